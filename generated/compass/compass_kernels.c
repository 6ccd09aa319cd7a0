/* Compass walker: kernels of the solver
 * Printed by CasADi 3.8.2 from equations ab0018d4a24e7091.
 * Do not edit: run `stridemap derive`.
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
#define casadi_f103 CASADI_PREFIX(f103)
#define casadi_f104 CASADI_PREFIX(f104)
#define casadi_f105 CASADI_PREFIX(f105)
#define casadi_f106 CASADI_PREFIX(f106)
#define casadi_f107 CASADI_PREFIX(f107)
#define casadi_f108 CASADI_PREFIX(f108)
#define casadi_f109 CASADI_PREFIX(f109)
#define casadi_f11 CASADI_PREFIX(f11)
#define casadi_f110 CASADI_PREFIX(f110)
#define casadi_f111 CASADI_PREFIX(f111)
#define casadi_f112 CASADI_PREFIX(f112)
#define casadi_f113 CASADI_PREFIX(f113)
#define casadi_f114 CASADI_PREFIX(f114)
#define casadi_f115 CASADI_PREFIX(f115)
#define casadi_f116 CASADI_PREFIX(f116)
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
  casadi_real a216, a217, a218, a219, a220, a221, a222, a223, a224, a225, a226, a227;
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236, a237, a238;
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
  a015=arg[4]? arg[4][3] : 0;
  a027=arg[4]? arg[4][5] : 0;
  a028=arg[4]? arg[4][0] : 0;
  a028=(a027*a028);
  a029=arg[1]? arg[1][1] : 0;
  a030=(a028*a029);
  a030=(a008+a030);
  a030=(a015*a030);
  a031=arg[4]? arg[4][2] : 0;
  a032=arg[4]? arg[4][4] : 0;
  a033=arg[1]? arg[1][0] : 0;
  a034=(a033+a018);
  a034=(a027*a034);
  a034=(a032-a034);
  a034=(a034+a010);
  a034=(a031*a034);
  a030=(a030+a034);
  a026=(a026-a030);
  a009=(a025*a009);
  a009=(a026-a009);
  a024=(a024*a025);
  a024=(a007-a024);
  a009=(a009/a024);
  a030=(a025*a009);
  a023=(a023-a030);
  a030=(a006*a023);
  a034=1.7082860872947386e-01;
  a034=(a034*a002);
  a035=2.9587585476806851e-02;
  a035=(a035*a002);
  a036=(a035*a009);
  a037=8.8762756430420545e-02;
  a037=(a037*a002);
  a038=1.9725056984537900e-02;
  a038=(a038*a002);
  a039=(a038*a023);
  a040=5.9175170953613701e-02;
  a040=(a040*a002);
  a041=5.2600151958767730e-02;
  a041=(a041*a002);
  a042=(a041*a009);
  a042=(a008+a042);
  a043=(a007*a042);
  a044=(a041*a008);
  a044=(a010+a044);
  a045=sin(a044);
  a043=(a043*a045);
  a046=(a041*a023);
  a046=(a003+a046);
  a047=(2.*a046);
  a047=(a042-a047);
  a043=(a043*a047);
  a048=(a041*a003);
  a048=(a000+a048);
  a049=sin(a048);
  a050=cos(a044);
  a051=(a049*a050);
  a048=cos(a048);
  a052=(a048*a045);
  a051=(a051-a052);
  a052=(a007*a051);
  a043=(a043-a052);
  a053=(a049*a019);
  a043=(a043+a053);
  a054=(a018-a050);
  a054=(a021*a054);
  a054=(a054+a018);
  a055=(a043/a054);
  a056=(a050-a018);
  a056=(a007*a056);
  a057=(a056/a054);
  a058=casadi_sq(a046);
  a058=(a058*a045);
  a058=(a058+a051);
  a058=(a007*a058);
  a051=arg[2]? arg[2][2] : 0;
  a059=(a029*a051);
  a060=arg[2]? arg[2][3] : 0;
  a061=(a033*a060);
  a059=(a059+a061);
  a059=(a028*a059);
  a059=(a042+a059);
  a059=(a015*a059);
  a051=(a033*a051);
  a060=(a029*a060);
  a051=(a051-a060);
  a051=(a051+a018);
  a051=(a027*a051);
  a051=(a032-a051);
  a051=(a051+a044);
  a051=(a031*a051);
  a059=(a059+a051);
  a058=(a058-a059);
  a043=(a057*a043);
  a043=(a058-a043);
  a056=(a056*a057);
  a056=(a007-a056);
  a043=(a043/a056);
  a059=(a057*a043);
  a055=(a055-a059);
  a055=(a040*a055);
  a039=(a039+a055);
  a039=(a003+a039);
  a055=casadi_sq(a039);
  a059=(a038*a008);
  a051=(a040*a042);
  a059=(a059+a051);
  a059=(a010+a059);
  a051=sin(a059);
  a055=(a055*a051);
  a044=(a038*a003);
  a060=(a040*a046);
  a044=(a044+a060);
  a044=(a000+a044);
  a060=sin(a044);
  a061=cos(a059);
  a062=(a060*a061);
  a044=cos(a044);
  a063=(a044*a051);
  a062=(a062-a063);
  a055=(a055+a062);
  a055=(a007*a055);
  a063=(a038*a009);
  a043=(a040*a043);
  a063=(a063+a043);
  a063=(a008+a063);
  a043=arg[2]? arg[2][4] : 0;
  a064=(a029*a043);
  a065=arg[2]? arg[2][5] : 0;
  a066=(a033*a065);
  a064=(a064+a066);
  a064=(a028*a064);
  a064=(a063+a064);
  a064=(a015*a064);
  a043=(a033*a043);
  a065=(a029*a065);
  a043=(a043-a065);
  a043=(a043+a018);
  a043=(a027*a043);
  a043=(a032-a043);
  a043=(a043+a059);
  a043=(a031*a043);
  a064=(a064+a043);
  a055=(a055-a064);
  a064=(a061-a018);
  a064=(a007*a064);
  a043=(a018-a061);
  a043=(a021*a043);
  a043=(a043+a018);
  a059=(a064/a043);
  a065=(a007*a063);
  a065=(a065*a051);
  a066=(2.*a039);
  a066=(a063-a066);
  a065=(a065*a066);
  a062=(a007*a062);
  a065=(a065-a062);
  a067=(a060*a019);
  a065=(a065+a067);
  a068=(a059*a065);
  a068=(a055-a068);
  a064=(a064*a059);
  a064=(a007-a064);
  a068=(a068/a064);
  a069=(a037*a068);
  a036=(a036+a069);
  a036=(a008+a036);
  a069=(a007*a036);
  a070=(a035*a008);
  a071=(a037*a063);
  a070=(a070+a071);
  a070=(a010+a070);
  a071=sin(a070);
  a069=(a069*a071);
  a072=(a035*a023);
  a065=(a065/a043);
  a073=(a059*a068);
  a065=(a065-a073);
  a073=(a037*a065);
  a072=(a072+a073);
  a072=(a003+a072);
  a073=(2.*a072);
  a073=(a036-a073);
  a069=(a069*a073);
  a074=(a035*a003);
  a075=(a037*a039);
  a074=(a074+a075);
  a074=(a000+a074);
  a075=sin(a074);
  a076=cos(a070);
  a077=(a075*a076);
  a074=cos(a074);
  a078=(a074*a071);
  a077=(a077-a078);
  a078=(a007*a077);
  a069=(a069-a078);
  a079=(a075*a019);
  a069=(a069+a079);
  a080=(a018-a076);
  a080=(a021*a080);
  a080=(a080+a018);
  a081=(a069/a080);
  a082=(a076-a018);
  a082=(a007*a082);
  a083=(a082/a080);
  a084=casadi_sq(a072);
  a084=(a084*a071);
  a084=(a084+a077);
  a084=(a007*a084);
  a077=arg[2]? arg[2][6] : 0;
  a085=(a029*a077);
  a086=arg[2]? arg[2][7] : 0;
  a087=(a033*a086);
  a085=(a085+a087);
  a085=(a028*a085);
  a085=(a036+a085);
  a085=(a015*a085);
  a077=(a033*a077);
  a086=(a029*a086);
  a077=(a077-a086);
  a077=(a077+a018);
  a077=(a027*a077);
  a077=(a032-a077);
  a077=(a077+a070);
  a077=(a031*a077);
  a085=(a085+a077);
  a084=(a084-a085);
  a069=(a083*a069);
  a069=(a084-a069);
  a082=(a082*a083);
  a082=(a007-a082);
  a069=(a069/a082);
  a085=(a083*a069);
  a081=(a081-a085);
  a085=(a034*a081);
  a030=(a030+a085);
  a085=1.2546768756682242e-01;
  a085=(a085*a002);
  a077=2.4136513415926669e-01;
  a077=(a077*a002);
  a070=(a077*a009);
  a086=-8.8454947932828609e-01;
  a086=(a086*a002);
  a068=(a086*a068);
  a070=(a070+a068);
  a068=9.2483400326179199e-01;
  a068=(a068*a002);
  a087=(a068*a069);
  a070=(a070+a087);
  a070=(a008+a070);
  a087=(a007*a070);
  a088=(a077*a008);
  a089=(a086*a063);
  a088=(a088+a089);
  a089=(a068*a036);
  a088=(a088+a089);
  a088=(a010+a088);
  a089=sin(a088);
  a087=(a087*a089);
  a090=(a077*a023);
  a065=(a086*a065);
  a090=(a090+a065);
  a065=(a068*a081);
  a090=(a090+a065);
  a090=(a003+a090);
  a065=(2.*a090);
  a065=(a070-a065);
  a087=(a087*a065);
  a091=(a077*a003);
  a092=(a086*a039);
  a091=(a091+a092);
  a092=(a068*a072);
  a091=(a091+a092);
  a091=(a000+a091);
  a092=sin(a091);
  a093=cos(a088);
  a094=(a092*a093);
  a091=cos(a091);
  a095=(a091*a089);
  a094=(a094-a095);
  a095=(a007*a094);
  a087=(a087-a095);
  a096=(a092*a019);
  a087=(a087+a096);
  a097=(a018-a093);
  a097=(a021*a097);
  a097=(a097+a018);
  a098=(a087/a097);
  a099=(a093-a018);
  a099=(a007*a099);
  a100=(a099/a097);
  a101=casadi_sq(a090);
  a101=(a101*a089);
  a101=(a101+a094);
  a101=(a007*a101);
  a094=arg[2]? arg[2][8] : 0;
  a102=(a029*a094);
  a103=arg[2]? arg[2][9] : 0;
  a104=(a033*a103);
  a102=(a102+a104);
  a102=(a028*a102);
  a102=(a070+a102);
  a102=(a015*a102);
  a094=(a033*a094);
  a103=(a029*a103);
  a094=(a094-a103);
  a094=(a094+a018);
  a094=(a027*a094);
  a094=(a032-a094);
  a094=(a094+a088);
  a094=(a031*a094);
  a102=(a102+a094);
  a101=(a101-a102);
  a087=(a100*a087);
  a087=(a101-a087);
  a099=(a099*a100);
  a099=(a007-a099);
  a087=(a087/a099);
  a102=(a100*a087);
  a098=(a098-a102);
  a102=(a085*a098);
  a030=(a030+a102);
  a030=(a003+a030);
  a102=(a005*a030);
  a004=(a004+a102);
  a102=1.8915178993145003e+00;
  a102=(a102*a002);
  a094=3.7109375000000000e-02;
  a094=(a094*a002);
  a088=(a094*a023);
  a103=1.7025221101954405e-01;
  a103=(a103*a002);
  a104=(a103*a081);
  a088=(a088+a104);
  a104=6.0216538980455959e-02;
  a104=(a104*a002);
  a105=(a104*a098);
  a088=(a088+a105);
  a105=-1.7578125000000000e-02;
  a105=(a105*a002);
  a106=(a006*a009);
  a107=(a034*a069);
  a106=(a106+a107);
  a107=(a085*a087);
  a106=(a106+a107);
  a106=(a008+a106);
  a107=(a007*a106);
  a108=(a006*a008);
  a109=(a034*a036);
  a108=(a108+a109);
  a109=(a085*a070);
  a108=(a108+a109);
  a108=(a010+a108);
  a109=sin(a108);
  a107=(a107*a109);
  a110=(2.*a030);
  a110=(a106-a110);
  a107=(a107*a110);
  a111=(a006*a003);
  a112=(a034*a072);
  a111=(a111+a112);
  a112=(a085*a090);
  a111=(a111+a112);
  a111=(a000+a111);
  a112=sin(a111);
  a113=cos(a108);
  a114=(a112*a113);
  a111=cos(a111);
  a115=(a111*a109);
  a114=(a114-a115);
  a115=(a007*a114);
  a107=(a107-a115);
  a116=(a112*a019);
  a107=(a107+a116);
  a117=(a018-a113);
  a117=(a021*a117);
  a117=(a117+a018);
  a118=(a107/a117);
  a119=(a113-a018);
  a119=(a007*a119);
  a120=(a119/a117);
  a121=casadi_sq(a030);
  a121=(a121*a109);
  a121=(a121+a114);
  a121=(a007*a121);
  a114=arg[2]? arg[2][10] : 0;
  a122=(a029*a114);
  a123=arg[2]? arg[2][11] : 0;
  a124=(a033*a123);
  a122=(a122+a124);
  a122=(a028*a122);
  a122=(a106+a122);
  a122=(a015*a122);
  a114=(a033*a114);
  a123=(a029*a123);
  a114=(a114-a123);
  a114=(a114+a018);
  a114=(a027*a114);
  a114=(a032-a114);
  a114=(a114+a108);
  a114=(a031*a114);
  a122=(a122+a114);
  a121=(a121-a122);
  a107=(a120*a107);
  a107=(a121-a107);
  a119=(a119*a120);
  a119=(a007-a119);
  a107=(a107/a119);
  a122=(a120*a107);
  a118=(a118-a122);
  a122=(a105*a118);
  a088=(a088+a122);
  a088=(a003+a088);
  a122=(a102*a088);
  a004=(a004+a122);
  a122=-5.8012039600105849e+00;
  a122=(a122*a002);
  a114=3.7092000118504789e-02;
  a114=(a114*a002);
  a108=(a114*a023);
  a123=1.7038392571223998e-01;
  a123=(a123*a002);
  a124=(a123*a081);
  a108=(a108+a124);
  a124=1.0726203044637328e-01;
  a124=(a124*a002);
  a125=(a124*a098);
  a108=(a108+a125);
  a125=-1.5319437748624402e-02;
  a125=(a125*a002);
  a126=(a125*a118);
  a108=(a108+a126);
  a126=8.2737891638140233e-03;
  a126=(a126*a002);
  a127=(a094*a009);
  a128=(a103*a069);
  a127=(a127+a128);
  a128=(a104*a087);
  a127=(a127+a128);
  a128=(a105*a107);
  a127=(a127+a128);
  a127=(a008+a127);
  a128=(a007*a127);
  a129=(a094*a008);
  a130=(a103*a036);
  a129=(a129+a130);
  a130=(a104*a070);
  a129=(a129+a130);
  a130=(a105*a106);
  a129=(a129+a130);
  a129=(a010+a129);
  a130=sin(a129);
  a128=(a128*a130);
  a131=(2.*a088);
  a131=(a127-a131);
  a128=(a128*a131);
  a132=(a094*a003);
  a133=(a103*a072);
  a132=(a132+a133);
  a133=(a104*a090);
  a132=(a132+a133);
  a133=(a105*a030);
  a132=(a132+a133);
  a132=(a000+a132);
  a133=sin(a132);
  a134=cos(a129);
  a135=(a133*a134);
  a132=cos(a132);
  a136=(a132*a130);
  a135=(a135-a136);
  a136=(a007*a135);
  a128=(a128-a136);
  a137=(a133*a019);
  a128=(a128+a137);
  a138=(a018-a134);
  a138=(a021*a138);
  a138=(a138+a018);
  a139=(a128/a138);
  a140=(a134-a018);
  a140=(a007*a140);
  a141=(a140/a138);
  a142=casadi_sq(a088);
  a142=(a142*a130);
  a142=(a142+a135);
  a142=(a007*a142);
  a135=arg[2]? arg[2][12] : 0;
  a143=(a029*a135);
  a144=arg[2]? arg[2][13] : 0;
  a145=(a033*a144);
  a143=(a143+a145);
  a143=(a028*a143);
  a143=(a127+a143);
  a143=(a015*a143);
  a135=(a033*a135);
  a144=(a029*a144);
  a135=(a135-a144);
  a135=(a135+a018);
  a135=(a027*a135);
  a135=(a032-a135);
  a135=(a135+a129);
  a135=(a031*a135);
  a143=(a143+a135);
  a142=(a142-a143);
  a128=(a141*a128);
  a128=(a142-a128);
  a140=(a140*a141);
  a140=(a007-a140);
  a128=(a128/a140);
  a143=(a141*a128);
  a139=(a139-a143);
  a143=(a126*a139);
  a108=(a108+a143);
  a108=(a003+a108);
  a143=(a122*a108);
  a004=(a004+a143);
  a143=3.1116436695781990e-01;
  a143=(a143*a002);
  a135=6.2411095871607569e-01;
  a135=(a135*a002);
  a129=(a135*a023);
  a144=-3.3608926294469414e+00;
  a144=(a144*a002);
  a145=(a144*a081);
  a129=(a129+a145);
  a145=-8.6821934684172597e-01;
  a145=(a145*a002);
  a146=(a145*a098);
  a129=(a129+a146);
  a146=2.7592099699446710e+01;
  a146=(a146*a002);
  a147=(a146*a118);
  a129=(a129+a147);
  a147=2.0154067550477894e+01;
  a147=(a147*a002);
  a148=(a147*a139);
  a129=(a129+a148);
  a148=-4.3489884181069961e+01;
  a148=(a148*a002);
  a149=(a114*a009);
  a150=(a123*a069);
  a149=(a149+a150);
  a150=(a124*a087);
  a149=(a149+a150);
  a150=(a125*a107);
  a149=(a149+a150);
  a150=(a126*a128);
  a149=(a149+a150);
  a149=(a008+a149);
  a150=(a007*a149);
  a151=(a114*a008);
  a152=(a123*a036);
  a151=(a151+a152);
  a152=(a124*a070);
  a151=(a151+a152);
  a152=(a125*a106);
  a151=(a151+a152);
  a152=(a126*a127);
  a151=(a151+a152);
  a151=(a010+a151);
  a152=sin(a151);
  a150=(a150*a152);
  a153=(2.*a108);
  a153=(a149-a153);
  a150=(a150*a153);
  a154=(a114*a003);
  a155=(a123*a072);
  a154=(a154+a155);
  a155=(a124*a090);
  a154=(a154+a155);
  a155=(a125*a030);
  a154=(a154+a155);
  a155=(a126*a088);
  a154=(a154+a155);
  a154=(a000+a154);
  a155=sin(a154);
  a156=cos(a151);
  a157=(a155*a156);
  a154=cos(a154);
  a158=(a154*a152);
  a157=(a157-a158);
  a158=(a007*a157);
  a150=(a150-a158);
  a159=(a155*a019);
  a150=(a150+a159);
  a160=(a018-a156);
  a160=(a021*a160);
  a160=(a160+a018);
  a161=(a150/a160);
  a162=(a156-a018);
  a162=(a007*a162);
  a163=(a162/a160);
  a164=casadi_sq(a108);
  a164=(a164*a152);
  a164=(a164+a157);
  a164=(a007*a164);
  a157=arg[2]? arg[2][14] : 0;
  a165=(a029*a157);
  a166=arg[2]? arg[2][15] : 0;
  a167=(a033*a166);
  a165=(a165+a167);
  a165=(a028*a165);
  a165=(a149+a165);
  a165=(a015*a165);
  a157=(a033*a157);
  a166=(a029*a166);
  a157=(a157-a166);
  a157=(a157+a018);
  a157=(a027*a157);
  a157=(a032-a157);
  a157=(a157+a151);
  a157=(a031*a157);
  a165=(a165+a157);
  a164=(a164-a165);
  a150=(a163*a150);
  a150=(a164-a150);
  a162=(a162*a163);
  a162=(a007-a162);
  a150=(a150/a162);
  a165=(a163*a150);
  a161=(a161-a165);
  a165=(a148*a161);
  a129=(a129+a165);
  a129=(a003+a129);
  a165=(a143*a129);
  a004=(a004+a165);
  a165=-1.5216094966251609e-01;
  a165=(a165*a002);
  a157=4.7766253643826434e-01;
  a157=(a157*a002);
  a151=(a157*a023);
  a166=-2.4881146199716677e+00;
  a166=(a166*a002);
  a167=(a166*a081);
  a151=(a151+a167);
  a167=-5.9029082683684297e-01;
  a167=(a167*a002);
  a168=(a167*a098);
  a151=(a151+a168);
  a168=2.1230051448181193e+01;
  a168=(a168*a002);
  a169=(a168*a118);
  a151=(a151+a169);
  a169=1.5279233632882423e+01;
  a169=(a169*a002);
  a170=(a169*a139);
  a151=(a151+a170);
  a170=-3.3288210968984863e+01;
  a170=(a170*a002);
  a171=(a170*a161);
  a151=(a151+a171);
  a171=-2.0331201708508627e-02;
  a171=(a171*a002);
  a172=(a135*a009);
  a173=(a144*a069);
  a172=(a172+a173);
  a173=(a145*a087);
  a172=(a172+a173);
  a173=(a146*a107);
  a172=(a172+a173);
  a173=(a147*a128);
  a172=(a172+a173);
  a173=(a148*a150);
  a172=(a172+a173);
  a172=(a008+a172);
  a173=(a007*a172);
  a174=(a135*a008);
  a175=(a144*a036);
  a174=(a174+a175);
  a175=(a145*a070);
  a174=(a174+a175);
  a175=(a146*a106);
  a174=(a174+a175);
  a175=(a147*a127);
  a174=(a174+a175);
  a175=(a148*a149);
  a174=(a174+a175);
  a174=(a010+a174);
  a175=sin(a174);
  a173=(a173*a175);
  a176=(2.*a129);
  a176=(a172-a176);
  a173=(a173*a176);
  a177=(a135*a003);
  a178=(a144*a072);
  a177=(a177+a178);
  a178=(a145*a090);
  a177=(a177+a178);
  a178=(a146*a030);
  a177=(a177+a178);
  a178=(a147*a088);
  a177=(a177+a178);
  a178=(a148*a108);
  a177=(a177+a178);
  a177=(a000+a177);
  a178=sin(a177);
  a179=cos(a174);
  a180=(a178*a179);
  a177=cos(a177);
  a181=(a177*a175);
  a180=(a180-a181);
  a181=(a007*a180);
  a173=(a173-a181);
  a182=(a178*a019);
  a173=(a173+a182);
  a183=(a018-a179);
  a183=(a021*a183);
  a183=(a183+a018);
  a184=(a173/a183);
  a185=(a179-a018);
  a185=(a007*a185);
  a186=(a185/a183);
  a187=casadi_sq(a129);
  a187=(a187*a175);
  a187=(a187+a180);
  a187=(a007*a187);
  a180=arg[2]? arg[2][16] : 0;
  a188=(a029*a180);
  a189=arg[2]? arg[2][17] : 0;
  a190=(a033*a189);
  a188=(a188+a190);
  a188=(a028*a188);
  a188=(a172+a188);
  a188=(a015*a188);
  a180=(a033*a180);
  a189=(a029*a189);
  a180=(a180-a189);
  a180=(a180+a018);
  a180=(a027*a180);
  a180=(a032-a180);
  a180=(a180+a174);
  a180=(a031*a180);
  a188=(a188+a180);
  a187=(a187-a188);
  a173=(a186*a173);
  a173=(a187-a173);
  a185=(a185*a186);
  a185=(a007-a185);
  a173=(a173/a185);
  a188=(a186*a173);
  a184=(a184-a188);
  a188=(a171*a184);
  a151=(a151+a188);
  a151=(a003+a151);
  a188=(a165*a151);
  a004=(a004+a188);
  a188=2.0136540080403034e-01;
  a188=(a188*a002);
  a180=-9.3714243008598730e-01;
  a180=(a180*a002);
  a174=(a180*a023);
  a189=5.1863724288440638e+00;
  a189=(a189*a002);
  a190=(a189*a081);
  a174=(a174+a190);
  a190=1.0914373489967295e+00;
  a190=(a190*a002);
  a191=(a190*a098);
  a174=(a174+a191);
  a191=-8.1497870107469268e+00;
  a191=(a191*a002);
  a192=(a191*a118);
  a174=(a174+a192);
  a192=-1.8520065659996959e+01;
  a192=(a192*a002);
  a193=(a192*a139);
  a174=(a174+a193);
  a193=2.2739487099350505e+01;
  a193=(a193*a002);
  a194=(a193*a161);
  a174=(a174+a194);
  a194=2.4936055526796523e+00;
  a194=(a194*a002);
  a195=(a194*a184);
  a174=(a174+a195);
  a195=-3.0467644718982196e+00;
  a195=(a195*a002);
  a196=(a157*a009);
  a197=(a166*a069);
  a196=(a196+a197);
  a197=(a167*a087);
  a196=(a196+a197);
  a197=(a168*a107);
  a196=(a196+a197);
  a197=(a169*a128);
  a196=(a196+a197);
  a197=(a170*a150);
  a196=(a196+a197);
  a197=(a171*a173);
  a196=(a196+a197);
  a196=(a008+a196);
  a197=(a007*a196);
  a198=(a157*a008);
  a199=(a166*a036);
  a198=(a198+a199);
  a199=(a167*a070);
  a198=(a198+a199);
  a199=(a168*a106);
  a198=(a198+a199);
  a199=(a169*a127);
  a198=(a198+a199);
  a199=(a170*a149);
  a198=(a198+a199);
  a199=(a171*a172);
  a198=(a198+a199);
  a198=(a010+a198);
  a199=sin(a198);
  a197=(a197*a199);
  a200=(2.*a151);
  a200=(a196-a200);
  a197=(a197*a200);
  a201=(a157*a003);
  a202=(a166*a072);
  a201=(a201+a202);
  a202=(a167*a090);
  a201=(a201+a202);
  a202=(a168*a030);
  a201=(a201+a202);
  a202=(a169*a088);
  a201=(a201+a202);
  a202=(a170*a108);
  a201=(a201+a202);
  a202=(a171*a129);
  a201=(a201+a202);
  a201=(a000+a201);
  a202=sin(a201);
  a203=cos(a198);
  a204=(a202*a203);
  a201=cos(a201);
  a205=(a201*a199);
  a204=(a204-a205);
  a205=(a007*a204);
  a197=(a197-a205);
  a206=(a202*a019);
  a197=(a197+a206);
  a207=(a018-a203);
  a207=(a021*a207);
  a207=(a207+a018);
  a208=(a197/a207);
  a209=(a203-a018);
  a209=(a007*a209);
  a210=(a209/a207);
  a211=casadi_sq(a151);
  a211=(a211*a199);
  a211=(a211+a204);
  a211=(a007*a211);
  a204=arg[2]? arg[2][18] : 0;
  a212=(a029*a204);
  a213=arg[2]? arg[2][19] : 0;
  a214=(a033*a213);
  a212=(a212+a214);
  a212=(a028*a212);
  a212=(a196+a212);
  a212=(a015*a212);
  a204=(a033*a204);
  a213=(a029*a213);
  a204=(a204-a213);
  a204=(a204+a018);
  a204=(a027*a204);
  a204=(a032-a204);
  a204=(a204+a198);
  a204=(a031*a204);
  a212=(a212+a204);
  a211=(a211-a212);
  a197=(a210*a197);
  a197=(a211-a197);
  a209=(a209*a210);
  a209=(a007-a209);
  a197=(a197/a209);
  a212=(a210*a197);
  a208=(a208-a212);
  a212=(a195*a208);
  a174=(a174+a212);
  a174=(a003+a174);
  a212=(a188*a174);
  a004=(a004+a212);
  a212=4.4710615727772587e-02;
  a212=(a212*a002);
  a204=2.2733101475165380e+00;
  a204=(a204*a002);
  a198=(a204*a023);
  a213=-1.0534495466737249e+01;
  a213=(a213*a002);
  a081=(a213*a081);
  a198=(a198+a081);
  a081=-2.0008720582248625e+00;
  a081=(a081*a002);
  a098=(a081*a098);
  a198=(a198+a098);
  a098=-1.7958931863118799e+01;
  a098=(a098*a002);
  a214=(a098*a118);
  a198=(a198+a214);
  a214=2.7948884529419960e+01;
  a214=(a214*a002);
  a215=(a214*a139);
  a198=(a198+a215);
  a215=-2.8589982771350235e+00;
  a215=(a215*a002);
  a216=(a215*a161);
  a198=(a198+a216);
  a216=-8.8728569335306293e+00;
  a216=(a216*a002);
  a217=(a216*a184);
  a198=(a198+a217);
  a217=1.2360567175794303e+01;
  a217=(a217*a002);
  a218=(a217*a208);
  a198=(a198+a218);
  a218=6.4339274601576357e-01;
  a218=(a218*a002);
  a002=(a180*a009);
  a219=(a189*a069);
  a002=(a002+a219);
  a219=(a190*a087);
  a002=(a002+a219);
  a219=(a191*a107);
  a002=(a002+a219);
  a219=(a192*a128);
  a002=(a002+a219);
  a219=(a193*a150);
  a002=(a002+a219);
  a219=(a194*a173);
  a002=(a002+a219);
  a219=(a195*a197);
  a002=(a002+a219);
  a002=(a008+a002);
  a219=(a007*a002);
  a220=(a180*a008);
  a221=(a189*a036);
  a220=(a220+a221);
  a221=(a190*a070);
  a220=(a220+a221);
  a221=(a191*a106);
  a220=(a220+a221);
  a221=(a192*a127);
  a220=(a220+a221);
  a221=(a193*a149);
  a220=(a220+a221);
  a221=(a194*a172);
  a220=(a220+a221);
  a221=(a195*a196);
  a220=(a220+a221);
  a220=(a010+a220);
  a221=sin(a220);
  a219=(a219*a221);
  a222=(2.*a174);
  a222=(a002-a222);
  a219=(a219*a222);
  a223=(a180*a003);
  a224=(a189*a072);
  a223=(a223+a224);
  a224=(a190*a090);
  a223=(a223+a224);
  a224=(a191*a030);
  a223=(a223+a224);
  a224=(a192*a088);
  a223=(a223+a224);
  a224=(a193*a108);
  a223=(a223+a224);
  a224=(a194*a129);
  a223=(a223+a224);
  a224=(a195*a151);
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
  a233=casadi_sq(a174);
  a233=(a233*a221);
  a233=(a233+a226);
  a233=(a007*a233);
  a226=arg[2]? arg[2][20] : 0;
  a234=(a029*a226);
  a235=arg[2]? arg[2][21] : 0;
  a236=(a033*a235);
  a234=(a234+a236);
  a234=(a028*a234);
  a234=(a002+a234);
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
  a219=(a232*a219);
  a219=(a233-a219);
  a231=(a231*a232);
  a231=(a007-a231);
  a219=(a219/a231);
  a234=(a232*a219);
  a230=(a230-a234);
  a234=(a218*a230);
  a198=(a198+a234);
  a198=(a003+a198);
  a234=(a212*a198);
  a004=(a004+a234);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a234=(a005*a106);
  a004=(a004+a234);
  a234=(a102*a127);
  a004=(a004+a234);
  a234=(a122*a149);
  a004=(a004+a234);
  a234=(a143*a172);
  a004=(a004+a234);
  a234=(a165*a196);
  a004=(a004+a234);
  a234=(a188*a002);
  a004=(a004+a234);
  a234=(a204*a009);
  a069=(a213*a069);
  a234=(a234+a069);
  a087=(a081*a087);
  a234=(a234+a087);
  a087=(a098*a107);
  a234=(a234+a087);
  a087=(a214*a128);
  a234=(a234+a087);
  a087=(a215*a150);
  a234=(a234+a087);
  a087=(a216*a173);
  a234=(a234+a087);
  a087=(a217*a197);
  a234=(a234+a087);
  a087=(a218*a219);
  a234=(a234+a087);
  a234=(a008+a234);
  a087=(a212*a234);
  a004=(a004+a087);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a023=(a001*a023);
  a118=(a005*a118);
  a023=(a023+a118);
  a139=(a102*a139);
  a023=(a023+a139);
  a161=(a122*a161);
  a023=(a023+a161);
  a184=(a143*a184);
  a023=(a023+a184);
  a208=(a165*a208);
  a023=(a023+a208);
  a230=(a188*a230);
  a023=(a023+a230);
  a230=(a007*a234);
  a208=(a204*a008);
  a184=(a213*a036);
  a208=(a208+a184);
  a184=(a081*a070);
  a208=(a208+a184);
  a184=(a098*a106);
  a208=(a208+a184);
  a184=(a214*a127);
  a208=(a208+a184);
  a184=(a215*a149);
  a208=(a208+a184);
  a184=(a216*a172);
  a208=(a208+a184);
  a184=(a217*a196);
  a208=(a208+a184);
  a184=(a218*a002);
  a208=(a208+a184);
  a010=(a010+a208);
  a208=sin(a010);
  a230=(a230*a208);
  a184=(2.*a198);
  a184=(a234-a184);
  a230=(a230*a184);
  a161=(a204*a003);
  a139=(a213*a072);
  a161=(a161+a139);
  a139=(a081*a090);
  a161=(a161+a139);
  a139=(a098*a030);
  a161=(a161+a139);
  a139=(a214*a088);
  a161=(a161+a139);
  a139=(a215*a108);
  a161=(a161+a139);
  a139=(a216*a129);
  a161=(a161+a139);
  a139=(a217*a151);
  a161=(a161+a139);
  a139=(a218*a174);
  a161=(a161+a139);
  a000=(a000+a161);
  a161=sin(a000);
  a139=cos(a010);
  a118=(a161*a139);
  a000=cos(a000);
  a004=(a000*a208);
  a118=(a118-a004);
  a004=(a007*a118);
  a230=(a230-a004);
  a019=(a161*a019);
  a230=(a230+a019);
  a087=(a018-a139);
  a087=(a021*a087);
  a087=(a087+a018);
  a069=(a230/a087);
  a226=(a139-a018);
  a226=(a007*a226);
  a220=(a226/a087);
  a235=casadi_sq(a198);
  a235=(a235*a208);
  a235=(a235+a118);
  a235=(a007*a235);
  a118=arg[2]? arg[2][22] : 0;
  a236=(a029*a118);
  a237=arg[2]? arg[2][23] : 0;
  a238=(a033*a237);
  a236=(a236+a238);
  a028=(a028*a236);
  a028=(a234+a028);
  a028=(a015*a028);
  a033=(a033*a118);
  a029=(a029*a237);
  a033=(a033-a029);
  a033=(a033+a018);
  a027=(a027*a033);
  a032=(a032-a027);
  a032=(a032+a010);
  a032=(a031*a032);
  a028=(a028+a032);
  a235=(a235-a028);
  a230=(a220*a230);
  a230=(a235-a230);
  a226=(a226*a220);
  a226=(a007-a226);
  a230=(a230/a226);
  a028=(a220*a230);
  a069=(a069-a028);
  a069=(a212*a069);
  a023=(a023+a069);
  a023=(a003+a023);
  if (res[0]!=0) res[0][2]=a023;
  a009=(a001*a009);
  a107=(a005*a107);
  a009=(a009+a107);
  a128=(a102*a128);
  a009=(a009+a128);
  a150=(a122*a150);
  a009=(a009+a150);
  a173=(a143*a173);
  a009=(a009+a173);
  a197=(a165*a197);
  a009=(a009+a197);
  a219=(a188*a219);
  a009=(a009+a219);
  a230=(a212*a230);
  a009=(a009+a230);
  a009=(a008+a009);
  if (res[0]!=0) res[0][3]=a009;
  a009=arg[0]? arg[0][4] : 0;
  a230=arg[0]? arg[0][6] : 0;
  a219=(a001*a230);
  a197=(a016*a014);
  a013=(a013*a011);
  a197=(a197+a013);
  a013=(a016-a197);
  a013=(a007*a013);
  a013=(a013+a016);
  a016=(a013/a022);
  a173=(a007*a197);
  a013=(a025*a013);
  a173=(a173-a013);
  a173=(a173/a024);
  a013=(a025*a173);
  a016=(a016-a013);
  a013=(a016*a009);
  a012=(a008*a012);
  a150=(a014*a012);
  a150=(a197+a150);
  a128=(a007*a011);
  a128=(a128*a012);
  a128=(a128-a017);
  a128=(a128+a020);
  a020=(a025*a128);
  a026=(a026-a020);
  a026=(a026/a024);
  a128=(a128/a022);
  a020=(a025*a026);
  a128=(a128-a020);
  a020=(2.*a128);
  a026=(a026-a020);
  a026=(a011*a026);
  a150=(a150+a026);
  a150=(a007*a150);
  a026=(a150/a022);
  a128=(a128*a011);
  a128=(a128-a197);
  a014=(a014*a003);
  a014=(a014*a003);
  a128=(a128+a014);
  a128=(a007*a128);
  a128=(a128-a031);
  a150=(a025*a150);
  a128=(a128-a150);
  a128=(a128/a024);
  a150=(a025*a128);
  a026=(a026-a150);
  a150=arg[0]? arg[0][5] : 0;
  a014=(a026*a150);
  a013=(a013+a014);
  a014=-2.;
  a014=(a014*a007);
  a197=(a014*a008);
  a197=(a197*a011);
  a020=(a197/a022);
  a017=(a021*a003);
  a017=(a017*a011);
  a197=(a025*a197);
  a017=(a017-a197);
  a017=(a017/a024);
  a197=(a025*a017);
  a020=(a020-a197);
  a197=(a020*a230);
  a011=(a021*a011);
  a008=(a008-a003);
  a011=(a011*a008);
  a022=(a011/a022);
  a011=(a025*a011);
  a011=(a015+a011);
  a011=(a011/a024);
  a025=(a025*a011);
  a022=(a022+a025);
  a025=arg[0]? arg[0][7] : 0;
  a024=(a022*a025);
  a197=(a197+a024);
  a013=(a013+a197);
  a197=(a006*a013);
  a024=(a074*a076);
  a075=(a075*a071);
  a024=(a024+a075);
  a075=(a074-a024);
  a075=(a007*a075);
  a075=(a075+a074);
  a074=(a075/a080);
  a008=(a007*a024);
  a075=(a083*a075);
  a008=(a008-a075);
  a008=(a008/a082);
  a075=(a083*a008);
  a074=(a074-a075);
  a075=(a035*a230);
  a003=(a038*a013);
  a012=(a048*a050);
  a049=(a049*a045);
  a012=(a012+a049);
  a049=(a048-a012);
  a049=(a007*a049);
  a049=(a049+a048);
  a048=(a049/a054);
  a107=(a007*a012);
  a049=(a057*a049);
  a107=(a107-a049);
  a107=(a107/a056);
  a049=(a057*a107);
  a048=(a048-a049);
  a049=(a041*a230);
  a049=(a009+a049);
  a023=(a048*a049);
  a047=(a042*a047);
  a069=(a050*a047);
  a069=(a012+a069);
  a028=(a007*a045);
  a028=(a028*a047);
  a028=(a028-a052);
  a028=(a028+a053);
  a053=(a057*a028);
  a058=(a058-a053);
  a058=(a058/a056);
  a028=(a028/a054);
  a053=(a057*a058);
  a028=(a028-a053);
  a053=(2.*a028);
  a058=(a058-a053);
  a058=(a045*a058);
  a069=(a069+a058);
  a069=(a007*a069);
  a058=(a069/a054);
  a028=(a028*a045);
  a028=(a028-a012);
  a050=(a050*a046);
  a050=(a050*a046);
  a028=(a028+a050);
  a028=(a007*a028);
  a028=(a028-a031);
  a069=(a057*a069);
  a028=(a028-a069);
  a028=(a028/a056);
  a069=(a057*a028);
  a058=(a058-a069);
  a069=(a041*a025);
  a069=(a150+a069);
  a050=(a058*a069);
  a023=(a023+a050);
  a050=(a014*a042);
  a050=(a050*a045);
  a012=(a050/a054);
  a053=(a021*a046);
  a053=(a053*a045);
  a050=(a057*a050);
  a053=(a053-a050);
  a053=(a053/a056);
  a050=(a057*a053);
  a012=(a012-a050);
  a050=(a041*a013);
  a050=(a230+a050);
  a052=(a012*a050);
  a045=(a021*a045);
  a042=(a042-a046);
  a045=(a045*a042);
  a054=(a045/a054);
  a045=(a057*a045);
  a045=(a015+a045);
  a045=(a045/a056);
  a057=(a057*a045);
  a054=(a054+a057);
  a057=(a173*a009);
  a056=(a128*a150);
  a057=(a057+a056);
  a056=(a017*a230);
  a042=(a011*a025);
  a056=(a056-a042);
  a057=(a057+a056);
  a056=(a041*a057);
  a056=(a025+a056);
  a042=(a054*a056);
  a052=(a052+a042);
  a023=(a023+a052);
  a023=(a040*a023);
  a003=(a003+a023);
  a003=(a230+a003);
  a023=(a037*a003);
  a075=(a075+a023);
  a075=(a009+a075);
  a023=(a074*a075);
  a073=(a036*a073);
  a052=(a076*a073);
  a052=(a024+a052);
  a042=(a007*a071);
  a042=(a042*a073);
  a042=(a042-a078);
  a042=(a042+a079);
  a079=(a083*a042);
  a084=(a084-a079);
  a084=(a084/a082);
  a042=(a042/a080);
  a079=(a083*a084);
  a042=(a042-a079);
  a079=(2.*a042);
  a084=(a084-a079);
  a084=(a071*a084);
  a052=(a052+a084);
  a052=(a007*a052);
  a084=(a052/a080);
  a042=(a042*a071);
  a042=(a042-a024);
  a076=(a076*a072);
  a076=(a076*a072);
  a042=(a042+a076);
  a042=(a007*a042);
  a042=(a042-a031);
  a052=(a083*a052);
  a042=(a042-a052);
  a042=(a042/a082);
  a052=(a083*a042);
  a084=(a084-a052);
  a052=(a035*a025);
  a076=(a038*a057);
  a049=(a107*a049);
  a069=(a028*a069);
  a049=(a049+a069);
  a069=(a053*a050);
  a024=(a045*a056);
  a069=(a069-a024);
  a049=(a049+a069);
  a049=(a040*a049);
  a076=(a076+a049);
  a076=(a025+a076);
  a049=(a037*a076);
  a052=(a052+a049);
  a052=(a150+a052);
  a049=(a084*a052);
  a023=(a023+a049);
  a049=(a014*a036);
  a049=(a049*a071);
  a069=(a049/a080);
  a024=(a021*a072);
  a024=(a024*a071);
  a049=(a083*a049);
  a024=(a024-a049);
  a024=(a024/a082);
  a049=(a083*a024);
  a069=(a069-a049);
  a049=(a035*a013);
  a079=(a044*a061);
  a060=(a060*a051);
  a079=(a079+a060);
  a060=(a044-a079);
  a060=(a007*a060);
  a060=(a060+a044);
  a044=(a060/a043);
  a078=(a007*a079);
  a060=(a059*a060);
  a078=(a078-a060);
  a078=(a078/a064);
  a060=(a059*a078);
  a044=(a044-a060);
  a060=(a038*a230);
  a050=(a040*a050);
  a060=(a060+a050);
  a060=(a009+a060);
  a050=(a044*a060);
  a066=(a063*a066);
  a073=(a061*a066);
  a073=(a079+a073);
  a046=(a007*a051);
  a046=(a046*a066);
  a046=(a046-a062);
  a046=(a046+a067);
  a067=(a059*a046);
  a055=(a055-a067);
  a055=(a055/a064);
  a046=(a046/a043);
  a067=(a059*a055);
  a046=(a046-a067);
  a067=(2.*a046);
  a055=(a055-a067);
  a055=(a051*a055);
  a073=(a073+a055);
  a073=(a007*a073);
  a055=(a073/a043);
  a046=(a046*a051);
  a046=(a046-a079);
  a061=(a061*a039);
  a061=(a061*a039);
  a046=(a046+a061);
  a046=(a007*a046);
  a046=(a046-a031);
  a073=(a059*a073);
  a046=(a046-a073);
  a046=(a046/a064);
  a073=(a059*a046);
  a055=(a055-a073);
  a073=(a038*a025);
  a056=(a040*a056);
  a073=(a073+a056);
  a073=(a150+a073);
  a056=(a055*a073);
  a050=(a050+a056);
  a056=(a014*a063);
  a056=(a056*a051);
  a061=(a056/a043);
  a079=(a021*a039);
  a079=(a079*a051);
  a056=(a059*a056);
  a079=(a079-a056);
  a079=(a079/a064);
  a056=(a059*a079);
  a061=(a061-a056);
  a056=(a061*a003);
  a051=(a021*a051);
  a063=(a063-a039);
  a051=(a051*a063);
  a043=(a051/a043);
  a051=(a059*a051);
  a051=(a015+a051);
  a051=(a051/a064);
  a059=(a059*a051);
  a043=(a043+a059);
  a059=(a043*a076);
  a056=(a056+a059);
  a050=(a050+a056);
  a056=(a037*a050);
  a049=(a049+a056);
  a049=(a230+a049);
  a056=(a069*a049);
  a071=(a021*a071);
  a036=(a036-a072);
  a071=(a071*a036);
  a080=(a071/a080);
  a071=(a083*a071);
  a071=(a015+a071);
  a071=(a071/a082);
  a083=(a083*a071);
  a080=(a080+a083);
  a083=(a035*a057);
  a060=(a078*a060);
  a073=(a046*a073);
  a060=(a060+a073);
  a073=(a079*a003);
  a082=(a051*a076);
  a073=(a073-a082);
  a060=(a060+a073);
  a073=(a037*a060);
  a083=(a083+a073);
  a083=(a025+a083);
  a073=(a080*a083);
  a056=(a056+a073);
  a023=(a023+a056);
  a056=(a034*a023);
  a197=(a197+a056);
  a056=(a091*a093);
  a092=(a092*a089);
  a056=(a056+a092);
  a092=(a091-a056);
  a092=(a007*a092);
  a092=(a092+a091);
  a091=(a092/a097);
  a073=(a007*a056);
  a092=(a100*a092);
  a073=(a073-a092);
  a073=(a073/a099);
  a092=(a100*a073);
  a091=(a091-a092);
  a092=(a077*a230);
  a003=(a086*a003);
  a092=(a092+a003);
  a003=(a068*a049);
  a092=(a092+a003);
  a092=(a009+a092);
  a003=(a091*a092);
  a065=(a070*a065);
  a082=(a093*a065);
  a082=(a056+a082);
  a036=(a007*a089);
  a036=(a036*a065);
  a036=(a036-a095);
  a036=(a036+a096);
  a096=(a100*a036);
  a101=(a101-a096);
  a101=(a101/a099);
  a036=(a036/a097);
  a096=(a100*a101);
  a036=(a036-a096);
  a096=(2.*a036);
  a101=(a101-a096);
  a101=(a089*a101);
  a082=(a082+a101);
  a082=(a007*a082);
  a101=(a082/a097);
  a036=(a036*a089);
  a036=(a036-a056);
  a093=(a093*a090);
  a093=(a093*a090);
  a036=(a036+a093);
  a036=(a007*a036);
  a036=(a036-a031);
  a082=(a100*a082);
  a036=(a036-a082);
  a036=(a036/a099);
  a082=(a100*a036);
  a101=(a101-a082);
  a082=(a077*a025);
  a076=(a086*a076);
  a082=(a082+a076);
  a076=(a068*a083);
  a082=(a082+a076);
  a082=(a150+a082);
  a076=(a101*a082);
  a003=(a003+a076);
  a076=(a014*a070);
  a076=(a076*a089);
  a093=(a076/a097);
  a056=(a021*a090);
  a056=(a056*a089);
  a076=(a100*a076);
  a056=(a056-a076);
  a056=(a056/a099);
  a076=(a100*a056);
  a093=(a093-a076);
  a076=(a077*a013);
  a050=(a086*a050);
  a076=(a076+a050);
  a050=(a068*a023);
  a076=(a076+a050);
  a076=(a230+a076);
  a050=(a093*a076);
  a089=(a021*a089);
  a070=(a070-a090);
  a089=(a089*a070);
  a097=(a089/a097);
  a089=(a100*a089);
  a089=(a015+a089);
  a089=(a089/a099);
  a100=(a100*a089);
  a097=(a097+a100);
  a100=(a077*a057);
  a060=(a086*a060);
  a100=(a100+a060);
  a075=(a008*a075);
  a052=(a042*a052);
  a075=(a075+a052);
  a052=(a024*a049);
  a060=(a071*a083);
  a052=(a052-a060);
  a075=(a075+a052);
  a052=(a068*a075);
  a100=(a100+a052);
  a100=(a025+a100);
  a052=(a097*a100);
  a050=(a050+a052);
  a003=(a003+a050);
  a050=(a085*a003);
  a197=(a197+a050);
  a197=(a230+a197);
  a050=(a005*a197);
  a219=(a219+a050);
  a050=(a094*a013);
  a052=(a103*a023);
  a050=(a050+a052);
  a052=(a104*a003);
  a050=(a050+a052);
  a052=(a111*a113);
  a112=(a112*a109);
  a052=(a052+a112);
  a112=(a111-a052);
  a112=(a007*a112);
  a112=(a112+a111);
  a111=(a112/a117);
  a060=(a007*a052);
  a112=(a120*a112);
  a060=(a060-a112);
  a060=(a060/a119);
  a112=(a120*a060);
  a111=(a111-a112);
  a112=(a006*a230);
  a099=(a034*a049);
  a112=(a112+a099);
  a099=(a085*a076);
  a112=(a112+a099);
  a112=(a009+a112);
  a099=(a111*a112);
  a110=(a106*a110);
  a070=(a113*a110);
  a070=(a052+a070);
  a090=(a007*a109);
  a090=(a090*a110);
  a090=(a090-a115);
  a090=(a090+a116);
  a116=(a120*a090);
  a121=(a121-a116);
  a121=(a121/a119);
  a090=(a090/a117);
  a116=(a120*a121);
  a090=(a090-a116);
  a116=(2.*a090);
  a121=(a121-a116);
  a121=(a109*a121);
  a070=(a070+a121);
  a070=(a007*a070);
  a121=(a070/a117);
  a090=(a090*a109);
  a090=(a090-a052);
  a113=(a113*a030);
  a113=(a113*a030);
  a090=(a090+a113);
  a090=(a007*a090);
  a090=(a090-a031);
  a070=(a120*a070);
  a090=(a090-a070);
  a090=(a090/a119);
  a070=(a120*a090);
  a121=(a121-a070);
  a070=(a006*a025);
  a113=(a034*a083);
  a070=(a070+a113);
  a113=(a085*a100);
  a070=(a070+a113);
  a070=(a150+a070);
  a113=(a121*a070);
  a099=(a099+a113);
  a113=(a014*a106);
  a113=(a113*a109);
  a052=(a113/a117);
  a116=(a021*a030);
  a116=(a116*a109);
  a113=(a120*a113);
  a116=(a116-a113);
  a116=(a116/a119);
  a113=(a120*a116);
  a052=(a052-a113);
  a113=(a052*a197);
  a109=(a021*a109);
  a106=(a106-a030);
  a109=(a109*a106);
  a117=(a109/a117);
  a109=(a120*a109);
  a109=(a015+a109);
  a109=(a109/a119);
  a120=(a120*a109);
  a117=(a117+a120);
  a120=(a006*a057);
  a119=(a034*a075);
  a120=(a120+a119);
  a092=(a073*a092);
  a082=(a036*a082);
  a092=(a092+a082);
  a082=(a056*a076);
  a119=(a089*a100);
  a082=(a082-a119);
  a092=(a092+a082);
  a082=(a085*a092);
  a120=(a120+a082);
  a120=(a025+a120);
  a082=(a117*a120);
  a113=(a113+a082);
  a099=(a099+a113);
  a113=(a105*a099);
  a050=(a050+a113);
  a050=(a230+a050);
  a113=(a102*a050);
  a219=(a219+a113);
  a113=(a114*a013);
  a082=(a123*a023);
  a113=(a113+a082);
  a082=(a124*a003);
  a113=(a113+a082);
  a082=(a125*a099);
  a113=(a113+a082);
  a082=(a132*a134);
  a133=(a133*a130);
  a082=(a082+a133);
  a133=(a132-a082);
  a133=(a007*a133);
  a133=(a133+a132);
  a132=(a133/a138);
  a119=(a007*a082);
  a133=(a141*a133);
  a119=(a119-a133);
  a119=(a119/a140);
  a133=(a141*a119);
  a132=(a132-a133);
  a133=(a094*a230);
  a106=(a103*a049);
  a133=(a133+a106);
  a106=(a104*a076);
  a133=(a133+a106);
  a106=(a105*a197);
  a133=(a133+a106);
  a133=(a009+a133);
  a106=(a132*a133);
  a131=(a127*a131);
  a030=(a134*a131);
  a030=(a082+a030);
  a115=(a007*a130);
  a115=(a115*a131);
  a115=(a115-a136);
  a115=(a115+a137);
  a137=(a141*a115);
  a142=(a142-a137);
  a142=(a142/a140);
  a115=(a115/a138);
  a137=(a141*a142);
  a115=(a115-a137);
  a137=(2.*a115);
  a142=(a142-a137);
  a142=(a130*a142);
  a030=(a030+a142);
  a030=(a007*a030);
  a142=(a030/a138);
  a115=(a115*a130);
  a115=(a115-a082);
  a134=(a134*a088);
  a134=(a134*a088);
  a115=(a115+a134);
  a115=(a007*a115);
  a115=(a115-a031);
  a030=(a141*a030);
  a115=(a115-a030);
  a115=(a115/a140);
  a030=(a141*a115);
  a142=(a142-a030);
  a030=(a094*a025);
  a134=(a103*a083);
  a030=(a030+a134);
  a134=(a104*a100);
  a030=(a030+a134);
  a134=(a105*a120);
  a030=(a030+a134);
  a030=(a150+a030);
  a134=(a142*a030);
  a106=(a106+a134);
  a134=(a014*a127);
  a134=(a134*a130);
  a082=(a134/a138);
  a137=(a021*a088);
  a137=(a137*a130);
  a134=(a141*a134);
  a137=(a137-a134);
  a137=(a137/a140);
  a134=(a141*a137);
  a082=(a082-a134);
  a134=(a082*a050);
  a130=(a021*a130);
  a127=(a127-a088);
  a130=(a130*a127);
  a138=(a130/a138);
  a130=(a141*a130);
  a130=(a015+a130);
  a130=(a130/a140);
  a141=(a141*a130);
  a138=(a138+a141);
  a141=(a094*a057);
  a140=(a103*a075);
  a141=(a141+a140);
  a140=(a104*a092);
  a141=(a141+a140);
  a112=(a060*a112);
  a070=(a090*a070);
  a112=(a112+a070);
  a070=(a116*a197);
  a140=(a109*a120);
  a070=(a070-a140);
  a112=(a112+a070);
  a070=(a105*a112);
  a141=(a141+a070);
  a141=(a025+a141);
  a070=(a138*a141);
  a134=(a134+a070);
  a106=(a106+a134);
  a134=(a126*a106);
  a113=(a113+a134);
  a113=(a230+a113);
  a134=(a122*a113);
  a219=(a219+a134);
  a134=(a135*a013);
  a070=(a144*a023);
  a134=(a134+a070);
  a070=(a145*a003);
  a134=(a134+a070);
  a070=(a146*a099);
  a134=(a134+a070);
  a070=(a147*a106);
  a134=(a134+a070);
  a070=(a154*a156);
  a155=(a155*a152);
  a070=(a070+a155);
  a155=(a154-a070);
  a155=(a007*a155);
  a155=(a155+a154);
  a154=(a155/a160);
  a140=(a007*a070);
  a155=(a163*a155);
  a140=(a140-a155);
  a140=(a140/a162);
  a155=(a163*a140);
  a154=(a154-a155);
  a155=(a114*a230);
  a127=(a123*a049);
  a155=(a155+a127);
  a127=(a124*a076);
  a155=(a155+a127);
  a127=(a125*a197);
  a155=(a155+a127);
  a127=(a126*a050);
  a155=(a155+a127);
  a155=(a009+a155);
  a127=(a154*a155);
  a153=(a149*a153);
  a088=(a156*a153);
  a088=(a070+a088);
  a136=(a007*a152);
  a136=(a136*a153);
  a136=(a136-a158);
  a136=(a136+a159);
  a159=(a163*a136);
  a164=(a164-a159);
  a164=(a164/a162);
  a136=(a136/a160);
  a159=(a163*a164);
  a136=(a136-a159);
  a159=(2.*a136);
  a164=(a164-a159);
  a164=(a152*a164);
  a088=(a088+a164);
  a088=(a007*a088);
  a164=(a088/a160);
  a136=(a136*a152);
  a136=(a136-a070);
  a156=(a156*a108);
  a156=(a156*a108);
  a136=(a136+a156);
  a136=(a007*a136);
  a136=(a136-a031);
  a088=(a163*a088);
  a136=(a136-a088);
  a136=(a136/a162);
  a088=(a163*a136);
  a164=(a164-a088);
  a088=(a114*a025);
  a156=(a123*a083);
  a088=(a088+a156);
  a156=(a124*a100);
  a088=(a088+a156);
  a156=(a125*a120);
  a088=(a088+a156);
  a156=(a126*a141);
  a088=(a088+a156);
  a088=(a150+a088);
  a156=(a164*a088);
  a127=(a127+a156);
  a156=(a014*a149);
  a156=(a156*a152);
  a070=(a156/a160);
  a159=(a021*a108);
  a159=(a159*a152);
  a156=(a163*a156);
  a159=(a159-a156);
  a159=(a159/a162);
  a156=(a163*a159);
  a070=(a070-a156);
  a156=(a070*a113);
  a152=(a021*a152);
  a149=(a149-a108);
  a152=(a152*a149);
  a160=(a152/a160);
  a152=(a163*a152);
  a152=(a015+a152);
  a152=(a152/a162);
  a163=(a163*a152);
  a160=(a160+a163);
  a163=(a114*a057);
  a162=(a123*a075);
  a163=(a163+a162);
  a162=(a124*a092);
  a163=(a163+a162);
  a162=(a125*a112);
  a163=(a163+a162);
  a133=(a119*a133);
  a030=(a115*a030);
  a133=(a133+a030);
  a030=(a137*a050);
  a162=(a130*a141);
  a030=(a030-a162);
  a133=(a133+a030);
  a030=(a126*a133);
  a163=(a163+a030);
  a163=(a025+a163);
  a030=(a160*a163);
  a156=(a156+a030);
  a127=(a127+a156);
  a156=(a148*a127);
  a134=(a134+a156);
  a134=(a230+a134);
  a156=(a143*a134);
  a219=(a219+a156);
  a156=(a157*a013);
  a030=(a166*a023);
  a156=(a156+a030);
  a030=(a167*a003);
  a156=(a156+a030);
  a030=(a168*a099);
  a156=(a156+a030);
  a030=(a169*a106);
  a156=(a156+a030);
  a030=(a170*a127);
  a156=(a156+a030);
  a030=(a177*a179);
  a178=(a178*a175);
  a030=(a030+a178);
  a178=(a177-a030);
  a178=(a007*a178);
  a178=(a178+a177);
  a177=(a178/a183);
  a162=(a007*a030);
  a178=(a186*a178);
  a162=(a162-a178);
  a162=(a162/a185);
  a178=(a186*a162);
  a177=(a177-a178);
  a178=(a135*a230);
  a149=(a144*a049);
  a178=(a178+a149);
  a149=(a145*a076);
  a178=(a178+a149);
  a149=(a146*a197);
  a178=(a178+a149);
  a149=(a147*a050);
  a178=(a178+a149);
  a149=(a148*a113);
  a178=(a178+a149);
  a178=(a009+a178);
  a149=(a177*a178);
  a176=(a172*a176);
  a108=(a179*a176);
  a108=(a030+a108);
  a158=(a007*a175);
  a158=(a158*a176);
  a158=(a158-a181);
  a158=(a158+a182);
  a182=(a186*a158);
  a187=(a187-a182);
  a187=(a187/a185);
  a158=(a158/a183);
  a182=(a186*a187);
  a158=(a158-a182);
  a182=(2.*a158);
  a187=(a187-a182);
  a187=(a175*a187);
  a108=(a108+a187);
  a108=(a007*a108);
  a187=(a108/a183);
  a158=(a158*a175);
  a158=(a158-a030);
  a179=(a179*a129);
  a179=(a179*a129);
  a158=(a158+a179);
  a158=(a007*a158);
  a158=(a158-a031);
  a108=(a186*a108);
  a158=(a158-a108);
  a158=(a158/a185);
  a108=(a186*a158);
  a187=(a187-a108);
  a108=(a135*a025);
  a179=(a144*a083);
  a108=(a108+a179);
  a179=(a145*a100);
  a108=(a108+a179);
  a179=(a146*a120);
  a108=(a108+a179);
  a179=(a147*a141);
  a108=(a108+a179);
  a179=(a148*a163);
  a108=(a108+a179);
  a108=(a150+a108);
  a179=(a187*a108);
  a149=(a149+a179);
  a179=(a014*a172);
  a179=(a179*a175);
  a030=(a179/a183);
  a182=(a021*a129);
  a182=(a182*a175);
  a179=(a186*a179);
  a182=(a182-a179);
  a182=(a182/a185);
  a179=(a186*a182);
  a030=(a030-a179);
  a179=(a030*a134);
  a175=(a021*a175);
  a172=(a172-a129);
  a175=(a175*a172);
  a183=(a175/a183);
  a175=(a186*a175);
  a175=(a015+a175);
  a175=(a175/a185);
  a186=(a186*a175);
  a183=(a183+a186);
  a186=(a135*a057);
  a185=(a144*a075);
  a186=(a186+a185);
  a185=(a145*a092);
  a186=(a186+a185);
  a185=(a146*a112);
  a186=(a186+a185);
  a185=(a147*a133);
  a186=(a186+a185);
  a155=(a140*a155);
  a088=(a136*a088);
  a155=(a155+a088);
  a088=(a159*a113);
  a185=(a152*a163);
  a088=(a088-a185);
  a155=(a155+a088);
  a088=(a148*a155);
  a186=(a186+a088);
  a186=(a025+a186);
  a088=(a183*a186);
  a179=(a179+a088);
  a149=(a149+a179);
  a179=(a171*a149);
  a156=(a156+a179);
  a156=(a230+a156);
  a179=(a165*a156);
  a219=(a219+a179);
  a179=(a180*a013);
  a088=(a189*a023);
  a179=(a179+a088);
  a088=(a190*a003);
  a179=(a179+a088);
  a088=(a191*a099);
  a179=(a179+a088);
  a088=(a192*a106);
  a179=(a179+a088);
  a088=(a193*a127);
  a179=(a179+a088);
  a088=(a194*a149);
  a179=(a179+a088);
  a088=(a201*a203);
  a202=(a202*a199);
  a088=(a088+a202);
  a202=(a201-a088);
  a202=(a007*a202);
  a202=(a202+a201);
  a201=(a202/a207);
  a185=(a007*a088);
  a202=(a210*a202);
  a185=(a185-a202);
  a185=(a185/a209);
  a202=(a210*a185);
  a201=(a201-a202);
  a202=(a157*a230);
  a172=(a166*a049);
  a202=(a202+a172);
  a172=(a167*a076);
  a202=(a202+a172);
  a172=(a168*a197);
  a202=(a202+a172);
  a172=(a169*a050);
  a202=(a202+a172);
  a172=(a170*a113);
  a202=(a202+a172);
  a172=(a171*a134);
  a202=(a202+a172);
  a202=(a009+a202);
  a172=(a201*a202);
  a200=(a196*a200);
  a129=(a203*a200);
  a129=(a088+a129);
  a181=(a007*a199);
  a181=(a181*a200);
  a181=(a181-a205);
  a181=(a181+a206);
  a206=(a210*a181);
  a211=(a211-a206);
  a211=(a211/a209);
  a181=(a181/a207);
  a206=(a210*a211);
  a181=(a181-a206);
  a206=(2.*a181);
  a211=(a211-a206);
  a211=(a199*a211);
  a129=(a129+a211);
  a129=(a007*a129);
  a211=(a129/a207);
  a181=(a181*a199);
  a181=(a181-a088);
  a203=(a203*a151);
  a203=(a203*a151);
  a181=(a181+a203);
  a181=(a007*a181);
  a181=(a181-a031);
  a129=(a210*a129);
  a181=(a181-a129);
  a181=(a181/a209);
  a129=(a210*a181);
  a211=(a211-a129);
  a129=(a157*a025);
  a203=(a166*a083);
  a129=(a129+a203);
  a203=(a167*a100);
  a129=(a129+a203);
  a203=(a168*a120);
  a129=(a129+a203);
  a203=(a169*a141);
  a129=(a129+a203);
  a203=(a170*a163);
  a129=(a129+a203);
  a203=(a171*a186);
  a129=(a129+a203);
  a129=(a150+a129);
  a203=(a211*a129);
  a172=(a172+a203);
  a203=(a014*a196);
  a203=(a203*a199);
  a088=(a203/a207);
  a206=(a021*a151);
  a206=(a206*a199);
  a203=(a210*a203);
  a206=(a206-a203);
  a206=(a206/a209);
  a203=(a210*a206);
  a088=(a088-a203);
  a203=(a088*a156);
  a199=(a021*a199);
  a196=(a196-a151);
  a199=(a199*a196);
  a207=(a199/a207);
  a199=(a210*a199);
  a199=(a015+a199);
  a199=(a199/a209);
  a210=(a210*a199);
  a207=(a207+a210);
  a210=(a157*a057);
  a209=(a166*a075);
  a210=(a210+a209);
  a209=(a167*a092);
  a210=(a210+a209);
  a209=(a168*a112);
  a210=(a210+a209);
  a209=(a169*a133);
  a210=(a210+a209);
  a209=(a170*a155);
  a210=(a210+a209);
  a178=(a162*a178);
  a108=(a158*a108);
  a178=(a178+a108);
  a108=(a182*a134);
  a209=(a175*a186);
  a108=(a108-a209);
  a178=(a178+a108);
  a108=(a171*a178);
  a210=(a210+a108);
  a210=(a025+a210);
  a108=(a207*a210);
  a203=(a203+a108);
  a172=(a172+a203);
  a203=(a195*a172);
  a179=(a179+a203);
  a179=(a230+a179);
  a203=(a188*a179);
  a219=(a219+a203);
  a203=(a204*a013);
  a023=(a213*a023);
  a203=(a203+a023);
  a003=(a081*a003);
  a203=(a203+a003);
  a003=(a098*a099);
  a203=(a203+a003);
  a003=(a214*a106);
  a203=(a203+a003);
  a003=(a215*a127);
  a203=(a203+a003);
  a003=(a216*a149);
  a203=(a203+a003);
  a003=(a217*a172);
  a203=(a203+a003);
  a003=(a223*a225);
  a224=(a224*a221);
  a003=(a003+a224);
  a224=(a223-a003);
  a224=(a007*a224);
  a224=(a224+a223);
  a223=(a224/a229);
  a023=(a007*a003);
  a224=(a232*a224);
  a023=(a023-a224);
  a023=(a023/a231);
  a224=(a232*a023);
  a223=(a223-a224);
  a224=(a180*a230);
  a108=(a189*a049);
  a224=(a224+a108);
  a108=(a190*a076);
  a224=(a224+a108);
  a108=(a191*a197);
  a224=(a224+a108);
  a108=(a192*a050);
  a224=(a224+a108);
  a108=(a193*a113);
  a224=(a224+a108);
  a108=(a194*a134);
  a224=(a224+a108);
  a108=(a195*a156);
  a224=(a224+a108);
  a224=(a009+a224);
  a108=(a223*a224);
  a222=(a002*a222);
  a209=(a225*a222);
  a209=(a003+a209);
  a196=(a007*a221);
  a196=(a196*a222);
  a196=(a196-a227);
  a196=(a196+a228);
  a228=(a232*a196);
  a233=(a233-a228);
  a233=(a233/a231);
  a196=(a196/a229);
  a228=(a232*a233);
  a196=(a196-a228);
  a228=(2.*a196);
  a233=(a233-a228);
  a233=(a221*a233);
  a209=(a209+a233);
  a209=(a007*a209);
  a233=(a209/a229);
  a196=(a196*a221);
  a196=(a196-a003);
  a225=(a225*a174);
  a225=(a225*a174);
  a196=(a196+a225);
  a196=(a007*a196);
  a196=(a196-a031);
  a209=(a232*a209);
  a196=(a196-a209);
  a196=(a196/a231);
  a209=(a232*a196);
  a233=(a233-a209);
  a209=(a180*a025);
  a225=(a189*a083);
  a209=(a209+a225);
  a225=(a190*a100);
  a209=(a209+a225);
  a225=(a191*a120);
  a209=(a209+a225);
  a225=(a192*a141);
  a209=(a209+a225);
  a225=(a193*a163);
  a209=(a209+a225);
  a225=(a194*a186);
  a209=(a209+a225);
  a225=(a195*a210);
  a209=(a209+a225);
  a209=(a150+a209);
  a225=(a233*a209);
  a108=(a108+a225);
  a225=(a014*a002);
  a225=(a225*a221);
  a003=(a225/a229);
  a228=(a021*a174);
  a228=(a228*a221);
  a225=(a232*a225);
  a228=(a228-a225);
  a228=(a228/a231);
  a225=(a232*a228);
  a003=(a003-a225);
  a225=(a003*a179);
  a221=(a021*a221);
  a002=(a002-a174);
  a221=(a221*a002);
  a229=(a221/a229);
  a221=(a232*a221);
  a221=(a015+a221);
  a221=(a221/a231);
  a232=(a232*a221);
  a229=(a229+a232);
  a232=(a180*a057);
  a231=(a189*a075);
  a232=(a232+a231);
  a231=(a190*a092);
  a232=(a232+a231);
  a231=(a191*a112);
  a232=(a232+a231);
  a231=(a192*a133);
  a232=(a232+a231);
  a231=(a193*a155);
  a232=(a232+a231);
  a231=(a194*a178);
  a232=(a232+a231);
  a202=(a185*a202);
  a129=(a181*a129);
  a202=(a202+a129);
  a129=(a206*a156);
  a231=(a199*a210);
  a129=(a129-a231);
  a202=(a202+a129);
  a129=(a195*a202);
  a232=(a232+a129);
  a232=(a025+a232);
  a129=(a229*a232);
  a225=(a225+a129);
  a108=(a108+a225);
  a225=(a218*a108);
  a203=(a203+a225);
  a203=(a230+a203);
  a225=(a212*a203);
  a219=(a219+a225);
  a219=(a009+a219);
  if (res[0]!=0) res[0][4]=a219;
  a219=(a001*a025);
  a225=(a005*a120);
  a219=(a219+a225);
  a225=(a102*a141);
  a219=(a219+a225);
  a225=(a122*a163);
  a219=(a219+a225);
  a225=(a143*a186);
  a219=(a219+a225);
  a225=(a165*a210);
  a219=(a219+a225);
  a225=(a188*a232);
  a219=(a219+a225);
  a225=(a204*a057);
  a075=(a213*a075);
  a225=(a225+a075);
  a092=(a081*a092);
  a225=(a225+a092);
  a092=(a098*a112);
  a225=(a225+a092);
  a092=(a214*a133);
  a225=(a225+a092);
  a092=(a215*a155);
  a225=(a225+a092);
  a092=(a216*a178);
  a225=(a225+a092);
  a092=(a217*a202);
  a225=(a225+a092);
  a224=(a023*a224);
  a209=(a196*a209);
  a224=(a224+a209);
  a209=(a228*a179);
  a092=(a221*a232);
  a209=(a209-a092);
  a224=(a224+a209);
  a209=(a218*a224);
  a225=(a225+a209);
  a225=(a025+a225);
  a209=(a212*a225);
  a219=(a219+a209);
  a219=(a150+a219);
  if (res[0]!=0) res[0][5]=a219;
  a013=(a001*a013);
  a099=(a005*a099);
  a013=(a013+a099);
  a106=(a102*a106);
  a013=(a013+a106);
  a127=(a122*a127);
  a013=(a013+a127);
  a149=(a143*a149);
  a013=(a013+a149);
  a172=(a165*a172);
  a013=(a013+a172);
  a108=(a188*a108);
  a013=(a013+a108);
  a108=(a000*a139);
  a161=(a161*a208);
  a108=(a108+a161);
  a161=(a000-a108);
  a161=(a007*a161);
  a161=(a161+a000);
  a000=(a161/a087);
  a172=(a007*a108);
  a161=(a220*a161);
  a172=(a172-a161);
  a172=(a172/a226);
  a161=(a220*a172);
  a000=(a000-a161);
  a161=(a204*a230);
  a049=(a213*a049);
  a161=(a161+a049);
  a076=(a081*a076);
  a161=(a161+a076);
  a197=(a098*a197);
  a161=(a161+a197);
  a050=(a214*a050);
  a161=(a161+a050);
  a113=(a215*a113);
  a161=(a161+a113);
  a134=(a216*a134);
  a161=(a161+a134);
  a156=(a217*a156);
  a161=(a161+a156);
  a179=(a218*a179);
  a161=(a161+a179);
  a009=(a009+a161);
  a161=(a000*a009);
  a184=(a234*a184);
  a179=(a139*a184);
  a179=(a108+a179);
  a156=(a007*a208);
  a156=(a156*a184);
  a156=(a156-a004);
  a156=(a156+a019);
  a019=(a220*a156);
  a235=(a235-a019);
  a235=(a235/a226);
  a156=(a156/a087);
  a019=(a220*a235);
  a156=(a156-a019);
  a019=(2.*a156);
  a235=(a235-a019);
  a235=(a208*a235);
  a179=(a179+a235);
  a179=(a007*a179);
  a235=(a179/a087);
  a156=(a156*a208);
  a156=(a156-a108);
  a139=(a139*a198);
  a139=(a139*a198);
  a156=(a156+a139);
  a007=(a007*a156);
  a007=(a007-a031);
  a179=(a220*a179);
  a007=(a007-a179);
  a007=(a007/a226);
  a179=(a220*a007);
  a235=(a235-a179);
  a179=(a204*a025);
  a083=(a213*a083);
  a179=(a179+a083);
  a100=(a081*a100);
  a179=(a179+a100);
  a120=(a098*a120);
  a179=(a179+a120);
  a141=(a214*a141);
  a179=(a179+a141);
  a163=(a215*a163);
  a179=(a179+a163);
  a186=(a216*a186);
  a179=(a179+a186);
  a210=(a217*a210);
  a179=(a179+a210);
  a232=(a218*a232);
  a179=(a179+a232);
  a150=(a150+a179);
  a179=(a235*a150);
  a161=(a161+a179);
  a014=(a014*a234);
  a014=(a014*a208);
  a179=(a014/a087);
  a232=(a021*a198);
  a232=(a232*a208);
  a014=(a220*a014);
  a232=(a232-a014);
  a232=(a232/a226);
  a014=(a220*a232);
  a179=(a179-a014);
  a014=(a179*a203);
  a021=(a021*a208);
  a234=(a234-a198);
  a021=(a021*a234);
  a087=(a021/a087);
  a021=(a220*a021);
  a015=(a015+a021);
  a015=(a015/a226);
  a220=(a220*a015);
  a087=(a087+a220);
  a220=(a087*a225);
  a014=(a014+a220);
  a161=(a161+a014);
  a161=(a212*a161);
  a013=(a013+a161);
  a230=(a230+a013);
  if (res[0]!=0) res[0][6]=a230;
  a057=(a001*a057);
  a112=(a005*a112);
  a057=(a057+a112);
  a133=(a102*a133);
  a057=(a057+a133);
  a155=(a122*a155);
  a057=(a057+a155);
  a178=(a143*a178);
  a057=(a057+a178);
  a202=(a165*a202);
  a057=(a057+a202);
  a224=(a188*a224);
  a057=(a057+a224);
  a009=(a172*a009);
  a150=(a007*a150);
  a009=(a009+a150);
  a203=(a232*a203);
  a225=(a015*a225);
  a203=(a203-a225);
  a009=(a009+a203);
  a009=(a212*a009);
  a057=(a057+a009);
  a025=(a025+a057);
  if (res[0]!=0) res[0][7]=a025;
  a025=arg[0]? arg[0][8] : 0;
  a057=arg[0]? arg[0][10] : 0;
  a009=(a001*a057);
  a203=(a016*a025);
  a225=arg[0]? arg[0][9] : 0;
  a150=(a026*a225);
  a203=(a203+a150);
  a150=(a020*a057);
  a224=arg[0]? arg[0][11] : 0;
  a202=(a022*a224);
  a150=(a150+a202);
  a203=(a203+a150);
  a150=(a006*a203);
  a202=(a035*a057);
  a178=(a038*a203);
  a155=(a041*a057);
  a155=(a025+a155);
  a133=(a048*a155);
  a112=(a041*a224);
  a112=(a225+a112);
  a230=(a058*a112);
  a133=(a133+a230);
  a230=(a041*a203);
  a230=(a057+a230);
  a013=(a012*a230);
  a161=(a173*a025);
  a014=(a128*a225);
  a161=(a161+a014);
  a014=(a017*a057);
  a220=(a011*a224);
  a014=(a014-a220);
  a161=(a161+a014);
  a014=(a041*a161);
  a014=(a224+a014);
  a220=(a054*a014);
  a013=(a013+a220);
  a133=(a133+a013);
  a133=(a040*a133);
  a178=(a178+a133);
  a178=(a057+a178);
  a133=(a037*a178);
  a202=(a202+a133);
  a202=(a025+a202);
  a133=(a074*a202);
  a013=(a035*a224);
  a220=(a038*a161);
  a155=(a107*a155);
  a112=(a028*a112);
  a155=(a155+a112);
  a112=(a053*a230);
  a226=(a045*a014);
  a112=(a112-a226);
  a155=(a155+a112);
  a155=(a040*a155);
  a220=(a220+a155);
  a220=(a224+a220);
  a155=(a037*a220);
  a013=(a013+a155);
  a013=(a225+a013);
  a155=(a084*a013);
  a133=(a133+a155);
  a155=(a035*a203);
  a112=(a038*a057);
  a230=(a040*a230);
  a112=(a112+a230);
  a112=(a025+a112);
  a230=(a044*a112);
  a226=(a038*a224);
  a014=(a040*a014);
  a226=(a226+a014);
  a226=(a225+a226);
  a014=(a055*a226);
  a230=(a230+a014);
  a014=(a061*a178);
  a021=(a043*a220);
  a014=(a014+a021);
  a230=(a230+a014);
  a014=(a037*a230);
  a155=(a155+a014);
  a155=(a057+a155);
  a014=(a069*a155);
  a021=(a035*a161);
  a112=(a078*a112);
  a226=(a046*a226);
  a112=(a112+a226);
  a226=(a079*a178);
  a234=(a051*a220);
  a226=(a226-a234);
  a112=(a112+a226);
  a226=(a037*a112);
  a021=(a021+a226);
  a021=(a224+a021);
  a226=(a080*a021);
  a014=(a014+a226);
  a133=(a133+a014);
  a014=(a034*a133);
  a150=(a150+a014);
  a014=(a077*a057);
  a178=(a086*a178);
  a014=(a014+a178);
  a178=(a068*a155);
  a014=(a014+a178);
  a014=(a025+a014);
  a178=(a091*a014);
  a226=(a077*a224);
  a220=(a086*a220);
  a226=(a226+a220);
  a220=(a068*a021);
  a226=(a226+a220);
  a226=(a225+a226);
  a220=(a101*a226);
  a178=(a178+a220);
  a220=(a077*a203);
  a230=(a086*a230);
  a220=(a220+a230);
  a230=(a068*a133);
  a220=(a220+a230);
  a220=(a057+a220);
  a230=(a093*a220);
  a234=(a077*a161);
  a112=(a086*a112);
  a234=(a234+a112);
  a202=(a008*a202);
  a013=(a042*a013);
  a202=(a202+a013);
  a013=(a024*a155);
  a112=(a071*a021);
  a013=(a013-a112);
  a202=(a202+a013);
  a013=(a068*a202);
  a234=(a234+a013);
  a234=(a224+a234);
  a013=(a097*a234);
  a230=(a230+a013);
  a178=(a178+a230);
  a230=(a085*a178);
  a150=(a150+a230);
  a150=(a057+a150);
  a230=(a005*a150);
  a009=(a009+a230);
  a230=(a094*a203);
  a013=(a103*a133);
  a230=(a230+a013);
  a013=(a104*a178);
  a230=(a230+a013);
  a013=(a006*a057);
  a112=(a034*a155);
  a013=(a013+a112);
  a112=(a085*a220);
  a013=(a013+a112);
  a013=(a025+a013);
  a112=(a111*a013);
  a198=(a006*a224);
  a208=(a034*a021);
  a198=(a198+a208);
  a208=(a085*a234);
  a198=(a198+a208);
  a198=(a225+a198);
  a208=(a121*a198);
  a112=(a112+a208);
  a208=(a052*a150);
  a210=(a006*a161);
  a186=(a034*a202);
  a210=(a210+a186);
  a014=(a073*a014);
  a226=(a036*a226);
  a014=(a014+a226);
  a226=(a056*a220);
  a186=(a089*a234);
  a226=(a226-a186);
  a014=(a014+a226);
  a226=(a085*a014);
  a210=(a210+a226);
  a210=(a224+a210);
  a226=(a117*a210);
  a208=(a208+a226);
  a112=(a112+a208);
  a208=(a105*a112);
  a230=(a230+a208);
  a230=(a057+a230);
  a208=(a102*a230);
  a009=(a009+a208);
  a208=(a114*a203);
  a226=(a123*a133);
  a208=(a208+a226);
  a226=(a124*a178);
  a208=(a208+a226);
  a226=(a125*a112);
  a208=(a208+a226);
  a226=(a094*a057);
  a186=(a103*a155);
  a226=(a226+a186);
  a186=(a104*a220);
  a226=(a226+a186);
  a186=(a105*a150);
  a226=(a226+a186);
  a226=(a025+a226);
  a186=(a132*a226);
  a163=(a094*a224);
  a141=(a103*a021);
  a163=(a163+a141);
  a141=(a104*a234);
  a163=(a163+a141);
  a141=(a105*a210);
  a163=(a163+a141);
  a163=(a225+a163);
  a141=(a142*a163);
  a186=(a186+a141);
  a141=(a082*a230);
  a120=(a094*a161);
  a100=(a103*a202);
  a120=(a120+a100);
  a100=(a104*a014);
  a120=(a120+a100);
  a013=(a060*a013);
  a198=(a090*a198);
  a013=(a013+a198);
  a198=(a116*a150);
  a100=(a109*a210);
  a198=(a198-a100);
  a013=(a013+a198);
  a198=(a105*a013);
  a120=(a120+a198);
  a120=(a224+a120);
  a198=(a138*a120);
  a141=(a141+a198);
  a186=(a186+a141);
  a141=(a126*a186);
  a208=(a208+a141);
  a208=(a057+a208);
  a141=(a122*a208);
  a009=(a009+a141);
  a141=(a135*a203);
  a198=(a144*a133);
  a141=(a141+a198);
  a198=(a145*a178);
  a141=(a141+a198);
  a198=(a146*a112);
  a141=(a141+a198);
  a198=(a147*a186);
  a141=(a141+a198);
  a198=(a114*a057);
  a100=(a123*a155);
  a198=(a198+a100);
  a100=(a124*a220);
  a198=(a198+a100);
  a100=(a125*a150);
  a198=(a198+a100);
  a100=(a126*a230);
  a198=(a198+a100);
  a198=(a025+a198);
  a100=(a154*a198);
  a083=(a114*a224);
  a031=(a123*a021);
  a083=(a083+a031);
  a031=(a124*a234);
  a083=(a083+a031);
  a031=(a125*a210);
  a083=(a083+a031);
  a031=(a126*a120);
  a083=(a083+a031);
  a083=(a225+a083);
  a031=(a164*a083);
  a100=(a100+a031);
  a031=(a070*a208);
  a156=(a114*a161);
  a139=(a123*a202);
  a156=(a156+a139);
  a139=(a124*a014);
  a156=(a156+a139);
  a139=(a125*a013);
  a156=(a156+a139);
  a226=(a119*a226);
  a163=(a115*a163);
  a226=(a226+a163);
  a163=(a137*a230);
  a139=(a130*a120);
  a163=(a163-a139);
  a226=(a226+a163);
  a163=(a126*a226);
  a156=(a156+a163);
  a156=(a224+a156);
  a163=(a160*a156);
  a031=(a031+a163);
  a100=(a100+a031);
  a031=(a148*a100);
  a141=(a141+a031);
  a141=(a057+a141);
  a031=(a143*a141);
  a009=(a009+a031);
  a031=(a157*a203);
  a163=(a166*a133);
  a031=(a031+a163);
  a163=(a167*a178);
  a031=(a031+a163);
  a163=(a168*a112);
  a031=(a031+a163);
  a163=(a169*a186);
  a031=(a031+a163);
  a163=(a170*a100);
  a031=(a031+a163);
  a163=(a135*a057);
  a139=(a144*a155);
  a163=(a163+a139);
  a139=(a145*a220);
  a163=(a163+a139);
  a139=(a146*a150);
  a163=(a163+a139);
  a139=(a147*a230);
  a163=(a163+a139);
  a139=(a148*a208);
  a163=(a163+a139);
  a163=(a025+a163);
  a139=(a177*a163);
  a108=(a135*a224);
  a019=(a144*a021);
  a108=(a108+a019);
  a019=(a145*a234);
  a108=(a108+a019);
  a019=(a146*a210);
  a108=(a108+a019);
  a019=(a147*a120);
  a108=(a108+a019);
  a019=(a148*a156);
  a108=(a108+a019);
  a108=(a225+a108);
  a019=(a187*a108);
  a139=(a139+a019);
  a019=(a030*a141);
  a004=(a135*a161);
  a184=(a144*a202);
  a004=(a004+a184);
  a184=(a145*a014);
  a004=(a004+a184);
  a184=(a146*a013);
  a004=(a004+a184);
  a184=(a147*a226);
  a004=(a004+a184);
  a198=(a140*a198);
  a083=(a136*a083);
  a198=(a198+a083);
  a083=(a159*a208);
  a184=(a152*a156);
  a083=(a083-a184);
  a198=(a198+a083);
  a083=(a148*a198);
  a004=(a004+a083);
  a004=(a224+a004);
  a083=(a183*a004);
  a019=(a019+a083);
  a139=(a139+a019);
  a019=(a171*a139);
  a031=(a031+a019);
  a031=(a057+a031);
  a019=(a165*a031);
  a009=(a009+a019);
  a019=(a180*a203);
  a083=(a189*a133);
  a019=(a019+a083);
  a083=(a190*a178);
  a019=(a019+a083);
  a083=(a191*a112);
  a019=(a019+a083);
  a083=(a192*a186);
  a019=(a019+a083);
  a083=(a193*a100);
  a019=(a019+a083);
  a083=(a194*a139);
  a019=(a019+a083);
  a083=(a157*a057);
  a184=(a166*a155);
  a083=(a083+a184);
  a184=(a167*a220);
  a083=(a083+a184);
  a184=(a168*a150);
  a083=(a083+a184);
  a184=(a169*a230);
  a083=(a083+a184);
  a184=(a170*a208);
  a083=(a083+a184);
  a184=(a171*a141);
  a083=(a083+a184);
  a083=(a025+a083);
  a184=(a201*a083);
  a134=(a157*a224);
  a113=(a166*a021);
  a134=(a134+a113);
  a113=(a167*a234);
  a134=(a134+a113);
  a113=(a168*a210);
  a134=(a134+a113);
  a113=(a169*a120);
  a134=(a134+a113);
  a113=(a170*a156);
  a134=(a134+a113);
  a113=(a171*a004);
  a134=(a134+a113);
  a134=(a225+a134);
  a113=(a211*a134);
  a184=(a184+a113);
  a113=(a088*a031);
  a050=(a157*a161);
  a197=(a166*a202);
  a050=(a050+a197);
  a197=(a167*a014);
  a050=(a050+a197);
  a197=(a168*a013);
  a050=(a050+a197);
  a197=(a169*a226);
  a050=(a050+a197);
  a197=(a170*a198);
  a050=(a050+a197);
  a163=(a162*a163);
  a108=(a158*a108);
  a163=(a163+a108);
  a108=(a182*a141);
  a197=(a175*a004);
  a108=(a108-a197);
  a163=(a163+a108);
  a108=(a171*a163);
  a050=(a050+a108);
  a050=(a224+a050);
  a108=(a207*a050);
  a113=(a113+a108);
  a184=(a184+a113);
  a113=(a195*a184);
  a019=(a019+a113);
  a019=(a057+a019);
  a113=(a188*a019);
  a009=(a009+a113);
  a113=(a204*a203);
  a133=(a213*a133);
  a113=(a113+a133);
  a178=(a081*a178);
  a113=(a113+a178);
  a178=(a098*a112);
  a113=(a113+a178);
  a178=(a214*a186);
  a113=(a113+a178);
  a178=(a215*a100);
  a113=(a113+a178);
  a178=(a216*a139);
  a113=(a113+a178);
  a178=(a217*a184);
  a113=(a113+a178);
  a178=(a180*a057);
  a133=(a189*a155);
  a178=(a178+a133);
  a133=(a190*a220);
  a178=(a178+a133);
  a133=(a191*a150);
  a178=(a178+a133);
  a133=(a192*a230);
  a178=(a178+a133);
  a133=(a193*a208);
  a178=(a178+a133);
  a133=(a194*a141);
  a178=(a178+a133);
  a133=(a195*a031);
  a178=(a178+a133);
  a178=(a025+a178);
  a133=(a223*a178);
  a108=(a180*a224);
  a197=(a189*a021);
  a108=(a108+a197);
  a197=(a190*a234);
  a108=(a108+a197);
  a197=(a191*a210);
  a108=(a108+a197);
  a197=(a192*a120);
  a108=(a108+a197);
  a197=(a193*a156);
  a108=(a108+a197);
  a197=(a194*a004);
  a108=(a108+a197);
  a197=(a195*a050);
  a108=(a108+a197);
  a108=(a225+a108);
  a197=(a233*a108);
  a133=(a133+a197);
  a197=(a003*a019);
  a076=(a180*a161);
  a049=(a189*a202);
  a076=(a076+a049);
  a049=(a190*a014);
  a076=(a076+a049);
  a049=(a191*a013);
  a076=(a076+a049);
  a049=(a192*a226);
  a076=(a076+a049);
  a049=(a193*a198);
  a076=(a076+a049);
  a049=(a194*a163);
  a076=(a076+a049);
  a083=(a185*a083);
  a134=(a181*a134);
  a083=(a083+a134);
  a134=(a206*a031);
  a049=(a199*a050);
  a134=(a134-a049);
  a083=(a083+a134);
  a134=(a195*a083);
  a076=(a076+a134);
  a076=(a224+a076);
  a134=(a229*a076);
  a197=(a197+a134);
  a133=(a133+a197);
  a197=(a218*a133);
  a113=(a113+a197);
  a113=(a057+a113);
  a197=(a212*a113);
  a009=(a009+a197);
  a009=(a025+a009);
  if (res[0]!=0) res[0][8]=a009;
  a009=(a001*a224);
  a197=(a005*a210);
  a009=(a009+a197);
  a197=(a102*a120);
  a009=(a009+a197);
  a197=(a122*a156);
  a009=(a009+a197);
  a197=(a143*a004);
  a009=(a009+a197);
  a197=(a165*a050);
  a009=(a009+a197);
  a197=(a188*a076);
  a009=(a009+a197);
  a197=(a204*a161);
  a202=(a213*a202);
  a197=(a197+a202);
  a014=(a081*a014);
  a197=(a197+a014);
  a014=(a098*a013);
  a197=(a197+a014);
  a014=(a214*a226);
  a197=(a197+a014);
  a014=(a215*a198);
  a197=(a197+a014);
  a014=(a216*a163);
  a197=(a197+a014);
  a014=(a217*a083);
  a197=(a197+a014);
  a178=(a023*a178);
  a108=(a196*a108);
  a178=(a178+a108);
  a108=(a228*a019);
  a014=(a221*a076);
  a108=(a108-a014);
  a178=(a178+a108);
  a108=(a218*a178);
  a197=(a197+a108);
  a197=(a224+a197);
  a108=(a212*a197);
  a009=(a009+a108);
  a009=(a225+a009);
  if (res[0]!=0) res[0][9]=a009;
  a203=(a001*a203);
  a112=(a005*a112);
  a203=(a203+a112);
  a186=(a102*a186);
  a203=(a203+a186);
  a100=(a122*a100);
  a203=(a203+a100);
  a139=(a143*a139);
  a203=(a203+a139);
  a184=(a165*a184);
  a203=(a203+a184);
  a133=(a188*a133);
  a203=(a203+a133);
  a133=(a204*a057);
  a155=(a213*a155);
  a133=(a133+a155);
  a220=(a081*a220);
  a133=(a133+a220);
  a150=(a098*a150);
  a133=(a133+a150);
  a230=(a214*a230);
  a133=(a133+a230);
  a208=(a215*a208);
  a133=(a133+a208);
  a141=(a216*a141);
  a133=(a133+a141);
  a031=(a217*a031);
  a133=(a133+a031);
  a019=(a218*a019);
  a133=(a133+a019);
  a025=(a025+a133);
  a133=(a000*a025);
  a019=(a204*a224);
  a021=(a213*a021);
  a019=(a019+a021);
  a234=(a081*a234);
  a019=(a019+a234);
  a210=(a098*a210);
  a019=(a019+a210);
  a120=(a214*a120);
  a019=(a019+a120);
  a156=(a215*a156);
  a019=(a019+a156);
  a004=(a216*a004);
  a019=(a019+a004);
  a050=(a217*a050);
  a019=(a019+a050);
  a076=(a218*a076);
  a019=(a019+a076);
  a225=(a225+a019);
  a019=(a235*a225);
  a133=(a133+a019);
  a019=(a179*a113);
  a076=(a087*a197);
  a019=(a019+a076);
  a133=(a133+a019);
  a133=(a212*a133);
  a203=(a203+a133);
  a057=(a057+a203);
  if (res[0]!=0) res[0][10]=a057;
  a161=(a001*a161);
  a013=(a005*a013);
  a161=(a161+a013);
  a226=(a102*a226);
  a161=(a161+a226);
  a198=(a122*a198);
  a161=(a161+a198);
  a163=(a143*a163);
  a161=(a161+a163);
  a083=(a165*a083);
  a161=(a161+a083);
  a178=(a188*a178);
  a161=(a161+a178);
  a025=(a172*a025);
  a225=(a007*a225);
  a025=(a025+a225);
  a113=(a232*a113);
  a197=(a015*a197);
  a113=(a113-a197);
  a025=(a025+a113);
  a025=(a212*a025);
  a161=(a161+a025);
  a224=(a224+a161);
  if (res[0]!=0) res[0][11]=a224;
  a224=arg[0]? arg[0][12] : 0;
  a161=arg[0]? arg[0][14] : 0;
  a025=(a001*a161);
  a016=(a016*a224);
  a113=arg[0]? arg[0][13] : 0;
  a026=(a026*a113);
  a016=(a016+a026);
  a020=(a020*a161);
  a026=arg[0]? arg[0][15] : 0;
  a022=(a022*a026);
  a020=(a020+a022);
  a016=(a016+a020);
  a020=(a006*a016);
  a022=(a035*a161);
  a197=(a038*a016);
  a225=(a041*a161);
  a225=(a224+a225);
  a048=(a048*a225);
  a178=(a041*a026);
  a178=(a113+a178);
  a058=(a058*a178);
  a048=(a048+a058);
  a058=(a041*a016);
  a058=(a161+a058);
  a012=(a012*a058);
  a173=(a173*a224);
  a128=(a128*a113);
  a173=(a173+a128);
  a017=(a017*a161);
  a011=(a011*a026);
  a017=(a017-a011);
  a173=(a173+a017);
  a041=(a041*a173);
  a041=(a026+a041);
  a054=(a054*a041);
  a012=(a012+a054);
  a048=(a048+a012);
  a048=(a040*a048);
  a197=(a197+a048);
  a197=(a161+a197);
  a048=(a037*a197);
  a022=(a022+a048);
  a022=(a224+a022);
  a074=(a074*a022);
  a048=(a035*a026);
  a012=(a038*a173);
  a107=(a107*a225);
  a028=(a028*a178);
  a107=(a107+a028);
  a053=(a053*a058);
  a045=(a045*a041);
  a053=(a053-a045);
  a107=(a107+a053);
  a107=(a040*a107);
  a012=(a012+a107);
  a012=(a026+a012);
  a107=(a037*a012);
  a048=(a048+a107);
  a048=(a113+a048);
  a084=(a084*a048);
  a074=(a074+a084);
  a084=(a035*a016);
  a107=(a038*a161);
  a058=(a040*a058);
  a107=(a107+a058);
  a107=(a224+a107);
  a044=(a044*a107);
  a038=(a038*a026);
  a040=(a040*a041);
  a038=(a038+a040);
  a038=(a113+a038);
  a055=(a055*a038);
  a044=(a044+a055);
  a061=(a061*a197);
  a043=(a043*a012);
  a061=(a061+a043);
  a044=(a044+a061);
  a061=(a037*a044);
  a084=(a084+a061);
  a084=(a161+a084);
  a069=(a069*a084);
  a035=(a035*a173);
  a078=(a078*a107);
  a046=(a046*a038);
  a078=(a078+a046);
  a079=(a079*a197);
  a051=(a051*a012);
  a079=(a079-a051);
  a078=(a078+a079);
  a037=(a037*a078);
  a035=(a035+a037);
  a035=(a026+a035);
  a080=(a080*a035);
  a069=(a069+a080);
  a074=(a074+a069);
  a069=(a034*a074);
  a020=(a020+a069);
  a069=(a077*a161);
  a197=(a086*a197);
  a069=(a069+a197);
  a197=(a068*a084);
  a069=(a069+a197);
  a069=(a224+a069);
  a091=(a091*a069);
  a197=(a077*a026);
  a012=(a086*a012);
  a197=(a197+a012);
  a012=(a068*a035);
  a197=(a197+a012);
  a197=(a113+a197);
  a101=(a101*a197);
  a091=(a091+a101);
  a101=(a077*a016);
  a044=(a086*a044);
  a101=(a101+a044);
  a044=(a068*a074);
  a101=(a101+a044);
  a101=(a161+a101);
  a093=(a093*a101);
  a077=(a077*a173);
  a086=(a086*a078);
  a077=(a077+a086);
  a008=(a008*a022);
  a042=(a042*a048);
  a008=(a008+a042);
  a024=(a024*a084);
  a071=(a071*a035);
  a024=(a024-a071);
  a008=(a008+a024);
  a068=(a068*a008);
  a077=(a077+a068);
  a077=(a026+a077);
  a097=(a097*a077);
  a093=(a093+a097);
  a091=(a091+a093);
  a093=(a085*a091);
  a020=(a020+a093);
  a020=(a161+a020);
  a093=(a005*a020);
  a025=(a025+a093);
  a093=(a094*a016);
  a097=(a103*a074);
  a093=(a093+a097);
  a097=(a104*a091);
  a093=(a093+a097);
  a097=(a006*a161);
  a068=(a034*a084);
  a097=(a097+a068);
  a068=(a085*a101);
  a097=(a097+a068);
  a097=(a224+a097);
  a111=(a111*a097);
  a068=(a006*a026);
  a024=(a034*a035);
  a068=(a068+a024);
  a024=(a085*a077);
  a068=(a068+a024);
  a068=(a113+a068);
  a121=(a121*a068);
  a111=(a111+a121);
  a052=(a052*a020);
  a006=(a006*a173);
  a034=(a034*a008);
  a006=(a006+a034);
  a073=(a073*a069);
  a036=(a036*a197);
  a073=(a073+a036);
  a056=(a056*a101);
  a089=(a089*a077);
  a056=(a056-a089);
  a073=(a073+a056);
  a085=(a085*a073);
  a006=(a006+a085);
  a006=(a026+a006);
  a117=(a117*a006);
  a052=(a052+a117);
  a111=(a111+a052);
  a052=(a105*a111);
  a093=(a093+a052);
  a093=(a161+a093);
  a052=(a102*a093);
  a025=(a025+a052);
  a052=(a114*a016);
  a117=(a123*a074);
  a052=(a052+a117);
  a117=(a124*a091);
  a052=(a052+a117);
  a117=(a125*a111);
  a052=(a052+a117);
  a117=(a094*a161);
  a085=(a103*a084);
  a117=(a117+a085);
  a085=(a104*a101);
  a117=(a117+a085);
  a085=(a105*a020);
  a117=(a117+a085);
  a117=(a224+a117);
  a132=(a132*a117);
  a085=(a094*a026);
  a056=(a103*a035);
  a085=(a085+a056);
  a056=(a104*a077);
  a085=(a085+a056);
  a056=(a105*a006);
  a085=(a085+a056);
  a085=(a113+a085);
  a142=(a142*a085);
  a132=(a132+a142);
  a082=(a082*a093);
  a094=(a094*a173);
  a103=(a103*a008);
  a094=(a094+a103);
  a104=(a104*a073);
  a094=(a094+a104);
  a060=(a060*a097);
  a090=(a090*a068);
  a060=(a060+a090);
  a116=(a116*a020);
  a109=(a109*a006);
  a116=(a116-a109);
  a060=(a060+a116);
  a105=(a105*a060);
  a094=(a094+a105);
  a094=(a026+a094);
  a138=(a138*a094);
  a082=(a082+a138);
  a132=(a132+a082);
  a082=(a126*a132);
  a052=(a052+a082);
  a052=(a161+a052);
  a082=(a122*a052);
  a025=(a025+a082);
  a082=(a135*a016);
  a138=(a144*a074);
  a082=(a082+a138);
  a138=(a145*a091);
  a082=(a082+a138);
  a138=(a146*a111);
  a082=(a082+a138);
  a138=(a147*a132);
  a082=(a082+a138);
  a138=(a114*a161);
  a105=(a123*a084);
  a138=(a138+a105);
  a105=(a124*a101);
  a138=(a138+a105);
  a105=(a125*a020);
  a138=(a138+a105);
  a105=(a126*a093);
  a138=(a138+a105);
  a138=(a224+a138);
  a154=(a154*a138);
  a105=(a114*a026);
  a116=(a123*a035);
  a105=(a105+a116);
  a116=(a124*a077);
  a105=(a105+a116);
  a116=(a125*a006);
  a105=(a105+a116);
  a116=(a126*a094);
  a105=(a105+a116);
  a105=(a113+a105);
  a164=(a164*a105);
  a154=(a154+a164);
  a070=(a070*a052);
  a114=(a114*a173);
  a123=(a123*a008);
  a114=(a114+a123);
  a124=(a124*a073);
  a114=(a114+a124);
  a125=(a125*a060);
  a114=(a114+a125);
  a119=(a119*a117);
  a115=(a115*a085);
  a119=(a119+a115);
  a137=(a137*a093);
  a130=(a130*a094);
  a137=(a137-a130);
  a119=(a119+a137);
  a126=(a126*a119);
  a114=(a114+a126);
  a114=(a026+a114);
  a160=(a160*a114);
  a070=(a070+a160);
  a154=(a154+a070);
  a070=(a148*a154);
  a082=(a082+a070);
  a082=(a161+a082);
  a070=(a143*a082);
  a025=(a025+a070);
  a070=(a157*a016);
  a160=(a166*a074);
  a070=(a070+a160);
  a160=(a167*a091);
  a070=(a070+a160);
  a160=(a168*a111);
  a070=(a070+a160);
  a160=(a169*a132);
  a070=(a070+a160);
  a160=(a170*a154);
  a070=(a070+a160);
  a160=(a135*a161);
  a126=(a144*a084);
  a160=(a160+a126);
  a126=(a145*a101);
  a160=(a160+a126);
  a126=(a146*a020);
  a160=(a160+a126);
  a126=(a147*a093);
  a160=(a160+a126);
  a126=(a148*a052);
  a160=(a160+a126);
  a160=(a224+a160);
  a177=(a177*a160);
  a126=(a135*a026);
  a137=(a144*a035);
  a126=(a126+a137);
  a137=(a145*a077);
  a126=(a126+a137);
  a137=(a146*a006);
  a126=(a126+a137);
  a137=(a147*a094);
  a126=(a126+a137);
  a137=(a148*a114);
  a126=(a126+a137);
  a126=(a113+a126);
  a187=(a187*a126);
  a177=(a177+a187);
  a030=(a030*a082);
  a135=(a135*a173);
  a144=(a144*a008);
  a135=(a135+a144);
  a145=(a145*a073);
  a135=(a135+a145);
  a146=(a146*a060);
  a135=(a135+a146);
  a147=(a147*a119);
  a135=(a135+a147);
  a140=(a140*a138);
  a136=(a136*a105);
  a140=(a140+a136);
  a159=(a159*a052);
  a152=(a152*a114);
  a159=(a159-a152);
  a140=(a140+a159);
  a148=(a148*a140);
  a135=(a135+a148);
  a135=(a026+a135);
  a183=(a183*a135);
  a030=(a030+a183);
  a177=(a177+a030);
  a030=(a171*a177);
  a070=(a070+a030);
  a070=(a161+a070);
  a030=(a165*a070);
  a025=(a025+a030);
  a030=(a180*a016);
  a183=(a189*a074);
  a030=(a030+a183);
  a183=(a190*a091);
  a030=(a030+a183);
  a183=(a191*a111);
  a030=(a030+a183);
  a183=(a192*a132);
  a030=(a030+a183);
  a183=(a193*a154);
  a030=(a030+a183);
  a183=(a194*a177);
  a030=(a030+a183);
  a183=(a157*a161);
  a148=(a166*a084);
  a183=(a183+a148);
  a148=(a167*a101);
  a183=(a183+a148);
  a148=(a168*a020);
  a183=(a183+a148);
  a148=(a169*a093);
  a183=(a183+a148);
  a148=(a170*a052);
  a183=(a183+a148);
  a148=(a171*a082);
  a183=(a183+a148);
  a183=(a224+a183);
  a201=(a201*a183);
  a148=(a157*a026);
  a159=(a166*a035);
  a148=(a148+a159);
  a159=(a167*a077);
  a148=(a148+a159);
  a159=(a168*a006);
  a148=(a148+a159);
  a159=(a169*a094);
  a148=(a148+a159);
  a159=(a170*a114);
  a148=(a148+a159);
  a159=(a171*a135);
  a148=(a148+a159);
  a148=(a113+a148);
  a211=(a211*a148);
  a201=(a201+a211);
  a088=(a088*a070);
  a157=(a157*a173);
  a166=(a166*a008);
  a157=(a157+a166);
  a167=(a167*a073);
  a157=(a157+a167);
  a168=(a168*a060);
  a157=(a157+a168);
  a169=(a169*a119);
  a157=(a157+a169);
  a170=(a170*a140);
  a157=(a157+a170);
  a162=(a162*a160);
  a158=(a158*a126);
  a162=(a162+a158);
  a182=(a182*a082);
  a175=(a175*a135);
  a182=(a182-a175);
  a162=(a162+a182);
  a171=(a171*a162);
  a157=(a157+a171);
  a157=(a026+a157);
  a207=(a207*a157);
  a088=(a088+a207);
  a201=(a201+a088);
  a088=(a195*a201);
  a030=(a030+a088);
  a030=(a161+a030);
  a088=(a188*a030);
  a025=(a025+a088);
  a088=(a204*a016);
  a074=(a213*a074);
  a088=(a088+a074);
  a091=(a081*a091);
  a088=(a088+a091);
  a091=(a098*a111);
  a088=(a088+a091);
  a091=(a214*a132);
  a088=(a088+a091);
  a091=(a215*a154);
  a088=(a088+a091);
  a091=(a216*a177);
  a088=(a088+a091);
  a091=(a217*a201);
  a088=(a088+a091);
  a091=(a180*a161);
  a074=(a189*a084);
  a091=(a091+a074);
  a074=(a190*a101);
  a091=(a091+a074);
  a074=(a191*a020);
  a091=(a091+a074);
  a074=(a192*a093);
  a091=(a091+a074);
  a074=(a193*a052);
  a091=(a091+a074);
  a074=(a194*a082);
  a091=(a091+a074);
  a074=(a195*a070);
  a091=(a091+a074);
  a091=(a224+a091);
  a223=(a223*a091);
  a074=(a180*a026);
  a207=(a189*a035);
  a074=(a074+a207);
  a207=(a190*a077);
  a074=(a074+a207);
  a207=(a191*a006);
  a074=(a074+a207);
  a207=(a192*a094);
  a074=(a074+a207);
  a207=(a193*a114);
  a074=(a074+a207);
  a207=(a194*a135);
  a074=(a074+a207);
  a207=(a195*a157);
  a074=(a074+a207);
  a074=(a113+a074);
  a233=(a233*a074);
  a223=(a223+a233);
  a003=(a003*a030);
  a180=(a180*a173);
  a189=(a189*a008);
  a180=(a180+a189);
  a190=(a190*a073);
  a180=(a180+a190);
  a191=(a191*a060);
  a180=(a180+a191);
  a192=(a192*a119);
  a180=(a180+a192);
  a193=(a193*a140);
  a180=(a180+a193);
  a194=(a194*a162);
  a180=(a180+a194);
  a185=(a185*a183);
  a181=(a181*a148);
  a185=(a185+a181);
  a206=(a206*a070);
  a199=(a199*a157);
  a206=(a206-a199);
  a185=(a185+a206);
  a195=(a195*a185);
  a180=(a180+a195);
  a180=(a026+a180);
  a229=(a229*a180);
  a003=(a003+a229);
  a223=(a223+a003);
  a003=(a218*a223);
  a088=(a088+a003);
  a088=(a161+a088);
  a003=(a212*a088);
  a025=(a025+a003);
  a025=(a224+a025);
  if (res[0]!=0) res[0][12]=a025;
  a025=(a001*a026);
  a003=(a005*a006);
  a025=(a025+a003);
  a003=(a102*a094);
  a025=(a025+a003);
  a003=(a122*a114);
  a025=(a025+a003);
  a003=(a143*a135);
  a025=(a025+a003);
  a003=(a165*a157);
  a025=(a025+a003);
  a003=(a188*a180);
  a025=(a025+a003);
  a003=(a204*a173);
  a008=(a213*a008);
  a003=(a003+a008);
  a073=(a081*a073);
  a003=(a003+a073);
  a073=(a098*a060);
  a003=(a003+a073);
  a073=(a214*a119);
  a003=(a003+a073);
  a073=(a215*a140);
  a003=(a003+a073);
  a073=(a216*a162);
  a003=(a003+a073);
  a073=(a217*a185);
  a003=(a003+a073);
  a023=(a023*a091);
  a196=(a196*a074);
  a023=(a023+a196);
  a228=(a228*a030);
  a221=(a221*a180);
  a228=(a228-a221);
  a023=(a023+a228);
  a228=(a218*a023);
  a003=(a003+a228);
  a003=(a026+a003);
  a228=(a212*a003);
  a025=(a025+a228);
  a025=(a113+a025);
  if (res[0]!=0) res[0][13]=a025;
  a016=(a001*a016);
  a111=(a005*a111);
  a016=(a016+a111);
  a132=(a102*a132);
  a016=(a016+a132);
  a154=(a122*a154);
  a016=(a016+a154);
  a177=(a143*a177);
  a016=(a016+a177);
  a201=(a165*a201);
  a016=(a016+a201);
  a223=(a188*a223);
  a016=(a016+a223);
  a223=(a204*a161);
  a084=(a213*a084);
  a223=(a223+a084);
  a101=(a081*a101);
  a223=(a223+a101);
  a020=(a098*a020);
  a223=(a223+a020);
  a093=(a214*a093);
  a223=(a223+a093);
  a052=(a215*a052);
  a223=(a223+a052);
  a082=(a216*a082);
  a223=(a223+a082);
  a070=(a217*a070);
  a223=(a223+a070);
  a030=(a218*a030);
  a223=(a223+a030);
  a224=(a224+a223);
  a000=(a000*a224);
  a204=(a204*a026);
  a213=(a213*a035);
  a204=(a204+a213);
  a081=(a081*a077);
  a204=(a204+a081);
  a098=(a098*a006);
  a204=(a204+a098);
  a214=(a214*a094);
  a204=(a204+a214);
  a215=(a215*a114);
  a204=(a204+a215);
  a216=(a216*a135);
  a204=(a204+a216);
  a217=(a217*a157);
  a204=(a204+a217);
  a218=(a218*a180);
  a204=(a204+a218);
  a113=(a113+a204);
  a235=(a235*a113);
  a000=(a000+a235);
  a179=(a179*a088);
  a087=(a087*a003);
  a179=(a179+a087);
  a000=(a000+a179);
  a000=(a212*a000);
  a016=(a016+a000);
  a161=(a161+a016);
  if (res[0]!=0) res[0][14]=a161;
  a001=(a001*a173);
  a005=(a005*a060);
  a001=(a001+a005);
  a102=(a102*a119);
  a001=(a001+a102);
  a122=(a122*a140);
  a001=(a001+a122);
  a143=(a143*a162);
  a001=(a001+a143);
  a165=(a165*a185);
  a001=(a001+a165);
  a188=(a188*a023);
  a001=(a001+a188);
  a172=(a172*a224);
  a007=(a007*a113);
  a172=(a172+a007);
  a232=(a232*a088);
  a015=(a015*a003);
  a232=(a232-a015);
  a172=(a172+a232);
  a212=(a212*a172);
  a001=(a001+a212);
  a026=(a026+a001);
  if (res[0]!=0) res[0][15]=a026;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[6])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+239, w1, *w2=w+255, *w3=w+261, w5, *w6=w+263, w7;
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
  a23=(a13-a02);
  a17=sin(a23);
  a21=(a05*a17);
  a01=(a01-a21);
  a21=sin(a13);
  a09=(a05+a03);
  a21=(a21*a09);
  a01=(a01+a21);
  a07=(a01/a07);
  a21=casadi_sq(a15);
  a21=(a21*a16);
  a21=(a21+a17);
  a05=(a05*a21);
  a21=arg[3]? arg[3][3] : 0;
  a17=arg[3]? arg[3][5] : 0;
  a16=arg[3]? arg[3][0] : 0;
  a09=(a17*a16);
  a22=arg[2]? arg[2][0] : 0;
  a16=(a16*a22);
  a22=sin(a16);
  a09=(a09*a22);
  a09=(a00+a09);
  a21=(a21*a09);
  a09=arg[3]? arg[3][2] : 0;
  a22=arg[3]? arg[3][4] : 0;
  a16=cos(a16);
  a16=(a16+a03);
  a17=(a17*a16);
  a22=(a22-a17);
  a22=(a22+a02);
  a09=(a09*a22);
  a21=(a21+a09);
  a05=(a05-a21);
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
  a23=(a23-a14);
  if (res[1]!=0) res[1][0]=a23;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+2, *rr, *w0=w+394, *w1=w+410, *w2=w+414, *w3=w+420, *w4=w+436;
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
  casadi_real **res1=res+1, *w0=w+504, *w1=w+508, *w2=w+514;
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
  casadi_real a72, a73, a74, a75;
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
  a15=(a07*a14);
  a09=(a09-a15);
  a15=1.;
  a16=(a07+a15);
  a12=(a12*a16);
  a09=(a09+a12);
  a12=(2.*a07);
  a17=(a15-a13);
  a17=(a12*a17);
  a17=(a17+a15);
  a18=(a09/a17);
  a13=(a13-a15);
  a13=(a07*a13);
  a17=(a13/a17);
  a19=casadi_sq(a03);
  a19=(a19*a11);
  a19=(a19+a14);
  a19=(a07*a19);
  a14=arg[4]? arg[4][3] : 0;
  a11=arg[4]? arg[4][5] : 0;
  a20=arg[4]? arg[4][0] : 0;
  a20=(a11*a20);
  a21=arg[1]? arg[1][1] : 0;
  a22=(a20*a21);
  a22=(a08+a22);
  a22=(a14*a22);
  a23=arg[4]? arg[4][2] : 0;
  a24=arg[4]? arg[4][4] : 0;
  a25=arg[1]? arg[1][0] : 0;
  a26=(a25+a15);
  a26=(a11*a26);
  a26=(a24-a26);
  a26=(a26+a10);
  a26=(a23*a26);
  a22=(a22+a26);
  a19=(a19-a22);
  a09=(a17*a09);
  a19=(a19-a09);
  a13=(a13*a17);
  a13=(a07-a13);
  a19=(a19/a13);
  a17=(a17*a19);
  a18=(a18-a17);
  a17=(a06*a18);
  a13=1.7082860872947386e-01;
  a13=(a13*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a22=(a09*a19);
  a26=8.8762756430420545e-02;
  a26=(a26*a02);
  a27=1.9725056984537900e-02;
  a27=(a27*a02);
  a28=(a27*a18);
  a29=5.9175170953613701e-02;
  a29=(a29*a02);
  a30=5.2600151958767730e-02;
  a30=(a30*a02);
  a31=(a30*a19);
  a31=(a08+a31);
  a32=(a07*a31);
  a33=(a30*a08);
  a33=(a10+a33);
  a34=sin(a33);
  a32=(a32*a34);
  a35=(a30*a18);
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
  a30=(a07*a38);
  a32=(a32-a30);
  a36=(a36*a16);
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
  a34=(a21*a38);
  a40=arg[2]? arg[2][3] : 0;
  a41=(a25*a40);
  a34=(a34+a41);
  a34=(a20*a34);
  a34=(a31+a34);
  a34=(a14*a34);
  a38=(a25*a38);
  a40=(a21*a40);
  a38=(a38-a40);
  a38=(a38+a15);
  a38=(a11*a38);
  a38=(a24-a38);
  a38=(a38+a33);
  a38=(a23*a38);
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
  a27=(a27*a19);
  a29=(a29*a39);
  a27=(a27+a29);
  a27=(a08+a27);
  a29=arg[2]? arg[2][4] : 0;
  a39=(a21*a29);
  a37=arg[2]? arg[2][5] : 0;
  a38=(a25*a37);
  a39=(a39+a38);
  a39=(a20*a39);
  a39=(a27+a39);
  a39=(a14*a39);
  a29=(a25*a29);
  a37=(a21*a37);
  a29=(a29-a37);
  a29=(a29+a15);
  a29=(a11*a29);
  a29=(a24-a29);
  a29=(a29+a36);
  a29=(a23*a29);
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
  a34=(a07*a34);
  a36=(a36-a34);
  a35=(a35*a16);
  a36=(a36+a35);
  a35=(a29*a36);
  a30=(a30-a35);
  a39=(a39*a29);
  a39=(a07-a39);
  a30=(a30/a39);
  a39=(a26*a30);
  a22=(a22+a39);
  a22=(a08+a22);
  a39=(a07*a22);
  a35=(a09*a08);
  a34=(a26*a27);
  a35=(a35+a34);
  a35=(a10+a35);
  a34=sin(a35);
  a39=(a39*a34);
  a31=(a09*a18);
  a36=(a36/a32);
  a29=(a29*a30);
  a36=(a36-a29);
  a29=(a26*a36);
  a31=(a31+a29);
  a31=(a03+a31);
  a29=(2.*a31);
  a29=(a22-a29);
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
  a09=(a07*a32);
  a39=(a39-a09);
  a26=(a26*a16);
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
  a34=(a21*a32);
  a38=arg[2]? arg[2][7] : 0;
  a33=(a25*a38);
  a34=(a34+a33);
  a34=(a20*a34);
  a34=(a22+a34);
  a34=(a14*a34);
  a32=(a25*a32);
  a38=(a21*a38);
  a32=(a32-a38);
  a32=(a32+a15);
  a32=(a11*a32);
  a32=(a24-a32);
  a32=(a32+a35);
  a32=(a23*a32);
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
  a17=(a17+a26);
  a26=1.2546768756682242e-01;
  a26=(a26*a02);
  a29=2.4136513415926669e-01;
  a29=(a29*a02);
  a39=(a29*a19);
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
  a27=(a30*a22);
  a35=(a35+a27);
  a35=(a10+a35);
  a27=sin(a35);
  a32=(a32*a27);
  a38=(a29*a18);
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
  a29=(a07*a28);
  a32=(a32-a29);
  a30=(a30*a16);
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
  a27=(a21*a28);
  a33=arg[2]? arg[2][9] : 0;
  a40=(a25*a33);
  a27=(a27+a40);
  a27=(a20*a27);
  a27=(a39+a27);
  a27=(a14*a27);
  a28=(a25*a28);
  a33=(a21*a33);
  a28=(a28-a33);
  a28=(a28+a15);
  a28=(a11*a28);
  a28=(a24-a28);
  a28=(a28+a35);
  a28=(a23*a28);
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
  a17=(a17+a30);
  a17=(a03+a17);
  a30=(a05*a17);
  a04=(a04+a30);
  a30=1.8915178993145003e+00;
  a30=(a30*a02);
  a34=3.7109375000000000e-02;
  a34=(a34*a02);
  a32=(a34*a18);
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
  a33=(a06*a19);
  a40=(a13*a37);
  a33=(a33+a40);
  a40=(a26*a36);
  a33=(a33+a40);
  a33=(a08+a33);
  a40=(a07*a33);
  a41=(a06*a08);
  a42=(a13*a22);
  a41=(a41+a42);
  a42=(a26*a39);
  a41=(a41+a42);
  a41=(a10+a41);
  a42=sin(a41);
  a40=(a40*a42);
  a43=(2.*a17);
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
  a06=(a07*a43);
  a40=(a40-a06);
  a26=(a26*a16);
  a40=(a40+a26);
  a26=(a15-a13);
  a26=(a12*a26);
  a26=(a26+a15);
  a06=(a40/a26);
  a13=(a13-a15);
  a13=(a07*a13);
  a26=(a13/a26);
  a44=casadi_sq(a17);
  a44=(a44*a42);
  a44=(a44+a43);
  a44=(a07*a44);
  a43=arg[2]? arg[2][10] : 0;
  a42=(a21*a43);
  a45=arg[2]? arg[2][11] : 0;
  a46=(a25*a45);
  a42=(a42+a46);
  a42=(a20*a42);
  a42=(a33+a42);
  a42=(a14*a42);
  a43=(a25*a43);
  a45=(a21*a45);
  a43=(a43-a45);
  a43=(a43+a15);
  a43=(a11*a43);
  a43=(a24-a43);
  a43=(a43+a41);
  a43=(a23*a43);
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
  a40=(a13*a18);
  a42=1.7038392571223998e-01;
  a42=(a42*a02);
  a43=(a42*a09);
  a40=(a40+a43);
  a43=1.0726203044637328e-01;
  a43=(a43*a02);
  a41=(a43*a29);
  a40=(a40+a41);
  a41=-1.5319437748624402e-02;
  a41=(a41*a02);
  a45=(a41*a06);
  a40=(a40+a45);
  a45=8.2737891638140233e-03;
  a45=(a45*a02);
  a46=(a34*a19);
  a47=(a27*a37);
  a46=(a46+a47);
  a47=(a28*a36);
  a46=(a46+a47);
  a47=(a35*a44);
  a46=(a46+a47);
  a46=(a08+a46);
  a47=(a07*a46);
  a48=(a34*a08);
  a49=(a27*a22);
  a48=(a48+a49);
  a49=(a28*a39);
  a48=(a48+a49);
  a49=(a35*a33);
  a48=(a48+a49);
  a48=(a10+a48);
  a49=sin(a48);
  a47=(a47*a49);
  a50=(2.*a32);
  a50=(a46-a50);
  a47=(a47*a50);
  a34=(a34*a03);
  a27=(a27*a31);
  a34=(a34+a27);
  a28=(a28*a38);
  a34=(a34+a28);
  a35=(a35*a17);
  a34=(a34+a35);
  a34=(a00+a34);
  a35=sin(a34);
  a28=cos(a48);
  a27=(a35*a28);
  a34=cos(a34);
  a34=(a34*a49);
  a27=(a27-a34);
  a34=(a07*a27);
  a47=(a47-a34);
  a35=(a35*a16);
  a47=(a47+a35);
  a35=(a15-a28);
  a35=(a12*a35);
  a35=(a35+a15);
  a34=(a47/a35);
  a28=(a28-a15);
  a28=(a07*a28);
  a35=(a28/a35);
  a50=casadi_sq(a32);
  a50=(a50*a49);
  a50=(a50+a27);
  a50=(a07*a50);
  a27=arg[2]? arg[2][12] : 0;
  a49=(a21*a27);
  a51=arg[2]? arg[2][13] : 0;
  a52=(a25*a51);
  a49=(a49+a52);
  a49=(a20*a49);
  a49=(a46+a49);
  a49=(a14*a49);
  a27=(a25*a27);
  a51=(a21*a51);
  a27=(a27-a51);
  a27=(a27+a15);
  a27=(a11*a27);
  a27=(a24-a27);
  a27=(a27+a48);
  a27=(a23*a27);
  a49=(a49+a27);
  a50=(a50-a49);
  a47=(a35*a47);
  a50=(a50-a47);
  a28=(a28*a35);
  a28=(a07-a28);
  a50=(a50/a28);
  a35=(a35*a50);
  a34=(a34-a35);
  a35=(a45*a34);
  a40=(a40+a35);
  a40=(a03+a40);
  a35=(a26*a40);
  a04=(a04+a35);
  a35=3.1116436695781990e-01;
  a35=(a35*a02);
  a28=6.2411095871607569e-01;
  a28=(a28*a02);
  a47=(a28*a18);
  a49=-3.3608926294469414e+00;
  a49=(a49*a02);
  a27=(a49*a09);
  a47=(a47+a27);
  a27=-8.6821934684172597e-01;
  a27=(a27*a02);
  a48=(a27*a29);
  a47=(a47+a48);
  a48=2.7592099699446710e+01;
  a48=(a48*a02);
  a51=(a48*a06);
  a47=(a47+a51);
  a51=2.0154067550477894e+01;
  a51=(a51*a02);
  a52=(a51*a34);
  a47=(a47+a52);
  a52=-4.3489884181069961e+01;
  a52=(a52*a02);
  a53=(a13*a19);
  a54=(a42*a37);
  a53=(a53+a54);
  a54=(a43*a36);
  a53=(a53+a54);
  a54=(a41*a44);
  a53=(a53+a54);
  a54=(a45*a50);
  a53=(a53+a54);
  a53=(a08+a53);
  a54=(a07*a53);
  a55=(a13*a08);
  a56=(a42*a22);
  a55=(a55+a56);
  a56=(a43*a39);
  a55=(a55+a56);
  a56=(a41*a33);
  a55=(a55+a56);
  a56=(a45*a46);
  a55=(a55+a56);
  a55=(a10+a55);
  a56=sin(a55);
  a54=(a54*a56);
  a57=(2.*a40);
  a57=(a53-a57);
  a54=(a54*a57);
  a13=(a13*a03);
  a42=(a42*a31);
  a13=(a13+a42);
  a43=(a43*a38);
  a13=(a13+a43);
  a41=(a41*a17);
  a13=(a13+a41);
  a45=(a45*a32);
  a13=(a13+a45);
  a13=(a00+a13);
  a45=sin(a13);
  a41=cos(a55);
  a43=(a45*a41);
  a13=cos(a13);
  a13=(a13*a56);
  a43=(a43-a13);
  a13=(a07*a43);
  a54=(a54-a13);
  a45=(a45*a16);
  a54=(a54+a45);
  a45=(a15-a41);
  a45=(a12*a45);
  a45=(a45+a15);
  a13=(a54/a45);
  a41=(a41-a15);
  a41=(a07*a41);
  a45=(a41/a45);
  a42=casadi_sq(a40);
  a42=(a42*a56);
  a42=(a42+a43);
  a42=(a07*a42);
  a43=arg[2]? arg[2][14] : 0;
  a56=(a21*a43);
  a57=arg[2]? arg[2][15] : 0;
  a58=(a25*a57);
  a56=(a56+a58);
  a56=(a20*a56);
  a56=(a53+a56);
  a56=(a14*a56);
  a43=(a25*a43);
  a57=(a21*a57);
  a43=(a43-a57);
  a43=(a43+a15);
  a43=(a11*a43);
  a43=(a24-a43);
  a43=(a43+a55);
  a43=(a23*a43);
  a56=(a56+a43);
  a42=(a42-a56);
  a54=(a45*a54);
  a42=(a42-a54);
  a41=(a41*a45);
  a41=(a07-a41);
  a42=(a42/a41);
  a45=(a45*a42);
  a13=(a13-a45);
  a45=(a52*a13);
  a47=(a47+a45);
  a47=(a03+a47);
  a45=(a35*a47);
  a04=(a04+a45);
  a45=-1.5216094966251609e-01;
  a45=(a45*a02);
  a41=4.7766253643826434e-01;
  a41=(a41*a02);
  a54=(a41*a18);
  a56=-2.4881146199716677e+00;
  a56=(a56*a02);
  a43=(a56*a09);
  a54=(a54+a43);
  a43=-5.9029082683684297e-01;
  a43=(a43*a02);
  a55=(a43*a29);
  a54=(a54+a55);
  a55=2.1230051448181193e+01;
  a55=(a55*a02);
  a57=(a55*a06);
  a54=(a54+a57);
  a57=1.5279233632882423e+01;
  a57=(a57*a02);
  a58=(a57*a34);
  a54=(a54+a58);
  a58=-3.3288210968984863e+01;
  a58=(a58*a02);
  a59=(a58*a13);
  a54=(a54+a59);
  a59=-2.0331201708508627e-02;
  a59=(a59*a02);
  a60=(a28*a19);
  a61=(a49*a37);
  a60=(a60+a61);
  a61=(a27*a36);
  a60=(a60+a61);
  a61=(a48*a44);
  a60=(a60+a61);
  a61=(a51*a50);
  a60=(a60+a61);
  a61=(a52*a42);
  a60=(a60+a61);
  a60=(a08+a60);
  a61=(a07*a60);
  a62=(a28*a08);
  a63=(a49*a22);
  a62=(a62+a63);
  a63=(a27*a39);
  a62=(a62+a63);
  a63=(a48*a33);
  a62=(a62+a63);
  a63=(a51*a46);
  a62=(a62+a63);
  a63=(a52*a53);
  a62=(a62+a63);
  a62=(a10+a62);
  a63=sin(a62);
  a61=(a61*a63);
  a64=(2.*a47);
  a64=(a60-a64);
  a61=(a61*a64);
  a28=(a28*a03);
  a49=(a49*a31);
  a28=(a28+a49);
  a27=(a27*a38);
  a28=(a28+a27);
  a48=(a48*a17);
  a28=(a28+a48);
  a51=(a51*a32);
  a28=(a28+a51);
  a52=(a52*a40);
  a28=(a28+a52);
  a28=(a00+a28);
  a52=sin(a28);
  a51=cos(a62);
  a48=(a52*a51);
  a28=cos(a28);
  a28=(a28*a63);
  a48=(a48-a28);
  a28=(a07*a48);
  a61=(a61-a28);
  a52=(a52*a16);
  a61=(a61+a52);
  a52=(a15-a51);
  a52=(a12*a52);
  a52=(a52+a15);
  a28=(a61/a52);
  a51=(a51-a15);
  a51=(a07*a51);
  a52=(a51/a52);
  a27=casadi_sq(a47);
  a27=(a27*a63);
  a27=(a27+a48);
  a27=(a07*a27);
  a48=arg[2]? arg[2][16] : 0;
  a63=(a21*a48);
  a49=arg[2]? arg[2][17] : 0;
  a64=(a25*a49);
  a63=(a63+a64);
  a63=(a20*a63);
  a63=(a60+a63);
  a63=(a14*a63);
  a48=(a25*a48);
  a49=(a21*a49);
  a48=(a48-a49);
  a48=(a48+a15);
  a48=(a11*a48);
  a48=(a24-a48);
  a48=(a48+a62);
  a48=(a23*a48);
  a63=(a63+a48);
  a27=(a27-a63);
  a61=(a52*a61);
  a27=(a27-a61);
  a51=(a51*a52);
  a51=(a07-a51);
  a27=(a27/a51);
  a52=(a52*a27);
  a28=(a28-a52);
  a52=(a59*a28);
  a54=(a54+a52);
  a54=(a03+a54);
  a52=(a45*a54);
  a04=(a04+a52);
  a52=2.0136540080403034e-01;
  a52=(a52*a02);
  a51=-9.3714243008598730e-01;
  a51=(a51*a02);
  a61=(a51*a18);
  a63=5.1863724288440638e+00;
  a63=(a63*a02);
  a48=(a63*a09);
  a61=(a61+a48);
  a48=1.0914373489967295e+00;
  a48=(a48*a02);
  a62=(a48*a29);
  a61=(a61+a62);
  a62=-8.1497870107469268e+00;
  a62=(a62*a02);
  a49=(a62*a06);
  a61=(a61+a49);
  a49=-1.8520065659996959e+01;
  a49=(a49*a02);
  a64=(a49*a34);
  a61=(a61+a64);
  a64=2.2739487099350505e+01;
  a64=(a64*a02);
  a65=(a64*a13);
  a61=(a61+a65);
  a65=2.4936055526796523e+00;
  a65=(a65*a02);
  a66=(a65*a28);
  a61=(a61+a66);
  a66=-3.0467644718982196e+00;
  a66=(a66*a02);
  a67=(a41*a19);
  a68=(a56*a37);
  a67=(a67+a68);
  a68=(a43*a36);
  a67=(a67+a68);
  a68=(a55*a44);
  a67=(a67+a68);
  a68=(a57*a50);
  a67=(a67+a68);
  a68=(a58*a42);
  a67=(a67+a68);
  a68=(a59*a27);
  a67=(a67+a68);
  a67=(a08+a67);
  a68=(a07*a67);
  a69=(a41*a08);
  a70=(a56*a22);
  a69=(a69+a70);
  a70=(a43*a39);
  a69=(a69+a70);
  a70=(a55*a33);
  a69=(a69+a70);
  a70=(a57*a46);
  a69=(a69+a70);
  a70=(a58*a53);
  a69=(a69+a70);
  a70=(a59*a60);
  a69=(a69+a70);
  a69=(a10+a69);
  a70=sin(a69);
  a68=(a68*a70);
  a71=(2.*a54);
  a71=(a67-a71);
  a68=(a68*a71);
  a41=(a41*a03);
  a56=(a56*a31);
  a41=(a41+a56);
  a43=(a43*a38);
  a41=(a41+a43);
  a55=(a55*a17);
  a41=(a41+a55);
  a57=(a57*a32);
  a41=(a41+a57);
  a58=(a58*a40);
  a41=(a41+a58);
  a59=(a59*a47);
  a41=(a41+a59);
  a41=(a00+a41);
  a59=sin(a41);
  a58=cos(a69);
  a57=(a59*a58);
  a41=cos(a41);
  a41=(a41*a70);
  a57=(a57-a41);
  a41=(a07*a57);
  a68=(a68-a41);
  a59=(a59*a16);
  a68=(a68+a59);
  a59=(a15-a58);
  a59=(a12*a59);
  a59=(a59+a15);
  a41=(a68/a59);
  a58=(a58-a15);
  a58=(a07*a58);
  a59=(a58/a59);
  a55=casadi_sq(a54);
  a55=(a55*a70);
  a55=(a55+a57);
  a55=(a07*a55);
  a57=arg[2]? arg[2][18] : 0;
  a70=(a21*a57);
  a43=arg[2]? arg[2][19] : 0;
  a56=(a25*a43);
  a70=(a70+a56);
  a70=(a20*a70);
  a70=(a67+a70);
  a70=(a14*a70);
  a57=(a25*a57);
  a43=(a21*a43);
  a57=(a57-a43);
  a57=(a57+a15);
  a57=(a11*a57);
  a57=(a24-a57);
  a57=(a57+a69);
  a57=(a23*a57);
  a70=(a70+a57);
  a55=(a55-a70);
  a68=(a59*a68);
  a55=(a55-a68);
  a58=(a58*a59);
  a58=(a07-a58);
  a55=(a55/a58);
  a59=(a59*a55);
  a41=(a41-a59);
  a59=(a66*a41);
  a61=(a61+a59);
  a61=(a03+a61);
  a59=(a52*a61);
  a04=(a04+a59);
  a59=4.4710615727772587e-02;
  a59=(a59*a02);
  a58=2.2733101475165380e+00;
  a58=(a58*a02);
  a68=(a58*a18);
  a70=-1.0534495466737249e+01;
  a70=(a70*a02);
  a09=(a70*a09);
  a68=(a68+a09);
  a09=-2.0008720582248625e+00;
  a09=(a09*a02);
  a29=(a09*a29);
  a68=(a68+a29);
  a29=-1.7958931863118799e+01;
  a29=(a29*a02);
  a57=(a29*a06);
  a68=(a68+a57);
  a57=2.7948884529419960e+01;
  a57=(a57*a02);
  a69=(a57*a34);
  a68=(a68+a69);
  a69=-2.8589982771350235e+00;
  a69=(a69*a02);
  a43=(a69*a13);
  a68=(a68+a43);
  a43=-8.8728569335306293e+00;
  a43=(a43*a02);
  a56=(a43*a28);
  a68=(a68+a56);
  a56=1.2360567175794303e+01;
  a56=(a56*a02);
  a71=(a56*a41);
  a68=(a68+a71);
  a71=6.4339274601576357e-01;
  a71=(a71*a02);
  a02=(a51*a19);
  a72=(a63*a37);
  a02=(a02+a72);
  a72=(a48*a36);
  a02=(a02+a72);
  a72=(a62*a44);
  a02=(a02+a72);
  a72=(a49*a50);
  a02=(a02+a72);
  a72=(a64*a42);
  a02=(a02+a72);
  a72=(a65*a27);
  a02=(a02+a72);
  a72=(a66*a55);
  a02=(a02+a72);
  a02=(a08+a02);
  a72=(a07*a02);
  a73=(a51*a08);
  a74=(a63*a22);
  a73=(a73+a74);
  a74=(a48*a39);
  a73=(a73+a74);
  a74=(a62*a33);
  a73=(a73+a74);
  a74=(a49*a46);
  a73=(a73+a74);
  a74=(a64*a53);
  a73=(a73+a74);
  a74=(a65*a60);
  a73=(a73+a74);
  a74=(a66*a67);
  a73=(a73+a74);
  a73=(a10+a73);
  a74=sin(a73);
  a72=(a72*a74);
  a75=(2.*a61);
  a75=(a02-a75);
  a72=(a72*a75);
  a51=(a51*a03);
  a63=(a63*a31);
  a51=(a51+a63);
  a48=(a48*a38);
  a51=(a51+a48);
  a62=(a62*a17);
  a51=(a51+a62);
  a49=(a49*a32);
  a51=(a51+a49);
  a64=(a64*a40);
  a51=(a51+a64);
  a65=(a65*a47);
  a51=(a51+a65);
  a66=(a66*a54);
  a51=(a51+a66);
  a51=(a00+a51);
  a66=sin(a51);
  a65=cos(a73);
  a64=(a66*a65);
  a51=cos(a51);
  a51=(a51*a74);
  a64=(a64-a51);
  a51=(a07*a64);
  a72=(a72-a51);
  a66=(a66*a16);
  a72=(a72+a66);
  a66=(a15-a65);
  a66=(a12*a66);
  a66=(a66+a15);
  a51=(a72/a66);
  a65=(a65-a15);
  a65=(a07*a65);
  a66=(a65/a66);
  a49=casadi_sq(a61);
  a49=(a49*a74);
  a49=(a49+a64);
  a49=(a07*a49);
  a64=arg[2]? arg[2][20] : 0;
  a74=(a21*a64);
  a62=arg[2]? arg[2][21] : 0;
  a48=(a25*a62);
  a74=(a74+a48);
  a74=(a20*a74);
  a74=(a02+a74);
  a74=(a14*a74);
  a64=(a25*a64);
  a62=(a21*a62);
  a64=(a64-a62);
  a64=(a64+a15);
  a64=(a11*a64);
  a64=(a24-a64);
  a64=(a64+a73);
  a64=(a23*a64);
  a74=(a74+a64);
  a49=(a49-a74);
  a72=(a66*a72);
  a49=(a49-a72);
  a65=(a65*a66);
  a65=(a07-a65);
  a49=(a49/a65);
  a66=(a66*a49);
  a51=(a51-a66);
  a66=(a71*a51);
  a68=(a68+a66);
  a68=(a03+a68);
  a66=(a59*a68);
  a04=(a04+a66);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a66=(a05*a33);
  a04=(a04+a66);
  a66=(a30*a46);
  a04=(a04+a66);
  a66=(a26*a53);
  a04=(a04+a66);
  a66=(a35*a60);
  a04=(a04+a66);
  a66=(a45*a67);
  a04=(a04+a66);
  a66=(a52*a02);
  a04=(a04+a66);
  a66=(a58*a19);
  a37=(a70*a37);
  a66=(a66+a37);
  a36=(a09*a36);
  a66=(a66+a36);
  a36=(a29*a44);
  a66=(a66+a36);
  a36=(a57*a50);
  a66=(a66+a36);
  a36=(a69*a42);
  a66=(a66+a36);
  a36=(a43*a27);
  a66=(a66+a36);
  a36=(a56*a55);
  a66=(a66+a36);
  a36=(a71*a49);
  a66=(a66+a36);
  a66=(a08+a66);
  a36=(a59*a66);
  a04=(a04+a36);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a18=(a01*a18);
  a06=(a05*a06);
  a18=(a18+a06);
  a34=(a30*a34);
  a18=(a18+a34);
  a13=(a26*a13);
  a18=(a18+a13);
  a28=(a35*a28);
  a18=(a18+a28);
  a41=(a45*a41);
  a18=(a18+a41);
  a51=(a52*a51);
  a18=(a18+a51);
  a51=(a07*a66);
  a41=(a58*a08);
  a22=(a70*a22);
  a41=(a41+a22);
  a39=(a09*a39);
  a41=(a41+a39);
  a33=(a29*a33);
  a41=(a41+a33);
  a46=(a57*a46);
  a41=(a41+a46);
  a53=(a69*a53);
  a41=(a41+a53);
  a60=(a43*a60);
  a41=(a41+a60);
  a67=(a56*a67);
  a41=(a41+a67);
  a02=(a71*a02);
  a41=(a41+a02);
  a10=(a10+a41);
  a41=sin(a10);
  a51=(a51*a41);
  a02=(2.*a68);
  a02=(a66-a02);
  a51=(a51*a02);
  a58=(a58*a03);
  a70=(a70*a31);
  a58=(a58+a70);
  a09=(a09*a38);
  a58=(a58+a09);
  a29=(a29*a17);
  a58=(a58+a29);
  a57=(a57*a32);
  a58=(a58+a57);
  a69=(a69*a40);
  a58=(a58+a69);
  a43=(a43*a47);
  a58=(a58+a43);
  a56=(a56*a54);
  a58=(a58+a56);
  a71=(a71*a61);
  a58=(a58+a71);
  a00=(a00+a58);
  a58=sin(a00);
  a71=cos(a10);
  a61=(a58*a71);
  a00=cos(a00);
  a00=(a00*a41);
  a61=(a61-a00);
  a00=(a07*a61);
  a51=(a51-a00);
  a58=(a58*a16);
  a51=(a51+a58);
  a58=(a15-a71);
  a12=(a12*a58);
  a12=(a12+a15);
  a58=(a51/a12);
  a71=(a71-a15);
  a71=(a07*a71);
  a12=(a71/a12);
  a68=casadi_sq(a68);
  a68=(a68*a41);
  a68=(a68+a61);
  a68=(a07*a68);
  a61=arg[2]? arg[2][22] : 0;
  a41=(a21*a61);
  a16=arg[2]? arg[2][23] : 0;
  a00=(a25*a16);
  a41=(a41+a00);
  a20=(a20*a41);
  a66=(a66+a20);
  a14=(a14*a66);
  a25=(a25*a61);
  a21=(a21*a16);
  a25=(a25-a21);
  a25=(a25+a15);
  a11=(a11*a25);
  a24=(a24-a11);
  a24=(a24+a10);
  a23=(a23*a24);
  a14=(a14+a23);
  a68=(a68-a14);
  a51=(a12*a51);
  a68=(a68-a51);
  a71=(a71*a12);
  a07=(a07-a71);
  a68=(a68/a07);
  a12=(a12*a68);
  a58=(a58-a12);
  a58=(a59*a58);
  a18=(a18+a58);
  a03=(a03+a18);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a19);
  a05=(a05*a44);
  a01=(a01+a05);
  a30=(a30*a50);
  a01=(a01+a30);
  a26=(a26*a42);
  a01=(a01+a26);
  a35=(a35*a27);
  a01=(a01+a35);
  a45=(a45*a55);
  a01=(a01+a45);
  a52=(a52*a49);
  a01=(a01+a52);
  a59=(a59*a68);
  a01=(a01+a59);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p[6])->(y_end[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+76, w1, *w2=w+80, *w3=w+86, w5, *w6=w+88, w7;
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
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+518, *w1=w+522, *w2=w+528;
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
  if (sz_w) *sz_w = 532;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 532*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+2, *rr, *w0=w+394, *w1=w+410, *w2=w+414, *w3=w+420, *w4=w+436;
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
  casadi_real **res1=res+1, *w0=w+504, *w1=w+508, *w2=w+514;
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
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+518, *w1=w+522, *w2=w+528;
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
  if (sz_w) *sz_w = 532;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 532*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+2, *rr, *w0=w+394, *w1=w+410, *w2=w+414, *w3=w+420, *w4=w+436;
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
  casadi_real **res1=res+1, *w0=w+504, *w1=w+508, *w2=w+514;
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
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+518, *w1=w+522, *w2=w+528;
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
  if (sz_w) *sz_w = 532;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 532*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_36:(u[4],p[6])->(R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_72:(u[4],p[6])->(R[4]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_96:(u[4],p[6])->(R[4]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_144:(u[4],p[6])->(R[4]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_192:(u[4],p[6])->(R[4]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_288:(u[4],p[6])->(R[4]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
  return 0;
}

/* compass_residual_384:(u[4],p[6])->(R[4]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+132, w4, w5, w6, *w7=w+136;
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
  casadi_real **res1=res+2, *w0=w+394, *w1=w+398, *w2=w+404, *w3=w+420;
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
  casadi_real **res1=res+2, *rr, *w0=w+424, *w1=w+440, *w2=w+444, *w3=w+450, *w4=w+466;
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
  casadi_real **res1=res+1, *w0=w+534, *w1=w+538, *w2=w+544;
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
  casadi_real **res1=res+2, *rr, *w00=w+306, *w01=w+310, *w02=w+313, *w03=w+319, *w04=w+323, *w05=w+335, w06, w07, w08, *w09=w+351;
  casadi_real *w10=w+375;
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
  casadi_real **res1=res+3, *w0=w+548, *w1=w+552, *w2=w+558, *w3=w+562;
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
  if (sz_w) *sz_w = 578;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 578*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 160;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 160*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 391;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 391*sizeof(casadi_real);
  return 0;
}

/* start_along:(z[3],p[6],d[6])->(y[4x5]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (res[0]!=0) res[0][4]=a0;
  a1=2.;
  if (res[0]!=0) res[0][5]=a1;
  a1=0.;
  if (res[0]!=0) res[0][6]=a1;
  if (res[0]!=0) res[0][7]=a1;
  if (res[0]!=0) res[0][8]=a1;
  if (res[0]!=0) res[0][9]=a1;
  if (res[0]!=0) res[0][10]=a0;
  if (res[0]!=0) res[0][11]=a1;
  if (res[0]!=0) res[0][12]=a1;
  if (res[0]!=0) res[0][13]=a1;
  if (res[0]!=0) res[0][14]=a1;
  if (res[0]!=0) res[0][15]=a0;
  if (res[0]!=0) res[0][16]=a1;
  if (res[0]!=0) res[0][17]=a1;
  if (res[0]!=0) res[0][18]=a1;
  if (res[0]!=0) res[0][19]=a1;
  return 0;
}

/* step_along:(y[4x5],phase[2],turns[2x12],h,p[6],t,d[6])->(y_end[4x5]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344, a345, a346, a347;
  casadi_real a348, a349, a350, a351, a352, a353, a354, a355, a356, a357, a358, a359;
  casadi_real a360, a361, a362, a363, a364, a365, a366, a367, a368, a369, a370, a371;
  casadi_real a372, a373, a374, a375, a376, a377, a378, a379, a380, a381, a382, a383;
  casadi_real a384, a385, a386, a387, a388, a389, a390, a391, a392, a393, a394, a395;
  casadi_real a396, a397, a398, a399, a400, a401, a402, a403, a404, a405, a406, a407;
  casadi_real a408, a409, a410, a411, a412, a413, a414, a415, a416, a417, a418, a419;
  casadi_real a420, a421, a422, a423, a424, a425, a426, a427, a428, a429, a430, a431;
  casadi_real a432, a433, a434, a435, a436, a437, a438, a439, a440, a441, a442;
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
  a023=(a021*a022);
  a023=(a023+a018);
  a024=(a009/a023);
  a025=(a014-a018);
  a026=(a007*a025);
  a027=(a026/a023);
  a028=casadi_sq(a003);
  a028=(a028*a011);
  a028=(a028+a015);
  a029=(a007*a028);
  a030=arg[4]? arg[4][3] : 0;
  a031=arg[4]? arg[4][5] : 0;
  a032=arg[4]? arg[4][0] : 0;
  a033=(a031*a032);
  a034=arg[1]? arg[1][1] : 0;
  a035=(a033*a034);
  a035=(a008+a035);
  a036=(a030*a035);
  a037=arg[4]? arg[4][2] : 0;
  a038=arg[4]? arg[4][4] : 0;
  a039=arg[1]? arg[1][0] : 0;
  a040=(a039+a018);
  a041=(a031*a040);
  a041=(a038-a041);
  a041=(a041+a010);
  a042=(a037*a041);
  a036=(a036+a042);
  a029=(a029-a036);
  a036=(a027*a009);
  a036=(a029-a036);
  a042=(a026*a027);
  a042=(a007-a042);
  a036=(a036/a042);
  a043=(a027*a036);
  a043=(a024-a043);
  a044=(a006*a043);
  a045=1.7082860872947386e-01;
  a045=(a045*a002);
  a046=2.9587585476806851e-02;
  a046=(a046*a002);
  a047=(a046*a036);
  a048=8.8762756430420545e-02;
  a048=(a048*a002);
  a049=1.9725056984537900e-02;
  a049=(a049*a002);
  a050=(a049*a043);
  a051=5.9175170953613701e-02;
  a051=(a051*a002);
  a052=5.2600151958767730e-02;
  a052=(a052*a002);
  a053=(a052*a036);
  a053=(a008+a053);
  a054=(a007*a053);
  a055=(a052*a008);
  a055=(a010+a055);
  a056=sin(a055);
  a054=(a054*a056);
  a057=(a052*a043);
  a057=(a003+a057);
  a058=(2.*a057);
  a058=(a053-a058);
  a054=(a054*a058);
  a059=(a052*a003);
  a059=(a000+a059);
  a060=sin(a059);
  a061=cos(a055);
  a062=(a060*a061);
  a059=cos(a059);
  a063=(a059*a056);
  a062=(a062-a063);
  a063=(a007*a062);
  a054=(a054-a063);
  a064=(a060*a019);
  a054=(a054+a064);
  a065=(a018-a061);
  a066=(a021*a065);
  a066=(a066+a018);
  a067=(a054/a066);
  a068=(a061-a018);
  a069=(a007*a068);
  a070=(a069/a066);
  a071=casadi_sq(a057);
  a071=(a071*a056);
  a071=(a071+a062);
  a072=(a007*a071);
  a073=arg[2]? arg[2][2] : 0;
  a074=(a034*a073);
  a075=arg[2]? arg[2][3] : 0;
  a076=(a039*a075);
  a074=(a074+a076);
  a076=(a033*a074);
  a076=(a053+a076);
  a077=(a030*a076);
  a073=(a039*a073);
  a075=(a034*a075);
  a073=(a073-a075);
  a075=(a073+a018);
  a078=(a031*a075);
  a078=(a038-a078);
  a078=(a078+a055);
  a055=(a037*a078);
  a077=(a077+a055);
  a072=(a072-a077);
  a077=(a070*a054);
  a077=(a072-a077);
  a055=(a069*a070);
  a055=(a007-a055);
  a077=(a077/a055);
  a079=(a070*a077);
  a079=(a067-a079);
  a079=(a051*a079);
  a050=(a050+a079);
  a050=(a003+a050);
  a079=casadi_sq(a050);
  a080=(a049*a008);
  a081=(a051*a053);
  a080=(a080+a081);
  a080=(a010+a080);
  a081=sin(a080);
  a079=(a079*a081);
  a082=(a049*a003);
  a083=(a051*a057);
  a082=(a082+a083);
  a082=(a000+a082);
  a083=sin(a082);
  a084=cos(a080);
  a085=(a083*a084);
  a082=cos(a082);
  a086=(a082*a081);
  a085=(a085-a086);
  a079=(a079+a085);
  a086=(a007*a079);
  a087=(a049*a036);
  a088=(a051*a077);
  a087=(a087+a088);
  a087=(a008+a087);
  a088=arg[2]? arg[2][4] : 0;
  a089=(a034*a088);
  a090=arg[2]? arg[2][5] : 0;
  a091=(a039*a090);
  a089=(a089+a091);
  a091=(a033*a089);
  a091=(a087+a091);
  a092=(a030*a091);
  a088=(a039*a088);
  a090=(a034*a090);
  a088=(a088-a090);
  a090=(a088+a018);
  a093=(a031*a090);
  a093=(a038-a093);
  a093=(a093+a080);
  a080=(a037*a093);
  a092=(a092+a080);
  a086=(a086-a092);
  a092=(a084-a018);
  a080=(a007*a092);
  a094=(a018-a084);
  a095=(a021*a094);
  a095=(a095+a018);
  a096=(a080/a095);
  a097=(a007*a087);
  a097=(a097*a081);
  a098=(2.*a050);
  a098=(a087-a098);
  a097=(a097*a098);
  a099=(a007*a085);
  a097=(a097-a099);
  a100=(a083*a019);
  a097=(a097+a100);
  a101=(a096*a097);
  a101=(a086-a101);
  a102=(a080*a096);
  a102=(a007-a102);
  a101=(a101/a102);
  a103=(a048*a101);
  a047=(a047+a103);
  a047=(a008+a047);
  a103=(a007*a047);
  a104=(a046*a008);
  a105=(a048*a087);
  a104=(a104+a105);
  a104=(a010+a104);
  a105=sin(a104);
  a103=(a103*a105);
  a106=(a046*a043);
  a107=(a097/a095);
  a108=(a096*a101);
  a108=(a107-a108);
  a109=(a048*a108);
  a106=(a106+a109);
  a106=(a003+a106);
  a109=(2.*a106);
  a109=(a047-a109);
  a103=(a103*a109);
  a110=(a046*a003);
  a111=(a048*a050);
  a110=(a110+a111);
  a110=(a000+a110);
  a111=sin(a110);
  a112=cos(a104);
  a113=(a111*a112);
  a110=cos(a110);
  a114=(a110*a105);
  a113=(a113-a114);
  a114=(a007*a113);
  a103=(a103-a114);
  a115=(a111*a019);
  a103=(a103+a115);
  a116=(a018-a112);
  a117=(a021*a116);
  a117=(a117+a018);
  a118=(a103/a117);
  a119=(a112-a018);
  a120=(a007*a119);
  a121=(a120/a117);
  a122=casadi_sq(a106);
  a122=(a122*a105);
  a122=(a122+a113);
  a123=(a007*a122);
  a124=arg[2]? arg[2][6] : 0;
  a125=(a034*a124);
  a126=arg[2]? arg[2][7] : 0;
  a127=(a039*a126);
  a125=(a125+a127);
  a127=(a033*a125);
  a127=(a047+a127);
  a128=(a030*a127);
  a124=(a039*a124);
  a126=(a034*a126);
  a124=(a124-a126);
  a126=(a124+a018);
  a129=(a031*a126);
  a129=(a038-a129);
  a129=(a129+a104);
  a104=(a037*a129);
  a128=(a128+a104);
  a123=(a123-a128);
  a128=(a121*a103);
  a128=(a123-a128);
  a104=(a120*a121);
  a104=(a007-a104);
  a128=(a128/a104);
  a130=(a121*a128);
  a130=(a118-a130);
  a131=(a045*a130);
  a044=(a044+a131);
  a131=1.2546768756682242e-01;
  a131=(a131*a002);
  a132=2.4136513415926669e-01;
  a132=(a132*a002);
  a133=(a132*a036);
  a134=-8.8454947932828609e-01;
  a134=(a134*a002);
  a135=(a134*a101);
  a133=(a133+a135);
  a135=9.2483400326179199e-01;
  a135=(a135*a002);
  a136=(a135*a128);
  a133=(a133+a136);
  a133=(a008+a133);
  a136=(a007*a133);
  a137=(a132*a008);
  a138=(a134*a087);
  a137=(a137+a138);
  a138=(a135*a047);
  a137=(a137+a138);
  a137=(a010+a137);
  a138=sin(a137);
  a136=(a136*a138);
  a139=(a132*a043);
  a108=(a134*a108);
  a139=(a139+a108);
  a108=(a135*a130);
  a139=(a139+a108);
  a139=(a003+a139);
  a108=(2.*a139);
  a108=(a133-a108);
  a136=(a136*a108);
  a140=(a132*a003);
  a141=(a134*a050);
  a140=(a140+a141);
  a141=(a135*a106);
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
  a147=(a021*a146);
  a147=(a147+a018);
  a148=(a136/a147);
  a149=(a142-a018);
  a150=(a007*a149);
  a151=(a150/a147);
  a152=casadi_sq(a139);
  a152=(a152*a138);
  a152=(a152+a143);
  a153=(a007*a152);
  a154=arg[2]? arg[2][8] : 0;
  a155=(a034*a154);
  a156=arg[2]? arg[2][9] : 0;
  a157=(a039*a156);
  a155=(a155+a157);
  a157=(a033*a155);
  a157=(a133+a157);
  a158=(a030*a157);
  a154=(a039*a154);
  a156=(a034*a156);
  a154=(a154-a156);
  a156=(a154+a018);
  a159=(a031*a156);
  a159=(a038-a159);
  a159=(a159+a137);
  a137=(a037*a159);
  a158=(a158+a137);
  a153=(a153-a158);
  a158=(a151*a136);
  a158=(a153-a158);
  a137=(a150*a151);
  a137=(a007-a137);
  a158=(a158/a137);
  a160=(a151*a158);
  a160=(a148-a160);
  a161=(a131*a160);
  a044=(a044+a161);
  a044=(a003+a044);
  a161=(a005*a044);
  a004=(a004+a161);
  a161=1.8915178993145003e+00;
  a161=(a161*a002);
  a162=3.7109375000000000e-02;
  a162=(a162*a002);
  a163=(a162*a043);
  a164=1.7025221101954405e-01;
  a164=(a164*a002);
  a165=(a164*a130);
  a163=(a163+a165);
  a165=6.0216538980455959e-02;
  a165=(a165*a002);
  a166=(a165*a160);
  a163=(a163+a166);
  a166=-1.7578125000000000e-02;
  a166=(a166*a002);
  a167=(a006*a036);
  a168=(a045*a128);
  a167=(a167+a168);
  a168=(a131*a158);
  a167=(a167+a168);
  a167=(a008+a167);
  a168=(a007*a167);
  a169=(a006*a008);
  a170=(a045*a047);
  a169=(a169+a170);
  a170=(a131*a133);
  a169=(a169+a170);
  a169=(a010+a169);
  a170=sin(a169);
  a168=(a168*a170);
  a171=(2.*a044);
  a171=(a167-a171);
  a168=(a168*a171);
  a172=(a006*a003);
  a173=(a045*a106);
  a172=(a172+a173);
  a173=(a131*a139);
  a172=(a172+a173);
  a172=(a000+a172);
  a173=sin(a172);
  a174=cos(a169);
  a175=(a173*a174);
  a172=cos(a172);
  a176=(a172*a170);
  a175=(a175-a176);
  a176=(a007*a175);
  a168=(a168-a176);
  a177=(a173*a019);
  a168=(a168+a177);
  a178=(a018-a174);
  a179=(a021*a178);
  a179=(a179+a018);
  a180=(a168/a179);
  a181=(a174-a018);
  a182=(a007*a181);
  a183=(a182/a179);
  a184=casadi_sq(a044);
  a184=(a184*a170);
  a184=(a184+a175);
  a185=(a007*a184);
  a186=arg[2]? arg[2][10] : 0;
  a187=(a034*a186);
  a188=arg[2]? arg[2][11] : 0;
  a189=(a039*a188);
  a187=(a187+a189);
  a189=(a033*a187);
  a189=(a167+a189);
  a190=(a030*a189);
  a186=(a039*a186);
  a188=(a034*a188);
  a186=(a186-a188);
  a188=(a186+a018);
  a191=(a031*a188);
  a191=(a038-a191);
  a191=(a191+a169);
  a169=(a037*a191);
  a190=(a190+a169);
  a185=(a185-a190);
  a190=(a183*a168);
  a190=(a185-a190);
  a169=(a182*a183);
  a169=(a007-a169);
  a190=(a190/a169);
  a192=(a183*a190);
  a192=(a180-a192);
  a193=(a166*a192);
  a163=(a163+a193);
  a163=(a003+a163);
  a193=(a161*a163);
  a004=(a004+a193);
  a193=-5.8012039600105849e+00;
  a193=(a193*a002);
  a194=3.7092000118504789e-02;
  a194=(a194*a002);
  a195=(a194*a043);
  a196=1.7038392571223998e-01;
  a196=(a196*a002);
  a197=(a196*a130);
  a195=(a195+a197);
  a197=1.0726203044637328e-01;
  a197=(a197*a002);
  a198=(a197*a160);
  a195=(a195+a198);
  a198=-1.5319437748624402e-02;
  a198=(a198*a002);
  a199=(a198*a192);
  a195=(a195+a199);
  a199=8.2737891638140233e-03;
  a199=(a199*a002);
  a200=(a162*a036);
  a201=(a164*a128);
  a200=(a200+a201);
  a201=(a165*a158);
  a200=(a200+a201);
  a201=(a166*a190);
  a200=(a200+a201);
  a200=(a008+a200);
  a201=(a007*a200);
  a202=(a162*a008);
  a203=(a164*a047);
  a202=(a202+a203);
  a203=(a165*a133);
  a202=(a202+a203);
  a203=(a166*a167);
  a202=(a202+a203);
  a202=(a010+a202);
  a203=sin(a202);
  a201=(a201*a203);
  a204=(2.*a163);
  a204=(a200-a204);
  a201=(a201*a204);
  a205=(a162*a003);
  a206=(a164*a106);
  a205=(a205+a206);
  a206=(a165*a139);
  a205=(a205+a206);
  a206=(a166*a044);
  a205=(a205+a206);
  a205=(a000+a205);
  a206=sin(a205);
  a207=cos(a202);
  a208=(a206*a207);
  a205=cos(a205);
  a209=(a205*a203);
  a208=(a208-a209);
  a209=(a007*a208);
  a201=(a201-a209);
  a210=(a206*a019);
  a201=(a201+a210);
  a211=(a018-a207);
  a212=(a021*a211);
  a212=(a212+a018);
  a213=(a201/a212);
  a214=(a207-a018);
  a215=(a007*a214);
  a216=(a215/a212);
  a217=casadi_sq(a163);
  a217=(a217*a203);
  a217=(a217+a208);
  a218=(a007*a217);
  a219=arg[2]? arg[2][12] : 0;
  a220=(a034*a219);
  a221=arg[2]? arg[2][13] : 0;
  a222=(a039*a221);
  a220=(a220+a222);
  a222=(a033*a220);
  a222=(a200+a222);
  a223=(a030*a222);
  a219=(a039*a219);
  a221=(a034*a221);
  a219=(a219-a221);
  a221=(a219+a018);
  a224=(a031*a221);
  a224=(a038-a224);
  a224=(a224+a202);
  a202=(a037*a224);
  a223=(a223+a202);
  a218=(a218-a223);
  a223=(a216*a201);
  a223=(a218-a223);
  a202=(a215*a216);
  a202=(a007-a202);
  a223=(a223/a202);
  a225=(a216*a223);
  a225=(a213-a225);
  a226=(a199*a225);
  a195=(a195+a226);
  a195=(a003+a195);
  a226=(a193*a195);
  a004=(a004+a226);
  a226=3.1116436695781990e-01;
  a226=(a226*a002);
  a227=6.2411095871607569e-01;
  a227=(a227*a002);
  a228=(a227*a043);
  a229=-3.3608926294469414e+00;
  a229=(a229*a002);
  a230=(a229*a130);
  a228=(a228+a230);
  a230=-8.6821934684172597e-01;
  a230=(a230*a002);
  a231=(a230*a160);
  a228=(a228+a231);
  a231=2.7592099699446710e+01;
  a231=(a231*a002);
  a232=(a231*a192);
  a228=(a228+a232);
  a232=2.0154067550477894e+01;
  a232=(a232*a002);
  a233=(a232*a225);
  a228=(a228+a233);
  a233=-4.3489884181069961e+01;
  a233=(a233*a002);
  a234=(a194*a036);
  a235=(a196*a128);
  a234=(a234+a235);
  a235=(a197*a158);
  a234=(a234+a235);
  a235=(a198*a190);
  a234=(a234+a235);
  a235=(a199*a223);
  a234=(a234+a235);
  a234=(a008+a234);
  a235=(a007*a234);
  a236=(a194*a008);
  a237=(a196*a047);
  a236=(a236+a237);
  a237=(a197*a133);
  a236=(a236+a237);
  a237=(a198*a167);
  a236=(a236+a237);
  a237=(a199*a200);
  a236=(a236+a237);
  a236=(a010+a236);
  a237=sin(a236);
  a235=(a235*a237);
  a238=(2.*a195);
  a238=(a234-a238);
  a235=(a235*a238);
  a239=(a194*a003);
  a240=(a196*a106);
  a239=(a239+a240);
  a240=(a197*a139);
  a239=(a239+a240);
  a240=(a198*a044);
  a239=(a239+a240);
  a240=(a199*a163);
  a239=(a239+a240);
  a239=(a000+a239);
  a240=sin(a239);
  a241=cos(a236);
  a242=(a240*a241);
  a239=cos(a239);
  a243=(a239*a237);
  a242=(a242-a243);
  a243=(a007*a242);
  a235=(a235-a243);
  a244=(a240*a019);
  a235=(a235+a244);
  a245=(a018-a241);
  a246=(a021*a245);
  a246=(a246+a018);
  a247=(a235/a246);
  a248=(a241-a018);
  a249=(a007*a248);
  a250=(a249/a246);
  a251=casadi_sq(a195);
  a251=(a251*a237);
  a251=(a251+a242);
  a252=(a007*a251);
  a253=arg[2]? arg[2][14] : 0;
  a254=(a034*a253);
  a255=arg[2]? arg[2][15] : 0;
  a256=(a039*a255);
  a254=(a254+a256);
  a256=(a033*a254);
  a256=(a234+a256);
  a257=(a030*a256);
  a253=(a039*a253);
  a255=(a034*a255);
  a253=(a253-a255);
  a255=(a253+a018);
  a258=(a031*a255);
  a258=(a038-a258);
  a258=(a258+a236);
  a236=(a037*a258);
  a257=(a257+a236);
  a252=(a252-a257);
  a257=(a250*a235);
  a257=(a252-a257);
  a236=(a249*a250);
  a236=(a007-a236);
  a257=(a257/a236);
  a259=(a250*a257);
  a259=(a247-a259);
  a260=(a233*a259);
  a228=(a228+a260);
  a228=(a003+a228);
  a260=(a226*a228);
  a004=(a004+a260);
  a260=-1.5216094966251609e-01;
  a260=(a260*a002);
  a261=4.7766253643826434e-01;
  a261=(a261*a002);
  a262=(a261*a043);
  a263=-2.4881146199716677e+00;
  a263=(a263*a002);
  a264=(a263*a130);
  a262=(a262+a264);
  a264=-5.9029082683684297e-01;
  a264=(a264*a002);
  a265=(a264*a160);
  a262=(a262+a265);
  a265=2.1230051448181193e+01;
  a265=(a265*a002);
  a266=(a265*a192);
  a262=(a262+a266);
  a266=1.5279233632882423e+01;
  a266=(a266*a002);
  a267=(a266*a225);
  a262=(a262+a267);
  a267=-3.3288210968984863e+01;
  a267=(a267*a002);
  a268=(a267*a259);
  a262=(a262+a268);
  a268=-2.0331201708508627e-02;
  a268=(a268*a002);
  a269=(a227*a036);
  a270=(a229*a128);
  a269=(a269+a270);
  a270=(a230*a158);
  a269=(a269+a270);
  a270=(a231*a190);
  a269=(a269+a270);
  a270=(a232*a223);
  a269=(a269+a270);
  a270=(a233*a257);
  a269=(a269+a270);
  a269=(a008+a269);
  a270=(a007*a269);
  a271=(a227*a008);
  a272=(a229*a047);
  a271=(a271+a272);
  a272=(a230*a133);
  a271=(a271+a272);
  a272=(a231*a167);
  a271=(a271+a272);
  a272=(a232*a200);
  a271=(a271+a272);
  a272=(a233*a234);
  a271=(a271+a272);
  a271=(a010+a271);
  a272=sin(a271);
  a270=(a270*a272);
  a273=(2.*a228);
  a273=(a269-a273);
  a270=(a270*a273);
  a274=(a227*a003);
  a275=(a229*a106);
  a274=(a274+a275);
  a275=(a230*a139);
  a274=(a274+a275);
  a275=(a231*a044);
  a274=(a274+a275);
  a275=(a232*a163);
  a274=(a274+a275);
  a275=(a233*a195);
  a274=(a274+a275);
  a274=(a000+a274);
  a275=sin(a274);
  a276=cos(a271);
  a277=(a275*a276);
  a274=cos(a274);
  a278=(a274*a272);
  a277=(a277-a278);
  a278=(a007*a277);
  a270=(a270-a278);
  a279=(a275*a019);
  a270=(a270+a279);
  a280=(a018-a276);
  a281=(a021*a280);
  a281=(a281+a018);
  a282=(a270/a281);
  a283=(a276-a018);
  a284=(a007*a283);
  a285=(a284/a281);
  a286=casadi_sq(a228);
  a286=(a286*a272);
  a286=(a286+a277);
  a287=(a007*a286);
  a288=arg[2]? arg[2][16] : 0;
  a289=(a034*a288);
  a290=arg[2]? arg[2][17] : 0;
  a291=(a039*a290);
  a289=(a289+a291);
  a291=(a033*a289);
  a291=(a269+a291);
  a292=(a030*a291);
  a288=(a039*a288);
  a290=(a034*a290);
  a288=(a288-a290);
  a290=(a288+a018);
  a293=(a031*a290);
  a293=(a038-a293);
  a293=(a293+a271);
  a271=(a037*a293);
  a292=(a292+a271);
  a287=(a287-a292);
  a292=(a285*a270);
  a292=(a287-a292);
  a271=(a284*a285);
  a271=(a007-a271);
  a292=(a292/a271);
  a294=(a285*a292);
  a294=(a282-a294);
  a295=(a268*a294);
  a262=(a262+a295);
  a262=(a003+a262);
  a295=(a260*a262);
  a004=(a004+a295);
  a295=2.0136540080403034e-01;
  a295=(a295*a002);
  a296=-9.3714243008598730e-01;
  a296=(a296*a002);
  a297=(a296*a043);
  a298=5.1863724288440638e+00;
  a298=(a298*a002);
  a299=(a298*a130);
  a297=(a297+a299);
  a299=1.0914373489967295e+00;
  a299=(a299*a002);
  a300=(a299*a160);
  a297=(a297+a300);
  a300=-8.1497870107469268e+00;
  a300=(a300*a002);
  a301=(a300*a192);
  a297=(a297+a301);
  a301=-1.8520065659996959e+01;
  a301=(a301*a002);
  a302=(a301*a225);
  a297=(a297+a302);
  a302=2.2739487099350505e+01;
  a302=(a302*a002);
  a303=(a302*a259);
  a297=(a297+a303);
  a303=2.4936055526796523e+00;
  a303=(a303*a002);
  a304=(a303*a294);
  a297=(a297+a304);
  a304=-3.0467644718982196e+00;
  a304=(a304*a002);
  a305=(a261*a036);
  a306=(a263*a128);
  a305=(a305+a306);
  a306=(a264*a158);
  a305=(a305+a306);
  a306=(a265*a190);
  a305=(a305+a306);
  a306=(a266*a223);
  a305=(a305+a306);
  a306=(a267*a257);
  a305=(a305+a306);
  a306=(a268*a292);
  a305=(a305+a306);
  a305=(a008+a305);
  a306=(a007*a305);
  a307=(a261*a008);
  a308=(a263*a047);
  a307=(a307+a308);
  a308=(a264*a133);
  a307=(a307+a308);
  a308=(a265*a167);
  a307=(a307+a308);
  a308=(a266*a200);
  a307=(a307+a308);
  a308=(a267*a234);
  a307=(a307+a308);
  a308=(a268*a269);
  a307=(a307+a308);
  a307=(a010+a307);
  a308=sin(a307);
  a306=(a306*a308);
  a309=(2.*a262);
  a309=(a305-a309);
  a306=(a306*a309);
  a310=(a261*a003);
  a311=(a263*a106);
  a310=(a310+a311);
  a311=(a264*a139);
  a310=(a310+a311);
  a311=(a265*a044);
  a310=(a310+a311);
  a311=(a266*a163);
  a310=(a310+a311);
  a311=(a267*a195);
  a310=(a310+a311);
  a311=(a268*a228);
  a310=(a310+a311);
  a310=(a000+a310);
  a311=sin(a310);
  a312=cos(a307);
  a313=(a311*a312);
  a310=cos(a310);
  a314=(a310*a308);
  a313=(a313-a314);
  a314=(a007*a313);
  a306=(a306-a314);
  a315=(a311*a019);
  a306=(a306+a315);
  a316=(a018-a312);
  a317=(a021*a316);
  a317=(a317+a018);
  a318=(a306/a317);
  a319=(a312-a018);
  a320=(a007*a319);
  a321=(a320/a317);
  a322=casadi_sq(a262);
  a322=(a322*a308);
  a322=(a322+a313);
  a323=(a007*a322);
  a324=arg[2]? arg[2][18] : 0;
  a325=(a034*a324);
  a326=arg[2]? arg[2][19] : 0;
  a327=(a039*a326);
  a325=(a325+a327);
  a327=(a033*a325);
  a327=(a305+a327);
  a328=(a030*a327);
  a324=(a039*a324);
  a326=(a034*a326);
  a324=(a324-a326);
  a326=(a324+a018);
  a329=(a031*a326);
  a329=(a038-a329);
  a329=(a329+a307);
  a307=(a037*a329);
  a328=(a328+a307);
  a323=(a323-a328);
  a328=(a321*a306);
  a328=(a323-a328);
  a307=(a320*a321);
  a307=(a007-a307);
  a328=(a328/a307);
  a330=(a321*a328);
  a330=(a318-a330);
  a331=(a304*a330);
  a297=(a297+a331);
  a297=(a003+a297);
  a331=(a295*a297);
  a004=(a004+a331);
  a331=4.4710615727772587e-02;
  a331=(a331*a002);
  a332=2.2733101475165380e+00;
  a332=(a332*a002);
  a333=(a332*a043);
  a334=-1.0534495466737249e+01;
  a334=(a334*a002);
  a130=(a334*a130);
  a333=(a333+a130);
  a130=-2.0008720582248625e+00;
  a130=(a130*a002);
  a160=(a130*a160);
  a333=(a333+a160);
  a160=-1.7958931863118799e+01;
  a160=(a160*a002);
  a335=(a160*a192);
  a333=(a333+a335);
  a335=2.7948884529419960e+01;
  a335=(a335*a002);
  a336=(a335*a225);
  a333=(a333+a336);
  a336=-2.8589982771350235e+00;
  a336=(a336*a002);
  a337=(a336*a259);
  a333=(a333+a337);
  a337=-8.8728569335306293e+00;
  a337=(a337*a002);
  a338=(a337*a294);
  a333=(a333+a338);
  a338=1.2360567175794303e+01;
  a338=(a338*a002);
  a339=(a338*a330);
  a333=(a333+a339);
  a339=6.4339274601576357e-01;
  a339=(a339*a002);
  a340=(a296*a036);
  a341=(a298*a128);
  a340=(a340+a341);
  a341=(a299*a158);
  a340=(a340+a341);
  a341=(a300*a190);
  a340=(a340+a341);
  a341=(a301*a223);
  a340=(a340+a341);
  a341=(a302*a257);
  a340=(a340+a341);
  a341=(a303*a292);
  a340=(a340+a341);
  a341=(a304*a328);
  a340=(a340+a341);
  a340=(a008+a340);
  a341=(a007*a340);
  a342=(a296*a008);
  a343=(a298*a047);
  a342=(a342+a343);
  a343=(a299*a133);
  a342=(a342+a343);
  a343=(a300*a167);
  a342=(a342+a343);
  a343=(a301*a200);
  a342=(a342+a343);
  a343=(a302*a234);
  a342=(a342+a343);
  a343=(a303*a269);
  a342=(a342+a343);
  a343=(a304*a305);
  a342=(a342+a343);
  a342=(a010+a342);
  a343=sin(a342);
  a341=(a341*a343);
  a344=(2.*a297);
  a344=(a340-a344);
  a341=(a341*a344);
  a345=(a296*a003);
  a346=(a298*a106);
  a345=(a345+a346);
  a346=(a299*a139);
  a345=(a345+a346);
  a346=(a300*a044);
  a345=(a345+a346);
  a346=(a301*a163);
  a345=(a345+a346);
  a346=(a302*a195);
  a345=(a345+a346);
  a346=(a303*a228);
  a345=(a345+a346);
  a346=(a304*a262);
  a345=(a345+a346);
  a345=(a000+a345);
  a346=sin(a345);
  a347=cos(a342);
  a348=(a346*a347);
  a345=cos(a345);
  a349=(a345*a343);
  a348=(a348-a349);
  a349=(a007*a348);
  a341=(a341-a349);
  a350=(a346*a019);
  a341=(a341+a350);
  a351=(a018-a347);
  a352=(a021*a351);
  a352=(a352+a018);
  a353=(a341/a352);
  a354=(a347-a018);
  a355=(a007*a354);
  a356=(a355/a352);
  a357=casadi_sq(a297);
  a357=(a357*a343);
  a357=(a357+a348);
  a358=(a007*a357);
  a359=arg[2]? arg[2][20] : 0;
  a360=(a034*a359);
  a361=arg[2]? arg[2][21] : 0;
  a362=(a039*a361);
  a360=(a360+a362);
  a362=(a033*a360);
  a362=(a340+a362);
  a363=(a030*a362);
  a359=(a039*a359);
  a361=(a034*a361);
  a359=(a359-a361);
  a361=(a359+a018);
  a364=(a031*a361);
  a364=(a038-a364);
  a364=(a364+a342);
  a342=(a037*a364);
  a363=(a363+a342);
  a358=(a358-a363);
  a363=(a356*a341);
  a363=(a358-a363);
  a342=(a355*a356);
  a342=(a007-a342);
  a363=(a363/a342);
  a365=(a356*a363);
  a365=(a353-a365);
  a366=(a339*a365);
  a333=(a333+a366);
  a333=(a003+a333);
  a366=(a331*a333);
  a004=(a004+a366);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a366=(a005*a167);
  a004=(a004+a366);
  a366=(a161*a200);
  a004=(a004+a366);
  a366=(a193*a234);
  a004=(a004+a366);
  a366=(a226*a269);
  a004=(a004+a366);
  a366=(a260*a305);
  a004=(a004+a366);
  a366=(a295*a340);
  a004=(a004+a366);
  a366=(a332*a036);
  a367=(a334*a128);
  a366=(a366+a367);
  a367=(a130*a158);
  a366=(a366+a367);
  a367=(a160*a190);
  a366=(a366+a367);
  a367=(a335*a223);
  a366=(a366+a367);
  a367=(a336*a257);
  a366=(a366+a367);
  a367=(a337*a292);
  a366=(a366+a367);
  a367=(a338*a328);
  a366=(a366+a367);
  a367=(a339*a363);
  a366=(a366+a367);
  a366=(a008+a366);
  a367=(a331*a366);
  a004=(a004+a367);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a043=(a001*a043);
  a192=(a005*a192);
  a043=(a043+a192);
  a225=(a161*a225);
  a043=(a043+a225);
  a259=(a193*a259);
  a043=(a043+a259);
  a294=(a226*a294);
  a043=(a043+a294);
  a330=(a260*a330);
  a043=(a043+a330);
  a365=(a295*a365);
  a043=(a043+a365);
  a365=(a007*a366);
  a330=(a332*a008);
  a294=(a334*a047);
  a330=(a330+a294);
  a294=(a130*a133);
  a330=(a330+a294);
  a294=(a160*a167);
  a330=(a330+a294);
  a294=(a335*a200);
  a330=(a330+a294);
  a294=(a336*a234);
  a330=(a330+a294);
  a294=(a337*a269);
  a330=(a330+a294);
  a294=(a338*a305);
  a330=(a330+a294);
  a294=(a339*a340);
  a330=(a330+a294);
  a010=(a010+a330);
  a330=sin(a010);
  a365=(a365*a330);
  a294=(2.*a333);
  a294=(a366-a294);
  a365=(a365*a294);
  a259=(a332*a003);
  a225=(a334*a106);
  a259=(a259+a225);
  a225=(a130*a139);
  a259=(a259+a225);
  a225=(a160*a044);
  a259=(a259+a225);
  a225=(a335*a163);
  a259=(a259+a225);
  a225=(a336*a195);
  a259=(a259+a225);
  a225=(a337*a228);
  a259=(a259+a225);
  a225=(a338*a262);
  a259=(a259+a225);
  a225=(a339*a297);
  a259=(a259+a225);
  a000=(a000+a259);
  a259=sin(a000);
  a225=cos(a010);
  a192=(a259*a225);
  a000=cos(a000);
  a004=(a000*a330);
  a192=(a192-a004);
  a004=(a007*a192);
  a365=(a365-a004);
  a019=(a259*a019);
  a365=(a365+a019);
  a367=(a018-a225);
  a368=(a021*a367);
  a368=(a368+a018);
  a369=(a365/a368);
  a370=(a225-a018);
  a371=(a007*a370);
  a372=(a371/a368);
  a373=casadi_sq(a333);
  a373=(a373*a330);
  a373=(a373+a192);
  a374=(a007*a373);
  a375=arg[2]? arg[2][22] : 0;
  a376=(a034*a375);
  a377=arg[2]? arg[2][23] : 0;
  a378=(a039*a377);
  a376=(a376+a378);
  a378=(a033*a376);
  a378=(a366+a378);
  a379=(a030*a378);
  a375=(a039*a375);
  a377=(a034*a377);
  a375=(a375-a377);
  a018=(a375+a018);
  a377=(a031*a018);
  a038=(a038-a377);
  a038=(a038+a010);
  a010=(a037*a038);
  a379=(a379+a010);
  a374=(a374-a379);
  a379=(a372*a365);
  a379=(a374-a379);
  a010=(a371*a372);
  a010=(a007-a010);
  a379=(a379/a010);
  a377=(a372*a379);
  a377=(a369-a377);
  a377=(a331*a377);
  a043=(a043+a377);
  a043=(a003+a043);
  if (res[0]!=0) res[0][2]=a043;
  a043=(a001*a036);
  a377=(a005*a190);
  a043=(a043+a377);
  a377=(a161*a223);
  a043=(a043+a377);
  a377=(a193*a257);
  a043=(a043+a377);
  a377=(a226*a292);
  a043=(a043+a377);
  a377=(a260*a328);
  a043=(a043+a377);
  a377=(a295*a363);
  a043=(a043+a377);
  a377=(a331*a379);
  a043=(a043+a377);
  a043=(a008+a043);
  if (res[0]!=0) res[0][3]=a043;
  a043=arg[0]? arg[0][4] : 0;
  a377=arg[0]? arg[0][6] : 0;
  a380=(a001*a377);
  a381=(a016*a014);
  a382=(a013*a011);
  a381=(a381+a382);
  a382=(a016-a381);
  a382=(a007*a382);
  a382=(a382+a016);
  a016=(a382/a023);
  a383=(a007*a381);
  a382=(a027*a382);
  a383=(a383-a382);
  a383=(a383/a042);
  a382=(a027*a383);
  a016=(a016-a382);
  a382=(a016*a043);
  a384=(a008*a012);
  a385=(a014*a384);
  a385=(a381+a385);
  a386=(a007*a011);
  a386=(a386*a384);
  a386=(a386-a017);
  a386=(a386+a020);
  a020=(a027*a386);
  a029=(a029-a020);
  a029=(a029/a042);
  a386=(a386/a023);
  a020=(a027*a029);
  a386=(a386-a020);
  a020=(2.*a386);
  a029=(a029-a020);
  a029=(a011*a029);
  a385=(a385+a029);
  a385=(a007*a385);
  a029=(a385/a023);
  a386=(a386*a011);
  a386=(a386-a381);
  a014=(a014*a003);
  a014=(a014*a003);
  a386=(a386+a014);
  a386=(a007*a386);
  a386=(a386-a037);
  a385=(a027*a385);
  a386=(a386-a385);
  a386=(a386/a042);
  a385=(a027*a386);
  a029=(a029-a385);
  a385=arg[0]? arg[0][5] : 0;
  a014=(a029*a385);
  a382=(a382+a014);
  a014=-2.;
  a014=(a014*a007);
  a381=(a014*a008);
  a381=(a381*a011);
  a020=(a381/a023);
  a017=(a021*a003);
  a017=(a017*a011);
  a381=(a027*a381);
  a017=(a017-a381);
  a017=(a017/a042);
  a381=(a027*a017);
  a020=(a020-a381);
  a381=(a020*a377);
  a384=(a021*a011);
  a003=(a008-a003);
  a384=(a384*a003);
  a003=(a384/a023);
  a384=(a027*a384);
  a384=(a030+a384);
  a384=(a384/a042);
  a387=(a027*a384);
  a003=(a003+a387);
  a387=arg[0]? arg[0][7] : 0;
  a388=(a003*a387);
  a381=(a381+a388);
  a382=(a382+a381);
  a381=(a006*a382);
  a388=(a110*a112);
  a389=(a111*a105);
  a388=(a388+a389);
  a389=(a110-a388);
  a389=(a007*a389);
  a389=(a389+a110);
  a110=(a389/a117);
  a390=(a007*a388);
  a389=(a121*a389);
  a390=(a390-a389);
  a390=(a390/a104);
  a389=(a121*a390);
  a110=(a110-a389);
  a389=(a046*a377);
  a391=(a049*a382);
  a392=(a059*a061);
  a393=(a060*a056);
  a392=(a392+a393);
  a393=(a059-a392);
  a393=(a007*a393);
  a393=(a393+a059);
  a059=(a393/a066);
  a394=(a007*a392);
  a393=(a070*a393);
  a394=(a394-a393);
  a394=(a394/a055);
  a393=(a070*a394);
  a059=(a059-a393);
  a393=(a052*a377);
  a393=(a043+a393);
  a395=(a059*a393);
  a396=(a053*a058);
  a397=(a061*a396);
  a397=(a392+a397);
  a398=(a007*a056);
  a398=(a398*a396);
  a398=(a398-a063);
  a398=(a398+a064);
  a064=(a070*a398);
  a072=(a072-a064);
  a072=(a072/a055);
  a398=(a398/a066);
  a064=(a070*a072);
  a398=(a398-a064);
  a064=(2.*a398);
  a072=(a072-a064);
  a072=(a056*a072);
  a397=(a397+a072);
  a397=(a007*a397);
  a072=(a397/a066);
  a398=(a398*a056);
  a398=(a398-a392);
  a061=(a061*a057);
  a061=(a061*a057);
  a398=(a398+a061);
  a398=(a007*a398);
  a398=(a398-a037);
  a397=(a070*a397);
  a398=(a398-a397);
  a398=(a398/a055);
  a397=(a070*a398);
  a072=(a072-a397);
  a397=(a052*a387);
  a397=(a385+a397);
  a061=(a072*a397);
  a395=(a395+a061);
  a061=(a014*a053);
  a061=(a061*a056);
  a392=(a061/a066);
  a064=(a021*a057);
  a064=(a064*a056);
  a061=(a070*a061);
  a064=(a064-a061);
  a064=(a064/a055);
  a061=(a070*a064);
  a392=(a392-a061);
  a061=(a052*a382);
  a061=(a377+a061);
  a063=(a392*a061);
  a396=(a021*a056);
  a057=(a053-a057);
  a396=(a396*a057);
  a057=(a396/a066);
  a396=(a070*a396);
  a396=(a030+a396);
  a396=(a396/a055);
  a399=(a070*a396);
  a057=(a057+a399);
  a399=(a383*a043);
  a400=(a386*a385);
  a399=(a399+a400);
  a400=(a017*a377);
  a401=(a384*a387);
  a400=(a400-a401);
  a399=(a399+a400);
  a400=(a052*a399);
  a400=(a387+a400);
  a401=(a057*a400);
  a063=(a063+a401);
  a395=(a395+a063);
  a395=(a051*a395);
  a391=(a391+a395);
  a391=(a377+a391);
  a395=(a048*a391);
  a389=(a389+a395);
  a389=(a043+a389);
  a395=(a110*a389);
  a063=(a047*a109);
  a401=(a112*a063);
  a401=(a388+a401);
  a402=(a007*a105);
  a402=(a402*a063);
  a402=(a402-a114);
  a402=(a402+a115);
  a115=(a121*a402);
  a123=(a123-a115);
  a123=(a123/a104);
  a402=(a402/a117);
  a115=(a121*a123);
  a402=(a402-a115);
  a115=(2.*a402);
  a123=(a123-a115);
  a123=(a105*a123);
  a401=(a401+a123);
  a401=(a007*a401);
  a123=(a401/a117);
  a402=(a402*a105);
  a402=(a402-a388);
  a112=(a112*a106);
  a112=(a112*a106);
  a402=(a402+a112);
  a402=(a007*a402);
  a402=(a402-a037);
  a401=(a121*a401);
  a402=(a402-a401);
  a402=(a402/a104);
  a401=(a121*a402);
  a123=(a123-a401);
  a401=(a046*a387);
  a112=(a049*a399);
  a393=(a394*a393);
  a397=(a398*a397);
  a393=(a393+a397);
  a397=(a064*a061);
  a388=(a396*a400);
  a397=(a397-a388);
  a393=(a393+a397);
  a393=(a051*a393);
  a112=(a112+a393);
  a112=(a387+a112);
  a393=(a048*a112);
  a401=(a401+a393);
  a401=(a385+a401);
  a393=(a123*a401);
  a395=(a395+a393);
  a393=(a014*a047);
  a393=(a393*a105);
  a397=(a393/a117);
  a388=(a021*a106);
  a388=(a388*a105);
  a393=(a121*a393);
  a388=(a388-a393);
  a388=(a388/a104);
  a393=(a121*a388);
  a397=(a397-a393);
  a393=(a046*a382);
  a115=(a082*a084);
  a114=(a083*a081);
  a115=(a115+a114);
  a114=(a082-a115);
  a114=(a007*a114);
  a114=(a114+a082);
  a082=(a114/a095);
  a063=(a007*a115);
  a114=(a096*a114);
  a063=(a063-a114);
  a063=(a063/a102);
  a114=(a096*a063);
  a082=(a082-a114);
  a114=(a049*a377);
  a061=(a051*a061);
  a114=(a114+a061);
  a114=(a043+a114);
  a061=(a082*a114);
  a403=(a087*a098);
  a404=(a084*a403);
  a404=(a115+a404);
  a405=(a007*a081);
  a405=(a405*a403);
  a405=(a405-a099);
  a405=(a405+a100);
  a100=(a096*a405);
  a086=(a086-a100);
  a086=(a086/a102);
  a405=(a405/a095);
  a100=(a096*a086);
  a405=(a405-a100);
  a100=(2.*a405);
  a086=(a086-a100);
  a086=(a081*a086);
  a404=(a404+a086);
  a404=(a007*a404);
  a086=(a404/a095);
  a405=(a405*a081);
  a405=(a405-a115);
  a084=(a084*a050);
  a084=(a084*a050);
  a405=(a405+a084);
  a405=(a007*a405);
  a405=(a405-a037);
  a404=(a096*a404);
  a405=(a405-a404);
  a405=(a405/a102);
  a404=(a096*a405);
  a086=(a086-a404);
  a404=(a049*a387);
  a400=(a051*a400);
  a404=(a404+a400);
  a404=(a385+a404);
  a400=(a086*a404);
  a061=(a061+a400);
  a400=(a014*a087);
  a400=(a400*a081);
  a084=(a400/a095);
  a115=(a021*a050);
  a115=(a115*a081);
  a400=(a096*a400);
  a115=(a115-a400);
  a115=(a115/a102);
  a400=(a096*a115);
  a084=(a084-a400);
  a400=(a084*a391);
  a100=(a021*a081);
  a050=(a087-a050);
  a100=(a100*a050);
  a050=(a100/a095);
  a100=(a096*a100);
  a100=(a030+a100);
  a100=(a100/a102);
  a099=(a096*a100);
  a050=(a050+a099);
  a099=(a050*a112);
  a400=(a400+a099);
  a061=(a061+a400);
  a400=(a048*a061);
  a393=(a393+a400);
  a393=(a377+a393);
  a400=(a397*a393);
  a099=(a021*a105);
  a106=(a047-a106);
  a099=(a099*a106);
  a106=(a099/a117);
  a099=(a121*a099);
  a099=(a030+a099);
  a099=(a099/a104);
  a403=(a121*a099);
  a106=(a106+a403);
  a403=(a046*a399);
  a114=(a063*a114);
  a404=(a405*a404);
  a114=(a114+a404);
  a404=(a115*a391);
  a406=(a100*a112);
  a404=(a404-a406);
  a114=(a114+a404);
  a404=(a048*a114);
  a403=(a403+a404);
  a403=(a387+a403);
  a404=(a106*a403);
  a400=(a400+a404);
  a395=(a395+a400);
  a400=(a045*a395);
  a381=(a381+a400);
  a400=(a140*a142);
  a404=(a141*a138);
  a400=(a400+a404);
  a404=(a140-a400);
  a404=(a007*a404);
  a404=(a404+a140);
  a140=(a404/a147);
  a406=(a007*a400);
  a404=(a151*a404);
  a406=(a406-a404);
  a406=(a406/a137);
  a404=(a151*a406);
  a140=(a140-a404);
  a404=(a132*a377);
  a391=(a134*a391);
  a404=(a404+a391);
  a391=(a135*a393);
  a404=(a404+a391);
  a404=(a043+a404);
  a391=(a140*a404);
  a407=(a133*a108);
  a408=(a142*a407);
  a408=(a400+a408);
  a409=(a007*a138);
  a409=(a409*a407);
  a409=(a409-a144);
  a409=(a409+a145);
  a145=(a151*a409);
  a153=(a153-a145);
  a153=(a153/a137);
  a409=(a409/a147);
  a145=(a151*a153);
  a409=(a409-a145);
  a145=(2.*a409);
  a153=(a153-a145);
  a153=(a138*a153);
  a408=(a408+a153);
  a408=(a007*a408);
  a153=(a408/a147);
  a409=(a409*a138);
  a409=(a409-a400);
  a142=(a142*a139);
  a142=(a142*a139);
  a409=(a409+a142);
  a409=(a007*a409);
  a409=(a409-a037);
  a408=(a151*a408);
  a409=(a409-a408);
  a409=(a409/a137);
  a408=(a151*a409);
  a153=(a153-a408);
  a408=(a132*a387);
  a112=(a134*a112);
  a408=(a408+a112);
  a112=(a135*a403);
  a408=(a408+a112);
  a408=(a385+a408);
  a112=(a153*a408);
  a391=(a391+a112);
  a112=(a014*a133);
  a112=(a112*a138);
  a142=(a112/a147);
  a400=(a021*a139);
  a400=(a400*a138);
  a112=(a151*a112);
  a400=(a400-a112);
  a400=(a400/a137);
  a112=(a151*a400);
  a142=(a142-a112);
  a112=(a132*a382);
  a061=(a134*a061);
  a112=(a112+a061);
  a061=(a135*a395);
  a112=(a112+a061);
  a112=(a377+a112);
  a061=(a142*a112);
  a145=(a021*a138);
  a139=(a133-a139);
  a145=(a145*a139);
  a139=(a145/a147);
  a145=(a151*a145);
  a145=(a030+a145);
  a145=(a145/a137);
  a144=(a151*a145);
  a139=(a139+a144);
  a144=(a132*a399);
  a114=(a134*a114);
  a144=(a144+a114);
  a389=(a390*a389);
  a401=(a402*a401);
  a389=(a389+a401);
  a401=(a388*a393);
  a114=(a099*a403);
  a401=(a401-a114);
  a389=(a389+a401);
  a401=(a135*a389);
  a144=(a144+a401);
  a144=(a387+a144);
  a401=(a139*a144);
  a061=(a061+a401);
  a391=(a391+a061);
  a061=(a131*a391);
  a381=(a381+a061);
  a381=(a377+a381);
  a061=(a005*a381);
  a380=(a380+a061);
  a061=(a162*a382);
  a401=(a164*a395);
  a061=(a061+a401);
  a401=(a165*a391);
  a061=(a061+a401);
  a401=(a172*a174);
  a114=(a173*a170);
  a401=(a401+a114);
  a114=(a172-a401);
  a114=(a007*a114);
  a114=(a114+a172);
  a172=(a114/a179);
  a407=(a007*a401);
  a114=(a183*a114);
  a407=(a407-a114);
  a407=(a407/a169);
  a114=(a183*a407);
  a172=(a172-a114);
  a114=(a006*a377);
  a410=(a045*a393);
  a114=(a114+a410);
  a410=(a131*a112);
  a114=(a114+a410);
  a114=(a043+a114);
  a410=(a172*a114);
  a411=(a167*a171);
  a412=(a174*a411);
  a412=(a401+a412);
  a413=(a007*a170);
  a413=(a413*a411);
  a413=(a413-a176);
  a413=(a413+a177);
  a177=(a183*a413);
  a185=(a185-a177);
  a185=(a185/a169);
  a413=(a413/a179);
  a177=(a183*a185);
  a413=(a413-a177);
  a177=(2.*a413);
  a185=(a185-a177);
  a185=(a170*a185);
  a412=(a412+a185);
  a412=(a007*a412);
  a185=(a412/a179);
  a413=(a413*a170);
  a413=(a413-a401);
  a174=(a174*a044);
  a174=(a174*a044);
  a413=(a413+a174);
  a413=(a007*a413);
  a413=(a413-a037);
  a412=(a183*a412);
  a413=(a413-a412);
  a413=(a413/a169);
  a412=(a183*a413);
  a185=(a185-a412);
  a412=(a006*a387);
  a174=(a045*a403);
  a412=(a412+a174);
  a174=(a131*a144);
  a412=(a412+a174);
  a412=(a385+a412);
  a174=(a185*a412);
  a410=(a410+a174);
  a174=(a014*a167);
  a174=(a174*a170);
  a401=(a174/a179);
  a177=(a021*a044);
  a177=(a177*a170);
  a174=(a183*a174);
  a177=(a177-a174);
  a177=(a177/a169);
  a174=(a183*a177);
  a401=(a401-a174);
  a174=(a401*a381);
  a176=(a021*a170);
  a044=(a167-a044);
  a176=(a176*a044);
  a044=(a176/a179);
  a176=(a183*a176);
  a176=(a030+a176);
  a176=(a176/a169);
  a411=(a183*a176);
  a044=(a044+a411);
  a411=(a006*a399);
  a414=(a045*a389);
  a411=(a411+a414);
  a404=(a406*a404);
  a408=(a409*a408);
  a404=(a404+a408);
  a408=(a400*a112);
  a414=(a145*a144);
  a408=(a408-a414);
  a404=(a404+a408);
  a408=(a131*a404);
  a411=(a411+a408);
  a411=(a387+a411);
  a408=(a044*a411);
  a174=(a174+a408);
  a410=(a410+a174);
  a174=(a166*a410);
  a061=(a061+a174);
  a061=(a377+a061);
  a174=(a161*a061);
  a380=(a380+a174);
  a174=(a194*a382);
  a408=(a196*a395);
  a174=(a174+a408);
  a408=(a197*a391);
  a174=(a174+a408);
  a408=(a198*a410);
  a174=(a174+a408);
  a408=(a205*a207);
  a414=(a206*a203);
  a408=(a408+a414);
  a414=(a205-a408);
  a414=(a007*a414);
  a414=(a414+a205);
  a205=(a414/a212);
  a415=(a007*a408);
  a414=(a216*a414);
  a415=(a415-a414);
  a415=(a415/a202);
  a414=(a216*a415);
  a205=(a205-a414);
  a414=(a162*a377);
  a416=(a164*a393);
  a414=(a414+a416);
  a416=(a165*a112);
  a414=(a414+a416);
  a416=(a166*a381);
  a414=(a414+a416);
  a414=(a043+a414);
  a416=(a205*a414);
  a417=(a200*a204);
  a418=(a207*a417);
  a418=(a408+a418);
  a419=(a007*a203);
  a419=(a419*a417);
  a419=(a419-a209);
  a419=(a419+a210);
  a210=(a216*a419);
  a218=(a218-a210);
  a218=(a218/a202);
  a419=(a419/a212);
  a210=(a216*a218);
  a419=(a419-a210);
  a210=(2.*a419);
  a218=(a218-a210);
  a218=(a203*a218);
  a418=(a418+a218);
  a418=(a007*a418);
  a218=(a418/a212);
  a419=(a419*a203);
  a419=(a419-a408);
  a207=(a207*a163);
  a207=(a207*a163);
  a419=(a419+a207);
  a419=(a007*a419);
  a419=(a419-a037);
  a418=(a216*a418);
  a419=(a419-a418);
  a419=(a419/a202);
  a418=(a216*a419);
  a218=(a218-a418);
  a418=(a162*a387);
  a207=(a164*a403);
  a418=(a418+a207);
  a207=(a165*a144);
  a418=(a418+a207);
  a207=(a166*a411);
  a418=(a418+a207);
  a418=(a385+a418);
  a207=(a218*a418);
  a416=(a416+a207);
  a207=(a014*a200);
  a207=(a207*a203);
  a408=(a207/a212);
  a210=(a021*a163);
  a210=(a210*a203);
  a207=(a216*a207);
  a210=(a210-a207);
  a210=(a210/a202);
  a207=(a216*a210);
  a408=(a408-a207);
  a207=(a408*a061);
  a209=(a021*a203);
  a163=(a200-a163);
  a209=(a209*a163);
  a163=(a209/a212);
  a209=(a216*a209);
  a209=(a030+a209);
  a209=(a209/a202);
  a417=(a216*a209);
  a163=(a163+a417);
  a417=(a162*a399);
  a420=(a164*a389);
  a417=(a417+a420);
  a420=(a165*a404);
  a417=(a417+a420);
  a114=(a407*a114);
  a412=(a413*a412);
  a114=(a114+a412);
  a412=(a177*a381);
  a420=(a176*a411);
  a412=(a412-a420);
  a114=(a114+a412);
  a412=(a166*a114);
  a417=(a417+a412);
  a417=(a387+a417);
  a412=(a163*a417);
  a207=(a207+a412);
  a416=(a416+a207);
  a207=(a199*a416);
  a174=(a174+a207);
  a174=(a377+a174);
  a207=(a193*a174);
  a380=(a380+a207);
  a207=(a227*a382);
  a412=(a229*a395);
  a207=(a207+a412);
  a412=(a230*a391);
  a207=(a207+a412);
  a412=(a231*a410);
  a207=(a207+a412);
  a412=(a232*a416);
  a207=(a207+a412);
  a412=(a239*a241);
  a420=(a240*a237);
  a412=(a412+a420);
  a420=(a239-a412);
  a420=(a007*a420);
  a420=(a420+a239);
  a239=(a420/a246);
  a421=(a007*a412);
  a420=(a250*a420);
  a421=(a421-a420);
  a421=(a421/a236);
  a420=(a250*a421);
  a239=(a239-a420);
  a420=(a194*a377);
  a422=(a196*a393);
  a420=(a420+a422);
  a422=(a197*a112);
  a420=(a420+a422);
  a422=(a198*a381);
  a420=(a420+a422);
  a422=(a199*a061);
  a420=(a420+a422);
  a420=(a043+a420);
  a422=(a239*a420);
  a423=(a234*a238);
  a424=(a241*a423);
  a424=(a412+a424);
  a425=(a007*a237);
  a425=(a425*a423);
  a425=(a425-a243);
  a425=(a425+a244);
  a244=(a250*a425);
  a252=(a252-a244);
  a252=(a252/a236);
  a425=(a425/a246);
  a244=(a250*a252);
  a425=(a425-a244);
  a244=(2.*a425);
  a252=(a252-a244);
  a252=(a237*a252);
  a424=(a424+a252);
  a424=(a007*a424);
  a252=(a424/a246);
  a425=(a425*a237);
  a425=(a425-a412);
  a241=(a241*a195);
  a241=(a241*a195);
  a425=(a425+a241);
  a425=(a007*a425);
  a425=(a425-a037);
  a424=(a250*a424);
  a425=(a425-a424);
  a425=(a425/a236);
  a424=(a250*a425);
  a252=(a252-a424);
  a424=(a194*a387);
  a241=(a196*a403);
  a424=(a424+a241);
  a241=(a197*a144);
  a424=(a424+a241);
  a241=(a198*a411);
  a424=(a424+a241);
  a241=(a199*a417);
  a424=(a424+a241);
  a424=(a385+a424);
  a241=(a252*a424);
  a422=(a422+a241);
  a241=(a014*a234);
  a241=(a241*a237);
  a412=(a241/a246);
  a244=(a021*a195);
  a244=(a244*a237);
  a241=(a250*a241);
  a244=(a244-a241);
  a244=(a244/a236);
  a241=(a250*a244);
  a412=(a412-a241);
  a241=(a412*a174);
  a243=(a021*a237);
  a195=(a234-a195);
  a243=(a243*a195);
  a195=(a243/a246);
  a243=(a250*a243);
  a243=(a030+a243);
  a243=(a243/a236);
  a423=(a250*a243);
  a195=(a195+a423);
  a423=(a194*a399);
  a426=(a196*a389);
  a423=(a423+a426);
  a426=(a197*a404);
  a423=(a423+a426);
  a426=(a198*a114);
  a423=(a423+a426);
  a414=(a415*a414);
  a418=(a419*a418);
  a414=(a414+a418);
  a418=(a210*a061);
  a426=(a209*a417);
  a418=(a418-a426);
  a414=(a414+a418);
  a418=(a199*a414);
  a423=(a423+a418);
  a423=(a387+a423);
  a418=(a195*a423);
  a241=(a241+a418);
  a422=(a422+a241);
  a241=(a233*a422);
  a207=(a207+a241);
  a207=(a377+a207);
  a241=(a226*a207);
  a380=(a380+a241);
  a241=(a261*a382);
  a418=(a263*a395);
  a241=(a241+a418);
  a418=(a264*a391);
  a241=(a241+a418);
  a418=(a265*a410);
  a241=(a241+a418);
  a418=(a266*a416);
  a241=(a241+a418);
  a418=(a267*a422);
  a241=(a241+a418);
  a418=(a274*a276);
  a426=(a275*a272);
  a418=(a418+a426);
  a426=(a274-a418);
  a426=(a007*a426);
  a426=(a426+a274);
  a274=(a426/a281);
  a427=(a007*a418);
  a426=(a285*a426);
  a427=(a427-a426);
  a427=(a427/a271);
  a426=(a285*a427);
  a274=(a274-a426);
  a426=(a227*a377);
  a428=(a229*a393);
  a426=(a426+a428);
  a428=(a230*a112);
  a426=(a426+a428);
  a428=(a231*a381);
  a426=(a426+a428);
  a428=(a232*a061);
  a426=(a426+a428);
  a428=(a233*a174);
  a426=(a426+a428);
  a426=(a043+a426);
  a428=(a274*a426);
  a429=(a269*a273);
  a430=(a276*a429);
  a430=(a418+a430);
  a431=(a007*a272);
  a431=(a431*a429);
  a431=(a431-a278);
  a431=(a431+a279);
  a279=(a285*a431);
  a287=(a287-a279);
  a287=(a287/a271);
  a431=(a431/a281);
  a279=(a285*a287);
  a431=(a431-a279);
  a279=(2.*a431);
  a287=(a287-a279);
  a287=(a272*a287);
  a430=(a430+a287);
  a430=(a007*a430);
  a287=(a430/a281);
  a431=(a431*a272);
  a431=(a431-a418);
  a276=(a276*a228);
  a276=(a276*a228);
  a431=(a431+a276);
  a431=(a007*a431);
  a431=(a431-a037);
  a430=(a285*a430);
  a431=(a431-a430);
  a431=(a431/a271);
  a430=(a285*a431);
  a287=(a287-a430);
  a430=(a227*a387);
  a276=(a229*a403);
  a430=(a430+a276);
  a276=(a230*a144);
  a430=(a430+a276);
  a276=(a231*a411);
  a430=(a430+a276);
  a276=(a232*a417);
  a430=(a430+a276);
  a276=(a233*a423);
  a430=(a430+a276);
  a430=(a385+a430);
  a276=(a287*a430);
  a428=(a428+a276);
  a276=(a014*a269);
  a276=(a276*a272);
  a418=(a276/a281);
  a279=(a021*a228);
  a279=(a279*a272);
  a276=(a285*a276);
  a279=(a279-a276);
  a279=(a279/a271);
  a276=(a285*a279);
  a418=(a418-a276);
  a276=(a418*a207);
  a278=(a021*a272);
  a228=(a269-a228);
  a278=(a278*a228);
  a228=(a278/a281);
  a278=(a285*a278);
  a278=(a030+a278);
  a278=(a278/a271);
  a429=(a285*a278);
  a228=(a228+a429);
  a429=(a227*a399);
  a432=(a229*a389);
  a429=(a429+a432);
  a432=(a230*a404);
  a429=(a429+a432);
  a432=(a231*a114);
  a429=(a429+a432);
  a432=(a232*a414);
  a429=(a429+a432);
  a420=(a421*a420);
  a424=(a425*a424);
  a420=(a420+a424);
  a424=(a244*a174);
  a432=(a243*a423);
  a424=(a424-a432);
  a420=(a420+a424);
  a424=(a233*a420);
  a429=(a429+a424);
  a429=(a387+a429);
  a424=(a228*a429);
  a276=(a276+a424);
  a428=(a428+a276);
  a276=(a268*a428);
  a241=(a241+a276);
  a241=(a377+a241);
  a276=(a260*a241);
  a380=(a380+a276);
  a276=(a296*a382);
  a424=(a298*a395);
  a276=(a276+a424);
  a424=(a299*a391);
  a276=(a276+a424);
  a424=(a300*a410);
  a276=(a276+a424);
  a424=(a301*a416);
  a276=(a276+a424);
  a424=(a302*a422);
  a276=(a276+a424);
  a424=(a303*a428);
  a276=(a276+a424);
  a424=(a310*a312);
  a432=(a311*a308);
  a424=(a424+a432);
  a432=(a310-a424);
  a432=(a007*a432);
  a432=(a432+a310);
  a310=(a432/a317);
  a433=(a007*a424);
  a432=(a321*a432);
  a433=(a433-a432);
  a433=(a433/a307);
  a432=(a321*a433);
  a310=(a310-a432);
  a432=(a261*a377);
  a434=(a263*a393);
  a432=(a432+a434);
  a434=(a264*a112);
  a432=(a432+a434);
  a434=(a265*a381);
  a432=(a432+a434);
  a434=(a266*a061);
  a432=(a432+a434);
  a434=(a267*a174);
  a432=(a432+a434);
  a434=(a268*a207);
  a432=(a432+a434);
  a432=(a043+a432);
  a434=(a310*a432);
  a435=(a305*a309);
  a436=(a312*a435);
  a436=(a424+a436);
  a437=(a007*a308);
  a437=(a437*a435);
  a437=(a437-a314);
  a437=(a437+a315);
  a315=(a321*a437);
  a323=(a323-a315);
  a323=(a323/a307);
  a437=(a437/a317);
  a315=(a321*a323);
  a437=(a437-a315);
  a315=(2.*a437);
  a323=(a323-a315);
  a323=(a308*a323);
  a436=(a436+a323);
  a436=(a007*a436);
  a323=(a436/a317);
  a437=(a437*a308);
  a437=(a437-a424);
  a312=(a312*a262);
  a312=(a312*a262);
  a437=(a437+a312);
  a437=(a007*a437);
  a437=(a437-a037);
  a436=(a321*a436);
  a437=(a437-a436);
  a437=(a437/a307);
  a436=(a321*a437);
  a323=(a323-a436);
  a436=(a261*a387);
  a312=(a263*a403);
  a436=(a436+a312);
  a312=(a264*a144);
  a436=(a436+a312);
  a312=(a265*a411);
  a436=(a436+a312);
  a312=(a266*a417);
  a436=(a436+a312);
  a312=(a267*a423);
  a436=(a436+a312);
  a312=(a268*a429);
  a436=(a436+a312);
  a436=(a385+a436);
  a312=(a323*a436);
  a434=(a434+a312);
  a312=(a014*a305);
  a312=(a312*a308);
  a424=(a312/a317);
  a315=(a021*a262);
  a315=(a315*a308);
  a312=(a321*a312);
  a315=(a315-a312);
  a315=(a315/a307);
  a312=(a321*a315);
  a424=(a424-a312);
  a312=(a424*a241);
  a314=(a021*a308);
  a262=(a305-a262);
  a314=(a314*a262);
  a262=(a314/a317);
  a314=(a321*a314);
  a314=(a030+a314);
  a314=(a314/a307);
  a435=(a321*a314);
  a262=(a262+a435);
  a435=(a261*a399);
  a438=(a263*a389);
  a435=(a435+a438);
  a438=(a264*a404);
  a435=(a435+a438);
  a438=(a265*a114);
  a435=(a435+a438);
  a438=(a266*a414);
  a435=(a435+a438);
  a438=(a267*a420);
  a435=(a435+a438);
  a426=(a427*a426);
  a430=(a431*a430);
  a426=(a426+a430);
  a430=(a279*a207);
  a438=(a278*a429);
  a430=(a430-a438);
  a426=(a426+a430);
  a430=(a268*a426);
  a435=(a435+a430);
  a435=(a387+a435);
  a430=(a262*a435);
  a312=(a312+a430);
  a434=(a434+a312);
  a312=(a304*a434);
  a276=(a276+a312);
  a276=(a377+a276);
  a312=(a295*a276);
  a380=(a380+a312);
  a312=(a332*a382);
  a395=(a334*a395);
  a312=(a312+a395);
  a391=(a130*a391);
  a312=(a312+a391);
  a391=(a160*a410);
  a312=(a312+a391);
  a391=(a335*a416);
  a312=(a312+a391);
  a391=(a336*a422);
  a312=(a312+a391);
  a391=(a337*a428);
  a312=(a312+a391);
  a391=(a338*a434);
  a312=(a312+a391);
  a391=(a345*a347);
  a395=(a346*a343);
  a391=(a391+a395);
  a395=(a345-a391);
  a395=(a007*a395);
  a395=(a395+a345);
  a345=(a395/a352);
  a430=(a007*a391);
  a395=(a356*a395);
  a430=(a430-a395);
  a430=(a430/a342);
  a395=(a356*a430);
  a345=(a345-a395);
  a395=(a296*a377);
  a438=(a298*a393);
  a395=(a395+a438);
  a438=(a299*a112);
  a395=(a395+a438);
  a438=(a300*a381);
  a395=(a395+a438);
  a438=(a301*a061);
  a395=(a395+a438);
  a438=(a302*a174);
  a395=(a395+a438);
  a438=(a303*a207);
  a395=(a395+a438);
  a438=(a304*a241);
  a395=(a395+a438);
  a395=(a043+a395);
  a438=(a345*a395);
  a439=(a340*a344);
  a440=(a347*a439);
  a440=(a391+a440);
  a441=(a007*a343);
  a441=(a441*a439);
  a441=(a441-a349);
  a441=(a441+a350);
  a350=(a356*a441);
  a358=(a358-a350);
  a358=(a358/a342);
  a441=(a441/a352);
  a350=(a356*a358);
  a441=(a441-a350);
  a350=(2.*a441);
  a358=(a358-a350);
  a358=(a343*a358);
  a440=(a440+a358);
  a440=(a007*a440);
  a358=(a440/a352);
  a441=(a441*a343);
  a441=(a441-a391);
  a347=(a347*a297);
  a347=(a347*a297);
  a441=(a441+a347);
  a441=(a007*a441);
  a441=(a441-a037);
  a440=(a356*a440);
  a441=(a441-a440);
  a441=(a441/a342);
  a440=(a356*a441);
  a358=(a358-a440);
  a440=(a296*a387);
  a347=(a298*a403);
  a440=(a440+a347);
  a347=(a299*a144);
  a440=(a440+a347);
  a347=(a300*a411);
  a440=(a440+a347);
  a347=(a301*a417);
  a440=(a440+a347);
  a347=(a302*a423);
  a440=(a440+a347);
  a347=(a303*a429);
  a440=(a440+a347);
  a347=(a304*a435);
  a440=(a440+a347);
  a440=(a385+a440);
  a347=(a358*a440);
  a438=(a438+a347);
  a347=(a014*a340);
  a347=(a347*a343);
  a391=(a347/a352);
  a350=(a021*a297);
  a350=(a350*a343);
  a347=(a356*a347);
  a350=(a350-a347);
  a350=(a350/a342);
  a347=(a356*a350);
  a391=(a391-a347);
  a347=(a391*a276);
  a349=(a021*a343);
  a297=(a340-a297);
  a349=(a349*a297);
  a297=(a349/a352);
  a349=(a356*a349);
  a349=(a030+a349);
  a349=(a349/a342);
  a439=(a356*a349);
  a297=(a297+a439);
  a439=(a296*a399);
  a442=(a298*a389);
  a439=(a439+a442);
  a442=(a299*a404);
  a439=(a439+a442);
  a442=(a300*a114);
  a439=(a439+a442);
  a442=(a301*a414);
  a439=(a439+a442);
  a442=(a302*a420);
  a439=(a439+a442);
  a442=(a303*a426);
  a439=(a439+a442);
  a432=(a433*a432);
  a436=(a437*a436);
  a432=(a432+a436);
  a436=(a315*a241);
  a442=(a314*a435);
  a436=(a436-a442);
  a432=(a432+a436);
  a436=(a304*a432);
  a439=(a439+a436);
  a439=(a387+a439);
  a436=(a297*a439);
  a347=(a347+a436);
  a438=(a438+a347);
  a347=(a339*a438);
  a312=(a312+a347);
  a312=(a377+a312);
  a347=(a331*a312);
  a380=(a380+a347);
  a380=(a043+a380);
  if (res[0]!=0) res[0][4]=a380;
  a380=(a001*a387);
  a347=(a005*a411);
  a380=(a380+a347);
  a347=(a161*a417);
  a380=(a380+a347);
  a347=(a193*a423);
  a380=(a380+a347);
  a347=(a226*a429);
  a380=(a380+a347);
  a347=(a260*a435);
  a380=(a380+a347);
  a347=(a295*a439);
  a380=(a380+a347);
  a347=(a332*a399);
  a389=(a334*a389);
  a347=(a347+a389);
  a404=(a130*a404);
  a347=(a347+a404);
  a404=(a160*a114);
  a347=(a347+a404);
  a404=(a335*a414);
  a347=(a347+a404);
  a404=(a336*a420);
  a347=(a347+a404);
  a404=(a337*a426);
  a347=(a347+a404);
  a404=(a338*a432);
  a347=(a347+a404);
  a395=(a430*a395);
  a440=(a441*a440);
  a395=(a395+a440);
  a440=(a350*a276);
  a404=(a349*a439);
  a440=(a440-a404);
  a395=(a395+a440);
  a440=(a339*a395);
  a347=(a347+a440);
  a347=(a387+a347);
  a440=(a331*a347);
  a380=(a380+a440);
  a380=(a385+a380);
  if (res[0]!=0) res[0][5]=a380;
  a382=(a001*a382);
  a410=(a005*a410);
  a382=(a382+a410);
  a416=(a161*a416);
  a382=(a382+a416);
  a422=(a193*a422);
  a382=(a382+a422);
  a428=(a226*a428);
  a382=(a382+a428);
  a434=(a260*a434);
  a382=(a382+a434);
  a438=(a295*a438);
  a382=(a382+a438);
  a438=(a000*a225);
  a434=(a259*a330);
  a438=(a438+a434);
  a434=(a000-a438);
  a434=(a007*a434);
  a434=(a434+a000);
  a000=(a434/a368);
  a428=(a007*a438);
  a434=(a372*a434);
  a428=(a428-a434);
  a428=(a428/a010);
  a434=(a372*a428);
  a000=(a000-a434);
  a434=(a332*a377);
  a393=(a334*a393);
  a434=(a434+a393);
  a112=(a130*a112);
  a434=(a434+a112);
  a381=(a160*a381);
  a434=(a434+a381);
  a061=(a335*a061);
  a434=(a434+a061);
  a174=(a336*a174);
  a434=(a434+a174);
  a207=(a337*a207);
  a434=(a434+a207);
  a241=(a338*a241);
  a434=(a434+a241);
  a276=(a339*a276);
  a434=(a434+a276);
  a043=(a043+a434);
  a434=(a000*a043);
  a276=(a366*a294);
  a241=(a225*a276);
  a241=(a438+a241);
  a207=(a007*a330);
  a207=(a207*a276);
  a207=(a207-a004);
  a207=(a207+a019);
  a019=(a372*a207);
  a374=(a374-a019);
  a374=(a374/a010);
  a207=(a207/a368);
  a019=(a372*a374);
  a207=(a207-a019);
  a019=(2.*a207);
  a374=(a374-a019);
  a374=(a330*a374);
  a241=(a241+a374);
  a241=(a007*a241);
  a374=(a241/a368);
  a207=(a207*a330);
  a207=(a207-a438);
  a225=(a225*a333);
  a225=(a225*a333);
  a207=(a207+a225);
  a007=(a007*a207);
  a007=(a007-a037);
  a241=(a372*a241);
  a007=(a007-a241);
  a007=(a007/a010);
  a241=(a372*a007);
  a374=(a374-a241);
  a241=(a332*a387);
  a403=(a334*a403);
  a241=(a241+a403);
  a144=(a130*a144);
  a241=(a241+a144);
  a411=(a160*a411);
  a241=(a241+a411);
  a417=(a335*a417);
  a241=(a241+a417);
  a423=(a336*a423);
  a241=(a241+a423);
  a429=(a337*a429);
  a241=(a241+a429);
  a435=(a338*a435);
  a241=(a241+a435);
  a439=(a339*a439);
  a241=(a241+a439);
  a385=(a385+a241);
  a241=(a374*a385);
  a434=(a434+a241);
  a014=(a014*a366);
  a014=(a014*a330);
  a241=(a014/a368);
  a439=(a021*a333);
  a439=(a439*a330);
  a014=(a372*a014);
  a439=(a439-a014);
  a439=(a439/a010);
  a014=(a372*a439);
  a241=(a241-a014);
  a014=(a241*a312);
  a021=(a021*a330);
  a333=(a366-a333);
  a021=(a021*a333);
  a333=(a021/a368);
  a021=(a372*a021);
  a021=(a030+a021);
  a021=(a021/a010);
  a435=(a372*a021);
  a333=(a333+a435);
  a435=(a333*a347);
  a014=(a014+a435);
  a434=(a434+a014);
  a434=(a331*a434);
  a382=(a382+a434);
  a377=(a377+a382);
  if (res[0]!=0) res[0][6]=a377;
  a399=(a001*a399);
  a114=(a005*a114);
  a399=(a399+a114);
  a414=(a161*a414);
  a399=(a399+a414);
  a420=(a193*a420);
  a399=(a399+a420);
  a426=(a226*a426);
  a399=(a399+a426);
  a432=(a260*a432);
  a399=(a399+a432);
  a395=(a295*a395);
  a399=(a399+a395);
  a043=(a428*a043);
  a385=(a007*a385);
  a043=(a043+a385);
  a312=(a439*a312);
  a347=(a021*a347);
  a312=(a312-a347);
  a043=(a043+a312);
  a043=(a331*a043);
  a399=(a399+a043);
  a387=(a387+a399);
  if (res[0]!=0) res[0][7]=a387;
  a387=arg[0]? arg[0][8] : 0;
  a399=arg[0]? arg[0][10] : 0;
  a043=(a001*a399);
  a312=(a016*a387);
  a347=arg[0]? arg[0][9] : 0;
  a385=(a029*a347);
  a312=(a312+a385);
  a385=(a020*a399);
  a395=arg[0]? arg[0][11] : 0;
  a432=(a003*a395);
  a385=(a385+a432);
  a312=(a312+a385);
  a385=(a006*a312);
  a432=(a046*a399);
  a426=(a049*a312);
  a420=(a052*a399);
  a420=(a387+a420);
  a414=(a059*a420);
  a114=(a052*a395);
  a114=(a347+a114);
  a377=(a072*a114);
  a414=(a414+a377);
  a377=(a052*a312);
  a377=(a399+a377);
  a382=(a392*a377);
  a434=(a383*a387);
  a014=(a386*a347);
  a434=(a434+a014);
  a014=(a017*a399);
  a435=(a384*a395);
  a014=(a014-a435);
  a434=(a434+a014);
  a014=(a052*a434);
  a014=(a395+a014);
  a435=(a057*a014);
  a382=(a382+a435);
  a414=(a414+a382);
  a414=(a051*a414);
  a426=(a426+a414);
  a426=(a399+a426);
  a414=(a048*a426);
  a432=(a432+a414);
  a432=(a387+a432);
  a414=(a110*a432);
  a382=(a046*a395);
  a435=(a049*a434);
  a420=(a394*a420);
  a114=(a398*a114);
  a420=(a420+a114);
  a114=(a064*a377);
  a429=(a396*a014);
  a114=(a114-a429);
  a420=(a420+a114);
  a420=(a051*a420);
  a435=(a435+a420);
  a435=(a395+a435);
  a420=(a048*a435);
  a382=(a382+a420);
  a382=(a347+a382);
  a420=(a123*a382);
  a414=(a414+a420);
  a420=(a046*a312);
  a114=(a049*a399);
  a377=(a051*a377);
  a114=(a114+a377);
  a114=(a387+a114);
  a377=(a082*a114);
  a429=(a049*a395);
  a014=(a051*a014);
  a429=(a429+a014);
  a429=(a347+a429);
  a014=(a086*a429);
  a377=(a377+a014);
  a014=(a084*a426);
  a423=(a050*a435);
  a014=(a014+a423);
  a377=(a377+a014);
  a014=(a048*a377);
  a420=(a420+a014);
  a420=(a399+a420);
  a014=(a397*a420);
  a423=(a046*a434);
  a114=(a063*a114);
  a429=(a405*a429);
  a114=(a114+a429);
  a429=(a115*a426);
  a417=(a100*a435);
  a429=(a429-a417);
  a114=(a114+a429);
  a429=(a048*a114);
  a423=(a423+a429);
  a423=(a395+a423);
  a429=(a106*a423);
  a014=(a014+a429);
  a414=(a414+a014);
  a014=(a045*a414);
  a385=(a385+a014);
  a014=(a132*a399);
  a426=(a134*a426);
  a014=(a014+a426);
  a426=(a135*a420);
  a014=(a014+a426);
  a014=(a387+a014);
  a426=(a140*a014);
  a429=(a132*a395);
  a435=(a134*a435);
  a429=(a429+a435);
  a435=(a135*a423);
  a429=(a429+a435);
  a429=(a347+a429);
  a435=(a153*a429);
  a426=(a426+a435);
  a435=(a132*a312);
  a377=(a134*a377);
  a435=(a435+a377);
  a377=(a135*a414);
  a435=(a435+a377);
  a435=(a399+a435);
  a377=(a142*a435);
  a417=(a132*a434);
  a114=(a134*a114);
  a417=(a417+a114);
  a432=(a390*a432);
  a382=(a402*a382);
  a432=(a432+a382);
  a382=(a388*a420);
  a114=(a099*a423);
  a382=(a382-a114);
  a432=(a432+a382);
  a382=(a135*a432);
  a417=(a417+a382);
  a417=(a395+a417);
  a382=(a139*a417);
  a377=(a377+a382);
  a426=(a426+a377);
  a377=(a131*a426);
  a385=(a385+a377);
  a385=(a399+a385);
  a377=(a005*a385);
  a043=(a043+a377);
  a377=(a162*a312);
  a382=(a164*a414);
  a377=(a377+a382);
  a382=(a165*a426);
  a377=(a377+a382);
  a382=(a006*a399);
  a114=(a045*a420);
  a382=(a382+a114);
  a114=(a131*a435);
  a382=(a382+a114);
  a382=(a387+a382);
  a114=(a172*a382);
  a411=(a006*a395);
  a144=(a045*a423);
  a411=(a411+a144);
  a144=(a131*a417);
  a411=(a411+a144);
  a411=(a347+a411);
  a144=(a185*a411);
  a114=(a114+a144);
  a144=(a401*a385);
  a403=(a006*a434);
  a207=(a045*a432);
  a403=(a403+a207);
  a014=(a406*a014);
  a429=(a409*a429);
  a014=(a014+a429);
  a429=(a400*a435);
  a207=(a145*a417);
  a429=(a429-a207);
  a014=(a014+a429);
  a429=(a131*a014);
  a403=(a403+a429);
  a403=(a395+a403);
  a429=(a044*a403);
  a144=(a144+a429);
  a114=(a114+a144);
  a144=(a166*a114);
  a377=(a377+a144);
  a377=(a399+a377);
  a144=(a161*a377);
  a043=(a043+a144);
  a144=(a194*a312);
  a429=(a196*a414);
  a144=(a144+a429);
  a429=(a197*a426);
  a144=(a144+a429);
  a429=(a198*a114);
  a144=(a144+a429);
  a429=(a162*a399);
  a207=(a164*a420);
  a429=(a429+a207);
  a207=(a165*a435);
  a429=(a429+a207);
  a207=(a166*a385);
  a429=(a429+a207);
  a429=(a387+a429);
  a207=(a205*a429);
  a225=(a162*a395);
  a438=(a164*a423);
  a225=(a225+a438);
  a438=(a165*a417);
  a225=(a225+a438);
  a438=(a166*a403);
  a225=(a225+a438);
  a225=(a347+a225);
  a438=(a218*a225);
  a207=(a207+a438);
  a438=(a408*a377);
  a019=(a162*a434);
  a004=(a164*a432);
  a019=(a019+a004);
  a004=(a165*a014);
  a019=(a019+a004);
  a382=(a407*a382);
  a411=(a413*a411);
  a382=(a382+a411);
  a411=(a177*a385);
  a004=(a176*a403);
  a411=(a411-a004);
  a382=(a382+a411);
  a411=(a166*a382);
  a019=(a019+a411);
  a019=(a395+a019);
  a411=(a163*a019);
  a438=(a438+a411);
  a207=(a207+a438);
  a438=(a199*a207);
  a144=(a144+a438);
  a144=(a399+a144);
  a438=(a193*a144);
  a043=(a043+a438);
  a438=(a227*a312);
  a411=(a229*a414);
  a438=(a438+a411);
  a411=(a230*a426);
  a438=(a438+a411);
  a411=(a231*a114);
  a438=(a438+a411);
  a411=(a232*a207);
  a438=(a438+a411);
  a411=(a194*a399);
  a004=(a196*a420);
  a411=(a411+a004);
  a004=(a197*a435);
  a411=(a411+a004);
  a004=(a198*a385);
  a411=(a411+a004);
  a004=(a199*a377);
  a411=(a411+a004);
  a411=(a387+a411);
  a004=(a239*a411);
  a276=(a194*a395);
  a174=(a196*a423);
  a276=(a276+a174);
  a174=(a197*a417);
  a276=(a276+a174);
  a174=(a198*a403);
  a276=(a276+a174);
  a174=(a199*a019);
  a276=(a276+a174);
  a276=(a347+a276);
  a174=(a252*a276);
  a004=(a004+a174);
  a174=(a412*a144);
  a061=(a194*a434);
  a381=(a196*a432);
  a061=(a061+a381);
  a381=(a197*a014);
  a061=(a061+a381);
  a381=(a198*a382);
  a061=(a061+a381);
  a429=(a415*a429);
  a225=(a419*a225);
  a429=(a429+a225);
  a225=(a210*a377);
  a381=(a209*a019);
  a225=(a225-a381);
  a429=(a429+a225);
  a225=(a199*a429);
  a061=(a061+a225);
  a061=(a395+a061);
  a225=(a195*a061);
  a174=(a174+a225);
  a004=(a004+a174);
  a174=(a233*a004);
  a438=(a438+a174);
  a438=(a399+a438);
  a174=(a226*a438);
  a043=(a043+a174);
  a174=(a261*a312);
  a225=(a263*a414);
  a174=(a174+a225);
  a225=(a264*a426);
  a174=(a174+a225);
  a225=(a265*a114);
  a174=(a174+a225);
  a225=(a266*a207);
  a174=(a174+a225);
  a225=(a267*a004);
  a174=(a174+a225);
  a225=(a227*a399);
  a381=(a229*a420);
  a225=(a225+a381);
  a381=(a230*a435);
  a225=(a225+a381);
  a381=(a231*a385);
  a225=(a225+a381);
  a381=(a232*a377);
  a225=(a225+a381);
  a381=(a233*a144);
  a225=(a225+a381);
  a225=(a387+a225);
  a381=(a274*a225);
  a112=(a227*a395);
  a393=(a229*a423);
  a112=(a112+a393);
  a393=(a230*a417);
  a112=(a112+a393);
  a393=(a231*a403);
  a112=(a112+a393);
  a393=(a232*a019);
  a112=(a112+a393);
  a393=(a233*a061);
  a112=(a112+a393);
  a112=(a347+a112);
  a393=(a287*a112);
  a381=(a381+a393);
  a393=(a418*a438);
  a422=(a227*a434);
  a416=(a229*a432);
  a422=(a422+a416);
  a416=(a230*a014);
  a422=(a422+a416);
  a416=(a231*a382);
  a422=(a422+a416);
  a416=(a232*a429);
  a422=(a422+a416);
  a411=(a421*a411);
  a276=(a425*a276);
  a411=(a411+a276);
  a276=(a244*a144);
  a416=(a243*a061);
  a276=(a276-a416);
  a411=(a411+a276);
  a276=(a233*a411);
  a422=(a422+a276);
  a422=(a395+a422);
  a276=(a228*a422);
  a393=(a393+a276);
  a381=(a381+a393);
  a393=(a268*a381);
  a174=(a174+a393);
  a174=(a399+a174);
  a393=(a260*a174);
  a043=(a043+a393);
  a393=(a296*a312);
  a276=(a298*a414);
  a393=(a393+a276);
  a276=(a299*a426);
  a393=(a393+a276);
  a276=(a300*a114);
  a393=(a393+a276);
  a276=(a301*a207);
  a393=(a393+a276);
  a276=(a302*a004);
  a393=(a393+a276);
  a276=(a303*a381);
  a393=(a393+a276);
  a276=(a261*a399);
  a416=(a263*a420);
  a276=(a276+a416);
  a416=(a264*a435);
  a276=(a276+a416);
  a416=(a265*a385);
  a276=(a276+a416);
  a416=(a266*a377);
  a276=(a276+a416);
  a416=(a267*a144);
  a276=(a276+a416);
  a416=(a268*a438);
  a276=(a276+a416);
  a276=(a387+a276);
  a416=(a310*a276);
  a410=(a261*a395);
  a380=(a263*a423);
  a410=(a410+a380);
  a380=(a264*a417);
  a410=(a410+a380);
  a380=(a265*a403);
  a410=(a410+a380);
  a380=(a266*a019);
  a410=(a410+a380);
  a380=(a267*a061);
  a410=(a410+a380);
  a380=(a268*a422);
  a410=(a410+a380);
  a410=(a347+a410);
  a380=(a323*a410);
  a416=(a416+a380);
  a380=(a424*a174);
  a440=(a261*a434);
  a404=(a263*a432);
  a440=(a440+a404);
  a404=(a264*a014);
  a440=(a440+a404);
  a404=(a265*a382);
  a440=(a440+a404);
  a404=(a266*a429);
  a440=(a440+a404);
  a404=(a267*a411);
  a440=(a440+a404);
  a225=(a427*a225);
  a112=(a431*a112);
  a225=(a225+a112);
  a112=(a279*a438);
  a404=(a278*a422);
  a112=(a112-a404);
  a225=(a225+a112);
  a112=(a268*a225);
  a440=(a440+a112);
  a440=(a395+a440);
  a112=(a262*a440);
  a380=(a380+a112);
  a416=(a416+a380);
  a380=(a304*a416);
  a393=(a393+a380);
  a393=(a399+a393);
  a380=(a295*a393);
  a043=(a043+a380);
  a380=(a332*a312);
  a414=(a334*a414);
  a380=(a380+a414);
  a426=(a130*a426);
  a380=(a380+a426);
  a426=(a160*a114);
  a380=(a380+a426);
  a426=(a335*a207);
  a380=(a380+a426);
  a426=(a336*a004);
  a380=(a380+a426);
  a426=(a337*a381);
  a380=(a380+a426);
  a426=(a338*a416);
  a380=(a380+a426);
  a426=(a296*a399);
  a414=(a298*a420);
  a426=(a426+a414);
  a414=(a299*a435);
  a426=(a426+a414);
  a414=(a300*a385);
  a426=(a426+a414);
  a414=(a301*a377);
  a426=(a426+a414);
  a414=(a302*a144);
  a426=(a426+a414);
  a414=(a303*a438);
  a426=(a426+a414);
  a414=(a304*a174);
  a426=(a426+a414);
  a426=(a387+a426);
  a414=(a345*a426);
  a112=(a296*a395);
  a404=(a298*a423);
  a112=(a112+a404);
  a404=(a299*a417);
  a112=(a112+a404);
  a404=(a300*a403);
  a112=(a112+a404);
  a404=(a301*a019);
  a112=(a112+a404);
  a404=(a302*a061);
  a112=(a112+a404);
  a404=(a303*a422);
  a112=(a112+a404);
  a404=(a304*a440);
  a112=(a112+a404);
  a112=(a347+a112);
  a404=(a358*a112);
  a414=(a414+a404);
  a404=(a391*a393);
  a389=(a296*a434);
  a436=(a298*a432);
  a389=(a389+a436);
  a436=(a299*a014);
  a389=(a389+a436);
  a436=(a300*a382);
  a389=(a389+a436);
  a436=(a301*a429);
  a389=(a389+a436);
  a436=(a302*a411);
  a389=(a389+a436);
  a436=(a303*a225);
  a389=(a389+a436);
  a276=(a433*a276);
  a410=(a437*a410);
  a276=(a276+a410);
  a410=(a315*a174);
  a436=(a314*a440);
  a410=(a410-a436);
  a276=(a276+a410);
  a410=(a304*a276);
  a389=(a389+a410);
  a389=(a395+a389);
  a410=(a297*a389);
  a404=(a404+a410);
  a414=(a414+a404);
  a404=(a339*a414);
  a380=(a380+a404);
  a380=(a399+a380);
  a404=(a331*a380);
  a043=(a043+a404);
  a043=(a387+a043);
  if (res[0]!=0) res[0][8]=a043;
  a043=(a001*a395);
  a404=(a005*a403);
  a043=(a043+a404);
  a404=(a161*a019);
  a043=(a043+a404);
  a404=(a193*a061);
  a043=(a043+a404);
  a404=(a226*a422);
  a043=(a043+a404);
  a404=(a260*a440);
  a043=(a043+a404);
  a404=(a295*a389);
  a043=(a043+a404);
  a404=(a332*a434);
  a432=(a334*a432);
  a404=(a404+a432);
  a014=(a130*a014);
  a404=(a404+a014);
  a014=(a160*a382);
  a404=(a404+a014);
  a014=(a335*a429);
  a404=(a404+a014);
  a014=(a336*a411);
  a404=(a404+a014);
  a014=(a337*a225);
  a404=(a404+a014);
  a014=(a338*a276);
  a404=(a404+a014);
  a426=(a430*a426);
  a112=(a441*a112);
  a426=(a426+a112);
  a112=(a350*a393);
  a014=(a349*a389);
  a112=(a112-a014);
  a426=(a426+a112);
  a112=(a339*a426);
  a404=(a404+a112);
  a404=(a395+a404);
  a112=(a331*a404);
  a043=(a043+a112);
  a043=(a347+a043);
  if (res[0]!=0) res[0][9]=a043;
  a312=(a001*a312);
  a114=(a005*a114);
  a312=(a312+a114);
  a207=(a161*a207);
  a312=(a312+a207);
  a004=(a193*a004);
  a312=(a312+a004);
  a381=(a226*a381);
  a312=(a312+a381);
  a416=(a260*a416);
  a312=(a312+a416);
  a414=(a295*a414);
  a312=(a312+a414);
  a414=(a332*a399);
  a420=(a334*a420);
  a414=(a414+a420);
  a435=(a130*a435);
  a414=(a414+a435);
  a385=(a160*a385);
  a414=(a414+a385);
  a377=(a335*a377);
  a414=(a414+a377);
  a144=(a336*a144);
  a414=(a414+a144);
  a438=(a337*a438);
  a414=(a414+a438);
  a174=(a338*a174);
  a414=(a414+a174);
  a393=(a339*a393);
  a414=(a414+a393);
  a387=(a387+a414);
  a414=(a000*a387);
  a393=(a332*a395);
  a423=(a334*a423);
  a393=(a393+a423);
  a417=(a130*a417);
  a393=(a393+a417);
  a403=(a160*a403);
  a393=(a393+a403);
  a019=(a335*a019);
  a393=(a393+a019);
  a061=(a336*a061);
  a393=(a393+a061);
  a422=(a337*a422);
  a393=(a393+a422);
  a440=(a338*a440);
  a393=(a393+a440);
  a389=(a339*a389);
  a393=(a393+a389);
  a347=(a347+a393);
  a393=(a374*a347);
  a414=(a414+a393);
  a393=(a241*a380);
  a389=(a333*a404);
  a393=(a393+a389);
  a414=(a414+a393);
  a414=(a331*a414);
  a312=(a312+a414);
  a399=(a399+a312);
  if (res[0]!=0) res[0][10]=a399;
  a434=(a001*a434);
  a382=(a005*a382);
  a434=(a434+a382);
  a429=(a161*a429);
  a434=(a434+a429);
  a411=(a193*a411);
  a434=(a434+a411);
  a225=(a226*a225);
  a434=(a434+a225);
  a276=(a260*a276);
  a434=(a434+a276);
  a426=(a295*a426);
  a434=(a434+a426);
  a387=(a428*a387);
  a347=(a007*a347);
  a387=(a387+a347);
  a380=(a439*a380);
  a404=(a021*a404);
  a380=(a380-a404);
  a387=(a387+a380);
  a387=(a331*a387);
  a434=(a434+a387);
  a395=(a395+a434);
  if (res[0]!=0) res[0][11]=a395;
  a395=arg[0]? arg[0][12] : 0;
  a434=arg[0]? arg[0][14] : 0;
  a387=(a001*a434);
  a380=(a016*a395);
  a404=arg[0]? arg[0][13] : 0;
  a347=(a029*a404);
  a380=(a380+a347);
  a347=(a020*a434);
  a426=arg[0]? arg[0][15] : 0;
  a276=(a003*a426);
  a347=(a347+a276);
  a380=(a380+a347);
  a347=(a006*a380);
  a276=(a046*a434);
  a225=(a049*a380);
  a411=(a052*a434);
  a411=(a395+a411);
  a429=(a059*a411);
  a382=(a052*a426);
  a382=(a404+a382);
  a399=(a072*a382);
  a429=(a429+a399);
  a399=(a052*a380);
  a399=(a434+a399);
  a312=(a392*a399);
  a414=(a383*a395);
  a393=(a386*a404);
  a414=(a414+a393);
  a393=(a017*a434);
  a389=(a384*a426);
  a393=(a393-a389);
  a414=(a414+a393);
  a393=(a052*a414);
  a393=(a426+a393);
  a389=(a057*a393);
  a312=(a312+a389);
  a429=(a429+a312);
  a429=(a051*a429);
  a225=(a225+a429);
  a225=(a434+a225);
  a429=(a048*a225);
  a276=(a276+a429);
  a276=(a395+a276);
  a429=(a110*a276);
  a312=(a046*a426);
  a389=(a049*a414);
  a411=(a394*a411);
  a382=(a398*a382);
  a411=(a411+a382);
  a382=(a064*a399);
  a440=(a396*a393);
  a382=(a382-a440);
  a411=(a411+a382);
  a411=(a051*a411);
  a389=(a389+a411);
  a389=(a426+a389);
  a411=(a048*a389);
  a312=(a312+a411);
  a312=(a404+a312);
  a411=(a123*a312);
  a429=(a429+a411);
  a411=(a046*a380);
  a382=(a049*a434);
  a399=(a051*a399);
  a382=(a382+a399);
  a382=(a395+a382);
  a399=(a082*a382);
  a440=(a049*a426);
  a393=(a051*a393);
  a440=(a440+a393);
  a440=(a404+a440);
  a393=(a086*a440);
  a399=(a399+a393);
  a393=(a084*a225);
  a422=(a050*a389);
  a393=(a393+a422);
  a399=(a399+a393);
  a393=(a048*a399);
  a411=(a411+a393);
  a411=(a434+a411);
  a393=(a397*a411);
  a422=(a046*a414);
  a382=(a063*a382);
  a440=(a405*a440);
  a382=(a382+a440);
  a440=(a115*a225);
  a061=(a100*a389);
  a440=(a440-a061);
  a382=(a382+a440);
  a440=(a048*a382);
  a422=(a422+a440);
  a422=(a426+a422);
  a440=(a106*a422);
  a393=(a393+a440);
  a429=(a429+a393);
  a393=(a045*a429);
  a347=(a347+a393);
  a393=(a132*a434);
  a225=(a134*a225);
  a393=(a393+a225);
  a225=(a135*a411);
  a393=(a393+a225);
  a393=(a395+a393);
  a225=(a140*a393);
  a440=(a132*a426);
  a389=(a134*a389);
  a440=(a440+a389);
  a389=(a135*a422);
  a440=(a440+a389);
  a440=(a404+a440);
  a389=(a153*a440);
  a225=(a225+a389);
  a389=(a132*a380);
  a399=(a134*a399);
  a389=(a389+a399);
  a399=(a135*a429);
  a389=(a389+a399);
  a389=(a434+a389);
  a399=(a142*a389);
  a061=(a132*a414);
  a382=(a134*a382);
  a061=(a061+a382);
  a276=(a390*a276);
  a312=(a402*a312);
  a276=(a276+a312);
  a312=(a388*a411);
  a382=(a099*a422);
  a312=(a312-a382);
  a276=(a276+a312);
  a312=(a135*a276);
  a061=(a061+a312);
  a061=(a426+a061);
  a312=(a139*a061);
  a399=(a399+a312);
  a225=(a225+a399);
  a399=(a131*a225);
  a347=(a347+a399);
  a347=(a434+a347);
  a399=(a005*a347);
  a387=(a387+a399);
  a399=(a162*a380);
  a312=(a164*a429);
  a399=(a399+a312);
  a312=(a165*a225);
  a399=(a399+a312);
  a312=(a006*a434);
  a382=(a045*a411);
  a312=(a312+a382);
  a382=(a131*a389);
  a312=(a312+a382);
  a312=(a395+a312);
  a382=(a172*a312);
  a019=(a006*a426);
  a403=(a045*a422);
  a019=(a019+a403);
  a403=(a131*a061);
  a019=(a019+a403);
  a019=(a404+a019);
  a403=(a185*a019);
  a382=(a382+a403);
  a403=(a401*a347);
  a417=(a006*a414);
  a423=(a045*a276);
  a417=(a417+a423);
  a393=(a406*a393);
  a440=(a409*a440);
  a393=(a393+a440);
  a440=(a400*a389);
  a423=(a145*a061);
  a440=(a440-a423);
  a393=(a393+a440);
  a440=(a131*a393);
  a417=(a417+a440);
  a417=(a426+a417);
  a440=(a044*a417);
  a403=(a403+a440);
  a382=(a382+a403);
  a403=(a166*a382);
  a399=(a399+a403);
  a399=(a434+a399);
  a403=(a161*a399);
  a387=(a387+a403);
  a403=(a194*a380);
  a440=(a196*a429);
  a403=(a403+a440);
  a440=(a197*a225);
  a403=(a403+a440);
  a440=(a198*a382);
  a403=(a403+a440);
  a440=(a162*a434);
  a423=(a164*a411);
  a440=(a440+a423);
  a423=(a165*a389);
  a440=(a440+a423);
  a423=(a166*a347);
  a440=(a440+a423);
  a440=(a395+a440);
  a423=(a205*a440);
  a174=(a162*a426);
  a438=(a164*a422);
  a174=(a174+a438);
  a438=(a165*a061);
  a174=(a174+a438);
  a438=(a166*a417);
  a174=(a174+a438);
  a174=(a404+a174);
  a438=(a218*a174);
  a423=(a423+a438);
  a438=(a408*a399);
  a144=(a162*a414);
  a377=(a164*a276);
  a144=(a144+a377);
  a377=(a165*a393);
  a144=(a144+a377);
  a312=(a407*a312);
  a019=(a413*a019);
  a312=(a312+a019);
  a019=(a177*a347);
  a377=(a176*a417);
  a019=(a019-a377);
  a312=(a312+a019);
  a019=(a166*a312);
  a144=(a144+a019);
  a144=(a426+a144);
  a019=(a163*a144);
  a438=(a438+a019);
  a423=(a423+a438);
  a438=(a199*a423);
  a403=(a403+a438);
  a403=(a434+a403);
  a438=(a193*a403);
  a387=(a387+a438);
  a438=(a227*a380);
  a019=(a229*a429);
  a438=(a438+a019);
  a019=(a230*a225);
  a438=(a438+a019);
  a019=(a231*a382);
  a438=(a438+a019);
  a019=(a232*a423);
  a438=(a438+a019);
  a019=(a194*a434);
  a377=(a196*a411);
  a019=(a019+a377);
  a377=(a197*a389);
  a019=(a019+a377);
  a377=(a198*a347);
  a019=(a019+a377);
  a377=(a199*a399);
  a019=(a019+a377);
  a019=(a395+a019);
  a377=(a239*a019);
  a385=(a194*a426);
  a435=(a196*a422);
  a385=(a385+a435);
  a435=(a197*a061);
  a385=(a385+a435);
  a435=(a198*a417);
  a385=(a385+a435);
  a435=(a199*a144);
  a385=(a385+a435);
  a385=(a404+a385);
  a435=(a252*a385);
  a377=(a377+a435);
  a435=(a412*a403);
  a420=(a194*a414);
  a416=(a196*a276);
  a420=(a420+a416);
  a416=(a197*a393);
  a420=(a420+a416);
  a416=(a198*a312);
  a420=(a420+a416);
  a440=(a415*a440);
  a174=(a419*a174);
  a440=(a440+a174);
  a174=(a210*a399);
  a416=(a209*a144);
  a174=(a174-a416);
  a440=(a440+a174);
  a174=(a199*a440);
  a420=(a420+a174);
  a420=(a426+a420);
  a174=(a195*a420);
  a435=(a435+a174);
  a377=(a377+a435);
  a435=(a233*a377);
  a438=(a438+a435);
  a438=(a434+a438);
  a435=(a226*a438);
  a387=(a387+a435);
  a435=(a261*a380);
  a174=(a263*a429);
  a435=(a435+a174);
  a174=(a264*a225);
  a435=(a435+a174);
  a174=(a265*a382);
  a435=(a435+a174);
  a174=(a266*a423);
  a435=(a435+a174);
  a174=(a267*a377);
  a435=(a435+a174);
  a174=(a227*a434);
  a416=(a229*a411);
  a174=(a174+a416);
  a416=(a230*a389);
  a174=(a174+a416);
  a416=(a231*a347);
  a174=(a174+a416);
  a416=(a232*a399);
  a174=(a174+a416);
  a416=(a233*a403);
  a174=(a174+a416);
  a174=(a395+a174);
  a416=(a274*a174);
  a381=(a227*a426);
  a004=(a229*a422);
  a381=(a381+a004);
  a004=(a230*a061);
  a381=(a381+a004);
  a004=(a231*a417);
  a381=(a381+a004);
  a004=(a232*a144);
  a381=(a381+a004);
  a004=(a233*a420);
  a381=(a381+a004);
  a381=(a404+a381);
  a004=(a287*a381);
  a416=(a416+a004);
  a004=(a418*a438);
  a207=(a227*a414);
  a114=(a229*a276);
  a207=(a207+a114);
  a114=(a230*a393);
  a207=(a207+a114);
  a114=(a231*a312);
  a207=(a207+a114);
  a114=(a232*a440);
  a207=(a207+a114);
  a019=(a421*a019);
  a385=(a425*a385);
  a019=(a019+a385);
  a385=(a244*a403);
  a114=(a243*a420);
  a385=(a385-a114);
  a019=(a019+a385);
  a385=(a233*a019);
  a207=(a207+a385);
  a207=(a426+a207);
  a385=(a228*a207);
  a004=(a004+a385);
  a416=(a416+a004);
  a004=(a268*a416);
  a435=(a435+a004);
  a435=(a434+a435);
  a004=(a260*a435);
  a387=(a387+a004);
  a004=(a296*a380);
  a385=(a298*a429);
  a004=(a004+a385);
  a385=(a299*a225);
  a004=(a004+a385);
  a385=(a300*a382);
  a004=(a004+a385);
  a385=(a301*a423);
  a004=(a004+a385);
  a385=(a302*a377);
  a004=(a004+a385);
  a385=(a303*a416);
  a004=(a004+a385);
  a385=(a261*a434);
  a114=(a263*a411);
  a385=(a385+a114);
  a114=(a264*a389);
  a385=(a385+a114);
  a114=(a265*a347);
  a385=(a385+a114);
  a114=(a266*a399);
  a385=(a385+a114);
  a114=(a267*a403);
  a385=(a385+a114);
  a114=(a268*a438);
  a385=(a385+a114);
  a385=(a395+a385);
  a114=(a310*a385);
  a043=(a261*a426);
  a112=(a263*a422);
  a043=(a043+a112);
  a112=(a264*a061);
  a043=(a043+a112);
  a112=(a265*a417);
  a043=(a043+a112);
  a112=(a266*a144);
  a043=(a043+a112);
  a112=(a267*a420);
  a043=(a043+a112);
  a112=(a268*a207);
  a043=(a043+a112);
  a043=(a404+a043);
  a112=(a323*a043);
  a114=(a114+a112);
  a112=(a424*a435);
  a014=(a261*a414);
  a432=(a263*a276);
  a014=(a014+a432);
  a432=(a264*a393);
  a014=(a014+a432);
  a432=(a265*a312);
  a014=(a014+a432);
  a432=(a266*a440);
  a014=(a014+a432);
  a432=(a267*a019);
  a014=(a014+a432);
  a174=(a427*a174);
  a381=(a431*a381);
  a174=(a174+a381);
  a381=(a279*a438);
  a432=(a278*a207);
  a381=(a381-a432);
  a174=(a174+a381);
  a381=(a268*a174);
  a014=(a014+a381);
  a014=(a426+a014);
  a381=(a262*a014);
  a112=(a112+a381);
  a114=(a114+a112);
  a112=(a304*a114);
  a004=(a004+a112);
  a004=(a434+a004);
  a112=(a295*a004);
  a387=(a387+a112);
  a112=(a332*a380);
  a429=(a334*a429);
  a112=(a112+a429);
  a225=(a130*a225);
  a112=(a112+a225);
  a225=(a160*a382);
  a112=(a112+a225);
  a225=(a335*a423);
  a112=(a112+a225);
  a225=(a336*a377);
  a112=(a112+a225);
  a225=(a337*a416);
  a112=(a112+a225);
  a225=(a338*a114);
  a112=(a112+a225);
  a225=(a296*a434);
  a429=(a298*a411);
  a225=(a225+a429);
  a429=(a299*a389);
  a225=(a225+a429);
  a429=(a300*a347);
  a225=(a225+a429);
  a429=(a301*a399);
  a225=(a225+a429);
  a429=(a302*a403);
  a225=(a225+a429);
  a429=(a303*a438);
  a225=(a225+a429);
  a429=(a304*a435);
  a225=(a225+a429);
  a225=(a395+a225);
  a429=(a345*a225);
  a381=(a296*a426);
  a432=(a298*a422);
  a381=(a381+a432);
  a432=(a299*a061);
  a381=(a381+a432);
  a432=(a300*a417);
  a381=(a381+a432);
  a432=(a301*a144);
  a381=(a381+a432);
  a432=(a302*a420);
  a381=(a381+a432);
  a432=(a303*a207);
  a381=(a381+a432);
  a432=(a304*a014);
  a381=(a381+a432);
  a381=(a404+a381);
  a432=(a358*a381);
  a429=(a429+a432);
  a432=(a391*a004);
  a410=(a296*a414);
  a436=(a298*a276);
  a410=(a410+a436);
  a436=(a299*a393);
  a410=(a410+a436);
  a436=(a300*a312);
  a410=(a410+a436);
  a436=(a301*a440);
  a410=(a410+a436);
  a436=(a302*a019);
  a410=(a410+a436);
  a436=(a303*a174);
  a410=(a410+a436);
  a385=(a433*a385);
  a043=(a437*a043);
  a385=(a385+a043);
  a043=(a315*a435);
  a436=(a314*a014);
  a043=(a043-a436);
  a385=(a385+a043);
  a043=(a304*a385);
  a410=(a410+a043);
  a410=(a426+a410);
  a043=(a297*a410);
  a432=(a432+a043);
  a429=(a429+a432);
  a432=(a339*a429);
  a112=(a112+a432);
  a112=(a434+a112);
  a432=(a331*a112);
  a387=(a387+a432);
  a387=(a395+a387);
  if (res[0]!=0) res[0][12]=a387;
  a387=(a001*a426);
  a432=(a005*a417);
  a387=(a387+a432);
  a432=(a161*a144);
  a387=(a387+a432);
  a432=(a193*a420);
  a387=(a387+a432);
  a432=(a226*a207);
  a387=(a387+a432);
  a432=(a260*a014);
  a387=(a387+a432);
  a432=(a295*a410);
  a387=(a387+a432);
  a432=(a332*a414);
  a276=(a334*a276);
  a432=(a432+a276);
  a393=(a130*a393);
  a432=(a432+a393);
  a393=(a160*a312);
  a432=(a432+a393);
  a393=(a335*a440);
  a432=(a432+a393);
  a393=(a336*a019);
  a432=(a432+a393);
  a393=(a337*a174);
  a432=(a432+a393);
  a393=(a338*a385);
  a432=(a432+a393);
  a225=(a430*a225);
  a381=(a441*a381);
  a225=(a225+a381);
  a381=(a350*a004);
  a393=(a349*a410);
  a381=(a381-a393);
  a225=(a225+a381);
  a381=(a339*a225);
  a432=(a432+a381);
  a432=(a426+a432);
  a381=(a331*a432);
  a387=(a387+a381);
  a387=(a404+a387);
  if (res[0]!=0) res[0][13]=a387;
  a380=(a001*a380);
  a382=(a005*a382);
  a380=(a380+a382);
  a423=(a161*a423);
  a380=(a380+a423);
  a377=(a193*a377);
  a380=(a380+a377);
  a416=(a226*a416);
  a380=(a380+a416);
  a114=(a260*a114);
  a380=(a380+a114);
  a429=(a295*a429);
  a380=(a380+a429);
  a429=(a332*a434);
  a411=(a334*a411);
  a429=(a429+a411);
  a389=(a130*a389);
  a429=(a429+a389);
  a347=(a160*a347);
  a429=(a429+a347);
  a399=(a335*a399);
  a429=(a429+a399);
  a403=(a336*a403);
  a429=(a429+a403);
  a438=(a337*a438);
  a429=(a429+a438);
  a435=(a338*a435);
  a429=(a429+a435);
  a004=(a339*a004);
  a429=(a429+a004);
  a395=(a395+a429);
  a429=(a000*a395);
  a004=(a332*a426);
  a422=(a334*a422);
  a004=(a004+a422);
  a061=(a130*a061);
  a004=(a004+a061);
  a417=(a160*a417);
  a004=(a004+a417);
  a144=(a335*a144);
  a004=(a004+a144);
  a420=(a336*a420);
  a004=(a004+a420);
  a207=(a337*a207);
  a004=(a004+a207);
  a014=(a338*a014);
  a004=(a004+a014);
  a410=(a339*a410);
  a004=(a004+a410);
  a404=(a404+a004);
  a004=(a374*a404);
  a429=(a429+a004);
  a004=(a241*a112);
  a410=(a333*a432);
  a004=(a004+a410);
  a429=(a429+a004);
  a429=(a331*a429);
  a380=(a380+a429);
  a434=(a434+a380);
  if (res[0]!=0) res[0][14]=a434;
  a414=(a001*a414);
  a312=(a005*a312);
  a414=(a414+a312);
  a440=(a161*a440);
  a414=(a414+a440);
  a019=(a193*a019);
  a414=(a414+a019);
  a174=(a226*a174);
  a414=(a414+a174);
  a385=(a260*a385);
  a414=(a414+a385);
  a225=(a295*a225);
  a414=(a414+a225);
  a395=(a428*a395);
  a404=(a007*a404);
  a395=(a395+a404);
  a112=(a439*a112);
  a432=(a021*a432);
  a112=(a112-a432);
  a395=(a395+a112);
  a395=(a331*a395);
  a414=(a414+a395);
  a426=(a426+a414);
  if (res[0]!=0) res[0][15]=a426;
  a426=arg[0]? arg[0][16] : 0;
  a414=arg[0]? arg[0][18] : 0;
  a395=(a001*a414);
  a016=(a016*a426);
  a112=arg[0]? arg[0][17] : 0;
  a029=(a029*a112);
  a016=(a016+a029);
  a020=(a020*a414);
  a029=arg[0]? arg[0][19] : 0;
  a003=(a003*a029);
  a020=(a020+a003);
  a016=(a016+a020);
  a020=arg[6]? arg[6][1] : 0;
  a008=(a008*a020);
  a011=(a011*a008);
  a012=(a012*a011);
  a015=(a015*a020);
  a012=(a012-a015);
  a013=(a013*a020);
  a012=(a012+a013);
  a013=(a012/a023);
  a024=(a024/a023);
  a015=(2.*a020);
  a022=(a022*a015);
  a024=(a024*a022);
  a013=(a013-a024);
  a025=(a025*a020);
  a024=(a025/a023);
  a023=(a027/a023);
  a023=(a023*a022);
  a024=(a024-a023);
  a023=(a036*a024);
  a028=(a028*a020);
  a022=arg[6]? arg[6][3] : 0;
  a035=(a035*a022);
  a011=arg[6]? arg[6][5] : 0;
  a032=(a032*a011);
  a008=arg[6]? arg[6][0] : 0;
  a003=(a031*a008);
  a032=(a032+a003);
  a003=(a034*a032);
  a432=arg[5]? arg[5][0] : 0;
  a404=(a432*a008);
  a039=(a404*a039);
  a039=(a033*a039);
  a003=(a003+a039);
  a003=(a030*a003);
  a035=(a035+a003);
  a003=arg[6]? arg[6][2] : 0;
  a041=(a041*a003);
  a039=arg[6]? arg[6][4] : 0;
  a040=(a040*a011);
  a404=(a404*a034);
  a404=(a031*a404);
  a040=(a040-a404);
  a040=(a039-a040);
  a040=(a037*a040);
  a041=(a041+a040);
  a035=(a035+a041);
  a028=(a028-a035);
  a009=(a009*a024);
  a012=(a027*a012);
  a009=(a009+a012);
  a028=(a028-a009);
  a028=(a028/a042);
  a036=(a036/a042);
  a025=(a027*a025);
  a026=(a026*a024);
  a025=(a025+a026);
  a025=(a020-a025);
  a036=(a036*a025);
  a028=(a028-a036);
  a027=(a027*a028);
  a023=(a023+a027);
  a013=(a013-a023);
  a016=(a016+a013);
  a013=(a006*a016);
  a023=(a046*a414);
  a027=(a049*a016);
  a036=(a052*a414);
  a036=(a426+a036);
  a059=(a059*a036);
  a025=(a052*a029);
  a025=(a112+a025);
  a072=(a072*a025);
  a059=(a059+a072);
  a072=(a052*a016);
  a072=(a414+a072);
  a392=(a392*a072);
  a383=(a383*a426);
  a386=(a386*a112);
  a383=(a383+a386);
  a017=(a017*a414);
  a384=(a384*a029);
  a017=(a017-a384);
  a383=(a383+a017);
  a383=(a383+a028);
  a028=(a052*a383);
  a028=(a029+a028);
  a057=(a057*a028);
  a392=(a392+a057);
  a059=(a059+a392);
  a053=(a053*a020);
  a056=(a056*a053);
  a058=(a058*a056);
  a062=(a062*a020);
  a058=(a058-a062);
  a060=(a060*a020);
  a058=(a058+a060);
  a060=(a058/a066);
  a067=(a067/a066);
  a065=(a065*a015);
  a067=(a067*a065);
  a060=(a060-a067);
  a068=(a068*a020);
  a067=(a068/a066);
  a066=(a070/a066);
  a066=(a066*a065);
  a067=(a067-a066);
  a066=(a077*a067);
  a071=(a071*a020);
  a076=(a076*a022);
  a065=(a074*a032);
  a052=(a432+a052);
  a052=(a052*a008);
  a073=(a052*a073);
  a073=(a033*a073);
  a065=(a065+a073);
  a065=(a030*a065);
  a076=(a076+a065);
  a078=(a078*a003);
  a075=(a075*a011);
  a052=(a052*a074);
  a052=(a031*a052);
  a075=(a075-a052);
  a075=(a039-a075);
  a075=(a037*a075);
  a078=(a078+a075);
  a076=(a076+a078);
  a071=(a071-a076);
  a054=(a054*a067);
  a058=(a070*a058);
  a054=(a054+a058);
  a071=(a071-a054);
  a071=(a071/a055);
  a077=(a077/a055);
  a068=(a070*a068);
  a069=(a069*a067);
  a068=(a068+a069);
  a068=(a020-a068);
  a077=(a077*a068);
  a071=(a071-a077);
  a070=(a070*a071);
  a066=(a066+a070);
  a060=(a060-a066);
  a059=(a059+a060);
  a059=(a051*a059);
  a027=(a027+a059);
  a027=(a414+a027);
  a059=(a048*a027);
  a023=(a023+a059);
  a023=(a426+a023);
  a110=(a110*a023);
  a059=(a046*a029);
  a060=(a049*a383);
  a394=(a394*a036);
  a398=(a398*a025);
  a394=(a394+a398);
  a064=(a064*a072);
  a396=(a396*a028);
  a064=(a064-a396);
  a394=(a394+a064);
  a394=(a394+a071);
  a394=(a051*a394);
  a060=(a060+a394);
  a060=(a029+a060);
  a394=(a048*a060);
  a059=(a059+a394);
  a059=(a112+a059);
  a123=(a123*a059);
  a110=(a110+a123);
  a123=(a046*a016);
  a394=(a049*a414);
  a072=(a051*a072);
  a394=(a394+a072);
  a394=(a426+a394);
  a082=(a082*a394);
  a049=(a049*a029);
  a051=(a051*a028);
  a049=(a049+a051);
  a049=(a112+a049);
  a086=(a086*a049);
  a082=(a082+a086);
  a084=(a084*a027);
  a050=(a050*a060);
  a084=(a084+a050);
  a082=(a082+a084);
  a087=(a087*a020);
  a081=(a081*a087);
  a098=(a098*a081);
  a085=(a085*a020);
  a098=(a098-a085);
  a083=(a083*a020);
  a098=(a098+a083);
  a083=(a098/a095);
  a107=(a107/a095);
  a094=(a094*a015);
  a107=(a107*a094);
  a083=(a083-a107);
  a092=(a092*a020);
  a107=(a092/a095);
  a095=(a096/a095);
  a095=(a095*a094);
  a107=(a107-a095);
  a095=(a101*a107);
  a079=(a079*a020);
  a091=(a091*a022);
  a094=(a089*a032);
  a085=7.8900227938151601e-02;
  a085=(a085*a002);
  a085=(a432+a085);
  a085=(a085*a008);
  a088=(a085*a088);
  a088=(a033*a088);
  a094=(a094+a088);
  a094=(a030*a094);
  a091=(a091+a094);
  a093=(a093*a003);
  a090=(a090*a011);
  a085=(a085*a089);
  a085=(a031*a085);
  a090=(a090-a085);
  a090=(a039-a090);
  a090=(a037*a090);
  a093=(a093+a090);
  a091=(a091+a093);
  a079=(a079-a091);
  a097=(a097*a107);
  a098=(a096*a098);
  a097=(a097+a098);
  a079=(a079-a097);
  a079=(a079/a102);
  a101=(a101/a102);
  a092=(a096*a092);
  a080=(a080*a107);
  a092=(a092+a080);
  a092=(a020-a092);
  a101=(a101*a092);
  a079=(a079-a101);
  a096=(a096*a079);
  a095=(a095+a096);
  a083=(a083-a095);
  a082=(a082+a083);
  a083=(a048*a082);
  a123=(a123+a083);
  a123=(a414+a123);
  a397=(a397*a123);
  a046=(a046*a383);
  a063=(a063*a394);
  a405=(a405*a049);
  a063=(a063+a405);
  a115=(a115*a027);
  a100=(a100*a060);
  a115=(a115-a100);
  a063=(a063+a115);
  a063=(a063+a079);
  a048=(a048*a063);
  a046=(a046+a048);
  a046=(a029+a046);
  a106=(a106*a046);
  a397=(a397+a106);
  a110=(a110+a397);
  a047=(a047*a020);
  a105=(a105*a047);
  a109=(a109*a105);
  a113=(a113*a020);
  a109=(a109-a113);
  a111=(a111*a020);
  a109=(a109+a111);
  a111=(a109/a117);
  a118=(a118/a117);
  a116=(a116*a015);
  a118=(a118*a116);
  a111=(a111-a118);
  a119=(a119*a020);
  a118=(a119/a117);
  a117=(a121/a117);
  a117=(a117*a116);
  a118=(a118-a117);
  a117=(a128*a118);
  a122=(a122*a020);
  a127=(a127*a022);
  a116=(a125*a032);
  a113=1.1835034190722740e-01;
  a113=(a113*a002);
  a113=(a432+a113);
  a113=(a113*a008);
  a124=(a113*a124);
  a124=(a033*a124);
  a116=(a116+a124);
  a116=(a030*a116);
  a127=(a127+a116);
  a129=(a129*a003);
  a126=(a126*a011);
  a113=(a113*a125);
  a113=(a031*a113);
  a126=(a126-a113);
  a126=(a039-a126);
  a126=(a037*a126);
  a129=(a129+a126);
  a127=(a127+a129);
  a122=(a122-a127);
  a103=(a103*a118);
  a109=(a121*a109);
  a103=(a103+a109);
  a122=(a122-a103);
  a122=(a122/a104);
  a128=(a128/a104);
  a119=(a121*a119);
  a120=(a120*a118);
  a119=(a119+a120);
  a119=(a020-a119);
  a128=(a128*a119);
  a122=(a122-a128);
  a121=(a121*a122);
  a117=(a117+a121);
  a111=(a111-a117);
  a110=(a110+a111);
  a111=(a045*a110);
  a013=(a013+a111);
  a111=(a132*a414);
  a027=(a134*a027);
  a111=(a111+a027);
  a027=(a135*a123);
  a111=(a111+a027);
  a111=(a426+a111);
  a140=(a140*a111);
  a027=(a132*a029);
  a060=(a134*a060);
  a027=(a027+a060);
  a060=(a135*a046);
  a027=(a027+a060);
  a027=(a112+a027);
  a153=(a153*a027);
  a140=(a140+a153);
  a153=(a132*a016);
  a082=(a134*a082);
  a153=(a153+a082);
  a082=(a135*a110);
  a153=(a153+a082);
  a153=(a414+a153);
  a142=(a142*a153);
  a132=(a132*a383);
  a134=(a134*a063);
  a132=(a132+a134);
  a390=(a390*a023);
  a402=(a402*a059);
  a390=(a390+a402);
  a388=(a388*a123);
  a099=(a099*a046);
  a388=(a388-a099);
  a390=(a390+a388);
  a390=(a390+a122);
  a135=(a135*a390);
  a132=(a132+a135);
  a132=(a029+a132);
  a139=(a139*a132);
  a142=(a142+a139);
  a140=(a140+a142);
  a133=(a133*a020);
  a138=(a138*a133);
  a108=(a108*a138);
  a143=(a143*a020);
  a108=(a108-a143);
  a141=(a141*a020);
  a108=(a108+a141);
  a141=(a108/a147);
  a148=(a148/a147);
  a146=(a146*a015);
  a148=(a148*a146);
  a141=(a141-a148);
  a149=(a149*a020);
  a148=(a149/a147);
  a147=(a151/a147);
  a147=(a147*a146);
  a148=(a148-a147);
  a147=(a158*a148);
  a152=(a152*a020);
  a157=(a157*a022);
  a146=(a155*a032);
  a143=2.8164965809277259e-01;
  a143=(a143*a002);
  a143=(a432+a143);
  a143=(a143*a008);
  a154=(a143*a154);
  a154=(a033*a154);
  a146=(a146+a154);
  a146=(a030*a146);
  a157=(a157+a146);
  a159=(a159*a003);
  a156=(a156*a011);
  a143=(a143*a155);
  a143=(a031*a143);
  a156=(a156-a143);
  a156=(a039-a156);
  a156=(a037*a156);
  a159=(a159+a156);
  a157=(a157+a159);
  a152=(a152-a157);
  a136=(a136*a148);
  a108=(a151*a108);
  a136=(a136+a108);
  a152=(a152-a136);
  a152=(a152/a137);
  a158=(a158/a137);
  a149=(a151*a149);
  a150=(a150*a148);
  a149=(a149+a150);
  a149=(a020-a149);
  a158=(a158*a149);
  a152=(a152-a158);
  a151=(a151*a152);
  a147=(a147+a151);
  a141=(a141-a147);
  a140=(a140+a141);
  a141=(a131*a140);
  a013=(a013+a141);
  a013=(a414+a013);
  a141=(a005*a013);
  a395=(a395+a141);
  a141=(a162*a016);
  a147=(a164*a110);
  a141=(a141+a147);
  a147=(a165*a140);
  a141=(a141+a147);
  a147=(a006*a414);
  a151=(a045*a123);
  a147=(a147+a151);
  a151=(a131*a153);
  a147=(a147+a151);
  a147=(a426+a147);
  a172=(a172*a147);
  a151=(a006*a029);
  a158=(a045*a046);
  a151=(a151+a158);
  a158=(a131*a132);
  a151=(a151+a158);
  a151=(a112+a151);
  a185=(a185*a151);
  a172=(a172+a185);
  a401=(a401*a013);
  a006=(a006*a383);
  a045=(a045*a390);
  a006=(a006+a045);
  a406=(a406*a111);
  a409=(a409*a027);
  a406=(a406+a409);
  a400=(a400*a153);
  a145=(a145*a132);
  a400=(a400-a145);
  a406=(a406+a400);
  a406=(a406+a152);
  a131=(a131*a406);
  a006=(a006+a131);
  a006=(a029+a006);
  a044=(a044*a006);
  a401=(a401+a044);
  a172=(a172+a401);
  a167=(a167*a020);
  a170=(a170*a167);
  a171=(a171*a170);
  a175=(a175*a020);
  a171=(a171-a175);
  a173=(a173*a020);
  a171=(a171+a173);
  a173=(a171/a179);
  a180=(a180/a179);
  a178=(a178*a015);
  a180=(a180*a178);
  a173=(a173-a180);
  a181=(a181*a020);
  a180=(a181/a179);
  a179=(a183/a179);
  a179=(a179*a178);
  a180=(a180-a179);
  a179=(a190*a180);
  a184=(a184*a020);
  a189=(a189*a022);
  a178=(a187*a032);
  a175=3.3333333333333331e-01;
  a175=(a175*a002);
  a175=(a432+a175);
  a175=(a175*a008);
  a186=(a175*a186);
  a186=(a033*a186);
  a178=(a178+a186);
  a178=(a030*a178);
  a189=(a189+a178);
  a191=(a191*a003);
  a188=(a188*a011);
  a175=(a175*a187);
  a175=(a031*a175);
  a188=(a188-a175);
  a188=(a039-a188);
  a188=(a037*a188);
  a191=(a191+a188);
  a189=(a189+a191);
  a184=(a184-a189);
  a168=(a168*a180);
  a171=(a183*a171);
  a168=(a168+a171);
  a184=(a184-a168);
  a184=(a184/a169);
  a190=(a190/a169);
  a181=(a183*a181);
  a182=(a182*a180);
  a181=(a181+a182);
  a181=(a020-a181);
  a190=(a190*a181);
  a184=(a184-a190);
  a183=(a183*a184);
  a179=(a179+a183);
  a173=(a173-a179);
  a172=(a172+a173);
  a173=(a166*a172);
  a141=(a141+a173);
  a141=(a414+a141);
  a173=(a161*a141);
  a395=(a395+a173);
  a173=(a194*a016);
  a179=(a196*a110);
  a173=(a173+a179);
  a179=(a197*a140);
  a173=(a173+a179);
  a179=(a198*a172);
  a173=(a173+a179);
  a179=(a162*a414);
  a183=(a164*a123);
  a179=(a179+a183);
  a183=(a165*a153);
  a179=(a179+a183);
  a183=(a166*a013);
  a179=(a179+a183);
  a179=(a426+a179);
  a205=(a205*a179);
  a183=(a162*a029);
  a190=(a164*a046);
  a183=(a183+a190);
  a190=(a165*a132);
  a183=(a183+a190);
  a190=(a166*a006);
  a183=(a183+a190);
  a183=(a112+a183);
  a218=(a218*a183);
  a205=(a205+a218);
  a408=(a408*a141);
  a162=(a162*a383);
  a164=(a164*a390);
  a162=(a162+a164);
  a165=(a165*a406);
  a162=(a162+a165);
  a407=(a407*a147);
  a413=(a413*a151);
  a407=(a407+a413);
  a177=(a177*a013);
  a176=(a176*a006);
  a177=(a177-a176);
  a407=(a407+a177);
  a407=(a407+a184);
  a166=(a166*a407);
  a162=(a162+a166);
  a162=(a029+a162);
  a163=(a163*a162);
  a408=(a408+a163);
  a205=(a205+a408);
  a200=(a200*a020);
  a203=(a203*a200);
  a204=(a204*a203);
  a208=(a208*a020);
  a204=(a204-a208);
  a206=(a206*a020);
  a204=(a204+a206);
  a206=(a204/a212);
  a213=(a213/a212);
  a211=(a211*a015);
  a213=(a213*a211);
  a206=(a206-a213);
  a214=(a214*a020);
  a213=(a214/a212);
  a212=(a216/a212);
  a212=(a212*a211);
  a213=(a213-a212);
  a212=(a223*a213);
  a217=(a217*a020);
  a222=(a222*a022);
  a211=(a220*a032);
  a208=2.5000000000000000e-01;
  a208=(a208*a002);
  a208=(a432+a208);
  a208=(a208*a008);
  a219=(a208*a219);
  a219=(a033*a219);
  a211=(a211+a219);
  a211=(a030*a211);
  a222=(a222+a211);
  a224=(a224*a003);
  a221=(a221*a011);
  a208=(a208*a220);
  a208=(a031*a208);
  a221=(a221-a208);
  a221=(a039-a221);
  a221=(a037*a221);
  a224=(a224+a221);
  a222=(a222+a224);
  a217=(a217-a222);
  a201=(a201*a213);
  a204=(a216*a204);
  a201=(a201+a204);
  a217=(a217-a201);
  a217=(a217/a202);
  a223=(a223/a202);
  a214=(a216*a214);
  a215=(a215*a213);
  a214=(a214+a215);
  a214=(a020-a214);
  a223=(a223*a214);
  a217=(a217-a223);
  a216=(a216*a217);
  a212=(a212+a216);
  a206=(a206-a212);
  a205=(a205+a206);
  a206=(a199*a205);
  a173=(a173+a206);
  a173=(a414+a173);
  a206=(a193*a173);
  a395=(a395+a206);
  a206=(a227*a016);
  a212=(a229*a110);
  a206=(a206+a212);
  a212=(a230*a140);
  a206=(a206+a212);
  a212=(a231*a172);
  a206=(a206+a212);
  a212=(a232*a205);
  a206=(a206+a212);
  a212=(a194*a414);
  a216=(a196*a123);
  a212=(a212+a216);
  a216=(a197*a153);
  a212=(a212+a216);
  a216=(a198*a013);
  a212=(a212+a216);
  a216=(a199*a141);
  a212=(a212+a216);
  a212=(a426+a212);
  a239=(a239*a212);
  a216=(a194*a029);
  a223=(a196*a046);
  a216=(a216+a223);
  a223=(a197*a132);
  a216=(a216+a223);
  a223=(a198*a006);
  a216=(a216+a223);
  a223=(a199*a162);
  a216=(a216+a223);
  a216=(a112+a216);
  a252=(a252*a216);
  a239=(a239+a252);
  a412=(a412*a173);
  a194=(a194*a383);
  a196=(a196*a390);
  a194=(a194+a196);
  a197=(a197*a406);
  a194=(a194+a197);
  a198=(a198*a407);
  a194=(a194+a198);
  a415=(a415*a179);
  a419=(a419*a183);
  a415=(a415+a419);
  a210=(a210*a141);
  a209=(a209*a162);
  a210=(a210-a209);
  a415=(a415+a210);
  a415=(a415+a217);
  a199=(a199*a415);
  a194=(a194+a199);
  a194=(a029+a194);
  a195=(a195*a194);
  a412=(a412+a195);
  a239=(a239+a412);
  a234=(a234*a020);
  a237=(a237*a234);
  a238=(a238*a237);
  a242=(a242*a020);
  a238=(a238-a242);
  a240=(a240*a020);
  a238=(a238+a240);
  a240=(a238/a246);
  a247=(a247/a246);
  a245=(a245*a015);
  a247=(a247*a245);
  a240=(a240-a247);
  a248=(a248*a020);
  a247=(a248/a246);
  a246=(a250/a246);
  a246=(a246*a245);
  a247=(a247-a246);
  a246=(a257*a247);
  a251=(a251*a020);
  a256=(a256*a022);
  a245=(a254*a032);
  a242=3.0769230769230771e-01;
  a242=(a242*a002);
  a242=(a432+a242);
  a242=(a242*a008);
  a253=(a242*a253);
  a253=(a033*a253);
  a245=(a245+a253);
  a245=(a030*a245);
  a256=(a256+a245);
  a258=(a258*a003);
  a255=(a255*a011);
  a242=(a242*a254);
  a242=(a031*a242);
  a255=(a255-a242);
  a255=(a039-a255);
  a255=(a037*a255);
  a258=(a258+a255);
  a256=(a256+a258);
  a251=(a251-a256);
  a235=(a235*a247);
  a238=(a250*a238);
  a235=(a235+a238);
  a251=(a251-a235);
  a251=(a251/a236);
  a257=(a257/a236);
  a248=(a250*a248);
  a249=(a249*a247);
  a248=(a248+a249);
  a248=(a020-a248);
  a257=(a257*a248);
  a251=(a251-a257);
  a250=(a250*a251);
  a246=(a246+a250);
  a240=(a240-a246);
  a239=(a239+a240);
  a240=(a233*a239);
  a206=(a206+a240);
  a206=(a414+a206);
  a240=(a226*a206);
  a395=(a395+a240);
  a240=(a261*a016);
  a246=(a263*a110);
  a240=(a240+a246);
  a246=(a264*a140);
  a240=(a240+a246);
  a246=(a265*a172);
  a240=(a240+a246);
  a246=(a266*a205);
  a240=(a240+a246);
  a246=(a267*a239);
  a240=(a240+a246);
  a246=(a227*a414);
  a250=(a229*a123);
  a246=(a246+a250);
  a250=(a230*a153);
  a246=(a246+a250);
  a250=(a231*a013);
  a246=(a246+a250);
  a250=(a232*a141);
  a246=(a246+a250);
  a250=(a233*a173);
  a246=(a246+a250);
  a246=(a426+a246);
  a274=(a274*a246);
  a250=(a227*a029);
  a257=(a229*a046);
  a250=(a250+a257);
  a257=(a230*a132);
  a250=(a250+a257);
  a257=(a231*a006);
  a250=(a250+a257);
  a257=(a232*a162);
  a250=(a250+a257);
  a257=(a233*a194);
  a250=(a250+a257);
  a250=(a112+a250);
  a287=(a287*a250);
  a274=(a274+a287);
  a418=(a418*a206);
  a227=(a227*a383);
  a229=(a229*a390);
  a227=(a227+a229);
  a230=(a230*a406);
  a227=(a227+a230);
  a231=(a231*a407);
  a227=(a227+a231);
  a232=(a232*a415);
  a227=(a227+a232);
  a421=(a421*a212);
  a425=(a425*a216);
  a421=(a421+a425);
  a244=(a244*a173);
  a243=(a243*a194);
  a244=(a244-a243);
  a421=(a421+a244);
  a421=(a421+a251);
  a233=(a233*a421);
  a227=(a227+a233);
  a227=(a029+a227);
  a228=(a228*a227);
  a418=(a418+a228);
  a274=(a274+a418);
  a269=(a269*a020);
  a272=(a272*a269);
  a273=(a273*a272);
  a277=(a277*a020);
  a273=(a273-a277);
  a275=(a275*a020);
  a273=(a273+a275);
  a275=(a273/a281);
  a282=(a282/a281);
  a280=(a280*a015);
  a282=(a282*a280);
  a275=(a275-a282);
  a283=(a283*a020);
  a282=(a283/a281);
  a281=(a285/a281);
  a281=(a281*a280);
  a282=(a282-a281);
  a281=(a292*a282);
  a286=(a286*a020);
  a291=(a291*a022);
  a280=(a289*a032);
  a277=6.5128205128205130e-01;
  a277=(a277*a002);
  a277=(a432+a277);
  a277=(a277*a008);
  a288=(a277*a288);
  a288=(a033*a288);
  a280=(a280+a288);
  a280=(a030*a280);
  a291=(a291+a280);
  a293=(a293*a003);
  a290=(a290*a011);
  a277=(a277*a289);
  a277=(a031*a277);
  a290=(a290-a277);
  a290=(a039-a290);
  a290=(a037*a290);
  a293=(a293+a290);
  a291=(a291+a293);
  a286=(a286-a291);
  a270=(a270*a282);
  a273=(a285*a273);
  a270=(a270+a273);
  a286=(a286-a270);
  a286=(a286/a271);
  a292=(a292/a271);
  a283=(a285*a283);
  a284=(a284*a282);
  a283=(a283+a284);
  a283=(a020-a283);
  a292=(a292*a283);
  a286=(a286-a292);
  a285=(a285*a286);
  a281=(a281+a285);
  a275=(a275-a281);
  a274=(a274+a275);
  a275=(a268*a274);
  a240=(a240+a275);
  a240=(a414+a240);
  a275=(a260*a240);
  a395=(a395+a275);
  a275=(a296*a016);
  a281=(a298*a110);
  a275=(a275+a281);
  a281=(a299*a140);
  a275=(a275+a281);
  a281=(a300*a172);
  a275=(a275+a281);
  a281=(a301*a205);
  a275=(a275+a281);
  a281=(a302*a239);
  a275=(a275+a281);
  a281=(a303*a274);
  a275=(a275+a281);
  a281=(a261*a414);
  a285=(a263*a123);
  a281=(a281+a285);
  a285=(a264*a153);
  a281=(a281+a285);
  a285=(a265*a013);
  a281=(a281+a285);
  a285=(a266*a141);
  a281=(a281+a285);
  a285=(a267*a173);
  a281=(a281+a285);
  a285=(a268*a206);
  a281=(a281+a285);
  a281=(a426+a281);
  a310=(a310*a281);
  a285=(a261*a029);
  a292=(a263*a046);
  a285=(a285+a292);
  a292=(a264*a132);
  a285=(a285+a292);
  a292=(a265*a006);
  a285=(a285+a292);
  a292=(a266*a162);
  a285=(a285+a292);
  a292=(a267*a194);
  a285=(a285+a292);
  a292=(a268*a227);
  a285=(a285+a292);
  a285=(a112+a285);
  a323=(a323*a285);
  a310=(a310+a323);
  a424=(a424*a240);
  a261=(a261*a383);
  a263=(a263*a390);
  a261=(a261+a263);
  a264=(a264*a406);
  a261=(a261+a264);
  a265=(a265*a407);
  a261=(a261+a265);
  a266=(a266*a415);
  a261=(a261+a266);
  a267=(a267*a421);
  a261=(a261+a267);
  a427=(a427*a246);
  a431=(a431*a250);
  a427=(a427+a431);
  a279=(a279*a206);
  a278=(a278*a227);
  a279=(a279-a278);
  a427=(a427+a279);
  a427=(a427+a286);
  a268=(a268*a427);
  a261=(a261+a268);
  a261=(a029+a261);
  a262=(a262*a261);
  a424=(a424+a262);
  a310=(a310+a424);
  a305=(a305*a020);
  a308=(a308*a305);
  a309=(a309*a308);
  a313=(a313*a020);
  a309=(a309-a313);
  a311=(a311*a020);
  a309=(a309+a311);
  a311=(a309/a317);
  a318=(a318/a317);
  a316=(a316*a015);
  a318=(a318*a316);
  a311=(a311-a318);
  a319=(a319*a020);
  a318=(a319/a317);
  a317=(a321/a317);
  a317=(a317*a316);
  a318=(a318-a317);
  a317=(a328*a318);
  a322=(a322*a020);
  a327=(a327*a022);
  a316=(a325*a032);
  a313=5.9999999999999998e-01;
  a313=(a313*a002);
  a313=(a432+a313);
  a313=(a313*a008);
  a324=(a313*a324);
  a324=(a033*a324);
  a316=(a316+a324);
  a316=(a030*a316);
  a327=(a327+a316);
  a329=(a329*a003);
  a326=(a326*a011);
  a313=(a313*a325);
  a313=(a031*a313);
  a326=(a326-a313);
  a326=(a039-a326);
  a326=(a037*a326);
  a329=(a329+a326);
  a327=(a327+a329);
  a322=(a322-a327);
  a306=(a306*a318);
  a309=(a321*a309);
  a306=(a306+a309);
  a322=(a322-a306);
  a322=(a322/a307);
  a328=(a328/a307);
  a319=(a321*a319);
  a320=(a320*a318);
  a319=(a319+a320);
  a319=(a020-a319);
  a328=(a328*a319);
  a322=(a322-a328);
  a321=(a321*a322);
  a317=(a317+a321);
  a311=(a311-a317);
  a310=(a310+a311);
  a311=(a304*a310);
  a275=(a275+a311);
  a275=(a414+a275);
  a311=(a295*a275);
  a395=(a395+a311);
  a311=(a332*a016);
  a110=(a334*a110);
  a311=(a311+a110);
  a140=(a130*a140);
  a311=(a311+a140);
  a140=(a160*a172);
  a311=(a311+a140);
  a140=(a335*a205);
  a311=(a311+a140);
  a140=(a336*a239);
  a311=(a311+a140);
  a140=(a337*a274);
  a311=(a311+a140);
  a140=(a338*a310);
  a311=(a311+a140);
  a140=(a296*a414);
  a110=(a298*a123);
  a140=(a140+a110);
  a110=(a299*a153);
  a140=(a140+a110);
  a110=(a300*a013);
  a140=(a140+a110);
  a110=(a301*a141);
  a140=(a140+a110);
  a110=(a302*a173);
  a140=(a140+a110);
  a110=(a303*a206);
  a140=(a140+a110);
  a110=(a304*a240);
  a140=(a140+a110);
  a140=(a426+a140);
  a345=(a345*a140);
  a110=(a296*a029);
  a317=(a298*a046);
  a110=(a110+a317);
  a317=(a299*a132);
  a110=(a110+a317);
  a317=(a300*a006);
  a110=(a110+a317);
  a317=(a301*a162);
  a110=(a110+a317);
  a317=(a302*a194);
  a110=(a110+a317);
  a317=(a303*a227);
  a110=(a110+a317);
  a317=(a304*a261);
  a110=(a110+a317);
  a110=(a112+a110);
  a358=(a358*a110);
  a345=(a345+a358);
  a391=(a391*a275);
  a296=(a296*a383);
  a298=(a298*a390);
  a296=(a296+a298);
  a299=(a299*a406);
  a296=(a296+a299);
  a300=(a300*a407);
  a296=(a296+a300);
  a301=(a301*a415);
  a296=(a296+a301);
  a302=(a302*a421);
  a296=(a296+a302);
  a303=(a303*a427);
  a296=(a296+a303);
  a433=(a433*a281);
  a437=(a437*a285);
  a433=(a433+a437);
  a315=(a315*a240);
  a314=(a314*a261);
  a315=(a315-a314);
  a433=(a433+a315);
  a433=(a433+a322);
  a304=(a304*a433);
  a296=(a296+a304);
  a296=(a029+a296);
  a297=(a297*a296);
  a391=(a391+a297);
  a345=(a345+a391);
  a340=(a340*a020);
  a343=(a343*a340);
  a344=(a344*a343);
  a348=(a348*a020);
  a344=(a344-a348);
  a346=(a346*a020);
  a344=(a344+a346);
  a346=(a344/a352);
  a353=(a353/a352);
  a351=(a351*a015);
  a353=(a353*a351);
  a346=(a346-a353);
  a354=(a354*a020);
  a353=(a354/a352);
  a352=(a356/a352);
  a352=(a352*a351);
  a353=(a353-a352);
  a352=(a363*a353);
  a357=(a357*a020);
  a362=(a362*a022);
  a351=(a360*a032);
  a348=8.5714285714285710e-01;
  a348=(a348*a002);
  a348=(a432+a348);
  a348=(a348*a008);
  a359=(a348*a359);
  a359=(a033*a359);
  a351=(a351+a359);
  a351=(a030*a351);
  a362=(a362+a351);
  a364=(a364*a003);
  a361=(a361*a011);
  a348=(a348*a360);
  a348=(a031*a348);
  a361=(a361-a348);
  a361=(a039-a361);
  a361=(a037*a361);
  a364=(a364+a361);
  a362=(a362+a364);
  a357=(a357-a362);
  a341=(a341*a353);
  a344=(a356*a344);
  a341=(a341+a344);
  a357=(a357-a341);
  a357=(a357/a342);
  a363=(a363/a342);
  a354=(a356*a354);
  a355=(a355*a353);
  a354=(a354+a355);
  a354=(a020-a354);
  a363=(a363*a354);
  a357=(a357-a363);
  a356=(a356*a357);
  a352=(a352+a356);
  a346=(a346-a352);
  a345=(a345+a346);
  a346=(a339*a345);
  a311=(a311+a346);
  a311=(a414+a311);
  a346=(a331*a311);
  a395=(a395+a346);
  a395=(a426+a395);
  if (res[0]!=0) res[0][16]=a395;
  a395=(a001*a029);
  a346=(a005*a006);
  a395=(a395+a346);
  a346=(a161*a162);
  a395=(a395+a346);
  a346=(a193*a194);
  a395=(a395+a346);
  a346=(a226*a227);
  a395=(a395+a346);
  a346=(a260*a261);
  a395=(a395+a346);
  a346=(a295*a296);
  a395=(a395+a346);
  a346=(a332*a383);
  a390=(a334*a390);
  a346=(a346+a390);
  a406=(a130*a406);
  a346=(a346+a406);
  a406=(a160*a407);
  a346=(a346+a406);
  a406=(a335*a415);
  a346=(a346+a406);
  a406=(a336*a421);
  a346=(a346+a406);
  a406=(a337*a427);
  a346=(a346+a406);
  a406=(a338*a433);
  a346=(a346+a406);
  a430=(a430*a140);
  a441=(a441*a110);
  a430=(a430+a441);
  a350=(a350*a275);
  a349=(a349*a296);
  a350=(a350-a349);
  a430=(a430+a350);
  a430=(a430+a357);
  a357=(a339*a430);
  a346=(a346+a357);
  a346=(a029+a346);
  a357=(a331*a346);
  a395=(a395+a357);
  a395=(a112+a395);
  if (res[0]!=0) res[0][17]=a395;
  a016=(a001*a016);
  a172=(a005*a172);
  a016=(a016+a172);
  a205=(a161*a205);
  a016=(a016+a205);
  a239=(a193*a239);
  a016=(a016+a239);
  a274=(a226*a274);
  a016=(a016+a274);
  a310=(a260*a310);
  a016=(a016+a310);
  a345=(a295*a345);
  a016=(a016+a345);
  a345=(a332*a414);
  a123=(a334*a123);
  a345=(a345+a123);
  a153=(a130*a153);
  a345=(a345+a153);
  a013=(a160*a013);
  a345=(a345+a013);
  a141=(a335*a141);
  a345=(a345+a141);
  a173=(a336*a173);
  a345=(a345+a173);
  a206=(a337*a206);
  a345=(a345+a206);
  a240=(a338*a240);
  a345=(a345+a240);
  a275=(a339*a275);
  a345=(a345+a275);
  a426=(a426+a345);
  a000=(a000*a426);
  a332=(a332*a029);
  a334=(a334*a046);
  a332=(a332+a334);
  a130=(a130*a132);
  a332=(a332+a130);
  a160=(a160*a006);
  a332=(a332+a160);
  a335=(a335*a162);
  a332=(a332+a335);
  a336=(a336*a194);
  a332=(a332+a336);
  a337=(a337*a227);
  a332=(a332+a337);
  a338=(a338*a261);
  a332=(a332+a338);
  a339=(a339*a296);
  a332=(a332+a339);
  a112=(a112+a332);
  a374=(a374*a112);
  a000=(a000+a374);
  a241=(a241*a311);
  a333=(a333*a346);
  a241=(a241+a333);
  a000=(a000+a241);
  a366=(a366*a020);
  a330=(a330*a366);
  a294=(a294*a330);
  a192=(a192*a020);
  a294=(a294-a192);
  a259=(a259*a020);
  a294=(a294+a259);
  a259=(a294/a368);
  a369=(a369/a368);
  a367=(a367*a015);
  a369=(a369*a367);
  a259=(a259-a369);
  a370=(a370*a020);
  a369=(a370/a368);
  a368=(a372/a368);
  a368=(a368*a367);
  a369=(a369-a368);
  a368=(a379*a369);
  a373=(a373*a020);
  a378=(a378*a022);
  a032=(a376*a032);
  a432=(a432+a002);
  a432=(a432*a008);
  a375=(a432*a375);
  a033=(a033*a375);
  a032=(a032+a033);
  a030=(a030*a032);
  a378=(a378+a030);
  a038=(a038*a003);
  a018=(a018*a011);
  a432=(a432*a376);
  a031=(a031*a432);
  a018=(a018-a031);
  a039=(a039-a018);
  a037=(a037*a039);
  a038=(a038+a037);
  a378=(a378+a038);
  a373=(a373-a378);
  a365=(a365*a369);
  a294=(a372*a294);
  a365=(a365+a294);
  a373=(a373-a365);
  a373=(a373/a010);
  a379=(a379/a010);
  a370=(a372*a370);
  a371=(a371*a369);
  a370=(a370+a371);
  a020=(a020-a370);
  a379=(a379*a020);
  a373=(a373-a379);
  a372=(a372*a373);
  a368=(a368+a372);
  a259=(a259-a368);
  a000=(a000+a259);
  a000=(a331*a000);
  a016=(a016+a000);
  a414=(a414+a016);
  if (res[0]!=0) res[0][18]=a414;
  a001=(a001*a383);
  a005=(a005*a407);
  a001=(a001+a005);
  a161=(a161*a415);
  a001=(a001+a161);
  a193=(a193*a421);
  a001=(a001+a193);
  a226=(a226*a427);
  a001=(a001+a226);
  a260=(a260*a433);
  a001=(a001+a260);
  a295=(a295*a430);
  a001=(a001+a295);
  a428=(a428*a426);
  a007=(a007*a112);
  a428=(a428+a007);
  a439=(a439*a311);
  a021=(a021*a346);
  a439=(a439-a021);
  a428=(a428+a439);
  a428=(a428+a373);
  a331=(a331*a428);
  a001=(a001+a331);
  a029=(a029+a001);
  if (res[0]!=0) res[0][19]=a029;
  return 0;
}

/* step_alongs:(y[4x5],t,turns[2x12],h,p[6],d[6])->(y_end[4x5]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+443, w1, *w2=w+463, *w3=w+469, w5, *w6=w+471, *w7=w+477, w8;
  const casadi_real **arg1=arg+6, *wr0, *wr4;
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
  /* #6: @6 = input[5][0] */
  casadi_copy(arg[5], 6, w6);
  /* #7: @7 = step_along(@0, @3, @4, @5, @2, @1, @6) */
  arg1[0]=wr0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w1);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #8: @8 = (@1+@5) */
  w8  = (w1+w5);
  /* #9: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #10: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #11: @8 = (2.*@5) */
  w8 = (2.* w5 );
  /* #12: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #13: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #14: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #15: @8 = 3 */
  w8 = 3.;
  /* #16: @8 = (@8*@5) */
  w8 *= w5;
  /* #17: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #18: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #20: @8 = 4 */
  w8 = 4.;
  /* #21: @8 = (@8*@5) */
  w8 *= w5;
  /* #22: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #23: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #25: @8 = 5 */
  w8 = 5.;
  /* #26: @8 = (@8*@5) */
  w8 *= w5;
  /* #27: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #28: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #29: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #30: @8 = 6 */
  w8 = 6.;
  /* #31: @8 = (@8*@5) */
  w8 *= w5;
  /* #32: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #33: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #35: @8 = 7 */
  w8 = 7.;
  /* #36: @8 = (@8*@5) */
  w8 *= w5;
  /* #37: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #38: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #39: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #40: @8 = 8 */
  w8 = 8.;
  /* #41: @8 = (@8*@5) */
  w8 *= w5;
  /* #42: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #43: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #44: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #45: @8 = 9 */
  w8 = 9.;
  /* #46: @8 = (@8*@5) */
  w8 *= w5;
  /* #47: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #48: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #49: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #50: @8 = 10 */
  w8 = 10.;
  /* #51: @8 = (@8*@5) */
  w8 *= w5;
  /* #52: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #53: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #55: @8 = 11 */
  w8 = 11.;
  /* #56: @8 = (@8*@5) */
  w8 *= w5;
  /* #57: @1 = (@1+@8) */
  w1 += w8;
  /* #58: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #59: @0 = step_along(@7, @3, @4, @5, @2, @1, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w1);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][0] = @0 */
  casadi_copy(w0, 20, res[0]);
  return 0;
}

/* landing_along:(y[4x5],z[3],T,p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
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
  a08=(a06*a07);
  a08=(a08+a03);
  a09=(a04/a08);
  a10=(a04-a03);
  a11=(a05*a10);
  a12=(a11/a08);
  a13=(a12*a04);
  a14=(a11*a12);
  a14=(a05-a14);
  a13=(a13/a14);
  a15=(a12*a13);
  a09=(a09+a15);
  a15=arg[0]? arg[0][6] : 0;
  a16=(a09*a15);
  a17=arg[0]? arg[0][2] : 0;
  a18=sin(a02);
  a19=(a17*a18);
  a20=(a19/a08);
  a21=(a04*a17);
  a22=(a21/a08);
  a23=(a22/a08);
  a24=(a06*a18);
  a25=(a23*a24);
  a20=(a20+a25);
  a25=(a12*a21);
  a25=(a25/a14);
  a26=(a05*a18);
  a27=(a26/a08);
  a28=(a12/a08);
  a24=(a28*a24);
  a27=(a27+a24);
  a24=(a25*a27);
  a29=(a21*a27);
  a19=(a12*a19);
  a29=(a29+a19);
  a29=(a29/a14);
  a19=(a25/a14);
  a26=(a12*a26);
  a27=(a11*a27);
  a26=(a26+a27);
  a26=(a19*a26);
  a29=(a29+a26);
  a26=(a12*a29);
  a24=(a24+a26);
  a20=(a20+a24);
  a24=(a20*a01);
  a16=(a16-a24);
  if (res[0]!=0) res[0][1]=a16;
  a16=(a29*a01);
  a15=(a13*a15);
  a16=(a16-a15);
  if (res[0]!=0) res[0][2]=a16;
  a16=-2.;
  a00=(a16*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a15=(a00-a01);
  if (res[0]!=0) res[0][4]=a15;
  a15=arg[0]? arg[0][10] : 0;
  a24=(a09*a15);
  a26=(a20*a01);
  a24=(a24-a26);
  a24=(a24-a03);
  if (res[0]!=0) res[0][5]=a24;
  a24=(a29*a01);
  a15=(a13*a15);
  a24=(a24-a15);
  if (res[0]!=0) res[0][6]=a24;
  a00=(a16*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a24=(a00-a01);
  if (res[0]!=0) res[0][8]=a24;
  a24=arg[0]? arg[0][14] : 0;
  a15=(a09*a24);
  a26=(a20*a01);
  a15=(a15-a26);
  if (res[0]!=0) res[0][9]=a15;
  a15=(a29*a01);
  a24=(a13*a24);
  a15=(a15-a24);
  a15=(a15-a03);
  if (res[0]!=0) res[0][10]=a15;
  a00=(a16*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=arg[0]? arg[0][3] : 0;
  a01=(a17-a00);
  if (res[0]!=0) res[0][12]=a01;
  a01=(a05*a00);
  a01=(a01*a18);
  a15=(2.*a17);
  a15=(a00-a15);
  a01=(a01*a15);
  a15=arg[0]? arg[0][0] : 0;
  a24=(a15-a02);
  a26=sin(a24);
  a27=(a05*a26);
  a01=(a01-a27);
  a27=sin(a15);
  a30=(a05+a03);
  a27=(a27*a30);
  a01=(a01+a27);
  a27=(a01/a08);
  a30=casadi_sq(a17);
  a30=(a30*a18);
  a30=(a30+a26);
  a30=(a05*a30);
  a26=arg[3]? arg[3][3] : 0;
  a31=arg[3]? arg[3][5] : 0;
  a32=arg[3]? arg[3][0] : 0;
  a33=(a31*a32);
  a34=arg[2]? arg[2][0] : 0;
  a32=(a32*a34);
  a34=sin(a32);
  a33=(a33*a34);
  a33=(a00+a33);
  a26=(a26*a33);
  a33=arg[3]? arg[3][2] : 0;
  a34=arg[3]? arg[3][4] : 0;
  a32=cos(a32);
  a32=(a32+a03);
  a31=(a31*a32);
  a34=(a34-a31);
  a34=(a34+a02);
  a33=(a33*a34);
  a26=(a26+a33);
  a30=(a30-a26);
  a01=(a12*a01);
  a30=(a30-a01);
  a30=(a30/a14);
  a30=(a12*a30);
  a27=(a27-a30);
  a09=(a09*a27);
  a20=(a20*a00);
  a09=(a09-a20);
  if (res[0]!=0) res[0][13]=a09;
  a29=(a29*a00);
  a13=(a13*a27);
  a29=(a29-a13);
  if (res[0]!=0) res[0][14]=a29;
  a16=(a16*a17);
  a16=(a16+a00);
  if (res[0]!=0) res[0][15]=a16;
  a16=arg[0]? arg[0][16] : 0;
  a00=arg[0]? arg[0][17] : 0;
  a29=(a16-a00);
  if (res[1]!=0) res[1][0]=a29;
  a29=arg[0]? arg[0][18] : 0;
  a04=(a04*a29);
  a18=(a18*a00);
  a17=(a17*a18);
  a04=(a04-a17);
  a17=(a04/a08);
  a29=arg[4]? arg[4][1] : 0;
  a13=(2.*a29);
  a07=(a07*a13);
  a06=(a06*a18);
  a07=(a07+a06);
  a23=(a23*a07);
  a17=(a17-a23);
  a10=(a10*a29);
  a05=(a05*a18);
  a10=(a10-a05);
  a08=(a10/a08);
  a28=(a28*a07);
  a08=(a08-a28);
  a28=(a25*a08);
  a21=(a21*a08);
  a04=(a12*a04);
  a21=(a21+a04);
  a21=(a21/a14);
  a10=(a12*a10);
  a11=(a11*a08);
  a10=(a10+a11);
  a29=(a29-a10);
  a19=(a19*a29);
  a21=(a21-a19);
  a19=(a12*a21);
  a28=(a28+a19);
  a17=(a17+a28);
  if (res[1]!=0) res[1][1]=a17;
  a21=(-a21);
  if (res[1]!=0) res[1][2]=a21;
  a16=(2.*a16);
  a00=(a00-a16);
  if (res[1]!=0) res[1][3]=a00;
  a00=arg[1]? arg[1][0] : 0;
  a24=(a24-a00);
  if (res[2]!=0) res[2][0]=a24;
  a12=(a12*a25);
  a22=(a22+a12);
  a12=arg[1]? arg[1][1] : 0;
  a22=(a22-a12);
  if (res[2]!=0) res[2][1]=a22;
  a22=arg[1]? arg[1][2] : 0;
  a25=(a25+a22);
  a25=(-a25);
  if (res[2]!=0) res[2][2]=a25;
  a15=(2.*a15);
  a02=(a02-a15);
  if (res[2]!=0) res[2][3]=a02;
  return 0;
}

/* compass_jacobian_along_12:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 12 */
  w07 = 12.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@10, @0, @11} = landing_along(@9, @1, @6, @2, @3) */
  arg1[0]=w09;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #14: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_12_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_12_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_24:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 24 */
  w07 = 24.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #17: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_24_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_36:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 36 */
  w07 = 36.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.333333 */
  w05 = 3.3333333333333331e-01;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.666667 */
  w05 = 6.6666666666666663e-01;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@10, @0, @11} = landing_along(@9, @1, @6, @2, @3) */
  arg1[0]=w09;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #20: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_36_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_48:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 48 */
  w07 = 48.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.25 */
  w05 = 2.5000000000000000e-01;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.75 */
  w05 = 7.5000000000000000e-01;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #23: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_48_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_72:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 72 */
  w07 = 72.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.166667 */
  w05 = 1.6666666666666666e-01;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.333333 */
  w05 = 3.3333333333333331e-01;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.666667 */
  w05 = 6.6666666666666663e-01;
  /* #21: @5 = (@5*@6) */
  w05 *= w06;
  /* #22: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #23: @5 = 0.833333 */
  w05 = 8.3333333333333337e-01;
  /* #24: @5 = (@5*@6) */
  w05 *= w06;
  /* #25: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #29: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_72_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_96:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 96 */
  w07 = 96.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.125 */
  w05 = 1.2500000000000000e-01;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.25 */
  w05 = 2.5000000000000000e-01;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.375 */
  w05 = 3.7500000000000000e-01;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w05 *= w06;
  /* #22: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #23: @5 = 0.625 */
  w05 = 6.2500000000000000e-01;
  /* #24: @5 = (@5*@6) */
  w05 *= w06;
  /* #25: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 0.75 */
  w05 = 7.5000000000000000e-01;
  /* #27: @5 = (@5*@6) */
  w05 *= w06;
  /* #28: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #29: @5 = 0.875 */
  w05 = 8.7500000000000000e-01;
  /* #30: @5 = (@5*@6) */
  w05 *= w06;
  /* #31: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #35: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_96_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_144:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 144 */
  w07 = 144.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.0833333 */
  w05 = 8.3333333333333329e-02;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.166667 */
  w05 = 1.6666666666666666e-01;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.25 */
  w05 = 2.5000000000000000e-01;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.333333 */
  w05 = 3.3333333333333331e-01;
  /* #21: @5 = (@5*@6) */
  w05 *= w06;
  /* #22: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #23: @5 = 0.416667 */
  w05 = 4.1666666666666669e-01;
  /* #24: @5 = (@5*@6) */
  w05 *= w06;
  /* #25: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #27: @5 = (@5*@6) */
  w05 *= w06;
  /* #28: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #29: @5 = 0.583333 */
  w05 = 5.8333333333333337e-01;
  /* #30: @5 = (@5*@6) */
  w05 *= w06;
  /* #31: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #32: @5 = 0.666667 */
  w05 = 6.6666666666666663e-01;
  /* #33: @5 = (@5*@6) */
  w05 *= w06;
  /* #34: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.75 */
  w05 = 7.5000000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w05 *= w06;
  /* #37: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #38: @5 = 0.833333 */
  w05 = 8.3333333333333337e-01;
  /* #39: @5 = (@5*@6) */
  w05 *= w06;
  /* #40: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #41: @5 = 0.916667 */
  w05 = 9.1666666666666663e-01;
  /* #42: @5 = (@5*@6) */
  w05 *= w06;
  /* #43: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #47: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_144_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_192:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 192 */
  w07 = 192.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.0625 */
  w05 = 6.2500000000000000e-02;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.125 */
  w05 = 1.2500000000000000e-01;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.1875 */
  w05 = 1.8750000000000000e-01;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.25 */
  w05 = 2.5000000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w05 *= w06;
  /* #22: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #23: @5 = 0.3125 */
  w05 = 3.1250000000000000e-01;
  /* #24: @5 = (@5*@6) */
  w05 *= w06;
  /* #25: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 0.375 */
  w05 = 3.7500000000000000e-01;
  /* #27: @5 = (@5*@6) */
  w05 *= w06;
  /* #28: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #29: @5 = 0.4375 */
  w05 = 4.3750000000000000e-01;
  /* #30: @5 = (@5*@6) */
  w05 *= w06;
  /* #31: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #32: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #33: @5 = (@5*@6) */
  w05 *= w06;
  /* #34: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.5625 */
  w05 = 5.6250000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w05 *= w06;
  /* #37: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #38: @5 = 0.625 */
  w05 = 6.2500000000000000e-01;
  /* #39: @5 = (@5*@6) */
  w05 *= w06;
  /* #40: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #41: @5 = 0.6875 */
  w05 = 6.8750000000000000e-01;
  /* #42: @5 = (@5*@6) */
  w05 *= w06;
  /* #43: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #44: @5 = 0.75 */
  w05 = 7.5000000000000000e-01;
  /* #45: @5 = (@5*@6) */
  w05 *= w06;
  /* #46: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #47: @5 = 0.8125 */
  w05 = 8.1250000000000000e-01;
  /* #48: @5 = (@5*@6) */
  w05 *= w06;
  /* #49: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.875 */
  w05 = 8.7500000000000000e-01;
  /* #51: @5 = (@5*@6) */
  w05 *= w06;
  /* #52: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #53: @5 = 0.9375 */
  w05 = 9.3750000000000000e-01;
  /* #54: @5 = (@5*@6) */
  w05 *= w06;
  /* #55: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #59: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_192_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_288:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 288 */
  w07 = 288.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.0416667 */
  w05 = 4.1666666666666664e-02;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.0833333 */
  w05 = 8.3333333333333329e-02;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.125 */
  w05 = 1.2500000000000000e-01;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.166667 */
  w05 = 1.6666666666666666e-01;
  /* #21: @5 = (@5*@6) */
  w05 *= w06;
  /* #22: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #23: @5 = 0.208333 */
  w05 = 2.0833333333333334e-01;
  /* #24: @5 = (@5*@6) */
  w05 *= w06;
  /* #25: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 0.25 */
  w05 = 2.5000000000000000e-01;
  /* #27: @5 = (@5*@6) */
  w05 *= w06;
  /* #28: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #29: @5 = 0.291667 */
  w05 = 2.9166666666666669e-01;
  /* #30: @5 = (@5*@6) */
  w05 *= w06;
  /* #31: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #32: @5 = 0.333333 */
  w05 = 3.3333333333333331e-01;
  /* #33: @5 = (@5*@6) */
  w05 *= w06;
  /* #34: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.375 */
  w05 = 3.7500000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w05 *= w06;
  /* #37: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #38: @5 = 0.416667 */
  w05 = 4.1666666666666669e-01;
  /* #39: @5 = (@5*@6) */
  w05 *= w06;
  /* #40: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #41: @5 = 0.458333 */
  w05 = 4.5833333333333331e-01;
  /* #42: @5 = (@5*@6) */
  w05 *= w06;
  /* #43: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #44: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #45: @5 = (@5*@6) */
  w05 *= w06;
  /* #46: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #47: @5 = 0.541667 */
  w05 = 5.4166666666666663e-01;
  /* #48: @5 = (@5*@6) */
  w05 *= w06;
  /* #49: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.583333 */
  w05 = 5.8333333333333337e-01;
  /* #51: @5 = (@5*@6) */
  w05 *= w06;
  /* #52: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #53: @5 = 0.625 */
  w05 = 6.2500000000000000e-01;
  /* #54: @5 = (@5*@6) */
  w05 *= w06;
  /* #55: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #56: @5 = 0.666667 */
  w05 = 6.6666666666666663e-01;
  /* #57: @5 = (@5*@6) */
  w05 *= w06;
  /* #58: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #59: @5 = 0.708333 */
  w05 = 7.0833333333333337e-01;
  /* #60: @5 = (@5*@6) */
  w05 *= w06;
  /* #61: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #62: @5 = 0.75 */
  w05 = 7.5000000000000000e-01;
  /* #63: @5 = (@5*@6) */
  w05 *= w06;
  /* #64: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #65: @5 = 0.791667 */
  w05 = 7.9166666666666663e-01;
  /* #66: @5 = (@5*@6) */
  w05 *= w06;
  /* #67: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #68: @5 = 0.833333 */
  w05 = 8.3333333333333337e-01;
  /* #69: @5 = (@5*@6) */
  w05 *= w06;
  /* #70: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #71: @5 = 0.875 */
  w05 = 8.7500000000000000e-01;
  /* #72: @5 = (@5*@6) */
  w05 *= w06;
  /* #73: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #74: @5 = 0.916667 */
  w05 = 9.1666666666666663e-01;
  /* #75: @5 = (@5*@6) */
  w05 *= w06;
  /* #76: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #77: @5 = 0.958333 */
  w05 = 9.5833333333333337e-01;
  /* #78: @5 = (@5*@6) */
  w05 *= w06;
  /* #79: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #83: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_288_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* compass_jacobian_along_384:(u[4],p[6],d[6])->(J[4x4],R_d[4],R[4]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+524, *w01=w+528, *w02=w+531, *w03=w+537, *w04=w+543, w05, w06, w07, *w08=w+563, *w09=w+587;
  casadi_real *w10=w+607, *w11=w+623;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 6, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 6, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[3] */
  for (rr=(&w06), cs=w00+3; cs!=w00+4; cs+=1) *rr++ = *cs;
  /* #7: @7 = 384 */
  w07 = 384.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: @5 = 0.03125 */
  w05 = 3.1250000000000000e-02;
  /* #12: @5 = (@5*@6) */
  w05 *= w06;
  /* #13: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 0.0625 */
  w05 = 6.2500000000000000e-02;
  /* #15: @5 = (@5*@6) */
  w05 *= w06;
  /* #16: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: @5 = 0.09375 */
  w05 = 9.3750000000000000e-02;
  /* #18: @5 = (@5*@6) */
  w05 *= w06;
  /* #19: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.125 */
  w05 = 1.2500000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w05 *= w06;
  /* #22: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #23: @5 = 0.15625 */
  w05 = 1.5625000000000000e-01;
  /* #24: @5 = (@5*@6) */
  w05 *= w06;
  /* #25: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 0.1875 */
  w05 = 1.8750000000000000e-01;
  /* #27: @5 = (@5*@6) */
  w05 *= w06;
  /* #28: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #29: @5 = 0.21875 */
  w05 = 2.1875000000000000e-01;
  /* #30: @5 = (@5*@6) */
  w05 *= w06;
  /* #31: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #32: @5 = 0.25 */
  w05 = 2.5000000000000000e-01;
  /* #33: @5 = (@5*@6) */
  w05 *= w06;
  /* #34: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.28125 */
  w05 = 2.8125000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w05 *= w06;
  /* #37: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #38: @5 = 0.3125 */
  w05 = 3.1250000000000000e-01;
  /* #39: @5 = (@5*@6) */
  w05 *= w06;
  /* #40: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #41: @5 = 0.34375 */
  w05 = 3.4375000000000000e-01;
  /* #42: @5 = (@5*@6) */
  w05 *= w06;
  /* #43: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #44: @5 = 0.375 */
  w05 = 3.7500000000000000e-01;
  /* #45: @5 = (@5*@6) */
  w05 *= w06;
  /* #46: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #47: @5 = 0.40625 */
  w05 = 4.0625000000000000e-01;
  /* #48: @5 = (@5*@6) */
  w05 *= w06;
  /* #49: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.4375 */
  w05 = 4.3750000000000000e-01;
  /* #51: @5 = (@5*@6) */
  w05 *= w06;
  /* #52: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #53: @5 = 0.46875 */
  w05 = 4.6875000000000000e-01;
  /* #54: @5 = (@5*@6) */
  w05 *= w06;
  /* #55: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #56: @5 = 0.5 */
  w05 = 5.0000000000000000e-01;
  /* #57: @5 = (@5*@6) */
  w05 *= w06;
  /* #58: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #59: @5 = 0.53125 */
  w05 = 5.3125000000000000e-01;
  /* #60: @5 = (@5*@6) */
  w05 *= w06;
  /* #61: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #62: @5 = 0.5625 */
  w05 = 5.6250000000000000e-01;
  /* #63: @5 = (@5*@6) */
  w05 *= w06;
  /* #64: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #65: @5 = 0.59375 */
  w05 = 5.9375000000000000e-01;
  /* #66: @5 = (@5*@6) */
  w05 *= w06;
  /* #67: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #68: @5 = 0.625 */
  w05 = 6.2500000000000000e-01;
  /* #69: @5 = (@5*@6) */
  w05 *= w06;
  /* #70: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #71: @5 = 0.65625 */
  w05 = 6.5625000000000000e-01;
  /* #72: @5 = (@5*@6) */
  w05 *= w06;
  /* #73: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #74: @5 = 0.6875 */
  w05 = 6.8750000000000000e-01;
  /* #75: @5 = (@5*@6) */
  w05 *= w06;
  /* #76: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #77: @5 = 0.71875 */
  w05 = 7.1875000000000000e-01;
  /* #78: @5 = (@5*@6) */
  w05 *= w06;
  /* #79: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #80: @5 = 0.75 */
  w05 = 7.5000000000000000e-01;
  /* #81: @5 = (@5*@6) */
  w05 *= w06;
  /* #82: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #83: @5 = 0.78125 */
  w05 = 7.8125000000000000e-01;
  /* #84: @5 = (@5*@6) */
  w05 *= w06;
  /* #85: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #86: @5 = 0.8125 */
  w05 = 8.1250000000000000e-01;
  /* #87: @5 = (@5*@6) */
  w05 *= w06;
  /* #88: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #89: @5 = 0.84375 */
  w05 = 8.4375000000000000e-01;
  /* #90: @5 = (@5*@6) */
  w05 *= w06;
  /* #91: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #92: @5 = 0.875 */
  w05 = 8.7500000000000000e-01;
  /* #93: @5 = (@5*@6) */
  w05 *= w06;
  /* #94: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #95: @5 = 0.90625 */
  w05 = 9.0625000000000000e-01;
  /* #96: @5 = (@5*@6) */
  w05 *= w06;
  /* #97: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #98: @5 = 0.9375 */
  w05 = 9.3750000000000000e-01;
  /* #99: @5 = (@5*@6) */
  w05 *= w06;
  /* #100: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #101: @5 = 0.96875 */
  w05 = 9.6875000000000000e-01;
  /* #102: @5 = (@5*@6) */
  w05 *= w06;
  /* #103: @4 = step_alongs(@9, @5, @8, @7, @2, @3) */
  arg1[0]=w09;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #107: output[2][0] = @11 */
  casadi_copy(w11, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void compass_jacobian_along_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_384_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int compass_jacobian_along_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real compass_jacobian_along_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* compass_jacobian_along_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_jacobian_along_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 627;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_jacobian_along_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 627*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[5],phase[2],turns[2x12],h,p[6])->(y_end[5]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81;
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
  a15=(a07*a14);
  a09=(a09-a15);
  a15=1.;
  a16=(a07+a15);
  a12=(a12*a16);
  a09=(a09+a12);
  a12=(2.*a07);
  a17=(a15-a13);
  a17=(a12*a17);
  a17=(a17+a15);
  a18=(a09/a17);
  a13=(a13-a15);
  a13=(a07*a13);
  a17=(a13/a17);
  a19=casadi_sq(a03);
  a19=(a19*a11);
  a19=(a19+a14);
  a19=(a07*a19);
  a14=arg[4]? arg[4][3] : 0;
  a11=arg[4]? arg[4][5] : 0;
  a20=arg[4]? arg[4][0] : 0;
  a20=(a11*a20);
  a21=arg[1]? arg[1][1] : 0;
  a22=(a20*a21);
  a22=(a08+a22);
  a22=(a14*a22);
  a23=arg[4]? arg[4][2] : 0;
  a24=arg[4]? arg[4][4] : 0;
  a25=arg[1]? arg[1][0] : 0;
  a26=(a25+a15);
  a26=(a11*a26);
  a26=(a24-a26);
  a26=(a26+a10);
  a26=(a23*a26);
  a22=(a22+a26);
  a19=(a19-a22);
  a09=(a17*a09);
  a19=(a19-a09);
  a13=(a13*a17);
  a13=(a07-a13);
  a19=(a19/a13);
  a17=(a17*a19);
  a18=(a18-a17);
  a17=(a06*a18);
  a13=1.7082860872947386e-01;
  a13=(a13*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a26=(a09*a19);
  a27=8.8762756430420545e-02;
  a27=(a27*a02);
  a28=1.9725056984537900e-02;
  a28=(a28*a02);
  a29=(a28*a18);
  a30=5.9175170953613701e-02;
  a30=(a30*a02);
  a31=5.2600151958767730e-02;
  a31=(a31*a02);
  a32=(a31*a19);
  a32=(a08+a32);
  a33=(a07*a32);
  a34=(a31*a08);
  a34=(a10+a34);
  a35=sin(a34);
  a33=(a33*a35);
  a36=(a31*a18);
  a36=(a03+a36);
  a37=(2.*a36);
  a37=(a32-a37);
  a33=(a33*a37);
  a31=(a31*a03);
  a31=(a00+a31);
  a37=sin(a31);
  a38=cos(a34);
  a39=(a37*a38);
  a31=cos(a31);
  a31=(a31*a35);
  a39=(a39-a31);
  a31=(a07*a39);
  a33=(a33-a31);
  a37=(a37*a16);
  a33=(a33+a37);
  a37=(a15-a38);
  a37=(a12*a37);
  a37=(a37+a15);
  a31=(a33/a37);
  a38=(a38-a15);
  a38=(a07*a38);
  a37=(a38/a37);
  a40=casadi_sq(a36);
  a40=(a40*a35);
  a40=(a40+a39);
  a40=(a07*a40);
  a39=arg[2]? arg[2][2] : 0;
  a35=(a21*a39);
  a41=arg[2]? arg[2][3] : 0;
  a42=(a25*a41);
  a35=(a35+a42);
  a35=(a20*a35);
  a35=(a32+a35);
  a35=(a14*a35);
  a39=(a25*a39);
  a41=(a21*a41);
  a39=(a39-a41);
  a39=(a39+a15);
  a39=(a11*a39);
  a39=(a24-a39);
  a39=(a39+a34);
  a39=(a23*a39);
  a35=(a35+a39);
  a40=(a40-a35);
  a33=(a37*a33);
  a40=(a40-a33);
  a38=(a38*a37);
  a38=(a07-a38);
  a40=(a40/a38);
  a37=(a37*a40);
  a31=(a31-a37);
  a31=(a30*a31);
  a29=(a29+a31);
  a29=(a03+a29);
  a31=casadi_sq(a29);
  a37=(a28*a08);
  a32=(a30*a32);
  a37=(a37+a32);
  a37=(a10+a37);
  a32=sin(a37);
  a31=(a31*a32);
  a38=(a28*a03);
  a36=(a30*a36);
  a38=(a38+a36);
  a38=(a00+a38);
  a36=sin(a38);
  a33=cos(a37);
  a35=(a36*a33);
  a38=cos(a38);
  a38=(a38*a32);
  a35=(a35-a38);
  a31=(a31+a35);
  a31=(a07*a31);
  a28=(a28*a19);
  a30=(a30*a40);
  a28=(a28+a30);
  a28=(a08+a28);
  a30=arg[2]? arg[2][4] : 0;
  a40=(a21*a30);
  a38=arg[2]? arg[2][5] : 0;
  a39=(a25*a38);
  a40=(a40+a39);
  a40=(a20*a40);
  a40=(a28+a40);
  a40=(a14*a40);
  a30=(a25*a30);
  a38=(a21*a38);
  a30=(a30-a38);
  a30=(a30+a15);
  a30=(a11*a30);
  a30=(a24-a30);
  a30=(a30+a37);
  a30=(a23*a30);
  a40=(a40+a30);
  a31=(a31-a40);
  a40=(a33-a15);
  a40=(a07*a40);
  a33=(a15-a33);
  a33=(a12*a33);
  a33=(a33+a15);
  a30=(a40/a33);
  a37=(a07*a28);
  a37=(a37*a32);
  a32=(2.*a29);
  a32=(a28-a32);
  a37=(a37*a32);
  a35=(a07*a35);
  a37=(a37-a35);
  a36=(a36*a16);
  a37=(a37+a36);
  a36=(a30*a37);
  a31=(a31-a36);
  a40=(a40*a30);
  a40=(a07-a40);
  a31=(a31/a40);
  a40=(a27*a31);
  a26=(a26+a40);
  a26=(a08+a26);
  a40=(a07*a26);
  a36=(a09*a08);
  a35=(a27*a28);
  a36=(a36+a35);
  a36=(a10+a36);
  a35=sin(a36);
  a40=(a40*a35);
  a32=(a09*a18);
  a37=(a37/a33);
  a30=(a30*a31);
  a37=(a37-a30);
  a30=(a27*a37);
  a32=(a32+a30);
  a32=(a03+a32);
  a30=(2.*a32);
  a30=(a26-a30);
  a40=(a40*a30);
  a09=(a09*a03);
  a27=(a27*a29);
  a09=(a09+a27);
  a09=(a00+a09);
  a27=sin(a09);
  a30=cos(a36);
  a33=(a27*a30);
  a09=cos(a09);
  a09=(a09*a35);
  a33=(a33-a09);
  a09=(a07*a33);
  a40=(a40-a09);
  a27=(a27*a16);
  a40=(a40+a27);
  a27=(a15-a30);
  a27=(a12*a27);
  a27=(a27+a15);
  a09=(a40/a27);
  a30=(a30-a15);
  a30=(a07*a30);
  a27=(a30/a27);
  a38=casadi_sq(a32);
  a38=(a38*a35);
  a38=(a38+a33);
  a38=(a07*a38);
  a33=arg[2]? arg[2][6] : 0;
  a35=(a21*a33);
  a39=arg[2]? arg[2][7] : 0;
  a34=(a25*a39);
  a35=(a35+a34);
  a35=(a20*a35);
  a35=(a26+a35);
  a35=(a14*a35);
  a33=(a25*a33);
  a39=(a21*a39);
  a33=(a33-a39);
  a33=(a33+a15);
  a33=(a11*a33);
  a33=(a24-a33);
  a33=(a33+a36);
  a33=(a23*a33);
  a35=(a35+a33);
  a38=(a38-a35);
  a40=(a27*a40);
  a38=(a38-a40);
  a30=(a30*a27);
  a30=(a07-a30);
  a38=(a38/a30);
  a27=(a27*a38);
  a09=(a09-a27);
  a27=(a13*a09);
  a17=(a17+a27);
  a27=1.2546768756682242e-01;
  a27=(a27*a02);
  a30=2.4136513415926669e-01;
  a30=(a30*a02);
  a40=(a30*a19);
  a35=-8.8454947932828609e-01;
  a35=(a35*a02);
  a31=(a35*a31);
  a40=(a40+a31);
  a31=9.2483400326179199e-01;
  a31=(a31*a02);
  a33=(a31*a38);
  a40=(a40+a33);
  a40=(a08+a40);
  a33=(a07*a40);
  a36=(a30*a08);
  a28=(a35*a28);
  a36=(a36+a28);
  a28=(a31*a26);
  a36=(a36+a28);
  a36=(a10+a36);
  a28=sin(a36);
  a33=(a33*a28);
  a39=(a30*a18);
  a37=(a35*a37);
  a39=(a39+a37);
  a37=(a31*a09);
  a39=(a39+a37);
  a39=(a03+a39);
  a37=(2.*a39);
  a37=(a40-a37);
  a33=(a33*a37);
  a30=(a30*a03);
  a35=(a35*a29);
  a30=(a30+a35);
  a31=(a31*a32);
  a30=(a30+a31);
  a30=(a00+a30);
  a31=sin(a30);
  a35=cos(a36);
  a29=(a31*a35);
  a30=cos(a30);
  a30=(a30*a28);
  a29=(a29-a30);
  a30=(a07*a29);
  a33=(a33-a30);
  a31=(a31*a16);
  a33=(a33+a31);
  a31=(a15-a35);
  a31=(a12*a31);
  a31=(a31+a15);
  a30=(a33/a31);
  a35=(a35-a15);
  a35=(a07*a35);
  a31=(a35/a31);
  a37=casadi_sq(a39);
  a37=(a37*a28);
  a37=(a37+a29);
  a37=(a07*a37);
  a29=arg[2]? arg[2][8] : 0;
  a28=(a21*a29);
  a34=arg[2]? arg[2][9] : 0;
  a41=(a25*a34);
  a28=(a28+a41);
  a28=(a20*a28);
  a28=(a40+a28);
  a28=(a14*a28);
  a29=(a25*a29);
  a34=(a21*a34);
  a29=(a29-a34);
  a29=(a29+a15);
  a29=(a11*a29);
  a29=(a24-a29);
  a29=(a29+a36);
  a29=(a23*a29);
  a28=(a28+a29);
  a37=(a37-a28);
  a33=(a31*a33);
  a37=(a37-a33);
  a35=(a35*a31);
  a35=(a07-a35);
  a37=(a37/a35);
  a31=(a31*a37);
  a30=(a30-a31);
  a31=(a27*a30);
  a17=(a17+a31);
  a17=(a03+a17);
  a31=(a05*a17);
  a04=(a04+a31);
  a31=1.8915178993145003e+00;
  a31=(a31*a02);
  a35=3.7109375000000000e-02;
  a35=(a35*a02);
  a33=(a35*a18);
  a28=1.7025221101954405e-01;
  a28=(a28*a02);
  a29=(a28*a09);
  a33=(a33+a29);
  a29=6.0216538980455959e-02;
  a29=(a29*a02);
  a36=(a29*a30);
  a33=(a33+a36);
  a36=-1.7578125000000000e-02;
  a36=(a36*a02);
  a34=(a06*a19);
  a41=(a13*a38);
  a34=(a34+a41);
  a41=(a27*a37);
  a34=(a34+a41);
  a34=(a08+a34);
  a41=(a07*a34);
  a42=(a06*a08);
  a43=(a13*a26);
  a42=(a42+a43);
  a43=(a27*a40);
  a42=(a42+a43);
  a42=(a10+a42);
  a43=sin(a42);
  a41=(a41*a43);
  a44=(2.*a17);
  a44=(a34-a44);
  a41=(a41*a44);
  a06=(a06*a03);
  a13=(a13*a32);
  a06=(a06+a13);
  a27=(a27*a39);
  a06=(a06+a27);
  a06=(a00+a06);
  a27=sin(a06);
  a13=cos(a42);
  a44=(a27*a13);
  a06=cos(a06);
  a06=(a06*a43);
  a44=(a44-a06);
  a06=(a07*a44);
  a41=(a41-a06);
  a27=(a27*a16);
  a41=(a41+a27);
  a27=(a15-a13);
  a27=(a12*a27);
  a27=(a27+a15);
  a06=(a41/a27);
  a13=(a13-a15);
  a13=(a07*a13);
  a27=(a13/a27);
  a45=casadi_sq(a17);
  a45=(a45*a43);
  a45=(a45+a44);
  a45=(a07*a45);
  a44=arg[2]? arg[2][10] : 0;
  a43=(a21*a44);
  a46=arg[2]? arg[2][11] : 0;
  a47=(a25*a46);
  a43=(a43+a47);
  a43=(a20*a43);
  a43=(a34+a43);
  a43=(a14*a43);
  a44=(a25*a44);
  a46=(a21*a46);
  a44=(a44-a46);
  a44=(a44+a15);
  a44=(a11*a44);
  a44=(a24-a44);
  a44=(a44+a42);
  a44=(a23*a44);
  a43=(a43+a44);
  a45=(a45-a43);
  a41=(a27*a41);
  a45=(a45-a41);
  a13=(a13*a27);
  a13=(a07-a13);
  a45=(a45/a13);
  a27=(a27*a45);
  a06=(a06-a27);
  a27=(a36*a06);
  a33=(a33+a27);
  a33=(a03+a33);
  a27=(a31*a33);
  a04=(a04+a27);
  a27=-5.8012039600105849e+00;
  a27=(a27*a02);
  a13=3.7092000118504789e-02;
  a13=(a13*a02);
  a41=(a13*a18);
  a44=1.7038392571223998e-01;
  a44=(a44*a02);
  a42=(a44*a09);
  a41=(a41+a42);
  a42=1.0726203044637328e-01;
  a42=(a42*a02);
  a46=(a42*a30);
  a41=(a41+a46);
  a46=-1.5319437748624402e-02;
  a46=(a46*a02);
  a47=(a46*a06);
  a41=(a41+a47);
  a47=8.2737891638140233e-03;
  a47=(a47*a02);
  a48=(a35*a19);
  a49=(a28*a38);
  a48=(a48+a49);
  a49=(a29*a37);
  a48=(a48+a49);
  a49=(a36*a45);
  a48=(a48+a49);
  a48=(a08+a48);
  a49=(a07*a48);
  a50=(a35*a08);
  a51=(a28*a26);
  a50=(a50+a51);
  a51=(a29*a40);
  a50=(a50+a51);
  a51=(a36*a34);
  a50=(a50+a51);
  a50=(a10+a50);
  a51=sin(a50);
  a49=(a49*a51);
  a52=(2.*a33);
  a52=(a48-a52);
  a49=(a49*a52);
  a35=(a35*a03);
  a28=(a28*a32);
  a35=(a35+a28);
  a29=(a29*a39);
  a35=(a35+a29);
  a36=(a36*a17);
  a35=(a35+a36);
  a35=(a00+a35);
  a36=sin(a35);
  a29=cos(a50);
  a28=(a36*a29);
  a35=cos(a35);
  a35=(a35*a51);
  a28=(a28-a35);
  a35=(a07*a28);
  a49=(a49-a35);
  a36=(a36*a16);
  a49=(a49+a36);
  a36=(a15-a29);
  a36=(a12*a36);
  a36=(a36+a15);
  a35=(a49/a36);
  a29=(a29-a15);
  a29=(a07*a29);
  a36=(a29/a36);
  a52=casadi_sq(a33);
  a52=(a52*a51);
  a52=(a52+a28);
  a52=(a07*a52);
  a28=arg[2]? arg[2][12] : 0;
  a51=(a21*a28);
  a53=arg[2]? arg[2][13] : 0;
  a54=(a25*a53);
  a51=(a51+a54);
  a51=(a20*a51);
  a51=(a48+a51);
  a51=(a14*a51);
  a28=(a25*a28);
  a53=(a21*a53);
  a28=(a28-a53);
  a28=(a28+a15);
  a28=(a11*a28);
  a28=(a24-a28);
  a28=(a28+a50);
  a28=(a23*a28);
  a51=(a51+a28);
  a52=(a52-a51);
  a49=(a36*a49);
  a52=(a52-a49);
  a29=(a29*a36);
  a29=(a07-a29);
  a52=(a52/a29);
  a36=(a36*a52);
  a35=(a35-a36);
  a36=(a47*a35);
  a41=(a41+a36);
  a41=(a03+a41);
  a36=(a27*a41);
  a04=(a04+a36);
  a36=3.1116436695781990e-01;
  a36=(a36*a02);
  a29=6.2411095871607569e-01;
  a29=(a29*a02);
  a49=(a29*a18);
  a28=-3.3608926294469414e+00;
  a28=(a28*a02);
  a50=(a28*a09);
  a49=(a49+a50);
  a50=-8.6821934684172597e-01;
  a50=(a50*a02);
  a53=(a50*a30);
  a49=(a49+a53);
  a53=2.7592099699446710e+01;
  a53=(a53*a02);
  a54=(a53*a06);
  a49=(a49+a54);
  a54=2.0154067550477894e+01;
  a54=(a54*a02);
  a55=(a54*a35);
  a49=(a49+a55);
  a55=-4.3489884181069961e+01;
  a55=(a55*a02);
  a56=(a13*a19);
  a57=(a44*a38);
  a56=(a56+a57);
  a57=(a42*a37);
  a56=(a56+a57);
  a57=(a46*a45);
  a56=(a56+a57);
  a57=(a47*a52);
  a56=(a56+a57);
  a56=(a08+a56);
  a57=(a07*a56);
  a58=(a13*a08);
  a59=(a44*a26);
  a58=(a58+a59);
  a59=(a42*a40);
  a58=(a58+a59);
  a59=(a46*a34);
  a58=(a58+a59);
  a59=(a47*a48);
  a58=(a58+a59);
  a58=(a10+a58);
  a59=sin(a58);
  a57=(a57*a59);
  a60=(2.*a41);
  a60=(a56-a60);
  a57=(a57*a60);
  a13=(a13*a03);
  a44=(a44*a32);
  a13=(a13+a44);
  a42=(a42*a39);
  a13=(a13+a42);
  a46=(a46*a17);
  a13=(a13+a46);
  a47=(a47*a33);
  a13=(a13+a47);
  a13=(a00+a13);
  a47=sin(a13);
  a46=cos(a58);
  a42=(a47*a46);
  a13=cos(a13);
  a13=(a13*a59);
  a42=(a42-a13);
  a13=(a07*a42);
  a57=(a57-a13);
  a47=(a47*a16);
  a57=(a57+a47);
  a47=(a15-a46);
  a47=(a12*a47);
  a47=(a47+a15);
  a13=(a57/a47);
  a46=(a46-a15);
  a46=(a07*a46);
  a47=(a46/a47);
  a44=casadi_sq(a41);
  a44=(a44*a59);
  a44=(a44+a42);
  a44=(a07*a44);
  a42=arg[2]? arg[2][14] : 0;
  a59=(a21*a42);
  a60=arg[2]? arg[2][15] : 0;
  a61=(a25*a60);
  a59=(a59+a61);
  a59=(a20*a59);
  a59=(a56+a59);
  a59=(a14*a59);
  a42=(a25*a42);
  a60=(a21*a60);
  a42=(a42-a60);
  a42=(a42+a15);
  a42=(a11*a42);
  a42=(a24-a42);
  a42=(a42+a58);
  a42=(a23*a42);
  a59=(a59+a42);
  a44=(a44-a59);
  a57=(a47*a57);
  a44=(a44-a57);
  a46=(a46*a47);
  a46=(a07-a46);
  a44=(a44/a46);
  a47=(a47*a44);
  a13=(a13-a47);
  a47=(a55*a13);
  a49=(a49+a47);
  a49=(a03+a49);
  a47=(a36*a49);
  a04=(a04+a47);
  a47=-1.5216094966251609e-01;
  a47=(a47*a02);
  a46=4.7766253643826434e-01;
  a46=(a46*a02);
  a57=(a46*a18);
  a42=-2.4881146199716677e+00;
  a42=(a42*a02);
  a58=(a42*a09);
  a57=(a57+a58);
  a58=-5.9029082683684297e-01;
  a58=(a58*a02);
  a60=(a58*a30);
  a57=(a57+a60);
  a60=2.1230051448181193e+01;
  a60=(a60*a02);
  a61=(a60*a06);
  a57=(a57+a61);
  a61=1.5279233632882423e+01;
  a61=(a61*a02);
  a62=(a61*a35);
  a57=(a57+a62);
  a62=-3.3288210968984863e+01;
  a62=(a62*a02);
  a63=(a62*a13);
  a57=(a57+a63);
  a63=-2.0331201708508627e-02;
  a63=(a63*a02);
  a64=(a29*a19);
  a65=(a28*a38);
  a64=(a64+a65);
  a65=(a50*a37);
  a64=(a64+a65);
  a65=(a53*a45);
  a64=(a64+a65);
  a65=(a54*a52);
  a64=(a64+a65);
  a65=(a55*a44);
  a64=(a64+a65);
  a64=(a08+a64);
  a65=(a07*a64);
  a66=(a29*a08);
  a67=(a28*a26);
  a66=(a66+a67);
  a67=(a50*a40);
  a66=(a66+a67);
  a67=(a53*a34);
  a66=(a66+a67);
  a67=(a54*a48);
  a66=(a66+a67);
  a67=(a55*a56);
  a66=(a66+a67);
  a66=(a10+a66);
  a67=sin(a66);
  a65=(a65*a67);
  a68=(2.*a49);
  a68=(a64-a68);
  a65=(a65*a68);
  a29=(a29*a03);
  a28=(a28*a32);
  a29=(a29+a28);
  a50=(a50*a39);
  a29=(a29+a50);
  a53=(a53*a17);
  a29=(a29+a53);
  a54=(a54*a33);
  a29=(a29+a54);
  a55=(a55*a41);
  a29=(a29+a55);
  a29=(a00+a29);
  a55=sin(a29);
  a54=cos(a66);
  a53=(a55*a54);
  a29=cos(a29);
  a29=(a29*a67);
  a53=(a53-a29);
  a29=(a07*a53);
  a65=(a65-a29);
  a55=(a55*a16);
  a65=(a65+a55);
  a55=(a15-a54);
  a55=(a12*a55);
  a55=(a55+a15);
  a29=(a65/a55);
  a54=(a54-a15);
  a54=(a07*a54);
  a55=(a54/a55);
  a50=casadi_sq(a49);
  a50=(a50*a67);
  a50=(a50+a53);
  a50=(a07*a50);
  a53=arg[2]? arg[2][16] : 0;
  a67=(a21*a53);
  a28=arg[2]? arg[2][17] : 0;
  a68=(a25*a28);
  a67=(a67+a68);
  a67=(a20*a67);
  a67=(a64+a67);
  a67=(a14*a67);
  a53=(a25*a53);
  a28=(a21*a28);
  a53=(a53-a28);
  a53=(a53+a15);
  a53=(a11*a53);
  a53=(a24-a53);
  a53=(a53+a66);
  a53=(a23*a53);
  a67=(a67+a53);
  a50=(a50-a67);
  a65=(a55*a65);
  a50=(a50-a65);
  a54=(a54*a55);
  a54=(a07-a54);
  a50=(a50/a54);
  a55=(a55*a50);
  a29=(a29-a55);
  a55=(a63*a29);
  a57=(a57+a55);
  a57=(a03+a57);
  a55=(a47*a57);
  a04=(a04+a55);
  a55=2.0136540080403034e-01;
  a55=(a55*a02);
  a54=-9.3714243008598730e-01;
  a54=(a54*a02);
  a65=(a54*a18);
  a53=5.1863724288440638e+00;
  a53=(a53*a02);
  a66=(a53*a09);
  a65=(a65+a66);
  a66=1.0914373489967295e+00;
  a66=(a66*a02);
  a28=(a66*a30);
  a65=(a65+a28);
  a28=-8.1497870107469268e+00;
  a28=(a28*a02);
  a68=(a28*a06);
  a65=(a65+a68);
  a68=-1.8520065659996959e+01;
  a68=(a68*a02);
  a69=(a68*a35);
  a65=(a65+a69);
  a69=2.2739487099350505e+01;
  a69=(a69*a02);
  a70=(a69*a13);
  a65=(a65+a70);
  a70=2.4936055526796523e+00;
  a70=(a70*a02);
  a71=(a70*a29);
  a65=(a65+a71);
  a71=-3.0467644718982196e+00;
  a71=(a71*a02);
  a72=(a46*a19);
  a73=(a42*a38);
  a72=(a72+a73);
  a73=(a58*a37);
  a72=(a72+a73);
  a73=(a60*a45);
  a72=(a72+a73);
  a73=(a61*a52);
  a72=(a72+a73);
  a73=(a62*a44);
  a72=(a72+a73);
  a73=(a63*a50);
  a72=(a72+a73);
  a72=(a08+a72);
  a73=(a07*a72);
  a74=(a46*a08);
  a75=(a42*a26);
  a74=(a74+a75);
  a75=(a58*a40);
  a74=(a74+a75);
  a75=(a60*a34);
  a74=(a74+a75);
  a75=(a61*a48);
  a74=(a74+a75);
  a75=(a62*a56);
  a74=(a74+a75);
  a75=(a63*a64);
  a74=(a74+a75);
  a74=(a10+a74);
  a75=sin(a74);
  a73=(a73*a75);
  a76=(2.*a57);
  a76=(a72-a76);
  a73=(a73*a76);
  a46=(a46*a03);
  a42=(a42*a32);
  a46=(a46+a42);
  a58=(a58*a39);
  a46=(a46+a58);
  a60=(a60*a17);
  a46=(a46+a60);
  a61=(a61*a33);
  a46=(a46+a61);
  a62=(a62*a41);
  a46=(a46+a62);
  a63=(a63*a49);
  a46=(a46+a63);
  a46=(a00+a46);
  a63=sin(a46);
  a62=cos(a74);
  a61=(a63*a62);
  a46=cos(a46);
  a46=(a46*a75);
  a61=(a61-a46);
  a46=(a07*a61);
  a73=(a73-a46);
  a63=(a63*a16);
  a73=(a73+a63);
  a63=(a15-a62);
  a63=(a12*a63);
  a63=(a63+a15);
  a46=(a73/a63);
  a62=(a62-a15);
  a62=(a07*a62);
  a63=(a62/a63);
  a60=casadi_sq(a57);
  a60=(a60*a75);
  a60=(a60+a61);
  a60=(a07*a60);
  a61=arg[2]? arg[2][18] : 0;
  a75=(a21*a61);
  a58=arg[2]? arg[2][19] : 0;
  a42=(a25*a58);
  a75=(a75+a42);
  a75=(a20*a75);
  a75=(a72+a75);
  a75=(a14*a75);
  a61=(a25*a61);
  a58=(a21*a58);
  a61=(a61-a58);
  a61=(a61+a15);
  a61=(a11*a61);
  a61=(a24-a61);
  a61=(a61+a74);
  a61=(a23*a61);
  a75=(a75+a61);
  a60=(a60-a75);
  a73=(a63*a73);
  a60=(a60-a73);
  a62=(a62*a63);
  a62=(a07-a62);
  a60=(a60/a62);
  a63=(a63*a60);
  a46=(a46-a63);
  a63=(a71*a46);
  a65=(a65+a63);
  a65=(a03+a65);
  a63=(a55*a65);
  a04=(a04+a63);
  a63=4.4710615727772587e-02;
  a63=(a63*a02);
  a62=2.2733101475165380e+00;
  a62=(a62*a02);
  a73=(a62*a18);
  a61=-1.0534495466737249e+01;
  a61=(a61*a02);
  a09=(a61*a09);
  a73=(a73+a09);
  a09=-2.0008720582248625e+00;
  a09=(a09*a02);
  a30=(a09*a30);
  a73=(a73+a30);
  a30=-1.7958931863118799e+01;
  a30=(a30*a02);
  a74=(a30*a06);
  a73=(a73+a74);
  a74=2.7948884529419960e+01;
  a74=(a74*a02);
  a58=(a74*a35);
  a73=(a73+a58);
  a58=-2.8589982771350235e+00;
  a58=(a58*a02);
  a42=(a58*a13);
  a73=(a73+a42);
  a42=-8.8728569335306293e+00;
  a42=(a42*a02);
  a76=(a42*a29);
  a73=(a73+a76);
  a76=1.2360567175794303e+01;
  a76=(a76*a02);
  a77=(a76*a46);
  a73=(a73+a77);
  a77=6.4339274601576357e-01;
  a77=(a77*a02);
  a02=(a54*a19);
  a78=(a53*a38);
  a02=(a02+a78);
  a78=(a66*a37);
  a02=(a02+a78);
  a78=(a28*a45);
  a02=(a02+a78);
  a78=(a68*a52);
  a02=(a02+a78);
  a78=(a69*a44);
  a02=(a02+a78);
  a78=(a70*a50);
  a02=(a02+a78);
  a78=(a71*a60);
  a02=(a02+a78);
  a02=(a08+a02);
  a78=(a07*a02);
  a79=(a54*a08);
  a80=(a53*a26);
  a79=(a79+a80);
  a80=(a66*a40);
  a79=(a79+a80);
  a80=(a28*a34);
  a79=(a79+a80);
  a80=(a68*a48);
  a79=(a79+a80);
  a80=(a69*a56);
  a79=(a79+a80);
  a80=(a70*a64);
  a79=(a79+a80);
  a80=(a71*a72);
  a79=(a79+a80);
  a79=(a10+a79);
  a80=sin(a79);
  a78=(a78*a80);
  a81=(2.*a65);
  a81=(a02-a81);
  a78=(a78*a81);
  a54=(a54*a03);
  a53=(a53*a32);
  a54=(a54+a53);
  a66=(a66*a39);
  a54=(a54+a66);
  a28=(a28*a17);
  a54=(a54+a28);
  a68=(a68*a33);
  a54=(a54+a68);
  a69=(a69*a41);
  a54=(a54+a69);
  a70=(a70*a49);
  a54=(a54+a70);
  a71=(a71*a57);
  a54=(a54+a71);
  a54=(a00+a54);
  a71=sin(a54);
  a70=cos(a79);
  a69=(a71*a70);
  a54=cos(a54);
  a54=(a54*a80);
  a69=(a69-a54);
  a54=(a07*a69);
  a78=(a78-a54);
  a71=(a71*a16);
  a78=(a78+a71);
  a71=(a15-a70);
  a71=(a12*a71);
  a71=(a71+a15);
  a54=(a78/a71);
  a70=(a70-a15);
  a70=(a07*a70);
  a71=(a70/a71);
  a68=casadi_sq(a65);
  a68=(a68*a80);
  a68=(a68+a69);
  a68=(a07*a68);
  a69=arg[2]? arg[2][20] : 0;
  a80=(a21*a69);
  a28=arg[2]? arg[2][21] : 0;
  a66=(a25*a28);
  a80=(a80+a66);
  a80=(a20*a80);
  a80=(a02+a80);
  a80=(a14*a80);
  a69=(a25*a69);
  a28=(a21*a28);
  a69=(a69-a28);
  a69=(a69+a15);
  a69=(a11*a69);
  a69=(a24-a69);
  a69=(a69+a79);
  a69=(a23*a69);
  a80=(a80+a69);
  a68=(a68-a80);
  a78=(a71*a78);
  a68=(a68-a78);
  a70=(a70*a71);
  a70=(a07-a70);
  a68=(a68/a70);
  a71=(a71*a68);
  a54=(a54-a71);
  a71=(a77*a54);
  a73=(a73+a71);
  a73=(a03+a73);
  a71=(a63*a73);
  a04=(a04+a71);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a71=(a05*a34);
  a04=(a04+a71);
  a71=(a31*a48);
  a04=(a04+a71);
  a71=(a27*a56);
  a04=(a04+a71);
  a71=(a36*a64);
  a04=(a04+a71);
  a71=(a47*a72);
  a04=(a04+a71);
  a71=(a55*a02);
  a04=(a04+a71);
  a71=(a62*a19);
  a38=(a61*a38);
  a71=(a71+a38);
  a37=(a09*a37);
  a71=(a71+a37);
  a37=(a30*a45);
  a71=(a71+a37);
  a37=(a74*a52);
  a71=(a71+a37);
  a37=(a58*a44);
  a71=(a71+a37);
  a37=(a42*a50);
  a71=(a71+a37);
  a37=(a76*a60);
  a71=(a71+a37);
  a37=(a77*a68);
  a71=(a71+a37);
  a71=(a08+a71);
  a37=(a63*a71);
  a04=(a04+a37);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a18=(a01*a18);
  a06=(a05*a06);
  a18=(a18+a06);
  a35=(a31*a35);
  a18=(a18+a35);
  a13=(a27*a13);
  a18=(a18+a13);
  a29=(a36*a29);
  a18=(a18+a29);
  a46=(a47*a46);
  a18=(a18+a46);
  a54=(a55*a54);
  a18=(a18+a54);
  a54=(a07*a71);
  a46=(a62*a08);
  a26=(a61*a26);
  a46=(a46+a26);
  a40=(a09*a40);
  a46=(a46+a40);
  a40=(a30*a34);
  a46=(a46+a40);
  a40=(a74*a48);
  a46=(a46+a40);
  a40=(a58*a56);
  a46=(a46+a40);
  a40=(a42*a64);
  a46=(a46+a40);
  a40=(a76*a72);
  a46=(a46+a40);
  a40=(a77*a02);
  a46=(a46+a40);
  a10=(a10+a46);
  a46=sin(a10);
  a54=(a54*a46);
  a40=(2.*a73);
  a40=(a71-a40);
  a54=(a54*a40);
  a62=(a62*a03);
  a61=(a61*a32);
  a62=(a62+a61);
  a09=(a09*a39);
  a62=(a62+a09);
  a30=(a30*a17);
  a62=(a62+a30);
  a74=(a74*a33);
  a62=(a62+a74);
  a58=(a58*a41);
  a62=(a62+a58);
  a42=(a42*a49);
  a62=(a62+a42);
  a76=(a76*a57);
  a62=(a62+a76);
  a77=(a77*a65);
  a62=(a62+a77);
  a00=(a00+a62);
  a62=sin(a00);
  a77=cos(a10);
  a65=(a62*a77);
  a00=cos(a00);
  a00=(a00*a46);
  a65=(a65-a00);
  a00=(a07*a65);
  a54=(a54-a00);
  a62=(a62*a16);
  a54=(a54+a62);
  a62=(a15-a77);
  a12=(a12*a62);
  a12=(a12+a15);
  a62=(a54/a12);
  a77=(a77-a15);
  a77=(a07*a77);
  a12=(a77/a12);
  a73=casadi_sq(a73);
  a73=(a73*a46);
  a73=(a73+a65);
  a73=(a07*a73);
  a65=arg[2]? arg[2][22] : 0;
  a46=(a21*a65);
  a16=arg[2]? arg[2][23] : 0;
  a00=(a25*a16);
  a46=(a46+a00);
  a20=(a20*a46);
  a20=(a71+a20);
  a14=(a14*a20);
  a25=(a25*a65);
  a21=(a21*a16);
  a25=(a25-a21);
  a25=(a25+a15);
  a11=(a11*a25);
  a24=(a24-a11);
  a24=(a24+a10);
  a23=(a23*a24);
  a14=(a14+a23);
  a73=(a73-a14);
  a54=(a12*a54);
  a73=(a73-a54);
  a77=(a77*a12);
  a07=(a07-a77);
  a73=(a73/a07);
  a12=(a12*a73);
  a62=(a62-a12);
  a62=(a63*a62);
  a18=(a18+a62);
  a03=(a03+a18);
  if (res[0]!=0) res[0][2]=a03;
  a19=(a01*a19);
  a45=(a05*a45);
  a19=(a19+a45);
  a52=(a31*a52);
  a19=(a19+a52);
  a44=(a27*a44);
  a19=(a19+a44);
  a50=(a36*a50);
  a19=(a19+a50);
  a60=(a47*a60);
  a19=(a19+a60);
  a68=(a55*a68);
  a19=(a19+a68);
  a73=(a63*a73);
  a19=(a19+a73);
  a19=(a08+a19);
  if (res[0]!=0) res[0][3]=a19;
  a19=arg[0]? arg[0][4] : 0;
  a22=(a22*a08);
  a01=(a01*a22);
  a43=(a43*a34);
  a05=(a05*a43);
  a01=(a01+a05);
  a51=(a51*a48);
  a31=(a31*a51);
  a01=(a01+a31);
  a59=(a59*a56);
  a27=(a27*a59);
  a01=(a01+a27);
  a67=(a67*a64);
  a36=(a36*a67);
  a01=(a01+a36);
  a75=(a75*a72);
  a47=(a47*a75);
  a01=(a01+a47);
  a80=(a80*a02);
  a55=(a55*a80);
  a01=(a01+a55);
  a14=(a14*a71);
  a63=(a63*a14);
  a01=(a01+a63);
  a19=(a19-a01);
  if (res[0]!=0) res[0][4]=a19;
  return 0;
}

/* observe:(t,y[4],p[6])->(g[10],dg[10]) */
static int casadi_f103(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49;
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
  a06=(a06/a09);
  a10=cos(a01);
  a03=cos(a03);
  a11=(a10-a03);
  a12=(a00*a11);
  a12=(a12+a10);
  a12=(a12/a09);
  a13=(a00*a03);
  a14=arg[1]? arg[1][3] : 0;
  a15=(a00*a14);
  a16=sin(a02);
  a17=(a15*a16);
  a18=arg[1]? arg[1][2] : 0;
  a19=(2.*a18);
  a20=(a14-a19);
  a21=(a17*a20);
  a22=(a00*a04);
  a21=(a21-a22);
  a23=(a00+a08);
  a24=(a05*a23);
  a21=(a21+a24);
  a25=cos(a02);
  a26=(a08-a25);
  a26=(a07*a26);
  a26=(a26+a08);
  a27=(a21/a26);
  a28=(a25-a08);
  a28=(a00*a28);
  a29=(a28/a26);
  a30=casadi_sq(a18);
  a31=(a30*a16);
  a31=(a31+a04);
  a31=(a00*a31);
  a32=arg[2]? arg[2][3] : 0;
  a33=arg[2]? arg[2][5] : 0;
  a34=arg[2]? arg[2][0] : 0;
  a35=(a33*a34);
  a36=arg[0]? arg[0][0] : 0;
  a36=(a34*a36);
  a37=sin(a36);
  a38=(a35*a37);
  a38=(a14+a38);
  a38=(a32*a38);
  a39=arg[2]? arg[2][2] : 0;
  a40=arg[2]? arg[2][4] : 0;
  a36=cos(a36);
  a41=(a36+a08);
  a41=(a33*a41);
  a40=(a40-a41);
  a40=(a40+a02);
  a40=(a39*a40);
  a38=(a38+a40);
  a31=(a31-a38);
  a40=(a29*a21);
  a31=(a31-a40);
  a40=(a28*a29);
  a40=(a00-a40);
  a31=(a31/a40);
  a41=(a29*a31);
  a41=(a27-a41);
  a42=(a41-a31);
  a43=(a13*a42);
  a44=(a10*a23);
  a45=(a41*a44);
  a43=(a43-a45);
  a45=(a19*a14);
  a45=(a30-a45);
  a46=casadi_sq(a14);
  a45=(a45+a46);
  a46=(a22*a45);
  a43=(a43-a46);
  a46=(a30*a24);
  a43=(a43+a46);
  a46=(a12*a43);
  a47=(a13*a45);
  a48=(a41*a24);
  a47=(a47-a48);
  a48=(a22*a42);
  a47=(a47+a48);
  a48=(a30*a44);
  a49=(a47-a48);
  a49=(a49+a09);
  a46=(a46/a49);
  a06=(a06-a46);
  a06=(-a06);
  if (res[0]!=0) res[0][0]=a06;
  a06=0.;
  if (res[0]!=0) res[0][1]=a06;
  a47=(a47+a07);
  a47=(a47-a48);
  a47=(a47+a08);
  if (res[0]!=0) res[0][2]=a47;
  a08=(a43/a47);
  if (res[0]!=0) res[0][3]=a08;
  if (res[0]!=0) res[0][4]=a11;
  if (res[0]!=0) res[0][5]=a41;
  a01=(2.*a01);
  a02=(a02-a01);
  if (res[0]!=0) res[0][6]=a02;
  if (res[0]!=0) res[0][7]=a06;
  a02=(a38*a14);
  a02=(-a02);
  if (res[0]!=0) res[0][8]=a02;
  a02=(-a38);
  if (res[0]!=0) res[0][9]=a02;
  a02=(a18-a14);
  a03=(a03*a02);
  a10=(a10*a18);
  a01=(a03-a10);
  a01=(a00*a01);
  a01=(a01-a10);
  a01=(a01/a09);
  a04=(a04*a02);
  a05=(a05*a18);
  a18=(a04-a05);
  a02=(a00*a18);
  a02=(a02-a05);
  a02=(a02/a09);
  a43=(a43*a02);
  a02=(a00*a31);
  a02=(a16*a02);
  a25=(a25*a14);
  a15=(a15*a25);
  a02=(a02+a15);
  a02=(a20*a02);
  a15=(2.*a41);
  a09=(a31-a15);
  a17=(a17*a09);
  a02=(a02+a17);
  a17=(a00*a03);
  a02=(a02-a17);
  a10=(a23*a10);
  a02=(a02+a10);
  a09=(a02/a26);
  a27=(a27/a26);
  a11=(a16*a14);
  a07=(a07*a11);
  a27=(a27*a07);
  a09=(a09-a27);
  a27=(a19*a41);
  a16=(a16*a27);
  a25=(a30*a25);
  a16=(a16+a25);
  a16=(a16+a03);
  a16=(a00*a16);
  a36=(a36*a34);
  a35=(a35*a36);
  a35=(a31+a35);
  a32=(a32*a35);
  a37=(a37*a34);
  a33=(a33*a37);
  a33=(a33+a14);
  a39=(a39*a33);
  a32=(a32+a39);
  a16=(a16-a32);
  a02=(a29*a02);
  a11=(a00*a11);
  a39=(a11/a26);
  a26=(a29/a26);
  a26=(a26*a07);
  a39=(a39+a26);
  a21=(a21*a39);
  a02=(a02-a21);
  a16=(a16-a02);
  a16=(a16/a40);
  a40=(a31/a40);
  a11=(a29*a11);
  a28=(a28*a39);
  a11=(a11+a28);
  a40=(a40*a11);
  a16=(a16-a40);
  a29=(a29*a16);
  a39=(a31*a39);
  a29=(a29-a39);
  a09=(a09-a29);
  a16=(a09-a16);
  a29=(a13*a16);
  a00=(a00*a04);
  a04=(a42*a00);
  a29=(a29-a04);
  a04=(a44*a09);
  a23=(a23*a05);
  a05=(a41*a23);
  a04=(a04-a05);
  a29=(a29-a04);
  a04=(a45*a17);
  a15=(a14*a15);
  a19=(a19*a31);
  a15=(a15+a19);
  a15=(a27-a15);
  a19=(2.*a14);
  a19=(a19*a31);
  a15=(a15+a19);
  a19=(a22*a15);
  a04=(a04+a19);
  a29=(a29-a04);
  a04=(a24*a27);
  a19=(a30*a10);
  a04=(a04+a19);
  a29=(a29+a04);
  a12=(a12*a29);
  a43=(a43+a12);
  a43=(a43/a49);
  a46=(a46/a49);
  a13=(a13*a15);
  a45=(a45*a00);
  a13=(a13-a45);
  a24=(a24*a09);
  a41=(a41*a10);
  a24=(a24+a41);
  a13=(a13-a24);
  a42=(a42*a17);
  a22=(a22*a16);
  a42=(a42+a22);
  a13=(a13+a42);
  a44=(a44*a27);
  a30=(a30*a23);
  a44=(a44-a30);
  a13=(a13-a44);
  a46=(a46*a13);
  a43=(a43-a46);
  a01=(a01-a43);
  a01=(-a01);
  if (res[1]!=0) res[1][0]=a01;
  if (res[1]!=0) res[1][1]=a06;
  if (res[1]!=0) res[1][2]=a13;
  a29=(a29/a47);
  a08=(a08/a47);
  a08=(a08*a13);
  a29=(a29-a08);
  if (res[1]!=0) res[1][3]=a29;
  if (res[1]!=0) res[1][4]=a18;
  if (res[1]!=0) res[1][5]=a09;
  if (res[1]!=0) res[1][6]=a20;
  if (res[1]!=0) res[1][7]=a06;
  a14=(a14*a32);
  a38=(a38*a31);
  a14=(a14+a38);
  a14=(-a14);
  if (res[1]!=0) res[1][8]=a14;
  a32=(-a32);
  if (res[1]!=0) res[1][9]=a32;
  return 0;
}

/* working_steps:(t,turns[2x12],w[5],h,p[6])->(w_end[5],nodes[5x12],g[10x12],dg[10x12]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, *w00=w+82, w01, *w02=w+87, *w03=w+93, w05, *w06=w+95, w07, *w08=w+100, *w09=w+105, *w10=w+110;
  casadi_real *w11=w+115, *w12=w+120, *w13=w+125, *w14=w+130, *w15=w+135, *w16=w+140, *w17=w+145, *w18=w+150, *w19=w+155, *w20=w+159, *w21=w+169, *w22=w+179;
  casadi_real *w23=w+189, *w24=w+199, *w25=w+209, *w26=w+219, *w27=w+229, *w28=w+239, *w29=w+249, *w30=w+259, *w31=w+269, *w32=w+279;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1393, *w21=w+1403;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f100(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1407;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1407*sizeof(casadi_real);
  return 0;
}

/* compass_trace_72:(u[4],p[6])->(w[5x73],g[10x73],dg[10x73],R[4]) */
static int casadi_f104(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1503, *w21=w+1623;
  casadi_real *w22=w+1743, *w23=w+1863, *w24=w+1873, *w25=w+1883;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f104(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1887;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1887*sizeof(casadi_real);
  return 0;
}

/* compass_trace_96:(u[4],p[6])->(w[5x97],g[10x97],dg[10x97],R[4]) */
static int casadi_f105(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1503, *w21=w+1623;
  casadi_real *w22=w+1743, *w23=w+1863, *w24=w+1983, *w25=w+2103, *w26=w+2223, *w27=w+2343, *w28=w+2353, *w29=w+2363;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f105(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 2367;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2367*sizeof(casadi_real);
  return 0;
}

/* compass_trace_144:(u[4],p[6])->(w[5x145],g[10x145],dg[10x145],R[4]) */
static int casadi_f106(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1503, *w21=w+1623;
  casadi_real *w22=w+1743, *w23=w+1863, *w24=w+1983, *w25=w+2103, *w26=w+2223, *w27=w+2343, *w28=w+2463, *w29=w+2583, *w30=w+2703, *w31=w+2823, *w32=w+2943, *w33=w+3063;
  casadi_real *w34=w+3183, *w35=w+3303, *w36=w+3313, *w37=w+3323;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f106(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 3327;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3327*sizeof(casadi_real);
  return 0;
}

/* compass_trace_192:(u[4],p[6])->(w[5x193],g[10x193],dg[10x193],R[4]) */
static int casadi_f107(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1503, *w21=w+1623;
  casadi_real *w22=w+1743, *w23=w+1863, *w24=w+1983, *w25=w+2103, *w26=w+2223, *w27=w+2343, *w28=w+2463, *w29=w+2583, *w30=w+2703, *w31=w+2823, *w32=w+2943, *w33=w+3063;
  casadi_real *w34=w+3183, *w35=w+3303, *w36=w+3423, *w37=w+3543, *w38=w+3663, *w39=w+3783, *w40=w+3903, *w41=w+4023, *w42=w+4143, *w43=w+4263, *w44=w+4273, *w45=w+4283;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f107(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 4287;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4287*sizeof(casadi_real);
  return 0;
}

/* compass_trace_288:(u[4],p[6])->(w[5x289],g[10x289],dg[10x289],R[4]) */
static int casadi_f108(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1503, *w21=w+1623;
  casadi_real *w22=w+1743, *w23=w+1863, *w24=w+1983, *w25=w+2103, *w26=w+2223, *w27=w+2343, *w28=w+2463, *w29=w+2583, *w30=w+2703, *w31=w+2823, *w32=w+2943, *w33=w+3063;
  casadi_real *w34=w+3183, *w35=w+3303, *w36=w+3423, *w37=w+3543, *w38=w+3663, *w39=w+3783, *w40=w+3903, *w41=w+4023, *w42=w+4143, *w43=w+4263, *w44=w+4383, *w45=w+4503;
  casadi_real *w46=w+4623, *w47=w+4743, *w48=w+4863, *w49=w+4983, *w50=w+5103, *w51=w+5223, *w52=w+5343, *w53=w+5463, *w54=w+5583, *w55=w+5703, *w56=w+5823, *w57=w+5943;
  casadi_real *w58=w+6063, *w59=w+6183, *w60=w+6193, *w61=w+6203;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f108(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 6207;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6207*sizeof(casadi_real);
  return 0;
}

/* compass_trace_384:(u[4],p[6])->(w[5x385],g[10x385],dg[10x385],R[4]) */
static int casadi_f109(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+316, w02, w03, *w04=w+320, *w05=w+326, *w06=w+350, w07, *w08=w+353, *w09=w+358;
  casadi_real *w10=w+363, *w11=w+423, *w12=w+543, *w13=w+663, *w14=w+783, *w15=w+903, *w16=w+1023, *w17=w+1143, *w18=w+1263, *w19=w+1383, *w20=w+1503, *w21=w+1623;
  casadi_real *w22=w+1743, *w23=w+1863, *w24=w+1983, *w25=w+2103, *w26=w+2223, *w27=w+2343, *w28=w+2463, *w29=w+2583, *w30=w+2703, *w31=w+2823, *w32=w+2943, *w33=w+3063;
  casadi_real *w34=w+3183, *w35=w+3303, *w36=w+3423, *w37=w+3543, *w38=w+3663, *w39=w+3783, *w40=w+3903, *w41=w+4023, *w42=w+4143, *w43=w+4263, *w44=w+4383, *w45=w+4503;
  casadi_real *w46=w+4623, *w47=w+4743, *w48=w+4863, *w49=w+4983, *w50=w+5103, *w51=w+5223, *w52=w+5343, *w53=w+5463, *w54=w+5583, *w55=w+5703, *w56=w+5823, *w57=w+5943;
  casadi_real *w58=w+6063, *w59=w+6183, *w60=w+6303, *w61=w+6423, *w62=w+6543, *w63=w+6663, *w64=w+6783, *w65=w+6903, *w66=w+7023, *w67=w+7143, *w68=w+7263, *w69=w+7383;
  casadi_real *w70=w+7503, *w71=w+7623, *w72=w+7743, *w73=w+7863, *w74=w+7983, *w75=w+8103, *w76=w+8113, *w77=w+8123;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f109(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 8127;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8127*sizeof(casadi_real);
  return 0;
}

/* compass_trace_576:(u[4],p[6])->(w[5x577],g[10x577],dg[10x577],R[4]) */
static int casadi_f110(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+316, w002, w003, *w004=w+320, *w005=w+326, *w006=w+350, w007, *w008=w+353, *w009=w+358;
  casadi_real *w010=w+363, *w011=w+423, *w012=w+543, *w013=w+663, *w014=w+783, *w015=w+903, *w016=w+1023, *w017=w+1143, *w018=w+1263, *w019=w+1383, *w020=w+1503, *w021=w+1623;
  casadi_real *w022=w+1743, *w023=w+1863, *w024=w+1983, *w025=w+2103, *w026=w+2223, *w027=w+2343, *w028=w+2463, *w029=w+2583, *w030=w+2703, *w031=w+2823, *w032=w+2943, *w033=w+3063;
  casadi_real *w034=w+3183, *w035=w+3303, *w036=w+3423, *w037=w+3543, *w038=w+3663, *w039=w+3783, *w040=w+3903, *w041=w+4023, *w042=w+4143, *w043=w+4263, *w044=w+4383, *w045=w+4503;
  casadi_real *w046=w+4623, *w047=w+4743, *w048=w+4863, *w049=w+4983, *w050=w+5103, *w051=w+5223, *w052=w+5343, *w053=w+5463, *w054=w+5583, *w055=w+5703, *w056=w+5823, *w057=w+5943;
  casadi_real *w058=w+6063, *w059=w+6183, *w060=w+6303, *w061=w+6423, *w062=w+6543, *w063=w+6663, *w064=w+6783, *w065=w+6903, *w066=w+7023, *w067=w+7143, *w068=w+7263, *w069=w+7383;
  casadi_real *w070=w+7503, *w071=w+7623, *w072=w+7743, *w073=w+7863, *w074=w+7983, *w075=w+8103, *w076=w+8223, *w077=w+8343, *w078=w+8463, *w079=w+8583, *w080=w+8703, *w081=w+8823;
  casadi_real *w082=w+8943, *w083=w+9063, *w084=w+9183, *w085=w+9303, *w086=w+9423, *w087=w+9543, *w088=w+9663, *w089=w+9783, *w090=w+9903, *w091=w+10023, *w092=w+10143, *w093=w+10263;
  casadi_real *w094=w+10383, *w095=w+10503, *w096=w+10623, *w097=w+10743, *w098=w+10863, *w099=w+10983, *w100=w+11103, *w101=w+11223, *w102=w+11343, *w103=w+11463, *w104=w+11583, *w105=w+11703;
  casadi_real *w106=w+11823, *w107=w+11943, *w108=w+11953, *w109=w+11963;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f110(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 11967;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 11967*sizeof(casadi_real);
  return 0;
}

/* compass_trace_768:(u[4],p[6])->(w[5x769],g[10x769],dg[10x769],R[4]) */
static int casadi_f111(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+316, w002, w003, *w004=w+320, *w005=w+326, *w006=w+350, w007, *w008=w+353, *w009=w+358;
  casadi_real *w010=w+363, *w011=w+423, *w012=w+543, *w013=w+663, *w014=w+783, *w015=w+903, *w016=w+1023, *w017=w+1143, *w018=w+1263, *w019=w+1383, *w020=w+1503, *w021=w+1623;
  casadi_real *w022=w+1743, *w023=w+1863, *w024=w+1983, *w025=w+2103, *w026=w+2223, *w027=w+2343, *w028=w+2463, *w029=w+2583, *w030=w+2703, *w031=w+2823, *w032=w+2943, *w033=w+3063;
  casadi_real *w034=w+3183, *w035=w+3303, *w036=w+3423, *w037=w+3543, *w038=w+3663, *w039=w+3783, *w040=w+3903, *w041=w+4023, *w042=w+4143, *w043=w+4263, *w044=w+4383, *w045=w+4503;
  casadi_real *w046=w+4623, *w047=w+4743, *w048=w+4863, *w049=w+4983, *w050=w+5103, *w051=w+5223, *w052=w+5343, *w053=w+5463, *w054=w+5583, *w055=w+5703, *w056=w+5823, *w057=w+5943;
  casadi_real *w058=w+6063, *w059=w+6183, *w060=w+6303, *w061=w+6423, *w062=w+6543, *w063=w+6663, *w064=w+6783, *w065=w+6903, *w066=w+7023, *w067=w+7143, *w068=w+7263, *w069=w+7383;
  casadi_real *w070=w+7503, *w071=w+7623, *w072=w+7743, *w073=w+7863, *w074=w+7983, *w075=w+8103, *w076=w+8223, *w077=w+8343, *w078=w+8463, *w079=w+8583, *w080=w+8703, *w081=w+8823;
  casadi_real *w082=w+8943, *w083=w+9063, *w084=w+9183, *w085=w+9303, *w086=w+9423, *w087=w+9543, *w088=w+9663, *w089=w+9783, *w090=w+9903, *w091=w+10023, *w092=w+10143, *w093=w+10263;
  casadi_real *w094=w+10383, *w095=w+10503, *w096=w+10623, *w097=w+10743, *w098=w+10863, *w099=w+10983, *w100=w+11103, *w101=w+11223, *w102=w+11343, *w103=w+11463, *w104=w+11583, *w105=w+11703;
  casadi_real *w106=w+11823, *w107=w+11943, *w108=w+12063, *w109=w+12183, *w110=w+12303, *w111=w+12423, *w112=w+12543, *w113=w+12663, *w114=w+12783, *w115=w+12903, *w116=w+13023, *w117=w+13143;
  casadi_real *w118=w+13263, *w119=w+13383, *w120=w+13503, *w121=w+13623, *w122=w+13743, *w123=w+13863, *w124=w+13983, *w125=w+14103, *w126=w+14223, *w127=w+14343, *w128=w+14463, *w129=w+14583;
  casadi_real *w130=w+14703, *w131=w+14823, *w132=w+14943, *w133=w+15063, *w134=w+15183, *w135=w+15303, *w136=w+15423, *w137=w+15543, *w138=w+15663, *w139=w+15783, *w140=w+15793, *w141=w+15803;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f111(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 15807;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 15807*sizeof(casadi_real);
  return 0;
}

/* compass_advance:(t,w[5],h,p[6])->(w_end[5],g[10],dg[10]) */
static int casadi_f112(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w0=w+82, w1, *w2=w+87, *w3=w+93, w4, *w5=w+95, *w6=w+119, *w7=w+124, *w8=w+128, *w9=w+138;
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
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[1][0] = @8 */
  casadi_copy(w8, 10, res[1]);
  /* #12: output[2][0] = @9 */
  casadi_copy(w9, 10, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f112(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 148;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 148*sizeof(casadi_real);
  return 0;
}

/* compass_begin:(u[4],p[6])->(y[4x4]) */
static int casadi_f113(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  return casadi_f113(arg, res, iw, w, mem);
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
static int casadi_f114(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w3=w+306, *w4=w+312, *w5=w+336;
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
  return casadi_f114(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 352;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 352*sizeof(casadi_real);
  return 0;
}

/* compass_end:(y[4x4],u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f115(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  return casadi_f115(arg, res, iw, w, mem);
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
static int casadi_f116(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+316, *w3=w+322, *w4=w+346, *w5=w+351, *w6=w+356, *w7=w+416, *w8=w+536;
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
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f116(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 656;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 656*sizeof(casadi_real);
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
