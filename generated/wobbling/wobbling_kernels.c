/* Compass walker with a horizontally wobbling mass: kernels of the solver
 * Printed by CasADi 3.8.2 from equations 545a67fb84f58fd4.
 * Do not edit: run `stridemap derive`.
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
static const casadi_int casadi_s5[3] = {9, 1, 1};
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

/* start:(z[5],p[9])->(y[6],dy_dz[6x5]) */
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

/* turns:(h,p[9])->(turns[2x12]) */
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

/* phase:(t,p[9])->(phase[2]) */
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

/* variational_step:(y[6x6],phase[2],turns[2x12],h,p[9])->(y_end[6x6]) */
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
  casadi_real a312, a313, a314, a315, a316, a317, a318, a319, a320, a321, a322, a323;
  casadi_real a324, a325, a326, a327, a328, a329, a330, a331, a332, a333, a334, a335;
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344;
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
  a041=arg[4]? arg[4][8] : 0;
  a042=arg[0]? arg[0][5] : 0;
  a043=(a041*a042);
  a040=(a040+a043);
  a043=arg[4]? arg[4][0] : 0;
  a044=arg[0]? arg[0][2] : 0;
  a045=(a043*a044);
  a040=(a040+a045);
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
  a045=2.9587585476806851e-02;
  a045=(a045*a002);
  a046=(a045*a035);
  a047=8.8762756430420545e-02;
  a047=(a047*a002);
  a048=1.9725056984537900e-02;
  a048=(a048*a002);
  a049=(a048*a023);
  a050=5.9175170953613701e-02;
  a050=(a050*a002);
  a051=5.2600151958767730e-02;
  a051=(a051*a002);
  a052=(a051*a035);
  a052=(a008+a052);
  a053=(a007*a052);
  a054=(a051*a008);
  a054=(a010+a054);
  a055=sin(a054);
  a053=(a053*a055);
  a056=(a051*a023);
  a056=(a003+a056);
  a057=(2.*a056);
  a057=(a052-a057);
  a053=(a053*a057);
  a058=(a051*a003);
  a058=(a000+a058);
  a059=sin(a058);
  a060=cos(a054);
  a061=(a059*a060);
  a058=cos(a058);
  a062=(a058*a055);
  a061=(a061-a062);
  a062=(a007*a061);
  a053=(a053-a062);
  a063=(a059*a019);
  a053=(a053+a063);
  a064=(a018-a060);
  a064=(a021*a064);
  a064=(a064+a018);
  a065=(a053/a064);
  a066=(a060-a018);
  a066=(a007*a066);
  a067=(a066/a064);
  a068=casadi_sq(a056);
  a068=(a068*a055);
  a068=(a068+a061);
  a068=(a007*a068);
  a061=arg[2]? arg[2][2] : 0;
  a069=(a029*a061);
  a070=arg[2]? arg[2][3] : 0;
  a071=(a033*a070);
  a069=(a069+a071);
  a069=(a028*a069);
  a069=(a052+a069);
  a069=(a015*a069);
  a061=(a033*a061);
  a070=(a029*a070);
  a061=(a061-a070);
  a061=(a061+a018);
  a061=(a027*a061);
  a061=(a032-a061);
  a061=(a061+a054);
  a061=(a031*a061);
  a069=(a069+a061);
  a068=(a068-a069);
  a069=(a067*a053);
  a069=(a068-a069);
  a061=(a066*a067);
  a061=(a007-a061);
  a054=(a069/a061);
  a070=(a036*a058);
  a071=(a070/a064);
  a066=(a066*a071);
  a072=(a066/a061);
  a053=(a071*a053);
  a073=(a036*a056);
  a073=(a073*a056);
  a073=(a073*a059);
  a074=(a051*a009);
  a074=(a042+a074);
  a075=(a041*a074);
  a073=(a073+a075);
  a075=(a051*a042);
  a075=(a044+a075);
  a075=(a043*a075);
  a073=(a073+a075);
  a053=(a053-a073);
  a069=(a072*a069);
  a053=(a053-a069);
  a070=(a070*a071);
  a070=(a036-a070);
  a066=(a066*a072);
  a070=(a070-a066);
  a053=(a053/a070);
  a066=(a072*a053);
  a054=(a054-a066);
  a066=(a067*a054);
  a065=(a065-a066);
  a066=(a071*a053);
  a065=(a065+a066);
  a065=(a050*a065);
  a049=(a049+a065);
  a049=(a003+a049);
  a065=casadi_sq(a049);
  a066=(a048*a008);
  a069=(a050*a052);
  a066=(a066+a069);
  a066=(a010+a066);
  a069=sin(a066);
  a065=(a065*a069);
  a075=(a048*a003);
  a076=(a050*a056);
  a075=(a075+a076);
  a075=(a000+a075);
  a076=sin(a075);
  a077=cos(a066);
  a078=(a076*a077);
  a075=cos(a075);
  a079=(a075*a069);
  a078=(a078-a079);
  a065=(a065+a078);
  a065=(a007*a065);
  a079=(a048*a035);
  a054=(a050*a054);
  a079=(a079+a054);
  a079=(a008+a079);
  a054=arg[2]? arg[2][4] : 0;
  a080=(a029*a054);
  a081=arg[2]? arg[2][5] : 0;
  a082=(a033*a081);
  a080=(a080+a082);
  a080=(a028*a080);
  a080=(a079+a080);
  a080=(a015*a080);
  a054=(a033*a054);
  a081=(a029*a081);
  a054=(a054-a081);
  a054=(a054+a018);
  a054=(a027*a054);
  a054=(a032-a054);
  a054=(a054+a066);
  a054=(a031*a054);
  a080=(a080+a054);
  a065=(a065-a080);
  a080=(a077-a018);
  a080=(a007*a080);
  a054=(a018-a077);
  a054=(a021*a054);
  a054=(a054+a018);
  a066=(a080/a054);
  a081=(a007*a079);
  a081=(a081*a069);
  a082=(2.*a049);
  a082=(a079-a082);
  a081=(a081*a082);
  a078=(a007*a078);
  a081=(a081-a078);
  a083=(a076*a019);
  a081=(a081+a083);
  a084=(a066*a081);
  a084=(a065-a084);
  a085=(a080*a066);
  a085=(a007-a085);
  a086=(a084/a085);
  a087=(a036*a075);
  a088=(a087/a054);
  a080=(a080*a088);
  a089=(a080/a085);
  a090=(a088*a081);
  a091=(a036*a049);
  a091=(a091*a049);
  a091=(a091*a076);
  a092=(a048*a009);
  a053=(a050*a053);
  a092=(a092+a053);
  a092=(a042+a092);
  a053=(a041*a092);
  a091=(a091+a053);
  a053=(a048*a042);
  a074=(a050*a074);
  a053=(a053+a074);
  a053=(a044+a053);
  a053=(a043*a053);
  a091=(a091+a053);
  a090=(a090-a091);
  a084=(a089*a084);
  a090=(a090-a084);
  a087=(a087*a088);
  a087=(a036-a087);
  a080=(a080*a089);
  a087=(a087-a080);
  a090=(a090/a087);
  a080=(a089*a090);
  a086=(a086-a080);
  a080=(a047*a086);
  a046=(a046+a080);
  a046=(a008+a046);
  a080=(a007*a046);
  a084=(a045*a008);
  a053=(a047*a079);
  a084=(a084+a053);
  a084=(a010+a084);
  a053=sin(a084);
  a080=(a080*a053);
  a074=(a045*a023);
  a081=(a081/a054);
  a093=(a066*a086);
  a081=(a081-a093);
  a093=(a088*a090);
  a081=(a081+a093);
  a093=(a047*a081);
  a074=(a074+a093);
  a074=(a003+a074);
  a093=(2.*a074);
  a093=(a046-a093);
  a080=(a080*a093);
  a094=(a045*a003);
  a095=(a047*a049);
  a094=(a094+a095);
  a094=(a000+a094);
  a095=sin(a094);
  a096=cos(a084);
  a097=(a095*a096);
  a094=cos(a094);
  a098=(a094*a053);
  a097=(a097-a098);
  a098=(a007*a097);
  a080=(a080-a098);
  a099=(a095*a019);
  a080=(a080+a099);
  a100=(a018-a096);
  a100=(a021*a100);
  a100=(a100+a018);
  a101=(a080/a100);
  a102=(a096-a018);
  a102=(a007*a102);
  a103=(a102/a100);
  a104=casadi_sq(a074);
  a104=(a104*a053);
  a104=(a104+a097);
  a104=(a007*a104);
  a097=arg[2]? arg[2][6] : 0;
  a105=(a029*a097);
  a106=arg[2]? arg[2][7] : 0;
  a107=(a033*a106);
  a105=(a105+a107);
  a105=(a028*a105);
  a105=(a046+a105);
  a105=(a015*a105);
  a097=(a033*a097);
  a106=(a029*a106);
  a097=(a097-a106);
  a097=(a097+a018);
  a097=(a027*a097);
  a097=(a032-a097);
  a097=(a097+a084);
  a097=(a031*a097);
  a105=(a105+a097);
  a104=(a104-a105);
  a105=(a103*a080);
  a105=(a104-a105);
  a097=(a102*a103);
  a097=(a007-a097);
  a084=(a105/a097);
  a106=(a036*a094);
  a107=(a106/a100);
  a102=(a102*a107);
  a108=(a102/a097);
  a080=(a107*a080);
  a109=(a036*a074);
  a109=(a109*a074);
  a109=(a109*a095);
  a110=(a045*a009);
  a111=(a047*a090);
  a110=(a110+a111);
  a110=(a042+a110);
  a111=(a041*a110);
  a109=(a109+a111);
  a111=(a045*a042);
  a112=(a047*a092);
  a111=(a111+a112);
  a111=(a044+a111);
  a111=(a043*a111);
  a109=(a109+a111);
  a080=(a080-a109);
  a105=(a108*a105);
  a080=(a080-a105);
  a106=(a106*a107);
  a106=(a036-a106);
  a102=(a102*a108);
  a106=(a106-a102);
  a080=(a080/a106);
  a102=(a108*a080);
  a084=(a084-a102);
  a102=(a103*a084);
  a101=(a101-a102);
  a102=(a107*a080);
  a101=(a101+a102);
  a102=(a030*a101);
  a024=(a024+a102);
  a102=1.2546768756682242e-01;
  a102=(a102*a002);
  a105=2.4136513415926669e-01;
  a105=(a105*a002);
  a111=(a105*a035);
  a112=-8.8454947932828609e-01;
  a112=(a112*a002);
  a086=(a112*a086);
  a111=(a111+a086);
  a086=9.2483400326179199e-01;
  a086=(a086*a002);
  a113=(a086*a084);
  a111=(a111+a113);
  a111=(a008+a111);
  a113=(a007*a111);
  a114=(a105*a008);
  a115=(a112*a079);
  a114=(a114+a115);
  a115=(a086*a046);
  a114=(a114+a115);
  a114=(a010+a114);
  a115=sin(a114);
  a113=(a113*a115);
  a116=(a105*a023);
  a081=(a112*a081);
  a116=(a116+a081);
  a081=(a086*a101);
  a116=(a116+a081);
  a116=(a003+a116);
  a081=(2.*a116);
  a081=(a111-a081);
  a113=(a113*a081);
  a117=(a105*a003);
  a118=(a112*a049);
  a117=(a117+a118);
  a118=(a086*a074);
  a117=(a117+a118);
  a117=(a000+a117);
  a118=sin(a117);
  a119=cos(a114);
  a120=(a118*a119);
  a117=cos(a117);
  a121=(a117*a115);
  a120=(a120-a121);
  a121=(a007*a120);
  a113=(a113-a121);
  a122=(a118*a019);
  a113=(a113+a122);
  a123=(a018-a119);
  a123=(a021*a123);
  a123=(a123+a018);
  a124=(a113/a123);
  a125=(a119-a018);
  a125=(a007*a125);
  a126=(a125/a123);
  a127=casadi_sq(a116);
  a127=(a127*a115);
  a127=(a127+a120);
  a127=(a007*a127);
  a120=arg[2]? arg[2][8] : 0;
  a128=(a029*a120);
  a129=arg[2]? arg[2][9] : 0;
  a130=(a033*a129);
  a128=(a128+a130);
  a128=(a028*a128);
  a128=(a111+a128);
  a128=(a015*a128);
  a120=(a033*a120);
  a129=(a029*a129);
  a120=(a120-a129);
  a120=(a120+a018);
  a120=(a027*a120);
  a120=(a032-a120);
  a120=(a120+a114);
  a120=(a031*a120);
  a128=(a128+a120);
  a127=(a127-a128);
  a128=(a126*a113);
  a128=(a127-a128);
  a120=(a125*a126);
  a120=(a007-a120);
  a114=(a128/a120);
  a129=(a036*a117);
  a130=(a129/a123);
  a125=(a125*a130);
  a131=(a125/a120);
  a113=(a130*a113);
  a132=(a036*a116);
  a132=(a132*a116);
  a132=(a132*a118);
  a133=(a105*a009);
  a090=(a112*a090);
  a133=(a133+a090);
  a090=(a086*a080);
  a133=(a133+a090);
  a133=(a042+a133);
  a090=(a041*a133);
  a132=(a132+a090);
  a090=(a105*a042);
  a092=(a112*a092);
  a090=(a090+a092);
  a092=(a086*a110);
  a090=(a090+a092);
  a090=(a044+a090);
  a090=(a043*a090);
  a132=(a132+a090);
  a113=(a113-a132);
  a128=(a131*a128);
  a113=(a113-a128);
  a129=(a129*a130);
  a129=(a036-a129);
  a125=(a125*a131);
  a129=(a129-a125);
  a113=(a113/a129);
  a125=(a131*a113);
  a114=(a114-a125);
  a125=(a126*a114);
  a124=(a124-a125);
  a125=(a130*a113);
  a124=(a124+a125);
  a125=(a102*a124);
  a024=(a024+a125);
  a024=(a003+a024);
  a125=(a005*a024);
  a004=(a004+a125);
  a125=1.8915178993145003e+00;
  a125=(a125*a002);
  a128=3.7109375000000000e-02;
  a128=(a128*a002);
  a090=(a128*a023);
  a092=1.7025221101954405e-01;
  a092=(a092*a002);
  a134=(a092*a101);
  a090=(a090+a134);
  a134=6.0216538980455959e-02;
  a134=(a134*a002);
  a135=(a134*a124);
  a090=(a090+a135);
  a135=-1.7578125000000000e-02;
  a135=(a135*a002);
  a136=(a006*a035);
  a137=(a030*a084);
  a136=(a136+a137);
  a137=(a102*a114);
  a136=(a136+a137);
  a136=(a008+a136);
  a137=(a007*a136);
  a138=(a006*a008);
  a139=(a030*a046);
  a138=(a138+a139);
  a139=(a102*a111);
  a138=(a138+a139);
  a138=(a010+a138);
  a139=sin(a138);
  a137=(a137*a139);
  a140=(2.*a024);
  a140=(a136-a140);
  a137=(a137*a140);
  a141=(a006*a003);
  a142=(a030*a074);
  a141=(a141+a142);
  a142=(a102*a116);
  a141=(a141+a142);
  a141=(a000+a141);
  a142=sin(a141);
  a143=cos(a138);
  a144=(a142*a143);
  a141=cos(a141);
  a145=(a141*a139);
  a144=(a144-a145);
  a145=(a007*a144);
  a137=(a137-a145);
  a146=(a142*a019);
  a137=(a137+a146);
  a147=(a018-a143);
  a147=(a021*a147);
  a147=(a147+a018);
  a148=(a137/a147);
  a149=(a143-a018);
  a149=(a007*a149);
  a150=(a149/a147);
  a151=casadi_sq(a024);
  a151=(a151*a139);
  a151=(a151+a144);
  a151=(a007*a151);
  a144=arg[2]? arg[2][10] : 0;
  a152=(a029*a144);
  a153=arg[2]? arg[2][11] : 0;
  a154=(a033*a153);
  a152=(a152+a154);
  a152=(a028*a152);
  a152=(a136+a152);
  a152=(a015*a152);
  a144=(a033*a144);
  a153=(a029*a153);
  a144=(a144-a153);
  a144=(a144+a018);
  a144=(a027*a144);
  a144=(a032-a144);
  a144=(a144+a138);
  a144=(a031*a144);
  a152=(a152+a144);
  a151=(a151-a152);
  a152=(a150*a137);
  a152=(a151-a152);
  a144=(a149*a150);
  a144=(a007-a144);
  a138=(a152/a144);
  a153=(a036*a141);
  a154=(a153/a147);
  a149=(a149*a154);
  a155=(a149/a144);
  a137=(a154*a137);
  a156=(a036*a024);
  a156=(a156*a024);
  a156=(a156*a142);
  a157=(a006*a009);
  a158=(a030*a080);
  a157=(a157+a158);
  a158=(a102*a113);
  a157=(a157+a158);
  a157=(a042+a157);
  a158=(a041*a157);
  a156=(a156+a158);
  a158=(a006*a042);
  a159=(a030*a110);
  a158=(a158+a159);
  a159=(a102*a133);
  a158=(a158+a159);
  a158=(a044+a158);
  a158=(a043*a158);
  a156=(a156+a158);
  a137=(a137-a156);
  a152=(a155*a152);
  a137=(a137-a152);
  a153=(a153*a154);
  a153=(a036-a153);
  a149=(a149*a155);
  a153=(a153-a149);
  a137=(a137/a153);
  a149=(a155*a137);
  a138=(a138-a149);
  a149=(a150*a138);
  a148=(a148-a149);
  a149=(a154*a137);
  a148=(a148+a149);
  a149=(a135*a148);
  a090=(a090+a149);
  a090=(a003+a090);
  a149=(a125*a090);
  a004=(a004+a149);
  a149=-5.8012039600105849e+00;
  a149=(a149*a002);
  a152=3.7092000118504789e-02;
  a152=(a152*a002);
  a158=(a152*a023);
  a159=1.7038392571223998e-01;
  a159=(a159*a002);
  a160=(a159*a101);
  a158=(a158+a160);
  a160=1.0726203044637328e-01;
  a160=(a160*a002);
  a161=(a160*a124);
  a158=(a158+a161);
  a161=-1.5319437748624402e-02;
  a161=(a161*a002);
  a162=(a161*a148);
  a158=(a158+a162);
  a162=8.2737891638140233e-03;
  a162=(a162*a002);
  a163=(a128*a035);
  a164=(a092*a084);
  a163=(a163+a164);
  a164=(a134*a114);
  a163=(a163+a164);
  a164=(a135*a138);
  a163=(a163+a164);
  a163=(a008+a163);
  a164=(a007*a163);
  a165=(a128*a008);
  a166=(a092*a046);
  a165=(a165+a166);
  a166=(a134*a111);
  a165=(a165+a166);
  a166=(a135*a136);
  a165=(a165+a166);
  a165=(a010+a165);
  a166=sin(a165);
  a164=(a164*a166);
  a167=(2.*a090);
  a167=(a163-a167);
  a164=(a164*a167);
  a168=(a128*a003);
  a169=(a092*a074);
  a168=(a168+a169);
  a169=(a134*a116);
  a168=(a168+a169);
  a169=(a135*a024);
  a168=(a168+a169);
  a168=(a000+a168);
  a169=sin(a168);
  a170=cos(a165);
  a171=(a169*a170);
  a168=cos(a168);
  a172=(a168*a166);
  a171=(a171-a172);
  a172=(a007*a171);
  a164=(a164-a172);
  a173=(a169*a019);
  a164=(a164+a173);
  a174=(a018-a170);
  a174=(a021*a174);
  a174=(a174+a018);
  a175=(a164/a174);
  a176=(a170-a018);
  a176=(a007*a176);
  a177=(a176/a174);
  a178=casadi_sq(a090);
  a178=(a178*a166);
  a178=(a178+a171);
  a178=(a007*a178);
  a171=arg[2]? arg[2][12] : 0;
  a179=(a029*a171);
  a180=arg[2]? arg[2][13] : 0;
  a181=(a033*a180);
  a179=(a179+a181);
  a179=(a028*a179);
  a179=(a163+a179);
  a179=(a015*a179);
  a171=(a033*a171);
  a180=(a029*a180);
  a171=(a171-a180);
  a171=(a171+a018);
  a171=(a027*a171);
  a171=(a032-a171);
  a171=(a171+a165);
  a171=(a031*a171);
  a179=(a179+a171);
  a178=(a178-a179);
  a179=(a177*a164);
  a179=(a178-a179);
  a171=(a176*a177);
  a171=(a007-a171);
  a165=(a179/a171);
  a180=(a036*a168);
  a181=(a180/a174);
  a176=(a176*a181);
  a182=(a176/a171);
  a164=(a181*a164);
  a183=(a036*a090);
  a183=(a183*a090);
  a183=(a183*a169);
  a184=(a128*a009);
  a185=(a092*a080);
  a184=(a184+a185);
  a185=(a134*a113);
  a184=(a184+a185);
  a185=(a135*a137);
  a184=(a184+a185);
  a184=(a042+a184);
  a185=(a041*a184);
  a183=(a183+a185);
  a185=(a128*a042);
  a186=(a092*a110);
  a185=(a185+a186);
  a186=(a134*a133);
  a185=(a185+a186);
  a186=(a135*a157);
  a185=(a185+a186);
  a185=(a044+a185);
  a185=(a043*a185);
  a183=(a183+a185);
  a164=(a164-a183);
  a179=(a182*a179);
  a164=(a164-a179);
  a180=(a180*a181);
  a180=(a036-a180);
  a176=(a176*a182);
  a180=(a180-a176);
  a164=(a164/a180);
  a176=(a182*a164);
  a165=(a165-a176);
  a176=(a177*a165);
  a175=(a175-a176);
  a176=(a181*a164);
  a175=(a175+a176);
  a176=(a162*a175);
  a158=(a158+a176);
  a158=(a003+a158);
  a176=(a149*a158);
  a004=(a004+a176);
  a176=3.1116436695781990e-01;
  a176=(a176*a002);
  a179=6.2411095871607569e-01;
  a179=(a179*a002);
  a185=(a179*a023);
  a186=-3.3608926294469414e+00;
  a186=(a186*a002);
  a187=(a186*a101);
  a185=(a185+a187);
  a187=-8.6821934684172597e-01;
  a187=(a187*a002);
  a188=(a187*a124);
  a185=(a185+a188);
  a188=2.7592099699446710e+01;
  a188=(a188*a002);
  a189=(a188*a148);
  a185=(a185+a189);
  a189=2.0154067550477894e+01;
  a189=(a189*a002);
  a190=(a189*a175);
  a185=(a185+a190);
  a190=-4.3489884181069961e+01;
  a190=(a190*a002);
  a191=(a152*a035);
  a192=(a159*a084);
  a191=(a191+a192);
  a192=(a160*a114);
  a191=(a191+a192);
  a192=(a161*a138);
  a191=(a191+a192);
  a192=(a162*a165);
  a191=(a191+a192);
  a191=(a008+a191);
  a192=(a007*a191);
  a193=(a152*a008);
  a194=(a159*a046);
  a193=(a193+a194);
  a194=(a160*a111);
  a193=(a193+a194);
  a194=(a161*a136);
  a193=(a193+a194);
  a194=(a162*a163);
  a193=(a193+a194);
  a193=(a010+a193);
  a194=sin(a193);
  a192=(a192*a194);
  a195=(2.*a158);
  a195=(a191-a195);
  a192=(a192*a195);
  a196=(a152*a003);
  a197=(a159*a074);
  a196=(a196+a197);
  a197=(a160*a116);
  a196=(a196+a197);
  a197=(a161*a024);
  a196=(a196+a197);
  a197=(a162*a090);
  a196=(a196+a197);
  a196=(a000+a196);
  a197=sin(a196);
  a198=cos(a193);
  a199=(a197*a198);
  a196=cos(a196);
  a200=(a196*a194);
  a199=(a199-a200);
  a200=(a007*a199);
  a192=(a192-a200);
  a201=(a197*a019);
  a192=(a192+a201);
  a202=(a018-a198);
  a202=(a021*a202);
  a202=(a202+a018);
  a203=(a192/a202);
  a204=(a198-a018);
  a204=(a007*a204);
  a205=(a204/a202);
  a206=casadi_sq(a158);
  a206=(a206*a194);
  a206=(a206+a199);
  a206=(a007*a206);
  a199=arg[2]? arg[2][14] : 0;
  a207=(a029*a199);
  a208=arg[2]? arg[2][15] : 0;
  a209=(a033*a208);
  a207=(a207+a209);
  a207=(a028*a207);
  a207=(a191+a207);
  a207=(a015*a207);
  a199=(a033*a199);
  a208=(a029*a208);
  a199=(a199-a208);
  a199=(a199+a018);
  a199=(a027*a199);
  a199=(a032-a199);
  a199=(a199+a193);
  a199=(a031*a199);
  a207=(a207+a199);
  a206=(a206-a207);
  a207=(a205*a192);
  a207=(a206-a207);
  a199=(a204*a205);
  a199=(a007-a199);
  a193=(a207/a199);
  a208=(a036*a196);
  a209=(a208/a202);
  a204=(a204*a209);
  a210=(a204/a199);
  a192=(a209*a192);
  a211=(a036*a158);
  a211=(a211*a158);
  a211=(a211*a197);
  a212=(a152*a009);
  a213=(a159*a080);
  a212=(a212+a213);
  a213=(a160*a113);
  a212=(a212+a213);
  a213=(a161*a137);
  a212=(a212+a213);
  a213=(a162*a164);
  a212=(a212+a213);
  a212=(a042+a212);
  a213=(a041*a212);
  a211=(a211+a213);
  a213=(a152*a042);
  a214=(a159*a110);
  a213=(a213+a214);
  a214=(a160*a133);
  a213=(a213+a214);
  a214=(a161*a157);
  a213=(a213+a214);
  a214=(a162*a184);
  a213=(a213+a214);
  a213=(a044+a213);
  a213=(a043*a213);
  a211=(a211+a213);
  a192=(a192-a211);
  a207=(a210*a207);
  a192=(a192-a207);
  a208=(a208*a209);
  a208=(a036-a208);
  a204=(a204*a210);
  a208=(a208-a204);
  a192=(a192/a208);
  a204=(a210*a192);
  a193=(a193-a204);
  a204=(a205*a193);
  a203=(a203-a204);
  a204=(a209*a192);
  a203=(a203+a204);
  a204=(a190*a203);
  a185=(a185+a204);
  a185=(a003+a185);
  a204=(a176*a185);
  a004=(a004+a204);
  a204=-1.5216094966251609e-01;
  a204=(a204*a002);
  a207=4.7766253643826434e-01;
  a207=(a207*a002);
  a213=(a207*a023);
  a214=-2.4881146199716677e+00;
  a214=(a214*a002);
  a215=(a214*a101);
  a213=(a213+a215);
  a215=-5.9029082683684297e-01;
  a215=(a215*a002);
  a216=(a215*a124);
  a213=(a213+a216);
  a216=2.1230051448181193e+01;
  a216=(a216*a002);
  a217=(a216*a148);
  a213=(a213+a217);
  a217=1.5279233632882423e+01;
  a217=(a217*a002);
  a218=(a217*a175);
  a213=(a213+a218);
  a218=-3.3288210968984863e+01;
  a218=(a218*a002);
  a219=(a218*a203);
  a213=(a213+a219);
  a219=-2.0331201708508627e-02;
  a219=(a219*a002);
  a220=(a179*a035);
  a221=(a186*a084);
  a220=(a220+a221);
  a221=(a187*a114);
  a220=(a220+a221);
  a221=(a188*a138);
  a220=(a220+a221);
  a221=(a189*a165);
  a220=(a220+a221);
  a221=(a190*a193);
  a220=(a220+a221);
  a220=(a008+a220);
  a221=(a007*a220);
  a222=(a179*a008);
  a223=(a186*a046);
  a222=(a222+a223);
  a223=(a187*a111);
  a222=(a222+a223);
  a223=(a188*a136);
  a222=(a222+a223);
  a223=(a189*a163);
  a222=(a222+a223);
  a223=(a190*a191);
  a222=(a222+a223);
  a222=(a010+a222);
  a223=sin(a222);
  a221=(a221*a223);
  a224=(2.*a185);
  a224=(a220-a224);
  a221=(a221*a224);
  a225=(a179*a003);
  a226=(a186*a074);
  a225=(a225+a226);
  a226=(a187*a116);
  a225=(a225+a226);
  a226=(a188*a024);
  a225=(a225+a226);
  a226=(a189*a090);
  a225=(a225+a226);
  a226=(a190*a158);
  a225=(a225+a226);
  a225=(a000+a225);
  a226=sin(a225);
  a227=cos(a222);
  a228=(a226*a227);
  a225=cos(a225);
  a229=(a225*a223);
  a228=(a228-a229);
  a229=(a007*a228);
  a221=(a221-a229);
  a230=(a226*a019);
  a221=(a221+a230);
  a231=(a018-a227);
  a231=(a021*a231);
  a231=(a231+a018);
  a232=(a221/a231);
  a233=(a227-a018);
  a233=(a007*a233);
  a234=(a233/a231);
  a235=casadi_sq(a185);
  a235=(a235*a223);
  a235=(a235+a228);
  a235=(a007*a235);
  a228=arg[2]? arg[2][16] : 0;
  a236=(a029*a228);
  a237=arg[2]? arg[2][17] : 0;
  a238=(a033*a237);
  a236=(a236+a238);
  a236=(a028*a236);
  a236=(a220+a236);
  a236=(a015*a236);
  a228=(a033*a228);
  a237=(a029*a237);
  a228=(a228-a237);
  a228=(a228+a018);
  a228=(a027*a228);
  a228=(a032-a228);
  a228=(a228+a222);
  a228=(a031*a228);
  a236=(a236+a228);
  a235=(a235-a236);
  a236=(a234*a221);
  a236=(a235-a236);
  a228=(a233*a234);
  a228=(a007-a228);
  a222=(a236/a228);
  a237=(a036*a225);
  a238=(a237/a231);
  a233=(a233*a238);
  a239=(a233/a228);
  a221=(a238*a221);
  a240=(a036*a185);
  a240=(a240*a185);
  a240=(a240*a226);
  a241=(a179*a009);
  a242=(a186*a080);
  a241=(a241+a242);
  a242=(a187*a113);
  a241=(a241+a242);
  a242=(a188*a137);
  a241=(a241+a242);
  a242=(a189*a164);
  a241=(a241+a242);
  a242=(a190*a192);
  a241=(a241+a242);
  a241=(a042+a241);
  a242=(a041*a241);
  a240=(a240+a242);
  a242=(a179*a042);
  a243=(a186*a110);
  a242=(a242+a243);
  a243=(a187*a133);
  a242=(a242+a243);
  a243=(a188*a157);
  a242=(a242+a243);
  a243=(a189*a184);
  a242=(a242+a243);
  a243=(a190*a212);
  a242=(a242+a243);
  a242=(a044+a242);
  a242=(a043*a242);
  a240=(a240+a242);
  a221=(a221-a240);
  a236=(a239*a236);
  a221=(a221-a236);
  a237=(a237*a238);
  a237=(a036-a237);
  a233=(a233*a239);
  a237=(a237-a233);
  a221=(a221/a237);
  a233=(a239*a221);
  a222=(a222-a233);
  a233=(a234*a222);
  a232=(a232-a233);
  a233=(a238*a221);
  a232=(a232+a233);
  a233=(a219*a232);
  a213=(a213+a233);
  a213=(a003+a213);
  a233=(a204*a213);
  a004=(a004+a233);
  a233=2.0136540080403034e-01;
  a233=(a233*a002);
  a236=-9.3714243008598730e-01;
  a236=(a236*a002);
  a242=(a236*a023);
  a243=5.1863724288440638e+00;
  a243=(a243*a002);
  a244=(a243*a101);
  a242=(a242+a244);
  a244=1.0914373489967295e+00;
  a244=(a244*a002);
  a245=(a244*a124);
  a242=(a242+a245);
  a245=-8.1497870107469268e+00;
  a245=(a245*a002);
  a246=(a245*a148);
  a242=(a242+a246);
  a246=-1.8520065659996959e+01;
  a246=(a246*a002);
  a247=(a246*a175);
  a242=(a242+a247);
  a247=2.2739487099350505e+01;
  a247=(a247*a002);
  a248=(a247*a203);
  a242=(a242+a248);
  a248=2.4936055526796523e+00;
  a248=(a248*a002);
  a249=(a248*a232);
  a242=(a242+a249);
  a249=-3.0467644718982196e+00;
  a249=(a249*a002);
  a250=(a207*a035);
  a251=(a214*a084);
  a250=(a250+a251);
  a251=(a215*a114);
  a250=(a250+a251);
  a251=(a216*a138);
  a250=(a250+a251);
  a251=(a217*a165);
  a250=(a250+a251);
  a251=(a218*a193);
  a250=(a250+a251);
  a251=(a219*a222);
  a250=(a250+a251);
  a250=(a008+a250);
  a251=(a007*a250);
  a252=(a207*a008);
  a253=(a214*a046);
  a252=(a252+a253);
  a253=(a215*a111);
  a252=(a252+a253);
  a253=(a216*a136);
  a252=(a252+a253);
  a253=(a217*a163);
  a252=(a252+a253);
  a253=(a218*a191);
  a252=(a252+a253);
  a253=(a219*a220);
  a252=(a252+a253);
  a252=(a010+a252);
  a253=sin(a252);
  a251=(a251*a253);
  a254=(2.*a213);
  a254=(a250-a254);
  a251=(a251*a254);
  a255=(a207*a003);
  a256=(a214*a074);
  a255=(a255+a256);
  a256=(a215*a116);
  a255=(a255+a256);
  a256=(a216*a024);
  a255=(a255+a256);
  a256=(a217*a090);
  a255=(a255+a256);
  a256=(a218*a158);
  a255=(a255+a256);
  a256=(a219*a185);
  a255=(a255+a256);
  a255=(a000+a255);
  a256=sin(a255);
  a257=cos(a252);
  a258=(a256*a257);
  a255=cos(a255);
  a259=(a255*a253);
  a258=(a258-a259);
  a259=(a007*a258);
  a251=(a251-a259);
  a260=(a256*a019);
  a251=(a251+a260);
  a261=(a018-a257);
  a261=(a021*a261);
  a261=(a261+a018);
  a262=(a251/a261);
  a263=(a257-a018);
  a263=(a007*a263);
  a264=(a263/a261);
  a265=casadi_sq(a213);
  a265=(a265*a253);
  a265=(a265+a258);
  a265=(a007*a265);
  a258=arg[2]? arg[2][18] : 0;
  a266=(a029*a258);
  a267=arg[2]? arg[2][19] : 0;
  a268=(a033*a267);
  a266=(a266+a268);
  a266=(a028*a266);
  a266=(a250+a266);
  a266=(a015*a266);
  a258=(a033*a258);
  a267=(a029*a267);
  a258=(a258-a267);
  a258=(a258+a018);
  a258=(a027*a258);
  a258=(a032-a258);
  a258=(a258+a252);
  a258=(a031*a258);
  a266=(a266+a258);
  a265=(a265-a266);
  a266=(a264*a251);
  a266=(a265-a266);
  a258=(a263*a264);
  a258=(a007-a258);
  a252=(a266/a258);
  a267=(a036*a255);
  a268=(a267/a261);
  a263=(a263*a268);
  a269=(a263/a258);
  a251=(a268*a251);
  a270=(a036*a213);
  a270=(a270*a213);
  a270=(a270*a256);
  a271=(a207*a009);
  a272=(a214*a080);
  a271=(a271+a272);
  a272=(a215*a113);
  a271=(a271+a272);
  a272=(a216*a137);
  a271=(a271+a272);
  a272=(a217*a164);
  a271=(a271+a272);
  a272=(a218*a192);
  a271=(a271+a272);
  a272=(a219*a221);
  a271=(a271+a272);
  a271=(a042+a271);
  a272=(a041*a271);
  a270=(a270+a272);
  a272=(a207*a042);
  a273=(a214*a110);
  a272=(a272+a273);
  a273=(a215*a133);
  a272=(a272+a273);
  a273=(a216*a157);
  a272=(a272+a273);
  a273=(a217*a184);
  a272=(a272+a273);
  a273=(a218*a212);
  a272=(a272+a273);
  a273=(a219*a241);
  a272=(a272+a273);
  a272=(a044+a272);
  a272=(a043*a272);
  a270=(a270+a272);
  a251=(a251-a270);
  a266=(a269*a266);
  a251=(a251-a266);
  a267=(a267*a268);
  a267=(a036-a267);
  a263=(a263*a269);
  a267=(a267-a263);
  a251=(a251/a267);
  a263=(a269*a251);
  a252=(a252-a263);
  a263=(a264*a252);
  a262=(a262-a263);
  a263=(a268*a251);
  a262=(a262+a263);
  a263=(a249*a262);
  a242=(a242+a263);
  a242=(a003+a242);
  a263=(a233*a242);
  a004=(a004+a263);
  a263=4.4710615727772587e-02;
  a263=(a263*a002);
  a266=2.2733101475165380e+00;
  a266=(a266*a002);
  a272=(a266*a023);
  a273=-1.0534495466737249e+01;
  a273=(a273*a002);
  a101=(a273*a101);
  a272=(a272+a101);
  a101=-2.0008720582248625e+00;
  a101=(a101*a002);
  a124=(a101*a124);
  a272=(a272+a124);
  a124=-1.7958931863118799e+01;
  a124=(a124*a002);
  a274=(a124*a148);
  a272=(a272+a274);
  a274=2.7948884529419960e+01;
  a274=(a274*a002);
  a275=(a274*a175);
  a272=(a272+a275);
  a275=-2.8589982771350235e+00;
  a275=(a275*a002);
  a276=(a275*a203);
  a272=(a272+a276);
  a276=-8.8728569335306293e+00;
  a276=(a276*a002);
  a277=(a276*a232);
  a272=(a272+a277);
  a277=1.2360567175794303e+01;
  a277=(a277*a002);
  a278=(a277*a262);
  a272=(a272+a278);
  a278=6.4339274601576357e-01;
  a278=(a278*a002);
  a002=(a236*a035);
  a279=(a243*a084);
  a002=(a002+a279);
  a279=(a244*a114);
  a002=(a002+a279);
  a279=(a245*a138);
  a002=(a002+a279);
  a279=(a246*a165);
  a002=(a002+a279);
  a279=(a247*a193);
  a002=(a002+a279);
  a279=(a248*a222);
  a002=(a002+a279);
  a279=(a249*a252);
  a002=(a002+a279);
  a002=(a008+a002);
  a279=(a007*a002);
  a280=(a236*a008);
  a281=(a243*a046);
  a280=(a280+a281);
  a281=(a244*a111);
  a280=(a280+a281);
  a281=(a245*a136);
  a280=(a280+a281);
  a281=(a246*a163);
  a280=(a280+a281);
  a281=(a247*a191);
  a280=(a280+a281);
  a281=(a248*a220);
  a280=(a280+a281);
  a281=(a249*a250);
  a280=(a280+a281);
  a280=(a010+a280);
  a281=sin(a280);
  a279=(a279*a281);
  a282=(2.*a242);
  a282=(a002-a282);
  a279=(a279*a282);
  a283=(a236*a003);
  a284=(a243*a074);
  a283=(a283+a284);
  a284=(a244*a116);
  a283=(a283+a284);
  a284=(a245*a024);
  a283=(a283+a284);
  a284=(a246*a090);
  a283=(a283+a284);
  a284=(a247*a158);
  a283=(a283+a284);
  a284=(a248*a185);
  a283=(a283+a284);
  a284=(a249*a213);
  a283=(a283+a284);
  a283=(a000+a283);
  a284=sin(a283);
  a285=cos(a280);
  a286=(a284*a285);
  a283=cos(a283);
  a287=(a283*a281);
  a286=(a286-a287);
  a287=(a007*a286);
  a279=(a279-a287);
  a288=(a284*a019);
  a279=(a279+a288);
  a289=(a018-a285);
  a289=(a021*a289);
  a289=(a289+a018);
  a290=(a279/a289);
  a291=(a285-a018);
  a291=(a007*a291);
  a292=(a291/a289);
  a293=casadi_sq(a242);
  a293=(a293*a281);
  a293=(a293+a286);
  a293=(a007*a293);
  a286=arg[2]? arg[2][20] : 0;
  a294=(a029*a286);
  a295=arg[2]? arg[2][21] : 0;
  a296=(a033*a295);
  a294=(a294+a296);
  a294=(a028*a294);
  a294=(a002+a294);
  a294=(a015*a294);
  a286=(a033*a286);
  a295=(a029*a295);
  a286=(a286-a295);
  a286=(a286+a018);
  a286=(a027*a286);
  a286=(a032-a286);
  a286=(a286+a280);
  a286=(a031*a286);
  a294=(a294+a286);
  a293=(a293-a294);
  a294=(a292*a279);
  a294=(a293-a294);
  a286=(a291*a292);
  a286=(a007-a286);
  a280=(a294/a286);
  a295=(a036*a283);
  a296=(a295/a289);
  a291=(a291*a296);
  a297=(a291/a286);
  a279=(a296*a279);
  a298=(a036*a242);
  a298=(a298*a242);
  a298=(a298*a284);
  a299=(a236*a009);
  a300=(a243*a080);
  a299=(a299+a300);
  a300=(a244*a113);
  a299=(a299+a300);
  a300=(a245*a137);
  a299=(a299+a300);
  a300=(a246*a164);
  a299=(a299+a300);
  a300=(a247*a192);
  a299=(a299+a300);
  a300=(a248*a221);
  a299=(a299+a300);
  a300=(a249*a251);
  a299=(a299+a300);
  a299=(a042+a299);
  a300=(a041*a299);
  a298=(a298+a300);
  a300=(a236*a042);
  a301=(a243*a110);
  a300=(a300+a301);
  a301=(a244*a133);
  a300=(a300+a301);
  a301=(a245*a157);
  a300=(a300+a301);
  a301=(a246*a184);
  a300=(a300+a301);
  a301=(a247*a212);
  a300=(a300+a301);
  a301=(a248*a241);
  a300=(a300+a301);
  a301=(a249*a271);
  a300=(a300+a301);
  a300=(a044+a300);
  a300=(a043*a300);
  a298=(a298+a300);
  a279=(a279-a298);
  a294=(a297*a294);
  a279=(a279-a294);
  a295=(a295*a296);
  a295=(a036-a295);
  a291=(a291*a297);
  a295=(a295-a291);
  a279=(a279/a295);
  a291=(a297*a279);
  a280=(a280-a291);
  a291=(a292*a280);
  a290=(a290-a291);
  a291=(a296*a279);
  a290=(a290+a291);
  a291=(a278*a290);
  a272=(a272+a291);
  a272=(a003+a272);
  a291=(a263*a272);
  a004=(a004+a291);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a291=(a005*a136);
  a004=(a004+a291);
  a291=(a125*a163);
  a004=(a004+a291);
  a291=(a149*a191);
  a004=(a004+a291);
  a291=(a176*a220);
  a004=(a004+a291);
  a291=(a204*a250);
  a004=(a004+a291);
  a291=(a233*a002);
  a004=(a004+a291);
  a291=(a266*a035);
  a084=(a273*a084);
  a291=(a291+a084);
  a114=(a101*a114);
  a291=(a291+a114);
  a114=(a124*a138);
  a291=(a291+a114);
  a114=(a274*a165);
  a291=(a291+a114);
  a114=(a275*a193);
  a291=(a291+a114);
  a114=(a276*a222);
  a291=(a291+a114);
  a114=(a277*a252);
  a291=(a291+a114);
  a114=(a278*a280);
  a291=(a291+a114);
  a291=(a008+a291);
  a114=(a263*a291);
  a004=(a004+a114);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a042);
  a114=(a005*a157);
  a004=(a004+a114);
  a114=(a125*a184);
  a004=(a004+a114);
  a114=(a149*a212);
  a004=(a004+a114);
  a114=(a176*a241);
  a004=(a004+a114);
  a114=(a204*a271);
  a004=(a004+a114);
  a114=(a233*a299);
  a004=(a004+a114);
  a114=(a266*a009);
  a080=(a273*a080);
  a114=(a114+a080);
  a113=(a101*a113);
  a114=(a114+a113);
  a113=(a124*a137);
  a114=(a114+a113);
  a113=(a274*a164);
  a114=(a114+a113);
  a113=(a275*a192);
  a114=(a114+a113);
  a113=(a276*a221);
  a114=(a114+a113);
  a113=(a277*a251);
  a114=(a114+a113);
  a113=(a278*a279);
  a114=(a114+a113);
  a114=(a042+a114);
  a113=(a263*a114);
  a004=(a004+a113);
  a004=(a044+a004);
  if (res[0]!=0) res[0][2]=a004;
  a023=(a001*a023);
  a148=(a005*a148);
  a023=(a023+a148);
  a175=(a125*a175);
  a023=(a023+a175);
  a203=(a149*a203);
  a023=(a023+a203);
  a232=(a176*a232);
  a023=(a023+a232);
  a262=(a204*a262);
  a023=(a023+a262);
  a290=(a233*a290);
  a023=(a023+a290);
  a290=(a007*a291);
  a262=(a266*a008);
  a232=(a273*a046);
  a262=(a262+a232);
  a232=(a101*a111);
  a262=(a262+a232);
  a232=(a124*a136);
  a262=(a262+a232);
  a232=(a274*a163);
  a262=(a262+a232);
  a232=(a275*a191);
  a262=(a262+a232);
  a232=(a276*a220);
  a262=(a262+a232);
  a232=(a277*a250);
  a262=(a262+a232);
  a232=(a278*a002);
  a262=(a262+a232);
  a010=(a010+a262);
  a262=sin(a010);
  a290=(a290*a262);
  a232=(2.*a272);
  a232=(a291-a232);
  a290=(a290*a232);
  a203=(a266*a003);
  a175=(a273*a074);
  a203=(a203+a175);
  a175=(a101*a116);
  a203=(a203+a175);
  a175=(a124*a024);
  a203=(a203+a175);
  a175=(a274*a090);
  a203=(a203+a175);
  a175=(a275*a158);
  a203=(a203+a175);
  a175=(a276*a185);
  a203=(a203+a175);
  a175=(a277*a213);
  a203=(a203+a175);
  a175=(a278*a242);
  a203=(a203+a175);
  a000=(a000+a203);
  a203=sin(a000);
  a175=cos(a010);
  a148=(a203*a175);
  a000=cos(a000);
  a004=(a000*a262);
  a148=(a148-a004);
  a004=(a007*a148);
  a290=(a290-a004);
  a019=(a203*a019);
  a290=(a290+a019);
  a113=(a018-a175);
  a113=(a021*a113);
  a113=(a113+a018);
  a080=(a290/a113);
  a084=(a175-a018);
  a084=(a007*a084);
  a294=(a084/a113);
  a300=casadi_sq(a272);
  a300=(a300*a262);
  a300=(a300+a148);
  a300=(a007*a300);
  a148=arg[2]? arg[2][22] : 0;
  a301=(a029*a148);
  a302=arg[2]? arg[2][23] : 0;
  a303=(a033*a302);
  a301=(a301+a303);
  a028=(a028*a301);
  a028=(a291+a028);
  a028=(a015*a028);
  a033=(a033*a148);
  a029=(a029*a302);
  a033=(a033-a029);
  a033=(a033+a018);
  a027=(a027*a033);
  a032=(a032-a027);
  a032=(a032+a010);
  a032=(a031*a032);
  a028=(a028+a032);
  a300=(a300-a028);
  a028=(a294*a290);
  a028=(a300-a028);
  a032=(a084*a294);
  a032=(a007-a032);
  a010=(a028/a032);
  a027=(a036*a000);
  a033=(a027/a113);
  a084=(a084*a033);
  a018=(a084/a032);
  a290=(a033*a290);
  a029=(a036*a272);
  a029=(a029*a272);
  a029=(a029*a203);
  a114=(a041*a114);
  a029=(a029+a114);
  a114=(a266*a042);
  a110=(a273*a110);
  a114=(a114+a110);
  a133=(a101*a133);
  a114=(a114+a133);
  a157=(a124*a157);
  a114=(a114+a157);
  a184=(a274*a184);
  a114=(a114+a184);
  a212=(a275*a212);
  a114=(a114+a212);
  a241=(a276*a241);
  a114=(a114+a241);
  a271=(a277*a271);
  a114=(a114+a271);
  a299=(a278*a299);
  a114=(a114+a299);
  a044=(a044+a114);
  a044=(a043*a044);
  a029=(a029+a044);
  a290=(a290-a029);
  a028=(a018*a028);
  a290=(a290-a028);
  a027=(a027*a033);
  a027=(a036-a027);
  a084=(a084*a018);
  a027=(a027-a084);
  a290=(a290/a027);
  a084=(a018*a290);
  a010=(a010-a084);
  a084=(a294*a010);
  a080=(a080-a084);
  a084=(a033*a290);
  a080=(a080+a084);
  a080=(a263*a080);
  a023=(a023+a080);
  a023=(a003+a023);
  if (res[0]!=0) res[0][3]=a023;
  a035=(a001*a035);
  a138=(a005*a138);
  a035=(a035+a138);
  a165=(a125*a165);
  a035=(a035+a165);
  a193=(a149*a193);
  a035=(a035+a193);
  a222=(a176*a222);
  a035=(a035+a222);
  a252=(a204*a252);
  a035=(a035+a252);
  a280=(a233*a280);
  a035=(a035+a280);
  a010=(a263*a010);
  a035=(a035+a010);
  a035=(a008+a035);
  if (res[0]!=0) res[0][4]=a035;
  a009=(a001*a009);
  a137=(a005*a137);
  a009=(a009+a137);
  a164=(a125*a164);
  a009=(a009+a164);
  a192=(a149*a192);
  a009=(a009+a192);
  a221=(a176*a221);
  a009=(a009+a221);
  a251=(a204*a251);
  a009=(a009+a251);
  a279=(a233*a279);
  a009=(a009+a279);
  a290=(a263*a290);
  a009=(a009+a290);
  a042=(a042+a009);
  if (res[0]!=0) res[0][5]=a042;
  a042=arg[0]? arg[0][6] : 0;
  a009=arg[0]? arg[0][9] : 0;
  a290=(a001*a009);
  a279=(a016*a014);
  a251=(a013*a011);
  a279=(a279+a251);
  a251=(a016-a279);
  a251=(a007*a251);
  a221=(a007*a011);
  a012=(a008*a012);
  a221=(a221*a012);
  a221=(a221-a017);
  a221=(a221+a020);
  a020=(a038*a221);
  a020=(a020-a040);
  a040=(a025*a221);
  a026=(a026-a040);
  a040=(a039*a026);
  a020=(a020-a040);
  a020=(a020/a037);
  a040=(a020*a036);
  a040=(a040*a013);
  a251=(a251-a040);
  a251=(a251+a016);
  a040=(a251/a022);
  a017=(a007*a279);
  a192=(a025*a251);
  a017=(a017-a192);
  a192=(a017/a034);
  a251=(a038*a251);
  a221=(a221/a022);
  a026=(a026/a034);
  a164=(a039*a020);
  a026=(a026-a164);
  a164=(a025*a026);
  a221=(a221-a164);
  a020=(a038*a020);
  a221=(a221+a020);
  a020=(a221*a013);
  a016=(a016*a003);
  a016=(a016*a003);
  a020=(a020+a016);
  a020=(a036*a020);
  a251=(a251-a020);
  a017=(a039*a017);
  a251=(a251-a017);
  a251=(a251/a037);
  a017=(a039*a251);
  a192=(a192-a017);
  a017=(a025*a192);
  a040=(a040-a017);
  a017=(a038*a251);
  a040=(a040+a017);
  a017=(a040*a042);
  a012=(a014*a012);
  a012=(a279+a012);
  a020=(2.*a221);
  a026=(a026-a020);
  a026=(a011*a026);
  a012=(a012+a026);
  a012=(a007*a012);
  a026=(a012/a022);
  a221=(a221*a011);
  a221=(a221-a279);
  a014=(a014*a003);
  a014=(a014*a003);
  a221=(a221+a014);
  a221=(a007*a221);
  a221=(a221-a031);
  a014=(a025*a012);
  a221=(a221-a014);
  a014=(a221/a034);
  a012=(a038*a012);
  a221=(a039*a221);
  a012=(a012-a221);
  a012=(a012/a037);
  a221=(a039*a012);
  a014=(a014-a221);
  a221=(a025*a014);
  a026=(a026-a221);
  a221=(a038*a012);
  a026=(a026+a221);
  a221=arg[0]? arg[0][7] : 0;
  a279=(a026*a221);
  a017=(a017+a279);
  a279=(a043/a037);
  a020=(a039*a279);
  a016=(a025*a020);
  a164=(a038*a279);
  a016=(a016+a164);
  a164=arg[0]? arg[0][8] : 0;
  a137=(a016*a164);
  a017=(a017-a137);
  a137=-2.;
  a035=(a137*a007);
  a010=(a035*a008);
  a010=(a010*a011);
  a280=(a010/a022);
  a252=(a021*a003);
  a252=(a252*a011);
  a222=(a025*a010);
  a252=(a252-a222);
  a222=(a252/a034);
  a137=(a137*a036);
  a193=(a137*a003);
  a193=(a193*a013);
  a010=(a038*a010);
  a193=(a193+a010);
  a252=(a039*a252);
  a193=(a193-a252);
  a193=(a193/a037);
  a252=(a039*a193);
  a222=(a222-a252);
  a252=(a025*a222);
  a280=(a280-a252);
  a252=(a038*a193);
  a280=(a280+a252);
  a252=(a280*a009);
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
  a008=(a039*a011);
  a034=(a034+a008);
  a008=(a025*a034);
  a022=(a022+a008);
  a008=(a038*a011);
  a022=(a022+a008);
  a008=arg[0]? arg[0][10] : 0;
  a003=(a022*a008);
  a252=(a252+a003);
  a037=(a041/a037);
  a039=(a039*a037);
  a025=(a025*a039);
  a038=(a038*a037);
  a025=(a025+a038);
  a038=arg[0]? arg[0][11] : 0;
  a003=(a025*a038);
  a252=(a252-a003);
  a017=(a017+a252);
  a252=(a006*a017);
  a003=(a094*a096);
  a010=(a095*a053);
  a003=(a003+a010);
  a010=(a094-a003);
  a010=(a007*a010);
  a013=(a007*a053);
  a093=(a046*a093);
  a013=(a013*a093);
  a013=(a013-a098);
  a013=(a013+a099);
  a099=(a107*a013);
  a099=(a099-a109);
  a109=(a103*a013);
  a104=(a104-a109);
  a109=(a108*a104);
  a099=(a099-a109);
  a099=(a099/a106);
  a109=(a099*a036);
  a109=(a109*a095);
  a010=(a010-a109);
  a010=(a010+a094);
  a109=(a010/a100);
  a098=(a007*a003);
  a165=(a103*a010);
  a098=(a098-a165);
  a165=(a098/a097);
  a010=(a107*a010);
  a013=(a013/a100);
  a104=(a104/a097);
  a138=(a108*a099);
  a104=(a104-a138);
  a138=(a103*a104);
  a013=(a013-a138);
  a099=(a107*a099);
  a013=(a013+a099);
  a099=(a013*a095);
  a094=(a094*a074);
  a094=(a094*a074);
  a099=(a099+a094);
  a099=(a036*a099);
  a010=(a010-a099);
  a098=(a108*a098);
  a010=(a010-a098);
  a010=(a010/a106);
  a098=(a108*a010);
  a165=(a165-a098);
  a098=(a103*a165);
  a109=(a109-a098);
  a098=(a107*a010);
  a109=(a109+a098);
  a098=(a045*a009);
  a099=(a048*a017);
  a094=(a058*a060);
  a138=(a059*a055);
  a094=(a094+a138);
  a138=(a058-a094);
  a138=(a007*a138);
  a023=(a007*a055);
  a057=(a052*a057);
  a023=(a023*a057);
  a023=(a023-a062);
  a023=(a023+a063);
  a063=(a071*a023);
  a063=(a063-a073);
  a073=(a067*a023);
  a068=(a068-a073);
  a073=(a072*a068);
  a063=(a063-a073);
  a063=(a063/a070);
  a073=(a063*a036);
  a073=(a073*a059);
  a138=(a138-a073);
  a138=(a138+a058);
  a073=(a138/a064);
  a062=(a007*a094);
  a080=(a067*a138);
  a062=(a062-a080);
  a080=(a062/a061);
  a138=(a071*a138);
  a023=(a023/a064);
  a068=(a068/a061);
  a084=(a072*a063);
  a068=(a068-a084);
  a084=(a067*a068);
  a023=(a023-a084);
  a063=(a071*a063);
  a023=(a023+a063);
  a063=(a023*a059);
  a058=(a058*a056);
  a058=(a058*a056);
  a063=(a063+a058);
  a063=(a036*a063);
  a138=(a138-a063);
  a062=(a072*a062);
  a138=(a138-a062);
  a138=(a138/a070);
  a062=(a072*a138);
  a080=(a080-a062);
  a062=(a067*a080);
  a073=(a073-a062);
  a062=(a071*a138);
  a073=(a073+a062);
  a062=(a051*a009);
  a062=(a042+a062);
  a063=(a073*a062);
  a057=(a060*a057);
  a057=(a094+a057);
  a058=(2.*a023);
  a068=(a068-a058);
  a068=(a055*a068);
  a057=(a057+a068);
  a057=(a007*a057);
  a068=(a057/a064);
  a023=(a023*a055);
  a023=(a023-a094);
  a060=(a060*a056);
  a060=(a060*a056);
  a023=(a023+a060);
  a023=(a007*a023);
  a023=(a023-a031);
  a060=(a067*a057);
  a023=(a023-a060);
  a060=(a023/a061);
  a057=(a071*a057);
  a023=(a072*a023);
  a057=(a057-a023);
  a057=(a057/a070);
  a023=(a072*a057);
  a060=(a060-a023);
  a023=(a067*a060);
  a068=(a068-a023);
  a023=(a071*a057);
  a068=(a068+a023);
  a023=(a051*a008);
  a023=(a221+a023);
  a094=(a068*a023);
  a063=(a063+a094);
  a094=(a043/a070);
  a058=(a072*a094);
  a084=(a067*a058);
  a028=(a071*a094);
  a084=(a084+a028);
  a028=(a051*a038);
  a028=(a164+a028);
  a044=(a084*a028);
  a063=(a063-a044);
  a044=(a035*a052);
  a044=(a044*a055);
  a114=(a044/a064);
  a299=(a021*a056);
  a299=(a299*a055);
  a271=(a067*a044);
  a299=(a299-a271);
  a271=(a299/a061);
  a241=(a137*a056);
  a241=(a241*a059);
  a044=(a071*a044);
  a241=(a241+a044);
  a299=(a072*a299);
  a241=(a241-a299);
  a241=(a241/a070);
  a299=(a072*a241);
  a271=(a271-a299);
  a299=(a067*a271);
  a114=(a114-a299);
  a299=(a071*a241);
  a114=(a114+a299);
  a299=(a051*a017);
  a299=(a009+a299);
  a044=(a114*a299);
  a055=(a021*a055);
  a052=(a052-a056);
  a055=(a055*a052);
  a064=(a055/a064);
  a052=(a067*a055);
  a052=(a015+a052);
  a061=(a052/a061);
  a055=(a071*a055);
  a052=(a072*a052);
  a055=(a055+a052);
  a055=(a055/a070);
  a052=(a072*a055);
  a061=(a061+a052);
  a052=(a067*a061);
  a064=(a064+a052);
  a052=(a071*a055);
  a064=(a064+a052);
  a052=(a192*a042);
  a056=(a014*a221);
  a052=(a052+a056);
  a056=(a020*a164);
  a052=(a052+a056);
  a056=(a222*a009);
  a059=(a034*a008);
  a056=(a056-a059);
  a059=(a039*a038);
  a056=(a056+a059);
  a052=(a052+a056);
  a056=(a051*a052);
  a056=(a008+a056);
  a059=(a064*a056);
  a044=(a044+a059);
  a070=(a041/a070);
  a072=(a072*a070);
  a067=(a067*a072);
  a071=(a071*a070);
  a067=(a067+a071);
  a071=(a251*a042);
  a059=(a012*a221);
  a071=(a071+a059);
  a059=(a279*a164);
  a071=(a071-a059);
  a059=(a193*a009);
  a212=(a011*a008);
  a059=(a059+a212);
  a212=(a037*a038);
  a059=(a059-a212);
  a071=(a071+a059);
  a059=(a051*a071);
  a059=(a038+a059);
  a212=(a067*a059);
  a044=(a044-a212);
  a063=(a063+a044);
  a063=(a050*a063);
  a099=(a099+a063);
  a099=(a009+a099);
  a063=(a047*a099);
  a098=(a098+a063);
  a098=(a042+a098);
  a063=(a109*a098);
  a093=(a096*a093);
  a093=(a003+a093);
  a044=(2.*a013);
  a104=(a104-a044);
  a104=(a053*a104);
  a093=(a093+a104);
  a093=(a007*a093);
  a104=(a093/a100);
  a013=(a013*a053);
  a013=(a013-a003);
  a096=(a096*a074);
  a096=(a096*a074);
  a013=(a013+a096);
  a013=(a007*a013);
  a013=(a013-a031);
  a096=(a103*a093);
  a013=(a013-a096);
  a096=(a013/a097);
  a093=(a107*a093);
  a013=(a108*a013);
  a093=(a093-a013);
  a093=(a093/a106);
  a013=(a108*a093);
  a096=(a096-a013);
  a013=(a103*a096);
  a104=(a104-a013);
  a013=(a107*a093);
  a104=(a104+a013);
  a013=(a045*a008);
  a003=(a048*a052);
  a044=(a080*a062);
  a212=(a060*a023);
  a044=(a044+a212);
  a212=(a058*a028);
  a044=(a044+a212);
  a212=(a271*a299);
  a184=(a061*a056);
  a212=(a212-a184);
  a184=(a072*a059);
  a212=(a212+a184);
  a044=(a044+a212);
  a044=(a050*a044);
  a003=(a003+a044);
  a003=(a008+a003);
  a044=(a047*a003);
  a013=(a013+a044);
  a013=(a221+a013);
  a044=(a104*a013);
  a063=(a063+a044);
  a044=(a043/a106);
  a212=(a108*a044);
  a184=(a103*a212);
  a157=(a107*a044);
  a184=(a184+a157);
  a157=(a045*a038);
  a133=(a048*a071);
  a062=(a138*a062);
  a023=(a057*a023);
  a062=(a062+a023);
  a028=(a094*a028);
  a062=(a062-a028);
  a028=(a241*a299);
  a023=(a055*a056);
  a028=(a028+a023);
  a023=(a070*a059);
  a028=(a028-a023);
  a062=(a062+a028);
  a062=(a050*a062);
  a133=(a133+a062);
  a133=(a038+a133);
  a062=(a047*a133);
  a157=(a157+a062);
  a157=(a164+a157);
  a062=(a184*a157);
  a063=(a063-a062);
  a062=(a035*a046);
  a062=(a062*a053);
  a028=(a062/a100);
  a023=(a021*a074);
  a023=(a023*a053);
  a110=(a103*a062);
  a023=(a023-a110);
  a110=(a023/a097);
  a302=(a137*a074);
  a302=(a302*a095);
  a062=(a107*a062);
  a302=(a302+a062);
  a023=(a108*a023);
  a302=(a302-a023);
  a302=(a302/a106);
  a023=(a108*a302);
  a110=(a110-a023);
  a023=(a103*a110);
  a028=(a028-a023);
  a023=(a107*a302);
  a028=(a028+a023);
  a023=(a045*a017);
  a062=(a075*a077);
  a095=(a076*a069);
  a062=(a062+a095);
  a095=(a075-a062);
  a095=(a007*a095);
  a148=(a007*a069);
  a082=(a079*a082);
  a148=(a148*a082);
  a148=(a148-a078);
  a148=(a148+a083);
  a083=(a088*a148);
  a083=(a083-a091);
  a091=(a066*a148);
  a065=(a065-a091);
  a091=(a089*a065);
  a083=(a083-a091);
  a083=(a083/a087);
  a091=(a083*a036);
  a091=(a091*a076);
  a095=(a095-a091);
  a095=(a095+a075);
  a091=(a095/a054);
  a078=(a007*a062);
  a301=(a066*a095);
  a078=(a078-a301);
  a301=(a078/a085);
  a095=(a088*a095);
  a148=(a148/a054);
  a065=(a065/a085);
  a303=(a089*a083);
  a065=(a065-a303);
  a303=(a066*a065);
  a148=(a148-a303);
  a083=(a088*a083);
  a148=(a148+a083);
  a083=(a148*a076);
  a075=(a075*a049);
  a075=(a075*a049);
  a083=(a083+a075);
  a083=(a036*a083);
  a095=(a095-a083);
  a078=(a089*a078);
  a095=(a095-a078);
  a095=(a095/a087);
  a078=(a089*a095);
  a301=(a301-a078);
  a078=(a066*a301);
  a091=(a091-a078);
  a078=(a088*a095);
  a091=(a091+a078);
  a078=(a048*a009);
  a299=(a050*a299);
  a078=(a078+a299);
  a078=(a042+a078);
  a299=(a091*a078);
  a082=(a077*a082);
  a082=(a062+a082);
  a083=(2.*a148);
  a065=(a065-a083);
  a065=(a069*a065);
  a082=(a082+a065);
  a082=(a007*a082);
  a065=(a082/a054);
  a148=(a148*a069);
  a148=(a148-a062);
  a077=(a077*a049);
  a077=(a077*a049);
  a148=(a148+a077);
  a148=(a007*a148);
  a148=(a148-a031);
  a077=(a066*a082);
  a148=(a148-a077);
  a077=(a148/a085);
  a082=(a088*a082);
  a148=(a089*a148);
  a082=(a082-a148);
  a082=(a082/a087);
  a148=(a089*a082);
  a077=(a077-a148);
  a148=(a066*a077);
  a065=(a065-a148);
  a148=(a088*a082);
  a065=(a065+a148);
  a148=(a048*a008);
  a056=(a050*a056);
  a148=(a148+a056);
  a148=(a221+a148);
  a056=(a065*a148);
  a299=(a299+a056);
  a056=(a043/a087);
  a062=(a089*a056);
  a083=(a066*a062);
  a075=(a088*a056);
  a083=(a083+a075);
  a075=(a048*a038);
  a059=(a050*a059);
  a075=(a075+a059);
  a075=(a164+a075);
  a059=(a083*a075);
  a299=(a299-a059);
  a059=(a035*a079);
  a059=(a059*a069);
  a303=(a059/a054);
  a304=(a021*a049);
  a304=(a304*a069);
  a305=(a066*a059);
  a304=(a304-a305);
  a305=(a304/a085);
  a306=(a137*a049);
  a306=(a306*a076);
  a059=(a088*a059);
  a306=(a306+a059);
  a304=(a089*a304);
  a306=(a306-a304);
  a306=(a306/a087);
  a304=(a089*a306);
  a305=(a305-a304);
  a304=(a066*a305);
  a303=(a303-a304);
  a304=(a088*a306);
  a303=(a303+a304);
  a304=(a303*a099);
  a069=(a021*a069);
  a079=(a079-a049);
  a069=(a069*a079);
  a054=(a069/a054);
  a079=(a066*a069);
  a079=(a015+a079);
  a085=(a079/a085);
  a069=(a088*a069);
  a079=(a089*a079);
  a069=(a069+a079);
  a069=(a069/a087);
  a079=(a089*a069);
  a085=(a085+a079);
  a079=(a066*a085);
  a054=(a054+a079);
  a079=(a088*a069);
  a054=(a054+a079);
  a079=(a054*a003);
  a304=(a304+a079);
  a087=(a041/a087);
  a089=(a089*a087);
  a066=(a066*a089);
  a088=(a088*a087);
  a066=(a066+a088);
  a088=(a066*a133);
  a304=(a304-a088);
  a299=(a299+a304);
  a304=(a047*a299);
  a023=(a023+a304);
  a023=(a009+a023);
  a304=(a028*a023);
  a053=(a021*a053);
  a046=(a046-a074);
  a053=(a053*a046);
  a100=(a053/a100);
  a046=(a103*a053);
  a046=(a015+a046);
  a097=(a046/a097);
  a053=(a107*a053);
  a046=(a108*a046);
  a053=(a053+a046);
  a053=(a053/a106);
  a046=(a108*a053);
  a097=(a097+a046);
  a046=(a103*a097);
  a100=(a100+a046);
  a046=(a107*a053);
  a100=(a100+a046);
  a046=(a045*a052);
  a074=(a301*a078);
  a088=(a077*a148);
  a074=(a074+a088);
  a088=(a062*a075);
  a074=(a074+a088);
  a088=(a305*a099);
  a079=(a085*a003);
  a088=(a088-a079);
  a079=(a089*a133);
  a088=(a088+a079);
  a074=(a074+a088);
  a088=(a047*a074);
  a046=(a046+a088);
  a046=(a008+a046);
  a088=(a100*a046);
  a304=(a304+a088);
  a106=(a041/a106);
  a108=(a108*a106);
  a103=(a103*a108);
  a107=(a107*a106);
  a103=(a103+a107);
  a107=(a045*a071);
  a078=(a095*a078);
  a148=(a082*a148);
  a078=(a078+a148);
  a075=(a056*a075);
  a078=(a078-a075);
  a075=(a306*a099);
  a148=(a069*a003);
  a075=(a075+a148);
  a148=(a087*a133);
  a075=(a075-a148);
  a078=(a078+a075);
  a075=(a047*a078);
  a107=(a107+a075);
  a107=(a038+a107);
  a075=(a103*a107);
  a304=(a304-a075);
  a063=(a063+a304);
  a304=(a030*a063);
  a252=(a252+a304);
  a304=(a117*a119);
  a075=(a118*a115);
  a304=(a304+a075);
  a075=(a117-a304);
  a075=(a007*a075);
  a148=(a007*a115);
  a081=(a111*a081);
  a148=(a148*a081);
  a148=(a148-a121);
  a148=(a148+a122);
  a122=(a130*a148);
  a122=(a122-a132);
  a132=(a126*a148);
  a127=(a127-a132);
  a132=(a131*a127);
  a122=(a122-a132);
  a122=(a122/a129);
  a132=(a122*a036);
  a132=(a132*a118);
  a075=(a075-a132);
  a075=(a075+a117);
  a132=(a075/a123);
  a121=(a007*a304);
  a088=(a126*a075);
  a121=(a121-a088);
  a088=(a121/a120);
  a075=(a130*a075);
  a148=(a148/a123);
  a127=(a127/a120);
  a079=(a131*a122);
  a127=(a127-a079);
  a079=(a126*a127);
  a148=(a148-a079);
  a122=(a130*a122);
  a148=(a148+a122);
  a122=(a148*a118);
  a117=(a117*a116);
  a117=(a117*a116);
  a122=(a122+a117);
  a122=(a036*a122);
  a075=(a075-a122);
  a121=(a131*a121);
  a075=(a075-a121);
  a075=(a075/a129);
  a121=(a131*a075);
  a088=(a088-a121);
  a121=(a126*a088);
  a132=(a132-a121);
  a121=(a130*a075);
  a132=(a132+a121);
  a121=(a105*a009);
  a099=(a112*a099);
  a121=(a121+a099);
  a099=(a086*a023);
  a121=(a121+a099);
  a121=(a042+a121);
  a099=(a132*a121);
  a081=(a119*a081);
  a081=(a304+a081);
  a122=(2.*a148);
  a127=(a127-a122);
  a127=(a115*a127);
  a081=(a081+a127);
  a081=(a007*a081);
  a127=(a081/a123);
  a148=(a148*a115);
  a148=(a148-a304);
  a119=(a119*a116);
  a119=(a119*a116);
  a148=(a148+a119);
  a148=(a007*a148);
  a148=(a148-a031);
  a119=(a126*a081);
  a148=(a148-a119);
  a119=(a148/a120);
  a081=(a130*a081);
  a148=(a131*a148);
  a081=(a081-a148);
  a081=(a081/a129);
  a148=(a131*a081);
  a119=(a119-a148);
  a148=(a126*a119);
  a127=(a127-a148);
  a148=(a130*a081);
  a127=(a127+a148);
  a148=(a105*a008);
  a003=(a112*a003);
  a148=(a148+a003);
  a003=(a086*a046);
  a148=(a148+a003);
  a148=(a221+a148);
  a003=(a127*a148);
  a099=(a099+a003);
  a003=(a043/a129);
  a304=(a131*a003);
  a122=(a126*a304);
  a117=(a130*a003);
  a122=(a122+a117);
  a117=(a105*a038);
  a133=(a112*a133);
  a117=(a117+a133);
  a133=(a086*a107);
  a117=(a117+a133);
  a117=(a164+a117);
  a133=(a122*a117);
  a099=(a099-a133);
  a133=(a035*a111);
  a133=(a133*a115);
  a079=(a133/a123);
  a049=(a021*a116);
  a049=(a049*a115);
  a059=(a126*a133);
  a049=(a049-a059);
  a059=(a049/a120);
  a076=(a137*a116);
  a076=(a076*a118);
  a133=(a130*a133);
  a076=(a076+a133);
  a049=(a131*a049);
  a076=(a076-a049);
  a076=(a076/a129);
  a049=(a131*a076);
  a059=(a059-a049);
  a049=(a126*a059);
  a079=(a079-a049);
  a049=(a130*a076);
  a079=(a079+a049);
  a049=(a105*a017);
  a299=(a112*a299);
  a049=(a049+a299);
  a299=(a086*a063);
  a049=(a049+a299);
  a049=(a009+a049);
  a299=(a079*a049);
  a115=(a021*a115);
  a111=(a111-a116);
  a115=(a115*a111);
  a123=(a115/a123);
  a111=(a126*a115);
  a111=(a015+a111);
  a120=(a111/a120);
  a115=(a130*a115);
  a111=(a131*a111);
  a115=(a115+a111);
  a115=(a115/a129);
  a111=(a131*a115);
  a120=(a120+a111);
  a111=(a126*a120);
  a123=(a123+a111);
  a111=(a130*a115);
  a123=(a123+a111);
  a111=(a105*a052);
  a074=(a112*a074);
  a111=(a111+a074);
  a074=(a165*a098);
  a116=(a096*a013);
  a074=(a074+a116);
  a116=(a212*a157);
  a074=(a074+a116);
  a116=(a110*a023);
  a133=(a097*a046);
  a116=(a116-a133);
  a133=(a108*a107);
  a116=(a116+a133);
  a074=(a074+a116);
  a116=(a086*a074);
  a111=(a111+a116);
  a111=(a008+a111);
  a116=(a123*a111);
  a299=(a299+a116);
  a129=(a041/a129);
  a131=(a131*a129);
  a126=(a126*a131);
  a130=(a130*a129);
  a126=(a126+a130);
  a130=(a105*a071);
  a078=(a112*a078);
  a130=(a130+a078);
  a098=(a010*a098);
  a013=(a093*a013);
  a098=(a098+a013);
  a157=(a044*a157);
  a098=(a098-a157);
  a157=(a302*a023);
  a013=(a053*a046);
  a157=(a157+a013);
  a013=(a106*a107);
  a157=(a157-a013);
  a098=(a098+a157);
  a157=(a086*a098);
  a130=(a130+a157);
  a130=(a038+a130);
  a157=(a126*a130);
  a299=(a299-a157);
  a099=(a099+a299);
  a299=(a102*a099);
  a252=(a252+a299);
  a252=(a009+a252);
  a299=(a005*a252);
  a290=(a290+a299);
  a299=(a128*a017);
  a157=(a092*a063);
  a299=(a299+a157);
  a157=(a134*a099);
  a299=(a299+a157);
  a157=(a141*a143);
  a013=(a142*a139);
  a157=(a157+a013);
  a013=(a141-a157);
  a013=(a007*a013);
  a078=(a007*a139);
  a140=(a136*a140);
  a078=(a078*a140);
  a078=(a078-a145);
  a078=(a078+a146);
  a146=(a154*a078);
  a146=(a146-a156);
  a156=(a150*a078);
  a151=(a151-a156);
  a156=(a155*a151);
  a146=(a146-a156);
  a146=(a146/a153);
  a156=(a146*a036);
  a156=(a156*a142);
  a013=(a013-a156);
  a013=(a013+a141);
  a156=(a013/a147);
  a145=(a007*a157);
  a116=(a150*a013);
  a145=(a145-a116);
  a116=(a145/a144);
  a013=(a154*a013);
  a078=(a078/a147);
  a151=(a151/a144);
  a133=(a155*a146);
  a151=(a151-a133);
  a133=(a150*a151);
  a078=(a078-a133);
  a146=(a154*a146);
  a078=(a078+a146);
  a146=(a078*a142);
  a141=(a141*a024);
  a141=(a141*a024);
  a146=(a146+a141);
  a146=(a036*a146);
  a013=(a013-a146);
  a145=(a155*a145);
  a013=(a013-a145);
  a013=(a013/a153);
  a145=(a155*a013);
  a116=(a116-a145);
  a145=(a150*a116);
  a156=(a156-a145);
  a145=(a154*a013);
  a156=(a156+a145);
  a145=(a006*a009);
  a146=(a030*a023);
  a145=(a145+a146);
  a146=(a102*a049);
  a145=(a145+a146);
  a145=(a042+a145);
  a146=(a156*a145);
  a140=(a143*a140);
  a140=(a157+a140);
  a141=(2.*a078);
  a151=(a151-a141);
  a151=(a139*a151);
  a140=(a140+a151);
  a140=(a007*a140);
  a151=(a140/a147);
  a078=(a078*a139);
  a078=(a078-a157);
  a143=(a143*a024);
  a143=(a143*a024);
  a078=(a078+a143);
  a078=(a007*a078);
  a078=(a078-a031);
  a143=(a150*a140);
  a078=(a078-a143);
  a143=(a078/a144);
  a140=(a154*a140);
  a078=(a155*a078);
  a140=(a140-a078);
  a140=(a140/a153);
  a078=(a155*a140);
  a143=(a143-a078);
  a078=(a150*a143);
  a151=(a151-a078);
  a078=(a154*a140);
  a151=(a151+a078);
  a078=(a006*a008);
  a157=(a030*a046);
  a078=(a078+a157);
  a157=(a102*a111);
  a078=(a078+a157);
  a078=(a221+a078);
  a157=(a151*a078);
  a146=(a146+a157);
  a157=(a043/a153);
  a141=(a155*a157);
  a133=(a150*a141);
  a118=(a154*a157);
  a133=(a133+a118);
  a118=(a006*a038);
  a307=(a030*a107);
  a118=(a118+a307);
  a307=(a102*a130);
  a118=(a118+a307);
  a118=(a164+a118);
  a307=(a133*a118);
  a146=(a146-a307);
  a307=(a035*a136);
  a307=(a307*a139);
  a308=(a307/a147);
  a309=(a021*a024);
  a309=(a309*a139);
  a310=(a150*a307);
  a309=(a309-a310);
  a310=(a309/a144);
  a311=(a137*a024);
  a311=(a311*a142);
  a307=(a154*a307);
  a311=(a311+a307);
  a309=(a155*a309);
  a311=(a311-a309);
  a311=(a311/a153);
  a309=(a155*a311);
  a310=(a310-a309);
  a309=(a150*a310);
  a308=(a308-a309);
  a309=(a154*a311);
  a308=(a308+a309);
  a309=(a308*a252);
  a139=(a021*a139);
  a136=(a136-a024);
  a139=(a139*a136);
  a147=(a139/a147);
  a136=(a150*a139);
  a136=(a015+a136);
  a144=(a136/a144);
  a139=(a154*a139);
  a136=(a155*a136);
  a139=(a139+a136);
  a139=(a139/a153);
  a136=(a155*a139);
  a144=(a144+a136);
  a136=(a150*a144);
  a147=(a147+a136);
  a136=(a154*a139);
  a147=(a147+a136);
  a136=(a006*a052);
  a024=(a030*a074);
  a136=(a136+a024);
  a024=(a088*a121);
  a307=(a119*a148);
  a024=(a024+a307);
  a307=(a304*a117);
  a024=(a024+a307);
  a307=(a059*a049);
  a142=(a120*a111);
  a307=(a307-a142);
  a142=(a131*a130);
  a307=(a307+a142);
  a024=(a024+a307);
  a307=(a102*a024);
  a136=(a136+a307);
  a136=(a008+a136);
  a307=(a147*a136);
  a309=(a309+a307);
  a153=(a041/a153);
  a155=(a155*a153);
  a150=(a150*a155);
  a154=(a154*a153);
  a150=(a150+a154);
  a154=(a006*a071);
  a307=(a030*a098);
  a154=(a154+a307);
  a121=(a075*a121);
  a148=(a081*a148);
  a121=(a121+a148);
  a117=(a003*a117);
  a121=(a121-a117);
  a117=(a076*a049);
  a148=(a115*a111);
  a117=(a117+a148);
  a148=(a129*a130);
  a117=(a117-a148);
  a121=(a121+a117);
  a117=(a102*a121);
  a154=(a154+a117);
  a154=(a038+a154);
  a117=(a150*a154);
  a309=(a309-a117);
  a146=(a146+a309);
  a309=(a135*a146);
  a299=(a299+a309);
  a299=(a009+a299);
  a309=(a125*a299);
  a290=(a290+a309);
  a309=(a152*a017);
  a117=(a159*a063);
  a309=(a309+a117);
  a117=(a160*a099);
  a309=(a309+a117);
  a117=(a161*a146);
  a309=(a309+a117);
  a117=(a168*a170);
  a148=(a169*a166);
  a117=(a117+a148);
  a148=(a168-a117);
  a148=(a007*a148);
  a307=(a007*a166);
  a167=(a163*a167);
  a307=(a307*a167);
  a307=(a307-a172);
  a307=(a307+a173);
  a173=(a181*a307);
  a173=(a173-a183);
  a183=(a177*a307);
  a178=(a178-a183);
  a183=(a182*a178);
  a173=(a173-a183);
  a173=(a173/a180);
  a183=(a173*a036);
  a183=(a183*a169);
  a148=(a148-a183);
  a148=(a148+a168);
  a183=(a148/a174);
  a172=(a007*a117);
  a142=(a177*a148);
  a172=(a172-a142);
  a142=(a172/a171);
  a148=(a181*a148);
  a307=(a307/a174);
  a178=(a178/a171);
  a312=(a182*a173);
  a178=(a178-a312);
  a312=(a177*a178);
  a307=(a307-a312);
  a173=(a181*a173);
  a307=(a307+a173);
  a173=(a307*a169);
  a168=(a168*a090);
  a168=(a168*a090);
  a173=(a173+a168);
  a173=(a036*a173);
  a148=(a148-a173);
  a172=(a182*a172);
  a148=(a148-a172);
  a148=(a148/a180);
  a172=(a182*a148);
  a142=(a142-a172);
  a172=(a177*a142);
  a183=(a183-a172);
  a172=(a181*a148);
  a183=(a183+a172);
  a172=(a128*a009);
  a173=(a092*a023);
  a172=(a172+a173);
  a173=(a134*a049);
  a172=(a172+a173);
  a173=(a135*a252);
  a172=(a172+a173);
  a172=(a042+a172);
  a173=(a183*a172);
  a167=(a170*a167);
  a167=(a117+a167);
  a168=(2.*a307);
  a178=(a178-a168);
  a178=(a166*a178);
  a167=(a167+a178);
  a167=(a007*a167);
  a178=(a167/a174);
  a307=(a307*a166);
  a307=(a307-a117);
  a170=(a170*a090);
  a170=(a170*a090);
  a307=(a307+a170);
  a307=(a007*a307);
  a307=(a307-a031);
  a170=(a177*a167);
  a307=(a307-a170);
  a170=(a307/a171);
  a167=(a181*a167);
  a307=(a182*a307);
  a167=(a167-a307);
  a167=(a167/a180);
  a307=(a182*a167);
  a170=(a170-a307);
  a307=(a177*a170);
  a178=(a178-a307);
  a307=(a181*a167);
  a178=(a178+a307);
  a307=(a128*a008);
  a117=(a092*a046);
  a307=(a307+a117);
  a117=(a134*a111);
  a307=(a307+a117);
  a117=(a135*a136);
  a307=(a307+a117);
  a307=(a221+a307);
  a117=(a178*a307);
  a173=(a173+a117);
  a117=(a043/a180);
  a168=(a182*a117);
  a312=(a177*a168);
  a313=(a181*a117);
  a312=(a312+a313);
  a313=(a128*a038);
  a314=(a092*a107);
  a313=(a313+a314);
  a314=(a134*a130);
  a313=(a313+a314);
  a314=(a135*a154);
  a313=(a313+a314);
  a313=(a164+a313);
  a314=(a312*a313);
  a173=(a173-a314);
  a314=(a035*a163);
  a314=(a314*a166);
  a315=(a314/a174);
  a316=(a021*a090);
  a316=(a316*a166);
  a317=(a177*a314);
  a316=(a316-a317);
  a317=(a316/a171);
  a318=(a137*a090);
  a318=(a318*a169);
  a314=(a181*a314);
  a318=(a318+a314);
  a316=(a182*a316);
  a318=(a318-a316);
  a318=(a318/a180);
  a316=(a182*a318);
  a317=(a317-a316);
  a316=(a177*a317);
  a315=(a315-a316);
  a316=(a181*a318);
  a315=(a315+a316);
  a316=(a315*a299);
  a166=(a021*a166);
  a163=(a163-a090);
  a166=(a166*a163);
  a174=(a166/a174);
  a163=(a177*a166);
  a163=(a015+a163);
  a171=(a163/a171);
  a166=(a181*a166);
  a163=(a182*a163);
  a166=(a166+a163);
  a166=(a166/a180);
  a163=(a182*a166);
  a171=(a171+a163);
  a163=(a177*a171);
  a174=(a174+a163);
  a163=(a181*a166);
  a174=(a174+a163);
  a163=(a128*a052);
  a090=(a092*a074);
  a163=(a163+a090);
  a090=(a134*a024);
  a163=(a163+a090);
  a090=(a116*a145);
  a314=(a143*a078);
  a090=(a090+a314);
  a314=(a141*a118);
  a090=(a090+a314);
  a314=(a310*a252);
  a169=(a144*a136);
  a314=(a314-a169);
  a169=(a155*a154);
  a314=(a314+a169);
  a090=(a090+a314);
  a314=(a135*a090);
  a163=(a163+a314);
  a163=(a008+a163);
  a314=(a174*a163);
  a316=(a316+a314);
  a180=(a041/a180);
  a182=(a182*a180);
  a177=(a177*a182);
  a181=(a181*a180);
  a177=(a177+a181);
  a181=(a128*a071);
  a314=(a092*a098);
  a181=(a181+a314);
  a314=(a134*a121);
  a181=(a181+a314);
  a145=(a013*a145);
  a078=(a140*a078);
  a145=(a145+a078);
  a118=(a157*a118);
  a145=(a145-a118);
  a118=(a311*a252);
  a078=(a139*a136);
  a118=(a118+a078);
  a078=(a153*a154);
  a118=(a118-a078);
  a145=(a145+a118);
  a118=(a135*a145);
  a181=(a181+a118);
  a181=(a038+a181);
  a118=(a177*a181);
  a316=(a316-a118);
  a173=(a173+a316);
  a316=(a162*a173);
  a309=(a309+a316);
  a309=(a009+a309);
  a316=(a149*a309);
  a290=(a290+a316);
  a316=(a179*a017);
  a118=(a186*a063);
  a316=(a316+a118);
  a118=(a187*a099);
  a316=(a316+a118);
  a118=(a188*a146);
  a316=(a316+a118);
  a118=(a189*a173);
  a316=(a316+a118);
  a118=(a196*a198);
  a078=(a197*a194);
  a118=(a118+a078);
  a078=(a196-a118);
  a078=(a007*a078);
  a314=(a007*a194);
  a195=(a191*a195);
  a314=(a314*a195);
  a314=(a314-a200);
  a314=(a314+a201);
  a201=(a209*a314);
  a201=(a201-a211);
  a211=(a205*a314);
  a206=(a206-a211);
  a211=(a210*a206);
  a201=(a201-a211);
  a201=(a201/a208);
  a211=(a201*a036);
  a211=(a211*a197);
  a078=(a078-a211);
  a078=(a078+a196);
  a211=(a078/a202);
  a200=(a007*a118);
  a169=(a205*a078);
  a200=(a200-a169);
  a169=(a200/a199);
  a078=(a209*a078);
  a314=(a314/a202);
  a206=(a206/a199);
  a319=(a210*a201);
  a206=(a206-a319);
  a319=(a205*a206);
  a314=(a314-a319);
  a201=(a209*a201);
  a314=(a314+a201);
  a201=(a314*a197);
  a196=(a196*a158);
  a196=(a196*a158);
  a201=(a201+a196);
  a201=(a036*a201);
  a078=(a078-a201);
  a200=(a210*a200);
  a078=(a078-a200);
  a078=(a078/a208);
  a200=(a210*a078);
  a169=(a169-a200);
  a200=(a205*a169);
  a211=(a211-a200);
  a200=(a209*a078);
  a211=(a211+a200);
  a200=(a152*a009);
  a201=(a159*a023);
  a200=(a200+a201);
  a201=(a160*a049);
  a200=(a200+a201);
  a201=(a161*a252);
  a200=(a200+a201);
  a201=(a162*a299);
  a200=(a200+a201);
  a200=(a042+a200);
  a201=(a211*a200);
  a195=(a198*a195);
  a195=(a118+a195);
  a196=(2.*a314);
  a206=(a206-a196);
  a206=(a194*a206);
  a195=(a195+a206);
  a195=(a007*a195);
  a206=(a195/a202);
  a314=(a314*a194);
  a314=(a314-a118);
  a198=(a198*a158);
  a198=(a198*a158);
  a314=(a314+a198);
  a314=(a007*a314);
  a314=(a314-a031);
  a198=(a205*a195);
  a314=(a314-a198);
  a198=(a314/a199);
  a195=(a209*a195);
  a314=(a210*a314);
  a195=(a195-a314);
  a195=(a195/a208);
  a314=(a210*a195);
  a198=(a198-a314);
  a314=(a205*a198);
  a206=(a206-a314);
  a314=(a209*a195);
  a206=(a206+a314);
  a314=(a152*a008);
  a118=(a159*a046);
  a314=(a314+a118);
  a118=(a160*a111);
  a314=(a314+a118);
  a118=(a161*a136);
  a314=(a314+a118);
  a118=(a162*a163);
  a314=(a314+a118);
  a314=(a221+a314);
  a118=(a206*a314);
  a201=(a201+a118);
  a118=(a043/a208);
  a196=(a210*a118);
  a319=(a205*a196);
  a320=(a209*a118);
  a319=(a319+a320);
  a320=(a152*a038);
  a321=(a159*a107);
  a320=(a320+a321);
  a321=(a160*a130);
  a320=(a320+a321);
  a321=(a161*a154);
  a320=(a320+a321);
  a321=(a162*a181);
  a320=(a320+a321);
  a320=(a164+a320);
  a321=(a319*a320);
  a201=(a201-a321);
  a321=(a035*a191);
  a321=(a321*a194);
  a322=(a321/a202);
  a323=(a021*a158);
  a323=(a323*a194);
  a324=(a205*a321);
  a323=(a323-a324);
  a324=(a323/a199);
  a325=(a137*a158);
  a325=(a325*a197);
  a321=(a209*a321);
  a325=(a325+a321);
  a323=(a210*a323);
  a325=(a325-a323);
  a325=(a325/a208);
  a323=(a210*a325);
  a324=(a324-a323);
  a323=(a205*a324);
  a322=(a322-a323);
  a323=(a209*a325);
  a322=(a322+a323);
  a323=(a322*a309);
  a194=(a021*a194);
  a191=(a191-a158);
  a194=(a194*a191);
  a202=(a194/a202);
  a191=(a205*a194);
  a191=(a015+a191);
  a199=(a191/a199);
  a194=(a209*a194);
  a191=(a210*a191);
  a194=(a194+a191);
  a194=(a194/a208);
  a191=(a210*a194);
  a199=(a199+a191);
  a191=(a205*a199);
  a202=(a202+a191);
  a191=(a209*a194);
  a202=(a202+a191);
  a191=(a152*a052);
  a158=(a159*a074);
  a191=(a191+a158);
  a158=(a160*a024);
  a191=(a191+a158);
  a158=(a161*a090);
  a191=(a191+a158);
  a158=(a142*a172);
  a321=(a170*a307);
  a158=(a158+a321);
  a321=(a168*a313);
  a158=(a158+a321);
  a321=(a317*a299);
  a197=(a171*a163);
  a321=(a321-a197);
  a197=(a182*a181);
  a321=(a321+a197);
  a158=(a158+a321);
  a321=(a162*a158);
  a191=(a191+a321);
  a191=(a008+a191);
  a321=(a202*a191);
  a323=(a323+a321);
  a208=(a041/a208);
  a210=(a210*a208);
  a205=(a205*a210);
  a209=(a209*a208);
  a205=(a205+a209);
  a209=(a152*a071);
  a321=(a159*a098);
  a209=(a209+a321);
  a321=(a160*a121);
  a209=(a209+a321);
  a321=(a161*a145);
  a209=(a209+a321);
  a172=(a148*a172);
  a307=(a167*a307);
  a172=(a172+a307);
  a313=(a117*a313);
  a172=(a172-a313);
  a313=(a318*a299);
  a307=(a166*a163);
  a313=(a313+a307);
  a307=(a180*a181);
  a313=(a313-a307);
  a172=(a172+a313);
  a313=(a162*a172);
  a209=(a209+a313);
  a209=(a038+a209);
  a313=(a205*a209);
  a323=(a323-a313);
  a201=(a201+a323);
  a323=(a190*a201);
  a316=(a316+a323);
  a316=(a009+a316);
  a323=(a176*a316);
  a290=(a290+a323);
  a323=(a207*a017);
  a313=(a214*a063);
  a323=(a323+a313);
  a313=(a215*a099);
  a323=(a323+a313);
  a313=(a216*a146);
  a323=(a323+a313);
  a313=(a217*a173);
  a323=(a323+a313);
  a313=(a218*a201);
  a323=(a323+a313);
  a313=(a225*a227);
  a307=(a226*a223);
  a313=(a313+a307);
  a307=(a225-a313);
  a307=(a007*a307);
  a321=(a007*a223);
  a224=(a220*a224);
  a321=(a321*a224);
  a321=(a321-a229);
  a321=(a321+a230);
  a230=(a238*a321);
  a230=(a230-a240);
  a240=(a234*a321);
  a235=(a235-a240);
  a240=(a239*a235);
  a230=(a230-a240);
  a230=(a230/a237);
  a240=(a230*a036);
  a240=(a240*a226);
  a307=(a307-a240);
  a307=(a307+a225);
  a240=(a307/a231);
  a229=(a007*a313);
  a197=(a234*a307);
  a229=(a229-a197);
  a197=(a229/a228);
  a307=(a238*a307);
  a321=(a321/a231);
  a235=(a235/a228);
  a326=(a239*a230);
  a235=(a235-a326);
  a326=(a234*a235);
  a321=(a321-a326);
  a230=(a238*a230);
  a321=(a321+a230);
  a230=(a321*a226);
  a225=(a225*a185);
  a225=(a225*a185);
  a230=(a230+a225);
  a230=(a036*a230);
  a307=(a307-a230);
  a229=(a239*a229);
  a307=(a307-a229);
  a307=(a307/a237);
  a229=(a239*a307);
  a197=(a197-a229);
  a229=(a234*a197);
  a240=(a240-a229);
  a229=(a238*a307);
  a240=(a240+a229);
  a229=(a179*a009);
  a230=(a186*a023);
  a229=(a229+a230);
  a230=(a187*a049);
  a229=(a229+a230);
  a230=(a188*a252);
  a229=(a229+a230);
  a230=(a189*a299);
  a229=(a229+a230);
  a230=(a190*a309);
  a229=(a229+a230);
  a229=(a042+a229);
  a230=(a240*a229);
  a224=(a227*a224);
  a224=(a313+a224);
  a225=(2.*a321);
  a235=(a235-a225);
  a235=(a223*a235);
  a224=(a224+a235);
  a224=(a007*a224);
  a235=(a224/a231);
  a321=(a321*a223);
  a321=(a321-a313);
  a227=(a227*a185);
  a227=(a227*a185);
  a321=(a321+a227);
  a321=(a007*a321);
  a321=(a321-a031);
  a227=(a234*a224);
  a321=(a321-a227);
  a227=(a321/a228);
  a224=(a238*a224);
  a321=(a239*a321);
  a224=(a224-a321);
  a224=(a224/a237);
  a321=(a239*a224);
  a227=(a227-a321);
  a321=(a234*a227);
  a235=(a235-a321);
  a321=(a238*a224);
  a235=(a235+a321);
  a321=(a179*a008);
  a313=(a186*a046);
  a321=(a321+a313);
  a313=(a187*a111);
  a321=(a321+a313);
  a313=(a188*a136);
  a321=(a321+a313);
  a313=(a189*a163);
  a321=(a321+a313);
  a313=(a190*a191);
  a321=(a321+a313);
  a321=(a221+a321);
  a313=(a235*a321);
  a230=(a230+a313);
  a313=(a043/a237);
  a225=(a239*a313);
  a326=(a234*a225);
  a327=(a238*a313);
  a326=(a326+a327);
  a327=(a179*a038);
  a328=(a186*a107);
  a327=(a327+a328);
  a328=(a187*a130);
  a327=(a327+a328);
  a328=(a188*a154);
  a327=(a327+a328);
  a328=(a189*a181);
  a327=(a327+a328);
  a328=(a190*a209);
  a327=(a327+a328);
  a327=(a164+a327);
  a328=(a326*a327);
  a230=(a230-a328);
  a328=(a035*a220);
  a328=(a328*a223);
  a329=(a328/a231);
  a330=(a021*a185);
  a330=(a330*a223);
  a331=(a234*a328);
  a330=(a330-a331);
  a331=(a330/a228);
  a332=(a137*a185);
  a332=(a332*a226);
  a328=(a238*a328);
  a332=(a332+a328);
  a330=(a239*a330);
  a332=(a332-a330);
  a332=(a332/a237);
  a330=(a239*a332);
  a331=(a331-a330);
  a330=(a234*a331);
  a329=(a329-a330);
  a330=(a238*a332);
  a329=(a329+a330);
  a330=(a329*a316);
  a223=(a021*a223);
  a220=(a220-a185);
  a223=(a223*a220);
  a231=(a223/a231);
  a220=(a234*a223);
  a220=(a015+a220);
  a228=(a220/a228);
  a223=(a238*a223);
  a220=(a239*a220);
  a223=(a223+a220);
  a223=(a223/a237);
  a220=(a239*a223);
  a228=(a228+a220);
  a220=(a234*a228);
  a231=(a231+a220);
  a220=(a238*a223);
  a231=(a231+a220);
  a220=(a179*a052);
  a185=(a186*a074);
  a220=(a220+a185);
  a185=(a187*a024);
  a220=(a220+a185);
  a185=(a188*a090);
  a220=(a220+a185);
  a185=(a189*a158);
  a220=(a220+a185);
  a185=(a169*a200);
  a328=(a198*a314);
  a185=(a185+a328);
  a328=(a196*a320);
  a185=(a185+a328);
  a328=(a324*a309);
  a226=(a199*a191);
  a328=(a328-a226);
  a226=(a210*a209);
  a328=(a328+a226);
  a185=(a185+a328);
  a328=(a190*a185);
  a220=(a220+a328);
  a220=(a008+a220);
  a328=(a231*a220);
  a330=(a330+a328);
  a237=(a041/a237);
  a239=(a239*a237);
  a234=(a234*a239);
  a238=(a238*a237);
  a234=(a234+a238);
  a238=(a179*a071);
  a328=(a186*a098);
  a238=(a238+a328);
  a328=(a187*a121);
  a238=(a238+a328);
  a328=(a188*a145);
  a238=(a238+a328);
  a328=(a189*a172);
  a238=(a238+a328);
  a200=(a078*a200);
  a314=(a195*a314);
  a200=(a200+a314);
  a320=(a118*a320);
  a200=(a200-a320);
  a320=(a325*a309);
  a314=(a194*a191);
  a320=(a320+a314);
  a314=(a208*a209);
  a320=(a320-a314);
  a200=(a200+a320);
  a320=(a190*a200);
  a238=(a238+a320);
  a238=(a038+a238);
  a320=(a234*a238);
  a330=(a330-a320);
  a230=(a230+a330);
  a330=(a219*a230);
  a323=(a323+a330);
  a323=(a009+a323);
  a330=(a204*a323);
  a290=(a290+a330);
  a330=(a236*a017);
  a320=(a243*a063);
  a330=(a330+a320);
  a320=(a244*a099);
  a330=(a330+a320);
  a320=(a245*a146);
  a330=(a330+a320);
  a320=(a246*a173);
  a330=(a330+a320);
  a320=(a247*a201);
  a330=(a330+a320);
  a320=(a248*a230);
  a330=(a330+a320);
  a320=(a255*a257);
  a314=(a256*a253);
  a320=(a320+a314);
  a314=(a255-a320);
  a314=(a007*a314);
  a328=(a007*a253);
  a254=(a250*a254);
  a328=(a328*a254);
  a328=(a328-a259);
  a328=(a328+a260);
  a260=(a268*a328);
  a260=(a260-a270);
  a270=(a264*a328);
  a265=(a265-a270);
  a270=(a269*a265);
  a260=(a260-a270);
  a260=(a260/a267);
  a270=(a260*a036);
  a270=(a270*a256);
  a314=(a314-a270);
  a314=(a314+a255);
  a270=(a314/a261);
  a259=(a007*a320);
  a226=(a264*a314);
  a259=(a259-a226);
  a226=(a259/a258);
  a314=(a268*a314);
  a328=(a328/a261);
  a265=(a265/a258);
  a333=(a269*a260);
  a265=(a265-a333);
  a333=(a264*a265);
  a328=(a328-a333);
  a260=(a268*a260);
  a328=(a328+a260);
  a260=(a328*a256);
  a255=(a255*a213);
  a255=(a255*a213);
  a260=(a260+a255);
  a260=(a036*a260);
  a314=(a314-a260);
  a259=(a269*a259);
  a314=(a314-a259);
  a314=(a314/a267);
  a259=(a269*a314);
  a226=(a226-a259);
  a259=(a264*a226);
  a270=(a270-a259);
  a259=(a268*a314);
  a270=(a270+a259);
  a259=(a207*a009);
  a260=(a214*a023);
  a259=(a259+a260);
  a260=(a215*a049);
  a259=(a259+a260);
  a260=(a216*a252);
  a259=(a259+a260);
  a260=(a217*a299);
  a259=(a259+a260);
  a260=(a218*a309);
  a259=(a259+a260);
  a260=(a219*a316);
  a259=(a259+a260);
  a259=(a042+a259);
  a260=(a270*a259);
  a254=(a257*a254);
  a254=(a320+a254);
  a255=(2.*a328);
  a265=(a265-a255);
  a265=(a253*a265);
  a254=(a254+a265);
  a254=(a007*a254);
  a265=(a254/a261);
  a328=(a328*a253);
  a328=(a328-a320);
  a257=(a257*a213);
  a257=(a257*a213);
  a328=(a328+a257);
  a328=(a007*a328);
  a328=(a328-a031);
  a257=(a264*a254);
  a328=(a328-a257);
  a257=(a328/a258);
  a254=(a268*a254);
  a328=(a269*a328);
  a254=(a254-a328);
  a254=(a254/a267);
  a328=(a269*a254);
  a257=(a257-a328);
  a328=(a264*a257);
  a265=(a265-a328);
  a328=(a268*a254);
  a265=(a265+a328);
  a328=(a207*a008);
  a320=(a214*a046);
  a328=(a328+a320);
  a320=(a215*a111);
  a328=(a328+a320);
  a320=(a216*a136);
  a328=(a328+a320);
  a320=(a217*a163);
  a328=(a328+a320);
  a320=(a218*a191);
  a328=(a328+a320);
  a320=(a219*a220);
  a328=(a328+a320);
  a328=(a221+a328);
  a320=(a265*a328);
  a260=(a260+a320);
  a320=(a043/a267);
  a255=(a269*a320);
  a333=(a264*a255);
  a334=(a268*a320);
  a333=(a333+a334);
  a334=(a207*a038);
  a335=(a214*a107);
  a334=(a334+a335);
  a335=(a215*a130);
  a334=(a334+a335);
  a335=(a216*a154);
  a334=(a334+a335);
  a335=(a217*a181);
  a334=(a334+a335);
  a335=(a218*a209);
  a334=(a334+a335);
  a335=(a219*a238);
  a334=(a334+a335);
  a334=(a164+a334);
  a335=(a333*a334);
  a260=(a260-a335);
  a335=(a035*a250);
  a335=(a335*a253);
  a336=(a335/a261);
  a337=(a021*a213);
  a337=(a337*a253);
  a338=(a264*a335);
  a337=(a337-a338);
  a338=(a337/a258);
  a339=(a137*a213);
  a339=(a339*a256);
  a335=(a268*a335);
  a339=(a339+a335);
  a337=(a269*a337);
  a339=(a339-a337);
  a339=(a339/a267);
  a337=(a269*a339);
  a338=(a338-a337);
  a337=(a264*a338);
  a336=(a336-a337);
  a337=(a268*a339);
  a336=(a336+a337);
  a337=(a336*a323);
  a253=(a021*a253);
  a250=(a250-a213);
  a253=(a253*a250);
  a261=(a253/a261);
  a250=(a264*a253);
  a250=(a015+a250);
  a258=(a250/a258);
  a253=(a268*a253);
  a250=(a269*a250);
  a253=(a253+a250);
  a253=(a253/a267);
  a250=(a269*a253);
  a258=(a258+a250);
  a250=(a264*a258);
  a261=(a261+a250);
  a250=(a268*a253);
  a261=(a261+a250);
  a250=(a207*a052);
  a213=(a214*a074);
  a250=(a250+a213);
  a213=(a215*a024);
  a250=(a250+a213);
  a213=(a216*a090);
  a250=(a250+a213);
  a213=(a217*a158);
  a250=(a250+a213);
  a213=(a218*a185);
  a250=(a250+a213);
  a213=(a197*a229);
  a335=(a227*a321);
  a213=(a213+a335);
  a335=(a225*a327);
  a213=(a213+a335);
  a335=(a331*a316);
  a256=(a228*a220);
  a335=(a335-a256);
  a256=(a239*a238);
  a335=(a335+a256);
  a213=(a213+a335);
  a335=(a219*a213);
  a250=(a250+a335);
  a250=(a008+a250);
  a335=(a261*a250);
  a337=(a337+a335);
  a267=(a041/a267);
  a269=(a269*a267);
  a264=(a264*a269);
  a268=(a268*a267);
  a264=(a264+a268);
  a268=(a207*a071);
  a335=(a214*a098);
  a268=(a268+a335);
  a335=(a215*a121);
  a268=(a268+a335);
  a335=(a216*a145);
  a268=(a268+a335);
  a335=(a217*a172);
  a268=(a268+a335);
  a335=(a218*a200);
  a268=(a268+a335);
  a229=(a307*a229);
  a321=(a224*a321);
  a229=(a229+a321);
  a327=(a313*a327);
  a229=(a229-a327);
  a327=(a332*a316);
  a321=(a223*a220);
  a327=(a327+a321);
  a321=(a237*a238);
  a327=(a327-a321);
  a229=(a229+a327);
  a327=(a219*a229);
  a268=(a268+a327);
  a268=(a038+a268);
  a327=(a264*a268);
  a337=(a337-a327);
  a260=(a260+a337);
  a337=(a249*a260);
  a330=(a330+a337);
  a330=(a009+a330);
  a337=(a233*a330);
  a290=(a290+a337);
  a337=(a266*a017);
  a063=(a273*a063);
  a337=(a337+a063);
  a099=(a101*a099);
  a337=(a337+a099);
  a099=(a124*a146);
  a337=(a337+a099);
  a099=(a274*a173);
  a337=(a337+a099);
  a099=(a275*a201);
  a337=(a337+a099);
  a099=(a276*a230);
  a337=(a337+a099);
  a099=(a277*a260);
  a337=(a337+a099);
  a099=(a283*a285);
  a063=(a284*a281);
  a099=(a099+a063);
  a063=(a283-a099);
  a063=(a007*a063);
  a327=(a007*a281);
  a282=(a002*a282);
  a327=(a327*a282);
  a327=(a327-a287);
  a327=(a327+a288);
  a288=(a296*a327);
  a288=(a288-a298);
  a298=(a292*a327);
  a293=(a293-a298);
  a298=(a297*a293);
  a288=(a288-a298);
  a288=(a288/a295);
  a298=(a288*a036);
  a298=(a298*a284);
  a063=(a063-a298);
  a063=(a063+a283);
  a298=(a063/a289);
  a287=(a007*a099);
  a321=(a292*a063);
  a287=(a287-a321);
  a321=(a287/a286);
  a063=(a296*a063);
  a327=(a327/a289);
  a293=(a293/a286);
  a335=(a297*a288);
  a293=(a293-a335);
  a335=(a292*a293);
  a327=(a327-a335);
  a288=(a296*a288);
  a327=(a327+a288);
  a288=(a327*a284);
  a283=(a283*a242);
  a283=(a283*a242);
  a288=(a288+a283);
  a288=(a036*a288);
  a063=(a063-a288);
  a287=(a297*a287);
  a063=(a063-a287);
  a063=(a063/a295);
  a287=(a297*a063);
  a321=(a321-a287);
  a287=(a292*a321);
  a298=(a298-a287);
  a287=(a296*a063);
  a298=(a298+a287);
  a287=(a236*a009);
  a288=(a243*a023);
  a287=(a287+a288);
  a288=(a244*a049);
  a287=(a287+a288);
  a288=(a245*a252);
  a287=(a287+a288);
  a288=(a246*a299);
  a287=(a287+a288);
  a288=(a247*a309);
  a287=(a287+a288);
  a288=(a248*a316);
  a287=(a287+a288);
  a288=(a249*a323);
  a287=(a287+a288);
  a287=(a042+a287);
  a288=(a298*a287);
  a282=(a285*a282);
  a282=(a099+a282);
  a283=(2.*a327);
  a293=(a293-a283);
  a293=(a281*a293);
  a282=(a282+a293);
  a282=(a007*a282);
  a293=(a282/a289);
  a327=(a327*a281);
  a327=(a327-a099);
  a285=(a285*a242);
  a285=(a285*a242);
  a327=(a327+a285);
  a327=(a007*a327);
  a327=(a327-a031);
  a285=(a292*a282);
  a327=(a327-a285);
  a285=(a327/a286);
  a282=(a296*a282);
  a327=(a297*a327);
  a282=(a282-a327);
  a282=(a282/a295);
  a327=(a297*a282);
  a285=(a285-a327);
  a327=(a292*a285);
  a293=(a293-a327);
  a327=(a296*a282);
  a293=(a293+a327);
  a327=(a236*a008);
  a099=(a243*a046);
  a327=(a327+a099);
  a099=(a244*a111);
  a327=(a327+a099);
  a099=(a245*a136);
  a327=(a327+a099);
  a099=(a246*a163);
  a327=(a327+a099);
  a099=(a247*a191);
  a327=(a327+a099);
  a099=(a248*a220);
  a327=(a327+a099);
  a099=(a249*a250);
  a327=(a327+a099);
  a327=(a221+a327);
  a099=(a293*a327);
  a288=(a288+a099);
  a099=(a043/a295);
  a283=(a297*a099);
  a335=(a292*a283);
  a256=(a296*a099);
  a335=(a335+a256);
  a256=(a236*a038);
  a340=(a243*a107);
  a256=(a256+a340);
  a340=(a244*a130);
  a256=(a256+a340);
  a340=(a245*a154);
  a256=(a256+a340);
  a340=(a246*a181);
  a256=(a256+a340);
  a340=(a247*a209);
  a256=(a256+a340);
  a340=(a248*a238);
  a256=(a256+a340);
  a340=(a249*a268);
  a256=(a256+a340);
  a256=(a164+a256);
  a340=(a335*a256);
  a288=(a288-a340);
  a340=(a035*a002);
  a340=(a340*a281);
  a341=(a340/a289);
  a342=(a021*a242);
  a342=(a342*a281);
  a343=(a292*a340);
  a342=(a342-a343);
  a343=(a342/a286);
  a344=(a137*a242);
  a344=(a344*a284);
  a340=(a296*a340);
  a344=(a344+a340);
  a342=(a297*a342);
  a344=(a344-a342);
  a344=(a344/a295);
  a342=(a297*a344);
  a343=(a343-a342);
  a342=(a292*a343);
  a341=(a341-a342);
  a342=(a296*a344);
  a341=(a341+a342);
  a342=(a341*a330);
  a281=(a021*a281);
  a002=(a002-a242);
  a281=(a281*a002);
  a289=(a281/a289);
  a002=(a292*a281);
  a002=(a015+a002);
  a286=(a002/a286);
  a281=(a296*a281);
  a002=(a297*a002);
  a281=(a281+a002);
  a281=(a281/a295);
  a002=(a297*a281);
  a286=(a286+a002);
  a002=(a292*a286);
  a289=(a289+a002);
  a002=(a296*a281);
  a289=(a289+a002);
  a002=(a236*a052);
  a242=(a243*a074);
  a002=(a002+a242);
  a242=(a244*a024);
  a002=(a002+a242);
  a242=(a245*a090);
  a002=(a002+a242);
  a242=(a246*a158);
  a002=(a002+a242);
  a242=(a247*a185);
  a002=(a002+a242);
  a242=(a248*a213);
  a002=(a002+a242);
  a242=(a226*a259);
  a340=(a257*a328);
  a242=(a242+a340);
  a340=(a255*a334);
  a242=(a242+a340);
  a340=(a338*a323);
  a284=(a258*a250);
  a340=(a340-a284);
  a284=(a269*a268);
  a340=(a340+a284);
  a242=(a242+a340);
  a340=(a249*a242);
  a002=(a002+a340);
  a002=(a008+a002);
  a340=(a289*a002);
  a342=(a342+a340);
  a295=(a041/a295);
  a297=(a297*a295);
  a292=(a292*a297);
  a296=(a296*a295);
  a292=(a292+a296);
  a296=(a236*a071);
  a340=(a243*a098);
  a296=(a296+a340);
  a340=(a244*a121);
  a296=(a296+a340);
  a340=(a245*a145);
  a296=(a296+a340);
  a340=(a246*a172);
  a296=(a296+a340);
  a340=(a247*a200);
  a296=(a296+a340);
  a340=(a248*a229);
  a296=(a296+a340);
  a259=(a314*a259);
  a328=(a254*a328);
  a259=(a259+a328);
  a334=(a320*a334);
  a259=(a259-a334);
  a334=(a339*a323);
  a328=(a253*a250);
  a334=(a334+a328);
  a328=(a267*a268);
  a334=(a334-a328);
  a259=(a259+a334);
  a334=(a249*a259);
  a296=(a296+a334);
  a296=(a038+a296);
  a334=(a292*a296);
  a342=(a342-a334);
  a288=(a288+a342);
  a342=(a278*a288);
  a337=(a337+a342);
  a337=(a009+a337);
  a342=(a263*a337);
  a290=(a290+a342);
  a290=(a042+a290);
  if (res[0]!=0) res[0][6]=a290;
  a290=(a001*a008);
  a342=(a005*a136);
  a290=(a290+a342);
  a342=(a125*a163);
  a290=(a290+a342);
  a342=(a149*a191);
  a290=(a290+a342);
  a342=(a176*a220);
  a290=(a290+a342);
  a342=(a204*a250);
  a290=(a290+a342);
  a342=(a233*a002);
  a290=(a290+a342);
  a342=(a266*a052);
  a074=(a273*a074);
  a342=(a342+a074);
  a024=(a101*a024);
  a342=(a342+a024);
  a024=(a124*a090);
  a342=(a342+a024);
  a024=(a274*a158);
  a342=(a342+a024);
  a024=(a275*a185);
  a342=(a342+a024);
  a024=(a276*a213);
  a342=(a342+a024);
  a024=(a277*a242);
  a342=(a342+a024);
  a024=(a321*a287);
  a074=(a285*a327);
  a024=(a024+a074);
  a074=(a283*a256);
  a024=(a024+a074);
  a074=(a343*a330);
  a334=(a286*a002);
  a074=(a074-a334);
  a334=(a297*a296);
  a074=(a074+a334);
  a024=(a024+a074);
  a074=(a278*a024);
  a342=(a342+a074);
  a342=(a008+a342);
  a074=(a263*a342);
  a290=(a290+a074);
  a290=(a221+a290);
  if (res[0]!=0) res[0][7]=a290;
  a290=(a001*a038);
  a074=(a005*a154);
  a290=(a290+a074);
  a074=(a125*a181);
  a290=(a290+a074);
  a074=(a149*a209);
  a290=(a290+a074);
  a074=(a176*a238);
  a290=(a290+a074);
  a074=(a204*a268);
  a290=(a290+a074);
  a074=(a233*a296);
  a290=(a290+a074);
  a074=(a266*a071);
  a098=(a273*a098);
  a074=(a074+a098);
  a121=(a101*a121);
  a074=(a074+a121);
  a121=(a124*a145);
  a074=(a074+a121);
  a121=(a274*a172);
  a074=(a074+a121);
  a121=(a275*a200);
  a074=(a074+a121);
  a121=(a276*a229);
  a074=(a074+a121);
  a121=(a277*a259);
  a074=(a074+a121);
  a287=(a063*a287);
  a327=(a282*a327);
  a287=(a287+a327);
  a256=(a099*a256);
  a287=(a287-a256);
  a256=(a344*a330);
  a327=(a281*a002);
  a256=(a256+a327);
  a327=(a295*a296);
  a256=(a256-a327);
  a287=(a287+a256);
  a256=(a278*a287);
  a074=(a074+a256);
  a074=(a038+a074);
  a256=(a263*a074);
  a290=(a290+a256);
  a290=(a164+a290);
  if (res[0]!=0) res[0][8]=a290;
  a017=(a001*a017);
  a146=(a005*a146);
  a017=(a017+a146);
  a173=(a125*a173);
  a017=(a017+a173);
  a201=(a149*a201);
  a017=(a017+a201);
  a230=(a176*a230);
  a017=(a017+a230);
  a260=(a204*a260);
  a017=(a017+a260);
  a288=(a233*a288);
  a017=(a017+a288);
  a288=(a000*a175);
  a260=(a203*a262);
  a288=(a288+a260);
  a260=(a000-a288);
  a260=(a007*a260);
  a230=(a007*a262);
  a232=(a291*a232);
  a230=(a230*a232);
  a230=(a230-a004);
  a230=(a230+a019);
  a019=(a033*a230);
  a019=(a019-a029);
  a029=(a294*a230);
  a300=(a300-a029);
  a029=(a018*a300);
  a019=(a019-a029);
  a019=(a019/a027);
  a029=(a019*a036);
  a029=(a029*a203);
  a260=(a260-a029);
  a260=(a260+a000);
  a029=(a260/a113);
  a004=(a007*a288);
  a201=(a294*a260);
  a004=(a004-a201);
  a201=(a004/a032);
  a260=(a033*a260);
  a230=(a230/a113);
  a300=(a300/a032);
  a173=(a018*a019);
  a300=(a300-a173);
  a173=(a294*a300);
  a230=(a230-a173);
  a019=(a033*a019);
  a230=(a230+a019);
  a019=(a230*a203);
  a000=(a000*a272);
  a000=(a000*a272);
  a019=(a019+a000);
  a036=(a036*a019);
  a260=(a260-a036);
  a004=(a018*a004);
  a260=(a260-a004);
  a260=(a260/a027);
  a004=(a018*a260);
  a201=(a201-a004);
  a004=(a294*a201);
  a029=(a029-a004);
  a004=(a033*a260);
  a029=(a029+a004);
  a004=(a266*a009);
  a023=(a273*a023);
  a004=(a004+a023);
  a049=(a101*a049);
  a004=(a004+a049);
  a252=(a124*a252);
  a004=(a004+a252);
  a299=(a274*a299);
  a004=(a004+a299);
  a309=(a275*a309);
  a004=(a004+a309);
  a316=(a276*a316);
  a004=(a004+a316);
  a323=(a277*a323);
  a004=(a004+a323);
  a330=(a278*a330);
  a004=(a004+a330);
  a042=(a042+a004);
  a004=(a029*a042);
  a232=(a175*a232);
  a232=(a288+a232);
  a330=(2.*a230);
  a300=(a300-a330);
  a300=(a262*a300);
  a232=(a232+a300);
  a232=(a007*a232);
  a300=(a232/a113);
  a230=(a230*a262);
  a230=(a230-a288);
  a175=(a175*a272);
  a175=(a175*a272);
  a230=(a230+a175);
  a007=(a007*a230);
  a007=(a007-a031);
  a031=(a294*a232);
  a007=(a007-a031);
  a031=(a007/a032);
  a232=(a033*a232);
  a007=(a018*a007);
  a232=(a232-a007);
  a232=(a232/a027);
  a007=(a018*a232);
  a031=(a031-a007);
  a007=(a294*a031);
  a300=(a300-a007);
  a007=(a033*a232);
  a300=(a300+a007);
  a007=(a266*a008);
  a046=(a273*a046);
  a007=(a007+a046);
  a111=(a101*a111);
  a007=(a007+a111);
  a136=(a124*a136);
  a007=(a007+a136);
  a163=(a274*a163);
  a007=(a007+a163);
  a191=(a275*a191);
  a007=(a007+a191);
  a220=(a276*a220);
  a007=(a007+a220);
  a250=(a277*a250);
  a007=(a007+a250);
  a002=(a278*a002);
  a007=(a007+a002);
  a221=(a221+a007);
  a007=(a300*a221);
  a004=(a004+a007);
  a043=(a043/a027);
  a007=(a018*a043);
  a002=(a294*a007);
  a250=(a033*a043);
  a002=(a002+a250);
  a250=(a266*a038);
  a107=(a273*a107);
  a250=(a250+a107);
  a130=(a101*a130);
  a250=(a250+a130);
  a154=(a124*a154);
  a250=(a250+a154);
  a181=(a274*a181);
  a250=(a250+a181);
  a209=(a275*a209);
  a250=(a250+a209);
  a238=(a276*a238);
  a250=(a250+a238);
  a268=(a277*a268);
  a250=(a250+a268);
  a296=(a278*a296);
  a250=(a250+a296);
  a164=(a164+a250);
  a250=(a002*a164);
  a004=(a004-a250);
  a035=(a035*a291);
  a035=(a035*a262);
  a250=(a035/a113);
  a296=(a021*a272);
  a296=(a296*a262);
  a268=(a294*a035);
  a296=(a296-a268);
  a268=(a296/a032);
  a137=(a137*a272);
  a137=(a137*a203);
  a035=(a033*a035);
  a137=(a137+a035);
  a296=(a018*a296);
  a137=(a137-a296);
  a137=(a137/a027);
  a296=(a018*a137);
  a268=(a268-a296);
  a296=(a294*a268);
  a250=(a250-a296);
  a296=(a033*a137);
  a250=(a250+a296);
  a296=(a250*a337);
  a021=(a021*a262);
  a291=(a291-a272);
  a021=(a021*a291);
  a113=(a021/a113);
  a291=(a294*a021);
  a015=(a015+a291);
  a032=(a015/a032);
  a021=(a033*a021);
  a015=(a018*a015);
  a021=(a021+a015);
  a021=(a021/a027);
  a015=(a018*a021);
  a032=(a032+a015);
  a015=(a294*a032);
  a113=(a113+a015);
  a015=(a033*a021);
  a113=(a113+a015);
  a015=(a113*a342);
  a296=(a296+a015);
  a041=(a041/a027);
  a018=(a018*a041);
  a294=(a294*a018);
  a033=(a033*a041);
  a294=(a294+a033);
  a033=(a294*a074);
  a296=(a296-a033);
  a004=(a004+a296);
  a004=(a263*a004);
  a017=(a017+a004);
  a009=(a009+a017);
  if (res[0]!=0) res[0][9]=a009;
  a052=(a001*a052);
  a090=(a005*a090);
  a052=(a052+a090);
  a158=(a125*a158);
  a052=(a052+a158);
  a185=(a149*a185);
  a052=(a052+a185);
  a213=(a176*a213);
  a052=(a052+a213);
  a242=(a204*a242);
  a052=(a052+a242);
  a024=(a233*a024);
  a052=(a052+a024);
  a024=(a201*a042);
  a242=(a031*a221);
  a024=(a024+a242);
  a242=(a007*a164);
  a024=(a024+a242);
  a242=(a268*a337);
  a213=(a032*a342);
  a242=(a242-a213);
  a213=(a018*a074);
  a242=(a242+a213);
  a024=(a024+a242);
  a024=(a263*a024);
  a052=(a052+a024);
  a008=(a008+a052);
  if (res[0]!=0) res[0][10]=a008;
  a071=(a001*a071);
  a145=(a005*a145);
  a071=(a071+a145);
  a172=(a125*a172);
  a071=(a071+a172);
  a200=(a149*a200);
  a071=(a071+a200);
  a229=(a176*a229);
  a071=(a071+a229);
  a259=(a204*a259);
  a071=(a071+a259);
  a287=(a233*a287);
  a071=(a071+a287);
  a042=(a260*a042);
  a221=(a232*a221);
  a042=(a042+a221);
  a164=(a043*a164);
  a042=(a042-a164);
  a337=(a137*a337);
  a342=(a021*a342);
  a337=(a337+a342);
  a074=(a041*a074);
  a337=(a337-a074);
  a042=(a042+a337);
  a042=(a263*a042);
  a071=(a071+a042);
  a038=(a038+a071);
  if (res[0]!=0) res[0][11]=a038;
  a038=arg[0]? arg[0][12] : 0;
  a071=arg[0]? arg[0][15] : 0;
  a042=(a001*a071);
  a337=(a040*a038);
  a074=arg[0]? arg[0][13] : 0;
  a342=(a026*a074);
  a337=(a337+a342);
  a342=arg[0]? arg[0][14] : 0;
  a164=(a016*a342);
  a337=(a337-a164);
  a164=(a280*a071);
  a221=arg[0]? arg[0][16] : 0;
  a287=(a022*a221);
  a164=(a164+a287);
  a287=arg[0]? arg[0][17] : 0;
  a259=(a025*a287);
  a164=(a164-a259);
  a337=(a337+a164);
  a164=(a006*a337);
  a259=(a045*a071);
  a229=(a048*a337);
  a200=(a051*a071);
  a200=(a038+a200);
  a172=(a073*a200);
  a145=(a051*a221);
  a145=(a074+a145);
  a008=(a068*a145);
  a172=(a172+a008);
  a008=(a051*a287);
  a008=(a342+a008);
  a052=(a084*a008);
  a172=(a172-a052);
  a052=(a051*a337);
  a052=(a071+a052);
  a024=(a114*a052);
  a242=(a192*a038);
  a213=(a014*a074);
  a242=(a242+a213);
  a213=(a020*a342);
  a242=(a242+a213);
  a213=(a222*a071);
  a185=(a034*a221);
  a213=(a213-a185);
  a185=(a039*a287);
  a213=(a213+a185);
  a242=(a242+a213);
  a213=(a051*a242);
  a213=(a221+a213);
  a185=(a064*a213);
  a024=(a024+a185);
  a185=(a251*a038);
  a158=(a012*a074);
  a185=(a185+a158);
  a158=(a279*a342);
  a185=(a185-a158);
  a158=(a193*a071);
  a090=(a011*a221);
  a158=(a158+a090);
  a090=(a037*a287);
  a158=(a158-a090);
  a185=(a185+a158);
  a158=(a051*a185);
  a158=(a287+a158);
  a090=(a067*a158);
  a024=(a024-a090);
  a172=(a172+a024);
  a172=(a050*a172);
  a229=(a229+a172);
  a229=(a071+a229);
  a172=(a047*a229);
  a259=(a259+a172);
  a259=(a038+a259);
  a172=(a109*a259);
  a024=(a045*a221);
  a090=(a048*a242);
  a009=(a080*a200);
  a017=(a060*a145);
  a009=(a009+a017);
  a017=(a058*a008);
  a009=(a009+a017);
  a017=(a271*a052);
  a004=(a061*a213);
  a017=(a017-a004);
  a004=(a072*a158);
  a017=(a017+a004);
  a009=(a009+a017);
  a009=(a050*a009);
  a090=(a090+a009);
  a090=(a221+a090);
  a009=(a047*a090);
  a024=(a024+a009);
  a024=(a074+a024);
  a009=(a104*a024);
  a172=(a172+a009);
  a009=(a045*a287);
  a017=(a048*a185);
  a200=(a138*a200);
  a145=(a057*a145);
  a200=(a200+a145);
  a008=(a094*a008);
  a200=(a200-a008);
  a008=(a241*a052);
  a145=(a055*a213);
  a008=(a008+a145);
  a145=(a070*a158);
  a008=(a008-a145);
  a200=(a200+a008);
  a200=(a050*a200);
  a017=(a017+a200);
  a017=(a287+a017);
  a200=(a047*a017);
  a009=(a009+a200);
  a009=(a342+a009);
  a200=(a184*a009);
  a172=(a172-a200);
  a200=(a045*a337);
  a008=(a048*a071);
  a052=(a050*a052);
  a008=(a008+a052);
  a008=(a038+a008);
  a052=(a091*a008);
  a145=(a048*a221);
  a213=(a050*a213);
  a145=(a145+a213);
  a145=(a074+a145);
  a213=(a065*a145);
  a052=(a052+a213);
  a213=(a048*a287);
  a158=(a050*a158);
  a213=(a213+a158);
  a213=(a342+a213);
  a158=(a083*a213);
  a052=(a052-a158);
  a158=(a303*a229);
  a004=(a054*a090);
  a158=(a158+a004);
  a004=(a066*a017);
  a158=(a158-a004);
  a052=(a052+a158);
  a158=(a047*a052);
  a200=(a200+a158);
  a200=(a071+a200);
  a158=(a028*a200);
  a004=(a045*a242);
  a296=(a301*a008);
  a033=(a077*a145);
  a296=(a296+a033);
  a033=(a062*a213);
  a296=(a296+a033);
  a033=(a305*a229);
  a027=(a085*a090);
  a033=(a033-a027);
  a027=(a089*a017);
  a033=(a033+a027);
  a296=(a296+a033);
  a033=(a047*a296);
  a004=(a004+a033);
  a004=(a221+a004);
  a033=(a100*a004);
  a158=(a158+a033);
  a033=(a045*a185);
  a008=(a095*a008);
  a145=(a082*a145);
  a008=(a008+a145);
  a213=(a056*a213);
  a008=(a008-a213);
  a213=(a306*a229);
  a145=(a069*a090);
  a213=(a213+a145);
  a145=(a087*a017);
  a213=(a213-a145);
  a008=(a008+a213);
  a213=(a047*a008);
  a033=(a033+a213);
  a033=(a287+a033);
  a213=(a103*a033);
  a158=(a158-a213);
  a172=(a172+a158);
  a158=(a030*a172);
  a164=(a164+a158);
  a158=(a105*a071);
  a229=(a112*a229);
  a158=(a158+a229);
  a229=(a086*a200);
  a158=(a158+a229);
  a158=(a038+a158);
  a229=(a132*a158);
  a213=(a105*a221);
  a090=(a112*a090);
  a213=(a213+a090);
  a090=(a086*a004);
  a213=(a213+a090);
  a213=(a074+a213);
  a090=(a127*a213);
  a229=(a229+a090);
  a090=(a105*a287);
  a017=(a112*a017);
  a090=(a090+a017);
  a017=(a086*a033);
  a090=(a090+a017);
  a090=(a342+a090);
  a017=(a122*a090);
  a229=(a229-a017);
  a017=(a105*a337);
  a052=(a112*a052);
  a017=(a017+a052);
  a052=(a086*a172);
  a017=(a017+a052);
  a017=(a071+a017);
  a052=(a079*a017);
  a145=(a105*a242);
  a296=(a112*a296);
  a145=(a145+a296);
  a296=(a165*a259);
  a027=(a096*a024);
  a296=(a296+a027);
  a027=(a212*a009);
  a296=(a296+a027);
  a027=(a110*a200);
  a015=(a097*a004);
  a027=(a027-a015);
  a015=(a108*a033);
  a027=(a027+a015);
  a296=(a296+a027);
  a027=(a086*a296);
  a145=(a145+a027);
  a145=(a221+a145);
  a027=(a123*a145);
  a052=(a052+a027);
  a027=(a105*a185);
  a008=(a112*a008);
  a027=(a027+a008);
  a259=(a010*a259);
  a024=(a093*a024);
  a259=(a259+a024);
  a009=(a044*a009);
  a259=(a259-a009);
  a009=(a302*a200);
  a024=(a053*a004);
  a009=(a009+a024);
  a024=(a106*a033);
  a009=(a009-a024);
  a259=(a259+a009);
  a009=(a086*a259);
  a027=(a027+a009);
  a027=(a287+a027);
  a009=(a126*a027);
  a052=(a052-a009);
  a229=(a229+a052);
  a052=(a102*a229);
  a164=(a164+a052);
  a164=(a071+a164);
  a052=(a005*a164);
  a042=(a042+a052);
  a052=(a128*a337);
  a009=(a092*a172);
  a052=(a052+a009);
  a009=(a134*a229);
  a052=(a052+a009);
  a009=(a006*a071);
  a024=(a030*a200);
  a009=(a009+a024);
  a024=(a102*a017);
  a009=(a009+a024);
  a009=(a038+a009);
  a024=(a156*a009);
  a008=(a006*a221);
  a015=(a030*a004);
  a008=(a008+a015);
  a015=(a102*a145);
  a008=(a008+a015);
  a008=(a074+a008);
  a015=(a151*a008);
  a024=(a024+a015);
  a015=(a006*a287);
  a291=(a030*a033);
  a015=(a015+a291);
  a291=(a102*a027);
  a015=(a015+a291);
  a015=(a342+a015);
  a291=(a133*a015);
  a024=(a024-a291);
  a291=(a308*a164);
  a272=(a006*a242);
  a262=(a030*a296);
  a272=(a272+a262);
  a262=(a088*a158);
  a035=(a119*a213);
  a262=(a262+a035);
  a035=(a304*a090);
  a262=(a262+a035);
  a035=(a059*a017);
  a203=(a120*a145);
  a035=(a035-a203);
  a203=(a131*a027);
  a035=(a035+a203);
  a262=(a262+a035);
  a035=(a102*a262);
  a272=(a272+a035);
  a272=(a221+a272);
  a035=(a147*a272);
  a291=(a291+a035);
  a035=(a006*a185);
  a203=(a030*a259);
  a035=(a035+a203);
  a158=(a075*a158);
  a213=(a081*a213);
  a158=(a158+a213);
  a090=(a003*a090);
  a158=(a158-a090);
  a090=(a076*a017);
  a213=(a115*a145);
  a090=(a090+a213);
  a213=(a129*a027);
  a090=(a090-a213);
  a158=(a158+a090);
  a090=(a102*a158);
  a035=(a035+a090);
  a035=(a287+a035);
  a090=(a150*a035);
  a291=(a291-a090);
  a024=(a024+a291);
  a291=(a135*a024);
  a052=(a052+a291);
  a052=(a071+a052);
  a291=(a125*a052);
  a042=(a042+a291);
  a291=(a152*a337);
  a090=(a159*a172);
  a291=(a291+a090);
  a090=(a160*a229);
  a291=(a291+a090);
  a090=(a161*a024);
  a291=(a291+a090);
  a090=(a128*a071);
  a213=(a092*a200);
  a090=(a090+a213);
  a213=(a134*a017);
  a090=(a090+a213);
  a213=(a135*a164);
  a090=(a090+a213);
  a090=(a038+a090);
  a213=(a183*a090);
  a203=(a128*a221);
  a238=(a092*a004);
  a203=(a203+a238);
  a238=(a134*a145);
  a203=(a203+a238);
  a238=(a135*a272);
  a203=(a203+a238);
  a203=(a074+a203);
  a238=(a178*a203);
  a213=(a213+a238);
  a238=(a128*a287);
  a209=(a092*a033);
  a238=(a238+a209);
  a209=(a134*a027);
  a238=(a238+a209);
  a209=(a135*a035);
  a238=(a238+a209);
  a238=(a342+a238);
  a209=(a312*a238);
  a213=(a213-a209);
  a209=(a315*a052);
  a181=(a128*a242);
  a154=(a092*a296);
  a181=(a181+a154);
  a154=(a134*a262);
  a181=(a181+a154);
  a154=(a116*a009);
  a130=(a143*a008);
  a154=(a154+a130);
  a130=(a141*a015);
  a154=(a154+a130);
  a130=(a310*a164);
  a107=(a144*a272);
  a130=(a130-a107);
  a107=(a155*a035);
  a130=(a130+a107);
  a154=(a154+a130);
  a130=(a135*a154);
  a181=(a181+a130);
  a181=(a221+a181);
  a130=(a174*a181);
  a209=(a209+a130);
  a130=(a128*a185);
  a107=(a092*a259);
  a130=(a130+a107);
  a107=(a134*a158);
  a130=(a130+a107);
  a009=(a013*a009);
  a008=(a140*a008);
  a009=(a009+a008);
  a015=(a157*a015);
  a009=(a009-a015);
  a015=(a311*a164);
  a008=(a139*a272);
  a015=(a015+a008);
  a008=(a153*a035);
  a015=(a015-a008);
  a009=(a009+a015);
  a015=(a135*a009);
  a130=(a130+a015);
  a130=(a287+a130);
  a015=(a177*a130);
  a209=(a209-a015);
  a213=(a213+a209);
  a209=(a162*a213);
  a291=(a291+a209);
  a291=(a071+a291);
  a209=(a149*a291);
  a042=(a042+a209);
  a209=(a179*a337);
  a015=(a186*a172);
  a209=(a209+a015);
  a015=(a187*a229);
  a209=(a209+a015);
  a015=(a188*a024);
  a209=(a209+a015);
  a015=(a189*a213);
  a209=(a209+a015);
  a015=(a152*a071);
  a008=(a159*a200);
  a015=(a015+a008);
  a008=(a160*a017);
  a015=(a015+a008);
  a008=(a161*a164);
  a015=(a015+a008);
  a008=(a162*a052);
  a015=(a015+a008);
  a015=(a038+a015);
  a008=(a211*a015);
  a107=(a152*a221);
  a220=(a159*a004);
  a107=(a107+a220);
  a220=(a160*a145);
  a107=(a107+a220);
  a220=(a161*a272);
  a107=(a107+a220);
  a220=(a162*a181);
  a107=(a107+a220);
  a107=(a074+a107);
  a220=(a206*a107);
  a008=(a008+a220);
  a220=(a152*a287);
  a191=(a159*a033);
  a220=(a220+a191);
  a191=(a160*a027);
  a220=(a220+a191);
  a191=(a161*a035);
  a220=(a220+a191);
  a191=(a162*a130);
  a220=(a220+a191);
  a220=(a342+a220);
  a191=(a319*a220);
  a008=(a008-a191);
  a191=(a322*a291);
  a163=(a152*a242);
  a136=(a159*a296);
  a163=(a163+a136);
  a136=(a160*a262);
  a163=(a163+a136);
  a136=(a161*a154);
  a163=(a163+a136);
  a136=(a142*a090);
  a111=(a170*a203);
  a136=(a136+a111);
  a111=(a168*a238);
  a136=(a136+a111);
  a111=(a317*a052);
  a046=(a171*a181);
  a111=(a111-a046);
  a046=(a182*a130);
  a111=(a111+a046);
  a136=(a136+a111);
  a111=(a162*a136);
  a163=(a163+a111);
  a163=(a221+a163);
  a111=(a202*a163);
  a191=(a191+a111);
  a111=(a152*a185);
  a046=(a159*a259);
  a111=(a111+a046);
  a046=(a160*a158);
  a111=(a111+a046);
  a046=(a161*a009);
  a111=(a111+a046);
  a090=(a148*a090);
  a203=(a167*a203);
  a090=(a090+a203);
  a238=(a117*a238);
  a090=(a090-a238);
  a238=(a318*a052);
  a203=(a166*a181);
  a238=(a238+a203);
  a203=(a180*a130);
  a238=(a238-a203);
  a090=(a090+a238);
  a238=(a162*a090);
  a111=(a111+a238);
  a111=(a287+a111);
  a238=(a205*a111);
  a191=(a191-a238);
  a008=(a008+a191);
  a191=(a190*a008);
  a209=(a209+a191);
  a209=(a071+a209);
  a191=(a176*a209);
  a042=(a042+a191);
  a191=(a207*a337);
  a238=(a214*a172);
  a191=(a191+a238);
  a238=(a215*a229);
  a191=(a191+a238);
  a238=(a216*a024);
  a191=(a191+a238);
  a238=(a217*a213);
  a191=(a191+a238);
  a238=(a218*a008);
  a191=(a191+a238);
  a238=(a179*a071);
  a203=(a186*a200);
  a238=(a238+a203);
  a203=(a187*a017);
  a238=(a238+a203);
  a203=(a188*a164);
  a238=(a238+a203);
  a203=(a189*a052);
  a238=(a238+a203);
  a203=(a190*a291);
  a238=(a238+a203);
  a238=(a038+a238);
  a203=(a240*a238);
  a046=(a179*a221);
  a230=(a186*a004);
  a046=(a046+a230);
  a230=(a187*a145);
  a046=(a046+a230);
  a230=(a188*a272);
  a046=(a046+a230);
  a230=(a189*a181);
  a046=(a046+a230);
  a230=(a190*a163);
  a046=(a046+a230);
  a046=(a074+a046);
  a230=(a235*a046);
  a203=(a203+a230);
  a230=(a179*a287);
  a175=(a186*a033);
  a230=(a230+a175);
  a175=(a187*a027);
  a230=(a230+a175);
  a175=(a188*a035);
  a230=(a230+a175);
  a175=(a189*a130);
  a230=(a230+a175);
  a175=(a190*a111);
  a230=(a230+a175);
  a230=(a342+a230);
  a175=(a326*a230);
  a203=(a203-a175);
  a175=(a329*a209);
  a288=(a179*a242);
  a330=(a186*a296);
  a288=(a288+a330);
  a330=(a187*a262);
  a288=(a288+a330);
  a330=(a188*a154);
  a288=(a288+a330);
  a330=(a189*a136);
  a288=(a288+a330);
  a330=(a169*a015);
  a323=(a198*a107);
  a330=(a330+a323);
  a323=(a196*a220);
  a330=(a330+a323);
  a323=(a324*a291);
  a316=(a199*a163);
  a323=(a323-a316);
  a316=(a210*a111);
  a323=(a323+a316);
  a330=(a330+a323);
  a323=(a190*a330);
  a288=(a288+a323);
  a288=(a221+a288);
  a323=(a231*a288);
  a175=(a175+a323);
  a323=(a179*a185);
  a316=(a186*a259);
  a323=(a323+a316);
  a316=(a187*a158);
  a323=(a323+a316);
  a316=(a188*a009);
  a323=(a323+a316);
  a316=(a189*a090);
  a323=(a323+a316);
  a015=(a078*a015);
  a107=(a195*a107);
  a015=(a015+a107);
  a220=(a118*a220);
  a015=(a015-a220);
  a220=(a325*a291);
  a107=(a194*a163);
  a220=(a220+a107);
  a107=(a208*a111);
  a220=(a220-a107);
  a015=(a015+a220);
  a220=(a190*a015);
  a323=(a323+a220);
  a323=(a287+a323);
  a220=(a234*a323);
  a175=(a175-a220);
  a203=(a203+a175);
  a175=(a219*a203);
  a191=(a191+a175);
  a191=(a071+a191);
  a175=(a204*a191);
  a042=(a042+a175);
  a175=(a236*a337);
  a220=(a243*a172);
  a175=(a175+a220);
  a220=(a244*a229);
  a175=(a175+a220);
  a220=(a245*a024);
  a175=(a175+a220);
  a220=(a246*a213);
  a175=(a175+a220);
  a220=(a247*a008);
  a175=(a175+a220);
  a220=(a248*a203);
  a175=(a175+a220);
  a220=(a207*a071);
  a107=(a214*a200);
  a220=(a220+a107);
  a107=(a215*a017);
  a220=(a220+a107);
  a107=(a216*a164);
  a220=(a220+a107);
  a107=(a217*a052);
  a220=(a220+a107);
  a107=(a218*a291);
  a220=(a220+a107);
  a107=(a219*a209);
  a220=(a220+a107);
  a220=(a038+a220);
  a107=(a270*a220);
  a316=(a207*a221);
  a309=(a214*a004);
  a316=(a316+a309);
  a309=(a215*a145);
  a316=(a316+a309);
  a309=(a216*a272);
  a316=(a316+a309);
  a309=(a217*a181);
  a316=(a316+a309);
  a309=(a218*a163);
  a316=(a316+a309);
  a309=(a219*a288);
  a316=(a316+a309);
  a316=(a074+a316);
  a309=(a265*a316);
  a107=(a107+a309);
  a309=(a207*a287);
  a299=(a214*a033);
  a309=(a309+a299);
  a299=(a215*a027);
  a309=(a309+a299);
  a299=(a216*a035);
  a309=(a309+a299);
  a299=(a217*a130);
  a309=(a309+a299);
  a299=(a218*a111);
  a309=(a309+a299);
  a299=(a219*a323);
  a309=(a309+a299);
  a309=(a342+a309);
  a299=(a333*a309);
  a107=(a107-a299);
  a299=(a336*a191);
  a252=(a207*a242);
  a049=(a214*a296);
  a252=(a252+a049);
  a049=(a215*a262);
  a252=(a252+a049);
  a049=(a216*a154);
  a252=(a252+a049);
  a049=(a217*a136);
  a252=(a252+a049);
  a049=(a218*a330);
  a252=(a252+a049);
  a049=(a197*a238);
  a023=(a227*a046);
  a049=(a049+a023);
  a023=(a225*a230);
  a049=(a049+a023);
  a023=(a331*a209);
  a036=(a228*a288);
  a023=(a023-a036);
  a036=(a239*a323);
  a023=(a023+a036);
  a049=(a049+a023);
  a023=(a219*a049);
  a252=(a252+a023);
  a252=(a221+a252);
  a023=(a261*a252);
  a299=(a299+a023);
  a023=(a207*a185);
  a036=(a214*a259);
  a023=(a023+a036);
  a036=(a215*a158);
  a023=(a023+a036);
  a036=(a216*a009);
  a023=(a023+a036);
  a036=(a217*a090);
  a023=(a023+a036);
  a036=(a218*a015);
  a023=(a023+a036);
  a238=(a307*a238);
  a046=(a224*a046);
  a238=(a238+a046);
  a230=(a313*a230);
  a238=(a238-a230);
  a230=(a332*a209);
  a046=(a223*a288);
  a230=(a230+a046);
  a046=(a237*a323);
  a230=(a230-a046);
  a238=(a238+a230);
  a230=(a219*a238);
  a023=(a023+a230);
  a023=(a287+a023);
  a230=(a264*a023);
  a299=(a299-a230);
  a107=(a107+a299);
  a299=(a249*a107);
  a175=(a175+a299);
  a175=(a071+a175);
  a299=(a233*a175);
  a042=(a042+a299);
  a299=(a266*a337);
  a172=(a273*a172);
  a299=(a299+a172);
  a229=(a101*a229);
  a299=(a299+a229);
  a229=(a124*a024);
  a299=(a299+a229);
  a229=(a274*a213);
  a299=(a299+a229);
  a229=(a275*a008);
  a299=(a299+a229);
  a229=(a276*a203);
  a299=(a299+a229);
  a229=(a277*a107);
  a299=(a299+a229);
  a229=(a236*a071);
  a172=(a243*a200);
  a229=(a229+a172);
  a172=(a244*a017);
  a229=(a229+a172);
  a172=(a245*a164);
  a229=(a229+a172);
  a172=(a246*a052);
  a229=(a229+a172);
  a172=(a247*a291);
  a229=(a229+a172);
  a172=(a248*a209);
  a229=(a229+a172);
  a172=(a249*a191);
  a229=(a229+a172);
  a229=(a038+a229);
  a172=(a298*a229);
  a230=(a236*a221);
  a046=(a243*a004);
  a230=(a230+a046);
  a046=(a244*a145);
  a230=(a230+a046);
  a046=(a245*a272);
  a230=(a230+a046);
  a046=(a246*a181);
  a230=(a230+a046);
  a046=(a247*a163);
  a230=(a230+a046);
  a046=(a248*a288);
  a230=(a230+a046);
  a046=(a249*a252);
  a230=(a230+a046);
  a230=(a074+a230);
  a046=(a293*a230);
  a172=(a172+a046);
  a046=(a236*a287);
  a036=(a243*a033);
  a046=(a046+a036);
  a036=(a244*a027);
  a046=(a046+a036);
  a036=(a245*a035);
  a046=(a046+a036);
  a036=(a246*a130);
  a046=(a046+a036);
  a036=(a247*a111);
  a046=(a046+a036);
  a036=(a248*a323);
  a046=(a046+a036);
  a036=(a249*a023);
  a046=(a046+a036);
  a046=(a342+a046);
  a036=(a335*a046);
  a172=(a172-a036);
  a036=(a341*a175);
  a019=(a236*a242);
  a000=(a243*a296);
  a019=(a019+a000);
  a000=(a244*a262);
  a019=(a019+a000);
  a000=(a245*a154);
  a019=(a019+a000);
  a000=(a246*a136);
  a019=(a019+a000);
  a000=(a247*a330);
  a019=(a019+a000);
  a000=(a248*a049);
  a019=(a019+a000);
  a000=(a226*a220);
  a173=(a257*a316);
  a000=(a000+a173);
  a173=(a255*a309);
  a000=(a000+a173);
  a173=(a338*a191);
  a146=(a258*a252);
  a173=(a173-a146);
  a146=(a269*a023);
  a173=(a173+a146);
  a000=(a000+a173);
  a173=(a249*a000);
  a019=(a019+a173);
  a019=(a221+a019);
  a173=(a289*a019);
  a036=(a036+a173);
  a173=(a236*a185);
  a146=(a243*a259);
  a173=(a173+a146);
  a146=(a244*a158);
  a173=(a173+a146);
  a146=(a245*a009);
  a173=(a173+a146);
  a146=(a246*a090);
  a173=(a173+a146);
  a146=(a247*a015);
  a173=(a173+a146);
  a146=(a248*a238);
  a173=(a173+a146);
  a220=(a314*a220);
  a316=(a254*a316);
  a220=(a220+a316);
  a309=(a320*a309);
  a220=(a220-a309);
  a309=(a339*a191);
  a316=(a253*a252);
  a309=(a309+a316);
  a316=(a267*a023);
  a309=(a309-a316);
  a220=(a220+a309);
  a309=(a249*a220);
  a173=(a173+a309);
  a173=(a287+a173);
  a309=(a292*a173);
  a036=(a036-a309);
  a172=(a172+a036);
  a036=(a278*a172);
  a299=(a299+a036);
  a299=(a071+a299);
  a036=(a263*a299);
  a042=(a042+a036);
  a042=(a038+a042);
  if (res[0]!=0) res[0][12]=a042;
  a042=(a001*a221);
  a036=(a005*a272);
  a042=(a042+a036);
  a036=(a125*a181);
  a042=(a042+a036);
  a036=(a149*a163);
  a042=(a042+a036);
  a036=(a176*a288);
  a042=(a042+a036);
  a036=(a204*a252);
  a042=(a042+a036);
  a036=(a233*a019);
  a042=(a042+a036);
  a036=(a266*a242);
  a296=(a273*a296);
  a036=(a036+a296);
  a262=(a101*a262);
  a036=(a036+a262);
  a262=(a124*a154);
  a036=(a036+a262);
  a262=(a274*a136);
  a036=(a036+a262);
  a262=(a275*a330);
  a036=(a036+a262);
  a262=(a276*a049);
  a036=(a036+a262);
  a262=(a277*a000);
  a036=(a036+a262);
  a262=(a321*a229);
  a296=(a285*a230);
  a262=(a262+a296);
  a296=(a283*a046);
  a262=(a262+a296);
  a296=(a343*a175);
  a309=(a286*a019);
  a296=(a296-a309);
  a309=(a297*a173);
  a296=(a296+a309);
  a262=(a262+a296);
  a296=(a278*a262);
  a036=(a036+a296);
  a036=(a221+a036);
  a296=(a263*a036);
  a042=(a042+a296);
  a042=(a074+a042);
  if (res[0]!=0) res[0][13]=a042;
  a042=(a001*a287);
  a296=(a005*a035);
  a042=(a042+a296);
  a296=(a125*a130);
  a042=(a042+a296);
  a296=(a149*a111);
  a042=(a042+a296);
  a296=(a176*a323);
  a042=(a042+a296);
  a296=(a204*a023);
  a042=(a042+a296);
  a296=(a233*a173);
  a042=(a042+a296);
  a296=(a266*a185);
  a259=(a273*a259);
  a296=(a296+a259);
  a158=(a101*a158);
  a296=(a296+a158);
  a158=(a124*a009);
  a296=(a296+a158);
  a158=(a274*a090);
  a296=(a296+a158);
  a158=(a275*a015);
  a296=(a296+a158);
  a158=(a276*a238);
  a296=(a296+a158);
  a158=(a277*a220);
  a296=(a296+a158);
  a229=(a063*a229);
  a230=(a282*a230);
  a229=(a229+a230);
  a046=(a099*a046);
  a229=(a229-a046);
  a046=(a344*a175);
  a230=(a281*a019);
  a046=(a046+a230);
  a230=(a295*a173);
  a046=(a046-a230);
  a229=(a229+a046);
  a046=(a278*a229);
  a296=(a296+a046);
  a296=(a287+a296);
  a046=(a263*a296);
  a042=(a042+a046);
  a042=(a342+a042);
  if (res[0]!=0) res[0][14]=a042;
  a337=(a001*a337);
  a024=(a005*a024);
  a337=(a337+a024);
  a213=(a125*a213);
  a337=(a337+a213);
  a008=(a149*a008);
  a337=(a337+a008);
  a203=(a176*a203);
  a337=(a337+a203);
  a107=(a204*a107);
  a337=(a337+a107);
  a172=(a233*a172);
  a337=(a337+a172);
  a172=(a266*a071);
  a200=(a273*a200);
  a172=(a172+a200);
  a017=(a101*a017);
  a172=(a172+a017);
  a164=(a124*a164);
  a172=(a172+a164);
  a052=(a274*a052);
  a172=(a172+a052);
  a291=(a275*a291);
  a172=(a172+a291);
  a209=(a276*a209);
  a172=(a172+a209);
  a191=(a277*a191);
  a172=(a172+a191);
  a175=(a278*a175);
  a172=(a172+a175);
  a038=(a038+a172);
  a172=(a029*a038);
  a175=(a266*a221);
  a004=(a273*a004);
  a175=(a175+a004);
  a145=(a101*a145);
  a175=(a175+a145);
  a272=(a124*a272);
  a175=(a175+a272);
  a181=(a274*a181);
  a175=(a175+a181);
  a163=(a275*a163);
  a175=(a175+a163);
  a288=(a276*a288);
  a175=(a175+a288);
  a252=(a277*a252);
  a175=(a175+a252);
  a019=(a278*a019);
  a175=(a175+a019);
  a074=(a074+a175);
  a175=(a300*a074);
  a172=(a172+a175);
  a175=(a266*a287);
  a033=(a273*a033);
  a175=(a175+a033);
  a027=(a101*a027);
  a175=(a175+a027);
  a035=(a124*a035);
  a175=(a175+a035);
  a130=(a274*a130);
  a175=(a175+a130);
  a111=(a275*a111);
  a175=(a175+a111);
  a323=(a276*a323);
  a175=(a175+a323);
  a023=(a277*a023);
  a175=(a175+a023);
  a173=(a278*a173);
  a175=(a175+a173);
  a342=(a342+a175);
  a175=(a002*a342);
  a172=(a172-a175);
  a175=(a250*a299);
  a173=(a113*a036);
  a175=(a175+a173);
  a173=(a294*a296);
  a175=(a175-a173);
  a172=(a172+a175);
  a172=(a263*a172);
  a337=(a337+a172);
  a071=(a071+a337);
  if (res[0]!=0) res[0][15]=a071;
  a242=(a001*a242);
  a154=(a005*a154);
  a242=(a242+a154);
  a136=(a125*a136);
  a242=(a242+a136);
  a330=(a149*a330);
  a242=(a242+a330);
  a049=(a176*a049);
  a242=(a242+a049);
  a000=(a204*a000);
  a242=(a242+a000);
  a262=(a233*a262);
  a242=(a242+a262);
  a262=(a201*a038);
  a000=(a031*a074);
  a262=(a262+a000);
  a000=(a007*a342);
  a262=(a262+a000);
  a000=(a268*a299);
  a049=(a032*a036);
  a000=(a000-a049);
  a049=(a018*a296);
  a000=(a000+a049);
  a262=(a262+a000);
  a262=(a263*a262);
  a242=(a242+a262);
  a221=(a221+a242);
  if (res[0]!=0) res[0][16]=a221;
  a185=(a001*a185);
  a009=(a005*a009);
  a185=(a185+a009);
  a090=(a125*a090);
  a185=(a185+a090);
  a015=(a149*a015);
  a185=(a185+a015);
  a238=(a176*a238);
  a185=(a185+a238);
  a220=(a204*a220);
  a185=(a185+a220);
  a229=(a233*a229);
  a185=(a185+a229);
  a038=(a260*a038);
  a074=(a232*a074);
  a038=(a038+a074);
  a342=(a043*a342);
  a038=(a038-a342);
  a299=(a137*a299);
  a036=(a021*a036);
  a299=(a299+a036);
  a296=(a041*a296);
  a299=(a299-a296);
  a038=(a038+a299);
  a038=(a263*a038);
  a185=(a185+a038);
  a287=(a287+a185);
  if (res[0]!=0) res[0][17]=a287;
  a287=arg[0]? arg[0][18] : 0;
  a185=arg[0]? arg[0][21] : 0;
  a038=(a001*a185);
  a299=(a040*a287);
  a296=arg[0]? arg[0][19] : 0;
  a036=(a026*a296);
  a299=(a299+a036);
  a036=arg[0]? arg[0][20] : 0;
  a342=(a016*a036);
  a299=(a299-a342);
  a342=(a280*a185);
  a074=arg[0]? arg[0][22] : 0;
  a229=(a022*a074);
  a342=(a342+a229);
  a229=arg[0]? arg[0][23] : 0;
  a220=(a025*a229);
  a342=(a342-a220);
  a299=(a299+a342);
  a342=(a006*a299);
  a220=(a045*a185);
  a238=(a048*a299);
  a015=(a051*a185);
  a015=(a287+a015);
  a090=(a073*a015);
  a009=(a051*a074);
  a009=(a296+a009);
  a221=(a068*a009);
  a090=(a090+a221);
  a221=(a051*a229);
  a221=(a036+a221);
  a242=(a084*a221);
  a090=(a090-a242);
  a242=(a051*a299);
  a242=(a185+a242);
  a262=(a114*a242);
  a000=(a192*a287);
  a049=(a014*a296);
  a000=(a000+a049);
  a049=(a020*a036);
  a000=(a000+a049);
  a049=(a222*a185);
  a330=(a034*a074);
  a049=(a049-a330);
  a330=(a039*a229);
  a049=(a049+a330);
  a000=(a000+a049);
  a049=(a051*a000);
  a049=(a074+a049);
  a330=(a064*a049);
  a262=(a262+a330);
  a330=(a251*a287);
  a136=(a012*a296);
  a330=(a330+a136);
  a136=(a279*a036);
  a330=(a330-a136);
  a136=(a193*a185);
  a154=(a011*a074);
  a136=(a136+a154);
  a154=(a037*a229);
  a136=(a136-a154);
  a330=(a330+a136);
  a136=(a051*a330);
  a136=(a229+a136);
  a154=(a067*a136);
  a262=(a262-a154);
  a090=(a090+a262);
  a090=(a050*a090);
  a238=(a238+a090);
  a238=(a185+a238);
  a090=(a047*a238);
  a220=(a220+a090);
  a220=(a287+a220);
  a090=(a109*a220);
  a262=(a045*a074);
  a154=(a048*a000);
  a071=(a080*a015);
  a337=(a060*a009);
  a071=(a071+a337);
  a337=(a058*a221);
  a071=(a071+a337);
  a337=(a271*a242);
  a172=(a061*a049);
  a337=(a337-a172);
  a172=(a072*a136);
  a337=(a337+a172);
  a071=(a071+a337);
  a071=(a050*a071);
  a154=(a154+a071);
  a154=(a074+a154);
  a071=(a047*a154);
  a262=(a262+a071);
  a262=(a296+a262);
  a071=(a104*a262);
  a090=(a090+a071);
  a071=(a045*a229);
  a337=(a048*a330);
  a015=(a138*a015);
  a009=(a057*a009);
  a015=(a015+a009);
  a221=(a094*a221);
  a015=(a015-a221);
  a221=(a241*a242);
  a009=(a055*a049);
  a221=(a221+a009);
  a009=(a070*a136);
  a221=(a221-a009);
  a015=(a015+a221);
  a015=(a050*a015);
  a337=(a337+a015);
  a337=(a229+a337);
  a015=(a047*a337);
  a071=(a071+a015);
  a071=(a036+a071);
  a015=(a184*a071);
  a090=(a090-a015);
  a015=(a045*a299);
  a221=(a048*a185);
  a242=(a050*a242);
  a221=(a221+a242);
  a221=(a287+a221);
  a242=(a091*a221);
  a009=(a048*a074);
  a049=(a050*a049);
  a009=(a009+a049);
  a009=(a296+a009);
  a049=(a065*a009);
  a242=(a242+a049);
  a049=(a048*a229);
  a136=(a050*a136);
  a049=(a049+a136);
  a049=(a036+a049);
  a136=(a083*a049);
  a242=(a242-a136);
  a136=(a303*a238);
  a172=(a054*a154);
  a136=(a136+a172);
  a172=(a066*a337);
  a136=(a136-a172);
  a242=(a242+a136);
  a136=(a047*a242);
  a015=(a015+a136);
  a015=(a185+a015);
  a136=(a028*a015);
  a172=(a045*a000);
  a175=(a301*a221);
  a173=(a077*a009);
  a175=(a175+a173);
  a173=(a062*a049);
  a175=(a175+a173);
  a173=(a305*a238);
  a023=(a085*a154);
  a173=(a173-a023);
  a023=(a089*a337);
  a173=(a173+a023);
  a175=(a175+a173);
  a173=(a047*a175);
  a172=(a172+a173);
  a172=(a074+a172);
  a173=(a100*a172);
  a136=(a136+a173);
  a173=(a045*a330);
  a221=(a095*a221);
  a009=(a082*a009);
  a221=(a221+a009);
  a049=(a056*a049);
  a221=(a221-a049);
  a049=(a306*a238);
  a009=(a069*a154);
  a049=(a049+a009);
  a009=(a087*a337);
  a049=(a049-a009);
  a221=(a221+a049);
  a049=(a047*a221);
  a173=(a173+a049);
  a173=(a229+a173);
  a049=(a103*a173);
  a136=(a136-a049);
  a090=(a090+a136);
  a136=(a030*a090);
  a342=(a342+a136);
  a136=(a105*a185);
  a238=(a112*a238);
  a136=(a136+a238);
  a238=(a086*a015);
  a136=(a136+a238);
  a136=(a287+a136);
  a238=(a132*a136);
  a049=(a105*a074);
  a154=(a112*a154);
  a049=(a049+a154);
  a154=(a086*a172);
  a049=(a049+a154);
  a049=(a296+a049);
  a154=(a127*a049);
  a238=(a238+a154);
  a154=(a105*a229);
  a337=(a112*a337);
  a154=(a154+a337);
  a337=(a086*a173);
  a154=(a154+a337);
  a154=(a036+a154);
  a337=(a122*a154);
  a238=(a238-a337);
  a337=(a105*a299);
  a242=(a112*a242);
  a337=(a337+a242);
  a242=(a086*a090);
  a337=(a337+a242);
  a337=(a185+a337);
  a242=(a079*a337);
  a009=(a105*a000);
  a175=(a112*a175);
  a009=(a009+a175);
  a175=(a165*a220);
  a023=(a096*a262);
  a175=(a175+a023);
  a023=(a212*a071);
  a175=(a175+a023);
  a023=(a110*a015);
  a323=(a097*a172);
  a023=(a023-a323);
  a323=(a108*a173);
  a023=(a023+a323);
  a175=(a175+a023);
  a023=(a086*a175);
  a009=(a009+a023);
  a009=(a074+a009);
  a023=(a123*a009);
  a242=(a242+a023);
  a023=(a105*a330);
  a221=(a112*a221);
  a023=(a023+a221);
  a220=(a010*a220);
  a262=(a093*a262);
  a220=(a220+a262);
  a071=(a044*a071);
  a220=(a220-a071);
  a071=(a302*a015);
  a262=(a053*a172);
  a071=(a071+a262);
  a262=(a106*a173);
  a071=(a071-a262);
  a220=(a220+a071);
  a071=(a086*a220);
  a023=(a023+a071);
  a023=(a229+a023);
  a071=(a126*a023);
  a242=(a242-a071);
  a238=(a238+a242);
  a242=(a102*a238);
  a342=(a342+a242);
  a342=(a185+a342);
  a242=(a005*a342);
  a038=(a038+a242);
  a242=(a128*a299);
  a071=(a092*a090);
  a242=(a242+a071);
  a071=(a134*a238);
  a242=(a242+a071);
  a071=(a006*a185);
  a262=(a030*a015);
  a071=(a071+a262);
  a262=(a102*a337);
  a071=(a071+a262);
  a071=(a287+a071);
  a262=(a156*a071);
  a221=(a006*a074);
  a323=(a030*a172);
  a221=(a221+a323);
  a323=(a102*a009);
  a221=(a221+a323);
  a221=(a296+a221);
  a323=(a151*a221);
  a262=(a262+a323);
  a323=(a006*a229);
  a111=(a030*a173);
  a323=(a323+a111);
  a111=(a102*a023);
  a323=(a323+a111);
  a323=(a036+a323);
  a111=(a133*a323);
  a262=(a262-a111);
  a111=(a308*a342);
  a130=(a006*a000);
  a035=(a030*a175);
  a130=(a130+a035);
  a035=(a088*a136);
  a027=(a119*a049);
  a035=(a035+a027);
  a027=(a304*a154);
  a035=(a035+a027);
  a027=(a059*a337);
  a033=(a120*a009);
  a027=(a027-a033);
  a033=(a131*a023);
  a027=(a027+a033);
  a035=(a035+a027);
  a027=(a102*a035);
  a130=(a130+a027);
  a130=(a074+a130);
  a027=(a147*a130);
  a111=(a111+a027);
  a027=(a006*a330);
  a033=(a030*a220);
  a027=(a027+a033);
  a136=(a075*a136);
  a049=(a081*a049);
  a136=(a136+a049);
  a154=(a003*a154);
  a136=(a136-a154);
  a154=(a076*a337);
  a049=(a115*a009);
  a154=(a154+a049);
  a049=(a129*a023);
  a154=(a154-a049);
  a136=(a136+a154);
  a154=(a102*a136);
  a027=(a027+a154);
  a027=(a229+a027);
  a154=(a150*a027);
  a111=(a111-a154);
  a262=(a262+a111);
  a111=(a135*a262);
  a242=(a242+a111);
  a242=(a185+a242);
  a111=(a125*a242);
  a038=(a038+a111);
  a111=(a152*a299);
  a154=(a159*a090);
  a111=(a111+a154);
  a154=(a160*a238);
  a111=(a111+a154);
  a154=(a161*a262);
  a111=(a111+a154);
  a154=(a128*a185);
  a049=(a092*a015);
  a154=(a154+a049);
  a049=(a134*a337);
  a154=(a154+a049);
  a049=(a135*a342);
  a154=(a154+a049);
  a154=(a287+a154);
  a049=(a183*a154);
  a033=(a128*a074);
  a019=(a092*a172);
  a033=(a033+a019);
  a019=(a134*a009);
  a033=(a033+a019);
  a019=(a135*a130);
  a033=(a033+a019);
  a033=(a296+a033);
  a019=(a178*a033);
  a049=(a049+a019);
  a019=(a128*a229);
  a252=(a092*a173);
  a019=(a019+a252);
  a252=(a134*a023);
  a019=(a019+a252);
  a252=(a135*a027);
  a019=(a019+a252);
  a019=(a036+a019);
  a252=(a312*a019);
  a049=(a049-a252);
  a252=(a315*a242);
  a288=(a128*a000);
  a163=(a092*a175);
  a288=(a288+a163);
  a163=(a134*a035);
  a288=(a288+a163);
  a163=(a116*a071);
  a181=(a143*a221);
  a163=(a163+a181);
  a181=(a141*a323);
  a163=(a163+a181);
  a181=(a310*a342);
  a272=(a144*a130);
  a181=(a181-a272);
  a272=(a155*a027);
  a181=(a181+a272);
  a163=(a163+a181);
  a181=(a135*a163);
  a288=(a288+a181);
  a288=(a074+a288);
  a181=(a174*a288);
  a252=(a252+a181);
  a181=(a128*a330);
  a272=(a092*a220);
  a181=(a181+a272);
  a272=(a134*a136);
  a181=(a181+a272);
  a071=(a013*a071);
  a221=(a140*a221);
  a071=(a071+a221);
  a323=(a157*a323);
  a071=(a071-a323);
  a323=(a311*a342);
  a221=(a139*a130);
  a323=(a323+a221);
  a221=(a153*a027);
  a323=(a323-a221);
  a071=(a071+a323);
  a323=(a135*a071);
  a181=(a181+a323);
  a181=(a229+a181);
  a323=(a177*a181);
  a252=(a252-a323);
  a049=(a049+a252);
  a252=(a162*a049);
  a111=(a111+a252);
  a111=(a185+a111);
  a252=(a149*a111);
  a038=(a038+a252);
  a252=(a179*a299);
  a323=(a186*a090);
  a252=(a252+a323);
  a323=(a187*a238);
  a252=(a252+a323);
  a323=(a188*a262);
  a252=(a252+a323);
  a323=(a189*a049);
  a252=(a252+a323);
  a323=(a152*a185);
  a221=(a159*a015);
  a323=(a323+a221);
  a221=(a160*a337);
  a323=(a323+a221);
  a221=(a161*a342);
  a323=(a323+a221);
  a221=(a162*a242);
  a323=(a323+a221);
  a323=(a287+a323);
  a221=(a211*a323);
  a272=(a152*a074);
  a145=(a159*a172);
  a272=(a272+a145);
  a145=(a160*a009);
  a272=(a272+a145);
  a145=(a161*a130);
  a272=(a272+a145);
  a145=(a162*a288);
  a272=(a272+a145);
  a272=(a296+a272);
  a145=(a206*a272);
  a221=(a221+a145);
  a145=(a152*a229);
  a004=(a159*a173);
  a145=(a145+a004);
  a004=(a160*a023);
  a145=(a145+a004);
  a004=(a161*a027);
  a145=(a145+a004);
  a004=(a162*a181);
  a145=(a145+a004);
  a145=(a036+a145);
  a004=(a319*a145);
  a221=(a221-a004);
  a004=(a322*a111);
  a191=(a152*a000);
  a209=(a159*a175);
  a191=(a191+a209);
  a209=(a160*a035);
  a191=(a191+a209);
  a209=(a161*a163);
  a191=(a191+a209);
  a209=(a142*a154);
  a291=(a170*a033);
  a209=(a209+a291);
  a291=(a168*a019);
  a209=(a209+a291);
  a291=(a317*a242);
  a052=(a171*a288);
  a291=(a291-a052);
  a052=(a182*a181);
  a291=(a291+a052);
  a209=(a209+a291);
  a291=(a162*a209);
  a191=(a191+a291);
  a191=(a074+a191);
  a291=(a202*a191);
  a004=(a004+a291);
  a291=(a152*a330);
  a052=(a159*a220);
  a291=(a291+a052);
  a052=(a160*a136);
  a291=(a291+a052);
  a052=(a161*a071);
  a291=(a291+a052);
  a154=(a148*a154);
  a033=(a167*a033);
  a154=(a154+a033);
  a019=(a117*a019);
  a154=(a154-a019);
  a019=(a318*a242);
  a033=(a166*a288);
  a019=(a019+a033);
  a033=(a180*a181);
  a019=(a019-a033);
  a154=(a154+a019);
  a019=(a162*a154);
  a291=(a291+a019);
  a291=(a229+a291);
  a019=(a205*a291);
  a004=(a004-a019);
  a221=(a221+a004);
  a004=(a190*a221);
  a252=(a252+a004);
  a252=(a185+a252);
  a004=(a176*a252);
  a038=(a038+a004);
  a004=(a207*a299);
  a019=(a214*a090);
  a004=(a004+a019);
  a019=(a215*a238);
  a004=(a004+a019);
  a019=(a216*a262);
  a004=(a004+a019);
  a019=(a217*a049);
  a004=(a004+a019);
  a019=(a218*a221);
  a004=(a004+a019);
  a019=(a179*a185);
  a033=(a186*a015);
  a019=(a019+a033);
  a033=(a187*a337);
  a019=(a019+a033);
  a033=(a188*a342);
  a019=(a019+a033);
  a033=(a189*a242);
  a019=(a019+a033);
  a033=(a190*a111);
  a019=(a019+a033);
  a019=(a287+a019);
  a033=(a240*a019);
  a052=(a179*a074);
  a164=(a186*a172);
  a052=(a052+a164);
  a164=(a187*a009);
  a052=(a052+a164);
  a164=(a188*a130);
  a052=(a052+a164);
  a164=(a189*a288);
  a052=(a052+a164);
  a164=(a190*a191);
  a052=(a052+a164);
  a052=(a296+a052);
  a164=(a235*a052);
  a033=(a033+a164);
  a164=(a179*a229);
  a017=(a186*a173);
  a164=(a164+a017);
  a017=(a187*a023);
  a164=(a164+a017);
  a017=(a188*a027);
  a164=(a164+a017);
  a017=(a189*a181);
  a164=(a164+a017);
  a017=(a190*a291);
  a164=(a164+a017);
  a164=(a036+a164);
  a017=(a326*a164);
  a033=(a033-a017);
  a017=(a329*a252);
  a200=(a179*a000);
  a107=(a186*a175);
  a200=(a200+a107);
  a107=(a187*a035);
  a200=(a200+a107);
  a107=(a188*a163);
  a200=(a200+a107);
  a107=(a189*a209);
  a200=(a200+a107);
  a107=(a169*a323);
  a203=(a198*a272);
  a107=(a107+a203);
  a203=(a196*a145);
  a107=(a107+a203);
  a203=(a324*a111);
  a008=(a199*a191);
  a203=(a203-a008);
  a008=(a210*a291);
  a203=(a203+a008);
  a107=(a107+a203);
  a203=(a190*a107);
  a200=(a200+a203);
  a200=(a074+a200);
  a203=(a231*a200);
  a017=(a017+a203);
  a203=(a179*a330);
  a008=(a186*a220);
  a203=(a203+a008);
  a008=(a187*a136);
  a203=(a203+a008);
  a008=(a188*a071);
  a203=(a203+a008);
  a008=(a189*a154);
  a203=(a203+a008);
  a323=(a078*a323);
  a272=(a195*a272);
  a323=(a323+a272);
  a145=(a118*a145);
  a323=(a323-a145);
  a145=(a325*a111);
  a272=(a194*a191);
  a145=(a145+a272);
  a272=(a208*a291);
  a145=(a145-a272);
  a323=(a323+a145);
  a145=(a190*a323);
  a203=(a203+a145);
  a203=(a229+a203);
  a145=(a234*a203);
  a017=(a017-a145);
  a033=(a033+a017);
  a017=(a219*a033);
  a004=(a004+a017);
  a004=(a185+a004);
  a017=(a204*a004);
  a038=(a038+a017);
  a017=(a236*a299);
  a145=(a243*a090);
  a017=(a017+a145);
  a145=(a244*a238);
  a017=(a017+a145);
  a145=(a245*a262);
  a017=(a017+a145);
  a145=(a246*a049);
  a017=(a017+a145);
  a145=(a247*a221);
  a017=(a017+a145);
  a145=(a248*a033);
  a017=(a017+a145);
  a145=(a207*a185);
  a272=(a214*a015);
  a145=(a145+a272);
  a272=(a215*a337);
  a145=(a145+a272);
  a272=(a216*a342);
  a145=(a145+a272);
  a272=(a217*a242);
  a145=(a145+a272);
  a272=(a218*a111);
  a145=(a145+a272);
  a272=(a219*a252);
  a145=(a145+a272);
  a145=(a287+a145);
  a272=(a270*a145);
  a008=(a207*a074);
  a213=(a214*a172);
  a008=(a008+a213);
  a213=(a215*a009);
  a008=(a008+a213);
  a213=(a216*a130);
  a008=(a008+a213);
  a213=(a217*a288);
  a008=(a008+a213);
  a213=(a218*a191);
  a008=(a008+a213);
  a213=(a219*a200);
  a008=(a008+a213);
  a008=(a296+a008);
  a213=(a265*a008);
  a272=(a272+a213);
  a213=(a207*a229);
  a024=(a214*a173);
  a213=(a213+a024);
  a024=(a215*a023);
  a213=(a213+a024);
  a024=(a216*a027);
  a213=(a213+a024);
  a024=(a217*a181);
  a213=(a213+a024);
  a024=(a218*a291);
  a213=(a213+a024);
  a024=(a219*a203);
  a213=(a213+a024);
  a213=(a036+a213);
  a024=(a333*a213);
  a272=(a272-a024);
  a024=(a336*a004);
  a042=(a207*a000);
  a046=(a214*a175);
  a042=(a042+a046);
  a046=(a215*a035);
  a042=(a042+a046);
  a046=(a216*a163);
  a042=(a042+a046);
  a046=(a217*a209);
  a042=(a042+a046);
  a046=(a218*a107);
  a042=(a042+a046);
  a046=(a197*a019);
  a230=(a227*a052);
  a046=(a046+a230);
  a230=(a225*a164);
  a046=(a046+a230);
  a230=(a331*a252);
  a158=(a228*a200);
  a230=(a230-a158);
  a158=(a239*a203);
  a230=(a230+a158);
  a046=(a046+a230);
  a230=(a219*a046);
  a042=(a042+a230);
  a042=(a074+a042);
  a230=(a261*a042);
  a024=(a024+a230);
  a230=(a207*a330);
  a158=(a214*a220);
  a230=(a230+a158);
  a158=(a215*a136);
  a230=(a230+a158);
  a158=(a216*a071);
  a230=(a230+a158);
  a158=(a217*a154);
  a230=(a230+a158);
  a158=(a218*a323);
  a230=(a230+a158);
  a019=(a307*a019);
  a052=(a224*a052);
  a019=(a019+a052);
  a164=(a313*a164);
  a019=(a019-a164);
  a164=(a332*a252);
  a052=(a223*a200);
  a164=(a164+a052);
  a052=(a237*a203);
  a164=(a164-a052);
  a019=(a019+a164);
  a164=(a219*a019);
  a230=(a230+a164);
  a230=(a229+a230);
  a164=(a264*a230);
  a024=(a024-a164);
  a272=(a272+a024);
  a024=(a249*a272);
  a017=(a017+a024);
  a017=(a185+a017);
  a024=(a233*a017);
  a038=(a038+a024);
  a024=(a266*a299);
  a090=(a273*a090);
  a024=(a024+a090);
  a238=(a101*a238);
  a024=(a024+a238);
  a238=(a124*a262);
  a024=(a024+a238);
  a238=(a274*a049);
  a024=(a024+a238);
  a238=(a275*a221);
  a024=(a024+a238);
  a238=(a276*a033);
  a024=(a024+a238);
  a238=(a277*a272);
  a024=(a024+a238);
  a238=(a236*a185);
  a090=(a243*a015);
  a238=(a238+a090);
  a090=(a244*a337);
  a238=(a238+a090);
  a090=(a245*a342);
  a238=(a238+a090);
  a090=(a246*a242);
  a238=(a238+a090);
  a090=(a247*a111);
  a238=(a238+a090);
  a090=(a248*a252);
  a238=(a238+a090);
  a090=(a249*a004);
  a238=(a238+a090);
  a238=(a287+a238);
  a090=(a298*a238);
  a164=(a236*a074);
  a052=(a243*a172);
  a164=(a164+a052);
  a052=(a244*a009);
  a164=(a164+a052);
  a052=(a245*a130);
  a164=(a164+a052);
  a052=(a246*a288);
  a164=(a164+a052);
  a052=(a247*a191);
  a164=(a164+a052);
  a052=(a248*a200);
  a164=(a164+a052);
  a052=(a249*a042);
  a164=(a164+a052);
  a164=(a296+a164);
  a052=(a293*a164);
  a090=(a090+a052);
  a052=(a236*a229);
  a158=(a243*a173);
  a052=(a052+a158);
  a158=(a244*a023);
  a052=(a052+a158);
  a158=(a245*a027);
  a052=(a052+a158);
  a158=(a246*a181);
  a052=(a052+a158);
  a158=(a247*a291);
  a052=(a052+a158);
  a158=(a248*a203);
  a052=(a052+a158);
  a158=(a249*a230);
  a052=(a052+a158);
  a052=(a036+a052);
  a158=(a335*a052);
  a090=(a090-a158);
  a158=(a341*a017);
  a259=(a236*a000);
  a309=(a243*a175);
  a259=(a259+a309);
  a309=(a244*a035);
  a259=(a259+a309);
  a309=(a245*a163);
  a259=(a259+a309);
  a309=(a246*a209);
  a259=(a259+a309);
  a309=(a247*a107);
  a259=(a259+a309);
  a309=(a248*a046);
  a259=(a259+a309);
  a309=(a226*a145);
  a316=(a257*a008);
  a309=(a309+a316);
  a316=(a255*a213);
  a309=(a309+a316);
  a316=(a338*a004);
  a146=(a258*a042);
  a316=(a316-a146);
  a146=(a269*a230);
  a316=(a316+a146);
  a309=(a309+a316);
  a316=(a249*a309);
  a259=(a259+a316);
  a259=(a074+a259);
  a316=(a289*a259);
  a158=(a158+a316);
  a316=(a236*a330);
  a146=(a243*a220);
  a316=(a316+a146);
  a146=(a244*a136);
  a316=(a316+a146);
  a146=(a245*a071);
  a316=(a316+a146);
  a146=(a246*a154);
  a316=(a316+a146);
  a146=(a247*a323);
  a316=(a316+a146);
  a146=(a248*a019);
  a316=(a316+a146);
  a145=(a314*a145);
  a008=(a254*a008);
  a145=(a145+a008);
  a213=(a320*a213);
  a145=(a145-a213);
  a213=(a339*a004);
  a008=(a253*a042);
  a213=(a213+a008);
  a008=(a267*a230);
  a213=(a213-a008);
  a145=(a145+a213);
  a213=(a249*a145);
  a316=(a316+a213);
  a316=(a229+a316);
  a213=(a292*a316);
  a158=(a158-a213);
  a090=(a090+a158);
  a158=(a278*a090);
  a024=(a024+a158);
  a024=(a185+a024);
  a158=(a263*a024);
  a038=(a038+a158);
  a038=(a287+a038);
  if (res[0]!=0) res[0][18]=a038;
  a038=(a001*a074);
  a158=(a005*a130);
  a038=(a038+a158);
  a158=(a125*a288);
  a038=(a038+a158);
  a158=(a149*a191);
  a038=(a038+a158);
  a158=(a176*a200);
  a038=(a038+a158);
  a158=(a204*a042);
  a038=(a038+a158);
  a158=(a233*a259);
  a038=(a038+a158);
  a158=(a266*a000);
  a175=(a273*a175);
  a158=(a158+a175);
  a035=(a101*a035);
  a158=(a158+a035);
  a035=(a124*a163);
  a158=(a158+a035);
  a035=(a274*a209);
  a158=(a158+a035);
  a035=(a275*a107);
  a158=(a158+a035);
  a035=(a276*a046);
  a158=(a158+a035);
  a035=(a277*a309);
  a158=(a158+a035);
  a035=(a321*a238);
  a175=(a285*a164);
  a035=(a035+a175);
  a175=(a283*a052);
  a035=(a035+a175);
  a175=(a343*a017);
  a213=(a286*a259);
  a175=(a175-a213);
  a213=(a297*a316);
  a175=(a175+a213);
  a035=(a035+a175);
  a175=(a278*a035);
  a158=(a158+a175);
  a158=(a074+a158);
  a175=(a263*a158);
  a038=(a038+a175);
  a038=(a296+a038);
  if (res[0]!=0) res[0][19]=a038;
  a038=(a001*a229);
  a175=(a005*a027);
  a038=(a038+a175);
  a175=(a125*a181);
  a038=(a038+a175);
  a175=(a149*a291);
  a038=(a038+a175);
  a175=(a176*a203);
  a038=(a038+a175);
  a175=(a204*a230);
  a038=(a038+a175);
  a175=(a233*a316);
  a038=(a038+a175);
  a175=(a266*a330);
  a220=(a273*a220);
  a175=(a175+a220);
  a136=(a101*a136);
  a175=(a175+a136);
  a136=(a124*a071);
  a175=(a175+a136);
  a136=(a274*a154);
  a175=(a175+a136);
  a136=(a275*a323);
  a175=(a175+a136);
  a136=(a276*a019);
  a175=(a175+a136);
  a136=(a277*a145);
  a175=(a175+a136);
  a238=(a063*a238);
  a164=(a282*a164);
  a238=(a238+a164);
  a052=(a099*a052);
  a238=(a238-a052);
  a052=(a344*a017);
  a164=(a281*a259);
  a052=(a052+a164);
  a164=(a295*a316);
  a052=(a052-a164);
  a238=(a238+a052);
  a052=(a278*a238);
  a175=(a175+a052);
  a175=(a229+a175);
  a052=(a263*a175);
  a038=(a038+a052);
  a038=(a036+a038);
  if (res[0]!=0) res[0][20]=a038;
  a299=(a001*a299);
  a262=(a005*a262);
  a299=(a299+a262);
  a049=(a125*a049);
  a299=(a299+a049);
  a221=(a149*a221);
  a299=(a299+a221);
  a033=(a176*a033);
  a299=(a299+a033);
  a272=(a204*a272);
  a299=(a299+a272);
  a090=(a233*a090);
  a299=(a299+a090);
  a090=(a266*a185);
  a015=(a273*a015);
  a090=(a090+a015);
  a337=(a101*a337);
  a090=(a090+a337);
  a342=(a124*a342);
  a090=(a090+a342);
  a242=(a274*a242);
  a090=(a090+a242);
  a111=(a275*a111);
  a090=(a090+a111);
  a252=(a276*a252);
  a090=(a090+a252);
  a004=(a277*a004);
  a090=(a090+a004);
  a017=(a278*a017);
  a090=(a090+a017);
  a287=(a287+a090);
  a090=(a029*a287);
  a017=(a266*a074);
  a172=(a273*a172);
  a017=(a017+a172);
  a009=(a101*a009);
  a017=(a017+a009);
  a130=(a124*a130);
  a017=(a017+a130);
  a288=(a274*a288);
  a017=(a017+a288);
  a191=(a275*a191);
  a017=(a017+a191);
  a200=(a276*a200);
  a017=(a017+a200);
  a042=(a277*a042);
  a017=(a017+a042);
  a259=(a278*a259);
  a017=(a017+a259);
  a296=(a296+a017);
  a017=(a300*a296);
  a090=(a090+a017);
  a017=(a266*a229);
  a173=(a273*a173);
  a017=(a017+a173);
  a023=(a101*a023);
  a017=(a017+a023);
  a027=(a124*a027);
  a017=(a017+a027);
  a181=(a274*a181);
  a017=(a017+a181);
  a291=(a275*a291);
  a017=(a017+a291);
  a203=(a276*a203);
  a017=(a017+a203);
  a230=(a277*a230);
  a017=(a017+a230);
  a316=(a278*a316);
  a017=(a017+a316);
  a036=(a036+a017);
  a017=(a002*a036);
  a090=(a090-a017);
  a017=(a250*a024);
  a316=(a113*a158);
  a017=(a017+a316);
  a316=(a294*a175);
  a017=(a017-a316);
  a090=(a090+a017);
  a090=(a263*a090);
  a299=(a299+a090);
  a185=(a185+a299);
  if (res[0]!=0) res[0][21]=a185;
  a000=(a001*a000);
  a163=(a005*a163);
  a000=(a000+a163);
  a209=(a125*a209);
  a000=(a000+a209);
  a107=(a149*a107);
  a000=(a000+a107);
  a046=(a176*a046);
  a000=(a000+a046);
  a309=(a204*a309);
  a000=(a000+a309);
  a035=(a233*a035);
  a000=(a000+a035);
  a035=(a201*a287);
  a309=(a031*a296);
  a035=(a035+a309);
  a309=(a007*a036);
  a035=(a035+a309);
  a309=(a268*a024);
  a046=(a032*a158);
  a309=(a309-a046);
  a046=(a018*a175);
  a309=(a309+a046);
  a035=(a035+a309);
  a035=(a263*a035);
  a000=(a000+a035);
  a074=(a074+a000);
  if (res[0]!=0) res[0][22]=a074;
  a330=(a001*a330);
  a071=(a005*a071);
  a330=(a330+a071);
  a154=(a125*a154);
  a330=(a330+a154);
  a323=(a149*a323);
  a330=(a330+a323);
  a019=(a176*a019);
  a330=(a330+a019);
  a145=(a204*a145);
  a330=(a330+a145);
  a238=(a233*a238);
  a330=(a330+a238);
  a287=(a260*a287);
  a296=(a232*a296);
  a287=(a287+a296);
  a036=(a043*a036);
  a287=(a287-a036);
  a024=(a137*a024);
  a158=(a021*a158);
  a024=(a024+a158);
  a175=(a041*a175);
  a024=(a024-a175);
  a287=(a287+a024);
  a287=(a263*a287);
  a330=(a330+a287);
  a229=(a229+a330);
  if (res[0]!=0) res[0][23]=a229;
  a229=arg[0]? arg[0][24] : 0;
  a330=arg[0]? arg[0][27] : 0;
  a287=(a001*a330);
  a024=(a040*a229);
  a175=arg[0]? arg[0][25] : 0;
  a158=(a026*a175);
  a024=(a024+a158);
  a158=arg[0]? arg[0][26] : 0;
  a036=(a016*a158);
  a024=(a024-a036);
  a036=(a280*a330);
  a296=arg[0]? arg[0][28] : 0;
  a238=(a022*a296);
  a036=(a036+a238);
  a238=arg[0]? arg[0][29] : 0;
  a145=(a025*a238);
  a036=(a036-a145);
  a024=(a024+a036);
  a036=(a006*a024);
  a145=(a045*a330);
  a019=(a048*a024);
  a323=(a051*a330);
  a323=(a229+a323);
  a154=(a073*a323);
  a071=(a051*a296);
  a071=(a175+a071);
  a074=(a068*a071);
  a154=(a154+a074);
  a074=(a051*a238);
  a074=(a158+a074);
  a000=(a084*a074);
  a154=(a154-a000);
  a000=(a051*a024);
  a000=(a330+a000);
  a035=(a114*a000);
  a309=(a192*a229);
  a046=(a014*a175);
  a309=(a309+a046);
  a046=(a020*a158);
  a309=(a309+a046);
  a046=(a222*a330);
  a107=(a034*a296);
  a046=(a046-a107);
  a107=(a039*a238);
  a046=(a046+a107);
  a309=(a309+a046);
  a046=(a051*a309);
  a046=(a296+a046);
  a107=(a064*a046);
  a035=(a035+a107);
  a107=(a251*a229);
  a209=(a012*a175);
  a107=(a107+a209);
  a209=(a279*a158);
  a107=(a107-a209);
  a209=(a193*a330);
  a163=(a011*a296);
  a209=(a209+a163);
  a163=(a037*a238);
  a209=(a209-a163);
  a107=(a107+a209);
  a209=(a051*a107);
  a209=(a238+a209);
  a163=(a067*a209);
  a035=(a035-a163);
  a154=(a154+a035);
  a154=(a050*a154);
  a019=(a019+a154);
  a019=(a330+a019);
  a154=(a047*a019);
  a145=(a145+a154);
  a145=(a229+a145);
  a154=(a109*a145);
  a035=(a045*a296);
  a163=(a048*a309);
  a185=(a080*a323);
  a299=(a060*a071);
  a185=(a185+a299);
  a299=(a058*a074);
  a185=(a185+a299);
  a299=(a271*a000);
  a090=(a061*a046);
  a299=(a299-a090);
  a090=(a072*a209);
  a299=(a299+a090);
  a185=(a185+a299);
  a185=(a050*a185);
  a163=(a163+a185);
  a163=(a296+a163);
  a185=(a047*a163);
  a035=(a035+a185);
  a035=(a175+a035);
  a185=(a104*a035);
  a154=(a154+a185);
  a185=(a045*a238);
  a299=(a048*a107);
  a323=(a138*a323);
  a071=(a057*a071);
  a323=(a323+a071);
  a074=(a094*a074);
  a323=(a323-a074);
  a074=(a241*a000);
  a071=(a055*a046);
  a074=(a074+a071);
  a071=(a070*a209);
  a074=(a074-a071);
  a323=(a323+a074);
  a323=(a050*a323);
  a299=(a299+a323);
  a299=(a238+a299);
  a323=(a047*a299);
  a185=(a185+a323);
  a185=(a158+a185);
  a323=(a184*a185);
  a154=(a154-a323);
  a323=(a045*a024);
  a074=(a048*a330);
  a000=(a050*a000);
  a074=(a074+a000);
  a074=(a229+a074);
  a000=(a091*a074);
  a071=(a048*a296);
  a046=(a050*a046);
  a071=(a071+a046);
  a071=(a175+a071);
  a046=(a065*a071);
  a000=(a000+a046);
  a046=(a048*a238);
  a209=(a050*a209);
  a046=(a046+a209);
  a046=(a158+a046);
  a209=(a083*a046);
  a000=(a000-a209);
  a209=(a303*a019);
  a090=(a054*a163);
  a209=(a209+a090);
  a090=(a066*a299);
  a209=(a209-a090);
  a000=(a000+a209);
  a209=(a047*a000);
  a323=(a323+a209);
  a323=(a330+a323);
  a209=(a028*a323);
  a090=(a045*a309);
  a017=(a301*a074);
  a316=(a077*a071);
  a017=(a017+a316);
  a316=(a062*a046);
  a017=(a017+a316);
  a316=(a305*a019);
  a230=(a085*a163);
  a316=(a316-a230);
  a230=(a089*a299);
  a316=(a316+a230);
  a017=(a017+a316);
  a316=(a047*a017);
  a090=(a090+a316);
  a090=(a296+a090);
  a316=(a100*a090);
  a209=(a209+a316);
  a316=(a045*a107);
  a074=(a095*a074);
  a071=(a082*a071);
  a074=(a074+a071);
  a046=(a056*a046);
  a074=(a074-a046);
  a046=(a306*a019);
  a071=(a069*a163);
  a046=(a046+a071);
  a071=(a087*a299);
  a046=(a046-a071);
  a074=(a074+a046);
  a046=(a047*a074);
  a316=(a316+a046);
  a316=(a238+a316);
  a046=(a103*a316);
  a209=(a209-a046);
  a154=(a154+a209);
  a209=(a030*a154);
  a036=(a036+a209);
  a209=(a105*a330);
  a019=(a112*a019);
  a209=(a209+a019);
  a019=(a086*a323);
  a209=(a209+a019);
  a209=(a229+a209);
  a019=(a132*a209);
  a046=(a105*a296);
  a163=(a112*a163);
  a046=(a046+a163);
  a163=(a086*a090);
  a046=(a046+a163);
  a046=(a175+a046);
  a163=(a127*a046);
  a019=(a019+a163);
  a163=(a105*a238);
  a299=(a112*a299);
  a163=(a163+a299);
  a299=(a086*a316);
  a163=(a163+a299);
  a163=(a158+a163);
  a299=(a122*a163);
  a019=(a019-a299);
  a299=(a105*a024);
  a000=(a112*a000);
  a299=(a299+a000);
  a000=(a086*a154);
  a299=(a299+a000);
  a299=(a330+a299);
  a000=(a079*a299);
  a071=(a105*a309);
  a017=(a112*a017);
  a071=(a071+a017);
  a017=(a165*a145);
  a230=(a096*a035);
  a017=(a017+a230);
  a230=(a212*a185);
  a017=(a017+a230);
  a230=(a110*a323);
  a203=(a097*a090);
  a230=(a230-a203);
  a203=(a108*a316);
  a230=(a230+a203);
  a017=(a017+a230);
  a230=(a086*a017);
  a071=(a071+a230);
  a071=(a296+a071);
  a230=(a123*a071);
  a000=(a000+a230);
  a230=(a105*a107);
  a074=(a112*a074);
  a230=(a230+a074);
  a145=(a010*a145);
  a035=(a093*a035);
  a145=(a145+a035);
  a185=(a044*a185);
  a145=(a145-a185);
  a185=(a302*a323);
  a035=(a053*a090);
  a185=(a185+a035);
  a035=(a106*a316);
  a185=(a185-a035);
  a145=(a145+a185);
  a185=(a086*a145);
  a230=(a230+a185);
  a230=(a238+a230);
  a185=(a126*a230);
  a000=(a000-a185);
  a019=(a019+a000);
  a000=(a102*a019);
  a036=(a036+a000);
  a036=(a330+a036);
  a000=(a005*a036);
  a287=(a287+a000);
  a000=(a128*a024);
  a185=(a092*a154);
  a000=(a000+a185);
  a185=(a134*a019);
  a000=(a000+a185);
  a185=(a006*a330);
  a035=(a030*a323);
  a185=(a185+a035);
  a035=(a102*a299);
  a185=(a185+a035);
  a185=(a229+a185);
  a035=(a156*a185);
  a074=(a006*a296);
  a203=(a030*a090);
  a074=(a074+a203);
  a203=(a102*a071);
  a074=(a074+a203);
  a074=(a175+a074);
  a203=(a151*a074);
  a035=(a035+a203);
  a203=(a006*a238);
  a291=(a030*a316);
  a203=(a203+a291);
  a291=(a102*a230);
  a203=(a203+a291);
  a203=(a158+a203);
  a291=(a133*a203);
  a035=(a035-a291);
  a291=(a308*a036);
  a181=(a006*a309);
  a027=(a030*a017);
  a181=(a181+a027);
  a027=(a088*a209);
  a023=(a119*a046);
  a027=(a027+a023);
  a023=(a304*a163);
  a027=(a027+a023);
  a023=(a059*a299);
  a173=(a120*a071);
  a023=(a023-a173);
  a173=(a131*a230);
  a023=(a023+a173);
  a027=(a027+a023);
  a023=(a102*a027);
  a181=(a181+a023);
  a181=(a296+a181);
  a023=(a147*a181);
  a291=(a291+a023);
  a023=(a006*a107);
  a173=(a030*a145);
  a023=(a023+a173);
  a209=(a075*a209);
  a046=(a081*a046);
  a209=(a209+a046);
  a163=(a003*a163);
  a209=(a209-a163);
  a163=(a076*a299);
  a046=(a115*a071);
  a163=(a163+a046);
  a046=(a129*a230);
  a163=(a163-a046);
  a209=(a209+a163);
  a163=(a102*a209);
  a023=(a023+a163);
  a023=(a238+a023);
  a163=(a150*a023);
  a291=(a291-a163);
  a035=(a035+a291);
  a291=(a135*a035);
  a000=(a000+a291);
  a000=(a330+a000);
  a291=(a125*a000);
  a287=(a287+a291);
  a291=(a152*a024);
  a163=(a159*a154);
  a291=(a291+a163);
  a163=(a160*a019);
  a291=(a291+a163);
  a163=(a161*a035);
  a291=(a291+a163);
  a163=(a128*a330);
  a046=(a092*a323);
  a163=(a163+a046);
  a046=(a134*a299);
  a163=(a163+a046);
  a046=(a135*a036);
  a163=(a163+a046);
  a163=(a229+a163);
  a046=(a183*a163);
  a173=(a128*a296);
  a259=(a092*a090);
  a173=(a173+a259);
  a259=(a134*a071);
  a173=(a173+a259);
  a259=(a135*a181);
  a173=(a173+a259);
  a173=(a175+a173);
  a259=(a178*a173);
  a046=(a046+a259);
  a259=(a128*a238);
  a042=(a092*a316);
  a259=(a259+a042);
  a042=(a134*a230);
  a259=(a259+a042);
  a042=(a135*a023);
  a259=(a259+a042);
  a259=(a158+a259);
  a042=(a312*a259);
  a046=(a046-a042);
  a042=(a315*a000);
  a200=(a128*a309);
  a191=(a092*a017);
  a200=(a200+a191);
  a191=(a134*a027);
  a200=(a200+a191);
  a191=(a116*a185);
  a288=(a143*a074);
  a191=(a191+a288);
  a288=(a141*a203);
  a191=(a191+a288);
  a288=(a310*a036);
  a130=(a144*a181);
  a288=(a288-a130);
  a130=(a155*a023);
  a288=(a288+a130);
  a191=(a191+a288);
  a288=(a135*a191);
  a200=(a200+a288);
  a200=(a296+a200);
  a288=(a174*a200);
  a042=(a042+a288);
  a288=(a128*a107);
  a130=(a092*a145);
  a288=(a288+a130);
  a130=(a134*a209);
  a288=(a288+a130);
  a185=(a013*a185);
  a074=(a140*a074);
  a185=(a185+a074);
  a203=(a157*a203);
  a185=(a185-a203);
  a203=(a311*a036);
  a074=(a139*a181);
  a203=(a203+a074);
  a074=(a153*a023);
  a203=(a203-a074);
  a185=(a185+a203);
  a203=(a135*a185);
  a288=(a288+a203);
  a288=(a238+a288);
  a203=(a177*a288);
  a042=(a042-a203);
  a046=(a046+a042);
  a042=(a162*a046);
  a291=(a291+a042);
  a291=(a330+a291);
  a042=(a149*a291);
  a287=(a287+a042);
  a042=(a179*a024);
  a203=(a186*a154);
  a042=(a042+a203);
  a203=(a187*a019);
  a042=(a042+a203);
  a203=(a188*a035);
  a042=(a042+a203);
  a203=(a189*a046);
  a042=(a042+a203);
  a203=(a152*a330);
  a074=(a159*a323);
  a203=(a203+a074);
  a074=(a160*a299);
  a203=(a203+a074);
  a074=(a161*a036);
  a203=(a203+a074);
  a074=(a162*a000);
  a203=(a203+a074);
  a203=(a229+a203);
  a074=(a211*a203);
  a130=(a152*a296);
  a009=(a159*a090);
  a130=(a130+a009);
  a009=(a160*a071);
  a130=(a130+a009);
  a009=(a161*a181);
  a130=(a130+a009);
  a009=(a162*a200);
  a130=(a130+a009);
  a130=(a175+a130);
  a009=(a206*a130);
  a074=(a074+a009);
  a009=(a152*a238);
  a172=(a159*a316);
  a009=(a009+a172);
  a172=(a160*a230);
  a009=(a009+a172);
  a172=(a161*a023);
  a009=(a009+a172);
  a172=(a162*a288);
  a009=(a009+a172);
  a009=(a158+a009);
  a172=(a319*a009);
  a074=(a074-a172);
  a172=(a322*a291);
  a004=(a152*a309);
  a252=(a159*a017);
  a004=(a004+a252);
  a252=(a160*a027);
  a004=(a004+a252);
  a252=(a161*a191);
  a004=(a004+a252);
  a252=(a142*a163);
  a111=(a170*a173);
  a252=(a252+a111);
  a111=(a168*a259);
  a252=(a252+a111);
  a111=(a317*a000);
  a242=(a171*a200);
  a111=(a111-a242);
  a242=(a182*a288);
  a111=(a111+a242);
  a252=(a252+a111);
  a111=(a162*a252);
  a004=(a004+a111);
  a004=(a296+a004);
  a111=(a202*a004);
  a172=(a172+a111);
  a111=(a152*a107);
  a242=(a159*a145);
  a111=(a111+a242);
  a242=(a160*a209);
  a111=(a111+a242);
  a242=(a161*a185);
  a111=(a111+a242);
  a163=(a148*a163);
  a173=(a167*a173);
  a163=(a163+a173);
  a259=(a117*a259);
  a163=(a163-a259);
  a259=(a318*a000);
  a173=(a166*a200);
  a259=(a259+a173);
  a173=(a180*a288);
  a259=(a259-a173);
  a163=(a163+a259);
  a259=(a162*a163);
  a111=(a111+a259);
  a111=(a238+a111);
  a259=(a205*a111);
  a172=(a172-a259);
  a074=(a074+a172);
  a172=(a190*a074);
  a042=(a042+a172);
  a042=(a330+a042);
  a172=(a176*a042);
  a287=(a287+a172);
  a172=(a207*a024);
  a259=(a214*a154);
  a172=(a172+a259);
  a259=(a215*a019);
  a172=(a172+a259);
  a259=(a216*a035);
  a172=(a172+a259);
  a259=(a217*a046);
  a172=(a172+a259);
  a259=(a218*a074);
  a172=(a172+a259);
  a259=(a179*a330);
  a173=(a186*a323);
  a259=(a259+a173);
  a173=(a187*a299);
  a259=(a259+a173);
  a173=(a188*a036);
  a259=(a259+a173);
  a173=(a189*a000);
  a259=(a259+a173);
  a173=(a190*a291);
  a259=(a259+a173);
  a259=(a229+a259);
  a173=(a240*a259);
  a242=(a179*a296);
  a342=(a186*a090);
  a242=(a242+a342);
  a342=(a187*a071);
  a242=(a242+a342);
  a342=(a188*a181);
  a242=(a242+a342);
  a342=(a189*a200);
  a242=(a242+a342);
  a342=(a190*a004);
  a242=(a242+a342);
  a242=(a175+a242);
  a342=(a235*a242);
  a173=(a173+a342);
  a342=(a179*a238);
  a337=(a186*a316);
  a342=(a342+a337);
  a337=(a187*a230);
  a342=(a342+a337);
  a337=(a188*a023);
  a342=(a342+a337);
  a337=(a189*a288);
  a342=(a342+a337);
  a337=(a190*a111);
  a342=(a342+a337);
  a342=(a158+a342);
  a337=(a326*a342);
  a173=(a173-a337);
  a337=(a329*a042);
  a015=(a179*a309);
  a272=(a186*a017);
  a015=(a015+a272);
  a272=(a187*a027);
  a015=(a015+a272);
  a272=(a188*a191);
  a015=(a015+a272);
  a272=(a189*a252);
  a015=(a015+a272);
  a272=(a169*a203);
  a033=(a198*a130);
  a272=(a272+a033);
  a033=(a196*a009);
  a272=(a272+a033);
  a033=(a324*a291);
  a221=(a199*a004);
  a033=(a033-a221);
  a221=(a210*a111);
  a033=(a033+a221);
  a272=(a272+a033);
  a033=(a190*a272);
  a015=(a015+a033);
  a015=(a296+a015);
  a033=(a231*a015);
  a337=(a337+a033);
  a033=(a179*a107);
  a221=(a186*a145);
  a033=(a033+a221);
  a221=(a187*a209);
  a033=(a033+a221);
  a221=(a188*a185);
  a033=(a033+a221);
  a221=(a189*a163);
  a033=(a033+a221);
  a203=(a078*a203);
  a130=(a195*a130);
  a203=(a203+a130);
  a009=(a118*a009);
  a203=(a203-a009);
  a009=(a325*a291);
  a130=(a194*a004);
  a009=(a009+a130);
  a130=(a208*a111);
  a009=(a009-a130);
  a203=(a203+a009);
  a009=(a190*a203);
  a033=(a033+a009);
  a033=(a238+a033);
  a009=(a234*a033);
  a337=(a337-a009);
  a173=(a173+a337);
  a337=(a219*a173);
  a172=(a172+a337);
  a172=(a330+a172);
  a337=(a204*a172);
  a287=(a287+a337);
  a337=(a236*a024);
  a009=(a243*a154);
  a337=(a337+a009);
  a009=(a244*a019);
  a337=(a337+a009);
  a009=(a245*a035);
  a337=(a337+a009);
  a009=(a246*a046);
  a337=(a337+a009);
  a009=(a247*a074);
  a337=(a337+a009);
  a009=(a248*a173);
  a337=(a337+a009);
  a009=(a207*a330);
  a130=(a214*a323);
  a009=(a009+a130);
  a130=(a215*a299);
  a009=(a009+a130);
  a130=(a216*a036);
  a009=(a009+a130);
  a130=(a217*a000);
  a009=(a009+a130);
  a130=(a218*a291);
  a009=(a009+a130);
  a130=(a219*a042);
  a009=(a009+a130);
  a009=(a229+a009);
  a130=(a270*a009);
  a221=(a207*a296);
  a049=(a214*a090);
  a221=(a221+a049);
  a049=(a215*a071);
  a221=(a221+a049);
  a049=(a216*a181);
  a221=(a221+a049);
  a049=(a217*a200);
  a221=(a221+a049);
  a049=(a218*a004);
  a221=(a221+a049);
  a049=(a219*a015);
  a221=(a221+a049);
  a221=(a175+a221);
  a049=(a265*a221);
  a130=(a130+a049);
  a049=(a207*a238);
  a262=(a214*a316);
  a049=(a049+a262);
  a262=(a215*a230);
  a049=(a049+a262);
  a262=(a216*a023);
  a049=(a049+a262);
  a262=(a217*a288);
  a049=(a049+a262);
  a262=(a218*a111);
  a049=(a049+a262);
  a262=(a219*a033);
  a049=(a049+a262);
  a049=(a158+a049);
  a262=(a333*a049);
  a130=(a130-a262);
  a262=(a336*a172);
  a038=(a207*a309);
  a052=(a214*a017);
  a038=(a038+a052);
  a052=(a215*a027);
  a038=(a038+a052);
  a052=(a216*a191);
  a038=(a038+a052);
  a052=(a217*a252);
  a038=(a038+a052);
  a052=(a218*a272);
  a038=(a038+a052);
  a052=(a197*a259);
  a164=(a227*a242);
  a052=(a052+a164);
  a164=(a225*a342);
  a052=(a052+a164);
  a164=(a331*a042);
  a136=(a228*a015);
  a164=(a164-a136);
  a136=(a239*a033);
  a164=(a164+a136);
  a052=(a052+a164);
  a164=(a219*a052);
  a038=(a038+a164);
  a038=(a296+a038);
  a164=(a261*a038);
  a262=(a262+a164);
  a164=(a207*a107);
  a136=(a214*a145);
  a164=(a164+a136);
  a136=(a215*a209);
  a164=(a164+a136);
  a136=(a216*a185);
  a164=(a164+a136);
  a136=(a217*a163);
  a164=(a164+a136);
  a136=(a218*a203);
  a164=(a164+a136);
  a259=(a307*a259);
  a242=(a224*a242);
  a259=(a259+a242);
  a342=(a313*a342);
  a259=(a259-a342);
  a342=(a332*a042);
  a242=(a223*a015);
  a342=(a342+a242);
  a242=(a237*a033);
  a342=(a342-a242);
  a259=(a259+a342);
  a342=(a219*a259);
  a164=(a164+a342);
  a164=(a238+a164);
  a342=(a264*a164);
  a262=(a262-a342);
  a130=(a130+a262);
  a262=(a249*a130);
  a337=(a337+a262);
  a337=(a330+a337);
  a262=(a233*a337);
  a287=(a287+a262);
  a262=(a266*a024);
  a154=(a273*a154);
  a262=(a262+a154);
  a019=(a101*a019);
  a262=(a262+a019);
  a019=(a124*a035);
  a262=(a262+a019);
  a019=(a274*a046);
  a262=(a262+a019);
  a019=(a275*a074);
  a262=(a262+a019);
  a019=(a276*a173);
  a262=(a262+a019);
  a019=(a277*a130);
  a262=(a262+a019);
  a019=(a236*a330);
  a154=(a243*a323);
  a019=(a019+a154);
  a154=(a244*a299);
  a019=(a019+a154);
  a154=(a245*a036);
  a019=(a019+a154);
  a154=(a246*a000);
  a019=(a019+a154);
  a154=(a247*a291);
  a019=(a019+a154);
  a154=(a248*a042);
  a019=(a019+a154);
  a154=(a249*a172);
  a019=(a019+a154);
  a019=(a229+a019);
  a154=(a298*a019);
  a342=(a236*a296);
  a242=(a243*a090);
  a342=(a342+a242);
  a242=(a244*a071);
  a342=(a342+a242);
  a242=(a245*a181);
  a342=(a342+a242);
  a242=(a246*a200);
  a342=(a342+a242);
  a242=(a247*a004);
  a342=(a342+a242);
  a242=(a248*a015);
  a342=(a342+a242);
  a242=(a249*a038);
  a342=(a342+a242);
  a342=(a175+a342);
  a242=(a293*a342);
  a154=(a154+a242);
  a242=(a236*a238);
  a136=(a243*a316);
  a242=(a242+a136);
  a136=(a244*a230);
  a242=(a242+a136);
  a136=(a245*a023);
  a242=(a242+a136);
  a136=(a246*a288);
  a242=(a242+a136);
  a136=(a247*a111);
  a242=(a242+a136);
  a136=(a248*a033);
  a242=(a242+a136);
  a136=(a249*a164);
  a242=(a242+a136);
  a242=(a158+a242);
  a136=(a335*a242);
  a154=(a154-a136);
  a136=(a341*a337);
  a220=(a236*a309);
  a213=(a243*a017);
  a220=(a220+a213);
  a213=(a244*a027);
  a220=(a220+a213);
  a213=(a245*a191);
  a220=(a220+a213);
  a213=(a246*a252);
  a220=(a220+a213);
  a213=(a247*a272);
  a220=(a220+a213);
  a213=(a248*a052);
  a220=(a220+a213);
  a213=(a226*a009);
  a008=(a257*a221);
  a213=(a213+a008);
  a008=(a255*a049);
  a213=(a213+a008);
  a008=(a338*a172);
  a146=(a258*a038);
  a008=(a008-a146);
  a146=(a269*a164);
  a008=(a008+a146);
  a213=(a213+a008);
  a008=(a249*a213);
  a220=(a220+a008);
  a220=(a296+a220);
  a008=(a289*a220);
  a136=(a136+a008);
  a008=(a236*a107);
  a146=(a243*a145);
  a008=(a008+a146);
  a146=(a244*a209);
  a008=(a008+a146);
  a146=(a245*a185);
  a008=(a008+a146);
  a146=(a246*a163);
  a008=(a008+a146);
  a146=(a247*a203);
  a008=(a008+a146);
  a146=(a248*a259);
  a008=(a008+a146);
  a009=(a314*a009);
  a221=(a254*a221);
  a009=(a009+a221);
  a049=(a320*a049);
  a009=(a009-a049);
  a049=(a339*a172);
  a221=(a253*a038);
  a049=(a049+a221);
  a221=(a267*a164);
  a049=(a049-a221);
  a009=(a009+a049);
  a049=(a249*a009);
  a008=(a008+a049);
  a008=(a238+a008);
  a049=(a292*a008);
  a136=(a136-a049);
  a154=(a154+a136);
  a136=(a278*a154);
  a262=(a262+a136);
  a262=(a330+a262);
  a136=(a263*a262);
  a287=(a287+a136);
  a287=(a229+a287);
  if (res[0]!=0) res[0][24]=a287;
  a287=(a001*a296);
  a136=(a005*a181);
  a287=(a287+a136);
  a136=(a125*a200);
  a287=(a287+a136);
  a136=(a149*a004);
  a287=(a287+a136);
  a136=(a176*a015);
  a287=(a287+a136);
  a136=(a204*a038);
  a287=(a287+a136);
  a136=(a233*a220);
  a287=(a287+a136);
  a136=(a266*a309);
  a017=(a273*a017);
  a136=(a136+a017);
  a027=(a101*a027);
  a136=(a136+a027);
  a027=(a124*a191);
  a136=(a136+a027);
  a027=(a274*a252);
  a136=(a136+a027);
  a027=(a275*a272);
  a136=(a136+a027);
  a027=(a276*a052);
  a136=(a136+a027);
  a027=(a277*a213);
  a136=(a136+a027);
  a027=(a321*a019);
  a017=(a285*a342);
  a027=(a027+a017);
  a017=(a283*a242);
  a027=(a027+a017);
  a017=(a343*a337);
  a049=(a286*a220);
  a017=(a017-a049);
  a049=(a297*a008);
  a017=(a017+a049);
  a027=(a027+a017);
  a017=(a278*a027);
  a136=(a136+a017);
  a136=(a296+a136);
  a017=(a263*a136);
  a287=(a287+a017);
  a287=(a175+a287);
  if (res[0]!=0) res[0][25]=a287;
  a287=(a001*a238);
  a017=(a005*a023);
  a287=(a287+a017);
  a017=(a125*a288);
  a287=(a287+a017);
  a017=(a149*a111);
  a287=(a287+a017);
  a017=(a176*a033);
  a287=(a287+a017);
  a017=(a204*a164);
  a287=(a287+a017);
  a017=(a233*a008);
  a287=(a287+a017);
  a017=(a266*a107);
  a145=(a273*a145);
  a017=(a017+a145);
  a209=(a101*a209);
  a017=(a017+a209);
  a209=(a124*a185);
  a017=(a017+a209);
  a209=(a274*a163);
  a017=(a017+a209);
  a209=(a275*a203);
  a017=(a017+a209);
  a209=(a276*a259);
  a017=(a017+a209);
  a209=(a277*a009);
  a017=(a017+a209);
  a019=(a063*a019);
  a342=(a282*a342);
  a019=(a019+a342);
  a242=(a099*a242);
  a019=(a019-a242);
  a242=(a344*a337);
  a342=(a281*a220);
  a242=(a242+a342);
  a342=(a295*a008);
  a242=(a242-a342);
  a019=(a019+a242);
  a242=(a278*a019);
  a017=(a017+a242);
  a017=(a238+a017);
  a242=(a263*a017);
  a287=(a287+a242);
  a287=(a158+a287);
  if (res[0]!=0) res[0][26]=a287;
  a024=(a001*a024);
  a035=(a005*a035);
  a024=(a024+a035);
  a046=(a125*a046);
  a024=(a024+a046);
  a074=(a149*a074);
  a024=(a024+a074);
  a173=(a176*a173);
  a024=(a024+a173);
  a130=(a204*a130);
  a024=(a024+a130);
  a154=(a233*a154);
  a024=(a024+a154);
  a154=(a266*a330);
  a323=(a273*a323);
  a154=(a154+a323);
  a299=(a101*a299);
  a154=(a154+a299);
  a036=(a124*a036);
  a154=(a154+a036);
  a000=(a274*a000);
  a154=(a154+a000);
  a291=(a275*a291);
  a154=(a154+a291);
  a042=(a276*a042);
  a154=(a154+a042);
  a172=(a277*a172);
  a154=(a154+a172);
  a337=(a278*a337);
  a154=(a154+a337);
  a229=(a229+a154);
  a154=(a029*a229);
  a337=(a266*a296);
  a090=(a273*a090);
  a337=(a337+a090);
  a071=(a101*a071);
  a337=(a337+a071);
  a181=(a124*a181);
  a337=(a337+a181);
  a200=(a274*a200);
  a337=(a337+a200);
  a004=(a275*a004);
  a337=(a337+a004);
  a015=(a276*a015);
  a337=(a337+a015);
  a038=(a277*a038);
  a337=(a337+a038);
  a220=(a278*a220);
  a337=(a337+a220);
  a175=(a175+a337);
  a337=(a300*a175);
  a154=(a154+a337);
  a337=(a266*a238);
  a316=(a273*a316);
  a337=(a337+a316);
  a230=(a101*a230);
  a337=(a337+a230);
  a023=(a124*a023);
  a337=(a337+a023);
  a288=(a274*a288);
  a337=(a337+a288);
  a111=(a275*a111);
  a337=(a337+a111);
  a033=(a276*a033);
  a337=(a337+a033);
  a164=(a277*a164);
  a337=(a337+a164);
  a008=(a278*a008);
  a337=(a337+a008);
  a158=(a158+a337);
  a337=(a002*a158);
  a154=(a154-a337);
  a337=(a250*a262);
  a008=(a113*a136);
  a337=(a337+a008);
  a008=(a294*a017);
  a337=(a337-a008);
  a154=(a154+a337);
  a154=(a263*a154);
  a024=(a024+a154);
  a330=(a330+a024);
  if (res[0]!=0) res[0][27]=a330;
  a309=(a001*a309);
  a191=(a005*a191);
  a309=(a309+a191);
  a252=(a125*a252);
  a309=(a309+a252);
  a272=(a149*a272);
  a309=(a309+a272);
  a052=(a176*a052);
  a309=(a309+a052);
  a213=(a204*a213);
  a309=(a309+a213);
  a027=(a233*a027);
  a309=(a309+a027);
  a027=(a201*a229);
  a213=(a031*a175);
  a027=(a027+a213);
  a213=(a007*a158);
  a027=(a027+a213);
  a213=(a268*a262);
  a052=(a032*a136);
  a213=(a213-a052);
  a052=(a018*a017);
  a213=(a213+a052);
  a027=(a027+a213);
  a027=(a263*a027);
  a309=(a309+a027);
  a296=(a296+a309);
  if (res[0]!=0) res[0][28]=a296;
  a107=(a001*a107);
  a185=(a005*a185);
  a107=(a107+a185);
  a163=(a125*a163);
  a107=(a107+a163);
  a203=(a149*a203);
  a107=(a107+a203);
  a259=(a176*a259);
  a107=(a107+a259);
  a009=(a204*a009);
  a107=(a107+a009);
  a019=(a233*a019);
  a107=(a107+a019);
  a229=(a260*a229);
  a175=(a232*a175);
  a229=(a229+a175);
  a158=(a043*a158);
  a229=(a229-a158);
  a262=(a137*a262);
  a136=(a021*a136);
  a262=(a262+a136);
  a017=(a041*a017);
  a262=(a262-a017);
  a229=(a229+a262);
  a229=(a263*a229);
  a107=(a107+a229);
  a238=(a238+a107);
  if (res[0]!=0) res[0][29]=a238;
  a238=arg[0]? arg[0][30] : 0;
  a107=arg[0]? arg[0][33] : 0;
  a229=(a001*a107);
  a040=(a040*a238);
  a262=arg[0]? arg[0][31] : 0;
  a026=(a026*a262);
  a040=(a040+a026);
  a026=arg[0]? arg[0][32] : 0;
  a016=(a016*a026);
  a040=(a040-a016);
  a280=(a280*a107);
  a016=arg[0]? arg[0][34] : 0;
  a022=(a022*a016);
  a280=(a280+a022);
  a022=arg[0]? arg[0][35] : 0;
  a025=(a025*a022);
  a280=(a280-a025);
  a040=(a040+a280);
  a280=(a006*a040);
  a025=(a045*a107);
  a017=(a048*a040);
  a136=(a051*a107);
  a136=(a238+a136);
  a073=(a073*a136);
  a158=(a051*a016);
  a158=(a262+a158);
  a068=(a068*a158);
  a073=(a073+a068);
  a068=(a051*a022);
  a068=(a026+a068);
  a084=(a084*a068);
  a073=(a073-a084);
  a084=(a051*a040);
  a084=(a107+a084);
  a114=(a114*a084);
  a192=(a192*a238);
  a014=(a014*a262);
  a192=(a192+a014);
  a020=(a020*a026);
  a192=(a192+a020);
  a222=(a222*a107);
  a034=(a034*a016);
  a222=(a222-a034);
  a039=(a039*a022);
  a222=(a222+a039);
  a192=(a192+a222);
  a222=(a051*a192);
  a222=(a016+a222);
  a064=(a064*a222);
  a114=(a114+a064);
  a251=(a251*a238);
  a012=(a012*a262);
  a251=(a251+a012);
  a279=(a279*a026);
  a251=(a251-a279);
  a193=(a193*a107);
  a011=(a011*a016);
  a193=(a193+a011);
  a037=(a037*a022);
  a193=(a193-a037);
  a251=(a251+a193);
  a051=(a051*a251);
  a051=(a022+a051);
  a067=(a067*a051);
  a114=(a114-a067);
  a073=(a073+a114);
  a073=(a050*a073);
  a017=(a017+a073);
  a017=(a107+a017);
  a073=(a047*a017);
  a025=(a025+a073);
  a025=(a238+a025);
  a109=(a109*a025);
  a073=(a045*a016);
  a114=(a048*a192);
  a080=(a080*a136);
  a060=(a060*a158);
  a080=(a080+a060);
  a058=(a058*a068);
  a080=(a080+a058);
  a271=(a271*a084);
  a061=(a061*a222);
  a271=(a271-a061);
  a072=(a072*a051);
  a271=(a271+a072);
  a080=(a080+a271);
  a080=(a050*a080);
  a114=(a114+a080);
  a114=(a016+a114);
  a080=(a047*a114);
  a073=(a073+a080);
  a073=(a262+a073);
  a104=(a104*a073);
  a109=(a109+a104);
  a104=(a045*a022);
  a080=(a048*a251);
  a138=(a138*a136);
  a057=(a057*a158);
  a138=(a138+a057);
  a094=(a094*a068);
  a138=(a138-a094);
  a241=(a241*a084);
  a055=(a055*a222);
  a241=(a241+a055);
  a070=(a070*a051);
  a241=(a241-a070);
  a138=(a138+a241);
  a138=(a050*a138);
  a080=(a080+a138);
  a080=(a022+a080);
  a138=(a047*a080);
  a104=(a104+a138);
  a104=(a026+a104);
  a184=(a184*a104);
  a109=(a109-a184);
  a184=(a045*a040);
  a138=(a048*a107);
  a084=(a050*a084);
  a138=(a138+a084);
  a138=(a238+a138);
  a091=(a091*a138);
  a084=(a048*a016);
  a222=(a050*a222);
  a084=(a084+a222);
  a084=(a262+a084);
  a065=(a065*a084);
  a091=(a091+a065);
  a048=(a048*a022);
  a050=(a050*a051);
  a048=(a048+a050);
  a048=(a026+a048);
  a083=(a083*a048);
  a091=(a091-a083);
  a303=(a303*a017);
  a054=(a054*a114);
  a303=(a303+a054);
  a066=(a066*a080);
  a303=(a303-a066);
  a091=(a091+a303);
  a303=(a047*a091);
  a184=(a184+a303);
  a184=(a107+a184);
  a028=(a028*a184);
  a303=(a045*a192);
  a301=(a301*a138);
  a077=(a077*a084);
  a301=(a301+a077);
  a062=(a062*a048);
  a301=(a301+a062);
  a305=(a305*a017);
  a085=(a085*a114);
  a305=(a305-a085);
  a089=(a089*a080);
  a305=(a305+a089);
  a301=(a301+a305);
  a305=(a047*a301);
  a303=(a303+a305);
  a303=(a016+a303);
  a100=(a100*a303);
  a028=(a028+a100);
  a045=(a045*a251);
  a095=(a095*a138);
  a082=(a082*a084);
  a095=(a095+a082);
  a056=(a056*a048);
  a095=(a095-a056);
  a306=(a306*a017);
  a069=(a069*a114);
  a306=(a306+a069);
  a087=(a087*a080);
  a306=(a306-a087);
  a095=(a095+a306);
  a047=(a047*a095);
  a045=(a045+a047);
  a045=(a022+a045);
  a103=(a103*a045);
  a028=(a028-a103);
  a109=(a109+a028);
  a028=(a030*a109);
  a280=(a280+a028);
  a028=(a105*a107);
  a017=(a112*a017);
  a028=(a028+a017);
  a017=(a086*a184);
  a028=(a028+a017);
  a028=(a238+a028);
  a132=(a132*a028);
  a017=(a105*a016);
  a114=(a112*a114);
  a017=(a017+a114);
  a114=(a086*a303);
  a017=(a017+a114);
  a017=(a262+a017);
  a127=(a127*a017);
  a132=(a132+a127);
  a127=(a105*a022);
  a080=(a112*a080);
  a127=(a127+a080);
  a080=(a086*a045);
  a127=(a127+a080);
  a127=(a026+a127);
  a122=(a122*a127);
  a132=(a132-a122);
  a122=(a105*a040);
  a091=(a112*a091);
  a122=(a122+a091);
  a091=(a086*a109);
  a122=(a122+a091);
  a122=(a107+a122);
  a079=(a079*a122);
  a091=(a105*a192);
  a301=(a112*a301);
  a091=(a091+a301);
  a165=(a165*a025);
  a096=(a096*a073);
  a165=(a165+a096);
  a212=(a212*a104);
  a165=(a165+a212);
  a110=(a110*a184);
  a097=(a097*a303);
  a110=(a110-a097);
  a108=(a108*a045);
  a110=(a110+a108);
  a165=(a165+a110);
  a110=(a086*a165);
  a091=(a091+a110);
  a091=(a016+a091);
  a123=(a123*a091);
  a079=(a079+a123);
  a105=(a105*a251);
  a112=(a112*a095);
  a105=(a105+a112);
  a010=(a010*a025);
  a093=(a093*a073);
  a010=(a010+a093);
  a044=(a044*a104);
  a010=(a010-a044);
  a302=(a302*a184);
  a053=(a053*a303);
  a302=(a302+a053);
  a106=(a106*a045);
  a302=(a302-a106);
  a010=(a010+a302);
  a086=(a086*a010);
  a105=(a105+a086);
  a105=(a022+a105);
  a126=(a126*a105);
  a079=(a079-a126);
  a132=(a132+a079);
  a079=(a102*a132);
  a280=(a280+a079);
  a280=(a107+a280);
  a079=(a005*a280);
  a229=(a229+a079);
  a079=(a128*a040);
  a126=(a092*a109);
  a079=(a079+a126);
  a126=(a134*a132);
  a079=(a079+a126);
  a126=(a006*a107);
  a086=(a030*a184);
  a126=(a126+a086);
  a086=(a102*a122);
  a126=(a126+a086);
  a126=(a238+a126);
  a156=(a156*a126);
  a086=(a006*a016);
  a302=(a030*a303);
  a086=(a086+a302);
  a302=(a102*a091);
  a086=(a086+a302);
  a086=(a262+a086);
  a151=(a151*a086);
  a156=(a156+a151);
  a151=(a006*a022);
  a302=(a030*a045);
  a151=(a151+a302);
  a302=(a102*a105);
  a151=(a151+a302);
  a151=(a026+a151);
  a133=(a133*a151);
  a156=(a156-a133);
  a308=(a308*a280);
  a133=(a006*a192);
  a302=(a030*a165);
  a133=(a133+a302);
  a088=(a088*a028);
  a119=(a119*a017);
  a088=(a088+a119);
  a304=(a304*a127);
  a088=(a088+a304);
  a059=(a059*a122);
  a120=(a120*a091);
  a059=(a059-a120);
  a131=(a131*a105);
  a059=(a059+a131);
  a088=(a088+a059);
  a059=(a102*a088);
  a133=(a133+a059);
  a133=(a016+a133);
  a147=(a147*a133);
  a308=(a308+a147);
  a006=(a006*a251);
  a030=(a030*a010);
  a006=(a006+a030);
  a075=(a075*a028);
  a081=(a081*a017);
  a075=(a075+a081);
  a003=(a003*a127);
  a075=(a075-a003);
  a076=(a076*a122);
  a115=(a115*a091);
  a076=(a076+a115);
  a129=(a129*a105);
  a076=(a076-a129);
  a075=(a075+a076);
  a102=(a102*a075);
  a006=(a006+a102);
  a006=(a022+a006);
  a150=(a150*a006);
  a308=(a308-a150);
  a156=(a156+a308);
  a308=(a135*a156);
  a079=(a079+a308);
  a079=(a107+a079);
  a308=(a125*a079);
  a229=(a229+a308);
  a308=(a152*a040);
  a150=(a159*a109);
  a308=(a308+a150);
  a150=(a160*a132);
  a308=(a308+a150);
  a150=(a161*a156);
  a308=(a308+a150);
  a150=(a128*a107);
  a102=(a092*a184);
  a150=(a150+a102);
  a102=(a134*a122);
  a150=(a150+a102);
  a102=(a135*a280);
  a150=(a150+a102);
  a150=(a238+a150);
  a183=(a183*a150);
  a102=(a128*a016);
  a076=(a092*a303);
  a102=(a102+a076);
  a076=(a134*a091);
  a102=(a102+a076);
  a076=(a135*a133);
  a102=(a102+a076);
  a102=(a262+a102);
  a178=(a178*a102);
  a183=(a183+a178);
  a178=(a128*a022);
  a076=(a092*a045);
  a178=(a178+a076);
  a076=(a134*a105);
  a178=(a178+a076);
  a076=(a135*a006);
  a178=(a178+a076);
  a178=(a026+a178);
  a312=(a312*a178);
  a183=(a183-a312);
  a315=(a315*a079);
  a312=(a128*a192);
  a076=(a092*a165);
  a312=(a312+a076);
  a076=(a134*a088);
  a312=(a312+a076);
  a116=(a116*a126);
  a143=(a143*a086);
  a116=(a116+a143);
  a141=(a141*a151);
  a116=(a116+a141);
  a310=(a310*a280);
  a144=(a144*a133);
  a310=(a310-a144);
  a155=(a155*a006);
  a310=(a310+a155);
  a116=(a116+a310);
  a310=(a135*a116);
  a312=(a312+a310);
  a312=(a016+a312);
  a174=(a174*a312);
  a315=(a315+a174);
  a128=(a128*a251);
  a092=(a092*a010);
  a128=(a128+a092);
  a134=(a134*a075);
  a128=(a128+a134);
  a013=(a013*a126);
  a140=(a140*a086);
  a013=(a013+a140);
  a157=(a157*a151);
  a013=(a013-a157);
  a311=(a311*a280);
  a139=(a139*a133);
  a311=(a311+a139);
  a153=(a153*a006);
  a311=(a311-a153);
  a013=(a013+a311);
  a135=(a135*a013);
  a128=(a128+a135);
  a128=(a022+a128);
  a177=(a177*a128);
  a315=(a315-a177);
  a183=(a183+a315);
  a315=(a162*a183);
  a308=(a308+a315);
  a308=(a107+a308);
  a315=(a149*a308);
  a229=(a229+a315);
  a315=(a179*a040);
  a177=(a186*a109);
  a315=(a315+a177);
  a177=(a187*a132);
  a315=(a315+a177);
  a177=(a188*a156);
  a315=(a315+a177);
  a177=(a189*a183);
  a315=(a315+a177);
  a177=(a152*a107);
  a135=(a159*a184);
  a177=(a177+a135);
  a135=(a160*a122);
  a177=(a177+a135);
  a135=(a161*a280);
  a177=(a177+a135);
  a135=(a162*a079);
  a177=(a177+a135);
  a177=(a238+a177);
  a211=(a211*a177);
  a135=(a152*a016);
  a311=(a159*a303);
  a135=(a135+a311);
  a311=(a160*a091);
  a135=(a135+a311);
  a311=(a161*a133);
  a135=(a135+a311);
  a311=(a162*a312);
  a135=(a135+a311);
  a135=(a262+a135);
  a206=(a206*a135);
  a211=(a211+a206);
  a206=(a152*a022);
  a311=(a159*a045);
  a206=(a206+a311);
  a311=(a160*a105);
  a206=(a206+a311);
  a311=(a161*a006);
  a206=(a206+a311);
  a311=(a162*a128);
  a206=(a206+a311);
  a206=(a026+a206);
  a319=(a319*a206);
  a211=(a211-a319);
  a322=(a322*a308);
  a319=(a152*a192);
  a311=(a159*a165);
  a319=(a319+a311);
  a311=(a160*a088);
  a319=(a319+a311);
  a311=(a161*a116);
  a319=(a319+a311);
  a142=(a142*a150);
  a170=(a170*a102);
  a142=(a142+a170);
  a168=(a168*a178);
  a142=(a142+a168);
  a317=(a317*a079);
  a171=(a171*a312);
  a317=(a317-a171);
  a182=(a182*a128);
  a317=(a317+a182);
  a142=(a142+a317);
  a317=(a162*a142);
  a319=(a319+a317);
  a319=(a016+a319);
  a202=(a202*a319);
  a322=(a322+a202);
  a152=(a152*a251);
  a159=(a159*a010);
  a152=(a152+a159);
  a160=(a160*a075);
  a152=(a152+a160);
  a161=(a161*a013);
  a152=(a152+a161);
  a148=(a148*a150);
  a167=(a167*a102);
  a148=(a148+a167);
  a117=(a117*a178);
  a148=(a148-a117);
  a318=(a318*a079);
  a166=(a166*a312);
  a318=(a318+a166);
  a180=(a180*a128);
  a318=(a318-a180);
  a148=(a148+a318);
  a162=(a162*a148);
  a152=(a152+a162);
  a152=(a022+a152);
  a205=(a205*a152);
  a322=(a322-a205);
  a211=(a211+a322);
  a322=(a190*a211);
  a315=(a315+a322);
  a315=(a107+a315);
  a322=(a176*a315);
  a229=(a229+a322);
  a322=(a207*a040);
  a205=(a214*a109);
  a322=(a322+a205);
  a205=(a215*a132);
  a322=(a322+a205);
  a205=(a216*a156);
  a322=(a322+a205);
  a205=(a217*a183);
  a322=(a322+a205);
  a205=(a218*a211);
  a322=(a322+a205);
  a205=(a179*a107);
  a162=(a186*a184);
  a205=(a205+a162);
  a162=(a187*a122);
  a205=(a205+a162);
  a162=(a188*a280);
  a205=(a205+a162);
  a162=(a189*a079);
  a205=(a205+a162);
  a162=(a190*a308);
  a205=(a205+a162);
  a205=(a238+a205);
  a240=(a240*a205);
  a162=(a179*a016);
  a318=(a186*a303);
  a162=(a162+a318);
  a318=(a187*a091);
  a162=(a162+a318);
  a318=(a188*a133);
  a162=(a162+a318);
  a318=(a189*a312);
  a162=(a162+a318);
  a318=(a190*a319);
  a162=(a162+a318);
  a162=(a262+a162);
  a235=(a235*a162);
  a240=(a240+a235);
  a235=(a179*a022);
  a318=(a186*a045);
  a235=(a235+a318);
  a318=(a187*a105);
  a235=(a235+a318);
  a318=(a188*a006);
  a235=(a235+a318);
  a318=(a189*a128);
  a235=(a235+a318);
  a318=(a190*a152);
  a235=(a235+a318);
  a235=(a026+a235);
  a326=(a326*a235);
  a240=(a240-a326);
  a329=(a329*a315);
  a326=(a179*a192);
  a318=(a186*a165);
  a326=(a326+a318);
  a318=(a187*a088);
  a326=(a326+a318);
  a318=(a188*a116);
  a326=(a326+a318);
  a318=(a189*a142);
  a326=(a326+a318);
  a169=(a169*a177);
  a198=(a198*a135);
  a169=(a169+a198);
  a196=(a196*a206);
  a169=(a169+a196);
  a324=(a324*a308);
  a199=(a199*a319);
  a324=(a324-a199);
  a210=(a210*a152);
  a324=(a324+a210);
  a169=(a169+a324);
  a324=(a190*a169);
  a326=(a326+a324);
  a326=(a016+a326);
  a231=(a231*a326);
  a329=(a329+a231);
  a179=(a179*a251);
  a186=(a186*a010);
  a179=(a179+a186);
  a187=(a187*a075);
  a179=(a179+a187);
  a188=(a188*a013);
  a179=(a179+a188);
  a189=(a189*a148);
  a179=(a179+a189);
  a078=(a078*a177);
  a195=(a195*a135);
  a078=(a078+a195);
  a118=(a118*a206);
  a078=(a078-a118);
  a325=(a325*a308);
  a194=(a194*a319);
  a325=(a325+a194);
  a208=(a208*a152);
  a325=(a325-a208);
  a078=(a078+a325);
  a190=(a190*a078);
  a179=(a179+a190);
  a179=(a022+a179);
  a234=(a234*a179);
  a329=(a329-a234);
  a240=(a240+a329);
  a329=(a219*a240);
  a322=(a322+a329);
  a322=(a107+a322);
  a329=(a204*a322);
  a229=(a229+a329);
  a329=(a236*a040);
  a234=(a243*a109);
  a329=(a329+a234);
  a234=(a244*a132);
  a329=(a329+a234);
  a234=(a245*a156);
  a329=(a329+a234);
  a234=(a246*a183);
  a329=(a329+a234);
  a234=(a247*a211);
  a329=(a329+a234);
  a234=(a248*a240);
  a329=(a329+a234);
  a234=(a207*a107);
  a190=(a214*a184);
  a234=(a234+a190);
  a190=(a215*a122);
  a234=(a234+a190);
  a190=(a216*a280);
  a234=(a234+a190);
  a190=(a217*a079);
  a234=(a234+a190);
  a190=(a218*a308);
  a234=(a234+a190);
  a190=(a219*a315);
  a234=(a234+a190);
  a234=(a238+a234);
  a270=(a270*a234);
  a190=(a207*a016);
  a325=(a214*a303);
  a190=(a190+a325);
  a325=(a215*a091);
  a190=(a190+a325);
  a325=(a216*a133);
  a190=(a190+a325);
  a325=(a217*a312);
  a190=(a190+a325);
  a325=(a218*a319);
  a190=(a190+a325);
  a325=(a219*a326);
  a190=(a190+a325);
  a190=(a262+a190);
  a265=(a265*a190);
  a270=(a270+a265);
  a265=(a207*a022);
  a325=(a214*a045);
  a265=(a265+a325);
  a325=(a215*a105);
  a265=(a265+a325);
  a325=(a216*a006);
  a265=(a265+a325);
  a325=(a217*a128);
  a265=(a265+a325);
  a325=(a218*a152);
  a265=(a265+a325);
  a325=(a219*a179);
  a265=(a265+a325);
  a265=(a026+a265);
  a333=(a333*a265);
  a270=(a270-a333);
  a336=(a336*a322);
  a333=(a207*a192);
  a325=(a214*a165);
  a333=(a333+a325);
  a325=(a215*a088);
  a333=(a333+a325);
  a325=(a216*a116);
  a333=(a333+a325);
  a325=(a217*a142);
  a333=(a333+a325);
  a325=(a218*a169);
  a333=(a333+a325);
  a197=(a197*a205);
  a227=(a227*a162);
  a197=(a197+a227);
  a225=(a225*a235);
  a197=(a197+a225);
  a331=(a331*a315);
  a228=(a228*a326);
  a331=(a331-a228);
  a239=(a239*a179);
  a331=(a331+a239);
  a197=(a197+a331);
  a331=(a219*a197);
  a333=(a333+a331);
  a333=(a016+a333);
  a261=(a261*a333);
  a336=(a336+a261);
  a207=(a207*a251);
  a214=(a214*a010);
  a207=(a207+a214);
  a215=(a215*a075);
  a207=(a207+a215);
  a216=(a216*a013);
  a207=(a207+a216);
  a217=(a217*a148);
  a207=(a207+a217);
  a218=(a218*a078);
  a207=(a207+a218);
  a307=(a307*a205);
  a224=(a224*a162);
  a307=(a307+a224);
  a313=(a313*a235);
  a307=(a307-a313);
  a332=(a332*a315);
  a223=(a223*a326);
  a332=(a332+a223);
  a237=(a237*a179);
  a332=(a332-a237);
  a307=(a307+a332);
  a219=(a219*a307);
  a207=(a207+a219);
  a207=(a022+a207);
  a264=(a264*a207);
  a336=(a336-a264);
  a270=(a270+a336);
  a336=(a249*a270);
  a329=(a329+a336);
  a329=(a107+a329);
  a336=(a233*a329);
  a229=(a229+a336);
  a336=(a266*a040);
  a109=(a273*a109);
  a336=(a336+a109);
  a132=(a101*a132);
  a336=(a336+a132);
  a132=(a124*a156);
  a336=(a336+a132);
  a132=(a274*a183);
  a336=(a336+a132);
  a132=(a275*a211);
  a336=(a336+a132);
  a132=(a276*a240);
  a336=(a336+a132);
  a132=(a277*a270);
  a336=(a336+a132);
  a132=(a236*a107);
  a109=(a243*a184);
  a132=(a132+a109);
  a109=(a244*a122);
  a132=(a132+a109);
  a109=(a245*a280);
  a132=(a132+a109);
  a109=(a246*a079);
  a132=(a132+a109);
  a109=(a247*a308);
  a132=(a132+a109);
  a109=(a248*a315);
  a132=(a132+a109);
  a109=(a249*a322);
  a132=(a132+a109);
  a132=(a238+a132);
  a298=(a298*a132);
  a109=(a236*a016);
  a264=(a243*a303);
  a109=(a109+a264);
  a264=(a244*a091);
  a109=(a109+a264);
  a264=(a245*a133);
  a109=(a109+a264);
  a264=(a246*a312);
  a109=(a109+a264);
  a264=(a247*a319);
  a109=(a109+a264);
  a264=(a248*a326);
  a109=(a109+a264);
  a264=(a249*a333);
  a109=(a109+a264);
  a109=(a262+a109);
  a293=(a293*a109);
  a298=(a298+a293);
  a293=(a236*a022);
  a264=(a243*a045);
  a293=(a293+a264);
  a264=(a244*a105);
  a293=(a293+a264);
  a264=(a245*a006);
  a293=(a293+a264);
  a264=(a246*a128);
  a293=(a293+a264);
  a264=(a247*a152);
  a293=(a293+a264);
  a264=(a248*a179);
  a293=(a293+a264);
  a264=(a249*a207);
  a293=(a293+a264);
  a293=(a026+a293);
  a335=(a335*a293);
  a298=(a298-a335);
  a341=(a341*a329);
  a335=(a236*a192);
  a264=(a243*a165);
  a335=(a335+a264);
  a264=(a244*a088);
  a335=(a335+a264);
  a264=(a245*a116);
  a335=(a335+a264);
  a264=(a246*a142);
  a335=(a335+a264);
  a264=(a247*a169);
  a335=(a335+a264);
  a264=(a248*a197);
  a335=(a335+a264);
  a226=(a226*a234);
  a257=(a257*a190);
  a226=(a226+a257);
  a255=(a255*a265);
  a226=(a226+a255);
  a338=(a338*a322);
  a258=(a258*a333);
  a338=(a338-a258);
  a269=(a269*a207);
  a338=(a338+a269);
  a226=(a226+a338);
  a338=(a249*a226);
  a335=(a335+a338);
  a335=(a016+a335);
  a289=(a289*a335);
  a341=(a341+a289);
  a236=(a236*a251);
  a243=(a243*a010);
  a236=(a236+a243);
  a244=(a244*a075);
  a236=(a236+a244);
  a245=(a245*a013);
  a236=(a236+a245);
  a246=(a246*a148);
  a236=(a236+a246);
  a247=(a247*a078);
  a236=(a236+a247);
  a248=(a248*a307);
  a236=(a236+a248);
  a314=(a314*a234);
  a254=(a254*a190);
  a314=(a314+a254);
  a320=(a320*a265);
  a314=(a314-a320);
  a339=(a339*a322);
  a253=(a253*a333);
  a339=(a339+a253);
  a267=(a267*a207);
  a339=(a339-a267);
  a314=(a314+a339);
  a249=(a249*a314);
  a236=(a236+a249);
  a236=(a022+a236);
  a292=(a292*a236);
  a341=(a341-a292);
  a298=(a298+a341);
  a341=(a278*a298);
  a336=(a336+a341);
  a336=(a107+a336);
  a341=(a263*a336);
  a229=(a229+a341);
  a229=(a238+a229);
  if (res[0]!=0) res[0][30]=a229;
  a229=(a001*a016);
  a341=(a005*a133);
  a229=(a229+a341);
  a341=(a125*a312);
  a229=(a229+a341);
  a341=(a149*a319);
  a229=(a229+a341);
  a341=(a176*a326);
  a229=(a229+a341);
  a341=(a204*a333);
  a229=(a229+a341);
  a341=(a233*a335);
  a229=(a229+a341);
  a341=(a266*a192);
  a165=(a273*a165);
  a341=(a341+a165);
  a088=(a101*a088);
  a341=(a341+a088);
  a088=(a124*a116);
  a341=(a341+a088);
  a088=(a274*a142);
  a341=(a341+a088);
  a088=(a275*a169);
  a341=(a341+a088);
  a088=(a276*a197);
  a341=(a341+a088);
  a088=(a277*a226);
  a341=(a341+a088);
  a321=(a321*a132);
  a285=(a285*a109);
  a321=(a321+a285);
  a283=(a283*a293);
  a321=(a321+a283);
  a343=(a343*a329);
  a286=(a286*a335);
  a343=(a343-a286);
  a297=(a297*a236);
  a343=(a343+a297);
  a321=(a321+a343);
  a343=(a278*a321);
  a341=(a341+a343);
  a341=(a016+a341);
  a343=(a263*a341);
  a229=(a229+a343);
  a229=(a262+a229);
  if (res[0]!=0) res[0][31]=a229;
  a229=(a001*a022);
  a343=(a005*a006);
  a229=(a229+a343);
  a343=(a125*a128);
  a229=(a229+a343);
  a343=(a149*a152);
  a229=(a229+a343);
  a343=(a176*a179);
  a229=(a229+a343);
  a343=(a204*a207);
  a229=(a229+a343);
  a343=(a233*a236);
  a229=(a229+a343);
  a343=(a266*a251);
  a010=(a273*a010);
  a343=(a343+a010);
  a075=(a101*a075);
  a343=(a343+a075);
  a075=(a124*a013);
  a343=(a343+a075);
  a075=(a274*a148);
  a343=(a343+a075);
  a075=(a275*a078);
  a343=(a343+a075);
  a075=(a276*a307);
  a343=(a343+a075);
  a075=(a277*a314);
  a343=(a343+a075);
  a063=(a063*a132);
  a282=(a282*a109);
  a063=(a063+a282);
  a099=(a099*a293);
  a063=(a063-a099);
  a344=(a344*a329);
  a281=(a281*a335);
  a344=(a344+a281);
  a295=(a295*a236);
  a344=(a344-a295);
  a063=(a063+a344);
  a344=(a278*a063);
  a343=(a343+a344);
  a343=(a022+a343);
  a344=(a263*a343);
  a229=(a229+a344);
  a229=(a026+a229);
  if (res[0]!=0) res[0][32]=a229;
  a040=(a001*a040);
  a156=(a005*a156);
  a040=(a040+a156);
  a183=(a125*a183);
  a040=(a040+a183);
  a211=(a149*a211);
  a040=(a040+a211);
  a240=(a176*a240);
  a040=(a040+a240);
  a270=(a204*a270);
  a040=(a040+a270);
  a298=(a233*a298);
  a040=(a040+a298);
  a298=(a266*a107);
  a184=(a273*a184);
  a298=(a298+a184);
  a122=(a101*a122);
  a298=(a298+a122);
  a280=(a124*a280);
  a298=(a298+a280);
  a079=(a274*a079);
  a298=(a298+a079);
  a308=(a275*a308);
  a298=(a298+a308);
  a315=(a276*a315);
  a298=(a298+a315);
  a322=(a277*a322);
  a298=(a298+a322);
  a329=(a278*a329);
  a298=(a298+a329);
  a238=(a238+a298);
  a029=(a029*a238);
  a298=(a266*a016);
  a303=(a273*a303);
  a298=(a298+a303);
  a091=(a101*a091);
  a298=(a298+a091);
  a133=(a124*a133);
  a298=(a298+a133);
  a312=(a274*a312);
  a298=(a298+a312);
  a319=(a275*a319);
  a298=(a298+a319);
  a326=(a276*a326);
  a298=(a298+a326);
  a333=(a277*a333);
  a298=(a298+a333);
  a335=(a278*a335);
  a298=(a298+a335);
  a262=(a262+a298);
  a300=(a300*a262);
  a029=(a029+a300);
  a266=(a266*a022);
  a273=(a273*a045);
  a266=(a266+a273);
  a101=(a101*a105);
  a266=(a266+a101);
  a124=(a124*a006);
  a266=(a266+a124);
  a274=(a274*a128);
  a266=(a266+a274);
  a275=(a275*a152);
  a266=(a266+a275);
  a276=(a276*a179);
  a266=(a266+a276);
  a277=(a277*a207);
  a266=(a266+a277);
  a278=(a278*a236);
  a266=(a266+a278);
  a026=(a026+a266);
  a002=(a002*a026);
  a029=(a029-a002);
  a250=(a250*a336);
  a113=(a113*a341);
  a250=(a250+a113);
  a294=(a294*a343);
  a250=(a250-a294);
  a029=(a029+a250);
  a029=(a263*a029);
  a040=(a040+a029);
  a107=(a107+a040);
  if (res[0]!=0) res[0][33]=a107;
  a192=(a001*a192);
  a116=(a005*a116);
  a192=(a192+a116);
  a142=(a125*a142);
  a192=(a192+a142);
  a169=(a149*a169);
  a192=(a192+a169);
  a197=(a176*a197);
  a192=(a192+a197);
  a226=(a204*a226);
  a192=(a192+a226);
  a321=(a233*a321);
  a192=(a192+a321);
  a201=(a201*a238);
  a031=(a031*a262);
  a201=(a201+a031);
  a007=(a007*a026);
  a201=(a201+a007);
  a268=(a268*a336);
  a032=(a032*a341);
  a268=(a268-a032);
  a018=(a018*a343);
  a268=(a268+a018);
  a201=(a201+a268);
  a201=(a263*a201);
  a192=(a192+a201);
  a016=(a016+a192);
  if (res[0]!=0) res[0][34]=a016;
  a001=(a001*a251);
  a005=(a005*a013);
  a001=(a001+a005);
  a125=(a125*a148);
  a001=(a001+a125);
  a149=(a149*a078);
  a001=(a001+a149);
  a176=(a176*a307);
  a001=(a001+a176);
  a204=(a204*a314);
  a001=(a001+a204);
  a233=(a233*a063);
  a001=(a001+a233);
  a260=(a260*a238);
  a232=(a232*a262);
  a260=(a260+a232);
  a043=(a043*a026);
  a260=(a260-a043);
  a137=(a137*a336);
  a021=(a021*a341);
  a137=(a137+a021);
  a041=(a041*a343);
  a137=(a137-a041);
  a260=(a260+a137);
  a263=(a263*a260);
  a001=(a001+a263);
  a022=(a022+a001);
  if (res[0]!=0) res[0][35]=a022;
  return 0;
}

/* variational_steps:(y[6x6],t,turns[2x12],h,p[9])->(y_end[6x6]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+345, w1, *w3=w+381, w5, *w6=w+383, w7;
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

/* landing_with_derivative:(y[6x6],z[5],T,p[9])->(J[6x6],R[6]) */
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
  a26=arg[3]? arg[3][8] : 0;
  a26=(a26*a02);
  a42=(a42+a26);
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

/* wobbling_jacobian_12:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* scaled_jacobian_12:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+610, *w1=w+646, *w3=w+652, *w4=w+688;
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

/* newton_12:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_12:(i0[6],i1[9])->(o0[6]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+823, *w2=w+829;
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

/* plain_step:(y[6],phase[2],turns[2x12],h,p[9])->(y_end[6]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104;
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
  a012=arg[4]? arg[4][8] : 0;
  a032=arg[0]? arg[0][5] : 0;
  a033=(a012*a032);
  a031=(a031+a033);
  a033=arg[4]? arg[4][0] : 0;
  a034=arg[0]? arg[0][2] : 0;
  a035=(a033*a034);
  a031=(a031+a035);
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
  a035=5.9175170953613701e-02;
  a035=(a035*a002);
  a036=5.2600151958767730e-02;
  a036=(a036*a002);
  a037=(a036*a029);
  a037=(a008+a037);
  a038=(a007*a037);
  a039=(a036*a008);
  a039=(a010+a039);
  a040=sin(a039);
  a038=(a038*a040);
  a041=(a036*a020);
  a041=(a003+a041);
  a042=(2.*a041);
  a042=(a037-a042);
  a038=(a038*a042);
  a042=(a036*a003);
  a042=(a000+a042);
  a043=sin(a042);
  a044=cos(a039);
  a045=(a043*a044);
  a042=cos(a042);
  a046=(a042*a040);
  a045=(a045-a046);
  a046=(a007*a045);
  a038=(a038-a046);
  a046=(a043*a017);
  a038=(a038+a046);
  a046=(a016-a044);
  a046=(a018*a046);
  a046=(a046+a016);
  a047=(a038/a046);
  a044=(a044-a016);
  a044=(a007*a044);
  a048=(a044/a046);
  a049=casadi_sq(a041);
  a049=(a049*a040);
  a049=(a049+a045);
  a049=(a007*a049);
  a045=arg[2]? arg[2][2] : 0;
  a040=(a024*a045);
  a050=arg[2]? arg[2][3] : 0;
  a051=(a028*a050);
  a040=(a040+a051);
  a040=(a023*a040);
  a040=(a037+a040);
  a040=(a014*a040);
  a045=(a028*a045);
  a050=(a024*a050);
  a045=(a045-a050);
  a045=(a045+a016);
  a045=(a011*a045);
  a045=(a027-a045);
  a045=(a045+a039);
  a045=(a026*a045);
  a040=(a040+a045);
  a049=(a049-a040);
  a040=(a048*a038);
  a049=(a049-a040);
  a040=(a044*a048);
  a040=(a007-a040);
  a045=(a049/a040);
  a042=(a030*a042);
  a046=(a042/a046);
  a044=(a044*a046);
  a040=(a044/a040);
  a038=(a046*a038);
  a039=(a030*a041);
  a039=(a039*a041);
  a039=(a039*a043);
  a043=(a036*a009);
  a043=(a032+a043);
  a050=(a012*a043);
  a039=(a039+a050);
  a036=(a036*a032);
  a036=(a034+a036);
  a036=(a033*a036);
  a039=(a039+a036);
  a038=(a038-a039);
  a049=(a040*a049);
  a038=(a038-a049);
  a042=(a042*a046);
  a042=(a030-a042);
  a044=(a044*a040);
  a042=(a042-a044);
  a038=(a038/a042);
  a040=(a040*a038);
  a045=(a045-a040);
  a048=(a048*a045);
  a047=(a047-a048);
  a046=(a046*a038);
  a047=(a047+a046);
  a047=(a035*a047);
  a031=(a031+a047);
  a031=(a003+a031);
  a047=casadi_sq(a031);
  a046=(a022*a008);
  a037=(a035*a037);
  a046=(a046+a037);
  a046=(a010+a046);
  a037=sin(a046);
  a047=(a047*a037);
  a048=(a022*a003);
  a041=(a035*a041);
  a048=(a048+a041);
  a048=(a000+a048);
  a041=sin(a048);
  a040=cos(a046);
  a042=(a041*a040);
  a048=cos(a048);
  a044=(a048*a037);
  a042=(a042-a044);
  a047=(a047+a042);
  a047=(a007*a047);
  a044=(a022*a029);
  a045=(a035*a045);
  a044=(a044+a045);
  a044=(a008+a044);
  a045=arg[2]? arg[2][4] : 0;
  a049=(a024*a045);
  a039=arg[2]? arg[2][5] : 0;
  a036=(a028*a039);
  a049=(a049+a036);
  a049=(a023*a049);
  a049=(a044+a049);
  a049=(a014*a049);
  a045=(a028*a045);
  a039=(a024*a039);
  a045=(a045-a039);
  a045=(a045+a016);
  a045=(a011*a045);
  a045=(a027-a045);
  a045=(a045+a046);
  a045=(a026*a045);
  a049=(a049+a045);
  a047=(a047-a049);
  a049=(a040-a016);
  a049=(a007*a049);
  a040=(a016-a040);
  a040=(a018*a040);
  a040=(a040+a016);
  a045=(a049/a040);
  a046=(a007*a044);
  a046=(a046*a037);
  a037=(2.*a031);
  a037=(a044-a037);
  a046=(a046*a037);
  a042=(a007*a042);
  a046=(a046-a042);
  a042=(a041*a017);
  a046=(a046+a042);
  a042=(a045*a046);
  a047=(a047-a042);
  a042=(a049*a045);
  a042=(a007-a042);
  a037=(a047/a042);
  a048=(a030*a048);
  a039=(a048/a040);
  a049=(a049*a039);
  a042=(a049/a042);
  a036=(a039*a046);
  a050=(a030*a031);
  a050=(a050*a031);
  a050=(a050*a041);
  a041=(a022*a009);
  a038=(a035*a038);
  a041=(a041+a038);
  a041=(a032+a041);
  a038=(a012*a041);
  a050=(a050+a038);
  a022=(a022*a032);
  a035=(a035*a043);
  a022=(a022+a035);
  a022=(a034+a022);
  a022=(a033*a022);
  a050=(a050+a022);
  a036=(a036-a050);
  a047=(a042*a047);
  a036=(a036-a047);
  a048=(a048*a039);
  a048=(a030-a048);
  a049=(a049*a042);
  a048=(a048-a049);
  a036=(a036/a048);
  a042=(a042*a036);
  a037=(a037-a042);
  a042=(a013*a037);
  a015=(a015+a042);
  a015=(a008+a015);
  a042=(a007*a015);
  a048=(a025*a008);
  a049=(a013*a044);
  a048=(a048+a049);
  a048=(a010+a048);
  a049=sin(a048);
  a042=(a042*a049);
  a047=(a025*a020);
  a046=(a046/a040);
  a045=(a045*a037);
  a046=(a046-a045);
  a039=(a039*a036);
  a046=(a046+a039);
  a039=(a013*a046);
  a047=(a047+a039);
  a047=(a003+a047);
  a039=(2.*a047);
  a039=(a015-a039);
  a042=(a042*a039);
  a039=(a025*a003);
  a045=(a013*a031);
  a039=(a039+a045);
  a039=(a000+a039);
  a045=sin(a039);
  a040=cos(a048);
  a050=(a045*a040);
  a039=cos(a039);
  a022=(a039*a049);
  a050=(a050-a022);
  a022=(a007*a050);
  a042=(a042-a022);
  a022=(a045*a017);
  a042=(a042+a022);
  a022=(a016-a040);
  a022=(a018*a022);
  a022=(a022+a016);
  a035=(a042/a022);
  a040=(a040-a016);
  a040=(a007*a040);
  a043=(a040/a022);
  a038=casadi_sq(a047);
  a038=(a038*a049);
  a038=(a038+a050);
  a038=(a007*a038);
  a050=arg[2]? arg[2][6] : 0;
  a049=(a024*a050);
  a051=arg[2]? arg[2][7] : 0;
  a052=(a028*a051);
  a049=(a049+a052);
  a049=(a023*a049);
  a049=(a015+a049);
  a049=(a014*a049);
  a050=(a028*a050);
  a051=(a024*a051);
  a050=(a050-a051);
  a050=(a050+a016);
  a050=(a011*a050);
  a050=(a027-a050);
  a050=(a050+a048);
  a050=(a026*a050);
  a049=(a049+a050);
  a038=(a038-a049);
  a049=(a043*a042);
  a038=(a038-a049);
  a049=(a040*a043);
  a049=(a007-a049);
  a050=(a038/a049);
  a039=(a030*a039);
  a022=(a039/a022);
  a040=(a040*a022);
  a049=(a040/a049);
  a042=(a022*a042);
  a048=(a030*a047);
  a048=(a048*a047);
  a048=(a048*a045);
  a045=(a025*a009);
  a051=(a013*a036);
  a045=(a045+a051);
  a045=(a032+a045);
  a051=(a012*a045);
  a048=(a048+a051);
  a025=(a025*a032);
  a013=(a013*a041);
  a025=(a025+a013);
  a025=(a034+a025);
  a025=(a033*a025);
  a048=(a048+a025);
  a042=(a042-a048);
  a038=(a049*a038);
  a042=(a042-a038);
  a039=(a039*a022);
  a039=(a030-a039);
  a040=(a040*a049);
  a039=(a039-a040);
  a042=(a042/a039);
  a049=(a049*a042);
  a050=(a050-a049);
  a043=(a043*a050);
  a035=(a035-a043);
  a022=(a022*a042);
  a035=(a035+a022);
  a022=(a021*a035);
  a019=(a019+a022);
  a022=1.2546768756682242e-01;
  a022=(a022*a002);
  a043=2.4136513415926669e-01;
  a043=(a043*a002);
  a049=(a043*a029);
  a039=-8.8454947932828609e-01;
  a039=(a039*a002);
  a037=(a039*a037);
  a049=(a049+a037);
  a037=9.2483400326179199e-01;
  a037=(a037*a002);
  a040=(a037*a050);
  a049=(a049+a040);
  a049=(a008+a049);
  a040=(a007*a049);
  a038=(a043*a008);
  a044=(a039*a044);
  a038=(a038+a044);
  a044=(a037*a015);
  a038=(a038+a044);
  a038=(a010+a038);
  a044=sin(a038);
  a040=(a040*a044);
  a048=(a043*a020);
  a046=(a039*a046);
  a048=(a048+a046);
  a046=(a037*a035);
  a048=(a048+a046);
  a048=(a003+a048);
  a046=(2.*a048);
  a046=(a049-a046);
  a040=(a040*a046);
  a046=(a043*a003);
  a031=(a039*a031);
  a046=(a046+a031);
  a031=(a037*a047);
  a046=(a046+a031);
  a046=(a000+a046);
  a031=sin(a046);
  a025=cos(a038);
  a013=(a031*a025);
  a046=cos(a046);
  a051=(a046*a044);
  a013=(a013-a051);
  a051=(a007*a013);
  a040=(a040-a051);
  a051=(a031*a017);
  a040=(a040+a051);
  a051=(a016-a025);
  a051=(a018*a051);
  a051=(a051+a016);
  a052=(a040/a051);
  a025=(a025-a016);
  a025=(a007*a025);
  a053=(a025/a051);
  a054=casadi_sq(a048);
  a054=(a054*a044);
  a054=(a054+a013);
  a054=(a007*a054);
  a013=arg[2]? arg[2][8] : 0;
  a044=(a024*a013);
  a055=arg[2]? arg[2][9] : 0;
  a056=(a028*a055);
  a044=(a044+a056);
  a044=(a023*a044);
  a044=(a049+a044);
  a044=(a014*a044);
  a013=(a028*a013);
  a055=(a024*a055);
  a013=(a013-a055);
  a013=(a013+a016);
  a013=(a011*a013);
  a013=(a027-a013);
  a013=(a013+a038);
  a013=(a026*a013);
  a044=(a044+a013);
  a054=(a054-a044);
  a044=(a053*a040);
  a054=(a054-a044);
  a044=(a025*a053);
  a044=(a007-a044);
  a013=(a054/a044);
  a046=(a030*a046);
  a051=(a046/a051);
  a025=(a025*a051);
  a044=(a025/a044);
  a040=(a051*a040);
  a038=(a030*a048);
  a038=(a038*a048);
  a038=(a038*a031);
  a031=(a043*a009);
  a036=(a039*a036);
  a031=(a031+a036);
  a036=(a037*a042);
  a031=(a031+a036);
  a031=(a032+a031);
  a036=(a012*a031);
  a038=(a038+a036);
  a043=(a043*a032);
  a039=(a039*a041);
  a043=(a043+a039);
  a037=(a037*a045);
  a043=(a043+a037);
  a043=(a034+a043);
  a043=(a033*a043);
  a038=(a038+a043);
  a040=(a040-a038);
  a054=(a044*a054);
  a040=(a040-a054);
  a046=(a046*a051);
  a046=(a030-a046);
  a025=(a025*a044);
  a046=(a046-a025);
  a040=(a040/a046);
  a044=(a044*a040);
  a013=(a013-a044);
  a053=(a053*a013);
  a052=(a052-a053);
  a051=(a051*a040);
  a052=(a052+a051);
  a051=(a022*a052);
  a019=(a019+a051);
  a019=(a003+a019);
  a051=(a005*a019);
  a004=(a004+a051);
  a051=1.8915178993145003e+00;
  a051=(a051*a002);
  a053=3.7109375000000000e-02;
  a053=(a053*a002);
  a044=(a053*a020);
  a046=1.7025221101954405e-01;
  a046=(a046*a002);
  a025=(a046*a035);
  a044=(a044+a025);
  a025=6.0216538980455959e-02;
  a025=(a025*a002);
  a054=(a025*a052);
  a044=(a044+a054);
  a054=-1.7578125000000000e-02;
  a054=(a054*a002);
  a038=(a006*a029);
  a043=(a021*a050);
  a038=(a038+a043);
  a043=(a022*a013);
  a038=(a038+a043);
  a038=(a008+a038);
  a043=(a007*a038);
  a037=(a006*a008);
  a039=(a021*a015);
  a037=(a037+a039);
  a039=(a022*a049);
  a037=(a037+a039);
  a037=(a010+a037);
  a039=sin(a037);
  a043=(a043*a039);
  a041=(2.*a019);
  a041=(a038-a041);
  a043=(a043*a041);
  a041=(a006*a003);
  a036=(a021*a047);
  a041=(a041+a036);
  a036=(a022*a048);
  a041=(a041+a036);
  a041=(a000+a041);
  a036=sin(a041);
  a055=cos(a037);
  a056=(a036*a055);
  a041=cos(a041);
  a057=(a041*a039);
  a056=(a056-a057);
  a057=(a007*a056);
  a043=(a043-a057);
  a057=(a036*a017);
  a043=(a043+a057);
  a057=(a016-a055);
  a057=(a018*a057);
  a057=(a057+a016);
  a058=(a043/a057);
  a055=(a055-a016);
  a055=(a007*a055);
  a059=(a055/a057);
  a060=casadi_sq(a019);
  a060=(a060*a039);
  a060=(a060+a056);
  a060=(a007*a060);
  a056=arg[2]? arg[2][10] : 0;
  a039=(a024*a056);
  a061=arg[2]? arg[2][11] : 0;
  a062=(a028*a061);
  a039=(a039+a062);
  a039=(a023*a039);
  a039=(a038+a039);
  a039=(a014*a039);
  a056=(a028*a056);
  a061=(a024*a061);
  a056=(a056-a061);
  a056=(a056+a016);
  a056=(a011*a056);
  a056=(a027-a056);
  a056=(a056+a037);
  a056=(a026*a056);
  a039=(a039+a056);
  a060=(a060-a039);
  a039=(a059*a043);
  a060=(a060-a039);
  a039=(a055*a059);
  a039=(a007-a039);
  a056=(a060/a039);
  a041=(a030*a041);
  a057=(a041/a057);
  a055=(a055*a057);
  a039=(a055/a039);
  a043=(a057*a043);
  a037=(a030*a019);
  a037=(a037*a019);
  a037=(a037*a036);
  a036=(a006*a009);
  a061=(a021*a042);
  a036=(a036+a061);
  a061=(a022*a040);
  a036=(a036+a061);
  a036=(a032+a036);
  a061=(a012*a036);
  a037=(a037+a061);
  a006=(a006*a032);
  a021=(a021*a045);
  a006=(a006+a021);
  a022=(a022*a031);
  a006=(a006+a022);
  a006=(a034+a006);
  a006=(a033*a006);
  a037=(a037+a006);
  a043=(a043-a037);
  a060=(a039*a060);
  a043=(a043-a060);
  a041=(a041*a057);
  a041=(a030-a041);
  a055=(a055*a039);
  a041=(a041-a055);
  a043=(a043/a041);
  a039=(a039*a043);
  a056=(a056-a039);
  a059=(a059*a056);
  a058=(a058-a059);
  a057=(a057*a043);
  a058=(a058+a057);
  a057=(a054*a058);
  a044=(a044+a057);
  a044=(a003+a044);
  a057=(a051*a044);
  a004=(a004+a057);
  a057=-5.8012039600105849e+00;
  a057=(a057*a002);
  a059=3.7092000118504789e-02;
  a059=(a059*a002);
  a039=(a059*a020);
  a041=1.7038392571223998e-01;
  a041=(a041*a002);
  a055=(a041*a035);
  a039=(a039+a055);
  a055=1.0726203044637328e-01;
  a055=(a055*a002);
  a060=(a055*a052);
  a039=(a039+a060);
  a060=-1.5319437748624402e-02;
  a060=(a060*a002);
  a037=(a060*a058);
  a039=(a039+a037);
  a037=8.2737891638140233e-03;
  a037=(a037*a002);
  a006=(a053*a029);
  a022=(a046*a050);
  a006=(a006+a022);
  a022=(a025*a013);
  a006=(a006+a022);
  a022=(a054*a056);
  a006=(a006+a022);
  a006=(a008+a006);
  a022=(a007*a006);
  a021=(a053*a008);
  a061=(a046*a015);
  a021=(a021+a061);
  a061=(a025*a049);
  a021=(a021+a061);
  a061=(a054*a038);
  a021=(a021+a061);
  a021=(a010+a021);
  a061=sin(a021);
  a022=(a022*a061);
  a062=(2.*a044);
  a062=(a006-a062);
  a022=(a022*a062);
  a062=(a053*a003);
  a063=(a046*a047);
  a062=(a062+a063);
  a063=(a025*a048);
  a062=(a062+a063);
  a063=(a054*a019);
  a062=(a062+a063);
  a062=(a000+a062);
  a063=sin(a062);
  a064=cos(a021);
  a065=(a063*a064);
  a062=cos(a062);
  a066=(a062*a061);
  a065=(a065-a066);
  a066=(a007*a065);
  a022=(a022-a066);
  a066=(a063*a017);
  a022=(a022+a066);
  a066=(a016-a064);
  a066=(a018*a066);
  a066=(a066+a016);
  a067=(a022/a066);
  a064=(a064-a016);
  a064=(a007*a064);
  a068=(a064/a066);
  a069=casadi_sq(a044);
  a069=(a069*a061);
  a069=(a069+a065);
  a069=(a007*a069);
  a065=arg[2]? arg[2][12] : 0;
  a061=(a024*a065);
  a070=arg[2]? arg[2][13] : 0;
  a071=(a028*a070);
  a061=(a061+a071);
  a061=(a023*a061);
  a061=(a006+a061);
  a061=(a014*a061);
  a065=(a028*a065);
  a070=(a024*a070);
  a065=(a065-a070);
  a065=(a065+a016);
  a065=(a011*a065);
  a065=(a027-a065);
  a065=(a065+a021);
  a065=(a026*a065);
  a061=(a061+a065);
  a069=(a069-a061);
  a061=(a068*a022);
  a069=(a069-a061);
  a061=(a064*a068);
  a061=(a007-a061);
  a065=(a069/a061);
  a062=(a030*a062);
  a066=(a062/a066);
  a064=(a064*a066);
  a061=(a064/a061);
  a022=(a066*a022);
  a021=(a030*a044);
  a021=(a021*a044);
  a021=(a021*a063);
  a063=(a053*a009);
  a070=(a046*a042);
  a063=(a063+a070);
  a070=(a025*a040);
  a063=(a063+a070);
  a070=(a054*a043);
  a063=(a063+a070);
  a063=(a032+a063);
  a070=(a012*a063);
  a021=(a021+a070);
  a053=(a053*a032);
  a046=(a046*a045);
  a053=(a053+a046);
  a025=(a025*a031);
  a053=(a053+a025);
  a054=(a054*a036);
  a053=(a053+a054);
  a053=(a034+a053);
  a053=(a033*a053);
  a021=(a021+a053);
  a022=(a022-a021);
  a069=(a061*a069);
  a022=(a022-a069);
  a062=(a062*a066);
  a062=(a030-a062);
  a064=(a064*a061);
  a062=(a062-a064);
  a022=(a022/a062);
  a061=(a061*a022);
  a065=(a065-a061);
  a068=(a068*a065);
  a067=(a067-a068);
  a066=(a066*a022);
  a067=(a067+a066);
  a066=(a037*a067);
  a039=(a039+a066);
  a039=(a003+a039);
  a066=(a057*a039);
  a004=(a004+a066);
  a066=3.1116436695781990e-01;
  a066=(a066*a002);
  a068=6.2411095871607569e-01;
  a068=(a068*a002);
  a061=(a068*a020);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a064=(a062*a035);
  a061=(a061+a064);
  a064=-8.6821934684172597e-01;
  a064=(a064*a002);
  a069=(a064*a052);
  a061=(a061+a069);
  a069=2.7592099699446710e+01;
  a069=(a069*a002);
  a021=(a069*a058);
  a061=(a061+a021);
  a021=2.0154067550477894e+01;
  a021=(a021*a002);
  a053=(a021*a067);
  a061=(a061+a053);
  a053=-4.3489884181069961e+01;
  a053=(a053*a002);
  a054=(a059*a029);
  a025=(a041*a050);
  a054=(a054+a025);
  a025=(a055*a013);
  a054=(a054+a025);
  a025=(a060*a056);
  a054=(a054+a025);
  a025=(a037*a065);
  a054=(a054+a025);
  a054=(a008+a054);
  a025=(a007*a054);
  a046=(a059*a008);
  a070=(a041*a015);
  a046=(a046+a070);
  a070=(a055*a049);
  a046=(a046+a070);
  a070=(a060*a038);
  a046=(a046+a070);
  a070=(a037*a006);
  a046=(a046+a070);
  a046=(a010+a046);
  a070=sin(a046);
  a025=(a025*a070);
  a071=(2.*a039);
  a071=(a054-a071);
  a025=(a025*a071);
  a071=(a059*a003);
  a072=(a041*a047);
  a071=(a071+a072);
  a072=(a055*a048);
  a071=(a071+a072);
  a072=(a060*a019);
  a071=(a071+a072);
  a072=(a037*a044);
  a071=(a071+a072);
  a071=(a000+a071);
  a072=sin(a071);
  a073=cos(a046);
  a074=(a072*a073);
  a071=cos(a071);
  a075=(a071*a070);
  a074=(a074-a075);
  a075=(a007*a074);
  a025=(a025-a075);
  a075=(a072*a017);
  a025=(a025+a075);
  a075=(a016-a073);
  a075=(a018*a075);
  a075=(a075+a016);
  a076=(a025/a075);
  a073=(a073-a016);
  a073=(a007*a073);
  a077=(a073/a075);
  a078=casadi_sq(a039);
  a078=(a078*a070);
  a078=(a078+a074);
  a078=(a007*a078);
  a074=arg[2]? arg[2][14] : 0;
  a070=(a024*a074);
  a079=arg[2]? arg[2][15] : 0;
  a080=(a028*a079);
  a070=(a070+a080);
  a070=(a023*a070);
  a070=(a054+a070);
  a070=(a014*a070);
  a074=(a028*a074);
  a079=(a024*a079);
  a074=(a074-a079);
  a074=(a074+a016);
  a074=(a011*a074);
  a074=(a027-a074);
  a074=(a074+a046);
  a074=(a026*a074);
  a070=(a070+a074);
  a078=(a078-a070);
  a070=(a077*a025);
  a078=(a078-a070);
  a070=(a073*a077);
  a070=(a007-a070);
  a074=(a078/a070);
  a071=(a030*a071);
  a075=(a071/a075);
  a073=(a073*a075);
  a070=(a073/a070);
  a025=(a075*a025);
  a046=(a030*a039);
  a046=(a046*a039);
  a046=(a046*a072);
  a072=(a059*a009);
  a079=(a041*a042);
  a072=(a072+a079);
  a079=(a055*a040);
  a072=(a072+a079);
  a079=(a060*a043);
  a072=(a072+a079);
  a079=(a037*a022);
  a072=(a072+a079);
  a072=(a032+a072);
  a079=(a012*a072);
  a046=(a046+a079);
  a059=(a059*a032);
  a041=(a041*a045);
  a059=(a059+a041);
  a055=(a055*a031);
  a059=(a059+a055);
  a060=(a060*a036);
  a059=(a059+a060);
  a037=(a037*a063);
  a059=(a059+a037);
  a059=(a034+a059);
  a059=(a033*a059);
  a046=(a046+a059);
  a025=(a025-a046);
  a078=(a070*a078);
  a025=(a025-a078);
  a071=(a071*a075);
  a071=(a030-a071);
  a073=(a073*a070);
  a071=(a071-a073);
  a025=(a025/a071);
  a070=(a070*a025);
  a074=(a074-a070);
  a077=(a077*a074);
  a076=(a076-a077);
  a075=(a075*a025);
  a076=(a076+a075);
  a075=(a053*a076);
  a061=(a061+a075);
  a061=(a003+a061);
  a075=(a066*a061);
  a004=(a004+a075);
  a075=-1.5216094966251609e-01;
  a075=(a075*a002);
  a077=4.7766253643826434e-01;
  a077=(a077*a002);
  a070=(a077*a020);
  a071=-2.4881146199716677e+00;
  a071=(a071*a002);
  a073=(a071*a035);
  a070=(a070+a073);
  a073=-5.9029082683684297e-01;
  a073=(a073*a002);
  a078=(a073*a052);
  a070=(a070+a078);
  a078=2.1230051448181193e+01;
  a078=(a078*a002);
  a046=(a078*a058);
  a070=(a070+a046);
  a046=1.5279233632882423e+01;
  a046=(a046*a002);
  a059=(a046*a067);
  a070=(a070+a059);
  a059=-3.3288210968984863e+01;
  a059=(a059*a002);
  a037=(a059*a076);
  a070=(a070+a037);
  a037=-2.0331201708508627e-02;
  a037=(a037*a002);
  a060=(a068*a029);
  a055=(a062*a050);
  a060=(a060+a055);
  a055=(a064*a013);
  a060=(a060+a055);
  a055=(a069*a056);
  a060=(a060+a055);
  a055=(a021*a065);
  a060=(a060+a055);
  a055=(a053*a074);
  a060=(a060+a055);
  a060=(a008+a060);
  a055=(a007*a060);
  a041=(a068*a008);
  a079=(a062*a015);
  a041=(a041+a079);
  a079=(a064*a049);
  a041=(a041+a079);
  a079=(a069*a038);
  a041=(a041+a079);
  a079=(a021*a006);
  a041=(a041+a079);
  a079=(a053*a054);
  a041=(a041+a079);
  a041=(a010+a041);
  a079=sin(a041);
  a055=(a055*a079);
  a080=(2.*a061);
  a080=(a060-a080);
  a055=(a055*a080);
  a080=(a068*a003);
  a081=(a062*a047);
  a080=(a080+a081);
  a081=(a064*a048);
  a080=(a080+a081);
  a081=(a069*a019);
  a080=(a080+a081);
  a081=(a021*a044);
  a080=(a080+a081);
  a081=(a053*a039);
  a080=(a080+a081);
  a080=(a000+a080);
  a081=sin(a080);
  a082=cos(a041);
  a083=(a081*a082);
  a080=cos(a080);
  a084=(a080*a079);
  a083=(a083-a084);
  a084=(a007*a083);
  a055=(a055-a084);
  a084=(a081*a017);
  a055=(a055+a084);
  a084=(a016-a082);
  a084=(a018*a084);
  a084=(a084+a016);
  a085=(a055/a084);
  a082=(a082-a016);
  a082=(a007*a082);
  a086=(a082/a084);
  a087=casadi_sq(a061);
  a087=(a087*a079);
  a087=(a087+a083);
  a087=(a007*a087);
  a083=arg[2]? arg[2][16] : 0;
  a079=(a024*a083);
  a088=arg[2]? arg[2][17] : 0;
  a089=(a028*a088);
  a079=(a079+a089);
  a079=(a023*a079);
  a079=(a060+a079);
  a079=(a014*a079);
  a083=(a028*a083);
  a088=(a024*a088);
  a083=(a083-a088);
  a083=(a083+a016);
  a083=(a011*a083);
  a083=(a027-a083);
  a083=(a083+a041);
  a083=(a026*a083);
  a079=(a079+a083);
  a087=(a087-a079);
  a079=(a086*a055);
  a087=(a087-a079);
  a079=(a082*a086);
  a079=(a007-a079);
  a083=(a087/a079);
  a080=(a030*a080);
  a084=(a080/a084);
  a082=(a082*a084);
  a079=(a082/a079);
  a055=(a084*a055);
  a041=(a030*a061);
  a041=(a041*a061);
  a041=(a041*a081);
  a081=(a068*a009);
  a088=(a062*a042);
  a081=(a081+a088);
  a088=(a064*a040);
  a081=(a081+a088);
  a088=(a069*a043);
  a081=(a081+a088);
  a088=(a021*a022);
  a081=(a081+a088);
  a088=(a053*a025);
  a081=(a081+a088);
  a081=(a032+a081);
  a088=(a012*a081);
  a041=(a041+a088);
  a068=(a068*a032);
  a062=(a062*a045);
  a068=(a068+a062);
  a064=(a064*a031);
  a068=(a068+a064);
  a069=(a069*a036);
  a068=(a068+a069);
  a021=(a021*a063);
  a068=(a068+a021);
  a053=(a053*a072);
  a068=(a068+a053);
  a068=(a034+a068);
  a068=(a033*a068);
  a041=(a041+a068);
  a055=(a055-a041);
  a087=(a079*a087);
  a055=(a055-a087);
  a080=(a080*a084);
  a080=(a030-a080);
  a082=(a082*a079);
  a080=(a080-a082);
  a055=(a055/a080);
  a079=(a079*a055);
  a083=(a083-a079);
  a086=(a086*a083);
  a085=(a085-a086);
  a084=(a084*a055);
  a085=(a085+a084);
  a084=(a037*a085);
  a070=(a070+a084);
  a070=(a003+a070);
  a084=(a075*a070);
  a004=(a004+a084);
  a084=2.0136540080403034e-01;
  a084=(a084*a002);
  a086=-9.3714243008598730e-01;
  a086=(a086*a002);
  a079=(a086*a020);
  a080=5.1863724288440638e+00;
  a080=(a080*a002);
  a082=(a080*a035);
  a079=(a079+a082);
  a082=1.0914373489967295e+00;
  a082=(a082*a002);
  a087=(a082*a052);
  a079=(a079+a087);
  a087=-8.1497870107469268e+00;
  a087=(a087*a002);
  a041=(a087*a058);
  a079=(a079+a041);
  a041=-1.8520065659996959e+01;
  a041=(a041*a002);
  a068=(a041*a067);
  a079=(a079+a068);
  a068=2.2739487099350505e+01;
  a068=(a068*a002);
  a053=(a068*a076);
  a079=(a079+a053);
  a053=2.4936055526796523e+00;
  a053=(a053*a002);
  a021=(a053*a085);
  a079=(a079+a021);
  a021=-3.0467644718982196e+00;
  a021=(a021*a002);
  a069=(a077*a029);
  a064=(a071*a050);
  a069=(a069+a064);
  a064=(a073*a013);
  a069=(a069+a064);
  a064=(a078*a056);
  a069=(a069+a064);
  a064=(a046*a065);
  a069=(a069+a064);
  a064=(a059*a074);
  a069=(a069+a064);
  a064=(a037*a083);
  a069=(a069+a064);
  a069=(a008+a069);
  a064=(a007*a069);
  a062=(a077*a008);
  a088=(a071*a015);
  a062=(a062+a088);
  a088=(a073*a049);
  a062=(a062+a088);
  a088=(a078*a038);
  a062=(a062+a088);
  a088=(a046*a006);
  a062=(a062+a088);
  a088=(a059*a054);
  a062=(a062+a088);
  a088=(a037*a060);
  a062=(a062+a088);
  a062=(a010+a062);
  a088=sin(a062);
  a064=(a064*a088);
  a089=(2.*a070);
  a089=(a069-a089);
  a064=(a064*a089);
  a089=(a077*a003);
  a090=(a071*a047);
  a089=(a089+a090);
  a090=(a073*a048);
  a089=(a089+a090);
  a090=(a078*a019);
  a089=(a089+a090);
  a090=(a046*a044);
  a089=(a089+a090);
  a090=(a059*a039);
  a089=(a089+a090);
  a090=(a037*a061);
  a089=(a089+a090);
  a089=(a000+a089);
  a090=sin(a089);
  a091=cos(a062);
  a092=(a090*a091);
  a089=cos(a089);
  a093=(a089*a088);
  a092=(a092-a093);
  a093=(a007*a092);
  a064=(a064-a093);
  a093=(a090*a017);
  a064=(a064+a093);
  a093=(a016-a091);
  a093=(a018*a093);
  a093=(a093+a016);
  a094=(a064/a093);
  a091=(a091-a016);
  a091=(a007*a091);
  a095=(a091/a093);
  a096=casadi_sq(a070);
  a096=(a096*a088);
  a096=(a096+a092);
  a096=(a007*a096);
  a092=arg[2]? arg[2][18] : 0;
  a088=(a024*a092);
  a097=arg[2]? arg[2][19] : 0;
  a098=(a028*a097);
  a088=(a088+a098);
  a088=(a023*a088);
  a088=(a069+a088);
  a088=(a014*a088);
  a092=(a028*a092);
  a097=(a024*a097);
  a092=(a092-a097);
  a092=(a092+a016);
  a092=(a011*a092);
  a092=(a027-a092);
  a092=(a092+a062);
  a092=(a026*a092);
  a088=(a088+a092);
  a096=(a096-a088);
  a088=(a095*a064);
  a096=(a096-a088);
  a088=(a091*a095);
  a088=(a007-a088);
  a092=(a096/a088);
  a089=(a030*a089);
  a093=(a089/a093);
  a091=(a091*a093);
  a088=(a091/a088);
  a064=(a093*a064);
  a062=(a030*a070);
  a062=(a062*a070);
  a062=(a062*a090);
  a090=(a077*a009);
  a097=(a071*a042);
  a090=(a090+a097);
  a097=(a073*a040);
  a090=(a090+a097);
  a097=(a078*a043);
  a090=(a090+a097);
  a097=(a046*a022);
  a090=(a090+a097);
  a097=(a059*a025);
  a090=(a090+a097);
  a097=(a037*a055);
  a090=(a090+a097);
  a090=(a032+a090);
  a097=(a012*a090);
  a062=(a062+a097);
  a077=(a077*a032);
  a071=(a071*a045);
  a077=(a077+a071);
  a073=(a073*a031);
  a077=(a077+a073);
  a078=(a078*a036);
  a077=(a077+a078);
  a046=(a046*a063);
  a077=(a077+a046);
  a059=(a059*a072);
  a077=(a077+a059);
  a037=(a037*a081);
  a077=(a077+a037);
  a077=(a034+a077);
  a077=(a033*a077);
  a062=(a062+a077);
  a064=(a064-a062);
  a096=(a088*a096);
  a064=(a064-a096);
  a089=(a089*a093);
  a089=(a030-a089);
  a091=(a091*a088);
  a089=(a089-a091);
  a064=(a064/a089);
  a088=(a088*a064);
  a092=(a092-a088);
  a095=(a095*a092);
  a094=(a094-a095);
  a093=(a093*a064);
  a094=(a094+a093);
  a093=(a021*a094);
  a079=(a079+a093);
  a079=(a003+a079);
  a093=(a084*a079);
  a004=(a004+a093);
  a093=4.4710615727772587e-02;
  a093=(a093*a002);
  a095=2.2733101475165380e+00;
  a095=(a095*a002);
  a088=(a095*a020);
  a089=-1.0534495466737249e+01;
  a089=(a089*a002);
  a035=(a089*a035);
  a088=(a088+a035);
  a035=-2.0008720582248625e+00;
  a035=(a035*a002);
  a052=(a035*a052);
  a088=(a088+a052);
  a052=-1.7958931863118799e+01;
  a052=(a052*a002);
  a091=(a052*a058);
  a088=(a088+a091);
  a091=2.7948884529419960e+01;
  a091=(a091*a002);
  a096=(a091*a067);
  a088=(a088+a096);
  a096=-2.8589982771350235e+00;
  a096=(a096*a002);
  a062=(a096*a076);
  a088=(a088+a062);
  a062=-8.8728569335306293e+00;
  a062=(a062*a002);
  a077=(a062*a085);
  a088=(a088+a077);
  a077=1.2360567175794303e+01;
  a077=(a077*a002);
  a037=(a077*a094);
  a088=(a088+a037);
  a037=6.4339274601576357e-01;
  a037=(a037*a002);
  a002=(a086*a029);
  a059=(a080*a050);
  a002=(a002+a059);
  a059=(a082*a013);
  a002=(a002+a059);
  a059=(a087*a056);
  a002=(a002+a059);
  a059=(a041*a065);
  a002=(a002+a059);
  a059=(a068*a074);
  a002=(a002+a059);
  a059=(a053*a083);
  a002=(a002+a059);
  a059=(a021*a092);
  a002=(a002+a059);
  a002=(a008+a002);
  a059=(a007*a002);
  a046=(a086*a008);
  a078=(a080*a015);
  a046=(a046+a078);
  a078=(a082*a049);
  a046=(a046+a078);
  a078=(a087*a038);
  a046=(a046+a078);
  a078=(a041*a006);
  a046=(a046+a078);
  a078=(a068*a054);
  a046=(a046+a078);
  a078=(a053*a060);
  a046=(a046+a078);
  a078=(a021*a069);
  a046=(a046+a078);
  a046=(a010+a046);
  a078=sin(a046);
  a059=(a059*a078);
  a073=(2.*a079);
  a073=(a002-a073);
  a059=(a059*a073);
  a073=(a086*a003);
  a071=(a080*a047);
  a073=(a073+a071);
  a071=(a082*a048);
  a073=(a073+a071);
  a071=(a087*a019);
  a073=(a073+a071);
  a071=(a041*a044);
  a073=(a073+a071);
  a071=(a068*a039);
  a073=(a073+a071);
  a071=(a053*a061);
  a073=(a073+a071);
  a071=(a021*a070);
  a073=(a073+a071);
  a073=(a000+a073);
  a071=sin(a073);
  a097=cos(a046);
  a098=(a071*a097);
  a073=cos(a073);
  a099=(a073*a078);
  a098=(a098-a099);
  a099=(a007*a098);
  a059=(a059-a099);
  a099=(a071*a017);
  a059=(a059+a099);
  a099=(a016-a097);
  a099=(a018*a099);
  a099=(a099+a016);
  a100=(a059/a099);
  a097=(a097-a016);
  a097=(a007*a097);
  a101=(a097/a099);
  a102=casadi_sq(a079);
  a102=(a102*a078);
  a102=(a102+a098);
  a102=(a007*a102);
  a098=arg[2]? arg[2][20] : 0;
  a078=(a024*a098);
  a103=arg[2]? arg[2][21] : 0;
  a104=(a028*a103);
  a078=(a078+a104);
  a078=(a023*a078);
  a078=(a002+a078);
  a078=(a014*a078);
  a098=(a028*a098);
  a103=(a024*a103);
  a098=(a098-a103);
  a098=(a098+a016);
  a098=(a011*a098);
  a098=(a027-a098);
  a098=(a098+a046);
  a098=(a026*a098);
  a078=(a078+a098);
  a102=(a102-a078);
  a078=(a101*a059);
  a102=(a102-a078);
  a078=(a097*a101);
  a078=(a007-a078);
  a098=(a102/a078);
  a073=(a030*a073);
  a099=(a073/a099);
  a097=(a097*a099);
  a078=(a097/a078);
  a059=(a099*a059);
  a046=(a030*a079);
  a046=(a046*a079);
  a046=(a046*a071);
  a071=(a086*a009);
  a103=(a080*a042);
  a071=(a071+a103);
  a103=(a082*a040);
  a071=(a071+a103);
  a103=(a087*a043);
  a071=(a071+a103);
  a103=(a041*a022);
  a071=(a071+a103);
  a103=(a068*a025);
  a071=(a071+a103);
  a103=(a053*a055);
  a071=(a071+a103);
  a103=(a021*a064);
  a071=(a071+a103);
  a071=(a032+a071);
  a103=(a012*a071);
  a046=(a046+a103);
  a086=(a086*a032);
  a080=(a080*a045);
  a086=(a086+a080);
  a082=(a082*a031);
  a086=(a086+a082);
  a087=(a087*a036);
  a086=(a086+a087);
  a041=(a041*a063);
  a086=(a086+a041);
  a068=(a068*a072);
  a086=(a086+a068);
  a053=(a053*a081);
  a086=(a086+a053);
  a021=(a021*a090);
  a086=(a086+a021);
  a086=(a034+a086);
  a086=(a033*a086);
  a046=(a046+a086);
  a059=(a059-a046);
  a102=(a078*a102);
  a059=(a059-a102);
  a073=(a073*a099);
  a073=(a030-a073);
  a097=(a097*a078);
  a073=(a073-a097);
  a059=(a059/a073);
  a078=(a078*a059);
  a098=(a098-a078);
  a101=(a101*a098);
  a100=(a100-a101);
  a099=(a099*a059);
  a100=(a100+a099);
  a099=(a037*a100);
  a088=(a088+a099);
  a088=(a003+a088);
  a099=(a093*a088);
  a004=(a004+a099);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a099=(a005*a038);
  a004=(a004+a099);
  a099=(a051*a006);
  a004=(a004+a099);
  a099=(a057*a054);
  a004=(a004+a099);
  a099=(a066*a060);
  a004=(a004+a099);
  a099=(a075*a069);
  a004=(a004+a099);
  a099=(a084*a002);
  a004=(a004+a099);
  a099=(a095*a029);
  a050=(a089*a050);
  a099=(a099+a050);
  a013=(a035*a013);
  a099=(a099+a013);
  a013=(a052*a056);
  a099=(a099+a013);
  a013=(a091*a065);
  a099=(a099+a013);
  a013=(a096*a074);
  a099=(a099+a013);
  a013=(a062*a083);
  a099=(a099+a013);
  a013=(a077*a092);
  a099=(a099+a013);
  a013=(a037*a098);
  a099=(a099+a013);
  a099=(a008+a099);
  a013=(a093*a099);
  a004=(a004+a013);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a032);
  a013=(a005*a036);
  a004=(a004+a013);
  a013=(a051*a063);
  a004=(a004+a013);
  a013=(a057*a072);
  a004=(a004+a013);
  a013=(a066*a081);
  a004=(a004+a013);
  a013=(a075*a090);
  a004=(a004+a013);
  a013=(a084*a071);
  a004=(a004+a013);
  a013=(a095*a009);
  a042=(a089*a042);
  a013=(a013+a042);
  a040=(a035*a040);
  a013=(a013+a040);
  a040=(a052*a043);
  a013=(a013+a040);
  a040=(a091*a022);
  a013=(a013+a040);
  a040=(a096*a025);
  a013=(a013+a040);
  a040=(a062*a055);
  a013=(a013+a040);
  a040=(a077*a064);
  a013=(a013+a040);
  a040=(a037*a059);
  a013=(a013+a040);
  a013=(a032+a013);
  a040=(a093*a013);
  a004=(a004+a040);
  a004=(a034+a004);
  if (res[0]!=0) res[0][2]=a004;
  a020=(a001*a020);
  a058=(a005*a058);
  a020=(a020+a058);
  a067=(a051*a067);
  a020=(a020+a067);
  a076=(a057*a076);
  a020=(a020+a076);
  a085=(a066*a085);
  a020=(a020+a085);
  a094=(a075*a094);
  a020=(a020+a094);
  a100=(a084*a100);
  a020=(a020+a100);
  a100=(a007*a099);
  a094=(a095*a008);
  a015=(a089*a015);
  a094=(a094+a015);
  a049=(a035*a049);
  a094=(a094+a049);
  a038=(a052*a038);
  a094=(a094+a038);
  a006=(a091*a006);
  a094=(a094+a006);
  a054=(a096*a054);
  a094=(a094+a054);
  a060=(a062*a060);
  a094=(a094+a060);
  a069=(a077*a069);
  a094=(a094+a069);
  a002=(a037*a002);
  a094=(a094+a002);
  a010=(a010+a094);
  a094=sin(a010);
  a100=(a100*a094);
  a002=(2.*a088);
  a002=(a099-a002);
  a100=(a100*a002);
  a002=(a095*a003);
  a047=(a089*a047);
  a002=(a002+a047);
  a048=(a035*a048);
  a002=(a002+a048);
  a019=(a052*a019);
  a002=(a002+a019);
  a044=(a091*a044);
  a002=(a002+a044);
  a039=(a096*a039);
  a002=(a002+a039);
  a061=(a062*a061);
  a002=(a002+a061);
  a070=(a077*a070);
  a002=(a002+a070);
  a079=(a037*a079);
  a002=(a002+a079);
  a000=(a000+a002);
  a002=sin(a000);
  a079=cos(a010);
  a070=(a002*a079);
  a000=cos(a000);
  a061=(a000*a094);
  a070=(a070-a061);
  a061=(a007*a070);
  a100=(a100-a061);
  a017=(a002*a017);
  a100=(a100+a017);
  a017=(a016-a079);
  a018=(a018*a017);
  a018=(a018+a016);
  a017=(a100/a018);
  a079=(a079-a016);
  a079=(a007*a079);
  a061=(a079/a018);
  a039=casadi_sq(a088);
  a039=(a039*a094);
  a039=(a039+a070);
  a039=(a007*a039);
  a070=arg[2]? arg[2][22] : 0;
  a094=(a024*a070);
  a044=arg[2]? arg[2][23] : 0;
  a019=(a028*a044);
  a094=(a094+a019);
  a023=(a023*a094);
  a099=(a099+a023);
  a014=(a014*a099);
  a028=(a028*a070);
  a024=(a024*a044);
  a028=(a028-a024);
  a028=(a028+a016);
  a011=(a011*a028);
  a027=(a027-a011);
  a027=(a027+a010);
  a026=(a026*a027);
  a014=(a014+a026);
  a039=(a039-a014);
  a014=(a061*a100);
  a039=(a039-a014);
  a014=(a079*a061);
  a007=(a007-a014);
  a014=(a039/a007);
  a000=(a030*a000);
  a018=(a000/a018);
  a079=(a079*a018);
  a007=(a079/a007);
  a100=(a018*a100);
  a026=(a030*a088);
  a026=(a026*a088);
  a026=(a026*a002);
  a012=(a012*a013);
  a026=(a026+a012);
  a095=(a095*a032);
  a089=(a089*a045);
  a095=(a095+a089);
  a035=(a035*a031);
  a095=(a095+a035);
  a052=(a052*a036);
  a095=(a095+a052);
  a091=(a091*a063);
  a095=(a095+a091);
  a096=(a096*a072);
  a095=(a095+a096);
  a062=(a062*a081);
  a095=(a095+a062);
  a077=(a077*a090);
  a095=(a095+a077);
  a037=(a037*a071);
  a095=(a095+a037);
  a034=(a034+a095);
  a033=(a033*a034);
  a026=(a026+a033);
  a100=(a100-a026);
  a039=(a007*a039);
  a100=(a100-a039);
  a000=(a000*a018);
  a030=(a030-a000);
  a079=(a079*a007);
  a030=(a030-a079);
  a100=(a100/a030);
  a007=(a007*a100);
  a014=(a014-a007);
  a061=(a061*a014);
  a017=(a017-a061);
  a018=(a018*a100);
  a017=(a017+a018);
  a017=(a093*a017);
  a020=(a020+a017);
  a003=(a003+a020);
  if (res[0]!=0) res[0][3]=a003;
  a029=(a001*a029);
  a056=(a005*a056);
  a029=(a029+a056);
  a065=(a051*a065);
  a029=(a029+a065);
  a074=(a057*a074);
  a029=(a029+a074);
  a083=(a066*a083);
  a029=(a029+a083);
  a092=(a075*a092);
  a029=(a029+a092);
  a098=(a084*a098);
  a029=(a029+a098);
  a014=(a093*a014);
  a029=(a029+a014);
  a008=(a008+a029);
  if (res[0]!=0) res[0][4]=a008;
  a001=(a001*a009);
  a005=(a005*a043);
  a001=(a001+a005);
  a051=(a051*a022);
  a001=(a001+a051);
  a057=(a057*a025);
  a001=(a001+a057);
  a066=(a066*a055);
  a001=(a001+a066);
  a075=(a075*a064);
  a001=(a001+a075);
  a084=(a084*a059);
  a001=(a001+a084);
  a093=(a093*a100);
  a001=(a001+a093);
  a032=(a032+a001);
  if (res[0]!=0) res[0][5]=a032;
  return 0;
}

/* plain_steps:(y[6],t,turns[2x12],h,p[9])->(y_end[6]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+105, w1, *w3=w+111, w5, *w6=w+113, w7;
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

/* landing:(y[6],z[5],p[9])->(R[6]) */
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

/* wobbling_residual_12:(u[6],p[9])->(R[6]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* wobbling_search_12:(u0[6],p[9])->(u[6],R[6]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+844, *w2=w+850;
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
  if (sz_w) *sz_w = 856;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 856*sizeof(casadi_real);
  return 0;
}

/* wobbling_jacobian_24:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* scaled_jacobian_24:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+610, *w1=w+646, *w3=w+652, *w4=w+688;
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

/* newton_24:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_24:(i0[6],i1[9])->(o0[6]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+823, *w2=w+829;
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

/* wobbling_residual_24:(u[6],p[9])->(R[6]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* wobbling_search_24:(u0[6],p[9])->(u[6],R[6]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+844, *w2=w+850;
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
  if (sz_w) *sz_w = 856;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 856*sizeof(casadi_real);
  return 0;
}

/* wobbling_jacobian_48:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* scaled_jacobian_48:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+610, *w1=w+646, *w3=w+652, *w4=w+688;
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

/* newton_48:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_48:(i0[6],i1[9])->(o0[6]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+823, *w2=w+829;
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

/* wobbling_residual_48:(u[6],p[9])->(R[6]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* wobbling_search_48:(u0[6],p[9])->(u[6],R[6]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+844, *w2=w+850;
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
  if (sz_w) *sz_w = 856;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 856*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_24:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_24:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_24:(i0[6],i1[9])->(o0[6]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_limit_cycle_24:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_36:(u[6],p[9])->(R[6]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_36:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_36:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_36:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_36:(i0[6],i1[9])->(o0[6]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_36:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_36:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_48:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_48:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_48:(i0[6],i1[9])->(o0[6]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_limit_cycle_48:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_72:(u[6],p[9])->(R[6]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_72:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_72:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_72:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_72:(i0[6],i1[9])->(o0[6]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_72:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_72:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_96:(u[6],p[9])->(R[6]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_96:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_96:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_96:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_96:(i0[6],i1[9])->(o0[6]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_96:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_96:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_144:(u[6],p[9])->(R[6]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_144:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_144:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_144:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_144:(i0[6],i1[9])->(o0[6]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_144:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_144:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_192:(u[6],p[9])->(R[6]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_192:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_192:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_192:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_192:(i0[6],i1[9])->(o0[6]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_192:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_192:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_288:(u[6],p[9])->(R[6]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_288:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_288:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_288:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_288:(i0[6],i1[9])->(o0[6]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_288:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_288:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
  return 0;
}

/* wobbling_residual_384:(u[6],p[9])->(R[6]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+161, *w3=w+166, w4, w5, w6, *w7=w+172;
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

/* coarse_jacobian_384:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+610, *w2=w+616, *w3=w+652;
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

/* scaled_jacobian_384:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+667, *w1=w+703, *w3=w+709, *w4=w+745;
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

/* newton_384:(u0[6],p[9])->(u[6]) */
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

/* scaled_newton_384:(i0[6],i1[9])->(o0[6]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+880, *w2=w+886;
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

/* wobbling_jacobian_384:(u[6],p[9])->(J[6x6],R[6]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+455, *w01=w+461, *w03=w+466, *w04=w+472, *w05=w+502, w06, w07, w08, *w09=w+538, *w10=w+562;
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

/* wobbling_limit_cycle_384:(u0[6],p[9])->(u[6],J[6x6],R[6]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+901, *w2=w+907, *w3=w+913;
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
  if (sz_w) *sz_w = 949;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 949*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 196;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 196*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 598;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 598*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[7],phase[2],turns[2x12],h,p[9])->(y_end[7]) */
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
  casadi_real a108, a109, a110;
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
  a012=arg[4]? arg[4][8] : 0;
  a033=arg[0]? arg[0][5] : 0;
  a034=(a012*a033);
  a032=(a032+a034);
  a034=arg[4]? arg[4][0] : 0;
  a035=arg[0]? arg[0][2] : 0;
  a036=(a034*a035);
  a032=(a032+a036);
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
  a036=5.9175170953613701e-02;
  a036=(a036*a002);
  a037=5.2600151958767730e-02;
  a037=(a037*a002);
  a038=(a037*a030);
  a038=(a008+a038);
  a039=(a007*a038);
  a040=(a037*a008);
  a040=(a010+a040);
  a041=sin(a040);
  a039=(a039*a041);
  a042=(a037*a020);
  a042=(a003+a042);
  a043=(2.*a042);
  a043=(a038-a043);
  a039=(a039*a043);
  a043=(a037*a003);
  a043=(a000+a043);
  a044=sin(a043);
  a045=cos(a040);
  a046=(a044*a045);
  a043=cos(a043);
  a047=(a043*a041);
  a046=(a046-a047);
  a047=(a007*a046);
  a039=(a039-a047);
  a047=(a044*a017);
  a039=(a039+a047);
  a047=(a016-a045);
  a047=(a018*a047);
  a047=(a047+a016);
  a048=(a039/a047);
  a045=(a045-a016);
  a045=(a007*a045);
  a049=(a045/a047);
  a050=casadi_sq(a042);
  a050=(a050*a041);
  a050=(a050+a046);
  a050=(a007*a050);
  a046=arg[2]? arg[2][2] : 0;
  a041=(a024*a046);
  a051=arg[2]? arg[2][3] : 0;
  a052=(a028*a051);
  a041=(a041+a052);
  a041=(a023*a041);
  a041=(a038+a041);
  a041=(a014*a041);
  a046=(a028*a046);
  a051=(a024*a051);
  a046=(a046-a051);
  a046=(a046+a016);
  a046=(a011*a046);
  a046=(a027-a046);
  a046=(a046+a040);
  a046=(a026*a046);
  a041=(a041+a046);
  a050=(a050-a041);
  a041=(a049*a039);
  a050=(a050-a041);
  a041=(a045*a049);
  a041=(a007-a041);
  a046=(a050/a041);
  a043=(a031*a043);
  a047=(a043/a047);
  a045=(a045*a047);
  a041=(a045/a041);
  a039=(a047*a039);
  a040=(a031*a042);
  a040=(a040*a042);
  a040=(a040*a044);
  a044=(a037*a009);
  a044=(a033+a044);
  a051=(a012*a044);
  a040=(a040+a051);
  a037=(a037*a033);
  a037=(a035+a037);
  a037=(a034*a037);
  a040=(a040+a037);
  a039=(a039-a040);
  a050=(a041*a050);
  a039=(a039-a050);
  a043=(a043*a047);
  a043=(a031-a043);
  a045=(a045*a041);
  a043=(a043-a045);
  a039=(a039/a043);
  a041=(a041*a039);
  a046=(a046-a041);
  a049=(a049*a046);
  a048=(a048-a049);
  a047=(a047*a039);
  a048=(a048+a047);
  a048=(a036*a048);
  a032=(a032+a048);
  a032=(a003+a032);
  a048=casadi_sq(a032);
  a047=(a022*a008);
  a038=(a036*a038);
  a047=(a047+a038);
  a047=(a010+a047);
  a038=sin(a047);
  a048=(a048*a038);
  a049=(a022*a003);
  a042=(a036*a042);
  a049=(a049+a042);
  a049=(a000+a049);
  a042=sin(a049);
  a041=cos(a047);
  a043=(a042*a041);
  a049=cos(a049);
  a045=(a049*a038);
  a043=(a043-a045);
  a048=(a048+a043);
  a048=(a007*a048);
  a045=(a022*a030);
  a046=(a036*a046);
  a045=(a045+a046);
  a045=(a008+a045);
  a046=arg[2]? arg[2][4] : 0;
  a050=(a024*a046);
  a040=arg[2]? arg[2][5] : 0;
  a037=(a028*a040);
  a050=(a050+a037);
  a050=(a023*a050);
  a050=(a045+a050);
  a050=(a014*a050);
  a046=(a028*a046);
  a040=(a024*a040);
  a046=(a046-a040);
  a046=(a046+a016);
  a046=(a011*a046);
  a046=(a027-a046);
  a046=(a046+a047);
  a046=(a026*a046);
  a050=(a050+a046);
  a048=(a048-a050);
  a050=(a041-a016);
  a050=(a007*a050);
  a041=(a016-a041);
  a041=(a018*a041);
  a041=(a041+a016);
  a046=(a050/a041);
  a047=(a007*a045);
  a047=(a047*a038);
  a038=(2.*a032);
  a038=(a045-a038);
  a047=(a047*a038);
  a043=(a007*a043);
  a047=(a047-a043);
  a043=(a042*a017);
  a047=(a047+a043);
  a043=(a046*a047);
  a048=(a048-a043);
  a043=(a050*a046);
  a043=(a007-a043);
  a038=(a048/a043);
  a049=(a031*a049);
  a040=(a049/a041);
  a050=(a050*a040);
  a043=(a050/a043);
  a037=(a040*a047);
  a051=(a031*a032);
  a051=(a051*a032);
  a051=(a051*a042);
  a042=(a022*a009);
  a039=(a036*a039);
  a042=(a042+a039);
  a042=(a033+a042);
  a039=(a012*a042);
  a051=(a051+a039);
  a022=(a022*a033);
  a036=(a036*a044);
  a022=(a022+a036);
  a022=(a035+a022);
  a022=(a034*a022);
  a051=(a051+a022);
  a037=(a037-a051);
  a048=(a043*a048);
  a037=(a037-a048);
  a049=(a049*a040);
  a049=(a031-a049);
  a050=(a050*a043);
  a049=(a049-a050);
  a037=(a037/a049);
  a043=(a043*a037);
  a038=(a038-a043);
  a043=(a013*a038);
  a015=(a015+a043);
  a015=(a008+a015);
  a043=(a007*a015);
  a049=(a029*a008);
  a050=(a013*a045);
  a049=(a049+a050);
  a049=(a010+a049);
  a050=sin(a049);
  a043=(a043*a050);
  a048=(a029*a020);
  a047=(a047/a041);
  a046=(a046*a038);
  a047=(a047-a046);
  a040=(a040*a037);
  a047=(a047+a040);
  a040=(a013*a047);
  a048=(a048+a040);
  a048=(a003+a048);
  a040=(2.*a048);
  a040=(a015-a040);
  a043=(a043*a040);
  a040=(a029*a003);
  a046=(a013*a032);
  a040=(a040+a046);
  a040=(a000+a040);
  a046=sin(a040);
  a041=cos(a049);
  a051=(a046*a041);
  a040=cos(a040);
  a022=(a040*a050);
  a051=(a051-a022);
  a022=(a007*a051);
  a043=(a043-a022);
  a022=(a046*a017);
  a043=(a043+a022);
  a022=(a016-a041);
  a022=(a018*a022);
  a022=(a022+a016);
  a036=(a043/a022);
  a041=(a041-a016);
  a041=(a007*a041);
  a044=(a041/a022);
  a039=casadi_sq(a048);
  a039=(a039*a050);
  a039=(a039+a051);
  a039=(a007*a039);
  a051=arg[2]? arg[2][6] : 0;
  a050=(a024*a051);
  a052=arg[2]? arg[2][7] : 0;
  a053=(a028*a052);
  a050=(a050+a053);
  a050=(a023*a050);
  a050=(a015+a050);
  a050=(a014*a050);
  a051=(a028*a051);
  a052=(a024*a052);
  a051=(a051-a052);
  a051=(a051+a016);
  a051=(a011*a051);
  a051=(a027-a051);
  a051=(a051+a049);
  a051=(a026*a051);
  a050=(a050+a051);
  a039=(a039-a050);
  a050=(a044*a043);
  a039=(a039-a050);
  a050=(a041*a044);
  a050=(a007-a050);
  a051=(a039/a050);
  a040=(a031*a040);
  a022=(a040/a022);
  a041=(a041*a022);
  a050=(a041/a050);
  a043=(a022*a043);
  a049=(a031*a048);
  a049=(a049*a048);
  a049=(a049*a046);
  a046=(a029*a009);
  a052=(a013*a037);
  a046=(a046+a052);
  a046=(a033+a046);
  a052=(a012*a046);
  a049=(a049+a052);
  a029=(a029*a033);
  a013=(a013*a042);
  a029=(a029+a013);
  a029=(a035+a029);
  a029=(a034*a029);
  a049=(a049+a029);
  a043=(a043-a049);
  a039=(a050*a039);
  a043=(a043-a039);
  a040=(a040*a022);
  a040=(a031-a040);
  a041=(a041*a050);
  a040=(a040-a041);
  a043=(a043/a040);
  a050=(a050*a043);
  a051=(a051-a050);
  a044=(a044*a051);
  a036=(a036-a044);
  a022=(a022*a043);
  a036=(a036+a022);
  a022=(a021*a036);
  a019=(a019+a022);
  a022=1.2546768756682242e-01;
  a022=(a022*a002);
  a044=2.4136513415926669e-01;
  a044=(a044*a002);
  a050=(a044*a030);
  a040=-8.8454947932828609e-01;
  a040=(a040*a002);
  a038=(a040*a038);
  a050=(a050+a038);
  a038=9.2483400326179199e-01;
  a038=(a038*a002);
  a041=(a038*a051);
  a050=(a050+a041);
  a050=(a008+a050);
  a041=(a007*a050);
  a039=(a044*a008);
  a045=(a040*a045);
  a039=(a039+a045);
  a045=(a038*a015);
  a039=(a039+a045);
  a039=(a010+a039);
  a045=sin(a039);
  a041=(a041*a045);
  a049=(a044*a020);
  a047=(a040*a047);
  a049=(a049+a047);
  a047=(a038*a036);
  a049=(a049+a047);
  a049=(a003+a049);
  a047=(2.*a049);
  a047=(a050-a047);
  a041=(a041*a047);
  a047=(a044*a003);
  a032=(a040*a032);
  a047=(a047+a032);
  a032=(a038*a048);
  a047=(a047+a032);
  a047=(a000+a047);
  a032=sin(a047);
  a029=cos(a039);
  a013=(a032*a029);
  a047=cos(a047);
  a052=(a047*a045);
  a013=(a013-a052);
  a052=(a007*a013);
  a041=(a041-a052);
  a052=(a032*a017);
  a041=(a041+a052);
  a052=(a016-a029);
  a052=(a018*a052);
  a052=(a052+a016);
  a053=(a041/a052);
  a029=(a029-a016);
  a029=(a007*a029);
  a054=(a029/a052);
  a055=casadi_sq(a049);
  a055=(a055*a045);
  a055=(a055+a013);
  a055=(a007*a055);
  a013=arg[2]? arg[2][8] : 0;
  a045=(a024*a013);
  a056=arg[2]? arg[2][9] : 0;
  a057=(a028*a056);
  a045=(a045+a057);
  a045=(a023*a045);
  a045=(a050+a045);
  a045=(a014*a045);
  a013=(a028*a013);
  a056=(a024*a056);
  a013=(a013-a056);
  a013=(a013+a016);
  a013=(a011*a013);
  a013=(a027-a013);
  a013=(a013+a039);
  a013=(a026*a013);
  a045=(a045+a013);
  a055=(a055-a045);
  a045=(a054*a041);
  a055=(a055-a045);
  a045=(a029*a054);
  a045=(a007-a045);
  a013=(a055/a045);
  a047=(a031*a047);
  a052=(a047/a052);
  a029=(a029*a052);
  a045=(a029/a045);
  a041=(a052*a041);
  a039=(a031*a049);
  a039=(a039*a049);
  a039=(a039*a032);
  a032=(a044*a009);
  a037=(a040*a037);
  a032=(a032+a037);
  a037=(a038*a043);
  a032=(a032+a037);
  a032=(a033+a032);
  a037=(a012*a032);
  a039=(a039+a037);
  a044=(a044*a033);
  a040=(a040*a042);
  a044=(a044+a040);
  a038=(a038*a046);
  a044=(a044+a038);
  a044=(a035+a044);
  a044=(a034*a044);
  a039=(a039+a044);
  a041=(a041-a039);
  a055=(a045*a055);
  a041=(a041-a055);
  a047=(a047*a052);
  a047=(a031-a047);
  a029=(a029*a045);
  a047=(a047-a029);
  a041=(a041/a047);
  a045=(a045*a041);
  a013=(a013-a045);
  a054=(a054*a013);
  a053=(a053-a054);
  a052=(a052*a041);
  a053=(a053+a052);
  a052=(a022*a053);
  a019=(a019+a052);
  a019=(a003+a019);
  a052=(a005*a019);
  a004=(a004+a052);
  a052=1.8915178993145003e+00;
  a052=(a052*a002);
  a054=3.7109375000000000e-02;
  a054=(a054*a002);
  a045=(a054*a020);
  a047=1.7025221101954405e-01;
  a047=(a047*a002);
  a029=(a047*a036);
  a045=(a045+a029);
  a029=6.0216538980455959e-02;
  a029=(a029*a002);
  a055=(a029*a053);
  a045=(a045+a055);
  a055=-1.7578125000000000e-02;
  a055=(a055*a002);
  a039=(a006*a030);
  a044=(a021*a051);
  a039=(a039+a044);
  a044=(a022*a013);
  a039=(a039+a044);
  a039=(a008+a039);
  a044=(a007*a039);
  a038=(a006*a008);
  a040=(a021*a015);
  a038=(a038+a040);
  a040=(a022*a050);
  a038=(a038+a040);
  a038=(a010+a038);
  a040=sin(a038);
  a044=(a044*a040);
  a042=(2.*a019);
  a042=(a039-a042);
  a044=(a044*a042);
  a042=(a006*a003);
  a037=(a021*a048);
  a042=(a042+a037);
  a037=(a022*a049);
  a042=(a042+a037);
  a042=(a000+a042);
  a037=sin(a042);
  a056=cos(a038);
  a057=(a037*a056);
  a042=cos(a042);
  a058=(a042*a040);
  a057=(a057-a058);
  a058=(a007*a057);
  a044=(a044-a058);
  a058=(a037*a017);
  a044=(a044+a058);
  a058=(a016-a056);
  a058=(a018*a058);
  a058=(a058+a016);
  a059=(a044/a058);
  a056=(a056-a016);
  a056=(a007*a056);
  a060=(a056/a058);
  a061=casadi_sq(a019);
  a061=(a061*a040);
  a061=(a061+a057);
  a061=(a007*a061);
  a057=arg[2]? arg[2][10] : 0;
  a040=(a024*a057);
  a062=arg[2]? arg[2][11] : 0;
  a063=(a028*a062);
  a040=(a040+a063);
  a040=(a023*a040);
  a040=(a039+a040);
  a040=(a014*a040);
  a057=(a028*a057);
  a062=(a024*a062);
  a057=(a057-a062);
  a057=(a057+a016);
  a057=(a011*a057);
  a057=(a027-a057);
  a057=(a057+a038);
  a057=(a026*a057);
  a040=(a040+a057);
  a061=(a061-a040);
  a057=(a060*a044);
  a061=(a061-a057);
  a057=(a056*a060);
  a057=(a007-a057);
  a038=(a061/a057);
  a042=(a031*a042);
  a058=(a042/a058);
  a056=(a056*a058);
  a057=(a056/a057);
  a044=(a058*a044);
  a062=(a031*a019);
  a062=(a062*a019);
  a062=(a062*a037);
  a037=(a006*a009);
  a063=(a021*a043);
  a037=(a037+a063);
  a063=(a022*a041);
  a037=(a037+a063);
  a037=(a033+a037);
  a063=(a012*a037);
  a062=(a062+a063);
  a006=(a006*a033);
  a021=(a021*a046);
  a006=(a006+a021);
  a022=(a022*a032);
  a006=(a006+a022);
  a006=(a035+a006);
  a006=(a034*a006);
  a062=(a062+a006);
  a044=(a044-a062);
  a061=(a057*a061);
  a044=(a044-a061);
  a042=(a042*a058);
  a042=(a031-a042);
  a056=(a056*a057);
  a042=(a042-a056);
  a044=(a044/a042);
  a057=(a057*a044);
  a038=(a038-a057);
  a060=(a060*a038);
  a059=(a059-a060);
  a058=(a058*a044);
  a059=(a059+a058);
  a058=(a055*a059);
  a045=(a045+a058);
  a045=(a003+a045);
  a058=(a052*a045);
  a004=(a004+a058);
  a058=-5.8012039600105849e+00;
  a058=(a058*a002);
  a060=3.7092000118504789e-02;
  a060=(a060*a002);
  a057=(a060*a020);
  a042=1.7038392571223998e-01;
  a042=(a042*a002);
  a056=(a042*a036);
  a057=(a057+a056);
  a056=1.0726203044637328e-01;
  a056=(a056*a002);
  a061=(a056*a053);
  a057=(a057+a061);
  a061=-1.5319437748624402e-02;
  a061=(a061*a002);
  a062=(a061*a059);
  a057=(a057+a062);
  a062=8.2737891638140233e-03;
  a062=(a062*a002);
  a006=(a054*a030);
  a022=(a047*a051);
  a006=(a006+a022);
  a022=(a029*a013);
  a006=(a006+a022);
  a022=(a055*a038);
  a006=(a006+a022);
  a006=(a008+a006);
  a022=(a007*a006);
  a021=(a054*a008);
  a063=(a047*a015);
  a021=(a021+a063);
  a063=(a029*a050);
  a021=(a021+a063);
  a063=(a055*a039);
  a021=(a021+a063);
  a021=(a010+a021);
  a063=sin(a021);
  a022=(a022*a063);
  a064=(2.*a045);
  a064=(a006-a064);
  a022=(a022*a064);
  a064=(a054*a003);
  a065=(a047*a048);
  a064=(a064+a065);
  a065=(a029*a049);
  a064=(a064+a065);
  a065=(a055*a019);
  a064=(a064+a065);
  a064=(a000+a064);
  a065=sin(a064);
  a066=cos(a021);
  a067=(a065*a066);
  a064=cos(a064);
  a068=(a064*a063);
  a067=(a067-a068);
  a068=(a007*a067);
  a022=(a022-a068);
  a068=(a065*a017);
  a022=(a022+a068);
  a068=(a016-a066);
  a068=(a018*a068);
  a068=(a068+a016);
  a069=(a022/a068);
  a066=(a066-a016);
  a066=(a007*a066);
  a070=(a066/a068);
  a071=casadi_sq(a045);
  a071=(a071*a063);
  a071=(a071+a067);
  a071=(a007*a071);
  a067=arg[2]? arg[2][12] : 0;
  a063=(a024*a067);
  a072=arg[2]? arg[2][13] : 0;
  a073=(a028*a072);
  a063=(a063+a073);
  a063=(a023*a063);
  a063=(a006+a063);
  a063=(a014*a063);
  a067=(a028*a067);
  a072=(a024*a072);
  a067=(a067-a072);
  a067=(a067+a016);
  a067=(a011*a067);
  a067=(a027-a067);
  a067=(a067+a021);
  a067=(a026*a067);
  a063=(a063+a067);
  a071=(a071-a063);
  a067=(a070*a022);
  a071=(a071-a067);
  a067=(a066*a070);
  a067=(a007-a067);
  a021=(a071/a067);
  a064=(a031*a064);
  a068=(a064/a068);
  a066=(a066*a068);
  a067=(a066/a067);
  a022=(a068*a022);
  a072=(a031*a045);
  a072=(a072*a045);
  a072=(a072*a065);
  a065=(a054*a009);
  a073=(a047*a043);
  a065=(a065+a073);
  a073=(a029*a041);
  a065=(a065+a073);
  a073=(a055*a044);
  a065=(a065+a073);
  a065=(a033+a065);
  a073=(a012*a065);
  a072=(a072+a073);
  a054=(a054*a033);
  a047=(a047*a046);
  a054=(a054+a047);
  a029=(a029*a032);
  a054=(a054+a029);
  a055=(a055*a037);
  a054=(a054+a055);
  a054=(a035+a054);
  a054=(a034*a054);
  a072=(a072+a054);
  a022=(a022-a072);
  a071=(a067*a071);
  a022=(a022-a071);
  a064=(a064*a068);
  a064=(a031-a064);
  a066=(a066*a067);
  a064=(a064-a066);
  a022=(a022/a064);
  a067=(a067*a022);
  a021=(a021-a067);
  a070=(a070*a021);
  a069=(a069-a070);
  a068=(a068*a022);
  a069=(a069+a068);
  a068=(a062*a069);
  a057=(a057+a068);
  a057=(a003+a057);
  a068=(a058*a057);
  a004=(a004+a068);
  a068=3.1116436695781990e-01;
  a068=(a068*a002);
  a070=6.2411095871607569e-01;
  a070=(a070*a002);
  a067=(a070*a020);
  a064=-3.3608926294469414e+00;
  a064=(a064*a002);
  a066=(a064*a036);
  a067=(a067+a066);
  a066=-8.6821934684172597e-01;
  a066=(a066*a002);
  a071=(a066*a053);
  a067=(a067+a071);
  a071=2.7592099699446710e+01;
  a071=(a071*a002);
  a072=(a071*a059);
  a067=(a067+a072);
  a072=2.0154067550477894e+01;
  a072=(a072*a002);
  a054=(a072*a069);
  a067=(a067+a054);
  a054=-4.3489884181069961e+01;
  a054=(a054*a002);
  a055=(a060*a030);
  a029=(a042*a051);
  a055=(a055+a029);
  a029=(a056*a013);
  a055=(a055+a029);
  a029=(a061*a038);
  a055=(a055+a029);
  a029=(a062*a021);
  a055=(a055+a029);
  a055=(a008+a055);
  a029=(a007*a055);
  a047=(a060*a008);
  a073=(a042*a015);
  a047=(a047+a073);
  a073=(a056*a050);
  a047=(a047+a073);
  a073=(a061*a039);
  a047=(a047+a073);
  a073=(a062*a006);
  a047=(a047+a073);
  a047=(a010+a047);
  a073=sin(a047);
  a029=(a029*a073);
  a074=(2.*a057);
  a074=(a055-a074);
  a029=(a029*a074);
  a074=(a060*a003);
  a075=(a042*a048);
  a074=(a074+a075);
  a075=(a056*a049);
  a074=(a074+a075);
  a075=(a061*a019);
  a074=(a074+a075);
  a075=(a062*a045);
  a074=(a074+a075);
  a074=(a000+a074);
  a075=sin(a074);
  a076=cos(a047);
  a077=(a075*a076);
  a074=cos(a074);
  a078=(a074*a073);
  a077=(a077-a078);
  a078=(a007*a077);
  a029=(a029-a078);
  a078=(a075*a017);
  a029=(a029+a078);
  a078=(a016-a076);
  a078=(a018*a078);
  a078=(a078+a016);
  a079=(a029/a078);
  a076=(a076-a016);
  a076=(a007*a076);
  a080=(a076/a078);
  a081=casadi_sq(a057);
  a081=(a081*a073);
  a081=(a081+a077);
  a081=(a007*a081);
  a077=arg[2]? arg[2][14] : 0;
  a073=(a024*a077);
  a082=arg[2]? arg[2][15] : 0;
  a083=(a028*a082);
  a073=(a073+a083);
  a073=(a023*a073);
  a073=(a055+a073);
  a073=(a014*a073);
  a077=(a028*a077);
  a082=(a024*a082);
  a077=(a077-a082);
  a077=(a077+a016);
  a077=(a011*a077);
  a077=(a027-a077);
  a077=(a077+a047);
  a077=(a026*a077);
  a073=(a073+a077);
  a081=(a081-a073);
  a077=(a080*a029);
  a081=(a081-a077);
  a077=(a076*a080);
  a077=(a007-a077);
  a047=(a081/a077);
  a074=(a031*a074);
  a078=(a074/a078);
  a076=(a076*a078);
  a077=(a076/a077);
  a029=(a078*a029);
  a082=(a031*a057);
  a082=(a082*a057);
  a082=(a082*a075);
  a075=(a060*a009);
  a083=(a042*a043);
  a075=(a075+a083);
  a083=(a056*a041);
  a075=(a075+a083);
  a083=(a061*a044);
  a075=(a075+a083);
  a083=(a062*a022);
  a075=(a075+a083);
  a075=(a033+a075);
  a083=(a012*a075);
  a082=(a082+a083);
  a060=(a060*a033);
  a042=(a042*a046);
  a060=(a060+a042);
  a056=(a056*a032);
  a060=(a060+a056);
  a061=(a061*a037);
  a060=(a060+a061);
  a062=(a062*a065);
  a060=(a060+a062);
  a060=(a035+a060);
  a060=(a034*a060);
  a082=(a082+a060);
  a029=(a029-a082);
  a081=(a077*a081);
  a029=(a029-a081);
  a074=(a074*a078);
  a074=(a031-a074);
  a076=(a076*a077);
  a074=(a074-a076);
  a029=(a029/a074);
  a077=(a077*a029);
  a047=(a047-a077);
  a080=(a080*a047);
  a079=(a079-a080);
  a078=(a078*a029);
  a079=(a079+a078);
  a078=(a054*a079);
  a067=(a067+a078);
  a067=(a003+a067);
  a078=(a068*a067);
  a004=(a004+a078);
  a078=-1.5216094966251609e-01;
  a078=(a078*a002);
  a080=4.7766253643826434e-01;
  a080=(a080*a002);
  a077=(a080*a020);
  a074=-2.4881146199716677e+00;
  a074=(a074*a002);
  a076=(a074*a036);
  a077=(a077+a076);
  a076=-5.9029082683684297e-01;
  a076=(a076*a002);
  a081=(a076*a053);
  a077=(a077+a081);
  a081=2.1230051448181193e+01;
  a081=(a081*a002);
  a082=(a081*a059);
  a077=(a077+a082);
  a082=1.5279233632882423e+01;
  a082=(a082*a002);
  a060=(a082*a069);
  a077=(a077+a060);
  a060=-3.3288210968984863e+01;
  a060=(a060*a002);
  a062=(a060*a079);
  a077=(a077+a062);
  a062=-2.0331201708508627e-02;
  a062=(a062*a002);
  a061=(a070*a030);
  a056=(a064*a051);
  a061=(a061+a056);
  a056=(a066*a013);
  a061=(a061+a056);
  a056=(a071*a038);
  a061=(a061+a056);
  a056=(a072*a021);
  a061=(a061+a056);
  a056=(a054*a047);
  a061=(a061+a056);
  a061=(a008+a061);
  a056=(a007*a061);
  a042=(a070*a008);
  a083=(a064*a015);
  a042=(a042+a083);
  a083=(a066*a050);
  a042=(a042+a083);
  a083=(a071*a039);
  a042=(a042+a083);
  a083=(a072*a006);
  a042=(a042+a083);
  a083=(a054*a055);
  a042=(a042+a083);
  a042=(a010+a042);
  a083=sin(a042);
  a056=(a056*a083);
  a084=(2.*a067);
  a084=(a061-a084);
  a056=(a056*a084);
  a084=(a070*a003);
  a085=(a064*a048);
  a084=(a084+a085);
  a085=(a066*a049);
  a084=(a084+a085);
  a085=(a071*a019);
  a084=(a084+a085);
  a085=(a072*a045);
  a084=(a084+a085);
  a085=(a054*a057);
  a084=(a084+a085);
  a084=(a000+a084);
  a085=sin(a084);
  a086=cos(a042);
  a087=(a085*a086);
  a084=cos(a084);
  a088=(a084*a083);
  a087=(a087-a088);
  a088=(a007*a087);
  a056=(a056-a088);
  a088=(a085*a017);
  a056=(a056+a088);
  a088=(a016-a086);
  a088=(a018*a088);
  a088=(a088+a016);
  a089=(a056/a088);
  a086=(a086-a016);
  a086=(a007*a086);
  a090=(a086/a088);
  a091=casadi_sq(a067);
  a091=(a091*a083);
  a091=(a091+a087);
  a091=(a007*a091);
  a087=arg[2]? arg[2][16] : 0;
  a083=(a024*a087);
  a092=arg[2]? arg[2][17] : 0;
  a093=(a028*a092);
  a083=(a083+a093);
  a083=(a023*a083);
  a083=(a061+a083);
  a083=(a014*a083);
  a087=(a028*a087);
  a092=(a024*a092);
  a087=(a087-a092);
  a087=(a087+a016);
  a087=(a011*a087);
  a087=(a027-a087);
  a087=(a087+a042);
  a087=(a026*a087);
  a083=(a083+a087);
  a091=(a091-a083);
  a087=(a090*a056);
  a091=(a091-a087);
  a087=(a086*a090);
  a087=(a007-a087);
  a042=(a091/a087);
  a084=(a031*a084);
  a088=(a084/a088);
  a086=(a086*a088);
  a087=(a086/a087);
  a056=(a088*a056);
  a092=(a031*a067);
  a092=(a092*a067);
  a092=(a092*a085);
  a085=(a070*a009);
  a093=(a064*a043);
  a085=(a085+a093);
  a093=(a066*a041);
  a085=(a085+a093);
  a093=(a071*a044);
  a085=(a085+a093);
  a093=(a072*a022);
  a085=(a085+a093);
  a093=(a054*a029);
  a085=(a085+a093);
  a085=(a033+a085);
  a093=(a012*a085);
  a092=(a092+a093);
  a070=(a070*a033);
  a064=(a064*a046);
  a070=(a070+a064);
  a066=(a066*a032);
  a070=(a070+a066);
  a071=(a071*a037);
  a070=(a070+a071);
  a072=(a072*a065);
  a070=(a070+a072);
  a054=(a054*a075);
  a070=(a070+a054);
  a070=(a035+a070);
  a070=(a034*a070);
  a092=(a092+a070);
  a056=(a056-a092);
  a091=(a087*a091);
  a056=(a056-a091);
  a084=(a084*a088);
  a084=(a031-a084);
  a086=(a086*a087);
  a084=(a084-a086);
  a056=(a056/a084);
  a087=(a087*a056);
  a042=(a042-a087);
  a090=(a090*a042);
  a089=(a089-a090);
  a088=(a088*a056);
  a089=(a089+a088);
  a088=(a062*a089);
  a077=(a077+a088);
  a077=(a003+a077);
  a088=(a078*a077);
  a004=(a004+a088);
  a088=2.0136540080403034e-01;
  a088=(a088*a002);
  a090=-9.3714243008598730e-01;
  a090=(a090*a002);
  a087=(a090*a020);
  a084=5.1863724288440638e+00;
  a084=(a084*a002);
  a086=(a084*a036);
  a087=(a087+a086);
  a086=1.0914373489967295e+00;
  a086=(a086*a002);
  a091=(a086*a053);
  a087=(a087+a091);
  a091=-8.1497870107469268e+00;
  a091=(a091*a002);
  a092=(a091*a059);
  a087=(a087+a092);
  a092=-1.8520065659996959e+01;
  a092=(a092*a002);
  a070=(a092*a069);
  a087=(a087+a070);
  a070=2.2739487099350505e+01;
  a070=(a070*a002);
  a054=(a070*a079);
  a087=(a087+a054);
  a054=2.4936055526796523e+00;
  a054=(a054*a002);
  a072=(a054*a089);
  a087=(a087+a072);
  a072=-3.0467644718982196e+00;
  a072=(a072*a002);
  a071=(a080*a030);
  a066=(a074*a051);
  a071=(a071+a066);
  a066=(a076*a013);
  a071=(a071+a066);
  a066=(a081*a038);
  a071=(a071+a066);
  a066=(a082*a021);
  a071=(a071+a066);
  a066=(a060*a047);
  a071=(a071+a066);
  a066=(a062*a042);
  a071=(a071+a066);
  a071=(a008+a071);
  a066=(a007*a071);
  a064=(a080*a008);
  a093=(a074*a015);
  a064=(a064+a093);
  a093=(a076*a050);
  a064=(a064+a093);
  a093=(a081*a039);
  a064=(a064+a093);
  a093=(a082*a006);
  a064=(a064+a093);
  a093=(a060*a055);
  a064=(a064+a093);
  a093=(a062*a061);
  a064=(a064+a093);
  a064=(a010+a064);
  a093=sin(a064);
  a066=(a066*a093);
  a094=(2.*a077);
  a094=(a071-a094);
  a066=(a066*a094);
  a094=(a080*a003);
  a095=(a074*a048);
  a094=(a094+a095);
  a095=(a076*a049);
  a094=(a094+a095);
  a095=(a081*a019);
  a094=(a094+a095);
  a095=(a082*a045);
  a094=(a094+a095);
  a095=(a060*a057);
  a094=(a094+a095);
  a095=(a062*a067);
  a094=(a094+a095);
  a094=(a000+a094);
  a095=sin(a094);
  a096=cos(a064);
  a097=(a095*a096);
  a094=cos(a094);
  a098=(a094*a093);
  a097=(a097-a098);
  a098=(a007*a097);
  a066=(a066-a098);
  a098=(a095*a017);
  a066=(a066+a098);
  a098=(a016-a096);
  a098=(a018*a098);
  a098=(a098+a016);
  a099=(a066/a098);
  a096=(a096-a016);
  a096=(a007*a096);
  a100=(a096/a098);
  a101=casadi_sq(a077);
  a101=(a101*a093);
  a101=(a101+a097);
  a101=(a007*a101);
  a097=arg[2]? arg[2][18] : 0;
  a093=(a024*a097);
  a102=arg[2]? arg[2][19] : 0;
  a103=(a028*a102);
  a093=(a093+a103);
  a093=(a023*a093);
  a093=(a071+a093);
  a093=(a014*a093);
  a097=(a028*a097);
  a102=(a024*a102);
  a097=(a097-a102);
  a097=(a097+a016);
  a097=(a011*a097);
  a097=(a027-a097);
  a097=(a097+a064);
  a097=(a026*a097);
  a093=(a093+a097);
  a101=(a101-a093);
  a097=(a100*a066);
  a101=(a101-a097);
  a097=(a096*a100);
  a097=(a007-a097);
  a064=(a101/a097);
  a094=(a031*a094);
  a098=(a094/a098);
  a096=(a096*a098);
  a097=(a096/a097);
  a066=(a098*a066);
  a102=(a031*a077);
  a102=(a102*a077);
  a102=(a102*a095);
  a095=(a080*a009);
  a103=(a074*a043);
  a095=(a095+a103);
  a103=(a076*a041);
  a095=(a095+a103);
  a103=(a081*a044);
  a095=(a095+a103);
  a103=(a082*a022);
  a095=(a095+a103);
  a103=(a060*a029);
  a095=(a095+a103);
  a103=(a062*a056);
  a095=(a095+a103);
  a095=(a033+a095);
  a103=(a012*a095);
  a102=(a102+a103);
  a080=(a080*a033);
  a074=(a074*a046);
  a080=(a080+a074);
  a076=(a076*a032);
  a080=(a080+a076);
  a081=(a081*a037);
  a080=(a080+a081);
  a082=(a082*a065);
  a080=(a080+a082);
  a060=(a060*a075);
  a080=(a080+a060);
  a062=(a062*a085);
  a080=(a080+a062);
  a080=(a035+a080);
  a080=(a034*a080);
  a102=(a102+a080);
  a066=(a066-a102);
  a101=(a097*a101);
  a066=(a066-a101);
  a094=(a094*a098);
  a094=(a031-a094);
  a096=(a096*a097);
  a094=(a094-a096);
  a066=(a066/a094);
  a097=(a097*a066);
  a064=(a064-a097);
  a100=(a100*a064);
  a099=(a099-a100);
  a098=(a098*a066);
  a099=(a099+a098);
  a098=(a072*a099);
  a087=(a087+a098);
  a087=(a003+a087);
  a098=(a088*a087);
  a004=(a004+a098);
  a098=4.4710615727772587e-02;
  a098=(a098*a002);
  a100=2.2733101475165380e+00;
  a100=(a100*a002);
  a097=(a100*a020);
  a094=-1.0534495466737249e+01;
  a094=(a094*a002);
  a036=(a094*a036);
  a097=(a097+a036);
  a036=-2.0008720582248625e+00;
  a036=(a036*a002);
  a053=(a036*a053);
  a097=(a097+a053);
  a053=-1.7958931863118799e+01;
  a053=(a053*a002);
  a096=(a053*a059);
  a097=(a097+a096);
  a096=2.7948884529419960e+01;
  a096=(a096*a002);
  a101=(a096*a069);
  a097=(a097+a101);
  a101=-2.8589982771350235e+00;
  a101=(a101*a002);
  a102=(a101*a079);
  a097=(a097+a102);
  a102=-8.8728569335306293e+00;
  a102=(a102*a002);
  a080=(a102*a089);
  a097=(a097+a080);
  a080=1.2360567175794303e+01;
  a080=(a080*a002);
  a062=(a080*a099);
  a097=(a097+a062);
  a062=6.4339274601576357e-01;
  a062=(a062*a002);
  a002=(a090*a030);
  a060=(a084*a051);
  a002=(a002+a060);
  a060=(a086*a013);
  a002=(a002+a060);
  a060=(a091*a038);
  a002=(a002+a060);
  a060=(a092*a021);
  a002=(a002+a060);
  a060=(a070*a047);
  a002=(a002+a060);
  a060=(a054*a042);
  a002=(a002+a060);
  a060=(a072*a064);
  a002=(a002+a060);
  a002=(a008+a002);
  a060=(a007*a002);
  a082=(a090*a008);
  a081=(a084*a015);
  a082=(a082+a081);
  a081=(a086*a050);
  a082=(a082+a081);
  a081=(a091*a039);
  a082=(a082+a081);
  a081=(a092*a006);
  a082=(a082+a081);
  a081=(a070*a055);
  a082=(a082+a081);
  a081=(a054*a061);
  a082=(a082+a081);
  a081=(a072*a071);
  a082=(a082+a081);
  a082=(a010+a082);
  a081=sin(a082);
  a060=(a060*a081);
  a076=(2.*a087);
  a076=(a002-a076);
  a060=(a060*a076);
  a076=(a090*a003);
  a074=(a084*a048);
  a076=(a076+a074);
  a074=(a086*a049);
  a076=(a076+a074);
  a074=(a091*a019);
  a076=(a076+a074);
  a074=(a092*a045);
  a076=(a076+a074);
  a074=(a070*a057);
  a076=(a076+a074);
  a074=(a054*a067);
  a076=(a076+a074);
  a074=(a072*a077);
  a076=(a076+a074);
  a076=(a000+a076);
  a074=sin(a076);
  a103=cos(a082);
  a104=(a074*a103);
  a076=cos(a076);
  a105=(a076*a081);
  a104=(a104-a105);
  a105=(a007*a104);
  a060=(a060-a105);
  a105=(a074*a017);
  a060=(a060+a105);
  a105=(a016-a103);
  a105=(a018*a105);
  a105=(a105+a016);
  a106=(a060/a105);
  a103=(a103-a016);
  a103=(a007*a103);
  a107=(a103/a105);
  a108=casadi_sq(a087);
  a108=(a108*a081);
  a108=(a108+a104);
  a108=(a007*a108);
  a104=arg[2]? arg[2][20] : 0;
  a081=(a024*a104);
  a109=arg[2]? arg[2][21] : 0;
  a110=(a028*a109);
  a081=(a081+a110);
  a081=(a023*a081);
  a081=(a002+a081);
  a081=(a014*a081);
  a104=(a028*a104);
  a109=(a024*a109);
  a104=(a104-a109);
  a104=(a104+a016);
  a104=(a011*a104);
  a104=(a027-a104);
  a104=(a104+a082);
  a104=(a026*a104);
  a081=(a081+a104);
  a108=(a108-a081);
  a104=(a107*a060);
  a108=(a108-a104);
  a104=(a103*a107);
  a104=(a007-a104);
  a082=(a108/a104);
  a076=(a031*a076);
  a105=(a076/a105);
  a103=(a103*a105);
  a104=(a103/a104);
  a060=(a105*a060);
  a109=(a031*a087);
  a109=(a109*a087);
  a109=(a109*a074);
  a074=(a090*a009);
  a110=(a084*a043);
  a074=(a074+a110);
  a110=(a086*a041);
  a074=(a074+a110);
  a110=(a091*a044);
  a074=(a074+a110);
  a110=(a092*a022);
  a074=(a074+a110);
  a110=(a070*a029);
  a074=(a074+a110);
  a110=(a054*a056);
  a074=(a074+a110);
  a110=(a072*a066);
  a074=(a074+a110);
  a074=(a033+a074);
  a110=(a012*a074);
  a109=(a109+a110);
  a090=(a090*a033);
  a084=(a084*a046);
  a090=(a090+a084);
  a086=(a086*a032);
  a090=(a090+a086);
  a091=(a091*a037);
  a090=(a090+a091);
  a092=(a092*a065);
  a090=(a090+a092);
  a070=(a070*a075);
  a090=(a090+a070);
  a054=(a054*a085);
  a090=(a090+a054);
  a072=(a072*a095);
  a090=(a090+a072);
  a090=(a035+a090);
  a090=(a034*a090);
  a109=(a109+a090);
  a060=(a060-a109);
  a108=(a104*a108);
  a060=(a060-a108);
  a076=(a076*a105);
  a076=(a031-a076);
  a103=(a103*a104);
  a076=(a076-a103);
  a060=(a060/a076);
  a104=(a104*a060);
  a082=(a082-a104);
  a107=(a107*a082);
  a106=(a106-a107);
  a105=(a105*a060);
  a106=(a106+a105);
  a105=(a062*a106);
  a097=(a097+a105);
  a097=(a003+a097);
  a105=(a098*a097);
  a004=(a004+a105);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a105=(a005*a039);
  a004=(a004+a105);
  a105=(a052*a006);
  a004=(a004+a105);
  a105=(a058*a055);
  a004=(a004+a105);
  a105=(a068*a061);
  a004=(a004+a105);
  a105=(a078*a071);
  a004=(a004+a105);
  a105=(a088*a002);
  a004=(a004+a105);
  a105=(a100*a030);
  a051=(a094*a051);
  a105=(a105+a051);
  a013=(a036*a013);
  a105=(a105+a013);
  a013=(a053*a038);
  a105=(a105+a013);
  a013=(a096*a021);
  a105=(a105+a013);
  a013=(a101*a047);
  a105=(a105+a013);
  a013=(a102*a042);
  a105=(a105+a013);
  a013=(a080*a064);
  a105=(a105+a013);
  a013=(a062*a082);
  a105=(a105+a013);
  a105=(a008+a105);
  a013=(a098*a105);
  a004=(a004+a013);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a033);
  a013=(a005*a037);
  a004=(a004+a013);
  a013=(a052*a065);
  a004=(a004+a013);
  a013=(a058*a075);
  a004=(a004+a013);
  a013=(a068*a085);
  a004=(a004+a013);
  a013=(a078*a095);
  a004=(a004+a013);
  a013=(a088*a074);
  a004=(a004+a013);
  a013=(a100*a009);
  a043=(a094*a043);
  a013=(a013+a043);
  a041=(a036*a041);
  a013=(a013+a041);
  a041=(a053*a044);
  a013=(a013+a041);
  a041=(a096*a022);
  a013=(a013+a041);
  a041=(a101*a029);
  a013=(a013+a041);
  a041=(a102*a056);
  a013=(a013+a041);
  a041=(a080*a066);
  a013=(a013+a041);
  a041=(a062*a060);
  a013=(a013+a041);
  a013=(a033+a013);
  a041=(a098*a013);
  a004=(a004+a041);
  a004=(a035+a004);
  if (res[0]!=0) res[0][2]=a004;
  a020=(a001*a020);
  a059=(a005*a059);
  a020=(a020+a059);
  a069=(a052*a069);
  a020=(a020+a069);
  a079=(a058*a079);
  a020=(a020+a079);
  a089=(a068*a089);
  a020=(a020+a089);
  a099=(a078*a099);
  a020=(a020+a099);
  a106=(a088*a106);
  a020=(a020+a106);
  a106=(a007*a105);
  a099=(a100*a008);
  a015=(a094*a015);
  a099=(a099+a015);
  a050=(a036*a050);
  a099=(a099+a050);
  a050=(a053*a039);
  a099=(a099+a050);
  a050=(a096*a006);
  a099=(a099+a050);
  a050=(a101*a055);
  a099=(a099+a050);
  a050=(a102*a061);
  a099=(a099+a050);
  a050=(a080*a071);
  a099=(a099+a050);
  a050=(a062*a002);
  a099=(a099+a050);
  a010=(a010+a099);
  a099=sin(a010);
  a106=(a106*a099);
  a050=(2.*a097);
  a050=(a105-a050);
  a106=(a106*a050);
  a050=(a100*a003);
  a048=(a094*a048);
  a050=(a050+a048);
  a049=(a036*a049);
  a050=(a050+a049);
  a019=(a053*a019);
  a050=(a050+a019);
  a045=(a096*a045);
  a050=(a050+a045);
  a057=(a101*a057);
  a050=(a050+a057);
  a067=(a102*a067);
  a050=(a050+a067);
  a077=(a080*a077);
  a050=(a050+a077);
  a087=(a062*a087);
  a050=(a050+a087);
  a000=(a000+a050);
  a050=sin(a000);
  a087=cos(a010);
  a077=(a050*a087);
  a000=cos(a000);
  a067=(a000*a099);
  a077=(a077-a067);
  a067=(a007*a077);
  a106=(a106-a067);
  a017=(a050*a017);
  a106=(a106+a017);
  a017=(a016-a087);
  a018=(a018*a017);
  a018=(a018+a016);
  a017=(a106/a018);
  a087=(a087-a016);
  a087=(a007*a087);
  a067=(a087/a018);
  a057=casadi_sq(a097);
  a057=(a057*a099);
  a057=(a057+a077);
  a057=(a007*a057);
  a077=arg[2]? arg[2][22] : 0;
  a099=(a024*a077);
  a045=arg[2]? arg[2][23] : 0;
  a019=(a028*a045);
  a099=(a099+a019);
  a023=(a023*a099);
  a023=(a105+a023);
  a014=(a014*a023);
  a028=(a028*a077);
  a024=(a024*a045);
  a028=(a028-a024);
  a028=(a028+a016);
  a011=(a011*a028);
  a027=(a027-a011);
  a027=(a027+a010);
  a026=(a026*a027);
  a014=(a014+a026);
  a057=(a057-a014);
  a026=(a067*a106);
  a057=(a057-a026);
  a026=(a087*a067);
  a007=(a007-a026);
  a026=(a057/a007);
  a000=(a031*a000);
  a018=(a000/a018);
  a087=(a087*a018);
  a007=(a087/a007);
  a106=(a018*a106);
  a027=(a031*a097);
  a027=(a027*a097);
  a027=(a027*a050);
  a012=(a012*a013);
  a027=(a027+a012);
  a100=(a100*a033);
  a094=(a094*a046);
  a100=(a100+a094);
  a036=(a036*a032);
  a100=(a100+a036);
  a053=(a053*a037);
  a100=(a100+a053);
  a096=(a096*a065);
  a100=(a100+a096);
  a101=(a101*a075);
  a100=(a100+a101);
  a102=(a102*a085);
  a100=(a100+a102);
  a080=(a080*a095);
  a100=(a100+a080);
  a062=(a062*a074);
  a100=(a100+a062);
  a035=(a035+a100);
  a034=(a034*a035);
  a027=(a027+a034);
  a106=(a106-a027);
  a057=(a007*a057);
  a106=(a106-a057);
  a000=(a000*a018);
  a031=(a031-a000);
  a087=(a087*a007);
  a031=(a031-a087);
  a106=(a106/a031);
  a007=(a007*a106);
  a026=(a026-a007);
  a067=(a067*a026);
  a017=(a017-a067);
  a018=(a018*a106);
  a017=(a017+a018);
  a017=(a098*a017);
  a020=(a020+a017);
  a003=(a003+a020);
  if (res[0]!=0) res[0][3]=a003;
  a030=(a001*a030);
  a038=(a005*a038);
  a030=(a030+a038);
  a021=(a052*a021);
  a030=(a030+a021);
  a047=(a058*a047);
  a030=(a030+a047);
  a042=(a068*a042);
  a030=(a030+a042);
  a064=(a078*a064);
  a030=(a030+a064);
  a082=(a088*a082);
  a030=(a030+a082);
  a026=(a098*a026);
  a030=(a030+a026);
  a030=(a008+a030);
  if (res[0]!=0) res[0][4]=a030;
  a009=(a001*a009);
  a044=(a005*a044);
  a009=(a009+a044);
  a022=(a052*a022);
  a009=(a009+a022);
  a029=(a058*a029);
  a009=(a009+a029);
  a056=(a068*a056);
  a009=(a009+a056);
  a066=(a078*a066);
  a009=(a009+a066);
  a060=(a088*a060);
  a009=(a009+a060);
  a106=(a098*a106);
  a009=(a009+a106);
  a033=(a033+a009);
  if (res[0]!=0) res[0][5]=a033;
  a033=arg[0]? arg[0][6] : 0;
  a025=(a025*a008);
  a001=(a001*a025);
  a040=(a040*a039);
  a005=(a005*a040);
  a001=(a001+a005);
  a063=(a063*a006);
  a052=(a052*a063);
  a001=(a001+a052);
  a073=(a073*a055);
  a058=(a058*a073);
  a001=(a001+a058);
  a083=(a083*a061);
  a068=(a068*a083);
  a001=(a001+a068);
  a093=(a093*a071);
  a078=(a078*a093);
  a001=(a001+a078);
  a081=(a081*a002);
  a088=(a088*a081);
  a001=(a001+a088);
  a014=(a014*a105);
  a098=(a098*a014);
  a001=(a001+a098);
  a033=(a033-a001);
  if (res[0]!=0) res[0][6]=a033;
  return 0;
}

/* observe:(t,y[6],p[9])->(g[10],dg[10]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68;
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
  a34=arg[2]? arg[2][8] : 0;
  a35=arg[1]? arg[1][5] : 0;
  a36=(a34*a35);
  a33=(a33+a36);
  a36=arg[2]? arg[2][0] : 0;
  a37=(a36*a01);
  a33=(a33+a37);
  a30=(a30-a33);
  a33=(a16-a10);
  a33=(a03*a33);
  a37=(a33*a18);
  a38=(a33/a17);
  a39=(a33*a38);
  a39=(a03-a39);
  a40=(a37/a39);
  a41=casadi_sq(a23);
  a42=(a41*a21);
  a42=(a42+a07);
  a42=(a03*a42);
  a43=arg[2]? arg[2][5] : 0;
  a44=arg[2]? arg[2][7] : 0;
  a45=arg[2]? arg[2][2] : 0;
  a46=(a44*a45);
  a47=arg[0]? arg[0][0] : 0;
  a47=(a45*a47);
  a48=sin(a47);
  a49=(a46*a48);
  a49=(a19+a49);
  a49=(a43*a49);
  a50=arg[2]? arg[2][4] : 0;
  a51=arg[2]? arg[2][6] : 0;
  a47=cos(a47);
  a52=(a47+a10);
  a52=(a44*a52);
  a51=(a51-a52);
  a51=(a51+a05);
  a51=(a50*a51);
  a49=(a49+a51);
  a42=(a42-a49);
  a51=(a38*a26);
  a42=(a42-a51);
  a51=(a40*a42);
  a30=(a30-a51);
  a51=(a15*a18);
  a51=(a00-a51);
  a52=(a37*a40);
  a51=(a51-a52);
  a30=(a30/a51);
  a52=(a30*a00);
  a53=(a26/a17);
  a54=(a42/a39);
  a55=(a40*a30);
  a55=(a54-a55);
  a56=(a38*a55);
  a56=(a53-a56);
  a57=(a18*a30);
  a56=(a56+a57);
  a57=(a12*a28);
  a58=(a56*a57);
  a52=(a52-a58);
  a58=(a03*a06);
  a59=(a56-a55);
  a60=(a58*a59);
  a52=(a52+a60);
  a60=(a24*a19);
  a60=(a41-a60);
  a61=casadi_sq(a19);
  a60=(a60+a61);
  a61=(a27*a60);
  a52=(a52-a61);
  a61=(a41*a29);
  a52=(a52+a61);
  a61=(a14*a52);
  a62=(a58*a60);
  a63=(a56*a29);
  a62=(a62-a63);
  a63=(a27*a59);
  a62=(a62+a63);
  a63=(a41*a57);
  a64=(a62-a63);
  a64=(a64+a11);
  a61=(a61/a64);
  a02=(a02-a61);
  a02=(-a02);
  if (res[0]!=0) res[0][0]=a02;
  a02=0.;
  if (res[0]!=0) res[0][1]=a02;
  a62=(a62+a09);
  a62=(a62-a63);
  a62=(a62+a10);
  if (res[0]!=0) res[0][2]=a62;
  a10=(a52/a62);
  if (res[0]!=0) res[0][3]=a10;
  if (res[0]!=0) res[0][4]=a13;
  if (res[0]!=0) res[0][5]=a56;
  a04=(2.*a04);
  a05=(a05-a04);
  if (res[0]!=0) res[0][6]=a05;
  if (res[0]!=0) res[0][7]=a01;
  a01=(a49*a19);
  a01=(-a01);
  if (res[0]!=0) res[0][8]=a01;
  a01=(-a49);
  if (res[0]!=0) res[0][9]=a01;
  a01=(a00*a35);
  a05=(a23-a19);
  a06=(a06*a05);
  a12=(a12*a23);
  a04=(a06-a12);
  a04=(a03*a04);
  a01=(a01+a04);
  a01=(a01-a12);
  a01=(a01/a11);
  a07=(a07*a05);
  a05=(a08*a23);
  a04=(a07-a05);
  a13=(a03*a04);
  a13=(a13-a05);
  a13=(a13/a11);
  a52=(a52*a13);
  a13=(a03*a55);
  a13=(a21*a13);
  a16=(a16*a19);
  a20=(a20*a16);
  a13=(a13+a20);
  a13=(a25*a13);
  a20=(2.*a56);
  a11=(a55-a20);
  a22=(a22*a11);
  a13=(a13+a22);
  a22=(a03*a06);
  a13=(a13-a22);
  a11=(a28*a12);
  a13=(a13+a11);
  a63=(a18*a13);
  a65=(a00*a05);
  a66=(a65/a17);
  a67=(a18/a17);
  a68=(a21*a19);
  a09=(a09*a68);
  a67=(a67*a09);
  a66=(a66+a67);
  a67=(a26*a66);
  a63=(a63-a67);
  a67=(a00*a56);
  a23=(a23*a67);
  a31=(a31*a56);
  a23=(a23+a31);
  a08=(a08*a23);
  a32=(a32*a12);
  a08=(a08+a32);
  a34=(a34*a30);
  a08=(a08+a34);
  a36=(a36*a35);
  a08=(a08+a36);
  a63=(a63-a08);
  a08=(a24*a56);
  a21=(a21*a08);
  a16=(a41*a16);
  a21=(a21+a16);
  a21=(a21+a06);
  a21=(a03*a21);
  a47=(a47*a45);
  a46=(a46*a47);
  a46=(a55+a46);
  a43=(a43*a46);
  a48=(a48*a45);
  a44=(a44*a48);
  a44=(a44+a19);
  a50=(a50*a44);
  a43=(a43+a50);
  a21=(a21-a43);
  a50=(a38*a13);
  a68=(a03*a68);
  a44=(a68/a17);
  a48=(a38/a17);
  a48=(a48*a09);
  a44=(a44+a48);
  a26=(a26*a44);
  a50=(a50-a26);
  a21=(a21-a50);
  a50=(a40*a21);
  a26=(a18*a68);
  a48=(a33*a66);
  a26=(a26+a48);
  a48=(a26/a39);
  a45=(a40/a39);
  a68=(a38*a68);
  a33=(a33*a44);
  a68=(a68+a33);
  a45=(a45*a68);
  a48=(a48+a45);
  a42=(a42*a48);
  a50=(a50-a42);
  a63=(a63-a50);
  a63=(a63/a51);
  a51=(a30/a51);
  a65=(a18*a65);
  a15=(a15*a66);
  a65=(a65+a15);
  a26=(a40*a26);
  a37=(a37*a48);
  a26=(a26+a37);
  a65=(a65+a26);
  a51=(a51*a65);
  a63=(a63-a51);
  a00=(a00*a63);
  a13=(a13/a17);
  a53=(a53/a17);
  a53=(a53*a09);
  a13=(a13-a53);
  a21=(a21/a39);
  a54=(a54/a39);
  a54=(a54*a68);
  a21=(a21-a54);
  a40=(a40*a63);
  a48=(a30*a48);
  a40=(a40-a48);
  a21=(a21-a40);
  a38=(a38*a21);
  a44=(a55*a44);
  a38=(a38-a44);
  a13=(a13-a38);
  a18=(a18*a63);
  a30=(a30*a66);
  a18=(a18-a30);
  a13=(a13+a18);
  a18=(a57*a13);
  a28=(a28*a05);
  a05=(a56*a28);
  a18=(a18-a05);
  a00=(a00-a18);
  a21=(a13-a21);
  a18=(a58*a21);
  a03=(a03*a07);
  a07=(a59*a03);
  a18=(a18-a07);
  a00=(a00+a18);
  a18=(a60*a22);
  a20=(a19*a20);
  a24=(a24*a55);
  a20=(a20+a24);
  a20=(a08-a20);
  a24=(2.*a19);
  a24=(a24*a55);
  a20=(a20+a24);
  a24=(a27*a20);
  a18=(a18+a24);
  a00=(a00-a18);
  a18=(a29*a08);
  a24=(a41*a11);
  a18=(a18+a24);
  a00=(a00+a18);
  a14=(a14*a00);
  a52=(a52+a14);
  a52=(a52/a64);
  a61=(a61/a64);
  a58=(a58*a20);
  a60=(a60*a03);
  a58=(a58-a60);
  a29=(a29*a13);
  a56=(a56*a11);
  a29=(a29+a56);
  a58=(a58-a29);
  a59=(a59*a22);
  a27=(a27*a21);
  a59=(a59+a27);
  a58=(a58+a59);
  a57=(a57*a08);
  a41=(a41*a28);
  a57=(a57-a41);
  a58=(a58-a57);
  a61=(a61*a58);
  a52=(a52-a61);
  a01=(a01-a52);
  a01=(-a01);
  if (res[1]!=0) res[1][0]=a01;
  if (res[1]!=0) res[1][1]=a02;
  if (res[1]!=0) res[1][2]=a58;
  a00=(a00/a62);
  a10=(a10/a62);
  a10=(a10*a58);
  a00=(a00-a10);
  if (res[1]!=0) res[1][3]=a00;
  if (res[1]!=0) res[1][4]=a04;
  if (res[1]!=0) res[1][5]=a13;
  if (res[1]!=0) res[1][6]=a25;
  if (res[1]!=0) res[1][7]=a35;
  a19=(a19*a43);
  a49=(a49*a55);
  a19=(a19+a49);
  a19=(-a19);
  if (res[1]!=0) res[1][8]=a19;
  a43=(-a43);
  if (res[1]!=0) res[1][9]=a43;
  return 0;
}

/* working_steps:(t,turns[2x12],w[7],h,p[9])->(w_end[7],nodes[7x12],g[10x12],dg[10x12]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, *w00=w+111, w01, *w03=w+118, w05, *w06=w+120, w07, *w08=w+127, *w09=w+134, *w10=w+141, *w11=w+148;
  casadi_real *w12=w+155, *w13=w+162, *w14=w+169, *w15=w+176, *w16=w+183, *w17=w+190, *w18=w+197, *w19=w+204, *w20=w+210, *w21=w+220, *w22=w+230, *w23=w+240;
  casadi_real *w24=w+250, *w25=w+260, *w26=w+270, *w27=w+280, *w28=w+290, *w29=w+300, *w30=w+310, *w31=w+320, *w32=w+330;
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

/* wobbling_trace_48:(u[6],p[9])->(w[7x49],g[10x49],dg[10x49],R[6]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1479, *w21=w+1489;
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
  if (sz_w) *sz_w = 1495;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1495*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_72:(u[6],p[9])->(w[7x73],g[10x73],dg[10x73],R[6]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1589, *w21=w+1709, *w22=w+1829;
  casadi_real *w23=w+1949, *w24=w+1959, *w25=w+1969;
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
  if (sz_w) *sz_w = 1975;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1975*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_96:(u[6],p[9])->(w[7x97],g[10x97],dg[10x97],R[6]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1589, *w21=w+1709, *w22=w+1829;
  casadi_real *w23=w+1949, *w24=w+2069, *w25=w+2189, *w26=w+2309, *w27=w+2429, *w28=w+2439, *w29=w+2449;
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
  if (sz_w) *sz_w = 2455;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2455*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_144:(u[6],p[9])->(w[7x145],g[10x145],dg[10x145],R[6]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1589, *w21=w+1709, *w22=w+1829;
  casadi_real *w23=w+1949, *w24=w+2069, *w25=w+2189, *w26=w+2309, *w27=w+2429, *w28=w+2549, *w29=w+2669, *w30=w+2789, *w31=w+2909, *w32=w+3029, *w33=w+3149, *w34=w+3269;
  casadi_real *w35=w+3389, *w36=w+3399, *w37=w+3409;
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
  if (sz_w) *sz_w = 3415;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3415*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_192:(u[6],p[9])->(w[7x193],g[10x193],dg[10x193],R[6]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1589, *w21=w+1709, *w22=w+1829;
  casadi_real *w23=w+1949, *w24=w+2069, *w25=w+2189, *w26=w+2309, *w27=w+2429, *w28=w+2549, *w29=w+2669, *w30=w+2789, *w31=w+2909, *w32=w+3029, *w33=w+3149, *w34=w+3269;
  casadi_real *w35=w+3389, *w36=w+3509, *w37=w+3629, *w38=w+3749, *w39=w+3869, *w40=w+3989, *w41=w+4109, *w42=w+4229, *w43=w+4349, *w44=w+4359, *w45=w+4369;
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
  if (sz_w) *sz_w = 4375;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4375*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_288:(u[6],p[9])->(w[7x289],g[10x289],dg[10x289],R[6]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1589, *w21=w+1709, *w22=w+1829;
  casadi_real *w23=w+1949, *w24=w+2069, *w25=w+2189, *w26=w+2309, *w27=w+2429, *w28=w+2549, *w29=w+2669, *w30=w+2789, *w31=w+2909, *w32=w+3029, *w33=w+3149, *w34=w+3269;
  casadi_real *w35=w+3389, *w36=w+3509, *w37=w+3629, *w38=w+3749, *w39=w+3869, *w40=w+3989, *w41=w+4109, *w42=w+4229, *w43=w+4349, *w44=w+4469, *w45=w+4589, *w46=w+4709;
  casadi_real *w47=w+4829, *w48=w+4949, *w49=w+5069, *w50=w+5189, *w51=w+5309, *w52=w+5429, *w53=w+5549, *w54=w+5669, *w55=w+5789, *w56=w+5909, *w57=w+6029, *w58=w+6149;
  casadi_real *w59=w+6269, *w60=w+6279, *w61=w+6289;
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
  if (sz_w) *sz_w = 6295;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6295*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_384:(u[6],p[9])->(w[7x385],g[10x385],dg[10x385],R[6]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+376, w02, w03, *w05=w+382, *w06=w+406, w07, *w08=w+411, *w09=w+418, *w10=w+425;
  casadi_real *w11=w+509, *w12=w+629, *w13=w+749, *w14=w+869, *w15=w+989, *w16=w+1109, *w17=w+1229, *w18=w+1349, *w19=w+1469, *w20=w+1589, *w21=w+1709, *w22=w+1829;
  casadi_real *w23=w+1949, *w24=w+2069, *w25=w+2189, *w26=w+2309, *w27=w+2429, *w28=w+2549, *w29=w+2669, *w30=w+2789, *w31=w+2909, *w32=w+3029, *w33=w+3149, *w34=w+3269;
  casadi_real *w35=w+3389, *w36=w+3509, *w37=w+3629, *w38=w+3749, *w39=w+3869, *w40=w+3989, *w41=w+4109, *w42=w+4229, *w43=w+4349, *w44=w+4469, *w45=w+4589, *w46=w+4709;
  casadi_real *w47=w+4829, *w48=w+4949, *w49=w+5069, *w50=w+5189, *w51=w+5309, *w52=w+5429, *w53=w+5549, *w54=w+5669, *w55=w+5789, *w56=w+5909, *w57=w+6029, *w58=w+6149;
  casadi_real *w59=w+6269, *w60=w+6389, *w61=w+6509, *w62=w+6629, *w63=w+6749, *w64=w+6869, *w65=w+6989, *w66=w+7109, *w67=w+7229, *w68=w+7349, *w69=w+7469, *w70=w+7589;
  casadi_real *w71=w+7709, *w72=w+7829, *w73=w+7949, *w74=w+8069, *w75=w+8189, *w76=w+8199, *w77=w+8209;
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
  if (sz_w) *sz_w = 8215;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8215*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_576:(u[6],p[9])->(w[7x577],g[10x577],dg[10x577],R[6]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+376, w002, w003, *w005=w+382, *w006=w+406, w007, *w008=w+411, *w009=w+418, *w010=w+425;
  casadi_real *w011=w+509, *w012=w+629, *w013=w+749, *w014=w+869, *w015=w+989, *w016=w+1109, *w017=w+1229, *w018=w+1349, *w019=w+1469, *w020=w+1589, *w021=w+1709, *w022=w+1829;
  casadi_real *w023=w+1949, *w024=w+2069, *w025=w+2189, *w026=w+2309, *w027=w+2429, *w028=w+2549, *w029=w+2669, *w030=w+2789, *w031=w+2909, *w032=w+3029, *w033=w+3149, *w034=w+3269;
  casadi_real *w035=w+3389, *w036=w+3509, *w037=w+3629, *w038=w+3749, *w039=w+3869, *w040=w+3989, *w041=w+4109, *w042=w+4229, *w043=w+4349, *w044=w+4469, *w045=w+4589, *w046=w+4709;
  casadi_real *w047=w+4829, *w048=w+4949, *w049=w+5069, *w050=w+5189, *w051=w+5309, *w052=w+5429, *w053=w+5549, *w054=w+5669, *w055=w+5789, *w056=w+5909, *w057=w+6029, *w058=w+6149;
  casadi_real *w059=w+6269, *w060=w+6389, *w061=w+6509, *w062=w+6629, *w063=w+6749, *w064=w+6869, *w065=w+6989, *w066=w+7109, *w067=w+7229, *w068=w+7349, *w069=w+7469, *w070=w+7589;
  casadi_real *w071=w+7709, *w072=w+7829, *w073=w+7949, *w074=w+8069, *w075=w+8189, *w076=w+8309, *w077=w+8429, *w078=w+8549, *w079=w+8669, *w080=w+8789, *w081=w+8909, *w082=w+9029;
  casadi_real *w083=w+9149, *w084=w+9269, *w085=w+9389, *w086=w+9509, *w087=w+9629, *w088=w+9749, *w089=w+9869, *w090=w+9989, *w091=w+10109, *w092=w+10229, *w093=w+10349, *w094=w+10469;
  casadi_real *w095=w+10589, *w096=w+10709, *w097=w+10829, *w098=w+10949, *w099=w+11069, *w100=w+11189, *w101=w+11309, *w102=w+11429, *w103=w+11549, *w104=w+11669, *w105=w+11789, *w106=w+11909;
  casadi_real *w107=w+12029, *w108=w+12039, *w109=w+12049;
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
  if (sz_w) *sz_w = 12055;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12055*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_768:(u[6],p[9])->(w[7x769],g[10x769],dg[10x769],R[6]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+376, w002, w003, *w005=w+382, *w006=w+406, w007, *w008=w+411, *w009=w+418, *w010=w+425;
  casadi_real *w011=w+509, *w012=w+629, *w013=w+749, *w014=w+869, *w015=w+989, *w016=w+1109, *w017=w+1229, *w018=w+1349, *w019=w+1469, *w020=w+1589, *w021=w+1709, *w022=w+1829;
  casadi_real *w023=w+1949, *w024=w+2069, *w025=w+2189, *w026=w+2309, *w027=w+2429, *w028=w+2549, *w029=w+2669, *w030=w+2789, *w031=w+2909, *w032=w+3029, *w033=w+3149, *w034=w+3269;
  casadi_real *w035=w+3389, *w036=w+3509, *w037=w+3629, *w038=w+3749, *w039=w+3869, *w040=w+3989, *w041=w+4109, *w042=w+4229, *w043=w+4349, *w044=w+4469, *w045=w+4589, *w046=w+4709;
  casadi_real *w047=w+4829, *w048=w+4949, *w049=w+5069, *w050=w+5189, *w051=w+5309, *w052=w+5429, *w053=w+5549, *w054=w+5669, *w055=w+5789, *w056=w+5909, *w057=w+6029, *w058=w+6149;
  casadi_real *w059=w+6269, *w060=w+6389, *w061=w+6509, *w062=w+6629, *w063=w+6749, *w064=w+6869, *w065=w+6989, *w066=w+7109, *w067=w+7229, *w068=w+7349, *w069=w+7469, *w070=w+7589;
  casadi_real *w071=w+7709, *w072=w+7829, *w073=w+7949, *w074=w+8069, *w075=w+8189, *w076=w+8309, *w077=w+8429, *w078=w+8549, *w079=w+8669, *w080=w+8789, *w081=w+8909, *w082=w+9029;
  casadi_real *w083=w+9149, *w084=w+9269, *w085=w+9389, *w086=w+9509, *w087=w+9629, *w088=w+9749, *w089=w+9869, *w090=w+9989, *w091=w+10109, *w092=w+10229, *w093=w+10349, *w094=w+10469;
  casadi_real *w095=w+10589, *w096=w+10709, *w097=w+10829, *w098=w+10949, *w099=w+11069, *w100=w+11189, *w101=w+11309, *w102=w+11429, *w103=w+11549, *w104=w+11669, *w105=w+11789, *w106=w+11909;
  casadi_real *w107=w+12029, *w108=w+12149, *w109=w+12269, *w110=w+12389, *w111=w+12509, *w112=w+12629, *w113=w+12749, *w114=w+12869, *w115=w+12989, *w116=w+13109, *w117=w+13229, *w118=w+13349;
  casadi_real *w119=w+13469, *w120=w+13589, *w121=w+13709, *w122=w+13829, *w123=w+13949, *w124=w+14069, *w125=w+14189, *w126=w+14309, *w127=w+14429, *w128=w+14549, *w129=w+14669, *w130=w+14789;
  casadi_real *w131=w+14909, *w132=w+15029, *w133=w+15149, *w134=w+15269, *w135=w+15389, *w136=w+15509, *w137=w+15629, *w138=w+15749, *w139=w+15869, *w140=w+15879, *w141=w+15889;
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
  if (sz_w) *sz_w = 15895;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 15895*sizeof(casadi_real);
  return 0;
}

/* wobbling_advance:(t,w[7],h,p[9])->(w_end[7],g[10],dg[10]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w0=w+111, w1, *w3=w+118, w4, *w5=w+120, *w6=w+144, *w7=w+151, *w8=w+157, *w9=w+167;
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
  if (sz_w) *sz_w = 177;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 177*sizeof(casadi_real);
  return 0;
}

/* wobbling_begin:(u[6],p[9])->(y[6x6]) */
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

/* wobbling_swing:(t,h,y[6x6],p[9])->(y_end[6x6]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w4=w+455, *w5=w+479;
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
  if (sz_w) *sz_w = 515;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 515*sizeof(casadi_real);
  return 0;
}

/* wobbling_end:(y[6x6],u[6],p[9])->(J[6x6],R[6]) */
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

/* wobbling_observed_swing:(t,h,w[7],p[9])->(w_end[7],nodes[7x12],g[10x12],dg[10x12]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w3=w+376, *w4=w+400, *w5=w+407, *w6=w+414, *w7=w+498, *w8=w+618;
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
  if (sz_w) *sz_w = 738;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 738*sizeof(casadi_real);
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
