/* Compass gait on a slope: kernels of the solver
 * Printed by CasADi 3.8.2 from equations df23ad6e412b94e6.
 * Do not edit: run `make derive`.
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
  casadi_real a264, a265, a266, a267, a268, a269;
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
  a012=(a012-a008);
  a009=(a009*a012);
  a013=arg[4]? arg[4][2] : 0;
  a014=sin(a013);
  a015=cos(a000);
  a016=(a014*a015);
  a017=cos(a013);
  a018=sin(a000);
  a019=(a017*a018);
  a016=(a016-a019);
  a019=(a007*a016);
  a009=(a009+a019);
  a020=(a013-a000);
  a020=(a020+a010);
  a021=sin(a020);
  a022=(a007*a021);
  a009=(a009-a022);
  a023=arg[4]? arg[4][0] : 0;
  a024=(a023*a016);
  a025=1.;
  a026=(a007+a025);
  a024=(a024*a026);
  a009=(a009+a024);
  a024=(2.*a016);
  a009=(a009+a024);
  a009=(a009/a026);
  a027=casadi_sq(a007);
  a028=cos(a010);
  a029=(2.*a028);
  a029=(a023-a029);
  a030=2.;
  a029=(a029+a030);
  a029=(a027*a029);
  a031=(2.*a007);
  a032=(a023-a028);
  a032=(a032+a025);
  a032=(a031*a032);
  a029=(a029+a032);
  a029=(a029+a023);
  a029=(a029+a030);
  a032=casadi_sq(a026);
  a029=(a029/a032);
  a033=(a009/a029);
  a034=(a007/a032);
  a035=(a028-a025);
  a035=(a007*a035);
  a035=(a035+a028);
  a035=(a034*a035);
  a036=(a035/a029);
  a037=(a007/a026);
  a038=casadi_sq(a003);
  a038=(a038*a011);
  a038=(a038-a021);
  a038=(a037*a038);
  a009=(a036*a009);
  a009=(a038+a009);
  a021=(a027/a032);
  a035=(a035*a036);
  a035=(a021-a035);
  a009=(a009/a035);
  a039=(a036*a009);
  a033=(a033+a039);
  a039=(a006*a033);
  a040=1.7082860872947386e-01;
  a040=(a040*a002);
  a041=2.9587585476806851e-02;
  a041=(a041*a002);
  a042=(a041*a009);
  a043=8.8762756430420545e-02;
  a043=(a043*a002);
  a044=1.9725056984537900e-02;
  a044=(a044*a002);
  a045=(a044*a033);
  a046=5.9175170953613701e-02;
  a046=(a046*a002);
  a047=5.2600151958767730e-02;
  a047=(a047*a002);
  a048=(a047*a009);
  a048=(a008+a048);
  a049=(a007*a048);
  a050=(a047*a008);
  a050=(a010+a050);
  a051=sin(a050);
  a049=(a049*a051);
  a052=(a047*a033);
  a052=(a003-a052);
  a053=(2.*a052);
  a053=(a053-a048);
  a049=(a049*a053);
  a054=(a047*a003);
  a054=(a000+a054);
  a055=cos(a054);
  a056=(a014*a055);
  a057=sin(a054);
  a058=(a017*a057);
  a056=(a056-a058);
  a058=(a007*a056);
  a049=(a049+a058);
  a054=(a013-a054);
  a054=(a054+a050);
  a059=sin(a054);
  a060=(a007*a059);
  a049=(a049-a060);
  a061=(a023*a056);
  a061=(a061*a026);
  a049=(a049+a061);
  a061=(2.*a056);
  a049=(a049+a061);
  a049=(a049/a026);
  a050=cos(a050);
  a062=(2.*a050);
  a062=(a023-a062);
  a062=(a062+a030);
  a062=(a027*a062);
  a063=(a023-a050);
  a063=(a063+a025);
  a063=(a031*a063);
  a062=(a062+a063);
  a062=(a062+a023);
  a062=(a062+a030);
  a062=(a062/a032);
  a063=(a049/a062);
  a064=(a050-a025);
  a064=(a007*a064);
  a064=(a064+a050);
  a064=(a034*a064);
  a065=(a064/a062);
  a066=casadi_sq(a052);
  a066=(a066*a051);
  a066=(a066-a059);
  a066=(a037*a066);
  a049=(a065*a049);
  a049=(a066+a049);
  a064=(a064*a065);
  a064=(a021-a064);
  a049=(a049/a064);
  a059=(a065*a049);
  a063=(a063+a059);
  a063=(a046*a063);
  a045=(a045+a063);
  a045=(a003-a045);
  a063=casadi_sq(a045);
  a059=(a044*a008);
  a067=(a046*a048);
  a059=(a059+a067);
  a059=(a010+a059);
  a067=sin(a059);
  a063=(a063*a067);
  a068=(a044*a003);
  a069=(a046*a052);
  a068=(a068+a069);
  a068=(a000+a068);
  a069=(a013-a068);
  a069=(a069+a059);
  a070=sin(a069);
  a063=(a063-a070);
  a063=(a037*a063);
  a059=cos(a059);
  a071=(a059-a025);
  a071=(a007*a071);
  a071=(a071+a059);
  a071=(a034*a071);
  a072=(2.*a059);
  a072=(a023-a072);
  a072=(a072+a030);
  a072=(a027*a072);
  a073=(a023-a059);
  a073=(a073+a025);
  a073=(a031*a073);
  a072=(a072+a073);
  a072=(a072+a023);
  a072=(a072+a030);
  a072=(a072/a032);
  a073=(a071/a072);
  a074=(a044*a009);
  a049=(a046*a049);
  a074=(a074+a049);
  a074=(a008+a074);
  a049=(a007*a074);
  a049=(a049*a067);
  a075=(2.*a045);
  a075=(a075-a074);
  a049=(a049*a075);
  a076=cos(a068);
  a077=(a014*a076);
  a068=sin(a068);
  a078=(a017*a068);
  a077=(a077-a078);
  a078=(a007*a077);
  a049=(a049+a078);
  a070=(a007*a070);
  a049=(a049-a070);
  a079=(a023*a077);
  a079=(a079*a026);
  a049=(a049+a079);
  a079=(2.*a077);
  a049=(a049+a079);
  a049=(a049/a026);
  a080=(a073*a049);
  a080=(a063+a080);
  a071=(a071*a073);
  a071=(a021-a071);
  a080=(a080/a071);
  a081=(a043*a080);
  a042=(a042+a081);
  a042=(a008+a042);
  a081=(a007*a042);
  a082=(a041*a008);
  a083=(a043*a074);
  a082=(a082+a083);
  a082=(a010+a082);
  a083=sin(a082);
  a081=(a081*a083);
  a084=(a041*a033);
  a049=(a049/a072);
  a085=(a073*a080);
  a049=(a049+a085);
  a085=(a043*a049);
  a084=(a084+a085);
  a084=(a003-a084);
  a085=(2.*a084);
  a085=(a085-a042);
  a081=(a081*a085);
  a086=(a041*a003);
  a087=(a043*a045);
  a086=(a086+a087);
  a086=(a000+a086);
  a087=cos(a086);
  a088=(a014*a087);
  a089=sin(a086);
  a090=(a017*a089);
  a088=(a088-a090);
  a090=(a007*a088);
  a081=(a081+a090);
  a086=(a013-a086);
  a086=(a086+a082);
  a091=sin(a086);
  a092=(a007*a091);
  a081=(a081-a092);
  a093=(a023*a088);
  a093=(a093*a026);
  a081=(a081+a093);
  a093=(2.*a088);
  a081=(a081+a093);
  a081=(a081/a026);
  a082=cos(a082);
  a094=(2.*a082);
  a094=(a023-a094);
  a094=(a094+a030);
  a094=(a027*a094);
  a095=(a023-a082);
  a095=(a095+a025);
  a095=(a031*a095);
  a094=(a094+a095);
  a094=(a094+a023);
  a094=(a094+a030);
  a094=(a094/a032);
  a095=(a081/a094);
  a096=(a082-a025);
  a096=(a007*a096);
  a096=(a096+a082);
  a096=(a034*a096);
  a097=(a096/a094);
  a098=casadi_sq(a084);
  a098=(a098*a083);
  a098=(a098-a091);
  a098=(a037*a098);
  a081=(a097*a081);
  a081=(a098+a081);
  a096=(a096*a097);
  a096=(a021-a096);
  a081=(a081/a096);
  a091=(a097*a081);
  a095=(a095+a091);
  a091=(a040*a095);
  a039=(a039+a091);
  a091=1.2546768756682242e-01;
  a091=(a091*a002);
  a099=2.4136513415926669e-01;
  a099=(a099*a002);
  a100=(a099*a009);
  a101=-8.8454947932828609e-01;
  a101=(a101*a002);
  a080=(a101*a080);
  a100=(a100+a080);
  a080=9.2483400326179199e-01;
  a080=(a080*a002);
  a102=(a080*a081);
  a100=(a100+a102);
  a100=(a008+a100);
  a102=(a007*a100);
  a103=(a099*a008);
  a104=(a101*a074);
  a103=(a103+a104);
  a104=(a080*a042);
  a103=(a103+a104);
  a103=(a010+a103);
  a104=sin(a103);
  a102=(a102*a104);
  a105=(a099*a033);
  a049=(a101*a049);
  a105=(a105+a049);
  a049=(a080*a095);
  a105=(a105+a049);
  a105=(a003-a105);
  a049=(2.*a105);
  a049=(a049-a100);
  a102=(a102*a049);
  a106=(a099*a003);
  a107=(a101*a045);
  a106=(a106+a107);
  a107=(a080*a084);
  a106=(a106+a107);
  a106=(a000+a106);
  a107=cos(a106);
  a108=(a014*a107);
  a109=sin(a106);
  a110=(a017*a109);
  a108=(a108-a110);
  a110=(a007*a108);
  a102=(a102+a110);
  a106=(a013-a106);
  a106=(a106+a103);
  a111=sin(a106);
  a112=(a007*a111);
  a102=(a102-a112);
  a113=(a023*a108);
  a113=(a113*a026);
  a102=(a102+a113);
  a113=(2.*a108);
  a102=(a102+a113);
  a102=(a102/a026);
  a103=cos(a103);
  a114=(2.*a103);
  a114=(a023-a114);
  a114=(a114+a030);
  a114=(a027*a114);
  a115=(a023-a103);
  a115=(a115+a025);
  a115=(a031*a115);
  a114=(a114+a115);
  a114=(a114+a023);
  a114=(a114+a030);
  a114=(a114/a032);
  a115=(a102/a114);
  a116=(a103-a025);
  a116=(a007*a116);
  a116=(a116+a103);
  a116=(a034*a116);
  a117=(a116/a114);
  a118=casadi_sq(a105);
  a118=(a118*a104);
  a118=(a118-a111);
  a118=(a037*a118);
  a102=(a117*a102);
  a102=(a118+a102);
  a116=(a116*a117);
  a116=(a021-a116);
  a102=(a102/a116);
  a111=(a117*a102);
  a115=(a115+a111);
  a111=(a091*a115);
  a039=(a039+a111);
  a039=(a003-a039);
  a111=(a005*a039);
  a004=(a004+a111);
  a111=1.8915178993145003e+00;
  a111=(a111*a002);
  a119=3.7109375000000000e-02;
  a119=(a119*a002);
  a120=(a119*a033);
  a121=1.7025221101954405e-01;
  a121=(a121*a002);
  a122=(a121*a095);
  a120=(a120+a122);
  a122=6.0216538980455959e-02;
  a122=(a122*a002);
  a123=(a122*a115);
  a120=(a120+a123);
  a123=-1.7578125000000000e-02;
  a123=(a123*a002);
  a124=(a006*a009);
  a125=(a040*a081);
  a124=(a124+a125);
  a125=(a091*a102);
  a124=(a124+a125);
  a124=(a008+a124);
  a125=(a007*a124);
  a126=(a006*a008);
  a127=(a040*a042);
  a126=(a126+a127);
  a127=(a091*a100);
  a126=(a126+a127);
  a126=(a010+a126);
  a127=sin(a126);
  a125=(a125*a127);
  a128=(2.*a039);
  a128=(a128-a124);
  a125=(a125*a128);
  a129=(a006*a003);
  a130=(a040*a084);
  a129=(a129+a130);
  a130=(a091*a105);
  a129=(a129+a130);
  a129=(a000+a129);
  a130=cos(a129);
  a131=(a014*a130);
  a132=sin(a129);
  a133=(a017*a132);
  a131=(a131-a133);
  a133=(a007*a131);
  a125=(a125+a133);
  a129=(a013-a129);
  a129=(a129+a126);
  a134=sin(a129);
  a135=(a007*a134);
  a125=(a125-a135);
  a136=(a023*a131);
  a136=(a136*a026);
  a125=(a125+a136);
  a136=(2.*a131);
  a125=(a125+a136);
  a125=(a125/a026);
  a126=cos(a126);
  a137=(2.*a126);
  a137=(a023-a137);
  a137=(a137+a030);
  a137=(a027*a137);
  a138=(a023-a126);
  a138=(a138+a025);
  a138=(a031*a138);
  a137=(a137+a138);
  a137=(a137+a023);
  a137=(a137+a030);
  a137=(a137/a032);
  a138=(a125/a137);
  a139=(a126-a025);
  a139=(a007*a139);
  a139=(a139+a126);
  a139=(a034*a139);
  a140=(a139/a137);
  a141=casadi_sq(a039);
  a141=(a141*a127);
  a141=(a141-a134);
  a141=(a037*a141);
  a125=(a140*a125);
  a125=(a141+a125);
  a139=(a139*a140);
  a139=(a021-a139);
  a125=(a125/a139);
  a134=(a140*a125);
  a138=(a138+a134);
  a134=(a123*a138);
  a120=(a120+a134);
  a120=(a003-a120);
  a134=(a111*a120);
  a004=(a004+a134);
  a134=-5.8012039600105849e+00;
  a134=(a134*a002);
  a142=3.7092000118504789e-02;
  a142=(a142*a002);
  a143=(a142*a033);
  a144=1.7038392571223998e-01;
  a144=(a144*a002);
  a145=(a144*a095);
  a143=(a143+a145);
  a145=1.0726203044637328e-01;
  a145=(a145*a002);
  a146=(a145*a115);
  a143=(a143+a146);
  a146=-1.5319437748624402e-02;
  a146=(a146*a002);
  a147=(a146*a138);
  a143=(a143+a147);
  a147=8.2737891638140233e-03;
  a147=(a147*a002);
  a148=(a119*a009);
  a149=(a121*a081);
  a148=(a148+a149);
  a149=(a122*a102);
  a148=(a148+a149);
  a149=(a123*a125);
  a148=(a148+a149);
  a148=(a008+a148);
  a149=(a007*a148);
  a150=(a119*a008);
  a151=(a121*a042);
  a150=(a150+a151);
  a151=(a122*a100);
  a150=(a150+a151);
  a151=(a123*a124);
  a150=(a150+a151);
  a150=(a010+a150);
  a151=sin(a150);
  a149=(a149*a151);
  a152=(2.*a120);
  a152=(a152-a148);
  a149=(a149*a152);
  a153=(a119*a003);
  a154=(a121*a084);
  a153=(a153+a154);
  a154=(a122*a105);
  a153=(a153+a154);
  a154=(a123*a039);
  a153=(a153+a154);
  a153=(a000+a153);
  a154=cos(a153);
  a155=(a014*a154);
  a156=sin(a153);
  a157=(a017*a156);
  a155=(a155-a157);
  a157=(a007*a155);
  a149=(a149+a157);
  a153=(a013-a153);
  a153=(a153+a150);
  a158=sin(a153);
  a159=(a007*a158);
  a149=(a149-a159);
  a160=(a023*a155);
  a160=(a160*a026);
  a149=(a149+a160);
  a160=(2.*a155);
  a149=(a149+a160);
  a149=(a149/a026);
  a150=cos(a150);
  a161=(2.*a150);
  a161=(a023-a161);
  a161=(a161+a030);
  a161=(a027*a161);
  a162=(a023-a150);
  a162=(a162+a025);
  a162=(a031*a162);
  a161=(a161+a162);
  a161=(a161+a023);
  a161=(a161+a030);
  a161=(a161/a032);
  a162=(a149/a161);
  a163=(a150-a025);
  a163=(a007*a163);
  a163=(a163+a150);
  a163=(a034*a163);
  a164=(a163/a161);
  a165=casadi_sq(a120);
  a165=(a165*a151);
  a165=(a165-a158);
  a165=(a037*a165);
  a149=(a164*a149);
  a149=(a165+a149);
  a163=(a163*a164);
  a163=(a021-a163);
  a149=(a149/a163);
  a158=(a164*a149);
  a162=(a162+a158);
  a158=(a147*a162);
  a143=(a143+a158);
  a143=(a003-a143);
  a158=(a134*a143);
  a004=(a004+a158);
  a158=3.1116436695781990e-01;
  a158=(a158*a002);
  a166=6.2411095871607569e-01;
  a166=(a166*a002);
  a167=(a166*a033);
  a168=-3.3608926294469414e+00;
  a168=(a168*a002);
  a169=(a168*a095);
  a167=(a167+a169);
  a169=-8.6821934684172597e-01;
  a169=(a169*a002);
  a170=(a169*a115);
  a167=(a167+a170);
  a170=2.7592099699446710e+01;
  a170=(a170*a002);
  a171=(a170*a138);
  a167=(a167+a171);
  a171=2.0154067550477894e+01;
  a171=(a171*a002);
  a172=(a171*a162);
  a167=(a167+a172);
  a172=-4.3489884181069961e+01;
  a172=(a172*a002);
  a173=(a142*a009);
  a174=(a144*a081);
  a173=(a173+a174);
  a174=(a145*a102);
  a173=(a173+a174);
  a174=(a146*a125);
  a173=(a173+a174);
  a174=(a147*a149);
  a173=(a173+a174);
  a173=(a008+a173);
  a174=(a007*a173);
  a175=(a142*a008);
  a176=(a144*a042);
  a175=(a175+a176);
  a176=(a145*a100);
  a175=(a175+a176);
  a176=(a146*a124);
  a175=(a175+a176);
  a176=(a147*a148);
  a175=(a175+a176);
  a175=(a010+a175);
  a176=sin(a175);
  a174=(a174*a176);
  a177=(2.*a143);
  a177=(a177-a173);
  a174=(a174*a177);
  a178=(a142*a003);
  a179=(a144*a084);
  a178=(a178+a179);
  a179=(a145*a105);
  a178=(a178+a179);
  a179=(a146*a039);
  a178=(a178+a179);
  a179=(a147*a120);
  a178=(a178+a179);
  a178=(a000+a178);
  a179=cos(a178);
  a180=(a014*a179);
  a181=sin(a178);
  a182=(a017*a181);
  a180=(a180-a182);
  a182=(a007*a180);
  a174=(a174+a182);
  a178=(a013-a178);
  a178=(a178+a175);
  a183=sin(a178);
  a184=(a007*a183);
  a174=(a174-a184);
  a185=(a023*a180);
  a185=(a185*a026);
  a174=(a174+a185);
  a185=(2.*a180);
  a174=(a174+a185);
  a174=(a174/a026);
  a175=cos(a175);
  a186=(2.*a175);
  a186=(a023-a186);
  a186=(a186+a030);
  a186=(a027*a186);
  a187=(a023-a175);
  a187=(a187+a025);
  a187=(a031*a187);
  a186=(a186+a187);
  a186=(a186+a023);
  a186=(a186+a030);
  a186=(a186/a032);
  a187=(a174/a186);
  a188=(a175-a025);
  a188=(a007*a188);
  a188=(a188+a175);
  a188=(a034*a188);
  a189=(a188/a186);
  a190=casadi_sq(a143);
  a190=(a190*a176);
  a190=(a190-a183);
  a190=(a037*a190);
  a174=(a189*a174);
  a174=(a190+a174);
  a188=(a188*a189);
  a188=(a021-a188);
  a174=(a174/a188);
  a183=(a189*a174);
  a187=(a187+a183);
  a183=(a172*a187);
  a167=(a167+a183);
  a167=(a003-a167);
  a183=(a158*a167);
  a004=(a004+a183);
  a183=-1.5216094966251609e-01;
  a183=(a183*a002);
  a191=4.7766253643826434e-01;
  a191=(a191*a002);
  a192=(a191*a033);
  a193=-2.4881146199716677e+00;
  a193=(a193*a002);
  a194=(a193*a095);
  a192=(a192+a194);
  a194=-5.9029082683684297e-01;
  a194=(a194*a002);
  a195=(a194*a115);
  a192=(a192+a195);
  a195=2.1230051448181193e+01;
  a195=(a195*a002);
  a196=(a195*a138);
  a192=(a192+a196);
  a196=1.5279233632882423e+01;
  a196=(a196*a002);
  a197=(a196*a162);
  a192=(a192+a197);
  a197=-3.3288210968984863e+01;
  a197=(a197*a002);
  a198=(a197*a187);
  a192=(a192+a198);
  a198=-2.0331201708508627e-02;
  a198=(a198*a002);
  a199=(a166*a009);
  a200=(a168*a081);
  a199=(a199+a200);
  a200=(a169*a102);
  a199=(a199+a200);
  a200=(a170*a125);
  a199=(a199+a200);
  a200=(a171*a149);
  a199=(a199+a200);
  a200=(a172*a174);
  a199=(a199+a200);
  a199=(a008+a199);
  a200=(a007*a199);
  a201=(a166*a008);
  a202=(a168*a042);
  a201=(a201+a202);
  a202=(a169*a100);
  a201=(a201+a202);
  a202=(a170*a124);
  a201=(a201+a202);
  a202=(a171*a148);
  a201=(a201+a202);
  a202=(a172*a173);
  a201=(a201+a202);
  a201=(a010+a201);
  a202=sin(a201);
  a200=(a200*a202);
  a203=(2.*a167);
  a203=(a203-a199);
  a200=(a200*a203);
  a204=(a166*a003);
  a205=(a168*a084);
  a204=(a204+a205);
  a205=(a169*a105);
  a204=(a204+a205);
  a205=(a170*a039);
  a204=(a204+a205);
  a205=(a171*a120);
  a204=(a204+a205);
  a205=(a172*a143);
  a204=(a204+a205);
  a204=(a000+a204);
  a205=cos(a204);
  a206=(a014*a205);
  a207=sin(a204);
  a208=(a017*a207);
  a206=(a206-a208);
  a208=(a007*a206);
  a200=(a200+a208);
  a204=(a013-a204);
  a204=(a204+a201);
  a209=sin(a204);
  a210=(a007*a209);
  a200=(a200-a210);
  a211=(a023*a206);
  a211=(a211*a026);
  a200=(a200+a211);
  a211=(2.*a206);
  a200=(a200+a211);
  a200=(a200/a026);
  a201=cos(a201);
  a212=(2.*a201);
  a212=(a023-a212);
  a212=(a212+a030);
  a212=(a027*a212);
  a213=(a023-a201);
  a213=(a213+a025);
  a213=(a031*a213);
  a212=(a212+a213);
  a212=(a212+a023);
  a212=(a212+a030);
  a212=(a212/a032);
  a213=(a200/a212);
  a214=(a201-a025);
  a214=(a007*a214);
  a214=(a214+a201);
  a214=(a034*a214);
  a215=(a214/a212);
  a216=casadi_sq(a167);
  a216=(a216*a202);
  a216=(a216-a209);
  a216=(a037*a216);
  a200=(a215*a200);
  a200=(a216+a200);
  a214=(a214*a215);
  a214=(a021-a214);
  a200=(a200/a214);
  a209=(a215*a200);
  a213=(a213+a209);
  a209=(a198*a213);
  a192=(a192+a209);
  a192=(a003-a192);
  a209=(a183*a192);
  a004=(a004+a209);
  a209=2.0136540080403034e-01;
  a209=(a209*a002);
  a217=-9.3714243008598730e-01;
  a217=(a217*a002);
  a218=(a217*a033);
  a219=5.1863724288440638e+00;
  a219=(a219*a002);
  a220=(a219*a095);
  a218=(a218+a220);
  a220=1.0914373489967295e+00;
  a220=(a220*a002);
  a221=(a220*a115);
  a218=(a218+a221);
  a221=-8.1497870107469268e+00;
  a221=(a221*a002);
  a222=(a221*a138);
  a218=(a218+a222);
  a222=-1.8520065659996959e+01;
  a222=(a222*a002);
  a223=(a222*a162);
  a218=(a218+a223);
  a223=2.2739487099350505e+01;
  a223=(a223*a002);
  a224=(a223*a187);
  a218=(a218+a224);
  a224=2.4936055526796523e+00;
  a224=(a224*a002);
  a225=(a224*a213);
  a218=(a218+a225);
  a225=-3.0467644718982196e+00;
  a225=(a225*a002);
  a226=(a191*a009);
  a227=(a193*a081);
  a226=(a226+a227);
  a227=(a194*a102);
  a226=(a226+a227);
  a227=(a195*a125);
  a226=(a226+a227);
  a227=(a196*a149);
  a226=(a226+a227);
  a227=(a197*a174);
  a226=(a226+a227);
  a227=(a198*a200);
  a226=(a226+a227);
  a226=(a008+a226);
  a227=(a007*a226);
  a228=(a191*a008);
  a229=(a193*a042);
  a228=(a228+a229);
  a229=(a194*a100);
  a228=(a228+a229);
  a229=(a195*a124);
  a228=(a228+a229);
  a229=(a196*a148);
  a228=(a228+a229);
  a229=(a197*a173);
  a228=(a228+a229);
  a229=(a198*a199);
  a228=(a228+a229);
  a228=(a010+a228);
  a229=sin(a228);
  a227=(a227*a229);
  a230=(2.*a192);
  a230=(a230-a226);
  a227=(a227*a230);
  a231=(a191*a003);
  a232=(a193*a084);
  a231=(a231+a232);
  a232=(a194*a105);
  a231=(a231+a232);
  a232=(a195*a039);
  a231=(a231+a232);
  a232=(a196*a120);
  a231=(a231+a232);
  a232=(a197*a143);
  a231=(a231+a232);
  a232=(a198*a167);
  a231=(a231+a232);
  a231=(a000+a231);
  a232=cos(a231);
  a233=(a014*a232);
  a234=sin(a231);
  a235=(a017*a234);
  a233=(a233-a235);
  a235=(a007*a233);
  a227=(a227+a235);
  a231=(a013-a231);
  a231=(a231+a228);
  a236=sin(a231);
  a237=(a007*a236);
  a227=(a227-a237);
  a238=(a023*a233);
  a238=(a238*a026);
  a227=(a227+a238);
  a238=(2.*a233);
  a227=(a227+a238);
  a227=(a227/a026);
  a228=cos(a228);
  a239=(2.*a228);
  a239=(a023-a239);
  a239=(a239+a030);
  a239=(a027*a239);
  a240=(a023-a228);
  a240=(a240+a025);
  a240=(a031*a240);
  a239=(a239+a240);
  a239=(a239+a023);
  a239=(a239+a030);
  a239=(a239/a032);
  a240=(a227/a239);
  a241=(a228-a025);
  a241=(a007*a241);
  a241=(a241+a228);
  a241=(a034*a241);
  a242=(a241/a239);
  a243=casadi_sq(a192);
  a243=(a243*a229);
  a243=(a243-a236);
  a243=(a037*a243);
  a227=(a242*a227);
  a227=(a243+a227);
  a241=(a241*a242);
  a241=(a021-a241);
  a227=(a227/a241);
  a236=(a242*a227);
  a240=(a240+a236);
  a236=(a225*a240);
  a218=(a218+a236);
  a218=(a003-a218);
  a236=(a209*a218);
  a004=(a004+a236);
  a236=4.4710615727772587e-02;
  a236=(a236*a002);
  a244=2.2733101475165380e+00;
  a244=(a244*a002);
  a245=(a244*a033);
  a246=-1.0534495466737249e+01;
  a246=(a246*a002);
  a095=(a246*a095);
  a245=(a245+a095);
  a095=-2.0008720582248625e+00;
  a095=(a095*a002);
  a115=(a095*a115);
  a245=(a245+a115);
  a115=-1.7958931863118799e+01;
  a115=(a115*a002);
  a247=(a115*a138);
  a245=(a245+a247);
  a247=2.7948884529419960e+01;
  a247=(a247*a002);
  a248=(a247*a162);
  a245=(a245+a248);
  a248=-2.8589982771350235e+00;
  a248=(a248*a002);
  a249=(a248*a187);
  a245=(a245+a249);
  a249=-8.8728569335306293e+00;
  a249=(a249*a002);
  a250=(a249*a213);
  a245=(a245+a250);
  a250=1.2360567175794303e+01;
  a250=(a250*a002);
  a251=(a250*a240);
  a245=(a245+a251);
  a251=6.4339274601576357e-01;
  a251=(a251*a002);
  a002=(a217*a009);
  a252=(a219*a081);
  a002=(a002+a252);
  a252=(a220*a102);
  a002=(a002+a252);
  a252=(a221*a125);
  a002=(a002+a252);
  a252=(a222*a149);
  a002=(a002+a252);
  a252=(a223*a174);
  a002=(a002+a252);
  a252=(a224*a200);
  a002=(a002+a252);
  a252=(a225*a227);
  a002=(a002+a252);
  a002=(a008+a002);
  a252=(a007*a002);
  a253=(a217*a008);
  a254=(a219*a042);
  a253=(a253+a254);
  a254=(a220*a100);
  a253=(a253+a254);
  a254=(a221*a124);
  a253=(a253+a254);
  a254=(a222*a148);
  a253=(a253+a254);
  a254=(a223*a173);
  a253=(a253+a254);
  a254=(a224*a199);
  a253=(a253+a254);
  a254=(a225*a226);
  a253=(a253+a254);
  a253=(a010+a253);
  a254=sin(a253);
  a252=(a252*a254);
  a255=(2.*a218);
  a255=(a255-a002);
  a252=(a252*a255);
  a256=(a217*a003);
  a257=(a219*a084);
  a256=(a256+a257);
  a257=(a220*a105);
  a256=(a256+a257);
  a257=(a221*a039);
  a256=(a256+a257);
  a257=(a222*a120);
  a256=(a256+a257);
  a257=(a223*a143);
  a256=(a256+a257);
  a257=(a224*a167);
  a256=(a256+a257);
  a257=(a225*a192);
  a256=(a256+a257);
  a256=(a000+a256);
  a257=cos(a256);
  a258=(a014*a257);
  a259=sin(a256);
  a260=(a017*a259);
  a258=(a258-a260);
  a260=(a007*a258);
  a252=(a252+a260);
  a256=(a013-a256);
  a256=(a256+a253);
  a261=sin(a256);
  a262=(a007*a261);
  a252=(a252-a262);
  a263=(a023*a258);
  a263=(a263*a026);
  a252=(a252+a263);
  a263=(2.*a258);
  a252=(a252+a263);
  a252=(a252/a026);
  a253=cos(a253);
  a264=(2.*a253);
  a264=(a023-a264);
  a264=(a264+a030);
  a264=(a027*a264);
  a265=(a023-a253);
  a265=(a265+a025);
  a265=(a031*a265);
  a264=(a264+a265);
  a264=(a264+a023);
  a264=(a264+a030);
  a264=(a264/a032);
  a265=(a252/a264);
  a266=(a253-a025);
  a266=(a007*a266);
  a266=(a266+a253);
  a266=(a034*a266);
  a267=(a266/a264);
  a268=casadi_sq(a218);
  a268=(a268*a254);
  a268=(a268-a261);
  a268=(a037*a268);
  a252=(a267*a252);
  a252=(a268+a252);
  a266=(a266*a267);
  a266=(a021-a266);
  a252=(a252/a266);
  a261=(a267*a252);
  a265=(a265+a261);
  a261=(a251*a265);
  a245=(a245+a261);
  a245=(a003-a245);
  a261=(a236*a245);
  a004=(a004+a261);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a261=(a005*a124);
  a004=(a004+a261);
  a261=(a111*a148);
  a004=(a004+a261);
  a261=(a134*a173);
  a004=(a004+a261);
  a261=(a158*a199);
  a004=(a004+a261);
  a261=(a183*a226);
  a004=(a004+a261);
  a261=(a209*a002);
  a004=(a004+a261);
  a261=(a244*a009);
  a081=(a246*a081);
  a261=(a261+a081);
  a102=(a095*a102);
  a261=(a261+a102);
  a102=(a115*a125);
  a261=(a261+a102);
  a102=(a247*a149);
  a261=(a261+a102);
  a102=(a248*a174);
  a261=(a261+a102);
  a102=(a249*a200);
  a261=(a261+a102);
  a102=(a250*a227);
  a261=(a261+a102);
  a102=(a251*a252);
  a261=(a261+a102);
  a261=(a008+a261);
  a102=(a236*a261);
  a004=(a004+a102);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a033=(a001*a033);
  a138=(a005*a138);
  a033=(a033+a138);
  a162=(a111*a162);
  a033=(a033+a162);
  a187=(a134*a187);
  a033=(a033+a187);
  a213=(a158*a213);
  a033=(a033+a213);
  a240=(a183*a240);
  a033=(a033+a240);
  a265=(a209*a265);
  a033=(a033+a265);
  a265=(a007*a261);
  a240=(a244*a008);
  a213=(a246*a042);
  a240=(a240+a213);
  a213=(a095*a100);
  a240=(a240+a213);
  a213=(a115*a124);
  a240=(a240+a213);
  a213=(a247*a148);
  a240=(a240+a213);
  a213=(a248*a173);
  a240=(a240+a213);
  a213=(a249*a199);
  a240=(a240+a213);
  a213=(a250*a226);
  a240=(a240+a213);
  a213=(a251*a002);
  a240=(a240+a213);
  a010=(a010+a240);
  a240=sin(a010);
  a265=(a265*a240);
  a213=(2.*a245);
  a213=(a213-a261);
  a265=(a265*a213);
  a187=(a244*a003);
  a162=(a246*a084);
  a187=(a187+a162);
  a162=(a095*a105);
  a187=(a187+a162);
  a162=(a115*a039);
  a187=(a187+a162);
  a162=(a247*a120);
  a187=(a187+a162);
  a162=(a248*a143);
  a187=(a187+a162);
  a162=(a249*a167);
  a187=(a187+a162);
  a162=(a250*a192);
  a187=(a187+a162);
  a162=(a251*a218);
  a187=(a187+a162);
  a000=(a000+a187);
  a187=cos(a000);
  a162=(a014*a187);
  a138=sin(a000);
  a004=(a017*a138);
  a162=(a162-a004);
  a004=(a007*a162);
  a265=(a265+a004);
  a013=(a013-a000);
  a013=(a013+a010);
  a000=sin(a013);
  a102=(a007*a000);
  a265=(a265-a102);
  a081=(a023*a162);
  a081=(a081*a026);
  a265=(a265+a081);
  a081=(2.*a162);
  a265=(a265+a081);
  a265=(a265/a026);
  a010=cos(a010);
  a269=(2.*a010);
  a269=(a023-a269);
  a269=(a269+a030);
  a027=(a027*a269);
  a269=(a023-a010);
  a269=(a269+a025);
  a269=(a031*a269);
  a027=(a027+a269);
  a027=(a027+a023);
  a027=(a027+a030);
  a027=(a027/a032);
  a032=(a265/a027);
  a025=(a010-a025);
  a025=(a007*a025);
  a025=(a025+a010);
  a034=(a034*a025);
  a025=(a034/a027);
  a030=casadi_sq(a245);
  a030=(a030*a240);
  a030=(a030-a000);
  a030=(a037*a030);
  a265=(a025*a265);
  a265=(a030+a265);
  a034=(a034*a025);
  a021=(a021-a034);
  a265=(a265/a021);
  a034=(a025*a265);
  a032=(a032+a034);
  a032=(a236*a032);
  a033=(a033+a032);
  a033=(a003-a033);
  if (res[0]!=0) res[0][2]=a033;
  a009=(a001*a009);
  a125=(a005*a125);
  a009=(a009+a125);
  a149=(a111*a149);
  a009=(a009+a149);
  a174=(a134*a174);
  a009=(a009+a174);
  a200=(a158*a200);
  a009=(a009+a200);
  a227=(a183*a227);
  a009=(a009+a227);
  a252=(a209*a252);
  a009=(a009+a252);
  a265=(a236*a265);
  a009=(a009+a265);
  a009=(a008+a009);
  if (res[0]!=0) res[0][3]=a009;
  a009=arg[0]? arg[0][4] : 0;
  a265=arg[0]? arg[0][6] : 0;
  a252=(a001*a265);
  a015=(a017*a015);
  a018=(a014*a018);
  a015=(a015+a018);
  a018=(a007*a015);
  a020=cos(a020);
  a227=(a007*a020);
  a018=(a018-a227);
  a023=(a023*a026);
  a200=(a015*a023);
  a018=(a018+a200);
  a015=(2.*a015);
  a018=(a018+a015);
  a018=(a018/a026);
  a015=(a018/a029);
  a227=(a227/a026);
  a018=(a036*a018);
  a227=(a227-a018);
  a227=(a227/a035);
  a018=(a036*a227);
  a015=(a015-a018);
  a018=(a015*a009);
  a019=(a019-a022);
  a022=(a007*a011);
  a012=(a008*a012);
  a022=(a022*a012);
  a019=(a019+a022);
  a016=(a016*a023);
  a019=(a019+a016);
  a019=(a019+a024);
  a019=(a019/a026);
  a024=(a036*a019);
  a038=(a038+a024);
  a038=(a038/a035);
  a024=(a038*a011);
  a019=(a019/a029);
  a038=(a036*a038);
  a019=(a019+a038);
  a038=(-a019);
  a038=(2.*a038);
  a038=(a038*a011);
  a024=(a024-a038);
  a024=(a024+a020);
  a012=(a028*a012);
  a024=(a024-a012);
  a024=(a037*a024);
  a012=(a024/a029);
  a028=(a028*a003);
  a028=(a028*a003);
  a019=(a019*a011);
  a019=(a019+a020);
  a028=(a028-a019);
  a028=(a037*a028);
  a024=(a036*a024);
  a028=(a028-a024);
  a028=(a028/a035);
  a024=(a036*a028);
  a012=(a012-a024);
  a024=arg[0]? arg[0][5] : 0;
  a019=(a012*a024);
  a018=(a018+a019);
  a019=(a031/a026);
  a020=(a011*a019);
  a038=(a008-a003);
  a020=(a020*a038);
  a038=(a020/a029);
  a020=(a036*a020);
  a020=(a020/a035);
  a016=(a036*a020);
  a038=(a038+a016);
  a016=arg[0]? arg[0][7] : 0;
  a022=(a038*a016);
  a008=(a008*a011);
  a008=(a008*a019);
  a029=(a008/a029);
  a003=(a031*a003);
  a003=(a003*a011);
  a003=(a003/a026);
  a008=(a036*a008);
  a003=(a003+a008);
  a003=(a003/a035);
  a036=(a036*a003);
  a029=(a029+a036);
  a036=(a029*a265);
  a022=(a022-a036);
  a018=(a018+a022);
  a022=(a006*a018);
  a087=(a017*a087);
  a089=(a014*a089);
  a087=(a087+a089);
  a089=(a007*a087);
  a086=cos(a086);
  a036=(a007*a086);
  a089=(a089-a036);
  a035=(a087*a023);
  a089=(a089+a035);
  a087=(2.*a087);
  a089=(a089+a087);
  a089=(a089/a026);
  a087=(a089/a094);
  a036=(a036/a026);
  a089=(a097*a089);
  a036=(a036-a089);
  a036=(a036/a096);
  a089=(a097*a036);
  a087=(a087-a089);
  a089=(a041*a265);
  a035=(a044*a018);
  a055=(a017*a055);
  a057=(a014*a057);
  a055=(a055+a057);
  a057=(a007*a055);
  a054=cos(a054);
  a008=(a007*a054);
  a057=(a057-a008);
  a011=(a055*a023);
  a057=(a057+a011);
  a055=(2.*a055);
  a057=(a057+a055);
  a057=(a057/a026);
  a055=(a057/a062);
  a008=(a008/a026);
  a057=(a065*a057);
  a008=(a008-a057);
  a008=(a008/a064);
  a057=(a065*a008);
  a055=(a055-a057);
  a057=(a047*a265);
  a057=(a009+a057);
  a011=(a055*a057);
  a058=(a058-a060);
  a060=(a007*a051);
  a053=(a048*a053);
  a060=(a060*a053);
  a058=(a058+a060);
  a056=(a056*a023);
  a058=(a058+a056);
  a058=(a058+a061);
  a058=(a058/a026);
  a061=(a065*a058);
  a066=(a066+a061);
  a066=(a066/a064);
  a061=(a066*a051);
  a058=(a058/a062);
  a066=(a065*a066);
  a058=(a058+a066);
  a066=(-a058);
  a066=(2.*a066);
  a066=(a066*a051);
  a061=(a061-a066);
  a061=(a061+a054);
  a053=(a050*a053);
  a061=(a061-a053);
  a061=(a037*a061);
  a053=(a061/a062);
  a050=(a050*a052);
  a050=(a050*a052);
  a058=(a058*a051);
  a058=(a058+a054);
  a050=(a050-a058);
  a050=(a037*a050);
  a061=(a065*a061);
  a050=(a050-a061);
  a050=(a050/a064);
  a061=(a065*a050);
  a053=(a053-a061);
  a061=(a047*a016);
  a061=(a024+a061);
  a058=(a053*a061);
  a011=(a011+a058);
  a058=(a051*a019);
  a054=(a048-a052);
  a058=(a058*a054);
  a054=(a058/a062);
  a058=(a065*a058);
  a058=(a058/a064);
  a066=(a065*a058);
  a054=(a054+a066);
  a066=(a227*a009);
  a056=(a028*a024);
  a066=(a066+a056);
  a056=(a003*a265);
  a060=(a020*a016);
  a056=(a056-a060);
  a066=(a066+a056);
  a056=(a047*a066);
  a056=(a016+a056);
  a060=(a054*a056);
  a048=(a048*a051);
  a048=(a048*a019);
  a062=(a048/a062);
  a052=(a031*a052);
  a052=(a052*a051);
  a052=(a052/a026);
  a048=(a065*a048);
  a052=(a052+a048);
  a052=(a052/a064);
  a065=(a065*a052);
  a062=(a062+a065);
  a065=(a047*a018);
  a065=(a265+a065);
  a064=(a062*a065);
  a060=(a060-a064);
  a011=(a011+a060);
  a011=(a046*a011);
  a035=(a035+a011);
  a035=(a265+a035);
  a011=(a043*a035);
  a089=(a089+a011);
  a089=(a009+a089);
  a011=(a087*a089);
  a090=(a090-a092);
  a092=(a007*a083);
  a085=(a042*a085);
  a092=(a092*a085);
  a090=(a090+a092);
  a088=(a088*a023);
  a090=(a090+a088);
  a090=(a090+a093);
  a090=(a090/a026);
  a093=(a097*a090);
  a098=(a098+a093);
  a098=(a098/a096);
  a093=(a098*a083);
  a090=(a090/a094);
  a098=(a097*a098);
  a090=(a090+a098);
  a098=(-a090);
  a098=(2.*a098);
  a098=(a098*a083);
  a093=(a093-a098);
  a093=(a093+a086);
  a085=(a082*a085);
  a093=(a093-a085);
  a093=(a037*a093);
  a085=(a093/a094);
  a082=(a082*a084);
  a082=(a082*a084);
  a090=(a090*a083);
  a090=(a090+a086);
  a082=(a082-a090);
  a082=(a037*a082);
  a093=(a097*a093);
  a082=(a082-a093);
  a082=(a082/a096);
  a093=(a097*a082);
  a085=(a085-a093);
  a093=(a041*a016);
  a090=(a044*a066);
  a057=(a008*a057);
  a061=(a050*a061);
  a057=(a057+a061);
  a061=(a052*a065);
  a086=(a058*a056);
  a061=(a061-a086);
  a057=(a057+a061);
  a057=(a046*a057);
  a090=(a090+a057);
  a090=(a016+a090);
  a057=(a043*a090);
  a093=(a093+a057);
  a093=(a024+a093);
  a057=(a085*a093);
  a011=(a011+a057);
  a057=(a083*a019);
  a061=(a042-a084);
  a057=(a057*a061);
  a061=(a057/a094);
  a057=(a097*a057);
  a057=(a057/a096);
  a086=(a097*a057);
  a061=(a061+a086);
  a086=(a041*a066);
  a069=cos(a069);
  a098=(a007*a069);
  a088=(a098/a026);
  a076=(a017*a076);
  a068=(a014*a068);
  a076=(a076+a068);
  a068=(a007*a076);
  a068=(a068-a098);
  a098=(a076*a023);
  a068=(a068+a098);
  a076=(2.*a076);
  a068=(a068+a076);
  a068=(a068/a026);
  a076=(a073*a068);
  a088=(a088-a076);
  a088=(a088/a071);
  a076=(a044*a265);
  a065=(a046*a065);
  a076=(a076+a065);
  a076=(a009+a076);
  a065=(a088*a076);
  a098=(a059*a045);
  a098=(a098*a045);
  a078=(a078-a070);
  a070=(a007*a067);
  a075=(a074*a075);
  a070=(a070*a075);
  a078=(a078+a070);
  a077=(a077*a023);
  a078=(a078+a077);
  a078=(a078+a079);
  a078=(a078/a026);
  a079=(a078/a072);
  a078=(a073*a078);
  a063=(a063+a078);
  a063=(a063/a071);
  a078=(a073*a063);
  a079=(a079+a078);
  a078=(a079*a067);
  a078=(a078+a069);
  a098=(a098-a078);
  a098=(a037*a098);
  a063=(a063*a067);
  a079=(-a079);
  a079=(2.*a079);
  a079=(a079*a067);
  a063=(a063-a079);
  a063=(a063+a069);
  a059=(a059*a075);
  a063=(a063-a059);
  a063=(a037*a063);
  a059=(a073*a063);
  a098=(a098-a059);
  a098=(a098/a071);
  a059=(a044*a016);
  a056=(a046*a056);
  a059=(a059+a056);
  a059=(a024+a059);
  a056=(a098*a059);
  a065=(a065+a056);
  a056=(a031*a045);
  a056=(a056*a067);
  a056=(a056/a026);
  a075=(a074*a067);
  a075=(a075*a019);
  a069=(a073*a075);
  a056=(a056+a069);
  a056=(a056/a071);
  a069=(a056*a035);
  a067=(a067*a019);
  a074=(a074-a045);
  a067=(a067*a074);
  a074=(a073*a067);
  a074=(a074/a071);
  a071=(a074*a090);
  a069=(a069-a071);
  a065=(a065+a069);
  a069=(a043*a065);
  a086=(a086+a069);
  a086=(a016+a086);
  a069=(a061*a086);
  a042=(a042*a083);
  a042=(a042*a019);
  a094=(a042/a094);
  a084=(a031*a084);
  a084=(a084*a083);
  a084=(a084/a026);
  a042=(a097*a042);
  a084=(a084+a042);
  a084=(a084/a096);
  a097=(a097*a084);
  a094=(a094+a097);
  a097=(a041*a018);
  a068=(a068/a072);
  a096=(a073*a088);
  a068=(a068-a096);
  a076=(a068*a076);
  a063=(a063/a072);
  a096=(a073*a098);
  a063=(a063-a096);
  a059=(a063*a059);
  a076=(a076+a059);
  a067=(a067/a072);
  a059=(a073*a074);
  a067=(a067+a059);
  a059=(a067*a090);
  a075=(a075/a072);
  a073=(a073*a056);
  a075=(a075+a073);
  a073=(a075*a035);
  a059=(a059-a073);
  a076=(a076+a059);
  a059=(a043*a076);
  a097=(a097+a059);
  a097=(a265+a097);
  a059=(a094*a097);
  a069=(a069-a059);
  a011=(a011+a069);
  a069=(a040*a011);
  a022=(a022+a069);
  a107=(a017*a107);
  a109=(a014*a109);
  a107=(a107+a109);
  a109=(a007*a107);
  a106=cos(a106);
  a069=(a007*a106);
  a109=(a109-a069);
  a059=(a107*a023);
  a109=(a109+a059);
  a107=(2.*a107);
  a109=(a109+a107);
  a109=(a109/a026);
  a107=(a109/a114);
  a069=(a069/a026);
  a109=(a117*a109);
  a069=(a069-a109);
  a069=(a069/a116);
  a109=(a117*a069);
  a107=(a107-a109);
  a109=(a099*a265);
  a035=(a101*a035);
  a109=(a109+a035);
  a035=(a080*a097);
  a109=(a109+a035);
  a109=(a009+a109);
  a035=(a107*a109);
  a110=(a110-a112);
  a112=(a007*a104);
  a049=(a100*a049);
  a112=(a112*a049);
  a110=(a110+a112);
  a108=(a108*a023);
  a110=(a110+a108);
  a110=(a110+a113);
  a110=(a110/a026);
  a113=(a117*a110);
  a118=(a118+a113);
  a118=(a118/a116);
  a113=(a118*a104);
  a110=(a110/a114);
  a118=(a117*a118);
  a110=(a110+a118);
  a118=(-a110);
  a118=(2.*a118);
  a118=(a118*a104);
  a113=(a113-a118);
  a113=(a113+a106);
  a049=(a103*a049);
  a113=(a113-a049);
  a113=(a037*a113);
  a049=(a113/a114);
  a103=(a103*a105);
  a103=(a103*a105);
  a110=(a110*a104);
  a110=(a110+a106);
  a103=(a103-a110);
  a103=(a037*a103);
  a113=(a117*a113);
  a103=(a103-a113);
  a103=(a103/a116);
  a113=(a117*a103);
  a049=(a049-a113);
  a113=(a099*a016);
  a090=(a101*a090);
  a113=(a113+a090);
  a090=(a080*a086);
  a113=(a113+a090);
  a113=(a024+a113);
  a090=(a049*a113);
  a035=(a035+a090);
  a090=(a104*a019);
  a110=(a100-a105);
  a090=(a090*a110);
  a110=(a090/a114);
  a090=(a117*a090);
  a090=(a090/a116);
  a106=(a117*a090);
  a110=(a110+a106);
  a106=(a099*a066);
  a065=(a101*a065);
  a106=(a106+a065);
  a089=(a036*a089);
  a093=(a082*a093);
  a089=(a089+a093);
  a093=(a084*a097);
  a065=(a057*a086);
  a093=(a093-a065);
  a089=(a089+a093);
  a093=(a080*a089);
  a106=(a106+a093);
  a106=(a016+a106);
  a093=(a110*a106);
  a100=(a100*a104);
  a100=(a100*a019);
  a114=(a100/a114);
  a105=(a031*a105);
  a105=(a105*a104);
  a105=(a105/a026);
  a100=(a117*a100);
  a105=(a105+a100);
  a105=(a105/a116);
  a117=(a117*a105);
  a114=(a114+a117);
  a117=(a099*a018);
  a076=(a101*a076);
  a117=(a117+a076);
  a076=(a080*a011);
  a117=(a117+a076);
  a117=(a265+a117);
  a076=(a114*a117);
  a093=(a093-a076);
  a035=(a035+a093);
  a093=(a091*a035);
  a022=(a022+a093);
  a022=(a265+a022);
  a093=(a005*a022);
  a252=(a252+a093);
  a093=(a119*a018);
  a076=(a121*a011);
  a093=(a093+a076);
  a076=(a122*a035);
  a093=(a093+a076);
  a130=(a017*a130);
  a132=(a014*a132);
  a130=(a130+a132);
  a132=(a007*a130);
  a129=cos(a129);
  a076=(a007*a129);
  a132=(a132-a076);
  a116=(a130*a023);
  a132=(a132+a116);
  a130=(2.*a130);
  a132=(a132+a130);
  a132=(a132/a026);
  a130=(a132/a137);
  a076=(a076/a026);
  a132=(a140*a132);
  a076=(a076-a132);
  a076=(a076/a139);
  a132=(a140*a076);
  a130=(a130-a132);
  a132=(a006*a265);
  a116=(a040*a097);
  a132=(a132+a116);
  a116=(a091*a117);
  a132=(a132+a116);
  a132=(a009+a132);
  a116=(a130*a132);
  a133=(a133-a135);
  a135=(a007*a127);
  a128=(a124*a128);
  a135=(a135*a128);
  a133=(a133+a135);
  a131=(a131*a023);
  a133=(a133+a131);
  a133=(a133+a136);
  a133=(a133/a026);
  a136=(a140*a133);
  a141=(a141+a136);
  a141=(a141/a139);
  a136=(a141*a127);
  a133=(a133/a137);
  a141=(a140*a141);
  a133=(a133+a141);
  a141=(-a133);
  a141=(2.*a141);
  a141=(a141*a127);
  a136=(a136-a141);
  a136=(a136+a129);
  a128=(a126*a128);
  a136=(a136-a128);
  a136=(a037*a136);
  a128=(a136/a137);
  a126=(a126*a039);
  a126=(a126*a039);
  a133=(a133*a127);
  a133=(a133+a129);
  a126=(a126-a133);
  a126=(a037*a126);
  a136=(a140*a136);
  a126=(a126-a136);
  a126=(a126/a139);
  a136=(a140*a126);
  a128=(a128-a136);
  a136=(a006*a016);
  a133=(a040*a086);
  a136=(a136+a133);
  a133=(a091*a106);
  a136=(a136+a133);
  a136=(a024+a136);
  a133=(a128*a136);
  a116=(a116+a133);
  a133=(a127*a019);
  a129=(a124-a039);
  a133=(a133*a129);
  a129=(a133/a137);
  a133=(a140*a133);
  a133=(a133/a139);
  a141=(a140*a133);
  a129=(a129+a141);
  a141=(a006*a066);
  a131=(a040*a089);
  a141=(a141+a131);
  a109=(a069*a109);
  a113=(a103*a113);
  a109=(a109+a113);
  a113=(a105*a117);
  a131=(a090*a106);
  a113=(a113-a131);
  a109=(a109+a113);
  a113=(a091*a109);
  a141=(a141+a113);
  a141=(a016+a141);
  a113=(a129*a141);
  a124=(a124*a127);
  a124=(a124*a019);
  a137=(a124/a137);
  a039=(a031*a039);
  a039=(a039*a127);
  a039=(a039/a026);
  a124=(a140*a124);
  a039=(a039+a124);
  a039=(a039/a139);
  a140=(a140*a039);
  a137=(a137+a140);
  a140=(a137*a022);
  a113=(a113-a140);
  a116=(a116+a113);
  a113=(a123*a116);
  a093=(a093+a113);
  a093=(a265+a093);
  a113=(a111*a093);
  a252=(a252+a113);
  a113=(a142*a018);
  a140=(a144*a011);
  a113=(a113+a140);
  a140=(a145*a035);
  a113=(a113+a140);
  a140=(a146*a116);
  a113=(a113+a140);
  a154=(a017*a154);
  a156=(a014*a156);
  a154=(a154+a156);
  a156=(a007*a154);
  a153=cos(a153);
  a140=(a007*a153);
  a156=(a156-a140);
  a139=(a154*a023);
  a156=(a156+a139);
  a154=(2.*a154);
  a156=(a156+a154);
  a156=(a156/a026);
  a154=(a156/a161);
  a140=(a140/a026);
  a156=(a164*a156);
  a140=(a140-a156);
  a140=(a140/a163);
  a156=(a164*a140);
  a154=(a154-a156);
  a156=(a119*a265);
  a139=(a121*a097);
  a156=(a156+a139);
  a139=(a122*a117);
  a156=(a156+a139);
  a139=(a123*a022);
  a156=(a156+a139);
  a156=(a009+a156);
  a139=(a154*a156);
  a157=(a157-a159);
  a159=(a007*a151);
  a152=(a148*a152);
  a159=(a159*a152);
  a157=(a157+a159);
  a155=(a155*a023);
  a157=(a157+a155);
  a157=(a157+a160);
  a157=(a157/a026);
  a160=(a164*a157);
  a165=(a165+a160);
  a165=(a165/a163);
  a160=(a165*a151);
  a157=(a157/a161);
  a165=(a164*a165);
  a157=(a157+a165);
  a165=(-a157);
  a165=(2.*a165);
  a165=(a165*a151);
  a160=(a160-a165);
  a160=(a160+a153);
  a152=(a150*a152);
  a160=(a160-a152);
  a160=(a037*a160);
  a152=(a160/a161);
  a150=(a150*a120);
  a150=(a150*a120);
  a157=(a157*a151);
  a157=(a157+a153);
  a150=(a150-a157);
  a150=(a037*a150);
  a160=(a164*a160);
  a150=(a150-a160);
  a150=(a150/a163);
  a160=(a164*a150);
  a152=(a152-a160);
  a160=(a119*a016);
  a157=(a121*a086);
  a160=(a160+a157);
  a157=(a122*a106);
  a160=(a160+a157);
  a157=(a123*a141);
  a160=(a160+a157);
  a160=(a024+a160);
  a157=(a152*a160);
  a139=(a139+a157);
  a157=(a151*a019);
  a153=(a148-a120);
  a157=(a157*a153);
  a153=(a157/a161);
  a157=(a164*a157);
  a157=(a157/a163);
  a165=(a164*a157);
  a153=(a153+a165);
  a165=(a119*a066);
  a155=(a121*a089);
  a165=(a165+a155);
  a155=(a122*a109);
  a165=(a165+a155);
  a132=(a076*a132);
  a136=(a126*a136);
  a132=(a132+a136);
  a136=(a039*a022);
  a155=(a133*a141);
  a136=(a136-a155);
  a132=(a132+a136);
  a136=(a123*a132);
  a165=(a165+a136);
  a165=(a016+a165);
  a136=(a153*a165);
  a148=(a148*a151);
  a148=(a148*a019);
  a161=(a148/a161);
  a120=(a031*a120);
  a120=(a120*a151);
  a120=(a120/a026);
  a148=(a164*a148);
  a120=(a120+a148);
  a120=(a120/a163);
  a164=(a164*a120);
  a161=(a161+a164);
  a164=(a161*a093);
  a136=(a136-a164);
  a139=(a139+a136);
  a136=(a147*a139);
  a113=(a113+a136);
  a113=(a265+a113);
  a136=(a134*a113);
  a252=(a252+a136);
  a136=(a166*a018);
  a164=(a168*a011);
  a136=(a136+a164);
  a164=(a169*a035);
  a136=(a136+a164);
  a164=(a170*a116);
  a136=(a136+a164);
  a164=(a171*a139);
  a136=(a136+a164);
  a179=(a017*a179);
  a181=(a014*a181);
  a179=(a179+a181);
  a181=(a007*a179);
  a178=cos(a178);
  a164=(a007*a178);
  a181=(a181-a164);
  a163=(a179*a023);
  a181=(a181+a163);
  a179=(2.*a179);
  a181=(a181+a179);
  a181=(a181/a026);
  a179=(a181/a186);
  a164=(a164/a026);
  a181=(a189*a181);
  a164=(a164-a181);
  a164=(a164/a188);
  a181=(a189*a164);
  a179=(a179-a181);
  a181=(a142*a265);
  a163=(a144*a097);
  a181=(a181+a163);
  a163=(a145*a117);
  a181=(a181+a163);
  a163=(a146*a022);
  a181=(a181+a163);
  a163=(a147*a093);
  a181=(a181+a163);
  a181=(a009+a181);
  a163=(a179*a181);
  a182=(a182-a184);
  a184=(a007*a176);
  a177=(a173*a177);
  a184=(a184*a177);
  a182=(a182+a184);
  a180=(a180*a023);
  a182=(a182+a180);
  a182=(a182+a185);
  a182=(a182/a026);
  a185=(a189*a182);
  a190=(a190+a185);
  a190=(a190/a188);
  a185=(a190*a176);
  a182=(a182/a186);
  a190=(a189*a190);
  a182=(a182+a190);
  a190=(-a182);
  a190=(2.*a190);
  a190=(a190*a176);
  a185=(a185-a190);
  a185=(a185+a178);
  a177=(a175*a177);
  a185=(a185-a177);
  a185=(a037*a185);
  a177=(a185/a186);
  a175=(a175*a143);
  a175=(a175*a143);
  a182=(a182*a176);
  a182=(a182+a178);
  a175=(a175-a182);
  a175=(a037*a175);
  a185=(a189*a185);
  a175=(a175-a185);
  a175=(a175/a188);
  a185=(a189*a175);
  a177=(a177-a185);
  a185=(a142*a016);
  a182=(a144*a086);
  a185=(a185+a182);
  a182=(a145*a106);
  a185=(a185+a182);
  a182=(a146*a141);
  a185=(a185+a182);
  a182=(a147*a165);
  a185=(a185+a182);
  a185=(a024+a185);
  a182=(a177*a185);
  a163=(a163+a182);
  a182=(a176*a019);
  a178=(a173-a143);
  a182=(a182*a178);
  a178=(a182/a186);
  a182=(a189*a182);
  a182=(a182/a188);
  a190=(a189*a182);
  a178=(a178+a190);
  a190=(a142*a066);
  a180=(a144*a089);
  a190=(a190+a180);
  a180=(a145*a109);
  a190=(a190+a180);
  a180=(a146*a132);
  a190=(a190+a180);
  a156=(a140*a156);
  a160=(a150*a160);
  a156=(a156+a160);
  a160=(a120*a093);
  a180=(a157*a165);
  a160=(a160-a180);
  a156=(a156+a160);
  a160=(a147*a156);
  a190=(a190+a160);
  a190=(a016+a190);
  a160=(a178*a190);
  a173=(a173*a176);
  a173=(a173*a019);
  a186=(a173/a186);
  a143=(a031*a143);
  a143=(a143*a176);
  a143=(a143/a026);
  a173=(a189*a173);
  a143=(a143+a173);
  a143=(a143/a188);
  a189=(a189*a143);
  a186=(a186+a189);
  a189=(a186*a113);
  a160=(a160-a189);
  a163=(a163+a160);
  a160=(a172*a163);
  a136=(a136+a160);
  a136=(a265+a136);
  a160=(a158*a136);
  a252=(a252+a160);
  a160=(a191*a018);
  a189=(a193*a011);
  a160=(a160+a189);
  a189=(a194*a035);
  a160=(a160+a189);
  a189=(a195*a116);
  a160=(a160+a189);
  a189=(a196*a139);
  a160=(a160+a189);
  a189=(a197*a163);
  a160=(a160+a189);
  a205=(a017*a205);
  a207=(a014*a207);
  a205=(a205+a207);
  a207=(a007*a205);
  a204=cos(a204);
  a189=(a007*a204);
  a207=(a207-a189);
  a188=(a205*a023);
  a207=(a207+a188);
  a205=(2.*a205);
  a207=(a207+a205);
  a207=(a207/a026);
  a205=(a207/a212);
  a189=(a189/a026);
  a207=(a215*a207);
  a189=(a189-a207);
  a189=(a189/a214);
  a207=(a215*a189);
  a205=(a205-a207);
  a207=(a166*a265);
  a188=(a168*a097);
  a207=(a207+a188);
  a188=(a169*a117);
  a207=(a207+a188);
  a188=(a170*a022);
  a207=(a207+a188);
  a188=(a171*a093);
  a207=(a207+a188);
  a188=(a172*a113);
  a207=(a207+a188);
  a207=(a009+a207);
  a188=(a205*a207);
  a208=(a208-a210);
  a210=(a007*a202);
  a203=(a199*a203);
  a210=(a210*a203);
  a208=(a208+a210);
  a206=(a206*a023);
  a208=(a208+a206);
  a208=(a208+a211);
  a208=(a208/a026);
  a211=(a215*a208);
  a216=(a216+a211);
  a216=(a216/a214);
  a211=(a216*a202);
  a208=(a208/a212);
  a216=(a215*a216);
  a208=(a208+a216);
  a216=(-a208);
  a216=(2.*a216);
  a216=(a216*a202);
  a211=(a211-a216);
  a211=(a211+a204);
  a203=(a201*a203);
  a211=(a211-a203);
  a211=(a037*a211);
  a203=(a211/a212);
  a201=(a201*a167);
  a201=(a201*a167);
  a208=(a208*a202);
  a208=(a208+a204);
  a201=(a201-a208);
  a201=(a037*a201);
  a211=(a215*a211);
  a201=(a201-a211);
  a201=(a201/a214);
  a211=(a215*a201);
  a203=(a203-a211);
  a211=(a166*a016);
  a208=(a168*a086);
  a211=(a211+a208);
  a208=(a169*a106);
  a211=(a211+a208);
  a208=(a170*a141);
  a211=(a211+a208);
  a208=(a171*a165);
  a211=(a211+a208);
  a208=(a172*a190);
  a211=(a211+a208);
  a211=(a024+a211);
  a208=(a203*a211);
  a188=(a188+a208);
  a208=(a202*a019);
  a204=(a199-a167);
  a208=(a208*a204);
  a204=(a208/a212);
  a208=(a215*a208);
  a208=(a208/a214);
  a216=(a215*a208);
  a204=(a204+a216);
  a216=(a166*a066);
  a206=(a168*a089);
  a216=(a216+a206);
  a206=(a169*a109);
  a216=(a216+a206);
  a206=(a170*a132);
  a216=(a216+a206);
  a206=(a171*a156);
  a216=(a216+a206);
  a181=(a164*a181);
  a185=(a175*a185);
  a181=(a181+a185);
  a185=(a143*a113);
  a206=(a182*a190);
  a185=(a185-a206);
  a181=(a181+a185);
  a185=(a172*a181);
  a216=(a216+a185);
  a216=(a016+a216);
  a185=(a204*a216);
  a199=(a199*a202);
  a199=(a199*a019);
  a212=(a199/a212);
  a167=(a031*a167);
  a167=(a167*a202);
  a167=(a167/a026);
  a199=(a215*a199);
  a167=(a167+a199);
  a167=(a167/a214);
  a215=(a215*a167);
  a212=(a212+a215);
  a215=(a212*a136);
  a185=(a185-a215);
  a188=(a188+a185);
  a185=(a198*a188);
  a160=(a160+a185);
  a160=(a265+a160);
  a185=(a183*a160);
  a252=(a252+a185);
  a185=(a217*a018);
  a215=(a219*a011);
  a185=(a185+a215);
  a215=(a220*a035);
  a185=(a185+a215);
  a215=(a221*a116);
  a185=(a185+a215);
  a215=(a222*a139);
  a185=(a185+a215);
  a215=(a223*a163);
  a185=(a185+a215);
  a215=(a224*a188);
  a185=(a185+a215);
  a232=(a017*a232);
  a234=(a014*a234);
  a232=(a232+a234);
  a234=(a007*a232);
  a231=cos(a231);
  a215=(a007*a231);
  a234=(a234-a215);
  a214=(a232*a023);
  a234=(a234+a214);
  a232=(2.*a232);
  a234=(a234+a232);
  a234=(a234/a026);
  a232=(a234/a239);
  a215=(a215/a026);
  a234=(a242*a234);
  a215=(a215-a234);
  a215=(a215/a241);
  a234=(a242*a215);
  a232=(a232-a234);
  a234=(a191*a265);
  a214=(a193*a097);
  a234=(a234+a214);
  a214=(a194*a117);
  a234=(a234+a214);
  a214=(a195*a022);
  a234=(a234+a214);
  a214=(a196*a093);
  a234=(a234+a214);
  a214=(a197*a113);
  a234=(a234+a214);
  a214=(a198*a136);
  a234=(a234+a214);
  a234=(a009+a234);
  a214=(a232*a234);
  a235=(a235-a237);
  a237=(a007*a229);
  a230=(a226*a230);
  a237=(a237*a230);
  a235=(a235+a237);
  a233=(a233*a023);
  a235=(a235+a233);
  a235=(a235+a238);
  a235=(a235/a026);
  a238=(a242*a235);
  a243=(a243+a238);
  a243=(a243/a241);
  a238=(a243*a229);
  a235=(a235/a239);
  a243=(a242*a243);
  a235=(a235+a243);
  a243=(-a235);
  a243=(2.*a243);
  a243=(a243*a229);
  a238=(a238-a243);
  a238=(a238+a231);
  a230=(a228*a230);
  a238=(a238-a230);
  a238=(a037*a238);
  a230=(a238/a239);
  a228=(a228*a192);
  a228=(a228*a192);
  a235=(a235*a229);
  a235=(a235+a231);
  a228=(a228-a235);
  a228=(a037*a228);
  a238=(a242*a238);
  a228=(a228-a238);
  a228=(a228/a241);
  a238=(a242*a228);
  a230=(a230-a238);
  a238=(a191*a016);
  a235=(a193*a086);
  a238=(a238+a235);
  a235=(a194*a106);
  a238=(a238+a235);
  a235=(a195*a141);
  a238=(a238+a235);
  a235=(a196*a165);
  a238=(a238+a235);
  a235=(a197*a190);
  a238=(a238+a235);
  a235=(a198*a216);
  a238=(a238+a235);
  a238=(a024+a238);
  a235=(a230*a238);
  a214=(a214+a235);
  a235=(a229*a019);
  a231=(a226-a192);
  a235=(a235*a231);
  a231=(a235/a239);
  a235=(a242*a235);
  a235=(a235/a241);
  a243=(a242*a235);
  a231=(a231+a243);
  a243=(a191*a066);
  a233=(a193*a089);
  a243=(a243+a233);
  a233=(a194*a109);
  a243=(a243+a233);
  a233=(a195*a132);
  a243=(a243+a233);
  a233=(a196*a156);
  a243=(a243+a233);
  a233=(a197*a181);
  a243=(a243+a233);
  a207=(a189*a207);
  a211=(a201*a211);
  a207=(a207+a211);
  a211=(a167*a136);
  a233=(a208*a216);
  a211=(a211-a233);
  a207=(a207+a211);
  a211=(a198*a207);
  a243=(a243+a211);
  a243=(a016+a243);
  a211=(a231*a243);
  a226=(a226*a229);
  a226=(a226*a019);
  a239=(a226/a239);
  a192=(a031*a192);
  a192=(a192*a229);
  a192=(a192/a026);
  a226=(a242*a226);
  a192=(a192+a226);
  a192=(a192/a241);
  a242=(a242*a192);
  a239=(a239+a242);
  a242=(a239*a160);
  a211=(a211-a242);
  a214=(a214+a211);
  a211=(a225*a214);
  a185=(a185+a211);
  a185=(a265+a185);
  a211=(a209*a185);
  a252=(a252+a211);
  a211=(a244*a018);
  a011=(a246*a011);
  a211=(a211+a011);
  a035=(a095*a035);
  a211=(a211+a035);
  a035=(a115*a116);
  a211=(a211+a035);
  a035=(a247*a139);
  a211=(a211+a035);
  a035=(a248*a163);
  a211=(a211+a035);
  a035=(a249*a188);
  a211=(a211+a035);
  a035=(a250*a214);
  a211=(a211+a035);
  a257=(a017*a257);
  a259=(a014*a259);
  a257=(a257+a259);
  a259=(a007*a257);
  a256=cos(a256);
  a035=(a007*a256);
  a259=(a259-a035);
  a011=(a257*a023);
  a259=(a259+a011);
  a257=(2.*a257);
  a259=(a259+a257);
  a259=(a259/a026);
  a257=(a259/a264);
  a035=(a035/a026);
  a259=(a267*a259);
  a035=(a035-a259);
  a035=(a035/a266);
  a259=(a267*a035);
  a257=(a257-a259);
  a259=(a217*a265);
  a011=(a219*a097);
  a259=(a259+a011);
  a011=(a220*a117);
  a259=(a259+a011);
  a011=(a221*a022);
  a259=(a259+a011);
  a011=(a222*a093);
  a259=(a259+a011);
  a011=(a223*a113);
  a259=(a259+a011);
  a011=(a224*a136);
  a259=(a259+a011);
  a011=(a225*a160);
  a259=(a259+a011);
  a259=(a009+a259);
  a011=(a257*a259);
  a260=(a260-a262);
  a262=(a007*a254);
  a255=(a002*a255);
  a262=(a262*a255);
  a260=(a260+a262);
  a258=(a258*a023);
  a260=(a260+a258);
  a260=(a260+a263);
  a260=(a260/a026);
  a263=(a267*a260);
  a268=(a268+a263);
  a268=(a268/a266);
  a263=(a268*a254);
  a260=(a260/a264);
  a268=(a267*a268);
  a260=(a260+a268);
  a268=(-a260);
  a268=(2.*a268);
  a268=(a268*a254);
  a263=(a263-a268);
  a263=(a263+a256);
  a255=(a253*a255);
  a263=(a263-a255);
  a263=(a037*a263);
  a255=(a263/a264);
  a253=(a253*a218);
  a253=(a253*a218);
  a260=(a260*a254);
  a260=(a260+a256);
  a253=(a253-a260);
  a253=(a037*a253);
  a263=(a267*a263);
  a253=(a253-a263);
  a253=(a253/a266);
  a263=(a267*a253);
  a255=(a255-a263);
  a263=(a217*a016);
  a260=(a219*a086);
  a263=(a263+a260);
  a260=(a220*a106);
  a263=(a263+a260);
  a260=(a221*a141);
  a263=(a263+a260);
  a260=(a222*a165);
  a263=(a263+a260);
  a260=(a223*a190);
  a263=(a263+a260);
  a260=(a224*a216);
  a263=(a263+a260);
  a260=(a225*a243);
  a263=(a263+a260);
  a263=(a024+a263);
  a260=(a255*a263);
  a011=(a011+a260);
  a260=(a254*a019);
  a256=(a002-a218);
  a260=(a260*a256);
  a256=(a260/a264);
  a260=(a267*a260);
  a260=(a260/a266);
  a268=(a267*a260);
  a256=(a256+a268);
  a268=(a217*a066);
  a258=(a219*a089);
  a268=(a268+a258);
  a258=(a220*a109);
  a268=(a268+a258);
  a258=(a221*a132);
  a268=(a268+a258);
  a258=(a222*a156);
  a268=(a268+a258);
  a258=(a223*a181);
  a268=(a268+a258);
  a258=(a224*a207);
  a268=(a268+a258);
  a234=(a215*a234);
  a238=(a228*a238);
  a234=(a234+a238);
  a238=(a192*a160);
  a258=(a235*a243);
  a238=(a238-a258);
  a234=(a234+a238);
  a238=(a225*a234);
  a268=(a268+a238);
  a268=(a016+a268);
  a238=(a256*a268);
  a002=(a002*a254);
  a002=(a002*a019);
  a264=(a002/a264);
  a218=(a031*a218);
  a218=(a218*a254);
  a218=(a218/a026);
  a002=(a267*a002);
  a218=(a218+a002);
  a218=(a218/a266);
  a267=(a267*a218);
  a264=(a264+a267);
  a267=(a264*a185);
  a238=(a238-a267);
  a011=(a011+a238);
  a238=(a251*a011);
  a211=(a211+a238);
  a211=(a265+a211);
  a238=(a236*a211);
  a252=(a252+a238);
  a252=(a009+a252);
  if (res[0]!=0) res[0][4]=a252;
  a252=(a001*a016);
  a238=(a005*a141);
  a252=(a252+a238);
  a238=(a111*a165);
  a252=(a252+a238);
  a238=(a134*a190);
  a252=(a252+a238);
  a238=(a158*a216);
  a252=(a252+a238);
  a238=(a183*a243);
  a252=(a252+a238);
  a238=(a209*a268);
  a252=(a252+a238);
  a238=(a244*a066);
  a089=(a246*a089);
  a238=(a238+a089);
  a109=(a095*a109);
  a238=(a238+a109);
  a109=(a115*a132);
  a238=(a238+a109);
  a109=(a247*a156);
  a238=(a238+a109);
  a109=(a248*a181);
  a238=(a238+a109);
  a109=(a249*a207);
  a238=(a238+a109);
  a109=(a250*a234);
  a238=(a238+a109);
  a259=(a035*a259);
  a263=(a253*a263);
  a259=(a259+a263);
  a263=(a218*a185);
  a109=(a260*a268);
  a263=(a263-a109);
  a259=(a259+a263);
  a263=(a251*a259);
  a238=(a238+a263);
  a238=(a016+a238);
  a263=(a236*a238);
  a252=(a252+a263);
  a252=(a024+a252);
  if (res[0]!=0) res[0][5]=a252;
  a018=(a001*a018);
  a116=(a005*a116);
  a018=(a018+a116);
  a139=(a111*a139);
  a018=(a018+a139);
  a163=(a134*a163);
  a018=(a018+a163);
  a188=(a158*a188);
  a018=(a018+a188);
  a214=(a183*a214);
  a018=(a018+a214);
  a011=(a209*a011);
  a018=(a018+a011);
  a017=(a017*a187);
  a014=(a014*a138);
  a017=(a017+a014);
  a014=(a007*a017);
  a013=cos(a013);
  a138=(a007*a013);
  a014=(a014-a138);
  a187=(a017*a023);
  a014=(a014+a187);
  a017=(2.*a017);
  a014=(a014+a017);
  a014=(a014/a026);
  a017=(a014/a027);
  a138=(a138/a026);
  a014=(a025*a014);
  a138=(a138-a014);
  a138=(a138/a021);
  a014=(a025*a138);
  a017=(a017-a014);
  a014=(a244*a265);
  a097=(a246*a097);
  a014=(a014+a097);
  a117=(a095*a117);
  a014=(a014+a117);
  a022=(a115*a022);
  a014=(a014+a022);
  a093=(a247*a093);
  a014=(a014+a093);
  a113=(a248*a113);
  a014=(a014+a113);
  a136=(a249*a136);
  a014=(a014+a136);
  a160=(a250*a160);
  a014=(a014+a160);
  a185=(a251*a185);
  a014=(a014+a185);
  a009=(a009+a014);
  a014=(a017*a009);
  a004=(a004-a102);
  a007=(a007*a240);
  a213=(a261*a213);
  a007=(a007*a213);
  a004=(a004+a007);
  a162=(a162*a023);
  a004=(a004+a162);
  a004=(a004+a081);
  a004=(a004/a026);
  a081=(a025*a004);
  a030=(a030+a081);
  a030=(a030/a021);
  a081=(a030*a240);
  a004=(a004/a027);
  a030=(a025*a030);
  a004=(a004+a030);
  a030=(-a004);
  a030=(2.*a030);
  a030=(a030*a240);
  a081=(a081-a030);
  a081=(a081+a013);
  a213=(a010*a213);
  a081=(a081-a213);
  a081=(a037*a081);
  a213=(a081/a027);
  a010=(a010*a245);
  a010=(a010*a245);
  a004=(a004*a240);
  a004=(a004+a013);
  a010=(a010-a004);
  a037=(a037*a010);
  a081=(a025*a081);
  a037=(a037-a081);
  a037=(a037/a021);
  a081=(a025*a037);
  a213=(a213-a081);
  a081=(a244*a016);
  a086=(a246*a086);
  a081=(a081+a086);
  a106=(a095*a106);
  a081=(a081+a106);
  a141=(a115*a141);
  a081=(a081+a141);
  a165=(a247*a165);
  a081=(a081+a165);
  a190=(a248*a190);
  a081=(a081+a190);
  a216=(a249*a216);
  a081=(a081+a216);
  a243=(a250*a243);
  a081=(a081+a243);
  a268=(a251*a268);
  a081=(a081+a268);
  a024=(a024+a081);
  a081=(a213*a024);
  a014=(a014+a081);
  a081=(a240*a019);
  a268=(a261-a245);
  a081=(a081*a268);
  a268=(a081/a027);
  a081=(a025*a081);
  a081=(a081/a021);
  a243=(a025*a081);
  a268=(a268+a243);
  a243=(a268*a238);
  a261=(a261*a240);
  a261=(a261*a019);
  a027=(a261/a027);
  a031=(a031*a245);
  a031=(a031*a240);
  a031=(a031/a026);
  a261=(a025*a261);
  a031=(a031+a261);
  a031=(a031/a021);
  a025=(a025*a031);
  a027=(a027+a025);
  a025=(a027*a211);
  a243=(a243-a025);
  a014=(a014+a243);
  a014=(a236*a014);
  a018=(a018+a014);
  a265=(a265+a018);
  if (res[0]!=0) res[0][6]=a265;
  a066=(a001*a066);
  a132=(a005*a132);
  a066=(a066+a132);
  a156=(a111*a156);
  a066=(a066+a156);
  a181=(a134*a181);
  a066=(a066+a181);
  a207=(a158*a207);
  a066=(a066+a207);
  a234=(a183*a234);
  a066=(a066+a234);
  a259=(a209*a259);
  a066=(a066+a259);
  a009=(a138*a009);
  a024=(a037*a024);
  a009=(a009+a024);
  a211=(a031*a211);
  a238=(a081*a238);
  a211=(a211-a238);
  a009=(a009+a211);
  a009=(a236*a009);
  a066=(a066+a009);
  a016=(a016+a066);
  if (res[0]!=0) res[0][7]=a016;
  a016=arg[0]? arg[0][8] : 0;
  a066=arg[0]? arg[0][10] : 0;
  a009=(a001*a066);
  a211=(a015*a016);
  a238=arg[0]? arg[0][9] : 0;
  a024=(a012*a238);
  a211=(a211+a024);
  a024=arg[0]? arg[0][11] : 0;
  a259=(a038*a024);
  a234=(a029*a066);
  a259=(a259-a234);
  a211=(a211+a259);
  a259=(a006*a211);
  a234=(a041*a066);
  a207=(a044*a211);
  a181=(a047*a066);
  a181=(a016+a181);
  a156=(a055*a181);
  a132=(a047*a024);
  a132=(a238+a132);
  a265=(a053*a132);
  a156=(a156+a265);
  a265=(a227*a016);
  a018=(a028*a238);
  a265=(a265+a018);
  a018=(a003*a066);
  a014=(a020*a024);
  a018=(a018-a014);
  a265=(a265+a018);
  a018=(a047*a265);
  a018=(a024+a018);
  a014=(a054*a018);
  a243=(a047*a211);
  a243=(a066+a243);
  a025=(a062*a243);
  a014=(a014-a025);
  a156=(a156+a014);
  a156=(a046*a156);
  a207=(a207+a156);
  a207=(a066+a207);
  a156=(a043*a207);
  a234=(a234+a156);
  a234=(a016+a234);
  a156=(a087*a234);
  a014=(a041*a024);
  a025=(a044*a265);
  a181=(a008*a181);
  a132=(a050*a132);
  a181=(a181+a132);
  a132=(a052*a243);
  a021=(a058*a018);
  a132=(a132-a021);
  a181=(a181+a132);
  a181=(a046*a181);
  a025=(a025+a181);
  a025=(a024+a025);
  a181=(a043*a025);
  a014=(a014+a181);
  a014=(a238+a014);
  a181=(a085*a014);
  a156=(a156+a181);
  a181=(a041*a265);
  a132=(a044*a066);
  a243=(a046*a243);
  a132=(a132+a243);
  a132=(a016+a132);
  a243=(a088*a132);
  a021=(a044*a024);
  a018=(a046*a018);
  a021=(a021+a018);
  a021=(a238+a021);
  a018=(a098*a021);
  a243=(a243+a018);
  a018=(a056*a207);
  a261=(a074*a025);
  a018=(a018-a261);
  a243=(a243+a018);
  a018=(a043*a243);
  a181=(a181+a018);
  a181=(a024+a181);
  a018=(a061*a181);
  a261=(a041*a211);
  a132=(a068*a132);
  a021=(a063*a021);
  a132=(a132+a021);
  a021=(a067*a025);
  a026=(a075*a207);
  a021=(a021-a026);
  a132=(a132+a021);
  a021=(a043*a132);
  a261=(a261+a021);
  a261=(a066+a261);
  a021=(a094*a261);
  a018=(a018-a021);
  a156=(a156+a018);
  a018=(a040*a156);
  a259=(a259+a018);
  a018=(a099*a066);
  a207=(a101*a207);
  a018=(a018+a207);
  a207=(a080*a261);
  a018=(a018+a207);
  a018=(a016+a018);
  a207=(a107*a018);
  a021=(a099*a024);
  a025=(a101*a025);
  a021=(a021+a025);
  a025=(a080*a181);
  a021=(a021+a025);
  a021=(a238+a021);
  a025=(a049*a021);
  a207=(a207+a025);
  a025=(a099*a265);
  a243=(a101*a243);
  a025=(a025+a243);
  a234=(a036*a234);
  a014=(a082*a014);
  a234=(a234+a014);
  a014=(a084*a261);
  a243=(a057*a181);
  a014=(a014-a243);
  a234=(a234+a014);
  a014=(a080*a234);
  a025=(a025+a014);
  a025=(a024+a025);
  a014=(a110*a025);
  a243=(a099*a211);
  a132=(a101*a132);
  a243=(a243+a132);
  a132=(a080*a156);
  a243=(a243+a132);
  a243=(a066+a243);
  a132=(a114*a243);
  a014=(a014-a132);
  a207=(a207+a014);
  a014=(a091*a207);
  a259=(a259+a014);
  a259=(a066+a259);
  a014=(a005*a259);
  a009=(a009+a014);
  a014=(a119*a211);
  a132=(a121*a156);
  a014=(a014+a132);
  a132=(a122*a207);
  a014=(a014+a132);
  a132=(a006*a066);
  a026=(a040*a261);
  a132=(a132+a026);
  a026=(a091*a243);
  a132=(a132+a026);
  a132=(a016+a132);
  a026=(a130*a132);
  a240=(a006*a024);
  a245=(a040*a181);
  a240=(a240+a245);
  a245=(a091*a025);
  a240=(a240+a245);
  a240=(a238+a240);
  a245=(a128*a240);
  a026=(a026+a245);
  a245=(a006*a265);
  a019=(a040*a234);
  a245=(a245+a019);
  a018=(a069*a018);
  a021=(a103*a021);
  a018=(a018+a021);
  a021=(a105*a243);
  a019=(a090*a025);
  a021=(a021-a019);
  a018=(a018+a021);
  a021=(a091*a018);
  a245=(a245+a021);
  a245=(a024+a245);
  a021=(a129*a245);
  a019=(a137*a259);
  a021=(a021-a019);
  a026=(a026+a021);
  a021=(a123*a026);
  a014=(a014+a021);
  a014=(a066+a014);
  a021=(a111*a014);
  a009=(a009+a021);
  a021=(a142*a211);
  a019=(a144*a156);
  a021=(a021+a019);
  a019=(a145*a207);
  a021=(a021+a019);
  a019=(a146*a026);
  a021=(a021+a019);
  a019=(a119*a066);
  a216=(a121*a261);
  a019=(a019+a216);
  a216=(a122*a243);
  a019=(a019+a216);
  a216=(a123*a259);
  a019=(a019+a216);
  a019=(a016+a019);
  a216=(a154*a019);
  a190=(a119*a024);
  a165=(a121*a181);
  a190=(a190+a165);
  a165=(a122*a025);
  a190=(a190+a165);
  a165=(a123*a245);
  a190=(a190+a165);
  a190=(a238+a190);
  a165=(a152*a190);
  a216=(a216+a165);
  a165=(a119*a265);
  a141=(a121*a234);
  a165=(a165+a141);
  a141=(a122*a018);
  a165=(a165+a141);
  a132=(a076*a132);
  a240=(a126*a240);
  a132=(a132+a240);
  a240=(a039*a259);
  a141=(a133*a245);
  a240=(a240-a141);
  a132=(a132+a240);
  a240=(a123*a132);
  a165=(a165+a240);
  a165=(a024+a165);
  a240=(a153*a165);
  a141=(a161*a014);
  a240=(a240-a141);
  a216=(a216+a240);
  a240=(a147*a216);
  a021=(a021+a240);
  a021=(a066+a021);
  a240=(a134*a021);
  a009=(a009+a240);
  a240=(a166*a211);
  a141=(a168*a156);
  a240=(a240+a141);
  a141=(a169*a207);
  a240=(a240+a141);
  a141=(a170*a026);
  a240=(a240+a141);
  a141=(a171*a216);
  a240=(a240+a141);
  a141=(a142*a066);
  a106=(a144*a261);
  a141=(a141+a106);
  a106=(a145*a243);
  a141=(a141+a106);
  a106=(a146*a259);
  a141=(a141+a106);
  a106=(a147*a014);
  a141=(a141+a106);
  a141=(a016+a141);
  a106=(a179*a141);
  a086=(a142*a024);
  a010=(a144*a181);
  a086=(a086+a010);
  a010=(a145*a025);
  a086=(a086+a010);
  a010=(a146*a245);
  a086=(a086+a010);
  a010=(a147*a165);
  a086=(a086+a010);
  a086=(a238+a086);
  a010=(a177*a086);
  a106=(a106+a010);
  a010=(a142*a265);
  a004=(a144*a234);
  a010=(a010+a004);
  a004=(a145*a018);
  a010=(a010+a004);
  a004=(a146*a132);
  a010=(a010+a004);
  a019=(a140*a019);
  a190=(a150*a190);
  a019=(a019+a190);
  a190=(a120*a014);
  a004=(a157*a165);
  a190=(a190-a004);
  a019=(a019+a190);
  a190=(a147*a019);
  a010=(a010+a190);
  a010=(a024+a010);
  a190=(a178*a010);
  a004=(a186*a021);
  a190=(a190-a004);
  a106=(a106+a190);
  a190=(a172*a106);
  a240=(a240+a190);
  a240=(a066+a240);
  a190=(a158*a240);
  a009=(a009+a190);
  a190=(a191*a211);
  a004=(a193*a156);
  a190=(a190+a004);
  a004=(a194*a207);
  a190=(a190+a004);
  a004=(a195*a026);
  a190=(a190+a004);
  a004=(a196*a216);
  a190=(a190+a004);
  a004=(a197*a106);
  a190=(a190+a004);
  a004=(a166*a066);
  a013=(a168*a261);
  a004=(a004+a013);
  a013=(a169*a243);
  a004=(a004+a013);
  a013=(a170*a259);
  a004=(a004+a013);
  a013=(a171*a014);
  a004=(a004+a013);
  a013=(a172*a021);
  a004=(a004+a013);
  a004=(a016+a004);
  a013=(a205*a004);
  a030=(a166*a024);
  a162=(a168*a181);
  a030=(a030+a162);
  a162=(a169*a025);
  a030=(a030+a162);
  a162=(a170*a245);
  a030=(a030+a162);
  a162=(a171*a165);
  a030=(a030+a162);
  a162=(a172*a010);
  a030=(a030+a162);
  a030=(a238+a030);
  a162=(a203*a030);
  a013=(a013+a162);
  a162=(a166*a265);
  a023=(a168*a234);
  a162=(a162+a023);
  a023=(a169*a018);
  a162=(a162+a023);
  a023=(a170*a132);
  a162=(a162+a023);
  a023=(a171*a019);
  a162=(a162+a023);
  a141=(a164*a141);
  a086=(a175*a086);
  a141=(a141+a086);
  a086=(a143*a021);
  a023=(a182*a010);
  a086=(a086-a023);
  a141=(a141+a086);
  a086=(a172*a141);
  a162=(a162+a086);
  a162=(a024+a162);
  a086=(a204*a162);
  a023=(a212*a240);
  a086=(a086-a023);
  a013=(a013+a086);
  a086=(a198*a013);
  a190=(a190+a086);
  a190=(a066+a190);
  a086=(a183*a190);
  a009=(a009+a086);
  a086=(a217*a211);
  a023=(a219*a156);
  a086=(a086+a023);
  a023=(a220*a207);
  a086=(a086+a023);
  a023=(a221*a026);
  a086=(a086+a023);
  a023=(a222*a216);
  a086=(a086+a023);
  a023=(a223*a106);
  a086=(a086+a023);
  a023=(a224*a013);
  a086=(a086+a023);
  a023=(a191*a066);
  a007=(a193*a261);
  a023=(a023+a007);
  a007=(a194*a243);
  a023=(a023+a007);
  a007=(a195*a259);
  a023=(a023+a007);
  a007=(a196*a014);
  a023=(a023+a007);
  a007=(a197*a021);
  a023=(a023+a007);
  a007=(a198*a240);
  a023=(a023+a007);
  a023=(a016+a023);
  a007=(a232*a023);
  a102=(a191*a024);
  a185=(a193*a181);
  a102=(a102+a185);
  a185=(a194*a025);
  a102=(a102+a185);
  a185=(a195*a245);
  a102=(a102+a185);
  a185=(a196*a165);
  a102=(a102+a185);
  a185=(a197*a010);
  a102=(a102+a185);
  a185=(a198*a162);
  a102=(a102+a185);
  a102=(a238+a102);
  a185=(a230*a102);
  a007=(a007+a185);
  a185=(a191*a265);
  a160=(a193*a234);
  a185=(a185+a160);
  a160=(a194*a018);
  a185=(a185+a160);
  a160=(a195*a132);
  a185=(a185+a160);
  a160=(a196*a019);
  a185=(a185+a160);
  a160=(a197*a141);
  a185=(a185+a160);
  a004=(a189*a004);
  a030=(a201*a030);
  a004=(a004+a030);
  a030=(a167*a240);
  a160=(a208*a162);
  a030=(a030-a160);
  a004=(a004+a030);
  a030=(a198*a004);
  a185=(a185+a030);
  a185=(a024+a185);
  a030=(a231*a185);
  a160=(a239*a190);
  a030=(a030-a160);
  a007=(a007+a030);
  a030=(a225*a007);
  a086=(a086+a030);
  a086=(a066+a086);
  a030=(a209*a086);
  a009=(a009+a030);
  a030=(a244*a211);
  a156=(a246*a156);
  a030=(a030+a156);
  a207=(a095*a207);
  a030=(a030+a207);
  a207=(a115*a026);
  a030=(a030+a207);
  a207=(a247*a216);
  a030=(a030+a207);
  a207=(a248*a106);
  a030=(a030+a207);
  a207=(a249*a013);
  a030=(a030+a207);
  a207=(a250*a007);
  a030=(a030+a207);
  a207=(a217*a066);
  a156=(a219*a261);
  a207=(a207+a156);
  a156=(a220*a243);
  a207=(a207+a156);
  a156=(a221*a259);
  a207=(a207+a156);
  a156=(a222*a014);
  a207=(a207+a156);
  a156=(a223*a021);
  a207=(a207+a156);
  a156=(a224*a240);
  a207=(a207+a156);
  a156=(a225*a190);
  a207=(a207+a156);
  a207=(a016+a207);
  a156=(a257*a207);
  a160=(a217*a024);
  a136=(a219*a181);
  a160=(a160+a136);
  a136=(a220*a025);
  a160=(a160+a136);
  a136=(a221*a245);
  a160=(a160+a136);
  a136=(a222*a165);
  a160=(a160+a136);
  a136=(a223*a010);
  a160=(a160+a136);
  a136=(a224*a162);
  a160=(a160+a136);
  a136=(a225*a185);
  a160=(a160+a136);
  a160=(a238+a160);
  a136=(a255*a160);
  a156=(a156+a136);
  a136=(a217*a265);
  a113=(a219*a234);
  a136=(a136+a113);
  a113=(a220*a018);
  a136=(a136+a113);
  a113=(a221*a132);
  a136=(a136+a113);
  a113=(a222*a019);
  a136=(a136+a113);
  a113=(a223*a141);
  a136=(a136+a113);
  a113=(a224*a004);
  a136=(a136+a113);
  a023=(a215*a023);
  a102=(a228*a102);
  a023=(a023+a102);
  a102=(a192*a190);
  a113=(a235*a185);
  a102=(a102-a113);
  a023=(a023+a102);
  a102=(a225*a023);
  a136=(a136+a102);
  a136=(a024+a136);
  a102=(a256*a136);
  a113=(a264*a086);
  a102=(a102-a113);
  a156=(a156+a102);
  a102=(a251*a156);
  a030=(a030+a102);
  a030=(a066+a030);
  a102=(a236*a030);
  a009=(a009+a102);
  a009=(a016+a009);
  if (res[0]!=0) res[0][8]=a009;
  a009=(a001*a024);
  a102=(a005*a245);
  a009=(a009+a102);
  a102=(a111*a165);
  a009=(a009+a102);
  a102=(a134*a010);
  a009=(a009+a102);
  a102=(a158*a162);
  a009=(a009+a102);
  a102=(a183*a185);
  a009=(a009+a102);
  a102=(a209*a136);
  a009=(a009+a102);
  a102=(a244*a265);
  a234=(a246*a234);
  a102=(a102+a234);
  a018=(a095*a018);
  a102=(a102+a018);
  a018=(a115*a132);
  a102=(a102+a018);
  a018=(a247*a019);
  a102=(a102+a018);
  a018=(a248*a141);
  a102=(a102+a018);
  a018=(a249*a004);
  a102=(a102+a018);
  a018=(a250*a023);
  a102=(a102+a018);
  a207=(a035*a207);
  a160=(a253*a160);
  a207=(a207+a160);
  a160=(a218*a086);
  a018=(a260*a136);
  a160=(a160-a018);
  a207=(a207+a160);
  a160=(a251*a207);
  a102=(a102+a160);
  a102=(a024+a102);
  a160=(a236*a102);
  a009=(a009+a160);
  a009=(a238+a009);
  if (res[0]!=0) res[0][9]=a009;
  a211=(a001*a211);
  a026=(a005*a026);
  a211=(a211+a026);
  a216=(a111*a216);
  a211=(a211+a216);
  a106=(a134*a106);
  a211=(a211+a106);
  a013=(a158*a013);
  a211=(a211+a013);
  a007=(a183*a007);
  a211=(a211+a007);
  a156=(a209*a156);
  a211=(a211+a156);
  a156=(a244*a066);
  a261=(a246*a261);
  a156=(a156+a261);
  a243=(a095*a243);
  a156=(a156+a243);
  a259=(a115*a259);
  a156=(a156+a259);
  a014=(a247*a014);
  a156=(a156+a014);
  a021=(a248*a021);
  a156=(a156+a021);
  a240=(a249*a240);
  a156=(a156+a240);
  a190=(a250*a190);
  a156=(a156+a190);
  a086=(a251*a086);
  a156=(a156+a086);
  a016=(a016+a156);
  a156=(a017*a016);
  a086=(a244*a024);
  a181=(a246*a181);
  a086=(a086+a181);
  a025=(a095*a025);
  a086=(a086+a025);
  a245=(a115*a245);
  a086=(a086+a245);
  a165=(a247*a165);
  a086=(a086+a165);
  a010=(a248*a010);
  a086=(a086+a010);
  a162=(a249*a162);
  a086=(a086+a162);
  a185=(a250*a185);
  a086=(a086+a185);
  a136=(a251*a136);
  a086=(a086+a136);
  a238=(a238+a086);
  a086=(a213*a238);
  a156=(a156+a086);
  a086=(a268*a102);
  a136=(a027*a030);
  a086=(a086-a136);
  a156=(a156+a086);
  a156=(a236*a156);
  a211=(a211+a156);
  a066=(a066+a211);
  if (res[0]!=0) res[0][10]=a066;
  a265=(a001*a265);
  a132=(a005*a132);
  a265=(a265+a132);
  a019=(a111*a019);
  a265=(a265+a019);
  a141=(a134*a141);
  a265=(a265+a141);
  a004=(a158*a004);
  a265=(a265+a004);
  a023=(a183*a023);
  a265=(a265+a023);
  a207=(a209*a207);
  a265=(a265+a207);
  a016=(a138*a016);
  a238=(a037*a238);
  a016=(a016+a238);
  a030=(a031*a030);
  a102=(a081*a102);
  a030=(a030-a102);
  a016=(a016+a030);
  a016=(a236*a016);
  a265=(a265+a016);
  a024=(a024+a265);
  if (res[0]!=0) res[0][11]=a024;
  a024=arg[0]? arg[0][12] : 0;
  a265=arg[0]? arg[0][14] : 0;
  a016=(a001*a265);
  a015=(a015*a024);
  a030=arg[0]? arg[0][13] : 0;
  a012=(a012*a030);
  a015=(a015+a012);
  a012=arg[0]? arg[0][15] : 0;
  a038=(a038*a012);
  a029=(a029*a265);
  a038=(a038-a029);
  a015=(a015+a038);
  a038=(a006*a015);
  a029=(a041*a265);
  a102=(a044*a015);
  a238=(a047*a265);
  a238=(a024+a238);
  a055=(a055*a238);
  a207=(a047*a012);
  a207=(a030+a207);
  a053=(a053*a207);
  a055=(a055+a053);
  a227=(a227*a024);
  a028=(a028*a030);
  a227=(a227+a028);
  a003=(a003*a265);
  a020=(a020*a012);
  a003=(a003-a020);
  a227=(a227+a003);
  a003=(a047*a227);
  a003=(a012+a003);
  a054=(a054*a003);
  a047=(a047*a015);
  a047=(a265+a047);
  a062=(a062*a047);
  a054=(a054-a062);
  a055=(a055+a054);
  a055=(a046*a055);
  a102=(a102+a055);
  a102=(a265+a102);
  a055=(a043*a102);
  a029=(a029+a055);
  a029=(a024+a029);
  a087=(a087*a029);
  a055=(a041*a012);
  a054=(a044*a227);
  a008=(a008*a238);
  a050=(a050*a207);
  a008=(a008+a050);
  a052=(a052*a047);
  a058=(a058*a003);
  a052=(a052-a058);
  a008=(a008+a052);
  a008=(a046*a008);
  a054=(a054+a008);
  a054=(a012+a054);
  a008=(a043*a054);
  a055=(a055+a008);
  a055=(a030+a055);
  a085=(a085*a055);
  a087=(a087+a085);
  a085=(a041*a227);
  a008=(a044*a265);
  a047=(a046*a047);
  a008=(a008+a047);
  a008=(a024+a008);
  a088=(a088*a008);
  a044=(a044*a012);
  a046=(a046*a003);
  a044=(a044+a046);
  a044=(a030+a044);
  a098=(a098*a044);
  a088=(a088+a098);
  a056=(a056*a102);
  a074=(a074*a054);
  a056=(a056-a074);
  a088=(a088+a056);
  a056=(a043*a088);
  a085=(a085+a056);
  a085=(a012+a085);
  a061=(a061*a085);
  a041=(a041*a015);
  a068=(a068*a008);
  a063=(a063*a044);
  a068=(a068+a063);
  a067=(a067*a054);
  a075=(a075*a102);
  a067=(a067-a075);
  a068=(a068+a067);
  a043=(a043*a068);
  a041=(a041+a043);
  a041=(a265+a041);
  a094=(a094*a041);
  a061=(a061-a094);
  a087=(a087+a061);
  a061=(a040*a087);
  a038=(a038+a061);
  a061=(a099*a265);
  a102=(a101*a102);
  a061=(a061+a102);
  a102=(a080*a041);
  a061=(a061+a102);
  a061=(a024+a061);
  a107=(a107*a061);
  a102=(a099*a012);
  a054=(a101*a054);
  a102=(a102+a054);
  a054=(a080*a085);
  a102=(a102+a054);
  a102=(a030+a102);
  a049=(a049*a102);
  a107=(a107+a049);
  a049=(a099*a227);
  a088=(a101*a088);
  a049=(a049+a088);
  a036=(a036*a029);
  a082=(a082*a055);
  a036=(a036+a082);
  a084=(a084*a041);
  a057=(a057*a085);
  a084=(a084-a057);
  a036=(a036+a084);
  a084=(a080*a036);
  a049=(a049+a084);
  a049=(a012+a049);
  a110=(a110*a049);
  a099=(a099*a015);
  a101=(a101*a068);
  a099=(a099+a101);
  a080=(a080*a087);
  a099=(a099+a080);
  a099=(a265+a099);
  a114=(a114*a099);
  a110=(a110-a114);
  a107=(a107+a110);
  a110=(a091*a107);
  a038=(a038+a110);
  a038=(a265+a038);
  a110=(a005*a038);
  a016=(a016+a110);
  a110=(a119*a015);
  a114=(a121*a087);
  a110=(a110+a114);
  a114=(a122*a107);
  a110=(a110+a114);
  a114=(a006*a265);
  a080=(a040*a041);
  a114=(a114+a080);
  a080=(a091*a099);
  a114=(a114+a080);
  a114=(a024+a114);
  a130=(a130*a114);
  a080=(a006*a012);
  a101=(a040*a085);
  a080=(a080+a101);
  a101=(a091*a049);
  a080=(a080+a101);
  a080=(a030+a080);
  a128=(a128*a080);
  a130=(a130+a128);
  a006=(a006*a227);
  a040=(a040*a036);
  a006=(a006+a040);
  a069=(a069*a061);
  a103=(a103*a102);
  a069=(a069+a103);
  a105=(a105*a099);
  a090=(a090*a049);
  a105=(a105-a090);
  a069=(a069+a105);
  a091=(a091*a069);
  a006=(a006+a091);
  a006=(a012+a006);
  a129=(a129*a006);
  a137=(a137*a038);
  a129=(a129-a137);
  a130=(a130+a129);
  a129=(a123*a130);
  a110=(a110+a129);
  a110=(a265+a110);
  a129=(a111*a110);
  a016=(a016+a129);
  a129=(a142*a015);
  a137=(a144*a087);
  a129=(a129+a137);
  a137=(a145*a107);
  a129=(a129+a137);
  a137=(a146*a130);
  a129=(a129+a137);
  a137=(a119*a265);
  a091=(a121*a041);
  a137=(a137+a091);
  a091=(a122*a099);
  a137=(a137+a091);
  a091=(a123*a038);
  a137=(a137+a091);
  a137=(a024+a137);
  a154=(a154*a137);
  a091=(a119*a012);
  a105=(a121*a085);
  a091=(a091+a105);
  a105=(a122*a049);
  a091=(a091+a105);
  a105=(a123*a006);
  a091=(a091+a105);
  a091=(a030+a091);
  a152=(a152*a091);
  a154=(a154+a152);
  a119=(a119*a227);
  a121=(a121*a036);
  a119=(a119+a121);
  a122=(a122*a069);
  a119=(a119+a122);
  a076=(a076*a114);
  a126=(a126*a080);
  a076=(a076+a126);
  a039=(a039*a038);
  a133=(a133*a006);
  a039=(a039-a133);
  a076=(a076+a039);
  a123=(a123*a076);
  a119=(a119+a123);
  a119=(a012+a119);
  a153=(a153*a119);
  a161=(a161*a110);
  a153=(a153-a161);
  a154=(a154+a153);
  a153=(a147*a154);
  a129=(a129+a153);
  a129=(a265+a129);
  a153=(a134*a129);
  a016=(a016+a153);
  a153=(a166*a015);
  a161=(a168*a087);
  a153=(a153+a161);
  a161=(a169*a107);
  a153=(a153+a161);
  a161=(a170*a130);
  a153=(a153+a161);
  a161=(a171*a154);
  a153=(a153+a161);
  a161=(a142*a265);
  a123=(a144*a041);
  a161=(a161+a123);
  a123=(a145*a099);
  a161=(a161+a123);
  a123=(a146*a038);
  a161=(a161+a123);
  a123=(a147*a110);
  a161=(a161+a123);
  a161=(a024+a161);
  a179=(a179*a161);
  a123=(a142*a012);
  a039=(a144*a085);
  a123=(a123+a039);
  a039=(a145*a049);
  a123=(a123+a039);
  a039=(a146*a006);
  a123=(a123+a039);
  a039=(a147*a119);
  a123=(a123+a039);
  a123=(a030+a123);
  a177=(a177*a123);
  a179=(a179+a177);
  a142=(a142*a227);
  a144=(a144*a036);
  a142=(a142+a144);
  a145=(a145*a069);
  a142=(a142+a145);
  a146=(a146*a076);
  a142=(a142+a146);
  a140=(a140*a137);
  a150=(a150*a091);
  a140=(a140+a150);
  a120=(a120*a110);
  a157=(a157*a119);
  a120=(a120-a157);
  a140=(a140+a120);
  a147=(a147*a140);
  a142=(a142+a147);
  a142=(a012+a142);
  a178=(a178*a142);
  a186=(a186*a129);
  a178=(a178-a186);
  a179=(a179+a178);
  a178=(a172*a179);
  a153=(a153+a178);
  a153=(a265+a153);
  a178=(a158*a153);
  a016=(a016+a178);
  a178=(a191*a015);
  a186=(a193*a087);
  a178=(a178+a186);
  a186=(a194*a107);
  a178=(a178+a186);
  a186=(a195*a130);
  a178=(a178+a186);
  a186=(a196*a154);
  a178=(a178+a186);
  a186=(a197*a179);
  a178=(a178+a186);
  a186=(a166*a265);
  a147=(a168*a041);
  a186=(a186+a147);
  a147=(a169*a099);
  a186=(a186+a147);
  a147=(a170*a038);
  a186=(a186+a147);
  a147=(a171*a110);
  a186=(a186+a147);
  a147=(a172*a129);
  a186=(a186+a147);
  a186=(a024+a186);
  a205=(a205*a186);
  a147=(a166*a012);
  a120=(a168*a085);
  a147=(a147+a120);
  a120=(a169*a049);
  a147=(a147+a120);
  a120=(a170*a006);
  a147=(a147+a120);
  a120=(a171*a119);
  a147=(a147+a120);
  a120=(a172*a142);
  a147=(a147+a120);
  a147=(a030+a147);
  a203=(a203*a147);
  a205=(a205+a203);
  a166=(a166*a227);
  a168=(a168*a036);
  a166=(a166+a168);
  a169=(a169*a069);
  a166=(a166+a169);
  a170=(a170*a076);
  a166=(a166+a170);
  a171=(a171*a140);
  a166=(a166+a171);
  a164=(a164*a161);
  a175=(a175*a123);
  a164=(a164+a175);
  a143=(a143*a129);
  a182=(a182*a142);
  a143=(a143-a182);
  a164=(a164+a143);
  a172=(a172*a164);
  a166=(a166+a172);
  a166=(a012+a166);
  a204=(a204*a166);
  a212=(a212*a153);
  a204=(a204-a212);
  a205=(a205+a204);
  a204=(a198*a205);
  a178=(a178+a204);
  a178=(a265+a178);
  a204=(a183*a178);
  a016=(a016+a204);
  a204=(a217*a015);
  a212=(a219*a087);
  a204=(a204+a212);
  a212=(a220*a107);
  a204=(a204+a212);
  a212=(a221*a130);
  a204=(a204+a212);
  a212=(a222*a154);
  a204=(a204+a212);
  a212=(a223*a179);
  a204=(a204+a212);
  a212=(a224*a205);
  a204=(a204+a212);
  a212=(a191*a265);
  a172=(a193*a041);
  a212=(a212+a172);
  a172=(a194*a099);
  a212=(a212+a172);
  a172=(a195*a038);
  a212=(a212+a172);
  a172=(a196*a110);
  a212=(a212+a172);
  a172=(a197*a129);
  a212=(a212+a172);
  a172=(a198*a153);
  a212=(a212+a172);
  a212=(a024+a212);
  a232=(a232*a212);
  a172=(a191*a012);
  a143=(a193*a085);
  a172=(a172+a143);
  a143=(a194*a049);
  a172=(a172+a143);
  a143=(a195*a006);
  a172=(a172+a143);
  a143=(a196*a119);
  a172=(a172+a143);
  a143=(a197*a142);
  a172=(a172+a143);
  a143=(a198*a166);
  a172=(a172+a143);
  a172=(a030+a172);
  a230=(a230*a172);
  a232=(a232+a230);
  a191=(a191*a227);
  a193=(a193*a036);
  a191=(a191+a193);
  a194=(a194*a069);
  a191=(a191+a194);
  a195=(a195*a076);
  a191=(a191+a195);
  a196=(a196*a140);
  a191=(a191+a196);
  a197=(a197*a164);
  a191=(a191+a197);
  a189=(a189*a186);
  a201=(a201*a147);
  a189=(a189+a201);
  a167=(a167*a153);
  a208=(a208*a166);
  a167=(a167-a208);
  a189=(a189+a167);
  a198=(a198*a189);
  a191=(a191+a198);
  a191=(a012+a191);
  a231=(a231*a191);
  a239=(a239*a178);
  a231=(a231-a239);
  a232=(a232+a231);
  a231=(a225*a232);
  a204=(a204+a231);
  a204=(a265+a204);
  a231=(a209*a204);
  a016=(a016+a231);
  a231=(a244*a015);
  a087=(a246*a087);
  a231=(a231+a087);
  a107=(a095*a107);
  a231=(a231+a107);
  a107=(a115*a130);
  a231=(a231+a107);
  a107=(a247*a154);
  a231=(a231+a107);
  a107=(a248*a179);
  a231=(a231+a107);
  a107=(a249*a205);
  a231=(a231+a107);
  a107=(a250*a232);
  a231=(a231+a107);
  a107=(a217*a265);
  a087=(a219*a041);
  a107=(a107+a087);
  a087=(a220*a099);
  a107=(a107+a087);
  a087=(a221*a038);
  a107=(a107+a087);
  a087=(a222*a110);
  a107=(a107+a087);
  a087=(a223*a129);
  a107=(a107+a087);
  a087=(a224*a153);
  a107=(a107+a087);
  a087=(a225*a178);
  a107=(a107+a087);
  a107=(a024+a107);
  a257=(a257*a107);
  a087=(a217*a012);
  a239=(a219*a085);
  a087=(a087+a239);
  a239=(a220*a049);
  a087=(a087+a239);
  a239=(a221*a006);
  a087=(a087+a239);
  a239=(a222*a119);
  a087=(a087+a239);
  a239=(a223*a142);
  a087=(a087+a239);
  a239=(a224*a166);
  a087=(a087+a239);
  a239=(a225*a191);
  a087=(a087+a239);
  a087=(a030+a087);
  a255=(a255*a087);
  a257=(a257+a255);
  a217=(a217*a227);
  a219=(a219*a036);
  a217=(a217+a219);
  a220=(a220*a069);
  a217=(a217+a220);
  a221=(a221*a076);
  a217=(a217+a221);
  a222=(a222*a140);
  a217=(a217+a222);
  a223=(a223*a164);
  a217=(a217+a223);
  a224=(a224*a189);
  a217=(a217+a224);
  a215=(a215*a212);
  a228=(a228*a172);
  a215=(a215+a228);
  a192=(a192*a178);
  a235=(a235*a191);
  a192=(a192-a235);
  a215=(a215+a192);
  a225=(a225*a215);
  a217=(a217+a225);
  a217=(a012+a217);
  a256=(a256*a217);
  a264=(a264*a204);
  a256=(a256-a264);
  a257=(a257+a256);
  a256=(a251*a257);
  a231=(a231+a256);
  a231=(a265+a231);
  a256=(a236*a231);
  a016=(a016+a256);
  a016=(a024+a016);
  if (res[0]!=0) res[0][12]=a016;
  a016=(a001*a012);
  a256=(a005*a006);
  a016=(a016+a256);
  a256=(a111*a119);
  a016=(a016+a256);
  a256=(a134*a142);
  a016=(a016+a256);
  a256=(a158*a166);
  a016=(a016+a256);
  a256=(a183*a191);
  a016=(a016+a256);
  a256=(a209*a217);
  a016=(a016+a256);
  a256=(a244*a227);
  a036=(a246*a036);
  a256=(a256+a036);
  a069=(a095*a069);
  a256=(a256+a069);
  a069=(a115*a076);
  a256=(a256+a069);
  a069=(a247*a140);
  a256=(a256+a069);
  a069=(a248*a164);
  a256=(a256+a069);
  a069=(a249*a189);
  a256=(a256+a069);
  a069=(a250*a215);
  a256=(a256+a069);
  a035=(a035*a107);
  a253=(a253*a087);
  a035=(a035+a253);
  a218=(a218*a204);
  a260=(a260*a217);
  a218=(a218-a260);
  a035=(a035+a218);
  a218=(a251*a035);
  a256=(a256+a218);
  a256=(a012+a256);
  a218=(a236*a256);
  a016=(a016+a218);
  a016=(a030+a016);
  if (res[0]!=0) res[0][13]=a016;
  a015=(a001*a015);
  a130=(a005*a130);
  a015=(a015+a130);
  a154=(a111*a154);
  a015=(a015+a154);
  a179=(a134*a179);
  a015=(a015+a179);
  a205=(a158*a205);
  a015=(a015+a205);
  a232=(a183*a232);
  a015=(a015+a232);
  a257=(a209*a257);
  a015=(a015+a257);
  a257=(a244*a265);
  a041=(a246*a041);
  a257=(a257+a041);
  a099=(a095*a099);
  a257=(a257+a099);
  a038=(a115*a038);
  a257=(a257+a038);
  a110=(a247*a110);
  a257=(a257+a110);
  a129=(a248*a129);
  a257=(a257+a129);
  a153=(a249*a153);
  a257=(a257+a153);
  a178=(a250*a178);
  a257=(a257+a178);
  a204=(a251*a204);
  a257=(a257+a204);
  a024=(a024+a257);
  a017=(a017*a024);
  a244=(a244*a012);
  a246=(a246*a085);
  a244=(a244+a246);
  a095=(a095*a049);
  a244=(a244+a095);
  a115=(a115*a006);
  a244=(a244+a115);
  a247=(a247*a119);
  a244=(a244+a247);
  a248=(a248*a142);
  a244=(a244+a248);
  a249=(a249*a166);
  a244=(a244+a249);
  a250=(a250*a191);
  a244=(a244+a250);
  a251=(a251*a217);
  a244=(a244+a251);
  a030=(a030+a244);
  a213=(a213*a030);
  a017=(a017+a213);
  a268=(a268*a256);
  a027=(a027*a231);
  a268=(a268-a027);
  a017=(a017+a268);
  a017=(a236*a017);
  a015=(a015+a017);
  a265=(a265+a015);
  if (res[0]!=0) res[0][14]=a265;
  a001=(a001*a227);
  a005=(a005*a076);
  a001=(a001+a005);
  a111=(a111*a140);
  a001=(a001+a111);
  a134=(a134*a164);
  a001=(a001+a134);
  a158=(a158*a189);
  a001=(a001+a158);
  a183=(a183*a215);
  a001=(a001+a183);
  a209=(a209*a035);
  a001=(a001+a209);
  a138=(a138*a024);
  a037=(a037*a030);
  a138=(a138+a037);
  a031=(a031*a231);
  a081=(a081*a256);
  a031=(a031-a081);
  a138=(a138+a031);
  a236=(a236*a138);
  a001=(a001+a236);
  a012=(a012+a001);
  if (res[0]!=0) res[0][15]=a012;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[3])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+270, w1, *w2=w+286, *w3=w+289, w5, *w6=w+291, w7;
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
  casadi_real a24, a25, a26, a27, a28, a29, a30;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[3]? arg[3][1] : 0;
  a04=arg[3]? arg[3][0] : 0;
  a05=(a02*a04);
  a06=arg[0]? arg[0][2] : 0;
  a07=arg[0]? arg[0][1] : 0;
  a08=sin(a07);
  a09=(-a08);
  a09=(2.*a09);
  a10=(a06*a09);
  a11=(a05*a10);
  a12=casadi_sq(a02);
  a13=(a06*a08);
  a13=(a04*a13);
  a14=(a12*a13);
  a11=(a11-a14);
  a14=(a02*a10);
  a11=(a11+a14);
  a11=(a11+a10);
  a11=(a11-a13);
  a13=(a02+a03);
  a10=casadi_sq(a13);
  a11=(a11/a10);
  a14=cos(a07);
  a15=(2.*a14);
  a16=(a04-a15);
  a17=2.;
  a16=(a16+a17);
  a16=(a12*a16);
  a18=(2.*a02);
  a19=(a04-a14);
  a19=(a19+a03);
  a19=(a18*a19);
  a16=(a16+a19);
  a16=(a16+a04);
  a16=(a16+a17);
  a16=(a16/a10);
  a17=(a11/a16);
  a19=(a14*a06);
  a19=(a19*a04);
  a20=(a12*a19);
  a21=(a18*a06);
  a20=(a20-a21);
  a21=arg[0]? arg[0][3] : 0;
  a22=(a02*a21);
  a20=(a20+a22);
  a23=(a15*a06);
  a24=(a05*a23);
  a20=(a20+a24);
  a24=(a02*a23);
  a20=(a20+a24);
  a20=(a20+a23);
  a20=(a20+a19);
  a20=(a20/a10);
  a19=(a20/a16);
  a23=(a19/a16);
  a24=(a18*a08);
  a09=(a12*a09);
  a24=(a24-a09);
  a24=(a24/a10);
  a23=(a23*a24);
  a17=(a17-a23);
  a23=(a02*a06);
  a23=(a23/a10);
  a09=(a02/a10);
  a25=(a14-a03);
  a25=(a02*a25);
  a25=(a25+a14);
  a25=(a09*a25);
  a26=(a25/a16);
  a27=(a26*a20);
  a23=(a23-a27);
  a27=(a12/a10);
  a28=(a25*a26);
  a27=(a27-a28);
  a23=(a23/a27);
  a28=(a02*a08);
  a28=(a28+a08);
  a28=(a09*a28);
  a29=(a28/a16);
  a30=(a26/a16);
  a30=(a30*a24);
  a29=(a29+a30);
  a30=(a23*a29);
  a11=(a26*a11);
  a20=(a20*a29);
  a11=(a11-a20);
  a11=(a11/a27);
  a20=(a23/a27);
  a28=(a26*a28);
  a25=(a25*a29);
  a28=(a28+a25);
  a20=(a20*a28);
  a11=(a11+a20);
  a20=(a26*a11);
  a30=(a30+a20);
  a17=(a17+a30);
  a30=(a17*a01);
  a14=(a04*a14);
  a12=(a12*a14);
  a12=(a12-a18);
  a05=(a05*a15);
  a12=(a12+a05);
  a05=(a02*a15);
  a12=(a12+a05);
  a12=(a12+a15);
  a12=(a12+a14);
  a12=(a12/a10);
  a10=(a12/a16);
  a12=(a26*a12);
  a12=(a09-a12);
  a12=(a12/a27);
  a14=(a26*a12);
  a10=(a10-a14);
  a14=arg[0]? arg[0][6] : 0;
  a15=(a10*a14);
  a30=(a30+a15);
  a15=(a09/a16);
  a09=(a26*a09);
  a09=(a09/a27);
  a05=(a26*a09);
  a15=(a15+a05);
  a05=arg[0]? arg[0][7] : 0;
  a18=(a15*a05);
  a30=(a30+a18);
  if (res[0]!=0) res[0][1]=a30;
  a14=(a12*a14);
  a30=(a11*a01);
  a14=(a14-a30);
  a05=(a09*a05);
  a14=(a14-a05);
  if (res[0]!=0) res[0][2]=a14;
  a14=-2.;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a05=(a00-a01);
  if (res[0]!=0) res[0][4]=a05;
  a05=(a17*a01);
  a30=arg[0]? arg[0][10] : 0;
  a18=(a10*a30);
  a05=(a05+a18);
  a18=arg[0]? arg[0][11] : 0;
  a20=(a15*a18);
  a05=(a05+a20);
  a05=(a05-a03);
  if (res[0]!=0) res[0][5]=a05;
  a30=(a12*a30);
  a05=(a11*a01);
  a30=(a30-a05);
  a18=(a09*a18);
  a30=(a30-a18);
  if (res[0]!=0) res[0][6]=a30;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a30=(a00-a01);
  if (res[0]!=0) res[0][8]=a30;
  a30=(a17*a01);
  a18=arg[0]? arg[0][14] : 0;
  a05=(a10*a18);
  a30=(a30+a05);
  a05=arg[0]? arg[0][15] : 0;
  a20=(a15*a05);
  a30=(a30+a20);
  if (res[0]!=0) res[0][9]=a30;
  a18=(a12*a18);
  a30=(a11*a01);
  a18=(a18-a30);
  a05=(a09*a05);
  a18=(a18-a05);
  a18=(a18-a03);
  if (res[0]!=0) res[0][10]=a18;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=(a06-a21);
  if (res[0]!=0) res[0][12]=a00;
  a17=(a17*a21);
  a22=(a22*a08);
  a00=(2.*a06);
  a00=(a00-a21);
  a22=(a22*a00);
  a00=arg[3]? arg[3][2] : 0;
  a01=arg[0]? arg[0][0] : 0;
  a00=(a00-a01);
  a18=sin(a00);
  a03=(a02*a18);
  a22=(a22+a03);
  a00=(a00+a07);
  a00=sin(a00);
  a03=(a02*a00);
  a22=(a22-a03);
  a04=(a04*a18);
  a04=(a04*a13);
  a22=(a22+a04);
  a18=(2.*a18);
  a22=(a22+a18);
  a22=(a22/a13);
  a16=(a22/a16);
  a02=(a02/a13);
  a13=casadi_sq(a06);
  a13=(a13*a08);
  a13=(a13-a00);
  a02=(a02*a13);
  a22=(a26*a22);
  a02=(a02+a22);
  a02=(a02/a27);
  a27=(a26*a02);
  a16=(a16+a27);
  a10=(a10*a16);
  a17=(a17-a10);
  a15=(a15*a02);
  a17=(a17+a15);
  if (res[0]!=0) res[0][13]=a17;
  a11=(a11*a21);
  a12=(a12*a16);
  a11=(a11+a12);
  a09=(a09*a02);
  a11=(a11+a09);
  a11=(-a11);
  if (res[0]!=0) res[0][14]=a11;
  a14=(a14*a06);
  a14=(a14+a21);
  if (res[0]!=0) res[0][15]=a14;
  a14=(a01-a07);
  a21=arg[1]? arg[1][0] : 0;
  a14=(a14-a21);
  if (res[1]!=0) res[1][0]=a14;
  a26=(a26*a23);
  a19=(a19-a26);
  a26=arg[1]? arg[1][1] : 0;
  a19=(a19-a26);
  if (res[1]!=0) res[1][1]=a19;
  a19=arg[1]? arg[1][2] : 0;
  a23=(a23-a19);
  if (res[1]!=0) res[1][2]=a23;
  a01=(2.*a01);
  a07=(a07-a01);
  if (res[1]!=0) res[1][3]=a07;
  return 0;
}

/* goswami_compass_jacobian_12:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+2, *rr, *w0=w+419, *w1=w+435, *w2=w+439, *w3=w+442, *w4=w+458;
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
  casadi_real **res1=res+1, *w0=w+526, *w1=w+530, *w2=w+533;
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
  casadi_real a72, a73, a74, a75, a76, a77, a78;
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
  a12=(a12-a08);
  a09=(a09*a12);
  a12=arg[4]? arg[4][2] : 0;
  a13=sin(a12);
  a14=cos(a00);
  a14=(a13*a14);
  a15=cos(a12);
  a16=sin(a00);
  a16=(a15*a16);
  a14=(a14-a16);
  a16=(a07*a14);
  a09=(a09+a16);
  a16=(a12-a00);
  a16=(a16+a10);
  a16=sin(a16);
  a17=(a07*a16);
  a09=(a09-a17);
  a17=arg[4]? arg[4][0] : 0;
  a18=(a17*a14);
  a19=1.;
  a20=(a07+a19);
  a18=(a18*a20);
  a09=(a09+a18);
  a14=(2.*a14);
  a09=(a09+a14);
  a09=(a09/a20);
  a14=casadi_sq(a07);
  a18=cos(a10);
  a21=(2.*a18);
  a21=(a17-a21);
  a22=2.;
  a21=(a21+a22);
  a21=(a14*a21);
  a23=(2.*a07);
  a24=(a17-a18);
  a24=(a24+a19);
  a24=(a23*a24);
  a21=(a21+a24);
  a21=(a21+a17);
  a21=(a21+a22);
  a24=casadi_sq(a20);
  a21=(a21/a24);
  a25=(a09/a21);
  a26=(a07/a24);
  a27=(a18-a19);
  a27=(a07*a27);
  a27=(a27+a18);
  a27=(a26*a27);
  a21=(a27/a21);
  a18=(a07/a20);
  a28=casadi_sq(a03);
  a28=(a28*a11);
  a28=(a28-a16);
  a28=(a18*a28);
  a09=(a21*a09);
  a28=(a28+a09);
  a09=(a14/a24);
  a27=(a27*a21);
  a27=(a09-a27);
  a28=(a28/a27);
  a21=(a21*a28);
  a25=(a25+a21);
  a21=(a06*a25);
  a27=1.7082860872947386e-01;
  a27=(a27*a02);
  a16=2.9587585476806851e-02;
  a16=(a16*a02);
  a11=(a16*a28);
  a29=8.8762756430420545e-02;
  a29=(a29*a02);
  a30=1.9725056984537900e-02;
  a30=(a30*a02);
  a31=(a30*a25);
  a32=5.9175170953613701e-02;
  a32=(a32*a02);
  a33=5.2600151958767730e-02;
  a33=(a33*a02);
  a34=(a33*a28);
  a34=(a08+a34);
  a35=(a07*a34);
  a36=(a33*a08);
  a36=(a10+a36);
  a37=sin(a36);
  a35=(a35*a37);
  a38=(a33*a25);
  a38=(a03-a38);
  a39=(2.*a38);
  a39=(a39-a34);
  a35=(a35*a39);
  a33=(a33*a03);
  a33=(a00+a33);
  a39=cos(a33);
  a39=(a13*a39);
  a40=sin(a33);
  a40=(a15*a40);
  a39=(a39-a40);
  a40=(a07*a39);
  a35=(a35+a40);
  a33=(a12-a33);
  a33=(a33+a36);
  a33=sin(a33);
  a40=(a07*a33);
  a35=(a35-a40);
  a40=(a17*a39);
  a40=(a40*a20);
  a35=(a35+a40);
  a39=(2.*a39);
  a35=(a35+a39);
  a35=(a35/a20);
  a36=cos(a36);
  a39=(2.*a36);
  a39=(a17-a39);
  a39=(a39+a22);
  a39=(a14*a39);
  a40=(a17-a36);
  a40=(a40+a19);
  a40=(a23*a40);
  a39=(a39+a40);
  a39=(a39+a17);
  a39=(a39+a22);
  a39=(a39/a24);
  a40=(a35/a39);
  a41=(a36-a19);
  a41=(a07*a41);
  a41=(a41+a36);
  a41=(a26*a41);
  a39=(a41/a39);
  a36=casadi_sq(a38);
  a36=(a36*a37);
  a36=(a36-a33);
  a36=(a18*a36);
  a35=(a39*a35);
  a36=(a36+a35);
  a41=(a41*a39);
  a41=(a09-a41);
  a36=(a36/a41);
  a39=(a39*a36);
  a40=(a40+a39);
  a40=(a32*a40);
  a31=(a31+a40);
  a31=(a03-a31);
  a40=casadi_sq(a31);
  a39=(a30*a08);
  a34=(a32*a34);
  a39=(a39+a34);
  a39=(a10+a39);
  a34=sin(a39);
  a40=(a40*a34);
  a41=(a30*a03);
  a38=(a32*a38);
  a41=(a41+a38);
  a41=(a00+a41);
  a38=(a12-a41);
  a38=(a38+a39);
  a38=sin(a38);
  a40=(a40-a38);
  a40=(a18*a40);
  a39=cos(a39);
  a35=(a39-a19);
  a35=(a07*a35);
  a35=(a35+a39);
  a35=(a26*a35);
  a33=(2.*a39);
  a33=(a17-a33);
  a33=(a33+a22);
  a33=(a14*a33);
  a39=(a17-a39);
  a39=(a39+a19);
  a39=(a23*a39);
  a33=(a33+a39);
  a33=(a33+a17);
  a33=(a33+a22);
  a33=(a33/a24);
  a39=(a35/a33);
  a30=(a30*a28);
  a32=(a32*a36);
  a30=(a30+a32);
  a30=(a08+a30);
  a32=(a07*a30);
  a32=(a32*a34);
  a34=(2.*a31);
  a34=(a34-a30);
  a32=(a32*a34);
  a34=cos(a41);
  a34=(a13*a34);
  a41=sin(a41);
  a41=(a15*a41);
  a34=(a34-a41);
  a41=(a07*a34);
  a32=(a32+a41);
  a38=(a07*a38);
  a32=(a32-a38);
  a38=(a17*a34);
  a38=(a38*a20);
  a32=(a32+a38);
  a34=(2.*a34);
  a32=(a32+a34);
  a32=(a32/a20);
  a34=(a39*a32);
  a40=(a40+a34);
  a35=(a35*a39);
  a35=(a09-a35);
  a40=(a40/a35);
  a35=(a29*a40);
  a11=(a11+a35);
  a11=(a08+a11);
  a35=(a07*a11);
  a34=(a16*a08);
  a38=(a29*a30);
  a34=(a34+a38);
  a34=(a10+a34);
  a38=sin(a34);
  a35=(a35*a38);
  a41=(a16*a25);
  a32=(a32/a33);
  a39=(a39*a40);
  a32=(a32+a39);
  a39=(a29*a32);
  a41=(a41+a39);
  a41=(a03-a41);
  a39=(2.*a41);
  a39=(a39-a11);
  a35=(a35*a39);
  a16=(a16*a03);
  a29=(a29*a31);
  a16=(a16+a29);
  a16=(a00+a16);
  a29=cos(a16);
  a29=(a13*a29);
  a39=sin(a16);
  a39=(a15*a39);
  a29=(a29-a39);
  a39=(a07*a29);
  a35=(a35+a39);
  a16=(a12-a16);
  a16=(a16+a34);
  a16=sin(a16);
  a39=(a07*a16);
  a35=(a35-a39);
  a39=(a17*a29);
  a39=(a39*a20);
  a35=(a35+a39);
  a29=(2.*a29);
  a35=(a35+a29);
  a35=(a35/a20);
  a34=cos(a34);
  a29=(2.*a34);
  a29=(a17-a29);
  a29=(a29+a22);
  a29=(a14*a29);
  a39=(a17-a34);
  a39=(a39+a19);
  a39=(a23*a39);
  a29=(a29+a39);
  a29=(a29+a17);
  a29=(a29+a22);
  a29=(a29/a24);
  a39=(a35/a29);
  a33=(a34-a19);
  a33=(a07*a33);
  a33=(a33+a34);
  a33=(a26*a33);
  a29=(a33/a29);
  a34=casadi_sq(a41);
  a34=(a34*a38);
  a34=(a34-a16);
  a34=(a18*a34);
  a35=(a29*a35);
  a34=(a34+a35);
  a33=(a33*a29);
  a33=(a09-a33);
  a34=(a34/a33);
  a29=(a29*a34);
  a39=(a39+a29);
  a29=(a27*a39);
  a21=(a21+a29);
  a29=1.2546768756682242e-01;
  a29=(a29*a02);
  a33=2.4136513415926669e-01;
  a33=(a33*a02);
  a35=(a33*a28);
  a16=-8.8454947932828609e-01;
  a16=(a16*a02);
  a40=(a16*a40);
  a35=(a35+a40);
  a40=9.2483400326179199e-01;
  a40=(a40*a02);
  a38=(a40*a34);
  a35=(a35+a38);
  a35=(a08+a35);
  a38=(a07*a35);
  a36=(a33*a08);
  a30=(a16*a30);
  a36=(a36+a30);
  a30=(a40*a11);
  a36=(a36+a30);
  a36=(a10+a36);
  a30=sin(a36);
  a38=(a38*a30);
  a37=(a33*a25);
  a32=(a16*a32);
  a37=(a37+a32);
  a32=(a40*a39);
  a37=(a37+a32);
  a37=(a03-a37);
  a32=(2.*a37);
  a32=(a32-a35);
  a38=(a38*a32);
  a33=(a33*a03);
  a16=(a16*a31);
  a33=(a33+a16);
  a40=(a40*a41);
  a33=(a33+a40);
  a33=(a00+a33);
  a40=cos(a33);
  a40=(a13*a40);
  a16=sin(a33);
  a16=(a15*a16);
  a40=(a40-a16);
  a16=(a07*a40);
  a38=(a38+a16);
  a33=(a12-a33);
  a33=(a33+a36);
  a33=sin(a33);
  a16=(a07*a33);
  a38=(a38-a16);
  a16=(a17*a40);
  a16=(a16*a20);
  a38=(a38+a16);
  a40=(2.*a40);
  a38=(a38+a40);
  a38=(a38/a20);
  a36=cos(a36);
  a40=(2.*a36);
  a40=(a17-a40);
  a40=(a40+a22);
  a40=(a14*a40);
  a16=(a17-a36);
  a16=(a16+a19);
  a16=(a23*a16);
  a40=(a40+a16);
  a40=(a40+a17);
  a40=(a40+a22);
  a40=(a40/a24);
  a16=(a38/a40);
  a31=(a36-a19);
  a31=(a07*a31);
  a31=(a31+a36);
  a31=(a26*a31);
  a40=(a31/a40);
  a36=casadi_sq(a37);
  a36=(a36*a30);
  a36=(a36-a33);
  a36=(a18*a36);
  a38=(a40*a38);
  a36=(a36+a38);
  a31=(a31*a40);
  a31=(a09-a31);
  a36=(a36/a31);
  a40=(a40*a36);
  a16=(a16+a40);
  a40=(a29*a16);
  a21=(a21+a40);
  a21=(a03-a21);
  a40=(a05*a21);
  a04=(a04+a40);
  a40=1.8915178993145003e+00;
  a40=(a40*a02);
  a31=3.7109375000000000e-02;
  a31=(a31*a02);
  a38=(a31*a25);
  a33=1.7025221101954405e-01;
  a33=(a33*a02);
  a30=(a33*a39);
  a38=(a38+a30);
  a30=6.0216538980455959e-02;
  a30=(a30*a02);
  a32=(a30*a16);
  a38=(a38+a32);
  a32=-1.7578125000000000e-02;
  a32=(a32*a02);
  a42=(a06*a28);
  a43=(a27*a34);
  a42=(a42+a43);
  a43=(a29*a36);
  a42=(a42+a43);
  a42=(a08+a42);
  a43=(a07*a42);
  a44=(a06*a08);
  a45=(a27*a11);
  a44=(a44+a45);
  a45=(a29*a35);
  a44=(a44+a45);
  a44=(a10+a44);
  a45=sin(a44);
  a43=(a43*a45);
  a46=(2.*a21);
  a46=(a46-a42);
  a43=(a43*a46);
  a06=(a06*a03);
  a27=(a27*a41);
  a06=(a06+a27);
  a29=(a29*a37);
  a06=(a06+a29);
  a06=(a00+a06);
  a29=cos(a06);
  a29=(a13*a29);
  a27=sin(a06);
  a27=(a15*a27);
  a29=(a29-a27);
  a27=(a07*a29);
  a43=(a43+a27);
  a06=(a12-a06);
  a06=(a06+a44);
  a06=sin(a06);
  a27=(a07*a06);
  a43=(a43-a27);
  a27=(a17*a29);
  a27=(a27*a20);
  a43=(a43+a27);
  a29=(2.*a29);
  a43=(a43+a29);
  a43=(a43/a20);
  a44=cos(a44);
  a29=(2.*a44);
  a29=(a17-a29);
  a29=(a29+a22);
  a29=(a14*a29);
  a27=(a17-a44);
  a27=(a27+a19);
  a27=(a23*a27);
  a29=(a29+a27);
  a29=(a29+a17);
  a29=(a29+a22);
  a29=(a29/a24);
  a27=(a43/a29);
  a46=(a44-a19);
  a46=(a07*a46);
  a46=(a46+a44);
  a46=(a26*a46);
  a29=(a46/a29);
  a44=casadi_sq(a21);
  a44=(a44*a45);
  a44=(a44-a06);
  a44=(a18*a44);
  a43=(a29*a43);
  a44=(a44+a43);
  a46=(a46*a29);
  a46=(a09-a46);
  a44=(a44/a46);
  a29=(a29*a44);
  a27=(a27+a29);
  a29=(a32*a27);
  a38=(a38+a29);
  a38=(a03-a38);
  a29=(a40*a38);
  a04=(a04+a29);
  a29=-5.8012039600105849e+00;
  a29=(a29*a02);
  a46=3.7092000118504789e-02;
  a46=(a46*a02);
  a43=(a46*a25);
  a06=1.7038392571223998e-01;
  a06=(a06*a02);
  a45=(a06*a39);
  a43=(a43+a45);
  a45=1.0726203044637328e-01;
  a45=(a45*a02);
  a47=(a45*a16);
  a43=(a43+a47);
  a47=-1.5319437748624402e-02;
  a47=(a47*a02);
  a48=(a47*a27);
  a43=(a43+a48);
  a48=8.2737891638140233e-03;
  a48=(a48*a02);
  a49=(a31*a28);
  a50=(a33*a34);
  a49=(a49+a50);
  a50=(a30*a36);
  a49=(a49+a50);
  a50=(a32*a44);
  a49=(a49+a50);
  a49=(a08+a49);
  a50=(a07*a49);
  a51=(a31*a08);
  a52=(a33*a11);
  a51=(a51+a52);
  a52=(a30*a35);
  a51=(a51+a52);
  a52=(a32*a42);
  a51=(a51+a52);
  a51=(a10+a51);
  a52=sin(a51);
  a50=(a50*a52);
  a53=(2.*a38);
  a53=(a53-a49);
  a50=(a50*a53);
  a31=(a31*a03);
  a33=(a33*a41);
  a31=(a31+a33);
  a30=(a30*a37);
  a31=(a31+a30);
  a32=(a32*a21);
  a31=(a31+a32);
  a31=(a00+a31);
  a32=cos(a31);
  a32=(a13*a32);
  a30=sin(a31);
  a30=(a15*a30);
  a32=(a32-a30);
  a30=(a07*a32);
  a50=(a50+a30);
  a31=(a12-a31);
  a31=(a31+a51);
  a31=sin(a31);
  a30=(a07*a31);
  a50=(a50-a30);
  a30=(a17*a32);
  a30=(a30*a20);
  a50=(a50+a30);
  a32=(2.*a32);
  a50=(a50+a32);
  a50=(a50/a20);
  a51=cos(a51);
  a32=(2.*a51);
  a32=(a17-a32);
  a32=(a32+a22);
  a32=(a14*a32);
  a30=(a17-a51);
  a30=(a30+a19);
  a30=(a23*a30);
  a32=(a32+a30);
  a32=(a32+a17);
  a32=(a32+a22);
  a32=(a32/a24);
  a30=(a50/a32);
  a33=(a51-a19);
  a33=(a07*a33);
  a33=(a33+a51);
  a33=(a26*a33);
  a32=(a33/a32);
  a51=casadi_sq(a38);
  a51=(a51*a52);
  a51=(a51-a31);
  a51=(a18*a51);
  a50=(a32*a50);
  a51=(a51+a50);
  a33=(a33*a32);
  a33=(a09-a33);
  a51=(a51/a33);
  a32=(a32*a51);
  a30=(a30+a32);
  a32=(a48*a30);
  a43=(a43+a32);
  a43=(a03-a43);
  a32=(a29*a43);
  a04=(a04+a32);
  a32=3.1116436695781990e-01;
  a32=(a32*a02);
  a33=6.2411095871607569e-01;
  a33=(a33*a02);
  a50=(a33*a25);
  a31=-3.3608926294469414e+00;
  a31=(a31*a02);
  a52=(a31*a39);
  a50=(a50+a52);
  a52=-8.6821934684172597e-01;
  a52=(a52*a02);
  a53=(a52*a16);
  a50=(a50+a53);
  a53=2.7592099699446710e+01;
  a53=(a53*a02);
  a54=(a53*a27);
  a50=(a50+a54);
  a54=2.0154067550477894e+01;
  a54=(a54*a02);
  a55=(a54*a30);
  a50=(a50+a55);
  a55=-4.3489884181069961e+01;
  a55=(a55*a02);
  a56=(a46*a28);
  a57=(a06*a34);
  a56=(a56+a57);
  a57=(a45*a36);
  a56=(a56+a57);
  a57=(a47*a44);
  a56=(a56+a57);
  a57=(a48*a51);
  a56=(a56+a57);
  a56=(a08+a56);
  a57=(a07*a56);
  a58=(a46*a08);
  a59=(a06*a11);
  a58=(a58+a59);
  a59=(a45*a35);
  a58=(a58+a59);
  a59=(a47*a42);
  a58=(a58+a59);
  a59=(a48*a49);
  a58=(a58+a59);
  a58=(a10+a58);
  a59=sin(a58);
  a57=(a57*a59);
  a60=(2.*a43);
  a60=(a60-a56);
  a57=(a57*a60);
  a46=(a46*a03);
  a06=(a06*a41);
  a46=(a46+a06);
  a45=(a45*a37);
  a46=(a46+a45);
  a47=(a47*a21);
  a46=(a46+a47);
  a48=(a48*a38);
  a46=(a46+a48);
  a46=(a00+a46);
  a48=cos(a46);
  a48=(a13*a48);
  a47=sin(a46);
  a47=(a15*a47);
  a48=(a48-a47);
  a47=(a07*a48);
  a57=(a57+a47);
  a46=(a12-a46);
  a46=(a46+a58);
  a46=sin(a46);
  a47=(a07*a46);
  a57=(a57-a47);
  a47=(a17*a48);
  a47=(a47*a20);
  a57=(a57+a47);
  a48=(2.*a48);
  a57=(a57+a48);
  a57=(a57/a20);
  a58=cos(a58);
  a48=(2.*a58);
  a48=(a17-a48);
  a48=(a48+a22);
  a48=(a14*a48);
  a47=(a17-a58);
  a47=(a47+a19);
  a47=(a23*a47);
  a48=(a48+a47);
  a48=(a48+a17);
  a48=(a48+a22);
  a48=(a48/a24);
  a47=(a57/a48);
  a45=(a58-a19);
  a45=(a07*a45);
  a45=(a45+a58);
  a45=(a26*a45);
  a48=(a45/a48);
  a58=casadi_sq(a43);
  a58=(a58*a59);
  a58=(a58-a46);
  a58=(a18*a58);
  a57=(a48*a57);
  a58=(a58+a57);
  a45=(a45*a48);
  a45=(a09-a45);
  a58=(a58/a45);
  a48=(a48*a58);
  a47=(a47+a48);
  a48=(a55*a47);
  a50=(a50+a48);
  a50=(a03-a50);
  a48=(a32*a50);
  a04=(a04+a48);
  a48=-1.5216094966251609e-01;
  a48=(a48*a02);
  a45=4.7766253643826434e-01;
  a45=(a45*a02);
  a57=(a45*a25);
  a46=-2.4881146199716677e+00;
  a46=(a46*a02);
  a59=(a46*a39);
  a57=(a57+a59);
  a59=-5.9029082683684297e-01;
  a59=(a59*a02);
  a06=(a59*a16);
  a57=(a57+a06);
  a06=2.1230051448181193e+01;
  a06=(a06*a02);
  a60=(a06*a27);
  a57=(a57+a60);
  a60=1.5279233632882423e+01;
  a60=(a60*a02);
  a61=(a60*a30);
  a57=(a57+a61);
  a61=-3.3288210968984863e+01;
  a61=(a61*a02);
  a62=(a61*a47);
  a57=(a57+a62);
  a62=-2.0331201708508627e-02;
  a62=(a62*a02);
  a63=(a33*a28);
  a64=(a31*a34);
  a63=(a63+a64);
  a64=(a52*a36);
  a63=(a63+a64);
  a64=(a53*a44);
  a63=(a63+a64);
  a64=(a54*a51);
  a63=(a63+a64);
  a64=(a55*a58);
  a63=(a63+a64);
  a63=(a08+a63);
  a64=(a07*a63);
  a65=(a33*a08);
  a66=(a31*a11);
  a65=(a65+a66);
  a66=(a52*a35);
  a65=(a65+a66);
  a66=(a53*a42);
  a65=(a65+a66);
  a66=(a54*a49);
  a65=(a65+a66);
  a66=(a55*a56);
  a65=(a65+a66);
  a65=(a10+a65);
  a66=sin(a65);
  a64=(a64*a66);
  a67=(2.*a50);
  a67=(a67-a63);
  a64=(a64*a67);
  a33=(a33*a03);
  a31=(a31*a41);
  a33=(a33+a31);
  a52=(a52*a37);
  a33=(a33+a52);
  a53=(a53*a21);
  a33=(a33+a53);
  a54=(a54*a38);
  a33=(a33+a54);
  a55=(a55*a43);
  a33=(a33+a55);
  a33=(a00+a33);
  a55=cos(a33);
  a55=(a13*a55);
  a54=sin(a33);
  a54=(a15*a54);
  a55=(a55-a54);
  a54=(a07*a55);
  a64=(a64+a54);
  a33=(a12-a33);
  a33=(a33+a65);
  a33=sin(a33);
  a54=(a07*a33);
  a64=(a64-a54);
  a54=(a17*a55);
  a54=(a54*a20);
  a64=(a64+a54);
  a55=(2.*a55);
  a64=(a64+a55);
  a64=(a64/a20);
  a65=cos(a65);
  a55=(2.*a65);
  a55=(a17-a55);
  a55=(a55+a22);
  a55=(a14*a55);
  a54=(a17-a65);
  a54=(a54+a19);
  a54=(a23*a54);
  a55=(a55+a54);
  a55=(a55+a17);
  a55=(a55+a22);
  a55=(a55/a24);
  a54=(a64/a55);
  a53=(a65-a19);
  a53=(a07*a53);
  a53=(a53+a65);
  a53=(a26*a53);
  a55=(a53/a55);
  a65=casadi_sq(a50);
  a65=(a65*a66);
  a65=(a65-a33);
  a65=(a18*a65);
  a64=(a55*a64);
  a65=(a65+a64);
  a53=(a53*a55);
  a53=(a09-a53);
  a65=(a65/a53);
  a55=(a55*a65);
  a54=(a54+a55);
  a55=(a62*a54);
  a57=(a57+a55);
  a57=(a03-a57);
  a55=(a48*a57);
  a04=(a04+a55);
  a55=2.0136540080403034e-01;
  a55=(a55*a02);
  a53=-9.3714243008598730e-01;
  a53=(a53*a02);
  a64=(a53*a25);
  a33=5.1863724288440638e+00;
  a33=(a33*a02);
  a66=(a33*a39);
  a64=(a64+a66);
  a66=1.0914373489967295e+00;
  a66=(a66*a02);
  a52=(a66*a16);
  a64=(a64+a52);
  a52=-8.1497870107469268e+00;
  a52=(a52*a02);
  a31=(a52*a27);
  a64=(a64+a31);
  a31=-1.8520065659996959e+01;
  a31=(a31*a02);
  a67=(a31*a30);
  a64=(a64+a67);
  a67=2.2739487099350505e+01;
  a67=(a67*a02);
  a68=(a67*a47);
  a64=(a64+a68);
  a68=2.4936055526796523e+00;
  a68=(a68*a02);
  a69=(a68*a54);
  a64=(a64+a69);
  a69=-3.0467644718982196e+00;
  a69=(a69*a02);
  a70=(a45*a28);
  a71=(a46*a34);
  a70=(a70+a71);
  a71=(a59*a36);
  a70=(a70+a71);
  a71=(a06*a44);
  a70=(a70+a71);
  a71=(a60*a51);
  a70=(a70+a71);
  a71=(a61*a58);
  a70=(a70+a71);
  a71=(a62*a65);
  a70=(a70+a71);
  a70=(a08+a70);
  a71=(a07*a70);
  a72=(a45*a08);
  a73=(a46*a11);
  a72=(a72+a73);
  a73=(a59*a35);
  a72=(a72+a73);
  a73=(a06*a42);
  a72=(a72+a73);
  a73=(a60*a49);
  a72=(a72+a73);
  a73=(a61*a56);
  a72=(a72+a73);
  a73=(a62*a63);
  a72=(a72+a73);
  a72=(a10+a72);
  a73=sin(a72);
  a71=(a71*a73);
  a74=(2.*a57);
  a74=(a74-a70);
  a71=(a71*a74);
  a45=(a45*a03);
  a46=(a46*a41);
  a45=(a45+a46);
  a59=(a59*a37);
  a45=(a45+a59);
  a06=(a06*a21);
  a45=(a45+a06);
  a60=(a60*a38);
  a45=(a45+a60);
  a61=(a61*a43);
  a45=(a45+a61);
  a62=(a62*a50);
  a45=(a45+a62);
  a45=(a00+a45);
  a62=cos(a45);
  a62=(a13*a62);
  a61=sin(a45);
  a61=(a15*a61);
  a62=(a62-a61);
  a61=(a07*a62);
  a71=(a71+a61);
  a45=(a12-a45);
  a45=(a45+a72);
  a45=sin(a45);
  a61=(a07*a45);
  a71=(a71-a61);
  a61=(a17*a62);
  a61=(a61*a20);
  a71=(a71+a61);
  a62=(2.*a62);
  a71=(a71+a62);
  a71=(a71/a20);
  a72=cos(a72);
  a62=(2.*a72);
  a62=(a17-a62);
  a62=(a62+a22);
  a62=(a14*a62);
  a61=(a17-a72);
  a61=(a61+a19);
  a61=(a23*a61);
  a62=(a62+a61);
  a62=(a62+a17);
  a62=(a62+a22);
  a62=(a62/a24);
  a61=(a71/a62);
  a60=(a72-a19);
  a60=(a07*a60);
  a60=(a60+a72);
  a60=(a26*a60);
  a62=(a60/a62);
  a72=casadi_sq(a57);
  a72=(a72*a73);
  a72=(a72-a45);
  a72=(a18*a72);
  a71=(a62*a71);
  a72=(a72+a71);
  a60=(a60*a62);
  a60=(a09-a60);
  a72=(a72/a60);
  a62=(a62*a72);
  a61=(a61+a62);
  a62=(a69*a61);
  a64=(a64+a62);
  a64=(a03-a64);
  a62=(a55*a64);
  a04=(a04+a62);
  a62=4.4710615727772587e-02;
  a62=(a62*a02);
  a60=2.2733101475165380e+00;
  a60=(a60*a02);
  a71=(a60*a25);
  a45=-1.0534495466737249e+01;
  a45=(a45*a02);
  a39=(a45*a39);
  a71=(a71+a39);
  a39=-2.0008720582248625e+00;
  a39=(a39*a02);
  a16=(a39*a16);
  a71=(a71+a16);
  a16=-1.7958931863118799e+01;
  a16=(a16*a02);
  a73=(a16*a27);
  a71=(a71+a73);
  a73=2.7948884529419960e+01;
  a73=(a73*a02);
  a06=(a73*a30);
  a71=(a71+a06);
  a06=-2.8589982771350235e+00;
  a06=(a06*a02);
  a59=(a06*a47);
  a71=(a71+a59);
  a59=-8.8728569335306293e+00;
  a59=(a59*a02);
  a46=(a59*a54);
  a71=(a71+a46);
  a46=1.2360567175794303e+01;
  a46=(a46*a02);
  a74=(a46*a61);
  a71=(a71+a74);
  a74=6.4339274601576357e-01;
  a74=(a74*a02);
  a02=(a53*a28);
  a75=(a33*a34);
  a02=(a02+a75);
  a75=(a66*a36);
  a02=(a02+a75);
  a75=(a52*a44);
  a02=(a02+a75);
  a75=(a31*a51);
  a02=(a02+a75);
  a75=(a67*a58);
  a02=(a02+a75);
  a75=(a68*a65);
  a02=(a02+a75);
  a75=(a69*a72);
  a02=(a02+a75);
  a02=(a08+a02);
  a75=(a07*a02);
  a76=(a53*a08);
  a77=(a33*a11);
  a76=(a76+a77);
  a77=(a66*a35);
  a76=(a76+a77);
  a77=(a52*a42);
  a76=(a76+a77);
  a77=(a31*a49);
  a76=(a76+a77);
  a77=(a67*a56);
  a76=(a76+a77);
  a77=(a68*a63);
  a76=(a76+a77);
  a77=(a69*a70);
  a76=(a76+a77);
  a76=(a10+a76);
  a77=sin(a76);
  a75=(a75*a77);
  a78=(2.*a64);
  a78=(a78-a02);
  a75=(a75*a78);
  a53=(a53*a03);
  a33=(a33*a41);
  a53=(a53+a33);
  a66=(a66*a37);
  a53=(a53+a66);
  a52=(a52*a21);
  a53=(a53+a52);
  a31=(a31*a38);
  a53=(a53+a31);
  a67=(a67*a43);
  a53=(a53+a67);
  a68=(a68*a50);
  a53=(a53+a68);
  a69=(a69*a57);
  a53=(a53+a69);
  a53=(a00+a53);
  a69=cos(a53);
  a69=(a13*a69);
  a68=sin(a53);
  a68=(a15*a68);
  a69=(a69-a68);
  a68=(a07*a69);
  a75=(a75+a68);
  a53=(a12-a53);
  a53=(a53+a76);
  a53=sin(a53);
  a68=(a07*a53);
  a75=(a75-a68);
  a68=(a17*a69);
  a68=(a68*a20);
  a75=(a75+a68);
  a69=(2.*a69);
  a75=(a75+a69);
  a75=(a75/a20);
  a76=cos(a76);
  a69=(2.*a76);
  a69=(a17-a69);
  a69=(a69+a22);
  a69=(a14*a69);
  a68=(a17-a76);
  a68=(a68+a19);
  a68=(a23*a68);
  a69=(a69+a68);
  a69=(a69+a17);
  a69=(a69+a22);
  a69=(a69/a24);
  a68=(a75/a69);
  a67=(a76-a19);
  a67=(a07*a67);
  a67=(a67+a76);
  a67=(a26*a67);
  a69=(a67/a69);
  a76=casadi_sq(a64);
  a76=(a76*a77);
  a76=(a76-a53);
  a76=(a18*a76);
  a75=(a69*a75);
  a76=(a76+a75);
  a67=(a67*a69);
  a67=(a09-a67);
  a76=(a76/a67);
  a69=(a69*a76);
  a68=(a68+a69);
  a69=(a74*a68);
  a71=(a71+a69);
  a71=(a03-a71);
  a69=(a62*a71);
  a04=(a04+a69);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a69=(a05*a42);
  a04=(a04+a69);
  a69=(a40*a49);
  a04=(a04+a69);
  a69=(a29*a56);
  a04=(a04+a69);
  a69=(a32*a63);
  a04=(a04+a69);
  a69=(a48*a70);
  a04=(a04+a69);
  a69=(a55*a02);
  a04=(a04+a69);
  a69=(a60*a28);
  a34=(a45*a34);
  a69=(a69+a34);
  a36=(a39*a36);
  a69=(a69+a36);
  a36=(a16*a44);
  a69=(a69+a36);
  a36=(a73*a51);
  a69=(a69+a36);
  a36=(a06*a58);
  a69=(a69+a36);
  a36=(a59*a65);
  a69=(a69+a36);
  a36=(a46*a72);
  a69=(a69+a36);
  a36=(a74*a76);
  a69=(a69+a36);
  a69=(a08+a69);
  a36=(a62*a69);
  a04=(a04+a36);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a25=(a01*a25);
  a27=(a05*a27);
  a25=(a25+a27);
  a30=(a40*a30);
  a25=(a25+a30);
  a47=(a29*a47);
  a25=(a25+a47);
  a54=(a32*a54);
  a25=(a25+a54);
  a61=(a48*a61);
  a25=(a25+a61);
  a68=(a55*a68);
  a25=(a25+a68);
  a68=(a07*a69);
  a61=(a60*a08);
  a11=(a45*a11);
  a61=(a61+a11);
  a35=(a39*a35);
  a61=(a61+a35);
  a42=(a16*a42);
  a61=(a61+a42);
  a49=(a73*a49);
  a61=(a61+a49);
  a56=(a06*a56);
  a61=(a61+a56);
  a63=(a59*a63);
  a61=(a61+a63);
  a70=(a46*a70);
  a61=(a61+a70);
  a02=(a74*a02);
  a61=(a61+a02);
  a10=(a10+a61);
  a61=sin(a10);
  a68=(a68*a61);
  a02=(2.*a71);
  a02=(a02-a69);
  a68=(a68*a02);
  a60=(a60*a03);
  a45=(a45*a41);
  a60=(a60+a45);
  a39=(a39*a37);
  a60=(a60+a39);
  a16=(a16*a21);
  a60=(a60+a16);
  a73=(a73*a38);
  a60=(a60+a73);
  a06=(a06*a43);
  a60=(a60+a06);
  a59=(a59*a50);
  a60=(a60+a59);
  a46=(a46*a57);
  a60=(a60+a46);
  a74=(a74*a64);
  a60=(a60+a74);
  a00=(a00+a60);
  a60=cos(a00);
  a13=(a13*a60);
  a60=sin(a00);
  a15=(a15*a60);
  a13=(a13-a15);
  a15=(a07*a13);
  a68=(a68+a15);
  a12=(a12-a00);
  a12=(a12+a10);
  a12=sin(a12);
  a00=(a07*a12);
  a68=(a68-a00);
  a00=(a17*a13);
  a00=(a00*a20);
  a68=(a68+a00);
  a13=(2.*a13);
  a68=(a68+a13);
  a68=(a68/a20);
  a10=cos(a10);
  a20=(2.*a10);
  a20=(a17-a20);
  a20=(a20+a22);
  a14=(a14*a20);
  a20=(a17-a10);
  a20=(a20+a19);
  a23=(a23*a20);
  a14=(a14+a23);
  a14=(a14+a17);
  a14=(a14+a22);
  a14=(a14/a24);
  a24=(a68/a14);
  a19=(a10-a19);
  a07=(a07*a19);
  a07=(a07+a10);
  a26=(a26*a07);
  a14=(a26/a14);
  a71=casadi_sq(a71);
  a71=(a71*a61);
  a71=(a71-a12);
  a18=(a18*a71);
  a68=(a14*a68);
  a18=(a18+a68);
  a26=(a26*a14);
  a09=(a09-a26);
  a18=(a18/a09);
  a14=(a14*a18);
  a24=(a24+a14);
  a24=(a62*a24);
  a25=(a25+a24);
  a03=(a03-a25);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a28);
  a05=(a05*a44);
  a01=(a01+a05);
  a40=(a40*a51);
  a01=(a01+a40);
  a29=(a29*a58);
  a01=(a01+a29);
  a32=(a32*a65);
  a01=(a01+a32);
  a48=(a48*a72);
  a01=(a01+a48);
  a55=(a55*a76);
  a01=(a01+a55);
  a62=(a62*a18);
  a01=(a01+a62);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p[3])->(y_end[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+79, w1, *w2=w+83, *w3=w+86, w5, *w6=w+88, w7;
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
  casadi_real a12, a13;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00-a01);
  a03=arg[1]? arg[1][0] : 0;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[2]? arg[2][1] : 0;
  a03=casadi_sq(a02);
  a04=cos(a01);
  a05=arg[0]? arg[0][2] : 0;
  a06=(a04*a05);
  a07=arg[2]? arg[2][0] : 0;
  a06=(a06*a07);
  a08=(a03*a06);
  a09=(2.*a02);
  a10=(a09*a05);
  a08=(a08-a10);
  a10=arg[0]? arg[0][3] : 0;
  a10=(a02*a10);
  a08=(a08+a10);
  a10=(a02*a07);
  a11=(2.*a04);
  a12=(a11*a05);
  a10=(a10*a12);
  a08=(a08+a10);
  a10=(a02*a12);
  a08=(a08+a10);
  a08=(a08+a12);
  a08=(a08+a06);
  a06=1.;
  a12=(a02+a06);
  a12=casadi_sq(a12);
  a08=(a08/a12);
  a11=(a07-a11);
  a10=2.;
  a11=(a11+a10);
  a11=(a03*a11);
  a13=(a07-a04);
  a13=(a13+a06);
  a09=(a09*a13);
  a11=(a11+a09);
  a11=(a11+a07);
  a11=(a11+a10);
  a11=(a11/a12);
  a10=(a08/a11);
  a07=(a02/a12);
  a06=(a04-a06);
  a06=(a02*a06);
  a06=(a06+a04);
  a07=(a07*a06);
  a11=(a07/a11);
  a02=(a02*a05);
  a02=(a02/a12);
  a08=(a11*a08);
  a02=(a02-a08);
  a03=(a03/a12);
  a07=(a07*a11);
  a03=(a03-a07);
  a02=(a02/a03);
  a11=(a11*a02);
  a10=(a10-a11);
  a11=arg[1]? arg[1][1] : 0;
  a10=(a10-a11);
  if (res[0]!=0) res[0][1]=a10;
  a10=arg[1]? arg[1][2] : 0;
  a02=(a02-a10);
  if (res[0]!=0) res[0][2]=a02;
  a00=(2.*a00);
  a01=(a01-a00);
  if (res[0]!=0) res[0][3]=a01;
  return 0;
}

/* goswami_compass_residual_12:(u[4],p[3])->(R[4]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+537, *w1=w+541, *w2=w+544;
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
  if (sz_w) *sz_w = 548;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 548*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_24:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+2, *rr, *w0=w+419, *w1=w+435, *w2=w+439, *w3=w+442, *w4=w+458;
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
  casadi_real **res1=res+1, *w0=w+526, *w1=w+530, *w2=w+533;
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
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+537, *w1=w+541, *w2=w+544;
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
  if (sz_w) *sz_w = 548;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 548*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_jacobian_48:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+2, *rr, *w0=w+419, *w1=w+435, *w2=w+439, *w3=w+442, *w4=w+458;
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
  casadi_real **res1=res+1, *w0=w+526, *w1=w+530, *w2=w+533;
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
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+537, *w1=w+541, *w2=w+544;
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
  if (sz_w) *sz_w = 548;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 548*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_36:(u[4],p[3])->(R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_72:(u[4],p[3])->(R[4]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_96:(u[4],p[3])->(R[4]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_144:(u[4],p[3])->(R[4]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_192:(u[4],p[3])->(R[4]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_288:(u[4],p[3])->(R[4]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_residual_384:(u[4],p[3])->(R[4]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+119, *w1=w+123, *w2=w+126, *w3=w+129, w4, w5, w6, *w7=w+133;
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
  casadi_real **res1=res+2, *w0=w+419, *w1=w+423, *w2=w+426, *w3=w+442;
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
  casadi_real **res1=res+2, *rr, *w0=w+446, *w1=w+462, *w2=w+466, *w3=w+469, *w4=w+485;
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
  casadi_real **res1=res+1, *w0=w+553, *w1=w+557, *w2=w+560;
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
  casadi_real **res1=res+2, *rr, *w00=w+334, *w01=w+338, *w02=w+341, *w03=w+344, *w04=w+348, *w05=w+360, w06, w07, w08, *w09=w+376;
  casadi_real *w10=w+400;
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
  casadi_real **res1=res+3, *w0=w+564, *w1=w+568, *w2=w+571, *w3=w+575;
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
  if (sz_w) *sz_w = 591;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 591*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 157;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 157*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 416;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 416*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[4],phase[2],turns[2x12],h,p[3])->(y_end[4]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78;
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
  a12=(a12-a08);
  a09=(a09*a12);
  a12=arg[4]? arg[4][2] : 0;
  a13=sin(a12);
  a14=cos(a00);
  a14=(a13*a14);
  a15=cos(a12);
  a16=sin(a00);
  a16=(a15*a16);
  a14=(a14-a16);
  a16=(a07*a14);
  a09=(a09+a16);
  a16=(a12-a00);
  a16=(a16+a10);
  a16=sin(a16);
  a17=(a07*a16);
  a09=(a09-a17);
  a17=arg[4]? arg[4][0] : 0;
  a18=(a17*a14);
  a19=1.;
  a20=(a07+a19);
  a18=(a18*a20);
  a09=(a09+a18);
  a14=(2.*a14);
  a09=(a09+a14);
  a09=(a09/a20);
  a14=casadi_sq(a07);
  a18=cos(a10);
  a21=(2.*a18);
  a21=(a17-a21);
  a22=2.;
  a21=(a21+a22);
  a21=(a14*a21);
  a23=(2.*a07);
  a24=(a17-a18);
  a24=(a24+a19);
  a24=(a23*a24);
  a21=(a21+a24);
  a21=(a21+a17);
  a21=(a21+a22);
  a24=casadi_sq(a20);
  a21=(a21/a24);
  a25=(a09/a21);
  a26=(a07/a24);
  a27=(a18-a19);
  a27=(a07*a27);
  a27=(a27+a18);
  a27=(a26*a27);
  a21=(a27/a21);
  a18=(a07/a20);
  a28=casadi_sq(a03);
  a28=(a28*a11);
  a28=(a28-a16);
  a28=(a18*a28);
  a09=(a21*a09);
  a28=(a28+a09);
  a09=(a14/a24);
  a27=(a27*a21);
  a27=(a09-a27);
  a28=(a28/a27);
  a21=(a21*a28);
  a25=(a25+a21);
  a21=(a06*a25);
  a27=1.7082860872947386e-01;
  a27=(a27*a02);
  a16=2.9587585476806851e-02;
  a16=(a16*a02);
  a11=(a16*a28);
  a29=8.8762756430420545e-02;
  a29=(a29*a02);
  a30=1.9725056984537900e-02;
  a30=(a30*a02);
  a31=(a30*a25);
  a32=5.9175170953613701e-02;
  a32=(a32*a02);
  a33=5.2600151958767730e-02;
  a33=(a33*a02);
  a34=(a33*a28);
  a34=(a08+a34);
  a35=(a07*a34);
  a36=(a33*a08);
  a36=(a10+a36);
  a37=sin(a36);
  a35=(a35*a37);
  a38=(a33*a25);
  a38=(a03-a38);
  a39=(2.*a38);
  a39=(a39-a34);
  a35=(a35*a39);
  a33=(a33*a03);
  a33=(a00+a33);
  a39=cos(a33);
  a39=(a13*a39);
  a40=sin(a33);
  a40=(a15*a40);
  a39=(a39-a40);
  a40=(a07*a39);
  a35=(a35+a40);
  a33=(a12-a33);
  a33=(a33+a36);
  a33=sin(a33);
  a40=(a07*a33);
  a35=(a35-a40);
  a40=(a17*a39);
  a40=(a40*a20);
  a35=(a35+a40);
  a39=(2.*a39);
  a35=(a35+a39);
  a35=(a35/a20);
  a36=cos(a36);
  a39=(2.*a36);
  a39=(a17-a39);
  a39=(a39+a22);
  a39=(a14*a39);
  a40=(a17-a36);
  a40=(a40+a19);
  a40=(a23*a40);
  a39=(a39+a40);
  a39=(a39+a17);
  a39=(a39+a22);
  a39=(a39/a24);
  a40=(a35/a39);
  a41=(a36-a19);
  a41=(a07*a41);
  a41=(a41+a36);
  a41=(a26*a41);
  a39=(a41/a39);
  a36=casadi_sq(a38);
  a36=(a36*a37);
  a36=(a36-a33);
  a36=(a18*a36);
  a35=(a39*a35);
  a36=(a36+a35);
  a41=(a41*a39);
  a41=(a09-a41);
  a36=(a36/a41);
  a39=(a39*a36);
  a40=(a40+a39);
  a40=(a32*a40);
  a31=(a31+a40);
  a31=(a03-a31);
  a40=casadi_sq(a31);
  a39=(a30*a08);
  a34=(a32*a34);
  a39=(a39+a34);
  a39=(a10+a39);
  a34=sin(a39);
  a40=(a40*a34);
  a41=(a30*a03);
  a38=(a32*a38);
  a41=(a41+a38);
  a41=(a00+a41);
  a38=(a12-a41);
  a38=(a38+a39);
  a38=sin(a38);
  a40=(a40-a38);
  a40=(a18*a40);
  a39=cos(a39);
  a35=(a39-a19);
  a35=(a07*a35);
  a35=(a35+a39);
  a35=(a26*a35);
  a33=(2.*a39);
  a33=(a17-a33);
  a33=(a33+a22);
  a33=(a14*a33);
  a39=(a17-a39);
  a39=(a39+a19);
  a39=(a23*a39);
  a33=(a33+a39);
  a33=(a33+a17);
  a33=(a33+a22);
  a33=(a33/a24);
  a39=(a35/a33);
  a30=(a30*a28);
  a32=(a32*a36);
  a30=(a30+a32);
  a30=(a08+a30);
  a32=(a07*a30);
  a32=(a32*a34);
  a34=(2.*a31);
  a34=(a34-a30);
  a32=(a32*a34);
  a34=cos(a41);
  a34=(a13*a34);
  a41=sin(a41);
  a41=(a15*a41);
  a34=(a34-a41);
  a41=(a07*a34);
  a32=(a32+a41);
  a38=(a07*a38);
  a32=(a32-a38);
  a38=(a17*a34);
  a38=(a38*a20);
  a32=(a32+a38);
  a34=(2.*a34);
  a32=(a32+a34);
  a32=(a32/a20);
  a34=(a39*a32);
  a40=(a40+a34);
  a35=(a35*a39);
  a35=(a09-a35);
  a40=(a40/a35);
  a35=(a29*a40);
  a11=(a11+a35);
  a11=(a08+a11);
  a35=(a07*a11);
  a34=(a16*a08);
  a38=(a29*a30);
  a34=(a34+a38);
  a34=(a10+a34);
  a38=sin(a34);
  a35=(a35*a38);
  a41=(a16*a25);
  a32=(a32/a33);
  a39=(a39*a40);
  a32=(a32+a39);
  a39=(a29*a32);
  a41=(a41+a39);
  a41=(a03-a41);
  a39=(2.*a41);
  a39=(a39-a11);
  a35=(a35*a39);
  a16=(a16*a03);
  a29=(a29*a31);
  a16=(a16+a29);
  a16=(a00+a16);
  a29=cos(a16);
  a29=(a13*a29);
  a39=sin(a16);
  a39=(a15*a39);
  a29=(a29-a39);
  a39=(a07*a29);
  a35=(a35+a39);
  a16=(a12-a16);
  a16=(a16+a34);
  a16=sin(a16);
  a39=(a07*a16);
  a35=(a35-a39);
  a39=(a17*a29);
  a39=(a39*a20);
  a35=(a35+a39);
  a29=(2.*a29);
  a35=(a35+a29);
  a35=(a35/a20);
  a34=cos(a34);
  a29=(2.*a34);
  a29=(a17-a29);
  a29=(a29+a22);
  a29=(a14*a29);
  a39=(a17-a34);
  a39=(a39+a19);
  a39=(a23*a39);
  a29=(a29+a39);
  a29=(a29+a17);
  a29=(a29+a22);
  a29=(a29/a24);
  a39=(a35/a29);
  a33=(a34-a19);
  a33=(a07*a33);
  a33=(a33+a34);
  a33=(a26*a33);
  a29=(a33/a29);
  a34=casadi_sq(a41);
  a34=(a34*a38);
  a34=(a34-a16);
  a34=(a18*a34);
  a35=(a29*a35);
  a34=(a34+a35);
  a33=(a33*a29);
  a33=(a09-a33);
  a34=(a34/a33);
  a29=(a29*a34);
  a39=(a39+a29);
  a29=(a27*a39);
  a21=(a21+a29);
  a29=1.2546768756682242e-01;
  a29=(a29*a02);
  a33=2.4136513415926669e-01;
  a33=(a33*a02);
  a35=(a33*a28);
  a16=-8.8454947932828609e-01;
  a16=(a16*a02);
  a40=(a16*a40);
  a35=(a35+a40);
  a40=9.2483400326179199e-01;
  a40=(a40*a02);
  a38=(a40*a34);
  a35=(a35+a38);
  a35=(a08+a35);
  a38=(a07*a35);
  a36=(a33*a08);
  a30=(a16*a30);
  a36=(a36+a30);
  a30=(a40*a11);
  a36=(a36+a30);
  a36=(a10+a36);
  a30=sin(a36);
  a38=(a38*a30);
  a37=(a33*a25);
  a32=(a16*a32);
  a37=(a37+a32);
  a32=(a40*a39);
  a37=(a37+a32);
  a37=(a03-a37);
  a32=(2.*a37);
  a32=(a32-a35);
  a38=(a38*a32);
  a33=(a33*a03);
  a16=(a16*a31);
  a33=(a33+a16);
  a40=(a40*a41);
  a33=(a33+a40);
  a33=(a00+a33);
  a40=cos(a33);
  a40=(a13*a40);
  a16=sin(a33);
  a16=(a15*a16);
  a40=(a40-a16);
  a16=(a07*a40);
  a38=(a38+a16);
  a33=(a12-a33);
  a33=(a33+a36);
  a33=sin(a33);
  a16=(a07*a33);
  a38=(a38-a16);
  a16=(a17*a40);
  a16=(a16*a20);
  a38=(a38+a16);
  a40=(2.*a40);
  a38=(a38+a40);
  a38=(a38/a20);
  a36=cos(a36);
  a40=(2.*a36);
  a40=(a17-a40);
  a40=(a40+a22);
  a40=(a14*a40);
  a16=(a17-a36);
  a16=(a16+a19);
  a16=(a23*a16);
  a40=(a40+a16);
  a40=(a40+a17);
  a40=(a40+a22);
  a40=(a40/a24);
  a16=(a38/a40);
  a31=(a36-a19);
  a31=(a07*a31);
  a31=(a31+a36);
  a31=(a26*a31);
  a40=(a31/a40);
  a36=casadi_sq(a37);
  a36=(a36*a30);
  a36=(a36-a33);
  a36=(a18*a36);
  a38=(a40*a38);
  a36=(a36+a38);
  a31=(a31*a40);
  a31=(a09-a31);
  a36=(a36/a31);
  a40=(a40*a36);
  a16=(a16+a40);
  a40=(a29*a16);
  a21=(a21+a40);
  a21=(a03-a21);
  a40=(a05*a21);
  a04=(a04+a40);
  a40=1.8915178993145003e+00;
  a40=(a40*a02);
  a31=3.7109375000000000e-02;
  a31=(a31*a02);
  a38=(a31*a25);
  a33=1.7025221101954405e-01;
  a33=(a33*a02);
  a30=(a33*a39);
  a38=(a38+a30);
  a30=6.0216538980455959e-02;
  a30=(a30*a02);
  a32=(a30*a16);
  a38=(a38+a32);
  a32=-1.7578125000000000e-02;
  a32=(a32*a02);
  a42=(a06*a28);
  a43=(a27*a34);
  a42=(a42+a43);
  a43=(a29*a36);
  a42=(a42+a43);
  a42=(a08+a42);
  a43=(a07*a42);
  a44=(a06*a08);
  a45=(a27*a11);
  a44=(a44+a45);
  a45=(a29*a35);
  a44=(a44+a45);
  a44=(a10+a44);
  a45=sin(a44);
  a43=(a43*a45);
  a46=(2.*a21);
  a46=(a46-a42);
  a43=(a43*a46);
  a06=(a06*a03);
  a27=(a27*a41);
  a06=(a06+a27);
  a29=(a29*a37);
  a06=(a06+a29);
  a06=(a00+a06);
  a29=cos(a06);
  a29=(a13*a29);
  a27=sin(a06);
  a27=(a15*a27);
  a29=(a29-a27);
  a27=(a07*a29);
  a43=(a43+a27);
  a06=(a12-a06);
  a06=(a06+a44);
  a06=sin(a06);
  a27=(a07*a06);
  a43=(a43-a27);
  a27=(a17*a29);
  a27=(a27*a20);
  a43=(a43+a27);
  a29=(2.*a29);
  a43=(a43+a29);
  a43=(a43/a20);
  a44=cos(a44);
  a29=(2.*a44);
  a29=(a17-a29);
  a29=(a29+a22);
  a29=(a14*a29);
  a27=(a17-a44);
  a27=(a27+a19);
  a27=(a23*a27);
  a29=(a29+a27);
  a29=(a29+a17);
  a29=(a29+a22);
  a29=(a29/a24);
  a27=(a43/a29);
  a46=(a44-a19);
  a46=(a07*a46);
  a46=(a46+a44);
  a46=(a26*a46);
  a29=(a46/a29);
  a44=casadi_sq(a21);
  a44=(a44*a45);
  a44=(a44-a06);
  a44=(a18*a44);
  a43=(a29*a43);
  a44=(a44+a43);
  a46=(a46*a29);
  a46=(a09-a46);
  a44=(a44/a46);
  a29=(a29*a44);
  a27=(a27+a29);
  a29=(a32*a27);
  a38=(a38+a29);
  a38=(a03-a38);
  a29=(a40*a38);
  a04=(a04+a29);
  a29=-5.8012039600105849e+00;
  a29=(a29*a02);
  a46=3.7092000118504789e-02;
  a46=(a46*a02);
  a43=(a46*a25);
  a06=1.7038392571223998e-01;
  a06=(a06*a02);
  a45=(a06*a39);
  a43=(a43+a45);
  a45=1.0726203044637328e-01;
  a45=(a45*a02);
  a47=(a45*a16);
  a43=(a43+a47);
  a47=-1.5319437748624402e-02;
  a47=(a47*a02);
  a48=(a47*a27);
  a43=(a43+a48);
  a48=8.2737891638140233e-03;
  a48=(a48*a02);
  a49=(a31*a28);
  a50=(a33*a34);
  a49=(a49+a50);
  a50=(a30*a36);
  a49=(a49+a50);
  a50=(a32*a44);
  a49=(a49+a50);
  a49=(a08+a49);
  a50=(a07*a49);
  a51=(a31*a08);
  a52=(a33*a11);
  a51=(a51+a52);
  a52=(a30*a35);
  a51=(a51+a52);
  a52=(a32*a42);
  a51=(a51+a52);
  a51=(a10+a51);
  a52=sin(a51);
  a50=(a50*a52);
  a53=(2.*a38);
  a53=(a53-a49);
  a50=(a50*a53);
  a31=(a31*a03);
  a33=(a33*a41);
  a31=(a31+a33);
  a30=(a30*a37);
  a31=(a31+a30);
  a32=(a32*a21);
  a31=(a31+a32);
  a31=(a00+a31);
  a32=cos(a31);
  a32=(a13*a32);
  a30=sin(a31);
  a30=(a15*a30);
  a32=(a32-a30);
  a30=(a07*a32);
  a50=(a50+a30);
  a31=(a12-a31);
  a31=(a31+a51);
  a31=sin(a31);
  a30=(a07*a31);
  a50=(a50-a30);
  a30=(a17*a32);
  a30=(a30*a20);
  a50=(a50+a30);
  a32=(2.*a32);
  a50=(a50+a32);
  a50=(a50/a20);
  a51=cos(a51);
  a32=(2.*a51);
  a32=(a17-a32);
  a32=(a32+a22);
  a32=(a14*a32);
  a30=(a17-a51);
  a30=(a30+a19);
  a30=(a23*a30);
  a32=(a32+a30);
  a32=(a32+a17);
  a32=(a32+a22);
  a32=(a32/a24);
  a30=(a50/a32);
  a33=(a51-a19);
  a33=(a07*a33);
  a33=(a33+a51);
  a33=(a26*a33);
  a32=(a33/a32);
  a51=casadi_sq(a38);
  a51=(a51*a52);
  a51=(a51-a31);
  a51=(a18*a51);
  a50=(a32*a50);
  a51=(a51+a50);
  a33=(a33*a32);
  a33=(a09-a33);
  a51=(a51/a33);
  a32=(a32*a51);
  a30=(a30+a32);
  a32=(a48*a30);
  a43=(a43+a32);
  a43=(a03-a43);
  a32=(a29*a43);
  a04=(a04+a32);
  a32=3.1116436695781990e-01;
  a32=(a32*a02);
  a33=6.2411095871607569e-01;
  a33=(a33*a02);
  a50=(a33*a25);
  a31=-3.3608926294469414e+00;
  a31=(a31*a02);
  a52=(a31*a39);
  a50=(a50+a52);
  a52=-8.6821934684172597e-01;
  a52=(a52*a02);
  a53=(a52*a16);
  a50=(a50+a53);
  a53=2.7592099699446710e+01;
  a53=(a53*a02);
  a54=(a53*a27);
  a50=(a50+a54);
  a54=2.0154067550477894e+01;
  a54=(a54*a02);
  a55=(a54*a30);
  a50=(a50+a55);
  a55=-4.3489884181069961e+01;
  a55=(a55*a02);
  a56=(a46*a28);
  a57=(a06*a34);
  a56=(a56+a57);
  a57=(a45*a36);
  a56=(a56+a57);
  a57=(a47*a44);
  a56=(a56+a57);
  a57=(a48*a51);
  a56=(a56+a57);
  a56=(a08+a56);
  a57=(a07*a56);
  a58=(a46*a08);
  a59=(a06*a11);
  a58=(a58+a59);
  a59=(a45*a35);
  a58=(a58+a59);
  a59=(a47*a42);
  a58=(a58+a59);
  a59=(a48*a49);
  a58=(a58+a59);
  a58=(a10+a58);
  a59=sin(a58);
  a57=(a57*a59);
  a60=(2.*a43);
  a60=(a60-a56);
  a57=(a57*a60);
  a46=(a46*a03);
  a06=(a06*a41);
  a46=(a46+a06);
  a45=(a45*a37);
  a46=(a46+a45);
  a47=(a47*a21);
  a46=(a46+a47);
  a48=(a48*a38);
  a46=(a46+a48);
  a46=(a00+a46);
  a48=cos(a46);
  a48=(a13*a48);
  a47=sin(a46);
  a47=(a15*a47);
  a48=(a48-a47);
  a47=(a07*a48);
  a57=(a57+a47);
  a46=(a12-a46);
  a46=(a46+a58);
  a46=sin(a46);
  a47=(a07*a46);
  a57=(a57-a47);
  a47=(a17*a48);
  a47=(a47*a20);
  a57=(a57+a47);
  a48=(2.*a48);
  a57=(a57+a48);
  a57=(a57/a20);
  a58=cos(a58);
  a48=(2.*a58);
  a48=(a17-a48);
  a48=(a48+a22);
  a48=(a14*a48);
  a47=(a17-a58);
  a47=(a47+a19);
  a47=(a23*a47);
  a48=(a48+a47);
  a48=(a48+a17);
  a48=(a48+a22);
  a48=(a48/a24);
  a47=(a57/a48);
  a45=(a58-a19);
  a45=(a07*a45);
  a45=(a45+a58);
  a45=(a26*a45);
  a48=(a45/a48);
  a58=casadi_sq(a43);
  a58=(a58*a59);
  a58=(a58-a46);
  a58=(a18*a58);
  a57=(a48*a57);
  a58=(a58+a57);
  a45=(a45*a48);
  a45=(a09-a45);
  a58=(a58/a45);
  a48=(a48*a58);
  a47=(a47+a48);
  a48=(a55*a47);
  a50=(a50+a48);
  a50=(a03-a50);
  a48=(a32*a50);
  a04=(a04+a48);
  a48=-1.5216094966251609e-01;
  a48=(a48*a02);
  a45=4.7766253643826434e-01;
  a45=(a45*a02);
  a57=(a45*a25);
  a46=-2.4881146199716677e+00;
  a46=(a46*a02);
  a59=(a46*a39);
  a57=(a57+a59);
  a59=-5.9029082683684297e-01;
  a59=(a59*a02);
  a06=(a59*a16);
  a57=(a57+a06);
  a06=2.1230051448181193e+01;
  a06=(a06*a02);
  a60=(a06*a27);
  a57=(a57+a60);
  a60=1.5279233632882423e+01;
  a60=(a60*a02);
  a61=(a60*a30);
  a57=(a57+a61);
  a61=-3.3288210968984863e+01;
  a61=(a61*a02);
  a62=(a61*a47);
  a57=(a57+a62);
  a62=-2.0331201708508627e-02;
  a62=(a62*a02);
  a63=(a33*a28);
  a64=(a31*a34);
  a63=(a63+a64);
  a64=(a52*a36);
  a63=(a63+a64);
  a64=(a53*a44);
  a63=(a63+a64);
  a64=(a54*a51);
  a63=(a63+a64);
  a64=(a55*a58);
  a63=(a63+a64);
  a63=(a08+a63);
  a64=(a07*a63);
  a65=(a33*a08);
  a66=(a31*a11);
  a65=(a65+a66);
  a66=(a52*a35);
  a65=(a65+a66);
  a66=(a53*a42);
  a65=(a65+a66);
  a66=(a54*a49);
  a65=(a65+a66);
  a66=(a55*a56);
  a65=(a65+a66);
  a65=(a10+a65);
  a66=sin(a65);
  a64=(a64*a66);
  a67=(2.*a50);
  a67=(a67-a63);
  a64=(a64*a67);
  a33=(a33*a03);
  a31=(a31*a41);
  a33=(a33+a31);
  a52=(a52*a37);
  a33=(a33+a52);
  a53=(a53*a21);
  a33=(a33+a53);
  a54=(a54*a38);
  a33=(a33+a54);
  a55=(a55*a43);
  a33=(a33+a55);
  a33=(a00+a33);
  a55=cos(a33);
  a55=(a13*a55);
  a54=sin(a33);
  a54=(a15*a54);
  a55=(a55-a54);
  a54=(a07*a55);
  a64=(a64+a54);
  a33=(a12-a33);
  a33=(a33+a65);
  a33=sin(a33);
  a54=(a07*a33);
  a64=(a64-a54);
  a54=(a17*a55);
  a54=(a54*a20);
  a64=(a64+a54);
  a55=(2.*a55);
  a64=(a64+a55);
  a64=(a64/a20);
  a65=cos(a65);
  a55=(2.*a65);
  a55=(a17-a55);
  a55=(a55+a22);
  a55=(a14*a55);
  a54=(a17-a65);
  a54=(a54+a19);
  a54=(a23*a54);
  a55=(a55+a54);
  a55=(a55+a17);
  a55=(a55+a22);
  a55=(a55/a24);
  a54=(a64/a55);
  a53=(a65-a19);
  a53=(a07*a53);
  a53=(a53+a65);
  a53=(a26*a53);
  a55=(a53/a55);
  a65=casadi_sq(a50);
  a65=(a65*a66);
  a65=(a65-a33);
  a65=(a18*a65);
  a64=(a55*a64);
  a65=(a65+a64);
  a53=(a53*a55);
  a53=(a09-a53);
  a65=(a65/a53);
  a55=(a55*a65);
  a54=(a54+a55);
  a55=(a62*a54);
  a57=(a57+a55);
  a57=(a03-a57);
  a55=(a48*a57);
  a04=(a04+a55);
  a55=2.0136540080403034e-01;
  a55=(a55*a02);
  a53=-9.3714243008598730e-01;
  a53=(a53*a02);
  a64=(a53*a25);
  a33=5.1863724288440638e+00;
  a33=(a33*a02);
  a66=(a33*a39);
  a64=(a64+a66);
  a66=1.0914373489967295e+00;
  a66=(a66*a02);
  a52=(a66*a16);
  a64=(a64+a52);
  a52=-8.1497870107469268e+00;
  a52=(a52*a02);
  a31=(a52*a27);
  a64=(a64+a31);
  a31=-1.8520065659996959e+01;
  a31=(a31*a02);
  a67=(a31*a30);
  a64=(a64+a67);
  a67=2.2739487099350505e+01;
  a67=(a67*a02);
  a68=(a67*a47);
  a64=(a64+a68);
  a68=2.4936055526796523e+00;
  a68=(a68*a02);
  a69=(a68*a54);
  a64=(a64+a69);
  a69=-3.0467644718982196e+00;
  a69=(a69*a02);
  a70=(a45*a28);
  a71=(a46*a34);
  a70=(a70+a71);
  a71=(a59*a36);
  a70=(a70+a71);
  a71=(a06*a44);
  a70=(a70+a71);
  a71=(a60*a51);
  a70=(a70+a71);
  a71=(a61*a58);
  a70=(a70+a71);
  a71=(a62*a65);
  a70=(a70+a71);
  a70=(a08+a70);
  a71=(a07*a70);
  a72=(a45*a08);
  a73=(a46*a11);
  a72=(a72+a73);
  a73=(a59*a35);
  a72=(a72+a73);
  a73=(a06*a42);
  a72=(a72+a73);
  a73=(a60*a49);
  a72=(a72+a73);
  a73=(a61*a56);
  a72=(a72+a73);
  a73=(a62*a63);
  a72=(a72+a73);
  a72=(a10+a72);
  a73=sin(a72);
  a71=(a71*a73);
  a74=(2.*a57);
  a74=(a74-a70);
  a71=(a71*a74);
  a45=(a45*a03);
  a46=(a46*a41);
  a45=(a45+a46);
  a59=(a59*a37);
  a45=(a45+a59);
  a06=(a06*a21);
  a45=(a45+a06);
  a60=(a60*a38);
  a45=(a45+a60);
  a61=(a61*a43);
  a45=(a45+a61);
  a62=(a62*a50);
  a45=(a45+a62);
  a45=(a00+a45);
  a62=cos(a45);
  a62=(a13*a62);
  a61=sin(a45);
  a61=(a15*a61);
  a62=(a62-a61);
  a61=(a07*a62);
  a71=(a71+a61);
  a45=(a12-a45);
  a45=(a45+a72);
  a45=sin(a45);
  a61=(a07*a45);
  a71=(a71-a61);
  a61=(a17*a62);
  a61=(a61*a20);
  a71=(a71+a61);
  a62=(2.*a62);
  a71=(a71+a62);
  a71=(a71/a20);
  a72=cos(a72);
  a62=(2.*a72);
  a62=(a17-a62);
  a62=(a62+a22);
  a62=(a14*a62);
  a61=(a17-a72);
  a61=(a61+a19);
  a61=(a23*a61);
  a62=(a62+a61);
  a62=(a62+a17);
  a62=(a62+a22);
  a62=(a62/a24);
  a61=(a71/a62);
  a60=(a72-a19);
  a60=(a07*a60);
  a60=(a60+a72);
  a60=(a26*a60);
  a62=(a60/a62);
  a72=casadi_sq(a57);
  a72=(a72*a73);
  a72=(a72-a45);
  a72=(a18*a72);
  a71=(a62*a71);
  a72=(a72+a71);
  a60=(a60*a62);
  a60=(a09-a60);
  a72=(a72/a60);
  a62=(a62*a72);
  a61=(a61+a62);
  a62=(a69*a61);
  a64=(a64+a62);
  a64=(a03-a64);
  a62=(a55*a64);
  a04=(a04+a62);
  a62=4.4710615727772587e-02;
  a62=(a62*a02);
  a60=2.2733101475165380e+00;
  a60=(a60*a02);
  a71=(a60*a25);
  a45=-1.0534495466737249e+01;
  a45=(a45*a02);
  a39=(a45*a39);
  a71=(a71+a39);
  a39=-2.0008720582248625e+00;
  a39=(a39*a02);
  a16=(a39*a16);
  a71=(a71+a16);
  a16=-1.7958931863118799e+01;
  a16=(a16*a02);
  a73=(a16*a27);
  a71=(a71+a73);
  a73=2.7948884529419960e+01;
  a73=(a73*a02);
  a06=(a73*a30);
  a71=(a71+a06);
  a06=-2.8589982771350235e+00;
  a06=(a06*a02);
  a59=(a06*a47);
  a71=(a71+a59);
  a59=-8.8728569335306293e+00;
  a59=(a59*a02);
  a46=(a59*a54);
  a71=(a71+a46);
  a46=1.2360567175794303e+01;
  a46=(a46*a02);
  a74=(a46*a61);
  a71=(a71+a74);
  a74=6.4339274601576357e-01;
  a74=(a74*a02);
  a02=(a53*a28);
  a75=(a33*a34);
  a02=(a02+a75);
  a75=(a66*a36);
  a02=(a02+a75);
  a75=(a52*a44);
  a02=(a02+a75);
  a75=(a31*a51);
  a02=(a02+a75);
  a75=(a67*a58);
  a02=(a02+a75);
  a75=(a68*a65);
  a02=(a02+a75);
  a75=(a69*a72);
  a02=(a02+a75);
  a02=(a08+a02);
  a75=(a07*a02);
  a76=(a53*a08);
  a77=(a33*a11);
  a76=(a76+a77);
  a77=(a66*a35);
  a76=(a76+a77);
  a77=(a52*a42);
  a76=(a76+a77);
  a77=(a31*a49);
  a76=(a76+a77);
  a77=(a67*a56);
  a76=(a76+a77);
  a77=(a68*a63);
  a76=(a76+a77);
  a77=(a69*a70);
  a76=(a76+a77);
  a76=(a10+a76);
  a77=sin(a76);
  a75=(a75*a77);
  a78=(2.*a64);
  a78=(a78-a02);
  a75=(a75*a78);
  a53=(a53*a03);
  a33=(a33*a41);
  a53=(a53+a33);
  a66=(a66*a37);
  a53=(a53+a66);
  a52=(a52*a21);
  a53=(a53+a52);
  a31=(a31*a38);
  a53=(a53+a31);
  a67=(a67*a43);
  a53=(a53+a67);
  a68=(a68*a50);
  a53=(a53+a68);
  a69=(a69*a57);
  a53=(a53+a69);
  a53=(a00+a53);
  a69=cos(a53);
  a69=(a13*a69);
  a68=sin(a53);
  a68=(a15*a68);
  a69=(a69-a68);
  a68=(a07*a69);
  a75=(a75+a68);
  a53=(a12-a53);
  a53=(a53+a76);
  a53=sin(a53);
  a68=(a07*a53);
  a75=(a75-a68);
  a68=(a17*a69);
  a68=(a68*a20);
  a75=(a75+a68);
  a69=(2.*a69);
  a75=(a75+a69);
  a75=(a75/a20);
  a76=cos(a76);
  a69=(2.*a76);
  a69=(a17-a69);
  a69=(a69+a22);
  a69=(a14*a69);
  a68=(a17-a76);
  a68=(a68+a19);
  a68=(a23*a68);
  a69=(a69+a68);
  a69=(a69+a17);
  a69=(a69+a22);
  a69=(a69/a24);
  a68=(a75/a69);
  a67=(a76-a19);
  a67=(a07*a67);
  a67=(a67+a76);
  a67=(a26*a67);
  a69=(a67/a69);
  a76=casadi_sq(a64);
  a76=(a76*a77);
  a76=(a76-a53);
  a76=(a18*a76);
  a75=(a69*a75);
  a76=(a76+a75);
  a67=(a67*a69);
  a67=(a09-a67);
  a76=(a76/a67);
  a69=(a69*a76);
  a68=(a68+a69);
  a69=(a74*a68);
  a71=(a71+a69);
  a71=(a03-a71);
  a69=(a62*a71);
  a04=(a04+a69);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a69=(a05*a42);
  a04=(a04+a69);
  a69=(a40*a49);
  a04=(a04+a69);
  a69=(a29*a56);
  a04=(a04+a69);
  a69=(a32*a63);
  a04=(a04+a69);
  a69=(a48*a70);
  a04=(a04+a69);
  a69=(a55*a02);
  a04=(a04+a69);
  a69=(a60*a28);
  a34=(a45*a34);
  a69=(a69+a34);
  a36=(a39*a36);
  a69=(a69+a36);
  a36=(a16*a44);
  a69=(a69+a36);
  a36=(a73*a51);
  a69=(a69+a36);
  a36=(a06*a58);
  a69=(a69+a36);
  a36=(a59*a65);
  a69=(a69+a36);
  a36=(a46*a72);
  a69=(a69+a36);
  a36=(a74*a76);
  a69=(a69+a36);
  a69=(a08+a69);
  a36=(a62*a69);
  a04=(a04+a36);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a25=(a01*a25);
  a27=(a05*a27);
  a25=(a25+a27);
  a30=(a40*a30);
  a25=(a25+a30);
  a47=(a29*a47);
  a25=(a25+a47);
  a54=(a32*a54);
  a25=(a25+a54);
  a61=(a48*a61);
  a25=(a25+a61);
  a68=(a55*a68);
  a25=(a25+a68);
  a68=(a07*a69);
  a61=(a60*a08);
  a11=(a45*a11);
  a61=(a61+a11);
  a35=(a39*a35);
  a61=(a61+a35);
  a42=(a16*a42);
  a61=(a61+a42);
  a49=(a73*a49);
  a61=(a61+a49);
  a56=(a06*a56);
  a61=(a61+a56);
  a63=(a59*a63);
  a61=(a61+a63);
  a70=(a46*a70);
  a61=(a61+a70);
  a02=(a74*a02);
  a61=(a61+a02);
  a10=(a10+a61);
  a61=sin(a10);
  a68=(a68*a61);
  a02=(2.*a71);
  a02=(a02-a69);
  a68=(a68*a02);
  a60=(a60*a03);
  a45=(a45*a41);
  a60=(a60+a45);
  a39=(a39*a37);
  a60=(a60+a39);
  a16=(a16*a21);
  a60=(a60+a16);
  a73=(a73*a38);
  a60=(a60+a73);
  a06=(a06*a43);
  a60=(a60+a06);
  a59=(a59*a50);
  a60=(a60+a59);
  a46=(a46*a57);
  a60=(a60+a46);
  a74=(a74*a64);
  a60=(a60+a74);
  a00=(a00+a60);
  a60=cos(a00);
  a13=(a13*a60);
  a60=sin(a00);
  a15=(a15*a60);
  a13=(a13-a15);
  a15=(a07*a13);
  a68=(a68+a15);
  a12=(a12-a00);
  a12=(a12+a10);
  a12=sin(a12);
  a00=(a07*a12);
  a68=(a68-a00);
  a00=(a17*a13);
  a00=(a00*a20);
  a68=(a68+a00);
  a13=(2.*a13);
  a68=(a68+a13);
  a68=(a68/a20);
  a10=cos(a10);
  a20=(2.*a10);
  a20=(a17-a20);
  a20=(a20+a22);
  a14=(a14*a20);
  a20=(a17-a10);
  a20=(a20+a19);
  a23=(a23*a20);
  a14=(a14+a23);
  a14=(a14+a17);
  a14=(a14+a22);
  a14=(a14/a24);
  a24=(a68/a14);
  a19=(a10-a19);
  a07=(a07*a19);
  a07=(a07+a10);
  a26=(a26*a07);
  a14=(a26/a14);
  a71=casadi_sq(a71);
  a71=(a71*a61);
  a71=(a71-a12);
  a18=(a18*a71);
  a68=(a14*a68);
  a18=(a18+a68);
  a26=(a26*a14);
  a09=(a09-a26);
  a18=(a18/a09);
  a14=(a14*a18);
  a24=(a24+a14);
  a24=(a62*a24);
  a25=(a25+a24);
  a03=(a03-a25);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a28);
  a05=(a05*a44);
  a01=(a01+a05);
  a40=(a40*a51);
  a01=(a01+a40);
  a29=(a29*a58);
  a01=(a01+a29);
  a32=(a32*a65);
  a01=(a01+a32);
  a48=(a48*a72);
  a01=(a01+a48);
  a55=(a55*a76);
  a01=(a01+a55);
  a62=(a62*a18);
  a01=(a01+a62);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* observe:(t,y[4],p[3])->(g[8],dg[8]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55;
  a00=arg[2]? arg[2][0] : 0;
  a01=arg[1]? arg[1][0] : 0;
  a02=sin(a01);
  a03=(a00*a02);
  a04=arg[2]? arg[2][1] : 0;
  a05=arg[1]? arg[1][1] : 0;
  a06=(a01-a05);
  a07=sin(a06);
  a08=(a04*a07);
  a09=1.;
  a10=(a04+a09);
  a08=(a08/a10);
  a03=(a03-a08);
  a08=(a04/a10);
  a11=(a09-a08);
  a12=(a02*a11);
  a03=(a03+a12);
  a03=(a03+a02);
  a12=2.;
  a13=(a00+a12);
  a03=(a03/a13);
  a14=cos(a01);
  a15=(a14*a00);
  a06=cos(a06);
  a16=(a04*a06);
  a16=(a16/a10);
  a15=(a15-a16);
  a16=(a14*a11);
  a15=(a15+a16);
  a15=(a15+a14);
  a15=(a15/a13);
  a16=arg[1]? arg[1][2] : 0;
  a17=(2.*a16);
  a18=arg[1]? arg[1][3] : 0;
  a19=(a17*a18);
  a20=(a19*a07);
  a21=(a04*a18);
  a22=sin(a05);
  a23=(a21*a22);
  a24=(a17-a18);
  a25=(a23*a24);
  a26=arg[2]? arg[2][2] : 0;
  a27=(a26-a01);
  a28=sin(a27);
  a29=(a04*a28);
  a25=(a25+a29);
  a29=(a27+a05);
  a30=sin(a29);
  a31=(a04*a30);
  a25=(a25-a31);
  a31=(a00*a28);
  a31=(a31*a10);
  a25=(a25+a31);
  a28=(2.*a28);
  a25=(a25+a28);
  a25=(a25/a10);
  a28=casadi_sq(a04);
  a31=cos(a05);
  a32=(2.*a31);
  a32=(a00-a32);
  a32=(a32+a12);
  a32=(a28*a32);
  a33=(2.*a04);
  a34=(a00-a31);
  a34=(a34+a09);
  a34=(a33*a34);
  a32=(a32+a34);
  a32=(a32+a00);
  a32=(a32+a12);
  a12=casadi_sq(a10);
  a32=(a32/a12);
  a34=(a25/a32);
  a35=(a04/a12);
  a09=(a31-a09);
  a09=(a04*a09);
  a09=(a09+a31);
  a09=(a35*a09);
  a36=(a09/a32);
  a37=casadi_sq(a16);
  a38=(a37*a22);
  a38=(a38-a30);
  a38=(a08*a38);
  a30=(a36*a25);
  a38=(a38+a30);
  a30=(a28/a12);
  a39=(a09*a36);
  a30=(a30-a39);
  a38=(a38/a30);
  a39=(a36*a38);
  a39=(a34+a39);
  a40=(a39*a14);
  a41=(a39*a06);
  a41=(a40+a41);
  a42=(a38*a06);
  a41=(a41+a42);
  a42=(a37*a02);
  a41=(a41+a42);
  a42=(a37*a07);
  a41=(a41+a42);
  a20=(a20-a41);
  a41=casadi_sq(a18);
  a42=(a41*a07);
  a20=(a20-a42);
  a20=(a08*a20);
  a40=(a40*a00);
  a20=(a20+a40);
  a40=(-a39);
  a42=(2.*a40);
  a43=(a42*a14);
  a20=(a20-a43);
  a43=(a37*a00);
  a44=(a43*a02);
  a20=(a20+a44);
  a44=(a17*a16);
  a45=(a44*a02);
  a20=(a20+a45);
  a45=sin(a26);
  a46=(a00*a45);
  a20=(a20-a46);
  a45=(2.*a45);
  a20=(a20-a45);
  a45=(a15*a20);
  a46=(a06*a16);
  a47=(a46*a16);
  a48=(a39*a02);
  a49=(a39*a07);
  a48=(a48+a49);
  a49=(a38*a07);
  a48=(a48+a49);
  a47=(a47-a48);
  a48=(2.*a06);
  a49=(a48*a16);
  a50=(a49*a18);
  a47=(a47-a50);
  a50=(a06*a18);
  a51=(a50*a18);
  a47=(a47+a51);
  a51=(a14*a16);
  a52=(a51*a16);
  a47=(a47+a52);
  a47=(a08*a47);
  a53=(a39*a00);
  a54=(a53*a02);
  a47=(a47+a54);
  a54=(a42*a02);
  a47=(a47-a54);
  a26=cos(a26);
  a54=(a26*a00);
  a47=(a47+a54);
  a26=(2.*a26);
  a47=(a47+a26);
  a26=(a00*a52);
  a47=(a47-a26);
  a52=(2.*a52);
  a47=(a47-a52);
  a45=(a45/a47);
  a03=(a03+a45);
  if (res[0]!=0) res[0][0]=a03;
  a03=0.;
  if (res[0]!=0) res[0][1]=a03;
  if (res[0]!=0) res[0][2]=a47;
  a52=(a20/a47);
  if (res[0]!=0) res[0][3]=a52;
  a26=(a14-a06);
  if (res[0]!=0) res[0][4]=a26;
  if (res[0]!=0) res[0][5]=a40;
  a01=(2.*a01);
  a05=(a05-a01);
  if (res[0]!=0) res[0][6]=a05;
  if (res[0]!=0) res[0][7]=a03;
  a05=(a00*a51);
  a01=(a16-a18);
  a40=(a06*a01);
  a26=(a04*a40);
  a26=(a26/a10);
  a05=(a05-a26);
  a26=(a11*a51);
  a05=(a05+a26);
  a05=(a05+a51);
  a05=(a05/a13);
  a01=(a07*a01);
  a26=(a04*a01);
  a26=(a26/a10);
  a54=(a02*a16);
  a55=(a00*a54);
  a26=(a26-a55);
  a11=(a11*a54);
  a26=(a26-a11);
  a26=(a26-a54);
  a26=(a26/a13);
  a20=(a20*a26);
  a26=(a18*a42);
  a13=(a17*a38);
  a26=(a26+a13);
  a26=(a07*a26);
  a19=(a19*a40);
  a26=(a26+a19);
  a19=(a04*a38);
  a19=(a22*a19);
  a31=(a31*a18);
  a21=(a21*a31);
  a19=(a19+a21);
  a24=(a24*a19);
  a19=(a42-a38);
  a23=(a23*a19);
  a24=(a24+a23);
  a27=cos(a27);
  a27=(a27*a16);
  a23=(a04*a27);
  a24=(a24-a23);
  a29=cos(a29);
  a23=(a18-a16);
  a29=(a29*a23);
  a23=(a04*a29);
  a24=(a24-a23);
  a23=(a00*a27);
  a23=(a10*a23);
  a24=(a24-a23);
  a27=(-a27);
  a27=(2.*a27);
  a24=(a24+a27);
  a24=(a24/a10);
  a10=(a24/a32);
  a34=(a34/a32);
  a27=(a22*a18);
  a33=(a33*a27);
  a23=(-a27);
  a23=(2.*a23);
  a28=(a28*a23);
  a33=(a33-a28);
  a33=(a33/a12);
  a34=(a34*a33);
  a10=(a10-a34);
  a31=(a37*a31);
  a34=(a17*a39);
  a22=(a22*a34);
  a31=(a31-a22);
  a31=(a31-a29);
  a31=(a08*a31);
  a24=(a36*a24);
  a04=(a04*a27);
  a04=(a04+a27);
  a35=(a35*a04);
  a04=(a35/a32);
  a32=(a36/a32);
  a32=(a32*a33);
  a04=(a04+a32);
  a25=(a25*a04);
  a24=(a24-a25);
  a31=(a31+a24);
  a31=(a31/a30);
  a30=(a38/a30);
  a35=(a36*a35);
  a09=(a09*a04);
  a35=(a35+a09);
  a30=(a30*a35);
  a31=(a31-a30);
  a36=(a36*a31);
  a04=(a38*a04);
  a36=(a36-a04);
  a10=(a10+a36);
  a36=(a14*a10);
  a04=(a39*a54);
  a36=(a36-a04);
  a04=(a06*a10);
  a30=(a39*a01);
  a04=(a04-a30);
  a04=(a36+a04);
  a30=(a06*a31);
  a35=(a38*a01);
  a30=(a30-a35);
  a04=(a04+a30);
  a30=(a37*a51);
  a35=(a02*a34);
  a30=(a30-a35);
  a04=(a04+a30);
  a37=(a37*a40);
  a30=(a07*a34);
  a37=(a37-a30);
  a04=(a04+a37);
  a26=(a26-a04);
  a04=(2.*a18);
  a04=(a04*a38);
  a04=(a07*a04);
  a41=(a41*a40);
  a04=(a04+a41);
  a26=(a26-a04);
  a26=(a08*a26);
  a36=(a00*a36);
  a26=(a26+a36);
  a36=(-a10);
  a04=(2.*a36);
  a41=(a14*a04);
  a37=(a42*a54);
  a41=(a41-a37);
  a26=(a26-a41);
  a43=(a43*a51);
  a41=(a00*a34);
  a41=(a02*a41);
  a43=(a43-a41);
  a26=(a26+a43);
  a43=(a16*a42);
  a43=(a43-a34);
  a43=(a02*a43);
  a44=(a44*a51);
  a43=(a43+a44);
  a26=(a26+a43);
  a15=(a15*a26);
  a20=(a20+a15);
  a20=(a20/a47);
  a45=(a45/a47);
  a15=(a06*a38);
  a43=(a18*a01);
  a15=(a15-a43);
  a15=(a18*a15);
  a50=(a50*a38);
  a15=(a15+a50);
  a50=(a16*a01);
  a06=(a06*a39);
  a50=(a50+a06);
  a50=(a16*a50);
  a46=(a46*a39);
  a50=(a50+a46);
  a46=(a02*a10);
  a06=(a39*a51);
  a46=(a46+a06);
  a06=(a07*a10);
  a43=(a39*a40);
  a06=(a06+a43);
  a46=(a46+a06);
  a07=(a07*a31);
  a40=(a38*a40);
  a07=(a07+a40);
  a46=(a46+a07);
  a50=(a50+a46);
  a46=(-a01);
  a46=(2.*a46);
  a46=(a16*a46);
  a48=(a48*a39);
  a46=(a46-a48);
  a46=(a18*a46);
  a49=(a49*a38);
  a46=(a46+a49);
  a50=(a50+a46);
  a15=(a15-a50);
  a50=(a16*a54);
  a14=(a14*a39);
  a50=(a50+a14);
  a16=(a16*a50);
  a39=(a51*a39);
  a16=(a16+a39);
  a15=(a15-a16);
  a08=(a08*a15);
  a10=(a00*a10);
  a10=(a02*a10);
  a53=(a53*a51);
  a10=(a10+a53);
  a08=(a08+a10);
  a02=(a02*a04);
  a42=(a42*a51);
  a02=(a02+a42);
  a08=(a08-a02);
  a00=(a00*a16);
  a08=(a08+a00);
  a16=(-a16);
  a16=(2.*a16);
  a08=(a08-a16);
  a45=(a45*a08);
  a20=(a20-a45);
  a05=(a05+a20);
  if (res[1]!=0) res[1][0]=a05;
  if (res[1]!=0) res[1][1]=a03;
  if (res[1]!=0) res[1][2]=a08;
  a26=(a26/a47);
  a52=(a52/a47);
  a52=(a52*a08);
  a26=(a26-a52);
  if (res[1]!=0) res[1][3]=a26;
  a01=(a01-a54);
  if (res[1]!=0) res[1][4]=a01;
  if (res[1]!=0) res[1][5]=a36;
  a18=(a18-a17);
  if (res[1]!=0) res[1][6]=a18;
  if (res[1]!=0) res[1][7]=a03;
  return 0;
}

/* working_steps:(t,turns[2x12],w[4],h,p[3])->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+79, w01, *w02=w+83, *w03=w+86, w05, *w06=w+88, w07, *w08=w+92, *w09=w+96, *w10=w+100, *w11=w+104;
  casadi_real *w12=w+108, *w13=w+112, *w14=w+116, *w15=w+120, *w16=w+124, *w17=w+128, *w18=w+132, *w19=w+136, *w20=w+144, *w21=w+152, *w22=w+160, *w23=w+168;
  casadi_real *w24=w+176, *w25=w+184, *w26=w+192, *w27=w+200, *w28=w+208, *w29=w+216, *w30=w+224, *w31=w+232;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1129;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f86(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1137;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1137*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_72:(u[4],p[3])->(w[4x73],g[8x73],dg[8x73],R[4]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1217, *w19=w+1313, *w20=w+1409, *w21=w+1505;
  casadi_real *w22=w+1513;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f90(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1521;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1521*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_96:(u[4],p[3])->(w[4x97],g[8x97],dg[8x97],R[4]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1217, *w19=w+1313, *w20=w+1409, *w21=w+1505;
  casadi_real *w22=w+1601, *w23=w+1697, *w24=w+1793, *w25=w+1889, *w26=w+1897;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f91(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1905;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1905*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_144:(u[4],p[3])->(w[4x145],g[8x145],dg[8x145],R[4]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1217, *w19=w+1313, *w20=w+1409, *w21=w+1505;
  casadi_real *w22=w+1601, *w23=w+1697, *w24=w+1793, *w25=w+1889, *w26=w+1985, *w27=w+2081, *w28=w+2177, *w29=w+2273, *w30=w+2369, *w31=w+2465, *w32=w+2561, *w33=w+2657;
  casadi_real *w34=w+2665;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f92(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 2673;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2673*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_192:(u[4],p[3])->(w[4x193],g[8x193],dg[8x193],R[4]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1217, *w19=w+1313, *w20=w+1409, *w21=w+1505;
  casadi_real *w22=w+1601, *w23=w+1697, *w24=w+1793, *w25=w+1889, *w26=w+1985, *w27=w+2081, *w28=w+2177, *w29=w+2273, *w30=w+2369, *w31=w+2465, *w32=w+2561, *w33=w+2657;
  casadi_real *w34=w+2753, *w35=w+2849, *w36=w+2945, *w37=w+3041, *w38=w+3137, *w39=w+3233, *w40=w+3329, *w41=w+3425, *w42=w+3433;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f93(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 3441;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3441*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_288:(u[4],p[3])->(w[4x289],g[8x289],dg[8x289],R[4]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1217, *w19=w+1313, *w20=w+1409, *w21=w+1505;
  casadi_real *w22=w+1601, *w23=w+1697, *w24=w+1793, *w25=w+1889, *w26=w+1985, *w27=w+2081, *w28=w+2177, *w29=w+2273, *w30=w+2369, *w31=w+2465, *w32=w+2561, *w33=w+2657;
  casadi_real *w34=w+2753, *w35=w+2849, *w36=w+2945, *w37=w+3041, *w38=w+3137, *w39=w+3233, *w40=w+3329, *w41=w+3425, *w42=w+3521, *w43=w+3617, *w44=w+3713, *w45=w+3809;
  casadi_real *w46=w+3905, *w47=w+4001, *w48=w+4097, *w49=w+4193, *w50=w+4289, *w51=w+4385, *w52=w+4481, *w53=w+4577, *w54=w+4673, *w55=w+4769, *w56=w+4865, *w57=w+4961;
  casadi_real *w58=w+4969;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f94(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 4977;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4977*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_384:(u[4],p[3])->(w[4x385],g[8x385],dg[8x385],R[4]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+267, w02, w03, *w04=w+271, *w05=w+274, *w06=w+298, *w07=w+301, *w08=w+305, *w09=w+353;
  casadi_real *w10=w+449, *w11=w+545, *w12=w+641, *w13=w+737, *w14=w+833, *w15=w+929, *w16=w+1025, *w17=w+1121, *w18=w+1217, *w19=w+1313, *w20=w+1409, *w21=w+1505;
  casadi_real *w22=w+1601, *w23=w+1697, *w24=w+1793, *w25=w+1889, *w26=w+1985, *w27=w+2081, *w28=w+2177, *w29=w+2273, *w30=w+2369, *w31=w+2465, *w32=w+2561, *w33=w+2657;
  casadi_real *w34=w+2753, *w35=w+2849, *w36=w+2945, *w37=w+3041, *w38=w+3137, *w39=w+3233, *w40=w+3329, *w41=w+3425, *w42=w+3521, *w43=w+3617, *w44=w+3713, *w45=w+3809;
  casadi_real *w46=w+3905, *w47=w+4001, *w48=w+4097, *w49=w+4193, *w50=w+4289, *w51=w+4385, *w52=w+4481, *w53=w+4577, *w54=w+4673, *w55=w+4769, *w56=w+4865, *w57=w+4961;
  casadi_real *w58=w+5057, *w59=w+5153, *w60=w+5249, *w61=w+5345, *w62=w+5441, *w63=w+5537, *w64=w+5633, *w65=w+5729, *w66=w+5825, *w67=w+5921, *w68=w+6017, *w69=w+6113;
  casadi_real *w70=w+6209, *w71=w+6305, *w72=w+6401, *w73=w+6497, *w74=w+6505;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f95(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 6513;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6513*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_576:(u[4],p[3])->(w[4x577],g[8x577],dg[8x577],R[4]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+267, w002, w003, *w004=w+271, *w005=w+274, *w006=w+298, *w007=w+301, *w008=w+305, *w009=w+353;
  casadi_real *w010=w+449, *w011=w+545, *w012=w+641, *w013=w+737, *w014=w+833, *w015=w+929, *w016=w+1025, *w017=w+1121, *w018=w+1217, *w019=w+1313, *w020=w+1409, *w021=w+1505;
  casadi_real *w022=w+1601, *w023=w+1697, *w024=w+1793, *w025=w+1889, *w026=w+1985, *w027=w+2081, *w028=w+2177, *w029=w+2273, *w030=w+2369, *w031=w+2465, *w032=w+2561, *w033=w+2657;
  casadi_real *w034=w+2753, *w035=w+2849, *w036=w+2945, *w037=w+3041, *w038=w+3137, *w039=w+3233, *w040=w+3329, *w041=w+3425, *w042=w+3521, *w043=w+3617, *w044=w+3713, *w045=w+3809;
  casadi_real *w046=w+3905, *w047=w+4001, *w048=w+4097, *w049=w+4193, *w050=w+4289, *w051=w+4385, *w052=w+4481, *w053=w+4577, *w054=w+4673, *w055=w+4769, *w056=w+4865, *w057=w+4961;
  casadi_real *w058=w+5057, *w059=w+5153, *w060=w+5249, *w061=w+5345, *w062=w+5441, *w063=w+5537, *w064=w+5633, *w065=w+5729, *w066=w+5825, *w067=w+5921, *w068=w+6017, *w069=w+6113;
  casadi_real *w070=w+6209, *w071=w+6305, *w072=w+6401, *w073=w+6497, *w074=w+6593, *w075=w+6689, *w076=w+6785, *w077=w+6881, *w078=w+6977, *w079=w+7073, *w080=w+7169, *w081=w+7265;
  casadi_real *w082=w+7361, *w083=w+7457, *w084=w+7553, *w085=w+7649, *w086=w+7745, *w087=w+7841, *w088=w+7937, *w089=w+8033, *w090=w+8129, *w091=w+8225, *w092=w+8321, *w093=w+8417;
  casadi_real *w094=w+8513, *w095=w+8609, *w096=w+8705, *w097=w+8801, *w098=w+8897, *w099=w+8993, *w100=w+9089, *w101=w+9185, *w102=w+9281, *w103=w+9377, *w104=w+9473, *w105=w+9569;
  casadi_real *w106=w+9577;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f96(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 9585;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 9585*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_trace_768:(u[4],p[3])->(w[4x769],g[8x769],dg[8x769],R[4]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+267, w002, w003, *w004=w+271, *w005=w+274, *w006=w+298, *w007=w+301, *w008=w+305, *w009=w+353;
  casadi_real *w010=w+449, *w011=w+545, *w012=w+641, *w013=w+737, *w014=w+833, *w015=w+929, *w016=w+1025, *w017=w+1121, *w018=w+1217, *w019=w+1313, *w020=w+1409, *w021=w+1505;
  casadi_real *w022=w+1601, *w023=w+1697, *w024=w+1793, *w025=w+1889, *w026=w+1985, *w027=w+2081, *w028=w+2177, *w029=w+2273, *w030=w+2369, *w031=w+2465, *w032=w+2561, *w033=w+2657;
  casadi_real *w034=w+2753, *w035=w+2849, *w036=w+2945, *w037=w+3041, *w038=w+3137, *w039=w+3233, *w040=w+3329, *w041=w+3425, *w042=w+3521, *w043=w+3617, *w044=w+3713, *w045=w+3809;
  casadi_real *w046=w+3905, *w047=w+4001, *w048=w+4097, *w049=w+4193, *w050=w+4289, *w051=w+4385, *w052=w+4481, *w053=w+4577, *w054=w+4673, *w055=w+4769, *w056=w+4865, *w057=w+4961;
  casadi_real *w058=w+5057, *w059=w+5153, *w060=w+5249, *w061=w+5345, *w062=w+5441, *w063=w+5537, *w064=w+5633, *w065=w+5729, *w066=w+5825, *w067=w+5921, *w068=w+6017, *w069=w+6113;
  casadi_real *w070=w+6209, *w071=w+6305, *w072=w+6401, *w073=w+6497, *w074=w+6593, *w075=w+6689, *w076=w+6785, *w077=w+6881, *w078=w+6977, *w079=w+7073, *w080=w+7169, *w081=w+7265;
  casadi_real *w082=w+7361, *w083=w+7457, *w084=w+7553, *w085=w+7649, *w086=w+7745, *w087=w+7841, *w088=w+7937, *w089=w+8033, *w090=w+8129, *w091=w+8225, *w092=w+8321, *w093=w+8417;
  casadi_real *w094=w+8513, *w095=w+8609, *w096=w+8705, *w097=w+8801, *w098=w+8897, *w099=w+8993, *w100=w+9089, *w101=w+9185, *w102=w+9281, *w103=w+9377, *w104=w+9473, *w105=w+9569;
  casadi_real *w106=w+9665, *w107=w+9761, *w108=w+9857, *w109=w+9953, *w110=w+10049, *w111=w+10145, *w112=w+10241, *w113=w+10337, *w114=w+10433, *w115=w+10529, *w116=w+10625, *w117=w+10721;
  casadi_real *w118=w+10817, *w119=w+10913, *w120=w+11009, *w121=w+11105, *w122=w+11201, *w123=w+11297, *w124=w+11393, *w125=w+11489, *w126=w+11585, *w127=w+11681, *w128=w+11777, *w129=w+11873;
  casadi_real *w130=w+11969, *w131=w+12065, *w132=w+12161, *w133=w+12257, *w134=w+12353, *w135=w+12449, *w136=w+12545, *w137=w+12641, *w138=w+12649;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f97(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 12657;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12657*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_advance:(t,w[4],h,p[3])->(w_end[4],g[8],dg[8]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+79, w1, *w2=w+83, *w3=w+86, w4, *w5=w+88, *w6=w+112, *w7=w+116, *w8=w+124;
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
  if (casadi_f88(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[1][0] = @7 */
  casadi_copy(w7, 8, res[1]);
  /* #11: output[2][0] = @8 */
  casadi_copy(w8, 8, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 132;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 132*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_begin:(u[4],p[3])->(y[4x4]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  return casadi_f99(arg, res, iw, w, mem);
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
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w3=w+334, *w4=w+337, *w5=w+361;
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
  return casadi_f100(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 377;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 377*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_end:(y[4x4],u[4],p[3])->(J[4x4],R[4]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w1=w+31, *w2=w+35, w3, *w4=w+38, *w5=w+41;
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
  return casadi_f101(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 57;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 57*sizeof(casadi_real);
  return 0;
}

/* goswami_compass_observed_swing:(t,h,w[4],p[3])->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+267, *w3=w+270, *w4=w+294, *w5=w+298, *w6=w+302, *w7=w+350, *w8=w+446;
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
  if (casadi_f87(arg1, res1, iw, w, 0)) return 1;
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
  return casadi_f102(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 542;
  return 0;
}

CASADI_SYMBOL_EXPORT int goswami_compass_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 542*sizeof(casadi_real);
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
