/* Compass walker: kernels of the solver
 * Printed by CasADi 3.8.2 from equations 7b267325499c63c6.
 * Do not edit: run `make derive`.
 * SPDX-License-Identifier: BSD-3-Clause
 */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) compass_kernels_ ## ID
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
CASADI_SYMBOL_EXPORT void compass_kernels_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int compass_kernels_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int compass_kernels_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[23] = 
  {4, 4, 0, 4, 8, 12, 16, 0,
  1, 2, 3, 0, 1, 2, 3, 0,
  1, 2, 3, 0, 1, 2, 3};
static const casadi_int casadi_s1[17] = 
  {4, 4, 0, 4, 7, 9, 10, 0,
  1, 2, 3, 1, 2, 3, 2, 3,
  3};
static const casadi_int casadi_s2[17] = 
  {4, 4, 0, 1, 3, 6, 10, 0,
  0, 1, 0, 1, 2, 0, 1, 2,
  3};
static const casadi_int casadi_s3[4] = {0, 1, 2, 3};
static const casadi_int casadi_s4[3] = {4, 1, 1};
static const casadi_int casadi_s5[3] = {6, 1, 1};
static const casadi_int casadi_s6[3] = {4, 4, 1};
static const casadi_int casadi_s7[3] = {5, 49, 1};
static const casadi_int casadi_s8[3] = {10, 49, 1};
static const casadi_int casadi_s9[3] = {5, 73, 1};
static const casadi_int casadi_s10[3] = {10, 73, 1};
static const casadi_int casadi_s11[3] = {5, 97, 1};
static const casadi_int casadi_s12[3] = {10, 97, 1};
static const casadi_int casadi_s13[3] = {5, 145, 1};
static const casadi_int casadi_s14[3] = {10, 145, 1};
static const casadi_int casadi_s15[3] = {5, 193, 1};
static const casadi_int casadi_s16[3] = {10, 193, 1};
static const casadi_int casadi_s17[3] = {5, 289, 1};
static const casadi_int casadi_s18[3] = {10, 289, 1};
static const casadi_int casadi_s19[3] = {5, 385, 1};
static const casadi_int casadi_s20[3] = {10, 385, 1};
static const casadi_int casadi_s21[3] = {5, 577, 1};
static const casadi_int casadi_s22[3] = {10, 577, 1};
static const casadi_int casadi_s23[3] = {5, 769, 1};
static const casadi_int casadi_s24[3] = {10, 769, 1};
static const casadi_int casadi_s25[3] = {1, 1, 1};
static const casadi_int casadi_s26[3] = {5, 1, 1};
static const casadi_int casadi_s27[3] = {10, 1, 1};
static const casadi_int casadi_s28[3] = {5, 12, 1};
static const casadi_int casadi_s29[3] = {10, 12, 1};

static const casadi_real casadi_c0[16] = 
  {1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 5.0000000000000000e-01,
  1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 5.0000000000000000e-01};
static const casadi_real casadi_c1[4] = {1., 1., 1., 2.};

static const casadi_real casadi_zeros[24] = 
  {0.};

