/* Simplest walker: kernels of the solver
 * Printed by CasADi 3.8.2 from equations 1c495352f80f0021.
 * Do not edit: run `stridemap derive`.
 * SPDX-License-Identifier: BSD-3-Clause
 */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) simplest_walker_kernels_ ## ID
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
CASADI_SYMBOL_EXPORT void simplest_walker_kernels_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int simplest_walker_kernels_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int simplest_walker_kernels_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[15] = 
  {3, 3, 0, 3, 6, 9, 0, 1,
  2, 0, 1, 2, 0, 1, 2};
static const casadi_int casadi_s1[12] = 
  {3, 3, 0, 3, 5, 6, 0, 1,
  2, 1, 2, 2};
static const casadi_int casadi_s2[12] = 
  {3, 3, 0, 1, 3, 6, 0, 0,
  1, 0, 1, 2};
static const casadi_int casadi_s3[3] = {0, 1, 2};
static const casadi_int casadi_s4[3] = {3, 1, 1};
static const casadi_int casadi_s5[3] = {1, 1, 1};
static const casadi_int casadi_s6[3] = {3, 3, 1};
static const casadi_int casadi_s7[3] = {4, 49, 1};
static const casadi_int casadi_s8[3] = {8, 49, 1};
static const casadi_int casadi_s9[3] = {4, 73, 1};
static const casadi_int casadi_s10[3] = {8, 73, 1};
static const casadi_int casadi_s11[3] = {4, 97, 1};
static const casadi_int casadi_s12[3] = {8, 97, 1};
static const casadi_int casadi_s13[3] = {4, 145, 1};
static const casadi_int casadi_s14[3] = {8, 145, 1};
static const casadi_int casadi_s15[3] = {4, 193, 1};
static const casadi_int casadi_s16[3] = {8, 193, 1};
static const casadi_int casadi_s17[3] = {4, 289, 1};
static const casadi_int casadi_s18[3] = {8, 289, 1};
static const casadi_int casadi_s19[3] = {4, 385, 1};
static const casadi_int casadi_s20[3] = {8, 385, 1};
static const casadi_int casadi_s21[3] = {4, 577, 1};
static const casadi_int casadi_s22[3] = {8, 577, 1};
static const casadi_int casadi_s23[3] = {4, 769, 1};
static const casadi_int casadi_s24[3] = {8, 769, 1};
static const casadi_int casadi_s25[3] = {4, 1, 1};
static const casadi_int casadi_s26[3] = {8, 1, 1};
static const casadi_int casadi_s27[3] = {4, 3, 1};
static const casadi_int casadi_s28[3] = {4, 12, 1};
static const casadi_int casadi_s29[3] = {8, 12, 1};

static const casadi_real casadi_c0[9] = 
  {1., 1., 5.0000000000000000e-01, 1., 1., 5.0000000000000000e-01, 1., 1.,
  5.0000000000000000e-01};
static const casadi_real casadi_c1[3] = {1., 1., 2.};

static const casadi_real casadi_zeros[24] = 
  {0.};

/* start:(z[2],p)->(y[4],dy_dz[4x2]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a1=(2.*a0);
  if (res[0]!=0) res[0][1]=a1;
  a1=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][2]=a1;
  a2=1.;
  a0=(2.*a0);
  a3=cos(a0);
  a3=(a2-a3);
  a4=(a1*a3);
  if (res[0]!=0) res[0][3]=a4;
  if (res[1]!=0) res[1][0]=a2;
  a4=2.;
  if (res[1]!=0) res[1][1]=a4;
  a4=0.;
  if (res[1]!=0) res[1][2]=a4;
  a0=sin(a0);
  a0=(-a0);
  a0=(2.*a0);
  a1=(a1*a0);
  a1=(-a1);
  if (res[1]!=0) res[1][3]=a1;
  if (res[1]!=0) res[1][4]=a4;
  if (res[1]!=0) res[1][5]=a4;
  if (res[1]!=0) res[1][6]=a2;
  if (res[1]!=0) res[1][7]=a3;
  return 0;
}

/* turns:(h,p)->(turns[2x12]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a1=0.;
  if (res[0]!=0) res[0][1]=a1;
  if (res[0]!=0) res[0][2]=a0;
  if (res[0]!=0) res[0][3]=a1;
  if (res[0]!=0) res[0][4]=a0;
  if (res[0]!=0) res[0][5]=a1;
  if (res[0]!=0) res[0][6]=a0;
  if (res[0]!=0) res[0][7]=a1;
  if (res[0]!=0) res[0][8]=a0;
  if (res[0]!=0) res[0][9]=a1;
  if (res[0]!=0) res[0][10]=a0;
  if (res[0]!=0) res[0][11]=a1;
  if (res[0]!=0) res[0][12]=a0;
  if (res[0]!=0) res[0][13]=a1;
  if (res[0]!=0) res[0][14]=a0;
  if (res[0]!=0) res[0][15]=a1;
  if (res[0]!=0) res[0][16]=a0;
  if (res[0]!=0) res[0][17]=a1;
  if (res[0]!=0) res[0][18]=a0;
  if (res[0]!=0) res[0][19]=a1;
  if (res[0]!=0) res[0][20]=a0;
  if (res[0]!=0) res[0][21]=a1;
  if (res[0]!=0) res[0][22]=a0;
  if (res[0]!=0) res[0][23]=a1;
  return 0;
}

/* phase:(t,p)->(phase[2]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[4x3],phase[2],turns[2x12],h,p)->(y_end[4x3]) */
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
  casadi_real a204, a205, a206, a207, a208, a209, a210, a211;
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
  a007=arg[4]? arg[4][0] : 0;
  a008=sin(a007);
  a009=cos(a000);
  a010=(a008*a009);
  a011=cos(a007);
  a012=sin(a000);
  a013=(a011*a012);
  a010=(a010-a013);
  a013=(a006*a010);
  a014=1.7082860872947386e-01;
  a014=(a014*a002);
  a015=2.9587585476806851e-02;
  a015=(a015*a002);
  a016=(a015*a003);
  a017=8.8762756430420545e-02;
  a017=(a017*a002);
  a018=1.9725056984537900e-02;
  a018=(a018*a002);
  a019=(a018*a010);
  a020=5.9175170953613701e-02;
  a020=(a020*a002);
  a021=5.2600151958767730e-02;
  a021=(a021*a002);
  a022=(a021*a003);
  a022=(a000+a022);
  a023=cos(a022);
  a024=(a008*a023);
  a022=sin(a022);
  a025=(a011*a022);
  a024=(a024-a025);
  a025=(a020*a024);
  a019=(a019+a025);
  a019=(a003-a019);
  a025=(a017*a019);
  a016=(a016+a025);
  a016=(a000+a016);
  a025=cos(a016);
  a026=(a008*a025);
  a016=sin(a016);
  a027=(a011*a016);
  a026=(a026-a027);
  a027=(a014*a026);
  a013=(a013+a027);
  a027=1.2546768756682242e-01;
  a027=(a027*a002);
  a028=2.4136513415926669e-01;
  a028=(a028*a002);
  a029=(a028*a003);
  a030=-8.8454947932828609e-01;
  a030=(a030*a002);
  a031=(a030*a019);
  a029=(a029+a031);
  a031=9.2483400326179199e-01;
  a031=(a031*a002);
  a032=(a015*a010);
  a033=(a018*a003);
  a034=(a021*a010);
  a034=(a003-a034);
  a035=(a020*a034);
  a033=(a033+a035);
  a033=(a000+a033);
  a035=cos(a033);
  a036=(a008*a035);
  a033=sin(a033);
  a037=(a011*a033);
  a036=(a036-a037);
  a037=(a017*a036);
  a032=(a032+a037);
  a032=(a003-a032);
  a037=(a031*a032);
  a029=(a029+a037);
  a029=(a000+a029);
  a037=cos(a029);
  a038=(a008*a037);
  a029=sin(a029);
  a039=(a011*a029);
  a038=(a038-a039);
  a039=(a027*a038);
  a013=(a013+a039);
  a013=(a003-a013);
  a039=(a005*a013);
  a004=(a004+a039);
  a039=1.8915178993145003e+00;
  a039=(a039*a002);
  a040=3.7109375000000000e-02;
  a040=(a040*a002);
  a041=(a040*a010);
  a042=1.7025221101954405e-01;
  a042=(a042*a002);
  a043=(a042*a026);
  a041=(a041+a043);
  a043=6.0216538980455959e-02;
  a043=(a043*a002);
  a044=(a043*a038);
  a041=(a041+a044);
  a044=-1.7578125000000000e-02;
  a044=(a044*a002);
  a045=(a006*a003);
  a046=(a014*a032);
  a045=(a045+a046);
  a046=(a028*a010);
  a047=(a030*a036);
  a046=(a046+a047);
  a047=(a031*a026);
  a046=(a046+a047);
  a046=(a003-a046);
  a047=(a027*a046);
  a045=(a045+a047);
  a045=(a000+a045);
  a047=cos(a045);
  a048=(a008*a047);
  a045=sin(a045);
  a049=(a011*a045);
  a048=(a048-a049);
  a049=(a044*a048);
  a041=(a041+a049);
  a041=(a003-a041);
  a049=(a039*a041);
  a004=(a004+a049);
  a049=-5.8012039600105849e+00;
  a049=(a049*a002);
  a050=3.7092000118504789e-02;
  a050=(a050*a002);
  a051=(a050*a010);
  a052=1.7038392571223998e-01;
  a052=(a052*a002);
  a053=(a052*a026);
  a051=(a051+a053);
  a053=1.0726203044637328e-01;
  a053=(a053*a002);
  a054=(a053*a038);
  a051=(a051+a054);
  a054=-1.5319437748624402e-02;
  a054=(a054*a002);
  a055=(a054*a048);
  a051=(a051+a055);
  a055=8.2737891638140233e-03;
  a055=(a055*a002);
  a056=(a040*a003);
  a057=(a042*a032);
  a056=(a056+a057);
  a057=(a043*a046);
  a056=(a056+a057);
  a057=(a044*a013);
  a056=(a056+a057);
  a056=(a000+a056);
  a057=cos(a056);
  a058=(a008*a057);
  a056=sin(a056);
  a059=(a011*a056);
  a058=(a058-a059);
  a059=(a055*a058);
  a051=(a051+a059);
  a051=(a003-a051);
  a059=(a049*a051);
  a004=(a004+a059);
  a059=3.1116436695781990e-01;
  a059=(a059*a002);
  a060=6.2411095871607569e-01;
  a060=(a060*a002);
  a061=(a060*a010);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a063=(a062*a026);
  a061=(a061+a063);
  a063=-8.6821934684172597e-01;
  a063=(a063*a002);
  a064=(a063*a038);
  a061=(a061+a064);
  a064=2.7592099699446710e+01;
  a064=(a064*a002);
  a065=(a064*a048);
  a061=(a061+a065);
  a065=2.0154067550477894e+01;
  a065=(a065*a002);
  a066=(a065*a058);
  a061=(a061+a066);
  a066=-4.3489884181069961e+01;
  a066=(a066*a002);
  a067=(a050*a003);
  a068=(a052*a032);
  a067=(a067+a068);
  a068=(a053*a046);
  a067=(a067+a068);
  a068=(a054*a013);
  a067=(a067+a068);
  a068=(a055*a041);
  a067=(a067+a068);
  a067=(a000+a067);
  a068=cos(a067);
  a069=(a008*a068);
  a067=sin(a067);
  a070=(a011*a067);
  a069=(a069-a070);
  a070=(a066*a069);
  a061=(a061+a070);
  a061=(a003-a061);
  a070=(a059*a061);
  a004=(a004+a070);
  a070=-1.5216094966251609e-01;
  a070=(a070*a002);
  a071=4.7766253643826434e-01;
  a071=(a071*a002);
  a072=(a071*a010);
  a073=-2.4881146199716677e+00;
  a073=(a073*a002);
  a074=(a073*a026);
  a072=(a072+a074);
  a074=-5.9029082683684297e-01;
  a074=(a074*a002);
  a075=(a074*a038);
  a072=(a072+a075);
  a075=2.1230051448181193e+01;
  a075=(a075*a002);
  a076=(a075*a048);
  a072=(a072+a076);
  a076=1.5279233632882423e+01;
  a076=(a076*a002);
  a077=(a076*a058);
  a072=(a072+a077);
  a077=-3.3288210968984863e+01;
  a077=(a077*a002);
  a078=(a077*a069);
  a072=(a072+a078);
  a078=-2.0331201708508627e-02;
  a078=(a078*a002);
  a079=(a060*a003);
  a080=(a062*a032);
  a079=(a079+a080);
  a080=(a063*a046);
  a079=(a079+a080);
  a080=(a064*a013);
  a079=(a079+a080);
  a080=(a065*a041);
  a079=(a079+a080);
  a080=(a066*a051);
  a079=(a079+a080);
  a079=(a000+a079);
  a080=cos(a079);
  a081=(a008*a080);
  a079=sin(a079);
  a082=(a011*a079);
  a081=(a081-a082);
  a082=(a078*a081);
  a072=(a072+a082);
  a072=(a003-a072);
  a082=(a070*a072);
  a004=(a004+a082);
  a082=2.0136540080403034e-01;
  a082=(a082*a002);
  a083=-9.3714243008598730e-01;
  a083=(a083*a002);
  a084=(a083*a010);
  a085=5.1863724288440638e+00;
  a085=(a085*a002);
  a086=(a085*a026);
  a084=(a084+a086);
  a086=1.0914373489967295e+00;
  a086=(a086*a002);
  a087=(a086*a038);
  a084=(a084+a087);
  a087=-8.1497870107469268e+00;
  a087=(a087*a002);
  a088=(a087*a048);
  a084=(a084+a088);
  a088=-1.8520065659996959e+01;
  a088=(a088*a002);
  a089=(a088*a058);
  a084=(a084+a089);
  a089=2.2739487099350505e+01;
  a089=(a089*a002);
  a090=(a089*a069);
  a084=(a084+a090);
  a090=2.4936055526796523e+00;
  a090=(a090*a002);
  a091=(a090*a081);
  a084=(a084+a091);
  a091=-3.0467644718982196e+00;
  a091=(a091*a002);
  a092=(a071*a003);
  a093=(a073*a032);
  a092=(a092+a093);
  a093=(a074*a046);
  a092=(a092+a093);
  a093=(a075*a013);
  a092=(a092+a093);
  a093=(a076*a041);
  a092=(a092+a093);
  a093=(a077*a051);
  a092=(a092+a093);
  a093=(a078*a061);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=cos(a092);
  a094=(a008*a093);
  a092=sin(a092);
  a095=(a011*a092);
  a094=(a094-a095);
  a095=(a091*a094);
  a084=(a084+a095);
  a084=(a003-a084);
  a095=(a082*a084);
  a004=(a004+a095);
  a095=4.4710615727772587e-02;
  a095=(a095*a002);
  a096=2.2733101475165380e+00;
  a096=(a096*a002);
  a097=(a096*a010);
  a098=-1.0534495466737249e+01;
  a098=(a098*a002);
  a099=(a098*a026);
  a097=(a097+a099);
  a099=-2.0008720582248625e+00;
  a099=(a099*a002);
  a100=(a099*a038);
  a097=(a097+a100);
  a100=-1.7958931863118799e+01;
  a100=(a100*a002);
  a101=(a100*a048);
  a097=(a097+a101);
  a101=2.7948884529419960e+01;
  a101=(a101*a002);
  a102=(a101*a058);
  a097=(a097+a102);
  a102=-2.8589982771350235e+00;
  a102=(a102*a002);
  a103=(a102*a069);
  a097=(a097+a103);
  a103=-8.8728569335306293e+00;
  a103=(a103*a002);
  a104=(a103*a081);
  a097=(a097+a104);
  a104=1.2360567175794303e+01;
  a104=(a104*a002);
  a105=(a104*a094);
  a097=(a097+a105);
  a105=6.4339274601576357e-01;
  a105=(a105*a002);
  a002=(a083*a003);
  a106=(a085*a032);
  a002=(a002+a106);
  a106=(a086*a046);
  a002=(a002+a106);
  a106=(a087*a013);
  a002=(a002+a106);
  a106=(a088*a041);
  a002=(a002+a106);
  a106=(a089*a051);
  a002=(a002+a106);
  a106=(a090*a061);
  a002=(a002+a106);
  a106=(a091*a072);
  a002=(a002+a106);
  a002=(a000+a002);
  a106=cos(a002);
  a107=(a008*a106);
  a002=sin(a002);
  a108=(a011*a002);
  a107=(a107-a108);
  a108=(a105*a107);
  a097=(a097+a108);
  a097=(a003-a097);
  a108=(a095*a097);
  a004=(a004+a108);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=arg[0]? arg[0][1] : 0;
  a108=arg[0]? arg[0][3] : 0;
  a109=(a001*a108);
  a110=casadi_sq(a003);
  a111=sin(a004);
  a110=(a110*a111);
  a112=(a004+a007);
  a113=sin(a112);
  a114=(a113*a009);
  a112=cos(a112);
  a115=(a112*a012);
  a114=(a114-a115);
  a110=(a110-a114);
  a114=cos(a004);
  a115=1.;
  a116=(a114-a115);
  a117=(a116*a010);
  a110=(a110+a117);
  a117=(a006*a110);
  a118=casadi_sq(a032);
  a119=(a015*a108);
  a120=(a018*a110);
  a121=casadi_sq(a034);
  a122=(a021*a108);
  a122=(a004+a122);
  a123=sin(a122);
  a121=(a121*a123);
  a124=(a122+a007);
  a125=sin(a124);
  a126=(a125*a023);
  a124=cos(a124);
  a127=(a124*a022);
  a126=(a126-a127);
  a121=(a121-a126);
  a122=cos(a122);
  a126=(a122-a115);
  a127=(a126*a024);
  a121=(a121+a127);
  a121=(a020*a121);
  a120=(a120+a121);
  a120=(a108+a120);
  a121=(a017*a120);
  a119=(a119+a121);
  a119=(a004+a119);
  a121=sin(a119);
  a118=(a118*a121);
  a127=(a119+a007);
  a128=sin(a127);
  a129=(a128*a025);
  a127=cos(a127);
  a130=(a127*a016);
  a129=(a129-a130);
  a118=(a118-a129);
  a119=cos(a119);
  a129=(a119-a115);
  a130=(a129*a026);
  a118=(a118+a130);
  a130=(a014*a118);
  a117=(a117+a130);
  a130=casadi_sq(a046);
  a131=(a028*a108);
  a120=(a030*a120);
  a131=(a131+a120);
  a120=(a015*a110);
  a132=casadi_sq(a019);
  a133=(a018*a108);
  a134=(a021*a110);
  a134=(a108+a134);
  a134=(a020*a134);
  a133=(a133+a134);
  a133=(a004+a133);
  a134=sin(a133);
  a132=(a132*a134);
  a135=(a133+a007);
  a136=sin(a135);
  a137=(a136*a035);
  a135=cos(a135);
  a138=(a135*a033);
  a137=(a137-a138);
  a132=(a132-a137);
  a133=cos(a133);
  a137=(a133-a115);
  a138=(a137*a036);
  a132=(a132+a138);
  a138=(a017*a132);
  a120=(a120+a138);
  a120=(a108+a120);
  a138=(a031*a120);
  a131=(a131+a138);
  a131=(a004+a131);
  a138=sin(a131);
  a130=(a130*a138);
  a139=(a131+a007);
  a140=sin(a139);
  a141=(a140*a037);
  a139=cos(a139);
  a142=(a139*a029);
  a141=(a141-a142);
  a130=(a130-a141);
  a131=cos(a131);
  a141=(a131-a115);
  a142=(a141*a038);
  a130=(a130+a142);
  a142=(a027*a130);
  a117=(a117+a142);
  a117=(a108+a117);
  a142=(a005*a117);
  a109=(a109+a142);
  a142=(a040*a110);
  a143=(a042*a118);
  a142=(a142+a143);
  a143=(a043*a130);
  a142=(a142+a143);
  a143=casadi_sq(a013);
  a144=(a006*a108);
  a145=(a014*a120);
  a144=(a144+a145);
  a145=(a028*a110);
  a132=(a030*a132);
  a145=(a145+a132);
  a132=(a031*a118);
  a145=(a145+a132);
  a145=(a108+a145);
  a132=(a027*a145);
  a144=(a144+a132);
  a144=(a004+a144);
  a132=sin(a144);
  a143=(a143*a132);
  a146=(a144+a007);
  a147=sin(a146);
  a148=(a147*a047);
  a146=cos(a146);
  a149=(a146*a045);
  a148=(a148-a149);
  a143=(a143-a148);
  a144=cos(a144);
  a148=(a144-a115);
  a149=(a148*a048);
  a143=(a143+a149);
  a149=(a044*a143);
  a142=(a142+a149);
  a142=(a108+a142);
  a149=(a039*a142);
  a109=(a109+a149);
  a149=(a050*a110);
  a150=(a052*a118);
  a149=(a149+a150);
  a150=(a053*a130);
  a149=(a149+a150);
  a150=(a054*a143);
  a149=(a149+a150);
  a150=casadi_sq(a041);
  a151=(a040*a108);
  a152=(a042*a120);
  a151=(a151+a152);
  a152=(a043*a145);
  a151=(a151+a152);
  a152=(a044*a117);
  a151=(a151+a152);
  a151=(a004+a151);
  a152=sin(a151);
  a150=(a150*a152);
  a153=(a151+a007);
  a154=sin(a153);
  a155=(a154*a057);
  a153=cos(a153);
  a156=(a153*a056);
  a155=(a155-a156);
  a150=(a150-a155);
  a151=cos(a151);
  a155=(a151-a115);
  a156=(a155*a058);
  a150=(a150+a156);
  a156=(a055*a150);
  a149=(a149+a156);
  a149=(a108+a149);
  a156=(a049*a149);
  a109=(a109+a156);
  a156=(a060*a110);
  a157=(a062*a118);
  a156=(a156+a157);
  a157=(a063*a130);
  a156=(a156+a157);
  a157=(a064*a143);
  a156=(a156+a157);
  a157=(a065*a150);
  a156=(a156+a157);
  a157=casadi_sq(a051);
  a158=(a050*a108);
  a159=(a052*a120);
  a158=(a158+a159);
  a159=(a053*a145);
  a158=(a158+a159);
  a159=(a054*a117);
  a158=(a158+a159);
  a159=(a055*a142);
  a158=(a158+a159);
  a158=(a004+a158);
  a159=sin(a158);
  a157=(a157*a159);
  a160=(a158+a007);
  a161=sin(a160);
  a162=(a161*a068);
  a160=cos(a160);
  a163=(a160*a067);
  a162=(a162-a163);
  a157=(a157-a162);
  a158=cos(a158);
  a162=(a158-a115);
  a163=(a162*a069);
  a157=(a157+a163);
  a163=(a066*a157);
  a156=(a156+a163);
  a156=(a108+a156);
  a163=(a059*a156);
  a109=(a109+a163);
  a163=(a071*a110);
  a164=(a073*a118);
  a163=(a163+a164);
  a164=(a074*a130);
  a163=(a163+a164);
  a164=(a075*a143);
  a163=(a163+a164);
  a164=(a076*a150);
  a163=(a163+a164);
  a164=(a077*a157);
  a163=(a163+a164);
  a164=casadi_sq(a061);
  a165=(a060*a108);
  a166=(a062*a120);
  a165=(a165+a166);
  a166=(a063*a145);
  a165=(a165+a166);
  a166=(a064*a117);
  a165=(a165+a166);
  a166=(a065*a142);
  a165=(a165+a166);
  a166=(a066*a149);
  a165=(a165+a166);
  a165=(a004+a165);
  a166=sin(a165);
  a164=(a164*a166);
  a167=(a165+a007);
  a168=sin(a167);
  a169=(a168*a080);
  a167=cos(a167);
  a170=(a167*a079);
  a169=(a169-a170);
  a164=(a164-a169);
  a165=cos(a165);
  a169=(a165-a115);
  a170=(a169*a081);
  a164=(a164+a170);
  a170=(a078*a164);
  a163=(a163+a170);
  a163=(a108+a163);
  a170=(a070*a163);
  a109=(a109+a170);
  a170=(a083*a110);
  a171=(a085*a118);
  a170=(a170+a171);
  a171=(a086*a130);
  a170=(a170+a171);
  a171=(a087*a143);
  a170=(a170+a171);
  a171=(a088*a150);
  a170=(a170+a171);
  a171=(a089*a157);
  a170=(a170+a171);
  a171=(a090*a164);
  a170=(a170+a171);
  a171=casadi_sq(a072);
  a172=(a071*a108);
  a173=(a073*a120);
  a172=(a172+a173);
  a173=(a074*a145);
  a172=(a172+a173);
  a173=(a075*a117);
  a172=(a172+a173);
  a173=(a076*a142);
  a172=(a172+a173);
  a173=(a077*a149);
  a172=(a172+a173);
  a173=(a078*a156);
  a172=(a172+a173);
  a172=(a004+a172);
  a173=sin(a172);
  a171=(a171*a173);
  a174=(a172+a007);
  a175=sin(a174);
  a176=(a175*a093);
  a174=cos(a174);
  a177=(a174*a092);
  a176=(a176-a177);
  a171=(a171-a176);
  a172=cos(a172);
  a176=(a172-a115);
  a177=(a176*a094);
  a171=(a171+a177);
  a177=(a091*a171);
  a170=(a170+a177);
  a170=(a108+a170);
  a177=(a082*a170);
  a109=(a109+a177);
  a177=(a096*a110);
  a118=(a098*a118);
  a177=(a177+a118);
  a130=(a099*a130);
  a177=(a177+a130);
  a130=(a100*a143);
  a177=(a177+a130);
  a130=(a101*a150);
  a177=(a177+a130);
  a130=(a102*a157);
  a177=(a177+a130);
  a130=(a103*a164);
  a177=(a177+a130);
  a130=(a104*a171);
  a177=(a177+a130);
  a130=casadi_sq(a084);
  a118=(a083*a108);
  a178=(a085*a120);
  a118=(a118+a178);
  a178=(a086*a145);
  a118=(a118+a178);
  a178=(a087*a117);
  a118=(a118+a178);
  a178=(a088*a142);
  a118=(a118+a178);
  a178=(a089*a149);
  a118=(a118+a178);
  a178=(a090*a156);
  a118=(a118+a178);
  a178=(a091*a163);
  a118=(a118+a178);
  a118=(a004+a118);
  a178=sin(a118);
  a130=(a130*a178);
  a179=(a118+a007);
  a180=sin(a179);
  a181=(a180*a106);
  a179=cos(a179);
  a182=(a179*a002);
  a181=(a181-a182);
  a130=(a130-a181);
  a118=cos(a118);
  a181=(a118-a115);
  a182=(a181*a107);
  a130=(a130+a182);
  a182=(a105*a130);
  a177=(a177+a182);
  a177=(a108+a177);
  a177=(a095*a177);
  a109=(a109+a177);
  a109=(a004+a109);
  if (res[0]!=0) res[0][1]=a109;
  a109=(a001*a010);
  a177=(a005*a048);
  a109=(a109+a177);
  a177=(a039*a058);
  a109=(a109+a177);
  a177=(a049*a069);
  a109=(a109+a177);
  a177=(a059*a081);
  a109=(a109+a177);
  a177=(a070*a094);
  a109=(a109+a177);
  a177=(a082*a107);
  a109=(a109+a177);
  a177=(a096*a003);
  a182=(a098*a032);
  a177=(a177+a182);
  a182=(a099*a046);
  a177=(a177+a182);
  a182=(a100*a013);
  a177=(a177+a182);
  a182=(a101*a041);
  a177=(a177+a182);
  a182=(a102*a051);
  a177=(a177+a182);
  a182=(a103*a061);
  a177=(a177+a182);
  a182=(a104*a072);
  a177=(a177+a182);
  a182=(a105*a084);
  a177=(a177+a182);
  a000=(a000+a177);
  a177=cos(a000);
  a182=(a008*a177);
  a000=sin(a000);
  a183=(a011*a000);
  a182=(a182-a183);
  a183=(a095*a182);
  a109=(a109+a183);
  a109=(a003-a109);
  if (res[0]!=0) res[0][2]=a109;
  a110=(a001*a110);
  a143=(a005*a143);
  a110=(a110+a143);
  a150=(a039*a150);
  a110=(a110+a150);
  a157=(a049*a157);
  a110=(a110+a157);
  a164=(a059*a164);
  a110=(a110+a164);
  a171=(a070*a171);
  a110=(a110+a171);
  a130=(a082*a130);
  a110=(a110+a130);
  a130=casadi_sq(a097);
  a171=(a096*a108);
  a120=(a098*a120);
  a171=(a171+a120);
  a145=(a099*a145);
  a171=(a171+a145);
  a117=(a100*a117);
  a171=(a171+a117);
  a142=(a101*a142);
  a171=(a171+a142);
  a149=(a102*a149);
  a171=(a171+a149);
  a156=(a103*a156);
  a171=(a171+a156);
  a163=(a104*a163);
  a171=(a171+a163);
  a170=(a105*a170);
  a171=(a171+a170);
  a004=(a004+a171);
  a171=sin(a004);
  a130=(a130*a171);
  a007=(a004+a007);
  a170=sin(a007);
  a163=(a170*a177);
  a007=cos(a007);
  a156=(a007*a000);
  a163=(a163-a156);
  a130=(a130-a163);
  a004=cos(a004);
  a115=(a004-a115);
  a163=(a115*a182);
  a130=(a130+a163);
  a130=(a095*a130);
  a110=(a110+a130);
  a108=(a108+a110);
  if (res[0]!=0) res[0][3]=a108;
  a108=arg[0]? arg[0][4] : 0;
  a110=arg[0]? arg[0][6] : 0;
  a130=(a001*a110);
  a163=(a011*a009);
  a156=(a008*a012);
  a163=(a163+a156);
  a156=(a163*a108);
  a149=(a006*a156);
  a142=(a011*a025);
  a117=(a008*a016);
  a142=(a142+a117);
  a117=(a015*a110);
  a145=(a018*a156);
  a120=(a011*a023);
  a164=(a008*a022);
  a120=(a120+a164);
  a164=(a021*a110);
  a164=(a108+a164);
  a157=(a120*a164);
  a157=(a020*a157);
  a145=(a145+a157);
  a145=(a110+a145);
  a157=(a017*a145);
  a117=(a117+a157);
  a117=(a108+a117);
  a157=(a142*a117);
  a150=(a014*a157);
  a149=(a149+a150);
  a150=(a011*a037);
  a143=(a008*a029);
  a150=(a150+a143);
  a143=(a028*a110);
  a109=(a030*a145);
  a143=(a143+a109);
  a109=(a015*a156);
  a183=(a011*a035);
  a184=(a008*a033);
  a183=(a183+a184);
  a184=(a018*a110);
  a185=(a021*a156);
  a185=(a110+a185);
  a186=(a020*a185);
  a184=(a184+a186);
  a184=(a108+a184);
  a186=(a183*a184);
  a187=(a017*a186);
  a109=(a109+a187);
  a109=(a110+a109);
  a187=(a031*a109);
  a143=(a143+a187);
  a143=(a108+a143);
  a187=(a150*a143);
  a188=(a027*a187);
  a149=(a149+a188);
  a149=(a110+a149);
  a188=(a005*a149);
  a130=(a130+a188);
  a188=(a040*a156);
  a189=(a042*a157);
  a188=(a188+a189);
  a189=(a043*a187);
  a188=(a188+a189);
  a189=(a011*a047);
  a190=(a008*a045);
  a189=(a189+a190);
  a190=(a006*a110);
  a191=(a014*a109);
  a190=(a190+a191);
  a191=(a028*a156);
  a186=(a030*a186);
  a191=(a191+a186);
  a186=(a031*a157);
  a191=(a191+a186);
  a191=(a110+a191);
  a186=(a027*a191);
  a190=(a190+a186);
  a190=(a108+a190);
  a186=(a189*a190);
  a192=(a044*a186);
  a188=(a188+a192);
  a188=(a110+a188);
  a192=(a039*a188);
  a130=(a130+a192);
  a192=(a050*a156);
  a193=(a052*a157);
  a192=(a192+a193);
  a193=(a053*a187);
  a192=(a192+a193);
  a193=(a054*a186);
  a192=(a192+a193);
  a193=(a011*a057);
  a194=(a008*a056);
  a193=(a193+a194);
  a194=(a040*a110);
  a195=(a042*a109);
  a194=(a194+a195);
  a195=(a043*a191);
  a194=(a194+a195);
  a195=(a044*a149);
  a194=(a194+a195);
  a194=(a108+a194);
  a195=(a193*a194);
  a196=(a055*a195);
  a192=(a192+a196);
  a192=(a110+a192);
  a196=(a049*a192);
  a130=(a130+a196);
  a196=(a060*a156);
  a197=(a062*a157);
  a196=(a196+a197);
  a197=(a063*a187);
  a196=(a196+a197);
  a197=(a064*a186);
  a196=(a196+a197);
  a197=(a065*a195);
  a196=(a196+a197);
  a197=(a011*a068);
  a198=(a008*a067);
  a197=(a197+a198);
  a198=(a050*a110);
  a199=(a052*a109);
  a198=(a198+a199);
  a199=(a053*a191);
  a198=(a198+a199);
  a199=(a054*a149);
  a198=(a198+a199);
  a199=(a055*a188);
  a198=(a198+a199);
  a198=(a108+a198);
  a199=(a197*a198);
  a200=(a066*a199);
  a196=(a196+a200);
  a196=(a110+a196);
  a200=(a059*a196);
  a130=(a130+a200);
  a200=(a071*a156);
  a201=(a073*a157);
  a200=(a200+a201);
  a201=(a074*a187);
  a200=(a200+a201);
  a201=(a075*a186);
  a200=(a200+a201);
  a201=(a076*a195);
  a200=(a200+a201);
  a201=(a077*a199);
  a200=(a200+a201);
  a201=(a011*a080);
  a202=(a008*a079);
  a201=(a201+a202);
  a202=(a060*a110);
  a203=(a062*a109);
  a202=(a202+a203);
  a203=(a063*a191);
  a202=(a202+a203);
  a203=(a064*a149);
  a202=(a202+a203);
  a203=(a065*a188);
  a202=(a202+a203);
  a203=(a066*a192);
  a202=(a202+a203);
  a202=(a108+a202);
  a203=(a201*a202);
  a204=(a078*a203);
  a200=(a200+a204);
  a200=(a110+a200);
  a204=(a070*a200);
  a130=(a130+a204);
  a204=(a083*a156);
  a205=(a085*a157);
  a204=(a204+a205);
  a205=(a086*a187);
  a204=(a204+a205);
  a205=(a087*a186);
  a204=(a204+a205);
  a205=(a088*a195);
  a204=(a204+a205);
  a205=(a089*a199);
  a204=(a204+a205);
  a205=(a090*a203);
  a204=(a204+a205);
  a205=(a011*a093);
  a206=(a008*a092);
  a205=(a205+a206);
  a206=(a071*a110);
  a207=(a073*a109);
  a206=(a206+a207);
  a207=(a074*a191);
  a206=(a206+a207);
  a207=(a075*a149);
  a206=(a206+a207);
  a207=(a076*a188);
  a206=(a206+a207);
  a207=(a077*a192);
  a206=(a206+a207);
  a207=(a078*a196);
  a206=(a206+a207);
  a206=(a108+a206);
  a207=(a205*a206);
  a208=(a091*a207);
  a204=(a204+a208);
  a204=(a110+a204);
  a208=(a082*a204);
  a130=(a130+a208);
  a208=(a096*a156);
  a157=(a098*a157);
  a208=(a208+a157);
  a187=(a099*a187);
  a208=(a208+a187);
  a187=(a100*a186);
  a208=(a208+a187);
  a187=(a101*a195);
  a208=(a208+a187);
  a187=(a102*a199);
  a208=(a208+a187);
  a187=(a103*a203);
  a208=(a208+a187);
  a187=(a104*a207);
  a208=(a208+a187);
  a187=(a011*a106);
  a157=(a008*a002);
  a187=(a187+a157);
  a157=(a083*a110);
  a209=(a085*a109);
  a157=(a157+a209);
  a209=(a086*a191);
  a157=(a157+a209);
  a209=(a087*a149);
  a157=(a157+a209);
  a209=(a088*a188);
  a157=(a157+a209);
  a209=(a089*a192);
  a157=(a157+a209);
  a209=(a090*a196);
  a157=(a157+a209);
  a209=(a091*a200);
  a157=(a157+a209);
  a157=(a108+a157);
  a209=(a187*a157);
  a210=(a105*a209);
  a208=(a208+a210);
  a208=(a110+a208);
  a210=(a095*a208);
  a130=(a130+a210);
  a130=(a108+a130);
  if (res[0]!=0) res[0][4]=a130;
  a130=arg[0]? arg[0][5] : 0;
  a210=arg[0]? arg[0][7] : 0;
  a211=(a001*a210);
  a112=(a112*a009);
  a113=(a113*a012);
  a112=(a112+a113);
  a116=(a116*a163);
  a116=(a112-a116);
  a113=(a116*a108);
  a114=(a114*a003);
  a114=(a114*a003);
  a114=(a114-a112);
  a010=(a010*a111);
  a114=(a114-a010);
  a010=(a114*a130);
  a113=(a113+a010);
  a003=(2.*a003);
  a003=(a003*a111);
  a111=(a003*a110);
  a113=(a113+a111);
  a111=(a006*a113);
  a127=(a127*a025);
  a128=(a128*a016);
  a127=(a127+a128);
  a129=(a129*a142);
  a129=(a127-a129);
  a117=(a129*a117);
  a119=(a119*a032);
  a119=(a119*a032);
  a119=(a119-a127);
  a026=(a026*a121);
  a119=(a119-a026);
  a026=(a015*a210);
  a127=(a018*a113);
  a124=(a124*a023);
  a125=(a125*a022);
  a124=(a124+a125);
  a126=(a126*a120);
  a126=(a124-a126);
  a164=(a126*a164);
  a122=(a122*a034);
  a122=(a122*a034);
  a122=(a122-a124);
  a024=(a024*a123);
  a122=(a122-a024);
  a024=(a021*a210);
  a024=(a130+a024);
  a024=(a122*a024);
  a164=(a164+a024);
  a034=(2.*a034);
  a034=(a034*a123);
  a185=(a034*a185);
  a164=(a164+a185);
  a164=(a020*a164);
  a127=(a127+a164);
  a127=(a210+a127);
  a164=(a017*a127);
  a026=(a026+a164);
  a026=(a130+a026);
  a026=(a119*a026);
  a117=(a117+a026);
  a032=(2.*a032);
  a032=(a032*a121);
  a121=(a032*a109);
  a117=(a117+a121);
  a121=(a014*a117);
  a111=(a111+a121);
  a139=(a139*a037);
  a140=(a140*a029);
  a139=(a139+a140);
  a141=(a141*a150);
  a141=(a139-a141);
  a143=(a141*a143);
  a131=(a131*a046);
  a131=(a131*a046);
  a131=(a131-a139);
  a038=(a038*a138);
  a131=(a131-a038);
  a038=(a028*a210);
  a127=(a030*a127);
  a038=(a038+a127);
  a127=(a015*a113);
  a135=(a135*a035);
  a136=(a136*a033);
  a135=(a135+a136);
  a137=(a137*a183);
  a137=(a135-a137);
  a184=(a137*a184);
  a133=(a133*a019);
  a133=(a133*a019);
  a133=(a133-a135);
  a036=(a036*a134);
  a133=(a133-a036);
  a036=(a018*a210);
  a135=(a021*a113);
  a135=(a210+a135);
  a135=(a020*a135);
  a036=(a036+a135);
  a036=(a130+a036);
  a036=(a133*a036);
  a184=(a184+a036);
  a019=(2.*a019);
  a019=(a019*a134);
  a145=(a019*a145);
  a184=(a184+a145);
  a145=(a017*a184);
  a127=(a127+a145);
  a127=(a210+a127);
  a145=(a031*a127);
  a038=(a038+a145);
  a038=(a130+a038);
  a038=(a131*a038);
  a143=(a143+a038);
  a046=(2.*a046);
  a046=(a046*a138);
  a138=(a046*a191);
  a143=(a143+a138);
  a138=(a027*a143);
  a111=(a111+a138);
  a111=(a210+a111);
  a138=(a005*a111);
  a211=(a211+a138);
  a138=(a040*a113);
  a038=(a042*a117);
  a138=(a138+a038);
  a038=(a043*a143);
  a138=(a138+a038);
  a146=(a146*a047);
  a147=(a147*a045);
  a146=(a146+a147);
  a148=(a148*a189);
  a148=(a146-a148);
  a190=(a148*a190);
  a144=(a144*a013);
  a144=(a144*a013);
  a144=(a144-a146);
  a048=(a048*a132);
  a144=(a144-a048);
  a048=(a006*a210);
  a146=(a014*a127);
  a048=(a048+a146);
  a146=(a028*a113);
  a184=(a030*a184);
  a146=(a146+a184);
  a184=(a031*a117);
  a146=(a146+a184);
  a146=(a210+a146);
  a184=(a027*a146);
  a048=(a048+a184);
  a048=(a130+a048);
  a048=(a144*a048);
  a190=(a190+a048);
  a013=(2.*a013);
  a013=(a013*a132);
  a132=(a013*a149);
  a190=(a190+a132);
  a132=(a044*a190);
  a138=(a138+a132);
  a138=(a210+a138);
  a132=(a039*a138);
  a211=(a211+a132);
  a132=(a050*a113);
  a048=(a052*a117);
  a132=(a132+a048);
  a048=(a053*a143);
  a132=(a132+a048);
  a048=(a054*a190);
  a132=(a132+a048);
  a153=(a153*a057);
  a154=(a154*a056);
  a153=(a153+a154);
  a155=(a155*a193);
  a155=(a153-a155);
  a194=(a155*a194);
  a151=(a151*a041);
  a151=(a151*a041);
  a151=(a151-a153);
  a058=(a058*a152);
  a151=(a151-a058);
  a058=(a040*a210);
  a153=(a042*a127);
  a058=(a058+a153);
  a153=(a043*a146);
  a058=(a058+a153);
  a153=(a044*a111);
  a058=(a058+a153);
  a058=(a130+a058);
  a058=(a151*a058);
  a194=(a194+a058);
  a041=(2.*a041);
  a041=(a041*a152);
  a152=(a041*a188);
  a194=(a194+a152);
  a152=(a055*a194);
  a132=(a132+a152);
  a132=(a210+a132);
  a152=(a049*a132);
  a211=(a211+a152);
  a152=(a060*a113);
  a058=(a062*a117);
  a152=(a152+a058);
  a058=(a063*a143);
  a152=(a152+a058);
  a058=(a064*a190);
  a152=(a152+a058);
  a058=(a065*a194);
  a152=(a152+a058);
  a160=(a160*a068);
  a161=(a161*a067);
  a160=(a160+a161);
  a162=(a162*a197);
  a162=(a160-a162);
  a198=(a162*a198);
  a158=(a158*a051);
  a158=(a158*a051);
  a158=(a158-a160);
  a069=(a069*a159);
  a158=(a158-a069);
  a069=(a050*a210);
  a160=(a052*a127);
  a069=(a069+a160);
  a160=(a053*a146);
  a069=(a069+a160);
  a160=(a054*a111);
  a069=(a069+a160);
  a160=(a055*a138);
  a069=(a069+a160);
  a069=(a130+a069);
  a069=(a158*a069);
  a198=(a198+a069);
  a051=(2.*a051);
  a051=(a051*a159);
  a159=(a051*a192);
  a198=(a198+a159);
  a159=(a066*a198);
  a152=(a152+a159);
  a152=(a210+a152);
  a159=(a059*a152);
  a211=(a211+a159);
  a159=(a071*a113);
  a069=(a073*a117);
  a159=(a159+a069);
  a069=(a074*a143);
  a159=(a159+a069);
  a069=(a075*a190);
  a159=(a159+a069);
  a069=(a076*a194);
  a159=(a159+a069);
  a069=(a077*a198);
  a159=(a159+a069);
  a167=(a167*a080);
  a168=(a168*a079);
  a167=(a167+a168);
  a169=(a169*a201);
  a169=(a167-a169);
  a202=(a169*a202);
  a165=(a165*a061);
  a165=(a165*a061);
  a165=(a165-a167);
  a081=(a081*a166);
  a165=(a165-a081);
  a081=(a060*a210);
  a167=(a062*a127);
  a081=(a081+a167);
  a167=(a063*a146);
  a081=(a081+a167);
  a167=(a064*a111);
  a081=(a081+a167);
  a167=(a065*a138);
  a081=(a081+a167);
  a167=(a066*a132);
  a081=(a081+a167);
  a081=(a130+a081);
  a081=(a165*a081);
  a202=(a202+a081);
  a061=(2.*a061);
  a061=(a061*a166);
  a166=(a061*a196);
  a202=(a202+a166);
  a166=(a078*a202);
  a159=(a159+a166);
  a159=(a210+a159);
  a166=(a070*a159);
  a211=(a211+a166);
  a166=(a083*a113);
  a081=(a085*a117);
  a166=(a166+a081);
  a081=(a086*a143);
  a166=(a166+a081);
  a081=(a087*a190);
  a166=(a166+a081);
  a081=(a088*a194);
  a166=(a166+a081);
  a081=(a089*a198);
  a166=(a166+a081);
  a081=(a090*a202);
  a166=(a166+a081);
  a174=(a174*a093);
  a175=(a175*a092);
  a174=(a174+a175);
  a176=(a176*a205);
  a176=(a174-a176);
  a206=(a176*a206);
  a172=(a172*a072);
  a172=(a172*a072);
  a172=(a172-a174);
  a094=(a094*a173);
  a172=(a172-a094);
  a094=(a071*a210);
  a174=(a073*a127);
  a094=(a094+a174);
  a174=(a074*a146);
  a094=(a094+a174);
  a174=(a075*a111);
  a094=(a094+a174);
  a174=(a076*a138);
  a094=(a094+a174);
  a174=(a077*a132);
  a094=(a094+a174);
  a174=(a078*a152);
  a094=(a094+a174);
  a094=(a130+a094);
  a094=(a172*a094);
  a206=(a206+a094);
  a072=(2.*a072);
  a072=(a072*a173);
  a173=(a072*a200);
  a206=(a206+a173);
  a173=(a091*a206);
  a166=(a166+a173);
  a166=(a210+a166);
  a173=(a082*a166);
  a211=(a211+a173);
  a173=(a096*a113);
  a117=(a098*a117);
  a173=(a173+a117);
  a143=(a099*a143);
  a173=(a173+a143);
  a143=(a100*a190);
  a173=(a173+a143);
  a143=(a101*a194);
  a173=(a173+a143);
  a143=(a102*a198);
  a173=(a173+a143);
  a143=(a103*a202);
  a173=(a173+a143);
  a143=(a104*a206);
  a173=(a173+a143);
  a179=(a179*a106);
  a180=(a180*a002);
  a179=(a179+a180);
  a181=(a181*a187);
  a181=(a179-a181);
  a157=(a181*a157);
  a118=(a118*a084);
  a118=(a118*a084);
  a118=(a118-a179);
  a107=(a107*a178);
  a118=(a118-a107);
  a107=(a083*a210);
  a179=(a085*a127);
  a107=(a107+a179);
  a179=(a086*a146);
  a107=(a107+a179);
  a179=(a087*a111);
  a107=(a107+a179);
  a179=(a088*a138);
  a107=(a107+a179);
  a179=(a089*a132);
  a107=(a107+a179);
  a179=(a090*a152);
  a107=(a107+a179);
  a179=(a091*a159);
  a107=(a107+a179);
  a107=(a130+a107);
  a107=(a118*a107);
  a157=(a157+a107);
  a084=(2.*a084);
  a084=(a084*a178);
  a178=(a084*a204);
  a157=(a157+a178);
  a178=(a105*a157);
  a173=(a173+a178);
  a173=(a210+a173);
  a173=(a095*a173);
  a211=(a211+a173);
  a211=(a130+a211);
  if (res[0]!=0) res[0][5]=a211;
  a156=(a001*a156);
  a186=(a005*a186);
  a156=(a156+a186);
  a195=(a039*a195);
  a156=(a156+a195);
  a199=(a049*a199);
  a156=(a156+a199);
  a203=(a059*a203);
  a156=(a156+a203);
  a207=(a070*a207);
  a156=(a156+a207);
  a209=(a082*a209);
  a156=(a156+a209);
  a011=(a011*a177);
  a008=(a008*a000);
  a011=(a011+a008);
  a008=(a096*a110);
  a109=(a098*a109);
  a008=(a008+a109);
  a191=(a099*a191);
  a008=(a008+a191);
  a149=(a100*a149);
  a008=(a008+a149);
  a188=(a101*a188);
  a008=(a008+a188);
  a192=(a102*a192);
  a008=(a008+a192);
  a196=(a103*a196);
  a008=(a008+a196);
  a200=(a104*a200);
  a008=(a008+a200);
  a204=(a105*a204);
  a008=(a008+a204);
  a108=(a108+a008);
  a008=(a011*a108);
  a008=(a095*a008);
  a156=(a156+a008);
  a110=(a110+a156);
  if (res[0]!=0) res[0][6]=a110;
  a113=(a001*a113);
  a190=(a005*a190);
  a113=(a113+a190);
  a194=(a039*a194);
  a113=(a113+a194);
  a198=(a049*a198);
  a113=(a113+a198);
  a202=(a059*a202);
  a113=(a113+a202);
  a206=(a070*a206);
  a113=(a113+a206);
  a157=(a082*a157);
  a113=(a113+a157);
  a007=(a007*a177);
  a170=(a170*a000);
  a007=(a007+a170);
  a115=(a115*a011);
  a115=(a007-a115);
  a108=(a115*a108);
  a004=(a004*a097);
  a004=(a004*a097);
  a004=(a004-a007);
  a182=(a182*a171);
  a004=(a004-a182);
  a182=(a096*a210);
  a127=(a098*a127);
  a182=(a182+a127);
  a146=(a099*a146);
  a182=(a182+a146);
  a111=(a100*a111);
  a182=(a182+a111);
  a138=(a101*a138);
  a182=(a182+a138);
  a132=(a102*a132);
  a182=(a182+a132);
  a152=(a103*a152);
  a182=(a182+a152);
  a159=(a104*a159);
  a182=(a182+a159);
  a166=(a105*a166);
  a182=(a182+a166);
  a130=(a130+a182);
  a130=(a004*a130);
  a108=(a108+a130);
  a097=(2.*a097);
  a097=(a097*a171);
  a208=(a097*a208);
  a108=(a108+a208);
  a108=(a095*a108);
  a113=(a113+a108);
  a210=(a210+a113);
  if (res[0]!=0) res[0][7]=a210;
  a210=arg[0]? arg[0][8] : 0;
  a113=arg[0]? arg[0][10] : 0;
  a108=(a001*a113);
  a163=(a163*a210);
  a208=(a006*a163);
  a171=(a015*a113);
  a130=(a018*a163);
  a182=(a021*a113);
  a182=(a210+a182);
  a120=(a120*a182);
  a120=(a020*a120);
  a130=(a130+a120);
  a130=(a113+a130);
  a120=(a017*a130);
  a171=(a171+a120);
  a171=(a210+a171);
  a142=(a142*a171);
  a120=(a014*a142);
  a208=(a208+a120);
  a120=(a028*a113);
  a166=(a030*a130);
  a120=(a120+a166);
  a166=(a015*a163);
  a159=(a018*a113);
  a152=(a021*a163);
  a152=(a113+a152);
  a132=(a020*a152);
  a159=(a159+a132);
  a159=(a210+a159);
  a183=(a183*a159);
  a132=(a017*a183);
  a166=(a166+a132);
  a166=(a113+a166);
  a132=(a031*a166);
  a120=(a120+a132);
  a120=(a210+a120);
  a150=(a150*a120);
  a132=(a027*a150);
  a208=(a208+a132);
  a208=(a113+a208);
  a132=(a005*a208);
  a108=(a108+a132);
  a132=(a040*a163);
  a138=(a042*a142);
  a132=(a132+a138);
  a138=(a043*a150);
  a132=(a132+a138);
  a138=(a006*a113);
  a111=(a014*a166);
  a138=(a138+a111);
  a111=(a028*a163);
  a183=(a030*a183);
  a111=(a111+a183);
  a183=(a031*a142);
  a111=(a111+a183);
  a111=(a113+a111);
  a183=(a027*a111);
  a138=(a138+a183);
  a138=(a210+a138);
  a189=(a189*a138);
  a183=(a044*a189);
  a132=(a132+a183);
  a132=(a113+a132);
  a183=(a039*a132);
  a108=(a108+a183);
  a183=(a050*a163);
  a146=(a052*a142);
  a183=(a183+a146);
  a146=(a053*a150);
  a183=(a183+a146);
  a146=(a054*a189);
  a183=(a183+a146);
  a146=(a040*a113);
  a127=(a042*a166);
  a146=(a146+a127);
  a127=(a043*a111);
  a146=(a146+a127);
  a127=(a044*a208);
  a146=(a146+a127);
  a146=(a210+a146);
  a193=(a193*a146);
  a127=(a055*a193);
  a183=(a183+a127);
  a183=(a113+a183);
  a127=(a049*a183);
  a108=(a108+a127);
  a127=(a060*a163);
  a007=(a062*a142);
  a127=(a127+a007);
  a007=(a063*a150);
  a127=(a127+a007);
  a007=(a064*a189);
  a127=(a127+a007);
  a007=(a065*a193);
  a127=(a127+a007);
  a007=(a050*a113);
  a170=(a052*a166);
  a007=(a007+a170);
  a170=(a053*a111);
  a007=(a007+a170);
  a170=(a054*a208);
  a007=(a007+a170);
  a170=(a055*a132);
  a007=(a007+a170);
  a007=(a210+a007);
  a197=(a197*a007);
  a170=(a066*a197);
  a127=(a127+a170);
  a127=(a113+a127);
  a170=(a059*a127);
  a108=(a108+a170);
  a170=(a071*a163);
  a000=(a073*a142);
  a170=(a170+a000);
  a000=(a074*a150);
  a170=(a170+a000);
  a000=(a075*a189);
  a170=(a170+a000);
  a000=(a076*a193);
  a170=(a170+a000);
  a000=(a077*a197);
  a170=(a170+a000);
  a000=(a060*a113);
  a177=(a062*a166);
  a000=(a000+a177);
  a177=(a063*a111);
  a000=(a000+a177);
  a177=(a064*a208);
  a000=(a000+a177);
  a177=(a065*a132);
  a000=(a000+a177);
  a177=(a066*a183);
  a000=(a000+a177);
  a000=(a210+a000);
  a201=(a201*a000);
  a177=(a078*a201);
  a170=(a170+a177);
  a170=(a113+a170);
  a177=(a070*a170);
  a108=(a108+a177);
  a177=(a083*a163);
  a157=(a085*a142);
  a177=(a177+a157);
  a157=(a086*a150);
  a177=(a177+a157);
  a157=(a087*a189);
  a177=(a177+a157);
  a157=(a088*a193);
  a177=(a177+a157);
  a157=(a089*a197);
  a177=(a177+a157);
  a157=(a090*a201);
  a177=(a177+a157);
  a157=(a071*a113);
  a206=(a073*a166);
  a157=(a157+a206);
  a206=(a074*a111);
  a157=(a157+a206);
  a206=(a075*a208);
  a157=(a157+a206);
  a206=(a076*a132);
  a157=(a157+a206);
  a206=(a077*a183);
  a157=(a157+a206);
  a206=(a078*a127);
  a157=(a157+a206);
  a157=(a210+a157);
  a205=(a205*a157);
  a206=(a091*a205);
  a177=(a177+a206);
  a177=(a113+a177);
  a206=(a082*a177);
  a108=(a108+a206);
  a206=(a096*a163);
  a142=(a098*a142);
  a206=(a206+a142);
  a150=(a099*a150);
  a206=(a206+a150);
  a150=(a100*a189);
  a206=(a206+a150);
  a150=(a101*a193);
  a206=(a206+a150);
  a150=(a102*a197);
  a206=(a206+a150);
  a150=(a103*a201);
  a206=(a206+a150);
  a150=(a104*a205);
  a206=(a206+a150);
  a150=(a083*a113);
  a142=(a085*a166);
  a150=(a150+a142);
  a142=(a086*a111);
  a150=(a150+a142);
  a142=(a087*a208);
  a150=(a150+a142);
  a142=(a088*a132);
  a150=(a150+a142);
  a142=(a089*a183);
  a150=(a150+a142);
  a142=(a090*a127);
  a150=(a150+a142);
  a142=(a091*a170);
  a150=(a150+a142);
  a150=(a210+a150);
  a187=(a187*a150);
  a142=(a105*a187);
  a206=(a206+a142);
  a206=(a113+a206);
  a142=(a095*a206);
  a108=(a108+a142);
  a108=(a210+a108);
  if (res[0]!=0) res[0][8]=a108;
  a108=arg[0]? arg[0][9] : 0;
  a142=arg[0]? arg[0][11] : 0;
  a202=(a001*a142);
  a116=(a116*a210);
  a114=(a114*a108);
  a116=(a116+a114);
  a003=(a003*a113);
  a116=(a116+a003);
  a003=(a006*a116);
  a129=(a129*a171);
  a171=(a015*a142);
  a114=(a018*a116);
  a126=(a126*a182);
  a182=(a021*a142);
  a182=(a108+a182);
  a122=(a122*a182);
  a126=(a126+a122);
  a034=(a034*a152);
  a126=(a126+a034);
  a126=(a020*a126);
  a114=(a114+a126);
  a114=(a142+a114);
  a126=(a017*a114);
  a171=(a171+a126);
  a171=(a108+a171);
  a119=(a119*a171);
  a129=(a129+a119);
  a032=(a032*a166);
  a129=(a129+a032);
  a032=(a014*a129);
  a003=(a003+a032);
  a141=(a141*a120);
  a120=(a028*a142);
  a114=(a030*a114);
  a120=(a120+a114);
  a015=(a015*a116);
  a137=(a137*a159);
  a018=(a018*a142);
  a021=(a021*a116);
  a021=(a142+a021);
  a020=(a020*a021);
  a018=(a018+a020);
  a018=(a108+a018);
  a133=(a133*a018);
  a137=(a137+a133);
  a019=(a019*a130);
  a137=(a137+a019);
  a017=(a017*a137);
  a015=(a015+a017);
  a015=(a142+a015);
  a017=(a031*a015);
  a120=(a120+a017);
  a120=(a108+a120);
  a131=(a131*a120);
  a141=(a141+a131);
  a046=(a046*a111);
  a141=(a141+a046);
  a046=(a027*a141);
  a003=(a003+a046);
  a003=(a142+a003);
  a046=(a005*a003);
  a202=(a202+a046);
  a046=(a040*a116);
  a131=(a042*a129);
  a046=(a046+a131);
  a131=(a043*a141);
  a046=(a046+a131);
  a148=(a148*a138);
  a006=(a006*a142);
  a014=(a014*a015);
  a006=(a006+a014);
  a028=(a028*a116);
  a030=(a030*a137);
  a028=(a028+a030);
  a031=(a031*a129);
  a028=(a028+a031);
  a028=(a142+a028);
  a027=(a027*a028);
  a006=(a006+a027);
  a006=(a108+a006);
  a144=(a144*a006);
  a148=(a148+a144);
  a013=(a013*a208);
  a148=(a148+a013);
  a013=(a044*a148);
  a046=(a046+a013);
  a046=(a142+a046);
  a013=(a039*a046);
  a202=(a202+a013);
  a013=(a050*a116);
  a144=(a052*a129);
  a013=(a013+a144);
  a144=(a053*a141);
  a013=(a013+a144);
  a144=(a054*a148);
  a013=(a013+a144);
  a155=(a155*a146);
  a040=(a040*a142);
  a042=(a042*a015);
  a040=(a040+a042);
  a043=(a043*a028);
  a040=(a040+a043);
  a044=(a044*a003);
  a040=(a040+a044);
  a040=(a108+a040);
  a151=(a151*a040);
  a155=(a155+a151);
  a041=(a041*a132);
  a155=(a155+a041);
  a041=(a055*a155);
  a013=(a013+a041);
  a013=(a142+a013);
  a041=(a049*a013);
  a202=(a202+a041);
  a041=(a060*a116);
  a151=(a062*a129);
  a041=(a041+a151);
  a151=(a063*a141);
  a041=(a041+a151);
  a151=(a064*a148);
  a041=(a041+a151);
  a151=(a065*a155);
  a041=(a041+a151);
  a162=(a162*a007);
  a050=(a050*a142);
  a052=(a052*a015);
  a050=(a050+a052);
  a053=(a053*a028);
  a050=(a050+a053);
  a054=(a054*a003);
  a050=(a050+a054);
  a055=(a055*a046);
  a050=(a050+a055);
  a050=(a108+a050);
  a158=(a158*a050);
  a162=(a162+a158);
  a051=(a051*a183);
  a162=(a162+a051);
  a051=(a066*a162);
  a041=(a041+a051);
  a041=(a142+a041);
  a051=(a059*a041);
  a202=(a202+a051);
  a051=(a071*a116);
  a158=(a073*a129);
  a051=(a051+a158);
  a158=(a074*a141);
  a051=(a051+a158);
  a158=(a075*a148);
  a051=(a051+a158);
  a158=(a076*a155);
  a051=(a051+a158);
  a158=(a077*a162);
  a051=(a051+a158);
  a169=(a169*a000);
  a060=(a060*a142);
  a062=(a062*a015);
  a060=(a060+a062);
  a063=(a063*a028);
  a060=(a060+a063);
  a064=(a064*a003);
  a060=(a060+a064);
  a065=(a065*a046);
  a060=(a060+a065);
  a066=(a066*a013);
  a060=(a060+a066);
  a060=(a108+a060);
  a165=(a165*a060);
  a169=(a169+a165);
  a061=(a061*a127);
  a169=(a169+a061);
  a061=(a078*a169);
  a051=(a051+a061);
  a051=(a142+a051);
  a061=(a070*a051);
  a202=(a202+a061);
  a061=(a083*a116);
  a165=(a085*a129);
  a061=(a061+a165);
  a165=(a086*a141);
  a061=(a061+a165);
  a165=(a087*a148);
  a061=(a061+a165);
  a165=(a088*a155);
  a061=(a061+a165);
  a165=(a089*a162);
  a061=(a061+a165);
  a165=(a090*a169);
  a061=(a061+a165);
  a176=(a176*a157);
  a071=(a071*a142);
  a073=(a073*a015);
  a071=(a071+a073);
  a074=(a074*a028);
  a071=(a071+a074);
  a075=(a075*a003);
  a071=(a071+a075);
  a076=(a076*a046);
  a071=(a071+a076);
  a077=(a077*a013);
  a071=(a071+a077);
  a078=(a078*a041);
  a071=(a071+a078);
  a071=(a108+a071);
  a172=(a172*a071);
  a176=(a176+a172);
  a072=(a072*a170);
  a176=(a176+a072);
  a072=(a091*a176);
  a061=(a061+a072);
  a061=(a142+a061);
  a072=(a082*a061);
  a202=(a202+a072);
  a072=(a096*a116);
  a129=(a098*a129);
  a072=(a072+a129);
  a141=(a099*a141);
  a072=(a072+a141);
  a141=(a100*a148);
  a072=(a072+a141);
  a141=(a101*a155);
  a072=(a072+a141);
  a141=(a102*a162);
  a072=(a072+a141);
  a141=(a103*a169);
  a072=(a072+a141);
  a141=(a104*a176);
  a072=(a072+a141);
  a181=(a181*a150);
  a083=(a083*a142);
  a085=(a085*a015);
  a083=(a083+a085);
  a086=(a086*a028);
  a083=(a083+a086);
  a087=(a087*a003);
  a083=(a083+a087);
  a088=(a088*a046);
  a083=(a083+a088);
  a089=(a089*a013);
  a083=(a083+a089);
  a090=(a090*a041);
  a083=(a083+a090);
  a091=(a091*a051);
  a083=(a083+a091);
  a083=(a108+a083);
  a118=(a118*a083);
  a181=(a181+a118);
  a084=(a084*a177);
  a181=(a181+a084);
  a084=(a105*a181);
  a072=(a072+a084);
  a072=(a142+a072);
  a072=(a095*a072);
  a202=(a202+a072);
  a202=(a108+a202);
  if (res[0]!=0) res[0][9]=a202;
  a163=(a001*a163);
  a189=(a005*a189);
  a163=(a163+a189);
  a193=(a039*a193);
  a163=(a163+a193);
  a197=(a049*a197);
  a163=(a163+a197);
  a201=(a059*a201);
  a163=(a163+a201);
  a205=(a070*a205);
  a163=(a163+a205);
  a187=(a082*a187);
  a163=(a163+a187);
  a187=(a096*a113);
  a166=(a098*a166);
  a187=(a187+a166);
  a111=(a099*a111);
  a187=(a187+a111);
  a208=(a100*a208);
  a187=(a187+a208);
  a132=(a101*a132);
  a187=(a187+a132);
  a183=(a102*a183);
  a187=(a187+a183);
  a127=(a103*a127);
  a187=(a187+a127);
  a170=(a104*a170);
  a187=(a187+a170);
  a177=(a105*a177);
  a187=(a187+a177);
  a210=(a210+a187);
  a011=(a011*a210);
  a011=(a095*a011);
  a163=(a163+a011);
  a113=(a113+a163);
  if (res[0]!=0) res[0][10]=a113;
  a001=(a001*a116);
  a005=(a005*a148);
  a001=(a001+a005);
  a039=(a039*a155);
  a001=(a001+a039);
  a049=(a049*a162);
  a001=(a001+a049);
  a059=(a059*a169);
  a001=(a001+a059);
  a070=(a070*a176);
  a001=(a001+a070);
  a082=(a082*a181);
  a001=(a001+a082);
  a115=(a115*a210);
  a096=(a096*a142);
  a098=(a098*a015);
  a096=(a096+a098);
  a099=(a099*a028);
  a096=(a096+a099);
  a100=(a100*a003);
  a096=(a096+a100);
  a101=(a101*a046);
  a096=(a096+a101);
  a102=(a102*a013);
  a096=(a096+a102);
  a103=(a103*a041);
  a096=(a096+a103);
  a104=(a104*a051);
  a096=(a096+a104);
  a105=(a105*a061);
  a096=(a096+a105);
  a108=(a108+a096);
  a004=(a004*a108);
  a115=(a115+a004);
  a097=(a097*a206);
  a115=(a115+a097);
  a095=(a095*a115);
  a001=(a001+a095);
  a142=(a142+a001);
  if (res[0]!=0) res[0][11]=a142;
  return 0;
}

/* variational_steps:(y[4x3],t,turns[2x12],h,p)->(y_end[4x3]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+212, w1, w2, *w3=w+224, w5, *w6=w+226, w7;
  const casadi_real **arg1=arg+5, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  w2 = arg[4] ? arg[4][0] : 0;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=(&w2);
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
  arg1[4]=(&w2);
  res1[0]=w6;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 12, res[0]);
  return 0;
}

/* landing_with_derivative:(y[4x3],z[2],T,p)->(J[3x3],R[3]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
  a0=arg[0]? arg[0][4] : 0;
  a1=arg[0]? arg[0][5] : 0;
  a2=(a0-a1);
  a3=1.;
  a2=(a2-a3);
  if (res[0]!=0) res[0][0]=a2;
  a2=arg[0]? arg[0][1] : 0;
  a4=cos(a2);
  a5=arg[0]? arg[0][6] : 0;
  a5=(a4*a5);
  a6=arg[0]? arg[0][2] : 0;
  a7=sin(a2);
  a7=(a6*a7);
  a8=(a7*a1);
  a5=(a5-a8);
  if (res[0]!=0) res[0][1]=a5;
  a5=-2.;
  a0=(a5*a0);
  a0=(a0+a1);
  if (res[0]!=0) res[0][2]=a0;
  a0=arg[0]? arg[0][8] : 0;
  a1=arg[0]? arg[0][9] : 0;
  a8=(a0-a1);
  if (res[0]!=0) res[0][3]=a8;
  a8=arg[0]? arg[0][10] : 0;
  a8=(a4*a8);
  a9=(a7*a1);
  a8=(a8-a9);
  a8=(a8-a3);
  if (res[0]!=0) res[0][4]=a8;
  a0=(a5*a0);
  a0=(a0+a1);
  if (res[0]!=0) res[0][5]=a0;
  a0=arg[0]? arg[0][3] : 0;
  a1=(a6-a0);
  if (res[0]!=0) res[0][6]=a1;
  a7=(a7*a0);
  a1=arg[3]? arg[3][0] : 0;
  a8=arg[0]? arg[0][0] : 0;
  a1=(a1-a8);
  a1=sin(a1);
  a1=(a4*a1);
  a7=(a7+a1);
  a7=(-a7);
  if (res[0]!=0) res[0][7]=a7;
  a5=(a5*a6);
  a5=(a5+a0);
  if (res[0]!=0) res[0][8]=a5;
  a5=(a8-a2);
  a0=arg[1]? arg[1][0] : 0;
  a5=(a5-a0);
  if (res[1]!=0) res[1][0]=a5;
  a4=(a4*a6);
  a6=arg[1]? arg[1][1] : 0;
  a4=(a4-a6);
  if (res[1]!=0) res[1][1]=a4;
  a8=(2.*a8);
  a2=(a2-a8);
  if (res[1]!=0) res[1][2]=a2;
  return 0;
}

/* simplest_walker_jacobian_12:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 12 */
  w08 = 12.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@11, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* scaled_jacobian_12:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+344, *w1=w+353, w2, *w3=w+356, *w4=w+365;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = simplest_walker_jacobian_12(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_12:(u0[3],p)->(u[3]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f3(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_12:(i0[3],i1)->(o0[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+411, w1, *w2=w+414;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* plain_step:(y[4],phase[2],turns[2x12],h,p)->(y_end[4]) */
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
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116;
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
  a007=arg[4]? arg[4][0] : 0;
  a008=sin(a007);
  a009=cos(a000);
  a010=(a008*a009);
  a011=cos(a007);
  a012=sin(a000);
  a013=(a011*a012);
  a010=(a010-a013);
  a013=(a006*a010);
  a014=1.7082860872947386e-01;
  a014=(a014*a002);
  a015=2.9587585476806851e-02;
  a015=(a015*a002);
  a016=(a015*a003);
  a017=8.8762756430420545e-02;
  a017=(a017*a002);
  a018=1.9725056984537900e-02;
  a018=(a018*a002);
  a019=(a018*a010);
  a020=5.9175170953613701e-02;
  a020=(a020*a002);
  a021=5.2600151958767730e-02;
  a021=(a021*a002);
  a022=(a021*a003);
  a022=(a000+a022);
  a023=cos(a022);
  a024=(a008*a023);
  a022=sin(a022);
  a025=(a011*a022);
  a024=(a024-a025);
  a025=(a020*a024);
  a019=(a019+a025);
  a019=(a003-a019);
  a025=(a017*a019);
  a016=(a016+a025);
  a016=(a000+a016);
  a025=cos(a016);
  a026=(a008*a025);
  a016=sin(a016);
  a027=(a011*a016);
  a026=(a026-a027);
  a027=(a014*a026);
  a013=(a013+a027);
  a027=1.2546768756682242e-01;
  a027=(a027*a002);
  a028=2.4136513415926669e-01;
  a028=(a028*a002);
  a029=(a028*a003);
  a030=-8.8454947932828609e-01;
  a030=(a030*a002);
  a031=(a030*a019);
  a029=(a029+a031);
  a031=9.2483400326179199e-01;
  a031=(a031*a002);
  a032=(a015*a010);
  a033=(a018*a003);
  a034=(a021*a010);
  a034=(a003-a034);
  a035=(a020*a034);
  a033=(a033+a035);
  a033=(a000+a033);
  a035=cos(a033);
  a036=(a008*a035);
  a033=sin(a033);
  a037=(a011*a033);
  a036=(a036-a037);
  a037=(a017*a036);
  a032=(a032+a037);
  a032=(a003-a032);
  a037=(a031*a032);
  a029=(a029+a037);
  a029=(a000+a029);
  a037=cos(a029);
  a038=(a008*a037);
  a029=sin(a029);
  a039=(a011*a029);
  a038=(a038-a039);
  a039=(a027*a038);
  a013=(a013+a039);
  a013=(a003-a013);
  a039=(a005*a013);
  a004=(a004+a039);
  a039=1.8915178993145003e+00;
  a039=(a039*a002);
  a040=3.7109375000000000e-02;
  a040=(a040*a002);
  a041=(a040*a010);
  a042=1.7025221101954405e-01;
  a042=(a042*a002);
  a043=(a042*a026);
  a041=(a041+a043);
  a043=6.0216538980455959e-02;
  a043=(a043*a002);
  a044=(a043*a038);
  a041=(a041+a044);
  a044=-1.7578125000000000e-02;
  a044=(a044*a002);
  a045=(a006*a003);
  a046=(a014*a032);
  a045=(a045+a046);
  a046=(a028*a010);
  a047=(a030*a036);
  a046=(a046+a047);
  a047=(a031*a026);
  a046=(a046+a047);
  a046=(a003-a046);
  a047=(a027*a046);
  a045=(a045+a047);
  a045=(a000+a045);
  a047=cos(a045);
  a048=(a008*a047);
  a045=sin(a045);
  a049=(a011*a045);
  a048=(a048-a049);
  a049=(a044*a048);
  a041=(a041+a049);
  a041=(a003-a041);
  a049=(a039*a041);
  a004=(a004+a049);
  a049=-5.8012039600105849e+00;
  a049=(a049*a002);
  a050=3.7092000118504789e-02;
  a050=(a050*a002);
  a051=(a050*a010);
  a052=1.7038392571223998e-01;
  a052=(a052*a002);
  a053=(a052*a026);
  a051=(a051+a053);
  a053=1.0726203044637328e-01;
  a053=(a053*a002);
  a054=(a053*a038);
  a051=(a051+a054);
  a054=-1.5319437748624402e-02;
  a054=(a054*a002);
  a055=(a054*a048);
  a051=(a051+a055);
  a055=8.2737891638140233e-03;
  a055=(a055*a002);
  a056=(a040*a003);
  a057=(a042*a032);
  a056=(a056+a057);
  a057=(a043*a046);
  a056=(a056+a057);
  a057=(a044*a013);
  a056=(a056+a057);
  a056=(a000+a056);
  a057=cos(a056);
  a058=(a008*a057);
  a056=sin(a056);
  a059=(a011*a056);
  a058=(a058-a059);
  a059=(a055*a058);
  a051=(a051+a059);
  a051=(a003-a051);
  a059=(a049*a051);
  a004=(a004+a059);
  a059=3.1116436695781990e-01;
  a059=(a059*a002);
  a060=6.2411095871607569e-01;
  a060=(a060*a002);
  a061=(a060*a010);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a063=(a062*a026);
  a061=(a061+a063);
  a063=-8.6821934684172597e-01;
  a063=(a063*a002);
  a064=(a063*a038);
  a061=(a061+a064);
  a064=2.7592099699446710e+01;
  a064=(a064*a002);
  a065=(a064*a048);
  a061=(a061+a065);
  a065=2.0154067550477894e+01;
  a065=(a065*a002);
  a066=(a065*a058);
  a061=(a061+a066);
  a066=-4.3489884181069961e+01;
  a066=(a066*a002);
  a067=(a050*a003);
  a068=(a052*a032);
  a067=(a067+a068);
  a068=(a053*a046);
  a067=(a067+a068);
  a068=(a054*a013);
  a067=(a067+a068);
  a068=(a055*a041);
  a067=(a067+a068);
  a067=(a000+a067);
  a068=cos(a067);
  a069=(a008*a068);
  a067=sin(a067);
  a070=(a011*a067);
  a069=(a069-a070);
  a070=(a066*a069);
  a061=(a061+a070);
  a061=(a003-a061);
  a070=(a059*a061);
  a004=(a004+a070);
  a070=-1.5216094966251609e-01;
  a070=(a070*a002);
  a071=4.7766253643826434e-01;
  a071=(a071*a002);
  a072=(a071*a010);
  a073=-2.4881146199716677e+00;
  a073=(a073*a002);
  a074=(a073*a026);
  a072=(a072+a074);
  a074=-5.9029082683684297e-01;
  a074=(a074*a002);
  a075=(a074*a038);
  a072=(a072+a075);
  a075=2.1230051448181193e+01;
  a075=(a075*a002);
  a076=(a075*a048);
  a072=(a072+a076);
  a076=1.5279233632882423e+01;
  a076=(a076*a002);
  a077=(a076*a058);
  a072=(a072+a077);
  a077=-3.3288210968984863e+01;
  a077=(a077*a002);
  a078=(a077*a069);
  a072=(a072+a078);
  a078=-2.0331201708508627e-02;
  a078=(a078*a002);
  a079=(a060*a003);
  a080=(a062*a032);
  a079=(a079+a080);
  a080=(a063*a046);
  a079=(a079+a080);
  a080=(a064*a013);
  a079=(a079+a080);
  a080=(a065*a041);
  a079=(a079+a080);
  a080=(a066*a051);
  a079=(a079+a080);
  a079=(a000+a079);
  a080=cos(a079);
  a081=(a008*a080);
  a079=sin(a079);
  a082=(a011*a079);
  a081=(a081-a082);
  a082=(a078*a081);
  a072=(a072+a082);
  a072=(a003-a072);
  a082=(a070*a072);
  a004=(a004+a082);
  a082=2.0136540080403034e-01;
  a082=(a082*a002);
  a083=-9.3714243008598730e-01;
  a083=(a083*a002);
  a084=(a083*a010);
  a085=5.1863724288440638e+00;
  a085=(a085*a002);
  a086=(a085*a026);
  a084=(a084+a086);
  a086=1.0914373489967295e+00;
  a086=(a086*a002);
  a087=(a086*a038);
  a084=(a084+a087);
  a087=-8.1497870107469268e+00;
  a087=(a087*a002);
  a088=(a087*a048);
  a084=(a084+a088);
  a088=-1.8520065659996959e+01;
  a088=(a088*a002);
  a089=(a088*a058);
  a084=(a084+a089);
  a089=2.2739487099350505e+01;
  a089=(a089*a002);
  a090=(a089*a069);
  a084=(a084+a090);
  a090=2.4936055526796523e+00;
  a090=(a090*a002);
  a091=(a090*a081);
  a084=(a084+a091);
  a091=-3.0467644718982196e+00;
  a091=(a091*a002);
  a092=(a071*a003);
  a093=(a073*a032);
  a092=(a092+a093);
  a093=(a074*a046);
  a092=(a092+a093);
  a093=(a075*a013);
  a092=(a092+a093);
  a093=(a076*a041);
  a092=(a092+a093);
  a093=(a077*a051);
  a092=(a092+a093);
  a093=(a078*a061);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=cos(a092);
  a094=(a008*a093);
  a092=sin(a092);
  a095=(a011*a092);
  a094=(a094-a095);
  a095=(a091*a094);
  a084=(a084+a095);
  a084=(a003-a084);
  a095=(a082*a084);
  a004=(a004+a095);
  a095=4.4710615727772587e-02;
  a095=(a095*a002);
  a096=2.2733101475165380e+00;
  a096=(a096*a002);
  a097=(a096*a010);
  a098=-1.0534495466737249e+01;
  a098=(a098*a002);
  a099=(a098*a026);
  a097=(a097+a099);
  a099=-2.0008720582248625e+00;
  a099=(a099*a002);
  a100=(a099*a038);
  a097=(a097+a100);
  a100=-1.7958931863118799e+01;
  a100=(a100*a002);
  a101=(a100*a048);
  a097=(a097+a101);
  a101=2.7948884529419960e+01;
  a101=(a101*a002);
  a102=(a101*a058);
  a097=(a097+a102);
  a102=-2.8589982771350235e+00;
  a102=(a102*a002);
  a103=(a102*a069);
  a097=(a097+a103);
  a103=-8.8728569335306293e+00;
  a103=(a103*a002);
  a104=(a103*a081);
  a097=(a097+a104);
  a104=1.2360567175794303e+01;
  a104=(a104*a002);
  a105=(a104*a094);
  a097=(a097+a105);
  a105=6.4339274601576357e-01;
  a105=(a105*a002);
  a002=(a083*a003);
  a106=(a085*a032);
  a002=(a002+a106);
  a106=(a086*a046);
  a002=(a002+a106);
  a106=(a087*a013);
  a002=(a002+a106);
  a106=(a088*a041);
  a002=(a002+a106);
  a106=(a089*a051);
  a002=(a002+a106);
  a106=(a090*a061);
  a002=(a002+a106);
  a106=(a091*a072);
  a002=(a002+a106);
  a002=(a000+a002);
  a106=cos(a002);
  a107=(a008*a106);
  a002=sin(a002);
  a108=(a011*a002);
  a107=(a107-a108);
  a108=(a105*a107);
  a097=(a097+a108);
  a097=(a003-a097);
  a108=(a095*a097);
  a004=(a004+a108);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=arg[0]? arg[0][1] : 0;
  a108=arg[0]? arg[0][3] : 0;
  a109=(a001*a108);
  a110=casadi_sq(a003);
  a111=sin(a004);
  a110=(a110*a111);
  a111=(a004+a007);
  a112=sin(a111);
  a112=(a112*a009);
  a111=cos(a111);
  a111=(a111*a012);
  a112=(a112-a111);
  a110=(a110-a112);
  a112=cos(a004);
  a111=1.;
  a112=(a112-a111);
  a112=(a112*a010);
  a110=(a110+a112);
  a112=(a006*a110);
  a012=casadi_sq(a032);
  a009=(a015*a108);
  a113=(a018*a110);
  a034=casadi_sq(a034);
  a114=(a021*a108);
  a114=(a004+a114);
  a115=sin(a114);
  a034=(a034*a115);
  a115=(a114+a007);
  a116=sin(a115);
  a116=(a116*a023);
  a115=cos(a115);
  a115=(a115*a022);
  a116=(a116-a115);
  a034=(a034-a116);
  a114=cos(a114);
  a114=(a114-a111);
  a114=(a114*a024);
  a034=(a034+a114);
  a034=(a020*a034);
  a113=(a113+a034);
  a113=(a108+a113);
  a034=(a017*a113);
  a009=(a009+a034);
  a009=(a004+a009);
  a034=sin(a009);
  a012=(a012*a034);
  a034=(a009+a007);
  a114=sin(a034);
  a114=(a114*a025);
  a034=cos(a034);
  a034=(a034*a016);
  a114=(a114-a034);
  a012=(a012-a114);
  a009=cos(a009);
  a009=(a009-a111);
  a009=(a009*a026);
  a012=(a012+a009);
  a009=(a014*a012);
  a112=(a112+a009);
  a009=casadi_sq(a046);
  a026=(a028*a108);
  a113=(a030*a113);
  a026=(a026+a113);
  a015=(a015*a110);
  a019=casadi_sq(a019);
  a018=(a018*a108);
  a021=(a021*a110);
  a021=(a108+a021);
  a020=(a020*a021);
  a018=(a018+a020);
  a018=(a004+a018);
  a020=sin(a018);
  a019=(a019*a020);
  a020=(a018+a007);
  a021=sin(a020);
  a021=(a021*a035);
  a020=cos(a020);
  a020=(a020*a033);
  a021=(a021-a020);
  a019=(a019-a021);
  a018=cos(a018);
  a018=(a018-a111);
  a018=(a018*a036);
  a019=(a019+a018);
  a017=(a017*a019);
  a015=(a015+a017);
  a015=(a108+a015);
  a017=(a031*a015);
  a026=(a026+a017);
  a026=(a004+a026);
  a017=sin(a026);
  a009=(a009*a017);
  a017=(a026+a007);
  a018=sin(a017);
  a018=(a018*a037);
  a017=cos(a017);
  a017=(a017*a029);
  a018=(a018-a017);
  a009=(a009-a018);
  a026=cos(a026);
  a026=(a026-a111);
  a026=(a026*a038);
  a009=(a009+a026);
  a026=(a027*a009);
  a112=(a112+a026);
  a112=(a108+a112);
  a026=(a005*a112);
  a109=(a109+a026);
  a026=(a040*a110);
  a038=(a042*a012);
  a026=(a026+a038);
  a038=(a043*a009);
  a026=(a026+a038);
  a038=casadi_sq(a013);
  a006=(a006*a108);
  a014=(a014*a015);
  a006=(a006+a014);
  a028=(a028*a110);
  a030=(a030*a019);
  a028=(a028+a030);
  a031=(a031*a012);
  a028=(a028+a031);
  a028=(a108+a028);
  a027=(a027*a028);
  a006=(a006+a027);
  a006=(a004+a006);
  a027=sin(a006);
  a038=(a038*a027);
  a027=(a006+a007);
  a031=sin(a027);
  a031=(a031*a047);
  a027=cos(a027);
  a027=(a027*a045);
  a031=(a031-a027);
  a038=(a038-a031);
  a006=cos(a006);
  a006=(a006-a111);
  a006=(a006*a048);
  a038=(a038+a006);
  a006=(a044*a038);
  a026=(a026+a006);
  a026=(a108+a026);
  a006=(a039*a026);
  a109=(a109+a006);
  a006=(a050*a110);
  a031=(a052*a012);
  a006=(a006+a031);
  a031=(a053*a009);
  a006=(a006+a031);
  a031=(a054*a038);
  a006=(a006+a031);
  a031=casadi_sq(a041);
  a040=(a040*a108);
  a042=(a042*a015);
  a040=(a040+a042);
  a043=(a043*a028);
  a040=(a040+a043);
  a044=(a044*a112);
  a040=(a040+a044);
  a040=(a004+a040);
  a044=sin(a040);
  a031=(a031*a044);
  a044=(a040+a007);
  a043=sin(a044);
  a043=(a043*a057);
  a044=cos(a044);
  a044=(a044*a056);
  a043=(a043-a044);
  a031=(a031-a043);
  a040=cos(a040);
  a040=(a040-a111);
  a040=(a040*a058);
  a031=(a031+a040);
  a040=(a055*a031);
  a006=(a006+a040);
  a006=(a108+a006);
  a040=(a049*a006);
  a109=(a109+a040);
  a040=(a060*a110);
  a043=(a062*a012);
  a040=(a040+a043);
  a043=(a063*a009);
  a040=(a040+a043);
  a043=(a064*a038);
  a040=(a040+a043);
  a043=(a065*a031);
  a040=(a040+a043);
  a043=casadi_sq(a051);
  a050=(a050*a108);
  a052=(a052*a015);
  a050=(a050+a052);
  a053=(a053*a028);
  a050=(a050+a053);
  a054=(a054*a112);
  a050=(a050+a054);
  a055=(a055*a026);
  a050=(a050+a055);
  a050=(a004+a050);
  a055=sin(a050);
  a043=(a043*a055);
  a055=(a050+a007);
  a054=sin(a055);
  a054=(a054*a068);
  a055=cos(a055);
  a055=(a055*a067);
  a054=(a054-a055);
  a043=(a043-a054);
  a050=cos(a050);
  a050=(a050-a111);
  a050=(a050*a069);
  a043=(a043+a050);
  a050=(a066*a043);
  a040=(a040+a050);
  a040=(a108+a040);
  a050=(a059*a040);
  a109=(a109+a050);
  a050=(a071*a110);
  a054=(a073*a012);
  a050=(a050+a054);
  a054=(a074*a009);
  a050=(a050+a054);
  a054=(a075*a038);
  a050=(a050+a054);
  a054=(a076*a031);
  a050=(a050+a054);
  a054=(a077*a043);
  a050=(a050+a054);
  a054=casadi_sq(a061);
  a060=(a060*a108);
  a062=(a062*a015);
  a060=(a060+a062);
  a063=(a063*a028);
  a060=(a060+a063);
  a064=(a064*a112);
  a060=(a060+a064);
  a065=(a065*a026);
  a060=(a060+a065);
  a066=(a066*a006);
  a060=(a060+a066);
  a060=(a004+a060);
  a066=sin(a060);
  a054=(a054*a066);
  a066=(a060+a007);
  a065=sin(a066);
  a065=(a065*a080);
  a066=cos(a066);
  a066=(a066*a079);
  a065=(a065-a066);
  a054=(a054-a065);
  a060=cos(a060);
  a060=(a060-a111);
  a060=(a060*a081);
  a054=(a054+a060);
  a060=(a078*a054);
  a050=(a050+a060);
  a050=(a108+a050);
  a060=(a070*a050);
  a109=(a109+a060);
  a060=(a083*a110);
  a065=(a085*a012);
  a060=(a060+a065);
  a065=(a086*a009);
  a060=(a060+a065);
  a065=(a087*a038);
  a060=(a060+a065);
  a065=(a088*a031);
  a060=(a060+a065);
  a065=(a089*a043);
  a060=(a060+a065);
  a065=(a090*a054);
  a060=(a060+a065);
  a065=casadi_sq(a072);
  a071=(a071*a108);
  a073=(a073*a015);
  a071=(a071+a073);
  a074=(a074*a028);
  a071=(a071+a074);
  a075=(a075*a112);
  a071=(a071+a075);
  a076=(a076*a026);
  a071=(a071+a076);
  a077=(a077*a006);
  a071=(a071+a077);
  a078=(a078*a040);
  a071=(a071+a078);
  a071=(a004+a071);
  a078=sin(a071);
  a065=(a065*a078);
  a078=(a071+a007);
  a077=sin(a078);
  a077=(a077*a093);
  a078=cos(a078);
  a078=(a078*a092);
  a077=(a077-a078);
  a065=(a065-a077);
  a071=cos(a071);
  a071=(a071-a111);
  a071=(a071*a094);
  a065=(a065+a071);
  a071=(a091*a065);
  a060=(a060+a071);
  a060=(a108+a060);
  a071=(a082*a060);
  a109=(a109+a071);
  a071=(a096*a110);
  a012=(a098*a012);
  a071=(a071+a012);
  a009=(a099*a009);
  a071=(a071+a009);
  a009=(a100*a038);
  a071=(a071+a009);
  a009=(a101*a031);
  a071=(a071+a009);
  a009=(a102*a043);
  a071=(a071+a009);
  a009=(a103*a054);
  a071=(a071+a009);
  a009=(a104*a065);
  a071=(a071+a009);
  a009=casadi_sq(a084);
  a083=(a083*a108);
  a085=(a085*a015);
  a083=(a083+a085);
  a086=(a086*a028);
  a083=(a083+a086);
  a087=(a087*a112);
  a083=(a083+a087);
  a088=(a088*a026);
  a083=(a083+a088);
  a089=(a089*a006);
  a083=(a083+a089);
  a090=(a090*a040);
  a083=(a083+a090);
  a091=(a091*a050);
  a083=(a083+a091);
  a083=(a004+a083);
  a091=sin(a083);
  a009=(a009*a091);
  a091=(a083+a007);
  a090=sin(a091);
  a090=(a090*a106);
  a091=cos(a091);
  a091=(a091*a002);
  a090=(a090-a091);
  a009=(a009-a090);
  a083=cos(a083);
  a083=(a083-a111);
  a083=(a083*a107);
  a009=(a009+a083);
  a083=(a105*a009);
  a071=(a071+a083);
  a071=(a108+a071);
  a071=(a095*a071);
  a109=(a109+a071);
  a109=(a004+a109);
  if (res[0]!=0) res[0][1]=a109;
  a010=(a001*a010);
  a048=(a005*a048);
  a010=(a010+a048);
  a058=(a039*a058);
  a010=(a010+a058);
  a069=(a049*a069);
  a010=(a010+a069);
  a081=(a059*a081);
  a010=(a010+a081);
  a094=(a070*a094);
  a010=(a010+a094);
  a107=(a082*a107);
  a010=(a010+a107);
  a107=(a096*a003);
  a032=(a098*a032);
  a107=(a107+a032);
  a046=(a099*a046);
  a107=(a107+a046);
  a013=(a100*a013);
  a107=(a107+a013);
  a041=(a101*a041);
  a107=(a107+a041);
  a051=(a102*a051);
  a107=(a107+a051);
  a061=(a103*a061);
  a107=(a107+a061);
  a072=(a104*a072);
  a107=(a107+a072);
  a084=(a105*a084);
  a107=(a107+a084);
  a000=(a000+a107);
  a107=cos(a000);
  a008=(a008*a107);
  a000=sin(a000);
  a011=(a011*a000);
  a008=(a008-a011);
  a011=(a095*a008);
  a010=(a010+a011);
  a003=(a003-a010);
  if (res[0]!=0) res[0][2]=a003;
  a001=(a001*a110);
  a005=(a005*a038);
  a001=(a001+a005);
  a039=(a039*a031);
  a001=(a001+a039);
  a049=(a049*a043);
  a001=(a001+a049);
  a059=(a059*a054);
  a001=(a001+a059);
  a070=(a070*a065);
  a001=(a001+a070);
  a082=(a082*a009);
  a001=(a001+a082);
  a097=casadi_sq(a097);
  a096=(a096*a108);
  a098=(a098*a015);
  a096=(a096+a098);
  a099=(a099*a028);
  a096=(a096+a099);
  a100=(a100*a112);
  a096=(a096+a100);
  a101=(a101*a026);
  a096=(a096+a101);
  a102=(a102*a006);
  a096=(a096+a102);
  a103=(a103*a040);
  a096=(a096+a103);
  a104=(a104*a050);
  a096=(a096+a104);
  a105=(a105*a060);
  a096=(a096+a105);
  a004=(a004+a096);
  a096=sin(a004);
  a097=(a097*a096);
  a007=(a004+a007);
  a096=sin(a007);
  a096=(a096*a107);
  a007=cos(a007);
  a007=(a007*a000);
  a096=(a096-a007);
  a097=(a097-a096);
  a004=cos(a004);
  a004=(a004-a111);
  a004=(a004*a008);
  a097=(a097+a004);
  a095=(a095*a097);
  a001=(a001+a095);
  a108=(a108+a001);
  if (res[0]!=0) res[0][3]=a108;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p)->(y_end[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+117, w1, w2, *w3=w+121, w5, *w6=w+123, w7;
  const casadi_real **arg1=arg+5, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  w2 = arg[4] ? arg[4][0] : 0;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=(&w2);
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
  arg1[4]=(&w2);
  res1[0]=w6;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  res1[0]=w0;
  if (casadi_f13(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* landing:(y[4],z[2],p)->(R[3]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3;
  a0=arg[0]? arg[0][0] : 0;
  a1=arg[0]? arg[0][1] : 0;
  a2=(a0-a1);
  a3=arg[1]? arg[1][0] : 0;
  a2=(a2-a3);
  if (res[0]!=0) res[0][0]=a2;
  a2=cos(a1);
  a3=arg[0]? arg[0][2] : 0;
  a2=(a2*a3);
  a3=arg[1]? arg[1][1] : 0;
  a2=(a2-a3);
  if (res[0]!=0) res[0][1]=a2;
  a0=(2.*a0);
  a1=(a1-a0);
  if (res[0]!=0) res[0][2]=a1;
  return 0;
}

/* simplest_walker_residual_12:(u[3],p)->(R[3]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 12 */
  w6 = 12.;
  /* #7: @5 = (@5/@6) */
  w5 /= w6;
  /* #8: @7 = turns(@5, @2) */
  arg1[0]=(&w5);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @5, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @0 = landing(@8, @1, @2) */
  arg1[0]=w8;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* simplest_walker_search_12:(u0[3],p)->(u[3],R[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+418, w1, *w2=w+421;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: @0 = simplest_walker_residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 424;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 424*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_24:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 24 */
  w08 = 24.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+344, *w1=w+353, w2, *w3=w+356, *w4=w+365;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = simplest_walker_jacobian_24(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_24:(u0[3],p)->(u[3]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f18(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_24:(i0[3],i1)->(o0[3]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+411, w1, *w2=w+414;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f17(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_residual_24:(u[3],p)->(R[3]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 24 */
  w6 = 24.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* simplest_walker_search_24:(u0[3],p)->(u[3],R[3]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+418, w1, *w2=w+421;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: @0 = simplest_walker_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 424;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 424*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_48:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 48 */
  w08 = 48.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+344, *w1=w+353, w2, *w3=w+356, *w4=w+365;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = simplest_walker_jacobian_48(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_48:(u0[3],p)->(u[3]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-12;
  m.abstol_step = 0.0001;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<10; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f24(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_48:(i0[3],i1)->(o0[3]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+411, w1, *w2=w+414;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f23(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_residual_48:(u[3],p)->(R[3]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 48 */
  w6 = 48.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* simplest_walker_search_48:(u0[3],p)->(u[3],R[3]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+418, w1, *w2=w+421;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: @0 = simplest_walker_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 424;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 424*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_24(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f31(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_24:(u0[3],p)->(u[3]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f30(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_24:(i0[3],i1)->(o0[3]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f29(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_limit_cycle_24:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_36:(u[3],p)->(R[3]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 36 */
  w6 = 36.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @0 = landing(@8, @1, @2) */
  arg1[0]=w8;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_36:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f37(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_36:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_36(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_36:(u0[3],p)->(u[3]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f35(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_36:(i0[3],i1)->(o0[3]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_36:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 36 */
  w08 = 36.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w10;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@11, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_36:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_36(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_48(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f43(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_48:(u0[3],p)->(u[3]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f42(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_48:(i0[3],i1)->(o0[3]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_limit_cycle_48:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_72:(u[3],p)->(R[3]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 72 */
  w6 = 72.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_72:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f49(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_72:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_72(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f48(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_72:(u0[3],p)->(u[3]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f47(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_72:(i0[3],i1)->(o0[3]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_72:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 72 */
  w08 = 72.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_72:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_72(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_96:(u[3],p)->(R[3]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 96 */
  w6 = 96.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_96:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_96:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_96(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f55(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_96:(u0[3],p)->(u[3]) */
static int casadi_f53(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f54(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_96:(i0[3],i1)->(o0[3]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_96:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 96 */
  w08 = 96.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_96:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f52(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_144:(u[3],p)->(R[3]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 144 */
  w6 = 144.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0833333 */
  w4 = 8.3333333333333329e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.416667 */
  w4 = 4.1666666666666669e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.583333 */
  w4 = 5.8333333333333337e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.916667 */
  w4 = 9.1666666666666663e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_144:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_144:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_144(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f62(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_144:(u0[3],p)->(u[3]) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f61(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_144:(i0[3],i1)->(o0[3]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_144:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 144 */
  w08 = 144.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_144:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f59(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_144(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f58(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_192:(u[3],p)->(R[3]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 192 */
  w6 = 192.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0625 */
  w4 = 6.2500000000000000e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.1875 */
  w4 = 1.8750000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.3125 */
  w4 = 3.1250000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.4375 */
  w4 = 4.3750000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.5625 */
  w4 = 5.6250000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.6875 */
  w4 = 6.8750000000000000e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.8125 */
  w4 = 8.1250000000000000e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.9375 */
  w4 = 9.3750000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_192:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f70(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_192:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_192(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f69(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_192:(u0[3],p)->(u[3]) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f68(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_192:(i0[3],i1)->(o0[3]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f67(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_192:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 192 */
  w08 = 192.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_192:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f65(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_288:(u[3],p)->(R[3]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 288 */
  w6 = 288.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0416667 */
  w4 = 4.1666666666666664e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.0833333 */
  w4 = 8.3333333333333329e-02;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.208333 */
  w4 = 2.0833333333333334e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.291667 */
  w4 = 2.9166666666666669e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.416667 */
  w4 = 4.1666666666666669e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.458333 */
  w4 = 4.5833333333333331e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.541667 */
  w4 = 5.4166666666666663e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.583333 */
  w4 = 5.8333333333333337e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #56: @4 = (@4*@5) */
  w4 *= w5;
  /* #57: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #58: @4 = 0.708333 */
  w4 = 7.0833333333333337e-01;
  /* #59: @4 = (@4*@5) */
  w4 *= w5;
  /* #60: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #61: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #62: @4 = (@4*@5) */
  w4 *= w5;
  /* #63: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #64: @4 = 0.791667 */
  w4 = 7.9166666666666663e-01;
  /* #65: @4 = (@4*@5) */
  w4 *= w5;
  /* #66: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #67: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #68: @4 = (@4*@5) */
  w4 *= w5;
  /* #69: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #70: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #71: @4 = (@4*@5) */
  w4 *= w5;
  /* #72: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #73: @4 = 0.916667 */
  w4 = 9.1666666666666663e-01;
  /* #74: @4 = (@4*@5) */
  w4 *= w5;
  /* #75: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #76: @4 = 0.958333 */
  w4 = 9.5833333333333337e-01;
  /* #77: @4 = (@4*@5) */
  w4 *= w5;
  /* #78: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #79: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_288:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_288:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_288(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f76(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_288:(u0[3],p)->(u[3]) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f75(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_288:(i0[3],i1)->(o0[3]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f74(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_288:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 288 */
  w08 = 288.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_288:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f73(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_288(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_residual_384:(u[3],p)->(R[3]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+155, *w1=w+158, w2, *w3=w+160, w4, w5, w6, *w7=w+164, *w8=w+188;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w4 = 0.;
  /* #5: @5 = @0[2] */
  for (rr=(&w5), cs=w0+2; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #6: @6 = 384 */
  w6 = 384.;
  /* #7: @6 = (@5/@6) */
  w6  = (w5/w6);
  /* #8: @7 = turns(@6, @2) */
  arg1[0]=(&w6);
  arg1[1]=(&w2);
  res1[0]=w7;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.03125 */
  w4 = 3.1250000000000000e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.0625 */
  w4 = 6.2500000000000000e-02;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.09375 */
  w4 = 9.3750000000000000e-02;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.15625 */
  w4 = 1.5625000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.1875 */
  w4 = 1.8750000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.21875 */
  w4 = 2.1875000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.28125 */
  w4 = 2.8125000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.3125 */
  w4 = 3.1250000000000000e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.34375 */
  w4 = 3.4375000000000000e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.40625 */
  w4 = 4.0625000000000000e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.4375 */
  w4 = 4.3750000000000000e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.46875 */
  w4 = 4.6875000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #55: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #56: @4 = (@4*@5) */
  w4 *= w5;
  /* #57: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #58: @4 = 0.53125 */
  w4 = 5.3125000000000000e-01;
  /* #59: @4 = (@4*@5) */
  w4 *= w5;
  /* #60: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #61: @4 = 0.5625 */
  w4 = 5.6250000000000000e-01;
  /* #62: @4 = (@4*@5) */
  w4 *= w5;
  /* #63: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #64: @4 = 0.59375 */
  w4 = 5.9375000000000000e-01;
  /* #65: @4 = (@4*@5) */
  w4 *= w5;
  /* #66: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #67: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #68: @4 = (@4*@5) */
  w4 *= w5;
  /* #69: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #70: @4 = 0.65625 */
  w4 = 6.5625000000000000e-01;
  /* #71: @4 = (@4*@5) */
  w4 *= w5;
  /* #72: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #73: @4 = 0.6875 */
  w4 = 6.8750000000000000e-01;
  /* #74: @4 = (@4*@5) */
  w4 *= w5;
  /* #75: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #76: @4 = 0.71875 */
  w4 = 7.1875000000000000e-01;
  /* #77: @4 = (@4*@5) */
  w4 *= w5;
  /* #78: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #79: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #80: @4 = (@4*@5) */
  w4 *= w5;
  /* #81: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #82: @4 = 0.78125 */
  w4 = 7.8125000000000000e-01;
  /* #83: @4 = (@4*@5) */
  w4 *= w5;
  /* #84: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #85: @4 = 0.8125 */
  w4 = 8.1250000000000000e-01;
  /* #86: @4 = (@4*@5) */
  w4 *= w5;
  /* #87: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #88: @4 = 0.84375 */
  w4 = 8.4375000000000000e-01;
  /* #89: @4 = (@4*@5) */
  w4 *= w5;
  /* #90: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #91: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #92: @4 = (@4*@5) */
  w4 *= w5;
  /* #93: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #94: @4 = 0.90625 */
  w4 = 9.0625000000000000e-01;
  /* #95: @4 = (@4*@5) */
  w4 *= w5;
  /* #96: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #97: @4 = 0.9375 */
  w4 = 9.3750000000000000e-01;
  /* #98: @4 = (@4*@5) */
  w4 *= w5;
  /* #99: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w8;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #100: @4 = 0.96875 */
  w4 = 9.6875000000000000e-01;
  /* #101: @4 = (@4*@5) */
  w4 *= w5;
  /* #102: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=(&w2);
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #103: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=(&w2);
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_384:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+344, w1, *w2=w+347, *w3=w+356;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: {@2, NULL} = simplest_walker_jacobian_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = simplest_walker_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w3;
  if (casadi_f84(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* scaled_jacobian_384:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+360, *w1=w+369, w2, *w3=w+372, *w4=w+381;
  const casadi_real **arg1=arg+2, *cr, *cs, *wr0;
  /* #0: @0 = 
  [[1, 1, 1], 
   [1, 1, 1], 
   [0.5, 0.5, 0.5]] */
  wr0 = casadi_c0;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w1);
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = coarse_jacobian_384(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f83(arg1, res1, iw, w, 0)) return 1;
  /* #4: @0 = (@0*@3) */
  for (i=0, rr=w0, cr=wr0, cs=w3; i<9; ++i) (*rr++)  = ((*cr++)*(*cs++));
  /* #5: output[0][0] = @0 */
  casadi_copy(w0, 9, res[0]);
  /* #6: @1 = [1, 1, 2] */
  casadi_copy(casadi_c1, 3, w1);
  /* #7: @4 = (@4/@1) */
  for (i=0, rr=w4, cs=w1; i<3; ++i) (*rr++) /= (*cs++);
  /* #8: output[1][0] = @4 */
  casadi_copy(w4, 3, res[1]);
  return 0;
}

/* newton_384:(u0[3],p)->(u[3]) */
static int casadi_f81(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 3;
  m.abstol = 1e-14;
  m.abstol_step = 1e-09;
  m.x = w;
  m.g = w+3;
  m.jac_g_x = w+6;
  m.sp_a = casadi_s0;
  m.sp_v = casadi_s1;
  m.sp_r = casadi_s2;
  m.prinv = casadi_s3;
  m.pc = casadi_s3;
  m.lin_w = w+15;
  m.lin_v = w+21;
  m.lin_r = w+27;
  m.lin_beta = w+33;
  /* Get the initial guess */
  casadi_copy(arg[0], 3, m.x);
  for (iter=0; iter<6; ++iter) {
    /* (re)calculate f and J */
    arg[2] = m.x;
    arg[3] = arg[1];
    res[1] = m.jac_g_x;
    res[2] = m.g;
    if (casadi_f82(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* scaled_newton_384:(i0[3],i1)->(o0[3]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+427, w1, *w2=w+430;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f81(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  return 0;
}

/* simplest_walker_jacobian_384:(u[3],p)->(J[3x3],R[3]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+266, *w01=w+269, w02, *w03=w+271, *w04=w+275, *w05=w+283, w06, w07, w08, *w09=w+295;
  casadi_real *w10=w+319, *w11=w+331;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<8; ++i) *rr++ = *cs++;
  /* #5: @6 = 0 */
  w06 = 0.;
  /* #6: @7 = @0[2] */
  for (rr=(&w07), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @8 = 384 */
  w08 = 384.;
  /* #8: @8 = (@7/@8) */
  w08  = (w07/w08);
  /* #9: @9 = turns(@8, @2) */
  arg1[0]=(&w08);
  arg1[1]=(&w02);
  res1[0]=w09;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w05;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=(&w02);
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* simplest_walker_limit_cycle_384:(u0[3],p)->(u[3],J[3x3],R[3]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+434, w1, *w2=w+437, *w3=w+440;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = scaled_newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  res1[0]=w2;
  if (casadi_f80(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = simplest_walker_jacobian_384(@2, @1) */
  arg1[0]=w2;
  arg1[1]=(&w1);
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f85(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f79(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 449;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 449*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_12_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_24_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_36_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f26(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_48_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f49(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_72_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_96_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f63(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_144_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_192_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f77(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_288_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_residual_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_residual_384_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_residual_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_residual_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_residual_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 192;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 192*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f38(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_36_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f25(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_72_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_96_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f64(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_144_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_192_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f78(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_288_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_384_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 340;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 340*sizeof(casadi_real);
  return 0;
}

/* start_along:(z[2],p,d)->(y[4x4]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a1=(2.*a0);
  if (res[0]!=0) res[0][1]=a1;
  a1=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][2]=a1;
  a2=1.;
  a0=(2.*a0);
  a3=cos(a0);
  a3=(a2-a3);
  a4=(a1*a3);
  if (res[0]!=0) res[0][3]=a4;
  if (res[0]!=0) res[0][4]=a2;
  a4=2.;
  if (res[0]!=0) res[0][5]=a4;
  a4=0.;
  if (res[0]!=0) res[0][6]=a4;
  a0=sin(a0);
  a0=(-a0);
  a0=(2.*a0);
  a1=(a1*a0);
  a1=(-a1);
  if (res[0]!=0) res[0][7]=a1;
  if (res[0]!=0) res[0][8]=a4;
  if (res[0]!=0) res[0][9]=a4;
  if (res[0]!=0) res[0][10]=a2;
  if (res[0]!=0) res[0][11]=a3;
  if (res[0]!=0) res[0][12]=a4;
  if (res[0]!=0) res[0][13]=a4;
  if (res[0]!=0) res[0][14]=a4;
  if (res[0]!=0) res[0][15]=a4;
  return 0;
}

/* step_along:(y[4x4],phase[2],turns[2x12],h,p,t,d)->(y_end[4x4]) */
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
  casadi_real a216;
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
  a007=arg[4]? arg[4][0] : 0;
  a008=sin(a007);
  a009=cos(a000);
  a010=(a008*a009);
  a011=cos(a007);
  a012=sin(a000);
  a013=(a011*a012);
  a010=(a010-a013);
  a013=(a006*a010);
  a014=1.7082860872947386e-01;
  a014=(a014*a002);
  a015=2.9587585476806851e-02;
  a015=(a015*a002);
  a016=(a015*a003);
  a017=8.8762756430420545e-02;
  a017=(a017*a002);
  a018=1.9725056984537900e-02;
  a018=(a018*a002);
  a019=(a018*a010);
  a020=5.9175170953613701e-02;
  a020=(a020*a002);
  a021=5.2600151958767730e-02;
  a021=(a021*a002);
  a022=(a021*a003);
  a022=(a000+a022);
  a023=cos(a022);
  a024=(a008*a023);
  a022=sin(a022);
  a025=(a011*a022);
  a024=(a024-a025);
  a025=(a020*a024);
  a019=(a019+a025);
  a019=(a003-a019);
  a025=(a017*a019);
  a016=(a016+a025);
  a016=(a000+a016);
  a025=cos(a016);
  a026=(a008*a025);
  a016=sin(a016);
  a027=(a011*a016);
  a026=(a026-a027);
  a027=(a014*a026);
  a013=(a013+a027);
  a027=1.2546768756682242e-01;
  a027=(a027*a002);
  a028=2.4136513415926669e-01;
  a028=(a028*a002);
  a029=(a028*a003);
  a030=-8.8454947932828609e-01;
  a030=(a030*a002);
  a031=(a030*a019);
  a029=(a029+a031);
  a031=9.2483400326179199e-01;
  a031=(a031*a002);
  a032=(a015*a010);
  a033=(a018*a003);
  a034=(a021*a010);
  a034=(a003-a034);
  a035=(a020*a034);
  a033=(a033+a035);
  a033=(a000+a033);
  a035=cos(a033);
  a036=(a008*a035);
  a033=sin(a033);
  a037=(a011*a033);
  a036=(a036-a037);
  a037=(a017*a036);
  a032=(a032+a037);
  a032=(a003-a032);
  a037=(a031*a032);
  a029=(a029+a037);
  a029=(a000+a029);
  a037=cos(a029);
  a038=(a008*a037);
  a029=sin(a029);
  a039=(a011*a029);
  a038=(a038-a039);
  a039=(a027*a038);
  a013=(a013+a039);
  a013=(a003-a013);
  a039=(a005*a013);
  a004=(a004+a039);
  a039=1.8915178993145003e+00;
  a039=(a039*a002);
  a040=3.7109375000000000e-02;
  a040=(a040*a002);
  a041=(a040*a010);
  a042=1.7025221101954405e-01;
  a042=(a042*a002);
  a043=(a042*a026);
  a041=(a041+a043);
  a043=6.0216538980455959e-02;
  a043=(a043*a002);
  a044=(a043*a038);
  a041=(a041+a044);
  a044=-1.7578125000000000e-02;
  a044=(a044*a002);
  a045=(a006*a003);
  a046=(a014*a032);
  a045=(a045+a046);
  a046=(a028*a010);
  a047=(a030*a036);
  a046=(a046+a047);
  a047=(a031*a026);
  a046=(a046+a047);
  a046=(a003-a046);
  a047=(a027*a046);
  a045=(a045+a047);
  a045=(a000+a045);
  a047=cos(a045);
  a048=(a008*a047);
  a045=sin(a045);
  a049=(a011*a045);
  a048=(a048-a049);
  a049=(a044*a048);
  a041=(a041+a049);
  a041=(a003-a041);
  a049=(a039*a041);
  a004=(a004+a049);
  a049=-5.8012039600105849e+00;
  a049=(a049*a002);
  a050=3.7092000118504789e-02;
  a050=(a050*a002);
  a051=(a050*a010);
  a052=1.7038392571223998e-01;
  a052=(a052*a002);
  a053=(a052*a026);
  a051=(a051+a053);
  a053=1.0726203044637328e-01;
  a053=(a053*a002);
  a054=(a053*a038);
  a051=(a051+a054);
  a054=-1.5319437748624402e-02;
  a054=(a054*a002);
  a055=(a054*a048);
  a051=(a051+a055);
  a055=8.2737891638140233e-03;
  a055=(a055*a002);
  a056=(a040*a003);
  a057=(a042*a032);
  a056=(a056+a057);
  a057=(a043*a046);
  a056=(a056+a057);
  a057=(a044*a013);
  a056=(a056+a057);
  a056=(a000+a056);
  a057=cos(a056);
  a058=(a008*a057);
  a056=sin(a056);
  a059=(a011*a056);
  a058=(a058-a059);
  a059=(a055*a058);
  a051=(a051+a059);
  a051=(a003-a051);
  a059=(a049*a051);
  a004=(a004+a059);
  a059=3.1116436695781990e-01;
  a059=(a059*a002);
  a060=6.2411095871607569e-01;
  a060=(a060*a002);
  a061=(a060*a010);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a063=(a062*a026);
  a061=(a061+a063);
  a063=-8.6821934684172597e-01;
  a063=(a063*a002);
  a064=(a063*a038);
  a061=(a061+a064);
  a064=2.7592099699446710e+01;
  a064=(a064*a002);
  a065=(a064*a048);
  a061=(a061+a065);
  a065=2.0154067550477894e+01;
  a065=(a065*a002);
  a066=(a065*a058);
  a061=(a061+a066);
  a066=-4.3489884181069961e+01;
  a066=(a066*a002);
  a067=(a050*a003);
  a068=(a052*a032);
  a067=(a067+a068);
  a068=(a053*a046);
  a067=(a067+a068);
  a068=(a054*a013);
  a067=(a067+a068);
  a068=(a055*a041);
  a067=(a067+a068);
  a067=(a000+a067);
  a068=cos(a067);
  a069=(a008*a068);
  a067=sin(a067);
  a070=(a011*a067);
  a069=(a069-a070);
  a070=(a066*a069);
  a061=(a061+a070);
  a061=(a003-a061);
  a070=(a059*a061);
  a004=(a004+a070);
  a070=-1.5216094966251609e-01;
  a070=(a070*a002);
  a071=4.7766253643826434e-01;
  a071=(a071*a002);
  a072=(a071*a010);
  a073=-2.4881146199716677e+00;
  a073=(a073*a002);
  a074=(a073*a026);
  a072=(a072+a074);
  a074=-5.9029082683684297e-01;
  a074=(a074*a002);
  a075=(a074*a038);
  a072=(a072+a075);
  a075=2.1230051448181193e+01;
  a075=(a075*a002);
  a076=(a075*a048);
  a072=(a072+a076);
  a076=1.5279233632882423e+01;
  a076=(a076*a002);
  a077=(a076*a058);
  a072=(a072+a077);
  a077=-3.3288210968984863e+01;
  a077=(a077*a002);
  a078=(a077*a069);
  a072=(a072+a078);
  a078=-2.0331201708508627e-02;
  a078=(a078*a002);
  a079=(a060*a003);
  a080=(a062*a032);
  a079=(a079+a080);
  a080=(a063*a046);
  a079=(a079+a080);
  a080=(a064*a013);
  a079=(a079+a080);
  a080=(a065*a041);
  a079=(a079+a080);
  a080=(a066*a051);
  a079=(a079+a080);
  a079=(a000+a079);
  a080=cos(a079);
  a081=(a008*a080);
  a079=sin(a079);
  a082=(a011*a079);
  a081=(a081-a082);
  a082=(a078*a081);
  a072=(a072+a082);
  a072=(a003-a072);
  a082=(a070*a072);
  a004=(a004+a082);
  a082=2.0136540080403034e-01;
  a082=(a082*a002);
  a083=-9.3714243008598730e-01;
  a083=(a083*a002);
  a084=(a083*a010);
  a085=5.1863724288440638e+00;
  a085=(a085*a002);
  a086=(a085*a026);
  a084=(a084+a086);
  a086=1.0914373489967295e+00;
  a086=(a086*a002);
  a087=(a086*a038);
  a084=(a084+a087);
  a087=-8.1497870107469268e+00;
  a087=(a087*a002);
  a088=(a087*a048);
  a084=(a084+a088);
  a088=-1.8520065659996959e+01;
  a088=(a088*a002);
  a089=(a088*a058);
  a084=(a084+a089);
  a089=2.2739487099350505e+01;
  a089=(a089*a002);
  a090=(a089*a069);
  a084=(a084+a090);
  a090=2.4936055526796523e+00;
  a090=(a090*a002);
  a091=(a090*a081);
  a084=(a084+a091);
  a091=-3.0467644718982196e+00;
  a091=(a091*a002);
  a092=(a071*a003);
  a093=(a073*a032);
  a092=(a092+a093);
  a093=(a074*a046);
  a092=(a092+a093);
  a093=(a075*a013);
  a092=(a092+a093);
  a093=(a076*a041);
  a092=(a092+a093);
  a093=(a077*a051);
  a092=(a092+a093);
  a093=(a078*a061);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=cos(a092);
  a094=(a008*a093);
  a092=sin(a092);
  a095=(a011*a092);
  a094=(a094-a095);
  a095=(a091*a094);
  a084=(a084+a095);
  a084=(a003-a084);
  a095=(a082*a084);
  a004=(a004+a095);
  a095=4.4710615727772587e-02;
  a095=(a095*a002);
  a096=2.2733101475165380e+00;
  a096=(a096*a002);
  a097=(a096*a010);
  a098=-1.0534495466737249e+01;
  a098=(a098*a002);
  a099=(a098*a026);
  a097=(a097+a099);
  a099=-2.0008720582248625e+00;
  a099=(a099*a002);
  a100=(a099*a038);
  a097=(a097+a100);
  a100=-1.7958931863118799e+01;
  a100=(a100*a002);
  a101=(a100*a048);
  a097=(a097+a101);
  a101=2.7948884529419960e+01;
  a101=(a101*a002);
  a102=(a101*a058);
  a097=(a097+a102);
  a102=-2.8589982771350235e+00;
  a102=(a102*a002);
  a103=(a102*a069);
  a097=(a097+a103);
  a103=-8.8728569335306293e+00;
  a103=(a103*a002);
  a104=(a103*a081);
  a097=(a097+a104);
  a104=1.2360567175794303e+01;
  a104=(a104*a002);
  a105=(a104*a094);
  a097=(a097+a105);
  a105=6.4339274601576357e-01;
  a105=(a105*a002);
  a002=(a083*a003);
  a106=(a085*a032);
  a002=(a002+a106);
  a106=(a086*a046);
  a002=(a002+a106);
  a106=(a087*a013);
  a002=(a002+a106);
  a106=(a088*a041);
  a002=(a002+a106);
  a106=(a089*a051);
  a002=(a002+a106);
  a106=(a090*a061);
  a002=(a002+a106);
  a106=(a091*a072);
  a002=(a002+a106);
  a002=(a000+a002);
  a106=cos(a002);
  a107=(a008*a106);
  a002=sin(a002);
  a108=(a011*a002);
  a107=(a107-a108);
  a108=(a105*a107);
  a097=(a097+a108);
  a097=(a003-a097);
  a108=(a095*a097);
  a004=(a004+a108);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=arg[0]? arg[0][1] : 0;
  a108=arg[0]? arg[0][3] : 0;
  a109=(a001*a108);
  a110=casadi_sq(a003);
  a111=sin(a004);
  a110=(a110*a111);
  a112=(a004+a007);
  a113=sin(a112);
  a114=(a113*a009);
  a112=cos(a112);
  a115=(a112*a012);
  a114=(a114-a115);
  a110=(a110-a114);
  a114=cos(a004);
  a115=1.;
  a116=(a114-a115);
  a117=(a116*a010);
  a110=(a110+a117);
  a117=(a006*a110);
  a118=casadi_sq(a032);
  a119=(a015*a108);
  a120=(a018*a110);
  a121=casadi_sq(a034);
  a122=(a021*a108);
  a122=(a004+a122);
  a123=sin(a122);
  a121=(a121*a123);
  a124=(a122+a007);
  a125=sin(a124);
  a126=(a125*a023);
  a124=cos(a124);
  a127=(a124*a022);
  a126=(a126-a127);
  a121=(a121-a126);
  a122=cos(a122);
  a126=(a122-a115);
  a127=(a126*a024);
  a121=(a121+a127);
  a121=(a020*a121);
  a120=(a120+a121);
  a120=(a108+a120);
  a121=(a017*a120);
  a119=(a119+a121);
  a119=(a004+a119);
  a121=sin(a119);
  a118=(a118*a121);
  a127=(a119+a007);
  a128=sin(a127);
  a129=(a128*a025);
  a127=cos(a127);
  a130=(a127*a016);
  a129=(a129-a130);
  a118=(a118-a129);
  a119=cos(a119);
  a129=(a119-a115);
  a130=(a129*a026);
  a118=(a118+a130);
  a130=(a014*a118);
  a117=(a117+a130);
  a130=casadi_sq(a046);
  a131=(a028*a108);
  a120=(a030*a120);
  a131=(a131+a120);
  a120=(a015*a110);
  a132=casadi_sq(a019);
  a133=(a018*a108);
  a134=(a021*a110);
  a134=(a108+a134);
  a134=(a020*a134);
  a133=(a133+a134);
  a133=(a004+a133);
  a134=sin(a133);
  a132=(a132*a134);
  a135=(a133+a007);
  a136=sin(a135);
  a137=(a136*a035);
  a135=cos(a135);
  a138=(a135*a033);
  a137=(a137-a138);
  a132=(a132-a137);
  a133=cos(a133);
  a137=(a133-a115);
  a138=(a137*a036);
  a132=(a132+a138);
  a138=(a017*a132);
  a120=(a120+a138);
  a120=(a108+a120);
  a138=(a031*a120);
  a131=(a131+a138);
  a131=(a004+a131);
  a138=sin(a131);
  a130=(a130*a138);
  a139=(a131+a007);
  a140=sin(a139);
  a141=(a140*a037);
  a139=cos(a139);
  a142=(a139*a029);
  a141=(a141-a142);
  a130=(a130-a141);
  a131=cos(a131);
  a141=(a131-a115);
  a142=(a141*a038);
  a130=(a130+a142);
  a142=(a027*a130);
  a117=(a117+a142);
  a117=(a108+a117);
  a142=(a005*a117);
  a109=(a109+a142);
  a142=(a040*a110);
  a143=(a042*a118);
  a142=(a142+a143);
  a143=(a043*a130);
  a142=(a142+a143);
  a143=casadi_sq(a013);
  a144=(a006*a108);
  a145=(a014*a120);
  a144=(a144+a145);
  a145=(a028*a110);
  a132=(a030*a132);
  a145=(a145+a132);
  a132=(a031*a118);
  a145=(a145+a132);
  a145=(a108+a145);
  a132=(a027*a145);
  a144=(a144+a132);
  a144=(a004+a144);
  a132=sin(a144);
  a143=(a143*a132);
  a146=(a144+a007);
  a147=sin(a146);
  a148=(a147*a047);
  a146=cos(a146);
  a149=(a146*a045);
  a148=(a148-a149);
  a143=(a143-a148);
  a144=cos(a144);
  a148=(a144-a115);
  a149=(a148*a048);
  a143=(a143+a149);
  a149=(a044*a143);
  a142=(a142+a149);
  a142=(a108+a142);
  a149=(a039*a142);
  a109=(a109+a149);
  a149=(a050*a110);
  a150=(a052*a118);
  a149=(a149+a150);
  a150=(a053*a130);
  a149=(a149+a150);
  a150=(a054*a143);
  a149=(a149+a150);
  a150=casadi_sq(a041);
  a151=(a040*a108);
  a152=(a042*a120);
  a151=(a151+a152);
  a152=(a043*a145);
  a151=(a151+a152);
  a152=(a044*a117);
  a151=(a151+a152);
  a151=(a004+a151);
  a152=sin(a151);
  a150=(a150*a152);
  a153=(a151+a007);
  a154=sin(a153);
  a155=(a154*a057);
  a153=cos(a153);
  a156=(a153*a056);
  a155=(a155-a156);
  a150=(a150-a155);
  a151=cos(a151);
  a155=(a151-a115);
  a156=(a155*a058);
  a150=(a150+a156);
  a156=(a055*a150);
  a149=(a149+a156);
  a149=(a108+a149);
  a156=(a049*a149);
  a109=(a109+a156);
  a156=(a060*a110);
  a157=(a062*a118);
  a156=(a156+a157);
  a157=(a063*a130);
  a156=(a156+a157);
  a157=(a064*a143);
  a156=(a156+a157);
  a157=(a065*a150);
  a156=(a156+a157);
  a157=casadi_sq(a051);
  a158=(a050*a108);
  a159=(a052*a120);
  a158=(a158+a159);
  a159=(a053*a145);
  a158=(a158+a159);
  a159=(a054*a117);
  a158=(a158+a159);
  a159=(a055*a142);
  a158=(a158+a159);
  a158=(a004+a158);
  a159=sin(a158);
  a157=(a157*a159);
  a160=(a158+a007);
  a161=sin(a160);
  a162=(a161*a068);
  a160=cos(a160);
  a163=(a160*a067);
  a162=(a162-a163);
  a157=(a157-a162);
  a158=cos(a158);
  a162=(a158-a115);
  a163=(a162*a069);
  a157=(a157+a163);
  a163=(a066*a157);
  a156=(a156+a163);
  a156=(a108+a156);
  a163=(a059*a156);
  a109=(a109+a163);
  a163=(a071*a110);
  a164=(a073*a118);
  a163=(a163+a164);
  a164=(a074*a130);
  a163=(a163+a164);
  a164=(a075*a143);
  a163=(a163+a164);
  a164=(a076*a150);
  a163=(a163+a164);
  a164=(a077*a157);
  a163=(a163+a164);
  a164=casadi_sq(a061);
  a165=(a060*a108);
  a166=(a062*a120);
  a165=(a165+a166);
  a166=(a063*a145);
  a165=(a165+a166);
  a166=(a064*a117);
  a165=(a165+a166);
  a166=(a065*a142);
  a165=(a165+a166);
  a166=(a066*a149);
  a165=(a165+a166);
  a165=(a004+a165);
  a166=sin(a165);
  a164=(a164*a166);
  a167=(a165+a007);
  a168=sin(a167);
  a169=(a168*a080);
  a167=cos(a167);
  a170=(a167*a079);
  a169=(a169-a170);
  a164=(a164-a169);
  a165=cos(a165);
  a169=(a165-a115);
  a170=(a169*a081);
  a164=(a164+a170);
  a170=(a078*a164);
  a163=(a163+a170);
  a163=(a108+a163);
  a170=(a070*a163);
  a109=(a109+a170);
  a170=(a083*a110);
  a171=(a085*a118);
  a170=(a170+a171);
  a171=(a086*a130);
  a170=(a170+a171);
  a171=(a087*a143);
  a170=(a170+a171);
  a171=(a088*a150);
  a170=(a170+a171);
  a171=(a089*a157);
  a170=(a170+a171);
  a171=(a090*a164);
  a170=(a170+a171);
  a171=casadi_sq(a072);
  a172=(a071*a108);
  a173=(a073*a120);
  a172=(a172+a173);
  a173=(a074*a145);
  a172=(a172+a173);
  a173=(a075*a117);
  a172=(a172+a173);
  a173=(a076*a142);
  a172=(a172+a173);
  a173=(a077*a149);
  a172=(a172+a173);
  a173=(a078*a156);
  a172=(a172+a173);
  a172=(a004+a172);
  a173=sin(a172);
  a171=(a171*a173);
  a174=(a172+a007);
  a175=sin(a174);
  a176=(a175*a093);
  a174=cos(a174);
  a177=(a174*a092);
  a176=(a176-a177);
  a171=(a171-a176);
  a172=cos(a172);
  a176=(a172-a115);
  a177=(a176*a094);
  a171=(a171+a177);
  a177=(a091*a171);
  a170=(a170+a177);
  a170=(a108+a170);
  a177=(a082*a170);
  a109=(a109+a177);
  a177=(a096*a110);
  a118=(a098*a118);
  a177=(a177+a118);
  a130=(a099*a130);
  a177=(a177+a130);
  a130=(a100*a143);
  a177=(a177+a130);
  a130=(a101*a150);
  a177=(a177+a130);
  a130=(a102*a157);
  a177=(a177+a130);
  a130=(a103*a164);
  a177=(a177+a130);
  a130=(a104*a171);
  a177=(a177+a130);
  a130=casadi_sq(a084);
  a118=(a083*a108);
  a178=(a085*a120);
  a118=(a118+a178);
  a178=(a086*a145);
  a118=(a118+a178);
  a178=(a087*a117);
  a118=(a118+a178);
  a178=(a088*a142);
  a118=(a118+a178);
  a178=(a089*a149);
  a118=(a118+a178);
  a178=(a090*a156);
  a118=(a118+a178);
  a178=(a091*a163);
  a118=(a118+a178);
  a118=(a004+a118);
  a178=sin(a118);
  a130=(a130*a178);
  a179=(a118+a007);
  a180=sin(a179);
  a181=(a180*a106);
  a179=cos(a179);
  a182=(a179*a002);
  a181=(a181-a182);
  a130=(a130-a181);
  a118=cos(a118);
  a181=(a118-a115);
  a182=(a181*a107);
  a130=(a130+a182);
  a182=(a105*a130);
  a177=(a177+a182);
  a177=(a108+a177);
  a177=(a095*a177);
  a109=(a109+a177);
  a109=(a004+a109);
  if (res[0]!=0) res[0][1]=a109;
  a109=(a001*a010);
  a177=(a005*a048);
  a109=(a109+a177);
  a177=(a039*a058);
  a109=(a109+a177);
  a177=(a049*a069);
  a109=(a109+a177);
  a177=(a059*a081);
  a109=(a109+a177);
  a177=(a070*a094);
  a109=(a109+a177);
  a177=(a082*a107);
  a109=(a109+a177);
  a177=(a096*a003);
  a182=(a098*a032);
  a177=(a177+a182);
  a182=(a099*a046);
  a177=(a177+a182);
  a182=(a100*a013);
  a177=(a177+a182);
  a182=(a101*a041);
  a177=(a177+a182);
  a182=(a102*a051);
  a177=(a177+a182);
  a182=(a103*a061);
  a177=(a177+a182);
  a182=(a104*a072);
  a177=(a177+a182);
  a182=(a105*a084);
  a177=(a177+a182);
  a000=(a000+a177);
  a177=cos(a000);
  a182=(a008*a177);
  a000=sin(a000);
  a183=(a011*a000);
  a182=(a182-a183);
  a183=(a095*a182);
  a109=(a109+a183);
  a109=(a003-a109);
  if (res[0]!=0) res[0][2]=a109;
  a110=(a001*a110);
  a143=(a005*a143);
  a110=(a110+a143);
  a150=(a039*a150);
  a110=(a110+a150);
  a157=(a049*a157);
  a110=(a110+a157);
  a164=(a059*a164);
  a110=(a110+a164);
  a171=(a070*a171);
  a110=(a110+a171);
  a130=(a082*a130);
  a110=(a110+a130);
  a130=casadi_sq(a097);
  a171=(a096*a108);
  a120=(a098*a120);
  a171=(a171+a120);
  a145=(a099*a145);
  a171=(a171+a145);
  a117=(a100*a117);
  a171=(a171+a117);
  a142=(a101*a142);
  a171=(a171+a142);
  a149=(a102*a149);
  a171=(a171+a149);
  a156=(a103*a156);
  a171=(a171+a156);
  a163=(a104*a163);
  a171=(a171+a163);
  a170=(a105*a170);
  a171=(a171+a170);
  a004=(a004+a171);
  a171=sin(a004);
  a130=(a130*a171);
  a007=(a004+a007);
  a170=sin(a007);
  a163=(a170*a177);
  a007=cos(a007);
  a156=(a007*a000);
  a163=(a163-a156);
  a130=(a130-a163);
  a004=cos(a004);
  a115=(a004-a115);
  a163=(a115*a182);
  a130=(a130+a163);
  a130=(a095*a130);
  a110=(a110+a130);
  a108=(a108+a110);
  if (res[0]!=0) res[0][3]=a108;
  a108=arg[0]? arg[0][4] : 0;
  a110=arg[0]? arg[0][6] : 0;
  a130=(a001*a110);
  a163=(a011*a009);
  a156=(a008*a012);
  a163=(a163+a156);
  a156=(a163*a108);
  a149=(a006*a156);
  a142=(a011*a025);
  a117=(a008*a016);
  a142=(a142+a117);
  a117=(a015*a110);
  a145=(a018*a156);
  a120=(a011*a023);
  a164=(a008*a022);
  a120=(a120+a164);
  a164=(a021*a110);
  a164=(a108+a164);
  a157=(a120*a164);
  a157=(a020*a157);
  a145=(a145+a157);
  a145=(a110+a145);
  a157=(a017*a145);
  a117=(a117+a157);
  a117=(a108+a117);
  a157=(a142*a117);
  a150=(a014*a157);
  a149=(a149+a150);
  a150=(a011*a037);
  a143=(a008*a029);
  a150=(a150+a143);
  a143=(a028*a110);
  a109=(a030*a145);
  a143=(a143+a109);
  a109=(a015*a156);
  a183=(a011*a035);
  a184=(a008*a033);
  a183=(a183+a184);
  a184=(a018*a110);
  a185=(a021*a156);
  a185=(a110+a185);
  a186=(a020*a185);
  a184=(a184+a186);
  a184=(a108+a184);
  a186=(a183*a184);
  a187=(a017*a186);
  a109=(a109+a187);
  a109=(a110+a109);
  a187=(a031*a109);
  a143=(a143+a187);
  a143=(a108+a143);
  a187=(a150*a143);
  a188=(a027*a187);
  a149=(a149+a188);
  a149=(a110+a149);
  a188=(a005*a149);
  a130=(a130+a188);
  a188=(a040*a156);
  a189=(a042*a157);
  a188=(a188+a189);
  a189=(a043*a187);
  a188=(a188+a189);
  a189=(a011*a047);
  a190=(a008*a045);
  a189=(a189+a190);
  a190=(a006*a110);
  a191=(a014*a109);
  a190=(a190+a191);
  a191=(a028*a156);
  a186=(a030*a186);
  a191=(a191+a186);
  a186=(a031*a157);
  a191=(a191+a186);
  a191=(a110+a191);
  a186=(a027*a191);
  a190=(a190+a186);
  a190=(a108+a190);
  a186=(a189*a190);
  a192=(a044*a186);
  a188=(a188+a192);
  a188=(a110+a188);
  a192=(a039*a188);
  a130=(a130+a192);
  a192=(a050*a156);
  a193=(a052*a157);
  a192=(a192+a193);
  a193=(a053*a187);
  a192=(a192+a193);
  a193=(a054*a186);
  a192=(a192+a193);
  a193=(a011*a057);
  a194=(a008*a056);
  a193=(a193+a194);
  a194=(a040*a110);
  a195=(a042*a109);
  a194=(a194+a195);
  a195=(a043*a191);
  a194=(a194+a195);
  a195=(a044*a149);
  a194=(a194+a195);
  a194=(a108+a194);
  a195=(a193*a194);
  a196=(a055*a195);
  a192=(a192+a196);
  a192=(a110+a192);
  a196=(a049*a192);
  a130=(a130+a196);
  a196=(a060*a156);
  a197=(a062*a157);
  a196=(a196+a197);
  a197=(a063*a187);
  a196=(a196+a197);
  a197=(a064*a186);
  a196=(a196+a197);
  a197=(a065*a195);
  a196=(a196+a197);
  a197=(a011*a068);
  a198=(a008*a067);
  a197=(a197+a198);
  a198=(a050*a110);
  a199=(a052*a109);
  a198=(a198+a199);
  a199=(a053*a191);
  a198=(a198+a199);
  a199=(a054*a149);
  a198=(a198+a199);
  a199=(a055*a188);
  a198=(a198+a199);
  a198=(a108+a198);
  a199=(a197*a198);
  a200=(a066*a199);
  a196=(a196+a200);
  a196=(a110+a196);
  a200=(a059*a196);
  a130=(a130+a200);
  a200=(a071*a156);
  a201=(a073*a157);
  a200=(a200+a201);
  a201=(a074*a187);
  a200=(a200+a201);
  a201=(a075*a186);
  a200=(a200+a201);
  a201=(a076*a195);
  a200=(a200+a201);
  a201=(a077*a199);
  a200=(a200+a201);
  a201=(a011*a080);
  a202=(a008*a079);
  a201=(a201+a202);
  a202=(a060*a110);
  a203=(a062*a109);
  a202=(a202+a203);
  a203=(a063*a191);
  a202=(a202+a203);
  a203=(a064*a149);
  a202=(a202+a203);
  a203=(a065*a188);
  a202=(a202+a203);
  a203=(a066*a192);
  a202=(a202+a203);
  a202=(a108+a202);
  a203=(a201*a202);
  a204=(a078*a203);
  a200=(a200+a204);
  a200=(a110+a200);
  a204=(a070*a200);
  a130=(a130+a204);
  a204=(a083*a156);
  a205=(a085*a157);
  a204=(a204+a205);
  a205=(a086*a187);
  a204=(a204+a205);
  a205=(a087*a186);
  a204=(a204+a205);
  a205=(a088*a195);
  a204=(a204+a205);
  a205=(a089*a199);
  a204=(a204+a205);
  a205=(a090*a203);
  a204=(a204+a205);
  a205=(a011*a093);
  a206=(a008*a092);
  a205=(a205+a206);
  a206=(a071*a110);
  a207=(a073*a109);
  a206=(a206+a207);
  a207=(a074*a191);
  a206=(a206+a207);
  a207=(a075*a149);
  a206=(a206+a207);
  a207=(a076*a188);
  a206=(a206+a207);
  a207=(a077*a192);
  a206=(a206+a207);
  a207=(a078*a196);
  a206=(a206+a207);
  a206=(a108+a206);
  a207=(a205*a206);
  a208=(a091*a207);
  a204=(a204+a208);
  a204=(a110+a204);
  a208=(a082*a204);
  a130=(a130+a208);
  a208=(a096*a156);
  a157=(a098*a157);
  a208=(a208+a157);
  a187=(a099*a187);
  a208=(a208+a187);
  a187=(a100*a186);
  a208=(a208+a187);
  a187=(a101*a195);
  a208=(a208+a187);
  a187=(a102*a199);
  a208=(a208+a187);
  a187=(a103*a203);
  a208=(a208+a187);
  a187=(a104*a207);
  a208=(a208+a187);
  a187=(a011*a106);
  a157=(a008*a002);
  a187=(a187+a157);
  a157=(a083*a110);
  a209=(a085*a109);
  a157=(a157+a209);
  a209=(a086*a191);
  a157=(a157+a209);
  a209=(a087*a149);
  a157=(a157+a209);
  a209=(a088*a188);
  a157=(a157+a209);
  a209=(a089*a192);
  a157=(a157+a209);
  a209=(a090*a196);
  a157=(a157+a209);
  a209=(a091*a200);
  a157=(a157+a209);
  a157=(a108+a157);
  a209=(a187*a157);
  a210=(a105*a209);
  a208=(a208+a210);
  a208=(a110+a208);
  a210=(a095*a208);
  a130=(a130+a210);
  a130=(a108+a130);
  if (res[0]!=0) res[0][4]=a130;
  a130=arg[0]? arg[0][5] : 0;
  a210=arg[0]? arg[0][7] : 0;
  a211=(a001*a210);
  a212=(a112*a009);
  a213=(a113*a012);
  a212=(a212+a213);
  a213=(a116*a163);
  a213=(a212-a213);
  a214=(a213*a108);
  a114=(a114*a003);
  a114=(a114*a003);
  a114=(a114-a212);
  a010=(a010*a111);
  a114=(a114-a010);
  a010=(a114*a130);
  a214=(a214+a010);
  a003=(2.*a003);
  a003=(a003*a111);
  a111=(a003*a110);
  a214=(a214+a111);
  a111=(a006*a214);
  a010=(a127*a025);
  a212=(a128*a016);
  a010=(a010+a212);
  a212=(a129*a142);
  a212=(a010-a212);
  a117=(a212*a117);
  a119=(a119*a032);
  a119=(a119*a032);
  a119=(a119-a010);
  a026=(a026*a121);
  a119=(a119-a026);
  a026=(a015*a210);
  a010=(a018*a214);
  a215=(a124*a023);
  a216=(a125*a022);
  a215=(a215+a216);
  a216=(a126*a120);
  a216=(a215-a216);
  a164=(a216*a164);
  a122=(a122*a034);
  a122=(a122*a034);
  a122=(a122-a215);
  a024=(a024*a123);
  a122=(a122-a024);
  a024=(a021*a210);
  a024=(a130+a024);
  a024=(a122*a024);
  a164=(a164+a024);
  a034=(2.*a034);
  a034=(a034*a123);
  a185=(a034*a185);
  a164=(a164+a185);
  a164=(a020*a164);
  a010=(a010+a164);
  a010=(a210+a010);
  a164=(a017*a010);
  a026=(a026+a164);
  a026=(a130+a026);
  a026=(a119*a026);
  a117=(a117+a026);
  a032=(2.*a032);
  a032=(a032*a121);
  a121=(a032*a109);
  a117=(a117+a121);
  a121=(a014*a117);
  a111=(a111+a121);
  a121=(a139*a037);
  a026=(a140*a029);
  a121=(a121+a026);
  a026=(a141*a150);
  a026=(a121-a026);
  a143=(a026*a143);
  a131=(a131*a046);
  a131=(a131*a046);
  a131=(a131-a121);
  a038=(a038*a138);
  a131=(a131-a038);
  a038=(a028*a210);
  a010=(a030*a010);
  a038=(a038+a010);
  a010=(a015*a214);
  a121=(a135*a035);
  a164=(a136*a033);
  a121=(a121+a164);
  a164=(a137*a183);
  a164=(a121-a164);
  a184=(a164*a184);
  a133=(a133*a019);
  a133=(a133*a019);
  a133=(a133-a121);
  a036=(a036*a134);
  a133=(a133-a036);
  a036=(a018*a210);
  a121=(a021*a214);
  a121=(a210+a121);
  a121=(a020*a121);
  a036=(a036+a121);
  a036=(a130+a036);
  a036=(a133*a036);
  a184=(a184+a036);
  a019=(2.*a019);
  a019=(a019*a134);
  a145=(a019*a145);
  a184=(a184+a145);
  a145=(a017*a184);
  a010=(a010+a145);
  a010=(a210+a010);
  a145=(a031*a010);
  a038=(a038+a145);
  a038=(a130+a038);
  a038=(a131*a038);
  a143=(a143+a038);
  a046=(2.*a046);
  a046=(a046*a138);
  a138=(a046*a191);
  a143=(a143+a138);
  a138=(a027*a143);
  a111=(a111+a138);
  a111=(a210+a111);
  a138=(a005*a111);
  a211=(a211+a138);
  a138=(a040*a214);
  a038=(a042*a117);
  a138=(a138+a038);
  a038=(a043*a143);
  a138=(a138+a038);
  a038=(a146*a047);
  a145=(a147*a045);
  a038=(a038+a145);
  a145=(a148*a189);
  a145=(a038-a145);
  a190=(a145*a190);
  a144=(a144*a013);
  a144=(a144*a013);
  a144=(a144-a038);
  a048=(a048*a132);
  a144=(a144-a048);
  a048=(a006*a210);
  a038=(a014*a010);
  a048=(a048+a038);
  a038=(a028*a214);
  a184=(a030*a184);
  a038=(a038+a184);
  a184=(a031*a117);
  a038=(a038+a184);
  a038=(a210+a038);
  a184=(a027*a038);
  a048=(a048+a184);
  a048=(a130+a048);
  a048=(a144*a048);
  a190=(a190+a048);
  a013=(2.*a013);
  a013=(a013*a132);
  a132=(a013*a149);
  a190=(a190+a132);
  a132=(a044*a190);
  a138=(a138+a132);
  a138=(a210+a138);
  a132=(a039*a138);
  a211=(a211+a132);
  a132=(a050*a214);
  a048=(a052*a117);
  a132=(a132+a048);
  a048=(a053*a143);
  a132=(a132+a048);
  a048=(a054*a190);
  a132=(a132+a048);
  a048=(a153*a057);
  a184=(a154*a056);
  a048=(a048+a184);
  a184=(a155*a193);
  a184=(a048-a184);
  a194=(a184*a194);
  a151=(a151*a041);
  a151=(a151*a041);
  a151=(a151-a048);
  a058=(a058*a152);
  a151=(a151-a058);
  a058=(a040*a210);
  a048=(a042*a010);
  a058=(a058+a048);
  a048=(a043*a038);
  a058=(a058+a048);
  a048=(a044*a111);
  a058=(a058+a048);
  a058=(a130+a058);
  a058=(a151*a058);
  a194=(a194+a058);
  a041=(2.*a041);
  a041=(a041*a152);
  a152=(a041*a188);
  a194=(a194+a152);
  a152=(a055*a194);
  a132=(a132+a152);
  a132=(a210+a132);
  a152=(a049*a132);
  a211=(a211+a152);
  a152=(a060*a214);
  a058=(a062*a117);
  a152=(a152+a058);
  a058=(a063*a143);
  a152=(a152+a058);
  a058=(a064*a190);
  a152=(a152+a058);
  a058=(a065*a194);
  a152=(a152+a058);
  a058=(a160*a068);
  a048=(a161*a067);
  a058=(a058+a048);
  a048=(a162*a197);
  a048=(a058-a048);
  a198=(a048*a198);
  a158=(a158*a051);
  a158=(a158*a051);
  a158=(a158-a058);
  a069=(a069*a159);
  a158=(a158-a069);
  a069=(a050*a210);
  a058=(a052*a010);
  a069=(a069+a058);
  a058=(a053*a038);
  a069=(a069+a058);
  a058=(a054*a111);
  a069=(a069+a058);
  a058=(a055*a138);
  a069=(a069+a058);
  a069=(a130+a069);
  a069=(a158*a069);
  a198=(a198+a069);
  a051=(2.*a051);
  a051=(a051*a159);
  a159=(a051*a192);
  a198=(a198+a159);
  a159=(a066*a198);
  a152=(a152+a159);
  a152=(a210+a152);
  a159=(a059*a152);
  a211=(a211+a159);
  a159=(a071*a214);
  a069=(a073*a117);
  a159=(a159+a069);
  a069=(a074*a143);
  a159=(a159+a069);
  a069=(a075*a190);
  a159=(a159+a069);
  a069=(a076*a194);
  a159=(a159+a069);
  a069=(a077*a198);
  a159=(a159+a069);
  a069=(a167*a080);
  a058=(a168*a079);
  a069=(a069+a058);
  a058=(a169*a201);
  a058=(a069-a058);
  a202=(a058*a202);
  a165=(a165*a061);
  a165=(a165*a061);
  a165=(a165-a069);
  a081=(a081*a166);
  a165=(a165-a081);
  a081=(a060*a210);
  a069=(a062*a010);
  a081=(a081+a069);
  a069=(a063*a038);
  a081=(a081+a069);
  a069=(a064*a111);
  a081=(a081+a069);
  a069=(a065*a138);
  a081=(a081+a069);
  a069=(a066*a132);
  a081=(a081+a069);
  a081=(a130+a081);
  a081=(a165*a081);
  a202=(a202+a081);
  a061=(2.*a061);
  a061=(a061*a166);
  a166=(a061*a196);
  a202=(a202+a166);
  a166=(a078*a202);
  a159=(a159+a166);
  a159=(a210+a159);
  a166=(a070*a159);
  a211=(a211+a166);
  a166=(a083*a214);
  a081=(a085*a117);
  a166=(a166+a081);
  a081=(a086*a143);
  a166=(a166+a081);
  a081=(a087*a190);
  a166=(a166+a081);
  a081=(a088*a194);
  a166=(a166+a081);
  a081=(a089*a198);
  a166=(a166+a081);
  a081=(a090*a202);
  a166=(a166+a081);
  a081=(a174*a093);
  a069=(a175*a092);
  a081=(a081+a069);
  a069=(a176*a205);
  a069=(a081-a069);
  a206=(a069*a206);
  a172=(a172*a072);
  a172=(a172*a072);
  a172=(a172-a081);
  a094=(a094*a173);
  a172=(a172-a094);
  a094=(a071*a210);
  a081=(a073*a010);
  a094=(a094+a081);
  a081=(a074*a038);
  a094=(a094+a081);
  a081=(a075*a111);
  a094=(a094+a081);
  a081=(a076*a138);
  a094=(a094+a081);
  a081=(a077*a132);
  a094=(a094+a081);
  a081=(a078*a152);
  a094=(a094+a081);
  a094=(a130+a094);
  a094=(a172*a094);
  a206=(a206+a094);
  a072=(2.*a072);
  a072=(a072*a173);
  a173=(a072*a200);
  a206=(a206+a173);
  a173=(a091*a206);
  a166=(a166+a173);
  a166=(a210+a166);
  a173=(a082*a166);
  a211=(a211+a173);
  a173=(a096*a214);
  a117=(a098*a117);
  a173=(a173+a117);
  a143=(a099*a143);
  a173=(a173+a143);
  a143=(a100*a190);
  a173=(a173+a143);
  a143=(a101*a194);
  a173=(a173+a143);
  a143=(a102*a198);
  a173=(a173+a143);
  a143=(a103*a202);
  a173=(a173+a143);
  a143=(a104*a206);
  a173=(a173+a143);
  a143=(a179*a106);
  a117=(a180*a002);
  a143=(a143+a117);
  a117=(a181*a187);
  a117=(a143-a117);
  a157=(a117*a157);
  a118=(a118*a084);
  a118=(a118*a084);
  a118=(a118-a143);
  a107=(a107*a178);
  a118=(a118-a107);
  a107=(a083*a210);
  a143=(a085*a010);
  a107=(a107+a143);
  a143=(a086*a038);
  a107=(a107+a143);
  a143=(a087*a111);
  a107=(a107+a143);
  a143=(a088*a138);
  a107=(a107+a143);
  a143=(a089*a132);
  a107=(a107+a143);
  a143=(a090*a152);
  a107=(a107+a143);
  a143=(a091*a159);
  a107=(a107+a143);
  a107=(a130+a107);
  a107=(a118*a107);
  a157=(a157+a107);
  a084=(2.*a084);
  a084=(a084*a178);
  a178=(a084*a204);
  a157=(a157+a178);
  a178=(a105*a157);
  a173=(a173+a178);
  a173=(a210+a173);
  a173=(a095*a173);
  a211=(a211+a173);
  a211=(a130+a211);
  if (res[0]!=0) res[0][5]=a211;
  a156=(a001*a156);
  a186=(a005*a186);
  a156=(a156+a186);
  a195=(a039*a195);
  a156=(a156+a195);
  a199=(a049*a199);
  a156=(a156+a199);
  a203=(a059*a203);
  a156=(a156+a203);
  a207=(a070*a207);
  a156=(a156+a207);
  a209=(a082*a209);
  a156=(a156+a209);
  a209=(a011*a177);
  a207=(a008*a000);
  a209=(a209+a207);
  a207=(a096*a110);
  a109=(a098*a109);
  a207=(a207+a109);
  a191=(a099*a191);
  a207=(a207+a191);
  a149=(a100*a149);
  a207=(a207+a149);
  a188=(a101*a188);
  a207=(a207+a188);
  a192=(a102*a192);
  a207=(a207+a192);
  a196=(a103*a196);
  a207=(a207+a196);
  a200=(a104*a200);
  a207=(a207+a200);
  a204=(a105*a204);
  a207=(a207+a204);
  a108=(a108+a207);
  a207=(a209*a108);
  a207=(a095*a207);
  a156=(a156+a207);
  a110=(a110+a156);
  if (res[0]!=0) res[0][6]=a110;
  a214=(a001*a214);
  a190=(a005*a190);
  a214=(a214+a190);
  a194=(a039*a194);
  a214=(a214+a194);
  a198=(a049*a198);
  a214=(a214+a198);
  a202=(a059*a202);
  a214=(a214+a202);
  a206=(a070*a206);
  a214=(a214+a206);
  a157=(a082*a157);
  a214=(a214+a157);
  a157=(a007*a177);
  a206=(a170*a000);
  a157=(a157+a206);
  a206=(a115*a209);
  a206=(a157-a206);
  a108=(a206*a108);
  a004=(a004*a097);
  a004=(a004*a097);
  a004=(a004-a157);
  a182=(a182*a171);
  a004=(a004-a182);
  a182=(a096*a210);
  a010=(a098*a010);
  a182=(a182+a010);
  a038=(a099*a038);
  a182=(a182+a038);
  a111=(a100*a111);
  a182=(a182+a111);
  a138=(a101*a138);
  a182=(a182+a138);
  a132=(a102*a132);
  a182=(a182+a132);
  a152=(a103*a152);
  a182=(a182+a152);
  a159=(a104*a159);
  a182=(a182+a159);
  a166=(a105*a166);
  a182=(a182+a166);
  a130=(a130+a182);
  a130=(a004*a130);
  a108=(a108+a130);
  a097=(2.*a097);
  a097=(a097*a171);
  a208=(a097*a208);
  a108=(a108+a208);
  a108=(a095*a108);
  a214=(a214+a108);
  a210=(a210+a214);
  if (res[0]!=0) res[0][7]=a210;
  a210=arg[0]? arg[0][8] : 0;
  a214=arg[0]? arg[0][10] : 0;
  a108=(a001*a214);
  a208=(a163*a210);
  a171=(a006*a208);
  a130=(a015*a214);
  a182=(a018*a208);
  a166=(a021*a214);
  a166=(a210+a166);
  a159=(a120*a166);
  a159=(a020*a159);
  a182=(a182+a159);
  a182=(a214+a182);
  a159=(a017*a182);
  a130=(a130+a159);
  a130=(a210+a130);
  a159=(a142*a130);
  a152=(a014*a159);
  a171=(a171+a152);
  a152=(a028*a214);
  a132=(a030*a182);
  a152=(a152+a132);
  a132=(a015*a208);
  a138=(a018*a214);
  a111=(a021*a208);
  a111=(a214+a111);
  a038=(a020*a111);
  a138=(a138+a038);
  a138=(a210+a138);
  a038=(a183*a138);
  a010=(a017*a038);
  a132=(a132+a010);
  a132=(a214+a132);
  a010=(a031*a132);
  a152=(a152+a010);
  a152=(a210+a152);
  a010=(a150*a152);
  a157=(a027*a010);
  a171=(a171+a157);
  a171=(a214+a171);
  a157=(a005*a171);
  a108=(a108+a157);
  a157=(a040*a208);
  a202=(a042*a159);
  a157=(a157+a202);
  a202=(a043*a010);
  a157=(a157+a202);
  a202=(a006*a214);
  a198=(a014*a132);
  a202=(a202+a198);
  a198=(a028*a208);
  a038=(a030*a038);
  a198=(a198+a038);
  a038=(a031*a159);
  a198=(a198+a038);
  a198=(a214+a198);
  a038=(a027*a198);
  a202=(a202+a038);
  a202=(a210+a202);
  a038=(a189*a202);
  a194=(a044*a038);
  a157=(a157+a194);
  a157=(a214+a157);
  a194=(a039*a157);
  a108=(a108+a194);
  a194=(a050*a208);
  a190=(a052*a159);
  a194=(a194+a190);
  a190=(a053*a010);
  a194=(a194+a190);
  a190=(a054*a038);
  a194=(a194+a190);
  a190=(a040*a214);
  a110=(a042*a132);
  a190=(a190+a110);
  a110=(a043*a198);
  a190=(a190+a110);
  a110=(a044*a171);
  a190=(a190+a110);
  a190=(a210+a190);
  a110=(a193*a190);
  a156=(a055*a110);
  a194=(a194+a156);
  a194=(a214+a194);
  a156=(a049*a194);
  a108=(a108+a156);
  a156=(a060*a208);
  a207=(a062*a159);
  a156=(a156+a207);
  a207=(a063*a010);
  a156=(a156+a207);
  a207=(a064*a038);
  a156=(a156+a207);
  a207=(a065*a110);
  a156=(a156+a207);
  a207=(a050*a214);
  a204=(a052*a132);
  a207=(a207+a204);
  a204=(a053*a198);
  a207=(a207+a204);
  a204=(a054*a171);
  a207=(a207+a204);
  a204=(a055*a157);
  a207=(a207+a204);
  a207=(a210+a207);
  a204=(a197*a207);
  a200=(a066*a204);
  a156=(a156+a200);
  a156=(a214+a156);
  a200=(a059*a156);
  a108=(a108+a200);
  a200=(a071*a208);
  a196=(a073*a159);
  a200=(a200+a196);
  a196=(a074*a010);
  a200=(a200+a196);
  a196=(a075*a038);
  a200=(a200+a196);
  a196=(a076*a110);
  a200=(a200+a196);
  a196=(a077*a204);
  a200=(a200+a196);
  a196=(a060*a214);
  a192=(a062*a132);
  a196=(a196+a192);
  a192=(a063*a198);
  a196=(a196+a192);
  a192=(a064*a171);
  a196=(a196+a192);
  a192=(a065*a157);
  a196=(a196+a192);
  a192=(a066*a194);
  a196=(a196+a192);
  a196=(a210+a196);
  a192=(a201*a196);
  a188=(a078*a192);
  a200=(a200+a188);
  a200=(a214+a200);
  a188=(a070*a200);
  a108=(a108+a188);
  a188=(a083*a208);
  a149=(a085*a159);
  a188=(a188+a149);
  a149=(a086*a010);
  a188=(a188+a149);
  a149=(a087*a038);
  a188=(a188+a149);
  a149=(a088*a110);
  a188=(a188+a149);
  a149=(a089*a204);
  a188=(a188+a149);
  a149=(a090*a192);
  a188=(a188+a149);
  a149=(a071*a214);
  a191=(a073*a132);
  a149=(a149+a191);
  a191=(a074*a198);
  a149=(a149+a191);
  a191=(a075*a171);
  a149=(a149+a191);
  a191=(a076*a157);
  a149=(a149+a191);
  a191=(a077*a194);
  a149=(a149+a191);
  a191=(a078*a156);
  a149=(a149+a191);
  a149=(a210+a149);
  a191=(a205*a149);
  a109=(a091*a191);
  a188=(a188+a109);
  a188=(a214+a188);
  a109=(a082*a188);
  a108=(a108+a109);
  a109=(a096*a208);
  a159=(a098*a159);
  a109=(a109+a159);
  a010=(a099*a010);
  a109=(a109+a010);
  a010=(a100*a038);
  a109=(a109+a010);
  a010=(a101*a110);
  a109=(a109+a010);
  a010=(a102*a204);
  a109=(a109+a010);
  a010=(a103*a192);
  a109=(a109+a010);
  a010=(a104*a191);
  a109=(a109+a010);
  a010=(a083*a214);
  a159=(a085*a132);
  a010=(a010+a159);
  a159=(a086*a198);
  a010=(a010+a159);
  a159=(a087*a171);
  a010=(a010+a159);
  a159=(a088*a157);
  a010=(a010+a159);
  a159=(a089*a194);
  a010=(a010+a159);
  a159=(a090*a156);
  a010=(a010+a159);
  a159=(a091*a200);
  a010=(a010+a159);
  a010=(a210+a010);
  a159=(a187*a010);
  a203=(a105*a159);
  a109=(a109+a203);
  a109=(a214+a109);
  a203=(a095*a109);
  a108=(a108+a203);
  a108=(a210+a108);
  if (res[0]!=0) res[0][8]=a108;
  a108=arg[0]? arg[0][9] : 0;
  a203=arg[0]? arg[0][11] : 0;
  a199=(a001*a203);
  a195=(a213*a210);
  a186=(a114*a108);
  a195=(a195+a186);
  a186=(a003*a214);
  a195=(a195+a186);
  a186=(a006*a195);
  a130=(a212*a130);
  a211=(a015*a203);
  a173=(a018*a195);
  a166=(a216*a166);
  a178=(a021*a203);
  a178=(a108+a178);
  a178=(a122*a178);
  a166=(a166+a178);
  a111=(a034*a111);
  a166=(a166+a111);
  a166=(a020*a166);
  a173=(a173+a166);
  a173=(a203+a173);
  a166=(a017*a173);
  a211=(a211+a166);
  a211=(a108+a211);
  a211=(a119*a211);
  a130=(a130+a211);
  a211=(a032*a132);
  a130=(a130+a211);
  a211=(a014*a130);
  a186=(a186+a211);
  a152=(a026*a152);
  a211=(a028*a203);
  a173=(a030*a173);
  a211=(a211+a173);
  a173=(a015*a195);
  a138=(a164*a138);
  a166=(a018*a203);
  a111=(a021*a195);
  a111=(a203+a111);
  a111=(a020*a111);
  a166=(a166+a111);
  a166=(a108+a166);
  a166=(a133*a166);
  a138=(a138+a166);
  a182=(a019*a182);
  a138=(a138+a182);
  a182=(a017*a138);
  a173=(a173+a182);
  a173=(a203+a173);
  a182=(a031*a173);
  a211=(a211+a182);
  a211=(a108+a211);
  a211=(a131*a211);
  a152=(a152+a211);
  a211=(a046*a198);
  a152=(a152+a211);
  a211=(a027*a152);
  a186=(a186+a211);
  a186=(a203+a186);
  a211=(a005*a186);
  a199=(a199+a211);
  a211=(a040*a195);
  a182=(a042*a130);
  a211=(a211+a182);
  a182=(a043*a152);
  a211=(a211+a182);
  a202=(a145*a202);
  a182=(a006*a203);
  a166=(a014*a173);
  a182=(a182+a166);
  a166=(a028*a195);
  a138=(a030*a138);
  a166=(a166+a138);
  a138=(a031*a130);
  a166=(a166+a138);
  a166=(a203+a166);
  a138=(a027*a166);
  a182=(a182+a138);
  a182=(a108+a182);
  a182=(a144*a182);
  a202=(a202+a182);
  a182=(a013*a171);
  a202=(a202+a182);
  a182=(a044*a202);
  a211=(a211+a182);
  a211=(a203+a211);
  a182=(a039*a211);
  a199=(a199+a182);
  a182=(a050*a195);
  a138=(a052*a130);
  a182=(a182+a138);
  a138=(a053*a152);
  a182=(a182+a138);
  a138=(a054*a202);
  a182=(a182+a138);
  a190=(a184*a190);
  a138=(a040*a203);
  a111=(a042*a173);
  a138=(a138+a111);
  a111=(a043*a166);
  a138=(a138+a111);
  a111=(a044*a186);
  a138=(a138+a111);
  a138=(a108+a138);
  a138=(a151*a138);
  a190=(a190+a138);
  a138=(a041*a157);
  a190=(a190+a138);
  a138=(a055*a190);
  a182=(a182+a138);
  a182=(a203+a182);
  a138=(a049*a182);
  a199=(a199+a138);
  a138=(a060*a195);
  a111=(a062*a130);
  a138=(a138+a111);
  a111=(a063*a152);
  a138=(a138+a111);
  a111=(a064*a202);
  a138=(a138+a111);
  a111=(a065*a190);
  a138=(a138+a111);
  a207=(a048*a207);
  a111=(a050*a203);
  a178=(a052*a173);
  a111=(a111+a178);
  a178=(a053*a166);
  a111=(a111+a178);
  a178=(a054*a186);
  a111=(a111+a178);
  a178=(a055*a211);
  a111=(a111+a178);
  a111=(a108+a111);
  a111=(a158*a111);
  a207=(a207+a111);
  a111=(a051*a194);
  a207=(a207+a111);
  a111=(a066*a207);
  a138=(a138+a111);
  a138=(a203+a138);
  a111=(a059*a138);
  a199=(a199+a111);
  a111=(a071*a195);
  a178=(a073*a130);
  a111=(a111+a178);
  a178=(a074*a152);
  a111=(a111+a178);
  a178=(a075*a202);
  a111=(a111+a178);
  a178=(a076*a190);
  a111=(a111+a178);
  a178=(a077*a207);
  a111=(a111+a178);
  a196=(a058*a196);
  a178=(a060*a203);
  a107=(a062*a173);
  a178=(a178+a107);
  a107=(a063*a166);
  a178=(a178+a107);
  a107=(a064*a186);
  a178=(a178+a107);
  a107=(a065*a211);
  a178=(a178+a107);
  a107=(a066*a182);
  a178=(a178+a107);
  a178=(a108+a178);
  a178=(a165*a178);
  a196=(a196+a178);
  a178=(a061*a156);
  a196=(a196+a178);
  a178=(a078*a196);
  a111=(a111+a178);
  a111=(a203+a111);
  a178=(a070*a111);
  a199=(a199+a178);
  a178=(a083*a195);
  a107=(a085*a130);
  a178=(a178+a107);
  a107=(a086*a152);
  a178=(a178+a107);
  a107=(a087*a202);
  a178=(a178+a107);
  a107=(a088*a190);
  a178=(a178+a107);
  a107=(a089*a207);
  a178=(a178+a107);
  a107=(a090*a196);
  a178=(a178+a107);
  a149=(a069*a149);
  a107=(a071*a203);
  a143=(a073*a173);
  a107=(a107+a143);
  a143=(a074*a166);
  a107=(a107+a143);
  a143=(a075*a186);
  a107=(a107+a143);
  a143=(a076*a211);
  a107=(a107+a143);
  a143=(a077*a182);
  a107=(a107+a143);
  a143=(a078*a138);
  a107=(a107+a143);
  a107=(a108+a107);
  a107=(a172*a107);
  a149=(a149+a107);
  a107=(a072*a200);
  a149=(a149+a107);
  a107=(a091*a149);
  a178=(a178+a107);
  a178=(a203+a178);
  a107=(a082*a178);
  a199=(a199+a107);
  a107=(a096*a195);
  a130=(a098*a130);
  a107=(a107+a130);
  a152=(a099*a152);
  a107=(a107+a152);
  a152=(a100*a202);
  a107=(a107+a152);
  a152=(a101*a190);
  a107=(a107+a152);
  a152=(a102*a207);
  a107=(a107+a152);
  a152=(a103*a196);
  a107=(a107+a152);
  a152=(a104*a149);
  a107=(a107+a152);
  a010=(a117*a010);
  a152=(a083*a203);
  a130=(a085*a173);
  a152=(a152+a130);
  a130=(a086*a166);
  a152=(a152+a130);
  a130=(a087*a186);
  a152=(a152+a130);
  a130=(a088*a211);
  a152=(a152+a130);
  a130=(a089*a182);
  a152=(a152+a130);
  a130=(a090*a138);
  a152=(a152+a130);
  a130=(a091*a111);
  a152=(a152+a130);
  a152=(a108+a152);
  a152=(a118*a152);
  a010=(a010+a152);
  a152=(a084*a188);
  a010=(a010+a152);
  a152=(a105*a010);
  a107=(a107+a152);
  a107=(a203+a107);
  a107=(a095*a107);
  a199=(a199+a107);
  a199=(a108+a199);
  if (res[0]!=0) res[0][9]=a199;
  a208=(a001*a208);
  a038=(a005*a038);
  a208=(a208+a038);
  a110=(a039*a110);
  a208=(a208+a110);
  a204=(a049*a204);
  a208=(a208+a204);
  a192=(a059*a192);
  a208=(a208+a192);
  a191=(a070*a191);
  a208=(a208+a191);
  a159=(a082*a159);
  a208=(a208+a159);
  a159=(a096*a214);
  a132=(a098*a132);
  a159=(a159+a132);
  a198=(a099*a198);
  a159=(a159+a198);
  a171=(a100*a171);
  a159=(a159+a171);
  a157=(a101*a157);
  a159=(a159+a157);
  a194=(a102*a194);
  a159=(a159+a194);
  a156=(a103*a156);
  a159=(a159+a156);
  a200=(a104*a200);
  a159=(a159+a200);
  a188=(a105*a188);
  a159=(a159+a188);
  a210=(a210+a159);
  a159=(a209*a210);
  a159=(a095*a159);
  a208=(a208+a159);
  a214=(a214+a208);
  if (res[0]!=0) res[0][10]=a214;
  a195=(a001*a195);
  a202=(a005*a202);
  a195=(a195+a202);
  a190=(a039*a190);
  a195=(a195+a190);
  a207=(a049*a207);
  a195=(a195+a207);
  a196=(a059*a196);
  a195=(a195+a196);
  a149=(a070*a149);
  a195=(a195+a149);
  a010=(a082*a010);
  a195=(a195+a010);
  a210=(a206*a210);
  a010=(a096*a203);
  a173=(a098*a173);
  a010=(a010+a173);
  a166=(a099*a166);
  a010=(a010+a166);
  a186=(a100*a186);
  a010=(a010+a186);
  a211=(a101*a211);
  a010=(a010+a211);
  a182=(a102*a182);
  a010=(a010+a182);
  a138=(a103*a138);
  a010=(a010+a138);
  a111=(a104*a111);
  a010=(a010+a111);
  a178=(a105*a178);
  a010=(a010+a178);
  a108=(a108+a010);
  a108=(a004*a108);
  a210=(a210+a108);
  a109=(a097*a109);
  a210=(a210+a109);
  a210=(a095*a210);
  a195=(a195+a210);
  a203=(a203+a195);
  if (res[0]!=0) res[0][11]=a203;
  a203=arg[0]? arg[0][12] : 0;
  a195=arg[0]? arg[0][14] : 0;
  a210=(a001*a195);
  a163=(a163*a203);
  a109=arg[6]? arg[6][0] : 0;
  a011=(a011*a109);
  a108=(a009*a011);
  a008=(a008*a109);
  a010=(a012*a008);
  a108=(a108+a010);
  a163=(a163-a108);
  a010=(a006*a163);
  a178=(a015*a195);
  a111=(a018*a163);
  a138=(a021*a195);
  a138=(a203+a138);
  a120=(a120*a138);
  a182=(a023*a011);
  a211=(a022*a008);
  a182=(a182+a211);
  a120=(a120-a182);
  a120=(a020*a120);
  a111=(a111+a120);
  a111=(a195+a111);
  a120=(a017*a111);
  a178=(a178+a120);
  a178=(a203+a178);
  a142=(a142*a178);
  a120=(a025*a011);
  a211=(a016*a008);
  a120=(a120+a211);
  a142=(a142-a120);
  a211=(a014*a142);
  a010=(a010+a211);
  a211=(a028*a195);
  a186=(a030*a111);
  a211=(a211+a186);
  a186=(a015*a163);
  a166=(a018*a195);
  a173=(a021*a163);
  a173=(a195+a173);
  a149=(a020*a173);
  a166=(a166+a149);
  a166=(a203+a166);
  a183=(a183*a166);
  a149=(a035*a011);
  a196=(a033*a008);
  a149=(a149+a196);
  a183=(a183-a149);
  a196=(a017*a183);
  a186=(a186+a196);
  a186=(a195+a186);
  a196=(a031*a186);
  a211=(a211+a196);
  a211=(a203+a211);
  a150=(a150*a211);
  a196=(a037*a011);
  a207=(a029*a008);
  a196=(a196+a207);
  a150=(a150-a196);
  a207=(a027*a150);
  a010=(a010+a207);
  a010=(a195+a010);
  a207=(a005*a010);
  a210=(a210+a207);
  a207=(a040*a163);
  a190=(a042*a142);
  a207=(a207+a190);
  a190=(a043*a150);
  a207=(a207+a190);
  a190=(a006*a195);
  a202=(a014*a186);
  a190=(a190+a202);
  a202=(a028*a163);
  a183=(a030*a183);
  a202=(a202+a183);
  a183=(a031*a142);
  a202=(a202+a183);
  a202=(a195+a202);
  a183=(a027*a202);
  a190=(a190+a183);
  a190=(a203+a190);
  a189=(a189*a190);
  a183=(a047*a011);
  a214=(a045*a008);
  a183=(a183+a214);
  a189=(a189-a183);
  a214=(a044*a189);
  a207=(a207+a214);
  a207=(a195+a207);
  a214=(a039*a207);
  a210=(a210+a214);
  a214=(a050*a163);
  a208=(a052*a142);
  a214=(a214+a208);
  a208=(a053*a150);
  a214=(a214+a208);
  a208=(a054*a189);
  a214=(a214+a208);
  a208=(a040*a195);
  a159=(a042*a186);
  a208=(a208+a159);
  a159=(a043*a202);
  a208=(a208+a159);
  a159=(a044*a010);
  a208=(a208+a159);
  a208=(a203+a208);
  a193=(a193*a208);
  a159=(a057*a011);
  a188=(a056*a008);
  a159=(a159+a188);
  a193=(a193-a159);
  a188=(a055*a193);
  a214=(a214+a188);
  a214=(a195+a214);
  a188=(a049*a214);
  a210=(a210+a188);
  a188=(a060*a163);
  a200=(a062*a142);
  a188=(a188+a200);
  a200=(a063*a150);
  a188=(a188+a200);
  a200=(a064*a189);
  a188=(a188+a200);
  a200=(a065*a193);
  a188=(a188+a200);
  a200=(a050*a195);
  a156=(a052*a186);
  a200=(a200+a156);
  a156=(a053*a202);
  a200=(a200+a156);
  a156=(a054*a010);
  a200=(a200+a156);
  a156=(a055*a207);
  a200=(a200+a156);
  a200=(a203+a200);
  a197=(a197*a200);
  a156=(a068*a011);
  a194=(a067*a008);
  a156=(a156+a194);
  a197=(a197-a156);
  a194=(a066*a197);
  a188=(a188+a194);
  a188=(a195+a188);
  a194=(a059*a188);
  a210=(a210+a194);
  a194=(a071*a163);
  a157=(a073*a142);
  a194=(a194+a157);
  a157=(a074*a150);
  a194=(a194+a157);
  a157=(a075*a189);
  a194=(a194+a157);
  a157=(a076*a193);
  a194=(a194+a157);
  a157=(a077*a197);
  a194=(a194+a157);
  a157=(a060*a195);
  a171=(a062*a186);
  a157=(a157+a171);
  a171=(a063*a202);
  a157=(a157+a171);
  a171=(a064*a010);
  a157=(a157+a171);
  a171=(a065*a207);
  a157=(a157+a171);
  a171=(a066*a214);
  a157=(a157+a171);
  a157=(a203+a157);
  a201=(a201*a157);
  a171=(a080*a011);
  a198=(a079*a008);
  a171=(a171+a198);
  a201=(a201-a171);
  a198=(a078*a201);
  a194=(a194+a198);
  a194=(a195+a194);
  a198=(a070*a194);
  a210=(a210+a198);
  a198=(a083*a163);
  a132=(a085*a142);
  a198=(a198+a132);
  a132=(a086*a150);
  a198=(a198+a132);
  a132=(a087*a189);
  a198=(a198+a132);
  a132=(a088*a193);
  a198=(a198+a132);
  a132=(a089*a197);
  a198=(a198+a132);
  a132=(a090*a201);
  a198=(a198+a132);
  a132=(a071*a195);
  a191=(a073*a186);
  a132=(a132+a191);
  a191=(a074*a202);
  a132=(a132+a191);
  a191=(a075*a010);
  a132=(a132+a191);
  a191=(a076*a207);
  a132=(a132+a191);
  a191=(a077*a214);
  a132=(a132+a191);
  a191=(a078*a188);
  a132=(a132+a191);
  a132=(a203+a132);
  a205=(a205*a132);
  a191=(a093*a011);
  a192=(a092*a008);
  a191=(a191+a192);
  a205=(a205-a191);
  a192=(a091*a205);
  a198=(a198+a192);
  a198=(a195+a198);
  a192=(a082*a198);
  a210=(a210+a192);
  a192=(a096*a163);
  a142=(a098*a142);
  a192=(a192+a142);
  a150=(a099*a150);
  a192=(a192+a150);
  a150=(a100*a189);
  a192=(a192+a150);
  a150=(a101*a193);
  a192=(a192+a150);
  a150=(a102*a197);
  a192=(a192+a150);
  a150=(a103*a201);
  a192=(a192+a150);
  a150=(a104*a205);
  a192=(a192+a150);
  a150=(a083*a195);
  a142=(a085*a186);
  a150=(a150+a142);
  a142=(a086*a202);
  a150=(a150+a142);
  a142=(a087*a010);
  a150=(a150+a142);
  a142=(a088*a207);
  a150=(a150+a142);
  a142=(a089*a214);
  a150=(a150+a142);
  a142=(a090*a188);
  a150=(a150+a142);
  a142=(a091*a194);
  a150=(a150+a142);
  a150=(a203+a150);
  a187=(a187*a150);
  a142=(a106*a011);
  a204=(a002*a008);
  a142=(a142+a204);
  a187=(a187-a142);
  a204=(a105*a187);
  a192=(a192+a204);
  a192=(a195+a192);
  a204=(a095*a192);
  a210=(a210+a204);
  a210=(a203+a210);
  if (res[0]!=0) res[0][12]=a210;
  a210=arg[0]? arg[0][13] : 0;
  a204=arg[0]? arg[0][15] : 0;
  a110=(a001*a204);
  a213=(a213*a203);
  a114=(a114*a210);
  a213=(a213+a114);
  a003=(a003*a195);
  a213=(a213+a003);
  a116=(a116*a108);
  a112=(a112*a109);
  a009=(a009*a112);
  a113=(a113*a109);
  a012=(a012*a113);
  a009=(a009+a012);
  a116=(a116-a009);
  a213=(a213+a116);
  a116=(a006*a213);
  a212=(a212*a178);
  a178=(a015*a204);
  a009=(a018*a213);
  a216=(a216*a138);
  a138=(a021*a204);
  a138=(a210+a138);
  a122=(a122*a138);
  a216=(a216+a122);
  a034=(a034*a173);
  a216=(a216+a034);
  a126=(a126*a182);
  a124=(a124*a109);
  a023=(a023*a124);
  a125=(a125*a109);
  a022=(a022*a125);
  a023=(a023+a022);
  a126=(a126-a023);
  a216=(a216+a126);
  a216=(a020*a216);
  a009=(a009+a216);
  a009=(a204+a009);
  a216=(a017*a009);
  a178=(a178+a216);
  a178=(a210+a178);
  a119=(a119*a178);
  a212=(a212+a119);
  a032=(a032*a186);
  a212=(a212+a032);
  a129=(a129*a120);
  a127=(a127*a109);
  a025=(a025*a127);
  a128=(a128*a109);
  a016=(a016*a128);
  a025=(a025+a016);
  a129=(a129-a025);
  a212=(a212+a129);
  a129=(a014*a212);
  a116=(a116+a129);
  a026=(a026*a211);
  a211=(a028*a204);
  a009=(a030*a009);
  a211=(a211+a009);
  a015=(a015*a213);
  a164=(a164*a166);
  a018=(a018*a204);
  a021=(a021*a213);
  a021=(a204+a021);
  a020=(a020*a021);
  a018=(a018+a020);
  a018=(a210+a018);
  a133=(a133*a018);
  a164=(a164+a133);
  a019=(a019*a111);
  a164=(a164+a019);
  a137=(a137*a149);
  a135=(a135*a109);
  a035=(a035*a135);
  a136=(a136*a109);
  a033=(a033*a136);
  a035=(a035+a033);
  a137=(a137-a035);
  a164=(a164+a137);
  a017=(a017*a164);
  a015=(a015+a017);
  a015=(a204+a015);
  a017=(a031*a015);
  a211=(a211+a017);
  a211=(a210+a211);
  a131=(a131*a211);
  a026=(a026+a131);
  a046=(a046*a202);
  a026=(a026+a046);
  a141=(a141*a196);
  a139=(a139*a109);
  a037=(a037*a139);
  a140=(a140*a109);
  a029=(a029*a140);
  a037=(a037+a029);
  a141=(a141-a037);
  a026=(a026+a141);
  a141=(a027*a026);
  a116=(a116+a141);
  a116=(a204+a116);
  a141=(a005*a116);
  a110=(a110+a141);
  a141=(a040*a213);
  a037=(a042*a212);
  a141=(a141+a037);
  a037=(a043*a026);
  a141=(a141+a037);
  a145=(a145*a190);
  a006=(a006*a204);
  a014=(a014*a015);
  a006=(a006+a014);
  a028=(a028*a213);
  a030=(a030*a164);
  a028=(a028+a030);
  a031=(a031*a212);
  a028=(a028+a031);
  a028=(a204+a028);
  a027=(a027*a028);
  a006=(a006+a027);
  a006=(a210+a006);
  a144=(a144*a006);
  a145=(a145+a144);
  a013=(a013*a010);
  a145=(a145+a013);
  a148=(a148*a183);
  a146=(a146*a109);
  a047=(a047*a146);
  a147=(a147*a109);
  a045=(a045*a147);
  a047=(a047+a045);
  a148=(a148-a047);
  a145=(a145+a148);
  a148=(a044*a145);
  a141=(a141+a148);
  a141=(a204+a141);
  a148=(a039*a141);
  a110=(a110+a148);
  a148=(a050*a213);
  a047=(a052*a212);
  a148=(a148+a047);
  a047=(a053*a026);
  a148=(a148+a047);
  a047=(a054*a145);
  a148=(a148+a047);
  a184=(a184*a208);
  a040=(a040*a204);
  a042=(a042*a015);
  a040=(a040+a042);
  a043=(a043*a028);
  a040=(a040+a043);
  a044=(a044*a116);
  a040=(a040+a044);
  a040=(a210+a040);
  a151=(a151*a040);
  a184=(a184+a151);
  a041=(a041*a207);
  a184=(a184+a041);
  a155=(a155*a159);
  a153=(a153*a109);
  a057=(a057*a153);
  a154=(a154*a109);
  a056=(a056*a154);
  a057=(a057+a056);
  a155=(a155-a057);
  a184=(a184+a155);
  a155=(a055*a184);
  a148=(a148+a155);
  a148=(a204+a148);
  a155=(a049*a148);
  a110=(a110+a155);
  a155=(a060*a213);
  a057=(a062*a212);
  a155=(a155+a057);
  a057=(a063*a026);
  a155=(a155+a057);
  a057=(a064*a145);
  a155=(a155+a057);
  a057=(a065*a184);
  a155=(a155+a057);
  a048=(a048*a200);
  a050=(a050*a204);
  a052=(a052*a015);
  a050=(a050+a052);
  a053=(a053*a028);
  a050=(a050+a053);
  a054=(a054*a116);
  a050=(a050+a054);
  a055=(a055*a141);
  a050=(a050+a055);
  a050=(a210+a050);
  a158=(a158*a050);
  a048=(a048+a158);
  a051=(a051*a214);
  a048=(a048+a051);
  a162=(a162*a156);
  a160=(a160*a109);
  a068=(a068*a160);
  a161=(a161*a109);
  a067=(a067*a161);
  a068=(a068+a067);
  a162=(a162-a068);
  a048=(a048+a162);
  a162=(a066*a048);
  a155=(a155+a162);
  a155=(a204+a155);
  a162=(a059*a155);
  a110=(a110+a162);
  a162=(a071*a213);
  a068=(a073*a212);
  a162=(a162+a068);
  a068=(a074*a026);
  a162=(a162+a068);
  a068=(a075*a145);
  a162=(a162+a068);
  a068=(a076*a184);
  a162=(a162+a068);
  a068=(a077*a048);
  a162=(a162+a068);
  a058=(a058*a157);
  a060=(a060*a204);
  a062=(a062*a015);
  a060=(a060+a062);
  a063=(a063*a028);
  a060=(a060+a063);
  a064=(a064*a116);
  a060=(a060+a064);
  a065=(a065*a141);
  a060=(a060+a065);
  a066=(a066*a148);
  a060=(a060+a066);
  a060=(a210+a060);
  a165=(a165*a060);
  a058=(a058+a165);
  a061=(a061*a188);
  a058=(a058+a061);
  a169=(a169*a171);
  a167=(a167*a109);
  a080=(a080*a167);
  a168=(a168*a109);
  a079=(a079*a168);
  a080=(a080+a079);
  a169=(a169-a080);
  a058=(a058+a169);
  a169=(a078*a058);
  a162=(a162+a169);
  a162=(a204+a162);
  a169=(a070*a162);
  a110=(a110+a169);
  a169=(a083*a213);
  a080=(a085*a212);
  a169=(a169+a080);
  a080=(a086*a026);
  a169=(a169+a080);
  a080=(a087*a145);
  a169=(a169+a080);
  a080=(a088*a184);
  a169=(a169+a080);
  a080=(a089*a048);
  a169=(a169+a080);
  a080=(a090*a058);
  a169=(a169+a080);
  a069=(a069*a132);
  a071=(a071*a204);
  a073=(a073*a015);
  a071=(a071+a073);
  a074=(a074*a028);
  a071=(a071+a074);
  a075=(a075*a116);
  a071=(a071+a075);
  a076=(a076*a141);
  a071=(a071+a076);
  a077=(a077*a148);
  a071=(a071+a077);
  a078=(a078*a155);
  a071=(a071+a078);
  a071=(a210+a071);
  a172=(a172*a071);
  a069=(a069+a172);
  a072=(a072*a194);
  a069=(a069+a072);
  a176=(a176*a191);
  a174=(a174*a109);
  a093=(a093*a174);
  a175=(a175*a109);
  a092=(a092*a175);
  a093=(a093+a092);
  a176=(a176-a093);
  a069=(a069+a176);
  a176=(a091*a069);
  a169=(a169+a176);
  a169=(a204+a169);
  a176=(a082*a169);
  a110=(a110+a176);
  a176=(a096*a213);
  a212=(a098*a212);
  a176=(a176+a212);
  a026=(a099*a026);
  a176=(a176+a026);
  a026=(a100*a145);
  a176=(a176+a026);
  a026=(a101*a184);
  a176=(a176+a026);
  a026=(a102*a048);
  a176=(a176+a026);
  a026=(a103*a058);
  a176=(a176+a026);
  a026=(a104*a069);
  a176=(a176+a026);
  a117=(a117*a150);
  a083=(a083*a204);
  a085=(a085*a015);
  a083=(a083+a085);
  a086=(a086*a028);
  a083=(a083+a086);
  a087=(a087*a116);
  a083=(a083+a087);
  a088=(a088*a141);
  a083=(a083+a088);
  a089=(a089*a148);
  a083=(a083+a089);
  a090=(a090*a155);
  a083=(a083+a090);
  a091=(a091*a162);
  a083=(a083+a091);
  a083=(a210+a083);
  a118=(a118*a083);
  a117=(a117+a118);
  a084=(a084*a198);
  a117=(a117+a084);
  a181=(a181*a142);
  a179=(a179*a109);
  a106=(a106*a179);
  a180=(a180*a109);
  a002=(a002*a180);
  a106=(a106+a002);
  a181=(a181-a106);
  a117=(a117+a181);
  a181=(a105*a117);
  a176=(a176+a181);
  a176=(a204+a176);
  a176=(a095*a176);
  a110=(a110+a176);
  a110=(a210+a110);
  if (res[0]!=0) res[0][13]=a110;
  a163=(a001*a163);
  a189=(a005*a189);
  a163=(a163+a189);
  a193=(a039*a193);
  a163=(a163+a193);
  a197=(a049*a197);
  a163=(a163+a197);
  a201=(a059*a201);
  a163=(a163+a201);
  a205=(a070*a205);
  a163=(a163+a205);
  a187=(a082*a187);
  a163=(a163+a187);
  a187=(a096*a195);
  a186=(a098*a186);
  a187=(a187+a186);
  a202=(a099*a202);
  a187=(a187+a202);
  a010=(a100*a010);
  a187=(a187+a010);
  a207=(a101*a207);
  a187=(a187+a207);
  a214=(a102*a214);
  a187=(a187+a214);
  a188=(a103*a188);
  a187=(a187+a188);
  a194=(a104*a194);
  a187=(a187+a194);
  a198=(a105*a198);
  a187=(a187+a198);
  a203=(a203+a187);
  a209=(a209*a203);
  a011=(a177*a011);
  a008=(a000*a008);
  a011=(a011+a008);
  a209=(a209-a011);
  a209=(a095*a209);
  a163=(a163+a209);
  a195=(a195+a163);
  if (res[0]!=0) res[0][14]=a195;
  a001=(a001*a213);
  a005=(a005*a145);
  a001=(a001+a005);
  a039=(a039*a184);
  a001=(a001+a039);
  a049=(a049*a048);
  a001=(a001+a049);
  a059=(a059*a058);
  a001=(a001+a059);
  a070=(a070*a069);
  a001=(a001+a070);
  a082=(a082*a117);
  a001=(a001+a082);
  a206=(a206*a203);
  a096=(a096*a204);
  a098=(a098*a015);
  a096=(a096+a098);
  a099=(a099*a028);
  a096=(a096+a099);
  a100=(a100*a116);
  a096=(a096+a100);
  a101=(a101*a141);
  a096=(a096+a101);
  a102=(a102*a148);
  a096=(a096+a102);
  a103=(a103*a155);
  a096=(a096+a103);
  a104=(a104*a162);
  a096=(a096+a104);
  a105=(a105*a169);
  a096=(a096+a105);
  a210=(a210+a096);
  a004=(a004*a210);
  a206=(a206+a004);
  a097=(a097*a192);
  a206=(a206+a097);
  a115=(a115*a011);
  a007=(a007*a109);
  a177=(a177*a007);
  a170=(a170*a109);
  a000=(a000*a170);
  a177=(a177+a000);
  a115=(a115-a177);
  a206=(a206+a115);
  a095=(a095*a206);
  a001=(a001+a095);
  a204=(a204+a001);
  if (res[0]!=0) res[0][15]=a204;
  return 0;
}

/* step_alongs:(y[4x4],t,turns[2x12],h,p,d)->(y_end[4x4]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+217, w1, w2, *w3=w+233, w5, w6, *w7=w+235, w8;
  const casadi_real **arg1=arg+6, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  w2 = arg[4] ? arg[4][0] : 0;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  wr4 = arg[2] ? arg[2] : casadi_zeros;
  /* #5: @5 = input[3][0] */
  w5 = arg[3] ? arg[3][0] : 0;
  /* #6: @6 = input[5][0] */
  w6 = arg[5] ? arg[5][0] : 0;
  /* #7: @7 = step_along(@0, @3, @4, @5, @2, @1, @6) */
  arg1[0]=wr0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w1);
  arg1[6]=(&w6);
  res1[0]=w7;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #8: @8 = (@1+@5) */
  w8  = (w1+w5);
  /* #9: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #10: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #11: @8 = (2.*@5) */
  w8 = (2.* w5 );
  /* #12: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #13: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #14: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #29: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #39: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #44: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #49: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w8);
  arg1[6]=(&w6);
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
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #59: @0 = step_along(@7, @3, @4, @5, @2, @1, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=(&w2);
  arg1[5]=(&w1);
  arg1[6]=(&w6);
  res1[0]=w0;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  return 0;
}

/* landing_along:(y[4x4],z[2],T,p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[0]? arg[0][1] : 0;
  a04=cos(a02);
  a05=arg[0]? arg[0][6] : 0;
  a05=(a04*a05);
  a06=arg[0]? arg[0][2] : 0;
  a07=sin(a02);
  a08=(a06*a07);
  a09=(a08*a01);
  a05=(a05-a09);
  if (res[0]!=0) res[0][1]=a05;
  a05=-2.;
  a00=(a05*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][2]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a09=(a00-a01);
  if (res[0]!=0) res[0][3]=a09;
  a09=arg[0]? arg[0][10] : 0;
  a09=(a04*a09);
  a10=(a08*a01);
  a09=(a09-a10);
  a09=(a09-a03);
  if (res[0]!=0) res[0][4]=a09;
  a00=(a05*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][5]=a00;
  a00=arg[0]? arg[0][3] : 0;
  a01=(a06-a00);
  if (res[0]!=0) res[0][6]=a01;
  a08=(a08*a00);
  a01=arg[3]? arg[3][0] : 0;
  a09=arg[0]? arg[0][0] : 0;
  a01=(a01-a09);
  a01=sin(a01);
  a01=(a04*a01);
  a08=(a08+a01);
  a08=(-a08);
  if (res[0]!=0) res[0][7]=a08;
  a05=(a05*a06);
  a05=(a05+a00);
  if (res[0]!=0) res[0][8]=a05;
  a05=arg[0]? arg[0][12] : 0;
  a00=arg[0]? arg[0][13] : 0;
  a08=(a05-a00);
  if (res[1]!=0) res[1][0]=a08;
  a08=arg[0]? arg[0][14] : 0;
  a08=(a04*a08);
  a07=(a07*a00);
  a07=(a06*a07);
  a08=(a08-a07);
  if (res[1]!=0) res[1][1]=a08;
  a05=(2.*a05);
  a00=(a00-a05);
  if (res[1]!=0) res[1][2]=a00;
  a00=(a09-a02);
  a05=arg[1]? arg[1][0] : 0;
  a00=(a00-a05);
  if (res[2]!=0) res[2][0]=a00;
  a04=(a04*a06);
  a06=arg[1]? arg[1][1] : 0;
  a04=(a04-a06);
  if (res[2]!=0) res[2][1]=a04;
  a09=(2.*a09);
  a02=(a02-a09);
  if (res[2]!=0) res[2][2]=a02;
  return 0;
}

/* simplest_walker_jacobian_along_12:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 12 */
  w07 = 12.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@10, @0, @11} = landing_along(@9, @1, @6, @2, @3) */
  arg1[0]=w09;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #14: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_12_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_12_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_24:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 24 */
  w07 = 24.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #17: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_24_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_36:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 36 */
  w07 = 36.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w09;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@10, @0, @11} = landing_along(@9, @1, @6, @2, @3) */
  arg1[0]=w09;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #20: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_36_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_48:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 48 */
  w07 = 48.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #23: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_48_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_72:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 72 */
  w07 = 72.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #29: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_72_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_96:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 96 */
  w07 = 96.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #35: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_96_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_144:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 144 */
  w07 = 144.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #47: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_144_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_192:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 192 */
  w07 = 192.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #59: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_192_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_288:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 288 */
  w07 = 288.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #83: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_288_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_jacobian_along_384:(u[3],p,d)->(J[3x3],R_d[3],R[3]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+280, *w01=w+283, w02, w03, *w04=w+285, w05, w06, w07, *w08=w+301, *w09=w+325;
  casadi_real *w10=w+341, *w11=w+350;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w02 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[2][0] */
  w03 = arg[2] ? arg[2][0] : 0;
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=(&w02);
  arg1[2]=(&w03);
  res1[0]=w04;
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = 0 */
  w05 = 0.;
  /* #6: @6 = @0[2] */
  for (rr=(&w06), cs=w00+2; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #7: @7 = 384 */
  w07 = 384.;
  /* #8: @7 = (@6/@7) */
  w07  = (w06/w07);
  /* #9: @8 = turns(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w08;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
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
  arg1[4]=(&w02);
  arg1[5]=(&w03);
  res1[0]=w04;
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=(&w02);
  arg1[4]=(&w03);
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f90(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #107: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_jacobian_along_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_384_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_jacobian_along_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_jacobian_along_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_jacobian_along_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_jacobian_along_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 353;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_jacobian_along_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 353*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[4],phase[2],turns[2x12],h,p)->(y_end[4]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116;
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
  a007=arg[4]? arg[4][0] : 0;
  a008=sin(a007);
  a009=cos(a000);
  a010=(a008*a009);
  a011=cos(a007);
  a012=sin(a000);
  a013=(a011*a012);
  a010=(a010-a013);
  a013=(a006*a010);
  a014=1.7082860872947386e-01;
  a014=(a014*a002);
  a015=2.9587585476806851e-02;
  a015=(a015*a002);
  a016=(a015*a003);
  a017=8.8762756430420545e-02;
  a017=(a017*a002);
  a018=1.9725056984537900e-02;
  a018=(a018*a002);
  a019=(a018*a010);
  a020=5.9175170953613701e-02;
  a020=(a020*a002);
  a021=5.2600151958767730e-02;
  a021=(a021*a002);
  a022=(a021*a003);
  a022=(a000+a022);
  a023=cos(a022);
  a024=(a008*a023);
  a022=sin(a022);
  a025=(a011*a022);
  a024=(a024-a025);
  a025=(a020*a024);
  a019=(a019+a025);
  a019=(a003-a019);
  a025=(a017*a019);
  a016=(a016+a025);
  a016=(a000+a016);
  a025=cos(a016);
  a026=(a008*a025);
  a016=sin(a016);
  a027=(a011*a016);
  a026=(a026-a027);
  a027=(a014*a026);
  a013=(a013+a027);
  a027=1.2546768756682242e-01;
  a027=(a027*a002);
  a028=2.4136513415926669e-01;
  a028=(a028*a002);
  a029=(a028*a003);
  a030=-8.8454947932828609e-01;
  a030=(a030*a002);
  a031=(a030*a019);
  a029=(a029+a031);
  a031=9.2483400326179199e-01;
  a031=(a031*a002);
  a032=(a015*a010);
  a033=(a018*a003);
  a034=(a021*a010);
  a034=(a003-a034);
  a035=(a020*a034);
  a033=(a033+a035);
  a033=(a000+a033);
  a035=cos(a033);
  a036=(a008*a035);
  a033=sin(a033);
  a037=(a011*a033);
  a036=(a036-a037);
  a037=(a017*a036);
  a032=(a032+a037);
  a032=(a003-a032);
  a037=(a031*a032);
  a029=(a029+a037);
  a029=(a000+a029);
  a037=cos(a029);
  a038=(a008*a037);
  a029=sin(a029);
  a039=(a011*a029);
  a038=(a038-a039);
  a039=(a027*a038);
  a013=(a013+a039);
  a013=(a003-a013);
  a039=(a005*a013);
  a004=(a004+a039);
  a039=1.8915178993145003e+00;
  a039=(a039*a002);
  a040=3.7109375000000000e-02;
  a040=(a040*a002);
  a041=(a040*a010);
  a042=1.7025221101954405e-01;
  a042=(a042*a002);
  a043=(a042*a026);
  a041=(a041+a043);
  a043=6.0216538980455959e-02;
  a043=(a043*a002);
  a044=(a043*a038);
  a041=(a041+a044);
  a044=-1.7578125000000000e-02;
  a044=(a044*a002);
  a045=(a006*a003);
  a046=(a014*a032);
  a045=(a045+a046);
  a046=(a028*a010);
  a047=(a030*a036);
  a046=(a046+a047);
  a047=(a031*a026);
  a046=(a046+a047);
  a046=(a003-a046);
  a047=(a027*a046);
  a045=(a045+a047);
  a045=(a000+a045);
  a047=cos(a045);
  a048=(a008*a047);
  a045=sin(a045);
  a049=(a011*a045);
  a048=(a048-a049);
  a049=(a044*a048);
  a041=(a041+a049);
  a041=(a003-a041);
  a049=(a039*a041);
  a004=(a004+a049);
  a049=-5.8012039600105849e+00;
  a049=(a049*a002);
  a050=3.7092000118504789e-02;
  a050=(a050*a002);
  a051=(a050*a010);
  a052=1.7038392571223998e-01;
  a052=(a052*a002);
  a053=(a052*a026);
  a051=(a051+a053);
  a053=1.0726203044637328e-01;
  a053=(a053*a002);
  a054=(a053*a038);
  a051=(a051+a054);
  a054=-1.5319437748624402e-02;
  a054=(a054*a002);
  a055=(a054*a048);
  a051=(a051+a055);
  a055=8.2737891638140233e-03;
  a055=(a055*a002);
  a056=(a040*a003);
  a057=(a042*a032);
  a056=(a056+a057);
  a057=(a043*a046);
  a056=(a056+a057);
  a057=(a044*a013);
  a056=(a056+a057);
  a056=(a000+a056);
  a057=cos(a056);
  a058=(a008*a057);
  a056=sin(a056);
  a059=(a011*a056);
  a058=(a058-a059);
  a059=(a055*a058);
  a051=(a051+a059);
  a051=(a003-a051);
  a059=(a049*a051);
  a004=(a004+a059);
  a059=3.1116436695781990e-01;
  a059=(a059*a002);
  a060=6.2411095871607569e-01;
  a060=(a060*a002);
  a061=(a060*a010);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a063=(a062*a026);
  a061=(a061+a063);
  a063=-8.6821934684172597e-01;
  a063=(a063*a002);
  a064=(a063*a038);
  a061=(a061+a064);
  a064=2.7592099699446710e+01;
  a064=(a064*a002);
  a065=(a064*a048);
  a061=(a061+a065);
  a065=2.0154067550477894e+01;
  a065=(a065*a002);
  a066=(a065*a058);
  a061=(a061+a066);
  a066=-4.3489884181069961e+01;
  a066=(a066*a002);
  a067=(a050*a003);
  a068=(a052*a032);
  a067=(a067+a068);
  a068=(a053*a046);
  a067=(a067+a068);
  a068=(a054*a013);
  a067=(a067+a068);
  a068=(a055*a041);
  a067=(a067+a068);
  a067=(a000+a067);
  a068=cos(a067);
  a069=(a008*a068);
  a067=sin(a067);
  a070=(a011*a067);
  a069=(a069-a070);
  a070=(a066*a069);
  a061=(a061+a070);
  a061=(a003-a061);
  a070=(a059*a061);
  a004=(a004+a070);
  a070=-1.5216094966251609e-01;
  a070=(a070*a002);
  a071=4.7766253643826434e-01;
  a071=(a071*a002);
  a072=(a071*a010);
  a073=-2.4881146199716677e+00;
  a073=(a073*a002);
  a074=(a073*a026);
  a072=(a072+a074);
  a074=-5.9029082683684297e-01;
  a074=(a074*a002);
  a075=(a074*a038);
  a072=(a072+a075);
  a075=2.1230051448181193e+01;
  a075=(a075*a002);
  a076=(a075*a048);
  a072=(a072+a076);
  a076=1.5279233632882423e+01;
  a076=(a076*a002);
  a077=(a076*a058);
  a072=(a072+a077);
  a077=-3.3288210968984863e+01;
  a077=(a077*a002);
  a078=(a077*a069);
  a072=(a072+a078);
  a078=-2.0331201708508627e-02;
  a078=(a078*a002);
  a079=(a060*a003);
  a080=(a062*a032);
  a079=(a079+a080);
  a080=(a063*a046);
  a079=(a079+a080);
  a080=(a064*a013);
  a079=(a079+a080);
  a080=(a065*a041);
  a079=(a079+a080);
  a080=(a066*a051);
  a079=(a079+a080);
  a079=(a000+a079);
  a080=cos(a079);
  a081=(a008*a080);
  a079=sin(a079);
  a082=(a011*a079);
  a081=(a081-a082);
  a082=(a078*a081);
  a072=(a072+a082);
  a072=(a003-a072);
  a082=(a070*a072);
  a004=(a004+a082);
  a082=2.0136540080403034e-01;
  a082=(a082*a002);
  a083=-9.3714243008598730e-01;
  a083=(a083*a002);
  a084=(a083*a010);
  a085=5.1863724288440638e+00;
  a085=(a085*a002);
  a086=(a085*a026);
  a084=(a084+a086);
  a086=1.0914373489967295e+00;
  a086=(a086*a002);
  a087=(a086*a038);
  a084=(a084+a087);
  a087=-8.1497870107469268e+00;
  a087=(a087*a002);
  a088=(a087*a048);
  a084=(a084+a088);
  a088=-1.8520065659996959e+01;
  a088=(a088*a002);
  a089=(a088*a058);
  a084=(a084+a089);
  a089=2.2739487099350505e+01;
  a089=(a089*a002);
  a090=(a089*a069);
  a084=(a084+a090);
  a090=2.4936055526796523e+00;
  a090=(a090*a002);
  a091=(a090*a081);
  a084=(a084+a091);
  a091=-3.0467644718982196e+00;
  a091=(a091*a002);
  a092=(a071*a003);
  a093=(a073*a032);
  a092=(a092+a093);
  a093=(a074*a046);
  a092=(a092+a093);
  a093=(a075*a013);
  a092=(a092+a093);
  a093=(a076*a041);
  a092=(a092+a093);
  a093=(a077*a051);
  a092=(a092+a093);
  a093=(a078*a061);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=cos(a092);
  a094=(a008*a093);
  a092=sin(a092);
  a095=(a011*a092);
  a094=(a094-a095);
  a095=(a091*a094);
  a084=(a084+a095);
  a084=(a003-a084);
  a095=(a082*a084);
  a004=(a004+a095);
  a095=4.4710615727772587e-02;
  a095=(a095*a002);
  a096=2.2733101475165380e+00;
  a096=(a096*a002);
  a097=(a096*a010);
  a098=-1.0534495466737249e+01;
  a098=(a098*a002);
  a099=(a098*a026);
  a097=(a097+a099);
  a099=-2.0008720582248625e+00;
  a099=(a099*a002);
  a100=(a099*a038);
  a097=(a097+a100);
  a100=-1.7958931863118799e+01;
  a100=(a100*a002);
  a101=(a100*a048);
  a097=(a097+a101);
  a101=2.7948884529419960e+01;
  a101=(a101*a002);
  a102=(a101*a058);
  a097=(a097+a102);
  a102=-2.8589982771350235e+00;
  a102=(a102*a002);
  a103=(a102*a069);
  a097=(a097+a103);
  a103=-8.8728569335306293e+00;
  a103=(a103*a002);
  a104=(a103*a081);
  a097=(a097+a104);
  a104=1.2360567175794303e+01;
  a104=(a104*a002);
  a105=(a104*a094);
  a097=(a097+a105);
  a105=6.4339274601576357e-01;
  a105=(a105*a002);
  a002=(a083*a003);
  a106=(a085*a032);
  a002=(a002+a106);
  a106=(a086*a046);
  a002=(a002+a106);
  a106=(a087*a013);
  a002=(a002+a106);
  a106=(a088*a041);
  a002=(a002+a106);
  a106=(a089*a051);
  a002=(a002+a106);
  a106=(a090*a061);
  a002=(a002+a106);
  a106=(a091*a072);
  a002=(a002+a106);
  a002=(a000+a002);
  a106=cos(a002);
  a107=(a008*a106);
  a002=sin(a002);
  a108=(a011*a002);
  a107=(a107-a108);
  a108=(a105*a107);
  a097=(a097+a108);
  a097=(a003-a097);
  a108=(a095*a097);
  a004=(a004+a108);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=arg[0]? arg[0][1] : 0;
  a108=arg[0]? arg[0][3] : 0;
  a109=(a001*a108);
  a110=casadi_sq(a003);
  a111=sin(a004);
  a110=(a110*a111);
  a111=(a004+a007);
  a112=sin(a111);
  a112=(a112*a009);
  a111=cos(a111);
  a111=(a111*a012);
  a112=(a112-a111);
  a110=(a110-a112);
  a112=cos(a004);
  a111=1.;
  a112=(a112-a111);
  a112=(a112*a010);
  a110=(a110+a112);
  a112=(a006*a110);
  a012=casadi_sq(a032);
  a009=(a015*a108);
  a113=(a018*a110);
  a034=casadi_sq(a034);
  a114=(a021*a108);
  a114=(a004+a114);
  a115=sin(a114);
  a034=(a034*a115);
  a115=(a114+a007);
  a116=sin(a115);
  a116=(a116*a023);
  a115=cos(a115);
  a115=(a115*a022);
  a116=(a116-a115);
  a034=(a034-a116);
  a114=cos(a114);
  a114=(a114-a111);
  a114=(a114*a024);
  a034=(a034+a114);
  a034=(a020*a034);
  a113=(a113+a034);
  a113=(a108+a113);
  a034=(a017*a113);
  a009=(a009+a034);
  a009=(a004+a009);
  a034=sin(a009);
  a012=(a012*a034);
  a034=(a009+a007);
  a114=sin(a034);
  a114=(a114*a025);
  a034=cos(a034);
  a034=(a034*a016);
  a114=(a114-a034);
  a012=(a012-a114);
  a009=cos(a009);
  a009=(a009-a111);
  a009=(a009*a026);
  a012=(a012+a009);
  a009=(a014*a012);
  a112=(a112+a009);
  a009=casadi_sq(a046);
  a026=(a028*a108);
  a113=(a030*a113);
  a026=(a026+a113);
  a015=(a015*a110);
  a019=casadi_sq(a019);
  a018=(a018*a108);
  a021=(a021*a110);
  a021=(a108+a021);
  a020=(a020*a021);
  a018=(a018+a020);
  a018=(a004+a018);
  a020=sin(a018);
  a019=(a019*a020);
  a020=(a018+a007);
  a021=sin(a020);
  a021=(a021*a035);
  a020=cos(a020);
  a020=(a020*a033);
  a021=(a021-a020);
  a019=(a019-a021);
  a018=cos(a018);
  a018=(a018-a111);
  a018=(a018*a036);
  a019=(a019+a018);
  a017=(a017*a019);
  a015=(a015+a017);
  a015=(a108+a015);
  a017=(a031*a015);
  a026=(a026+a017);
  a026=(a004+a026);
  a017=sin(a026);
  a009=(a009*a017);
  a017=(a026+a007);
  a018=sin(a017);
  a018=(a018*a037);
  a017=cos(a017);
  a017=(a017*a029);
  a018=(a018-a017);
  a009=(a009-a018);
  a026=cos(a026);
  a026=(a026-a111);
  a026=(a026*a038);
  a009=(a009+a026);
  a026=(a027*a009);
  a112=(a112+a026);
  a112=(a108+a112);
  a026=(a005*a112);
  a109=(a109+a026);
  a026=(a040*a110);
  a038=(a042*a012);
  a026=(a026+a038);
  a038=(a043*a009);
  a026=(a026+a038);
  a038=casadi_sq(a013);
  a006=(a006*a108);
  a014=(a014*a015);
  a006=(a006+a014);
  a028=(a028*a110);
  a030=(a030*a019);
  a028=(a028+a030);
  a031=(a031*a012);
  a028=(a028+a031);
  a028=(a108+a028);
  a027=(a027*a028);
  a006=(a006+a027);
  a006=(a004+a006);
  a027=sin(a006);
  a038=(a038*a027);
  a027=(a006+a007);
  a031=sin(a027);
  a031=(a031*a047);
  a027=cos(a027);
  a027=(a027*a045);
  a031=(a031-a027);
  a038=(a038-a031);
  a006=cos(a006);
  a006=(a006-a111);
  a006=(a006*a048);
  a038=(a038+a006);
  a006=(a044*a038);
  a026=(a026+a006);
  a026=(a108+a026);
  a006=(a039*a026);
  a109=(a109+a006);
  a006=(a050*a110);
  a031=(a052*a012);
  a006=(a006+a031);
  a031=(a053*a009);
  a006=(a006+a031);
  a031=(a054*a038);
  a006=(a006+a031);
  a031=casadi_sq(a041);
  a040=(a040*a108);
  a042=(a042*a015);
  a040=(a040+a042);
  a043=(a043*a028);
  a040=(a040+a043);
  a044=(a044*a112);
  a040=(a040+a044);
  a040=(a004+a040);
  a044=sin(a040);
  a031=(a031*a044);
  a044=(a040+a007);
  a043=sin(a044);
  a043=(a043*a057);
  a044=cos(a044);
  a044=(a044*a056);
  a043=(a043-a044);
  a031=(a031-a043);
  a040=cos(a040);
  a040=(a040-a111);
  a040=(a040*a058);
  a031=(a031+a040);
  a040=(a055*a031);
  a006=(a006+a040);
  a006=(a108+a006);
  a040=(a049*a006);
  a109=(a109+a040);
  a040=(a060*a110);
  a043=(a062*a012);
  a040=(a040+a043);
  a043=(a063*a009);
  a040=(a040+a043);
  a043=(a064*a038);
  a040=(a040+a043);
  a043=(a065*a031);
  a040=(a040+a043);
  a043=casadi_sq(a051);
  a050=(a050*a108);
  a052=(a052*a015);
  a050=(a050+a052);
  a053=(a053*a028);
  a050=(a050+a053);
  a054=(a054*a112);
  a050=(a050+a054);
  a055=(a055*a026);
  a050=(a050+a055);
  a050=(a004+a050);
  a055=sin(a050);
  a043=(a043*a055);
  a055=(a050+a007);
  a054=sin(a055);
  a054=(a054*a068);
  a055=cos(a055);
  a055=(a055*a067);
  a054=(a054-a055);
  a043=(a043-a054);
  a050=cos(a050);
  a050=(a050-a111);
  a050=(a050*a069);
  a043=(a043+a050);
  a050=(a066*a043);
  a040=(a040+a050);
  a040=(a108+a040);
  a050=(a059*a040);
  a109=(a109+a050);
  a050=(a071*a110);
  a054=(a073*a012);
  a050=(a050+a054);
  a054=(a074*a009);
  a050=(a050+a054);
  a054=(a075*a038);
  a050=(a050+a054);
  a054=(a076*a031);
  a050=(a050+a054);
  a054=(a077*a043);
  a050=(a050+a054);
  a054=casadi_sq(a061);
  a060=(a060*a108);
  a062=(a062*a015);
  a060=(a060+a062);
  a063=(a063*a028);
  a060=(a060+a063);
  a064=(a064*a112);
  a060=(a060+a064);
  a065=(a065*a026);
  a060=(a060+a065);
  a066=(a066*a006);
  a060=(a060+a066);
  a060=(a004+a060);
  a066=sin(a060);
  a054=(a054*a066);
  a066=(a060+a007);
  a065=sin(a066);
  a065=(a065*a080);
  a066=cos(a066);
  a066=(a066*a079);
  a065=(a065-a066);
  a054=(a054-a065);
  a060=cos(a060);
  a060=(a060-a111);
  a060=(a060*a081);
  a054=(a054+a060);
  a060=(a078*a054);
  a050=(a050+a060);
  a050=(a108+a050);
  a060=(a070*a050);
  a109=(a109+a060);
  a060=(a083*a110);
  a065=(a085*a012);
  a060=(a060+a065);
  a065=(a086*a009);
  a060=(a060+a065);
  a065=(a087*a038);
  a060=(a060+a065);
  a065=(a088*a031);
  a060=(a060+a065);
  a065=(a089*a043);
  a060=(a060+a065);
  a065=(a090*a054);
  a060=(a060+a065);
  a065=casadi_sq(a072);
  a071=(a071*a108);
  a073=(a073*a015);
  a071=(a071+a073);
  a074=(a074*a028);
  a071=(a071+a074);
  a075=(a075*a112);
  a071=(a071+a075);
  a076=(a076*a026);
  a071=(a071+a076);
  a077=(a077*a006);
  a071=(a071+a077);
  a078=(a078*a040);
  a071=(a071+a078);
  a071=(a004+a071);
  a078=sin(a071);
  a065=(a065*a078);
  a078=(a071+a007);
  a077=sin(a078);
  a077=(a077*a093);
  a078=cos(a078);
  a078=(a078*a092);
  a077=(a077-a078);
  a065=(a065-a077);
  a071=cos(a071);
  a071=(a071-a111);
  a071=(a071*a094);
  a065=(a065+a071);
  a071=(a091*a065);
  a060=(a060+a071);
  a060=(a108+a060);
  a071=(a082*a060);
  a109=(a109+a071);
  a071=(a096*a110);
  a012=(a098*a012);
  a071=(a071+a012);
  a009=(a099*a009);
  a071=(a071+a009);
  a009=(a100*a038);
  a071=(a071+a009);
  a009=(a101*a031);
  a071=(a071+a009);
  a009=(a102*a043);
  a071=(a071+a009);
  a009=(a103*a054);
  a071=(a071+a009);
  a009=(a104*a065);
  a071=(a071+a009);
  a009=casadi_sq(a084);
  a083=(a083*a108);
  a085=(a085*a015);
  a083=(a083+a085);
  a086=(a086*a028);
  a083=(a083+a086);
  a087=(a087*a112);
  a083=(a083+a087);
  a088=(a088*a026);
  a083=(a083+a088);
  a089=(a089*a006);
  a083=(a083+a089);
  a090=(a090*a040);
  a083=(a083+a090);
  a091=(a091*a050);
  a083=(a083+a091);
  a083=(a004+a083);
  a091=sin(a083);
  a009=(a009*a091);
  a091=(a083+a007);
  a090=sin(a091);
  a090=(a090*a106);
  a091=cos(a091);
  a091=(a091*a002);
  a090=(a090-a091);
  a009=(a009-a090);
  a083=cos(a083);
  a083=(a083-a111);
  a083=(a083*a107);
  a009=(a009+a083);
  a083=(a105*a009);
  a071=(a071+a083);
  a071=(a108+a071);
  a071=(a095*a071);
  a109=(a109+a071);
  a109=(a004+a109);
  if (res[0]!=0) res[0][1]=a109;
  a010=(a001*a010);
  a048=(a005*a048);
  a010=(a010+a048);
  a058=(a039*a058);
  a010=(a010+a058);
  a069=(a049*a069);
  a010=(a010+a069);
  a081=(a059*a081);
  a010=(a010+a081);
  a094=(a070*a094);
  a010=(a010+a094);
  a107=(a082*a107);
  a010=(a010+a107);
  a107=(a096*a003);
  a032=(a098*a032);
  a107=(a107+a032);
  a046=(a099*a046);
  a107=(a107+a046);
  a013=(a100*a013);
  a107=(a107+a013);
  a041=(a101*a041);
  a107=(a107+a041);
  a051=(a102*a051);
  a107=(a107+a051);
  a061=(a103*a061);
  a107=(a107+a061);
  a072=(a104*a072);
  a107=(a107+a072);
  a084=(a105*a084);
  a107=(a107+a084);
  a000=(a000+a107);
  a107=cos(a000);
  a008=(a008*a107);
  a000=sin(a000);
  a011=(a011*a000);
  a008=(a008-a011);
  a011=(a095*a008);
  a010=(a010+a011);
  a003=(a003-a010);
  if (res[0]!=0) res[0][2]=a003;
  a001=(a001*a110);
  a005=(a005*a038);
  a001=(a001+a005);
  a039=(a039*a031);
  a001=(a001+a039);
  a049=(a049*a043);
  a001=(a001+a049);
  a059=(a059*a054);
  a001=(a001+a059);
  a070=(a070*a065);
  a001=(a001+a070);
  a082=(a082*a009);
  a001=(a001+a082);
  a097=casadi_sq(a097);
  a096=(a096*a108);
  a098=(a098*a015);
  a096=(a096+a098);
  a099=(a099*a028);
  a096=(a096+a099);
  a100=(a100*a112);
  a096=(a096+a100);
  a101=(a101*a026);
  a096=(a096+a101);
  a102=(a102*a006);
  a096=(a096+a102);
  a103=(a103*a040);
  a096=(a096+a103);
  a104=(a104*a050);
  a096=(a096+a104);
  a105=(a105*a060);
  a096=(a096+a105);
  a004=(a004+a096);
  a096=sin(a004);
  a097=(a097*a096);
  a007=(a004+a007);
  a096=sin(a007);
  a096=(a096*a107);
  a007=cos(a007);
  a007=(a007*a000);
  a096=(a096-a007);
  a097=(a097-a096);
  a004=cos(a004);
  a004=(a004-a111);
  a004=(a004*a008);
  a097=(a097+a004);
  a095=(a095*a097);
  a001=(a001+a095);
  a108=(a108+a001);
  if (res[0]!=0) res[0][3]=a108;
  return 0;
}

/* observe:(t,y[4],p)->(g[8],dg[8]) */
static int casadi_f103(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17;
  a00=arg[1]? arg[1][0] : 0;
  a01=sin(a00);
  a02=cos(a00);
  a03=arg[1]? arg[1][2] : 0;
  a04=casadi_sq(a03);
  a05=(a04*a01);
  a06=arg[2]? arg[2][0] : 0;
  a07=(a06-a00);
  a08=sin(a07);
  a09=(a02*a08);
  a05=(a05+a09);
  a10=sin(a06);
  a05=(a05-a10);
  a10=(a02*a05);
  a06=cos(a06);
  a11=(a02*a03);
  a12=(a11*a03);
  a06=(a06-a12);
  a12=(a08*a01);
  a06=(a06+a12);
  a10=(a10/a06);
  a12=(a01+a10);
  if (res[0]!=0) res[0][0]=a12;
  a12=0.;
  if (res[0]!=0) res[0][1]=a12;
  if (res[0]!=0) res[0][2]=a06;
  a13=(a05/a06);
  if (res[0]!=0) res[0][3]=a13;
  a14=arg[1]? arg[1][1] : 0;
  a15=(a14-a00);
  a16=cos(a15);
  a16=(a02-a16);
  if (res[0]!=0) res[0][4]=a16;
  a16=(-a08);
  if (res[0]!=0) res[0][5]=a16;
  a00=(2.*a00);
  a14=(a14-a00);
  if (res[0]!=0) res[0][6]=a14;
  if (res[0]!=0) res[0][7]=a12;
  a04=(a04*a11);
  a14=(2.*a03);
  a00=(a14*a08);
  a00=(a01*a00);
  a04=(a04-a00);
  a00=(a01*a03);
  a16=(a08*a00);
  a07=cos(a07);
  a07=(a07*a03);
  a17=(a02*a07);
  a16=(a16+a17);
  a04=(a04-a16);
  a02=(a02*a04);
  a05=(a05*a00);
  a02=(a02-a05);
  a02=(a02/a06);
  a10=(a10/a06);
  a05=(a03*a00);
  a05=(a05+a09);
  a05=(a03*a05);
  a09=(a11*a08);
  a05=(a05+a09);
  a08=(a08*a11);
  a01=(a01*a07);
  a08=(a08-a01);
  a05=(a05+a08);
  a10=(a10*a05);
  a02=(a02-a10);
  a11=(a11+a02);
  if (res[1]!=0) res[1][0]=a11;
  if (res[1]!=0) res[1][1]=a12;
  if (res[1]!=0) res[1][2]=a05;
  a04=(a04/a06);
  a13=(a13/a06);
  a13=(a13*a05);
  a04=(a04-a13);
  if (res[1]!=0) res[1][3]=a04;
  a15=sin(a15);
  a04=arg[1]? arg[1][3] : 0;
  a03=(a04-a03);
  a15=(a15*a03);
  a15=(a15-a00);
  if (res[1]!=0) res[1][4]=a15;
  if (res[1]!=0) res[1][5]=a07;
  a04=(a04-a14);
  if (res[1]!=0) res[1][6]=a04;
  if (res[1]!=0) res[1][7]=a12;
  return 0;
}

/* working_steps:(t,turns[2x12],w[4],h,p)->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+117, w01, w02, *w03=w+121, w05, *w06=w+123, w07, *w08=w+127, *w09=w+131, *w10=w+135, *w11=w+139;
  casadi_real *w12=w+143, *w13=w+147, *w14=w+151, *w15=w+155, *w16=w+159, *w17=w+163, *w18=w+167, *w19=w+171, *w20=w+179, *w21=w+187, *w22=w+195, *w23=w+203;
  casadi_real *w24=w+211, *w25=w+219, *w26=w+227, *w27=w+235, *w28=w+243, *w29=w+251, *w30=w+259, *w31=w+267;
  const casadi_real **arg1=arg+5, *wr04;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 4, w00);
  /* #1: @1 = input[0][0] */
  w01 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[4][0] */
  w02 = arg[4] ? arg[4][0] : 0;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w01);
  arg1[1]=(&w02);
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
  arg1[4]=(&w02);
  res1[0]=w06;
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = working_step(@6, @3, @4, @5, @2) */
  arg1[0]=w06;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
  res1[0]=w08;
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #11: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #13: @9 = working_step(@8, @3, @4, @5, @2) */
  arg1[0]=w08;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: @10 = working_step(@9, @3, @4, @5, @2) */
  arg1[0]=w09;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #23: @11 = working_step(@10, @3, @4, @5, @2) */
  arg1[0]=w10;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #28: @12 = working_step(@11, @3, @4, @5, @2) */
  arg1[0]=w11;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: @13 = working_step(@12, @3, @4, @5, @2) */
  arg1[0]=w12;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #38: @14 = working_step(@13, @3, @4, @5, @2) */
  arg1[0]=w13;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #43: @15 = working_step(@14, @3, @4, @5, @2) */
  arg1[0]=w14;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #48: @16 = working_step(@15, @3, @4, @5, @2) */
  arg1[0]=w15;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #53: @17 = working_step(@16, @3, @4, @5, @2) */
  arg1[0]=w16;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
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
  arg1[1]=(&w02);
  res1[0]=w03;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #58: @18 = working_step(@17, @3, @4, @5, @2) */
  arg1[0]=w17;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=(&w02);
  res1[0]=w18;
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @18 */
  casadi_copy(w18, 4, res[0]);
  /* #60: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  /* #61: output[1][1] = @6 */
  if (res[1]) casadi_copy(w06, 4, res[1]+4);
  /* #62: output[1][2] = @8 */
  if (res[1]) casadi_copy(w08, 4, res[1]+8);
  /* #63: output[1][3] = @9 */
  if (res[1]) casadi_copy(w09, 4, res[1]+12);
  /* #64: output[1][4] = @10 */
  if (res[1]) casadi_copy(w10, 4, res[1]+16);
  /* #65: output[1][5] = @11 */
  if (res[1]) casadi_copy(w11, 4, res[1]+20);
  /* #66: output[1][6] = @12 */
  if (res[1]) casadi_copy(w12, 4, res[1]+24);
  /* #67: output[1][7] = @13 */
  if (res[1]) casadi_copy(w13, 4, res[1]+28);
  /* #68: output[1][8] = @14 */
  if (res[1]) casadi_copy(w14, 4, res[1]+32);
  /* #69: output[1][9] = @15 */
  if (res[1]) casadi_copy(w15, 4, res[1]+36);
  /* #70: output[1][10] = @16 */
  if (res[1]) casadi_copy(w16, 4, res[1]+40);
  /* #71: output[1][11] = @17 */
  if (res[1]) casadi_copy(w17, 4, res[1]+44);
  /* #72: {@19, @20} = observe(@1, @0, @2) */
  arg1[0]=(&w01);
  arg1[1]=w00;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w20;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #73: output[2][0] = @19 */
  casadi_copy(w19, 8, res[2]);
  /* #74: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #75: {@19, @21} = observe(@7, @6, @2) */
  arg1[0]=(&w07);
  arg1[1]=w06;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w21;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[2][1] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+8);
  /* #77: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #78: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #79: {@19, @22} = observe(@7, @8, @2) */
  arg1[0]=(&w07);
  arg1[1]=w08;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w22;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[2][2] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+16);
  /* #81: @7 = 3 */
  w07 = 3.;
  /* #82: @7 = (@7*@5) */
  w07 *= w05;
  /* #83: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #84: {@19, @23} = observe(@7, @9, @2) */
  arg1[0]=(&w07);
  arg1[1]=w09;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w23;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #85: output[2][3] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+24);
  /* #86: @7 = 4 */
  w07 = 4.;
  /* #87: @7 = (@7*@5) */
  w07 *= w05;
  /* #88: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #89: {@19, @24} = observe(@7, @10, @2) */
  arg1[0]=(&w07);
  arg1[1]=w10;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w24;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+32);
  /* #91: @7 = 5 */
  w07 = 5.;
  /* #92: @7 = (@7*@5) */
  w07 *= w05;
  /* #93: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #94: {@19, @25} = observe(@7, @11, @2) */
  arg1[0]=(&w07);
  arg1[1]=w11;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w25;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[2][5] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+40);
  /* #96: @7 = 6 */
  w07 = 6.;
  /* #97: @7 = (@7*@5) */
  w07 *= w05;
  /* #98: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #99: {@19, @26} = observe(@7, @12, @2) */
  arg1[0]=(&w07);
  arg1[1]=w12;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w26;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[2][6] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+48);
  /* #101: @7 = 7 */
  w07 = 7.;
  /* #102: @7 = (@7*@5) */
  w07 *= w05;
  /* #103: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #104: {@19, @27} = observe(@7, @13, @2) */
  arg1[0]=(&w07);
  arg1[1]=w13;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w27;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[2][7] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+56);
  /* #106: @7 = 8 */
  w07 = 8.;
  /* #107: @7 = (@7*@5) */
  w07 *= w05;
  /* #108: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #109: {@19, @28} = observe(@7, @14, @2) */
  arg1[0]=(&w07);
  arg1[1]=w14;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w28;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[2][8] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+64);
  /* #111: @7 = 9 */
  w07 = 9.;
  /* #112: @7 = (@7*@5) */
  w07 *= w05;
  /* #113: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #114: {@19, @29} = observe(@7, @15, @2) */
  arg1[0]=(&w07);
  arg1[1]=w15;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w29;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #115: output[2][9] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+72);
  /* #116: @7 = 10 */
  w07 = 10.;
  /* #117: @7 = (@7*@5) */
  w07 *= w05;
  /* #118: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #119: {@19, @30} = observe(@7, @16, @2) */
  arg1[0]=(&w07);
  arg1[1]=w16;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w30;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #120: output[2][10] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+80);
  /* #121: @7 = 11 */
  w07 = 11.;
  /* #122: @7 = (@7*@5) */
  w07 *= w05;
  /* #123: @1 = (@1+@7) */
  w01 += w07;
  /* #124: {@19, @31} = observe(@1, @17, @2) */
  arg1[0]=(&w01);
  arg1[1]=w17;
  arg1[2]=(&w02);
  res1[0]=w19;
  res1[1]=w31;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #125: output[2][11] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+88);
  /* #126: output[3][0] = @20 */
  casadi_copy(w20, 8, res[3]);
  /* #127: output[3][1] = @21 */
  if (res[3]) casadi_copy(w21, 8, res[3]+8);
  /* #128: output[3][2] = @22 */
  if (res[3]) casadi_copy(w22, 8, res[3]+16);
  /* #129: output[3][3] = @23 */
  if (res[3]) casadi_copy(w23, 8, res[3]+24);
  /* #130: output[3][4] = @24 */
  if (res[3]) casadi_copy(w24, 8, res[3]+32);
  /* #131: output[3][5] = @25 */
  if (res[3]) casadi_copy(w25, 8, res[3]+40);
  /* #132: output[3][6] = @26 */
  if (res[3]) casadi_copy(w26, 8, res[3]+48);
  /* #133: output[3][7] = @27 */
  if (res[3]) casadi_copy(w27, 8, res[3]+56);
  /* #134: output[3][8] = @28 */
  if (res[3]) casadi_copy(w28, 8, res[3]+64);
  /* #135: output[3][9] = @29 */
  if (res[3]) casadi_copy(w29, 8, res[3]+72);
  /* #136: output[3][10] = @30 */
  if (res[3]) casadi_copy(w30, 8, res[3]+80);
  /* #137: output[3][11] = @31 */
  if (res[3]) casadi_copy(w31, 8, res[3]+88);
  return 0;
}

/* simplest_walker_trace_48:(u[3],p)->(w[4x49],g[8x49],dg[8x49],R[3]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1164;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 48 */
  w03 = 48.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: output[0][4] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+192);
  /* #24: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #25: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #26: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #27: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #28: {@18, @19} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w18;
  res1[1]=w19;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 8, res[1]+384);
  /* #30: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #31: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #32: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #33: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #34: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+384);
  /* #35: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f100(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s7;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1172;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1172*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_72:(u[3],p)->(w[4x73],g[8x73],dg[8x73],R[3]) */
static int casadi_f104(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1252, *w20=w+1348, *w21=w+1444;
  casadi_real *w22=w+1540, *w23=w+1548;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 72 */
  w03 = 72.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+192);
  /* #27: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+240);
  /* #31: output[0][6] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+288);
  /* #32: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #33: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #34: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #35: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #36: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #37: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #38: {@22, @23} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w22;
  res1[1]=w23;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #39: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 8, res[1]+576);
  /* #40: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #41: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #42: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #43: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #44: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #45: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #46: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 8, res[2]+576);
  /* #47: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f104(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_72_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1556;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1556*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_96:(u[3],p)->(w[4x97],g[8x97],dg[8x97],R[3]) */
static int casadi_f105(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1252, *w20=w+1348, *w21=w+1444;
  casadi_real *w22=w+1540, *w23=w+1636, *w24=w+1732, *w25=w+1828, *w26=w+1924, *w27=w+1932;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 96 */
  w03 = 96.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+192);
  /* #27: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+240);
  /* #31: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+288);
  /* #35: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+336);
  /* #39: output[0][8] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+384);
  /* #40: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #41: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #42: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #43: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #44: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #45: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #46: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #47: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #48: {@26, @27} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w26;
  res1[1]=w27;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #49: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 8, res[1]+768);
  /* #50: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #51: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #52: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #53: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #54: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #55: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #56: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #57: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #58: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 8, res[2]+768);
  /* #59: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f105(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1940;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1940*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_144:(u[3],p)->(w[4x145],g[8x145],dg[8x145],R[3]) */
static int casadi_f106(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1252, *w20=w+1348, *w21=w+1444;
  casadi_real *w22=w+1540, *w23=w+1636, *w24=w+1732, *w25=w+1828, *w26=w+1924, *w27=w+2020, *w28=w+2116, *w29=w+2212, *w30=w+2308, *w31=w+2404, *w32=w+2500, *w33=w+2596;
  casadi_real *w34=w+2692, *w35=w+2700;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 144 */
  w03 = 144.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+192);
  /* #27: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+240);
  /* #31: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+288);
  /* #35: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+336);
  /* #39: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+384);
  /* #43: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+432);
  /* #47: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+480);
  /* #51: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+528);
  /* #55: output[0][12] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+576);
  /* #56: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #57: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #58: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #59: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #60: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #61: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #62: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #63: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #64: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 96, res[1]+768);
  /* #65: output[1][9] = @28 */
  if (res[1]) casadi_copy(w28, 96, res[1]+864);
  /* #66: output[1][10] = @30 */
  if (res[1]) casadi_copy(w30, 96, res[1]+960);
  /* #67: output[1][11] = @32 */
  if (res[1]) casadi_copy(w32, 96, res[1]+1056);
  /* #68: {@34, @35} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w34;
  res1[1]=w35;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #69: output[1][12] = @34 */
  if (res[1]) casadi_copy(w34, 8, res[1]+1152);
  /* #70: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #71: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #72: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #73: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #74: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #75: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #76: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #77: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #78: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 96, res[2]+768);
  /* #79: output[2][9] = @29 */
  if (res[2]) casadi_copy(w29, 96, res[2]+864);
  /* #80: output[2][10] = @31 */
  if (res[2]) casadi_copy(w31, 96, res[2]+960);
  /* #81: output[2][11] = @33 */
  if (res[2]) casadi_copy(w33, 96, res[2]+1056);
  /* #82: output[2][12] = @35 */
  if (res[2]) casadi_copy(w35, 8, res[2]+1152);
  /* #83: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f106(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_144_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2708;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2708*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_192:(u[3],p)->(w[4x193],g[8x193],dg[8x193],R[3]) */
static int casadi_f107(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1252, *w20=w+1348, *w21=w+1444;
  casadi_real *w22=w+1540, *w23=w+1636, *w24=w+1732, *w25=w+1828, *w26=w+1924, *w27=w+2020, *w28=w+2116, *w29=w+2212, *w30=w+2308, *w31=w+2404, *w32=w+2500, *w33=w+2596;
  casadi_real *w34=w+2692, *w35=w+2788, *w36=w+2884, *w37=w+2980, *w38=w+3076, *w39=w+3172, *w40=w+3268, *w41=w+3364, *w42=w+3460, *w43=w+3468;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 192 */
  w03 = 192.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+192);
  /* #27: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+240);
  /* #31: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+288);
  /* #35: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+336);
  /* #39: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+384);
  /* #43: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+432);
  /* #47: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+480);
  /* #51: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+528);
  /* #55: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+576);
  /* #59: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+624);
  /* #63: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+672);
  /* #67: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+720);
  /* #71: output[0][16] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+768);
  /* #72: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #73: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #74: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #75: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #76: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #77: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #78: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #79: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #80: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 96, res[1]+768);
  /* #81: output[1][9] = @28 */
  if (res[1]) casadi_copy(w28, 96, res[1]+864);
  /* #82: output[1][10] = @30 */
  if (res[1]) casadi_copy(w30, 96, res[1]+960);
  /* #83: output[1][11] = @32 */
  if (res[1]) casadi_copy(w32, 96, res[1]+1056);
  /* #84: output[1][12] = @34 */
  if (res[1]) casadi_copy(w34, 96, res[1]+1152);
  /* #85: output[1][13] = @36 */
  if (res[1]) casadi_copy(w36, 96, res[1]+1248);
  /* #86: output[1][14] = @38 */
  if (res[1]) casadi_copy(w38, 96, res[1]+1344);
  /* #87: output[1][15] = @40 */
  if (res[1]) casadi_copy(w40, 96, res[1]+1440);
  /* #88: {@42, @43} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w42;
  res1[1]=w43;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[1][16] = @42 */
  if (res[1]) casadi_copy(w42, 8, res[1]+1536);
  /* #90: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #91: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #92: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #93: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #94: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #95: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #96: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #97: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #98: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 96, res[2]+768);
  /* #99: output[2][9] = @29 */
  if (res[2]) casadi_copy(w29, 96, res[2]+864);
  /* #100: output[2][10] = @31 */
  if (res[2]) casadi_copy(w31, 96, res[2]+960);
  /* #101: output[2][11] = @33 */
  if (res[2]) casadi_copy(w33, 96, res[2]+1056);
  /* #102: output[2][12] = @35 */
  if (res[2]) casadi_copy(w35, 96, res[2]+1152);
  /* #103: output[2][13] = @37 */
  if (res[2]) casadi_copy(w37, 96, res[2]+1248);
  /* #104: output[2][14] = @39 */
  if (res[2]) casadi_copy(w39, 96, res[2]+1344);
  /* #105: output[2][15] = @41 */
  if (res[2]) casadi_copy(w41, 96, res[2]+1440);
  /* #106: output[2][16] = @43 */
  if (res[2]) casadi_copy(w43, 8, res[2]+1536);
  /* #107: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f107(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3476;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3476*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_288:(u[3],p)->(w[4x289],g[8x289],dg[8x289],R[3]) */
static int casadi_f108(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1252, *w20=w+1348, *w21=w+1444;
  casadi_real *w22=w+1540, *w23=w+1636, *w24=w+1732, *w25=w+1828, *w26=w+1924, *w27=w+2020, *w28=w+2116, *w29=w+2212, *w30=w+2308, *w31=w+2404, *w32=w+2500, *w33=w+2596;
  casadi_real *w34=w+2692, *w35=w+2788, *w36=w+2884, *w37=w+2980, *w38=w+3076, *w39=w+3172, *w40=w+3268, *w41=w+3364, *w42=w+3460, *w43=w+3556, *w44=w+3652, *w45=w+3748;
  casadi_real *w46=w+3844, *w47=w+3940, *w48=w+4036, *w49=w+4132, *w50=w+4228, *w51=w+4324, *w52=w+4420, *w53=w+4516, *w54=w+4612, *w55=w+4708, *w56=w+4804, *w57=w+4900;
  casadi_real *w58=w+4996, *w59=w+5004;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 288 */
  w03 = 288.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.0416667 */
  w00 = 4.1666666666666664e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+192);
  /* #27: @0 = 0.208333 */
  w00 = 2.0833333333333334e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+240);
  /* #31: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+288);
  /* #35: @0 = 0.291667 */
  w00 = 2.9166666666666669e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+336);
  /* #39: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+384);
  /* #43: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+432);
  /* #47: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+480);
  /* #51: @0 = 0.458333 */
  w00 = 4.5833333333333331e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+528);
  /* #55: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+576);
  /* #59: @0 = 0.541667 */
  w00 = 5.4166666666666663e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+624);
  /* #63: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+672);
  /* #67: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+720);
  /* #71: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #72: @0 = (@0*@2) */
  w00 *= w02;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w42;
  res1[3]=w43;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+768);
  /* #75: @0 = 0.708333 */
  w00 = 7.0833333333333337e-01;
  /* #76: @0 = (@0*@2) */
  w00 *= w02;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w44;
  res1[3]=w45;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+816);
  /* #79: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w00 *= w02;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w46;
  res1[3]=w47;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+864);
  /* #83: @0 = 0.791667 */
  w00 = 7.9166666666666663e-01;
  /* #84: @0 = (@0*@2) */
  w00 *= w02;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w48;
  res1[3]=w49;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+912);
  /* #87: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #88: @0 = (@0*@2) */
  w00 *= w02;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w50;
  res1[3]=w51;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+960);
  /* #91: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w00 *= w02;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w52;
  res1[3]=w53;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1008);
  /* #95: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #96: @0 = (@0*@2) */
  w00 *= w02;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w54;
  res1[3]=w55;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1056);
  /* #99: @0 = 0.958333 */
  w00 = 9.5833333333333337e-01;
  /* #100: @0 = (@0*@2) */
  w00 *= w02;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w56;
  res1[3]=w57;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1104);
  /* #103: output[0][24] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+1152);
  /* #104: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #105: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #106: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #107: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #108: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #109: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #110: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #111: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #112: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 96, res[1]+768);
  /* #113: output[1][9] = @28 */
  if (res[1]) casadi_copy(w28, 96, res[1]+864);
  /* #114: output[1][10] = @30 */
  if (res[1]) casadi_copy(w30, 96, res[1]+960);
  /* #115: output[1][11] = @32 */
  if (res[1]) casadi_copy(w32, 96, res[1]+1056);
  /* #116: output[1][12] = @34 */
  if (res[1]) casadi_copy(w34, 96, res[1]+1152);
  /* #117: output[1][13] = @36 */
  if (res[1]) casadi_copy(w36, 96, res[1]+1248);
  /* #118: output[1][14] = @38 */
  if (res[1]) casadi_copy(w38, 96, res[1]+1344);
  /* #119: output[1][15] = @40 */
  if (res[1]) casadi_copy(w40, 96, res[1]+1440);
  /* #120: output[1][16] = @42 */
  if (res[1]) casadi_copy(w42, 96, res[1]+1536);
  /* #121: output[1][17] = @44 */
  if (res[1]) casadi_copy(w44, 96, res[1]+1632);
  /* #122: output[1][18] = @46 */
  if (res[1]) casadi_copy(w46, 96, res[1]+1728);
  /* #123: output[1][19] = @48 */
  if (res[1]) casadi_copy(w48, 96, res[1]+1824);
  /* #124: output[1][20] = @50 */
  if (res[1]) casadi_copy(w50, 96, res[1]+1920);
  /* #125: output[1][21] = @52 */
  if (res[1]) casadi_copy(w52, 96, res[1]+2016);
  /* #126: output[1][22] = @54 */
  if (res[1]) casadi_copy(w54, 96, res[1]+2112);
  /* #127: output[1][23] = @56 */
  if (res[1]) casadi_copy(w56, 96, res[1]+2208);
  /* #128: {@58, @59} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w58;
  res1[1]=w59;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #129: output[1][24] = @58 */
  if (res[1]) casadi_copy(w58, 8, res[1]+2304);
  /* #130: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #131: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #132: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #133: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #134: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #135: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #136: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #137: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #138: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 96, res[2]+768);
  /* #139: output[2][9] = @29 */
  if (res[2]) casadi_copy(w29, 96, res[2]+864);
  /* #140: output[2][10] = @31 */
  if (res[2]) casadi_copy(w31, 96, res[2]+960);
  /* #141: output[2][11] = @33 */
  if (res[2]) casadi_copy(w33, 96, res[2]+1056);
  /* #142: output[2][12] = @35 */
  if (res[2]) casadi_copy(w35, 96, res[2]+1152);
  /* #143: output[2][13] = @37 */
  if (res[2]) casadi_copy(w37, 96, res[2]+1248);
  /* #144: output[2][14] = @39 */
  if (res[2]) casadi_copy(w39, 96, res[2]+1344);
  /* #145: output[2][15] = @41 */
  if (res[2]) casadi_copy(w41, 96, res[2]+1440);
  /* #146: output[2][16] = @43 */
  if (res[2]) casadi_copy(w43, 96, res[2]+1536);
  /* #147: output[2][17] = @45 */
  if (res[2]) casadi_copy(w45, 96, res[2]+1632);
  /* #148: output[2][18] = @47 */
  if (res[2]) casadi_copy(w47, 96, res[2]+1728);
  /* #149: output[2][19] = @49 */
  if (res[2]) casadi_copy(w49, 96, res[2]+1824);
  /* #150: output[2][20] = @51 */
  if (res[2]) casadi_copy(w51, 96, res[2]+1920);
  /* #151: output[2][21] = @53 */
  if (res[2]) casadi_copy(w53, 96, res[2]+2016);
  /* #152: output[2][22] = @55 */
  if (res[2]) casadi_copy(w55, 96, res[2]+2112);
  /* #153: output[2][23] = @57 */
  if (res[2]) casadi_copy(w57, 96, res[2]+2208);
  /* #154: output[2][24] = @59 */
  if (res[2]) casadi_copy(w59, 8, res[2]+2304);
  /* #155: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f108(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_288_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s18;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 5012;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 5012*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_384:(u[3],p)->(w[4x385],g[8x385],dg[8x385],R[3]) */
static int casadi_f109(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+303, w02, w03, w04, *w05=w+306, *w06=w+330, *w07=w+332, *w08=w+336, *w09=w+340;
  casadi_real *w10=w+388, *w11=w+484, *w12=w+580, *w13=w+676, *w14=w+772, *w15=w+868, *w16=w+964, *w17=w+1060, *w18=w+1156, *w19=w+1252, *w20=w+1348, *w21=w+1444;
  casadi_real *w22=w+1540, *w23=w+1636, *w24=w+1732, *w25=w+1828, *w26=w+1924, *w27=w+2020, *w28=w+2116, *w29=w+2212, *w30=w+2308, *w31=w+2404, *w32=w+2500, *w33=w+2596;
  casadi_real *w34=w+2692, *w35=w+2788, *w36=w+2884, *w37=w+2980, *w38=w+3076, *w39=w+3172, *w40=w+3268, *w41=w+3364, *w42=w+3460, *w43=w+3556, *w44=w+3652, *w45=w+3748;
  casadi_real *w46=w+3844, *w47=w+3940, *w48=w+4036, *w49=w+4132, *w50=w+4228, *w51=w+4324, *w52=w+4420, *w53=w+4516, *w54=w+4612, *w55=w+4708, *w56=w+4804, *w57=w+4900;
  casadi_real *w58=w+4996, *w59=w+5092, *w60=w+5188, *w61=w+5284, *w62=w+5380, *w63=w+5476, *w64=w+5572, *w65=w+5668, *w66=w+5764, *w67=w+5860, *w68=w+5956, *w69=w+6052;
  casadi_real *w70=w+6148, *w71=w+6244, *w72=w+6340, *w73=w+6436, *w74=w+6532, *w75=w+6540;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w01);
  /* #2: @2 = @1[2] */
  for (rr=(&w02), cs=w01+2; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 384 */
  w03 = 384.;
  /* #4: @3 = (@2/@3) */
  w03  = (w02/w03);
  /* #5: @4 = input[1][0] */
  w04 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=(&w04);
  res1[0]=w05;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=(&w04);
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 48, res[0]);
  /* #11: @0 = 0.03125 */
  w00 = 3.1250000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+48);
  /* #15: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+96);
  /* #19: @0 = 0.09375 */
  w00 = 9.3750000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+144);
  /* #23: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+192);
  /* #27: @0 = 0.15625 */
  w00 = 1.5625000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+240);
  /* #31: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+288);
  /* #35: @0 = 0.21875 */
  w00 = 2.1875000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+336);
  /* #39: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+384);
  /* #43: @0 = 0.28125 */
  w00 = 2.8125000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+432);
  /* #47: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+480);
  /* #51: @0 = 0.34375 */
  w00 = 3.4375000000000000e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+528);
  /* #55: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+576);
  /* #59: @0 = 0.40625 */
  w00 = 4.0625000000000000e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+624);
  /* #63: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+672);
  /* #67: @0 = 0.46875 */
  w00 = 4.6875000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+720);
  /* #71: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #72: @0 = (@0*@2) */
  w00 *= w02;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w42;
  res1[3]=w43;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+768);
  /* #75: @0 = 0.53125 */
  w00 = 5.3125000000000000e-01;
  /* #76: @0 = (@0*@2) */
  w00 *= w02;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w44;
  res1[3]=w45;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+816);
  /* #79: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w00 *= w02;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w46;
  res1[3]=w47;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+864);
  /* #83: @0 = 0.59375 */
  w00 = 5.9375000000000000e-01;
  /* #84: @0 = (@0*@2) */
  w00 *= w02;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w48;
  res1[3]=w49;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+912);
  /* #87: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #88: @0 = (@0*@2) */
  w00 *= w02;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w50;
  res1[3]=w51;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+960);
  /* #91: @0 = 0.65625 */
  w00 = 6.5625000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w00 *= w02;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w52;
  res1[3]=w53;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1008);
  /* #95: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #96: @0 = (@0*@2) */
  w00 *= w02;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w54;
  res1[3]=w55;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1056);
  /* #99: @0 = 0.71875 */
  w00 = 7.1875000000000000e-01;
  /* #100: @0 = (@0*@2) */
  w00 *= w02;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w56;
  res1[3]=w57;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1104);
  /* #103: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w00 *= w02;
  /* #105: {@8, @9, @58, @59} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w58;
  res1[3]=w59;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1152);
  /* #107: @0 = 0.78125 */
  w00 = 7.8125000000000000e-01;
  /* #108: @0 = (@0*@2) */
  w00 *= w02;
  /* #109: {@7, @9, @60, @61} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w60;
  res1[3]=w61;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1200);
  /* #111: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #112: @0 = (@0*@2) */
  w00 *= w02;
  /* #113: {@8, @9, @62, @63} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w62;
  res1[3]=w63;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1248);
  /* #115: @0 = 0.84375 */
  w00 = 8.4375000000000000e-01;
  /* #116: @0 = (@0*@2) */
  w00 *= w02;
  /* #117: {@7, @9, @64, @65} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w64;
  res1[3]=w65;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1296);
  /* #119: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #120: @0 = (@0*@2) */
  w00 *= w02;
  /* #121: {@8, @9, @66, @67} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w66;
  res1[3]=w67;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1344);
  /* #123: @0 = 0.90625 */
  w00 = 9.0625000000000000e-01;
  /* #124: @0 = (@0*@2) */
  w00 *= w02;
  /* #125: {@7, @9, @68, @69} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w68;
  res1[3]=w69;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1392);
  /* #127: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w00 *= w02;
  /* #129: {@8, @9, @70, @71} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w70;
  res1[3]=w71;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1440);
  /* #131: @0 = 0.96875 */
  w00 = 9.6875000000000000e-01;
  /* #132: @0 = (@0*@2) */
  w00 *= w02;
  /* #133: {@7, @9, @72, @73} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=(&w04);
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w72;
  res1[3]=w73;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @9 */
  if (res[0]) casadi_copy(w09, 48, res[0]+1488);
  /* #135: output[0][32] = @7 */
  if (res[0]) casadi_copy(w07, 4, res[0]+1536);
  /* #136: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #137: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #138: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #139: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #140: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #141: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #142: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #143: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #144: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 96, res[1]+768);
  /* #145: output[1][9] = @28 */
  if (res[1]) casadi_copy(w28, 96, res[1]+864);
  /* #146: output[1][10] = @30 */
  if (res[1]) casadi_copy(w30, 96, res[1]+960);
  /* #147: output[1][11] = @32 */
  if (res[1]) casadi_copy(w32, 96, res[1]+1056);
  /* #148: output[1][12] = @34 */
  if (res[1]) casadi_copy(w34, 96, res[1]+1152);
  /* #149: output[1][13] = @36 */
  if (res[1]) casadi_copy(w36, 96, res[1]+1248);
  /* #150: output[1][14] = @38 */
  if (res[1]) casadi_copy(w38, 96, res[1]+1344);
  /* #151: output[1][15] = @40 */
  if (res[1]) casadi_copy(w40, 96, res[1]+1440);
  /* #152: output[1][16] = @42 */
  if (res[1]) casadi_copy(w42, 96, res[1]+1536);
  /* #153: output[1][17] = @44 */
  if (res[1]) casadi_copy(w44, 96, res[1]+1632);
  /* #154: output[1][18] = @46 */
  if (res[1]) casadi_copy(w46, 96, res[1]+1728);
  /* #155: output[1][19] = @48 */
  if (res[1]) casadi_copy(w48, 96, res[1]+1824);
  /* #156: output[1][20] = @50 */
  if (res[1]) casadi_copy(w50, 96, res[1]+1920);
  /* #157: output[1][21] = @52 */
  if (res[1]) casadi_copy(w52, 96, res[1]+2016);
  /* #158: output[1][22] = @54 */
  if (res[1]) casadi_copy(w54, 96, res[1]+2112);
  /* #159: output[1][23] = @56 */
  if (res[1]) casadi_copy(w56, 96, res[1]+2208);
  /* #160: output[1][24] = @58 */
  if (res[1]) casadi_copy(w58, 96, res[1]+2304);
  /* #161: output[1][25] = @60 */
  if (res[1]) casadi_copy(w60, 96, res[1]+2400);
  /* #162: output[1][26] = @62 */
  if (res[1]) casadi_copy(w62, 96, res[1]+2496);
  /* #163: output[1][27] = @64 */
  if (res[1]) casadi_copy(w64, 96, res[1]+2592);
  /* #164: output[1][28] = @66 */
  if (res[1]) casadi_copy(w66, 96, res[1]+2688);
  /* #165: output[1][29] = @68 */
  if (res[1]) casadi_copy(w68, 96, res[1]+2784);
  /* #166: output[1][30] = @70 */
  if (res[1]) casadi_copy(w70, 96, res[1]+2880);
  /* #167: output[1][31] = @72 */
  if (res[1]) casadi_copy(w72, 96, res[1]+2976);
  /* #168: {@74, @75} = observe(@2, @7, @4) */
  arg1[0]=(&w02);
  arg1[1]=w07;
  arg1[2]=(&w04);
  res1[0]=w74;
  res1[1]=w75;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #169: output[1][32] = @74 */
  if (res[1]) casadi_copy(w74, 8, res[1]+3072);
  /* #170: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #171: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #172: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #173: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #174: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #175: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #176: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #177: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #178: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 96, res[2]+768);
  /* #179: output[2][9] = @29 */
  if (res[2]) casadi_copy(w29, 96, res[2]+864);
  /* #180: output[2][10] = @31 */
  if (res[2]) casadi_copy(w31, 96, res[2]+960);
  /* #181: output[2][11] = @33 */
  if (res[2]) casadi_copy(w33, 96, res[2]+1056);
  /* #182: output[2][12] = @35 */
  if (res[2]) casadi_copy(w35, 96, res[2]+1152);
  /* #183: output[2][13] = @37 */
  if (res[2]) casadi_copy(w37, 96, res[2]+1248);
  /* #184: output[2][14] = @39 */
  if (res[2]) casadi_copy(w39, 96, res[2]+1344);
  /* #185: output[2][15] = @41 */
  if (res[2]) casadi_copy(w41, 96, res[2]+1440);
  /* #186: output[2][16] = @43 */
  if (res[2]) casadi_copy(w43, 96, res[2]+1536);
  /* #187: output[2][17] = @45 */
  if (res[2]) casadi_copy(w45, 96, res[2]+1632);
  /* #188: output[2][18] = @47 */
  if (res[2]) casadi_copy(w47, 96, res[2]+1728);
  /* #189: output[2][19] = @49 */
  if (res[2]) casadi_copy(w49, 96, res[2]+1824);
  /* #190: output[2][20] = @51 */
  if (res[2]) casadi_copy(w51, 96, res[2]+1920);
  /* #191: output[2][21] = @53 */
  if (res[2]) casadi_copy(w53, 96, res[2]+2016);
  /* #192: output[2][22] = @55 */
  if (res[2]) casadi_copy(w55, 96, res[2]+2112);
  /* #193: output[2][23] = @57 */
  if (res[2]) casadi_copy(w57, 96, res[2]+2208);
  /* #194: output[2][24] = @59 */
  if (res[2]) casadi_copy(w59, 96, res[2]+2304);
  /* #195: output[2][25] = @61 */
  if (res[2]) casadi_copy(w61, 96, res[2]+2400);
  /* #196: output[2][26] = @63 */
  if (res[2]) casadi_copy(w63, 96, res[2]+2496);
  /* #197: output[2][27] = @65 */
  if (res[2]) casadi_copy(w65, 96, res[2]+2592);
  /* #198: output[2][28] = @67 */
  if (res[2]) casadi_copy(w67, 96, res[2]+2688);
  /* #199: output[2][29] = @69 */
  if (res[2]) casadi_copy(w69, 96, res[2]+2784);
  /* #200: output[2][30] = @71 */
  if (res[2]) casadi_copy(w71, 96, res[2]+2880);
  /* #201: output[2][31] = @73 */
  if (res[2]) casadi_copy(w73, 96, res[2]+2976);
  /* #202: output[2][32] = @75 */
  if (res[2]) casadi_copy(w75, 8, res[2]+3072);
  /* #203: @1 = landing(@7, @6, @4) */
  arg1[0]=w07;
  arg1[1]=w06;
  arg1[2]=(&w04);
  res1[0]=w01;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #204: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f109(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s19;
    case 1: return casadi_s20;
    case 2: return casadi_s20;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6548;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6548*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_576:(u[3],p)->(w[4x577],g[8x577],dg[8x577],R[3]) */
static int casadi_f110(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+303, w002, w003, w004, *w005=w+306, *w006=w+330, *w007=w+332, *w008=w+336, *w009=w+340;
  casadi_real *w010=w+388, *w011=w+484, *w012=w+580, *w013=w+676, *w014=w+772, *w015=w+868, *w016=w+964, *w017=w+1060, *w018=w+1156, *w019=w+1252, *w020=w+1348, *w021=w+1444;
  casadi_real *w022=w+1540, *w023=w+1636, *w024=w+1732, *w025=w+1828, *w026=w+1924, *w027=w+2020, *w028=w+2116, *w029=w+2212, *w030=w+2308, *w031=w+2404, *w032=w+2500, *w033=w+2596;
  casadi_real *w034=w+2692, *w035=w+2788, *w036=w+2884, *w037=w+2980, *w038=w+3076, *w039=w+3172, *w040=w+3268, *w041=w+3364, *w042=w+3460, *w043=w+3556, *w044=w+3652, *w045=w+3748;
  casadi_real *w046=w+3844, *w047=w+3940, *w048=w+4036, *w049=w+4132, *w050=w+4228, *w051=w+4324, *w052=w+4420, *w053=w+4516, *w054=w+4612, *w055=w+4708, *w056=w+4804, *w057=w+4900;
  casadi_real *w058=w+4996, *w059=w+5092, *w060=w+5188, *w061=w+5284, *w062=w+5380, *w063=w+5476, *w064=w+5572, *w065=w+5668, *w066=w+5764, *w067=w+5860, *w068=w+5956, *w069=w+6052;
  casadi_real *w070=w+6148, *w071=w+6244, *w072=w+6340, *w073=w+6436, *w074=w+6532, *w075=w+6628, *w076=w+6724, *w077=w+6820, *w078=w+6916, *w079=w+7012, *w080=w+7108, *w081=w+7204;
  casadi_real *w082=w+7300, *w083=w+7396, *w084=w+7492, *w085=w+7588, *w086=w+7684, *w087=w+7780, *w088=w+7876, *w089=w+7972, *w090=w+8068, *w091=w+8164, *w092=w+8260, *w093=w+8356;
  casadi_real *w094=w+8452, *w095=w+8548, *w096=w+8644, *w097=w+8740, *w098=w+8836, *w099=w+8932, *w100=w+9028, *w101=w+9124, *w102=w+9220, *w103=w+9316, *w104=w+9412, *w105=w+9508;
  casadi_real *w106=w+9604, *w107=w+9612;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w001);
  /* #2: @2 = @1[2] */
  for (rr=(&w002), cs=w001+2; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 576 */
  w003 = 576.;
  /* #4: @3 = (@2/@3) */
  w003  = (w002/w003);
  /* #5: @4 = input[1][0] */
  w004 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=(&w004);
  res1[0]=w005;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w006, cs=w001+0; cs!=w001+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=(&w004);
  res1[0]=w007;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w010;
  res1[3]=w011;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w009, 48, res[0]);
  /* #11: @0 = 0.0208333 */
  w000 = 2.0833333333333332e-02;
  /* #12: @0 = (@0*@2) */
  w000 *= w002;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w012;
  res1[3]=w013;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+48);
  /* #15: @0 = 0.0416667 */
  w000 = 4.1666666666666664e-02;
  /* #16: @0 = (@0*@2) */
  w000 *= w002;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w014;
  res1[3]=w015;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+96);
  /* #19: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w000 *= w002;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w016;
  res1[3]=w017;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+144);
  /* #23: @0 = 0.0833333 */
  w000 = 8.3333333333333329e-02;
  /* #24: @0 = (@0*@2) */
  w000 *= w002;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w018;
  res1[3]=w019;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+192);
  /* #27: @0 = 0.104167 */
  w000 = 1.0416666666666667e-01;
  /* #28: @0 = (@0*@2) */
  w000 *= w002;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w020;
  res1[3]=w021;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+240);
  /* #31: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w000 *= w002;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w022;
  res1[3]=w023;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+288);
  /* #35: @0 = 0.145833 */
  w000 = 1.4583333333333334e-01;
  /* #36: @0 = (@0*@2) */
  w000 *= w002;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w024;
  res1[3]=w025;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+336);
  /* #39: @0 = 0.166667 */
  w000 = 1.6666666666666666e-01;
  /* #40: @0 = (@0*@2) */
  w000 *= w002;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w026;
  res1[3]=w027;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+384);
  /* #43: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w000 *= w002;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w028;
  res1[3]=w029;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+432);
  /* #47: @0 = 0.208333 */
  w000 = 2.0833333333333334e-01;
  /* #48: @0 = (@0*@2) */
  w000 *= w002;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w030;
  res1[3]=w031;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+480);
  /* #51: @0 = 0.229167 */
  w000 = 2.2916666666666666e-01;
  /* #52: @0 = (@0*@2) */
  w000 *= w002;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w032;
  res1[3]=w033;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+528);
  /* #55: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w000 *= w002;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w034;
  res1[3]=w035;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+576);
  /* #59: @0 = 0.270833 */
  w000 = 2.7083333333333331e-01;
  /* #60: @0 = (@0*@2) */
  w000 *= w002;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w036;
  res1[3]=w037;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+624);
  /* #63: @0 = 0.291667 */
  w000 = 2.9166666666666669e-01;
  /* #64: @0 = (@0*@2) */
  w000 *= w002;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w038;
  res1[3]=w039;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+672);
  /* #67: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w000 *= w002;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w040;
  res1[3]=w041;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+720);
  /* #71: @0 = 0.333333 */
  w000 = 3.3333333333333331e-01;
  /* #72: @0 = (@0*@2) */
  w000 *= w002;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w042;
  res1[3]=w043;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+768);
  /* #75: @0 = 0.354167 */
  w000 = 3.5416666666666669e-01;
  /* #76: @0 = (@0*@2) */
  w000 *= w002;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w044;
  res1[3]=w045;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+816);
  /* #79: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w000 *= w002;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w046;
  res1[3]=w047;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+864);
  /* #83: @0 = 0.395833 */
  w000 = 3.9583333333333331e-01;
  /* #84: @0 = (@0*@2) */
  w000 *= w002;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w048;
  res1[3]=w049;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+912);
  /* #87: @0 = 0.416667 */
  w000 = 4.1666666666666669e-01;
  /* #88: @0 = (@0*@2) */
  w000 *= w002;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w050;
  res1[3]=w051;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+960);
  /* #91: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w000 *= w002;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w052;
  res1[3]=w053;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1008);
  /* #95: @0 = 0.458333 */
  w000 = 4.5833333333333331e-01;
  /* #96: @0 = (@0*@2) */
  w000 *= w002;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w054;
  res1[3]=w055;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1056);
  /* #99: @0 = 0.479167 */
  w000 = 4.7916666666666669e-01;
  /* #100: @0 = (@0*@2) */
  w000 *= w002;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w056;
  res1[3]=w057;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1104);
  /* #103: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w000 *= w002;
  /* #105: {@8, @9, @58, @59} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w058;
  res1[3]=w059;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1152);
  /* #107: @0 = 0.520833 */
  w000 = 5.2083333333333337e-01;
  /* #108: @0 = (@0*@2) */
  w000 *= w002;
  /* #109: {@7, @9, @60, @61} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w060;
  res1[3]=w061;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1200);
  /* #111: @0 = 0.541667 */
  w000 = 5.4166666666666663e-01;
  /* #112: @0 = (@0*@2) */
  w000 *= w002;
  /* #113: {@8, @9, @62, @63} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w062;
  res1[3]=w063;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1248);
  /* #115: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #116: @0 = (@0*@2) */
  w000 *= w002;
  /* #117: {@7, @9, @64, @65} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w064;
  res1[3]=w065;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1296);
  /* #119: @0 = 0.583333 */
  w000 = 5.8333333333333337e-01;
  /* #120: @0 = (@0*@2) */
  w000 *= w002;
  /* #121: {@8, @9, @66, @67} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w066;
  res1[3]=w067;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1344);
  /* #123: @0 = 0.604167 */
  w000 = 6.0416666666666663e-01;
  /* #124: @0 = (@0*@2) */
  w000 *= w002;
  /* #125: {@7, @9, @68, @69} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w068;
  res1[3]=w069;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1392);
  /* #127: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w000 *= w002;
  /* #129: {@8, @9, @70, @71} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w070;
  res1[3]=w071;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1440);
  /* #131: @0 = 0.645833 */
  w000 = 6.4583333333333337e-01;
  /* #132: @0 = (@0*@2) */
  w000 *= w002;
  /* #133: {@7, @9, @72, @73} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w072;
  res1[3]=w073;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1488);
  /* #135: @0 = 0.666667 */
  w000 = 6.6666666666666663e-01;
  /* #136: @0 = (@0*@2) */
  w000 *= w002;
  /* #137: {@8, @9, @74, @75} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w074;
  res1[3]=w075;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #138: output[0][32] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1536);
  /* #139: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #140: @0 = (@0*@2) */
  w000 *= w002;
  /* #141: {@7, @9, @76, @77} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w076;
  res1[3]=w077;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #142: output[0][33] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1584);
  /* #143: @0 = 0.708333 */
  w000 = 7.0833333333333337e-01;
  /* #144: @0 = (@0*@2) */
  w000 *= w002;
  /* #145: {@8, @9, @78, @79} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w078;
  res1[3]=w079;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #146: output[0][34] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1632);
  /* #147: @0 = 0.729167 */
  w000 = 7.2916666666666663e-01;
  /* #148: @0 = (@0*@2) */
  w000 *= w002;
  /* #149: {@7, @9, @80, @81} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w080;
  res1[3]=w081;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #150: output[0][35] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1680);
  /* #151: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #152: @0 = (@0*@2) */
  w000 *= w002;
  /* #153: {@8, @9, @82, @83} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w082;
  res1[3]=w083;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #154: output[0][36] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1728);
  /* #155: @0 = 0.770833 */
  w000 = 7.7083333333333337e-01;
  /* #156: @0 = (@0*@2) */
  w000 *= w002;
  /* #157: {@7, @9, @84, @85} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w084;
  res1[3]=w085;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #158: output[0][37] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1776);
  /* #159: @0 = 0.791667 */
  w000 = 7.9166666666666663e-01;
  /* #160: @0 = (@0*@2) */
  w000 *= w002;
  /* #161: {@8, @9, @86, @87} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w086;
  res1[3]=w087;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #162: output[0][38] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1824);
  /* #163: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #164: @0 = (@0*@2) */
  w000 *= w002;
  /* #165: {@7, @9, @88, @89} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w088;
  res1[3]=w089;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][39] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1872);
  /* #167: @0 = 0.833333 */
  w000 = 8.3333333333333337e-01;
  /* #168: @0 = (@0*@2) */
  w000 *= w002;
  /* #169: {@8, @9, @90, @91} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w090;
  res1[3]=w091;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #170: output[0][40] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1920);
  /* #171: @0 = 0.854167 */
  w000 = 8.5416666666666663e-01;
  /* #172: @0 = (@0*@2) */
  w000 *= w002;
  /* #173: {@7, @9, @92, @93} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w092;
  res1[3]=w093;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #174: output[0][41] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1968);
  /* #175: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #176: @0 = (@0*@2) */
  w000 *= w002;
  /* #177: {@8, @9, @94, @95} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w094;
  res1[3]=w095;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #178: output[0][42] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2016);
  /* #179: @0 = 0.895833 */
  w000 = 8.9583333333333337e-01;
  /* #180: @0 = (@0*@2) */
  w000 *= w002;
  /* #181: {@7, @9, @96, @97} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w096;
  res1[3]=w097;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #182: output[0][43] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2064);
  /* #183: @0 = 0.916667 */
  w000 = 9.1666666666666663e-01;
  /* #184: @0 = (@0*@2) */
  w000 *= w002;
  /* #185: {@8, @9, @98, @99} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w098;
  res1[3]=w099;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #186: output[0][44] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2112);
  /* #187: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #188: @0 = (@0*@2) */
  w000 *= w002;
  /* #189: {@7, @9, @100, @101} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w100;
  res1[3]=w101;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #190: output[0][45] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2160);
  /* #191: @0 = 0.958333 */
  w000 = 9.5833333333333337e-01;
  /* #192: @0 = (@0*@2) */
  w000 *= w002;
  /* #193: {@8, @9, @102, @103} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w102;
  res1[3]=w103;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #194: output[0][46] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2208);
  /* #195: @0 = 0.979167 */
  w000 = 9.7916666666666663e-01;
  /* #196: @0 = (@0*@2) */
  w000 *= w002;
  /* #197: {@7, @9, @104, @105} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w104;
  res1[3]=w105;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #198: output[0][47] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2256);
  /* #199: output[0][48] = @7 */
  if (res[0]) casadi_copy(w007, 4, res[0]+2304);
  /* #200: output[1][0] = @10 */
  casadi_copy(w010, 96, res[1]);
  /* #201: output[1][1] = @12 */
  if (res[1]) casadi_copy(w012, 96, res[1]+96);
  /* #202: output[1][2] = @14 */
  if (res[1]) casadi_copy(w014, 96, res[1]+192);
  /* #203: output[1][3] = @16 */
  if (res[1]) casadi_copy(w016, 96, res[1]+288);
  /* #204: output[1][4] = @18 */
  if (res[1]) casadi_copy(w018, 96, res[1]+384);
  /* #205: output[1][5] = @20 */
  if (res[1]) casadi_copy(w020, 96, res[1]+480);
  /* #206: output[1][6] = @22 */
  if (res[1]) casadi_copy(w022, 96, res[1]+576);
  /* #207: output[1][7] = @24 */
  if (res[1]) casadi_copy(w024, 96, res[1]+672);
  /* #208: output[1][8] = @26 */
  if (res[1]) casadi_copy(w026, 96, res[1]+768);
  /* #209: output[1][9] = @28 */
  if (res[1]) casadi_copy(w028, 96, res[1]+864);
  /* #210: output[1][10] = @30 */
  if (res[1]) casadi_copy(w030, 96, res[1]+960);
  /* #211: output[1][11] = @32 */
  if (res[1]) casadi_copy(w032, 96, res[1]+1056);
  /* #212: output[1][12] = @34 */
  if (res[1]) casadi_copy(w034, 96, res[1]+1152);
  /* #213: output[1][13] = @36 */
  if (res[1]) casadi_copy(w036, 96, res[1]+1248);
  /* #214: output[1][14] = @38 */
  if (res[1]) casadi_copy(w038, 96, res[1]+1344);
  /* #215: output[1][15] = @40 */
  if (res[1]) casadi_copy(w040, 96, res[1]+1440);
  /* #216: output[1][16] = @42 */
  if (res[1]) casadi_copy(w042, 96, res[1]+1536);
  /* #217: output[1][17] = @44 */
  if (res[1]) casadi_copy(w044, 96, res[1]+1632);
  /* #218: output[1][18] = @46 */
  if (res[1]) casadi_copy(w046, 96, res[1]+1728);
  /* #219: output[1][19] = @48 */
  if (res[1]) casadi_copy(w048, 96, res[1]+1824);
  /* #220: output[1][20] = @50 */
  if (res[1]) casadi_copy(w050, 96, res[1]+1920);
  /* #221: output[1][21] = @52 */
  if (res[1]) casadi_copy(w052, 96, res[1]+2016);
  /* #222: output[1][22] = @54 */
  if (res[1]) casadi_copy(w054, 96, res[1]+2112);
  /* #223: output[1][23] = @56 */
  if (res[1]) casadi_copy(w056, 96, res[1]+2208);
  /* #224: output[1][24] = @58 */
  if (res[1]) casadi_copy(w058, 96, res[1]+2304);
  /* #225: output[1][25] = @60 */
  if (res[1]) casadi_copy(w060, 96, res[1]+2400);
  /* #226: output[1][26] = @62 */
  if (res[1]) casadi_copy(w062, 96, res[1]+2496);
  /* #227: output[1][27] = @64 */
  if (res[1]) casadi_copy(w064, 96, res[1]+2592);
  /* #228: output[1][28] = @66 */
  if (res[1]) casadi_copy(w066, 96, res[1]+2688);
  /* #229: output[1][29] = @68 */
  if (res[1]) casadi_copy(w068, 96, res[1]+2784);
  /* #230: output[1][30] = @70 */
  if (res[1]) casadi_copy(w070, 96, res[1]+2880);
  /* #231: output[1][31] = @72 */
  if (res[1]) casadi_copy(w072, 96, res[1]+2976);
  /* #232: output[1][32] = @74 */
  if (res[1]) casadi_copy(w074, 96, res[1]+3072);
  /* #233: output[1][33] = @76 */
  if (res[1]) casadi_copy(w076, 96, res[1]+3168);
  /* #234: output[1][34] = @78 */
  if (res[1]) casadi_copy(w078, 96, res[1]+3264);
  /* #235: output[1][35] = @80 */
  if (res[1]) casadi_copy(w080, 96, res[1]+3360);
  /* #236: output[1][36] = @82 */
  if (res[1]) casadi_copy(w082, 96, res[1]+3456);
  /* #237: output[1][37] = @84 */
  if (res[1]) casadi_copy(w084, 96, res[1]+3552);
  /* #238: output[1][38] = @86 */
  if (res[1]) casadi_copy(w086, 96, res[1]+3648);
  /* #239: output[1][39] = @88 */
  if (res[1]) casadi_copy(w088, 96, res[1]+3744);
  /* #240: output[1][40] = @90 */
  if (res[1]) casadi_copy(w090, 96, res[1]+3840);
  /* #241: output[1][41] = @92 */
  if (res[1]) casadi_copy(w092, 96, res[1]+3936);
  /* #242: output[1][42] = @94 */
  if (res[1]) casadi_copy(w094, 96, res[1]+4032);
  /* #243: output[1][43] = @96 */
  if (res[1]) casadi_copy(w096, 96, res[1]+4128);
  /* #244: output[1][44] = @98 */
  if (res[1]) casadi_copy(w098, 96, res[1]+4224);
  /* #245: output[1][45] = @100 */
  if (res[1]) casadi_copy(w100, 96, res[1]+4320);
  /* #246: output[1][46] = @102 */
  if (res[1]) casadi_copy(w102, 96, res[1]+4416);
  /* #247: output[1][47] = @104 */
  if (res[1]) casadi_copy(w104, 96, res[1]+4512);
  /* #248: {@106, @107} = observe(@2, @7, @4) */
  arg1[0]=(&w002);
  arg1[1]=w007;
  arg1[2]=(&w004);
  res1[0]=w106;
  res1[1]=w107;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #249: output[1][48] = @106 */
  if (res[1]) casadi_copy(w106, 8, res[1]+4608);
  /* #250: output[2][0] = @11 */
  casadi_copy(w011, 96, res[2]);
  /* #251: output[2][1] = @13 */
  if (res[2]) casadi_copy(w013, 96, res[2]+96);
  /* #252: output[2][2] = @15 */
  if (res[2]) casadi_copy(w015, 96, res[2]+192);
  /* #253: output[2][3] = @17 */
  if (res[2]) casadi_copy(w017, 96, res[2]+288);
  /* #254: output[2][4] = @19 */
  if (res[2]) casadi_copy(w019, 96, res[2]+384);
  /* #255: output[2][5] = @21 */
  if (res[2]) casadi_copy(w021, 96, res[2]+480);
  /* #256: output[2][6] = @23 */
  if (res[2]) casadi_copy(w023, 96, res[2]+576);
  /* #257: output[2][7] = @25 */
  if (res[2]) casadi_copy(w025, 96, res[2]+672);
  /* #258: output[2][8] = @27 */
  if (res[2]) casadi_copy(w027, 96, res[2]+768);
  /* #259: output[2][9] = @29 */
  if (res[2]) casadi_copy(w029, 96, res[2]+864);
  /* #260: output[2][10] = @31 */
  if (res[2]) casadi_copy(w031, 96, res[2]+960);
  /* #261: output[2][11] = @33 */
  if (res[2]) casadi_copy(w033, 96, res[2]+1056);
  /* #262: output[2][12] = @35 */
  if (res[2]) casadi_copy(w035, 96, res[2]+1152);
  /* #263: output[2][13] = @37 */
  if (res[2]) casadi_copy(w037, 96, res[2]+1248);
  /* #264: output[2][14] = @39 */
  if (res[2]) casadi_copy(w039, 96, res[2]+1344);
  /* #265: output[2][15] = @41 */
  if (res[2]) casadi_copy(w041, 96, res[2]+1440);
  /* #266: output[2][16] = @43 */
  if (res[2]) casadi_copy(w043, 96, res[2]+1536);
  /* #267: output[2][17] = @45 */
  if (res[2]) casadi_copy(w045, 96, res[2]+1632);
  /* #268: output[2][18] = @47 */
  if (res[2]) casadi_copy(w047, 96, res[2]+1728);
  /* #269: output[2][19] = @49 */
  if (res[2]) casadi_copy(w049, 96, res[2]+1824);
  /* #270: output[2][20] = @51 */
  if (res[2]) casadi_copy(w051, 96, res[2]+1920);
  /* #271: output[2][21] = @53 */
  if (res[2]) casadi_copy(w053, 96, res[2]+2016);
  /* #272: output[2][22] = @55 */
  if (res[2]) casadi_copy(w055, 96, res[2]+2112);
  /* #273: output[2][23] = @57 */
  if (res[2]) casadi_copy(w057, 96, res[2]+2208);
  /* #274: output[2][24] = @59 */
  if (res[2]) casadi_copy(w059, 96, res[2]+2304);
  /* #275: output[2][25] = @61 */
  if (res[2]) casadi_copy(w061, 96, res[2]+2400);
  /* #276: output[2][26] = @63 */
  if (res[2]) casadi_copy(w063, 96, res[2]+2496);
  /* #277: output[2][27] = @65 */
  if (res[2]) casadi_copy(w065, 96, res[2]+2592);
  /* #278: output[2][28] = @67 */
  if (res[2]) casadi_copy(w067, 96, res[2]+2688);
  /* #279: output[2][29] = @69 */
  if (res[2]) casadi_copy(w069, 96, res[2]+2784);
  /* #280: output[2][30] = @71 */
  if (res[2]) casadi_copy(w071, 96, res[2]+2880);
  /* #281: output[2][31] = @73 */
  if (res[2]) casadi_copy(w073, 96, res[2]+2976);
  /* #282: output[2][32] = @75 */
  if (res[2]) casadi_copy(w075, 96, res[2]+3072);
  /* #283: output[2][33] = @77 */
  if (res[2]) casadi_copy(w077, 96, res[2]+3168);
  /* #284: output[2][34] = @79 */
  if (res[2]) casadi_copy(w079, 96, res[2]+3264);
  /* #285: output[2][35] = @81 */
  if (res[2]) casadi_copy(w081, 96, res[2]+3360);
  /* #286: output[2][36] = @83 */
  if (res[2]) casadi_copy(w083, 96, res[2]+3456);
  /* #287: output[2][37] = @85 */
  if (res[2]) casadi_copy(w085, 96, res[2]+3552);
  /* #288: output[2][38] = @87 */
  if (res[2]) casadi_copy(w087, 96, res[2]+3648);
  /* #289: output[2][39] = @89 */
  if (res[2]) casadi_copy(w089, 96, res[2]+3744);
  /* #290: output[2][40] = @91 */
  if (res[2]) casadi_copy(w091, 96, res[2]+3840);
  /* #291: output[2][41] = @93 */
  if (res[2]) casadi_copy(w093, 96, res[2]+3936);
  /* #292: output[2][42] = @95 */
  if (res[2]) casadi_copy(w095, 96, res[2]+4032);
  /* #293: output[2][43] = @97 */
  if (res[2]) casadi_copy(w097, 96, res[2]+4128);
  /* #294: output[2][44] = @99 */
  if (res[2]) casadi_copy(w099, 96, res[2]+4224);
  /* #295: output[2][45] = @101 */
  if (res[2]) casadi_copy(w101, 96, res[2]+4320);
  /* #296: output[2][46] = @103 */
  if (res[2]) casadi_copy(w103, 96, res[2]+4416);
  /* #297: output[2][47] = @105 */
  if (res[2]) casadi_copy(w105, 96, res[2]+4512);
  /* #298: output[2][48] = @107 */
  if (res[2]) casadi_copy(w107, 8, res[2]+4608);
  /* #299: @1 = landing(@7, @6, @4) */
  arg1[0]=w007;
  arg1[1]=w006;
  arg1[2]=(&w004);
  res1[0]=w001;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #300: output[3][0] = @1 */
  casadi_copy(w001, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f110(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_576_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_576_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_576_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_576_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_576_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_576_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_576_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_576_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_576_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_576_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_576_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s21;
    case 1: return casadi_s22;
    case 2: return casadi_s22;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_576_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 9620;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 9620*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_trace_768:(u[3],p)->(w[4x769],g[8x769],dg[8x769],R[3]) */
static int casadi_f111(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+303, w002, w003, w004, *w005=w+306, *w006=w+330, *w007=w+332, *w008=w+336, *w009=w+340;
  casadi_real *w010=w+388, *w011=w+484, *w012=w+580, *w013=w+676, *w014=w+772, *w015=w+868, *w016=w+964, *w017=w+1060, *w018=w+1156, *w019=w+1252, *w020=w+1348, *w021=w+1444;
  casadi_real *w022=w+1540, *w023=w+1636, *w024=w+1732, *w025=w+1828, *w026=w+1924, *w027=w+2020, *w028=w+2116, *w029=w+2212, *w030=w+2308, *w031=w+2404, *w032=w+2500, *w033=w+2596;
  casadi_real *w034=w+2692, *w035=w+2788, *w036=w+2884, *w037=w+2980, *w038=w+3076, *w039=w+3172, *w040=w+3268, *w041=w+3364, *w042=w+3460, *w043=w+3556, *w044=w+3652, *w045=w+3748;
  casadi_real *w046=w+3844, *w047=w+3940, *w048=w+4036, *w049=w+4132, *w050=w+4228, *w051=w+4324, *w052=w+4420, *w053=w+4516, *w054=w+4612, *w055=w+4708, *w056=w+4804, *w057=w+4900;
  casadi_real *w058=w+4996, *w059=w+5092, *w060=w+5188, *w061=w+5284, *w062=w+5380, *w063=w+5476, *w064=w+5572, *w065=w+5668, *w066=w+5764, *w067=w+5860, *w068=w+5956, *w069=w+6052;
  casadi_real *w070=w+6148, *w071=w+6244, *w072=w+6340, *w073=w+6436, *w074=w+6532, *w075=w+6628, *w076=w+6724, *w077=w+6820, *w078=w+6916, *w079=w+7012, *w080=w+7108, *w081=w+7204;
  casadi_real *w082=w+7300, *w083=w+7396, *w084=w+7492, *w085=w+7588, *w086=w+7684, *w087=w+7780, *w088=w+7876, *w089=w+7972, *w090=w+8068, *w091=w+8164, *w092=w+8260, *w093=w+8356;
  casadi_real *w094=w+8452, *w095=w+8548, *w096=w+8644, *w097=w+8740, *w098=w+8836, *w099=w+8932, *w100=w+9028, *w101=w+9124, *w102=w+9220, *w103=w+9316, *w104=w+9412, *w105=w+9508;
  casadi_real *w106=w+9604, *w107=w+9700, *w108=w+9796, *w109=w+9892, *w110=w+9988, *w111=w+10084, *w112=w+10180, *w113=w+10276, *w114=w+10372, *w115=w+10468, *w116=w+10564, *w117=w+10660;
  casadi_real *w118=w+10756, *w119=w+10852, *w120=w+10948, *w121=w+11044, *w122=w+11140, *w123=w+11236, *w124=w+11332, *w125=w+11428, *w126=w+11524, *w127=w+11620, *w128=w+11716, *w129=w+11812;
  casadi_real *w130=w+11908, *w131=w+12004, *w132=w+12100, *w133=w+12196, *w134=w+12292, *w135=w+12388, *w136=w+12484, *w137=w+12580, *w138=w+12676, *w139=w+12684;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 3, w001);
  /* #2: @2 = @1[2] */
  for (rr=(&w002), cs=w001+2; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #3: @3 = 768 */
  w003 = 768.;
  /* #4: @3 = (@2/@3) */
  w003  = (w002/w003);
  /* #5: @4 = input[1][0] */
  w004 = arg[1] ? arg[1][0] : 0;
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=(&w004);
  res1[0]=w005;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w006, cs=w001+0; cs!=w001+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=(&w004);
  res1[0]=w007;
  res1[1]=0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w010;
  res1[3]=w011;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w009, 48, res[0]);
  /* #11: @0 = 0.015625 */
  w000 = 1.5625000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w000 *= w002;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w012;
  res1[3]=w013;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+48);
  /* #15: @0 = 0.03125 */
  w000 = 3.1250000000000000e-02;
  /* #16: @0 = (@0*@2) */
  w000 *= w002;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w014;
  res1[3]=w015;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+96);
  /* #19: @0 = 0.046875 */
  w000 = 4.6875000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w000 *= w002;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w016;
  res1[3]=w017;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+144);
  /* #23: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #24: @0 = (@0*@2) */
  w000 *= w002;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w018;
  res1[3]=w019;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+192);
  /* #27: @0 = 0.078125 */
  w000 = 7.8125000000000000e-02;
  /* #28: @0 = (@0*@2) */
  w000 *= w002;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w020;
  res1[3]=w021;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+240);
  /* #31: @0 = 0.09375 */
  w000 = 9.3750000000000000e-02;
  /* #32: @0 = (@0*@2) */
  w000 *= w002;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w022;
  res1[3]=w023;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+288);
  /* #35: @0 = 0.109375 */
  w000 = 1.0937500000000000e-01;
  /* #36: @0 = (@0*@2) */
  w000 *= w002;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w024;
  res1[3]=w025;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+336);
  /* #39: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w000 *= w002;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w026;
  res1[3]=w027;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+384);
  /* #43: @0 = 0.140625 */
  w000 = 1.4062500000000000e-01;
  /* #44: @0 = (@0*@2) */
  w000 *= w002;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w028;
  res1[3]=w029;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+432);
  /* #47: @0 = 0.15625 */
  w000 = 1.5625000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w000 *= w002;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w030;
  res1[3]=w031;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+480);
  /* #51: @0 = 0.171875 */
  w000 = 1.7187500000000000e-01;
  /* #52: @0 = (@0*@2) */
  w000 *= w002;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w032;
  res1[3]=w033;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+528);
  /* #55: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w000 *= w002;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w034;
  res1[3]=w035;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+576);
  /* #59: @0 = 0.203125 */
  w000 = 2.0312500000000000e-01;
  /* #60: @0 = (@0*@2) */
  w000 *= w002;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w036;
  res1[3]=w037;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+624);
  /* #63: @0 = 0.21875 */
  w000 = 2.1875000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w000 *= w002;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w038;
  res1[3]=w039;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+672);
  /* #67: @0 = 0.234375 */
  w000 = 2.3437500000000000e-01;
  /* #68: @0 = (@0*@2) */
  w000 *= w002;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w040;
  res1[3]=w041;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+720);
  /* #71: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #72: @0 = (@0*@2) */
  w000 *= w002;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w042;
  res1[3]=w043;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+768);
  /* #75: @0 = 0.265625 */
  w000 = 2.6562500000000000e-01;
  /* #76: @0 = (@0*@2) */
  w000 *= w002;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w044;
  res1[3]=w045;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+816);
  /* #79: @0 = 0.28125 */
  w000 = 2.8125000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w000 *= w002;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w046;
  res1[3]=w047;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+864);
  /* #83: @0 = 0.296875 */
  w000 = 2.9687500000000000e-01;
  /* #84: @0 = (@0*@2) */
  w000 *= w002;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w048;
  res1[3]=w049;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+912);
  /* #87: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #88: @0 = (@0*@2) */
  w000 *= w002;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w050;
  res1[3]=w051;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+960);
  /* #91: @0 = 0.328125 */
  w000 = 3.2812500000000000e-01;
  /* #92: @0 = (@0*@2) */
  w000 *= w002;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w052;
  res1[3]=w053;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1008);
  /* #95: @0 = 0.34375 */
  w000 = 3.4375000000000000e-01;
  /* #96: @0 = (@0*@2) */
  w000 *= w002;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w054;
  res1[3]=w055;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1056);
  /* #99: @0 = 0.359375 */
  w000 = 3.5937500000000000e-01;
  /* #100: @0 = (@0*@2) */
  w000 *= w002;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w056;
  res1[3]=w057;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1104);
  /* #103: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w000 *= w002;
  /* #105: {@8, @9, @58, @59} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w058;
  res1[3]=w059;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1152);
  /* #107: @0 = 0.390625 */
  w000 = 3.9062500000000000e-01;
  /* #108: @0 = (@0*@2) */
  w000 *= w002;
  /* #109: {@7, @9, @60, @61} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w060;
  res1[3]=w061;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1200);
  /* #111: @0 = 0.40625 */
  w000 = 4.0625000000000000e-01;
  /* #112: @0 = (@0*@2) */
  w000 *= w002;
  /* #113: {@8, @9, @62, @63} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w062;
  res1[3]=w063;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1248);
  /* #115: @0 = 0.421875 */
  w000 = 4.2187500000000000e-01;
  /* #116: @0 = (@0*@2) */
  w000 *= w002;
  /* #117: {@7, @9, @64, @65} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w064;
  res1[3]=w065;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1296);
  /* #119: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #120: @0 = (@0*@2) */
  w000 *= w002;
  /* #121: {@8, @9, @66, @67} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w066;
  res1[3]=w067;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1344);
  /* #123: @0 = 0.453125 */
  w000 = 4.5312500000000000e-01;
  /* #124: @0 = (@0*@2) */
  w000 *= w002;
  /* #125: {@7, @9, @68, @69} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w068;
  res1[3]=w069;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1392);
  /* #127: @0 = 0.46875 */
  w000 = 4.6875000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w000 *= w002;
  /* #129: {@8, @9, @70, @71} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w070;
  res1[3]=w071;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1440);
  /* #131: @0 = 0.484375 */
  w000 = 4.8437500000000000e-01;
  /* #132: @0 = (@0*@2) */
  w000 *= w002;
  /* #133: {@7, @9, @72, @73} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w072;
  res1[3]=w073;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1488);
  /* #135: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #136: @0 = (@0*@2) */
  w000 *= w002;
  /* #137: {@8, @9, @74, @75} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w074;
  res1[3]=w075;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #138: output[0][32] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1536);
  /* #139: @0 = 0.515625 */
  w000 = 5.1562500000000000e-01;
  /* #140: @0 = (@0*@2) */
  w000 *= w002;
  /* #141: {@7, @9, @76, @77} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w076;
  res1[3]=w077;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #142: output[0][33] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1584);
  /* #143: @0 = 0.53125 */
  w000 = 5.3125000000000000e-01;
  /* #144: @0 = (@0*@2) */
  w000 *= w002;
  /* #145: {@8, @9, @78, @79} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w078;
  res1[3]=w079;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #146: output[0][34] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1632);
  /* #147: @0 = 0.546875 */
  w000 = 5.4687500000000000e-01;
  /* #148: @0 = (@0*@2) */
  w000 *= w002;
  /* #149: {@7, @9, @80, @81} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w080;
  res1[3]=w081;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #150: output[0][35] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1680);
  /* #151: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #152: @0 = (@0*@2) */
  w000 *= w002;
  /* #153: {@8, @9, @82, @83} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w082;
  res1[3]=w083;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #154: output[0][36] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1728);
  /* #155: @0 = 0.578125 */
  w000 = 5.7812500000000000e-01;
  /* #156: @0 = (@0*@2) */
  w000 *= w002;
  /* #157: {@7, @9, @84, @85} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w084;
  res1[3]=w085;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #158: output[0][37] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1776);
  /* #159: @0 = 0.59375 */
  w000 = 5.9375000000000000e-01;
  /* #160: @0 = (@0*@2) */
  w000 *= w002;
  /* #161: {@8, @9, @86, @87} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w086;
  res1[3]=w087;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #162: output[0][38] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1824);
  /* #163: @0 = 0.609375 */
  w000 = 6.0937500000000000e-01;
  /* #164: @0 = (@0*@2) */
  w000 *= w002;
  /* #165: {@7, @9, @88, @89} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w088;
  res1[3]=w089;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][39] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1872);
  /* #167: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #168: @0 = (@0*@2) */
  w000 *= w002;
  /* #169: {@8, @9, @90, @91} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w090;
  res1[3]=w091;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #170: output[0][40] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1920);
  /* #171: @0 = 0.640625 */
  w000 = 6.4062500000000000e-01;
  /* #172: @0 = (@0*@2) */
  w000 *= w002;
  /* #173: {@7, @9, @92, @93} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w092;
  res1[3]=w093;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #174: output[0][41] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+1968);
  /* #175: @0 = 0.65625 */
  w000 = 6.5625000000000000e-01;
  /* #176: @0 = (@0*@2) */
  w000 *= w002;
  /* #177: {@8, @9, @94, @95} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w094;
  res1[3]=w095;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #178: output[0][42] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2016);
  /* #179: @0 = 0.671875 */
  w000 = 6.7187500000000000e-01;
  /* #180: @0 = (@0*@2) */
  w000 *= w002;
  /* #181: {@7, @9, @96, @97} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w096;
  res1[3]=w097;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #182: output[0][43] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2064);
  /* #183: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #184: @0 = (@0*@2) */
  w000 *= w002;
  /* #185: {@8, @9, @98, @99} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w098;
  res1[3]=w099;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #186: output[0][44] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2112);
  /* #187: @0 = 0.703125 */
  w000 = 7.0312500000000000e-01;
  /* #188: @0 = (@0*@2) */
  w000 *= w002;
  /* #189: {@7, @9, @100, @101} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w100;
  res1[3]=w101;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #190: output[0][45] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2160);
  /* #191: @0 = 0.71875 */
  w000 = 7.1875000000000000e-01;
  /* #192: @0 = (@0*@2) */
  w000 *= w002;
  /* #193: {@8, @9, @102, @103} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w102;
  res1[3]=w103;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #194: output[0][46] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2208);
  /* #195: @0 = 0.734375 */
  w000 = 7.3437500000000000e-01;
  /* #196: @0 = (@0*@2) */
  w000 *= w002;
  /* #197: {@7, @9, @104, @105} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w104;
  res1[3]=w105;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #198: output[0][47] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2256);
  /* #199: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #200: @0 = (@0*@2) */
  w000 *= w002;
  /* #201: {@8, @9, @106, @107} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w106;
  res1[3]=w107;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #202: output[0][48] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2304);
  /* #203: @0 = 0.765625 */
  w000 = 7.6562500000000000e-01;
  /* #204: @0 = (@0*@2) */
  w000 *= w002;
  /* #205: {@7, @9, @108, @109} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w108;
  res1[3]=w109;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #206: output[0][49] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2352);
  /* #207: @0 = 0.78125 */
  w000 = 7.8125000000000000e-01;
  /* #208: @0 = (@0*@2) */
  w000 *= w002;
  /* #209: {@8, @9, @110, @111} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w110;
  res1[3]=w111;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #210: output[0][50] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2400);
  /* #211: @0 = 0.796875 */
  w000 = 7.9687500000000000e-01;
  /* #212: @0 = (@0*@2) */
  w000 *= w002;
  /* #213: {@7, @9, @112, @113} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w112;
  res1[3]=w113;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #214: output[0][51] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2448);
  /* #215: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #216: @0 = (@0*@2) */
  w000 *= w002;
  /* #217: {@8, @9, @114, @115} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w114;
  res1[3]=w115;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #218: output[0][52] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2496);
  /* #219: @0 = 0.828125 */
  w000 = 8.2812500000000000e-01;
  /* #220: @0 = (@0*@2) */
  w000 *= w002;
  /* #221: {@7, @9, @116, @117} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w116;
  res1[3]=w117;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #222: output[0][53] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2544);
  /* #223: @0 = 0.84375 */
  w000 = 8.4375000000000000e-01;
  /* #224: @0 = (@0*@2) */
  w000 *= w002;
  /* #225: {@8, @9, @118, @119} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w118;
  res1[3]=w119;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #226: output[0][54] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2592);
  /* #227: @0 = 0.859375 */
  w000 = 8.5937500000000000e-01;
  /* #228: @0 = (@0*@2) */
  w000 *= w002;
  /* #229: {@7, @9, @120, @121} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w120;
  res1[3]=w121;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #230: output[0][55] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2640);
  /* #231: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #232: @0 = (@0*@2) */
  w000 *= w002;
  /* #233: {@8, @9, @122, @123} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w122;
  res1[3]=w123;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #234: output[0][56] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2688);
  /* #235: @0 = 0.890625 */
  w000 = 8.9062500000000000e-01;
  /* #236: @0 = (@0*@2) */
  w000 *= w002;
  /* #237: {@7, @9, @124, @125} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w124;
  res1[3]=w125;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #238: output[0][57] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2736);
  /* #239: @0 = 0.90625 */
  w000 = 9.0625000000000000e-01;
  /* #240: @0 = (@0*@2) */
  w000 *= w002;
  /* #241: {@8, @9, @126, @127} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w126;
  res1[3]=w127;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #242: output[0][58] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2784);
  /* #243: @0 = 0.921875 */
  w000 = 9.2187500000000000e-01;
  /* #244: @0 = (@0*@2) */
  w000 *= w002;
  /* #245: {@7, @9, @128, @129} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w128;
  res1[3]=w129;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #246: output[0][59] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2832);
  /* #247: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #248: @0 = (@0*@2) */
  w000 *= w002;
  /* #249: {@8, @9, @130, @131} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w130;
  res1[3]=w131;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #250: output[0][60] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2880);
  /* #251: @0 = 0.953125 */
  w000 = 9.5312500000000000e-01;
  /* #252: @0 = (@0*@2) */
  w000 *= w002;
  /* #253: {@7, @9, @132, @133} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w132;
  res1[3]=w133;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #254: output[0][61] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2928);
  /* #255: @0 = 0.96875 */
  w000 = 9.6875000000000000e-01;
  /* #256: @0 = (@0*@2) */
  w000 *= w002;
  /* #257: {@8, @9, @134, @135} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w134;
  res1[3]=w135;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #258: output[0][62] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+2976);
  /* #259: @0 = 0.984375 */
  w000 = 9.8437500000000000e-01;
  /* #260: @0 = (@0*@2) */
  w000 *= w002;
  /* #261: {@7, @9, @136, @137} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=(&w004);
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w136;
  res1[3]=w137;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #262: output[0][63] = @9 */
  if (res[0]) casadi_copy(w009, 48, res[0]+3024);
  /* #263: output[0][64] = @7 */
  if (res[0]) casadi_copy(w007, 4, res[0]+3072);
  /* #264: output[1][0] = @10 */
  casadi_copy(w010, 96, res[1]);
  /* #265: output[1][1] = @12 */
  if (res[1]) casadi_copy(w012, 96, res[1]+96);
  /* #266: output[1][2] = @14 */
  if (res[1]) casadi_copy(w014, 96, res[1]+192);
  /* #267: output[1][3] = @16 */
  if (res[1]) casadi_copy(w016, 96, res[1]+288);
  /* #268: output[1][4] = @18 */
  if (res[1]) casadi_copy(w018, 96, res[1]+384);
  /* #269: output[1][5] = @20 */
  if (res[1]) casadi_copy(w020, 96, res[1]+480);
  /* #270: output[1][6] = @22 */
  if (res[1]) casadi_copy(w022, 96, res[1]+576);
  /* #271: output[1][7] = @24 */
  if (res[1]) casadi_copy(w024, 96, res[1]+672);
  /* #272: output[1][8] = @26 */
  if (res[1]) casadi_copy(w026, 96, res[1]+768);
  /* #273: output[1][9] = @28 */
  if (res[1]) casadi_copy(w028, 96, res[1]+864);
  /* #274: output[1][10] = @30 */
  if (res[1]) casadi_copy(w030, 96, res[1]+960);
  /* #275: output[1][11] = @32 */
  if (res[1]) casadi_copy(w032, 96, res[1]+1056);
  /* #276: output[1][12] = @34 */
  if (res[1]) casadi_copy(w034, 96, res[1]+1152);
  /* #277: output[1][13] = @36 */
  if (res[1]) casadi_copy(w036, 96, res[1]+1248);
  /* #278: output[1][14] = @38 */
  if (res[1]) casadi_copy(w038, 96, res[1]+1344);
  /* #279: output[1][15] = @40 */
  if (res[1]) casadi_copy(w040, 96, res[1]+1440);
  /* #280: output[1][16] = @42 */
  if (res[1]) casadi_copy(w042, 96, res[1]+1536);
  /* #281: output[1][17] = @44 */
  if (res[1]) casadi_copy(w044, 96, res[1]+1632);
  /* #282: output[1][18] = @46 */
  if (res[1]) casadi_copy(w046, 96, res[1]+1728);
  /* #283: output[1][19] = @48 */
  if (res[1]) casadi_copy(w048, 96, res[1]+1824);
  /* #284: output[1][20] = @50 */
  if (res[1]) casadi_copy(w050, 96, res[1]+1920);
  /* #285: output[1][21] = @52 */
  if (res[1]) casadi_copy(w052, 96, res[1]+2016);
  /* #286: output[1][22] = @54 */
  if (res[1]) casadi_copy(w054, 96, res[1]+2112);
  /* #287: output[1][23] = @56 */
  if (res[1]) casadi_copy(w056, 96, res[1]+2208);
  /* #288: output[1][24] = @58 */
  if (res[1]) casadi_copy(w058, 96, res[1]+2304);
  /* #289: output[1][25] = @60 */
  if (res[1]) casadi_copy(w060, 96, res[1]+2400);
  /* #290: output[1][26] = @62 */
  if (res[1]) casadi_copy(w062, 96, res[1]+2496);
  /* #291: output[1][27] = @64 */
  if (res[1]) casadi_copy(w064, 96, res[1]+2592);
  /* #292: output[1][28] = @66 */
  if (res[1]) casadi_copy(w066, 96, res[1]+2688);
  /* #293: output[1][29] = @68 */
  if (res[1]) casadi_copy(w068, 96, res[1]+2784);
  /* #294: output[1][30] = @70 */
  if (res[1]) casadi_copy(w070, 96, res[1]+2880);
  /* #295: output[1][31] = @72 */
  if (res[1]) casadi_copy(w072, 96, res[1]+2976);
  /* #296: output[1][32] = @74 */
  if (res[1]) casadi_copy(w074, 96, res[1]+3072);
  /* #297: output[1][33] = @76 */
  if (res[1]) casadi_copy(w076, 96, res[1]+3168);
  /* #298: output[1][34] = @78 */
  if (res[1]) casadi_copy(w078, 96, res[1]+3264);
  /* #299: output[1][35] = @80 */
  if (res[1]) casadi_copy(w080, 96, res[1]+3360);
  /* #300: output[1][36] = @82 */
  if (res[1]) casadi_copy(w082, 96, res[1]+3456);
  /* #301: output[1][37] = @84 */
  if (res[1]) casadi_copy(w084, 96, res[1]+3552);
  /* #302: output[1][38] = @86 */
  if (res[1]) casadi_copy(w086, 96, res[1]+3648);
  /* #303: output[1][39] = @88 */
  if (res[1]) casadi_copy(w088, 96, res[1]+3744);
  /* #304: output[1][40] = @90 */
  if (res[1]) casadi_copy(w090, 96, res[1]+3840);
  /* #305: output[1][41] = @92 */
  if (res[1]) casadi_copy(w092, 96, res[1]+3936);
  /* #306: output[1][42] = @94 */
  if (res[1]) casadi_copy(w094, 96, res[1]+4032);
  /* #307: output[1][43] = @96 */
  if (res[1]) casadi_copy(w096, 96, res[1]+4128);
  /* #308: output[1][44] = @98 */
  if (res[1]) casadi_copy(w098, 96, res[1]+4224);
  /* #309: output[1][45] = @100 */
  if (res[1]) casadi_copy(w100, 96, res[1]+4320);
  /* #310: output[1][46] = @102 */
  if (res[1]) casadi_copy(w102, 96, res[1]+4416);
  /* #311: output[1][47] = @104 */
  if (res[1]) casadi_copy(w104, 96, res[1]+4512);
  /* #312: output[1][48] = @106 */
  if (res[1]) casadi_copy(w106, 96, res[1]+4608);
  /* #313: output[1][49] = @108 */
  if (res[1]) casadi_copy(w108, 96, res[1]+4704);
  /* #314: output[1][50] = @110 */
  if (res[1]) casadi_copy(w110, 96, res[1]+4800);
  /* #315: output[1][51] = @112 */
  if (res[1]) casadi_copy(w112, 96, res[1]+4896);
  /* #316: output[1][52] = @114 */
  if (res[1]) casadi_copy(w114, 96, res[1]+4992);
  /* #317: output[1][53] = @116 */
  if (res[1]) casadi_copy(w116, 96, res[1]+5088);
  /* #318: output[1][54] = @118 */
  if (res[1]) casadi_copy(w118, 96, res[1]+5184);
  /* #319: output[1][55] = @120 */
  if (res[1]) casadi_copy(w120, 96, res[1]+5280);
  /* #320: output[1][56] = @122 */
  if (res[1]) casadi_copy(w122, 96, res[1]+5376);
  /* #321: output[1][57] = @124 */
  if (res[1]) casadi_copy(w124, 96, res[1]+5472);
  /* #322: output[1][58] = @126 */
  if (res[1]) casadi_copy(w126, 96, res[1]+5568);
  /* #323: output[1][59] = @128 */
  if (res[1]) casadi_copy(w128, 96, res[1]+5664);
  /* #324: output[1][60] = @130 */
  if (res[1]) casadi_copy(w130, 96, res[1]+5760);
  /* #325: output[1][61] = @132 */
  if (res[1]) casadi_copy(w132, 96, res[1]+5856);
  /* #326: output[1][62] = @134 */
  if (res[1]) casadi_copy(w134, 96, res[1]+5952);
  /* #327: output[1][63] = @136 */
  if (res[1]) casadi_copy(w136, 96, res[1]+6048);
  /* #328: {@138, @139} = observe(@2, @7, @4) */
  arg1[0]=(&w002);
  arg1[1]=w007;
  arg1[2]=(&w004);
  res1[0]=w138;
  res1[1]=w139;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #329: output[1][64] = @138 */
  if (res[1]) casadi_copy(w138, 8, res[1]+6144);
  /* #330: output[2][0] = @11 */
  casadi_copy(w011, 96, res[2]);
  /* #331: output[2][1] = @13 */
  if (res[2]) casadi_copy(w013, 96, res[2]+96);
  /* #332: output[2][2] = @15 */
  if (res[2]) casadi_copy(w015, 96, res[2]+192);
  /* #333: output[2][3] = @17 */
  if (res[2]) casadi_copy(w017, 96, res[2]+288);
  /* #334: output[2][4] = @19 */
  if (res[2]) casadi_copy(w019, 96, res[2]+384);
  /* #335: output[2][5] = @21 */
  if (res[2]) casadi_copy(w021, 96, res[2]+480);
  /* #336: output[2][6] = @23 */
  if (res[2]) casadi_copy(w023, 96, res[2]+576);
  /* #337: output[2][7] = @25 */
  if (res[2]) casadi_copy(w025, 96, res[2]+672);
  /* #338: output[2][8] = @27 */
  if (res[2]) casadi_copy(w027, 96, res[2]+768);
  /* #339: output[2][9] = @29 */
  if (res[2]) casadi_copy(w029, 96, res[2]+864);
  /* #340: output[2][10] = @31 */
  if (res[2]) casadi_copy(w031, 96, res[2]+960);
  /* #341: output[2][11] = @33 */
  if (res[2]) casadi_copy(w033, 96, res[2]+1056);
  /* #342: output[2][12] = @35 */
  if (res[2]) casadi_copy(w035, 96, res[2]+1152);
  /* #343: output[2][13] = @37 */
  if (res[2]) casadi_copy(w037, 96, res[2]+1248);
  /* #344: output[2][14] = @39 */
  if (res[2]) casadi_copy(w039, 96, res[2]+1344);
  /* #345: output[2][15] = @41 */
  if (res[2]) casadi_copy(w041, 96, res[2]+1440);
  /* #346: output[2][16] = @43 */
  if (res[2]) casadi_copy(w043, 96, res[2]+1536);
  /* #347: output[2][17] = @45 */
  if (res[2]) casadi_copy(w045, 96, res[2]+1632);
  /* #348: output[2][18] = @47 */
  if (res[2]) casadi_copy(w047, 96, res[2]+1728);
  /* #349: output[2][19] = @49 */
  if (res[2]) casadi_copy(w049, 96, res[2]+1824);
  /* #350: output[2][20] = @51 */
  if (res[2]) casadi_copy(w051, 96, res[2]+1920);
  /* #351: output[2][21] = @53 */
  if (res[2]) casadi_copy(w053, 96, res[2]+2016);
  /* #352: output[2][22] = @55 */
  if (res[2]) casadi_copy(w055, 96, res[2]+2112);
  /* #353: output[2][23] = @57 */
  if (res[2]) casadi_copy(w057, 96, res[2]+2208);
  /* #354: output[2][24] = @59 */
  if (res[2]) casadi_copy(w059, 96, res[2]+2304);
  /* #355: output[2][25] = @61 */
  if (res[2]) casadi_copy(w061, 96, res[2]+2400);
  /* #356: output[2][26] = @63 */
  if (res[2]) casadi_copy(w063, 96, res[2]+2496);
  /* #357: output[2][27] = @65 */
  if (res[2]) casadi_copy(w065, 96, res[2]+2592);
  /* #358: output[2][28] = @67 */
  if (res[2]) casadi_copy(w067, 96, res[2]+2688);
  /* #359: output[2][29] = @69 */
  if (res[2]) casadi_copy(w069, 96, res[2]+2784);
  /* #360: output[2][30] = @71 */
  if (res[2]) casadi_copy(w071, 96, res[2]+2880);
  /* #361: output[2][31] = @73 */
  if (res[2]) casadi_copy(w073, 96, res[2]+2976);
  /* #362: output[2][32] = @75 */
  if (res[2]) casadi_copy(w075, 96, res[2]+3072);
  /* #363: output[2][33] = @77 */
  if (res[2]) casadi_copy(w077, 96, res[2]+3168);
  /* #364: output[2][34] = @79 */
  if (res[2]) casadi_copy(w079, 96, res[2]+3264);
  /* #365: output[2][35] = @81 */
  if (res[2]) casadi_copy(w081, 96, res[2]+3360);
  /* #366: output[2][36] = @83 */
  if (res[2]) casadi_copy(w083, 96, res[2]+3456);
  /* #367: output[2][37] = @85 */
  if (res[2]) casadi_copy(w085, 96, res[2]+3552);
  /* #368: output[2][38] = @87 */
  if (res[2]) casadi_copy(w087, 96, res[2]+3648);
  /* #369: output[2][39] = @89 */
  if (res[2]) casadi_copy(w089, 96, res[2]+3744);
  /* #370: output[2][40] = @91 */
  if (res[2]) casadi_copy(w091, 96, res[2]+3840);
  /* #371: output[2][41] = @93 */
  if (res[2]) casadi_copy(w093, 96, res[2]+3936);
  /* #372: output[2][42] = @95 */
  if (res[2]) casadi_copy(w095, 96, res[2]+4032);
  /* #373: output[2][43] = @97 */
  if (res[2]) casadi_copy(w097, 96, res[2]+4128);
  /* #374: output[2][44] = @99 */
  if (res[2]) casadi_copy(w099, 96, res[2]+4224);
  /* #375: output[2][45] = @101 */
  if (res[2]) casadi_copy(w101, 96, res[2]+4320);
  /* #376: output[2][46] = @103 */
  if (res[2]) casadi_copy(w103, 96, res[2]+4416);
  /* #377: output[2][47] = @105 */
  if (res[2]) casadi_copy(w105, 96, res[2]+4512);
  /* #378: output[2][48] = @107 */
  if (res[2]) casadi_copy(w107, 96, res[2]+4608);
  /* #379: output[2][49] = @109 */
  if (res[2]) casadi_copy(w109, 96, res[2]+4704);
  /* #380: output[2][50] = @111 */
  if (res[2]) casadi_copy(w111, 96, res[2]+4800);
  /* #381: output[2][51] = @113 */
  if (res[2]) casadi_copy(w113, 96, res[2]+4896);
  /* #382: output[2][52] = @115 */
  if (res[2]) casadi_copy(w115, 96, res[2]+4992);
  /* #383: output[2][53] = @117 */
  if (res[2]) casadi_copy(w117, 96, res[2]+5088);
  /* #384: output[2][54] = @119 */
  if (res[2]) casadi_copy(w119, 96, res[2]+5184);
  /* #385: output[2][55] = @121 */
  if (res[2]) casadi_copy(w121, 96, res[2]+5280);
  /* #386: output[2][56] = @123 */
  if (res[2]) casadi_copy(w123, 96, res[2]+5376);
  /* #387: output[2][57] = @125 */
  if (res[2]) casadi_copy(w125, 96, res[2]+5472);
  /* #388: output[2][58] = @127 */
  if (res[2]) casadi_copy(w127, 96, res[2]+5568);
  /* #389: output[2][59] = @129 */
  if (res[2]) casadi_copy(w129, 96, res[2]+5664);
  /* #390: output[2][60] = @131 */
  if (res[2]) casadi_copy(w131, 96, res[2]+5760);
  /* #391: output[2][61] = @133 */
  if (res[2]) casadi_copy(w133, 96, res[2]+5856);
  /* #392: output[2][62] = @135 */
  if (res[2]) casadi_copy(w135, 96, res[2]+5952);
  /* #393: output[2][63] = @137 */
  if (res[2]) casadi_copy(w137, 96, res[2]+6048);
  /* #394: output[2][64] = @139 */
  if (res[2]) casadi_copy(w139, 8, res[2]+6144);
  /* #395: @1 = landing(@7, @6, @4) */
  arg1[0]=w007;
  arg1[1]=w006;
  arg1[2]=(&w004);
  res1[0]=w001;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #396: output[3][0] = @1 */
  casadi_copy(w001, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f111(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s23;
    case 1: return casadi_s24;
    case 2: return casadi_s24;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12692;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12692*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_advance:(t,w[4],h,p)->(w_end[4],g[8],dg[8]) */
static int casadi_f112(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+117, w1, w2, *w3=w+121, w4, *w5=w+123, *w6=w+147, *w7=w+151, *w8=w+159;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[1][0] */
  casadi_copy(arg[1], 4, w0);
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[3][0] */
  w2 = arg[3] ? arg[3][0] : 0;
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  w4 = arg[2] ? arg[2][0] : 0;
  /* #5: @5 = turns(@4, @2) */
  arg1[0]=(&w4);
  arg1[1]=(&w2);
  res1[0]=w5;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #6: @6 = working_step(@0, @3, @5, @4, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=w5;
  arg1[3]=(&w4);
  arg1[4]=(&w2);
  res1[0]=w6;
  if (casadi_f102(arg1, res1, iw, w, 0)) return 1;
  /* #7: output[0][0] = @6 */
  casadi_copy(w6, 4, res[0]);
  /* #8: @1 = (@1+@4) */
  w1 += w4;
  /* #9: {@7, @8} = observe(@1, @6, @2) */
  arg1[0]=(&w1);
  arg1[1]=w6;
  arg1[2]=(&w2);
  res1[0]=w7;
  res1[1]=w8;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[1][0] = @7 */
  casadi_copy(w7, 8, res[1]);
  /* #11: output[2][0] = @8 */
  casadi_copy(w8, 8, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f112(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s25;
    case 2: return casadi_s5;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s26;
    case 2: return casadi_s26;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 167;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 167*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_begin:(u[3],p)->(y[4x3]) */
static int casadi_f113(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+5, *w1=w+8, w2, *w3=w+10, *w4=w+14;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=(&w2);
  res1[0]=w3;
  res1[1]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #4: output[0][0] = @3 */
  casadi_copy(w3, 4, res[0]);
  /* #5: output[0][1] = @4 */
  if (res[0]) casadi_copy(w4, 8, res[0]+4);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_begin(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f113(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_begin_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_begin_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_begin_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_begin_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_begin_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_begin_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_begin_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_begin_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_begin_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_begin_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_begin_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_begin_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 22;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_begin_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 22*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_swing:(t,h,y[4x3],p)->(y_end[4x3]) */
static int casadi_f114(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, w3, *w4=w+266, *w5=w+290;
  const casadi_real **arg1=arg+4, *wr0;
  /* #0: @0 = input[2][0] */
  wr0 = arg[2] ? arg[2] : casadi_zeros;
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[3][0] */
  w3 = arg[3] ? arg[3][0] : 0;
  /* #4: @4 = turns(@2, @3) */
  arg1[0]=(&w2);
  arg1[1]=(&w3);
  res1[0]=w4;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = variational_steps(@0, @1, @4, @2, @3) */
  arg1[0]=wr0;
  arg1[1]=(&w1);
  arg1[2]=w4;
  arg1[3]=(&w2);
  arg1[4]=(&w3);
  res1[0]=w5;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 12, res[0]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f114(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_swing_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "y";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y_end";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s5;
    case 2: return casadi_s27;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 302;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 302*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_end:(y[4x3],u[3],p)->(J[3x3],R[3]) */
static int casadi_f115(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w1=w+10, *w2=w+13, w3, w4, *w5=w+15;
  const casadi_real **arg1=arg+3, *cs, *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = @1[:2] */
  for (rr=w2, cs=w1+0; cs!=w1+2; cs+=1) *rr++ = *cs;
  /* #3: @3 = @1[2] */
  for (rr=(&w3), cs=w1+2; cs!=w1+3; cs+=1) *rr++ = *cs;
  /* #4: @4 = input[2][0] */
  w4 = arg[2] ? arg[2][0] : 0;
  /* #5: {@5, @1} = landing_with_derivative(@0, @2, @3, @4) */
  arg1[0]=wr0;
  arg1[1]=w2;
  arg1[2]=(&w3);
  arg1[3]=(&w4);
  res1[0]=w5;
  res1[1]=w1;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 9, res[0]);
  /* #7: output[1][0] = @1 */
  casadi_copy(w1, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_end(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f115(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_end_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_end_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_end_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_end_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_end_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_end_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_end_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_end_name_in(casadi_int i) {
  switch (i) {
    case 0: return "y";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_end_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_end_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s27;
    case 1: return casadi_s4;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_end_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_end_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 24;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 24*sizeof(casadi_real);
  return 0;
}

/* simplest_walker_observed_swing:(t,h,w[4],p)->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f116(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, w2, *w3=w+303, *w4=w+327, *w5=w+331, *w6=w+335, *w7=w+383, *w8=w+479;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[3][0] */
  w2 = arg[3] ? arg[3][0] : 0;
  /* #3: @3 = turns(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=(&w2);
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  casadi_copy(arg[2], 4, w4);
  /* #5: {@5, @6, @7, @8} = working_steps(@0, @3, @4, @1, @2) */
  arg1[0]=(&w0);
  arg1[1]=w3;
  arg1[2]=w4;
  arg1[3]=(&w1);
  arg1[4]=(&w2);
  res1[0]=w5;
  res1[1]=w6;
  res1[2]=w7;
  res1[3]=w8;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 4, res[0]);
  /* #7: output[1][0] = @6 */
  casadi_copy(w6, 48, res[1]);
  /* #8: output[2][0] = @7 */
  casadi_copy(w7, 96, res[2]);
  /* #9: output[3][0] = @8 */
  casadi_copy(w8, 96, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f116(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int simplest_walker_observed_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void simplest_walker_observed_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_observed_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void simplest_walker_observed_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_observed_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int simplest_walker_observed_swing_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real simplest_walker_observed_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_observed_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "w";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* simplest_walker_observed_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "nodes";
    case 2: return "g";
    case 3: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_observed_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s5;
    case 2: return casadi_s25;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* simplest_walker_observed_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s28;
    case 2: return casadi_s29;
    case 3: return casadi_s29;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int simplest_walker_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 575;
  return 0;
}

CASADI_SYMBOL_EXPORT int simplest_walker_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 575*sizeof(casadi_real);
  return 0;
}



/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*simplest_walker_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int simplest_walker_map(simplest_walker_kernel kernel, const casadi_int* work_size, casadi_int n,
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
