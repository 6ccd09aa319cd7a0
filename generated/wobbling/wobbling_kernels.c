/* Compass walker with a horizontally wobbling mass: kernels of the solver
 * Printed by CasADi 3.8.2 from equations a3b89c634070f7cc.
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
  casadi_real a312;
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
  a013=(a008-a012);
  a009=(a009*a013);
  a013=sin(a000);
  a014=cos(a010);
  a015=(a013*a014);
  a016=cos(a000);
  a017=(a016*a011);
  a015=(a015-a017);
  a017=(a013-a015);
  a017=(a007*a017);
  a009=(a009+a017);
  a009=(a009+a013);
  a018=(2.*a007);
  a019=1.;
  a020=(a019-a014);
  a020=(a018*a020);
  a020=(a020+a019);
  a021=(a009/a020);
  a022=(a014-a019);
  a022=(a007*a022);
  a023=(a022/a020);
  a024=casadi_sq(a003);
  a024=(a024*a011);
  a024=(a024+a015);
  a024=(a007*a024);
  a015=arg[4]? arg[4][5] : 0;
  a025=arg[4]? arg[4][7] : 0;
  a026=arg[4]? arg[4][2] : 0;
  a026=(a025*a026);
  a027=arg[1]? arg[1][1] : 0;
  a028=(a026*a027);
  a028=(a008+a028);
  a028=(a015*a028);
  a029=arg[4]? arg[4][4] : 0;
  a030=arg[4]? arg[4][6] : 0;
  a031=arg[1]? arg[1][0] : 0;
  a032=(a031+a019);
  a032=(a025*a032);
  a032=(a030-a032);
  a032=(a032+a010);
  a032=(a029*a032);
  a028=(a028+a032);
  a024=(a024-a028);
  a028=(a023*a009);
  a028=(a024-a028);
  a032=(a022*a023);
  a032=(a007-a032);
  a033=(a028/a032);
  a034=arg[4]? arg[4][1] : 0;
  a035=(a034*a016);
  a036=(a035/a020);
  a022=(a022*a036);
  a037=(a022/a032);
  a009=(a036*a009);
  a038=(a034*a003);
  a038=(a038*a003);
  a038=(a038*a013);
  a039=arg[4]? arg[4][0] : 0;
  a040=arg[0]? arg[0][2] : 0;
  a041=(a039*a040);
  a038=(a038+a041);
  a009=(a009-a038);
  a028=(a037*a028);
  a009=(a009-a028);
  a035=(a035*a036);
  a035=(a034-a035);
  a022=(a022*a037);
  a035=(a035-a022);
  a009=(a009/a035);
  a022=(a037*a009);
  a033=(a033-a022);
  a022=(a023*a033);
  a021=(a021-a022);
  a022=(a036*a009);
  a021=(a021+a022);
  a022=(a006*a021);
  a028=1.7082860872947386e-01;
  a028=(a028*a002);
  a041=2.9587585476806851e-02;
  a041=(a041*a002);
  a042=(a041*a033);
  a043=8.8762756430420545e-02;
  a043=(a043*a002);
  a044=1.9725056984537900e-02;
  a044=(a044*a002);
  a045=(a044*a021);
  a046=5.9175170953613701e-02;
  a046=(a046*a002);
  a047=5.2600151958767730e-02;
  a047=(a047*a002);
  a048=(a047*a033);
  a048=(a008+a048);
  a049=(a007*a048);
  a050=(a047*a008);
  a050=(a010+a050);
  a051=sin(a050);
  a049=(a049*a051);
  a052=(a047*a021);
  a052=(a003+a052);
  a053=(2.*a052);
  a054=(a048-a053);
  a049=(a049*a054);
  a054=(a047*a003);
  a054=(a000+a054);
  a055=sin(a054);
  a056=cos(a050);
  a057=(a055*a056);
  a054=cos(a054);
  a058=(a054*a051);
  a057=(a057-a058);
  a058=(a055-a057);
  a058=(a007*a058);
  a049=(a049+a058);
  a049=(a049+a055);
  a059=(a019-a056);
  a059=(a018*a059);
  a059=(a059+a019);
  a060=(a049/a059);
  a061=(a056-a019);
  a061=(a007*a061);
  a062=(a061/a059);
  a063=casadi_sq(a052);
  a063=(a063*a051);
  a063=(a063+a057);
  a063=(a007*a063);
  a057=arg[2]? arg[2][2] : 0;
  a064=(a027*a057);
  a065=arg[2]? arg[2][3] : 0;
  a066=(a031*a065);
  a064=(a064+a066);
  a064=(a026*a064);
  a064=(a048+a064);
  a064=(a015*a064);
  a057=(a031*a057);
  a065=(a027*a065);
  a057=(a057-a065);
  a057=(a057+a019);
  a057=(a025*a057);
  a057=(a030-a057);
  a057=(a057+a050);
  a057=(a029*a057);
  a064=(a064+a057);
  a063=(a063-a064);
  a064=(a062*a049);
  a064=(a063-a064);
  a057=(a061*a062);
  a057=(a007-a057);
  a050=(a064/a057);
  a065=(a034*a054);
  a066=(a065/a059);
  a061=(a061*a066);
  a067=(a061/a057);
  a049=(a066*a049);
  a068=(a034*a052);
  a068=(a068*a052);
  a068=(a068*a055);
  a069=arg[0]? arg[0][5] : 0;
  a070=(a047*a069);
  a070=(a040+a070);
  a070=(a039*a070);
  a068=(a068+a070);
  a049=(a049-a068);
  a064=(a067*a064);
  a049=(a049-a064);
  a065=(a065*a066);
  a065=(a034-a065);
  a061=(a061*a067);
  a065=(a065-a061);
  a049=(a049/a065);
  a061=(a067*a049);
  a050=(a050-a061);
  a061=(a062*a050);
  a060=(a060-a061);
  a061=(a066*a049);
  a060=(a060+a061);
  a060=(a046*a060);
  a045=(a045+a060);
  a045=(a003+a045);
  a060=casadi_sq(a045);
  a061=(a044*a008);
  a064=(a046*a048);
  a061=(a061+a064);
  a061=(a010+a061);
  a064=sin(a061);
  a060=(a060*a064);
  a070=(a044*a003);
  a071=(a046*a052);
  a070=(a070+a071);
  a070=(a000+a070);
  a071=sin(a070);
  a072=cos(a061);
  a073=(a071*a072);
  a070=cos(a070);
  a074=(a070*a064);
  a073=(a073-a074);
  a060=(a060+a073);
  a060=(a007*a060);
  a074=(a044*a033);
  a050=(a046*a050);
  a074=(a074+a050);
  a074=(a008+a074);
  a050=arg[2]? arg[2][4] : 0;
  a075=(a027*a050);
  a076=arg[2]? arg[2][5] : 0;
  a077=(a031*a076);
  a075=(a075+a077);
  a075=(a026*a075);
  a075=(a074+a075);
  a075=(a015*a075);
  a050=(a031*a050);
  a076=(a027*a076);
  a050=(a050-a076);
  a050=(a050+a019);
  a050=(a025*a050);
  a050=(a030-a050);
  a050=(a050+a061);
  a050=(a029*a050);
  a075=(a075+a050);
  a060=(a060-a075);
  a075=(a072-a019);
  a075=(a007*a075);
  a050=(a019-a072);
  a050=(a018*a050);
  a050=(a050+a019);
  a061=(a075/a050);
  a076=(a007*a074);
  a076=(a076*a064);
  a077=(2.*a045);
  a078=(a074-a077);
  a076=(a076*a078);
  a073=(a071-a073);
  a073=(a007*a073);
  a076=(a076+a073);
  a076=(a076+a071);
  a078=(a061*a076);
  a078=(a060-a078);
  a079=(a075*a061);
  a079=(a007-a079);
  a080=(a078/a079);
  a081=(a034*a070);
  a082=(a081/a050);
  a075=(a075*a082);
  a083=(a075/a079);
  a084=(a082*a076);
  a085=(a034*a045);
  a085=(a085*a045);
  a085=(a085*a071);
  a086=(a044*a069);
  a087=(a047*a009);
  a087=(a069+a087);
  a087=(a046*a087);
  a086=(a086+a087);
  a086=(a040+a086);
  a086=(a039*a086);
  a085=(a085+a086);
  a084=(a084-a085);
  a078=(a083*a078);
  a084=(a084-a078);
  a081=(a081*a082);
  a081=(a034-a081);
  a075=(a075*a083);
  a081=(a081-a075);
  a084=(a084/a081);
  a075=(a083*a084);
  a080=(a080-a075);
  a075=(a043*a080);
  a042=(a042+a075);
  a042=(a008+a042);
  a075=(a007*a042);
  a078=(a041*a008);
  a086=(a043*a074);
  a078=(a078+a086);
  a078=(a010+a078);
  a086=sin(a078);
  a075=(a075*a086);
  a087=(a041*a021);
  a076=(a076/a050);
  a088=(a061*a080);
  a076=(a076-a088);
  a088=(a082*a084);
  a076=(a076+a088);
  a088=(a043*a076);
  a087=(a087+a088);
  a087=(a003+a087);
  a088=(2.*a087);
  a089=(a042-a088);
  a075=(a075*a089);
  a089=(a041*a003);
  a090=(a043*a045);
  a089=(a089+a090);
  a089=(a000+a089);
  a090=sin(a089);
  a091=cos(a078);
  a092=(a090*a091);
  a089=cos(a089);
  a093=(a089*a086);
  a092=(a092-a093);
  a093=(a090-a092);
  a093=(a007*a093);
  a075=(a075+a093);
  a075=(a075+a090);
  a094=(a019-a091);
  a094=(a018*a094);
  a094=(a094+a019);
  a095=(a075/a094);
  a096=(a091-a019);
  a096=(a007*a096);
  a097=(a096/a094);
  a098=casadi_sq(a087);
  a098=(a098*a086);
  a098=(a098+a092);
  a098=(a007*a098);
  a092=arg[2]? arg[2][6] : 0;
  a099=(a027*a092);
  a100=arg[2]? arg[2][7] : 0;
  a101=(a031*a100);
  a099=(a099+a101);
  a099=(a026*a099);
  a099=(a042+a099);
  a099=(a015*a099);
  a092=(a031*a092);
  a100=(a027*a100);
  a092=(a092-a100);
  a092=(a092+a019);
  a092=(a025*a092);
  a092=(a030-a092);
  a092=(a092+a078);
  a092=(a029*a092);
  a099=(a099+a092);
  a098=(a098-a099);
  a099=(a097*a075);
  a099=(a098-a099);
  a092=(a096*a097);
  a092=(a007-a092);
  a078=(a099/a092);
  a100=(a034*a089);
  a101=(a100/a094);
  a096=(a096*a101);
  a102=(a096/a092);
  a075=(a101*a075);
  a103=(a034*a087);
  a103=(a103*a087);
  a103=(a103*a090);
  a104=(a041*a069);
  a105=(a044*a009);
  a049=(a046*a049);
  a105=(a105+a049);
  a105=(a069+a105);
  a049=(a043*a105);
  a104=(a104+a049);
  a104=(a040+a104);
  a104=(a039*a104);
  a103=(a103+a104);
  a075=(a075-a103);
  a099=(a102*a099);
  a075=(a075-a099);
  a100=(a100*a101);
  a100=(a034-a100);
  a096=(a096*a102);
  a100=(a100-a096);
  a075=(a075/a100);
  a096=(a102*a075);
  a078=(a078-a096);
  a096=(a097*a078);
  a095=(a095-a096);
  a096=(a101*a075);
  a095=(a095+a096);
  a096=(a028*a095);
  a022=(a022+a096);
  a096=1.2546768756682242e-01;
  a096=(a096*a002);
  a099=2.4136513415926669e-01;
  a099=(a099*a002);
  a104=(a099*a033);
  a049=-8.8454947932828609e-01;
  a049=(a049*a002);
  a080=(a049*a080);
  a104=(a104+a080);
  a080=9.2483400326179199e-01;
  a080=(a080*a002);
  a106=(a080*a078);
  a104=(a104+a106);
  a104=(a008+a104);
  a106=(a007*a104);
  a107=(a099*a008);
  a108=(a049*a074);
  a107=(a107+a108);
  a108=(a080*a042);
  a107=(a107+a108);
  a107=(a010+a107);
  a108=sin(a107);
  a106=(a106*a108);
  a109=(a099*a021);
  a076=(a049*a076);
  a109=(a109+a076);
  a076=(a080*a095);
  a109=(a109+a076);
  a109=(a003+a109);
  a076=(2.*a109);
  a110=(a104-a076);
  a106=(a106*a110);
  a110=(a099*a003);
  a111=(a049*a045);
  a110=(a110+a111);
  a111=(a080*a087);
  a110=(a110+a111);
  a110=(a000+a110);
  a111=sin(a110);
  a112=cos(a107);
  a113=(a111*a112);
  a110=cos(a110);
  a114=(a110*a108);
  a113=(a113-a114);
  a114=(a111-a113);
  a114=(a007*a114);
  a106=(a106+a114);
  a106=(a106+a111);
  a115=(a019-a112);
  a115=(a018*a115);
  a115=(a115+a019);
  a116=(a106/a115);
  a117=(a112-a019);
  a117=(a007*a117);
  a118=(a117/a115);
  a119=casadi_sq(a109);
  a119=(a119*a108);
  a119=(a119+a113);
  a119=(a007*a119);
  a113=arg[2]? arg[2][8] : 0;
  a120=(a027*a113);
  a121=arg[2]? arg[2][9] : 0;
  a122=(a031*a121);
  a120=(a120+a122);
  a120=(a026*a120);
  a120=(a104+a120);
  a120=(a015*a120);
  a113=(a031*a113);
  a121=(a027*a121);
  a113=(a113-a121);
  a113=(a113+a019);
  a113=(a025*a113);
  a113=(a030-a113);
  a113=(a113+a107);
  a113=(a029*a113);
  a120=(a120+a113);
  a119=(a119-a120);
  a120=(a118*a106);
  a120=(a119-a120);
  a113=(a117*a118);
  a113=(a007-a113);
  a107=(a120/a113);
  a121=(a034*a110);
  a122=(a121/a115);
  a117=(a117*a122);
  a123=(a117/a113);
  a106=(a122*a106);
  a124=(a034*a109);
  a124=(a124*a109);
  a124=(a124*a111);
  a125=(a099*a069);
  a105=(a049*a105);
  a125=(a125+a105);
  a105=(a041*a009);
  a126=(a043*a084);
  a105=(a105+a126);
  a105=(a069+a105);
  a126=(a080*a105);
  a125=(a125+a126);
  a125=(a040+a125);
  a125=(a039*a125);
  a124=(a124+a125);
  a106=(a106-a124);
  a120=(a123*a120);
  a106=(a106-a120);
  a121=(a121*a122);
  a121=(a034-a121);
  a117=(a117*a123);
  a121=(a121-a117);
  a106=(a106/a121);
  a117=(a123*a106);
  a107=(a107-a117);
  a117=(a118*a107);
  a116=(a116-a117);
  a117=(a122*a106);
  a116=(a116+a117);
  a117=(a096*a116);
  a022=(a022+a117);
  a022=(a003+a022);
  a117=(a005*a022);
  a004=(a004+a117);
  a117=1.8915178993145003e+00;
  a117=(a117*a002);
  a120=3.7109375000000000e-02;
  a120=(a120*a002);
  a125=(a120*a021);
  a126=1.7025221101954405e-01;
  a126=(a126*a002);
  a127=(a126*a095);
  a125=(a125+a127);
  a127=6.0216538980455959e-02;
  a127=(a127*a002);
  a128=(a127*a116);
  a125=(a125+a128);
  a128=-1.7578125000000000e-02;
  a128=(a128*a002);
  a129=(a006*a033);
  a130=(a028*a078);
  a129=(a129+a130);
  a130=(a096*a107);
  a129=(a129+a130);
  a129=(a008+a129);
  a130=(a007*a129);
  a131=(a006*a008);
  a132=(a028*a042);
  a131=(a131+a132);
  a132=(a096*a104);
  a131=(a131+a132);
  a131=(a010+a131);
  a132=sin(a131);
  a130=(a130*a132);
  a133=(2.*a022);
  a134=(a129-a133);
  a130=(a130*a134);
  a134=(a006*a003);
  a135=(a028*a087);
  a134=(a134+a135);
  a135=(a096*a109);
  a134=(a134+a135);
  a134=(a000+a134);
  a135=sin(a134);
  a136=cos(a131);
  a137=(a135*a136);
  a134=cos(a134);
  a138=(a134*a132);
  a137=(a137-a138);
  a138=(a135-a137);
  a138=(a007*a138);
  a130=(a130+a138);
  a130=(a130+a135);
  a139=(a019-a136);
  a139=(a018*a139);
  a139=(a139+a019);
  a140=(a130/a139);
  a141=(a136-a019);
  a141=(a007*a141);
  a142=(a141/a139);
  a143=casadi_sq(a022);
  a143=(a143*a132);
  a143=(a143+a137);
  a143=(a007*a143);
  a137=arg[2]? arg[2][10] : 0;
  a144=(a027*a137);
  a145=arg[2]? arg[2][11] : 0;
  a146=(a031*a145);
  a144=(a144+a146);
  a144=(a026*a144);
  a144=(a129+a144);
  a144=(a015*a144);
  a137=(a031*a137);
  a145=(a027*a145);
  a137=(a137-a145);
  a137=(a137+a019);
  a137=(a025*a137);
  a137=(a030-a137);
  a137=(a137+a131);
  a137=(a029*a137);
  a144=(a144+a137);
  a143=(a143-a144);
  a144=(a142*a130);
  a144=(a143-a144);
  a137=(a141*a142);
  a137=(a007-a137);
  a131=(a144/a137);
  a145=(a034*a134);
  a146=(a145/a139);
  a141=(a141*a146);
  a147=(a141/a137);
  a130=(a146*a130);
  a148=(a034*a022);
  a148=(a148*a022);
  a148=(a148*a135);
  a149=(a006*a069);
  a150=(a028*a105);
  a149=(a149+a150);
  a150=(a099*a009);
  a084=(a049*a084);
  a150=(a150+a084);
  a084=(a080*a075);
  a150=(a150+a084);
  a150=(a069+a150);
  a084=(a096*a150);
  a149=(a149+a084);
  a149=(a040+a149);
  a149=(a039*a149);
  a148=(a148+a149);
  a130=(a130-a148);
  a144=(a147*a144);
  a130=(a130-a144);
  a145=(a145*a146);
  a145=(a034-a145);
  a141=(a141*a147);
  a145=(a145-a141);
  a130=(a130/a145);
  a141=(a147*a130);
  a131=(a131-a141);
  a141=(a142*a131);
  a140=(a140-a141);
  a141=(a146*a130);
  a140=(a140+a141);
  a141=(a128*a140);
  a125=(a125+a141);
  a125=(a003+a125);
  a141=(a117*a125);
  a004=(a004+a141);
  a141=-5.8012039600105849e+00;
  a141=(a141*a002);
  a144=3.7092000118504789e-02;
  a144=(a144*a002);
  a149=(a144*a021);
  a084=1.7038392571223998e-01;
  a084=(a084*a002);
  a151=(a084*a095);
  a149=(a149+a151);
  a151=1.0726203044637328e-01;
  a151=(a151*a002);
  a152=(a151*a116);
  a149=(a149+a152);
  a152=-1.5319437748624402e-02;
  a152=(a152*a002);
  a153=(a152*a140);
  a149=(a149+a153);
  a153=8.2737891638140233e-03;
  a153=(a153*a002);
  a154=(a120*a033);
  a155=(a126*a078);
  a154=(a154+a155);
  a155=(a127*a107);
  a154=(a154+a155);
  a155=(a128*a131);
  a154=(a154+a155);
  a154=(a008+a154);
  a155=(a007*a154);
  a156=(a120*a008);
  a157=(a126*a042);
  a156=(a156+a157);
  a157=(a127*a104);
  a156=(a156+a157);
  a157=(a128*a129);
  a156=(a156+a157);
  a156=(a010+a156);
  a157=sin(a156);
  a155=(a155*a157);
  a158=(2.*a125);
  a159=(a154-a158);
  a155=(a155*a159);
  a159=(a120*a003);
  a160=(a126*a087);
  a159=(a159+a160);
  a160=(a127*a109);
  a159=(a159+a160);
  a160=(a128*a022);
  a159=(a159+a160);
  a159=(a000+a159);
  a160=sin(a159);
  a161=cos(a156);
  a162=(a160*a161);
  a159=cos(a159);
  a163=(a159*a157);
  a162=(a162-a163);
  a163=(a160-a162);
  a163=(a007*a163);
  a155=(a155+a163);
  a155=(a155+a160);
  a164=(a019-a161);
  a164=(a018*a164);
  a164=(a164+a019);
  a165=(a155/a164);
  a166=(a161-a019);
  a166=(a007*a166);
  a167=(a166/a164);
  a168=casadi_sq(a125);
  a168=(a168*a157);
  a168=(a168+a162);
  a168=(a007*a168);
  a162=arg[2]? arg[2][12] : 0;
  a169=(a027*a162);
  a170=arg[2]? arg[2][13] : 0;
  a171=(a031*a170);
  a169=(a169+a171);
  a169=(a026*a169);
  a169=(a154+a169);
  a169=(a015*a169);
  a162=(a031*a162);
  a170=(a027*a170);
  a162=(a162-a170);
  a162=(a162+a019);
  a162=(a025*a162);
  a162=(a030-a162);
  a162=(a162+a156);
  a162=(a029*a162);
  a169=(a169+a162);
  a168=(a168-a169);
  a169=(a167*a155);
  a169=(a168-a169);
  a162=(a166*a167);
  a162=(a007-a162);
  a156=(a169/a162);
  a170=(a034*a159);
  a171=(a170/a164);
  a166=(a166*a171);
  a172=(a166/a162);
  a155=(a171*a155);
  a173=(a034*a125);
  a173=(a173*a125);
  a173=(a173*a160);
  a174=(a120*a069);
  a175=(a126*a105);
  a174=(a174+a175);
  a175=(a127*a150);
  a174=(a174+a175);
  a175=(a006*a009);
  a176=(a028*a075);
  a175=(a175+a176);
  a176=(a096*a106);
  a175=(a175+a176);
  a175=(a069+a175);
  a176=(a128*a175);
  a174=(a174+a176);
  a174=(a040+a174);
  a174=(a039*a174);
  a173=(a173+a174);
  a155=(a155-a173);
  a169=(a172*a169);
  a155=(a155-a169);
  a170=(a170*a171);
  a170=(a034-a170);
  a166=(a166*a172);
  a170=(a170-a166);
  a155=(a155/a170);
  a166=(a172*a155);
  a156=(a156-a166);
  a166=(a167*a156);
  a165=(a165-a166);
  a166=(a171*a155);
  a165=(a165+a166);
  a166=(a153*a165);
  a149=(a149+a166);
  a149=(a003+a149);
  a166=(a141*a149);
  a004=(a004+a166);
  a166=3.1116436695781990e-01;
  a166=(a166*a002);
  a169=6.2411095871607569e-01;
  a169=(a169*a002);
  a174=(a169*a021);
  a176=-3.3608926294469414e+00;
  a176=(a176*a002);
  a177=(a176*a095);
  a174=(a174+a177);
  a177=-8.6821934684172597e-01;
  a177=(a177*a002);
  a178=(a177*a116);
  a174=(a174+a178);
  a178=2.7592099699446710e+01;
  a178=(a178*a002);
  a179=(a178*a140);
  a174=(a174+a179);
  a179=2.0154067550477894e+01;
  a179=(a179*a002);
  a180=(a179*a165);
  a174=(a174+a180);
  a180=-4.3489884181069961e+01;
  a180=(a180*a002);
  a181=(a144*a033);
  a182=(a084*a078);
  a181=(a181+a182);
  a182=(a151*a107);
  a181=(a181+a182);
  a182=(a152*a131);
  a181=(a181+a182);
  a182=(a153*a156);
  a181=(a181+a182);
  a181=(a008+a181);
  a182=(a007*a181);
  a183=(a144*a008);
  a184=(a084*a042);
  a183=(a183+a184);
  a184=(a151*a104);
  a183=(a183+a184);
  a184=(a152*a129);
  a183=(a183+a184);
  a184=(a153*a154);
  a183=(a183+a184);
  a183=(a010+a183);
  a184=sin(a183);
  a182=(a182*a184);
  a185=(2.*a149);
  a186=(a181-a185);
  a182=(a182*a186);
  a186=(a144*a003);
  a187=(a084*a087);
  a186=(a186+a187);
  a187=(a151*a109);
  a186=(a186+a187);
  a187=(a152*a022);
  a186=(a186+a187);
  a187=(a153*a125);
  a186=(a186+a187);
  a186=(a000+a186);
  a187=sin(a186);
  a188=cos(a183);
  a189=(a187*a188);
  a186=cos(a186);
  a190=(a186*a184);
  a189=(a189-a190);
  a190=(a187-a189);
  a190=(a007*a190);
  a182=(a182+a190);
  a182=(a182+a187);
  a191=(a019-a188);
  a191=(a018*a191);
  a191=(a191+a019);
  a192=(a182/a191);
  a193=(a188-a019);
  a193=(a007*a193);
  a194=(a193/a191);
  a195=casadi_sq(a149);
  a195=(a195*a184);
  a195=(a195+a189);
  a195=(a007*a195);
  a189=arg[2]? arg[2][14] : 0;
  a196=(a027*a189);
  a197=arg[2]? arg[2][15] : 0;
  a198=(a031*a197);
  a196=(a196+a198);
  a196=(a026*a196);
  a196=(a181+a196);
  a196=(a015*a196);
  a189=(a031*a189);
  a197=(a027*a197);
  a189=(a189-a197);
  a189=(a189+a019);
  a189=(a025*a189);
  a189=(a030-a189);
  a189=(a189+a183);
  a189=(a029*a189);
  a196=(a196+a189);
  a195=(a195-a196);
  a196=(a194*a182);
  a196=(a195-a196);
  a189=(a193*a194);
  a189=(a007-a189);
  a183=(a196/a189);
  a197=(a034*a186);
  a198=(a197/a191);
  a193=(a193*a198);
  a199=(a193/a189);
  a182=(a198*a182);
  a200=(a034*a149);
  a200=(a200*a149);
  a200=(a200*a187);
  a201=(a144*a069);
  a202=(a084*a105);
  a201=(a201+a202);
  a202=(a151*a150);
  a201=(a201+a202);
  a202=(a152*a175);
  a201=(a201+a202);
  a202=(a120*a009);
  a203=(a126*a075);
  a202=(a202+a203);
  a203=(a127*a106);
  a202=(a202+a203);
  a203=(a128*a130);
  a202=(a202+a203);
  a202=(a069+a202);
  a203=(a153*a202);
  a201=(a201+a203);
  a201=(a040+a201);
  a201=(a039*a201);
  a200=(a200+a201);
  a182=(a182-a200);
  a196=(a199*a196);
  a182=(a182-a196);
  a197=(a197*a198);
  a197=(a034-a197);
  a193=(a193*a199);
  a197=(a197-a193);
  a182=(a182/a197);
  a193=(a199*a182);
  a183=(a183-a193);
  a193=(a194*a183);
  a192=(a192-a193);
  a193=(a198*a182);
  a192=(a192+a193);
  a193=(a180*a192);
  a174=(a174+a193);
  a174=(a003+a174);
  a193=(a166*a174);
  a004=(a004+a193);
  a193=-1.5216094966251609e-01;
  a193=(a193*a002);
  a196=4.7766253643826434e-01;
  a196=(a196*a002);
  a201=(a196*a021);
  a203=-2.4881146199716677e+00;
  a203=(a203*a002);
  a204=(a203*a095);
  a201=(a201+a204);
  a204=-5.9029082683684297e-01;
  a204=(a204*a002);
  a205=(a204*a116);
  a201=(a201+a205);
  a205=2.1230051448181193e+01;
  a205=(a205*a002);
  a206=(a205*a140);
  a201=(a201+a206);
  a206=1.5279233632882423e+01;
  a206=(a206*a002);
  a207=(a206*a165);
  a201=(a201+a207);
  a207=-3.3288210968984863e+01;
  a207=(a207*a002);
  a208=(a207*a192);
  a201=(a201+a208);
  a208=-2.0331201708508627e-02;
  a208=(a208*a002);
  a209=(a169*a033);
  a210=(a176*a078);
  a209=(a209+a210);
  a210=(a177*a107);
  a209=(a209+a210);
  a210=(a178*a131);
  a209=(a209+a210);
  a210=(a179*a156);
  a209=(a209+a210);
  a210=(a180*a183);
  a209=(a209+a210);
  a209=(a008+a209);
  a210=(a007*a209);
  a211=(a169*a008);
  a212=(a176*a042);
  a211=(a211+a212);
  a212=(a177*a104);
  a211=(a211+a212);
  a212=(a178*a129);
  a211=(a211+a212);
  a212=(a179*a154);
  a211=(a211+a212);
  a212=(a180*a181);
  a211=(a211+a212);
  a211=(a010+a211);
  a212=sin(a211);
  a210=(a210*a212);
  a213=(2.*a174);
  a214=(a209-a213);
  a210=(a210*a214);
  a214=(a169*a003);
  a215=(a176*a087);
  a214=(a214+a215);
  a215=(a177*a109);
  a214=(a214+a215);
  a215=(a178*a022);
  a214=(a214+a215);
  a215=(a179*a125);
  a214=(a214+a215);
  a215=(a180*a149);
  a214=(a214+a215);
  a214=(a000+a214);
  a215=sin(a214);
  a216=cos(a211);
  a217=(a215*a216);
  a214=cos(a214);
  a218=(a214*a212);
  a217=(a217-a218);
  a218=(a215-a217);
  a218=(a007*a218);
  a210=(a210+a218);
  a210=(a210+a215);
  a219=(a019-a216);
  a219=(a018*a219);
  a219=(a219+a019);
  a220=(a210/a219);
  a221=(a216-a019);
  a221=(a007*a221);
  a222=(a221/a219);
  a223=casadi_sq(a174);
  a223=(a223*a212);
  a223=(a223+a217);
  a223=(a007*a223);
  a217=arg[2]? arg[2][16] : 0;
  a224=(a027*a217);
  a225=arg[2]? arg[2][17] : 0;
  a226=(a031*a225);
  a224=(a224+a226);
  a224=(a026*a224);
  a224=(a209+a224);
  a224=(a015*a224);
  a217=(a031*a217);
  a225=(a027*a225);
  a217=(a217-a225);
  a217=(a217+a019);
  a217=(a025*a217);
  a217=(a030-a217);
  a217=(a217+a211);
  a217=(a029*a217);
  a224=(a224+a217);
  a223=(a223-a224);
  a224=(a222*a210);
  a224=(a223-a224);
  a217=(a221*a222);
  a217=(a007-a217);
  a211=(a224/a217);
  a225=(a034*a214);
  a226=(a225/a219);
  a221=(a221*a226);
  a227=(a221/a217);
  a210=(a226*a210);
  a228=(a034*a174);
  a228=(a228*a174);
  a228=(a228*a215);
  a229=(a169*a069);
  a230=(a176*a105);
  a229=(a229+a230);
  a230=(a177*a150);
  a229=(a229+a230);
  a230=(a178*a175);
  a229=(a229+a230);
  a230=(a179*a202);
  a229=(a229+a230);
  a230=(a144*a009);
  a231=(a084*a075);
  a230=(a230+a231);
  a231=(a151*a106);
  a230=(a230+a231);
  a231=(a152*a130);
  a230=(a230+a231);
  a231=(a153*a155);
  a230=(a230+a231);
  a230=(a069+a230);
  a231=(a180*a230);
  a229=(a229+a231);
  a229=(a040+a229);
  a229=(a039*a229);
  a228=(a228+a229);
  a210=(a210-a228);
  a224=(a227*a224);
  a210=(a210-a224);
  a225=(a225*a226);
  a225=(a034-a225);
  a221=(a221*a227);
  a225=(a225-a221);
  a210=(a210/a225);
  a221=(a227*a210);
  a211=(a211-a221);
  a221=(a222*a211);
  a220=(a220-a221);
  a221=(a226*a210);
  a220=(a220+a221);
  a221=(a208*a220);
  a201=(a201+a221);
  a201=(a003+a201);
  a221=(a193*a201);
  a004=(a004+a221);
  a221=2.0136540080403034e-01;
  a221=(a221*a002);
  a224=-9.3714243008598730e-01;
  a224=(a224*a002);
  a229=(a224*a021);
  a231=5.1863724288440638e+00;
  a231=(a231*a002);
  a232=(a231*a095);
  a229=(a229+a232);
  a232=1.0914373489967295e+00;
  a232=(a232*a002);
  a233=(a232*a116);
  a229=(a229+a233);
  a233=-8.1497870107469268e+00;
  a233=(a233*a002);
  a234=(a233*a140);
  a229=(a229+a234);
  a234=-1.8520065659996959e+01;
  a234=(a234*a002);
  a235=(a234*a165);
  a229=(a229+a235);
  a235=2.2739487099350505e+01;
  a235=(a235*a002);
  a236=(a235*a192);
  a229=(a229+a236);
  a236=2.4936055526796523e+00;
  a236=(a236*a002);
  a237=(a236*a220);
  a229=(a229+a237);
  a237=-3.0467644718982196e+00;
  a237=(a237*a002);
  a238=(a196*a033);
  a239=(a203*a078);
  a238=(a238+a239);
  a239=(a204*a107);
  a238=(a238+a239);
  a239=(a205*a131);
  a238=(a238+a239);
  a239=(a206*a156);
  a238=(a238+a239);
  a239=(a207*a183);
  a238=(a238+a239);
  a239=(a208*a211);
  a238=(a238+a239);
  a238=(a008+a238);
  a239=(a007*a238);
  a240=(a196*a008);
  a241=(a203*a042);
  a240=(a240+a241);
  a241=(a204*a104);
  a240=(a240+a241);
  a241=(a205*a129);
  a240=(a240+a241);
  a241=(a206*a154);
  a240=(a240+a241);
  a241=(a207*a181);
  a240=(a240+a241);
  a241=(a208*a209);
  a240=(a240+a241);
  a240=(a010+a240);
  a241=sin(a240);
  a239=(a239*a241);
  a242=(2.*a201);
  a243=(a238-a242);
  a239=(a239*a243);
  a243=(a196*a003);
  a244=(a203*a087);
  a243=(a243+a244);
  a244=(a204*a109);
  a243=(a243+a244);
  a244=(a205*a022);
  a243=(a243+a244);
  a244=(a206*a125);
  a243=(a243+a244);
  a244=(a207*a149);
  a243=(a243+a244);
  a244=(a208*a174);
  a243=(a243+a244);
  a243=(a000+a243);
  a244=sin(a243);
  a245=cos(a240);
  a246=(a244*a245);
  a243=cos(a243);
  a247=(a243*a241);
  a246=(a246-a247);
  a247=(a244-a246);
  a247=(a007*a247);
  a239=(a239+a247);
  a239=(a239+a244);
  a248=(a019-a245);
  a248=(a018*a248);
  a248=(a248+a019);
  a249=(a239/a248);
  a250=(a245-a019);
  a250=(a007*a250);
  a251=(a250/a248);
  a252=casadi_sq(a201);
  a252=(a252*a241);
  a252=(a252+a246);
  a252=(a007*a252);
  a246=arg[2]? arg[2][18] : 0;
  a253=(a027*a246);
  a254=arg[2]? arg[2][19] : 0;
  a255=(a031*a254);
  a253=(a253+a255);
  a253=(a026*a253);
  a253=(a238+a253);
  a253=(a015*a253);
  a246=(a031*a246);
  a254=(a027*a254);
  a246=(a246-a254);
  a246=(a246+a019);
  a246=(a025*a246);
  a246=(a030-a246);
  a246=(a246+a240);
  a246=(a029*a246);
  a253=(a253+a246);
  a252=(a252-a253);
  a253=(a251*a239);
  a253=(a252-a253);
  a246=(a250*a251);
  a246=(a007-a246);
  a240=(a253/a246);
  a254=(a034*a243);
  a255=(a254/a248);
  a250=(a250*a255);
  a256=(a250/a246);
  a239=(a255*a239);
  a257=(a034*a201);
  a257=(a257*a201);
  a257=(a257*a244);
  a258=(a196*a069);
  a259=(a203*a105);
  a258=(a258+a259);
  a259=(a204*a150);
  a258=(a258+a259);
  a259=(a205*a175);
  a258=(a258+a259);
  a259=(a206*a202);
  a258=(a258+a259);
  a259=(a207*a230);
  a258=(a258+a259);
  a259=(a169*a009);
  a260=(a176*a075);
  a259=(a259+a260);
  a260=(a177*a106);
  a259=(a259+a260);
  a260=(a178*a130);
  a259=(a259+a260);
  a260=(a179*a155);
  a259=(a259+a260);
  a260=(a180*a182);
  a259=(a259+a260);
  a259=(a069+a259);
  a260=(a208*a259);
  a258=(a258+a260);
  a258=(a040+a258);
  a258=(a039*a258);
  a257=(a257+a258);
  a239=(a239-a257);
  a253=(a256*a253);
  a239=(a239-a253);
  a254=(a254*a255);
  a254=(a034-a254);
  a250=(a250*a256);
  a254=(a254-a250);
  a239=(a239/a254);
  a250=(a256*a239);
  a240=(a240-a250);
  a250=(a251*a240);
  a249=(a249-a250);
  a250=(a255*a239);
  a249=(a249+a250);
  a250=(a237*a249);
  a229=(a229+a250);
  a229=(a003+a229);
  a250=(a221*a229);
  a004=(a004+a250);
  a250=4.4710615727772587e-02;
  a250=(a250*a002);
  a253=2.2733101475165380e+00;
  a253=(a253*a002);
  a258=(a253*a021);
  a260=-1.0534495466737249e+01;
  a260=(a260*a002);
  a095=(a260*a095);
  a258=(a258+a095);
  a095=-2.0008720582248625e+00;
  a095=(a095*a002);
  a116=(a095*a116);
  a258=(a258+a116);
  a116=-1.7958931863118799e+01;
  a116=(a116*a002);
  a261=(a116*a140);
  a258=(a258+a261);
  a261=2.7948884529419960e+01;
  a261=(a261*a002);
  a262=(a261*a165);
  a258=(a258+a262);
  a262=-2.8589982771350235e+00;
  a262=(a262*a002);
  a263=(a262*a192);
  a258=(a258+a263);
  a263=-8.8728569335306293e+00;
  a263=(a263*a002);
  a264=(a263*a220);
  a258=(a258+a264);
  a264=1.2360567175794303e+01;
  a264=(a264*a002);
  a265=(a264*a249);
  a258=(a258+a265);
  a265=6.4339274601576357e-01;
  a265=(a265*a002);
  a002=(a224*a033);
  a266=(a231*a078);
  a002=(a002+a266);
  a266=(a232*a107);
  a002=(a002+a266);
  a266=(a233*a131);
  a002=(a002+a266);
  a266=(a234*a156);
  a002=(a002+a266);
  a266=(a235*a183);
  a002=(a002+a266);
  a266=(a236*a211);
  a002=(a002+a266);
  a266=(a237*a240);
  a002=(a002+a266);
  a002=(a008+a002);
  a266=(a007*a002);
  a267=(a224*a008);
  a268=(a231*a042);
  a267=(a267+a268);
  a268=(a232*a104);
  a267=(a267+a268);
  a268=(a233*a129);
  a267=(a267+a268);
  a268=(a234*a154);
  a267=(a267+a268);
  a268=(a235*a181);
  a267=(a267+a268);
  a268=(a236*a209);
  a267=(a267+a268);
  a268=(a237*a238);
  a267=(a267+a268);
  a267=(a010+a267);
  a268=sin(a267);
  a266=(a266*a268);
  a269=(2.*a229);
  a270=(a002-a269);
  a266=(a266*a270);
  a270=(a224*a003);
  a271=(a231*a087);
  a270=(a270+a271);
  a271=(a232*a109);
  a270=(a270+a271);
  a271=(a233*a022);
  a270=(a270+a271);
  a271=(a234*a125);
  a270=(a270+a271);
  a271=(a235*a149);
  a270=(a270+a271);
  a271=(a236*a174);
  a270=(a270+a271);
  a271=(a237*a201);
  a270=(a270+a271);
  a270=(a000+a270);
  a271=sin(a270);
  a272=cos(a267);
  a273=(a271*a272);
  a270=cos(a270);
  a274=(a270*a268);
  a273=(a273-a274);
  a274=(a271-a273);
  a274=(a007*a274);
  a266=(a266+a274);
  a266=(a266+a271);
  a275=(a019-a272);
  a275=(a018*a275);
  a275=(a275+a019);
  a276=(a266/a275);
  a277=(a272-a019);
  a277=(a007*a277);
  a278=(a277/a275);
  a279=casadi_sq(a229);
  a279=(a279*a268);
  a279=(a279+a273);
  a279=(a007*a279);
  a273=arg[2]? arg[2][20] : 0;
  a280=(a027*a273);
  a281=arg[2]? arg[2][21] : 0;
  a282=(a031*a281);
  a280=(a280+a282);
  a280=(a026*a280);
  a280=(a002+a280);
  a280=(a015*a280);
  a273=(a031*a273);
  a281=(a027*a281);
  a273=(a273-a281);
  a273=(a273+a019);
  a273=(a025*a273);
  a273=(a030-a273);
  a273=(a273+a267);
  a273=(a029*a273);
  a280=(a280+a273);
  a279=(a279-a280);
  a280=(a278*a266);
  a280=(a279-a280);
  a273=(a277*a278);
  a273=(a007-a273);
  a267=(a280/a273);
  a281=(a034*a270);
  a282=(a281/a275);
  a277=(a277*a282);
  a283=(a277/a273);
  a266=(a282*a266);
  a284=(a034*a229);
  a284=(a284*a229);
  a284=(a284*a271);
  a285=(a224*a069);
  a286=(a231*a105);
  a285=(a285+a286);
  a286=(a232*a150);
  a285=(a285+a286);
  a286=(a233*a175);
  a285=(a285+a286);
  a286=(a234*a202);
  a285=(a285+a286);
  a286=(a235*a230);
  a285=(a285+a286);
  a286=(a236*a259);
  a285=(a285+a286);
  a286=(a196*a009);
  a287=(a203*a075);
  a286=(a286+a287);
  a287=(a204*a106);
  a286=(a286+a287);
  a287=(a205*a130);
  a286=(a286+a287);
  a287=(a206*a155);
  a286=(a286+a287);
  a287=(a207*a182);
  a286=(a286+a287);
  a287=(a208*a210);
  a286=(a286+a287);
  a286=(a069+a286);
  a287=(a237*a286);
  a285=(a285+a287);
  a285=(a040+a285);
  a285=(a039*a285);
  a284=(a284+a285);
  a266=(a266-a284);
  a280=(a283*a280);
  a266=(a266-a280);
  a281=(a281*a282);
  a281=(a034-a281);
  a277=(a277*a283);
  a281=(a281-a277);
  a266=(a266/a281);
  a277=(a283*a266);
  a267=(a267-a277);
  a277=(a278*a267);
  a276=(a276-a277);
  a277=(a282*a266);
  a276=(a276+a277);
  a277=(a265*a276);
  a258=(a258+a277);
  a258=(a003+a258);
  a277=(a250*a258);
  a004=(a004+a277);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a277=(a005*a129);
  a004=(a004+a277);
  a277=(a117*a154);
  a004=(a004+a277);
  a277=(a141*a181);
  a004=(a004+a277);
  a277=(a166*a209);
  a004=(a004+a277);
  a277=(a193*a238);
  a004=(a004+a277);
  a277=(a221*a002);
  a004=(a004+a277);
  a277=(a253*a033);
  a078=(a260*a078);
  a277=(a277+a078);
  a107=(a095*a107);
  a277=(a277+a107);
  a107=(a116*a131);
  a277=(a277+a107);
  a107=(a261*a156);
  a277=(a277+a107);
  a107=(a262*a183);
  a277=(a277+a107);
  a107=(a263*a211);
  a277=(a277+a107);
  a107=(a264*a240);
  a277=(a277+a107);
  a107=(a265*a267);
  a277=(a277+a107);
  a277=(a008+a277);
  a107=(a250*a277);
  a004=(a004+a107);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a069);
  a107=(a005*a175);
  a004=(a004+a107);
  a107=(a117*a202);
  a004=(a004+a107);
  a107=(a141*a230);
  a004=(a004+a107);
  a107=(a166*a259);
  a004=(a004+a107);
  a107=(a193*a286);
  a004=(a004+a107);
  a107=(a224*a009);
  a078=(a231*a075);
  a107=(a107+a078);
  a078=(a232*a106);
  a107=(a107+a078);
  a078=(a233*a130);
  a107=(a107+a078);
  a078=(a234*a155);
  a107=(a107+a078);
  a078=(a235*a182);
  a107=(a107+a078);
  a078=(a236*a210);
  a107=(a107+a078);
  a078=(a237*a239);
  a107=(a107+a078);
  a107=(a069+a107);
  a078=(a221*a107);
  a004=(a004+a078);
  a078=(a253*a009);
  a075=(a260*a075);
  a078=(a078+a075);
  a106=(a095*a106);
  a078=(a078+a106);
  a106=(a116*a130);
  a078=(a078+a106);
  a106=(a261*a155);
  a078=(a078+a106);
  a106=(a262*a182);
  a078=(a078+a106);
  a106=(a263*a210);
  a078=(a078+a106);
  a106=(a264*a239);
  a078=(a078+a106);
  a106=(a265*a266);
  a078=(a078+a106);
  a078=(a069+a078);
  a078=(a250*a078);
  a004=(a004+a078);
  a004=(a040+a004);
  if (res[0]!=0) res[0][2]=a004;
  a021=(a001*a021);
  a140=(a005*a140);
  a021=(a021+a140);
  a165=(a117*a165);
  a021=(a021+a165);
  a192=(a141*a192);
  a021=(a021+a192);
  a220=(a166*a220);
  a021=(a021+a220);
  a249=(a193*a249);
  a021=(a021+a249);
  a276=(a221*a276);
  a021=(a021+a276);
  a276=(a007*a277);
  a249=(a253*a008);
  a220=(a260*a042);
  a249=(a249+a220);
  a220=(a095*a104);
  a249=(a249+a220);
  a220=(a116*a129);
  a249=(a249+a220);
  a220=(a261*a154);
  a249=(a249+a220);
  a220=(a262*a181);
  a249=(a249+a220);
  a220=(a263*a209);
  a249=(a249+a220);
  a220=(a264*a238);
  a249=(a249+a220);
  a220=(a265*a002);
  a249=(a249+a220);
  a010=(a010+a249);
  a249=sin(a010);
  a276=(a276*a249);
  a220=(2.*a258);
  a192=(a277-a220);
  a276=(a276*a192);
  a192=(a253*a003);
  a165=(a260*a087);
  a192=(a192+a165);
  a165=(a095*a109);
  a192=(a192+a165);
  a165=(a116*a022);
  a192=(a192+a165);
  a165=(a261*a125);
  a192=(a192+a165);
  a165=(a262*a149);
  a192=(a192+a165);
  a165=(a263*a174);
  a192=(a192+a165);
  a165=(a264*a201);
  a192=(a192+a165);
  a165=(a265*a229);
  a192=(a192+a165);
  a000=(a000+a192);
  a192=sin(a000);
  a165=cos(a010);
  a140=(a192*a165);
  a000=cos(a000);
  a004=(a000*a249);
  a140=(a140-a004);
  a004=(a192-a140);
  a004=(a007*a004);
  a276=(a276+a004);
  a276=(a276+a192);
  a078=(a019-a165);
  a078=(a018*a078);
  a078=(a078+a019);
  a106=(a276/a078);
  a075=(a165-a019);
  a075=(a007*a075);
  a280=(a075/a078);
  a285=casadi_sq(a258);
  a285=(a285*a249);
  a285=(a285+a140);
  a285=(a007*a285);
  a140=arg[2]? arg[2][22] : 0;
  a287=(a027*a140);
  a288=arg[2]? arg[2][23] : 0;
  a289=(a031*a288);
  a287=(a287+a289);
  a026=(a026*a287);
  a026=(a277+a026);
  a026=(a015*a026);
  a031=(a031*a140);
  a027=(a027*a288);
  a031=(a031-a027);
  a031=(a031+a019);
  a025=(a025*a031);
  a030=(a030-a025);
  a030=(a030+a010);
  a030=(a029*a030);
  a026=(a026+a030);
  a285=(a285-a026);
  a026=(a280*a276);
  a026=(a285-a026);
  a030=(a075*a280);
  a030=(a007-a030);
  a010=(a026/a030);
  a025=(a034*a000);
  a031=(a025/a078);
  a075=(a075*a031);
  a019=(a075/a030);
  a276=(a031*a276);
  a027=(a034*a258);
  a027=(a027*a258);
  a027=(a027*a192);
  a288=(a253*a069);
  a105=(a260*a105);
  a288=(a288+a105);
  a150=(a095*a150);
  a288=(a288+a150);
  a175=(a116*a175);
  a288=(a288+a175);
  a202=(a261*a202);
  a288=(a288+a202);
  a230=(a262*a230);
  a288=(a288+a230);
  a259=(a263*a259);
  a288=(a288+a259);
  a286=(a264*a286);
  a288=(a288+a286);
  a107=(a265*a107);
  a288=(a288+a107);
  a040=(a040+a288);
  a040=(a039*a040);
  a027=(a027+a040);
  a276=(a276-a027);
  a026=(a019*a026);
  a276=(a276-a026);
  a025=(a025*a031);
  a025=(a034-a025);
  a075=(a075*a019);
  a025=(a025-a075);
  a276=(a276/a025);
  a075=(a019*a276);
  a010=(a010-a075);
  a075=(a280*a010);
  a106=(a106-a075);
  a075=(a031*a276);
  a106=(a106+a075);
  a106=(a250*a106);
  a021=(a021+a106);
  a021=(a003+a021);
  if (res[0]!=0) res[0][3]=a021;
  a033=(a001*a033);
  a131=(a005*a131);
  a033=(a033+a131);
  a156=(a117*a156);
  a033=(a033+a156);
  a183=(a141*a183);
  a033=(a033+a183);
  a211=(a166*a211);
  a033=(a033+a211);
  a240=(a193*a240);
  a033=(a033+a240);
  a267=(a221*a267);
  a033=(a033+a267);
  a010=(a250*a010);
  a033=(a033+a010);
  a033=(a008+a033);
  if (res[0]!=0) res[0][4]=a033;
  a009=(a001*a009);
  a130=(a005*a130);
  a009=(a009+a130);
  a155=(a117*a155);
  a009=(a009+a155);
  a182=(a141*a182);
  a009=(a009+a182);
  a210=(a166*a210);
  a009=(a009+a210);
  a239=(a193*a239);
  a009=(a009+a239);
  a266=(a221*a266);
  a009=(a009+a266);
  a276=(a250*a276);
  a009=(a009+a276);
  a069=(a069+a009);
  if (res[0]!=0) res[0][5]=a069;
  a069=arg[0]? arg[0][6] : 0;
  a009=arg[0]? arg[0][9] : 0;
  a276=(a001*a009);
  a266=(a016*a014);
  a239=(a013*a011);
  a266=(a266+a239);
  a239=(a016-a266);
  a239=(a007*a239);
  a210=(a007*a011);
  a012=(a012-a008);
  a012=(a008*a012);
  a210=(a210*a012);
  a017=(a017-a210);
  a017=(a017+a013);
  a210=(a036*a017);
  a210=(a210-a038);
  a038=(a023*a017);
  a024=(a024-a038);
  a038=(a037*a024);
  a210=(a210-a038);
  a210=(a210/a035);
  a038=(a210*a034);
  a038=(a038*a013);
  a239=(a239-a038);
  a239=(a239+a016);
  a038=(a239/a020);
  a182=(a007*a266);
  a155=(a023*a239);
  a182=(a182-a155);
  a155=(a182/a032);
  a239=(a036*a239);
  a017=(a017/a020);
  a024=(a024/a032);
  a130=(a037*a210);
  a024=(a024-a130);
  a130=(a023*a024);
  a017=(a017-a130);
  a210=(a036*a210);
  a017=(a017+a210);
  a210=(a017*a013);
  a016=(a016*a003);
  a016=(a016*a003);
  a210=(a210+a016);
  a210=(a034*a210);
  a239=(a239-a210);
  a182=(a037*a182);
  a239=(a239-a182);
  a239=(a239/a035);
  a182=(a037*a239);
  a155=(a155-a182);
  a182=(a023*a155);
  a038=(a038-a182);
  a182=(a036*a239);
  a038=(a038+a182);
  a182=(a038*a069);
  a024=(a024*a011);
  a210=(2.*a017);
  a210=(a210*a011);
  a024=(a024-a210);
  a024=(a024+a266);
  a012=(a014*a012);
  a024=(a024-a012);
  a024=(a007*a024);
  a012=(a024/a020);
  a017=(a017*a011);
  a017=(a017-a266);
  a014=(a014*a003);
  a014=(a014*a003);
  a017=(a017+a014);
  a017=(a007*a017);
  a017=(a017-a029);
  a014=(a023*a024);
  a017=(a017-a014);
  a014=(a017/a032);
  a024=(a036*a024);
  a017=(a037*a017);
  a024=(a024-a017);
  a024=(a024/a035);
  a017=(a037*a024);
  a014=(a014-a017);
  a017=(a023*a014);
  a012=(a012-a017);
  a017=(a036*a024);
  a012=(a012+a017);
  a017=arg[0]? arg[0][7] : 0;
  a266=(a012*a017);
  a182=(a182+a266);
  a266=(a039/a035);
  a210=(a037*a266);
  a016=(a023*a210);
  a130=(a036*a266);
  a016=(a016+a130);
  a130=arg[0]? arg[0][8] : 0;
  a033=(a016*a130);
  a182=(a182-a033);
  a033=-2.;
  a010=(a033*a007);
  a267=(a010*a008);
  a267=(a267*a011);
  a240=(a267/a020);
  a211=(a018*a003);
  a211=(a211*a011);
  a183=(a023*a267);
  a211=(a211-a183);
  a183=(a211/a032);
  a033=(a033*a034);
  a156=(a033*a003);
  a156=(a156*a013);
  a267=(a036*a267);
  a156=(a156+a267);
  a211=(a037*a211);
  a156=(a156-a211);
  a156=(a156/a035);
  a211=(a037*a156);
  a183=(a183-a211);
  a211=(a023*a183);
  a240=(a240-a211);
  a211=(a036*a156);
  a240=(a240+a211);
  a211=(a240*a009);
  a011=(a018*a011);
  a008=(a008-a003);
  a011=(a011*a008);
  a020=(a011/a020);
  a008=(a023*a011);
  a008=(a015+a008);
  a032=(a008/a032);
  a011=(a036*a011);
  a008=(a037*a008);
  a011=(a011+a008);
  a011=(a011/a035);
  a037=(a037*a011);
  a032=(a032+a037);
  a023=(a023*a032);
  a020=(a020+a023);
  a036=(a036*a011);
  a020=(a020+a036);
  a036=arg[0]? arg[0][10] : 0;
  a023=(a020*a036);
  a211=(a211+a023);
  a182=(a182+a211);
  a211=(a006*a182);
  a023=(a089*a091);
  a037=(a090*a086);
  a023=(a023+a037);
  a037=(a089-a023);
  a037=(a007*a037);
  a035=(a007*a086);
  a088=(a088-a042);
  a088=(a042*a088);
  a035=(a035*a088);
  a093=(a093-a035);
  a093=(a093+a090);
  a035=(a101*a093);
  a035=(a035-a103);
  a103=(a097*a093);
  a098=(a098-a103);
  a103=(a102*a098);
  a035=(a035-a103);
  a035=(a035/a100);
  a103=(a035*a034);
  a103=(a103*a090);
  a037=(a037-a103);
  a037=(a037+a089);
  a103=(a037/a094);
  a008=(a007*a023);
  a003=(a097*a037);
  a008=(a008-a003);
  a003=(a008/a092);
  a037=(a101*a037);
  a093=(a093/a094);
  a098=(a098/a092);
  a267=(a102*a035);
  a098=(a098-a267);
  a267=(a097*a098);
  a093=(a093-a267);
  a035=(a101*a035);
  a093=(a093+a035);
  a035=(a093*a090);
  a089=(a089*a087);
  a089=(a089*a087);
  a035=(a035+a089);
  a035=(a034*a035);
  a037=(a037-a035);
  a008=(a102*a008);
  a037=(a037-a008);
  a037=(a037/a100);
  a008=(a102*a037);
  a003=(a003-a008);
  a008=(a097*a003);
  a103=(a103-a008);
  a008=(a101*a037);
  a103=(a103+a008);
  a008=(a041*a009);
  a035=(a044*a182);
  a089=(a054*a056);
  a267=(a055*a051);
  a089=(a089+a267);
  a267=(a054-a089);
  a267=(a007*a267);
  a013=(a007*a051);
  a053=(a053-a048);
  a053=(a048*a053);
  a013=(a013*a053);
  a058=(a058-a013);
  a058=(a058+a055);
  a013=(a066*a058);
  a013=(a013-a068);
  a068=(a062*a058);
  a063=(a063-a068);
  a068=(a067*a063);
  a013=(a013-a068);
  a013=(a013/a065);
  a068=(a013*a034);
  a068=(a068*a055);
  a267=(a267-a068);
  a267=(a267+a054);
  a068=(a267/a059);
  a131=(a007*a089);
  a021=(a062*a267);
  a131=(a131-a021);
  a021=(a131/a057);
  a267=(a066*a267);
  a058=(a058/a059);
  a063=(a063/a057);
  a106=(a067*a013);
  a063=(a063-a106);
  a106=(a062*a063);
  a058=(a058-a106);
  a013=(a066*a013);
  a058=(a058+a013);
  a013=(a058*a055);
  a054=(a054*a052);
  a054=(a054*a052);
  a013=(a013+a054);
  a013=(a034*a013);
  a267=(a267-a013);
  a131=(a067*a131);
  a267=(a267-a131);
  a267=(a267/a065);
  a131=(a067*a267);
  a021=(a021-a131);
  a131=(a062*a021);
  a068=(a068-a131);
  a131=(a066*a267);
  a068=(a068+a131);
  a131=(a047*a009);
  a131=(a069+a131);
  a013=(a068*a131);
  a063=(a063*a051);
  a054=(2.*a058);
  a054=(a054*a051);
  a063=(a063-a054);
  a063=(a063+a089);
  a053=(a056*a053);
  a063=(a063-a053);
  a063=(a007*a063);
  a053=(a063/a059);
  a058=(a058*a051);
  a058=(a058-a089);
  a056=(a056*a052);
  a056=(a056*a052);
  a058=(a058+a056);
  a058=(a007*a058);
  a058=(a058-a029);
  a056=(a062*a063);
  a058=(a058-a056);
  a056=(a058/a057);
  a063=(a066*a063);
  a058=(a067*a058);
  a063=(a063-a058);
  a063=(a063/a065);
  a058=(a067*a063);
  a056=(a056-a058);
  a058=(a062*a056);
  a053=(a053-a058);
  a058=(a066*a063);
  a053=(a053+a058);
  a058=(a047*a036);
  a058=(a017+a058);
  a089=(a053*a058);
  a013=(a013+a089);
  a089=(a039/a065);
  a054=(a067*a089);
  a106=(a062*a054);
  a075=(a066*a089);
  a106=(a106+a075);
  a075=arg[0]? arg[0][11] : 0;
  a026=(a047*a075);
  a026=(a130+a026);
  a040=(a106*a026);
  a013=(a013-a040);
  a040=(a010*a048);
  a040=(a040*a051);
  a288=(a040/a059);
  a107=(a018*a052);
  a107=(a107*a051);
  a286=(a062*a040);
  a107=(a107-a286);
  a286=(a107/a057);
  a259=(a033*a052);
  a259=(a259*a055);
  a040=(a066*a040);
  a259=(a259+a040);
  a107=(a067*a107);
  a259=(a259-a107);
  a259=(a259/a065);
  a107=(a067*a259);
  a286=(a286-a107);
  a107=(a062*a286);
  a288=(a288-a107);
  a107=(a066*a259);
  a288=(a288+a107);
  a107=(a047*a182);
  a107=(a009+a107);
  a040=(a288*a107);
  a051=(a018*a051);
  a048=(a048-a052);
  a051=(a051*a048);
  a059=(a051/a059);
  a048=(a062*a051);
  a048=(a015+a048);
  a057=(a048/a057);
  a051=(a066*a051);
  a048=(a067*a048);
  a051=(a051+a048);
  a051=(a051/a065);
  a067=(a067*a051);
  a057=(a057+a067);
  a062=(a062*a057);
  a059=(a059+a062);
  a066=(a066*a051);
  a059=(a059+a066);
  a066=(a155*a069);
  a062=(a014*a017);
  a066=(a066+a062);
  a062=(a210*a130);
  a066=(a066+a062);
  a062=(a183*a009);
  a067=(a032*a036);
  a062=(a062-a067);
  a066=(a066+a062);
  a062=(a047*a066);
  a062=(a036+a062);
  a067=(a059*a062);
  a040=(a040+a067);
  a013=(a013+a040);
  a013=(a046*a013);
  a035=(a035+a013);
  a035=(a009+a035);
  a013=(a043*a035);
  a008=(a008+a013);
  a008=(a069+a008);
  a013=(a103*a008);
  a098=(a098*a086);
  a040=(2.*a093);
  a040=(a040*a086);
  a098=(a098-a040);
  a098=(a098+a023);
  a088=(a091*a088);
  a098=(a098-a088);
  a098=(a007*a098);
  a088=(a098/a094);
  a093=(a093*a086);
  a093=(a093-a023);
  a091=(a091*a087);
  a091=(a091*a087);
  a093=(a093+a091);
  a093=(a007*a093);
  a093=(a093-a029);
  a091=(a097*a098);
  a093=(a093-a091);
  a091=(a093/a092);
  a098=(a101*a098);
  a093=(a102*a093);
  a098=(a098-a093);
  a098=(a098/a100);
  a093=(a102*a098);
  a091=(a091-a093);
  a093=(a097*a091);
  a088=(a088-a093);
  a093=(a101*a098);
  a088=(a088+a093);
  a093=(a041*a036);
  a023=(a044*a066);
  a040=(a021*a131);
  a067=(a056*a058);
  a040=(a040+a067);
  a067=(a054*a026);
  a040=(a040+a067);
  a067=(a286*a107);
  a065=(a057*a062);
  a067=(a067-a065);
  a040=(a040+a067);
  a040=(a046*a040);
  a023=(a023+a040);
  a023=(a036+a023);
  a040=(a043*a023);
  a093=(a093+a040);
  a093=(a017+a093);
  a040=(a088*a093);
  a013=(a013+a040);
  a040=(a039/a100);
  a067=(a102*a040);
  a065=(a097*a067);
  a048=(a101*a040);
  a065=(a065+a048);
  a048=(a041*a075);
  a052=(a239*a069);
  a055=(a024*a017);
  a052=(a052+a055);
  a055=(a266*a130);
  a052=(a052-a055);
  a055=(a156*a009);
  a230=(a011*a036);
  a055=(a055+a230);
  a052=(a052+a055);
  a055=(a044*a052);
  a131=(a267*a131);
  a058=(a063*a058);
  a131=(a131+a058);
  a026=(a089*a026);
  a131=(a131-a026);
  a026=(a259*a107);
  a058=(a051*a062);
  a026=(a026+a058);
  a131=(a131+a026);
  a131=(a046*a131);
  a055=(a055+a131);
  a055=(a075+a055);
  a131=(a043*a055);
  a048=(a048+a131);
  a048=(a130+a048);
  a131=(a065*a048);
  a013=(a013-a131);
  a131=(a010*a042);
  a131=(a131*a086);
  a026=(a131/a094);
  a058=(a018*a087);
  a058=(a058*a086);
  a230=(a097*a131);
  a058=(a058-a230);
  a230=(a058/a092);
  a202=(a033*a087);
  a202=(a202*a090);
  a131=(a101*a131);
  a202=(a202+a131);
  a058=(a102*a058);
  a202=(a202-a058);
  a202=(a202/a100);
  a058=(a102*a202);
  a230=(a230-a058);
  a058=(a097*a230);
  a026=(a026-a058);
  a058=(a101*a202);
  a026=(a026+a058);
  a058=(a041*a182);
  a131=(a070*a072);
  a090=(a071*a064);
  a131=(a131+a090);
  a090=(a070-a131);
  a090=(a007*a090);
  a175=(a007*a064);
  a077=(a077-a074);
  a077=(a074*a077);
  a175=(a175*a077);
  a073=(a073-a175);
  a073=(a073+a071);
  a175=(a082*a073);
  a175=(a175-a085);
  a085=(a061*a073);
  a060=(a060-a085);
  a085=(a083*a060);
  a175=(a175-a085);
  a175=(a175/a081);
  a085=(a175*a034);
  a085=(a085*a071);
  a090=(a090-a085);
  a090=(a090+a070);
  a085=(a090/a050);
  a150=(a007*a131);
  a105=(a061*a090);
  a150=(a150-a105);
  a105=(a150/a079);
  a090=(a082*a090);
  a073=(a073/a050);
  a060=(a060/a079);
  a140=(a083*a175);
  a060=(a060-a140);
  a140=(a061*a060);
  a073=(a073-a140);
  a175=(a082*a175);
  a073=(a073+a175);
  a175=(a073*a071);
  a070=(a070*a045);
  a070=(a070*a045);
  a175=(a175+a070);
  a175=(a034*a175);
  a090=(a090-a175);
  a150=(a083*a150);
  a090=(a090-a150);
  a090=(a090/a081);
  a150=(a083*a090);
  a105=(a105-a150);
  a150=(a061*a105);
  a085=(a085-a150);
  a150=(a082*a090);
  a085=(a085+a150);
  a150=(a044*a009);
  a107=(a046*a107);
  a150=(a150+a107);
  a150=(a069+a150);
  a107=(a085*a150);
  a060=(a060*a064);
  a175=(2.*a073);
  a175=(a175*a064);
  a060=(a060-a175);
  a060=(a060+a131);
  a077=(a072*a077);
  a060=(a060-a077);
  a060=(a007*a060);
  a077=(a060/a050);
  a073=(a073*a064);
  a073=(a073-a131);
  a072=(a072*a045);
  a072=(a072*a045);
  a073=(a073+a072);
  a073=(a007*a073);
  a073=(a073-a029);
  a072=(a061*a060);
  a073=(a073-a072);
  a072=(a073/a079);
  a060=(a082*a060);
  a073=(a083*a073);
  a060=(a060-a073);
  a060=(a060/a081);
  a073=(a083*a060);
  a072=(a072-a073);
  a073=(a061*a072);
  a077=(a077-a073);
  a073=(a082*a060);
  a077=(a077+a073);
  a073=(a044*a036);
  a062=(a046*a062);
  a073=(a073+a062);
  a073=(a017+a073);
  a062=(a077*a073);
  a107=(a107+a062);
  a062=(a039/a081);
  a131=(a083*a062);
  a175=(a061*a131);
  a070=(a082*a062);
  a175=(a175+a070);
  a070=(a044*a075);
  a140=(a047*a052);
  a140=(a075+a140);
  a140=(a046*a140);
  a070=(a070+a140);
  a070=(a130+a070);
  a140=(a175*a070);
  a107=(a107-a140);
  a140=(a010*a074);
  a140=(a140*a064);
  a287=(a140/a050);
  a289=(a018*a045);
  a289=(a289*a064);
  a290=(a061*a140);
  a289=(a289-a290);
  a290=(a289/a079);
  a291=(a033*a045);
  a291=(a291*a071);
  a140=(a082*a140);
  a291=(a291+a140);
  a289=(a083*a289);
  a291=(a291-a289);
  a291=(a291/a081);
  a289=(a083*a291);
  a290=(a290-a289);
  a289=(a061*a290);
  a287=(a287-a289);
  a289=(a082*a291);
  a287=(a287+a289);
  a289=(a287*a035);
  a064=(a018*a064);
  a074=(a074-a045);
  a064=(a064*a074);
  a050=(a064/a050);
  a074=(a061*a064);
  a074=(a015+a074);
  a079=(a074/a079);
  a064=(a082*a064);
  a074=(a083*a074);
  a064=(a064+a074);
  a064=(a064/a081);
  a083=(a083*a064);
  a079=(a079+a083);
  a061=(a061*a079);
  a050=(a050+a061);
  a082=(a082*a064);
  a050=(a050+a082);
  a082=(a050*a023);
  a289=(a289+a082);
  a107=(a107+a289);
  a289=(a043*a107);
  a058=(a058+a289);
  a058=(a009+a058);
  a289=(a026*a058);
  a086=(a018*a086);
  a042=(a042-a087);
  a086=(a086*a042);
  a094=(a086/a094);
  a042=(a097*a086);
  a042=(a015+a042);
  a092=(a042/a092);
  a086=(a101*a086);
  a042=(a102*a042);
  a086=(a086+a042);
  a086=(a086/a100);
  a102=(a102*a086);
  a092=(a092+a102);
  a097=(a097*a092);
  a094=(a094+a097);
  a101=(a101*a086);
  a094=(a094+a101);
  a101=(a041*a066);
  a097=(a105*a150);
  a102=(a072*a073);
  a097=(a097+a102);
  a102=(a131*a070);
  a097=(a097+a102);
  a102=(a290*a035);
  a100=(a079*a023);
  a102=(a102-a100);
  a097=(a097+a102);
  a102=(a043*a097);
  a101=(a101+a102);
  a101=(a036+a101);
  a102=(a094*a101);
  a289=(a289+a102);
  a013=(a013+a289);
  a289=(a028*a013);
  a211=(a211+a289);
  a289=(a110*a112);
  a102=(a111*a108);
  a289=(a289+a102);
  a102=(a110-a289);
  a102=(a007*a102);
  a100=(a007*a108);
  a076=(a076-a104);
  a076=(a104*a076);
  a100=(a100*a076);
  a114=(a114-a100);
  a114=(a114+a111);
  a100=(a122*a114);
  a100=(a100-a124);
  a124=(a118*a114);
  a119=(a119-a124);
  a124=(a123*a119);
  a100=(a100-a124);
  a100=(a100/a121);
  a124=(a100*a034);
  a124=(a124*a111);
  a102=(a102-a124);
  a102=(a102+a110);
  a124=(a102/a115);
  a042=(a007*a289);
  a087=(a118*a102);
  a042=(a042-a087);
  a087=(a042/a113);
  a102=(a122*a102);
  a114=(a114/a115);
  a119=(a119/a113);
  a082=(a123*a100);
  a119=(a119-a082);
  a082=(a118*a119);
  a114=(a114-a082);
  a100=(a122*a100);
  a114=(a114+a100);
  a100=(a114*a111);
  a110=(a110*a109);
  a110=(a110*a109);
  a100=(a100+a110);
  a100=(a034*a100);
  a102=(a102-a100);
  a042=(a123*a042);
  a102=(a102-a042);
  a102=(a102/a121);
  a042=(a123*a102);
  a087=(a087-a042);
  a042=(a118*a087);
  a124=(a124-a042);
  a042=(a122*a102);
  a124=(a124+a042);
  a042=(a099*a009);
  a100=(a049*a035);
  a042=(a042+a100);
  a100=(a080*a058);
  a042=(a042+a100);
  a042=(a069+a042);
  a100=(a124*a042);
  a119=(a119*a108);
  a110=(2.*a114);
  a110=(a110*a108);
  a119=(a119-a110);
  a119=(a119+a289);
  a076=(a112*a076);
  a119=(a119-a076);
  a119=(a007*a119);
  a076=(a119/a115);
  a114=(a114*a108);
  a114=(a114-a289);
  a112=(a112*a109);
  a112=(a112*a109);
  a114=(a114+a112);
  a114=(a007*a114);
  a114=(a114-a029);
  a112=(a118*a119);
  a114=(a114-a112);
  a112=(a114/a113);
  a119=(a122*a119);
  a114=(a123*a114);
  a119=(a119-a114);
  a119=(a119/a121);
  a114=(a123*a119);
  a112=(a112-a114);
  a114=(a118*a112);
  a076=(a076-a114);
  a114=(a122*a119);
  a076=(a076+a114);
  a114=(a099*a036);
  a289=(a049*a023);
  a114=(a114+a289);
  a289=(a080*a101);
  a114=(a114+a289);
  a114=(a017+a114);
  a289=(a076*a114);
  a100=(a100+a289);
  a289=(a039/a121);
  a110=(a123*a289);
  a082=(a118*a110);
  a061=(a122*a289);
  a082=(a082+a061);
  a061=(a099*a075);
  a055=(a049*a055);
  a061=(a061+a055);
  a055=(a041*a052);
  a150=(a090*a150);
  a073=(a060*a073);
  a150=(a150+a073);
  a070=(a062*a070);
  a150=(a150-a070);
  a035=(a291*a035);
  a023=(a064*a023);
  a035=(a035+a023);
  a150=(a150+a035);
  a035=(a043*a150);
  a055=(a055+a035);
  a055=(a075+a055);
  a035=(a080*a055);
  a061=(a061+a035);
  a061=(a130+a061);
  a035=(a082*a061);
  a100=(a100-a035);
  a035=(a010*a104);
  a035=(a035*a108);
  a023=(a035/a115);
  a070=(a018*a109);
  a070=(a070*a108);
  a073=(a118*a035);
  a070=(a070-a073);
  a073=(a070/a113);
  a083=(a033*a109);
  a083=(a083*a111);
  a035=(a122*a035);
  a083=(a083+a035);
  a070=(a123*a070);
  a083=(a083-a070);
  a083=(a083/a121);
  a070=(a123*a083);
  a073=(a073-a070);
  a070=(a118*a073);
  a023=(a023-a070);
  a070=(a122*a083);
  a023=(a023+a070);
  a070=(a099*a182);
  a107=(a049*a107);
  a070=(a070+a107);
  a107=(a080*a013);
  a070=(a070+a107);
  a070=(a009+a070);
  a107=(a023*a070);
  a108=(a018*a108);
  a104=(a104-a109);
  a108=(a108*a104);
  a115=(a108/a115);
  a104=(a118*a108);
  a104=(a015+a104);
  a113=(a104/a113);
  a108=(a122*a108);
  a104=(a123*a104);
  a108=(a108+a104);
  a108=(a108/a121);
  a123=(a123*a108);
  a113=(a113+a123);
  a118=(a118*a113);
  a115=(a115+a118);
  a122=(a122*a108);
  a115=(a115+a122);
  a122=(a099*a066);
  a097=(a049*a097);
  a122=(a122+a097);
  a097=(a003*a008);
  a118=(a091*a093);
  a097=(a097+a118);
  a118=(a067*a048);
  a097=(a097+a118);
  a118=(a230*a058);
  a123=(a092*a101);
  a118=(a118-a123);
  a097=(a097+a118);
  a118=(a080*a097);
  a122=(a122+a118);
  a122=(a036+a122);
  a118=(a115*a122);
  a107=(a107+a118);
  a100=(a100+a107);
  a107=(a096*a100);
  a211=(a211+a107);
  a211=(a009+a211);
  a107=(a005*a211);
  a276=(a276+a107);
  a107=(a120*a182);
  a118=(a126*a013);
  a107=(a107+a118);
  a118=(a127*a100);
  a107=(a107+a118);
  a118=(a134*a136);
  a123=(a135*a132);
  a118=(a118+a123);
  a123=(a134-a118);
  a123=(a007*a123);
  a121=(a007*a132);
  a133=(a133-a129);
  a133=(a129*a133);
  a121=(a121*a133);
  a138=(a138-a121);
  a138=(a138+a135);
  a121=(a146*a138);
  a121=(a121-a148);
  a148=(a142*a138);
  a143=(a143-a148);
  a148=(a147*a143);
  a121=(a121-a148);
  a121=(a121/a145);
  a148=(a121*a034);
  a148=(a148*a135);
  a123=(a123-a148);
  a123=(a123+a134);
  a148=(a123/a139);
  a104=(a007*a118);
  a109=(a142*a123);
  a104=(a104-a109);
  a109=(a104/a137);
  a123=(a146*a123);
  a138=(a138/a139);
  a143=(a143/a137);
  a035=(a147*a121);
  a143=(a143-a035);
  a035=(a142*a143);
  a138=(a138-a035);
  a121=(a146*a121);
  a138=(a138+a121);
  a121=(a138*a135);
  a134=(a134*a022);
  a134=(a134*a022);
  a121=(a121+a134);
  a121=(a034*a121);
  a123=(a123-a121);
  a104=(a147*a104);
  a123=(a123-a104);
  a123=(a123/a145);
  a104=(a147*a123);
  a109=(a109-a104);
  a104=(a142*a109);
  a148=(a148-a104);
  a104=(a146*a123);
  a148=(a148+a104);
  a104=(a006*a009);
  a121=(a028*a058);
  a104=(a104+a121);
  a121=(a096*a070);
  a104=(a104+a121);
  a104=(a069+a104);
  a121=(a148*a104);
  a143=(a143*a132);
  a134=(2.*a138);
  a134=(a134*a132);
  a143=(a143-a134);
  a143=(a143+a118);
  a133=(a136*a133);
  a143=(a143-a133);
  a143=(a007*a143);
  a133=(a143/a139);
  a138=(a138*a132);
  a138=(a138-a118);
  a136=(a136*a022);
  a136=(a136*a022);
  a138=(a138+a136);
  a138=(a007*a138);
  a138=(a138-a029);
  a136=(a142*a143);
  a138=(a138-a136);
  a136=(a138/a137);
  a143=(a146*a143);
  a138=(a147*a138);
  a143=(a143-a138);
  a143=(a143/a145);
  a138=(a147*a143);
  a136=(a136-a138);
  a138=(a142*a136);
  a133=(a133-a138);
  a138=(a146*a143);
  a133=(a133+a138);
  a138=(a006*a036);
  a118=(a028*a101);
  a138=(a138+a118);
  a118=(a096*a122);
  a138=(a138+a118);
  a138=(a017+a138);
  a118=(a133*a138);
  a121=(a121+a118);
  a118=(a039/a145);
  a134=(a147*a118);
  a035=(a142*a134);
  a111=(a146*a118);
  a035=(a035+a111);
  a111=(a006*a075);
  a081=(a028*a055);
  a111=(a111+a081);
  a081=(a099*a052);
  a150=(a049*a150);
  a081=(a081+a150);
  a008=(a037*a008);
  a093=(a098*a093);
  a008=(a008+a093);
  a048=(a040*a048);
  a008=(a008-a048);
  a048=(a202*a058);
  a093=(a086*a101);
  a048=(a048+a093);
  a008=(a008+a048);
  a048=(a080*a008);
  a081=(a081+a048);
  a081=(a075+a081);
  a048=(a096*a081);
  a111=(a111+a048);
  a111=(a130+a111);
  a048=(a035*a111);
  a121=(a121-a048);
  a048=(a010*a129);
  a048=(a048*a132);
  a093=(a048/a139);
  a150=(a018*a022);
  a150=(a150*a132);
  a074=(a142*a048);
  a150=(a150-a074);
  a074=(a150/a137);
  a045=(a033*a022);
  a045=(a045*a135);
  a048=(a146*a048);
  a045=(a045+a048);
  a150=(a147*a150);
  a045=(a045-a150);
  a045=(a045/a145);
  a150=(a147*a045);
  a074=(a074-a150);
  a150=(a142*a074);
  a093=(a093-a150);
  a150=(a146*a045);
  a093=(a093+a150);
  a150=(a093*a211);
  a132=(a018*a132);
  a129=(a129-a022);
  a132=(a132*a129);
  a139=(a132/a139);
  a129=(a142*a132);
  a129=(a015+a129);
  a137=(a129/a137);
  a132=(a146*a132);
  a129=(a147*a129);
  a132=(a132+a129);
  a132=(a132/a145);
  a147=(a147*a132);
  a137=(a137+a147);
  a142=(a142*a137);
  a139=(a139+a142);
  a146=(a146*a132);
  a139=(a139+a146);
  a146=(a006*a066);
  a142=(a028*a097);
  a146=(a146+a142);
  a142=(a087*a042);
  a147=(a112*a114);
  a142=(a142+a147);
  a147=(a110*a061);
  a142=(a142+a147);
  a147=(a073*a070);
  a145=(a113*a122);
  a147=(a147-a145);
  a142=(a142+a147);
  a147=(a096*a142);
  a146=(a146+a147);
  a146=(a036+a146);
  a147=(a139*a146);
  a150=(a150+a147);
  a121=(a121+a150);
  a150=(a128*a121);
  a107=(a107+a150);
  a107=(a009+a107);
  a150=(a117*a107);
  a276=(a276+a150);
  a150=(a144*a182);
  a147=(a084*a013);
  a150=(a150+a147);
  a147=(a151*a100);
  a150=(a150+a147);
  a147=(a152*a121);
  a150=(a150+a147);
  a147=(a159*a161);
  a145=(a160*a157);
  a147=(a147+a145);
  a145=(a159-a147);
  a145=(a007*a145);
  a129=(a007*a157);
  a158=(a158-a154);
  a158=(a154*a158);
  a129=(a129*a158);
  a163=(a163-a129);
  a163=(a163+a160);
  a129=(a171*a163);
  a129=(a129-a173);
  a173=(a167*a163);
  a168=(a168-a173);
  a173=(a172*a168);
  a129=(a129-a173);
  a129=(a129/a170);
  a173=(a129*a034);
  a173=(a173*a160);
  a145=(a145-a173);
  a145=(a145+a159);
  a173=(a145/a164);
  a022=(a007*a147);
  a048=(a167*a145);
  a022=(a022-a048);
  a048=(a022/a162);
  a145=(a171*a145);
  a163=(a163/a164);
  a168=(a168/a162);
  a135=(a172*a129);
  a168=(a168-a135);
  a135=(a167*a168);
  a163=(a163-a135);
  a129=(a171*a129);
  a163=(a163+a129);
  a129=(a163*a160);
  a159=(a159*a125);
  a159=(a159*a125);
  a129=(a129+a159);
  a129=(a034*a129);
  a145=(a145-a129);
  a022=(a172*a022);
  a145=(a145-a022);
  a145=(a145/a170);
  a022=(a172*a145);
  a048=(a048-a022);
  a022=(a167*a048);
  a173=(a173-a022);
  a022=(a171*a145);
  a173=(a173+a022);
  a022=(a120*a009);
  a129=(a126*a058);
  a022=(a022+a129);
  a129=(a127*a070);
  a022=(a022+a129);
  a129=(a128*a211);
  a022=(a022+a129);
  a022=(a069+a022);
  a129=(a173*a022);
  a168=(a168*a157);
  a159=(2.*a163);
  a159=(a159*a157);
  a168=(a168-a159);
  a168=(a168+a147);
  a158=(a161*a158);
  a168=(a168-a158);
  a168=(a007*a168);
  a158=(a168/a164);
  a163=(a163*a157);
  a163=(a163-a147);
  a161=(a161*a125);
  a161=(a161*a125);
  a163=(a163+a161);
  a163=(a007*a163);
  a163=(a163-a029);
  a161=(a167*a168);
  a163=(a163-a161);
  a161=(a163/a162);
  a168=(a171*a168);
  a163=(a172*a163);
  a168=(a168-a163);
  a168=(a168/a170);
  a163=(a172*a168);
  a161=(a161-a163);
  a163=(a167*a161);
  a158=(a158-a163);
  a163=(a171*a168);
  a158=(a158+a163);
  a163=(a120*a036);
  a147=(a126*a101);
  a163=(a163+a147);
  a147=(a127*a122);
  a163=(a163+a147);
  a147=(a128*a146);
  a163=(a163+a147);
  a163=(a017+a163);
  a147=(a158*a163);
  a129=(a129+a147);
  a147=(a039/a170);
  a159=(a172*a147);
  a135=(a167*a159);
  a140=(a171*a147);
  a135=(a135+a140);
  a140=(a120*a075);
  a071=(a126*a055);
  a140=(a140+a071);
  a071=(a127*a081);
  a140=(a140+a071);
  a071=(a006*a052);
  a292=(a028*a008);
  a071=(a071+a292);
  a042=(a102*a042);
  a114=(a119*a114);
  a042=(a042+a114);
  a061=(a289*a061);
  a042=(a042-a061);
  a061=(a083*a070);
  a114=(a108*a122);
  a061=(a061+a114);
  a042=(a042+a061);
  a061=(a096*a042);
  a071=(a071+a061);
  a071=(a075+a071);
  a061=(a128*a071);
  a140=(a140+a061);
  a140=(a130+a140);
  a061=(a135*a140);
  a129=(a129-a061);
  a061=(a010*a154);
  a061=(a061*a157);
  a114=(a061/a164);
  a292=(a018*a125);
  a292=(a292*a157);
  a293=(a167*a061);
  a292=(a292-a293);
  a293=(a292/a162);
  a294=(a033*a125);
  a294=(a294*a160);
  a061=(a171*a061);
  a294=(a294+a061);
  a292=(a172*a292);
  a294=(a294-a292);
  a294=(a294/a170);
  a292=(a172*a294);
  a293=(a293-a292);
  a292=(a167*a293);
  a114=(a114-a292);
  a292=(a171*a294);
  a114=(a114+a292);
  a292=(a114*a107);
  a157=(a018*a157);
  a154=(a154-a125);
  a157=(a157*a154);
  a164=(a157/a164);
  a154=(a167*a157);
  a154=(a015+a154);
  a162=(a154/a162);
  a157=(a171*a157);
  a154=(a172*a154);
  a157=(a157+a154);
  a157=(a157/a170);
  a172=(a172*a157);
  a162=(a162+a172);
  a167=(a167*a162);
  a164=(a164+a167);
  a171=(a171*a157);
  a164=(a164+a171);
  a171=(a120*a066);
  a167=(a126*a097);
  a171=(a171+a167);
  a167=(a127*a142);
  a171=(a171+a167);
  a167=(a109*a104);
  a172=(a136*a138);
  a167=(a167+a172);
  a172=(a134*a111);
  a167=(a167+a172);
  a172=(a074*a211);
  a170=(a137*a146);
  a172=(a172-a170);
  a167=(a167+a172);
  a172=(a128*a167);
  a171=(a171+a172);
  a171=(a036+a171);
  a172=(a164*a171);
  a292=(a292+a172);
  a129=(a129+a292);
  a292=(a153*a129);
  a150=(a150+a292);
  a150=(a009+a150);
  a292=(a141*a150);
  a276=(a276+a292);
  a292=(a169*a182);
  a172=(a176*a013);
  a292=(a292+a172);
  a172=(a177*a100);
  a292=(a292+a172);
  a172=(a178*a121);
  a292=(a292+a172);
  a172=(a179*a129);
  a292=(a292+a172);
  a172=(a186*a188);
  a170=(a187*a184);
  a172=(a172+a170);
  a170=(a186-a172);
  a170=(a007*a170);
  a154=(a007*a184);
  a185=(a185-a181);
  a185=(a181*a185);
  a154=(a154*a185);
  a190=(a190-a154);
  a190=(a190+a187);
  a154=(a198*a190);
  a154=(a154-a200);
  a200=(a194*a190);
  a195=(a195-a200);
  a200=(a199*a195);
  a154=(a154-a200);
  a154=(a154/a197);
  a200=(a154*a034);
  a200=(a200*a187);
  a170=(a170-a200);
  a170=(a170+a186);
  a200=(a170/a191);
  a125=(a007*a172);
  a061=(a194*a170);
  a125=(a125-a061);
  a061=(a125/a189);
  a170=(a198*a170);
  a190=(a190/a191);
  a195=(a195/a189);
  a160=(a199*a154);
  a195=(a195-a160);
  a160=(a194*a195);
  a190=(a190-a160);
  a154=(a198*a154);
  a190=(a190+a154);
  a154=(a190*a187);
  a186=(a186*a149);
  a186=(a186*a149);
  a154=(a154+a186);
  a154=(a034*a154);
  a170=(a170-a154);
  a125=(a199*a125);
  a170=(a170-a125);
  a170=(a170/a197);
  a125=(a199*a170);
  a061=(a061-a125);
  a125=(a194*a061);
  a200=(a200-a125);
  a125=(a198*a170);
  a200=(a200+a125);
  a125=(a144*a009);
  a154=(a084*a058);
  a125=(a125+a154);
  a154=(a151*a070);
  a125=(a125+a154);
  a154=(a152*a211);
  a125=(a125+a154);
  a154=(a153*a107);
  a125=(a125+a154);
  a125=(a069+a125);
  a154=(a200*a125);
  a195=(a195*a184);
  a186=(2.*a190);
  a186=(a186*a184);
  a195=(a195-a186);
  a195=(a195+a172);
  a185=(a188*a185);
  a195=(a195-a185);
  a195=(a007*a195);
  a185=(a195/a191);
  a190=(a190*a184);
  a190=(a190-a172);
  a188=(a188*a149);
  a188=(a188*a149);
  a190=(a190+a188);
  a190=(a007*a190);
  a190=(a190-a029);
  a188=(a194*a195);
  a190=(a190-a188);
  a188=(a190/a189);
  a195=(a198*a195);
  a190=(a199*a190);
  a195=(a195-a190);
  a195=(a195/a197);
  a190=(a199*a195);
  a188=(a188-a190);
  a190=(a194*a188);
  a185=(a185-a190);
  a190=(a198*a195);
  a185=(a185+a190);
  a190=(a144*a036);
  a172=(a084*a101);
  a190=(a190+a172);
  a172=(a151*a122);
  a190=(a190+a172);
  a172=(a152*a146);
  a190=(a190+a172);
  a172=(a153*a171);
  a190=(a190+a172);
  a190=(a017+a190);
  a172=(a185*a190);
  a154=(a154+a172);
  a172=(a039/a197);
  a186=(a199*a172);
  a160=(a194*a186);
  a295=(a198*a172);
  a160=(a160+a295);
  a295=(a144*a075);
  a296=(a084*a055);
  a295=(a295+a296);
  a296=(a151*a081);
  a295=(a295+a296);
  a296=(a152*a071);
  a295=(a295+a296);
  a296=(a120*a052);
  a297=(a126*a008);
  a296=(a296+a297);
  a297=(a127*a042);
  a296=(a296+a297);
  a104=(a123*a104);
  a138=(a143*a138);
  a104=(a104+a138);
  a111=(a118*a111);
  a104=(a104-a111);
  a111=(a045*a211);
  a138=(a132*a146);
  a111=(a111+a138);
  a104=(a104+a111);
  a111=(a128*a104);
  a296=(a296+a111);
  a296=(a075+a296);
  a111=(a153*a296);
  a295=(a295+a111);
  a295=(a130+a295);
  a111=(a160*a295);
  a154=(a154-a111);
  a111=(a010*a181);
  a111=(a111*a184);
  a138=(a111/a191);
  a297=(a018*a149);
  a297=(a297*a184);
  a298=(a194*a111);
  a297=(a297-a298);
  a298=(a297/a189);
  a299=(a033*a149);
  a299=(a299*a187);
  a111=(a198*a111);
  a299=(a299+a111);
  a297=(a199*a297);
  a299=(a299-a297);
  a299=(a299/a197);
  a297=(a199*a299);
  a298=(a298-a297);
  a297=(a194*a298);
  a138=(a138-a297);
  a297=(a198*a299);
  a138=(a138+a297);
  a297=(a138*a150);
  a184=(a018*a184);
  a181=(a181-a149);
  a184=(a184*a181);
  a191=(a184/a191);
  a181=(a194*a184);
  a181=(a015+a181);
  a189=(a181/a189);
  a184=(a198*a184);
  a181=(a199*a181);
  a184=(a184+a181);
  a184=(a184/a197);
  a199=(a199*a184);
  a189=(a189+a199);
  a194=(a194*a189);
  a191=(a191+a194);
  a198=(a198*a184);
  a191=(a191+a198);
  a198=(a144*a066);
  a194=(a084*a097);
  a198=(a198+a194);
  a194=(a151*a142);
  a198=(a198+a194);
  a194=(a152*a167);
  a198=(a198+a194);
  a194=(a048*a022);
  a199=(a161*a163);
  a194=(a194+a199);
  a199=(a159*a140);
  a194=(a194+a199);
  a199=(a293*a107);
  a197=(a162*a171);
  a199=(a199-a197);
  a194=(a194+a199);
  a199=(a153*a194);
  a198=(a198+a199);
  a198=(a036+a198);
  a199=(a191*a198);
  a297=(a297+a199);
  a154=(a154+a297);
  a297=(a180*a154);
  a292=(a292+a297);
  a292=(a009+a292);
  a297=(a166*a292);
  a276=(a276+a297);
  a297=(a196*a182);
  a199=(a203*a013);
  a297=(a297+a199);
  a199=(a204*a100);
  a297=(a297+a199);
  a199=(a205*a121);
  a297=(a297+a199);
  a199=(a206*a129);
  a297=(a297+a199);
  a199=(a207*a154);
  a297=(a297+a199);
  a199=(a214*a216);
  a197=(a215*a212);
  a199=(a199+a197);
  a197=(a214-a199);
  a197=(a007*a197);
  a181=(a007*a212);
  a213=(a213-a209);
  a213=(a209*a213);
  a181=(a181*a213);
  a218=(a218-a181);
  a218=(a218+a215);
  a181=(a226*a218);
  a181=(a181-a228);
  a228=(a222*a218);
  a223=(a223-a228);
  a228=(a227*a223);
  a181=(a181-a228);
  a181=(a181/a225);
  a228=(a181*a034);
  a228=(a228*a215);
  a197=(a197-a228);
  a197=(a197+a214);
  a228=(a197/a219);
  a149=(a007*a199);
  a111=(a222*a197);
  a149=(a149-a111);
  a111=(a149/a217);
  a197=(a226*a197);
  a218=(a218/a219);
  a223=(a223/a217);
  a187=(a227*a181);
  a223=(a223-a187);
  a187=(a222*a223);
  a218=(a218-a187);
  a181=(a226*a181);
  a218=(a218+a181);
  a181=(a218*a215);
  a214=(a214*a174);
  a214=(a214*a174);
  a181=(a181+a214);
  a181=(a034*a181);
  a197=(a197-a181);
  a149=(a227*a149);
  a197=(a197-a149);
  a197=(a197/a225);
  a149=(a227*a197);
  a111=(a111-a149);
  a149=(a222*a111);
  a228=(a228-a149);
  a149=(a226*a197);
  a228=(a228+a149);
  a149=(a169*a009);
  a181=(a176*a058);
  a149=(a149+a181);
  a181=(a177*a070);
  a149=(a149+a181);
  a181=(a178*a211);
  a149=(a149+a181);
  a181=(a179*a107);
  a149=(a149+a181);
  a181=(a180*a150);
  a149=(a149+a181);
  a149=(a069+a149);
  a181=(a228*a149);
  a223=(a223*a212);
  a214=(2.*a218);
  a214=(a214*a212);
  a223=(a223-a214);
  a223=(a223+a199);
  a213=(a216*a213);
  a223=(a223-a213);
  a223=(a007*a223);
  a213=(a223/a219);
  a218=(a218*a212);
  a218=(a218-a199);
  a216=(a216*a174);
  a216=(a216*a174);
  a218=(a218+a216);
  a218=(a007*a218);
  a218=(a218-a029);
  a216=(a222*a223);
  a218=(a218-a216);
  a216=(a218/a217);
  a223=(a226*a223);
  a218=(a227*a218);
  a223=(a223-a218);
  a223=(a223/a225);
  a218=(a227*a223);
  a216=(a216-a218);
  a218=(a222*a216);
  a213=(a213-a218);
  a218=(a226*a223);
  a213=(a213+a218);
  a218=(a169*a036);
  a199=(a176*a101);
  a218=(a218+a199);
  a199=(a177*a122);
  a218=(a218+a199);
  a199=(a178*a146);
  a218=(a218+a199);
  a199=(a179*a171);
  a218=(a218+a199);
  a199=(a180*a198);
  a218=(a218+a199);
  a218=(a017+a218);
  a199=(a213*a218);
  a181=(a181+a199);
  a199=(a039/a225);
  a214=(a227*a199);
  a187=(a222*a214);
  a300=(a226*a199);
  a187=(a187+a300);
  a300=(a169*a075);
  a301=(a176*a055);
  a300=(a300+a301);
  a301=(a177*a081);
  a300=(a300+a301);
  a301=(a178*a071);
  a300=(a300+a301);
  a301=(a179*a296);
  a300=(a300+a301);
  a301=(a144*a052);
  a302=(a084*a008);
  a301=(a301+a302);
  a302=(a151*a042);
  a301=(a301+a302);
  a302=(a152*a104);
  a301=(a301+a302);
  a022=(a145*a022);
  a163=(a168*a163);
  a022=(a022+a163);
  a140=(a147*a140);
  a022=(a022-a140);
  a140=(a294*a107);
  a163=(a157*a171);
  a140=(a140+a163);
  a022=(a022+a140);
  a140=(a153*a022);
  a301=(a301+a140);
  a301=(a075+a301);
  a140=(a180*a301);
  a300=(a300+a140);
  a300=(a130+a300);
  a140=(a187*a300);
  a181=(a181-a140);
  a140=(a010*a209);
  a140=(a140*a212);
  a163=(a140/a219);
  a302=(a018*a174);
  a302=(a302*a212);
  a303=(a222*a140);
  a302=(a302-a303);
  a303=(a302/a217);
  a304=(a033*a174);
  a304=(a304*a215);
  a140=(a226*a140);
  a304=(a304+a140);
  a302=(a227*a302);
  a304=(a304-a302);
  a304=(a304/a225);
  a302=(a227*a304);
  a303=(a303-a302);
  a302=(a222*a303);
  a163=(a163-a302);
  a302=(a226*a304);
  a163=(a163+a302);
  a302=(a163*a292);
  a212=(a018*a212);
  a209=(a209-a174);
  a212=(a212*a209);
  a219=(a212/a219);
  a209=(a222*a212);
  a209=(a015+a209);
  a217=(a209/a217);
  a212=(a226*a212);
  a209=(a227*a209);
  a212=(a212+a209);
  a212=(a212/a225);
  a227=(a227*a212);
  a217=(a217+a227);
  a222=(a222*a217);
  a219=(a219+a222);
  a226=(a226*a212);
  a219=(a219+a226);
  a226=(a169*a066);
  a222=(a176*a097);
  a226=(a226+a222);
  a222=(a177*a142);
  a226=(a226+a222);
  a222=(a178*a167);
  a226=(a226+a222);
  a222=(a179*a194);
  a226=(a226+a222);
  a222=(a061*a125);
  a227=(a188*a190);
  a222=(a222+a227);
  a227=(a186*a295);
  a222=(a222+a227);
  a227=(a298*a150);
  a225=(a189*a198);
  a227=(a227-a225);
  a222=(a222+a227);
  a227=(a180*a222);
  a226=(a226+a227);
  a226=(a036+a226);
  a227=(a219*a226);
  a302=(a302+a227);
  a181=(a181+a302);
  a302=(a208*a181);
  a297=(a297+a302);
  a297=(a009+a297);
  a302=(a193*a297);
  a276=(a276+a302);
  a302=(a224*a182);
  a227=(a231*a013);
  a302=(a302+a227);
  a227=(a232*a100);
  a302=(a302+a227);
  a227=(a233*a121);
  a302=(a302+a227);
  a227=(a234*a129);
  a302=(a302+a227);
  a227=(a235*a154);
  a302=(a302+a227);
  a227=(a236*a181);
  a302=(a302+a227);
  a227=(a243*a245);
  a225=(a244*a241);
  a227=(a227+a225);
  a225=(a243-a227);
  a225=(a007*a225);
  a209=(a007*a241);
  a242=(a242-a238);
  a242=(a238*a242);
  a209=(a209*a242);
  a247=(a247-a209);
  a247=(a247+a244);
  a209=(a255*a247);
  a209=(a209-a257);
  a257=(a251*a247);
  a252=(a252-a257);
  a257=(a256*a252);
  a209=(a209-a257);
  a209=(a209/a254);
  a257=(a209*a034);
  a257=(a257*a244);
  a225=(a225-a257);
  a225=(a225+a243);
  a257=(a225/a248);
  a174=(a007*a227);
  a140=(a251*a225);
  a174=(a174-a140);
  a140=(a174/a246);
  a225=(a255*a225);
  a247=(a247/a248);
  a252=(a252/a246);
  a215=(a256*a209);
  a252=(a252-a215);
  a215=(a251*a252);
  a247=(a247-a215);
  a209=(a255*a209);
  a247=(a247+a209);
  a209=(a247*a244);
  a243=(a243*a201);
  a243=(a243*a201);
  a209=(a209+a243);
  a209=(a034*a209);
  a225=(a225-a209);
  a174=(a256*a174);
  a225=(a225-a174);
  a225=(a225/a254);
  a174=(a256*a225);
  a140=(a140-a174);
  a174=(a251*a140);
  a257=(a257-a174);
  a174=(a255*a225);
  a257=(a257+a174);
  a174=(a196*a009);
  a209=(a203*a058);
  a174=(a174+a209);
  a209=(a204*a070);
  a174=(a174+a209);
  a209=(a205*a211);
  a174=(a174+a209);
  a209=(a206*a107);
  a174=(a174+a209);
  a209=(a207*a150);
  a174=(a174+a209);
  a209=(a208*a292);
  a174=(a174+a209);
  a174=(a069+a174);
  a209=(a257*a174);
  a252=(a252*a241);
  a243=(2.*a247);
  a243=(a243*a241);
  a252=(a252-a243);
  a252=(a252+a227);
  a242=(a245*a242);
  a252=(a252-a242);
  a252=(a007*a252);
  a242=(a252/a248);
  a247=(a247*a241);
  a247=(a247-a227);
  a245=(a245*a201);
  a245=(a245*a201);
  a247=(a247+a245);
  a247=(a007*a247);
  a247=(a247-a029);
  a245=(a251*a252);
  a247=(a247-a245);
  a245=(a247/a246);
  a252=(a255*a252);
  a247=(a256*a247);
  a252=(a252-a247);
  a252=(a252/a254);
  a247=(a256*a252);
  a245=(a245-a247);
  a247=(a251*a245);
  a242=(a242-a247);
  a247=(a255*a252);
  a242=(a242+a247);
  a247=(a196*a036);
  a227=(a203*a101);
  a247=(a247+a227);
  a227=(a204*a122);
  a247=(a247+a227);
  a227=(a205*a146);
  a247=(a247+a227);
  a227=(a206*a171);
  a247=(a247+a227);
  a227=(a207*a198);
  a247=(a247+a227);
  a227=(a208*a226);
  a247=(a247+a227);
  a247=(a017+a247);
  a227=(a242*a247);
  a209=(a209+a227);
  a227=(a039/a254);
  a243=(a256*a227);
  a215=(a251*a243);
  a305=(a255*a227);
  a215=(a215+a305);
  a305=(a196*a075);
  a306=(a203*a055);
  a305=(a305+a306);
  a306=(a204*a081);
  a305=(a305+a306);
  a306=(a205*a071);
  a305=(a305+a306);
  a306=(a206*a296);
  a305=(a305+a306);
  a306=(a207*a301);
  a305=(a305+a306);
  a306=(a169*a052);
  a307=(a176*a008);
  a306=(a306+a307);
  a307=(a177*a042);
  a306=(a306+a307);
  a307=(a178*a104);
  a306=(a306+a307);
  a307=(a179*a022);
  a306=(a306+a307);
  a125=(a170*a125);
  a190=(a195*a190);
  a125=(a125+a190);
  a295=(a172*a295);
  a125=(a125-a295);
  a295=(a299*a150);
  a190=(a184*a198);
  a295=(a295+a190);
  a125=(a125+a295);
  a295=(a180*a125);
  a306=(a306+a295);
  a306=(a075+a306);
  a295=(a208*a306);
  a305=(a305+a295);
  a305=(a130+a305);
  a295=(a215*a305);
  a209=(a209-a295);
  a295=(a010*a238);
  a295=(a295*a241);
  a190=(a295/a248);
  a307=(a018*a201);
  a307=(a307*a241);
  a308=(a251*a295);
  a307=(a307-a308);
  a308=(a307/a246);
  a309=(a033*a201);
  a309=(a309*a244);
  a295=(a255*a295);
  a309=(a309+a295);
  a307=(a256*a307);
  a309=(a309-a307);
  a309=(a309/a254);
  a307=(a256*a309);
  a308=(a308-a307);
  a307=(a251*a308);
  a190=(a190-a307);
  a307=(a255*a309);
  a190=(a190+a307);
  a307=(a190*a297);
  a241=(a018*a241);
  a238=(a238-a201);
  a241=(a241*a238);
  a248=(a241/a248);
  a238=(a251*a241);
  a238=(a015+a238);
  a246=(a238/a246);
  a241=(a255*a241);
  a238=(a256*a238);
  a241=(a241+a238);
  a241=(a241/a254);
  a256=(a256*a241);
  a246=(a246+a256);
  a251=(a251*a246);
  a248=(a248+a251);
  a255=(a255*a241);
  a248=(a248+a255);
  a255=(a196*a066);
  a251=(a203*a097);
  a255=(a255+a251);
  a251=(a204*a142);
  a255=(a255+a251);
  a251=(a205*a167);
  a255=(a255+a251);
  a251=(a206*a194);
  a255=(a255+a251);
  a251=(a207*a222);
  a255=(a255+a251);
  a251=(a111*a149);
  a256=(a216*a218);
  a251=(a251+a256);
  a256=(a214*a300);
  a251=(a251+a256);
  a256=(a303*a292);
  a254=(a217*a226);
  a256=(a256-a254);
  a251=(a251+a256);
  a256=(a208*a251);
  a255=(a255+a256);
  a255=(a036+a255);
  a256=(a248*a255);
  a307=(a307+a256);
  a209=(a209+a307);
  a307=(a237*a209);
  a302=(a302+a307);
  a302=(a009+a302);
  a307=(a221*a302);
  a276=(a276+a307);
  a307=(a253*a182);
  a013=(a260*a013);
  a307=(a307+a013);
  a100=(a095*a100);
  a307=(a307+a100);
  a100=(a116*a121);
  a307=(a307+a100);
  a100=(a261*a129);
  a307=(a307+a100);
  a100=(a262*a154);
  a307=(a307+a100);
  a100=(a263*a181);
  a307=(a307+a100);
  a100=(a264*a209);
  a307=(a307+a100);
  a100=(a270*a272);
  a013=(a271*a268);
  a100=(a100+a013);
  a013=(a270-a100);
  a013=(a007*a013);
  a256=(a007*a268);
  a269=(a269-a002);
  a269=(a002*a269);
  a256=(a256*a269);
  a274=(a274-a256);
  a274=(a274+a271);
  a256=(a282*a274);
  a256=(a256-a284);
  a284=(a278*a274);
  a279=(a279-a284);
  a284=(a283*a279);
  a256=(a256-a284);
  a256=(a256/a281);
  a284=(a256*a034);
  a284=(a284*a271);
  a013=(a013-a284);
  a013=(a013+a270);
  a284=(a013/a275);
  a254=(a007*a100);
  a238=(a278*a013);
  a254=(a254-a238);
  a238=(a254/a273);
  a013=(a282*a013);
  a274=(a274/a275);
  a279=(a279/a273);
  a201=(a283*a256);
  a279=(a279-a201);
  a201=(a278*a279);
  a274=(a274-a201);
  a256=(a282*a256);
  a274=(a274+a256);
  a256=(a274*a271);
  a270=(a270*a229);
  a270=(a270*a229);
  a256=(a256+a270);
  a256=(a034*a256);
  a013=(a013-a256);
  a254=(a283*a254);
  a013=(a013-a254);
  a013=(a013/a281);
  a254=(a283*a013);
  a238=(a238-a254);
  a254=(a278*a238);
  a284=(a284-a254);
  a254=(a282*a013);
  a284=(a284+a254);
  a254=(a224*a009);
  a256=(a231*a058);
  a254=(a254+a256);
  a256=(a232*a070);
  a254=(a254+a256);
  a256=(a233*a211);
  a254=(a254+a256);
  a256=(a234*a107);
  a254=(a254+a256);
  a256=(a235*a150);
  a254=(a254+a256);
  a256=(a236*a292);
  a254=(a254+a256);
  a256=(a237*a297);
  a254=(a254+a256);
  a254=(a069+a254);
  a256=(a284*a254);
  a279=(a279*a268);
  a270=(2.*a274);
  a270=(a270*a268);
  a279=(a279-a270);
  a279=(a279+a100);
  a269=(a272*a269);
  a279=(a279-a269);
  a279=(a007*a279);
  a269=(a279/a275);
  a274=(a274*a268);
  a274=(a274-a100);
  a272=(a272*a229);
  a272=(a272*a229);
  a274=(a274+a272);
  a274=(a007*a274);
  a274=(a274-a029);
  a272=(a278*a279);
  a274=(a274-a272);
  a272=(a274/a273);
  a279=(a282*a279);
  a274=(a283*a274);
  a279=(a279-a274);
  a279=(a279/a281);
  a274=(a283*a279);
  a272=(a272-a274);
  a274=(a278*a272);
  a269=(a269-a274);
  a274=(a282*a279);
  a269=(a269+a274);
  a274=(a224*a036);
  a100=(a231*a101);
  a274=(a274+a100);
  a100=(a232*a122);
  a274=(a274+a100);
  a100=(a233*a146);
  a274=(a274+a100);
  a100=(a234*a171);
  a274=(a274+a100);
  a100=(a235*a198);
  a274=(a274+a100);
  a100=(a236*a226);
  a274=(a274+a100);
  a100=(a237*a255);
  a274=(a274+a100);
  a274=(a017+a274);
  a100=(a269*a274);
  a256=(a256+a100);
  a100=(a039/a281);
  a270=(a283*a100);
  a201=(a278*a270);
  a295=(a282*a100);
  a201=(a201+a295);
  a295=(a224*a075);
  a244=(a231*a055);
  a295=(a295+a244);
  a244=(a232*a081);
  a295=(a295+a244);
  a244=(a233*a071);
  a295=(a295+a244);
  a244=(a234*a296);
  a295=(a295+a244);
  a244=(a235*a301);
  a295=(a295+a244);
  a244=(a236*a306);
  a295=(a295+a244);
  a244=(a196*a052);
  a310=(a203*a008);
  a244=(a244+a310);
  a310=(a204*a042);
  a244=(a244+a310);
  a310=(a205*a104);
  a244=(a244+a310);
  a310=(a206*a022);
  a244=(a244+a310);
  a310=(a207*a125);
  a244=(a244+a310);
  a149=(a197*a149);
  a218=(a223*a218);
  a149=(a149+a218);
  a300=(a199*a300);
  a149=(a149-a300);
  a300=(a304*a292);
  a218=(a212*a226);
  a300=(a300+a218);
  a149=(a149+a300);
  a300=(a208*a149);
  a244=(a244+a300);
  a244=(a075+a244);
  a300=(a237*a244);
  a295=(a295+a300);
  a295=(a130+a295);
  a300=(a201*a295);
  a256=(a256-a300);
  a300=(a010*a002);
  a300=(a300*a268);
  a218=(a300/a275);
  a310=(a018*a229);
  a310=(a310*a268);
  a311=(a278*a300);
  a310=(a310-a311);
  a311=(a310/a273);
  a312=(a033*a229);
  a312=(a312*a271);
  a300=(a282*a300);
  a312=(a312+a300);
  a310=(a283*a310);
  a312=(a312-a310);
  a312=(a312/a281);
  a310=(a283*a312);
  a311=(a311-a310);
  a310=(a278*a311);
  a218=(a218-a310);
  a310=(a282*a312);
  a218=(a218+a310);
  a310=(a218*a302);
  a268=(a018*a268);
  a002=(a002-a229);
  a268=(a268*a002);
  a275=(a268/a275);
  a002=(a278*a268);
  a002=(a015+a002);
  a273=(a002/a273);
  a268=(a282*a268);
  a002=(a283*a002);
  a268=(a268+a002);
  a268=(a268/a281);
  a283=(a283*a268);
  a273=(a273+a283);
  a278=(a278*a273);
  a275=(a275+a278);
  a282=(a282*a268);
  a275=(a275+a282);
  a282=(a224*a066);
  a278=(a231*a097);
  a282=(a282+a278);
  a278=(a232*a142);
  a282=(a282+a278);
  a278=(a233*a167);
  a282=(a282+a278);
  a278=(a234*a194);
  a282=(a282+a278);
  a278=(a235*a222);
  a282=(a282+a278);
  a278=(a236*a251);
  a282=(a282+a278);
  a278=(a140*a174);
  a283=(a245*a247);
  a278=(a278+a283);
  a283=(a243*a305);
  a278=(a278+a283);
  a283=(a308*a297);
  a281=(a246*a255);
  a283=(a283-a281);
  a278=(a278+a283);
  a283=(a237*a278);
  a282=(a282+a283);
  a282=(a036+a282);
  a283=(a275*a282);
  a310=(a310+a283);
  a256=(a256+a310);
  a310=(a265*a256);
  a307=(a307+a310);
  a307=(a009+a307);
  a310=(a250*a307);
  a276=(a276+a310);
  a276=(a069+a276);
  if (res[0]!=0) res[0][6]=a276;
  a276=(a001*a036);
  a310=(a005*a146);
  a276=(a276+a310);
  a310=(a117*a171);
  a276=(a276+a310);
  a310=(a141*a198);
  a276=(a276+a310);
  a310=(a166*a226);
  a276=(a276+a310);
  a310=(a193*a255);
  a276=(a276+a310);
  a310=(a221*a282);
  a276=(a276+a310);
  a310=(a253*a066);
  a097=(a260*a097);
  a310=(a310+a097);
  a142=(a095*a142);
  a310=(a310+a142);
  a142=(a116*a167);
  a310=(a310+a142);
  a142=(a261*a194);
  a310=(a310+a142);
  a142=(a262*a222);
  a310=(a310+a142);
  a142=(a263*a251);
  a310=(a310+a142);
  a142=(a264*a278);
  a310=(a310+a142);
  a142=(a238*a254);
  a097=(a272*a274);
  a142=(a142+a097);
  a097=(a270*a295);
  a142=(a142+a097);
  a097=(a311*a302);
  a283=(a273*a282);
  a097=(a097-a283);
  a142=(a142+a097);
  a097=(a265*a142);
  a310=(a310+a097);
  a310=(a036+a310);
  a097=(a250*a310);
  a276=(a276+a097);
  a276=(a017+a276);
  if (res[0]!=0) res[0][7]=a276;
  a276=(a001*a075);
  a097=(a005*a071);
  a276=(a276+a097);
  a097=(a117*a296);
  a276=(a276+a097);
  a097=(a141*a301);
  a276=(a276+a097);
  a097=(a166*a306);
  a276=(a276+a097);
  a097=(a193*a244);
  a276=(a276+a097);
  a097=(a224*a052);
  a283=(a231*a008);
  a097=(a097+a283);
  a283=(a232*a042);
  a097=(a097+a283);
  a283=(a233*a104);
  a097=(a097+a283);
  a283=(a234*a022);
  a097=(a097+a283);
  a283=(a235*a125);
  a097=(a097+a283);
  a283=(a236*a149);
  a097=(a097+a283);
  a174=(a225*a174);
  a247=(a252*a247);
  a174=(a174+a247);
  a305=(a227*a305);
  a174=(a174-a305);
  a305=(a309*a297);
  a247=(a241*a255);
  a305=(a305+a247);
  a174=(a174+a305);
  a305=(a237*a174);
  a097=(a097+a305);
  a097=(a075+a097);
  a305=(a221*a097);
  a276=(a276+a305);
  a305=(a253*a052);
  a008=(a260*a008);
  a305=(a305+a008);
  a042=(a095*a042);
  a305=(a305+a042);
  a042=(a116*a104);
  a305=(a305+a042);
  a042=(a261*a022);
  a305=(a305+a042);
  a042=(a262*a125);
  a305=(a305+a042);
  a042=(a263*a149);
  a305=(a305+a042);
  a042=(a264*a174);
  a305=(a305+a042);
  a254=(a013*a254);
  a274=(a279*a274);
  a254=(a254+a274);
  a295=(a100*a295);
  a254=(a254-a295);
  a295=(a312*a302);
  a274=(a268*a282);
  a295=(a295+a274);
  a254=(a254+a295);
  a295=(a265*a254);
  a305=(a305+a295);
  a305=(a075+a305);
  a305=(a250*a305);
  a276=(a276+a305);
  a276=(a130+a276);
  if (res[0]!=0) res[0][8]=a276;
  a182=(a001*a182);
  a121=(a005*a121);
  a182=(a182+a121);
  a129=(a117*a129);
  a182=(a182+a129);
  a154=(a141*a154);
  a182=(a182+a154);
  a181=(a166*a181);
  a182=(a182+a181);
  a209=(a193*a209);
  a182=(a182+a209);
  a256=(a221*a256);
  a182=(a182+a256);
  a256=(a000*a165);
  a209=(a192*a249);
  a256=(a256+a209);
  a209=(a000-a256);
  a209=(a007*a209);
  a181=(a007*a249);
  a220=(a220-a277);
  a220=(a277*a220);
  a181=(a181*a220);
  a004=(a004-a181);
  a004=(a004+a192);
  a181=(a031*a004);
  a181=(a181-a027);
  a027=(a280*a004);
  a285=(a285-a027);
  a027=(a019*a285);
  a181=(a181-a027);
  a181=(a181/a025);
  a027=(a181*a034);
  a027=(a027*a192);
  a209=(a209-a027);
  a209=(a209+a000);
  a027=(a209/a078);
  a154=(a007*a256);
  a129=(a280*a209);
  a154=(a154-a129);
  a129=(a154/a030);
  a209=(a031*a209);
  a004=(a004/a078);
  a285=(a285/a030);
  a121=(a019*a181);
  a285=(a285-a121);
  a121=(a280*a285);
  a004=(a004-a121);
  a181=(a031*a181);
  a004=(a004+a181);
  a181=(a004*a192);
  a000=(a000*a258);
  a000=(a000*a258);
  a181=(a181+a000);
  a034=(a034*a181);
  a209=(a209-a034);
  a154=(a019*a154);
  a209=(a209-a154);
  a209=(a209/a025);
  a154=(a019*a209);
  a129=(a129-a154);
  a154=(a280*a129);
  a027=(a027-a154);
  a154=(a031*a209);
  a027=(a027+a154);
  a154=(a253*a009);
  a058=(a260*a058);
  a154=(a154+a058);
  a070=(a095*a070);
  a154=(a154+a070);
  a211=(a116*a211);
  a154=(a154+a211);
  a107=(a261*a107);
  a154=(a154+a107);
  a150=(a262*a150);
  a154=(a154+a150);
  a292=(a263*a292);
  a154=(a154+a292);
  a297=(a264*a297);
  a154=(a154+a297);
  a302=(a265*a302);
  a154=(a154+a302);
  a069=(a069+a154);
  a154=(a027*a069);
  a285=(a285*a249);
  a302=(2.*a004);
  a302=(a302*a249);
  a285=(a285-a302);
  a285=(a285+a256);
  a220=(a165*a220);
  a285=(a285-a220);
  a285=(a007*a285);
  a220=(a285/a078);
  a004=(a004*a249);
  a004=(a004-a256);
  a165=(a165*a258);
  a165=(a165*a258);
  a004=(a004+a165);
  a007=(a007*a004);
  a007=(a007-a029);
  a029=(a280*a285);
  a007=(a007-a029);
  a029=(a007/a030);
  a285=(a031*a285);
  a007=(a019*a007);
  a285=(a285-a007);
  a285=(a285/a025);
  a007=(a019*a285);
  a029=(a029-a007);
  a007=(a280*a029);
  a220=(a220-a007);
  a007=(a031*a285);
  a220=(a220+a007);
  a007=(a253*a036);
  a101=(a260*a101);
  a007=(a007+a101);
  a122=(a095*a122);
  a007=(a007+a122);
  a146=(a116*a146);
  a007=(a007+a146);
  a171=(a261*a171);
  a007=(a007+a171);
  a198=(a262*a198);
  a007=(a007+a198);
  a226=(a263*a226);
  a007=(a007+a226);
  a255=(a264*a255);
  a007=(a007+a255);
  a282=(a265*a282);
  a007=(a007+a282);
  a017=(a017+a007);
  a007=(a220*a017);
  a154=(a154+a007);
  a039=(a039/a025);
  a007=(a019*a039);
  a282=(a280*a007);
  a255=(a031*a039);
  a282=(a282+a255);
  a255=(a253*a075);
  a055=(a260*a055);
  a255=(a255+a055);
  a081=(a095*a081);
  a255=(a255+a081);
  a071=(a116*a071);
  a255=(a255+a071);
  a296=(a261*a296);
  a255=(a255+a296);
  a301=(a262*a301);
  a255=(a255+a301);
  a306=(a263*a306);
  a255=(a255+a306);
  a244=(a264*a244);
  a255=(a255+a244);
  a097=(a265*a097);
  a255=(a255+a097);
  a130=(a130+a255);
  a255=(a282*a130);
  a154=(a154-a255);
  a010=(a010*a277);
  a010=(a010*a249);
  a255=(a010/a078);
  a097=(a018*a258);
  a097=(a097*a249);
  a244=(a280*a010);
  a097=(a097-a244);
  a244=(a097/a030);
  a033=(a033*a258);
  a033=(a033*a192);
  a010=(a031*a010);
  a033=(a033+a010);
  a097=(a019*a097);
  a033=(a033-a097);
  a033=(a033/a025);
  a097=(a019*a033);
  a244=(a244-a097);
  a097=(a280*a244);
  a255=(a255-a097);
  a097=(a031*a033);
  a255=(a255+a097);
  a097=(a255*a307);
  a018=(a018*a249);
  a277=(a277-a258);
  a018=(a018*a277);
  a078=(a018/a078);
  a277=(a280*a018);
  a015=(a015+a277);
  a030=(a015/a030);
  a018=(a031*a018);
  a015=(a019*a015);
  a018=(a018+a015);
  a018=(a018/a025);
  a019=(a019*a018);
  a030=(a030+a019);
  a280=(a280*a030);
  a078=(a078+a280);
  a031=(a031*a018);
  a078=(a078+a031);
  a031=(a078*a310);
  a097=(a097+a031);
  a154=(a154+a097);
  a154=(a250*a154);
  a182=(a182+a154);
  a009=(a009+a182);
  if (res[0]!=0) res[0][9]=a009;
  a066=(a001*a066);
  a167=(a005*a167);
  a066=(a066+a167);
  a194=(a117*a194);
  a066=(a066+a194);
  a222=(a141*a222);
  a066=(a066+a222);
  a251=(a166*a251);
  a066=(a066+a251);
  a278=(a193*a278);
  a066=(a066+a278);
  a142=(a221*a142);
  a066=(a066+a142);
  a142=(a129*a069);
  a278=(a029*a017);
  a142=(a142+a278);
  a278=(a007*a130);
  a142=(a142+a278);
  a278=(a244*a307);
  a251=(a030*a310);
  a278=(a278-a251);
  a142=(a142+a278);
  a142=(a250*a142);
  a066=(a066+a142);
  a036=(a036+a066);
  if (res[0]!=0) res[0][10]=a036;
  a052=(a001*a052);
  a104=(a005*a104);
  a052=(a052+a104);
  a022=(a117*a022);
  a052=(a052+a022);
  a125=(a141*a125);
  a052=(a052+a125);
  a149=(a166*a149);
  a052=(a052+a149);
  a174=(a193*a174);
  a052=(a052+a174);
  a254=(a221*a254);
  a052=(a052+a254);
  a069=(a209*a069);
  a017=(a285*a017);
  a069=(a069+a017);
  a130=(a039*a130);
  a069=(a069-a130);
  a307=(a033*a307);
  a310=(a018*a310);
  a307=(a307+a310);
  a069=(a069+a307);
  a069=(a250*a069);
  a052=(a052+a069);
  a075=(a075+a052);
  if (res[0]!=0) res[0][11]=a075;
  a075=arg[0]? arg[0][12] : 0;
  a052=arg[0]? arg[0][15] : 0;
  a069=(a001*a052);
  a307=(a038*a075);
  a310=arg[0]? arg[0][13] : 0;
  a130=(a012*a310);
  a307=(a307+a130);
  a130=arg[0]? arg[0][14] : 0;
  a017=(a016*a130);
  a307=(a307-a017);
  a017=(a240*a052);
  a254=arg[0]? arg[0][16] : 0;
  a174=(a020*a254);
  a017=(a017+a174);
  a307=(a307+a017);
  a017=(a006*a307);
  a174=(a041*a052);
  a149=(a044*a307);
  a125=(a047*a052);
  a125=(a075+a125);
  a022=(a068*a125);
  a104=(a047*a254);
  a104=(a310+a104);
  a036=(a053*a104);
  a022=(a022+a036);
  a036=arg[0]? arg[0][17] : 0;
  a066=(a047*a036);
  a066=(a130+a066);
  a142=(a106*a066);
  a022=(a022-a142);
  a142=(a047*a307);
  a142=(a052+a142);
  a278=(a288*a142);
  a251=(a155*a075);
  a222=(a014*a310);
  a251=(a251+a222);
  a222=(a210*a130);
  a251=(a251+a222);
  a222=(a183*a052);
  a194=(a032*a254);
  a222=(a222-a194);
  a251=(a251+a222);
  a222=(a047*a251);
  a222=(a254+a222);
  a194=(a059*a222);
  a278=(a278+a194);
  a022=(a022+a278);
  a022=(a046*a022);
  a149=(a149+a022);
  a149=(a052+a149);
  a022=(a043*a149);
  a174=(a174+a022);
  a174=(a075+a174);
  a022=(a103*a174);
  a278=(a041*a254);
  a194=(a044*a251);
  a167=(a021*a125);
  a009=(a056*a104);
  a167=(a167+a009);
  a009=(a054*a066);
  a167=(a167+a009);
  a009=(a286*a142);
  a182=(a057*a222);
  a009=(a009-a182);
  a167=(a167+a009);
  a167=(a046*a167);
  a194=(a194+a167);
  a194=(a254+a194);
  a167=(a043*a194);
  a278=(a278+a167);
  a278=(a310+a278);
  a167=(a088*a278);
  a022=(a022+a167);
  a167=(a041*a036);
  a009=(a239*a075);
  a182=(a024*a310);
  a009=(a009+a182);
  a182=(a266*a130);
  a009=(a009-a182);
  a182=(a156*a052);
  a154=(a011*a254);
  a182=(a182+a154);
  a009=(a009+a182);
  a182=(a044*a009);
  a125=(a267*a125);
  a104=(a063*a104);
  a125=(a125+a104);
  a066=(a089*a066);
  a125=(a125-a066);
  a066=(a259*a142);
  a104=(a051*a222);
  a066=(a066+a104);
  a125=(a125+a066);
  a125=(a046*a125);
  a182=(a182+a125);
  a182=(a036+a182);
  a125=(a043*a182);
  a167=(a167+a125);
  a167=(a130+a167);
  a125=(a065*a167);
  a022=(a022-a125);
  a125=(a041*a307);
  a066=(a044*a052);
  a142=(a046*a142);
  a066=(a066+a142);
  a066=(a075+a066);
  a142=(a085*a066);
  a104=(a044*a254);
  a222=(a046*a222);
  a104=(a104+a222);
  a104=(a310+a104);
  a222=(a077*a104);
  a142=(a142+a222);
  a222=(a044*a036);
  a154=(a047*a009);
  a154=(a036+a154);
  a154=(a046*a154);
  a222=(a222+a154);
  a222=(a130+a222);
  a154=(a175*a222);
  a142=(a142-a154);
  a154=(a287*a149);
  a097=(a050*a194);
  a154=(a154+a097);
  a142=(a142+a154);
  a154=(a043*a142);
  a125=(a125+a154);
  a125=(a052+a125);
  a154=(a026*a125);
  a097=(a041*a251);
  a031=(a105*a066);
  a280=(a072*a104);
  a031=(a031+a280);
  a280=(a131*a222);
  a031=(a031+a280);
  a280=(a290*a149);
  a019=(a079*a194);
  a280=(a280-a019);
  a031=(a031+a280);
  a280=(a043*a031);
  a097=(a097+a280);
  a097=(a254+a097);
  a280=(a094*a097);
  a154=(a154+a280);
  a022=(a022+a154);
  a154=(a028*a022);
  a017=(a017+a154);
  a154=(a099*a052);
  a280=(a049*a149);
  a154=(a154+a280);
  a280=(a080*a125);
  a154=(a154+a280);
  a154=(a075+a154);
  a280=(a124*a154);
  a019=(a099*a254);
  a025=(a049*a194);
  a019=(a019+a025);
  a025=(a080*a097);
  a019=(a019+a025);
  a019=(a310+a019);
  a025=(a076*a019);
  a280=(a280+a025);
  a025=(a099*a036);
  a182=(a049*a182);
  a025=(a025+a182);
  a182=(a041*a009);
  a066=(a090*a066);
  a104=(a060*a104);
  a066=(a066+a104);
  a222=(a062*a222);
  a066=(a066-a222);
  a149=(a291*a149);
  a194=(a064*a194);
  a149=(a149+a194);
  a066=(a066+a149);
  a149=(a043*a066);
  a182=(a182+a149);
  a182=(a036+a182);
  a149=(a080*a182);
  a025=(a025+a149);
  a025=(a130+a025);
  a149=(a082*a025);
  a280=(a280-a149);
  a149=(a099*a307);
  a142=(a049*a142);
  a149=(a149+a142);
  a142=(a080*a022);
  a149=(a149+a142);
  a149=(a052+a149);
  a142=(a023*a149);
  a194=(a099*a251);
  a031=(a049*a031);
  a194=(a194+a031);
  a031=(a003*a174);
  a222=(a091*a278);
  a031=(a031+a222);
  a222=(a067*a167);
  a031=(a031+a222);
  a222=(a230*a125);
  a104=(a092*a097);
  a222=(a222-a104);
  a031=(a031+a222);
  a222=(a080*a031);
  a194=(a194+a222);
  a194=(a254+a194);
  a222=(a115*a194);
  a142=(a142+a222);
  a280=(a280+a142);
  a142=(a096*a280);
  a017=(a017+a142);
  a017=(a052+a017);
  a142=(a005*a017);
  a069=(a069+a142);
  a142=(a120*a307);
  a222=(a126*a022);
  a142=(a142+a222);
  a222=(a127*a280);
  a142=(a142+a222);
  a222=(a006*a052);
  a104=(a028*a125);
  a222=(a222+a104);
  a104=(a096*a149);
  a222=(a222+a104);
  a222=(a075+a222);
  a104=(a148*a222);
  a015=(a006*a254);
  a277=(a028*a097);
  a015=(a015+a277);
  a277=(a096*a194);
  a015=(a015+a277);
  a015=(a310+a015);
  a277=(a133*a015);
  a104=(a104+a277);
  a277=(a006*a036);
  a258=(a028*a182);
  a277=(a277+a258);
  a258=(a099*a009);
  a066=(a049*a066);
  a258=(a258+a066);
  a174=(a037*a174);
  a278=(a098*a278);
  a174=(a174+a278);
  a167=(a040*a167);
  a174=(a174-a167);
  a167=(a202*a125);
  a278=(a086*a097);
  a167=(a167+a278);
  a174=(a174+a167);
  a167=(a080*a174);
  a258=(a258+a167);
  a258=(a036+a258);
  a167=(a096*a258);
  a277=(a277+a167);
  a277=(a130+a277);
  a167=(a035*a277);
  a104=(a104-a167);
  a167=(a093*a017);
  a278=(a006*a251);
  a066=(a028*a031);
  a278=(a278+a066);
  a066=(a087*a154);
  a249=(a112*a019);
  a066=(a066+a249);
  a249=(a110*a025);
  a066=(a066+a249);
  a249=(a073*a149);
  a010=(a113*a194);
  a249=(a249-a010);
  a066=(a066+a249);
  a249=(a096*a066);
  a278=(a278+a249);
  a278=(a254+a278);
  a249=(a139*a278);
  a167=(a167+a249);
  a104=(a104+a167);
  a167=(a128*a104);
  a142=(a142+a167);
  a142=(a052+a142);
  a167=(a117*a142);
  a069=(a069+a167);
  a167=(a144*a307);
  a249=(a084*a022);
  a167=(a167+a249);
  a249=(a151*a280);
  a167=(a167+a249);
  a249=(a152*a104);
  a167=(a167+a249);
  a249=(a120*a052);
  a010=(a126*a125);
  a249=(a249+a010);
  a010=(a127*a149);
  a249=(a249+a010);
  a010=(a128*a017);
  a249=(a249+a010);
  a249=(a075+a249);
  a010=(a173*a249);
  a192=(a120*a254);
  a306=(a126*a097);
  a192=(a192+a306);
  a306=(a127*a194);
  a192=(a192+a306);
  a306=(a128*a278);
  a192=(a192+a306);
  a192=(a310+a192);
  a306=(a158*a192);
  a010=(a010+a306);
  a306=(a120*a036);
  a301=(a126*a182);
  a306=(a306+a301);
  a301=(a127*a258);
  a306=(a306+a301);
  a301=(a006*a009);
  a296=(a028*a174);
  a301=(a301+a296);
  a154=(a102*a154);
  a019=(a119*a019);
  a154=(a154+a019);
  a025=(a289*a025);
  a154=(a154-a025);
  a025=(a083*a149);
  a019=(a108*a194);
  a025=(a025+a019);
  a154=(a154+a025);
  a025=(a096*a154);
  a301=(a301+a025);
  a301=(a036+a301);
  a025=(a128*a301);
  a306=(a306+a025);
  a306=(a130+a306);
  a025=(a135*a306);
  a010=(a010-a025);
  a025=(a114*a142);
  a019=(a120*a251);
  a296=(a126*a031);
  a019=(a019+a296);
  a296=(a127*a066);
  a019=(a019+a296);
  a296=(a109*a222);
  a071=(a136*a015);
  a296=(a296+a071);
  a071=(a134*a277);
  a296=(a296+a071);
  a071=(a074*a017);
  a081=(a137*a278);
  a071=(a071-a081);
  a296=(a296+a071);
  a071=(a128*a296);
  a019=(a019+a071);
  a019=(a254+a019);
  a071=(a164*a019);
  a025=(a025+a071);
  a010=(a010+a025);
  a025=(a153*a010);
  a167=(a167+a025);
  a167=(a052+a167);
  a025=(a141*a167);
  a069=(a069+a025);
  a025=(a169*a307);
  a071=(a176*a022);
  a025=(a025+a071);
  a071=(a177*a280);
  a025=(a025+a071);
  a071=(a178*a104);
  a025=(a025+a071);
  a071=(a179*a010);
  a025=(a025+a071);
  a071=(a144*a052);
  a081=(a084*a125);
  a071=(a071+a081);
  a081=(a151*a149);
  a071=(a071+a081);
  a081=(a152*a017);
  a071=(a071+a081);
  a081=(a153*a142);
  a071=(a071+a081);
  a071=(a075+a071);
  a081=(a200*a071);
  a055=(a144*a254);
  a226=(a084*a097);
  a055=(a055+a226);
  a226=(a151*a194);
  a055=(a055+a226);
  a226=(a152*a278);
  a055=(a055+a226);
  a226=(a153*a019);
  a055=(a055+a226);
  a055=(a310+a055);
  a226=(a185*a055);
  a081=(a081+a226);
  a226=(a144*a036);
  a198=(a084*a182);
  a226=(a226+a198);
  a198=(a151*a258);
  a226=(a226+a198);
  a198=(a152*a301);
  a226=(a226+a198);
  a198=(a120*a009);
  a171=(a126*a174);
  a198=(a198+a171);
  a171=(a127*a154);
  a198=(a198+a171);
  a222=(a123*a222);
  a015=(a143*a015);
  a222=(a222+a015);
  a277=(a118*a277);
  a222=(a222-a277);
  a277=(a045*a017);
  a015=(a132*a278);
  a277=(a277+a015);
  a222=(a222+a277);
  a277=(a128*a222);
  a198=(a198+a277);
  a198=(a036+a198);
  a277=(a153*a198);
  a226=(a226+a277);
  a226=(a130+a226);
  a277=(a160*a226);
  a081=(a081-a277);
  a277=(a138*a167);
  a015=(a144*a251);
  a171=(a084*a031);
  a015=(a015+a171);
  a171=(a151*a066);
  a015=(a015+a171);
  a171=(a152*a296);
  a015=(a015+a171);
  a171=(a048*a249);
  a146=(a161*a192);
  a171=(a171+a146);
  a146=(a159*a306);
  a171=(a171+a146);
  a146=(a293*a142);
  a122=(a162*a019);
  a146=(a146-a122);
  a171=(a171+a146);
  a146=(a153*a171);
  a015=(a015+a146);
  a015=(a254+a015);
  a146=(a191*a015);
  a277=(a277+a146);
  a081=(a081+a277);
  a277=(a180*a081);
  a025=(a025+a277);
  a025=(a052+a025);
  a277=(a166*a025);
  a069=(a069+a277);
  a277=(a196*a307);
  a146=(a203*a022);
  a277=(a277+a146);
  a146=(a204*a280);
  a277=(a277+a146);
  a146=(a205*a104);
  a277=(a277+a146);
  a146=(a206*a010);
  a277=(a277+a146);
  a146=(a207*a081);
  a277=(a277+a146);
  a146=(a169*a052);
  a122=(a176*a125);
  a146=(a146+a122);
  a122=(a177*a149);
  a146=(a146+a122);
  a122=(a178*a017);
  a146=(a146+a122);
  a122=(a179*a142);
  a146=(a146+a122);
  a122=(a180*a167);
  a146=(a146+a122);
  a146=(a075+a146);
  a122=(a228*a146);
  a101=(a169*a254);
  a004=(a176*a097);
  a101=(a101+a004);
  a004=(a177*a194);
  a101=(a101+a004);
  a004=(a178*a278);
  a101=(a101+a004);
  a004=(a179*a019);
  a101=(a101+a004);
  a004=(a180*a015);
  a101=(a101+a004);
  a101=(a310+a101);
  a004=(a213*a101);
  a122=(a122+a004);
  a004=(a169*a036);
  a165=(a176*a182);
  a004=(a004+a165);
  a165=(a177*a258);
  a004=(a004+a165);
  a165=(a178*a301);
  a004=(a004+a165);
  a165=(a179*a198);
  a004=(a004+a165);
  a165=(a144*a009);
  a256=(a084*a174);
  a165=(a165+a256);
  a256=(a151*a154);
  a165=(a165+a256);
  a256=(a152*a222);
  a165=(a165+a256);
  a249=(a145*a249);
  a192=(a168*a192);
  a249=(a249+a192);
  a306=(a147*a306);
  a249=(a249-a306);
  a306=(a294*a142);
  a192=(a157*a019);
  a306=(a306+a192);
  a249=(a249+a306);
  a306=(a153*a249);
  a165=(a165+a306);
  a165=(a036+a165);
  a306=(a180*a165);
  a004=(a004+a306);
  a004=(a130+a004);
  a306=(a187*a004);
  a122=(a122-a306);
  a306=(a163*a025);
  a192=(a169*a251);
  a256=(a176*a031);
  a192=(a192+a256);
  a256=(a177*a066);
  a192=(a192+a256);
  a256=(a178*a296);
  a192=(a192+a256);
  a256=(a179*a171);
  a192=(a192+a256);
  a256=(a061*a071);
  a302=(a188*a055);
  a256=(a256+a302);
  a302=(a186*a226);
  a256=(a256+a302);
  a302=(a298*a167);
  a297=(a189*a015);
  a302=(a302-a297);
  a256=(a256+a302);
  a302=(a180*a256);
  a192=(a192+a302);
  a192=(a254+a192);
  a302=(a219*a192);
  a306=(a306+a302);
  a122=(a122+a306);
  a306=(a208*a122);
  a277=(a277+a306);
  a277=(a052+a277);
  a306=(a193*a277);
  a069=(a069+a306);
  a306=(a224*a307);
  a302=(a231*a022);
  a306=(a306+a302);
  a302=(a232*a280);
  a306=(a306+a302);
  a302=(a233*a104);
  a306=(a306+a302);
  a302=(a234*a010);
  a306=(a306+a302);
  a302=(a235*a081);
  a306=(a306+a302);
  a302=(a236*a122);
  a306=(a306+a302);
  a302=(a196*a052);
  a297=(a203*a125);
  a302=(a302+a297);
  a297=(a204*a149);
  a302=(a302+a297);
  a297=(a205*a017);
  a302=(a302+a297);
  a297=(a206*a142);
  a302=(a302+a297);
  a297=(a207*a167);
  a302=(a302+a297);
  a297=(a208*a025);
  a302=(a302+a297);
  a302=(a075+a302);
  a297=(a257*a302);
  a292=(a196*a254);
  a150=(a203*a097);
  a292=(a292+a150);
  a150=(a204*a194);
  a292=(a292+a150);
  a150=(a205*a278);
  a292=(a292+a150);
  a150=(a206*a019);
  a292=(a292+a150);
  a150=(a207*a015);
  a292=(a292+a150);
  a150=(a208*a192);
  a292=(a292+a150);
  a292=(a310+a292);
  a150=(a242*a292);
  a297=(a297+a150);
  a150=(a196*a036);
  a107=(a203*a182);
  a150=(a150+a107);
  a107=(a204*a258);
  a150=(a150+a107);
  a107=(a205*a301);
  a150=(a150+a107);
  a107=(a206*a198);
  a150=(a150+a107);
  a107=(a207*a165);
  a150=(a150+a107);
  a107=(a169*a009);
  a211=(a176*a174);
  a107=(a107+a211);
  a211=(a177*a154);
  a107=(a107+a211);
  a211=(a178*a222);
  a107=(a107+a211);
  a211=(a179*a249);
  a107=(a107+a211);
  a071=(a170*a071);
  a055=(a195*a055);
  a071=(a071+a055);
  a226=(a172*a226);
  a071=(a071-a226);
  a226=(a299*a167);
  a055=(a184*a015);
  a226=(a226+a055);
  a071=(a071+a226);
  a226=(a180*a071);
  a107=(a107+a226);
  a107=(a036+a107);
  a226=(a208*a107);
  a150=(a150+a226);
  a150=(a130+a150);
  a226=(a215*a150);
  a297=(a297-a226);
  a226=(a190*a277);
  a055=(a196*a251);
  a211=(a203*a031);
  a055=(a055+a211);
  a211=(a204*a066);
  a055=(a055+a211);
  a211=(a205*a296);
  a055=(a055+a211);
  a211=(a206*a171);
  a055=(a055+a211);
  a211=(a207*a256);
  a055=(a055+a211);
  a211=(a111*a146);
  a070=(a216*a101);
  a211=(a211+a070);
  a070=(a214*a004);
  a211=(a211+a070);
  a070=(a303*a025);
  a058=(a217*a192);
  a070=(a070-a058);
  a211=(a211+a070);
  a070=(a208*a211);
  a055=(a055+a070);
  a055=(a254+a055);
  a070=(a248*a055);
  a226=(a226+a070);
  a297=(a297+a226);
  a226=(a237*a297);
  a306=(a306+a226);
  a306=(a052+a306);
  a226=(a221*a306);
  a069=(a069+a226);
  a226=(a253*a307);
  a022=(a260*a022);
  a226=(a226+a022);
  a280=(a095*a280);
  a226=(a226+a280);
  a280=(a116*a104);
  a226=(a226+a280);
  a280=(a261*a010);
  a226=(a226+a280);
  a280=(a262*a081);
  a226=(a226+a280);
  a280=(a263*a122);
  a226=(a226+a280);
  a280=(a264*a297);
  a226=(a226+a280);
  a280=(a224*a052);
  a022=(a231*a125);
  a280=(a280+a022);
  a022=(a232*a149);
  a280=(a280+a022);
  a022=(a233*a017);
  a280=(a280+a022);
  a022=(a234*a142);
  a280=(a280+a022);
  a022=(a235*a167);
  a280=(a280+a022);
  a022=(a236*a025);
  a280=(a280+a022);
  a022=(a237*a277);
  a280=(a280+a022);
  a280=(a075+a280);
  a022=(a284*a280);
  a070=(a224*a254);
  a058=(a231*a097);
  a070=(a070+a058);
  a058=(a232*a194);
  a070=(a070+a058);
  a058=(a233*a278);
  a070=(a070+a058);
  a058=(a234*a019);
  a070=(a070+a058);
  a058=(a235*a015);
  a070=(a070+a058);
  a058=(a236*a192);
  a070=(a070+a058);
  a058=(a237*a055);
  a070=(a070+a058);
  a070=(a310+a070);
  a058=(a269*a070);
  a022=(a022+a058);
  a058=(a224*a036);
  a034=(a231*a182);
  a058=(a058+a034);
  a034=(a232*a258);
  a058=(a058+a034);
  a034=(a233*a301);
  a058=(a058+a034);
  a034=(a234*a198);
  a058=(a058+a034);
  a034=(a235*a165);
  a058=(a058+a034);
  a034=(a236*a107);
  a058=(a058+a034);
  a034=(a196*a009);
  a181=(a203*a174);
  a034=(a034+a181);
  a181=(a204*a154);
  a034=(a034+a181);
  a181=(a205*a222);
  a034=(a034+a181);
  a181=(a206*a249);
  a034=(a034+a181);
  a181=(a207*a071);
  a034=(a034+a181);
  a146=(a197*a146);
  a101=(a223*a101);
  a146=(a146+a101);
  a004=(a199*a004);
  a146=(a146-a004);
  a004=(a304*a025);
  a101=(a212*a192);
  a004=(a004+a101);
  a146=(a146+a004);
  a004=(a208*a146);
  a034=(a034+a004);
  a034=(a036+a034);
  a004=(a237*a034);
  a058=(a058+a004);
  a058=(a130+a058);
  a004=(a201*a058);
  a022=(a022-a004);
  a004=(a218*a306);
  a101=(a224*a251);
  a181=(a231*a031);
  a101=(a101+a181);
  a181=(a232*a066);
  a101=(a101+a181);
  a181=(a233*a296);
  a101=(a101+a181);
  a181=(a234*a171);
  a101=(a101+a181);
  a181=(a235*a256);
  a101=(a101+a181);
  a181=(a236*a211);
  a101=(a101+a181);
  a181=(a140*a302);
  a000=(a245*a292);
  a181=(a181+a000);
  a000=(a243*a150);
  a181=(a181+a000);
  a000=(a308*a277);
  a121=(a246*a055);
  a000=(a000-a121);
  a181=(a181+a000);
  a000=(a237*a181);
  a101=(a101+a000);
  a101=(a254+a101);
  a000=(a275*a101);
  a004=(a004+a000);
  a022=(a022+a004);
  a004=(a265*a022);
  a226=(a226+a004);
  a226=(a052+a226);
  a004=(a250*a226);
  a069=(a069+a004);
  a069=(a075+a069);
  if (res[0]!=0) res[0][12]=a069;
  a069=(a001*a254);
  a004=(a005*a278);
  a069=(a069+a004);
  a004=(a117*a019);
  a069=(a069+a004);
  a004=(a141*a015);
  a069=(a069+a004);
  a004=(a166*a192);
  a069=(a069+a004);
  a004=(a193*a055);
  a069=(a069+a004);
  a004=(a221*a101);
  a069=(a069+a004);
  a004=(a253*a251);
  a031=(a260*a031);
  a004=(a004+a031);
  a066=(a095*a066);
  a004=(a004+a066);
  a066=(a116*a296);
  a004=(a004+a066);
  a066=(a261*a171);
  a004=(a004+a066);
  a066=(a262*a256);
  a004=(a004+a066);
  a066=(a263*a211);
  a004=(a004+a066);
  a066=(a264*a181);
  a004=(a004+a066);
  a066=(a238*a280);
  a031=(a272*a070);
  a066=(a066+a031);
  a031=(a270*a058);
  a066=(a066+a031);
  a031=(a311*a306);
  a000=(a273*a101);
  a031=(a031-a000);
  a066=(a066+a031);
  a031=(a265*a066);
  a004=(a004+a031);
  a004=(a254+a004);
  a031=(a250*a004);
  a069=(a069+a031);
  a069=(a310+a069);
  if (res[0]!=0) res[0][13]=a069;
  a069=(a001*a036);
  a031=(a005*a301);
  a069=(a069+a031);
  a031=(a117*a198);
  a069=(a069+a031);
  a031=(a141*a165);
  a069=(a069+a031);
  a031=(a166*a107);
  a069=(a069+a031);
  a031=(a193*a034);
  a069=(a069+a031);
  a031=(a224*a009);
  a000=(a231*a174);
  a031=(a031+a000);
  a000=(a232*a154);
  a031=(a031+a000);
  a000=(a233*a222);
  a031=(a031+a000);
  a000=(a234*a249);
  a031=(a031+a000);
  a000=(a235*a071);
  a031=(a031+a000);
  a000=(a236*a146);
  a031=(a031+a000);
  a302=(a225*a302);
  a292=(a252*a292);
  a302=(a302+a292);
  a150=(a227*a150);
  a302=(a302-a150);
  a150=(a309*a277);
  a292=(a241*a055);
  a150=(a150+a292);
  a302=(a302+a150);
  a150=(a237*a302);
  a031=(a031+a150);
  a031=(a036+a031);
  a150=(a221*a031);
  a069=(a069+a150);
  a150=(a253*a009);
  a174=(a260*a174);
  a150=(a150+a174);
  a154=(a095*a154);
  a150=(a150+a154);
  a154=(a116*a222);
  a150=(a150+a154);
  a154=(a261*a249);
  a150=(a150+a154);
  a154=(a262*a071);
  a150=(a150+a154);
  a154=(a263*a146);
  a150=(a150+a154);
  a154=(a264*a302);
  a150=(a150+a154);
  a280=(a013*a280);
  a070=(a279*a070);
  a280=(a280+a070);
  a058=(a100*a058);
  a280=(a280-a058);
  a058=(a312*a306);
  a070=(a268*a101);
  a058=(a058+a070);
  a280=(a280+a058);
  a058=(a265*a280);
  a150=(a150+a058);
  a150=(a036+a150);
  a150=(a250*a150);
  a069=(a069+a150);
  a069=(a130+a069);
  if (res[0]!=0) res[0][14]=a069;
  a307=(a001*a307);
  a104=(a005*a104);
  a307=(a307+a104);
  a010=(a117*a010);
  a307=(a307+a010);
  a081=(a141*a081);
  a307=(a307+a081);
  a122=(a166*a122);
  a307=(a307+a122);
  a297=(a193*a297);
  a307=(a307+a297);
  a022=(a221*a022);
  a307=(a307+a022);
  a022=(a253*a052);
  a125=(a260*a125);
  a022=(a022+a125);
  a149=(a095*a149);
  a022=(a022+a149);
  a017=(a116*a017);
  a022=(a022+a017);
  a142=(a261*a142);
  a022=(a022+a142);
  a167=(a262*a167);
  a022=(a022+a167);
  a025=(a263*a025);
  a022=(a022+a025);
  a277=(a264*a277);
  a022=(a022+a277);
  a306=(a265*a306);
  a022=(a022+a306);
  a075=(a075+a022);
  a022=(a027*a075);
  a306=(a253*a254);
  a097=(a260*a097);
  a306=(a306+a097);
  a194=(a095*a194);
  a306=(a306+a194);
  a278=(a116*a278);
  a306=(a306+a278);
  a019=(a261*a019);
  a306=(a306+a019);
  a015=(a262*a015);
  a306=(a306+a015);
  a192=(a263*a192);
  a306=(a306+a192);
  a055=(a264*a055);
  a306=(a306+a055);
  a101=(a265*a101);
  a306=(a306+a101);
  a310=(a310+a306);
  a306=(a220*a310);
  a022=(a022+a306);
  a306=(a253*a036);
  a182=(a260*a182);
  a306=(a306+a182);
  a258=(a095*a258);
  a306=(a306+a258);
  a301=(a116*a301);
  a306=(a306+a301);
  a198=(a261*a198);
  a306=(a306+a198);
  a165=(a262*a165);
  a306=(a306+a165);
  a107=(a263*a107);
  a306=(a306+a107);
  a034=(a264*a034);
  a306=(a306+a034);
  a031=(a265*a031);
  a306=(a306+a031);
  a130=(a130+a306);
  a306=(a282*a130);
  a022=(a022-a306);
  a306=(a255*a226);
  a031=(a078*a004);
  a306=(a306+a031);
  a022=(a022+a306);
  a022=(a250*a022);
  a307=(a307+a022);
  a052=(a052+a307);
  if (res[0]!=0) res[0][15]=a052;
  a251=(a001*a251);
  a296=(a005*a296);
  a251=(a251+a296);
  a171=(a117*a171);
  a251=(a251+a171);
  a256=(a141*a256);
  a251=(a251+a256);
  a211=(a166*a211);
  a251=(a251+a211);
  a181=(a193*a181);
  a251=(a251+a181);
  a066=(a221*a066);
  a251=(a251+a066);
  a066=(a129*a075);
  a181=(a029*a310);
  a066=(a066+a181);
  a181=(a007*a130);
  a066=(a066+a181);
  a181=(a244*a226);
  a211=(a030*a004);
  a181=(a181-a211);
  a066=(a066+a181);
  a066=(a250*a066);
  a251=(a251+a066);
  a254=(a254+a251);
  if (res[0]!=0) res[0][16]=a254;
  a009=(a001*a009);
  a222=(a005*a222);
  a009=(a009+a222);
  a249=(a117*a249);
  a009=(a009+a249);
  a071=(a141*a071);
  a009=(a009+a071);
  a146=(a166*a146);
  a009=(a009+a146);
  a302=(a193*a302);
  a009=(a009+a302);
  a280=(a221*a280);
  a009=(a009+a280);
  a075=(a209*a075);
  a310=(a285*a310);
  a075=(a075+a310);
  a130=(a039*a130);
  a075=(a075-a130);
  a226=(a033*a226);
  a004=(a018*a004);
  a226=(a226+a004);
  a075=(a075+a226);
  a075=(a250*a075);
  a009=(a009+a075);
  a036=(a036+a009);
  if (res[0]!=0) res[0][17]=a036;
  a036=arg[0]? arg[0][18] : 0;
  a009=arg[0]? arg[0][21] : 0;
  a075=(a001*a009);
  a226=(a038*a036);
  a004=arg[0]? arg[0][19] : 0;
  a130=(a012*a004);
  a226=(a226+a130);
  a130=arg[0]? arg[0][20] : 0;
  a310=(a016*a130);
  a226=(a226-a310);
  a310=(a240*a009);
  a280=arg[0]? arg[0][22] : 0;
  a302=(a020*a280);
  a310=(a310+a302);
  a226=(a226+a310);
  a310=(a006*a226);
  a302=(a041*a009);
  a146=(a044*a226);
  a071=(a047*a009);
  a071=(a036+a071);
  a249=(a068*a071);
  a222=(a047*a280);
  a222=(a004+a222);
  a254=(a053*a222);
  a249=(a249+a254);
  a254=arg[0]? arg[0][23] : 0;
  a251=(a047*a254);
  a251=(a130+a251);
  a066=(a106*a251);
  a249=(a249-a066);
  a066=(a047*a226);
  a066=(a009+a066);
  a181=(a288*a066);
  a211=(a155*a036);
  a256=(a014*a004);
  a211=(a211+a256);
  a256=(a210*a130);
  a211=(a211+a256);
  a256=(a183*a009);
  a171=(a032*a280);
  a256=(a256-a171);
  a211=(a211+a256);
  a256=(a047*a211);
  a256=(a280+a256);
  a171=(a059*a256);
  a181=(a181+a171);
  a249=(a249+a181);
  a249=(a046*a249);
  a146=(a146+a249);
  a146=(a009+a146);
  a249=(a043*a146);
  a302=(a302+a249);
  a302=(a036+a302);
  a249=(a103*a302);
  a181=(a041*a280);
  a171=(a044*a211);
  a296=(a021*a071);
  a052=(a056*a222);
  a296=(a296+a052);
  a052=(a054*a251);
  a296=(a296+a052);
  a052=(a286*a066);
  a307=(a057*a256);
  a052=(a052-a307);
  a296=(a296+a052);
  a296=(a046*a296);
  a171=(a171+a296);
  a171=(a280+a171);
  a296=(a043*a171);
  a181=(a181+a296);
  a181=(a004+a181);
  a296=(a088*a181);
  a249=(a249+a296);
  a296=(a041*a254);
  a052=(a239*a036);
  a307=(a024*a004);
  a052=(a052+a307);
  a307=(a266*a130);
  a052=(a052-a307);
  a307=(a156*a009);
  a022=(a011*a280);
  a307=(a307+a022);
  a052=(a052+a307);
  a307=(a044*a052);
  a071=(a267*a071);
  a222=(a063*a222);
  a071=(a071+a222);
  a251=(a089*a251);
  a071=(a071-a251);
  a251=(a259*a066);
  a222=(a051*a256);
  a251=(a251+a222);
  a071=(a071+a251);
  a071=(a046*a071);
  a307=(a307+a071);
  a307=(a254+a307);
  a071=(a043*a307);
  a296=(a296+a071);
  a296=(a130+a296);
  a071=(a065*a296);
  a249=(a249-a071);
  a071=(a041*a226);
  a251=(a044*a009);
  a066=(a046*a066);
  a251=(a251+a066);
  a251=(a036+a251);
  a066=(a085*a251);
  a222=(a044*a280);
  a256=(a046*a256);
  a222=(a222+a256);
  a222=(a004+a222);
  a256=(a077*a222);
  a066=(a066+a256);
  a256=(a044*a254);
  a022=(a047*a052);
  a022=(a254+a022);
  a022=(a046*a022);
  a256=(a256+a022);
  a256=(a130+a256);
  a022=(a175*a256);
  a066=(a066-a022);
  a022=(a287*a146);
  a306=(a050*a171);
  a022=(a022+a306);
  a066=(a066+a022);
  a022=(a043*a066);
  a071=(a071+a022);
  a071=(a009+a071);
  a022=(a026*a071);
  a306=(a041*a211);
  a031=(a105*a251);
  a034=(a072*a222);
  a031=(a031+a034);
  a034=(a131*a256);
  a031=(a031+a034);
  a034=(a290*a146);
  a107=(a079*a171);
  a034=(a034-a107);
  a031=(a031+a034);
  a034=(a043*a031);
  a306=(a306+a034);
  a306=(a280+a306);
  a034=(a094*a306);
  a022=(a022+a034);
  a249=(a249+a022);
  a022=(a028*a249);
  a310=(a310+a022);
  a022=(a099*a009);
  a034=(a049*a146);
  a022=(a022+a034);
  a034=(a080*a071);
  a022=(a022+a034);
  a022=(a036+a022);
  a034=(a124*a022);
  a107=(a099*a280);
  a165=(a049*a171);
  a107=(a107+a165);
  a165=(a080*a306);
  a107=(a107+a165);
  a107=(a004+a107);
  a165=(a076*a107);
  a034=(a034+a165);
  a165=(a099*a254);
  a307=(a049*a307);
  a165=(a165+a307);
  a307=(a041*a052);
  a251=(a090*a251);
  a222=(a060*a222);
  a251=(a251+a222);
  a256=(a062*a256);
  a251=(a251-a256);
  a146=(a291*a146);
  a171=(a064*a171);
  a146=(a146+a171);
  a251=(a251+a146);
  a146=(a043*a251);
  a307=(a307+a146);
  a307=(a254+a307);
  a146=(a080*a307);
  a165=(a165+a146);
  a165=(a130+a165);
  a146=(a082*a165);
  a034=(a034-a146);
  a146=(a099*a226);
  a066=(a049*a066);
  a146=(a146+a066);
  a066=(a080*a249);
  a146=(a146+a066);
  a146=(a009+a146);
  a066=(a023*a146);
  a171=(a099*a211);
  a031=(a049*a031);
  a171=(a171+a031);
  a031=(a003*a302);
  a256=(a091*a181);
  a031=(a031+a256);
  a256=(a067*a296);
  a031=(a031+a256);
  a256=(a230*a071);
  a222=(a092*a306);
  a256=(a256-a222);
  a031=(a031+a256);
  a256=(a080*a031);
  a171=(a171+a256);
  a171=(a280+a171);
  a256=(a115*a171);
  a066=(a066+a256);
  a034=(a034+a066);
  a066=(a096*a034);
  a310=(a310+a066);
  a310=(a009+a310);
  a066=(a005*a310);
  a075=(a075+a066);
  a066=(a120*a226);
  a256=(a126*a249);
  a066=(a066+a256);
  a256=(a127*a034);
  a066=(a066+a256);
  a256=(a006*a009);
  a222=(a028*a071);
  a256=(a256+a222);
  a222=(a096*a146);
  a256=(a256+a222);
  a256=(a036+a256);
  a222=(a148*a256);
  a198=(a006*a280);
  a301=(a028*a306);
  a198=(a198+a301);
  a301=(a096*a171);
  a198=(a198+a301);
  a198=(a004+a198);
  a301=(a133*a198);
  a222=(a222+a301);
  a301=(a006*a254);
  a258=(a028*a307);
  a301=(a301+a258);
  a258=(a099*a052);
  a251=(a049*a251);
  a258=(a258+a251);
  a302=(a037*a302);
  a181=(a098*a181);
  a302=(a302+a181);
  a296=(a040*a296);
  a302=(a302-a296);
  a296=(a202*a071);
  a181=(a086*a306);
  a296=(a296+a181);
  a302=(a302+a296);
  a296=(a080*a302);
  a258=(a258+a296);
  a258=(a254+a258);
  a296=(a096*a258);
  a301=(a301+a296);
  a301=(a130+a301);
  a296=(a035*a301);
  a222=(a222-a296);
  a296=(a093*a310);
  a181=(a006*a211);
  a251=(a028*a031);
  a181=(a181+a251);
  a251=(a087*a022);
  a182=(a112*a107);
  a251=(a251+a182);
  a182=(a110*a165);
  a251=(a251+a182);
  a182=(a073*a146);
  a101=(a113*a171);
  a182=(a182-a101);
  a251=(a251+a182);
  a182=(a096*a251);
  a181=(a181+a182);
  a181=(a280+a181);
  a182=(a139*a181);
  a296=(a296+a182);
  a222=(a222+a296);
  a296=(a128*a222);
  a066=(a066+a296);
  a066=(a009+a066);
  a296=(a117*a066);
  a075=(a075+a296);
  a296=(a144*a226);
  a182=(a084*a249);
  a296=(a296+a182);
  a182=(a151*a034);
  a296=(a296+a182);
  a182=(a152*a222);
  a296=(a296+a182);
  a182=(a120*a009);
  a101=(a126*a071);
  a182=(a182+a101);
  a101=(a127*a146);
  a182=(a182+a101);
  a101=(a128*a310);
  a182=(a182+a101);
  a182=(a036+a182);
  a101=(a173*a182);
  a055=(a120*a280);
  a192=(a126*a306);
  a055=(a055+a192);
  a192=(a127*a171);
  a055=(a055+a192);
  a192=(a128*a181);
  a055=(a055+a192);
  a055=(a004+a055);
  a192=(a158*a055);
  a101=(a101+a192);
  a192=(a120*a254);
  a015=(a126*a307);
  a192=(a192+a015);
  a015=(a127*a258);
  a192=(a192+a015);
  a015=(a006*a052);
  a019=(a028*a302);
  a015=(a015+a019);
  a022=(a102*a022);
  a107=(a119*a107);
  a022=(a022+a107);
  a165=(a289*a165);
  a022=(a022-a165);
  a165=(a083*a146);
  a107=(a108*a171);
  a165=(a165+a107);
  a022=(a022+a165);
  a165=(a096*a022);
  a015=(a015+a165);
  a015=(a254+a015);
  a165=(a128*a015);
  a192=(a192+a165);
  a192=(a130+a192);
  a165=(a135*a192);
  a101=(a101-a165);
  a165=(a114*a066);
  a107=(a120*a211);
  a019=(a126*a031);
  a107=(a107+a019);
  a019=(a127*a251);
  a107=(a107+a019);
  a019=(a109*a256);
  a278=(a136*a198);
  a019=(a019+a278);
  a278=(a134*a301);
  a019=(a019+a278);
  a278=(a074*a310);
  a194=(a137*a181);
  a278=(a278-a194);
  a019=(a019+a278);
  a278=(a128*a019);
  a107=(a107+a278);
  a107=(a280+a107);
  a278=(a164*a107);
  a165=(a165+a278);
  a101=(a101+a165);
  a165=(a153*a101);
  a296=(a296+a165);
  a296=(a009+a296);
  a165=(a141*a296);
  a075=(a075+a165);
  a165=(a169*a226);
  a278=(a176*a249);
  a165=(a165+a278);
  a278=(a177*a034);
  a165=(a165+a278);
  a278=(a178*a222);
  a165=(a165+a278);
  a278=(a179*a101);
  a165=(a165+a278);
  a278=(a144*a009);
  a194=(a084*a071);
  a278=(a278+a194);
  a194=(a151*a146);
  a278=(a278+a194);
  a194=(a152*a310);
  a278=(a278+a194);
  a194=(a153*a066);
  a278=(a278+a194);
  a278=(a036+a278);
  a194=(a200*a278);
  a097=(a144*a280);
  a277=(a084*a306);
  a097=(a097+a277);
  a277=(a151*a171);
  a097=(a097+a277);
  a277=(a152*a181);
  a097=(a097+a277);
  a277=(a153*a107);
  a097=(a097+a277);
  a097=(a004+a097);
  a277=(a185*a097);
  a194=(a194+a277);
  a277=(a144*a254);
  a025=(a084*a307);
  a277=(a277+a025);
  a025=(a151*a258);
  a277=(a277+a025);
  a025=(a152*a015);
  a277=(a277+a025);
  a025=(a120*a052);
  a167=(a126*a302);
  a025=(a025+a167);
  a167=(a127*a022);
  a025=(a025+a167);
  a256=(a123*a256);
  a198=(a143*a198);
  a256=(a256+a198);
  a301=(a118*a301);
  a256=(a256-a301);
  a301=(a045*a310);
  a198=(a132*a181);
  a301=(a301+a198);
  a256=(a256+a301);
  a301=(a128*a256);
  a025=(a025+a301);
  a025=(a254+a025);
  a301=(a153*a025);
  a277=(a277+a301);
  a277=(a130+a277);
  a301=(a160*a277);
  a194=(a194-a301);
  a301=(a138*a296);
  a198=(a144*a211);
  a167=(a084*a031);
  a198=(a198+a167);
  a167=(a151*a251);
  a198=(a198+a167);
  a167=(a152*a019);
  a198=(a198+a167);
  a167=(a048*a182);
  a142=(a161*a055);
  a167=(a167+a142);
  a142=(a159*a192);
  a167=(a167+a142);
  a142=(a293*a066);
  a017=(a162*a107);
  a142=(a142-a017);
  a167=(a167+a142);
  a142=(a153*a167);
  a198=(a198+a142);
  a198=(a280+a198);
  a142=(a191*a198);
  a301=(a301+a142);
  a194=(a194+a301);
  a301=(a180*a194);
  a165=(a165+a301);
  a165=(a009+a165);
  a301=(a166*a165);
  a075=(a075+a301);
  a301=(a196*a226);
  a142=(a203*a249);
  a301=(a301+a142);
  a142=(a204*a034);
  a301=(a301+a142);
  a142=(a205*a222);
  a301=(a301+a142);
  a142=(a206*a101);
  a301=(a301+a142);
  a142=(a207*a194);
  a301=(a301+a142);
  a142=(a169*a009);
  a017=(a176*a071);
  a142=(a142+a017);
  a017=(a177*a146);
  a142=(a142+a017);
  a017=(a178*a310);
  a142=(a142+a017);
  a017=(a179*a066);
  a142=(a142+a017);
  a017=(a180*a296);
  a142=(a142+a017);
  a142=(a036+a142);
  a017=(a228*a142);
  a149=(a169*a280);
  a125=(a176*a306);
  a149=(a149+a125);
  a125=(a177*a171);
  a149=(a149+a125);
  a125=(a178*a181);
  a149=(a149+a125);
  a125=(a179*a107);
  a149=(a149+a125);
  a125=(a180*a198);
  a149=(a149+a125);
  a149=(a004+a149);
  a125=(a213*a149);
  a017=(a017+a125);
  a125=(a169*a254);
  a297=(a176*a307);
  a125=(a125+a297);
  a297=(a177*a258);
  a125=(a125+a297);
  a297=(a178*a015);
  a125=(a125+a297);
  a297=(a179*a025);
  a125=(a125+a297);
  a297=(a144*a052);
  a122=(a084*a302);
  a297=(a297+a122);
  a122=(a151*a022);
  a297=(a297+a122);
  a122=(a152*a256);
  a297=(a297+a122);
  a182=(a145*a182);
  a055=(a168*a055);
  a182=(a182+a055);
  a192=(a147*a192);
  a182=(a182-a192);
  a192=(a294*a066);
  a055=(a157*a107);
  a192=(a192+a055);
  a182=(a182+a192);
  a192=(a153*a182);
  a297=(a297+a192);
  a297=(a254+a297);
  a192=(a180*a297);
  a125=(a125+a192);
  a125=(a130+a125);
  a192=(a187*a125);
  a017=(a017-a192);
  a192=(a163*a165);
  a055=(a169*a211);
  a122=(a176*a031);
  a055=(a055+a122);
  a122=(a177*a251);
  a055=(a055+a122);
  a122=(a178*a019);
  a055=(a055+a122);
  a122=(a179*a167);
  a055=(a055+a122);
  a122=(a061*a278);
  a081=(a188*a097);
  a122=(a122+a081);
  a081=(a186*a277);
  a122=(a122+a081);
  a081=(a298*a296);
  a010=(a189*a198);
  a081=(a081-a010);
  a122=(a122+a081);
  a081=(a180*a122);
  a055=(a055+a081);
  a055=(a280+a055);
  a081=(a219*a055);
  a192=(a192+a081);
  a017=(a017+a192);
  a192=(a208*a017);
  a301=(a301+a192);
  a301=(a009+a301);
  a192=(a193*a301);
  a075=(a075+a192);
  a192=(a224*a226);
  a081=(a231*a249);
  a192=(a192+a081);
  a081=(a232*a034);
  a192=(a192+a081);
  a081=(a233*a222);
  a192=(a192+a081);
  a081=(a234*a101);
  a192=(a192+a081);
  a081=(a235*a194);
  a192=(a192+a081);
  a081=(a236*a017);
  a192=(a192+a081);
  a081=(a196*a009);
  a010=(a203*a071);
  a081=(a081+a010);
  a010=(a204*a146);
  a081=(a081+a010);
  a010=(a205*a310);
  a081=(a081+a010);
  a010=(a206*a066);
  a081=(a081+a010);
  a010=(a207*a296);
  a081=(a081+a010);
  a010=(a208*a165);
  a081=(a081+a010);
  a081=(a036+a081);
  a010=(a257*a081);
  a104=(a196*a280);
  a069=(a203*a306);
  a104=(a104+a069);
  a069=(a204*a171);
  a104=(a104+a069);
  a069=(a205*a181);
  a104=(a104+a069);
  a069=(a206*a107);
  a104=(a104+a069);
  a069=(a207*a198);
  a104=(a104+a069);
  a069=(a208*a055);
  a104=(a104+a069);
  a104=(a004+a104);
  a069=(a242*a104);
  a010=(a010+a069);
  a069=(a196*a254);
  a150=(a203*a307);
  a069=(a069+a150);
  a150=(a204*a258);
  a069=(a069+a150);
  a150=(a205*a015);
  a069=(a069+a150);
  a150=(a206*a025);
  a069=(a069+a150);
  a150=(a207*a297);
  a069=(a069+a150);
  a150=(a169*a052);
  a058=(a176*a302);
  a150=(a150+a058);
  a058=(a177*a022);
  a150=(a150+a058);
  a058=(a178*a256);
  a150=(a150+a058);
  a058=(a179*a182);
  a150=(a150+a058);
  a278=(a170*a278);
  a097=(a195*a097);
  a278=(a278+a097);
  a277=(a172*a277);
  a278=(a278-a277);
  a277=(a299*a296);
  a097=(a184*a198);
  a277=(a277+a097);
  a278=(a278+a277);
  a277=(a180*a278);
  a150=(a150+a277);
  a150=(a254+a150);
  a277=(a208*a150);
  a069=(a069+a277);
  a069=(a130+a069);
  a277=(a215*a069);
  a010=(a010-a277);
  a277=(a190*a301);
  a097=(a196*a211);
  a058=(a203*a031);
  a097=(a097+a058);
  a058=(a204*a251);
  a097=(a097+a058);
  a058=(a205*a019);
  a097=(a097+a058);
  a058=(a206*a167);
  a097=(a097+a058);
  a058=(a207*a122);
  a097=(a097+a058);
  a058=(a111*a142);
  a070=(a216*a149);
  a058=(a058+a070);
  a070=(a214*a125);
  a058=(a058+a070);
  a070=(a303*a165);
  a154=(a217*a055);
  a070=(a070-a154);
  a058=(a058+a070);
  a070=(a208*a058);
  a097=(a097+a070);
  a097=(a280+a097);
  a070=(a248*a097);
  a277=(a277+a070);
  a010=(a010+a277);
  a277=(a237*a010);
  a192=(a192+a277);
  a192=(a009+a192);
  a277=(a221*a192);
  a075=(a075+a277);
  a277=(a253*a226);
  a249=(a260*a249);
  a277=(a277+a249);
  a034=(a095*a034);
  a277=(a277+a034);
  a034=(a116*a222);
  a277=(a277+a034);
  a034=(a261*a101);
  a277=(a277+a034);
  a034=(a262*a194);
  a277=(a277+a034);
  a034=(a263*a017);
  a277=(a277+a034);
  a034=(a264*a010);
  a277=(a277+a034);
  a034=(a224*a009);
  a249=(a231*a071);
  a034=(a034+a249);
  a249=(a232*a146);
  a034=(a034+a249);
  a249=(a233*a310);
  a034=(a034+a249);
  a249=(a234*a066);
  a034=(a034+a249);
  a249=(a235*a296);
  a034=(a034+a249);
  a249=(a236*a165);
  a034=(a034+a249);
  a249=(a237*a301);
  a034=(a034+a249);
  a034=(a036+a034);
  a249=(a284*a034);
  a070=(a224*a280);
  a154=(a231*a306);
  a070=(a070+a154);
  a154=(a232*a171);
  a070=(a070+a154);
  a154=(a233*a181);
  a070=(a070+a154);
  a154=(a234*a107);
  a070=(a070+a154);
  a154=(a235*a198);
  a070=(a070+a154);
  a154=(a236*a055);
  a070=(a070+a154);
  a154=(a237*a097);
  a070=(a070+a154);
  a070=(a004+a070);
  a154=(a269*a070);
  a249=(a249+a154);
  a154=(a224*a254);
  a174=(a231*a307);
  a154=(a154+a174);
  a174=(a232*a258);
  a154=(a154+a174);
  a174=(a233*a015);
  a154=(a154+a174);
  a174=(a234*a025);
  a154=(a154+a174);
  a174=(a235*a297);
  a154=(a154+a174);
  a174=(a236*a150);
  a154=(a154+a174);
  a174=(a196*a052);
  a292=(a203*a302);
  a174=(a174+a292);
  a292=(a204*a022);
  a174=(a174+a292);
  a292=(a205*a256);
  a174=(a174+a292);
  a292=(a206*a182);
  a174=(a174+a292);
  a292=(a207*a278);
  a174=(a174+a292);
  a142=(a197*a142);
  a149=(a223*a149);
  a142=(a142+a149);
  a125=(a199*a125);
  a142=(a142-a125);
  a125=(a304*a165);
  a149=(a212*a055);
  a125=(a125+a149);
  a142=(a142+a125);
  a125=(a208*a142);
  a174=(a174+a125);
  a174=(a254+a174);
  a125=(a237*a174);
  a154=(a154+a125);
  a154=(a130+a154);
  a125=(a201*a154);
  a249=(a249-a125);
  a125=(a218*a192);
  a149=(a224*a211);
  a292=(a231*a031);
  a149=(a149+a292);
  a292=(a232*a251);
  a149=(a149+a292);
  a292=(a233*a019);
  a149=(a149+a292);
  a292=(a234*a167);
  a149=(a149+a292);
  a292=(a235*a122);
  a149=(a149+a292);
  a292=(a236*a058);
  a149=(a149+a292);
  a292=(a140*a081);
  a000=(a245*a104);
  a292=(a292+a000);
  a000=(a243*a069);
  a292=(a292+a000);
  a000=(a308*a301);
  a121=(a246*a097);
  a000=(a000-a121);
  a292=(a292+a000);
  a000=(a237*a292);
  a149=(a149+a000);
  a149=(a280+a149);
  a000=(a275*a149);
  a125=(a125+a000);
  a249=(a249+a125);
  a125=(a265*a249);
  a277=(a277+a125);
  a277=(a009+a277);
  a125=(a250*a277);
  a075=(a075+a125);
  a075=(a036+a075);
  if (res[0]!=0) res[0][18]=a075;
  a075=(a001*a280);
  a125=(a005*a181);
  a075=(a075+a125);
  a125=(a117*a107);
  a075=(a075+a125);
  a125=(a141*a198);
  a075=(a075+a125);
  a125=(a166*a055);
  a075=(a075+a125);
  a125=(a193*a097);
  a075=(a075+a125);
  a125=(a221*a149);
  a075=(a075+a125);
  a125=(a253*a211);
  a031=(a260*a031);
  a125=(a125+a031);
  a251=(a095*a251);
  a125=(a125+a251);
  a251=(a116*a019);
  a125=(a125+a251);
  a251=(a261*a167);
  a125=(a125+a251);
  a251=(a262*a122);
  a125=(a125+a251);
  a251=(a263*a058);
  a125=(a125+a251);
  a251=(a264*a292);
  a125=(a125+a251);
  a251=(a238*a034);
  a031=(a272*a070);
  a251=(a251+a031);
  a031=(a270*a154);
  a251=(a251+a031);
  a031=(a311*a192);
  a000=(a273*a149);
  a031=(a031-a000);
  a251=(a251+a031);
  a031=(a265*a251);
  a125=(a125+a031);
  a125=(a280+a125);
  a031=(a250*a125);
  a075=(a075+a031);
  a075=(a004+a075);
  if (res[0]!=0) res[0][19]=a075;
  a075=(a001*a254);
  a031=(a005*a015);
  a075=(a075+a031);
  a031=(a117*a025);
  a075=(a075+a031);
  a031=(a141*a297);
  a075=(a075+a031);
  a031=(a166*a150);
  a075=(a075+a031);
  a031=(a193*a174);
  a075=(a075+a031);
  a031=(a224*a052);
  a000=(a231*a302);
  a031=(a031+a000);
  a000=(a232*a022);
  a031=(a031+a000);
  a000=(a233*a256);
  a031=(a031+a000);
  a000=(a234*a182);
  a031=(a031+a000);
  a000=(a235*a278);
  a031=(a031+a000);
  a000=(a236*a142);
  a031=(a031+a000);
  a081=(a225*a081);
  a104=(a252*a104);
  a081=(a081+a104);
  a069=(a227*a069);
  a081=(a081-a069);
  a069=(a309*a301);
  a104=(a241*a097);
  a069=(a069+a104);
  a081=(a081+a069);
  a069=(a237*a081);
  a031=(a031+a069);
  a031=(a254+a031);
  a069=(a221*a031);
  a075=(a075+a069);
  a069=(a253*a052);
  a302=(a260*a302);
  a069=(a069+a302);
  a022=(a095*a022);
  a069=(a069+a022);
  a022=(a116*a256);
  a069=(a069+a022);
  a022=(a261*a182);
  a069=(a069+a022);
  a022=(a262*a278);
  a069=(a069+a022);
  a022=(a263*a142);
  a069=(a069+a022);
  a022=(a264*a081);
  a069=(a069+a022);
  a034=(a013*a034);
  a070=(a279*a070);
  a034=(a034+a070);
  a154=(a100*a154);
  a034=(a034-a154);
  a154=(a312*a192);
  a070=(a268*a149);
  a154=(a154+a070);
  a034=(a034+a154);
  a154=(a265*a034);
  a069=(a069+a154);
  a069=(a254+a069);
  a069=(a250*a069);
  a075=(a075+a069);
  a075=(a130+a075);
  if (res[0]!=0) res[0][20]=a075;
  a226=(a001*a226);
  a222=(a005*a222);
  a226=(a226+a222);
  a101=(a117*a101);
  a226=(a226+a101);
  a194=(a141*a194);
  a226=(a226+a194);
  a017=(a166*a017);
  a226=(a226+a017);
  a010=(a193*a010);
  a226=(a226+a010);
  a249=(a221*a249);
  a226=(a226+a249);
  a249=(a253*a009);
  a071=(a260*a071);
  a249=(a249+a071);
  a146=(a095*a146);
  a249=(a249+a146);
  a310=(a116*a310);
  a249=(a249+a310);
  a066=(a261*a066);
  a249=(a249+a066);
  a296=(a262*a296);
  a249=(a249+a296);
  a165=(a263*a165);
  a249=(a249+a165);
  a301=(a264*a301);
  a249=(a249+a301);
  a192=(a265*a192);
  a249=(a249+a192);
  a036=(a036+a249);
  a249=(a027*a036);
  a192=(a253*a280);
  a306=(a260*a306);
  a192=(a192+a306);
  a171=(a095*a171);
  a192=(a192+a171);
  a181=(a116*a181);
  a192=(a192+a181);
  a107=(a261*a107);
  a192=(a192+a107);
  a198=(a262*a198);
  a192=(a192+a198);
  a055=(a263*a055);
  a192=(a192+a055);
  a097=(a264*a097);
  a192=(a192+a097);
  a149=(a265*a149);
  a192=(a192+a149);
  a004=(a004+a192);
  a192=(a220*a004);
  a249=(a249+a192);
  a192=(a253*a254);
  a307=(a260*a307);
  a192=(a192+a307);
  a258=(a095*a258);
  a192=(a192+a258);
  a015=(a116*a015);
  a192=(a192+a015);
  a025=(a261*a025);
  a192=(a192+a025);
  a297=(a262*a297);
  a192=(a192+a297);
  a150=(a263*a150);
  a192=(a192+a150);
  a174=(a264*a174);
  a192=(a192+a174);
  a031=(a265*a031);
  a192=(a192+a031);
  a130=(a130+a192);
  a192=(a282*a130);
  a249=(a249-a192);
  a192=(a255*a277);
  a031=(a078*a125);
  a192=(a192+a031);
  a249=(a249+a192);
  a249=(a250*a249);
  a226=(a226+a249);
  a009=(a009+a226);
  if (res[0]!=0) res[0][21]=a009;
  a211=(a001*a211);
  a019=(a005*a019);
  a211=(a211+a019);
  a167=(a117*a167);
  a211=(a211+a167);
  a122=(a141*a122);
  a211=(a211+a122);
  a058=(a166*a058);
  a211=(a211+a058);
  a292=(a193*a292);
  a211=(a211+a292);
  a251=(a221*a251);
  a211=(a211+a251);
  a251=(a129*a036);
  a292=(a029*a004);
  a251=(a251+a292);
  a292=(a007*a130);
  a251=(a251+a292);
  a292=(a244*a277);
  a058=(a030*a125);
  a292=(a292-a058);
  a251=(a251+a292);
  a251=(a250*a251);
  a211=(a211+a251);
  a280=(a280+a211);
  if (res[0]!=0) res[0][22]=a280;
  a052=(a001*a052);
  a256=(a005*a256);
  a052=(a052+a256);
  a182=(a117*a182);
  a052=(a052+a182);
  a278=(a141*a278);
  a052=(a052+a278);
  a142=(a166*a142);
  a052=(a052+a142);
  a081=(a193*a081);
  a052=(a052+a081);
  a034=(a221*a034);
  a052=(a052+a034);
  a036=(a209*a036);
  a004=(a285*a004);
  a036=(a036+a004);
  a130=(a039*a130);
  a036=(a036-a130);
  a277=(a033*a277);
  a125=(a018*a125);
  a277=(a277+a125);
  a036=(a036+a277);
  a036=(a250*a036);
  a052=(a052+a036);
  a254=(a254+a052);
  if (res[0]!=0) res[0][23]=a254;
  a254=arg[0]? arg[0][24] : 0;
  a052=arg[0]? arg[0][27] : 0;
  a036=(a001*a052);
  a277=(a038*a254);
  a125=arg[0]? arg[0][25] : 0;
  a130=(a012*a125);
  a277=(a277+a130);
  a130=arg[0]? arg[0][26] : 0;
  a004=(a016*a130);
  a277=(a277-a004);
  a004=(a240*a052);
  a034=arg[0]? arg[0][28] : 0;
  a081=(a020*a034);
  a004=(a004+a081);
  a277=(a277+a004);
  a004=(a006*a277);
  a081=(a041*a052);
  a142=(a044*a277);
  a278=(a047*a052);
  a278=(a254+a278);
  a182=(a068*a278);
  a256=(a047*a034);
  a256=(a125+a256);
  a280=(a053*a256);
  a182=(a182+a280);
  a280=arg[0]? arg[0][29] : 0;
  a211=(a047*a280);
  a211=(a130+a211);
  a251=(a106*a211);
  a182=(a182-a251);
  a251=(a047*a277);
  a251=(a052+a251);
  a292=(a288*a251);
  a058=(a155*a254);
  a122=(a014*a125);
  a058=(a058+a122);
  a122=(a210*a130);
  a058=(a058+a122);
  a122=(a183*a052);
  a167=(a032*a034);
  a122=(a122-a167);
  a058=(a058+a122);
  a122=(a047*a058);
  a122=(a034+a122);
  a167=(a059*a122);
  a292=(a292+a167);
  a182=(a182+a292);
  a182=(a046*a182);
  a142=(a142+a182);
  a142=(a052+a142);
  a182=(a043*a142);
  a081=(a081+a182);
  a081=(a254+a081);
  a182=(a103*a081);
  a292=(a041*a034);
  a167=(a044*a058);
  a019=(a021*a278);
  a009=(a056*a256);
  a019=(a019+a009);
  a009=(a054*a211);
  a019=(a019+a009);
  a009=(a286*a251);
  a226=(a057*a122);
  a009=(a009-a226);
  a019=(a019+a009);
  a019=(a046*a019);
  a167=(a167+a019);
  a167=(a034+a167);
  a019=(a043*a167);
  a292=(a292+a019);
  a292=(a125+a292);
  a019=(a088*a292);
  a182=(a182+a019);
  a019=(a041*a280);
  a009=(a239*a254);
  a226=(a024*a125);
  a009=(a009+a226);
  a226=(a266*a130);
  a009=(a009-a226);
  a226=(a156*a052);
  a249=(a011*a034);
  a226=(a226+a249);
  a009=(a009+a226);
  a226=(a044*a009);
  a278=(a267*a278);
  a256=(a063*a256);
  a278=(a278+a256);
  a211=(a089*a211);
  a278=(a278-a211);
  a211=(a259*a251);
  a256=(a051*a122);
  a211=(a211+a256);
  a278=(a278+a211);
  a278=(a046*a278);
  a226=(a226+a278);
  a226=(a280+a226);
  a278=(a043*a226);
  a019=(a019+a278);
  a019=(a130+a019);
  a278=(a065*a019);
  a182=(a182-a278);
  a278=(a041*a277);
  a211=(a044*a052);
  a251=(a046*a251);
  a211=(a211+a251);
  a211=(a254+a211);
  a251=(a085*a211);
  a256=(a044*a034);
  a122=(a046*a122);
  a256=(a256+a122);
  a256=(a125+a256);
  a122=(a077*a256);
  a251=(a251+a122);
  a122=(a044*a280);
  a249=(a047*a009);
  a249=(a280+a249);
  a249=(a046*a249);
  a122=(a122+a249);
  a122=(a130+a122);
  a249=(a175*a122);
  a251=(a251-a249);
  a249=(a287*a142);
  a192=(a050*a167);
  a249=(a249+a192);
  a251=(a251+a249);
  a249=(a043*a251);
  a278=(a278+a249);
  a278=(a052+a278);
  a249=(a026*a278);
  a192=(a041*a058);
  a031=(a105*a211);
  a174=(a072*a256);
  a031=(a031+a174);
  a174=(a131*a122);
  a031=(a031+a174);
  a174=(a290*a142);
  a150=(a079*a167);
  a174=(a174-a150);
  a031=(a031+a174);
  a174=(a043*a031);
  a192=(a192+a174);
  a192=(a034+a192);
  a174=(a094*a192);
  a249=(a249+a174);
  a182=(a182+a249);
  a249=(a028*a182);
  a004=(a004+a249);
  a249=(a099*a052);
  a174=(a049*a142);
  a249=(a249+a174);
  a174=(a080*a278);
  a249=(a249+a174);
  a249=(a254+a249);
  a174=(a124*a249);
  a150=(a099*a034);
  a297=(a049*a167);
  a150=(a150+a297);
  a297=(a080*a192);
  a150=(a150+a297);
  a150=(a125+a150);
  a297=(a076*a150);
  a174=(a174+a297);
  a297=(a099*a280);
  a226=(a049*a226);
  a297=(a297+a226);
  a226=(a041*a009);
  a211=(a090*a211);
  a256=(a060*a256);
  a211=(a211+a256);
  a122=(a062*a122);
  a211=(a211-a122);
  a142=(a291*a142);
  a167=(a064*a167);
  a142=(a142+a167);
  a211=(a211+a142);
  a142=(a043*a211);
  a226=(a226+a142);
  a226=(a280+a226);
  a142=(a080*a226);
  a297=(a297+a142);
  a297=(a130+a297);
  a142=(a082*a297);
  a174=(a174-a142);
  a142=(a099*a277);
  a251=(a049*a251);
  a142=(a142+a251);
  a251=(a080*a182);
  a142=(a142+a251);
  a142=(a052+a142);
  a251=(a023*a142);
  a167=(a099*a058);
  a031=(a049*a031);
  a167=(a167+a031);
  a031=(a003*a081);
  a122=(a091*a292);
  a031=(a031+a122);
  a122=(a067*a019);
  a031=(a031+a122);
  a122=(a230*a278);
  a256=(a092*a192);
  a122=(a122-a256);
  a031=(a031+a122);
  a122=(a080*a031);
  a167=(a167+a122);
  a167=(a034+a167);
  a122=(a115*a167);
  a251=(a251+a122);
  a174=(a174+a251);
  a251=(a096*a174);
  a004=(a004+a251);
  a004=(a052+a004);
  a251=(a005*a004);
  a036=(a036+a251);
  a251=(a120*a277);
  a122=(a126*a182);
  a251=(a251+a122);
  a122=(a127*a174);
  a251=(a251+a122);
  a122=(a006*a052);
  a256=(a028*a278);
  a122=(a122+a256);
  a256=(a096*a142);
  a122=(a122+a256);
  a122=(a254+a122);
  a256=(a148*a122);
  a025=(a006*a034);
  a015=(a028*a192);
  a025=(a025+a015);
  a015=(a096*a167);
  a025=(a025+a015);
  a025=(a125+a025);
  a015=(a133*a025);
  a256=(a256+a015);
  a015=(a006*a280);
  a258=(a028*a226);
  a015=(a015+a258);
  a258=(a099*a009);
  a211=(a049*a211);
  a258=(a258+a211);
  a081=(a037*a081);
  a292=(a098*a292);
  a081=(a081+a292);
  a019=(a040*a019);
  a081=(a081-a019);
  a019=(a202*a278);
  a292=(a086*a192);
  a019=(a019+a292);
  a081=(a081+a019);
  a019=(a080*a081);
  a258=(a258+a019);
  a258=(a280+a258);
  a019=(a096*a258);
  a015=(a015+a019);
  a015=(a130+a015);
  a019=(a035*a015);
  a256=(a256-a019);
  a019=(a093*a004);
  a292=(a006*a058);
  a211=(a028*a031);
  a292=(a292+a211);
  a211=(a087*a249);
  a307=(a112*a150);
  a211=(a211+a307);
  a307=(a110*a297);
  a211=(a211+a307);
  a307=(a073*a142);
  a149=(a113*a167);
  a307=(a307-a149);
  a211=(a211+a307);
  a307=(a096*a211);
  a292=(a292+a307);
  a292=(a034+a292);
  a307=(a139*a292);
  a019=(a019+a307);
  a256=(a256+a019);
  a019=(a128*a256);
  a251=(a251+a019);
  a251=(a052+a251);
  a019=(a117*a251);
  a036=(a036+a019);
  a019=(a144*a277);
  a307=(a084*a182);
  a019=(a019+a307);
  a307=(a151*a174);
  a019=(a019+a307);
  a307=(a152*a256);
  a019=(a019+a307);
  a307=(a120*a052);
  a149=(a126*a278);
  a307=(a307+a149);
  a149=(a127*a142);
  a307=(a307+a149);
  a149=(a128*a004);
  a307=(a307+a149);
  a307=(a254+a307);
  a149=(a173*a307);
  a097=(a120*a034);
  a055=(a126*a192);
  a097=(a097+a055);
  a055=(a127*a167);
  a097=(a097+a055);
  a055=(a128*a292);
  a097=(a097+a055);
  a097=(a125+a097);
  a055=(a158*a097);
  a149=(a149+a055);
  a055=(a120*a280);
  a198=(a126*a226);
  a055=(a055+a198);
  a198=(a127*a258);
  a055=(a055+a198);
  a198=(a006*a009);
  a107=(a028*a081);
  a198=(a198+a107);
  a249=(a102*a249);
  a150=(a119*a150);
  a249=(a249+a150);
  a297=(a289*a297);
  a249=(a249-a297);
  a297=(a083*a142);
  a150=(a108*a167);
  a297=(a297+a150);
  a249=(a249+a297);
  a297=(a096*a249);
  a198=(a198+a297);
  a198=(a280+a198);
  a297=(a128*a198);
  a055=(a055+a297);
  a055=(a130+a055);
  a297=(a135*a055);
  a149=(a149-a297);
  a297=(a114*a251);
  a150=(a120*a058);
  a107=(a126*a031);
  a150=(a150+a107);
  a107=(a127*a211);
  a150=(a150+a107);
  a107=(a109*a122);
  a181=(a136*a025);
  a107=(a107+a181);
  a181=(a134*a015);
  a107=(a107+a181);
  a181=(a074*a004);
  a171=(a137*a292);
  a181=(a181-a171);
  a107=(a107+a181);
  a181=(a128*a107);
  a150=(a150+a181);
  a150=(a034+a150);
  a181=(a164*a150);
  a297=(a297+a181);
  a149=(a149+a297);
  a297=(a153*a149);
  a019=(a019+a297);
  a019=(a052+a019);
  a297=(a141*a019);
  a036=(a036+a297);
  a297=(a169*a277);
  a181=(a176*a182);
  a297=(a297+a181);
  a181=(a177*a174);
  a297=(a297+a181);
  a181=(a178*a256);
  a297=(a297+a181);
  a181=(a179*a149);
  a297=(a297+a181);
  a181=(a144*a052);
  a171=(a084*a278);
  a181=(a181+a171);
  a171=(a151*a142);
  a181=(a181+a171);
  a171=(a152*a004);
  a181=(a181+a171);
  a171=(a153*a251);
  a181=(a181+a171);
  a181=(a254+a181);
  a171=(a200*a181);
  a306=(a144*a034);
  a301=(a084*a192);
  a306=(a306+a301);
  a301=(a151*a167);
  a306=(a306+a301);
  a301=(a152*a292);
  a306=(a306+a301);
  a301=(a153*a150);
  a306=(a306+a301);
  a306=(a125+a306);
  a301=(a185*a306);
  a171=(a171+a301);
  a301=(a144*a280);
  a165=(a084*a226);
  a301=(a301+a165);
  a165=(a151*a258);
  a301=(a301+a165);
  a165=(a152*a198);
  a301=(a301+a165);
  a165=(a120*a009);
  a296=(a126*a081);
  a165=(a165+a296);
  a296=(a127*a249);
  a165=(a165+a296);
  a122=(a123*a122);
  a025=(a143*a025);
  a122=(a122+a025);
  a015=(a118*a015);
  a122=(a122-a015);
  a015=(a045*a004);
  a025=(a132*a292);
  a015=(a015+a025);
  a122=(a122+a015);
  a015=(a128*a122);
  a165=(a165+a015);
  a165=(a280+a165);
  a015=(a153*a165);
  a301=(a301+a015);
  a301=(a130+a301);
  a015=(a160*a301);
  a171=(a171-a015);
  a015=(a138*a019);
  a025=(a144*a058);
  a296=(a084*a031);
  a025=(a025+a296);
  a296=(a151*a211);
  a025=(a025+a296);
  a296=(a152*a107);
  a025=(a025+a296);
  a296=(a048*a307);
  a066=(a161*a097);
  a296=(a296+a066);
  a066=(a159*a055);
  a296=(a296+a066);
  a066=(a293*a251);
  a310=(a162*a150);
  a066=(a066-a310);
  a296=(a296+a066);
  a066=(a153*a296);
  a025=(a025+a066);
  a025=(a034+a025);
  a066=(a191*a025);
  a015=(a015+a066);
  a171=(a171+a015);
  a015=(a180*a171);
  a297=(a297+a015);
  a297=(a052+a297);
  a015=(a166*a297);
  a036=(a036+a015);
  a015=(a196*a277);
  a066=(a203*a182);
  a015=(a015+a066);
  a066=(a204*a174);
  a015=(a015+a066);
  a066=(a205*a256);
  a015=(a015+a066);
  a066=(a206*a149);
  a015=(a015+a066);
  a066=(a207*a171);
  a015=(a015+a066);
  a066=(a169*a052);
  a310=(a176*a278);
  a066=(a066+a310);
  a310=(a177*a142);
  a066=(a066+a310);
  a310=(a178*a004);
  a066=(a066+a310);
  a310=(a179*a251);
  a066=(a066+a310);
  a310=(a180*a019);
  a066=(a066+a310);
  a066=(a254+a066);
  a310=(a228*a066);
  a146=(a169*a034);
  a071=(a176*a192);
  a146=(a146+a071);
  a071=(a177*a167);
  a146=(a146+a071);
  a071=(a178*a292);
  a146=(a146+a071);
  a071=(a179*a150);
  a146=(a146+a071);
  a071=(a180*a025);
  a146=(a146+a071);
  a146=(a125+a146);
  a071=(a213*a146);
  a310=(a310+a071);
  a071=(a169*a280);
  a010=(a176*a226);
  a071=(a071+a010);
  a010=(a177*a258);
  a071=(a071+a010);
  a010=(a178*a198);
  a071=(a071+a010);
  a010=(a179*a165);
  a071=(a071+a010);
  a010=(a144*a009);
  a017=(a084*a081);
  a010=(a010+a017);
  a017=(a151*a249);
  a010=(a010+a017);
  a017=(a152*a122);
  a010=(a010+a017);
  a307=(a145*a307);
  a097=(a168*a097);
  a307=(a307+a097);
  a055=(a147*a055);
  a307=(a307-a055);
  a055=(a294*a251);
  a097=(a157*a150);
  a055=(a055+a097);
  a307=(a307+a055);
  a055=(a153*a307);
  a010=(a010+a055);
  a010=(a280+a010);
  a055=(a180*a010);
  a071=(a071+a055);
  a071=(a130+a071);
  a055=(a187*a071);
  a310=(a310-a055);
  a055=(a163*a297);
  a097=(a169*a058);
  a017=(a176*a031);
  a097=(a097+a017);
  a017=(a177*a211);
  a097=(a097+a017);
  a017=(a178*a107);
  a097=(a097+a017);
  a017=(a179*a296);
  a097=(a097+a017);
  a017=(a061*a181);
  a194=(a188*a306);
  a017=(a017+a194);
  a194=(a186*a301);
  a017=(a017+a194);
  a194=(a298*a019);
  a101=(a189*a025);
  a194=(a194-a101);
  a017=(a017+a194);
  a194=(a180*a017);
  a097=(a097+a194);
  a097=(a034+a097);
  a194=(a219*a097);
  a055=(a055+a194);
  a310=(a310+a055);
  a055=(a208*a310);
  a015=(a015+a055);
  a015=(a052+a015);
  a055=(a193*a015);
  a036=(a036+a055);
  a055=(a224*a277);
  a194=(a231*a182);
  a055=(a055+a194);
  a194=(a232*a174);
  a055=(a055+a194);
  a194=(a233*a256);
  a055=(a055+a194);
  a194=(a234*a149);
  a055=(a055+a194);
  a194=(a235*a171);
  a055=(a055+a194);
  a194=(a236*a310);
  a055=(a055+a194);
  a194=(a196*a052);
  a101=(a203*a278);
  a194=(a194+a101);
  a101=(a204*a142);
  a194=(a194+a101);
  a101=(a205*a004);
  a194=(a194+a101);
  a101=(a206*a251);
  a194=(a194+a101);
  a101=(a207*a019);
  a194=(a194+a101);
  a101=(a208*a297);
  a194=(a194+a101);
  a194=(a254+a194);
  a101=(a257*a194);
  a222=(a196*a034);
  a075=(a203*a192);
  a222=(a222+a075);
  a075=(a204*a167);
  a222=(a222+a075);
  a075=(a205*a292);
  a222=(a222+a075);
  a075=(a206*a150);
  a222=(a222+a075);
  a075=(a207*a025);
  a222=(a222+a075);
  a075=(a208*a097);
  a222=(a222+a075);
  a222=(a125+a222);
  a075=(a242*a222);
  a101=(a101+a075);
  a075=(a196*a280);
  a069=(a203*a226);
  a075=(a075+a069);
  a069=(a204*a258);
  a075=(a075+a069);
  a069=(a205*a198);
  a075=(a075+a069);
  a069=(a206*a165);
  a075=(a075+a069);
  a069=(a207*a010);
  a075=(a075+a069);
  a069=(a169*a009);
  a154=(a176*a081);
  a069=(a069+a154);
  a154=(a177*a249);
  a069=(a069+a154);
  a154=(a178*a122);
  a069=(a069+a154);
  a154=(a179*a307);
  a069=(a069+a154);
  a181=(a170*a181);
  a306=(a195*a306);
  a181=(a181+a306);
  a301=(a172*a301);
  a181=(a181-a301);
  a301=(a299*a019);
  a306=(a184*a025);
  a301=(a301+a306);
  a181=(a181+a301);
  a301=(a180*a181);
  a069=(a069+a301);
  a069=(a280+a069);
  a301=(a208*a069);
  a075=(a075+a301);
  a075=(a130+a075);
  a301=(a215*a075);
  a101=(a101-a301);
  a301=(a190*a015);
  a306=(a196*a058);
  a154=(a203*a031);
  a306=(a306+a154);
  a154=(a204*a211);
  a306=(a306+a154);
  a154=(a205*a107);
  a306=(a306+a154);
  a154=(a206*a296);
  a306=(a306+a154);
  a154=(a207*a017);
  a306=(a306+a154);
  a154=(a111*a066);
  a070=(a216*a146);
  a154=(a154+a070);
  a070=(a214*a071);
  a154=(a154+a070);
  a070=(a303*a297);
  a022=(a217*a097);
  a070=(a070-a022);
  a154=(a154+a070);
  a070=(a208*a154);
  a306=(a306+a070);
  a306=(a034+a306);
  a070=(a248*a306);
  a301=(a301+a070);
  a101=(a101+a301);
  a301=(a237*a101);
  a055=(a055+a301);
  a055=(a052+a055);
  a301=(a221*a055);
  a036=(a036+a301);
  a301=(a253*a277);
  a182=(a260*a182);
  a301=(a301+a182);
  a174=(a095*a174);
  a301=(a301+a174);
  a174=(a116*a256);
  a301=(a301+a174);
  a174=(a261*a149);
  a301=(a301+a174);
  a174=(a262*a171);
  a301=(a301+a174);
  a174=(a263*a310);
  a301=(a301+a174);
  a174=(a264*a101);
  a301=(a301+a174);
  a174=(a224*a052);
  a182=(a231*a278);
  a174=(a174+a182);
  a182=(a232*a142);
  a174=(a174+a182);
  a182=(a233*a004);
  a174=(a174+a182);
  a182=(a234*a251);
  a174=(a174+a182);
  a182=(a235*a019);
  a174=(a174+a182);
  a182=(a236*a297);
  a174=(a174+a182);
  a182=(a237*a015);
  a174=(a174+a182);
  a174=(a254+a174);
  a182=(a284*a174);
  a070=(a224*a034);
  a022=(a231*a192);
  a070=(a070+a022);
  a022=(a232*a167);
  a070=(a070+a022);
  a022=(a233*a292);
  a070=(a070+a022);
  a022=(a234*a150);
  a070=(a070+a022);
  a022=(a235*a025);
  a070=(a070+a022);
  a022=(a236*a097);
  a070=(a070+a022);
  a022=(a237*a306);
  a070=(a070+a022);
  a070=(a125+a070);
  a022=(a269*a070);
  a182=(a182+a022);
  a022=(a224*a280);
  a302=(a231*a226);
  a022=(a022+a302);
  a302=(a232*a258);
  a022=(a022+a302);
  a302=(a233*a198);
  a022=(a022+a302);
  a302=(a234*a165);
  a022=(a022+a302);
  a302=(a235*a010);
  a022=(a022+a302);
  a302=(a236*a069);
  a022=(a022+a302);
  a302=(a196*a009);
  a104=(a203*a081);
  a302=(a302+a104);
  a104=(a204*a249);
  a302=(a302+a104);
  a104=(a205*a122);
  a302=(a302+a104);
  a104=(a206*a307);
  a302=(a302+a104);
  a104=(a207*a181);
  a302=(a302+a104);
  a066=(a197*a066);
  a146=(a223*a146);
  a066=(a066+a146);
  a071=(a199*a071);
  a066=(a066-a071);
  a071=(a304*a297);
  a146=(a212*a097);
  a071=(a071+a146);
  a066=(a066+a071);
  a071=(a208*a066);
  a302=(a302+a071);
  a302=(a280+a302);
  a071=(a237*a302);
  a022=(a022+a071);
  a022=(a130+a022);
  a071=(a201*a022);
  a182=(a182-a071);
  a071=(a218*a055);
  a146=(a224*a058);
  a104=(a231*a031);
  a146=(a146+a104);
  a104=(a232*a211);
  a146=(a146+a104);
  a104=(a233*a107);
  a146=(a146+a104);
  a104=(a234*a296);
  a146=(a146+a104);
  a104=(a235*a017);
  a146=(a146+a104);
  a104=(a236*a154);
  a146=(a146+a104);
  a104=(a140*a194);
  a000=(a245*a222);
  a104=(a104+a000);
  a000=(a243*a075);
  a104=(a104+a000);
  a000=(a308*a015);
  a121=(a246*a306);
  a000=(a000-a121);
  a104=(a104+a000);
  a000=(a237*a104);
  a146=(a146+a000);
  a146=(a034+a146);
  a000=(a275*a146);
  a071=(a071+a000);
  a182=(a182+a071);
  a071=(a265*a182);
  a301=(a301+a071);
  a301=(a052+a301);
  a071=(a250*a301);
  a036=(a036+a071);
  a036=(a254+a036);
  if (res[0]!=0) res[0][24]=a036;
  a036=(a001*a034);
  a071=(a005*a292);
  a036=(a036+a071);
  a071=(a117*a150);
  a036=(a036+a071);
  a071=(a141*a025);
  a036=(a036+a071);
  a071=(a166*a097);
  a036=(a036+a071);
  a071=(a193*a306);
  a036=(a036+a071);
  a071=(a221*a146);
  a036=(a036+a071);
  a071=(a253*a058);
  a031=(a260*a031);
  a071=(a071+a031);
  a211=(a095*a211);
  a071=(a071+a211);
  a211=(a116*a107);
  a071=(a071+a211);
  a211=(a261*a296);
  a071=(a071+a211);
  a211=(a262*a017);
  a071=(a071+a211);
  a211=(a263*a154);
  a071=(a071+a211);
  a211=(a264*a104);
  a071=(a071+a211);
  a211=(a238*a174);
  a031=(a272*a070);
  a211=(a211+a031);
  a031=(a270*a022);
  a211=(a211+a031);
  a031=(a311*a055);
  a000=(a273*a146);
  a031=(a031-a000);
  a211=(a211+a031);
  a031=(a265*a211);
  a071=(a071+a031);
  a071=(a034+a071);
  a031=(a250*a071);
  a036=(a036+a031);
  a036=(a125+a036);
  if (res[0]!=0) res[0][25]=a036;
  a036=(a001*a280);
  a031=(a005*a198);
  a036=(a036+a031);
  a031=(a117*a165);
  a036=(a036+a031);
  a031=(a141*a010);
  a036=(a036+a031);
  a031=(a166*a069);
  a036=(a036+a031);
  a031=(a193*a302);
  a036=(a036+a031);
  a031=(a224*a009);
  a000=(a231*a081);
  a031=(a031+a000);
  a000=(a232*a249);
  a031=(a031+a000);
  a000=(a233*a122);
  a031=(a031+a000);
  a000=(a234*a307);
  a031=(a031+a000);
  a000=(a235*a181);
  a031=(a031+a000);
  a000=(a236*a066);
  a031=(a031+a000);
  a194=(a225*a194);
  a222=(a252*a222);
  a194=(a194+a222);
  a075=(a227*a075);
  a194=(a194-a075);
  a075=(a309*a015);
  a222=(a241*a306);
  a075=(a075+a222);
  a194=(a194+a075);
  a075=(a237*a194);
  a031=(a031+a075);
  a031=(a280+a031);
  a075=(a221*a031);
  a036=(a036+a075);
  a075=(a253*a009);
  a081=(a260*a081);
  a075=(a075+a081);
  a249=(a095*a249);
  a075=(a075+a249);
  a249=(a116*a122);
  a075=(a075+a249);
  a249=(a261*a307);
  a075=(a075+a249);
  a249=(a262*a181);
  a075=(a075+a249);
  a249=(a263*a066);
  a075=(a075+a249);
  a249=(a264*a194);
  a075=(a075+a249);
  a174=(a013*a174);
  a070=(a279*a070);
  a174=(a174+a070);
  a022=(a100*a022);
  a174=(a174-a022);
  a022=(a312*a055);
  a070=(a268*a146);
  a022=(a022+a070);
  a174=(a174+a022);
  a022=(a265*a174);
  a075=(a075+a022);
  a075=(a280+a075);
  a075=(a250*a075);
  a036=(a036+a075);
  a036=(a130+a036);
  if (res[0]!=0) res[0][26]=a036;
  a277=(a001*a277);
  a256=(a005*a256);
  a277=(a277+a256);
  a149=(a117*a149);
  a277=(a277+a149);
  a171=(a141*a171);
  a277=(a277+a171);
  a310=(a166*a310);
  a277=(a277+a310);
  a101=(a193*a101);
  a277=(a277+a101);
  a182=(a221*a182);
  a277=(a277+a182);
  a182=(a253*a052);
  a278=(a260*a278);
  a182=(a182+a278);
  a142=(a095*a142);
  a182=(a182+a142);
  a004=(a116*a004);
  a182=(a182+a004);
  a251=(a261*a251);
  a182=(a182+a251);
  a019=(a262*a019);
  a182=(a182+a019);
  a297=(a263*a297);
  a182=(a182+a297);
  a015=(a264*a015);
  a182=(a182+a015);
  a055=(a265*a055);
  a182=(a182+a055);
  a254=(a254+a182);
  a182=(a027*a254);
  a055=(a253*a034);
  a192=(a260*a192);
  a055=(a055+a192);
  a167=(a095*a167);
  a055=(a055+a167);
  a292=(a116*a292);
  a055=(a055+a292);
  a150=(a261*a150);
  a055=(a055+a150);
  a025=(a262*a025);
  a055=(a055+a025);
  a097=(a263*a097);
  a055=(a055+a097);
  a306=(a264*a306);
  a055=(a055+a306);
  a146=(a265*a146);
  a055=(a055+a146);
  a125=(a125+a055);
  a055=(a220*a125);
  a182=(a182+a055);
  a055=(a253*a280);
  a226=(a260*a226);
  a055=(a055+a226);
  a258=(a095*a258);
  a055=(a055+a258);
  a198=(a116*a198);
  a055=(a055+a198);
  a165=(a261*a165);
  a055=(a055+a165);
  a010=(a262*a010);
  a055=(a055+a010);
  a069=(a263*a069);
  a055=(a055+a069);
  a302=(a264*a302);
  a055=(a055+a302);
  a031=(a265*a031);
  a055=(a055+a031);
  a130=(a130+a055);
  a055=(a282*a130);
  a182=(a182-a055);
  a055=(a255*a301);
  a031=(a078*a071);
  a055=(a055+a031);
  a182=(a182+a055);
  a182=(a250*a182);
  a277=(a277+a182);
  a052=(a052+a277);
  if (res[0]!=0) res[0][27]=a052;
  a058=(a001*a058);
  a107=(a005*a107);
  a058=(a058+a107);
  a296=(a117*a296);
  a058=(a058+a296);
  a017=(a141*a017);
  a058=(a058+a017);
  a154=(a166*a154);
  a058=(a058+a154);
  a104=(a193*a104);
  a058=(a058+a104);
  a211=(a221*a211);
  a058=(a058+a211);
  a211=(a129*a254);
  a104=(a029*a125);
  a211=(a211+a104);
  a104=(a007*a130);
  a211=(a211+a104);
  a104=(a244*a301);
  a154=(a030*a071);
  a104=(a104-a154);
  a211=(a211+a104);
  a211=(a250*a211);
  a058=(a058+a211);
  a034=(a034+a058);
  if (res[0]!=0) res[0][28]=a034;
  a009=(a001*a009);
  a122=(a005*a122);
  a009=(a009+a122);
  a307=(a117*a307);
  a009=(a009+a307);
  a181=(a141*a181);
  a009=(a009+a181);
  a066=(a166*a066);
  a009=(a009+a066);
  a194=(a193*a194);
  a009=(a009+a194);
  a174=(a221*a174);
  a009=(a009+a174);
  a254=(a209*a254);
  a125=(a285*a125);
  a254=(a254+a125);
  a130=(a039*a130);
  a254=(a254-a130);
  a301=(a033*a301);
  a071=(a018*a071);
  a301=(a301+a071);
  a254=(a254+a301);
  a254=(a250*a254);
  a009=(a009+a254);
  a280=(a280+a009);
  if (res[0]!=0) res[0][29]=a280;
  a280=arg[0]? arg[0][30] : 0;
  a009=arg[0]? arg[0][33] : 0;
  a254=(a001*a009);
  a038=(a038*a280);
  a301=arg[0]? arg[0][31] : 0;
  a012=(a012*a301);
  a038=(a038+a012);
  a012=arg[0]? arg[0][32] : 0;
  a016=(a016*a012);
  a038=(a038-a016);
  a240=(a240*a009);
  a016=arg[0]? arg[0][34] : 0;
  a020=(a020*a016);
  a240=(a240+a020);
  a038=(a038+a240);
  a240=(a006*a038);
  a020=(a041*a009);
  a071=(a044*a038);
  a130=(a047*a009);
  a130=(a280+a130);
  a068=(a068*a130);
  a125=(a047*a016);
  a125=(a301+a125);
  a053=(a053*a125);
  a068=(a068+a053);
  a053=arg[0]? arg[0][35] : 0;
  a174=(a047*a053);
  a174=(a012+a174);
  a106=(a106*a174);
  a068=(a068-a106);
  a106=(a047*a038);
  a106=(a009+a106);
  a288=(a288*a106);
  a155=(a155*a280);
  a014=(a014*a301);
  a155=(a155+a014);
  a210=(a210*a012);
  a155=(a155+a210);
  a183=(a183*a009);
  a032=(a032*a016);
  a183=(a183-a032);
  a155=(a155+a183);
  a183=(a047*a155);
  a183=(a016+a183);
  a059=(a059*a183);
  a288=(a288+a059);
  a068=(a068+a288);
  a068=(a046*a068);
  a071=(a071+a068);
  a071=(a009+a071);
  a068=(a043*a071);
  a020=(a020+a068);
  a020=(a280+a020);
  a103=(a103*a020);
  a068=(a041*a016);
  a288=(a044*a155);
  a021=(a021*a130);
  a056=(a056*a125);
  a021=(a021+a056);
  a054=(a054*a174);
  a021=(a021+a054);
  a286=(a286*a106);
  a057=(a057*a183);
  a286=(a286-a057);
  a021=(a021+a286);
  a021=(a046*a021);
  a288=(a288+a021);
  a288=(a016+a288);
  a021=(a043*a288);
  a068=(a068+a021);
  a068=(a301+a068);
  a088=(a088*a068);
  a103=(a103+a088);
  a088=(a041*a053);
  a239=(a239*a280);
  a024=(a024*a301);
  a239=(a239+a024);
  a266=(a266*a012);
  a239=(a239-a266);
  a156=(a156*a009);
  a011=(a011*a016);
  a156=(a156+a011);
  a239=(a239+a156);
  a156=(a044*a239);
  a267=(a267*a130);
  a063=(a063*a125);
  a267=(a267+a063);
  a089=(a089*a174);
  a267=(a267-a089);
  a259=(a259*a106);
  a051=(a051*a183);
  a259=(a259+a051);
  a267=(a267+a259);
  a267=(a046*a267);
  a156=(a156+a267);
  a156=(a053+a156);
  a267=(a043*a156);
  a088=(a088+a267);
  a088=(a012+a088);
  a065=(a065*a088);
  a103=(a103-a065);
  a065=(a041*a038);
  a267=(a044*a009);
  a106=(a046*a106);
  a267=(a267+a106);
  a267=(a280+a267);
  a085=(a085*a267);
  a106=(a044*a016);
  a183=(a046*a183);
  a106=(a106+a183);
  a106=(a301+a106);
  a077=(a077*a106);
  a085=(a085+a077);
  a044=(a044*a053);
  a047=(a047*a239);
  a047=(a053+a047);
  a046=(a046*a047);
  a044=(a044+a046);
  a044=(a012+a044);
  a175=(a175*a044);
  a085=(a085-a175);
  a287=(a287*a071);
  a050=(a050*a288);
  a287=(a287+a050);
  a085=(a085+a287);
  a287=(a043*a085);
  a065=(a065+a287);
  a065=(a009+a065);
  a026=(a026*a065);
  a287=(a041*a155);
  a105=(a105*a267);
  a072=(a072*a106);
  a105=(a105+a072);
  a131=(a131*a044);
  a105=(a105+a131);
  a290=(a290*a071);
  a079=(a079*a288);
  a290=(a290-a079);
  a105=(a105+a290);
  a290=(a043*a105);
  a287=(a287+a290);
  a287=(a016+a287);
  a094=(a094*a287);
  a026=(a026+a094);
  a103=(a103+a026);
  a026=(a028*a103);
  a240=(a240+a026);
  a026=(a099*a009);
  a094=(a049*a071);
  a026=(a026+a094);
  a094=(a080*a065);
  a026=(a026+a094);
  a026=(a280+a026);
  a124=(a124*a026);
  a094=(a099*a016);
  a290=(a049*a288);
  a094=(a094+a290);
  a290=(a080*a287);
  a094=(a094+a290);
  a094=(a301+a094);
  a076=(a076*a094);
  a124=(a124+a076);
  a076=(a099*a053);
  a156=(a049*a156);
  a076=(a076+a156);
  a041=(a041*a239);
  a090=(a090*a267);
  a060=(a060*a106);
  a090=(a090+a060);
  a062=(a062*a044);
  a090=(a090-a062);
  a291=(a291*a071);
  a064=(a064*a288);
  a291=(a291+a064);
  a090=(a090+a291);
  a043=(a043*a090);
  a041=(a041+a043);
  a041=(a053+a041);
  a043=(a080*a041);
  a076=(a076+a043);
  a076=(a012+a076);
  a082=(a082*a076);
  a124=(a124-a082);
  a082=(a099*a038);
  a085=(a049*a085);
  a082=(a082+a085);
  a085=(a080*a103);
  a082=(a082+a085);
  a082=(a009+a082);
  a023=(a023*a082);
  a085=(a099*a155);
  a105=(a049*a105);
  a085=(a085+a105);
  a003=(a003*a020);
  a091=(a091*a068);
  a003=(a003+a091);
  a067=(a067*a088);
  a003=(a003+a067);
  a230=(a230*a065);
  a092=(a092*a287);
  a230=(a230-a092);
  a003=(a003+a230);
  a230=(a080*a003);
  a085=(a085+a230);
  a085=(a016+a085);
  a115=(a115*a085);
  a023=(a023+a115);
  a124=(a124+a023);
  a023=(a096*a124);
  a240=(a240+a023);
  a240=(a009+a240);
  a023=(a005*a240);
  a254=(a254+a023);
  a023=(a120*a038);
  a115=(a126*a103);
  a023=(a023+a115);
  a115=(a127*a124);
  a023=(a023+a115);
  a115=(a006*a009);
  a230=(a028*a065);
  a115=(a115+a230);
  a230=(a096*a082);
  a115=(a115+a230);
  a115=(a280+a115);
  a148=(a148*a115);
  a230=(a006*a016);
  a092=(a028*a287);
  a230=(a230+a092);
  a092=(a096*a085);
  a230=(a230+a092);
  a230=(a301+a230);
  a133=(a133*a230);
  a148=(a148+a133);
  a133=(a006*a053);
  a092=(a028*a041);
  a133=(a133+a092);
  a099=(a099*a239);
  a049=(a049*a090);
  a099=(a099+a049);
  a037=(a037*a020);
  a098=(a098*a068);
  a037=(a037+a098);
  a040=(a040*a088);
  a037=(a037-a040);
  a202=(a202*a065);
  a086=(a086*a287);
  a202=(a202+a086);
  a037=(a037+a202);
  a080=(a080*a037);
  a099=(a099+a080);
  a099=(a053+a099);
  a080=(a096*a099);
  a133=(a133+a080);
  a133=(a012+a133);
  a035=(a035*a133);
  a148=(a148-a035);
  a093=(a093*a240);
  a035=(a006*a155);
  a080=(a028*a003);
  a035=(a035+a080);
  a087=(a087*a026);
  a112=(a112*a094);
  a087=(a087+a112);
  a110=(a110*a076);
  a087=(a087+a110);
  a073=(a073*a082);
  a113=(a113*a085);
  a073=(a073-a113);
  a087=(a087+a073);
  a073=(a096*a087);
  a035=(a035+a073);
  a035=(a016+a035);
  a139=(a139*a035);
  a093=(a093+a139);
  a148=(a148+a093);
  a093=(a128*a148);
  a023=(a023+a093);
  a023=(a009+a023);
  a093=(a117*a023);
  a254=(a254+a093);
  a093=(a144*a038);
  a139=(a084*a103);
  a093=(a093+a139);
  a139=(a151*a124);
  a093=(a093+a139);
  a139=(a152*a148);
  a093=(a093+a139);
  a139=(a120*a009);
  a073=(a126*a065);
  a139=(a139+a073);
  a073=(a127*a082);
  a139=(a139+a073);
  a073=(a128*a240);
  a139=(a139+a073);
  a139=(a280+a139);
  a173=(a173*a139);
  a073=(a120*a016);
  a113=(a126*a287);
  a073=(a073+a113);
  a113=(a127*a085);
  a073=(a073+a113);
  a113=(a128*a035);
  a073=(a073+a113);
  a073=(a301+a073);
  a158=(a158*a073);
  a173=(a173+a158);
  a158=(a120*a053);
  a113=(a126*a041);
  a158=(a158+a113);
  a113=(a127*a099);
  a158=(a158+a113);
  a006=(a006*a239);
  a028=(a028*a037);
  a006=(a006+a028);
  a102=(a102*a026);
  a119=(a119*a094);
  a102=(a102+a119);
  a289=(a289*a076);
  a102=(a102-a289);
  a083=(a083*a082);
  a108=(a108*a085);
  a083=(a083+a108);
  a102=(a102+a083);
  a096=(a096*a102);
  a006=(a006+a096);
  a006=(a053+a006);
  a096=(a128*a006);
  a158=(a158+a096);
  a158=(a012+a158);
  a135=(a135*a158);
  a173=(a173-a135);
  a114=(a114*a023);
  a135=(a120*a155);
  a096=(a126*a003);
  a135=(a135+a096);
  a096=(a127*a087);
  a135=(a135+a096);
  a109=(a109*a115);
  a136=(a136*a230);
  a109=(a109+a136);
  a134=(a134*a133);
  a109=(a109+a134);
  a074=(a074*a240);
  a137=(a137*a035);
  a074=(a074-a137);
  a109=(a109+a074);
  a074=(a128*a109);
  a135=(a135+a074);
  a135=(a016+a135);
  a164=(a164*a135);
  a114=(a114+a164);
  a173=(a173+a114);
  a114=(a153*a173);
  a093=(a093+a114);
  a093=(a009+a093);
  a114=(a141*a093);
  a254=(a254+a114);
  a114=(a169*a038);
  a164=(a176*a103);
  a114=(a114+a164);
  a164=(a177*a124);
  a114=(a114+a164);
  a164=(a178*a148);
  a114=(a114+a164);
  a164=(a179*a173);
  a114=(a114+a164);
  a164=(a144*a009);
  a074=(a084*a065);
  a164=(a164+a074);
  a074=(a151*a082);
  a164=(a164+a074);
  a074=(a152*a240);
  a164=(a164+a074);
  a074=(a153*a023);
  a164=(a164+a074);
  a164=(a280+a164);
  a200=(a200*a164);
  a074=(a144*a016);
  a137=(a084*a287);
  a074=(a074+a137);
  a137=(a151*a085);
  a074=(a074+a137);
  a137=(a152*a035);
  a074=(a074+a137);
  a137=(a153*a135);
  a074=(a074+a137);
  a074=(a301+a074);
  a185=(a185*a074);
  a200=(a200+a185);
  a185=(a144*a053);
  a137=(a084*a041);
  a185=(a185+a137);
  a137=(a151*a099);
  a185=(a185+a137);
  a137=(a152*a006);
  a185=(a185+a137);
  a120=(a120*a239);
  a126=(a126*a037);
  a120=(a120+a126);
  a127=(a127*a102);
  a120=(a120+a127);
  a123=(a123*a115);
  a143=(a143*a230);
  a123=(a123+a143);
  a118=(a118*a133);
  a123=(a123-a118);
  a045=(a045*a240);
  a132=(a132*a035);
  a045=(a045+a132);
  a123=(a123+a045);
  a128=(a128*a123);
  a120=(a120+a128);
  a120=(a053+a120);
  a128=(a153*a120);
  a185=(a185+a128);
  a185=(a012+a185);
  a160=(a160*a185);
  a200=(a200-a160);
  a138=(a138*a093);
  a160=(a144*a155);
  a128=(a084*a003);
  a160=(a160+a128);
  a128=(a151*a087);
  a160=(a160+a128);
  a128=(a152*a109);
  a160=(a160+a128);
  a048=(a048*a139);
  a161=(a161*a073);
  a048=(a048+a161);
  a159=(a159*a158);
  a048=(a048+a159);
  a293=(a293*a023);
  a162=(a162*a135);
  a293=(a293-a162);
  a048=(a048+a293);
  a293=(a153*a048);
  a160=(a160+a293);
  a160=(a016+a160);
  a191=(a191*a160);
  a138=(a138+a191);
  a200=(a200+a138);
  a138=(a180*a200);
  a114=(a114+a138);
  a114=(a009+a114);
  a138=(a166*a114);
  a254=(a254+a138);
  a138=(a196*a038);
  a191=(a203*a103);
  a138=(a138+a191);
  a191=(a204*a124);
  a138=(a138+a191);
  a191=(a205*a148);
  a138=(a138+a191);
  a191=(a206*a173);
  a138=(a138+a191);
  a191=(a207*a200);
  a138=(a138+a191);
  a191=(a169*a009);
  a293=(a176*a065);
  a191=(a191+a293);
  a293=(a177*a082);
  a191=(a191+a293);
  a293=(a178*a240);
  a191=(a191+a293);
  a293=(a179*a023);
  a191=(a191+a293);
  a293=(a180*a093);
  a191=(a191+a293);
  a191=(a280+a191);
  a228=(a228*a191);
  a293=(a169*a016);
  a162=(a176*a287);
  a293=(a293+a162);
  a162=(a177*a085);
  a293=(a293+a162);
  a162=(a178*a035);
  a293=(a293+a162);
  a162=(a179*a135);
  a293=(a293+a162);
  a162=(a180*a160);
  a293=(a293+a162);
  a293=(a301+a293);
  a213=(a213*a293);
  a228=(a228+a213);
  a213=(a169*a053);
  a162=(a176*a041);
  a213=(a213+a162);
  a162=(a177*a099);
  a213=(a213+a162);
  a162=(a178*a006);
  a213=(a213+a162);
  a162=(a179*a120);
  a213=(a213+a162);
  a144=(a144*a239);
  a084=(a084*a037);
  a144=(a144+a084);
  a151=(a151*a102);
  a144=(a144+a151);
  a152=(a152*a123);
  a144=(a144+a152);
  a145=(a145*a139);
  a168=(a168*a073);
  a145=(a145+a168);
  a147=(a147*a158);
  a145=(a145-a147);
  a294=(a294*a023);
  a157=(a157*a135);
  a294=(a294+a157);
  a145=(a145+a294);
  a153=(a153*a145);
  a144=(a144+a153);
  a144=(a053+a144);
  a153=(a180*a144);
  a213=(a213+a153);
  a213=(a012+a213);
  a187=(a187*a213);
  a228=(a228-a187);
  a163=(a163*a114);
  a187=(a169*a155);
  a153=(a176*a003);
  a187=(a187+a153);
  a153=(a177*a087);
  a187=(a187+a153);
  a153=(a178*a109);
  a187=(a187+a153);
  a153=(a179*a048);
  a187=(a187+a153);
  a061=(a061*a164);
  a188=(a188*a074);
  a061=(a061+a188);
  a186=(a186*a185);
  a061=(a061+a186);
  a298=(a298*a093);
  a189=(a189*a160);
  a298=(a298-a189);
  a061=(a061+a298);
  a298=(a180*a061);
  a187=(a187+a298);
  a187=(a016+a187);
  a219=(a219*a187);
  a163=(a163+a219);
  a228=(a228+a163);
  a163=(a208*a228);
  a138=(a138+a163);
  a138=(a009+a138);
  a163=(a193*a138);
  a254=(a254+a163);
  a163=(a224*a038);
  a219=(a231*a103);
  a163=(a163+a219);
  a219=(a232*a124);
  a163=(a163+a219);
  a219=(a233*a148);
  a163=(a163+a219);
  a219=(a234*a173);
  a163=(a163+a219);
  a219=(a235*a200);
  a163=(a163+a219);
  a219=(a236*a228);
  a163=(a163+a219);
  a219=(a196*a009);
  a298=(a203*a065);
  a219=(a219+a298);
  a298=(a204*a082);
  a219=(a219+a298);
  a298=(a205*a240);
  a219=(a219+a298);
  a298=(a206*a023);
  a219=(a219+a298);
  a298=(a207*a093);
  a219=(a219+a298);
  a298=(a208*a114);
  a219=(a219+a298);
  a219=(a280+a219);
  a257=(a257*a219);
  a298=(a196*a016);
  a189=(a203*a287);
  a298=(a298+a189);
  a189=(a204*a085);
  a298=(a298+a189);
  a189=(a205*a035);
  a298=(a298+a189);
  a189=(a206*a135);
  a298=(a298+a189);
  a189=(a207*a160);
  a298=(a298+a189);
  a189=(a208*a187);
  a298=(a298+a189);
  a298=(a301+a298);
  a242=(a242*a298);
  a257=(a257+a242);
  a242=(a196*a053);
  a189=(a203*a041);
  a242=(a242+a189);
  a189=(a204*a099);
  a242=(a242+a189);
  a189=(a205*a006);
  a242=(a242+a189);
  a189=(a206*a120);
  a242=(a242+a189);
  a189=(a207*a144);
  a242=(a242+a189);
  a169=(a169*a239);
  a176=(a176*a037);
  a169=(a169+a176);
  a177=(a177*a102);
  a169=(a169+a177);
  a178=(a178*a123);
  a169=(a169+a178);
  a179=(a179*a145);
  a169=(a169+a179);
  a170=(a170*a164);
  a195=(a195*a074);
  a170=(a170+a195);
  a172=(a172*a185);
  a170=(a170-a172);
  a299=(a299*a093);
  a184=(a184*a160);
  a299=(a299+a184);
  a170=(a170+a299);
  a180=(a180*a170);
  a169=(a169+a180);
  a169=(a053+a169);
  a180=(a208*a169);
  a242=(a242+a180);
  a242=(a012+a242);
  a215=(a215*a242);
  a257=(a257-a215);
  a190=(a190*a138);
  a215=(a196*a155);
  a180=(a203*a003);
  a215=(a215+a180);
  a180=(a204*a087);
  a215=(a215+a180);
  a180=(a205*a109);
  a215=(a215+a180);
  a180=(a206*a048);
  a215=(a215+a180);
  a180=(a207*a061);
  a215=(a215+a180);
  a111=(a111*a191);
  a216=(a216*a293);
  a111=(a111+a216);
  a214=(a214*a213);
  a111=(a111+a214);
  a303=(a303*a114);
  a217=(a217*a187);
  a303=(a303-a217);
  a111=(a111+a303);
  a303=(a208*a111);
  a215=(a215+a303);
  a215=(a016+a215);
  a248=(a248*a215);
  a190=(a190+a248);
  a257=(a257+a190);
  a190=(a237*a257);
  a163=(a163+a190);
  a163=(a009+a163);
  a190=(a221*a163);
  a254=(a254+a190);
  a190=(a253*a038);
  a103=(a260*a103);
  a190=(a190+a103);
  a124=(a095*a124);
  a190=(a190+a124);
  a124=(a116*a148);
  a190=(a190+a124);
  a124=(a261*a173);
  a190=(a190+a124);
  a124=(a262*a200);
  a190=(a190+a124);
  a124=(a263*a228);
  a190=(a190+a124);
  a124=(a264*a257);
  a190=(a190+a124);
  a124=(a224*a009);
  a103=(a231*a065);
  a124=(a124+a103);
  a103=(a232*a082);
  a124=(a124+a103);
  a103=(a233*a240);
  a124=(a124+a103);
  a103=(a234*a023);
  a124=(a124+a103);
  a103=(a235*a093);
  a124=(a124+a103);
  a103=(a236*a114);
  a124=(a124+a103);
  a103=(a237*a138);
  a124=(a124+a103);
  a124=(a280+a124);
  a284=(a284*a124);
  a103=(a224*a016);
  a248=(a231*a287);
  a103=(a103+a248);
  a248=(a232*a085);
  a103=(a103+a248);
  a248=(a233*a035);
  a103=(a103+a248);
  a248=(a234*a135);
  a103=(a103+a248);
  a248=(a235*a160);
  a103=(a103+a248);
  a248=(a236*a187);
  a103=(a103+a248);
  a248=(a237*a215);
  a103=(a103+a248);
  a103=(a301+a103);
  a269=(a269*a103);
  a284=(a284+a269);
  a269=(a224*a053);
  a248=(a231*a041);
  a269=(a269+a248);
  a248=(a232*a099);
  a269=(a269+a248);
  a248=(a233*a006);
  a269=(a269+a248);
  a248=(a234*a120);
  a269=(a269+a248);
  a248=(a235*a144);
  a269=(a269+a248);
  a248=(a236*a169);
  a269=(a269+a248);
  a196=(a196*a239);
  a203=(a203*a037);
  a196=(a196+a203);
  a204=(a204*a102);
  a196=(a196+a204);
  a205=(a205*a123);
  a196=(a196+a205);
  a206=(a206*a145);
  a196=(a196+a206);
  a207=(a207*a170);
  a196=(a196+a207);
  a197=(a197*a191);
  a223=(a223*a293);
  a197=(a197+a223);
  a199=(a199*a213);
  a197=(a197-a199);
  a304=(a304*a114);
  a212=(a212*a187);
  a304=(a304+a212);
  a197=(a197+a304);
  a208=(a208*a197);
  a196=(a196+a208);
  a196=(a053+a196);
  a208=(a237*a196);
  a269=(a269+a208);
  a269=(a012+a269);
  a201=(a201*a269);
  a284=(a284-a201);
  a218=(a218*a163);
  a201=(a224*a155);
  a208=(a231*a003);
  a201=(a201+a208);
  a208=(a232*a087);
  a201=(a201+a208);
  a208=(a233*a109);
  a201=(a201+a208);
  a208=(a234*a048);
  a201=(a201+a208);
  a208=(a235*a061);
  a201=(a201+a208);
  a208=(a236*a111);
  a201=(a201+a208);
  a140=(a140*a219);
  a245=(a245*a298);
  a140=(a140+a245);
  a243=(a243*a242);
  a140=(a140+a243);
  a308=(a308*a138);
  a246=(a246*a215);
  a308=(a308-a246);
  a140=(a140+a308);
  a308=(a237*a140);
  a201=(a201+a308);
  a201=(a016+a201);
  a275=(a275*a201);
  a218=(a218+a275);
  a284=(a284+a218);
  a218=(a265*a284);
  a190=(a190+a218);
  a190=(a009+a190);
  a218=(a250*a190);
  a254=(a254+a218);
  a254=(a280+a254);
  if (res[0]!=0) res[0][30]=a254;
  a254=(a001*a016);
  a218=(a005*a035);
  a254=(a254+a218);
  a218=(a117*a135);
  a254=(a254+a218);
  a218=(a141*a160);
  a254=(a254+a218);
  a218=(a166*a187);
  a254=(a254+a218);
  a218=(a193*a215);
  a254=(a254+a218);
  a218=(a221*a201);
  a254=(a254+a218);
  a218=(a253*a155);
  a003=(a260*a003);
  a218=(a218+a003);
  a087=(a095*a087);
  a218=(a218+a087);
  a087=(a116*a109);
  a218=(a218+a087);
  a087=(a261*a048);
  a218=(a218+a087);
  a087=(a262*a061);
  a218=(a218+a087);
  a087=(a263*a111);
  a218=(a218+a087);
  a087=(a264*a140);
  a218=(a218+a087);
  a238=(a238*a124);
  a272=(a272*a103);
  a238=(a238+a272);
  a270=(a270*a269);
  a238=(a238+a270);
  a311=(a311*a163);
  a273=(a273*a201);
  a311=(a311-a273);
  a238=(a238+a311);
  a311=(a265*a238);
  a218=(a218+a311);
  a218=(a016+a218);
  a311=(a250*a218);
  a254=(a254+a311);
  a254=(a301+a254);
  if (res[0]!=0) res[0][31]=a254;
  a254=(a001*a053);
  a311=(a005*a006);
  a254=(a254+a311);
  a311=(a117*a120);
  a254=(a254+a311);
  a311=(a141*a144);
  a254=(a254+a311);
  a311=(a166*a169);
  a254=(a254+a311);
  a311=(a193*a196);
  a254=(a254+a311);
  a224=(a224*a239);
  a231=(a231*a037);
  a224=(a224+a231);
  a232=(a232*a102);
  a224=(a224+a232);
  a233=(a233*a123);
  a224=(a224+a233);
  a234=(a234*a145);
  a224=(a224+a234);
  a235=(a235*a170);
  a224=(a224+a235);
  a236=(a236*a197);
  a224=(a224+a236);
  a225=(a225*a219);
  a252=(a252*a298);
  a225=(a225+a252);
  a227=(a227*a242);
  a225=(a225-a227);
  a309=(a309*a138);
  a241=(a241*a215);
  a309=(a309+a241);
  a225=(a225+a309);
  a237=(a237*a225);
  a224=(a224+a237);
  a224=(a053+a224);
  a237=(a221*a224);
  a254=(a254+a237);
  a237=(a253*a239);
  a037=(a260*a037);
  a237=(a237+a037);
  a102=(a095*a102);
  a237=(a237+a102);
  a102=(a116*a123);
  a237=(a237+a102);
  a102=(a261*a145);
  a237=(a237+a102);
  a102=(a262*a170);
  a237=(a237+a102);
  a102=(a263*a197);
  a237=(a237+a102);
  a102=(a264*a225);
  a237=(a237+a102);
  a013=(a013*a124);
  a279=(a279*a103);
  a013=(a013+a279);
  a100=(a100*a269);
  a013=(a013-a100);
  a312=(a312*a163);
  a268=(a268*a201);
  a312=(a312+a268);
  a013=(a013+a312);
  a312=(a265*a013);
  a237=(a237+a312);
  a237=(a053+a237);
  a237=(a250*a237);
  a254=(a254+a237);
  a254=(a012+a254);
  if (res[0]!=0) res[0][32]=a254;
  a038=(a001*a038);
  a148=(a005*a148);
  a038=(a038+a148);
  a173=(a117*a173);
  a038=(a038+a173);
  a200=(a141*a200);
  a038=(a038+a200);
  a228=(a166*a228);
  a038=(a038+a228);
  a257=(a193*a257);
  a038=(a038+a257);
  a284=(a221*a284);
  a038=(a038+a284);
  a284=(a253*a009);
  a065=(a260*a065);
  a284=(a284+a065);
  a082=(a095*a082);
  a284=(a284+a082);
  a240=(a116*a240);
  a284=(a284+a240);
  a023=(a261*a023);
  a284=(a284+a023);
  a093=(a262*a093);
  a284=(a284+a093);
  a114=(a263*a114);
  a284=(a284+a114);
  a138=(a264*a138);
  a284=(a284+a138);
  a163=(a265*a163);
  a284=(a284+a163);
  a280=(a280+a284);
  a027=(a027*a280);
  a284=(a253*a016);
  a287=(a260*a287);
  a284=(a284+a287);
  a085=(a095*a085);
  a284=(a284+a085);
  a035=(a116*a035);
  a284=(a284+a035);
  a135=(a261*a135);
  a284=(a284+a135);
  a160=(a262*a160);
  a284=(a284+a160);
  a187=(a263*a187);
  a284=(a284+a187);
  a215=(a264*a215);
  a284=(a284+a215);
  a201=(a265*a201);
  a284=(a284+a201);
  a301=(a301+a284);
  a220=(a220*a301);
  a027=(a027+a220);
  a253=(a253*a053);
  a260=(a260*a041);
  a253=(a253+a260);
  a095=(a095*a099);
  a253=(a253+a095);
  a116=(a116*a006);
  a253=(a253+a116);
  a261=(a261*a120);
  a253=(a253+a261);
  a262=(a262*a144);
  a253=(a253+a262);
  a263=(a263*a169);
  a253=(a253+a263);
  a264=(a264*a196);
  a253=(a253+a264);
  a265=(a265*a224);
  a253=(a253+a265);
  a012=(a012+a253);
  a282=(a282*a012);
  a027=(a027-a282);
  a255=(a255*a190);
  a078=(a078*a218);
  a255=(a255+a078);
  a027=(a027+a255);
  a027=(a250*a027);
  a038=(a038+a027);
  a009=(a009+a038);
  if (res[0]!=0) res[0][33]=a009;
  a155=(a001*a155);
  a109=(a005*a109);
  a155=(a155+a109);
  a048=(a117*a048);
  a155=(a155+a048);
  a061=(a141*a061);
  a155=(a155+a061);
  a111=(a166*a111);
  a155=(a155+a111);
  a140=(a193*a140);
  a155=(a155+a140);
  a238=(a221*a238);
  a155=(a155+a238);
  a129=(a129*a280);
  a029=(a029*a301);
  a129=(a129+a029);
  a007=(a007*a012);
  a129=(a129+a007);
  a244=(a244*a190);
  a030=(a030*a218);
  a244=(a244-a030);
  a129=(a129+a244);
  a129=(a250*a129);
  a155=(a155+a129);
  a016=(a016+a155);
  if (res[0]!=0) res[0][34]=a016;
  a001=(a001*a239);
  a005=(a005*a123);
  a001=(a001+a005);
  a117=(a117*a145);
  a001=(a001+a117);
  a141=(a141*a170);
  a001=(a001+a141);
  a166=(a166*a197);
  a001=(a001+a166);
  a193=(a193*a225);
  a001=(a001+a193);
  a221=(a221*a013);
  a001=(a001+a221);
  a209=(a209*a280);
  a285=(a285*a301);
  a209=(a209+a285);
  a039=(a039*a012);
  a209=(a209-a039);
  a033=(a033*a190);
  a018=(a018*a218);
  a033=(a033+a018);
  a209=(a209+a033);
  a250=(a250*a209);
  a001=(a001+a250);
  a053=(a053+a001);
  if (res[0]!=0) res[0][35]=a053;
  return 0;
}

/* variational_steps:(y[6x6],t,turns[2x12],h,p[8])->(y_end[6x6]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+313, w1, *w3=w+349, w5, *w6=w+351, w7;
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
  a01=(a26-a08);
  a01=(a11*a01);
  a43=(a43+a01);
  a43=(a43+a26);
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+2, *rr, *w0=w+576, *w1=w+612, *w3=w+618, *w4=w+654;
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
  casadi_real **res1=res+1, *w0=w+788, *w2=w+794;
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
  casadi_real a108;
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
  a016=(a012-a014);
  a016=(a007*a016);
  a009=(a009+a016);
  a009=(a009+a012);
  a016=(2.*a007);
  a017=1.;
  a018=(a017-a013);
  a018=(a016*a018);
  a018=(a018+a017);
  a019=(a009/a018);
  a013=(a013-a017);
  a013=(a007*a013);
  a020=(a013/a018);
  a021=casadi_sq(a003);
  a021=(a021*a011);
  a021=(a021+a014);
  a021=(a007*a021);
  a014=arg[4]? arg[4][5] : 0;
  a011=arg[4]? arg[4][7] : 0;
  a022=arg[4]? arg[4][2] : 0;
  a022=(a011*a022);
  a023=arg[1]? arg[1][1] : 0;
  a024=(a022*a023);
  a024=(a008+a024);
  a024=(a014*a024);
  a025=arg[4]? arg[4][4] : 0;
  a026=arg[4]? arg[4][6] : 0;
  a027=arg[1]? arg[1][0] : 0;
  a028=(a027+a017);
  a028=(a011*a028);
  a028=(a026-a028);
  a028=(a028+a010);
  a028=(a025*a028);
  a024=(a024+a028);
  a021=(a021-a024);
  a024=(a020*a009);
  a021=(a021-a024);
  a024=(a013*a020);
  a024=(a007-a024);
  a028=(a021/a024);
  a029=arg[4]? arg[4][1] : 0;
  a015=(a029*a015);
  a018=(a015/a018);
  a013=(a013*a018);
  a024=(a013/a024);
  a009=(a018*a009);
  a030=(a029*a003);
  a030=(a030*a003);
  a030=(a030*a012);
  a012=arg[4]? arg[4][0] : 0;
  a031=arg[0]? arg[0][2] : 0;
  a032=(a012*a031);
  a030=(a030+a032);
  a009=(a009-a030);
  a021=(a024*a021);
  a009=(a009-a021);
  a015=(a015*a018);
  a015=(a029-a015);
  a013=(a013*a024);
  a015=(a015-a013);
  a009=(a009/a015);
  a024=(a024*a009);
  a028=(a028-a024);
  a020=(a020*a028);
  a019=(a019-a020);
  a018=(a018*a009);
  a019=(a019+a018);
  a018=(a006*a019);
  a020=1.7082860872947386e-01;
  a020=(a020*a002);
  a024=2.9587585476806851e-02;
  a024=(a024*a002);
  a015=(a024*a028);
  a013=8.8762756430420545e-02;
  a013=(a013*a002);
  a021=1.9725056984537900e-02;
  a021=(a021*a002);
  a030=(a021*a019);
  a032=5.9175170953613701e-02;
  a032=(a032*a002);
  a033=5.2600151958767730e-02;
  a033=(a033*a002);
  a034=(a033*a028);
  a034=(a008+a034);
  a035=(a007*a034);
  a036=(a033*a008);
  a036=(a010+a036);
  a037=sin(a036);
  a035=(a035*a037);
  a038=(a033*a019);
  a038=(a003+a038);
  a039=(2.*a038);
  a039=(a034-a039);
  a035=(a035*a039);
  a039=(a033*a003);
  a039=(a000+a039);
  a040=sin(a039);
  a041=cos(a036);
  a042=(a040*a041);
  a039=cos(a039);
  a043=(a039*a037);
  a042=(a042-a043);
  a043=(a040-a042);
  a043=(a007*a043);
  a035=(a035+a043);
  a035=(a035+a040);
  a043=(a017-a041);
  a043=(a016*a043);
  a043=(a043+a017);
  a044=(a035/a043);
  a041=(a041-a017);
  a041=(a007*a041);
  a045=(a041/a043);
  a046=casadi_sq(a038);
  a046=(a046*a037);
  a046=(a046+a042);
  a046=(a007*a046);
  a042=arg[2]? arg[2][2] : 0;
  a037=(a023*a042);
  a047=arg[2]? arg[2][3] : 0;
  a048=(a027*a047);
  a037=(a037+a048);
  a037=(a022*a037);
  a037=(a034+a037);
  a037=(a014*a037);
  a042=(a027*a042);
  a047=(a023*a047);
  a042=(a042-a047);
  a042=(a042+a017);
  a042=(a011*a042);
  a042=(a026-a042);
  a042=(a042+a036);
  a042=(a025*a042);
  a037=(a037+a042);
  a046=(a046-a037);
  a037=(a045*a035);
  a046=(a046-a037);
  a037=(a041*a045);
  a037=(a007-a037);
  a042=(a046/a037);
  a039=(a029*a039);
  a043=(a039/a043);
  a041=(a041*a043);
  a037=(a041/a037);
  a035=(a043*a035);
  a036=(a029*a038);
  a036=(a036*a038);
  a036=(a036*a040);
  a040=arg[0]? arg[0][5] : 0;
  a047=(a033*a040);
  a047=(a031+a047);
  a047=(a012*a047);
  a036=(a036+a047);
  a035=(a035-a036);
  a046=(a037*a046);
  a035=(a035-a046);
  a039=(a039*a043);
  a039=(a029-a039);
  a041=(a041*a037);
  a039=(a039-a041);
  a035=(a035/a039);
  a037=(a037*a035);
  a042=(a042-a037);
  a045=(a045*a042);
  a044=(a044-a045);
  a043=(a043*a035);
  a044=(a044+a043);
  a044=(a032*a044);
  a030=(a030+a044);
  a030=(a003+a030);
  a044=casadi_sq(a030);
  a043=(a021*a008);
  a034=(a032*a034);
  a043=(a043+a034);
  a043=(a010+a043);
  a034=sin(a043);
  a044=(a044*a034);
  a045=(a021*a003);
  a038=(a032*a038);
  a045=(a045+a038);
  a045=(a000+a045);
  a038=sin(a045);
  a037=cos(a043);
  a039=(a038*a037);
  a045=cos(a045);
  a041=(a045*a034);
  a039=(a039-a041);
  a044=(a044+a039);
  a044=(a007*a044);
  a041=(a021*a028);
  a042=(a032*a042);
  a041=(a041+a042);
  a041=(a008+a041);
  a042=arg[2]? arg[2][4] : 0;
  a046=(a023*a042);
  a036=arg[2]? arg[2][5] : 0;
  a047=(a027*a036);
  a046=(a046+a047);
  a046=(a022*a046);
  a046=(a041+a046);
  a046=(a014*a046);
  a042=(a027*a042);
  a036=(a023*a036);
  a042=(a042-a036);
  a042=(a042+a017);
  a042=(a011*a042);
  a042=(a026-a042);
  a042=(a042+a043);
  a042=(a025*a042);
  a046=(a046+a042);
  a044=(a044-a046);
  a046=(a037-a017);
  a046=(a007*a046);
  a037=(a017-a037);
  a037=(a016*a037);
  a037=(a037+a017);
  a042=(a046/a037);
  a043=(a007*a041);
  a043=(a043*a034);
  a034=(2.*a030);
  a034=(a041-a034);
  a043=(a043*a034);
  a039=(a038-a039);
  a039=(a007*a039);
  a043=(a043+a039);
  a043=(a043+a038);
  a039=(a042*a043);
  a044=(a044-a039);
  a039=(a046*a042);
  a039=(a007-a039);
  a034=(a044/a039);
  a045=(a029*a045);
  a036=(a045/a037);
  a046=(a046*a036);
  a039=(a046/a039);
  a047=(a036*a043);
  a048=(a029*a030);
  a048=(a048*a030);
  a048=(a048*a038);
  a038=(a021*a040);
  a033=(a033*a009);
  a033=(a040+a033);
  a033=(a032*a033);
  a038=(a038+a033);
  a038=(a031+a038);
  a038=(a012*a038);
  a048=(a048+a038);
  a047=(a047-a048);
  a044=(a039*a044);
  a047=(a047-a044);
  a045=(a045*a036);
  a045=(a029-a045);
  a046=(a046*a039);
  a045=(a045-a046);
  a047=(a047/a045);
  a039=(a039*a047);
  a034=(a034-a039);
  a039=(a013*a034);
  a015=(a015+a039);
  a015=(a008+a015);
  a039=(a007*a015);
  a045=(a024*a008);
  a046=(a013*a041);
  a045=(a045+a046);
  a045=(a010+a045);
  a046=sin(a045);
  a039=(a039*a046);
  a044=(a024*a019);
  a043=(a043/a037);
  a042=(a042*a034);
  a043=(a043-a042);
  a036=(a036*a047);
  a043=(a043+a036);
  a036=(a013*a043);
  a044=(a044+a036);
  a044=(a003+a044);
  a036=(2.*a044);
  a036=(a015-a036);
  a039=(a039*a036);
  a036=(a024*a003);
  a042=(a013*a030);
  a036=(a036+a042);
  a036=(a000+a036);
  a042=sin(a036);
  a037=cos(a045);
  a048=(a042*a037);
  a036=cos(a036);
  a038=(a036*a046);
  a048=(a048-a038);
  a038=(a042-a048);
  a038=(a007*a038);
  a039=(a039+a038);
  a039=(a039+a042);
  a038=(a017-a037);
  a038=(a016*a038);
  a038=(a038+a017);
  a033=(a039/a038);
  a037=(a037-a017);
  a037=(a007*a037);
  a049=(a037/a038);
  a050=casadi_sq(a044);
  a050=(a050*a046);
  a050=(a050+a048);
  a050=(a007*a050);
  a048=arg[2]? arg[2][6] : 0;
  a046=(a023*a048);
  a051=arg[2]? arg[2][7] : 0;
  a052=(a027*a051);
  a046=(a046+a052);
  a046=(a022*a046);
  a046=(a015+a046);
  a046=(a014*a046);
  a048=(a027*a048);
  a051=(a023*a051);
  a048=(a048-a051);
  a048=(a048+a017);
  a048=(a011*a048);
  a048=(a026-a048);
  a048=(a048+a045);
  a048=(a025*a048);
  a046=(a046+a048);
  a050=(a050-a046);
  a046=(a049*a039);
  a050=(a050-a046);
  a046=(a037*a049);
  a046=(a007-a046);
  a048=(a050/a046);
  a036=(a029*a036);
  a038=(a036/a038);
  a037=(a037*a038);
  a046=(a037/a046);
  a039=(a038*a039);
  a045=(a029*a044);
  a045=(a045*a044);
  a045=(a045*a042);
  a042=(a024*a040);
  a021=(a021*a009);
  a032=(a032*a035);
  a021=(a021+a032);
  a021=(a040+a021);
  a032=(a013*a021);
  a042=(a042+a032);
  a042=(a031+a042);
  a042=(a012*a042);
  a045=(a045+a042);
  a039=(a039-a045);
  a050=(a046*a050);
  a039=(a039-a050);
  a036=(a036*a038);
  a036=(a029-a036);
  a037=(a037*a046);
  a036=(a036-a037);
  a039=(a039/a036);
  a046=(a046*a039);
  a048=(a048-a046);
  a049=(a049*a048);
  a033=(a033-a049);
  a038=(a038*a039);
  a033=(a033+a038);
  a038=(a020*a033);
  a018=(a018+a038);
  a038=1.2546768756682242e-01;
  a038=(a038*a002);
  a049=2.4136513415926669e-01;
  a049=(a049*a002);
  a046=(a049*a028);
  a036=-8.8454947932828609e-01;
  a036=(a036*a002);
  a034=(a036*a034);
  a046=(a046+a034);
  a034=9.2483400326179199e-01;
  a034=(a034*a002);
  a037=(a034*a048);
  a046=(a046+a037);
  a046=(a008+a046);
  a037=(a007*a046);
  a050=(a049*a008);
  a041=(a036*a041);
  a050=(a050+a041);
  a041=(a034*a015);
  a050=(a050+a041);
  a050=(a010+a050);
  a041=sin(a050);
  a037=(a037*a041);
  a045=(a049*a019);
  a043=(a036*a043);
  a045=(a045+a043);
  a043=(a034*a033);
  a045=(a045+a043);
  a045=(a003+a045);
  a043=(2.*a045);
  a043=(a046-a043);
  a037=(a037*a043);
  a043=(a049*a003);
  a030=(a036*a030);
  a043=(a043+a030);
  a030=(a034*a044);
  a043=(a043+a030);
  a043=(a000+a043);
  a030=sin(a043);
  a042=cos(a050);
  a032=(a030*a042);
  a043=cos(a043);
  a035=(a043*a041);
  a032=(a032-a035);
  a035=(a030-a032);
  a035=(a007*a035);
  a037=(a037+a035);
  a037=(a037+a030);
  a035=(a017-a042);
  a035=(a016*a035);
  a035=(a035+a017);
  a051=(a037/a035);
  a042=(a042-a017);
  a042=(a007*a042);
  a052=(a042/a035);
  a053=casadi_sq(a045);
  a053=(a053*a041);
  a053=(a053+a032);
  a053=(a007*a053);
  a032=arg[2]? arg[2][8] : 0;
  a041=(a023*a032);
  a054=arg[2]? arg[2][9] : 0;
  a055=(a027*a054);
  a041=(a041+a055);
  a041=(a022*a041);
  a041=(a046+a041);
  a041=(a014*a041);
  a032=(a027*a032);
  a054=(a023*a054);
  a032=(a032-a054);
  a032=(a032+a017);
  a032=(a011*a032);
  a032=(a026-a032);
  a032=(a032+a050);
  a032=(a025*a032);
  a041=(a041+a032);
  a053=(a053-a041);
  a041=(a052*a037);
  a053=(a053-a041);
  a041=(a042*a052);
  a041=(a007-a041);
  a032=(a053/a041);
  a043=(a029*a043);
  a035=(a043/a035);
  a042=(a042*a035);
  a041=(a042/a041);
  a037=(a035*a037);
  a050=(a029*a045);
  a050=(a050*a045);
  a050=(a050*a030);
  a030=(a049*a040);
  a021=(a036*a021);
  a030=(a030+a021);
  a024=(a024*a009);
  a013=(a013*a047);
  a024=(a024+a013);
  a024=(a040+a024);
  a013=(a034*a024);
  a030=(a030+a013);
  a030=(a031+a030);
  a030=(a012*a030);
  a050=(a050+a030);
  a037=(a037-a050);
  a053=(a041*a053);
  a037=(a037-a053);
  a043=(a043*a035);
  a043=(a029-a043);
  a042=(a042*a041);
  a043=(a043-a042);
  a037=(a037/a043);
  a041=(a041*a037);
  a032=(a032-a041);
  a052=(a052*a032);
  a051=(a051-a052);
  a035=(a035*a037);
  a051=(a051+a035);
  a035=(a038*a051);
  a018=(a018+a035);
  a018=(a003+a018);
  a035=(a005*a018);
  a004=(a004+a035);
  a035=1.8915178993145003e+00;
  a035=(a035*a002);
  a052=3.7109375000000000e-02;
  a052=(a052*a002);
  a041=(a052*a019);
  a043=1.7025221101954405e-01;
  a043=(a043*a002);
  a042=(a043*a033);
  a041=(a041+a042);
  a042=6.0216538980455959e-02;
  a042=(a042*a002);
  a053=(a042*a051);
  a041=(a041+a053);
  a053=-1.7578125000000000e-02;
  a053=(a053*a002);
  a050=(a006*a028);
  a030=(a020*a048);
  a050=(a050+a030);
  a030=(a038*a032);
  a050=(a050+a030);
  a050=(a008+a050);
  a030=(a007*a050);
  a013=(a006*a008);
  a021=(a020*a015);
  a013=(a013+a021);
  a021=(a038*a046);
  a013=(a013+a021);
  a013=(a010+a013);
  a021=sin(a013);
  a030=(a030*a021);
  a054=(2.*a018);
  a054=(a050-a054);
  a030=(a030*a054);
  a054=(a006*a003);
  a055=(a020*a044);
  a054=(a054+a055);
  a055=(a038*a045);
  a054=(a054+a055);
  a054=(a000+a054);
  a055=sin(a054);
  a056=cos(a013);
  a057=(a055*a056);
  a054=cos(a054);
  a058=(a054*a021);
  a057=(a057-a058);
  a058=(a055-a057);
  a058=(a007*a058);
  a030=(a030+a058);
  a030=(a030+a055);
  a058=(a017-a056);
  a058=(a016*a058);
  a058=(a058+a017);
  a059=(a030/a058);
  a056=(a056-a017);
  a056=(a007*a056);
  a060=(a056/a058);
  a061=casadi_sq(a018);
  a061=(a061*a021);
  a061=(a061+a057);
  a061=(a007*a061);
  a057=arg[2]? arg[2][10] : 0;
  a021=(a023*a057);
  a062=arg[2]? arg[2][11] : 0;
  a063=(a027*a062);
  a021=(a021+a063);
  a021=(a022*a021);
  a021=(a050+a021);
  a021=(a014*a021);
  a057=(a027*a057);
  a062=(a023*a062);
  a057=(a057-a062);
  a057=(a057+a017);
  a057=(a011*a057);
  a057=(a026-a057);
  a057=(a057+a013);
  a057=(a025*a057);
  a021=(a021+a057);
  a061=(a061-a021);
  a021=(a060*a030);
  a061=(a061-a021);
  a021=(a056*a060);
  a021=(a007-a021);
  a057=(a061/a021);
  a054=(a029*a054);
  a058=(a054/a058);
  a056=(a056*a058);
  a021=(a056/a021);
  a030=(a058*a030);
  a013=(a029*a018);
  a013=(a013*a018);
  a013=(a013*a055);
  a055=(a006*a040);
  a062=(a020*a024);
  a055=(a055+a062);
  a049=(a049*a009);
  a036=(a036*a047);
  a049=(a049+a036);
  a034=(a034*a039);
  a049=(a049+a034);
  a049=(a040+a049);
  a034=(a038*a049);
  a055=(a055+a034);
  a055=(a031+a055);
  a055=(a012*a055);
  a013=(a013+a055);
  a030=(a030-a013);
  a061=(a021*a061);
  a030=(a030-a061);
  a054=(a054*a058);
  a054=(a029-a054);
  a056=(a056*a021);
  a054=(a054-a056);
  a030=(a030/a054);
  a021=(a021*a030);
  a057=(a057-a021);
  a060=(a060*a057);
  a059=(a059-a060);
  a058=(a058*a030);
  a059=(a059+a058);
  a058=(a053*a059);
  a041=(a041+a058);
  a041=(a003+a041);
  a058=(a035*a041);
  a004=(a004+a058);
  a058=-5.8012039600105849e+00;
  a058=(a058*a002);
  a060=3.7092000118504789e-02;
  a060=(a060*a002);
  a021=(a060*a019);
  a054=1.7038392571223998e-01;
  a054=(a054*a002);
  a056=(a054*a033);
  a021=(a021+a056);
  a056=1.0726203044637328e-01;
  a056=(a056*a002);
  a061=(a056*a051);
  a021=(a021+a061);
  a061=-1.5319437748624402e-02;
  a061=(a061*a002);
  a013=(a061*a059);
  a021=(a021+a013);
  a013=8.2737891638140233e-03;
  a013=(a013*a002);
  a055=(a052*a028);
  a034=(a043*a048);
  a055=(a055+a034);
  a034=(a042*a032);
  a055=(a055+a034);
  a034=(a053*a057);
  a055=(a055+a034);
  a055=(a008+a055);
  a034=(a007*a055);
  a036=(a052*a008);
  a047=(a043*a015);
  a036=(a036+a047);
  a047=(a042*a046);
  a036=(a036+a047);
  a047=(a053*a050);
  a036=(a036+a047);
  a036=(a010+a036);
  a047=sin(a036);
  a034=(a034*a047);
  a062=(2.*a041);
  a062=(a055-a062);
  a034=(a034*a062);
  a062=(a052*a003);
  a063=(a043*a044);
  a062=(a062+a063);
  a063=(a042*a045);
  a062=(a062+a063);
  a063=(a053*a018);
  a062=(a062+a063);
  a062=(a000+a062);
  a063=sin(a062);
  a064=cos(a036);
  a065=(a063*a064);
  a062=cos(a062);
  a066=(a062*a047);
  a065=(a065-a066);
  a066=(a063-a065);
  a066=(a007*a066);
  a034=(a034+a066);
  a034=(a034+a063);
  a066=(a017-a064);
  a066=(a016*a066);
  a066=(a066+a017);
  a067=(a034/a066);
  a064=(a064-a017);
  a064=(a007*a064);
  a068=(a064/a066);
  a069=casadi_sq(a041);
  a069=(a069*a047);
  a069=(a069+a065);
  a069=(a007*a069);
  a065=arg[2]? arg[2][12] : 0;
  a047=(a023*a065);
  a070=arg[2]? arg[2][13] : 0;
  a071=(a027*a070);
  a047=(a047+a071);
  a047=(a022*a047);
  a047=(a055+a047);
  a047=(a014*a047);
  a065=(a027*a065);
  a070=(a023*a070);
  a065=(a065-a070);
  a065=(a065+a017);
  a065=(a011*a065);
  a065=(a026-a065);
  a065=(a065+a036);
  a065=(a025*a065);
  a047=(a047+a065);
  a069=(a069-a047);
  a047=(a068*a034);
  a069=(a069-a047);
  a047=(a064*a068);
  a047=(a007-a047);
  a065=(a069/a047);
  a062=(a029*a062);
  a066=(a062/a066);
  a064=(a064*a066);
  a047=(a064/a047);
  a034=(a066*a034);
  a036=(a029*a041);
  a036=(a036*a041);
  a036=(a036*a063);
  a063=(a052*a040);
  a070=(a043*a024);
  a063=(a063+a070);
  a070=(a042*a049);
  a063=(a063+a070);
  a006=(a006*a009);
  a020=(a020*a039);
  a006=(a006+a020);
  a038=(a038*a037);
  a006=(a006+a038);
  a006=(a040+a006);
  a038=(a053*a006);
  a063=(a063+a038);
  a063=(a031+a063);
  a063=(a012*a063);
  a036=(a036+a063);
  a034=(a034-a036);
  a069=(a047*a069);
  a034=(a034-a069);
  a062=(a062*a066);
  a062=(a029-a062);
  a064=(a064*a047);
  a062=(a062-a064);
  a034=(a034/a062);
  a047=(a047*a034);
  a065=(a065-a047);
  a068=(a068*a065);
  a067=(a067-a068);
  a066=(a066*a034);
  a067=(a067+a066);
  a066=(a013*a067);
  a021=(a021+a066);
  a021=(a003+a021);
  a066=(a058*a021);
  a004=(a004+a066);
  a066=3.1116436695781990e-01;
  a066=(a066*a002);
  a068=6.2411095871607569e-01;
  a068=(a068*a002);
  a047=(a068*a019);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a064=(a062*a033);
  a047=(a047+a064);
  a064=-8.6821934684172597e-01;
  a064=(a064*a002);
  a069=(a064*a051);
  a047=(a047+a069);
  a069=2.7592099699446710e+01;
  a069=(a069*a002);
  a036=(a069*a059);
  a047=(a047+a036);
  a036=2.0154067550477894e+01;
  a036=(a036*a002);
  a063=(a036*a067);
  a047=(a047+a063);
  a063=-4.3489884181069961e+01;
  a063=(a063*a002);
  a038=(a060*a028);
  a020=(a054*a048);
  a038=(a038+a020);
  a020=(a056*a032);
  a038=(a038+a020);
  a020=(a061*a057);
  a038=(a038+a020);
  a020=(a013*a065);
  a038=(a038+a020);
  a038=(a008+a038);
  a020=(a007*a038);
  a070=(a060*a008);
  a071=(a054*a015);
  a070=(a070+a071);
  a071=(a056*a046);
  a070=(a070+a071);
  a071=(a061*a050);
  a070=(a070+a071);
  a071=(a013*a055);
  a070=(a070+a071);
  a070=(a010+a070);
  a071=sin(a070);
  a020=(a020*a071);
  a072=(2.*a021);
  a072=(a038-a072);
  a020=(a020*a072);
  a072=(a060*a003);
  a073=(a054*a044);
  a072=(a072+a073);
  a073=(a056*a045);
  a072=(a072+a073);
  a073=(a061*a018);
  a072=(a072+a073);
  a073=(a013*a041);
  a072=(a072+a073);
  a072=(a000+a072);
  a073=sin(a072);
  a074=cos(a070);
  a075=(a073*a074);
  a072=cos(a072);
  a076=(a072*a071);
  a075=(a075-a076);
  a076=(a073-a075);
  a076=(a007*a076);
  a020=(a020+a076);
  a020=(a020+a073);
  a076=(a017-a074);
  a076=(a016*a076);
  a076=(a076+a017);
  a077=(a020/a076);
  a074=(a074-a017);
  a074=(a007*a074);
  a078=(a074/a076);
  a079=casadi_sq(a021);
  a079=(a079*a071);
  a079=(a079+a075);
  a079=(a007*a079);
  a075=arg[2]? arg[2][14] : 0;
  a071=(a023*a075);
  a080=arg[2]? arg[2][15] : 0;
  a081=(a027*a080);
  a071=(a071+a081);
  a071=(a022*a071);
  a071=(a038+a071);
  a071=(a014*a071);
  a075=(a027*a075);
  a080=(a023*a080);
  a075=(a075-a080);
  a075=(a075+a017);
  a075=(a011*a075);
  a075=(a026-a075);
  a075=(a075+a070);
  a075=(a025*a075);
  a071=(a071+a075);
  a079=(a079-a071);
  a071=(a078*a020);
  a079=(a079-a071);
  a071=(a074*a078);
  a071=(a007-a071);
  a075=(a079/a071);
  a072=(a029*a072);
  a076=(a072/a076);
  a074=(a074*a076);
  a071=(a074/a071);
  a020=(a076*a020);
  a070=(a029*a021);
  a070=(a070*a021);
  a070=(a070*a073);
  a073=(a060*a040);
  a080=(a054*a024);
  a073=(a073+a080);
  a080=(a056*a049);
  a073=(a073+a080);
  a080=(a061*a006);
  a073=(a073+a080);
  a052=(a052*a009);
  a043=(a043*a039);
  a052=(a052+a043);
  a042=(a042*a037);
  a052=(a052+a042);
  a053=(a053*a030);
  a052=(a052+a053);
  a052=(a040+a052);
  a053=(a013*a052);
  a073=(a073+a053);
  a073=(a031+a073);
  a073=(a012*a073);
  a070=(a070+a073);
  a020=(a020-a070);
  a079=(a071*a079);
  a020=(a020-a079);
  a072=(a072*a076);
  a072=(a029-a072);
  a074=(a074*a071);
  a072=(a072-a074);
  a020=(a020/a072);
  a071=(a071*a020);
  a075=(a075-a071);
  a078=(a078*a075);
  a077=(a077-a078);
  a076=(a076*a020);
  a077=(a077+a076);
  a076=(a063*a077);
  a047=(a047+a076);
  a047=(a003+a047);
  a076=(a066*a047);
  a004=(a004+a076);
  a076=-1.5216094966251609e-01;
  a076=(a076*a002);
  a078=4.7766253643826434e-01;
  a078=(a078*a002);
  a071=(a078*a019);
  a072=-2.4881146199716677e+00;
  a072=(a072*a002);
  a074=(a072*a033);
  a071=(a071+a074);
  a074=-5.9029082683684297e-01;
  a074=(a074*a002);
  a079=(a074*a051);
  a071=(a071+a079);
  a079=2.1230051448181193e+01;
  a079=(a079*a002);
  a070=(a079*a059);
  a071=(a071+a070);
  a070=1.5279233632882423e+01;
  a070=(a070*a002);
  a073=(a070*a067);
  a071=(a071+a073);
  a073=-3.3288210968984863e+01;
  a073=(a073*a002);
  a053=(a073*a077);
  a071=(a071+a053);
  a053=-2.0331201708508627e-02;
  a053=(a053*a002);
  a042=(a068*a028);
  a043=(a062*a048);
  a042=(a042+a043);
  a043=(a064*a032);
  a042=(a042+a043);
  a043=(a069*a057);
  a042=(a042+a043);
  a043=(a036*a065);
  a042=(a042+a043);
  a043=(a063*a075);
  a042=(a042+a043);
  a042=(a008+a042);
  a043=(a007*a042);
  a080=(a068*a008);
  a081=(a062*a015);
  a080=(a080+a081);
  a081=(a064*a046);
  a080=(a080+a081);
  a081=(a069*a050);
  a080=(a080+a081);
  a081=(a036*a055);
  a080=(a080+a081);
  a081=(a063*a038);
  a080=(a080+a081);
  a080=(a010+a080);
  a081=sin(a080);
  a043=(a043*a081);
  a082=(2.*a047);
  a082=(a042-a082);
  a043=(a043*a082);
  a082=(a068*a003);
  a083=(a062*a044);
  a082=(a082+a083);
  a083=(a064*a045);
  a082=(a082+a083);
  a083=(a069*a018);
  a082=(a082+a083);
  a083=(a036*a041);
  a082=(a082+a083);
  a083=(a063*a021);
  a082=(a082+a083);
  a082=(a000+a082);
  a083=sin(a082);
  a084=cos(a080);
  a085=(a083*a084);
  a082=cos(a082);
  a086=(a082*a081);
  a085=(a085-a086);
  a086=(a083-a085);
  a086=(a007*a086);
  a043=(a043+a086);
  a043=(a043+a083);
  a086=(a017-a084);
  a086=(a016*a086);
  a086=(a086+a017);
  a087=(a043/a086);
  a084=(a084-a017);
  a084=(a007*a084);
  a088=(a084/a086);
  a089=casadi_sq(a047);
  a089=(a089*a081);
  a089=(a089+a085);
  a089=(a007*a089);
  a085=arg[2]? arg[2][16] : 0;
  a081=(a023*a085);
  a090=arg[2]? arg[2][17] : 0;
  a091=(a027*a090);
  a081=(a081+a091);
  a081=(a022*a081);
  a081=(a042+a081);
  a081=(a014*a081);
  a085=(a027*a085);
  a090=(a023*a090);
  a085=(a085-a090);
  a085=(a085+a017);
  a085=(a011*a085);
  a085=(a026-a085);
  a085=(a085+a080);
  a085=(a025*a085);
  a081=(a081+a085);
  a089=(a089-a081);
  a081=(a088*a043);
  a089=(a089-a081);
  a081=(a084*a088);
  a081=(a007-a081);
  a085=(a089/a081);
  a082=(a029*a082);
  a086=(a082/a086);
  a084=(a084*a086);
  a081=(a084/a081);
  a043=(a086*a043);
  a080=(a029*a047);
  a080=(a080*a047);
  a080=(a080*a083);
  a083=(a068*a040);
  a090=(a062*a024);
  a083=(a083+a090);
  a090=(a064*a049);
  a083=(a083+a090);
  a090=(a069*a006);
  a083=(a083+a090);
  a090=(a036*a052);
  a083=(a083+a090);
  a060=(a060*a009);
  a054=(a054*a039);
  a060=(a060+a054);
  a056=(a056*a037);
  a060=(a060+a056);
  a061=(a061*a030);
  a060=(a060+a061);
  a013=(a013*a034);
  a060=(a060+a013);
  a060=(a040+a060);
  a013=(a063*a060);
  a083=(a083+a013);
  a083=(a031+a083);
  a083=(a012*a083);
  a080=(a080+a083);
  a043=(a043-a080);
  a089=(a081*a089);
  a043=(a043-a089);
  a082=(a082*a086);
  a082=(a029-a082);
  a084=(a084*a081);
  a082=(a082-a084);
  a043=(a043/a082);
  a081=(a081*a043);
  a085=(a085-a081);
  a088=(a088*a085);
  a087=(a087-a088);
  a086=(a086*a043);
  a087=(a087+a086);
  a086=(a053*a087);
  a071=(a071+a086);
  a071=(a003+a071);
  a086=(a076*a071);
  a004=(a004+a086);
  a086=2.0136540080403034e-01;
  a086=(a086*a002);
  a088=-9.3714243008598730e-01;
  a088=(a088*a002);
  a081=(a088*a019);
  a082=5.1863724288440638e+00;
  a082=(a082*a002);
  a084=(a082*a033);
  a081=(a081+a084);
  a084=1.0914373489967295e+00;
  a084=(a084*a002);
  a089=(a084*a051);
  a081=(a081+a089);
  a089=-8.1497870107469268e+00;
  a089=(a089*a002);
  a080=(a089*a059);
  a081=(a081+a080);
  a080=-1.8520065659996959e+01;
  a080=(a080*a002);
  a083=(a080*a067);
  a081=(a081+a083);
  a083=2.2739487099350505e+01;
  a083=(a083*a002);
  a013=(a083*a077);
  a081=(a081+a013);
  a013=2.4936055526796523e+00;
  a013=(a013*a002);
  a061=(a013*a087);
  a081=(a081+a061);
  a061=-3.0467644718982196e+00;
  a061=(a061*a002);
  a056=(a078*a028);
  a054=(a072*a048);
  a056=(a056+a054);
  a054=(a074*a032);
  a056=(a056+a054);
  a054=(a079*a057);
  a056=(a056+a054);
  a054=(a070*a065);
  a056=(a056+a054);
  a054=(a073*a075);
  a056=(a056+a054);
  a054=(a053*a085);
  a056=(a056+a054);
  a056=(a008+a056);
  a054=(a007*a056);
  a090=(a078*a008);
  a091=(a072*a015);
  a090=(a090+a091);
  a091=(a074*a046);
  a090=(a090+a091);
  a091=(a079*a050);
  a090=(a090+a091);
  a091=(a070*a055);
  a090=(a090+a091);
  a091=(a073*a038);
  a090=(a090+a091);
  a091=(a053*a042);
  a090=(a090+a091);
  a090=(a010+a090);
  a091=sin(a090);
  a054=(a054*a091);
  a092=(2.*a071);
  a092=(a056-a092);
  a054=(a054*a092);
  a092=(a078*a003);
  a093=(a072*a044);
  a092=(a092+a093);
  a093=(a074*a045);
  a092=(a092+a093);
  a093=(a079*a018);
  a092=(a092+a093);
  a093=(a070*a041);
  a092=(a092+a093);
  a093=(a073*a021);
  a092=(a092+a093);
  a093=(a053*a047);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=sin(a092);
  a094=cos(a090);
  a095=(a093*a094);
  a092=cos(a092);
  a096=(a092*a091);
  a095=(a095-a096);
  a096=(a093-a095);
  a096=(a007*a096);
  a054=(a054+a096);
  a054=(a054+a093);
  a096=(a017-a094);
  a096=(a016*a096);
  a096=(a096+a017);
  a097=(a054/a096);
  a094=(a094-a017);
  a094=(a007*a094);
  a098=(a094/a096);
  a099=casadi_sq(a071);
  a099=(a099*a091);
  a099=(a099+a095);
  a099=(a007*a099);
  a095=arg[2]? arg[2][18] : 0;
  a091=(a023*a095);
  a100=arg[2]? arg[2][19] : 0;
  a101=(a027*a100);
  a091=(a091+a101);
  a091=(a022*a091);
  a091=(a056+a091);
  a091=(a014*a091);
  a095=(a027*a095);
  a100=(a023*a100);
  a095=(a095-a100);
  a095=(a095+a017);
  a095=(a011*a095);
  a095=(a026-a095);
  a095=(a095+a090);
  a095=(a025*a095);
  a091=(a091+a095);
  a099=(a099-a091);
  a091=(a098*a054);
  a099=(a099-a091);
  a091=(a094*a098);
  a091=(a007-a091);
  a095=(a099/a091);
  a092=(a029*a092);
  a096=(a092/a096);
  a094=(a094*a096);
  a091=(a094/a091);
  a054=(a096*a054);
  a090=(a029*a071);
  a090=(a090*a071);
  a090=(a090*a093);
  a093=(a078*a040);
  a100=(a072*a024);
  a093=(a093+a100);
  a100=(a074*a049);
  a093=(a093+a100);
  a100=(a079*a006);
  a093=(a093+a100);
  a100=(a070*a052);
  a093=(a093+a100);
  a100=(a073*a060);
  a093=(a093+a100);
  a068=(a068*a009);
  a062=(a062*a039);
  a068=(a068+a062);
  a064=(a064*a037);
  a068=(a068+a064);
  a069=(a069*a030);
  a068=(a068+a069);
  a036=(a036*a034);
  a068=(a068+a036);
  a063=(a063*a020);
  a068=(a068+a063);
  a068=(a040+a068);
  a063=(a053*a068);
  a093=(a093+a063);
  a093=(a031+a093);
  a093=(a012*a093);
  a090=(a090+a093);
  a054=(a054-a090);
  a099=(a091*a099);
  a054=(a054-a099);
  a092=(a092*a096);
  a092=(a029-a092);
  a094=(a094*a091);
  a092=(a092-a094);
  a054=(a054/a092);
  a091=(a091*a054);
  a095=(a095-a091);
  a098=(a098*a095);
  a097=(a097-a098);
  a096=(a096*a054);
  a097=(a097+a096);
  a096=(a061*a097);
  a081=(a081+a096);
  a081=(a003+a081);
  a096=(a086*a081);
  a004=(a004+a096);
  a096=4.4710615727772587e-02;
  a096=(a096*a002);
  a098=2.2733101475165380e+00;
  a098=(a098*a002);
  a091=(a098*a019);
  a092=-1.0534495466737249e+01;
  a092=(a092*a002);
  a033=(a092*a033);
  a091=(a091+a033);
  a033=-2.0008720582248625e+00;
  a033=(a033*a002);
  a051=(a033*a051);
  a091=(a091+a051);
  a051=-1.7958931863118799e+01;
  a051=(a051*a002);
  a094=(a051*a059);
  a091=(a091+a094);
  a094=2.7948884529419960e+01;
  a094=(a094*a002);
  a099=(a094*a067);
  a091=(a091+a099);
  a099=-2.8589982771350235e+00;
  a099=(a099*a002);
  a090=(a099*a077);
  a091=(a091+a090);
  a090=-8.8728569335306293e+00;
  a090=(a090*a002);
  a093=(a090*a087);
  a091=(a091+a093);
  a093=1.2360567175794303e+01;
  a093=(a093*a002);
  a063=(a093*a097);
  a091=(a091+a063);
  a063=6.4339274601576357e-01;
  a063=(a063*a002);
  a002=(a088*a028);
  a036=(a082*a048);
  a002=(a002+a036);
  a036=(a084*a032);
  a002=(a002+a036);
  a036=(a089*a057);
  a002=(a002+a036);
  a036=(a080*a065);
  a002=(a002+a036);
  a036=(a083*a075);
  a002=(a002+a036);
  a036=(a013*a085);
  a002=(a002+a036);
  a036=(a061*a095);
  a002=(a002+a036);
  a002=(a008+a002);
  a036=(a007*a002);
  a069=(a088*a008);
  a064=(a082*a015);
  a069=(a069+a064);
  a064=(a084*a046);
  a069=(a069+a064);
  a064=(a089*a050);
  a069=(a069+a064);
  a064=(a080*a055);
  a069=(a069+a064);
  a064=(a083*a038);
  a069=(a069+a064);
  a064=(a013*a042);
  a069=(a069+a064);
  a064=(a061*a056);
  a069=(a069+a064);
  a069=(a010+a069);
  a064=sin(a069);
  a036=(a036*a064);
  a062=(2.*a081);
  a062=(a002-a062);
  a036=(a036*a062);
  a062=(a088*a003);
  a100=(a082*a044);
  a062=(a062+a100);
  a100=(a084*a045);
  a062=(a062+a100);
  a100=(a089*a018);
  a062=(a062+a100);
  a100=(a080*a041);
  a062=(a062+a100);
  a100=(a083*a021);
  a062=(a062+a100);
  a100=(a013*a047);
  a062=(a062+a100);
  a100=(a061*a071);
  a062=(a062+a100);
  a062=(a000+a062);
  a100=sin(a062);
  a101=cos(a069);
  a102=(a100*a101);
  a062=cos(a062);
  a103=(a062*a064);
  a102=(a102-a103);
  a103=(a100-a102);
  a103=(a007*a103);
  a036=(a036+a103);
  a036=(a036+a100);
  a103=(a017-a101);
  a103=(a016*a103);
  a103=(a103+a017);
  a104=(a036/a103);
  a101=(a101-a017);
  a101=(a007*a101);
  a105=(a101/a103);
  a106=casadi_sq(a081);
  a106=(a106*a064);
  a106=(a106+a102);
  a106=(a007*a106);
  a102=arg[2]? arg[2][20] : 0;
  a064=(a023*a102);
  a107=arg[2]? arg[2][21] : 0;
  a108=(a027*a107);
  a064=(a064+a108);
  a064=(a022*a064);
  a064=(a002+a064);
  a064=(a014*a064);
  a102=(a027*a102);
  a107=(a023*a107);
  a102=(a102-a107);
  a102=(a102+a017);
  a102=(a011*a102);
  a102=(a026-a102);
  a102=(a102+a069);
  a102=(a025*a102);
  a064=(a064+a102);
  a106=(a106-a064);
  a064=(a105*a036);
  a106=(a106-a064);
  a064=(a101*a105);
  a064=(a007-a064);
  a102=(a106/a064);
  a062=(a029*a062);
  a103=(a062/a103);
  a101=(a101*a103);
  a064=(a101/a064);
  a036=(a103*a036);
  a069=(a029*a081);
  a069=(a069*a081);
  a069=(a069*a100);
  a100=(a088*a040);
  a107=(a082*a024);
  a100=(a100+a107);
  a107=(a084*a049);
  a100=(a100+a107);
  a107=(a089*a006);
  a100=(a100+a107);
  a107=(a080*a052);
  a100=(a100+a107);
  a107=(a083*a060);
  a100=(a100+a107);
  a107=(a013*a068);
  a100=(a100+a107);
  a078=(a078*a009);
  a072=(a072*a039);
  a078=(a078+a072);
  a074=(a074*a037);
  a078=(a078+a074);
  a079=(a079*a030);
  a078=(a078+a079);
  a070=(a070*a034);
  a078=(a078+a070);
  a073=(a073*a020);
  a078=(a078+a073);
  a053=(a053*a043);
  a078=(a078+a053);
  a078=(a040+a078);
  a053=(a061*a078);
  a100=(a100+a053);
  a100=(a031+a100);
  a100=(a012*a100);
  a069=(a069+a100);
  a036=(a036-a069);
  a106=(a064*a106);
  a036=(a036-a106);
  a062=(a062*a103);
  a062=(a029-a062);
  a101=(a101*a064);
  a062=(a062-a101);
  a036=(a036/a062);
  a064=(a064*a036);
  a102=(a102-a064);
  a105=(a105*a102);
  a104=(a104-a105);
  a103=(a103*a036);
  a104=(a104+a103);
  a103=(a063*a104);
  a091=(a091+a103);
  a091=(a003+a091);
  a103=(a096*a091);
  a004=(a004+a103);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a103=(a005*a050);
  a004=(a004+a103);
  a103=(a035*a055);
  a004=(a004+a103);
  a103=(a058*a038);
  a004=(a004+a103);
  a103=(a066*a042);
  a004=(a004+a103);
  a103=(a076*a056);
  a004=(a004+a103);
  a103=(a086*a002);
  a004=(a004+a103);
  a103=(a098*a028);
  a048=(a092*a048);
  a103=(a103+a048);
  a032=(a033*a032);
  a103=(a103+a032);
  a032=(a051*a057);
  a103=(a103+a032);
  a032=(a094*a065);
  a103=(a103+a032);
  a032=(a099*a075);
  a103=(a103+a032);
  a032=(a090*a085);
  a103=(a103+a032);
  a032=(a093*a095);
  a103=(a103+a032);
  a032=(a063*a102);
  a103=(a103+a032);
  a103=(a008+a103);
  a032=(a096*a103);
  a004=(a004+a032);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a040);
  a032=(a005*a006);
  a004=(a004+a032);
  a032=(a035*a052);
  a004=(a004+a032);
  a032=(a058*a060);
  a004=(a004+a032);
  a032=(a066*a068);
  a004=(a004+a032);
  a032=(a076*a078);
  a004=(a004+a032);
  a088=(a088*a009);
  a082=(a082*a039);
  a088=(a088+a082);
  a084=(a084*a037);
  a088=(a088+a084);
  a089=(a089*a030);
  a088=(a088+a089);
  a080=(a080*a034);
  a088=(a088+a080);
  a083=(a083*a020);
  a088=(a088+a083);
  a013=(a013*a043);
  a088=(a088+a013);
  a061=(a061*a054);
  a088=(a088+a061);
  a088=(a040+a088);
  a061=(a086*a088);
  a004=(a004+a061);
  a061=(a098*a009);
  a039=(a092*a039);
  a061=(a061+a039);
  a037=(a033*a037);
  a061=(a061+a037);
  a037=(a051*a030);
  a061=(a061+a037);
  a037=(a094*a034);
  a061=(a061+a037);
  a037=(a099*a020);
  a061=(a061+a037);
  a037=(a090*a043);
  a061=(a061+a037);
  a037=(a093*a054);
  a061=(a061+a037);
  a037=(a063*a036);
  a061=(a061+a037);
  a061=(a040+a061);
  a061=(a096*a061);
  a004=(a004+a061);
  a004=(a031+a004);
  if (res[0]!=0) res[0][2]=a004;
  a019=(a001*a019);
  a059=(a005*a059);
  a019=(a019+a059);
  a067=(a035*a067);
  a019=(a019+a067);
  a077=(a058*a077);
  a019=(a019+a077);
  a087=(a066*a087);
  a019=(a019+a087);
  a097=(a076*a097);
  a019=(a019+a097);
  a104=(a086*a104);
  a019=(a019+a104);
  a104=(a007*a103);
  a097=(a098*a008);
  a015=(a092*a015);
  a097=(a097+a015);
  a046=(a033*a046);
  a097=(a097+a046);
  a050=(a051*a050);
  a097=(a097+a050);
  a055=(a094*a055);
  a097=(a097+a055);
  a038=(a099*a038);
  a097=(a097+a038);
  a042=(a090*a042);
  a097=(a097+a042);
  a056=(a093*a056);
  a097=(a097+a056);
  a002=(a063*a002);
  a097=(a097+a002);
  a010=(a010+a097);
  a097=sin(a010);
  a104=(a104*a097);
  a002=(2.*a091);
  a002=(a103-a002);
  a104=(a104*a002);
  a002=(a098*a003);
  a044=(a092*a044);
  a002=(a002+a044);
  a045=(a033*a045);
  a002=(a002+a045);
  a018=(a051*a018);
  a002=(a002+a018);
  a041=(a094*a041);
  a002=(a002+a041);
  a021=(a099*a021);
  a002=(a002+a021);
  a047=(a090*a047);
  a002=(a002+a047);
  a071=(a093*a071);
  a002=(a002+a071);
  a081=(a063*a081);
  a002=(a002+a081);
  a000=(a000+a002);
  a002=sin(a000);
  a081=cos(a010);
  a071=(a002*a081);
  a000=cos(a000);
  a047=(a000*a097);
  a071=(a071-a047);
  a047=(a002-a071);
  a047=(a007*a047);
  a104=(a104+a047);
  a104=(a104+a002);
  a047=(a017-a081);
  a016=(a016*a047);
  a016=(a016+a017);
  a047=(a104/a016);
  a081=(a081-a017);
  a081=(a007*a081);
  a021=(a081/a016);
  a041=casadi_sq(a091);
  a041=(a041*a097);
  a041=(a041+a071);
  a041=(a007*a041);
  a071=arg[2]? arg[2][22] : 0;
  a097=(a023*a071);
  a018=arg[2]? arg[2][23] : 0;
  a045=(a027*a018);
  a097=(a097+a045);
  a022=(a022*a097);
  a103=(a103+a022);
  a014=(a014*a103);
  a027=(a027*a071);
  a023=(a023*a018);
  a027=(a027-a023);
  a027=(a027+a017);
  a011=(a011*a027);
  a026=(a026-a011);
  a026=(a026+a010);
  a025=(a025*a026);
  a014=(a014+a025);
  a041=(a041-a014);
  a014=(a021*a104);
  a041=(a041-a014);
  a014=(a081*a021);
  a007=(a007-a014);
  a014=(a041/a007);
  a000=(a029*a000);
  a016=(a000/a016);
  a081=(a081*a016);
  a007=(a081/a007);
  a104=(a016*a104);
  a025=(a029*a091);
  a025=(a025*a091);
  a025=(a025*a002);
  a098=(a098*a040);
  a092=(a092*a024);
  a098=(a098+a092);
  a033=(a033*a049);
  a098=(a098+a033);
  a051=(a051*a006);
  a098=(a098+a051);
  a094=(a094*a052);
  a098=(a098+a094);
  a099=(a099*a060);
  a098=(a098+a099);
  a090=(a090*a068);
  a098=(a098+a090);
  a093=(a093*a078);
  a098=(a098+a093);
  a063=(a063*a088);
  a098=(a098+a063);
  a031=(a031+a098);
  a012=(a012*a031);
  a025=(a025+a012);
  a104=(a104-a025);
  a041=(a007*a041);
  a104=(a104-a041);
  a000=(a000*a016);
  a029=(a029-a000);
  a081=(a081*a007);
  a029=(a029-a081);
  a104=(a104/a029);
  a007=(a007*a104);
  a014=(a014-a007);
  a021=(a021*a014);
  a047=(a047-a021);
  a016=(a016*a104);
  a047=(a047+a016);
  a047=(a096*a047);
  a019=(a019+a047);
  a003=(a003+a019);
  if (res[0]!=0) res[0][3]=a003;
  a028=(a001*a028);
  a057=(a005*a057);
  a028=(a028+a057);
  a065=(a035*a065);
  a028=(a028+a065);
  a075=(a058*a075);
  a028=(a028+a075);
  a085=(a066*a085);
  a028=(a028+a085);
  a095=(a076*a095);
  a028=(a028+a095);
  a102=(a086*a102);
  a028=(a028+a102);
  a014=(a096*a014);
  a028=(a028+a014);
  a008=(a008+a028);
  if (res[0]!=0) res[0][4]=a008;
  a001=(a001*a009);
  a005=(a005*a030);
  a001=(a001+a005);
  a035=(a035*a034);
  a001=(a001+a035);
  a058=(a058*a020);
  a001=(a001+a058);
  a066=(a066*a043);
  a001=(a001+a066);
  a076=(a076*a054);
  a001=(a001+a076);
  a086=(a086*a036);
  a001=(a001+a086);
  a096=(a096*a104);
  a001=(a001+a096);
  a040=(a040+a001);
  if (res[0]!=0) res[0][5]=a040;
  return 0;
}

/* plain_steps:(y[6],t,turns[2x12],h,p[8])->(y_end[6]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+109, w1, *w3=w+115, w5, *w6=w+117, w7;
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
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+808, *w2=w+814;
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
  if (sz_w) *sz_w = 820;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 820*sizeof(casadi_real);
  return 0;
}

/* wobbling_jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+2, *rr, *w0=w+576, *w1=w+612, *w3=w+618, *w4=w+654;
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
  casadi_real **res1=res+1, *w0=w+788, *w2=w+794;
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
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+808, *w2=w+814;
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
  if (sz_w) *sz_w = 820;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 820*sizeof(casadi_real);
  return 0;
}

/* wobbling_jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+2, *rr, *w0=w+576, *w1=w+612, *w3=w+618, *w4=w+654;
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
  casadi_real **res1=res+1, *w0=w+788, *w2=w+794;
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
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+808, *w2=w+814;
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
  if (sz_w) *sz_w = 820;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 820*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_36:(u[6],p[8])->(R[6]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_72:(u[6],p[8])->(R[6]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_96:(u[6],p[8])->(R[6]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_144:(u[6],p[8])->(R[6]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_192:(u[6],p[8])->(R[6]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_288:(u[6],p[8])->(R[6]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_384:(u[6],p[8])->(R[6]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+158, *w1=w+164, *w3=w+169, w4, w5, w6, *w7=w+175;
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
  casadi_real **res1=res+2, *w0=w+576, *w2=w+582, *w3=w+618;
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
  casadi_real **res1=res+2, *rr, *w0=w+632, *w1=w+668, *w3=w+674, *w4=w+710;
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
  casadi_real **res1=res+1, *w0=w+844, *w2=w+850;
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
  casadi_real **res1=res+2, *rr, *w00=w+422, *w01=w+428, *w03=w+433, *w04=w+439, *w05=w+469, w06, w07, w08, *w09=w+505, *w10=w+529;
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
  casadi_real **res1=res+3, *w0=w+864, *w2=w+870, *w3=w+876;
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
  if (sz_w) *sz_w = 912;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 912*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 199;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 199*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 565;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 565*sizeof(casadi_real);
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
  casadi_real a108, a109, a110, a111, a112, a113, a114;
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
  a016=(a012-a014);
  a016=(a007*a016);
  a009=(a009+a016);
  a009=(a009+a012);
  a016=(2.*a007);
  a017=1.;
  a018=(a017-a013);
  a018=(a016*a018);
  a018=(a018+a017);
  a019=(a009/a018);
  a013=(a013-a017);
  a013=(a007*a013);
  a020=(a013/a018);
  a021=casadi_sq(a003);
  a021=(a021*a011);
  a021=(a021+a014);
  a021=(a007*a021);
  a014=arg[4]? arg[4][5] : 0;
  a011=arg[4]? arg[4][7] : 0;
  a022=arg[4]? arg[4][2] : 0;
  a022=(a011*a022);
  a023=arg[1]? arg[1][1] : 0;
  a024=(a022*a023);
  a024=(a008+a024);
  a024=(a014*a024);
  a025=arg[4]? arg[4][4] : 0;
  a026=arg[4]? arg[4][6] : 0;
  a027=arg[1]? arg[1][0] : 0;
  a028=(a027+a017);
  a028=(a011*a028);
  a028=(a026-a028);
  a028=(a028+a010);
  a028=(a025*a028);
  a024=(a024+a028);
  a021=(a021-a024);
  a028=(a020*a009);
  a021=(a021-a028);
  a028=(a013*a020);
  a028=(a007-a028);
  a029=(a021/a028);
  a030=arg[4]? arg[4][1] : 0;
  a015=(a030*a015);
  a018=(a015/a018);
  a013=(a013*a018);
  a028=(a013/a028);
  a009=(a018*a009);
  a031=(a030*a003);
  a031=(a031*a003);
  a031=(a031*a012);
  a012=arg[4]? arg[4][0] : 0;
  a032=arg[0]? arg[0][2] : 0;
  a033=(a012*a032);
  a031=(a031+a033);
  a009=(a009-a031);
  a021=(a028*a021);
  a009=(a009-a021);
  a015=(a015*a018);
  a015=(a030-a015);
  a013=(a013*a028);
  a015=(a015-a013);
  a009=(a009/a015);
  a028=(a028*a009);
  a029=(a029-a028);
  a020=(a020*a029);
  a019=(a019-a020);
  a018=(a018*a009);
  a019=(a019+a018);
  a018=(a006*a019);
  a020=1.7082860872947386e-01;
  a020=(a020*a002);
  a028=2.9587585476806851e-02;
  a028=(a028*a002);
  a015=(a028*a029);
  a013=8.8762756430420545e-02;
  a013=(a013*a002);
  a021=1.9725056984537900e-02;
  a021=(a021*a002);
  a031=(a021*a019);
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
  a039=(a034*a019);
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
  a044=(a041-a043);
  a044=(a007*a044);
  a036=(a036+a044);
  a036=(a036+a041);
  a044=(a017-a042);
  a044=(a016*a044);
  a044=(a044+a017);
  a045=(a036/a044);
  a042=(a042-a017);
  a042=(a007*a042);
  a046=(a042/a044);
  a047=casadi_sq(a039);
  a047=(a047*a038);
  a047=(a047+a043);
  a047=(a007*a047);
  a043=arg[2]? arg[2][2] : 0;
  a038=(a023*a043);
  a048=arg[2]? arg[2][3] : 0;
  a049=(a027*a048);
  a038=(a038+a049);
  a038=(a022*a038);
  a038=(a035+a038);
  a038=(a014*a038);
  a043=(a027*a043);
  a048=(a023*a048);
  a043=(a043-a048);
  a043=(a043+a017);
  a043=(a011*a043);
  a043=(a026-a043);
  a043=(a043+a037);
  a043=(a025*a043);
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
  a044=(a021*a008);
  a035=(a033*a035);
  a044=(a044+a035);
  a044=(a010+a044);
  a035=sin(a044);
  a045=(a045*a035);
  a046=(a021*a003);
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
  a042=(a021*a029);
  a043=(a033*a043);
  a042=(a042+a043);
  a042=(a008+a042);
  a043=arg[2]? arg[2][4] : 0;
  a047=(a023*a043);
  a037=arg[2]? arg[2][5] : 0;
  a048=(a027*a037);
  a047=(a047+a048);
  a047=(a022*a047);
  a047=(a042+a047);
  a047=(a014*a047);
  a043=(a027*a043);
  a037=(a023*a037);
  a043=(a043-a037);
  a043=(a043+a017);
  a043=(a011*a043);
  a043=(a026-a043);
  a043=(a043+a044);
  a043=(a025*a043);
  a047=(a047+a043);
  a045=(a045-a047);
  a047=(a038-a017);
  a047=(a007*a047);
  a038=(a017-a038);
  a038=(a016*a038);
  a038=(a038+a017);
  a043=(a047/a038);
  a044=(a007*a042);
  a044=(a044*a035);
  a035=(2.*a031);
  a035=(a042-a035);
  a044=(a044*a035);
  a040=(a039-a040);
  a040=(a007*a040);
  a044=(a044+a040);
  a044=(a044+a039);
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
  a039=(a021*a041);
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
  a046=(a028*a008);
  a047=(a013*a042);
  a046=(a046+a047);
  a046=(a010+a046);
  a047=sin(a046);
  a040=(a040*a047);
  a045=(a028*a019);
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
  a037=(a028*a003);
  a043=(a013*a031);
  a037=(a037+a043);
  a037=(a000+a037);
  a043=sin(a037);
  a038=cos(a046);
  a049=(a043*a038);
  a037=cos(a037);
  a039=(a037*a047);
  a049=(a049-a039);
  a039=(a043-a049);
  a039=(a007*a039);
  a040=(a040+a039);
  a040=(a040+a043);
  a039=(a017-a038);
  a039=(a016*a039);
  a039=(a039+a017);
  a034=(a040/a039);
  a038=(a038-a017);
  a038=(a007*a038);
  a050=(a038/a039);
  a051=casadi_sq(a045);
  a051=(a051*a047);
  a051=(a051+a049);
  a051=(a007*a051);
  a049=arg[2]? arg[2][6] : 0;
  a047=(a023*a049);
  a052=arg[2]? arg[2][7] : 0;
  a053=(a027*a052);
  a047=(a047+a053);
  a047=(a022*a047);
  a047=(a015+a047);
  a047=(a014*a047);
  a049=(a027*a049);
  a052=(a023*a052);
  a049=(a049-a052);
  a049=(a049+a017);
  a049=(a011*a049);
  a049=(a026-a049);
  a049=(a049+a046);
  a049=(a025*a049);
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
  a043=(a028*a041);
  a021=(a021*a009);
  a033=(a033*a036);
  a021=(a021+a033);
  a021=(a041+a021);
  a033=(a013*a021);
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
  a039=(a020*a034);
  a018=(a018+a039);
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
  a046=(a050*a019);
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
  a036=(a031-a033);
  a036=(a007*a036);
  a038=(a038+a036);
  a038=(a038+a031);
  a036=(a017-a043);
  a036=(a016*a036);
  a036=(a036+a017);
  a052=(a038/a036);
  a043=(a043-a017);
  a043=(a007*a043);
  a053=(a043/a036);
  a054=casadi_sq(a046);
  a054=(a054*a042);
  a054=(a054+a033);
  a054=(a007*a054);
  a033=arg[2]? arg[2][8] : 0;
  a042=(a023*a033);
  a055=arg[2]? arg[2][9] : 0;
  a056=(a027*a055);
  a042=(a042+a056);
  a042=(a022*a042);
  a042=(a047+a042);
  a042=(a014*a042);
  a033=(a027*a033);
  a055=(a023*a055);
  a033=(a033-a055);
  a033=(a033+a017);
  a033=(a011*a033);
  a033=(a026-a033);
  a033=(a033+a051);
  a033=(a025*a033);
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
  a021=(a037*a021);
  a031=(a031+a021);
  a028=(a028*a009);
  a013=(a013*a048);
  a028=(a028+a013);
  a028=(a041+a028);
  a013=(a035*a028);
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
  a018=(a018+a036);
  a018=(a003+a018);
  a036=(a005*a018);
  a004=(a004+a036);
  a036=1.8915178993145003e+00;
  a036=(a036*a002);
  a053=3.7109375000000000e-02;
  a053=(a053*a002);
  a042=(a053*a019);
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
  a031=(a020*a049);
  a051=(a051+a031);
  a031=(a039*a033);
  a051=(a051+a031);
  a051=(a008+a051);
  a031=(a007*a051);
  a013=(a006*a008);
  a021=(a020*a015);
  a013=(a013+a021);
  a021=(a039*a047);
  a013=(a013+a021);
  a013=(a010+a013);
  a021=sin(a013);
  a031=(a031*a021);
  a055=(2.*a018);
  a055=(a051-a055);
  a031=(a031*a055);
  a055=(a006*a003);
  a056=(a020*a045);
  a055=(a055+a056);
  a056=(a039*a046);
  a055=(a055+a056);
  a055=(a000+a055);
  a056=sin(a055);
  a057=cos(a013);
  a058=(a056*a057);
  a055=cos(a055);
  a059=(a055*a021);
  a058=(a058-a059);
  a059=(a056-a058);
  a059=(a007*a059);
  a031=(a031+a059);
  a031=(a031+a056);
  a059=(a017-a057);
  a059=(a016*a059);
  a059=(a059+a017);
  a060=(a031/a059);
  a057=(a057-a017);
  a057=(a007*a057);
  a061=(a057/a059);
  a062=casadi_sq(a018);
  a062=(a062*a021);
  a062=(a062+a058);
  a062=(a007*a062);
  a058=arg[2]? arg[2][10] : 0;
  a021=(a023*a058);
  a063=arg[2]? arg[2][11] : 0;
  a064=(a027*a063);
  a021=(a021+a064);
  a021=(a022*a021);
  a021=(a051+a021);
  a021=(a014*a021);
  a058=(a027*a058);
  a063=(a023*a063);
  a058=(a058-a063);
  a058=(a058+a017);
  a058=(a011*a058);
  a058=(a026-a058);
  a058=(a058+a013);
  a058=(a025*a058);
  a021=(a021+a058);
  a062=(a062-a021);
  a058=(a061*a031);
  a062=(a062-a058);
  a058=(a057*a061);
  a058=(a007-a058);
  a013=(a062/a058);
  a055=(a030*a055);
  a059=(a055/a059);
  a057=(a057*a059);
  a058=(a057/a058);
  a031=(a059*a031);
  a063=(a030*a018);
  a063=(a063*a018);
  a063=(a063*a056);
  a056=(a006*a041);
  a064=(a020*a028);
  a056=(a056+a064);
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
  a063=(a063+a056);
  a031=(a031-a063);
  a062=(a058*a062);
  a031=(a031-a062);
  a055=(a055*a059);
  a055=(a030-a055);
  a057=(a057*a058);
  a055=(a055-a057);
  a031=(a031/a055);
  a058=(a058*a031);
  a013=(a013-a058);
  a061=(a061*a013);
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
  a058=(a061*a019);
  a055=1.7038392571223998e-01;
  a055=(a055*a002);
  a057=(a055*a034);
  a058=(a058+a057);
  a057=1.0726203044637328e-01;
  a057=(a057*a002);
  a062=(a057*a052);
  a058=(a058+a062);
  a062=-1.5319437748624402e-02;
  a062=(a062*a002);
  a063=(a062*a060);
  a058=(a058+a063);
  a063=8.2737891638140233e-03;
  a063=(a063*a002);
  a056=(a053*a029);
  a035=(a044*a049);
  a056=(a056+a035);
  a035=(a043*a033);
  a056=(a056+a035);
  a035=(a054*a013);
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
  a064=(2.*a042);
  a064=(a056-a064);
  a035=(a035*a064);
  a064=(a053*a003);
  a065=(a044*a045);
  a064=(a064+a065);
  a065=(a043*a046);
  a064=(a064+a065);
  a065=(a054*a018);
  a064=(a064+a065);
  a064=(a000+a064);
  a065=sin(a064);
  a066=cos(a037);
  a067=(a065*a066);
  a064=cos(a064);
  a068=(a064*a048);
  a067=(a067-a068);
  a068=(a065-a067);
  a068=(a007*a068);
  a035=(a035+a068);
  a035=(a035+a065);
  a068=(a017-a066);
  a068=(a016*a068);
  a068=(a068+a017);
  a069=(a035/a068);
  a066=(a066-a017);
  a066=(a007*a066);
  a070=(a066/a068);
  a071=casadi_sq(a042);
  a071=(a071*a048);
  a071=(a071+a067);
  a071=(a007*a071);
  a067=arg[2]? arg[2][12] : 0;
  a048=(a023*a067);
  a072=arg[2]? arg[2][13] : 0;
  a073=(a027*a072);
  a048=(a048+a073);
  a048=(a022*a048);
  a048=(a056+a048);
  a048=(a014*a048);
  a067=(a027*a067);
  a072=(a023*a072);
  a067=(a067-a072);
  a067=(a067+a017);
  a067=(a011*a067);
  a067=(a026-a067);
  a067=(a067+a037);
  a067=(a025*a067);
  a048=(a048+a067);
  a071=(a071-a048);
  a067=(a070*a035);
  a071=(a071-a067);
  a067=(a066*a070);
  a067=(a007-a067);
  a037=(a071/a067);
  a064=(a030*a064);
  a068=(a064/a068);
  a066=(a066*a068);
  a067=(a066/a067);
  a035=(a068*a035);
  a072=(a030*a042);
  a072=(a072*a042);
  a072=(a072*a065);
  a065=(a053*a041);
  a073=(a044*a028);
  a065=(a065+a073);
  a073=(a043*a050);
  a065=(a065+a073);
  a006=(a006*a009);
  a020=(a020*a040);
  a006=(a006+a020);
  a039=(a039*a038);
  a006=(a006+a039);
  a006=(a041+a006);
  a039=(a054*a006);
  a065=(a065+a039);
  a065=(a032+a065);
  a065=(a012*a065);
  a072=(a072+a065);
  a035=(a035-a072);
  a071=(a067*a071);
  a035=(a035-a071);
  a064=(a064*a068);
  a064=(a030-a064);
  a066=(a066*a067);
  a064=(a064-a066);
  a035=(a035/a064);
  a067=(a067*a035);
  a037=(a037-a067);
  a070=(a070*a037);
  a069=(a069-a070);
  a068=(a068*a035);
  a069=(a069+a068);
  a068=(a063*a069);
  a058=(a058+a068);
  a058=(a003+a058);
  a068=(a059*a058);
  a004=(a004+a068);
  a068=3.1116436695781990e-01;
  a068=(a068*a002);
  a070=6.2411095871607569e-01;
  a070=(a070*a002);
  a067=(a070*a019);
  a064=-3.3608926294469414e+00;
  a064=(a064*a002);
  a066=(a064*a034);
  a067=(a067+a066);
  a066=-8.6821934684172597e-01;
  a066=(a066*a002);
  a071=(a066*a052);
  a067=(a067+a071);
  a071=2.7592099699446710e+01;
  a071=(a071*a002);
  a072=(a071*a060);
  a067=(a067+a072);
  a072=2.0154067550477894e+01;
  a072=(a072*a002);
  a065=(a072*a069);
  a067=(a067+a065);
  a065=-4.3489884181069961e+01;
  a065=(a065*a002);
  a039=(a061*a029);
  a020=(a055*a049);
  a039=(a039+a020);
  a020=(a057*a033);
  a039=(a039+a020);
  a020=(a062*a013);
  a039=(a039+a020);
  a020=(a063*a037);
  a039=(a039+a020);
  a039=(a008+a039);
  a020=(a007*a039);
  a073=(a061*a008);
  a074=(a055*a015);
  a073=(a073+a074);
  a074=(a057*a047);
  a073=(a073+a074);
  a074=(a062*a051);
  a073=(a073+a074);
  a074=(a063*a056);
  a073=(a073+a074);
  a073=(a010+a073);
  a074=sin(a073);
  a020=(a020*a074);
  a075=(2.*a058);
  a075=(a039-a075);
  a020=(a020*a075);
  a075=(a061*a003);
  a076=(a055*a045);
  a075=(a075+a076);
  a076=(a057*a046);
  a075=(a075+a076);
  a076=(a062*a018);
  a075=(a075+a076);
  a076=(a063*a042);
  a075=(a075+a076);
  a075=(a000+a075);
  a076=sin(a075);
  a077=cos(a073);
  a078=(a076*a077);
  a075=cos(a075);
  a079=(a075*a074);
  a078=(a078-a079);
  a079=(a076-a078);
  a079=(a007*a079);
  a020=(a020+a079);
  a020=(a020+a076);
  a079=(a017-a077);
  a079=(a016*a079);
  a079=(a079+a017);
  a080=(a020/a079);
  a077=(a077-a017);
  a077=(a007*a077);
  a081=(a077/a079);
  a082=casadi_sq(a058);
  a082=(a082*a074);
  a082=(a082+a078);
  a082=(a007*a082);
  a078=arg[2]? arg[2][14] : 0;
  a074=(a023*a078);
  a083=arg[2]? arg[2][15] : 0;
  a084=(a027*a083);
  a074=(a074+a084);
  a074=(a022*a074);
  a074=(a039+a074);
  a074=(a014*a074);
  a078=(a027*a078);
  a083=(a023*a083);
  a078=(a078-a083);
  a078=(a078+a017);
  a078=(a011*a078);
  a078=(a026-a078);
  a078=(a078+a073);
  a078=(a025*a078);
  a074=(a074+a078);
  a082=(a082-a074);
  a078=(a081*a020);
  a082=(a082-a078);
  a078=(a077*a081);
  a078=(a007-a078);
  a073=(a082/a078);
  a075=(a030*a075);
  a079=(a075/a079);
  a077=(a077*a079);
  a078=(a077/a078);
  a020=(a079*a020);
  a083=(a030*a058);
  a083=(a083*a058);
  a083=(a083*a076);
  a076=(a061*a041);
  a084=(a055*a028);
  a076=(a076+a084);
  a084=(a057*a050);
  a076=(a076+a084);
  a084=(a062*a006);
  a076=(a076+a084);
  a053=(a053*a009);
  a044=(a044*a040);
  a053=(a053+a044);
  a043=(a043*a038);
  a053=(a053+a043);
  a054=(a054*a031);
  a053=(a053+a054);
  a053=(a041+a053);
  a054=(a063*a053);
  a076=(a076+a054);
  a076=(a032+a076);
  a076=(a012*a076);
  a083=(a083+a076);
  a020=(a020-a083);
  a082=(a078*a082);
  a020=(a020-a082);
  a075=(a075*a079);
  a075=(a030-a075);
  a077=(a077*a078);
  a075=(a075-a077);
  a020=(a020/a075);
  a078=(a078*a020);
  a073=(a073-a078);
  a081=(a081*a073);
  a080=(a080-a081);
  a079=(a079*a020);
  a080=(a080+a079);
  a079=(a065*a080);
  a067=(a067+a079);
  a067=(a003+a067);
  a079=(a068*a067);
  a004=(a004+a079);
  a079=-1.5216094966251609e-01;
  a079=(a079*a002);
  a081=4.7766253643826434e-01;
  a081=(a081*a002);
  a078=(a081*a019);
  a075=-2.4881146199716677e+00;
  a075=(a075*a002);
  a077=(a075*a034);
  a078=(a078+a077);
  a077=-5.9029082683684297e-01;
  a077=(a077*a002);
  a082=(a077*a052);
  a078=(a078+a082);
  a082=2.1230051448181193e+01;
  a082=(a082*a002);
  a083=(a082*a060);
  a078=(a078+a083);
  a083=1.5279233632882423e+01;
  a083=(a083*a002);
  a076=(a083*a069);
  a078=(a078+a076);
  a076=-3.3288210968984863e+01;
  a076=(a076*a002);
  a054=(a076*a080);
  a078=(a078+a054);
  a054=-2.0331201708508627e-02;
  a054=(a054*a002);
  a043=(a070*a029);
  a044=(a064*a049);
  a043=(a043+a044);
  a044=(a066*a033);
  a043=(a043+a044);
  a044=(a071*a013);
  a043=(a043+a044);
  a044=(a072*a037);
  a043=(a043+a044);
  a044=(a065*a073);
  a043=(a043+a044);
  a043=(a008+a043);
  a044=(a007*a043);
  a084=(a070*a008);
  a085=(a064*a015);
  a084=(a084+a085);
  a085=(a066*a047);
  a084=(a084+a085);
  a085=(a071*a051);
  a084=(a084+a085);
  a085=(a072*a056);
  a084=(a084+a085);
  a085=(a065*a039);
  a084=(a084+a085);
  a084=(a010+a084);
  a085=sin(a084);
  a044=(a044*a085);
  a086=(2.*a067);
  a086=(a043-a086);
  a044=(a044*a086);
  a086=(a070*a003);
  a087=(a064*a045);
  a086=(a086+a087);
  a087=(a066*a046);
  a086=(a086+a087);
  a087=(a071*a018);
  a086=(a086+a087);
  a087=(a072*a042);
  a086=(a086+a087);
  a087=(a065*a058);
  a086=(a086+a087);
  a086=(a000+a086);
  a087=sin(a086);
  a088=cos(a084);
  a089=(a087*a088);
  a086=cos(a086);
  a090=(a086*a085);
  a089=(a089-a090);
  a090=(a087-a089);
  a090=(a007*a090);
  a044=(a044+a090);
  a044=(a044+a087);
  a090=(a017-a088);
  a090=(a016*a090);
  a090=(a090+a017);
  a091=(a044/a090);
  a088=(a088-a017);
  a088=(a007*a088);
  a092=(a088/a090);
  a093=casadi_sq(a067);
  a093=(a093*a085);
  a093=(a093+a089);
  a093=(a007*a093);
  a089=arg[2]? arg[2][16] : 0;
  a085=(a023*a089);
  a094=arg[2]? arg[2][17] : 0;
  a095=(a027*a094);
  a085=(a085+a095);
  a085=(a022*a085);
  a085=(a043+a085);
  a085=(a014*a085);
  a089=(a027*a089);
  a094=(a023*a094);
  a089=(a089-a094);
  a089=(a089+a017);
  a089=(a011*a089);
  a089=(a026-a089);
  a089=(a089+a084);
  a089=(a025*a089);
  a085=(a085+a089);
  a093=(a093-a085);
  a089=(a092*a044);
  a093=(a093-a089);
  a089=(a088*a092);
  a089=(a007-a089);
  a084=(a093/a089);
  a086=(a030*a086);
  a090=(a086/a090);
  a088=(a088*a090);
  a089=(a088/a089);
  a044=(a090*a044);
  a094=(a030*a067);
  a094=(a094*a067);
  a094=(a094*a087);
  a087=(a070*a041);
  a095=(a064*a028);
  a087=(a087+a095);
  a095=(a066*a050);
  a087=(a087+a095);
  a095=(a071*a006);
  a087=(a087+a095);
  a095=(a072*a053);
  a087=(a087+a095);
  a061=(a061*a009);
  a055=(a055*a040);
  a061=(a061+a055);
  a057=(a057*a038);
  a061=(a061+a057);
  a062=(a062*a031);
  a061=(a061+a062);
  a063=(a063*a035);
  a061=(a061+a063);
  a061=(a041+a061);
  a063=(a065*a061);
  a087=(a087+a063);
  a087=(a032+a087);
  a087=(a012*a087);
  a094=(a094+a087);
  a044=(a044-a094);
  a093=(a089*a093);
  a044=(a044-a093);
  a086=(a086*a090);
  a086=(a030-a086);
  a088=(a088*a089);
  a086=(a086-a088);
  a044=(a044/a086);
  a089=(a089*a044);
  a084=(a084-a089);
  a092=(a092*a084);
  a091=(a091-a092);
  a090=(a090*a044);
  a091=(a091+a090);
  a090=(a054*a091);
  a078=(a078+a090);
  a078=(a003+a078);
  a090=(a079*a078);
  a004=(a004+a090);
  a090=2.0136540080403034e-01;
  a090=(a090*a002);
  a092=-9.3714243008598730e-01;
  a092=(a092*a002);
  a089=(a092*a019);
  a086=5.1863724288440638e+00;
  a086=(a086*a002);
  a088=(a086*a034);
  a089=(a089+a088);
  a088=1.0914373489967295e+00;
  a088=(a088*a002);
  a093=(a088*a052);
  a089=(a089+a093);
  a093=-8.1497870107469268e+00;
  a093=(a093*a002);
  a094=(a093*a060);
  a089=(a089+a094);
  a094=-1.8520065659996959e+01;
  a094=(a094*a002);
  a087=(a094*a069);
  a089=(a089+a087);
  a087=2.2739487099350505e+01;
  a087=(a087*a002);
  a063=(a087*a080);
  a089=(a089+a063);
  a063=2.4936055526796523e+00;
  a063=(a063*a002);
  a062=(a063*a091);
  a089=(a089+a062);
  a062=-3.0467644718982196e+00;
  a062=(a062*a002);
  a057=(a081*a029);
  a055=(a075*a049);
  a057=(a057+a055);
  a055=(a077*a033);
  a057=(a057+a055);
  a055=(a082*a013);
  a057=(a057+a055);
  a055=(a083*a037);
  a057=(a057+a055);
  a055=(a076*a073);
  a057=(a057+a055);
  a055=(a054*a084);
  a057=(a057+a055);
  a057=(a008+a057);
  a055=(a007*a057);
  a095=(a081*a008);
  a096=(a075*a015);
  a095=(a095+a096);
  a096=(a077*a047);
  a095=(a095+a096);
  a096=(a082*a051);
  a095=(a095+a096);
  a096=(a083*a056);
  a095=(a095+a096);
  a096=(a076*a039);
  a095=(a095+a096);
  a096=(a054*a043);
  a095=(a095+a096);
  a095=(a010+a095);
  a096=sin(a095);
  a055=(a055*a096);
  a097=(2.*a078);
  a097=(a057-a097);
  a055=(a055*a097);
  a097=(a081*a003);
  a098=(a075*a045);
  a097=(a097+a098);
  a098=(a077*a046);
  a097=(a097+a098);
  a098=(a082*a018);
  a097=(a097+a098);
  a098=(a083*a042);
  a097=(a097+a098);
  a098=(a076*a058);
  a097=(a097+a098);
  a098=(a054*a067);
  a097=(a097+a098);
  a097=(a000+a097);
  a098=sin(a097);
  a099=cos(a095);
  a100=(a098*a099);
  a097=cos(a097);
  a101=(a097*a096);
  a100=(a100-a101);
  a101=(a098-a100);
  a101=(a007*a101);
  a055=(a055+a101);
  a055=(a055+a098);
  a101=(a017-a099);
  a101=(a016*a101);
  a101=(a101+a017);
  a102=(a055/a101);
  a099=(a099-a017);
  a099=(a007*a099);
  a103=(a099/a101);
  a104=casadi_sq(a078);
  a104=(a104*a096);
  a104=(a104+a100);
  a104=(a007*a104);
  a100=arg[2]? arg[2][18] : 0;
  a096=(a023*a100);
  a105=arg[2]? arg[2][19] : 0;
  a106=(a027*a105);
  a096=(a096+a106);
  a096=(a022*a096);
  a096=(a057+a096);
  a096=(a014*a096);
  a100=(a027*a100);
  a105=(a023*a105);
  a100=(a100-a105);
  a100=(a100+a017);
  a100=(a011*a100);
  a100=(a026-a100);
  a100=(a100+a095);
  a100=(a025*a100);
  a096=(a096+a100);
  a104=(a104-a096);
  a100=(a103*a055);
  a104=(a104-a100);
  a100=(a099*a103);
  a100=(a007-a100);
  a095=(a104/a100);
  a097=(a030*a097);
  a101=(a097/a101);
  a099=(a099*a101);
  a100=(a099/a100);
  a055=(a101*a055);
  a105=(a030*a078);
  a105=(a105*a078);
  a105=(a105*a098);
  a098=(a081*a041);
  a106=(a075*a028);
  a098=(a098+a106);
  a106=(a077*a050);
  a098=(a098+a106);
  a106=(a082*a006);
  a098=(a098+a106);
  a106=(a083*a053);
  a098=(a098+a106);
  a106=(a076*a061);
  a098=(a098+a106);
  a070=(a070*a009);
  a064=(a064*a040);
  a070=(a070+a064);
  a066=(a066*a038);
  a070=(a070+a066);
  a071=(a071*a031);
  a070=(a070+a071);
  a072=(a072*a035);
  a070=(a070+a072);
  a065=(a065*a020);
  a070=(a070+a065);
  a070=(a041+a070);
  a065=(a054*a070);
  a098=(a098+a065);
  a098=(a032+a098);
  a098=(a012*a098);
  a105=(a105+a098);
  a055=(a055-a105);
  a104=(a100*a104);
  a055=(a055-a104);
  a097=(a097*a101);
  a097=(a030-a097);
  a099=(a099*a100);
  a097=(a097-a099);
  a055=(a055/a097);
  a100=(a100*a055);
  a095=(a095-a100);
  a103=(a103*a095);
  a102=(a102-a103);
  a101=(a101*a055);
  a102=(a102+a101);
  a101=(a062*a102);
  a089=(a089+a101);
  a089=(a003+a089);
  a101=(a090*a089);
  a004=(a004+a101);
  a101=4.4710615727772587e-02;
  a101=(a101*a002);
  a103=2.2733101475165380e+00;
  a103=(a103*a002);
  a100=(a103*a019);
  a097=-1.0534495466737249e+01;
  a097=(a097*a002);
  a034=(a097*a034);
  a100=(a100+a034);
  a034=-2.0008720582248625e+00;
  a034=(a034*a002);
  a052=(a034*a052);
  a100=(a100+a052);
  a052=-1.7958931863118799e+01;
  a052=(a052*a002);
  a099=(a052*a060);
  a100=(a100+a099);
  a099=2.7948884529419960e+01;
  a099=(a099*a002);
  a104=(a099*a069);
  a100=(a100+a104);
  a104=-2.8589982771350235e+00;
  a104=(a104*a002);
  a105=(a104*a080);
  a100=(a100+a105);
  a105=-8.8728569335306293e+00;
  a105=(a105*a002);
  a098=(a105*a091);
  a100=(a100+a098);
  a098=1.2360567175794303e+01;
  a098=(a098*a002);
  a065=(a098*a102);
  a100=(a100+a065);
  a065=6.4339274601576357e-01;
  a065=(a065*a002);
  a002=(a092*a029);
  a072=(a086*a049);
  a002=(a002+a072);
  a072=(a088*a033);
  a002=(a002+a072);
  a072=(a093*a013);
  a002=(a002+a072);
  a072=(a094*a037);
  a002=(a002+a072);
  a072=(a087*a073);
  a002=(a002+a072);
  a072=(a063*a084);
  a002=(a002+a072);
  a072=(a062*a095);
  a002=(a002+a072);
  a002=(a008+a002);
  a072=(a007*a002);
  a071=(a092*a008);
  a066=(a086*a015);
  a071=(a071+a066);
  a066=(a088*a047);
  a071=(a071+a066);
  a066=(a093*a051);
  a071=(a071+a066);
  a066=(a094*a056);
  a071=(a071+a066);
  a066=(a087*a039);
  a071=(a071+a066);
  a066=(a063*a043);
  a071=(a071+a066);
  a066=(a062*a057);
  a071=(a071+a066);
  a071=(a010+a071);
  a066=sin(a071);
  a072=(a072*a066);
  a064=(2.*a089);
  a064=(a002-a064);
  a072=(a072*a064);
  a064=(a092*a003);
  a106=(a086*a045);
  a064=(a064+a106);
  a106=(a088*a046);
  a064=(a064+a106);
  a106=(a093*a018);
  a064=(a064+a106);
  a106=(a094*a042);
  a064=(a064+a106);
  a106=(a087*a058);
  a064=(a064+a106);
  a106=(a063*a067);
  a064=(a064+a106);
  a106=(a062*a078);
  a064=(a064+a106);
  a064=(a000+a064);
  a106=sin(a064);
  a107=cos(a071);
  a108=(a106*a107);
  a064=cos(a064);
  a109=(a064*a066);
  a108=(a108-a109);
  a109=(a106-a108);
  a109=(a007*a109);
  a072=(a072+a109);
  a072=(a072+a106);
  a109=(a017-a107);
  a109=(a016*a109);
  a109=(a109+a017);
  a110=(a072/a109);
  a107=(a107-a017);
  a107=(a007*a107);
  a111=(a107/a109);
  a112=casadi_sq(a089);
  a112=(a112*a066);
  a112=(a112+a108);
  a112=(a007*a112);
  a108=arg[2]? arg[2][20] : 0;
  a066=(a023*a108);
  a113=arg[2]? arg[2][21] : 0;
  a114=(a027*a113);
  a066=(a066+a114);
  a066=(a022*a066);
  a066=(a002+a066);
  a066=(a014*a066);
  a108=(a027*a108);
  a113=(a023*a113);
  a108=(a108-a113);
  a108=(a108+a017);
  a108=(a011*a108);
  a108=(a026-a108);
  a108=(a108+a071);
  a108=(a025*a108);
  a066=(a066+a108);
  a112=(a112-a066);
  a108=(a111*a072);
  a112=(a112-a108);
  a108=(a107*a111);
  a108=(a007-a108);
  a071=(a112/a108);
  a064=(a030*a064);
  a109=(a064/a109);
  a107=(a107*a109);
  a108=(a107/a108);
  a072=(a109*a072);
  a113=(a030*a089);
  a113=(a113*a089);
  a113=(a113*a106);
  a106=(a092*a041);
  a114=(a086*a028);
  a106=(a106+a114);
  a114=(a088*a050);
  a106=(a106+a114);
  a114=(a093*a006);
  a106=(a106+a114);
  a114=(a094*a053);
  a106=(a106+a114);
  a114=(a087*a061);
  a106=(a106+a114);
  a114=(a063*a070);
  a106=(a106+a114);
  a081=(a081*a009);
  a075=(a075*a040);
  a081=(a081+a075);
  a077=(a077*a038);
  a081=(a081+a077);
  a082=(a082*a031);
  a081=(a081+a082);
  a083=(a083*a035);
  a081=(a081+a083);
  a076=(a076*a020);
  a081=(a081+a076);
  a054=(a054*a044);
  a081=(a081+a054);
  a081=(a041+a081);
  a054=(a062*a081);
  a106=(a106+a054);
  a106=(a032+a106);
  a106=(a012*a106);
  a113=(a113+a106);
  a072=(a072-a113);
  a112=(a108*a112);
  a072=(a072-a112);
  a064=(a064*a109);
  a064=(a030-a064);
  a107=(a107*a108);
  a064=(a064-a107);
  a072=(a072/a064);
  a108=(a108*a072);
  a071=(a071-a108);
  a111=(a111*a071);
  a110=(a110-a111);
  a109=(a109*a072);
  a110=(a110+a109);
  a109=(a065*a110);
  a100=(a100+a109);
  a100=(a003+a100);
  a109=(a101*a100);
  a004=(a004+a109);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a109=(a005*a051);
  a004=(a004+a109);
  a109=(a036*a056);
  a004=(a004+a109);
  a109=(a059*a039);
  a004=(a004+a109);
  a109=(a068*a043);
  a004=(a004+a109);
  a109=(a079*a057);
  a004=(a004+a109);
  a109=(a090*a002);
  a004=(a004+a109);
  a109=(a103*a029);
  a049=(a097*a049);
  a109=(a109+a049);
  a033=(a034*a033);
  a109=(a109+a033);
  a033=(a052*a013);
  a109=(a109+a033);
  a033=(a099*a037);
  a109=(a109+a033);
  a033=(a104*a073);
  a109=(a109+a033);
  a033=(a105*a084);
  a109=(a109+a033);
  a033=(a098*a095);
  a109=(a109+a033);
  a033=(a065*a071);
  a109=(a109+a033);
  a109=(a008+a109);
  a033=(a101*a109);
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
  a033=(a068*a070);
  a004=(a004+a033);
  a033=(a079*a081);
  a004=(a004+a033);
  a092=(a092*a009);
  a086=(a086*a040);
  a092=(a092+a086);
  a088=(a088*a038);
  a092=(a092+a088);
  a093=(a093*a031);
  a092=(a092+a093);
  a094=(a094*a035);
  a092=(a092+a094);
  a087=(a087*a020);
  a092=(a092+a087);
  a063=(a063*a044);
  a092=(a092+a063);
  a062=(a062*a055);
  a092=(a092+a062);
  a092=(a041+a092);
  a062=(a090*a092);
  a004=(a004+a062);
  a062=(a103*a009);
  a040=(a097*a040);
  a062=(a062+a040);
  a038=(a034*a038);
  a062=(a062+a038);
  a038=(a052*a031);
  a062=(a062+a038);
  a038=(a099*a035);
  a062=(a062+a038);
  a038=(a104*a020);
  a062=(a062+a038);
  a038=(a105*a044);
  a062=(a062+a038);
  a038=(a098*a055);
  a062=(a062+a038);
  a038=(a065*a072);
  a062=(a062+a038);
  a062=(a041+a062);
  a062=(a101*a062);
  a004=(a004+a062);
  a004=(a032+a004);
  if (res[0]!=0) res[0][2]=a004;
  a019=(a001*a019);
  a060=(a005*a060);
  a019=(a019+a060);
  a069=(a036*a069);
  a019=(a019+a069);
  a080=(a059*a080);
  a019=(a019+a080);
  a091=(a068*a091);
  a019=(a019+a091);
  a102=(a079*a102);
  a019=(a019+a102);
  a110=(a090*a110);
  a019=(a019+a110);
  a110=(a007*a109);
  a102=(a103*a008);
  a015=(a097*a015);
  a102=(a102+a015);
  a047=(a034*a047);
  a102=(a102+a047);
  a047=(a052*a051);
  a102=(a102+a047);
  a047=(a099*a056);
  a102=(a102+a047);
  a047=(a104*a039);
  a102=(a102+a047);
  a047=(a105*a043);
  a102=(a102+a047);
  a047=(a098*a057);
  a102=(a102+a047);
  a047=(a065*a002);
  a102=(a102+a047);
  a010=(a010+a102);
  a102=sin(a010);
  a110=(a110*a102);
  a047=(2.*a100);
  a047=(a109-a047);
  a110=(a110*a047);
  a047=(a103*a003);
  a045=(a097*a045);
  a047=(a047+a045);
  a046=(a034*a046);
  a047=(a047+a046);
  a018=(a052*a018);
  a047=(a047+a018);
  a042=(a099*a042);
  a047=(a047+a042);
  a058=(a104*a058);
  a047=(a047+a058);
  a067=(a105*a067);
  a047=(a047+a067);
  a078=(a098*a078);
  a047=(a047+a078);
  a089=(a065*a089);
  a047=(a047+a089);
  a000=(a000+a047);
  a047=sin(a000);
  a089=cos(a010);
  a078=(a047*a089);
  a000=cos(a000);
  a067=(a000*a102);
  a078=(a078-a067);
  a067=(a047-a078);
  a067=(a007*a067);
  a110=(a110+a067);
  a110=(a110+a047);
  a067=(a017-a089);
  a016=(a016*a067);
  a016=(a016+a017);
  a067=(a110/a016);
  a089=(a089-a017);
  a089=(a007*a089);
  a058=(a089/a016);
  a042=casadi_sq(a100);
  a042=(a042*a102);
  a042=(a042+a078);
  a042=(a007*a042);
  a078=arg[2]? arg[2][22] : 0;
  a102=(a023*a078);
  a018=arg[2]? arg[2][23] : 0;
  a046=(a027*a018);
  a102=(a102+a046);
  a022=(a022*a102);
  a022=(a109+a022);
  a014=(a014*a022);
  a027=(a027*a078);
  a023=(a023*a018);
  a027=(a027-a023);
  a027=(a027+a017);
  a011=(a011*a027);
  a026=(a026-a011);
  a026=(a026+a010);
  a025=(a025*a026);
  a014=(a014+a025);
  a042=(a042-a014);
  a025=(a058*a110);
  a042=(a042-a025);
  a025=(a089*a058);
  a007=(a007-a025);
  a025=(a042/a007);
  a000=(a030*a000);
  a016=(a000/a016);
  a089=(a089*a016);
  a007=(a089/a007);
  a110=(a016*a110);
  a026=(a030*a100);
  a026=(a026*a100);
  a026=(a026*a047);
  a103=(a103*a041);
  a097=(a097*a028);
  a103=(a103+a097);
  a034=(a034*a050);
  a103=(a103+a034);
  a052=(a052*a006);
  a103=(a103+a052);
  a099=(a099*a053);
  a103=(a103+a099);
  a104=(a104*a061);
  a103=(a103+a104);
  a105=(a105*a070);
  a103=(a103+a105);
  a098=(a098*a081);
  a103=(a103+a098);
  a065=(a065*a092);
  a103=(a103+a065);
  a032=(a032+a103);
  a012=(a012*a032);
  a026=(a026+a012);
  a110=(a110-a026);
  a042=(a007*a042);
  a110=(a110-a042);
  a000=(a000*a016);
  a030=(a030-a000);
  a089=(a089*a007);
  a030=(a030-a089);
  a110=(a110/a030);
  a007=(a007*a110);
  a025=(a025-a007);
  a058=(a058*a025);
  a067=(a067-a058);
  a016=(a016*a110);
  a067=(a067+a016);
  a067=(a101*a067);
  a019=(a019+a067);
  a003=(a003+a019);
  if (res[0]!=0) res[0][3]=a003;
  a029=(a001*a029);
  a013=(a005*a013);
  a029=(a029+a013);
  a037=(a036*a037);
  a029=(a029+a037);
  a073=(a059*a073);
  a029=(a029+a073);
  a084=(a068*a084);
  a029=(a029+a084);
  a095=(a079*a095);
  a029=(a029+a095);
  a071=(a090*a071);
  a029=(a029+a071);
  a025=(a101*a025);
  a029=(a029+a025);
  a029=(a008+a029);
  if (res[0]!=0) res[0][4]=a029;
  a009=(a001*a009);
  a031=(a005*a031);
  a009=(a009+a031);
  a035=(a036*a035);
  a009=(a009+a035);
  a020=(a059*a020);
  a009=(a009+a020);
  a044=(a068*a044);
  a009=(a009+a044);
  a055=(a079*a055);
  a009=(a009+a055);
  a072=(a090*a072);
  a009=(a009+a072);
  a110=(a101*a110);
  a009=(a009+a110);
  a041=(a041+a009);
  if (res[0]!=0) res[0][5]=a041;
  a041=arg[0]? arg[0][6] : 0;
  a024=(a024*a008);
  a001=(a001*a024);
  a021=(a021*a051);
  a005=(a005*a021);
  a001=(a001+a005);
  a048=(a048*a056);
  a036=(a036*a048);
  a001=(a001+a036);
  a074=(a074*a039);
  a059=(a059*a074);
  a001=(a001+a059);
  a085=(a085*a043);
  a068=(a068*a085);
  a001=(a001+a068);
  a096=(a096*a057);
  a079=(a079*a096);
  a001=(a001+a079);
  a066=(a066*a002);
  a090=(a090*a066);
  a001=(a001+a090);
  a014=(a014*a109);
  a101=(a101*a014);
  a001=(a001+a101);
  a041=(a041-a001);
  if (res[0]!=0) res[0][6]=a041;
  return 0;
}

/* observe:(t,y[6],p[8])->(g[10],dg[10]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79;
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
  a09=(a09-a08);
  a02=(a02+a09);
  a10=(2.*a03);
  a11=1.;
  a12=(a10+a11);
  a02=(a02/a12);
  a13=cos(a04);
  a06=cos(a06);
  a14=(a13-a06);
  a15=(a03*a14);
  a15=(a15+a13);
  a15=(a15/a12);
  a16=arg[1]? arg[1][4] : 0;
  a17=(a03*a16);
  a18=sin(a05);
  a19=(a17*a18);
  a20=arg[1]? arg[1][3] : 0;
  a21=(2.*a20);
  a22=(a16-a21);
  a23=(a19*a22);
  a09=(a23-a09);
  a24=cos(a05);
  a25=(a11-a24);
  a25=(a10*a25);
  a25=(a25+a11);
  a26=(a09/a25);
  a27=(a24-a11);
  a27=(a03*a27);
  a28=(a27/a25);
  a29=casadi_sq(a20);
  a30=(a29*a18);
  a30=(a30+a07);
  a30=(a03*a30);
  a31=arg[2]? arg[2][5] : 0;
  a32=arg[2]? arg[2][7] : 0;
  a33=arg[2]? arg[2][2] : 0;
  a34=(a32*a33);
  a35=arg[0]? arg[0][0] : 0;
  a35=(a33*a35);
  a36=sin(a35);
  a37=(a34*a36);
  a37=(a16+a37);
  a37=(a31*a37);
  a38=arg[2]? arg[2][4] : 0;
  a39=arg[2]? arg[2][6] : 0;
  a35=cos(a35);
  a40=(a35+a11);
  a40=(a32*a40);
  a39=(a39-a40);
  a39=(a39+a05);
  a39=(a38*a39);
  a37=(a37+a39);
  a30=(a30-a37);
  a39=(a28*a09);
  a39=(a30-a39);
  a40=(a27*a28);
  a40=(a03-a40);
  a41=(a39/a40);
  a42=(a00*a13);
  a43=(a42/a25);
  a44=(a27*a43);
  a45=(a44/a40);
  a46=(a43*a09);
  a47=(a00*a20);
  a48=(a47*a20);
  a49=(a48*a08);
  a50=arg[2]? arg[2][0] : 0;
  a51=(a50*a01);
  a49=(a49+a51);
  a46=(a46-a49);
  a51=(a45*a39);
  a46=(a46-a51);
  a51=(a42*a43);
  a51=(a00-a51);
  a52=(a44*a45);
  a51=(a51-a52);
  a46=(a46/a51);
  a52=(a45*a46);
  a52=(a41-a52);
  a53=(a28*a52);
  a53=(a26-a53);
  a54=(a43*a46);
  a53=(a53+a54);
  a54=(a06-a13);
  a54=(a03*a54);
  a54=(a54-a13);
  a55=(a53*a54);
  a56=(a52*a03);
  a57=(a56*a06);
  a55=(a55-a57);
  a57=(a46*a00);
  a55=(a55+a57);
  a57=(a17*a16);
  a58=(a57*a07);
  a55=(a55-a58);
  a59=(a03*a07);
  a60=(a21*a16);
  a61=(a59*a60);
  a55=(a55+a61);
  a62=(a03*a08);
  a62=(a62-a59);
  a62=(a62+a08);
  a63=(a29*a62);
  a55=(a55+a63);
  a64=(a15*a55);
  a65=(a53*a07);
  a66=(a52*a07);
  a65=(a65-a66);
  a66=(a06*a20);
  a67=(a66*a20);
  a65=(a65+a67);
  a68=(a06*a16);
  a69=(a68*a16);
  a65=(a65+a69);
  a70=(a06*a60);
  a65=(a65-a70);
  a71=(a53*a08);
  a72=(a13*a20);
  a73=(a72*a20);
  a71=(a71+a73);
  a65=(a65-a71);
  a74=2.;
  a65=(a65+a74);
  a65=(a03*a65);
  a65=(a65-a71);
  a65=(a65+a11);
  a64=(a64/a65);
  a02=(a02-a64);
  a02=(-a02);
  if (res[0]!=0) res[0][0]=a02;
  a02=0.;
  if (res[0]!=0) res[0][1]=a02;
  a71=(a08-a07);
  a71=(a03*a71);
  a23=(a23+a71);
  a23=(a23+a08);
  a71=(a23/a25);
  a75=(a28*a23);
  a30=(a30-a75);
  a75=(a30/a40);
  a76=(a43*a23);
  a76=(a76-a49);
  a49=(a45*a30);
  a76=(a76-a49);
  a76=(a76/a51);
  a49=(a45*a76);
  a49=(a75-a49);
  a77=(a28*a49);
  a77=(a71-a77);
  a78=(a43*a76);
  a77=(a77+a78);
  a78=(a77*a07);
  a79=(a49*a07);
  a78=(a78-a79);
  a78=(a78+a67);
  a78=(a78+a69);
  a78=(a78-a70);
  a70=(a77*a08);
  a70=(a70+a73);
  a78=(a78-a70);
  a78=(a78+a74);
  a78=(a03*a78);
  a78=(a78-a70);
  a78=(a78+a11);
  if (res[0]!=0) res[0][2]=a78;
  a11=(a77*a54);
  a70=(a49*a03);
  a74=(a70*a06);
  a11=(a11-a74);
  a74=(a76*a00);
  a11=(a11+a74);
  a11=(a11-a58);
  a11=(a11+a61);
  a11=(a11+a63);
  a11=(a11/a78);
  if (res[0]!=0) res[0][3]=a11;
  if (res[0]!=0) res[0][4]=a14;
  if (res[0]!=0) res[0][5]=a77;
  a04=(2.*a04);
  a05=(a05-a04);
  if (res[0]!=0) res[0][6]=a05;
  if (res[0]!=0) res[0][7]=a01;
  a01=(a37*a16);
  a01=(-a01);
  if (res[0]!=0) res[0][8]=a01;
  a01=(-a37);
  if (res[0]!=0) res[0][9]=a01;
  a01=arg[1]? arg[1][5] : 0;
  a05=(a00*a01);
  a04=(a20-a16);
  a14=(a06*a04);
  a63=(a14-a72);
  a63=(a03*a63);
  a63=(a63-a72);
  a05=(a05+a63);
  a05=(a05/a12);
  a04=(a07*a04);
  a61=(a08*a20);
  a58=(a04-a61);
  a74=(a03*a58);
  a74=(a74-a61);
  a74=(a74/a12);
  a55=(a55*a74);
  a74=(a03*a49);
  a12=(a18*a74);
  a24=(a24*a16);
  a73=(a17*a24);
  a12=(a12+a73);
  a12=(a22*a12);
  a73=(2.*a77);
  a69=(a49-a73);
  a19=(a19*a69);
  a12=(a12+a19);
  a63=(a12-a63);
  a19=(a63/a25);
  a26=(a26/a25);
  a69=(a18*a16);
  a10=(a10*a69);
  a26=(a26*a10);
  a19=(a19-a26);
  a26=(a21*a77);
  a18=(a18*a26);
  a24=(a29*a24);
  a18=(a18+a24);
  a18=(a18+a14);
  a18=(a03*a18);
  a35=(a35*a33);
  a34=(a34*a35);
  a34=(a49+a34);
  a31=(a31*a34);
  a36=(a36*a33);
  a32=(a32*a36);
  a32=(a32+a16);
  a38=(a38*a32);
  a31=(a31+a38);
  a18=(a18-a31);
  a38=(a28*a63);
  a69=(a03*a69);
  a32=(a69/a25);
  a36=(a28/a25);
  a36=(a36*a10);
  a32=(a32+a36);
  a36=(a09*a32);
  a38=(a38-a36);
  a38=(a18-a38);
  a36=(a38/a40);
  a41=(a41/a40);
  a33=(a28*a69);
  a34=(a27*a32);
  a33=(a33+a34);
  a41=(a41*a33);
  a36=(a36-a41);
  a63=(a43*a63);
  a41=(a00*a61);
  a34=(a41/a25);
  a35=(a43/a25);
  a35=(a35*a10);
  a34=(a34+a35);
  a09=(a09*a34);
  a63=(a63-a09);
  a09=(a00*a77);
  a09=(a20*a09);
  a47=(a47*a77);
  a09=(a09+a47);
  a09=(a08*a09);
  a48=(a48*a72);
  a09=(a09+a48);
  a50=(a50*a01);
  a09=(a09+a50);
  a63=(a63-a09);
  a38=(a45*a38);
  a69=(a43*a69);
  a27=(a27*a34);
  a69=(a69+a27);
  a27=(a69/a40);
  a50=(a45/a40);
  a50=(a50*a33);
  a27=(a27+a50);
  a39=(a39*a27);
  a38=(a38-a39);
  a63=(a63-a38);
  a63=(a63/a51);
  a38=(a46/a51);
  a41=(a43*a41);
  a42=(a42*a34);
  a41=(a41+a42);
  a69=(a45*a69);
  a44=(a44*a27);
  a69=(a69+a44);
  a41=(a41+a69);
  a38=(a38*a41);
  a63=(a63-a38);
  a38=(a45*a63);
  a69=(a46*a27);
  a38=(a38-a69);
  a36=(a36-a38);
  a38=(a28*a36);
  a69=(a52*a32);
  a38=(a38-a69);
  a19=(a19-a38);
  a38=(a43*a63);
  a46=(a46*a34);
  a38=(a38-a46);
  a19=(a19+a38);
  a38=(a54*a19);
  a46=(a61-a04);
  a46=(a03*a46);
  a46=(a46+a61);
  a69=(a53*a46);
  a38=(a38+a69);
  a69=(a03*a36);
  a69=(a06*a69);
  a56=(a56*a04);
  a69=(a69-a56);
  a38=(a38-a69);
  a63=(a00*a63);
  a38=(a38+a63);
  a74=(a16*a74);
  a17=(a17*a49);
  a74=(a74+a17);
  a74=(a07*a74);
  a57=(a57*a14);
  a74=(a74+a57);
  a38=(a38-a74);
  a57=(a03*a14);
  a17=(a60*a57);
  a73=(a16*a73);
  a21=(a21*a49);
  a73=(a73+a21);
  a59=(a59*a73);
  a17=(a17+a59);
  a38=(a38+a17);
  a62=(a62*a26);
  a26=(a03*a72);
  a26=(a26-a57);
  a26=(a26+a72);
  a29=(a29*a26);
  a62=(a62+a29);
  a38=(a38+a62);
  a15=(a15*a38);
  a55=(a55+a15);
  a55=(a55/a65);
  a64=(a64/a65);
  a65=(a07*a19);
  a15=(a53*a14);
  a65=(a65+a15);
  a36=(a07*a36);
  a52=(a52*a14);
  a36=(a36+a52);
  a65=(a65-a36);
  a36=(a06*a77);
  a52=(a20*a04);
  a36=(a36-a52);
  a36=(a20*a36);
  a66=(a66*a77);
  a36=(a36+a66);
  a65=(a65+a36);
  a66=(a06*a49);
  a52=(a16*a04);
  a66=(a66-a52);
  a66=(a16*a66);
  a68=(a68*a49);
  a66=(a66+a68);
  a65=(a65+a66);
  a73=(a06*a73);
  a60=(a60*a04);
  a73=(a73-a60);
  a65=(a65-a73);
  a19=(a08*a19);
  a53=(a53*a72);
  a19=(a19+a53);
  a13=(a13*a77);
  a61=(a20*a61);
  a13=(a13-a61);
  a20=(a20*a13);
  a13=(a72*a77);
  a20=(a20+a13);
  a19=(a19+a20);
  a65=(a65-a19);
  a65=(a03*a65);
  a65=(a65-a19);
  a64=(a64*a65);
  a55=(a55-a64);
  a05=(a05-a55);
  a05=(-a05);
  if (res[1]!=0) res[1][0]=a05;
  if (res[1]!=0) res[1][1]=a02;
  a02=(a72-a14);
  a02=(a03*a02);
  a12=(a12+a02);
  a12=(a12+a72);
  a02=(a12/a25);
  a71=(a71/a25);
  a71=(a71*a10);
  a02=(a02-a71);
  a71=(a28*a12);
  a10=(a23*a32);
  a71=(a71-a10);
  a18=(a18-a71);
  a71=(a18/a40);
  a75=(a75/a40);
  a75=(a75*a33);
  a71=(a71-a75);
  a12=(a43*a12);
  a23=(a23*a34);
  a12=(a12-a23);
  a12=(a12-a09);
  a18=(a45*a18);
  a30=(a30*a27);
  a18=(a18-a30);
  a12=(a12-a18);
  a12=(a12/a51);
  a51=(a76/a51);
  a51=(a51*a41);
  a12=(a12-a51);
  a45=(a45*a12);
  a27=(a76*a27);
  a45=(a45-a27);
  a71=(a71-a45);
  a28=(a28*a71);
  a32=(a49*a32);
  a28=(a28-a32);
  a02=(a02-a28);
  a43=(a43*a12);
  a76=(a76*a34);
  a43=(a43-a76);
  a02=(a02+a43);
  a43=(a07*a02);
  a76=(a77*a14);
  a43=(a43+a76);
  a07=(a07*a71);
  a14=(a49*a14);
  a07=(a07+a14);
  a43=(a43-a07);
  a43=(a43+a36);
  a43=(a43+a66);
  a43=(a43-a73);
  a08=(a08*a02);
  a72=(a77*a72);
  a08=(a08+a72);
  a08=(a08+a20);
  a43=(a43-a08);
  a43=(a03*a43);
  a43=(a43-a08);
  if (res[1]!=0) res[1][2]=a43;
  a54=(a54*a02);
  a77=(a77*a46);
  a54=(a54+a77);
  a03=(a03*a71);
  a06=(a06*a03);
  a70=(a70*a04);
  a06=(a06-a70);
  a54=(a54-a06);
  a00=(a00*a12);
  a54=(a54+a00);
  a54=(a54-a74);
  a54=(a54+a17);
  a54=(a54+a62);
  a54=(a54/a78);
  a11=(a11/a78);
  a11=(a11*a43);
  a54=(a54-a11);
  if (res[1]!=0) res[1][3]=a54;
  if (res[1]!=0) res[1][4]=a58;
  if (res[1]!=0) res[1][5]=a02;
  if (res[1]!=0) res[1][6]=a22;
  if (res[1]!=0) res[1][7]=a01;
  a16=(a16*a31);
  a37=(a37*a49);
  a16=(a16+a37);
  a16=(-a16);
  if (res[1]!=0) res[1][8]=a16;
  a31=(-a31);
  if (res[1]!=0) res[1][9]=a31;
  return 0;
}

/* working_steps:(t,turns[2x12],w[7],h,p[8])->(w_end[7],nodes[7x12],g[10x12],dg[10x12]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, *w00=w+115, w01, *w03=w+122, w05, *w06=w+124, w07, *w08=w+131, *w09=w+138, *w10=w+145, *w11=w+152;
  casadi_real *w12=w+159, *w13=w+166, *w14=w+173, *w15=w+180, *w16=w+187, *w17=w+194, *w18=w+201, *w19=w+208, *w20=w+214, *w21=w+224, *w22=w+234, *w23=w+244;
  casadi_real *w24=w+254, *w25=w+264, *w26=w+274, *w27=w+284, *w28=w+294, *w29=w+304, *w30=w+314, *w31=w+324, *w32=w+334;
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
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1482, *w21=w+1492;
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
  if (sz_w) *sz_w = 1498;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1498*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_72:(u[6],p[8])->(w[7x73],g[10x73],dg[10x73],R[6]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1592, *w21=w+1712, *w22=w+1832;
  casadi_real *w23=w+1952, *w24=w+1962, *w25=w+1972;
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
  if (sz_w) *sz_w = 1978;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1978*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_96:(u[6],p[8])->(w[7x97],g[10x97],dg[10x97],R[6]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1592, *w21=w+1712, *w22=w+1832;
  casadi_real *w23=w+1952, *w24=w+2072, *w25=w+2192, *w26=w+2312, *w27=w+2432, *w28=w+2442, *w29=w+2452;
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
  if (sz_w) *sz_w = 2458;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2458*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_144:(u[6],p[8])->(w[7x145],g[10x145],dg[10x145],R[6]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1592, *w21=w+1712, *w22=w+1832;
  casadi_real *w23=w+1952, *w24=w+2072, *w25=w+2192, *w26=w+2312, *w27=w+2432, *w28=w+2552, *w29=w+2672, *w30=w+2792, *w31=w+2912, *w32=w+3032, *w33=w+3152, *w34=w+3272;
  casadi_real *w35=w+3392, *w36=w+3402, *w37=w+3412;
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
  if (sz_w) *sz_w = 3418;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3418*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_192:(u[6],p[8])->(w[7x193],g[10x193],dg[10x193],R[6]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1592, *w21=w+1712, *w22=w+1832;
  casadi_real *w23=w+1952, *w24=w+2072, *w25=w+2192, *w26=w+2312, *w27=w+2432, *w28=w+2552, *w29=w+2672, *w30=w+2792, *w31=w+2912, *w32=w+3032, *w33=w+3152, *w34=w+3272;
  casadi_real *w35=w+3392, *w36=w+3512, *w37=w+3632, *w38=w+3752, *w39=w+3872, *w40=w+3992, *w41=w+4112, *w42=w+4232, *w43=w+4352, *w44=w+4362, *w45=w+4372;
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
  if (sz_w) *sz_w = 4378;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4378*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_288:(u[6],p[8])->(w[7x289],g[10x289],dg[10x289],R[6]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1592, *w21=w+1712, *w22=w+1832;
  casadi_real *w23=w+1952, *w24=w+2072, *w25=w+2192, *w26=w+2312, *w27=w+2432, *w28=w+2552, *w29=w+2672, *w30=w+2792, *w31=w+2912, *w32=w+3032, *w33=w+3152, *w34=w+3272;
  casadi_real *w35=w+3392, *w36=w+3512, *w37=w+3632, *w38=w+3752, *w39=w+3872, *w40=w+3992, *w41=w+4112, *w42=w+4232, *w43=w+4352, *w44=w+4472, *w45=w+4592, *w46=w+4712;
  casadi_real *w47=w+4832, *w48=w+4952, *w49=w+5072, *w50=w+5192, *w51=w+5312, *w52=w+5432, *w53=w+5552, *w54=w+5672, *w55=w+5792, *w56=w+5912, *w57=w+6032, *w58=w+6152;
  casadi_real *w59=w+6272, *w60=w+6282, *w61=w+6292;
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
  if (sz_w) *sz_w = 6298;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6298*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_384:(u[6],p[8])->(w[7x385],g[10x385],dg[10x385],R[6]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+379, w02, w03, *w05=w+385, *w06=w+409, w07, *w08=w+414, *w09=w+421, *w10=w+428;
  casadi_real *w11=w+512, *w12=w+632, *w13=w+752, *w14=w+872, *w15=w+992, *w16=w+1112, *w17=w+1232, *w18=w+1352, *w19=w+1472, *w20=w+1592, *w21=w+1712, *w22=w+1832;
  casadi_real *w23=w+1952, *w24=w+2072, *w25=w+2192, *w26=w+2312, *w27=w+2432, *w28=w+2552, *w29=w+2672, *w30=w+2792, *w31=w+2912, *w32=w+3032, *w33=w+3152, *w34=w+3272;
  casadi_real *w35=w+3392, *w36=w+3512, *w37=w+3632, *w38=w+3752, *w39=w+3872, *w40=w+3992, *w41=w+4112, *w42=w+4232, *w43=w+4352, *w44=w+4472, *w45=w+4592, *w46=w+4712;
  casadi_real *w47=w+4832, *w48=w+4952, *w49=w+5072, *w50=w+5192, *w51=w+5312, *w52=w+5432, *w53=w+5552, *w54=w+5672, *w55=w+5792, *w56=w+5912, *w57=w+6032, *w58=w+6152;
  casadi_real *w59=w+6272, *w60=w+6392, *w61=w+6512, *w62=w+6632, *w63=w+6752, *w64=w+6872, *w65=w+6992, *w66=w+7112, *w67=w+7232, *w68=w+7352, *w69=w+7472, *w70=w+7592;
  casadi_real *w71=w+7712, *w72=w+7832, *w73=w+7952, *w74=w+8072, *w75=w+8192, *w76=w+8202, *w77=w+8212;
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
  if (sz_w) *sz_w = 8218;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8218*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_576:(u[6],p[8])->(w[7x577],g[10x577],dg[10x577],R[6]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+379, w002, w003, *w005=w+385, *w006=w+409, w007, *w008=w+414, *w009=w+421, *w010=w+428;
  casadi_real *w011=w+512, *w012=w+632, *w013=w+752, *w014=w+872, *w015=w+992, *w016=w+1112, *w017=w+1232, *w018=w+1352, *w019=w+1472, *w020=w+1592, *w021=w+1712, *w022=w+1832;
  casadi_real *w023=w+1952, *w024=w+2072, *w025=w+2192, *w026=w+2312, *w027=w+2432, *w028=w+2552, *w029=w+2672, *w030=w+2792, *w031=w+2912, *w032=w+3032, *w033=w+3152, *w034=w+3272;
  casadi_real *w035=w+3392, *w036=w+3512, *w037=w+3632, *w038=w+3752, *w039=w+3872, *w040=w+3992, *w041=w+4112, *w042=w+4232, *w043=w+4352, *w044=w+4472, *w045=w+4592, *w046=w+4712;
  casadi_real *w047=w+4832, *w048=w+4952, *w049=w+5072, *w050=w+5192, *w051=w+5312, *w052=w+5432, *w053=w+5552, *w054=w+5672, *w055=w+5792, *w056=w+5912, *w057=w+6032, *w058=w+6152;
  casadi_real *w059=w+6272, *w060=w+6392, *w061=w+6512, *w062=w+6632, *w063=w+6752, *w064=w+6872, *w065=w+6992, *w066=w+7112, *w067=w+7232, *w068=w+7352, *w069=w+7472, *w070=w+7592;
  casadi_real *w071=w+7712, *w072=w+7832, *w073=w+7952, *w074=w+8072, *w075=w+8192, *w076=w+8312, *w077=w+8432, *w078=w+8552, *w079=w+8672, *w080=w+8792, *w081=w+8912, *w082=w+9032;
  casadi_real *w083=w+9152, *w084=w+9272, *w085=w+9392, *w086=w+9512, *w087=w+9632, *w088=w+9752, *w089=w+9872, *w090=w+9992, *w091=w+10112, *w092=w+10232, *w093=w+10352, *w094=w+10472;
  casadi_real *w095=w+10592, *w096=w+10712, *w097=w+10832, *w098=w+10952, *w099=w+11072, *w100=w+11192, *w101=w+11312, *w102=w+11432, *w103=w+11552, *w104=w+11672, *w105=w+11792, *w106=w+11912;
  casadi_real *w107=w+12032, *w108=w+12042, *w109=w+12052;
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
  if (sz_w) *sz_w = 12058;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12058*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_768:(u[6],p[8])->(w[7x769],g[10x769],dg[10x769],R[6]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+379, w002, w003, *w005=w+385, *w006=w+409, w007, *w008=w+414, *w009=w+421, *w010=w+428;
  casadi_real *w011=w+512, *w012=w+632, *w013=w+752, *w014=w+872, *w015=w+992, *w016=w+1112, *w017=w+1232, *w018=w+1352, *w019=w+1472, *w020=w+1592, *w021=w+1712, *w022=w+1832;
  casadi_real *w023=w+1952, *w024=w+2072, *w025=w+2192, *w026=w+2312, *w027=w+2432, *w028=w+2552, *w029=w+2672, *w030=w+2792, *w031=w+2912, *w032=w+3032, *w033=w+3152, *w034=w+3272;
  casadi_real *w035=w+3392, *w036=w+3512, *w037=w+3632, *w038=w+3752, *w039=w+3872, *w040=w+3992, *w041=w+4112, *w042=w+4232, *w043=w+4352, *w044=w+4472, *w045=w+4592, *w046=w+4712;
  casadi_real *w047=w+4832, *w048=w+4952, *w049=w+5072, *w050=w+5192, *w051=w+5312, *w052=w+5432, *w053=w+5552, *w054=w+5672, *w055=w+5792, *w056=w+5912, *w057=w+6032, *w058=w+6152;
  casadi_real *w059=w+6272, *w060=w+6392, *w061=w+6512, *w062=w+6632, *w063=w+6752, *w064=w+6872, *w065=w+6992, *w066=w+7112, *w067=w+7232, *w068=w+7352, *w069=w+7472, *w070=w+7592;
  casadi_real *w071=w+7712, *w072=w+7832, *w073=w+7952, *w074=w+8072, *w075=w+8192, *w076=w+8312, *w077=w+8432, *w078=w+8552, *w079=w+8672, *w080=w+8792, *w081=w+8912, *w082=w+9032;
  casadi_real *w083=w+9152, *w084=w+9272, *w085=w+9392, *w086=w+9512, *w087=w+9632, *w088=w+9752, *w089=w+9872, *w090=w+9992, *w091=w+10112, *w092=w+10232, *w093=w+10352, *w094=w+10472;
  casadi_real *w095=w+10592, *w096=w+10712, *w097=w+10832, *w098=w+10952, *w099=w+11072, *w100=w+11192, *w101=w+11312, *w102=w+11432, *w103=w+11552, *w104=w+11672, *w105=w+11792, *w106=w+11912;
  casadi_real *w107=w+12032, *w108=w+12152, *w109=w+12272, *w110=w+12392, *w111=w+12512, *w112=w+12632, *w113=w+12752, *w114=w+12872, *w115=w+12992, *w116=w+13112, *w117=w+13232, *w118=w+13352;
  casadi_real *w119=w+13472, *w120=w+13592, *w121=w+13712, *w122=w+13832, *w123=w+13952, *w124=w+14072, *w125=w+14192, *w126=w+14312, *w127=w+14432, *w128=w+14552, *w129=w+14672, *w130=w+14792;
  casadi_real *w131=w+14912, *w132=w+15032, *w133=w+15152, *w134=w+15272, *w135=w+15392, *w136=w+15512, *w137=w+15632, *w138=w+15752, *w139=w+15872, *w140=w+15882, *w141=w+15892;
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
  if (sz_w) *sz_w = 15898;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 15898*sizeof(casadi_real);
  return 0;
}

/* wobbling_advance:(t,w[7],h,p[8])->(w_end[7],g[10],dg[10]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w0=w+115, w1, *w3=w+122, w4, *w5=w+124, *w6=w+148, *w7=w+155, *w8=w+161, *w9=w+171;
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
  if (sz_w) *sz_w = 181;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 181*sizeof(casadi_real);
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
  casadi_real **res1=res+1, w1, w2, *w4=w+422, *w5=w+446;
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
  if (sz_w) *sz_w = 482;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 482*sizeof(casadi_real);
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
  casadi_real **res1=res+4, w0, w1, *w3=w+379, *w4=w+403, *w5=w+410, *w6=w+417, *w7=w+501, *w8=w+621;
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
  if (sz_w) *sz_w = 741;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 741*sizeof(casadi_real);
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
