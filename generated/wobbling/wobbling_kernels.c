/* Compass walker with a horizontally wobbling mass: kernels of the solver
 * Printed by CasADi 3.8.2 from equations c6d2bd68570b75bd.
 * Do not edit: run `make derive`.
 * SPDX-License-Identifier: BSD-3-Clause
 */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) wobbling_kernels_ ## ID
#endif

#include <math.h>

#ifndef casadi_real
#define casadi_real double
#endif

#ifndef casadi_int
#define casadi_int long long int
#endif

/* Add prefix to internal symbols */
#define casadi_axpy CASADI_PREFIX(axpy)
#define casadi_c0 CASADI_PREFIX(c0)
#define casadi_c1 CASADI_PREFIX(c1)
#define casadi_clear CASADI_PREFIX(clear)
#define casadi_copy CASADI_PREFIX(copy)
#define casadi_dot CASADI_PREFIX(dot)
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_f1 CASADI_PREFIX(f1)
#define casadi_f10 CASADI_PREFIX(f10)
#define casadi_f100 CASADI_PREFIX(f100)
#define casadi_f101 CASADI_PREFIX(f101)
#define casadi_f102 CASADI_PREFIX(f102)
#define casadi_f11 CASADI_PREFIX(f11)
#define casadi_f12 CASADI_PREFIX(f12)
#define casadi_f13 CASADI_PREFIX(f13)
#define casadi_f14 CASADI_PREFIX(f14)
#define casadi_f15 CASADI_PREFIX(f15)
#define casadi_f16 CASADI_PREFIX(f16)
#define casadi_f17 CASADI_PREFIX(f17)
#define casadi_f18 CASADI_PREFIX(f18)
#define casadi_f19 CASADI_PREFIX(f19)
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f20 CASADI_PREFIX(f20)
#define casadi_f21 CASADI_PREFIX(f21)
#define casadi_f22 CASADI_PREFIX(f22)
#define casadi_f23 CASADI_PREFIX(f23)
#define casadi_f24 CASADI_PREFIX(f24)
#define casadi_f25 CASADI_PREFIX(f25)
#define casadi_f26 CASADI_PREFIX(f26)
#define casadi_f27 CASADI_PREFIX(f27)
#define casadi_f28 CASADI_PREFIX(f28)
#define casadi_f29 CASADI_PREFIX(f29)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f30 CASADI_PREFIX(f30)
#define casadi_f31 CASADI_PREFIX(f31)
#define casadi_f32 CASADI_PREFIX(f32)
#define casadi_f33 CASADI_PREFIX(f33)
#define casadi_f34 CASADI_PREFIX(f34)
#define casadi_f35 CASADI_PREFIX(f35)
#define casadi_f36 CASADI_PREFIX(f36)
#define casadi_f37 CASADI_PREFIX(f37)
#define casadi_f38 CASADI_PREFIX(f38)
#define casadi_f39 CASADI_PREFIX(f39)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_f40 CASADI_PREFIX(f40)
#define casadi_f41 CASADI_PREFIX(f41)
#define casadi_f42 CASADI_PREFIX(f42)
#define casadi_f43 CASADI_PREFIX(f43)
#define casadi_f44 CASADI_PREFIX(f44)
#define casadi_f45 CASADI_PREFIX(f45)
#define casadi_f46 CASADI_PREFIX(f46)
#define casadi_f47 CASADI_PREFIX(f47)
#define casadi_f48 CASADI_PREFIX(f48)
#define casadi_f49 CASADI_PREFIX(f49)
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f50 CASADI_PREFIX(f50)
#define casadi_f51 CASADI_PREFIX(f51)
#define casadi_f52 CASADI_PREFIX(f52)
#define casadi_f53 CASADI_PREFIX(f53)
#define casadi_f54 CASADI_PREFIX(f54)
#define casadi_f55 CASADI_PREFIX(f55)
#define casadi_f56 CASADI_PREFIX(f56)
#define casadi_f57 CASADI_PREFIX(f57)
#define casadi_f58 CASADI_PREFIX(f58)
#define casadi_f59 CASADI_PREFIX(f59)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f60 CASADI_PREFIX(f60)
#define casadi_f61 CASADI_PREFIX(f61)
#define casadi_f62 CASADI_PREFIX(f62)
#define casadi_f63 CASADI_PREFIX(f63)
#define casadi_f64 CASADI_PREFIX(f64)
#define casadi_f65 CASADI_PREFIX(f65)
#define casadi_f66 CASADI_PREFIX(f66)
#define casadi_f67 CASADI_PREFIX(f67)
#define casadi_f68 CASADI_PREFIX(f68)
#define casadi_f69 CASADI_PREFIX(f69)
#define casadi_f7 CASADI_PREFIX(f7)
#define casadi_f70 CASADI_PREFIX(f70)
#define casadi_f71 CASADI_PREFIX(f71)
#define casadi_f72 CASADI_PREFIX(f72)
#define casadi_f73 CASADI_PREFIX(f73)
#define casadi_f74 CASADI_PREFIX(f74)
#define casadi_f75 CASADI_PREFIX(f75)
#define casadi_f76 CASADI_PREFIX(f76)
#define casadi_f77 CASADI_PREFIX(f77)
#define casadi_f78 CASADI_PREFIX(f78)
#define casadi_f79 CASADI_PREFIX(f79)
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f80 CASADI_PREFIX(f80)
#define casadi_f81 CASADI_PREFIX(f81)
#define casadi_f82 CASADI_PREFIX(f82)
#define casadi_f83 CASADI_PREFIX(f83)
#define casadi_f84 CASADI_PREFIX(f84)
#define casadi_f85 CASADI_PREFIX(f85)
#define casadi_f86 CASADI_PREFIX(f86)
#define casadi_f87 CASADI_PREFIX(f87)
#define casadi_f88 CASADI_PREFIX(f88)
#define casadi_f89 CASADI_PREFIX(f89)
#define casadi_f9 CASADI_PREFIX(f9)
#define casadi_f90 CASADI_PREFIX(f90)
#define casadi_f91 CASADI_PREFIX(f91)
#define casadi_f92 CASADI_PREFIX(f92)
#define casadi_f93 CASADI_PREFIX(f93)
#define casadi_f94 CASADI_PREFIX(f94)
#define casadi_f95 CASADI_PREFIX(f95)
#define casadi_f96 CASADI_PREFIX(f96)
#define casadi_f97 CASADI_PREFIX(f97)
#define casadi_f98 CASADI_PREFIX(f98)
#define casadi_f99 CASADI_PREFIX(f99)
#define casadi_fabs CASADI_PREFIX(fabs)
#define casadi_fmax CASADI_PREFIX(fmax)
#define casadi_house CASADI_PREFIX(house)
#define casadi_if_else CASADI_PREFIX(if_else)
#define casadi_newton CASADI_PREFIX(newton)
#define casadi_newton_mem CASADI_PREFIX(newton_mem)
#define casadi_norm_inf CASADI_PREFIX(norm_inf)
#define casadi_qr CASADI_PREFIX(qr)
#define casadi_qr_colcomb CASADI_PREFIX(qr_colcomb)
#define casadi_qr_mv CASADI_PREFIX(qr_mv)
#define casadi_qr_singular CASADI_PREFIX(qr_singular)
#define casadi_qr_solve CASADI_PREFIX(qr_solve)
#define casadi_qr_trs CASADI_PREFIX(qr_trs)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s10 CASADI_PREFIX(s10)
#define casadi_s11 CASADI_PREFIX(s11)
#define casadi_s12 CASADI_PREFIX(s12)
#define casadi_s13 CASADI_PREFIX(s13)
#define casadi_s14 CASADI_PREFIX(s14)
#define casadi_s15 CASADI_PREFIX(s15)
#define casadi_s16 CASADI_PREFIX(s16)
#define casadi_s17 CASADI_PREFIX(s17)
#define casadi_s18 CASADI_PREFIX(s18)
#define casadi_s19 CASADI_PREFIX(s19)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s20 CASADI_PREFIX(s20)
#define casadi_s21 CASADI_PREFIX(s21)
#define casadi_s22 CASADI_PREFIX(s22)
#define casadi_s23 CASADI_PREFIX(s23)
#define casadi_s24 CASADI_PREFIX(s24)
#define casadi_s25 CASADI_PREFIX(s25)
#define casadi_s26 CASADI_PREFIX(s26)
#define casadi_s27 CASADI_PREFIX(s27)
#define casadi_s28 CASADI_PREFIX(s28)
#define casadi_s29 CASADI_PREFIX(s29)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_s5 CASADI_PREFIX(s5)
#define casadi_s6 CASADI_PREFIX(s6)
#define casadi_s7 CASADI_PREFIX(s7)
#define casadi_s8 CASADI_PREFIX(s8)
#define casadi_s9 CASADI_PREFIX(s9)
#define casadi_scal CASADI_PREFIX(scal)
#define casadi_sq CASADI_PREFIX(sq)
#define casadi_zeros CASADI_PREFIX(zeros)

/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
  #if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
    #if defined(STATIC_LINKED)
      #define CASADI_SYMBOL_EXPORT
    #else
      #define CASADI_SYMBOL_EXPORT __declspec(dllexport)
    #endif
  #elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
    #define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
  #else
    #define CASADI_SYMBOL_EXPORT
  #endif
#endif

casadi_real casadi_sq(casadi_real x) { return x*x;}

void casadi_copy(const casadi_real* x, casadi_int n, casadi_real* y) {
  casadi_int i;
  if (y) {
    if (x) {
      for (i=0; i<n; ++i) *y++ = *x++;
    } else {
      for (i=0; i<n; ++i) *y++ = 0.;
    }
  }
}

void casadi_axpy(casadi_int n, casadi_real alpha, const casadi_real* x, casadi_real* y) {
  casadi_int i;
  if (!x || !y) return;
  for (i=0; i<n; ++i) *y++ += alpha**x++;
}

casadi_real casadi_fmax(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x>y ? x : y;
#else
  return fmax(x, y);
#endif
}

casadi_real casadi_fabs(casadi_real x) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x>0 ? x : -x;
#else
  return fabs(x);
#endif
}

casadi_real casadi_norm_inf(casadi_int n, const casadi_real* x) {
  casadi_int i;
  casadi_real ret = 0;
  for (i=0; i<n; ++i) ret = casadi_fmax(ret, casadi_fabs(*x++));
  return ret;
}

casadi_real casadi_if_else(casadi_real c, casadi_real x, casadi_real y) { return c!=0 ? x : y;}

void casadi_scal(casadi_int n, casadi_real alpha, casadi_real* x) {
  casadi_int i;
  if (!x) return;
  for (i=0; i<n; ++i) *x++ *= alpha;
}

casadi_real casadi_dot(casadi_int n, const casadi_real* x, const casadi_real* y) {
  casadi_int i;
  casadi_real r = 0;
  for (i=0; i<n; ++i) r += *x++ * *y++;
  return r;
}

void casadi_clear(casadi_real* x, casadi_int n) {
  casadi_int i;
  if (x) {
    for (i=0; i<n; ++i) *x++ = 0;
  }
}

casadi_real casadi_house(casadi_real* v, casadi_real* beta, casadi_int nv) {
  casadi_int i;
  casadi_real v0, sigma, s, sigma_is_zero, v0_nonpos;
  v0 = v[0];
  sigma=0;
  for (i=1; i<nv; ++i) sigma += v[i]*v[i];
  s = sqrt(v0*v0 + sigma);
  sigma_is_zero = sigma==0;
  v0_nonpos = v0<=0;
  v[0] = casadi_if_else(sigma_is_zero, 1,
                 casadi_if_else(v0_nonpos, v0-s, -sigma/(v0+s)));
  *beta = casadi_if_else(sigma_is_zero, 2*v0_nonpos, -1/(s*v[0]));
  return s;
}
void casadi_qr(const casadi_int* sp_a, const casadi_real* nz_a, casadi_real* x,
               const casadi_int* sp_v, casadi_real* nz_v, const casadi_int* sp_r, casadi_real* nz_r, casadi_real* beta,
               const casadi_int* prinv, const casadi_int* pc) {
   casadi_int ncol, nrow, r, c, k, k1;
   casadi_real alpha;
   const casadi_int *a_colind, *a_row, *v_colind, *v_row, *r_colind, *r_row;
   ncol = sp_a[1];
   a_colind=sp_a+2; a_row=sp_a+2+ncol+1;
   nrow = sp_v[0];
   v_colind=sp_v+2; v_row=sp_v+2+ncol+1;
   r_colind=sp_r+2; r_row=sp_r+2+ncol+1;
   for (r=0; r<nrow; ++r) x[r] = 0;
   for (c=0; c<ncol; ++c) {
     for (k=a_colind[pc[c]]; k<a_colind[pc[c]+1]; ++k) x[prinv[a_row[k]]] = nz_a[k];
     for (k=r_colind[c]; k<r_colind[c+1] && (r=r_row[k])<c; ++k) {
       alpha = 0;
       for (k1=v_colind[r]; k1<v_colind[r+1]; ++k1) alpha += nz_v[k1]*x[v_row[k1]];
       alpha *= beta[r];
       for (k1=v_colind[r]; k1<v_colind[r+1]; ++k1) x[v_row[k1]] -= alpha*nz_v[k1];
       *nz_r++ = x[r];
       x[r] = 0;
     }
     for (k=v_colind[c]; k<v_colind[c+1]; ++k) {
       nz_v[k] = x[v_row[k]];
       x[v_row[k]] = 0;
     }
     *nz_r++ = casadi_house(nz_v + v_colind[c], beta + c, v_colind[c+1] - v_colind[c]);
   }
 }
void casadi_qr_mv(const casadi_int* sp_v, const casadi_real* v, const casadi_real* beta, casadi_real* x,
                  casadi_int tr) {
  casadi_int ncol, c, c1, k;
  casadi_real alpha;
  const casadi_int *colind, *row;
  ncol=sp_v[1];
  colind=sp_v+2; row=sp_v+2+ncol+1;
  for (c1=0; c1<ncol; ++c1) {
    c = tr ? c1 : ncol-1-c1;
    alpha=0;
    for (k=colind[c]; k<colind[c+1]; ++k) alpha += v[k]*x[row[k]];
    alpha *= beta[c];
    for (k=colind[c]; k<colind[c+1]; ++k) x[row[k]] -= alpha*v[k];
  }
}
void casadi_qr_trs(const casadi_int* sp_r, const casadi_real* nz_r, casadi_real* x, casadi_int tr) {
  casadi_int ncol, r, c, k;
  const casadi_int *colind, *row;
  ncol=sp_r[1];
  colind=sp_r+2; row=sp_r+2+ncol+1;
  if (tr) {
    for (c=0; c<ncol; ++c) {
      for (k=colind[c]; k<colind[c+1]; ++k) {
        r = row[k];
        if (r==c) {
          x[c] /= nz_r[k];
        } else {
          x[c] -= nz_r[k]*x[r];
        }
      }
    }
  } else {
    for (c=ncol-1; c>=0; --c) {
      for (k=colind[c+1]-1; k>=colind[c]; --k) {
        r=row[k];
        if (r==c) {
          x[r] /= nz_r[k];
        } else {
          x[r] -= nz_r[k]*x[c];
        }
      }
    }
  }
}
void casadi_qr_solve(casadi_real* x, casadi_int nrhs, casadi_int tr,
                     const casadi_int* sp_v, const casadi_real* v, const casadi_int* sp_r, const casadi_real* r,
                     const casadi_real* beta, const casadi_int* prinv, const casadi_int* pc, casadi_real* w) {
  casadi_int k, c, nrow_ext, ncol;
  nrow_ext = sp_v[0]; ncol = sp_v[1];
  for (k=0; k<nrhs; ++k) {
    if (tr) {
      for (c=0; c<ncol; ++c) w[c] = x[pc[c]];
      casadi_qr_trs(sp_r, r, w, 1);
      casadi_qr_mv(sp_v, v, beta, w, 0);
      for (c=0; c<ncol; ++c) x[c] = w[prinv[c]];
    } else {
      for (c=0; c<nrow_ext; ++c) w[c] = 0;
      for (c=0; c<ncol; ++c) w[prinv[c]] = x[c];
      casadi_qr_mv(sp_v, v, beta, w, 1);
      casadi_qr_trs(sp_r, r, w, 0);
      for (c=0; c<ncol; ++c) x[pc[c]] = w[c];
    }
    x += ncol;
  }
}
casadi_int casadi_qr_singular(casadi_real* rmin, casadi_int* irmin, const casadi_real* nz_r,
                             const casadi_int* sp_r, const casadi_int* pc, casadi_real eps) {
  casadi_real rd, rd_min;
  casadi_int ncol, c, nullity;
  const casadi_int* r_colind;
  nullity = 0;
  rd_min = 0;
  ncol = sp_r[1];
  r_colind = sp_r + 2;
  for (c=0; c<ncol; ++c) {
    rd = fabs(nz_r[r_colind[c+1]-1]);
    if (rd<eps) nullity++;
    if (c==0 || rd < rd_min) {
      rd_min = rd;
      if (rmin) *rmin = rd;
      if (irmin) *irmin = pc[c];
    }
  }
  return nullity;
}
void casadi_qr_colcomb(casadi_real* v, const casadi_real* nz_r, const casadi_int* sp_r,
                       const casadi_int* pc, casadi_real eps, casadi_int ind) {
  casadi_int ncol, r, c, k;
  const casadi_int *r_colind, *r_row;
  ncol = sp_r[1];
  r_colind = sp_r + 2;
  r_row = r_colind + ncol + 1;
  for (c=0; c<ncol; ++c) {
    if (fabs(nz_r[r_colind[c+1]-1])<eps && 0==ind--) {
      ind = c;
      break;
    }
  }
  casadi_clear(v, ncol);
  v[pc[ind]] = 1.;
  for (k=r_colind[ind]; k<r_colind[ind+1]-1; ++k) {
    v[pc[r_row[k]]] = -nz_r[k];
  }
  for (c=ind-1; c>=0; --c) {
    for (k=r_colind[c+1]-1; k>=r_colind[c]; --k) {
      r=r_row[k];
      if (r==c) {
        if (fabs(nz_r[k])<eps) {
          v[pc[r]] = 0;
        } else {
          v[pc[r]] /= nz_r[k];
        }
      } else {
        v[pc[r]] -= nz_r[k]*v[pc[c]];
      }
    }
  }
  casadi_scal(ncol, 1./sqrt(casadi_dot(ncol, v, v)), v);
}

struct casadi_newton_mem {
  casadi_int n;
  casadi_real abstol;
  casadi_real abstol_step;
  casadi_real* x;
  casadi_real* g;
  casadi_real* jac_g_x;
  const casadi_int* sp_a;
  const casadi_int* sp_v;
  const casadi_int* sp_r;
  const casadi_int* prinv;
  const casadi_int* pc;
  casadi_real* lin_w;
  casadi_real* lin_v;
  casadi_real* lin_r;
  casadi_real* lin_beta;
};
int casadi_newton(const struct casadi_newton_mem* m) {
    if (m->abstol>0 && casadi_norm_inf(m->n, m->g) <= m->abstol) return 1;
    casadi_qr(m->sp_a, m->jac_g_x, m->lin_w,
              m->sp_v,  m->lin_v, m->sp_r, m->lin_r, m->lin_beta,
              m->prinv, m->pc);
    casadi_qr_solve(m->g, 1, 0, m->sp_v, m->lin_v, m->sp_r, m->lin_r, m->lin_beta,
                    m->prinv, m->pc, m->lin_w);
    casadi_axpy(m->n, -1., m->g, m->x);
    if (m->abstol_step>0 && casadi_norm_inf(m->n, m->g) <= m->abstol_step) return 2;
    return 0;
}

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void wobbling_kernels_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int wobbling_kernels_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int wobbling_kernels_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[45] = 
  {6, 6, 0, 6, 12, 18, 24, 30,
  36, 0, 1, 2, 3, 4, 5, 0,
  1, 2, 3, 4, 5, 0, 1, 2,
  3, 4, 5, 0, 1, 2, 3, 4,
  5, 0, 1, 2, 3, 4, 5, 0,
  1, 2, 3, 4, 5};
static const casadi_int casadi_s1[30] = 
  {6, 6, 0, 6, 11, 15, 18, 20,
  21, 0, 1, 2, 3, 4, 5, 1,
  2, 3, 4, 5, 2, 3, 4, 5,
  3, 4, 5, 4, 5, 5};
static const casadi_int casadi_s2[30] = 
  {6, 6, 0, 1, 3, 6, 10, 15,
  21, 0, 0, 1, 0, 1, 2, 0,
  1, 2, 3, 0, 1, 2, 3, 4,
  0, 1, 2, 3, 4, 5};
static const casadi_int casadi_s3[6] = {0, 1, 2, 3, 4, 5};
static const casadi_int casadi_s4[3] = {6, 1, 1};
static const casadi_int casadi_s5[3] = {8, 1, 1};
static const casadi_int casadi_s6[3] = {6, 6, 1};
static const casadi_int casadi_s7[3] = {7, 49, 1};
static const casadi_int casadi_s8[3] = {10, 49, 1};
static const casadi_int casadi_s9[3] = {7, 73, 1};
static const casadi_int casadi_s10[3] = {10, 73, 1};
static const casadi_int casadi_s11[3] = {7, 97, 1};
static const casadi_int casadi_s12[3] = {10, 97, 1};
static const casadi_int casadi_s13[3] = {7, 145, 1};
static const casadi_int casadi_s14[3] = {10, 145, 1};
static const casadi_int casadi_s15[3] = {7, 193, 1};
static const casadi_int casadi_s16[3] = {10, 193, 1};
static const casadi_int casadi_s17[3] = {7, 289, 1};
static const casadi_int casadi_s18[3] = {10, 289, 1};
static const casadi_int casadi_s19[3] = {7, 385, 1};
static const casadi_int casadi_s20[3] = {10, 385, 1};
static const casadi_int casadi_s21[3] = {7, 577, 1};
static const casadi_int casadi_s22[3] = {10, 577, 1};
static const casadi_int casadi_s23[3] = {7, 769, 1};
static const casadi_int casadi_s24[3] = {10, 769, 1};
static const casadi_int casadi_s25[3] = {1, 1, 1};
static const casadi_int casadi_s26[3] = {7, 1, 1};
static const casadi_int casadi_s27[3] = {10, 1, 1};
static const casadi_int casadi_s28[3] = {7, 12, 1};
static const casadi_int casadi_s29[3] = {10, 12, 1};

static const casadi_real casadi_c0[36] = 
  {1., 1., 1., 1., 1., 5.0000000000000000e-01, 1., 1.,
  1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 1.,
  1., 5.0000000000000000e-01, 1., 1., 1., 1., 1., 5.0000000000000000e-01,
  1., 1., 1., 1., 1., 5.0000000000000000e-01, 1., 1.,
  1., 1., 1., 5.0000000000000000e-01};
static const casadi_real casadi_c1[6] = {1., 1., 1., 1., 1., 2.};

static const casadi_real casadi_zeros[36] = 
  {0.};

/* start:(z[5],p[8])->(y[6],dy_dz[6x5]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a0=(2.*a0);
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[0]? arg[0][3] : 0;
  if (res[0]!=0) res[0][2]=a0;
  a0=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][3]=a0;
  a0=arg[0]? arg[0][2] : 0;
  if (res[0]!=0) res[0][4]=a0;
  a0=arg[0]? arg[0][4] : 0;
  if (res[0]!=0) res[0][5]=a0;
  a0=1.;
  if (res[1]!=0) res[1][0]=a0;
  a1=2.;
  if (res[1]!=0) res[1][1]=a1;
  a1=0.;
  if (res[1]!=0) res[1][2]=a1;
  if (res[1]!=0) res[1][3]=a1;
  if (res[1]!=0) res[1][4]=a1;
  if (res[1]!=0) res[1][5]=a1;
  if (res[1]!=0) res[1][6]=a1;
  if (res[1]!=0) res[1][7]=a1;
  if (res[1]!=0) res[1][8]=a1;
  if (res[1]!=0) res[1][9]=a0;
  if (res[1]!=0) res[1][10]=a1;
  if (res[1]!=0) res[1][11]=a1;
  if (res[1]!=0) res[1][12]=a1;
  if (res[1]!=0) res[1][13]=a1;
  if (res[1]!=0) res[1][14]=a1;
  if (res[1]!=0) res[1][15]=a1;
  if (res[1]!=0) res[1][16]=a0;
  if (res[1]!=0) res[1][17]=a1;
  if (res[1]!=0) res[1][18]=a1;
  if (res[1]!=0) res[1][19]=a1;
  if (res[1]!=0) res[1][20]=a0;
  if (res[1]!=0) res[1][21]=a1;
  if (res[1]!=0) res[1][22]=a1;
  if (res[1]!=0) res[1][23]=a1;
  if (res[1]!=0) res[1][24]=a1;
  if (res[1]!=0) res[1][25]=a1;
  if (res[1]!=0) res[1][26]=a1;
  if (res[1]!=0) res[1][27]=a1;
  if (res[1]!=0) res[1][28]=a1;
  if (res[1]!=0) res[1][29]=a0;
  return 0;
}

/* turns:(h,p[8])->(turns[2x12]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[1]? arg[1][2] : 0;
  a1=5.2600151958767730e-02;
  a2=arg[0]? arg[0][0] : 0;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][2]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][3]=a1;
  a1=7.8900227938151601e-02;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][4]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][5]=a1;
  a1=1.1835034190722740e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][6]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][7]=a1;
  a1=2.8164965809277259e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][8]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][9]=a1;
  a1=3.3333333333333331e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][10]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][11]=a1;
  a1=2.5000000000000000e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][12]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][13]=a1;
  a1=3.0769230769230771e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][14]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][15]=a1;
  a1=6.5128205128205130e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][16]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][17]=a1;
  a1=5.9999999999999998e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][18]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][19]=a1;
  a1=8.5714285714285710e-01;
  a1=(a1*a2);
  a1=(a0*a1);
  a3=cos(a1);
  if (res[0]!=0) res[0][20]=a3;
  a1=sin(a1);
  if (res[0]!=0) res[0][21]=a1;
  a0=(a0*a2);
  a2=cos(a0);
  if (res[0]!=0) res[0][22]=a2;
  a0=sin(a0);
  if (res[0]!=0) res[0][23]=a0;
  return 0;
}

/* phase:(t,p[8])->(phase[2]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[1]? arg[1][2] : 0;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  a1=cos(a0);
  if (res[0]!=0) res[0][0]=a1;
  a0=sin(a0);
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[6x6],phase[2],turns[2x12],h,p[8])->(y_end[6x6]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
  casadi_real a120, a121, a122, a123, a124, a125, a126, a127, a128, a129, a130, a131;
  casadi_real a132, a133, a134, a135, a136, a137, a138, a139, a140, a141, a142, a143;
  casadi_real a144, a145, a146, a147, a148, a149, a150, a151, a152, a153, a154, a155;
  casadi_real a156, a157, a158, a159, a160, a161, a162, a163, a164, a165, a166, a167;
  casadi_real a168, a169, a170, a171, a172, a173, a174, a175, a176, a177, a178, a179;
  casadi_real a180, a181, a182, a183, a184, a185, a186, a187, a188, a189, a190, a191;
  casadi_real a192, a193, a194, a195, a196, a197, a198, a199, a200, a201, a202, a203;
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211, a212, a213, a214, a215;
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238, a239;
  casadi_real a240, a241, a242, a243, a244, a245, a246, a247, a248, a249, a250, a251;
  casadi_real a252, a253, a254, a255, a256, a257, a258, a259, a260, a261, a262, a263;
  casadi_real a264, a265, a266, a267, a268, a269, a270, a271, a272, a273, a274, a275;
  casadi_real a276, a277, a278, a279, a280, a281, a282, a283, a284, a285, a286, a287;
  casadi_real a288, a289, a290, a291, a292, a293, a294, a295, a296, a297, a298, a299;
  casadi_real a300, a301, a302, a303, a304, a305, a306, a307, a308, a309, a310, a311;
  casadi_real a312, a313;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[3]? arg[3][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][3] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[4]? arg[4][3] : 0;
  a008=arg[0]? arg[0][4] : 0;
  a009=(a007*a008);
  a010=arg[0]? arg[0][1] : 0;
  a011=sin(a010);
  a009=(a009*a011);
  a012=(2.*a003);
  a012=(a008-a012);
  a009=(a009*a012);
  a013=sin(a000);
  a014=cos(a010);
  a015=(a013*a014);
  a016=cos(a000);
  a017=(a016*a011);
  a015=(a015-a017);
  a017=(a007*a015);
  a009=(a009-a017);
  a018=1.;
  a019=(a007+a018);
  a020=(a013*a019);
  a009=(a009+a020);
  a021=(2.*a007);
  a022=(a018-a014);
  a022=(a021*a022);
  a022=(a022+a018);
  a023=(a009/a022);
  a024=(a014-a018);
  a024=(a007*a024);
  a025=(a024/a022);
  a026=casadi_sq(a003);
  a026=(a026*a011);
  a026=(a026+a015);
  a026=(a007*a026);
  a015=arg[4]? arg[4][5] : 0;
  a027=arg[4]? arg[4][7] : 0;
  a028=arg[4]? arg[4][2] : 0;
  a028=(a027*a028);
  a029=arg[1]? arg[1][1] : 0;
  a030=(a028*a029);
  a030=(a008+a030);
  a030=(a015*a030);
  a031=arg[4]? arg[4][4] : 0;
  a032=arg[4]? arg[4][6] : 0;
  a033=arg[1]? arg[1][0] : 0;
  a034=(a033+a018);
  a034=(a027*a034);
  a034=(a032-a034);
  a034=(a034+a010);
  a034=(a031*a034);
  a030=(a030+a034);
  a026=(a026-a030);
  a030=(a025*a009);
  a030=(a026-a030);
  a034=(a024*a025);
  a034=(a007-a034);
  a035=(a030/a034);
  a036=arg[4]? arg[4][1] : 0;
  a037=(a036*a016);
  a038=(a037/a022);
  a024=(a024*a038);
  a039=(a024/a034);
  a009=(a038*a009);
  a040=(a036*a003);
  a040=(a040*a003);
  a040=(a040*a013);
  a041=arg[4]? arg[4][0] : 0;
  a042=arg[0]? arg[0][2] : 0;
  a043=(a041*a042);
  a040=(a040+a043);
  a009=(a009-a040);
  a030=(a039*a030);
  a009=(a009-a030);
  a037=(a037*a038);
  a037=(a036-a037);
  a024=(a024*a039);
  a037=(a037-a024);
  a009=(a009/a037);
  a024=(a039*a009);
  a035=(a035-a024);
  a024=(a025*a035);
  a023=(a023-a024);
  a024=(a038*a009);
  a023=(a023+a024);
  a024=(a006*a023);
  a030=1.7082860872947386e-01;
  a030=(a030*a002);
  a043=2.9587585476806851e-02;
  a043=(a043*a002);
  a044=(a043*a035);
  a045=8.8762756430420545e-02;
  a045=(a045*a002);
  a046=1.9725056984537900e-02;
  a046=(a046*a002);
  a047=(a046*a023);
  a048=5.9175170953613701e-02;
  a048=(a048*a002);
  a049=5.2600151958767730e-02;
  a049=(a049*a002);
  a050=(a049*a035);
  a050=(a008+a050);
  a051=(a007*a050);
  a052=(a049*a008);
  a052=(a010+a052);
  a053=sin(a052);
  a051=(a051*a053);
  a054=(a049*a023);
  a054=(a003+a054);
  a055=(2.*a054);
  a055=(a050-a055);
  a051=(a051*a055);
  a056=(a049*a003);
  a056=(a000+a056);
  a057=sin(a056);
  a058=cos(a052);
  a059=(a057*a058);
  a056=cos(a056);
  a060=(a056*a053);
  a059=(a059-a060);
  a060=(a007*a059);
  a051=(a051-a060);
  a061=(a057*a019);
  a051=(a051+a061);
  a062=(a018-a058);
  a062=(a021*a062);
  a062=(a062+a018);
  a063=(a051/a062);
  a064=(a058-a018);
  a064=(a007*a064);
  a065=(a064/a062);
  a066=casadi_sq(a054);
  a066=(a066*a053);
  a066=(a066+a059);
  a066=(a007*a066);
  a059=arg[2]? arg[2][2] : 0;
  a067=(a029*a059);
  a068=arg[2]? arg[2][3] : 0;
  a069=(a033*a068);
  a067=(a067+a069);
  a067=(a028*a067);
  a067=(a050+a067);
  a067=(a015*a067);
  a059=(a033*a059);
  a068=(a029*a068);
  a059=(a059-a068);
  a059=(a059+a018);
  a059=(a027*a059);
  a059=(a032-a059);
  a059=(a059+a052);
  a059=(a031*a059);
  a067=(a067+a059);
  a066=(a066-a067);
  a067=(a065*a051);
  a067=(a066-a067);
  a059=(a064*a065);
  a059=(a007-a059);
  a052=(a067/a059);
  a068=(a036*a056);
  a069=(a068/a062);
  a064=(a064*a069);
  a070=(a064/a059);
  a051=(a069*a051);
  a071=(a036*a054);
  a071=(a071*a054);
  a071=(a071*a057);
  a072=arg[0]? arg[0][5] : 0;
  a073=(a049*a072);
  a073=(a042+a073);
  a073=(a041*a073);
  a071=(a071+a073);
  a051=(a051-a071);
  a067=(a070*a067);
  a051=(a051-a067);
  a068=(a068*a069);
  a068=(a036-a068);
  a064=(a064*a070);
  a068=(a068-a064);
  a051=(a051/a068);
  a064=(a070*a051);
  a052=(a052-a064);
  a064=(a065*a052);
  a063=(a063-a064);
  a064=(a069*a051);
  a063=(a063+a064);
  a063=(a048*a063);
  a047=(a047+a063);
  a047=(a003+a047);
  a063=casadi_sq(a047);
  a064=(a046*a008);
  a067=(a048*a050);
  a064=(a064+a067);
  a064=(a010+a064);
  a067=sin(a064);
  a063=(a063*a067);
  a073=(a046*a003);
  a074=(a048*a054);
  a073=(a073+a074);
  a073=(a000+a073);
  a074=sin(a073);
  a075=cos(a064);
  a076=(a074*a075);
  a073=cos(a073);
  a077=(a073*a067);
  a076=(a076-a077);
  a063=(a063+a076);
  a063=(a007*a063);
  a077=(a046*a035);
  a052=(a048*a052);
  a077=(a077+a052);
  a077=(a008+a077);
  a052=arg[2]? arg[2][4] : 0;
  a078=(a029*a052);
  a079=arg[2]? arg[2][5] : 0;
  a080=(a033*a079);
  a078=(a078+a080);
  a078=(a028*a078);
  a078=(a077+a078);
  a078=(a015*a078);
  a052=(a033*a052);
  a079=(a029*a079);
  a052=(a052-a079);
  a052=(a052+a018);
  a052=(a027*a052);
  a052=(a032-a052);
  a052=(a052+a064);
  a052=(a031*a052);
  a078=(a078+a052);
  a063=(a063-a078);
  a078=(a075-a018);
  a078=(a007*a078);
  a052=(a018-a075);
  a052=(a021*a052);
  a052=(a052+a018);
  a064=(a078/a052);
  a079=(a007*a077);
  a079=(a079*a067);
  a080=(2.*a047);
  a080=(a077-a080);
  a079=(a079*a080);
  a076=(a007*a076);
  a079=(a079-a076);
  a081=(a074*a019);
  a079=(a079+a081);
  a082=(a064*a079);
  a082=(a063-a082);
  a083=(a078*a064);
  a083=(a007-a083);
  a084=(a082/a083);
  a085=(a036*a073);
  a086=(a085/a052);
  a078=(a078*a086);
  a087=(a078/a083);
  a088=(a086*a079);
  a089=(a036*a047);
  a089=(a089*a047);
  a089=(a089*a074);
  a090=(a046*a072);
  a091=(a049*a009);
  a091=(a072+a091);
  a091=(a048*a091);
  a090=(a090+a091);
  a090=(a042+a090);
  a090=(a041*a090);
  a089=(a089+a090);
  a088=(a088-a089);
  a082=(a087*a082);
  a088=(a088-a082);
  a085=(a085*a086);
  a085=(a036-a085);
  a078=(a078*a087);
  a085=(a085-a078);
  a088=(a088/a085);
  a078=(a087*a088);
  a084=(a084-a078);
  a078=(a045*a084);
  a044=(a044+a078);
  a044=(a008+a044);
  a078=(a007*a044);
  a082=(a043*a008);
  a090=(a045*a077);
  a082=(a082+a090);
  a082=(a010+a082);
  a090=sin(a082);
  a078=(a078*a090);
  a091=(a043*a023);
  a079=(a079/a052);
  a092=(a064*a084);
  a079=(a079-a092);
  a092=(a086*a088);
  a079=(a079+a092);
  a092=(a045*a079);
  a091=(a091+a092);
  a091=(a003+a091);
  a092=(2.*a091);
  a092=(a044-a092);
  a078=(a078*a092);
  a093=(a043*a003);
  a094=(a045*a047);
  a093=(a093+a094);
  a093=(a000+a093);
  a094=sin(a093);
  a095=cos(a082);
  a096=(a094*a095);
  a093=cos(a093);
  a097=(a093*a090);
  a096=(a096-a097);
  a097=(a007*a096);
  a078=(a078-a097);
  a098=(a094*a019);
  a078=(a078+a098);
  a099=(a018-a095);
  a099=(a021*a099);
  a099=(a099+a018);
  a100=(a078/a099);
  a101=(a095-a018);
  a101=(a007*a101);
  a102=(a101/a099);
  a103=casadi_sq(a091);
  a103=(a103*a090);
  a103=(a103+a096);
  a103=(a007*a103);
  a096=arg[2]? arg[2][6] : 0;
  a104=(a029*a096);
  a105=arg[2]? arg[2][7] : 0;
  a106=(a033*a105);
  a104=(a104+a106);
  a104=(a028*a104);
  a104=(a044+a104);
  a104=(a015*a104);
  a096=(a033*a096);
  a105=(a029*a105);
  a096=(a096-a105);
  a096=(a096+a018);
  a096=(a027*a096);
  a096=(a032-a096);
  a096=(a096+a082);
  a096=(a031*a096);
  a104=(a104+a096);
  a103=(a103-a104);
  a104=(a102*a078);
  a104=(a103-a104);
  a096=(a101*a102);
  a096=(a007-a096);
  a082=(a104/a096);
  a105=(a036*a093);
  a106=(a105/a099);
  a101=(a101*a106);
  a107=(a101/a096);
  a078=(a106*a078);
  a108=(a036*a091);
  a108=(a108*a091);
  a108=(a108*a094);
  a109=(a043*a072);
  a110=(a046*a009);
  a051=(a048*a051);
  a110=(a110+a051);
  a110=(a072+a110);
  a051=(a045*a110);
  a109=(a109+a051);
  a109=(a042+a109);
  a109=(a041*a109);
  a108=(a108+a109);
  a078=(a078-a108);
  a104=(a107*a104);
  a078=(a078-a104);
  a105=(a105*a106);
  a105=(a036-a105);
  a101=(a101*a107);
  a105=(a105-a101);
  a078=(a078/a105);
  a101=(a107*a078);
  a082=(a082-a101);
  a101=(a102*a082);
  a100=(a100-a101);
  a101=(a106*a078);
  a100=(a100+a101);
  a101=(a030*a100);
  a024=(a024+a101);
  a101=1.2546768756682242e-01;
  a101=(a101*a002);
  a104=2.4136513415926669e-01;
  a104=(a104*a002);
  a109=(a104*a035);
  a051=-8.8454947932828609e-01;
  a051=(a051*a002);
  a084=(a051*a084);
  a109=(a109+a084);
  a084=9.2483400326179199e-01;
  a084=(a084*a002);
  a111=(a084*a082);
  a109=(a109+a111);
  a109=(a008+a109);
  a111=(a007*a109);
  a112=(a104*a008);
  a113=(a051*a077);
  a112=(a112+a113);
  a113=(a084*a044);
  a112=(a112+a113);
  a112=(a010+a112);
  a113=sin(a112);
  a111=(a111*a113);
  a114=(a104*a023);
  a079=(a051*a079);
  a114=(a114+a079);
  a079=(a084*a100);
  a114=(a114+a079);
  a114=(a003+a114);
  a079=(2.*a114);
  a079=(a109-a079);
  a111=(a111*a079);
  a115=(a104*a003);
  a116=(a051*a047);
  a115=(a115+a116);
  a116=(a084*a091);
  a115=(a115+a116);
  a115=(a000+a115);
  a116=sin(a115);
  a117=cos(a112);
  a118=(a116*a117);
  a115=cos(a115);
  a119=(a115*a113);
  a118=(a118-a119);
  a119=(a007*a118);
  a111=(a111-a119);
  a120=(a116*a019);
  a111=(a111+a120);
  a121=(a018-a117);
  a121=(a021*a121);
  a121=(a121+a018);
  a122=(a111/a121);
  a123=(a117-a018);
  a123=(a007*a123);
  a124=(a123/a121);
  a125=casadi_sq(a114);
  a125=(a125*a113);
  a125=(a125+a118);
  a125=(a007*a125);
  a118=arg[2]? arg[2][8] : 0;
  a126=(a029*a118);
  a127=arg[2]? arg[2][9] : 0;
  a128=(a033*a127);
  a126=(a126+a128);
  a126=(a028*a126);
  a126=(a109+a126);
  a126=(a015*a126);
  a118=(a033*a118);
  a127=(a029*a127);
  a118=(a118-a127);
  a118=(a118+a018);
  a118=(a027*a118);
  a118=(a032-a118);
  a118=(a118+a112);
  a118=(a031*a118);
  a126=(a126+a118);
  a125=(a125-a126);
  a126=(a124*a111);
  a126=(a125-a126);
  a118=(a123*a124);
  a118=(a007-a118);
  a112=(a126/a118);
  a127=(a036*a115);
  a128=(a127/a121);
  a123=(a123*a128);
  a129=(a123/a118);
  a111=(a128*a111);
  a130=(a036*a114);
  a130=(a130*a114);
  a130=(a130*a116);
  a131=(a104*a072);
  a110=(a051*a110);
  a131=(a131+a110);
  a110=(a043*a009);
  a132=(a045*a088);
  a110=(a110+a132);
  a110=(a072+a110);
  a132=(a084*a110);
  a131=(a131+a132);
  a131=(a042+a131);
  a131=(a041*a131);
  a130=(a130+a131);
  a111=(a111-a130);
  a126=(a129*a126);
  a111=(a111-a126);
  a127=(a127*a128);
  a127=(a036-a127);
  a123=(a123*a129);
  a127=(a127-a123);
  a111=(a111/a127);
  a123=(a129*a111);
  a112=(a112-a123);
  a123=(a124*a112);
  a122=(a122-a123);
  a123=(a128*a111);
  a122=(a122+a123);
  a123=(a101*a122);
  a024=(a024+a123);
  a024=(a003+a024);
  a123=(a005*a024);
  a004=(a004+a123);
  a123=1.8915178993145003e+00;
  a123=(a123*a002);
  a126=3.7109375000000000e-02;
  a126=(a126*a002);
  a131=(a126*a023);
  a132=1.7025221101954405e-01;
  a132=(a132*a002);
  a133=(a132*a100);
  a131=(a131+a133);
  a133=6.0216538980455959e-02;
  a133=(a133*a002);
  a134=(a133*a122);
  a131=(a131+a134);
  a134=-1.7578125000000000e-02;
  a134=(a134*a002);
  a135=(a006*a035);
  a136=(a030*a082);
  a135=(a135+a136);
  a136=(a101*a112);
  a135=(a135+a136);
  a135=(a008+a135);
  a136=(a007*a135);
  a137=(a006*a008);
  a138=(a030*a044);
  a137=(a137+a138);
  a138=(a101*a109);
  a137=(a137+a138);
  a137=(a010+a137);
  a138=sin(a137);
  a136=(a136*a138);
  a139=(2.*a024);
  a139=(a135-a139);
  a136=(a136*a139);
  a140=(a006*a003);
  a141=(a030*a091);
  a140=(a140+a141);
  a141=(a101*a114);
  a140=(a140+a141);
  a140=(a000+a140);
  a141=sin(a140);
  a142=cos(a137);
  a143=(a141*a142);
  a140=cos(a140);
  a144=(a140*a138);
  a143=(a143-a144);
  a144=(a007*a143);
  a136=(a136-a144);
  a145=(a141*a019);
  a136=(a136+a145);
  a146=(a018-a142);
  a146=(a021*a146);
  a146=(a146+a018);
  a147=(a136/a146);
  a148=(a142-a018);
  a148=(a007*a148);
  a149=(a148/a146);
  a150=casadi_sq(a024);
  a150=(a150*a138);
  a150=(a150+a143);
  a150=(a007*a150);
  a143=arg[2]? arg[2][10] : 0;
  a151=(a029*a143);
  a152=arg[2]? arg[2][11] : 0;
  a153=(a033*a152);
  a151=(a151+a153);
  a151=(a028*a151);
  a151=(a135+a151);
  a151=(a015*a151);
  a143=(a033*a143);
  a152=(a029*a152);
  a143=(a143-a152);
  a143=(a143+a018);
  a143=(a027*a143);
  a143=(a032-a143);
  a143=(a143+a137);
  a143=(a031*a143);
  a151=(a151+a143);
  a150=(a150-a151);
  a151=(a149*a136);
  a151=(a150-a151);
  a143=(a148*a149);
  a143=(a007-a143);
  a137=(a151/a143);
  a152=(a036*a140);
  a153=(a152/a146);
  a148=(a148*a153);
  a154=(a148/a143);
  a136=(a153*a136);
  a155=(a036*a024);
  a155=(a155*a024);
  a155=(a155*a141);
  a156=(a006*a072);
  a157=(a030*a110);
  a156=(a156+a157);
  a157=(a104*a009);
  a088=(a051*a088);
  a157=(a157+a088);
  a088=(a084*a078);
  a157=(a157+a088);
  a157=(a072+a157);
  a088=(a101*a157);
  a156=(a156+a088);
  a156=(a042+a156);
  a156=(a041*a156);
  a155=(a155+a156);
  a136=(a136-a155);
  a151=(a154*a151);
  a136=(a136-a151);
  a152=(a152*a153);
  a152=(a036-a152);
  a148=(a148*a154);
  a152=(a152-a148);
  a136=(a136/a152);
  a148=(a154*a136);
  a137=(a137-a148);
  a148=(a149*a137);
  a147=(a147-a148);
  a148=(a153*a136);
  a147=(a147+a148);
  a148=(a134*a147);
  a131=(a131+a148);
  a131=(a003+a131);
  a148=(a123*a131);
  a004=(a004+a148);
  a148=-5.8012039600105849e+00;
  a148=(a148*a002);
  a151=3.7092000118504789e-02;
  a151=(a151*a002);
  a156=(a151*a023);
  a088=1.7038392571223998e-01;
  a088=(a088*a002);
  a158=(a088*a100);
  a156=(a156+a158);
  a158=1.0726203044637328e-01;
  a158=(a158*a002);
  a159=(a158*a122);
  a156=(a156+a159);
  a159=-1.5319437748624402e-02;
  a159=(a159*a002);
  a160=(a159*a147);
  a156=(a156+a160);
  a160=8.2737891638140233e-03;
  a160=(a160*a002);
  a161=(a126*a035);
  a162=(a132*a082);
  a161=(a161+a162);
  a162=(a133*a112);
  a161=(a161+a162);
  a162=(a134*a137);
  a161=(a161+a162);
  a161=(a008+a161);
  a162=(a007*a161);
  a163=(a126*a008);
  a164=(a132*a044);
  a163=(a163+a164);
  a164=(a133*a109);
  a163=(a163+a164);
  a164=(a134*a135);
  a163=(a163+a164);
  a163=(a010+a163);
  a164=sin(a163);
  a162=(a162*a164);
  a165=(2.*a131);
  a165=(a161-a165);
  a162=(a162*a165);
  a166=(a126*a003);
  a167=(a132*a091);
  a166=(a166+a167);
  a167=(a133*a114);
  a166=(a166+a167);
  a167=(a134*a024);
  a166=(a166+a167);
  a166=(a000+a166);
  a167=sin(a166);
  a168=cos(a163);
  a169=(a167*a168);
  a166=cos(a166);
  a170=(a166*a164);
  a169=(a169-a170);
  a170=(a007*a169);
  a162=(a162-a170);
  a171=(a167*a019);
  a162=(a162+a171);
  a172=(a018-a168);
  a172=(a021*a172);
  a172=(a172+a018);
  a173=(a162/a172);
  a174=(a168-a018);
  a174=(a007*a174);
  a175=(a174/a172);
  a176=casadi_sq(a131);
  a176=(a176*a164);
  a176=(a176+a169);
  a176=(a007*a176);
  a169=arg[2]? arg[2][12] : 0;
  a177=(a029*a169);
  a178=arg[2]? arg[2][13] : 0;
  a179=(a033*a178);
  a177=(a177+a179);
  a177=(a028*a177);
  a177=(a161+a177);
  a177=(a015*a177);
  a169=(a033*a169);
  a178=(a029*a178);
  a169=(a169-a178);
  a169=(a169+a018);
  a169=(a027*a169);
  a169=(a032-a169);
  a169=(a169+a163);
  a169=(a031*a169);
  a177=(a177+a169);
  a176=(a176-a177);
  a177=(a175*a162);
  a177=(a176-a177);
  a169=(a174*a175);
  a169=(a007-a169);
  a163=(a177/a169);
  a178=(a036*a166);
  a179=(a178/a172);
  a174=(a174*a179);
  a180=(a174/a169);
  a162=(a179*a162);
  a181=(a036*a131);
  a181=(a181*a131);
  a181=(a181*a167);
  a182=(a126*a072);
  a183=(a132*a110);
  a182=(a182+a183);
  a183=(a133*a157);
  a182=(a182+a183);
  a183=(a006*a009);
  a184=(a030*a078);
  a183=(a183+a184);
  a184=(a101*a111);
  a183=(a183+a184);
  a183=(a072+a183);
  a184=(a134*a183);
  a182=(a182+a184);
  a182=(a042+a182);
  a182=(a041*a182);
  a181=(a181+a182);
  a162=(a162-a181);
  a177=(a180*a177);
  a162=(a162-a177);
  a178=(a178*a179);
  a178=(a036-a178);
  a174=(a174*a180);
  a178=(a178-a174);
  a162=(a162/a178);
  a174=(a180*a162);
  a163=(a163-a174);
  a174=(a175*a163);
  a173=(a173-a174);
  a174=(a179*a162);
  a173=(a173+a174);
  a174=(a160*a173);
  a156=(a156+a174);
  a156=(a003+a156);
  a174=(a148*a156);
  a004=(a004+a174);
  a174=3.1116436695781990e-01;
  a174=(a174*a002);
  a177=6.2411095871607569e-01;
  a177=(a177*a002);
  a182=(a177*a023);
  a184=-3.3608926294469414e+00;
  a184=(a184*a002);
  a185=(a184*a100);
  a182=(a182+a185);
  a185=-8.6821934684172597e-01;
  a185=(a185*a002);
  a186=(a185*a122);
  a182=(a182+a186);
  a186=2.7592099699446710e+01;
  a186=(a186*a002);
  a187=(a186*a147);
  a182=(a182+a187);
  a187=2.0154067550477894e+01;
  a187=(a187*a002);
  a188=(a187*a173);
  a182=(a182+a188);
  a188=-4.3489884181069961e+01;
  a188=(a188*a002);
  a189=(a151*a035);
  a190=(a088*a082);
  a189=(a189+a190);
  a190=(a158*a112);
  a189=(a189+a190);
  a190=(a159*a137);
  a189=(a189+a190);
  a190=(a160*a163);
  a189=(a189+a190);
  a189=(a008+a189);
  a190=(a007*a189);
  a191=(a151*a008);
  a192=(a088*a044);
  a191=(a191+a192);
  a192=(a158*a109);
  a191=(a191+a192);
  a192=(a159*a135);
  a191=(a191+a192);
  a192=(a160*a161);
  a191=(a191+a192);
  a191=(a010+a191);
  a192=sin(a191);
  a190=(a190*a192);
  a193=(2.*a156);
  a193=(a189-a193);
  a190=(a190*a193);
  a194=(a151*a003);
  a195=(a088*a091);
  a194=(a194+a195);
  a195=(a158*a114);
  a194=(a194+a195);
  a195=(a159*a024);
  a194=(a194+a195);
  a195=(a160*a131);
  a194=(a194+a195);
  a194=(a000+a194);
  a195=sin(a194);
  a196=cos(a191);
  a197=(a195*a196);
  a194=cos(a194);
  a198=(a194*a192);
  a197=(a197-a198);
  a198=(a007*a197);
  a190=(a190-a198);
  a199=(a195*a019);
  a190=(a190+a199);
  a200=(a018-a196);
  a200=(a021*a200);
  a200=(a200+a018);
  a201=(a190/a200);
  a202=(a196-a018);
  a202=(a007*a202);
  a203=(a202/a200);
  a204=casadi_sq(a156);
  a204=(a204*a192);
  a204=(a204+a197);
  a204=(a007*a204);
  a197=arg[2]? arg[2][14] : 0;
  a205=(a029*a197);
  a206=arg[2]? arg[2][15] : 0;
  a207=(a033*a206);
  a205=(a205+a207);
  a205=(a028*a205);
  a205=(a189+a205);
  a205=(a015*a205);
  a197=(a033*a197);
  a206=(a029*a206);
  a197=(a197-a206);
  a197=(a197+a018);
  a197=(a027*a197);
  a197=(a032-a197);
  a197=(a197+a191);
  a197=(a031*a197);
  a205=(a205+a197);
  a204=(a204-a205);
  a205=(a203*a190);
  a205=(a204-a205);
  a197=(a202*a203);
  a197=(a007-a197);
  a191=(a205/a197);
  a206=(a036*a194);
  a207=(a206/a200);
  a202=(a202*a207);
  a208=(a202/a197);
  a190=(a207*a190);
  a209=(a036*a156);
  a209=(a209*a156);
  a209=(a209*a195);
  a210=(a151*a072);
  a211=(a088*a110);
  a210=(a210+a211);
  a211=(a158*a157);
  a210=(a210+a211);
  a211=(a159*a183);
  a210=(a210+a211);
  a211=(a126*a009);
  a212=(a132*a078);
  a211=(a211+a212);
  a212=(a133*a111);
  a211=(a211+a212);
  a212=(a134*a136);
  a211=(a211+a212);
  a211=(a072+a211);
  a212=(a160*a211);
  a210=(a210+a212);
  a210=(a042+a210);
  a210=(a041*a210);
  a209=(a209+a210);
  a190=(a190-a209);
  a205=(a208*a205);
  a190=(a190-a205);
  a206=(a206*a207);
  a206=(a036-a206);
  a202=(a202*a208);
  a206=(a206-a202);
  a190=(a190/a206);
  a202=(a208*a190);
  a191=(a191-a202);
  a202=(a203*a191);
  a201=(a201-a202);
  a202=(a207*a190);
  a201=(a201+a202);
  a202=(a188*a201);
  a182=(a182+a202);
  a182=(a003+a182);
  a202=(a174*a182);
  a004=(a004+a202);
  a202=-1.5216094966251609e-01;
  a202=(a202*a002);
  a205=4.7766253643826434e-01;
  a205=(a205*a002);
  a210=(a205*a023);
  a212=-2.4881146199716677e+00;
  a212=(a212*a002);
  a213=(a212*a100);
  a210=(a210+a213);
  a213=-5.9029082683684297e-01;
  a213=(a213*a002);
  a214=(a213*a122);
  a210=(a210+a214);
  a214=2.1230051448181193e+01;
  a214=(a214*a002);
  a215=(a214*a147);
  a210=(a210+a215);
  a215=1.5279233632882423e+01;
  a215=(a215*a002);
  a216=(a215*a173);
  a210=(a210+a216);
  a216=-3.3288210968984863e+01;
  a216=(a216*a002);
  a217=(a216*a201);
  a210=(a210+a217);
  a217=-2.0331201708508627e-02;
  a217=(a217*a002);
  a218=(a177*a035);
  a219=(a184*a082);
  a218=(a218+a219);
  a219=(a185*a112);
  a218=(a218+a219);
  a219=(a186*a137);
  a218=(a218+a219);
  a219=(a187*a163);
  a218=(a218+a219);
  a219=(a188*a191);
  a218=(a218+a219);
  a218=(a008+a218);
  a219=(a007*a218);
  a220=(a177*a008);
  a221=(a184*a044);
  a220=(a220+a221);
  a221=(a185*a109);
  a220=(a220+a221);
  a221=(a186*a135);
  a220=(a220+a221);
  a221=(a187*a161);
  a220=(a220+a221);
  a221=(a188*a189);
  a220=(a220+a221);
  a220=(a010+a220);
  a221=sin(a220);
  a219=(a219*a221);
  a222=(2.*a182);
  a222=(a218-a222);
  a219=(a219*a222);
  a223=(a177*a003);
  a224=(a184*a091);
  a223=(a223+a224);
  a224=(a185*a114);
  a223=(a223+a224);
  a224=(a186*a024);
  a223=(a223+a224);
  a224=(a187*a131);
  a223=(a223+a224);
  a224=(a188*a156);
  a223=(a223+a224);
  a223=(a000+a223);
  a224=sin(a223);
  a225=cos(a220);
  a226=(a224*a225);
  a223=cos(a223);
  a227=(a223*a221);
  a226=(a226-a227);
  a227=(a007*a226);
  a219=(a219-a227);
  a228=(a224*a019);
  a219=(a219+a228);
  a229=(a018-a225);
  a229=(a021*a229);
  a229=(a229+a018);
  a230=(a219/a229);
  a231=(a225-a018);
  a231=(a007*a231);
  a232=(a231/a229);
  a233=casadi_sq(a182);
  a233=(a233*a221);
  a233=(a233+a226);
  a233=(a007*a233);
  a226=arg[2]? arg[2][16] : 0;
  a234=(a029*a226);
  a235=arg[2]? arg[2][17] : 0;
  a236=(a033*a235);
  a234=(a234+a236);
  a234=(a028*a234);
  a234=(a218+a234);
  a234=(a015*a234);
  a226=(a033*a226);
  a235=(a029*a235);
  a226=(a226-a235);
  a226=(a226+a018);
  a226=(a027*a226);
  a226=(a032-a226);
  a226=(a226+a220);
  a226=(a031*a226);
  a234=(a234+a226);
  a233=(a233-a234);
  a234=(a232*a219);
  a234=(a233-a234);
  a226=(a231*a232);
  a226=(a007-a226);
  a220=(a234/a226);
  a235=(a036*a223);
  a236=(a235/a229);
  a231=(a231*a236);
  a237=(a231/a226);
  a219=(a236*a219);
  a238=(a036*a182);
  a238=(a238*a182);
  a238=(a238*a224);
  a239=(a177*a072);
  a240=(a184*a110);
  a239=(a239+a240);
  a240=(a185*a157);
  a239=(a239+a240);
  a240=(a186*a183);
  a239=(a239+a240);
  a240=(a187*a211);
  a239=(a239+a240);
  a240=(a151*a009);
  a241=(a088*a078);
  a240=(a240+a241);
  a241=(a158*a111);
  a240=(a240+a241);
  a241=(a159*a136);
  a240=(a240+a241);
  a241=(a160*a162);
  a240=(a240+a241);
  a240=(a072+a240);
  a241=(a188*a240);
  a239=(a239+a241);
  a239=(a042+a239);
  a239=(a041*a239);
  a238=(a238+a239);
  a219=(a219-a238);
  a234=(a237*a234);
  a219=(a219-a234);
  a235=(a235*a236);
  a235=(a036-a235);
  a231=(a231*a237);
  a235=(a235-a231);
  a219=(a219/a235);
  a231=(a237*a219);
  a220=(a220-a231);
  a231=(a232*a220);
  a230=(a230-a231);
  a231=(a236*a219);
  a230=(a230+a231);
  a231=(a217*a230);
  a210=(a210+a231);
  a210=(a003+a210);
  a231=(a202*a210);
  a004=(a004+a231);
  a231=2.0136540080403034e-01;
  a231=(a231*a002);
  a234=-9.3714243008598730e-01;
  a234=(a234*a002);
  a239=(a234*a023);
  a241=5.1863724288440638e+00;
  a241=(a241*a002);
  a242=(a241*a100);
  a239=(a239+a242);
  a242=1.0914373489967295e+00;
  a242=(a242*a002);
  a243=(a242*a122);
  a239=(a239+a243);
  a243=-8.1497870107469268e+00;
  a243=(a243*a002);
  a244=(a243*a147);
  a239=(a239+a244);
  a244=-1.8520065659996959e+01;
  a244=(a244*a002);
  a245=(a244*a173);
  a239=(a239+a245);
  a245=2.2739487099350505e+01;
  a245=(a245*a002);
  a246=(a245*a201);
  a239=(a239+a246);
  a246=2.4936055526796523e+00;
  a246=(a246*a002);
  a247=(a246*a230);
  a239=(a239+a247);
  a247=-3.0467644718982196e+00;
  a247=(a247*a002);
  a248=(a205*a035);
  a249=(a212*a082);
  a248=(a248+a249);
  a249=(a213*a112);
  a248=(a248+a249);
  a249=(a214*a137);
  a248=(a248+a249);
  a249=(a215*a163);
  a248=(a248+a249);
  a249=(a216*a191);
  a248=(a248+a249);
  a249=(a217*a220);
  a248=(a248+a249);
  a248=(a008+a248);
  a249=(a007*a248);
  a250=(a205*a008);
  a251=(a212*a044);
  a250=(a250+a251);
  a251=(a213*a109);
  a250=(a250+a251);
  a251=(a214*a135);
  a250=(a250+a251);
  a251=(a215*a161);
  a250=(a250+a251);
  a251=(a216*a189);
  a250=(a250+a251);
  a251=(a217*a218);
  a250=(a250+a251);
  a250=(a010+a250);
  a251=sin(a250);
  a249=(a249*a251);
  a252=(2.*a210);
  a252=(a248-a252);
  a249=(a249*a252);
  a253=(a205*a003);
  a254=(a212*a091);
  a253=(a253+a254);
  a254=(a213*a114);
  a253=(a253+a254);
  a254=(a214*a024);
  a253=(a253+a254);
  a254=(a215*a131);
  a253=(a253+a254);
  a254=(a216*a156);
  a253=(a253+a254);
  a254=(a217*a182);
  a253=(a253+a254);
  a253=(a000+a253);
  a254=sin(a253);
  a255=cos(a250);
  a256=(a254*a255);
  a253=cos(a253);
  a257=(a253*a251);
  a256=(a256-a257);
  a257=(a007*a256);
  a249=(a249-a257);
  a258=(a254*a019);
  a249=(a249+a258);
  a259=(a018-a255);
  a259=(a021*a259);
  a259=(a259+a018);
  a260=(a249/a259);
  a261=(a255-a018);
  a261=(a007*a261);
  a262=(a261/a259);
  a263=casadi_sq(a210);
  a263=(a263*a251);
  a263=(a263+a256);
  a263=(a007*a263);
  a256=arg[2]? arg[2][18] : 0;
  a264=(a029*a256);
  a265=arg[2]? arg[2][19] : 0;
  a266=(a033*a265);
  a264=(a264+a266);
  a264=(a028*a264);
  a264=(a248+a264);
  a264=(a015*a264);
  a256=(a033*a256);
  a265=(a029*a265);
  a256=(a256-a265);
  a256=(a256+a018);
  a256=(a027*a256);
  a256=(a032-a256);
  a256=(a256+a250);
  a256=(a031*a256);
  a264=(a264+a256);
  a263=(a263-a264);
  a264=(a262*a249);
  a264=(a263-a264);
  a256=(a261*a262);
  a256=(a007-a256);
  a250=(a264/a256);
  a265=(a036*a253);
  a266=(a265/a259);
  a261=(a261*a266);
  a267=(a261/a256);
  a249=(a266*a249);
  a268=(a036*a210);
  a268=(a268*a210);
  a268=(a268*a254);
  a269=(a205*a072);
  a270=(a212*a110);
  a269=(a269+a270);
  a270=(a213*a157);
  a269=(a269+a270);
  a270=(a214*a183);
  a269=(a269+a270);
  a270=(a215*a211);
  a269=(a269+a270);
  a270=(a216*a240);
  a269=(a269+a270);
  a270=(a177*a009);
  a271=(a184*a078);
  a270=(a270+a271);
  a271=(a185*a111);
  a270=(a270+a271);
  a271=(a186*a136);
  a270=(a270+a271);
  a271=(a187*a162);
  a270=(a270+a271);
  a271=(a188*a190);
  a270=(a270+a271);
  a270=(a072+a270);
  a271=(a217*a270);
  a269=(a269+a271);
  a269=(a042+a269);
  a269=(a041*a269);
  a268=(a268+a269);
  a249=(a249-a268);
  a264=(a267*a264);
  a249=(a249-a264);
  a265=(a265*a266);
  a265=(a036-a265);
  a261=(a261*a267);
  a265=(a265-a261);
  a249=(a249/a265);
  a261=(a267*a249);
  a250=(a250-a261);
  a261=(a262*a250);
  a260=(a260-a261);
  a261=(a266*a249);
  a260=(a260+a261);
  a261=(a247*a260);
  a239=(a239+a261);
  a239=(a003+a239);
  a261=(a231*a239);
  a004=(a004+a261);
  a261=4.4710615727772587e-02;
  a261=(a261*a002);
  a264=2.2733101475165380e+00;
  a264=(a264*a002);
  a269=(a264*a023);
  a271=-1.0534495466737249e+01;
  a271=(a271*a002);
  a100=(a271*a100);
  a269=(a269+a100);
  a100=-2.0008720582248625e+00;
  a100=(a100*a002);
  a122=(a100*a122);
  a269=(a269+a122);
  a122=-1.7958931863118799e+01;
  a122=(a122*a002);
  a272=(a122*a147);
  a269=(a269+a272);
  a272=2.7948884529419960e+01;
  a272=(a272*a002);
  a273=(a272*a173);
  a269=(a269+a273);
  a273=-2.8589982771350235e+00;
  a273=(a273*a002);
  a274=(a273*a201);
  a269=(a269+a274);
  a274=-8.8728569335306293e+00;
  a274=(a274*a002);
  a275=(a274*a230);
  a269=(a269+a275);
  a275=1.2360567175794303e+01;
  a275=(a275*a002);
  a276=(a275*a260);
  a269=(a269+a276);
  a276=6.4339274601576357e-01;
  a276=(a276*a002);
  a002=(a234*a035);
  a277=(a241*a082);
  a002=(a002+a277);
  a277=(a242*a112);
  a002=(a002+a277);
  a277=(a243*a137);
  a002=(a002+a277);
  a277=(a244*a163);
  a002=(a002+a277);
  a277=(a245*a191);
  a002=(a002+a277);
  a277=(a246*a220);
  a002=(a002+a277);
  a277=(a247*a250);
  a002=(a002+a277);
  a002=(a008+a002);
  a277=(a007*a002);
  a278=(a234*a008);
  a279=(a241*a044);
  a278=(a278+a279);
  a279=(a242*a109);
  a278=(a278+a279);
  a279=(a243*a135);
  a278=(a278+a279);
  a279=(a244*a161);
  a278=(a278+a279);
  a279=(a245*a189);
  a278=(a278+a279);
  a279=(a246*a218);
  a278=(a278+a279);
  a279=(a247*a248);
  a278=(a278+a279);
  a278=(a010+a278);
  a279=sin(a278);
  a277=(a277*a279);
  a280=(2.*a239);
  a280=(a002-a280);
  a277=(a277*a280);
  a281=(a234*a003);
  a282=(a241*a091);
  a281=(a281+a282);
  a282=(a242*a114);
  a281=(a281+a282);
  a282=(a243*a024);
  a281=(a281+a282);
  a282=(a244*a131);
  a281=(a281+a282);
  a282=(a245*a156);
  a281=(a281+a282);
  a282=(a246*a182);
  a281=(a281+a282);
  a282=(a247*a210);
  a281=(a281+a282);
  a281=(a000+a281);
  a282=sin(a281);
  a283=cos(a278);
  a284=(a282*a283);
  a281=cos(a281);
  a285=(a281*a279);
  a284=(a284-a285);
  a285=(a007*a284);
  a277=(a277-a285);
  a286=(a282*a019);
  a277=(a277+a286);
  a287=(a018-a283);
  a287=(a021*a287);
  a287=(a287+a018);
  a288=(a277/a287);
  a289=(a283-a018);
  a289=(a007*a289);
  a290=(a289/a287);
  a291=casadi_sq(a239);
  a291=(a291*a279);
  a291=(a291+a284);
  a291=(a007*a291);
  a284=arg[2]? arg[2][20] : 0;
  a292=(a029*a284);
  a293=arg[2]? arg[2][21] : 0;
  a294=(a033*a293);
  a292=(a292+a294);
  a292=(a028*a292);
  a292=(a002+a292);
  a292=(a015*a292);
  a284=(a033*a284);
  a293=(a029*a293);
  a284=(a284-a293);
  a284=(a284+a018);
  a284=(a027*a284);
  a284=(a032-a284);
  a284=(a284+a278);
  a284=(a031*a284);
  a292=(a292+a284);
  a291=(a291-a292);
  a292=(a290*a277);
  a292=(a291-a292);
  a284=(a289*a290);
  a284=(a007-a284);
  a278=(a292/a284);
  a293=(a036*a281);
  a294=(a293/a287);
  a289=(a289*a294);
  a295=(a289/a284);
  a277=(a294*a277);
  a296=(a036*a239);
  a296=(a296*a239);
  a296=(a296*a282);
  a297=(a234*a072);
  a298=(a241*a110);
  a297=(a297+a298);
  a298=(a242*a157);
  a297=(a297+a298);
  a298=(a243*a183);
  a297=(a297+a298);
  a298=(a244*a211);
  a297=(a297+a298);
  a298=(a245*a240);
  a297=(a297+a298);
  a298=(a246*a270);
  a297=(a297+a298);
  a298=(a205*a009);
  a299=(a212*a078);
  a298=(a298+a299);
  a299=(a213*a111);
  a298=(a298+a299);
  a299=(a214*a136);
  a298=(a298+a299);
  a299=(a215*a162);
  a298=(a298+a299);
  a299=(a216*a190);
  a298=(a298+a299);
  a299=(a217*a219);
  a298=(a298+a299);
  a298=(a072+a298);
  a299=(a247*a298);
  a297=(a297+a299);
  a297=(a042+a297);
  a297=(a041*a297);
  a296=(a296+a297);
  a277=(a277-a296);
  a292=(a295*a292);
  a277=(a277-a292);
  a293=(a293*a294);
  a293=(a036-a293);
  a289=(a289*a295);
  a293=(a293-a289);
  a277=(a277/a293);
  a289=(a295*a277);
  a278=(a278-a289);
  a289=(a290*a278);
  a288=(a288-a289);
  a289=(a294*a277);
  a288=(a288+a289);
  a289=(a276*a288);
  a269=(a269+a289);
  a269=(a003+a269);
  a289=(a261*a269);
  a004=(a004+a289);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a289=(a005*a135);
  a004=(a004+a289);
  a289=(a123*a161);
  a004=(a004+a289);
  a289=(a148*a189);
  a004=(a004+a289);
  a289=(a174*a218);
  a004=(a004+a289);
  a289=(a202*a248);
  a004=(a004+a289);
  a289=(a231*a002);
  a004=(a004+a289);
  a289=(a264*a035);
  a082=(a271*a082);
  a289=(a289+a082);
  a112=(a100*a112);
  a289=(a289+a112);
  a112=(a122*a137);
  a289=(a289+a112);
  a112=(a272*a163);
  a289=(a289+a112);
  a112=(a273*a191);
  a289=(a289+a112);
  a112=(a274*a220);
  a289=(a289+a112);
  a112=(a275*a250);
  a289=(a289+a112);
  a112=(a276*a278);
  a289=(a289+a112);
  a289=(a008+a289);
  a112=(a261*a289);
  a004=(a004+a112);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a072);
  a112=(a005*a183);
  a004=(a004+a112);
  a112=(a123*a211);
  a004=(a004+a112);
  a112=(a148*a240);
  a004=(a004+a112);
  a112=(a174*a270);
  a004=(a004+a112);
  a112=(a202*a298);
  a004=(a004+a112);
  a112=(a234*a009);
  a082=(a241*a078);
  a112=(a112+a082);
  a082=(a242*a111);
  a112=(a112+a082);
  a082=(a243*a136);
  a112=(a112+a082);
  a082=(a244*a162);
  a112=(a112+a082);
  a082=(a245*a190);
  a112=(a112+a082);
  a082=(a246*a219);
  a112=(a112+a082);
  a082=(a247*a249);
  a112=(a112+a082);
  a112=(a072+a112);
  a082=(a231*a112);
  a004=(a004+a082);
  a082=(a264*a009);
  a078=(a271*a078);
  a082=(a082+a078);
  a111=(a100*a111);
  a082=(a082+a111);
  a111=(a122*a136);
  a082=(a082+a111);
  a111=(a272*a162);
  a082=(a082+a111);
  a111=(a273*a190);
  a082=(a082+a111);
  a111=(a274*a219);
  a082=(a082+a111);
  a111=(a275*a249);
  a082=(a082+a111);
  a111=(a276*a277);
  a082=(a082+a111);
  a082=(a072+a082);
  a082=(a261*a082);
  a004=(a004+a082);
  a004=(a042+a004);
  if (res[0]!=0) res[0][2]=a004;
  a023=(a001*a023);
  a147=(a005*a147);
  a023=(a023+a147);
  a173=(a123*a173);
  a023=(a023+a173);
  a201=(a148*a201);
  a023=(a023+a201);
  a230=(a174*a230);
  a023=(a023+a230);
  a260=(a202*a260);
  a023=(a023+a260);
  a288=(a231*a288);
  a023=(a023+a288);
  a288=(a007*a289);
  a260=(a264*a008);
  a230=(a271*a044);
  a260=(a260+a230);
  a230=(a100*a109);
  a260=(a260+a230);
  a230=(a122*a135);
  a260=(a260+a230);
  a230=(a272*a161);
  a260=(a260+a230);
  a230=(a273*a189);
  a260=(a260+a230);
  a230=(a274*a218);
  a260=(a260+a230);
  a230=(a275*a248);
  a260=(a260+a230);
  a230=(a276*a002);
  a260=(a260+a230);
  a010=(a010+a260);
  a260=sin(a010);
  a288=(a288*a260);
  a230=(2.*a269);
  a230=(a289-a230);
  a288=(a288*a230);
  a201=(a264*a003);
  a173=(a271*a091);
  a201=(a201+a173);
  a173=(a100*a114);
  a201=(a201+a173);
  a173=(a122*a024);
  a201=(a201+a173);
  a173=(a272*a131);
  a201=(a201+a173);
  a173=(a273*a156);
  a201=(a201+a173);
  a173=(a274*a182);
  a201=(a201+a173);
  a173=(a275*a210);
  a201=(a201+a173);
  a173=(a276*a239);
  a201=(a201+a173);
  a000=(a000+a201);
  a201=sin(a000);
  a173=cos(a010);
  a147=(a201*a173);
  a000=cos(a000);
  a004=(a000*a260);
  a147=(a147-a004);
  a004=(a007*a147);
  a288=(a288-a004);
  a019=(a201*a019);
  a288=(a288+a019);
  a082=(a018-a173);
  a082=(a021*a082);
  a082=(a082+a018);
  a111=(a288/a082);
  a078=(a173-a018);
  a078=(a007*a078);
  a292=(a078/a082);
  a297=casadi_sq(a269);
  a297=(a297*a260);
  a297=(a297+a147);
  a297=(a007*a297);
  a147=arg[2]? arg[2][22] : 0;
  a299=(a029*a147);
  a300=arg[2]? arg[2][23] : 0;
  a301=(a033*a300);
  a299=(a299+a301);
  a028=(a028*a299);
  a028=(a289+a028);
  a028=(a015*a028);
  a033=(a033*a147);
  a029=(a029*a300);
  a033=(a033-a029);
  a033=(a033+a018);
  a027=(a027*a033);
  a032=(a032-a027);
  a032=(a032+a010);
  a032=(a031*a032);
  a028=(a028+a032);
  a297=(a297-a028);
  a028=(a292*a288);
  a028=(a297-a028);
  a032=(a078*a292);
  a032=(a007-a032);
  a010=(a028/a032);
  a027=(a036*a000);
  a033=(a027/a082);
  a078=(a078*a033);
  a018=(a078/a032);
  a288=(a033*a288);
  a029=(a036*a269);
  a029=(a029*a269);
  a029=(a029*a201);
  a300=(a264*a072);
  a110=(a271*a110);
  a300=(a300+a110);
  a157=(a100*a157);
  a300=(a300+a157);
  a183=(a122*a183);
  a300=(a300+a183);
  a211=(a272*a211);
  a300=(a300+a211);
  a240=(a273*a240);
  a300=(a300+a240);
  a270=(a274*a270);
  a300=(a300+a270);
  a298=(a275*a298);
  a300=(a300+a298);
  a112=(a276*a112);
  a300=(a300+a112);
  a042=(a042+a300);
  a042=(a041*a042);
  a029=(a029+a042);
  a288=(a288-a029);
  a028=(a018*a028);
  a288=(a288-a028);
  a027=(a027*a033);
  a027=(a036-a027);
  a078=(a078*a018);
  a027=(a027-a078);
  a288=(a288/a027);
  a078=(a018*a288);
  a010=(a010-a078);
  a078=(a292*a010);
  a111=(a111-a078);
  a078=(a033*a288);
  a111=(a111+a078);
  a111=(a261*a111);
  a023=(a023+a111);
  a023=(a003+a023);
  if (res[0]!=0) res[0][3]=a023;
  a035=(a001*a035);
  a137=(a005*a137);
  a035=(a035+a137);
  a163=(a123*a163);
  a035=(a035+a163);
  a191=(a148*a191);
  a035=(a035+a191);
  a220=(a174*a220);
  a035=(a035+a220);
  a250=(a202*a250);
  a035=(a035+a250);
  a278=(a231*a278);
  a035=(a035+a278);
  a010=(a261*a010);
  a035=(a035+a010);
  a035=(a008+a035);
  if (res[0]!=0) res[0][4]=a035;
  a009=(a001*a009);
  a136=(a005*a136);
  a009=(a009+a136);
  a162=(a123*a162);
  a009=(a009+a162);
  a190=(a148*a190);
  a009=(a009+a190);
  a219=(a174*a219);
  a009=(a009+a219);
  a249=(a202*a249);
  a009=(a009+a249);
  a277=(a231*a277);
  a009=(a009+a277);
  a288=(a261*a288);
  a009=(a009+a288);
  a072=(a072+a009);
  if (res[0]!=0) res[0][5]=a072;
  a072=arg[0]? arg[0][6] : 0;
  a009=arg[0]? arg[0][9] : 0;
  a288=(a001*a009);
  a277=(a016*a014);
  a249=(a013*a011);
  a277=(a277+a249);
  a249=(a016-a277);
  a249=(a007*a249);
  a219=(a007*a011);
  a012=(a008*a012);
  a219=(a219*a012);
  a219=(a219-a017);
  a219=(a219+a020);
  a020=(a038*a219);
  a020=(a020-a040);
  a040=(a025*a219);
  a026=(a026-a040);
  a040=(a039*a026);
  a020=(a020-a040);
  a020=(a020/a037);
  a040=(a020*a036);
  a040=(a040*a013);
  a249=(a249-a040);
  a249=(a249+a016);
  a040=(a249/a022);
  a017=(a007*a277);
  a190=(a025*a249);
  a017=(a017-a190);
  a190=(a017/a034);
  a249=(a038*a249);
  a219=(a219/a022);
  a026=(a026/a034);
  a162=(a039*a020);
  a026=(a026-a162);
  a162=(a025*a026);
  a219=(a219-a162);
  a020=(a038*a020);
  a219=(a219+a020);
  a020=(a219*a013);
  a016=(a016*a003);
  a016=(a016*a003);
  a020=(a020+a016);
  a020=(a036*a020);
  a249=(a249-a020);
  a017=(a039*a017);
  a249=(a249-a017);
  a249=(a249/a037);
  a017=(a039*a249);
  a190=(a190-a017);
  a017=(a025*a190);
  a040=(a040-a017);
  a017=(a038*a249);
  a040=(a040+a017);
  a017=(a040*a072);
  a012=(a014*a012);
  a012=(a277+a012);
  a020=(2.*a219);
  a026=(a026-a020);
  a026=(a011*a026);
  a012=(a012+a026);
  a012=(a007*a012);
  a026=(a012/a022);
  a219=(a219*a011);
  a219=(a219-a277);
  a014=(a014*a003);
  a014=(a014*a003);
  a219=(a219+a014);
  a219=(a007*a219);
  a219=(a219-a031);
  a014=(a025*a012);
  a219=(a219-a014);
  a014=(a219/a034);
  a012=(a038*a012);
  a219=(a039*a219);
  a012=(a012-a219);
  a012=(a012/a037);
  a219=(a039*a012);
  a014=(a014-a219);
  a219=(a025*a014);
  a026=(a026-a219);
  a219=(a038*a012);
  a026=(a026+a219);
  a219=arg[0]? arg[0][7] : 0;
  a277=(a026*a219);
  a017=(a017+a277);
  a277=(a041/a037);
  a020=(a039*a277);
  a016=(a025*a020);
  a162=(a038*a277);
  a016=(a016+a162);
  a162=arg[0]? arg[0][8] : 0;
  a136=(a016*a162);
  a017=(a017-a136);
  a136=-2.;
  a035=(a136*a007);
  a010=(a035*a008);
  a010=(a010*a011);
  a278=(a010/a022);
  a250=(a021*a003);
  a250=(a250*a011);
  a220=(a025*a010);
  a250=(a250-a220);
  a220=(a250/a034);
  a136=(a136*a036);
  a191=(a136*a003);
  a191=(a191*a013);
  a010=(a038*a010);
  a191=(a191+a010);
  a250=(a039*a250);
  a191=(a191-a250);
  a191=(a191/a037);
  a250=(a039*a191);
  a220=(a220-a250);
  a250=(a025*a220);
  a278=(a278-a250);
  a250=(a038*a191);
  a278=(a278+a250);
  a250=(a278*a009);
  a011=(a021*a011);
  a008=(a008-a003);
  a011=(a011*a008);
  a022=(a011/a022);
  a008=(a025*a011);
  a008=(a015+a008);
  a034=(a008/a034);
  a011=(a038*a011);
  a008=(a039*a008);
  a011=(a011+a008);
  a011=(a011/a037);
  a039=(a039*a011);
  a034=(a034+a039);
  a025=(a025*a034);
  a022=(a022+a025);
  a038=(a038*a011);
  a022=(a022+a038);
  a038=arg[0]? arg[0][10] : 0;
  a025=(a022*a038);
  a250=(a250+a025);
  a017=(a017+a250);
  a250=(a006*a017);
  a025=(a093*a095);
  a039=(a094*a090);
  a025=(a025+a039);
  a039=(a093-a025);
  a039=(a007*a039);
  a037=(a007*a090);
  a092=(a044*a092);
  a037=(a037*a092);
  a037=(a037-a097);
  a037=(a037+a098);
  a098=(a106*a037);
  a098=(a098-a108);
  a108=(a102*a037);
  a103=(a103-a108);
  a108=(a107*a103);
  a098=(a098-a108);
  a098=(a098/a105);
  a108=(a098*a036);
  a108=(a108*a094);
  a039=(a039-a108);
  a039=(a039+a093);
  a108=(a039/a099);
  a097=(a007*a025);
  a008=(a102*a039);
  a097=(a097-a008);
  a008=(a097/a096);
  a039=(a106*a039);
  a037=(a037/a099);
  a103=(a103/a096);
  a003=(a107*a098);
  a103=(a103-a003);
  a003=(a102*a103);
  a037=(a037-a003);
  a098=(a106*a098);
  a037=(a037+a098);
  a098=(a037*a094);
  a093=(a093*a091);
  a093=(a093*a091);
  a098=(a098+a093);
  a098=(a036*a098);
  a039=(a039-a098);
  a097=(a107*a097);
  a039=(a039-a097);
  a039=(a039/a105);
  a097=(a107*a039);
  a008=(a008-a097);
  a097=(a102*a008);
  a108=(a108-a097);
  a097=(a106*a039);
  a108=(a108+a097);
  a097=(a043*a009);
  a098=(a046*a017);
  a093=(a056*a058);
  a003=(a057*a053);
  a093=(a093+a003);
  a003=(a056-a093);
  a003=(a007*a003);
  a010=(a007*a053);
  a055=(a050*a055);
  a010=(a010*a055);
  a010=(a010-a060);
  a010=(a010+a061);
  a061=(a069*a010);
  a061=(a061-a071);
  a071=(a065*a010);
  a066=(a066-a071);
  a071=(a070*a066);
  a061=(a061-a071);
  a061=(a061/a068);
  a071=(a061*a036);
  a071=(a071*a057);
  a003=(a003-a071);
  a003=(a003+a056);
  a071=(a003/a062);
  a060=(a007*a093);
  a013=(a065*a003);
  a060=(a060-a013);
  a013=(a060/a059);
  a003=(a069*a003);
  a010=(a010/a062);
  a066=(a066/a059);
  a163=(a070*a061);
  a066=(a066-a163);
  a163=(a065*a066);
  a010=(a010-a163);
  a061=(a069*a061);
  a010=(a010+a061);
  a061=(a010*a057);
  a056=(a056*a054);
  a056=(a056*a054);
  a061=(a061+a056);
  a061=(a036*a061);
  a003=(a003-a061);
  a060=(a070*a060);
  a003=(a003-a060);
  a003=(a003/a068);
  a060=(a070*a003);
  a013=(a013-a060);
  a060=(a065*a013);
  a071=(a071-a060);
  a060=(a069*a003);
  a071=(a071+a060);
  a060=(a049*a009);
  a060=(a072+a060);
  a061=(a071*a060);
  a055=(a058*a055);
  a055=(a093+a055);
  a056=(2.*a010);
  a066=(a066-a056);
  a066=(a053*a066);
  a055=(a055+a066);
  a055=(a007*a055);
  a066=(a055/a062);
  a010=(a010*a053);
  a010=(a010-a093);
  a058=(a058*a054);
  a058=(a058*a054);
  a010=(a010+a058);
  a010=(a007*a010);
  a010=(a010-a031);
  a058=(a065*a055);
  a010=(a010-a058);
  a058=(a010/a059);
  a055=(a069*a055);
  a010=(a070*a010);
  a055=(a055-a010);
  a055=(a055/a068);
  a010=(a070*a055);
  a058=(a058-a010);
  a010=(a065*a058);
  a066=(a066-a010);
  a010=(a069*a055);
  a066=(a066+a010);
  a010=(a049*a038);
  a010=(a219+a010);
  a093=(a066*a010);
  a061=(a061+a093);
  a093=(a041/a068);
  a056=(a070*a093);
  a163=(a065*a056);
  a137=(a069*a093);
  a163=(a163+a137);
  a137=arg[0]? arg[0][11] : 0;
  a023=(a049*a137);
  a023=(a162+a023);
  a111=(a163*a023);
  a061=(a061-a111);
  a111=(a035*a050);
  a111=(a111*a053);
  a078=(a111/a062);
  a028=(a021*a054);
  a028=(a028*a053);
  a042=(a065*a111);
  a028=(a028-a042);
  a042=(a028/a059);
  a300=(a136*a054);
  a300=(a300*a057);
  a111=(a069*a111);
  a300=(a300+a111);
  a028=(a070*a028);
  a300=(a300-a028);
  a300=(a300/a068);
  a028=(a070*a300);
  a042=(a042-a028);
  a028=(a065*a042);
  a078=(a078-a028);
  a028=(a069*a300);
  a078=(a078+a028);
  a028=(a049*a017);
  a028=(a009+a028);
  a111=(a078*a028);
  a053=(a021*a053);
  a050=(a050-a054);
  a053=(a053*a050);
  a062=(a053/a062);
  a050=(a065*a053);
  a050=(a015+a050);
  a059=(a050/a059);
  a053=(a069*a053);
  a050=(a070*a050);
  a053=(a053+a050);
  a053=(a053/a068);
  a070=(a070*a053);
  a059=(a059+a070);
  a065=(a065*a059);
  a062=(a062+a065);
  a069=(a069*a053);
  a062=(a062+a069);
  a069=(a190*a072);
  a065=(a014*a219);
  a069=(a069+a065);
  a065=(a020*a162);
  a069=(a069+a065);
  a065=(a220*a009);
  a070=(a034*a038);
  a065=(a065-a070);
  a069=(a069+a065);
  a065=(a049*a069);
  a065=(a038+a065);
  a070=(a062*a065);
  a111=(a111+a070);
  a061=(a061+a111);
  a061=(a048*a061);
  a098=(a098+a061);
  a098=(a009+a098);
  a061=(a045*a098);
  a097=(a097+a061);
  a097=(a072+a097);
  a061=(a108*a097);
  a092=(a095*a092);
  a092=(a025+a092);
  a111=(2.*a037);
  a103=(a103-a111);
  a103=(a090*a103);
  a092=(a092+a103);
  a092=(a007*a092);
  a103=(a092/a099);
  a037=(a037*a090);
  a037=(a037-a025);
  a095=(a095*a091);
  a095=(a095*a091);
  a037=(a037+a095);
  a037=(a007*a037);
  a037=(a037-a031);
  a095=(a102*a092);
  a037=(a037-a095);
  a095=(a037/a096);
  a092=(a106*a092);
  a037=(a107*a037);
  a092=(a092-a037);
  a092=(a092/a105);
  a037=(a107*a092);
  a095=(a095-a037);
  a037=(a102*a095);
  a103=(a103-a037);
  a037=(a106*a092);
  a103=(a103+a037);
  a037=(a043*a038);
  a025=(a046*a069);
  a111=(a013*a060);
  a070=(a058*a010);
  a111=(a111+a070);
  a070=(a056*a023);
  a111=(a111+a070);
  a070=(a042*a028);
  a068=(a059*a065);
  a070=(a070-a068);
  a111=(a111+a070);
  a111=(a048*a111);
  a025=(a025+a111);
  a025=(a038+a025);
  a111=(a045*a025);
  a037=(a037+a111);
  a037=(a219+a037);
  a111=(a103*a037);
  a061=(a061+a111);
  a111=(a041/a105);
  a070=(a107*a111);
  a068=(a102*a070);
  a050=(a106*a111);
  a068=(a068+a050);
  a050=(a043*a137);
  a054=(a249*a072);
  a057=(a012*a219);
  a054=(a054+a057);
  a057=(a277*a162);
  a054=(a054-a057);
  a057=(a191*a009);
  a112=(a011*a038);
  a057=(a057+a112);
  a054=(a054+a057);
  a057=(a046*a054);
  a060=(a003*a060);
  a010=(a055*a010);
  a060=(a060+a010);
  a023=(a093*a023);
  a060=(a060-a023);
  a023=(a300*a028);
  a010=(a053*a065);
  a023=(a023+a010);
  a060=(a060+a023);
  a060=(a048*a060);
  a057=(a057+a060);
  a057=(a137+a057);
  a060=(a045*a057);
  a050=(a050+a060);
  a050=(a162+a050);
  a060=(a068*a050);
  a061=(a061-a060);
  a060=(a035*a044);
  a060=(a060*a090);
  a023=(a060/a099);
  a010=(a021*a091);
  a010=(a010*a090);
  a112=(a102*a060);
  a010=(a010-a112);
  a112=(a010/a096);
  a298=(a136*a091);
  a298=(a298*a094);
  a060=(a106*a060);
  a298=(a298+a060);
  a010=(a107*a010);
  a298=(a298-a010);
  a298=(a298/a105);
  a010=(a107*a298);
  a112=(a112-a010);
  a010=(a102*a112);
  a023=(a023-a010);
  a010=(a106*a298);
  a023=(a023+a010);
  a010=(a043*a017);
  a060=(a073*a075);
  a094=(a074*a067);
  a060=(a060+a094);
  a094=(a073-a060);
  a094=(a007*a094);
  a270=(a007*a067);
  a080=(a077*a080);
  a270=(a270*a080);
  a270=(a270-a076);
  a270=(a270+a081);
  a081=(a086*a270);
  a081=(a081-a089);
  a089=(a064*a270);
  a063=(a063-a089);
  a089=(a087*a063);
  a081=(a081-a089);
  a081=(a081/a085);
  a089=(a081*a036);
  a089=(a089*a074);
  a094=(a094-a089);
  a094=(a094+a073);
  a089=(a094/a052);
  a076=(a007*a060);
  a240=(a064*a094);
  a076=(a076-a240);
  a240=(a076/a083);
  a094=(a086*a094);
  a270=(a270/a052);
  a063=(a063/a083);
  a211=(a087*a081);
  a063=(a063-a211);
  a211=(a064*a063);
  a270=(a270-a211);
  a081=(a086*a081);
  a270=(a270+a081);
  a081=(a270*a074);
  a073=(a073*a047);
  a073=(a073*a047);
  a081=(a081+a073);
  a081=(a036*a081);
  a094=(a094-a081);
  a076=(a087*a076);
  a094=(a094-a076);
  a094=(a094/a085);
  a076=(a087*a094);
  a240=(a240-a076);
  a076=(a064*a240);
  a089=(a089-a076);
  a076=(a086*a094);
  a089=(a089+a076);
  a076=(a046*a009);
  a028=(a048*a028);
  a076=(a076+a028);
  a076=(a072+a076);
  a028=(a089*a076);
  a080=(a075*a080);
  a080=(a060+a080);
  a081=(2.*a270);
  a063=(a063-a081);
  a063=(a067*a063);
  a080=(a080+a063);
  a080=(a007*a080);
  a063=(a080/a052);
  a270=(a270*a067);
  a270=(a270-a060);
  a075=(a075*a047);
  a075=(a075*a047);
  a270=(a270+a075);
  a270=(a007*a270);
  a270=(a270-a031);
  a075=(a064*a080);
  a270=(a270-a075);
  a075=(a270/a083);
  a080=(a086*a080);
  a270=(a087*a270);
  a080=(a080-a270);
  a080=(a080/a085);
  a270=(a087*a080);
  a075=(a075-a270);
  a270=(a064*a075);
  a063=(a063-a270);
  a270=(a086*a080);
  a063=(a063+a270);
  a270=(a046*a038);
  a065=(a048*a065);
  a270=(a270+a065);
  a270=(a219+a270);
  a065=(a063*a270);
  a028=(a028+a065);
  a065=(a041/a085);
  a060=(a087*a065);
  a081=(a064*a060);
  a073=(a086*a065);
  a081=(a081+a073);
  a073=(a046*a137);
  a211=(a049*a054);
  a211=(a137+a211);
  a211=(a048*a211);
  a073=(a073+a211);
  a073=(a162+a073);
  a211=(a081*a073);
  a028=(a028-a211);
  a211=(a035*a077);
  a211=(a211*a067);
  a183=(a211/a052);
  a157=(a021*a047);
  a157=(a157*a067);
  a110=(a064*a211);
  a157=(a157-a110);
  a110=(a157/a083);
  a147=(a136*a047);
  a147=(a147*a074);
  a211=(a086*a211);
  a147=(a147+a211);
  a157=(a087*a157);
  a147=(a147-a157);
  a147=(a147/a085);
  a157=(a087*a147);
  a110=(a110-a157);
  a157=(a064*a110);
  a183=(a183-a157);
  a157=(a086*a147);
  a183=(a183+a157);
  a157=(a183*a098);
  a067=(a021*a067);
  a077=(a077-a047);
  a067=(a067*a077);
  a052=(a067/a052);
  a077=(a064*a067);
  a077=(a015+a077);
  a083=(a077/a083);
  a067=(a086*a067);
  a077=(a087*a077);
  a067=(a067+a077);
  a067=(a067/a085);
  a087=(a087*a067);
  a083=(a083+a087);
  a064=(a064*a083);
  a052=(a052+a064);
  a086=(a086*a067);
  a052=(a052+a086);
  a086=(a052*a025);
  a157=(a157+a086);
  a028=(a028+a157);
  a157=(a045*a028);
  a010=(a010+a157);
  a010=(a009+a010);
  a157=(a023*a010);
  a090=(a021*a090);
  a044=(a044-a091);
  a090=(a090*a044);
  a099=(a090/a099);
  a044=(a102*a090);
  a044=(a015+a044);
  a096=(a044/a096);
  a090=(a106*a090);
  a044=(a107*a044);
  a090=(a090+a044);
  a090=(a090/a105);
  a107=(a107*a090);
  a096=(a096+a107);
  a102=(a102*a096);
  a099=(a099+a102);
  a106=(a106*a090);
  a099=(a099+a106);
  a106=(a043*a069);
  a102=(a240*a076);
  a107=(a075*a270);
  a102=(a102+a107);
  a107=(a060*a073);
  a102=(a102+a107);
  a107=(a110*a098);
  a105=(a083*a025);
  a107=(a107-a105);
  a102=(a102+a107);
  a107=(a045*a102);
  a106=(a106+a107);
  a106=(a038+a106);
  a107=(a099*a106);
  a157=(a157+a107);
  a061=(a061+a157);
  a157=(a030*a061);
  a250=(a250+a157);
  a157=(a115*a117);
  a107=(a116*a113);
  a157=(a157+a107);
  a107=(a115-a157);
  a107=(a007*a107);
  a105=(a007*a113);
  a079=(a109*a079);
  a105=(a105*a079);
  a105=(a105-a119);
  a105=(a105+a120);
  a120=(a128*a105);
  a120=(a120-a130);
  a130=(a124*a105);
  a125=(a125-a130);
  a130=(a129*a125);
  a120=(a120-a130);
  a120=(a120/a127);
  a130=(a120*a036);
  a130=(a130*a116);
  a107=(a107-a130);
  a107=(a107+a115);
  a130=(a107/a121);
  a119=(a007*a157);
  a044=(a124*a107);
  a119=(a119-a044);
  a044=(a119/a118);
  a107=(a128*a107);
  a105=(a105/a121);
  a125=(a125/a118);
  a091=(a129*a120);
  a125=(a125-a091);
  a091=(a124*a125);
  a105=(a105-a091);
  a120=(a128*a120);
  a105=(a105+a120);
  a120=(a105*a116);
  a115=(a115*a114);
  a115=(a115*a114);
  a120=(a120+a115);
  a120=(a036*a120);
  a107=(a107-a120);
  a119=(a129*a119);
  a107=(a107-a119);
  a107=(a107/a127);
  a119=(a129*a107);
  a044=(a044-a119);
  a119=(a124*a044);
  a130=(a130-a119);
  a119=(a128*a107);
  a130=(a130+a119);
  a119=(a104*a009);
  a120=(a051*a098);
  a119=(a119+a120);
  a120=(a084*a010);
  a119=(a119+a120);
  a119=(a072+a119);
  a120=(a130*a119);
  a079=(a117*a079);
  a079=(a157+a079);
  a115=(2.*a105);
  a125=(a125-a115);
  a125=(a113*a125);
  a079=(a079+a125);
  a079=(a007*a079);
  a125=(a079/a121);
  a105=(a105*a113);
  a105=(a105-a157);
  a117=(a117*a114);
  a117=(a117*a114);
  a105=(a105+a117);
  a105=(a007*a105);
  a105=(a105-a031);
  a117=(a124*a079);
  a105=(a105-a117);
  a117=(a105/a118);
  a079=(a128*a079);
  a105=(a129*a105);
  a079=(a079-a105);
  a079=(a079/a127);
  a105=(a129*a079);
  a117=(a117-a105);
  a105=(a124*a117);
  a125=(a125-a105);
  a105=(a128*a079);
  a125=(a125+a105);
  a105=(a104*a038);
  a157=(a051*a025);
  a105=(a105+a157);
  a157=(a084*a106);
  a105=(a105+a157);
  a105=(a219+a105);
  a157=(a125*a105);
  a120=(a120+a157);
  a157=(a041/a127);
  a115=(a129*a157);
  a091=(a124*a115);
  a086=(a128*a157);
  a091=(a091+a086);
  a086=(a104*a137);
  a057=(a051*a057);
  a086=(a086+a057);
  a057=(a043*a054);
  a076=(a094*a076);
  a270=(a080*a270);
  a076=(a076+a270);
  a073=(a065*a073);
  a076=(a076-a073);
  a098=(a147*a098);
  a025=(a067*a025);
  a098=(a098+a025);
  a076=(a076+a098);
  a098=(a045*a076);
  a057=(a057+a098);
  a057=(a137+a057);
  a098=(a084*a057);
  a086=(a086+a098);
  a086=(a162+a086);
  a098=(a091*a086);
  a120=(a120-a098);
  a098=(a035*a109);
  a098=(a098*a113);
  a025=(a098/a121);
  a073=(a021*a114);
  a073=(a073*a113);
  a270=(a124*a098);
  a073=(a073-a270);
  a270=(a073/a118);
  a064=(a136*a114);
  a064=(a064*a116);
  a098=(a128*a098);
  a064=(a064+a098);
  a073=(a129*a073);
  a064=(a064-a073);
  a064=(a064/a127);
  a073=(a129*a064);
  a270=(a270-a073);
  a073=(a124*a270);
  a025=(a025-a073);
  a073=(a128*a064);
  a025=(a025+a073);
  a073=(a104*a017);
  a028=(a051*a028);
  a073=(a073+a028);
  a028=(a084*a061);
  a073=(a073+a028);
  a073=(a009+a073);
  a028=(a025*a073);
  a113=(a021*a113);
  a109=(a109-a114);
  a113=(a113*a109);
  a121=(a113/a121);
  a109=(a124*a113);
  a109=(a015+a109);
  a118=(a109/a118);
  a113=(a128*a113);
  a109=(a129*a109);
  a113=(a113+a109);
  a113=(a113/a127);
  a129=(a129*a113);
  a118=(a118+a129);
  a124=(a124*a118);
  a121=(a121+a124);
  a128=(a128*a113);
  a121=(a121+a128);
  a128=(a104*a069);
  a102=(a051*a102);
  a128=(a128+a102);
  a102=(a008*a097);
  a124=(a095*a037);
  a102=(a102+a124);
  a124=(a070*a050);
  a102=(a102+a124);
  a124=(a112*a010);
  a129=(a096*a106);
  a124=(a124-a129);
  a102=(a102+a124);
  a124=(a084*a102);
  a128=(a128+a124);
  a128=(a038+a128);
  a124=(a121*a128);
  a028=(a028+a124);
  a120=(a120+a028);
  a028=(a101*a120);
  a250=(a250+a028);
  a250=(a009+a250);
  a028=(a005*a250);
  a288=(a288+a028);
  a028=(a126*a017);
  a124=(a132*a061);
  a028=(a028+a124);
  a124=(a133*a120);
  a028=(a028+a124);
  a124=(a140*a142);
  a129=(a141*a138);
  a124=(a124+a129);
  a129=(a140-a124);
  a129=(a007*a129);
  a127=(a007*a138);
  a139=(a135*a139);
  a127=(a127*a139);
  a127=(a127-a144);
  a127=(a127+a145);
  a145=(a153*a127);
  a145=(a145-a155);
  a155=(a149*a127);
  a150=(a150-a155);
  a155=(a154*a150);
  a145=(a145-a155);
  a145=(a145/a152);
  a155=(a145*a036);
  a155=(a155*a141);
  a129=(a129-a155);
  a129=(a129+a140);
  a155=(a129/a146);
  a144=(a007*a124);
  a109=(a149*a129);
  a144=(a144-a109);
  a109=(a144/a143);
  a129=(a153*a129);
  a127=(a127/a146);
  a150=(a150/a143);
  a114=(a154*a145);
  a150=(a150-a114);
  a114=(a149*a150);
  a127=(a127-a114);
  a145=(a153*a145);
  a127=(a127+a145);
  a145=(a127*a141);
  a140=(a140*a024);
  a140=(a140*a024);
  a145=(a145+a140);
  a145=(a036*a145);
  a129=(a129-a145);
  a144=(a154*a144);
  a129=(a129-a144);
  a129=(a129/a152);
  a144=(a154*a129);
  a109=(a109-a144);
  a144=(a149*a109);
  a155=(a155-a144);
  a144=(a153*a129);
  a155=(a155+a144);
  a144=(a006*a009);
  a145=(a030*a010);
  a144=(a144+a145);
  a145=(a101*a073);
  a144=(a144+a145);
  a144=(a072+a144);
  a145=(a155*a144);
  a139=(a142*a139);
  a139=(a124+a139);
  a140=(2.*a127);
  a150=(a150-a140);
  a150=(a138*a150);
  a139=(a139+a150);
  a139=(a007*a139);
  a150=(a139/a146);
  a127=(a127*a138);
  a127=(a127-a124);
  a142=(a142*a024);
  a142=(a142*a024);
  a127=(a127+a142);
  a127=(a007*a127);
  a127=(a127-a031);
  a142=(a149*a139);
  a127=(a127-a142);
  a142=(a127/a143);
  a139=(a153*a139);
  a127=(a154*a127);
  a139=(a139-a127);
  a139=(a139/a152);
  a127=(a154*a139);
  a142=(a142-a127);
  a127=(a149*a142);
  a150=(a150-a127);
  a127=(a153*a139);
  a150=(a150+a127);
  a127=(a006*a038);
  a124=(a030*a106);
  a127=(a127+a124);
  a124=(a101*a128);
  a127=(a127+a124);
  a127=(a219+a127);
  a124=(a150*a127);
  a145=(a145+a124);
  a124=(a041/a152);
  a140=(a154*a124);
  a114=(a149*a140);
  a098=(a153*a124);
  a114=(a114+a098);
  a098=(a006*a137);
  a116=(a030*a057);
  a098=(a098+a116);
  a116=(a104*a054);
  a076=(a051*a076);
  a116=(a116+a076);
  a097=(a039*a097);
  a037=(a092*a037);
  a097=(a097+a037);
  a050=(a111*a050);
  a097=(a097-a050);
  a050=(a298*a010);
  a037=(a090*a106);
  a050=(a050+a037);
  a097=(a097+a050);
  a050=(a084*a097);
  a116=(a116+a050);
  a116=(a137+a116);
  a050=(a101*a116);
  a098=(a098+a050);
  a098=(a162+a098);
  a050=(a114*a098);
  a145=(a145-a050);
  a050=(a035*a135);
  a050=(a050*a138);
  a037=(a050/a146);
  a076=(a021*a024);
  a076=(a076*a138);
  a087=(a149*a050);
  a076=(a076-a087);
  a087=(a076/a143);
  a085=(a136*a024);
  a085=(a085*a141);
  a050=(a153*a050);
  a085=(a085+a050);
  a076=(a154*a076);
  a085=(a085-a076);
  a085=(a085/a152);
  a076=(a154*a085);
  a087=(a087-a076);
  a076=(a149*a087);
  a037=(a037-a076);
  a076=(a153*a085);
  a037=(a037+a076);
  a076=(a037*a250);
  a138=(a021*a138);
  a135=(a135-a024);
  a138=(a138*a135);
  a146=(a138/a146);
  a135=(a149*a138);
  a135=(a015+a135);
  a143=(a135/a143);
  a138=(a153*a138);
  a135=(a154*a135);
  a138=(a138+a135);
  a138=(a138/a152);
  a154=(a154*a138);
  a143=(a143+a154);
  a149=(a149*a143);
  a146=(a146+a149);
  a153=(a153*a138);
  a146=(a146+a153);
  a153=(a006*a069);
  a149=(a030*a102);
  a153=(a153+a149);
  a149=(a044*a119);
  a154=(a117*a105);
  a149=(a149+a154);
  a154=(a115*a086);
  a149=(a149+a154);
  a154=(a270*a073);
  a152=(a118*a128);
  a154=(a154-a152);
  a149=(a149+a154);
  a154=(a101*a149);
  a153=(a153+a154);
  a153=(a038+a153);
  a154=(a146*a153);
  a076=(a076+a154);
  a145=(a145+a076);
  a076=(a134*a145);
  a028=(a028+a076);
  a028=(a009+a028);
  a076=(a123*a028);
  a288=(a288+a076);
  a076=(a151*a017);
  a154=(a088*a061);
  a076=(a076+a154);
  a154=(a158*a120);
  a076=(a076+a154);
  a154=(a159*a145);
  a076=(a076+a154);
  a154=(a166*a168);
  a152=(a167*a164);
  a154=(a154+a152);
  a152=(a166-a154);
  a152=(a007*a152);
  a135=(a007*a164);
  a165=(a161*a165);
  a135=(a135*a165);
  a135=(a135-a170);
  a135=(a135+a171);
  a171=(a179*a135);
  a171=(a171-a181);
  a181=(a175*a135);
  a176=(a176-a181);
  a181=(a180*a176);
  a171=(a171-a181);
  a171=(a171/a178);
  a181=(a171*a036);
  a181=(a181*a167);
  a152=(a152-a181);
  a152=(a152+a166);
  a181=(a152/a172);
  a170=(a007*a154);
  a024=(a175*a152);
  a170=(a170-a024);
  a024=(a170/a169);
  a152=(a179*a152);
  a135=(a135/a172);
  a176=(a176/a169);
  a050=(a180*a171);
  a176=(a176-a050);
  a050=(a175*a176);
  a135=(a135-a050);
  a171=(a179*a171);
  a135=(a135+a171);
  a171=(a135*a167);
  a166=(a166*a131);
  a166=(a166*a131);
  a171=(a171+a166);
  a171=(a036*a171);
  a152=(a152-a171);
  a170=(a180*a170);
  a152=(a152-a170);
  a152=(a152/a178);
  a170=(a180*a152);
  a024=(a024-a170);
  a170=(a175*a024);
  a181=(a181-a170);
  a170=(a179*a152);
  a181=(a181+a170);
  a170=(a126*a009);
  a171=(a132*a010);
  a170=(a170+a171);
  a171=(a133*a073);
  a170=(a170+a171);
  a171=(a134*a250);
  a170=(a170+a171);
  a170=(a072+a170);
  a171=(a181*a170);
  a165=(a168*a165);
  a165=(a154+a165);
  a166=(2.*a135);
  a176=(a176-a166);
  a176=(a164*a176);
  a165=(a165+a176);
  a165=(a007*a165);
  a176=(a165/a172);
  a135=(a135*a164);
  a135=(a135-a154);
  a168=(a168*a131);
  a168=(a168*a131);
  a135=(a135+a168);
  a135=(a007*a135);
  a135=(a135-a031);
  a168=(a175*a165);
  a135=(a135-a168);
  a168=(a135/a169);
  a165=(a179*a165);
  a135=(a180*a135);
  a165=(a165-a135);
  a165=(a165/a178);
  a135=(a180*a165);
  a168=(a168-a135);
  a135=(a175*a168);
  a176=(a176-a135);
  a135=(a179*a165);
  a176=(a176+a135);
  a135=(a126*a038);
  a154=(a132*a106);
  a135=(a135+a154);
  a154=(a133*a128);
  a135=(a135+a154);
  a154=(a134*a153);
  a135=(a135+a154);
  a135=(a219+a135);
  a154=(a176*a135);
  a171=(a171+a154);
  a154=(a041/a178);
  a166=(a180*a154);
  a050=(a175*a166);
  a141=(a179*a154);
  a050=(a050+a141);
  a141=(a126*a137);
  a077=(a132*a057);
  a141=(a141+a077);
  a077=(a133*a116);
  a141=(a141+a077);
  a077=(a006*a054);
  a047=(a030*a097);
  a077=(a077+a047);
  a119=(a107*a119);
  a105=(a079*a105);
  a119=(a119+a105);
  a086=(a157*a086);
  a119=(a119-a086);
  a086=(a064*a073);
  a105=(a113*a128);
  a086=(a086+a105);
  a119=(a119+a086);
  a086=(a101*a119);
  a077=(a077+a086);
  a077=(a137+a077);
  a086=(a134*a077);
  a141=(a141+a086);
  a141=(a162+a141);
  a086=(a050*a141);
  a171=(a171-a086);
  a086=(a035*a161);
  a086=(a086*a164);
  a105=(a086/a172);
  a047=(a021*a131);
  a047=(a047*a164);
  a211=(a175*a086);
  a047=(a047-a211);
  a211=(a047/a169);
  a074=(a136*a131);
  a074=(a074*a167);
  a086=(a179*a086);
  a074=(a074+a086);
  a047=(a180*a047);
  a074=(a074-a047);
  a074=(a074/a178);
  a047=(a180*a074);
  a211=(a211-a047);
  a047=(a175*a211);
  a105=(a105-a047);
  a047=(a179*a074);
  a105=(a105+a047);
  a047=(a105*a028);
  a164=(a021*a164);
  a161=(a161-a131);
  a164=(a164*a161);
  a172=(a164/a172);
  a161=(a175*a164);
  a161=(a015+a161);
  a169=(a161/a169);
  a164=(a179*a164);
  a161=(a180*a161);
  a164=(a164+a161);
  a164=(a164/a178);
  a180=(a180*a164);
  a169=(a169+a180);
  a175=(a175*a169);
  a172=(a172+a175);
  a179=(a179*a164);
  a172=(a172+a179);
  a179=(a126*a069);
  a175=(a132*a102);
  a179=(a179+a175);
  a175=(a133*a149);
  a179=(a179+a175);
  a175=(a109*a144);
  a180=(a142*a127);
  a175=(a175+a180);
  a180=(a140*a098);
  a175=(a175+a180);
  a180=(a087*a250);
  a178=(a143*a153);
  a180=(a180-a178);
  a175=(a175+a180);
  a180=(a134*a175);
  a179=(a179+a180);
  a179=(a038+a179);
  a180=(a172*a179);
  a047=(a047+a180);
  a171=(a171+a047);
  a047=(a160*a171);
  a076=(a076+a047);
  a076=(a009+a076);
  a047=(a148*a076);
  a288=(a288+a047);
  a047=(a177*a017);
  a180=(a184*a061);
  a047=(a047+a180);
  a180=(a185*a120);
  a047=(a047+a180);
  a180=(a186*a145);
  a047=(a047+a180);
  a180=(a187*a171);
  a047=(a047+a180);
  a180=(a194*a196);
  a178=(a195*a192);
  a180=(a180+a178);
  a178=(a194-a180);
  a178=(a007*a178);
  a161=(a007*a192);
  a193=(a189*a193);
  a161=(a161*a193);
  a161=(a161-a198);
  a161=(a161+a199);
  a199=(a207*a161);
  a199=(a199-a209);
  a209=(a203*a161);
  a204=(a204-a209);
  a209=(a208*a204);
  a199=(a199-a209);
  a199=(a199/a206);
  a209=(a199*a036);
  a209=(a209*a195);
  a178=(a178-a209);
  a178=(a178+a194);
  a209=(a178/a200);
  a198=(a007*a180);
  a131=(a203*a178);
  a198=(a198-a131);
  a131=(a198/a197);
  a178=(a207*a178);
  a161=(a161/a200);
  a204=(a204/a197);
  a086=(a208*a199);
  a204=(a204-a086);
  a086=(a203*a204);
  a161=(a161-a086);
  a199=(a207*a199);
  a161=(a161+a199);
  a199=(a161*a195);
  a194=(a194*a156);
  a194=(a194*a156);
  a199=(a199+a194);
  a199=(a036*a199);
  a178=(a178-a199);
  a198=(a208*a198);
  a178=(a178-a198);
  a178=(a178/a206);
  a198=(a208*a178);
  a131=(a131-a198);
  a198=(a203*a131);
  a209=(a209-a198);
  a198=(a207*a178);
  a209=(a209+a198);
  a198=(a151*a009);
  a199=(a088*a010);
  a198=(a198+a199);
  a199=(a158*a073);
  a198=(a198+a199);
  a199=(a159*a250);
  a198=(a198+a199);
  a199=(a160*a028);
  a198=(a198+a199);
  a198=(a072+a198);
  a199=(a209*a198);
  a193=(a196*a193);
  a193=(a180+a193);
  a194=(2.*a161);
  a204=(a204-a194);
  a204=(a192*a204);
  a193=(a193+a204);
  a193=(a007*a193);
  a204=(a193/a200);
  a161=(a161*a192);
  a161=(a161-a180);
  a196=(a196*a156);
  a196=(a196*a156);
  a161=(a161+a196);
  a161=(a007*a161);
  a161=(a161-a031);
  a196=(a203*a193);
  a161=(a161-a196);
  a196=(a161/a197);
  a193=(a207*a193);
  a161=(a208*a161);
  a193=(a193-a161);
  a193=(a193/a206);
  a161=(a208*a193);
  a196=(a196-a161);
  a161=(a203*a196);
  a204=(a204-a161);
  a161=(a207*a193);
  a204=(a204+a161);
  a161=(a151*a038);
  a180=(a088*a106);
  a161=(a161+a180);
  a180=(a158*a128);
  a161=(a161+a180);
  a180=(a159*a153);
  a161=(a161+a180);
  a180=(a160*a179);
  a161=(a161+a180);
  a161=(a219+a161);
  a180=(a204*a161);
  a199=(a199+a180);
  a180=(a041/a206);
  a194=(a208*a180);
  a086=(a203*a194);
  a167=(a207*a180);
  a086=(a086+a167);
  a167=(a151*a137);
  a299=(a088*a057);
  a167=(a167+a299);
  a299=(a158*a116);
  a167=(a167+a299);
  a299=(a159*a077);
  a167=(a167+a299);
  a299=(a126*a054);
  a301=(a132*a097);
  a299=(a299+a301);
  a301=(a133*a119);
  a299=(a299+a301);
  a144=(a129*a144);
  a127=(a139*a127);
  a144=(a144+a127);
  a098=(a124*a098);
  a144=(a144-a098);
  a098=(a085*a250);
  a127=(a138*a153);
  a098=(a098+a127);
  a144=(a144+a098);
  a098=(a134*a144);
  a299=(a299+a098);
  a299=(a137+a299);
  a098=(a160*a299);
  a167=(a167+a098);
  a167=(a162+a167);
  a098=(a086*a167);
  a199=(a199-a098);
  a098=(a035*a189);
  a098=(a098*a192);
  a127=(a098/a200);
  a301=(a021*a156);
  a301=(a301*a192);
  a302=(a203*a098);
  a301=(a301-a302);
  a302=(a301/a197);
  a303=(a136*a156);
  a303=(a303*a195);
  a098=(a207*a098);
  a303=(a303+a098);
  a301=(a208*a301);
  a303=(a303-a301);
  a303=(a303/a206);
  a301=(a208*a303);
  a302=(a302-a301);
  a301=(a203*a302);
  a127=(a127-a301);
  a301=(a207*a303);
  a127=(a127+a301);
  a301=(a127*a076);
  a192=(a021*a192);
  a189=(a189-a156);
  a192=(a192*a189);
  a200=(a192/a200);
  a189=(a203*a192);
  a189=(a015+a189);
  a197=(a189/a197);
  a192=(a207*a192);
  a189=(a208*a189);
  a192=(a192+a189);
  a192=(a192/a206);
  a208=(a208*a192);
  a197=(a197+a208);
  a203=(a203*a197);
  a200=(a200+a203);
  a207=(a207*a192);
  a200=(a200+a207);
  a207=(a151*a069);
  a203=(a088*a102);
  a207=(a207+a203);
  a203=(a158*a149);
  a207=(a207+a203);
  a203=(a159*a175);
  a207=(a207+a203);
  a203=(a024*a170);
  a208=(a168*a135);
  a203=(a203+a208);
  a208=(a166*a141);
  a203=(a203+a208);
  a208=(a211*a028);
  a206=(a169*a179);
  a208=(a208-a206);
  a203=(a203+a208);
  a208=(a160*a203);
  a207=(a207+a208);
  a207=(a038+a207);
  a208=(a200*a207);
  a301=(a301+a208);
  a199=(a199+a301);
  a301=(a188*a199);
  a047=(a047+a301);
  a047=(a009+a047);
  a301=(a174*a047);
  a288=(a288+a301);
  a301=(a205*a017);
  a208=(a212*a061);
  a301=(a301+a208);
  a208=(a213*a120);
  a301=(a301+a208);
  a208=(a214*a145);
  a301=(a301+a208);
  a208=(a215*a171);
  a301=(a301+a208);
  a208=(a216*a199);
  a301=(a301+a208);
  a208=(a223*a225);
  a206=(a224*a221);
  a208=(a208+a206);
  a206=(a223-a208);
  a206=(a007*a206);
  a189=(a007*a221);
  a222=(a218*a222);
  a189=(a189*a222);
  a189=(a189-a227);
  a189=(a189+a228);
  a228=(a236*a189);
  a228=(a228-a238);
  a238=(a232*a189);
  a233=(a233-a238);
  a238=(a237*a233);
  a228=(a228-a238);
  a228=(a228/a235);
  a238=(a228*a036);
  a238=(a238*a224);
  a206=(a206-a238);
  a206=(a206+a223);
  a238=(a206/a229);
  a227=(a007*a208);
  a156=(a232*a206);
  a227=(a227-a156);
  a156=(a227/a226);
  a206=(a236*a206);
  a189=(a189/a229);
  a233=(a233/a226);
  a098=(a237*a228);
  a233=(a233-a098);
  a098=(a232*a233);
  a189=(a189-a098);
  a228=(a236*a228);
  a189=(a189+a228);
  a228=(a189*a224);
  a223=(a223*a182);
  a223=(a223*a182);
  a228=(a228+a223);
  a228=(a036*a228);
  a206=(a206-a228);
  a227=(a237*a227);
  a206=(a206-a227);
  a206=(a206/a235);
  a227=(a237*a206);
  a156=(a156-a227);
  a227=(a232*a156);
  a238=(a238-a227);
  a227=(a236*a206);
  a238=(a238+a227);
  a227=(a177*a009);
  a228=(a184*a010);
  a227=(a227+a228);
  a228=(a185*a073);
  a227=(a227+a228);
  a228=(a186*a250);
  a227=(a227+a228);
  a228=(a187*a028);
  a227=(a227+a228);
  a228=(a188*a076);
  a227=(a227+a228);
  a227=(a072+a227);
  a228=(a238*a227);
  a222=(a225*a222);
  a222=(a208+a222);
  a223=(2.*a189);
  a233=(a233-a223);
  a233=(a221*a233);
  a222=(a222+a233);
  a222=(a007*a222);
  a233=(a222/a229);
  a189=(a189*a221);
  a189=(a189-a208);
  a225=(a225*a182);
  a225=(a225*a182);
  a189=(a189+a225);
  a189=(a007*a189);
  a189=(a189-a031);
  a225=(a232*a222);
  a189=(a189-a225);
  a225=(a189/a226);
  a222=(a236*a222);
  a189=(a237*a189);
  a222=(a222-a189);
  a222=(a222/a235);
  a189=(a237*a222);
  a225=(a225-a189);
  a189=(a232*a225);
  a233=(a233-a189);
  a189=(a236*a222);
  a233=(a233+a189);
  a189=(a177*a038);
  a208=(a184*a106);
  a189=(a189+a208);
  a208=(a185*a128);
  a189=(a189+a208);
  a208=(a186*a153);
  a189=(a189+a208);
  a208=(a187*a179);
  a189=(a189+a208);
  a208=(a188*a207);
  a189=(a189+a208);
  a189=(a219+a189);
  a208=(a233*a189);
  a228=(a228+a208);
  a208=(a041/a235);
  a223=(a237*a208);
  a098=(a232*a223);
  a195=(a236*a208);
  a098=(a098+a195);
  a195=(a177*a137);
  a304=(a184*a057);
  a195=(a195+a304);
  a304=(a185*a116);
  a195=(a195+a304);
  a304=(a186*a077);
  a195=(a195+a304);
  a304=(a187*a299);
  a195=(a195+a304);
  a304=(a151*a054);
  a305=(a088*a097);
  a304=(a304+a305);
  a305=(a158*a119);
  a304=(a304+a305);
  a305=(a159*a144);
  a304=(a304+a305);
  a170=(a152*a170);
  a135=(a165*a135);
  a170=(a170+a135);
  a141=(a154*a141);
  a170=(a170-a141);
  a141=(a074*a028);
  a135=(a164*a179);
  a141=(a141+a135);
  a170=(a170+a141);
  a141=(a160*a170);
  a304=(a304+a141);
  a304=(a137+a304);
  a141=(a188*a304);
  a195=(a195+a141);
  a195=(a162+a195);
  a141=(a098*a195);
  a228=(a228-a141);
  a141=(a035*a218);
  a141=(a141*a221);
  a135=(a141/a229);
  a305=(a021*a182);
  a305=(a305*a221);
  a306=(a232*a141);
  a305=(a305-a306);
  a306=(a305/a226);
  a307=(a136*a182);
  a307=(a307*a224);
  a141=(a236*a141);
  a307=(a307+a141);
  a305=(a237*a305);
  a307=(a307-a305);
  a307=(a307/a235);
  a305=(a237*a307);
  a306=(a306-a305);
  a305=(a232*a306);
  a135=(a135-a305);
  a305=(a236*a307);
  a135=(a135+a305);
  a305=(a135*a047);
  a221=(a021*a221);
  a218=(a218-a182);
  a221=(a221*a218);
  a229=(a221/a229);
  a218=(a232*a221);
  a218=(a015+a218);
  a226=(a218/a226);
  a221=(a236*a221);
  a218=(a237*a218);
  a221=(a221+a218);
  a221=(a221/a235);
  a237=(a237*a221);
  a226=(a226+a237);
  a232=(a232*a226);
  a229=(a229+a232);
  a236=(a236*a221);
  a229=(a229+a236);
  a236=(a177*a069);
  a232=(a184*a102);
  a236=(a236+a232);
  a232=(a185*a149);
  a236=(a236+a232);
  a232=(a186*a175);
  a236=(a236+a232);
  a232=(a187*a203);
  a236=(a236+a232);
  a232=(a131*a198);
  a237=(a196*a161);
  a232=(a232+a237);
  a237=(a194*a167);
  a232=(a232+a237);
  a237=(a302*a076);
  a235=(a197*a207);
  a237=(a237-a235);
  a232=(a232+a237);
  a237=(a188*a232);
  a236=(a236+a237);
  a236=(a038+a236);
  a237=(a229*a236);
  a305=(a305+a237);
  a228=(a228+a305);
  a305=(a217*a228);
  a301=(a301+a305);
  a301=(a009+a301);
  a305=(a202*a301);
  a288=(a288+a305);
  a305=(a234*a017);
  a237=(a241*a061);
  a305=(a305+a237);
  a237=(a242*a120);
  a305=(a305+a237);
  a237=(a243*a145);
  a305=(a305+a237);
  a237=(a244*a171);
  a305=(a305+a237);
  a237=(a245*a199);
  a305=(a305+a237);
  a237=(a246*a228);
  a305=(a305+a237);
  a237=(a253*a255);
  a235=(a254*a251);
  a237=(a237+a235);
  a235=(a253-a237);
  a235=(a007*a235);
  a218=(a007*a251);
  a252=(a248*a252);
  a218=(a218*a252);
  a218=(a218-a257);
  a218=(a218+a258);
  a258=(a266*a218);
  a258=(a258-a268);
  a268=(a262*a218);
  a263=(a263-a268);
  a268=(a267*a263);
  a258=(a258-a268);
  a258=(a258/a265);
  a268=(a258*a036);
  a268=(a268*a254);
  a235=(a235-a268);
  a235=(a235+a253);
  a268=(a235/a259);
  a257=(a007*a237);
  a182=(a262*a235);
  a257=(a257-a182);
  a182=(a257/a256);
  a235=(a266*a235);
  a218=(a218/a259);
  a263=(a263/a256);
  a141=(a267*a258);
  a263=(a263-a141);
  a141=(a262*a263);
  a218=(a218-a141);
  a258=(a266*a258);
  a218=(a218+a258);
  a258=(a218*a254);
  a253=(a253*a210);
  a253=(a253*a210);
  a258=(a258+a253);
  a258=(a036*a258);
  a235=(a235-a258);
  a257=(a267*a257);
  a235=(a235-a257);
  a235=(a235/a265);
  a257=(a267*a235);
  a182=(a182-a257);
  a257=(a262*a182);
  a268=(a268-a257);
  a257=(a266*a235);
  a268=(a268+a257);
  a257=(a205*a009);
  a258=(a212*a010);
  a257=(a257+a258);
  a258=(a213*a073);
  a257=(a257+a258);
  a258=(a214*a250);
  a257=(a257+a258);
  a258=(a215*a028);
  a257=(a257+a258);
  a258=(a216*a076);
  a257=(a257+a258);
  a258=(a217*a047);
  a257=(a257+a258);
  a257=(a072+a257);
  a258=(a268*a257);
  a252=(a255*a252);
  a252=(a237+a252);
  a253=(2.*a218);
  a263=(a263-a253);
  a263=(a251*a263);
  a252=(a252+a263);
  a252=(a007*a252);
  a263=(a252/a259);
  a218=(a218*a251);
  a218=(a218-a237);
  a255=(a255*a210);
  a255=(a255*a210);
  a218=(a218+a255);
  a218=(a007*a218);
  a218=(a218-a031);
  a255=(a262*a252);
  a218=(a218-a255);
  a255=(a218/a256);
  a252=(a266*a252);
  a218=(a267*a218);
  a252=(a252-a218);
  a252=(a252/a265);
  a218=(a267*a252);
  a255=(a255-a218);
  a218=(a262*a255);
  a263=(a263-a218);
  a218=(a266*a252);
  a263=(a263+a218);
  a218=(a205*a038);
  a237=(a212*a106);
  a218=(a218+a237);
  a237=(a213*a128);
  a218=(a218+a237);
  a237=(a214*a153);
  a218=(a218+a237);
  a237=(a215*a179);
  a218=(a218+a237);
  a237=(a216*a207);
  a218=(a218+a237);
  a237=(a217*a236);
  a218=(a218+a237);
  a218=(a219+a218);
  a237=(a263*a218);
  a258=(a258+a237);
  a237=(a041/a265);
  a253=(a267*a237);
  a141=(a262*a253);
  a224=(a266*a237);
  a141=(a141+a224);
  a224=(a205*a137);
  a308=(a212*a057);
  a224=(a224+a308);
  a308=(a213*a116);
  a224=(a224+a308);
  a308=(a214*a077);
  a224=(a224+a308);
  a308=(a215*a299);
  a224=(a224+a308);
  a308=(a216*a304);
  a224=(a224+a308);
  a308=(a177*a054);
  a309=(a184*a097);
  a308=(a308+a309);
  a309=(a185*a119);
  a308=(a308+a309);
  a309=(a186*a144);
  a308=(a308+a309);
  a309=(a187*a170);
  a308=(a308+a309);
  a198=(a178*a198);
  a161=(a193*a161);
  a198=(a198+a161);
  a167=(a180*a167);
  a198=(a198-a167);
  a167=(a303*a076);
  a161=(a192*a207);
  a167=(a167+a161);
  a198=(a198+a167);
  a167=(a188*a198);
  a308=(a308+a167);
  a308=(a137+a308);
  a167=(a217*a308);
  a224=(a224+a167);
  a224=(a162+a224);
  a167=(a141*a224);
  a258=(a258-a167);
  a167=(a035*a248);
  a167=(a167*a251);
  a161=(a167/a259);
  a309=(a021*a210);
  a309=(a309*a251);
  a310=(a262*a167);
  a309=(a309-a310);
  a310=(a309/a256);
  a311=(a136*a210);
  a311=(a311*a254);
  a167=(a266*a167);
  a311=(a311+a167);
  a309=(a267*a309);
  a311=(a311-a309);
  a311=(a311/a265);
  a309=(a267*a311);
  a310=(a310-a309);
  a309=(a262*a310);
  a161=(a161-a309);
  a309=(a266*a311);
  a161=(a161+a309);
  a309=(a161*a301);
  a251=(a021*a251);
  a248=(a248-a210);
  a251=(a251*a248);
  a259=(a251/a259);
  a248=(a262*a251);
  a248=(a015+a248);
  a256=(a248/a256);
  a251=(a266*a251);
  a248=(a267*a248);
  a251=(a251+a248);
  a251=(a251/a265);
  a267=(a267*a251);
  a256=(a256+a267);
  a262=(a262*a256);
  a259=(a259+a262);
  a266=(a266*a251);
  a259=(a259+a266);
  a266=(a205*a069);
  a262=(a212*a102);
  a266=(a266+a262);
  a262=(a213*a149);
  a266=(a266+a262);
  a262=(a214*a175);
  a266=(a266+a262);
  a262=(a215*a203);
  a266=(a266+a262);
  a262=(a216*a232);
  a266=(a266+a262);
  a262=(a156*a227);
  a267=(a225*a189);
  a262=(a262+a267);
  a267=(a223*a195);
  a262=(a262+a267);
  a267=(a306*a047);
  a265=(a226*a236);
  a267=(a267-a265);
  a262=(a262+a267);
  a267=(a217*a262);
  a266=(a266+a267);
  a266=(a038+a266);
  a267=(a259*a266);
  a309=(a309+a267);
  a258=(a258+a309);
  a309=(a247*a258);
  a305=(a305+a309);
  a305=(a009+a305);
  a309=(a231*a305);
  a288=(a288+a309);
  a309=(a264*a017);
  a061=(a271*a061);
  a309=(a309+a061);
  a120=(a100*a120);
  a309=(a309+a120);
  a120=(a122*a145);
  a309=(a309+a120);
  a120=(a272*a171);
  a309=(a309+a120);
  a120=(a273*a199);
  a309=(a309+a120);
  a120=(a274*a228);
  a309=(a309+a120);
  a120=(a275*a258);
  a309=(a309+a120);
  a120=(a281*a283);
  a061=(a282*a279);
  a120=(a120+a061);
  a061=(a281-a120);
  a061=(a007*a061);
  a267=(a007*a279);
  a280=(a002*a280);
  a267=(a267*a280);
  a267=(a267-a285);
  a267=(a267+a286);
  a286=(a294*a267);
  a286=(a286-a296);
  a296=(a290*a267);
  a291=(a291-a296);
  a296=(a295*a291);
  a286=(a286-a296);
  a286=(a286/a293);
  a296=(a286*a036);
  a296=(a296*a282);
  a061=(a061-a296);
  a061=(a061+a281);
  a296=(a061/a287);
  a285=(a007*a120);
  a265=(a290*a061);
  a285=(a285-a265);
  a265=(a285/a284);
  a061=(a294*a061);
  a267=(a267/a287);
  a291=(a291/a284);
  a248=(a295*a286);
  a291=(a291-a248);
  a248=(a290*a291);
  a267=(a267-a248);
  a286=(a294*a286);
  a267=(a267+a286);
  a286=(a267*a282);
  a281=(a281*a239);
  a281=(a281*a239);
  a286=(a286+a281);
  a286=(a036*a286);
  a061=(a061-a286);
  a285=(a295*a285);
  a061=(a061-a285);
  a061=(a061/a293);
  a285=(a295*a061);
  a265=(a265-a285);
  a285=(a290*a265);
  a296=(a296-a285);
  a285=(a294*a061);
  a296=(a296+a285);
  a285=(a234*a009);
  a286=(a241*a010);
  a285=(a285+a286);
  a286=(a242*a073);
  a285=(a285+a286);
  a286=(a243*a250);
  a285=(a285+a286);
  a286=(a244*a028);
  a285=(a285+a286);
  a286=(a245*a076);
  a285=(a285+a286);
  a286=(a246*a047);
  a285=(a285+a286);
  a286=(a247*a301);
  a285=(a285+a286);
  a285=(a072+a285);
  a286=(a296*a285);
  a280=(a283*a280);
  a280=(a120+a280);
  a281=(2.*a267);
  a291=(a291-a281);
  a291=(a279*a291);
  a280=(a280+a291);
  a280=(a007*a280);
  a291=(a280/a287);
  a267=(a267*a279);
  a267=(a267-a120);
  a283=(a283*a239);
  a283=(a283*a239);
  a267=(a267+a283);
  a267=(a007*a267);
  a267=(a267-a031);
  a283=(a290*a280);
  a267=(a267-a283);
  a283=(a267/a284);
  a280=(a294*a280);
  a267=(a295*a267);
  a280=(a280-a267);
  a280=(a280/a293);
  a267=(a295*a280);
  a283=(a283-a267);
  a267=(a290*a283);
  a291=(a291-a267);
  a267=(a294*a280);
  a291=(a291+a267);
  a267=(a234*a038);
  a120=(a241*a106);
  a267=(a267+a120);
  a120=(a242*a128);
  a267=(a267+a120);
  a120=(a243*a153);
  a267=(a267+a120);
  a120=(a244*a179);
  a267=(a267+a120);
  a120=(a245*a207);
  a267=(a267+a120);
  a120=(a246*a236);
  a267=(a267+a120);
  a120=(a247*a266);
  a267=(a267+a120);
  a267=(a219+a267);
  a120=(a291*a267);
  a286=(a286+a120);
  a120=(a041/a293);
  a281=(a295*a120);
  a248=(a290*a281);
  a210=(a294*a120);
  a248=(a248+a210);
  a210=(a234*a137);
  a167=(a241*a057);
  a210=(a210+a167);
  a167=(a242*a116);
  a210=(a210+a167);
  a167=(a243*a077);
  a210=(a210+a167);
  a167=(a244*a299);
  a210=(a210+a167);
  a167=(a245*a304);
  a210=(a210+a167);
  a167=(a246*a308);
  a210=(a210+a167);
  a167=(a205*a054);
  a254=(a212*a097);
  a167=(a167+a254);
  a254=(a213*a119);
  a167=(a167+a254);
  a254=(a214*a144);
  a167=(a167+a254);
  a254=(a215*a170);
  a167=(a167+a254);
  a254=(a216*a198);
  a167=(a167+a254);
  a227=(a206*a227);
  a189=(a222*a189);
  a227=(a227+a189);
  a195=(a208*a195);
  a227=(a227-a195);
  a195=(a307*a047);
  a189=(a221*a236);
  a195=(a195+a189);
  a227=(a227+a195);
  a195=(a217*a227);
  a167=(a167+a195);
  a167=(a137+a167);
  a195=(a247*a167);
  a210=(a210+a195);
  a210=(a162+a210);
  a195=(a248*a210);
  a286=(a286-a195);
  a195=(a035*a002);
  a195=(a195*a279);
  a189=(a195/a287);
  a254=(a021*a239);
  a254=(a254*a279);
  a312=(a290*a195);
  a254=(a254-a312);
  a312=(a254/a284);
  a313=(a136*a239);
  a313=(a313*a282);
  a195=(a294*a195);
  a313=(a313+a195);
  a254=(a295*a254);
  a313=(a313-a254);
  a313=(a313/a293);
  a254=(a295*a313);
  a312=(a312-a254);
  a254=(a290*a312);
  a189=(a189-a254);
  a254=(a294*a313);
  a189=(a189+a254);
  a254=(a189*a305);
  a279=(a021*a279);
  a002=(a002-a239);
  a279=(a279*a002);
  a287=(a279/a287);
  a002=(a290*a279);
  a002=(a015+a002);
  a284=(a002/a284);
  a279=(a294*a279);
  a002=(a295*a002);
  a279=(a279+a002);
  a279=(a279/a293);
  a295=(a295*a279);
  a284=(a284+a295);
  a290=(a290*a284);
  a287=(a287+a290);
  a294=(a294*a279);
  a287=(a287+a294);
  a294=(a234*a069);
  a290=(a241*a102);
  a294=(a294+a290);
  a290=(a242*a149);
  a294=(a294+a290);
  a290=(a243*a175);
  a294=(a294+a290);
  a290=(a244*a203);
  a294=(a294+a290);
  a290=(a245*a232);
  a294=(a294+a290);
  a290=(a246*a262);
  a294=(a294+a290);
  a290=(a182*a257);
  a295=(a255*a218);
  a290=(a290+a295);
  a295=(a253*a224);
  a290=(a290+a295);
  a295=(a310*a301);
  a293=(a256*a266);
  a295=(a295-a293);
  a290=(a290+a295);
  a295=(a247*a290);
  a294=(a294+a295);
  a294=(a038+a294);
  a295=(a287*a294);
  a254=(a254+a295);
  a286=(a286+a254);
  a254=(a276*a286);
  a309=(a309+a254);
  a309=(a009+a309);
  a254=(a261*a309);
  a288=(a288+a254);
  a288=(a072+a288);
  if (res[0]!=0) res[0][6]=a288;
  a288=(a001*a038);
  a254=(a005*a153);
  a288=(a288+a254);
  a254=(a123*a179);
  a288=(a288+a254);
  a254=(a148*a207);
  a288=(a288+a254);
  a254=(a174*a236);
  a288=(a288+a254);
  a254=(a202*a266);
  a288=(a288+a254);
  a254=(a231*a294);
  a288=(a288+a254);
  a254=(a264*a069);
  a102=(a271*a102);
  a254=(a254+a102);
  a149=(a100*a149);
  a254=(a254+a149);
  a149=(a122*a175);
  a254=(a254+a149);
  a149=(a272*a203);
  a254=(a254+a149);
  a149=(a273*a232);
  a254=(a254+a149);
  a149=(a274*a262);
  a254=(a254+a149);
  a149=(a275*a290);
  a254=(a254+a149);
  a149=(a265*a285);
  a102=(a283*a267);
  a149=(a149+a102);
  a102=(a281*a210);
  a149=(a149+a102);
  a102=(a312*a305);
  a295=(a284*a294);
  a102=(a102-a295);
  a149=(a149+a102);
  a102=(a276*a149);
  a254=(a254+a102);
  a254=(a038+a254);
  a102=(a261*a254);
  a288=(a288+a102);
  a288=(a219+a288);
  if (res[0]!=0) res[0][7]=a288;
  a288=(a001*a137);
  a102=(a005*a077);
  a288=(a288+a102);
  a102=(a123*a299);
  a288=(a288+a102);
  a102=(a148*a304);
  a288=(a288+a102);
  a102=(a174*a308);
  a288=(a288+a102);
  a102=(a202*a167);
  a288=(a288+a102);
  a102=(a234*a054);
  a295=(a241*a097);
  a102=(a102+a295);
  a295=(a242*a119);
  a102=(a102+a295);
  a295=(a243*a144);
  a102=(a102+a295);
  a295=(a244*a170);
  a102=(a102+a295);
  a295=(a245*a198);
  a102=(a102+a295);
  a295=(a246*a227);
  a102=(a102+a295);
  a257=(a235*a257);
  a218=(a252*a218);
  a257=(a257+a218);
  a224=(a237*a224);
  a257=(a257-a224);
  a224=(a311*a301);
  a218=(a251*a266);
  a224=(a224+a218);
  a257=(a257+a224);
  a224=(a247*a257);
  a102=(a102+a224);
  a102=(a137+a102);
  a224=(a231*a102);
  a288=(a288+a224);
  a224=(a264*a054);
  a097=(a271*a097);
  a224=(a224+a097);
  a119=(a100*a119);
  a224=(a224+a119);
  a119=(a122*a144);
  a224=(a224+a119);
  a119=(a272*a170);
  a224=(a224+a119);
  a119=(a273*a198);
  a224=(a224+a119);
  a119=(a274*a227);
  a224=(a224+a119);
  a119=(a275*a257);
  a224=(a224+a119);
  a285=(a061*a285);
  a267=(a280*a267);
  a285=(a285+a267);
  a210=(a120*a210);
  a285=(a285-a210);
  a210=(a313*a305);
  a267=(a279*a294);
  a210=(a210+a267);
  a285=(a285+a210);
  a210=(a276*a285);
  a224=(a224+a210);
  a224=(a137+a224);
  a224=(a261*a224);
  a288=(a288+a224);
  a288=(a162+a288);
  if (res[0]!=0) res[0][8]=a288;
  a017=(a001*a017);
  a145=(a005*a145);
  a017=(a017+a145);
  a171=(a123*a171);
  a017=(a017+a171);
  a199=(a148*a199);
  a017=(a017+a199);
  a228=(a174*a228);
  a017=(a017+a228);
  a258=(a202*a258);
  a017=(a017+a258);
  a286=(a231*a286);
  a017=(a017+a286);
  a286=(a000*a173);
  a258=(a201*a260);
  a286=(a286+a258);
  a258=(a000-a286);
  a258=(a007*a258);
  a228=(a007*a260);
  a230=(a289*a230);
  a228=(a228*a230);
  a228=(a228-a004);
  a228=(a228+a019);
  a019=(a033*a228);
  a019=(a019-a029);
  a029=(a292*a228);
  a297=(a297-a029);
  a029=(a018*a297);
  a019=(a019-a029);
  a019=(a019/a027);
  a029=(a019*a036);
  a029=(a029*a201);
  a258=(a258-a029);
  a258=(a258+a000);
  a029=(a258/a082);
  a004=(a007*a286);
  a199=(a292*a258);
  a004=(a004-a199);
  a199=(a004/a032);
  a258=(a033*a258);
  a228=(a228/a082);
  a297=(a297/a032);
  a171=(a018*a019);
  a297=(a297-a171);
  a171=(a292*a297);
  a228=(a228-a171);
  a019=(a033*a019);
  a228=(a228+a019);
  a019=(a228*a201);
  a000=(a000*a269);
  a000=(a000*a269);
  a019=(a019+a000);
  a036=(a036*a019);
  a258=(a258-a036);
  a004=(a018*a004);
  a258=(a258-a004);
  a258=(a258/a027);
  a004=(a018*a258);
  a199=(a199-a004);
  a004=(a292*a199);
  a029=(a029-a004);
  a004=(a033*a258);
  a029=(a029+a004);
  a004=(a264*a009);
  a010=(a271*a010);
  a004=(a004+a010);
  a073=(a100*a073);
  a004=(a004+a073);
  a250=(a122*a250);
  a004=(a004+a250);
  a028=(a272*a028);
  a004=(a004+a028);
  a076=(a273*a076);
  a004=(a004+a076);
  a047=(a274*a047);
  a004=(a004+a047);
  a301=(a275*a301);
  a004=(a004+a301);
  a305=(a276*a305);
  a004=(a004+a305);
  a072=(a072+a004);
  a004=(a029*a072);
  a230=(a173*a230);
  a230=(a286+a230);
  a305=(2.*a228);
  a297=(a297-a305);
  a297=(a260*a297);
  a230=(a230+a297);
  a230=(a007*a230);
  a297=(a230/a082);
  a228=(a228*a260);
  a228=(a228-a286);
  a173=(a173*a269);
  a173=(a173*a269);
  a228=(a228+a173);
  a007=(a007*a228);
  a007=(a007-a031);
  a031=(a292*a230);
  a007=(a007-a031);
  a031=(a007/a032);
  a230=(a033*a230);
  a007=(a018*a007);
  a230=(a230-a007);
  a230=(a230/a027);
  a007=(a018*a230);
  a031=(a031-a007);
  a007=(a292*a031);
  a297=(a297-a007);
  a007=(a033*a230);
  a297=(a297+a007);
  a007=(a264*a038);
  a106=(a271*a106);
  a007=(a007+a106);
  a128=(a100*a128);
  a007=(a007+a128);
  a153=(a122*a153);
  a007=(a007+a153);
  a179=(a272*a179);
  a007=(a007+a179);
  a207=(a273*a207);
  a007=(a007+a207);
  a236=(a274*a236);
  a007=(a007+a236);
  a266=(a275*a266);
  a007=(a007+a266);
  a294=(a276*a294);
  a007=(a007+a294);
  a219=(a219+a007);
  a007=(a297*a219);
  a004=(a004+a007);
  a041=(a041/a027);
  a007=(a018*a041);
  a294=(a292*a007);
  a266=(a033*a041);
  a294=(a294+a266);
  a266=(a264*a137);
  a057=(a271*a057);
  a266=(a266+a057);
  a116=(a100*a116);
  a266=(a266+a116);
  a077=(a122*a077);
  a266=(a266+a077);
  a299=(a272*a299);
  a266=(a266+a299);
  a304=(a273*a304);
  a266=(a266+a304);
  a308=(a274*a308);
  a266=(a266+a308);
  a167=(a275*a167);
  a266=(a266+a167);
  a102=(a276*a102);
  a266=(a266+a102);
  a162=(a162+a266);
  a266=(a294*a162);
  a004=(a004-a266);
  a035=(a035*a289);
  a035=(a035*a260);
  a266=(a035/a082);
  a102=(a021*a269);
  a102=(a102*a260);
  a167=(a292*a035);
  a102=(a102-a167);
  a167=(a102/a032);
  a136=(a136*a269);
  a136=(a136*a201);
  a035=(a033*a035);
  a136=(a136+a035);
  a102=(a018*a102);
  a136=(a136-a102);
  a136=(a136/a027);
  a102=(a018*a136);
  a167=(a167-a102);
  a102=(a292*a167);
  a266=(a266-a102);
  a102=(a033*a136);
  a266=(a266+a102);
  a102=(a266*a309);
  a021=(a021*a260);
  a289=(a289-a269);
  a021=(a021*a289);
  a082=(a021/a082);
  a289=(a292*a021);
  a015=(a015+a289);
  a032=(a015/a032);
  a021=(a033*a021);
  a015=(a018*a015);
  a021=(a021+a015);
  a021=(a021/a027);
  a018=(a018*a021);
  a032=(a032+a018);
  a292=(a292*a032);
  a082=(a082+a292);
  a033=(a033*a021);
  a082=(a082+a033);
  a033=(a082*a254);
  a102=(a102+a033);
  a004=(a004+a102);
  a004=(a261*a004);
  a017=(a017+a004);
  a009=(a009+a017);
  if (res[0]!=0) res[0][9]=a009;
  a069=(a001*a069);
  a175=(a005*a175);
  a069=(a069+a175);
  a203=(a123*a203);
  a069=(a069+a203);
  a232=(a148*a232);
  a069=(a069+a232);
  a262=(a174*a262);
  a069=(a069+a262);
  a290=(a202*a290);
  a069=(a069+a290);
  a149=(a231*a149);
  a069=(a069+a149);
  a149=(a199*a072);
  a290=(a031*a219);
  a149=(a149+a290);
  a290=(a007*a162);
  a149=(a149+a290);
  a290=(a167*a309);
  a262=(a032*a254);
  a290=(a290-a262);
  a149=(a149+a290);
  a149=(a261*a149);
  a069=(a069+a149);
  a038=(a038+a069);
  if (res[0]!=0) res[0][10]=a038;
  a054=(a001*a054);
  a144=(a005*a144);
  a054=(a054+a144);
  a170=(a123*a170);
  a054=(a054+a170);
  a198=(a148*a198);
  a054=(a054+a198);
  a227=(a174*a227);
  a054=(a054+a227);
  a257=(a202*a257);
  a054=(a054+a257);
  a285=(a231*a285);
  a054=(a054+a285);
  a072=(a258*a072);
  a219=(a230*a219);
  a072=(a072+a219);
  a162=(a041*a162);
  a072=(a072-a162);
  a309=(a136*a309);
  a254=(a021*a254);
  a309=(a309+a254);
  a072=(a072+a309);
  a072=(a261*a072);
  a054=(a054+a072);
  a137=(a137+a054);
  if (res[0]!=0) res[0][11]=a137;
  a137=arg[0]? arg[0][12] : 0;
  a054=arg[0]? arg[0][15] : 0;
  a072=(a001*a054);
  a309=(a040*a137);
  a254=arg[0]? arg[0][13] : 0;
  a162=(a026*a254);
  a309=(a309+a162);
  a162=arg[0]? arg[0][14] : 0;
  a219=(a016*a162);
  a309=(a309-a219);
  a219=(a278*a054);
  a285=arg[0]? arg[0][16] : 0;
  a257=(a022*a285);
  a219=(a219+a257);
  a309=(a309+a219);
  a219=(a006*a309);
  a257=(a043*a054);
  a227=(a046*a309);
  a198=(a049*a054);
  a198=(a137+a198);
  a170=(a071*a198);
  a144=(a049*a285);
  a144=(a254+a144);
  a038=(a066*a144);
  a170=(a170+a038);
  a038=arg[0]? arg[0][17] : 0;
  a069=(a049*a038);
  a069=(a162+a069);
  a149=(a163*a069);
  a170=(a170-a149);
  a149=(a049*a309);
  a149=(a054+a149);
  a290=(a078*a149);
  a262=(a190*a137);
  a232=(a014*a254);
  a262=(a262+a232);
  a232=(a020*a162);
  a262=(a262+a232);
  a232=(a220*a054);
  a203=(a034*a285);
  a232=(a232-a203);
  a262=(a262+a232);
  a232=(a049*a262);
  a232=(a285+a232);
  a203=(a062*a232);
  a290=(a290+a203);
  a170=(a170+a290);
  a170=(a048*a170);
  a227=(a227+a170);
  a227=(a054+a227);
  a170=(a045*a227);
  a257=(a257+a170);
  a257=(a137+a257);
  a170=(a108*a257);
  a290=(a043*a285);
  a203=(a046*a262);
  a175=(a013*a198);
  a009=(a058*a144);
  a175=(a175+a009);
  a009=(a056*a069);
  a175=(a175+a009);
  a009=(a042*a149);
  a017=(a059*a232);
  a009=(a009-a017);
  a175=(a175+a009);
  a175=(a048*a175);
  a203=(a203+a175);
  a203=(a285+a203);
  a175=(a045*a203);
  a290=(a290+a175);
  a290=(a254+a290);
  a175=(a103*a290);
  a170=(a170+a175);
  a175=(a043*a038);
  a009=(a249*a137);
  a017=(a012*a254);
  a009=(a009+a017);
  a017=(a277*a162);
  a009=(a009-a017);
  a017=(a191*a054);
  a004=(a011*a285);
  a017=(a017+a004);
  a009=(a009+a017);
  a017=(a046*a009);
  a198=(a003*a198);
  a144=(a055*a144);
  a198=(a198+a144);
  a069=(a093*a069);
  a198=(a198-a069);
  a069=(a300*a149);
  a144=(a053*a232);
  a069=(a069+a144);
  a198=(a198+a069);
  a198=(a048*a198);
  a017=(a017+a198);
  a017=(a038+a017);
  a198=(a045*a017);
  a175=(a175+a198);
  a175=(a162+a175);
  a198=(a068*a175);
  a170=(a170-a198);
  a198=(a043*a309);
  a069=(a046*a054);
  a149=(a048*a149);
  a069=(a069+a149);
  a069=(a137+a069);
  a149=(a089*a069);
  a144=(a046*a285);
  a232=(a048*a232);
  a144=(a144+a232);
  a144=(a254+a144);
  a232=(a063*a144);
  a149=(a149+a232);
  a232=(a046*a038);
  a004=(a049*a009);
  a004=(a038+a004);
  a004=(a048*a004);
  a232=(a232+a004);
  a232=(a162+a232);
  a004=(a081*a232);
  a149=(a149-a004);
  a004=(a183*a227);
  a102=(a052*a203);
  a004=(a004+a102);
  a149=(a149+a004);
  a004=(a045*a149);
  a198=(a198+a004);
  a198=(a054+a198);
  a004=(a023*a198);
  a102=(a043*a262);
  a033=(a240*a069);
  a292=(a075*a144);
  a033=(a033+a292);
  a292=(a060*a232);
  a033=(a033+a292);
  a292=(a110*a227);
  a018=(a083*a203);
  a292=(a292-a018);
  a033=(a033+a292);
  a292=(a045*a033);
  a102=(a102+a292);
  a102=(a285+a102);
  a292=(a099*a102);
  a004=(a004+a292);
  a170=(a170+a004);
  a004=(a030*a170);
  a219=(a219+a004);
  a004=(a104*a054);
  a292=(a051*a227);
  a004=(a004+a292);
  a292=(a084*a198);
  a004=(a004+a292);
  a004=(a137+a004);
  a292=(a130*a004);
  a018=(a104*a285);
  a027=(a051*a203);
  a018=(a018+a027);
  a027=(a084*a102);
  a018=(a018+a027);
  a018=(a254+a018);
  a027=(a125*a018);
  a292=(a292+a027);
  a027=(a104*a038);
  a017=(a051*a017);
  a027=(a027+a017);
  a017=(a043*a009);
  a069=(a094*a069);
  a144=(a080*a144);
  a069=(a069+a144);
  a232=(a065*a232);
  a069=(a069-a232);
  a227=(a147*a227);
  a203=(a067*a203);
  a227=(a227+a203);
  a069=(a069+a227);
  a227=(a045*a069);
  a017=(a017+a227);
  a017=(a038+a017);
  a227=(a084*a017);
  a027=(a027+a227);
  a027=(a162+a027);
  a227=(a091*a027);
  a292=(a292-a227);
  a227=(a104*a309);
  a149=(a051*a149);
  a227=(a227+a149);
  a149=(a084*a170);
  a227=(a227+a149);
  a227=(a054+a227);
  a149=(a025*a227);
  a203=(a104*a262);
  a033=(a051*a033);
  a203=(a203+a033);
  a033=(a008*a257);
  a232=(a095*a290);
  a033=(a033+a232);
  a232=(a070*a175);
  a033=(a033+a232);
  a232=(a112*a198);
  a144=(a096*a102);
  a232=(a232-a144);
  a033=(a033+a232);
  a232=(a084*a033);
  a203=(a203+a232);
  a203=(a285+a203);
  a232=(a121*a203);
  a149=(a149+a232);
  a292=(a292+a149);
  a149=(a101*a292);
  a219=(a219+a149);
  a219=(a054+a219);
  a149=(a005*a219);
  a072=(a072+a149);
  a149=(a126*a309);
  a232=(a132*a170);
  a149=(a149+a232);
  a232=(a133*a292);
  a149=(a149+a232);
  a232=(a006*a054);
  a144=(a030*a198);
  a232=(a232+a144);
  a144=(a101*a227);
  a232=(a232+a144);
  a232=(a137+a232);
  a144=(a155*a232);
  a015=(a006*a285);
  a289=(a030*a102);
  a015=(a015+a289);
  a289=(a101*a203);
  a015=(a015+a289);
  a015=(a254+a015);
  a289=(a150*a015);
  a144=(a144+a289);
  a289=(a006*a038);
  a269=(a030*a017);
  a289=(a289+a269);
  a269=(a104*a009);
  a069=(a051*a069);
  a269=(a269+a069);
  a257=(a039*a257);
  a290=(a092*a290);
  a257=(a257+a290);
  a175=(a111*a175);
  a257=(a257-a175);
  a175=(a298*a198);
  a290=(a090*a102);
  a175=(a175+a290);
  a257=(a257+a175);
  a175=(a084*a257);
  a269=(a269+a175);
  a269=(a038+a269);
  a175=(a101*a269);
  a289=(a289+a175);
  a289=(a162+a289);
  a175=(a114*a289);
  a144=(a144-a175);
  a175=(a037*a219);
  a290=(a006*a262);
  a069=(a030*a033);
  a290=(a290+a069);
  a069=(a044*a004);
  a260=(a117*a018);
  a069=(a069+a260);
  a260=(a115*a027);
  a069=(a069+a260);
  a260=(a270*a227);
  a035=(a118*a203);
  a260=(a260-a035);
  a069=(a069+a260);
  a260=(a101*a069);
  a290=(a290+a260);
  a290=(a285+a290);
  a260=(a146*a290);
  a175=(a175+a260);
  a144=(a144+a175);
  a175=(a134*a144);
  a149=(a149+a175);
  a149=(a054+a149);
  a175=(a123*a149);
  a072=(a072+a175);
  a175=(a151*a309);
  a260=(a088*a170);
  a175=(a175+a260);
  a260=(a158*a292);
  a175=(a175+a260);
  a260=(a159*a144);
  a175=(a175+a260);
  a260=(a126*a054);
  a035=(a132*a198);
  a260=(a260+a035);
  a035=(a133*a227);
  a260=(a260+a035);
  a035=(a134*a219);
  a260=(a260+a035);
  a260=(a137+a260);
  a035=(a181*a260);
  a201=(a126*a285);
  a308=(a132*a102);
  a201=(a201+a308);
  a308=(a133*a203);
  a201=(a201+a308);
  a308=(a134*a290);
  a201=(a201+a308);
  a201=(a254+a201);
  a308=(a176*a201);
  a035=(a035+a308);
  a308=(a126*a038);
  a304=(a132*a017);
  a308=(a308+a304);
  a304=(a133*a269);
  a308=(a308+a304);
  a304=(a006*a009);
  a299=(a030*a257);
  a304=(a304+a299);
  a004=(a107*a004);
  a018=(a079*a018);
  a004=(a004+a018);
  a027=(a157*a027);
  a004=(a004-a027);
  a027=(a064*a227);
  a018=(a113*a203);
  a027=(a027+a018);
  a004=(a004+a027);
  a027=(a101*a004);
  a304=(a304+a027);
  a304=(a038+a304);
  a027=(a134*a304);
  a308=(a308+a027);
  a308=(a162+a308);
  a027=(a050*a308);
  a035=(a035-a027);
  a027=(a105*a149);
  a018=(a126*a262);
  a299=(a132*a033);
  a018=(a018+a299);
  a299=(a133*a069);
  a018=(a018+a299);
  a299=(a109*a232);
  a077=(a142*a015);
  a299=(a299+a077);
  a077=(a140*a289);
  a299=(a299+a077);
  a077=(a087*a219);
  a116=(a143*a290);
  a077=(a077-a116);
  a299=(a299+a077);
  a077=(a134*a299);
  a018=(a018+a077);
  a018=(a285+a018);
  a077=(a172*a018);
  a027=(a027+a077);
  a035=(a035+a027);
  a027=(a160*a035);
  a175=(a175+a027);
  a175=(a054+a175);
  a027=(a148*a175);
  a072=(a072+a027);
  a027=(a177*a309);
  a077=(a184*a170);
  a027=(a027+a077);
  a077=(a185*a292);
  a027=(a027+a077);
  a077=(a186*a144);
  a027=(a027+a077);
  a077=(a187*a035);
  a027=(a027+a077);
  a077=(a151*a054);
  a116=(a088*a198);
  a077=(a077+a116);
  a116=(a158*a227);
  a077=(a077+a116);
  a116=(a159*a219);
  a077=(a077+a116);
  a116=(a160*a149);
  a077=(a077+a116);
  a077=(a137+a077);
  a116=(a209*a077);
  a057=(a151*a285);
  a236=(a088*a102);
  a057=(a057+a236);
  a236=(a158*a203);
  a057=(a057+a236);
  a236=(a159*a290);
  a057=(a057+a236);
  a236=(a160*a018);
  a057=(a057+a236);
  a057=(a254+a057);
  a236=(a204*a057);
  a116=(a116+a236);
  a236=(a151*a038);
  a207=(a088*a017);
  a236=(a236+a207);
  a207=(a158*a269);
  a236=(a236+a207);
  a207=(a159*a304);
  a236=(a236+a207);
  a207=(a126*a009);
  a179=(a132*a257);
  a207=(a207+a179);
  a179=(a133*a004);
  a207=(a207+a179);
  a232=(a129*a232);
  a015=(a139*a015);
  a232=(a232+a015);
  a289=(a124*a289);
  a232=(a232-a289);
  a289=(a085*a219);
  a015=(a138*a290);
  a289=(a289+a015);
  a232=(a232+a289);
  a289=(a134*a232);
  a207=(a207+a289);
  a207=(a038+a207);
  a289=(a160*a207);
  a236=(a236+a289);
  a236=(a162+a236);
  a289=(a086*a236);
  a116=(a116-a289);
  a289=(a127*a175);
  a015=(a151*a262);
  a179=(a088*a033);
  a015=(a015+a179);
  a179=(a158*a069);
  a015=(a015+a179);
  a179=(a159*a299);
  a015=(a015+a179);
  a179=(a024*a260);
  a153=(a168*a201);
  a179=(a179+a153);
  a153=(a166*a308);
  a179=(a179+a153);
  a153=(a211*a149);
  a128=(a169*a018);
  a153=(a153-a128);
  a179=(a179+a153);
  a153=(a160*a179);
  a015=(a015+a153);
  a015=(a285+a015);
  a153=(a200*a015);
  a289=(a289+a153);
  a116=(a116+a289);
  a289=(a188*a116);
  a027=(a027+a289);
  a027=(a054+a027);
  a289=(a174*a027);
  a072=(a072+a289);
  a289=(a205*a309);
  a153=(a212*a170);
  a289=(a289+a153);
  a153=(a213*a292);
  a289=(a289+a153);
  a153=(a214*a144);
  a289=(a289+a153);
  a153=(a215*a035);
  a289=(a289+a153);
  a153=(a216*a116);
  a289=(a289+a153);
  a153=(a177*a054);
  a128=(a184*a198);
  a153=(a153+a128);
  a128=(a185*a227);
  a153=(a153+a128);
  a128=(a186*a219);
  a153=(a153+a128);
  a128=(a187*a149);
  a153=(a153+a128);
  a128=(a188*a175);
  a153=(a153+a128);
  a153=(a137+a153);
  a128=(a238*a153);
  a106=(a177*a285);
  a228=(a184*a102);
  a106=(a106+a228);
  a228=(a185*a203);
  a106=(a106+a228);
  a228=(a186*a290);
  a106=(a106+a228);
  a228=(a187*a018);
  a106=(a106+a228);
  a228=(a188*a015);
  a106=(a106+a228);
  a106=(a254+a106);
  a228=(a233*a106);
  a128=(a128+a228);
  a228=(a177*a038);
  a173=(a184*a017);
  a228=(a228+a173);
  a173=(a185*a269);
  a228=(a228+a173);
  a173=(a186*a304);
  a228=(a228+a173);
  a173=(a187*a207);
  a228=(a228+a173);
  a173=(a151*a009);
  a286=(a088*a257);
  a173=(a173+a286);
  a286=(a158*a004);
  a173=(a173+a286);
  a286=(a159*a232);
  a173=(a173+a286);
  a260=(a152*a260);
  a201=(a165*a201);
  a260=(a260+a201);
  a308=(a154*a308);
  a260=(a260-a308);
  a308=(a074*a149);
  a201=(a164*a018);
  a308=(a308+a201);
  a260=(a260+a308);
  a308=(a160*a260);
  a173=(a173+a308);
  a173=(a038+a173);
  a308=(a188*a173);
  a228=(a228+a308);
  a228=(a162+a228);
  a308=(a098*a228);
  a128=(a128-a308);
  a308=(a135*a027);
  a201=(a177*a262);
  a286=(a184*a033);
  a201=(a201+a286);
  a286=(a185*a069);
  a201=(a201+a286);
  a286=(a186*a299);
  a201=(a201+a286);
  a286=(a187*a179);
  a201=(a201+a286);
  a286=(a131*a077);
  a305=(a196*a057);
  a286=(a286+a305);
  a305=(a194*a236);
  a286=(a286+a305);
  a305=(a302*a175);
  a301=(a197*a015);
  a305=(a305-a301);
  a286=(a286+a305);
  a305=(a188*a286);
  a201=(a201+a305);
  a201=(a285+a201);
  a305=(a229*a201);
  a308=(a308+a305);
  a128=(a128+a308);
  a308=(a217*a128);
  a289=(a289+a308);
  a289=(a054+a289);
  a308=(a202*a289);
  a072=(a072+a308);
  a308=(a234*a309);
  a305=(a241*a170);
  a308=(a308+a305);
  a305=(a242*a292);
  a308=(a308+a305);
  a305=(a243*a144);
  a308=(a308+a305);
  a305=(a244*a035);
  a308=(a308+a305);
  a305=(a245*a116);
  a308=(a308+a305);
  a305=(a246*a128);
  a308=(a308+a305);
  a305=(a205*a054);
  a301=(a212*a198);
  a305=(a305+a301);
  a301=(a213*a227);
  a305=(a305+a301);
  a301=(a214*a219);
  a305=(a305+a301);
  a301=(a215*a149);
  a305=(a305+a301);
  a301=(a216*a175);
  a305=(a305+a301);
  a301=(a217*a027);
  a305=(a305+a301);
  a305=(a137+a305);
  a301=(a268*a305);
  a047=(a205*a285);
  a076=(a212*a102);
  a047=(a047+a076);
  a076=(a213*a203);
  a047=(a047+a076);
  a076=(a214*a290);
  a047=(a047+a076);
  a076=(a215*a018);
  a047=(a047+a076);
  a076=(a216*a015);
  a047=(a047+a076);
  a076=(a217*a201);
  a047=(a047+a076);
  a047=(a254+a047);
  a076=(a263*a047);
  a301=(a301+a076);
  a076=(a205*a038);
  a028=(a212*a017);
  a076=(a076+a028);
  a028=(a213*a269);
  a076=(a076+a028);
  a028=(a214*a304);
  a076=(a076+a028);
  a028=(a215*a207);
  a076=(a076+a028);
  a028=(a216*a173);
  a076=(a076+a028);
  a028=(a177*a009);
  a250=(a184*a257);
  a028=(a028+a250);
  a250=(a185*a004);
  a028=(a028+a250);
  a250=(a186*a232);
  a028=(a028+a250);
  a250=(a187*a260);
  a028=(a028+a250);
  a077=(a178*a077);
  a057=(a193*a057);
  a077=(a077+a057);
  a236=(a180*a236);
  a077=(a077-a236);
  a236=(a303*a175);
  a057=(a192*a015);
  a236=(a236+a057);
  a077=(a077+a236);
  a236=(a188*a077);
  a028=(a028+a236);
  a028=(a038+a028);
  a236=(a217*a028);
  a076=(a076+a236);
  a076=(a162+a076);
  a236=(a141*a076);
  a301=(a301-a236);
  a236=(a161*a289);
  a057=(a205*a262);
  a250=(a212*a033);
  a057=(a057+a250);
  a250=(a213*a069);
  a057=(a057+a250);
  a250=(a214*a299);
  a057=(a057+a250);
  a250=(a215*a179);
  a057=(a057+a250);
  a250=(a216*a286);
  a057=(a057+a250);
  a250=(a156*a153);
  a073=(a225*a106);
  a250=(a250+a073);
  a073=(a223*a228);
  a250=(a250+a073);
  a073=(a306*a027);
  a010=(a226*a201);
  a073=(a073-a010);
  a250=(a250+a073);
  a073=(a217*a250);
  a057=(a057+a073);
  a057=(a285+a057);
  a073=(a259*a057);
  a236=(a236+a073);
  a301=(a301+a236);
  a236=(a247*a301);
  a308=(a308+a236);
  a308=(a054+a308);
  a236=(a231*a308);
  a072=(a072+a236);
  a236=(a264*a309);
  a170=(a271*a170);
  a236=(a236+a170);
  a292=(a100*a292);
  a236=(a236+a292);
  a292=(a122*a144);
  a236=(a236+a292);
  a292=(a272*a035);
  a236=(a236+a292);
  a292=(a273*a116);
  a236=(a236+a292);
  a292=(a274*a128);
  a236=(a236+a292);
  a292=(a275*a301);
  a236=(a236+a292);
  a292=(a234*a054);
  a170=(a241*a198);
  a292=(a292+a170);
  a170=(a242*a227);
  a292=(a292+a170);
  a170=(a243*a219);
  a292=(a292+a170);
  a170=(a244*a149);
  a292=(a292+a170);
  a170=(a245*a175);
  a292=(a292+a170);
  a170=(a246*a027);
  a292=(a292+a170);
  a170=(a247*a289);
  a292=(a292+a170);
  a292=(a137+a292);
  a170=(a296*a292);
  a073=(a234*a285);
  a010=(a241*a102);
  a073=(a073+a010);
  a010=(a242*a203);
  a073=(a073+a010);
  a010=(a243*a290);
  a073=(a073+a010);
  a010=(a244*a018);
  a073=(a073+a010);
  a010=(a245*a015);
  a073=(a073+a010);
  a010=(a246*a201);
  a073=(a073+a010);
  a010=(a247*a057);
  a073=(a073+a010);
  a073=(a254+a073);
  a010=(a291*a073);
  a170=(a170+a010);
  a010=(a234*a038);
  a036=(a241*a017);
  a010=(a010+a036);
  a036=(a242*a269);
  a010=(a010+a036);
  a036=(a243*a304);
  a010=(a010+a036);
  a036=(a244*a207);
  a010=(a010+a036);
  a036=(a245*a173);
  a010=(a010+a036);
  a036=(a246*a028);
  a010=(a010+a036);
  a036=(a205*a009);
  a019=(a212*a257);
  a036=(a036+a019);
  a019=(a213*a004);
  a036=(a036+a019);
  a019=(a214*a232);
  a036=(a036+a019);
  a019=(a215*a260);
  a036=(a036+a019);
  a019=(a216*a077);
  a036=(a036+a019);
  a153=(a206*a153);
  a106=(a222*a106);
  a153=(a153+a106);
  a228=(a208*a228);
  a153=(a153-a228);
  a228=(a307*a027);
  a106=(a221*a201);
  a228=(a228+a106);
  a153=(a153+a228);
  a228=(a217*a153);
  a036=(a036+a228);
  a036=(a038+a036);
  a228=(a247*a036);
  a010=(a010+a228);
  a010=(a162+a010);
  a228=(a248*a010);
  a170=(a170-a228);
  a228=(a189*a308);
  a106=(a234*a262);
  a019=(a241*a033);
  a106=(a106+a019);
  a019=(a242*a069);
  a106=(a106+a019);
  a019=(a243*a299);
  a106=(a106+a019);
  a019=(a244*a179);
  a106=(a106+a019);
  a019=(a245*a286);
  a106=(a106+a019);
  a019=(a246*a250);
  a106=(a106+a019);
  a019=(a182*a305);
  a000=(a255*a047);
  a019=(a019+a000);
  a000=(a253*a076);
  a019=(a019+a000);
  a000=(a310*a289);
  a171=(a256*a057);
  a000=(a000-a171);
  a019=(a019+a000);
  a000=(a247*a019);
  a106=(a106+a000);
  a106=(a285+a106);
  a000=(a287*a106);
  a228=(a228+a000);
  a170=(a170+a228);
  a228=(a276*a170);
  a236=(a236+a228);
  a236=(a054+a236);
  a228=(a261*a236);
  a072=(a072+a228);
  a072=(a137+a072);
  if (res[0]!=0) res[0][12]=a072;
  a072=(a001*a285);
  a228=(a005*a290);
  a072=(a072+a228);
  a228=(a123*a018);
  a072=(a072+a228);
  a228=(a148*a015);
  a072=(a072+a228);
  a228=(a174*a201);
  a072=(a072+a228);
  a228=(a202*a057);
  a072=(a072+a228);
  a228=(a231*a106);
  a072=(a072+a228);
  a228=(a264*a262);
  a033=(a271*a033);
  a228=(a228+a033);
  a069=(a100*a069);
  a228=(a228+a069);
  a069=(a122*a299);
  a228=(a228+a069);
  a069=(a272*a179);
  a228=(a228+a069);
  a069=(a273*a286);
  a228=(a228+a069);
  a069=(a274*a250);
  a228=(a228+a069);
  a069=(a275*a019);
  a228=(a228+a069);
  a069=(a265*a292);
  a033=(a283*a073);
  a069=(a069+a033);
  a033=(a281*a010);
  a069=(a069+a033);
  a033=(a312*a308);
  a000=(a284*a106);
  a033=(a033-a000);
  a069=(a069+a033);
  a033=(a276*a069);
  a228=(a228+a033);
  a228=(a285+a228);
  a033=(a261*a228);
  a072=(a072+a033);
  a072=(a254+a072);
  if (res[0]!=0) res[0][13]=a072;
  a072=(a001*a038);
  a033=(a005*a304);
  a072=(a072+a033);
  a033=(a123*a207);
  a072=(a072+a033);
  a033=(a148*a173);
  a072=(a072+a033);
  a033=(a174*a028);
  a072=(a072+a033);
  a033=(a202*a036);
  a072=(a072+a033);
  a033=(a234*a009);
  a000=(a241*a257);
  a033=(a033+a000);
  a000=(a242*a004);
  a033=(a033+a000);
  a000=(a243*a232);
  a033=(a033+a000);
  a000=(a244*a260);
  a033=(a033+a000);
  a000=(a245*a077);
  a033=(a033+a000);
  a000=(a246*a153);
  a033=(a033+a000);
  a305=(a235*a305);
  a047=(a252*a047);
  a305=(a305+a047);
  a076=(a237*a076);
  a305=(a305-a076);
  a076=(a311*a289);
  a047=(a251*a057);
  a076=(a076+a047);
  a305=(a305+a076);
  a076=(a247*a305);
  a033=(a033+a076);
  a033=(a038+a033);
  a076=(a231*a033);
  a072=(a072+a076);
  a076=(a264*a009);
  a257=(a271*a257);
  a076=(a076+a257);
  a004=(a100*a004);
  a076=(a076+a004);
  a004=(a122*a232);
  a076=(a076+a004);
  a004=(a272*a260);
  a076=(a076+a004);
  a004=(a273*a077);
  a076=(a076+a004);
  a004=(a274*a153);
  a076=(a076+a004);
  a004=(a275*a305);
  a076=(a076+a004);
  a292=(a061*a292);
  a073=(a280*a073);
  a292=(a292+a073);
  a010=(a120*a010);
  a292=(a292-a010);
  a010=(a313*a308);
  a073=(a279*a106);
  a010=(a010+a073);
  a292=(a292+a010);
  a010=(a276*a292);
  a076=(a076+a010);
  a076=(a038+a076);
  a076=(a261*a076);
  a072=(a072+a076);
  a072=(a162+a072);
  if (res[0]!=0) res[0][14]=a072;
  a309=(a001*a309);
  a144=(a005*a144);
  a309=(a309+a144);
  a035=(a123*a035);
  a309=(a309+a035);
  a116=(a148*a116);
  a309=(a309+a116);
  a128=(a174*a128);
  a309=(a309+a128);
  a301=(a202*a301);
  a309=(a309+a301);
  a170=(a231*a170);
  a309=(a309+a170);
  a170=(a264*a054);
  a198=(a271*a198);
  a170=(a170+a198);
  a227=(a100*a227);
  a170=(a170+a227);
  a219=(a122*a219);
  a170=(a170+a219);
  a149=(a272*a149);
  a170=(a170+a149);
  a175=(a273*a175);
  a170=(a170+a175);
  a027=(a274*a027);
  a170=(a170+a027);
  a289=(a275*a289);
  a170=(a170+a289);
  a308=(a276*a308);
  a170=(a170+a308);
  a137=(a137+a170);
  a170=(a029*a137);
  a308=(a264*a285);
  a102=(a271*a102);
  a308=(a308+a102);
  a203=(a100*a203);
  a308=(a308+a203);
  a290=(a122*a290);
  a308=(a308+a290);
  a018=(a272*a018);
  a308=(a308+a018);
  a015=(a273*a015);
  a308=(a308+a015);
  a201=(a274*a201);
  a308=(a308+a201);
  a057=(a275*a057);
  a308=(a308+a057);
  a106=(a276*a106);
  a308=(a308+a106);
  a254=(a254+a308);
  a308=(a297*a254);
  a170=(a170+a308);
  a308=(a264*a038);
  a017=(a271*a017);
  a308=(a308+a017);
  a269=(a100*a269);
  a308=(a308+a269);
  a304=(a122*a304);
  a308=(a308+a304);
  a207=(a272*a207);
  a308=(a308+a207);
  a173=(a273*a173);
  a308=(a308+a173);
  a028=(a274*a028);
  a308=(a308+a028);
  a036=(a275*a036);
  a308=(a308+a036);
  a033=(a276*a033);
  a308=(a308+a033);
  a162=(a162+a308);
  a308=(a294*a162);
  a170=(a170-a308);
  a308=(a266*a236);
  a033=(a082*a228);
  a308=(a308+a033);
  a170=(a170+a308);
  a170=(a261*a170);
  a309=(a309+a170);
  a054=(a054+a309);
  if (res[0]!=0) res[0][15]=a054;
  a262=(a001*a262);
  a299=(a005*a299);
  a262=(a262+a299);
  a179=(a123*a179);
  a262=(a262+a179);
  a286=(a148*a286);
  a262=(a262+a286);
  a250=(a174*a250);
  a262=(a262+a250);
  a019=(a202*a019);
  a262=(a262+a019);
  a069=(a231*a069);
  a262=(a262+a069);
  a069=(a199*a137);
  a019=(a031*a254);
  a069=(a069+a019);
  a019=(a007*a162);
  a069=(a069+a019);
  a019=(a167*a236);
  a250=(a032*a228);
  a019=(a019-a250);
  a069=(a069+a019);
  a069=(a261*a069);
  a262=(a262+a069);
  a285=(a285+a262);
  if (res[0]!=0) res[0][16]=a285;
  a009=(a001*a009);
  a232=(a005*a232);
  a009=(a009+a232);
  a260=(a123*a260);
  a009=(a009+a260);
  a077=(a148*a077);
  a009=(a009+a077);
  a153=(a174*a153);
  a009=(a009+a153);
  a305=(a202*a305);
  a009=(a009+a305);
  a292=(a231*a292);
  a009=(a009+a292);
  a137=(a258*a137);
  a254=(a230*a254);
  a137=(a137+a254);
  a162=(a041*a162);
  a137=(a137-a162);
  a236=(a136*a236);
  a228=(a021*a228);
  a236=(a236+a228);
  a137=(a137+a236);
  a137=(a261*a137);
  a009=(a009+a137);
  a038=(a038+a009);
  if (res[0]!=0) res[0][17]=a038;
  a038=arg[0]? arg[0][18] : 0;
  a009=arg[0]? arg[0][21] : 0;
  a137=(a001*a009);
  a236=(a040*a038);
  a228=arg[0]? arg[0][19] : 0;
  a162=(a026*a228);
  a236=(a236+a162);
  a162=arg[0]? arg[0][20] : 0;
  a254=(a016*a162);
  a236=(a236-a254);
  a254=(a278*a009);
  a292=arg[0]? arg[0][22] : 0;
  a305=(a022*a292);
  a254=(a254+a305);
  a236=(a236+a254);
  a254=(a006*a236);
  a305=(a043*a009);
  a153=(a046*a236);
  a077=(a049*a009);
  a077=(a038+a077);
  a260=(a071*a077);
  a232=(a049*a292);
  a232=(a228+a232);
  a285=(a066*a232);
  a260=(a260+a285);
  a285=arg[0]? arg[0][23] : 0;
  a262=(a049*a285);
  a262=(a162+a262);
  a069=(a163*a262);
  a260=(a260-a069);
  a069=(a049*a236);
  a069=(a009+a069);
  a019=(a078*a069);
  a250=(a190*a038);
  a286=(a014*a228);
  a250=(a250+a286);
  a286=(a020*a162);
  a250=(a250+a286);
  a286=(a220*a009);
  a179=(a034*a292);
  a286=(a286-a179);
  a250=(a250+a286);
  a286=(a049*a250);
  a286=(a292+a286);
  a179=(a062*a286);
  a019=(a019+a179);
  a260=(a260+a019);
  a260=(a048*a260);
  a153=(a153+a260);
  a153=(a009+a153);
  a260=(a045*a153);
  a305=(a305+a260);
  a305=(a038+a305);
  a260=(a108*a305);
  a019=(a043*a292);
  a179=(a046*a250);
  a299=(a013*a077);
  a054=(a058*a232);
  a299=(a299+a054);
  a054=(a056*a262);
  a299=(a299+a054);
  a054=(a042*a069);
  a309=(a059*a286);
  a054=(a054-a309);
  a299=(a299+a054);
  a299=(a048*a299);
  a179=(a179+a299);
  a179=(a292+a179);
  a299=(a045*a179);
  a019=(a019+a299);
  a019=(a228+a019);
  a299=(a103*a019);
  a260=(a260+a299);
  a299=(a043*a285);
  a054=(a249*a038);
  a309=(a012*a228);
  a054=(a054+a309);
  a309=(a277*a162);
  a054=(a054-a309);
  a309=(a191*a009);
  a170=(a011*a292);
  a309=(a309+a170);
  a054=(a054+a309);
  a309=(a046*a054);
  a077=(a003*a077);
  a232=(a055*a232);
  a077=(a077+a232);
  a262=(a093*a262);
  a077=(a077-a262);
  a262=(a300*a069);
  a232=(a053*a286);
  a262=(a262+a232);
  a077=(a077+a262);
  a077=(a048*a077);
  a309=(a309+a077);
  a309=(a285+a309);
  a077=(a045*a309);
  a299=(a299+a077);
  a299=(a162+a299);
  a077=(a068*a299);
  a260=(a260-a077);
  a077=(a043*a236);
  a262=(a046*a009);
  a069=(a048*a069);
  a262=(a262+a069);
  a262=(a038+a262);
  a069=(a089*a262);
  a232=(a046*a292);
  a286=(a048*a286);
  a232=(a232+a286);
  a232=(a228+a232);
  a286=(a063*a232);
  a069=(a069+a286);
  a286=(a046*a285);
  a170=(a049*a054);
  a170=(a285+a170);
  a170=(a048*a170);
  a286=(a286+a170);
  a286=(a162+a286);
  a170=(a081*a286);
  a069=(a069-a170);
  a170=(a183*a153);
  a308=(a052*a179);
  a170=(a170+a308);
  a069=(a069+a170);
  a170=(a045*a069);
  a077=(a077+a170);
  a077=(a009+a077);
  a170=(a023*a077);
  a308=(a043*a250);
  a033=(a240*a262);
  a036=(a075*a232);
  a033=(a033+a036);
  a036=(a060*a286);
  a033=(a033+a036);
  a036=(a110*a153);
  a028=(a083*a179);
  a036=(a036-a028);
  a033=(a033+a036);
  a036=(a045*a033);
  a308=(a308+a036);
  a308=(a292+a308);
  a036=(a099*a308);
  a170=(a170+a036);
  a260=(a260+a170);
  a170=(a030*a260);
  a254=(a254+a170);
  a170=(a104*a009);
  a036=(a051*a153);
  a170=(a170+a036);
  a036=(a084*a077);
  a170=(a170+a036);
  a170=(a038+a170);
  a036=(a130*a170);
  a028=(a104*a292);
  a173=(a051*a179);
  a028=(a028+a173);
  a173=(a084*a308);
  a028=(a028+a173);
  a028=(a228+a028);
  a173=(a125*a028);
  a036=(a036+a173);
  a173=(a104*a285);
  a309=(a051*a309);
  a173=(a173+a309);
  a309=(a043*a054);
  a262=(a094*a262);
  a232=(a080*a232);
  a262=(a262+a232);
  a286=(a065*a286);
  a262=(a262-a286);
  a153=(a147*a153);
  a179=(a067*a179);
  a153=(a153+a179);
  a262=(a262+a153);
  a153=(a045*a262);
  a309=(a309+a153);
  a309=(a285+a309);
  a153=(a084*a309);
  a173=(a173+a153);
  a173=(a162+a173);
  a153=(a091*a173);
  a036=(a036-a153);
  a153=(a104*a236);
  a069=(a051*a069);
  a153=(a153+a069);
  a069=(a084*a260);
  a153=(a153+a069);
  a153=(a009+a153);
  a069=(a025*a153);
  a179=(a104*a250);
  a033=(a051*a033);
  a179=(a179+a033);
  a033=(a008*a305);
  a286=(a095*a019);
  a033=(a033+a286);
  a286=(a070*a299);
  a033=(a033+a286);
  a286=(a112*a077);
  a232=(a096*a308);
  a286=(a286-a232);
  a033=(a033+a286);
  a286=(a084*a033);
  a179=(a179+a286);
  a179=(a292+a179);
  a286=(a121*a179);
  a069=(a069+a286);
  a036=(a036+a069);
  a069=(a101*a036);
  a254=(a254+a069);
  a254=(a009+a254);
  a069=(a005*a254);
  a137=(a137+a069);
  a069=(a126*a236);
  a286=(a132*a260);
  a069=(a069+a286);
  a286=(a133*a036);
  a069=(a069+a286);
  a286=(a006*a009);
  a232=(a030*a077);
  a286=(a286+a232);
  a232=(a101*a153);
  a286=(a286+a232);
  a286=(a038+a286);
  a232=(a155*a286);
  a207=(a006*a292);
  a304=(a030*a308);
  a207=(a207+a304);
  a304=(a101*a179);
  a207=(a207+a304);
  a207=(a228+a207);
  a304=(a150*a207);
  a232=(a232+a304);
  a304=(a006*a285);
  a269=(a030*a309);
  a304=(a304+a269);
  a269=(a104*a054);
  a262=(a051*a262);
  a269=(a269+a262);
  a305=(a039*a305);
  a019=(a092*a019);
  a305=(a305+a019);
  a299=(a111*a299);
  a305=(a305-a299);
  a299=(a298*a077);
  a019=(a090*a308);
  a299=(a299+a019);
  a305=(a305+a299);
  a299=(a084*a305);
  a269=(a269+a299);
  a269=(a285+a269);
  a299=(a101*a269);
  a304=(a304+a299);
  a304=(a162+a304);
  a299=(a114*a304);
  a232=(a232-a299);
  a299=(a037*a254);
  a019=(a006*a250);
  a262=(a030*a033);
  a019=(a019+a262);
  a262=(a044*a170);
  a017=(a117*a028);
  a262=(a262+a017);
  a017=(a115*a173);
  a262=(a262+a017);
  a017=(a270*a153);
  a106=(a118*a179);
  a017=(a017-a106);
  a262=(a262+a017);
  a017=(a101*a262);
  a019=(a019+a017);
  a019=(a292+a019);
  a017=(a146*a019);
  a299=(a299+a017);
  a232=(a232+a299);
  a299=(a134*a232);
  a069=(a069+a299);
  a069=(a009+a069);
  a299=(a123*a069);
  a137=(a137+a299);
  a299=(a151*a236);
  a017=(a088*a260);
  a299=(a299+a017);
  a017=(a158*a036);
  a299=(a299+a017);
  a017=(a159*a232);
  a299=(a299+a017);
  a017=(a126*a009);
  a106=(a132*a077);
  a017=(a017+a106);
  a106=(a133*a153);
  a017=(a017+a106);
  a106=(a134*a254);
  a017=(a017+a106);
  a017=(a038+a017);
  a106=(a181*a017);
  a057=(a126*a292);
  a201=(a132*a308);
  a057=(a057+a201);
  a201=(a133*a179);
  a057=(a057+a201);
  a201=(a134*a019);
  a057=(a057+a201);
  a057=(a228+a057);
  a201=(a176*a057);
  a106=(a106+a201);
  a201=(a126*a285);
  a015=(a132*a309);
  a201=(a201+a015);
  a015=(a133*a269);
  a201=(a201+a015);
  a015=(a006*a054);
  a018=(a030*a305);
  a015=(a015+a018);
  a170=(a107*a170);
  a028=(a079*a028);
  a170=(a170+a028);
  a173=(a157*a173);
  a170=(a170-a173);
  a173=(a064*a153);
  a028=(a113*a179);
  a173=(a173+a028);
  a170=(a170+a173);
  a173=(a101*a170);
  a015=(a015+a173);
  a015=(a285+a015);
  a173=(a134*a015);
  a201=(a201+a173);
  a201=(a162+a201);
  a173=(a050*a201);
  a106=(a106-a173);
  a173=(a105*a069);
  a028=(a126*a250);
  a018=(a132*a033);
  a028=(a028+a018);
  a018=(a133*a262);
  a028=(a028+a018);
  a018=(a109*a286);
  a290=(a142*a207);
  a018=(a018+a290);
  a290=(a140*a304);
  a018=(a018+a290);
  a290=(a087*a254);
  a203=(a143*a019);
  a290=(a290-a203);
  a018=(a018+a290);
  a290=(a134*a018);
  a028=(a028+a290);
  a028=(a292+a028);
  a290=(a172*a028);
  a173=(a173+a290);
  a106=(a106+a173);
  a173=(a160*a106);
  a299=(a299+a173);
  a299=(a009+a299);
  a173=(a148*a299);
  a137=(a137+a173);
  a173=(a177*a236);
  a290=(a184*a260);
  a173=(a173+a290);
  a290=(a185*a036);
  a173=(a173+a290);
  a290=(a186*a232);
  a173=(a173+a290);
  a290=(a187*a106);
  a173=(a173+a290);
  a290=(a151*a009);
  a203=(a088*a077);
  a290=(a290+a203);
  a203=(a158*a153);
  a290=(a290+a203);
  a203=(a159*a254);
  a290=(a290+a203);
  a203=(a160*a069);
  a290=(a290+a203);
  a290=(a038+a290);
  a203=(a209*a290);
  a102=(a151*a292);
  a289=(a088*a308);
  a102=(a102+a289);
  a289=(a158*a179);
  a102=(a102+a289);
  a289=(a159*a019);
  a102=(a102+a289);
  a289=(a160*a028);
  a102=(a102+a289);
  a102=(a228+a102);
  a289=(a204*a102);
  a203=(a203+a289);
  a289=(a151*a285);
  a027=(a088*a309);
  a289=(a289+a027);
  a027=(a158*a269);
  a289=(a289+a027);
  a027=(a159*a015);
  a289=(a289+a027);
  a027=(a126*a054);
  a175=(a132*a305);
  a027=(a027+a175);
  a175=(a133*a170);
  a027=(a027+a175);
  a286=(a129*a286);
  a207=(a139*a207);
  a286=(a286+a207);
  a304=(a124*a304);
  a286=(a286-a304);
  a304=(a085*a254);
  a207=(a138*a019);
  a304=(a304+a207);
  a286=(a286+a304);
  a304=(a134*a286);
  a027=(a027+a304);
  a027=(a285+a027);
  a304=(a160*a027);
  a289=(a289+a304);
  a289=(a162+a289);
  a304=(a086*a289);
  a203=(a203-a304);
  a304=(a127*a299);
  a207=(a151*a250);
  a175=(a088*a033);
  a207=(a207+a175);
  a175=(a158*a262);
  a207=(a207+a175);
  a175=(a159*a018);
  a207=(a207+a175);
  a175=(a024*a017);
  a149=(a168*a057);
  a175=(a175+a149);
  a149=(a166*a201);
  a175=(a175+a149);
  a149=(a211*a069);
  a219=(a169*a028);
  a149=(a149-a219);
  a175=(a175+a149);
  a149=(a160*a175);
  a207=(a207+a149);
  a207=(a292+a207);
  a149=(a200*a207);
  a304=(a304+a149);
  a203=(a203+a304);
  a304=(a188*a203);
  a173=(a173+a304);
  a173=(a009+a173);
  a304=(a174*a173);
  a137=(a137+a304);
  a304=(a205*a236);
  a149=(a212*a260);
  a304=(a304+a149);
  a149=(a213*a036);
  a304=(a304+a149);
  a149=(a214*a232);
  a304=(a304+a149);
  a149=(a215*a106);
  a304=(a304+a149);
  a149=(a216*a203);
  a304=(a304+a149);
  a149=(a177*a009);
  a219=(a184*a077);
  a149=(a149+a219);
  a219=(a185*a153);
  a149=(a149+a219);
  a219=(a186*a254);
  a149=(a149+a219);
  a219=(a187*a069);
  a149=(a149+a219);
  a219=(a188*a299);
  a149=(a149+a219);
  a149=(a038+a149);
  a219=(a238*a149);
  a227=(a177*a292);
  a198=(a184*a308);
  a227=(a227+a198);
  a198=(a185*a179);
  a227=(a227+a198);
  a198=(a186*a019);
  a227=(a227+a198);
  a198=(a187*a028);
  a227=(a227+a198);
  a198=(a188*a207);
  a227=(a227+a198);
  a227=(a228+a227);
  a198=(a233*a227);
  a219=(a219+a198);
  a198=(a177*a285);
  a301=(a184*a309);
  a198=(a198+a301);
  a301=(a185*a269);
  a198=(a198+a301);
  a301=(a186*a015);
  a198=(a198+a301);
  a301=(a187*a027);
  a198=(a198+a301);
  a301=(a151*a054);
  a128=(a088*a305);
  a301=(a301+a128);
  a128=(a158*a170);
  a301=(a301+a128);
  a128=(a159*a286);
  a301=(a301+a128);
  a017=(a152*a017);
  a057=(a165*a057);
  a017=(a017+a057);
  a201=(a154*a201);
  a017=(a017-a201);
  a201=(a074*a069);
  a057=(a164*a028);
  a201=(a201+a057);
  a017=(a017+a201);
  a201=(a160*a017);
  a301=(a301+a201);
  a301=(a285+a301);
  a201=(a188*a301);
  a198=(a198+a201);
  a198=(a162+a198);
  a201=(a098*a198);
  a219=(a219-a201);
  a201=(a135*a173);
  a057=(a177*a250);
  a128=(a184*a033);
  a057=(a057+a128);
  a128=(a185*a262);
  a057=(a057+a128);
  a128=(a186*a018);
  a057=(a057+a128);
  a128=(a187*a175);
  a057=(a057+a128);
  a128=(a131*a290);
  a116=(a196*a102);
  a128=(a128+a116);
  a116=(a194*a289);
  a128=(a128+a116);
  a116=(a302*a299);
  a035=(a197*a207);
  a116=(a116-a035);
  a128=(a128+a116);
  a116=(a188*a128);
  a057=(a057+a116);
  a057=(a292+a057);
  a116=(a229*a057);
  a201=(a201+a116);
  a219=(a219+a201);
  a201=(a217*a219);
  a304=(a304+a201);
  a304=(a009+a304);
  a201=(a202*a304);
  a137=(a137+a201);
  a201=(a234*a236);
  a116=(a241*a260);
  a201=(a201+a116);
  a116=(a242*a036);
  a201=(a201+a116);
  a116=(a243*a232);
  a201=(a201+a116);
  a116=(a244*a106);
  a201=(a201+a116);
  a116=(a245*a203);
  a201=(a201+a116);
  a116=(a246*a219);
  a201=(a201+a116);
  a116=(a205*a009);
  a035=(a212*a077);
  a116=(a116+a035);
  a035=(a213*a153);
  a116=(a116+a035);
  a035=(a214*a254);
  a116=(a116+a035);
  a035=(a215*a069);
  a116=(a116+a035);
  a035=(a216*a299);
  a116=(a116+a035);
  a035=(a217*a173);
  a116=(a116+a035);
  a116=(a038+a116);
  a035=(a268*a116);
  a144=(a205*a292);
  a072=(a212*a308);
  a144=(a144+a072);
  a072=(a213*a179);
  a144=(a144+a072);
  a072=(a214*a019);
  a144=(a144+a072);
  a072=(a215*a028);
  a144=(a144+a072);
  a072=(a216*a207);
  a144=(a144+a072);
  a072=(a217*a057);
  a144=(a144+a072);
  a144=(a228+a144);
  a072=(a263*a144);
  a035=(a035+a072);
  a072=(a205*a285);
  a076=(a212*a309);
  a072=(a072+a076);
  a076=(a213*a269);
  a072=(a072+a076);
  a076=(a214*a015);
  a072=(a072+a076);
  a076=(a215*a027);
  a072=(a072+a076);
  a076=(a216*a301);
  a072=(a072+a076);
  a076=(a177*a054);
  a010=(a184*a305);
  a076=(a076+a010);
  a010=(a185*a170);
  a076=(a076+a010);
  a010=(a186*a286);
  a076=(a076+a010);
  a010=(a187*a017);
  a076=(a076+a010);
  a290=(a178*a290);
  a102=(a193*a102);
  a290=(a290+a102);
  a289=(a180*a289);
  a290=(a290-a289);
  a289=(a303*a299);
  a102=(a192*a207);
  a289=(a289+a102);
  a290=(a290+a289);
  a289=(a188*a290);
  a076=(a076+a289);
  a076=(a285+a076);
  a289=(a217*a076);
  a072=(a072+a289);
  a072=(a162+a072);
  a289=(a141*a072);
  a035=(a035-a289);
  a289=(a161*a304);
  a102=(a205*a250);
  a010=(a212*a033);
  a102=(a102+a010);
  a010=(a213*a262);
  a102=(a102+a010);
  a010=(a214*a018);
  a102=(a102+a010);
  a010=(a215*a175);
  a102=(a102+a010);
  a010=(a216*a128);
  a102=(a102+a010);
  a010=(a156*a149);
  a073=(a225*a227);
  a010=(a010+a073);
  a073=(a223*a198);
  a010=(a010+a073);
  a073=(a306*a173);
  a004=(a226*a057);
  a073=(a073-a004);
  a010=(a010+a073);
  a073=(a217*a010);
  a102=(a102+a073);
  a102=(a292+a102);
  a073=(a259*a102);
  a289=(a289+a073);
  a035=(a035+a289);
  a289=(a247*a035);
  a201=(a201+a289);
  a201=(a009+a201);
  a289=(a231*a201);
  a137=(a137+a289);
  a289=(a264*a236);
  a260=(a271*a260);
  a289=(a289+a260);
  a036=(a100*a036);
  a289=(a289+a036);
  a036=(a122*a232);
  a289=(a289+a036);
  a036=(a272*a106);
  a289=(a289+a036);
  a036=(a273*a203);
  a289=(a289+a036);
  a036=(a274*a219);
  a289=(a289+a036);
  a036=(a275*a035);
  a289=(a289+a036);
  a036=(a234*a009);
  a260=(a241*a077);
  a036=(a036+a260);
  a260=(a242*a153);
  a036=(a036+a260);
  a260=(a243*a254);
  a036=(a036+a260);
  a260=(a244*a069);
  a036=(a036+a260);
  a260=(a245*a299);
  a036=(a036+a260);
  a260=(a246*a173);
  a036=(a036+a260);
  a260=(a247*a304);
  a036=(a036+a260);
  a036=(a038+a036);
  a260=(a296*a036);
  a073=(a234*a292);
  a004=(a241*a308);
  a073=(a073+a004);
  a004=(a242*a179);
  a073=(a073+a004);
  a004=(a243*a019);
  a073=(a073+a004);
  a004=(a244*a028);
  a073=(a073+a004);
  a004=(a245*a207);
  a073=(a073+a004);
  a004=(a246*a057);
  a073=(a073+a004);
  a004=(a247*a102);
  a073=(a073+a004);
  a073=(a228+a073);
  a004=(a291*a073);
  a260=(a260+a004);
  a004=(a234*a285);
  a257=(a241*a309);
  a004=(a004+a257);
  a257=(a242*a269);
  a004=(a004+a257);
  a257=(a243*a015);
  a004=(a004+a257);
  a257=(a244*a027);
  a004=(a004+a257);
  a257=(a245*a301);
  a004=(a004+a257);
  a257=(a246*a076);
  a004=(a004+a257);
  a257=(a205*a054);
  a047=(a212*a305);
  a257=(a257+a047);
  a047=(a213*a170);
  a257=(a257+a047);
  a047=(a214*a286);
  a257=(a257+a047);
  a047=(a215*a017);
  a257=(a257+a047);
  a047=(a216*a290);
  a257=(a257+a047);
  a149=(a206*a149);
  a227=(a222*a227);
  a149=(a149+a227);
  a198=(a208*a198);
  a149=(a149-a198);
  a198=(a307*a173);
  a227=(a221*a057);
  a198=(a198+a227);
  a149=(a149+a198);
  a198=(a217*a149);
  a257=(a257+a198);
  a257=(a285+a257);
  a198=(a247*a257);
  a004=(a004+a198);
  a004=(a162+a004);
  a198=(a248*a004);
  a260=(a260-a198);
  a198=(a189*a201);
  a227=(a234*a250);
  a047=(a241*a033);
  a227=(a227+a047);
  a047=(a242*a262);
  a227=(a227+a047);
  a047=(a243*a018);
  a227=(a227+a047);
  a047=(a244*a175);
  a227=(a227+a047);
  a047=(a245*a128);
  a227=(a227+a047);
  a047=(a246*a010);
  a227=(a227+a047);
  a047=(a182*a116);
  a000=(a255*a144);
  a047=(a047+a000);
  a000=(a253*a072);
  a047=(a047+a000);
  a000=(a310*a304);
  a171=(a256*a102);
  a000=(a000-a171);
  a047=(a047+a000);
  a000=(a247*a047);
  a227=(a227+a000);
  a227=(a292+a227);
  a000=(a287*a227);
  a198=(a198+a000);
  a260=(a260+a198);
  a198=(a276*a260);
  a289=(a289+a198);
  a289=(a009+a289);
  a198=(a261*a289);
  a137=(a137+a198);
  a137=(a038+a137);
  if (res[0]!=0) res[0][18]=a137;
  a137=(a001*a292);
  a198=(a005*a019);
  a137=(a137+a198);
  a198=(a123*a028);
  a137=(a137+a198);
  a198=(a148*a207);
  a137=(a137+a198);
  a198=(a174*a057);
  a137=(a137+a198);
  a198=(a202*a102);
  a137=(a137+a198);
  a198=(a231*a227);
  a137=(a137+a198);
  a198=(a264*a250);
  a033=(a271*a033);
  a198=(a198+a033);
  a262=(a100*a262);
  a198=(a198+a262);
  a262=(a122*a018);
  a198=(a198+a262);
  a262=(a272*a175);
  a198=(a198+a262);
  a262=(a273*a128);
  a198=(a198+a262);
  a262=(a274*a010);
  a198=(a198+a262);
  a262=(a275*a047);
  a198=(a198+a262);
  a262=(a265*a036);
  a033=(a283*a073);
  a262=(a262+a033);
  a033=(a281*a004);
  a262=(a262+a033);
  a033=(a312*a201);
  a000=(a284*a227);
  a033=(a033-a000);
  a262=(a262+a033);
  a033=(a276*a262);
  a198=(a198+a033);
  a198=(a292+a198);
  a033=(a261*a198);
  a137=(a137+a033);
  a137=(a228+a137);
  if (res[0]!=0) res[0][19]=a137;
  a137=(a001*a285);
  a033=(a005*a015);
  a137=(a137+a033);
  a033=(a123*a027);
  a137=(a137+a033);
  a033=(a148*a301);
  a137=(a137+a033);
  a033=(a174*a076);
  a137=(a137+a033);
  a033=(a202*a257);
  a137=(a137+a033);
  a033=(a234*a054);
  a000=(a241*a305);
  a033=(a033+a000);
  a000=(a242*a170);
  a033=(a033+a000);
  a000=(a243*a286);
  a033=(a033+a000);
  a000=(a244*a017);
  a033=(a033+a000);
  a000=(a245*a290);
  a033=(a033+a000);
  a000=(a246*a149);
  a033=(a033+a000);
  a116=(a235*a116);
  a144=(a252*a144);
  a116=(a116+a144);
  a072=(a237*a072);
  a116=(a116-a072);
  a072=(a311*a304);
  a144=(a251*a102);
  a072=(a072+a144);
  a116=(a116+a072);
  a072=(a247*a116);
  a033=(a033+a072);
  a033=(a285+a033);
  a072=(a231*a033);
  a137=(a137+a072);
  a072=(a264*a054);
  a305=(a271*a305);
  a072=(a072+a305);
  a170=(a100*a170);
  a072=(a072+a170);
  a170=(a122*a286);
  a072=(a072+a170);
  a170=(a272*a017);
  a072=(a072+a170);
  a170=(a273*a290);
  a072=(a072+a170);
  a170=(a274*a149);
  a072=(a072+a170);
  a170=(a275*a116);
  a072=(a072+a170);
  a036=(a061*a036);
  a073=(a280*a073);
  a036=(a036+a073);
  a004=(a120*a004);
  a036=(a036-a004);
  a004=(a313*a201);
  a073=(a279*a227);
  a004=(a004+a073);
  a036=(a036+a004);
  a004=(a276*a036);
  a072=(a072+a004);
  a072=(a285+a072);
  a072=(a261*a072);
  a137=(a137+a072);
  a137=(a162+a137);
  if (res[0]!=0) res[0][20]=a137;
  a236=(a001*a236);
  a232=(a005*a232);
  a236=(a236+a232);
  a106=(a123*a106);
  a236=(a236+a106);
  a203=(a148*a203);
  a236=(a236+a203);
  a219=(a174*a219);
  a236=(a236+a219);
  a035=(a202*a035);
  a236=(a236+a035);
  a260=(a231*a260);
  a236=(a236+a260);
  a260=(a264*a009);
  a077=(a271*a077);
  a260=(a260+a077);
  a153=(a100*a153);
  a260=(a260+a153);
  a254=(a122*a254);
  a260=(a260+a254);
  a069=(a272*a069);
  a260=(a260+a069);
  a299=(a273*a299);
  a260=(a260+a299);
  a173=(a274*a173);
  a260=(a260+a173);
  a304=(a275*a304);
  a260=(a260+a304);
  a201=(a276*a201);
  a260=(a260+a201);
  a038=(a038+a260);
  a260=(a029*a038);
  a201=(a264*a292);
  a308=(a271*a308);
  a201=(a201+a308);
  a179=(a100*a179);
  a201=(a201+a179);
  a019=(a122*a019);
  a201=(a201+a019);
  a028=(a272*a028);
  a201=(a201+a028);
  a207=(a273*a207);
  a201=(a201+a207);
  a057=(a274*a057);
  a201=(a201+a057);
  a102=(a275*a102);
  a201=(a201+a102);
  a227=(a276*a227);
  a201=(a201+a227);
  a228=(a228+a201);
  a201=(a297*a228);
  a260=(a260+a201);
  a201=(a264*a285);
  a309=(a271*a309);
  a201=(a201+a309);
  a269=(a100*a269);
  a201=(a201+a269);
  a015=(a122*a015);
  a201=(a201+a015);
  a027=(a272*a027);
  a201=(a201+a027);
  a301=(a273*a301);
  a201=(a201+a301);
  a076=(a274*a076);
  a201=(a201+a076);
  a257=(a275*a257);
  a201=(a201+a257);
  a033=(a276*a033);
  a201=(a201+a033);
  a162=(a162+a201);
  a201=(a294*a162);
  a260=(a260-a201);
  a201=(a266*a289);
  a033=(a082*a198);
  a201=(a201+a033);
  a260=(a260+a201);
  a260=(a261*a260);
  a236=(a236+a260);
  a009=(a009+a236);
  if (res[0]!=0) res[0][21]=a009;
  a250=(a001*a250);
  a018=(a005*a018);
  a250=(a250+a018);
  a175=(a123*a175);
  a250=(a250+a175);
  a128=(a148*a128);
  a250=(a250+a128);
  a010=(a174*a010);
  a250=(a250+a010);
  a047=(a202*a047);
  a250=(a250+a047);
  a262=(a231*a262);
  a250=(a250+a262);
  a262=(a199*a038);
  a047=(a031*a228);
  a262=(a262+a047);
  a047=(a007*a162);
  a262=(a262+a047);
  a047=(a167*a289);
  a010=(a032*a198);
  a047=(a047-a010);
  a262=(a262+a047);
  a262=(a261*a262);
  a250=(a250+a262);
  a292=(a292+a250);
  if (res[0]!=0) res[0][22]=a292;
  a054=(a001*a054);
  a286=(a005*a286);
  a054=(a054+a286);
  a017=(a123*a017);
  a054=(a054+a017);
  a290=(a148*a290);
  a054=(a054+a290);
  a149=(a174*a149);
  a054=(a054+a149);
  a116=(a202*a116);
  a054=(a054+a116);
  a036=(a231*a036);
  a054=(a054+a036);
  a038=(a258*a038);
  a228=(a230*a228);
  a038=(a038+a228);
  a162=(a041*a162);
  a038=(a038-a162);
  a289=(a136*a289);
  a198=(a021*a198);
  a289=(a289+a198);
  a038=(a038+a289);
  a038=(a261*a038);
  a054=(a054+a038);
  a285=(a285+a054);
  if (res[0]!=0) res[0][23]=a285;
  a285=arg[0]? arg[0][24] : 0;
  a054=arg[0]? arg[0][27] : 0;
  a038=(a001*a054);
  a289=(a040*a285);
  a198=arg[0]? arg[0][25] : 0;
  a162=(a026*a198);
  a289=(a289+a162);
  a162=arg[0]? arg[0][26] : 0;
  a228=(a016*a162);
  a289=(a289-a228);
  a228=(a278*a054);
  a036=arg[0]? arg[0][28] : 0;
  a116=(a022*a036);
  a228=(a228+a116);
  a289=(a289+a228);
  a228=(a006*a289);
  a116=(a043*a054);
  a149=(a046*a289);
  a290=(a049*a054);
  a290=(a285+a290);
  a017=(a071*a290);
  a286=(a049*a036);
  a286=(a198+a286);
  a292=(a066*a286);
  a017=(a017+a292);
  a292=arg[0]? arg[0][29] : 0;
  a250=(a049*a292);
  a250=(a162+a250);
  a262=(a163*a250);
  a017=(a017-a262);
  a262=(a049*a289);
  a262=(a054+a262);
  a047=(a078*a262);
  a010=(a190*a285);
  a128=(a014*a198);
  a010=(a010+a128);
  a128=(a020*a162);
  a010=(a010+a128);
  a128=(a220*a054);
  a175=(a034*a036);
  a128=(a128-a175);
  a010=(a010+a128);
  a128=(a049*a010);
  a128=(a036+a128);
  a175=(a062*a128);
  a047=(a047+a175);
  a017=(a017+a047);
  a017=(a048*a017);
  a149=(a149+a017);
  a149=(a054+a149);
  a017=(a045*a149);
  a116=(a116+a017);
  a116=(a285+a116);
  a017=(a108*a116);
  a047=(a043*a036);
  a175=(a046*a010);
  a018=(a013*a290);
  a009=(a058*a286);
  a018=(a018+a009);
  a009=(a056*a250);
  a018=(a018+a009);
  a009=(a042*a262);
  a236=(a059*a128);
  a009=(a009-a236);
  a018=(a018+a009);
  a018=(a048*a018);
  a175=(a175+a018);
  a175=(a036+a175);
  a018=(a045*a175);
  a047=(a047+a018);
  a047=(a198+a047);
  a018=(a103*a047);
  a017=(a017+a018);
  a018=(a043*a292);
  a009=(a249*a285);
  a236=(a012*a198);
  a009=(a009+a236);
  a236=(a277*a162);
  a009=(a009-a236);
  a236=(a191*a054);
  a260=(a011*a036);
  a236=(a236+a260);
  a009=(a009+a236);
  a236=(a046*a009);
  a290=(a003*a290);
  a286=(a055*a286);
  a290=(a290+a286);
  a250=(a093*a250);
  a290=(a290-a250);
  a250=(a300*a262);
  a286=(a053*a128);
  a250=(a250+a286);
  a290=(a290+a250);
  a290=(a048*a290);
  a236=(a236+a290);
  a236=(a292+a236);
  a290=(a045*a236);
  a018=(a018+a290);
  a018=(a162+a018);
  a290=(a068*a018);
  a017=(a017-a290);
  a290=(a043*a289);
  a250=(a046*a054);
  a262=(a048*a262);
  a250=(a250+a262);
  a250=(a285+a250);
  a262=(a089*a250);
  a286=(a046*a036);
  a128=(a048*a128);
  a286=(a286+a128);
  a286=(a198+a286);
  a128=(a063*a286);
  a262=(a262+a128);
  a128=(a046*a292);
  a260=(a049*a009);
  a260=(a292+a260);
  a260=(a048*a260);
  a128=(a128+a260);
  a128=(a162+a128);
  a260=(a081*a128);
  a262=(a262-a260);
  a260=(a183*a149);
  a201=(a052*a175);
  a260=(a260+a201);
  a262=(a262+a260);
  a260=(a045*a262);
  a290=(a290+a260);
  a290=(a054+a290);
  a260=(a023*a290);
  a201=(a043*a010);
  a033=(a240*a250);
  a257=(a075*a286);
  a033=(a033+a257);
  a257=(a060*a128);
  a033=(a033+a257);
  a257=(a110*a149);
  a076=(a083*a175);
  a257=(a257-a076);
  a033=(a033+a257);
  a257=(a045*a033);
  a201=(a201+a257);
  a201=(a036+a201);
  a257=(a099*a201);
  a260=(a260+a257);
  a017=(a017+a260);
  a260=(a030*a017);
  a228=(a228+a260);
  a260=(a104*a054);
  a257=(a051*a149);
  a260=(a260+a257);
  a257=(a084*a290);
  a260=(a260+a257);
  a260=(a285+a260);
  a257=(a130*a260);
  a076=(a104*a036);
  a301=(a051*a175);
  a076=(a076+a301);
  a301=(a084*a201);
  a076=(a076+a301);
  a076=(a198+a076);
  a301=(a125*a076);
  a257=(a257+a301);
  a301=(a104*a292);
  a236=(a051*a236);
  a301=(a301+a236);
  a236=(a043*a009);
  a250=(a094*a250);
  a286=(a080*a286);
  a250=(a250+a286);
  a128=(a065*a128);
  a250=(a250-a128);
  a149=(a147*a149);
  a175=(a067*a175);
  a149=(a149+a175);
  a250=(a250+a149);
  a149=(a045*a250);
  a236=(a236+a149);
  a236=(a292+a236);
  a149=(a084*a236);
  a301=(a301+a149);
  a301=(a162+a301);
  a149=(a091*a301);
  a257=(a257-a149);
  a149=(a104*a289);
  a262=(a051*a262);
  a149=(a149+a262);
  a262=(a084*a017);
  a149=(a149+a262);
  a149=(a054+a149);
  a262=(a025*a149);
  a175=(a104*a010);
  a033=(a051*a033);
  a175=(a175+a033);
  a033=(a008*a116);
  a128=(a095*a047);
  a033=(a033+a128);
  a128=(a070*a018);
  a033=(a033+a128);
  a128=(a112*a290);
  a286=(a096*a201);
  a128=(a128-a286);
  a033=(a033+a128);
  a128=(a084*a033);
  a175=(a175+a128);
  a175=(a036+a175);
  a128=(a121*a175);
  a262=(a262+a128);
  a257=(a257+a262);
  a262=(a101*a257);
  a228=(a228+a262);
  a228=(a054+a228);
  a262=(a005*a228);
  a038=(a038+a262);
  a262=(a126*a289);
  a128=(a132*a017);
  a262=(a262+a128);
  a128=(a133*a257);
  a262=(a262+a128);
  a128=(a006*a054);
  a286=(a030*a290);
  a128=(a128+a286);
  a286=(a101*a149);
  a128=(a128+a286);
  a128=(a285+a128);
  a286=(a155*a128);
  a027=(a006*a036);
  a015=(a030*a201);
  a027=(a027+a015);
  a015=(a101*a175);
  a027=(a027+a015);
  a027=(a198+a027);
  a015=(a150*a027);
  a286=(a286+a015);
  a015=(a006*a292);
  a269=(a030*a236);
  a015=(a015+a269);
  a269=(a104*a009);
  a250=(a051*a250);
  a269=(a269+a250);
  a116=(a039*a116);
  a047=(a092*a047);
  a116=(a116+a047);
  a018=(a111*a018);
  a116=(a116-a018);
  a018=(a298*a290);
  a047=(a090*a201);
  a018=(a018+a047);
  a116=(a116+a018);
  a018=(a084*a116);
  a269=(a269+a018);
  a269=(a292+a269);
  a018=(a101*a269);
  a015=(a015+a018);
  a015=(a162+a015);
  a018=(a114*a015);
  a286=(a286-a018);
  a018=(a037*a228);
  a047=(a006*a010);
  a250=(a030*a033);
  a047=(a047+a250);
  a250=(a044*a260);
  a309=(a117*a076);
  a250=(a250+a309);
  a309=(a115*a301);
  a250=(a250+a309);
  a309=(a270*a149);
  a227=(a118*a175);
  a309=(a309-a227);
  a250=(a250+a309);
  a309=(a101*a250);
  a047=(a047+a309);
  a047=(a036+a047);
  a309=(a146*a047);
  a018=(a018+a309);
  a286=(a286+a018);
  a018=(a134*a286);
  a262=(a262+a018);
  a262=(a054+a262);
  a018=(a123*a262);
  a038=(a038+a018);
  a018=(a151*a289);
  a309=(a088*a017);
  a018=(a018+a309);
  a309=(a158*a257);
  a018=(a018+a309);
  a309=(a159*a286);
  a018=(a018+a309);
  a309=(a126*a054);
  a227=(a132*a290);
  a309=(a309+a227);
  a227=(a133*a149);
  a309=(a309+a227);
  a227=(a134*a228);
  a309=(a309+a227);
  a309=(a285+a309);
  a227=(a181*a309);
  a102=(a126*a036);
  a057=(a132*a201);
  a102=(a102+a057);
  a057=(a133*a175);
  a102=(a102+a057);
  a057=(a134*a047);
  a102=(a102+a057);
  a102=(a198+a102);
  a057=(a176*a102);
  a227=(a227+a057);
  a057=(a126*a292);
  a207=(a132*a236);
  a057=(a057+a207);
  a207=(a133*a269);
  a057=(a057+a207);
  a207=(a006*a009);
  a028=(a030*a116);
  a207=(a207+a028);
  a260=(a107*a260);
  a076=(a079*a076);
  a260=(a260+a076);
  a301=(a157*a301);
  a260=(a260-a301);
  a301=(a064*a149);
  a076=(a113*a175);
  a301=(a301+a076);
  a260=(a260+a301);
  a301=(a101*a260);
  a207=(a207+a301);
  a207=(a292+a207);
  a301=(a134*a207);
  a057=(a057+a301);
  a057=(a162+a057);
  a301=(a050*a057);
  a227=(a227-a301);
  a301=(a105*a262);
  a076=(a126*a010);
  a028=(a132*a033);
  a076=(a076+a028);
  a028=(a133*a250);
  a076=(a076+a028);
  a028=(a109*a128);
  a019=(a142*a027);
  a028=(a028+a019);
  a019=(a140*a015);
  a028=(a028+a019);
  a019=(a087*a228);
  a179=(a143*a047);
  a019=(a019-a179);
  a028=(a028+a019);
  a019=(a134*a028);
  a076=(a076+a019);
  a076=(a036+a076);
  a019=(a172*a076);
  a301=(a301+a019);
  a227=(a227+a301);
  a301=(a160*a227);
  a018=(a018+a301);
  a018=(a054+a018);
  a301=(a148*a018);
  a038=(a038+a301);
  a301=(a177*a289);
  a019=(a184*a017);
  a301=(a301+a019);
  a019=(a185*a257);
  a301=(a301+a019);
  a019=(a186*a286);
  a301=(a301+a019);
  a019=(a187*a227);
  a301=(a301+a019);
  a019=(a151*a054);
  a179=(a088*a290);
  a019=(a019+a179);
  a179=(a158*a149);
  a019=(a019+a179);
  a179=(a159*a228);
  a019=(a019+a179);
  a179=(a160*a262);
  a019=(a019+a179);
  a019=(a285+a019);
  a179=(a209*a019);
  a308=(a151*a036);
  a304=(a088*a201);
  a308=(a308+a304);
  a304=(a158*a175);
  a308=(a308+a304);
  a304=(a159*a047);
  a308=(a308+a304);
  a304=(a160*a076);
  a308=(a308+a304);
  a308=(a198+a308);
  a304=(a204*a308);
  a179=(a179+a304);
  a304=(a151*a292);
  a173=(a088*a236);
  a304=(a304+a173);
  a173=(a158*a269);
  a304=(a304+a173);
  a173=(a159*a207);
  a304=(a304+a173);
  a173=(a126*a009);
  a299=(a132*a116);
  a173=(a173+a299);
  a299=(a133*a260);
  a173=(a173+a299);
  a128=(a129*a128);
  a027=(a139*a027);
  a128=(a128+a027);
  a015=(a124*a015);
  a128=(a128-a015);
  a015=(a085*a228);
  a027=(a138*a047);
  a015=(a015+a027);
  a128=(a128+a015);
  a015=(a134*a128);
  a173=(a173+a015);
  a173=(a292+a173);
  a015=(a160*a173);
  a304=(a304+a015);
  a304=(a162+a304);
  a015=(a086*a304);
  a179=(a179-a015);
  a015=(a127*a018);
  a027=(a151*a010);
  a299=(a088*a033);
  a027=(a027+a299);
  a299=(a158*a250);
  a027=(a027+a299);
  a299=(a159*a028);
  a027=(a027+a299);
  a299=(a024*a309);
  a069=(a168*a102);
  a299=(a299+a069);
  a069=(a166*a057);
  a299=(a299+a069);
  a069=(a211*a262);
  a254=(a169*a076);
  a069=(a069-a254);
  a299=(a299+a069);
  a069=(a160*a299);
  a027=(a027+a069);
  a027=(a036+a027);
  a069=(a200*a027);
  a015=(a015+a069);
  a179=(a179+a015);
  a015=(a188*a179);
  a301=(a301+a015);
  a301=(a054+a301);
  a015=(a174*a301);
  a038=(a038+a015);
  a015=(a205*a289);
  a069=(a212*a017);
  a015=(a015+a069);
  a069=(a213*a257);
  a015=(a015+a069);
  a069=(a214*a286);
  a015=(a015+a069);
  a069=(a215*a227);
  a015=(a015+a069);
  a069=(a216*a179);
  a015=(a015+a069);
  a069=(a177*a054);
  a254=(a184*a290);
  a069=(a069+a254);
  a254=(a185*a149);
  a069=(a069+a254);
  a254=(a186*a228);
  a069=(a069+a254);
  a254=(a187*a262);
  a069=(a069+a254);
  a254=(a188*a018);
  a069=(a069+a254);
  a069=(a285+a069);
  a254=(a238*a069);
  a153=(a177*a036);
  a077=(a184*a201);
  a153=(a153+a077);
  a077=(a185*a175);
  a153=(a153+a077);
  a077=(a186*a047);
  a153=(a153+a077);
  a077=(a187*a076);
  a153=(a153+a077);
  a077=(a188*a027);
  a153=(a153+a077);
  a153=(a198+a153);
  a077=(a233*a153);
  a254=(a254+a077);
  a077=(a177*a292);
  a035=(a184*a236);
  a077=(a077+a035);
  a035=(a185*a269);
  a077=(a077+a035);
  a035=(a186*a207);
  a077=(a077+a035);
  a035=(a187*a173);
  a077=(a077+a035);
  a035=(a151*a009);
  a219=(a088*a116);
  a035=(a035+a219);
  a219=(a158*a260);
  a035=(a035+a219);
  a219=(a159*a128);
  a035=(a035+a219);
  a309=(a152*a309);
  a102=(a165*a102);
  a309=(a309+a102);
  a057=(a154*a057);
  a309=(a309-a057);
  a057=(a074*a262);
  a102=(a164*a076);
  a057=(a057+a102);
  a309=(a309+a057);
  a057=(a160*a309);
  a035=(a035+a057);
  a035=(a292+a035);
  a057=(a188*a035);
  a077=(a077+a057);
  a077=(a162+a077);
  a057=(a098*a077);
  a254=(a254-a057);
  a057=(a135*a301);
  a102=(a177*a010);
  a219=(a184*a033);
  a102=(a102+a219);
  a219=(a185*a250);
  a102=(a102+a219);
  a219=(a186*a028);
  a102=(a102+a219);
  a219=(a187*a299);
  a102=(a102+a219);
  a219=(a131*a019);
  a203=(a196*a308);
  a219=(a219+a203);
  a203=(a194*a304);
  a219=(a219+a203);
  a203=(a302*a018);
  a106=(a197*a027);
  a203=(a203-a106);
  a219=(a219+a203);
  a203=(a188*a219);
  a102=(a102+a203);
  a102=(a036+a102);
  a203=(a229*a102);
  a057=(a057+a203);
  a254=(a254+a057);
  a057=(a217*a254);
  a015=(a015+a057);
  a015=(a054+a015);
  a057=(a202*a015);
  a038=(a038+a057);
  a057=(a234*a289);
  a203=(a241*a017);
  a057=(a057+a203);
  a203=(a242*a257);
  a057=(a057+a203);
  a203=(a243*a286);
  a057=(a057+a203);
  a203=(a244*a227);
  a057=(a057+a203);
  a203=(a245*a179);
  a057=(a057+a203);
  a203=(a246*a254);
  a057=(a057+a203);
  a203=(a205*a054);
  a106=(a212*a290);
  a203=(a203+a106);
  a106=(a213*a149);
  a203=(a203+a106);
  a106=(a214*a228);
  a203=(a203+a106);
  a106=(a215*a262);
  a203=(a203+a106);
  a106=(a216*a018);
  a203=(a203+a106);
  a106=(a217*a301);
  a203=(a203+a106);
  a203=(a285+a203);
  a106=(a268*a203);
  a232=(a205*a036);
  a137=(a212*a201);
  a232=(a232+a137);
  a137=(a213*a175);
  a232=(a232+a137);
  a137=(a214*a047);
  a232=(a232+a137);
  a137=(a215*a076);
  a232=(a232+a137);
  a137=(a216*a027);
  a232=(a232+a137);
  a137=(a217*a102);
  a232=(a232+a137);
  a232=(a198+a232);
  a137=(a263*a232);
  a106=(a106+a137);
  a137=(a205*a292);
  a072=(a212*a236);
  a137=(a137+a072);
  a072=(a213*a269);
  a137=(a137+a072);
  a072=(a214*a207);
  a137=(a137+a072);
  a072=(a215*a173);
  a137=(a137+a072);
  a072=(a216*a035);
  a137=(a137+a072);
  a072=(a177*a009);
  a004=(a184*a116);
  a072=(a072+a004);
  a004=(a185*a260);
  a072=(a072+a004);
  a004=(a186*a128);
  a072=(a072+a004);
  a004=(a187*a309);
  a072=(a072+a004);
  a019=(a178*a019);
  a308=(a193*a308);
  a019=(a019+a308);
  a304=(a180*a304);
  a019=(a019-a304);
  a304=(a303*a018);
  a308=(a192*a027);
  a304=(a304+a308);
  a019=(a019+a304);
  a304=(a188*a019);
  a072=(a072+a304);
  a072=(a292+a072);
  a304=(a217*a072);
  a137=(a137+a304);
  a137=(a162+a137);
  a304=(a141*a137);
  a106=(a106-a304);
  a304=(a161*a015);
  a308=(a205*a010);
  a004=(a212*a033);
  a308=(a308+a004);
  a004=(a213*a250);
  a308=(a308+a004);
  a004=(a214*a028);
  a308=(a308+a004);
  a004=(a215*a299);
  a308=(a308+a004);
  a004=(a216*a219);
  a308=(a308+a004);
  a004=(a156*a069);
  a073=(a225*a153);
  a004=(a004+a073);
  a073=(a223*a077);
  a004=(a004+a073);
  a073=(a306*a301);
  a170=(a226*a102);
  a073=(a073-a170);
  a004=(a004+a073);
  a073=(a217*a004);
  a308=(a308+a073);
  a308=(a036+a308);
  a073=(a259*a308);
  a304=(a304+a073);
  a106=(a106+a304);
  a304=(a247*a106);
  a057=(a057+a304);
  a057=(a054+a057);
  a304=(a231*a057);
  a038=(a038+a304);
  a304=(a264*a289);
  a017=(a271*a017);
  a304=(a304+a017);
  a257=(a100*a257);
  a304=(a304+a257);
  a257=(a122*a286);
  a304=(a304+a257);
  a257=(a272*a227);
  a304=(a304+a257);
  a257=(a273*a179);
  a304=(a304+a257);
  a257=(a274*a254);
  a304=(a304+a257);
  a257=(a275*a106);
  a304=(a304+a257);
  a257=(a234*a054);
  a017=(a241*a290);
  a257=(a257+a017);
  a017=(a242*a149);
  a257=(a257+a017);
  a017=(a243*a228);
  a257=(a257+a017);
  a017=(a244*a262);
  a257=(a257+a017);
  a017=(a245*a018);
  a257=(a257+a017);
  a017=(a246*a301);
  a257=(a257+a017);
  a017=(a247*a015);
  a257=(a257+a017);
  a257=(a285+a257);
  a017=(a296*a257);
  a073=(a234*a036);
  a170=(a241*a201);
  a073=(a073+a170);
  a170=(a242*a175);
  a073=(a073+a170);
  a170=(a243*a047);
  a073=(a073+a170);
  a170=(a244*a076);
  a073=(a073+a170);
  a170=(a245*a027);
  a073=(a073+a170);
  a170=(a246*a102);
  a073=(a073+a170);
  a170=(a247*a308);
  a073=(a073+a170);
  a073=(a198+a073);
  a170=(a291*a073);
  a017=(a017+a170);
  a170=(a234*a292);
  a305=(a241*a236);
  a170=(a170+a305);
  a305=(a242*a269);
  a170=(a170+a305);
  a305=(a243*a207);
  a170=(a170+a305);
  a305=(a244*a173);
  a170=(a170+a305);
  a305=(a245*a035);
  a170=(a170+a305);
  a305=(a246*a072);
  a170=(a170+a305);
  a305=(a205*a009);
  a144=(a212*a116);
  a305=(a305+a144);
  a144=(a213*a260);
  a305=(a305+a144);
  a144=(a214*a128);
  a305=(a305+a144);
  a144=(a215*a309);
  a305=(a305+a144);
  a144=(a216*a019);
  a305=(a305+a144);
  a069=(a206*a069);
  a153=(a222*a153);
  a069=(a069+a153);
  a077=(a208*a077);
  a069=(a069-a077);
  a077=(a307*a301);
  a153=(a221*a102);
  a077=(a077+a153);
  a069=(a069+a077);
  a077=(a217*a069);
  a305=(a305+a077);
  a305=(a292+a305);
  a077=(a247*a305);
  a170=(a170+a077);
  a170=(a162+a170);
  a077=(a248*a170);
  a017=(a017-a077);
  a077=(a189*a057);
  a153=(a234*a010);
  a144=(a241*a033);
  a153=(a153+a144);
  a144=(a242*a250);
  a153=(a153+a144);
  a144=(a243*a028);
  a153=(a153+a144);
  a144=(a244*a299);
  a153=(a153+a144);
  a144=(a245*a219);
  a153=(a153+a144);
  a144=(a246*a004);
  a153=(a153+a144);
  a144=(a182*a203);
  a000=(a255*a232);
  a144=(a144+a000);
  a000=(a253*a137);
  a144=(a144+a000);
  a000=(a310*a015);
  a171=(a256*a308);
  a000=(a000-a171);
  a144=(a144+a000);
  a000=(a247*a144);
  a153=(a153+a000);
  a153=(a036+a153);
  a000=(a287*a153);
  a077=(a077+a000);
  a017=(a017+a077);
  a077=(a276*a017);
  a304=(a304+a077);
  a304=(a054+a304);
  a077=(a261*a304);
  a038=(a038+a077);
  a038=(a285+a038);
  if (res[0]!=0) res[0][24]=a038;
  a038=(a001*a036);
  a077=(a005*a047);
  a038=(a038+a077);
  a077=(a123*a076);
  a038=(a038+a077);
  a077=(a148*a027);
  a038=(a038+a077);
  a077=(a174*a102);
  a038=(a038+a077);
  a077=(a202*a308);
  a038=(a038+a077);
  a077=(a231*a153);
  a038=(a038+a077);
  a077=(a264*a010);
  a033=(a271*a033);
  a077=(a077+a033);
  a250=(a100*a250);
  a077=(a077+a250);
  a250=(a122*a028);
  a077=(a077+a250);
  a250=(a272*a299);
  a077=(a077+a250);
  a250=(a273*a219);
  a077=(a077+a250);
  a250=(a274*a004);
  a077=(a077+a250);
  a250=(a275*a144);
  a077=(a077+a250);
  a250=(a265*a257);
  a033=(a283*a073);
  a250=(a250+a033);
  a033=(a281*a170);
  a250=(a250+a033);
  a033=(a312*a057);
  a000=(a284*a153);
  a033=(a033-a000);
  a250=(a250+a033);
  a033=(a276*a250);
  a077=(a077+a033);
  a077=(a036+a077);
  a033=(a261*a077);
  a038=(a038+a033);
  a038=(a198+a038);
  if (res[0]!=0) res[0][25]=a038;
  a038=(a001*a292);
  a033=(a005*a207);
  a038=(a038+a033);
  a033=(a123*a173);
  a038=(a038+a033);
  a033=(a148*a035);
  a038=(a038+a033);
  a033=(a174*a072);
  a038=(a038+a033);
  a033=(a202*a305);
  a038=(a038+a033);
  a033=(a234*a009);
  a000=(a241*a116);
  a033=(a033+a000);
  a000=(a242*a260);
  a033=(a033+a000);
  a000=(a243*a128);
  a033=(a033+a000);
  a000=(a244*a309);
  a033=(a033+a000);
  a000=(a245*a019);
  a033=(a033+a000);
  a000=(a246*a069);
  a033=(a033+a000);
  a203=(a235*a203);
  a232=(a252*a232);
  a203=(a203+a232);
  a137=(a237*a137);
  a203=(a203-a137);
  a137=(a311*a015);
  a232=(a251*a308);
  a137=(a137+a232);
  a203=(a203+a137);
  a137=(a247*a203);
  a033=(a033+a137);
  a033=(a292+a033);
  a137=(a231*a033);
  a038=(a038+a137);
  a137=(a264*a009);
  a116=(a271*a116);
  a137=(a137+a116);
  a260=(a100*a260);
  a137=(a137+a260);
  a260=(a122*a128);
  a137=(a137+a260);
  a260=(a272*a309);
  a137=(a137+a260);
  a260=(a273*a019);
  a137=(a137+a260);
  a260=(a274*a069);
  a137=(a137+a260);
  a260=(a275*a203);
  a137=(a137+a260);
  a257=(a061*a257);
  a073=(a280*a073);
  a257=(a257+a073);
  a170=(a120*a170);
  a257=(a257-a170);
  a170=(a313*a057);
  a073=(a279*a153);
  a170=(a170+a073);
  a257=(a257+a170);
  a170=(a276*a257);
  a137=(a137+a170);
  a137=(a292+a137);
  a137=(a261*a137);
  a038=(a038+a137);
  a038=(a162+a038);
  if (res[0]!=0) res[0][26]=a038;
  a289=(a001*a289);
  a286=(a005*a286);
  a289=(a289+a286);
  a227=(a123*a227);
  a289=(a289+a227);
  a179=(a148*a179);
  a289=(a289+a179);
  a254=(a174*a254);
  a289=(a289+a254);
  a106=(a202*a106);
  a289=(a289+a106);
  a017=(a231*a017);
  a289=(a289+a017);
  a017=(a264*a054);
  a290=(a271*a290);
  a017=(a017+a290);
  a149=(a100*a149);
  a017=(a017+a149);
  a228=(a122*a228);
  a017=(a017+a228);
  a262=(a272*a262);
  a017=(a017+a262);
  a018=(a273*a018);
  a017=(a017+a018);
  a301=(a274*a301);
  a017=(a017+a301);
  a015=(a275*a015);
  a017=(a017+a015);
  a057=(a276*a057);
  a017=(a017+a057);
  a285=(a285+a017);
  a017=(a029*a285);
  a057=(a264*a036);
  a201=(a271*a201);
  a057=(a057+a201);
  a175=(a100*a175);
  a057=(a057+a175);
  a047=(a122*a047);
  a057=(a057+a047);
  a076=(a272*a076);
  a057=(a057+a076);
  a027=(a273*a027);
  a057=(a057+a027);
  a102=(a274*a102);
  a057=(a057+a102);
  a308=(a275*a308);
  a057=(a057+a308);
  a153=(a276*a153);
  a057=(a057+a153);
  a198=(a198+a057);
  a057=(a297*a198);
  a017=(a017+a057);
  a057=(a264*a292);
  a236=(a271*a236);
  a057=(a057+a236);
  a269=(a100*a269);
  a057=(a057+a269);
  a207=(a122*a207);
  a057=(a057+a207);
  a173=(a272*a173);
  a057=(a057+a173);
  a035=(a273*a035);
  a057=(a057+a035);
  a072=(a274*a072);
  a057=(a057+a072);
  a305=(a275*a305);
  a057=(a057+a305);
  a033=(a276*a033);
  a057=(a057+a033);
  a162=(a162+a057);
  a057=(a294*a162);
  a017=(a017-a057);
  a057=(a266*a304);
  a033=(a082*a077);
  a057=(a057+a033);
  a017=(a017+a057);
  a017=(a261*a017);
  a289=(a289+a017);
  a054=(a054+a289);
  if (res[0]!=0) res[0][27]=a054;
  a010=(a001*a010);
  a028=(a005*a028);
  a010=(a010+a028);
  a299=(a123*a299);
  a010=(a010+a299);
  a219=(a148*a219);
  a010=(a010+a219);
  a004=(a174*a004);
  a010=(a010+a004);
  a144=(a202*a144);
  a010=(a010+a144);
  a250=(a231*a250);
  a010=(a010+a250);
  a250=(a199*a285);
  a144=(a031*a198);
  a250=(a250+a144);
  a144=(a007*a162);
  a250=(a250+a144);
  a144=(a167*a304);
  a004=(a032*a077);
  a144=(a144-a004);
  a250=(a250+a144);
  a250=(a261*a250);
  a010=(a010+a250);
  a036=(a036+a010);
  if (res[0]!=0) res[0][28]=a036;
  a009=(a001*a009);
  a128=(a005*a128);
  a009=(a009+a128);
  a309=(a123*a309);
  a009=(a009+a309);
  a019=(a148*a019);
  a009=(a009+a019);
  a069=(a174*a069);
  a009=(a009+a069);
  a203=(a202*a203);
  a009=(a009+a203);
  a257=(a231*a257);
  a009=(a009+a257);
  a285=(a258*a285);
  a198=(a230*a198);
  a285=(a285+a198);
  a162=(a041*a162);
  a285=(a285-a162);
  a304=(a136*a304);
  a077=(a021*a077);
  a304=(a304+a077);
  a285=(a285+a304);
  a285=(a261*a285);
  a009=(a009+a285);
  a292=(a292+a009);
  if (res[0]!=0) res[0][29]=a292;
  a292=arg[0]? arg[0][30] : 0;
  a009=arg[0]? arg[0][33] : 0;
  a285=(a001*a009);
  a040=(a040*a292);
  a304=arg[0]? arg[0][31] : 0;
  a026=(a026*a304);
  a040=(a040+a026);
  a026=arg[0]? arg[0][32] : 0;
  a016=(a016*a026);
  a040=(a040-a016);
  a278=(a278*a009);
  a016=arg[0]? arg[0][34] : 0;
  a022=(a022*a016);
  a278=(a278+a022);
  a040=(a040+a278);
  a278=(a006*a040);
  a022=(a043*a009);
  a077=(a046*a040);
  a162=(a049*a009);
  a162=(a292+a162);
  a071=(a071*a162);
  a198=(a049*a016);
  a198=(a304+a198);
  a066=(a066*a198);
  a071=(a071+a066);
  a066=arg[0]? arg[0][35] : 0;
  a257=(a049*a066);
  a257=(a026+a257);
  a163=(a163*a257);
  a071=(a071-a163);
  a163=(a049*a040);
  a163=(a009+a163);
  a078=(a078*a163);
  a190=(a190*a292);
  a014=(a014*a304);
  a190=(a190+a014);
  a020=(a020*a026);
  a190=(a190+a020);
  a220=(a220*a009);
  a034=(a034*a016);
  a220=(a220-a034);
  a190=(a190+a220);
  a220=(a049*a190);
  a220=(a016+a220);
  a062=(a062*a220);
  a078=(a078+a062);
  a071=(a071+a078);
  a071=(a048*a071);
  a077=(a077+a071);
  a077=(a009+a077);
  a071=(a045*a077);
  a022=(a022+a071);
  a022=(a292+a022);
  a108=(a108*a022);
  a071=(a043*a016);
  a078=(a046*a190);
  a013=(a013*a162);
  a058=(a058*a198);
  a013=(a013+a058);
  a056=(a056*a257);
  a013=(a013+a056);
  a042=(a042*a163);
  a059=(a059*a220);
  a042=(a042-a059);
  a013=(a013+a042);
  a013=(a048*a013);
  a078=(a078+a013);
  a078=(a016+a078);
  a013=(a045*a078);
  a071=(a071+a013);
  a071=(a304+a071);
  a103=(a103*a071);
  a108=(a108+a103);
  a103=(a043*a066);
  a249=(a249*a292);
  a012=(a012*a304);
  a249=(a249+a012);
  a277=(a277*a026);
  a249=(a249-a277);
  a191=(a191*a009);
  a011=(a011*a016);
  a191=(a191+a011);
  a249=(a249+a191);
  a191=(a046*a249);
  a003=(a003*a162);
  a055=(a055*a198);
  a003=(a003+a055);
  a093=(a093*a257);
  a003=(a003-a093);
  a300=(a300*a163);
  a053=(a053*a220);
  a300=(a300+a053);
  a003=(a003+a300);
  a003=(a048*a003);
  a191=(a191+a003);
  a191=(a066+a191);
  a003=(a045*a191);
  a103=(a103+a003);
  a103=(a026+a103);
  a068=(a068*a103);
  a108=(a108-a068);
  a068=(a043*a040);
  a003=(a046*a009);
  a163=(a048*a163);
  a003=(a003+a163);
  a003=(a292+a003);
  a089=(a089*a003);
  a163=(a046*a016);
  a220=(a048*a220);
  a163=(a163+a220);
  a163=(a304+a163);
  a063=(a063*a163);
  a089=(a089+a063);
  a046=(a046*a066);
  a049=(a049*a249);
  a049=(a066+a049);
  a048=(a048*a049);
  a046=(a046+a048);
  a046=(a026+a046);
  a081=(a081*a046);
  a089=(a089-a081);
  a183=(a183*a077);
  a052=(a052*a078);
  a183=(a183+a052);
  a089=(a089+a183);
  a183=(a045*a089);
  a068=(a068+a183);
  a068=(a009+a068);
  a023=(a023*a068);
  a183=(a043*a190);
  a240=(a240*a003);
  a075=(a075*a163);
  a240=(a240+a075);
  a060=(a060*a046);
  a240=(a240+a060);
  a110=(a110*a077);
  a083=(a083*a078);
  a110=(a110-a083);
  a240=(a240+a110);
  a110=(a045*a240);
  a183=(a183+a110);
  a183=(a016+a183);
  a099=(a099*a183);
  a023=(a023+a099);
  a108=(a108+a023);
  a023=(a030*a108);
  a278=(a278+a023);
  a023=(a104*a009);
  a099=(a051*a077);
  a023=(a023+a099);
  a099=(a084*a068);
  a023=(a023+a099);
  a023=(a292+a023);
  a130=(a130*a023);
  a099=(a104*a016);
  a110=(a051*a078);
  a099=(a099+a110);
  a110=(a084*a183);
  a099=(a099+a110);
  a099=(a304+a099);
  a125=(a125*a099);
  a130=(a130+a125);
  a125=(a104*a066);
  a191=(a051*a191);
  a125=(a125+a191);
  a043=(a043*a249);
  a094=(a094*a003);
  a080=(a080*a163);
  a094=(a094+a080);
  a065=(a065*a046);
  a094=(a094-a065);
  a147=(a147*a077);
  a067=(a067*a078);
  a147=(a147+a067);
  a094=(a094+a147);
  a045=(a045*a094);
  a043=(a043+a045);
  a043=(a066+a043);
  a045=(a084*a043);
  a125=(a125+a045);
  a125=(a026+a125);
  a091=(a091*a125);
  a130=(a130-a091);
  a091=(a104*a040);
  a089=(a051*a089);
  a091=(a091+a089);
  a089=(a084*a108);
  a091=(a091+a089);
  a091=(a009+a091);
  a025=(a025*a091);
  a089=(a104*a190);
  a240=(a051*a240);
  a089=(a089+a240);
  a008=(a008*a022);
  a095=(a095*a071);
  a008=(a008+a095);
  a070=(a070*a103);
  a008=(a008+a070);
  a112=(a112*a068);
  a096=(a096*a183);
  a112=(a112-a096);
  a008=(a008+a112);
  a112=(a084*a008);
  a089=(a089+a112);
  a089=(a016+a089);
  a121=(a121*a089);
  a025=(a025+a121);
  a130=(a130+a025);
  a025=(a101*a130);
  a278=(a278+a025);
  a278=(a009+a278);
  a025=(a005*a278);
  a285=(a285+a025);
  a025=(a126*a040);
  a121=(a132*a108);
  a025=(a025+a121);
  a121=(a133*a130);
  a025=(a025+a121);
  a121=(a006*a009);
  a112=(a030*a068);
  a121=(a121+a112);
  a112=(a101*a091);
  a121=(a121+a112);
  a121=(a292+a121);
  a155=(a155*a121);
  a112=(a006*a016);
  a096=(a030*a183);
  a112=(a112+a096);
  a096=(a101*a089);
  a112=(a112+a096);
  a112=(a304+a112);
  a150=(a150*a112);
  a155=(a155+a150);
  a150=(a006*a066);
  a096=(a030*a043);
  a150=(a150+a096);
  a104=(a104*a249);
  a051=(a051*a094);
  a104=(a104+a051);
  a039=(a039*a022);
  a092=(a092*a071);
  a039=(a039+a092);
  a111=(a111*a103);
  a039=(a039-a111);
  a298=(a298*a068);
  a090=(a090*a183);
  a298=(a298+a090);
  a039=(a039+a298);
  a084=(a084*a039);
  a104=(a104+a084);
  a104=(a066+a104);
  a084=(a101*a104);
  a150=(a150+a084);
  a150=(a026+a150);
  a114=(a114*a150);
  a155=(a155-a114);
  a037=(a037*a278);
  a114=(a006*a190);
  a084=(a030*a008);
  a114=(a114+a084);
  a044=(a044*a023);
  a117=(a117*a099);
  a044=(a044+a117);
  a115=(a115*a125);
  a044=(a044+a115);
  a270=(a270*a091);
  a118=(a118*a089);
  a270=(a270-a118);
  a044=(a044+a270);
  a270=(a101*a044);
  a114=(a114+a270);
  a114=(a016+a114);
  a146=(a146*a114);
  a037=(a037+a146);
  a155=(a155+a037);
  a037=(a134*a155);
  a025=(a025+a037);
  a025=(a009+a025);
  a037=(a123*a025);
  a285=(a285+a037);
  a037=(a151*a040);
  a146=(a088*a108);
  a037=(a037+a146);
  a146=(a158*a130);
  a037=(a037+a146);
  a146=(a159*a155);
  a037=(a037+a146);
  a146=(a126*a009);
  a270=(a132*a068);
  a146=(a146+a270);
  a270=(a133*a091);
  a146=(a146+a270);
  a270=(a134*a278);
  a146=(a146+a270);
  a146=(a292+a146);
  a181=(a181*a146);
  a270=(a126*a016);
  a118=(a132*a183);
  a270=(a270+a118);
  a118=(a133*a089);
  a270=(a270+a118);
  a118=(a134*a114);
  a270=(a270+a118);
  a270=(a304+a270);
  a176=(a176*a270);
  a181=(a181+a176);
  a176=(a126*a066);
  a118=(a132*a043);
  a176=(a176+a118);
  a118=(a133*a104);
  a176=(a176+a118);
  a006=(a006*a249);
  a030=(a030*a039);
  a006=(a006+a030);
  a107=(a107*a023);
  a079=(a079*a099);
  a107=(a107+a079);
  a157=(a157*a125);
  a107=(a107-a157);
  a064=(a064*a091);
  a113=(a113*a089);
  a064=(a064+a113);
  a107=(a107+a064);
  a101=(a101*a107);
  a006=(a006+a101);
  a006=(a066+a006);
  a101=(a134*a006);
  a176=(a176+a101);
  a176=(a026+a176);
  a050=(a050*a176);
  a181=(a181-a050);
  a105=(a105*a025);
  a050=(a126*a190);
  a101=(a132*a008);
  a050=(a050+a101);
  a101=(a133*a044);
  a050=(a050+a101);
  a109=(a109*a121);
  a142=(a142*a112);
  a109=(a109+a142);
  a140=(a140*a150);
  a109=(a109+a140);
  a087=(a087*a278);
  a143=(a143*a114);
  a087=(a087-a143);
  a109=(a109+a087);
  a087=(a134*a109);
  a050=(a050+a087);
  a050=(a016+a050);
  a172=(a172*a050);
  a105=(a105+a172);
  a181=(a181+a105);
  a105=(a160*a181);
  a037=(a037+a105);
  a037=(a009+a037);
  a105=(a148*a037);
  a285=(a285+a105);
  a105=(a177*a040);
  a172=(a184*a108);
  a105=(a105+a172);
  a172=(a185*a130);
  a105=(a105+a172);
  a172=(a186*a155);
  a105=(a105+a172);
  a172=(a187*a181);
  a105=(a105+a172);
  a172=(a151*a009);
  a087=(a088*a068);
  a172=(a172+a087);
  a087=(a158*a091);
  a172=(a172+a087);
  a087=(a159*a278);
  a172=(a172+a087);
  a087=(a160*a025);
  a172=(a172+a087);
  a172=(a292+a172);
  a209=(a209*a172);
  a087=(a151*a016);
  a143=(a088*a183);
  a087=(a087+a143);
  a143=(a158*a089);
  a087=(a087+a143);
  a143=(a159*a114);
  a087=(a087+a143);
  a143=(a160*a050);
  a087=(a087+a143);
  a087=(a304+a087);
  a204=(a204*a087);
  a209=(a209+a204);
  a204=(a151*a066);
  a143=(a088*a043);
  a204=(a204+a143);
  a143=(a158*a104);
  a204=(a204+a143);
  a143=(a159*a006);
  a204=(a204+a143);
  a126=(a126*a249);
  a132=(a132*a039);
  a126=(a126+a132);
  a133=(a133*a107);
  a126=(a126+a133);
  a129=(a129*a121);
  a139=(a139*a112);
  a129=(a129+a139);
  a124=(a124*a150);
  a129=(a129-a124);
  a085=(a085*a278);
  a138=(a138*a114);
  a085=(a085+a138);
  a129=(a129+a085);
  a134=(a134*a129);
  a126=(a126+a134);
  a126=(a066+a126);
  a134=(a160*a126);
  a204=(a204+a134);
  a204=(a026+a204);
  a086=(a086*a204);
  a209=(a209-a086);
  a127=(a127*a037);
  a086=(a151*a190);
  a134=(a088*a008);
  a086=(a086+a134);
  a134=(a158*a044);
  a086=(a086+a134);
  a134=(a159*a109);
  a086=(a086+a134);
  a024=(a024*a146);
  a168=(a168*a270);
  a024=(a024+a168);
  a166=(a166*a176);
  a024=(a024+a166);
  a211=(a211*a025);
  a169=(a169*a050);
  a211=(a211-a169);
  a024=(a024+a211);
  a211=(a160*a024);
  a086=(a086+a211);
  a086=(a016+a086);
  a200=(a200*a086);
  a127=(a127+a200);
  a209=(a209+a127);
  a127=(a188*a209);
  a105=(a105+a127);
  a105=(a009+a105);
  a127=(a174*a105);
  a285=(a285+a127);
  a127=(a205*a040);
  a200=(a212*a108);
  a127=(a127+a200);
  a200=(a213*a130);
  a127=(a127+a200);
  a200=(a214*a155);
  a127=(a127+a200);
  a200=(a215*a181);
  a127=(a127+a200);
  a200=(a216*a209);
  a127=(a127+a200);
  a200=(a177*a009);
  a211=(a184*a068);
  a200=(a200+a211);
  a211=(a185*a091);
  a200=(a200+a211);
  a211=(a186*a278);
  a200=(a200+a211);
  a211=(a187*a025);
  a200=(a200+a211);
  a211=(a188*a037);
  a200=(a200+a211);
  a200=(a292+a200);
  a238=(a238*a200);
  a211=(a177*a016);
  a169=(a184*a183);
  a211=(a211+a169);
  a169=(a185*a089);
  a211=(a211+a169);
  a169=(a186*a114);
  a211=(a211+a169);
  a169=(a187*a050);
  a211=(a211+a169);
  a169=(a188*a086);
  a211=(a211+a169);
  a211=(a304+a211);
  a233=(a233*a211);
  a238=(a238+a233);
  a233=(a177*a066);
  a169=(a184*a043);
  a233=(a233+a169);
  a169=(a185*a104);
  a233=(a233+a169);
  a169=(a186*a006);
  a233=(a233+a169);
  a169=(a187*a126);
  a233=(a233+a169);
  a151=(a151*a249);
  a088=(a088*a039);
  a151=(a151+a088);
  a158=(a158*a107);
  a151=(a151+a158);
  a159=(a159*a129);
  a151=(a151+a159);
  a152=(a152*a146);
  a165=(a165*a270);
  a152=(a152+a165);
  a154=(a154*a176);
  a152=(a152-a154);
  a074=(a074*a025);
  a164=(a164*a050);
  a074=(a074+a164);
  a152=(a152+a074);
  a160=(a160*a152);
  a151=(a151+a160);
  a151=(a066+a151);
  a160=(a188*a151);
  a233=(a233+a160);
  a233=(a026+a233);
  a098=(a098*a233);
  a238=(a238-a098);
  a135=(a135*a105);
  a098=(a177*a190);
  a160=(a184*a008);
  a098=(a098+a160);
  a160=(a185*a044);
  a098=(a098+a160);
  a160=(a186*a109);
  a098=(a098+a160);
  a160=(a187*a024);
  a098=(a098+a160);
  a131=(a131*a172);
  a196=(a196*a087);
  a131=(a131+a196);
  a194=(a194*a204);
  a131=(a131+a194);
  a302=(a302*a037);
  a197=(a197*a086);
  a302=(a302-a197);
  a131=(a131+a302);
  a302=(a188*a131);
  a098=(a098+a302);
  a098=(a016+a098);
  a229=(a229*a098);
  a135=(a135+a229);
  a238=(a238+a135);
  a135=(a217*a238);
  a127=(a127+a135);
  a127=(a009+a127);
  a135=(a202*a127);
  a285=(a285+a135);
  a135=(a234*a040);
  a229=(a241*a108);
  a135=(a135+a229);
  a229=(a242*a130);
  a135=(a135+a229);
  a229=(a243*a155);
  a135=(a135+a229);
  a229=(a244*a181);
  a135=(a135+a229);
  a229=(a245*a209);
  a135=(a135+a229);
  a229=(a246*a238);
  a135=(a135+a229);
  a229=(a205*a009);
  a302=(a212*a068);
  a229=(a229+a302);
  a302=(a213*a091);
  a229=(a229+a302);
  a302=(a214*a278);
  a229=(a229+a302);
  a302=(a215*a025);
  a229=(a229+a302);
  a302=(a216*a037);
  a229=(a229+a302);
  a302=(a217*a105);
  a229=(a229+a302);
  a229=(a292+a229);
  a268=(a268*a229);
  a302=(a205*a016);
  a197=(a212*a183);
  a302=(a302+a197);
  a197=(a213*a089);
  a302=(a302+a197);
  a197=(a214*a114);
  a302=(a302+a197);
  a197=(a215*a050);
  a302=(a302+a197);
  a197=(a216*a086);
  a302=(a302+a197);
  a197=(a217*a098);
  a302=(a302+a197);
  a302=(a304+a302);
  a263=(a263*a302);
  a268=(a268+a263);
  a263=(a205*a066);
  a197=(a212*a043);
  a263=(a263+a197);
  a197=(a213*a104);
  a263=(a263+a197);
  a197=(a214*a006);
  a263=(a263+a197);
  a197=(a215*a126);
  a263=(a263+a197);
  a197=(a216*a151);
  a263=(a263+a197);
  a177=(a177*a249);
  a184=(a184*a039);
  a177=(a177+a184);
  a185=(a185*a107);
  a177=(a177+a185);
  a186=(a186*a129);
  a177=(a177+a186);
  a187=(a187*a152);
  a177=(a177+a187);
  a178=(a178*a172);
  a193=(a193*a087);
  a178=(a178+a193);
  a180=(a180*a204);
  a178=(a178-a180);
  a303=(a303*a037);
  a192=(a192*a086);
  a303=(a303+a192);
  a178=(a178+a303);
  a188=(a188*a178);
  a177=(a177+a188);
  a177=(a066+a177);
  a188=(a217*a177);
  a263=(a263+a188);
  a263=(a026+a263);
  a141=(a141*a263);
  a268=(a268-a141);
  a161=(a161*a127);
  a141=(a205*a190);
  a188=(a212*a008);
  a141=(a141+a188);
  a188=(a213*a044);
  a141=(a141+a188);
  a188=(a214*a109);
  a141=(a141+a188);
  a188=(a215*a024);
  a141=(a141+a188);
  a188=(a216*a131);
  a141=(a141+a188);
  a156=(a156*a200);
  a225=(a225*a211);
  a156=(a156+a225);
  a223=(a223*a233);
  a156=(a156+a223);
  a306=(a306*a105);
  a226=(a226*a098);
  a306=(a306-a226);
  a156=(a156+a306);
  a306=(a217*a156);
  a141=(a141+a306);
  a141=(a016+a141);
  a259=(a259*a141);
  a161=(a161+a259);
  a268=(a268+a161);
  a161=(a247*a268);
  a135=(a135+a161);
  a135=(a009+a135);
  a161=(a231*a135);
  a285=(a285+a161);
  a161=(a264*a040);
  a108=(a271*a108);
  a161=(a161+a108);
  a130=(a100*a130);
  a161=(a161+a130);
  a130=(a122*a155);
  a161=(a161+a130);
  a130=(a272*a181);
  a161=(a161+a130);
  a130=(a273*a209);
  a161=(a161+a130);
  a130=(a274*a238);
  a161=(a161+a130);
  a130=(a275*a268);
  a161=(a161+a130);
  a130=(a234*a009);
  a108=(a241*a068);
  a130=(a130+a108);
  a108=(a242*a091);
  a130=(a130+a108);
  a108=(a243*a278);
  a130=(a130+a108);
  a108=(a244*a025);
  a130=(a130+a108);
  a108=(a245*a037);
  a130=(a130+a108);
  a108=(a246*a105);
  a130=(a130+a108);
  a108=(a247*a127);
  a130=(a130+a108);
  a130=(a292+a130);
  a296=(a296*a130);
  a108=(a234*a016);
  a259=(a241*a183);
  a108=(a108+a259);
  a259=(a242*a089);
  a108=(a108+a259);
  a259=(a243*a114);
  a108=(a108+a259);
  a259=(a244*a050);
  a108=(a108+a259);
  a259=(a245*a086);
  a108=(a108+a259);
  a259=(a246*a098);
  a108=(a108+a259);
  a259=(a247*a141);
  a108=(a108+a259);
  a108=(a304+a108);
  a291=(a291*a108);
  a296=(a296+a291);
  a291=(a234*a066);
  a259=(a241*a043);
  a291=(a291+a259);
  a259=(a242*a104);
  a291=(a291+a259);
  a259=(a243*a006);
  a291=(a291+a259);
  a259=(a244*a126);
  a291=(a291+a259);
  a259=(a245*a151);
  a291=(a291+a259);
  a259=(a246*a177);
  a291=(a291+a259);
  a205=(a205*a249);
  a212=(a212*a039);
  a205=(a205+a212);
  a213=(a213*a107);
  a205=(a205+a213);
  a214=(a214*a129);
  a205=(a205+a214);
  a215=(a215*a152);
  a205=(a205+a215);
  a216=(a216*a178);
  a205=(a205+a216);
  a206=(a206*a200);
  a222=(a222*a211);
  a206=(a206+a222);
  a208=(a208*a233);
  a206=(a206-a208);
  a307=(a307*a105);
  a221=(a221*a098);
  a307=(a307+a221);
  a206=(a206+a307);
  a217=(a217*a206);
  a205=(a205+a217);
  a205=(a066+a205);
  a217=(a247*a205);
  a291=(a291+a217);
  a291=(a026+a291);
  a248=(a248*a291);
  a296=(a296-a248);
  a189=(a189*a135);
  a248=(a234*a190);
  a217=(a241*a008);
  a248=(a248+a217);
  a217=(a242*a044);
  a248=(a248+a217);
  a217=(a243*a109);
  a248=(a248+a217);
  a217=(a244*a024);
  a248=(a248+a217);
  a217=(a245*a131);
  a248=(a248+a217);
  a217=(a246*a156);
  a248=(a248+a217);
  a182=(a182*a229);
  a255=(a255*a302);
  a182=(a182+a255);
  a253=(a253*a263);
  a182=(a182+a253);
  a310=(a310*a127);
  a256=(a256*a141);
  a310=(a310-a256);
  a182=(a182+a310);
  a310=(a247*a182);
  a248=(a248+a310);
  a248=(a016+a248);
  a287=(a287*a248);
  a189=(a189+a287);
  a296=(a296+a189);
  a189=(a276*a296);
  a161=(a161+a189);
  a161=(a009+a161);
  a189=(a261*a161);
  a285=(a285+a189);
  a285=(a292+a285);
  if (res[0]!=0) res[0][30]=a285;
  a285=(a001*a016);
  a189=(a005*a114);
  a285=(a285+a189);
  a189=(a123*a050);
  a285=(a285+a189);
  a189=(a148*a086);
  a285=(a285+a189);
  a189=(a174*a098);
  a285=(a285+a189);
  a189=(a202*a141);
  a285=(a285+a189);
  a189=(a231*a248);
  a285=(a285+a189);
  a189=(a264*a190);
  a008=(a271*a008);
  a189=(a189+a008);
  a044=(a100*a044);
  a189=(a189+a044);
  a044=(a122*a109);
  a189=(a189+a044);
  a044=(a272*a024);
  a189=(a189+a044);
  a044=(a273*a131);
  a189=(a189+a044);
  a044=(a274*a156);
  a189=(a189+a044);
  a044=(a275*a182);
  a189=(a189+a044);
  a265=(a265*a130);
  a283=(a283*a108);
  a265=(a265+a283);
  a281=(a281*a291);
  a265=(a265+a281);
  a312=(a312*a135);
  a284=(a284*a248);
  a312=(a312-a284);
  a265=(a265+a312);
  a312=(a276*a265);
  a189=(a189+a312);
  a189=(a016+a189);
  a312=(a261*a189);
  a285=(a285+a312);
  a285=(a304+a285);
  if (res[0]!=0) res[0][31]=a285;
  a285=(a001*a066);
  a312=(a005*a006);
  a285=(a285+a312);
  a312=(a123*a126);
  a285=(a285+a312);
  a312=(a148*a151);
  a285=(a285+a312);
  a312=(a174*a177);
  a285=(a285+a312);
  a312=(a202*a205);
  a285=(a285+a312);
  a234=(a234*a249);
  a241=(a241*a039);
  a234=(a234+a241);
  a242=(a242*a107);
  a234=(a234+a242);
  a243=(a243*a129);
  a234=(a234+a243);
  a244=(a244*a152);
  a234=(a234+a244);
  a245=(a245*a178);
  a234=(a234+a245);
  a246=(a246*a206);
  a234=(a234+a246);
  a235=(a235*a229);
  a252=(a252*a302);
  a235=(a235+a252);
  a237=(a237*a263);
  a235=(a235-a237);
  a311=(a311*a127);
  a251=(a251*a141);
  a311=(a311+a251);
  a235=(a235+a311);
  a247=(a247*a235);
  a234=(a234+a247);
  a234=(a066+a234);
  a247=(a231*a234);
  a285=(a285+a247);
  a247=(a264*a249);
  a039=(a271*a039);
  a247=(a247+a039);
  a107=(a100*a107);
  a247=(a247+a107);
  a107=(a122*a129);
  a247=(a247+a107);
  a107=(a272*a152);
  a247=(a247+a107);
  a107=(a273*a178);
  a247=(a247+a107);
  a107=(a274*a206);
  a247=(a247+a107);
  a107=(a275*a235);
  a247=(a247+a107);
  a061=(a061*a130);
  a280=(a280*a108);
  a061=(a061+a280);
  a120=(a120*a291);
  a061=(a061-a120);
  a313=(a313*a135);
  a279=(a279*a248);
  a313=(a313+a279);
  a061=(a061+a313);
  a313=(a276*a061);
  a247=(a247+a313);
  a247=(a066+a247);
  a247=(a261*a247);
  a285=(a285+a247);
  a285=(a026+a285);
  if (res[0]!=0) res[0][32]=a285;
  a040=(a001*a040);
  a155=(a005*a155);
  a040=(a040+a155);
  a181=(a123*a181);
  a040=(a040+a181);
  a209=(a148*a209);
  a040=(a040+a209);
  a238=(a174*a238);
  a040=(a040+a238);
  a268=(a202*a268);
  a040=(a040+a268);
  a296=(a231*a296);
  a040=(a040+a296);
  a296=(a264*a009);
  a068=(a271*a068);
  a296=(a296+a068);
  a091=(a100*a091);
  a296=(a296+a091);
  a278=(a122*a278);
  a296=(a296+a278);
  a025=(a272*a025);
  a296=(a296+a025);
  a037=(a273*a037);
  a296=(a296+a037);
  a105=(a274*a105);
  a296=(a296+a105);
  a127=(a275*a127);
  a296=(a296+a127);
  a135=(a276*a135);
  a296=(a296+a135);
  a292=(a292+a296);
  a029=(a029*a292);
  a296=(a264*a016);
  a183=(a271*a183);
  a296=(a296+a183);
  a089=(a100*a089);
  a296=(a296+a089);
  a114=(a122*a114);
  a296=(a296+a114);
  a050=(a272*a050);
  a296=(a296+a050);
  a086=(a273*a086);
  a296=(a296+a086);
  a098=(a274*a098);
  a296=(a296+a098);
  a141=(a275*a141);
  a296=(a296+a141);
  a248=(a276*a248);
  a296=(a296+a248);
  a304=(a304+a296);
  a297=(a297*a304);
  a029=(a029+a297);
  a264=(a264*a066);
  a271=(a271*a043);
  a264=(a264+a271);
  a100=(a100*a104);
  a264=(a264+a100);
  a122=(a122*a006);
  a264=(a264+a122);
  a272=(a272*a126);
  a264=(a264+a272);
  a273=(a273*a151);
  a264=(a264+a273);
  a274=(a274*a177);
  a264=(a264+a274);
  a275=(a275*a205);
  a264=(a264+a275);
  a276=(a276*a234);
  a264=(a264+a276);
  a026=(a026+a264);
  a294=(a294*a026);
  a029=(a029-a294);
  a266=(a266*a161);
  a082=(a082*a189);
  a266=(a266+a082);
  a029=(a029+a266);
  a029=(a261*a029);
  a040=(a040+a029);
  a009=(a009+a040);
  if (res[0]!=0) res[0][33]=a009;
  a190=(a001*a190);
  a109=(a005*a109);
  a190=(a190+a109);
  a024=(a123*a024);
  a190=(a190+a024);
  a131=(a148*a131);
  a190=(a190+a131);
  a156=(a174*a156);
  a190=(a190+a156);
  a182=(a202*a182);
  a190=(a190+a182);
  a265=(a231*a265);
  a190=(a190+a265);
  a199=(a199*a292);
  a031=(a031*a304);
  a199=(a199+a031);
  a007=(a007*a026);
  a199=(a199+a007);
  a167=(a167*a161);
  a032=(a032*a189);
  a167=(a167-a032);
  a199=(a199+a167);
  a199=(a261*a199);
  a190=(a190+a199);
  a016=(a016+a190);
  if (res[0]!=0) res[0][34]=a016;
  a001=(a001*a249);
  a005=(a005*a129);
  a001=(a001+a005);
  a123=(a123*a152);
  a001=(a001+a123);
  a148=(a148*a178);
  a001=(a001+a148);
  a174=(a174*a206);
  a001=(a001+a174);
  a202=(a202*a235);
  a001=(a001+a202);
  a231=(a231*a061);
  a001=(a001+a231);
  a258=(a258*a292);
  a230=(a230*a304);
  a258=(a258+a230);
  a041=(a041*a026);
  a258=(a258-a041);
  a136=(a136*a161);
  a021=(a021*a189);
  a136=(a136+a021);
  a258=(a258+a136);
  a261=(a261*a258);
  a001=(a001+a261);
  a066=(a066+a001);
  if (res[0]!=0) res[0][35]=a066;
  return 0;
}

/* variational_steps:(y[6x6],t,turns[2x12],h,p[8])->(y_end[6x6]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+314, w1, *w3=w+350, w5, *w6=w+352, w7;
  const casadi_real **arg1=arg+5, *wr0, *wr2, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  wr2 = arg[4] ? arg[4] : casadi_zeros;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  wr4 = arg[2] ? arg[2] : casadi_zeros;
  /* #5: @5 = input[3][0] */
  w5 = arg[3] ? arg[3][0] : 0;
  /* #6: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=wr0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #14: @7 = 3 */
  w7 = 3.;
  /* #15: @7 = (@7*@5) */
  w7 *= w5;
  /* #16: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #17: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #19: @7 = 4 */
  w7 = 4.;
  /* #20: @7 = (@7*@5) */
  w7 *= w5;
  /* #21: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #22: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = 5 */
  w7 = 5.;
  /* #25: @7 = (@7*@5) */
  w7 *= w5;
  /* #26: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #27: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #29: @7 = 6 */
  w7 = 6.;
  /* #30: @7 = (@7*@5) */
  w7 *= w5;
  /* #31: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #32: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = 7 */
  w7 = 7.;
  /* #35: @7 = (@7*@5) */
  w7 *= w5;
  /* #36: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #37: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #39: @7 = 8 */
  w7 = 8.;
  /* #40: @7 = (@7*@5) */
  w7 *= w5;
  /* #41: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #42: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #44: @7 = 9 */
  w7 = 9.;
  /* #45: @7 = (@7*@5) */
  w7 *= w5;
  /* #46: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #47: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #49: @7 = 10 */
  w7 = 10.;
  /* #50: @7 = (@7*@5) */
  w7 *= w5;
  /* #51: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #52: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = 11 */
  w7 = 11.;
  /* #55: @7 = (@7*@5) */
  w7 *= w5;
  /* #56: @1 = (@1+@7) */
  w1 += w7;
  /* #57: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  return 0;
}

/* landing_with_derivative:(y[6x6],z[5],T,p[8])->(J[6x6],R[6]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44;
  a00=arg[0]? arg[0][6] : 0;
  a01=arg[0]? arg[0][7] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[0]? arg[0][5] : 0;
  a04=arg[3]? arg[3][1] : 0;
  a05=arg[0]? arg[0][0] : 0;
  a06=arg[0]? arg[0][1] : 0;
  a07=(a05-a06);
  a08=sin(a07);
  a09=(a04*a08);
  a10=(a02*a09);
  a11=arg[3]? arg[3][3] : 0;
  a12=(2.*a11);
  a13=cos(a06);
  a14=(a03-a13);
  a14=(a12*a14);
  a14=(a14+a03);
  a15=(a10/a14);
  a16=(a13-a03);
  a16=(a11*a16);
  a17=(a16/a14);
  a18=(a17*a10);
  a19=(a16*a17);
  a19=(a11-a19);
  a20=(a18/a19);
  a21=cos(a07);
  a21=(a04*a21);
  a22=(a21/a14);
  a23=(a16*a22);
  a24=(a23/a19);
  a25=arg[0]? arg[0][3] : 0;
  a26=sin(a05);
  a27=(a25*a26);
  a27=(a04*a27);
  a28=(a22*a10);
  a29=(a13*a25);
  a30=(a21*a02);
  a29=(a29-a30);
  a30=(a09/a14);
  a31=(a29*a30);
  a28=(a28-a31);
  a27=(a27+a28);
  a18=(a24*a18);
  a28=(a17*a29);
  a31=(a16*a30);
  a32=(a31/a19);
  a33=(a28*a32);
  a18=(a18-a33);
  a27=(a27+a18);
  a18=(a21*a22);
  a18=(a04-a18);
  a33=(a23*a24);
  a18=(a18-a33);
  a27=(a27/a18);
  a33=cos(a05);
  a34=(a33*a25);
  a34=(a02-a34);
  a34=(a04*a34);
  a35=(a22*a29);
  a34=(a34+a35);
  a35=(a24*a28);
  a34=(a34+a35);
  a34=(a34/a18);
  a35=(a34/a18);
  a09=(a22*a09);
  a36=(a21*a30);
  a36=(a09+a36);
  a31=(a24*a31);
  a37=(a23*a32);
  a31=(a31+a37);
  a36=(a36+a31);
  a36=(a35*a36);
  a27=(a27-a36);
  a36=(a24*a27);
  a32=(a34*a32);
  a36=(a36-a32);
  a20=(a20+a36);
  a36=(a17*a20);
  a15=(a15+a36);
  a36=(a22*a27);
  a32=(a34*a30);
  a36=(a36-a32);
  a15=(a15+a36);
  a36=(a15*a00);
  a32=(a22/a14);
  a31=sin(a06);
  a12=(a12*a31);
  a32=(a32*a12);
  a30=(a30-a32);
  a32=(a16*a30);
  a37=(a11*a31);
  a38=(a22*a37);
  a32=(a32-a38);
  a38=(a32/a19);
  a39=(a24/a19);
  a40=(a17*a37);
  a37=(a37/a14);
  a41=(a17/a14);
  a41=(a41*a12);
  a37=(a37+a41);
  a41=(a16*a37);
  a40=(a40+a41);
  a39=(a39*a40);
  a38=(a38-a39);
  a39=(a34*a38);
  a41=(a29*a30);
  a42=(a25*a31);
  a42=(a42+a10);
  a10=(a22*a42);
  a41=(a41-a10);
  a10=(a28*a38);
  a43=(a29*a37);
  a44=(a17*a42);
  a43=(a43+a44);
  a44=(a24*a43);
  a10=(a10-a44);
  a41=(a41+a10);
  a41=(a41/a18);
  a10=(a21*a30);
  a09=(a09+a10);
  a32=(a24*a32);
  a23=(a23*a38);
  a32=(a32+a23);
  a09=(a09+a32);
  a35=(a35*a09);
  a41=(a41+a35);
  a35=(a24*a41);
  a39=(a39+a35);
  a43=(a43/a19);
  a28=(a28/a19);
  a35=(a28/a19);
  a35=(a35*a40);
  a43=(a43+a35);
  a39=(a39-a43);
  a43=(a17*a39);
  a35=(a24*a34);
  a28=(a28+a35);
  a37=(a28*a37);
  a43=(a43-a37);
  a42=(a42/a14);
  a29=(a29/a14);
  a37=(a29/a14);
  a37=(a37*a12);
  a42=(a42+a37);
  a43=(a43-a42);
  a30=(a34*a30);
  a42=(a22*a41);
  a30=(a30+a42);
  a43=(a43+a30);
  a30=(a43*a01);
  a36=(a36+a30);
  a30=(a13/a14);
  a42=(a17*a13);
  a37=(a42/a19);
  a13=(a22*a13);
  a33=(a04*a33);
  a13=(a13-a33);
  a42=(a24*a42);
  a13=(a13+a42);
  a13=(a13/a18);
  a42=(a24*a13);
  a37=(a37+a42);
  a42=(a17*a37);
  a30=(a30+a42);
  a42=(a22*a13);
  a30=(a30+a42);
  a42=arg[0]? arg[0][9] : 0;
  a12=(a30*a42);
  a36=(a36+a12);
  a12=(a22*a21);
  a12=(a04-a12);
  a21=(a17*a21);
  a35=(a24*a21);
  a12=(a12-a35);
  a12=(a12/a18);
  a24=(a24*a12);
  a21=(a21/a19);
  a24=(a24-a21);
  a21=(a17*a24);
  a21=(a21-a22);
  a18=(a22*a12);
  a21=(a21+a18);
  a18=arg[0]? arg[0][11] : 0;
  a35=(a21*a18);
  a36=(a36+a35);
  if (res[0]!=0) res[0][1]=a36;
  a36=(a20*a00);
  a35=(a39*a01);
  a36=(a36+a35);
  a35=(a37*a42);
  a36=(a36+a35);
  a35=(a24*a18);
  a36=(a36+a35);
  a36=(-a36);
  if (res[0]!=0) res[0][2]=a36;
  a36=arg[0]? arg[0][8] : 0;
  if (res[0]!=0) res[0][3]=a36;
  a36=(a27*a00);
  a35=(a41*a01);
  a36=(a36+a35);
  a42=(a13*a42);
  a36=(a36+a42);
  a18=(a12*a18);
  a36=(a36+a18);
  if (res[0]!=0) res[0][4]=a36;
  a36=-2.;
  a00=(a36*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][5]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a18=(a00-a01);
  if (res[0]!=0) res[0][6]=a18;
  a18=(a15*a00);
  a42=(a43*a01);
  a18=(a18+a42);
  a42=arg[0]? arg[0][15] : 0;
  a35=(a30*a42);
  a18=(a18+a35);
  a35=arg[0]? arg[0][17] : 0;
  a40=(a21*a35);
  a18=(a18+a40);
  a18=(a18-a03);
  if (res[0]!=0) res[0][7]=a18;
  a18=(a20*a00);
  a40=(a39*a01);
  a18=(a18+a40);
  a40=(a37*a42);
  a18=(a18+a40);
  a40=(a24*a35);
  a18=(a18+a40);
  a18=(-a18);
  if (res[0]!=0) res[0][8]=a18;
  a18=arg[0]? arg[0][14] : 0;
  if (res[0]!=0) res[0][9]=a18;
  a18=(a27*a00);
  a40=(a41*a01);
  a18=(a18+a40);
  a42=(a13*a42);
  a18=(a18+a42);
  a35=(a12*a35);
  a18=(a18+a35);
  if (res[0]!=0) res[0][10]=a18;
  a00=(a36*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=arg[0]? arg[0][18] : 0;
  a01=arg[0]? arg[0][19] : 0;
  a18=(a00-a01);
  if (res[0]!=0) res[0][12]=a18;
  a18=(a15*a00);
  a35=(a43*a01);
  a18=(a18+a35);
  a35=arg[0]? arg[0][21] : 0;
  a42=(a30*a35);
  a18=(a18+a42);
  a42=arg[0]? arg[0][23] : 0;
  a40=(a21*a42);
  a18=(a18+a40);
  if (res[0]!=0) res[0][13]=a18;
  a18=(a20*a00);
  a40=(a39*a01);
  a18=(a18+a40);
  a40=(a37*a35);
  a18=(a18+a40);
  a40=(a24*a42);
  a18=(a18+a40);
  a18=(a18+a03);
  a18=(-a18);
  if (res[0]!=0) res[0][14]=a18;
  a18=arg[0]? arg[0][20] : 0;
  if (res[0]!=0) res[0][15]=a18;
  a18=(a27*a00);
  a40=(a41*a01);
  a18=(a18+a40);
  a35=(a13*a35);
  a18=(a18+a35);
  a42=(a12*a42);
  a18=(a18+a42);
  if (res[0]!=0) res[0][16]=a18;
  a00=(a36*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][17]=a00;
  a00=arg[0]? arg[0][24] : 0;
  a01=arg[0]? arg[0][25] : 0;
  a18=(a00-a01);
  if (res[0]!=0) res[0][18]=a18;
  a18=(a15*a00);
  a42=(a43*a01);
  a18=(a18+a42);
  a42=arg[0]? arg[0][27] : 0;
  a35=(a30*a42);
  a18=(a18+a35);
  a35=arg[0]? arg[0][29] : 0;
  a40=(a21*a35);
  a18=(a18+a40);
  if (res[0]!=0) res[0][19]=a18;
  a18=(a20*a00);
  a40=(a39*a01);
  a18=(a18+a40);
  a40=(a37*a42);
  a18=(a18+a40);
  a40=(a24*a35);
  a18=(a18+a40);
  a18=(-a18);
  if (res[0]!=0) res[0][20]=a18;
  a18=arg[0]? arg[0][26] : 0;
  a18=(a18-a03);
  if (res[0]!=0) res[0][21]=a18;
  a18=(a27*a00);
  a40=(a41*a01);
  a18=(a18+a40);
  a42=(a13*a42);
  a18=(a18+a42);
  a35=(a12*a35);
  a18=(a18+a35);
  if (res[0]!=0) res[0][22]=a18;
  a00=(a36*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][23]=a00;
  a00=arg[0]? arg[0][30] : 0;
  a01=arg[0]? arg[0][31] : 0;
  a18=(a00-a01);
  if (res[0]!=0) res[0][24]=a18;
  a18=(a15*a00);
  a35=(a43*a01);
  a18=(a18+a35);
  a35=arg[0]? arg[0][33] : 0;
  a42=(a30*a35);
  a18=(a18+a42);
  a42=arg[0]? arg[0][35] : 0;
  a40=(a21*a42);
  a18=(a18+a40);
  if (res[0]!=0) res[0][25]=a18;
  a18=(a20*a00);
  a40=(a39*a01);
  a18=(a18+a40);
  a40=(a37*a35);
  a18=(a18+a40);
  a40=(a24*a42);
  a18=(a18+a40);
  a18=(-a18);
  if (res[0]!=0) res[0][26]=a18;
  a18=arg[0]? arg[0][32] : 0;
  if (res[0]!=0) res[0][27]=a18;
  a18=(a27*a00);
  a40=(a41*a01);
  a18=(a18+a40);
  a35=(a13*a35);
  a18=(a18+a35);
  a42=(a12*a42);
  a18=(a18+a42);
  a18=(a18-a03);
  if (res[0]!=0) res[0][28]=a18;
  a00=(a36*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][29]=a00;
  a00=arg[0]? arg[0][4] : 0;
  a01=(a25-a00);
  if (res[0]!=0) res[0][30]=a01;
  a15=(a15*a25);
  a43=(a43*a00);
  a15=(a15+a43);
  a43=(a11*a00);
  a43=(a43*a31);
  a01=(2.*a25);
  a01=(a00-a01);
  a43=(a43*a01);
  a01=(a11*a08);
  a43=(a43-a01);
  a01=(a11+a03);
  a01=(a26*a01);
  a43=(a43+a01);
  a01=(a43/a14);
  a18=casadi_sq(a25);
  a18=(a18*a31);
  a18=(a18+a08);
  a11=(a11*a18);
  a18=arg[3]? arg[3][5] : 0;
  a08=arg[3]? arg[3][7] : 0;
  a31=arg[3]? arg[3][2] : 0;
  a42=(a08*a31);
  a35=arg[2]? arg[2][0] : 0;
  a31=(a31*a35);
  a35=sin(a31);
  a42=(a42*a35);
  a42=(a00+a42);
  a18=(a18*a42);
  a42=arg[3]? arg[3][4] : 0;
  a35=arg[3]? arg[3][6] : 0;
  a31=cos(a31);
  a31=(a31+a03);
  a08=(a08*a31);
  a35=(a35-a08);
  a35=(a35+a06);
  a42=(a42*a35);
  a18=(a18+a42);
  a11=(a11-a18);
  a18=(a17*a43);
  a11=(a11-a18);
  a18=(a11/a19);
  a14=(a33/a14);
  a16=(a16*a14);
  a19=(a16/a19);
  a43=(a14*a43);
  a42=(a04*a25);
  a42=(a42*a25);
  a42=(a42*a26);
  a26=arg[3]? arg[3][0] : 0;
  a35=arg[0]? arg[0][2] : 0;
  a26=(a26*a35);
  a42=(a42+a26);
  a43=(a43-a42);
  a11=(a19*a11);
  a43=(a43-a11);
  a33=(a33*a14);
  a04=(a04-a33);
  a16=(a16*a19);
  a04=(a04-a16);
  a43=(a43/a04);
  a19=(a19*a43);
  a18=(a18-a19);
  a18=(a17*a18);
  a01=(a01-a18);
  a14=(a14*a43);
  a01=(a01+a14);
  a30=(a30*a01);
  a15=(a15+a30);
  a21=(a21*a43);
  a15=(a15+a21);
  if (res[0]!=0) res[0][31]=a15;
  a20=(a20*a25);
  a39=(a39*a00);
  a20=(a20+a39);
  a37=(a37*a01);
  a20=(a20+a37);
  a24=(a24*a43);
  a20=(a20+a24);
  a20=(-a20);
  if (res[0]!=0) res[0][32]=a20;
  if (res[0]!=0) res[0][33]=a02;
  a27=(a27*a25);
  a41=(a41*a00);
  a27=(a27+a41);
  a13=(a13*a01);
  a27=(a27+a13);
  a12=(a12*a43);
  a27=(a27+a12);
  if (res[0]!=0) res[0][34]=a27;
  a36=(a36*a25);
  a36=(a36+a00);
  if (res[0]!=0) res[0][35]=a36;
  a36=arg[1]? arg[1][0] : 0;
  a07=(a07-a36);
  if (res[1]!=0) res[1][0]=a07;
  a17=(a17*a28);
  a29=(a29+a17);
  a22=(a22*a34);
  a29=(a29+a22);
  a22=arg[1]? arg[1][1] : 0;
  a29=(a29-a22);
  if (res[1]!=0) res[1][1]=a29;
  a29=arg[1]? arg[1][2] : 0;
  a28=(a28+a29);
  a28=(-a28);
  if (res[1]!=0) res[1][2]=a28;
  a28=arg[1]? arg[1][3] : 0;
  a35=(a35-a28);
  if (res[1]!=0) res[1][3]=a35;
  a35=arg[1]? arg[1][4] : 0;
  a34=(a34-a35);
  if (res[1]!=0) res[1][4]=a34;
  a05=(2.*a05);
  a06=(a06-a05);
  if (res[1]!=0) res[1][5]=a06;
  return 0;
}

/* wobbling_jacobian_12:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 12 */
  w08 = 12.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@5, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w05;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @5 */
  casadi_copy(w05, 36, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* scaled_jacobian_12:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+577, *w1=w+613, *w3=w+619, *w4=w+655;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = wobbling_jacobian_12(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_12:(u0[6],p[8])->(u[6]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f3(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_12:(i0[6],i1[8])->(o0[6]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+789, *w2=w+795;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* plain_step:(y[6],phase[2],turns[2x12],h,p[8])->(y_end[6]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[3]? arg[3][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][3] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[4]? arg[4][3] : 0;
  a008=arg[0]? arg[0][4] : 0;
  a009=(a007*a008);
  a010=arg[0]? arg[0][1] : 0;
  a011=sin(a010);
  a009=(a009*a011);
  a012=(2.*a003);
  a012=(a008-a012);
  a009=(a009*a012);
  a012=sin(a000);
  a013=cos(a010);
  a014=(a012*a013);
  a015=cos(a000);
  a016=(a015*a011);
  a014=(a014-a016);
  a016=(a007*a014);
  a009=(a009-a016);
  a016=1.;
  a017=(a007+a016);
  a018=(a012*a017);
  a009=(a009+a018);
  a018=(2.*a007);
  a019=(a016-a013);
  a019=(a018*a019);
  a019=(a019+a016);
  a020=(a009/a019);
  a013=(a013-a016);
  a013=(a007*a013);
  a021=(a013/a019);
  a022=casadi_sq(a003);
  a022=(a022*a011);
  a022=(a022+a014);
  a022=(a007*a022);
  a014=arg[4]? arg[4][5] : 0;
  a011=arg[4]? arg[4][7] : 0;
  a023=arg[4]? arg[4][2] : 0;
  a023=(a011*a023);
  a024=arg[1]? arg[1][1] : 0;
  a025=(a023*a024);
  a025=(a008+a025);
  a025=(a014*a025);
  a026=arg[4]? arg[4][4] : 0;
  a027=arg[4]? arg[4][6] : 0;
  a028=arg[1]? arg[1][0] : 0;
  a029=(a028+a016);
  a029=(a011*a029);
  a029=(a027-a029);
  a029=(a029+a010);
  a029=(a026*a029);
  a025=(a025+a029);
  a022=(a022-a025);
  a025=(a021*a009);
  a022=(a022-a025);
  a025=(a013*a021);
  a025=(a007-a025);
  a029=(a022/a025);
  a030=arg[4]? arg[4][1] : 0;
  a015=(a030*a015);
  a019=(a015/a019);
  a013=(a013*a019);
  a025=(a013/a025);
  a009=(a019*a009);
  a031=(a030*a003);
  a031=(a031*a003);
  a031=(a031*a012);
  a012=arg[4]? arg[4][0] : 0;
  a032=arg[0]? arg[0][2] : 0;
  a033=(a012*a032);
  a031=(a031+a033);
  a009=(a009-a031);
  a022=(a025*a022);
  a009=(a009-a022);
  a015=(a015*a019);
  a015=(a030-a015);
  a013=(a013*a025);
  a015=(a015-a013);
  a009=(a009/a015);
  a025=(a025*a009);
  a029=(a029-a025);
  a021=(a021*a029);
  a020=(a020-a021);
  a019=(a019*a009);
  a020=(a020+a019);
  a019=(a006*a020);
  a021=1.7082860872947386e-01;
  a021=(a021*a002);
  a025=2.9587585476806851e-02;
  a025=(a025*a002);
  a015=(a025*a029);
  a013=8.8762756430420545e-02;
  a013=(a013*a002);
  a022=1.9725056984537900e-02;
  a022=(a022*a002);
  a031=(a022*a020);
  a033=5.9175170953613701e-02;
  a033=(a033*a002);
  a034=5.2600151958767730e-02;
  a034=(a034*a002);
  a035=(a034*a029);
  a035=(a008+a035);
  a036=(a007*a035);
  a037=(a034*a008);
  a037=(a010+a037);
  a038=sin(a037);
  a036=(a036*a038);
  a039=(a034*a020);
  a039=(a003+a039);
  a040=(2.*a039);
  a040=(a035-a040);
  a036=(a036*a040);
  a040=(a034*a003);
  a040=(a000+a040);
  a041=sin(a040);
  a042=cos(a037);
  a043=(a041*a042);
  a040=cos(a040);
  a044=(a040*a038);
  a043=(a043-a044);
  a044=(a007*a043);
  a036=(a036-a044);
  a044=(a041*a017);
  a036=(a036+a044);
  a044=(a016-a042);
  a044=(a018*a044);
  a044=(a044+a016);
  a045=(a036/a044);
  a042=(a042-a016);
  a042=(a007*a042);
  a046=(a042/a044);
  a047=casadi_sq(a039);
  a047=(a047*a038);
  a047=(a047+a043);
  a047=(a007*a047);
  a043=arg[2]? arg[2][2] : 0;
  a038=(a024*a043);
  a048=arg[2]? arg[2][3] : 0;
  a049=(a028*a048);
  a038=(a038+a049);
  a038=(a023*a038);
  a038=(a035+a038);
  a038=(a014*a038);
  a043=(a028*a043);
  a048=(a024*a048);
  a043=(a043-a048);
  a043=(a043+a016);
  a043=(a011*a043);
  a043=(a027-a043);
  a043=(a043+a037);
  a043=(a026*a043);
  a038=(a038+a043);
  a047=(a047-a038);
  a038=(a046*a036);
  a047=(a047-a038);
  a038=(a042*a046);
  a038=(a007-a038);
  a043=(a047/a038);
  a040=(a030*a040);
  a044=(a040/a044);
  a042=(a042*a044);
  a038=(a042/a038);
  a036=(a044*a036);
  a037=(a030*a039);
  a037=(a037*a039);
  a037=(a037*a041);
  a041=arg[0]? arg[0][5] : 0;
  a048=(a034*a041);
  a048=(a032+a048);
  a048=(a012*a048);
  a037=(a037+a048);
  a036=(a036-a037);
  a047=(a038*a047);
  a036=(a036-a047);
  a040=(a040*a044);
  a040=(a030-a040);
  a042=(a042*a038);
  a040=(a040-a042);
  a036=(a036/a040);
  a038=(a038*a036);
  a043=(a043-a038);
  a046=(a046*a043);
  a045=(a045-a046);
  a044=(a044*a036);
  a045=(a045+a044);
  a045=(a033*a045);
  a031=(a031+a045);
  a031=(a003+a031);
  a045=casadi_sq(a031);
  a044=(a022*a008);
  a035=(a033*a035);
  a044=(a044+a035);
  a044=(a010+a044);
  a035=sin(a044);
  a045=(a045*a035);
  a046=(a022*a003);
  a039=(a033*a039);
  a046=(a046+a039);
  a046=(a000+a046);
  a039=sin(a046);
  a038=cos(a044);
  a040=(a039*a038);
  a046=cos(a046);
  a042=(a046*a035);
  a040=(a040-a042);
  a045=(a045+a040);
  a045=(a007*a045);
  a042=(a022*a029);
  a043=(a033*a043);
  a042=(a042+a043);
  a042=(a008+a042);
  a043=arg[2]? arg[2][4] : 0;
  a047=(a024*a043);
  a037=arg[2]? arg[2][5] : 0;
  a048=(a028*a037);
  a047=(a047+a048);
  a047=(a023*a047);
  a047=(a042+a047);
  a047=(a014*a047);
  a043=(a028*a043);
  a037=(a024*a037);
  a043=(a043-a037);
  a043=(a043+a016);
  a043=(a011*a043);
  a043=(a027-a043);
  a043=(a043+a044);
  a043=(a026*a043);
  a047=(a047+a043);
  a045=(a045-a047);
  a047=(a038-a016);
  a047=(a007*a047);
  a038=(a016-a038);
  a038=(a018*a038);
  a038=(a038+a016);
  a043=(a047/a038);
  a044=(a007*a042);
  a044=(a044*a035);
  a035=(2.*a031);
  a035=(a042-a035);
  a044=(a044*a035);
  a040=(a007*a040);
  a044=(a044-a040);
  a040=(a039*a017);
  a044=(a044+a040);
  a040=(a043*a044);
  a045=(a045-a040);
  a040=(a047*a043);
  a040=(a007-a040);
  a035=(a045/a040);
  a046=(a030*a046);
  a037=(a046/a038);
  a047=(a047*a037);
  a040=(a047/a040);
  a048=(a037*a044);
  a049=(a030*a031);
  a049=(a049*a031);
  a049=(a049*a039);
  a039=(a022*a041);
  a034=(a034*a009);
  a034=(a041+a034);
  a034=(a033*a034);
  a039=(a039+a034);
  a039=(a032+a039);
  a039=(a012*a039);
  a049=(a049+a039);
  a048=(a048-a049);
  a045=(a040*a045);
  a048=(a048-a045);
  a046=(a046*a037);
  a046=(a030-a046);
  a047=(a047*a040);
  a046=(a046-a047);
  a048=(a048/a046);
  a040=(a040*a048);
  a035=(a035-a040);
  a040=(a013*a035);
  a015=(a015+a040);
  a015=(a008+a015);
  a040=(a007*a015);
  a046=(a025*a008);
  a047=(a013*a042);
  a046=(a046+a047);
  a046=(a010+a046);
  a047=sin(a046);
  a040=(a040*a047);
  a045=(a025*a020);
  a044=(a044/a038);
  a043=(a043*a035);
  a044=(a044-a043);
  a037=(a037*a048);
  a044=(a044+a037);
  a037=(a013*a044);
  a045=(a045+a037);
  a045=(a003+a045);
  a037=(2.*a045);
  a037=(a015-a037);
  a040=(a040*a037);
  a037=(a025*a003);
  a043=(a013*a031);
  a037=(a037+a043);
  a037=(a000+a037);
  a043=sin(a037);
  a038=cos(a046);
  a049=(a043*a038);
  a037=cos(a037);
  a039=(a037*a047);
  a049=(a049-a039);
  a039=(a007*a049);
  a040=(a040-a039);
  a039=(a043*a017);
  a040=(a040+a039);
  a039=(a016-a038);
  a039=(a018*a039);
  a039=(a039+a016);
  a034=(a040/a039);
  a038=(a038-a016);
  a038=(a007*a038);
  a050=(a038/a039);
  a051=casadi_sq(a045);
  a051=(a051*a047);
  a051=(a051+a049);
  a051=(a007*a051);
  a049=arg[2]? arg[2][6] : 0;
  a047=(a024*a049);
  a052=arg[2]? arg[2][7] : 0;
  a053=(a028*a052);
  a047=(a047+a053);
  a047=(a023*a047);
  a047=(a015+a047);
  a047=(a014*a047);
  a049=(a028*a049);
  a052=(a024*a052);
  a049=(a049-a052);
  a049=(a049+a016);
  a049=(a011*a049);
  a049=(a027-a049);
  a049=(a049+a046);
  a049=(a026*a049);
  a047=(a047+a049);
  a051=(a051-a047);
  a047=(a050*a040);
  a051=(a051-a047);
  a047=(a038*a050);
  a047=(a007-a047);
  a049=(a051/a047);
  a037=(a030*a037);
  a039=(a037/a039);
  a038=(a038*a039);
  a047=(a038/a047);
  a040=(a039*a040);
  a046=(a030*a045);
  a046=(a046*a045);
  a046=(a046*a043);
  a043=(a025*a041);
  a022=(a022*a009);
  a033=(a033*a036);
  a022=(a022+a033);
  a022=(a041+a022);
  a033=(a013*a022);
  a043=(a043+a033);
  a043=(a032+a043);
  a043=(a012*a043);
  a046=(a046+a043);
  a040=(a040-a046);
  a051=(a047*a051);
  a040=(a040-a051);
  a037=(a037*a039);
  a037=(a030-a037);
  a038=(a038*a047);
  a037=(a037-a038);
  a040=(a040/a037);
  a047=(a047*a040);
  a049=(a049-a047);
  a050=(a050*a049);
  a034=(a034-a050);
  a039=(a039*a040);
  a034=(a034+a039);
  a039=(a021*a034);
  a019=(a019+a039);
  a039=1.2546768756682242e-01;
  a039=(a039*a002);
  a050=2.4136513415926669e-01;
  a050=(a050*a002);
  a047=(a050*a029);
  a037=-8.8454947932828609e-01;
  a037=(a037*a002);
  a035=(a037*a035);
  a047=(a047+a035);
  a035=9.2483400326179199e-01;
  a035=(a035*a002);
  a038=(a035*a049);
  a047=(a047+a038);
  a047=(a008+a047);
  a038=(a007*a047);
  a051=(a050*a008);
  a042=(a037*a042);
  a051=(a051+a042);
  a042=(a035*a015);
  a051=(a051+a042);
  a051=(a010+a051);
  a042=sin(a051);
  a038=(a038*a042);
  a046=(a050*a020);
  a044=(a037*a044);
  a046=(a046+a044);
  a044=(a035*a034);
  a046=(a046+a044);
  a046=(a003+a046);
  a044=(2.*a046);
  a044=(a047-a044);
  a038=(a038*a044);
  a044=(a050*a003);
  a031=(a037*a031);
  a044=(a044+a031);
  a031=(a035*a045);
  a044=(a044+a031);
  a044=(a000+a044);
  a031=sin(a044);
  a043=cos(a051);
  a033=(a031*a043);
  a044=cos(a044);
  a036=(a044*a042);
  a033=(a033-a036);
  a036=(a007*a033);
  a038=(a038-a036);
  a036=(a031*a017);
  a038=(a038+a036);
  a036=(a016-a043);
  a036=(a018*a036);
  a036=(a036+a016);
  a052=(a038/a036);
  a043=(a043-a016);
  a043=(a007*a043);
  a053=(a043/a036);
  a054=casadi_sq(a046);
  a054=(a054*a042);
  a054=(a054+a033);
  a054=(a007*a054);
  a033=arg[2]? arg[2][8] : 0;
  a042=(a024*a033);
  a055=arg[2]? arg[2][9] : 0;
  a056=(a028*a055);
  a042=(a042+a056);
  a042=(a023*a042);
  a042=(a047+a042);
  a042=(a014*a042);
  a033=(a028*a033);
  a055=(a024*a055);
  a033=(a033-a055);
  a033=(a033+a016);
  a033=(a011*a033);
  a033=(a027-a033);
  a033=(a033+a051);
  a033=(a026*a033);
  a042=(a042+a033);
  a054=(a054-a042);
  a042=(a053*a038);
  a054=(a054-a042);
  a042=(a043*a053);
  a042=(a007-a042);
  a033=(a054/a042);
  a044=(a030*a044);
  a036=(a044/a036);
  a043=(a043*a036);
  a042=(a043/a042);
  a038=(a036*a038);
  a051=(a030*a046);
  a051=(a051*a046);
  a051=(a051*a031);
  a031=(a050*a041);
  a022=(a037*a022);
  a031=(a031+a022);
  a025=(a025*a009);
  a013=(a013*a048);
  a025=(a025+a013);
  a025=(a041+a025);
  a013=(a035*a025);
  a031=(a031+a013);
  a031=(a032+a031);
  a031=(a012*a031);
  a051=(a051+a031);
  a038=(a038-a051);
  a054=(a042*a054);
  a038=(a038-a054);
  a044=(a044*a036);
  a044=(a030-a044);
  a043=(a043*a042);
  a044=(a044-a043);
  a038=(a038/a044);
  a042=(a042*a038);
  a033=(a033-a042);
  a053=(a053*a033);
  a052=(a052-a053);
  a036=(a036*a038);
  a052=(a052+a036);
  a036=(a039*a052);
  a019=(a019+a036);
  a019=(a003+a019);
  a036=(a005*a019);
  a004=(a004+a036);
  a036=1.8915178993145003e+00;
  a036=(a036*a002);
  a053=3.7109375000000000e-02;
  a053=(a053*a002);
  a042=(a053*a020);
  a044=1.7025221101954405e-01;
  a044=(a044*a002);
  a043=(a044*a034);
  a042=(a042+a043);
  a043=6.0216538980455959e-02;
  a043=(a043*a002);
  a054=(a043*a052);
  a042=(a042+a054);
  a054=-1.7578125000000000e-02;
  a054=(a054*a002);
  a051=(a006*a029);
  a031=(a021*a049);
  a051=(a051+a031);
  a031=(a039*a033);
  a051=(a051+a031);
  a051=(a008+a051);
  a031=(a007*a051);
  a013=(a006*a008);
  a022=(a021*a015);
  a013=(a013+a022);
  a022=(a039*a047);
  a013=(a013+a022);
  a013=(a010+a013);
  a022=sin(a013);
  a031=(a031*a022);
  a055=(2.*a019);
  a055=(a051-a055);
  a031=(a031*a055);
  a055=(a006*a003);
  a056=(a021*a045);
  a055=(a055+a056);
  a056=(a039*a046);
  a055=(a055+a056);
  a055=(a000+a055);
  a056=sin(a055);
  a057=cos(a013);
  a058=(a056*a057);
  a055=cos(a055);
  a059=(a055*a022);
  a058=(a058-a059);
  a059=(a007*a058);
  a031=(a031-a059);
  a059=(a056*a017);
  a031=(a031+a059);
  a059=(a016-a057);
  a059=(a018*a059);
  a059=(a059+a016);
  a060=(a031/a059);
  a057=(a057-a016);
  a057=(a007*a057);
  a061=(a057/a059);
  a062=casadi_sq(a019);
  a062=(a062*a022);
  a062=(a062+a058);
  a062=(a007*a062);
  a058=arg[2]? arg[2][10] : 0;
  a022=(a024*a058);
  a063=arg[2]? arg[2][11] : 0;
  a064=(a028*a063);
  a022=(a022+a064);
  a022=(a023*a022);
  a022=(a051+a022);
  a022=(a014*a022);
  a058=(a028*a058);
  a063=(a024*a063);
  a058=(a058-a063);
  a058=(a058+a016);
  a058=(a011*a058);
  a058=(a027-a058);
  a058=(a058+a013);
  a058=(a026*a058);
  a022=(a022+a058);
  a062=(a062-a022);
  a022=(a061*a031);
  a062=(a062-a022);
  a022=(a057*a061);
  a022=(a007-a022);
  a058=(a062/a022);
  a055=(a030*a055);
  a059=(a055/a059);
  a057=(a057*a059);
  a022=(a057/a022);
  a031=(a059*a031);
  a013=(a030*a019);
  a013=(a013*a019);
  a013=(a013*a056);
  a056=(a006*a041);
  a063=(a021*a025);
  a056=(a056+a063);
  a050=(a050*a009);
  a037=(a037*a048);
  a050=(a050+a037);
  a035=(a035*a040);
  a050=(a050+a035);
  a050=(a041+a050);
  a035=(a039*a050);
  a056=(a056+a035);
  a056=(a032+a056);
  a056=(a012*a056);
  a013=(a013+a056);
  a031=(a031-a013);
  a062=(a022*a062);
  a031=(a031-a062);
  a055=(a055*a059);
  a055=(a030-a055);
  a057=(a057*a022);
  a055=(a055-a057);
  a031=(a031/a055);
  a022=(a022*a031);
  a058=(a058-a022);
  a061=(a061*a058);
  a060=(a060-a061);
  a059=(a059*a031);
  a060=(a060+a059);
  a059=(a054*a060);
  a042=(a042+a059);
  a042=(a003+a042);
  a059=(a036*a042);
  a004=(a004+a059);
  a059=-5.8012039600105849e+00;
  a059=(a059*a002);
  a061=3.7092000118504789e-02;
  a061=(a061*a002);
  a022=(a061*a020);
  a055=1.7038392571223998e-01;
  a055=(a055*a002);
  a057=(a055*a034);
  a022=(a022+a057);
  a057=1.0726203044637328e-01;
  a057=(a057*a002);
  a062=(a057*a052);
  a022=(a022+a062);
  a062=-1.5319437748624402e-02;
  a062=(a062*a002);
  a013=(a062*a060);
  a022=(a022+a013);
  a013=8.2737891638140233e-03;
  a013=(a013*a002);
  a056=(a053*a029);
  a035=(a044*a049);
  a056=(a056+a035);
  a035=(a043*a033);
  a056=(a056+a035);
  a035=(a054*a058);
  a056=(a056+a035);
  a056=(a008+a056);
  a035=(a007*a056);
  a037=(a053*a008);
  a048=(a044*a015);
  a037=(a037+a048);
  a048=(a043*a047);
  a037=(a037+a048);
  a048=(a054*a051);
  a037=(a037+a048);
  a037=(a010+a037);
  a048=sin(a037);
  a035=(a035*a048);
  a063=(2.*a042);
  a063=(a056-a063);
  a035=(a035*a063);
  a063=(a053*a003);
  a064=(a044*a045);
  a063=(a063+a064);
  a064=(a043*a046);
  a063=(a063+a064);
  a064=(a054*a019);
  a063=(a063+a064);
  a063=(a000+a063);
  a064=sin(a063);
  a065=cos(a037);
  a066=(a064*a065);
  a063=cos(a063);
  a067=(a063*a048);
  a066=(a066-a067);
  a067=(a007*a066);
  a035=(a035-a067);
  a067=(a064*a017);
  a035=(a035+a067);
  a067=(a016-a065);
  a067=(a018*a067);
  a067=(a067+a016);
  a068=(a035/a067);
  a065=(a065-a016);
  a065=(a007*a065);
  a069=(a065/a067);
  a070=casadi_sq(a042);
  a070=(a070*a048);
  a070=(a070+a066);
  a070=(a007*a070);
  a066=arg[2]? arg[2][12] : 0;
  a048=(a024*a066);
  a071=arg[2]? arg[2][13] : 0;
  a072=(a028*a071);
  a048=(a048+a072);
  a048=(a023*a048);
  a048=(a056+a048);
  a048=(a014*a048);
  a066=(a028*a066);
  a071=(a024*a071);
  a066=(a066-a071);
  a066=(a066+a016);
  a066=(a011*a066);
  a066=(a027-a066);
  a066=(a066+a037);
  a066=(a026*a066);
  a048=(a048+a066);
  a070=(a070-a048);
  a048=(a069*a035);
  a070=(a070-a048);
  a048=(a065*a069);
  a048=(a007-a048);
  a066=(a070/a048);
  a063=(a030*a063);
  a067=(a063/a067);
  a065=(a065*a067);
  a048=(a065/a048);
  a035=(a067*a035);
  a037=(a030*a042);
  a037=(a037*a042);
  a037=(a037*a064);
  a064=(a053*a041);
  a071=(a044*a025);
  a064=(a064+a071);
  a071=(a043*a050);
  a064=(a064+a071);
  a006=(a006*a009);
  a021=(a021*a040);
  a006=(a006+a021);
  a039=(a039*a038);
  a006=(a006+a039);
  a006=(a041+a006);
  a039=(a054*a006);
  a064=(a064+a039);
  a064=(a032+a064);
  a064=(a012*a064);
  a037=(a037+a064);
  a035=(a035-a037);
  a070=(a048*a070);
  a035=(a035-a070);
  a063=(a063*a067);
  a063=(a030-a063);
  a065=(a065*a048);
  a063=(a063-a065);
  a035=(a035/a063);
  a048=(a048*a035);
  a066=(a066-a048);
  a069=(a069*a066);
  a068=(a068-a069);
  a067=(a067*a035);
  a068=(a068+a067);
  a067=(a013*a068);
  a022=(a022+a067);
  a022=(a003+a022);
  a067=(a059*a022);
  a004=(a004+a067);
  a067=3.1116436695781990e-01;
  a067=(a067*a002);
  a069=6.2411095871607569e-01;
  a069=(a069*a002);
  a048=(a069*a020);
  a063=-3.3608926294469414e+00;
  a063=(a063*a002);
  a065=(a063*a034);
  a048=(a048+a065);
  a065=-8.6821934684172597e-01;
  a065=(a065*a002);
  a070=(a065*a052);
  a048=(a048+a070);
  a070=2.7592099699446710e+01;
  a070=(a070*a002);
  a037=(a070*a060);
  a048=(a048+a037);
  a037=2.0154067550477894e+01;
  a037=(a037*a002);
  a064=(a037*a068);
  a048=(a048+a064);
  a064=-4.3489884181069961e+01;
  a064=(a064*a002);
  a039=(a061*a029);
  a021=(a055*a049);
  a039=(a039+a021);
  a021=(a057*a033);
  a039=(a039+a021);
  a021=(a062*a058);
  a039=(a039+a021);
  a021=(a013*a066);
  a039=(a039+a021);
  a039=(a008+a039);
  a021=(a007*a039);
  a071=(a061*a008);
  a072=(a055*a015);
  a071=(a071+a072);
  a072=(a057*a047);
  a071=(a071+a072);
  a072=(a062*a051);
  a071=(a071+a072);
  a072=(a013*a056);
  a071=(a071+a072);
  a071=(a010+a071);
  a072=sin(a071);
  a021=(a021*a072);
  a073=(2.*a022);
  a073=(a039-a073);
  a021=(a021*a073);
  a073=(a061*a003);
  a074=(a055*a045);
  a073=(a073+a074);
  a074=(a057*a046);
  a073=(a073+a074);
  a074=(a062*a019);
  a073=(a073+a074);
  a074=(a013*a042);
  a073=(a073+a074);
  a073=(a000+a073);
  a074=sin(a073);
  a075=cos(a071);
  a076=(a074*a075);
  a073=cos(a073);
  a077=(a073*a072);
  a076=(a076-a077);
  a077=(a007*a076);
  a021=(a021-a077);
  a077=(a074*a017);
  a021=(a021+a077);
  a077=(a016-a075);
  a077=(a018*a077);
  a077=(a077+a016);
  a078=(a021/a077);
  a075=(a075-a016);
  a075=(a007*a075);
  a079=(a075/a077);
  a080=casadi_sq(a022);
  a080=(a080*a072);
  a080=(a080+a076);
  a080=(a007*a080);
  a076=arg[2]? arg[2][14] : 0;
  a072=(a024*a076);
  a081=arg[2]? arg[2][15] : 0;
  a082=(a028*a081);
  a072=(a072+a082);
  a072=(a023*a072);
  a072=(a039+a072);
  a072=(a014*a072);
  a076=(a028*a076);
  a081=(a024*a081);
  a076=(a076-a081);
  a076=(a076+a016);
  a076=(a011*a076);
  a076=(a027-a076);
  a076=(a076+a071);
  a076=(a026*a076);
  a072=(a072+a076);
  a080=(a080-a072);
  a072=(a079*a021);
  a080=(a080-a072);
  a072=(a075*a079);
  a072=(a007-a072);
  a076=(a080/a072);
  a073=(a030*a073);
  a077=(a073/a077);
  a075=(a075*a077);
  a072=(a075/a072);
  a021=(a077*a021);
  a071=(a030*a022);
  a071=(a071*a022);
  a071=(a071*a074);
  a074=(a061*a041);
  a081=(a055*a025);
  a074=(a074+a081);
  a081=(a057*a050);
  a074=(a074+a081);
  a081=(a062*a006);
  a074=(a074+a081);
  a053=(a053*a009);
  a044=(a044*a040);
  a053=(a053+a044);
  a043=(a043*a038);
  a053=(a053+a043);
  a054=(a054*a031);
  a053=(a053+a054);
  a053=(a041+a053);
  a054=(a013*a053);
  a074=(a074+a054);
  a074=(a032+a074);
  a074=(a012*a074);
  a071=(a071+a074);
  a021=(a021-a071);
  a080=(a072*a080);
  a021=(a021-a080);
  a073=(a073*a077);
  a073=(a030-a073);
  a075=(a075*a072);
  a073=(a073-a075);
  a021=(a021/a073);
  a072=(a072*a021);
  a076=(a076-a072);
  a079=(a079*a076);
  a078=(a078-a079);
  a077=(a077*a021);
  a078=(a078+a077);
  a077=(a064*a078);
  a048=(a048+a077);
  a048=(a003+a048);
  a077=(a067*a048);
  a004=(a004+a077);
  a077=-1.5216094966251609e-01;
  a077=(a077*a002);
  a079=4.7766253643826434e-01;
  a079=(a079*a002);
  a072=(a079*a020);
  a073=-2.4881146199716677e+00;
  a073=(a073*a002);
  a075=(a073*a034);
  a072=(a072+a075);
  a075=-5.9029082683684297e-01;
  a075=(a075*a002);
  a080=(a075*a052);
  a072=(a072+a080);
  a080=2.1230051448181193e+01;
  a080=(a080*a002);
  a071=(a080*a060);
  a072=(a072+a071);
  a071=1.5279233632882423e+01;
  a071=(a071*a002);
  a074=(a071*a068);
  a072=(a072+a074);
  a074=-3.3288210968984863e+01;
  a074=(a074*a002);
  a054=(a074*a078);
  a072=(a072+a054);
  a054=-2.0331201708508627e-02;
  a054=(a054*a002);
  a043=(a069*a029);
  a044=(a063*a049);
  a043=(a043+a044);
  a044=(a065*a033);
  a043=(a043+a044);
  a044=(a070*a058);
  a043=(a043+a044);
  a044=(a037*a066);
  a043=(a043+a044);
  a044=(a064*a076);
  a043=(a043+a044);
  a043=(a008+a043);
  a044=(a007*a043);
  a081=(a069*a008);
  a082=(a063*a015);
  a081=(a081+a082);
  a082=(a065*a047);
  a081=(a081+a082);
  a082=(a070*a051);
  a081=(a081+a082);
  a082=(a037*a056);
  a081=(a081+a082);
  a082=(a064*a039);
  a081=(a081+a082);
  a081=(a010+a081);
  a082=sin(a081);
  a044=(a044*a082);
  a083=(2.*a048);
  a083=(a043-a083);
  a044=(a044*a083);
  a083=(a069*a003);
  a084=(a063*a045);
  a083=(a083+a084);
  a084=(a065*a046);
  a083=(a083+a084);
  a084=(a070*a019);
  a083=(a083+a084);
  a084=(a037*a042);
  a083=(a083+a084);
  a084=(a064*a022);
  a083=(a083+a084);
  a083=(a000+a083);
  a084=sin(a083);
  a085=cos(a081);
  a086=(a084*a085);
  a083=cos(a083);
  a087=(a083*a082);
  a086=(a086-a087);
  a087=(a007*a086);
  a044=(a044-a087);
  a087=(a084*a017);
  a044=(a044+a087);
  a087=(a016-a085);
  a087=(a018*a087);
  a087=(a087+a016);
  a088=(a044/a087);
  a085=(a085-a016);
  a085=(a007*a085);
  a089=(a085/a087);
  a090=casadi_sq(a048);
  a090=(a090*a082);
  a090=(a090+a086);
  a090=(a007*a090);
  a086=arg[2]? arg[2][16] : 0;
  a082=(a024*a086);
  a091=arg[2]? arg[2][17] : 0;
  a092=(a028*a091);
  a082=(a082+a092);
  a082=(a023*a082);
  a082=(a043+a082);
  a082=(a014*a082);
  a086=(a028*a086);
  a091=(a024*a091);
  a086=(a086-a091);
  a086=(a086+a016);
  a086=(a011*a086);
  a086=(a027-a086);
  a086=(a086+a081);
  a086=(a026*a086);
  a082=(a082+a086);
  a090=(a090-a082);
  a082=(a089*a044);
  a090=(a090-a082);
  a082=(a085*a089);
  a082=(a007-a082);
  a086=(a090/a082);
  a083=(a030*a083);
  a087=(a083/a087);
  a085=(a085*a087);
  a082=(a085/a082);
  a044=(a087*a044);
  a081=(a030*a048);
  a081=(a081*a048);
  a081=(a081*a084);
  a084=(a069*a041);
  a091=(a063*a025);
  a084=(a084+a091);
  a091=(a065*a050);
  a084=(a084+a091);
  a091=(a070*a006);
  a084=(a084+a091);
  a091=(a037*a053);
  a084=(a084+a091);
  a061=(a061*a009);
  a055=(a055*a040);
  a061=(a061+a055);
  a057=(a057*a038);
  a061=(a061+a057);
  a062=(a062*a031);
  a061=(a061+a062);
  a013=(a013*a035);
  a061=(a061+a013);
  a061=(a041+a061);
  a013=(a064*a061);
  a084=(a084+a013);
  a084=(a032+a084);
  a084=(a012*a084);
  a081=(a081+a084);
  a044=(a044-a081);
  a090=(a082*a090);
  a044=(a044-a090);
  a083=(a083*a087);
  a083=(a030-a083);
  a085=(a085*a082);
  a083=(a083-a085);
  a044=(a044/a083);
  a082=(a082*a044);
  a086=(a086-a082);
  a089=(a089*a086);
  a088=(a088-a089);
  a087=(a087*a044);
  a088=(a088+a087);
  a087=(a054*a088);
  a072=(a072+a087);
  a072=(a003+a072);
  a087=(a077*a072);
  a004=(a004+a087);
  a087=2.0136540080403034e-01;
  a087=(a087*a002);
  a089=-9.3714243008598730e-01;
  a089=(a089*a002);
  a082=(a089*a020);
  a083=5.1863724288440638e+00;
  a083=(a083*a002);
  a085=(a083*a034);
  a082=(a082+a085);
  a085=1.0914373489967295e+00;
  a085=(a085*a002);
  a090=(a085*a052);
  a082=(a082+a090);
  a090=-8.1497870107469268e+00;
  a090=(a090*a002);
  a081=(a090*a060);
  a082=(a082+a081);
  a081=-1.8520065659996959e+01;
  a081=(a081*a002);
  a084=(a081*a068);
  a082=(a082+a084);
  a084=2.2739487099350505e+01;
  a084=(a084*a002);
  a013=(a084*a078);
  a082=(a082+a013);
  a013=2.4936055526796523e+00;
  a013=(a013*a002);
  a062=(a013*a088);
  a082=(a082+a062);
  a062=-3.0467644718982196e+00;
  a062=(a062*a002);
  a057=(a079*a029);
  a055=(a073*a049);
  a057=(a057+a055);
  a055=(a075*a033);
  a057=(a057+a055);
  a055=(a080*a058);
  a057=(a057+a055);
  a055=(a071*a066);
  a057=(a057+a055);
  a055=(a074*a076);
  a057=(a057+a055);
  a055=(a054*a086);
  a057=(a057+a055);
  a057=(a008+a057);
  a055=(a007*a057);
  a091=(a079*a008);
  a092=(a073*a015);
  a091=(a091+a092);
  a092=(a075*a047);
  a091=(a091+a092);
  a092=(a080*a051);
  a091=(a091+a092);
  a092=(a071*a056);
  a091=(a091+a092);
  a092=(a074*a039);
  a091=(a091+a092);
  a092=(a054*a043);
  a091=(a091+a092);
  a091=(a010+a091);
  a092=sin(a091);
  a055=(a055*a092);
  a093=(2.*a072);
  a093=(a057-a093);
  a055=(a055*a093);
  a093=(a079*a003);
  a094=(a073*a045);
  a093=(a093+a094);
  a094=(a075*a046);
  a093=(a093+a094);
  a094=(a080*a019);
  a093=(a093+a094);
  a094=(a071*a042);
  a093=(a093+a094);
  a094=(a074*a022);
  a093=(a093+a094);
  a094=(a054*a048);
  a093=(a093+a094);
  a093=(a000+a093);
  a094=sin(a093);
  a095=cos(a091);
  a096=(a094*a095);
  a093=cos(a093);
  a097=(a093*a092);
  a096=(a096-a097);
  a097=(a007*a096);
  a055=(a055-a097);
  a097=(a094*a017);
  a055=(a055+a097);
  a097=(a016-a095);
  a097=(a018*a097);
  a097=(a097+a016);
  a098=(a055/a097);
  a095=(a095-a016);
  a095=(a007*a095);
  a099=(a095/a097);
  a100=casadi_sq(a072);
  a100=(a100*a092);
  a100=(a100+a096);
  a100=(a007*a100);
  a096=arg[2]? arg[2][18] : 0;
  a092=(a024*a096);
  a101=arg[2]? arg[2][19] : 0;
  a102=(a028*a101);
  a092=(a092+a102);
  a092=(a023*a092);
  a092=(a057+a092);
  a092=(a014*a092);
  a096=(a028*a096);
  a101=(a024*a101);
  a096=(a096-a101);
  a096=(a096+a016);
  a096=(a011*a096);
  a096=(a027-a096);
  a096=(a096+a091);
  a096=(a026*a096);
  a092=(a092+a096);
  a100=(a100-a092);
  a092=(a099*a055);
  a100=(a100-a092);
  a092=(a095*a099);
  a092=(a007-a092);
  a096=(a100/a092);
  a093=(a030*a093);
  a097=(a093/a097);
  a095=(a095*a097);
  a092=(a095/a092);
  a055=(a097*a055);
  a091=(a030*a072);
  a091=(a091*a072);
  a091=(a091*a094);
  a094=(a079*a041);
  a101=(a073*a025);
  a094=(a094+a101);
  a101=(a075*a050);
  a094=(a094+a101);
  a101=(a080*a006);
  a094=(a094+a101);
  a101=(a071*a053);
  a094=(a094+a101);
  a101=(a074*a061);
  a094=(a094+a101);
  a069=(a069*a009);
  a063=(a063*a040);
  a069=(a069+a063);
  a065=(a065*a038);
  a069=(a069+a065);
  a070=(a070*a031);
  a069=(a069+a070);
  a037=(a037*a035);
  a069=(a069+a037);
  a064=(a064*a021);
  a069=(a069+a064);
  a069=(a041+a069);
  a064=(a054*a069);
  a094=(a094+a064);
  a094=(a032+a094);
  a094=(a012*a094);
  a091=(a091+a094);
  a055=(a055-a091);
  a100=(a092*a100);
  a055=(a055-a100);
  a093=(a093*a097);
  a093=(a030-a093);
  a095=(a095*a092);
  a093=(a093-a095);
  a055=(a055/a093);
  a092=(a092*a055);
  a096=(a096-a092);
  a099=(a099*a096);
  a098=(a098-a099);
  a097=(a097*a055);
  a098=(a098+a097);
  a097=(a062*a098);
  a082=(a082+a097);
  a082=(a003+a082);
  a097=(a087*a082);
  a004=(a004+a097);
  a097=4.4710615727772587e-02;
  a097=(a097*a002);
  a099=2.2733101475165380e+00;
  a099=(a099*a002);
  a092=(a099*a020);
  a093=-1.0534495466737249e+01;
  a093=(a093*a002);
  a034=(a093*a034);
  a092=(a092+a034);
  a034=-2.0008720582248625e+00;
  a034=(a034*a002);
  a052=(a034*a052);
  a092=(a092+a052);
  a052=-1.7958931863118799e+01;
  a052=(a052*a002);
  a095=(a052*a060);
  a092=(a092+a095);
  a095=2.7948884529419960e+01;
  a095=(a095*a002);
  a100=(a095*a068);
  a092=(a092+a100);
  a100=-2.8589982771350235e+00;
  a100=(a100*a002);
  a091=(a100*a078);
  a092=(a092+a091);
  a091=-8.8728569335306293e+00;
  a091=(a091*a002);
  a094=(a091*a088);
  a092=(a092+a094);
  a094=1.2360567175794303e+01;
  a094=(a094*a002);
  a064=(a094*a098);
  a092=(a092+a064);
  a064=6.4339274601576357e-01;
  a064=(a064*a002);
  a002=(a089*a029);
  a037=(a083*a049);
  a002=(a002+a037);
  a037=(a085*a033);
  a002=(a002+a037);
  a037=(a090*a058);
  a002=(a002+a037);
  a037=(a081*a066);
  a002=(a002+a037);
  a037=(a084*a076);
  a002=(a002+a037);
  a037=(a013*a086);
  a002=(a002+a037);
  a037=(a062*a096);
  a002=(a002+a037);
  a002=(a008+a002);
  a037=(a007*a002);
  a070=(a089*a008);
  a065=(a083*a015);
  a070=(a070+a065);
  a065=(a085*a047);
  a070=(a070+a065);
  a065=(a090*a051);
  a070=(a070+a065);
  a065=(a081*a056);
  a070=(a070+a065);
  a065=(a084*a039);
  a070=(a070+a065);
  a065=(a013*a043);
  a070=(a070+a065);
  a065=(a062*a057);
  a070=(a070+a065);
  a070=(a010+a070);
  a065=sin(a070);
  a037=(a037*a065);
  a063=(2.*a082);
  a063=(a002-a063);
  a037=(a037*a063);
  a063=(a089*a003);
  a101=(a083*a045);
  a063=(a063+a101);
  a101=(a085*a046);
  a063=(a063+a101);
  a101=(a090*a019);
  a063=(a063+a101);
  a101=(a081*a042);
  a063=(a063+a101);
  a101=(a084*a022);
  a063=(a063+a101);
  a101=(a013*a048);
  a063=(a063+a101);
  a101=(a062*a072);
  a063=(a063+a101);
  a063=(a000+a063);
  a101=sin(a063);
  a102=cos(a070);
  a103=(a101*a102);
  a063=cos(a063);
  a104=(a063*a065);
  a103=(a103-a104);
  a104=(a007*a103);
  a037=(a037-a104);
  a104=(a101*a017);
  a037=(a037+a104);
  a104=(a016-a102);
  a104=(a018*a104);
  a104=(a104+a016);
  a105=(a037/a104);
  a102=(a102-a016);
  a102=(a007*a102);
  a106=(a102/a104);
  a107=casadi_sq(a082);
  a107=(a107*a065);
  a107=(a107+a103);
  a107=(a007*a107);
  a103=arg[2]? arg[2][20] : 0;
  a065=(a024*a103);
  a108=arg[2]? arg[2][21] : 0;
  a109=(a028*a108);
  a065=(a065+a109);
  a065=(a023*a065);
  a065=(a002+a065);
  a065=(a014*a065);
  a103=(a028*a103);
  a108=(a024*a108);
  a103=(a103-a108);
  a103=(a103+a016);
  a103=(a011*a103);
  a103=(a027-a103);
  a103=(a103+a070);
  a103=(a026*a103);
  a065=(a065+a103);
  a107=(a107-a065);
  a065=(a106*a037);
  a107=(a107-a065);
  a065=(a102*a106);
  a065=(a007-a065);
  a103=(a107/a065);
  a063=(a030*a063);
  a104=(a063/a104);
  a102=(a102*a104);
  a065=(a102/a065);
  a037=(a104*a037);
  a070=(a030*a082);
  a070=(a070*a082);
  a070=(a070*a101);
  a101=(a089*a041);
  a108=(a083*a025);
  a101=(a101+a108);
  a108=(a085*a050);
  a101=(a101+a108);
  a108=(a090*a006);
  a101=(a101+a108);
  a108=(a081*a053);
  a101=(a101+a108);
  a108=(a084*a061);
  a101=(a101+a108);
  a108=(a013*a069);
  a101=(a101+a108);
  a079=(a079*a009);
  a073=(a073*a040);
  a079=(a079+a073);
  a075=(a075*a038);
  a079=(a079+a075);
  a080=(a080*a031);
  a079=(a079+a080);
  a071=(a071*a035);
  a079=(a079+a071);
  a074=(a074*a021);
  a079=(a079+a074);
  a054=(a054*a044);
  a079=(a079+a054);
  a079=(a041+a079);
  a054=(a062*a079);
  a101=(a101+a054);
  a101=(a032+a101);
  a101=(a012*a101);
  a070=(a070+a101);
  a037=(a037-a070);
  a107=(a065*a107);
  a037=(a037-a107);
  a063=(a063*a104);
  a063=(a030-a063);
  a102=(a102*a065);
  a063=(a063-a102);
  a037=(a037/a063);
  a065=(a065*a037);
  a103=(a103-a065);
  a106=(a106*a103);
  a105=(a105-a106);
  a104=(a104*a037);
  a105=(a105+a104);
  a104=(a064*a105);
  a092=(a092+a104);
  a092=(a003+a092);
  a104=(a097*a092);
  a004=(a004+a104);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a104=(a005*a051);
  a004=(a004+a104);
  a104=(a036*a056);
  a004=(a004+a104);
  a104=(a059*a039);
  a004=(a004+a104);
  a104=(a067*a043);
  a004=(a004+a104);
  a104=(a077*a057);
  a004=(a004+a104);
  a104=(a087*a002);
  a004=(a004+a104);
  a104=(a099*a029);
  a049=(a093*a049);
  a104=(a104+a049);
  a033=(a034*a033);
  a104=(a104+a033);
  a033=(a052*a058);
  a104=(a104+a033);
  a033=(a095*a066);
  a104=(a104+a033);
  a033=(a100*a076);
  a104=(a104+a033);
  a033=(a091*a086);
  a104=(a104+a033);
  a033=(a094*a096);
  a104=(a104+a033);
  a033=(a064*a103);
  a104=(a104+a033);
  a104=(a008+a104);
  a033=(a097*a104);
  a004=(a004+a033);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a041);
  a033=(a005*a006);
  a004=(a004+a033);
  a033=(a036*a053);
  a004=(a004+a033);
  a033=(a059*a061);
  a004=(a004+a033);
  a033=(a067*a069);
  a004=(a004+a033);
  a033=(a077*a079);
  a004=(a004+a033);
  a089=(a089*a009);
  a083=(a083*a040);
  a089=(a089+a083);
  a085=(a085*a038);
  a089=(a089+a085);
  a090=(a090*a031);
  a089=(a089+a090);
  a081=(a081*a035);
  a089=(a089+a081);
  a084=(a084*a021);
  a089=(a089+a084);
  a013=(a013*a044);
  a089=(a089+a013);
  a062=(a062*a055);
  a089=(a089+a062);
  a089=(a041+a089);
  a062=(a087*a089);
  a004=(a004+a062);
  a062=(a099*a009);
  a040=(a093*a040);
  a062=(a062+a040);
  a038=(a034*a038);
  a062=(a062+a038);
  a038=(a052*a031);
  a062=(a062+a038);
  a038=(a095*a035);
  a062=(a062+a038);
  a038=(a100*a021);
  a062=(a062+a038);
  a038=(a091*a044);
  a062=(a062+a038);
  a038=(a094*a055);
  a062=(a062+a038);
  a038=(a064*a037);
  a062=(a062+a038);
  a062=(a041+a062);
  a062=(a097*a062);
  a004=(a004+a062);
  a004=(a032+a004);
  if (res[0]!=0) res[0][2]=a004;
  a020=(a001*a020);
  a060=(a005*a060);
  a020=(a020+a060);
  a068=(a036*a068);
  a020=(a020+a068);
  a078=(a059*a078);
  a020=(a020+a078);
  a088=(a067*a088);
  a020=(a020+a088);
  a098=(a077*a098);
  a020=(a020+a098);
  a105=(a087*a105);
  a020=(a020+a105);
  a105=(a007*a104);
  a098=(a099*a008);
  a015=(a093*a015);
  a098=(a098+a015);
  a047=(a034*a047);
  a098=(a098+a047);
  a051=(a052*a051);
  a098=(a098+a051);
  a056=(a095*a056);
  a098=(a098+a056);
  a039=(a100*a039);
  a098=(a098+a039);
  a043=(a091*a043);
  a098=(a098+a043);
  a057=(a094*a057);
  a098=(a098+a057);
  a002=(a064*a002);
  a098=(a098+a002);
  a010=(a010+a098);
  a098=sin(a010);
  a105=(a105*a098);
  a002=(2.*a092);
  a002=(a104-a002);
  a105=(a105*a002);
  a002=(a099*a003);
  a045=(a093*a045);
  a002=(a002+a045);
  a046=(a034*a046);
  a002=(a002+a046);
  a019=(a052*a019);
  a002=(a002+a019);
  a042=(a095*a042);
  a002=(a002+a042);
  a022=(a100*a022);
  a002=(a002+a022);
  a048=(a091*a048);
  a002=(a002+a048);
  a072=(a094*a072);
  a002=(a002+a072);
  a082=(a064*a082);
  a002=(a002+a082);
  a000=(a000+a002);
  a002=sin(a000);
  a082=cos(a010);
  a072=(a002*a082);
  a000=cos(a000);
  a048=(a000*a098);
  a072=(a072-a048);
  a048=(a007*a072);
  a105=(a105-a048);
  a017=(a002*a017);
  a105=(a105+a017);
  a017=(a016-a082);
  a018=(a018*a017);
  a018=(a018+a016);
  a017=(a105/a018);
  a082=(a082-a016);
  a082=(a007*a082);
  a048=(a082/a018);
  a022=casadi_sq(a092);
  a022=(a022*a098);
  a022=(a022+a072);
  a022=(a007*a022);
  a072=arg[2]? arg[2][22] : 0;
  a098=(a024*a072);
  a042=arg[2]? arg[2][23] : 0;
  a019=(a028*a042);
  a098=(a098+a019);
  a023=(a023*a098);
  a104=(a104+a023);
  a014=(a014*a104);
  a028=(a028*a072);
  a024=(a024*a042);
  a028=(a028-a024);
  a028=(a028+a016);
  a011=(a011*a028);
  a027=(a027-a011);
  a027=(a027+a010);
  a026=(a026*a027);
  a014=(a014+a026);
  a022=(a022-a014);
  a014=(a048*a105);
  a022=(a022-a014);
  a014=(a082*a048);
  a007=(a007-a014);
  a014=(a022/a007);
  a000=(a030*a000);
  a018=(a000/a018);
  a082=(a082*a018);
  a007=(a082/a007);
  a105=(a018*a105);
  a026=(a030*a092);
  a026=(a026*a092);
  a026=(a026*a002);
  a099=(a099*a041);
  a093=(a093*a025);
  a099=(a099+a093);
  a034=(a034*a050);
  a099=(a099+a034);
  a052=(a052*a006);
  a099=(a099+a052);
  a095=(a095*a053);
  a099=(a099+a095);
  a100=(a100*a061);
  a099=(a099+a100);
  a091=(a091*a069);
  a099=(a099+a091);
  a094=(a094*a079);
  a099=(a099+a094);
  a064=(a064*a089);
  a099=(a099+a064);
  a032=(a032+a099);
  a012=(a012*a032);
  a026=(a026+a012);
  a105=(a105-a026);
  a022=(a007*a022);
  a105=(a105-a022);
  a000=(a000*a018);
  a030=(a030-a000);
  a082=(a082*a007);
  a030=(a030-a082);
  a105=(a105/a030);
  a007=(a007*a105);
  a014=(a014-a007);
  a048=(a048*a014);
  a017=(a017-a048);
  a018=(a018*a105);
  a017=(a017+a018);
  a017=(a097*a017);
  a020=(a020+a017);
  a003=(a003+a020);
  if (res[0]!=0) res[0][3]=a003;
  a029=(a001*a029);
  a058=(a005*a058);
  a029=(a029+a058);
  a066=(a036*a066);
  a029=(a029+a066);
  a076=(a059*a076);
  a029=(a029+a076);
  a086=(a067*a086);
  a029=(a029+a086);
  a096=(a077*a096);
  a029=(a029+a096);
  a103=(a087*a103);
  a029=(a029+a103);
  a014=(a097*a014);
  a029=(a029+a014);
  a008=(a008+a029);
  if (res[0]!=0) res[0][4]=a008;
  a001=(a001*a009);
  a005=(a005*a031);
  a001=(a001+a005);
  a036=(a036*a035);
  a001=(a001+a036);
  a059=(a059*a021);
  a001=(a001+a059);
  a067=(a067*a044);
  a001=(a001+a067);
  a077=(a077*a055);
  a001=(a001+a077);
  a087=(a087*a037);
  a001=(a001+a087);
  a097=(a097*a105);
  a001=(a001+a097);
  a041=(a041+a001);
  if (res[0]!=0) res[0][5]=a041;
  return 0;
}

/* plain_steps:(y[6],t,turns[2x12],h,p[8])->(y_end[6]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+110, w1, *w3=w+116, w5, *w6=w+118, w7;
  const casadi_real **arg1=arg+5, *wr2, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  wr2 = arg[4] ? arg[4] : casadi_zeros;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  wr4 = arg[2] ? arg[2] : casadi_zeros;
  /* #5: @5 = input[3][0] */
  w5 = arg[3] ? arg[3][0] : 0;
  /* #6: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #14: @7 = 3 */
  w7 = 3.;
  /* #15: @7 = (@7*@5) */
  w7 *= w5;
  /* #16: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #17: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #19: @7 = 4 */
  w7 = 4.;
  /* #20: @7 = (@7*@5) */
  w7 *= w5;
  /* #21: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #22: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = 5 */
  w7 = 5.;
  /* #25: @7 = (@7*@5) */
  w7 *= w5;
  /* #26: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #27: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #29: @7 = 6 */
  w7 = 6.;
  /* #30: @7 = (@7*@5) */
  w7 *= w5;
  /* #31: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #32: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = 7 */
  w7 = 7.;
  /* #35: @7 = (@7*@5) */
  w7 *= w5;
  /* #36: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #37: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #39: @7 = 8 */
  w7 = 8.;
  /* #40: @7 = (@7*@5) */
  w7 *= w5;
  /* #41: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #42: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #44: @7 = 9 */
  w7 = 9.;
  /* #45: @7 = (@7*@5) */
  w7 *= w5;
  /* #46: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #47: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #49: @7 = 10 */
  w7 = 10.;
  /* #50: @7 = (@7*@5) */
  w7 *= w5;
  /* #51: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #52: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = 11 */
  w7 = 11.;
  /* #55: @7 = (@7*@5) */
  w7 *= w5;
  /* #56: @1 = (@1+@7) */
  w1 += w7;
  /* #57: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* landing:(y[6],z[5],p[8])->(R[6]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00-a01);
  a03=arg[1]? arg[1][0] : 0;
  a03=(a02-a03);
  if (res[0]!=0) res[0][0]=a03;
  a03=cos(a01);
  a04=arg[0]? arg[0][3] : 0;
  a05=(a03*a04);
  a06=arg[2]? arg[2][1] : 0;
  a02=cos(a02);
  a02=(a06*a02);
  a07=arg[0]? arg[0][5] : 0;
  a08=(a02*a07);
  a05=(a05-a08);
  a08=arg[2]? arg[2][3] : 0;
  a09=(2.*a08);
  a10=1.;
  a11=(a10-a03);
  a09=(a09*a11);
  a09=(a09+a10);
  a11=(a05/a09);
  a03=(a03-a10);
  a03=(a08*a03);
  a10=(a03/a09);
  a12=(a10*a05);
  a13=(a03*a10);
  a08=(a08-a13);
  a13=(a12/a08);
  a09=(a02/a09);
  a03=(a03*a09);
  a08=(a03/a08);
  a14=cos(a00);
  a14=(a14*a04);
  a07=(a07-a14);
  a07=(a06*a07);
  a05=(a09*a05);
  a07=(a07+a05);
  a12=(a08*a12);
  a07=(a07+a12);
  a02=(a02*a09);
  a06=(a06-a02);
  a03=(a03*a08);
  a06=(a06-a03);
  a07=(a07/a06);
  a08=(a08*a07);
  a13=(a13+a08);
  a10=(a10*a13);
  a11=(a11+a10);
  a09=(a09*a07);
  a11=(a11+a09);
  a09=arg[1]? arg[1][1] : 0;
  a11=(a11-a09);
  if (res[0]!=0) res[0][1]=a11;
  a11=arg[1]? arg[1][2] : 0;
  a13=(a13+a11);
  a13=(-a13);
  if (res[0]!=0) res[0][2]=a13;
  a13=arg[0]? arg[0][2] : 0;
  a11=arg[1]? arg[1][3] : 0;
  a13=(a13-a11);
  if (res[0]!=0) res[0][3]=a13;
  a13=arg[1]? arg[1][4] : 0;
  a07=(a07-a13);
  if (res[0]!=0) res[0][4]=a07;
  a00=(2.*a00);
  a01=(a01-a00);
  if (res[0]!=0) res[0][5]=a01;
  return 0;
}

/* wobbling_residual_12:(u[6],p[8])->(R[6]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 12 */
  w6 = 12.;
  /* #7: @5 = (@5/@6) */
  w5 /= w6;
  /* #8: @7 = turns(@5, @2) */
  arg1[0]=(&w5);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @5, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w5);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @3 = landing(@0, @1, @2) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w3;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @3 */
  casadi_copy(w3, 6, res[0]);
  return 0;
}

/* wobbling_search_12:(u0[6],p[8])->(u[6],R[6]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+809, *w2=w+815;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: @0 = wobbling_residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 821;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 821*sizeof(casadi_real);
  return 0;
}

/* wobbling_jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 24 */
  w08 = 24.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+577, *w1=w+613, *w3=w+619, *w4=w+655;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = wobbling_jacobian_24(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_24:(u0[6],p[8])->(u[6]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f18(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_24:(i0[6],i1[8])->(o0[6]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+789, *w2=w+795;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f17(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_residual_24:(u[6],p[8])->(R[6]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 24 */
  w6 = 24.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* wobbling_search_24:(u0[6],p[8])->(u[6],R[6]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+809, *w2=w+815;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: @0 = wobbling_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 821;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 821*sizeof(casadi_real);
  return 0;
}

/* wobbling_jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 48 */
  w08 = 48.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.25 */
  w06 = 2.5000000000000000e-01;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.75 */
  w06 = 7.5000000000000000e-01;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+577, *w1=w+613, *w3=w+619, *w4=w+655;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = wobbling_jacobian_48(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_48:(u0[6],p[8])->(u[6]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f24(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_48:(i0[6],i1[8])->(o0[6]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+789, *w2=w+795;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f23(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_residual_48:(u[6],p[8])->(R[6]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 48 */
  w6 = 48.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* wobbling_search_48:(u0[6],p[8])->(u[6],R[6]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+809, *w2=w+815;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: @0 = wobbling_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 821;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 821*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_24(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f31(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_24:(u0[6],p[8])->(u[6]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f30(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_24:(i0[6],i1[8])->(o0[6]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f29(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_limit_cycle_24:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_36:(u[6],p[8])->(R[6]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 36 */
  w6 = 36.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @3 = landing(@0, @1, @2) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w3;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][0] = @3 */
  casadi_copy(w3, 6, res[0]);
  return 0;
}

/* coarse_jacobian_36:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f37(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_36:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_36(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_36:(u0[6],p[8])->(u[6]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f35(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_36:(i0[6],i1[8])->(o0[6]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_36:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 36 */
  w08 = 36.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.333333 */
  w06 = 3.3333333333333331e-01;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.666667 */
  w06 = 6.6666666666666663e-01;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@5, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w05;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @5 */
  casadi_copy(w05, 36, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_36:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_36(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_48(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f43(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_48:(u0[6],p[8])->(u[6]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f42(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_48:(i0[6],i1[8])->(o0[6]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_limit_cycle_48:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_72:(u[6],p[8])->(R[6]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 72 */
  w6 = 72.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* coarse_jacobian_72:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f49(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_72:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_72(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f48(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_72:(u0[6],p[8])->(u[6]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f47(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_72:(i0[6],i1[8])->(o0[6]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_72:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 72 */
  w08 = 72.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.166667 */
  w06 = 1.6666666666666666e-01;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.333333 */
  w06 = 3.3333333333333331e-01;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: @6 = 0.666667 */
  w06 = 6.6666666666666663e-01;
  /* #21: @6 = (@6*@7) */
  w06 *= w07;
  /* #22: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = 0.833333 */
  w06 = 8.3333333333333337e-01;
  /* #24: @6 = (@6*@7) */
  w06 *= w07;
  /* #25: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_72:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_72(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_96:(u[6],p[8])->(R[6]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 96 */
  w6 = 96.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* coarse_jacobian_96:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_96:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_96(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f55(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_96:(u0[6],p[8])->(u[6]) */
static int casadi_f53(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f54(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_96:(i0[6],i1[8])->(o0[6]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_96:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 96 */
  w08 = 96.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.125 */
  w06 = 1.2500000000000000e-01;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.25 */
  w06 = 2.5000000000000000e-01;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.375 */
  w06 = 3.7500000000000000e-01;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #21: @6 = (@6*@7) */
  w06 *= w07;
  /* #22: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = 0.625 */
  w06 = 6.2500000000000000e-01;
  /* #24: @6 = (@6*@7) */
  w06 *= w07;
  /* #25: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: @6 = 0.75 */
  w06 = 7.5000000000000000e-01;
  /* #27: @6 = (@6*@7) */
  w06 *= w07;
  /* #28: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #29: @6 = 0.875 */
  w06 = 8.7500000000000000e-01;
  /* #30: @6 = (@6*@7) */
  w06 *= w07;
  /* #31: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_96:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f52(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_144:(u[6],p[8])->(R[6]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 144 */
  w6 = 144.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0833333 */
  w4 = 8.3333333333333329e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.416667 */
  w4 = 4.1666666666666669e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.583333 */
  w4 = 5.8333333333333337e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.916667 */
  w4 = 9.1666666666666663e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* coarse_jacobian_144:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_144:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_144(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f62(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_144:(u0[6],p[8])->(u[6]) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f61(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_144:(i0[6],i1[8])->(o0[6]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_144:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 144 */
  w08 = 144.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.0833333 */
  w06 = 8.3333333333333329e-02;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.166667 */
  w06 = 1.6666666666666666e-01;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.25 */
  w06 = 2.5000000000000000e-01;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: @6 = 0.333333 */
  w06 = 3.3333333333333331e-01;
  /* #21: @6 = (@6*@7) */
  w06 *= w07;
  /* #22: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = 0.416667 */
  w06 = 4.1666666666666669e-01;
  /* #24: @6 = (@6*@7) */
  w06 *= w07;
  /* #25: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #27: @6 = (@6*@7) */
  w06 *= w07;
  /* #28: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #29: @6 = 0.583333 */
  w06 = 5.8333333333333337e-01;
  /* #30: @6 = (@6*@7) */
  w06 *= w07;
  /* #31: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: @6 = 0.666667 */
  w06 = 6.6666666666666663e-01;
  /* #33: @6 = (@6*@7) */
  w06 *= w07;
  /* #34: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #35: @6 = 0.75 */
  w06 = 7.5000000000000000e-01;
  /* #36: @6 = (@6*@7) */
  w06 *= w07;
  /* #37: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #38: @6 = 0.833333 */
  w06 = 8.3333333333333337e-01;
  /* #39: @6 = (@6*@7) */
  w06 *= w07;
  /* #40: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #41: @6 = 0.916667 */
  w06 = 9.1666666666666663e-01;
  /* #42: @6 = (@6*@7) */
  w06 *= w07;
  /* #43: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_144:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f59(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_144(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f58(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_192:(u[6],p[8])->(R[6]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 192 */
  w6 = 192.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0625 */
  w4 = 6.2500000000000000e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.1875 */
  w4 = 1.8750000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.3125 */
  w4 = 3.1250000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.4375 */
  w4 = 4.3750000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.5625 */
  w4 = 5.6250000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.6875 */
  w4 = 6.8750000000000000e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.8125 */
  w4 = 8.1250000000000000e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.9375 */
  w4 = 9.3750000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* coarse_jacobian_192:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f70(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_192:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_192(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f69(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_192:(u0[6],p[8])->(u[6]) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f68(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_192:(i0[6],i1[8])->(o0[6]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f67(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_192:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 192 */
  w08 = 192.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.0625 */
  w06 = 6.2500000000000000e-02;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.125 */
  w06 = 1.2500000000000000e-01;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.1875 */
  w06 = 1.8750000000000000e-01;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: @6 = 0.25 */
  w06 = 2.5000000000000000e-01;
  /* #21: @6 = (@6*@7) */
  w06 *= w07;
  /* #22: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = 0.3125 */
  w06 = 3.1250000000000000e-01;
  /* #24: @6 = (@6*@7) */
  w06 *= w07;
  /* #25: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: @6 = 0.375 */
  w06 = 3.7500000000000000e-01;
  /* #27: @6 = (@6*@7) */
  w06 *= w07;
  /* #28: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #29: @6 = 0.4375 */
  w06 = 4.3750000000000000e-01;
  /* #30: @6 = (@6*@7) */
  w06 *= w07;
  /* #31: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #33: @6 = (@6*@7) */
  w06 *= w07;
  /* #34: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #35: @6 = 0.5625 */
  w06 = 5.6250000000000000e-01;
  /* #36: @6 = (@6*@7) */
  w06 *= w07;
  /* #37: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #38: @6 = 0.625 */
  w06 = 6.2500000000000000e-01;
  /* #39: @6 = (@6*@7) */
  w06 *= w07;
  /* #40: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #41: @6 = 0.6875 */
  w06 = 6.8750000000000000e-01;
  /* #42: @6 = (@6*@7) */
  w06 *= w07;
  /* #43: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #44: @6 = 0.75 */
  w06 = 7.5000000000000000e-01;
  /* #45: @6 = (@6*@7) */
  w06 *= w07;
  /* #46: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #47: @6 = 0.8125 */
  w06 = 8.1250000000000000e-01;
  /* #48: @6 = (@6*@7) */
  w06 *= w07;
  /* #49: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #50: @6 = 0.875 */
  w06 = 8.7500000000000000e-01;
  /* #51: @6 = (@6*@7) */
  w06 *= w07;
  /* #52: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = 0.9375 */
  w06 = 9.3750000000000000e-01;
  /* #54: @6 = (@6*@7) */
  w06 *= w07;
  /* #55: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_192:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f65(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_288:(u[6],p[8])->(R[6]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 288 */
  w6 = 288.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0416667 */
  w4 = 4.1666666666666664e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.0833333 */
  w4 = 8.3333333333333329e-02;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.208333 */
  w4 = 2.0833333333333334e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.291667 */
  w4 = 2.9166666666666669e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.416667 */
  w4 = 4.1666666666666669e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.458333 */
  w4 = 4.5833333333333331e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.541667 */
  w4 = 5.4166666666666663e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.583333 */
  w4 = 5.8333333333333337e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #56: @4 = (@4*@5) */
  w4 *= w5;
  /* #57: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #58: @4 = 0.708333 */
  w4 = 7.0833333333333337e-01;
  /* #59: @4 = (@4*@5) */
  w4 *= w5;
  /* #60: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #61: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #62: @4 = (@4*@5) */
  w4 *= w5;
  /* #63: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #64: @4 = 0.791667 */
  w4 = 7.9166666666666663e-01;
  /* #65: @4 = (@4*@5) */
  w4 *= w5;
  /* #66: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #67: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #68: @4 = (@4*@5) */
  w4 *= w5;
  /* #69: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #70: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #71: @4 = (@4*@5) */
  w4 *= w5;
  /* #72: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #73: @4 = 0.916667 */
  w4 = 9.1666666666666663e-01;
  /* #74: @4 = (@4*@5) */
  w4 *= w5;
  /* #75: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #76: @4 = 0.958333 */
  w4 = 9.5833333333333337e-01;
  /* #77: @4 = (@4*@5) */
  w4 *= w5;
  /* #78: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #79: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* coarse_jacobian_288:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_288:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_288(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f76(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_288:(u0[6],p[8])->(u[6]) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f75(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_288:(i0[6],i1[8])->(o0[6]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f74(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_288:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 288 */
  w08 = 288.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.0416667 */
  w06 = 4.1666666666666664e-02;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.0833333 */
  w06 = 8.3333333333333329e-02;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.125 */
  w06 = 1.2500000000000000e-01;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: @6 = 0.166667 */
  w06 = 1.6666666666666666e-01;
  /* #21: @6 = (@6*@7) */
  w06 *= w07;
  /* #22: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = 0.208333 */
  w06 = 2.0833333333333334e-01;
  /* #24: @6 = (@6*@7) */
  w06 *= w07;
  /* #25: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: @6 = 0.25 */
  w06 = 2.5000000000000000e-01;
  /* #27: @6 = (@6*@7) */
  w06 *= w07;
  /* #28: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #29: @6 = 0.291667 */
  w06 = 2.9166666666666669e-01;
  /* #30: @6 = (@6*@7) */
  w06 *= w07;
  /* #31: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: @6 = 0.333333 */
  w06 = 3.3333333333333331e-01;
  /* #33: @6 = (@6*@7) */
  w06 *= w07;
  /* #34: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #35: @6 = 0.375 */
  w06 = 3.7500000000000000e-01;
  /* #36: @6 = (@6*@7) */
  w06 *= w07;
  /* #37: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #38: @6 = 0.416667 */
  w06 = 4.1666666666666669e-01;
  /* #39: @6 = (@6*@7) */
  w06 *= w07;
  /* #40: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #41: @6 = 0.458333 */
  w06 = 4.5833333333333331e-01;
  /* #42: @6 = (@6*@7) */
  w06 *= w07;
  /* #43: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #44: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #45: @6 = (@6*@7) */
  w06 *= w07;
  /* #46: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #47: @6 = 0.541667 */
  w06 = 5.4166666666666663e-01;
  /* #48: @6 = (@6*@7) */
  w06 *= w07;
  /* #49: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #50: @6 = 0.583333 */
  w06 = 5.8333333333333337e-01;
  /* #51: @6 = (@6*@7) */
  w06 *= w07;
  /* #52: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = 0.625 */
  w06 = 6.2500000000000000e-01;
  /* #54: @6 = (@6*@7) */
  w06 *= w07;
  /* #55: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #56: @6 = 0.666667 */
  w06 = 6.6666666666666663e-01;
  /* #57: @6 = (@6*@7) */
  w06 *= w07;
  /* #58: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #59: @6 = 0.708333 */
  w06 = 7.0833333333333337e-01;
  /* #60: @6 = (@6*@7) */
  w06 *= w07;
  /* #61: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #62: @6 = 0.75 */
  w06 = 7.5000000000000000e-01;
  /* #63: @6 = (@6*@7) */
  w06 *= w07;
  /* #64: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #65: @6 = 0.791667 */
  w06 = 7.9166666666666663e-01;
  /* #66: @6 = (@6*@7) */
  w06 *= w07;
  /* #67: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #68: @6 = 0.833333 */
  w06 = 8.3333333333333337e-01;
  /* #69: @6 = (@6*@7) */
  w06 *= w07;
  /* #70: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #71: @6 = 0.875 */
  w06 = 8.7500000000000000e-01;
  /* #72: @6 = (@6*@7) */
  w06 *= w07;
  /* #73: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #74: @6 = 0.916667 */
  w06 = 9.1666666666666663e-01;
  /* #75: @6 = (@6*@7) */
  w06 *= w07;
  /* #76: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #77: @6 = 0.958333 */
  w06 = 9.5833333333333337e-01;
  /* #78: @6 = (@6*@7) */
  w06 *= w07;
  /* #79: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_288:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f73(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_288(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_384:(u[6],p[8])->(R[6]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+159, *w1=w+165, *w3=w+170, w4, w5, w6, *w7=w+176;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[5] */
  for (rr=(&w5), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @6 = 384 */
  w6 = 384.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=wr2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.03125 */
  w4 = 3.1250000000000000e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.0625 */
  w4 = 6.2500000000000000e-02;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.09375 */
  w4 = 9.3750000000000000e-02;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.15625 */
  w4 = 1.5625000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.1875 */
  w4 = 1.8750000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.21875 */
  w4 = 2.1875000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.28125 */
  w4 = 2.8125000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.3125 */
  w4 = 3.1250000000000000e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.34375 */
  w4 = 3.4375000000000000e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.40625 */
  w4 = 4.0625000000000000e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.4375 */
  w4 = 4.3750000000000000e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.46875 */
  w4 = 4.6875000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #56: @4 = (@4*@5) */
  w4 *= w5;
  /* #57: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #58: @4 = 0.53125 */
  w4 = 5.3125000000000000e-01;
  /* #59: @4 = (@4*@5) */
  w4 *= w5;
  /* #60: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #61: @4 = 0.5625 */
  w4 = 5.6250000000000000e-01;
  /* #62: @4 = (@4*@5) */
  w4 *= w5;
  /* #63: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #64: @4 = 0.59375 */
  w4 = 5.9375000000000000e-01;
  /* #65: @4 = (@4*@5) */
  w4 *= w5;
  /* #66: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #67: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #68: @4 = (@4*@5) */
  w4 *= w5;
  /* #69: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #70: @4 = 0.65625 */
  w4 = 6.5625000000000000e-01;
  /* #71: @4 = (@4*@5) */
  w4 *= w5;
  /* #72: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #73: @4 = 0.6875 */
  w4 = 6.8750000000000000e-01;
  /* #74: @4 = (@4*@5) */
  w4 *= w5;
  /* #75: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #76: @4 = 0.71875 */
  w4 = 7.1875000000000000e-01;
  /* #77: @4 = (@4*@5) */
  w4 *= w5;
  /* #78: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #79: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #80: @4 = (@4*@5) */
  w4 *= w5;
  /* #81: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #82: @4 = 0.78125 */
  w4 = 7.8125000000000000e-01;
  /* #83: @4 = (@4*@5) */
  w4 *= w5;
  /* #84: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #85: @4 = 0.8125 */
  w4 = 8.1250000000000000e-01;
  /* #86: @4 = (@4*@5) */
  w4 *= w5;
  /* #87: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #88: @4 = 0.84375 */
  w4 = 8.4375000000000000e-01;
  /* #89: @4 = (@4*@5) */
  w4 *= w5;
  /* #90: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #91: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #92: @4 = (@4*@5) */
  w4 *= w5;
  /* #93: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #94: @4 = 0.90625 */
  w4 = 9.0625000000000000e-01;
  /* #95: @4 = (@4*@5) */
  w4 *= w5;
  /* #96: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #97: @4 = 0.9375 */
  w4 = 9.3750000000000000e-01;
  /* #98: @4 = (@4*@5) */
  w4 *= w5;
  /* #99: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #100: @4 = 0.96875 */
  w4 = 9.6875000000000000e-01;
  /* #101: @4 = (@4*@5) */
  w4 *= w5;
  /* #102: @3 = plain_steps(@0, @4, @7, @6, @2) */
  arg1[0]=w0;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=wr2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #103: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=wr2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* coarse_jacobian_384:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+577, *w2=w+583, *w3=w+619;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: {@2, NULL} = wobbling_jacobian_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 36, res[0]);
  /* #4: @3 = wobbling_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w3;
  if (casadi_f84(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 6, res[1]);
  return 0;
}

/* scaled_jacobian_384:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+633, *w1=w+669, *w3=w+675, *w4=w+711;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0, *wr2;
  /* #0: @0 = 
  [[1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [1, 1, 1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w1);
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = coarse_jacobian_384(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f83(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<36; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  /* #6: @1 = [1, 1, 1, 1, 1, 2] */
  casadi_copy(casadi_c1, 6, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<6; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 6, res[1]);
  return 0;
}

/* newton_384:(u0[6],p[8])->(u[6]) */
static int casadi_f81(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+6;
  m.jac_g_x = w+12;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+48;
  m.lin_v = w+60;
  m.lin_r = w+81;
  m.lin_beta = w+102;
  /* Get the initial guess */
  casadi_copy(arg[0], 6, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f82(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* scaled_newton_384:(i0[6],i1[8])->(o0[6]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+845, *w2=w+851;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f81(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_jacobian_384:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+423, *w01=w+429, *w03=w+434, *w04=w+440, *w05=w+470, w06, w07, w08, *w09=w+506, *w10=w+530;
  const casadi_real **arg1=arg+2, *cs, *wr02;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w00);
  /* #1: @1 = @0[:5] */
  for (rr=w01, cs=w00+0; cs!=w00+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr02 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=wr02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<30; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[5] */
  for (rr=(&w07), cs=w00+5; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #7: @8 = 384 */
  w08 = 384.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=wr02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: @6 = 0.03125 */
  w06 = 3.1250000000000000e-02;
  /* #12: @6 = (@6*@7) */
  w06 *= w07;
  /* #13: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: @6 = 0.0625 */
  w06 = 6.2500000000000000e-02;
  /* #15: @6 = (@6*@7) */
  w06 *= w07;
  /* #16: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: @6 = 0.09375 */
  w06 = 9.3750000000000000e-02;
  /* #18: @6 = (@6*@7) */
  w06 *= w07;
  /* #19: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: @6 = 0.125 */
  w06 = 1.2500000000000000e-01;
  /* #21: @6 = (@6*@7) */
  w06 *= w07;
  /* #22: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = 0.15625 */
  w06 = 1.5625000000000000e-01;
  /* #24: @6 = (@6*@7) */
  w06 *= w07;
  /* #25: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: @6 = 0.1875 */
  w06 = 1.8750000000000000e-01;
  /* #27: @6 = (@6*@7) */
  w06 *= w07;
  /* #28: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #29: @6 = 0.21875 */
  w06 = 2.1875000000000000e-01;
  /* #30: @6 = (@6*@7) */
  w06 *= w07;
  /* #31: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: @6 = 0.25 */
  w06 = 2.5000000000000000e-01;
  /* #33: @6 = (@6*@7) */
  w06 *= w07;
  /* #34: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #35: @6 = 0.28125 */
  w06 = 2.8125000000000000e-01;
  /* #36: @6 = (@6*@7) */
  w06 *= w07;
  /* #37: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #38: @6 = 0.3125 */
  w06 = 3.1250000000000000e-01;
  /* #39: @6 = (@6*@7) */
  w06 *= w07;
  /* #40: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #41: @6 = 0.34375 */
  w06 = 3.4375000000000000e-01;
  /* #42: @6 = (@6*@7) */
  w06 *= w07;
  /* #43: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #44: @6 = 0.375 */
  w06 = 3.7500000000000000e-01;
  /* #45: @6 = (@6*@7) */
  w06 *= w07;
  /* #46: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #47: @6 = 0.40625 */
  w06 = 4.0625000000000000e-01;
  /* #48: @6 = (@6*@7) */
  w06 *= w07;
  /* #49: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #50: @6 = 0.4375 */
  w06 = 4.3750000000000000e-01;
  /* #51: @6 = (@6*@7) */
  w06 *= w07;
  /* #52: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = 0.46875 */
  w06 = 4.6875000000000000e-01;
  /* #54: @6 = (@6*@7) */
  w06 *= w07;
  /* #55: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #56: @6 = 0.5 */
  w06 = 5.0000000000000000e-01;
  /* #57: @6 = (@6*@7) */
  w06 *= w07;
  /* #58: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #59: @6 = 0.53125 */
  w06 = 5.3125000000000000e-01;
  /* #60: @6 = (@6*@7) */
  w06 *= w07;
  /* #61: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #62: @6 = 0.5625 */
  w06 = 5.6250000000000000e-01;
  /* #63: @6 = (@6*@7) */
  w06 *= w07;
  /* #64: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #65: @6 = 0.59375 */
  w06 = 5.9375000000000000e-01;
  /* #66: @6 = (@6*@7) */
  w06 *= w07;
  /* #67: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #68: @6 = 0.625 */
  w06 = 6.2500000000000000e-01;
  /* #69: @6 = (@6*@7) */
  w06 *= w07;
  /* #70: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #71: @6 = 0.65625 */
  w06 = 6.5625000000000000e-01;
  /* #72: @6 = (@6*@7) */
  w06 *= w07;
  /* #73: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #74: @6 = 0.6875 */
  w06 = 6.8750000000000000e-01;
  /* #75: @6 = (@6*@7) */
  w06 *= w07;
  /* #76: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #77: @6 = 0.71875 */
  w06 = 7.1875000000000000e-01;
  /* #78: @6 = (@6*@7) */
  w06 *= w07;
  /* #79: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #80: @6 = 0.75 */
  w06 = 7.5000000000000000e-01;
  /* #81: @6 = (@6*@7) */
  w06 *= w07;
  /* #82: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #83: @6 = 0.78125 */
  w06 = 7.8125000000000000e-01;
  /* #84: @6 = (@6*@7) */
  w06 *= w07;
  /* #85: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #86: @6 = 0.8125 */
  w06 = 8.1250000000000000e-01;
  /* #87: @6 = (@6*@7) */
  w06 *= w07;
  /* #88: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #89: @6 = 0.84375 */
  w06 = 8.4375000000000000e-01;
  /* #90: @6 = (@6*@7) */
  w06 *= w07;
  /* #91: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #92: @6 = 0.875 */
  w06 = 8.7500000000000000e-01;
  /* #93: @6 = (@6*@7) */
  w06 *= w07;
  /* #94: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #95: @6 = 0.90625 */
  w06 = 9.0625000000000000e-01;
  /* #96: @6 = (@6*@7) */
  w06 *= w07;
  /* #97: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #98: @6 = 0.9375 */
  w06 = 9.3750000000000000e-01;
  /* #99: @6 = (@6*@7) */
  w06 *= w07;
  /* #100: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #101: @6 = 0.96875 */
  w06 = 9.6875000000000000e-01;
  /* #102: @6 = (@6*@7) */
  w06 *= w07;
  /* #103: @5 = variational_steps(@10, @6, @9, @8, @2) */
  arg1[0]=w10;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=wr02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=wr02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @10 */
  casadi_copy(w10, 36, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_384:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+865, *w2=w+871, *w3=w+877;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = scaled_newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f80(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = wobbling_jacobian_384(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f85(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f79(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 913;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 913*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_12_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_24_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_36_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f26(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_48_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f49(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_72_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_96_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f63(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_144_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_192_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f77(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_288_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_residual_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_residual_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_residual_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_residual_384_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_residual_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_residual_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_residual_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_residual_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 200;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 200*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f38(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_36_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f25(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_72_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_96_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f64(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_144_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_192_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f78(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_288_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_jacobian_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_jacobian_384_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_jacobian_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_jacobian_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_jacobian_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[7],phase[2],turns[2x12],h,p[8])->(y_end[7]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[3]? arg[3][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][3] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[4]? arg[4][3] : 0;
  a008=arg[0]? arg[0][4] : 0;
  a009=(a007*a008);
  a010=arg[0]? arg[0][1] : 0;
  a011=sin(a010);
  a009=(a009*a011);
  a012=(2.*a003);
  a012=(a008-a012);
  a009=(a009*a012);
  a012=sin(a000);
  a013=cos(a010);
  a014=(a012*a013);
  a015=cos(a000);
  a016=(a015*a011);
  a014=(a014-a016);
  a016=(a007*a014);
  a009=(a009-a016);
  a016=1.;
  a017=(a007+a016);
  a018=(a012*a017);
  a009=(a009+a018);
  a018=(2.*a007);
  a019=(a016-a013);
  a019=(a018*a019);
  a019=(a019+a016);
  a020=(a009/a019);
  a013=(a013-a016);
  a013=(a007*a013);
  a021=(a013/a019);
  a022=casadi_sq(a003);
  a022=(a022*a011);
  a022=(a022+a014);
  a022=(a007*a022);
  a014=arg[4]? arg[4][5] : 0;
  a011=arg[4]? arg[4][7] : 0;
  a023=arg[4]? arg[4][2] : 0;
  a023=(a011*a023);
  a024=arg[1]? arg[1][1] : 0;
  a025=(a023*a024);
  a025=(a008+a025);
  a025=(a014*a025);
  a026=arg[4]? arg[4][4] : 0;
  a027=arg[4]? arg[4][6] : 0;
  a028=arg[1]? arg[1][0] : 0;
  a029=(a028+a016);
  a029=(a011*a029);
  a029=(a027-a029);
  a029=(a029+a010);
  a029=(a026*a029);
  a025=(a025+a029);
  a022=(a022-a025);
  a029=(a021*a009);
  a022=(a022-a029);
  a029=(a013*a021);
  a029=(a007-a029);
  a030=(a022/a029);
  a031=arg[4]? arg[4][1] : 0;
  a015=(a031*a015);
  a019=(a015/a019);
  a013=(a013*a019);
  a029=(a013/a029);
  a009=(a019*a009);
  a032=(a031*a003);
  a032=(a032*a003);
  a032=(a032*a012);
  a012=arg[4]? arg[4][0] : 0;
  a033=arg[0]? arg[0][2] : 0;
  a034=(a012*a033);
  a032=(a032+a034);
  a009=(a009-a032);
  a022=(a029*a022);
  a009=(a009-a022);
  a015=(a015*a019);
  a015=(a031-a015);
  a013=(a013*a029);
  a015=(a015-a013);
  a009=(a009/a015);
  a029=(a029*a009);
  a030=(a030-a029);
  a021=(a021*a030);
  a020=(a020-a021);
  a019=(a019*a009);
  a020=(a020+a019);
  a019=(a006*a020);
  a021=1.7082860872947386e-01;
  a021=(a021*a002);
  a029=2.9587585476806851e-02;
  a029=(a029*a002);
  a015=(a029*a030);
  a013=8.8762756430420545e-02;
  a013=(a013*a002);
  a022=1.9725056984537900e-02;
  a022=(a022*a002);
  a032=(a022*a020);
  a034=5.9175170953613701e-02;
  a034=(a034*a002);
  a035=5.2600151958767730e-02;
  a035=(a035*a002);
  a036=(a035*a030);
  a036=(a008+a036);
  a037=(a007*a036);
  a038=(a035*a008);
  a038=(a010+a038);
  a039=sin(a038);
  a037=(a037*a039);
  a040=(a035*a020);
  a040=(a003+a040);
  a041=(2.*a040);
  a041=(a036-a041);
  a037=(a037*a041);
  a041=(a035*a003);
  a041=(a000+a041);
  a042=sin(a041);
  a043=cos(a038);
  a044=(a042*a043);
  a041=cos(a041);
  a045=(a041*a039);
  a044=(a044-a045);
  a045=(a007*a044);
  a037=(a037-a045);
  a045=(a042*a017);
  a037=(a037+a045);
  a045=(a016-a043);
  a045=(a018*a045);
  a045=(a045+a016);
  a046=(a037/a045);
  a043=(a043-a016);
  a043=(a007*a043);
  a047=(a043/a045);
  a048=casadi_sq(a040);
  a048=(a048*a039);
  a048=(a048+a044);
  a048=(a007*a048);
  a044=arg[2]? arg[2][2] : 0;
  a039=(a024*a044);
  a049=arg[2]? arg[2][3] : 0;
  a050=(a028*a049);
  a039=(a039+a050);
  a039=(a023*a039);
  a039=(a036+a039);
  a039=(a014*a039);
  a044=(a028*a044);
  a049=(a024*a049);
  a044=(a044-a049);
  a044=(a044+a016);
  a044=(a011*a044);
  a044=(a027-a044);
  a044=(a044+a038);
  a044=(a026*a044);
  a039=(a039+a044);
  a048=(a048-a039);
  a039=(a047*a037);
  a048=(a048-a039);
  a039=(a043*a047);
  a039=(a007-a039);
  a044=(a048/a039);
  a041=(a031*a041);
  a045=(a041/a045);
  a043=(a043*a045);
  a039=(a043/a039);
  a037=(a045*a037);
  a038=(a031*a040);
  a038=(a038*a040);
  a038=(a038*a042);
  a042=arg[0]? arg[0][5] : 0;
  a049=(a035*a042);
  a049=(a033+a049);
  a049=(a012*a049);
  a038=(a038+a049);
  a037=(a037-a038);
  a048=(a039*a048);
  a037=(a037-a048);
  a041=(a041*a045);
  a041=(a031-a041);
  a043=(a043*a039);
  a041=(a041-a043);
  a037=(a037/a041);
  a039=(a039*a037);
  a044=(a044-a039);
  a047=(a047*a044);
  a046=(a046-a047);
  a045=(a045*a037);
  a046=(a046+a045);
  a046=(a034*a046);
  a032=(a032+a046);
  a032=(a003+a032);
  a046=casadi_sq(a032);
  a045=(a022*a008);
  a036=(a034*a036);
  a045=(a045+a036);
  a045=(a010+a045);
  a036=sin(a045);
  a046=(a046*a036);
  a047=(a022*a003);
  a040=(a034*a040);
  a047=(a047+a040);
  a047=(a000+a047);
  a040=sin(a047);
  a039=cos(a045);
  a041=(a040*a039);
  a047=cos(a047);
  a043=(a047*a036);
  a041=(a041-a043);
  a046=(a046+a041);
  a046=(a007*a046);
  a043=(a022*a030);
  a044=(a034*a044);
  a043=(a043+a044);
  a043=(a008+a043);
  a044=arg[2]? arg[2][4] : 0;
  a048=(a024*a044);
  a038=arg[2]? arg[2][5] : 0;
  a049=(a028*a038);
  a048=(a048+a049);
  a048=(a023*a048);
  a048=(a043+a048);
  a048=(a014*a048);
  a044=(a028*a044);
  a038=(a024*a038);
  a044=(a044-a038);
  a044=(a044+a016);
  a044=(a011*a044);
  a044=(a027-a044);
  a044=(a044+a045);
  a044=(a026*a044);
  a048=(a048+a044);
  a046=(a046-a048);
  a048=(a039-a016);
  a048=(a007*a048);
  a039=(a016-a039);
  a039=(a018*a039);
  a039=(a039+a016);
  a044=(a048/a039);
  a045=(a007*a043);
  a045=(a045*a036);
  a036=(2.*a032);
  a036=(a043-a036);
  a045=(a045*a036);
  a041=(a007*a041);
  a045=(a045-a041);
  a041=(a040*a017);
  a045=(a045+a041);
  a041=(a044*a045);
  a046=(a046-a041);
  a041=(a048*a044);
  a041=(a007-a041);
  a036=(a046/a041);
  a047=(a031*a047);
  a038=(a047/a039);
  a048=(a048*a038);
  a041=(a048/a041);
  a049=(a038*a045);
  a050=(a031*a032);
  a050=(a050*a032);
  a050=(a050*a040);
  a040=(a022*a042);
  a035=(a035*a009);
  a035=(a042+a035);
  a035=(a034*a035);
  a040=(a040+a035);
  a040=(a033+a040);
  a040=(a012*a040);
  a050=(a050+a040);
  a049=(a049-a050);
  a046=(a041*a046);
  a049=(a049-a046);
  a047=(a047*a038);
  a047=(a031-a047);
  a048=(a048*a041);
  a047=(a047-a048);
  a049=(a049/a047);
  a041=(a041*a049);
  a036=(a036-a041);
  a041=(a013*a036);
  a015=(a015+a041);
  a015=(a008+a015);
  a041=(a007*a015);
  a047=(a029*a008);
  a048=(a013*a043);
  a047=(a047+a048);
  a047=(a010+a047);
  a048=sin(a047);
  a041=(a041*a048);
  a046=(a029*a020);
  a045=(a045/a039);
  a044=(a044*a036);
  a045=(a045-a044);
  a038=(a038*a049);
  a045=(a045+a038);
  a038=(a013*a045);
  a046=(a046+a038);
  a046=(a003+a046);
  a038=(2.*a046);
  a038=(a015-a038);
  a041=(a041*a038);
  a038=(a029*a003);
  a044=(a013*a032);
  a038=(a038+a044);
  a038=(a000+a038);
  a044=sin(a038);
  a039=cos(a047);
  a050=(a044*a039);
  a038=cos(a038);
  a040=(a038*a048);
  a050=(a050-a040);
  a040=(a007*a050);
  a041=(a041-a040);
  a040=(a044*a017);
  a041=(a041+a040);
  a040=(a016-a039);
  a040=(a018*a040);
  a040=(a040+a016);
  a035=(a041/a040);
  a039=(a039-a016);
  a039=(a007*a039);
  a051=(a039/a040);
  a052=casadi_sq(a046);
  a052=(a052*a048);
  a052=(a052+a050);
  a052=(a007*a052);
  a050=arg[2]? arg[2][6] : 0;
  a048=(a024*a050);
  a053=arg[2]? arg[2][7] : 0;
  a054=(a028*a053);
  a048=(a048+a054);
  a048=(a023*a048);
  a048=(a015+a048);
  a048=(a014*a048);
  a050=(a028*a050);
  a053=(a024*a053);
  a050=(a050-a053);
  a050=(a050+a016);
  a050=(a011*a050);
  a050=(a027-a050);
  a050=(a050+a047);
  a050=(a026*a050);
  a048=(a048+a050);
  a052=(a052-a048);
  a048=(a051*a041);
  a052=(a052-a048);
  a048=(a039*a051);
  a048=(a007-a048);
  a050=(a052/a048);
  a038=(a031*a038);
  a040=(a038/a040);
  a039=(a039*a040);
  a048=(a039/a048);
  a041=(a040*a041);
  a047=(a031*a046);
  a047=(a047*a046);
  a047=(a047*a044);
  a044=(a029*a042);
  a022=(a022*a009);
  a034=(a034*a037);
  a022=(a022+a034);
  a022=(a042+a022);
  a034=(a013*a022);
  a044=(a044+a034);
  a044=(a033+a044);
  a044=(a012*a044);
  a047=(a047+a044);
  a041=(a041-a047);
  a052=(a048*a052);
  a041=(a041-a052);
  a038=(a038*a040);
  a038=(a031-a038);
  a039=(a039*a048);
  a038=(a038-a039);
  a041=(a041/a038);
  a048=(a048*a041);
  a050=(a050-a048);
  a051=(a051*a050);
  a035=(a035-a051);
  a040=(a040*a041);
  a035=(a035+a040);
  a040=(a021*a035);
  a019=(a019+a040);
  a040=1.2546768756682242e-01;
  a040=(a040*a002);
  a051=2.4136513415926669e-01;
  a051=(a051*a002);
  a048=(a051*a030);
  a038=-8.8454947932828609e-01;
  a038=(a038*a002);
  a036=(a038*a036);
  a048=(a048+a036);
  a036=9.2483400326179199e-01;
  a036=(a036*a002);
  a039=(a036*a050);
  a048=(a048+a039);
  a048=(a008+a048);
  a039=(a007*a048);
  a052=(a051*a008);
  a043=(a038*a043);
  a052=(a052+a043);
  a043=(a036*a015);
  a052=(a052+a043);
  a052=(a010+a052);
  a043=sin(a052);
  a039=(a039*a043);
  a047=(a051*a020);
  a045=(a038*a045);
  a047=(a047+a045);
  a045=(a036*a035);
  a047=(a047+a045);
  a047=(a003+a047);
  a045=(2.*a047);
  a045=(a048-a045);
  a039=(a039*a045);
  a045=(a051*a003);
  a032=(a038*a032);
  a045=(a045+a032);
  a032=(a036*a046);
  a045=(a045+a032);
  a045=(a000+a045);
  a032=sin(a045);
  a044=cos(a052);
  a034=(a032*a044);
  a045=cos(a045);
  a037=(a045*a043);
  a034=(a034-a037);
  a037=(a007*a034);
  a039=(a039-a037);
  a037=(a032*a017);
  a039=(a039+a037);
  a037=(a016-a044);
  a037=(a018*a037);
  a037=(a037+a016);
  a053=(a039/a037);
  a044=(a044-a016);
  a044=(a007*a044);
  a054=(a044/a037);
  a055=casadi_sq(a047);
  a055=(a055*a043);
  a055=(a055+a034);
  a055=(a007*a055);
  a034=arg[2]? arg[2][8] : 0;
  a043=(a024*a034);
  a056=arg[2]? arg[2][9] : 0;
  a057=(a028*a056);
  a043=(a043+a057);
  a043=(a023*a043);
  a043=(a048+a043);
  a043=(a014*a043);
  a034=(a028*a034);
  a056=(a024*a056);
  a034=(a034-a056);
  a034=(a034+a016);
  a034=(a011*a034);
  a034=(a027-a034);
  a034=(a034+a052);
  a034=(a026*a034);
  a043=(a043+a034);
  a055=(a055-a043);
  a043=(a054*a039);
  a055=(a055-a043);
  a043=(a044*a054);
  a043=(a007-a043);
  a034=(a055/a043);
  a045=(a031*a045);
  a037=(a045/a037);
  a044=(a044*a037);
  a043=(a044/a043);
  a039=(a037*a039);
  a052=(a031*a047);
  a052=(a052*a047);
  a052=(a052*a032);
  a032=(a051*a042);
  a022=(a038*a022);
  a032=(a032+a022);
  a029=(a029*a009);
  a013=(a013*a049);
  a029=(a029+a013);
  a029=(a042+a029);
  a013=(a036*a029);
  a032=(a032+a013);
  a032=(a033+a032);
  a032=(a012*a032);
  a052=(a052+a032);
  a039=(a039-a052);
  a055=(a043*a055);
  a039=(a039-a055);
  a045=(a045*a037);
  a045=(a031-a045);
  a044=(a044*a043);
  a045=(a045-a044);
  a039=(a039/a045);
  a043=(a043*a039);
  a034=(a034-a043);
  a054=(a054*a034);
  a053=(a053-a054);
  a037=(a037*a039);
  a053=(a053+a037);
  a037=(a040*a053);
  a019=(a019+a037);
  a019=(a003+a019);
  a037=(a005*a019);
  a004=(a004+a037);
  a037=1.8915178993145003e+00;
  a037=(a037*a002);
  a054=3.7109375000000000e-02;
  a054=(a054*a002);
  a043=(a054*a020);
  a045=1.7025221101954405e-01;
  a045=(a045*a002);
  a044=(a045*a035);
  a043=(a043+a044);
  a044=6.0216538980455959e-02;
  a044=(a044*a002);
  a055=(a044*a053);
  a043=(a043+a055);
  a055=-1.7578125000000000e-02;
  a055=(a055*a002);
  a052=(a006*a030);
  a032=(a021*a050);
  a052=(a052+a032);
  a032=(a040*a034);
  a052=(a052+a032);
  a052=(a008+a052);
  a032=(a007*a052);
  a013=(a006*a008);
  a022=(a021*a015);
  a013=(a013+a022);
  a022=(a040*a048);
  a013=(a013+a022);
  a013=(a010+a013);
  a022=sin(a013);
  a032=(a032*a022);
  a056=(2.*a019);
  a056=(a052-a056);
  a032=(a032*a056);
  a056=(a006*a003);
  a057=(a021*a046);
  a056=(a056+a057);
  a057=(a040*a047);
  a056=(a056+a057);
  a056=(a000+a056);
  a057=sin(a056);
  a058=cos(a013);
  a059=(a057*a058);
  a056=cos(a056);
  a060=(a056*a022);
  a059=(a059-a060);
  a060=(a007*a059);
  a032=(a032-a060);
  a060=(a057*a017);
  a032=(a032+a060);
  a060=(a016-a058);
  a060=(a018*a060);
  a060=(a060+a016);
  a061=(a032/a060);
  a058=(a058-a016);
  a058=(a007*a058);
  a062=(a058/a060);
  a063=casadi_sq(a019);
  a063=(a063*a022);
  a063=(a063+a059);
  a063=(a007*a063);
  a059=arg[2]? arg[2][10] : 0;
  a022=(a024*a059);
  a064=arg[2]? arg[2][11] : 0;
  a065=(a028*a064);
  a022=(a022+a065);
  a022=(a023*a022);
  a022=(a052+a022);
  a022=(a014*a022);
  a059=(a028*a059);
  a064=(a024*a064);
  a059=(a059-a064);
  a059=(a059+a016);
  a059=(a011*a059);
  a059=(a027-a059);
  a059=(a059+a013);
  a059=(a026*a059);
  a022=(a022+a059);
  a063=(a063-a022);
  a059=(a062*a032);
  a063=(a063-a059);
  a059=(a058*a062);
  a059=(a007-a059);
  a013=(a063/a059);
  a056=(a031*a056);
  a060=(a056/a060);
  a058=(a058*a060);
  a059=(a058/a059);
  a032=(a060*a032);
  a064=(a031*a019);
  a064=(a064*a019);
  a064=(a064*a057);
  a057=(a006*a042);
  a065=(a021*a029);
  a057=(a057+a065);
  a051=(a051*a009);
  a038=(a038*a049);
  a051=(a051+a038);
  a036=(a036*a041);
  a051=(a051+a036);
  a051=(a042+a051);
  a036=(a040*a051);
  a057=(a057+a036);
  a057=(a033+a057);
  a057=(a012*a057);
  a064=(a064+a057);
  a032=(a032-a064);
  a063=(a059*a063);
  a032=(a032-a063);
  a056=(a056*a060);
  a056=(a031-a056);
  a058=(a058*a059);
  a056=(a056-a058);
  a032=(a032/a056);
  a059=(a059*a032);
  a013=(a013-a059);
  a062=(a062*a013);
  a061=(a061-a062);
  a060=(a060*a032);
  a061=(a061+a060);
  a060=(a055*a061);
  a043=(a043+a060);
  a043=(a003+a043);
  a060=(a037*a043);
  a004=(a004+a060);
  a060=-5.8012039600105849e+00;
  a060=(a060*a002);
  a062=3.7092000118504789e-02;
  a062=(a062*a002);
  a059=(a062*a020);
  a056=1.7038392571223998e-01;
  a056=(a056*a002);
  a058=(a056*a035);
  a059=(a059+a058);
  a058=1.0726203044637328e-01;
  a058=(a058*a002);
  a063=(a058*a053);
  a059=(a059+a063);
  a063=-1.5319437748624402e-02;
  a063=(a063*a002);
  a064=(a063*a061);
  a059=(a059+a064);
  a064=8.2737891638140233e-03;
  a064=(a064*a002);
  a057=(a054*a030);
  a036=(a045*a050);
  a057=(a057+a036);
  a036=(a044*a034);
  a057=(a057+a036);
  a036=(a055*a013);
  a057=(a057+a036);
  a057=(a008+a057);
  a036=(a007*a057);
  a038=(a054*a008);
  a049=(a045*a015);
  a038=(a038+a049);
  a049=(a044*a048);
  a038=(a038+a049);
  a049=(a055*a052);
  a038=(a038+a049);
  a038=(a010+a038);
  a049=sin(a038);
  a036=(a036*a049);
  a065=(2.*a043);
  a065=(a057-a065);
  a036=(a036*a065);
  a065=(a054*a003);
  a066=(a045*a046);
  a065=(a065+a066);
  a066=(a044*a047);
  a065=(a065+a066);
  a066=(a055*a019);
  a065=(a065+a066);
  a065=(a000+a065);
  a066=sin(a065);
  a067=cos(a038);
  a068=(a066*a067);
  a065=cos(a065);
  a069=(a065*a049);
  a068=(a068-a069);
  a069=(a007*a068);
  a036=(a036-a069);
  a069=(a066*a017);
  a036=(a036+a069);
  a069=(a016-a067);
  a069=(a018*a069);
  a069=(a069+a016);
  a070=(a036/a069);
  a067=(a067-a016);
  a067=(a007*a067);
  a071=(a067/a069);
  a072=casadi_sq(a043);
  a072=(a072*a049);
  a072=(a072+a068);
  a072=(a007*a072);
  a068=arg[2]? arg[2][12] : 0;
  a049=(a024*a068);
  a073=arg[2]? arg[2][13] : 0;
  a074=(a028*a073);
  a049=(a049+a074);
  a049=(a023*a049);
  a049=(a057+a049);
  a049=(a014*a049);
  a068=(a028*a068);
  a073=(a024*a073);
  a068=(a068-a073);
  a068=(a068+a016);
  a068=(a011*a068);
  a068=(a027-a068);
  a068=(a068+a038);
  a068=(a026*a068);
  a049=(a049+a068);
  a072=(a072-a049);
  a068=(a071*a036);
  a072=(a072-a068);
  a068=(a067*a071);
  a068=(a007-a068);
  a038=(a072/a068);
  a065=(a031*a065);
  a069=(a065/a069);
  a067=(a067*a069);
  a068=(a067/a068);
  a036=(a069*a036);
  a073=(a031*a043);
  a073=(a073*a043);
  a073=(a073*a066);
  a066=(a054*a042);
  a074=(a045*a029);
  a066=(a066+a074);
  a074=(a044*a051);
  a066=(a066+a074);
  a006=(a006*a009);
  a021=(a021*a041);
  a006=(a006+a021);
  a040=(a040*a039);
  a006=(a006+a040);
  a006=(a042+a006);
  a040=(a055*a006);
  a066=(a066+a040);
  a066=(a033+a066);
  a066=(a012*a066);
  a073=(a073+a066);
  a036=(a036-a073);
  a072=(a068*a072);
  a036=(a036-a072);
  a065=(a065*a069);
  a065=(a031-a065);
  a067=(a067*a068);
  a065=(a065-a067);
  a036=(a036/a065);
  a068=(a068*a036);
  a038=(a038-a068);
  a071=(a071*a038);
  a070=(a070-a071);
  a069=(a069*a036);
  a070=(a070+a069);
  a069=(a064*a070);
  a059=(a059+a069);
  a059=(a003+a059);
  a069=(a060*a059);
  a004=(a004+a069);
  a069=3.1116436695781990e-01;
  a069=(a069*a002);
  a071=6.2411095871607569e-01;
  a071=(a071*a002);
  a068=(a071*a020);
  a065=-3.3608926294469414e+00;
  a065=(a065*a002);
  a067=(a065*a035);
  a068=(a068+a067);
  a067=-8.6821934684172597e-01;
  a067=(a067*a002);
  a072=(a067*a053);
  a068=(a068+a072);
  a072=2.7592099699446710e+01;
  a072=(a072*a002);
  a073=(a072*a061);
  a068=(a068+a073);
  a073=2.0154067550477894e+01;
  a073=(a073*a002);
  a066=(a073*a070);
  a068=(a068+a066);
  a066=-4.3489884181069961e+01;
  a066=(a066*a002);
  a040=(a062*a030);
  a021=(a056*a050);
  a040=(a040+a021);
  a021=(a058*a034);
  a040=(a040+a021);
  a021=(a063*a013);
  a040=(a040+a021);
  a021=(a064*a038);
  a040=(a040+a021);
  a040=(a008+a040);
  a021=(a007*a040);
  a074=(a062*a008);
  a075=(a056*a015);
  a074=(a074+a075);
  a075=(a058*a048);
  a074=(a074+a075);
  a075=(a063*a052);
  a074=(a074+a075);
  a075=(a064*a057);
  a074=(a074+a075);
  a074=(a010+a074);
  a075=sin(a074);
  a021=(a021*a075);
  a076=(2.*a059);
  a076=(a040-a076);
  a021=(a021*a076);
  a076=(a062*a003);
  a077=(a056*a046);
  a076=(a076+a077);
  a077=(a058*a047);
  a076=(a076+a077);
  a077=(a063*a019);
  a076=(a076+a077);
  a077=(a064*a043);
  a076=(a076+a077);
  a076=(a000+a076);
  a077=sin(a076);
  a078=cos(a074);
  a079=(a077*a078);
  a076=cos(a076);
  a080=(a076*a075);
  a079=(a079-a080);
  a080=(a007*a079);
  a021=(a021-a080);
  a080=(a077*a017);
  a021=(a021+a080);
  a080=(a016-a078);
  a080=(a018*a080);
  a080=(a080+a016);
  a081=(a021/a080);
  a078=(a078-a016);
  a078=(a007*a078);
  a082=(a078/a080);
  a083=casadi_sq(a059);
  a083=(a083*a075);
  a083=(a083+a079);
  a083=(a007*a083);
  a079=arg[2]? arg[2][14] : 0;
  a075=(a024*a079);
  a084=arg[2]? arg[2][15] : 0;
  a085=(a028*a084);
  a075=(a075+a085);
  a075=(a023*a075);
  a075=(a040+a075);
  a075=(a014*a075);
  a079=(a028*a079);
  a084=(a024*a084);
  a079=(a079-a084);
  a079=(a079+a016);
  a079=(a011*a079);
  a079=(a027-a079);
  a079=(a079+a074);
  a079=(a026*a079);
  a075=(a075+a079);
  a083=(a083-a075);
  a079=(a082*a021);
  a083=(a083-a079);
  a079=(a078*a082);
  a079=(a007-a079);
  a074=(a083/a079);
  a076=(a031*a076);
  a080=(a076/a080);
  a078=(a078*a080);
  a079=(a078/a079);
  a021=(a080*a021);
  a084=(a031*a059);
  a084=(a084*a059);
  a084=(a084*a077);
  a077=(a062*a042);
  a085=(a056*a029);
  a077=(a077+a085);
  a085=(a058*a051);
  a077=(a077+a085);
  a085=(a063*a006);
  a077=(a077+a085);
  a054=(a054*a009);
  a045=(a045*a041);
  a054=(a054+a045);
  a044=(a044*a039);
  a054=(a054+a044);
  a055=(a055*a032);
  a054=(a054+a055);
  a054=(a042+a054);
  a055=(a064*a054);
  a077=(a077+a055);
  a077=(a033+a077);
  a077=(a012*a077);
  a084=(a084+a077);
  a021=(a021-a084);
  a083=(a079*a083);
  a021=(a021-a083);
  a076=(a076*a080);
  a076=(a031-a076);
  a078=(a078*a079);
  a076=(a076-a078);
  a021=(a021/a076);
  a079=(a079*a021);
  a074=(a074-a079);
  a082=(a082*a074);
  a081=(a081-a082);
  a080=(a080*a021);
  a081=(a081+a080);
  a080=(a066*a081);
  a068=(a068+a080);
  a068=(a003+a068);
  a080=(a069*a068);
  a004=(a004+a080);
  a080=-1.5216094966251609e-01;
  a080=(a080*a002);
  a082=4.7766253643826434e-01;
  a082=(a082*a002);
  a079=(a082*a020);
  a076=-2.4881146199716677e+00;
  a076=(a076*a002);
  a078=(a076*a035);
  a079=(a079+a078);
  a078=-5.9029082683684297e-01;
  a078=(a078*a002);
  a083=(a078*a053);
  a079=(a079+a083);
  a083=2.1230051448181193e+01;
  a083=(a083*a002);
  a084=(a083*a061);
  a079=(a079+a084);
  a084=1.5279233632882423e+01;
  a084=(a084*a002);
  a077=(a084*a070);
  a079=(a079+a077);
  a077=-3.3288210968984863e+01;
  a077=(a077*a002);
  a055=(a077*a081);
  a079=(a079+a055);
  a055=-2.0331201708508627e-02;
  a055=(a055*a002);
  a044=(a071*a030);
  a045=(a065*a050);
  a044=(a044+a045);
  a045=(a067*a034);
  a044=(a044+a045);
  a045=(a072*a013);
  a044=(a044+a045);
  a045=(a073*a038);
  a044=(a044+a045);
  a045=(a066*a074);
  a044=(a044+a045);
  a044=(a008+a044);
  a045=(a007*a044);
  a085=(a071*a008);
  a086=(a065*a015);
  a085=(a085+a086);
  a086=(a067*a048);
  a085=(a085+a086);
  a086=(a072*a052);
  a085=(a085+a086);
  a086=(a073*a057);
  a085=(a085+a086);
  a086=(a066*a040);
  a085=(a085+a086);
  a085=(a010+a085);
  a086=sin(a085);
  a045=(a045*a086);
  a087=(2.*a068);
  a087=(a044-a087);
  a045=(a045*a087);
  a087=(a071*a003);
  a088=(a065*a046);
  a087=(a087+a088);
  a088=(a067*a047);
  a087=(a087+a088);
  a088=(a072*a019);
  a087=(a087+a088);
  a088=(a073*a043);
  a087=(a087+a088);
  a088=(a066*a059);
  a087=(a087+a088);
  a087=(a000+a087);
  a088=sin(a087);
  a089=cos(a085);
  a090=(a088*a089);
  a087=cos(a087);
  a091=(a087*a086);
  a090=(a090-a091);
  a091=(a007*a090);
  a045=(a045-a091);
  a091=(a088*a017);
  a045=(a045+a091);
  a091=(a016-a089);
  a091=(a018*a091);
  a091=(a091+a016);
  a092=(a045/a091);
  a089=(a089-a016);
  a089=(a007*a089);
  a093=(a089/a091);
  a094=casadi_sq(a068);
  a094=(a094*a086);
  a094=(a094+a090);
  a094=(a007*a094);
  a090=arg[2]? arg[2][16] : 0;
  a086=(a024*a090);
  a095=arg[2]? arg[2][17] : 0;
  a096=(a028*a095);
  a086=(a086+a096);
  a086=(a023*a086);
  a086=(a044+a086);
  a086=(a014*a086);
  a090=(a028*a090);
  a095=(a024*a095);
  a090=(a090-a095);
  a090=(a090+a016);
  a090=(a011*a090);
  a090=(a027-a090);
  a090=(a090+a085);
  a090=(a026*a090);
  a086=(a086+a090);
  a094=(a094-a086);
  a090=(a093*a045);
  a094=(a094-a090);
  a090=(a089*a093);
  a090=(a007-a090);
  a085=(a094/a090);
  a087=(a031*a087);
  a091=(a087/a091);
  a089=(a089*a091);
  a090=(a089/a090);
  a045=(a091*a045);
  a095=(a031*a068);
  a095=(a095*a068);
  a095=(a095*a088);
  a088=(a071*a042);
  a096=(a065*a029);
  a088=(a088+a096);
  a096=(a067*a051);
  a088=(a088+a096);
  a096=(a072*a006);
  a088=(a088+a096);
  a096=(a073*a054);
  a088=(a088+a096);
  a062=(a062*a009);
  a056=(a056*a041);
  a062=(a062+a056);
  a058=(a058*a039);
  a062=(a062+a058);
  a063=(a063*a032);
  a062=(a062+a063);
  a064=(a064*a036);
  a062=(a062+a064);
  a062=(a042+a062);
  a064=(a066*a062);
  a088=(a088+a064);
  a088=(a033+a088);
  a088=(a012*a088);
  a095=(a095+a088);
  a045=(a045-a095);
  a094=(a090*a094);
  a045=(a045-a094);
  a087=(a087*a091);
  a087=(a031-a087);
  a089=(a089*a090);
  a087=(a087-a089);
  a045=(a045/a087);
  a090=(a090*a045);
  a085=(a085-a090);
  a093=(a093*a085);
  a092=(a092-a093);
  a091=(a091*a045);
  a092=(a092+a091);
  a091=(a055*a092);
  a079=(a079+a091);
  a079=(a003+a079);
  a091=(a080*a079);
  a004=(a004+a091);
  a091=2.0136540080403034e-01;
  a091=(a091*a002);
  a093=-9.3714243008598730e-01;
  a093=(a093*a002);
  a090=(a093*a020);
  a087=5.1863724288440638e+00;
  a087=(a087*a002);
  a089=(a087*a035);
  a090=(a090+a089);
  a089=1.0914373489967295e+00;
  a089=(a089*a002);
  a094=(a089*a053);
  a090=(a090+a094);
  a094=-8.1497870107469268e+00;
  a094=(a094*a002);
  a095=(a094*a061);
  a090=(a090+a095);
  a095=-1.8520065659996959e+01;
  a095=(a095*a002);
  a088=(a095*a070);
  a090=(a090+a088);
  a088=2.2739487099350505e+01;
  a088=(a088*a002);
  a064=(a088*a081);
  a090=(a090+a064);
  a064=2.4936055526796523e+00;
  a064=(a064*a002);
  a063=(a064*a092);
  a090=(a090+a063);
  a063=-3.0467644718982196e+00;
  a063=(a063*a002);
  a058=(a082*a030);
  a056=(a076*a050);
  a058=(a058+a056);
  a056=(a078*a034);
  a058=(a058+a056);
  a056=(a083*a013);
  a058=(a058+a056);
  a056=(a084*a038);
  a058=(a058+a056);
  a056=(a077*a074);
  a058=(a058+a056);
  a056=(a055*a085);
  a058=(a058+a056);
  a058=(a008+a058);
  a056=(a007*a058);
  a096=(a082*a008);
  a097=(a076*a015);
  a096=(a096+a097);
  a097=(a078*a048);
  a096=(a096+a097);
  a097=(a083*a052);
  a096=(a096+a097);
  a097=(a084*a057);
  a096=(a096+a097);
  a097=(a077*a040);
  a096=(a096+a097);
  a097=(a055*a044);
  a096=(a096+a097);
  a096=(a010+a096);
  a097=sin(a096);
  a056=(a056*a097);
  a098=(2.*a079);
  a098=(a058-a098);
  a056=(a056*a098);
  a098=(a082*a003);
  a099=(a076*a046);
  a098=(a098+a099);
  a099=(a078*a047);
  a098=(a098+a099);
  a099=(a083*a019);
  a098=(a098+a099);
  a099=(a084*a043);
  a098=(a098+a099);
  a099=(a077*a059);
  a098=(a098+a099);
  a099=(a055*a068);
  a098=(a098+a099);
  a098=(a000+a098);
  a099=sin(a098);
  a100=cos(a096);
  a101=(a099*a100);
  a098=cos(a098);
  a102=(a098*a097);
  a101=(a101-a102);
  a102=(a007*a101);
  a056=(a056-a102);
  a102=(a099*a017);
  a056=(a056+a102);
  a102=(a016-a100);
  a102=(a018*a102);
  a102=(a102+a016);
  a103=(a056/a102);
  a100=(a100-a016);
  a100=(a007*a100);
  a104=(a100/a102);
  a105=casadi_sq(a079);
  a105=(a105*a097);
  a105=(a105+a101);
  a105=(a007*a105);
  a101=arg[2]? arg[2][18] : 0;
  a097=(a024*a101);
  a106=arg[2]? arg[2][19] : 0;
  a107=(a028*a106);
  a097=(a097+a107);
  a097=(a023*a097);
  a097=(a058+a097);
  a097=(a014*a097);
  a101=(a028*a101);
  a106=(a024*a106);
  a101=(a101-a106);
  a101=(a101+a016);
  a101=(a011*a101);
  a101=(a027-a101);
  a101=(a101+a096);
  a101=(a026*a101);
  a097=(a097+a101);
  a105=(a105-a097);
  a101=(a104*a056);
  a105=(a105-a101);
  a101=(a100*a104);
  a101=(a007-a101);
  a096=(a105/a101);
  a098=(a031*a098);
  a102=(a098/a102);
  a100=(a100*a102);
  a101=(a100/a101);
  a056=(a102*a056);
  a106=(a031*a079);
  a106=(a106*a079);
  a106=(a106*a099);
  a099=(a082*a042);
  a107=(a076*a029);
  a099=(a099+a107);
  a107=(a078*a051);
  a099=(a099+a107);
  a107=(a083*a006);
  a099=(a099+a107);
  a107=(a084*a054);
  a099=(a099+a107);
  a107=(a077*a062);
  a099=(a099+a107);
  a071=(a071*a009);
  a065=(a065*a041);
  a071=(a071+a065);
  a067=(a067*a039);
  a071=(a071+a067);
  a072=(a072*a032);
  a071=(a071+a072);
  a073=(a073*a036);
  a071=(a071+a073);
  a066=(a066*a021);
  a071=(a071+a066);
  a071=(a042+a071);
  a066=(a055*a071);
  a099=(a099+a066);
  a099=(a033+a099);
  a099=(a012*a099);
  a106=(a106+a099);
  a056=(a056-a106);
  a105=(a101*a105);
  a056=(a056-a105);
  a098=(a098*a102);
  a098=(a031-a098);
  a100=(a100*a101);
  a098=(a098-a100);
  a056=(a056/a098);
  a101=(a101*a056);
  a096=(a096-a101);
  a104=(a104*a096);
  a103=(a103-a104);
  a102=(a102*a056);
  a103=(a103+a102);
  a102=(a063*a103);
  a090=(a090+a102);
  a090=(a003+a090);
  a102=(a091*a090);
  a004=(a004+a102);
  a102=4.4710615727772587e-02;
  a102=(a102*a002);
  a104=2.2733101475165380e+00;
  a104=(a104*a002);
  a101=(a104*a020);
  a098=-1.0534495466737249e+01;
  a098=(a098*a002);
  a035=(a098*a035);
  a101=(a101+a035);
  a035=-2.0008720582248625e+00;
  a035=(a035*a002);
  a053=(a035*a053);
  a101=(a101+a053);
  a053=-1.7958931863118799e+01;
  a053=(a053*a002);
  a100=(a053*a061);
  a101=(a101+a100);
  a100=2.7948884529419960e+01;
  a100=(a100*a002);
  a105=(a100*a070);
  a101=(a101+a105);
  a105=-2.8589982771350235e+00;
  a105=(a105*a002);
  a106=(a105*a081);
  a101=(a101+a106);
  a106=-8.8728569335306293e+00;
  a106=(a106*a002);
  a099=(a106*a092);
  a101=(a101+a099);
  a099=1.2360567175794303e+01;
  a099=(a099*a002);
  a066=(a099*a103);
  a101=(a101+a066);
  a066=6.4339274601576357e-01;
  a066=(a066*a002);
  a002=(a093*a030);
  a073=(a087*a050);
  a002=(a002+a073);
  a073=(a089*a034);
  a002=(a002+a073);
  a073=(a094*a013);
  a002=(a002+a073);
  a073=(a095*a038);
  a002=(a002+a073);
  a073=(a088*a074);
  a002=(a002+a073);
  a073=(a064*a085);
  a002=(a002+a073);
  a073=(a063*a096);
  a002=(a002+a073);
  a002=(a008+a002);
  a073=(a007*a002);
  a072=(a093*a008);
  a067=(a087*a015);
  a072=(a072+a067);
  a067=(a089*a048);
  a072=(a072+a067);
  a067=(a094*a052);
  a072=(a072+a067);
  a067=(a095*a057);
  a072=(a072+a067);
  a067=(a088*a040);
  a072=(a072+a067);
  a067=(a064*a044);
  a072=(a072+a067);
  a067=(a063*a058);
  a072=(a072+a067);
  a072=(a010+a072);
  a067=sin(a072);
  a073=(a073*a067);
  a065=(2.*a090);
  a065=(a002-a065);
  a073=(a073*a065);
  a065=(a093*a003);
  a107=(a087*a046);
  a065=(a065+a107);
  a107=(a089*a047);
  a065=(a065+a107);
  a107=(a094*a019);
  a065=(a065+a107);
  a107=(a095*a043);
  a065=(a065+a107);
  a107=(a088*a059);
  a065=(a065+a107);
  a107=(a064*a068);
  a065=(a065+a107);
  a107=(a063*a079);
  a065=(a065+a107);
  a065=(a000+a065);
  a107=sin(a065);
  a108=cos(a072);
  a109=(a107*a108);
  a065=cos(a065);
  a110=(a065*a067);
  a109=(a109-a110);
  a110=(a007*a109);
  a073=(a073-a110);
  a110=(a107*a017);
  a073=(a073+a110);
  a110=(a016-a108);
  a110=(a018*a110);
  a110=(a110+a016);
  a111=(a073/a110);
  a108=(a108-a016);
  a108=(a007*a108);
  a112=(a108/a110);
  a113=casadi_sq(a090);
  a113=(a113*a067);
  a113=(a113+a109);
  a113=(a007*a113);
  a109=arg[2]? arg[2][20] : 0;
  a067=(a024*a109);
  a114=arg[2]? arg[2][21] : 0;
  a115=(a028*a114);
  a067=(a067+a115);
  a067=(a023*a067);
  a067=(a002+a067);
  a067=(a014*a067);
  a109=(a028*a109);
  a114=(a024*a114);
  a109=(a109-a114);
  a109=(a109+a016);
  a109=(a011*a109);
  a109=(a027-a109);
  a109=(a109+a072);
  a109=(a026*a109);
  a067=(a067+a109);
  a113=(a113-a067);
  a109=(a112*a073);
  a113=(a113-a109);
  a109=(a108*a112);
  a109=(a007-a109);
  a072=(a113/a109);
  a065=(a031*a065);
  a110=(a065/a110);
  a108=(a108*a110);
  a109=(a108/a109);
  a073=(a110*a073);
  a114=(a031*a090);
  a114=(a114*a090);
  a114=(a114*a107);
  a107=(a093*a042);
  a115=(a087*a029);
  a107=(a107+a115);
  a115=(a089*a051);
  a107=(a107+a115);
  a115=(a094*a006);
  a107=(a107+a115);
  a115=(a095*a054);
  a107=(a107+a115);
  a115=(a088*a062);
  a107=(a107+a115);
  a115=(a064*a071);
  a107=(a107+a115);
  a082=(a082*a009);
  a076=(a076*a041);
  a082=(a082+a076);
  a078=(a078*a039);
  a082=(a082+a078);
  a083=(a083*a032);
  a082=(a082+a083);
  a084=(a084*a036);
  a082=(a082+a084);
  a077=(a077*a021);
  a082=(a082+a077);
  a055=(a055*a045);
  a082=(a082+a055);
  a082=(a042+a082);
  a055=(a063*a082);
  a107=(a107+a055);
  a107=(a033+a107);
  a107=(a012*a107);
  a114=(a114+a107);
  a073=(a073-a114);
  a113=(a109*a113);
  a073=(a073-a113);
  a065=(a065*a110);
  a065=(a031-a065);
  a108=(a108*a109);
  a065=(a065-a108);
  a073=(a073/a065);
  a109=(a109*a073);
  a072=(a072-a109);
  a112=(a112*a072);
  a111=(a111-a112);
  a110=(a110*a073);
  a111=(a111+a110);
  a110=(a066*a111);
  a101=(a101+a110);
  a101=(a003+a101);
  a110=(a102*a101);
  a004=(a004+a110);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a110=(a005*a052);
  a004=(a004+a110);
  a110=(a037*a057);
  a004=(a004+a110);
  a110=(a060*a040);
  a004=(a004+a110);
  a110=(a069*a044);
  a004=(a004+a110);
  a110=(a080*a058);
  a004=(a004+a110);
  a110=(a091*a002);
  a004=(a004+a110);
  a110=(a104*a030);
  a050=(a098*a050);
  a110=(a110+a050);
  a034=(a035*a034);
  a110=(a110+a034);
  a034=(a053*a013);
  a110=(a110+a034);
  a034=(a100*a038);
  a110=(a110+a034);
  a034=(a105*a074);
  a110=(a110+a034);
  a034=(a106*a085);
  a110=(a110+a034);
  a034=(a099*a096);
  a110=(a110+a034);
  a034=(a066*a072);
  a110=(a110+a034);
  a110=(a008+a110);
  a034=(a102*a110);
  a004=(a004+a034);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a042);
  a034=(a005*a006);
  a004=(a004+a034);
  a034=(a037*a054);
  a004=(a004+a034);
  a034=(a060*a062);
  a004=(a004+a034);
  a034=(a069*a071);
  a004=(a004+a034);
  a034=(a080*a082);
  a004=(a004+a034);
  a093=(a093*a009);
  a087=(a087*a041);
  a093=(a093+a087);
  a089=(a089*a039);
  a093=(a093+a089);
  a094=(a094*a032);
  a093=(a093+a094);
  a095=(a095*a036);
  a093=(a093+a095);
  a088=(a088*a021);
  a093=(a093+a088);
  a064=(a064*a045);
  a093=(a093+a064);
  a063=(a063*a056);
  a093=(a093+a063);
  a093=(a042+a093);
  a063=(a091*a093);
  a004=(a004+a063);
  a063=(a104*a009);
  a041=(a098*a041);
  a063=(a063+a041);
  a039=(a035*a039);
  a063=(a063+a039);
  a039=(a053*a032);
  a063=(a063+a039);
  a039=(a100*a036);
  a063=(a063+a039);
  a039=(a105*a021);
  a063=(a063+a039);
  a039=(a106*a045);
  a063=(a063+a039);
  a039=(a099*a056);
  a063=(a063+a039);
  a039=(a066*a073);
  a063=(a063+a039);
  a063=(a042+a063);
  a063=(a102*a063);
  a004=(a004+a063);
  a004=(a033+a004);
  if (res[0]!=0) res[0][2]=a004;
  a020=(a001*a020);
  a061=(a005*a061);
  a020=(a020+a061);
  a070=(a037*a070);
  a020=(a020+a070);
  a081=(a060*a081);
  a020=(a020+a081);
  a092=(a069*a092);
  a020=(a020+a092);
  a103=(a080*a103);
  a020=(a020+a103);
  a111=(a091*a111);
  a020=(a020+a111);
  a111=(a007*a110);
  a103=(a104*a008);
  a015=(a098*a015);
  a103=(a103+a015);
  a048=(a035*a048);
  a103=(a103+a048);
  a048=(a053*a052);
  a103=(a103+a048);
  a048=(a100*a057);
  a103=(a103+a048);
  a048=(a105*a040);
  a103=(a103+a048);
  a048=(a106*a044);
  a103=(a103+a048);
  a048=(a099*a058);
  a103=(a103+a048);
  a048=(a066*a002);
  a103=(a103+a048);
  a010=(a010+a103);
  a103=sin(a010);
  a111=(a111*a103);
  a048=(2.*a101);
  a048=(a110-a048);
  a111=(a111*a048);
  a048=(a104*a003);
  a046=(a098*a046);
  a048=(a048+a046);
  a047=(a035*a047);
  a048=(a048+a047);
  a019=(a053*a019);
  a048=(a048+a019);
  a043=(a100*a043);
  a048=(a048+a043);
  a059=(a105*a059);
  a048=(a048+a059);
  a068=(a106*a068);
  a048=(a048+a068);
  a079=(a099*a079);
  a048=(a048+a079);
  a090=(a066*a090);
  a048=(a048+a090);
  a000=(a000+a048);
  a048=sin(a000);
  a090=cos(a010);
  a079=(a048*a090);
  a000=cos(a000);
  a068=(a000*a103);
  a079=(a079-a068);
  a068=(a007*a079);
  a111=(a111-a068);
  a017=(a048*a017);
  a111=(a111+a017);
  a017=(a016-a090);
  a018=(a018*a017);
  a018=(a018+a016);
  a017=(a111/a018);
  a090=(a090-a016);
  a090=(a007*a090);
  a068=(a090/a018);
  a059=casadi_sq(a101);
  a059=(a059*a103);
  a059=(a059+a079);
  a059=(a007*a059);
  a079=arg[2]? arg[2][22] : 0;
  a103=(a024*a079);
  a043=arg[2]? arg[2][23] : 0;
  a019=(a028*a043);
  a103=(a103+a019);
  a023=(a023*a103);
  a023=(a110+a023);
  a014=(a014*a023);
  a028=(a028*a079);
  a024=(a024*a043);
  a028=(a028-a024);
  a028=(a028+a016);
  a011=(a011*a028);
  a027=(a027-a011);
  a027=(a027+a010);
  a026=(a026*a027);
  a014=(a014+a026);
  a059=(a059-a014);
  a026=(a068*a111);
  a059=(a059-a026);
  a026=(a090*a068);
  a007=(a007-a026);
  a026=(a059/a007);
  a000=(a031*a000);
  a018=(a000/a018);
  a090=(a090*a018);
  a007=(a090/a007);
  a111=(a018*a111);
  a027=(a031*a101);
  a027=(a027*a101);
  a027=(a027*a048);
  a104=(a104*a042);
  a098=(a098*a029);
  a104=(a104+a098);
  a035=(a035*a051);
  a104=(a104+a035);
  a053=(a053*a006);
  a104=(a104+a053);
  a100=(a100*a054);
  a104=(a104+a100);
  a105=(a105*a062);
  a104=(a104+a105);
  a106=(a106*a071);
  a104=(a104+a106);
  a099=(a099*a082);
  a104=(a104+a099);
  a066=(a066*a093);
  a104=(a104+a066);
  a033=(a033+a104);
  a012=(a012*a033);
  a027=(a027+a012);
  a111=(a111-a027);
  a059=(a007*a059);
  a111=(a111-a059);
  a000=(a000*a018);
  a031=(a031-a000);
  a090=(a090*a007);
  a031=(a031-a090);
  a111=(a111/a031);
  a007=(a007*a111);
  a026=(a026-a007);
  a068=(a068*a026);
  a017=(a017-a068);
  a018=(a018*a111);
  a017=(a017+a018);
  a017=(a102*a017);
  a020=(a020+a017);
  a003=(a003+a020);
  if (res[0]!=0) res[0][3]=a003;
  a030=(a001*a030);
  a013=(a005*a013);
  a030=(a030+a013);
  a038=(a037*a038);
  a030=(a030+a038);
  a074=(a060*a074);
  a030=(a030+a074);
  a085=(a069*a085);
  a030=(a030+a085);
  a096=(a080*a096);
  a030=(a030+a096);
  a072=(a091*a072);
  a030=(a030+a072);
  a026=(a102*a026);
  a030=(a030+a026);
  a030=(a008+a030);
  if (res[0]!=0) res[0][4]=a030;
  a009=(a001*a009);
  a032=(a005*a032);
  a009=(a009+a032);
  a036=(a037*a036);
  a009=(a009+a036);
  a021=(a060*a021);
  a009=(a009+a021);
  a045=(a069*a045);
  a009=(a009+a045);
  a056=(a080*a056);
  a009=(a009+a056);
  a073=(a091*a073);
  a009=(a009+a073);
  a111=(a102*a111);
  a009=(a009+a111);
  a042=(a042+a009);
  if (res[0]!=0) res[0][5]=a042;
  a042=arg[0]? arg[0][6] : 0;
  a025=(a025*a008);
  a001=(a001*a025);
  a022=(a022*a052);
  a005=(a005*a022);
  a001=(a001+a005);
  a049=(a049*a057);
  a037=(a037*a049);
  a001=(a001+a037);
  a075=(a075*a040);
  a060=(a060*a075);
  a001=(a001+a060);
  a086=(a086*a044);
  a069=(a069*a086);
  a001=(a001+a069);
  a097=(a097*a058);
  a080=(a080*a097);
  a001=(a001+a080);
  a067=(a067*a002);
  a091=(a091*a067);
  a001=(a001+a091);
  a014=(a014*a110);
  a102=(a102*a014);
  a001=(a001+a102);
  a042=(a042-a001);
  if (res[0]!=0) res[0][6]=a042;
  return 0;
}

/* observe:(t,y[6],p[8])->(g[10],dg[10]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
  a00=arg[2]? arg[2][1] : 0;
  a01=arg[1]? arg[1][2] : 0;
  a02=(a00*a01);
  a03=arg[2]? arg[2][3] : 0;
  a04=arg[1]? arg[1][0] : 0;
  a05=arg[1]? arg[1][1] : 0;
  a06=(a04-a05);
  a07=sin(a06);
  a08=sin(a04);
  a09=(a07-a08);
  a09=(a03*a09);
  a02=(a02+a09);
  a02=(a02-a08);
  a09=(2.*a03);
  a10=1.;
  a11=(a09+a10);
  a02=(a02/a11);
  a12=cos(a04);
  a06=cos(a06);
  a13=(a12-a06);
  a14=(a03*a13);
  a14=(a14+a12);
  a14=(a14/a11);
  a15=(a00*a12);
  a16=cos(a05);
  a17=(a10-a16);
  a17=(a09*a17);
  a17=(a17+a10);
  a18=(a15/a17);
  a19=arg[1]? arg[1][4] : 0;
  a20=(a03*a19);
  a21=sin(a05);
  a22=(a20*a21);
  a23=arg[1]? arg[1][3] : 0;
  a24=(2.*a23);
  a25=(a19-a24);
  a26=(a22*a25);
  a27=(a03*a07);
  a26=(a26-a27);
  a28=(a03+a10);
  a29=(a08*a28);
  a26=(a26+a29);
  a30=(a18*a26);
  a31=(a00*a23);
  a32=(a31*a23);
  a33=(a32*a08);
  a34=arg[2]? arg[2][0] : 0;
  a35=(a34*a01);
  a33=(a33+a35);
  a30=(a30-a33);
  a33=(a16-a10);
  a33=(a03*a33);
  a35=(a33*a18);
  a36=(a33/a17);
  a37=(a33*a36);
  a37=(a03-a37);
  a38=(a35/a37);
  a39=casadi_sq(a23);
  a40=(a39*a21);
  a40=(a40+a07);
  a40=(a03*a40);
  a41=arg[2]? arg[2][5] : 0;
  a42=arg[2]? arg[2][7] : 0;
  a43=arg[2]? arg[2][2] : 0;
  a44=(a42*a43);
  a45=arg[0]? arg[0][0] : 0;
  a45=(a43*a45);
  a46=sin(a45);
  a47=(a44*a46);
  a47=(a19+a47);
  a47=(a41*a47);
  a48=arg[2]? arg[2][4] : 0;
  a49=arg[2]? arg[2][6] : 0;
  a45=cos(a45);
  a50=(a45+a10);
  a50=(a42*a50);
  a49=(a49-a50);
  a49=(a49+a05);
  a49=(a48*a49);
  a47=(a47+a49);
  a40=(a40-a47);
  a49=(a36*a26);
  a40=(a40-a49);
  a49=(a38*a40);
  a30=(a30-a49);
  a49=(a15*a18);
  a49=(a00-a49);
  a50=(a35*a38);
  a49=(a49-a50);
  a30=(a30/a49);
  a50=(a30*a00);
  a51=(a26/a17);
  a52=(a40/a37);
  a53=(a38*a30);
  a53=(a52-a53);
  a54=(a36*a53);
  a54=(a51-a54);
  a55=(a18*a30);
  a54=(a54+a55);
  a55=(a12*a28);
  a56=(a54*a55);
  a50=(a50-a56);
  a56=(a03*a06);
  a57=(a54-a53);
  a58=(a56*a57);
  a50=(a50+a58);
  a58=(a24*a19);
  a58=(a39-a58);
  a59=casadi_sq(a19);
  a58=(a58+a59);
  a59=(a27*a58);
  a50=(a50-a59);
  a59=(a39*a29);
  a50=(a50+a59);
  a59=(a14*a50);
  a60=(a56*a58);
  a61=(a54*a29);
  a60=(a60-a61);
  a61=(a27*a57);
  a60=(a60+a61);
  a61=(a39*a55);
  a62=(a60-a61);
  a62=(a62+a11);
  a59=(a59/a62);
  a02=(a02-a59);
  a02=(-a02);
  if (res[0]!=0) res[0][0]=a02;
  a02=0.;
  if (res[0]!=0) res[0][1]=a02;
  a60=(a60+a09);
  a60=(a60-a61);
  a60=(a60+a10);
  if (res[0]!=0) res[0][2]=a60;
  a10=(a50/a60);
  if (res[0]!=0) res[0][3]=a10;
  if (res[0]!=0) res[0][4]=a13;
  if (res[0]!=0) res[0][5]=a54;
  a04=(2.*a04);
  a05=(a05-a04);
  if (res[0]!=0) res[0][6]=a05;
  if (res[0]!=0) res[0][7]=a01;
  a01=(a47*a19);
  a01=(-a01);
  if (res[0]!=0) res[0][8]=a01;
  a01=(-a47);
  if (res[0]!=0) res[0][9]=a01;
  a01=arg[1]? arg[1][5] : 0;
  a05=(a00*a01);
  a04=(a23-a19);
  a06=(a06*a04);
  a12=(a12*a23);
  a13=(a06-a12);
  a13=(a03*a13);
  a05=(a05+a13);
  a05=(a05-a12);
  a05=(a05/a11);
  a07=(a07*a04);
  a04=(a08*a23);
  a13=(a07-a04);
  a61=(a03*a13);
  a61=(a61-a04);
  a61=(a61/a11);
  a50=(a50*a61);
  a61=(a03*a53);
  a61=(a21*a61);
  a16=(a16*a19);
  a20=(a20*a16);
  a61=(a61+a20);
  a61=(a25*a61);
  a20=(2.*a54);
  a11=(a53-a20);
  a22=(a22*a11);
  a61=(a61+a22);
  a22=(a03*a06);
  a61=(a61-a22);
  a11=(a28*a12);
  a61=(a61+a11);
  a63=(a18*a61);
  a64=(a00*a04);
  a65=(a64/a17);
  a66=(a18/a17);
  a67=(a21*a19);
  a09=(a09*a67);
  a66=(a66*a09);
  a65=(a65+a66);
  a66=(a26*a65);
  a63=(a63-a66);
  a66=(a00*a54);
  a23=(a23*a66);
  a31=(a31*a54);
  a23=(a23+a31);
  a08=(a08*a23);
  a32=(a32*a12);
  a08=(a08+a32);
  a34=(a34*a01);
  a08=(a08+a34);
  a63=(a63-a08);
  a08=(a24*a54);
  a21=(a21*a08);
  a16=(a39*a16);
  a21=(a21+a16);
  a21=(a21+a06);
  a21=(a03*a21);
  a45=(a45*a43);
  a44=(a44*a45);
  a44=(a53+a44);
  a41=(a41*a44);
  a46=(a46*a43);
  a42=(a42*a46);
  a42=(a42+a19);
  a48=(a48*a42);
  a41=(a41+a48);
  a21=(a21-a41);
  a48=(a36*a61);
  a67=(a03*a67);
  a42=(a67/a17);
  a46=(a36/a17);
  a46=(a46*a09);
  a42=(a42+a46);
  a26=(a26*a42);
  a48=(a48-a26);
  a21=(a21-a48);
  a48=(a38*a21);
  a26=(a18*a67);
  a46=(a33*a65);
  a26=(a26+a46);
  a46=(a26/a37);
  a43=(a38/a37);
  a67=(a36*a67);
  a33=(a33*a42);
  a67=(a67+a33);
  a43=(a43*a67);
  a46=(a46+a43);
  a40=(a40*a46);
  a48=(a48-a40);
  a63=(a63-a48);
  a63=(a63/a49);
  a49=(a30/a49);
  a64=(a18*a64);
  a15=(a15*a65);
  a64=(a64+a15);
  a26=(a38*a26);
  a35=(a35*a46);
  a26=(a26+a35);
  a64=(a64+a26);
  a49=(a49*a64);
  a63=(a63-a49);
  a00=(a00*a63);
  a61=(a61/a17);
  a51=(a51/a17);
  a51=(a51*a09);
  a61=(a61-a51);
  a21=(a21/a37);
  a52=(a52/a37);
  a52=(a52*a67);
  a21=(a21-a52);
  a38=(a38*a63);
  a46=(a30*a46);
  a38=(a38-a46);
  a21=(a21-a38);
  a36=(a36*a21);
  a42=(a53*a42);
  a36=(a36-a42);
  a61=(a61-a36);
  a18=(a18*a63);
  a30=(a30*a65);
  a18=(a18-a30);
  a61=(a61+a18);
  a18=(a55*a61);
  a28=(a28*a04);
  a04=(a54*a28);
  a18=(a18-a04);
  a00=(a00-a18);
  a21=(a61-a21);
  a18=(a56*a21);
  a03=(a03*a07);
  a07=(a57*a03);
  a18=(a18-a07);
  a00=(a00+a18);
  a18=(a58*a22);
  a20=(a19*a20);
  a24=(a24*a53);
  a20=(a20+a24);
  a20=(a08-a20);
  a24=(2.*a19);
  a24=(a24*a53);
  a20=(a20+a24);
  a24=(a27*a20);
  a18=(a18+a24);
  a00=(a00-a18);
  a18=(a29*a08);
  a24=(a39*a11);
  a18=(a18+a24);
  a00=(a00+a18);
  a14=(a14*a00);
  a50=(a50+a14);
  a50=(a50/a62);
  a59=(a59/a62);
  a56=(a56*a20);
  a58=(a58*a03);
  a56=(a56-a58);
  a29=(a29*a61);
  a54=(a54*a11);
  a29=(a29+a54);
  a56=(a56-a29);
  a57=(a57*a22);
  a27=(a27*a21);
  a57=(a57+a27);
  a56=(a56+a57);
  a55=(a55*a08);
  a39=(a39*a28);
  a55=(a55-a39);
  a56=(a56-a55);
  a59=(a59*a56);
  a50=(a50-a59);
  a05=(a05-a50);
  a05=(-a05);
  if (res[1]!=0) res[1][0]=a05;
  if (res[1]!=0) res[1][1]=a02;
  if (res[1]!=0) res[1][2]=a56;
  a00=(a00/a60);
  a10=(a10/a60);
  a10=(a10*a56);
  a00=(a00-a10);
  if (res[1]!=0) res[1][3]=a00;
  if (res[1]!=0) res[1][4]=a13;
  if (res[1]!=0) res[1][5]=a61;
  if (res[1]!=0) res[1][6]=a25;
  if (res[1]!=0) res[1][7]=a01;
  a19=(a19*a41);
  a47=(a47*a53);
  a19=(a19+a47);
  a19=(-a19);
  if (res[1]!=0) res[1][8]=a19;
  a41=(-a41);
  if (res[1]!=0) res[1][9]=a41;
  return 0;
}

/* working_steps:(t,turns[2x12],w[7],h,p[8])->(w_end[7],nodes[7x12],g[10x12],dg[10x12]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, *w00=w+116, w01, *w03=w+123, w05, *w06=w+125, w07, *w08=w+132, *w09=w+139, *w10=w+146, *w11=w+153;
  casadi_real *w12=w+160, *w13=w+167, *w14=w+174, *w15=w+181, *w16=w+188, *w17=w+195, *w18=w+202, *w19=w+209, *w20=w+215, *w21=w+225, *w22=w+235, *w23=w+245;
  casadi_real *w24=w+255, *w25=w+265, *w26=w+275, *w27=w+285, *w28=w+295, *w29=w+305, *w30=w+315, *w31=w+325, *w32=w+335;
  const casadi_real **arg1=arg+5, *cs, *wr02, *wr04;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 7, w00);
  /* #1: @1 = input[0][0] */
  w01 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[4][0] */
  wr02 = arg[4] ? arg[4] : casadi_zeros;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w01);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #5: @5 = input[3][0] */
  w05 = arg[3] ? arg[3][0] : 0;
  /* #6: @6 = working_step(@0, @3, @4, @5, @2) */
  arg1[0]=w00;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w06;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = working_step(@6, @3, @4, @5, @2) */
  arg1[0]=w06;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w08;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #11: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @9 = working_step(@8, @3, @4, @5, @2) */
  arg1[0]=w08;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @7 = 3 */
  w07 = 3.;
  /* #15: @7 = (@7*@5) */
  w07 *= w05;
  /* #16: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #17: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @10 = working_step(@9, @3, @4, @5, @2) */
  arg1[0]=w09;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w10;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #19: @7 = 4 */
  w07 = 4.;
  /* #20: @7 = (@7*@5) */
  w07 *= w05;
  /* #21: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #22: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @11 = working_step(@10, @3, @4, @5, @2) */
  arg1[0]=w10;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w11;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = 5 */
  w07 = 5.;
  /* #25: @7 = (@7*@5) */
  w07 *= w05;
  /* #26: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #27: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @12 = working_step(@11, @3, @4, @5, @2) */
  arg1[0]=w11;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w12;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #29: @7 = 6 */
  w07 = 6.;
  /* #30: @7 = (@7*@5) */
  w07 *= w05;
  /* #31: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #32: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @13 = working_step(@12, @3, @4, @5, @2) */
  arg1[0]=w12;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w13;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = 7 */
  w07 = 7.;
  /* #35: @7 = (@7*@5) */
  w07 *= w05;
  /* #36: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #37: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @14 = working_step(@13, @3, @4, @5, @2) */
  arg1[0]=w13;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w14;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #39: @7 = 8 */
  w07 = 8.;
  /* #40: @7 = (@7*@5) */
  w07 *= w05;
  /* #41: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #42: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @15 = working_step(@14, @3, @4, @5, @2) */
  arg1[0]=w14;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w15;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #44: @7 = 9 */
  w07 = 9.;
  /* #45: @7 = (@7*@5) */
  w07 *= w05;
  /* #46: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #47: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @16 = working_step(@15, @3, @4, @5, @2) */
  arg1[0]=w15;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w16;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #49: @7 = 10 */
  w07 = 10.;
  /* #50: @7 = (@7*@5) */
  w07 *= w05;
  /* #51: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #52: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @17 = working_step(@16, @3, @4, @5, @2) */
  arg1[0]=w16;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w17;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = 11 */
  w07 = 11.;
  /* #55: @7 = (@7*@5) */
  w07 *= w05;
  /* #56: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #57: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=wr02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @18 = working_step(@17, @3, @4, @5, @2) */
  arg1[0]=w17;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=wr02;
  res1[0]=w18;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @18 */
  casadi_copy(w18, 7, res[0]);
  /* #60: output[1][0] = @0 */
  casadi_copy(w00, 7, res[1]);
  /* #61: output[1][1] = @6 */
  if (res[1]) casadi_copy(w06, 7, res[1]+7);
  /* #62: output[1][2] = @8 */
  if (res[1]) casadi_copy(w08, 7, res[1]+14);
  /* #63: output[1][3] = @9 */
  if (res[1]) casadi_copy(w09, 7, res[1]+21);
  /* #64: output[1][4] = @10 */
  if (res[1]) casadi_copy(w10, 7, res[1]+28);
  /* #65: output[1][5] = @11 */
  if (res[1]) casadi_copy(w11, 7, res[1]+35);
  /* #66: output[1][6] = @12 */
  if (res[1]) casadi_copy(w12, 7, res[1]+42);
  /* #67: output[1][7] = @13 */
  if (res[1]) casadi_copy(w13, 7, res[1]+49);
  /* #68: output[1][8] = @14 */
  if (res[1]) casadi_copy(w14, 7, res[1]+56);
  /* #69: output[1][9] = @15 */
  if (res[1]) casadi_copy(w15, 7, res[1]+63);
  /* #70: output[1][10] = @16 */
  if (res[1]) casadi_copy(w16, 7, res[1]+70);
  /* #71: output[1][11] = @17 */
  if (res[1]) casadi_copy(w17, 7, res[1]+77);
  /* #72: @19 = @0[:6] */
  for (rr=w19, cs=w00+0; cs!=w00+6; cs+=1) *rr++ = *cs;
  /* #73: {@20, @21} = observe(@1, @19, @2) */
  arg1[0]=(&w01);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w21;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[2][0] = @20 */
  casadi_copy(w20, 10, res[2]);
  /* #75: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #76: @19 = @6[:6] */
  for (rr=w19, cs=w06+0; cs!=w06+6; cs+=1) *rr++ = *cs;
  /* #77: {@20, @22} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w22;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[2][1] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+10);
  /* #79: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #80: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #81: @19 = @8[:6] */
  for (rr=w19, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #82: {@20, @23} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w23;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[2][2] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+20);
  /* #84: @7 = 3 */
  w07 = 3.;
  /* #85: @7 = (@7*@5) */
  w07 *= w05;
  /* #86: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #87: @19 = @9[:6] */
  for (rr=w19, cs=w09+0; cs!=w09+6; cs+=1) *rr++ = *cs;
  /* #88: {@20, @24} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w24;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[2][3] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+30);
  /* #90: @7 = 4 */
  w07 = 4.;
  /* #91: @7 = (@7*@5) */
  w07 *= w05;
  /* #92: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #93: @19 = @10[:6] */
  for (rr=w19, cs=w10+0; cs!=w10+6; cs+=1) *rr++ = *cs;
  /* #94: {@20, @25} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w25;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+40);
  /* #96: @7 = 5 */
  w07 = 5.;
  /* #97: @7 = (@7*@5) */
  w07 *= w05;
  /* #98: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #99: @19 = @11[:6] */
  for (rr=w19, cs=w11+0; cs!=w11+6; cs+=1) *rr++ = *cs;
  /* #100: {@20, @26} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w26;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+50);
  /* #102: @7 = 6 */
  w07 = 6.;
  /* #103: @7 = (@7*@5) */
  w07 *= w05;
  /* #104: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #105: @19 = @12[:6] */
  for (rr=w19, cs=w12+0; cs!=w12+6; cs+=1) *rr++ = *cs;
  /* #106: {@20, @27} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w27;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #107: output[2][6] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+60);
  /* #108: @7 = 7 */
  w07 = 7.;
  /* #109: @7 = (@7*@5) */
  w07 *= w05;
  /* #110: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #111: @19 = @13[:6] */
  for (rr=w19, cs=w13+0; cs!=w13+6; cs+=1) *rr++ = *cs;
  /* #112: {@20, @28} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w28;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #113: output[2][7] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+70);
  /* #114: @7 = 8 */
  w07 = 8.;
  /* #115: @7 = (@7*@5) */
  w07 *= w05;
  /* #116: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #117: @19 = @14[:6] */
  for (rr=w19, cs=w14+0; cs!=w14+6; cs+=1) *rr++ = *cs;
  /* #118: {@20, @29} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w29;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #119: output[2][8] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+80);
  /* #120: @7 = 9 */
  w07 = 9.;
  /* #121: @7 = (@7*@5) */
  w07 *= w05;
  /* #122: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #123: @19 = @15[:6] */
  for (rr=w19, cs=w15+0; cs!=w15+6; cs+=1) *rr++ = *cs;
  /* #124: {@20, @30} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w30;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #125: output[2][9] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+90);
  /* #126: @7 = 10 */
  w07 = 10.;
  /* #127: @7 = (@7*@5) */
  w07 *= w05;
  /* #128: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #129: @19 = @16[:6] */
  for (rr=w19, cs=w16+0; cs!=w16+6; cs+=1) *rr++ = *cs;
  /* #130: {@20, @31} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w31;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #131: output[2][10] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+100);
  /* #132: @7 = 11 */
  w07 = 11.;
  /* #133: @7 = (@7*@5) */
  w07 *= w05;
  /* #134: @1 = (@1+@7) */
  w01 += w07;
  /* #135: @19 = @17[:6] */
  for (rr=w19, cs=w17+0; cs!=w17+6; cs+=1) *rr++ = *cs;
  /* #136: {@20, @32} = observe(@1, @19, @2) */
  arg1[0]=(&w01);
  arg1[1]=w19;
  arg1[2]=wr02;
  res1[0]=w20;
  res1[1]=w32;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #137: output[2][11] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+110);
  /* #138: output[3][0] = @21 */
  casadi_copy(w21, 10, res[3]);
  /* #139: output[3][1] = @22 */
  if (res[3]) casadi_copy(w22, 10, res[3]+10);
  /* #140: output[3][2] = @23 */
  if (res[3]) casadi_copy(w23, 10, res[3]+20);
  /* #141: output[3][3] = @24 */
  if (res[3]) casadi_copy(w24, 10, res[3]+30);
  /* #142: output[3][4] = @25 */
  if (res[3]) casadi_copy(w25, 10, res[3]+40);
  /* #143: output[3][5] = @26 */
  if (res[3]) casadi_copy(w26, 10, res[3]+50);
  /* #144: output[3][6] = @27 */
  if (res[3]) casadi_copy(w27, 10, res[3]+60);
  /* #145: output[3][7] = @28 */
  if (res[3]) casadi_copy(w28, 10, res[3]+70);
  /* #146: output[3][8] = @29 */
  if (res[3]) casadi_copy(w29, 10, res[3]+80);
  /* #147: output[3][9] = @30 */
  if (res[3]) casadi_copy(w30, 10, res[3]+90);
  /* #148: output[3][10] = @31 */
  if (res[3]) casadi_copy(w31, 10, res[3]+100);
  /* #149: output[3][11] = @32 */
  if (res[3]) casadi_copy(w32, 10, res[3]+110);
  return 0;
}

/* wobbling_trace_48:(u[6],p[8])->(w[7x49],g[10x49],dg[10x49],R[6]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1483, *w21=w+1493;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 48 */
  w03 = 48.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+336);
  /* #26: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #27: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #28: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #29: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #30: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #31: {@19, @20} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w19;
  res1[1]=w20;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 10, res[1]+480);
  /* #33: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #34: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #35: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #36: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #37: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+480);
  /* #38: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #39: @21 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w21;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[3][0] = @21 */
  casadi_copy(w21, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s7;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1499;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1499*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_72:(u[6],p[8])->(w[7x73],g[10x73],dg[10x73],R[6]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1593, *w21=w+1713, *w22=w+1833;
  casadi_real *w23=w+1953, *w24=w+1963, *w25=w+1973;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 72 */
  w03 = 72.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+336);
  /* #29: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+420);
  /* #33: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+504);
  /* #34: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #35: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #36: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #37: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #38: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 120, res[1]+480);
  /* #39: output[1][5] = @21 */
  if (res[1]) casadi_copy(w21, 120, res[1]+600);
  /* #40: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #41: {@23, @24} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w23;
  res1[1]=w24;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[1][6] = @23 */
  if (res[1]) casadi_copy(w23, 10, res[1]+720);
  /* #43: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #44: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #45: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #46: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #47: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 120, res[2]+480);
  /* #48: output[2][5] = @22 */
  if (res[2]) casadi_copy(w22, 120, res[2]+600);
  /* #49: output[2][6] = @24 */
  if (res[2]) casadi_copy(w24, 10, res[2]+720);
  /* #50: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #51: @25 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w25;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[3][0] = @25 */
  casadi_copy(w25, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f90(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_72_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1979;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1979*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_96:(u[6],p[8])->(w[7x97],g[10x97],dg[10x97],R[6]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1593, *w21=w+1713, *w22=w+1833;
  casadi_real *w23=w+1953, *w24=w+2073, *w25=w+2193, *w26=w+2313, *w27=w+2433, *w28=w+2443, *w29=w+2453;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 96 */
  w03 = 96.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+336);
  /* #29: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+420);
  /* #33: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+504);
  /* #37: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+588);
  /* #41: output[0][8] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+672);
  /* #42: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #43: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #44: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #45: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #46: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 120, res[1]+480);
  /* #47: output[1][5] = @21 */
  if (res[1]) casadi_copy(w21, 120, res[1]+600);
  /* #48: output[1][6] = @23 */
  if (res[1]) casadi_copy(w23, 120, res[1]+720);
  /* #49: output[1][7] = @25 */
  if (res[1]) casadi_copy(w25, 120, res[1]+840);
  /* #50: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #51: {@27, @28} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w27;
  res1[1]=w28;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[1][8] = @27 */
  if (res[1]) casadi_copy(w27, 10, res[1]+960);
  /* #53: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #54: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #55: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #56: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #57: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 120, res[2]+480);
  /* #58: output[2][5] = @22 */
  if (res[2]) casadi_copy(w22, 120, res[2]+600);
  /* #59: output[2][6] = @24 */
  if (res[2]) casadi_copy(w24, 120, res[2]+720);
  /* #60: output[2][7] = @26 */
  if (res[2]) casadi_copy(w26, 120, res[2]+840);
  /* #61: output[2][8] = @28 */
  if (res[2]) casadi_copy(w28, 10, res[2]+960);
  /* #62: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #63: @29 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w29;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[3][0] = @29 */
  casadi_copy(w29, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2459;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2459*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_144:(u[6],p[8])->(w[7x145],g[10x145],dg[10x145],R[6]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1593, *w21=w+1713, *w22=w+1833;
  casadi_real *w23=w+1953, *w24=w+2073, *w25=w+2193, *w26=w+2313, *w27=w+2433, *w28=w+2553, *w29=w+2673, *w30=w+2793, *w31=w+2913, *w32=w+3033, *w33=w+3153, *w34=w+3273;
  casadi_real *w35=w+3393, *w36=w+3403, *w37=w+3413;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 144 */
  w03 = 144.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+336);
  /* #29: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+420);
  /* #33: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+504);
  /* #37: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+588);
  /* #41: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+672);
  /* #45: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+756);
  /* #49: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+840);
  /* #53: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+924);
  /* #57: output[0][12] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+1008);
  /* #58: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #59: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #60: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #61: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #62: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 120, res[1]+480);
  /* #63: output[1][5] = @21 */
  if (res[1]) casadi_copy(w21, 120, res[1]+600);
  /* #64: output[1][6] = @23 */
  if (res[1]) casadi_copy(w23, 120, res[1]+720);
  /* #65: output[1][7] = @25 */
  if (res[1]) casadi_copy(w25, 120, res[1]+840);
  /* #66: output[1][8] = @27 */
  if (res[1]) casadi_copy(w27, 120, res[1]+960);
  /* #67: output[1][9] = @29 */
  if (res[1]) casadi_copy(w29, 120, res[1]+1080);
  /* #68: output[1][10] = @31 */
  if (res[1]) casadi_copy(w31, 120, res[1]+1200);
  /* #69: output[1][11] = @33 */
  if (res[1]) casadi_copy(w33, 120, res[1]+1320);
  /* #70: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #71: {@35, @36} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w35;
  res1[1]=w36;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[1][12] = @35 */
  if (res[1]) casadi_copy(w35, 10, res[1]+1440);
  /* #73: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #74: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #75: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #76: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #77: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 120, res[2]+480);
  /* #78: output[2][5] = @22 */
  if (res[2]) casadi_copy(w22, 120, res[2]+600);
  /* #79: output[2][6] = @24 */
  if (res[2]) casadi_copy(w24, 120, res[2]+720);
  /* #80: output[2][7] = @26 */
  if (res[2]) casadi_copy(w26, 120, res[2]+840);
  /* #81: output[2][8] = @28 */
  if (res[2]) casadi_copy(w28, 120, res[2]+960);
  /* #82: output[2][9] = @30 */
  if (res[2]) casadi_copy(w30, 120, res[2]+1080);
  /* #83: output[2][10] = @32 */
  if (res[2]) casadi_copy(w32, 120, res[2]+1200);
  /* #84: output[2][11] = @34 */
  if (res[2]) casadi_copy(w34, 120, res[2]+1320);
  /* #85: output[2][12] = @36 */
  if (res[2]) casadi_copy(w36, 10, res[2]+1440);
  /* #86: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #87: @37 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w37;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[3][0] = @37 */
  casadi_copy(w37, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_144_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3419;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3419*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_192:(u[6],p[8])->(w[7x193],g[10x193],dg[10x193],R[6]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1593, *w21=w+1713, *w22=w+1833;
  casadi_real *w23=w+1953, *w24=w+2073, *w25=w+2193, *w26=w+2313, *w27=w+2433, *w28=w+2553, *w29=w+2673, *w30=w+2793, *w31=w+2913, *w32=w+3033, *w33=w+3153, *w34=w+3273;
  casadi_real *w35=w+3393, *w36=w+3513, *w37=w+3633, *w38=w+3753, *w39=w+3873, *w40=w+3993, *w41=w+4113, *w42=w+4233, *w43=w+4353, *w44=w+4363, *w45=w+4373;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 192 */
  w03 = 192.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+336);
  /* #29: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+420);
  /* #33: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+504);
  /* #37: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+588);
  /* #41: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+672);
  /* #45: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+756);
  /* #49: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+840);
  /* #53: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+924);
  /* #57: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w00 *= w02;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1008);
  /* #61: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #62: @0 = (@0*@2) */
  w00 *= w02;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1092);
  /* #65: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #66: @0 = (@0*@2) */
  w00 *= w02;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1176);
  /* #69: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w00 *= w02;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1260);
  /* #73: output[0][16] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+1344);
  /* #74: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #75: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #76: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #77: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #78: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 120, res[1]+480);
  /* #79: output[1][5] = @21 */
  if (res[1]) casadi_copy(w21, 120, res[1]+600);
  /* #80: output[1][6] = @23 */
  if (res[1]) casadi_copy(w23, 120, res[1]+720);
  /* #81: output[1][7] = @25 */
  if (res[1]) casadi_copy(w25, 120, res[1]+840);
  /* #82: output[1][8] = @27 */
  if (res[1]) casadi_copy(w27, 120, res[1]+960);
  /* #83: output[1][9] = @29 */
  if (res[1]) casadi_copy(w29, 120, res[1]+1080);
  /* #84: output[1][10] = @31 */
  if (res[1]) casadi_copy(w31, 120, res[1]+1200);
  /* #85: output[1][11] = @33 */
  if (res[1]) casadi_copy(w33, 120, res[1]+1320);
  /* #86: output[1][12] = @35 */
  if (res[1]) casadi_copy(w35, 120, res[1]+1440);
  /* #87: output[1][13] = @37 */
  if (res[1]) casadi_copy(w37, 120, res[1]+1560);
  /* #88: output[1][14] = @39 */
  if (res[1]) casadi_copy(w39, 120, res[1]+1680);
  /* #89: output[1][15] = @41 */
  if (res[1]) casadi_copy(w41, 120, res[1]+1800);
  /* #90: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #91: {@43, @44} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w43;
  res1[1]=w44;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[1][16] = @43 */
  if (res[1]) casadi_copy(w43, 10, res[1]+1920);
  /* #93: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #94: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #95: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #96: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #97: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 120, res[2]+480);
  /* #98: output[2][5] = @22 */
  if (res[2]) casadi_copy(w22, 120, res[2]+600);
  /* #99: output[2][6] = @24 */
  if (res[2]) casadi_copy(w24, 120, res[2]+720);
  /* #100: output[2][7] = @26 */
  if (res[2]) casadi_copy(w26, 120, res[2]+840);
  /* #101: output[2][8] = @28 */
  if (res[2]) casadi_copy(w28, 120, res[2]+960);
  /* #102: output[2][9] = @30 */
  if (res[2]) casadi_copy(w30, 120, res[2]+1080);
  /* #103: output[2][10] = @32 */
  if (res[2]) casadi_copy(w32, 120, res[2]+1200);
  /* #104: output[2][11] = @34 */
  if (res[2]) casadi_copy(w34, 120, res[2]+1320);
  /* #105: output[2][12] = @36 */
  if (res[2]) casadi_copy(w36, 120, res[2]+1440);
  /* #106: output[2][13] = @38 */
  if (res[2]) casadi_copy(w38, 120, res[2]+1560);
  /* #107: output[2][14] = @40 */
  if (res[2]) casadi_copy(w40, 120, res[2]+1680);
  /* #108: output[2][15] = @42 */
  if (res[2]) casadi_copy(w42, 120, res[2]+1800);
  /* #109: output[2][16] = @44 */
  if (res[2]) casadi_copy(w44, 10, res[2]+1920);
  /* #110: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #111: @45 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w45;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[3][0] = @45 */
  casadi_copy(w45, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 4379;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4379*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_288:(u[6],p[8])->(w[7x289],g[10x289],dg[10x289],R[6]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1593, *w21=w+1713, *w22=w+1833;
  casadi_real *w23=w+1953, *w24=w+2073, *w25=w+2193, *w26=w+2313, *w27=w+2433, *w28=w+2553, *w29=w+2673, *w30=w+2793, *w31=w+2913, *w32=w+3033, *w33=w+3153, *w34=w+3273;
  casadi_real *w35=w+3393, *w36=w+3513, *w37=w+3633, *w38=w+3753, *w39=w+3873, *w40=w+3993, *w41=w+4113, *w42=w+4233, *w43=w+4353, *w44=w+4473, *w45=w+4593, *w46=w+4713;
  casadi_real *w47=w+4833, *w48=w+4953, *w49=w+5073, *w50=w+5193, *w51=w+5313, *w52=w+5433, *w53=w+5553, *w54=w+5673, *w55=w+5793, *w56=w+5913, *w57=w+6033, *w58=w+6153;
  casadi_real *w59=w+6273, *w60=w+6283, *w61=w+6293;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 288 */
  w03 = 288.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.0416667 */
  w00 = 4.1666666666666664e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+336);
  /* #29: @0 = 0.208333 */
  w00 = 2.0833333333333334e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+420);
  /* #33: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+504);
  /* #37: @0 = 0.291667 */
  w00 = 2.9166666666666669e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+588);
  /* #41: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+672);
  /* #45: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+756);
  /* #49: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+840);
  /* #53: @0 = 0.458333 */
  w00 = 4.5833333333333331e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+924);
  /* #57: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w00 *= w02;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1008);
  /* #61: @0 = 0.541667 */
  w00 = 5.4166666666666663e-01;
  /* #62: @0 = (@0*@2) */
  w00 *= w02;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1092);
  /* #65: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #66: @0 = (@0*@2) */
  w00 *= w02;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1176);
  /* #69: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w00 *= w02;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1260);
  /* #73: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #74: @0 = (@0*@2) */
  w00 *= w02;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w43;
  res1[3]=w44;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1344);
  /* #77: @0 = 0.708333 */
  w00 = 7.0833333333333337e-01;
  /* #78: @0 = (@0*@2) */
  w00 *= w02;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w45;
  res1[3]=w46;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1428);
  /* #81: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w00 *= w02;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w47;
  res1[3]=w48;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1512);
  /* #85: @0 = 0.791667 */
  w00 = 7.9166666666666663e-01;
  /* #86: @0 = (@0*@2) */
  w00 *= w02;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w49;
  res1[3]=w50;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1596);
  /* #89: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #90: @0 = (@0*@2) */
  w00 *= w02;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w51;
  res1[3]=w52;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1680);
  /* #93: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #94: @0 = (@0*@2) */
  w00 *= w02;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w53;
  res1[3]=w54;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1764);
  /* #97: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #98: @0 = (@0*@2) */
  w00 *= w02;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w55;
  res1[3]=w56;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1848);
  /* #101: @0 = 0.958333 */
  w00 = 9.5833333333333337e-01;
  /* #102: @0 = (@0*@2) */
  w00 *= w02;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w57;
  res1[3]=w58;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1932);
  /* #105: output[0][24] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+2016);
  /* #106: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #107: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #108: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #109: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #110: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 120, res[1]+480);
  /* #111: output[1][5] = @21 */
  if (res[1]) casadi_copy(w21, 120, res[1]+600);
  /* #112: output[1][6] = @23 */
  if (res[1]) casadi_copy(w23, 120, res[1]+720);
  /* #113: output[1][7] = @25 */
  if (res[1]) casadi_copy(w25, 120, res[1]+840);
  /* #114: output[1][8] = @27 */
  if (res[1]) casadi_copy(w27, 120, res[1]+960);
  /* #115: output[1][9] = @29 */
  if (res[1]) casadi_copy(w29, 120, res[1]+1080);
  /* #116: output[1][10] = @31 */
  if (res[1]) casadi_copy(w31, 120, res[1]+1200);
  /* #117: output[1][11] = @33 */
  if (res[1]) casadi_copy(w33, 120, res[1]+1320);
  /* #118: output[1][12] = @35 */
  if (res[1]) casadi_copy(w35, 120, res[1]+1440);
  /* #119: output[1][13] = @37 */
  if (res[1]) casadi_copy(w37, 120, res[1]+1560);
  /* #120: output[1][14] = @39 */
  if (res[1]) casadi_copy(w39, 120, res[1]+1680);
  /* #121: output[1][15] = @41 */
  if (res[1]) casadi_copy(w41, 120, res[1]+1800);
  /* #122: output[1][16] = @43 */
  if (res[1]) casadi_copy(w43, 120, res[1]+1920);
  /* #123: output[1][17] = @45 */
  if (res[1]) casadi_copy(w45, 120, res[1]+2040);
  /* #124: output[1][18] = @47 */
  if (res[1]) casadi_copy(w47, 120, res[1]+2160);
  /* #125: output[1][19] = @49 */
  if (res[1]) casadi_copy(w49, 120, res[1]+2280);
  /* #126: output[1][20] = @51 */
  if (res[1]) casadi_copy(w51, 120, res[1]+2400);
  /* #127: output[1][21] = @53 */
  if (res[1]) casadi_copy(w53, 120, res[1]+2520);
  /* #128: output[1][22] = @55 */
  if (res[1]) casadi_copy(w55, 120, res[1]+2640);
  /* #129: output[1][23] = @57 */
  if (res[1]) casadi_copy(w57, 120, res[1]+2760);
  /* #130: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #131: {@59, @60} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w59;
  res1[1]=w60;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[1][24] = @59 */
  if (res[1]) casadi_copy(w59, 10, res[1]+2880);
  /* #133: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #134: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #135: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #136: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #137: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 120, res[2]+480);
  /* #138: output[2][5] = @22 */
  if (res[2]) casadi_copy(w22, 120, res[2]+600);
  /* #139: output[2][6] = @24 */
  if (res[2]) casadi_copy(w24, 120, res[2]+720);
  /* #140: output[2][7] = @26 */
  if (res[2]) casadi_copy(w26, 120, res[2]+840);
  /* #141: output[2][8] = @28 */
  if (res[2]) casadi_copy(w28, 120, res[2]+960);
  /* #142: output[2][9] = @30 */
  if (res[2]) casadi_copy(w30, 120, res[2]+1080);
  /* #143: output[2][10] = @32 */
  if (res[2]) casadi_copy(w32, 120, res[2]+1200);
  /* #144: output[2][11] = @34 */
  if (res[2]) casadi_copy(w34, 120, res[2]+1320);
  /* #145: output[2][12] = @36 */
  if (res[2]) casadi_copy(w36, 120, res[2]+1440);
  /* #146: output[2][13] = @38 */
  if (res[2]) casadi_copy(w38, 120, res[2]+1560);
  /* #147: output[2][14] = @40 */
  if (res[2]) casadi_copy(w40, 120, res[2]+1680);
  /* #148: output[2][15] = @42 */
  if (res[2]) casadi_copy(w42, 120, res[2]+1800);
  /* #149: output[2][16] = @44 */
  if (res[2]) casadi_copy(w44, 120, res[2]+1920);
  /* #150: output[2][17] = @46 */
  if (res[2]) casadi_copy(w46, 120, res[2]+2040);
  /* #151: output[2][18] = @48 */
  if (res[2]) casadi_copy(w48, 120, res[2]+2160);
  /* #152: output[2][19] = @50 */
  if (res[2]) casadi_copy(w50, 120, res[2]+2280);
  /* #153: output[2][20] = @52 */
  if (res[2]) casadi_copy(w52, 120, res[2]+2400);
  /* #154: output[2][21] = @54 */
  if (res[2]) casadi_copy(w54, 120, res[2]+2520);
  /* #155: output[2][22] = @56 */
  if (res[2]) casadi_copy(w56, 120, res[2]+2640);
  /* #156: output[2][23] = @58 */
  if (res[2]) casadi_copy(w58, 120, res[2]+2760);
  /* #157: output[2][24] = @60 */
  if (res[2]) casadi_copy(w60, 10, res[2]+2880);
  /* #158: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #159: @61 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w61;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #160: output[3][0] = @61 */
  casadi_copy(w61, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_288_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s18;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6299;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6299*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_384:(u[6],p[8])->(w[7x385],g[10x385],dg[10x385],R[6]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+380, w02, w03, *w05=w+386, *w06=w+410, w07, *w08=w+415, *w09=w+422, *w10=w+429;
  casadi_real *w11=w+513, *w12=w+633, *w13=w+753, *w14=w+873, *w15=w+993, *w16=w+1113, *w17=w+1233, *w18=w+1353, *w19=w+1473, *w20=w+1593, *w21=w+1713, *w22=w+1833;
  casadi_real *w23=w+1953, *w24=w+2073, *w25=w+2193, *w26=w+2313, *w27=w+2433, *w28=w+2553, *w29=w+2673, *w30=w+2793, *w31=w+2913, *w32=w+3033, *w33=w+3153, *w34=w+3273;
  casadi_real *w35=w+3393, *w36=w+3513, *w37=w+3633, *w38=w+3753, *w39=w+3873, *w40=w+3993, *w41=w+4113, *w42=w+4233, *w43=w+4353, *w44=w+4473, *w45=w+4593, *w46=w+4713;
  casadi_real *w47=w+4833, *w48=w+4953, *w49=w+5073, *w50=w+5193, *w51=w+5313, *w52=w+5433, *w53=w+5553, *w54=w+5673, *w55=w+5793, *w56=w+5913, *w57=w+6033, *w58=w+6153;
  casadi_real *w59=w+6273, *w60=w+6393, *w61=w+6513, *w62=w+6633, *w63=w+6753, *w64=w+6873, *w65=w+6993, *w66=w+7113, *w67=w+7233, *w68=w+7353, *w69=w+7473, *w70=w+7593;
  casadi_real *w71=w+7713, *w72=w+7833, *w73=w+7953, *w74=w+8073, *w75=w+8193, *w76=w+8203, *w77=w+8213;
  const casadi_real **arg1=arg+2, *cs, *wr04;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[5] */
  for (rr=(&w02), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 384 */
  w03 = 384.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  wr04 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=wr04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w06, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=wr04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<6; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 84, res[0]);
  /* #13: @0 = 0.03125 */
  w00 = 3.1250000000000000e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+84);
  /* #17: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+168);
  /* #21: @0 = 0.09375 */
  w00 = 9.3750000000000000e-02;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+252);
  /* #25: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+336);
  /* #29: @0 = 0.15625 */
  w00 = 1.5625000000000000e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+420);
  /* #33: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+504);
  /* #37: @0 = 0.21875 */
  w00 = 2.1875000000000000e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+588);
  /* #41: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+672);
  /* #45: @0 = 0.28125 */
  w00 = 2.8125000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+756);
  /* #49: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+840);
  /* #53: @0 = 0.34375 */
  w00 = 3.4375000000000000e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+924);
  /* #57: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w00 *= w02;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1008);
  /* #61: @0 = 0.40625 */
  w00 = 4.0625000000000000e-01;
  /* #62: @0 = (@0*@2) */
  w00 *= w02;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1092);
  /* #65: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #66: @0 = (@0*@2) */
  w00 *= w02;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1176);
  /* #69: @0 = 0.46875 */
  w00 = 4.6875000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w00 *= w02;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1260);
  /* #73: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #74: @0 = (@0*@2) */
  w00 *= w02;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w43;
  res1[3]=w44;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1344);
  /* #77: @0 = 0.53125 */
  w00 = 5.3125000000000000e-01;
  /* #78: @0 = (@0*@2) */
  w00 *= w02;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w45;
  res1[3]=w46;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1428);
  /* #81: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w00 *= w02;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w47;
  res1[3]=w48;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1512);
  /* #85: @0 = 0.59375 */
  w00 = 5.9375000000000000e-01;
  /* #86: @0 = (@0*@2) */
  w00 *= w02;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w49;
  res1[3]=w50;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1596);
  /* #89: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #90: @0 = (@0*@2) */
  w00 *= w02;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w51;
  res1[3]=w52;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1680);
  /* #93: @0 = 0.65625 */
  w00 = 6.5625000000000000e-01;
  /* #94: @0 = (@0*@2) */
  w00 *= w02;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w53;
  res1[3]=w54;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1764);
  /* #97: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #98: @0 = (@0*@2) */
  w00 *= w02;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w55;
  res1[3]=w56;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1848);
  /* #101: @0 = 0.71875 */
  w00 = 7.1875000000000000e-01;
  /* #102: @0 = (@0*@2) */
  w00 *= w02;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w57;
  res1[3]=w58;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+1932);
  /* #105: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #106: @0 = (@0*@2) */
  w00 *= w02;
  /* #107: {@9, @10, @59, @60} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w59;
  res1[3]=w60;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[0][24] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2016);
  /* #109: @0 = 0.78125 */
  w00 = 7.8125000000000000e-01;
  /* #110: @0 = (@0*@2) */
  w00 *= w02;
  /* #111: {@8, @10, @61, @62} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w61;
  res1[3]=w62;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[0][25] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2100);
  /* #113: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #114: @0 = (@0*@2) */
  w00 *= w02;
  /* #115: {@9, @10, @63, @64} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w63;
  res1[3]=w64;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #116: output[0][26] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2184);
  /* #117: @0 = 0.84375 */
  w00 = 8.4375000000000000e-01;
  /* #118: @0 = (@0*@2) */
  w00 *= w02;
  /* #119: {@8, @10, @65, @66} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w65;
  res1[3]=w66;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[0][27] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2268);
  /* #121: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #122: @0 = (@0*@2) */
  w00 *= w02;
  /* #123: {@9, @10, @67, @68} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w67;
  res1[3]=w68;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[0][28] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2352);
  /* #125: @0 = 0.90625 */
  w00 = 9.0625000000000000e-01;
  /* #126: @0 = (@0*@2) */
  w00 *= w02;
  /* #127: {@8, @10, @69, @70} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w69;
  res1[3]=w70;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #128: output[0][29] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2436);
  /* #129: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #130: @0 = (@0*@2) */
  w00 *= w02;
  /* #131: {@9, @10, @71, @72} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w71;
  res1[3]=w72;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[0][30] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2520);
  /* #133: @0 = 0.96875 */
  w00 = 9.6875000000000000e-01;
  /* #134: @0 = (@0*@2) */
  w00 *= w02;
  /* #135: {@8, @10, @73, @74} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=wr04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w73;
  res1[3]=w74;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #136: output[0][31] = @10 */
  if (res[0]) casadi_copy(w10, 84, res[0]+2604);
  /* #137: output[0][32] = @8 */
  if (res[0]) casadi_copy(w08, 7, res[0]+2688);
  /* #138: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #139: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #140: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #141: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #142: output[1][4] = @19 */
  if (res[1]) casadi_copy(w19, 120, res[1]+480);
  /* #143: output[1][5] = @21 */
  if (res[1]) casadi_copy(w21, 120, res[1]+600);
  /* #144: output[1][6] = @23 */
  if (res[1]) casadi_copy(w23, 120, res[1]+720);
  /* #145: output[1][7] = @25 */
  if (res[1]) casadi_copy(w25, 120, res[1]+840);
  /* #146: output[1][8] = @27 */
  if (res[1]) casadi_copy(w27, 120, res[1]+960);
  /* #147: output[1][9] = @29 */
  if (res[1]) casadi_copy(w29, 120, res[1]+1080);
  /* #148: output[1][10] = @31 */
  if (res[1]) casadi_copy(w31, 120, res[1]+1200);
  /* #149: output[1][11] = @33 */
  if (res[1]) casadi_copy(w33, 120, res[1]+1320);
  /* #150: output[1][12] = @35 */
  if (res[1]) casadi_copy(w35, 120, res[1]+1440);
  /* #151: output[1][13] = @37 */
  if (res[1]) casadi_copy(w37, 120, res[1]+1560);
  /* #152: output[1][14] = @39 */
  if (res[1]) casadi_copy(w39, 120, res[1]+1680);
  /* #153: output[1][15] = @41 */
  if (res[1]) casadi_copy(w41, 120, res[1]+1800);
  /* #154: output[1][16] = @43 */
  if (res[1]) casadi_copy(w43, 120, res[1]+1920);
  /* #155: output[1][17] = @45 */
  if (res[1]) casadi_copy(w45, 120, res[1]+2040);
  /* #156: output[1][18] = @47 */
  if (res[1]) casadi_copy(w47, 120, res[1]+2160);
  /* #157: output[1][19] = @49 */
  if (res[1]) casadi_copy(w49, 120, res[1]+2280);
  /* #158: output[1][20] = @51 */
  if (res[1]) casadi_copy(w51, 120, res[1]+2400);
  /* #159: output[1][21] = @53 */
  if (res[1]) casadi_copy(w53, 120, res[1]+2520);
  /* #160: output[1][22] = @55 */
  if (res[1]) casadi_copy(w55, 120, res[1]+2640);
  /* #161: output[1][23] = @57 */
  if (res[1]) casadi_copy(w57, 120, res[1]+2760);
  /* #162: output[1][24] = @59 */
  if (res[1]) casadi_copy(w59, 120, res[1]+2880);
  /* #163: output[1][25] = @61 */
  if (res[1]) casadi_copy(w61, 120, res[1]+3000);
  /* #164: output[1][26] = @63 */
  if (res[1]) casadi_copy(w63, 120, res[1]+3120);
  /* #165: output[1][27] = @65 */
  if (res[1]) casadi_copy(w65, 120, res[1]+3240);
  /* #166: output[1][28] = @67 */
  if (res[1]) casadi_copy(w67, 120, res[1]+3360);
  /* #167: output[1][29] = @69 */
  if (res[1]) casadi_copy(w69, 120, res[1]+3480);
  /* #168: output[1][30] = @71 */
  if (res[1]) casadi_copy(w71, 120, res[1]+3600);
  /* #169: output[1][31] = @73 */
  if (res[1]) casadi_copy(w73, 120, res[1]+3720);
  /* #170: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #171: {@75, @76} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=wr04;
  res1[0]=w75;
  res1[1]=w76;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #172: output[1][32] = @75 */
  if (res[1]) casadi_copy(w75, 10, res[1]+3840);
  /* #173: output[2][0] = @12 */
  casadi_copy(w12, 120, res[2]);
  /* #174: output[2][1] = @14 */
  if (res[2]) casadi_copy(w14, 120, res[2]+120);
  /* #175: output[2][2] = @16 */
  if (res[2]) casadi_copy(w16, 120, res[2]+240);
  /* #176: output[2][3] = @18 */
  if (res[2]) casadi_copy(w18, 120, res[2]+360);
  /* #177: output[2][4] = @20 */
  if (res[2]) casadi_copy(w20, 120, res[2]+480);
  /* #178: output[2][5] = @22 */
  if (res[2]) casadi_copy(w22, 120, res[2]+600);
  /* #179: output[2][6] = @24 */
  if (res[2]) casadi_copy(w24, 120, res[2]+720);
  /* #180: output[2][7] = @26 */
  if (res[2]) casadi_copy(w26, 120, res[2]+840);
  /* #181: output[2][8] = @28 */
  if (res[2]) casadi_copy(w28, 120, res[2]+960);
  /* #182: output[2][9] = @30 */
  if (res[2]) casadi_copy(w30, 120, res[2]+1080);
  /* #183: output[2][10] = @32 */
  if (res[2]) casadi_copy(w32, 120, res[2]+1200);
  /* #184: output[2][11] = @34 */
  if (res[2]) casadi_copy(w34, 120, res[2]+1320);
  /* #185: output[2][12] = @36 */
  if (res[2]) casadi_copy(w36, 120, res[2]+1440);
  /* #186: output[2][13] = @38 */
  if (res[2]) casadi_copy(w38, 120, res[2]+1560);
  /* #187: output[2][14] = @40 */
  if (res[2]) casadi_copy(w40, 120, res[2]+1680);
  /* #188: output[2][15] = @42 */
  if (res[2]) casadi_copy(w42, 120, res[2]+1800);
  /* #189: output[2][16] = @44 */
  if (res[2]) casadi_copy(w44, 120, res[2]+1920);
  /* #190: output[2][17] = @46 */
  if (res[2]) casadi_copy(w46, 120, res[2]+2040);
  /* #191: output[2][18] = @48 */
  if (res[2]) casadi_copy(w48, 120, res[2]+2160);
  /* #192: output[2][19] = @50 */
  if (res[2]) casadi_copy(w50, 120, res[2]+2280);
  /* #193: output[2][20] = @52 */
  if (res[2]) casadi_copy(w52, 120, res[2]+2400);
  /* #194: output[2][21] = @54 */
  if (res[2]) casadi_copy(w54, 120, res[2]+2520);
  /* #195: output[2][22] = @56 */
  if (res[2]) casadi_copy(w56, 120, res[2]+2640);
  /* #196: output[2][23] = @58 */
  if (res[2]) casadi_copy(w58, 120, res[2]+2760);
  /* #197: output[2][24] = @60 */
  if (res[2]) casadi_copy(w60, 120, res[2]+2880);
  /* #198: output[2][25] = @62 */
  if (res[2]) casadi_copy(w62, 120, res[2]+3000);
  /* #199: output[2][26] = @64 */
  if (res[2]) casadi_copy(w64, 120, res[2]+3120);
  /* #200: output[2][27] = @66 */
  if (res[2]) casadi_copy(w66, 120, res[2]+3240);
  /* #201: output[2][28] = @68 */
  if (res[2]) casadi_copy(w68, 120, res[2]+3360);
  /* #202: output[2][29] = @70 */
  if (res[2]) casadi_copy(w70, 120, res[2]+3480);
  /* #203: output[2][30] = @72 */
  if (res[2]) casadi_copy(w72, 120, res[2]+3600);
  /* #204: output[2][31] = @74 */
  if (res[2]) casadi_copy(w74, 120, res[2]+3720);
  /* #205: output[2][32] = @76 */
  if (res[2]) casadi_copy(w76, 10, res[2]+3840);
  /* #206: @1 = @8[:6] */
  for (rr=w01, cs=w08+0; cs!=w08+6; cs+=1) *rr++ = *cs;
  /* #207: @77 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=wr04;
  res1[0]=w77;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #208: output[3][0] = @77 */
  casadi_copy(w77, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s19;
    case 1: return casadi_s20;
    case 2: return casadi_s20;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 8219;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8219*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_576:(u[6],p[8])->(w[7x577],g[10x577],dg[10x577],R[6]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+380, w002, w003, *w005=w+386, *w006=w+410, w007, *w008=w+415, *w009=w+422, *w010=w+429;
  casadi_real *w011=w+513, *w012=w+633, *w013=w+753, *w014=w+873, *w015=w+993, *w016=w+1113, *w017=w+1233, *w018=w+1353, *w019=w+1473, *w020=w+1593, *w021=w+1713, *w022=w+1833;
  casadi_real *w023=w+1953, *w024=w+2073, *w025=w+2193, *w026=w+2313, *w027=w+2433, *w028=w+2553, *w029=w+2673, *w030=w+2793, *w031=w+2913, *w032=w+3033, *w033=w+3153, *w034=w+3273;
  casadi_real *w035=w+3393, *w036=w+3513, *w037=w+3633, *w038=w+3753, *w039=w+3873, *w040=w+3993, *w041=w+4113, *w042=w+4233, *w043=w+4353, *w044=w+4473, *w045=w+4593, *w046=w+4713;
  casadi_real *w047=w+4833, *w048=w+4953, *w049=w+5073, *w050=w+5193, *w051=w+5313, *w052=w+5433, *w053=w+5553, *w054=w+5673, *w055=w+5793, *w056=w+5913, *w057=w+6033, *w058=w+6153;
  casadi_real *w059=w+6273, *w060=w+6393, *w061=w+6513, *w062=w+6633, *w063=w+6753, *w064=w+6873, *w065=w+6993, *w066=w+7113, *w067=w+7233, *w068=w+7353, *w069=w+7473, *w070=w+7593;
  casadi_real *w071=w+7713, *w072=w+7833, *w073=w+7953, *w074=w+8073, *w075=w+8193, *w076=w+8313, *w077=w+8433, *w078=w+8553, *w079=w+8673, *w080=w+8793, *w081=w+8913, *w082=w+9033;
  casadi_real *w083=w+9153, *w084=w+9273, *w085=w+9393, *w086=w+9513, *w087=w+9633, *w088=w+9753, *w089=w+9873, *w090=w+9993, *w091=w+10113, *w092=w+10233, *w093=w+10353, *w094=w+10473;
  casadi_real *w095=w+10593, *w096=w+10713, *w097=w+10833, *w098=w+10953, *w099=w+11073, *w100=w+11193, *w101=w+11313, *w102=w+11433, *w103=w+11553, *w104=w+11673, *w105=w+11793, *w106=w+11913;
  casadi_real *w107=w+12033, *w108=w+12043, *w109=w+12053;
  const casadi_real **arg1=arg+2, *cs, *wr004;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w001);
  /* #2: @2 = @1[5] */
  for (rr=(&w002), cs=w001+5; cs!=w001+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 576 */
  w003 = 576.;
  /* #4: @3 = (@2/@3) */
  w003  = (w002/w003);
  /* #5: @4 = input[1][0] */
  wr004 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=wr004;
  res1[0]=w005;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w006, cs=w001+0; cs!=w001+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=wr004;
  res1[0]=w001;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w007 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w008;
  for (i=0, cs=w001; i<6; ++i) *rr++ = *cs++;
  *rr++ = w007;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w011;
  res1[3]=w012;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w010, 84, res[0]);
  /* #13: @0 = 0.0208333 */
  w000 = 2.0833333333333332e-02;
  /* #14: @0 = (@0*@2) */
  w000 *= w002;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w013;
  res1[3]=w014;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+84);
  /* #17: @0 = 0.0416667 */
  w000 = 4.1666666666666664e-02;
  /* #18: @0 = (@0*@2) */
  w000 *= w002;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w015;
  res1[3]=w016;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+168);
  /* #21: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #22: @0 = (@0*@2) */
  w000 *= w002;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w017;
  res1[3]=w018;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+252);
  /* #25: @0 = 0.0833333 */
  w000 = 8.3333333333333329e-02;
  /* #26: @0 = (@0*@2) */
  w000 *= w002;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w019;
  res1[3]=w020;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+336);
  /* #29: @0 = 0.104167 */
  w000 = 1.0416666666666667e-01;
  /* #30: @0 = (@0*@2) */
  w000 *= w002;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w021;
  res1[3]=w022;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+420);
  /* #33: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w000 *= w002;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w023;
  res1[3]=w024;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+504);
  /* #37: @0 = 0.145833 */
  w000 = 1.4583333333333334e-01;
  /* #38: @0 = (@0*@2) */
  w000 *= w002;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w025;
  res1[3]=w026;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+588);
  /* #41: @0 = 0.166667 */
  w000 = 1.6666666666666666e-01;
  /* #42: @0 = (@0*@2) */
  w000 *= w002;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w027;
  res1[3]=w028;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+672);
  /* #45: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w000 *= w002;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w029;
  res1[3]=w030;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+756);
  /* #49: @0 = 0.208333 */
  w000 = 2.0833333333333334e-01;
  /* #50: @0 = (@0*@2) */
  w000 *= w002;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w031;
  res1[3]=w032;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+840);
  /* #53: @0 = 0.229167 */
  w000 = 2.2916666666666666e-01;
  /* #54: @0 = (@0*@2) */
  w000 *= w002;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w033;
  res1[3]=w034;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+924);
  /* #57: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w000 *= w002;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w035;
  res1[3]=w036;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1008);
  /* #61: @0 = 0.270833 */
  w000 = 2.7083333333333331e-01;
  /* #62: @0 = (@0*@2) */
  w000 *= w002;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w037;
  res1[3]=w038;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1092);
  /* #65: @0 = 0.291667 */
  w000 = 2.9166666666666669e-01;
  /* #66: @0 = (@0*@2) */
  w000 *= w002;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w039;
  res1[3]=w040;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1176);
  /* #69: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w000 *= w002;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w041;
  res1[3]=w042;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1260);
  /* #73: @0 = 0.333333 */
  w000 = 3.3333333333333331e-01;
  /* #74: @0 = (@0*@2) */
  w000 *= w002;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w043;
  res1[3]=w044;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1344);
  /* #77: @0 = 0.354167 */
  w000 = 3.5416666666666669e-01;
  /* #78: @0 = (@0*@2) */
  w000 *= w002;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w045;
  res1[3]=w046;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1428);
  /* #81: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w000 *= w002;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w047;
  res1[3]=w048;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1512);
  /* #85: @0 = 0.395833 */
  w000 = 3.9583333333333331e-01;
  /* #86: @0 = (@0*@2) */
  w000 *= w002;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w049;
  res1[3]=w050;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1596);
  /* #89: @0 = 0.416667 */
  w000 = 4.1666666666666669e-01;
  /* #90: @0 = (@0*@2) */
  w000 *= w002;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w051;
  res1[3]=w052;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1680);
  /* #93: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #94: @0 = (@0*@2) */
  w000 *= w002;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w053;
  res1[3]=w054;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1764);
  /* #97: @0 = 0.458333 */
  w000 = 4.5833333333333331e-01;
  /* #98: @0 = (@0*@2) */
  w000 *= w002;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w055;
  res1[3]=w056;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1848);
  /* #101: @0 = 0.479167 */
  w000 = 4.7916666666666669e-01;
  /* #102: @0 = (@0*@2) */
  w000 *= w002;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w057;
  res1[3]=w058;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1932);
  /* #105: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #106: @0 = (@0*@2) */
  w000 *= w002;
  /* #107: {@9, @10, @59, @60} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w059;
  res1[3]=w060;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[0][24] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2016);
  /* #109: @0 = 0.520833 */
  w000 = 5.2083333333333337e-01;
  /* #110: @0 = (@0*@2) */
  w000 *= w002;
  /* #111: {@8, @10, @61, @62} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w061;
  res1[3]=w062;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[0][25] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2100);
  /* #113: @0 = 0.541667 */
  w000 = 5.4166666666666663e-01;
  /* #114: @0 = (@0*@2) */
  w000 *= w002;
  /* #115: {@9, @10, @63, @64} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w063;
  res1[3]=w064;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #116: output[0][26] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2184);
  /* #117: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #118: @0 = (@0*@2) */
  w000 *= w002;
  /* #119: {@8, @10, @65, @66} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w065;
  res1[3]=w066;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[0][27] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2268);
  /* #121: @0 = 0.583333 */
  w000 = 5.8333333333333337e-01;
  /* #122: @0 = (@0*@2) */
  w000 *= w002;
  /* #123: {@9, @10, @67, @68} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w067;
  res1[3]=w068;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[0][28] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2352);
  /* #125: @0 = 0.604167 */
  w000 = 6.0416666666666663e-01;
  /* #126: @0 = (@0*@2) */
  w000 *= w002;
  /* #127: {@8, @10, @69, @70} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w069;
  res1[3]=w070;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #128: output[0][29] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2436);
  /* #129: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #130: @0 = (@0*@2) */
  w000 *= w002;
  /* #131: {@9, @10, @71, @72} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w071;
  res1[3]=w072;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[0][30] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2520);
  /* #133: @0 = 0.645833 */
  w000 = 6.4583333333333337e-01;
  /* #134: @0 = (@0*@2) */
  w000 *= w002;
  /* #135: {@8, @10, @73, @74} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w073;
  res1[3]=w074;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #136: output[0][31] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2604);
  /* #137: @0 = 0.666667 */
  w000 = 6.6666666666666663e-01;
  /* #138: @0 = (@0*@2) */
  w000 *= w002;
  /* #139: {@9, @10, @75, @76} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w075;
  res1[3]=w076;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #140: output[0][32] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2688);
  /* #141: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #142: @0 = (@0*@2) */
  w000 *= w002;
  /* #143: {@8, @10, @77, @78} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w077;
  res1[3]=w078;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #144: output[0][33] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2772);
  /* #145: @0 = 0.708333 */
  w000 = 7.0833333333333337e-01;
  /* #146: @0 = (@0*@2) */
  w000 *= w002;
  /* #147: {@9, @10, @79, @80} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w079;
  res1[3]=w080;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #148: output[0][34] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2856);
  /* #149: @0 = 0.729167 */
  w000 = 7.2916666666666663e-01;
  /* #150: @0 = (@0*@2) */
  w000 *= w002;
  /* #151: {@8, @10, @81, @82} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w081;
  res1[3]=w082;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #152: output[0][35] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2940);
  /* #153: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #154: @0 = (@0*@2) */
  w000 *= w002;
  /* #155: {@9, @10, @83, @84} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w083;
  res1[3]=w084;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[0][36] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3024);
  /* #157: @0 = 0.770833 */
  w000 = 7.7083333333333337e-01;
  /* #158: @0 = (@0*@2) */
  w000 *= w002;
  /* #159: {@8, @10, @85, @86} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w085;
  res1[3]=w086;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #160: output[0][37] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3108);
  /* #161: @0 = 0.791667 */
  w000 = 7.9166666666666663e-01;
  /* #162: @0 = (@0*@2) */
  w000 *= w002;
  /* #163: {@9, @10, @87, @88} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w087;
  res1[3]=w088;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #164: output[0][38] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3192);
  /* #165: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #166: @0 = (@0*@2) */
  w000 *= w002;
  /* #167: {@8, @10, @89, @90} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w089;
  res1[3]=w090;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #168: output[0][39] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3276);
  /* #169: @0 = 0.833333 */
  w000 = 8.3333333333333337e-01;
  /* #170: @0 = (@0*@2) */
  w000 *= w002;
  /* #171: {@9, @10, @91, @92} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w091;
  res1[3]=w092;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #172: output[0][40] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3360);
  /* #173: @0 = 0.854167 */
  w000 = 8.5416666666666663e-01;
  /* #174: @0 = (@0*@2) */
  w000 *= w002;
  /* #175: {@8, @10, @93, @94} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w093;
  res1[3]=w094;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #176: output[0][41] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3444);
  /* #177: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #178: @0 = (@0*@2) */
  w000 *= w002;
  /* #179: {@9, @10, @95, @96} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w095;
  res1[3]=w096;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #180: output[0][42] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3528);
  /* #181: @0 = 0.895833 */
  w000 = 8.9583333333333337e-01;
  /* #182: @0 = (@0*@2) */
  w000 *= w002;
  /* #183: {@8, @10, @97, @98} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w097;
  res1[3]=w098;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #184: output[0][43] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3612);
  /* #185: @0 = 0.916667 */
  w000 = 9.1666666666666663e-01;
  /* #186: @0 = (@0*@2) */
  w000 *= w002;
  /* #187: {@9, @10, @99, @100} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w099;
  res1[3]=w100;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #188: output[0][44] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3696);
  /* #189: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #190: @0 = (@0*@2) */
  w000 *= w002;
  /* #191: {@8, @10, @101, @102} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w101;
  res1[3]=w102;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #192: output[0][45] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3780);
  /* #193: @0 = 0.958333 */
  w000 = 9.5833333333333337e-01;
  /* #194: @0 = (@0*@2) */
  w000 *= w002;
  /* #195: {@9, @10, @103, @104} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w103;
  res1[3]=w104;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #196: output[0][46] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3864);
  /* #197: @0 = 0.979167 */
  w000 = 9.7916666666666663e-01;
  /* #198: @0 = (@0*@2) */
  w000 *= w002;
  /* #199: {@8, @10, @105, @106} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w105;
  res1[3]=w106;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #200: output[0][47] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3948);
  /* #201: output[0][48] = @8 */
  if (res[0]) casadi_copy(w008, 7, res[0]+4032);
  /* #202: output[1][0] = @11 */
  casadi_copy(w011, 120, res[1]);
  /* #203: output[1][1] = @13 */
  if (res[1]) casadi_copy(w013, 120, res[1]+120);
  /* #204: output[1][2] = @15 */
  if (res[1]) casadi_copy(w015, 120, res[1]+240);
  /* #205: output[1][3] = @17 */
  if (res[1]) casadi_copy(w017, 120, res[1]+360);
  /* #206: output[1][4] = @19 */
  if (res[1]) casadi_copy(w019, 120, res[1]+480);
  /* #207: output[1][5] = @21 */
  if (res[1]) casadi_copy(w021, 120, res[1]+600);
  /* #208: output[1][6] = @23 */
  if (res[1]) casadi_copy(w023, 120, res[1]+720);
  /* #209: output[1][7] = @25 */
  if (res[1]) casadi_copy(w025, 120, res[1]+840);
  /* #210: output[1][8] = @27 */
  if (res[1]) casadi_copy(w027, 120, res[1]+960);
  /* #211: output[1][9] = @29 */
  if (res[1]) casadi_copy(w029, 120, res[1]+1080);
  /* #212: output[1][10] = @31 */
  if (res[1]) casadi_copy(w031, 120, res[1]+1200);
  /* #213: output[1][11] = @33 */
  if (res[1]) casadi_copy(w033, 120, res[1]+1320);
  /* #214: output[1][12] = @35 */
  if (res[1]) casadi_copy(w035, 120, res[1]+1440);
  /* #215: output[1][13] = @37 */
  if (res[1]) casadi_copy(w037, 120, res[1]+1560);
  /* #216: output[1][14] = @39 */
  if (res[1]) casadi_copy(w039, 120, res[1]+1680);
  /* #217: output[1][15] = @41 */
  if (res[1]) casadi_copy(w041, 120, res[1]+1800);
  /* #218: output[1][16] = @43 */
  if (res[1]) casadi_copy(w043, 120, res[1]+1920);
  /* #219: output[1][17] = @45 */
  if (res[1]) casadi_copy(w045, 120, res[1]+2040);
  /* #220: output[1][18] = @47 */
  if (res[1]) casadi_copy(w047, 120, res[1]+2160);
  /* #221: output[1][19] = @49 */
  if (res[1]) casadi_copy(w049, 120, res[1]+2280);
  /* #222: output[1][20] = @51 */
  if (res[1]) casadi_copy(w051, 120, res[1]+2400);
  /* #223: output[1][21] = @53 */
  if (res[1]) casadi_copy(w053, 120, res[1]+2520);
  /* #224: output[1][22] = @55 */
  if (res[1]) casadi_copy(w055, 120, res[1]+2640);
  /* #225: output[1][23] = @57 */
  if (res[1]) casadi_copy(w057, 120, res[1]+2760);
  /* #226: output[1][24] = @59 */
  if (res[1]) casadi_copy(w059, 120, res[1]+2880);
  /* #227: output[1][25] = @61 */
  if (res[1]) casadi_copy(w061, 120, res[1]+3000);
  /* #228: output[1][26] = @63 */
  if (res[1]) casadi_copy(w063, 120, res[1]+3120);
  /* #229: output[1][27] = @65 */
  if (res[1]) casadi_copy(w065, 120, res[1]+3240);
  /* #230: output[1][28] = @67 */
  if (res[1]) casadi_copy(w067, 120, res[1]+3360);
  /* #231: output[1][29] = @69 */
  if (res[1]) casadi_copy(w069, 120, res[1]+3480);
  /* #232: output[1][30] = @71 */
  if (res[1]) casadi_copy(w071, 120, res[1]+3600);
  /* #233: output[1][31] = @73 */
  if (res[1]) casadi_copy(w073, 120, res[1]+3720);
  /* #234: output[1][32] = @75 */
  if (res[1]) casadi_copy(w075, 120, res[1]+3840);
  /* #235: output[1][33] = @77 */
  if (res[1]) casadi_copy(w077, 120, res[1]+3960);
  /* #236: output[1][34] = @79 */
  if (res[1]) casadi_copy(w079, 120, res[1]+4080);
  /* #237: output[1][35] = @81 */
  if (res[1]) casadi_copy(w081, 120, res[1]+4200);
  /* #238: output[1][36] = @83 */
  if (res[1]) casadi_copy(w083, 120, res[1]+4320);
  /* #239: output[1][37] = @85 */
  if (res[1]) casadi_copy(w085, 120, res[1]+4440);
  /* #240: output[1][38] = @87 */
  if (res[1]) casadi_copy(w087, 120, res[1]+4560);
  /* #241: output[1][39] = @89 */
  if (res[1]) casadi_copy(w089, 120, res[1]+4680);
  /* #242: output[1][40] = @91 */
  if (res[1]) casadi_copy(w091, 120, res[1]+4800);
  /* #243: output[1][41] = @93 */
  if (res[1]) casadi_copy(w093, 120, res[1]+4920);
  /* #244: output[1][42] = @95 */
  if (res[1]) casadi_copy(w095, 120, res[1]+5040);
  /* #245: output[1][43] = @97 */
  if (res[1]) casadi_copy(w097, 120, res[1]+5160);
  /* #246: output[1][44] = @99 */
  if (res[1]) casadi_copy(w099, 120, res[1]+5280);
  /* #247: output[1][45] = @101 */
  if (res[1]) casadi_copy(w101, 120, res[1]+5400);
  /* #248: output[1][46] = @103 */
  if (res[1]) casadi_copy(w103, 120, res[1]+5520);
  /* #249: output[1][47] = @105 */
  if (res[1]) casadi_copy(w105, 120, res[1]+5640);
  /* #250: @1 = @8[:6] */
  for (rr=w001, cs=w008+0; cs!=w008+6; cs+=1) *rr++ = *cs;
  /* #251: {@107, @108} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=wr004;
  res1[0]=w107;
  res1[1]=w108;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #252: output[1][48] = @107 */
  if (res[1]) casadi_copy(w107, 10, res[1]+5760);
  /* #253: output[2][0] = @12 */
  casadi_copy(w012, 120, res[2]);
  /* #254: output[2][1] = @14 */
  if (res[2]) casadi_copy(w014, 120, res[2]+120);
  /* #255: output[2][2] = @16 */
  if (res[2]) casadi_copy(w016, 120, res[2]+240);
  /* #256: output[2][3] = @18 */
  if (res[2]) casadi_copy(w018, 120, res[2]+360);
  /* #257: output[2][4] = @20 */
  if (res[2]) casadi_copy(w020, 120, res[2]+480);
  /* #258: output[2][5] = @22 */
  if (res[2]) casadi_copy(w022, 120, res[2]+600);
  /* #259: output[2][6] = @24 */
  if (res[2]) casadi_copy(w024, 120, res[2]+720);
  /* #260: output[2][7] = @26 */
  if (res[2]) casadi_copy(w026, 120, res[2]+840);
  /* #261: output[2][8] = @28 */
  if (res[2]) casadi_copy(w028, 120, res[2]+960);
  /* #262: output[2][9] = @30 */
  if (res[2]) casadi_copy(w030, 120, res[2]+1080);
  /* #263: output[2][10] = @32 */
  if (res[2]) casadi_copy(w032, 120, res[2]+1200);
  /* #264: output[2][11] = @34 */
  if (res[2]) casadi_copy(w034, 120, res[2]+1320);
  /* #265: output[2][12] = @36 */
  if (res[2]) casadi_copy(w036, 120, res[2]+1440);
  /* #266: output[2][13] = @38 */
  if (res[2]) casadi_copy(w038, 120, res[2]+1560);
  /* #267: output[2][14] = @40 */
  if (res[2]) casadi_copy(w040, 120, res[2]+1680);
  /* #268: output[2][15] = @42 */
  if (res[2]) casadi_copy(w042, 120, res[2]+1800);
  /* #269: output[2][16] = @44 */
  if (res[2]) casadi_copy(w044, 120, res[2]+1920);
  /* #270: output[2][17] = @46 */
  if (res[2]) casadi_copy(w046, 120, res[2]+2040);
  /* #271: output[2][18] = @48 */
  if (res[2]) casadi_copy(w048, 120, res[2]+2160);
  /* #272: output[2][19] = @50 */
  if (res[2]) casadi_copy(w050, 120, res[2]+2280);
  /* #273: output[2][20] = @52 */
  if (res[2]) casadi_copy(w052, 120, res[2]+2400);
  /* #274: output[2][21] = @54 */
  if (res[2]) casadi_copy(w054, 120, res[2]+2520);
  /* #275: output[2][22] = @56 */
  if (res[2]) casadi_copy(w056, 120, res[2]+2640);
  /* #276: output[2][23] = @58 */
  if (res[2]) casadi_copy(w058, 120, res[2]+2760);
  /* #277: output[2][24] = @60 */
  if (res[2]) casadi_copy(w060, 120, res[2]+2880);
  /* #278: output[2][25] = @62 */
  if (res[2]) casadi_copy(w062, 120, res[2]+3000);
  /* #279: output[2][26] = @64 */
  if (res[2]) casadi_copy(w064, 120, res[2]+3120);
  /* #280: output[2][27] = @66 */
  if (res[2]) casadi_copy(w066, 120, res[2]+3240);
  /* #281: output[2][28] = @68 */
  if (res[2]) casadi_copy(w068, 120, res[2]+3360);
  /* #282: output[2][29] = @70 */
  if (res[2]) casadi_copy(w070, 120, res[2]+3480);
  /* #283: output[2][30] = @72 */
  if (res[2]) casadi_copy(w072, 120, res[2]+3600);
  /* #284: output[2][31] = @74 */
  if (res[2]) casadi_copy(w074, 120, res[2]+3720);
  /* #285: output[2][32] = @76 */
  if (res[2]) casadi_copy(w076, 120, res[2]+3840);
  /* #286: output[2][33] = @78 */
  if (res[2]) casadi_copy(w078, 120, res[2]+3960);
  /* #287: output[2][34] = @80 */
  if (res[2]) casadi_copy(w080, 120, res[2]+4080);
  /* #288: output[2][35] = @82 */
  if (res[2]) casadi_copy(w082, 120, res[2]+4200);
  /* #289: output[2][36] = @84 */
  if (res[2]) casadi_copy(w084, 120, res[2]+4320);
  /* #290: output[2][37] = @86 */
  if (res[2]) casadi_copy(w086, 120, res[2]+4440);
  /* #291: output[2][38] = @88 */
  if (res[2]) casadi_copy(w088, 120, res[2]+4560);
  /* #292: output[2][39] = @90 */
  if (res[2]) casadi_copy(w090, 120, res[2]+4680);
  /* #293: output[2][40] = @92 */
  if (res[2]) casadi_copy(w092, 120, res[2]+4800);
  /* #294: output[2][41] = @94 */
  if (res[2]) casadi_copy(w094, 120, res[2]+4920);
  /* #295: output[2][42] = @96 */
  if (res[2]) casadi_copy(w096, 120, res[2]+5040);
  /* #296: output[2][43] = @98 */
  if (res[2]) casadi_copy(w098, 120, res[2]+5160);
  /* #297: output[2][44] = @100 */
  if (res[2]) casadi_copy(w100, 120, res[2]+5280);
  /* #298: output[2][45] = @102 */
  if (res[2]) casadi_copy(w102, 120, res[2]+5400);
  /* #299: output[2][46] = @104 */
  if (res[2]) casadi_copy(w104, 120, res[2]+5520);
  /* #300: output[2][47] = @106 */
  if (res[2]) casadi_copy(w106, 120, res[2]+5640);
  /* #301: output[2][48] = @108 */
  if (res[2]) casadi_copy(w108, 10, res[2]+5760);
  /* #302: @1 = @8[:6] */
  for (rr=w001, cs=w008+0; cs!=w008+6; cs+=1) *rr++ = *cs;
  /* #303: @109 = landing(@1, @6, @4) */
  arg1[0]=w001;
  arg1[1]=w006;
  arg1[2]=wr004;
  res1[0]=w109;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #304: output[3][0] = @109 */
  casadi_copy(w109, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_576_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_576_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_576_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_576_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_576_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_576_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_576_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_576_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_576_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_576_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_576_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s21;
    case 1: return casadi_s22;
    case 2: return casadi_s22;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_576_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12059;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12059*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_768:(u[6],p[8])->(w[7x769],g[10x769],dg[10x769],R[6]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+380, w002, w003, *w005=w+386, *w006=w+410, w007, *w008=w+415, *w009=w+422, *w010=w+429;
  casadi_real *w011=w+513, *w012=w+633, *w013=w+753, *w014=w+873, *w015=w+993, *w016=w+1113, *w017=w+1233, *w018=w+1353, *w019=w+1473, *w020=w+1593, *w021=w+1713, *w022=w+1833;
  casadi_real *w023=w+1953, *w024=w+2073, *w025=w+2193, *w026=w+2313, *w027=w+2433, *w028=w+2553, *w029=w+2673, *w030=w+2793, *w031=w+2913, *w032=w+3033, *w033=w+3153, *w034=w+3273;
  casadi_real *w035=w+3393, *w036=w+3513, *w037=w+3633, *w038=w+3753, *w039=w+3873, *w040=w+3993, *w041=w+4113, *w042=w+4233, *w043=w+4353, *w044=w+4473, *w045=w+4593, *w046=w+4713;
  casadi_real *w047=w+4833, *w048=w+4953, *w049=w+5073, *w050=w+5193, *w051=w+5313, *w052=w+5433, *w053=w+5553, *w054=w+5673, *w055=w+5793, *w056=w+5913, *w057=w+6033, *w058=w+6153;
  casadi_real *w059=w+6273, *w060=w+6393, *w061=w+6513, *w062=w+6633, *w063=w+6753, *w064=w+6873, *w065=w+6993, *w066=w+7113, *w067=w+7233, *w068=w+7353, *w069=w+7473, *w070=w+7593;
  casadi_real *w071=w+7713, *w072=w+7833, *w073=w+7953, *w074=w+8073, *w075=w+8193, *w076=w+8313, *w077=w+8433, *w078=w+8553, *w079=w+8673, *w080=w+8793, *w081=w+8913, *w082=w+9033;
  casadi_real *w083=w+9153, *w084=w+9273, *w085=w+9393, *w086=w+9513, *w087=w+9633, *w088=w+9753, *w089=w+9873, *w090=w+9993, *w091=w+10113, *w092=w+10233, *w093=w+10353, *w094=w+10473;
  casadi_real *w095=w+10593, *w096=w+10713, *w097=w+10833, *w098=w+10953, *w099=w+11073, *w100=w+11193, *w101=w+11313, *w102=w+11433, *w103=w+11553, *w104=w+11673, *w105=w+11793, *w106=w+11913;
  casadi_real *w107=w+12033, *w108=w+12153, *w109=w+12273, *w110=w+12393, *w111=w+12513, *w112=w+12633, *w113=w+12753, *w114=w+12873, *w115=w+12993, *w116=w+13113, *w117=w+13233, *w118=w+13353;
  casadi_real *w119=w+13473, *w120=w+13593, *w121=w+13713, *w122=w+13833, *w123=w+13953, *w124=w+14073, *w125=w+14193, *w126=w+14313, *w127=w+14433, *w128=w+14553, *w129=w+14673, *w130=w+14793;
  casadi_real *w131=w+14913, *w132=w+15033, *w133=w+15153, *w134=w+15273, *w135=w+15393, *w136=w+15513, *w137=w+15633, *w138=w+15753, *w139=w+15873, *w140=w+15883, *w141=w+15893;
  const casadi_real **arg1=arg+2, *cs, *wr004;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w001);
  /* #2: @2 = @1[5] */
  for (rr=(&w002), cs=w001+5; cs!=w001+6; cs+=1) *rr++ = *cs;
  /* #3: @3 = 768 */
  w003 = 768.;
  /* #4: @3 = (@2/@3) */
  w003  = (w002/w003);
  /* #5: @4 = input[1][0] */
  wr004 = arg[1] ? arg[1] : casadi_zeros;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=wr004;
  res1[0]=w005;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:5] */
  for (rr=w006, cs=w001+0; cs!=w001+5; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=wr004;
  res1[0]=w001;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w007 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w008;
  for (i=0, cs=w001; i<6; ++i) *rr++ = *cs++;
  *rr++ = w007;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w011;
  res1[3]=w012;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w010, 84, res[0]);
  /* #13: @0 = 0.015625 */
  w000 = 1.5625000000000000e-02;
  /* #14: @0 = (@0*@2) */
  w000 *= w002;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w013;
  res1[3]=w014;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+84);
  /* #17: @0 = 0.03125 */
  w000 = 3.1250000000000000e-02;
  /* #18: @0 = (@0*@2) */
  w000 *= w002;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w015;
  res1[3]=w016;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+168);
  /* #21: @0 = 0.046875 */
  w000 = 4.6875000000000000e-02;
  /* #22: @0 = (@0*@2) */
  w000 *= w002;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w017;
  res1[3]=w018;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+252);
  /* #25: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #26: @0 = (@0*@2) */
  w000 *= w002;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w019;
  res1[3]=w020;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+336);
  /* #29: @0 = 0.078125 */
  w000 = 7.8125000000000000e-02;
  /* #30: @0 = (@0*@2) */
  w000 *= w002;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w021;
  res1[3]=w022;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+420);
  /* #33: @0 = 0.09375 */
  w000 = 9.3750000000000000e-02;
  /* #34: @0 = (@0*@2) */
  w000 *= w002;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w023;
  res1[3]=w024;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+504);
  /* #37: @0 = 0.109375 */
  w000 = 1.0937500000000000e-01;
  /* #38: @0 = (@0*@2) */
  w000 *= w002;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w025;
  res1[3]=w026;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+588);
  /* #41: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #42: @0 = (@0*@2) */
  w000 *= w002;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w027;
  res1[3]=w028;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+672);
  /* #45: @0 = 0.140625 */
  w000 = 1.4062500000000000e-01;
  /* #46: @0 = (@0*@2) */
  w000 *= w002;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w029;
  res1[3]=w030;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+756);
  /* #49: @0 = 0.15625 */
  w000 = 1.5625000000000000e-01;
  /* #50: @0 = (@0*@2) */
  w000 *= w002;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w031;
  res1[3]=w032;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+840);
  /* #53: @0 = 0.171875 */
  w000 = 1.7187500000000000e-01;
  /* #54: @0 = (@0*@2) */
  w000 *= w002;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w033;
  res1[3]=w034;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+924);
  /* #57: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w000 *= w002;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w035;
  res1[3]=w036;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1008);
  /* #61: @0 = 0.203125 */
  w000 = 2.0312500000000000e-01;
  /* #62: @0 = (@0*@2) */
  w000 *= w002;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w037;
  res1[3]=w038;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1092);
  /* #65: @0 = 0.21875 */
  w000 = 2.1875000000000000e-01;
  /* #66: @0 = (@0*@2) */
  w000 *= w002;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w039;
  res1[3]=w040;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1176);
  /* #69: @0 = 0.234375 */
  w000 = 2.3437500000000000e-01;
  /* #70: @0 = (@0*@2) */
  w000 *= w002;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w041;
  res1[3]=w042;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1260);
  /* #73: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #74: @0 = (@0*@2) */
  w000 *= w002;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w043;
  res1[3]=w044;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1344);
  /* #77: @0 = 0.265625 */
  w000 = 2.6562500000000000e-01;
  /* #78: @0 = (@0*@2) */
  w000 *= w002;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w045;
  res1[3]=w046;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1428);
  /* #81: @0 = 0.28125 */
  w000 = 2.8125000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w000 *= w002;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w047;
  res1[3]=w048;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1512);
  /* #85: @0 = 0.296875 */
  w000 = 2.9687500000000000e-01;
  /* #86: @0 = (@0*@2) */
  w000 *= w002;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w049;
  res1[3]=w050;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1596);
  /* #89: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #90: @0 = (@0*@2) */
  w000 *= w002;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w051;
  res1[3]=w052;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1680);
  /* #93: @0 = 0.328125 */
  w000 = 3.2812500000000000e-01;
  /* #94: @0 = (@0*@2) */
  w000 *= w002;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w053;
  res1[3]=w054;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1764);
  /* #97: @0 = 0.34375 */
  w000 = 3.4375000000000000e-01;
  /* #98: @0 = (@0*@2) */
  w000 *= w002;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w055;
  res1[3]=w056;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1848);
  /* #101: @0 = 0.359375 */
  w000 = 3.5937500000000000e-01;
  /* #102: @0 = (@0*@2) */
  w000 *= w002;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w057;
  res1[3]=w058;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+1932);
  /* #105: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #106: @0 = (@0*@2) */
  w000 *= w002;
  /* #107: {@9, @10, @59, @60} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w059;
  res1[3]=w060;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[0][24] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2016);
  /* #109: @0 = 0.390625 */
  w000 = 3.9062500000000000e-01;
  /* #110: @0 = (@0*@2) */
  w000 *= w002;
  /* #111: {@8, @10, @61, @62} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w061;
  res1[3]=w062;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[0][25] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2100);
  /* #113: @0 = 0.40625 */
  w000 = 4.0625000000000000e-01;
  /* #114: @0 = (@0*@2) */
  w000 *= w002;
  /* #115: {@9, @10, @63, @64} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w063;
  res1[3]=w064;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #116: output[0][26] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2184);
  /* #117: @0 = 0.421875 */
  w000 = 4.2187500000000000e-01;
  /* #118: @0 = (@0*@2) */
  w000 *= w002;
  /* #119: {@8, @10, @65, @66} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w065;
  res1[3]=w066;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[0][27] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2268);
  /* #121: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #122: @0 = (@0*@2) */
  w000 *= w002;
  /* #123: {@9, @10, @67, @68} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w067;
  res1[3]=w068;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[0][28] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2352);
  /* #125: @0 = 0.453125 */
  w000 = 4.5312500000000000e-01;
  /* #126: @0 = (@0*@2) */
  w000 *= w002;
  /* #127: {@8, @10, @69, @70} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w069;
  res1[3]=w070;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #128: output[0][29] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2436);
  /* #129: @0 = 0.46875 */
  w000 = 4.6875000000000000e-01;
  /* #130: @0 = (@0*@2) */
  w000 *= w002;
  /* #131: {@9, @10, @71, @72} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w071;
  res1[3]=w072;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[0][30] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2520);
  /* #133: @0 = 0.484375 */
  w000 = 4.8437500000000000e-01;
  /* #134: @0 = (@0*@2) */
  w000 *= w002;
  /* #135: {@8, @10, @73, @74} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w073;
  res1[3]=w074;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #136: output[0][31] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2604);
  /* #137: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #138: @0 = (@0*@2) */
  w000 *= w002;
  /* #139: {@9, @10, @75, @76} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w075;
  res1[3]=w076;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #140: output[0][32] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2688);
  /* #141: @0 = 0.515625 */
  w000 = 5.1562500000000000e-01;
  /* #142: @0 = (@0*@2) */
  w000 *= w002;
  /* #143: {@8, @10, @77, @78} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w077;
  res1[3]=w078;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #144: output[0][33] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2772);
  /* #145: @0 = 0.53125 */
  w000 = 5.3125000000000000e-01;
  /* #146: @0 = (@0*@2) */
  w000 *= w002;
  /* #147: {@9, @10, @79, @80} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w079;
  res1[3]=w080;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #148: output[0][34] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2856);
  /* #149: @0 = 0.546875 */
  w000 = 5.4687500000000000e-01;
  /* #150: @0 = (@0*@2) */
  w000 *= w002;
  /* #151: {@8, @10, @81, @82} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w081;
  res1[3]=w082;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #152: output[0][35] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+2940);
  /* #153: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #154: @0 = (@0*@2) */
  w000 *= w002;
  /* #155: {@9, @10, @83, @84} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w083;
  res1[3]=w084;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[0][36] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3024);
  /* #157: @0 = 0.578125 */
  w000 = 5.7812500000000000e-01;
  /* #158: @0 = (@0*@2) */
  w000 *= w002;
  /* #159: {@8, @10, @85, @86} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w085;
  res1[3]=w086;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #160: output[0][37] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3108);
  /* #161: @0 = 0.59375 */
  w000 = 5.9375000000000000e-01;
  /* #162: @0 = (@0*@2) */
  w000 *= w002;
  /* #163: {@9, @10, @87, @88} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w087;
  res1[3]=w088;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #164: output[0][38] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3192);
  /* #165: @0 = 0.609375 */
  w000 = 6.0937500000000000e-01;
  /* #166: @0 = (@0*@2) */
  w000 *= w002;
  /* #167: {@8, @10, @89, @90} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w089;
  res1[3]=w090;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #168: output[0][39] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3276);
  /* #169: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #170: @0 = (@0*@2) */
  w000 *= w002;
  /* #171: {@9, @10, @91, @92} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w091;
  res1[3]=w092;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #172: output[0][40] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3360);
  /* #173: @0 = 0.640625 */
  w000 = 6.4062500000000000e-01;
  /* #174: @0 = (@0*@2) */
  w000 *= w002;
  /* #175: {@8, @10, @93, @94} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w093;
  res1[3]=w094;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #176: output[0][41] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3444);
  /* #177: @0 = 0.65625 */
  w000 = 6.5625000000000000e-01;
  /* #178: @0 = (@0*@2) */
  w000 *= w002;
  /* #179: {@9, @10, @95, @96} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w095;
  res1[3]=w096;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #180: output[0][42] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3528);
  /* #181: @0 = 0.671875 */
  w000 = 6.7187500000000000e-01;
  /* #182: @0 = (@0*@2) */
  w000 *= w002;
  /* #183: {@8, @10, @97, @98} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w097;
  res1[3]=w098;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #184: output[0][43] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3612);
  /* #185: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #186: @0 = (@0*@2) */
  w000 *= w002;
  /* #187: {@9, @10, @99, @100} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w099;
  res1[3]=w100;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #188: output[0][44] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3696);
  /* #189: @0 = 0.703125 */
  w000 = 7.0312500000000000e-01;
  /* #190: @0 = (@0*@2) */
  w000 *= w002;
  /* #191: {@8, @10, @101, @102} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w101;
  res1[3]=w102;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #192: output[0][45] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3780);
  /* #193: @0 = 0.71875 */
  w000 = 7.1875000000000000e-01;
  /* #194: @0 = (@0*@2) */
  w000 *= w002;
  /* #195: {@9, @10, @103, @104} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w103;
  res1[3]=w104;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #196: output[0][46] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3864);
  /* #197: @0 = 0.734375 */
  w000 = 7.3437500000000000e-01;
  /* #198: @0 = (@0*@2) */
  w000 *= w002;
  /* #199: {@8, @10, @105, @106} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w105;
  res1[3]=w106;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #200: output[0][47] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+3948);
  /* #201: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #202: @0 = (@0*@2) */
  w000 *= w002;
  /* #203: {@9, @10, @107, @108} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w107;
  res1[3]=w108;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #204: output[0][48] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4032);
  /* #205: @0 = 0.765625 */
  w000 = 7.6562500000000000e-01;
  /* #206: @0 = (@0*@2) */
  w000 *= w002;
  /* #207: {@8, @10, @109, @110} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w109;
  res1[3]=w110;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #208: output[0][49] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4116);
  /* #209: @0 = 0.78125 */
  w000 = 7.8125000000000000e-01;
  /* #210: @0 = (@0*@2) */
  w000 *= w002;
  /* #211: {@9, @10, @111, @112} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w111;
  res1[3]=w112;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #212: output[0][50] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4200);
  /* #213: @0 = 0.796875 */
  w000 = 7.9687500000000000e-01;
  /* #214: @0 = (@0*@2) */
  w000 *= w002;
  /* #215: {@8, @10, @113, @114} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w113;
  res1[3]=w114;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #216: output[0][51] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4284);
  /* #217: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #218: @0 = (@0*@2) */
  w000 *= w002;
  /* #219: {@9, @10, @115, @116} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w115;
  res1[3]=w116;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #220: output[0][52] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4368);
  /* #221: @0 = 0.828125 */
  w000 = 8.2812500000000000e-01;
  /* #222: @0 = (@0*@2) */
  w000 *= w002;
  /* #223: {@8, @10, @117, @118} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w117;
  res1[3]=w118;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #224: output[0][53] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4452);
  /* #225: @0 = 0.84375 */
  w000 = 8.4375000000000000e-01;
  /* #226: @0 = (@0*@2) */
  w000 *= w002;
  /* #227: {@9, @10, @119, @120} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w119;
  res1[3]=w120;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #228: output[0][54] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4536);
  /* #229: @0 = 0.859375 */
  w000 = 8.5937500000000000e-01;
  /* #230: @0 = (@0*@2) */
  w000 *= w002;
  /* #231: {@8, @10, @121, @122} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w121;
  res1[3]=w122;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #232: output[0][55] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4620);
  /* #233: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #234: @0 = (@0*@2) */
  w000 *= w002;
  /* #235: {@9, @10, @123, @124} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w123;
  res1[3]=w124;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #236: output[0][56] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4704);
  /* #237: @0 = 0.890625 */
  w000 = 8.9062500000000000e-01;
  /* #238: @0 = (@0*@2) */
  w000 *= w002;
  /* #239: {@8, @10, @125, @126} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w125;
  res1[3]=w126;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #240: output[0][57] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4788);
  /* #241: @0 = 0.90625 */
  w000 = 9.0625000000000000e-01;
  /* #242: @0 = (@0*@2) */
  w000 *= w002;
  /* #243: {@9, @10, @127, @128} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w127;
  res1[3]=w128;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #244: output[0][58] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4872);
  /* #245: @0 = 0.921875 */
  w000 = 9.2187500000000000e-01;
  /* #246: @0 = (@0*@2) */
  w000 *= w002;
  /* #247: {@8, @10, @129, @130} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w129;
  res1[3]=w130;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #248: output[0][59] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+4956);
  /* #249: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #250: @0 = (@0*@2) */
  w000 *= w002;
  /* #251: {@9, @10, @131, @132} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w131;
  res1[3]=w132;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #252: output[0][60] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+5040);
  /* #253: @0 = 0.953125 */
  w000 = 9.5312500000000000e-01;
  /* #254: @0 = (@0*@2) */
  w000 *= w002;
  /* #255: {@8, @10, @133, @134} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w133;
  res1[3]=w134;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #256: output[0][61] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+5124);
  /* #257: @0 = 0.96875 */
  w000 = 9.6875000000000000e-01;
  /* #258: @0 = (@0*@2) */
  w000 *= w002;
  /* #259: {@9, @10, @135, @136} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w135;
  res1[3]=w136;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #260: output[0][62] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+5208);
  /* #261: @0 = 0.984375 */
  w000 = 9.8437500000000000e-01;
  /* #262: @0 = (@0*@2) */
  w000 *= w002;
  /* #263: {@8, @10, @137, @138} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=wr004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w137;
  res1[3]=w138;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #264: output[0][63] = @10 */
  if (res[0]) casadi_copy(w010, 84, res[0]+5292);
  /* #265: output[0][64] = @8 */
  if (res[0]) casadi_copy(w008, 7, res[0]+5376);
  /* #266: output[1][0] = @11 */
  casadi_copy(w011, 120, res[1]);
  /* #267: output[1][1] = @13 */
  if (res[1]) casadi_copy(w013, 120, res[1]+120);
  /* #268: output[1][2] = @15 */
  if (res[1]) casadi_copy(w015, 120, res[1]+240);
  /* #269: output[1][3] = @17 */
  if (res[1]) casadi_copy(w017, 120, res[1]+360);
  /* #270: output[1][4] = @19 */
  if (res[1]) casadi_copy(w019, 120, res[1]+480);
  /* #271: output[1][5] = @21 */
  if (res[1]) casadi_copy(w021, 120, res[1]+600);
  /* #272: output[1][6] = @23 */
  if (res[1]) casadi_copy(w023, 120, res[1]+720);
  /* #273: output[1][7] = @25 */
  if (res[1]) casadi_copy(w025, 120, res[1]+840);
  /* #274: output[1][8] = @27 */
  if (res[1]) casadi_copy(w027, 120, res[1]+960);
  /* #275: output[1][9] = @29 */
  if (res[1]) casadi_copy(w029, 120, res[1]+1080);
  /* #276: output[1][10] = @31 */
  if (res[1]) casadi_copy(w031, 120, res[1]+1200);
  /* #277: output[1][11] = @33 */
  if (res[1]) casadi_copy(w033, 120, res[1]+1320);
  /* #278: output[1][12] = @35 */
  if (res[1]) casadi_copy(w035, 120, res[1]+1440);
  /* #279: output[1][13] = @37 */
  if (res[1]) casadi_copy(w037, 120, res[1]+1560);
  /* #280: output[1][14] = @39 */
  if (res[1]) casadi_copy(w039, 120, res[1]+1680);
  /* #281: output[1][15] = @41 */
  if (res[1]) casadi_copy(w041, 120, res[1]+1800);
  /* #282: output[1][16] = @43 */
  if (res[1]) casadi_copy(w043, 120, res[1]+1920);
  /* #283: output[1][17] = @45 */
  if (res[1]) casadi_copy(w045, 120, res[1]+2040);
  /* #284: output[1][18] = @47 */
  if (res[1]) casadi_copy(w047, 120, res[1]+2160);
  /* #285: output[1][19] = @49 */
  if (res[1]) casadi_copy(w049, 120, res[1]+2280);
  /* #286: output[1][20] = @51 */
  if (res[1]) casadi_copy(w051, 120, res[1]+2400);
  /* #287: output[1][21] = @53 */
  if (res[1]) casadi_copy(w053, 120, res[1]+2520);
  /* #288: output[1][22] = @55 */
  if (res[1]) casadi_copy(w055, 120, res[1]+2640);
  /* #289: output[1][23] = @57 */
  if (res[1]) casadi_copy(w057, 120, res[1]+2760);
  /* #290: output[1][24] = @59 */
  if (res[1]) casadi_copy(w059, 120, res[1]+2880);
  /* #291: output[1][25] = @61 */
  if (res[1]) casadi_copy(w061, 120, res[1]+3000);
  /* #292: output[1][26] = @63 */
  if (res[1]) casadi_copy(w063, 120, res[1]+3120);
  /* #293: output[1][27] = @65 */
  if (res[1]) casadi_copy(w065, 120, res[1]+3240);
  /* #294: output[1][28] = @67 */
  if (res[1]) casadi_copy(w067, 120, res[1]+3360);
  /* #295: output[1][29] = @69 */
  if (res[1]) casadi_copy(w069, 120, res[1]+3480);
  /* #296: output[1][30] = @71 */
  if (res[1]) casadi_copy(w071, 120, res[1]+3600);
  /* #297: output[1][31] = @73 */
  if (res[1]) casadi_copy(w073, 120, res[1]+3720);
  /* #298: output[1][32] = @75 */
  if (res[1]) casadi_copy(w075, 120, res[1]+3840);
  /* #299: output[1][33] = @77 */
  if (res[1]) casadi_copy(w077, 120, res[1]+3960);
  /* #300: output[1][34] = @79 */
  if (res[1]) casadi_copy(w079, 120, res[1]+4080);
  /* #301: output[1][35] = @81 */
  if (res[1]) casadi_copy(w081, 120, res[1]+4200);
  /* #302: output[1][36] = @83 */
  if (res[1]) casadi_copy(w083, 120, res[1]+4320);
  /* #303: output[1][37] = @85 */
  if (res[1]) casadi_copy(w085, 120, res[1]+4440);
  /* #304: output[1][38] = @87 */
  if (res[1]) casadi_copy(w087, 120, res[1]+4560);
  /* #305: output[1][39] = @89 */
  if (res[1]) casadi_copy(w089, 120, res[1]+4680);
  /* #306: output[1][40] = @91 */
  if (res[1]) casadi_copy(w091, 120, res[1]+4800);
  /* #307: output[1][41] = @93 */
  if (res[1]) casadi_copy(w093, 120, res[1]+4920);
  /* #308: output[1][42] = @95 */
  if (res[1]) casadi_copy(w095, 120, res[1]+5040);
  /* #309: output[1][43] = @97 */
  if (res[1]) casadi_copy(w097, 120, res[1]+5160);
  /* #310: output[1][44] = @99 */
  if (res[1]) casadi_copy(w099, 120, res[1]+5280);
  /* #311: output[1][45] = @101 */
  if (res[1]) casadi_copy(w101, 120, res[1]+5400);
  /* #312: output[1][46] = @103 */
  if (res[1]) casadi_copy(w103, 120, res[1]+5520);
  /* #313: output[1][47] = @105 */
  if (res[1]) casadi_copy(w105, 120, res[1]+5640);
  /* #314: output[1][48] = @107 */
  if (res[1]) casadi_copy(w107, 120, res[1]+5760);
  /* #315: output[1][49] = @109 */
  if (res[1]) casadi_copy(w109, 120, res[1]+5880);
  /* #316: output[1][50] = @111 */
  if (res[1]) casadi_copy(w111, 120, res[1]+6000);
  /* #317: output[1][51] = @113 */
  if (res[1]) casadi_copy(w113, 120, res[1]+6120);
  /* #318: output[1][52] = @115 */
  if (res[1]) casadi_copy(w115, 120, res[1]+6240);
  /* #319: output[1][53] = @117 */
  if (res[1]) casadi_copy(w117, 120, res[1]+6360);
  /* #320: output[1][54] = @119 */
  if (res[1]) casadi_copy(w119, 120, res[1]+6480);
  /* #321: output[1][55] = @121 */
  if (res[1]) casadi_copy(w121, 120, res[1]+6600);
  /* #322: output[1][56] = @123 */
  if (res[1]) casadi_copy(w123, 120, res[1]+6720);
  /* #323: output[1][57] = @125 */
  if (res[1]) casadi_copy(w125, 120, res[1]+6840);
  /* #324: output[1][58] = @127 */
  if (res[1]) casadi_copy(w127, 120, res[1]+6960);
  /* #325: output[1][59] = @129 */
  if (res[1]) casadi_copy(w129, 120, res[1]+7080);
  /* #326: output[1][60] = @131 */
  if (res[1]) casadi_copy(w131, 120, res[1]+7200);
  /* #327: output[1][61] = @133 */
  if (res[1]) casadi_copy(w133, 120, res[1]+7320);
  /* #328: output[1][62] = @135 */
  if (res[1]) casadi_copy(w135, 120, res[1]+7440);
  /* #329: output[1][63] = @137 */
  if (res[1]) casadi_copy(w137, 120, res[1]+7560);
  /* #330: @1 = @8[:6] */
  for (rr=w001, cs=w008+0; cs!=w008+6; cs+=1) *rr++ = *cs;
  /* #331: {@139, @140} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=wr004;
  res1[0]=w139;
  res1[1]=w140;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #332: output[1][64] = @139 */
  if (res[1]) casadi_copy(w139, 10, res[1]+7680);
  /* #333: output[2][0] = @12 */
  casadi_copy(w012, 120, res[2]);
  /* #334: output[2][1] = @14 */
  if (res[2]) casadi_copy(w014, 120, res[2]+120);
  /* #335: output[2][2] = @16 */
  if (res[2]) casadi_copy(w016, 120, res[2]+240);
  /* #336: output[2][3] = @18 */
  if (res[2]) casadi_copy(w018, 120, res[2]+360);
  /* #337: output[2][4] = @20 */
  if (res[2]) casadi_copy(w020, 120, res[2]+480);
  /* #338: output[2][5] = @22 */
  if (res[2]) casadi_copy(w022, 120, res[2]+600);
  /* #339: output[2][6] = @24 */
  if (res[2]) casadi_copy(w024, 120, res[2]+720);
  /* #340: output[2][7] = @26 */
  if (res[2]) casadi_copy(w026, 120, res[2]+840);
  /* #341: output[2][8] = @28 */
  if (res[2]) casadi_copy(w028, 120, res[2]+960);
  /* #342: output[2][9] = @30 */
  if (res[2]) casadi_copy(w030, 120, res[2]+1080);
  /* #343: output[2][10] = @32 */
  if (res[2]) casadi_copy(w032, 120, res[2]+1200);
  /* #344: output[2][11] = @34 */
  if (res[2]) casadi_copy(w034, 120, res[2]+1320);
  /* #345: output[2][12] = @36 */
  if (res[2]) casadi_copy(w036, 120, res[2]+1440);
  /* #346: output[2][13] = @38 */
  if (res[2]) casadi_copy(w038, 120, res[2]+1560);
  /* #347: output[2][14] = @40 */
  if (res[2]) casadi_copy(w040, 120, res[2]+1680);
  /* #348: output[2][15] = @42 */
  if (res[2]) casadi_copy(w042, 120, res[2]+1800);
  /* #349: output[2][16] = @44 */
  if (res[2]) casadi_copy(w044, 120, res[2]+1920);
  /* #350: output[2][17] = @46 */
  if (res[2]) casadi_copy(w046, 120, res[2]+2040);
  /* #351: output[2][18] = @48 */
  if (res[2]) casadi_copy(w048, 120, res[2]+2160);
  /* #352: output[2][19] = @50 */
  if (res[2]) casadi_copy(w050, 120, res[2]+2280);
  /* #353: output[2][20] = @52 */
  if (res[2]) casadi_copy(w052, 120, res[2]+2400);
  /* #354: output[2][21] = @54 */
  if (res[2]) casadi_copy(w054, 120, res[2]+2520);
  /* #355: output[2][22] = @56 */
  if (res[2]) casadi_copy(w056, 120, res[2]+2640);
  /* #356: output[2][23] = @58 */
  if (res[2]) casadi_copy(w058, 120, res[2]+2760);
  /* #357: output[2][24] = @60 */
  if (res[2]) casadi_copy(w060, 120, res[2]+2880);
  /* #358: output[2][25] = @62 */
  if (res[2]) casadi_copy(w062, 120, res[2]+3000);
  /* #359: output[2][26] = @64 */
  if (res[2]) casadi_copy(w064, 120, res[2]+3120);
  /* #360: output[2][27] = @66 */
  if (res[2]) casadi_copy(w066, 120, res[2]+3240);
  /* #361: output[2][28] = @68 */
  if (res[2]) casadi_copy(w068, 120, res[2]+3360);
  /* #362: output[2][29] = @70 */
  if (res[2]) casadi_copy(w070, 120, res[2]+3480);
  /* #363: output[2][30] = @72 */
  if (res[2]) casadi_copy(w072, 120, res[2]+3600);
  /* #364: output[2][31] = @74 */
  if (res[2]) casadi_copy(w074, 120, res[2]+3720);
  /* #365: output[2][32] = @76 */
  if (res[2]) casadi_copy(w076, 120, res[2]+3840);
  /* #366: output[2][33] = @78 */
  if (res[2]) casadi_copy(w078, 120, res[2]+3960);
  /* #367: output[2][34] = @80 */
  if (res[2]) casadi_copy(w080, 120, res[2]+4080);
  /* #368: output[2][35] = @82 */
  if (res[2]) casadi_copy(w082, 120, res[2]+4200);
  /* #369: output[2][36] = @84 */
  if (res[2]) casadi_copy(w084, 120, res[2]+4320);
  /* #370: output[2][37] = @86 */
  if (res[2]) casadi_copy(w086, 120, res[2]+4440);
  /* #371: output[2][38] = @88 */
  if (res[2]) casadi_copy(w088, 120, res[2]+4560);
  /* #372: output[2][39] = @90 */
  if (res[2]) casadi_copy(w090, 120, res[2]+4680);
  /* #373: output[2][40] = @92 */
  if (res[2]) casadi_copy(w092, 120, res[2]+4800);
  /* #374: output[2][41] = @94 */
  if (res[2]) casadi_copy(w094, 120, res[2]+4920);
  /* #375: output[2][42] = @96 */
  if (res[2]) casadi_copy(w096, 120, res[2]+5040);
  /* #376: output[2][43] = @98 */
  if (res[2]) casadi_copy(w098, 120, res[2]+5160);
  /* #377: output[2][44] = @100 */
  if (res[2]) casadi_copy(w100, 120, res[2]+5280);
  /* #378: output[2][45] = @102 */
  if (res[2]) casadi_copy(w102, 120, res[2]+5400);
  /* #379: output[2][46] = @104 */
  if (res[2]) casadi_copy(w104, 120, res[2]+5520);
  /* #380: output[2][47] = @106 */
  if (res[2]) casadi_copy(w106, 120, res[2]+5640);
  /* #381: output[2][48] = @108 */
  if (res[2]) casadi_copy(w108, 120, res[2]+5760);
  /* #382: output[2][49] = @110 */
  if (res[2]) casadi_copy(w110, 120, res[2]+5880);
  /* #383: output[2][50] = @112 */
  if (res[2]) casadi_copy(w112, 120, res[2]+6000);
  /* #384: output[2][51] = @114 */
  if (res[2]) casadi_copy(w114, 120, res[2]+6120);
  /* #385: output[2][52] = @116 */
  if (res[2]) casadi_copy(w116, 120, res[2]+6240);
  /* #386: output[2][53] = @118 */
  if (res[2]) casadi_copy(w118, 120, res[2]+6360);
  /* #387: output[2][54] = @120 */
  if (res[2]) casadi_copy(w120, 120, res[2]+6480);
  /* #388: output[2][55] = @122 */
  if (res[2]) casadi_copy(w122, 120, res[2]+6600);
  /* #389: output[2][56] = @124 */
  if (res[2]) casadi_copy(w124, 120, res[2]+6720);
  /* #390: output[2][57] = @126 */
  if (res[2]) casadi_copy(w126, 120, res[2]+6840);
  /* #391: output[2][58] = @128 */
  if (res[2]) casadi_copy(w128, 120, res[2]+6960);
  /* #392: output[2][59] = @130 */
  if (res[2]) casadi_copy(w130, 120, res[2]+7080);
  /* #393: output[2][60] = @132 */
  if (res[2]) casadi_copy(w132, 120, res[2]+7200);
  /* #394: output[2][61] = @134 */
  if (res[2]) casadi_copy(w134, 120, res[2]+7320);
  /* #395: output[2][62] = @136 */
  if (res[2]) casadi_copy(w136, 120, res[2]+7440);
  /* #396: output[2][63] = @138 */
  if (res[2]) casadi_copy(w138, 120, res[2]+7560);
  /* #397: output[2][64] = @140 */
  if (res[2]) casadi_copy(w140, 10, res[2]+7680);
  /* #398: @1 = @8[:6] */
  for (rr=w001, cs=w008+0; cs!=w008+6; cs+=1) *rr++ = *cs;
  /* #399: @141 = landing(@1, @6, @4) */
  arg1[0]=w001;
  arg1[1]=w006;
  arg1[2]=wr004;
  res1[0]=w141;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #400: output[3][0] = @141 */
  casadi_copy(w141, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s23;
    case 1: return casadi_s24;
    case 2: return casadi_s24;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 15899;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 15899*sizeof(casadi_real);
  return 0;
}

/* wobbling_advance:(t,w[7],h,p[8])->(w_end[7],g[10],dg[10]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w0=w+116, w1, *w3=w+123, w4, *w5=w+125, *w6=w+149, *w7=w+156, *w8=w+162, *w9=w+172;
  const casadi_real **arg1=arg+4, *cs, *wr2;
  /* #0: @0 = input[1][0] */
  casadi_copy(arg[1], 7, w0);
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[3][0] */
  wr2 = arg[3] ? arg[3] : casadi_zeros;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  w4 = arg[2] ? arg[2][0] : 0;
  /* #5: @5 = turns(@4, @2) */
  arg1[0]=(&w4);
  arg1[1]=wr2;
  res1[0]=w5;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #6: @6 = working_step(@0, @3, @5, @4, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=w5;
  arg1[3]=(&w4);
  arg1[4]=wr2;
  res1[0]=w6;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #7: output[0][0] = @6 */
  casadi_copy(w6, 7, res[0]);
  /* #8: @1 = (@1+@4) */
  w1 += w4;
  /* #9: @7 = @6[:6] */
  for (rr=w7, cs=w6+0; cs!=w6+6; cs+=1) *rr++ = *cs;
  /* #10: {@8, @9} = observe(@1, @7, @2) */
  arg1[0]=(&w1);
  arg1[1]=w7;
  arg1[2]=wr2;
  res1[0]=w8;
  res1[1]=w9;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[1][0] = @8 */
  casadi_copy(w8, 10, res[1]);
  /* #12: output[2][0] = @9 */
  casadi_copy(w9, 10, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s26;
    case 2: return casadi_s25;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s26;
    case 1: return casadi_s27;
    case 2: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 182;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 182*sizeof(casadi_real);
  return 0;
}

/* wobbling_begin:(u[6],p[8])->(y[6x6]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+2, *w1=w+8, *w3=w+13;
  const casadi_real **arg1=arg+2, *cs, *wr2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  wr2 = arg[1] ? arg[1] : casadi_zeros;
  /* #3: {@0, @3} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=wr2;
  res1[0]=w0;
  res1[1]=w3;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  /* #5: output[0][1] = @3 */
  if (res[0]) casadi_copy(w3, 30, res[0]+6);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_begin(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_begin_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_begin_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_begin_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_begin_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_begin_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_begin_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_begin_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_begin_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_begin_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_begin_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_begin_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_begin_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 43;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_begin_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 43*sizeof(casadi_real);
  return 0;
}

/* wobbling_swing:(t,h,y[6x6],p[8])->(y_end[6x6]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w4=w+423, *w5=w+447;
  const casadi_real **arg1=arg+4, *wr0, *wr3;
  /* #0: @0 = input[2][0] */
  wr0 = arg[2] ? arg[2] : casadi_zeros;
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[3][0] */
  wr3 = arg[3] ? arg[3] : casadi_zeros;
  /* #4: @4 = turns(@2, @3) */
  arg1[0]=(&w2);
  arg1[1]=wr3;
  res1[0]=w4;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = variational_steps(@0, @1, @4, @2, @3) */
  arg1[0]=wr0;
  arg1[1]=(&w1);
  arg1[2]=w4;
  arg1[3]=(&w2);
  arg1[4]=wr3;
  res1[0]=w5;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 36, res[0]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f100(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_swing_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "y";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y_end";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s6;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 483;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 483*sizeof(casadi_real);
  return 0;
}

/* wobbling_end:(y[6x6],u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w1=w+45, *w2=w+51, w3, *w5=w+56;
  const casadi_real **arg1=arg+3, *cs, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = @1[:5] */
  for (rr=w2, cs=w1+0; cs!=w1+5; cs+=1) *rr++ = *cs;
  /* #3: @3 = @1[5] */
  for (rr=(&w3), cs=w1+5; cs!=w1+6; cs+=1) *rr++ = *cs;
  /* #4: @4 = input[2][0] */
  wr4 = arg[2] ? arg[2] : casadi_zeros;
  /* #5: {@5, @1} = landing_with_derivative(@0, @2, @3, @4) */
  arg1[0]=wr0;
  arg1[1]=w2;
  arg1[2]=(&w3);
  arg1[3]=wr4;
  res1[0]=w5;
  res1[1]=w1;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 36, res[0]);
  /* #7: output[1][0] = @1 */
  casadi_copy(w1, 6, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_end(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f101(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_end_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_end_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_end_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_end_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_end_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_end_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_end_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_end_name_in(casadi_int i) {
  switch (i) {
    case 0: return "y";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_end_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_end_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_end_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_end_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 92;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 92*sizeof(casadi_real);
  return 0;
}

/* wobbling_observed_swing:(t,h,w[7],p[8])->(w_end[7],nodes[7x12],g[10x12],dg[10x12]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w3=w+380, *w4=w+404, *w5=w+411, *w6=w+418, *w7=w+502, *w8=w+622;
  const casadi_real **arg1=arg+4, *wr2;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[3][0] */
  wr2 = arg[3] ? arg[3] : casadi_zeros;
  /* #3: @3 = turns(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=wr2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  casadi_copy(arg[2], 7, w4);
  /* #5: {@5, @6, @7, @8} = working_steps(@0, @3, @4, @1, @2) */
  arg1[0]=(&w0);
  arg1[1]=w3;
  arg1[2]=w4;
  arg1[3]=(&w1);
  arg1[4]=wr2;
  res1[0]=w5;
  res1[1]=w6;
  res1[2]=w7;
  res1[3]=w8;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 7, res[0]);
  /* #7: output[1][0] = @6 */
  casadi_copy(w6, 84, res[1]);
  /* #8: output[2][0] = @7 */
  casadi_copy(w7, 120, res[2]);
  /* #9: output[3][0] = @8 */
  casadi_copy(w8, 120, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f102(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int wobbling_observed_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void wobbling_observed_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void wobbling_observed_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void wobbling_observed_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int wobbling_observed_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int wobbling_observed_swing_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real wobbling_observed_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_observed_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "w";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* wobbling_observed_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "nodes";
    case 2: return "g";
    case 3: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_observed_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s26;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_observed_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s26;
    case 1: return casadi_s28;
    case 2: return casadi_s29;
    case 3: return casadi_s29;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 742;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 742*sizeof(casadi_real);
  return 0;
}



/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*wobbling_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int wobbling_map(wobbling_kernel kernel, const casadi_int* work_size, casadi_int n,
    casadi_int n_in, const double* const* in, const casadi_int* in_size,
    casadi_int n_out, double* const* out, const casadi_int* out_size, int* failed)
{
    const double** arg = (const double**) malloc((size_t) work_size[0] * sizeof(double*));
    double** res = (double**) malloc((size_t) work_size[1] * sizeof(double*));
    casadi_int* iw = (casadi_int*) malloc((size_t) (work_size[2] + 1) * sizeof(casadi_int));
    double* w = (double*) malloc((size_t) (work_size[3] + 1) * sizeof(double));
    const int ready = arg && res && iw && w;
    casadi_int i, j;
    if (ready) {
        for (i = 0; i < n; i++) {
            for (j = 0; j < n_in; j++) arg[j] = in[j] + i * in_size[j];
            for (j = 0; j < n_out; j++) res[j] = out[j] + i * out_size[j];
            failed[i] = kernel(arg, res, iw, w, 0);
        }
    }
    free(arg);
    free(res);
    free(iw);
    free(w);
    return ready ? 0 : 1;
}