/* start:(z[3],p[6])->(y[4],dy_dz[4x3]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a0=(2.*a0);
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][2]=a0;
  a0=arg[0]? arg[0][2] : 0;
  if (res[0]!=0) res[0][3]=a0;
  a0=1.;
  if (res[1]!=0) res[1][0]=a0;
  a1=2.;
  if (res[1]!=0) res[1][1]=a1;
  a1=0.;
  if (res[1]!=0) res[1][2]=a1;
  if (res[1]!=0) res[1][3]=a1;
  if (res[1]!=0) res[1][4]=a1;
  if (res[1]!=0) res[1][5]=a1;
  if (res[1]!=0) res[1][6]=a0;
  if (res[1]!=0) res[1][7]=a1;
  if (res[1]!=0) res[1][8]=a1;
  if (res[1]!=0) res[1][9]=a1;
  if (res[1]!=0) res[1][10]=a1;
  if (res[1]!=0) res[1][11]=a0;
  return 0;
}

/* turns:(h,p[6])->(turns[2x12]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[1]? arg[1][0] : 0;
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

/* phase:(t,p[6])->(phase[2]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[1]? arg[1][0] : 0;
  a1=arg[0]? arg[0][0] : 0;
  a0=(a0*a1);
  a1=cos(a0);
  if (res[0]!=0) res[0][0]=a1;
  a0=sin(a0);
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[4x4],phase[2],turns[2x12],h,p[6])->(y_end[4x4]) */
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
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[3]? arg[3][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][2] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[4]? arg[4][1] : 0;
  a008=arg[0]? arg[0][3] : 0;
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
  a015=arg[4]? arg[4][3] : 0;
  a025=arg[4]? arg[4][5] : 0;
  a026=arg[4]? arg[4][0] : 0;
  a026=(a025*a026);
  a027=arg[1]? arg[1][1] : 0;
  a028=(a026*a027);
  a028=(a008+a028);
  a028=(a015*a028);
  a029=arg[4]? arg[4][2] : 0;
  a030=arg[4]? arg[4][4] : 0;
  a031=arg[1]? arg[1][0] : 0;
  a032=(a031+a019);
  a032=(a025*a032);
  a032=(a030-a032);
  a032=(a032+a010);
  a032=(a029*a032);
  a028=(a028+a032);
  a024=(a024-a028);
  a009=(a023*a009);
  a009=(a024-a009);
  a022=(a022*a023);
  a022=(a007-a022);
  a009=(a009/a022);
  a028=(a023*a009);
  a021=(a021-a028);
  a028=(a006*a021);
  a032=1.7082860872947386e-01;
  a032=(a032*a002);
  a033=2.9587585476806851e-02;
  a033=(a033*a002);
  a034=(a033*a009);
  a035=8.8762756430420545e-02;
  a035=(a035*a002);
  a036=1.9725056984537900e-02;
  a036=(a036*a002);
  a037=(a036*a021);
  a038=5.9175170953613701e-02;
  a038=(a038*a002);
  a039=5.2600151958767730e-02;
  a039=(a039*a002);
  a040=(a039*a009);
  a040=(a008+a040);
  a041=(a007*a040);
  a042=(a039*a008);
  a042=(a010+a042);
  a043=sin(a042);
  a041=(a041*a043);
  a044=(a039*a021);
  a044=(a003+a044);
  a045=(2.*a044);
  a046=(a040-a045);
  a041=(a041*a046);
  a046=(a039*a003);
  a046=(a000+a046);
  a047=sin(a046);
  a048=cos(a042);
  a049=(a047*a048);
  a046=cos(a046);
  a050=(a046*a043);
  a049=(a049-a050);
  a050=(a047-a049);
  a050=(a007*a050);
  a041=(a041+a050);
  a041=(a041+a047);
  a051=(a019-a048);
  a051=(a018*a051);
  a051=(a051+a019);
  a052=(a041/a051);
  a053=(a048-a019);
  a053=(a007*a053);
  a054=(a053/a051);
  a055=casadi_sq(a044);
  a055=(a055*a043);
  a055=(a055+a049);
  a055=(a007*a055);
  a049=arg[2]? arg[2][2] : 0;
  a056=(a027*a049);
  a057=arg[2]? arg[2][3] : 0;
  a058=(a031*a057);
  a056=(a056+a058);
  a056=(a026*a056);
  a056=(a040+a056);
  a056=(a015*a056);
  a049=(a031*a049);
  a057=(a027*a057);
  a049=(a049-a057);
  a049=(a049+a019);
  a049=(a025*a049);
  a049=(a030-a049);
  a049=(a049+a042);
  a049=(a029*a049);
  a056=(a056+a049);
  a055=(a055-a056);
  a041=(a054*a041);
  a041=(a055-a041);
  a053=(a053*a054);
  a053=(a007-a053);
  a041=(a041/a053);
  a056=(a054*a041);
  a052=(a052-a056);
  a052=(a038*a052);
  a037=(a037+a052);
  a037=(a003+a037);
  a052=casadi_sq(a037);
  a056=(a036*a008);
  a049=(a038*a040);
  a056=(a056+a049);
  a056=(a010+a056);
  a049=sin(a056);
  a052=(a052*a049);
  a042=(a036*a003);
  a057=(a038*a044);
  a042=(a042+a057);
  a042=(a000+a042);
  a057=sin(a042);
  a058=cos(a056);
  a059=(a057*a058);
  a042=cos(a042);
  a060=(a042*a049);
  a059=(a059-a060);
  a052=(a052+a059);
  a052=(a007*a052);
  a060=(a036*a009);
  a041=(a038*a041);
  a060=(a060+a041);
  a060=(a008+a060);
  a041=arg[2]? arg[2][4] : 0;
  a061=(a027*a041);
  a062=arg[2]? arg[2][5] : 0;
  a063=(a031*a062);
  a061=(a061+a063);
  a061=(a026*a061);
  a061=(a060+a061);
  a061=(a015*a061);
  a041=(a031*a041);
  a062=(a027*a062);
  a041=(a041-a062);
  a041=(a041+a019);
  a041=(a025*a041);
  a041=(a030-a041);
  a041=(a041+a056);
  a041=(a029*a041);
  a061=(a061+a041);
  a052=(a052-a061);
  a061=(a058-a019);
  a061=(a007*a061);
  a041=(a019-a058);
  a041=(a018*a041);
  a041=(a041+a019);
  a056=(a061/a041);
  a062=(a007*a060);
  a062=(a062*a049);
  a063=(2.*a037);
  a064=(a060-a063);
  a062=(a062*a064);
  a059=(a057-a059);
  a059=(a007*a059);
  a062=(a062+a059);
  a062=(a062+a057);
  a064=(a056*a062);
  a064=(a052-a064);
  a061=(a061*a056);
  a061=(a007-a061);
  a064=(a064/a061);
  a065=(a035*a064);
  a034=(a034+a065);
  a034=(a008+a034);
  a065=(a007*a034);
  a066=(a033*a008);
  a067=(a035*a060);
  a066=(a066+a067);
  a066=(a010+a066);
  a067=sin(a066);
  a065=(a065*a067);
  a068=(a033*a021);
  a062=(a062/a041);
  a069=(a056*a064);
  a062=(a062-a069);
  a069=(a035*a062);
  a068=(a068+a069);
  a068=(a003+a068);
  a069=(2.*a068);
  a070=(a034-a069);
  a065=(a065*a070);
  a070=(a033*a003);
  a071=(a035*a037);
  a070=(a070+a071);
  a070=(a000+a070);
  a071=sin(a070);
  a072=cos(a066);
  a073=(a071*a072);
  a070=cos(a070);
  a074=(a070*a067);
  a073=(a073-a074);
  a074=(a071-a073);
  a074=(a007*a074);
  a065=(a065+a074);
  a065=(a065+a071);
  a075=(a019-a072);
  a075=(a018*a075);
  a075=(a075+a019);
  a076=(a065/a075);
  a077=(a072-a019);
  a077=(a007*a077);
  a078=(a077/a075);
  a079=casadi_sq(a068);
  a079=(a079*a067);
  a079=(a079+a073);
  a079=(a007*a079);
  a073=arg[2]? arg[2][6] : 0;
  a080=(a027*a073);
  a081=arg[2]? arg[2][7] : 0;
  a082=(a031*a081);
  a080=(a080+a082);
  a080=(a026*a080);
  a080=(a034+a080);
  a080=(a015*a080);
  a073=(a031*a073);
  a081=(a027*a081);
  a073=(a073-a081);
  a073=(a073+a019);
  a073=(a025*a073);
  a073=(a030-a073);
  a073=(a073+a066);
  a073=(a029*a073);
  a080=(a080+a073);
  a079=(a079-a080);
  a065=(a078*a065);
  a065=(a079-a065);
  a077=(a077*a078);
  a077=(a007-a077);
  a065=(a065/a077);
  a080=(a078*a065);
  a076=(a076-a080);
  a080=(a032*a076);
  a028=(a028+a080);
  a080=1.2546768756682242e-01;
  a080=(a080*a002);
  a073=2.4136513415926669e-01;
  a073=(a073*a002);
  a066=(a073*a009);
  a081=-8.8454947932828609e-01;
  a081=(a081*a002);
  a064=(a081*a064);
  a066=(a066+a064);
  a064=9.2483400326179199e-01;
  a064=(a064*a002);
  a082=(a064*a065);
  a066=(a066+a082);
  a066=(a008+a066);
  a082=(a007*a066);
  a083=(a073*a008);
  a084=(a081*a060);
  a083=(a083+a084);
  a084=(a064*a034);
  a083=(a083+a084);
  a083=(a010+a083);
  a084=sin(a083);
  a082=(a082*a084);
  a085=(a073*a021);
  a062=(a081*a062);
  a085=(a085+a062);
  a062=(a064*a076);
  a085=(a085+a062);
  a085=(a003+a085);
  a062=(2.*a085);
  a086=(a066-a062);
  a082=(a082*a086);
  a086=(a073*a003);
  a087=(a081*a037);
  a086=(a086+a087);
  a087=(a064*a068);
  a086=(a086+a087);
  a086=(a000+a086);
  a087=sin(a086);
  a088=cos(a083);
  a089=(a087*a088);
  a086=cos(a086);
  a090=(a086*a084);
  a089=(a089-a090);
  a090=(a087-a089);
  a090=(a007*a090);
  a082=(a082+a090);
  a082=(a082+a087);
  a091=(a019-a088);
  a091=(a018*a091);
  a091=(a091+a019);
  a092=(a082/a091);
  a093=(a088-a019);
  a093=(a007*a093);
  a094=(a093/a091);
  a095=casadi_sq(a085);
  a095=(a095*a084);
  a095=(a095+a089);
  a095=(a007*a095);
  a089=arg[2]? arg[2][8] : 0;
  a096=(a027*a089);
  a097=arg[2]? arg[2][9] : 0;
  a098=(a031*a097);
  a096=(a096+a098);
  a096=(a026*a096);
  a096=(a066+a096);
  a096=(a015*a096);
  a089=(a031*a089);
  a097=(a027*a097);
  a089=(a089-a097);
  a089=(a089+a019);
  a089=(a025*a089);
  a089=(a030-a089);
  a089=(a089+a083);
  a089=(a029*a089);
  a096=(a096+a089);
  a095=(a095-a096);
  a082=(a094*a082);
  a082=(a095-a082);
  a093=(a093*a094);
  a093=(a007-a093);
  a082=(a082/a093);
  a096=(a094*a082);
  a092=(a092-a096);
  a096=(a080*a092);
  a028=(a028+a096);
  a028=(a003+a028);
  a096=(a005*a028);
  a004=(a004+a096);
  a096=1.8915178993145003e+00;
  a096=(a096*a002);
  a089=3.7109375000000000e-02;
  a089=(a089*a002);
  a083=(a089*a021);
  a097=1.7025221101954405e-01;
  a097=(a097*a002);
  a098=(a097*a076);
  a083=(a083+a098);
  a098=6.0216538980455959e-02;
  a098=(a098*a002);
  a099=(a098*a092);
  a083=(a083+a099);
  a099=-1.7578125000000000e-02;
  a099=(a099*a002);
  a100=(a006*a009);
  a101=(a032*a065);
  a100=(a100+a101);
  a101=(a080*a082);
  a100=(a100+a101);
  a100=(a008+a100);
  a101=(a007*a100);
  a102=(a006*a008);
  a103=(a032*a034);
  a102=(a102+a103);
  a103=(a080*a066);
  a102=(a102+a103);
  a102=(a010+a102);
  a103=sin(a102);
  a101=(a101*a103);
  a104=(2.*a028);
  a105=(a100-a104);
  a101=(a101*a105);
  a105=(a006*a003);
  a106=(a032*a068);
  a105=(a105+a106);
  a106=(a080*a085);
  a105=(a105+a106);
  a105=(a000+a105);
  a106=sin(a105);
  a107=cos(a102);
  a108=(a106*a107);
  a105=cos(a105);
  a109=(a105*a103);
  a108=(a108-a109);
  a109=(a106-a108);
  a109=(a007*a109);
  a101=(a101+a109);
  a101=(a101+a106);
  a110=(a019-a107);
  a110=(a018*a110);
  a110=(a110+a019);
  a111=(a101/a110);
  a112=(a107-a019);
  a112=(a007*a112);
  a113=(a112/a110);
  a114=casadi_sq(a028);
  a114=(a114*a103);
  a114=(a114+a108);
  a114=(a007*a114);
  a108=arg[2]? arg[2][10] : 0;
  a115=(a027*a108);
  a116=arg[2]? arg[2][11] : 0;
  a117=(a031*a116);
  a115=(a115+a117);
  a115=(a026*a115);
  a115=(a100+a115);
  a115=(a015*a115);
  a108=(a031*a108);
  a116=(a027*a116);
  a108=(a108-a116);
  a108=(a108+a019);
  a108=(a025*a108);
  a108=(a030-a108);
  a108=(a108+a102);
  a108=(a029*a108);
  a115=(a115+a108);
  a114=(a114-a115);
  a101=(a113*a101);
  a101=(a114-a101);
  a112=(a112*a113);
  a112=(a007-a112);
  a101=(a101/a112);
  a115=(a113*a101);
  a111=(a111-a115);
  a115=(a099*a111);
  a083=(a083+a115);
  a083=(a003+a083);
  a115=(a096*a083);
  a004=(a004+a115);
  a115=-5.8012039600105849e+00;
  a115=(a115*a002);
  a108=3.7092000118504789e-02;
  a108=(a108*a002);
  a102=(a108*a021);
  a116=1.7038392571223998e-01;
  a116=(a116*a002);
  a117=(a116*a076);
  a102=(a102+a117);
  a117=1.0726203044637328e-01;
  a117=(a117*a002);
  a118=(a117*a092);
  a102=(a102+a118);
  a118=-1.5319437748624402e-02;
  a118=(a118*a002);
  a119=(a118*a111);
  a102=(a102+a119);
  a119=8.2737891638140233e-03;
  a119=(a119*a002);
  a120=(a089*a009);
  a121=(a097*a065);
  a120=(a120+a121);
  a121=(a098*a082);
  a120=(a120+a121);
  a121=(a099*a101);
  a120=(a120+a121);
  a120=(a008+a120);
  a121=(a007*a120);
  a122=(a089*a008);
  a123=(a097*a034);
  a122=(a122+a123);
  a123=(a098*a066);
  a122=(a122+a123);
  a123=(a099*a100);
  a122=(a122+a123);
  a122=(a010+a122);
  a123=sin(a122);
  a121=(a121*a123);
  a124=(2.*a083);
  a125=(a120-a124);
  a121=(a121*a125);
  a125=(a089*a003);
  a126=(a097*a068);
  a125=(a125+a126);
  a126=(a098*a085);
  a125=(a125+a126);
  a126=(a099*a028);
  a125=(a125+a126);
  a125=(a000+a125);
  a126=sin(a125);
  a127=cos(a122);
  a128=(a126*a127);
  a125=cos(a125);
  a129=(a125*a123);
  a128=(a128-a129);
  a129=(a126-a128);
  a129=(a007*a129);
  a121=(a121+a129);
  a121=(a121+a126);
  a130=(a019-a127);
  a130=(a018*a130);
  a130=(a130+a019);
  a131=(a121/a130);
  a132=(a127-a019);
  a132=(a007*a132);
  a133=(a132/a130);
  a134=casadi_sq(a083);
  a134=(a134*a123);
  a134=(a134+a128);
  a134=(a007*a134);
  a128=arg[2]? arg[2][12] : 0;
  a135=(a027*a128);
  a136=arg[2]? arg[2][13] : 0;
  a137=(a031*a136);
  a135=(a135+a137);
  a135=(a026*a135);
  a135=(a120+a135);
  a135=(a015*a135);
  a128=(a031*a128);
  a136=(a027*a136);
  a128=(a128-a136);
  a128=(a128+a019);
  a128=(a025*a128);
  a128=(a030-a128);
  a128=(a128+a122);
  a128=(a029*a128);
  a135=(a135+a128);
  a134=(a134-a135);
  a121=(a133*a121);
  a121=(a134-a121);
  a132=(a132*a133);
  a132=(a007-a132);
  a121=(a121/a132);
  a135=(a133*a121);
  a131=(a131-a135);
  a135=(a119*a131);
  a102=(a102+a135);
  a102=(a003+a102);
  a135=(a115*a102);
  a004=(a004+a135);
  a135=3.1116436695781990e-01;
  a135=(a135*a002);
  a128=6.2411095871607569e-01;
  a128=(a128*a002);
  a122=(a128*a021);
  a136=-3.3608926294469414e+00;
  a136=(a136*a002);
  a137=(a136*a076);
  a122=(a122+a137);
  a137=-8.6821934684172597e-01;
  a137=(a137*a002);
  a138=(a137*a092);
  a122=(a122+a138);
  a138=2.7592099699446710e+01;
  a138=(a138*a002);
  a139=(a138*a111);
  a122=(a122+a139);
  a139=2.0154067550477894e+01;
  a139=(a139*a002);
  a140=(a139*a131);
  a122=(a122+a140);
  a140=-4.3489884181069961e+01;
  a140=(a140*a002);
  a141=(a108*a009);
  a142=(a116*a065);
  a141=(a141+a142);
  a142=(a117*a082);
  a141=(a141+a142);
  a142=(a118*a101);
  a141=(a141+a142);
  a142=(a119*a121);
  a141=(a141+a142);
  a141=(a008+a141);
  a142=(a007*a141);
  a143=(a108*a008);
  a144=(a116*a034);
  a143=(a143+a144);
  a144=(a117*a066);
  a143=(a143+a144);
  a144=(a118*a100);
  a143=(a143+a144);
  a144=(a119*a120);
  a143=(a143+a144);
  a143=(a010+a143);
  a144=sin(a143);
  a142=(a142*a144);
  a145=(2.*a102);
  a146=(a141-a145);
  a142=(a142*a146);
  a146=(a108*a003);
  a147=(a116*a068);
  a146=(a146+a147);
  a147=(a117*a085);
  a146=(a146+a147);
  a147=(a118*a028);
  a146=(a146+a147);
  a147=(a119*a083);
  a146=(a146+a147);
  a146=(a000+a146);
  a147=sin(a146);
  a148=cos(a143);
  a149=(a147*a148);
  a146=cos(a146);
  a150=(a146*a144);
  a149=(a149-a150);
  a150=(a147-a149);
  a150=(a007*a150);
  a142=(a142+a150);
  a142=(a142+a147);
  a151=(a019-a148);
  a151=(a018*a151);
  a151=(a151+a019);
  a152=(a142/a151);
  a153=(a148-a019);
  a153=(a007*a153);
  a154=(a153/a151);
  a155=casadi_sq(a102);
  a155=(a155*a144);
  a155=(a155+a149);
  a155=(a007*a155);
  a149=arg[2]? arg[2][14] : 0;
  a156=(a027*a149);
  a157=arg[2]? arg[2][15] : 0;
  a158=(a031*a157);
  a156=(a156+a158);
  a156=(a026*a156);
  a156=(a141+a156);
  a156=(a015*a156);
  a149=(a031*a149);
  a157=(a027*a157);
  a149=(a149-a157);
  a149=(a149+a019);
  a149=(a025*a149);
  a149=(a030-a149);
  a149=(a149+a143);
  a149=(a029*a149);
  a156=(a156+a149);
  a155=(a155-a156);
  a142=(a154*a142);
  a142=(a155-a142);
  a153=(a153*a154);
  a153=(a007-a153);
  a142=(a142/a153);
  a156=(a154*a142);
  a152=(a152-a156);
  a156=(a140*a152);
  a122=(a122+a156);
  a122=(a003+a122);
  a156=(a135*a122);
  a004=(a004+a156);
  a156=-1.5216094966251609e-01;
  a156=(a156*a002);
  a149=4.7766253643826434e-01;
  a149=(a149*a002);
  a143=(a149*a021);
  a157=-2.4881146199716677e+00;
  a157=(a157*a002);
  a158=(a157*a076);
  a143=(a143+a158);
  a158=-5.9029082683684297e-01;
  a158=(a158*a002);
  a159=(a158*a092);
  a143=(a143+a159);
  a159=2.1230051448181193e+01;
  a159=(a159*a002);
  a160=(a159*a111);
  a143=(a143+a160);
  a160=1.5279233632882423e+01;
  a160=(a160*a002);
  a161=(a160*a131);
  a143=(a143+a161);
  a161=-3.3288210968984863e+01;
  a161=(a161*a002);
  a162=(a161*a152);
  a143=(a143+a162);
  a162=-2.0331201708508627e-02;
  a162=(a162*a002);
  a163=(a128*a009);
  a164=(a136*a065);
  a163=(a163+a164);
  a164=(a137*a082);
  a163=(a163+a164);
  a164=(a138*a101);
  a163=(a163+a164);
  a164=(a139*a121);
  a163=(a163+a164);
  a164=(a140*a142);
  a163=(a163+a164);
  a163=(a008+a163);
  a164=(a007*a163);
  a165=(a128*a008);
  a166=(a136*a034);
  a165=(a165+a166);
  a166=(a137*a066);
  a165=(a165+a166);
  a166=(a138*a100);
  a165=(a165+a166);
  a166=(a139*a120);
  a165=(a165+a166);
  a166=(a140*a141);
  a165=(a165+a166);
  a165=(a010+a165);
  a166=sin(a165);
  a164=(a164*a166);
  a167=(2.*a122);
  a168=(a163-a167);
  a164=(a164*a168);
  a168=(a128*a003);
  a169=(a136*a068);
  a168=(a168+a169);
  a169=(a137*a085);
  a168=(a168+a169);
  a169=(a138*a028);
  a168=(a168+a169);
  a169=(a139*a083);
  a168=(a168+a169);
  a169=(a140*a102);
  a168=(a168+a169);
  a168=(a000+a168);
  a169=sin(a168);
  a170=cos(a165);
  a171=(a169*a170);
  a168=cos(a168);
  a172=(a168*a166);
  a171=(a171-a172);
  a172=(a169-a171);
  a172=(a007*a172);
  a164=(a164+a172);
  a164=(a164+a169);
  a173=(a019-a170);
  a173=(a018*a173);
  a173=(a173+a019);
  a174=(a164/a173);
  a175=(a170-a019);
  a175=(a007*a175);
  a176=(a175/a173);
  a177=casadi_sq(a122);
  a177=(a177*a166);
  a177=(a177+a171);
  a177=(a007*a177);
  a171=arg[2]? arg[2][16] : 0;
  a178=(a027*a171);
  a179=arg[2]? arg[2][17] : 0;
  a180=(a031*a179);
  a178=(a178+a180);
  a178=(a026*a178);
  a178=(a163+a178);
  a178=(a015*a178);
  a171=(a031*a171);
  a179=(a027*a179);
  a171=(a171-a179);
  a171=(a171+a019);
  a171=(a025*a171);
  a171=(a030-a171);
  a171=(a171+a165);
  a171=(a029*a171);
  a178=(a178+a171);
  a177=(a177-a178);
  a164=(a176*a164);
  a164=(a177-a164);
  a175=(a175*a176);
  a175=(a007-a175);
  a164=(a164/a175);
  a178=(a176*a164);
  a174=(a174-a178);
  a178=(a162*a174);
  a143=(a143+a178);
  a143=(a003+a143);
  a178=(a156*a143);
  a004=(a004+a178);
  a178=2.0136540080403034e-01;
  a178=(a178*a002);
  a171=-9.3714243008598730e-01;
  a171=(a171*a002);
  a165=(a171*a021);
  a179=5.1863724288440638e+00;
  a179=(a179*a002);
  a180=(a179*a076);
  a165=(a165+a180);
  a180=1.0914373489967295e+00;
  a180=(a180*a002);
  a181=(a180*a092);
  a165=(a165+a181);
  a181=-8.1497870107469268e+00;
  a181=(a181*a002);
  a182=(a181*a111);
  a165=(a165+a182);
  a182=-1.8520065659996959e+01;
  a182=(a182*a002);
  a183=(a182*a131);
  a165=(a165+a183);
  a183=2.2739487099350505e+01;
  a183=(a183*a002);
  a184=(a183*a152);
  a165=(a165+a184);
  a184=2.4936055526796523e+00;
  a184=(a184*a002);
  a185=(a184*a174);
  a165=(a165+a185);
  a185=-3.0467644718982196e+00;
  a185=(a185*a002);
  a186=(a149*a009);
  a187=(a157*a065);
  a186=(a186+a187);
  a187=(a158*a082);
  a186=(a186+a187);
  a187=(a159*a101);
  a186=(a186+a187);
  a187=(a160*a121);
  a186=(a186+a187);
  a187=(a161*a142);
  a186=(a186+a187);
  a187=(a162*a164);
  a186=(a186+a187);
  a186=(a008+a186);
  a187=(a007*a186);
  a188=(a149*a008);
  a189=(a157*a034);
  a188=(a188+a189);
  a189=(a158*a066);
  a188=(a188+a189);
  a189=(a159*a100);
  a188=(a188+a189);
  a189=(a160*a120);
  a188=(a188+a189);
  a189=(a161*a141);
  a188=(a188+a189);
  a189=(a162*a163);
  a188=(a188+a189);
  a188=(a010+a188);
  a189=sin(a188);
  a187=(a187*a189);
  a190=(2.*a143);
  a191=(a186-a190);
  a187=(a187*a191);
  a191=(a149*a003);
  a192=(a157*a068);
  a191=(a191+a192);
  a192=(a158*a085);
  a191=(a191+a192);
  a192=(a159*a028);
  a191=(a191+a192);
  a192=(a160*a083);
  a191=(a191+a192);
  a192=(a161*a102);
  a191=(a191+a192);
  a192=(a162*a122);
  a191=(a191+a192);
  a191=(a000+a191);
  a192=sin(a191);
  a193=cos(a188);
  a194=(a192*a193);
  a191=cos(a191);
  a195=(a191*a189);
  a194=(a194-a195);
  a195=(a192-a194);
  a195=(a007*a195);
  a187=(a187+a195);
  a187=(a187+a192);
  a196=(a019-a193);
  a196=(a018*a196);
  a196=(a196+a019);
  a197=(a187/a196);
  a198=(a193-a019);
  a198=(a007*a198);
  a199=(a198/a196);
  a200=casadi_sq(a143);
  a200=(a200*a189);
  a200=(a200+a194);
  a200=(a007*a200);
  a194=arg[2]? arg[2][18] : 0;
  a201=(a027*a194);
  a202=arg[2]? arg[2][19] : 0;
  a203=(a031*a202);
  a201=(a201+a203);
  a201=(a026*a201);
  a201=(a186+a201);
  a201=(a015*a201);
  a194=(a031*a194);
  a202=(a027*a202);
  a194=(a194-a202);
  a194=(a194+a019);
  a194=(a025*a194);
  a194=(a030-a194);
  a194=(a194+a188);
  a194=(a029*a194);
  a201=(a201+a194);
  a200=(a200-a201);
  a187=(a199*a187);
  a187=(a200-a187);
  a198=(a198*a199);
  a198=(a007-a198);
  a187=(a187/a198);
  a201=(a199*a187);
  a197=(a197-a201);
  a201=(a185*a197);
  a165=(a165+a201);
  a165=(a003+a165);
  a201=(a178*a165);
  a004=(a004+a201);
  a201=4.4710615727772587e-02;
  a201=(a201*a002);
  a194=2.2733101475165380e+00;
  a194=(a194*a002);
  a188=(a194*a021);
  a202=-1.0534495466737249e+01;
  a202=(a202*a002);
  a076=(a202*a076);
  a188=(a188+a076);
  a076=-2.0008720582248625e+00;
  a076=(a076*a002);
  a092=(a076*a092);
  a188=(a188+a092);
  a092=-1.7958931863118799e+01;
  a092=(a092*a002);
  a203=(a092*a111);
  a188=(a188+a203);
  a203=2.7948884529419960e+01;
  a203=(a203*a002);
  a204=(a203*a131);
  a188=(a188+a204);
  a204=-2.8589982771350235e+00;
  a204=(a204*a002);
  a205=(a204*a152);
  a188=(a188+a205);
  a205=-8.8728569335306293e+00;
  a205=(a205*a002);
  a206=(a205*a174);
  a188=(a188+a206);
  a206=1.2360567175794303e+01;
  a206=(a206*a002);
  a207=(a206*a197);
  a188=(a188+a207);
  a207=6.4339274601576357e-01;
  a207=(a207*a002);
  a002=(a171*a009);
  a208=(a179*a065);
  a002=(a002+a208);
  a208=(a180*a082);
  a002=(a002+a208);
  a208=(a181*a101);
  a002=(a002+a208);
  a208=(a182*a121);
  a002=(a002+a208);
  a208=(a183*a142);
  a002=(a002+a208);
  a208=(a184*a164);
  a002=(a002+a208);
  a208=(a185*a187);
  a002=(a002+a208);
  a002=(a008+a002);
  a208=(a007*a002);
  a209=(a171*a008);
  a210=(a179*a034);
  a209=(a209+a210);
  a210=(a180*a066);
  a209=(a209+a210);
  a210=(a181*a100);
  a209=(a209+a210);
  a210=(a182*a120);
  a209=(a209+a210);
  a210=(a183*a141);
  a209=(a209+a210);
  a210=(a184*a163);
  a209=(a209+a210);
  a210=(a185*a186);
  a209=(a209+a210);
  a209=(a010+a209);
  a210=sin(a209);
  a208=(a208*a210);
  a211=(2.*a165);
  a212=(a002-a211);
  a208=(a208*a212);
  a212=(a171*a003);
  a213=(a179*a068);
  a212=(a212+a213);
  a213=(a180*a085);
  a212=(a212+a213);
  a213=(a181*a028);
  a212=(a212+a213);
  a213=(a182*a083);
  a212=(a212+a213);
  a213=(a183*a102);
  a212=(a212+a213);
  a213=(a184*a122);
  a212=(a212+a213);
  a213=(a185*a143);
  a212=(a212+a213);
  a212=(a000+a212);
  a213=sin(a212);
  a214=cos(a209);
  a215=(a213*a214);
  a212=cos(a212);
  a216=(a212*a210);
  a215=(a215-a216);
  a216=(a213-a215);
  a216=(a007*a216);
  a208=(a208+a216);
  a208=(a208+a213);
  a217=(a019-a214);
  a217=(a018*a217);
  a217=(a217+a019);
  a218=(a208/a217);
  a219=(a214-a019);
  a219=(a007*a219);
  a220=(a219/a217);
  a221=casadi_sq(a165);
  a221=(a221*a210);
  a221=(a221+a215);
  a221=(a007*a221);
  a215=arg[2]? arg[2][20] : 0;
  a222=(a027*a215);
  a223=arg[2]? arg[2][21] : 0;
  a224=(a031*a223);
  a222=(a222+a224);
  a222=(a026*a222);
  a222=(a002+a222);
  a222=(a015*a222);
  a215=(a031*a215);
  a223=(a027*a223);
  a215=(a215-a223);
  a215=(a215+a019);
  a215=(a025*a215);
  a215=(a030-a215);
  a215=(a215+a209);
  a215=(a029*a215);
  a222=(a222+a215);
  a221=(a221-a222);
  a208=(a220*a208);
  a208=(a221-a208);
  a219=(a219*a220);
  a219=(a007-a219);
  a208=(a208/a219);
  a222=(a220*a208);
  a218=(a218-a222);
  a222=(a207*a218);
  a188=(a188+a222);
  a188=(a003+a188);
  a222=(a201*a188);
  a004=(a004+a222);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a222=(a005*a100);
  a004=(a004+a222);
  a222=(a096*a120);
  a004=(a004+a222);
  a222=(a115*a141);
  a004=(a004+a222);
  a222=(a135*a163);
  a004=(a004+a222);
  a222=(a156*a186);
  a004=(a004+a222);
  a222=(a178*a002);
  a004=(a004+a222);
  a222=(a194*a009);
  a065=(a202*a065);
  a222=(a222+a065);
  a082=(a076*a082);
  a222=(a222+a082);
  a082=(a092*a101);
  a222=(a222+a082);
  a082=(a203*a121);
  a222=(a222+a082);
  a082=(a204*a142);
  a222=(a222+a082);
  a082=(a205*a164);
  a222=(a222+a082);
  a082=(a206*a187);
  a222=(a222+a082);
  a082=(a207*a208);
  a222=(a222+a082);
  a222=(a008+a222);
  a082=(a201*a222);
  a004=(a004+a082);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a021=(a001*a021);
  a111=(a005*a111);
  a021=(a021+a111);
  a131=(a096*a131);
  a021=(a021+a131);
  a152=(a115*a152);
  a021=(a021+a152);
  a174=(a135*a174);
  a021=(a021+a174);
  a197=(a156*a197);
  a021=(a021+a197);
  a218=(a178*a218);
  a021=(a021+a218);
  a218=(a007*a222);
  a197=(a194*a008);
  a174=(a202*a034);
  a197=(a197+a174);
  a174=(a076*a066);
  a197=(a197+a174);
  a174=(a092*a100);
  a197=(a197+a174);
  a174=(a203*a120);
  a197=(a197+a174);
  a174=(a204*a141);
  a197=(a197+a174);
  a174=(a205*a163);
  a197=(a197+a174);
  a174=(a206*a186);
  a197=(a197+a174);
  a174=(a207*a002);
  a197=(a197+a174);
  a010=(a010+a197);
  a197=sin(a010);
  a218=(a218*a197);
  a174=(2.*a188);
  a152=(a222-a174);
  a218=(a218*a152);
  a152=(a194*a003);
  a131=(a202*a068);
  a152=(a152+a131);
  a131=(a076*a085);
  a152=(a152+a131);
  a131=(a092*a028);
  a152=(a152+a131);
  a131=(a203*a083);
  a152=(a152+a131);
  a131=(a204*a102);
  a152=(a152+a131);
  a131=(a205*a122);
  a152=(a152+a131);
  a131=(a206*a143);
  a152=(a152+a131);
  a131=(a207*a165);
  a152=(a152+a131);
  a000=(a000+a152);
  a152=sin(a000);
  a131=cos(a010);
  a111=(a152*a131);
  a000=cos(a000);
  a004=(a000*a197);
  a111=(a111-a004);
  a004=(a152-a111);
  a004=(a007*a004);
  a218=(a218+a004);
  a218=(a218+a152);
  a082=(a019-a131);
  a082=(a018*a082);
  a082=(a082+a019);
  a065=(a218/a082);
  a215=(a131-a019);
  a215=(a007*a215);
  a209=(a215/a082);
  a223=casadi_sq(a188);
  a223=(a223*a197);
  a223=(a223+a111);
  a223=(a007*a223);
  a111=arg[2]? arg[2][22] : 0;
  a224=(a027*a111);
  a225=arg[2]? arg[2][23] : 0;
  a226=(a031*a225);
  a224=(a224+a226);
  a026=(a026*a224);
  a026=(a222+a026);
  a026=(a015*a026);
  a031=(a031*a111);
  a027=(a027*a225);
  a031=(a031-a027);
  a031=(a031+a019);
  a025=(a025*a031);
  a030=(a030-a025);
  a030=(a030+a010);
  a030=(a029*a030);
  a026=(a026+a030);
  a223=(a223-a026);
  a218=(a209*a218);
  a218=(a223-a218);
  a215=(a215*a209);
  a215=(a007-a215);
  a218=(a218/a215);
  a026=(a209*a218);
  a065=(a065-a026);
  a065=(a201*a065);
  a021=(a021+a065);
  a021=(a003+a021);
  if (res[0]!=0) res[0][2]=a021;
  a009=(a001*a009);
  a101=(a005*a101);
  a009=(a009+a101);
  a121=(a096*a121);
  a009=(a009+a121);
  a142=(a115*a142);
  a009=(a009+a142);
  a164=(a135*a164);
  a009=(a009+a164);
  a187=(a156*a187);
  a009=(a009+a187);
  a208=(a178*a208);
  a009=(a009+a208);
  a218=(a201*a218);
  a009=(a009+a218);
  a009=(a008+a009);
  if (res[0]!=0) res[0][3]=a009;
  a009=arg[0]? arg[0][4] : 0;
  a218=arg[0]? arg[0][6] : 0;
  a208=(a001*a218);
  a187=(a016*a014);
  a164=(a013*a011);
  a187=(a187+a164);
  a164=(a016-a187);
  a164=(a007*a164);
  a164=(a164+a016);
  a016=(a164/a020);
  a142=(a007*a187);
  a164=(a023*a164);
  a142=(a142-a164);
  a142=(a142/a022);
  a164=(a023*a142);
  a016=(a016-a164);
  a164=(a016*a009);
  a121=(a007*a011);
  a012=(a012-a008);
  a012=(a008*a012);
  a121=(a121*a012);
  a017=(a017-a121);
  a017=(a017+a013);
  a013=(a023*a017);
  a024=(a024-a013);
  a024=(a024/a022);
  a013=(a024*a011);
  a017=(a017/a020);
  a024=(a023*a024);
  a017=(a017-a024);
  a024=(2.*a017);
  a024=(a024*a011);
  a013=(a013-a024);
  a013=(a013+a187);
  a012=(a014*a012);
  a013=(a013-a012);
  a013=(a007*a013);
  a012=(a013/a020);
  a017=(a017*a011);
  a017=(a017-a187);
  a014=(a014*a003);
  a014=(a014*a003);
  a017=(a017+a014);
  a017=(a007*a017);
  a017=(a017-a029);
  a013=(a023*a013);
  a017=(a017-a013);
  a017=(a017/a022);
  a013=(a023*a017);
  a012=(a012-a013);
  a013=arg[0]? arg[0][5] : 0;
  a014=(a012*a013);
  a164=(a164+a014);
  a014=-2.;
  a014=(a014*a007);
  a187=(a014*a008);
  a187=(a187*a011);
  a024=(a187/a020);
  a121=(a018*a003);
  a121=(a121*a011);
  a187=(a023*a187);
  a121=(a121-a187);
  a121=(a121/a022);
  a187=(a023*a121);
  a024=(a024-a187);
  a187=(a024*a218);
  a011=(a018*a011);
  a008=(a008-a003);
  a011=(a011*a008);
  a020=(a011/a020);
  a011=(a023*a011);
  a011=(a015+a011);
  a011=(a011/a022);
  a023=(a023*a011);
  a020=(a020+a023);
  a023=arg[0]? arg[0][7] : 0;
  a022=(a020*a023);
  a187=(a187+a022);
  a164=(a164+a187);
  a187=(a006*a164);
  a022=(a070*a072);
  a008=(a071*a067);
  a022=(a022+a008);
  a008=(a070-a022);
  a008=(a007*a008);
  a008=(a008+a070);
  a070=(a008/a075);
  a003=(a007*a022);
  a008=(a078*a008);
  a003=(a003-a008);
  a003=(a003/a077);
  a008=(a078*a003);
  a070=(a070-a008);
  a008=(a033*a218);
  a101=(a036*a164);
  a021=(a046*a048);
  a065=(a047*a043);
  a021=(a021+a065);
  a065=(a046-a021);
  a065=(a007*a065);
  a065=(a065+a046);
  a046=(a065/a051);
  a026=(a007*a021);
  a065=(a054*a065);
  a026=(a026-a065);
  a026=(a026/a053);
  a065=(a054*a026);
  a046=(a046-a065);
  a065=(a039*a218);
  a065=(a009+a065);
  a030=(a046*a065);
  a010=(a007*a043);
  a045=(a045-a040);
  a045=(a040*a045);
  a010=(a010*a045);
  a050=(a050-a010);
  a050=(a050+a047);
  a047=(a054*a050);
  a055=(a055-a047);
  a055=(a055/a053);
  a047=(a055*a043);
  a050=(a050/a051);
  a055=(a054*a055);
  a050=(a050-a055);
  a055=(2.*a050);
  a055=(a055*a043);
  a047=(a047-a055);
  a047=(a047+a021);
  a045=(a048*a045);
  a047=(a047-a045);
  a047=(a007*a047);
  a045=(a047/a051);
  a050=(a050*a043);
  a050=(a050-a021);
  a048=(a048*a044);
  a048=(a048*a044);
  a050=(a050+a048);
  a050=(a007*a050);
  a050=(a050-a029);
  a047=(a054*a047);
  a050=(a050-a047);
  a050=(a050/a053);
  a047=(a054*a050);
  a045=(a045-a047);
  a047=(a039*a023);
  a047=(a013+a047);
  a048=(a045*a047);
  a030=(a030+a048);
  a048=(a014*a040);
  a048=(a048*a043);
  a021=(a048/a051);
  a055=(a018*a044);
  a055=(a055*a043);
  a048=(a054*a048);
  a055=(a055-a048);
  a055=(a055/a053);
  a048=(a054*a055);
  a021=(a021-a048);
  a048=(a039*a164);
  a048=(a218+a048);
  a010=(a021*a048);
  a043=(a018*a043);
  a040=(a040-a044);
  a043=(a043*a040);
  a051=(a043/a051);
  a043=(a054*a043);
  a043=(a015+a043);
  a043=(a043/a053);
  a054=(a054*a043);
  a051=(a051+a054);
  a054=(a142*a009);
  a053=(a017*a013);
  a054=(a054+a053);
  a053=(a121*a218);
  a040=(a011*a023);
  a053=(a053-a040);
  a054=(a054+a053);
  a053=(a039*a054);
  a053=(a023+a053);
  a040=(a051*a053);
  a010=(a010+a040);
  a030=(a030+a010);
  a030=(a038*a030);
  a101=(a101+a030);
  a101=(a218+a101);
  a030=(a035*a101);
  a008=(a008+a030);
  a008=(a009+a008);
  a030=(a070*a008);
  a010=(a007*a067);
  a069=(a069-a034);
  a069=(a034*a069);
  a010=(a010*a069);
  a074=(a074-a010);
  a074=(a074+a071);
  a071=(a078*a074);
  a079=(a079-a071);
  a079=(a079/a077);
  a071=(a079*a067);
  a074=(a074/a075);
  a079=(a078*a079);
  a074=(a074-a079);
  a079=(2.*a074);
  a079=(a079*a067);
  a071=(a071-a079);
  a071=(a071+a022);
  a069=(a072*a069);
  a071=(a071-a069);
  a071=(a007*a071);
  a069=(a071/a075);
  a074=(a074*a067);
  a074=(a074-a022);
  a072=(a072*a068);
  a072=(a072*a068);
  a074=(a074+a072);
  a074=(a007*a074);
  a074=(a074-a029);
  a071=(a078*a071);
  a074=(a074-a071);
  a074=(a074/a077);
  a071=(a078*a074);
  a069=(a069-a071);
  a071=(a033*a023);
  a072=(a036*a054);
  a065=(a026*a065);
  a047=(a050*a047);
  a065=(a065+a047);
  a047=(a055*a048);
  a022=(a043*a053);
  a047=(a047-a022);
  a065=(a065+a047);
  a065=(a038*a065);
  a072=(a072+a065);
  a072=(a023+a072);
  a065=(a035*a072);
  a071=(a071+a065);
  a071=(a013+a071);
  a065=(a069*a071);
  a030=(a030+a065);
  a065=(a014*a034);
  a065=(a065*a067);
  a047=(a065/a075);
  a022=(a018*a068);
  a022=(a022*a067);
  a065=(a078*a065);
  a022=(a022-a065);
  a022=(a022/a077);
  a065=(a078*a022);
  a047=(a047-a065);
  a065=(a033*a164);
  a079=(a042*a058);
  a010=(a057*a049);
  a079=(a079+a010);
  a010=(a042-a079);
  a010=(a007*a010);
  a010=(a010+a042);
  a042=(a010/a041);
  a040=(a007*a079);
  a010=(a056*a010);
  a040=(a040-a010);
  a040=(a040/a061);
  a010=(a056*a040);
  a042=(a042-a010);
  a010=(a036*a218);
  a048=(a038*a048);
  a010=(a010+a048);
  a010=(a009+a010);
  a048=(a042*a010);
  a044=(a007*a049);
  a063=(a063-a060);
  a063=(a060*a063);
  a044=(a044*a063);
  a059=(a059-a044);
  a059=(a059+a057);
  a057=(a056*a059);
  a052=(a052-a057);
  a052=(a052/a061);
  a057=(a052*a049);
  a059=(a059/a041);
  a052=(a056*a052);
  a059=(a059-a052);
  a052=(2.*a059);
  a052=(a052*a049);
  a057=(a057-a052);
  a057=(a057+a079);
  a063=(a058*a063);
  a057=(a057-a063);
  a057=(a007*a057);
  a063=(a057/a041);
  a059=(a059*a049);
  a059=(a059-a079);
  a058=(a058*a037);
  a058=(a058*a037);
  a059=(a059+a058);
  a059=(a007*a059);
  a059=(a059-a029);
  a057=(a056*a057);
  a059=(a059-a057);
  a059=(a059/a061);
  a057=(a056*a059);
  a063=(a063-a057);
  a057=(a036*a023);
  a053=(a038*a053);
  a057=(a057+a053);
  a057=(a013+a057);
  a053=(a063*a057);
  a048=(a048+a053);
  a053=(a014*a060);
  a053=(a053*a049);
  a058=(a053/a041);
  a079=(a018*a037);
  a079=(a079*a049);
  a053=(a056*a053);
  a079=(a079-a053);
  a079=(a079/a061);
  a053=(a056*a079);
  a058=(a058-a053);
  a053=(a058*a101);
  a049=(a018*a049);
  a060=(a060-a037);
  a049=(a049*a060);
  a041=(a049/a041);
  a049=(a056*a049);
  a049=(a015+a049);
  a049=(a049/a061);
  a056=(a056*a049);
  a041=(a041+a056);
  a056=(a041*a072);
  a053=(a053+a056);
  a048=(a048+a053);
  a053=(a035*a048);
  a065=(a065+a053);
  a065=(a218+a065);
  a053=(a047*a065);
  a067=(a018*a067);
  a034=(a034-a068);
  a067=(a067*a034);
  a075=(a067/a075);
  a067=(a078*a067);
  a067=(a015+a067);
  a067=(a067/a077);
  a078=(a078*a067);
  a075=(a075+a078);
  a078=(a033*a054);
  a010=(a040*a010);
  a057=(a059*a057);
  a010=(a010+a057);
  a057=(a079*a101);
  a077=(a049*a072);
  a057=(a057-a077);
  a010=(a010+a057);
  a057=(a035*a010);
  a078=(a078+a057);
  a078=(a023+a078);
  a057=(a075*a078);
  a053=(a053+a057);
  a030=(a030+a053);
  a053=(a032*a030);
  a187=(a187+a053);
  a053=(a086*a088);
  a057=(a087*a084);
  a053=(a053+a057);
  a057=(a086-a053);
  a057=(a007*a057);
  a057=(a057+a086);
  a086=(a057/a091);
  a077=(a007*a053);
  a057=(a094*a057);
  a077=(a077-a057);
  a077=(a077/a093);
  a057=(a094*a077);
  a086=(a086-a057);
  a057=(a073*a218);
  a101=(a081*a101);
  a057=(a057+a101);
  a101=(a064*a065);
  a057=(a057+a101);
  a057=(a009+a057);
  a101=(a086*a057);
  a034=(a007*a084);
  a062=(a062-a066);
  a062=(a066*a062);
  a034=(a034*a062);
  a090=(a090-a034);
  a090=(a090+a087);
  a087=(a094*a090);
  a095=(a095-a087);
  a095=(a095/a093);
  a087=(a095*a084);
  a090=(a090/a091);
  a095=(a094*a095);
  a090=(a090-a095);
  a095=(2.*a090);
  a095=(a095*a084);
  a087=(a087-a095);
  a087=(a087+a053);
  a062=(a088*a062);
  a087=(a087-a062);
  a087=(a007*a087);
  a062=(a087/a091);
  a090=(a090*a084);
  a090=(a090-a053);
  a088=(a088*a085);
  a088=(a088*a085);
  a090=(a090+a088);
  a090=(a007*a090);
  a090=(a090-a029);
  a087=(a094*a087);
  a090=(a090-a087);
  a090=(a090/a093);
  a087=(a094*a090);
  a062=(a062-a087);
  a087=(a073*a023);
  a072=(a081*a072);
  a087=(a087+a072);
  a072=(a064*a078);
  a087=(a087+a072);
  a087=(a013+a087);
  a072=(a062*a087);
  a101=(a101+a072);
  a072=(a014*a066);
  a072=(a072*a084);
  a088=(a072/a091);
  a053=(a018*a085);
  a053=(a053*a084);
  a072=(a094*a072);
  a053=(a053-a072);
  a053=(a053/a093);
  a072=(a094*a053);
  a088=(a088-a072);
  a072=(a073*a164);
  a048=(a081*a048);
  a072=(a072+a048);
  a048=(a064*a030);
  a072=(a072+a048);
  a072=(a218+a072);
  a048=(a088*a072);
  a084=(a018*a084);
  a066=(a066-a085);
  a084=(a084*a066);
  a091=(a084/a091);
  a084=(a094*a084);
  a084=(a015+a084);
  a084=(a084/a093);
  a094=(a094*a084);
  a091=(a091+a094);
  a094=(a073*a054);
  a010=(a081*a010);
  a094=(a094+a010);
  a008=(a003*a008);
  a071=(a074*a071);
  a008=(a008+a071);
  a071=(a022*a065);
  a010=(a067*a078);
  a071=(a071-a010);
  a008=(a008+a071);
  a071=(a064*a008);
  a094=(a094+a071);
  a094=(a023+a094);
  a071=(a091*a094);
  a048=(a048+a071);
  a101=(a101+a048);
  a048=(a080*a101);
  a187=(a187+a048);
  a187=(a218+a187);
  a048=(a005*a187);
  a208=(a208+a048);
  a048=(a089*a164);
  a071=(a097*a030);
  a048=(a048+a071);
  a071=(a098*a101);
  a048=(a048+a071);
  a071=(a105*a107);
  a010=(a106*a103);
  a071=(a071+a010);
  a010=(a105-a071);
  a010=(a007*a010);
  a010=(a010+a105);
  a105=(a010/a110);
  a093=(a007*a071);
  a010=(a113*a010);
  a093=(a093-a010);
  a093=(a093/a112);
  a010=(a113*a093);
  a105=(a105-a010);
  a010=(a006*a218);
  a066=(a032*a065);
  a010=(a010+a066);
  a066=(a080*a072);
  a010=(a010+a066);
  a010=(a009+a010);
  a066=(a105*a010);
  a085=(a007*a103);
  a104=(a104-a100);
  a104=(a100*a104);
  a085=(a085*a104);
  a109=(a109-a085);
  a109=(a109+a106);
  a106=(a113*a109);
  a114=(a114-a106);
  a114=(a114/a112);
  a106=(a114*a103);
  a109=(a109/a110);
  a114=(a113*a114);
  a109=(a109-a114);
  a114=(2.*a109);
  a114=(a114*a103);
  a106=(a106-a114);
  a106=(a106+a071);
  a104=(a107*a104);
  a106=(a106-a104);
  a106=(a007*a106);
  a104=(a106/a110);
  a109=(a109*a103);
  a109=(a109-a071);
  a107=(a107*a028);
  a107=(a107*a028);
  a109=(a109+a107);
  a109=(a007*a109);
  a109=(a109-a029);
  a106=(a113*a106);
  a109=(a109-a106);
  a109=(a109/a112);
  a106=(a113*a109);
  a104=(a104-a106);
  a106=(a006*a023);
  a107=(a032*a078);
  a106=(a106+a107);
  a107=(a080*a094);
  a106=(a106+a107);
  a106=(a013+a106);
  a107=(a104*a106);
  a066=(a066+a107);
  a107=(a014*a100);
  a107=(a107*a103);
  a071=(a107/a110);
  a114=(a018*a028);
  a114=(a114*a103);
  a107=(a113*a107);
  a114=(a114-a107);
  a114=(a114/a112);
  a107=(a113*a114);
  a071=(a071-a107);
  a107=(a071*a187);
  a103=(a018*a103);
  a100=(a100-a028);
  a103=(a103*a100);
  a110=(a103/a110);
  a103=(a113*a103);
  a103=(a015+a103);
  a103=(a103/a112);
  a113=(a113*a103);
  a110=(a110+a113);
  a113=(a006*a054);
  a112=(a032*a008);
  a113=(a113+a112);
  a057=(a077*a057);
  a087=(a090*a087);
  a057=(a057+a087);
  a087=(a053*a072);
  a112=(a084*a094);
  a087=(a087-a112);
  a057=(a057+a087);
  a087=(a080*a057);
  a113=(a113+a087);
  a113=(a023+a113);
  a087=(a110*a113);
  a107=(a107+a087);
  a066=(a066+a107);
  a107=(a099*a066);
  a048=(a048+a107);
  a048=(a218+a048);
  a107=(a096*a048);
  a208=(a208+a107);
  a107=(a108*a164);
  a087=(a116*a030);
  a107=(a107+a087);
  a087=(a117*a101);
  a107=(a107+a087);
  a087=(a118*a066);
  a107=(a107+a087);
  a087=(a125*a127);
  a112=(a126*a123);
  a087=(a087+a112);
  a112=(a125-a087);
  a112=(a007*a112);
  a112=(a112+a125);
  a125=(a112/a130);
  a100=(a007*a087);
  a112=(a133*a112);
  a100=(a100-a112);
  a100=(a100/a132);
  a112=(a133*a100);
  a125=(a125-a112);
  a112=(a089*a218);
  a028=(a097*a065);
  a112=(a112+a028);
  a028=(a098*a072);
  a112=(a112+a028);
  a028=(a099*a187);
  a112=(a112+a028);
  a112=(a009+a112);
  a028=(a125*a112);
  a085=(a007*a123);
  a124=(a124-a120);
  a124=(a120*a124);
  a085=(a085*a124);
  a129=(a129-a085);
  a129=(a129+a126);
  a126=(a133*a129);
  a134=(a134-a126);
  a134=(a134/a132);
  a126=(a134*a123);
  a129=(a129/a130);
  a134=(a133*a134);
  a129=(a129-a134);
  a134=(2.*a129);
  a134=(a134*a123);
  a126=(a126-a134);
  a126=(a126+a087);
  a124=(a127*a124);
  a126=(a126-a124);
  a126=(a007*a126);
  a124=(a126/a130);
  a129=(a129*a123);
  a129=(a129-a087);
  a127=(a127*a083);
  a127=(a127*a083);
  a129=(a129+a127);
  a129=(a007*a129);
  a129=(a129-a029);
  a126=(a133*a126);
  a129=(a129-a126);
  a129=(a129/a132);
  a126=(a133*a129);
  a124=(a124-a126);
  a126=(a089*a023);
  a127=(a097*a078);
  a126=(a126+a127);
  a127=(a098*a094);
  a126=(a126+a127);
  a127=(a099*a113);
  a126=(a126+a127);
  a126=(a013+a126);
  a127=(a124*a126);
  a028=(a028+a127);
  a127=(a014*a120);
  a127=(a127*a123);
  a087=(a127/a130);
  a134=(a018*a083);
  a134=(a134*a123);
  a127=(a133*a127);
  a134=(a134-a127);
  a134=(a134/a132);
  a127=(a133*a134);
  a087=(a087-a127);
  a127=(a087*a048);
  a123=(a018*a123);
  a120=(a120-a083);
  a123=(a123*a120);
  a130=(a123/a130);
  a123=(a133*a123);
  a123=(a015+a123);
  a123=(a123/a132);
  a133=(a133*a123);
  a130=(a130+a133);
  a133=(a089*a054);
  a132=(a097*a008);
  a133=(a133+a132);
  a132=(a098*a057);
  a133=(a133+a132);
  a010=(a093*a010);
  a106=(a109*a106);
  a010=(a010+a106);
  a106=(a114*a187);
  a132=(a103*a113);
  a106=(a106-a132);
  a010=(a010+a106);
  a106=(a099*a010);
  a133=(a133+a106);
  a133=(a023+a133);
  a106=(a130*a133);
  a127=(a127+a106);
  a028=(a028+a127);
  a127=(a119*a028);
  a107=(a107+a127);
  a107=(a218+a107);
  a127=(a115*a107);
  a208=(a208+a127);
  a127=(a128*a164);
  a106=(a136*a030);
  a127=(a127+a106);
  a106=(a137*a101);
  a127=(a127+a106);
  a106=(a138*a066);
  a127=(a127+a106);
  a106=(a139*a028);
  a127=(a127+a106);
  a106=(a146*a148);
  a132=(a147*a144);
  a106=(a106+a132);
  a132=(a146-a106);
  a132=(a007*a132);
  a132=(a132+a146);
  a146=(a132/a151);
  a120=(a007*a106);
  a132=(a154*a132);
  a120=(a120-a132);
  a120=(a120/a153);
  a132=(a154*a120);
  a146=(a146-a132);
  a132=(a108*a218);
  a083=(a116*a065);
  a132=(a132+a083);
  a083=(a117*a072);
  a132=(a132+a083);
  a083=(a118*a187);
  a132=(a132+a083);
  a083=(a119*a048);
  a132=(a132+a083);
  a132=(a009+a132);
  a083=(a146*a132);
  a085=(a007*a144);
  a145=(a145-a141);
  a145=(a141*a145);
  a085=(a085*a145);
  a150=(a150-a085);
  a150=(a150+a147);
  a147=(a154*a150);
  a155=(a155-a147);
  a155=(a155/a153);
  a147=(a155*a144);
  a150=(a150/a151);
  a155=(a154*a155);
  a150=(a150-a155);
  a155=(2.*a150);
  a155=(a155*a144);
  a147=(a147-a155);
  a147=(a147+a106);
  a145=(a148*a145);
  a147=(a147-a145);
  a147=(a007*a147);
  a145=(a147/a151);
  a150=(a150*a144);
  a150=(a150-a106);
  a148=(a148*a102);
  a148=(a148*a102);
  a150=(a150+a148);
  a150=(a007*a150);
  a150=(a150-a029);
  a147=(a154*a147);
  a150=(a150-a147);
  a150=(a150/a153);
  a147=(a154*a150);
  a145=(a145-a147);
  a147=(a108*a023);
  a148=(a116*a078);
  a147=(a147+a148);
  a148=(a117*a094);
  a147=(a147+a148);
  a148=(a118*a113);
  a147=(a147+a148);
  a148=(a119*a133);
  a147=(a147+a148);
  a147=(a013+a147);
  a148=(a145*a147);
  a083=(a083+a148);
  a148=(a014*a141);
  a148=(a148*a144);
  a106=(a148/a151);
  a155=(a018*a102);
  a155=(a155*a144);
  a148=(a154*a148);
  a155=(a155-a148);
  a155=(a155/a153);
  a148=(a154*a155);
  a106=(a106-a148);
  a148=(a106*a107);
  a144=(a018*a144);
  a141=(a141-a102);
  a144=(a144*a141);
  a151=(a144/a151);
  a144=(a154*a144);
  a144=(a015+a144);
  a144=(a144/a153);
  a154=(a154*a144);
  a151=(a151+a154);
  a154=(a108*a054);
  a153=(a116*a008);
  a154=(a154+a153);
  a153=(a117*a057);
  a154=(a154+a153);
  a153=(a118*a010);
  a154=(a154+a153);
  a112=(a100*a112);
  a126=(a129*a126);
  a112=(a112+a126);
  a126=(a134*a048);
  a153=(a123*a133);
  a126=(a126-a153);
  a112=(a112+a126);
  a126=(a119*a112);
  a154=(a154+a126);
  a154=(a023+a154);
  a126=(a151*a154);
  a148=(a148+a126);
  a083=(a083+a148);
  a148=(a140*a083);
  a127=(a127+a148);
  a127=(a218+a127);
  a148=(a135*a127);
  a208=(a208+a148);
  a148=(a149*a164);
  a126=(a157*a030);
  a148=(a148+a126);
  a126=(a158*a101);
  a148=(a148+a126);
  a126=(a159*a066);
  a148=(a148+a126);
  a126=(a160*a028);
  a148=(a148+a126);
  a126=(a161*a083);
  a148=(a148+a126);
  a126=(a168*a170);
  a153=(a169*a166);
  a126=(a126+a153);
  a153=(a168-a126);
  a153=(a007*a153);
  a153=(a153+a168);
  a168=(a153/a173);
  a141=(a007*a126);
  a153=(a176*a153);
  a141=(a141-a153);
  a141=(a141/a175);
  a153=(a176*a141);
  a168=(a168-a153);
  a153=(a128*a218);
  a102=(a136*a065);
  a153=(a153+a102);
  a102=(a137*a072);
  a153=(a153+a102);
  a102=(a138*a187);
  a153=(a153+a102);
  a102=(a139*a048);
  a153=(a153+a102);
  a102=(a140*a107);
  a153=(a153+a102);
  a153=(a009+a153);
  a102=(a168*a153);
  a085=(a007*a166);
  a167=(a167-a163);
  a167=(a163*a167);
  a085=(a085*a167);
  a172=(a172-a085);
  a172=(a172+a169);
  a169=(a176*a172);
  a177=(a177-a169);
  a177=(a177/a175);
  a169=(a177*a166);
  a172=(a172/a173);
  a177=(a176*a177);
  a172=(a172-a177);
  a177=(2.*a172);
  a177=(a177*a166);
  a169=(a169-a177);
  a169=(a169+a126);
  a167=(a170*a167);
  a169=(a169-a167);
  a169=(a007*a169);
  a167=(a169/a173);
  a172=(a172*a166);
  a172=(a172-a126);
  a170=(a170*a122);
  a170=(a170*a122);
  a172=(a172+a170);
  a172=(a007*a172);
  a172=(a172-a029);
  a169=(a176*a169);
  a172=(a172-a169);
  a172=(a172/a175);
  a169=(a176*a172);
  a167=(a167-a169);
  a169=(a128*a023);
  a170=(a136*a078);
  a169=(a169+a170);
  a170=(a137*a094);
  a169=(a169+a170);
  a170=(a138*a113);
  a169=(a169+a170);
  a170=(a139*a133);
  a169=(a169+a170);
  a170=(a140*a154);
  a169=(a169+a170);
  a169=(a013+a169);
  a170=(a167*a169);
  a102=(a102+a170);
  a170=(a014*a163);
  a170=(a170*a166);
  a126=(a170/a173);
  a177=(a018*a122);
  a177=(a177*a166);
  a170=(a176*a170);
  a177=(a177-a170);
  a177=(a177/a175);
  a170=(a176*a177);
  a126=(a126-a170);
  a170=(a126*a127);
  a166=(a018*a166);
  a163=(a163-a122);
  a166=(a166*a163);
  a173=(a166/a173);
  a166=(a176*a166);
  a166=(a015+a166);
  a166=(a166/a175);
  a176=(a176*a166);
  a173=(a173+a176);
  a176=(a128*a054);
  a175=(a136*a008);
  a176=(a176+a175);
  a175=(a137*a057);
  a176=(a176+a175);
  a175=(a138*a010);
  a176=(a176+a175);
  a175=(a139*a112);
  a176=(a176+a175);
  a132=(a120*a132);
  a147=(a150*a147);
  a132=(a132+a147);
  a147=(a155*a107);
  a175=(a144*a154);
  a147=(a147-a175);
  a132=(a132+a147);
  a147=(a140*a132);
  a176=(a176+a147);
  a176=(a023+a176);
  a147=(a173*a176);
  a170=(a170+a147);
  a102=(a102+a170);
  a170=(a162*a102);
  a148=(a148+a170);
  a148=(a218+a148);
  a170=(a156*a148);
  a208=(a208+a170);
  a170=(a171*a164);
  a147=(a179*a030);
  a170=(a170+a147);
  a147=(a180*a101);
  a170=(a170+a147);
  a147=(a181*a066);
  a170=(a170+a147);
  a147=(a182*a028);
  a170=(a170+a147);
  a147=(a183*a083);
  a170=(a170+a147);
  a147=(a184*a102);
  a170=(a170+a147);
  a147=(a191*a193);
  a175=(a192*a189);
  a147=(a147+a175);
  a175=(a191-a147);
  a175=(a007*a175);
  a175=(a175+a191);
  a191=(a175/a196);
  a163=(a007*a147);
  a175=(a199*a175);
  a163=(a163-a175);
  a163=(a163/a198);
  a175=(a199*a163);
  a191=(a191-a175);
  a175=(a149*a218);
  a122=(a157*a065);
  a175=(a175+a122);
  a122=(a158*a072);
  a175=(a175+a122);
  a122=(a159*a187);
  a175=(a175+a122);
  a122=(a160*a048);
  a175=(a175+a122);
  a122=(a161*a107);
  a175=(a175+a122);
  a122=(a162*a127);
  a175=(a175+a122);
  a175=(a009+a175);
  a122=(a191*a175);
  a085=(a007*a189);
  a190=(a190-a186);
  a190=(a186*a190);
  a085=(a085*a190);
  a195=(a195-a085);
  a195=(a195+a192);
  a192=(a199*a195);
  a200=(a200-a192);
  a200=(a200/a198);
  a192=(a200*a189);
  a195=(a195/a196);
  a200=(a199*a200);
  a195=(a195-a200);
  a200=(2.*a195);
  a200=(a200*a189);
  a192=(a192-a200);
  a192=(a192+a147);
  a190=(a193*a190);
  a192=(a192-a190);
  a192=(a007*a192);
  a190=(a192/a196);
  a195=(a195*a189);
  a195=(a195-a147);
  a193=(a193*a143);
  a193=(a193*a143);
  a195=(a195+a193);
  a195=(a007*a195);
  a195=(a195-a029);
  a192=(a199*a192);
  a195=(a195-a192);
  a195=(a195/a198);
  a192=(a199*a195);
  a190=(a190-a192);
  a192=(a149*a023);
  a193=(a157*a078);
  a192=(a192+a193);
  a193=(a158*a094);
  a192=(a192+a193);
  a193=(a159*a113);
  a192=(a192+a193);
  a193=(a160*a133);
  a192=(a192+a193);
  a193=(a161*a154);
  a192=(a192+a193);
  a193=(a162*a176);
  a192=(a192+a193);
  a192=(a013+a192);
  a193=(a190*a192);
  a122=(a122+a193);
  a193=(a014*a186);
  a193=(a193*a189);
  a147=(a193/a196);
  a200=(a018*a143);
  a200=(a200*a189);
  a193=(a199*a193);
  a200=(a200-a193);
  a200=(a200/a198);
  a193=(a199*a200);
  a147=(a147-a193);
  a193=(a147*a148);
  a189=(a018*a189);
  a186=(a186-a143);
  a189=(a189*a186);
  a196=(a189/a196);
  a189=(a199*a189);
  a189=(a015+a189);
  a189=(a189/a198);
  a199=(a199*a189);
  a196=(a196+a199);
  a199=(a149*a054);
  a198=(a157*a008);
  a199=(a199+a198);
  a198=(a158*a057);
  a199=(a199+a198);
  a198=(a159*a010);
  a199=(a199+a198);
  a198=(a160*a112);
  a199=(a199+a198);
  a198=(a161*a132);
  a199=(a199+a198);
  a153=(a141*a153);
  a169=(a172*a169);
  a153=(a153+a169);
  a169=(a177*a127);
  a198=(a166*a176);
  a169=(a169-a198);
  a153=(a153+a169);
  a169=(a162*a153);
  a199=(a199+a169);
  a199=(a023+a199);
  a169=(a196*a199);
  a193=(a193+a169);
  a122=(a122+a193);
  a193=(a185*a122);
  a170=(a170+a193);
  a170=(a218+a170);
  a193=(a178*a170);
  a208=(a208+a193);
  a193=(a194*a164);
  a030=(a202*a030);
  a193=(a193+a030);
  a101=(a076*a101);
  a193=(a193+a101);
  a101=(a092*a066);
  a193=(a193+a101);
  a101=(a203*a028);
  a193=(a193+a101);
  a101=(a204*a083);
  a193=(a193+a101);
  a101=(a205*a102);
  a193=(a193+a101);
  a101=(a206*a122);
  a193=(a193+a101);
  a101=(a212*a214);
  a030=(a213*a210);
  a101=(a101+a030);
  a030=(a212-a101);
  a030=(a007*a030);
  a030=(a030+a212);
  a212=(a030/a217);
  a169=(a007*a101);
  a030=(a220*a030);
  a169=(a169-a030);
  a169=(a169/a219);
  a030=(a220*a169);
  a212=(a212-a030);
  a030=(a171*a218);
  a198=(a179*a065);
  a030=(a030+a198);
  a198=(a180*a072);
  a030=(a030+a198);
  a198=(a181*a187);
  a030=(a030+a198);
  a198=(a182*a048);
  a030=(a030+a198);
  a198=(a183*a107);
  a030=(a030+a198);
  a198=(a184*a127);
  a030=(a030+a198);
  a198=(a185*a148);
  a030=(a030+a198);
  a030=(a009+a030);
  a198=(a212*a030);
  a186=(a007*a210);
  a211=(a211-a002);
  a211=(a002*a211);
  a186=(a186*a211);
  a216=(a216-a186);
  a216=(a216+a213);
  a213=(a220*a216);
  a221=(a221-a213);
  a221=(a221/a219);
  a213=(a221*a210);
  a216=(a216/a217);
  a221=(a220*a221);
  a216=(a216-a221);
  a221=(2.*a216);
  a221=(a221*a210);
  a213=(a213-a221);
  a213=(a213+a101);
  a211=(a214*a211);
  a213=(a213-a211);
  a213=(a007*a213);
  a211=(a213/a217);
  a216=(a216*a210);
  a216=(a216-a101);
  a214=(a214*a165);
  a214=(a214*a165);
  a216=(a216+a214);
  a216=(a007*a216);
  a216=(a216-a029);
  a213=(a220*a213);
  a216=(a216-a213);
  a216=(a216/a219);
  a213=(a220*a216);
  a211=(a211-a213);
  a213=(a171*a023);
  a214=(a179*a078);
  a213=(a213+a214);
  a214=(a180*a094);
  a213=(a213+a214);
  a214=(a181*a113);
  a213=(a213+a214);
  a214=(a182*a133);
  a213=(a213+a214);
  a214=(a183*a154);
  a213=(a213+a214);
  a214=(a184*a176);
  a213=(a213+a214);
  a214=(a185*a199);
  a213=(a213+a214);
  a213=(a013+a213);
  a214=(a211*a213);
  a198=(a198+a214);
  a214=(a014*a002);
  a214=(a214*a210);
  a101=(a214/a217);
  a221=(a018*a165);
  a221=(a221*a210);
  a214=(a220*a214);
  a221=(a221-a214);
  a221=(a221/a219);
  a214=(a220*a221);
  a101=(a101-a214);
  a214=(a101*a170);
  a210=(a018*a210);
  a002=(a002-a165);
  a210=(a210*a002);
  a217=(a210/a217);
  a210=(a220*a210);
  a210=(a015+a210);
  a210=(a210/a219);
  a220=(a220*a210);
  a217=(a217+a220);
  a220=(a171*a054);
  a219=(a179*a008);
  a220=(a220+a219);
  a219=(a180*a057);
  a220=(a220+a219);
  a219=(a181*a010);
  a220=(a220+a219);
  a219=(a182*a112);
  a220=(a220+a219);
  a219=(a183*a132);
  a220=(a220+a219);
  a219=(a184*a153);
  a220=(a220+a219);
  a175=(a163*a175);
  a192=(a195*a192);
  a175=(a175+a192);
  a192=(a200*a148);
  a219=(a189*a199);
  a192=(a192-a219);
  a175=(a175+a192);
  a192=(a185*a175);
  a220=(a220+a192);
  a220=(a023+a220);
  a192=(a217*a220);
  a214=(a214+a192);
  a198=(a198+a214);
  a214=(a207*a198);
  a193=(a193+a214);
  a193=(a218+a193);
  a214=(a201*a193);
  a208=(a208+a214);
  a208=(a009+a208);
  if (res[0]!=0) res[0][4]=a208;
  a208=(a001*a023);
  a214=(a005*a113);
  a208=(a208+a214);
  a214=(a096*a133);
  a208=(a208+a214);
  a214=(a115*a154);
  a208=(a208+a214);
  a214=(a135*a176);
  a208=(a208+a214);
  a214=(a156*a199);
  a208=(a208+a214);
  a214=(a178*a220);
  a208=(a208+a214);
  a214=(a194*a054);
  a008=(a202*a008);
  a214=(a214+a008);
  a057=(a076*a057);
  a214=(a214+a057);
  a057=(a092*a010);
  a214=(a214+a057);
  a057=(a203*a112);
  a214=(a214+a057);
  a057=(a204*a132);
  a214=(a214+a057);
  a057=(a205*a153);
  a214=(a214+a057);
  a057=(a206*a175);
  a214=(a214+a057);
  a030=(a169*a030);
  a213=(a216*a213);
  a030=(a030+a213);
  a213=(a221*a170);
  a057=(a210*a220);
  a213=(a213-a057);
  a030=(a030+a213);
  a213=(a207*a030);
  a214=(a214+a213);
  a214=(a023+a214);
  a213=(a201*a214);
  a208=(a208+a213);
  a208=(a013+a208);
  if (res[0]!=0) res[0][5]=a208;
  a164=(a001*a164);
  a066=(a005*a066);
  a164=(a164+a066);
  a028=(a096*a028);
  a164=(a164+a028);
  a083=(a115*a083);
  a164=(a164+a083);
  a102=(a135*a102);
  a164=(a164+a102);
  a122=(a156*a122);
  a164=(a164+a122);
  a198=(a178*a198);
  a164=(a164+a198);
  a198=(a000*a131);
  a122=(a152*a197);
  a198=(a198+a122);
  a122=(a000-a198);
  a122=(a007*a122);
  a122=(a122+a000);
  a000=(a122/a082);
  a102=(a007*a198);
  a122=(a209*a122);
  a102=(a102-a122);
  a102=(a102/a215);
  a122=(a209*a102);
  a000=(a000-a122);
  a122=(a194*a218);
  a065=(a202*a065);
  a122=(a122+a065);
  a072=(a076*a072);
  a122=(a122+a072);
  a187=(a092*a187);
  a122=(a122+a187);
  a048=(a203*a048);
  a122=(a122+a048);
  a107=(a204*a107);
  a122=(a122+a107);
  a127=(a205*a127);
  a122=(a122+a127);
  a148=(a206*a148);
  a122=(a122+a148);
  a170=(a207*a170);
  a122=(a122+a170);
  a009=(a009+a122);
  a122=(a000*a009);
  a170=(a007*a197);
  a174=(a174-a222);
  a174=(a222*a174);
  a170=(a170*a174);
  a004=(a004-a170);
  a004=(a004+a152);
  a152=(a209*a004);
  a223=(a223-a152);
  a223=(a223/a215);
  a152=(a223*a197);
  a004=(a004/a082);
  a223=(a209*a223);
  a004=(a004-a223);
  a223=(2.*a004);
  a223=(a223*a197);
  a152=(a152-a223);
  a152=(a152+a198);
  a174=(a131*a174);
  a152=(a152-a174);
  a152=(a007*a152);
  a174=(a152/a082);
  a004=(a004*a197);
  a004=(a004-a198);
  a131=(a131*a188);
  a131=(a131*a188);
  a004=(a004+a131);
  a007=(a007*a004);
  a007=(a007-a029);
  a152=(a209*a152);
  a007=(a007-a152);
  a007=(a007/a215);
  a152=(a209*a007);
  a174=(a174-a152);
  a152=(a194*a023);
  a078=(a202*a078);
  a152=(a152+a078);
  a094=(a076*a094);
  a152=(a152+a094);
  a113=(a092*a113);
  a152=(a152+a113);
  a133=(a203*a133);
  a152=(a152+a133);
  a154=(a204*a154);
  a152=(a152+a154);
  a176=(a205*a176);
  a152=(a152+a176);
  a199=(a206*a199);
  a152=(a152+a199);
  a220=(a207*a220);
  a152=(a152+a220);
  a013=(a013+a152);
  a152=(a174*a013);
  a122=(a122+a152);
  a014=(a014*a222);
  a014=(a014*a197);
  a152=(a014/a082);
  a220=(a018*a188);
  a220=(a220*a197);
  a014=(a209*a014);
  a220=(a220-a014);
  a220=(a220/a215);
  a014=(a209*a220);
  a152=(a152-a014);
  a014=(a152*a193);
  a018=(a018*a197);
  a222=(a222-a188);
  a018=(a018*a222);
  a082=(a018/a082);
  a018=(a209*a018);
  a015=(a015+a018);
  a015=(a015/a215);
  a209=(a209*a015);
  a082=(a082+a209);
  a209=(a082*a214);
  a014=(a014+a209);
  a122=(a122+a014);
  a122=(a201*a122);
  a164=(a164+a122);
  a218=(a218+a164);
  if (res[0]!=0) res[0][6]=a218;
  a054=(a001*a054);
  a010=(a005*a010);
  a054=(a054+a010);
  a112=(a096*a112);
  a054=(a054+a112);
  a132=(a115*a132);
  a054=(a054+a132);
  a153=(a135*a153);
  a054=(a054+a153);
  a175=(a156*a175);
  a054=(a054+a175);
  a030=(a178*a030);
  a054=(a054+a030);
  a009=(a102*a009);
  a013=(a007*a013);
  a009=(a009+a013);
  a193=(a220*a193);
  a214=(a015*a214);
  a193=(a193-a214);
  a009=(a009+a193);
  a009=(a201*a009);
  a054=(a054+a009);
  a023=(a023+a054);
  if (res[0]!=0) res[0][7]=a023;
  a023=arg[0]? arg[0][8] : 0;
  a054=arg[0]? arg[0][10] : 0;
  a009=(a001*a054);
  a193=(a016*a023);
  a214=arg[0]? arg[0][9] : 0;
  a013=(a012*a214);
  a193=(a193+a013);
  a013=(a024*a054);
  a030=arg[0]? arg[0][11] : 0;
  a175=(a020*a030);
  a013=(a013+a175);
  a193=(a193+a013);
  a013=(a006*a193);
  a175=(a033*a054);
  a153=(a036*a193);
  a132=(a039*a054);
  a132=(a023+a132);
  a112=(a046*a132);
  a010=(a039*a030);
  a010=(a214+a010);
  a218=(a045*a010);
  a112=(a112+a218);
  a218=(a039*a193);
  a218=(a054+a218);
  a164=(a021*a218);
  a122=(a142*a023);
  a014=(a017*a214);
  a122=(a122+a014);
  a014=(a121*a054);
  a209=(a011*a030);
  a014=(a014-a209);
  a122=(a122+a014);
  a014=(a039*a122);
  a014=(a030+a014);
  a209=(a051*a014);
  a164=(a164+a209);
  a112=(a112+a164);
  a112=(a038*a112);
  a153=(a153+a112);
  a153=(a054+a153);
  a112=(a035*a153);
  a175=(a175+a112);
  a175=(a023+a175);
  a112=(a070*a175);
  a164=(a033*a030);
  a209=(a036*a122);
  a132=(a026*a132);
  a010=(a050*a010);
  a132=(a132+a010);
  a010=(a055*a218);
  a215=(a043*a014);
  a010=(a010-a215);
  a132=(a132+a010);
  a132=(a038*a132);
  a209=(a209+a132);
  a209=(a030+a209);
  a132=(a035*a209);
  a164=(a164+a132);
  a164=(a214+a164);
  a132=(a069*a164);
  a112=(a112+a132);
  a132=(a033*a193);
  a010=(a036*a054);
  a218=(a038*a218);
  a010=(a010+a218);
  a010=(a023+a010);
  a218=(a042*a010);
  a215=(a036*a030);
  a014=(a038*a014);
  a215=(a215+a014);
  a215=(a214+a215);
  a014=(a063*a215);
  a218=(a218+a014);
  a014=(a058*a153);
  a018=(a041*a209);
  a014=(a014+a018);
  a218=(a218+a014);
  a014=(a035*a218);
  a132=(a132+a014);
  a132=(a054+a132);
  a014=(a047*a132);
  a018=(a033*a122);
  a010=(a040*a010);
  a215=(a059*a215);
  a010=(a010+a215);
  a215=(a079*a153);
  a222=(a049*a209);
  a215=(a215-a222);
  a010=(a010+a215);
  a215=(a035*a010);
  a018=(a018+a215);
  a018=(a030+a018);
  a215=(a075*a018);
  a014=(a014+a215);
  a112=(a112+a014);
  a014=(a032*a112);
  a013=(a013+a014);
  a014=(a073*a054);
  a153=(a081*a153);
  a014=(a014+a153);
  a153=(a064*a132);
  a014=(a014+a153);
  a014=(a023+a014);
  a153=(a086*a014);
  a215=(a073*a030);
  a209=(a081*a209);
  a215=(a215+a209);
  a209=(a064*a018);
  a215=(a215+a209);
  a215=(a214+a215);
  a209=(a062*a215);
  a153=(a153+a209);
  a209=(a073*a193);
  a218=(a081*a218);
  a209=(a209+a218);
  a218=(a064*a112);
  a209=(a209+a218);
  a209=(a054+a209);
  a218=(a088*a209);
  a222=(a073*a122);
  a010=(a081*a010);
  a222=(a222+a010);
  a175=(a003*a175);
  a164=(a074*a164);
  a175=(a175+a164);
  a164=(a022*a132);
  a010=(a067*a018);
  a164=(a164-a010);
  a175=(a175+a164);
  a164=(a064*a175);
  a222=(a222+a164);
  a222=(a030+a222);
  a164=(a091*a222);
  a218=(a218+a164);
  a153=(a153+a218);
  a218=(a080*a153);
  a013=(a013+a218);
  a013=(a054+a013);
  a218=(a005*a013);
  a009=(a009+a218);
  a218=(a089*a193);
  a164=(a097*a112);
  a218=(a218+a164);
  a164=(a098*a153);
  a218=(a218+a164);
  a164=(a006*a054);
  a010=(a032*a132);
  a164=(a164+a010);
  a010=(a080*a209);
  a164=(a164+a010);
  a164=(a023+a164);
  a010=(a105*a164);
  a188=(a006*a030);
  a197=(a032*a018);
  a188=(a188+a197);
  a197=(a080*a222);
  a188=(a188+a197);
  a188=(a214+a188);
  a197=(a104*a188);
  a010=(a010+a197);
  a197=(a071*a013);
  a199=(a006*a122);
  a176=(a032*a175);
  a199=(a199+a176);
  a014=(a077*a014);
  a215=(a090*a215);
  a014=(a014+a215);
  a215=(a053*a209);
  a176=(a084*a222);
  a215=(a215-a176);
  a014=(a014+a215);
  a215=(a080*a014);
  a199=(a199+a215);
  a199=(a030+a199);
  a215=(a110*a199);
  a197=(a197+a215);
  a010=(a010+a197);
  a197=(a099*a010);
  a218=(a218+a197);
  a218=(a054+a218);
  a197=(a096*a218);
  a009=(a009+a197);
  a197=(a108*a193);
  a215=(a116*a112);
  a197=(a197+a215);
  a215=(a117*a153);
  a197=(a197+a215);
  a215=(a118*a010);
  a197=(a197+a215);
  a215=(a089*a054);
  a176=(a097*a132);
  a215=(a215+a176);
  a176=(a098*a209);
  a215=(a215+a176);
  a176=(a099*a013);
  a215=(a215+a176);
  a215=(a023+a215);
  a176=(a125*a215);
  a154=(a089*a030);
  a133=(a097*a018);
  a154=(a154+a133);
  a133=(a098*a222);
  a154=(a154+a133);
  a133=(a099*a199);
  a154=(a154+a133);
  a154=(a214+a154);
  a133=(a124*a154);
  a176=(a176+a133);
  a133=(a087*a218);
  a113=(a089*a122);
  a094=(a097*a175);
  a113=(a113+a094);
  a094=(a098*a014);
  a113=(a113+a094);
  a164=(a093*a164);
  a188=(a109*a188);
  a164=(a164+a188);
  a188=(a114*a013);
  a094=(a103*a199);
  a188=(a188-a094);
  a164=(a164+a188);
  a188=(a099*a164);
  a113=(a113+a188);
  a113=(a030+a113);
  a188=(a130*a113);
  a133=(a133+a188);
  a176=(a176+a133);
  a133=(a119*a176);
  a197=(a197+a133);
  a197=(a054+a197);
  a133=(a115*a197);
  a009=(a009+a133);
  a133=(a128*a193);
  a188=(a136*a112);
  a133=(a133+a188);
  a188=(a137*a153);
  a133=(a133+a188);
  a188=(a138*a010);
  a133=(a133+a188);
  a188=(a139*a176);
  a133=(a133+a188);
  a188=(a108*a054);
  a094=(a116*a132);
  a188=(a188+a094);
  a094=(a117*a209);
  a188=(a188+a094);
  a094=(a118*a013);
  a188=(a188+a094);
  a094=(a119*a218);
  a188=(a188+a094);
  a188=(a023+a188);
  a094=(a146*a188);
  a078=(a108*a030);
  a029=(a116*a018);
  a078=(a078+a029);
  a029=(a117*a222);
  a078=(a078+a029);
  a029=(a118*a199);
  a078=(a078+a029);
  a029=(a119*a113);
  a078=(a078+a029);
  a078=(a214+a078);
  a029=(a145*a078);
  a094=(a094+a029);
  a029=(a106*a197);
  a004=(a108*a122);
  a131=(a116*a175);
  a004=(a004+a131);
  a131=(a117*a014);
  a004=(a004+a131);
  a131=(a118*a164);
  a004=(a004+a131);
  a215=(a100*a215);
  a154=(a129*a154);
  a215=(a215+a154);
  a154=(a134*a218);
  a131=(a123*a113);
  a154=(a154-a131);
  a215=(a215+a154);
  a154=(a119*a215);
  a004=(a004+a154);
  a004=(a030+a004);
  a154=(a151*a004);
  a029=(a029+a154);
  a094=(a094+a029);
  a029=(a140*a094);
  a133=(a133+a029);
  a133=(a054+a133);
  a029=(a135*a133);
  a009=(a009+a029);
  a029=(a149*a193);
  a154=(a157*a112);
  a029=(a029+a154);
  a154=(a158*a153);
  a029=(a029+a154);
  a154=(a159*a010);
  a029=(a029+a154);
  a154=(a160*a176);
  a029=(a029+a154);
  a154=(a161*a094);
  a029=(a029+a154);
  a154=(a128*a054);
  a131=(a136*a132);
  a154=(a154+a131);
  a131=(a137*a209);
  a154=(a154+a131);
  a131=(a138*a013);
  a154=(a154+a131);
  a131=(a139*a218);
  a154=(a154+a131);
  a131=(a140*a197);
  a154=(a154+a131);
  a154=(a023+a154);
  a131=(a168*a154);
  a198=(a128*a030);
  a223=(a136*a018);
  a198=(a198+a223);
  a223=(a137*a222);
  a198=(a198+a223);
  a223=(a138*a199);
  a198=(a198+a223);
  a223=(a139*a113);
  a198=(a198+a223);
  a223=(a140*a004);
  a198=(a198+a223);
  a198=(a214+a198);
  a223=(a167*a198);
  a131=(a131+a223);
  a223=(a126*a133);
  a170=(a128*a122);
  a148=(a136*a175);
  a170=(a170+a148);
  a148=(a137*a014);
  a170=(a170+a148);
  a148=(a138*a164);
  a170=(a170+a148);
  a148=(a139*a215);
  a170=(a170+a148);
  a188=(a120*a188);
  a078=(a150*a078);
  a188=(a188+a078);
  a078=(a155*a197);
  a148=(a144*a004);
  a078=(a078-a148);
  a188=(a188+a078);
  a078=(a140*a188);
  a170=(a170+a078);
  a170=(a030+a170);
  a078=(a173*a170);
  a223=(a223+a078);
  a131=(a131+a223);
  a223=(a162*a131);
  a029=(a029+a223);
  a029=(a054+a029);
  a223=(a156*a029);
  a009=(a009+a223);
  a223=(a171*a193);
  a078=(a179*a112);
  a223=(a223+a078);
  a078=(a180*a153);
  a223=(a223+a078);
  a078=(a181*a010);
  a223=(a223+a078);
  a078=(a182*a176);
  a223=(a223+a078);
  a078=(a183*a094);
  a223=(a223+a078);
  a078=(a184*a131);
  a223=(a223+a078);
  a078=(a149*a054);
  a148=(a157*a132);
  a078=(a078+a148);
  a148=(a158*a209);
  a078=(a078+a148);
  a148=(a159*a013);
  a078=(a078+a148);
  a148=(a160*a218);
  a078=(a078+a148);
  a148=(a161*a197);
  a078=(a078+a148);
  a148=(a162*a133);
  a078=(a078+a148);
  a078=(a023+a078);
  a148=(a191*a078);
  a127=(a149*a030);
  a107=(a157*a018);
  a127=(a127+a107);
  a107=(a158*a222);
  a127=(a127+a107);
  a107=(a159*a199);
  a127=(a127+a107);
  a107=(a160*a113);
  a127=(a127+a107);
  a107=(a161*a004);
  a127=(a127+a107);
  a107=(a162*a170);
  a127=(a127+a107);
  a127=(a214+a127);
  a107=(a190*a127);
  a148=(a148+a107);
  a107=(a147*a029);
  a048=(a149*a122);
  a187=(a157*a175);
  a048=(a048+a187);
  a187=(a158*a014);
  a048=(a048+a187);
  a187=(a159*a164);
  a048=(a048+a187);
  a187=(a160*a215);
  a048=(a048+a187);
  a187=(a161*a188);
  a048=(a048+a187);
  a154=(a141*a154);
  a198=(a172*a198);
  a154=(a154+a198);
  a198=(a177*a133);
  a187=(a166*a170);
  a198=(a198-a187);
  a154=(a154+a198);
  a198=(a162*a154);
  a048=(a048+a198);
  a048=(a030+a048);
  a198=(a196*a048);
  a107=(a107+a198);
  a148=(a148+a107);
  a107=(a185*a148);
  a223=(a223+a107);
  a223=(a054+a223);
  a107=(a178*a223);
  a009=(a009+a107);
  a107=(a194*a193);
  a112=(a202*a112);
  a107=(a107+a112);
  a153=(a076*a153);
  a107=(a107+a153);
  a153=(a092*a010);
  a107=(a107+a153);
  a153=(a203*a176);
  a107=(a107+a153);
  a153=(a204*a094);
  a107=(a107+a153);
  a153=(a205*a131);
  a107=(a107+a153);
  a153=(a206*a148);
  a107=(a107+a153);
  a153=(a171*a054);
  a112=(a179*a132);
  a153=(a153+a112);
  a112=(a180*a209);
  a153=(a153+a112);
  a112=(a181*a013);
  a153=(a153+a112);
  a112=(a182*a218);
  a153=(a153+a112);
  a112=(a183*a197);
  a153=(a153+a112);
  a112=(a184*a133);
  a153=(a153+a112);
  a112=(a185*a029);
  a153=(a153+a112);
  a153=(a023+a153);
  a112=(a212*a153);
  a198=(a171*a030);
  a187=(a179*a018);
  a198=(a198+a187);
  a187=(a180*a222);
  a198=(a198+a187);
  a187=(a181*a199);
  a198=(a198+a187);
  a187=(a182*a113);
  a198=(a198+a187);
  a187=(a183*a004);
  a198=(a198+a187);
  a187=(a184*a170);
  a198=(a198+a187);
  a187=(a185*a048);
  a198=(a198+a187);
  a198=(a214+a198);
  a187=(a211*a198);
  a112=(a112+a187);
  a187=(a101*a223);
  a072=(a171*a122);
  a065=(a179*a175);
  a072=(a072+a065);
  a065=(a180*a014);
  a072=(a072+a065);
  a065=(a181*a164);
  a072=(a072+a065);
  a065=(a182*a215);
  a072=(a072+a065);
  a065=(a183*a188);
  a072=(a072+a065);
  a065=(a184*a154);
  a072=(a072+a065);
  a078=(a163*a078);
  a127=(a195*a127);
  a078=(a078+a127);
  a127=(a200*a029);
  a065=(a189*a048);
  a127=(a127-a065);
  a078=(a078+a127);
  a127=(a185*a078);
  a072=(a072+a127);
  a072=(a030+a072);
  a127=(a217*a072);
  a187=(a187+a127);
  a112=(a112+a187);
  a187=(a207*a112);
  a107=(a107+a187);
  a107=(a054+a107);
  a187=(a201*a107);
  a009=(a009+a187);
  a009=(a023+a009);
  if (res[0]!=0) res[0][8]=a009;
  a009=(a001*a030);
  a187=(a005*a199);
  a009=(a009+a187);
  a187=(a096*a113);
  a009=(a009+a187);
  a187=(a115*a004);
  a009=(a009+a187);
  a187=(a135*a170);
  a009=(a009+a187);
  a187=(a156*a048);
  a009=(a009+a187);
  a187=(a178*a072);
  a009=(a009+a187);
  a187=(a194*a122);
  a175=(a202*a175);
  a187=(a187+a175);
  a014=(a076*a014);
  a187=(a187+a014);
  a014=(a092*a164);
  a187=(a187+a014);
  a014=(a203*a215);
  a187=(a187+a014);
  a014=(a204*a188);
  a187=(a187+a014);
  a014=(a205*a154);
  a187=(a187+a014);
  a014=(a206*a078);
  a187=(a187+a014);
  a153=(a169*a153);
  a198=(a216*a198);
  a153=(a153+a198);
  a198=(a221*a223);
  a014=(a210*a072);
  a198=(a198-a014);
  a153=(a153+a198);
  a198=(a207*a153);
  a187=(a187+a198);
  a187=(a030+a187);
  a198=(a201*a187);
  a009=(a009+a198);
  a009=(a214+a009);
  if (res[0]!=0) res[0][9]=a009;
  a193=(a001*a193);
  a010=(a005*a010);
  a193=(a193+a010);
  a176=(a096*a176);
  a193=(a193+a176);
  a094=(a115*a094);
  a193=(a193+a094);
  a131=(a135*a131);
  a193=(a193+a131);
  a148=(a156*a148);
  a193=(a193+a148);
  a112=(a178*a112);
  a193=(a193+a112);
  a112=(a194*a054);
  a132=(a202*a132);
  a112=(a112+a132);
  a209=(a076*a209);
  a112=(a112+a209);
  a013=(a092*a013);
  a112=(a112+a013);
  a218=(a203*a218);
  a112=(a112+a218);
  a197=(a204*a197);
  a112=(a112+a197);
  a133=(a205*a133);
  a112=(a112+a133);
  a029=(a206*a029);
  a112=(a112+a029);
  a223=(a207*a223);
  a112=(a112+a223);
  a023=(a023+a112);
  a112=(a000*a023);
  a223=(a194*a030);
  a018=(a202*a018);
  a223=(a223+a018);
  a222=(a076*a222);
  a223=(a223+a222);
  a199=(a092*a199);
  a223=(a223+a199);
  a113=(a203*a113);
  a223=(a223+a113);
  a004=(a204*a004);
  a223=(a223+a004);
  a170=(a205*a170);
  a223=(a223+a170);
  a048=(a206*a048);
  a223=(a223+a048);
  a072=(a207*a072);
  a223=(a223+a072);
  a214=(a214+a223);
  a223=(a174*a214);
  a112=(a112+a223);
  a223=(a152*a107);
  a072=(a082*a187);
  a223=(a223+a072);
  a112=(a112+a223);
  a112=(a201*a112);
  a193=(a193+a112);
  a054=(a054+a193);
  if (res[0]!=0) res[0][10]=a054;
  a122=(a001*a122);
  a164=(a005*a164);
  a122=(a122+a164);
  a215=(a096*a215);
  a122=(a122+a215);
  a188=(a115*a188);
  a122=(a122+a188);
  a154=(a135*a154);
  a122=(a122+a154);
  a078=(a156*a078);
  a122=(a122+a078);
  a153=(a178*a153);
  a122=(a122+a153);
  a023=(a102*a023);
  a214=(a007*a214);
  a023=(a023+a214);
  a107=(a220*a107);
  a187=(a015*a187);
  a107=(a107-a187);
  a023=(a023+a107);
  a023=(a201*a023);
  a122=(a122+a023);
  a030=(a030+a122);
  if (res[0]!=0) res[0][11]=a030;
  a030=arg[0]? arg[0][12] : 0;
  a122=arg[0]? arg[0][14] : 0;
  a023=(a001*a122);
  a016=(a016*a030);
  a107=arg[0]? arg[0][13] : 0;
  a012=(a012*a107);
  a016=(a016+a012);
  a024=(a024*a122);
  a012=arg[0]? arg[0][15] : 0;
  a020=(a020*a012);
  a024=(a024+a020);
  a016=(a016+a024);
  a024=(a006*a016);
  a020=(a033*a122);
  a187=(a036*a016);
  a214=(a039*a122);
  a214=(a030+a214);
  a046=(a046*a214);
  a153=(a039*a012);
  a153=(a107+a153);
  a045=(a045*a153);
  a046=(a046+a045);
  a045=(a039*a016);
  a045=(a122+a045);
  a021=(a021*a045);
  a142=(a142*a030);
  a017=(a017*a107);
  a142=(a142+a017);
  a121=(a121*a122);
  a011=(a011*a012);
  a121=(a121-a011);
  a142=(a142+a121);
  a039=(a039*a142);
  a039=(a012+a039);
  a051=(a051*a039);
  a021=(a021+a051);
  a046=(a046+a021);
  a046=(a038*a046);
  a187=(a187+a046);
  a187=(a122+a187);
  a046=(a035*a187);
  a020=(a020+a046);
  a020=(a030+a020);
  a070=(a070*a020);
  a046=(a033*a012);
  a021=(a036*a142);
  a026=(a026*a214);
  a050=(a050*a153);
  a026=(a026+a050);
  a055=(a055*a045);
  a043=(a043*a039);
  a055=(a055-a043);
  a026=(a026+a055);
  a026=(a038*a026);
  a021=(a021+a026);
  a021=(a012+a021);
  a026=(a035*a021);
  a046=(a046+a026);
  a046=(a107+a046);
  a069=(a069*a046);
  a070=(a070+a069);
  a069=(a033*a016);
  a026=(a036*a122);
  a045=(a038*a045);
  a026=(a026+a045);
  a026=(a030+a026);
  a042=(a042*a026);
  a036=(a036*a012);
  a038=(a038*a039);
  a036=(a036+a038);
  a036=(a107+a036);
  a063=(a063*a036);
  a042=(a042+a063);
  a058=(a058*a187);
  a041=(a041*a021);
  a058=(a058+a041);
  a042=(a042+a058);
  a058=(a035*a042);
  a069=(a069+a058);
  a069=(a122+a069);
  a047=(a047*a069);
  a033=(a033*a142);
  a040=(a040*a026);
  a059=(a059*a036);
  a040=(a040+a059);
  a079=(a079*a187);
  a049=(a049*a021);
  a079=(a079-a049);
  a040=(a040+a079);
  a035=(a035*a040);
  a033=(a033+a035);
  a033=(a012+a033);
  a075=(a075*a033);
  a047=(a047+a075);
  a070=(a070+a047);
  a047=(a032*a070);
  a024=(a024+a047);
  a047=(a073*a122);
  a187=(a081*a187);
  a047=(a047+a187);
  a187=(a064*a069);
  a047=(a047+a187);
  a047=(a030+a047);
  a086=(a086*a047);
  a187=(a073*a012);
  a021=(a081*a021);
  a187=(a187+a021);
  a021=(a064*a033);
  a187=(a187+a021);
  a187=(a107+a187);
  a062=(a062*a187);
  a086=(a086+a062);
  a062=(a073*a016);
  a042=(a081*a042);
  a062=(a062+a042);
  a042=(a064*a070);
  a062=(a062+a042);
  a062=(a122+a062);
  a088=(a088*a062);
  a073=(a073*a142);
  a081=(a081*a040);
  a073=(a073+a081);
  a003=(a003*a020);
  a074=(a074*a046);
  a003=(a003+a074);
  a022=(a022*a069);
  a067=(a067*a033);
  a022=(a022-a067);
  a003=(a003+a022);
  a064=(a064*a003);
  a073=(a073+a064);
  a073=(a012+a073);
  a091=(a091*a073);
  a088=(a088+a091);
  a086=(a086+a088);
  a088=(a080*a086);
  a024=(a024+a088);
  a024=(a122+a024);
  a088=(a005*a024);
  a023=(a023+a088);
  a088=(a089*a016);
  a091=(a097*a070);
  a088=(a088+a091);
  a091=(a098*a086);
  a088=(a088+a091);
  a091=(a006*a122);
  a064=(a032*a069);
  a091=(a091+a064);
  a064=(a080*a062);
  a091=(a091+a064);
  a091=(a030+a091);
  a105=(a105*a091);
  a064=(a006*a012);
  a022=(a032*a033);
  a064=(a064+a022);
  a022=(a080*a073);
  a064=(a064+a022);
  a064=(a107+a064);
  a104=(a104*a064);
  a105=(a105+a104);
  a071=(a071*a024);
  a006=(a006*a142);
  a032=(a032*a003);
  a006=(a006+a032);
  a077=(a077*a047);
  a090=(a090*a187);
  a077=(a077+a090);
  a053=(a053*a062);
  a084=(a084*a073);
  a053=(a053-a084);
  a077=(a077+a053);
  a080=(a080*a077);
  a006=(a006+a080);
  a006=(a012+a006);
  a110=(a110*a006);
  a071=(a071+a110);
  a105=(a105+a071);
  a071=(a099*a105);
  a088=(a088+a071);
  a088=(a122+a088);
  a071=(a096*a088);
  a023=(a023+a071);
  a071=(a108*a016);
  a110=(a116*a070);
  a071=(a071+a110);
  a110=(a117*a086);
  a071=(a071+a110);
  a110=(a118*a105);
  a071=(a071+a110);
  a110=(a089*a122);
  a080=(a097*a069);
  a110=(a110+a080);
  a080=(a098*a062);
  a110=(a110+a080);
  a080=(a099*a024);
  a110=(a110+a080);
  a110=(a030+a110);
  a125=(a125*a110);
  a080=(a089*a012);
  a053=(a097*a033);
  a080=(a080+a053);
  a053=(a098*a073);
  a080=(a080+a053);
  a053=(a099*a006);
  a080=(a080+a053);
  a080=(a107+a080);
  a124=(a124*a080);
  a125=(a125+a124);
  a087=(a087*a088);
  a089=(a089*a142);
  a097=(a097*a003);
  a089=(a089+a097);
  a098=(a098*a077);
  a089=(a089+a098);
  a093=(a093*a091);
  a109=(a109*a064);
  a093=(a093+a109);
  a114=(a114*a024);
  a103=(a103*a006);
  a114=(a114-a103);
  a093=(a093+a114);
  a099=(a099*a093);
  a089=(a089+a099);
  a089=(a012+a089);
  a130=(a130*a089);
  a087=(a087+a130);
  a125=(a125+a087);
  a087=(a119*a125);
  a071=(a071+a087);
  a071=(a122+a071);
  a087=(a115*a071);
  a023=(a023+a087);
  a087=(a128*a016);
  a130=(a136*a070);
  a087=(a087+a130);
  a130=(a137*a086);
  a087=(a087+a130);
  a130=(a138*a105);
  a087=(a087+a130);
  a130=(a139*a125);
  a087=(a087+a130);
  a130=(a108*a122);
  a099=(a116*a069);
  a130=(a130+a099);
  a099=(a117*a062);
  a130=(a130+a099);
  a099=(a118*a024);
  a130=(a130+a099);
  a099=(a119*a088);
  a130=(a130+a099);
  a130=(a030+a130);
  a146=(a146*a130);
  a099=(a108*a012);
  a114=(a116*a033);
  a099=(a099+a114);
  a114=(a117*a073);
  a099=(a099+a114);
  a114=(a118*a006);
  a099=(a099+a114);
  a114=(a119*a089);
  a099=(a099+a114);
  a099=(a107+a099);
  a145=(a145*a099);
  a146=(a146+a145);
  a106=(a106*a071);
  a108=(a108*a142);
  a116=(a116*a003);
  a108=(a108+a116);
  a117=(a117*a077);
  a108=(a108+a117);
  a118=(a118*a093);
  a108=(a108+a118);
  a100=(a100*a110);
  a129=(a129*a080);
  a100=(a100+a129);
  a134=(a134*a088);
  a123=(a123*a089);
  a134=(a134-a123);
  a100=(a100+a134);
  a119=(a119*a100);
  a108=(a108+a119);
  a108=(a012+a108);
  a151=(a151*a108);
  a106=(a106+a151);
  a146=(a146+a106);
  a106=(a140*a146);
  a087=(a087+a106);
  a087=(a122+a087);
  a106=(a135*a087);
  a023=(a023+a106);
  a106=(a149*a016);
  a151=(a157*a070);
  a106=(a106+a151);
  a151=(a158*a086);
  a106=(a106+a151);
  a151=(a159*a105);
  a106=(a106+a151);
  a151=(a160*a125);
  a106=(a106+a151);
  a151=(a161*a146);
  a106=(a106+a151);
  a151=(a128*a122);
  a119=(a136*a069);
  a151=(a151+a119);
  a119=(a137*a062);
  a151=(a151+a119);
  a119=(a138*a024);
  a151=(a151+a119);
  a119=(a139*a088);
  a151=(a151+a119);
  a119=(a140*a071);
  a151=(a151+a119);
  a151=(a030+a151);
  a168=(a168*a151);
  a119=(a128*a012);
  a134=(a136*a033);
  a119=(a119+a134);
  a134=(a137*a073);
  a119=(a119+a134);
  a134=(a138*a006);
  a119=(a119+a134);
  a134=(a139*a089);
  a119=(a119+a134);
  a134=(a140*a108);
  a119=(a119+a134);
  a119=(a107+a119);
  a167=(a167*a119);
  a168=(a168+a167);
  a126=(a126*a087);
  a128=(a128*a142);
  a136=(a136*a003);
  a128=(a128+a136);
  a137=(a137*a077);
  a128=(a128+a137);
  a138=(a138*a093);
  a128=(a128+a138);
  a139=(a139*a100);
  a128=(a128+a139);
  a120=(a120*a130);
  a150=(a150*a099);
  a120=(a120+a150);
  a155=(a155*a071);
  a144=(a144*a108);
  a155=(a155-a144);
  a120=(a120+a155);
  a140=(a140*a120);
  a128=(a128+a140);
  a128=(a012+a128);
  a173=(a173*a128);
  a126=(a126+a173);
  a168=(a168+a126);
  a126=(a162*a168);
  a106=(a106+a126);
  a106=(a122+a106);
  a126=(a156*a106);
  a023=(a023+a126);
  a126=(a171*a016);
  a173=(a179*a070);
  a126=(a126+a173);
  a173=(a180*a086);
  a126=(a126+a173);
  a173=(a181*a105);
  a126=(a126+a173);
  a173=(a182*a125);
  a126=(a126+a173);
  a173=(a183*a146);
  a126=(a126+a173);
  a173=(a184*a168);
  a126=(a126+a173);
  a173=(a149*a122);
  a140=(a157*a069);
  a173=(a173+a140);
  a140=(a158*a062);
  a173=(a173+a140);
  a140=(a159*a024);
  a173=(a173+a140);
  a140=(a160*a088);
  a173=(a173+a140);
  a140=(a161*a071);
  a173=(a173+a140);
  a140=(a162*a087);
  a173=(a173+a140);
  a173=(a030+a173);
  a191=(a191*a173);
  a140=(a149*a012);
  a155=(a157*a033);
  a140=(a140+a155);
  a155=(a158*a073);
  a140=(a140+a155);
  a155=(a159*a006);
  a140=(a140+a155);
  a155=(a160*a089);
  a140=(a140+a155);
  a155=(a161*a108);
  a140=(a140+a155);
  a155=(a162*a128);
  a140=(a140+a155);
  a140=(a107+a140);
  a190=(a190*a140);
  a191=(a191+a190);
  a147=(a147*a106);
  a149=(a149*a142);
  a157=(a157*a003);
  a149=(a149+a157);
  a158=(a158*a077);
  a149=(a149+a158);
  a159=(a159*a093);
  a149=(a149+a159);
  a160=(a160*a100);
  a149=(a149+a160);
  a161=(a161*a120);
  a149=(a149+a161);
  a141=(a141*a151);
  a172=(a172*a119);
  a141=(a141+a172);
  a177=(a177*a087);
  a166=(a166*a128);
  a177=(a177-a166);
  a141=(a141+a177);
  a162=(a162*a141);
  a149=(a149+a162);
  a149=(a012+a149);
  a196=(a196*a149);
  a147=(a147+a196);
  a191=(a191+a147);
  a147=(a185*a191);
  a126=(a126+a147);
  a126=(a122+a126);
  a147=(a178*a126);
  a023=(a023+a147);
  a147=(a194*a016);
  a070=(a202*a070);
  a147=(a147+a070);
  a086=(a076*a086);
  a147=(a147+a086);
  a086=(a092*a105);
  a147=(a147+a086);
  a086=(a203*a125);
  a147=(a147+a086);
  a086=(a204*a146);
  a147=(a147+a086);
  a086=(a205*a168);
  a147=(a147+a086);
  a086=(a206*a191);
  a147=(a147+a086);
  a086=(a171*a122);
  a070=(a179*a069);
  a086=(a086+a070);
  a070=(a180*a062);
  a086=(a086+a070);
  a070=(a181*a024);
  a086=(a086+a070);
  a070=(a182*a088);
  a086=(a086+a070);
  a070=(a183*a071);
  a086=(a086+a070);
  a070=(a184*a087);
  a086=(a086+a070);
  a070=(a185*a106);
  a086=(a086+a070);
  a086=(a030+a086);
  a212=(a212*a086);
  a070=(a171*a012);
  a196=(a179*a033);
  a070=(a070+a196);
  a196=(a180*a073);
  a070=(a070+a196);
  a196=(a181*a006);
  a070=(a070+a196);
  a196=(a182*a089);
  a070=(a070+a196);
  a196=(a183*a108);
  a070=(a070+a196);
  a196=(a184*a128);
  a070=(a070+a196);
  a196=(a185*a149);
  a070=(a070+a196);
  a070=(a107+a070);
  a211=(a211*a070);
  a212=(a212+a211);
  a101=(a101*a126);
  a171=(a171*a142);
  a179=(a179*a003);
  a171=(a171+a179);
  a180=(a180*a077);
  a171=(a171+a180);
  a181=(a181*a093);
  a171=(a171+a181);
  a182=(a182*a100);
  a171=(a171+a182);
  a183=(a183*a120);
  a171=(a171+a183);
  a184=(a184*a141);
  a171=(a171+a184);
  a163=(a163*a173);
  a195=(a195*a140);
  a163=(a163+a195);
  a200=(a200*a106);
  a189=(a189*a149);
  a200=(a200-a189);
  a163=(a163+a200);
  a185=(a185*a163);
  a171=(a171+a185);
  a171=(a012+a171);
  a217=(a217*a171);
  a101=(a101+a217);
  a212=(a212+a101);
  a101=(a207*a212);
  a147=(a147+a101);
  a147=(a122+a147);
  a101=(a201*a147);
  a023=(a023+a101);
  a023=(a030+a023);
  if (res[0]!=0) res[0][12]=a023;
  a023=(a001*a012);
  a101=(a005*a006);
  a023=(a023+a101);
  a101=(a096*a089);
  a023=(a023+a101);
  a101=(a115*a108);
  a023=(a023+a101);
  a101=(a135*a128);
  a023=(a023+a101);
  a101=(a156*a149);
  a023=(a023+a101);
  a101=(a178*a171);
  a023=(a023+a101);
  a101=(a194*a142);
  a003=(a202*a003);
  a101=(a101+a003);
  a077=(a076*a077);
  a101=(a101+a077);
  a077=(a092*a093);
  a101=(a101+a077);
  a077=(a203*a100);
  a101=(a101+a077);
  a077=(a204*a120);
  a101=(a101+a077);
  a077=(a205*a141);
  a101=(a101+a077);
  a077=(a206*a163);
  a101=(a101+a077);
  a169=(a169*a086);
  a216=(a216*a070);
  a169=(a169+a216);
  a221=(a221*a126);
  a210=(a210*a171);
  a221=(a221-a210);
  a169=(a169+a221);
  a221=(a207*a169);
  a101=(a101+a221);
  a101=(a012+a101);
  a221=(a201*a101);
  a023=(a023+a221);
  a023=(a107+a023);
  if (res[0]!=0) res[0][13]=a023;
  a016=(a001*a016);
  a105=(a005*a105);
  a016=(a016+a105);
  a125=(a096*a125);
  a016=(a016+a125);
  a146=(a115*a146);
  a016=(a016+a146);
  a168=(a135*a168);
  a016=(a016+a168);
  a191=(a156*a191);
  a016=(a016+a191);
  a212=(a178*a212);
  a016=(a016+a212);
  a212=(a194*a122);
  a069=(a202*a069);
  a212=(a212+a069);
  a062=(a076*a062);
  a212=(a212+a062);
  a024=(a092*a024);
  a212=(a212+a024);
  a088=(a203*a088);
  a212=(a212+a088);
  a071=(a204*a071);
  a212=(a212+a071);
  a087=(a205*a087);
  a212=(a212+a087);
  a106=(a206*a106);
  a212=(a212+a106);
  a126=(a207*a126);
  a212=(a212+a126);
  a030=(a030+a212);
  a000=(a000*a030);
  a194=(a194*a012);
  a202=(a202*a033);
  a194=(a194+a202);
  a076=(a076*a073);
  a194=(a194+a076);
  a092=(a092*a006);
  a194=(a194+a092);
  a203=(a203*a089);
  a194=(a194+a203);
  a204=(a204*a108);
  a194=(a194+a204);
  a205=(a205*a128);
  a194=(a194+a205);
  a206=(a206*a149);
  a194=(a194+a206);
  a207=(a207*a171);
  a194=(a194+a207);
  a107=(a107+a194);
  a174=(a174*a107);
  a000=(a000+a174);
  a152=(a152*a147);
  a082=(a082*a101);
  a152=(a152+a082);
  a000=(a000+a152);
  a000=(a201*a000);
  a016=(a016+a000);
  a122=(a122+a016);
  if (res[0]!=0) res[0][14]=a122;
  a001=(a001*a142);
  a005=(a005*a093);
  a001=(a001+a005);
  a096=(a096*a100);
  a001=(a001+a096);
  a115=(a115*a120);
  a001=(a001+a115);
  a135=(a135*a141);
  a001=(a001+a135);
  a156=(a156*a163);
  a001=(a001+a156);
  a178=(a178*a169);
  a001=(a001+a178);
  a102=(a102*a030);
  a007=(a007*a107);
  a102=(a102+a007);
  a220=(a220*a147);
  a015=(a015*a101);
  a220=(a220-a015);
  a102=(a102+a220);
  a201=(a201*a102);
  a001=(a001+a201);
  a012=(a012+a001);
  if (res[0]!=0) res[0][15]=a012;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[6])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+227, w1, *w2=w+243, *w3=w+249, w5, *w6=w+251, w7;
  const casadi_real **arg1=arg+5, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 6, w2);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
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
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  return 0;
}

