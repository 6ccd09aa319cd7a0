/* Compass gait on a slope: kernels of the solver
 * Printed by CasADi 3.8.2 from equations 61ae9aa414b953a9.
 * Do not edit: run `stridemap derive`.
 * SPDX-License-Identifier: BSD-3-Clause
 */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) goswami_compass_kernels_ ## ID
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
CASADI_SYMBOL_EXPORT void goswami_compass_kernels_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int goswami_compass_kernels_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int goswami_compass_kernels_casadi_real_size(void) { return (int) sizeof(casadi_real); }

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
static const casadi_int casadi_s5[3] = {3, 1, 1};
static const casadi_int casadi_s6[3] = {4, 4, 1};
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
static const casadi_int casadi_s25[3] = {1, 1, 1};
static const casadi_int casadi_s26[3] = {8, 1, 1};
static const casadi_int casadi_s27[3] = {4, 12, 1};
static const casadi_int casadi_s28[3] = {8, 12, 1};

static const casadi_real casadi_c0[16] = 
  {1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 5.0000000000000000e-01,
  1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 5.0000000000000000e-01};
static const casadi_real casadi_c1[4] = {1., 1., 1., 2.};

static const casadi_real casadi_zeros[24] = 
  {0.};

/* start:(z[3],p[3])->(y[4],dy_dz[4x3]) */
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

/* turns:(h,p[3])->(turns[2x12]) */
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

/* phase:(t,p[3])->(phase[2]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[4x4],phase[2],turns[2x12],h,p[3])->(y_end[4x4]) */
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
  casadi_real a264, a265, a266, a267, a268, a269, a270;
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
  a012=1.;
  a013=(a007+a012);
  a009=(a009/a013);
  a014=(2.*a003);
  a014=(a008-a014);
  a009=(a009*a014);
  a015=arg[4]? arg[4][2] : 0;
  a016=(a015-a000);
  a016=(a016+a010);
  a017=sin(a016);
  a018=(a007*a017);
  a018=(a018/a013);
  a009=(a009+a018);
  a019=sin(a015);
  a020=cos(a000);
  a021=(a019*a020);
  a022=cos(a015);
  a023=sin(a000);
  a024=(a022*a023);
  a021=(a021-a024);
  a024=(a007/a013);
  a025=arg[4]? arg[4][0] : 0;
  a026=(a024-a025);
  a027=2.;
  a026=(a026-a027);
  a028=(a021*a026);
  a009=(a009+a028);
  a028=(2.*a007);
  a029=(a028*a007);
  a030=casadi_sq(a007);
  a031=(a030+a028);
  a031=(a031+a012);
  a029=(a029/a031);
  a028=(a028/a013);
  a031=cos(a010);
  a032=(a031+a012);
  a032=(a028*a032);
  a033=(a029-a032);
  a033=(a033+a025);
  a033=(a033+a027);
  a034=(a009/a033);
  a035=(a031-a024);
  a035=(a024*a035);
  a036=(a035/a033);
  a037=casadi_sq(a003);
  a037=(a037*a011);
  a037=(a037-a017);
  a037=(a024*a037);
  a009=(a036*a009);
  a009=(a037-a009);
  a017=casadi_sq(a013);
  a030=(a030/a017);
  a017=(a035*a036);
  a017=(a030-a017);
  a009=(a009/a017);
  a038=(a036*a009);
  a034=(a034-a038);
  a038=(a006*a034);
  a039=1.7082860872947386e-01;
  a039=(a039*a002);
  a040=2.9587585476806851e-02;
  a040=(a040*a002);
  a041=(a040*a009);
  a042=8.8762756430420545e-02;
  a042=(a042*a002);
  a043=1.9725056984537900e-02;
  a043=(a043*a002);
  a044=(a043*a034);
  a045=5.9175170953613701e-02;
  a045=(a045*a002);
  a046=5.2600151958767730e-02;
  a046=(a046*a002);
  a047=(a046*a009);
  a047=(a008+a047);
  a048=(a007*a047);
  a049=(a046*a008);
  a049=(a010+a049);
  a050=sin(a049);
  a048=(a048*a050);
  a048=(a048/a013);
  a051=(a046*a034);
  a051=(a003+a051);
  a052=(2.*a051);
  a052=(a047-a052);
  a048=(a048*a052);
  a053=(a046*a003);
  a053=(a000+a053);
  a054=(a015-a053);
  a054=(a054+a049);
  a055=sin(a054);
  a056=(a007*a055);
  a056=(a056/a013);
  a048=(a048+a056);
  a057=cos(a053);
  a058=(a019*a057);
  a053=sin(a053);
  a059=(a022*a053);
  a058=(a058-a059);
  a059=(a058*a026);
  a048=(a048+a059);
  a049=cos(a049);
  a059=(a049+a012);
  a059=(a028*a059);
  a060=(a029-a059);
  a060=(a060+a025);
  a060=(a060+a027);
  a061=(a048/a060);
  a062=(a049-a024);
  a062=(a024*a062);
  a063=(a062/a060);
  a064=casadi_sq(a051);
  a064=(a064*a050);
  a064=(a064-a055);
  a064=(a024*a064);
  a048=(a063*a048);
  a048=(a064-a048);
  a055=(a062*a063);
  a055=(a030-a055);
  a048=(a048/a055);
  a065=(a063*a048);
  a061=(a061-a065);
  a061=(a045*a061);
  a044=(a044+a061);
  a044=(a003+a044);
  a061=casadi_sq(a044);
  a065=(a043*a008);
  a066=(a045*a047);
  a065=(a065+a066);
  a065=(a010+a065);
  a066=sin(a065);
  a061=(a061*a066);
  a067=(a043*a003);
  a068=(a045*a051);
  a067=(a067+a068);
  a067=(a000+a067);
  a068=(a015-a067);
  a068=(a068+a065);
  a069=sin(a068);
  a061=(a061-a069);
  a061=(a024*a061);
  a065=cos(a065);
  a070=(a065-a024);
  a070=(a024*a070);
  a071=(a065+a012);
  a071=(a028*a071);
  a072=(a029-a071);
  a072=(a072+a025);
  a072=(a072+a027);
  a073=(a070/a072);
  a074=(a043*a009);
  a048=(a045*a048);
  a074=(a074+a048);
  a074=(a008+a074);
  a048=(a007*a074);
  a048=(a048*a066);
  a048=(a048/a013);
  a075=(2.*a044);
  a075=(a074-a075);
  a048=(a048*a075);
  a069=(a007*a069);
  a069=(a069/a013);
  a048=(a048+a069);
  a076=cos(a067);
  a077=(a019*a076);
  a067=sin(a067);
  a078=(a022*a067);
  a077=(a077-a078);
  a078=(a077*a026);
  a048=(a048+a078);
  a078=(a073*a048);
  a078=(a061-a078);
  a079=(a070*a073);
  a079=(a030-a079);
  a078=(a078/a079);
  a080=(a042*a078);
  a041=(a041+a080);
  a041=(a008+a041);
  a080=(a007*a041);
  a081=(a040*a008);
  a082=(a042*a074);
  a081=(a081+a082);
  a081=(a010+a081);
  a082=sin(a081);
  a080=(a080*a082);
  a080=(a080/a013);
  a083=(a040*a034);
  a048=(a048/a072);
  a084=(a073*a078);
  a048=(a048-a084);
  a084=(a042*a048);
  a083=(a083+a084);
  a083=(a003+a083);
  a084=(2.*a083);
  a084=(a041-a084);
  a080=(a080*a084);
  a085=(a040*a003);
  a086=(a042*a044);
  a085=(a085+a086);
  a085=(a000+a085);
  a086=(a015-a085);
  a086=(a086+a081);
  a087=sin(a086);
  a088=(a007*a087);
  a088=(a088/a013);
  a080=(a080+a088);
  a089=cos(a085);
  a090=(a019*a089);
  a085=sin(a085);
  a091=(a022*a085);
  a090=(a090-a091);
  a091=(a090*a026);
  a080=(a080+a091);
  a081=cos(a081);
  a091=(a081+a012);
  a091=(a028*a091);
  a092=(a029-a091);
  a092=(a092+a025);
  a092=(a092+a027);
  a093=(a080/a092);
  a094=(a081-a024);
  a094=(a024*a094);
  a095=(a094/a092);
  a096=casadi_sq(a083);
  a096=(a096*a082);
  a096=(a096-a087);
  a096=(a024*a096);
  a080=(a095*a080);
  a080=(a096-a080);
  a087=(a094*a095);
  a087=(a030-a087);
  a080=(a080/a087);
  a097=(a095*a080);
  a093=(a093-a097);
  a097=(a039*a093);
  a038=(a038+a097);
  a097=1.2546768756682242e-01;
  a097=(a097*a002);
  a098=2.4136513415926669e-01;
  a098=(a098*a002);
  a099=(a098*a009);
  a100=-8.8454947932828609e-01;
  a100=(a100*a002);
  a078=(a100*a078);
  a099=(a099+a078);
  a078=9.2483400326179199e-01;
  a078=(a078*a002);
  a101=(a078*a080);
  a099=(a099+a101);
  a099=(a008+a099);
  a101=(a007*a099);
  a102=(a098*a008);
  a103=(a100*a074);
  a102=(a102+a103);
  a103=(a078*a041);
  a102=(a102+a103);
  a102=(a010+a102);
  a103=sin(a102);
  a101=(a101*a103);
  a101=(a101/a013);
  a104=(a098*a034);
  a048=(a100*a048);
  a104=(a104+a048);
  a048=(a078*a093);
  a104=(a104+a048);
  a104=(a003+a104);
  a048=(2.*a104);
  a048=(a099-a048);
  a101=(a101*a048);
  a105=(a098*a003);
  a106=(a100*a044);
  a105=(a105+a106);
  a106=(a078*a083);
  a105=(a105+a106);
  a105=(a000+a105);
  a106=(a015-a105);
  a106=(a106+a102);
  a107=sin(a106);
  a108=(a007*a107);
  a108=(a108/a013);
  a101=(a101+a108);
  a109=cos(a105);
  a110=(a019*a109);
  a105=sin(a105);
  a111=(a022*a105);
  a110=(a110-a111);
  a111=(a110*a026);
  a101=(a101+a111);
  a102=cos(a102);
  a111=(a102+a012);
  a111=(a028*a111);
  a112=(a029-a111);
  a112=(a112+a025);
  a112=(a112+a027);
  a113=(a101/a112);
  a114=(a102-a024);
  a114=(a024*a114);
  a115=(a114/a112);
  a116=casadi_sq(a104);
  a116=(a116*a103);
  a116=(a116-a107);
  a116=(a024*a116);
  a101=(a115*a101);
  a101=(a116-a101);
  a107=(a114*a115);
  a107=(a030-a107);
  a101=(a101/a107);
  a117=(a115*a101);
  a113=(a113-a117);
  a117=(a097*a113);
  a038=(a038+a117);
  a038=(a003+a038);
  a117=(a005*a038);
  a004=(a004+a117);
  a117=1.8915178993145003e+00;
  a117=(a117*a002);
  a118=3.7109375000000000e-02;
  a118=(a118*a002);
  a119=(a118*a034);
  a120=1.7025221101954405e-01;
  a120=(a120*a002);
  a121=(a120*a093);
  a119=(a119+a121);
  a121=6.0216538980455959e-02;
  a121=(a121*a002);
  a122=(a121*a113);
  a119=(a119+a122);
  a122=-1.7578125000000000e-02;
  a122=(a122*a002);
  a123=(a006*a009);
  a124=(a039*a080);
  a123=(a123+a124);
  a124=(a097*a101);
  a123=(a123+a124);
  a123=(a008+a123);
  a124=(a007*a123);
  a125=(a006*a008);
  a126=(a039*a041);
  a125=(a125+a126);
  a126=(a097*a099);
  a125=(a125+a126);
  a125=(a010+a125);
  a126=sin(a125);
  a124=(a124*a126);
  a124=(a124/a013);
  a127=(2.*a038);
  a127=(a123-a127);
  a124=(a124*a127);
  a128=(a006*a003);
  a129=(a039*a083);
  a128=(a128+a129);
  a129=(a097*a104);
  a128=(a128+a129);
  a128=(a000+a128);
  a129=(a015-a128);
  a129=(a129+a125);
  a130=sin(a129);
  a131=(a007*a130);
  a131=(a131/a013);
  a124=(a124+a131);
  a132=cos(a128);
  a133=(a019*a132);
  a128=sin(a128);
  a134=(a022*a128);
  a133=(a133-a134);
  a134=(a133*a026);
  a124=(a124+a134);
  a125=cos(a125);
  a134=(a125+a012);
  a134=(a028*a134);
  a135=(a029-a134);
  a135=(a135+a025);
  a135=(a135+a027);
  a136=(a124/a135);
  a137=(a125-a024);
  a137=(a024*a137);
  a138=(a137/a135);
  a139=casadi_sq(a038);
  a139=(a139*a126);
  a139=(a139-a130);
  a139=(a024*a139);
  a124=(a138*a124);
  a124=(a139-a124);
  a130=(a137*a138);
  a130=(a030-a130);
  a124=(a124/a130);
  a140=(a138*a124);
  a136=(a136-a140);
  a140=(a122*a136);
  a119=(a119+a140);
  a119=(a003+a119);
  a140=(a117*a119);
  a004=(a004+a140);
  a140=-5.8012039600105849e+00;
  a140=(a140*a002);
  a141=3.7092000118504789e-02;
  a141=(a141*a002);
  a142=(a141*a034);
  a143=1.7038392571223998e-01;
  a143=(a143*a002);
  a144=(a143*a093);
  a142=(a142+a144);
  a144=1.0726203044637328e-01;
  a144=(a144*a002);
  a145=(a144*a113);
  a142=(a142+a145);
  a145=-1.5319437748624402e-02;
  a145=(a145*a002);
  a146=(a145*a136);
  a142=(a142+a146);
  a146=8.2737891638140233e-03;
  a146=(a146*a002);
  a147=(a118*a009);
  a148=(a120*a080);
  a147=(a147+a148);
  a148=(a121*a101);
  a147=(a147+a148);
  a148=(a122*a124);
  a147=(a147+a148);
  a147=(a008+a147);
  a148=(a007*a147);
  a149=(a118*a008);
  a150=(a120*a041);
  a149=(a149+a150);
  a150=(a121*a099);
  a149=(a149+a150);
  a150=(a122*a123);
  a149=(a149+a150);
  a149=(a010+a149);
  a150=sin(a149);
  a148=(a148*a150);
  a148=(a148/a013);
  a151=(2.*a119);
  a151=(a147-a151);
  a148=(a148*a151);
  a152=(a118*a003);
  a153=(a120*a083);
  a152=(a152+a153);
  a153=(a121*a104);
  a152=(a152+a153);
  a153=(a122*a038);
  a152=(a152+a153);
  a152=(a000+a152);
  a153=(a015-a152);
  a153=(a153+a149);
  a154=sin(a153);
  a155=(a007*a154);
  a155=(a155/a013);
  a148=(a148+a155);
  a156=cos(a152);
  a157=(a019*a156);
  a152=sin(a152);
  a158=(a022*a152);
  a157=(a157-a158);
  a158=(a157*a026);
  a148=(a148+a158);
  a149=cos(a149);
  a158=(a149+a012);
  a158=(a028*a158);
  a159=(a029-a158);
  a159=(a159+a025);
  a159=(a159+a027);
  a160=(a148/a159);
  a161=(a149-a024);
  a161=(a024*a161);
  a162=(a161/a159);
  a163=casadi_sq(a119);
  a163=(a163*a150);
  a163=(a163-a154);
  a163=(a024*a163);
  a148=(a162*a148);
  a148=(a163-a148);
  a154=(a161*a162);
  a154=(a030-a154);
  a148=(a148/a154);
  a164=(a162*a148);
  a160=(a160-a164);
  a164=(a146*a160);
  a142=(a142+a164);
  a142=(a003+a142);
  a164=(a140*a142);
  a004=(a004+a164);
  a164=3.1116436695781990e-01;
  a164=(a164*a002);
  a165=6.2411095871607569e-01;
  a165=(a165*a002);
  a166=(a165*a034);
  a167=-3.3608926294469414e+00;
  a167=(a167*a002);
  a168=(a167*a093);
  a166=(a166+a168);
  a168=-8.6821934684172597e-01;
  a168=(a168*a002);
  a169=(a168*a113);
  a166=(a166+a169);
  a169=2.7592099699446710e+01;
  a169=(a169*a002);
  a170=(a169*a136);
  a166=(a166+a170);
  a170=2.0154067550477894e+01;
  a170=(a170*a002);
  a171=(a170*a160);
  a166=(a166+a171);
  a171=-4.3489884181069961e+01;
  a171=(a171*a002);
  a172=(a141*a009);
  a173=(a143*a080);
  a172=(a172+a173);
  a173=(a144*a101);
  a172=(a172+a173);
  a173=(a145*a124);
  a172=(a172+a173);
  a173=(a146*a148);
  a172=(a172+a173);
  a172=(a008+a172);
  a173=(a007*a172);
  a174=(a141*a008);
  a175=(a143*a041);
  a174=(a174+a175);
  a175=(a144*a099);
  a174=(a174+a175);
  a175=(a145*a123);
  a174=(a174+a175);
  a175=(a146*a147);
  a174=(a174+a175);
  a174=(a010+a174);
  a175=sin(a174);
  a173=(a173*a175);
  a173=(a173/a013);
  a176=(2.*a142);
  a176=(a172-a176);
  a173=(a173*a176);
  a177=(a141*a003);
  a178=(a143*a083);
  a177=(a177+a178);
  a178=(a144*a104);
  a177=(a177+a178);
  a178=(a145*a038);
  a177=(a177+a178);
  a178=(a146*a119);
  a177=(a177+a178);
  a177=(a000+a177);
  a178=(a015-a177);
  a178=(a178+a174);
  a179=sin(a178);
  a180=(a007*a179);
  a180=(a180/a013);
  a173=(a173+a180);
  a181=cos(a177);
  a182=(a019*a181);
  a177=sin(a177);
  a183=(a022*a177);
  a182=(a182-a183);
  a183=(a182*a026);
  a173=(a173+a183);
  a174=cos(a174);
  a183=(a174+a012);
  a183=(a028*a183);
  a184=(a029-a183);
  a184=(a184+a025);
  a184=(a184+a027);
  a185=(a173/a184);
  a186=(a174-a024);
  a186=(a024*a186);
  a187=(a186/a184);
  a188=casadi_sq(a142);
  a188=(a188*a175);
  a188=(a188-a179);
  a188=(a024*a188);
  a173=(a187*a173);
  a173=(a188-a173);
  a179=(a186*a187);
  a179=(a030-a179);
  a173=(a173/a179);
  a189=(a187*a173);
  a185=(a185-a189);
  a189=(a171*a185);
  a166=(a166+a189);
  a166=(a003+a166);
  a189=(a164*a166);
  a004=(a004+a189);
  a189=-1.5216094966251609e-01;
  a189=(a189*a002);
  a190=4.7766253643826434e-01;
  a190=(a190*a002);
  a191=(a190*a034);
  a192=-2.4881146199716677e+00;
  a192=(a192*a002);
  a193=(a192*a093);
  a191=(a191+a193);
  a193=-5.9029082683684297e-01;
  a193=(a193*a002);
  a194=(a193*a113);
  a191=(a191+a194);
  a194=2.1230051448181193e+01;
  a194=(a194*a002);
  a195=(a194*a136);
  a191=(a191+a195);
  a195=1.5279233632882423e+01;
  a195=(a195*a002);
  a196=(a195*a160);
  a191=(a191+a196);
  a196=-3.3288210968984863e+01;
  a196=(a196*a002);
  a197=(a196*a185);
  a191=(a191+a197);
  a197=-2.0331201708508627e-02;
  a197=(a197*a002);
  a198=(a165*a009);
  a199=(a167*a080);
  a198=(a198+a199);
  a199=(a168*a101);
  a198=(a198+a199);
  a199=(a169*a124);
  a198=(a198+a199);
  a199=(a170*a148);
  a198=(a198+a199);
  a199=(a171*a173);
  a198=(a198+a199);
  a198=(a008+a198);
  a199=(a007*a198);
  a200=(a165*a008);
  a201=(a167*a041);
  a200=(a200+a201);
  a201=(a168*a099);
  a200=(a200+a201);
  a201=(a169*a123);
  a200=(a200+a201);
  a201=(a170*a147);
  a200=(a200+a201);
  a201=(a171*a172);
  a200=(a200+a201);
  a200=(a010+a200);
  a201=sin(a200);
  a199=(a199*a201);
  a199=(a199/a013);
  a202=(2.*a166);
  a202=(a198-a202);
  a199=(a199*a202);
  a203=(a165*a003);
  a204=(a167*a083);
  a203=(a203+a204);
  a204=(a168*a104);
  a203=(a203+a204);
  a204=(a169*a038);
  a203=(a203+a204);
  a204=(a170*a119);
  a203=(a203+a204);
  a204=(a171*a142);
  a203=(a203+a204);
  a203=(a000+a203);
  a204=(a015-a203);
  a204=(a204+a200);
  a205=sin(a204);
  a206=(a007*a205);
  a206=(a206/a013);
  a199=(a199+a206);
  a207=cos(a203);
  a208=(a019*a207);
  a203=sin(a203);
  a209=(a022*a203);
  a208=(a208-a209);
  a209=(a208*a026);
  a199=(a199+a209);
  a200=cos(a200);
  a209=(a200+a012);
  a209=(a028*a209);
  a210=(a029-a209);
  a210=(a210+a025);
  a210=(a210+a027);
  a211=(a199/a210);
  a212=(a200-a024);
  a212=(a024*a212);
  a213=(a212/a210);
  a214=casadi_sq(a166);
  a214=(a214*a201);
  a214=(a214-a205);
  a214=(a024*a214);
  a199=(a213*a199);
  a199=(a214-a199);
  a205=(a212*a213);
  a205=(a030-a205);
  a199=(a199/a205);
  a215=(a213*a199);
  a211=(a211-a215);
  a215=(a197*a211);
  a191=(a191+a215);
  a191=(a003+a191);
  a215=(a189*a191);
  a004=(a004+a215);
  a215=2.0136540080403034e-01;
  a215=(a215*a002);
  a216=-9.3714243008598730e-01;
  a216=(a216*a002);
  a217=(a216*a034);
  a218=5.1863724288440638e+00;
  a218=(a218*a002);
  a219=(a218*a093);
  a217=(a217+a219);
  a219=1.0914373489967295e+00;
  a219=(a219*a002);
  a220=(a219*a113);
  a217=(a217+a220);
  a220=-8.1497870107469268e+00;
  a220=(a220*a002);
  a221=(a220*a136);
  a217=(a217+a221);
  a221=-1.8520065659996959e+01;
  a221=(a221*a002);
  a222=(a221*a160);
  a217=(a217+a222);
  a222=2.2739487099350505e+01;
  a222=(a222*a002);
  a223=(a222*a185);
  a217=(a217+a223);
  a223=2.4936055526796523e+00;
  a223=(a223*a002);
  a224=(a223*a211);
  a217=(a217+a224);
  a224=-3.0467644718982196e+00;
  a224=(a224*a002);
  a225=(a190*a009);
  a226=(a192*a080);
  a225=(a225+a226);
  a226=(a193*a101);
  a225=(a225+a226);
  a226=(a194*a124);
  a225=(a225+a226);
  a226=(a195*a148);
  a225=(a225+a226);
  a226=(a196*a173);
  a225=(a225+a226);
  a226=(a197*a199);
  a225=(a225+a226);
  a225=(a008+a225);
  a226=(a007*a225);
  a227=(a190*a008);
  a228=(a192*a041);
  a227=(a227+a228);
  a228=(a193*a099);
  a227=(a227+a228);
  a228=(a194*a123);
  a227=(a227+a228);
  a228=(a195*a147);
  a227=(a227+a228);
  a228=(a196*a172);
  a227=(a227+a228);
  a228=(a197*a198);
  a227=(a227+a228);
  a227=(a010+a227);
  a228=sin(a227);
  a226=(a226*a228);
  a226=(a226/a013);
  a229=(2.*a191);
  a229=(a225-a229);
  a226=(a226*a229);
  a230=(a190*a003);
  a231=(a192*a083);
  a230=(a230+a231);
  a231=(a193*a104);
  a230=(a230+a231);
  a231=(a194*a038);
  a230=(a230+a231);
  a231=(a195*a119);
  a230=(a230+a231);
  a231=(a196*a142);
  a230=(a230+a231);
  a231=(a197*a166);
  a230=(a230+a231);
  a230=(a000+a230);
  a231=(a015-a230);
  a231=(a231+a227);
  a232=sin(a231);
  a233=(a007*a232);
  a233=(a233/a013);
  a226=(a226+a233);
  a234=cos(a230);
  a235=(a019*a234);
  a230=sin(a230);
  a236=(a022*a230);
  a235=(a235-a236);
  a236=(a235*a026);
  a226=(a226+a236);
  a227=cos(a227);
  a236=(a227+a012);
  a236=(a028*a236);
  a237=(a029-a236);
  a237=(a237+a025);
  a237=(a237+a027);
  a238=(a226/a237);
  a239=(a227-a024);
  a239=(a024*a239);
  a240=(a239/a237);
  a241=casadi_sq(a191);
  a241=(a241*a228);
  a241=(a241-a232);
  a241=(a024*a241);
  a226=(a240*a226);
  a226=(a241-a226);
  a232=(a239*a240);
  a232=(a030-a232);
  a226=(a226/a232);
  a242=(a240*a226);
  a238=(a238-a242);
  a242=(a224*a238);
  a217=(a217+a242);
  a217=(a003+a217);
  a242=(a215*a217);
  a004=(a004+a242);
  a242=4.4710615727772587e-02;
  a242=(a242*a002);
  a243=2.2733101475165380e+00;
  a243=(a243*a002);
  a244=(a243*a034);
  a245=-1.0534495466737249e+01;
  a245=(a245*a002);
  a093=(a245*a093);
  a244=(a244+a093);
  a093=-2.0008720582248625e+00;
  a093=(a093*a002);
  a113=(a093*a113);
  a244=(a244+a113);
  a113=-1.7958931863118799e+01;
  a113=(a113*a002);
  a246=(a113*a136);
  a244=(a244+a246);
  a246=2.7948884529419960e+01;
  a246=(a246*a002);
  a247=(a246*a160);
  a244=(a244+a247);
  a247=-2.8589982771350235e+00;
  a247=(a247*a002);
  a248=(a247*a185);
  a244=(a244+a248);
  a248=-8.8728569335306293e+00;
  a248=(a248*a002);
  a249=(a248*a211);
  a244=(a244+a249);
  a249=1.2360567175794303e+01;
  a249=(a249*a002);
  a250=(a249*a238);
  a244=(a244+a250);
  a250=6.4339274601576357e-01;
  a250=(a250*a002);
  a002=(a216*a009);
  a251=(a218*a080);
  a002=(a002+a251);
  a251=(a219*a101);
  a002=(a002+a251);
  a251=(a220*a124);
  a002=(a002+a251);
  a251=(a221*a148);
  a002=(a002+a251);
  a251=(a222*a173);
  a002=(a002+a251);
  a251=(a223*a199);
  a002=(a002+a251);
  a251=(a224*a226);
  a002=(a002+a251);
  a002=(a008+a002);
  a251=(a007*a002);
  a252=(a216*a008);
  a253=(a218*a041);
  a252=(a252+a253);
  a253=(a219*a099);
  a252=(a252+a253);
  a253=(a220*a123);
  a252=(a252+a253);
  a253=(a221*a147);
  a252=(a252+a253);
  a253=(a222*a172);
  a252=(a252+a253);
  a253=(a223*a198);
  a252=(a252+a253);
  a253=(a224*a225);
  a252=(a252+a253);
  a252=(a010+a252);
  a253=sin(a252);
  a251=(a251*a253);
  a251=(a251/a013);
  a254=(2.*a217);
  a254=(a002-a254);
  a251=(a251*a254);
  a255=(a216*a003);
  a256=(a218*a083);
  a255=(a255+a256);
  a256=(a219*a104);
  a255=(a255+a256);
  a256=(a220*a038);
  a255=(a255+a256);
  a256=(a221*a119);
  a255=(a255+a256);
  a256=(a222*a142);
  a255=(a255+a256);
  a256=(a223*a166);
  a255=(a255+a256);
  a256=(a224*a191);
  a255=(a255+a256);
  a255=(a000+a255);
  a256=(a015-a255);
  a256=(a256+a252);
  a257=sin(a256);
  a258=(a007*a257);
  a258=(a258/a013);
  a251=(a251+a258);
  a259=cos(a255);
  a260=(a019*a259);
  a255=sin(a255);
  a261=(a022*a255);
  a260=(a260-a261);
  a261=(a260*a026);
  a251=(a251+a261);
  a252=cos(a252);
  a261=(a252+a012);
  a261=(a028*a261);
  a262=(a029-a261);
  a262=(a262+a025);
  a262=(a262+a027);
  a263=(a251/a262);
  a264=(a252-a024);
  a264=(a024*a264);
  a265=(a264/a262);
  a266=casadi_sq(a217);
  a266=(a266*a253);
  a266=(a266-a257);
  a266=(a024*a266);
  a251=(a265*a251);
  a251=(a266-a251);
  a257=(a264*a265);
  a257=(a030-a257);
  a251=(a251/a257);
  a267=(a265*a251);
  a263=(a263-a267);
  a267=(a250*a263);
  a244=(a244+a267);
  a244=(a003+a244);
  a267=(a242*a244);
  a004=(a004+a267);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a267=(a005*a123);
  a004=(a004+a267);
  a267=(a117*a147);
  a004=(a004+a267);
  a267=(a140*a172);
  a004=(a004+a267);
  a267=(a164*a198);
  a004=(a004+a267);
  a267=(a189*a225);
  a004=(a004+a267);
  a267=(a215*a002);
  a004=(a004+a267);
  a267=(a243*a009);
  a080=(a245*a080);
  a267=(a267+a080);
  a101=(a093*a101);
  a267=(a267+a101);
  a101=(a113*a124);
  a267=(a267+a101);
  a101=(a246*a148);
  a267=(a267+a101);
  a101=(a247*a173);
  a267=(a267+a101);
  a101=(a248*a199);
  a267=(a267+a101);
  a101=(a249*a226);
  a267=(a267+a101);
  a101=(a250*a251);
  a267=(a267+a101);
  a267=(a008+a267);
  a101=(a242*a267);
  a004=(a004+a101);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a034=(a001*a034);
  a136=(a005*a136);
  a034=(a034+a136);
  a160=(a117*a160);
  a034=(a034+a160);
  a185=(a140*a185);
  a034=(a034+a185);
  a211=(a164*a211);
  a034=(a034+a211);
  a238=(a189*a238);
  a034=(a034+a238);
  a263=(a215*a263);
  a034=(a034+a263);
  a263=(a007*a267);
  a238=(a243*a008);
  a211=(a245*a041);
  a238=(a238+a211);
  a211=(a093*a099);
  a238=(a238+a211);
  a211=(a113*a123);
  a238=(a238+a211);
  a211=(a246*a147);
  a238=(a238+a211);
  a211=(a247*a172);
  a238=(a238+a211);
  a211=(a248*a198);
  a238=(a238+a211);
  a211=(a249*a225);
  a238=(a238+a211);
  a211=(a250*a002);
  a238=(a238+a211);
  a010=(a010+a238);
  a238=sin(a010);
  a263=(a263*a238);
  a263=(a263/a013);
  a211=(2.*a244);
  a211=(a267-a211);
  a263=(a263*a211);
  a185=(a243*a003);
  a160=(a245*a083);
  a185=(a185+a160);
  a160=(a093*a104);
  a185=(a185+a160);
  a160=(a113*a038);
  a185=(a185+a160);
  a160=(a246*a119);
  a185=(a185+a160);
  a160=(a247*a142);
  a185=(a185+a160);
  a160=(a248*a166);
  a185=(a185+a160);
  a160=(a249*a191);
  a185=(a185+a160);
  a160=(a250*a217);
  a185=(a185+a160);
  a000=(a000+a185);
  a015=(a015-a000);
  a015=(a015+a010);
  a185=sin(a015);
  a160=(a007*a185);
  a160=(a160/a013);
  a263=(a263+a160);
  a136=cos(a000);
  a004=(a019*a136);
  a000=sin(a000);
  a101=(a022*a000);
  a004=(a004-a101);
  a026=(a004*a026);
  a263=(a263+a026);
  a010=cos(a010);
  a012=(a010+a012);
  a012=(a028*a012);
  a026=(a029-a012);
  a026=(a026+a025);
  a026=(a026+a027);
  a101=(a263/a026);
  a080=(a010-a024);
  a080=(a024*a080);
  a268=(a080/a026);
  a269=casadi_sq(a244);
  a269=(a269*a238);
  a269=(a269-a185);
  a269=(a024*a269);
  a263=(a268*a263);
  a263=(a269-a263);
  a185=(a080*a268);
  a185=(a030-a185);
  a263=(a263/a185);
  a270=(a268*a263);
  a101=(a101-a270);
  a101=(a242*a101);
  a034=(a034+a101);
  a034=(a003+a034);
  if (res[0]!=0) res[0][2]=a034;
  a009=(a001*a009);
  a124=(a005*a124);
  a009=(a009+a124);
  a148=(a117*a148);
  a009=(a009+a148);
  a173=(a140*a173);
  a009=(a009+a173);
  a199=(a164*a199);
  a009=(a009+a199);
  a226=(a189*a226);
  a009=(a009+a226);
  a251=(a215*a251);
  a009=(a009+a251);
  a263=(a242*a263);
  a009=(a009+a263);
  a009=(a008+a009);
  if (res[0]!=0) res[0][3]=a009;
  a009=arg[0]? arg[0][4] : 0;
  a263=arg[0]? arg[0][6] : 0;
  a251=(a001*a263);
  a020=(a022*a020);
  a023=(a019*a023);
  a020=(a020+a023);
  a023=(a025-a024);
  a023=(a023+a027);
  a020=(a020*a023);
  a016=cos(a016);
  a226=(a007*a016);
  a226=(a226/a013);
  a020=(a020-a226);
  a199=(a020/a033);
  a020=(a036*a020);
  a226=(a226-a020);
  a226=(a226/a017);
  a020=(a036*a226);
  a199=(a199-a020);
  a020=(a199*a009);
  a014=(a008*a014);
  a173=(a031*a014);
  a173=(a016+a173);
  a148=(a007*a011);
  a148=(a148/a013);
  a148=(a148*a014);
  a018=(a018+a148);
  a021=(a021*a023);
  a018=(a018-a021);
  a021=(a036*a018);
  a037=(a037-a021);
  a037=(a037/a017);
  a018=(a018/a033);
  a021=(a036*a037);
  a018=(a018-a021);
  a021=(2.*a018);
  a037=(a037-a021);
  a037=(a011*a037);
  a173=(a173+a037);
  a173=(a024*a173);
  a033=(a173/a033);
  a018=(a018*a011);
  a018=(a018-a016);
  a031=(a031*a003);
  a031=(a031*a003);
  a018=(a018+a031);
  a018=(a024*a018);
  a173=(a036*a173);
  a018=(a018-a173);
  a018=(a018/a017);
  a036=(a036*a018);
  a033=(a033-a036);
  a036=arg[0]? arg[0][5] : 0;
  a017=(a033*a036);
  a020=(a020+a017);
  a017=(a011*a028);
  a173=(a008-a003);
  a017=(a017*a173);
  a029=(a029+a025);
  a032=(a029-a032);
  a032=(a032+a027);
  a025=(a017/a032);
  a173=(a035/a032);
  a017=(a173*a017);
  a035=(a035*a173);
  a035=(a030-a035);
  a017=(a017/a035);
  a031=(a173*a017);
  a025=(a025+a031);
  a031=arg[0]? arg[0][7] : 0;
  a016=(a025*a031);
  a008=(a008*a011);
  a008=(a008*a028);
  a032=(a008/a032);
  a003=(a003*a011);
  a003=(a003*a028);
  a008=(a173*a008);
  a003=(a003+a008);
  a003=(a003/a035);
  a173=(a173*a003);
  a032=(a032+a173);
  a173=(a032*a263);
  a016=(a016-a173);
  a020=(a020+a016);
  a016=(a006*a020);
  a089=(a022*a089);
  a085=(a019*a085);
  a089=(a089+a085);
  a089=(a089*a023);
  a086=cos(a086);
  a085=(a007*a086);
  a085=(a085/a013);
  a089=(a089-a085);
  a173=(a089/a092);
  a089=(a095*a089);
  a085=(a085-a089);
  a085=(a085/a087);
  a089=(a095*a085);
  a173=(a173-a089);
  a089=(a040*a263);
  a035=(a043*a020);
  a057=(a022*a057);
  a053=(a019*a053);
  a057=(a057+a053);
  a057=(a057*a023);
  a054=cos(a054);
  a053=(a007*a054);
  a053=(a053/a013);
  a057=(a057-a053);
  a008=(a057/a060);
  a057=(a063*a057);
  a053=(a053-a057);
  a053=(a053/a055);
  a057=(a063*a053);
  a008=(a008-a057);
  a057=(a046*a263);
  a057=(a009+a057);
  a011=(a008*a057);
  a052=(a047*a052);
  a037=(a049*a052);
  a037=(a054+a037);
  a021=(a007*a050);
  a021=(a021/a013);
  a021=(a021*a052);
  a056=(a056+a021);
  a058=(a058*a023);
  a056=(a056-a058);
  a058=(a063*a056);
  a064=(a064-a058);
  a064=(a064/a055);
  a056=(a056/a060);
  a058=(a063*a064);
  a056=(a056-a058);
  a058=(2.*a056);
  a064=(a064-a058);
  a064=(a050*a064);
  a037=(a037+a064);
  a037=(a024*a037);
  a060=(a037/a060);
  a056=(a056*a050);
  a056=(a056-a054);
  a049=(a049*a051);
  a049=(a049*a051);
  a056=(a056+a049);
  a056=(a024*a056);
  a037=(a063*a037);
  a056=(a056-a037);
  a056=(a056/a055);
  a063=(a063*a056);
  a060=(a060-a063);
  a063=(a046*a031);
  a063=(a036+a063);
  a055=(a060*a063);
  a011=(a011+a055);
  a055=(a050*a028);
  a037=(a047-a051);
  a055=(a055*a037);
  a059=(a029-a059);
  a059=(a059+a027);
  a037=(a055/a059);
  a049=(a062/a059);
  a055=(a049*a055);
  a062=(a062*a049);
  a062=(a030-a062);
  a055=(a055/a062);
  a054=(a049*a055);
  a037=(a037+a054);
  a054=(a226*a009);
  a064=(a018*a036);
  a054=(a054+a064);
  a064=(a003*a263);
  a058=(a017*a031);
  a064=(a064-a058);
  a054=(a054+a064);
  a064=(a046*a054);
  a064=(a031+a064);
  a058=(a037*a064);
  a047=(a047*a050);
  a047=(a047*a028);
  a059=(a047/a059);
  a051=(a051*a050);
  a051=(a051*a028);
  a047=(a049*a047);
  a051=(a051+a047);
  a051=(a051/a062);
  a049=(a049*a051);
  a059=(a059+a049);
  a049=(a046*a020);
  a049=(a263+a049);
  a062=(a059*a049);
  a058=(a058-a062);
  a011=(a011+a058);
  a011=(a045*a011);
  a035=(a035+a011);
  a035=(a263+a035);
  a011=(a042*a035);
  a089=(a089+a011);
  a089=(a009+a089);
  a011=(a173*a089);
  a084=(a041*a084);
  a058=(a081*a084);
  a058=(a086+a058);
  a062=(a007*a082);
  a062=(a062/a013);
  a062=(a062*a084);
  a088=(a088+a062);
  a090=(a090*a023);
  a088=(a088-a090);
  a090=(a095*a088);
  a096=(a096-a090);
  a096=(a096/a087);
  a088=(a088/a092);
  a090=(a095*a096);
  a088=(a088-a090);
  a090=(2.*a088);
  a096=(a096-a090);
  a096=(a082*a096);
  a058=(a058+a096);
  a058=(a024*a058);
  a092=(a058/a092);
  a088=(a088*a082);
  a088=(a088-a086);
  a081=(a081*a083);
  a081=(a081*a083);
  a088=(a088+a081);
  a088=(a024*a088);
  a058=(a095*a058);
  a088=(a088-a058);
  a088=(a088/a087);
  a095=(a095*a088);
  a092=(a092-a095);
  a095=(a040*a031);
  a087=(a043*a054);
  a057=(a053*a057);
  a063=(a056*a063);
  a057=(a057+a063);
  a063=(a051*a049);
  a058=(a055*a064);
  a063=(a063-a058);
  a057=(a057+a063);
  a057=(a045*a057);
  a087=(a087+a057);
  a087=(a031+a087);
  a057=(a042*a087);
  a095=(a095+a057);
  a095=(a036+a095);
  a057=(a092*a095);
  a011=(a011+a057);
  a057=(a082*a028);
  a063=(a041-a083);
  a057=(a057*a063);
  a091=(a029-a091);
  a091=(a091+a027);
  a063=(a057/a091);
  a058=(a094/a091);
  a057=(a058*a057);
  a094=(a094*a058);
  a094=(a030-a094);
  a057=(a057/a094);
  a081=(a058*a057);
  a063=(a063+a081);
  a081=(a040*a054);
  a068=cos(a068);
  a086=(a007*a068);
  a086=(a086/a013);
  a076=(a022*a076);
  a067=(a019*a067);
  a076=(a076+a067);
  a076=(a076*a023);
  a076=(a076-a086);
  a067=(a073*a076);
  a086=(a086-a067);
  a086=(a086/a079);
  a067=(a043*a263);
  a049=(a045*a049);
  a067=(a067+a049);
  a067=(a009+a067);
  a049=(a086*a067);
  a096=(a007*a066);
  a096=(a096/a013);
  a075=(a074*a075);
  a096=(a096*a075);
  a069=(a069+a096);
  a077=(a077*a023);
  a069=(a069-a077);
  a077=(a069/a072);
  a069=(a073*a069);
  a061=(a061-a069);
  a061=(a061/a079);
  a069=(a073*a061);
  a077=(a077-a069);
  a069=(a077*a066);
  a069=(a069-a068);
  a096=(a065*a044);
  a096=(a096*a044);
  a069=(a069+a096);
  a069=(a024*a069);
  a065=(a065*a075);
  a068=(a068+a065);
  a077=(2.*a077);
  a061=(a061-a077);
  a061=(a066*a061);
  a068=(a068+a061);
  a068=(a024*a068);
  a061=(a073*a068);
  a069=(a069-a061);
  a069=(a069/a079);
  a079=(a043*a031);
  a064=(a045*a064);
  a079=(a079+a064);
  a079=(a036+a079);
  a064=(a069*a079);
  a049=(a049+a064);
  a064=(a044*a066);
  a064=(a064*a028);
  a071=(a029-a071);
  a071=(a071+a027);
  a061=(a070/a071);
  a077=(a074*a066);
  a077=(a077*a028);
  a065=(a061*a077);
  a064=(a064+a065);
  a070=(a070*a061);
  a070=(a030-a070);
  a064=(a064/a070);
  a065=(a064*a035);
  a066=(a066*a028);
  a074=(a074-a044);
  a066=(a066*a074);
  a074=(a061*a066);
  a074=(a074/a070);
  a070=(a074*a087);
  a065=(a065-a070);
  a049=(a049+a065);
  a065=(a042*a049);
  a081=(a081+a065);
  a081=(a031+a081);
  a065=(a063*a081);
  a041=(a041*a082);
  a041=(a041*a028);
  a091=(a041/a091);
  a083=(a083*a082);
  a083=(a083*a028);
  a041=(a058*a041);
  a083=(a083+a041);
  a083=(a083/a094);
  a058=(a058*a083);
  a091=(a091+a058);
  a058=(a040*a020);
  a076=(a076/a072);
  a094=(a073*a086);
  a076=(a076-a094);
  a067=(a076*a067);
  a068=(a068/a072);
  a073=(a073*a069);
  a068=(a068-a073);
  a079=(a068*a079);
  a067=(a067+a079);
  a066=(a066/a071);
  a079=(a061*a074);
  a066=(a066+a079);
  a079=(a066*a087);
  a077=(a077/a071);
  a061=(a061*a064);
  a077=(a077+a061);
  a061=(a077*a035);
  a079=(a079-a061);
  a067=(a067+a079);
  a079=(a042*a067);
  a058=(a058+a079);
  a058=(a263+a058);
  a079=(a091*a058);
  a065=(a065-a079);
  a011=(a011+a065);
  a065=(a039*a011);
  a016=(a016+a065);
  a109=(a022*a109);
  a105=(a019*a105);
  a109=(a109+a105);
  a109=(a109*a023);
  a106=cos(a106);
  a105=(a007*a106);
  a105=(a105/a013);
  a109=(a109-a105);
  a065=(a109/a112);
  a109=(a115*a109);
  a105=(a105-a109);
  a105=(a105/a107);
  a109=(a115*a105);
  a065=(a065-a109);
  a109=(a098*a263);
  a035=(a100*a035);
  a109=(a109+a035);
  a035=(a078*a058);
  a109=(a109+a035);
  a109=(a009+a109);
  a035=(a065*a109);
  a048=(a099*a048);
  a079=(a102*a048);
  a079=(a106+a079);
  a061=(a007*a103);
  a061=(a061/a013);
  a061=(a061*a048);
  a108=(a108+a061);
  a110=(a110*a023);
  a108=(a108-a110);
  a110=(a115*a108);
  a116=(a116-a110);
  a116=(a116/a107);
  a108=(a108/a112);
  a110=(a115*a116);
  a108=(a108-a110);
  a110=(2.*a108);
  a116=(a116-a110);
  a116=(a103*a116);
  a079=(a079+a116);
  a079=(a024*a079);
  a112=(a079/a112);
  a108=(a108*a103);
  a108=(a108-a106);
  a102=(a102*a104);
  a102=(a102*a104);
  a108=(a108+a102);
  a108=(a024*a108);
  a079=(a115*a079);
  a108=(a108-a079);
  a108=(a108/a107);
  a115=(a115*a108);
  a112=(a112-a115);
  a115=(a098*a031);
  a087=(a100*a087);
  a115=(a115+a087);
  a087=(a078*a081);
  a115=(a115+a087);
  a115=(a036+a115);
  a087=(a112*a115);
  a035=(a035+a087);
  a087=(a103*a028);
  a107=(a099-a104);
  a087=(a087*a107);
  a111=(a029-a111);
  a111=(a111+a027);
  a107=(a087/a111);
  a079=(a114/a111);
  a087=(a079*a087);
  a114=(a114*a079);
  a114=(a030-a114);
  a087=(a087/a114);
  a102=(a079*a087);
  a107=(a107+a102);
  a102=(a098*a054);
  a049=(a100*a049);
  a102=(a102+a049);
  a089=(a085*a089);
  a095=(a088*a095);
  a089=(a089+a095);
  a095=(a083*a058);
  a049=(a057*a081);
  a095=(a095-a049);
  a089=(a089+a095);
  a095=(a078*a089);
  a102=(a102+a095);
  a102=(a031+a102);
  a095=(a107*a102);
  a099=(a099*a103);
  a099=(a099*a028);
  a111=(a099/a111);
  a104=(a104*a103);
  a104=(a104*a028);
  a099=(a079*a099);
  a104=(a104+a099);
  a104=(a104/a114);
  a079=(a079*a104);
  a111=(a111+a079);
  a079=(a098*a020);
  a067=(a100*a067);
  a079=(a079+a067);
  a067=(a078*a011);
  a079=(a079+a067);
  a079=(a263+a079);
  a067=(a111*a079);
  a095=(a095-a067);
  a035=(a035+a095);
  a095=(a097*a035);
  a016=(a016+a095);
  a016=(a263+a016);
  a095=(a005*a016);
  a251=(a251+a095);
  a095=(a118*a020);
  a067=(a120*a011);
  a095=(a095+a067);
  a067=(a121*a035);
  a095=(a095+a067);
  a132=(a022*a132);
  a128=(a019*a128);
  a132=(a132+a128);
  a132=(a132*a023);
  a129=cos(a129);
  a128=(a007*a129);
  a128=(a128/a013);
  a132=(a132-a128);
  a067=(a132/a135);
  a132=(a138*a132);
  a128=(a128-a132);
  a128=(a128/a130);
  a132=(a138*a128);
  a067=(a067-a132);
  a132=(a006*a263);
  a114=(a039*a058);
  a132=(a132+a114);
  a114=(a097*a079);
  a132=(a132+a114);
  a132=(a009+a132);
  a114=(a067*a132);
  a127=(a123*a127);
  a099=(a125*a127);
  a099=(a129+a099);
  a103=(a007*a126);
  a103=(a103/a013);
  a103=(a103*a127);
  a131=(a131+a103);
  a133=(a133*a023);
  a131=(a131-a133);
  a133=(a138*a131);
  a139=(a139-a133);
  a139=(a139/a130);
  a131=(a131/a135);
  a133=(a138*a139);
  a131=(a131-a133);
  a133=(2.*a131);
  a139=(a139-a133);
  a139=(a126*a139);
  a099=(a099+a139);
  a099=(a024*a099);
  a135=(a099/a135);
  a131=(a131*a126);
  a131=(a131-a129);
  a125=(a125*a038);
  a125=(a125*a038);
  a131=(a131+a125);
  a131=(a024*a131);
  a099=(a138*a099);
  a131=(a131-a099);
  a131=(a131/a130);
  a138=(a138*a131);
  a135=(a135-a138);
  a138=(a006*a031);
  a130=(a039*a081);
  a138=(a138+a130);
  a130=(a097*a102);
  a138=(a138+a130);
  a138=(a036+a138);
  a130=(a135*a138);
  a114=(a114+a130);
  a130=(a126*a028);
  a099=(a123-a038);
  a130=(a130*a099);
  a134=(a029-a134);
  a134=(a134+a027);
  a099=(a130/a134);
  a125=(a137/a134);
  a130=(a125*a130);
  a137=(a137*a125);
  a137=(a030-a137);
  a130=(a130/a137);
  a129=(a125*a130);
  a099=(a099+a129);
  a129=(a006*a054);
  a139=(a039*a089);
  a129=(a129+a139);
  a109=(a105*a109);
  a115=(a108*a115);
  a109=(a109+a115);
  a115=(a104*a079);
  a139=(a087*a102);
  a115=(a115-a139);
  a109=(a109+a115);
  a115=(a097*a109);
  a129=(a129+a115);
  a129=(a031+a129);
  a115=(a099*a129);
  a123=(a123*a126);
  a123=(a123*a028);
  a134=(a123/a134);
  a038=(a038*a126);
  a038=(a038*a028);
  a123=(a125*a123);
  a038=(a038+a123);
  a038=(a038/a137);
  a125=(a125*a038);
  a134=(a134+a125);
  a125=(a134*a016);
  a115=(a115-a125);
  a114=(a114+a115);
  a115=(a122*a114);
  a095=(a095+a115);
  a095=(a263+a095);
  a115=(a117*a095);
  a251=(a251+a115);
  a115=(a141*a020);
  a125=(a143*a011);
  a115=(a115+a125);
  a125=(a144*a035);
  a115=(a115+a125);
  a125=(a145*a114);
  a115=(a115+a125);
  a156=(a022*a156);
  a152=(a019*a152);
  a156=(a156+a152);
  a156=(a156*a023);
  a153=cos(a153);
  a152=(a007*a153);
  a152=(a152/a013);
  a156=(a156-a152);
  a125=(a156/a159);
  a156=(a162*a156);
  a152=(a152-a156);
  a152=(a152/a154);
  a156=(a162*a152);
  a125=(a125-a156);
  a156=(a118*a263);
  a137=(a120*a058);
  a156=(a156+a137);
  a137=(a121*a079);
  a156=(a156+a137);
  a137=(a122*a016);
  a156=(a156+a137);
  a156=(a009+a156);
  a137=(a125*a156);
  a151=(a147*a151);
  a123=(a149*a151);
  a123=(a153+a123);
  a126=(a007*a150);
  a126=(a126/a013);
  a126=(a126*a151);
  a155=(a155+a126);
  a157=(a157*a023);
  a155=(a155-a157);
  a157=(a162*a155);
  a163=(a163-a157);
  a163=(a163/a154);
  a155=(a155/a159);
  a157=(a162*a163);
  a155=(a155-a157);
  a157=(2.*a155);
  a163=(a163-a157);
  a163=(a150*a163);
  a123=(a123+a163);
  a123=(a024*a123);
  a159=(a123/a159);
  a155=(a155*a150);
  a155=(a155-a153);
  a149=(a149*a119);
  a149=(a149*a119);
  a155=(a155+a149);
  a155=(a024*a155);
  a123=(a162*a123);
  a155=(a155-a123);
  a155=(a155/a154);
  a162=(a162*a155);
  a159=(a159-a162);
  a162=(a118*a031);
  a154=(a120*a081);
  a162=(a162+a154);
  a154=(a121*a102);
  a162=(a162+a154);
  a154=(a122*a129);
  a162=(a162+a154);
  a162=(a036+a162);
  a154=(a159*a162);
  a137=(a137+a154);
  a154=(a150*a028);
  a123=(a147-a119);
  a154=(a154*a123);
  a158=(a029-a158);
  a158=(a158+a027);
  a123=(a154/a158);
  a149=(a161/a158);
  a154=(a149*a154);
  a161=(a161*a149);
  a161=(a030-a161);
  a154=(a154/a161);
  a153=(a149*a154);
  a123=(a123+a153);
  a153=(a118*a054);
  a163=(a120*a089);
  a153=(a153+a163);
  a163=(a121*a109);
  a153=(a153+a163);
  a132=(a128*a132);
  a138=(a131*a138);
  a132=(a132+a138);
  a138=(a038*a016);
  a163=(a130*a129);
  a138=(a138-a163);
  a132=(a132+a138);
  a138=(a122*a132);
  a153=(a153+a138);
  a153=(a031+a153);
  a138=(a123*a153);
  a147=(a147*a150);
  a147=(a147*a028);
  a158=(a147/a158);
  a119=(a119*a150);
  a119=(a119*a028);
  a147=(a149*a147);
  a119=(a119+a147);
  a119=(a119/a161);
  a149=(a149*a119);
  a158=(a158+a149);
  a149=(a158*a095);
  a138=(a138-a149);
  a137=(a137+a138);
  a138=(a146*a137);
  a115=(a115+a138);
  a115=(a263+a115);
  a138=(a140*a115);
  a251=(a251+a138);
  a138=(a165*a020);
  a149=(a167*a011);
  a138=(a138+a149);
  a149=(a168*a035);
  a138=(a138+a149);
  a149=(a169*a114);
  a138=(a138+a149);
  a149=(a170*a137);
  a138=(a138+a149);
  a181=(a022*a181);
  a177=(a019*a177);
  a181=(a181+a177);
  a181=(a181*a023);
  a178=cos(a178);
  a177=(a007*a178);
  a177=(a177/a013);
  a181=(a181-a177);
  a149=(a181/a184);
  a181=(a187*a181);
  a177=(a177-a181);
  a177=(a177/a179);
  a181=(a187*a177);
  a149=(a149-a181);
  a181=(a141*a263);
  a161=(a143*a058);
  a181=(a181+a161);
  a161=(a144*a079);
  a181=(a181+a161);
  a161=(a145*a016);
  a181=(a181+a161);
  a161=(a146*a095);
  a181=(a181+a161);
  a181=(a009+a181);
  a161=(a149*a181);
  a176=(a172*a176);
  a147=(a174*a176);
  a147=(a178+a147);
  a150=(a007*a175);
  a150=(a150/a013);
  a150=(a150*a176);
  a180=(a180+a150);
  a182=(a182*a023);
  a180=(a180-a182);
  a182=(a187*a180);
  a188=(a188-a182);
  a188=(a188/a179);
  a180=(a180/a184);
  a182=(a187*a188);
  a180=(a180-a182);
  a182=(2.*a180);
  a188=(a188-a182);
  a188=(a175*a188);
  a147=(a147+a188);
  a147=(a024*a147);
  a184=(a147/a184);
  a180=(a180*a175);
  a180=(a180-a178);
  a174=(a174*a142);
  a174=(a174*a142);
  a180=(a180+a174);
  a180=(a024*a180);
  a147=(a187*a147);
  a180=(a180-a147);
  a180=(a180/a179);
  a187=(a187*a180);
  a184=(a184-a187);
  a187=(a141*a031);
  a179=(a143*a081);
  a187=(a187+a179);
  a179=(a144*a102);
  a187=(a187+a179);
  a179=(a145*a129);
  a187=(a187+a179);
  a179=(a146*a153);
  a187=(a187+a179);
  a187=(a036+a187);
  a179=(a184*a187);
  a161=(a161+a179);
  a179=(a175*a028);
  a147=(a172-a142);
  a179=(a179*a147);
  a183=(a029-a183);
  a183=(a183+a027);
  a147=(a179/a183);
  a174=(a186/a183);
  a179=(a174*a179);
  a186=(a186*a174);
  a186=(a030-a186);
  a179=(a179/a186);
  a178=(a174*a179);
  a147=(a147+a178);
  a178=(a141*a054);
  a188=(a143*a089);
  a178=(a178+a188);
  a188=(a144*a109);
  a178=(a178+a188);
  a188=(a145*a132);
  a178=(a178+a188);
  a156=(a152*a156);
  a162=(a155*a162);
  a156=(a156+a162);
  a162=(a119*a095);
  a188=(a154*a153);
  a162=(a162-a188);
  a156=(a156+a162);
  a162=(a146*a156);
  a178=(a178+a162);
  a178=(a031+a178);
  a162=(a147*a178);
  a172=(a172*a175);
  a172=(a172*a028);
  a183=(a172/a183);
  a142=(a142*a175);
  a142=(a142*a028);
  a172=(a174*a172);
  a142=(a142+a172);
  a142=(a142/a186);
  a174=(a174*a142);
  a183=(a183+a174);
  a174=(a183*a115);
  a162=(a162-a174);
  a161=(a161+a162);
  a162=(a171*a161);
  a138=(a138+a162);
  a138=(a263+a138);
  a162=(a164*a138);
  a251=(a251+a162);
  a162=(a190*a020);
  a174=(a192*a011);
  a162=(a162+a174);
  a174=(a193*a035);
  a162=(a162+a174);
  a174=(a194*a114);
  a162=(a162+a174);
  a174=(a195*a137);
  a162=(a162+a174);
  a174=(a196*a161);
  a162=(a162+a174);
  a207=(a022*a207);
  a203=(a019*a203);
  a207=(a207+a203);
  a207=(a207*a023);
  a204=cos(a204);
  a203=(a007*a204);
  a203=(a203/a013);
  a207=(a207-a203);
  a174=(a207/a210);
  a207=(a213*a207);
  a203=(a203-a207);
  a203=(a203/a205);
  a207=(a213*a203);
  a174=(a174-a207);
  a207=(a165*a263);
  a186=(a167*a058);
  a207=(a207+a186);
  a186=(a168*a079);
  a207=(a207+a186);
  a186=(a169*a016);
  a207=(a207+a186);
  a186=(a170*a095);
  a207=(a207+a186);
  a186=(a171*a115);
  a207=(a207+a186);
  a207=(a009+a207);
  a186=(a174*a207);
  a202=(a198*a202);
  a172=(a200*a202);
  a172=(a204+a172);
  a175=(a007*a201);
  a175=(a175/a013);
  a175=(a175*a202);
  a206=(a206+a175);
  a208=(a208*a023);
  a206=(a206-a208);
  a208=(a213*a206);
  a214=(a214-a208);
  a214=(a214/a205);
  a206=(a206/a210);
  a208=(a213*a214);
  a206=(a206-a208);
  a208=(2.*a206);
  a214=(a214-a208);
  a214=(a201*a214);
  a172=(a172+a214);
  a172=(a024*a172);
  a210=(a172/a210);
  a206=(a206*a201);
  a206=(a206-a204);
  a200=(a200*a166);
  a200=(a200*a166);
  a206=(a206+a200);
  a206=(a024*a206);
  a172=(a213*a172);
  a206=(a206-a172);
  a206=(a206/a205);
  a213=(a213*a206);
  a210=(a210-a213);
  a213=(a165*a031);
  a205=(a167*a081);
  a213=(a213+a205);
  a205=(a168*a102);
  a213=(a213+a205);
  a205=(a169*a129);
  a213=(a213+a205);
  a205=(a170*a153);
  a213=(a213+a205);
  a205=(a171*a178);
  a213=(a213+a205);
  a213=(a036+a213);
  a205=(a210*a213);
  a186=(a186+a205);
  a205=(a201*a028);
  a172=(a198-a166);
  a205=(a205*a172);
  a209=(a029-a209);
  a209=(a209+a027);
  a172=(a205/a209);
  a200=(a212/a209);
  a205=(a200*a205);
  a212=(a212*a200);
  a212=(a030-a212);
  a205=(a205/a212);
  a204=(a200*a205);
  a172=(a172+a204);
  a204=(a165*a054);
  a214=(a167*a089);
  a204=(a204+a214);
  a214=(a168*a109);
  a204=(a204+a214);
  a214=(a169*a132);
  a204=(a204+a214);
  a214=(a170*a156);
  a204=(a204+a214);
  a181=(a177*a181);
  a187=(a180*a187);
  a181=(a181+a187);
  a187=(a142*a115);
  a214=(a179*a178);
  a187=(a187-a214);
  a181=(a181+a187);
  a187=(a171*a181);
  a204=(a204+a187);
  a204=(a031+a204);
  a187=(a172*a204);
  a198=(a198*a201);
  a198=(a198*a028);
  a209=(a198/a209);
  a166=(a166*a201);
  a166=(a166*a028);
  a198=(a200*a198);
  a166=(a166+a198);
  a166=(a166/a212);
  a200=(a200*a166);
  a209=(a209+a200);
  a200=(a209*a138);
  a187=(a187-a200);
  a186=(a186+a187);
  a187=(a197*a186);
  a162=(a162+a187);
  a162=(a263+a162);
  a187=(a189*a162);
  a251=(a251+a187);
  a187=(a216*a020);
  a200=(a218*a011);
  a187=(a187+a200);
  a200=(a219*a035);
  a187=(a187+a200);
  a200=(a220*a114);
  a187=(a187+a200);
  a200=(a221*a137);
  a187=(a187+a200);
  a200=(a222*a161);
  a187=(a187+a200);
  a200=(a223*a186);
  a187=(a187+a200);
  a234=(a022*a234);
  a230=(a019*a230);
  a234=(a234+a230);
  a234=(a234*a023);
  a231=cos(a231);
  a230=(a007*a231);
  a230=(a230/a013);
  a234=(a234-a230);
  a200=(a234/a237);
  a234=(a240*a234);
  a230=(a230-a234);
  a230=(a230/a232);
  a234=(a240*a230);
  a200=(a200-a234);
  a234=(a190*a263);
  a212=(a192*a058);
  a234=(a234+a212);
  a212=(a193*a079);
  a234=(a234+a212);
  a212=(a194*a016);
  a234=(a234+a212);
  a212=(a195*a095);
  a234=(a234+a212);
  a212=(a196*a115);
  a234=(a234+a212);
  a212=(a197*a138);
  a234=(a234+a212);
  a234=(a009+a234);
  a212=(a200*a234);
  a229=(a225*a229);
  a198=(a227*a229);
  a198=(a231+a198);
  a201=(a007*a228);
  a201=(a201/a013);
  a201=(a201*a229);
  a233=(a233+a201);
  a235=(a235*a023);
  a233=(a233-a235);
  a235=(a240*a233);
  a241=(a241-a235);
  a241=(a241/a232);
  a233=(a233/a237);
  a235=(a240*a241);
  a233=(a233-a235);
  a235=(2.*a233);
  a241=(a241-a235);
  a241=(a228*a241);
  a198=(a198+a241);
  a198=(a024*a198);
  a237=(a198/a237);
  a233=(a233*a228);
  a233=(a233-a231);
  a227=(a227*a191);
  a227=(a227*a191);
  a233=(a233+a227);
  a233=(a024*a233);
  a198=(a240*a198);
  a233=(a233-a198);
  a233=(a233/a232);
  a240=(a240*a233);
  a237=(a237-a240);
  a240=(a190*a031);
  a232=(a192*a081);
  a240=(a240+a232);
  a232=(a193*a102);
  a240=(a240+a232);
  a232=(a194*a129);
  a240=(a240+a232);
  a232=(a195*a153);
  a240=(a240+a232);
  a232=(a196*a178);
  a240=(a240+a232);
  a232=(a197*a204);
  a240=(a240+a232);
  a240=(a036+a240);
  a232=(a237*a240);
  a212=(a212+a232);
  a232=(a228*a028);
  a198=(a225-a191);
  a232=(a232*a198);
  a236=(a029-a236);
  a236=(a236+a027);
  a198=(a232/a236);
  a227=(a239/a236);
  a232=(a227*a232);
  a239=(a239*a227);
  a239=(a030-a239);
  a232=(a232/a239);
  a231=(a227*a232);
  a198=(a198+a231);
  a231=(a190*a054);
  a241=(a192*a089);
  a231=(a231+a241);
  a241=(a193*a109);
  a231=(a231+a241);
  a241=(a194*a132);
  a231=(a231+a241);
  a241=(a195*a156);
  a231=(a231+a241);
  a241=(a196*a181);
  a231=(a231+a241);
  a207=(a203*a207);
  a213=(a206*a213);
  a207=(a207+a213);
  a213=(a166*a138);
  a241=(a205*a204);
  a213=(a213-a241);
  a207=(a207+a213);
  a213=(a197*a207);
  a231=(a231+a213);
  a231=(a031+a231);
  a213=(a198*a231);
  a225=(a225*a228);
  a225=(a225*a028);
  a236=(a225/a236);
  a191=(a191*a228);
  a191=(a191*a028);
  a225=(a227*a225);
  a191=(a191+a225);
  a191=(a191/a239);
  a227=(a227*a191);
  a236=(a236+a227);
  a227=(a236*a162);
  a213=(a213-a227);
  a212=(a212+a213);
  a213=(a224*a212);
  a187=(a187+a213);
  a187=(a263+a187);
  a213=(a215*a187);
  a251=(a251+a213);
  a213=(a243*a020);
  a011=(a245*a011);
  a213=(a213+a011);
  a035=(a093*a035);
  a213=(a213+a035);
  a035=(a113*a114);
  a213=(a213+a035);
  a035=(a246*a137);
  a213=(a213+a035);
  a035=(a247*a161);
  a213=(a213+a035);
  a035=(a248*a186);
  a213=(a213+a035);
  a035=(a249*a212);
  a213=(a213+a035);
  a259=(a022*a259);
  a255=(a019*a255);
  a259=(a259+a255);
  a259=(a259*a023);
  a256=cos(a256);
  a255=(a007*a256);
  a255=(a255/a013);
  a259=(a259-a255);
  a035=(a259/a262);
  a259=(a265*a259);
  a255=(a255-a259);
  a255=(a255/a257);
  a259=(a265*a255);
  a035=(a035-a259);
  a259=(a216*a263);
  a011=(a218*a058);
  a259=(a259+a011);
  a011=(a219*a079);
  a259=(a259+a011);
  a011=(a220*a016);
  a259=(a259+a011);
  a011=(a221*a095);
  a259=(a259+a011);
  a011=(a222*a115);
  a259=(a259+a011);
  a011=(a223*a138);
  a259=(a259+a011);
  a011=(a224*a162);
  a259=(a259+a011);
  a259=(a009+a259);
  a011=(a035*a259);
  a254=(a002*a254);
  a227=(a252*a254);
  a227=(a256+a227);
  a239=(a007*a253);
  a239=(a239/a013);
  a239=(a239*a254);
  a258=(a258+a239);
  a260=(a260*a023);
  a258=(a258-a260);
  a260=(a265*a258);
  a266=(a266-a260);
  a266=(a266/a257);
  a258=(a258/a262);
  a260=(a265*a266);
  a258=(a258-a260);
  a260=(2.*a258);
  a266=(a266-a260);
  a266=(a253*a266);
  a227=(a227+a266);
  a227=(a024*a227);
  a262=(a227/a262);
  a258=(a258*a253);
  a258=(a258-a256);
  a252=(a252*a217);
  a252=(a252*a217);
  a258=(a258+a252);
  a258=(a024*a258);
  a227=(a265*a227);
  a258=(a258-a227);
  a258=(a258/a257);
  a265=(a265*a258);
  a262=(a262-a265);
  a265=(a216*a031);
  a257=(a218*a081);
  a265=(a265+a257);
  a257=(a219*a102);
  a265=(a265+a257);
  a257=(a220*a129);
  a265=(a265+a257);
  a257=(a221*a153);
  a265=(a265+a257);
  a257=(a222*a178);
  a265=(a265+a257);
  a257=(a223*a204);
  a265=(a265+a257);
  a257=(a224*a231);
  a265=(a265+a257);
  a265=(a036+a265);
  a257=(a262*a265);
  a011=(a011+a257);
  a257=(a253*a028);
  a227=(a002-a217);
  a257=(a257*a227);
  a261=(a029-a261);
  a261=(a261+a027);
  a227=(a257/a261);
  a252=(a264/a261);
  a257=(a252*a257);
  a264=(a264*a252);
  a264=(a030-a264);
  a257=(a257/a264);
  a256=(a252*a257);
  a227=(a227+a256);
  a256=(a216*a054);
  a266=(a218*a089);
  a256=(a256+a266);
  a266=(a219*a109);
  a256=(a256+a266);
  a266=(a220*a132);
  a256=(a256+a266);
  a266=(a221*a156);
  a256=(a256+a266);
  a266=(a222*a181);
  a256=(a256+a266);
  a266=(a223*a207);
  a256=(a256+a266);
  a234=(a230*a234);
  a240=(a233*a240);
  a234=(a234+a240);
  a240=(a191*a162);
  a266=(a232*a231);
  a240=(a240-a266);
  a234=(a234+a240);
  a240=(a224*a234);
  a256=(a256+a240);
  a256=(a031+a256);
  a240=(a227*a256);
  a002=(a002*a253);
  a002=(a002*a028);
  a261=(a002/a261);
  a217=(a217*a253);
  a217=(a217*a028);
  a002=(a252*a002);
  a217=(a217+a002);
  a217=(a217/a264);
  a252=(a252*a217);
  a261=(a261+a252);
  a252=(a261*a187);
  a240=(a240-a252);
  a011=(a011+a240);
  a240=(a250*a011);
  a213=(a213+a240);
  a213=(a263+a213);
  a240=(a242*a213);
  a251=(a251+a240);
  a251=(a009+a251);
  if (res[0]!=0) res[0][4]=a251;
  a251=(a001*a031);
  a240=(a005*a129);
  a251=(a251+a240);
  a240=(a117*a153);
  a251=(a251+a240);
  a240=(a140*a178);
  a251=(a251+a240);
  a240=(a164*a204);
  a251=(a251+a240);
  a240=(a189*a231);
  a251=(a251+a240);
  a240=(a215*a256);
  a251=(a251+a240);
  a240=(a243*a054);
  a089=(a245*a089);
  a240=(a240+a089);
  a109=(a093*a109);
  a240=(a240+a109);
  a109=(a113*a132);
  a240=(a240+a109);
  a109=(a246*a156);
  a240=(a240+a109);
  a109=(a247*a181);
  a240=(a240+a109);
  a109=(a248*a207);
  a240=(a240+a109);
  a109=(a249*a234);
  a240=(a240+a109);
  a259=(a255*a259);
  a265=(a258*a265);
  a259=(a259+a265);
  a265=(a217*a187);
  a109=(a257*a256);
  a265=(a265-a109);
  a259=(a259+a265);
  a265=(a250*a259);
  a240=(a240+a265);
  a240=(a031+a240);
  a265=(a242*a240);
  a251=(a251+a265);
  a251=(a036+a251);
  if (res[0]!=0) res[0][5]=a251;
  a020=(a001*a020);
  a114=(a005*a114);
  a020=(a020+a114);
  a137=(a117*a137);
  a020=(a020+a137);
  a161=(a140*a161);
  a020=(a020+a161);
  a186=(a164*a186);
  a020=(a020+a186);
  a212=(a189*a212);
  a020=(a020+a212);
  a011=(a215*a011);
  a020=(a020+a011);
  a022=(a022*a136);
  a019=(a019*a000);
  a022=(a022+a019);
  a022=(a022*a023);
  a015=cos(a015);
  a019=(a007*a015);
  a019=(a019/a013);
  a022=(a022-a019);
  a000=(a022/a026);
  a022=(a268*a022);
  a019=(a019-a022);
  a019=(a019/a185);
  a022=(a268*a019);
  a000=(a000-a022);
  a022=(a243*a263);
  a058=(a245*a058);
  a022=(a022+a058);
  a079=(a093*a079);
  a022=(a022+a079);
  a016=(a113*a016);
  a022=(a022+a016);
  a095=(a246*a095);
  a022=(a022+a095);
  a115=(a247*a115);
  a022=(a022+a115);
  a138=(a248*a138);
  a022=(a022+a138);
  a162=(a249*a162);
  a022=(a022+a162);
  a187=(a250*a187);
  a022=(a022+a187);
  a009=(a009+a022);
  a022=(a000*a009);
  a211=(a267*a211);
  a187=(a010*a211);
  a187=(a015+a187);
  a007=(a007*a238);
  a007=(a007/a013);
  a007=(a007*a211);
  a160=(a160+a007);
  a004=(a004*a023);
  a160=(a160-a004);
  a004=(a268*a160);
  a269=(a269-a004);
  a269=(a269/a185);
  a160=(a160/a026);
  a004=(a268*a269);
  a160=(a160-a004);
  a004=(2.*a160);
  a269=(a269-a004);
  a269=(a238*a269);
  a187=(a187+a269);
  a187=(a024*a187);
  a026=(a187/a026);
  a160=(a160*a238);
  a160=(a160-a015);
  a010=(a010*a244);
  a010=(a010*a244);
  a160=(a160+a010);
  a024=(a024*a160);
  a187=(a268*a187);
  a024=(a024-a187);
  a024=(a024/a185);
  a268=(a268*a024);
  a026=(a026-a268);
  a268=(a243*a031);
  a081=(a245*a081);
  a268=(a268+a081);
  a102=(a093*a102);
  a268=(a268+a102);
  a129=(a113*a129);
  a268=(a268+a129);
  a153=(a246*a153);
  a268=(a268+a153);
  a178=(a247*a178);
  a268=(a268+a178);
  a204=(a248*a204);
  a268=(a268+a204);
  a231=(a249*a231);
  a268=(a268+a231);
  a256=(a250*a256);
  a268=(a268+a256);
  a036=(a036+a268);
  a268=(a026*a036);
  a022=(a022+a268);
  a268=(a238*a028);
  a256=(a267-a244);
  a268=(a268*a256);
  a029=(a029-a012);
  a029=(a029+a027);
  a027=(a268/a029);
  a012=(a080/a029);
  a268=(a012*a268);
  a080=(a080*a012);
  a030=(a030-a080);
  a268=(a268/a030);
  a080=(a012*a268);
  a027=(a027+a080);
  a080=(a027*a240);
  a267=(a267*a238);
  a267=(a267*a028);
  a029=(a267/a029);
  a244=(a244*a238);
  a244=(a244*a028);
  a267=(a012*a267);
  a244=(a244+a267);
  a244=(a244/a030);
  a012=(a012*a244);
  a029=(a029+a012);
  a012=(a029*a213);
  a080=(a080-a012);
  a022=(a022+a080);
  a022=(a242*a022);
  a020=(a020+a022);
  a263=(a263+a020);
  if (res[0]!=0) res[0][6]=a263;
  a054=(a001*a054);
  a132=(a005*a132);
  a054=(a054+a132);
  a156=(a117*a156);
  a054=(a054+a156);
  a181=(a140*a181);
  a054=(a054+a181);
  a207=(a164*a207);
  a054=(a054+a207);
  a234=(a189*a234);
  a054=(a054+a234);
  a259=(a215*a259);
  a054=(a054+a259);
  a009=(a019*a009);
  a036=(a024*a036);
  a009=(a009+a036);
  a213=(a244*a213);
  a240=(a268*a240);
  a213=(a213-a240);
  a009=(a009+a213);
  a009=(a242*a009);
  a054=(a054+a009);
  a031=(a031+a054);
  if (res[0]!=0) res[0][7]=a031;
  a031=arg[0]? arg[0][8] : 0;
  a054=arg[0]? arg[0][10] : 0;
  a009=(a001*a054);
  a213=(a199*a031);
  a240=arg[0]? arg[0][9] : 0;
  a036=(a033*a240);
  a213=(a213+a036);
  a036=arg[0]? arg[0][11] : 0;
  a259=(a025*a036);
  a234=(a032*a054);
  a259=(a259-a234);
  a213=(a213+a259);
  a259=(a006*a213);
  a234=(a040*a054);
  a207=(a043*a213);
  a181=(a046*a054);
  a181=(a031+a181);
  a156=(a008*a181);
  a132=(a046*a036);
  a132=(a240+a132);
  a263=(a060*a132);
  a156=(a156+a263);
  a263=(a226*a031);
  a020=(a018*a240);
  a263=(a263+a020);
  a020=(a003*a054);
  a022=(a017*a036);
  a020=(a020-a022);
  a263=(a263+a020);
  a020=(a046*a263);
  a020=(a036+a020);
  a022=(a037*a020);
  a080=(a046*a213);
  a080=(a054+a080);
  a012=(a059*a080);
  a022=(a022-a012);
  a156=(a156+a022);
  a156=(a045*a156);
  a207=(a207+a156);
  a207=(a054+a207);
  a156=(a042*a207);
  a234=(a234+a156);
  a234=(a031+a234);
  a156=(a173*a234);
  a022=(a040*a036);
  a012=(a043*a263);
  a181=(a053*a181);
  a132=(a056*a132);
  a181=(a181+a132);
  a132=(a051*a080);
  a030=(a055*a020);
  a132=(a132-a030);
  a181=(a181+a132);
  a181=(a045*a181);
  a012=(a012+a181);
  a012=(a036+a012);
  a181=(a042*a012);
  a022=(a022+a181);
  a022=(a240+a022);
  a181=(a092*a022);
  a156=(a156+a181);
  a181=(a040*a263);
  a132=(a043*a054);
  a080=(a045*a080);
  a132=(a132+a080);
  a132=(a031+a132);
  a080=(a086*a132);
  a030=(a043*a036);
  a020=(a045*a020);
  a030=(a030+a020);
  a030=(a240+a030);
  a020=(a069*a030);
  a080=(a080+a020);
  a020=(a064*a207);
  a267=(a074*a012);
  a020=(a020-a267);
  a080=(a080+a020);
  a020=(a042*a080);
  a181=(a181+a020);
  a181=(a036+a181);
  a020=(a063*a181);
  a267=(a040*a213);
  a132=(a076*a132);
  a030=(a068*a030);
  a132=(a132+a030);
  a030=(a066*a012);
  a028=(a077*a207);
  a030=(a030-a028);
  a132=(a132+a030);
  a030=(a042*a132);
  a267=(a267+a030);
  a267=(a054+a267);
  a030=(a091*a267);
  a020=(a020-a030);
  a156=(a156+a020);
  a020=(a039*a156);
  a259=(a259+a020);
  a020=(a098*a054);
  a207=(a100*a207);
  a020=(a020+a207);
  a207=(a078*a267);
  a020=(a020+a207);
  a020=(a031+a020);
  a207=(a065*a020);
  a030=(a098*a036);
  a012=(a100*a012);
  a030=(a030+a012);
  a012=(a078*a181);
  a030=(a030+a012);
  a030=(a240+a030);
  a012=(a112*a030);
  a207=(a207+a012);
  a012=(a098*a263);
  a080=(a100*a080);
  a012=(a012+a080);
  a234=(a085*a234);
  a022=(a088*a022);
  a234=(a234+a022);
  a022=(a083*a267);
  a080=(a057*a181);
  a022=(a022-a080);
  a234=(a234+a022);
  a022=(a078*a234);
  a012=(a012+a022);
  a012=(a036+a012);
  a022=(a107*a012);
  a080=(a098*a213);
  a132=(a100*a132);
  a080=(a080+a132);
  a132=(a078*a156);
  a080=(a080+a132);
  a080=(a054+a080);
  a132=(a111*a080);
  a022=(a022-a132);
  a207=(a207+a022);
  a022=(a097*a207);
  a259=(a259+a022);
  a259=(a054+a259);
  a022=(a005*a259);
  a009=(a009+a022);
  a022=(a118*a213);
  a132=(a120*a156);
  a022=(a022+a132);
  a132=(a121*a207);
  a022=(a022+a132);
  a132=(a006*a054);
  a028=(a039*a267);
  a132=(a132+a028);
  a028=(a097*a080);
  a132=(a132+a028);
  a132=(a031+a132);
  a028=(a067*a132);
  a238=(a006*a036);
  a256=(a039*a181);
  a238=(a238+a256);
  a256=(a097*a012);
  a238=(a238+a256);
  a238=(a240+a238);
  a256=(a135*a238);
  a028=(a028+a256);
  a256=(a006*a263);
  a231=(a039*a234);
  a256=(a256+a231);
  a020=(a105*a020);
  a030=(a108*a030);
  a020=(a020+a030);
  a030=(a104*a080);
  a231=(a087*a012);
  a030=(a030-a231);
  a020=(a020+a030);
  a030=(a097*a020);
  a256=(a256+a030);
  a256=(a036+a256);
  a030=(a099*a256);
  a231=(a134*a259);
  a030=(a030-a231);
  a028=(a028+a030);
  a030=(a122*a028);
  a022=(a022+a030);
  a022=(a054+a022);
  a030=(a117*a022);
  a009=(a009+a030);
  a030=(a141*a213);
  a231=(a143*a156);
  a030=(a030+a231);
  a231=(a144*a207);
  a030=(a030+a231);
  a231=(a145*a028);
  a030=(a030+a231);
  a231=(a118*a054);
  a204=(a120*a267);
  a231=(a231+a204);
  a204=(a121*a080);
  a231=(a231+a204);
  a204=(a122*a259);
  a231=(a231+a204);
  a231=(a031+a231);
  a204=(a125*a231);
  a178=(a118*a036);
  a153=(a120*a181);
  a178=(a178+a153);
  a153=(a121*a012);
  a178=(a178+a153);
  a153=(a122*a256);
  a178=(a178+a153);
  a178=(a240+a178);
  a153=(a159*a178);
  a204=(a204+a153);
  a153=(a118*a263);
  a129=(a120*a234);
  a153=(a153+a129);
  a129=(a121*a020);
  a153=(a153+a129);
  a132=(a128*a132);
  a238=(a131*a238);
  a132=(a132+a238);
  a238=(a038*a259);
  a129=(a130*a256);
  a238=(a238-a129);
  a132=(a132+a238);
  a238=(a122*a132);
  a153=(a153+a238);
  a153=(a036+a153);
  a238=(a123*a153);
  a129=(a158*a022);
  a238=(a238-a129);
  a204=(a204+a238);
  a238=(a146*a204);
  a030=(a030+a238);
  a030=(a054+a030);
  a238=(a140*a030);
  a009=(a009+a238);
  a238=(a165*a213);
  a129=(a167*a156);
  a238=(a238+a129);
  a129=(a168*a207);
  a238=(a238+a129);
  a129=(a169*a028);
  a238=(a238+a129);
  a129=(a170*a204);
  a238=(a238+a129);
  a129=(a141*a054);
  a102=(a143*a267);
  a129=(a129+a102);
  a102=(a144*a080);
  a129=(a129+a102);
  a102=(a145*a259);
  a129=(a129+a102);
  a102=(a146*a022);
  a129=(a129+a102);
  a129=(a031+a129);
  a102=(a149*a129);
  a081=(a141*a036);
  a185=(a143*a181);
  a081=(a081+a185);
  a185=(a144*a012);
  a081=(a081+a185);
  a185=(a145*a256);
  a081=(a081+a185);
  a185=(a146*a153);
  a081=(a081+a185);
  a081=(a240+a081);
  a185=(a184*a081);
  a102=(a102+a185);
  a185=(a141*a263);
  a187=(a143*a234);
  a185=(a185+a187);
  a187=(a144*a020);
  a185=(a185+a187);
  a187=(a145*a132);
  a185=(a185+a187);
  a231=(a152*a231);
  a178=(a155*a178);
  a231=(a231+a178);
  a178=(a119*a022);
  a187=(a154*a153);
  a178=(a178-a187);
  a231=(a231+a178);
  a178=(a146*a231);
  a185=(a185+a178);
  a185=(a036+a185);
  a178=(a147*a185);
  a187=(a183*a030);
  a178=(a178-a187);
  a102=(a102+a178);
  a178=(a171*a102);
  a238=(a238+a178);
  a238=(a054+a238);
  a178=(a164*a238);
  a009=(a009+a178);
  a178=(a190*a213);
  a187=(a192*a156);
  a178=(a178+a187);
  a187=(a193*a207);
  a178=(a178+a187);
  a187=(a194*a028);
  a178=(a178+a187);
  a187=(a195*a204);
  a178=(a178+a187);
  a187=(a196*a102);
  a178=(a178+a187);
  a187=(a165*a054);
  a160=(a167*a267);
  a187=(a187+a160);
  a160=(a168*a080);
  a187=(a187+a160);
  a160=(a169*a259);
  a187=(a187+a160);
  a160=(a170*a022);
  a187=(a187+a160);
  a160=(a171*a030);
  a187=(a187+a160);
  a187=(a031+a187);
  a160=(a174*a187);
  a010=(a165*a036);
  a015=(a167*a181);
  a010=(a010+a015);
  a015=(a168*a012);
  a010=(a010+a015);
  a015=(a169*a256);
  a010=(a010+a015);
  a015=(a170*a153);
  a010=(a010+a015);
  a015=(a171*a185);
  a010=(a010+a015);
  a010=(a240+a010);
  a015=(a210*a010);
  a160=(a160+a015);
  a015=(a165*a263);
  a269=(a167*a234);
  a015=(a015+a269);
  a269=(a168*a020);
  a015=(a015+a269);
  a269=(a169*a132);
  a015=(a015+a269);
  a269=(a170*a231);
  a015=(a015+a269);
  a129=(a177*a129);
  a081=(a180*a081);
  a129=(a129+a081);
  a081=(a142*a030);
  a269=(a179*a185);
  a081=(a081-a269);
  a129=(a129+a081);
  a081=(a171*a129);
  a015=(a015+a081);
  a015=(a036+a015);
  a081=(a172*a015);
  a269=(a209*a238);
  a081=(a081-a269);
  a160=(a160+a081);
  a081=(a197*a160);
  a178=(a178+a081);
  a178=(a054+a178);
  a081=(a189*a178);
  a009=(a009+a081);
  a081=(a216*a213);
  a269=(a218*a156);
  a081=(a081+a269);
  a269=(a219*a207);
  a081=(a081+a269);
  a269=(a220*a028);
  a081=(a081+a269);
  a269=(a221*a204);
  a081=(a081+a269);
  a269=(a222*a102);
  a081=(a081+a269);
  a269=(a223*a160);
  a081=(a081+a269);
  a269=(a190*a054);
  a004=(a192*a267);
  a269=(a269+a004);
  a004=(a193*a080);
  a269=(a269+a004);
  a004=(a194*a259);
  a269=(a269+a004);
  a004=(a195*a022);
  a269=(a269+a004);
  a004=(a196*a030);
  a269=(a269+a004);
  a004=(a197*a238);
  a269=(a269+a004);
  a269=(a031+a269);
  a004=(a200*a269);
  a023=(a190*a036);
  a007=(a192*a181);
  a023=(a023+a007);
  a007=(a193*a012);
  a023=(a023+a007);
  a007=(a194*a256);
  a023=(a023+a007);
  a007=(a195*a153);
  a023=(a023+a007);
  a007=(a196*a185);
  a023=(a023+a007);
  a007=(a197*a015);
  a023=(a023+a007);
  a023=(a240+a023);
  a007=(a237*a023);
  a004=(a004+a007);
  a007=(a190*a263);
  a211=(a192*a234);
  a007=(a007+a211);
  a211=(a193*a020);
  a007=(a007+a211);
  a211=(a194*a132);
  a007=(a007+a211);
  a211=(a195*a231);
  a007=(a007+a211);
  a211=(a196*a129);
  a007=(a007+a211);
  a187=(a203*a187);
  a010=(a206*a010);
  a187=(a187+a010);
  a010=(a166*a238);
  a211=(a205*a015);
  a010=(a010-a211);
  a187=(a187+a010);
  a010=(a197*a187);
  a007=(a007+a010);
  a007=(a036+a007);
  a010=(a198*a007);
  a211=(a236*a178);
  a010=(a010-a211);
  a004=(a004+a010);
  a010=(a224*a004);
  a081=(a081+a010);
  a081=(a054+a081);
  a010=(a215*a081);
  a009=(a009+a010);
  a010=(a243*a213);
  a156=(a245*a156);
  a010=(a010+a156);
  a207=(a093*a207);
  a010=(a010+a207);
  a207=(a113*a028);
  a010=(a010+a207);
  a207=(a246*a204);
  a010=(a010+a207);
  a207=(a247*a102);
  a010=(a010+a207);
  a207=(a248*a160);
  a010=(a010+a207);
  a207=(a249*a004);
  a010=(a010+a207);
  a207=(a216*a054);
  a156=(a218*a267);
  a207=(a207+a156);
  a156=(a219*a080);
  a207=(a207+a156);
  a156=(a220*a259);
  a207=(a207+a156);
  a156=(a221*a022);
  a207=(a207+a156);
  a156=(a222*a030);
  a207=(a207+a156);
  a156=(a223*a238);
  a207=(a207+a156);
  a156=(a224*a178);
  a207=(a207+a156);
  a207=(a031+a207);
  a156=(a035*a207);
  a211=(a216*a036);
  a013=(a218*a181);
  a211=(a211+a013);
  a013=(a219*a012);
  a211=(a211+a013);
  a013=(a220*a256);
  a211=(a211+a013);
  a013=(a221*a153);
  a211=(a211+a013);
  a013=(a222*a185);
  a211=(a211+a013);
  a013=(a223*a015);
  a211=(a211+a013);
  a013=(a224*a007);
  a211=(a211+a013);
  a211=(a240+a211);
  a013=(a262*a211);
  a156=(a156+a013);
  a013=(a216*a263);
  a162=(a218*a234);
  a013=(a013+a162);
  a162=(a219*a020);
  a013=(a013+a162);
  a162=(a220*a132);
  a013=(a013+a162);
  a162=(a221*a231);
  a013=(a013+a162);
  a162=(a222*a129);
  a013=(a013+a162);
  a162=(a223*a187);
  a013=(a013+a162);
  a269=(a230*a269);
  a023=(a233*a023);
  a269=(a269+a023);
  a023=(a191*a178);
  a162=(a232*a007);
  a023=(a023-a162);
  a269=(a269+a023);
  a023=(a224*a269);
  a013=(a013+a023);
  a013=(a036+a013);
  a023=(a227*a013);
  a162=(a261*a081);
  a023=(a023-a162);
  a156=(a156+a023);
  a023=(a250*a156);
  a010=(a010+a023);
  a010=(a054+a010);
  a023=(a242*a010);
  a009=(a009+a023);
  a009=(a031+a009);
  if (res[0]!=0) res[0][8]=a009;
  a009=(a001*a036);
  a023=(a005*a256);
  a009=(a009+a023);
  a023=(a117*a153);
  a009=(a009+a023);
  a023=(a140*a185);
  a009=(a009+a023);
  a023=(a164*a015);
  a009=(a009+a023);
  a023=(a189*a007);
  a009=(a009+a023);
  a023=(a215*a013);
  a009=(a009+a023);
  a023=(a243*a263);
  a234=(a245*a234);
  a023=(a023+a234);
  a020=(a093*a020);
  a023=(a023+a020);
  a020=(a113*a132);
  a023=(a023+a020);
  a020=(a246*a231);
  a023=(a023+a020);
  a020=(a247*a129);
  a023=(a023+a020);
  a020=(a248*a187);
  a023=(a023+a020);
  a020=(a249*a269);
  a023=(a023+a020);
  a207=(a255*a207);
  a211=(a258*a211);
  a207=(a207+a211);
  a211=(a217*a081);
  a020=(a257*a013);
  a211=(a211-a020);
  a207=(a207+a211);
  a211=(a250*a207);
  a023=(a023+a211);
  a023=(a036+a023);
  a211=(a242*a023);
  a009=(a009+a211);
  a009=(a240+a009);
  if (res[0]!=0) res[0][9]=a009;
  a213=(a001*a213);
  a028=(a005*a028);
  a213=(a213+a028);
  a204=(a117*a204);
  a213=(a213+a204);
  a102=(a140*a102);
  a213=(a213+a102);
  a160=(a164*a160);
  a213=(a213+a160);
  a004=(a189*a004);
  a213=(a213+a004);
  a156=(a215*a156);
  a213=(a213+a156);
  a156=(a243*a054);
  a267=(a245*a267);
  a156=(a156+a267);
  a080=(a093*a080);
  a156=(a156+a080);
  a259=(a113*a259);
  a156=(a156+a259);
  a022=(a246*a022);
  a156=(a156+a022);
  a030=(a247*a030);
  a156=(a156+a030);
  a238=(a248*a238);
  a156=(a156+a238);
  a178=(a249*a178);
  a156=(a156+a178);
  a081=(a250*a081);
  a156=(a156+a081);
  a031=(a031+a156);
  a156=(a000*a031);
  a081=(a243*a036);
  a181=(a245*a181);
  a081=(a081+a181);
  a012=(a093*a012);
  a081=(a081+a012);
  a256=(a113*a256);
  a081=(a081+a256);
  a153=(a246*a153);
  a081=(a081+a153);
  a185=(a247*a185);
  a081=(a081+a185);
  a015=(a248*a015);
  a081=(a081+a015);
  a007=(a249*a007);
  a081=(a081+a007);
  a013=(a250*a013);
  a081=(a081+a013);
  a240=(a240+a081);
  a081=(a026*a240);
  a156=(a156+a081);
  a081=(a027*a023);
  a013=(a029*a010);
  a081=(a081-a013);
  a156=(a156+a081);
  a156=(a242*a156);
  a213=(a213+a156);
  a054=(a054+a213);
  if (res[0]!=0) res[0][10]=a054;
  a263=(a001*a263);
  a132=(a005*a132);
  a263=(a263+a132);
  a231=(a117*a231);
  a263=(a263+a231);
  a129=(a140*a129);
  a263=(a263+a129);
  a187=(a164*a187);
  a263=(a263+a187);
  a269=(a189*a269);
  a263=(a263+a269);
  a207=(a215*a207);
  a263=(a263+a207);
  a031=(a019*a031);
  a240=(a024*a240);
  a031=(a031+a240);
  a010=(a244*a010);
  a023=(a268*a023);
  a010=(a010-a023);
  a031=(a031+a010);
  a031=(a242*a031);
  a263=(a263+a031);
  a036=(a036+a263);
  if (res[0]!=0) res[0][11]=a036;
  a036=arg[0]? arg[0][12] : 0;
  a263=arg[0]? arg[0][14] : 0;
  a031=(a001*a263);
  a199=(a199*a036);
  a010=arg[0]? arg[0][13] : 0;
  a033=(a033*a010);
  a199=(a199+a033);
  a033=arg[0]? arg[0][15] : 0;
  a025=(a025*a033);
  a032=(a032*a263);
  a025=(a025-a032);
  a199=(a199+a025);
  a025=(a006*a199);
  a032=(a040*a263);
  a023=(a043*a199);
  a240=(a046*a263);
  a240=(a036+a240);
  a008=(a008*a240);
  a207=(a046*a033);
  a207=(a010+a207);
  a060=(a060*a207);
  a008=(a008+a060);
  a226=(a226*a036);
  a018=(a018*a010);
  a226=(a226+a018);
  a003=(a003*a263);
  a017=(a017*a033);
  a003=(a003-a017);
  a226=(a226+a003);
  a003=(a046*a226);
  a003=(a033+a003);
  a037=(a037*a003);
  a046=(a046*a199);
  a046=(a263+a046);
  a059=(a059*a046);
  a037=(a037-a059);
  a008=(a008+a037);
  a008=(a045*a008);
  a023=(a023+a008);
  a023=(a263+a023);
  a008=(a042*a023);
  a032=(a032+a008);
  a032=(a036+a032);
  a173=(a173*a032);
  a008=(a040*a033);
  a037=(a043*a226);
  a053=(a053*a240);
  a056=(a056*a207);
  a053=(a053+a056);
  a051=(a051*a046);
  a055=(a055*a003);
  a051=(a051-a055);
  a053=(a053+a051);
  a053=(a045*a053);
  a037=(a037+a053);
  a037=(a033+a037);
  a053=(a042*a037);
  a008=(a008+a053);
  a008=(a010+a008);
  a092=(a092*a008);
  a173=(a173+a092);
  a092=(a040*a226);
  a053=(a043*a263);
  a046=(a045*a046);
  a053=(a053+a046);
  a053=(a036+a053);
  a086=(a086*a053);
  a043=(a043*a033);
  a045=(a045*a003);
  a043=(a043+a045);
  a043=(a010+a043);
  a069=(a069*a043);
  a086=(a086+a069);
  a064=(a064*a023);
  a074=(a074*a037);
  a064=(a064-a074);
  a086=(a086+a064);
  a064=(a042*a086);
  a092=(a092+a064);
  a092=(a033+a092);
  a063=(a063*a092);
  a040=(a040*a199);
  a076=(a076*a053);
  a068=(a068*a043);
  a076=(a076+a068);
  a066=(a066*a037);
  a077=(a077*a023);
  a066=(a066-a077);
  a076=(a076+a066);
  a042=(a042*a076);
  a040=(a040+a042);
  a040=(a263+a040);
  a091=(a091*a040);
  a063=(a063-a091);
  a173=(a173+a063);
  a063=(a039*a173);
  a025=(a025+a063);
  a063=(a098*a263);
  a023=(a100*a023);
  a063=(a063+a023);
  a023=(a078*a040);
  a063=(a063+a023);
  a063=(a036+a063);
  a065=(a065*a063);
  a023=(a098*a033);
  a037=(a100*a037);
  a023=(a023+a037);
  a037=(a078*a092);
  a023=(a023+a037);
  a023=(a010+a023);
  a112=(a112*a023);
  a065=(a065+a112);
  a112=(a098*a226);
  a086=(a100*a086);
  a112=(a112+a086);
  a085=(a085*a032);
  a088=(a088*a008);
  a085=(a085+a088);
  a083=(a083*a040);
  a057=(a057*a092);
  a083=(a083-a057);
  a085=(a085+a083);
  a083=(a078*a085);
  a112=(a112+a083);
  a112=(a033+a112);
  a107=(a107*a112);
  a098=(a098*a199);
  a100=(a100*a076);
  a098=(a098+a100);
  a078=(a078*a173);
  a098=(a098+a078);
  a098=(a263+a098);
  a111=(a111*a098);
  a107=(a107-a111);
  a065=(a065+a107);
  a107=(a097*a065);
  a025=(a025+a107);
  a025=(a263+a025);
  a107=(a005*a025);
  a031=(a031+a107);
  a107=(a118*a199);
  a111=(a120*a173);
  a107=(a107+a111);
  a111=(a121*a065);
  a107=(a107+a111);
  a111=(a006*a263);
  a078=(a039*a040);
  a111=(a111+a078);
  a078=(a097*a098);
  a111=(a111+a078);
  a111=(a036+a111);
  a067=(a067*a111);
  a078=(a006*a033);
  a100=(a039*a092);
  a078=(a078+a100);
  a100=(a097*a112);
  a078=(a078+a100);
  a078=(a010+a078);
  a135=(a135*a078);
  a067=(a067+a135);
  a006=(a006*a226);
  a039=(a039*a085);
  a006=(a006+a039);
  a105=(a105*a063);
  a108=(a108*a023);
  a105=(a105+a108);
  a104=(a104*a098);
  a087=(a087*a112);
  a104=(a104-a087);
  a105=(a105+a104);
  a097=(a097*a105);
  a006=(a006+a097);
  a006=(a033+a006);
  a099=(a099*a006);
  a134=(a134*a025);
  a099=(a099-a134);
  a067=(a067+a099);
  a099=(a122*a067);
  a107=(a107+a099);
  a107=(a263+a107);
  a099=(a117*a107);
  a031=(a031+a099);
  a099=(a141*a199);
  a134=(a143*a173);
  a099=(a099+a134);
  a134=(a144*a065);
  a099=(a099+a134);
  a134=(a145*a067);
  a099=(a099+a134);
  a134=(a118*a263);
  a097=(a120*a040);
  a134=(a134+a097);
  a097=(a121*a098);
  a134=(a134+a097);
  a097=(a122*a025);
  a134=(a134+a097);
  a134=(a036+a134);
  a125=(a125*a134);
  a097=(a118*a033);
  a104=(a120*a092);
  a097=(a097+a104);
  a104=(a121*a112);
  a097=(a097+a104);
  a104=(a122*a006);
  a097=(a097+a104);
  a097=(a010+a097);
  a159=(a159*a097);
  a125=(a125+a159);
  a118=(a118*a226);
  a120=(a120*a085);
  a118=(a118+a120);
  a121=(a121*a105);
  a118=(a118+a121);
  a128=(a128*a111);
  a131=(a131*a078);
  a128=(a128+a131);
  a038=(a038*a025);
  a130=(a130*a006);
  a038=(a038-a130);
  a128=(a128+a038);
  a122=(a122*a128);
  a118=(a118+a122);
  a118=(a033+a118);
  a123=(a123*a118);
  a158=(a158*a107);
  a123=(a123-a158);
  a125=(a125+a123);
  a123=(a146*a125);
  a099=(a099+a123);
  a099=(a263+a099);
  a123=(a140*a099);
  a031=(a031+a123);
  a123=(a165*a199);
  a158=(a167*a173);
  a123=(a123+a158);
  a158=(a168*a065);
  a123=(a123+a158);
  a158=(a169*a067);
  a123=(a123+a158);
  a158=(a170*a125);
  a123=(a123+a158);
  a158=(a141*a263);
  a122=(a143*a040);
  a158=(a158+a122);
  a122=(a144*a098);
  a158=(a158+a122);
  a122=(a145*a025);
  a158=(a158+a122);
  a122=(a146*a107);
  a158=(a158+a122);
  a158=(a036+a158);
  a149=(a149*a158);
  a122=(a141*a033);
  a038=(a143*a092);
  a122=(a122+a038);
  a038=(a144*a112);
  a122=(a122+a038);
  a038=(a145*a006);
  a122=(a122+a038);
  a038=(a146*a118);
  a122=(a122+a038);
  a122=(a010+a122);
  a184=(a184*a122);
  a149=(a149+a184);
  a141=(a141*a226);
  a143=(a143*a085);
  a141=(a141+a143);
  a144=(a144*a105);
  a141=(a141+a144);
  a145=(a145*a128);
  a141=(a141+a145);
  a152=(a152*a134);
  a155=(a155*a097);
  a152=(a152+a155);
  a119=(a119*a107);
  a154=(a154*a118);
  a119=(a119-a154);
  a152=(a152+a119);
  a146=(a146*a152);
  a141=(a141+a146);
  a141=(a033+a141);
  a147=(a147*a141);
  a183=(a183*a099);
  a147=(a147-a183);
  a149=(a149+a147);
  a147=(a171*a149);
  a123=(a123+a147);
  a123=(a263+a123);
  a147=(a164*a123);
  a031=(a031+a147);
  a147=(a190*a199);
  a183=(a192*a173);
  a147=(a147+a183);
  a183=(a193*a065);
  a147=(a147+a183);
  a183=(a194*a067);
  a147=(a147+a183);
  a183=(a195*a125);
  a147=(a147+a183);
  a183=(a196*a149);
  a147=(a147+a183);
  a183=(a165*a263);
  a146=(a167*a040);
  a183=(a183+a146);
  a146=(a168*a098);
  a183=(a183+a146);
  a146=(a169*a025);
  a183=(a183+a146);
  a146=(a170*a107);
  a183=(a183+a146);
  a146=(a171*a099);
  a183=(a183+a146);
  a183=(a036+a183);
  a174=(a174*a183);
  a146=(a165*a033);
  a119=(a167*a092);
  a146=(a146+a119);
  a119=(a168*a112);
  a146=(a146+a119);
  a119=(a169*a006);
  a146=(a146+a119);
  a119=(a170*a118);
  a146=(a146+a119);
  a119=(a171*a141);
  a146=(a146+a119);
  a146=(a010+a146);
  a210=(a210*a146);
  a174=(a174+a210);
  a165=(a165*a226);
  a167=(a167*a085);
  a165=(a165+a167);
  a168=(a168*a105);
  a165=(a165+a168);
  a169=(a169*a128);
  a165=(a165+a169);
  a170=(a170*a152);
  a165=(a165+a170);
  a177=(a177*a158);
  a180=(a180*a122);
  a177=(a177+a180);
  a142=(a142*a099);
  a179=(a179*a141);
  a142=(a142-a179);
  a177=(a177+a142);
  a171=(a171*a177);
  a165=(a165+a171);
  a165=(a033+a165);
  a172=(a172*a165);
  a209=(a209*a123);
  a172=(a172-a209);
  a174=(a174+a172);
  a172=(a197*a174);
  a147=(a147+a172);
  a147=(a263+a147);
  a172=(a189*a147);
  a031=(a031+a172);
  a172=(a216*a199);
  a209=(a218*a173);
  a172=(a172+a209);
  a209=(a219*a065);
  a172=(a172+a209);
  a209=(a220*a067);
  a172=(a172+a209);
  a209=(a221*a125);
  a172=(a172+a209);
  a209=(a222*a149);
  a172=(a172+a209);
  a209=(a223*a174);
  a172=(a172+a209);
  a209=(a190*a263);
  a171=(a192*a040);
  a209=(a209+a171);
  a171=(a193*a098);
  a209=(a209+a171);
  a171=(a194*a025);
  a209=(a209+a171);
  a171=(a195*a107);
  a209=(a209+a171);
  a171=(a196*a099);
  a209=(a209+a171);
  a171=(a197*a123);
  a209=(a209+a171);
  a209=(a036+a209);
  a200=(a200*a209);
  a171=(a190*a033);
  a142=(a192*a092);
  a171=(a171+a142);
  a142=(a193*a112);
  a171=(a171+a142);
  a142=(a194*a006);
  a171=(a171+a142);
  a142=(a195*a118);
  a171=(a171+a142);
  a142=(a196*a141);
  a171=(a171+a142);
  a142=(a197*a165);
  a171=(a171+a142);
  a171=(a010+a171);
  a237=(a237*a171);
  a200=(a200+a237);
  a190=(a190*a226);
  a192=(a192*a085);
  a190=(a190+a192);
  a193=(a193*a105);
  a190=(a190+a193);
  a194=(a194*a128);
  a190=(a190+a194);
  a195=(a195*a152);
  a190=(a190+a195);
  a196=(a196*a177);
  a190=(a190+a196);
  a203=(a203*a183);
  a206=(a206*a146);
  a203=(a203+a206);
  a166=(a166*a123);
  a205=(a205*a165);
  a166=(a166-a205);
  a203=(a203+a166);
  a197=(a197*a203);
  a190=(a190+a197);
  a190=(a033+a190);
  a198=(a198*a190);
  a236=(a236*a147);
  a198=(a198-a236);
  a200=(a200+a198);
  a198=(a224*a200);
  a172=(a172+a198);
  a172=(a263+a172);
  a198=(a215*a172);
  a031=(a031+a198);
  a198=(a243*a199);
  a173=(a245*a173);
  a198=(a198+a173);
  a065=(a093*a065);
  a198=(a198+a065);
  a065=(a113*a067);
  a198=(a198+a065);
  a065=(a246*a125);
  a198=(a198+a065);
  a065=(a247*a149);
  a198=(a198+a065);
  a065=(a248*a174);
  a198=(a198+a065);
  a065=(a249*a200);
  a198=(a198+a065);
  a065=(a216*a263);
  a173=(a218*a040);
  a065=(a065+a173);
  a173=(a219*a098);
  a065=(a065+a173);
  a173=(a220*a025);
  a065=(a065+a173);
  a173=(a221*a107);
  a065=(a065+a173);
  a173=(a222*a099);
  a065=(a065+a173);
  a173=(a223*a123);
  a065=(a065+a173);
  a173=(a224*a147);
  a065=(a065+a173);
  a065=(a036+a065);
  a035=(a035*a065);
  a173=(a216*a033);
  a236=(a218*a092);
  a173=(a173+a236);
  a236=(a219*a112);
  a173=(a173+a236);
  a236=(a220*a006);
  a173=(a173+a236);
  a236=(a221*a118);
  a173=(a173+a236);
  a236=(a222*a141);
  a173=(a173+a236);
  a236=(a223*a165);
  a173=(a173+a236);
  a236=(a224*a190);
  a173=(a173+a236);
  a173=(a010+a173);
  a262=(a262*a173);
  a035=(a035+a262);
  a216=(a216*a226);
  a218=(a218*a085);
  a216=(a216+a218);
  a219=(a219*a105);
  a216=(a216+a219);
  a220=(a220*a128);
  a216=(a216+a220);
  a221=(a221*a152);
  a216=(a216+a221);
  a222=(a222*a177);
  a216=(a216+a222);
  a223=(a223*a203);
  a216=(a216+a223);
  a230=(a230*a209);
  a233=(a233*a171);
  a230=(a230+a233);
  a191=(a191*a147);
  a232=(a232*a190);
  a191=(a191-a232);
  a230=(a230+a191);
  a224=(a224*a230);
  a216=(a216+a224);
  a216=(a033+a216);
  a227=(a227*a216);
  a261=(a261*a172);
  a227=(a227-a261);
  a035=(a035+a227);
  a227=(a250*a035);
  a198=(a198+a227);
  a198=(a263+a198);
  a227=(a242*a198);
  a031=(a031+a227);
  a031=(a036+a031);
  if (res[0]!=0) res[0][12]=a031;
  a031=(a001*a033);
  a227=(a005*a006);
  a031=(a031+a227);
  a227=(a117*a118);
  a031=(a031+a227);
  a227=(a140*a141);
  a031=(a031+a227);
  a227=(a164*a165);
  a031=(a031+a227);
  a227=(a189*a190);
  a031=(a031+a227);
  a227=(a215*a216);
  a031=(a031+a227);
  a227=(a243*a226);
  a085=(a245*a085);
  a227=(a227+a085);
  a105=(a093*a105);
  a227=(a227+a105);
  a105=(a113*a128);
  a227=(a227+a105);
  a105=(a246*a152);
  a227=(a227+a105);
  a105=(a247*a177);
  a227=(a227+a105);
  a105=(a248*a203);
  a227=(a227+a105);
  a105=(a249*a230);
  a227=(a227+a105);
  a255=(a255*a065);
  a258=(a258*a173);
  a255=(a255+a258);
  a217=(a217*a172);
  a257=(a257*a216);
  a217=(a217-a257);
  a255=(a255+a217);
  a217=(a250*a255);
  a227=(a227+a217);
  a227=(a033+a227);
  a217=(a242*a227);
  a031=(a031+a217);
  a031=(a010+a031);
  if (res[0]!=0) res[0][13]=a031;
  a199=(a001*a199);
  a067=(a005*a067);
  a199=(a199+a067);
  a125=(a117*a125);
  a199=(a199+a125);
  a149=(a140*a149);
  a199=(a199+a149);
  a174=(a164*a174);
  a199=(a199+a174);
  a200=(a189*a200);
  a199=(a199+a200);
  a035=(a215*a035);
  a199=(a199+a035);
  a035=(a243*a263);
  a040=(a245*a040);
  a035=(a035+a040);
  a098=(a093*a098);
  a035=(a035+a098);
  a025=(a113*a025);
  a035=(a035+a025);
  a107=(a246*a107);
  a035=(a035+a107);
  a099=(a247*a099);
  a035=(a035+a099);
  a123=(a248*a123);
  a035=(a035+a123);
  a147=(a249*a147);
  a035=(a035+a147);
  a172=(a250*a172);
  a035=(a035+a172);
  a036=(a036+a035);
  a000=(a000*a036);
  a243=(a243*a033);
  a245=(a245*a092);
  a243=(a243+a245);
  a093=(a093*a112);
  a243=(a243+a093);
  a113=(a113*a006);
  a243=(a243+a113);
  a246=(a246*a118);
  a243=(a243+a246);
  a247=(a247*a141);
  a243=(a243+a247);
  a248=(a248*a165);
  a243=(a243+a248);
  a249=(a249*a190);
  a243=(a243+a249);
  a250=(a250*a216);
  a243=(a243+a250);
  a010=(a010+a243);
  a026=(a026*a010);
  a000=(a000+a026);
  a027=(a027*a227);
  a029=(a029*a198);
  a027=(a027-a029);
  a000=(a000+a027);
  a000=(a242*a000);
  a199=(a199+a000);
  a263=(a263+a199);
  if (res[0]!=0) res[0][14]=a263;
  a001=(a001*a226);
  a005=(a005*a128);
  a001=(a001+a005);
  a117=(a117*a152);
  a001=(a001+a117);
  a140=(a140*a177);
  a001=(a001+a140);
  a164=(a164*a203);
  a001=(a001+a164);
  a189=(a189*a230);
  a001=(a001+a189);
  a215=(a215*a255);
  a001=(a001+a215);
  a019=(a019*a036);
  a024=(a024*a010);
  a019=(a019+a024);
  a244=(a244*a198);
  a268=(a268*a227);
  a244=(a244-a268);
  a019=(a019+a244);
  a242=(a242*a019);
  a001=(a001+a242);
  a033=(a033+a001);
  if (res[0]!=0) res[0][15]=a033;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[3])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+271, w1, *w2=w+287, *w3=w+290, w5, *w6=w+292, w7;
  const casadi_real **arg1=arg+5, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w2);
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

/* landing_with_derivative:(y[4x4],z[3],T,p[3])->(J[4x4],R[4]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[0]? arg[0][2] : 0;
  a04=arg[0]? arg[0][1] : 0;
  a05=sin(a04);
  a06=(-a05);
  a06=(2.*a06);
  a06=(a02*a06);
  a07=arg[3]? arg[3][0] : 0;
  a08=(a02*a05);
  a08=(a07*a08);
  a09=arg[3]? arg[3][1] : 0;
  a10=(a09+a03);
  a11=(a09/a10);
  a12=(a11*a06);
  a08=(a08+a12);
  a06=(a06-a08);
  a08=(2.*a09);
  a12=(a08/a10);
  a13=cos(a04);
  a14=(a13+a03);
  a14=(a12*a14);
  a15=(a07-a14);
  a16=casadi_sq(a09);
  a17=(a16+a08);
  a17=(a17+a03);
  a18=(a16/a17);
  a19=(2.*a18);
  a15=(a15+a19);
  a20=2.;
  a15=(a15+a20);
  a21=(a06/a15);
  a22=(a13*a02);
  a22=(a22*a07);
  a23=(2.*a13);
  a24=(a23*a02);
  a25=(2.*a02);
  a26=arg[0]? arg[0][3] : 0;
  a27=(a25-a26);
  a28=(a24+a27);
  a28=(a11*a28);
  a22=(a22-a28);
  a27=(a18*a27);
  a22=(a22+a27);
  a22=(a22+a24);
  a24=(a22/a15);
  a27=(a24/a15);
  a12=(a12*a05);
  a27=(a27*a12);
  a21=(a21-a27);
  a27=(a09*a02);
  a28=casadi_sq(a10);
  a27=(a27/a28);
  a29=(a13-a11);
  a29=(a11*a29);
  a30=(a29/a15);
  a31=(a30*a22);
  a27=(a27-a31);
  a16=(a16/a28);
  a31=(a29*a30);
  a31=(a16-a31);
  a27=(a27/a31);
  a32=(a11*a05);
  a33=(a32/a15);
  a34=(a30/a15);
  a34=(a34*a12);
  a33=(a33+a34);
  a34=(a27*a33);
  a06=(a30*a06);
  a22=(a22*a33);
  a06=(a06-a22);
  a06=(a06/a31);
  a22=(a27/a31);
  a32=(a30*a32);
  a33=(a29*a33);
  a32=(a32+a33);
  a22=(a22*a32);
  a06=(a06+a22);
  a22=(a30*a06);
  a34=(a34+a22);
  a21=(a21+a34);
  a34=(a21*a01);
  a13=(a07*a13);
  a22=(a23+a20);
  a22=(a11*a22);
  a13=(a13-a22);
  a13=(a13+a19);
  a13=(a13+a23);
  a23=(a13/a15);
  a28=(a09/a28);
  a13=(a30*a13);
  a28=(a28-a13);
  a28=(a28/a31);
  a13=(a30*a28);
  a23=(a23-a13);
  a13=arg[0]? arg[0][6] : 0;
  a19=(a23*a13);
  a34=(a34+a19);
  a18=(a11-a18);
  a15=(a18/a15);
  a18=(a30*a18);
  a18=(a18/a31);
  a31=(a30*a18);
  a15=(a15+a31);
  a31=arg[0]? arg[0][7] : 0;
  a19=(a15*a31);
  a34=(a34+a19);
  if (res[0]!=0) res[0][1]=a34;
  a13=(a28*a13);
  a34=(a06*a01);
  a13=(a13-a34);
  a31=(a18*a31);
  a13=(a13-a31);
  if (res[0]!=0) res[0][2]=a13;
  a13=-2.;
  a00=(a13*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a31=(a00-a01);
  if (res[0]!=0) res[0][4]=a31;
  a31=(a21*a01);
  a34=arg[0]? arg[0][10] : 0;
  a19=(a23*a34);
  a31=(a31+a19);
  a19=arg[0]? arg[0][11] : 0;
  a22=(a15*a19);
  a31=(a31+a22);
  a31=(a31-a03);
  if (res[0]!=0) res[0][5]=a31;
  a34=(a28*a34);
  a31=(a06*a01);
  a34=(a34-a31);
  a19=(a18*a19);
  a34=(a34-a19);
  if (res[0]!=0) res[0][6]=a34;
  a00=(a13*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a34=(a00-a01);
  if (res[0]!=0) res[0][8]=a34;
  a34=(a21*a01);
  a19=arg[0]? arg[0][14] : 0;
  a31=(a23*a19);
  a34=(a34+a31);
  a31=arg[0]? arg[0][15] : 0;
  a22=(a15*a31);
  a34=(a34+a22);
  if (res[0]!=0) res[0][9]=a34;
  a19=(a28*a19);
  a34=(a06*a01);
  a19=(a19-a34);
  a31=(a18*a31);
  a19=(a19-a31);
  a19=(a19-a03);
  if (res[0]!=0) res[0][10]=a19;
  a00=(a13*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=(a02-a26);
  if (res[0]!=0) res[0][12]=a00;
  a21=(a21*a26);
  a00=(a09*a26);
  a00=(a00*a05);
  a00=(a00/a10);
  a25=(a26-a25);
  a00=(a00*a25);
  a25=arg[3]? arg[3][2] : 0;
  a01=arg[0]? arg[0][0] : 0;
  a25=(a25-a01);
  a19=(a25+a04);
  a19=sin(a19);
  a03=(a09*a19);
  a03=(a03/a10);
  a00=(a00+a03);
  a25=sin(a25);
  a03=(a11-a07);
  a03=(a03-a20);
  a25=(a25*a03);
  a00=(a00+a25);
  a08=(a08*a09);
  a08=(a08/a17);
  a08=(a08-a14);
  a08=(a08+a07);
  a08=(a08+a20);
  a20=(a00/a08);
  a08=(a29/a08);
  a07=casadi_sq(a02);
  a07=(a07*a05);
  a07=(a07-a19);
  a11=(a11*a07);
  a00=(a08*a00);
  a11=(a11-a00);
  a29=(a29*a08);
  a16=(a16-a29);
  a11=(a11/a16);
  a08=(a08*a11);
  a20=(a20-a08);
  a23=(a23*a20);
  a21=(a21+a23);
  a15=(a15*a11);
  a21=(a21+a15);
  if (res[0]!=0) res[0][13]=a21;
  a28=(a28*a20);
  a06=(a06*a26);
  a28=(a28-a06);
  a18=(a18*a11);
  a28=(a28-a18);
  if (res[0]!=0) res[0][14]=a28;
  a13=(a13*a02);
  a13=(a13+a26);
  if (res[0]!=0) res[0][15]=a13;
  a13=(a01-a04);
  a26=arg[1]? arg[1][0] : 0;
  a13=(a13-a26);
  if (res[1]!=0) res[1][0]=a13;
  a30=(a30*a27);
  a24=(a24-a30);
  a30=arg[1]? arg[1][1] : 0;
  a24=(a24-a30);
  if (res[1]!=0) res[1][1]=a24;
  a24=arg[1]? arg[1][2] : 0;
  a27=(a27-a24);
  if (res[1]!=0) res[1][2]=a27;
  a01=(2.*a01);
  a04=(a04-a01);
  if (res[1]!=0) res[1][3]=a04;
  return 0;
}

/* goswami_compass_jacobian_12:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* scaled_jacobian_12:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+420, *w1=w+436, *w2=w+440, *w3=w+443, *w4=w+459;
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
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, @4} = goswami_compass_jacobian_12(@1, @2) */
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

/* newton_12:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_12:(i0[4],i1[3])->(o0[4]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+527, *w1=w+531, *w2=w+534;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* plain_step:(y[4],phase[2],turns[2x12],h,p[3])->(y_end[4]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77;
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
  a12=1.;
  a13=(a07+a12);
  a09=(a09/a13);
  a14=(2.*a03);
  a14=(a08-a14);
  a09=(a09*a14);
  a14=arg[4]? arg[4][2] : 0;
  a15=(a14-a00);
  a15=(a15+a10);
  a15=sin(a15);
  a16=(a07*a15);
  a16=(a16/a13);
  a09=(a09+a16);
  a16=sin(a14);
  a17=cos(a00);
  a17=(a16*a17);
  a18=cos(a14);
  a19=sin(a00);
  a19=(a18*a19);
  a17=(a17-a19);
  a19=(a07/a13);
  a20=arg[4]? arg[4][0] : 0;
  a21=(a19-a20);
  a22=2.;
  a21=(a21-a22);
  a17=(a17*a21);
  a09=(a09+a17);
  a17=(2.*a07);
  a23=(a17*a07);
  a24=casadi_sq(a07);
  a25=(a24+a17);
  a25=(a25+a12);
  a23=(a23/a25);
  a17=(a17/a13);
  a25=cos(a10);
  a26=(a25+a12);
  a26=(a17*a26);
  a26=(a23-a26);
  a26=(a26+a20);
  a26=(a26+a22);
  a27=(a09/a26);
  a25=(a25-a19);
  a25=(a19*a25);
  a26=(a25/a26);
  a28=casadi_sq(a03);
  a28=(a28*a11);
  a28=(a28-a15);
  a28=(a19*a28);
  a09=(a26*a09);
  a28=(a28-a09);
  a09=casadi_sq(a13);
  a24=(a24/a09);
  a25=(a25*a26);
  a25=(a24-a25);
  a28=(a28/a25);
  a26=(a26*a28);
  a27=(a27-a26);
  a26=(a06*a27);
  a25=1.7082860872947386e-01;
  a25=(a25*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a15=(a09*a28);
  a11=8.8762756430420545e-02;
  a11=(a11*a02);
  a29=1.9725056984537900e-02;
  a29=(a29*a02);
  a30=(a29*a27);
  a31=5.9175170953613701e-02;
  a31=(a31*a02);
  a32=5.2600151958767730e-02;
  a32=(a32*a02);
  a33=(a32*a28);
  a33=(a08+a33);
  a34=(a07*a33);
  a35=(a32*a08);
  a35=(a10+a35);
  a36=sin(a35);
  a34=(a34*a36);
  a34=(a34/a13);
  a37=(a32*a27);
  a37=(a03+a37);
  a38=(2.*a37);
  a38=(a33-a38);
  a34=(a34*a38);
  a32=(a32*a03);
  a32=(a00+a32);
  a38=(a14-a32);
  a38=(a38+a35);
  a38=sin(a38);
  a39=(a07*a38);
  a39=(a39/a13);
  a34=(a34+a39);
  a39=cos(a32);
  a39=(a16*a39);
  a32=sin(a32);
  a32=(a18*a32);
  a39=(a39-a32);
  a39=(a39*a21);
  a34=(a34+a39);
  a35=cos(a35);
  a39=(a35+a12);
  a39=(a17*a39);
  a39=(a23-a39);
  a39=(a39+a20);
  a39=(a39+a22);
  a32=(a34/a39);
  a35=(a35-a19);
  a35=(a19*a35);
  a39=(a35/a39);
  a40=casadi_sq(a37);
  a40=(a40*a36);
  a40=(a40-a38);
  a40=(a19*a40);
  a34=(a39*a34);
  a40=(a40-a34);
  a35=(a35*a39);
  a35=(a24-a35);
  a40=(a40/a35);
  a39=(a39*a40);
  a32=(a32-a39);
  a32=(a31*a32);
  a30=(a30+a32);
  a30=(a03+a30);
  a32=casadi_sq(a30);
  a39=(a29*a08);
  a33=(a31*a33);
  a39=(a39+a33);
  a39=(a10+a39);
  a33=sin(a39);
  a32=(a32*a33);
  a35=(a29*a03);
  a37=(a31*a37);
  a35=(a35+a37);
  a35=(a00+a35);
  a37=(a14-a35);
  a37=(a37+a39);
  a37=sin(a37);
  a32=(a32-a37);
  a32=(a19*a32);
  a39=cos(a39);
  a34=(a39-a19);
  a34=(a19*a34);
  a39=(a39+a12);
  a39=(a17*a39);
  a39=(a23-a39);
  a39=(a39+a20);
  a39=(a39+a22);
  a38=(a34/a39);
  a29=(a29*a28);
  a31=(a31*a40);
  a29=(a29+a31);
  a29=(a08+a29);
  a31=(a07*a29);
  a31=(a31*a33);
  a31=(a31/a13);
  a33=(2.*a30);
  a33=(a29-a33);
  a31=(a31*a33);
  a37=(a07*a37);
  a37=(a37/a13);
  a31=(a31+a37);
  a37=cos(a35);
  a37=(a16*a37);
  a35=sin(a35);
  a35=(a18*a35);
  a37=(a37-a35);
  a37=(a37*a21);
  a31=(a31+a37);
  a37=(a38*a31);
  a32=(a32-a37);
  a34=(a34*a38);
  a34=(a24-a34);
  a32=(a32/a34);
  a34=(a11*a32);
  a15=(a15+a34);
  a15=(a08+a15);
  a34=(a07*a15);
  a37=(a09*a08);
  a35=(a11*a29);
  a37=(a37+a35);
  a37=(a10+a37);
  a35=sin(a37);
  a34=(a34*a35);
  a34=(a34/a13);
  a33=(a09*a27);
  a31=(a31/a39);
  a38=(a38*a32);
  a31=(a31-a38);
  a38=(a11*a31);
  a33=(a33+a38);
  a33=(a03+a33);
  a38=(2.*a33);
  a38=(a15-a38);
  a34=(a34*a38);
  a09=(a09*a03);
  a11=(a11*a30);
  a09=(a09+a11);
  a09=(a00+a09);
  a11=(a14-a09);
  a11=(a11+a37);
  a11=sin(a11);
  a38=(a07*a11);
  a38=(a38/a13);
  a34=(a34+a38);
  a38=cos(a09);
  a38=(a16*a38);
  a09=sin(a09);
  a09=(a18*a09);
  a38=(a38-a09);
  a38=(a38*a21);
  a34=(a34+a38);
  a37=cos(a37);
  a38=(a37+a12);
  a38=(a17*a38);
  a38=(a23-a38);
  a38=(a38+a20);
  a38=(a38+a22);
  a09=(a34/a38);
  a37=(a37-a19);
  a37=(a19*a37);
  a38=(a37/a38);
  a39=casadi_sq(a33);
  a39=(a39*a35);
  a39=(a39-a11);
  a39=(a19*a39);
  a34=(a38*a34);
  a39=(a39-a34);
  a37=(a37*a38);
  a37=(a24-a37);
  a39=(a39/a37);
  a38=(a38*a39);
  a09=(a09-a38);
  a38=(a25*a09);
  a26=(a26+a38);
  a38=1.2546768756682242e-01;
  a38=(a38*a02);
  a37=2.4136513415926669e-01;
  a37=(a37*a02);
  a34=(a37*a28);
  a11=-8.8454947932828609e-01;
  a11=(a11*a02);
  a32=(a11*a32);
  a34=(a34+a32);
  a32=9.2483400326179199e-01;
  a32=(a32*a02);
  a35=(a32*a39);
  a34=(a34+a35);
  a34=(a08+a34);
  a35=(a07*a34);
  a40=(a37*a08);
  a29=(a11*a29);
  a40=(a40+a29);
  a29=(a32*a15);
  a40=(a40+a29);
  a40=(a10+a40);
  a29=sin(a40);
  a35=(a35*a29);
  a35=(a35/a13);
  a36=(a37*a27);
  a31=(a11*a31);
  a36=(a36+a31);
  a31=(a32*a09);
  a36=(a36+a31);
  a36=(a03+a36);
  a31=(2.*a36);
  a31=(a34-a31);
  a35=(a35*a31);
  a37=(a37*a03);
  a11=(a11*a30);
  a37=(a37+a11);
  a32=(a32*a33);
  a37=(a37+a32);
  a37=(a00+a37);
  a32=(a14-a37);
  a32=(a32+a40);
  a32=sin(a32);
  a11=(a07*a32);
  a11=(a11/a13);
  a35=(a35+a11);
  a11=cos(a37);
  a11=(a16*a11);
  a37=sin(a37);
  a37=(a18*a37);
  a11=(a11-a37);
  a11=(a11*a21);
  a35=(a35+a11);
  a40=cos(a40);
  a11=(a40+a12);
  a11=(a17*a11);
  a11=(a23-a11);
  a11=(a11+a20);
  a11=(a11+a22);
  a37=(a35/a11);
  a40=(a40-a19);
  a40=(a19*a40);
  a11=(a40/a11);
  a30=casadi_sq(a36);
  a30=(a30*a29);
  a30=(a30-a32);
  a30=(a19*a30);
  a35=(a11*a35);
  a30=(a30-a35);
  a40=(a40*a11);
  a40=(a24-a40);
  a30=(a30/a40);
  a11=(a11*a30);
  a37=(a37-a11);
  a11=(a38*a37);
  a26=(a26+a11);
  a26=(a03+a26);
  a11=(a05*a26);
  a04=(a04+a11);
  a11=1.8915178993145003e+00;
  a11=(a11*a02);
  a40=3.7109375000000000e-02;
  a40=(a40*a02);
  a35=(a40*a27);
  a32=1.7025221101954405e-01;
  a32=(a32*a02);
  a29=(a32*a09);
  a35=(a35+a29);
  a29=6.0216538980455959e-02;
  a29=(a29*a02);
  a31=(a29*a37);
  a35=(a35+a31);
  a31=-1.7578125000000000e-02;
  a31=(a31*a02);
  a41=(a06*a28);
  a42=(a25*a39);
  a41=(a41+a42);
  a42=(a38*a30);
  a41=(a41+a42);
  a41=(a08+a41);
  a42=(a07*a41);
  a43=(a06*a08);
  a44=(a25*a15);
  a43=(a43+a44);
  a44=(a38*a34);
  a43=(a43+a44);
  a43=(a10+a43);
  a44=sin(a43);
  a42=(a42*a44);
  a42=(a42/a13);
  a45=(2.*a26);
  a45=(a41-a45);
  a42=(a42*a45);
  a06=(a06*a03);
  a25=(a25*a33);
  a06=(a06+a25);
  a38=(a38*a36);
  a06=(a06+a38);
  a06=(a00+a06);
  a38=(a14-a06);
  a38=(a38+a43);
  a38=sin(a38);
  a25=(a07*a38);
  a25=(a25/a13);
  a42=(a42+a25);
  a25=cos(a06);
  a25=(a16*a25);
  a06=sin(a06);
  a06=(a18*a06);
  a25=(a25-a06);
  a25=(a25*a21);
  a42=(a42+a25);
  a43=cos(a43);
  a25=(a43+a12);
  a25=(a17*a25);
  a25=(a23-a25);
  a25=(a25+a20);
  a25=(a25+a22);
  a06=(a42/a25);
  a43=(a43-a19);
  a43=(a19*a43);
  a25=(a43/a25);
  a45=casadi_sq(a26);
  a45=(a45*a44);
  a45=(a45-a38);
  a45=(a19*a45);
  a42=(a25*a42);
  a45=(a45-a42);
  a43=(a43*a25);
  a43=(a24-a43);
  a45=(a45/a43);
  a25=(a25*a45);
  a06=(a06-a25);
  a25=(a31*a06);
  a35=(a35+a25);
  a35=(a03+a35);
  a25=(a11*a35);
  a04=(a04+a25);
  a25=-5.8012039600105849e+00;
  a25=(a25*a02);
  a43=3.7092000118504789e-02;
  a43=(a43*a02);
  a42=(a43*a27);
  a38=1.7038392571223998e-01;
  a38=(a38*a02);
  a44=(a38*a09);
  a42=(a42+a44);
  a44=1.0726203044637328e-01;
  a44=(a44*a02);
  a46=(a44*a37);
  a42=(a42+a46);
  a46=-1.5319437748624402e-02;
  a46=(a46*a02);
  a47=(a46*a06);
  a42=(a42+a47);
  a47=8.2737891638140233e-03;
  a47=(a47*a02);
  a48=(a40*a28);
  a49=(a32*a39);
  a48=(a48+a49);
  a49=(a29*a30);
  a48=(a48+a49);
  a49=(a31*a45);
  a48=(a48+a49);
  a48=(a08+a48);
  a49=(a07*a48);
  a50=(a40*a08);
  a51=(a32*a15);
  a50=(a50+a51);
  a51=(a29*a34);
  a50=(a50+a51);
  a51=(a31*a41);
  a50=(a50+a51);
  a50=(a10+a50);
  a51=sin(a50);
  a49=(a49*a51);
  a49=(a49/a13);
  a52=(2.*a35);
  a52=(a48-a52);
  a49=(a49*a52);
  a40=(a40*a03);
  a32=(a32*a33);
  a40=(a40+a32);
  a29=(a29*a36);
  a40=(a40+a29);
  a31=(a31*a26);
  a40=(a40+a31);
  a40=(a00+a40);
  a31=(a14-a40);
  a31=(a31+a50);
  a31=sin(a31);
  a29=(a07*a31);
  a29=(a29/a13);
  a49=(a49+a29);
  a29=cos(a40);
  a29=(a16*a29);
  a40=sin(a40);
  a40=(a18*a40);
  a29=(a29-a40);
  a29=(a29*a21);
  a49=(a49+a29);
  a50=cos(a50);
  a29=(a50+a12);
  a29=(a17*a29);
  a29=(a23-a29);
  a29=(a29+a20);
  a29=(a29+a22);
  a40=(a49/a29);
  a50=(a50-a19);
  a50=(a19*a50);
  a29=(a50/a29);
  a32=casadi_sq(a35);
  a32=(a32*a51);
  a32=(a32-a31);
  a32=(a19*a32);
  a49=(a29*a49);
  a32=(a32-a49);
  a50=(a50*a29);
  a50=(a24-a50);
  a32=(a32/a50);
  a29=(a29*a32);
  a40=(a40-a29);
  a29=(a47*a40);
  a42=(a42+a29);
  a42=(a03+a42);
  a29=(a25*a42);
  a04=(a04+a29);
  a29=3.1116436695781990e-01;
  a29=(a29*a02);
  a50=6.2411095871607569e-01;
  a50=(a50*a02);
  a49=(a50*a27);
  a31=-3.3608926294469414e+00;
  a31=(a31*a02);
  a51=(a31*a09);
  a49=(a49+a51);
  a51=-8.6821934684172597e-01;
  a51=(a51*a02);
  a52=(a51*a37);
  a49=(a49+a52);
  a52=2.7592099699446710e+01;
  a52=(a52*a02);
  a53=(a52*a06);
  a49=(a49+a53);
  a53=2.0154067550477894e+01;
  a53=(a53*a02);
  a54=(a53*a40);
  a49=(a49+a54);
  a54=-4.3489884181069961e+01;
  a54=(a54*a02);
  a55=(a43*a28);
  a56=(a38*a39);
  a55=(a55+a56);
  a56=(a44*a30);
  a55=(a55+a56);
  a56=(a46*a45);
  a55=(a55+a56);
  a56=(a47*a32);
  a55=(a55+a56);
  a55=(a08+a55);
  a56=(a07*a55);
  a57=(a43*a08);
  a58=(a38*a15);
  a57=(a57+a58);
  a58=(a44*a34);
  a57=(a57+a58);
  a58=(a46*a41);
  a57=(a57+a58);
  a58=(a47*a48);
  a57=(a57+a58);
  a57=(a10+a57);
  a58=sin(a57);
  a56=(a56*a58);
  a56=(a56/a13);
  a59=(2.*a42);
  a59=(a55-a59);
  a56=(a56*a59);
  a43=(a43*a03);
  a38=(a38*a33);
  a43=(a43+a38);
  a44=(a44*a36);
  a43=(a43+a44);
  a46=(a46*a26);
  a43=(a43+a46);
  a47=(a47*a35);
  a43=(a43+a47);
  a43=(a00+a43);
  a47=(a14-a43);
  a47=(a47+a57);
  a47=sin(a47);
  a46=(a07*a47);
  a46=(a46/a13);
  a56=(a56+a46);
  a46=cos(a43);
  a46=(a16*a46);
  a43=sin(a43);
  a43=(a18*a43);
  a46=(a46-a43);
  a46=(a46*a21);
  a56=(a56+a46);
  a57=cos(a57);
  a46=(a57+a12);
  a46=(a17*a46);
  a46=(a23-a46);
  a46=(a46+a20);
  a46=(a46+a22);
  a43=(a56/a46);
  a57=(a57-a19);
  a57=(a19*a57);
  a46=(a57/a46);
  a44=casadi_sq(a42);
  a44=(a44*a58);
  a44=(a44-a47);
  a44=(a19*a44);
  a56=(a46*a56);
  a44=(a44-a56);
  a57=(a57*a46);
  a57=(a24-a57);
  a44=(a44/a57);
  a46=(a46*a44);
  a43=(a43-a46);
  a46=(a54*a43);
  a49=(a49+a46);
  a49=(a03+a49);
  a46=(a29*a49);
  a04=(a04+a46);
  a46=-1.5216094966251609e-01;
  a46=(a46*a02);
  a57=4.7766253643826434e-01;
  a57=(a57*a02);
  a56=(a57*a27);
  a47=-2.4881146199716677e+00;
  a47=(a47*a02);
  a58=(a47*a09);
  a56=(a56+a58);
  a58=-5.9029082683684297e-01;
  a58=(a58*a02);
  a38=(a58*a37);
  a56=(a56+a38);
  a38=2.1230051448181193e+01;
  a38=(a38*a02);
  a59=(a38*a06);
  a56=(a56+a59);
  a59=1.5279233632882423e+01;
  a59=(a59*a02);
  a60=(a59*a40);
  a56=(a56+a60);
  a60=-3.3288210968984863e+01;
  a60=(a60*a02);
  a61=(a60*a43);
  a56=(a56+a61);
  a61=-2.0331201708508627e-02;
  a61=(a61*a02);
  a62=(a50*a28);
  a63=(a31*a39);
  a62=(a62+a63);
  a63=(a51*a30);
  a62=(a62+a63);
  a63=(a52*a45);
  a62=(a62+a63);
  a63=(a53*a32);
  a62=(a62+a63);
  a63=(a54*a44);
  a62=(a62+a63);
  a62=(a08+a62);
  a63=(a07*a62);
  a64=(a50*a08);
  a65=(a31*a15);
  a64=(a64+a65);
  a65=(a51*a34);
  a64=(a64+a65);
  a65=(a52*a41);
  a64=(a64+a65);
  a65=(a53*a48);
  a64=(a64+a65);
  a65=(a54*a55);
  a64=(a64+a65);
  a64=(a10+a64);
  a65=sin(a64);
  a63=(a63*a65);
  a63=(a63/a13);
  a66=(2.*a49);
  a66=(a62-a66);
  a63=(a63*a66);
  a50=(a50*a03);
  a31=(a31*a33);
  a50=(a50+a31);
  a51=(a51*a36);
  a50=(a50+a51);
  a52=(a52*a26);
  a50=(a50+a52);
  a53=(a53*a35);
  a50=(a50+a53);
  a54=(a54*a42);
  a50=(a50+a54);
  a50=(a00+a50);
  a54=(a14-a50);
  a54=(a54+a64);
  a54=sin(a54);
  a53=(a07*a54);
  a53=(a53/a13);
  a63=(a63+a53);
  a53=cos(a50);
  a53=(a16*a53);
  a50=sin(a50);
  a50=(a18*a50);
  a53=(a53-a50);
  a53=(a53*a21);
  a63=(a63+a53);
  a64=cos(a64);
  a53=(a64+a12);
  a53=(a17*a53);
  a53=(a23-a53);
  a53=(a53+a20);
  a53=(a53+a22);
  a50=(a63/a53);
  a64=(a64-a19);
  a64=(a19*a64);
  a53=(a64/a53);
  a52=casadi_sq(a49);
  a52=(a52*a65);
  a52=(a52-a54);
  a52=(a19*a52);
  a63=(a53*a63);
  a52=(a52-a63);
  a64=(a64*a53);
  a64=(a24-a64);
  a52=(a52/a64);
  a53=(a53*a52);
  a50=(a50-a53);
  a53=(a61*a50);
  a56=(a56+a53);
  a56=(a03+a56);
  a53=(a46*a56);
  a04=(a04+a53);
  a53=2.0136540080403034e-01;
  a53=(a53*a02);
  a64=-9.3714243008598730e-01;
  a64=(a64*a02);
  a63=(a64*a27);
  a54=5.1863724288440638e+00;
  a54=(a54*a02);
  a65=(a54*a09);
  a63=(a63+a65);
  a65=1.0914373489967295e+00;
  a65=(a65*a02);
  a51=(a65*a37);
  a63=(a63+a51);
  a51=-8.1497870107469268e+00;
  a51=(a51*a02);
  a31=(a51*a06);
  a63=(a63+a31);
  a31=-1.8520065659996959e+01;
  a31=(a31*a02);
  a66=(a31*a40);
  a63=(a63+a66);
  a66=2.2739487099350505e+01;
  a66=(a66*a02);
  a67=(a66*a43);
  a63=(a63+a67);
  a67=2.4936055526796523e+00;
  a67=(a67*a02);
  a68=(a67*a50);
  a63=(a63+a68);
  a68=-3.0467644718982196e+00;
  a68=(a68*a02);
  a69=(a57*a28);
  a70=(a47*a39);
  a69=(a69+a70);
  a70=(a58*a30);
  a69=(a69+a70);
  a70=(a38*a45);
  a69=(a69+a70);
  a70=(a59*a32);
  a69=(a69+a70);
  a70=(a60*a44);
  a69=(a69+a70);
  a70=(a61*a52);
  a69=(a69+a70);
  a69=(a08+a69);
  a70=(a07*a69);
  a71=(a57*a08);
  a72=(a47*a15);
  a71=(a71+a72);
  a72=(a58*a34);
  a71=(a71+a72);
  a72=(a38*a41);
  a71=(a71+a72);
  a72=(a59*a48);
  a71=(a71+a72);
  a72=(a60*a55);
  a71=(a71+a72);
  a72=(a61*a62);
  a71=(a71+a72);
  a71=(a10+a71);
  a72=sin(a71);
  a70=(a70*a72);
  a70=(a70/a13);
  a73=(2.*a56);
  a73=(a69-a73);
  a70=(a70*a73);
  a57=(a57*a03);
  a47=(a47*a33);
  a57=(a57+a47);
  a58=(a58*a36);
  a57=(a57+a58);
  a38=(a38*a26);
  a57=(a57+a38);
  a59=(a59*a35);
  a57=(a57+a59);
  a60=(a60*a42);
  a57=(a57+a60);
  a61=(a61*a49);
  a57=(a57+a61);
  a57=(a00+a57);
  a61=(a14-a57);
  a61=(a61+a71);
  a61=sin(a61);
  a60=(a07*a61);
  a60=(a60/a13);
  a70=(a70+a60);
  a60=cos(a57);
  a60=(a16*a60);
  a57=sin(a57);
  a57=(a18*a57);
  a60=(a60-a57);
  a60=(a60*a21);
  a70=(a70+a60);
  a71=cos(a71);
  a60=(a71+a12);
  a60=(a17*a60);
  a60=(a23-a60);
  a60=(a60+a20);
  a60=(a60+a22);
  a57=(a70/a60);
  a71=(a71-a19);
  a71=(a19*a71);
  a60=(a71/a60);
  a59=casadi_sq(a56);
  a59=(a59*a72);
  a59=(a59-a61);
  a59=(a19*a59);
  a70=(a60*a70);
  a59=(a59-a70);
  a71=(a71*a60);
  a71=(a24-a71);
  a59=(a59/a71);
  a60=(a60*a59);
  a57=(a57-a60);
  a60=(a68*a57);
  a63=(a63+a60);
  a63=(a03+a63);
  a60=(a53*a63);
  a04=(a04+a60);
  a60=4.4710615727772587e-02;
  a60=(a60*a02);
  a71=2.2733101475165380e+00;
  a71=(a71*a02);
  a70=(a71*a27);
  a61=-1.0534495466737249e+01;
  a61=(a61*a02);
  a09=(a61*a09);
  a70=(a70+a09);
  a09=-2.0008720582248625e+00;
  a09=(a09*a02);
  a37=(a09*a37);
  a70=(a70+a37);
  a37=-1.7958931863118799e+01;
  a37=(a37*a02);
  a72=(a37*a06);
  a70=(a70+a72);
  a72=2.7948884529419960e+01;
  a72=(a72*a02);
  a38=(a72*a40);
  a70=(a70+a38);
  a38=-2.8589982771350235e+00;
  a38=(a38*a02);
  a58=(a38*a43);
  a70=(a70+a58);
  a58=-8.8728569335306293e+00;
  a58=(a58*a02);
  a47=(a58*a50);
  a70=(a70+a47);
  a47=1.2360567175794303e+01;
  a47=(a47*a02);
  a73=(a47*a57);
  a70=(a70+a73);
  a73=6.4339274601576357e-01;
  a73=(a73*a02);
  a02=(a64*a28);
  a74=(a54*a39);
  a02=(a02+a74);
  a74=(a65*a30);
  a02=(a02+a74);
  a74=(a51*a45);
  a02=(a02+a74);
  a74=(a31*a32);
  a02=(a02+a74);
  a74=(a66*a44);
  a02=(a02+a74);
  a74=(a67*a52);
  a02=(a02+a74);
  a74=(a68*a59);
  a02=(a02+a74);
  a02=(a08+a02);
  a74=(a07*a02);
  a75=(a64*a08);
  a76=(a54*a15);
  a75=(a75+a76);
  a76=(a65*a34);
  a75=(a75+a76);
  a76=(a51*a41);
  a75=(a75+a76);
  a76=(a31*a48);
  a75=(a75+a76);
  a76=(a66*a55);
  a75=(a75+a76);
  a76=(a67*a62);
  a75=(a75+a76);
  a76=(a68*a69);
  a75=(a75+a76);
  a75=(a10+a75);
  a76=sin(a75);
  a74=(a74*a76);
  a74=(a74/a13);
  a77=(2.*a63);
  a77=(a02-a77);
  a74=(a74*a77);
  a64=(a64*a03);
  a54=(a54*a33);
  a64=(a64+a54);
  a65=(a65*a36);
  a64=(a64+a65);
  a51=(a51*a26);
  a64=(a64+a51);
  a31=(a31*a35);
  a64=(a64+a31);
  a66=(a66*a42);
  a64=(a64+a66);
  a67=(a67*a49);
  a64=(a64+a67);
  a68=(a68*a56);
  a64=(a64+a68);
  a64=(a00+a64);
  a68=(a14-a64);
  a68=(a68+a75);
  a68=sin(a68);
  a67=(a07*a68);
  a67=(a67/a13);
  a74=(a74+a67);
  a67=cos(a64);
  a67=(a16*a67);
  a64=sin(a64);
  a64=(a18*a64);
  a67=(a67-a64);
  a67=(a67*a21);
  a74=(a74+a67);
  a75=cos(a75);
  a67=(a75+a12);
  a67=(a17*a67);
  a67=(a23-a67);
  a67=(a67+a20);
  a67=(a67+a22);
  a64=(a74/a67);
  a75=(a75-a19);
  a75=(a19*a75);
  a67=(a75/a67);
  a66=casadi_sq(a63);
  a66=(a66*a76);
  a66=(a66-a68);
  a66=(a19*a66);
  a74=(a67*a74);
  a66=(a66-a74);
  a75=(a75*a67);
  a75=(a24-a75);
  a66=(a66/a75);
  a67=(a67*a66);
  a64=(a64-a67);
  a67=(a73*a64);
  a70=(a70+a67);
  a70=(a03+a70);
  a67=(a60*a70);
  a04=(a04+a67);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a67=(a05*a41);
  a04=(a04+a67);
  a67=(a11*a48);
  a04=(a04+a67);
  a67=(a25*a55);
  a04=(a04+a67);
  a67=(a29*a62);
  a04=(a04+a67);
  a67=(a46*a69);
  a04=(a04+a67);
  a67=(a53*a02);
  a04=(a04+a67);
  a67=(a71*a28);
  a39=(a61*a39);
  a67=(a67+a39);
  a30=(a09*a30);
  a67=(a67+a30);
  a30=(a37*a45);
  a67=(a67+a30);
  a30=(a72*a32);
  a67=(a67+a30);
  a30=(a38*a44);
  a67=(a67+a30);
  a30=(a58*a52);
  a67=(a67+a30);
  a30=(a47*a59);
  a67=(a67+a30);
  a30=(a73*a66);
  a67=(a67+a30);
  a67=(a08+a67);
  a30=(a60*a67);
  a04=(a04+a30);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a27=(a01*a27);
  a06=(a05*a06);
  a27=(a27+a06);
  a40=(a11*a40);
  a27=(a27+a40);
  a43=(a25*a43);
  a27=(a27+a43);
  a50=(a29*a50);
  a27=(a27+a50);
  a57=(a46*a57);
  a27=(a27+a57);
  a64=(a53*a64);
  a27=(a27+a64);
  a64=(a07*a67);
  a57=(a71*a08);
  a15=(a61*a15);
  a57=(a57+a15);
  a34=(a09*a34);
  a57=(a57+a34);
  a41=(a37*a41);
  a57=(a57+a41);
  a48=(a72*a48);
  a57=(a57+a48);
  a55=(a38*a55);
  a57=(a57+a55);
  a62=(a58*a62);
  a57=(a57+a62);
  a69=(a47*a69);
  a57=(a57+a69);
  a02=(a73*a02);
  a57=(a57+a02);
  a10=(a10+a57);
  a57=sin(a10);
  a64=(a64*a57);
  a64=(a64/a13);
  a02=(2.*a70);
  a67=(a67-a02);
  a64=(a64*a67);
  a71=(a71*a03);
  a61=(a61*a33);
  a71=(a71+a61);
  a09=(a09*a36);
  a71=(a71+a09);
  a37=(a37*a26);
  a71=(a71+a37);
  a72=(a72*a35);
  a71=(a71+a72);
  a38=(a38*a42);
  a71=(a71+a38);
  a58=(a58*a49);
  a71=(a71+a58);
  a47=(a47*a56);
  a71=(a71+a47);
  a73=(a73*a63);
  a71=(a71+a73);
  a00=(a00+a71);
  a14=(a14-a00);
  a14=(a14+a10);
  a14=sin(a14);
  a07=(a07*a14);
  a07=(a07/a13);
  a64=(a64+a07);
  a07=cos(a00);
  a16=(a16*a07);
  a00=sin(a00);
  a18=(a18*a00);
  a16=(a16-a18);
  a16=(a16*a21);
  a64=(a64+a16);
  a10=cos(a10);
  a12=(a10+a12);
  a17=(a17*a12);
  a23=(a23-a17);
  a23=(a23+a20);
  a23=(a23+a22);
  a22=(a64/a23);
  a10=(a10-a19);
  a10=(a19*a10);
  a23=(a10/a23);
  a70=casadi_sq(a70);
  a70=(a70*a57);
  a70=(a70-a14);
  a19=(a19*a70);
  a64=(a23*a64);
  a19=(a19-a64);
  a10=(a10*a23);
  a24=(a24-a10);
  a19=(a19/a24);
  a23=(a23*a19);
  a22=(a22-a23);
  a22=(a60*a22);
  a27=(a27+a22);
  a03=(a03+a27);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a28);
  a05=(a05*a45);
  a01=(a01+a05);
  a11=(a11*a32);
  a01=(a01+a11);
  a25=(a25*a44);
  a01=(a01+a25);
  a29=(a29*a52);
  a01=(a01+a29);
  a46=(a46*a59);
  a01=(a01+a46);
  a53=(a53*a66);
  a01=(a01+a53);
  a60=(a60*a19);
  a01=(a01+a60);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p[3])->(y_end[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+78, w1, *w2=w+82, *w3=w+85, w5, *w6=w+87, w7;
  const casadi_real **arg1=arg+5, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w2);
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

/* landing:(y[4],z[3],p[3])->(R[4]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00-a01);
  a03=arg[1]? arg[1][0] : 0;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=cos(a01);
  a03=arg[0]? arg[0][2] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][0] : 0;
  a04=(a04*a05);
  a06=arg[2]? arg[2][1] : 0;
  a07=1.;
  a08=(a06+a07);
  a09=(a06/a08);
  a10=(2.*a02);
  a10=(a10*a03);
  a11=(2.*a03);
  a12=arg[0]? arg[0][3] : 0;
  a11=(a11-a12);
  a12=(a10+a11);
  a12=(a09*a12);
  a04=(a04-a12);
  a12=casadi_sq(a06);
  a13=(2.*a06);
  a14=(a12+a13);
  a14=(a14+a07);
  a14=(a12/a14);
  a11=(a14*a11);
  a04=(a04+a11);
  a04=(a04+a10);
  a13=(a13/a08);
  a07=(a02+a07);
  a13=(a13*a07);
  a05=(a05-a13);
  a14=(2.*a14);
  a05=(a05+a14);
  a14=2.;
  a05=(a05+a14);
  a14=(a04/a05);
  a02=(a02-a09);
  a09=(a09*a02);
  a05=(a09/a05);
  a06=(a06*a03);
  a08=casadi_sq(a08);
  a06=(a06/a08);
  a04=(a05*a04);
  a06=(a06-a04);
  a12=(a12/a08);
  a09=(a09*a05);
  a12=(a12-a09);
  a06=(a06/a12);
  a05=(a05*a06);
  a14=(a14-a05);
  a05=arg[1]? arg[1][1] : 0;
  a14=(a14-a05);
  if (res[0]!=0) res[0][1]=a14;
  a14=arg[1]? arg[1][2] : 0;
  a06=(a06-a14);
  if (res[0]!=0) res[0][2]=a06;
  a00=(2.*a00);
  a01=(a01-a00);
  if (res[0]!=0) res[0][3]=a01;
  return 0;
}

/* goswami_compass_residual_12:(u[4],p[3])->(R[4]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* goswami_compass_search_12:(u0[4],p[3])->(u[4],R[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+538, *w1=w+542, *w2=w+545;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = goswami_compass_residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 549;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 549*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_24:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* scaled_jacobian_24:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+420, *w1=w+436, *w2=w+440, *w3=w+443, *w4=w+459;
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
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, @4} = goswami_compass_jacobian_24(@1, @2) */
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

/* newton_24:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_24:(i0[4],i1[3])->(o0[4]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+527, *w1=w+531, *w2=w+534;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f17(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_residual_24:(u[4],p[3])->(R[4]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* goswami_compass_search_24:(u0[4],p[3])->(u[4],R[4]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+538, *w1=w+542, *w2=w+545;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = goswami_compass_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 549;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 549*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_48:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* scaled_jacobian_48:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+420, *w1=w+436, *w2=w+440, *w3=w+443, *w4=w+459;
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
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, @4} = goswami_compass_jacobian_48(@1, @2) */
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

/* newton_48:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_48:(i0[4],i1[3])->(o0[4]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+527, *w1=w+531, *w2=w+534;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f23(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_residual_48:(u[4],p[3])->(R[4]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* goswami_compass_search_48:(u0[4],p[3])->(u[4],R[4]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+538, *w1=w+542, *w2=w+545;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = goswami_compass_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 549;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 549*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_24:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_24:(i0[4],i1[3])->(o0[4]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f29(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_limit_cycle_24:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_24(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_36:(u[4],p[3])->(R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_36:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f37(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_36:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_36:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_36:(i0[4],i1[3])->(o0[4]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_36:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_36:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_36(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_48:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_48:(i0[4],i1[3])->(o0[4]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_limit_cycle_48:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_48(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_72:(u[4],p[3])->(R[4]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_72:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f49(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_72:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_72:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_72:(i0[4],i1[3])->(o0[4]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_72:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_72:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_72(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_96:(u[4],p[3])->(R[4]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_96:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_96:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_96:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_96:(i0[4],i1[3])->(o0[4]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_96:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_96:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f52(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_96(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_144:(u[4],p[3])->(R[4]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_144:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_144:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_144:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_144:(i0[4],i1[3])->(o0[4]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_144:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_144:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f59(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_144(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f58(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_192:(u[4],p[3])->(R[4]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_192:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f70(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_192:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_192:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_192:(i0[4],i1[3])->(o0[4]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f67(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_192:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_192:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_192(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f65(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_288:(u[4],p[3])->(R[4]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_288:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_288:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_288:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_288:(i0[4],i1[3])->(o0[4]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f74(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_288:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_288:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f73(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_288(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_384:(u[4],p[3])->(R[4]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+118, *w1=w+122, *w2=w+125, *w3=w+128, w4, w5, w6, *w7=w+132;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

/* coarse_jacobian_384:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+420, *w1=w+424, *w2=w+427, *w3=w+443;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = goswami_compass_jacobian_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = goswami_compass_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f84(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_384:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+447, *w1=w+463, *w2=w+467, *w3=w+470, *w4=w+486;
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
  casadi_copy(arg[1], 3, w2);
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

/* newton_384:(u0[4],p[3])->(u[4]) */
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

/* scaled_newton_384:(i0[4],i1[3])->(o0[4]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+554, *w1=w+558, *w2=w+561;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f81(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* goswami_compass_jacobian_384:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+335, *w01=w+339, *w02=w+342, *w03=w+345, *w04=w+349, *w05=w+361, w06, w07, w08, *w09=w+377;
  casadi_real *w10=w+401;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
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

/* goswami_compass_limit_cycle_384:(u0[4],p[3])->(u[4],J[4x4],R[4]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+565, *w1=w+569, *w2=w+572, *w3=w+576;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = scaled_newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f80(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = goswami_compass_jacobian_384(@2, @1) */
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

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f79(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 592;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 592*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_12_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_24_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_36_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f26(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_48_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f49(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_72_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_96_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f63(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_144_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_192_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f77(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_288_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_residual_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_residual_384_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_residual_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_residual_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_residual_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 156;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 156*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f38(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_36_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f25(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_72_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_96_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f64(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_144_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_192_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f78(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_288_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_384_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 417;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 417*sizeof(casadi_real);
  return 0;
}

/* start_along:(z[3],p[3],d[3])->(y[4x5]) */
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

/* step_along:(y[4x5],phase[2],turns[2x12],h,p[3],t,d[3])->(y_end[4x5]) */
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
  casadi_real a432, a433, a434, a435, a436, a437, a438, a439, a440, a441, a442, a443;
  casadi_real a444, a445, a446, a447;
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
  a012=1.;
  a013=(a007+a012);
  a009=(a009/a013);
  a014=(2.*a003);
  a014=(a008-a014);
  a015=(a009*a014);
  a016=arg[4]? arg[4][2] : 0;
  a017=(a016-a000);
  a017=(a017+a010);
  a018=sin(a017);
  a019=(a007*a018);
  a019=(a019/a013);
  a015=(a015+a019);
  a020=sin(a016);
  a021=cos(a000);
  a022=(a020*a021);
  a023=cos(a016);
  a024=sin(a000);
  a025=(a023*a024);
  a022=(a022-a025);
  a025=(a007/a013);
  a026=arg[4]? arg[4][0] : 0;
  a027=(a025-a026);
  a028=2.;
  a027=(a027-a028);
  a029=(a022*a027);
  a015=(a015+a029);
  a029=(2.*a007);
  a030=(a029*a007);
  a031=casadi_sq(a007);
  a032=(a031+a029);
  a032=(a032+a012);
  a030=(a030/a032);
  a033=(a029/a013);
  a034=cos(a010);
  a035=(a034+a012);
  a036=(a033*a035);
  a037=(a030-a036);
  a037=(a037+a026);
  a037=(a037+a028);
  a038=(a015/a037);
  a039=(a034-a025);
  a040=(a025*a039);
  a041=(a040/a037);
  a042=casadi_sq(a003);
  a042=(a042*a011);
  a042=(a042-a018);
  a043=(a025*a042);
  a044=(a041*a015);
  a044=(a043-a044);
  a045=casadi_sq(a013);
  a031=(a031/a045);
  a046=(a040*a041);
  a046=(a031-a046);
  a044=(a044/a046);
  a047=(a041*a044);
  a047=(a038-a047);
  a048=(a006*a047);
  a049=1.7082860872947386e-01;
  a049=(a049*a002);
  a050=2.9587585476806851e-02;
  a050=(a050*a002);
  a051=(a050*a044);
  a052=8.8762756430420545e-02;
  a052=(a052*a002);
  a053=1.9725056984537900e-02;
  a053=(a053*a002);
  a054=(a053*a047);
  a055=5.9175170953613701e-02;
  a055=(a055*a002);
  a056=5.2600151958767730e-02;
  a056=(a056*a002);
  a057=(a056*a044);
  a057=(a008+a057);
  a058=(a007*a057);
  a059=(a056*a008);
  a059=(a010+a059);
  a060=sin(a059);
  a058=(a058*a060);
  a058=(a058/a013);
  a061=(a056*a047);
  a061=(a003+a061);
  a062=(2.*a061);
  a062=(a057-a062);
  a063=(a058*a062);
  a064=(a056*a003);
  a064=(a000+a064);
  a065=(a016-a064);
  a065=(a065+a059);
  a066=sin(a065);
  a067=(a007*a066);
  a067=(a067/a013);
  a063=(a063+a067);
  a068=cos(a064);
  a069=(a020*a068);
  a064=sin(a064);
  a070=(a023*a064);
  a069=(a069-a070);
  a070=(a069*a027);
  a063=(a063+a070);
  a059=cos(a059);
  a070=(a059+a012);
  a071=(a033*a070);
  a072=(a030-a071);
  a072=(a072+a026);
  a072=(a072+a028);
  a073=(a063/a072);
  a074=(a059-a025);
  a075=(a025*a074);
  a076=(a075/a072);
  a077=casadi_sq(a061);
  a077=(a077*a060);
  a077=(a077-a066);
  a078=(a025*a077);
  a079=(a076*a063);
  a079=(a078-a079);
  a080=(a075*a076);
  a080=(a031-a080);
  a079=(a079/a080);
  a081=(a076*a079);
  a081=(a073-a081);
  a081=(a055*a081);
  a054=(a054+a081);
  a054=(a003+a054);
  a081=casadi_sq(a054);
  a082=(a053*a008);
  a083=(a055*a057);
  a082=(a082+a083);
  a082=(a010+a082);
  a083=sin(a082);
  a081=(a081*a083);
  a084=(a053*a003);
  a085=(a055*a061);
  a084=(a084+a085);
  a084=(a000+a084);
  a085=(a016-a084);
  a085=(a085+a082);
  a086=sin(a085);
  a081=(a081-a086);
  a087=(a025*a081);
  a082=cos(a082);
  a088=(a082-a025);
  a089=(a025*a088);
  a090=(a082+a012);
  a091=(a033*a090);
  a092=(a030-a091);
  a092=(a092+a026);
  a092=(a092+a028);
  a093=(a089/a092);
  a094=(a053*a044);
  a095=(a055*a079);
  a094=(a094+a095);
  a094=(a008+a094);
  a095=(a007*a094);
  a095=(a095*a083);
  a095=(a095/a013);
  a096=(2.*a054);
  a096=(a094-a096);
  a097=(a095*a096);
  a098=(a007*a086);
  a098=(a098/a013);
  a097=(a097+a098);
  a099=cos(a084);
  a100=(a020*a099);
  a084=sin(a084);
  a101=(a023*a084);
  a100=(a100-a101);
  a101=(a100*a027);
  a097=(a097+a101);
  a101=(a093*a097);
  a101=(a087-a101);
  a102=(a089*a093);
  a102=(a031-a102);
  a101=(a101/a102);
  a103=(a052*a101);
  a051=(a051+a103);
  a051=(a008+a051);
  a103=(a007*a051);
  a104=(a050*a008);
  a105=(a052*a094);
  a104=(a104+a105);
  a104=(a010+a104);
  a105=sin(a104);
  a103=(a103*a105);
  a103=(a103/a013);
  a106=(a050*a047);
  a107=(a097/a092);
  a108=(a093*a101);
  a108=(a107-a108);
  a109=(a052*a108);
  a106=(a106+a109);
  a106=(a003+a106);
  a109=(2.*a106);
  a109=(a051-a109);
  a110=(a103*a109);
  a111=(a050*a003);
  a112=(a052*a054);
  a111=(a111+a112);
  a111=(a000+a111);
  a112=(a016-a111);
  a112=(a112+a104);
  a113=sin(a112);
  a114=(a007*a113);
  a114=(a114/a013);
  a110=(a110+a114);
  a115=cos(a111);
  a116=(a020*a115);
  a111=sin(a111);
  a117=(a023*a111);
  a116=(a116-a117);
  a117=(a116*a027);
  a110=(a110+a117);
  a104=cos(a104);
  a117=(a104+a012);
  a118=(a033*a117);
  a119=(a030-a118);
  a119=(a119+a026);
  a119=(a119+a028);
  a120=(a110/a119);
  a121=(a104-a025);
  a122=(a025*a121);
  a123=(a122/a119);
  a124=casadi_sq(a106);
  a124=(a124*a105);
  a124=(a124-a113);
  a125=(a025*a124);
  a126=(a123*a110);
  a126=(a125-a126);
  a127=(a122*a123);
  a127=(a031-a127);
  a126=(a126/a127);
  a128=(a123*a126);
  a128=(a120-a128);
  a129=(a049*a128);
  a048=(a048+a129);
  a129=1.2546768756682242e-01;
  a129=(a129*a002);
  a130=2.4136513415926669e-01;
  a130=(a130*a002);
  a131=(a130*a044);
  a132=-8.8454947932828609e-01;
  a132=(a132*a002);
  a133=(a132*a101);
  a131=(a131+a133);
  a133=9.2483400326179199e-01;
  a133=(a133*a002);
  a134=(a133*a126);
  a131=(a131+a134);
  a131=(a008+a131);
  a134=(a007*a131);
  a135=(a130*a008);
  a136=(a132*a094);
  a135=(a135+a136);
  a136=(a133*a051);
  a135=(a135+a136);
  a135=(a010+a135);
  a136=sin(a135);
  a134=(a134*a136);
  a134=(a134/a013);
  a137=(a130*a047);
  a108=(a132*a108);
  a137=(a137+a108);
  a108=(a133*a128);
  a137=(a137+a108);
  a137=(a003+a137);
  a108=(2.*a137);
  a108=(a131-a108);
  a138=(a134*a108);
  a139=(a130*a003);
  a140=(a132*a054);
  a139=(a139+a140);
  a140=(a133*a106);
  a139=(a139+a140);
  a139=(a000+a139);
  a140=(a016-a139);
  a140=(a140+a135);
  a141=sin(a140);
  a142=(a007*a141);
  a142=(a142/a013);
  a138=(a138+a142);
  a143=cos(a139);
  a144=(a020*a143);
  a139=sin(a139);
  a145=(a023*a139);
  a144=(a144-a145);
  a145=(a144*a027);
  a138=(a138+a145);
  a135=cos(a135);
  a145=(a135+a012);
  a146=(a033*a145);
  a147=(a030-a146);
  a147=(a147+a026);
  a147=(a147+a028);
  a148=(a138/a147);
  a149=(a135-a025);
  a150=(a025*a149);
  a151=(a150/a147);
  a152=casadi_sq(a137);
  a152=(a152*a136);
  a152=(a152-a141);
  a153=(a025*a152);
  a154=(a151*a138);
  a154=(a153-a154);
  a155=(a150*a151);
  a155=(a031-a155);
  a154=(a154/a155);
  a156=(a151*a154);
  a156=(a148-a156);
  a157=(a129*a156);
  a048=(a048+a157);
  a048=(a003+a048);
  a157=(a005*a048);
  a004=(a004+a157);
  a157=1.8915178993145003e+00;
  a157=(a157*a002);
  a158=3.7109375000000000e-02;
  a158=(a158*a002);
  a159=(a158*a047);
  a160=1.7025221101954405e-01;
  a160=(a160*a002);
  a161=(a160*a128);
  a159=(a159+a161);
  a161=6.0216538980455959e-02;
  a161=(a161*a002);
  a162=(a161*a156);
  a159=(a159+a162);
  a162=-1.7578125000000000e-02;
  a162=(a162*a002);
  a163=(a006*a044);
  a164=(a049*a126);
  a163=(a163+a164);
  a164=(a129*a154);
  a163=(a163+a164);
  a163=(a008+a163);
  a164=(a007*a163);
  a165=(a006*a008);
  a166=(a049*a051);
  a165=(a165+a166);
  a166=(a129*a131);
  a165=(a165+a166);
  a165=(a010+a165);
  a166=sin(a165);
  a164=(a164*a166);
  a164=(a164/a013);
  a167=(2.*a048);
  a167=(a163-a167);
  a168=(a164*a167);
  a169=(a006*a003);
  a170=(a049*a106);
  a169=(a169+a170);
  a170=(a129*a137);
  a169=(a169+a170);
  a169=(a000+a169);
  a170=(a016-a169);
  a170=(a170+a165);
  a171=sin(a170);
  a172=(a007*a171);
  a172=(a172/a013);
  a168=(a168+a172);
  a173=cos(a169);
  a174=(a020*a173);
  a169=sin(a169);
  a175=(a023*a169);
  a174=(a174-a175);
  a175=(a174*a027);
  a168=(a168+a175);
  a165=cos(a165);
  a175=(a165+a012);
  a176=(a033*a175);
  a177=(a030-a176);
  a177=(a177+a026);
  a177=(a177+a028);
  a178=(a168/a177);
  a179=(a165-a025);
  a180=(a025*a179);
  a181=(a180/a177);
  a182=casadi_sq(a048);
  a182=(a182*a166);
  a182=(a182-a171);
  a183=(a025*a182);
  a184=(a181*a168);
  a184=(a183-a184);
  a185=(a180*a181);
  a185=(a031-a185);
  a184=(a184/a185);
  a186=(a181*a184);
  a186=(a178-a186);
  a187=(a162*a186);
  a159=(a159+a187);
  a159=(a003+a159);
  a187=(a157*a159);
  a004=(a004+a187);
  a187=-5.8012039600105849e+00;
  a187=(a187*a002);
  a188=3.7092000118504789e-02;
  a188=(a188*a002);
  a189=(a188*a047);
  a190=1.7038392571223998e-01;
  a190=(a190*a002);
  a191=(a190*a128);
  a189=(a189+a191);
  a191=1.0726203044637328e-01;
  a191=(a191*a002);
  a192=(a191*a156);
  a189=(a189+a192);
  a192=-1.5319437748624402e-02;
  a192=(a192*a002);
  a193=(a192*a186);
  a189=(a189+a193);
  a193=8.2737891638140233e-03;
  a193=(a193*a002);
  a194=(a158*a044);
  a195=(a160*a126);
  a194=(a194+a195);
  a195=(a161*a154);
  a194=(a194+a195);
  a195=(a162*a184);
  a194=(a194+a195);
  a194=(a008+a194);
  a195=(a007*a194);
  a196=(a158*a008);
  a197=(a160*a051);
  a196=(a196+a197);
  a197=(a161*a131);
  a196=(a196+a197);
  a197=(a162*a163);
  a196=(a196+a197);
  a196=(a010+a196);
  a197=sin(a196);
  a195=(a195*a197);
  a195=(a195/a013);
  a198=(2.*a159);
  a198=(a194-a198);
  a199=(a195*a198);
  a200=(a158*a003);
  a201=(a160*a106);
  a200=(a200+a201);
  a201=(a161*a137);
  a200=(a200+a201);
  a201=(a162*a048);
  a200=(a200+a201);
  a200=(a000+a200);
  a201=(a016-a200);
  a201=(a201+a196);
  a202=sin(a201);
  a203=(a007*a202);
  a203=(a203/a013);
  a199=(a199+a203);
  a204=cos(a200);
  a205=(a020*a204);
  a200=sin(a200);
  a206=(a023*a200);
  a205=(a205-a206);
  a206=(a205*a027);
  a199=(a199+a206);
  a196=cos(a196);
  a206=(a196+a012);
  a207=(a033*a206);
  a208=(a030-a207);
  a208=(a208+a026);
  a208=(a208+a028);
  a209=(a199/a208);
  a210=(a196-a025);
  a211=(a025*a210);
  a212=(a211/a208);
  a213=casadi_sq(a159);
  a213=(a213*a197);
  a213=(a213-a202);
  a214=(a025*a213);
  a215=(a212*a199);
  a215=(a214-a215);
  a216=(a211*a212);
  a216=(a031-a216);
  a215=(a215/a216);
  a217=(a212*a215);
  a217=(a209-a217);
  a218=(a193*a217);
  a189=(a189+a218);
  a189=(a003+a189);
  a218=(a187*a189);
  a004=(a004+a218);
  a218=3.1116436695781990e-01;
  a218=(a218*a002);
  a219=6.2411095871607569e-01;
  a219=(a219*a002);
  a220=(a219*a047);
  a221=-3.3608926294469414e+00;
  a221=(a221*a002);
  a222=(a221*a128);
  a220=(a220+a222);
  a222=-8.6821934684172597e-01;
  a222=(a222*a002);
  a223=(a222*a156);
  a220=(a220+a223);
  a223=2.7592099699446710e+01;
  a223=(a223*a002);
  a224=(a223*a186);
  a220=(a220+a224);
  a224=2.0154067550477894e+01;
  a224=(a224*a002);
  a225=(a224*a217);
  a220=(a220+a225);
  a225=-4.3489884181069961e+01;
  a225=(a225*a002);
  a226=(a188*a044);
  a227=(a190*a126);
  a226=(a226+a227);
  a227=(a191*a154);
  a226=(a226+a227);
  a227=(a192*a184);
  a226=(a226+a227);
  a227=(a193*a215);
  a226=(a226+a227);
  a226=(a008+a226);
  a227=(a007*a226);
  a228=(a188*a008);
  a229=(a190*a051);
  a228=(a228+a229);
  a229=(a191*a131);
  a228=(a228+a229);
  a229=(a192*a163);
  a228=(a228+a229);
  a229=(a193*a194);
  a228=(a228+a229);
  a228=(a010+a228);
  a229=sin(a228);
  a227=(a227*a229);
  a227=(a227/a013);
  a230=(2.*a189);
  a230=(a226-a230);
  a231=(a227*a230);
  a232=(a188*a003);
  a233=(a190*a106);
  a232=(a232+a233);
  a233=(a191*a137);
  a232=(a232+a233);
  a233=(a192*a048);
  a232=(a232+a233);
  a233=(a193*a159);
  a232=(a232+a233);
  a232=(a000+a232);
  a233=(a016-a232);
  a233=(a233+a228);
  a234=sin(a233);
  a235=(a007*a234);
  a235=(a235/a013);
  a231=(a231+a235);
  a236=cos(a232);
  a237=(a020*a236);
  a232=sin(a232);
  a238=(a023*a232);
  a237=(a237-a238);
  a238=(a237*a027);
  a231=(a231+a238);
  a228=cos(a228);
  a238=(a228+a012);
  a239=(a033*a238);
  a240=(a030-a239);
  a240=(a240+a026);
  a240=(a240+a028);
  a241=(a231/a240);
  a242=(a228-a025);
  a243=(a025*a242);
  a244=(a243/a240);
  a245=casadi_sq(a189);
  a245=(a245*a229);
  a245=(a245-a234);
  a246=(a025*a245);
  a247=(a244*a231);
  a247=(a246-a247);
  a248=(a243*a244);
  a248=(a031-a248);
  a247=(a247/a248);
  a249=(a244*a247);
  a249=(a241-a249);
  a250=(a225*a249);
  a220=(a220+a250);
  a220=(a003+a220);
  a250=(a218*a220);
  a004=(a004+a250);
  a250=-1.5216094966251609e-01;
  a250=(a250*a002);
  a251=4.7766253643826434e-01;
  a251=(a251*a002);
  a252=(a251*a047);
  a253=-2.4881146199716677e+00;
  a253=(a253*a002);
  a254=(a253*a128);
  a252=(a252+a254);
  a254=-5.9029082683684297e-01;
  a254=(a254*a002);
  a255=(a254*a156);
  a252=(a252+a255);
  a255=2.1230051448181193e+01;
  a255=(a255*a002);
  a256=(a255*a186);
  a252=(a252+a256);
  a256=1.5279233632882423e+01;
  a256=(a256*a002);
  a257=(a256*a217);
  a252=(a252+a257);
  a257=-3.3288210968984863e+01;
  a257=(a257*a002);
  a258=(a257*a249);
  a252=(a252+a258);
  a258=-2.0331201708508627e-02;
  a258=(a258*a002);
  a259=(a219*a044);
  a260=(a221*a126);
  a259=(a259+a260);
  a260=(a222*a154);
  a259=(a259+a260);
  a260=(a223*a184);
  a259=(a259+a260);
  a260=(a224*a215);
  a259=(a259+a260);
  a260=(a225*a247);
  a259=(a259+a260);
  a259=(a008+a259);
  a260=(a007*a259);
  a261=(a219*a008);
  a262=(a221*a051);
  a261=(a261+a262);
  a262=(a222*a131);
  a261=(a261+a262);
  a262=(a223*a163);
  a261=(a261+a262);
  a262=(a224*a194);
  a261=(a261+a262);
  a262=(a225*a226);
  a261=(a261+a262);
  a261=(a010+a261);
  a262=sin(a261);
  a260=(a260*a262);
  a260=(a260/a013);
  a263=(2.*a220);
  a263=(a259-a263);
  a264=(a260*a263);
  a265=(a219*a003);
  a266=(a221*a106);
  a265=(a265+a266);
  a266=(a222*a137);
  a265=(a265+a266);
  a266=(a223*a048);
  a265=(a265+a266);
  a266=(a224*a159);
  a265=(a265+a266);
  a266=(a225*a189);
  a265=(a265+a266);
  a265=(a000+a265);
  a266=(a016-a265);
  a266=(a266+a261);
  a267=sin(a266);
  a268=(a007*a267);
  a268=(a268/a013);
  a264=(a264+a268);
  a269=cos(a265);
  a270=(a020*a269);
  a265=sin(a265);
  a271=(a023*a265);
  a270=(a270-a271);
  a271=(a270*a027);
  a264=(a264+a271);
  a261=cos(a261);
  a271=(a261+a012);
  a272=(a033*a271);
  a273=(a030-a272);
  a273=(a273+a026);
  a273=(a273+a028);
  a274=(a264/a273);
  a275=(a261-a025);
  a276=(a025*a275);
  a277=(a276/a273);
  a278=casadi_sq(a220);
  a278=(a278*a262);
  a278=(a278-a267);
  a279=(a025*a278);
  a280=(a277*a264);
  a280=(a279-a280);
  a281=(a276*a277);
  a281=(a031-a281);
  a280=(a280/a281);
  a282=(a277*a280);
  a282=(a274-a282);
  a283=(a258*a282);
  a252=(a252+a283);
  a252=(a003+a252);
  a283=(a250*a252);
  a004=(a004+a283);
  a283=2.0136540080403034e-01;
  a283=(a283*a002);
  a284=-9.3714243008598730e-01;
  a284=(a284*a002);
  a285=(a284*a047);
  a286=5.1863724288440638e+00;
  a286=(a286*a002);
  a287=(a286*a128);
  a285=(a285+a287);
  a287=1.0914373489967295e+00;
  a287=(a287*a002);
  a288=(a287*a156);
  a285=(a285+a288);
  a288=-8.1497870107469268e+00;
  a288=(a288*a002);
  a289=(a288*a186);
  a285=(a285+a289);
  a289=-1.8520065659996959e+01;
  a289=(a289*a002);
  a290=(a289*a217);
  a285=(a285+a290);
  a290=2.2739487099350505e+01;
  a290=(a290*a002);
  a291=(a290*a249);
  a285=(a285+a291);
  a291=2.4936055526796523e+00;
  a291=(a291*a002);
  a292=(a291*a282);
  a285=(a285+a292);
  a292=-3.0467644718982196e+00;
  a292=(a292*a002);
  a293=(a251*a044);
  a294=(a253*a126);
  a293=(a293+a294);
  a294=(a254*a154);
  a293=(a293+a294);
  a294=(a255*a184);
  a293=(a293+a294);
  a294=(a256*a215);
  a293=(a293+a294);
  a294=(a257*a247);
  a293=(a293+a294);
  a294=(a258*a280);
  a293=(a293+a294);
  a293=(a008+a293);
  a294=(a007*a293);
  a295=(a251*a008);
  a296=(a253*a051);
  a295=(a295+a296);
  a296=(a254*a131);
  a295=(a295+a296);
  a296=(a255*a163);
  a295=(a295+a296);
  a296=(a256*a194);
  a295=(a295+a296);
  a296=(a257*a226);
  a295=(a295+a296);
  a296=(a258*a259);
  a295=(a295+a296);
  a295=(a010+a295);
  a296=sin(a295);
  a294=(a294*a296);
  a294=(a294/a013);
  a297=(2.*a252);
  a297=(a293-a297);
  a298=(a294*a297);
  a299=(a251*a003);
  a300=(a253*a106);
  a299=(a299+a300);
  a300=(a254*a137);
  a299=(a299+a300);
  a300=(a255*a048);
  a299=(a299+a300);
  a300=(a256*a159);
  a299=(a299+a300);
  a300=(a257*a189);
  a299=(a299+a300);
  a300=(a258*a220);
  a299=(a299+a300);
  a299=(a000+a299);
  a300=(a016-a299);
  a300=(a300+a295);
  a301=sin(a300);
  a302=(a007*a301);
  a302=(a302/a013);
  a298=(a298+a302);
  a303=cos(a299);
  a304=(a020*a303);
  a299=sin(a299);
  a305=(a023*a299);
  a304=(a304-a305);
  a305=(a304*a027);
  a298=(a298+a305);
  a295=cos(a295);
  a305=(a295+a012);
  a306=(a033*a305);
  a307=(a030-a306);
  a307=(a307+a026);
  a307=(a307+a028);
  a308=(a298/a307);
  a309=(a295-a025);
  a310=(a025*a309);
  a311=(a310/a307);
  a312=casadi_sq(a252);
  a312=(a312*a296);
  a312=(a312-a301);
  a313=(a025*a312);
  a314=(a311*a298);
  a314=(a313-a314);
  a315=(a310*a311);
  a315=(a031-a315);
  a314=(a314/a315);
  a316=(a311*a314);
  a316=(a308-a316);
  a317=(a292*a316);
  a285=(a285+a317);
  a285=(a003+a285);
  a317=(a283*a285);
  a004=(a004+a317);
  a317=4.4710615727772587e-02;
  a317=(a317*a002);
  a318=2.2733101475165380e+00;
  a318=(a318*a002);
  a319=(a318*a047);
  a320=-1.0534495466737249e+01;
  a320=(a320*a002);
  a128=(a320*a128);
  a319=(a319+a128);
  a128=-2.0008720582248625e+00;
  a128=(a128*a002);
  a156=(a128*a156);
  a319=(a319+a156);
  a156=-1.7958931863118799e+01;
  a156=(a156*a002);
  a321=(a156*a186);
  a319=(a319+a321);
  a321=2.7948884529419960e+01;
  a321=(a321*a002);
  a322=(a321*a217);
  a319=(a319+a322);
  a322=-2.8589982771350235e+00;
  a322=(a322*a002);
  a323=(a322*a249);
  a319=(a319+a323);
  a323=-8.8728569335306293e+00;
  a323=(a323*a002);
  a324=(a323*a282);
  a319=(a319+a324);
  a324=1.2360567175794303e+01;
  a324=(a324*a002);
  a325=(a324*a316);
  a319=(a319+a325);
  a325=6.4339274601576357e-01;
  a325=(a325*a002);
  a002=(a284*a044);
  a326=(a286*a126);
  a002=(a002+a326);
  a326=(a287*a154);
  a002=(a002+a326);
  a326=(a288*a184);
  a002=(a002+a326);
  a326=(a289*a215);
  a002=(a002+a326);
  a326=(a290*a247);
  a002=(a002+a326);
  a326=(a291*a280);
  a002=(a002+a326);
  a326=(a292*a314);
  a002=(a002+a326);
  a002=(a008+a002);
  a326=(a007*a002);
  a327=(a284*a008);
  a328=(a286*a051);
  a327=(a327+a328);
  a328=(a287*a131);
  a327=(a327+a328);
  a328=(a288*a163);
  a327=(a327+a328);
  a328=(a289*a194);
  a327=(a327+a328);
  a328=(a290*a226);
  a327=(a327+a328);
  a328=(a291*a259);
  a327=(a327+a328);
  a328=(a292*a293);
  a327=(a327+a328);
  a327=(a010+a327);
  a328=sin(a327);
  a326=(a326*a328);
  a326=(a326/a013);
  a329=(2.*a285);
  a329=(a002-a329);
  a330=(a326*a329);
  a331=(a284*a003);
  a332=(a286*a106);
  a331=(a331+a332);
  a332=(a287*a137);
  a331=(a331+a332);
  a332=(a288*a048);
  a331=(a331+a332);
  a332=(a289*a159);
  a331=(a331+a332);
  a332=(a290*a189);
  a331=(a331+a332);
  a332=(a291*a220);
  a331=(a331+a332);
  a332=(a292*a252);
  a331=(a331+a332);
  a331=(a000+a331);
  a332=(a016-a331);
  a332=(a332+a327);
  a333=sin(a332);
  a334=(a007*a333);
  a334=(a334/a013);
  a330=(a330+a334);
  a335=cos(a331);
  a336=(a020*a335);
  a331=sin(a331);
  a337=(a023*a331);
  a336=(a336-a337);
  a337=(a336*a027);
  a330=(a330+a337);
  a327=cos(a327);
  a337=(a327+a012);
  a338=(a033*a337);
  a339=(a030-a338);
  a339=(a339+a026);
  a339=(a339+a028);
  a340=(a330/a339);
  a341=(a327-a025);
  a342=(a025*a341);
  a343=(a342/a339);
  a344=casadi_sq(a285);
  a344=(a344*a328);
  a344=(a344-a333);
  a345=(a025*a344);
  a346=(a343*a330);
  a346=(a345-a346);
  a347=(a342*a343);
  a347=(a031-a347);
  a346=(a346/a347);
  a348=(a343*a346);
  a348=(a340-a348);
  a349=(a325*a348);
  a319=(a319+a349);
  a319=(a003+a319);
  a349=(a317*a319);
  a004=(a004+a349);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a349=(a005*a163);
  a004=(a004+a349);
  a349=(a157*a194);
  a004=(a004+a349);
  a349=(a187*a226);
  a004=(a004+a349);
  a349=(a218*a259);
  a004=(a004+a349);
  a349=(a250*a293);
  a004=(a004+a349);
  a349=(a283*a002);
  a004=(a004+a349);
  a349=(a318*a044);
  a350=(a320*a126);
  a349=(a349+a350);
  a350=(a128*a154);
  a349=(a349+a350);
  a350=(a156*a184);
  a349=(a349+a350);
  a350=(a321*a215);
  a349=(a349+a350);
  a350=(a322*a247);
  a349=(a349+a350);
  a350=(a323*a280);
  a349=(a349+a350);
  a350=(a324*a314);
  a349=(a349+a350);
  a350=(a325*a346);
  a349=(a349+a350);
  a349=(a008+a349);
  a350=(a317*a349);
  a004=(a004+a350);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a047=(a001*a047);
  a186=(a005*a186);
  a047=(a047+a186);
  a217=(a157*a217);
  a047=(a047+a217);
  a249=(a187*a249);
  a047=(a047+a249);
  a282=(a218*a282);
  a047=(a047+a282);
  a316=(a250*a316);
  a047=(a047+a316);
  a348=(a283*a348);
  a047=(a047+a348);
  a348=(a007*a349);
  a316=(a318*a008);
  a282=(a320*a051);
  a316=(a316+a282);
  a282=(a128*a131);
  a316=(a316+a282);
  a282=(a156*a163);
  a316=(a316+a282);
  a282=(a321*a194);
  a316=(a316+a282);
  a282=(a322*a226);
  a316=(a316+a282);
  a282=(a323*a259);
  a316=(a316+a282);
  a282=(a324*a293);
  a316=(a316+a282);
  a282=(a325*a002);
  a316=(a316+a282);
  a010=(a010+a316);
  a316=sin(a010);
  a348=(a348*a316);
  a348=(a348/a013);
  a282=(2.*a319);
  a282=(a349-a282);
  a249=(a348*a282);
  a217=(a318*a003);
  a186=(a320*a106);
  a217=(a217+a186);
  a186=(a128*a137);
  a217=(a217+a186);
  a186=(a156*a048);
  a217=(a217+a186);
  a186=(a321*a159);
  a217=(a217+a186);
  a186=(a322*a189);
  a217=(a217+a186);
  a186=(a323*a220);
  a217=(a217+a186);
  a186=(a324*a252);
  a217=(a217+a186);
  a186=(a325*a285);
  a217=(a217+a186);
  a000=(a000+a217);
  a016=(a016-a000);
  a016=(a016+a010);
  a217=sin(a016);
  a186=(a007*a217);
  a186=(a186/a013);
  a249=(a249+a186);
  a004=cos(a000);
  a350=(a020*a004);
  a000=sin(a000);
  a351=(a023*a000);
  a350=(a350-a351);
  a351=(a350*a027);
  a249=(a249+a351);
  a010=cos(a010);
  a012=(a010+a012);
  a351=(a033*a012);
  a352=(a030-a351);
  a352=(a352+a026);
  a352=(a352+a028);
  a353=(a249/a352);
  a354=(a010-a025);
  a355=(a025*a354);
  a356=(a355/a352);
  a357=casadi_sq(a319);
  a357=(a357*a316);
  a357=(a357-a217);
  a358=(a025*a357);
  a359=(a356*a249);
  a359=(a358-a359);
  a360=(a355*a356);
  a360=(a031-a360);
  a359=(a359/a360);
  a361=(a356*a359);
  a361=(a353-a361);
  a361=(a317*a361);
  a047=(a047+a361);
  a047=(a003+a047);
  if (res[0]!=0) res[0][2]=a047;
  a047=(a001*a044);
  a361=(a005*a184);
  a047=(a047+a361);
  a361=(a157*a215);
  a047=(a047+a361);
  a361=(a187*a247);
  a047=(a047+a361);
  a361=(a218*a280);
  a047=(a047+a361);
  a361=(a250*a314);
  a047=(a047+a361);
  a361=(a283*a346);
  a047=(a047+a361);
  a361=(a317*a359);
  a047=(a047+a361);
  a047=(a008+a047);
  if (res[0]!=0) res[0][3]=a047;
  a047=arg[0]? arg[0][4] : 0;
  a361=arg[0]? arg[0][6] : 0;
  a362=(a001*a361);
  a363=(a023*a021);
  a364=(a020*a024);
  a363=(a363+a364);
  a364=(a026-a025);
  a364=(a364+a028);
  a363=(a363*a364);
  a017=cos(a017);
  a365=(a007*a017);
  a365=(a365/a013);
  a363=(a363-a365);
  a366=(a363/a037);
  a363=(a041*a363);
  a365=(a365-a363);
  a365=(a365/a046);
  a363=(a041*a365);
  a366=(a366-a363);
  a363=(a366*a047);
  a367=(a008*a014);
  a368=(a034*a367);
  a368=(a017+a368);
  a369=(a007*a011);
  a369=(a369/a013);
  a369=(a369*a367);
  a369=(a019+a369);
  a367=(a022*a364);
  a369=(a369-a367);
  a367=(a041*a369);
  a043=(a043-a367);
  a043=(a043/a046);
  a369=(a369/a037);
  a367=(a041*a043);
  a369=(a369-a367);
  a367=(2.*a369);
  a043=(a043-a367);
  a043=(a011*a043);
  a368=(a368+a043);
  a368=(a025*a368);
  a043=(a368/a037);
  a369=(a369*a011);
  a369=(a369-a017);
  a034=(a034*a003);
  a034=(a034*a003);
  a369=(a369+a034);
  a369=(a025*a369);
  a368=(a041*a368);
  a369=(a369-a368);
  a369=(a369/a046);
  a368=(a041*a369);
  a043=(a043-a368);
  a368=arg[0]? arg[0][5] : 0;
  a034=(a043*a368);
  a363=(a363+a034);
  a034=(a011*a033);
  a367=(a008-a003);
  a034=(a034*a367);
  a026=(a030+a026);
  a036=(a026-a036);
  a036=(a036+a028);
  a367=(a034/a036);
  a370=(a040/a036);
  a034=(a370*a034);
  a371=(a040*a370);
  a371=(a031-a371);
  a034=(a034/a371);
  a372=(a370*a034);
  a367=(a367+a372);
  a372=arg[0]? arg[0][7] : 0;
  a373=(a367*a372);
  a374=(a008*a011);
  a374=(a374*a033);
  a036=(a374/a036);
  a003=(a003*a011);
  a003=(a003*a033);
  a374=(a370*a374);
  a003=(a003+a374);
  a003=(a003/a371);
  a370=(a370*a003);
  a036=(a036+a370);
  a370=(a036*a361);
  a373=(a373-a370);
  a363=(a363+a373);
  a373=(a006*a363);
  a370=(a023*a115);
  a371=(a020*a111);
  a370=(a370+a371);
  a370=(a370*a364);
  a112=cos(a112);
  a371=(a007*a112);
  a371=(a371/a013);
  a370=(a370-a371);
  a374=(a370/a119);
  a370=(a123*a370);
  a371=(a371-a370);
  a371=(a371/a127);
  a370=(a123*a371);
  a374=(a374-a370);
  a370=(a050*a361);
  a375=(a053*a363);
  a376=(a023*a068);
  a377=(a020*a064);
  a376=(a376+a377);
  a376=(a376*a364);
  a065=cos(a065);
  a377=(a007*a065);
  a377=(a377/a013);
  a376=(a376-a377);
  a378=(a376/a072);
  a376=(a076*a376);
  a377=(a377-a376);
  a377=(a377/a080);
  a376=(a076*a377);
  a378=(a378-a376);
  a376=(a056*a361);
  a376=(a047+a376);
  a379=(a378*a376);
  a380=(a057*a062);
  a381=(a059*a380);
  a381=(a065+a381);
  a382=(a007*a060);
  a382=(a382/a013);
  a382=(a382*a380);
  a382=(a067+a382);
  a380=(a069*a364);
  a382=(a382-a380);
  a380=(a076*a382);
  a078=(a078-a380);
  a078=(a078/a080);
  a382=(a382/a072);
  a380=(a076*a078);
  a382=(a382-a380);
  a380=(2.*a382);
  a078=(a078-a380);
  a078=(a060*a078);
  a381=(a381+a078);
  a381=(a025*a381);
  a078=(a381/a072);
  a382=(a382*a060);
  a382=(a382-a065);
  a059=(a059*a061);
  a059=(a059*a061);
  a382=(a382+a059);
  a382=(a025*a382);
  a381=(a076*a381);
  a382=(a382-a381);
  a382=(a382/a080);
  a381=(a076*a382);
  a078=(a078-a381);
  a381=(a056*a372);
  a381=(a368+a381);
  a059=(a078*a381);
  a379=(a379+a059);
  a059=(a060*a033);
  a380=(a057-a061);
  a059=(a059*a380);
  a071=(a026-a071);
  a071=(a071+a028);
  a380=(a059/a071);
  a383=(a075/a071);
  a059=(a383*a059);
  a384=(a075*a383);
  a384=(a031-a384);
  a059=(a059/a384);
  a385=(a383*a059);
  a380=(a380+a385);
  a385=(a365*a047);
  a386=(a369*a368);
  a385=(a385+a386);
  a386=(a003*a361);
  a387=(a034*a372);
  a386=(a386-a387);
  a385=(a385+a386);
  a386=(a056*a385);
  a386=(a372+a386);
  a387=(a380*a386);
  a388=(a057*a060);
  a388=(a388*a033);
  a071=(a388/a071);
  a061=(a061*a060);
  a061=(a061*a033);
  a388=(a383*a388);
  a061=(a061+a388);
  a061=(a061/a384);
  a383=(a383*a061);
  a071=(a071+a383);
  a383=(a056*a363);
  a383=(a361+a383);
  a384=(a071*a383);
  a387=(a387-a384);
  a379=(a379+a387);
  a379=(a055*a379);
  a375=(a375+a379);
  a375=(a361+a375);
  a379=(a052*a375);
  a370=(a370+a379);
  a370=(a047+a370);
  a379=(a374*a370);
  a387=(a051*a109);
  a384=(a104*a387);
  a384=(a112+a384);
  a388=(a007*a105);
  a388=(a388/a013);
  a388=(a388*a387);
  a388=(a114+a388);
  a387=(a116*a364);
  a388=(a388-a387);
  a387=(a123*a388);
  a125=(a125-a387);
  a125=(a125/a127);
  a388=(a388/a119);
  a387=(a123*a125);
  a388=(a388-a387);
  a387=(2.*a388);
  a125=(a125-a387);
  a125=(a105*a125);
  a384=(a384+a125);
  a384=(a025*a384);
  a125=(a384/a119);
  a388=(a388*a105);
  a388=(a388-a112);
  a104=(a104*a106);
  a104=(a104*a106);
  a388=(a388+a104);
  a388=(a025*a388);
  a384=(a123*a384);
  a388=(a388-a384);
  a388=(a388/a127);
  a384=(a123*a388);
  a125=(a125-a384);
  a384=(a050*a372);
  a104=(a053*a385);
  a376=(a377*a376);
  a381=(a382*a381);
  a376=(a376+a381);
  a381=(a061*a383);
  a387=(a059*a386);
  a381=(a381-a387);
  a376=(a376+a381);
  a376=(a055*a376);
  a104=(a104+a376);
  a104=(a372+a104);
  a376=(a052*a104);
  a384=(a384+a376);
  a384=(a368+a384);
  a376=(a125*a384);
  a379=(a379+a376);
  a376=(a105*a033);
  a381=(a051-a106);
  a376=(a376*a381);
  a118=(a026-a118);
  a118=(a118+a028);
  a381=(a376/a118);
  a387=(a122/a118);
  a376=(a387*a376);
  a389=(a122*a387);
  a389=(a031-a389);
  a376=(a376/a389);
  a390=(a387*a376);
  a381=(a381+a390);
  a390=(a050*a385);
  a085=cos(a085);
  a391=(a007*a085);
  a391=(a391/a013);
  a392=(a023*a099);
  a393=(a020*a084);
  a392=(a392+a393);
  a392=(a392*a364);
  a392=(a392-a391);
  a393=(a093*a392);
  a391=(a391-a393);
  a391=(a391/a102);
  a393=(a053*a361);
  a383=(a055*a383);
  a393=(a393+a383);
  a393=(a047+a393);
  a383=(a391*a393);
  a394=(a007*a083);
  a394=(a394/a013);
  a395=(a094*a096);
  a394=(a394*a395);
  a394=(a098+a394);
  a396=(a100*a364);
  a394=(a394-a396);
  a396=(a394/a092);
  a394=(a093*a394);
  a087=(a087-a394);
  a087=(a087/a102);
  a394=(a093*a087);
  a396=(a396-a394);
  a394=(a396*a083);
  a394=(a394-a085);
  a397=(a082*a054);
  a397=(a397*a054);
  a394=(a394+a397);
  a394=(a025*a394);
  a082=(a082*a395);
  a082=(a085+a082);
  a396=(2.*a396);
  a087=(a087-a396);
  a087=(a083*a087);
  a082=(a082+a087);
  a082=(a025*a082);
  a087=(a093*a082);
  a394=(a394-a087);
  a394=(a394/a102);
  a087=(a053*a372);
  a386=(a055*a386);
  a087=(a087+a386);
  a087=(a368+a087);
  a386=(a394*a087);
  a383=(a383+a386);
  a386=(a054*a083);
  a386=(a386*a033);
  a091=(a026-a091);
  a091=(a091+a028);
  a396=(a089/a091);
  a395=(a094*a083);
  a395=(a395*a033);
  a397=(a396*a395);
  a386=(a386+a397);
  a397=(a089*a396);
  a397=(a031-a397);
  a386=(a386/a397);
  a398=(a386*a375);
  a399=(a083*a033);
  a054=(a094-a054);
  a399=(a399*a054);
  a054=(a396*a399);
  a054=(a054/a397);
  a397=(a054*a104);
  a398=(a398-a397);
  a383=(a383+a398);
  a398=(a052*a383);
  a390=(a390+a398);
  a390=(a372+a390);
  a398=(a381*a390);
  a397=(a051*a105);
  a397=(a397*a033);
  a118=(a397/a118);
  a106=(a106*a105);
  a106=(a106*a033);
  a397=(a387*a397);
  a106=(a106+a397);
  a106=(a106/a389);
  a387=(a387*a106);
  a118=(a118+a387);
  a387=(a050*a363);
  a392=(a392/a092);
  a389=(a093*a391);
  a392=(a392-a389);
  a393=(a392*a393);
  a082=(a082/a092);
  a389=(a093*a394);
  a082=(a082-a389);
  a087=(a082*a087);
  a393=(a393+a087);
  a399=(a399/a091);
  a087=(a396*a054);
  a399=(a399+a087);
  a087=(a399*a104);
  a395=(a395/a091);
  a396=(a396*a386);
  a395=(a395+a396);
  a396=(a395*a375);
  a087=(a087-a396);
  a393=(a393+a087);
  a087=(a052*a393);
  a387=(a387+a087);
  a387=(a361+a387);
  a087=(a118*a387);
  a398=(a398-a087);
  a379=(a379+a398);
  a398=(a049*a379);
  a373=(a373+a398);
  a398=(a023*a143);
  a087=(a020*a139);
  a398=(a398+a087);
  a398=(a398*a364);
  a140=cos(a140);
  a087=(a007*a140);
  a087=(a087/a013);
  a398=(a398-a087);
  a396=(a398/a147);
  a398=(a151*a398);
  a087=(a087-a398);
  a087=(a087/a155);
  a398=(a151*a087);
  a396=(a396-a398);
  a398=(a130*a361);
  a375=(a132*a375);
  a398=(a398+a375);
  a375=(a133*a387);
  a398=(a398+a375);
  a398=(a047+a398);
  a375=(a396*a398);
  a091=(a131*a108);
  a389=(a135*a091);
  a389=(a140+a389);
  a397=(a007*a136);
  a397=(a397/a013);
  a397=(a397*a091);
  a397=(a142+a397);
  a091=(a144*a364);
  a397=(a397-a091);
  a091=(a151*a397);
  a153=(a153-a091);
  a153=(a153/a155);
  a397=(a397/a147);
  a091=(a151*a153);
  a397=(a397-a091);
  a091=(2.*a397);
  a153=(a153-a091);
  a153=(a136*a153);
  a389=(a389+a153);
  a389=(a025*a389);
  a153=(a389/a147);
  a397=(a397*a136);
  a397=(a397-a140);
  a135=(a135*a137);
  a135=(a135*a137);
  a397=(a397+a135);
  a397=(a025*a397);
  a389=(a151*a389);
  a397=(a397-a389);
  a397=(a397/a155);
  a389=(a151*a397);
  a153=(a153-a389);
  a389=(a130*a372);
  a104=(a132*a104);
  a389=(a389+a104);
  a104=(a133*a390);
  a389=(a389+a104);
  a389=(a368+a389);
  a104=(a153*a389);
  a375=(a375+a104);
  a104=(a136*a033);
  a135=(a131-a137);
  a104=(a104*a135);
  a146=(a026-a146);
  a146=(a146+a028);
  a135=(a104/a146);
  a091=(a150/a146);
  a104=(a091*a104);
  a400=(a150*a091);
  a400=(a031-a400);
  a104=(a104/a400);
  a401=(a091*a104);
  a135=(a135+a401);
  a401=(a130*a385);
  a383=(a132*a383);
  a401=(a401+a383);
  a370=(a371*a370);
  a384=(a388*a384);
  a370=(a370+a384);
  a384=(a106*a387);
  a383=(a376*a390);
  a384=(a384-a383);
  a370=(a370+a384);
  a384=(a133*a370);
  a401=(a401+a384);
  a401=(a372+a401);
  a384=(a135*a401);
  a383=(a131*a136);
  a383=(a383*a033);
  a146=(a383/a146);
  a137=(a137*a136);
  a137=(a137*a033);
  a383=(a091*a383);
  a137=(a137+a383);
  a137=(a137/a400);
  a091=(a091*a137);
  a146=(a146+a091);
  a091=(a130*a363);
  a393=(a132*a393);
  a091=(a091+a393);
  a393=(a133*a379);
  a091=(a091+a393);
  a091=(a361+a091);
  a393=(a146*a091);
  a384=(a384-a393);
  a375=(a375+a384);
  a384=(a129*a375);
  a373=(a373+a384);
  a373=(a361+a373);
  a384=(a005*a373);
  a362=(a362+a384);
  a384=(a158*a363);
  a393=(a160*a379);
  a384=(a384+a393);
  a393=(a161*a375);
  a384=(a384+a393);
  a393=(a023*a173);
  a400=(a020*a169);
  a393=(a393+a400);
  a393=(a393*a364);
  a170=cos(a170);
  a400=(a007*a170);
  a400=(a400/a013);
  a393=(a393-a400);
  a383=(a393/a177);
  a393=(a181*a393);
  a400=(a400-a393);
  a400=(a400/a185);
  a393=(a181*a400);
  a383=(a383-a393);
  a393=(a006*a361);
  a402=(a049*a387);
  a393=(a393+a402);
  a402=(a129*a091);
  a393=(a393+a402);
  a393=(a047+a393);
  a402=(a383*a393);
  a403=(a163*a167);
  a404=(a165*a403);
  a404=(a170+a404);
  a405=(a007*a166);
  a405=(a405/a013);
  a405=(a405*a403);
  a405=(a172+a405);
  a403=(a174*a364);
  a405=(a405-a403);
  a403=(a181*a405);
  a183=(a183-a403);
  a183=(a183/a185);
  a405=(a405/a177);
  a403=(a181*a183);
  a405=(a405-a403);
  a403=(2.*a405);
  a183=(a183-a403);
  a183=(a166*a183);
  a404=(a404+a183);
  a404=(a025*a404);
  a183=(a404/a177);
  a405=(a405*a166);
  a405=(a405-a170);
  a165=(a165*a048);
  a165=(a165*a048);
  a405=(a405+a165);
  a405=(a025*a405);
  a404=(a181*a404);
  a405=(a405-a404);
  a405=(a405/a185);
  a404=(a181*a405);
  a183=(a183-a404);
  a404=(a006*a372);
  a165=(a049*a390);
  a404=(a404+a165);
  a165=(a129*a401);
  a404=(a404+a165);
  a404=(a368+a404);
  a165=(a183*a404);
  a402=(a402+a165);
  a165=(a166*a033);
  a403=(a163-a048);
  a165=(a165*a403);
  a176=(a026-a176);
  a176=(a176+a028);
  a403=(a165/a176);
  a406=(a180/a176);
  a165=(a406*a165);
  a407=(a180*a406);
  a407=(a031-a407);
  a165=(a165/a407);
  a408=(a406*a165);
  a403=(a403+a408);
  a408=(a006*a385);
  a409=(a049*a370);
  a408=(a408+a409);
  a398=(a087*a398);
  a389=(a397*a389);
  a398=(a398+a389);
  a389=(a137*a091);
  a409=(a104*a401);
  a389=(a389-a409);
  a398=(a398+a389);
  a389=(a129*a398);
  a408=(a408+a389);
  a408=(a372+a408);
  a389=(a403*a408);
  a409=(a163*a166);
  a409=(a409*a033);
  a176=(a409/a176);
  a048=(a048*a166);
  a048=(a048*a033);
  a409=(a406*a409);
  a048=(a048+a409);
  a048=(a048/a407);
  a406=(a406*a048);
  a176=(a176+a406);
  a406=(a176*a373);
  a389=(a389-a406);
  a402=(a402+a389);
  a389=(a162*a402);
  a384=(a384+a389);
  a384=(a361+a384);
  a389=(a157*a384);
  a362=(a362+a389);
  a389=(a188*a363);
  a406=(a190*a379);
  a389=(a389+a406);
  a406=(a191*a375);
  a389=(a389+a406);
  a406=(a192*a402);
  a389=(a389+a406);
  a406=(a023*a204);
  a407=(a020*a200);
  a406=(a406+a407);
  a406=(a406*a364);
  a201=cos(a201);
  a407=(a007*a201);
  a407=(a407/a013);
  a406=(a406-a407);
  a409=(a406/a208);
  a406=(a212*a406);
  a407=(a407-a406);
  a407=(a407/a216);
  a406=(a212*a407);
  a409=(a409-a406);
  a406=(a158*a361);
  a410=(a160*a387);
  a406=(a406+a410);
  a410=(a161*a091);
  a406=(a406+a410);
  a410=(a162*a373);
  a406=(a406+a410);
  a406=(a047+a406);
  a410=(a409*a406);
  a411=(a194*a198);
  a412=(a196*a411);
  a412=(a201+a412);
  a413=(a007*a197);
  a413=(a413/a013);
  a413=(a413*a411);
  a413=(a203+a413);
  a411=(a205*a364);
  a413=(a413-a411);
  a411=(a212*a413);
  a214=(a214-a411);
  a214=(a214/a216);
  a413=(a413/a208);
  a411=(a212*a214);
  a413=(a413-a411);
  a411=(2.*a413);
  a214=(a214-a411);
  a214=(a197*a214);
  a412=(a412+a214);
  a412=(a025*a412);
  a214=(a412/a208);
  a413=(a413*a197);
  a413=(a413-a201);
  a196=(a196*a159);
  a196=(a196*a159);
  a413=(a413+a196);
  a413=(a025*a413);
  a412=(a212*a412);
  a413=(a413-a412);
  a413=(a413/a216);
  a412=(a212*a413);
  a214=(a214-a412);
  a412=(a158*a372);
  a196=(a160*a390);
  a412=(a412+a196);
  a196=(a161*a401);
  a412=(a412+a196);
  a196=(a162*a408);
  a412=(a412+a196);
  a412=(a368+a412);
  a196=(a214*a412);
  a410=(a410+a196);
  a196=(a197*a033);
  a411=(a194-a159);
  a196=(a196*a411);
  a207=(a026-a207);
  a207=(a207+a028);
  a411=(a196/a207);
  a414=(a211/a207);
  a196=(a414*a196);
  a415=(a211*a414);
  a415=(a031-a415);
  a196=(a196/a415);
  a416=(a414*a196);
  a411=(a411+a416);
  a416=(a158*a385);
  a417=(a160*a370);
  a416=(a416+a417);
  a417=(a161*a398);
  a416=(a416+a417);
  a393=(a400*a393);
  a404=(a405*a404);
  a393=(a393+a404);
  a404=(a048*a373);
  a417=(a165*a408);
  a404=(a404-a417);
  a393=(a393+a404);
  a404=(a162*a393);
  a416=(a416+a404);
  a416=(a372+a416);
  a404=(a411*a416);
  a417=(a194*a197);
  a417=(a417*a033);
  a207=(a417/a207);
  a159=(a159*a197);
  a159=(a159*a033);
  a417=(a414*a417);
  a159=(a159+a417);
  a159=(a159/a415);
  a414=(a414*a159);
  a207=(a207+a414);
  a414=(a207*a384);
  a404=(a404-a414);
  a410=(a410+a404);
  a404=(a193*a410);
  a389=(a389+a404);
  a389=(a361+a389);
  a404=(a187*a389);
  a362=(a362+a404);
  a404=(a219*a363);
  a414=(a221*a379);
  a404=(a404+a414);
  a414=(a222*a375);
  a404=(a404+a414);
  a414=(a223*a402);
  a404=(a404+a414);
  a414=(a224*a410);
  a404=(a404+a414);
  a414=(a023*a236);
  a415=(a020*a232);
  a414=(a414+a415);
  a414=(a414*a364);
  a233=cos(a233);
  a415=(a007*a233);
  a415=(a415/a013);
  a414=(a414-a415);
  a417=(a414/a240);
  a414=(a244*a414);
  a415=(a415-a414);
  a415=(a415/a248);
  a414=(a244*a415);
  a417=(a417-a414);
  a414=(a188*a361);
  a418=(a190*a387);
  a414=(a414+a418);
  a418=(a191*a091);
  a414=(a414+a418);
  a418=(a192*a373);
  a414=(a414+a418);
  a418=(a193*a384);
  a414=(a414+a418);
  a414=(a047+a414);
  a418=(a417*a414);
  a419=(a226*a230);
  a420=(a228*a419);
  a420=(a233+a420);
  a421=(a007*a229);
  a421=(a421/a013);
  a421=(a421*a419);
  a421=(a235+a421);
  a419=(a237*a364);
  a421=(a421-a419);
  a419=(a244*a421);
  a246=(a246-a419);
  a246=(a246/a248);
  a421=(a421/a240);
  a419=(a244*a246);
  a421=(a421-a419);
  a419=(2.*a421);
  a246=(a246-a419);
  a246=(a229*a246);
  a420=(a420+a246);
  a420=(a025*a420);
  a246=(a420/a240);
  a421=(a421*a229);
  a421=(a421-a233);
  a228=(a228*a189);
  a228=(a228*a189);
  a421=(a421+a228);
  a421=(a025*a421);
  a420=(a244*a420);
  a421=(a421-a420);
  a421=(a421/a248);
  a420=(a244*a421);
  a246=(a246-a420);
  a420=(a188*a372);
  a228=(a190*a390);
  a420=(a420+a228);
  a228=(a191*a401);
  a420=(a420+a228);
  a228=(a192*a408);
  a420=(a420+a228);
  a228=(a193*a416);
  a420=(a420+a228);
  a420=(a368+a420);
  a228=(a246*a420);
  a418=(a418+a228);
  a228=(a229*a033);
  a419=(a226-a189);
  a228=(a228*a419);
  a239=(a026-a239);
  a239=(a239+a028);
  a419=(a228/a239);
  a422=(a243/a239);
  a228=(a422*a228);
  a423=(a243*a422);
  a423=(a031-a423);
  a228=(a228/a423);
  a424=(a422*a228);
  a419=(a419+a424);
  a424=(a188*a385);
  a425=(a190*a370);
  a424=(a424+a425);
  a425=(a191*a398);
  a424=(a424+a425);
  a425=(a192*a393);
  a424=(a424+a425);
  a406=(a407*a406);
  a412=(a413*a412);
  a406=(a406+a412);
  a412=(a159*a384);
  a425=(a196*a416);
  a412=(a412-a425);
  a406=(a406+a412);
  a412=(a193*a406);
  a424=(a424+a412);
  a424=(a372+a424);
  a412=(a419*a424);
  a425=(a226*a229);
  a425=(a425*a033);
  a239=(a425/a239);
  a189=(a189*a229);
  a189=(a189*a033);
  a425=(a422*a425);
  a189=(a189+a425);
  a189=(a189/a423);
  a422=(a422*a189);
  a239=(a239+a422);
  a422=(a239*a389);
  a412=(a412-a422);
  a418=(a418+a412);
  a412=(a225*a418);
  a404=(a404+a412);
  a404=(a361+a404);
  a412=(a218*a404);
  a362=(a362+a412);
  a412=(a251*a363);
  a422=(a253*a379);
  a412=(a412+a422);
  a422=(a254*a375);
  a412=(a412+a422);
  a422=(a255*a402);
  a412=(a412+a422);
  a422=(a256*a410);
  a412=(a412+a422);
  a422=(a257*a418);
  a412=(a412+a422);
  a422=(a023*a269);
  a423=(a020*a265);
  a422=(a422+a423);
  a422=(a422*a364);
  a266=cos(a266);
  a423=(a007*a266);
  a423=(a423/a013);
  a422=(a422-a423);
  a425=(a422/a273);
  a422=(a277*a422);
  a423=(a423-a422);
  a423=(a423/a281);
  a422=(a277*a423);
  a425=(a425-a422);
  a422=(a219*a361);
  a426=(a221*a387);
  a422=(a422+a426);
  a426=(a222*a091);
  a422=(a422+a426);
  a426=(a223*a373);
  a422=(a422+a426);
  a426=(a224*a384);
  a422=(a422+a426);
  a426=(a225*a389);
  a422=(a422+a426);
  a422=(a047+a422);
  a426=(a425*a422);
  a427=(a259*a263);
  a428=(a261*a427);
  a428=(a266+a428);
  a429=(a007*a262);
  a429=(a429/a013);
  a429=(a429*a427);
  a429=(a268+a429);
  a427=(a270*a364);
  a429=(a429-a427);
  a427=(a277*a429);
  a279=(a279-a427);
  a279=(a279/a281);
  a429=(a429/a273);
  a427=(a277*a279);
  a429=(a429-a427);
  a427=(2.*a429);
  a279=(a279-a427);
  a279=(a262*a279);
  a428=(a428+a279);
  a428=(a025*a428);
  a279=(a428/a273);
  a429=(a429*a262);
  a429=(a429-a266);
  a261=(a261*a220);
  a261=(a261*a220);
  a429=(a429+a261);
  a429=(a025*a429);
  a428=(a277*a428);
  a429=(a429-a428);
  a429=(a429/a281);
  a428=(a277*a429);
  a279=(a279-a428);
  a428=(a219*a372);
  a261=(a221*a390);
  a428=(a428+a261);
  a261=(a222*a401);
  a428=(a428+a261);
  a261=(a223*a408);
  a428=(a428+a261);
  a261=(a224*a416);
  a428=(a428+a261);
  a261=(a225*a424);
  a428=(a428+a261);
  a428=(a368+a428);
  a261=(a279*a428);
  a426=(a426+a261);
  a261=(a262*a033);
  a427=(a259-a220);
  a261=(a261*a427);
  a272=(a026-a272);
  a272=(a272+a028);
  a427=(a261/a272);
  a430=(a276/a272);
  a261=(a430*a261);
  a431=(a276*a430);
  a431=(a031-a431);
  a261=(a261/a431);
  a432=(a430*a261);
  a427=(a427+a432);
  a432=(a219*a385);
  a433=(a221*a370);
  a432=(a432+a433);
  a433=(a222*a398);
  a432=(a432+a433);
  a433=(a223*a393);
  a432=(a432+a433);
  a433=(a224*a406);
  a432=(a432+a433);
  a414=(a415*a414);
  a420=(a421*a420);
  a414=(a414+a420);
  a420=(a189*a389);
  a433=(a228*a424);
  a420=(a420-a433);
  a414=(a414+a420);
  a420=(a225*a414);
  a432=(a432+a420);
  a432=(a372+a432);
  a420=(a427*a432);
  a433=(a259*a262);
  a433=(a433*a033);
  a272=(a433/a272);
  a220=(a220*a262);
  a220=(a220*a033);
  a433=(a430*a433);
  a220=(a220+a433);
  a220=(a220/a431);
  a430=(a430*a220);
  a272=(a272+a430);
  a430=(a272*a404);
  a420=(a420-a430);
  a426=(a426+a420);
  a420=(a258*a426);
  a412=(a412+a420);
  a412=(a361+a412);
  a420=(a250*a412);
  a362=(a362+a420);
  a420=(a284*a363);
  a430=(a286*a379);
  a420=(a420+a430);
  a430=(a287*a375);
  a420=(a420+a430);
  a430=(a288*a402);
  a420=(a420+a430);
  a430=(a289*a410);
  a420=(a420+a430);
  a430=(a290*a418);
  a420=(a420+a430);
  a430=(a291*a426);
  a420=(a420+a430);
  a430=(a023*a303);
  a431=(a020*a299);
  a430=(a430+a431);
  a430=(a430*a364);
  a300=cos(a300);
  a431=(a007*a300);
  a431=(a431/a013);
  a430=(a430-a431);
  a433=(a430/a307);
  a430=(a311*a430);
  a431=(a431-a430);
  a431=(a431/a315);
  a430=(a311*a431);
  a433=(a433-a430);
  a430=(a251*a361);
  a434=(a253*a387);
  a430=(a430+a434);
  a434=(a254*a091);
  a430=(a430+a434);
  a434=(a255*a373);
  a430=(a430+a434);
  a434=(a256*a384);
  a430=(a430+a434);
  a434=(a257*a389);
  a430=(a430+a434);
  a434=(a258*a404);
  a430=(a430+a434);
  a430=(a047+a430);
  a434=(a433*a430);
  a435=(a293*a297);
  a436=(a295*a435);
  a436=(a300+a436);
  a437=(a007*a296);
  a437=(a437/a013);
  a437=(a437*a435);
  a437=(a302+a437);
  a435=(a304*a364);
  a437=(a437-a435);
  a435=(a311*a437);
  a313=(a313-a435);
  a313=(a313/a315);
  a437=(a437/a307);
  a435=(a311*a313);
  a437=(a437-a435);
  a435=(2.*a437);
  a313=(a313-a435);
  a313=(a296*a313);
  a436=(a436+a313);
  a436=(a025*a436);
  a313=(a436/a307);
  a437=(a437*a296);
  a437=(a437-a300);
  a295=(a295*a252);
  a295=(a295*a252);
  a437=(a437+a295);
  a437=(a025*a437);
  a436=(a311*a436);
  a437=(a437-a436);
  a437=(a437/a315);
  a436=(a311*a437);
  a313=(a313-a436);
  a436=(a251*a372);
  a295=(a253*a390);
  a436=(a436+a295);
  a295=(a254*a401);
  a436=(a436+a295);
  a295=(a255*a408);
  a436=(a436+a295);
  a295=(a256*a416);
  a436=(a436+a295);
  a295=(a257*a424);
  a436=(a436+a295);
  a295=(a258*a432);
  a436=(a436+a295);
  a436=(a368+a436);
  a295=(a313*a436);
  a434=(a434+a295);
  a295=(a296*a033);
  a435=(a293-a252);
  a295=(a295*a435);
  a306=(a026-a306);
  a306=(a306+a028);
  a435=(a295/a306);
  a438=(a310/a306);
  a295=(a438*a295);
  a439=(a310*a438);
  a439=(a031-a439);
  a295=(a295/a439);
  a440=(a438*a295);
  a435=(a435+a440);
  a440=(a251*a385);
  a441=(a253*a370);
  a440=(a440+a441);
  a441=(a254*a398);
  a440=(a440+a441);
  a441=(a255*a393);
  a440=(a440+a441);
  a441=(a256*a406);
  a440=(a440+a441);
  a441=(a257*a414);
  a440=(a440+a441);
  a422=(a423*a422);
  a428=(a429*a428);
  a422=(a422+a428);
  a428=(a220*a404);
  a441=(a261*a432);
  a428=(a428-a441);
  a422=(a422+a428);
  a428=(a258*a422);
  a440=(a440+a428);
  a440=(a372+a440);
  a428=(a435*a440);
  a441=(a293*a296);
  a441=(a441*a033);
  a306=(a441/a306);
  a252=(a252*a296);
  a252=(a252*a033);
  a441=(a438*a441);
  a252=(a252+a441);
  a252=(a252/a439);
  a438=(a438*a252);
  a306=(a306+a438);
  a438=(a306*a412);
  a428=(a428-a438);
  a434=(a434+a428);
  a428=(a292*a434);
  a420=(a420+a428);
  a420=(a361+a420);
  a428=(a283*a420);
  a362=(a362+a428);
  a428=(a318*a363);
  a379=(a320*a379);
  a428=(a428+a379);
  a375=(a128*a375);
  a428=(a428+a375);
  a375=(a156*a402);
  a428=(a428+a375);
  a375=(a321*a410);
  a428=(a428+a375);
  a375=(a322*a418);
  a428=(a428+a375);
  a375=(a323*a426);
  a428=(a428+a375);
  a375=(a324*a434);
  a428=(a428+a375);
  a375=(a023*a335);
  a379=(a020*a331);
  a375=(a375+a379);
  a375=(a375*a364);
  a332=cos(a332);
  a379=(a007*a332);
  a379=(a379/a013);
  a375=(a375-a379);
  a438=(a375/a339);
  a375=(a343*a375);
  a379=(a379-a375);
  a379=(a379/a347);
  a375=(a343*a379);
  a438=(a438-a375);
  a375=(a284*a361);
  a439=(a286*a387);
  a375=(a375+a439);
  a439=(a287*a091);
  a375=(a375+a439);
  a439=(a288*a373);
  a375=(a375+a439);
  a439=(a289*a384);
  a375=(a375+a439);
  a439=(a290*a389);
  a375=(a375+a439);
  a439=(a291*a404);
  a375=(a375+a439);
  a439=(a292*a412);
  a375=(a375+a439);
  a375=(a047+a375);
  a439=(a438*a375);
  a441=(a002*a329);
  a442=(a327*a441);
  a442=(a332+a442);
  a443=(a007*a328);
  a443=(a443/a013);
  a443=(a443*a441);
  a443=(a334+a443);
  a441=(a336*a364);
  a443=(a443-a441);
  a441=(a343*a443);
  a345=(a345-a441);
  a345=(a345/a347);
  a443=(a443/a339);
  a441=(a343*a345);
  a443=(a443-a441);
  a441=(2.*a443);
  a345=(a345-a441);
  a345=(a328*a345);
  a442=(a442+a345);
  a442=(a025*a442);
  a345=(a442/a339);
  a443=(a443*a328);
  a443=(a443-a332);
  a327=(a327*a285);
  a327=(a327*a285);
  a443=(a443+a327);
  a443=(a025*a443);
  a442=(a343*a442);
  a443=(a443-a442);
  a443=(a443/a347);
  a442=(a343*a443);
  a345=(a345-a442);
  a442=(a284*a372);
  a327=(a286*a390);
  a442=(a442+a327);
  a327=(a287*a401);
  a442=(a442+a327);
  a327=(a288*a408);
  a442=(a442+a327);
  a327=(a289*a416);
  a442=(a442+a327);
  a327=(a290*a424);
  a442=(a442+a327);
  a327=(a291*a432);
  a442=(a442+a327);
  a327=(a292*a440);
  a442=(a442+a327);
  a442=(a368+a442);
  a327=(a345*a442);
  a439=(a439+a327);
  a327=(a328*a033);
  a441=(a002-a285);
  a327=(a327*a441);
  a338=(a026-a338);
  a338=(a338+a028);
  a441=(a327/a338);
  a444=(a342/a338);
  a327=(a444*a327);
  a445=(a342*a444);
  a445=(a031-a445);
  a327=(a327/a445);
  a446=(a444*a327);
  a441=(a441+a446);
  a446=(a284*a385);
  a447=(a286*a370);
  a446=(a446+a447);
  a447=(a287*a398);
  a446=(a446+a447);
  a447=(a288*a393);
  a446=(a446+a447);
  a447=(a289*a406);
  a446=(a446+a447);
  a447=(a290*a414);
  a446=(a446+a447);
  a447=(a291*a422);
  a446=(a446+a447);
  a430=(a431*a430);
  a436=(a437*a436);
  a430=(a430+a436);
  a436=(a252*a412);
  a447=(a295*a440);
  a436=(a436-a447);
  a430=(a430+a436);
  a436=(a292*a430);
  a446=(a446+a436);
  a446=(a372+a446);
  a436=(a441*a446);
  a447=(a002*a328);
  a447=(a447*a033);
  a338=(a447/a338);
  a285=(a285*a328);
  a285=(a285*a033);
  a447=(a444*a447);
  a285=(a285+a447);
  a285=(a285/a445);
  a444=(a444*a285);
  a338=(a338+a444);
  a444=(a338*a420);
  a436=(a436-a444);
  a439=(a439+a436);
  a436=(a325*a439);
  a428=(a428+a436);
  a428=(a361+a428);
  a436=(a317*a428);
  a362=(a362+a436);
  a362=(a047+a362);
  if (res[0]!=0) res[0][4]=a362;
  a362=(a001*a372);
  a436=(a005*a408);
  a362=(a362+a436);
  a436=(a157*a416);
  a362=(a362+a436);
  a436=(a187*a424);
  a362=(a362+a436);
  a436=(a218*a432);
  a362=(a362+a436);
  a436=(a250*a440);
  a362=(a362+a436);
  a436=(a283*a446);
  a362=(a362+a436);
  a436=(a318*a385);
  a370=(a320*a370);
  a436=(a436+a370);
  a398=(a128*a398);
  a436=(a436+a398);
  a398=(a156*a393);
  a436=(a436+a398);
  a398=(a321*a406);
  a436=(a436+a398);
  a398=(a322*a414);
  a436=(a436+a398);
  a398=(a323*a422);
  a436=(a436+a398);
  a398=(a324*a430);
  a436=(a436+a398);
  a375=(a379*a375);
  a442=(a443*a442);
  a375=(a375+a442);
  a442=(a285*a420);
  a398=(a327*a446);
  a442=(a442-a398);
  a375=(a375+a442);
  a442=(a325*a375);
  a436=(a436+a442);
  a436=(a372+a436);
  a442=(a317*a436);
  a362=(a362+a442);
  a362=(a368+a362);
  if (res[0]!=0) res[0][5]=a362;
  a363=(a001*a363);
  a402=(a005*a402);
  a363=(a363+a402);
  a410=(a157*a410);
  a363=(a363+a410);
  a418=(a187*a418);
  a363=(a363+a418);
  a426=(a218*a426);
  a363=(a363+a426);
  a434=(a250*a434);
  a363=(a363+a434);
  a439=(a283*a439);
  a363=(a363+a439);
  a439=(a023*a004);
  a434=(a020*a000);
  a439=(a439+a434);
  a439=(a439*a364);
  a016=cos(a016);
  a434=(a007*a016);
  a434=(a434/a013);
  a439=(a439-a434);
  a426=(a439/a352);
  a439=(a356*a439);
  a434=(a434-a439);
  a434=(a434/a360);
  a439=(a356*a434);
  a426=(a426-a439);
  a439=(a318*a361);
  a387=(a320*a387);
  a439=(a439+a387);
  a091=(a128*a091);
  a439=(a439+a091);
  a373=(a156*a373);
  a439=(a439+a373);
  a384=(a321*a384);
  a439=(a439+a384);
  a389=(a322*a389);
  a439=(a439+a389);
  a404=(a323*a404);
  a439=(a439+a404);
  a412=(a324*a412);
  a439=(a439+a412);
  a420=(a325*a420);
  a439=(a439+a420);
  a047=(a047+a439);
  a439=(a426*a047);
  a420=(a349*a282);
  a412=(a010*a420);
  a412=(a016+a412);
  a404=(a007*a316);
  a404=(a404/a013);
  a404=(a404*a420);
  a404=(a186+a404);
  a364=(a350*a364);
  a404=(a404-a364);
  a364=(a356*a404);
  a358=(a358-a364);
  a358=(a358/a360);
  a404=(a404/a352);
  a364=(a356*a358);
  a404=(a404-a364);
  a364=(2.*a404);
  a358=(a358-a364);
  a358=(a316*a358);
  a412=(a412+a358);
  a412=(a025*a412);
  a358=(a412/a352);
  a404=(a404*a316);
  a404=(a404-a016);
  a010=(a010*a319);
  a010=(a010*a319);
  a404=(a404+a010);
  a404=(a025*a404);
  a412=(a356*a412);
  a404=(a404-a412);
  a404=(a404/a360);
  a412=(a356*a404);
  a358=(a358-a412);
  a412=(a318*a372);
  a390=(a320*a390);
  a412=(a412+a390);
  a401=(a128*a401);
  a412=(a412+a401);
  a408=(a156*a408);
  a412=(a412+a408);
  a416=(a321*a416);
  a412=(a412+a416);
  a424=(a322*a424);
  a412=(a412+a424);
  a432=(a323*a432);
  a412=(a412+a432);
  a440=(a324*a440);
  a412=(a412+a440);
  a446=(a325*a446);
  a412=(a412+a446);
  a368=(a368+a412);
  a412=(a358*a368);
  a439=(a439+a412);
  a412=(a316*a033);
  a446=(a349-a319);
  a412=(a412*a446);
  a026=(a026-a351);
  a026=(a026+a028);
  a028=(a412/a026);
  a351=(a355/a026);
  a412=(a351*a412);
  a446=(a355*a351);
  a446=(a031-a446);
  a412=(a412/a446);
  a440=(a351*a412);
  a028=(a028+a440);
  a440=(a028*a436);
  a432=(a349*a316);
  a432=(a432*a033);
  a026=(a432/a026);
  a319=(a319*a316);
  a319=(a319*a033);
  a432=(a351*a432);
  a319=(a319+a432);
  a319=(a319/a446);
  a351=(a351*a319);
  a026=(a026+a351);
  a351=(a026*a428);
  a440=(a440-a351);
  a439=(a439+a440);
  a439=(a317*a439);
  a363=(a363+a439);
  a361=(a361+a363);
  if (res[0]!=0) res[0][6]=a361;
  a385=(a001*a385);
  a393=(a005*a393);
  a385=(a385+a393);
  a406=(a157*a406);
  a385=(a385+a406);
  a414=(a187*a414);
  a385=(a385+a414);
  a422=(a218*a422);
  a385=(a385+a422);
  a430=(a250*a430);
  a385=(a385+a430);
  a375=(a283*a375);
  a385=(a385+a375);
  a047=(a434*a047);
  a368=(a404*a368);
  a047=(a047+a368);
  a428=(a319*a428);
  a436=(a412*a436);
  a428=(a428-a436);
  a047=(a047+a428);
  a047=(a317*a047);
  a385=(a385+a047);
  a372=(a372+a385);
  if (res[0]!=0) res[0][7]=a372;
  a372=arg[0]? arg[0][8] : 0;
  a385=arg[0]? arg[0][10] : 0;
  a047=(a001*a385);
  a428=(a366*a372);
  a436=arg[0]? arg[0][9] : 0;
  a368=(a043*a436);
  a428=(a428+a368);
  a368=arg[0]? arg[0][11] : 0;
  a375=(a367*a368);
  a430=(a036*a385);
  a375=(a375-a430);
  a428=(a428+a375);
  a375=(a006*a428);
  a430=(a050*a385);
  a422=(a053*a428);
  a414=(a056*a385);
  a414=(a372+a414);
  a406=(a378*a414);
  a393=(a056*a368);
  a393=(a436+a393);
  a361=(a078*a393);
  a406=(a406+a361);
  a361=(a365*a372);
  a363=(a369*a436);
  a361=(a361+a363);
  a363=(a003*a385);
  a439=(a034*a368);
  a363=(a363-a439);
  a361=(a361+a363);
  a363=(a056*a361);
  a363=(a368+a363);
  a439=(a380*a363);
  a440=(a056*a428);
  a440=(a385+a440);
  a351=(a071*a440);
  a439=(a439-a351);
  a406=(a406+a439);
  a406=(a055*a406);
  a422=(a422+a406);
  a422=(a385+a422);
  a406=(a052*a422);
  a430=(a430+a406);
  a430=(a372+a430);
  a406=(a374*a430);
  a439=(a050*a368);
  a351=(a053*a361);
  a414=(a377*a414);
  a393=(a382*a393);
  a414=(a414+a393);
  a393=(a061*a440);
  a446=(a059*a363);
  a393=(a393-a446);
  a414=(a414+a393);
  a414=(a055*a414);
  a351=(a351+a414);
  a351=(a368+a351);
  a414=(a052*a351);
  a439=(a439+a414);
  a439=(a436+a439);
  a414=(a125*a439);
  a406=(a406+a414);
  a414=(a050*a361);
  a393=(a053*a385);
  a440=(a055*a440);
  a393=(a393+a440);
  a393=(a372+a393);
  a440=(a391*a393);
  a446=(a053*a368);
  a363=(a055*a363);
  a446=(a446+a363);
  a446=(a436+a446);
  a363=(a394*a446);
  a440=(a440+a363);
  a363=(a386*a422);
  a432=(a054*a351);
  a363=(a363-a432);
  a440=(a440+a363);
  a363=(a052*a440);
  a414=(a414+a363);
  a414=(a368+a414);
  a363=(a381*a414);
  a432=(a050*a428);
  a393=(a392*a393);
  a446=(a082*a446);
  a393=(a393+a446);
  a446=(a399*a351);
  a424=(a395*a422);
  a446=(a446-a424);
  a393=(a393+a446);
  a446=(a052*a393);
  a432=(a432+a446);
  a432=(a385+a432);
  a446=(a118*a432);
  a363=(a363-a446);
  a406=(a406+a363);
  a363=(a049*a406);
  a375=(a375+a363);
  a363=(a130*a385);
  a422=(a132*a422);
  a363=(a363+a422);
  a422=(a133*a432);
  a363=(a363+a422);
  a363=(a372+a363);
  a422=(a396*a363);
  a446=(a130*a368);
  a351=(a132*a351);
  a446=(a446+a351);
  a351=(a133*a414);
  a446=(a446+a351);
  a446=(a436+a446);
  a351=(a153*a446);
  a422=(a422+a351);
  a351=(a130*a361);
  a440=(a132*a440);
  a351=(a351+a440);
  a430=(a371*a430);
  a439=(a388*a439);
  a430=(a430+a439);
  a439=(a106*a432);
  a440=(a376*a414);
  a439=(a439-a440);
  a430=(a430+a439);
  a439=(a133*a430);
  a351=(a351+a439);
  a351=(a368+a351);
  a439=(a135*a351);
  a440=(a130*a428);
  a393=(a132*a393);
  a440=(a440+a393);
  a393=(a133*a406);
  a440=(a440+a393);
  a440=(a385+a440);
  a393=(a146*a440);
  a439=(a439-a393);
  a422=(a422+a439);
  a439=(a129*a422);
  a375=(a375+a439);
  a375=(a385+a375);
  a439=(a005*a375);
  a047=(a047+a439);
  a439=(a158*a428);
  a393=(a160*a406);
  a439=(a439+a393);
  a393=(a161*a422);
  a439=(a439+a393);
  a393=(a006*a385);
  a424=(a049*a432);
  a393=(a393+a424);
  a424=(a129*a440);
  a393=(a393+a424);
  a393=(a372+a393);
  a424=(a383*a393);
  a416=(a006*a368);
  a408=(a049*a414);
  a416=(a416+a408);
  a408=(a129*a351);
  a416=(a416+a408);
  a416=(a436+a416);
  a408=(a183*a416);
  a424=(a424+a408);
  a408=(a006*a361);
  a401=(a049*a430);
  a408=(a408+a401);
  a363=(a087*a363);
  a446=(a397*a446);
  a363=(a363+a446);
  a446=(a137*a440);
  a401=(a104*a351);
  a446=(a446-a401);
  a363=(a363+a446);
  a446=(a129*a363);
  a408=(a408+a446);
  a408=(a368+a408);
  a446=(a403*a408);
  a401=(a176*a375);
  a446=(a446-a401);
  a424=(a424+a446);
  a446=(a162*a424);
  a439=(a439+a446);
  a439=(a385+a439);
  a446=(a157*a439);
  a047=(a047+a446);
  a446=(a188*a428);
  a401=(a190*a406);
  a446=(a446+a401);
  a401=(a191*a422);
  a446=(a446+a401);
  a401=(a192*a424);
  a446=(a446+a401);
  a401=(a158*a385);
  a390=(a160*a432);
  a401=(a401+a390);
  a390=(a161*a440);
  a401=(a401+a390);
  a390=(a162*a375);
  a401=(a401+a390);
  a401=(a372+a401);
  a390=(a409*a401);
  a010=(a158*a368);
  a364=(a160*a414);
  a010=(a010+a364);
  a364=(a161*a351);
  a010=(a010+a364);
  a364=(a162*a408);
  a010=(a010+a364);
  a010=(a436+a010);
  a364=(a214*a010);
  a390=(a390+a364);
  a364=(a158*a361);
  a420=(a160*a430);
  a364=(a364+a420);
  a420=(a161*a363);
  a364=(a364+a420);
  a393=(a400*a393);
  a416=(a405*a416);
  a393=(a393+a416);
  a416=(a048*a375);
  a420=(a165*a408);
  a416=(a416-a420);
  a393=(a393+a416);
  a416=(a162*a393);
  a364=(a364+a416);
  a364=(a368+a364);
  a416=(a411*a364);
  a420=(a207*a439);
  a416=(a416-a420);
  a390=(a390+a416);
  a416=(a193*a390);
  a446=(a446+a416);
  a446=(a385+a446);
  a416=(a187*a446);
  a047=(a047+a416);
  a416=(a219*a428);
  a420=(a221*a406);
  a416=(a416+a420);
  a420=(a222*a422);
  a416=(a416+a420);
  a420=(a223*a424);
  a416=(a416+a420);
  a420=(a224*a390);
  a416=(a416+a420);
  a420=(a188*a385);
  a389=(a190*a432);
  a420=(a420+a389);
  a389=(a191*a440);
  a420=(a420+a389);
  a389=(a192*a375);
  a420=(a420+a389);
  a389=(a193*a439);
  a420=(a420+a389);
  a420=(a372+a420);
  a389=(a417*a420);
  a384=(a188*a368);
  a373=(a190*a414);
  a384=(a384+a373);
  a373=(a191*a351);
  a384=(a384+a373);
  a373=(a192*a408);
  a384=(a384+a373);
  a373=(a193*a364);
  a384=(a384+a373);
  a384=(a436+a384);
  a373=(a246*a384);
  a389=(a389+a373);
  a373=(a188*a361);
  a091=(a190*a430);
  a373=(a373+a091);
  a091=(a191*a363);
  a373=(a373+a091);
  a091=(a192*a393);
  a373=(a373+a091);
  a401=(a407*a401);
  a010=(a413*a010);
  a401=(a401+a010);
  a010=(a159*a439);
  a091=(a196*a364);
  a010=(a010-a091);
  a401=(a401+a010);
  a010=(a193*a401);
  a373=(a373+a010);
  a373=(a368+a373);
  a010=(a419*a373);
  a091=(a239*a446);
  a010=(a010-a091);
  a389=(a389+a010);
  a010=(a225*a389);
  a416=(a416+a010);
  a416=(a385+a416);
  a010=(a218*a416);
  a047=(a047+a010);
  a010=(a251*a428);
  a091=(a253*a406);
  a010=(a010+a091);
  a091=(a254*a422);
  a010=(a010+a091);
  a091=(a255*a424);
  a010=(a010+a091);
  a091=(a256*a390);
  a010=(a010+a091);
  a091=(a257*a389);
  a010=(a010+a091);
  a091=(a219*a385);
  a387=(a221*a432);
  a091=(a091+a387);
  a387=(a222*a440);
  a091=(a091+a387);
  a387=(a223*a375);
  a091=(a091+a387);
  a387=(a224*a439);
  a091=(a091+a387);
  a387=(a225*a446);
  a091=(a091+a387);
  a091=(a372+a091);
  a387=(a425*a091);
  a418=(a219*a368);
  a410=(a221*a414);
  a418=(a418+a410);
  a410=(a222*a351);
  a418=(a418+a410);
  a410=(a223*a408);
  a418=(a418+a410);
  a410=(a224*a364);
  a418=(a418+a410);
  a410=(a225*a373);
  a418=(a418+a410);
  a418=(a436+a418);
  a410=(a279*a418);
  a387=(a387+a410);
  a410=(a219*a361);
  a402=(a221*a430);
  a410=(a410+a402);
  a402=(a222*a363);
  a410=(a410+a402);
  a402=(a223*a393);
  a410=(a410+a402);
  a402=(a224*a401);
  a410=(a410+a402);
  a420=(a415*a420);
  a384=(a421*a384);
  a420=(a420+a384);
  a384=(a189*a446);
  a402=(a228*a373);
  a384=(a384-a402);
  a420=(a420+a384);
  a384=(a225*a420);
  a410=(a410+a384);
  a410=(a368+a410);
  a384=(a427*a410);
  a402=(a272*a416);
  a384=(a384-a402);
  a387=(a387+a384);
  a384=(a258*a387);
  a010=(a010+a384);
  a010=(a385+a010);
  a384=(a250*a010);
  a047=(a047+a384);
  a384=(a284*a428);
  a402=(a286*a406);
  a384=(a384+a402);
  a402=(a287*a422);
  a384=(a384+a402);
  a402=(a288*a424);
  a384=(a384+a402);
  a402=(a289*a390);
  a384=(a384+a402);
  a402=(a290*a389);
  a384=(a384+a402);
  a402=(a291*a387);
  a384=(a384+a402);
  a402=(a251*a385);
  a362=(a253*a432);
  a402=(a402+a362);
  a362=(a254*a440);
  a402=(a402+a362);
  a362=(a255*a375);
  a402=(a402+a362);
  a362=(a256*a439);
  a402=(a402+a362);
  a362=(a257*a446);
  a402=(a402+a362);
  a362=(a258*a416);
  a402=(a402+a362);
  a402=(a372+a402);
  a362=(a433*a402);
  a442=(a251*a368);
  a398=(a253*a414);
  a442=(a442+a398);
  a398=(a254*a351);
  a442=(a442+a398);
  a398=(a255*a408);
  a442=(a442+a398);
  a398=(a256*a364);
  a442=(a442+a398);
  a398=(a257*a373);
  a442=(a442+a398);
  a398=(a258*a410);
  a442=(a442+a398);
  a442=(a436+a442);
  a398=(a313*a442);
  a362=(a362+a398);
  a398=(a251*a361);
  a370=(a253*a430);
  a398=(a398+a370);
  a370=(a254*a363);
  a398=(a398+a370);
  a370=(a255*a393);
  a398=(a398+a370);
  a370=(a256*a401);
  a398=(a398+a370);
  a370=(a257*a420);
  a398=(a398+a370);
  a091=(a423*a091);
  a418=(a429*a418);
  a091=(a091+a418);
  a418=(a220*a416);
  a370=(a261*a410);
  a418=(a418-a370);
  a091=(a091+a418);
  a418=(a258*a091);
  a398=(a398+a418);
  a398=(a368+a398);
  a418=(a435*a398);
  a370=(a306*a010);
  a418=(a418-a370);
  a362=(a362+a418);
  a418=(a292*a362);
  a384=(a384+a418);
  a384=(a385+a384);
  a418=(a283*a384);
  a047=(a047+a418);
  a418=(a318*a428);
  a406=(a320*a406);
  a418=(a418+a406);
  a422=(a128*a422);
  a418=(a418+a422);
  a422=(a156*a424);
  a418=(a418+a422);
  a422=(a321*a390);
  a418=(a418+a422);
  a422=(a322*a389);
  a418=(a418+a422);
  a422=(a323*a387);
  a418=(a418+a422);
  a422=(a324*a362);
  a418=(a418+a422);
  a422=(a284*a385);
  a406=(a286*a432);
  a422=(a422+a406);
  a406=(a287*a440);
  a422=(a422+a406);
  a406=(a288*a375);
  a422=(a422+a406);
  a406=(a289*a439);
  a422=(a422+a406);
  a406=(a290*a446);
  a422=(a422+a406);
  a406=(a291*a416);
  a422=(a422+a406);
  a406=(a292*a010);
  a422=(a422+a406);
  a422=(a372+a422);
  a406=(a438*a422);
  a370=(a284*a368);
  a444=(a286*a414);
  a370=(a370+a444);
  a444=(a287*a351);
  a370=(a370+a444);
  a444=(a288*a408);
  a370=(a370+a444);
  a444=(a289*a364);
  a370=(a370+a444);
  a444=(a290*a373);
  a370=(a370+a444);
  a444=(a291*a410);
  a370=(a370+a444);
  a444=(a292*a398);
  a370=(a370+a444);
  a370=(a436+a370);
  a444=(a345*a370);
  a406=(a406+a444);
  a444=(a284*a361);
  a445=(a286*a430);
  a444=(a444+a445);
  a445=(a287*a363);
  a444=(a444+a445);
  a445=(a288*a393);
  a444=(a444+a445);
  a445=(a289*a401);
  a444=(a444+a445);
  a445=(a290*a420);
  a444=(a444+a445);
  a445=(a291*a091);
  a444=(a444+a445);
  a402=(a431*a402);
  a442=(a437*a442);
  a402=(a402+a442);
  a442=(a252*a010);
  a445=(a295*a398);
  a442=(a442-a445);
  a402=(a402+a442);
  a442=(a292*a402);
  a444=(a444+a442);
  a444=(a368+a444);
  a442=(a441*a444);
  a445=(a338*a384);
  a442=(a442-a445);
  a406=(a406+a442);
  a442=(a325*a406);
  a418=(a418+a442);
  a418=(a385+a418);
  a442=(a317*a418);
  a047=(a047+a442);
  a047=(a372+a047);
  if (res[0]!=0) res[0][8]=a047;
  a047=(a001*a368);
  a442=(a005*a408);
  a047=(a047+a442);
  a442=(a157*a364);
  a047=(a047+a442);
  a442=(a187*a373);
  a047=(a047+a442);
  a442=(a218*a410);
  a047=(a047+a442);
  a442=(a250*a398);
  a047=(a047+a442);
  a442=(a283*a444);
  a047=(a047+a442);
  a442=(a318*a361);
  a430=(a320*a430);
  a442=(a442+a430);
  a363=(a128*a363);
  a442=(a442+a363);
  a363=(a156*a393);
  a442=(a442+a363);
  a363=(a321*a401);
  a442=(a442+a363);
  a363=(a322*a420);
  a442=(a442+a363);
  a363=(a323*a091);
  a442=(a442+a363);
  a363=(a324*a402);
  a442=(a442+a363);
  a422=(a379*a422);
  a370=(a443*a370);
  a422=(a422+a370);
  a370=(a285*a384);
  a363=(a327*a444);
  a370=(a370-a363);
  a422=(a422+a370);
  a370=(a325*a422);
  a442=(a442+a370);
  a442=(a368+a442);
  a370=(a317*a442);
  a047=(a047+a370);
  a047=(a436+a047);
  if (res[0]!=0) res[0][9]=a047;
  a428=(a001*a428);
  a424=(a005*a424);
  a428=(a428+a424);
  a390=(a157*a390);
  a428=(a428+a390);
  a389=(a187*a389);
  a428=(a428+a389);
  a387=(a218*a387);
  a428=(a428+a387);
  a362=(a250*a362);
  a428=(a428+a362);
  a406=(a283*a406);
  a428=(a428+a406);
  a406=(a318*a385);
  a432=(a320*a432);
  a406=(a406+a432);
  a440=(a128*a440);
  a406=(a406+a440);
  a375=(a156*a375);
  a406=(a406+a375);
  a439=(a321*a439);
  a406=(a406+a439);
  a446=(a322*a446);
  a406=(a406+a446);
  a416=(a323*a416);
  a406=(a406+a416);
  a010=(a324*a010);
  a406=(a406+a010);
  a384=(a325*a384);
  a406=(a406+a384);
  a372=(a372+a406);
  a406=(a426*a372);
  a384=(a318*a368);
  a414=(a320*a414);
  a384=(a384+a414);
  a351=(a128*a351);
  a384=(a384+a351);
  a408=(a156*a408);
  a384=(a384+a408);
  a364=(a321*a364);
  a384=(a384+a364);
  a373=(a322*a373);
  a384=(a384+a373);
  a410=(a323*a410);
  a384=(a384+a410);
  a398=(a324*a398);
  a384=(a384+a398);
  a444=(a325*a444);
  a384=(a384+a444);
  a436=(a436+a384);
  a384=(a358*a436);
  a406=(a406+a384);
  a384=(a028*a442);
  a444=(a026*a418);
  a384=(a384-a444);
  a406=(a406+a384);
  a406=(a317*a406);
  a428=(a428+a406);
  a385=(a385+a428);
  if (res[0]!=0) res[0][10]=a385;
  a361=(a001*a361);
  a393=(a005*a393);
  a361=(a361+a393);
  a401=(a157*a401);
  a361=(a361+a401);
  a420=(a187*a420);
  a361=(a361+a420);
  a091=(a218*a091);
  a361=(a361+a091);
  a402=(a250*a402);
  a361=(a361+a402);
  a422=(a283*a422);
  a361=(a361+a422);
  a372=(a434*a372);
  a436=(a404*a436);
  a372=(a372+a436);
  a418=(a319*a418);
  a442=(a412*a442);
  a418=(a418-a442);
  a372=(a372+a418);
  a372=(a317*a372);
  a361=(a361+a372);
  a368=(a368+a361);
  if (res[0]!=0) res[0][11]=a368;
  a368=arg[0]? arg[0][12] : 0;
  a361=arg[0]? arg[0][14] : 0;
  a372=(a001*a361);
  a418=(a366*a368);
  a442=arg[0]? arg[0][13] : 0;
  a436=(a043*a442);
  a418=(a418+a436);
  a436=arg[0]? arg[0][15] : 0;
  a422=(a367*a436);
  a402=(a036*a361);
  a422=(a422-a402);
  a418=(a418+a422);
  a422=(a006*a418);
  a402=(a050*a361);
  a091=(a053*a418);
  a420=(a056*a361);
  a420=(a368+a420);
  a401=(a378*a420);
  a393=(a056*a436);
  a393=(a442+a393);
  a385=(a078*a393);
  a401=(a401+a385);
  a385=(a365*a368);
  a428=(a369*a442);
  a385=(a385+a428);
  a428=(a003*a361);
  a406=(a034*a436);
  a428=(a428-a406);
  a385=(a385+a428);
  a428=(a056*a385);
  a428=(a436+a428);
  a406=(a380*a428);
  a384=(a056*a418);
  a384=(a361+a384);
  a444=(a071*a384);
  a406=(a406-a444);
  a401=(a401+a406);
  a401=(a055*a401);
  a091=(a091+a401);
  a091=(a361+a091);
  a401=(a052*a091);
  a402=(a402+a401);
  a402=(a368+a402);
  a401=(a374*a402);
  a406=(a050*a436);
  a444=(a053*a385);
  a420=(a377*a420);
  a393=(a382*a393);
  a420=(a420+a393);
  a393=(a061*a384);
  a398=(a059*a428);
  a393=(a393-a398);
  a420=(a420+a393);
  a420=(a055*a420);
  a444=(a444+a420);
  a444=(a436+a444);
  a420=(a052*a444);
  a406=(a406+a420);
  a406=(a442+a406);
  a420=(a125*a406);
  a401=(a401+a420);
  a420=(a050*a385);
  a393=(a053*a361);
  a384=(a055*a384);
  a393=(a393+a384);
  a393=(a368+a393);
  a384=(a391*a393);
  a398=(a053*a436);
  a428=(a055*a428);
  a398=(a398+a428);
  a398=(a442+a398);
  a428=(a394*a398);
  a384=(a384+a428);
  a428=(a386*a091);
  a410=(a054*a444);
  a428=(a428-a410);
  a384=(a384+a428);
  a428=(a052*a384);
  a420=(a420+a428);
  a420=(a436+a420);
  a428=(a381*a420);
  a410=(a050*a418);
  a393=(a392*a393);
  a398=(a082*a398);
  a393=(a393+a398);
  a398=(a399*a444);
  a373=(a395*a091);
  a398=(a398-a373);
  a393=(a393+a398);
  a398=(a052*a393);
  a410=(a410+a398);
  a410=(a361+a410);
  a398=(a118*a410);
  a428=(a428-a398);
  a401=(a401+a428);
  a428=(a049*a401);
  a422=(a422+a428);
  a428=(a130*a361);
  a091=(a132*a091);
  a428=(a428+a091);
  a091=(a133*a410);
  a428=(a428+a091);
  a428=(a368+a428);
  a091=(a396*a428);
  a398=(a130*a436);
  a444=(a132*a444);
  a398=(a398+a444);
  a444=(a133*a420);
  a398=(a398+a444);
  a398=(a442+a398);
  a444=(a153*a398);
  a091=(a091+a444);
  a444=(a130*a385);
  a384=(a132*a384);
  a444=(a444+a384);
  a402=(a371*a402);
  a406=(a388*a406);
  a402=(a402+a406);
  a406=(a106*a410);
  a384=(a376*a420);
  a406=(a406-a384);
  a402=(a402+a406);
  a406=(a133*a402);
  a444=(a444+a406);
  a444=(a436+a444);
  a406=(a135*a444);
  a384=(a130*a418);
  a393=(a132*a393);
  a384=(a384+a393);
  a393=(a133*a401);
  a384=(a384+a393);
  a384=(a361+a384);
  a393=(a146*a384);
  a406=(a406-a393);
  a091=(a091+a406);
  a406=(a129*a091);
  a422=(a422+a406);
  a422=(a361+a422);
  a406=(a005*a422);
  a372=(a372+a406);
  a406=(a158*a418);
  a393=(a160*a401);
  a406=(a406+a393);
  a393=(a161*a091);
  a406=(a406+a393);
  a393=(a006*a361);
  a373=(a049*a410);
  a393=(a393+a373);
  a373=(a129*a384);
  a393=(a393+a373);
  a393=(a368+a393);
  a373=(a383*a393);
  a364=(a006*a436);
  a408=(a049*a420);
  a364=(a364+a408);
  a408=(a129*a444);
  a364=(a364+a408);
  a364=(a442+a364);
  a408=(a183*a364);
  a373=(a373+a408);
  a408=(a006*a385);
  a351=(a049*a402);
  a408=(a408+a351);
  a428=(a087*a428);
  a398=(a397*a398);
  a428=(a428+a398);
  a398=(a137*a384);
  a351=(a104*a444);
  a398=(a398-a351);
  a428=(a428+a398);
  a398=(a129*a428);
  a408=(a408+a398);
  a408=(a436+a408);
  a398=(a403*a408);
  a351=(a176*a422);
  a398=(a398-a351);
  a373=(a373+a398);
  a398=(a162*a373);
  a406=(a406+a398);
  a406=(a361+a406);
  a398=(a157*a406);
  a372=(a372+a398);
  a398=(a188*a418);
  a351=(a190*a401);
  a398=(a398+a351);
  a351=(a191*a091);
  a398=(a398+a351);
  a351=(a192*a373);
  a398=(a398+a351);
  a351=(a158*a361);
  a414=(a160*a410);
  a351=(a351+a414);
  a414=(a161*a384);
  a351=(a351+a414);
  a414=(a162*a422);
  a351=(a351+a414);
  a351=(a368+a351);
  a414=(a409*a351);
  a010=(a158*a436);
  a416=(a160*a420);
  a010=(a010+a416);
  a416=(a161*a444);
  a010=(a010+a416);
  a416=(a162*a408);
  a010=(a010+a416);
  a010=(a442+a010);
  a416=(a214*a010);
  a414=(a414+a416);
  a416=(a158*a385);
  a446=(a160*a402);
  a416=(a416+a446);
  a446=(a161*a428);
  a416=(a416+a446);
  a393=(a400*a393);
  a364=(a405*a364);
  a393=(a393+a364);
  a364=(a048*a422);
  a446=(a165*a408);
  a364=(a364-a446);
  a393=(a393+a364);
  a364=(a162*a393);
  a416=(a416+a364);
  a416=(a436+a416);
  a364=(a411*a416);
  a446=(a207*a406);
  a364=(a364-a446);
  a414=(a414+a364);
  a364=(a193*a414);
  a398=(a398+a364);
  a398=(a361+a398);
  a364=(a187*a398);
  a372=(a372+a364);
  a364=(a219*a418);
  a446=(a221*a401);
  a364=(a364+a446);
  a446=(a222*a091);
  a364=(a364+a446);
  a446=(a223*a373);
  a364=(a364+a446);
  a446=(a224*a414);
  a364=(a364+a446);
  a446=(a188*a361);
  a439=(a190*a410);
  a446=(a446+a439);
  a439=(a191*a384);
  a446=(a446+a439);
  a439=(a192*a422);
  a446=(a446+a439);
  a439=(a193*a406);
  a446=(a446+a439);
  a446=(a368+a446);
  a439=(a417*a446);
  a375=(a188*a436);
  a440=(a190*a420);
  a375=(a375+a440);
  a440=(a191*a444);
  a375=(a375+a440);
  a440=(a192*a408);
  a375=(a375+a440);
  a440=(a193*a416);
  a375=(a375+a440);
  a375=(a442+a375);
  a440=(a246*a375);
  a439=(a439+a440);
  a440=(a188*a385);
  a432=(a190*a402);
  a440=(a440+a432);
  a432=(a191*a428);
  a440=(a440+a432);
  a432=(a192*a393);
  a440=(a440+a432);
  a351=(a407*a351);
  a010=(a413*a010);
  a351=(a351+a010);
  a010=(a159*a406);
  a432=(a196*a416);
  a010=(a010-a432);
  a351=(a351+a010);
  a010=(a193*a351);
  a440=(a440+a010);
  a440=(a436+a440);
  a010=(a419*a440);
  a432=(a239*a398);
  a010=(a010-a432);
  a439=(a439+a010);
  a010=(a225*a439);
  a364=(a364+a010);
  a364=(a361+a364);
  a010=(a218*a364);
  a372=(a372+a010);
  a010=(a251*a418);
  a432=(a253*a401);
  a010=(a010+a432);
  a432=(a254*a091);
  a010=(a010+a432);
  a432=(a255*a373);
  a010=(a010+a432);
  a432=(a256*a414);
  a010=(a010+a432);
  a432=(a257*a439);
  a010=(a010+a432);
  a432=(a219*a361);
  a362=(a221*a410);
  a432=(a432+a362);
  a362=(a222*a384);
  a432=(a432+a362);
  a362=(a223*a422);
  a432=(a432+a362);
  a362=(a224*a406);
  a432=(a432+a362);
  a362=(a225*a398);
  a432=(a432+a362);
  a432=(a368+a432);
  a362=(a425*a432);
  a387=(a219*a436);
  a389=(a221*a420);
  a387=(a387+a389);
  a389=(a222*a444);
  a387=(a387+a389);
  a389=(a223*a408);
  a387=(a387+a389);
  a389=(a224*a416);
  a387=(a387+a389);
  a389=(a225*a440);
  a387=(a387+a389);
  a387=(a442+a387);
  a389=(a279*a387);
  a362=(a362+a389);
  a389=(a219*a385);
  a390=(a221*a402);
  a389=(a389+a390);
  a390=(a222*a428);
  a389=(a389+a390);
  a390=(a223*a393);
  a389=(a389+a390);
  a390=(a224*a351);
  a389=(a389+a390);
  a446=(a415*a446);
  a375=(a421*a375);
  a446=(a446+a375);
  a375=(a189*a398);
  a390=(a228*a440);
  a375=(a375-a390);
  a446=(a446+a375);
  a375=(a225*a446);
  a389=(a389+a375);
  a389=(a436+a389);
  a375=(a427*a389);
  a390=(a272*a364);
  a375=(a375-a390);
  a362=(a362+a375);
  a375=(a258*a362);
  a010=(a010+a375);
  a010=(a361+a010);
  a375=(a250*a010);
  a372=(a372+a375);
  a375=(a284*a418);
  a390=(a286*a401);
  a375=(a375+a390);
  a390=(a287*a091);
  a375=(a375+a390);
  a390=(a288*a373);
  a375=(a375+a390);
  a390=(a289*a414);
  a375=(a375+a390);
  a390=(a290*a439);
  a375=(a375+a390);
  a390=(a291*a362);
  a375=(a375+a390);
  a390=(a251*a361);
  a424=(a253*a410);
  a390=(a390+a424);
  a424=(a254*a384);
  a390=(a390+a424);
  a424=(a255*a422);
  a390=(a390+a424);
  a424=(a256*a406);
  a390=(a390+a424);
  a424=(a257*a398);
  a390=(a390+a424);
  a424=(a258*a364);
  a390=(a390+a424);
  a390=(a368+a390);
  a424=(a433*a390);
  a047=(a251*a436);
  a370=(a253*a420);
  a047=(a047+a370);
  a370=(a254*a444);
  a047=(a047+a370);
  a370=(a255*a408);
  a047=(a047+a370);
  a370=(a256*a416);
  a047=(a047+a370);
  a370=(a257*a440);
  a047=(a047+a370);
  a370=(a258*a389);
  a047=(a047+a370);
  a047=(a442+a047);
  a370=(a313*a047);
  a424=(a424+a370);
  a370=(a251*a385);
  a363=(a253*a402);
  a370=(a370+a363);
  a363=(a254*a428);
  a370=(a370+a363);
  a363=(a255*a393);
  a370=(a370+a363);
  a363=(a256*a351);
  a370=(a370+a363);
  a363=(a257*a446);
  a370=(a370+a363);
  a432=(a423*a432);
  a387=(a429*a387);
  a432=(a432+a387);
  a387=(a220*a364);
  a363=(a261*a389);
  a387=(a387-a363);
  a432=(a432+a387);
  a387=(a258*a432);
  a370=(a370+a387);
  a370=(a436+a370);
  a387=(a435*a370);
  a363=(a306*a010);
  a387=(a387-a363);
  a424=(a424+a387);
  a387=(a292*a424);
  a375=(a375+a387);
  a375=(a361+a375);
  a387=(a283*a375);
  a372=(a372+a387);
  a387=(a318*a418);
  a401=(a320*a401);
  a387=(a387+a401);
  a091=(a128*a091);
  a387=(a387+a091);
  a091=(a156*a373);
  a387=(a387+a091);
  a091=(a321*a414);
  a387=(a387+a091);
  a091=(a322*a439);
  a387=(a387+a091);
  a091=(a323*a362);
  a387=(a387+a091);
  a091=(a324*a424);
  a387=(a387+a091);
  a091=(a284*a361);
  a401=(a286*a410);
  a091=(a091+a401);
  a401=(a287*a384);
  a091=(a091+a401);
  a401=(a288*a422);
  a091=(a091+a401);
  a401=(a289*a406);
  a091=(a091+a401);
  a401=(a290*a398);
  a091=(a091+a401);
  a401=(a291*a364);
  a091=(a091+a401);
  a401=(a292*a010);
  a091=(a091+a401);
  a091=(a368+a091);
  a401=(a438*a091);
  a363=(a284*a436);
  a430=(a286*a420);
  a363=(a363+a430);
  a430=(a287*a444);
  a363=(a363+a430);
  a430=(a288*a408);
  a363=(a363+a430);
  a430=(a289*a416);
  a363=(a363+a430);
  a430=(a290*a440);
  a363=(a363+a430);
  a430=(a291*a389);
  a363=(a363+a430);
  a430=(a292*a370);
  a363=(a363+a430);
  a363=(a442+a363);
  a430=(a345*a363);
  a401=(a401+a430);
  a430=(a284*a385);
  a445=(a286*a402);
  a430=(a430+a445);
  a445=(a287*a428);
  a430=(a430+a445);
  a445=(a288*a393);
  a430=(a430+a445);
  a445=(a289*a351);
  a430=(a430+a445);
  a445=(a290*a446);
  a430=(a430+a445);
  a445=(a291*a432);
  a430=(a430+a445);
  a390=(a431*a390);
  a047=(a437*a047);
  a390=(a390+a047);
  a047=(a252*a010);
  a445=(a295*a370);
  a047=(a047-a445);
  a390=(a390+a047);
  a047=(a292*a390);
  a430=(a430+a047);
  a430=(a436+a430);
  a047=(a441*a430);
  a445=(a338*a375);
  a047=(a047-a445);
  a401=(a401+a047);
  a047=(a325*a401);
  a387=(a387+a047);
  a387=(a361+a387);
  a047=(a317*a387);
  a372=(a372+a047);
  a372=(a368+a372);
  if (res[0]!=0) res[0][12]=a372;
  a372=(a001*a436);
  a047=(a005*a408);
  a372=(a372+a047);
  a047=(a157*a416);
  a372=(a372+a047);
  a047=(a187*a440);
  a372=(a372+a047);
  a047=(a218*a389);
  a372=(a372+a047);
  a047=(a250*a370);
  a372=(a372+a047);
  a047=(a283*a430);
  a372=(a372+a047);
  a047=(a318*a385);
  a402=(a320*a402);
  a047=(a047+a402);
  a428=(a128*a428);
  a047=(a047+a428);
  a428=(a156*a393);
  a047=(a047+a428);
  a428=(a321*a351);
  a047=(a047+a428);
  a428=(a322*a446);
  a047=(a047+a428);
  a428=(a323*a432);
  a047=(a047+a428);
  a428=(a324*a390);
  a047=(a047+a428);
  a091=(a379*a091);
  a363=(a443*a363);
  a091=(a091+a363);
  a363=(a285*a375);
  a428=(a327*a430);
  a363=(a363-a428);
  a091=(a091+a363);
  a363=(a325*a091);
  a047=(a047+a363);
  a047=(a436+a047);
  a363=(a317*a047);
  a372=(a372+a363);
  a372=(a442+a372);
  if (res[0]!=0) res[0][13]=a372;
  a418=(a001*a418);
  a373=(a005*a373);
  a418=(a418+a373);
  a414=(a157*a414);
  a418=(a418+a414);
  a439=(a187*a439);
  a418=(a418+a439);
  a362=(a218*a362);
  a418=(a418+a362);
  a424=(a250*a424);
  a418=(a418+a424);
  a401=(a283*a401);
  a418=(a418+a401);
  a401=(a318*a361);
  a410=(a320*a410);
  a401=(a401+a410);
  a384=(a128*a384);
  a401=(a401+a384);
  a422=(a156*a422);
  a401=(a401+a422);
  a406=(a321*a406);
  a401=(a401+a406);
  a398=(a322*a398);
  a401=(a401+a398);
  a364=(a323*a364);
  a401=(a401+a364);
  a010=(a324*a010);
  a401=(a401+a010);
  a375=(a325*a375);
  a401=(a401+a375);
  a368=(a368+a401);
  a401=(a426*a368);
  a375=(a318*a436);
  a420=(a320*a420);
  a375=(a375+a420);
  a444=(a128*a444);
  a375=(a375+a444);
  a408=(a156*a408);
  a375=(a375+a408);
  a416=(a321*a416);
  a375=(a375+a416);
  a440=(a322*a440);
  a375=(a375+a440);
  a389=(a323*a389);
  a375=(a375+a389);
  a370=(a324*a370);
  a375=(a375+a370);
  a430=(a325*a430);
  a375=(a375+a430);
  a442=(a442+a375);
  a375=(a358*a442);
  a401=(a401+a375);
  a375=(a028*a047);
  a430=(a026*a387);
  a375=(a375-a430);
  a401=(a401+a375);
  a401=(a317*a401);
  a418=(a418+a401);
  a361=(a361+a418);
  if (res[0]!=0) res[0][14]=a361;
  a385=(a001*a385);
  a393=(a005*a393);
  a385=(a385+a393);
  a351=(a157*a351);
  a385=(a385+a351);
  a446=(a187*a446);
  a385=(a385+a446);
  a432=(a218*a432);
  a385=(a385+a432);
  a390=(a250*a390);
  a385=(a385+a390);
  a091=(a283*a091);
  a385=(a385+a091);
  a368=(a434*a368);
  a442=(a404*a442);
  a368=(a368+a442);
  a387=(a319*a387);
  a047=(a412*a047);
  a387=(a387-a047);
  a368=(a368+a387);
  a368=(a317*a368);
  a385=(a385+a368);
  a436=(a436+a385);
  if (res[0]!=0) res[0][15]=a436;
  a436=arg[0]? arg[0][16] : 0;
  a385=arg[0]? arg[0][18] : 0;
  a368=(a001*a385);
  a366=(a366*a436);
  a387=arg[0]? arg[0][17] : 0;
  a043=(a043*a387);
  a366=(a366+a043);
  a043=arg[0]? arg[0][19] : 0;
  a367=(a367*a043);
  a036=(a036*a385);
  a367=(a367-a036);
  a366=(a366+a367);
  a367=arg[6]? arg[6][1] : 0;
  a008=(a008*a367);
  a011=(a011*a008);
  a011=(a011/a013);
  a009=(a009/a013);
  a009=(a009*a367);
  a011=(a011-a009);
  a014=(a014*a011);
  a018=(a018*a367);
  a011=arg[6]? arg[6][2] : 0;
  a017=(a017*a011);
  a009=(a007*a017);
  a018=(a018+a009);
  a018=(a018/a013);
  a019=(a019/a013);
  a019=(a019*a367);
  a018=(a018-a019);
  a014=(a014+a018);
  a023=(a023*a011);
  a021=(a021*a023);
  a020=(a020*a011);
  a024=(a024*a020);
  a021=(a021+a024);
  a021=(a027*a021);
  a024=(a367/a013);
  a018=(a025/a013);
  a018=(a018*a367);
  a024=(a024-a018);
  a018=arg[6]? arg[6][0] : 0;
  a019=(a024-a018);
  a022=(a022*a019);
  a021=(a021+a022);
  a014=(a014+a021);
  a021=(a014/a037);
  a038=(a038/a037);
  a022=(2.*a367);
  a009=(a007*a022);
  a029=(a029*a367);
  a009=(a009+a029);
  a009=(a009/a032);
  a030=(a030/a032);
  a032=(a029+a022);
  a030=(a030*a032);
  a009=(a009-a030);
  a022=(a022/a013);
  a033=(a033/a013);
  a033=(a033*a367);
  a022=(a022-a033);
  a035=(a035*a022);
  a035=(a009-a035);
  a035=(a035+a018);
  a038=(a038*a035);
  a021=(a021-a038);
  a039=(a039*a024);
  a038=(a025*a024);
  a039=(a039-a038);
  a033=(a039/a037);
  a037=(a041/a037);
  a037=(a037*a035);
  a033=(a033-a037);
  a037=(a044*a033);
  a042=(a042*a024);
  a017=(a025*a017);
  a042=(a042-a017);
  a015=(a015*a033);
  a014=(a041*a014);
  a015=(a015+a014);
  a042=(a042-a015);
  a042=(a042/a046);
  a044=(a044/a046);
  a029=(a029/a045);
  a031=(a031/a045);
  a045=(2.*a013);
  a045=(a045*a367);
  a031=(a031*a045);
  a029=(a029-a031);
  a039=(a041*a039);
  a040=(a040*a033);
  a039=(a039+a040);
  a039=(a029-a039);
  a044=(a044*a039);
  a042=(a042-a044);
  a041=(a041*a042);
  a037=(a037+a041);
  a021=(a021-a037);
  a366=(a366+a021);
  a021=(a006*a366);
  a037=(a050*a385);
  a041=(a053*a366);
  a044=(a056*a385);
  a044=(a436+a044);
  a378=(a378*a044);
  a039=(a056*a043);
  a039=(a387+a039);
  a078=(a078*a039);
  a378=(a378+a078);
  a365=(a365*a436);
  a369=(a369*a387);
  a365=(a365+a369);
  a003=(a003*a385);
  a034=(a034*a043);
  a003=(a003-a034);
  a365=(a365+a003);
  a365=(a365+a042);
  a042=(a056*a365);
  a042=(a043+a042);
  a380=(a380*a042);
  a056=(a056*a366);
  a056=(a385+a056);
  a071=(a071*a056);
  a380=(a380-a071);
  a378=(a378+a380);
  a057=(a057*a367);
  a060=(a060*a057);
  a060=(a060/a013);
  a058=(a058/a013);
  a058=(a058*a367);
  a060=(a060-a058);
  a062=(a062*a060);
  a066=(a066*a367);
  a065=(a065*a011);
  a060=(a007*a065);
  a066=(a066+a060);
  a066=(a066/a013);
  a067=(a067/a013);
  a067=(a067*a367);
  a066=(a066-a067);
  a062=(a062+a066);
  a068=(a068*a023);
  a064=(a064*a020);
  a068=(a068+a064);
  a068=(a027*a068);
  a069=(a069*a019);
  a068=(a068+a069);
  a062=(a062+a068);
  a068=(a062/a072);
  a073=(a073/a072);
  a070=(a070*a022);
  a070=(a009-a070);
  a070=(a070+a018);
  a073=(a073*a070);
  a068=(a068-a073);
  a074=(a074*a024);
  a074=(a074-a038);
  a073=(a074/a072);
  a072=(a076/a072);
  a072=(a072*a070);
  a073=(a073-a072);
  a072=(a079*a073);
  a077=(a077*a024);
  a065=(a025*a065);
  a077=(a077-a065);
  a063=(a063*a073);
  a062=(a076*a062);
  a063=(a063+a062);
  a077=(a077-a063);
  a077=(a077/a080);
  a079=(a079/a080);
  a074=(a076*a074);
  a075=(a075*a073);
  a074=(a074+a075);
  a074=(a029-a074);
  a079=(a079*a074);
  a077=(a077-a079);
  a076=(a076*a077);
  a072=(a072+a076);
  a068=(a068-a072);
  a378=(a378+a068);
  a378=(a055*a378);
  a041=(a041+a378);
  a041=(a385+a041);
  a378=(a052*a041);
  a037=(a037+a378);
  a037=(a436+a037);
  a374=(a374*a037);
  a378=(a050*a043);
  a068=(a053*a365);
  a377=(a377*a044);
  a382=(a382*a039);
  a377=(a377+a382);
  a061=(a061*a056);
  a059=(a059*a042);
  a061=(a061-a059);
  a377=(a377+a061);
  a377=(a377+a077);
  a377=(a055*a377);
  a068=(a068+a377);
  a068=(a043+a068);
  a377=(a052*a068);
  a378=(a378+a377);
  a378=(a387+a378);
  a125=(a125*a378);
  a374=(a374+a125);
  a125=(a050*a365);
  a377=(a053*a385);
  a056=(a055*a056);
  a377=(a377+a056);
  a377=(a436+a377);
  a391=(a391*a377);
  a053=(a053*a043);
  a055=(a055*a042);
  a053=(a053+a055);
  a053=(a387+a053);
  a394=(a394*a053);
  a391=(a391+a394);
  a386=(a386*a041);
  a054=(a054*a068);
  a386=(a386-a054);
  a391=(a391+a386);
  a081=(a081*a024);
  a085=(a085*a011);
  a386=(a025*a085);
  a081=(a081-a386);
  a088=(a088*a024);
  a088=(a088-a038);
  a386=(a088/a092);
  a054=(a093/a092);
  a090=(a090*a022);
  a090=(a009-a090);
  a090=(a090+a018);
  a054=(a054*a090);
  a386=(a386-a054);
  a097=(a097*a386);
  a094=(a094*a367);
  a083=(a083*a094);
  a083=(a083/a013);
  a095=(a095/a013);
  a095=(a095*a367);
  a083=(a083-a095);
  a096=(a096*a083);
  a086=(a086*a367);
  a085=(a007*a085);
  a086=(a086+a085);
  a086=(a086/a013);
  a098=(a098/a013);
  a098=(a098*a367);
  a086=(a086-a098);
  a096=(a096+a086);
  a099=(a099*a023);
  a084=(a084*a020);
  a099=(a099+a084);
  a099=(a027*a099);
  a100=(a100*a019);
  a099=(a099+a100);
  a096=(a096+a099);
  a099=(a093*a096);
  a097=(a097+a099);
  a081=(a081-a097);
  a081=(a081/a102);
  a102=(a101/a102);
  a088=(a093*a088);
  a089=(a089*a386);
  a088=(a088+a089);
  a088=(a029-a088);
  a102=(a102*a088);
  a081=(a081-a102);
  a391=(a391+a081);
  a102=(a052*a391);
  a125=(a125+a102);
  a125=(a043+a125);
  a381=(a381*a125);
  a050=(a050*a366);
  a392=(a392*a377);
  a082=(a082*a053);
  a392=(a392+a082);
  a399=(a399*a068);
  a395=(a395*a041);
  a399=(a399-a395);
  a392=(a392+a399);
  a096=(a096/a092);
  a107=(a107/a092);
  a107=(a107*a090);
  a096=(a096-a107);
  a101=(a101*a386);
  a093=(a093*a081);
  a101=(a101+a093);
  a096=(a096-a101);
  a392=(a392+a096);
  a052=(a052*a392);
  a050=(a050+a052);
  a050=(a385+a050);
  a118=(a118*a050);
  a381=(a381-a118);
  a374=(a374+a381);
  a051=(a051*a367);
  a105=(a105*a051);
  a105=(a105/a013);
  a103=(a103/a013);
  a103=(a103*a367);
  a105=(a105-a103);
  a109=(a109*a105);
  a113=(a113*a367);
  a112=(a112*a011);
  a105=(a007*a112);
  a113=(a113+a105);
  a113=(a113/a013);
  a114=(a114/a013);
  a114=(a114*a367);
  a113=(a113-a114);
  a109=(a109+a113);
  a115=(a115*a023);
  a111=(a111*a020);
  a115=(a115+a111);
  a115=(a027*a115);
  a116=(a116*a019);
  a115=(a115+a116);
  a109=(a109+a115);
  a115=(a109/a119);
  a120=(a120/a119);
  a117=(a117*a022);
  a117=(a009-a117);
  a117=(a117+a018);
  a120=(a120*a117);
  a115=(a115-a120);
  a121=(a121*a024);
  a121=(a121-a038);
  a120=(a121/a119);
  a119=(a123/a119);
  a119=(a119*a117);
  a120=(a120-a119);
  a119=(a126*a120);
  a124=(a124*a024);
  a112=(a025*a112);
  a124=(a124-a112);
  a110=(a110*a120);
  a109=(a123*a109);
  a110=(a110+a109);
  a124=(a124-a110);
  a124=(a124/a127);
  a126=(a126/a127);
  a121=(a123*a121);
  a122=(a122*a120);
  a121=(a121+a122);
  a121=(a029-a121);
  a126=(a126*a121);
  a124=(a124-a126);
  a123=(a123*a124);
  a119=(a119+a123);
  a115=(a115-a119);
  a374=(a374+a115);
  a115=(a049*a374);
  a021=(a021+a115);
  a115=(a130*a385);
  a041=(a132*a041);
  a115=(a115+a041);
  a041=(a133*a050);
  a115=(a115+a041);
  a115=(a436+a115);
  a396=(a396*a115);
  a041=(a130*a043);
  a068=(a132*a068);
  a041=(a041+a068);
  a068=(a133*a125);
  a041=(a041+a068);
  a041=(a387+a041);
  a153=(a153*a041);
  a396=(a396+a153);
  a153=(a130*a365);
  a391=(a132*a391);
  a153=(a153+a391);
  a371=(a371*a037);
  a388=(a388*a378);
  a371=(a371+a388);
  a106=(a106*a050);
  a376=(a376*a125);
  a106=(a106-a376);
  a371=(a371+a106);
  a371=(a371+a124);
  a124=(a133*a371);
  a153=(a153+a124);
  a153=(a043+a153);
  a135=(a135*a153);
  a130=(a130*a366);
  a132=(a132*a392);
  a130=(a130+a132);
  a133=(a133*a374);
  a130=(a130+a133);
  a130=(a385+a130);
  a146=(a146*a130);
  a135=(a135-a146);
  a396=(a396+a135);
  a131=(a131*a367);
  a136=(a136*a131);
  a136=(a136/a013);
  a134=(a134/a013);
  a134=(a134*a367);
  a136=(a136-a134);
  a108=(a108*a136);
  a141=(a141*a367);
  a140=(a140*a011);
  a136=(a007*a140);
  a141=(a141+a136);
  a141=(a141/a013);
  a142=(a142/a013);
  a142=(a142*a367);
  a141=(a141-a142);
  a108=(a108+a141);
  a143=(a143*a023);
  a139=(a139*a020);
  a143=(a143+a139);
  a143=(a027*a143);
  a144=(a144*a019);
  a143=(a143+a144);
  a108=(a108+a143);
  a143=(a108/a147);
  a148=(a148/a147);
  a145=(a145*a022);
  a145=(a009-a145);
  a145=(a145+a018);
  a148=(a148*a145);
  a143=(a143-a148);
  a149=(a149*a024);
  a149=(a149-a038);
  a148=(a149/a147);
  a147=(a151/a147);
  a147=(a147*a145);
  a148=(a148-a147);
  a147=(a154*a148);
  a152=(a152*a024);
  a140=(a025*a140);
  a152=(a152-a140);
  a138=(a138*a148);
  a108=(a151*a108);
  a138=(a138+a108);
  a152=(a152-a138);
  a152=(a152/a155);
  a154=(a154/a155);
  a149=(a151*a149);
  a150=(a150*a148);
  a149=(a149+a150);
  a149=(a029-a149);
  a154=(a154*a149);
  a152=(a152-a154);
  a151=(a151*a152);
  a147=(a147+a151);
  a143=(a143-a147);
  a396=(a396+a143);
  a143=(a129*a396);
  a021=(a021+a143);
  a021=(a385+a021);
  a143=(a005*a021);
  a368=(a368+a143);
  a143=(a158*a366);
  a147=(a160*a374);
  a143=(a143+a147);
  a147=(a161*a396);
  a143=(a143+a147);
  a147=(a006*a385);
  a151=(a049*a050);
  a147=(a147+a151);
  a151=(a129*a130);
  a147=(a147+a151);
  a147=(a436+a147);
  a383=(a383*a147);
  a151=(a006*a043);
  a154=(a049*a125);
  a151=(a151+a154);
  a154=(a129*a153);
  a151=(a151+a154);
  a151=(a387+a151);
  a183=(a183*a151);
  a383=(a383+a183);
  a006=(a006*a365);
  a049=(a049*a371);
  a006=(a006+a049);
  a087=(a087*a115);
  a397=(a397*a041);
  a087=(a087+a397);
  a137=(a137*a130);
  a104=(a104*a153);
  a137=(a137-a104);
  a087=(a087+a137);
  a087=(a087+a152);
  a129=(a129*a087);
  a006=(a006+a129);
  a006=(a043+a006);
  a403=(a403*a006);
  a176=(a176*a021);
  a403=(a403-a176);
  a383=(a383+a403);
  a163=(a163*a367);
  a166=(a166*a163);
  a166=(a166/a013);
  a164=(a164/a013);
  a164=(a164*a367);
  a166=(a166-a164);
  a167=(a167*a166);
  a171=(a171*a367);
  a170=(a170*a011);
  a166=(a007*a170);
  a171=(a171+a166);
  a171=(a171/a013);
  a172=(a172/a013);
  a172=(a172*a367);
  a171=(a171-a172);
  a167=(a167+a171);
  a173=(a173*a023);
  a169=(a169*a020);
  a173=(a173+a169);
  a173=(a027*a173);
  a174=(a174*a019);
  a173=(a173+a174);
  a167=(a167+a173);
  a173=(a167/a177);
  a178=(a178/a177);
  a175=(a175*a022);
  a175=(a009-a175);
  a175=(a175+a018);
  a178=(a178*a175);
  a173=(a173-a178);
  a179=(a179*a024);
  a179=(a179-a038);
  a178=(a179/a177);
  a177=(a181/a177);
  a177=(a177*a175);
  a178=(a178-a177);
  a177=(a184*a178);
  a182=(a182*a024);
  a170=(a025*a170);
  a182=(a182-a170);
  a168=(a168*a178);
  a167=(a181*a167);
  a168=(a168+a167);
  a182=(a182-a168);
  a182=(a182/a185);
  a184=(a184/a185);
  a179=(a181*a179);
  a180=(a180*a178);
  a179=(a179+a180);
  a179=(a029-a179);
  a184=(a184*a179);
  a182=(a182-a184);
  a181=(a181*a182);
  a177=(a177+a181);
  a173=(a173-a177);
  a383=(a383+a173);
  a173=(a162*a383);
  a143=(a143+a173);
  a143=(a385+a143);
  a173=(a157*a143);
  a368=(a368+a173);
  a173=(a188*a366);
  a177=(a190*a374);
  a173=(a173+a177);
  a177=(a191*a396);
  a173=(a173+a177);
  a177=(a192*a383);
  a173=(a173+a177);
  a177=(a158*a385);
  a181=(a160*a050);
  a177=(a177+a181);
  a181=(a161*a130);
  a177=(a177+a181);
  a181=(a162*a021);
  a177=(a177+a181);
  a177=(a436+a177);
  a409=(a409*a177);
  a181=(a158*a043);
  a184=(a160*a125);
  a181=(a181+a184);
  a184=(a161*a153);
  a181=(a181+a184);
  a184=(a162*a006);
  a181=(a181+a184);
  a181=(a387+a181);
  a214=(a214*a181);
  a409=(a409+a214);
  a158=(a158*a365);
  a160=(a160*a371);
  a158=(a158+a160);
  a161=(a161*a087);
  a158=(a158+a161);
  a400=(a400*a147);
  a405=(a405*a151);
  a400=(a400+a405);
  a048=(a048*a021);
  a165=(a165*a006);
  a048=(a048-a165);
  a400=(a400+a048);
  a400=(a400+a182);
  a162=(a162*a400);
  a158=(a158+a162);
  a158=(a043+a158);
  a411=(a411*a158);
  a207=(a207*a143);
  a411=(a411-a207);
  a409=(a409+a411);
  a194=(a194*a367);
  a197=(a197*a194);
  a197=(a197/a013);
  a195=(a195/a013);
  a195=(a195*a367);
  a197=(a197-a195);
  a198=(a198*a197);
  a202=(a202*a367);
  a201=(a201*a011);
  a197=(a007*a201);
  a202=(a202+a197);
  a202=(a202/a013);
  a203=(a203/a013);
  a203=(a203*a367);
  a202=(a202-a203);
  a198=(a198+a202);
  a204=(a204*a023);
  a200=(a200*a020);
  a204=(a204+a200);
  a204=(a027*a204);
  a205=(a205*a019);
  a204=(a204+a205);
  a198=(a198+a204);
  a204=(a198/a208);
  a209=(a209/a208);
  a206=(a206*a022);
  a206=(a009-a206);
  a206=(a206+a018);
  a209=(a209*a206);
  a204=(a204-a209);
  a210=(a210*a024);
  a210=(a210-a038);
  a209=(a210/a208);
  a208=(a212/a208);
  a208=(a208*a206);
  a209=(a209-a208);
  a208=(a215*a209);
  a213=(a213*a024);
  a201=(a025*a201);
  a213=(a213-a201);
  a199=(a199*a209);
  a198=(a212*a198);
  a199=(a199+a198);
  a213=(a213-a199);
  a213=(a213/a216);
  a215=(a215/a216);
  a210=(a212*a210);
  a211=(a211*a209);
  a210=(a210+a211);
  a210=(a029-a210);
  a215=(a215*a210);
  a213=(a213-a215);
  a212=(a212*a213);
  a208=(a208+a212);
  a204=(a204-a208);
  a409=(a409+a204);
  a204=(a193*a409);
  a173=(a173+a204);
  a173=(a385+a173);
  a204=(a187*a173);
  a368=(a368+a204);
  a204=(a219*a366);
  a208=(a221*a374);
  a204=(a204+a208);
  a208=(a222*a396);
  a204=(a204+a208);
  a208=(a223*a383);
  a204=(a204+a208);
  a208=(a224*a409);
  a204=(a204+a208);
  a208=(a188*a385);
  a212=(a190*a050);
  a208=(a208+a212);
  a212=(a191*a130);
  a208=(a208+a212);
  a212=(a192*a021);
  a208=(a208+a212);
  a212=(a193*a143);
  a208=(a208+a212);
  a208=(a436+a208);
  a417=(a417*a208);
  a212=(a188*a043);
  a215=(a190*a125);
  a212=(a212+a215);
  a215=(a191*a153);
  a212=(a212+a215);
  a215=(a192*a006);
  a212=(a212+a215);
  a215=(a193*a158);
  a212=(a212+a215);
  a212=(a387+a212);
  a246=(a246*a212);
  a417=(a417+a246);
  a188=(a188*a365);
  a190=(a190*a371);
  a188=(a188+a190);
  a191=(a191*a087);
  a188=(a188+a191);
  a192=(a192*a400);
  a188=(a188+a192);
  a407=(a407*a177);
  a413=(a413*a181);
  a407=(a407+a413);
  a159=(a159*a143);
  a196=(a196*a158);
  a159=(a159-a196);
  a407=(a407+a159);
  a407=(a407+a213);
  a193=(a193*a407);
  a188=(a188+a193);
  a188=(a043+a188);
  a419=(a419*a188);
  a239=(a239*a173);
  a419=(a419-a239);
  a417=(a417+a419);
  a226=(a226*a367);
  a229=(a229*a226);
  a229=(a229/a013);
  a227=(a227/a013);
  a227=(a227*a367);
  a229=(a229-a227);
  a230=(a230*a229);
  a234=(a234*a367);
  a233=(a233*a011);
  a229=(a007*a233);
  a234=(a234+a229);
  a234=(a234/a013);
  a235=(a235/a013);
  a235=(a235*a367);
  a234=(a234-a235);
  a230=(a230+a234);
  a236=(a236*a023);
  a232=(a232*a020);
  a236=(a236+a232);
  a236=(a027*a236);
  a237=(a237*a019);
  a236=(a236+a237);
  a230=(a230+a236);
  a236=(a230/a240);
  a241=(a241/a240);
  a238=(a238*a022);
  a238=(a009-a238);
  a238=(a238+a018);
  a241=(a241*a238);
  a236=(a236-a241);
  a242=(a242*a024);
  a242=(a242-a038);
  a241=(a242/a240);
  a240=(a244/a240);
  a240=(a240*a238);
  a241=(a241-a240);
  a240=(a247*a241);
  a245=(a245*a024);
  a233=(a025*a233);
  a245=(a245-a233);
  a231=(a231*a241);
  a230=(a244*a230);
  a231=(a231+a230);
  a245=(a245-a231);
  a245=(a245/a248);
  a247=(a247/a248);
  a242=(a244*a242);
  a243=(a243*a241);
  a242=(a242+a243);
  a242=(a029-a242);
  a247=(a247*a242);
  a245=(a245-a247);
  a244=(a244*a245);
  a240=(a240+a244);
  a236=(a236-a240);
  a417=(a417+a236);
  a236=(a225*a417);
  a204=(a204+a236);
  a204=(a385+a204);
  a236=(a218*a204);
  a368=(a368+a236);
  a236=(a251*a366);
  a240=(a253*a374);
  a236=(a236+a240);
  a240=(a254*a396);
  a236=(a236+a240);
  a240=(a255*a383);
  a236=(a236+a240);
  a240=(a256*a409);
  a236=(a236+a240);
  a240=(a257*a417);
  a236=(a236+a240);
  a240=(a219*a385);
  a244=(a221*a050);
  a240=(a240+a244);
  a244=(a222*a130);
  a240=(a240+a244);
  a244=(a223*a021);
  a240=(a240+a244);
  a244=(a224*a143);
  a240=(a240+a244);
  a244=(a225*a173);
  a240=(a240+a244);
  a240=(a436+a240);
  a425=(a425*a240);
  a244=(a219*a043);
  a247=(a221*a125);
  a244=(a244+a247);
  a247=(a222*a153);
  a244=(a244+a247);
  a247=(a223*a006);
  a244=(a244+a247);
  a247=(a224*a158);
  a244=(a244+a247);
  a247=(a225*a188);
  a244=(a244+a247);
  a244=(a387+a244);
  a279=(a279*a244);
  a425=(a425+a279);
  a219=(a219*a365);
  a221=(a221*a371);
  a219=(a219+a221);
  a222=(a222*a087);
  a219=(a219+a222);
  a223=(a223*a400);
  a219=(a219+a223);
  a224=(a224*a407);
  a219=(a219+a224);
  a415=(a415*a208);
  a421=(a421*a212);
  a415=(a415+a421);
  a189=(a189*a173);
  a228=(a228*a188);
  a189=(a189-a228);
  a415=(a415+a189);
  a415=(a415+a245);
  a225=(a225*a415);
  a219=(a219+a225);
  a219=(a043+a219);
  a427=(a427*a219);
  a272=(a272*a204);
  a427=(a427-a272);
  a425=(a425+a427);
  a259=(a259*a367);
  a262=(a262*a259);
  a262=(a262/a013);
  a260=(a260/a013);
  a260=(a260*a367);
  a262=(a262-a260);
  a263=(a263*a262);
  a267=(a267*a367);
  a266=(a266*a011);
  a262=(a007*a266);
  a267=(a267+a262);
  a267=(a267/a013);
  a268=(a268/a013);
  a268=(a268*a367);
  a267=(a267-a268);
  a263=(a263+a267);
  a269=(a269*a023);
  a265=(a265*a020);
  a269=(a269+a265);
  a269=(a027*a269);
  a270=(a270*a019);
  a269=(a269+a270);
  a263=(a263+a269);
  a269=(a263/a273);
  a274=(a274/a273);
  a271=(a271*a022);
  a271=(a009-a271);
  a271=(a271+a018);
  a274=(a274*a271);
  a269=(a269-a274);
  a275=(a275*a024);
  a275=(a275-a038);
  a274=(a275/a273);
  a273=(a277/a273);
  a273=(a273*a271);
  a274=(a274-a273);
  a273=(a280*a274);
  a278=(a278*a024);
  a266=(a025*a266);
  a278=(a278-a266);
  a264=(a264*a274);
  a263=(a277*a263);
  a264=(a264+a263);
  a278=(a278-a264);
  a278=(a278/a281);
  a280=(a280/a281);
  a275=(a277*a275);
  a276=(a276*a274);
  a275=(a275+a276);
  a275=(a029-a275);
  a280=(a280*a275);
  a278=(a278-a280);
  a277=(a277*a278);
  a273=(a273+a277);
  a269=(a269-a273);
  a425=(a425+a269);
  a269=(a258*a425);
  a236=(a236+a269);
  a236=(a385+a236);
  a269=(a250*a236);
  a368=(a368+a269);
  a269=(a284*a366);
  a273=(a286*a374);
  a269=(a269+a273);
  a273=(a287*a396);
  a269=(a269+a273);
  a273=(a288*a383);
  a269=(a269+a273);
  a273=(a289*a409);
  a269=(a269+a273);
  a273=(a290*a417);
  a269=(a269+a273);
  a273=(a291*a425);
  a269=(a269+a273);
  a273=(a251*a385);
  a277=(a253*a050);
  a273=(a273+a277);
  a277=(a254*a130);
  a273=(a273+a277);
  a277=(a255*a021);
  a273=(a273+a277);
  a277=(a256*a143);
  a273=(a273+a277);
  a277=(a257*a173);
  a273=(a273+a277);
  a277=(a258*a204);
  a273=(a273+a277);
  a273=(a436+a273);
  a433=(a433*a273);
  a277=(a251*a043);
  a280=(a253*a125);
  a277=(a277+a280);
  a280=(a254*a153);
  a277=(a277+a280);
  a280=(a255*a006);
  a277=(a277+a280);
  a280=(a256*a158);
  a277=(a277+a280);
  a280=(a257*a188);
  a277=(a277+a280);
  a280=(a258*a219);
  a277=(a277+a280);
  a277=(a387+a277);
  a313=(a313*a277);
  a433=(a433+a313);
  a251=(a251*a365);
  a253=(a253*a371);
  a251=(a251+a253);
  a254=(a254*a087);
  a251=(a251+a254);
  a255=(a255*a400);
  a251=(a251+a255);
  a256=(a256*a407);
  a251=(a251+a256);
  a257=(a257*a415);
  a251=(a251+a257);
  a423=(a423*a240);
  a429=(a429*a244);
  a423=(a423+a429);
  a220=(a220*a204);
  a261=(a261*a219);
  a220=(a220-a261);
  a423=(a423+a220);
  a423=(a423+a278);
  a258=(a258*a423);
  a251=(a251+a258);
  a251=(a043+a251);
  a435=(a435*a251);
  a306=(a306*a236);
  a435=(a435-a306);
  a433=(a433+a435);
  a293=(a293*a367);
  a296=(a296*a293);
  a296=(a296/a013);
  a294=(a294/a013);
  a294=(a294*a367);
  a296=(a296-a294);
  a297=(a297*a296);
  a301=(a301*a367);
  a300=(a300*a011);
  a296=(a007*a300);
  a301=(a301+a296);
  a301=(a301/a013);
  a302=(a302/a013);
  a302=(a302*a367);
  a301=(a301-a302);
  a297=(a297+a301);
  a303=(a303*a023);
  a299=(a299*a020);
  a303=(a303+a299);
  a303=(a027*a303);
  a304=(a304*a019);
  a303=(a303+a304);
  a297=(a297+a303);
  a303=(a297/a307);
  a308=(a308/a307);
  a305=(a305*a022);
  a305=(a009-a305);
  a305=(a305+a018);
  a308=(a308*a305);
  a303=(a303-a308);
  a309=(a309*a024);
  a309=(a309-a038);
  a308=(a309/a307);
  a307=(a311/a307);
  a307=(a307*a305);
  a308=(a308-a307);
  a307=(a314*a308);
  a312=(a312*a024);
  a300=(a025*a300);
  a312=(a312-a300);
  a298=(a298*a308);
  a297=(a311*a297);
  a298=(a298+a297);
  a312=(a312-a298);
  a312=(a312/a315);
  a314=(a314/a315);
  a309=(a311*a309);
  a310=(a310*a308);
  a309=(a309+a310);
  a309=(a029-a309);
  a314=(a314*a309);
  a312=(a312-a314);
  a311=(a311*a312);
  a307=(a307+a311);
  a303=(a303-a307);
  a433=(a433+a303);
  a303=(a292*a433);
  a269=(a269+a303);
  a269=(a385+a269);
  a303=(a283*a269);
  a368=(a368+a303);
  a303=(a318*a366);
  a374=(a320*a374);
  a303=(a303+a374);
  a396=(a128*a396);
  a303=(a303+a396);
  a396=(a156*a383);
  a303=(a303+a396);
  a396=(a321*a409);
  a303=(a303+a396);
  a396=(a322*a417);
  a303=(a303+a396);
  a396=(a323*a425);
  a303=(a303+a396);
  a396=(a324*a433);
  a303=(a303+a396);
  a396=(a284*a385);
  a374=(a286*a050);
  a396=(a396+a374);
  a374=(a287*a130);
  a396=(a396+a374);
  a374=(a288*a021);
  a396=(a396+a374);
  a374=(a289*a143);
  a396=(a396+a374);
  a374=(a290*a173);
  a396=(a396+a374);
  a374=(a291*a204);
  a396=(a396+a374);
  a374=(a292*a236);
  a396=(a396+a374);
  a396=(a436+a396);
  a438=(a438*a396);
  a374=(a284*a043);
  a307=(a286*a125);
  a374=(a374+a307);
  a307=(a287*a153);
  a374=(a374+a307);
  a307=(a288*a006);
  a374=(a374+a307);
  a307=(a289*a158);
  a374=(a374+a307);
  a307=(a290*a188);
  a374=(a374+a307);
  a307=(a291*a219);
  a374=(a374+a307);
  a307=(a292*a251);
  a374=(a374+a307);
  a374=(a387+a374);
  a345=(a345*a374);
  a438=(a438+a345);
  a284=(a284*a365);
  a286=(a286*a371);
  a284=(a284+a286);
  a287=(a287*a087);
  a284=(a284+a287);
  a288=(a288*a400);
  a284=(a284+a288);
  a289=(a289*a407);
  a284=(a284+a289);
  a290=(a290*a415);
  a284=(a284+a290);
  a291=(a291*a423);
  a284=(a284+a291);
  a431=(a431*a273);
  a437=(a437*a277);
  a431=(a431+a437);
  a252=(a252*a236);
  a295=(a295*a251);
  a252=(a252-a295);
  a431=(a431+a252);
  a431=(a431+a312);
  a292=(a292*a431);
  a284=(a284+a292);
  a284=(a043+a284);
  a441=(a441*a284);
  a338=(a338*a269);
  a441=(a441-a338);
  a438=(a438+a441);
  a002=(a002*a367);
  a328=(a328*a002);
  a328=(a328/a013);
  a326=(a326/a013);
  a326=(a326*a367);
  a328=(a328-a326);
  a329=(a329*a328);
  a333=(a333*a367);
  a332=(a332*a011);
  a328=(a007*a332);
  a333=(a333+a328);
  a333=(a333/a013);
  a334=(a334/a013);
  a334=(a334*a367);
  a333=(a333-a334);
  a329=(a329+a333);
  a335=(a335*a023);
  a331=(a331*a020);
  a335=(a335+a331);
  a335=(a027*a335);
  a336=(a336*a019);
  a335=(a335+a336);
  a329=(a329+a335);
  a335=(a329/a339);
  a340=(a340/a339);
  a337=(a337*a022);
  a337=(a009-a337);
  a337=(a337+a018);
  a340=(a340*a337);
  a335=(a335-a340);
  a341=(a341*a024);
  a341=(a341-a038);
  a340=(a341/a339);
  a339=(a343/a339);
  a339=(a339*a337);
  a340=(a340-a339);
  a339=(a346*a340);
  a344=(a344*a024);
  a332=(a025*a332);
  a344=(a344-a332);
  a330=(a330*a340);
  a329=(a343*a329);
  a330=(a330+a329);
  a344=(a344-a330);
  a344=(a344/a347);
  a346=(a346/a347);
  a341=(a343*a341);
  a342=(a342*a340);
  a341=(a341+a342);
  a341=(a029-a341);
  a346=(a346*a341);
  a344=(a344-a346);
  a343=(a343*a344);
  a339=(a339+a343);
  a335=(a335-a339);
  a438=(a438+a335);
  a335=(a325*a438);
  a303=(a303+a335);
  a303=(a385+a303);
  a335=(a317*a303);
  a368=(a368+a335);
  a368=(a436+a368);
  if (res[0]!=0) res[0][16]=a368;
  a368=(a001*a043);
  a335=(a005*a006);
  a368=(a368+a335);
  a335=(a157*a158);
  a368=(a368+a335);
  a335=(a187*a188);
  a368=(a368+a335);
  a335=(a218*a219);
  a368=(a368+a335);
  a335=(a250*a251);
  a368=(a368+a335);
  a335=(a283*a284);
  a368=(a368+a335);
  a335=(a318*a365);
  a371=(a320*a371);
  a335=(a335+a371);
  a087=(a128*a087);
  a335=(a335+a087);
  a087=(a156*a400);
  a335=(a335+a087);
  a087=(a321*a407);
  a335=(a335+a087);
  a087=(a322*a415);
  a335=(a335+a087);
  a087=(a323*a423);
  a335=(a335+a087);
  a087=(a324*a431);
  a335=(a335+a087);
  a379=(a379*a396);
  a443=(a443*a374);
  a379=(a379+a443);
  a285=(a285*a269);
  a327=(a327*a284);
  a285=(a285-a327);
  a379=(a379+a285);
  a379=(a379+a344);
  a344=(a325*a379);
  a335=(a335+a344);
  a335=(a043+a335);
  a344=(a317*a335);
  a368=(a368+a344);
  a368=(a387+a368);
  if (res[0]!=0) res[0][17]=a368;
  a366=(a001*a366);
  a383=(a005*a383);
  a366=(a366+a383);
  a409=(a157*a409);
  a366=(a366+a409);
  a417=(a187*a417);
  a366=(a366+a417);
  a425=(a218*a425);
  a366=(a366+a425);
  a433=(a250*a433);
  a366=(a366+a433);
  a438=(a283*a438);
  a366=(a366+a438);
  a438=(a318*a385);
  a050=(a320*a050);
  a438=(a438+a050);
  a130=(a128*a130);
  a438=(a438+a130);
  a021=(a156*a021);
  a438=(a438+a021);
  a143=(a321*a143);
  a438=(a438+a143);
  a173=(a322*a173);
  a438=(a438+a173);
  a204=(a323*a204);
  a438=(a438+a204);
  a236=(a324*a236);
  a438=(a438+a236);
  a269=(a325*a269);
  a438=(a438+a269);
  a436=(a436+a438);
  a426=(a426*a436);
  a318=(a318*a043);
  a320=(a320*a125);
  a318=(a318+a320);
  a128=(a128*a153);
  a318=(a318+a128);
  a156=(a156*a006);
  a318=(a318+a156);
  a321=(a321*a158);
  a318=(a318+a321);
  a322=(a322*a188);
  a318=(a318+a322);
  a323=(a323*a219);
  a318=(a318+a323);
  a324=(a324*a251);
  a318=(a318+a324);
  a325=(a325*a284);
  a318=(a318+a325);
  a387=(a387+a318);
  a358=(a358*a387);
  a426=(a426+a358);
  a028=(a028*a335);
  a026=(a026*a303);
  a028=(a028-a026);
  a426=(a426+a028);
  a349=(a349*a367);
  a316=(a316*a349);
  a316=(a316/a013);
  a348=(a348/a013);
  a348=(a348*a367);
  a316=(a316-a348);
  a282=(a282*a316);
  a217=(a217*a367);
  a016=(a016*a011);
  a007=(a007*a016);
  a217=(a217+a007);
  a217=(a217/a013);
  a186=(a186/a013);
  a186=(a186*a367);
  a217=(a217-a186);
  a282=(a282+a217);
  a004=(a004*a023);
  a000=(a000*a020);
  a004=(a004+a000);
  a027=(a027*a004);
  a350=(a350*a019);
  a027=(a027+a350);
  a282=(a282+a027);
  a027=(a282/a352);
  a353=(a353/a352);
  a012=(a012*a022);
  a009=(a009-a012);
  a009=(a009+a018);
  a353=(a353*a009);
  a027=(a027-a353);
  a354=(a354*a024);
  a354=(a354-a038);
  a038=(a354/a352);
  a352=(a356/a352);
  a352=(a352*a009);
  a038=(a038-a352);
  a352=(a359*a038);
  a357=(a357*a024);
  a025=(a025*a016);
  a357=(a357-a025);
  a249=(a249*a038);
  a282=(a356*a282);
  a249=(a249+a282);
  a357=(a357-a249);
  a357=(a357/a360);
  a359=(a359/a360);
  a354=(a356*a354);
  a355=(a355*a038);
  a354=(a354+a355);
  a029=(a029-a354);
  a359=(a359*a029);
  a357=(a357-a359);
  a356=(a356*a357);
  a352=(a352+a356);
  a027=(a027-a352);
  a426=(a426+a027);
  a426=(a317*a426);
  a366=(a366+a426);
  a385=(a385+a366);
  if (res[0]!=0) res[0][18]=a385;
  a001=(a001*a365);
  a005=(a005*a400);
  a001=(a001+a005);
  a157=(a157*a407);
  a001=(a001+a157);
  a187=(a187*a415);
  a001=(a001+a187);
  a218=(a218*a423);
  a001=(a001+a218);
  a250=(a250*a431);
  a001=(a001+a250);
  a283=(a283*a379);
  a001=(a001+a283);
  a434=(a434*a436);
  a404=(a404*a387);
  a434=(a434+a404);
  a319=(a319*a303);
  a412=(a412*a335);
  a319=(a319-a412);
  a434=(a434+a319);
  a434=(a434+a357);
  a317=(a317*a434);
  a001=(a001+a317);
  a043=(a043+a001);
  if (res[0]!=0) res[0][19]=a043;
  return 0;
}

/* step_alongs:(y[4x5],t,turns[2x12],h,p[3],d[3])->(y_end[4x5]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+448, w1, *w2=w+468, *w3=w+471, w5, *w6=w+473, *w7=w+476, w8;
  const casadi_real **arg1=arg+6, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w2);
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
  casadi_copy(arg[5], 3, w6);
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

/* landing_along:(y[4x5],z[3],T,p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[0]? arg[0][2] : 0;
  a04=arg[0]? arg[0][1] : 0;
  a05=sin(a04);
  a06=(-a05);
  a06=(2.*a06);
  a06=(a02*a06);
  a07=arg[3]? arg[3][0] : 0;
  a08=(a02*a05);
  a08=(a07*a08);
  a09=arg[3]? arg[3][1] : 0;
  a10=(a09+a03);
  a11=(a09/a10);
  a12=(a11*a06);
  a08=(a08+a12);
  a06=(a06-a08);
  a08=(2.*a09);
  a12=(a08/a10);
  a13=cos(a04);
  a14=(a13+a03);
  a15=(a12*a14);
  a16=(a07-a15);
  a17=casadi_sq(a09);
  a18=(a17+a08);
  a18=(a18+a03);
  a19=(a17/a18);
  a20=(2.*a19);
  a16=(a16+a20);
  a21=2.;
  a16=(a16+a21);
  a22=(a06/a16);
  a23=(a13*a02);
  a24=(a23*a07);
  a25=(2.*a13);
  a26=(a25*a02);
  a27=(2.*a02);
  a28=arg[0]? arg[0][3] : 0;
  a29=(a27-a28);
  a30=(a26+a29);
  a31=(a11*a30);
  a24=(a24-a31);
  a31=(a19*a29);
  a24=(a24+a31);
  a24=(a24+a26);
  a26=(a24/a16);
  a31=(a26/a16);
  a32=(a12*a05);
  a33=(a31*a32);
  a22=(a22-a33);
  a33=(a09*a02);
  a34=casadi_sq(a10);
  a33=(a33/a34);
  a35=(a13-a11);
  a36=(a11*a35);
  a37=(a36/a16);
  a38=(a37*a24);
  a38=(a33-a38);
  a17=(a17/a34);
  a39=(a36*a37);
  a39=(a17-a39);
  a38=(a38/a39);
  a40=(a11*a05);
  a41=(a40/a16);
  a42=(a37/a16);
  a32=(a42*a32);
  a41=(a41+a32);
  a32=(a38*a41);
  a06=(a37*a06);
  a43=(a24*a41);
  a06=(a06-a43);
  a06=(a06/a39);
  a43=(a38/a39);
  a40=(a37*a40);
  a41=(a36*a41);
  a40=(a40+a41);
  a40=(a43*a40);
  a06=(a06+a40);
  a40=(a37*a06);
  a32=(a32+a40);
  a22=(a22+a32);
  a32=(a22*a01);
  a40=(a07*a13);
  a41=(a25+a21);
  a41=(a11*a41);
  a40=(a40-a41);
  a40=(a40+a20);
  a40=(a40+a25);
  a20=(a40/a16);
  a41=(a09/a34);
  a40=(a37*a40);
  a41=(a41-a40);
  a41=(a41/a39);
  a40=(a37*a41);
  a20=(a20-a40);
  a40=arg[0]? arg[0][6] : 0;
  a44=(a20*a40);
  a32=(a32+a44);
  a44=(a11-a19);
  a45=(a44/a16);
  a44=(a37*a44);
  a44=(a44/a39);
  a46=(a37*a44);
  a45=(a45+a46);
  a46=arg[0]? arg[0][7] : 0;
  a47=(a45*a46);
  a32=(a32+a47);
  if (res[0]!=0) res[0][1]=a32;
  a40=(a41*a40);
  a32=(a06*a01);
  a40=(a40-a32);
  a46=(a44*a46);
  a40=(a40-a46);
  if (res[0]!=0) res[0][2]=a40;
  a40=-2.;
  a00=(a40*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a46=(a00-a01);
  if (res[0]!=0) res[0][4]=a46;
  a46=(a22*a01);
  a32=arg[0]? arg[0][10] : 0;
  a47=(a20*a32);
  a46=(a46+a47);
  a47=arg[0]? arg[0][11] : 0;
  a48=(a45*a47);
  a46=(a46+a48);
  a46=(a46-a03);
  if (res[0]!=0) res[0][5]=a46;
  a32=(a41*a32);
  a46=(a06*a01);
  a32=(a32-a46);
  a47=(a44*a47);
  a32=(a32-a47);
  if (res[0]!=0) res[0][6]=a32;
  a00=(a40*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a32=(a00-a01);
  if (res[0]!=0) res[0][8]=a32;
  a32=(a22*a01);
  a47=arg[0]? arg[0][14] : 0;
  a46=(a20*a47);
  a32=(a32+a46);
  a46=arg[0]? arg[0][15] : 0;
  a48=(a45*a46);
  a32=(a32+a48);
  if (res[0]!=0) res[0][9]=a32;
  a47=(a41*a47);
  a32=(a06*a01);
  a47=(a47-a32);
  a46=(a44*a46);
  a47=(a47-a46);
  a47=(a47-a03);
  if (res[0]!=0) res[0][10]=a47;
  a00=(a40*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=(a02-a28);
  if (res[0]!=0) res[0][12]=a00;
  a22=(a22*a28);
  a00=(a09*a28);
  a00=(a00*a05);
  a00=(a00/a10);
  a27=(a28-a27);
  a00=(a00*a27);
  a27=arg[3]? arg[3][2] : 0;
  a01=arg[0]? arg[0][0] : 0;
  a27=(a27-a01);
  a47=(a27+a04);
  a47=sin(a47);
  a03=(a09*a47);
  a03=(a03/a10);
  a00=(a00+a03);
  a27=sin(a27);
  a03=(a11-a07);
  a03=(a03-a21);
  a27=(a27*a03);
  a00=(a00+a27);
  a27=(a08*a09);
  a27=(a27/a18);
  a27=(a27-a15);
  a27=(a27+a07);
  a27=(a27+a21);
  a21=(a00/a27);
  a27=(a36/a27);
  a15=casadi_sq(a02);
  a15=(a15*a05);
  a15=(a15-a47);
  a15=(a11*a15);
  a00=(a27*a00);
  a15=(a15-a00);
  a00=(a36*a27);
  a00=(a17-a00);
  a15=(a15/a00);
  a27=(a27*a15);
  a21=(a21-a27);
  a20=(a20*a21);
  a22=(a22+a20);
  a45=(a45*a15);
  a22=(a22+a45);
  if (res[0]!=0) res[0][13]=a22;
  a41=(a41*a21);
  a06=(a06*a28);
  a41=(a41-a06);
  a44=(a44*a15);
  a41=(a41-a44);
  if (res[0]!=0) res[0][14]=a41;
  a40=(a40*a02);
  a40=(a40+a28);
  if (res[0]!=0) res[0][15]=a40;
  a40=arg[0]? arg[0][16] : 0;
  a28=arg[0]? arg[0][17] : 0;
  a41=(a40-a28);
  if (res[1]!=0) res[1][0]=a41;
  a41=arg[0]? arg[0][18] : 0;
  a13=(a13*a41);
  a05=(a05*a28);
  a44=(a02*a05);
  a13=(a13-a44);
  a07=(a07*a13);
  a13=arg[4]? arg[4][0] : 0;
  a23=(a23*a13);
  a07=(a07+a23);
  a23=arg[4]? arg[4][1] : 0;
  a44=(a23/a10);
  a15=(a11/a10);
  a15=(a15*a23);
  a44=(a44-a15);
  a30=(a30*a44);
  a15=(-a05);
  a15=(2.*a15);
  a15=(a02*a15);
  a25=(a25*a41);
  a15=(a15+a25);
  a25=(2.*a41);
  a06=arg[0]? arg[0][19] : 0;
  a25=(a25-a06);
  a06=(a15+a25);
  a06=(a11*a06);
  a30=(a30+a06);
  a07=(a07-a30);
  a08=(a08*a23);
  a30=(a08/a18);
  a18=(a19/a18);
  a06=(2.*a23);
  a21=(a08+a06);
  a18=(a18*a21);
  a30=(a30-a18);
  a29=(a29*a30);
  a19=(a19*a25);
  a29=(a29+a19);
  a07=(a07+a29);
  a07=(a07+a15);
  a15=(a07/a16);
  a06=(a06/a10);
  a29=(a12/a10);
  a29=(a29*a23);
  a06=(a06-a29);
  a14=(a14*a06);
  a12=(a12*a05);
  a14=(a14-a12);
  a13=(a13-a14);
  a30=(2.*a30);
  a13=(a13+a30);
  a31=(a31*a13);
  a15=(a15-a31);
  a35=(a35*a44);
  a05=(a05+a44);
  a11=(a11*a05);
  a35=(a35-a11);
  a16=(a35/a16);
  a42=(a42*a13);
  a16=(a16-a42);
  a42=(a38*a16);
  a02=(a02*a23);
  a09=(a09*a41);
  a02=(a02+a09);
  a02=(a02/a34);
  a33=(a33/a34);
  a10=(2.*a10);
  a10=(a10*a23);
  a33=(a33*a10);
  a02=(a02-a33);
  a24=(a24*a16);
  a07=(a37*a07);
  a24=(a24+a07);
  a02=(a02-a24);
  a02=(a02/a39);
  a08=(a08/a34);
  a17=(a17/a34);
  a17=(a17*a10);
  a08=(a08-a17);
  a35=(a37*a35);
  a36=(a36*a16);
  a35=(a35+a36);
  a08=(a08-a35);
  a43=(a43*a08);
  a02=(a02-a43);
  a43=(a37*a02);
  a42=(a42+a43);
  a15=(a15-a42);
  if (res[1]!=0) res[1][1]=a15;
  if (res[1]!=0) res[1][2]=a02;
  a40=(2.*a40);
  a28=(a28-a40);
  if (res[1]!=0) res[1][3]=a28;
  a28=(a01-a04);
  a40=arg[1]? arg[1][0] : 0;
  a28=(a28-a40);
  if (res[2]!=0) res[2][0]=a28;
  a37=(a37*a38);
  a26=(a26-a37);
  a37=arg[1]? arg[1][1] : 0;
  a26=(a26-a37);
  if (res[2]!=0) res[2][1]=a26;
  a26=arg[1]? arg[1][2] : 0;
  a38=(a38-a26);
  if (res[2]!=0) res[2][2]=a38;
  a01=(2.*a01);
  a04=(a04-a01);
  if (res[2]!=0) res[2][3]=a04;
  return 0;
}

/* goswami_compass_jacobian_along_12:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_12_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_12_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_24:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_24_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_36:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_36_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_48:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_48_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_72:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_72_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_96:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_96_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_144:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_144_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_192:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_192_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_288:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_288_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_along_384:(u[4],p[3],d[3])->(J[4x4],R_d[4],R[4]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+523, *w01=w+527, *w02=w+530, *w03=w+533, *w04=w+536, w05, w06, w07, *w08=w+556, *w09=w+580;
  casadi_real *w10=w+600, *w11=w+616;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
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

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_jacobian_along_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_384_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_jacobian_along_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_jacobian_along_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_jacobian_along_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_jacobian_along_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 620;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_along_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 620*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[4],phase[2],turns[2x12],h,p[3])->(y_end[4]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77;
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
  a12=1.;
  a13=(a07+a12);
  a09=(a09/a13);
  a14=(2.*a03);
  a14=(a08-a14);
  a09=(a09*a14);
  a14=arg[4]? arg[4][2] : 0;
  a15=(a14-a00);
  a15=(a15+a10);
  a15=sin(a15);
  a16=(a07*a15);
  a16=(a16/a13);
  a09=(a09+a16);
  a16=sin(a14);
  a17=cos(a00);
  a17=(a16*a17);
  a18=cos(a14);
  a19=sin(a00);
  a19=(a18*a19);
  a17=(a17-a19);
  a19=(a07/a13);
  a20=arg[4]? arg[4][0] : 0;
  a21=(a19-a20);
  a22=2.;
  a21=(a21-a22);
  a17=(a17*a21);
  a09=(a09+a17);
  a17=(2.*a07);
  a23=(a17*a07);
  a24=casadi_sq(a07);
  a25=(a24+a17);
  a25=(a25+a12);
  a23=(a23/a25);
  a17=(a17/a13);
  a25=cos(a10);
  a26=(a25+a12);
  a26=(a17*a26);
  a26=(a23-a26);
  a26=(a26+a20);
  a26=(a26+a22);
  a27=(a09/a26);
  a25=(a25-a19);
  a25=(a19*a25);
  a26=(a25/a26);
  a28=casadi_sq(a03);
  a28=(a28*a11);
  a28=(a28-a15);
  a28=(a19*a28);
  a09=(a26*a09);
  a28=(a28-a09);
  a09=casadi_sq(a13);
  a24=(a24/a09);
  a25=(a25*a26);
  a25=(a24-a25);
  a28=(a28/a25);
  a26=(a26*a28);
  a27=(a27-a26);
  a26=(a06*a27);
  a25=1.7082860872947386e-01;
  a25=(a25*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a15=(a09*a28);
  a11=8.8762756430420545e-02;
  a11=(a11*a02);
  a29=1.9725056984537900e-02;
  a29=(a29*a02);
  a30=(a29*a27);
  a31=5.9175170953613701e-02;
  a31=(a31*a02);
  a32=5.2600151958767730e-02;
  a32=(a32*a02);
  a33=(a32*a28);
  a33=(a08+a33);
  a34=(a07*a33);
  a35=(a32*a08);
  a35=(a10+a35);
  a36=sin(a35);
  a34=(a34*a36);
  a34=(a34/a13);
  a37=(a32*a27);
  a37=(a03+a37);
  a38=(2.*a37);
  a38=(a33-a38);
  a34=(a34*a38);
  a32=(a32*a03);
  a32=(a00+a32);
  a38=(a14-a32);
  a38=(a38+a35);
  a38=sin(a38);
  a39=(a07*a38);
  a39=(a39/a13);
  a34=(a34+a39);
  a39=cos(a32);
  a39=(a16*a39);
  a32=sin(a32);
  a32=(a18*a32);
  a39=(a39-a32);
  a39=(a39*a21);
  a34=(a34+a39);
  a35=cos(a35);
  a39=(a35+a12);
  a39=(a17*a39);
  a39=(a23-a39);
  a39=(a39+a20);
  a39=(a39+a22);
  a32=(a34/a39);
  a35=(a35-a19);
  a35=(a19*a35);
  a39=(a35/a39);
  a40=casadi_sq(a37);
  a40=(a40*a36);
  a40=(a40-a38);
  a40=(a19*a40);
  a34=(a39*a34);
  a40=(a40-a34);
  a35=(a35*a39);
  a35=(a24-a35);
  a40=(a40/a35);
  a39=(a39*a40);
  a32=(a32-a39);
  a32=(a31*a32);
  a30=(a30+a32);
  a30=(a03+a30);
  a32=casadi_sq(a30);
  a39=(a29*a08);
  a33=(a31*a33);
  a39=(a39+a33);
  a39=(a10+a39);
  a33=sin(a39);
  a32=(a32*a33);
  a35=(a29*a03);
  a37=(a31*a37);
  a35=(a35+a37);
  a35=(a00+a35);
  a37=(a14-a35);
  a37=(a37+a39);
  a37=sin(a37);
  a32=(a32-a37);
  a32=(a19*a32);
  a39=cos(a39);
  a34=(a39-a19);
  a34=(a19*a34);
  a39=(a39+a12);
  a39=(a17*a39);
  a39=(a23-a39);
  a39=(a39+a20);
  a39=(a39+a22);
  a38=(a34/a39);
  a29=(a29*a28);
  a31=(a31*a40);
  a29=(a29+a31);
  a29=(a08+a29);
  a31=(a07*a29);
  a31=(a31*a33);
  a31=(a31/a13);
  a33=(2.*a30);
  a33=(a29-a33);
  a31=(a31*a33);
  a37=(a07*a37);
  a37=(a37/a13);
  a31=(a31+a37);
  a37=cos(a35);
  a37=(a16*a37);
  a35=sin(a35);
  a35=(a18*a35);
  a37=(a37-a35);
  a37=(a37*a21);
  a31=(a31+a37);
  a37=(a38*a31);
  a32=(a32-a37);
  a34=(a34*a38);
  a34=(a24-a34);
  a32=(a32/a34);
  a34=(a11*a32);
  a15=(a15+a34);
  a15=(a08+a15);
  a34=(a07*a15);
  a37=(a09*a08);
  a35=(a11*a29);
  a37=(a37+a35);
  a37=(a10+a37);
  a35=sin(a37);
  a34=(a34*a35);
  a34=(a34/a13);
  a33=(a09*a27);
  a31=(a31/a39);
  a38=(a38*a32);
  a31=(a31-a38);
  a38=(a11*a31);
  a33=(a33+a38);
  a33=(a03+a33);
  a38=(2.*a33);
  a38=(a15-a38);
  a34=(a34*a38);
  a09=(a09*a03);
  a11=(a11*a30);
  a09=(a09+a11);
  a09=(a00+a09);
  a11=(a14-a09);
  a11=(a11+a37);
  a11=sin(a11);
  a38=(a07*a11);
  a38=(a38/a13);
  a34=(a34+a38);
  a38=cos(a09);
  a38=(a16*a38);
  a09=sin(a09);
  a09=(a18*a09);
  a38=(a38-a09);
  a38=(a38*a21);
  a34=(a34+a38);
  a37=cos(a37);
  a38=(a37+a12);
  a38=(a17*a38);
  a38=(a23-a38);
  a38=(a38+a20);
  a38=(a38+a22);
  a09=(a34/a38);
  a37=(a37-a19);
  a37=(a19*a37);
  a38=(a37/a38);
  a39=casadi_sq(a33);
  a39=(a39*a35);
  a39=(a39-a11);
  a39=(a19*a39);
  a34=(a38*a34);
  a39=(a39-a34);
  a37=(a37*a38);
  a37=(a24-a37);
  a39=(a39/a37);
  a38=(a38*a39);
  a09=(a09-a38);
  a38=(a25*a09);
  a26=(a26+a38);
  a38=1.2546768756682242e-01;
  a38=(a38*a02);
  a37=2.4136513415926669e-01;
  a37=(a37*a02);
  a34=(a37*a28);
  a11=-8.8454947932828609e-01;
  a11=(a11*a02);
  a32=(a11*a32);
  a34=(a34+a32);
  a32=9.2483400326179199e-01;
  a32=(a32*a02);
  a35=(a32*a39);
  a34=(a34+a35);
  a34=(a08+a34);
  a35=(a07*a34);
  a40=(a37*a08);
  a29=(a11*a29);
  a40=(a40+a29);
  a29=(a32*a15);
  a40=(a40+a29);
  a40=(a10+a40);
  a29=sin(a40);
  a35=(a35*a29);
  a35=(a35/a13);
  a36=(a37*a27);
  a31=(a11*a31);
  a36=(a36+a31);
  a31=(a32*a09);
  a36=(a36+a31);
  a36=(a03+a36);
  a31=(2.*a36);
  a31=(a34-a31);
  a35=(a35*a31);
  a37=(a37*a03);
  a11=(a11*a30);
  a37=(a37+a11);
  a32=(a32*a33);
  a37=(a37+a32);
  a37=(a00+a37);
  a32=(a14-a37);
  a32=(a32+a40);
  a32=sin(a32);
  a11=(a07*a32);
  a11=(a11/a13);
  a35=(a35+a11);
  a11=cos(a37);
  a11=(a16*a11);
  a37=sin(a37);
  a37=(a18*a37);
  a11=(a11-a37);
  a11=(a11*a21);
  a35=(a35+a11);
  a40=cos(a40);
  a11=(a40+a12);
  a11=(a17*a11);
  a11=(a23-a11);
  a11=(a11+a20);
  a11=(a11+a22);
  a37=(a35/a11);
  a40=(a40-a19);
  a40=(a19*a40);
  a11=(a40/a11);
  a30=casadi_sq(a36);
  a30=(a30*a29);
  a30=(a30-a32);
  a30=(a19*a30);
  a35=(a11*a35);
  a30=(a30-a35);
  a40=(a40*a11);
  a40=(a24-a40);
  a30=(a30/a40);
  a11=(a11*a30);
  a37=(a37-a11);
  a11=(a38*a37);
  a26=(a26+a11);
  a26=(a03+a26);
  a11=(a05*a26);
  a04=(a04+a11);
  a11=1.8915178993145003e+00;
  a11=(a11*a02);
  a40=3.7109375000000000e-02;
  a40=(a40*a02);
  a35=(a40*a27);
  a32=1.7025221101954405e-01;
  a32=(a32*a02);
  a29=(a32*a09);
  a35=(a35+a29);
  a29=6.0216538980455959e-02;
  a29=(a29*a02);
  a31=(a29*a37);
  a35=(a35+a31);
  a31=-1.7578125000000000e-02;
  a31=(a31*a02);
  a41=(a06*a28);
  a42=(a25*a39);
  a41=(a41+a42);
  a42=(a38*a30);
  a41=(a41+a42);
  a41=(a08+a41);
  a42=(a07*a41);
  a43=(a06*a08);
  a44=(a25*a15);
  a43=(a43+a44);
  a44=(a38*a34);
  a43=(a43+a44);
  a43=(a10+a43);
  a44=sin(a43);
  a42=(a42*a44);
  a42=(a42/a13);
  a45=(2.*a26);
  a45=(a41-a45);
  a42=(a42*a45);
  a06=(a06*a03);
  a25=(a25*a33);
  a06=(a06+a25);
  a38=(a38*a36);
  a06=(a06+a38);
  a06=(a00+a06);
  a38=(a14-a06);
  a38=(a38+a43);
  a38=sin(a38);
  a25=(a07*a38);
  a25=(a25/a13);
  a42=(a42+a25);
  a25=cos(a06);
  a25=(a16*a25);
  a06=sin(a06);
  a06=(a18*a06);
  a25=(a25-a06);
  a25=(a25*a21);
  a42=(a42+a25);
  a43=cos(a43);
  a25=(a43+a12);
  a25=(a17*a25);
  a25=(a23-a25);
  a25=(a25+a20);
  a25=(a25+a22);
  a06=(a42/a25);
  a43=(a43-a19);
  a43=(a19*a43);
  a25=(a43/a25);
  a45=casadi_sq(a26);
  a45=(a45*a44);
  a45=(a45-a38);
  a45=(a19*a45);
  a42=(a25*a42);
  a45=(a45-a42);
  a43=(a43*a25);
  a43=(a24-a43);
  a45=(a45/a43);
  a25=(a25*a45);
  a06=(a06-a25);
  a25=(a31*a06);
  a35=(a35+a25);
  a35=(a03+a35);
  a25=(a11*a35);
  a04=(a04+a25);
  a25=-5.8012039600105849e+00;
  a25=(a25*a02);
  a43=3.7092000118504789e-02;
  a43=(a43*a02);
  a42=(a43*a27);
  a38=1.7038392571223998e-01;
  a38=(a38*a02);
  a44=(a38*a09);
  a42=(a42+a44);
  a44=1.0726203044637328e-01;
  a44=(a44*a02);
  a46=(a44*a37);
  a42=(a42+a46);
  a46=-1.5319437748624402e-02;
  a46=(a46*a02);
  a47=(a46*a06);
  a42=(a42+a47);
  a47=8.2737891638140233e-03;
  a47=(a47*a02);
  a48=(a40*a28);
  a49=(a32*a39);
  a48=(a48+a49);
  a49=(a29*a30);
  a48=(a48+a49);
  a49=(a31*a45);
  a48=(a48+a49);
  a48=(a08+a48);
  a49=(a07*a48);
  a50=(a40*a08);
  a51=(a32*a15);
  a50=(a50+a51);
  a51=(a29*a34);
  a50=(a50+a51);
  a51=(a31*a41);
  a50=(a50+a51);
  a50=(a10+a50);
  a51=sin(a50);
  a49=(a49*a51);
  a49=(a49/a13);
  a52=(2.*a35);
  a52=(a48-a52);
  a49=(a49*a52);
  a40=(a40*a03);
  a32=(a32*a33);
  a40=(a40+a32);
  a29=(a29*a36);
  a40=(a40+a29);
  a31=(a31*a26);
  a40=(a40+a31);
  a40=(a00+a40);
  a31=(a14-a40);
  a31=(a31+a50);
  a31=sin(a31);
  a29=(a07*a31);
  a29=(a29/a13);
  a49=(a49+a29);
  a29=cos(a40);
  a29=(a16*a29);
  a40=sin(a40);
  a40=(a18*a40);
  a29=(a29-a40);
  a29=(a29*a21);
  a49=(a49+a29);
  a50=cos(a50);
  a29=(a50+a12);
  a29=(a17*a29);
  a29=(a23-a29);
  a29=(a29+a20);
  a29=(a29+a22);
  a40=(a49/a29);
  a50=(a50-a19);
  a50=(a19*a50);
  a29=(a50/a29);
  a32=casadi_sq(a35);
  a32=(a32*a51);
  a32=(a32-a31);
  a32=(a19*a32);
  a49=(a29*a49);
  a32=(a32-a49);
  a50=(a50*a29);
  a50=(a24-a50);
  a32=(a32/a50);
  a29=(a29*a32);
  a40=(a40-a29);
  a29=(a47*a40);
  a42=(a42+a29);
  a42=(a03+a42);
  a29=(a25*a42);
  a04=(a04+a29);
  a29=3.1116436695781990e-01;
  a29=(a29*a02);
  a50=6.2411095871607569e-01;
  a50=(a50*a02);
  a49=(a50*a27);
  a31=-3.3608926294469414e+00;
  a31=(a31*a02);
  a51=(a31*a09);
  a49=(a49+a51);
  a51=-8.6821934684172597e-01;
  a51=(a51*a02);
  a52=(a51*a37);
  a49=(a49+a52);
  a52=2.7592099699446710e+01;
  a52=(a52*a02);
  a53=(a52*a06);
  a49=(a49+a53);
  a53=2.0154067550477894e+01;
  a53=(a53*a02);
  a54=(a53*a40);
  a49=(a49+a54);
  a54=-4.3489884181069961e+01;
  a54=(a54*a02);
  a55=(a43*a28);
  a56=(a38*a39);
  a55=(a55+a56);
  a56=(a44*a30);
  a55=(a55+a56);
  a56=(a46*a45);
  a55=(a55+a56);
  a56=(a47*a32);
  a55=(a55+a56);
  a55=(a08+a55);
  a56=(a07*a55);
  a57=(a43*a08);
  a58=(a38*a15);
  a57=(a57+a58);
  a58=(a44*a34);
  a57=(a57+a58);
  a58=(a46*a41);
  a57=(a57+a58);
  a58=(a47*a48);
  a57=(a57+a58);
  a57=(a10+a57);
  a58=sin(a57);
  a56=(a56*a58);
  a56=(a56/a13);
  a59=(2.*a42);
  a59=(a55-a59);
  a56=(a56*a59);
  a43=(a43*a03);
  a38=(a38*a33);
  a43=(a43+a38);
  a44=(a44*a36);
  a43=(a43+a44);
  a46=(a46*a26);
  a43=(a43+a46);
  a47=(a47*a35);
  a43=(a43+a47);
  a43=(a00+a43);
  a47=(a14-a43);
  a47=(a47+a57);
  a47=sin(a47);
  a46=(a07*a47);
  a46=(a46/a13);
  a56=(a56+a46);
  a46=cos(a43);
  a46=(a16*a46);
  a43=sin(a43);
  a43=(a18*a43);
  a46=(a46-a43);
  a46=(a46*a21);
  a56=(a56+a46);
  a57=cos(a57);
  a46=(a57+a12);
  a46=(a17*a46);
  a46=(a23-a46);
  a46=(a46+a20);
  a46=(a46+a22);
  a43=(a56/a46);
  a57=(a57-a19);
  a57=(a19*a57);
  a46=(a57/a46);
  a44=casadi_sq(a42);
  a44=(a44*a58);
  a44=(a44-a47);
  a44=(a19*a44);
  a56=(a46*a56);
  a44=(a44-a56);
  a57=(a57*a46);
  a57=(a24-a57);
  a44=(a44/a57);
  a46=(a46*a44);
  a43=(a43-a46);
  a46=(a54*a43);
  a49=(a49+a46);
  a49=(a03+a49);
  a46=(a29*a49);
  a04=(a04+a46);
  a46=-1.5216094966251609e-01;
  a46=(a46*a02);
  a57=4.7766253643826434e-01;
  a57=(a57*a02);
  a56=(a57*a27);
  a47=-2.4881146199716677e+00;
  a47=(a47*a02);
  a58=(a47*a09);
  a56=(a56+a58);
  a58=-5.9029082683684297e-01;
  a58=(a58*a02);
  a38=(a58*a37);
  a56=(a56+a38);
  a38=2.1230051448181193e+01;
  a38=(a38*a02);
  a59=(a38*a06);
  a56=(a56+a59);
  a59=1.5279233632882423e+01;
  a59=(a59*a02);
  a60=(a59*a40);
  a56=(a56+a60);
  a60=-3.3288210968984863e+01;
  a60=(a60*a02);
  a61=(a60*a43);
  a56=(a56+a61);
  a61=-2.0331201708508627e-02;
  a61=(a61*a02);
  a62=(a50*a28);
  a63=(a31*a39);
  a62=(a62+a63);
  a63=(a51*a30);
  a62=(a62+a63);
  a63=(a52*a45);
  a62=(a62+a63);
  a63=(a53*a32);
  a62=(a62+a63);
  a63=(a54*a44);
  a62=(a62+a63);
  a62=(a08+a62);
  a63=(a07*a62);
  a64=(a50*a08);
  a65=(a31*a15);
  a64=(a64+a65);
  a65=(a51*a34);
  a64=(a64+a65);
  a65=(a52*a41);
  a64=(a64+a65);
  a65=(a53*a48);
  a64=(a64+a65);
  a65=(a54*a55);
  a64=(a64+a65);
  a64=(a10+a64);
  a65=sin(a64);
  a63=(a63*a65);
  a63=(a63/a13);
  a66=(2.*a49);
  a66=(a62-a66);
  a63=(a63*a66);
  a50=(a50*a03);
  a31=(a31*a33);
  a50=(a50+a31);
  a51=(a51*a36);
  a50=(a50+a51);
  a52=(a52*a26);
  a50=(a50+a52);
  a53=(a53*a35);
  a50=(a50+a53);
  a54=(a54*a42);
  a50=(a50+a54);
  a50=(a00+a50);
  a54=(a14-a50);
  a54=(a54+a64);
  a54=sin(a54);
  a53=(a07*a54);
  a53=(a53/a13);
  a63=(a63+a53);
  a53=cos(a50);
  a53=(a16*a53);
  a50=sin(a50);
  a50=(a18*a50);
  a53=(a53-a50);
  a53=(a53*a21);
  a63=(a63+a53);
  a64=cos(a64);
  a53=(a64+a12);
  a53=(a17*a53);
  a53=(a23-a53);
  a53=(a53+a20);
  a53=(a53+a22);
  a50=(a63/a53);
  a64=(a64-a19);
  a64=(a19*a64);
  a53=(a64/a53);
  a52=casadi_sq(a49);
  a52=(a52*a65);
  a52=(a52-a54);
  a52=(a19*a52);
  a63=(a53*a63);
  a52=(a52-a63);
  a64=(a64*a53);
  a64=(a24-a64);
  a52=(a52/a64);
  a53=(a53*a52);
  a50=(a50-a53);
  a53=(a61*a50);
  a56=(a56+a53);
  a56=(a03+a56);
  a53=(a46*a56);
  a04=(a04+a53);
  a53=2.0136540080403034e-01;
  a53=(a53*a02);
  a64=-9.3714243008598730e-01;
  a64=(a64*a02);
  a63=(a64*a27);
  a54=5.1863724288440638e+00;
  a54=(a54*a02);
  a65=(a54*a09);
  a63=(a63+a65);
  a65=1.0914373489967295e+00;
  a65=(a65*a02);
  a51=(a65*a37);
  a63=(a63+a51);
  a51=-8.1497870107469268e+00;
  a51=(a51*a02);
  a31=(a51*a06);
  a63=(a63+a31);
  a31=-1.8520065659996959e+01;
  a31=(a31*a02);
  a66=(a31*a40);
  a63=(a63+a66);
  a66=2.2739487099350505e+01;
  a66=(a66*a02);
  a67=(a66*a43);
  a63=(a63+a67);
  a67=2.4936055526796523e+00;
  a67=(a67*a02);
  a68=(a67*a50);
  a63=(a63+a68);
  a68=-3.0467644718982196e+00;
  a68=(a68*a02);
  a69=(a57*a28);
  a70=(a47*a39);
  a69=(a69+a70);
  a70=(a58*a30);
  a69=(a69+a70);
  a70=(a38*a45);
  a69=(a69+a70);
  a70=(a59*a32);
  a69=(a69+a70);
  a70=(a60*a44);
  a69=(a69+a70);
  a70=(a61*a52);
  a69=(a69+a70);
  a69=(a08+a69);
  a70=(a07*a69);
  a71=(a57*a08);
  a72=(a47*a15);
  a71=(a71+a72);
  a72=(a58*a34);
  a71=(a71+a72);
  a72=(a38*a41);
  a71=(a71+a72);
  a72=(a59*a48);
  a71=(a71+a72);
  a72=(a60*a55);
  a71=(a71+a72);
  a72=(a61*a62);
  a71=(a71+a72);
  a71=(a10+a71);
  a72=sin(a71);
  a70=(a70*a72);
  a70=(a70/a13);
  a73=(2.*a56);
  a73=(a69-a73);
  a70=(a70*a73);
  a57=(a57*a03);
  a47=(a47*a33);
  a57=(a57+a47);
  a58=(a58*a36);
  a57=(a57+a58);
  a38=(a38*a26);
  a57=(a57+a38);
  a59=(a59*a35);
  a57=(a57+a59);
  a60=(a60*a42);
  a57=(a57+a60);
  a61=(a61*a49);
  a57=(a57+a61);
  a57=(a00+a57);
  a61=(a14-a57);
  a61=(a61+a71);
  a61=sin(a61);
  a60=(a07*a61);
  a60=(a60/a13);
  a70=(a70+a60);
  a60=cos(a57);
  a60=(a16*a60);
  a57=sin(a57);
  a57=(a18*a57);
  a60=(a60-a57);
  a60=(a60*a21);
  a70=(a70+a60);
  a71=cos(a71);
  a60=(a71+a12);
  a60=(a17*a60);
  a60=(a23-a60);
  a60=(a60+a20);
  a60=(a60+a22);
  a57=(a70/a60);
  a71=(a71-a19);
  a71=(a19*a71);
  a60=(a71/a60);
  a59=casadi_sq(a56);
  a59=(a59*a72);
  a59=(a59-a61);
  a59=(a19*a59);
  a70=(a60*a70);
  a59=(a59-a70);
  a71=(a71*a60);
  a71=(a24-a71);
  a59=(a59/a71);
  a60=(a60*a59);
  a57=(a57-a60);
  a60=(a68*a57);
  a63=(a63+a60);
  a63=(a03+a63);
  a60=(a53*a63);
  a04=(a04+a60);
  a60=4.4710615727772587e-02;
  a60=(a60*a02);
  a71=2.2733101475165380e+00;
  a71=(a71*a02);
  a70=(a71*a27);
  a61=-1.0534495466737249e+01;
  a61=(a61*a02);
  a09=(a61*a09);
  a70=(a70+a09);
  a09=-2.0008720582248625e+00;
  a09=(a09*a02);
  a37=(a09*a37);
  a70=(a70+a37);
  a37=-1.7958931863118799e+01;
  a37=(a37*a02);
  a72=(a37*a06);
  a70=(a70+a72);
  a72=2.7948884529419960e+01;
  a72=(a72*a02);
  a38=(a72*a40);
  a70=(a70+a38);
  a38=-2.8589982771350235e+00;
  a38=(a38*a02);
  a58=(a38*a43);
  a70=(a70+a58);
  a58=-8.8728569335306293e+00;
  a58=(a58*a02);
  a47=(a58*a50);
  a70=(a70+a47);
  a47=1.2360567175794303e+01;
  a47=(a47*a02);
  a73=(a47*a57);
  a70=(a70+a73);
  a73=6.4339274601576357e-01;
  a73=(a73*a02);
  a02=(a64*a28);
  a74=(a54*a39);
  a02=(a02+a74);
  a74=(a65*a30);
  a02=(a02+a74);
  a74=(a51*a45);
  a02=(a02+a74);
  a74=(a31*a32);
  a02=(a02+a74);
  a74=(a66*a44);
  a02=(a02+a74);
  a74=(a67*a52);
  a02=(a02+a74);
  a74=(a68*a59);
  a02=(a02+a74);
  a02=(a08+a02);
  a74=(a07*a02);
  a75=(a64*a08);
  a76=(a54*a15);
  a75=(a75+a76);
  a76=(a65*a34);
  a75=(a75+a76);
  a76=(a51*a41);
  a75=(a75+a76);
  a76=(a31*a48);
  a75=(a75+a76);
  a76=(a66*a55);
  a75=(a75+a76);
  a76=(a67*a62);
  a75=(a75+a76);
  a76=(a68*a69);
  a75=(a75+a76);
  a75=(a10+a75);
  a76=sin(a75);
  a74=(a74*a76);
  a74=(a74/a13);
  a77=(2.*a63);
  a77=(a02-a77);
  a74=(a74*a77);
  a64=(a64*a03);
  a54=(a54*a33);
  a64=(a64+a54);
  a65=(a65*a36);
  a64=(a64+a65);
  a51=(a51*a26);
  a64=(a64+a51);
  a31=(a31*a35);
  a64=(a64+a31);
  a66=(a66*a42);
  a64=(a64+a66);
  a67=(a67*a49);
  a64=(a64+a67);
  a68=(a68*a56);
  a64=(a64+a68);
  a64=(a00+a64);
  a68=(a14-a64);
  a68=(a68+a75);
  a68=sin(a68);
  a67=(a07*a68);
  a67=(a67/a13);
  a74=(a74+a67);
  a67=cos(a64);
  a67=(a16*a67);
  a64=sin(a64);
  a64=(a18*a64);
  a67=(a67-a64);
  a67=(a67*a21);
  a74=(a74+a67);
  a75=cos(a75);
  a67=(a75+a12);
  a67=(a17*a67);
  a67=(a23-a67);
  a67=(a67+a20);
  a67=(a67+a22);
  a64=(a74/a67);
  a75=(a75-a19);
  a75=(a19*a75);
  a67=(a75/a67);
  a66=casadi_sq(a63);
  a66=(a66*a76);
  a66=(a66-a68);
  a66=(a19*a66);
  a74=(a67*a74);
  a66=(a66-a74);
  a75=(a75*a67);
  a75=(a24-a75);
  a66=(a66/a75);
  a67=(a67*a66);
  a64=(a64-a67);
  a67=(a73*a64);
  a70=(a70+a67);
  a70=(a03+a70);
  a67=(a60*a70);
  a04=(a04+a67);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a67=(a05*a41);
  a04=(a04+a67);
  a67=(a11*a48);
  a04=(a04+a67);
  a67=(a25*a55);
  a04=(a04+a67);
  a67=(a29*a62);
  a04=(a04+a67);
  a67=(a46*a69);
  a04=(a04+a67);
  a67=(a53*a02);
  a04=(a04+a67);
  a67=(a71*a28);
  a39=(a61*a39);
  a67=(a67+a39);
  a30=(a09*a30);
  a67=(a67+a30);
  a30=(a37*a45);
  a67=(a67+a30);
  a30=(a72*a32);
  a67=(a67+a30);
  a30=(a38*a44);
  a67=(a67+a30);
  a30=(a58*a52);
  a67=(a67+a30);
  a30=(a47*a59);
  a67=(a67+a30);
  a30=(a73*a66);
  a67=(a67+a30);
  a67=(a08+a67);
  a30=(a60*a67);
  a04=(a04+a30);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a27=(a01*a27);
  a06=(a05*a06);
  a27=(a27+a06);
  a40=(a11*a40);
  a27=(a27+a40);
  a43=(a25*a43);
  a27=(a27+a43);
  a50=(a29*a50);
  a27=(a27+a50);
  a57=(a46*a57);
  a27=(a27+a57);
  a64=(a53*a64);
  a27=(a27+a64);
  a64=(a07*a67);
  a57=(a71*a08);
  a15=(a61*a15);
  a57=(a57+a15);
  a34=(a09*a34);
  a57=(a57+a34);
  a41=(a37*a41);
  a57=(a57+a41);
  a48=(a72*a48);
  a57=(a57+a48);
  a55=(a38*a55);
  a57=(a57+a55);
  a62=(a58*a62);
  a57=(a57+a62);
  a69=(a47*a69);
  a57=(a57+a69);
  a02=(a73*a02);
  a57=(a57+a02);
  a10=(a10+a57);
  a57=sin(a10);
  a64=(a64*a57);
  a64=(a64/a13);
  a02=(2.*a70);
  a67=(a67-a02);
  a64=(a64*a67);
  a71=(a71*a03);
  a61=(a61*a33);
  a71=(a71+a61);
  a09=(a09*a36);
  a71=(a71+a09);
  a37=(a37*a26);
  a71=(a71+a37);
  a72=(a72*a35);
  a71=(a71+a72);
  a38=(a38*a42);
  a71=(a71+a38);
  a58=(a58*a49);
  a71=(a71+a58);
  a47=(a47*a56);
  a71=(a71+a47);
  a73=(a73*a63);
  a71=(a71+a73);
  a00=(a00+a71);
  a14=(a14-a00);
  a14=(a14+a10);
  a14=sin(a14);
  a07=(a07*a14);
  a07=(a07/a13);
  a64=(a64+a07);
  a07=cos(a00);
  a16=(a16*a07);
  a00=sin(a00);
  a18=(a18*a00);
  a16=(a16-a18);
  a16=(a16*a21);
  a64=(a64+a16);
  a10=cos(a10);
  a12=(a10+a12);
  a17=(a17*a12);
  a23=(a23-a17);
  a23=(a23+a20);
  a23=(a23+a22);
  a22=(a64/a23);
  a10=(a10-a19);
  a10=(a19*a10);
  a23=(a10/a23);
  a70=casadi_sq(a70);
  a70=(a70*a57);
  a70=(a70-a14);
  a19=(a19*a70);
  a64=(a23*a64);
  a19=(a19-a64);
  a10=(a10*a23);
  a24=(a24-a10);
  a19=(a19/a24);
  a23=(a23*a19);
  a22=(a22-a23);
  a22=(a60*a22);
  a27=(a27+a22);
  a03=(a03+a27);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a28);
  a05=(a05*a45);
  a01=(a01+a05);
  a11=(a11*a32);
  a01=(a01+a11);
  a25=(a25*a44);
  a01=(a01+a25);
  a29=(a29*a52);
  a01=(a01+a29);
  a46=(a46*a59);
  a01=(a01+a46);
  a53=(a53*a66);
  a01=(a01+a53);
  a60=(a60*a19);
  a01=(a01+a60);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* observe:(t,y[4],p[3])->(g[8],dg[8]) */
static int casadi_f103(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56;
  a00=arg[2]? arg[2][1] : 0;
  a01=arg[1]? arg[1][0] : 0;
  a02=arg[1]? arg[1][1] : 0;
  a03=(a01-a02);
  a04=sin(a03);
  a05=(a00*a04);
  a06=1.;
  a07=(a00+a06);
  a05=(a05/a07);
  a08=sin(a01);
  a09=arg[2]? arg[2][0] : 0;
  a10=(a00/a07);
  a11=(a09-a10);
  a12=2.;
  a11=(a11+a12);
  a13=(a08*a11);
  a14=(a05-a13);
  a15=(a09+a12);
  a14=(a14/a15);
  a16=cos(a01);
  a17=(a16*a11);
  a03=cos(a03);
  a18=(a00*a03);
  a18=(a18/a07);
  a19=(a17-a18);
  a19=(a19/a15);
  a20=arg[1]? arg[1][2] : 0;
  a21=casadi_sq(a20);
  a22=(a21*a08);
  a22=(a22*a11);
  a23=arg[1]? arg[1][3] : 0;
  a24=(a00*a23);
  a25=sin(a02);
  a26=(a24*a25);
  a26=(a26/a07);
  a27=(2.*a20);
  a28=(a23-a27);
  a29=(a26*a28);
  a30=arg[2]? arg[2][2] : 0;
  a31=(a30-a01);
  a32=(a31+a02);
  a33=sin(a32);
  a34=(a00*a33);
  a34=(a34/a07);
  a29=(a29+a34);
  a34=sin(a31);
  a35=(a34*a11);
  a35=(a29-a35);
  a36=(2.*a00);
  a37=(a36*a00);
  a38=casadi_sq(a00);
  a39=(a38+a36);
  a39=(a39+a06);
  a37=(a37/a39);
  a36=(a36/a07);
  a39=cos(a02);
  a06=(a39+a06);
  a06=(a36*a06);
  a37=(a37-a06);
  a37=(a37+a09);
  a37=(a37+a12);
  a06=(a35/a37);
  a40=(a39-a10);
  a40=(a10*a40);
  a41=(a40/a37);
  a42=(a21*a25);
  a42=(a42-a33);
  a42=(a10*a42);
  a33=(a41*a35);
  a33=(a42-a33);
  a43=casadi_sq(a07);
  a38=(a38/a43);
  a43=(a40*a41);
  a38=(a38-a43);
  a33=(a33/a38);
  a43=(a41*a33);
  a43=(a06-a43);
  a44=(a43*a17);
  a44=(a22-a44);
  a45=sin(a30);
  a45=(a45*a15);
  a44=(a44-a45);
  a46=(a27*a23);
  a46=(a21-a46);
  a47=casadi_sq(a23);
  a46=(a46+a47);
  a47=(a05*a46);
  a44=(a44-a47);
  a47=(a43-a33);
  a48=(a18*a47);
  a44=(a44+a48);
  a49=(a19*a44);
  a30=cos(a30);
  a30=(a30*a15);
  a50=(a43*a13);
  a50=(a30-a50);
  a51=(a21*a17);
  a50=(a50-a51);
  a51=(a05*a47);
  a50=(a50+a51);
  a52=(a18*a46);
  a50=(a50+a52);
  a49=(a49/a50);
  a14=(a14-a49);
  a14=(-a14);
  if (res[0]!=0) res[0][0]=a14;
  a14=0.;
  if (res[0]!=0) res[0][1]=a14;
  a53=(a16*a20);
  a54=(a53*a20);
  a54=(a54*a11);
  a30=(a30-a54);
  a54=(a43*a11);
  a55=(a08*a54);
  a30=(a30-a55);
  a30=(a30+a52);
  a30=(a30+a51);
  if (res[0]!=0) res[0][2]=a30;
  a51=(a16*a54);
  a22=(a22-a51);
  a22=(a22-a45);
  a22=(a22+a48);
  a48=(a46*a05);
  a22=(a22-a48);
  a22=(a22/a30);
  if (res[0]!=0) res[0][3]=a22;
  a48=(a16-a03);
  if (res[0]!=0) res[0][4]=a48;
  a09=(a10-a09);
  a09=(a09-a12);
  a34=(a34*a09);
  a29=(a29+a34);
  a34=(a29/a37);
  a12=(a41*a29);
  a42=(a42-a12);
  a42=(a42/a38);
  a12=(a41*a42);
  a12=(a34-a12);
  if (res[0]!=0) res[0][5]=a12;
  a01=(2.*a01);
  a02=(a02-a01);
  if (res[0]!=0) res[0][6]=a02;
  if (res[0]!=0) res[0][7]=a14;
  a02=(a20-a23);
  a03=(a03*a02);
  a03=(a00*a03);
  a03=(a03/a07);
  a01=(a11*a53);
  a48=(a03-a01);
  a48=(a48/a15);
  a04=(a04*a02);
  a02=(a00*a04);
  a02=(a02/a07);
  a45=(a08*a20);
  a51=(a11*a45);
  a52=(a02-a51);
  a52=(a52/a15);
  a44=(a44*a52);
  a52=(a27*a12);
  a15=(a08*a52);
  a55=(a21*a53);
  a15=(a15+a55);
  a15=(a11*a15);
  a55=(a00*a42);
  a55=(a25*a55);
  a39=(a39*a23);
  a24=(a24*a39);
  a55=(a55+a24);
  a55=(a55/a07);
  a55=(a28*a55);
  a24=(2.*a12);
  a56=(a42-a24);
  a26=(a26*a56);
  a55=(a55+a26);
  a32=cos(a32);
  a26=(a23-a20);
  a32=(a32*a26);
  a00=(a00*a32);
  a00=(a00/a07);
  a55=(a55+a00);
  a31=cos(a31);
  a31=(a31*a20);
  a00=(a11*a31);
  a00=(a55+a00);
  a07=(a00/a37);
  a06=(a06/a37);
  a26=(a25*a23);
  a36=(a36*a26);
  a06=(a06*a36);
  a07=(a07-a06);
  a25=(a25*a52);
  a39=(a21*a39);
  a25=(a25+a39);
  a25=(a25-a32);
  a25=(a10*a25);
  a00=(a41*a00);
  a10=(a10*a26);
  a26=(a10/a37);
  a32=(a41/a37);
  a32=(a32*a36);
  a26=(a26+a32);
  a35=(a35*a26);
  a00=(a00-a35);
  a00=(a25-a00);
  a00=(a00/a38);
  a35=(a33/a38);
  a10=(a41*a10);
  a40=(a40*a26);
  a10=(a10+a40);
  a35=(a35*a10);
  a00=(a00-a35);
  a35=(a41*a00);
  a33=(a33*a26);
  a35=(a35-a33);
  a07=(a07-a35);
  a35=(a17*a07);
  a33=(a43*a51);
  a35=(a35-a33);
  a35=(a15-a35);
  a33=(a46*a03);
  a24=(a23*a24);
  a27=(a27*a42);
  a24=(a24+a27);
  a24=(a52-a24);
  a23=(2.*a23);
  a23=(a23*a42);
  a24=(a24+a23);
  a23=(a05*a24);
  a27=(a33+a23);
  a35=(a35-a27);
  a00=(a07-a00);
  a27=(a18*a00);
  a40=(a47*a02);
  a27=(a27-a40);
  a35=(a35+a27);
  a19=(a19*a35);
  a44=(a44+a19);
  a44=(a44/a50);
  a49=(a49/a50);
  a47=(a47*a03);
  a05=(a05*a00);
  a47=(a47+a05);
  a13=(a13*a07);
  a43=(a43*a01);
  a13=(a13+a43);
  a17=(a17*a52);
  a21=(a21*a51);
  a17=(a17-a21);
  a13=(a13+a17);
  a13=(a47-a13);
  a18=(a18*a24);
  a46=(a46*a02);
  a18=(a18-a46);
  a13=(a13+a18);
  a49=(a49*a13);
  a44=(a44-a49);
  a48=(a48-a44);
  a48=(-a48);
  if (res[1]!=0) res[1][0]=a48;
  if (res[1]!=0) res[1][1]=a14;
  a48=(a16*a12);
  a44=(a20*a45);
  a48=(a48-a44);
  a20=(a20*a48);
  a12=(a53*a12);
  a20=(a20+a12);
  a20=(a11*a20);
  a53=(a54*a53);
  a11=(a11*a07);
  a08=(a08*a11);
  a53=(a53+a08);
  a20=(a20+a53);
  a18=(a18-a20);
  a18=(a18+a47);
  if (res[1]!=0) res[1][2]=a18;
  a16=(a16*a11);
  a54=(a54*a45);
  a16=(a16-a54);
  a15=(a15-a16);
  a15=(a15+a27);
  a23=(a23+a33);
  a15=(a15-a23);
  a15=(a15/a30);
  a22=(a22/a30);
  a22=(a22*a18);
  a15=(a15-a22);
  if (res[1]!=0) res[1][3]=a15;
  a04=(a04-a45);
  if (res[1]!=0) res[1][4]=a04;
  a09=(a09*a31);
  a55=(a55-a09);
  a09=(a55/a37);
  a34=(a34/a37);
  a34=(a34*a36);
  a09=(a09-a34);
  a55=(a41*a55);
  a29=(a29*a26);
  a55=(a55-a29);
  a25=(a25-a55);
  a25=(a25/a38);
  a38=(a42/a38);
  a38=(a38*a10);
  a25=(a25-a38);
  a41=(a41*a25);
  a42=(a42*a26);
  a41=(a41-a42);
  a09=(a09-a41);
  if (res[1]!=0) res[1][5]=a09;
  if (res[1]!=0) res[1][6]=a28;
  if (res[1]!=0) res[1][7]=a14;
  return 0;
}

/* working_steps:(t,turns[2x12],w[4],h,p[3])->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+78, w01, *w02=w+82, *w03=w+85, w05, *w06=w+87, w07, *w08=w+91, *w09=w+95, *w10=w+99, *w11=w+103;
  casadi_real *w12=w+107, *w13=w+111, *w14=w+115, *w15=w+119, *w16=w+123, *w17=w+127, *w18=w+131, *w19=w+135, *w20=w+143, *w21=w+151, *w22=w+159, *w23=w+167;
  casadi_real *w24=w+175, *w25=w+183, *w26=w+191, *w27=w+199, *w28=w+207, *w29=w+215, *w30=w+223, *w31=w+231;
  const casadi_real **arg1=arg+5, *wr04;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 4, w00);
  /* #1: @1 = input[0][0] */
  w01 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w02);
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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
  arg1[2]=w02;
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

/* goswami_compass_trace_48:(u[4],p[3])->(w[4x49],g[8x49],dg[8x49],R[4]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1128;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: output[0][4] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+192);
  /* #24: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #25: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #26: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #27: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #28: {@17, @18} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w17;
  res1[1]=w18;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 8, res[1]+384);
  /* #30: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #31: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #32: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #33: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #34: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 8, res[2]+384);
  /* #35: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f100(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s7;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1136;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1136*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_72:(u[4],p[3])->(w[4x73],g[8x73],dg[8x73],R[4]) */
static int casadi_f104(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1216, *w19=w+1312, *w20=w+1408, *w21=w+1504;
  casadi_real *w22=w+1512;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+192);
  /* #27: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+240);
  /* #31: output[0][6] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+288);
  /* #32: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #33: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #34: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #35: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #36: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 96, res[1]+384);
  /* #37: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 96, res[1]+480);
  /* #38: {@21, @22} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w21;
  res1[1]=w22;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #39: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 8, res[1]+576);
  /* #40: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #41: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #42: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #43: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #44: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 96, res[2]+384);
  /* #45: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 96, res[2]+480);
  /* #46: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 8, res[2]+576);
  /* #47: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f104(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_72_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1520;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1520*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_96:(u[4],p[3])->(w[4x97],g[8x97],dg[8x97],R[4]) */
static int casadi_f105(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1216, *w19=w+1312, *w20=w+1408, *w21=w+1504;
  casadi_real *w22=w+1600, *w23=w+1696, *w24=w+1792, *w25=w+1888, *w26=w+1896;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+192);
  /* #27: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+240);
  /* #31: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+288);
  /* #35: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+336);
  /* #39: output[0][8] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+384);
  /* #40: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #41: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #42: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #43: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #44: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 96, res[1]+384);
  /* #45: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 96, res[1]+480);
  /* #46: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 96, res[1]+576);
  /* #47: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 96, res[1]+672);
  /* #48: {@25, @26} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w25;
  res1[1]=w26;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #49: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 8, res[1]+768);
  /* #50: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #51: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #52: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #53: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #54: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 96, res[2]+384);
  /* #55: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 96, res[2]+480);
  /* #56: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 96, res[2]+576);
  /* #57: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 96, res[2]+672);
  /* #58: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 8, res[2]+768);
  /* #59: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f105(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1904;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1904*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_144:(u[4],p[3])->(w[4x145],g[8x145],dg[8x145],R[4]) */
static int casadi_f106(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1216, *w19=w+1312, *w20=w+1408, *w21=w+1504;
  casadi_real *w22=w+1600, *w23=w+1696, *w24=w+1792, *w25=w+1888, *w26=w+1984, *w27=w+2080, *w28=w+2176, *w29=w+2272, *w30=w+2368, *w31=w+2464, *w32=w+2560, *w33=w+2656;
  casadi_real *w34=w+2664;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+192);
  /* #27: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+240);
  /* #31: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+288);
  /* #35: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+336);
  /* #39: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@7, @8, @25, @26} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+384);
  /* #43: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@1, @8, @27, @28} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+432);
  /* #47: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@7, @8, @29, @30} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+480);
  /* #51: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@1, @8, @31, @32} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+528);
  /* #55: output[0][12] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+576);
  /* #56: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #57: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #58: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #59: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #60: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 96, res[1]+384);
  /* #61: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 96, res[1]+480);
  /* #62: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 96, res[1]+576);
  /* #63: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 96, res[1]+672);
  /* #64: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 96, res[1]+768);
  /* #65: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 96, res[1]+864);
  /* #66: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 96, res[1]+960);
  /* #67: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 96, res[1]+1056);
  /* #68: {@33, @34} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w33;
  res1[1]=w34;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #69: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 8, res[1]+1152);
  /* #70: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #71: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #72: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #73: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #74: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 96, res[2]+384);
  /* #75: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 96, res[2]+480);
  /* #76: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 96, res[2]+576);
  /* #77: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 96, res[2]+672);
  /* #78: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 96, res[2]+768);
  /* #79: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 96, res[2]+864);
  /* #80: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 96, res[2]+960);
  /* #81: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 96, res[2]+1056);
  /* #82: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 8, res[2]+1152);
  /* #83: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f106(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_144_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2672;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2672*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_192:(u[4],p[3])->(w[4x193],g[8x193],dg[8x193],R[4]) */
static int casadi_f107(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1216, *w19=w+1312, *w20=w+1408, *w21=w+1504;
  casadi_real *w22=w+1600, *w23=w+1696, *w24=w+1792, *w25=w+1888, *w26=w+1984, *w27=w+2080, *w28=w+2176, *w29=w+2272, *w30=w+2368, *w31=w+2464, *w32=w+2560, *w33=w+2656;
  casadi_real *w34=w+2752, *w35=w+2848, *w36=w+2944, *w37=w+3040, *w38=w+3136, *w39=w+3232, *w40=w+3328, *w41=w+3424, *w42=w+3432;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+192);
  /* #27: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+240);
  /* #31: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+288);
  /* #35: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+336);
  /* #39: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@7, @8, @25, @26} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+384);
  /* #43: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@1, @8, @27, @28} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+432);
  /* #47: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@7, @8, @29, @30} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+480);
  /* #51: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@1, @8, @31, @32} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+528);
  /* #55: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@7, @8, @33, @34} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+576);
  /* #59: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@1, @8, @35, @36} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+624);
  /* #63: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@7, @8, @37, @38} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+672);
  /* #67: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@1, @8, @39, @40} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+720);
  /* #71: output[0][16] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+768);
  /* #72: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #73: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #74: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #75: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #76: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 96, res[1]+384);
  /* #77: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 96, res[1]+480);
  /* #78: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 96, res[1]+576);
  /* #79: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 96, res[1]+672);
  /* #80: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 96, res[1]+768);
  /* #81: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 96, res[1]+864);
  /* #82: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 96, res[1]+960);
  /* #83: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 96, res[1]+1056);
  /* #84: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 96, res[1]+1152);
  /* #85: output[1][13] = @35 */
  if (res[1]) casadi_copy(w35, 96, res[1]+1248);
  /* #86: output[1][14] = @37 */
  if (res[1]) casadi_copy(w37, 96, res[1]+1344);
  /* #87: output[1][15] = @39 */
  if (res[1]) casadi_copy(w39, 96, res[1]+1440);
  /* #88: {@41, @42} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w41;
  res1[1]=w42;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[1][16] = @41 */
  if (res[1]) casadi_copy(w41, 8, res[1]+1536);
  /* #90: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #91: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #92: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #93: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #94: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 96, res[2]+384);
  /* #95: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 96, res[2]+480);
  /* #96: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 96, res[2]+576);
  /* #97: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 96, res[2]+672);
  /* #98: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 96, res[2]+768);
  /* #99: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 96, res[2]+864);
  /* #100: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 96, res[2]+960);
  /* #101: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 96, res[2]+1056);
  /* #102: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 96, res[2]+1152);
  /* #103: output[2][13] = @36 */
  if (res[2]) casadi_copy(w36, 96, res[2]+1248);
  /* #104: output[2][14] = @38 */
  if (res[2]) casadi_copy(w38, 96, res[2]+1344);
  /* #105: output[2][15] = @40 */
  if (res[2]) casadi_copy(w40, 96, res[2]+1440);
  /* #106: output[2][16] = @42 */
  if (res[2]) casadi_copy(w42, 8, res[2]+1536);
  /* #107: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f107(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3440;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3440*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_288:(u[4],p[3])->(w[4x289],g[8x289],dg[8x289],R[4]) */
static int casadi_f108(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1216, *w19=w+1312, *w20=w+1408, *w21=w+1504;
  casadi_real *w22=w+1600, *w23=w+1696, *w24=w+1792, *w25=w+1888, *w26=w+1984, *w27=w+2080, *w28=w+2176, *w29=w+2272, *w30=w+2368, *w31=w+2464, *w32=w+2560, *w33=w+2656;
  casadi_real *w34=w+2752, *w35=w+2848, *w36=w+2944, *w37=w+3040, *w38=w+3136, *w39=w+3232, *w40=w+3328, *w41=w+3424, *w42=w+3520, *w43=w+3616, *w44=w+3712, *w45=w+3808;
  casadi_real *w46=w+3904, *w47=w+4000, *w48=w+4096, *w49=w+4192, *w50=w+4288, *w51=w+4384, *w52=w+4480, *w53=w+4576, *w54=w+4672, *w55=w+4768, *w56=w+4864, *w57=w+4960;
  casadi_real *w58=w+4968;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.0416667 */
  w00 = 4.1666666666666664e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+192);
  /* #27: @0 = 0.208333 */
  w00 = 2.0833333333333334e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+240);
  /* #31: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+288);
  /* #35: @0 = 0.291667 */
  w00 = 2.9166666666666669e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+336);
  /* #39: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@7, @8, @25, @26} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+384);
  /* #43: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@1, @8, @27, @28} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+432);
  /* #47: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@7, @8, @29, @30} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+480);
  /* #51: @0 = 0.458333 */
  w00 = 4.5833333333333331e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@1, @8, @31, @32} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+528);
  /* #55: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@7, @8, @33, @34} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+576);
  /* #59: @0 = 0.541667 */
  w00 = 5.4166666666666663e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@1, @8, @35, @36} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+624);
  /* #63: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@7, @8, @37, @38} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+672);
  /* #67: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@1, @8, @39, @40} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+720);
  /* #71: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #72: @0 = (@0*@2) */
  w00 *= w02;
  /* #73: {@7, @8, @41, @42} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+768);
  /* #75: @0 = 0.708333 */
  w00 = 7.0833333333333337e-01;
  /* #76: @0 = (@0*@2) */
  w00 *= w02;
  /* #77: {@1, @8, @43, @44} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w43;
  res1[3]=w44;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+816);
  /* #79: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w00 *= w02;
  /* #81: {@7, @8, @45, @46} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w45;
  res1[3]=w46;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+864);
  /* #83: @0 = 0.791667 */
  w00 = 7.9166666666666663e-01;
  /* #84: @0 = (@0*@2) */
  w00 *= w02;
  /* #85: {@1, @8, @47, @48} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w47;
  res1[3]=w48;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+912);
  /* #87: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #88: @0 = (@0*@2) */
  w00 *= w02;
  /* #89: {@7, @8, @49, @50} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w49;
  res1[3]=w50;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+960);
  /* #91: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w00 *= w02;
  /* #93: {@1, @8, @51, @52} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w51;
  res1[3]=w52;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1008);
  /* #95: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #96: @0 = (@0*@2) */
  w00 *= w02;
  /* #97: {@7, @8, @53, @54} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w53;
  res1[3]=w54;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1056);
  /* #99: @0 = 0.958333 */
  w00 = 9.5833333333333337e-01;
  /* #100: @0 = (@0*@2) */
  w00 *= w02;
  /* #101: {@1, @8, @55, @56} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w55;
  res1[3]=w56;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1104);
  /* #103: output[0][24] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+1152);
  /* #104: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #105: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #106: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #107: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #108: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 96, res[1]+384);
  /* #109: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 96, res[1]+480);
  /* #110: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 96, res[1]+576);
  /* #111: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 96, res[1]+672);
  /* #112: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 96, res[1]+768);
  /* #113: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 96, res[1]+864);
  /* #114: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 96, res[1]+960);
  /* #115: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 96, res[1]+1056);
  /* #116: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 96, res[1]+1152);
  /* #117: output[1][13] = @35 */
  if (res[1]) casadi_copy(w35, 96, res[1]+1248);
  /* #118: output[1][14] = @37 */
  if (res[1]) casadi_copy(w37, 96, res[1]+1344);
  /* #119: output[1][15] = @39 */
  if (res[1]) casadi_copy(w39, 96, res[1]+1440);
  /* #120: output[1][16] = @41 */
  if (res[1]) casadi_copy(w41, 96, res[1]+1536);
  /* #121: output[1][17] = @43 */
  if (res[1]) casadi_copy(w43, 96, res[1]+1632);
  /* #122: output[1][18] = @45 */
  if (res[1]) casadi_copy(w45, 96, res[1]+1728);
  /* #123: output[1][19] = @47 */
  if (res[1]) casadi_copy(w47, 96, res[1]+1824);
  /* #124: output[1][20] = @49 */
  if (res[1]) casadi_copy(w49, 96, res[1]+1920);
  /* #125: output[1][21] = @51 */
  if (res[1]) casadi_copy(w51, 96, res[1]+2016);
  /* #126: output[1][22] = @53 */
  if (res[1]) casadi_copy(w53, 96, res[1]+2112);
  /* #127: output[1][23] = @55 */
  if (res[1]) casadi_copy(w55, 96, res[1]+2208);
  /* #128: {@57, @58} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w57;
  res1[1]=w58;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #129: output[1][24] = @57 */
  if (res[1]) casadi_copy(w57, 8, res[1]+2304);
  /* #130: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #131: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #132: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #133: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #134: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 96, res[2]+384);
  /* #135: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 96, res[2]+480);
  /* #136: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 96, res[2]+576);
  /* #137: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 96, res[2]+672);
  /* #138: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 96, res[2]+768);
  /* #139: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 96, res[2]+864);
  /* #140: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 96, res[2]+960);
  /* #141: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 96, res[2]+1056);
  /* #142: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 96, res[2]+1152);
  /* #143: output[2][13] = @36 */
  if (res[2]) casadi_copy(w36, 96, res[2]+1248);
  /* #144: output[2][14] = @38 */
  if (res[2]) casadi_copy(w38, 96, res[2]+1344);
  /* #145: output[2][15] = @40 */
  if (res[2]) casadi_copy(w40, 96, res[2]+1440);
  /* #146: output[2][16] = @42 */
  if (res[2]) casadi_copy(w42, 96, res[2]+1536);
  /* #147: output[2][17] = @44 */
  if (res[2]) casadi_copy(w44, 96, res[2]+1632);
  /* #148: output[2][18] = @46 */
  if (res[2]) casadi_copy(w46, 96, res[2]+1728);
  /* #149: output[2][19] = @48 */
  if (res[2]) casadi_copy(w48, 96, res[2]+1824);
  /* #150: output[2][20] = @50 */
  if (res[2]) casadi_copy(w50, 96, res[2]+1920);
  /* #151: output[2][21] = @52 */
  if (res[2]) casadi_copy(w52, 96, res[2]+2016);
  /* #152: output[2][22] = @54 */
  if (res[2]) casadi_copy(w54, 96, res[2]+2112);
  /* #153: output[2][23] = @56 */
  if (res[2]) casadi_copy(w56, 96, res[2]+2208);
  /* #154: output[2][24] = @58 */
  if (res[2]) casadi_copy(w58, 8, res[2]+2304);
  /* #155: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f108(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_288_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s18;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 4976;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4976*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_384:(u[4],p[3])->(w[4x385],g[8x385],dg[8x385],R[4]) */
static int casadi_f109(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+266, w02, w03, *w04=w+270, *w05=w+273, *w06=w+297, *w07=w+300, *w08=w+304, *w09=w+352;
  casadi_real *w10=w+448, *w11=w+544, *w12=w+640, *w13=w+736, *w14=w+832, *w15=w+928, *w16=w+1024, *w17=w+1120, *w18=w+1216, *w19=w+1312, *w20=w+1408, *w21=w+1504;
  casadi_real *w22=w+1600, *w23=w+1696, *w24=w+1792, *w25=w+1888, *w26=w+1984, *w27=w+2080, *w28=w+2176, *w29=w+2272, *w30=w+2368, *w31=w+2464, *w32=w+2560, *w33=w+2656;
  casadi_real *w34=w+2752, *w35=w+2848, *w36=w+2944, *w37=w+3040, *w38=w+3136, *w39=w+3232, *w40=w+3328, *w41=w+3424, *w42=w+3520, *w43=w+3616, *w44=w+3712, *w45=w+3808;
  casadi_real *w46=w+3904, *w47=w+4000, *w48=w+4096, *w49=w+4192, *w50=w+4288, *w51=w+4384, *w52=w+4480, *w53=w+4576, *w54=w+4672, *w55=w+4768, *w56=w+4864, *w57=w+4960;
  casadi_real *w58=w+5056, *w59=w+5152, *w60=w+5248, *w61=w+5344, *w62=w+5440, *w63=w+5536, *w64=w+5632, *w65=w+5728, *w66=w+5824, *w67=w+5920, *w68=w+6016, *w69=w+6112;
  casadi_real *w70=w+6208, *w71=w+6304, *w72=w+6400, *w73=w+6496, *w74=w+6504;
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
  casadi_copy(arg[1], 3, w04);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w09;
  res1[3]=w10;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w08, 48, res[0]);
  /* #11: @0 = 0.03125 */
  w00 = 3.1250000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w11;
  res1[3]=w12;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+48);
  /* #15: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w13;
  res1[3]=w14;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+96);
  /* #19: @0 = 0.09375 */
  w00 = 9.3750000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w15;
  res1[3]=w16;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+144);
  /* #23: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w17;
  res1[3]=w18;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+192);
  /* #27: @0 = 0.15625 */
  w00 = 1.5625000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w19;
  res1[3]=w20;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+240);
  /* #31: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w21;
  res1[3]=w22;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+288);
  /* #35: @0 = 0.21875 */
  w00 = 2.1875000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w23;
  res1[3]=w24;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+336);
  /* #39: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@7, @8, @25, @26} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w25;
  res1[3]=w26;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+384);
  /* #43: @0 = 0.28125 */
  w00 = 2.8125000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@1, @8, @27, @28} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w27;
  res1[3]=w28;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+432);
  /* #47: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@7, @8, @29, @30} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w29;
  res1[3]=w30;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+480);
  /* #51: @0 = 0.34375 */
  w00 = 3.4375000000000000e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@1, @8, @31, @32} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w31;
  res1[3]=w32;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+528);
  /* #55: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@7, @8, @33, @34} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w33;
  res1[3]=w34;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+576);
  /* #59: @0 = 0.40625 */
  w00 = 4.0625000000000000e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@1, @8, @35, @36} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w35;
  res1[3]=w36;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+624);
  /* #63: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@7, @8, @37, @38} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w37;
  res1[3]=w38;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+672);
  /* #67: @0 = 0.46875 */
  w00 = 4.6875000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@1, @8, @39, @40} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w39;
  res1[3]=w40;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+720);
  /* #71: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #72: @0 = (@0*@2) */
  w00 *= w02;
  /* #73: {@7, @8, @41, @42} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w41;
  res1[3]=w42;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+768);
  /* #75: @0 = 0.53125 */
  w00 = 5.3125000000000000e-01;
  /* #76: @0 = (@0*@2) */
  w00 *= w02;
  /* #77: {@1, @8, @43, @44} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w43;
  res1[3]=w44;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+816);
  /* #79: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w00 *= w02;
  /* #81: {@7, @8, @45, @46} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w45;
  res1[3]=w46;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+864);
  /* #83: @0 = 0.59375 */
  w00 = 5.9375000000000000e-01;
  /* #84: @0 = (@0*@2) */
  w00 *= w02;
  /* #85: {@1, @8, @47, @48} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w47;
  res1[3]=w48;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+912);
  /* #87: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #88: @0 = (@0*@2) */
  w00 *= w02;
  /* #89: {@7, @8, @49, @50} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w49;
  res1[3]=w50;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+960);
  /* #91: @0 = 0.65625 */
  w00 = 6.5625000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w00 *= w02;
  /* #93: {@1, @8, @51, @52} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w51;
  res1[3]=w52;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1008);
  /* #95: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #96: @0 = (@0*@2) */
  w00 *= w02;
  /* #97: {@7, @8, @53, @54} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w53;
  res1[3]=w54;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1056);
  /* #99: @0 = 0.71875 */
  w00 = 7.1875000000000000e-01;
  /* #100: @0 = (@0*@2) */
  w00 *= w02;
  /* #101: {@1, @8, @55, @56} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w55;
  res1[3]=w56;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1104);
  /* #103: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w00 *= w02;
  /* #105: {@7, @8, @57, @58} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w57;
  res1[3]=w58;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1152);
  /* #107: @0 = 0.78125 */
  w00 = 7.8125000000000000e-01;
  /* #108: @0 = (@0*@2) */
  w00 *= w02;
  /* #109: {@1, @8, @59, @60} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w59;
  res1[3]=w60;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1200);
  /* #111: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #112: @0 = (@0*@2) */
  w00 *= w02;
  /* #113: {@7, @8, @61, @62} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w61;
  res1[3]=w62;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1248);
  /* #115: @0 = 0.84375 */
  w00 = 8.4375000000000000e-01;
  /* #116: @0 = (@0*@2) */
  w00 *= w02;
  /* #117: {@1, @8, @63, @64} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w63;
  res1[3]=w64;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1296);
  /* #119: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #120: @0 = (@0*@2) */
  w00 *= w02;
  /* #121: {@7, @8, @65, @66} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w65;
  res1[3]=w66;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1344);
  /* #123: @0 = 0.90625 */
  w00 = 9.0625000000000000e-01;
  /* #124: @0 = (@0*@2) */
  w00 *= w02;
  /* #125: {@1, @8, @67, @68} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w67;
  res1[3]=w68;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1392);
  /* #127: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w00 *= w02;
  /* #129: {@7, @8, @69, @70} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w01;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w08;
  res1[2]=w69;
  res1[3]=w70;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1440);
  /* #131: @0 = 0.96875 */
  w00 = 9.6875000000000000e-01;
  /* #132: @0 = (@0*@2) */
  w00 *= w02;
  /* #133: {@1, @8, @71, @72} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w01;
  res1[1]=w08;
  res1[2]=w71;
  res1[3]=w72;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @8 */
  if (res[0]) casadi_copy(w08, 48, res[0]+1488);
  /* #135: output[0][32] = @1 */
  if (res[0]) casadi_copy(w01, 4, res[0]+1536);
  /* #136: output[1][0] = @9 */
  casadi_copy(w09, 96, res[1]);
  /* #137: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 96, res[1]+96);
  /* #138: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 96, res[1]+192);
  /* #139: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 96, res[1]+288);
  /* #140: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 96, res[1]+384);
  /* #141: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 96, res[1]+480);
  /* #142: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 96, res[1]+576);
  /* #143: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 96, res[1]+672);
  /* #144: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 96, res[1]+768);
  /* #145: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 96, res[1]+864);
  /* #146: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 96, res[1]+960);
  /* #147: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 96, res[1]+1056);
  /* #148: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 96, res[1]+1152);
  /* #149: output[1][13] = @35 */
  if (res[1]) casadi_copy(w35, 96, res[1]+1248);
  /* #150: output[1][14] = @37 */
  if (res[1]) casadi_copy(w37, 96, res[1]+1344);
  /* #151: output[1][15] = @39 */
  if (res[1]) casadi_copy(w39, 96, res[1]+1440);
  /* #152: output[1][16] = @41 */
  if (res[1]) casadi_copy(w41, 96, res[1]+1536);
  /* #153: output[1][17] = @43 */
  if (res[1]) casadi_copy(w43, 96, res[1]+1632);
  /* #154: output[1][18] = @45 */
  if (res[1]) casadi_copy(w45, 96, res[1]+1728);
  /* #155: output[1][19] = @47 */
  if (res[1]) casadi_copy(w47, 96, res[1]+1824);
  /* #156: output[1][20] = @49 */
  if (res[1]) casadi_copy(w49, 96, res[1]+1920);
  /* #157: output[1][21] = @51 */
  if (res[1]) casadi_copy(w51, 96, res[1]+2016);
  /* #158: output[1][22] = @53 */
  if (res[1]) casadi_copy(w53, 96, res[1]+2112);
  /* #159: output[1][23] = @55 */
  if (res[1]) casadi_copy(w55, 96, res[1]+2208);
  /* #160: output[1][24] = @57 */
  if (res[1]) casadi_copy(w57, 96, res[1]+2304);
  /* #161: output[1][25] = @59 */
  if (res[1]) casadi_copy(w59, 96, res[1]+2400);
  /* #162: output[1][26] = @61 */
  if (res[1]) casadi_copy(w61, 96, res[1]+2496);
  /* #163: output[1][27] = @63 */
  if (res[1]) casadi_copy(w63, 96, res[1]+2592);
  /* #164: output[1][28] = @65 */
  if (res[1]) casadi_copy(w65, 96, res[1]+2688);
  /* #165: output[1][29] = @67 */
  if (res[1]) casadi_copy(w67, 96, res[1]+2784);
  /* #166: output[1][30] = @69 */
  if (res[1]) casadi_copy(w69, 96, res[1]+2880);
  /* #167: output[1][31] = @71 */
  if (res[1]) casadi_copy(w71, 96, res[1]+2976);
  /* #168: {@73, @74} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w73;
  res1[1]=w74;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #169: output[1][32] = @73 */
  if (res[1]) casadi_copy(w73, 8, res[1]+3072);
  /* #170: output[2][0] = @10 */
  casadi_copy(w10, 96, res[2]);
  /* #171: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 96, res[2]+96);
  /* #172: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 96, res[2]+192);
  /* #173: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 96, res[2]+288);
  /* #174: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 96, res[2]+384);
  /* #175: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 96, res[2]+480);
  /* #176: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 96, res[2]+576);
  /* #177: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 96, res[2]+672);
  /* #178: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 96, res[2]+768);
  /* #179: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 96, res[2]+864);
  /* #180: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 96, res[2]+960);
  /* #181: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 96, res[2]+1056);
  /* #182: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 96, res[2]+1152);
  /* #183: output[2][13] = @36 */
  if (res[2]) casadi_copy(w36, 96, res[2]+1248);
  /* #184: output[2][14] = @38 */
  if (res[2]) casadi_copy(w38, 96, res[2]+1344);
  /* #185: output[2][15] = @40 */
  if (res[2]) casadi_copy(w40, 96, res[2]+1440);
  /* #186: output[2][16] = @42 */
  if (res[2]) casadi_copy(w42, 96, res[2]+1536);
  /* #187: output[2][17] = @44 */
  if (res[2]) casadi_copy(w44, 96, res[2]+1632);
  /* #188: output[2][18] = @46 */
  if (res[2]) casadi_copy(w46, 96, res[2]+1728);
  /* #189: output[2][19] = @48 */
  if (res[2]) casadi_copy(w48, 96, res[2]+1824);
  /* #190: output[2][20] = @50 */
  if (res[2]) casadi_copy(w50, 96, res[2]+1920);
  /* #191: output[2][21] = @52 */
  if (res[2]) casadi_copy(w52, 96, res[2]+2016);
  /* #192: output[2][22] = @54 */
  if (res[2]) casadi_copy(w54, 96, res[2]+2112);
  /* #193: output[2][23] = @56 */
  if (res[2]) casadi_copy(w56, 96, res[2]+2208);
  /* #194: output[2][24] = @58 */
  if (res[2]) casadi_copy(w58, 96, res[2]+2304);
  /* #195: output[2][25] = @60 */
  if (res[2]) casadi_copy(w60, 96, res[2]+2400);
  /* #196: output[2][26] = @62 */
  if (res[2]) casadi_copy(w62, 96, res[2]+2496);
  /* #197: output[2][27] = @64 */
  if (res[2]) casadi_copy(w64, 96, res[2]+2592);
  /* #198: output[2][28] = @66 */
  if (res[2]) casadi_copy(w66, 96, res[2]+2688);
  /* #199: output[2][29] = @68 */
  if (res[2]) casadi_copy(w68, 96, res[2]+2784);
  /* #200: output[2][30] = @70 */
  if (res[2]) casadi_copy(w70, 96, res[2]+2880);
  /* #201: output[2][31] = @72 */
  if (res[2]) casadi_copy(w72, 96, res[2]+2976);
  /* #202: output[2][32] = @74 */
  if (res[2]) casadi_copy(w74, 8, res[2]+3072);
  /* #203: @7 = landing(@1, @6, @4) */
  arg1[0]=w01;
  arg1[1]=w06;
  arg1[2]=w04;
  res1[0]=w07;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #204: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f109(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s19;
    case 1: return casadi_s20;
    case 2: return casadi_s20;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6512;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6512*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_576:(u[4],p[3])->(w[4x577],g[8x577],dg[8x577],R[4]) */
static int casadi_f110(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+266, w002, w003, *w004=w+270, *w005=w+273, *w006=w+297, *w007=w+300, *w008=w+304, *w009=w+352;
  casadi_real *w010=w+448, *w011=w+544, *w012=w+640, *w013=w+736, *w014=w+832, *w015=w+928, *w016=w+1024, *w017=w+1120, *w018=w+1216, *w019=w+1312, *w020=w+1408, *w021=w+1504;
  casadi_real *w022=w+1600, *w023=w+1696, *w024=w+1792, *w025=w+1888, *w026=w+1984, *w027=w+2080, *w028=w+2176, *w029=w+2272, *w030=w+2368, *w031=w+2464, *w032=w+2560, *w033=w+2656;
  casadi_real *w034=w+2752, *w035=w+2848, *w036=w+2944, *w037=w+3040, *w038=w+3136, *w039=w+3232, *w040=w+3328, *w041=w+3424, *w042=w+3520, *w043=w+3616, *w044=w+3712, *w045=w+3808;
  casadi_real *w046=w+3904, *w047=w+4000, *w048=w+4096, *w049=w+4192, *w050=w+4288, *w051=w+4384, *w052=w+4480, *w053=w+4576, *w054=w+4672, *w055=w+4768, *w056=w+4864, *w057=w+4960;
  casadi_real *w058=w+5056, *w059=w+5152, *w060=w+5248, *w061=w+5344, *w062=w+5440, *w063=w+5536, *w064=w+5632, *w065=w+5728, *w066=w+5824, *w067=w+5920, *w068=w+6016, *w069=w+6112;
  casadi_real *w070=w+6208, *w071=w+6304, *w072=w+6400, *w073=w+6496, *w074=w+6592, *w075=w+6688, *w076=w+6784, *w077=w+6880, *w078=w+6976, *w079=w+7072, *w080=w+7168, *w081=w+7264;
  casadi_real *w082=w+7360, *w083=w+7456, *w084=w+7552, *w085=w+7648, *w086=w+7744, *w087=w+7840, *w088=w+7936, *w089=w+8032, *w090=w+8128, *w091=w+8224, *w092=w+8320, *w093=w+8416;
  casadi_real *w094=w+8512, *w095=w+8608, *w096=w+8704, *w097=w+8800, *w098=w+8896, *w099=w+8992, *w100=w+9088, *w101=w+9184, *w102=w+9280, *w103=w+9376, *w104=w+9472, *w105=w+9568;
  casadi_real *w106=w+9576;
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
  casadi_copy(arg[1], 3, w004);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w009;
  res1[3]=w010;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w008, 48, res[0]);
  /* #11: @0 = 0.0208333 */
  w000 = 2.0833333333333332e-02;
  /* #12: @0 = (@0*@2) */
  w000 *= w002;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w011;
  res1[3]=w012;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+48);
  /* #15: @0 = 0.0416667 */
  w000 = 4.1666666666666664e-02;
  /* #16: @0 = (@0*@2) */
  w000 *= w002;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w013;
  res1[3]=w014;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+96);
  /* #19: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w000 *= w002;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w015;
  res1[3]=w016;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+144);
  /* #23: @0 = 0.0833333 */
  w000 = 8.3333333333333329e-02;
  /* #24: @0 = (@0*@2) */
  w000 *= w002;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w017;
  res1[3]=w018;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+192);
  /* #27: @0 = 0.104167 */
  w000 = 1.0416666666666667e-01;
  /* #28: @0 = (@0*@2) */
  w000 *= w002;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w019;
  res1[3]=w020;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+240);
  /* #31: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w000 *= w002;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w021;
  res1[3]=w022;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+288);
  /* #35: @0 = 0.145833 */
  w000 = 1.4583333333333334e-01;
  /* #36: @0 = (@0*@2) */
  w000 *= w002;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w023;
  res1[3]=w024;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+336);
  /* #39: @0 = 0.166667 */
  w000 = 1.6666666666666666e-01;
  /* #40: @0 = (@0*@2) */
  w000 *= w002;
  /* #41: {@7, @8, @25, @26} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w025;
  res1[3]=w026;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+384);
  /* #43: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w000 *= w002;
  /* #45: {@1, @8, @27, @28} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w027;
  res1[3]=w028;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+432);
  /* #47: @0 = 0.208333 */
  w000 = 2.0833333333333334e-01;
  /* #48: @0 = (@0*@2) */
  w000 *= w002;
  /* #49: {@7, @8, @29, @30} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w029;
  res1[3]=w030;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+480);
  /* #51: @0 = 0.229167 */
  w000 = 2.2916666666666666e-01;
  /* #52: @0 = (@0*@2) */
  w000 *= w002;
  /* #53: {@1, @8, @31, @32} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w031;
  res1[3]=w032;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+528);
  /* #55: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w000 *= w002;
  /* #57: {@7, @8, @33, @34} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w033;
  res1[3]=w034;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+576);
  /* #59: @0 = 0.270833 */
  w000 = 2.7083333333333331e-01;
  /* #60: @0 = (@0*@2) */
  w000 *= w002;
  /* #61: {@1, @8, @35, @36} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w035;
  res1[3]=w036;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+624);
  /* #63: @0 = 0.291667 */
  w000 = 2.9166666666666669e-01;
  /* #64: @0 = (@0*@2) */
  w000 *= w002;
  /* #65: {@7, @8, @37, @38} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w037;
  res1[3]=w038;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+672);
  /* #67: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w000 *= w002;
  /* #69: {@1, @8, @39, @40} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w039;
  res1[3]=w040;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+720);
  /* #71: @0 = 0.333333 */
  w000 = 3.3333333333333331e-01;
  /* #72: @0 = (@0*@2) */
  w000 *= w002;
  /* #73: {@7, @8, @41, @42} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w041;
  res1[3]=w042;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+768);
  /* #75: @0 = 0.354167 */
  w000 = 3.5416666666666669e-01;
  /* #76: @0 = (@0*@2) */
  w000 *= w002;
  /* #77: {@1, @8, @43, @44} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w043;
  res1[3]=w044;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+816);
  /* #79: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w000 *= w002;
  /* #81: {@7, @8, @45, @46} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w045;
  res1[3]=w046;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+864);
  /* #83: @0 = 0.395833 */
  w000 = 3.9583333333333331e-01;
  /* #84: @0 = (@0*@2) */
  w000 *= w002;
  /* #85: {@1, @8, @47, @48} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w047;
  res1[3]=w048;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+912);
  /* #87: @0 = 0.416667 */
  w000 = 4.1666666666666669e-01;
  /* #88: @0 = (@0*@2) */
  w000 *= w002;
  /* #89: {@7, @8, @49, @50} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w049;
  res1[3]=w050;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+960);
  /* #91: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w000 *= w002;
  /* #93: {@1, @8, @51, @52} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w051;
  res1[3]=w052;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1008);
  /* #95: @0 = 0.458333 */
  w000 = 4.5833333333333331e-01;
  /* #96: @0 = (@0*@2) */
  w000 *= w002;
  /* #97: {@7, @8, @53, @54} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w053;
  res1[3]=w054;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1056);
  /* #99: @0 = 0.479167 */
  w000 = 4.7916666666666669e-01;
  /* #100: @0 = (@0*@2) */
  w000 *= w002;
  /* #101: {@1, @8, @55, @56} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w055;
  res1[3]=w056;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1104);
  /* #103: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w000 *= w002;
  /* #105: {@7, @8, @57, @58} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w057;
  res1[3]=w058;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1152);
  /* #107: @0 = 0.520833 */
  w000 = 5.2083333333333337e-01;
  /* #108: @0 = (@0*@2) */
  w000 *= w002;
  /* #109: {@1, @8, @59, @60} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w059;
  res1[3]=w060;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1200);
  /* #111: @0 = 0.541667 */
  w000 = 5.4166666666666663e-01;
  /* #112: @0 = (@0*@2) */
  w000 *= w002;
  /* #113: {@7, @8, @61, @62} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w061;
  res1[3]=w062;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1248);
  /* #115: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #116: @0 = (@0*@2) */
  w000 *= w002;
  /* #117: {@1, @8, @63, @64} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w063;
  res1[3]=w064;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1296);
  /* #119: @0 = 0.583333 */
  w000 = 5.8333333333333337e-01;
  /* #120: @0 = (@0*@2) */
  w000 *= w002;
  /* #121: {@7, @8, @65, @66} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w065;
  res1[3]=w066;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1344);
  /* #123: @0 = 0.604167 */
  w000 = 6.0416666666666663e-01;
  /* #124: @0 = (@0*@2) */
  w000 *= w002;
  /* #125: {@1, @8, @67, @68} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w067;
  res1[3]=w068;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1392);
  /* #127: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w000 *= w002;
  /* #129: {@7, @8, @69, @70} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w069;
  res1[3]=w070;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1440);
  /* #131: @0 = 0.645833 */
  w000 = 6.4583333333333337e-01;
  /* #132: @0 = (@0*@2) */
  w000 *= w002;
  /* #133: {@1, @8, @71, @72} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w071;
  res1[3]=w072;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1488);
  /* #135: @0 = 0.666667 */
  w000 = 6.6666666666666663e-01;
  /* #136: @0 = (@0*@2) */
  w000 *= w002;
  /* #137: {@7, @8, @73, @74} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w073;
  res1[3]=w074;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #138: output[0][32] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1536);
  /* #139: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #140: @0 = (@0*@2) */
  w000 *= w002;
  /* #141: {@1, @8, @75, @76} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w075;
  res1[3]=w076;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #142: output[0][33] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1584);
  /* #143: @0 = 0.708333 */
  w000 = 7.0833333333333337e-01;
  /* #144: @0 = (@0*@2) */
  w000 *= w002;
  /* #145: {@7, @8, @77, @78} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w077;
  res1[3]=w078;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #146: output[0][34] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1632);
  /* #147: @0 = 0.729167 */
  w000 = 7.2916666666666663e-01;
  /* #148: @0 = (@0*@2) */
  w000 *= w002;
  /* #149: {@1, @8, @79, @80} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w079;
  res1[3]=w080;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #150: output[0][35] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1680);
  /* #151: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #152: @0 = (@0*@2) */
  w000 *= w002;
  /* #153: {@7, @8, @81, @82} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w081;
  res1[3]=w082;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #154: output[0][36] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1728);
  /* #155: @0 = 0.770833 */
  w000 = 7.7083333333333337e-01;
  /* #156: @0 = (@0*@2) */
  w000 *= w002;
  /* #157: {@1, @8, @83, @84} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w083;
  res1[3]=w084;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #158: output[0][37] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1776);
  /* #159: @0 = 0.791667 */
  w000 = 7.9166666666666663e-01;
  /* #160: @0 = (@0*@2) */
  w000 *= w002;
  /* #161: {@7, @8, @85, @86} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w085;
  res1[3]=w086;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #162: output[0][38] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1824);
  /* #163: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #164: @0 = (@0*@2) */
  w000 *= w002;
  /* #165: {@1, @8, @87, @88} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w087;
  res1[3]=w088;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][39] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1872);
  /* #167: @0 = 0.833333 */
  w000 = 8.3333333333333337e-01;
  /* #168: @0 = (@0*@2) */
  w000 *= w002;
  /* #169: {@7, @8, @89, @90} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w089;
  res1[3]=w090;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #170: output[0][40] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1920);
  /* #171: @0 = 0.854167 */
  w000 = 8.5416666666666663e-01;
  /* #172: @0 = (@0*@2) */
  w000 *= w002;
  /* #173: {@1, @8, @91, @92} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w091;
  res1[3]=w092;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #174: output[0][41] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1968);
  /* #175: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #176: @0 = (@0*@2) */
  w000 *= w002;
  /* #177: {@7, @8, @93, @94} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w093;
  res1[3]=w094;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #178: output[0][42] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2016);
  /* #179: @0 = 0.895833 */
  w000 = 8.9583333333333337e-01;
  /* #180: @0 = (@0*@2) */
  w000 *= w002;
  /* #181: {@1, @8, @95, @96} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w095;
  res1[3]=w096;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #182: output[0][43] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2064);
  /* #183: @0 = 0.916667 */
  w000 = 9.1666666666666663e-01;
  /* #184: @0 = (@0*@2) */
  w000 *= w002;
  /* #185: {@7, @8, @97, @98} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w097;
  res1[3]=w098;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #186: output[0][44] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2112);
  /* #187: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #188: @0 = (@0*@2) */
  w000 *= w002;
  /* #189: {@1, @8, @99, @100} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w099;
  res1[3]=w100;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #190: output[0][45] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2160);
  /* #191: @0 = 0.958333 */
  w000 = 9.5833333333333337e-01;
  /* #192: @0 = (@0*@2) */
  w000 *= w002;
  /* #193: {@7, @8, @101, @102} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w101;
  res1[3]=w102;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #194: output[0][46] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2208);
  /* #195: @0 = 0.979167 */
  w000 = 9.7916666666666663e-01;
  /* #196: @0 = (@0*@2) */
  w000 *= w002;
  /* #197: {@1, @8, @103, @104} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w103;
  res1[3]=w104;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #198: output[0][47] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2256);
  /* #199: output[0][48] = @1 */
  if (res[0]) casadi_copy(w001, 4, res[0]+2304);
  /* #200: output[1][0] = @9 */
  casadi_copy(w009, 96, res[1]);
  /* #201: output[1][1] = @11 */
  if (res[1]) casadi_copy(w011, 96, res[1]+96);
  /* #202: output[1][2] = @13 */
  if (res[1]) casadi_copy(w013, 96, res[1]+192);
  /* #203: output[1][3] = @15 */
  if (res[1]) casadi_copy(w015, 96, res[1]+288);
  /* #204: output[1][4] = @17 */
  if (res[1]) casadi_copy(w017, 96, res[1]+384);
  /* #205: output[1][5] = @19 */
  if (res[1]) casadi_copy(w019, 96, res[1]+480);
  /* #206: output[1][6] = @21 */
  if (res[1]) casadi_copy(w021, 96, res[1]+576);
  /* #207: output[1][7] = @23 */
  if (res[1]) casadi_copy(w023, 96, res[1]+672);
  /* #208: output[1][8] = @25 */
  if (res[1]) casadi_copy(w025, 96, res[1]+768);
  /* #209: output[1][9] = @27 */
  if (res[1]) casadi_copy(w027, 96, res[1]+864);
  /* #210: output[1][10] = @29 */
  if (res[1]) casadi_copy(w029, 96, res[1]+960);
  /* #211: output[1][11] = @31 */
  if (res[1]) casadi_copy(w031, 96, res[1]+1056);
  /* #212: output[1][12] = @33 */
  if (res[1]) casadi_copy(w033, 96, res[1]+1152);
  /* #213: output[1][13] = @35 */
  if (res[1]) casadi_copy(w035, 96, res[1]+1248);
  /* #214: output[1][14] = @37 */
  if (res[1]) casadi_copy(w037, 96, res[1]+1344);
  /* #215: output[1][15] = @39 */
  if (res[1]) casadi_copy(w039, 96, res[1]+1440);
  /* #216: output[1][16] = @41 */
  if (res[1]) casadi_copy(w041, 96, res[1]+1536);
  /* #217: output[1][17] = @43 */
  if (res[1]) casadi_copy(w043, 96, res[1]+1632);
  /* #218: output[1][18] = @45 */
  if (res[1]) casadi_copy(w045, 96, res[1]+1728);
  /* #219: output[1][19] = @47 */
  if (res[1]) casadi_copy(w047, 96, res[1]+1824);
  /* #220: output[1][20] = @49 */
  if (res[1]) casadi_copy(w049, 96, res[1]+1920);
  /* #221: output[1][21] = @51 */
  if (res[1]) casadi_copy(w051, 96, res[1]+2016);
  /* #222: output[1][22] = @53 */
  if (res[1]) casadi_copy(w053, 96, res[1]+2112);
  /* #223: output[1][23] = @55 */
  if (res[1]) casadi_copy(w055, 96, res[1]+2208);
  /* #224: output[1][24] = @57 */
  if (res[1]) casadi_copy(w057, 96, res[1]+2304);
  /* #225: output[1][25] = @59 */
  if (res[1]) casadi_copy(w059, 96, res[1]+2400);
  /* #226: output[1][26] = @61 */
  if (res[1]) casadi_copy(w061, 96, res[1]+2496);
  /* #227: output[1][27] = @63 */
  if (res[1]) casadi_copy(w063, 96, res[1]+2592);
  /* #228: output[1][28] = @65 */
  if (res[1]) casadi_copy(w065, 96, res[1]+2688);
  /* #229: output[1][29] = @67 */
  if (res[1]) casadi_copy(w067, 96, res[1]+2784);
  /* #230: output[1][30] = @69 */
  if (res[1]) casadi_copy(w069, 96, res[1]+2880);
  /* #231: output[1][31] = @71 */
  if (res[1]) casadi_copy(w071, 96, res[1]+2976);
  /* #232: output[1][32] = @73 */
  if (res[1]) casadi_copy(w073, 96, res[1]+3072);
  /* #233: output[1][33] = @75 */
  if (res[1]) casadi_copy(w075, 96, res[1]+3168);
  /* #234: output[1][34] = @77 */
  if (res[1]) casadi_copy(w077, 96, res[1]+3264);
  /* #235: output[1][35] = @79 */
  if (res[1]) casadi_copy(w079, 96, res[1]+3360);
  /* #236: output[1][36] = @81 */
  if (res[1]) casadi_copy(w081, 96, res[1]+3456);
  /* #237: output[1][37] = @83 */
  if (res[1]) casadi_copy(w083, 96, res[1]+3552);
  /* #238: output[1][38] = @85 */
  if (res[1]) casadi_copy(w085, 96, res[1]+3648);
  /* #239: output[1][39] = @87 */
  if (res[1]) casadi_copy(w087, 96, res[1]+3744);
  /* #240: output[1][40] = @89 */
  if (res[1]) casadi_copy(w089, 96, res[1]+3840);
  /* #241: output[1][41] = @91 */
  if (res[1]) casadi_copy(w091, 96, res[1]+3936);
  /* #242: output[1][42] = @93 */
  if (res[1]) casadi_copy(w093, 96, res[1]+4032);
  /* #243: output[1][43] = @95 */
  if (res[1]) casadi_copy(w095, 96, res[1]+4128);
  /* #244: output[1][44] = @97 */
  if (res[1]) casadi_copy(w097, 96, res[1]+4224);
  /* #245: output[1][45] = @99 */
  if (res[1]) casadi_copy(w099, 96, res[1]+4320);
  /* #246: output[1][46] = @101 */
  if (res[1]) casadi_copy(w101, 96, res[1]+4416);
  /* #247: output[1][47] = @103 */
  if (res[1]) casadi_copy(w103, 96, res[1]+4512);
  /* #248: {@105, @106} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=w004;
  res1[0]=w105;
  res1[1]=w106;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #249: output[1][48] = @105 */
  if (res[1]) casadi_copy(w105, 8, res[1]+4608);
  /* #250: output[2][0] = @10 */
  casadi_copy(w010, 96, res[2]);
  /* #251: output[2][1] = @12 */
  if (res[2]) casadi_copy(w012, 96, res[2]+96);
  /* #252: output[2][2] = @14 */
  if (res[2]) casadi_copy(w014, 96, res[2]+192);
  /* #253: output[2][3] = @16 */
  if (res[2]) casadi_copy(w016, 96, res[2]+288);
  /* #254: output[2][4] = @18 */
  if (res[2]) casadi_copy(w018, 96, res[2]+384);
  /* #255: output[2][5] = @20 */
  if (res[2]) casadi_copy(w020, 96, res[2]+480);
  /* #256: output[2][6] = @22 */
  if (res[2]) casadi_copy(w022, 96, res[2]+576);
  /* #257: output[2][7] = @24 */
  if (res[2]) casadi_copy(w024, 96, res[2]+672);
  /* #258: output[2][8] = @26 */
  if (res[2]) casadi_copy(w026, 96, res[2]+768);
  /* #259: output[2][9] = @28 */
  if (res[2]) casadi_copy(w028, 96, res[2]+864);
  /* #260: output[2][10] = @30 */
  if (res[2]) casadi_copy(w030, 96, res[2]+960);
  /* #261: output[2][11] = @32 */
  if (res[2]) casadi_copy(w032, 96, res[2]+1056);
  /* #262: output[2][12] = @34 */
  if (res[2]) casadi_copy(w034, 96, res[2]+1152);
  /* #263: output[2][13] = @36 */
  if (res[2]) casadi_copy(w036, 96, res[2]+1248);
  /* #264: output[2][14] = @38 */
  if (res[2]) casadi_copy(w038, 96, res[2]+1344);
  /* #265: output[2][15] = @40 */
  if (res[2]) casadi_copy(w040, 96, res[2]+1440);
  /* #266: output[2][16] = @42 */
  if (res[2]) casadi_copy(w042, 96, res[2]+1536);
  /* #267: output[2][17] = @44 */
  if (res[2]) casadi_copy(w044, 96, res[2]+1632);
  /* #268: output[2][18] = @46 */
  if (res[2]) casadi_copy(w046, 96, res[2]+1728);
  /* #269: output[2][19] = @48 */
  if (res[2]) casadi_copy(w048, 96, res[2]+1824);
  /* #270: output[2][20] = @50 */
  if (res[2]) casadi_copy(w050, 96, res[2]+1920);
  /* #271: output[2][21] = @52 */
  if (res[2]) casadi_copy(w052, 96, res[2]+2016);
  /* #272: output[2][22] = @54 */
  if (res[2]) casadi_copy(w054, 96, res[2]+2112);
  /* #273: output[2][23] = @56 */
  if (res[2]) casadi_copy(w056, 96, res[2]+2208);
  /* #274: output[2][24] = @58 */
  if (res[2]) casadi_copy(w058, 96, res[2]+2304);
  /* #275: output[2][25] = @60 */
  if (res[2]) casadi_copy(w060, 96, res[2]+2400);
  /* #276: output[2][26] = @62 */
  if (res[2]) casadi_copy(w062, 96, res[2]+2496);
  /* #277: output[2][27] = @64 */
  if (res[2]) casadi_copy(w064, 96, res[2]+2592);
  /* #278: output[2][28] = @66 */
  if (res[2]) casadi_copy(w066, 96, res[2]+2688);
  /* #279: output[2][29] = @68 */
  if (res[2]) casadi_copy(w068, 96, res[2]+2784);
  /* #280: output[2][30] = @70 */
  if (res[2]) casadi_copy(w070, 96, res[2]+2880);
  /* #281: output[2][31] = @72 */
  if (res[2]) casadi_copy(w072, 96, res[2]+2976);
  /* #282: output[2][32] = @74 */
  if (res[2]) casadi_copy(w074, 96, res[2]+3072);
  /* #283: output[2][33] = @76 */
  if (res[2]) casadi_copy(w076, 96, res[2]+3168);
  /* #284: output[2][34] = @78 */
  if (res[2]) casadi_copy(w078, 96, res[2]+3264);
  /* #285: output[2][35] = @80 */
  if (res[2]) casadi_copy(w080, 96, res[2]+3360);
  /* #286: output[2][36] = @82 */
  if (res[2]) casadi_copy(w082, 96, res[2]+3456);
  /* #287: output[2][37] = @84 */
  if (res[2]) casadi_copy(w084, 96, res[2]+3552);
  /* #288: output[2][38] = @86 */
  if (res[2]) casadi_copy(w086, 96, res[2]+3648);
  /* #289: output[2][39] = @88 */
  if (res[2]) casadi_copy(w088, 96, res[2]+3744);
  /* #290: output[2][40] = @90 */
  if (res[2]) casadi_copy(w090, 96, res[2]+3840);
  /* #291: output[2][41] = @92 */
  if (res[2]) casadi_copy(w092, 96, res[2]+3936);
  /* #292: output[2][42] = @94 */
  if (res[2]) casadi_copy(w094, 96, res[2]+4032);
  /* #293: output[2][43] = @96 */
  if (res[2]) casadi_copy(w096, 96, res[2]+4128);
  /* #294: output[2][44] = @98 */
  if (res[2]) casadi_copy(w098, 96, res[2]+4224);
  /* #295: output[2][45] = @100 */
  if (res[2]) casadi_copy(w100, 96, res[2]+4320);
  /* #296: output[2][46] = @102 */
  if (res[2]) casadi_copy(w102, 96, res[2]+4416);
  /* #297: output[2][47] = @104 */
  if (res[2]) casadi_copy(w104, 96, res[2]+4512);
  /* #298: output[2][48] = @106 */
  if (res[2]) casadi_copy(w106, 8, res[2]+4608);
  /* #299: @7 = landing(@1, @6, @4) */
  arg1[0]=w001;
  arg1[1]=w006;
  arg1[2]=w004;
  res1[0]=w007;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #300: output[3][0] = @7 */
  casadi_copy(w007, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f110(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_576_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_576_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_576_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_576_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_576_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_576_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_576_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_576_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_576_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_576_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_576_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s21;
    case 1: return casadi_s22;
    case 2: return casadi_s22;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_576_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 9584;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 9584*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_768:(u[4],p[3])->(w[4x769],g[8x769],dg[8x769],R[4]) */
static int casadi_f111(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+266, w002, w003, *w004=w+270, *w005=w+273, *w006=w+297, *w007=w+300, *w008=w+304, *w009=w+352;
  casadi_real *w010=w+448, *w011=w+544, *w012=w+640, *w013=w+736, *w014=w+832, *w015=w+928, *w016=w+1024, *w017=w+1120, *w018=w+1216, *w019=w+1312, *w020=w+1408, *w021=w+1504;
  casadi_real *w022=w+1600, *w023=w+1696, *w024=w+1792, *w025=w+1888, *w026=w+1984, *w027=w+2080, *w028=w+2176, *w029=w+2272, *w030=w+2368, *w031=w+2464, *w032=w+2560, *w033=w+2656;
  casadi_real *w034=w+2752, *w035=w+2848, *w036=w+2944, *w037=w+3040, *w038=w+3136, *w039=w+3232, *w040=w+3328, *w041=w+3424, *w042=w+3520, *w043=w+3616, *w044=w+3712, *w045=w+3808;
  casadi_real *w046=w+3904, *w047=w+4000, *w048=w+4096, *w049=w+4192, *w050=w+4288, *w051=w+4384, *w052=w+4480, *w053=w+4576, *w054=w+4672, *w055=w+4768, *w056=w+4864, *w057=w+4960;
  casadi_real *w058=w+5056, *w059=w+5152, *w060=w+5248, *w061=w+5344, *w062=w+5440, *w063=w+5536, *w064=w+5632, *w065=w+5728, *w066=w+5824, *w067=w+5920, *w068=w+6016, *w069=w+6112;
  casadi_real *w070=w+6208, *w071=w+6304, *w072=w+6400, *w073=w+6496, *w074=w+6592, *w075=w+6688, *w076=w+6784, *w077=w+6880, *w078=w+6976, *w079=w+7072, *w080=w+7168, *w081=w+7264;
  casadi_real *w082=w+7360, *w083=w+7456, *w084=w+7552, *w085=w+7648, *w086=w+7744, *w087=w+7840, *w088=w+7936, *w089=w+8032, *w090=w+8128, *w091=w+8224, *w092=w+8320, *w093=w+8416;
  casadi_real *w094=w+8512, *w095=w+8608, *w096=w+8704, *w097=w+8800, *w098=w+8896, *w099=w+8992, *w100=w+9088, *w101=w+9184, *w102=w+9280, *w103=w+9376, *w104=w+9472, *w105=w+9568;
  casadi_real *w106=w+9664, *w107=w+9760, *w108=w+9856, *w109=w+9952, *w110=w+10048, *w111=w+10144, *w112=w+10240, *w113=w+10336, *w114=w+10432, *w115=w+10528, *w116=w+10624, *w117=w+10720;
  casadi_real *w118=w+10816, *w119=w+10912, *w120=w+11008, *w121=w+11104, *w122=w+11200, *w123=w+11296, *w124=w+11392, *w125=w+11488, *w126=w+11584, *w127=w+11680, *w128=w+11776, *w129=w+11872;
  casadi_real *w130=w+11968, *w131=w+12064, *w132=w+12160, *w133=w+12256, *w134=w+12352, *w135=w+12448, *w136=w+12544, *w137=w+12640, *w138=w+12648;
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
  casadi_copy(arg[1], 3, w004);
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
  /* #9: {@7, @8, @9, @10} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w009;
  res1[3]=w010;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @8 */
  casadi_copy(w008, 48, res[0]);
  /* #11: @0 = 0.015625 */
  w000 = 1.5625000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w000 *= w002;
  /* #13: {@1, @8, @11, @12} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w011;
  res1[3]=w012;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+48);
  /* #15: @0 = 0.03125 */
  w000 = 3.1250000000000000e-02;
  /* #16: @0 = (@0*@2) */
  w000 *= w002;
  /* #17: {@7, @8, @13, @14} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w013;
  res1[3]=w014;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+96);
  /* #19: @0 = 0.046875 */
  w000 = 4.6875000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w000 *= w002;
  /* #21: {@1, @8, @15, @16} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w015;
  res1[3]=w016;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+144);
  /* #23: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #24: @0 = (@0*@2) */
  w000 *= w002;
  /* #25: {@7, @8, @17, @18} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w017;
  res1[3]=w018;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+192);
  /* #27: @0 = 0.078125 */
  w000 = 7.8125000000000000e-02;
  /* #28: @0 = (@0*@2) */
  w000 *= w002;
  /* #29: {@1, @8, @19, @20} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w019;
  res1[3]=w020;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+240);
  /* #31: @0 = 0.09375 */
  w000 = 9.3750000000000000e-02;
  /* #32: @0 = (@0*@2) */
  w000 *= w002;
  /* #33: {@7, @8, @21, @22} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w021;
  res1[3]=w022;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+288);
  /* #35: @0 = 0.109375 */
  w000 = 1.0937500000000000e-01;
  /* #36: @0 = (@0*@2) */
  w000 *= w002;
  /* #37: {@1, @8, @23, @24} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w023;
  res1[3]=w024;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+336);
  /* #39: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w000 *= w002;
  /* #41: {@7, @8, @25, @26} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w025;
  res1[3]=w026;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+384);
  /* #43: @0 = 0.140625 */
  w000 = 1.4062500000000000e-01;
  /* #44: @0 = (@0*@2) */
  w000 *= w002;
  /* #45: {@1, @8, @27, @28} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w027;
  res1[3]=w028;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+432);
  /* #47: @0 = 0.15625 */
  w000 = 1.5625000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w000 *= w002;
  /* #49: {@7, @8, @29, @30} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w029;
  res1[3]=w030;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+480);
  /* #51: @0 = 0.171875 */
  w000 = 1.7187500000000000e-01;
  /* #52: @0 = (@0*@2) */
  w000 *= w002;
  /* #53: {@1, @8, @31, @32} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w031;
  res1[3]=w032;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+528);
  /* #55: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w000 *= w002;
  /* #57: {@7, @8, @33, @34} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w033;
  res1[3]=w034;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+576);
  /* #59: @0 = 0.203125 */
  w000 = 2.0312500000000000e-01;
  /* #60: @0 = (@0*@2) */
  w000 *= w002;
  /* #61: {@1, @8, @35, @36} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w035;
  res1[3]=w036;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+624);
  /* #63: @0 = 0.21875 */
  w000 = 2.1875000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w000 *= w002;
  /* #65: {@7, @8, @37, @38} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w037;
  res1[3]=w038;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+672);
  /* #67: @0 = 0.234375 */
  w000 = 2.3437500000000000e-01;
  /* #68: @0 = (@0*@2) */
  w000 *= w002;
  /* #69: {@1, @8, @39, @40} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w039;
  res1[3]=w040;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+720);
  /* #71: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #72: @0 = (@0*@2) */
  w000 *= w002;
  /* #73: {@7, @8, @41, @42} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w041;
  res1[3]=w042;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+768);
  /* #75: @0 = 0.265625 */
  w000 = 2.6562500000000000e-01;
  /* #76: @0 = (@0*@2) */
  w000 *= w002;
  /* #77: {@1, @8, @43, @44} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w043;
  res1[3]=w044;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+816);
  /* #79: @0 = 0.28125 */
  w000 = 2.8125000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w000 *= w002;
  /* #81: {@7, @8, @45, @46} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w045;
  res1[3]=w046;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+864);
  /* #83: @0 = 0.296875 */
  w000 = 2.9687500000000000e-01;
  /* #84: @0 = (@0*@2) */
  w000 *= w002;
  /* #85: {@1, @8, @47, @48} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w047;
  res1[3]=w048;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+912);
  /* #87: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #88: @0 = (@0*@2) */
  w000 *= w002;
  /* #89: {@7, @8, @49, @50} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w049;
  res1[3]=w050;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+960);
  /* #91: @0 = 0.328125 */
  w000 = 3.2812500000000000e-01;
  /* #92: @0 = (@0*@2) */
  w000 *= w002;
  /* #93: {@1, @8, @51, @52} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w051;
  res1[3]=w052;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1008);
  /* #95: @0 = 0.34375 */
  w000 = 3.4375000000000000e-01;
  /* #96: @0 = (@0*@2) */
  w000 *= w002;
  /* #97: {@7, @8, @53, @54} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w053;
  res1[3]=w054;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1056);
  /* #99: @0 = 0.359375 */
  w000 = 3.5937500000000000e-01;
  /* #100: @0 = (@0*@2) */
  w000 *= w002;
  /* #101: {@1, @8, @55, @56} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w055;
  res1[3]=w056;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1104);
  /* #103: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w000 *= w002;
  /* #105: {@7, @8, @57, @58} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w057;
  res1[3]=w058;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1152);
  /* #107: @0 = 0.390625 */
  w000 = 3.9062500000000000e-01;
  /* #108: @0 = (@0*@2) */
  w000 *= w002;
  /* #109: {@1, @8, @59, @60} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w059;
  res1[3]=w060;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1200);
  /* #111: @0 = 0.40625 */
  w000 = 4.0625000000000000e-01;
  /* #112: @0 = (@0*@2) */
  w000 *= w002;
  /* #113: {@7, @8, @61, @62} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w061;
  res1[3]=w062;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1248);
  /* #115: @0 = 0.421875 */
  w000 = 4.2187500000000000e-01;
  /* #116: @0 = (@0*@2) */
  w000 *= w002;
  /* #117: {@1, @8, @63, @64} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w063;
  res1[3]=w064;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1296);
  /* #119: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #120: @0 = (@0*@2) */
  w000 *= w002;
  /* #121: {@7, @8, @65, @66} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w065;
  res1[3]=w066;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1344);
  /* #123: @0 = 0.453125 */
  w000 = 4.5312500000000000e-01;
  /* #124: @0 = (@0*@2) */
  w000 *= w002;
  /* #125: {@1, @8, @67, @68} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w067;
  res1[3]=w068;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1392);
  /* #127: @0 = 0.46875 */
  w000 = 4.6875000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w000 *= w002;
  /* #129: {@7, @8, @69, @70} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w069;
  res1[3]=w070;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1440);
  /* #131: @0 = 0.484375 */
  w000 = 4.8437500000000000e-01;
  /* #132: @0 = (@0*@2) */
  w000 *= w002;
  /* #133: {@1, @8, @71, @72} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w071;
  res1[3]=w072;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1488);
  /* #135: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #136: @0 = (@0*@2) */
  w000 *= w002;
  /* #137: {@7, @8, @73, @74} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w073;
  res1[3]=w074;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #138: output[0][32] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1536);
  /* #139: @0 = 0.515625 */
  w000 = 5.1562500000000000e-01;
  /* #140: @0 = (@0*@2) */
  w000 *= w002;
  /* #141: {@1, @8, @75, @76} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w075;
  res1[3]=w076;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #142: output[0][33] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1584);
  /* #143: @0 = 0.53125 */
  w000 = 5.3125000000000000e-01;
  /* #144: @0 = (@0*@2) */
  w000 *= w002;
  /* #145: {@7, @8, @77, @78} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w077;
  res1[3]=w078;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #146: output[0][34] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1632);
  /* #147: @0 = 0.546875 */
  w000 = 5.4687500000000000e-01;
  /* #148: @0 = (@0*@2) */
  w000 *= w002;
  /* #149: {@1, @8, @79, @80} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w079;
  res1[3]=w080;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #150: output[0][35] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1680);
  /* #151: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #152: @0 = (@0*@2) */
  w000 *= w002;
  /* #153: {@7, @8, @81, @82} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w081;
  res1[3]=w082;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #154: output[0][36] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1728);
  /* #155: @0 = 0.578125 */
  w000 = 5.7812500000000000e-01;
  /* #156: @0 = (@0*@2) */
  w000 *= w002;
  /* #157: {@1, @8, @83, @84} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w083;
  res1[3]=w084;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #158: output[0][37] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1776);
  /* #159: @0 = 0.59375 */
  w000 = 5.9375000000000000e-01;
  /* #160: @0 = (@0*@2) */
  w000 *= w002;
  /* #161: {@7, @8, @85, @86} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w085;
  res1[3]=w086;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #162: output[0][38] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1824);
  /* #163: @0 = 0.609375 */
  w000 = 6.0937500000000000e-01;
  /* #164: @0 = (@0*@2) */
  w000 *= w002;
  /* #165: {@1, @8, @87, @88} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w087;
  res1[3]=w088;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][39] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1872);
  /* #167: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #168: @0 = (@0*@2) */
  w000 *= w002;
  /* #169: {@7, @8, @89, @90} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w089;
  res1[3]=w090;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #170: output[0][40] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1920);
  /* #171: @0 = 0.640625 */
  w000 = 6.4062500000000000e-01;
  /* #172: @0 = (@0*@2) */
  w000 *= w002;
  /* #173: {@1, @8, @91, @92} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w091;
  res1[3]=w092;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #174: output[0][41] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+1968);
  /* #175: @0 = 0.65625 */
  w000 = 6.5625000000000000e-01;
  /* #176: @0 = (@0*@2) */
  w000 *= w002;
  /* #177: {@7, @8, @93, @94} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w093;
  res1[3]=w094;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #178: output[0][42] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2016);
  /* #179: @0 = 0.671875 */
  w000 = 6.7187500000000000e-01;
  /* #180: @0 = (@0*@2) */
  w000 *= w002;
  /* #181: {@1, @8, @95, @96} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w095;
  res1[3]=w096;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #182: output[0][43] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2064);
  /* #183: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #184: @0 = (@0*@2) */
  w000 *= w002;
  /* #185: {@7, @8, @97, @98} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w097;
  res1[3]=w098;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #186: output[0][44] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2112);
  /* #187: @0 = 0.703125 */
  w000 = 7.0312500000000000e-01;
  /* #188: @0 = (@0*@2) */
  w000 *= w002;
  /* #189: {@1, @8, @99, @100} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w099;
  res1[3]=w100;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #190: output[0][45] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2160);
  /* #191: @0 = 0.71875 */
  w000 = 7.1875000000000000e-01;
  /* #192: @0 = (@0*@2) */
  w000 *= w002;
  /* #193: {@7, @8, @101, @102} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w101;
  res1[3]=w102;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #194: output[0][46] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2208);
  /* #195: @0 = 0.734375 */
  w000 = 7.3437500000000000e-01;
  /* #196: @0 = (@0*@2) */
  w000 *= w002;
  /* #197: {@1, @8, @103, @104} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w103;
  res1[3]=w104;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #198: output[0][47] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2256);
  /* #199: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #200: @0 = (@0*@2) */
  w000 *= w002;
  /* #201: {@7, @8, @105, @106} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w105;
  res1[3]=w106;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #202: output[0][48] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2304);
  /* #203: @0 = 0.765625 */
  w000 = 7.6562500000000000e-01;
  /* #204: @0 = (@0*@2) */
  w000 *= w002;
  /* #205: {@1, @8, @107, @108} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w107;
  res1[3]=w108;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #206: output[0][49] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2352);
  /* #207: @0 = 0.78125 */
  w000 = 7.8125000000000000e-01;
  /* #208: @0 = (@0*@2) */
  w000 *= w002;
  /* #209: {@7, @8, @109, @110} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w109;
  res1[3]=w110;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #210: output[0][50] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2400);
  /* #211: @0 = 0.796875 */
  w000 = 7.9687500000000000e-01;
  /* #212: @0 = (@0*@2) */
  w000 *= w002;
  /* #213: {@1, @8, @111, @112} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w111;
  res1[3]=w112;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #214: output[0][51] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2448);
  /* #215: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #216: @0 = (@0*@2) */
  w000 *= w002;
  /* #217: {@7, @8, @113, @114} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w113;
  res1[3]=w114;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #218: output[0][52] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2496);
  /* #219: @0 = 0.828125 */
  w000 = 8.2812500000000000e-01;
  /* #220: @0 = (@0*@2) */
  w000 *= w002;
  /* #221: {@1, @8, @115, @116} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w115;
  res1[3]=w116;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #222: output[0][53] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2544);
  /* #223: @0 = 0.84375 */
  w000 = 8.4375000000000000e-01;
  /* #224: @0 = (@0*@2) */
  w000 *= w002;
  /* #225: {@7, @8, @117, @118} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w117;
  res1[3]=w118;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #226: output[0][54] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2592);
  /* #227: @0 = 0.859375 */
  w000 = 8.5937500000000000e-01;
  /* #228: @0 = (@0*@2) */
  w000 *= w002;
  /* #229: {@1, @8, @119, @120} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w119;
  res1[3]=w120;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #230: output[0][55] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2640);
  /* #231: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #232: @0 = (@0*@2) */
  w000 *= w002;
  /* #233: {@7, @8, @121, @122} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w121;
  res1[3]=w122;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #234: output[0][56] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2688);
  /* #235: @0 = 0.890625 */
  w000 = 8.9062500000000000e-01;
  /* #236: @0 = (@0*@2) */
  w000 *= w002;
  /* #237: {@1, @8, @123, @124} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w123;
  res1[3]=w124;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #238: output[0][57] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2736);
  /* #239: @0 = 0.90625 */
  w000 = 9.0625000000000000e-01;
  /* #240: @0 = (@0*@2) */
  w000 *= w002;
  /* #241: {@7, @8, @125, @126} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w125;
  res1[3]=w126;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #242: output[0][58] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2784);
  /* #243: @0 = 0.921875 */
  w000 = 9.2187500000000000e-01;
  /* #244: @0 = (@0*@2) */
  w000 *= w002;
  /* #245: {@1, @8, @127, @128} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w127;
  res1[3]=w128;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #246: output[0][59] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2832);
  /* #247: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #248: @0 = (@0*@2) */
  w000 *= w002;
  /* #249: {@7, @8, @129, @130} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w129;
  res1[3]=w130;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #250: output[0][60] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2880);
  /* #251: @0 = 0.953125 */
  w000 = 9.5312500000000000e-01;
  /* #252: @0 = (@0*@2) */
  w000 *= w002;
  /* #253: {@1, @8, @131, @132} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w131;
  res1[3]=w132;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #254: output[0][61] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2928);
  /* #255: @0 = 0.96875 */
  w000 = 9.6875000000000000e-01;
  /* #256: @0 = (@0*@2) */
  w000 *= w002;
  /* #257: {@7, @8, @133, @134} = working_steps(@0, @5, @1, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w001;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w008;
  res1[2]=w133;
  res1[3]=w134;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #258: output[0][62] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+2976);
  /* #259: @0 = 0.984375 */
  w000 = 9.8437500000000000e-01;
  /* #260: @0 = (@0*@2) */
  w000 *= w002;
  /* #261: {@1, @8, @135, @136} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w001;
  res1[1]=w008;
  res1[2]=w135;
  res1[3]=w136;
  if (casadi_f101(arg1, res1, iw, w, 0)) return 1;
  /* #262: output[0][63] = @8 */
  if (res[0]) casadi_copy(w008, 48, res[0]+3024);
  /* #263: output[0][64] = @1 */
  if (res[0]) casadi_copy(w001, 4, res[0]+3072);
  /* #264: output[1][0] = @9 */
  casadi_copy(w009, 96, res[1]);
  /* #265: output[1][1] = @11 */
  if (res[1]) casadi_copy(w011, 96, res[1]+96);
  /* #266: output[1][2] = @13 */
  if (res[1]) casadi_copy(w013, 96, res[1]+192);
  /* #267: output[1][3] = @15 */
  if (res[1]) casadi_copy(w015, 96, res[1]+288);
  /* #268: output[1][4] = @17 */
  if (res[1]) casadi_copy(w017, 96, res[1]+384);
  /* #269: output[1][5] = @19 */
  if (res[1]) casadi_copy(w019, 96, res[1]+480);
  /* #270: output[1][6] = @21 */
  if (res[1]) casadi_copy(w021, 96, res[1]+576);
  /* #271: output[1][7] = @23 */
  if (res[1]) casadi_copy(w023, 96, res[1]+672);
  /* #272: output[1][8] = @25 */
  if (res[1]) casadi_copy(w025, 96, res[1]+768);
  /* #273: output[1][9] = @27 */
  if (res[1]) casadi_copy(w027, 96, res[1]+864);
  /* #274: output[1][10] = @29 */
  if (res[1]) casadi_copy(w029, 96, res[1]+960);
  /* #275: output[1][11] = @31 */
  if (res[1]) casadi_copy(w031, 96, res[1]+1056);
  /* #276: output[1][12] = @33 */
  if (res[1]) casadi_copy(w033, 96, res[1]+1152);
  /* #277: output[1][13] = @35 */
  if (res[1]) casadi_copy(w035, 96, res[1]+1248);
  /* #278: output[1][14] = @37 */
  if (res[1]) casadi_copy(w037, 96, res[1]+1344);
  /* #279: output[1][15] = @39 */
  if (res[1]) casadi_copy(w039, 96, res[1]+1440);
  /* #280: output[1][16] = @41 */
  if (res[1]) casadi_copy(w041, 96, res[1]+1536);
  /* #281: output[1][17] = @43 */
  if (res[1]) casadi_copy(w043, 96, res[1]+1632);
  /* #282: output[1][18] = @45 */
  if (res[1]) casadi_copy(w045, 96, res[1]+1728);
  /* #283: output[1][19] = @47 */
  if (res[1]) casadi_copy(w047, 96, res[1]+1824);
  /* #284: output[1][20] = @49 */
  if (res[1]) casadi_copy(w049, 96, res[1]+1920);
  /* #285: output[1][21] = @51 */
  if (res[1]) casadi_copy(w051, 96, res[1]+2016);
  /* #286: output[1][22] = @53 */
  if (res[1]) casadi_copy(w053, 96, res[1]+2112);
  /* #287: output[1][23] = @55 */
  if (res[1]) casadi_copy(w055, 96, res[1]+2208);
  /* #288: output[1][24] = @57 */
  if (res[1]) casadi_copy(w057, 96, res[1]+2304);
  /* #289: output[1][25] = @59 */
  if (res[1]) casadi_copy(w059, 96, res[1]+2400);
  /* #290: output[1][26] = @61 */
  if (res[1]) casadi_copy(w061, 96, res[1]+2496);
  /* #291: output[1][27] = @63 */
  if (res[1]) casadi_copy(w063, 96, res[1]+2592);
  /* #292: output[1][28] = @65 */
  if (res[1]) casadi_copy(w065, 96, res[1]+2688);
  /* #293: output[1][29] = @67 */
  if (res[1]) casadi_copy(w067, 96, res[1]+2784);
  /* #294: output[1][30] = @69 */
  if (res[1]) casadi_copy(w069, 96, res[1]+2880);
  /* #295: output[1][31] = @71 */
  if (res[1]) casadi_copy(w071, 96, res[1]+2976);
  /* #296: output[1][32] = @73 */
  if (res[1]) casadi_copy(w073, 96, res[1]+3072);
  /* #297: output[1][33] = @75 */
  if (res[1]) casadi_copy(w075, 96, res[1]+3168);
  /* #298: output[1][34] = @77 */
  if (res[1]) casadi_copy(w077, 96, res[1]+3264);
  /* #299: output[1][35] = @79 */
  if (res[1]) casadi_copy(w079, 96, res[1]+3360);
  /* #300: output[1][36] = @81 */
  if (res[1]) casadi_copy(w081, 96, res[1]+3456);
  /* #301: output[1][37] = @83 */
  if (res[1]) casadi_copy(w083, 96, res[1]+3552);
  /* #302: output[1][38] = @85 */
  if (res[1]) casadi_copy(w085, 96, res[1]+3648);
  /* #303: output[1][39] = @87 */
  if (res[1]) casadi_copy(w087, 96, res[1]+3744);
  /* #304: output[1][40] = @89 */
  if (res[1]) casadi_copy(w089, 96, res[1]+3840);
  /* #305: output[1][41] = @91 */
  if (res[1]) casadi_copy(w091, 96, res[1]+3936);
  /* #306: output[1][42] = @93 */
  if (res[1]) casadi_copy(w093, 96, res[1]+4032);
  /* #307: output[1][43] = @95 */
  if (res[1]) casadi_copy(w095, 96, res[1]+4128);
  /* #308: output[1][44] = @97 */
  if (res[1]) casadi_copy(w097, 96, res[1]+4224);
  /* #309: output[1][45] = @99 */
  if (res[1]) casadi_copy(w099, 96, res[1]+4320);
  /* #310: output[1][46] = @101 */
  if (res[1]) casadi_copy(w101, 96, res[1]+4416);
  /* #311: output[1][47] = @103 */
  if (res[1]) casadi_copy(w103, 96, res[1]+4512);
  /* #312: output[1][48] = @105 */
  if (res[1]) casadi_copy(w105, 96, res[1]+4608);
  /* #313: output[1][49] = @107 */
  if (res[1]) casadi_copy(w107, 96, res[1]+4704);
  /* #314: output[1][50] = @109 */
  if (res[1]) casadi_copy(w109, 96, res[1]+4800);
  /* #315: output[1][51] = @111 */
  if (res[1]) casadi_copy(w111, 96, res[1]+4896);
  /* #316: output[1][52] = @113 */
  if (res[1]) casadi_copy(w113, 96, res[1]+4992);
  /* #317: output[1][53] = @115 */
  if (res[1]) casadi_copy(w115, 96, res[1]+5088);
  /* #318: output[1][54] = @117 */
  if (res[1]) casadi_copy(w117, 96, res[1]+5184);
  /* #319: output[1][55] = @119 */
  if (res[1]) casadi_copy(w119, 96, res[1]+5280);
  /* #320: output[1][56] = @121 */
  if (res[1]) casadi_copy(w121, 96, res[1]+5376);
  /* #321: output[1][57] = @123 */
  if (res[1]) casadi_copy(w123, 96, res[1]+5472);
  /* #322: output[1][58] = @125 */
  if (res[1]) casadi_copy(w125, 96, res[1]+5568);
  /* #323: output[1][59] = @127 */
  if (res[1]) casadi_copy(w127, 96, res[1]+5664);
  /* #324: output[1][60] = @129 */
  if (res[1]) casadi_copy(w129, 96, res[1]+5760);
  /* #325: output[1][61] = @131 */
  if (res[1]) casadi_copy(w131, 96, res[1]+5856);
  /* #326: output[1][62] = @133 */
  if (res[1]) casadi_copy(w133, 96, res[1]+5952);
  /* #327: output[1][63] = @135 */
  if (res[1]) casadi_copy(w135, 96, res[1]+6048);
  /* #328: {@137, @138} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=w004;
  res1[0]=w137;
  res1[1]=w138;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #329: output[1][64] = @137 */
  if (res[1]) casadi_copy(w137, 8, res[1]+6144);
  /* #330: output[2][0] = @10 */
  casadi_copy(w010, 96, res[2]);
  /* #331: output[2][1] = @12 */
  if (res[2]) casadi_copy(w012, 96, res[2]+96);
  /* #332: output[2][2] = @14 */
  if (res[2]) casadi_copy(w014, 96, res[2]+192);
  /* #333: output[2][3] = @16 */
  if (res[2]) casadi_copy(w016, 96, res[2]+288);
  /* #334: output[2][4] = @18 */
  if (res[2]) casadi_copy(w018, 96, res[2]+384);
  /* #335: output[2][5] = @20 */
  if (res[2]) casadi_copy(w020, 96, res[2]+480);
  /* #336: output[2][6] = @22 */
  if (res[2]) casadi_copy(w022, 96, res[2]+576);
  /* #337: output[2][7] = @24 */
  if (res[2]) casadi_copy(w024, 96, res[2]+672);
  /* #338: output[2][8] = @26 */
  if (res[2]) casadi_copy(w026, 96, res[2]+768);
  /* #339: output[2][9] = @28 */
  if (res[2]) casadi_copy(w028, 96, res[2]+864);
  /* #340: output[2][10] = @30 */
  if (res[2]) casadi_copy(w030, 96, res[2]+960);
  /* #341: output[2][11] = @32 */
  if (res[2]) casadi_copy(w032, 96, res[2]+1056);
  /* #342: output[2][12] = @34 */
  if (res[2]) casadi_copy(w034, 96, res[2]+1152);
  /* #343: output[2][13] = @36 */
  if (res[2]) casadi_copy(w036, 96, res[2]+1248);
  /* #344: output[2][14] = @38 */
  if (res[2]) casadi_copy(w038, 96, res[2]+1344);
  /* #345: output[2][15] = @40 */
  if (res[2]) casadi_copy(w040, 96, res[2]+1440);
  /* #346: output[2][16] = @42 */
  if (res[2]) casadi_copy(w042, 96, res[2]+1536);
  /* #347: output[2][17] = @44 */
  if (res[2]) casadi_copy(w044, 96, res[2]+1632);
  /* #348: output[2][18] = @46 */
  if (res[2]) casadi_copy(w046, 96, res[2]+1728);
  /* #349: output[2][19] = @48 */
  if (res[2]) casadi_copy(w048, 96, res[2]+1824);
  /* #350: output[2][20] = @50 */
  if (res[2]) casadi_copy(w050, 96, res[2]+1920);
  /* #351: output[2][21] = @52 */
  if (res[2]) casadi_copy(w052, 96, res[2]+2016);
  /* #352: output[2][22] = @54 */
  if (res[2]) casadi_copy(w054, 96, res[2]+2112);
  /* #353: output[2][23] = @56 */
  if (res[2]) casadi_copy(w056, 96, res[2]+2208);
  /* #354: output[2][24] = @58 */
  if (res[2]) casadi_copy(w058, 96, res[2]+2304);
  /* #355: output[2][25] = @60 */
  if (res[2]) casadi_copy(w060, 96, res[2]+2400);
  /* #356: output[2][26] = @62 */
  if (res[2]) casadi_copy(w062, 96, res[2]+2496);
  /* #357: output[2][27] = @64 */
  if (res[2]) casadi_copy(w064, 96, res[2]+2592);
  /* #358: output[2][28] = @66 */
  if (res[2]) casadi_copy(w066, 96, res[2]+2688);
  /* #359: output[2][29] = @68 */
  if (res[2]) casadi_copy(w068, 96, res[2]+2784);
  /* #360: output[2][30] = @70 */
  if (res[2]) casadi_copy(w070, 96, res[2]+2880);
  /* #361: output[2][31] = @72 */
  if (res[2]) casadi_copy(w072, 96, res[2]+2976);
  /* #362: output[2][32] = @74 */
  if (res[2]) casadi_copy(w074, 96, res[2]+3072);
  /* #363: output[2][33] = @76 */
  if (res[2]) casadi_copy(w076, 96, res[2]+3168);
  /* #364: output[2][34] = @78 */
  if (res[2]) casadi_copy(w078, 96, res[2]+3264);
  /* #365: output[2][35] = @80 */
  if (res[2]) casadi_copy(w080, 96, res[2]+3360);
  /* #366: output[2][36] = @82 */
  if (res[2]) casadi_copy(w082, 96, res[2]+3456);
  /* #367: output[2][37] = @84 */
  if (res[2]) casadi_copy(w084, 96, res[2]+3552);
  /* #368: output[2][38] = @86 */
  if (res[2]) casadi_copy(w086, 96, res[2]+3648);
  /* #369: output[2][39] = @88 */
  if (res[2]) casadi_copy(w088, 96, res[2]+3744);
  /* #370: output[2][40] = @90 */
  if (res[2]) casadi_copy(w090, 96, res[2]+3840);
  /* #371: output[2][41] = @92 */
  if (res[2]) casadi_copy(w092, 96, res[2]+3936);
  /* #372: output[2][42] = @94 */
  if (res[2]) casadi_copy(w094, 96, res[2]+4032);
  /* #373: output[2][43] = @96 */
  if (res[2]) casadi_copy(w096, 96, res[2]+4128);
  /* #374: output[2][44] = @98 */
  if (res[2]) casadi_copy(w098, 96, res[2]+4224);
  /* #375: output[2][45] = @100 */
  if (res[2]) casadi_copy(w100, 96, res[2]+4320);
  /* #376: output[2][46] = @102 */
  if (res[2]) casadi_copy(w102, 96, res[2]+4416);
  /* #377: output[2][47] = @104 */
  if (res[2]) casadi_copy(w104, 96, res[2]+4512);
  /* #378: output[2][48] = @106 */
  if (res[2]) casadi_copy(w106, 96, res[2]+4608);
  /* #379: output[2][49] = @108 */
  if (res[2]) casadi_copy(w108, 96, res[2]+4704);
  /* #380: output[2][50] = @110 */
  if (res[2]) casadi_copy(w110, 96, res[2]+4800);
  /* #381: output[2][51] = @112 */
  if (res[2]) casadi_copy(w112, 96, res[2]+4896);
  /* #382: output[2][52] = @114 */
  if (res[2]) casadi_copy(w114, 96, res[2]+4992);
  /* #383: output[2][53] = @116 */
  if (res[2]) casadi_copy(w116, 96, res[2]+5088);
  /* #384: output[2][54] = @118 */
  if (res[2]) casadi_copy(w118, 96, res[2]+5184);
  /* #385: output[2][55] = @120 */
  if (res[2]) casadi_copy(w120, 96, res[2]+5280);
  /* #386: output[2][56] = @122 */
  if (res[2]) casadi_copy(w122, 96, res[2]+5376);
  /* #387: output[2][57] = @124 */
  if (res[2]) casadi_copy(w124, 96, res[2]+5472);
  /* #388: output[2][58] = @126 */
  if (res[2]) casadi_copy(w126, 96, res[2]+5568);
  /* #389: output[2][59] = @128 */
  if (res[2]) casadi_copy(w128, 96, res[2]+5664);
  /* #390: output[2][60] = @130 */
  if (res[2]) casadi_copy(w130, 96, res[2]+5760);
  /* #391: output[2][61] = @132 */
  if (res[2]) casadi_copy(w132, 96, res[2]+5856);
  /* #392: output[2][62] = @134 */
  if (res[2]) casadi_copy(w134, 96, res[2]+5952);
  /* #393: output[2][63] = @136 */
  if (res[2]) casadi_copy(w136, 96, res[2]+6048);
  /* #394: output[2][64] = @138 */
  if (res[2]) casadi_copy(w138, 8, res[2]+6144);
  /* #395: @7 = landing(@1, @6, @4) */
  arg1[0]=w001;
  arg1[1]=w006;
  arg1[2]=w004;
  res1[0]=w007;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #396: output[3][0] = @7 */
  casadi_copy(w007, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f111(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s23;
    case 1: return casadi_s24;
    case 2: return casadi_s24;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12656;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12656*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_advance:(t,w[4],h,p[3])->(w_end[4],g[8],dg[8]) */
static int casadi_f112(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+78, w1, *w2=w+82, *w3=w+85, w4, *w5=w+87, *w6=w+111, *w7=w+115, *w8=w+123;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[1][0] */
  casadi_copy(arg[1], 4, w0);
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 3, w2);
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
  casadi_copy(w6, 4, res[0]);
  /* #8: @1 = (@1+@4) */
  w1 += w4;
  /* #9: {@7, @8} = observe(@1, @6, @2) */
  arg1[0]=(&w1);
  arg1[1]=w6;
  arg1[2]=w2;
  res1[0]=w7;
  res1[1]=w8;
  if (casadi_f103(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[1][0] = @7 */
  casadi_copy(w7, 8, res[1]);
  /* #11: output[2][0] = @8 */
  casadi_copy(w8, 8, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f112(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s4;
    case 2: return casadi_s25;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s26;
    case 2: return casadi_s26;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 131;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 131*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_begin:(u[4],p[3])->(y[4x4]) */
static int casadi_f113(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+2, *w1=w+6, *w2=w+9, *w3=w+12;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
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

CASADI_SYMBOL_EXPORT int goswami_compass_begin(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f113(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_begin_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_begin_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_begin_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_begin_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_begin_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_begin_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_begin_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_begin_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_begin_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_begin_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_begin_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_begin_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 24;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_begin_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 24*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_swing:(t,h,y[4x4],p[3])->(y_end[4x4]) */
static int casadi_f114(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w3=w+335, *w4=w+338, *w5=w+362;
  const casadi_real **arg1=arg+4, *wr0;
  /* #0: @0 = input[2][0] */
  wr0 = arg[2] ? arg[2] : casadi_zeros;
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[3][0] */
  casadi_copy(arg[3], 3, w3);
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

CASADI_SYMBOL_EXPORT int goswami_compass_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f114(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_swing_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "y";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y_end";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s6;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 378;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 378*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_end:(y[4x4],u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f115(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w1=w+35, *w2=w+39, w3, *w4=w+42, *w5=w+45;
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
  casadi_copy(arg[2], 3, w4);
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

CASADI_SYMBOL_EXPORT int goswami_compass_end(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f115(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_end_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_end_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_end_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_end_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_end_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_end_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_end_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_end_name_in(casadi_int i) {
  switch (i) {
    case 0: return "y";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_end_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_end_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_end_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_end_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 61;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 61*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_observed_swing:(t,h,w[4],p[3])->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f116(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+266, *w3=w+269, *w4=w+293, *w5=w+297, *w6=w+301, *w7=w+349, *w8=w+445;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 3, w2);
  /* #3: @3 = turns(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  casadi_copy(arg[2], 4, w4);
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
  casadi_copy(w5, 4, res[0]);
  /* #7: output[1][0] = @6 */
  casadi_copy(w6, 48, res[1]);
  /* #8: output[2][0] = @7 */
  casadi_copy(w7, 96, res[2]);
  /* #9: output[3][0] = @8 */
  casadi_copy(w8, 96, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f116(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int goswami_compass_observed_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void goswami_compass_observed_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_observed_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void goswami_compass_observed_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_observed_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int goswami_compass_observed_swing_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real goswami_compass_observed_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_observed_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "w";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* goswami_compass_observed_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "nodes";
    case 2: return "g";
    case 3: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_observed_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s4;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* goswami_compass_observed_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s27;
    case 2: return casadi_s28;
    case 3: return casadi_s28;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int goswami_compass_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 541;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 541*sizeof(casadi_real);
  return 0;
}



/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*goswami_compass_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int goswami_compass_map(goswami_compass_kernel kernel, const casadi_int* work_size, casadi_int n,
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