/* landing_with_derivative:(y[4x4],z[3],T,p[6])->(J[4x4],R[4]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[0]? arg[0][1] : 0;
  a04=cos(a02);
  a05=arg[3]? arg[3][1] : 0;
  a06=(2.*a05);
  a07=(a03-a04);
  a07=(a06*a07);
  a07=(a07+a03);
  a08=(a04/a07);
  a09=(a04-a03);
  a09=(a05*a09);
  a10=(a09/a07);
  a11=(a10*a04);
  a12=(a09*a10);
  a12=(a05-a12);
  a11=(a11/a12);
  a13=(a10*a11);
  a08=(a08+a13);
  a13=arg[0]? arg[0][6] : 0;
  a14=(a08*a13);
  a15=arg[0]? arg[0][2] : 0;
  a16=sin(a02);
  a17=(a15*a16);
  a18=(a17/a07);
  a04=(a04*a15);
  a19=(a04/a07);
  a20=(a19/a07);
  a06=(a06*a16);
  a20=(a20*a06);
  a18=(a18+a20);
  a20=(a10*a04);
  a20=(a20/a12);
  a21=(a05*a16);
  a22=(a21/a07);
  a23=(a10/a07);
  a23=(a23*a06);
  a22=(a22+a23);
  a23=(a20*a22);
  a04=(a04*a22);
  a17=(a10*a17);
  a04=(a04+a17);
  a04=(a04/a12);
  a17=(a20/a12);
  a21=(a10*a21);
  a09=(a09*a22);
  a21=(a21+a09);
  a17=(a17*a21);
  a04=(a04+a17);
  a17=(a10*a04);
  a23=(a23+a17);
  a18=(a18+a23);
  a23=(a18*a01);
  a14=(a14-a23);
  if (res[0]!=0) res[0][1]=a14;
  a14=(a04*a01);
  a13=(a11*a13);
  a14=(a14-a13);
  if (res[0]!=0) res[0][2]=a14;
  a14=-2.;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a13=(a00-a01);
  if (res[0]!=0) res[0][4]=a13;
  a13=arg[0]? arg[0][10] : 0;
  a23=(a08*a13);
  a17=(a18*a01);
  a23=(a23-a17);
  a23=(a23-a03);
  if (res[0]!=0) res[0][5]=a23;
  a23=(a04*a01);
  a13=(a11*a13);
  a23=(a23-a13);
  if (res[0]!=0) res[0][6]=a23;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a23=(a00-a01);
  if (res[0]!=0) res[0][8]=a23;
  a23=arg[0]? arg[0][14] : 0;
  a13=(a08*a23);
  a17=(a18*a01);
  a13=(a13-a17);
  if (res[0]!=0) res[0][9]=a13;
  a13=(a04*a01);
  a23=(a11*a23);
  a13=(a13-a23);
  a13=(a13-a03);
  if (res[0]!=0) res[0][10]=a13;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=arg[0]? arg[0][3] : 0;
  a01=(a15-a00);
  if (res[0]!=0) res[0][12]=a01;
  a01=(a05*a00);
  a01=(a01*a16);
  a13=(2.*a15);
  a13=(a00-a13);
  a01=(a01*a13);
  a13=arg[0]? arg[0][0] : 0;
  a23=sin(a13);
  a17=(a13-a02);
  a21=sin(a17);
  a09=(a23-a21);
  a09=(a05*a09);
  a01=(a01+a09);
  a01=(a01+a23);
  a07=(a01/a07);
  a23=casadi_sq(a15);
  a23=(a23*a16);
  a23=(a23+a21);
  a05=(a05*a23);
  a23=arg[3]? arg[3][3] : 0;
  a21=arg[3]? arg[3][5] : 0;
  a16=arg[3]? arg[3][0] : 0;
  a09=(a21*a16);
  a22=arg[2]? arg[2][0] : 0;
  a16=(a16*a22);
  a22=sin(a16);
  a09=(a09*a22);
  a09=(a00+a09);
  a23=(a23*a09);
  a09=arg[3]? arg[3][2] : 0;
  a22=arg[3]? arg[3][4] : 0;
  a16=cos(a16);
  a16=(a16+a03);
  a21=(a21*a16);
  a22=(a22-a21);
  a22=(a22+a02);
  a09=(a09*a22);
  a23=(a23+a09);
  a05=(a05-a23);
  a01=(a10*a01);
  a05=(a05-a01);
  a05=(a05/a12);
  a05=(a10*a05);
  a07=(a07-a05);
  a08=(a08*a07);
  a18=(a18*a00);
  a08=(a08-a18);
  if (res[0]!=0) res[0][13]=a08;
  a04=(a04*a00);
  a11=(a11*a07);
  a04=(a04-a11);
  if (res[0]!=0) res[0][14]=a04;
  a14=(a14*a15);
  a14=(a14+a00);
  if (res[0]!=0) res[0][15]=a14;
  a14=arg[1]? arg[1][0] : 0;
  a17=(a17-a14);
  if (res[1]!=0) res[1][0]=a17;
  a10=(a10*a20);
  a19=(a19+a10);
  a10=arg[1]? arg[1][1] : 0;
  a19=(a19-a10);
  if (res[1]!=0) res[1][1]=a19;
  a19=arg[1]? arg[1][2] : 0;
  a20=(a20+a19);
  a20=(-a20);
  if (res[1]!=0) res[1][2]=a20;
  a13=(2.*a13);
  a02=(a02-a13);
  if (res[1]!=0) res[1][3]=a02;
  return 0;
}

/* compass_jacobian_12:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 12 */
  w08 = 12.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@5, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w05;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @5 */
  casadi_copy(w05, 16, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* scaled_jacobian_12:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+382, *w1=w+398, *w2=w+402, *w3=w+408, *w4=w+424;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = compass_jacobian_12(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_12:(u0[4],p[6])->(u[4]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f3(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_12:(i0[4],i1[6])->(o0[4]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+492, *w1=w+496, *w2=w+502;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* plain_step:(y[4],phase[2],turns[2x12],h,p[6])->(y_end[4]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74;
  a00=arg[0]? arg[0][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[3]? arg[3][0] : 0;
  a01=(a01*a02);
  a03=arg[0]? arg[0][2] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[4]? arg[4][1] : 0;
  a08=arg[0]? arg[0][3] : 0;
  a09=(a07*a08);
  a10=arg[0]? arg[0][1] : 0;
  a11=sin(a10);
  a09=(a09*a11);
  a12=(2.*a03);
  a12=(a08-a12);
  a09=(a09*a12);
  a12=sin(a00);
  a13=cos(a10);
  a14=(a12*a13);
  a15=cos(a00);
  a15=(a15*a11);
  a14=(a14-a15);
  a15=(a12-a14);
  a15=(a07*a15);
  a09=(a09+a15);
  a09=(a09+a12);
  a12=(2.*a07);
  a15=1.;
  a16=(a15-a13);
  a16=(a12*a16);
  a16=(a16+a15);
  a17=(a09/a16);
  a13=(a13-a15);
  a13=(a07*a13);
  a16=(a13/a16);
  a18=casadi_sq(a03);
  a18=(a18*a11);
  a18=(a18+a14);
  a18=(a07*a18);
  a14=arg[4]? arg[4][3] : 0;
  a11=arg[4]? arg[4][5] : 0;
  a19=arg[4]? arg[4][0] : 0;
  a19=(a11*a19);
  a20=arg[1]? arg[1][1] : 0;
  a21=(a19*a20);
  a21=(a08+a21);
  a21=(a14*a21);
  a22=arg[4]? arg[4][2] : 0;
  a23=arg[4]? arg[4][4] : 0;
  a24=arg[1]? arg[1][0] : 0;
  a25=(a24+a15);
  a25=(a11*a25);
  a25=(a23-a25);
  a25=(a25+a10);
  a25=(a22*a25);
  a21=(a21+a25);
  a18=(a18-a21);
  a09=(a16*a09);
  a18=(a18-a09);
  a13=(a13*a16);
  a13=(a07-a13);
  a18=(a18/a13);
  a16=(a16*a18);
  a17=(a17-a16);
  a16=(a06*a17);
  a13=1.7082860872947386e-01;
  a13=(a13*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a21=(a09*a18);
  a25=8.8762756430420545e-02;
  a25=(a25*a02);
  a26=1.9725056984537900e-02;
  a26=(a26*a02);
  a27=(a26*a17);
  a28=5.9175170953613701e-02;
  a28=(a28*a02);
  a29=5.2600151958767730e-02;
  a29=(a29*a02);
  a30=(a29*a18);
  a30=(a08+a30);
  a31=(a07*a30);
  a32=(a29*a08);
  a32=(a10+a32);
  a33=sin(a32);
  a31=(a31*a33);
  a34=(a29*a17);
  a34=(a03+a34);
  a35=(2.*a34);
  a35=(a30-a35);
  a31=(a31*a35);
  a29=(a29*a03);
  a29=(a00+a29);
  a35=sin(a29);
  a36=cos(a32);
  a37=(a35*a36);
  a29=cos(a29);
  a29=(a29*a33);
  a37=(a37-a29);
  a29=(a35-a37);
  a29=(a07*a29);
  a31=(a31+a29);
  a31=(a31+a35);
  a35=(a15-a36);
  a35=(a12*a35);
  a35=(a35+a15);
  a29=(a31/a35);
  a36=(a36-a15);
  a36=(a07*a36);
  a35=(a36/a35);
  a38=casadi_sq(a34);
  a38=(a38*a33);
  a38=(a38+a37);
  a38=(a07*a38);
  a37=arg[2]? arg[2][2] : 0;
  a33=(a20*a37);
  a39=arg[2]? arg[2][3] : 0;
  a40=(a24*a39);
  a33=(a33+a40);
  a33=(a19*a33);
  a33=(a30+a33);
  a33=(a14*a33);
  a37=(a24*a37);
  a39=(a20*a39);
  a37=(a37-a39);
  a37=(a37+a15);
  a37=(a11*a37);
  a37=(a23-a37);
  a37=(a37+a32);
  a37=(a22*a37);
  a33=(a33+a37);
  a38=(a38-a33);
  a31=(a35*a31);
  a38=(a38-a31);
  a36=(a36*a35);
  a36=(a07-a36);
  a38=(a38/a36);
  a35=(a35*a38);
  a29=(a29-a35);
  a29=(a28*a29);
  a27=(a27+a29);
  a27=(a03+a27);
  a29=casadi_sq(a27);
  a35=(a26*a08);
  a30=(a28*a30);
  a35=(a35+a30);
  a35=(a10+a35);
  a30=sin(a35);
  a29=(a29*a30);
  a36=(a26*a03);
  a34=(a28*a34);
  a36=(a36+a34);
  a36=(a00+a36);
  a34=sin(a36);
  a31=cos(a35);
  a33=(a34*a31);
  a36=cos(a36);
  a36=(a36*a30);
  a33=(a33-a36);
  a29=(a29+a33);
  a29=(a07*a29);
  a26=(a26*a18);
  a28=(a28*a38);
  a26=(a26+a28);
  a26=(a08+a26);
  a28=arg[2]? arg[2][4] : 0;
  a38=(a20*a28);
  a36=arg[2]? arg[2][5] : 0;
  a37=(a24*a36);
  a38=(a38+a37);
  a38=(a19*a38);
  a38=(a26+a38);
  a38=(a14*a38);
  a28=(a24*a28);
  a36=(a20*a36);
  a28=(a28-a36);
  a28=(a28+a15);
  a28=(a11*a28);
  a28=(a23-a28);
  a28=(a28+a35);
  a28=(a22*a28);
  a38=(a38+a28);
  a29=(a29-a38);
  a38=(a31-a15);
  a38=(a07*a38);
  a31=(a15-a31);
  a31=(a12*a31);
  a31=(a31+a15);
  a28=(a38/a31);
  a35=(a07*a26);
  a35=(a35*a30);
  a30=(2.*a27);
  a30=(a26-a30);
  a35=(a35*a30);
  a33=(a34-a33);
  a33=(a07*a33);
  a35=(a35+a33);
  a35=(a35+a34);
  a34=(a28*a35);
  a29=(a29-a34);
  a38=(a38*a28);
  a38=(a07-a38);
  a29=(a29/a38);
  a38=(a25*a29);
  a21=(a21+a38);
  a21=(a08+a21);
  a38=(a07*a21);
  a34=(a09*a08);
  a33=(a25*a26);
  a34=(a34+a33);
  a34=(a10+a34);
  a33=sin(a34);
  a38=(a38*a33);
  a30=(a09*a17);
  a35=(a35/a31);
  a28=(a28*a29);
  a35=(a35-a28);
  a28=(a25*a35);
  a30=(a30+a28);
  a30=(a03+a30);
  a28=(2.*a30);
  a28=(a21-a28);
  a38=(a38*a28);
  a09=(a09*a03);
  a25=(a25*a27);
  a09=(a09+a25);
  a09=(a00+a09);
  a25=sin(a09);
  a28=cos(a34);
  a31=(a25*a28);
  a09=cos(a09);
  a09=(a09*a33);
  a31=(a31-a09);
  a09=(a25-a31);
  a09=(a07*a09);
  a38=(a38+a09);
  a38=(a38+a25);
  a25=(a15-a28);
  a25=(a12*a25);
  a25=(a25+a15);
  a09=(a38/a25);
  a28=(a28-a15);
  a28=(a07*a28);
  a25=(a28/a25);
  a36=casadi_sq(a30);
  a36=(a36*a33);
  a36=(a36+a31);
  a36=(a07*a36);
  a31=arg[2]? arg[2][6] : 0;
  a33=(a20*a31);
  a37=arg[2]? arg[2][7] : 0;
  a32=(a24*a37);
  a33=(a33+a32);
  a33=(a19*a33);
  a33=(a21+a33);
  a33=(a14*a33);
  a31=(a24*a31);
  a37=(a20*a37);
  a31=(a31-a37);
  a31=(a31+a15);
  a31=(a11*a31);
  a31=(a23-a31);
  a31=(a31+a34);
  a31=(a22*a31);
  a33=(a33+a31);
  a36=(a36-a33);
  a38=(a25*a38);
  a36=(a36-a38);
  a28=(a28*a25);
  a28=(a07-a28);
  a36=(a36/a28);
  a25=(a25*a36);
  a09=(a09-a25);
  a25=(a13*a09);
  a16=(a16+a25);
  a25=1.2546768756682242e-01;
  a25=(a25*a02);
  a28=2.4136513415926669e-01;
  a28=(a28*a02);
  a38=(a28*a18);
  a33=-8.8454947932828609e-01;
  a33=(a33*a02);
  a29=(a33*a29);
  a38=(a38+a29);
  a29=9.2483400326179199e-01;
  a29=(a29*a02);
  a31=(a29*a36);
  a38=(a38+a31);
  a38=(a08+a38);
  a31=(a07*a38);
  a34=(a28*a08);
  a26=(a33*a26);
  a34=(a34+a26);
  a26=(a29*a21);
  a34=(a34+a26);
  a34=(a10+a34);
  a26=sin(a34);
  a31=(a31*a26);
  a37=(a28*a17);
  a35=(a33*a35);
  a37=(a37+a35);
  a35=(a29*a09);
  a37=(a37+a35);
  a37=(a03+a37);
  a35=(2.*a37);
  a35=(a38-a35);
  a31=(a31*a35);
  a28=(a28*a03);
  a33=(a33*a27);
  a28=(a28+a33);
  a29=(a29*a30);
  a28=(a28+a29);
  a28=(a00+a28);
  a29=sin(a28);
  a33=cos(a34);
  a27=(a29*a33);
  a28=cos(a28);
  a28=(a28*a26);
  a27=(a27-a28);
  a28=(a29-a27);
  a28=(a07*a28);
  a31=(a31+a28);
  a31=(a31+a29);
  a29=(a15-a33);
  a29=(a12*a29);
  a29=(a29+a15);
  a28=(a31/a29);
  a33=(a33-a15);
  a33=(a07*a33);
  a29=(a33/a29);
  a35=casadi_sq(a37);
  a35=(a35*a26);
  a35=(a35+a27);
  a35=(a07*a35);
  a27=arg[2]? arg[2][8] : 0;
  a26=(a20*a27);
  a32=arg[2]? arg[2][9] : 0;
  a39=(a24*a32);
  a26=(a26+a39);
  a26=(a19*a26);
  a26=(a38+a26);
  a26=(a14*a26);
  a27=(a24*a27);
  a32=(a20*a32);
  a27=(a27-a32);
  a27=(a27+a15);
  a27=(a11*a27);
  a27=(a23-a27);
  a27=(a27+a34);
  a27=(a22*a27);
  a26=(a26+a27);
  a35=(a35-a26);
  a31=(a29*a31);
  a35=(a35-a31);
  a33=(a33*a29);
  a33=(a07-a33);
  a35=(a35/a33);
  a29=(a29*a35);
  a28=(a28-a29);
  a29=(a25*a28);
  a16=(a16+a29);
  a16=(a03+a16);
  a29=(a05*a16);
  a04=(a04+a29);
  a29=1.8915178993145003e+00;
  a29=(a29*a02);
  a33=3.7109375000000000e-02;
  a33=(a33*a02);
  a31=(a33*a17);
  a26=1.7025221101954405e-01;
  a26=(a26*a02);
  a27=(a26*a09);
  a31=(a31+a27);
  a27=6.0216538980455959e-02;
  a27=(a27*a02);
  a34=(a27*a28);
  a31=(a31+a34);
  a34=-1.7578125000000000e-02;
  a34=(a34*a02);
  a32=(a06*a18);
  a39=(a13*a36);
  a32=(a32+a39);
  a39=(a25*a35);
  a32=(a32+a39);
  a32=(a08+a32);
  a39=(a07*a32);
  a40=(a06*a08);
  a41=(a13*a21);
  a40=(a40+a41);
  a41=(a25*a38);
  a40=(a40+a41);
  a40=(a10+a40);
  a41=sin(a40);
  a39=(a39*a41);
  a42=(2.*a16);
  a42=(a32-a42);
  a39=(a39*a42);
  a06=(a06*a03);
  a13=(a13*a30);
  a06=(a06+a13);
  a25=(a25*a37);
  a06=(a06+a25);
  a06=(a00+a06);
  a25=sin(a06);
  a13=cos(a40);
  a42=(a25*a13);
  a06=cos(a06);
  a06=(a06*a41);
  a42=(a42-a06);
  a06=(a25-a42);
  a06=(a07*a06);
  a39=(a39+a06);
  a39=(a39+a25);
  a25=(a15-a13);
  a25=(a12*a25);
  a25=(a25+a15);
  a06=(a39/a25);
  a13=(a13-a15);
  a13=(a07*a13);
  a25=(a13/a25);
  a43=casadi_sq(a16);
  a43=(a43*a41);
  a43=(a43+a42);
  a43=(a07*a43);
  a42=arg[2]? arg[2][10] : 0;
  a41=(a20*a42);
  a44=arg[2]? arg[2][11] : 0;
  a45=(a24*a44);
  a41=(a41+a45);
  a41=(a19*a41);
  a41=(a32+a41);
  a41=(a14*a41);
  a42=(a24*a42);
  a44=(a20*a44);
  a42=(a42-a44);
  a42=(a42+a15);
  a42=(a11*a42);
  a42=(a23-a42);
  a42=(a42+a40);
  a42=(a22*a42);
  a41=(a41+a42);
  a43=(a43-a41);
  a39=(a25*a39);
  a43=(a43-a39);
  a13=(a13*a25);
  a13=(a07-a13);
  a43=(a43/a13);
  a25=(a25*a43);
  a06=(a06-a25);
  a25=(a34*a06);
  a31=(a31+a25);
  a31=(a03+a31);
  a25=(a29*a31);
  a04=(a04+a25);
  a25=-5.8012039600105849e+00;
  a25=(a25*a02);
  a13=3.7092000118504789e-02;
  a13=(a13*a02);
  a39=(a13*a17);
  a41=1.7038392571223998e-01;
  a41=(a41*a02);
  a42=(a41*a09);
  a39=(a39+a42);
  a42=1.0726203044637328e-01;
  a42=(a42*a02);
  a40=(a42*a28);
  a39=(a39+a40);
  a40=-1.5319437748624402e-02;
  a40=(a40*a02);
  a44=(a40*a06);
  a39=(a39+a44);
  a44=8.2737891638140233e-03;
  a44=(a44*a02);
  a45=(a33*a18);
  a46=(a26*a36);
  a45=(a45+a46);
  a46=(a27*a35);
  a45=(a45+a46);
  a46=(a34*a43);
  a45=(a45+a46);
  a45=(a08+a45);
  a46=(a07*a45);
  a47=(a33*a08);
  a48=(a26*a21);
  a47=(a47+a48);
  a48=(a27*a38);
  a47=(a47+a48);
  a48=(a34*a32);
  a47=(a47+a48);
  a47=(a10+a47);
  a48=sin(a47);
  a46=(a46*a48);
  a49=(2.*a31);
  a49=(a45-a49);
  a46=(a46*a49);
  a33=(a33*a03);
  a26=(a26*a30);
  a33=(a33+a26);
  a27=(a27*a37);
  a33=(a33+a27);
  a34=(a34*a16);
  a33=(a33+a34);
  a33=(a00+a33);
  a34=sin(a33);
  a27=cos(a47);
  a26=(a34*a27);
  a33=cos(a33);
  a33=(a33*a48);
  a26=(a26-a33);
  a33=(a34-a26);
  a33=(a07*a33);
  a46=(a46+a33);
  a46=(a46+a34);
  a34=(a15-a27);
  a34=(a12*a34);
  a34=(a34+a15);
  a33=(a46/a34);
  a27=(a27-a15);
  a27=(a07*a27);
  a34=(a27/a34);
  a49=casadi_sq(a31);
  a49=(a49*a48);
  a49=(a49+a26);
  a49=(a07*a49);
  a26=arg[2]? arg[2][12] : 0;
  a48=(a20*a26);
  a50=arg[2]? arg[2][13] : 0;
  a51=(a24*a50);
  a48=(a48+a51);
  a48=(a19*a48);
  a48=(a45+a48);
  a48=(a14*a48);
  a26=(a24*a26);
  a50=(a20*a50);
  a26=(a26-a50);
  a26=(a26+a15);
  a26=(a11*a26);
  a26=(a23-a26);
  a26=(a26+a47);
  a26=(a22*a26);
  a48=(a48+a26);
  a49=(a49-a48);
  a46=(a34*a46);
  a49=(a49-a46);
  a27=(a27*a34);
  a27=(a07-a27);
  a49=(a49/a27);
  a34=(a34*a49);
  a33=(a33-a34);
  a34=(a44*a33);
  a39=(a39+a34);
  a39=(a03+a39);
  a34=(a25*a39);
  a04=(a04+a34);
  a34=3.1116436695781990e-01;
  a34=(a34*a02);
  a27=6.2411095871607569e-01;
  a27=(a27*a02);
  a46=(a27*a17);
  a48=-3.3608926294469414e+00;
  a48=(a48*a02);
  a26=(a48*a09);
  a46=(a46+a26);
  a26=-8.6821934684172597e-01;
  a26=(a26*a02);
  a47=(a26*a28);
  a46=(a46+a47);
  a47=2.7592099699446710e+01;
  a47=(a47*a02);
  a50=(a47*a06);
  a46=(a46+a50);
  a50=2.0154067550477894e+01;
  a50=(a50*a02);
  a51=(a50*a33);
  a46=(a46+a51);
  a51=-4.3489884181069961e+01;
  a51=(a51*a02);
  a52=(a13*a18);
  a53=(a41*a36);
  a52=(a52+a53);
  a53=(a42*a35);
  a52=(a52+a53);
  a53=(a40*a43);
  a52=(a52+a53);
  a53=(a44*a49);
  a52=(a52+a53);
  a52=(a08+a52);
  a53=(a07*a52);
  a54=(a13*a08);
  a55=(a41*a21);
  a54=(a54+a55);
  a55=(a42*a38);
  a54=(a54+a55);
  a55=(a40*a32);
  a54=(a54+a55);
  a55=(a44*a45);
  a54=(a54+a55);
  a54=(a10+a54);
  a55=sin(a54);
  a53=(a53*a55);
  a56=(2.*a39);
  a56=(a52-a56);
  a53=(a53*a56);
  a13=(a13*a03);
  a41=(a41*a30);
  a13=(a13+a41);
  a42=(a42*a37);
  a13=(a13+a42);
  a40=(a40*a16);
  a13=(a13+a40);
  a44=(a44*a31);
  a13=(a13+a44);
  a13=(a00+a13);
  a44=sin(a13);
  a40=cos(a54);
  a42=(a44*a40);
  a13=cos(a13);
  a13=(a13*a55);
  a42=(a42-a13);
  a13=(a44-a42);
  a13=(a07*a13);
  a53=(a53+a13);
  a53=(a53+a44);
  a44=(a15-a40);
  a44=(a12*a44);
  a44=(a44+a15);
  a13=(a53/a44);
  a40=(a40-a15);
  a40=(a07*a40);
  a44=(a40/a44);
  a41=casadi_sq(a39);
  a41=(a41*a55);
  a41=(a41+a42);
  a41=(a07*a41);
  a42=arg[2]? arg[2][14] : 0;
  a55=(a20*a42);
  a56=arg[2]? arg[2][15] : 0;
  a57=(a24*a56);
  a55=(a55+a57);
  a55=(a19*a55);
  a55=(a52+a55);
  a55=(a14*a55);
  a42=(a24*a42);
  a56=(a20*a56);
  a42=(a42-a56);
  a42=(a42+a15);
  a42=(a11*a42);
  a42=(a23-a42);
  a42=(a42+a54);
  a42=(a22*a42);
  a55=(a55+a42);
  a41=(a41-a55);
  a53=(a44*a53);
  a41=(a41-a53);
  a40=(a40*a44);
  a40=(a07-a40);
  a41=(a41/a40);
  a44=(a44*a41);
  a13=(a13-a44);
  a44=(a51*a13);
  a46=(a46+a44);
  a46=(a03+a46);
  a44=(a34*a46);
  a04=(a04+a44);
  a44=-1.5216094966251609e-01;
  a44=(a44*a02);
  a40=4.7766253643826434e-01;
  a40=(a40*a02);
  a53=(a40*a17);
  a55=-2.4881146199716677e+00;
  a55=(a55*a02);
  a42=(a55*a09);
  a53=(a53+a42);
  a42=-5.9029082683684297e-01;
  a42=(a42*a02);
  a54=(a42*a28);
  a53=(a53+a54);
  a54=2.1230051448181193e+01;
  a54=(a54*a02);
  a56=(a54*a06);
  a53=(a53+a56);
  a56=1.5279233632882423e+01;
  a56=(a56*a02);
  a57=(a56*a33);
  a53=(a53+a57);
  a57=-3.3288210968984863e+01;
  a57=(a57*a02);
  a58=(a57*a13);
  a53=(a53+a58);
  a58=-2.0331201708508627e-02;
  a58=(a58*a02);
  a59=(a27*a18);
  a60=(a48*a36);
  a59=(a59+a60);
  a60=(a26*a35);
  a59=(a59+a60);
  a60=(a47*a43);
  a59=(a59+a60);
  a60=(a50*a49);
  a59=(a59+a60);
  a60=(a51*a41);
  a59=(a59+a60);
  a59=(a08+a59);
  a60=(a07*a59);
  a61=(a27*a08);
  a62=(a48*a21);
  a61=(a61+a62);
  a62=(a26*a38);
  a61=(a61+a62);
  a62=(a47*a32);
  a61=(a61+a62);
  a62=(a50*a45);
  a61=(a61+a62);
  a62=(a51*a52);
  a61=(a61+a62);
  a61=(a10+a61);
  a62=sin(a61);
  a60=(a60*a62);
  a63=(2.*a46);
  a63=(a59-a63);
  a60=(a60*a63);
  a27=(a27*a03);
  a48=(a48*a30);
  a27=(a27+a48);
  a26=(a26*a37);
  a27=(a27+a26);
  a47=(a47*a16);
  a27=(a27+a47);
  a50=(a50*a31);
  a27=(a27+a50);
  a51=(a51*a39);
  a27=(a27+a51);
  a27=(a00+a27);
  a51=sin(a27);
  a50=cos(a61);
  a47=(a51*a50);
  a27=cos(a27);
  a27=(a27*a62);
  a47=(a47-a27);
  a27=(a51-a47);
  a27=(a07*a27);
  a60=(a60+a27);
  a60=(a60+a51);
  a51=(a15-a50);
  a51=(a12*a51);
  a51=(a51+a15);
  a27=(a60/a51);
  a50=(a50-a15);
  a50=(a07*a50);
  a51=(a50/a51);
  a26=casadi_sq(a46);
  a26=(a26*a62);
  a26=(a26+a47);
  a26=(a07*a26);
  a47=arg[2]? arg[2][16] : 0;
  a62=(a20*a47);
  a48=arg[2]? arg[2][17] : 0;
  a63=(a24*a48);
  a62=(a62+a63);
  a62=(a19*a62);
  a62=(a59+a62);
  a62=(a14*a62);
  a47=(a24*a47);
  a48=(a20*a48);
  a47=(a47-a48);
  a47=(a47+a15);
  a47=(a11*a47);
  a47=(a23-a47);
  a47=(a47+a61);
  a47=(a22*a47);
  a62=(a62+a47);
  a26=(a26-a62);
  a60=(a51*a60);
  a26=(a26-a60);
  a50=(a50*a51);
  a50=(a07-a50);
  a26=(a26/a50);
  a51=(a51*a26);
  a27=(a27-a51);
  a51=(a58*a27);
  a53=(a53+a51);
  a53=(a03+a53);
  a51=(a44*a53);
  a04=(a04+a51);
  a51=2.0136540080403034e-01;
  a51=(a51*a02);
  a50=-9.3714243008598730e-01;
  a50=(a50*a02);
  a60=(a50*a17);
  a62=5.1863724288440638e+00;
  a62=(a62*a02);
  a47=(a62*a09);
  a60=(a60+a47);
  a47=1.0914373489967295e+00;
  a47=(a47*a02);
  a61=(a47*a28);
  a60=(a60+a61);
  a61=-8.1497870107469268e+00;
  a61=(a61*a02);
  a48=(a61*a06);
  a60=(a60+a48);
  a48=-1.8520065659996959e+01;
  a48=(a48*a02);
  a63=(a48*a33);
  a60=(a60+a63);
  a63=2.2739487099350505e+01;
  a63=(a63*a02);
  a64=(a63*a13);
  a60=(a60+a64);
  a64=2.4936055526796523e+00;
  a64=(a64*a02);
  a65=(a64*a27);
  a60=(a60+a65);
  a65=-3.0467644718982196e+00;
  a65=(a65*a02);
  a66=(a40*a18);
  a67=(a55*a36);
  a66=(a66+a67);
  a67=(a42*a35);
  a66=(a66+a67);
  a67=(a54*a43);
  a66=(a66+a67);
  a67=(a56*a49);
  a66=(a66+a67);
  a67=(a57*a41);
  a66=(a66+a67);
  a67=(a58*a26);
  a66=(a66+a67);
  a66=(a08+a66);
  a67=(a07*a66);
  a68=(a40*a08);
  a69=(a55*a21);
  a68=(a68+a69);
  a69=(a42*a38);
  a68=(a68+a69);
  a69=(a54*a32);
  a68=(a68+a69);
  a69=(a56*a45);
  a68=(a68+a69);
  a69=(a57*a52);
  a68=(a68+a69);
  a69=(a58*a59);
  a68=(a68+a69);
  a68=(a10+a68);
  a69=sin(a68);
  a67=(a67*a69);
  a70=(2.*a53);
  a70=(a66-a70);
  a67=(a67*a70);
  a40=(a40*a03);
  a55=(a55*a30);
  a40=(a40+a55);
  a42=(a42*a37);
  a40=(a40+a42);
  a54=(a54*a16);
  a40=(a40+a54);
  a56=(a56*a31);
  a40=(a40+a56);
  a57=(a57*a39);
  a40=(a40+a57);
  a58=(a58*a46);
  a40=(a40+a58);
  a40=(a00+a40);
  a58=sin(a40);
  a57=cos(a68);
  a56=(a58*a57);
  a40=cos(a40);
  a40=(a40*a69);
  a56=(a56-a40);
  a40=(a58-a56);
  a40=(a07*a40);
  a67=(a67+a40);
  a67=(a67+a58);
  a58=(a15-a57);
  a58=(a12*a58);
  a58=(a58+a15);
  a40=(a67/a58);
  a57=(a57-a15);
  a57=(a07*a57);
  a58=(a57/a58);
  a54=casadi_sq(a53);
  a54=(a54*a69);
  a54=(a54+a56);
  a54=(a07*a54);
  a56=arg[2]? arg[2][18] : 0;
  a69=(a20*a56);
  a42=arg[2]? arg[2][19] : 0;
  a55=(a24*a42);
  a69=(a69+a55);
  a69=(a19*a69);
  a69=(a66+a69);
  a69=(a14*a69);
  a56=(a24*a56);
  a42=(a20*a42);
  a56=(a56-a42);
  a56=(a56+a15);
  a56=(a11*a56);
  a56=(a23-a56);
  a56=(a56+a68);
  a56=(a22*a56);
  a69=(a69+a56);
  a54=(a54-a69);
  a67=(a58*a67);
  a54=(a54-a67);
  a57=(a57*a58);
  a57=(a07-a57);
  a54=(a54/a57);
  a58=(a58*a54);
  a40=(a40-a58);
  a58=(a65*a40);
  a60=(a60+a58);
  a60=(a03+a60);
  a58=(a51*a60);
  a04=(a04+a58);
  a58=4.4710615727772587e-02;
  a58=(a58*a02);
  a57=2.2733101475165380e+00;
  a57=(a57*a02);
  a67=(a57*a17);
  a69=-1.0534495466737249e+01;
  a69=(a69*a02);
  a09=(a69*a09);
  a67=(a67+a09);
  a09=-2.0008720582248625e+00;
  a09=(a09*a02);
  a28=(a09*a28);
  a67=(a67+a28);
  a28=-1.7958931863118799e+01;
  a28=(a28*a02);
  a56=(a28*a06);
  a67=(a67+a56);
  a56=2.7948884529419960e+01;
  a56=(a56*a02);
  a68=(a56*a33);
  a67=(a67+a68);
  a68=-2.8589982771350235e+00;
  a68=(a68*a02);
  a42=(a68*a13);
  a67=(a67+a42);
  a42=-8.8728569335306293e+00;
  a42=(a42*a02);
  a55=(a42*a27);
  a67=(a67+a55);
  a55=1.2360567175794303e+01;
  a55=(a55*a02);
  a70=(a55*a40);
  a67=(a67+a70);
  a70=6.4339274601576357e-01;
  a70=(a70*a02);
  a02=(a50*a18);
  a71=(a62*a36);
  a02=(a02+a71);
  a71=(a47*a35);
  a02=(a02+a71);
  a71=(a61*a43);
  a02=(a02+a71);
  a71=(a48*a49);
  a02=(a02+a71);
  a71=(a63*a41);
  a02=(a02+a71);
  a71=(a64*a26);
  a02=(a02+a71);
  a71=(a65*a54);
  a02=(a02+a71);
  a02=(a08+a02);
  a71=(a07*a02);
  a72=(a50*a08);
  a73=(a62*a21);
  a72=(a72+a73);
  a73=(a47*a38);
  a72=(a72+a73);
  a73=(a61*a32);
  a72=(a72+a73);
  a73=(a48*a45);
  a72=(a72+a73);
  a73=(a63*a52);
  a72=(a72+a73);
  a73=(a64*a59);
  a72=(a72+a73);
  a73=(a65*a66);
  a72=(a72+a73);
  a72=(a10+a72);
  a73=sin(a72);
  a71=(a71*a73);
  a74=(2.*a60);
  a74=(a02-a74);
  a71=(a71*a74);
  a50=(a50*a03);
  a62=(a62*a30);
  a50=(a50+a62);
  a47=(a47*a37);
  a50=(a50+a47);
  a61=(a61*a16);
  a50=(a50+a61);
  a48=(a48*a31);
  a50=(a50+a48);
  a63=(a63*a39);
  a50=(a50+a63);
  a64=(a64*a46);
  a50=(a50+a64);
  a65=(a65*a53);
  a50=(a50+a65);
  a50=(a00+a50);
  a65=sin(a50);
  a64=cos(a72);
  a63=(a65*a64);
  a50=cos(a50);
  a50=(a50*a73);
  a63=(a63-a50);
  a50=(a65-a63);
  a50=(a07*a50);
  a71=(a71+a50);
  a71=(a71+a65);
  a65=(a15-a64);
  a65=(a12*a65);
  a65=(a65+a15);
  a50=(a71/a65);
  a64=(a64-a15);
  a64=(a07*a64);
  a65=(a64/a65);
  a48=casadi_sq(a60);
  a48=(a48*a73);
  a48=(a48+a63);
  a48=(a07*a48);
  a63=arg[2]? arg[2][20] : 0;
  a73=(a20*a63);
  a61=arg[2]? arg[2][21] : 0;
  a47=(a24*a61);
  a73=(a73+a47);
  a73=(a19*a73);
  a73=(a02+a73);
  a73=(a14*a73);
  a63=(a24*a63);
  a61=(a20*a61);
  a63=(a63-a61);
  a63=(a63+a15);
  a63=(a11*a63);
  a63=(a23-a63);
  a63=(a63+a72);
  a63=(a22*a63);
  a73=(a73+a63);
  a48=(a48-a73);
  a71=(a65*a71);
  a48=(a48-a71);
  a64=(a64*a65);
  a64=(a07-a64);
  a48=(a48/a64);
  a65=(a65*a48);
  a50=(a50-a65);
  a65=(a70*a50);
  a67=(a67+a65);
  a67=(a03+a67);
  a65=(a58*a67);
  a04=(a04+a65);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a65=(a05*a32);
  a04=(a04+a65);
  a65=(a29*a45);
  a04=(a04+a65);
  a65=(a25*a52);
  a04=(a04+a65);
  a65=(a34*a59);
  a04=(a04+a65);
  a65=(a44*a66);
  a04=(a04+a65);
  a65=(a51*a02);
  a04=(a04+a65);
  a65=(a57*a18);
  a36=(a69*a36);
  a65=(a65+a36);
  a35=(a09*a35);
  a65=(a65+a35);
  a35=(a28*a43);
  a65=(a65+a35);
  a35=(a56*a49);
  a65=(a65+a35);
  a35=(a68*a41);
  a65=(a65+a35);
  a35=(a42*a26);
  a65=(a65+a35);
  a35=(a55*a54);
  a65=(a65+a35);
  a35=(a70*a48);
  a65=(a65+a35);
  a65=(a08+a65);
  a35=(a58*a65);
  a04=(a04+a35);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a17=(a01*a17);
  a06=(a05*a06);
  a17=(a17+a06);
  a33=(a29*a33);
  a17=(a17+a33);
  a13=(a25*a13);
  a17=(a17+a13);
  a27=(a34*a27);
  a17=(a17+a27);
  a40=(a44*a40);
  a17=(a17+a40);
  a50=(a51*a50);
  a17=(a17+a50);
  a50=(a07*a65);
  a40=(a57*a08);
  a21=(a69*a21);
  a40=(a40+a21);
  a38=(a09*a38);
  a40=(a40+a38);
  a32=(a28*a32);
  a40=(a40+a32);
  a45=(a56*a45);
  a40=(a40+a45);
  a52=(a68*a52);
  a40=(a40+a52);
  a59=(a42*a59);
  a40=(a40+a59);
  a66=(a55*a66);
  a40=(a40+a66);
  a02=(a70*a02);
  a40=(a40+a02);
  a10=(a10+a40);
  a40=sin(a10);
  a50=(a50*a40);
  a02=(2.*a67);
  a02=(a65-a02);
  a50=(a50*a02);
  a57=(a57*a03);
  a69=(a69*a30);
  a57=(a57+a69);
  a09=(a09*a37);
  a57=(a57+a09);
  a28=(a28*a16);
  a57=(a57+a28);
  a56=(a56*a31);
  a57=(a57+a56);
  a68=(a68*a39);
  a57=(a57+a68);
  a42=(a42*a46);
  a57=(a57+a42);
  a55=(a55*a53);
  a57=(a57+a55);
  a70=(a70*a60);
  a57=(a57+a70);
  a00=(a00+a57);
  a57=sin(a00);
  a70=cos(a10);
  a60=(a57*a70);
  a00=cos(a00);
  a00=(a00*a40);
  a60=(a60-a00);
  a00=(a57-a60);
  a00=(a07*a00);
  a50=(a50+a00);
  a50=(a50+a57);
  a57=(a15-a70);
  a12=(a12*a57);
  a12=(a12+a15);
  a57=(a50/a12);
  a70=(a70-a15);
  a70=(a07*a70);
  a12=(a70/a12);
  a67=casadi_sq(a67);
  a67=(a67*a40);
  a67=(a67+a60);
  a67=(a07*a67);
  a60=arg[2]? arg[2][22] : 0;
  a40=(a20*a60);
  a00=arg[2]? arg[2][23] : 0;
  a55=(a24*a00);
  a40=(a40+a55);
  a19=(a19*a40);
  a65=(a65+a19);
  a14=(a14*a65);
  a24=(a24*a60);
  a20=(a20*a00);
  a24=(a24-a20);
  a24=(a24+a15);
  a11=(a11*a24);
  a23=(a23-a11);
  a23=(a23+a10);
  a22=(a22*a23);
  a14=(a14+a22);
  a67=(a67-a14);
  a50=(a12*a50);
  a67=(a67-a50);
  a70=(a70*a12);
  a07=(a07-a70);
  a67=(a67/a07);
  a12=(a12*a67);
  a57=(a57-a12);
  a57=(a58*a57);
  a17=(a17+a57);
  a03=(a03+a17);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a18);
  a05=(a05*a43);
  a01=(a01+a05);
  a29=(a29*a49);
  a01=(a01+a29);
  a25=(a25*a41);
  a01=(a01+a25);
  a34=(a34*a26);
  a01=(a01+a34);
  a44=(a44*a54);
  a01=(a01+a44);
  a51=(a51*a48);
  a01=(a01+a51);
  a58=(a58*a67);
  a01=(a01+a58);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p[6])->(y_end[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+75, w1, *w2=w+79, *w3=w+85, w5, *w6=w+87, w7;
  const casadi_real **arg1=arg+5, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 6, w2);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
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
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
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
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* landing:(y[4],z[3],p[6])->(R[4]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7;
  a0=arg[0]? arg[0][0] : 0;
  a1=arg[0]? arg[0][1] : 0;
  a2=(a0-a1);
  a3=arg[1]? arg[1][0] : 0;
  a2=(a2-a3);
  if (res[0]!=0) res[0][0]=a2;
  a2=cos(a1);
  a3=arg[0]? arg[0][2] : 0;
  a3=(a2*a3);
  a4=arg[2]? arg[2][1] : 0;
  a5=(2.*a4);
  a6=1.;
  a7=(a6-a2);
  a5=(a5*a7);
  a5=(a5+a6);
  a7=(a3/a5);
  a2=(a2-a6);
  a2=(a4*a2);
  a5=(a2/a5);
  a3=(a5*a3);
  a2=(a2*a5);
  a4=(a4-a2);
  a3=(a3/a4);
  a5=(a5*a3);
  a7=(a7+a5);
  a5=arg[1]? arg[1][1] : 0;
  a7=(a7-a5);
  if (res[0]!=0) res[0][1]=a7;
  a7=arg[1]? arg[1][2] : 0;
  a3=(a3+a7);
  a3=(-a3);
  if (res[0]!=0) res[0][2]=a3;
  a0=(2.*a0);
  a1=(a1-a0);
  if (res[0]!=0) res[0][3]=a1;
  return 0;
}

/* compass_residual_12:(u[4],p[6])->(R[4]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 12 */
  w6 = 12.;
  /* #7: @5 = (@5/@6) */
  w5 /= w6;
  /* #8: @7 = turns(@5, @2) */
  arg1[0]=(&w5);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @5, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @3 = landing(@0, @1, @2) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w3;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @3 */
  casadi_copy(w3, 4, res[0]);
  return 0;
}

/* compass_search_12:(u0[4],p[6])->(u[4],R[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+506, *w1=w+510, *w2=w+516;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = compass_residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 520;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 520*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 24 */
  w08 = 24.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+382, *w1=w+398, *w2=w+402, *w3=w+408, *w4=w+424;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = compass_jacobian_24(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_24:(u0[4],p[6])->(u[4]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f18(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_24:(i0[4],i1[6])->(o0[4]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+492, *w1=w+496, *w2=w+502;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f17(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_residual_24:(u[4],p[6])->(R[4]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 24 */
  w6 = 24.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* compass_search_24:(u0[4],p[6])->(u[4],R[4]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+506, *w1=w+510, *w2=w+516;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = compass_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 520;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 520*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 48 */
  w08 = 48.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+382, *w1=w+398, *w2=w+402, *w3=w+408, *w4=w+424;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = compass_jacobian_48(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_48:(u0[4],p[6])->(u[4]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f24(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_48:(i0[4],i1[6])->(o0[4]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+492, *w1=w+496, *w2=w+502;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f23(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_residual_48:(u[4],p[6])->(R[4]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 48 */
  w6 = 48.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* compass_search_48:(u0[4],p[6])->(u[4],R[4]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+506, *w1=w+510, *w2=w+516;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = compass_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 520;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 520*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_24(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f31(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_24:(u0[4],p[6])->(u[4]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f30(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_24:(i0[4],i1[6])->(o0[4]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f29(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_limit_cycle_24:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_36:(u[4],p[6])->(R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 36 */
  w6 = 36.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @3 = landing(@0, @1, @2) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w3;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][0] = @3 */
  casadi_copy(w3, 4, res[0]);
  return 0;
}

/* coarse_jacobian_36:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f37(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_36:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_36(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_36:(u0[4],p[6])->(u[4]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f35(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_36:(i0[4],i1[6])->(o0[4]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_36:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 36 */
  w08 = 36.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@5, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w05;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @5 */
  casadi_copy(w05, 16, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_36:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_36(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_48(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f43(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_48:(u0[4],p[6])->(u[4]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f42(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_48:(i0[4],i1[6])->(o0[4]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_limit_cycle_48:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_72:(u[4],p[6])->(R[4]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 72 */
  w6 = 72.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_72:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f49(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_72:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_72(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f48(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_72:(u0[4],p[6])->(u[4]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f47(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_72:(i0[4],i1[6])->(o0[4]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_72:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 72 */
  w08 = 72.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_72:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_72(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_96:(u[4],p[6])->(R[4]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 96 */
  w6 = 96.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_96:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_96:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_96(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f55(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_96:(u0[4],p[6])->(u[4]) */
static int casadi_f53(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f54(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_96:(i0[4],i1[6])->(o0[4]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_96:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 96 */
  w08 = 96.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_96:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f52(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_144:(u[4],p[6])->(R[4]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 144 */
  w6 = 144.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_144:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_144:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_144(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f62(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_144:(u0[4],p[6])->(u[4]) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f61(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_144:(i0[4],i1[6])->(o0[4]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_144:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 144 */
  w08 = 144.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_144:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f59(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_144(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f58(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_192:(u[4],p[6])->(R[4]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 192 */
  w6 = 192.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_192:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f70(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_192:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_192(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f69(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_192:(u0[4],p[6])->(u[4]) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f68(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_192:(i0[4],i1[6])->(o0[4]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f67(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_192:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 192 */
  w08 = 192.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_192:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f65(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_288:(u[4],p[6])->(R[4]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 288 */
  w6 = 288.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #79: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_288:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_288:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_288(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f76(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_288:(u0[4],p[6])->(u[4]) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f75(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_288:(i0[4],i1[6])->(o0[4]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f74(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_288:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 288 */
  w08 = 288.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_288:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f73(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_288(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

/* compass_residual_384:(u[4],p[6])->(R[4]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+131, w4, w5, w6, *w7=w+135;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[3] */
  for (rr=(&w5), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @6 = 384 */
  w6 = 384.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
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
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #103: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_384:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+382, *w1=w+386, *w2=w+392, *w3=w+408;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: {@2, NULL} = compass_jacobian_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = compass_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f84(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_384:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+412, *w1=w+428, *w2=w+432, *w3=w+438, *w4=w+454;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [1, 1, 1, 1], 
   [0.5, 0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w1);
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@3, @4} = coarse_jacobian_384(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f83(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<16; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  /* #6: @1 = [1, 1, 1, 2] */
  casadi_copy(casadi_c1, 4, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<4; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 4, res[1]);
  return 0;
}

/* newton_384:(u0[4],p[6])->(u[4]) */
static int casadi_f81(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+4;
  m.jac_g_x = w+8;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+24;
  m.lin_v = w+32;
  m.lin_r = w+42;
  m.lin_beta = w+52;
  /* Get the initial guess */
  casadi_copy(arg[0], 4, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f82(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* scaled_newton_384:(i0[4],i1[6])->(o0[4]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+522, *w1=w+526, *w2=w+532;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f81(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_jacobian_384:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+294, *w01=w+298, *w02=w+301, *w03=w+307, *w04=w+311, *w05=w+323, w06, w07, w08, *w09=w+339;
  casadi_real *w10=w+363;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<12; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[3] */
  for (rr=(&w07), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @8 = 384 */
  w08 = 384.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
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
  arg1[4]=w02;
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_384:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+536, *w1=w+540, *w2=w+546, *w3=w+550;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = scaled_newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f80(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = compass_jacobian_384(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f85(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f79(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 566;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 566*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_12_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_24_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_36_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f26(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_48_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f49(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_72_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_96_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f63(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_144_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_192_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f77(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_288_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_residual_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_residual_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_residual_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_residual_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_residual_384_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_residual_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_residual_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_residual_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_residual_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 159;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 159*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f38(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_36_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f25(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_72_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_96_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f64(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_144_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_192_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f78(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_288_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_384_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 379;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 379*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[5],phase[2],turns[2x12],h,p[6])->(y_end[5]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80;
  a00=arg[0]? arg[0][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[3]? arg[3][0] : 0;
  a01=(a01*a02);
  a03=arg[0]? arg[0][2] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[4]? arg[4][1] : 0;
  a08=arg[0]? arg[0][3] : 0;
  a09=(a07*a08);
  a10=arg[0]? arg[0][1] : 0;
  a11=sin(a10);
  a09=(a09*a11);
  a12=(2.*a03);
  a12=(a08-a12);
  a09=(a09*a12);
  a12=sin(a00);
  a13=cos(a10);
  a14=(a12*a13);
  a15=cos(a00);
  a15=(a15*a11);
  a14=(a14-a15);
  a15=(a12-a14);
  a15=(a07*a15);
  a09=(a09+a15);
  a09=(a09+a12);
  a12=(2.*a07);
  a15=1.;
  a16=(a15-a13);
  a16=(a12*a16);
  a16=(a16+a15);
  a17=(a09/a16);
  a13=(a13-a15);
  a13=(a07*a13);
  a16=(a13/a16);
  a18=casadi_sq(a03);
  a18=(a18*a11);
  a18=(a18+a14);
  a18=(a07*a18);
  a14=arg[4]? arg[4][3] : 0;
  a11=arg[4]? arg[4][5] : 0;
  a19=arg[4]? arg[4][0] : 0;
  a19=(a11*a19);
  a20=arg[1]? arg[1][1] : 0;
  a21=(a19*a20);
  a21=(a08+a21);
  a21=(a14*a21);
  a22=arg[4]? arg[4][2] : 0;
  a23=arg[4]? arg[4][4] : 0;
  a24=arg[1]? arg[1][0] : 0;
  a25=(a24+a15);
  a25=(a11*a25);
  a25=(a23-a25);
  a25=(a25+a10);
  a25=(a22*a25);
  a21=(a21+a25);
  a18=(a18-a21);
  a09=(a16*a09);
  a18=(a18-a09);
  a13=(a13*a16);
  a13=(a07-a13);
  a18=(a18/a13);
  a16=(a16*a18);
  a17=(a17-a16);
  a16=(a06*a17);
  a13=1.7082860872947386e-01;
  a13=(a13*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a25=(a09*a18);
  a26=8.8762756430420545e-02;
  a26=(a26*a02);
  a27=1.9725056984537900e-02;
  a27=(a27*a02);
  a28=(a27*a17);
  a29=5.9175170953613701e-02;
  a29=(a29*a02);
  a30=5.2600151958767730e-02;
  a30=(a30*a02);
  a31=(a30*a18);
  a31=(a08+a31);
  a32=(a07*a31);
  a33=(a30*a08);
  a33=(a10+a33);
  a34=sin(a33);
  a32=(a32*a34);
  a35=(a30*a17);
  a35=(a03+a35);
  a36=(2.*a35);
  a36=(a31-a36);
  a32=(a32*a36);
  a30=(a30*a03);
  a30=(a00+a30);
  a36=sin(a30);
  a37=cos(a33);
  a38=(a36*a37);
  a30=cos(a30);
  a30=(a30*a34);
  a38=(a38-a30);
  a30=(a36-a38);
  a30=(a07*a30);
  a32=(a32+a30);
  a32=(a32+a36);
  a36=(a15-a37);
  a36=(a12*a36);
  a36=(a36+a15);
  a30=(a32/a36);
  a37=(a37-a15);
  a37=(a07*a37);
  a36=(a37/a36);
  a39=casadi_sq(a35);
  a39=(a39*a34);
  a39=(a39+a38);
  a39=(a07*a39);
  a38=arg[2]? arg[2][2] : 0;
  a34=(a20*a38);
  a40=arg[2]? arg[2][3] : 0;
  a41=(a24*a40);
  a34=(a34+a41);
  a34=(a19*a34);
  a34=(a31+a34);
  a34=(a14*a34);
  a38=(a24*a38);
  a40=(a20*a40);
  a38=(a38-a40);
  a38=(a38+a15);
  a38=(a11*a38);
  a38=(a23-a38);
  a38=(a38+a33);
  a38=(a22*a38);
  a34=(a34+a38);
  a39=(a39-a34);
  a32=(a36*a32);
  a39=(a39-a32);
  a37=(a37*a36);
  a37=(a07-a37);
  a39=(a39/a37);
  a36=(a36*a39);
  a30=(a30-a36);
  a30=(a29*a30);
  a28=(a28+a30);
  a28=(a03+a28);
  a30=casadi_sq(a28);
  a36=(a27*a08);
  a31=(a29*a31);
  a36=(a36+a31);
  a36=(a10+a36);
  a31=sin(a36);
  a30=(a30*a31);
  a37=(a27*a03);
  a35=(a29*a35);
  a37=(a37+a35);
  a37=(a00+a37);
  a35=sin(a37);
  a32=cos(a36);
  a34=(a35*a32);
  a37=cos(a37);
  a37=(a37*a31);
  a34=(a34-a37);
  a30=(a30+a34);
  a30=(a07*a30);
  a27=(a27*a18);
  a29=(a29*a39);
  a27=(a27+a29);
  a27=(a08+a27);
  a29=arg[2]? arg[2][4] : 0;
  a39=(a20*a29);
  a37=arg[2]? arg[2][5] : 0;
  a38=(a24*a37);
  a39=(a39+a38);
  a39=(a19*a39);
  a39=(a27+a39);
  a39=(a14*a39);
  a29=(a24*a29);
  a37=(a20*a37);
  a29=(a29-a37);
  a29=(a29+a15);
  a29=(a11*a29);
  a29=(a23-a29);
  a29=(a29+a36);
  a29=(a22*a29);
  a39=(a39+a29);
  a30=(a30-a39);
  a39=(a32-a15);
  a39=(a07*a39);
  a32=(a15-a32);
  a32=(a12*a32);
  a32=(a32+a15);
  a29=(a39/a32);
  a36=(a07*a27);
  a36=(a36*a31);
  a31=(2.*a28);
  a31=(a27-a31);
  a36=(a36*a31);
  a34=(a35-a34);
  a34=(a07*a34);
  a36=(a36+a34);
  a36=(a36+a35);
  a35=(a29*a36);
  a30=(a30-a35);
  a39=(a39*a29);
  a39=(a07-a39);
  a30=(a30/a39);
  a39=(a26*a30);
  a25=(a25+a39);
  a25=(a08+a25);
  a39=(a07*a25);
  a35=(a09*a08);
  a34=(a26*a27);
  a35=(a35+a34);
  a35=(a10+a35);
  a34=sin(a35);
  a39=(a39*a34);
  a31=(a09*a17);
  a36=(a36/a32);
  a29=(a29*a30);
  a36=(a36-a29);
  a29=(a26*a36);
  a31=(a31+a29);
  a31=(a03+a31);
  a29=(2.*a31);
  a29=(a25-a29);
  a39=(a39*a29);
  a09=(a09*a03);
  a26=(a26*a28);
  a09=(a09+a26);
  a09=(a00+a09);
  a26=sin(a09);
  a29=cos(a35);
  a32=(a26*a29);
  a09=cos(a09);
  a09=(a09*a34);
  a32=(a32-a09);
  a09=(a26-a32);
  a09=(a07*a09);
  a39=(a39+a09);
  a39=(a39+a26);
  a26=(a15-a29);
  a26=(a12*a26);
  a26=(a26+a15);
  a09=(a39/a26);
  a29=(a29-a15);
  a29=(a07*a29);
  a26=(a29/a26);
  a37=casadi_sq(a31);
  a37=(a37*a34);
  a37=(a37+a32);
  a37=(a07*a37);
  a32=arg[2]? arg[2][6] : 0;
  a34=(a20*a32);
  a38=arg[2]? arg[2][7] : 0;
  a33=(a24*a38);
  a34=(a34+a33);
  a34=(a19*a34);
  a34=(a25+a34);
  a34=(a14*a34);
  a32=(a24*a32);
  a38=(a20*a38);
  a32=(a32-a38);
  a32=(a32+a15);
  a32=(a11*a32);
  a32=(a23-a32);
  a32=(a32+a35);
  a32=(a22*a32);
  a34=(a34+a32);
  a37=(a37-a34);
  a39=(a26*a39);
  a37=(a37-a39);
  a29=(a29*a26);
  a29=(a07-a29);
  a37=(a37/a29);
  a26=(a26*a37);
  a09=(a09-a26);
  a26=(a13*a09);
  a16=(a16+a26);
  a26=1.2546768756682242e-01;
  a26=(a26*a02);
  a29=2.4136513415926669e-01;
  a29=(a29*a02);
  a39=(a29*a18);
  a34=-8.8454947932828609e-01;
  a34=(a34*a02);
  a30=(a34*a30);
  a39=(a39+a30);
  a30=9.2483400326179199e-01;
  a30=(a30*a02);
  a32=(a30*a37);
  a39=(a39+a32);
  a39=(a08+a39);
  a32=(a07*a39);
  a35=(a29*a08);
  a27=(a34*a27);
  a35=(a35+a27);
  a27=(a30*a25);
  a35=(a35+a27);
  a35=(a10+a35);
  a27=sin(a35);
  a32=(a32*a27);
  a38=(a29*a17);
  a36=(a34*a36);
  a38=(a38+a36);
  a36=(a30*a09);
  a38=(a38+a36);
  a38=(a03+a38);
  a36=(2.*a38);
  a36=(a39-a36);
  a32=(a32*a36);
  a29=(a29*a03);
  a34=(a34*a28);
  a29=(a29+a34);
  a30=(a30*a31);
  a29=(a29+a30);
  a29=(a00+a29);
  a30=sin(a29);
  a34=cos(a35);
  a28=(a30*a34);
  a29=cos(a29);
  a29=(a29*a27);
  a28=(a28-a29);
  a29=(a30-a28);
  a29=(a07*a29);
  a32=(a32+a29);
  a32=(a32+a30);
  a30=(a15-a34);
  a30=(a12*a30);
  a30=(a30+a15);
  a29=(a32/a30);
  a34=(a34-a15);
  a34=(a07*a34);
  a30=(a34/a30);
  a36=casadi_sq(a38);
  a36=(a36*a27);
  a36=(a36+a28);
  a36=(a07*a36);
  a28=arg[2]? arg[2][8] : 0;
  a27=(a20*a28);
  a33=arg[2]? arg[2][9] : 0;
  a40=(a24*a33);
  a27=(a27+a40);
  a27=(a19*a27);
  a27=(a39+a27);
  a27=(a14*a27);
  a28=(a24*a28);
  a33=(a20*a33);
  a28=(a28-a33);
  a28=(a28+a15);
  a28=(a11*a28);
  a28=(a23-a28);
  a28=(a28+a35);
  a28=(a22*a28);
  a27=(a27+a28);
  a36=(a36-a27);
  a32=(a30*a32);
  a36=(a36-a32);
  a34=(a34*a30);
  a34=(a07-a34);
  a36=(a36/a34);
  a30=(a30*a36);
  a29=(a29-a30);
  a30=(a26*a29);
  a16=(a16+a30);
  a16=(a03+a16);
  a30=(a05*a16);
  a04=(a04+a30);
  a30=1.8915178993145003e+00;
  a30=(a30*a02);
  a34=3.7109375000000000e-02;
  a34=(a34*a02);
  a32=(a34*a17);
  a27=1.7025221101954405e-01;
  a27=(a27*a02);
  a28=(a27*a09);
  a32=(a32+a28);
  a28=6.0216538980455959e-02;
  a28=(a28*a02);
  a35=(a28*a29);
  a32=(a32+a35);
  a35=-1.7578125000000000e-02;
  a35=(a35*a02);
  a33=(a06*a18);
  a40=(a13*a37);
  a33=(a33+a40);
  a40=(a26*a36);
  a33=(a33+a40);
  a33=(a08+a33);
  a40=(a07*a33);
  a41=(a06*a08);
  a42=(a13*a25);
  a41=(a41+a42);
  a42=(a26*a39);
  a41=(a41+a42);
  a41=(a10+a41);
  a42=sin(a41);
  a40=(a40*a42);
  a43=(2.*a16);
  a43=(a33-a43);
  a40=(a40*a43);
  a06=(a06*a03);
  a13=(a13*a31);
  a06=(a06+a13);
  a26=(a26*a38);
  a06=(a06+a26);
  a06=(a00+a06);
  a26=sin(a06);
  a13=cos(a41);
  a43=(a26*a13);
  a06=cos(a06);
  a06=(a06*a42);
  a43=(a43-a06);
  a06=(a26-a43);
  a06=(a07*a06);
  a40=(a40+a06);
  a40=(a40+a26);
  a26=(a15-a13);
  a26=(a12*a26);
  a26=(a26+a15);
  a06=(a40/a26);
  a13=(a13-a15);
  a13=(a07*a13);
  a26=(a13/a26);
  a44=casadi_sq(a16);
  a44=(a44*a42);
  a44=(a44+a43);
  a44=(a07*a44);
  a43=arg[2]? arg[2][10] : 0;
  a42=(a20*a43);
  a45=arg[2]? arg[2][11] : 0;
  a46=(a24*a45);
  a42=(a42+a46);
  a42=(a19*a42);
  a42=(a33+a42);
  a42=(a14*a42);
  a43=(a24*a43);
  a45=(a20*a45);
  a43=(a43-a45);
  a43=(a43+a15);
  a43=(a11*a43);
  a43=(a23-a43);
  a43=(a43+a41);
  a43=(a22*a43);
  a42=(a42+a43);
  a44=(a44-a42);
  a40=(a26*a40);
  a44=(a44-a40);
  a13=(a13*a26);
  a13=(a07-a13);
  a44=(a44/a13);
  a26=(a26*a44);
  a06=(a06-a26);
  a26=(a35*a06);
  a32=(a32+a26);
  a32=(a03+a32);
  a26=(a30*a32);
  a04=(a04+a26);
  a26=-5.8012039600105849e+00;
  a26=(a26*a02);
  a13=3.7092000118504789e-02;
  a13=(a13*a02);
  a40=(a13*a17);
  a43=1.7038392571223998e-01;
  a43=(a43*a02);
  a41=(a43*a09);
  a40=(a40+a41);
  a41=1.0726203044637328e-01;
  a41=(a41*a02);
  a45=(a41*a29);
  a40=(a40+a45);
  a45=-1.5319437748624402e-02;
  a45=(a45*a02);
  a46=(a45*a06);
  a40=(a40+a46);
  a46=8.2737891638140233e-03;
  a46=(a46*a02);
  a47=(a34*a18);
  a48=(a27*a37);
  a47=(a47+a48);
  a48=(a28*a36);
  a47=(a47+a48);
  a48=(a35*a44);
  a47=(a47+a48);
  a47=(a08+a47);
  a48=(a07*a47);
  a49=(a34*a08);
  a50=(a27*a25);
  a49=(a49+a50);
  a50=(a28*a39);
  a49=(a49+a50);
  a50=(a35*a33);
  a49=(a49+a50);
  a49=(a10+a49);
  a50=sin(a49);
  a48=(a48*a50);
  a51=(2.*a32);
  a51=(a47-a51);
  a48=(a48*a51);
  a34=(a34*a03);
  a27=(a27*a31);
  a34=(a34+a27);
  a28=(a28*a38);
  a34=(a34+a28);
  a35=(a35*a16);
  a34=(a34+a35);
  a34=(a00+a34);
  a35=sin(a34);
  a28=cos(a49);
  a27=(a35*a28);
  a34=cos(a34);
  a34=(a34*a50);
  a27=(a27-a34);
  a34=(a35-a27);
  a34=(a07*a34);
  a48=(a48+a34);
  a48=(a48+a35);
  a35=(a15-a28);
  a35=(a12*a35);
  a35=(a35+a15);
  a34=(a48/a35);
  a28=(a28-a15);
  a28=(a07*a28);
  a35=(a28/a35);
  a51=casadi_sq(a32);
  a51=(a51*a50);
  a51=(a51+a27);
  a51=(a07*a51);
  a27=arg[2]? arg[2][12] : 0;
  a50=(a20*a27);
  a52=arg[2]? arg[2][13] : 0;
  a53=(a24*a52);
  a50=(a50+a53);
  a50=(a19*a50);
  a50=(a47+a50);
  a50=(a14*a50);
  a27=(a24*a27);
  a52=(a20*a52);
  a27=(a27-a52);
  a27=(a27+a15);
  a27=(a11*a27);
  a27=(a23-a27);
  a27=(a27+a49);
  a27=(a22*a27);
  a50=(a50+a27);
  a51=(a51-a50);
  a48=(a35*a48);
  a51=(a51-a48);
  a28=(a28*a35);
  a28=(a07-a28);
  a51=(a51/a28);
  a35=(a35*a51);
  a34=(a34-a35);
  a35=(a46*a34);
  a40=(a40+a35);
  a40=(a03+a40);
  a35=(a26*a40);
  a04=(a04+a35);
  a35=3.1116436695781990e-01;
  a35=(a35*a02);
  a28=6.2411095871607569e-01;
  a28=(a28*a02);
  a48=(a28*a17);
  a27=-3.3608926294469414e+00;
  a27=(a27*a02);
  a49=(a27*a09);
  a48=(a48+a49);
  a49=-8.6821934684172597e-01;
  a49=(a49*a02);
  a52=(a49*a29);
  a48=(a48+a52);
  a52=2.7592099699446710e+01;
  a52=(a52*a02);
  a53=(a52*a06);
  a48=(a48+a53);
  a53=2.0154067550477894e+01;
  a53=(a53*a02);
  a54=(a53*a34);
  a48=(a48+a54);
  a54=-4.3489884181069961e+01;
  a54=(a54*a02);
  a55=(a13*a18);
  a56=(a43*a37);
  a55=(a55+a56);
  a56=(a41*a36);
  a55=(a55+a56);
  a56=(a45*a44);
  a55=(a55+a56);
  a56=(a46*a51);
  a55=(a55+a56);
  a55=(a08+a55);
  a56=(a07*a55);
  a57=(a13*a08);
  a58=(a43*a25);
  a57=(a57+a58);
  a58=(a41*a39);
  a57=(a57+a58);
  a58=(a45*a33);
  a57=(a57+a58);
  a58=(a46*a47);
  a57=(a57+a58);
  a57=(a10+a57);
  a58=sin(a57);
  a56=(a56*a58);
  a59=(2.*a40);
  a59=(a55-a59);
  a56=(a56*a59);
  a13=(a13*a03);
  a43=(a43*a31);
  a13=(a13+a43);
  a41=(a41*a38);
  a13=(a13+a41);
  a45=(a45*a16);
  a13=(a13+a45);
  a46=(a46*a32);
  a13=(a13+a46);
  a13=(a00+a13);
  a46=sin(a13);
  a45=cos(a57);
  a41=(a46*a45);
  a13=cos(a13);
  a13=(a13*a58);
  a41=(a41-a13);
  a13=(a46-a41);
  a13=(a07*a13);
  a56=(a56+a13);
  a56=(a56+a46);
  a46=(a15-a45);
  a46=(a12*a46);
  a46=(a46+a15);
  a13=(a56/a46);
  a45=(a45-a15);
  a45=(a07*a45);
  a46=(a45/a46);
  a43=casadi_sq(a40);
  a43=(a43*a58);
  a43=(a43+a41);
  a43=(a07*a43);
  a41=arg[2]? arg[2][14] : 0;
  a58=(a20*a41);
  a59=arg[2]? arg[2][15] : 0;
  a60=(a24*a59);
  a58=(a58+a60);
  a58=(a19*a58);
  a58=(a55+a58);
  a58=(a14*a58);
  a41=(a24*a41);
  a59=(a20*a59);
  a41=(a41-a59);
  a41=(a41+a15);
  a41=(a11*a41);
  a41=(a23-a41);
  a41=(a41+a57);
  a41=(a22*a41);
  a58=(a58+a41);
  a43=(a43-a58);
  a56=(a46*a56);
  a43=(a43-a56);
  a45=(a45*a46);
  a45=(a07-a45);
  a43=(a43/a45);
  a46=(a46*a43);
  a13=(a13-a46);
  a46=(a54*a13);
  a48=(a48+a46);
  a48=(a03+a48);
  a46=(a35*a48);
  a04=(a04+a46);
  a46=-1.5216094966251609e-01;
  a46=(a46*a02);
  a45=4.7766253643826434e-01;
  a45=(a45*a02);
  a56=(a45*a17);
  a41=-2.4881146199716677e+00;
  a41=(a41*a02);
  a57=(a41*a09);
  a56=(a56+a57);
  a57=-5.9029082683684297e-01;
  a57=(a57*a02);
  a59=(a57*a29);
  a56=(a56+a59);
  a59=2.1230051448181193e+01;
  a59=(a59*a02);
  a60=(a59*a06);
  a56=(a56+a60);
  a60=1.5279233632882423e+01;
  a60=(a60*a02);
  a61=(a60*a34);
  a56=(a56+a61);
  a61=-3.3288210968984863e+01;
  a61=(a61*a02);
  a62=(a61*a13);
  a56=(a56+a62);
  a62=-2.0331201708508627e-02;
  a62=(a62*a02);
  a63=(a28*a18);
  a64=(a27*a37);
  a63=(a63+a64);
  a64=(a49*a36);
  a63=(a63+a64);
  a64=(a52*a44);
  a63=(a63+a64);
  a64=(a53*a51);
  a63=(a63+a64);
  a64=(a54*a43);
  a63=(a63+a64);
  a63=(a08+a63);
  a64=(a07*a63);
  a65=(a28*a08);
  a66=(a27*a25);
  a65=(a65+a66);
  a66=(a49*a39);
  a65=(a65+a66);
  a66=(a52*a33);
  a65=(a65+a66);
  a66=(a53*a47);
  a65=(a65+a66);
  a66=(a54*a55);
  a65=(a65+a66);
  a65=(a10+a65);
  a66=sin(a65);
  a64=(a64*a66);
  a67=(2.*a48);
  a67=(a63-a67);
  a64=(a64*a67);
  a28=(a28*a03);
  a27=(a27*a31);
  a28=(a28+a27);
  a49=(a49*a38);
  a28=(a28+a49);
  a52=(a52*a16);
  a28=(a28+a52);
  a53=(a53*a32);
  a28=(a28+a53);
  a54=(a54*a40);
  a28=(a28+a54);
  a28=(a00+a28);
  a54=sin(a28);
  a53=cos(a65);
  a52=(a54*a53);
  a28=cos(a28);
  a28=(a28*a66);
  a52=(a52-a28);
  a28=(a54-a52);
  a28=(a07*a28);
  a64=(a64+a28);
  a64=(a64+a54);
  a54=(a15-a53);
  a54=(a12*a54);
  a54=(a54+a15);
  a28=(a64/a54);
  a53=(a53-a15);
  a53=(a07*a53);
  a54=(a53/a54);
  a49=casadi_sq(a48);
  a49=(a49*a66);
  a49=(a49+a52);
  a49=(a07*a49);
  a52=arg[2]? arg[2][16] : 0;
  a66=(a20*a52);
  a27=arg[2]? arg[2][17] : 0;
  a67=(a24*a27);
  a66=(a66+a67);
  a66=(a19*a66);
  a66=(a63+a66);
  a66=(a14*a66);
  a52=(a24*a52);
  a27=(a20*a27);
  a52=(a52-a27);
  a52=(a52+a15);
  a52=(a11*a52);
  a52=(a23-a52);
  a52=(a52+a65);
  a52=(a22*a52);
  a66=(a66+a52);
  a49=(a49-a66);
  a64=(a54*a64);
  a49=(a49-a64);
  a53=(a53*a54);
  a53=(a07-a53);
  a49=(a49/a53);
  a54=(a54*a49);
  a28=(a28-a54);
  a54=(a62*a28);
  a56=(a56+a54);
  a56=(a03+a56);
  a54=(a46*a56);
  a04=(a04+a54);
  a54=2.0136540080403034e-01;
  a54=(a54*a02);
  a53=-9.3714243008598730e-01;
  a53=(a53*a02);
  a64=(a53*a17);
  a52=5.1863724288440638e+00;
  a52=(a52*a02);
  a65=(a52*a09);
  a64=(a64+a65);
  a65=1.0914373489967295e+00;
  a65=(a65*a02);
  a27=(a65*a29);
  a64=(a64+a27);
  a27=-8.1497870107469268e+00;
  a27=(a27*a02);
  a67=(a27*a06);
  a64=(a64+a67);
  a67=-1.8520065659996959e+01;
  a67=(a67*a02);
  a68=(a67*a34);
  a64=(a64+a68);
  a68=2.2739487099350505e+01;
  a68=(a68*a02);
  a69=(a68*a13);
  a64=(a64+a69);
  a69=2.4936055526796523e+00;
  a69=(a69*a02);
  a70=(a69*a28);
  a64=(a64+a70);
  a70=-3.0467644718982196e+00;
  a70=(a70*a02);
  a71=(a45*a18);
  a72=(a41*a37);
  a71=(a71+a72);
  a72=(a57*a36);
  a71=(a71+a72);
  a72=(a59*a44);
  a71=(a71+a72);
  a72=(a60*a51);
  a71=(a71+a72);
  a72=(a61*a43);
  a71=(a71+a72);
  a72=(a62*a49);
  a71=(a71+a72);
  a71=(a08+a71);
  a72=(a07*a71);
  a73=(a45*a08);
  a74=(a41*a25);
  a73=(a73+a74);
  a74=(a57*a39);
  a73=(a73+a74);
  a74=(a59*a33);
  a73=(a73+a74);
  a74=(a60*a47);
  a73=(a73+a74);
  a74=(a61*a55);
  a73=(a73+a74);
  a74=(a62*a63);
  a73=(a73+a74);
  a73=(a10+a73);
  a74=sin(a73);
  a72=(a72*a74);
  a75=(2.*a56);
  a75=(a71-a75);
  a72=(a72*a75);
  a45=(a45*a03);
  a41=(a41*a31);
  a45=(a45+a41);
  a57=(a57*a38);
  a45=(a45+a57);
  a59=(a59*a16);
  a45=(a45+a59);
  a60=(a60*a32);
  a45=(a45+a60);
  a61=(a61*a40);
  a45=(a45+a61);
  a62=(a62*a48);
  a45=(a45+a62);
  a45=(a00+a45);
  a62=sin(a45);
  a61=cos(a73);
  a60=(a62*a61);
  a45=cos(a45);
  a45=(a45*a74);
  a60=(a60-a45);
  a45=(a62-a60);
  a45=(a07*a45);
  a72=(a72+a45);
  a72=(a72+a62);
  a62=(a15-a61);
  a62=(a12*a62);
  a62=(a62+a15);
  a45=(a72/a62);
  a61=(a61-a15);
  a61=(a07*a61);
  a62=(a61/a62);
  a59=casadi_sq(a56);
  a59=(a59*a74);
  a59=(a59+a60);
  a59=(a07*a59);
  a60=arg[2]? arg[2][18] : 0;
  a74=(a20*a60);
  a57=arg[2]? arg[2][19] : 0;
  a41=(a24*a57);
  a74=(a74+a41);
  a74=(a19*a74);
  a74=(a71+a74);
  a74=(a14*a74);
  a60=(a24*a60);
  a57=(a20*a57);
  a60=(a60-a57);
  a60=(a60+a15);
  a60=(a11*a60);
  a60=(a23-a60);
  a60=(a60+a73);
  a60=(a22*a60);
  a74=(a74+a60);
  a59=(a59-a74);
  a72=(a62*a72);
  a59=(a59-a72);
  a61=(a61*a62);
  a61=(a07-a61);
  a59=(a59/a61);
  a62=(a62*a59);
  a45=(a45-a62);
  a62=(a70*a45);
  a64=(a64+a62);
  a64=(a03+a64);
  a62=(a54*a64);
  a04=(a04+a62);
  a62=4.4710615727772587e-02;
  a62=(a62*a02);
  a61=2.2733101475165380e+00;
  a61=(a61*a02);
  a72=(a61*a17);
  a60=-1.0534495466737249e+01;
  a60=(a60*a02);
  a09=(a60*a09);
  a72=(a72+a09);
  a09=-2.0008720582248625e+00;
  a09=(a09*a02);
  a29=(a09*a29);
  a72=(a72+a29);
  a29=-1.7958931863118799e+01;
  a29=(a29*a02);
  a73=(a29*a06);
  a72=(a72+a73);
  a73=2.7948884529419960e+01;
  a73=(a73*a02);
  a57=(a73*a34);
  a72=(a72+a57);
  a57=-2.8589982771350235e+00;
  a57=(a57*a02);
  a41=(a57*a13);
  a72=(a72+a41);
  a41=-8.8728569335306293e+00;
  a41=(a41*a02);
  a75=(a41*a28);
  a72=(a72+a75);
  a75=1.2360567175794303e+01;
  a75=(a75*a02);
  a76=(a75*a45);
  a72=(a72+a76);
  a76=6.4339274601576357e-01;
  a76=(a76*a02);
  a02=(a53*a18);
  a77=(a52*a37);
  a02=(a02+a77);
  a77=(a65*a36);
  a02=(a02+a77);
  a77=(a27*a44);
  a02=(a02+a77);
  a77=(a67*a51);
  a02=(a02+a77);
  a77=(a68*a43);
  a02=(a02+a77);
  a77=(a69*a49);
  a02=(a02+a77);
  a77=(a70*a59);
  a02=(a02+a77);
  a02=(a08+a02);
  a77=(a07*a02);
  a78=(a53*a08);
  a79=(a52*a25);
  a78=(a78+a79);
  a79=(a65*a39);
  a78=(a78+a79);
  a79=(a27*a33);
  a78=(a78+a79);
  a79=(a67*a47);
  a78=(a78+a79);
  a79=(a68*a55);
  a78=(a78+a79);
  a79=(a69*a63);
  a78=(a78+a79);
  a79=(a70*a71);
  a78=(a78+a79);
  a78=(a10+a78);
  a79=sin(a78);
  a77=(a77*a79);
  a80=(2.*a64);
  a80=(a02-a80);
  a77=(a77*a80);
  a53=(a53*a03);
  a52=(a52*a31);
  a53=(a53+a52);
  a65=(a65*a38);
  a53=(a53+a65);
  a27=(a27*a16);
  a53=(a53+a27);
  a67=(a67*a32);
  a53=(a53+a67);
  a68=(a68*a40);
  a53=(a53+a68);
  a69=(a69*a48);
  a53=(a53+a69);
  a70=(a70*a56);
  a53=(a53+a70);
  a53=(a00+a53);
  a70=sin(a53);
  a69=cos(a78);
  a68=(a70*a69);
  a53=cos(a53);
  a53=(a53*a79);
  a68=(a68-a53);
  a53=(a70-a68);
  a53=(a07*a53);
  a77=(a77+a53);
  a77=(a77+a70);
  a70=(a15-a69);
  a70=(a12*a70);
  a70=(a70+a15);
  a53=(a77/a70);
  a69=(a69-a15);
  a69=(a07*a69);
  a70=(a69/a70);
  a67=casadi_sq(a64);
  a67=(a67*a79);
  a67=(a67+a68);
  a67=(a07*a67);
  a68=arg[2]? arg[2][20] : 0;
  a79=(a20*a68);
  a27=arg[2]? arg[2][21] : 0;
  a65=(a24*a27);
  a79=(a79+a65);
  a79=(a19*a79);
  a79=(a02+a79);
  a79=(a14*a79);
  a68=(a24*a68);
  a27=(a20*a27);
  a68=(a68-a27);
  a68=(a68+a15);
  a68=(a11*a68);
  a68=(a23-a68);
  a68=(a68+a78);
  a68=(a22*a68);
  a79=(a79+a68);
  a67=(a67-a79);
  a77=(a70*a77);
  a67=(a67-a77);
  a69=(a69*a70);
  a69=(a07-a69);
  a67=(a67/a69);
  a70=(a70*a67);
  a53=(a53-a70);
  a70=(a76*a53);
  a72=(a72+a70);
  a72=(a03+a72);
  a70=(a62*a72);
  a04=(a04+a70);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a70=(a05*a33);
  a04=(a04+a70);
  a70=(a30*a47);
  a04=(a04+a70);
  a70=(a26*a55);
  a04=(a04+a70);
  a70=(a35*a63);
  a04=(a04+a70);
  a70=(a46*a71);
  a04=(a04+a70);
  a70=(a54*a02);
  a04=(a04+a70);
  a70=(a61*a18);
  a37=(a60*a37);
  a70=(a70+a37);
  a36=(a09*a36);
  a70=(a70+a36);
  a36=(a29*a44);
  a70=(a70+a36);
  a36=(a73*a51);
  a70=(a70+a36);
  a36=(a57*a43);
  a70=(a70+a36);
  a36=(a41*a49);
  a70=(a70+a36);
  a36=(a75*a59);
  a70=(a70+a36);
  a36=(a76*a67);
  a70=(a70+a36);
  a70=(a08+a70);
  a36=(a62*a70);
  a04=(a04+a36);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a17=(a01*a17);
  a06=(a05*a06);
  a17=(a17+a06);
  a34=(a30*a34);
  a17=(a17+a34);
  a13=(a26*a13);
  a17=(a17+a13);
  a28=(a35*a28);
  a17=(a17+a28);
  a45=(a46*a45);
  a17=(a17+a45);
  a53=(a54*a53);
  a17=(a17+a53);
  a53=(a07*a70);
  a45=(a61*a08);
  a25=(a60*a25);
  a45=(a45+a25);
  a39=(a09*a39);
  a45=(a45+a39);
  a39=(a29*a33);
  a45=(a45+a39);
  a39=(a73*a47);
  a45=(a45+a39);
  a39=(a57*a55);
  a45=(a45+a39);
  a39=(a41*a63);
  a45=(a45+a39);
  a39=(a75*a71);
  a45=(a45+a39);
  a39=(a76*a02);
  a45=(a45+a39);
  a10=(a10+a45);
  a45=sin(a10);
  a53=(a53*a45);
  a39=(2.*a72);
  a39=(a70-a39);
  a53=(a53*a39);
  a61=(a61*a03);
  a60=(a60*a31);
  a61=(a61+a60);
  a09=(a09*a38);
  a61=(a61+a09);
  a29=(a29*a16);
  a61=(a61+a29);
  a73=(a73*a32);
  a61=(a61+a73);
  a57=(a57*a40);
  a61=(a61+a57);
  a41=(a41*a48);
  a61=(a61+a41);
  a75=(a75*a56);
  a61=(a61+a75);
  a76=(a76*a64);
  a61=(a61+a76);
  a00=(a00+a61);
  a61=sin(a00);
  a76=cos(a10);
  a64=(a61*a76);
  a00=cos(a00);
  a00=(a00*a45);
  a64=(a64-a00);
  a00=(a61-a64);
  a00=(a07*a00);
  a53=(a53+a00);
  a53=(a53+a61);
  a61=(a15-a76);
  a12=(a12*a61);
  a12=(a12+a15);
  a61=(a53/a12);
  a76=(a76-a15);
  a76=(a07*a76);
  a12=(a76/a12);
  a72=casadi_sq(a72);
  a72=(a72*a45);
  a72=(a72+a64);
  a72=(a07*a72);
  a64=arg[2]? arg[2][22] : 0;
  a45=(a20*a64);
  a00=arg[2]? arg[2][23] : 0;
  a75=(a24*a00);
  a45=(a45+a75);
  a19=(a19*a45);
  a19=(a70+a19);
  a14=(a14*a19);
  a24=(a24*a64);
  a20=(a20*a00);
  a24=(a24-a20);
  a24=(a24+a15);
  a11=(a11*a24);
  a23=(a23-a11);
  a23=(a23+a10);
  a22=(a22*a23);
  a14=(a14+a22);
  a72=(a72-a14);
  a53=(a12*a53);
  a72=(a72-a53);
  a76=(a76*a12);
  a07=(a07-a76);
  a72=(a72/a07);
  a12=(a12*a72);
  a61=(a61-a12);
  a61=(a62*a61);
  a17=(a17+a61);
  a03=(a03+a17);
  if (res[0]!=0) res[0][2]=a03;
  a18=(a01*a18);
  a44=(a05*a44);
  a18=(a18+a44);
  a51=(a30*a51);
  a18=(a18+a51);
  a43=(a26*a43);
  a18=(a18+a43);
  a49=(a35*a49);
  a18=(a18+a49);
  a59=(a46*a59);
  a18=(a18+a59);
  a67=(a54*a67);
  a18=(a18+a67);
  a72=(a62*a72);
  a18=(a18+a72);
  a18=(a08+a18);
  if (res[0]!=0) res[0][3]=a18;
  a18=arg[0]? arg[0][4] : 0;
  a21=(a21*a08);
  a01=(a01*a21);
  a42=(a42*a33);
  a05=(a05*a42);
  a01=(a01+a05);
  a50=(a50*a47);
  a30=(a30*a50);
  a01=(a01+a30);
  a58=(a58*a55);
  a26=(a26*a58);
  a01=(a01+a26);
  a66=(a66*a63);
  a35=(a35*a66);
  a01=(a01+a35);
  a74=(a74*a71);
  a46=(a46*a74);
  a01=(a01+a46);
  a79=(a79*a02);
  a54=(a54*a79);
  a01=(a01+a54);
  a14=(a14*a70);
  a62=(a62*a14);
  a01=(a01+a62);
  a18=(a18-a01);
  if (res[0]!=0) res[0][4]=a18;
  return 0;
}

/* observe:(t,y[4],p[6])->(g[10],dg[10]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64;
  a00=arg[2]? arg[2][1] : 0;
  a01=arg[1]? arg[1][0] : 0;
  a02=arg[1]? arg[1][1] : 0;
  a03=(a01-a02);
  a04=sin(a03);
  a05=sin(a01);
  a06=(a04-a05);
  a06=(a00*a06);
  a06=(a06-a05);
  a07=(2.*a00);
  a08=1.;
  a09=(a07+a08);
  a10=(a06/a09);
  a11=cos(a01);
  a03=cos(a03);
  a12=(a11-a03);
  a13=(a00*a12);
  a13=(a13+a11);
  a13=(a13/a09);
  a14=arg[1]? arg[1][3] : 0;
  a15=(a00*a14);
  a16=sin(a02);
  a17=(a15*a16);
  a18=arg[1]? arg[1][2] : 0;
  a19=(2.*a18);
  a20=(a14-a19);
  a21=(a17*a20);
  a22=(a21-a06);
  a23=cos(a02);
  a24=(a08-a23);
  a24=(a07*a24);
  a24=(a24+a08);
  a25=(a22/a24);
  a26=(a23-a08);
  a26=(a00*a26);
  a27=(a26/a24);
  a28=casadi_sq(a18);
  a29=(a28*a16);
  a29=(a29+a04);
  a29=(a00*a29);
  a30=arg[2]? arg[2][3] : 0;
  a31=arg[2]? arg[2][5] : 0;
  a32=arg[2]? arg[2][0] : 0;
  a33=(a31*a32);
  a34=arg[0]? arg[0][0] : 0;
  a34=(a32*a34);
  a35=sin(a34);
  a36=(a33*a35);
  a36=(a14+a36);
  a36=(a30*a36);
  a37=arg[2]? arg[2][2] : 0;
  a38=arg[2]? arg[2][4] : 0;
  a34=cos(a34);
  a39=(a34+a08);
  a39=(a31*a39);
  a38=(a38-a39);
  a38=(a38+a02);
  a38=(a37*a38);
  a36=(a36+a38);
  a29=(a29-a36);
  a38=(a27*a22);
  a38=(a29-a38);
  a39=(a26*a27);
  a39=(a00-a39);
  a38=(a38/a39);
  a40=(a27*a38);
  a40=(a25-a40);
  a41=(a03-a11);
  a42=(a00*a41);
  a42=(a42-a11);
  a43=(a40*a42);
  a44=(a38*a00);
  a45=(a44*a03);
  a43=(a43-a45);
  a45=(a15*a04);
  a46=(a18-a14);
  a47=(a45*a46);
  a43=(a43+a47);
  a47=(a05-a04);
  a48=(a18*a47);
  a49=(a14*a04);
  a48=(a48+a49);
  a48=(a00*a48);
  a49=(a18*a05);
  a48=(a48+a49);
  a49=(a18*a48);
  a43=(a43+a49);
  a49=(a13*a43);
  a50=(a40*a06);
  a51=(a44*a04);
  a50=(a50-a51);
  a51=(a00*a03);
  a52=(a51*a14);
  a53=(a14-a18);
  a54=(a52*a53);
  a50=(a50+a54);
  a54=(a18*a41);
  a55=(a03*a14);
  a54=(a54-a55);
  a54=(a00*a54);
  a55=(a11*a18);
  a54=(a54-a55);
  a56=(a18*a54);
  a57=(a50+a56);
  a57=(a57+a09);
  a49=(a49/a57);
  a10=(a10-a49);
  a10=(-a10);
  if (res[0]!=0) res[0][0]=a10;
  a10=0.;
  if (res[0]!=0) res[0][1]=a10;
  a50=(a50+a07);
  a50=(a50+a56);
  a50=(a50+a08);
  if (res[0]!=0) res[0][2]=a50;
  a08=(a43/a50);
  if (res[0]!=0) res[0][3]=a08;
  if (res[0]!=0) res[0][4]=a12;
  a12=(a00*a47);
  a21=(a21+a12);
  a21=(a21+a05);
  a12=(a21/a24);
  a56=(a27*a21);
  a29=(a29-a56);
  a29=(a29/a39);
  a56=(a27*a29);
  a56=(a12-a56);
  if (res[0]!=0) res[0][5]=a56;
  a01=(2.*a01);
  a02=(a02-a01);
  if (res[0]!=0) res[0][6]=a02;
  if (res[0]!=0) res[0][7]=a10;
  a02=(a36*a14);
  a02=(-a02);
  if (res[0]!=0) res[0][8]=a02;
  a02=(-a36);
  if (res[0]!=0) res[0][9]=a02;
  a02=(a03*a46);
  a01=(a02-a55);
  a01=(a00*a01);
  a01=(a01-a55);
  a58=(a01/a09);
  a59=(a04*a46);
  a60=(a05*a18);
  a61=(a59-a60);
  a62=(a00*a61);
  a62=(a62-a60);
  a62=(a62/a09);
  a43=(a43*a62);
  a62=(a00*a29);
  a09=(a16*a62);
  a23=(a23*a14);
  a63=(a15*a23);
  a09=(a09+a63);
  a09=(a20*a09);
  a63=(2.*a56);
  a63=(a29-a63);
  a17=(a17*a63);
  a09=(a09+a17);
  a17=(a09-a01);
  a63=(a17/a24);
  a25=(a25/a24);
  a64=(a16*a14);
  a07=(a07*a64);
  a25=(a25*a07);
  a63=(a63-a25);
  a19=(a19*a56);
  a16=(a16*a19);
  a28=(a28*a23);
  a16=(a16+a28);
  a16=(a16+a02);
  a16=(a00*a16);
  a34=(a34*a32);
  a33=(a33*a34);
  a33=(a29+a33);
  a30=(a30*a33);
  a35=(a35*a32);
  a31=(a31*a35);
  a31=(a31+a14);
  a37=(a37*a31);
  a30=(a30+a37);
  a16=(a16-a30);
  a17=(a27*a17);
  a64=(a00*a64);
  a37=(a64/a24);
  a31=(a27/a24);
  a31=(a31*a07);
  a37=(a37+a31);
  a22=(a22*a37);
  a17=(a17-a22);
  a17=(a16-a17);
  a17=(a17/a39);
  a22=(a38/a39);
  a64=(a27*a64);
  a26=(a26*a37);
  a64=(a64+a26);
  a22=(a22*a64);
  a17=(a17-a22);
  a22=(a27*a17);
  a38=(a38*a37);
  a22=(a22-a38);
  a63=(a63-a22);
  a42=(a42*a63);
  a22=(a60-a59);
  a38=(a00*a22);
  a38=(a38+a60);
  a38=(a40*a38);
  a42=(a42+a38);
  a17=(a00*a17);
  a38=(a03*a17);
  a26=(a44*a59);
  a38=(a38-a26);
  a42=(a42-a38);
  a62=(a04*a62);
  a15=(a15*a02);
  a62=(a62+a15);
  a46=(a46*a62);
  a62=(a56-a29);
  a45=(a45*a62);
  a46=(a46+a45);
  a42=(a42+a46);
  a48=(a48*a56);
  a47=(a47*a56);
  a46=(a55-a02);
  a45=(a18*a46);
  a47=(a47+a45);
  a45=(a04*a29);
  a62=(a14*a02);
  a45=(a45+a62);
  a47=(a47+a45);
  a47=(a00*a47);
  a05=(a05*a56);
  a45=(a18*a55);
  a05=(a05+a45);
  a47=(a47+a05);
  a47=(a18*a47);
  a48=(a48+a47);
  a42=(a42+a48);
  a13=(a13*a42);
  a43=(a43+a13);
  a43=(a43/a57);
  a49=(a49/a57);
  a06=(a06*a63);
  a40=(a40*a01);
  a06=(a06+a40);
  a04=(a04*a17);
  a44=(a44*a02);
  a04=(a04+a44);
  a06=(a06-a04);
  a51=(a51*a29);
  a04=(a00*a59);
  a04=(a14*a04);
  a51=(a51-a04);
  a53=(a53*a51);
  a51=(a29-a56);
  a52=(a52*a51);
  a53=(a53+a52);
  a06=(a06+a53);
  a54=(a54*a56);
  a41=(a41*a56);
  a22=(a18*a22);
  a41=(a41+a22);
  a03=(a03*a29);
  a59=(a14*a59);
  a03=(a03-a59);
  a41=(a41-a03);
  a41=(a00*a41);
  a11=(a11*a56);
  a60=(a18*a60);
  a11=(a11-a60);
  a41=(a41-a11);
  a18=(a18*a41);
  a54=(a54+a18);
  a06=(a06+a54);
  a49=(a49*a06);
  a43=(a43-a49);
  a58=(a58-a43);
  a58=(-a58);
  if (res[1]!=0) res[1][0]=a58;
  if (res[1]!=0) res[1][1]=a10;
  if (res[1]!=0) res[1][2]=a06;
  a42=(a42/a50);
  a08=(a08/a50);
  a08=(a08*a06);
  a42=(a42-a08);
  if (res[1]!=0) res[1][3]=a42;
  if (res[1]!=0) res[1][4]=a61;
  a00=(a00*a46);
  a09=(a09+a00);
  a09=(a09+a55);
  a55=(a09/a24);
  a12=(a12/a24);
  a12=(a12*a07);
  a55=(a55-a12);
  a09=(a27*a09);
  a21=(a21*a37);
  a09=(a09-a21);
  a16=(a16-a09);
  a16=(a16/a39);
  a39=(a29/a39);
  a39=(a39*a64);
  a16=(a16-a39);
  a27=(a27*a16);
  a37=(a29*a37);
  a27=(a27-a37);
  a55=(a55-a27);
  if (res[1]!=0) res[1][5]=a55;
  if (res[1]!=0) res[1][6]=a20;
  if (res[1]!=0) res[1][7]=a10;
  a14=(a14*a30);
  a36=(a36*a29);
  a14=(a14+a36);
  a14=(-a14);
  if (res[1]!=0) res[1][8]=a14;
  a30=(-a30);
  if (res[1]!=0) res[1][9]=a30;
  return 0;
}

/* working_steps:(t,turns[2x12],w[5],h,p[6])->(w_end[5],nodes[5x12],g[10x12],dg[10x12]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, *w00=w+81, w01, *w02=w+86, *w03=w+92, w05, *w06=w+94, w07, *w08=w+99, *w09=w+104, *w10=w+109;
  casadi_real *w11=w+114, *w12=w+119, *w13=w+124, *w14=w+129, *w15=w+134, *w16=w+139, *w17=w+144, *w18=w+149, *w19=w+154, *w20=w+158, *w21=w+168, *w22=w+178;
  casadi_real *w23=w+188, *w24=w+198, *w25=w+208, *w26=w+218, *w27=w+228, *w28=w+238, *w29=w+248, *w30=w+258, *w31=w+268, *w32=w+278;
  const casadi_real **arg1=arg+5, *cs, *wr04;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 5, w00);
  /* #1: @1 = input[0][0] */
  w01 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 6, w02);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w01);
  arg1[1]=w02;
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
  arg1[4]=w02;
  res1[0]=w06;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = working_step(@6, @3, @4, @5, @2) */
  arg1[0]=w06;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w08;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #11: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @9 = working_step(@8, @3, @4, @5, @2) */
  arg1[0]=w08;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @10 = working_step(@9, @3, @4, @5, @2) */
  arg1[0]=w09;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @11 = working_step(@10, @3, @4, @5, @2) */
  arg1[0]=w10;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @12 = working_step(@11, @3, @4, @5, @2) */
  arg1[0]=w11;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @13 = working_step(@12, @3, @4, @5, @2) */
  arg1[0]=w12;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @14 = working_step(@13, @3, @4, @5, @2) */
  arg1[0]=w13;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @15 = working_step(@14, @3, @4, @5, @2) */
  arg1[0]=w14;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @16 = working_step(@15, @3, @4, @5, @2) */
  arg1[0]=w15;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @17 = working_step(@16, @3, @4, @5, @2) */
  arg1[0]=w16;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
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
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @18 = working_step(@17, @3, @4, @5, @2) */
  arg1[0]=w17;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w18;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @18 */
  casadi_copy(w18, 5, res[0]);
  /* #60: output[1][0] = @0 */
  casadi_copy(w00, 5, res[1]);
  /* #61: output[1][1] = @6 */
  if (res[1]) casadi_copy(w06, 5, res[1]+5);
  /* #62: output[1][2] = @8 */
  if (res[1]) casadi_copy(w08, 5, res[1]+10);
  /* #63: output[1][3] = @9 */
  if (res[1]) casadi_copy(w09, 5, res[1]+15);
  /* #64: output[1][4] = @10 */
  if (res[1]) casadi_copy(w10, 5, res[1]+20);
  /* #65: output[1][5] = @11 */
  if (res[1]) casadi_copy(w11, 5, res[1]+25);
  /* #66: output[1][6] = @12 */
  if (res[1]) casadi_copy(w12, 5, res[1]+30);
  /* #67: output[1][7] = @13 */
  if (res[1]) casadi_copy(w13, 5, res[1]+35);
  /* #68: output[1][8] = @14 */
  if (res[1]) casadi_copy(w14, 5, res[1]+40);
  /* #69: output[1][9] = @15 */
  if (res[1]) casadi_copy(w15, 5, res[1]+45);
  /* #70: output[1][10] = @16 */
  if (res[1]) casadi_copy(w16, 5, res[1]+50);
  /* #71: output[1][11] = @17 */
  if (res[1]) casadi_copy(w17, 5, res[1]+55);
  /* #72: @19 = @0[:4] */
  for (rr=w19, cs=w00+0; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #73: {@20, @21} = observe(@1, @19, @2) */
  arg1[0]=(&w01);
  arg1[1]=w19;
  arg1[2]=w02;
  res1[0]=w20;
  res1[1]=w21;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[2][0] = @20 */
  casadi_copy(w20, 10, res[2]);
  /* #75: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #76: @19 = @6[:4] */
  for (rr=w19, cs=w06+0; cs!=w06+4; cs+=1) *rr++ = *cs;
  /* #77: {@20, @22} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
  res1[0]=w20;
  res1[1]=w22;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[2][1] = @20 */
  if (res[2]) casadi_copy(w20, 10, res[2]+10);
  /* #79: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #80: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #81: @19 = @8[:4] */
  for (rr=w19, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #82: {@20, @23} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #87: @19 = @9[:4] */
  for (rr=w19, cs=w09+0; cs!=w09+4; cs+=1) *rr++ = *cs;
  /* #88: {@20, @24} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #93: @19 = @10[:4] */
  for (rr=w19, cs=w10+0; cs!=w10+4; cs+=1) *rr++ = *cs;
  /* #94: {@20, @25} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #99: @19 = @11[:4] */
  for (rr=w19, cs=w11+0; cs!=w11+4; cs+=1) *rr++ = *cs;
  /* #100: {@20, @26} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #105: @19 = @12[:4] */
  for (rr=w19, cs=w12+0; cs!=w12+4; cs+=1) *rr++ = *cs;
  /* #106: {@20, @27} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #111: @19 = @13[:4] */
  for (rr=w19, cs=w13+0; cs!=w13+4; cs+=1) *rr++ = *cs;
  /* #112: {@20, @28} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #117: @19 = @14[:4] */
  for (rr=w19, cs=w14+0; cs!=w14+4; cs+=1) *rr++ = *cs;
  /* #118: {@20, @29} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #123: @19 = @15[:4] */
  for (rr=w19, cs=w15+0; cs!=w15+4; cs+=1) *rr++ = *cs;
  /* #124: {@20, @30} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #129: @19 = @16[:4] */
  for (rr=w19, cs=w16+0; cs!=w16+4; cs+=1) *rr++ = *cs;
  /* #130: {@20, @31} = observe(@7, @19, @2) */
  arg1[0]=(&w07);
  arg1[1]=w19;
  arg1[2]=w02;
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
  /* #135: @19 = @17[:4] */
  for (rr=w19, cs=w17+0; cs!=w17+4; cs+=1) *rr++ = *cs;
  /* #136: {@20, @32} = observe(@1, @19, @2) */
  arg1[0]=(&w01);
  arg1[1]=w19;
  arg1[2]=w02;
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

/* compass_trace_48:(u[4],p[6])->(w[5x49],g[10x49],dg[10x49],R[4]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1392, *w21=w+1402;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 48 */
  w03 = 48.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+240);
  /* #26: output[1][0] = @11 */
  casadi_copy(w11, 120, res[1]);
  /* #27: output[1][1] = @13 */
  if (res[1]) casadi_copy(w13, 120, res[1]+120);
  /* #28: output[1][2] = @15 */
  if (res[1]) casadi_copy(w15, 120, res[1]+240);
  /* #29: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 120, res[1]+360);
  /* #30: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #31: {@19, @20} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #38: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #39: @21 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w21;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[3][0] = @21 */
  casadi_copy(w21, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s7;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1406;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1406*sizeof(casadi_real);
  return 0;
}

/* compass_trace_72:(u[4],p[6])->(w[5x73],g[10x73],dg[10x73],R[4]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1502, *w21=w+1622;
  casadi_real *w22=w+1742, *w23=w+1862, *w24=w+1872, *w25=w+1882;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 72 */
  w03 = 72.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+240);
  /* #29: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+300);
  /* #33: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+360);
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
  /* #40: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #41: {@23, @24} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #50: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #51: @25 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w25;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[3][0] = @25 */
  casadi_copy(w25, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f90(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_72_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1886;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1886*sizeof(casadi_real);
  return 0;
}

/* compass_trace_96:(u[4],p[6])->(w[5x97],g[10x97],dg[10x97],R[4]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1502, *w21=w+1622;
  casadi_real *w22=w+1742, *w23=w+1862, *w24=w+1982, *w25=w+2102, *w26=w+2222, *w27=w+2342, *w28=w+2352, *w29=w+2362;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 96 */
  w03 = 96.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+240);
  /* #29: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+300);
  /* #33: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+360);
  /* #37: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+420);
  /* #41: output[0][8] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+480);
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
  /* #50: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #51: {@27, @28} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #62: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #63: @29 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w29;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[3][0] = @29 */
  casadi_copy(w29, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2366;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2366*sizeof(casadi_real);
  return 0;
}

/* compass_trace_144:(u[4],p[6])->(w[5x145],g[10x145],dg[10x145],R[4]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1502, *w21=w+1622;
  casadi_real *w22=w+1742, *w23=w+1862, *w24=w+1982, *w25=w+2102, *w26=w+2222, *w27=w+2342, *w28=w+2462, *w29=w+2582, *w30=w+2702, *w31=w+2822, *w32=w+2942, *w33=w+3062;
  casadi_real *w34=w+3182, *w35=w+3302, *w36=w+3312, *w37=w+3322;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 144 */
  w03 = 144.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+240);
  /* #29: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+300);
  /* #33: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+360);
  /* #37: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+420);
  /* #41: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+480);
  /* #45: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+540);
  /* #49: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+600);
  /* #53: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+660);
  /* #57: output[0][12] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+720);
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
  /* #70: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #71: {@35, @36} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #86: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #87: @37 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w37;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[3][0] = @37 */
  casadi_copy(w37, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_144_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3326;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3326*sizeof(casadi_real);
  return 0;
}

/* compass_trace_192:(u[4],p[6])->(w[5x193],g[10x193],dg[10x193],R[4]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1502, *w21=w+1622;
  casadi_real *w22=w+1742, *w23=w+1862, *w24=w+1982, *w25=w+2102, *w26=w+2222, *w27=w+2342, *w28=w+2462, *w29=w+2582, *w30=w+2702, *w31=w+2822, *w32=w+2942, *w33=w+3062;
  casadi_real *w34=w+3182, *w35=w+3302, *w36=w+3422, *w37=w+3542, *w38=w+3662, *w39=w+3782, *w40=w+3902, *w41=w+4022, *w42=w+4142, *w43=w+4262, *w44=w+4272, *w45=w+4282;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 192 */
  w03 = 192.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+240);
  /* #29: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+300);
  /* #33: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+360);
  /* #37: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+420);
  /* #41: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+480);
  /* #45: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+540);
  /* #49: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+600);
  /* #53: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+660);
  /* #57: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w00 *= w02;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+720);
  /* #61: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #62: @0 = (@0*@2) */
  w00 *= w02;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+780);
  /* #65: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #66: @0 = (@0*@2) */
  w00 *= w02;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+840);
  /* #69: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w00 *= w02;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+900);
  /* #73: output[0][16] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+960);
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
  /* #90: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #91: {@43, @44} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #110: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #111: @45 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w45;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[3][0] = @45 */
  casadi_copy(w45, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 4286;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4286*sizeof(casadi_real);
  return 0;
}

/* compass_trace_288:(u[4],p[6])->(w[5x289],g[10x289],dg[10x289],R[4]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1502, *w21=w+1622;
  casadi_real *w22=w+1742, *w23=w+1862, *w24=w+1982, *w25=w+2102, *w26=w+2222, *w27=w+2342, *w28=w+2462, *w29=w+2582, *w30=w+2702, *w31=w+2822, *w32=w+2942, *w33=w+3062;
  casadi_real *w34=w+3182, *w35=w+3302, *w36=w+3422, *w37=w+3542, *w38=w+3662, *w39=w+3782, *w40=w+3902, *w41=w+4022, *w42=w+4142, *w43=w+4262, *w44=w+4382, *w45=w+4502;
  casadi_real *w46=w+4622, *w47=w+4742, *w48=w+4862, *w49=w+4982, *w50=w+5102, *w51=w+5222, *w52=w+5342, *w53=w+5462, *w54=w+5582, *w55=w+5702, *w56=w+5822, *w57=w+5942;
  casadi_real *w58=w+6062, *w59=w+6182, *w60=w+6192, *w61=w+6202;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 288 */
  w03 = 288.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.0416667 */
  w00 = 4.1666666666666664e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+240);
  /* #29: @0 = 0.208333 */
  w00 = 2.0833333333333334e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+300);
  /* #33: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+360);
  /* #37: @0 = 0.291667 */
  w00 = 2.9166666666666669e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+420);
  /* #41: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+480);
  /* #45: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+540);
  /* #49: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+600);
  /* #53: @0 = 0.458333 */
  w00 = 4.5833333333333331e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+660);
  /* #57: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w00 *= w02;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+720);
  /* #61: @0 = 0.541667 */
  w00 = 5.4166666666666663e-01;
  /* #62: @0 = (@0*@2) */
  w00 *= w02;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+780);
  /* #65: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #66: @0 = (@0*@2) */
  w00 *= w02;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+840);
  /* #69: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w00 *= w02;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+900);
  /* #73: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #74: @0 = (@0*@2) */
  w00 *= w02;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w43;
  res1[3]=w44;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+960);
  /* #77: @0 = 0.708333 */
  w00 = 7.0833333333333337e-01;
  /* #78: @0 = (@0*@2) */
  w00 *= w02;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w45;
  res1[3]=w46;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1020);
  /* #81: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w00 *= w02;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w47;
  res1[3]=w48;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1080);
  /* #85: @0 = 0.791667 */
  w00 = 7.9166666666666663e-01;
  /* #86: @0 = (@0*@2) */
  w00 *= w02;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w49;
  res1[3]=w50;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1140);
  /* #89: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #90: @0 = (@0*@2) */
  w00 *= w02;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w51;
  res1[3]=w52;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1200);
  /* #93: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #94: @0 = (@0*@2) */
  w00 *= w02;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w53;
  res1[3]=w54;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1260);
  /* #97: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #98: @0 = (@0*@2) */
  w00 *= w02;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w55;
  res1[3]=w56;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1320);
  /* #101: @0 = 0.958333 */
  w00 = 9.5833333333333337e-01;
  /* #102: @0 = (@0*@2) */
  w00 *= w02;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w57;
  res1[3]=w58;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1380);
  /* #105: output[0][24] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+1440);
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
  /* #130: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #131: {@59, @60} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #158: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #159: @61 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w61;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #160: output[3][0] = @61 */
  casadi_copy(w61, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_288_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s18;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6206;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6206*sizeof(casadi_real);
  return 0;
}

/* compass_trace_384:(u[4],p[6])->(w[5x385],g[10x385],dg[10x385],R[4]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+315, w02, w03, *w04=w+319, *w05=w+325, *w06=w+349, w07, *w08=w+352, *w09=w+357;
  casadi_real *w10=w+362, *w11=w+422, *w12=w+542, *w13=w+662, *w14=w+782, *w15=w+902, *w16=w+1022, *w17=w+1142, *w18=w+1262, *w19=w+1382, *w20=w+1502, *w21=w+1622;
  casadi_real *w22=w+1742, *w23=w+1862, *w24=w+1982, *w25=w+2102, *w26=w+2222, *w27=w+2342, *w28=w+2462, *w29=w+2582, *w30=w+2702, *w31=w+2822, *w32=w+2942, *w33=w+3062;
  casadi_real *w34=w+3182, *w35=w+3302, *w36=w+3422, *w37=w+3542, *w38=w+3662, *w39=w+3782, *w40=w+3902, *w41=w+4022, *w42=w+4142, *w43=w+4262, *w44=w+4382, *w45=w+4502;
  casadi_real *w46=w+4622, *w47=w+4742, *w48=w+4862, *w49=w+4982, *w50=w+5102, *w51=w+5222, *w52=w+5342, *w53=w+5462, *w54=w+5582, *w55=w+5702, *w56=w+5822, *w57=w+5942;
  casadi_real *w58=w+6062, *w59=w+6182, *w60=w+6302, *w61=w+6422, *w62=w+6542, *w63=w+6662, *w64=w+6782, *w65=w+6902, *w66=w+7022, *w67=w+7142, *w68=w+7262, *w69=w+7382;
  casadi_real *w70=w+7502, *w71=w+7622, *w72=w+7742, *w73=w+7862, *w74=w+7982, *w75=w+8102, *w76=w+8112, *w77=w+8122;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[3] */
  for (rr=(&w02), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 384 */
  w03 = 384.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w07 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w08;
  for (i=0, cs=w01; i<4; ++i) *rr++ = *cs++;
  *rr++ = w07;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 60, res[0]);
  /* #13: @0 = 0.03125 */
  w00 = 3.1250000000000000e-02;
  /* #14: @0 = (@0*@2) */
  w00 *= w02;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+60);
  /* #17: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #18: @0 = (@0*@2) */
  w00 *= w02;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+120);
  /* #21: @0 = 0.09375 */
  w00 = 9.3750000000000000e-02;
  /* #22: @0 = (@0*@2) */
  w00 *= w02;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+180);
  /* #25: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #26: @0 = (@0*@2) */
  w00 *= w02;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+240);
  /* #29: @0 = 0.15625 */
  w00 = 1.5625000000000000e-01;
  /* #30: @0 = (@0*@2) */
  w00 *= w02;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+300);
  /* #33: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w00 *= w02;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+360);
  /* #37: @0 = 0.21875 */
  w00 = 2.1875000000000000e-01;
  /* #38: @0 = (@0*@2) */
  w00 *= w02;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+420);
  /* #41: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #42: @0 = (@0*@2) */
  w00 *= w02;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+480);
  /* #45: @0 = 0.28125 */
  w00 = 2.8125000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w00 *= w02;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+540);
  /* #49: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #50: @0 = (@0*@2) */
  w00 *= w02;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+600);
  /* #53: @0 = 0.34375 */
  w00 = 3.4375000000000000e-01;
  /* #54: @0 = (@0*@2) */
  w00 *= w02;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+660);
  /* #57: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w00 *= w02;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+720);
  /* #61: @0 = 0.40625 */
  w00 = 4.0625000000000000e-01;
  /* #62: @0 = (@0*@2) */
  w00 *= w02;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+780);
  /* #65: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #66: @0 = (@0*@2) */
  w00 *= w02;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+840);
  /* #69: @0 = 0.46875 */
  w00 = 4.6875000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w00 *= w02;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+900);
  /* #73: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #74: @0 = (@0*@2) */
  w00 *= w02;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w43;
  res1[3]=w44;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+960);
  /* #77: @0 = 0.53125 */
  w00 = 5.3125000000000000e-01;
  /* #78: @0 = (@0*@2) */
  w00 *= w02;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w45;
  res1[3]=w46;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1020);
  /* #81: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w00 *= w02;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w47;
  res1[3]=w48;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1080);
  /* #85: @0 = 0.59375 */
  w00 = 5.9375000000000000e-01;
  /* #86: @0 = (@0*@2) */
  w00 *= w02;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w49;
  res1[3]=w50;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1140);
  /* #89: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #90: @0 = (@0*@2) */
  w00 *= w02;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w51;
  res1[3]=w52;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1200);
  /* #93: @0 = 0.65625 */
  w00 = 6.5625000000000000e-01;
  /* #94: @0 = (@0*@2) */
  w00 *= w02;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w53;
  res1[3]=w54;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1260);
  /* #97: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #98: @0 = (@0*@2) */
  w00 *= w02;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w55;
  res1[3]=w56;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1320);
  /* #101: @0 = 0.71875 */
  w00 = 7.1875000000000000e-01;
  /* #102: @0 = (@0*@2) */
  w00 *= w02;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w57;
  res1[3]=w58;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1380);
  /* #105: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #106: @0 = (@0*@2) */
  w00 *= w02;
  /* #107: {@9, @10, @59, @60} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w59;
  res1[3]=w60;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[0][24] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1440);
  /* #109: @0 = 0.78125 */
  w00 = 7.8125000000000000e-01;
  /* #110: @0 = (@0*@2) */
  w00 *= w02;
  /* #111: {@8, @10, @61, @62} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w61;
  res1[3]=w62;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[0][25] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1500);
  /* #113: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #114: @0 = (@0*@2) */
  w00 *= w02;
  /* #115: {@9, @10, @63, @64} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w63;
  res1[3]=w64;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #116: output[0][26] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1560);
  /* #117: @0 = 0.84375 */
  w00 = 8.4375000000000000e-01;
  /* #118: @0 = (@0*@2) */
  w00 *= w02;
  /* #119: {@8, @10, @65, @66} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w65;
  res1[3]=w66;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[0][27] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1620);
  /* #121: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #122: @0 = (@0*@2) */
  w00 *= w02;
  /* #123: {@9, @10, @67, @68} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w67;
  res1[3]=w68;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[0][28] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1680);
  /* #125: @0 = 0.90625 */
  w00 = 9.0625000000000000e-01;
  /* #126: @0 = (@0*@2) */
  w00 *= w02;
  /* #127: {@8, @10, @69, @70} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w69;
  res1[3]=w70;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #128: output[0][29] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1740);
  /* #129: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #130: @0 = (@0*@2) */
  w00 *= w02;
  /* #131: {@9, @10, @71, @72} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w09;
  res1[1]=w10;
  res1[2]=w71;
  res1[3]=w72;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[0][30] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1800);
  /* #133: @0 = 0.96875 */
  w00 = 9.6875000000000000e-01;
  /* #134: @0 = (@0*@2) */
  w00 *= w02;
  /* #135: {@8, @10, @73, @74} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w09;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w10;
  res1[2]=w73;
  res1[3]=w74;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #136: output[0][31] = @10 */
  if (res[0]) casadi_copy(w10, 60, res[0]+1860);
  /* #137: output[0][32] = @8 */
  if (res[0]) casadi_copy(w08, 5, res[0]+1920);
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
  /* #170: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #171: {@75, @76} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
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
  /* #206: @1 = @8[:4] */
  for (rr=w01, cs=w08+0; cs!=w08+4; cs+=1) *rr++ = *cs;
  /* #207: @77 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w77;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #208: output[3][0] = @77 */
  casadi_copy(w77, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s19;
    case 1: return casadi_s20;
    case 2: return casadi_s20;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 8126;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8126*sizeof(casadi_real);
  return 0;
}

/* compass_trace_576:(u[4],p[6])->(w[5x577],g[10x577],dg[10x577],R[4]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+315, w002, w003, *w004=w+319, *w005=w+325, *w006=w+349, w007, *w008=w+352, *w009=w+357;
  casadi_real *w010=w+362, *w011=w+422, *w012=w+542, *w013=w+662, *w014=w+782, *w015=w+902, *w016=w+1022, *w017=w+1142, *w018=w+1262, *w019=w+1382, *w020=w+1502, *w021=w+1622;
  casadi_real *w022=w+1742, *w023=w+1862, *w024=w+1982, *w025=w+2102, *w026=w+2222, *w027=w+2342, *w028=w+2462, *w029=w+2582, *w030=w+2702, *w031=w+2822, *w032=w+2942, *w033=w+3062;
  casadi_real *w034=w+3182, *w035=w+3302, *w036=w+3422, *w037=w+3542, *w038=w+3662, *w039=w+3782, *w040=w+3902, *w041=w+4022, *w042=w+4142, *w043=w+4262, *w044=w+4382, *w045=w+4502;
  casadi_real *w046=w+4622, *w047=w+4742, *w048=w+4862, *w049=w+4982, *w050=w+5102, *w051=w+5222, *w052=w+5342, *w053=w+5462, *w054=w+5582, *w055=w+5702, *w056=w+5822, *w057=w+5942;
  casadi_real *w058=w+6062, *w059=w+6182, *w060=w+6302, *w061=w+6422, *w062=w+6542, *w063=w+6662, *w064=w+6782, *w065=w+6902, *w066=w+7022, *w067=w+7142, *w068=w+7262, *w069=w+7382;
  casadi_real *w070=w+7502, *w071=w+7622, *w072=w+7742, *w073=w+7862, *w074=w+7982, *w075=w+8102, *w076=w+8222, *w077=w+8342, *w078=w+8462, *w079=w+8582, *w080=w+8702, *w081=w+8822;
  casadi_real *w082=w+8942, *w083=w+9062, *w084=w+9182, *w085=w+9302, *w086=w+9422, *w087=w+9542, *w088=w+9662, *w089=w+9782, *w090=w+9902, *w091=w+10022, *w092=w+10142, *w093=w+10262;
  casadi_real *w094=w+10382, *w095=w+10502, *w096=w+10622, *w097=w+10742, *w098=w+10862, *w099=w+10982, *w100=w+11102, *w101=w+11222, *w102=w+11342, *w103=w+11462, *w104=w+11582, *w105=w+11702;
  casadi_real *w106=w+11822, *w107=w+11942, *w108=w+11952, *w109=w+11962;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w001);
  /* #2: @2 = @1[3] */
  for (rr=(&w002), cs=w001+3; cs!=w001+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 576 */
  w003 = 576.;
  /* #4: @3 = (@2/@3) */
  w003  = (w002/w003);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w004);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=w004;
  res1[0]=w005;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w006, cs=w001+0; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=w004;
  res1[0]=w001;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w007 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w008;
  for (i=0, cs=w001; i<4; ++i) *rr++ = *cs++;
  *rr++ = w007;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w011;
  res1[3]=w012;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w010, 60, res[0]);
  /* #13: @0 = 0.0208333 */
  w000 = 2.0833333333333332e-02;
  /* #14: @0 = (@0*@2) */
  w000 *= w002;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w013;
  res1[3]=w014;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+60);
  /* #17: @0 = 0.0416667 */
  w000 = 4.1666666666666664e-02;
  /* #18: @0 = (@0*@2) */
  w000 *= w002;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w015;
  res1[3]=w016;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+120);
  /* #21: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #22: @0 = (@0*@2) */
  w000 *= w002;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w017;
  res1[3]=w018;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+180);
  /* #25: @0 = 0.0833333 */
  w000 = 8.3333333333333329e-02;
  /* #26: @0 = (@0*@2) */
  w000 *= w002;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w019;
  res1[3]=w020;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+240);
  /* #29: @0 = 0.104167 */
  w000 = 1.0416666666666667e-01;
  /* #30: @0 = (@0*@2) */
  w000 *= w002;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w021;
  res1[3]=w022;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+300);
  /* #33: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #34: @0 = (@0*@2) */
  w000 *= w002;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w023;
  res1[3]=w024;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+360);
  /* #37: @0 = 0.145833 */
  w000 = 1.4583333333333334e-01;
  /* #38: @0 = (@0*@2) */
  w000 *= w002;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w025;
  res1[3]=w026;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+420);
  /* #41: @0 = 0.166667 */
  w000 = 1.6666666666666666e-01;
  /* #42: @0 = (@0*@2) */
  w000 *= w002;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w027;
  res1[3]=w028;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+480);
  /* #45: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #46: @0 = (@0*@2) */
  w000 *= w002;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w029;
  res1[3]=w030;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+540);
  /* #49: @0 = 0.208333 */
  w000 = 2.0833333333333334e-01;
  /* #50: @0 = (@0*@2) */
  w000 *= w002;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w031;
  res1[3]=w032;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+600);
  /* #53: @0 = 0.229167 */
  w000 = 2.2916666666666666e-01;
  /* #54: @0 = (@0*@2) */
  w000 *= w002;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w033;
  res1[3]=w034;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+660);
  /* #57: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w000 *= w002;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w035;
  res1[3]=w036;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+720);
  /* #61: @0 = 0.270833 */
  w000 = 2.7083333333333331e-01;
  /* #62: @0 = (@0*@2) */
  w000 *= w002;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w037;
  res1[3]=w038;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+780);
  /* #65: @0 = 0.291667 */
  w000 = 2.9166666666666669e-01;
  /* #66: @0 = (@0*@2) */
  w000 *= w002;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w039;
  res1[3]=w040;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+840);
  /* #69: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #70: @0 = (@0*@2) */
  w000 *= w002;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w041;
  res1[3]=w042;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+900);
  /* #73: @0 = 0.333333 */
  w000 = 3.3333333333333331e-01;
  /* #74: @0 = (@0*@2) */
  w000 *= w002;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w043;
  res1[3]=w044;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+960);
  /* #77: @0 = 0.354167 */
  w000 = 3.5416666666666669e-01;
  /* #78: @0 = (@0*@2) */
  w000 *= w002;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w045;
  res1[3]=w046;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1020);
  /* #81: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w000 *= w002;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w047;
  res1[3]=w048;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1080);
  /* #85: @0 = 0.395833 */
  w000 = 3.9583333333333331e-01;
  /* #86: @0 = (@0*@2) */
  w000 *= w002;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w049;
  res1[3]=w050;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1140);
  /* #89: @0 = 0.416667 */
  w000 = 4.1666666666666669e-01;
  /* #90: @0 = (@0*@2) */
  w000 *= w002;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w051;
  res1[3]=w052;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1200);
  /* #93: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #94: @0 = (@0*@2) */
  w000 *= w002;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w053;
  res1[3]=w054;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1260);
  /* #97: @0 = 0.458333 */
  w000 = 4.5833333333333331e-01;
  /* #98: @0 = (@0*@2) */
  w000 *= w002;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w055;
  res1[3]=w056;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1320);
  /* #101: @0 = 0.479167 */
  w000 = 4.7916666666666669e-01;
  /* #102: @0 = (@0*@2) */
  w000 *= w002;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w057;
  res1[3]=w058;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1380);
  /* #105: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #106: @0 = (@0*@2) */
  w000 *= w002;
  /* #107: {@9, @10, @59, @60} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w059;
  res1[3]=w060;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[0][24] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1440);
  /* #109: @0 = 0.520833 */
  w000 = 5.2083333333333337e-01;
  /* #110: @0 = (@0*@2) */
  w000 *= w002;
  /* #111: {@8, @10, @61, @62} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w061;
  res1[3]=w062;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[0][25] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1500);
  /* #113: @0 = 0.541667 */
  w000 = 5.4166666666666663e-01;
  /* #114: @0 = (@0*@2) */
  w000 *= w002;
  /* #115: {@9, @10, @63, @64} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w063;
  res1[3]=w064;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #116: output[0][26] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1560);
  /* #117: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #118: @0 = (@0*@2) */
  w000 *= w002;
  /* #119: {@8, @10, @65, @66} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w065;
  res1[3]=w066;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[0][27] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1620);
  /* #121: @0 = 0.583333 */
  w000 = 5.8333333333333337e-01;
  /* #122: @0 = (@0*@2) */
  w000 *= w002;
  /* #123: {@9, @10, @67, @68} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w067;
  res1[3]=w068;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[0][28] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1680);
  /* #125: @0 = 0.604167 */
  w000 = 6.0416666666666663e-01;
  /* #126: @0 = (@0*@2) */
  w000 *= w002;
  /* #127: {@8, @10, @69, @70} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w069;
  res1[3]=w070;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #128: output[0][29] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1740);
  /* #129: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #130: @0 = (@0*@2) */
  w000 *= w002;
  /* #131: {@9, @10, @71, @72} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w071;
  res1[3]=w072;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[0][30] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1800);
  /* #133: @0 = 0.645833 */
  w000 = 6.4583333333333337e-01;
  /* #134: @0 = (@0*@2) */
  w000 *= w002;
  /* #135: {@8, @10, @73, @74} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w073;
  res1[3]=w074;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #136: output[0][31] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1860);
  /* #137: @0 = 0.666667 */
  w000 = 6.6666666666666663e-01;
  /* #138: @0 = (@0*@2) */
  w000 *= w002;
  /* #139: {@9, @10, @75, @76} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w075;
  res1[3]=w076;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #140: output[0][32] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1920);
  /* #141: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #142: @0 = (@0*@2) */
  w000 *= w002;
  /* #143: {@8, @10, @77, @78} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w077;
  res1[3]=w078;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #144: output[0][33] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1980);
  /* #145: @0 = 0.708333 */
  w000 = 7.0833333333333337e-01;
  /* #146: @0 = (@0*@2) */
  w000 *= w002;
  /* #147: {@9, @10, @79, @80} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w079;
  res1[3]=w080;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #148: output[0][34] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2040);
  /* #149: @0 = 0.729167 */
  w000 = 7.2916666666666663e-01;
  /* #150: @0 = (@0*@2) */
  w000 *= w002;
  /* #151: {@8, @10, @81, @82} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w081;
  res1[3]=w082;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #152: output[0][35] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2100);
  /* #153: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #154: @0 = (@0*@2) */
  w000 *= w002;
  /* #155: {@9, @10, @83, @84} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w083;
  res1[3]=w084;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[0][36] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2160);
  /* #157: @0 = 0.770833 */
  w000 = 7.7083333333333337e-01;
  /* #158: @0 = (@0*@2) */
  w000 *= w002;
  /* #159: {@8, @10, @85, @86} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w085;
  res1[3]=w086;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #160: output[0][37] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2220);
  /* #161: @0 = 0.791667 */
  w000 = 7.9166666666666663e-01;
  /* #162: @0 = (@0*@2) */
  w000 *= w002;
  /* #163: {@9, @10, @87, @88} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w087;
  res1[3]=w088;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #164: output[0][38] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2280);
  /* #165: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #166: @0 = (@0*@2) */
  w000 *= w002;
  /* #167: {@8, @10, @89, @90} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w089;
  res1[3]=w090;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #168: output[0][39] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2340);
  /* #169: @0 = 0.833333 */
  w000 = 8.3333333333333337e-01;
  /* #170: @0 = (@0*@2) */
  w000 *= w002;
  /* #171: {@9, @10, @91, @92} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w091;
  res1[3]=w092;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #172: output[0][40] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2400);
  /* #173: @0 = 0.854167 */
  w000 = 8.5416666666666663e-01;
  /* #174: @0 = (@0*@2) */
  w000 *= w002;
  /* #175: {@8, @10, @93, @94} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w093;
  res1[3]=w094;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #176: output[0][41] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2460);
  /* #177: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #178: @0 = (@0*@2) */
  w000 *= w002;
  /* #179: {@9, @10, @95, @96} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w095;
  res1[3]=w096;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #180: output[0][42] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2520);
  /* #181: @0 = 0.895833 */
  w000 = 8.9583333333333337e-01;
  /* #182: @0 = (@0*@2) */
  w000 *= w002;
  /* #183: {@8, @10, @97, @98} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w097;
  res1[3]=w098;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #184: output[0][43] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2580);
  /* #185: @0 = 0.916667 */
  w000 = 9.1666666666666663e-01;
  /* #186: @0 = (@0*@2) */
  w000 *= w002;
  /* #187: {@9, @10, @99, @100} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w099;
  res1[3]=w100;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #188: output[0][44] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2640);
  /* #189: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #190: @0 = (@0*@2) */
  w000 *= w002;
  /* #191: {@8, @10, @101, @102} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w101;
  res1[3]=w102;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #192: output[0][45] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2700);
  /* #193: @0 = 0.958333 */
  w000 = 9.5833333333333337e-01;
  /* #194: @0 = (@0*@2) */
  w000 *= w002;
  /* #195: {@9, @10, @103, @104} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w103;
  res1[3]=w104;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #196: output[0][46] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2760);
  /* #197: @0 = 0.979167 */
  w000 = 9.7916666666666663e-01;
  /* #198: @0 = (@0*@2) */
  w000 *= w002;
  /* #199: {@8, @10, @105, @106} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w105;
  res1[3]=w106;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #200: output[0][47] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2820);
  /* #201: output[0][48] = @8 */
  if (res[0]) casadi_copy(w008, 5, res[0]+2880);
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
  /* #250: @1 = @8[:4] */
  for (rr=w001, cs=w008+0; cs!=w008+4; cs+=1) *rr++ = *cs;
  /* #251: {@107, @108} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=w004;
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
  /* #302: @1 = @8[:4] */
  for (rr=w001, cs=w008+0; cs!=w008+4; cs+=1) *rr++ = *cs;
  /* #303: @109 = landing(@1, @6, @4) */
  arg1[0]=w001;
  arg1[1]=w006;
  arg1[2]=w004;
  res1[0]=w109;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #304: output[3][0] = @109 */
  casadi_copy(w109, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_576_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_576_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_576_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_576_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_576_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_576_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_576_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_576_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_576_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_576_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_576_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s21;
    case 1: return casadi_s22;
    case 2: return casadi_s22;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_576_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 11966;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 11966*sizeof(casadi_real);
  return 0;
}

/* compass_trace_768:(u[4],p[6])->(w[5x769],g[10x769],dg[10x769],R[4]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+315, w002, w003, *w004=w+319, *w005=w+325, *w006=w+349, w007, *w008=w+352, *w009=w+357;
  casadi_real *w010=w+362, *w011=w+422, *w012=w+542, *w013=w+662, *w014=w+782, *w015=w+902, *w016=w+1022, *w017=w+1142, *w018=w+1262, *w019=w+1382, *w020=w+1502, *w021=w+1622;
  casadi_real *w022=w+1742, *w023=w+1862, *w024=w+1982, *w025=w+2102, *w026=w+2222, *w027=w+2342, *w028=w+2462, *w029=w+2582, *w030=w+2702, *w031=w+2822, *w032=w+2942, *w033=w+3062;
  casadi_real *w034=w+3182, *w035=w+3302, *w036=w+3422, *w037=w+3542, *w038=w+3662, *w039=w+3782, *w040=w+3902, *w041=w+4022, *w042=w+4142, *w043=w+4262, *w044=w+4382, *w045=w+4502;
  casadi_real *w046=w+4622, *w047=w+4742, *w048=w+4862, *w049=w+4982, *w050=w+5102, *w051=w+5222, *w052=w+5342, *w053=w+5462, *w054=w+5582, *w055=w+5702, *w056=w+5822, *w057=w+5942;
  casadi_real *w058=w+6062, *w059=w+6182, *w060=w+6302, *w061=w+6422, *w062=w+6542, *w063=w+6662, *w064=w+6782, *w065=w+6902, *w066=w+7022, *w067=w+7142, *w068=w+7262, *w069=w+7382;
  casadi_real *w070=w+7502, *w071=w+7622, *w072=w+7742, *w073=w+7862, *w074=w+7982, *w075=w+8102, *w076=w+8222, *w077=w+8342, *w078=w+8462, *w079=w+8582, *w080=w+8702, *w081=w+8822;
  casadi_real *w082=w+8942, *w083=w+9062, *w084=w+9182, *w085=w+9302, *w086=w+9422, *w087=w+9542, *w088=w+9662, *w089=w+9782, *w090=w+9902, *w091=w+10022, *w092=w+10142, *w093=w+10262;
  casadi_real *w094=w+10382, *w095=w+10502, *w096=w+10622, *w097=w+10742, *w098=w+10862, *w099=w+10982, *w100=w+11102, *w101=w+11222, *w102=w+11342, *w103=w+11462, *w104=w+11582, *w105=w+11702;
  casadi_real *w106=w+11822, *w107=w+11942, *w108=w+12062, *w109=w+12182, *w110=w+12302, *w111=w+12422, *w112=w+12542, *w113=w+12662, *w114=w+12782, *w115=w+12902, *w116=w+13022, *w117=w+13142;
  casadi_real *w118=w+13262, *w119=w+13382, *w120=w+13502, *w121=w+13622, *w122=w+13742, *w123=w+13862, *w124=w+13982, *w125=w+14102, *w126=w+14222, *w127=w+14342, *w128=w+14462, *w129=w+14582;
  casadi_real *w130=w+14702, *w131=w+14822, *w132=w+14942, *w133=w+15062, *w134=w+15182, *w135=w+15302, *w136=w+15422, *w137=w+15542, *w138=w+15662, *w139=w+15782, *w140=w+15792, *w141=w+15802;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w001);
  /* #2: @2 = @1[3] */
  for (rr=(&w002), cs=w001+3; cs!=w001+4; cs+=1) *rr++ = *cs;
  /* #3: @3 = 768 */
  w003 = 768.;
  /* #4: @3 = (@2/@3) */
  w003  = (w002/w003);
  /* #5: @4 = input[1][0] */
  casadi_copy(arg[1], 6, w004);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=w004;
  res1[0]=w005;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w006, cs=w001+0; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=w004;
  res1[0]=w001;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: @7 = 0 */
  w007 = 0.;
  /* #10: @8 = vertcat(@1, @7) */
  rr=w008;
  for (i=0, cs=w001; i<4; ++i) *rr++ = *cs++;
  *rr++ = w007;
  /* #11: {@9, @10, @11, @12} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w011;
  res1[3]=w012;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w010, 60, res[0]);
  /* #13: @0 = 0.015625 */
  w000 = 1.5625000000000000e-02;
  /* #14: @0 = (@0*@2) */
  w000 *= w002;
  /* #15: {@8, @10, @13, @14} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w013;
  res1[3]=w014;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][1] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+60);
  /* #17: @0 = 0.03125 */
  w000 = 3.1250000000000000e-02;
  /* #18: @0 = (@0*@2) */
  w000 *= w002;
  /* #19: {@9, @10, @15, @16} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w015;
  res1[3]=w016;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][2] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+120);
  /* #21: @0 = 0.046875 */
  w000 = 4.6875000000000000e-02;
  /* #22: @0 = (@0*@2) */
  w000 *= w002;
  /* #23: {@8, @10, @17, @18} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w017;
  res1[3]=w018;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #24: output[0][3] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+180);
  /* #25: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #26: @0 = (@0*@2) */
  w000 *= w002;
  /* #27: {@9, @10, @19, @20} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w019;
  res1[3]=w020;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #28: output[0][4] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+240);
  /* #29: @0 = 0.078125 */
  w000 = 7.8125000000000000e-02;
  /* #30: @0 = (@0*@2) */
  w000 *= w002;
  /* #31: {@8, @10, @21, @22} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w021;
  res1[3]=w022;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][5] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+300);
  /* #33: @0 = 0.09375 */
  w000 = 9.3750000000000000e-02;
  /* #34: @0 = (@0*@2) */
  w000 *= w002;
  /* #35: {@9, @10, @23, @24} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w023;
  res1[3]=w024;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[0][6] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+360);
  /* #37: @0 = 0.109375 */
  w000 = 1.0937500000000000e-01;
  /* #38: @0 = (@0*@2) */
  w000 *= w002;
  /* #39: {@8, @10, @25, @26} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w025;
  res1[3]=w026;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #40: output[0][7] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+420);
  /* #41: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #42: @0 = (@0*@2) */
  w000 *= w002;
  /* #43: {@9, @10, @27, @28} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w027;
  res1[3]=w028;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][8] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+480);
  /* #45: @0 = 0.140625 */
  w000 = 1.4062500000000000e-01;
  /* #46: @0 = (@0*@2) */
  w000 *= w002;
  /* #47: {@8, @10, @29, @30} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w029;
  res1[3]=w030;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[0][9] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+540);
  /* #49: @0 = 0.15625 */
  w000 = 1.5625000000000000e-01;
  /* #50: @0 = (@0*@2) */
  w000 *= w002;
  /* #51: {@9, @10, @31, @32} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w031;
  res1[3]=w032;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #52: output[0][10] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+600);
  /* #53: @0 = 0.171875 */
  w000 = 1.7187500000000000e-01;
  /* #54: @0 = (@0*@2) */
  w000 *= w002;
  /* #55: {@8, @10, @33, @34} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w033;
  res1[3]=w034;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][11] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+660);
  /* #57: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #58: @0 = (@0*@2) */
  w000 *= w002;
  /* #59: {@9, @10, @35, @36} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w035;
  res1[3]=w036;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][12] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+720);
  /* #61: @0 = 0.203125 */
  w000 = 2.0312500000000000e-01;
  /* #62: @0 = (@0*@2) */
  w000 *= w002;
  /* #63: {@8, @10, @37, @38} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w037;
  res1[3]=w038;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #64: output[0][13] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+780);
  /* #65: @0 = 0.21875 */
  w000 = 2.1875000000000000e-01;
  /* #66: @0 = (@0*@2) */
  w000 *= w002;
  /* #67: {@9, @10, @39, @40} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w039;
  res1[3]=w040;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #68: output[0][14] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+840);
  /* #69: @0 = 0.234375 */
  w000 = 2.3437500000000000e-01;
  /* #70: @0 = (@0*@2) */
  w000 *= w002;
  /* #71: {@8, @10, @41, @42} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w041;
  res1[3]=w042;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #72: output[0][15] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+900);
  /* #73: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #74: @0 = (@0*@2) */
  w000 *= w002;
  /* #75: {@9, @10, @43, @44} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w043;
  res1[3]=w044;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[0][16] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+960);
  /* #77: @0 = 0.265625 */
  w000 = 2.6562500000000000e-01;
  /* #78: @0 = (@0*@2) */
  w000 *= w002;
  /* #79: {@8, @10, @45, @46} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w045;
  res1[3]=w046;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][17] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1020);
  /* #81: @0 = 0.28125 */
  w000 = 2.8125000000000000e-01;
  /* #82: @0 = (@0*@2) */
  w000 *= w002;
  /* #83: {@9, @10, @47, @48} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w047;
  res1[3]=w048;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[0][18] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1080);
  /* #85: @0 = 0.296875 */
  w000 = 2.9687500000000000e-01;
  /* #86: @0 = (@0*@2) */
  w000 *= w002;
  /* #87: {@8, @10, @49, @50} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w049;
  res1[3]=w050;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[0][19] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1140);
  /* #89: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #90: @0 = (@0*@2) */
  w000 *= w002;
  /* #91: {@9, @10, @51, @52} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w051;
  res1[3]=w052;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #92: output[0][20] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1200);
  /* #93: @0 = 0.328125 */
  w000 = 3.2812500000000000e-01;
  /* #94: @0 = (@0*@2) */
  w000 *= w002;
  /* #95: {@8, @10, @53, @54} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w053;
  res1[3]=w054;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #96: output[0][21] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1260);
  /* #97: @0 = 0.34375 */
  w000 = 3.4375000000000000e-01;
  /* #98: @0 = (@0*@2) */
  w000 *= w002;
  /* #99: {@9, @10, @55, @56} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w055;
  res1[3]=w056;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[0][22] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1320);
  /* #101: @0 = 0.359375 */
  w000 = 3.5937500000000000e-01;
  /* #102: @0 = (@0*@2) */
  w000 *= w002;
  /* #103: {@8, @10, @57, @58} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w057;
  res1[3]=w058;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][23] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1380);
  /* #105: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #106: @0 = (@0*@2) */
  w000 *= w002;
  /* #107: {@9, @10, @59, @60} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w059;
  res1[3]=w060;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[0][24] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1440);
  /* #109: @0 = 0.390625 */
  w000 = 3.9062500000000000e-01;
  /* #110: @0 = (@0*@2) */
  w000 *= w002;
  /* #111: {@8, @10, @61, @62} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w061;
  res1[3]=w062;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[0][25] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1500);
  /* #113: @0 = 0.40625 */
  w000 = 4.0625000000000000e-01;
  /* #114: @0 = (@0*@2) */
  w000 *= w002;
  /* #115: {@9, @10, @63, @64} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w063;
  res1[3]=w064;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #116: output[0][26] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1560);
  /* #117: @0 = 0.421875 */
  w000 = 4.2187500000000000e-01;
  /* #118: @0 = (@0*@2) */
  w000 *= w002;
  /* #119: {@8, @10, @65, @66} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w065;
  res1[3]=w066;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[0][27] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1620);
  /* #121: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #122: @0 = (@0*@2) */
  w000 *= w002;
  /* #123: {@9, @10, @67, @68} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w067;
  res1[3]=w068;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[0][28] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1680);
  /* #125: @0 = 0.453125 */
  w000 = 4.5312500000000000e-01;
  /* #126: @0 = (@0*@2) */
  w000 *= w002;
  /* #127: {@8, @10, @69, @70} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w069;
  res1[3]=w070;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #128: output[0][29] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1740);
  /* #129: @0 = 0.46875 */
  w000 = 4.6875000000000000e-01;
  /* #130: @0 = (@0*@2) */
  w000 *= w002;
  /* #131: {@9, @10, @71, @72} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w071;
  res1[3]=w072;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #132: output[0][30] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1800);
  /* #133: @0 = 0.484375 */
  w000 = 4.8437500000000000e-01;
  /* #134: @0 = (@0*@2) */
  w000 *= w002;
  /* #135: {@8, @10, @73, @74} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w073;
  res1[3]=w074;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #136: output[0][31] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1860);
  /* #137: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #138: @0 = (@0*@2) */
  w000 *= w002;
  /* #139: {@9, @10, @75, @76} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w075;
  res1[3]=w076;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #140: output[0][32] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1920);
  /* #141: @0 = 0.515625 */
  w000 = 5.1562500000000000e-01;
  /* #142: @0 = (@0*@2) */
  w000 *= w002;
  /* #143: {@8, @10, @77, @78} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w077;
  res1[3]=w078;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #144: output[0][33] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+1980);
  /* #145: @0 = 0.53125 */
  w000 = 5.3125000000000000e-01;
  /* #146: @0 = (@0*@2) */
  w000 *= w002;
  /* #147: {@9, @10, @79, @80} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w079;
  res1[3]=w080;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #148: output[0][34] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2040);
  /* #149: @0 = 0.546875 */
  w000 = 5.4687500000000000e-01;
  /* #150: @0 = (@0*@2) */
  w000 *= w002;
  /* #151: {@8, @10, @81, @82} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w081;
  res1[3]=w082;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #152: output[0][35] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2100);
  /* #153: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #154: @0 = (@0*@2) */
  w000 *= w002;
  /* #155: {@9, @10, @83, @84} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w083;
  res1[3]=w084;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[0][36] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2160);
  /* #157: @0 = 0.578125 */
  w000 = 5.7812500000000000e-01;
  /* #158: @0 = (@0*@2) */
  w000 *= w002;
  /* #159: {@8, @10, @85, @86} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w085;
  res1[3]=w086;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #160: output[0][37] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2220);
  /* #161: @0 = 0.59375 */
  w000 = 5.9375000000000000e-01;
  /* #162: @0 = (@0*@2) */
  w000 *= w002;
  /* #163: {@9, @10, @87, @88} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w087;
  res1[3]=w088;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #164: output[0][38] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2280);
  /* #165: @0 = 0.609375 */
  w000 = 6.0937500000000000e-01;
  /* #166: @0 = (@0*@2) */
  w000 *= w002;
  /* #167: {@8, @10, @89, @90} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w089;
  res1[3]=w090;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #168: output[0][39] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2340);
  /* #169: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #170: @0 = (@0*@2) */
  w000 *= w002;
  /* #171: {@9, @10, @91, @92} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w091;
  res1[3]=w092;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #172: output[0][40] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2400);
  /* #173: @0 = 0.640625 */
  w000 = 6.4062500000000000e-01;
  /* #174: @0 = (@0*@2) */
  w000 *= w002;
  /* #175: {@8, @10, @93, @94} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w093;
  res1[3]=w094;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #176: output[0][41] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2460);
  /* #177: @0 = 0.65625 */
  w000 = 6.5625000000000000e-01;
  /* #178: @0 = (@0*@2) */
  w000 *= w002;
  /* #179: {@9, @10, @95, @96} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w095;
  res1[3]=w096;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #180: output[0][42] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2520);
  /* #181: @0 = 0.671875 */
  w000 = 6.7187500000000000e-01;
  /* #182: @0 = (@0*@2) */
  w000 *= w002;
  /* #183: {@8, @10, @97, @98} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w097;
  res1[3]=w098;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #184: output[0][43] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2580);
  /* #185: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #186: @0 = (@0*@2) */
  w000 *= w002;
  /* #187: {@9, @10, @99, @100} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w099;
  res1[3]=w100;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #188: output[0][44] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2640);
  /* #189: @0 = 0.703125 */
  w000 = 7.0312500000000000e-01;
  /* #190: @0 = (@0*@2) */
  w000 *= w002;
  /* #191: {@8, @10, @101, @102} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w101;
  res1[3]=w102;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #192: output[0][45] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2700);
  /* #193: @0 = 0.71875 */
  w000 = 7.1875000000000000e-01;
  /* #194: @0 = (@0*@2) */
  w000 *= w002;
  /* #195: {@9, @10, @103, @104} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w103;
  res1[3]=w104;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #196: output[0][46] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2760);
  /* #197: @0 = 0.734375 */
  w000 = 7.3437500000000000e-01;
  /* #198: @0 = (@0*@2) */
  w000 *= w002;
  /* #199: {@8, @10, @105, @106} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w105;
  res1[3]=w106;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #200: output[0][47] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2820);
  /* #201: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #202: @0 = (@0*@2) */
  w000 *= w002;
  /* #203: {@9, @10, @107, @108} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w107;
  res1[3]=w108;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #204: output[0][48] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2880);
  /* #205: @0 = 0.765625 */
  w000 = 7.6562500000000000e-01;
  /* #206: @0 = (@0*@2) */
  w000 *= w002;
  /* #207: {@8, @10, @109, @110} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w109;
  res1[3]=w110;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #208: output[0][49] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+2940);
  /* #209: @0 = 0.78125 */
  w000 = 7.8125000000000000e-01;
  /* #210: @0 = (@0*@2) */
  w000 *= w002;
  /* #211: {@9, @10, @111, @112} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w111;
  res1[3]=w112;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #212: output[0][50] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3000);
  /* #213: @0 = 0.796875 */
  w000 = 7.9687500000000000e-01;
  /* #214: @0 = (@0*@2) */
  w000 *= w002;
  /* #215: {@8, @10, @113, @114} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w113;
  res1[3]=w114;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #216: output[0][51] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3060);
  /* #217: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #218: @0 = (@0*@2) */
  w000 *= w002;
  /* #219: {@9, @10, @115, @116} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w115;
  res1[3]=w116;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #220: output[0][52] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3120);
  /* #221: @0 = 0.828125 */
  w000 = 8.2812500000000000e-01;
  /* #222: @0 = (@0*@2) */
  w000 *= w002;
  /* #223: {@8, @10, @117, @118} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w117;
  res1[3]=w118;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #224: output[0][53] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3180);
  /* #225: @0 = 0.84375 */
  w000 = 8.4375000000000000e-01;
  /* #226: @0 = (@0*@2) */
  w000 *= w002;
  /* #227: {@9, @10, @119, @120} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w119;
  res1[3]=w120;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #228: output[0][54] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3240);
  /* #229: @0 = 0.859375 */
  w000 = 8.5937500000000000e-01;
  /* #230: @0 = (@0*@2) */
  w000 *= w002;
  /* #231: {@8, @10, @121, @122} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w121;
  res1[3]=w122;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #232: output[0][55] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3300);
  /* #233: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #234: @0 = (@0*@2) */
  w000 *= w002;
  /* #235: {@9, @10, @123, @124} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w123;
  res1[3]=w124;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #236: output[0][56] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3360);
  /* #237: @0 = 0.890625 */
  w000 = 8.9062500000000000e-01;
  /* #238: @0 = (@0*@2) */
  w000 *= w002;
  /* #239: {@8, @10, @125, @126} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w125;
  res1[3]=w126;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #240: output[0][57] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3420);
  /* #241: @0 = 0.90625 */
  w000 = 9.0625000000000000e-01;
  /* #242: @0 = (@0*@2) */
  w000 *= w002;
  /* #243: {@9, @10, @127, @128} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w127;
  res1[3]=w128;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #244: output[0][58] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3480);
  /* #245: @0 = 0.921875 */
  w000 = 9.2187500000000000e-01;
  /* #246: @0 = (@0*@2) */
  w000 *= w002;
  /* #247: {@8, @10, @129, @130} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w129;
  res1[3]=w130;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #248: output[0][59] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3540);
  /* #249: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #250: @0 = (@0*@2) */
  w000 *= w002;
  /* #251: {@9, @10, @131, @132} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w131;
  res1[3]=w132;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #252: output[0][60] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3600);
  /* #253: @0 = 0.953125 */
  w000 = 9.5312500000000000e-01;
  /* #254: @0 = (@0*@2) */
  w000 *= w002;
  /* #255: {@8, @10, @133, @134} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w133;
  res1[3]=w134;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #256: output[0][61] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3660);
  /* #257: @0 = 0.96875 */
  w000 = 9.6875000000000000e-01;
  /* #258: @0 = (@0*@2) */
  w000 *= w002;
  /* #259: {@9, @10, @135, @136} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w009;
  res1[1]=w010;
  res1[2]=w135;
  res1[3]=w136;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #260: output[0][62] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3720);
  /* #261: @0 = 0.984375 */
  w000 = 9.8437500000000000e-01;
  /* #262: @0 = (@0*@2) */
  w000 *= w002;
  /* #263: {@8, @10, @137, @138} = working_steps(@0, @5, @9, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w009;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w010;
  res1[2]=w137;
  res1[3]=w138;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #264: output[0][63] = @10 */
  if (res[0]) casadi_copy(w010, 60, res[0]+3780);
  /* #265: output[0][64] = @8 */
  if (res[0]) casadi_copy(w008, 5, res[0]+3840);
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
  /* #330: @1 = @8[:4] */
  for (rr=w001, cs=w008+0; cs!=w008+4; cs+=1) *rr++ = *cs;
  /* #331: {@139, @140} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=w004;
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
  /* #398: @1 = @8[:4] */
  for (rr=w001, cs=w008+0; cs!=w008+4; cs+=1) *rr++ = *cs;
  /* #399: @141 = landing(@1, @6, @4) */
  arg1[0]=w001;
  arg1[1]=w006;
  arg1[2]=w004;
  res1[0]=w141;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #400: output[3][0] = @141 */
  casadi_copy(w141, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s23;
    case 1: return casadi_s24;
    case 2: return casadi_s24;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 15806;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 15806*sizeof(casadi_real);
  return 0;
}

/* compass_advance:(t,w[5],h,p[6])->(w_end[5],g[10],dg[10]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w0=w+81, w1, *w2=w+86, *w3=w+92, w4, *w5=w+94, *w6=w+118, *w7=w+123, *w8=w+127, *w9=w+137;
  const casadi_real **arg1=arg+4, *cs;
  /* #0: @0 = input[1][0] */
  casadi_copy(arg[1], 5, w0);
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 6, w2);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  w4 = arg[2] ? arg[2][0] : 0;
  /* #5: @5 = turns(@4, @2) */
  arg1[0]=(&w4);
  arg1[1]=w2;
  res1[0]=w5;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #6: @6 = working_step(@0, @3, @5, @4, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=w5;
  arg1[3]=(&w4);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #7: output[0][0] = @6 */
  casadi_copy(w6, 5, res[0]);
  /* #8: @1 = (@1+@4) */
  w1 += w4;
  /* #9: @7 = @6[:4] */
  for (rr=w7, cs=w6+0; cs!=w6+4; cs+=1) *rr++ = *cs;
  /* #10: {@8, @9} = observe(@1, @7, @2) */
  arg1[0]=(&w1);
  arg1[1]=w7;
  arg1[2]=w2;
  res1[0]=w8;
  res1[1]=w9;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[1][0] = @8 */
  casadi_copy(w8, 10, res[1]);
  /* #12: output[2][0] = @9 */
  casadi_copy(w9, 10, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int compass_advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s26;
    case 2: return casadi_s25;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s26;
    case 1: return casadi_s27;
    case 2: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 147;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 147*sizeof(casadi_real);
  return 0;
}

/* compass_begin:(u[4],p[6])->(y[4x4]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+2, *w1=w+6, *w2=w+9, *w3=w+15;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w2);
  /* #3: {@0, @3} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w0;
  res1[1]=w3;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  /* #5: output[0][1] = @3 */
  if (res[0]) casadi_copy(w3, 12, res[0]+4);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_begin(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_begin_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_begin_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_begin_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_begin_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_begin_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int compass_begin_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_begin_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_begin_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_begin_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_begin_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_begin_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_begin_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 27;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_begin_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 27*sizeof(casadi_real);
  return 0;
}

/* compass_swing:(t,h,y[4x4],p[6])->(y_end[4x4]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w3=w+294, *w4=w+300, *w5=w+324;
  const casadi_real **arg1=arg+4, *wr0;
  /* #0: @0 = input[2][0] */
  wr0 = arg[2] ? arg[2] : casadi_zeros;
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[3][0] */
  casadi_copy(arg[3], 6, w3);
  /* #4: @4 = turns(@2, @3) */
  arg1[0]=(&w2);
  arg1[1]=w3;
  res1[0]=w4;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = variational_steps(@0, @1, @4, @2, @3) */
  arg1[0]=wr0;
  arg1[1]=(&w1);
  arg1[2]=w4;
  arg1[3]=(&w2);
  arg1[4]=w3;
  res1[0]=w5;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 16, res[0]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f100(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int compass_swing_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real compass_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "y";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y_end";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s6;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

/* compass_end:(y[4x4],u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w1=w+24, *w2=w+28, w3, *w4=w+31, *w5=w+37;
  const casadi_real **arg1=arg+3, *cs, *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 4, w1);
  /* #2: @2 = @1[:3] */
  for (rr=w2, cs=w1+0; cs!=w1+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = @1[3] */
  for (rr=(&w3), cs=w1+3; cs!=w1+4; cs+=1) *rr++ = *cs;
  /* #4: @4 = input[2][0] */
  casadi_copy(arg[2], 6, w4);
  /* #5: {@5, @1} = landing_with_derivative(@0, @2, @3, @4) */
  arg1[0]=wr0;
  arg1[1]=w2;
  arg1[2]=(&w3);
  arg1[3]=w4;
  res1[0]=w5;
  res1[1]=w1;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 16, res[0]);
  /* #7: output[1][0] = @1 */
  casadi_copy(w1, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_end(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f101(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_end_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_end_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_end_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_end_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_end_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_end_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real compass_end_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_end_name_in(casadi_int i) {
  switch (i) {
    case 0: return "y";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_end_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_end_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_end_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_end_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 53;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 53*sizeof(casadi_real);
  return 0;
}

/* compass_observed_swing:(t,h,w[5],p[6])->(w_end[5],nodes[5x12],g[10x12],dg[10x12]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+315, *w3=w+321, *w4=w+345, *w5=w+350, *w6=w+355, *w7=w+415, *w8=w+535;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 6, w2);
  /* #3: @3 = turns(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  casadi_copy(arg[2], 5, w4);
  /* #5: {@5, @6, @7, @8} = working_steps(@0, @3, @4, @1, @2) */
  arg1[0]=(&w0);
  arg1[1]=w3;
  arg1[2]=w4;
  arg1[3]=(&w1);
  arg1[4]=w2;
  res1[0]=w5;
  res1[1]=w6;
  res1[2]=w7;
  res1[3]=w8;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 5, res[0]);
  /* #7: output[1][0] = @6 */
  casadi_copy(w6, 60, res[1]);
  /* #8: output[2][0] = @7 */
  casadi_copy(w7, 120, res[2]);
  /* #9: output[3][0] = @8 */
  casadi_copy(w8, 120, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f102(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_observed_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_observed_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_observed_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_observed_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_observed_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int compass_observed_swing_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real compass_observed_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_observed_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "w";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_observed_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "nodes";
    case 2: return "g";
    case 3: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_observed_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s26;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_observed_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s26;
    case 1: return casadi_s28;
    case 2: return casadi_s29;
    case 3: return casadi_s29;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 655;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 655*sizeof(casadi_real);
  return 0;
}



/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*compass_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int compass_map(compass_kernel kernel, const casadi_int* work_size, casadi_int n,
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
