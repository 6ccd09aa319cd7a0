/* Walker on round feet: kernels of the solver
 * Printed by CasADi 3.8.2 from equations 74589ffce8759031.
 * Do not edit: run `make derive`.
 * SPDX-License-Identifier: BSD-3-Clause
 */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) round_feet_kernels_ ## ID
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
CASADI_SYMBOL_EXPORT void round_feet_kernels_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int round_feet_kernels_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int round_feet_kernels_casadi_real_size(void) { return (int) sizeof(casadi_real); }

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
static const casadi_int casadi_s5[3] = {7, 1, 1};
static const casadi_int casadi_s6[3] = {4, 4, 1};
static const casadi_int casadi_s7[3] = {4, 49, 1};
static const casadi_int casadi_s8[3] = {7, 49, 1};
static const casadi_int casadi_s9[3] = {4, 73, 1};
static const casadi_int casadi_s10[3] = {7, 73, 1};
static const casadi_int casadi_s11[3] = {4, 97, 1};
static const casadi_int casadi_s12[3] = {7, 97, 1};
static const casadi_int casadi_s13[3] = {4, 145, 1};
static const casadi_int casadi_s14[3] = {7, 145, 1};
static const casadi_int casadi_s15[3] = {4, 193, 1};
static const casadi_int casadi_s16[3] = {7, 193, 1};
static const casadi_int casadi_s17[3] = {4, 289, 1};
static const casadi_int casadi_s18[3] = {7, 289, 1};
static const casadi_int casadi_s19[3] = {4, 385, 1};
static const casadi_int casadi_s20[3] = {7, 385, 1};
static const casadi_int casadi_s21[3] = {4, 577, 1};
static const casadi_int casadi_s22[3] = {7, 577, 1};
static const casadi_int casadi_s23[3] = {4, 769, 1};
static const casadi_int casadi_s24[3] = {7, 769, 1};
static const casadi_int casadi_s25[3] = {1, 1, 1};
static const casadi_int casadi_s26[3] = {4, 12, 1};
static const casadi_int casadi_s27[3] = {7, 12, 1};

static const casadi_real casadi_c0[16] = 
  {1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 5.0000000000000000e-01,
  1., 1., 1., 5.0000000000000000e-01, 1., 1., 1., 5.0000000000000000e-01};
static const casadi_real casadi_c1[4] = {1., 1., 1., 2.};

static const casadi_real casadi_zeros[24] = 
  {0.};

/* start:(z[3],p[7])->(y[4],dy_dz[4x3]) */
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

/* turns:(h,p[7])->(turns[2x12]) */
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

/* phase:(t,p[7])->(phase[2]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[4x4],phase[2],turns[2x12],h,p[7])->(y_end[4x4]) */
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
  casadi_real a336, a337, a338, a339, a340, a341, a342, a343, a344, a345, a346, a347;
  casadi_real a348, a349, a350, a351, a352, a353, a354, a355, a356, a357, a358, a359;
  casadi_real a360, a361, a362, a363, a364, a365, a366, a367, a368, a369, a370, a371;
  casadi_real a372, a373, a374, a375, a376, a377, a378, a379, a380, a381, a382, a383;
  casadi_real a384, a385, a386, a387, a388, a389, a390, a391, a392, a393, a394, a395;
  casadi_real a396, a397, a398, a399, a400, a401, a402, a403, a404, a405, a406, a407;
  casadi_real a408, a409, a410, a411, a412, a413, a414, a415, a416, a417, a418, a419;
  casadi_real a420, a421, a422, a423, a424, a425, a426, a427, a428, a429, a430, a431;
  casadi_real a432, a433, a434, a435, a436, a437, a438, a439, a440, a441, a442, a443;
  casadi_real a444, a445, a446, a447, a448, a449, a450, a451, a452, a453, a454, a455;
  casadi_real a456, a457, a458, a459, a460, a461, a462, a463, a464, a465, a466, a467;
  casadi_real a468, a469, a470, a471, a472, a473, a474, a475, a476, a477, a478, a479;
  casadi_real a480, a481, a482, a483, a484, a485, a486, a487, a488, a489, a490, a491;
  casadi_real a492, a493, a494, a495, a496, a497, a498, a499, a500, a501, a502, a503;
  casadi_real a504, a505, a506, a507, a508, a509, a510, a511, a512, a513, a514;
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
  a007=casadi_sq(a003);
  a008=arg[4]? arg[4][5] : 0;
  a009=(a007*a008);
  a010=sin(a000);
  a009=(a009*a010);
  a011=arg[4]? arg[4][0] : 0;
  a012=arg[4]? arg[4][1] : 0;
  a013=2.;
  a014=arg[4]? arg[4][3] : 0;
  a013=(a013-a014);
  a013=(a012*a013);
  a013=(a011+a013);
  a009=(a009*a013);
  a015=cos(a000);
  a016=arg[0]? arg[0][1] : 0;
  a017=cos(a016);
  a018=(a015*a017);
  a019=sin(a016);
  a020=(a010*a019);
  a018=(a018+a020);
  a020=arg[4]? arg[4][4] : 0;
  a021=(a018*a020);
  a022=(a021*a008);
  a023=(2.*a003);
  a024=arg[0]? arg[0][3] : 0;
  a025=(a023*a024);
  a026=(a025-a007);
  a027=casadi_sq(a024);
  a026=(a026-a027);
  a027=(a022*a026);
  a028=(a016-a000);
  a029=arg[4]? arg[4][6] : 0;
  a028=(a028+a029);
  a030=cos(a028);
  a031=(a030*a020);
  a027=(a027-a031);
  a032=(a015*a020);
  a033=(a032*a003);
  a033=(a033*a003);
  a033=(a033*a008);
  a027=(a027-a033);
  a033=cos(a029);
  a034=(a015*a033);
  a035=sin(a029);
  a036=(a010*a035);
  a034=(a034+a036);
  a036=(a034*a020);
  a027=(a027-a036);
  a037=(a017*a020);
  a038=(a037*a024);
  a039=(a023-a024);
  a040=(a038*a039);
  a027=(a027+a040);
  a041=(a014*a024);
  a042=(a041*a019);
  a039=(a042*a039);
  a027=(a027-a039);
  a043=(a014*a008);
  a044=(a010*a017);
  a045=(a015*a019);
  a044=(a044-a045);
  a045=(a043*a044);
  a046=(a045*a026);
  a027=(a027+a046);
  a028=sin(a028);
  a046=(a014*a028);
  a027=(a027+a046);
  a027=(a012*a027);
  a027=(a009+a027);
  a047=(a008*a035);
  a048=(2.*a012);
  a049=(a011+a048);
  a047=(a047*a049);
  a027=(a027-a047);
  a049=(a010*a033);
  a050=(a015*a035);
  a049=(a049-a050);
  a050=(a049*a013);
  a027=(a027+a050);
  a051=(a011*a008);
  a051=(a051*a008);
  a052=(2.*a015);
  a052=(a052*a008);
  a053=(a011*a052);
  a053=(a051+a053);
  a053=(a053+a011);
  a054=arg[4]? arg[4][2] : 0;
  a055=(2.*a054);
  a053=(a053+a055);
  a056=(a020*a008);
  a057=(a056*a010);
  a058=(a015*a014);
  a058=(a058*a008);
  a057=(a057-a058);
  a058=(a017*a014);
  a057=(a057-a058);
  a057=(a057-a014);
  a059=(a020*a019);
  a057=(a057-a059);
  a060=casadi_sq(a008);
  a057=(a057+a060);
  a057=(a057+a052);
  a052=(a056*a044);
  a057=(a057+a052);
  a061=(a018*a014);
  a061=(a061*a008);
  a057=(a057-a061);
  a062=casadi_sq(a014);
  a063=casadi_sq(a020);
  a064=(a062+a063);
  a057=(a057+a064);
  a065=1.;
  a057=(a057+a065);
  a057=(a048*a057);
  a053=(a053+a057);
  a057=(a027/a053);
  a058=(a058-a062);
  a058=(a058-a063);
  a058=(a058+a059);
  a058=(a058-a052);
  a058=(a058+a061);
  a058=(a012*a058);
  a058=(a058-a054);
  a061=(a058/a053);
  a052=(a031-a046);
  a059=(a014*a019);
  a066=(a059-a037);
  a066=(a007*a066);
  a052=(a052+a066);
  a052=(a012*a052);
  a027=(a061*a027);
  a027=(a052-a027);
  a066=(a012*a064);
  a066=(a054+a066);
  a058=(a058*a061);
  a058=(a066-a058);
  a027=(a027/a058);
  a067=(a061*a027);
  a057=(a057-a067);
  a067=(a006*a057);
  a068=1.7082860872947386e-01;
  a068=(a068*a002);
  a069=2.9587585476806851e-02;
  a069=(a069*a002);
  a070=(a069*a057);
  a071=8.8762756430420545e-02;
  a071=(a071*a002);
  a072=1.9725056984537900e-02;
  a072=(a072*a002);
  a073=(a072*a057);
  a074=5.9175170953613701e-02;
  a074=(a074*a002);
  a075=5.2600151958767730e-02;
  a075=(a075*a002);
  a076=(a075*a057);
  a076=(a003+a076);
  a077=casadi_sq(a076);
  a078=(a077*a008);
  a079=(a075*a003);
  a079=(a000+a079);
  a080=sin(a079);
  a078=(a078*a080);
  a078=(a078*a013);
  a081=cos(a079);
  a082=(a075*a024);
  a082=(a016+a082);
  a083=cos(a082);
  a084=(a081*a083);
  a085=sin(a082);
  a086=(a080*a085);
  a084=(a084+a086);
  a086=(a084*a020);
  a087=(a086*a008);
  a088=(2.*a076);
  a089=(a075*a027);
  a089=(a024+a089);
  a090=(a088*a089);
  a091=(a090-a077);
  a092=casadi_sq(a089);
  a091=(a091-a092);
  a092=(a087*a091);
  a082=(a082-a079);
  a082=(a082+a029);
  a079=cos(a082);
  a093=(a079*a020);
  a092=(a092-a093);
  a094=(a081*a020);
  a095=(a094*a076);
  a095=(a095*a076);
  a095=(a095*a008);
  a092=(a092-a095);
  a095=(a081*a033);
  a096=(a080*a035);
  a095=(a095+a096);
  a096=(a095*a020);
  a092=(a092-a096);
  a097=(a083*a020);
  a098=(a097*a089);
  a099=(a088-a089);
  a100=(a098*a099);
  a092=(a092+a100);
  a101=(a014*a089);
  a102=(a101*a085);
  a099=(a102*a099);
  a092=(a092-a099);
  a103=(a080*a083);
  a104=(a081*a085);
  a103=(a103-a104);
  a104=(a043*a103);
  a105=(a104*a091);
  a092=(a092+a105);
  a082=sin(a082);
  a105=(a014*a082);
  a092=(a092+a105);
  a092=(a012*a092);
  a092=(a078+a092);
  a092=(a092-a047);
  a106=(a080*a033);
  a107=(a081*a035);
  a106=(a106-a107);
  a107=(a106*a013);
  a092=(a092+a107);
  a108=(2.*a081);
  a108=(a108*a008);
  a109=(a011*a108);
  a109=(a051+a109);
  a109=(a109+a011);
  a109=(a109+a055);
  a110=(a056*a080);
  a111=(a081*a014);
  a111=(a111*a008);
  a110=(a110-a111);
  a111=(a083*a014);
  a110=(a110-a111);
  a110=(a110-a014);
  a112=(a020*a085);
  a110=(a110-a112);
  a110=(a110+a060);
  a110=(a110+a108);
  a108=(a056*a103);
  a110=(a110+a108);
  a113=(a084*a014);
  a113=(a113*a008);
  a110=(a110-a113);
  a110=(a110+a064);
  a110=(a110+a065);
  a110=(a048*a110);
  a109=(a109+a110);
  a110=(a092/a109);
  a111=(a111-a062);
  a111=(a111-a063);
  a111=(a111+a112);
  a111=(a111-a108);
  a111=(a111+a113);
  a111=(a012*a111);
  a111=(a111-a054);
  a113=(a111/a109);
  a108=(a093-a105);
  a112=(a014*a085);
  a114=(a112-a097);
  a114=(a077*a114);
  a108=(a108+a114);
  a108=(a012*a108);
  a092=(a113*a092);
  a092=(a108-a092);
  a111=(a111*a113);
  a111=(a066-a111);
  a092=(a092/a111);
  a114=(a113*a092);
  a110=(a110-a114);
  a110=(a074*a110);
  a073=(a073+a110);
  a073=(a003+a073);
  a110=casadi_sq(a073);
  a114=(a110*a008);
  a115=(a072*a003);
  a116=(a074*a076);
  a115=(a115+a116);
  a115=(a000+a115);
  a116=sin(a115);
  a114=(a114*a116);
  a114=(a114*a013);
  a117=cos(a115);
  a118=(a072*a024);
  a119=(a074*a089);
  a118=(a118+a119);
  a118=(a016+a118);
  a119=cos(a118);
  a120=(a117*a119);
  a121=sin(a118);
  a122=(a116*a121);
  a120=(a120+a122);
  a122=(a120*a020);
  a123=(a122*a008);
  a124=(2.*a073);
  a125=(a072*a027);
  a092=(a074*a092);
  a125=(a125+a092);
  a125=(a024+a125);
  a092=(a124*a125);
  a126=(a092-a110);
  a127=casadi_sq(a125);
  a126=(a126-a127);
  a127=(a123*a126);
  a118=(a118-a115);
  a118=(a118+a029);
  a115=cos(a118);
  a128=(a115*a020);
  a127=(a127-a128);
  a129=(a117*a020);
  a130=(a129*a073);
  a130=(a130*a073);
  a130=(a130*a008);
  a127=(a127-a130);
  a130=(a117*a033);
  a131=(a116*a035);
  a130=(a130+a131);
  a131=(a130*a020);
  a127=(a127-a131);
  a132=(a119*a020);
  a133=(a132*a125);
  a134=(a124-a125);
  a135=(a133*a134);
  a127=(a127+a135);
  a136=(a014*a125);
  a137=(a136*a121);
  a134=(a137*a134);
  a127=(a127-a134);
  a138=(a116*a119);
  a139=(a117*a121);
  a138=(a138-a139);
  a139=(a043*a138);
  a140=(a139*a126);
  a127=(a127+a140);
  a118=sin(a118);
  a140=(a014*a118);
  a127=(a127+a140);
  a127=(a012*a127);
  a127=(a114+a127);
  a127=(a127-a047);
  a141=(a116*a033);
  a142=(a117*a035);
  a141=(a141-a142);
  a142=(a141*a013);
  a127=(a127+a142);
  a143=(2.*a117);
  a143=(a143*a008);
  a144=(a011*a143);
  a144=(a051+a144);
  a144=(a144+a011);
  a144=(a144+a055);
  a145=(a056*a116);
  a146=(a117*a014);
  a146=(a146*a008);
  a145=(a145-a146);
  a146=(a119*a014);
  a145=(a145-a146);
  a145=(a145-a014);
  a147=(a020*a121);
  a145=(a145-a147);
  a145=(a145+a060);
  a145=(a145+a143);
  a143=(a056*a138);
  a145=(a145+a143);
  a148=(a120*a014);
  a148=(a148*a008);
  a145=(a145-a148);
  a145=(a145+a064);
  a145=(a145+a065);
  a145=(a048*a145);
  a144=(a144+a145);
  a145=(a127/a144);
  a146=(a146-a062);
  a146=(a146-a063);
  a146=(a146+a147);
  a146=(a146-a143);
  a146=(a146+a148);
  a146=(a012*a146);
  a146=(a146-a054);
  a148=(a146/a144);
  a143=(a128-a140);
  a147=(a014*a121);
  a149=(a147-a132);
  a149=(a110*a149);
  a143=(a143+a149);
  a143=(a012*a143);
  a127=(a148*a127);
  a127=(a143-a127);
  a146=(a146*a148);
  a146=(a066-a146);
  a127=(a127/a146);
  a149=(a148*a127);
  a145=(a145-a149);
  a149=(a071*a145);
  a070=(a070+a149);
  a070=(a003+a070);
  a149=casadi_sq(a070);
  a150=(a149*a008);
  a151=(a069*a003);
  a152=(a071*a073);
  a151=(a151+a152);
  a151=(a000+a151);
  a152=sin(a151);
  a150=(a150*a152);
  a150=(a150*a013);
  a153=cos(a151);
  a154=(a069*a024);
  a155=(a071*a125);
  a154=(a154+a155);
  a154=(a016+a154);
  a155=cos(a154);
  a156=(a153*a155);
  a157=sin(a154);
  a158=(a152*a157);
  a156=(a156+a158);
  a158=(a156*a020);
  a159=(a158*a008);
  a160=(2.*a070);
  a161=(a069*a027);
  a162=(a071*a127);
  a161=(a161+a162);
  a161=(a024+a161);
  a162=(a160*a161);
  a163=(a162-a149);
  a164=casadi_sq(a161);
  a163=(a163-a164);
  a164=(a159*a163);
  a154=(a154-a151);
  a154=(a154+a029);
  a151=cos(a154);
  a165=(a151*a020);
  a164=(a164-a165);
  a166=(a153*a020);
  a167=(a166*a070);
  a167=(a167*a070);
  a167=(a167*a008);
  a164=(a164-a167);
  a167=(a153*a033);
  a168=(a152*a035);
  a167=(a167+a168);
  a168=(a167*a020);
  a164=(a164-a168);
  a169=(a155*a020);
  a170=(a169*a161);
  a171=(a160-a161);
  a172=(a170*a171);
  a164=(a164+a172);
  a173=(a014*a161);
  a174=(a173*a157);
  a171=(a174*a171);
  a164=(a164-a171);
  a175=(a152*a155);
  a176=(a153*a157);
  a175=(a175-a176);
  a176=(a043*a175);
  a177=(a176*a163);
  a164=(a164+a177);
  a154=sin(a154);
  a177=(a014*a154);
  a164=(a164+a177);
  a164=(a012*a164);
  a164=(a150+a164);
  a164=(a164-a047);
  a178=(a152*a033);
  a179=(a153*a035);
  a178=(a178-a179);
  a179=(a178*a013);
  a164=(a164+a179);
  a180=(2.*a153);
  a180=(a180*a008);
  a181=(a011*a180);
  a181=(a051+a181);
  a181=(a181+a011);
  a181=(a181+a055);
  a182=(a056*a152);
  a183=(a153*a014);
  a183=(a183*a008);
  a182=(a182-a183);
  a183=(a155*a014);
  a182=(a182-a183);
  a182=(a182-a014);
  a184=(a020*a157);
  a182=(a182-a184);
  a182=(a182+a060);
  a182=(a182+a180);
  a180=(a056*a175);
  a182=(a182+a180);
  a185=(a156*a014);
  a185=(a185*a008);
  a182=(a182-a185);
  a182=(a182+a064);
  a182=(a182+a065);
  a182=(a048*a182);
  a181=(a181+a182);
  a182=(a164/a181);
  a183=(a183-a062);
  a183=(a183-a063);
  a183=(a183+a184);
  a183=(a183-a180);
  a183=(a183+a185);
  a183=(a012*a183);
  a183=(a183-a054);
  a185=(a183/a181);
  a180=(a165-a177);
  a184=(a014*a157);
  a186=(a184-a169);
  a186=(a149*a186);
  a180=(a180+a186);
  a180=(a012*a180);
  a164=(a185*a164);
  a164=(a180-a164);
  a183=(a183*a185);
  a183=(a066-a183);
  a164=(a164/a183);
  a186=(a185*a164);
  a182=(a182-a186);
  a186=(a068*a182);
  a067=(a067+a186);
  a186=1.2546768756682242e-01;
  a186=(a186*a002);
  a187=2.4136513415926669e-01;
  a187=(a187*a002);
  a188=(a187*a057);
  a189=-8.8454947932828609e-01;
  a189=(a189*a002);
  a145=(a189*a145);
  a188=(a188+a145);
  a145=9.2483400326179199e-01;
  a145=(a145*a002);
  a190=(a145*a182);
  a188=(a188+a190);
  a188=(a003+a188);
  a190=casadi_sq(a188);
  a191=(a190*a008);
  a192=(a187*a003);
  a193=(a189*a073);
  a192=(a192+a193);
  a193=(a145*a070);
  a192=(a192+a193);
  a192=(a000+a192);
  a193=sin(a192);
  a191=(a191*a193);
  a191=(a191*a013);
  a194=cos(a192);
  a195=(a187*a024);
  a196=(a189*a125);
  a195=(a195+a196);
  a196=(a145*a161);
  a195=(a195+a196);
  a195=(a016+a195);
  a196=cos(a195);
  a197=(a194*a196);
  a198=sin(a195);
  a199=(a193*a198);
  a197=(a197+a199);
  a199=(a197*a020);
  a200=(a199*a008);
  a201=(2.*a188);
  a202=(a187*a027);
  a127=(a189*a127);
  a202=(a202+a127);
  a127=(a145*a164);
  a202=(a202+a127);
  a202=(a024+a202);
  a127=(a201*a202);
  a203=(a127-a190);
  a204=casadi_sq(a202);
  a203=(a203-a204);
  a204=(a200*a203);
  a195=(a195-a192);
  a195=(a195+a029);
  a192=cos(a195);
  a205=(a192*a020);
  a204=(a204-a205);
  a206=(a194*a020);
  a207=(a206*a188);
  a207=(a207*a188);
  a207=(a207*a008);
  a204=(a204-a207);
  a207=(a194*a033);
  a208=(a193*a035);
  a207=(a207+a208);
  a208=(a207*a020);
  a204=(a204-a208);
  a209=(a196*a020);
  a210=(a209*a202);
  a211=(a201-a202);
  a212=(a210*a211);
  a204=(a204+a212);
  a213=(a014*a202);
  a214=(a213*a198);
  a211=(a214*a211);
  a204=(a204-a211);
  a215=(a193*a196);
  a216=(a194*a198);
  a215=(a215-a216);
  a216=(a043*a215);
  a217=(a216*a203);
  a204=(a204+a217);
  a195=sin(a195);
  a217=(a014*a195);
  a204=(a204+a217);
  a204=(a012*a204);
  a204=(a191+a204);
  a204=(a204-a047);
  a218=(a193*a033);
  a219=(a194*a035);
  a218=(a218-a219);
  a219=(a218*a013);
  a204=(a204+a219);
  a220=(2.*a194);
  a220=(a220*a008);
  a221=(a011*a220);
  a221=(a051+a221);
  a221=(a221+a011);
  a221=(a221+a055);
  a222=(a056*a193);
  a223=(a194*a014);
  a223=(a223*a008);
  a222=(a222-a223);
  a223=(a196*a014);
  a222=(a222-a223);
  a222=(a222-a014);
  a224=(a020*a198);
  a222=(a222-a224);
  a222=(a222+a060);
  a222=(a222+a220);
  a220=(a056*a215);
  a222=(a222+a220);
  a225=(a197*a014);
  a225=(a225*a008);
  a222=(a222-a225);
  a222=(a222+a064);
  a222=(a222+a065);
  a222=(a048*a222);
  a221=(a221+a222);
  a222=(a204/a221);
  a223=(a223-a062);
  a223=(a223-a063);
  a223=(a223+a224);
  a223=(a223-a220);
  a223=(a223+a225);
  a223=(a012*a223);
  a223=(a223-a054);
  a225=(a223/a221);
  a220=(a205-a217);
  a224=(a014*a198);
  a226=(a224-a209);
  a226=(a190*a226);
  a220=(a220+a226);
  a220=(a012*a220);
  a204=(a225*a204);
  a204=(a220-a204);
  a223=(a223*a225);
  a223=(a066-a223);
  a204=(a204/a223);
  a226=(a225*a204);
  a222=(a222-a226);
  a226=(a186*a222);
  a067=(a067+a226);
  a067=(a003+a067);
  a226=(a005*a067);
  a004=(a004+a226);
  a226=1.8915178993145003e+00;
  a226=(a226*a002);
  a227=3.7109375000000000e-02;
  a227=(a227*a002);
  a228=(a227*a057);
  a229=1.7025221101954405e-01;
  a229=(a229*a002);
  a230=(a229*a182);
  a228=(a228+a230);
  a230=6.0216538980455959e-02;
  a230=(a230*a002);
  a231=(a230*a222);
  a228=(a228+a231);
  a231=-1.7578125000000000e-02;
  a231=(a231*a002);
  a232=casadi_sq(a067);
  a233=(a232*a008);
  a234=(a006*a003);
  a235=(a068*a070);
  a234=(a234+a235);
  a235=(a186*a188);
  a234=(a234+a235);
  a234=(a000+a234);
  a235=sin(a234);
  a233=(a233*a235);
  a233=(a233*a013);
  a236=cos(a234);
  a237=(a006*a024);
  a238=(a068*a161);
  a237=(a237+a238);
  a238=(a186*a202);
  a237=(a237+a238);
  a237=(a016+a237);
  a238=cos(a237);
  a239=(a236*a238);
  a240=sin(a237);
  a241=(a235*a240);
  a239=(a239+a241);
  a241=(a239*a020);
  a242=(a241*a008);
  a243=(2.*a067);
  a244=(a006*a027);
  a245=(a068*a164);
  a244=(a244+a245);
  a245=(a186*a204);
  a244=(a244+a245);
  a244=(a024+a244);
  a245=(a243*a244);
  a246=(a245-a232);
  a247=casadi_sq(a244);
  a246=(a246-a247);
  a247=(a242*a246);
  a237=(a237-a234);
  a237=(a237+a029);
  a234=cos(a237);
  a248=(a234*a020);
  a247=(a247-a248);
  a249=(a236*a020);
  a250=(a249*a067);
  a250=(a250*a067);
  a250=(a250*a008);
  a247=(a247-a250);
  a250=(a236*a033);
  a251=(a235*a035);
  a250=(a250+a251);
  a251=(a250*a020);
  a247=(a247-a251);
  a252=(a238*a020);
  a253=(a252*a244);
  a254=(a243-a244);
  a255=(a253*a254);
  a247=(a247+a255);
  a256=(a014*a244);
  a257=(a256*a240);
  a254=(a257*a254);
  a247=(a247-a254);
  a258=(a235*a238);
  a259=(a236*a240);
  a258=(a258-a259);
  a259=(a043*a258);
  a260=(a259*a246);
  a247=(a247+a260);
  a237=sin(a237);
  a260=(a014*a237);
  a247=(a247+a260);
  a247=(a012*a247);
  a247=(a233+a247);
  a247=(a247-a047);
  a261=(a235*a033);
  a262=(a236*a035);
  a261=(a261-a262);
  a262=(a261*a013);
  a247=(a247+a262);
  a263=(2.*a236);
  a263=(a263*a008);
  a264=(a011*a263);
  a264=(a051+a264);
  a264=(a264+a011);
  a264=(a264+a055);
  a265=(a056*a235);
  a266=(a236*a014);
  a266=(a266*a008);
  a265=(a265-a266);
  a266=(a238*a014);
  a265=(a265-a266);
  a265=(a265-a014);
  a267=(a020*a240);
  a265=(a265-a267);
  a265=(a265+a060);
  a265=(a265+a263);
  a263=(a056*a258);
  a265=(a265+a263);
  a268=(a239*a014);
  a268=(a268*a008);
  a265=(a265-a268);
  a265=(a265+a064);
  a265=(a265+a065);
  a265=(a048*a265);
  a264=(a264+a265);
  a265=(a247/a264);
  a266=(a266-a062);
  a266=(a266-a063);
  a266=(a266+a267);
  a266=(a266-a263);
  a266=(a266+a268);
  a266=(a012*a266);
  a266=(a266-a054);
  a268=(a266/a264);
  a263=(a248-a260);
  a267=(a014*a240);
  a269=(a267-a252);
  a269=(a232*a269);
  a263=(a263+a269);
  a263=(a012*a263);
  a247=(a268*a247);
  a247=(a263-a247);
  a266=(a266*a268);
  a266=(a066-a266);
  a247=(a247/a266);
  a269=(a268*a247);
  a265=(a265-a269);
  a269=(a231*a265);
  a228=(a228+a269);
  a228=(a003+a228);
  a269=(a226*a228);
  a004=(a004+a269);
  a269=-5.8012039600105849e+00;
  a269=(a269*a002);
  a270=3.7092000118504789e-02;
  a270=(a270*a002);
  a271=(a270*a057);
  a272=1.7038392571223998e-01;
  a272=(a272*a002);
  a273=(a272*a182);
  a271=(a271+a273);
  a273=1.0726203044637328e-01;
  a273=(a273*a002);
  a274=(a273*a222);
  a271=(a271+a274);
  a274=-1.5319437748624402e-02;
  a274=(a274*a002);
  a275=(a274*a265);
  a271=(a271+a275);
  a275=8.2737891638140233e-03;
  a275=(a275*a002);
  a276=casadi_sq(a228);
  a277=(a276*a008);
  a278=(a227*a003);
  a279=(a229*a070);
  a278=(a278+a279);
  a279=(a230*a188);
  a278=(a278+a279);
  a279=(a231*a067);
  a278=(a278+a279);
  a278=(a000+a278);
  a279=sin(a278);
  a277=(a277*a279);
  a277=(a277*a013);
  a280=cos(a278);
  a281=(a227*a024);
  a282=(a229*a161);
  a281=(a281+a282);
  a282=(a230*a202);
  a281=(a281+a282);
  a282=(a231*a244);
  a281=(a281+a282);
  a281=(a016+a281);
  a282=cos(a281);
  a283=(a280*a282);
  a284=sin(a281);
  a285=(a279*a284);
  a283=(a283+a285);
  a285=(a283*a020);
  a286=(a285*a008);
  a287=(2.*a228);
  a288=(a227*a027);
  a289=(a229*a164);
  a288=(a288+a289);
  a289=(a230*a204);
  a288=(a288+a289);
  a289=(a231*a247);
  a288=(a288+a289);
  a288=(a024+a288);
  a289=(a287*a288);
  a290=(a289-a276);
  a291=casadi_sq(a288);
  a290=(a290-a291);
  a291=(a286*a290);
  a281=(a281-a278);
  a281=(a281+a029);
  a278=cos(a281);
  a292=(a278*a020);
  a291=(a291-a292);
  a293=(a280*a020);
  a294=(a293*a228);
  a294=(a294*a228);
  a294=(a294*a008);
  a291=(a291-a294);
  a294=(a280*a033);
  a295=(a279*a035);
  a294=(a294+a295);
  a295=(a294*a020);
  a291=(a291-a295);
  a296=(a282*a020);
  a297=(a296*a288);
  a298=(a287-a288);
  a299=(a297*a298);
  a291=(a291+a299);
  a300=(a014*a288);
  a301=(a300*a284);
  a298=(a301*a298);
  a291=(a291-a298);
  a302=(a279*a282);
  a303=(a280*a284);
  a302=(a302-a303);
  a303=(a043*a302);
  a304=(a303*a290);
  a291=(a291+a304);
  a281=sin(a281);
  a304=(a014*a281);
  a291=(a291+a304);
  a291=(a012*a291);
  a291=(a277+a291);
  a291=(a291-a047);
  a305=(a279*a033);
  a306=(a280*a035);
  a305=(a305-a306);
  a306=(a305*a013);
  a291=(a291+a306);
  a307=(2.*a280);
  a307=(a307*a008);
  a308=(a011*a307);
  a308=(a051+a308);
  a308=(a308+a011);
  a308=(a308+a055);
  a309=(a056*a279);
  a310=(a280*a014);
  a310=(a310*a008);
  a309=(a309-a310);
  a310=(a282*a014);
  a309=(a309-a310);
  a309=(a309-a014);
  a311=(a020*a284);
  a309=(a309-a311);
  a309=(a309+a060);
  a309=(a309+a307);
  a307=(a056*a302);
  a309=(a309+a307);
  a312=(a283*a014);
  a312=(a312*a008);
  a309=(a309-a312);
  a309=(a309+a064);
  a309=(a309+a065);
  a309=(a048*a309);
  a308=(a308+a309);
  a309=(a291/a308);
  a310=(a310-a062);
  a310=(a310-a063);
  a310=(a310+a311);
  a310=(a310-a307);
  a310=(a310+a312);
  a310=(a012*a310);
  a310=(a310-a054);
  a312=(a310/a308);
  a307=(a292-a304);
  a311=(a014*a284);
  a313=(a311-a296);
  a313=(a276*a313);
  a307=(a307+a313);
  a307=(a012*a307);
  a291=(a312*a291);
  a291=(a307-a291);
  a310=(a310*a312);
  a310=(a066-a310);
  a291=(a291/a310);
  a313=(a312*a291);
  a309=(a309-a313);
  a313=(a275*a309);
  a271=(a271+a313);
  a271=(a003+a271);
  a313=(a269*a271);
  a004=(a004+a313);
  a313=3.1116436695781990e-01;
  a313=(a313*a002);
  a314=6.2411095871607569e-01;
  a314=(a314*a002);
  a315=(a314*a057);
  a316=-3.3608926294469414e+00;
  a316=(a316*a002);
  a317=(a316*a182);
  a315=(a315+a317);
  a317=-8.6821934684172597e-01;
  a317=(a317*a002);
  a318=(a317*a222);
  a315=(a315+a318);
  a318=2.7592099699446710e+01;
  a318=(a318*a002);
  a319=(a318*a265);
  a315=(a315+a319);
  a319=2.0154067550477894e+01;
  a319=(a319*a002);
  a320=(a319*a309);
  a315=(a315+a320);
  a320=-4.3489884181069961e+01;
  a320=(a320*a002);
  a321=casadi_sq(a271);
  a322=(a321*a008);
  a323=(a270*a003);
  a324=(a272*a070);
  a323=(a323+a324);
  a324=(a273*a188);
  a323=(a323+a324);
  a324=(a274*a067);
  a323=(a323+a324);
  a324=(a275*a228);
  a323=(a323+a324);
  a323=(a000+a323);
  a324=sin(a323);
  a322=(a322*a324);
  a322=(a322*a013);
  a325=cos(a323);
  a326=(a270*a024);
  a327=(a272*a161);
  a326=(a326+a327);
  a327=(a273*a202);
  a326=(a326+a327);
  a327=(a274*a244);
  a326=(a326+a327);
  a327=(a275*a288);
  a326=(a326+a327);
  a326=(a016+a326);
  a327=cos(a326);
  a328=(a325*a327);
  a329=sin(a326);
  a330=(a324*a329);
  a328=(a328+a330);
  a330=(a328*a020);
  a331=(a330*a008);
  a332=(2.*a271);
  a333=(a270*a027);
  a334=(a272*a164);
  a333=(a333+a334);
  a334=(a273*a204);
  a333=(a333+a334);
  a334=(a274*a247);
  a333=(a333+a334);
  a334=(a275*a291);
  a333=(a333+a334);
  a333=(a024+a333);
  a334=(a332*a333);
  a335=(a334-a321);
  a336=casadi_sq(a333);
  a335=(a335-a336);
  a336=(a331*a335);
  a326=(a326-a323);
  a326=(a326+a029);
  a323=cos(a326);
  a337=(a323*a020);
  a336=(a336-a337);
  a338=(a325*a020);
  a339=(a338*a271);
  a339=(a339*a271);
  a339=(a339*a008);
  a336=(a336-a339);
  a339=(a325*a033);
  a340=(a324*a035);
  a339=(a339+a340);
  a340=(a339*a020);
  a336=(a336-a340);
  a341=(a327*a020);
  a342=(a341*a333);
  a343=(a332-a333);
  a344=(a342*a343);
  a336=(a336+a344);
  a345=(a014*a333);
  a346=(a345*a329);
  a343=(a346*a343);
  a336=(a336-a343);
  a347=(a324*a327);
  a348=(a325*a329);
  a347=(a347-a348);
  a348=(a043*a347);
  a349=(a348*a335);
  a336=(a336+a349);
  a326=sin(a326);
  a349=(a014*a326);
  a336=(a336+a349);
  a336=(a012*a336);
  a336=(a322+a336);
  a336=(a336-a047);
  a350=(a324*a033);
  a351=(a325*a035);
  a350=(a350-a351);
  a351=(a350*a013);
  a336=(a336+a351);
  a352=(2.*a325);
  a352=(a352*a008);
  a353=(a011*a352);
  a353=(a051+a353);
  a353=(a353+a011);
  a353=(a353+a055);
  a354=(a056*a324);
  a355=(a325*a014);
  a355=(a355*a008);
  a354=(a354-a355);
  a355=(a327*a014);
  a354=(a354-a355);
  a354=(a354-a014);
  a356=(a020*a329);
  a354=(a354-a356);
  a354=(a354+a060);
  a354=(a354+a352);
  a352=(a056*a347);
  a354=(a354+a352);
  a357=(a328*a014);
  a357=(a357*a008);
  a354=(a354-a357);
  a354=(a354+a064);
  a354=(a354+a065);
  a354=(a048*a354);
  a353=(a353+a354);
  a354=(a336/a353);
  a355=(a355-a062);
  a355=(a355-a063);
  a355=(a355+a356);
  a355=(a355-a352);
  a355=(a355+a357);
  a355=(a012*a355);
  a355=(a355-a054);
  a357=(a355/a353);
  a352=(a337-a349);
  a356=(a014*a329);
  a358=(a356-a341);
  a358=(a321*a358);
  a352=(a352+a358);
  a352=(a012*a352);
  a336=(a357*a336);
  a336=(a352-a336);
  a355=(a355*a357);
  a355=(a066-a355);
  a336=(a336/a355);
  a358=(a357*a336);
  a354=(a354-a358);
  a358=(a320*a354);
  a315=(a315+a358);
  a315=(a003+a315);
  a358=(a313*a315);
  a004=(a004+a358);
  a358=-1.5216094966251609e-01;
  a358=(a358*a002);
  a359=4.7766253643826434e-01;
  a359=(a359*a002);
  a360=(a359*a057);
  a361=-2.4881146199716677e+00;
  a361=(a361*a002);
  a362=(a361*a182);
  a360=(a360+a362);
  a362=-5.9029082683684297e-01;
  a362=(a362*a002);
  a363=(a362*a222);
  a360=(a360+a363);
  a363=2.1230051448181193e+01;
  a363=(a363*a002);
  a364=(a363*a265);
  a360=(a360+a364);
  a364=1.5279233632882423e+01;
  a364=(a364*a002);
  a365=(a364*a309);
  a360=(a360+a365);
  a365=-3.3288210968984863e+01;
  a365=(a365*a002);
  a366=(a365*a354);
  a360=(a360+a366);
  a366=-2.0331201708508627e-02;
  a366=(a366*a002);
  a367=casadi_sq(a315);
  a368=(a367*a008);
  a369=(a314*a003);
  a370=(a316*a070);
  a369=(a369+a370);
  a370=(a317*a188);
  a369=(a369+a370);
  a370=(a318*a067);
  a369=(a369+a370);
  a370=(a319*a228);
  a369=(a369+a370);
  a370=(a320*a271);
  a369=(a369+a370);
  a369=(a000+a369);
  a370=sin(a369);
  a368=(a368*a370);
  a368=(a368*a013);
  a371=cos(a369);
  a372=(a314*a024);
  a373=(a316*a161);
  a372=(a372+a373);
  a373=(a317*a202);
  a372=(a372+a373);
  a373=(a318*a244);
  a372=(a372+a373);
  a373=(a319*a288);
  a372=(a372+a373);
  a373=(a320*a333);
  a372=(a372+a373);
  a372=(a016+a372);
  a373=cos(a372);
  a374=(a371*a373);
  a375=sin(a372);
  a376=(a370*a375);
  a374=(a374+a376);
  a376=(a374*a020);
  a377=(a376*a008);
  a378=(2.*a315);
  a379=(a314*a027);
  a380=(a316*a164);
  a379=(a379+a380);
  a380=(a317*a204);
  a379=(a379+a380);
  a380=(a318*a247);
  a379=(a379+a380);
  a380=(a319*a291);
  a379=(a379+a380);
  a380=(a320*a336);
  a379=(a379+a380);
  a379=(a024+a379);
  a380=(a378*a379);
  a381=(a380-a367);
  a382=casadi_sq(a379);
  a381=(a381-a382);
  a382=(a377*a381);
  a372=(a372-a369);
  a372=(a372+a029);
  a369=cos(a372);
  a383=(a369*a020);
  a382=(a382-a383);
  a384=(a371*a020);
  a385=(a384*a315);
  a385=(a385*a315);
  a385=(a385*a008);
  a382=(a382-a385);
  a385=(a371*a033);
  a386=(a370*a035);
  a385=(a385+a386);
  a386=(a385*a020);
  a382=(a382-a386);
  a387=(a373*a020);
  a388=(a387*a379);
  a389=(a378-a379);
  a390=(a388*a389);
  a382=(a382+a390);
  a391=(a014*a379);
  a392=(a391*a375);
  a389=(a392*a389);
  a382=(a382-a389);
  a393=(a370*a373);
  a394=(a371*a375);
  a393=(a393-a394);
  a394=(a043*a393);
  a395=(a394*a381);
  a382=(a382+a395);
  a372=sin(a372);
  a395=(a014*a372);
  a382=(a382+a395);
  a382=(a012*a382);
  a382=(a368+a382);
  a382=(a382-a047);
  a396=(a370*a033);
  a397=(a371*a035);
  a396=(a396-a397);
  a397=(a396*a013);
  a382=(a382+a397);
  a398=(2.*a371);
  a398=(a398*a008);
  a399=(a011*a398);
  a399=(a051+a399);
  a399=(a399+a011);
  a399=(a399+a055);
  a400=(a056*a370);
  a401=(a371*a014);
  a401=(a401*a008);
  a400=(a400-a401);
  a401=(a373*a014);
  a400=(a400-a401);
  a400=(a400-a014);
  a402=(a020*a375);
  a400=(a400-a402);
  a400=(a400+a060);
  a400=(a400+a398);
  a398=(a056*a393);
  a400=(a400+a398);
  a403=(a374*a014);
  a403=(a403*a008);
  a400=(a400-a403);
  a400=(a400+a064);
  a400=(a400+a065);
  a400=(a048*a400);
  a399=(a399+a400);
  a400=(a382/a399);
  a401=(a401-a062);
  a401=(a401-a063);
  a401=(a401+a402);
  a401=(a401-a398);
  a401=(a401+a403);
  a401=(a012*a401);
  a401=(a401-a054);
  a403=(a401/a399);
  a398=(a383-a395);
  a402=(a014*a375);
  a404=(a402-a387);
  a404=(a367*a404);
  a398=(a398+a404);
  a398=(a012*a398);
  a382=(a403*a382);
  a382=(a398-a382);
  a401=(a401*a403);
  a401=(a066-a401);
  a382=(a382/a401);
  a404=(a403*a382);
  a400=(a400-a404);
  a404=(a366*a400);
  a360=(a360+a404);
  a360=(a003+a360);
  a404=(a358*a360);
  a004=(a004+a404);
  a404=2.0136540080403034e-01;
  a404=(a404*a002);
  a405=-9.3714243008598730e-01;
  a405=(a405*a002);
  a406=(a405*a057);
  a407=5.1863724288440638e+00;
  a407=(a407*a002);
  a408=(a407*a182);
  a406=(a406+a408);
  a408=1.0914373489967295e+00;
  a408=(a408*a002);
  a409=(a408*a222);
  a406=(a406+a409);
  a409=-8.1497870107469268e+00;
  a409=(a409*a002);
  a410=(a409*a265);
  a406=(a406+a410);
  a410=-1.8520065659996959e+01;
  a410=(a410*a002);
  a411=(a410*a309);
  a406=(a406+a411);
  a411=2.2739487099350505e+01;
  a411=(a411*a002);
  a412=(a411*a354);
  a406=(a406+a412);
  a412=2.4936055526796523e+00;
  a412=(a412*a002);
  a413=(a412*a400);
  a406=(a406+a413);
  a413=-3.0467644718982196e+00;
  a413=(a413*a002);
  a414=casadi_sq(a360);
  a415=(a414*a008);
  a416=(a359*a003);
  a417=(a361*a070);
  a416=(a416+a417);
  a417=(a362*a188);
  a416=(a416+a417);
  a417=(a363*a067);
  a416=(a416+a417);
  a417=(a364*a228);
  a416=(a416+a417);
  a417=(a365*a271);
  a416=(a416+a417);
  a417=(a366*a315);
  a416=(a416+a417);
  a416=(a000+a416);
  a417=sin(a416);
  a415=(a415*a417);
  a415=(a415*a013);
  a418=cos(a416);
  a419=(a359*a024);
  a420=(a361*a161);
  a419=(a419+a420);
  a420=(a362*a202);
  a419=(a419+a420);
  a420=(a363*a244);
  a419=(a419+a420);
  a420=(a364*a288);
  a419=(a419+a420);
  a420=(a365*a333);
  a419=(a419+a420);
  a420=(a366*a379);
  a419=(a419+a420);
  a419=(a016+a419);
  a420=cos(a419);
  a421=(a418*a420);
  a422=sin(a419);
  a423=(a417*a422);
  a421=(a421+a423);
  a423=(a421*a020);
  a424=(a423*a008);
  a425=(2.*a360);
  a426=(a359*a027);
  a427=(a361*a164);
  a426=(a426+a427);
  a427=(a362*a204);
  a426=(a426+a427);
  a427=(a363*a247);
  a426=(a426+a427);
  a427=(a364*a291);
  a426=(a426+a427);
  a427=(a365*a336);
  a426=(a426+a427);
  a427=(a366*a382);
  a426=(a426+a427);
  a426=(a024+a426);
  a427=(a425*a426);
  a428=(a427-a414);
  a429=casadi_sq(a426);
  a428=(a428-a429);
  a429=(a424*a428);
  a419=(a419-a416);
  a419=(a419+a029);
  a416=cos(a419);
  a430=(a416*a020);
  a429=(a429-a430);
  a431=(a418*a020);
  a432=(a431*a360);
  a432=(a432*a360);
  a432=(a432*a008);
  a429=(a429-a432);
  a432=(a418*a033);
  a433=(a417*a035);
  a432=(a432+a433);
  a433=(a432*a020);
  a429=(a429-a433);
  a434=(a420*a020);
  a435=(a434*a426);
  a436=(a425-a426);
  a437=(a435*a436);
  a429=(a429+a437);
  a438=(a014*a426);
  a439=(a438*a422);
  a436=(a439*a436);
  a429=(a429-a436);
  a440=(a417*a420);
  a441=(a418*a422);
  a440=(a440-a441);
  a441=(a043*a440);
  a442=(a441*a428);
  a429=(a429+a442);
  a419=sin(a419);
  a442=(a014*a419);
  a429=(a429+a442);
  a429=(a012*a429);
  a429=(a415+a429);
  a429=(a429-a047);
  a443=(a417*a033);
  a444=(a418*a035);
  a443=(a443-a444);
  a444=(a443*a013);
  a429=(a429+a444);
  a445=(2.*a418);
  a445=(a445*a008);
  a446=(a011*a445);
  a446=(a051+a446);
  a446=(a446+a011);
  a446=(a446+a055);
  a447=(a056*a417);
  a448=(a418*a014);
  a448=(a448*a008);
  a447=(a447-a448);
  a448=(a420*a014);
  a447=(a447-a448);
  a447=(a447-a014);
  a449=(a020*a422);
  a447=(a447-a449);
  a447=(a447+a060);
  a447=(a447+a445);
  a445=(a056*a440);
  a447=(a447+a445);
  a450=(a421*a014);
  a450=(a450*a008);
  a447=(a447-a450);
  a447=(a447+a064);
  a447=(a447+a065);
  a447=(a048*a447);
  a446=(a446+a447);
  a447=(a429/a446);
  a448=(a448-a062);
  a448=(a448-a063);
  a448=(a448+a449);
  a448=(a448-a445);
  a448=(a448+a450);
  a448=(a012*a448);
  a448=(a448-a054);
  a450=(a448/a446);
  a445=(a430-a442);
  a449=(a014*a422);
  a451=(a449-a434);
  a451=(a414*a451);
  a445=(a445+a451);
  a445=(a012*a445);
  a429=(a450*a429);
  a429=(a445-a429);
  a448=(a448*a450);
  a448=(a066-a448);
  a429=(a429/a448);
  a451=(a450*a429);
  a447=(a447-a451);
  a451=(a413*a447);
  a406=(a406+a451);
  a406=(a003+a406);
  a451=(a404*a406);
  a004=(a004+a451);
  a451=4.4710615727772587e-02;
  a451=(a451*a002);
  a452=2.2733101475165380e+00;
  a452=(a452*a002);
  a453=(a452*a057);
  a454=-1.0534495466737249e+01;
  a454=(a454*a002);
  a182=(a454*a182);
  a453=(a453+a182);
  a182=-2.0008720582248625e+00;
  a182=(a182*a002);
  a222=(a182*a222);
  a453=(a453+a222);
  a222=-1.7958931863118799e+01;
  a222=(a222*a002);
  a455=(a222*a265);
  a453=(a453+a455);
  a455=2.7948884529419960e+01;
  a455=(a455*a002);
  a456=(a455*a309);
  a453=(a453+a456);
  a456=-2.8589982771350235e+00;
  a456=(a456*a002);
  a457=(a456*a354);
  a453=(a453+a457);
  a457=-8.8728569335306293e+00;
  a457=(a457*a002);
  a458=(a457*a400);
  a453=(a453+a458);
  a458=1.2360567175794303e+01;
  a458=(a458*a002);
  a459=(a458*a447);
  a453=(a453+a459);
  a459=6.4339274601576357e-01;
  a459=(a459*a002);
  a002=casadi_sq(a406);
  a460=(a002*a008);
  a461=(a405*a003);
  a462=(a407*a070);
  a461=(a461+a462);
  a462=(a408*a188);
  a461=(a461+a462);
  a462=(a409*a067);
  a461=(a461+a462);
  a462=(a410*a228);
  a461=(a461+a462);
  a462=(a411*a271);
  a461=(a461+a462);
  a462=(a412*a315);
  a461=(a461+a462);
  a462=(a413*a360);
  a461=(a461+a462);
  a461=(a000+a461);
  a462=sin(a461);
  a460=(a460*a462);
  a460=(a460*a013);
  a463=cos(a461);
  a464=(a405*a024);
  a465=(a407*a161);
  a464=(a464+a465);
  a465=(a408*a202);
  a464=(a464+a465);
  a465=(a409*a244);
  a464=(a464+a465);
  a465=(a410*a288);
  a464=(a464+a465);
  a465=(a411*a333);
  a464=(a464+a465);
  a465=(a412*a379);
  a464=(a464+a465);
  a465=(a413*a426);
  a464=(a464+a465);
  a464=(a016+a464);
  a465=cos(a464);
  a466=(a463*a465);
  a467=sin(a464);
  a468=(a462*a467);
  a466=(a466+a468);
  a468=(a466*a020);
  a469=(a468*a008);
  a470=(2.*a406);
  a471=(a405*a027);
  a472=(a407*a164);
  a471=(a471+a472);
  a472=(a408*a204);
  a471=(a471+a472);
  a472=(a409*a247);
  a471=(a471+a472);
  a472=(a410*a291);
  a471=(a471+a472);
  a472=(a411*a336);
  a471=(a471+a472);
  a472=(a412*a382);
  a471=(a471+a472);
  a472=(a413*a429);
  a471=(a471+a472);
  a471=(a024+a471);
  a472=(a470*a471);
  a473=(a472-a002);
  a474=casadi_sq(a471);
  a473=(a473-a474);
  a474=(a469*a473);
  a464=(a464-a461);
  a464=(a464+a029);
  a461=cos(a464);
  a475=(a461*a020);
  a474=(a474-a475);
  a476=(a463*a020);
  a477=(a476*a406);
  a477=(a477*a406);
  a477=(a477*a008);
  a474=(a474-a477);
  a477=(a463*a033);
  a478=(a462*a035);
  a477=(a477+a478);
  a478=(a477*a020);
  a474=(a474-a478);
  a479=(a465*a020);
  a480=(a479*a471);
  a481=(a470-a471);
  a482=(a480*a481);
  a474=(a474+a482);
  a483=(a014*a471);
  a484=(a483*a467);
  a481=(a484*a481);
  a474=(a474-a481);
  a485=(a462*a465);
  a486=(a463*a467);
  a485=(a485-a486);
  a486=(a043*a485);
  a487=(a486*a473);
  a474=(a474+a487);
  a464=sin(a464);
  a487=(a014*a464);
  a474=(a474+a487);
  a474=(a012*a474);
  a474=(a460+a474);
  a474=(a474-a047);
  a488=(a462*a033);
  a489=(a463*a035);
  a488=(a488-a489);
  a489=(a488*a013);
  a474=(a474+a489);
  a490=(2.*a463);
  a490=(a490*a008);
  a491=(a011*a490);
  a491=(a051+a491);
  a491=(a491+a011);
  a491=(a491+a055);
  a492=(a056*a462);
  a493=(a463*a014);
  a493=(a493*a008);
  a492=(a492-a493);
  a493=(a465*a014);
  a492=(a492-a493);
  a492=(a492-a014);
  a494=(a020*a467);
  a492=(a492-a494);
  a492=(a492+a060);
  a492=(a492+a490);
  a490=(a056*a485);
  a492=(a492+a490);
  a495=(a466*a014);
  a495=(a495*a008);
  a492=(a492-a495);
  a492=(a492+a064);
  a492=(a492+a065);
  a492=(a048*a492);
  a491=(a491+a492);
  a492=(a474/a491);
  a493=(a493-a062);
  a493=(a493-a063);
  a493=(a493+a494);
  a493=(a493-a490);
  a493=(a493+a495);
  a493=(a012*a493);
  a493=(a493-a054);
  a495=(a493/a491);
  a490=(a475-a487);
  a494=(a014*a467);
  a496=(a494-a479);
  a496=(a002*a496);
  a490=(a490+a496);
  a490=(a012*a490);
  a474=(a495*a474);
  a474=(a490-a474);
  a493=(a493*a495);
  a493=(a066-a493);
  a474=(a474/a493);
  a496=(a495*a474);
  a492=(a492-a496);
  a496=(a459*a492);
  a453=(a453+a496);
  a453=(a003+a453);
  a496=(a451*a453);
  a004=(a004+a496);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a024);
  a496=(a005*a244);
  a004=(a004+a496);
  a496=(a226*a288);
  a004=(a004+a496);
  a496=(a269*a333);
  a004=(a004+a496);
  a496=(a313*a379);
  a004=(a004+a496);
  a496=(a358*a426);
  a004=(a004+a496);
  a496=(a404*a471);
  a004=(a004+a496);
  a496=(a452*a027);
  a164=(a454*a164);
  a496=(a496+a164);
  a204=(a182*a204);
  a496=(a496+a204);
  a204=(a222*a247);
  a496=(a496+a204);
  a204=(a455*a291);
  a496=(a496+a204);
  a204=(a456*a336);
  a496=(a496+a204);
  a204=(a457*a382);
  a496=(a496+a204);
  a204=(a458*a429);
  a496=(a496+a204);
  a204=(a459*a474);
  a496=(a496+a204);
  a496=(a024+a496);
  a204=(a451*a496);
  a004=(a004+a204);
  a004=(a016+a004);
  if (res[0]!=0) res[0][1]=a004;
  a057=(a001*a057);
  a265=(a005*a265);
  a057=(a057+a265);
  a309=(a226*a309);
  a057=(a057+a309);
  a354=(a269*a354);
  a057=(a057+a354);
  a400=(a313*a400);
  a057=(a057+a400);
  a447=(a358*a447);
  a057=(a057+a447);
  a492=(a404*a492);
  a057=(a057+a492);
  a492=casadi_sq(a453);
  a447=(a492*a008);
  a400=(a452*a003);
  a354=(a454*a070);
  a400=(a400+a354);
  a354=(a182*a188);
  a400=(a400+a354);
  a354=(a222*a067);
  a400=(a400+a354);
  a354=(a455*a228);
  a400=(a400+a354);
  a354=(a456*a271);
  a400=(a400+a354);
  a354=(a457*a315);
  a400=(a400+a354);
  a354=(a458*a360);
  a400=(a400+a354);
  a354=(a459*a406);
  a400=(a400+a354);
  a000=(a000+a400);
  a400=sin(a000);
  a447=(a447*a400);
  a447=(a447*a013);
  a354=cos(a000);
  a309=(a452*a024);
  a265=(a454*a161);
  a309=(a309+a265);
  a265=(a182*a202);
  a309=(a309+a265);
  a265=(a222*a244);
  a309=(a309+a265);
  a265=(a455*a288);
  a309=(a309+a265);
  a265=(a456*a333);
  a309=(a309+a265);
  a265=(a457*a379);
  a309=(a309+a265);
  a265=(a458*a426);
  a309=(a309+a265);
  a265=(a459*a471);
  a309=(a309+a265);
  a016=(a016+a309);
  a309=cos(a016);
  a265=(a354*a309);
  a004=sin(a016);
  a204=(a400*a004);
  a265=(a265+a204);
  a204=(a265*a020);
  a164=(a204*a008);
  a497=(2.*a453);
  a498=(a497*a496);
  a499=(a498-a492);
  a500=casadi_sq(a496);
  a499=(a499-a500);
  a500=(a164*a499);
  a016=(a016-a000);
  a016=(a016+a029);
  a029=cos(a016);
  a000=(a029*a020);
  a500=(a500-a000);
  a501=(a354*a020);
  a502=(a501*a453);
  a502=(a502*a453);
  a502=(a502*a008);
  a500=(a500-a502);
  a502=(a354*a033);
  a503=(a400*a035);
  a502=(a502+a503);
  a503=(a502*a020);
  a500=(a500-a503);
  a504=(a309*a020);
  a505=(a504*a496);
  a506=(a497-a496);
  a507=(a505*a506);
  a500=(a500+a507);
  a508=(a014*a496);
  a509=(a508*a004);
  a506=(a509*a506);
  a500=(a500-a506);
  a510=(a400*a309);
  a511=(a354*a004);
  a510=(a510-a511);
  a043=(a043*a510);
  a511=(a043*a499);
  a500=(a500+a511);
  a016=sin(a016);
  a511=(a014*a016);
  a500=(a500+a511);
  a500=(a012*a500);
  a500=(a447+a500);
  a500=(a500-a047);
  a033=(a400*a033);
  a035=(a354*a035);
  a033=(a033-a035);
  a035=(a033*a013);
  a500=(a500+a035);
  a512=(2.*a354);
  a512=(a512*a008);
  a513=(a011*a512);
  a051=(a051+a513);
  a051=(a051+a011);
  a051=(a051+a055);
  a055=(a056*a400);
  a513=(a354*a014);
  a513=(a513*a008);
  a055=(a055-a513);
  a513=(a309*a014);
  a055=(a055-a513);
  a055=(a055-a014);
  a514=(a020*a004);
  a055=(a055-a514);
  a055=(a055+a060);
  a055=(a055+a512);
  a056=(a056*a510);
  a055=(a055+a056);
  a512=(a265*a014);
  a512=(a512*a008);
  a055=(a055-a512);
  a055=(a055+a064);
  a055=(a055+a065);
  a055=(a048*a055);
  a051=(a051+a055);
  a055=(a500/a051);
  a513=(a513-a062);
  a513=(a513-a063);
  a513=(a513+a514);
  a513=(a513-a056);
  a513=(a513+a512);
  a513=(a012*a513);
  a513=(a513-a054);
  a054=(a513/a051);
  a512=(a000-a511);
  a056=(a014*a004);
  a514=(a056-a504);
  a514=(a492*a514);
  a512=(a512+a514);
  a512=(a012*a512);
  a500=(a054*a500);
  a500=(a512-a500);
  a513=(a513*a054);
  a066=(a066-a513);
  a500=(a500/a066);
  a513=(a054*a500);
  a055=(a055-a513);
  a055=(a451*a055);
  a057=(a057+a055);
  a057=(a003+a057);
  if (res[0]!=0) res[0][2]=a057;
  a027=(a001*a027);
  a247=(a005*a247);
  a027=(a027+a247);
  a291=(a226*a291);
  a027=(a027+a291);
  a336=(a269*a336);
  a027=(a027+a336);
  a382=(a313*a382);
  a027=(a027+a382);
  a429=(a358*a429);
  a027=(a027+a429);
  a474=(a404*a474);
  a027=(a027+a474);
  a500=(a451*a500);
  a027=(a027+a500);
  a027=(a024+a027);
  if (res[0]!=0) res[0][3]=a027;
  a027=arg[0]? arg[0][4] : 0;
  a500=arg[0]? arg[0][6] : 0;
  a474=(a001*a500);
  a015=(a015*a008);
  a007=(a007*a011);
  a429=(a023*a003);
  a382=(a014*a003);
  a382=(a382*a003);
  a429=(a429-a382);
  a026=(a008*a026);
  a336=(a021*a026);
  a336=(a336-a031);
  a031=(a020*a003);
  a031=(a031*a003);
  a291=(a015*a031);
  a336=(a336-a291);
  a336=(a336-a036);
  a336=(a336+a040);
  a336=(a336-a039);
  a336=(a336+a046);
  a046=(a014*a044);
  a026=(a046*a026);
  a336=(a336+a026);
  a336=(a012*a336);
  a009=(a009+a336);
  a009=(a009-a047);
  a009=(a009+a050);
  a050=(a009/a053);
  a009=(a061*a009);
  a052=(a052-a009);
  a052=(a052/a058);
  a009=(a061*a052);
  a050=(a050-a009);
  a009=(2.*a050);
  a336=(a009*a020);
  a429=(a429-a336);
  a429=(a012*a429);
  a007=(a007+a429);
  a015=(a015*a007);
  a034=(a034*a013);
  a015=(a015+a034);
  a049=(a020*a049);
  a030=(a030*a014);
  a049=(a049-a030);
  a034=(a018*a008);
  a007=(a382+a336);
  a041=(a041*a024);
  a429=(a052*a020);
  a041=(a041-a429);
  a429=(a014*a025);
  a041=(a041-a429);
  a007=(a007+a041);
  a034=(a034*a007);
  a049=(a049-a034);
  a028=(a020*a028);
  a049=(a049-a028);
  a007=(a008*a044);
  a052=(a052*a014);
  a025=(a020*a025);
  a052=(a052-a025);
  a025=(a009*a014);
  a052=(a052-a025);
  a429=(a020*a024);
  a429=(a429*a024);
  a052=(a052+a429);
  a429=(a052+a031);
  a007=(a007*a429);
  a049=(a049+a007);
  a049=(a012*a049);
  a015=(a015+a049);
  a010=(a008*a010);
  a009=(a009*a011);
  a049=4.;
  a429=(a049*a050);
  a429=(a429-a025);
  a429=(a429+a031);
  a429=(a012*a429);
  a009=(a009+a429);
  a009=(a010*a009);
  a015=(a015+a009);
  a009=(a015/a053);
  a429=(a050*a008);
  a021=(a021+a046);
  a429=(a429*a021);
  a030=(a030+a028);
  a429=(a429+a030);
  a429=(a012*a429);
  a015=(a061*a015);
  a429=(a429-a015);
  a429=(a429/a058);
  a015=(a061*a429);
  a009=(a009-a015);
  a015=(a009*a027);
  a336=(a336+a041);
  a336=(a017*a336);
  a034=(a034+a336);
  a034=(a034-a007);
  a052=(a019*a052);
  a034=(a034+a052);
  a034=(a034+a030);
  a034=(a012*a034);
  a052=(a034/a053);
  a007=(a050*a020);
  a382=(a382-a007);
  a017=(a017*a382);
  a018=(a050*a018);
  a018=(a018*a020);
  a018=(a018*a008);
  a017=(a017-a018);
  a050=(a050*a014);
  a018=(a050*a008);
  a018=(a018*a044);
  a017=(a017-a018);
  a050=(a050+a031);
  a019=(a019*a050);
  a017=(a017+a019);
  a017=(a017-a030);
  a017=(a012*a017);
  a034=(a061*a034);
  a017=(a017-a034);
  a017=(a017/a058);
  a034=(a061*a017);
  a052=(a052-a034);
  a034=arg[0]? arg[0][5] : 0;
  a030=(a052*a034);
  a015=(a015+a030);
  a010=(a010*a013);
  a010=(a023*a010);
  a038=(2.*a038);
  a032=(a032*a008);
  a032=(a023*a032);
  a038=(a038-a032);
  a042=(2.*a042);
  a038=(a038-a042);
  a042=(2.*a024);
  a042=(a042-a023);
  a023=(a022*a042);
  a038=(a038+a023);
  a042=(a045*a042);
  a038=(a038+a042);
  a038=(a012*a038);
  a010=(a010+a038);
  a038=(a010/a053);
  a042=-2.;
  a023=(a042*a003);
  a023=(a023*a012);
  a037=(a037-a059);
  a023=(a023*a037);
  a010=(a061*a010);
  a023=(a023-a010);
  a023=(a023/a058);
  a010=(a061*a023);
  a038=(a038-a010);
  a010=(a038*a500);
  a003=(a003-a024);
  a003=(a048*a003);
  a022=(a022+a045);
  a022=(a022+a037);
  a003=(a003*a022);
  a053=(a003/a053);
  a003=(a061*a003);
  a003=(a003/a058);
  a061=(a061*a003);
  a053=(a053+a061);
  a061=arg[0]? arg[0][7] : 0;
  a058=(a053*a061);
  a010=(a010+a058);
  a015=(a015+a010);
  a010=(a006*a015);
  a153=(a153*a008);
  a149=(a149*a011);
  a058=(a160*a070);
  a022=(a014*a070);
  a022=(a022*a070);
  a058=(a058-a022);
  a163=(a008*a163);
  a037=(a158*a163);
  a037=(a037-a165);
  a165=(a020*a070);
  a165=(a165*a070);
  a045=(a153*a165);
  a037=(a037-a045);
  a037=(a037-a168);
  a037=(a037+a172);
  a037=(a037-a171);
  a037=(a037+a177);
  a177=(a014*a175);
  a163=(a177*a163);
  a037=(a037+a163);
  a037=(a012*a037);
  a150=(a150+a037);
  a150=(a150-a047);
  a150=(a150+a179);
  a179=(a150/a181);
  a150=(a185*a150);
  a180=(a180-a150);
  a180=(a180/a183);
  a150=(a185*a180);
  a179=(a179-a150);
  a150=(2.*a179);
  a037=(a150*a020);
  a058=(a058-a037);
  a058=(a012*a058);
  a149=(a149+a058);
  a153=(a153*a149);
  a167=(a167*a013);
  a153=(a153+a167);
  a178=(a020*a178);
  a151=(a151*a014);
  a178=(a178-a151);
  a167=(a156*a008);
  a149=(a022+a037);
  a173=(a173*a161);
  a058=(a180*a020);
  a173=(a173-a058);
  a058=(a014*a162);
  a173=(a173-a058);
  a149=(a149+a173);
  a167=(a167*a149);
  a178=(a178-a167);
  a154=(a020*a154);
  a178=(a178-a154);
  a149=(a008*a175);
  a180=(a180*a014);
  a162=(a020*a162);
  a180=(a180-a162);
  a162=(a150*a014);
  a180=(a180-a162);
  a058=(a020*a161);
  a058=(a058*a161);
  a180=(a180+a058);
  a058=(a180+a165);
  a149=(a149*a058);
  a178=(a178+a149);
  a178=(a012*a178);
  a153=(a153+a178);
  a152=(a008*a152);
  a150=(a150*a011);
  a178=(a049*a179);
  a178=(a178-a162);
  a178=(a178+a165);
  a178=(a012*a178);
  a150=(a150+a178);
  a150=(a152*a150);
  a153=(a153+a150);
  a150=(a153/a181);
  a178=(a179*a008);
  a158=(a158+a177);
  a178=(a178*a158);
  a151=(a151+a154);
  a178=(a178+a151);
  a178=(a012*a178);
  a153=(a185*a153);
  a178=(a178-a153);
  a178=(a178/a183);
  a153=(a185*a178);
  a150=(a150-a153);
  a153=(a069*a500);
  a154=(a072*a015);
  a081=(a081*a008);
  a077=(a077*a011);
  a158=(a088*a076);
  a177=(a014*a076);
  a177=(a177*a076);
  a158=(a158-a177);
  a091=(a008*a091);
  a162=(a086*a091);
  a162=(a162-a093);
  a093=(a020*a076);
  a093=(a093*a076);
  a058=(a081*a093);
  a162=(a162-a058);
  a162=(a162-a096);
  a162=(a162+a100);
  a162=(a162-a099);
  a162=(a162+a105);
  a105=(a014*a103);
  a091=(a105*a091);
  a162=(a162+a091);
  a162=(a012*a162);
  a078=(a078+a162);
  a078=(a078-a047);
  a078=(a078+a107);
  a107=(a078/a109);
  a078=(a113*a078);
  a108=(a108-a078);
  a108=(a108/a111);
  a078=(a113*a108);
  a107=(a107-a078);
  a078=(2.*a107);
  a162=(a078*a020);
  a158=(a158-a162);
  a158=(a012*a158);
  a077=(a077+a158);
  a081=(a081*a077);
  a095=(a095*a013);
  a081=(a081+a095);
  a106=(a020*a106);
  a079=(a079*a014);
  a106=(a106-a079);
  a095=(a084*a008);
  a077=(a177+a162);
  a101=(a101*a089);
  a158=(a108*a020);
  a101=(a101-a158);
  a158=(a014*a090);
  a101=(a101-a158);
  a077=(a077+a101);
  a095=(a095*a077);
  a106=(a106-a095);
  a082=(a020*a082);
  a106=(a106-a082);
  a077=(a008*a103);
  a108=(a108*a014);
  a090=(a020*a090);
  a108=(a108-a090);
  a090=(a078*a014);
  a108=(a108-a090);
  a158=(a020*a089);
  a158=(a158*a089);
  a108=(a108+a158);
  a158=(a108+a093);
  a077=(a077*a158);
  a106=(a106+a077);
  a106=(a012*a106);
  a081=(a081+a106);
  a080=(a008*a080);
  a078=(a078*a011);
  a106=(a049*a107);
  a106=(a106-a090);
  a106=(a106+a093);
  a106=(a012*a106);
  a078=(a078+a106);
  a078=(a080*a078);
  a081=(a081+a078);
  a078=(a081/a109);
  a106=(a107*a008);
  a086=(a086+a105);
  a106=(a106*a086);
  a079=(a079+a082);
  a106=(a106+a079);
  a106=(a012*a106);
  a081=(a113*a081);
  a106=(a106-a081);
  a106=(a106/a111);
  a081=(a113*a106);
  a078=(a078-a081);
  a081=(a075*a500);
  a081=(a027+a081);
  a082=(a078*a081);
  a162=(a162+a101);
  a162=(a083*a162);
  a095=(a095+a162);
  a095=(a095-a077);
  a108=(a085*a108);
  a095=(a095+a108);
  a095=(a095+a079);
  a095=(a012*a095);
  a108=(a095/a109);
  a077=(a107*a020);
  a177=(a177-a077);
  a083=(a083*a177);
  a084=(a107*a084);
  a084=(a084*a020);
  a084=(a084*a008);
  a083=(a083-a084);
  a107=(a107*a014);
  a084=(a107*a008);
  a084=(a084*a103);
  a083=(a083-a084);
  a107=(a107+a093);
  a085=(a085*a107);
  a083=(a083+a085);
  a083=(a083-a079);
  a083=(a012*a083);
  a095=(a113*a095);
  a083=(a083-a095);
  a083=(a083/a111);
  a095=(a113*a083);
  a108=(a108-a095);
  a095=(a075*a061);
  a095=(a034+a095);
  a079=(a108*a095);
  a082=(a082+a079);
  a080=(a080*a013);
  a080=(a088*a080);
  a098=(2.*a098);
  a094=(a094*a008);
  a094=(a088*a094);
  a098=(a098-a094);
  a102=(2.*a102);
  a098=(a098-a102);
  a102=(2.*a089);
  a102=(a102-a088);
  a088=(a087*a102);
  a098=(a098+a088);
  a102=(a104*a102);
  a098=(a098+a102);
  a098=(a012*a098);
  a080=(a080+a098);
  a098=(a080/a109);
  a102=(a042*a076);
  a102=(a102*a012);
  a097=(a097-a112);
  a102=(a102*a097);
  a080=(a113*a080);
  a102=(a102-a080);
  a102=(a102/a111);
  a080=(a113*a102);
  a098=(a098-a080);
  a080=(a075*a015);
  a080=(a500+a080);
  a112=(a098*a080);
  a076=(a076-a089);
  a076=(a048*a076);
  a087=(a087+a104);
  a087=(a087+a097);
  a076=(a076*a087);
  a109=(a076/a109);
  a076=(a113*a076);
  a076=(a076/a111);
  a113=(a113*a076);
  a109=(a109+a113);
  a113=(a429*a027);
  a111=(a017*a034);
  a113=(a113+a111);
  a111=(a023*a500);
  a087=(a003*a061);
  a111=(a111-a087);
  a113=(a113+a111);
  a111=(a075*a113);
  a111=(a061+a111);
  a087=(a109*a111);
  a112=(a112+a087);
  a082=(a082+a112);
  a082=(a074*a082);
  a154=(a154+a082);
  a154=(a500+a154);
  a082=(a071*a154);
  a153=(a153+a082);
  a153=(a027+a153);
  a082=(a150*a153);
  a037=(a037+a173);
  a037=(a155*a037);
  a167=(a167+a037);
  a167=(a167-a149);
  a180=(a157*a180);
  a167=(a167+a180);
  a167=(a167+a151);
  a167=(a012*a167);
  a180=(a167/a181);
  a149=(a179*a020);
  a022=(a022-a149);
  a155=(a155*a022);
  a156=(a179*a156);
  a156=(a156*a020);
  a156=(a156*a008);
  a155=(a155-a156);
  a179=(a179*a014);
  a156=(a179*a008);
  a156=(a156*a175);
  a155=(a155-a156);
  a179=(a179+a165);
  a157=(a157*a179);
  a155=(a155+a157);
  a155=(a155-a151);
  a155=(a012*a155);
  a167=(a185*a167);
  a155=(a155-a167);
  a155=(a155/a183);
  a167=(a185*a155);
  a180=(a180-a167);
  a167=(a069*a061);
  a151=(a072*a113);
  a081=(a106*a081);
  a095=(a083*a095);
  a081=(a081+a095);
  a095=(a102*a080);
  a157=(a076*a111);
  a095=(a095-a157);
  a081=(a081+a095);
  a081=(a074*a081);
  a151=(a151+a081);
  a151=(a061+a151);
  a081=(a071*a151);
  a167=(a167+a081);
  a167=(a034+a167);
  a081=(a180*a167);
  a082=(a082+a081);
  a152=(a152*a013);
  a152=(a160*a152);
  a170=(2.*a170);
  a166=(a166*a008);
  a166=(a160*a166);
  a170=(a170-a166);
  a174=(2.*a174);
  a170=(a170-a174);
  a174=(2.*a161);
  a174=(a174-a160);
  a160=(a159*a174);
  a170=(a170+a160);
  a174=(a176*a174);
  a170=(a170+a174);
  a170=(a012*a170);
  a152=(a152+a170);
  a170=(a152/a181);
  a174=(a042*a070);
  a174=(a174*a012);
  a169=(a169-a184);
  a174=(a174*a169);
  a152=(a185*a152);
  a174=(a174-a152);
  a174=(a174/a183);
  a152=(a185*a174);
  a170=(a170-a152);
  a152=(a069*a015);
  a117=(a117*a008);
  a110=(a110*a011);
  a184=(a124*a073);
  a160=(a014*a073);
  a160=(a160*a073);
  a184=(a184-a160);
  a126=(a008*a126);
  a166=(a122*a126);
  a166=(a166-a128);
  a128=(a020*a073);
  a128=(a128*a073);
  a081=(a117*a128);
  a166=(a166-a081);
  a166=(a166-a131);
  a166=(a166+a135);
  a166=(a166-a134);
  a166=(a166+a140);
  a140=(a014*a138);
  a126=(a140*a126);
  a166=(a166+a126);
  a166=(a012*a166);
  a114=(a114+a166);
  a114=(a114-a047);
  a114=(a114+a142);
  a142=(a114/a144);
  a114=(a148*a114);
  a143=(a143-a114);
  a143=(a143/a146);
  a114=(a148*a143);
  a142=(a142-a114);
  a114=(2.*a142);
  a166=(a114*a020);
  a184=(a184-a166);
  a184=(a012*a184);
  a110=(a110+a184);
  a117=(a117*a110);
  a130=(a130*a013);
  a117=(a117+a130);
  a141=(a020*a141);
  a115=(a115*a014);
  a141=(a141-a115);
  a130=(a120*a008);
  a110=(a160+a166);
  a136=(a136*a125);
  a184=(a143*a020);
  a136=(a136-a184);
  a184=(a014*a092);
  a136=(a136-a184);
  a110=(a110+a136);
  a130=(a130*a110);
  a141=(a141-a130);
  a118=(a020*a118);
  a141=(a141-a118);
  a110=(a008*a138);
  a143=(a143*a014);
  a092=(a020*a092);
  a143=(a143-a092);
  a092=(a114*a014);
  a143=(a143-a092);
  a184=(a020*a125);
  a184=(a184*a125);
  a143=(a143+a184);
  a184=(a143+a128);
  a110=(a110*a184);
  a141=(a141+a110);
  a141=(a012*a141);
  a117=(a117+a141);
  a116=(a008*a116);
  a114=(a114*a011);
  a141=(a049*a142);
  a141=(a141-a092);
  a141=(a141+a128);
  a141=(a012*a141);
  a114=(a114+a141);
  a114=(a116*a114);
  a117=(a117+a114);
  a114=(a117/a144);
  a141=(a142*a008);
  a122=(a122+a140);
  a141=(a141*a122);
  a115=(a115+a118);
  a141=(a141+a115);
  a141=(a012*a141);
  a117=(a148*a117);
  a141=(a141-a117);
  a141=(a141/a146);
  a117=(a148*a141);
  a114=(a114-a117);
  a117=(a072*a500);
  a080=(a074*a080);
  a117=(a117+a080);
  a117=(a027+a117);
  a080=(a114*a117);
  a166=(a166+a136);
  a166=(a119*a166);
  a130=(a130+a166);
  a130=(a130-a110);
  a143=(a121*a143);
  a130=(a130+a143);
  a130=(a130+a115);
  a130=(a012*a130);
  a143=(a130/a144);
  a110=(a142*a020);
  a160=(a160-a110);
  a119=(a119*a160);
  a120=(a142*a120);
  a120=(a120*a020);
  a120=(a120*a008);
  a119=(a119-a120);
  a142=(a142*a014);
  a120=(a142*a008);
  a120=(a120*a138);
  a119=(a119-a120);
  a142=(a142+a128);
  a121=(a121*a142);
  a119=(a119+a121);
  a119=(a119-a115);
  a119=(a012*a119);
  a130=(a148*a130);
  a119=(a119-a130);
  a119=(a119/a146);
  a130=(a148*a119);
  a143=(a143-a130);
  a130=(a072*a061);
  a111=(a074*a111);
  a130=(a130+a111);
  a130=(a034+a130);
  a111=(a143*a130);
  a080=(a080+a111);
  a116=(a116*a013);
  a116=(a124*a116);
  a133=(2.*a133);
  a129=(a129*a008);
  a129=(a124*a129);
  a133=(a133-a129);
  a137=(2.*a137);
  a133=(a133-a137);
  a137=(2.*a125);
  a137=(a137-a124);
  a124=(a123*a137);
  a133=(a133+a124);
  a137=(a139*a137);
  a133=(a133+a137);
  a133=(a012*a133);
  a116=(a116+a133);
  a133=(a116/a144);
  a137=(a042*a073);
  a137=(a137*a012);
  a132=(a132-a147);
  a137=(a137*a132);
  a116=(a148*a116);
  a137=(a137-a116);
  a137=(a137/a146);
  a116=(a148*a137);
  a133=(a133-a116);
  a116=(a133*a154);
  a073=(a073-a125);
  a073=(a048*a073);
  a123=(a123+a139);
  a123=(a123+a132);
  a073=(a073*a123);
  a144=(a073/a144);
  a073=(a148*a073);
  a073=(a073/a146);
  a148=(a148*a073);
  a144=(a144+a148);
  a148=(a144*a151);
  a116=(a116+a148);
  a080=(a080+a116);
  a116=(a071*a080);
  a152=(a152+a116);
  a152=(a500+a152);
  a116=(a170*a152);
  a070=(a070-a161);
  a070=(a048*a070);
  a159=(a159+a176);
  a159=(a159+a169);
  a070=(a070*a159);
  a181=(a070/a181);
  a070=(a185*a070);
  a070=(a070/a183);
  a185=(a185*a070);
  a181=(a181+a185);
  a185=(a069*a113);
  a117=(a141*a117);
  a130=(a119*a130);
  a117=(a117+a130);
  a130=(a137*a154);
  a183=(a073*a151);
  a130=(a130-a183);
  a117=(a117+a130);
  a130=(a071*a117);
  a185=(a185+a130);
  a185=(a061+a185);
  a130=(a181*a185);
  a116=(a116+a130);
  a082=(a082+a116);
  a116=(a068*a082);
  a010=(a010+a116);
  a194=(a194*a008);
  a190=(a190*a011);
  a116=(a201*a188);
  a130=(a014*a188);
  a130=(a130*a188);
  a116=(a116-a130);
  a203=(a008*a203);
  a183=(a199*a203);
  a183=(a183-a205);
  a205=(a020*a188);
  a205=(a205*a188);
  a159=(a194*a205);
  a183=(a183-a159);
  a183=(a183-a208);
  a183=(a183+a212);
  a183=(a183-a211);
  a183=(a183+a217);
  a217=(a014*a215);
  a203=(a217*a203);
  a183=(a183+a203);
  a183=(a012*a183);
  a191=(a191+a183);
  a191=(a191-a047);
  a191=(a191+a219);
  a219=(a191/a221);
  a191=(a225*a191);
  a220=(a220-a191);
  a220=(a220/a223);
  a191=(a225*a220);
  a219=(a219-a191);
  a191=(2.*a219);
  a183=(a191*a020);
  a116=(a116-a183);
  a116=(a012*a116);
  a190=(a190+a116);
  a194=(a194*a190);
  a207=(a207*a013);
  a194=(a194+a207);
  a218=(a020*a218);
  a192=(a192*a014);
  a218=(a218-a192);
  a207=(a197*a008);
  a190=(a130+a183);
  a213=(a213*a202);
  a116=(a220*a020);
  a213=(a213-a116);
  a116=(a014*a127);
  a213=(a213-a116);
  a190=(a190+a213);
  a207=(a207*a190);
  a218=(a218-a207);
  a195=(a020*a195);
  a218=(a218-a195);
  a190=(a008*a215);
  a220=(a220*a014);
  a127=(a020*a127);
  a220=(a220-a127);
  a127=(a191*a014);
  a220=(a220-a127);
  a116=(a020*a202);
  a116=(a116*a202);
  a220=(a220+a116);
  a116=(a220+a205);
  a190=(a190*a116);
  a218=(a218+a190);
  a218=(a012*a218);
  a194=(a194+a218);
  a193=(a008*a193);
  a191=(a191*a011);
  a218=(a049*a219);
  a218=(a218-a127);
  a218=(a218+a205);
  a218=(a012*a218);
  a191=(a191+a218);
  a191=(a193*a191);
  a194=(a194+a191);
  a191=(a194/a221);
  a218=(a219*a008);
  a199=(a199+a217);
  a218=(a218*a199);
  a192=(a192+a195);
  a218=(a218+a192);
  a218=(a012*a218);
  a194=(a225*a194);
  a218=(a218-a194);
  a218=(a218/a223);
  a194=(a225*a218);
  a191=(a191-a194);
  a194=(a187*a500);
  a154=(a189*a154);
  a194=(a194+a154);
  a154=(a145*a152);
  a194=(a194+a154);
  a194=(a027+a194);
  a154=(a191*a194);
  a183=(a183+a213);
  a183=(a196*a183);
  a207=(a207+a183);
  a207=(a207-a190);
  a220=(a198*a220);
  a207=(a207+a220);
  a207=(a207+a192);
  a207=(a012*a207);
  a220=(a207/a221);
  a190=(a219*a020);
  a130=(a130-a190);
  a196=(a196*a130);
  a197=(a219*a197);
  a197=(a197*a020);
  a197=(a197*a008);
  a196=(a196-a197);
  a219=(a219*a014);
  a197=(a219*a008);
  a197=(a197*a215);
  a196=(a196-a197);
  a219=(a219+a205);
  a198=(a198*a219);
  a196=(a196+a198);
  a196=(a196-a192);
  a196=(a012*a196);
  a207=(a225*a207);
  a196=(a196-a207);
  a196=(a196/a223);
  a207=(a225*a196);
  a220=(a220-a207);
  a207=(a187*a061);
  a151=(a189*a151);
  a207=(a207+a151);
  a151=(a145*a185);
  a207=(a207+a151);
  a207=(a034+a207);
  a151=(a220*a207);
  a154=(a154+a151);
  a193=(a193*a013);
  a193=(a201*a193);
  a210=(2.*a210);
  a206=(a206*a008);
  a206=(a201*a206);
  a210=(a210-a206);
  a214=(2.*a214);
  a210=(a210-a214);
  a214=(2.*a202);
  a214=(a214-a201);
  a201=(a200*a214);
  a210=(a210+a201);
  a214=(a216*a214);
  a210=(a210+a214);
  a210=(a012*a210);
  a193=(a193+a210);
  a210=(a193/a221);
  a214=(a042*a188);
  a214=(a214*a012);
  a209=(a209-a224);
  a214=(a214*a209);
  a193=(a225*a193);
  a214=(a214-a193);
  a214=(a214/a223);
  a193=(a225*a214);
  a210=(a210-a193);
  a193=(a187*a015);
  a080=(a189*a080);
  a193=(a193+a080);
  a080=(a145*a082);
  a193=(a193+a080);
  a193=(a500+a193);
  a080=(a210*a193);
  a188=(a188-a202);
  a188=(a048*a188);
  a200=(a200+a216);
  a200=(a200+a209);
  a188=(a188*a200);
  a221=(a188/a221);
  a188=(a225*a188);
  a188=(a188/a223);
  a225=(a225*a188);
  a221=(a221+a225);
  a225=(a187*a113);
  a117=(a189*a117);
  a225=(a225+a117);
  a153=(a178*a153);
  a167=(a155*a167);
  a153=(a153+a167);
  a167=(a174*a152);
  a117=(a070*a185);
  a167=(a167-a117);
  a153=(a153+a167);
  a167=(a145*a153);
  a225=(a225+a167);
  a225=(a061+a225);
  a167=(a221*a225);
  a080=(a080+a167);
  a154=(a154+a080);
  a080=(a186*a154);
  a010=(a010+a080);
  a010=(a500+a010);
  a080=(a005*a010);
  a474=(a474+a080);
  a080=(a227*a015);
  a167=(a229*a082);
  a080=(a080+a167);
  a167=(a230*a154);
  a080=(a080+a167);
  a236=(a236*a008);
  a232=(a232*a011);
  a167=(a243*a067);
  a117=(a014*a067);
  a117=(a117*a067);
  a167=(a167-a117);
  a246=(a008*a246);
  a223=(a241*a246);
  a223=(a223-a248);
  a248=(a020*a067);
  a248=(a248*a067);
  a200=(a236*a248);
  a223=(a223-a200);
  a223=(a223-a251);
  a223=(a223+a255);
  a223=(a223-a254);
  a223=(a223+a260);
  a260=(a014*a258);
  a246=(a260*a246);
  a223=(a223+a246);
  a223=(a012*a223);
  a233=(a233+a223);
  a233=(a233-a047);
  a233=(a233+a262);
  a262=(a233/a264);
  a233=(a268*a233);
  a263=(a263-a233);
  a263=(a263/a266);
  a233=(a268*a263);
  a262=(a262-a233);
  a233=(2.*a262);
  a223=(a233*a020);
  a167=(a167-a223);
  a167=(a012*a167);
  a232=(a232+a167);
  a236=(a236*a232);
  a250=(a250*a013);
  a236=(a236+a250);
  a261=(a020*a261);
  a234=(a234*a014);
  a261=(a261-a234);
  a250=(a239*a008);
  a232=(a117+a223);
  a256=(a256*a244);
  a167=(a263*a020);
  a256=(a256-a167);
  a167=(a014*a245);
  a256=(a256-a167);
  a232=(a232+a256);
  a250=(a250*a232);
  a261=(a261-a250);
  a237=(a020*a237);
  a261=(a261-a237);
  a232=(a008*a258);
  a263=(a263*a014);
  a245=(a020*a245);
  a263=(a263-a245);
  a245=(a233*a014);
  a263=(a263-a245);
  a167=(a020*a244);
  a167=(a167*a244);
  a263=(a263+a167);
  a167=(a263+a248);
  a232=(a232*a167);
  a261=(a261+a232);
  a261=(a012*a261);
  a236=(a236+a261);
  a235=(a008*a235);
  a233=(a233*a011);
  a261=(a049*a262);
  a261=(a261-a245);
  a261=(a261+a248);
  a261=(a012*a261);
  a233=(a233+a261);
  a233=(a235*a233);
  a236=(a236+a233);
  a233=(a236/a264);
  a261=(a262*a008);
  a241=(a241+a260);
  a261=(a261*a241);
  a234=(a234+a237);
  a261=(a261+a234);
  a261=(a012*a261);
  a236=(a268*a236);
  a261=(a261-a236);
  a261=(a261/a266);
  a236=(a268*a261);
  a233=(a233-a236);
  a236=(a006*a500);
  a237=(a068*a152);
  a236=(a236+a237);
  a237=(a186*a193);
  a236=(a236+a237);
  a236=(a027+a236);
  a237=(a233*a236);
  a223=(a223+a256);
  a223=(a238*a223);
  a250=(a250+a223);
  a250=(a250-a232);
  a263=(a240*a263);
  a250=(a250+a263);
  a250=(a250+a234);
  a250=(a012*a250);
  a263=(a250/a264);
  a232=(a262*a020);
  a117=(a117-a232);
  a238=(a238*a117);
  a239=(a262*a239);
  a239=(a239*a020);
  a239=(a239*a008);
  a238=(a238-a239);
  a262=(a262*a014);
  a239=(a262*a008);
  a239=(a239*a258);
  a238=(a238-a239);
  a262=(a262+a248);
  a240=(a240*a262);
  a238=(a238+a240);
  a238=(a238-a234);
  a238=(a012*a238);
  a250=(a268*a250);
  a238=(a238-a250);
  a238=(a238/a266);
  a250=(a268*a238);
  a263=(a263-a250);
  a250=(a006*a061);
  a234=(a068*a185);
  a250=(a250+a234);
  a234=(a186*a225);
  a250=(a250+a234);
  a250=(a034+a250);
  a234=(a263*a250);
  a237=(a237+a234);
  a235=(a235*a013);
  a235=(a243*a235);
  a253=(2.*a253);
  a249=(a249*a008);
  a249=(a243*a249);
  a253=(a253-a249);
  a257=(2.*a257);
  a253=(a253-a257);
  a257=(2.*a244);
  a257=(a257-a243);
  a243=(a242*a257);
  a253=(a253+a243);
  a257=(a259*a257);
  a253=(a253+a257);
  a253=(a012*a253);
  a235=(a235+a253);
  a253=(a235/a264);
  a257=(a042*a067);
  a257=(a257*a012);
  a252=(a252-a267);
  a257=(a257*a252);
  a235=(a268*a235);
  a257=(a257-a235);
  a257=(a257/a266);
  a235=(a268*a257);
  a253=(a253-a235);
  a235=(a253*a010);
  a067=(a067-a244);
  a067=(a048*a067);
  a242=(a242+a259);
  a242=(a242+a252);
  a067=(a067*a242);
  a264=(a067/a264);
  a067=(a268*a067);
  a067=(a067/a266);
  a268=(a268*a067);
  a264=(a264+a268);
  a268=(a006*a113);
  a266=(a068*a153);
  a268=(a268+a266);
  a194=(a218*a194);
  a207=(a196*a207);
  a194=(a194+a207);
  a207=(a214*a193);
  a266=(a188*a225);
  a207=(a207-a266);
  a194=(a194+a207);
  a207=(a186*a194);
  a268=(a268+a207);
  a268=(a061+a268);
  a207=(a264*a268);
  a235=(a235+a207);
  a237=(a237+a235);
  a235=(a231*a237);
  a080=(a080+a235);
  a080=(a500+a080);
  a235=(a226*a080);
  a474=(a474+a235);
  a235=(a270*a015);
  a207=(a272*a082);
  a235=(a235+a207);
  a207=(a273*a154);
  a235=(a235+a207);
  a207=(a274*a237);
  a235=(a235+a207);
  a280=(a280*a008);
  a276=(a276*a011);
  a207=(a287*a228);
  a266=(a014*a228);
  a266=(a266*a228);
  a207=(a207-a266);
  a290=(a008*a290);
  a242=(a285*a290);
  a242=(a242-a292);
  a292=(a020*a228);
  a292=(a292*a228);
  a252=(a280*a292);
  a242=(a242-a252);
  a242=(a242-a295);
  a242=(a242+a299);
  a242=(a242-a298);
  a242=(a242+a304);
  a304=(a014*a302);
  a290=(a304*a290);
  a242=(a242+a290);
  a242=(a012*a242);
  a277=(a277+a242);
  a277=(a277-a047);
  a277=(a277+a306);
  a306=(a277/a308);
  a277=(a312*a277);
  a307=(a307-a277);
  a307=(a307/a310);
  a277=(a312*a307);
  a306=(a306-a277);
  a277=(2.*a306);
  a242=(a277*a020);
  a207=(a207-a242);
  a207=(a012*a207);
  a276=(a276+a207);
  a280=(a280*a276);
  a294=(a294*a013);
  a280=(a280+a294);
  a305=(a020*a305);
  a278=(a278*a014);
  a305=(a305-a278);
  a294=(a283*a008);
  a276=(a266+a242);
  a300=(a300*a288);
  a207=(a307*a020);
  a300=(a300-a207);
  a207=(a014*a289);
  a300=(a300-a207);
  a276=(a276+a300);
  a294=(a294*a276);
  a305=(a305-a294);
  a281=(a020*a281);
  a305=(a305-a281);
  a276=(a008*a302);
  a307=(a307*a014);
  a289=(a020*a289);
  a307=(a307-a289);
  a289=(a277*a014);
  a307=(a307-a289);
  a207=(a020*a288);
  a207=(a207*a288);
  a307=(a307+a207);
  a207=(a307+a292);
  a276=(a276*a207);
  a305=(a305+a276);
  a305=(a012*a305);
  a280=(a280+a305);
  a279=(a008*a279);
  a277=(a277*a011);
  a305=(a049*a306);
  a305=(a305-a289);
  a305=(a305+a292);
  a305=(a012*a305);
  a277=(a277+a305);
  a277=(a279*a277);
  a280=(a280+a277);
  a277=(a280/a308);
  a305=(a306*a008);
  a285=(a285+a304);
  a305=(a305*a285);
  a278=(a278+a281);
  a305=(a305+a278);
  a305=(a012*a305);
  a280=(a312*a280);
  a305=(a305-a280);
  a305=(a305/a310);
  a280=(a312*a305);
  a277=(a277-a280);
  a280=(a227*a500);
  a281=(a229*a152);
  a280=(a280+a281);
  a281=(a230*a193);
  a280=(a280+a281);
  a281=(a231*a010);
  a280=(a280+a281);
  a280=(a027+a280);
  a281=(a277*a280);
  a242=(a242+a300);
  a242=(a282*a242);
  a294=(a294+a242);
  a294=(a294-a276);
  a307=(a284*a307);
  a294=(a294+a307);
  a294=(a294+a278);
  a294=(a012*a294);
  a307=(a294/a308);
  a276=(a306*a020);
  a266=(a266-a276);
  a282=(a282*a266);
  a283=(a306*a283);
  a283=(a283*a020);
  a283=(a283*a008);
  a282=(a282-a283);
  a306=(a306*a014);
  a283=(a306*a008);
  a283=(a283*a302);
  a282=(a282-a283);
  a306=(a306+a292);
  a284=(a284*a306);
  a282=(a282+a284);
  a282=(a282-a278);
  a282=(a012*a282);
  a294=(a312*a294);
  a282=(a282-a294);
  a282=(a282/a310);
  a294=(a312*a282);
  a307=(a307-a294);
  a294=(a227*a061);
  a278=(a229*a185);
  a294=(a294+a278);
  a278=(a230*a225);
  a294=(a294+a278);
  a278=(a231*a268);
  a294=(a294+a278);
  a294=(a034+a294);
  a278=(a307*a294);
  a281=(a281+a278);
  a279=(a279*a013);
  a279=(a287*a279);
  a297=(2.*a297);
  a293=(a293*a008);
  a293=(a287*a293);
  a297=(a297-a293);
  a301=(2.*a301);
  a297=(a297-a301);
  a301=(2.*a288);
  a301=(a301-a287);
  a287=(a286*a301);
  a297=(a297+a287);
  a301=(a303*a301);
  a297=(a297+a301);
  a297=(a012*a297);
  a279=(a279+a297);
  a297=(a279/a308);
  a301=(a042*a228);
  a301=(a301*a012);
  a296=(a296-a311);
  a301=(a301*a296);
  a279=(a312*a279);
  a301=(a301-a279);
  a301=(a301/a310);
  a279=(a312*a301);
  a297=(a297-a279);
  a279=(a297*a080);
  a228=(a228-a288);
  a228=(a048*a228);
  a286=(a286+a303);
  a286=(a286+a296);
  a228=(a228*a286);
  a308=(a228/a308);
  a228=(a312*a228);
  a228=(a228/a310);
  a312=(a312*a228);
  a308=(a308+a312);
  a312=(a227*a113);
  a310=(a229*a153);
  a312=(a312+a310);
  a310=(a230*a194);
  a312=(a312+a310);
  a236=(a261*a236);
  a250=(a238*a250);
  a236=(a236+a250);
  a250=(a257*a010);
  a310=(a067*a268);
  a250=(a250-a310);
  a236=(a236+a250);
  a250=(a231*a236);
  a312=(a312+a250);
  a312=(a061+a312);
  a250=(a308*a312);
  a279=(a279+a250);
  a281=(a281+a279);
  a279=(a275*a281);
  a235=(a235+a279);
  a235=(a500+a235);
  a279=(a269*a235);
  a474=(a474+a279);
  a279=(a314*a015);
  a250=(a316*a082);
  a279=(a279+a250);
  a250=(a317*a154);
  a279=(a279+a250);
  a250=(a318*a237);
  a279=(a279+a250);
  a250=(a319*a281);
  a279=(a279+a250);
  a325=(a325*a008);
  a321=(a321*a011);
  a250=(a332*a271);
  a310=(a014*a271);
  a310=(a310*a271);
  a250=(a250-a310);
  a335=(a008*a335);
  a286=(a330*a335);
  a286=(a286-a337);
  a337=(a020*a271);
  a337=(a337*a271);
  a296=(a325*a337);
  a286=(a286-a296);
  a286=(a286-a340);
  a286=(a286+a344);
  a286=(a286-a343);
  a286=(a286+a349);
  a349=(a014*a347);
  a335=(a349*a335);
  a286=(a286+a335);
  a286=(a012*a286);
  a322=(a322+a286);
  a322=(a322-a047);
  a322=(a322+a351);
  a351=(a322/a353);
  a322=(a357*a322);
  a352=(a352-a322);
  a352=(a352/a355);
  a322=(a357*a352);
  a351=(a351-a322);
  a322=(2.*a351);
  a286=(a322*a020);
  a250=(a250-a286);
  a250=(a012*a250);
  a321=(a321+a250);
  a325=(a325*a321);
  a339=(a339*a013);
  a325=(a325+a339);
  a350=(a020*a350);
  a323=(a323*a014);
  a350=(a350-a323);
  a339=(a328*a008);
  a321=(a310+a286);
  a345=(a345*a333);
  a250=(a352*a020);
  a345=(a345-a250);
  a250=(a014*a334);
  a345=(a345-a250);
  a321=(a321+a345);
  a339=(a339*a321);
  a350=(a350-a339);
  a326=(a020*a326);
  a350=(a350-a326);
  a321=(a008*a347);
  a352=(a352*a014);
  a334=(a020*a334);
  a352=(a352-a334);
  a334=(a322*a014);
  a352=(a352-a334);
  a250=(a020*a333);
  a250=(a250*a333);
  a352=(a352+a250);
  a250=(a352+a337);
  a321=(a321*a250);
  a350=(a350+a321);
  a350=(a012*a350);
  a325=(a325+a350);
  a324=(a008*a324);
  a322=(a322*a011);
  a350=(a049*a351);
  a350=(a350-a334);
  a350=(a350+a337);
  a350=(a012*a350);
  a322=(a322+a350);
  a322=(a324*a322);
  a325=(a325+a322);
  a322=(a325/a353);
  a350=(a351*a008);
  a330=(a330+a349);
  a350=(a350*a330);
  a323=(a323+a326);
  a350=(a350+a323);
  a350=(a012*a350);
  a325=(a357*a325);
  a350=(a350-a325);
  a350=(a350/a355);
  a325=(a357*a350);
  a322=(a322-a325);
  a325=(a270*a500);
  a326=(a272*a152);
  a325=(a325+a326);
  a326=(a273*a193);
  a325=(a325+a326);
  a326=(a274*a010);
  a325=(a325+a326);
  a326=(a275*a080);
  a325=(a325+a326);
  a325=(a027+a325);
  a326=(a322*a325);
  a286=(a286+a345);
  a286=(a327*a286);
  a339=(a339+a286);
  a339=(a339-a321);
  a352=(a329*a352);
  a339=(a339+a352);
  a339=(a339+a323);
  a339=(a012*a339);
  a352=(a339/a353);
  a321=(a351*a020);
  a310=(a310-a321);
  a327=(a327*a310);
  a328=(a351*a328);
  a328=(a328*a020);
  a328=(a328*a008);
  a327=(a327-a328);
  a351=(a351*a014);
  a328=(a351*a008);
  a328=(a328*a347);
  a327=(a327-a328);
  a351=(a351+a337);
  a329=(a329*a351);
  a327=(a327+a329);
  a327=(a327-a323);
  a327=(a012*a327);
  a339=(a357*a339);
  a327=(a327-a339);
  a327=(a327/a355);
  a339=(a357*a327);
  a352=(a352-a339);
  a339=(a270*a061);
  a323=(a272*a185);
  a339=(a339+a323);
  a323=(a273*a225);
  a339=(a339+a323);
  a323=(a274*a268);
  a339=(a339+a323);
  a323=(a275*a312);
  a339=(a339+a323);
  a339=(a034+a339);
  a323=(a352*a339);
  a326=(a326+a323);
  a324=(a324*a013);
  a324=(a332*a324);
  a342=(2.*a342);
  a338=(a338*a008);
  a338=(a332*a338);
  a342=(a342-a338);
  a346=(2.*a346);
  a342=(a342-a346);
  a346=(2.*a333);
  a346=(a346-a332);
  a332=(a331*a346);
  a342=(a342+a332);
  a346=(a348*a346);
  a342=(a342+a346);
  a342=(a012*a342);
  a324=(a324+a342);
  a342=(a324/a353);
  a346=(a042*a271);
  a346=(a346*a012);
  a341=(a341-a356);
  a346=(a346*a341);
  a324=(a357*a324);
  a346=(a346-a324);
  a346=(a346/a355);
  a324=(a357*a346);
  a342=(a342-a324);
  a324=(a342*a235);
  a271=(a271-a333);
  a271=(a048*a271);
  a331=(a331+a348);
  a331=(a331+a341);
  a271=(a271*a331);
  a353=(a271/a353);
  a271=(a357*a271);
  a271=(a271/a355);
  a357=(a357*a271);
  a353=(a353+a357);
  a357=(a270*a113);
  a355=(a272*a153);
  a357=(a357+a355);
  a355=(a273*a194);
  a357=(a357+a355);
  a355=(a274*a236);
  a357=(a357+a355);
  a280=(a305*a280);
  a294=(a282*a294);
  a280=(a280+a294);
  a294=(a301*a080);
  a355=(a228*a312);
  a294=(a294-a355);
  a280=(a280+a294);
  a294=(a275*a280);
  a357=(a357+a294);
  a357=(a061+a357);
  a294=(a353*a357);
  a324=(a324+a294);
  a326=(a326+a324);
  a324=(a320*a326);
  a279=(a279+a324);
  a279=(a500+a279);
  a324=(a313*a279);
  a474=(a474+a324);
  a324=(a359*a015);
  a294=(a361*a082);
  a324=(a324+a294);
  a294=(a362*a154);
  a324=(a324+a294);
  a294=(a363*a237);
  a324=(a324+a294);
  a294=(a364*a281);
  a324=(a324+a294);
  a294=(a365*a326);
  a324=(a324+a294);
  a371=(a371*a008);
  a367=(a367*a011);
  a294=(a378*a315);
  a355=(a014*a315);
  a355=(a355*a315);
  a294=(a294-a355);
  a381=(a008*a381);
  a331=(a376*a381);
  a331=(a331-a383);
  a383=(a020*a315);
  a383=(a383*a315);
  a341=(a371*a383);
  a331=(a331-a341);
  a331=(a331-a386);
  a331=(a331+a390);
  a331=(a331-a389);
  a331=(a331+a395);
  a395=(a014*a393);
  a381=(a395*a381);
  a331=(a331+a381);
  a331=(a012*a331);
  a368=(a368+a331);
  a368=(a368-a047);
  a368=(a368+a397);
  a397=(a368/a399);
  a368=(a403*a368);
  a398=(a398-a368);
  a398=(a398/a401);
  a368=(a403*a398);
  a397=(a397-a368);
  a368=(2.*a397);
  a331=(a368*a020);
  a294=(a294-a331);
  a294=(a012*a294);
  a367=(a367+a294);
  a371=(a371*a367);
  a385=(a385*a013);
  a371=(a371+a385);
  a396=(a020*a396);
  a369=(a369*a014);
  a396=(a396-a369);
  a385=(a374*a008);
  a367=(a355+a331);
  a391=(a391*a379);
  a294=(a398*a020);
  a391=(a391-a294);
  a294=(a014*a380);
  a391=(a391-a294);
  a367=(a367+a391);
  a385=(a385*a367);
  a396=(a396-a385);
  a372=(a020*a372);
  a396=(a396-a372);
  a367=(a008*a393);
  a398=(a398*a014);
  a380=(a020*a380);
  a398=(a398-a380);
  a380=(a368*a014);
  a398=(a398-a380);
  a294=(a020*a379);
  a294=(a294*a379);
  a398=(a398+a294);
  a294=(a398+a383);
  a367=(a367*a294);
  a396=(a396+a367);
  a396=(a012*a396);
  a371=(a371+a396);
  a370=(a008*a370);
  a368=(a368*a011);
  a396=(a049*a397);
  a396=(a396-a380);
  a396=(a396+a383);
  a396=(a012*a396);
  a368=(a368+a396);
  a368=(a370*a368);
  a371=(a371+a368);
  a368=(a371/a399);
  a396=(a397*a008);
  a376=(a376+a395);
  a396=(a396*a376);
  a369=(a369+a372);
  a396=(a396+a369);
  a396=(a012*a396);
  a371=(a403*a371);
  a396=(a396-a371);
  a396=(a396/a401);
  a371=(a403*a396);
  a368=(a368-a371);
  a371=(a314*a500);
  a372=(a316*a152);
  a371=(a371+a372);
  a372=(a317*a193);
  a371=(a371+a372);
  a372=(a318*a010);
  a371=(a371+a372);
  a372=(a319*a080);
  a371=(a371+a372);
  a372=(a320*a235);
  a371=(a371+a372);
  a371=(a027+a371);
  a372=(a368*a371);
  a331=(a331+a391);
  a331=(a373*a331);
  a385=(a385+a331);
  a385=(a385-a367);
  a398=(a375*a398);
  a385=(a385+a398);
  a385=(a385+a369);
  a385=(a012*a385);
  a398=(a385/a399);
  a367=(a397*a020);
  a355=(a355-a367);
  a373=(a373*a355);
  a374=(a397*a374);
  a374=(a374*a020);
  a374=(a374*a008);
  a373=(a373-a374);
  a397=(a397*a014);
  a374=(a397*a008);
  a374=(a374*a393);
  a373=(a373-a374);
  a397=(a397+a383);
  a375=(a375*a397);
  a373=(a373+a375);
  a373=(a373-a369);
  a373=(a012*a373);
  a385=(a403*a385);
  a373=(a373-a385);
  a373=(a373/a401);
  a385=(a403*a373);
  a398=(a398-a385);
  a385=(a314*a061);
  a369=(a316*a185);
  a385=(a385+a369);
  a369=(a317*a225);
  a385=(a385+a369);
  a369=(a318*a268);
  a385=(a385+a369);
  a369=(a319*a312);
  a385=(a385+a369);
  a369=(a320*a357);
  a385=(a385+a369);
  a385=(a034+a385);
  a369=(a398*a385);
  a372=(a372+a369);
  a370=(a370*a013);
  a370=(a378*a370);
  a388=(2.*a388);
  a384=(a384*a008);
  a384=(a378*a384);
  a388=(a388-a384);
  a392=(2.*a392);
  a388=(a388-a392);
  a392=(2.*a379);
  a392=(a392-a378);
  a378=(a377*a392);
  a388=(a388+a378);
  a392=(a394*a392);
  a388=(a388+a392);
  a388=(a012*a388);
  a370=(a370+a388);
  a388=(a370/a399);
  a392=(a042*a315);
  a392=(a392*a012);
  a387=(a387-a402);
  a392=(a392*a387);
  a370=(a403*a370);
  a392=(a392-a370);
  a392=(a392/a401);
  a370=(a403*a392);
  a388=(a388-a370);
  a370=(a388*a279);
  a315=(a315-a379);
  a315=(a048*a315);
  a377=(a377+a394);
  a377=(a377+a387);
  a315=(a315*a377);
  a399=(a315/a399);
  a315=(a403*a315);
  a315=(a315/a401);
  a403=(a403*a315);
  a399=(a399+a403);
  a403=(a314*a113);
  a401=(a316*a153);
  a403=(a403+a401);
  a401=(a317*a194);
  a403=(a403+a401);
  a401=(a318*a236);
  a403=(a403+a401);
  a401=(a319*a280);
  a403=(a403+a401);
  a325=(a350*a325);
  a339=(a327*a339);
  a325=(a325+a339);
  a339=(a346*a235);
  a401=(a271*a357);
  a339=(a339-a401);
  a325=(a325+a339);
  a339=(a320*a325);
  a403=(a403+a339);
  a403=(a061+a403);
  a339=(a399*a403);
  a370=(a370+a339);
  a372=(a372+a370);
  a370=(a366*a372);
  a324=(a324+a370);
  a324=(a500+a324);
  a370=(a358*a324);
  a474=(a474+a370);
  a370=(a405*a015);
  a339=(a407*a082);
  a370=(a370+a339);
  a339=(a408*a154);
  a370=(a370+a339);
  a339=(a409*a237);
  a370=(a370+a339);
  a339=(a410*a281);
  a370=(a370+a339);
  a339=(a411*a326);
  a370=(a370+a339);
  a339=(a412*a372);
  a370=(a370+a339);
  a418=(a418*a008);
  a414=(a414*a011);
  a339=(a425*a360);
  a401=(a014*a360);
  a401=(a401*a360);
  a339=(a339-a401);
  a428=(a008*a428);
  a377=(a423*a428);
  a377=(a377-a430);
  a430=(a020*a360);
  a430=(a430*a360);
  a387=(a418*a430);
  a377=(a377-a387);
  a377=(a377-a433);
  a377=(a377+a437);
  a377=(a377-a436);
  a377=(a377+a442);
  a442=(a014*a440);
  a428=(a442*a428);
  a377=(a377+a428);
  a377=(a012*a377);
  a415=(a415+a377);
  a415=(a415-a047);
  a415=(a415+a444);
  a444=(a415/a446);
  a415=(a450*a415);
  a445=(a445-a415);
  a445=(a445/a448);
  a415=(a450*a445);
  a444=(a444-a415);
  a415=(2.*a444);
  a377=(a415*a020);
  a339=(a339-a377);
  a339=(a012*a339);
  a414=(a414+a339);
  a418=(a418*a414);
  a432=(a432*a013);
  a418=(a418+a432);
  a443=(a020*a443);
  a416=(a416*a014);
  a443=(a443-a416);
  a432=(a421*a008);
  a414=(a401+a377);
  a438=(a438*a426);
  a339=(a445*a020);
  a438=(a438-a339);
  a339=(a014*a427);
  a438=(a438-a339);
  a414=(a414+a438);
  a432=(a432*a414);
  a443=(a443-a432);
  a419=(a020*a419);
  a443=(a443-a419);
  a414=(a008*a440);
  a445=(a445*a014);
  a427=(a020*a427);
  a445=(a445-a427);
  a427=(a415*a014);
  a445=(a445-a427);
  a339=(a020*a426);
  a339=(a339*a426);
  a445=(a445+a339);
  a339=(a445+a430);
  a414=(a414*a339);
  a443=(a443+a414);
  a443=(a012*a443);
  a418=(a418+a443);
  a417=(a008*a417);
  a415=(a415*a011);
  a443=(a049*a444);
  a443=(a443-a427);
  a443=(a443+a430);
  a443=(a012*a443);
  a415=(a415+a443);
  a415=(a417*a415);
  a418=(a418+a415);
  a415=(a418/a446);
  a443=(a444*a008);
  a423=(a423+a442);
  a443=(a443*a423);
  a416=(a416+a419);
  a443=(a443+a416);
  a443=(a012*a443);
  a418=(a450*a418);
  a443=(a443-a418);
  a443=(a443/a448);
  a418=(a450*a443);
  a415=(a415-a418);
  a418=(a359*a500);
  a419=(a361*a152);
  a418=(a418+a419);
  a419=(a362*a193);
  a418=(a418+a419);
  a419=(a363*a010);
  a418=(a418+a419);
  a419=(a364*a080);
  a418=(a418+a419);
  a419=(a365*a235);
  a418=(a418+a419);
  a419=(a366*a279);
  a418=(a418+a419);
  a418=(a027+a418);
  a419=(a415*a418);
  a377=(a377+a438);
  a377=(a420*a377);
  a432=(a432+a377);
  a432=(a432-a414);
  a445=(a422*a445);
  a432=(a432+a445);
  a432=(a432+a416);
  a432=(a012*a432);
  a445=(a432/a446);
  a414=(a444*a020);
  a401=(a401-a414);
  a420=(a420*a401);
  a421=(a444*a421);
  a421=(a421*a020);
  a421=(a421*a008);
  a420=(a420-a421);
  a444=(a444*a014);
  a421=(a444*a008);
  a421=(a421*a440);
  a420=(a420-a421);
  a444=(a444+a430);
  a422=(a422*a444);
  a420=(a420+a422);
  a420=(a420-a416);
  a420=(a012*a420);
  a432=(a450*a432);
  a420=(a420-a432);
  a420=(a420/a448);
  a432=(a450*a420);
  a445=(a445-a432);
  a432=(a359*a061);
  a416=(a361*a185);
  a432=(a432+a416);
  a416=(a362*a225);
  a432=(a432+a416);
  a416=(a363*a268);
  a432=(a432+a416);
  a416=(a364*a312);
  a432=(a432+a416);
  a416=(a365*a357);
  a432=(a432+a416);
  a416=(a366*a403);
  a432=(a432+a416);
  a432=(a034+a432);
  a416=(a445*a432);
  a419=(a419+a416);
  a417=(a417*a013);
  a417=(a425*a417);
  a435=(2.*a435);
  a431=(a431*a008);
  a431=(a425*a431);
  a435=(a435-a431);
  a439=(2.*a439);
  a435=(a435-a439);
  a439=(2.*a426);
  a439=(a439-a425);
  a425=(a424*a439);
  a435=(a435+a425);
  a439=(a441*a439);
  a435=(a435+a439);
  a435=(a012*a435);
  a417=(a417+a435);
  a435=(a417/a446);
  a439=(a042*a360);
  a439=(a439*a012);
  a434=(a434-a449);
  a439=(a439*a434);
  a417=(a450*a417);
  a439=(a439-a417);
  a439=(a439/a448);
  a417=(a450*a439);
  a435=(a435-a417);
  a417=(a435*a324);
  a360=(a360-a426);
  a360=(a048*a360);
  a424=(a424+a441);
  a424=(a424+a434);
  a360=(a360*a424);
  a446=(a360/a446);
  a360=(a450*a360);
  a360=(a360/a448);
  a450=(a450*a360);
  a446=(a446+a450);
  a450=(a359*a113);
  a448=(a361*a153);
  a450=(a450+a448);
  a448=(a362*a194);
  a450=(a450+a448);
  a448=(a363*a236);
  a450=(a450+a448);
  a448=(a364*a280);
  a450=(a450+a448);
  a448=(a365*a325);
  a450=(a450+a448);
  a371=(a396*a371);
  a385=(a373*a385);
  a371=(a371+a385);
  a385=(a392*a279);
  a448=(a315*a403);
  a385=(a385-a448);
  a371=(a371+a385);
  a385=(a366*a371);
  a450=(a450+a385);
  a450=(a061+a450);
  a385=(a446*a450);
  a417=(a417+a385);
  a419=(a419+a417);
  a417=(a413*a419);
  a370=(a370+a417);
  a370=(a500+a370);
  a417=(a404*a370);
  a474=(a474+a417);
  a417=(a452*a015);
  a082=(a454*a082);
  a417=(a417+a082);
  a154=(a182*a154);
  a417=(a417+a154);
  a154=(a222*a237);
  a417=(a417+a154);
  a154=(a455*a281);
  a417=(a417+a154);
  a154=(a456*a326);
  a417=(a417+a154);
  a154=(a457*a372);
  a417=(a417+a154);
  a154=(a458*a419);
  a417=(a417+a154);
  a463=(a463*a008);
  a002=(a002*a011);
  a154=(a470*a406);
  a082=(a014*a406);
  a082=(a082*a406);
  a154=(a154-a082);
  a473=(a008*a473);
  a385=(a468*a473);
  a385=(a385-a475);
  a475=(a020*a406);
  a475=(a475*a406);
  a448=(a463*a475);
  a385=(a385-a448);
  a385=(a385-a478);
  a385=(a385+a482);
  a385=(a385-a481);
  a385=(a385+a487);
  a487=(a014*a485);
  a473=(a487*a473);
  a385=(a385+a473);
  a385=(a012*a385);
  a460=(a460+a385);
  a460=(a460-a047);
  a460=(a460+a489);
  a489=(a460/a491);
  a460=(a495*a460);
  a490=(a490-a460);
  a490=(a490/a493);
  a460=(a495*a490);
  a489=(a489-a460);
  a460=(2.*a489);
  a385=(a460*a020);
  a154=(a154-a385);
  a154=(a012*a154);
  a002=(a002+a154);
  a463=(a463*a002);
  a477=(a477*a013);
  a463=(a463+a477);
  a488=(a020*a488);
  a461=(a461*a014);
  a488=(a488-a461);
  a477=(a466*a008);
  a002=(a082+a385);
  a483=(a483*a471);
  a154=(a490*a020);
  a483=(a483-a154);
  a154=(a014*a472);
  a483=(a483-a154);
  a002=(a002+a483);
  a477=(a477*a002);
  a488=(a488-a477);
  a464=(a020*a464);
  a488=(a488-a464);
  a002=(a008*a485);
  a490=(a490*a014);
  a472=(a020*a472);
  a490=(a490-a472);
  a472=(a460*a014);
  a490=(a490-a472);
  a154=(a020*a471);
  a154=(a154*a471);
  a490=(a490+a154);
  a154=(a490+a475);
  a002=(a002*a154);
  a488=(a488+a002);
  a488=(a012*a488);
  a463=(a463+a488);
  a462=(a008*a462);
  a460=(a460*a011);
  a488=(a049*a489);
  a488=(a488-a472);
  a488=(a488+a475);
  a488=(a012*a488);
  a460=(a460+a488);
  a460=(a462*a460);
  a463=(a463+a460);
  a460=(a463/a491);
  a488=(a489*a008);
  a468=(a468+a487);
  a488=(a488*a468);
  a461=(a461+a464);
  a488=(a488+a461);
  a488=(a012*a488);
  a463=(a495*a463);
  a488=(a488-a463);
  a488=(a488/a493);
  a463=(a495*a488);
  a460=(a460-a463);
  a463=(a405*a500);
  a464=(a407*a152);
  a463=(a463+a464);
  a464=(a408*a193);
  a463=(a463+a464);
  a464=(a409*a010);
  a463=(a463+a464);
  a464=(a410*a080);
  a463=(a463+a464);
  a464=(a411*a235);
  a463=(a463+a464);
  a464=(a412*a279);
  a463=(a463+a464);
  a464=(a413*a324);
  a463=(a463+a464);
  a463=(a027+a463);
  a464=(a460*a463);
  a385=(a385+a483);
  a385=(a465*a385);
  a477=(a477+a385);
  a477=(a477-a002);
  a490=(a467*a490);
  a477=(a477+a490);
  a477=(a477+a461);
  a477=(a012*a477);
  a490=(a477/a491);
  a002=(a489*a020);
  a082=(a082-a002);
  a465=(a465*a082);
  a466=(a489*a466);
  a466=(a466*a020);
  a466=(a466*a008);
  a465=(a465-a466);
  a489=(a489*a014);
  a466=(a489*a008);
  a466=(a466*a485);
  a465=(a465-a466);
  a489=(a489+a475);
  a467=(a467*a489);
  a465=(a465+a467);
  a465=(a465-a461);
  a465=(a012*a465);
  a477=(a495*a477);
  a465=(a465-a477);
  a465=(a465/a493);
  a477=(a495*a465);
  a490=(a490-a477);
  a477=(a405*a061);
  a461=(a407*a185);
  a477=(a477+a461);
  a461=(a408*a225);
  a477=(a477+a461);
  a461=(a409*a268);
  a477=(a477+a461);
  a461=(a410*a312);
  a477=(a477+a461);
  a461=(a411*a357);
  a477=(a477+a461);
  a461=(a412*a403);
  a477=(a477+a461);
  a461=(a413*a450);
  a477=(a477+a461);
  a477=(a034+a477);
  a461=(a490*a477);
  a464=(a464+a461);
  a462=(a462*a013);
  a462=(a470*a462);
  a480=(2.*a480);
  a476=(a476*a008);
  a476=(a470*a476);
  a480=(a480-a476);
  a484=(2.*a484);
  a480=(a480-a484);
  a484=(2.*a471);
  a484=(a484-a470);
  a470=(a469*a484);
  a480=(a480+a470);
  a484=(a486*a484);
  a480=(a480+a484);
  a480=(a012*a480);
  a462=(a462+a480);
  a480=(a462/a491);
  a484=(a042*a406);
  a484=(a484*a012);
  a479=(a479-a494);
  a484=(a484*a479);
  a462=(a495*a462);
  a484=(a484-a462);
  a484=(a484/a493);
  a462=(a495*a484);
  a480=(a480-a462);
  a462=(a480*a370);
  a406=(a406-a471);
  a406=(a048*a406);
  a469=(a469+a486);
  a469=(a469+a479);
  a406=(a406*a469);
  a491=(a406/a491);
  a406=(a495*a406);
  a406=(a406/a493);
  a495=(a495*a406);
  a491=(a491+a495);
  a495=(a405*a113);
  a493=(a407*a153);
  a495=(a495+a493);
  a493=(a408*a194);
  a495=(a495+a493);
  a493=(a409*a236);
  a495=(a495+a493);
  a493=(a410*a280);
  a495=(a495+a493);
  a493=(a411*a325);
  a495=(a495+a493);
  a493=(a412*a371);
  a495=(a495+a493);
  a418=(a443*a418);
  a432=(a420*a432);
  a418=(a418+a432);
  a432=(a439*a324);
  a493=(a360*a450);
  a432=(a432-a493);
  a418=(a418+a432);
  a432=(a413*a418);
  a495=(a495+a432);
  a495=(a061+a495);
  a432=(a491*a495);
  a462=(a462+a432);
  a464=(a464+a462);
  a462=(a459*a464);
  a417=(a417+a462);
  a417=(a500+a417);
  a462=(a451*a417);
  a474=(a474+a462);
  a474=(a027+a474);
  if (res[0]!=0) res[0][4]=a474;
  a474=(a001*a061);
  a462=(a005*a268);
  a474=(a474+a462);
  a462=(a226*a312);
  a474=(a474+a462);
  a462=(a269*a357);
  a474=(a474+a462);
  a462=(a313*a403);
  a474=(a474+a462);
  a462=(a358*a450);
  a474=(a474+a462);
  a462=(a404*a495);
  a474=(a474+a462);
  a462=(a452*a113);
  a153=(a454*a153);
  a462=(a462+a153);
  a194=(a182*a194);
  a462=(a462+a194);
  a194=(a222*a236);
  a462=(a462+a194);
  a194=(a455*a280);
  a462=(a462+a194);
  a194=(a456*a325);
  a462=(a462+a194);
  a194=(a457*a371);
  a462=(a462+a194);
  a194=(a458*a418);
  a462=(a462+a194);
  a463=(a488*a463);
  a477=(a465*a477);
  a463=(a463+a477);
  a477=(a484*a370);
  a194=(a406*a495);
  a477=(a477-a194);
  a463=(a463+a477);
  a477=(a459*a463);
  a462=(a462+a477);
  a462=(a061+a462);
  a477=(a451*a462);
  a474=(a474+a477);
  a474=(a034+a474);
  if (res[0]!=0) res[0][5]=a474;
  a015=(a001*a015);
  a237=(a005*a237);
  a015=(a015+a237);
  a281=(a226*a281);
  a015=(a015+a281);
  a326=(a269*a326);
  a015=(a015+a326);
  a372=(a313*a372);
  a015=(a015+a372);
  a419=(a358*a419);
  a015=(a015+a419);
  a464=(a404*a464);
  a015=(a015+a464);
  a354=(a354*a008);
  a492=(a492*a011);
  a464=(a497*a453);
  a419=(a014*a453);
  a419=(a419*a453);
  a464=(a464-a419);
  a499=(a008*a499);
  a372=(a204*a499);
  a372=(a372-a000);
  a000=(a020*a453);
  a000=(a000*a453);
  a326=(a354*a000);
  a372=(a372-a326);
  a372=(a372-a503);
  a372=(a372+a507);
  a372=(a372-a506);
  a372=(a372+a511);
  a511=(a014*a510);
  a499=(a511*a499);
  a372=(a372+a499);
  a372=(a012*a372);
  a447=(a447+a372);
  a447=(a447-a047);
  a447=(a447+a035);
  a035=(a447/a051);
  a447=(a054*a447);
  a512=(a512-a447);
  a512=(a512/a066);
  a447=(a054*a512);
  a035=(a035-a447);
  a447=(2.*a035);
  a047=(a447*a020);
  a464=(a464-a047);
  a464=(a012*a464);
  a492=(a492+a464);
  a354=(a354*a492);
  a502=(a502*a013);
  a354=(a354+a502);
  a033=(a020*a033);
  a029=(a029*a014);
  a033=(a033-a029);
  a502=(a265*a008);
  a492=(a419+a047);
  a508=(a508*a496);
  a464=(a512*a020);
  a508=(a508-a464);
  a464=(a014*a498);
  a508=(a508-a464);
  a492=(a492+a508);
  a502=(a502*a492);
  a033=(a033-a502);
  a016=(a020*a016);
  a033=(a033-a016);
  a492=(a008*a510);
  a512=(a512*a014);
  a498=(a020*a498);
  a512=(a512-a498);
  a498=(a447*a014);
  a512=(a512-a498);
  a464=(a020*a496);
  a464=(a464*a496);
  a512=(a512+a464);
  a464=(a512+a000);
  a492=(a492*a464);
  a033=(a033+a492);
  a033=(a012*a033);
  a354=(a354+a033);
  a400=(a008*a400);
  a447=(a447*a011);
  a049=(a049*a035);
  a049=(a049-a498);
  a049=(a049+a000);
  a049=(a012*a049);
  a447=(a447+a049);
  a447=(a400*a447);
  a354=(a354+a447);
  a447=(a354/a051);
  a049=(a035*a008);
  a204=(a204+a511);
  a049=(a049*a204);
  a029=(a029+a016);
  a049=(a049+a029);
  a049=(a012*a049);
  a354=(a054*a354);
  a049=(a049-a354);
  a049=(a049/a066);
  a354=(a054*a049);
  a447=(a447-a354);
  a354=(a452*a500);
  a152=(a454*a152);
  a354=(a354+a152);
  a193=(a182*a193);
  a354=(a354+a193);
  a010=(a222*a010);
  a354=(a354+a010);
  a080=(a455*a080);
  a354=(a354+a080);
  a235=(a456*a235);
  a354=(a354+a235);
  a279=(a457*a279);
  a354=(a354+a279);
  a324=(a458*a324);
  a354=(a354+a324);
  a370=(a459*a370);
  a354=(a354+a370);
  a027=(a027+a354);
  a354=(a447*a027);
  a047=(a047+a508);
  a047=(a309*a047);
  a502=(a502+a047);
  a502=(a502-a492);
  a512=(a004*a512);
  a502=(a502+a512);
  a502=(a502+a029);
  a502=(a012*a502);
  a512=(a502/a051);
  a492=(a035*a020);
  a419=(a419-a492);
  a309=(a309*a419);
  a265=(a035*a265);
  a265=(a265*a020);
  a265=(a265*a008);
  a309=(a309-a265);
  a035=(a035*a014);
  a014=(a035*a008);
  a014=(a014*a510);
  a309=(a309-a014);
  a035=(a035+a000);
  a004=(a004*a035);
  a309=(a309+a004);
  a309=(a309-a029);
  a309=(a012*a309);
  a502=(a054*a502);
  a309=(a309-a502);
  a309=(a309/a066);
  a502=(a054*a309);
  a512=(a512-a502);
  a502=(a452*a061);
  a185=(a454*a185);
  a502=(a502+a185);
  a225=(a182*a225);
  a502=(a502+a225);
  a268=(a222*a268);
  a502=(a502+a268);
  a312=(a455*a312);
  a502=(a502+a312);
  a357=(a456*a357);
  a502=(a502+a357);
  a403=(a457*a403);
  a502=(a502+a403);
  a450=(a458*a450);
  a502=(a502+a450);
  a495=(a459*a495);
  a502=(a502+a495);
  a034=(a034+a502);
  a502=(a512*a034);
  a354=(a354+a502);
  a400=(a400*a013);
  a400=(a497*a400);
  a505=(2.*a505);
  a501=(a501*a008);
  a501=(a497*a501);
  a505=(a505-a501);
  a509=(2.*a509);
  a505=(a505-a509);
  a509=(2.*a496);
  a509=(a509-a497);
  a497=(a164*a509);
  a505=(a505+a497);
  a509=(a043*a509);
  a505=(a505+a509);
  a505=(a012*a505);
  a400=(a400+a505);
  a505=(a400/a051);
  a042=(a042*a453);
  a042=(a042*a012);
  a504=(a504-a056);
  a042=(a042*a504);
  a400=(a054*a400);
  a042=(a042-a400);
  a042=(a042/a066);
  a400=(a054*a042);
  a505=(a505-a400);
  a400=(a505*a417);
  a453=(a453-a496);
  a048=(a048*a453);
  a164=(a164+a043);
  a164=(a164+a504);
  a048=(a048*a164);
  a051=(a048/a051);
  a048=(a054*a048);
  a048=(a048/a066);
  a054=(a054*a048);
  a051=(a051+a054);
  a054=(a051*a462);
  a400=(a400+a054);
  a354=(a354+a400);
  a354=(a451*a354);
  a015=(a015+a354);
  a500=(a500+a015);
  if (res[0]!=0) res[0][6]=a500;
  a113=(a001*a113);
  a236=(a005*a236);
  a113=(a113+a236);
  a280=(a226*a280);
  a113=(a113+a280);
  a325=(a269*a325);
  a113=(a113+a325);
  a371=(a313*a371);
  a113=(a113+a371);
  a418=(a358*a418);
  a113=(a113+a418);
  a463=(a404*a463);
  a113=(a113+a463);
  a027=(a049*a027);
  a034=(a309*a034);
  a027=(a027+a034);
  a417=(a042*a417);
  a462=(a048*a462);
  a417=(a417-a462);
  a027=(a027+a417);
  a027=(a451*a027);
  a113=(a113+a027);
  a061=(a061+a113);
  if (res[0]!=0) res[0][7]=a061;
  a061=arg[0]? arg[0][8] : 0;
  a113=arg[0]? arg[0][10] : 0;
  a027=(a001*a113);
  a417=(a009*a061);
  a462=arg[0]? arg[0][9] : 0;
  a034=(a052*a462);
  a417=(a417+a034);
  a034=(a038*a113);
  a463=arg[0]? arg[0][11] : 0;
  a418=(a053*a463);
  a034=(a034+a418);
  a417=(a417+a034);
  a034=(a006*a417);
  a418=(a069*a113);
  a371=(a072*a417);
  a325=(a075*a113);
  a325=(a061+a325);
  a280=(a078*a325);
  a236=(a075*a463);
  a236=(a462+a236);
  a500=(a108*a236);
  a280=(a280+a500);
  a500=(a075*a417);
  a500=(a113+a500);
  a015=(a098*a500);
  a354=(a429*a061);
  a400=(a017*a462);
  a354=(a354+a400);
  a400=(a023*a113);
  a054=(a003*a463);
  a400=(a400-a054);
  a354=(a354+a400);
  a400=(a075*a354);
  a400=(a463+a400);
  a054=(a109*a400);
  a015=(a015+a054);
  a280=(a280+a015);
  a280=(a074*a280);
  a371=(a371+a280);
  a371=(a113+a371);
  a280=(a071*a371);
  a418=(a418+a280);
  a418=(a061+a418);
  a280=(a150*a418);
  a015=(a069*a463);
  a054=(a072*a354);
  a325=(a106*a325);
  a236=(a083*a236);
  a325=(a325+a236);
  a236=(a102*a500);
  a066=(a076*a400);
  a236=(a236-a066);
  a325=(a325+a236);
  a325=(a074*a325);
  a054=(a054+a325);
  a054=(a463+a054);
  a325=(a071*a054);
  a015=(a015+a325);
  a015=(a462+a015);
  a325=(a180*a015);
  a280=(a280+a325);
  a325=(a069*a417);
  a236=(a072*a113);
  a500=(a074*a500);
  a236=(a236+a500);
  a236=(a061+a236);
  a500=(a114*a236);
  a066=(a072*a463);
  a400=(a074*a400);
  a066=(a066+a400);
  a066=(a462+a066);
  a400=(a143*a066);
  a500=(a500+a400);
  a400=(a133*a371);
  a164=(a144*a054);
  a400=(a400+a164);
  a500=(a500+a400);
  a400=(a071*a500);
  a325=(a325+a400);
  a325=(a113+a325);
  a400=(a170*a325);
  a164=(a069*a354);
  a236=(a141*a236);
  a066=(a119*a066);
  a236=(a236+a066);
  a066=(a137*a371);
  a504=(a073*a054);
  a066=(a066-a504);
  a236=(a236+a066);
  a066=(a071*a236);
  a164=(a164+a066);
  a164=(a463+a164);
  a066=(a181*a164);
  a400=(a400+a066);
  a280=(a280+a400);
  a400=(a068*a280);
  a034=(a034+a400);
  a400=(a187*a113);
  a371=(a189*a371);
  a400=(a400+a371);
  a371=(a145*a325);
  a400=(a400+a371);
  a400=(a061+a400);
  a371=(a191*a400);
  a066=(a187*a463);
  a054=(a189*a054);
  a066=(a066+a054);
  a054=(a145*a164);
  a066=(a066+a054);
  a066=(a462+a066);
  a054=(a220*a066);
  a371=(a371+a054);
  a054=(a187*a417);
  a500=(a189*a500);
  a054=(a054+a500);
  a500=(a145*a280);
  a054=(a054+a500);
  a054=(a113+a054);
  a500=(a210*a054);
  a504=(a187*a354);
  a236=(a189*a236);
  a504=(a504+a236);
  a418=(a178*a418);
  a015=(a155*a015);
  a418=(a418+a015);
  a015=(a174*a325);
  a236=(a070*a164);
  a015=(a015-a236);
  a418=(a418+a015);
  a015=(a145*a418);
  a504=(a504+a015);
  a504=(a463+a504);
  a015=(a221*a504);
  a500=(a500+a015);
  a371=(a371+a500);
  a500=(a186*a371);
  a034=(a034+a500);
  a034=(a113+a034);
  a500=(a005*a034);
  a027=(a027+a500);
  a500=(a227*a417);
  a015=(a229*a280);
  a500=(a500+a015);
  a015=(a230*a371);
  a500=(a500+a015);
  a015=(a006*a113);
  a236=(a068*a325);
  a015=(a015+a236);
  a236=(a186*a054);
  a015=(a015+a236);
  a015=(a061+a015);
  a236=(a233*a015);
  a043=(a006*a463);
  a453=(a068*a164);
  a043=(a043+a453);
  a453=(a186*a504);
  a043=(a043+a453);
  a043=(a462+a043);
  a453=(a263*a043);
  a236=(a236+a453);
  a453=(a253*a034);
  a496=(a006*a354);
  a056=(a068*a418);
  a496=(a496+a056);
  a400=(a218*a400);
  a066=(a196*a066);
  a400=(a400+a066);
  a066=(a214*a054);
  a056=(a188*a504);
  a066=(a066-a056);
  a400=(a400+a066);
  a066=(a186*a400);
  a496=(a496+a066);
  a496=(a463+a496);
  a066=(a264*a496);
  a453=(a453+a066);
  a236=(a236+a453);
  a453=(a231*a236);
  a500=(a500+a453);
  a500=(a113+a500);
  a453=(a226*a500);
  a027=(a027+a453);
  a453=(a270*a417);
  a066=(a272*a280);
  a453=(a453+a066);
  a066=(a273*a371);
  a453=(a453+a066);
  a066=(a274*a236);
  a453=(a453+a066);
  a066=(a227*a113);
  a056=(a229*a325);
  a066=(a066+a056);
  a056=(a230*a054);
  a066=(a066+a056);
  a056=(a231*a034);
  a066=(a066+a056);
  a066=(a061+a066);
  a056=(a277*a066);
  a012=(a227*a463);
  a509=(a229*a164);
  a012=(a012+a509);
  a509=(a230*a504);
  a012=(a012+a509);
  a509=(a231*a496);
  a012=(a012+a509);
  a012=(a462+a012);
  a509=(a307*a012);
  a056=(a056+a509);
  a509=(a297*a500);
  a497=(a227*a354);
  a501=(a229*a418);
  a497=(a497+a501);
  a501=(a230*a400);
  a497=(a497+a501);
  a015=(a261*a015);
  a043=(a238*a043);
  a015=(a015+a043);
  a043=(a257*a034);
  a501=(a067*a496);
  a043=(a043-a501);
  a015=(a015+a043);
  a043=(a231*a015);
  a497=(a497+a043);
  a497=(a463+a497);
  a043=(a308*a497);
  a509=(a509+a043);
  a056=(a056+a509);
  a509=(a275*a056);
  a453=(a453+a509);
  a453=(a113+a453);
  a509=(a269*a453);
  a027=(a027+a509);
  a509=(a314*a417);
  a043=(a316*a280);
  a509=(a509+a043);
  a043=(a317*a371);
  a509=(a509+a043);
  a043=(a318*a236);
  a509=(a509+a043);
  a043=(a319*a056);
  a509=(a509+a043);
  a043=(a270*a113);
  a501=(a272*a325);
  a043=(a043+a501);
  a501=(a273*a054);
  a043=(a043+a501);
  a501=(a274*a034);
  a043=(a043+a501);
  a501=(a275*a500);
  a043=(a043+a501);
  a043=(a061+a043);
  a501=(a322*a043);
  a008=(a270*a463);
  a013=(a272*a164);
  a008=(a008+a013);
  a013=(a273*a504);
  a008=(a008+a013);
  a013=(a274*a496);
  a008=(a008+a013);
  a013=(a275*a497);
  a008=(a008+a013);
  a008=(a462+a008);
  a013=(a352*a008);
  a501=(a501+a013);
  a013=(a342*a453);
  a502=(a270*a354);
  a495=(a272*a418);
  a502=(a502+a495);
  a495=(a273*a400);
  a502=(a502+a495);
  a495=(a274*a015);
  a502=(a502+a495);
  a066=(a305*a066);
  a012=(a282*a012);
  a066=(a066+a012);
  a012=(a301*a500);
  a495=(a228*a497);
  a012=(a012-a495);
  a066=(a066+a012);
  a012=(a275*a066);
  a502=(a502+a012);
  a502=(a463+a502);
  a012=(a353*a502);
  a013=(a013+a012);
  a501=(a501+a013);
  a013=(a320*a501);
  a509=(a509+a013);
  a509=(a113+a509);
  a013=(a313*a509);
  a027=(a027+a013);
  a013=(a359*a417);
  a012=(a361*a280);
  a013=(a013+a012);
  a012=(a362*a371);
  a013=(a013+a012);
  a012=(a363*a236);
  a013=(a013+a012);
  a012=(a364*a056);
  a013=(a013+a012);
  a012=(a365*a501);
  a013=(a013+a012);
  a012=(a314*a113);
  a495=(a316*a325);
  a012=(a012+a495);
  a495=(a317*a054);
  a012=(a012+a495);
  a495=(a318*a034);
  a012=(a012+a495);
  a495=(a319*a500);
  a012=(a012+a495);
  a495=(a320*a453);
  a012=(a012+a495);
  a012=(a061+a012);
  a495=(a368*a012);
  a450=(a314*a463);
  a403=(a316*a164);
  a450=(a450+a403);
  a403=(a317*a504);
  a450=(a450+a403);
  a403=(a318*a496);
  a450=(a450+a403);
  a403=(a319*a497);
  a450=(a450+a403);
  a403=(a320*a502);
  a450=(a450+a403);
  a450=(a462+a450);
  a403=(a398*a450);
  a495=(a495+a403);
  a403=(a388*a509);
  a357=(a314*a354);
  a312=(a316*a418);
  a357=(a357+a312);
  a312=(a317*a400);
  a357=(a357+a312);
  a312=(a318*a015);
  a357=(a357+a312);
  a312=(a319*a066);
  a357=(a357+a312);
  a043=(a350*a043);
  a008=(a327*a008);
  a043=(a043+a008);
  a008=(a346*a453);
  a312=(a271*a502);
  a008=(a008-a312);
  a043=(a043+a008);
  a008=(a320*a043);
  a357=(a357+a008);
  a357=(a463+a357);
  a008=(a399*a357);
  a403=(a403+a008);
  a495=(a495+a403);
  a403=(a366*a495);
  a013=(a013+a403);
  a013=(a113+a013);
  a403=(a358*a013);
  a027=(a027+a403);
  a403=(a405*a417);
  a008=(a407*a280);
  a403=(a403+a008);
  a008=(a408*a371);
  a403=(a403+a008);
  a008=(a409*a236);
  a403=(a403+a008);
  a008=(a410*a056);
  a403=(a403+a008);
  a008=(a411*a501);
  a403=(a403+a008);
  a008=(a412*a495);
  a403=(a403+a008);
  a008=(a359*a113);
  a312=(a361*a325);
  a008=(a008+a312);
  a312=(a362*a054);
  a008=(a008+a312);
  a312=(a363*a034);
  a008=(a008+a312);
  a312=(a364*a500);
  a008=(a008+a312);
  a312=(a365*a453);
  a008=(a008+a312);
  a312=(a366*a509);
  a008=(a008+a312);
  a008=(a061+a008);
  a312=(a415*a008);
  a268=(a359*a463);
  a225=(a361*a164);
  a268=(a268+a225);
  a225=(a362*a504);
  a268=(a268+a225);
  a225=(a363*a496);
  a268=(a268+a225);
  a225=(a364*a497);
  a268=(a268+a225);
  a225=(a365*a502);
  a268=(a268+a225);
  a225=(a366*a357);
  a268=(a268+a225);
  a268=(a462+a268);
  a225=(a445*a268);
  a312=(a312+a225);
  a225=(a435*a013);
  a185=(a359*a354);
  a029=(a361*a418);
  a185=(a185+a029);
  a029=(a362*a400);
  a185=(a185+a029);
  a029=(a363*a015);
  a185=(a185+a029);
  a029=(a364*a066);
  a185=(a185+a029);
  a029=(a365*a043);
  a185=(a185+a029);
  a012=(a396*a012);
  a450=(a373*a450);
  a012=(a012+a450);
  a450=(a392*a509);
  a029=(a315*a357);
  a450=(a450-a029);
  a012=(a012+a450);
  a450=(a366*a012);
  a185=(a185+a450);
  a185=(a463+a185);
  a450=(a446*a185);
  a225=(a225+a450);
  a312=(a312+a225);
  a225=(a413*a312);
  a403=(a403+a225);
  a403=(a113+a403);
  a225=(a404*a403);
  a027=(a027+a225);
  a225=(a452*a417);
  a280=(a454*a280);
  a225=(a225+a280);
  a371=(a182*a371);
  a225=(a225+a371);
  a371=(a222*a236);
  a225=(a225+a371);
  a371=(a455*a056);
  a225=(a225+a371);
  a371=(a456*a501);
  a225=(a225+a371);
  a371=(a457*a495);
  a225=(a225+a371);
  a371=(a458*a312);
  a225=(a225+a371);
  a371=(a405*a113);
  a280=(a407*a325);
  a371=(a371+a280);
  a280=(a408*a054);
  a371=(a371+a280);
  a280=(a409*a034);
  a371=(a371+a280);
  a280=(a410*a500);
  a371=(a371+a280);
  a280=(a411*a453);
  a371=(a371+a280);
  a280=(a412*a509);
  a371=(a371+a280);
  a280=(a413*a013);
  a371=(a371+a280);
  a371=(a061+a371);
  a280=(a460*a371);
  a450=(a405*a463);
  a029=(a407*a164);
  a450=(a450+a029);
  a029=(a408*a504);
  a450=(a450+a029);
  a029=(a409*a496);
  a450=(a450+a029);
  a029=(a410*a497);
  a450=(a450+a029);
  a029=(a411*a502);
  a450=(a450+a029);
  a029=(a412*a357);
  a450=(a450+a029);
  a029=(a413*a185);
  a450=(a450+a029);
  a450=(a462+a450);
  a029=(a490*a450);
  a280=(a280+a029);
  a029=(a480*a403);
  a004=(a405*a354);
  a035=(a407*a418);
  a004=(a004+a035);
  a035=(a408*a400);
  a004=(a004+a035);
  a035=(a409*a015);
  a004=(a004+a035);
  a035=(a410*a066);
  a004=(a004+a035);
  a035=(a411*a043);
  a004=(a004+a035);
  a035=(a412*a012);
  a004=(a004+a035);
  a008=(a443*a008);
  a268=(a420*a268);
  a008=(a008+a268);
  a268=(a439*a013);
  a035=(a360*a185);
  a268=(a268-a035);
  a008=(a008+a268);
  a268=(a413*a008);
  a004=(a004+a268);
  a004=(a463+a004);
  a268=(a491*a004);
  a029=(a029+a268);
  a280=(a280+a029);
  a029=(a459*a280);
  a225=(a225+a029);
  a225=(a113+a225);
  a029=(a451*a225);
  a027=(a027+a029);
  a027=(a061+a027);
  if (res[0]!=0) res[0][8]=a027;
  a027=(a001*a463);
  a029=(a005*a496);
  a027=(a027+a029);
  a029=(a226*a497);
  a027=(a027+a029);
  a029=(a269*a502);
  a027=(a027+a029);
  a029=(a313*a357);
  a027=(a027+a029);
  a029=(a358*a185);
  a027=(a027+a029);
  a029=(a404*a004);
  a027=(a027+a029);
  a029=(a452*a354);
  a418=(a454*a418);
  a029=(a029+a418);
  a400=(a182*a400);
  a029=(a029+a400);
  a400=(a222*a015);
  a029=(a029+a400);
  a400=(a455*a066);
  a029=(a029+a400);
  a400=(a456*a043);
  a029=(a029+a400);
  a400=(a457*a012);
  a029=(a029+a400);
  a400=(a458*a008);
  a029=(a029+a400);
  a371=(a488*a371);
  a450=(a465*a450);
  a371=(a371+a450);
  a450=(a484*a403);
  a400=(a406*a004);
  a450=(a450-a400);
  a371=(a371+a450);
  a450=(a459*a371);
  a029=(a029+a450);
  a029=(a463+a029);
  a450=(a451*a029);
  a027=(a027+a450);
  a027=(a462+a027);
  if (res[0]!=0) res[0][9]=a027;
  a417=(a001*a417);
  a236=(a005*a236);
  a417=(a417+a236);
  a056=(a226*a056);
  a417=(a417+a056);
  a501=(a269*a501);
  a417=(a417+a501);
  a495=(a313*a495);
  a417=(a417+a495);
  a312=(a358*a312);
  a417=(a417+a312);
  a280=(a404*a280);
  a417=(a417+a280);
  a280=(a452*a113);
  a325=(a454*a325);
  a280=(a280+a325);
  a054=(a182*a054);
  a280=(a280+a054);
  a034=(a222*a034);
  a280=(a280+a034);
  a500=(a455*a500);
  a280=(a280+a500);
  a453=(a456*a453);
  a280=(a280+a453);
  a509=(a457*a509);
  a280=(a280+a509);
  a013=(a458*a013);
  a280=(a280+a013);
  a403=(a459*a403);
  a280=(a280+a403);
  a061=(a061+a280);
  a280=(a447*a061);
  a403=(a452*a463);
  a164=(a454*a164);
  a403=(a403+a164);
  a504=(a182*a504);
  a403=(a403+a504);
  a496=(a222*a496);
  a403=(a403+a496);
  a497=(a455*a497);
  a403=(a403+a497);
  a502=(a456*a502);
  a403=(a403+a502);
  a357=(a457*a357);
  a403=(a403+a357);
  a185=(a458*a185);
  a403=(a403+a185);
  a004=(a459*a004);
  a403=(a403+a004);
  a462=(a462+a403);
  a403=(a512*a462);
  a280=(a280+a403);
  a403=(a505*a225);
  a004=(a051*a029);
  a403=(a403+a004);
  a280=(a280+a403);
  a280=(a451*a280);
  a417=(a417+a280);
  a113=(a113+a417);
  if (res[0]!=0) res[0][10]=a113;
  a354=(a001*a354);
  a015=(a005*a015);
  a354=(a354+a015);
  a066=(a226*a066);
  a354=(a354+a066);
  a043=(a269*a043);
  a354=(a354+a043);
  a012=(a313*a012);
  a354=(a354+a012);
  a008=(a358*a008);
  a354=(a354+a008);
  a371=(a404*a371);
  a354=(a354+a371);
  a061=(a049*a061);
  a462=(a309*a462);
  a061=(a061+a462);
  a225=(a042*a225);
  a029=(a048*a029);
  a225=(a225-a029);
  a061=(a061+a225);
  a061=(a451*a061);
  a354=(a354+a061);
  a463=(a463+a354);
  if (res[0]!=0) res[0][11]=a463;
  a463=arg[0]? arg[0][12] : 0;
  a354=arg[0]? arg[0][14] : 0;
  a061=(a001*a354);
  a009=(a009*a463);
  a225=arg[0]? arg[0][13] : 0;
  a052=(a052*a225);
  a009=(a009+a052);
  a038=(a038*a354);
  a052=arg[0]? arg[0][15] : 0;
  a053=(a053*a052);
  a038=(a038+a053);
  a009=(a009+a038);
  a038=(a006*a009);
  a053=(a069*a354);
  a029=(a072*a009);
  a462=(a075*a354);
  a462=(a463+a462);
  a078=(a078*a462);
  a371=(a075*a052);
  a371=(a225+a371);
  a108=(a108*a371);
  a078=(a078+a108);
  a108=(a075*a009);
  a108=(a354+a108);
  a098=(a098*a108);
  a429=(a429*a463);
  a017=(a017*a225);
  a429=(a429+a017);
  a023=(a023*a354);
  a003=(a003*a052);
  a023=(a023-a003);
  a429=(a429+a023);
  a075=(a075*a429);
  a075=(a052+a075);
  a109=(a109*a075);
  a098=(a098+a109);
  a078=(a078+a098);
  a078=(a074*a078);
  a029=(a029+a078);
  a029=(a354+a029);
  a078=(a071*a029);
  a053=(a053+a078);
  a053=(a463+a053);
  a150=(a150*a053);
  a078=(a069*a052);
  a098=(a072*a429);
  a106=(a106*a462);
  a083=(a083*a371);
  a106=(a106+a083);
  a102=(a102*a108);
  a076=(a076*a075);
  a102=(a102-a076);
  a106=(a106+a102);
  a106=(a074*a106);
  a098=(a098+a106);
  a098=(a052+a098);
  a106=(a071*a098);
  a078=(a078+a106);
  a078=(a225+a078);
  a180=(a180*a078);
  a150=(a150+a180);
  a180=(a069*a009);
  a106=(a072*a354);
  a108=(a074*a108);
  a106=(a106+a108);
  a106=(a463+a106);
  a114=(a114*a106);
  a072=(a072*a052);
  a074=(a074*a075);
  a072=(a072+a074);
  a072=(a225+a072);
  a143=(a143*a072);
  a114=(a114+a143);
  a133=(a133*a029);
  a144=(a144*a098);
  a133=(a133+a144);
  a114=(a114+a133);
  a133=(a071*a114);
  a180=(a180+a133);
  a180=(a354+a180);
  a170=(a170*a180);
  a069=(a069*a429);
  a141=(a141*a106);
  a119=(a119*a072);
  a141=(a141+a119);
  a137=(a137*a029);
  a073=(a073*a098);
  a137=(a137-a073);
  a141=(a141+a137);
  a071=(a071*a141);
  a069=(a069+a071);
  a069=(a052+a069);
  a181=(a181*a069);
  a170=(a170+a181);
  a150=(a150+a170);
  a170=(a068*a150);
  a038=(a038+a170);
  a170=(a187*a354);
  a029=(a189*a029);
  a170=(a170+a029);
  a029=(a145*a180);
  a170=(a170+a029);
  a170=(a463+a170);
  a191=(a191*a170);
  a029=(a187*a052);
  a098=(a189*a098);
  a029=(a029+a098);
  a098=(a145*a069);
  a029=(a029+a098);
  a029=(a225+a029);
  a220=(a220*a029);
  a191=(a191+a220);
  a220=(a187*a009);
  a114=(a189*a114);
  a220=(a220+a114);
  a114=(a145*a150);
  a220=(a220+a114);
  a220=(a354+a220);
  a210=(a210*a220);
  a187=(a187*a429);
  a189=(a189*a141);
  a187=(a187+a189);
  a178=(a178*a053);
  a155=(a155*a078);
  a178=(a178+a155);
  a174=(a174*a180);
  a070=(a070*a069);
  a174=(a174-a070);
  a178=(a178+a174);
  a145=(a145*a178);
  a187=(a187+a145);
  a187=(a052+a187);
  a221=(a221*a187);
  a210=(a210+a221);
  a191=(a191+a210);
  a210=(a186*a191);
  a038=(a038+a210);
  a038=(a354+a038);
  a210=(a005*a038);
  a061=(a061+a210);
  a210=(a227*a009);
  a221=(a229*a150);
  a210=(a210+a221);
  a221=(a230*a191);
  a210=(a210+a221);
  a221=(a006*a354);
  a145=(a068*a180);
  a221=(a221+a145);
  a145=(a186*a220);
  a221=(a221+a145);
  a221=(a463+a221);
  a233=(a233*a221);
  a145=(a006*a052);
  a174=(a068*a069);
  a145=(a145+a174);
  a174=(a186*a187);
  a145=(a145+a174);
  a145=(a225+a145);
  a263=(a263*a145);
  a233=(a233+a263);
  a253=(a253*a038);
  a006=(a006*a429);
  a068=(a068*a178);
  a006=(a006+a068);
  a218=(a218*a170);
  a196=(a196*a029);
  a218=(a218+a196);
  a214=(a214*a220);
  a188=(a188*a187);
  a214=(a214-a188);
  a218=(a218+a214);
  a186=(a186*a218);
  a006=(a006+a186);
  a006=(a052+a006);
  a264=(a264*a006);
  a253=(a253+a264);
  a233=(a233+a253);
  a253=(a231*a233);
  a210=(a210+a253);
  a210=(a354+a210);
  a253=(a226*a210);
  a061=(a061+a253);
  a253=(a270*a009);
  a264=(a272*a150);
  a253=(a253+a264);
  a264=(a273*a191);
  a253=(a253+a264);
  a264=(a274*a233);
  a253=(a253+a264);
  a264=(a227*a354);
  a186=(a229*a180);
  a264=(a264+a186);
  a186=(a230*a220);
  a264=(a264+a186);
  a186=(a231*a038);
  a264=(a264+a186);
  a264=(a463+a264);
  a277=(a277*a264);
  a186=(a227*a052);
  a214=(a229*a069);
  a186=(a186+a214);
  a214=(a230*a187);
  a186=(a186+a214);
  a214=(a231*a006);
  a186=(a186+a214);
  a186=(a225+a186);
  a307=(a307*a186);
  a277=(a277+a307);
  a297=(a297*a210);
  a227=(a227*a429);
  a229=(a229*a178);
  a227=(a227+a229);
  a230=(a230*a218);
  a227=(a227+a230);
  a261=(a261*a221);
  a238=(a238*a145);
  a261=(a261+a238);
  a257=(a257*a038);
  a067=(a067*a006);
  a257=(a257-a067);
  a261=(a261+a257);
  a231=(a231*a261);
  a227=(a227+a231);
  a227=(a052+a227);
  a308=(a308*a227);
  a297=(a297+a308);
  a277=(a277+a297);
  a297=(a275*a277);
  a253=(a253+a297);
  a253=(a354+a253);
  a297=(a269*a253);
  a061=(a061+a297);
  a297=(a314*a009);
  a308=(a316*a150);
  a297=(a297+a308);
  a308=(a317*a191);
  a297=(a297+a308);
  a308=(a318*a233);
  a297=(a297+a308);
  a308=(a319*a277);
  a297=(a297+a308);
  a308=(a270*a354);
  a231=(a272*a180);
  a308=(a308+a231);
  a231=(a273*a220);
  a308=(a308+a231);
  a231=(a274*a038);
  a308=(a308+a231);
  a231=(a275*a210);
  a308=(a308+a231);
  a308=(a463+a308);
  a322=(a322*a308);
  a231=(a270*a052);
  a257=(a272*a069);
  a231=(a231+a257);
  a257=(a273*a187);
  a231=(a231+a257);
  a257=(a274*a006);
  a231=(a231+a257);
  a257=(a275*a227);
  a231=(a231+a257);
  a231=(a225+a231);
  a352=(a352*a231);
  a322=(a322+a352);
  a342=(a342*a253);
  a270=(a270*a429);
  a272=(a272*a178);
  a270=(a270+a272);
  a273=(a273*a218);
  a270=(a270+a273);
  a274=(a274*a261);
  a270=(a270+a274);
  a305=(a305*a264);
  a282=(a282*a186);
  a305=(a305+a282);
  a301=(a301*a210);
  a228=(a228*a227);
  a301=(a301-a228);
  a305=(a305+a301);
  a275=(a275*a305);
  a270=(a270+a275);
  a270=(a052+a270);
  a353=(a353*a270);
  a342=(a342+a353);
  a322=(a322+a342);
  a342=(a320*a322);
  a297=(a297+a342);
  a297=(a354+a297);
  a342=(a313*a297);
  a061=(a061+a342);
  a342=(a359*a009);
  a353=(a361*a150);
  a342=(a342+a353);
  a353=(a362*a191);
  a342=(a342+a353);
  a353=(a363*a233);
  a342=(a342+a353);
  a353=(a364*a277);
  a342=(a342+a353);
  a353=(a365*a322);
  a342=(a342+a353);
  a353=(a314*a354);
  a275=(a316*a180);
  a353=(a353+a275);
  a275=(a317*a220);
  a353=(a353+a275);
  a275=(a318*a038);
  a353=(a353+a275);
  a275=(a319*a210);
  a353=(a353+a275);
  a275=(a320*a253);
  a353=(a353+a275);
  a353=(a463+a353);
  a368=(a368*a353);
  a275=(a314*a052);
  a301=(a316*a069);
  a275=(a275+a301);
  a301=(a317*a187);
  a275=(a275+a301);
  a301=(a318*a006);
  a275=(a275+a301);
  a301=(a319*a227);
  a275=(a275+a301);
  a301=(a320*a270);
  a275=(a275+a301);
  a275=(a225+a275);
  a398=(a398*a275);
  a368=(a368+a398);
  a388=(a388*a297);
  a314=(a314*a429);
  a316=(a316*a178);
  a314=(a314+a316);
  a317=(a317*a218);
  a314=(a314+a317);
  a318=(a318*a261);
  a314=(a314+a318);
  a319=(a319*a305);
  a314=(a314+a319);
  a350=(a350*a308);
  a327=(a327*a231);
  a350=(a350+a327);
  a346=(a346*a253);
  a271=(a271*a270);
  a346=(a346-a271);
  a350=(a350+a346);
  a320=(a320*a350);
  a314=(a314+a320);
  a314=(a052+a314);
  a399=(a399*a314);
  a388=(a388+a399);
  a368=(a368+a388);
  a388=(a366*a368);
  a342=(a342+a388);
  a342=(a354+a342);
  a388=(a358*a342);
  a061=(a061+a388);
  a388=(a405*a009);
  a399=(a407*a150);
  a388=(a388+a399);
  a399=(a408*a191);
  a388=(a388+a399);
  a399=(a409*a233);
  a388=(a388+a399);
  a399=(a410*a277);
  a388=(a388+a399);
  a399=(a411*a322);
  a388=(a388+a399);
  a399=(a412*a368);
  a388=(a388+a399);
  a399=(a359*a354);
  a320=(a361*a180);
  a399=(a399+a320);
  a320=(a362*a220);
  a399=(a399+a320);
  a320=(a363*a038);
  a399=(a399+a320);
  a320=(a364*a210);
  a399=(a399+a320);
  a320=(a365*a253);
  a399=(a399+a320);
  a320=(a366*a297);
  a399=(a399+a320);
  a399=(a463+a399);
  a415=(a415*a399);
  a320=(a359*a052);
  a346=(a361*a069);
  a320=(a320+a346);
  a346=(a362*a187);
  a320=(a320+a346);
  a346=(a363*a006);
  a320=(a320+a346);
  a346=(a364*a227);
  a320=(a320+a346);
  a346=(a365*a270);
  a320=(a320+a346);
  a346=(a366*a314);
  a320=(a320+a346);
  a320=(a225+a320);
  a445=(a445*a320);
  a415=(a415+a445);
  a435=(a435*a342);
  a359=(a359*a429);
  a361=(a361*a178);
  a359=(a359+a361);
  a362=(a362*a218);
  a359=(a359+a362);
  a363=(a363*a261);
  a359=(a359+a363);
  a364=(a364*a305);
  a359=(a359+a364);
  a365=(a365*a350);
  a359=(a359+a365);
  a396=(a396*a353);
  a373=(a373*a275);
  a396=(a396+a373);
  a392=(a392*a297);
  a315=(a315*a314);
  a392=(a392-a315);
  a396=(a396+a392);
  a366=(a366*a396);
  a359=(a359+a366);
  a359=(a052+a359);
  a446=(a446*a359);
  a435=(a435+a446);
  a415=(a415+a435);
  a435=(a413*a415);
  a388=(a388+a435);
  a388=(a354+a388);
  a435=(a404*a388);
  a061=(a061+a435);
  a435=(a452*a009);
  a150=(a454*a150);
  a435=(a435+a150);
  a191=(a182*a191);
  a435=(a435+a191);
  a191=(a222*a233);
  a435=(a435+a191);
  a191=(a455*a277);
  a435=(a435+a191);
  a191=(a456*a322);
  a435=(a435+a191);
  a191=(a457*a368);
  a435=(a435+a191);
  a191=(a458*a415);
  a435=(a435+a191);
  a191=(a405*a354);
  a150=(a407*a180);
  a191=(a191+a150);
  a150=(a408*a220);
  a191=(a191+a150);
  a150=(a409*a038);
  a191=(a191+a150);
  a150=(a410*a210);
  a191=(a191+a150);
  a150=(a411*a253);
  a191=(a191+a150);
  a150=(a412*a297);
  a191=(a191+a150);
  a150=(a413*a342);
  a191=(a191+a150);
  a191=(a463+a191);
  a460=(a460*a191);
  a150=(a405*a052);
  a446=(a407*a069);
  a150=(a150+a446);
  a446=(a408*a187);
  a150=(a150+a446);
  a446=(a409*a006);
  a150=(a150+a446);
  a446=(a410*a227);
  a150=(a150+a446);
  a446=(a411*a270);
  a150=(a150+a446);
  a446=(a412*a314);
  a150=(a150+a446);
  a446=(a413*a359);
  a150=(a150+a446);
  a150=(a225+a150);
  a490=(a490*a150);
  a460=(a460+a490);
  a480=(a480*a388);
  a405=(a405*a429);
  a407=(a407*a178);
  a405=(a405+a407);
  a408=(a408*a218);
  a405=(a405+a408);
  a409=(a409*a261);
  a405=(a405+a409);
  a410=(a410*a305);
  a405=(a405+a410);
  a411=(a411*a350);
  a405=(a405+a411);
  a412=(a412*a396);
  a405=(a405+a412);
  a443=(a443*a399);
  a420=(a420*a320);
  a443=(a443+a420);
  a439=(a439*a342);
  a360=(a360*a359);
  a439=(a439-a360);
  a443=(a443+a439);
  a413=(a413*a443);
  a405=(a405+a413);
  a405=(a052+a405);
  a491=(a491*a405);
  a480=(a480+a491);
  a460=(a460+a480);
  a480=(a459*a460);
  a435=(a435+a480);
  a435=(a354+a435);
  a480=(a451*a435);
  a061=(a061+a480);
  a061=(a463+a061);
  if (res[0]!=0) res[0][12]=a061;
  a061=(a001*a052);
  a480=(a005*a006);
  a061=(a061+a480);
  a480=(a226*a227);
  a061=(a061+a480);
  a480=(a269*a270);
  a061=(a061+a480);
  a480=(a313*a314);
  a061=(a061+a480);
  a480=(a358*a359);
  a061=(a061+a480);
  a480=(a404*a405);
  a061=(a061+a480);
  a480=(a452*a429);
  a178=(a454*a178);
  a480=(a480+a178);
  a218=(a182*a218);
  a480=(a480+a218);
  a218=(a222*a261);
  a480=(a480+a218);
  a218=(a455*a305);
  a480=(a480+a218);
  a218=(a456*a350);
  a480=(a480+a218);
  a218=(a457*a396);
  a480=(a480+a218);
  a218=(a458*a443);
  a480=(a480+a218);
  a488=(a488*a191);
  a465=(a465*a150);
  a488=(a488+a465);
  a484=(a484*a388);
  a406=(a406*a405);
  a484=(a484-a406);
  a488=(a488+a484);
  a484=(a459*a488);
  a480=(a480+a484);
  a480=(a052+a480);
  a484=(a451*a480);
  a061=(a061+a484);
  a061=(a225+a061);
  if (res[0]!=0) res[0][13]=a061;
  a009=(a001*a009);
  a233=(a005*a233);
  a009=(a009+a233);
  a277=(a226*a277);
  a009=(a009+a277);
  a322=(a269*a322);
  a009=(a009+a322);
  a368=(a313*a368);
  a009=(a009+a368);
  a415=(a358*a415);
  a009=(a009+a415);
  a460=(a404*a460);
  a009=(a009+a460);
  a460=(a452*a354);
  a180=(a454*a180);
  a460=(a460+a180);
  a220=(a182*a220);
  a460=(a460+a220);
  a038=(a222*a038);
  a460=(a460+a038);
  a210=(a455*a210);
  a460=(a460+a210);
  a253=(a456*a253);
  a460=(a460+a253);
  a297=(a457*a297);
  a460=(a460+a297);
  a342=(a458*a342);
  a460=(a460+a342);
  a388=(a459*a388);
  a460=(a460+a388);
  a463=(a463+a460);
  a447=(a447*a463);
  a452=(a452*a052);
  a454=(a454*a069);
  a452=(a452+a454);
  a182=(a182*a187);
  a452=(a452+a182);
  a222=(a222*a006);
  a452=(a452+a222);
  a455=(a455*a227);
  a452=(a452+a455);
  a456=(a456*a270);
  a452=(a452+a456);
  a457=(a457*a314);
  a452=(a452+a457);
  a458=(a458*a359);
  a452=(a452+a458);
  a459=(a459*a405);
  a452=(a452+a459);
  a225=(a225+a452);
  a512=(a512*a225);
  a447=(a447+a512);
  a505=(a505*a435);
  a051=(a051*a480);
  a505=(a505+a051);
  a447=(a447+a505);
  a447=(a451*a447);
  a009=(a009+a447);
  a354=(a354+a009);
  if (res[0]!=0) res[0][14]=a354;
  a001=(a001*a429);
  a005=(a005*a261);
  a001=(a001+a005);
  a226=(a226*a305);
  a001=(a001+a226);
  a269=(a269*a350);
  a001=(a001+a269);
  a313=(a313*a396);
  a001=(a001+a313);
  a358=(a358*a443);
  a001=(a001+a358);
  a404=(a404*a488);
  a001=(a001+a404);
  a049=(a049*a463);
  a309=(a309*a225);
  a049=(a049+a309);
  a042=(a042*a435);
  a048=(a048*a480);
  a042=(a042-a048);
  a049=(a049+a042);
  a451=(a451*a049);
  a001=(a001+a451);
  a052=(a052+a001);
  if (res[0]!=0) res[0][15]=a052;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[7])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+515, w1, *w2=w+531, *w3=w+538, w5, *w6=w+540, w7;
  const casadi_real **arg1=arg+5, *wr0, *wr4;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 7, w2);
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

/* landing_with_derivative:(y[4x4],z[3],T,p[7])->(J[4x4],R[4]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[3]? arg[3][1] : 0;
  a04=arg[0]? arg[0][2] : 0;
  a05=(2.*a04);
  a06=arg[3]? arg[3][4] : 0;
  a07=arg[3]? arg[3][5] : 0;
  a08=(a06*a07);
  a09=arg[0]? arg[0][0] : 0;
  a10=cos(a09);
  a11=(a08*a10);
  a12=(a05*a11);
  a13=arg[0]? arg[0][3] : 0;
  a14=(a05-a13);
  a15=arg[0]? arg[0][1] : 0;
  a16=(a09-a15);
  a17=cos(a16);
  a18=(a08*a17);
  a19=(a14*a18);
  a12=(a12+a19);
  a12=(a02*a12);
  a20=arg[3]? arg[3][0] : 0;
  a21=2.;
  a22=arg[3]? arg[3][3] : 0;
  a23=(2.*a22);
  a24=(a21-a23);
  a24=(a02*a24);
  a24=(a20+a24);
  a25=(a04*a24);
  a26=sin(a09);
  a27=(a07*a26);
  a27=(a25*a27);
  a28=(a04*a20);
  a29=(a22*a13);
  a30=(a23*a04);
  a30=(a29-a30);
  a31=(a05+a30);
  a31=(a02*a31);
  a28=(a28+a31);
  a31=sin(a16);
  a32=(a07*a31);
  a32=(a28*a32);
  a27=(a27+a32);
  a12=(a12-a27);
  a27=(2.*a17);
  a27=(a27*a07);
  a33=(a20*a27);
  a33=(a33+a20);
  a34=arg[3]? arg[3][2] : 0;
  a35=(2.*a34);
  a33=(a33+a35);
  a36=(2.*a02);
  a37=casadi_sq(a07);
  a38=(a17*a22);
  a38=(a38*a07);
  a39=(a37-a38);
  a39=(a39-a22);
  a39=(a39+a27);
  a27=(a08*a31);
  a39=(a39+a27);
  a40=casadi_sq(a22);
  a41=casadi_sq(a06);
  a42=(a40+a41);
  a39=(a39+a42);
  a43=sin(a15);
  a44=(a06*a43);
  a45=cos(a15);
  a46=(a45*a22);
  a47=(a44-a46);
  a08=(a08*a26);
  a47=(a47+a08);
  a48=(a10*a22);
  a48=(a48*a07);
  a47=(a47-a48);
  a39=(a39+a47);
  a39=(a39+a03);
  a39=(a36*a39);
  a33=(a33+a39);
  a39=(a20*a07);
  a39=(a39*a07);
  a33=(a33+a39);
  a49=(a12/a33);
  a50=(a10*a07);
  a51=(a50*a25);
  a52=(a17*a07);
  a28=(a52*a28);
  a51=(a51+a28);
  a28=(a45*a25);
  a51=(a51+a28);
  a28=(a05*a34);
  a51=(a51+a28);
  a28=(a04*a39);
  a51=(a51+a28);
  a28=(a13*a34);
  a51=(a51-a28);
  a28=(a23*a22);
  a53=(a28*a04);
  a54=(a40*a13);
  a53=(a53-a54);
  a54=(2.*a06);
  a54=(a54*a06);
  a55=(a54*a04);
  a53=(a53+a55);
  a55=(a41*a13);
  a53=(a53-a55);
  a55=(a05*a07);
  a55=(a55*a07);
  a53=(a53+a55);
  a55=(a05*a08);
  a53=(a53+a55);
  a53=(a53+a30);
  a30=(a27*a14);
  a53=(a53+a30);
  a53=(a02*a53);
  a51=(a51+a53);
  a53=(a51/a33);
  a30=(a53/a33);
  a55=(-a31);
  a55=(2.*a55);
  a55=(a07*a55);
  a56=(a20*a55);
  a57=(a22*a31);
  a57=(a07*a57);
  a55=(a57+a55);
  a55=(a55+a18);
  a58=(a22*a26);
  a58=(a07*a58);
  a59=(a11+a58);
  a55=(a55+a59);
  a55=(a36*a55);
  a56=(a56+a55);
  a55=(a30*a56);
  a49=(a49-a55);
  a55=(a22-a42);
  a60=(a02*a55);
  a60=(a60-a34);
  a61=(a04*a60);
  a62=(a04*a48);
  a63=(a04*a08);
  a62=(a62-a63);
  a62=(a02*a62);
  a61=(a61+a62);
  a47=(a42+a47);
  a47=(a02*a47);
  a47=(a34+a47);
  a62=(a47/a33);
  a63=(a62*a51);
  a61=(a61+a63);
  a63=(a02*a42);
  a63=(a34+a63);
  a64=(a47*a62);
  a64=(a63-a64);
  a61=(a61/a64);
  a59=(a02*a59);
  a65=(a59/a33);
  a66=(a62/a33);
  a56=(a66*a56);
  a65=(a65-a56);
  a56=(a61*a65);
  a67=(a51*a65);
  a12=(a62*a12);
  a67=(a67+a12);
  a58=(a04*a58);
  a11=(a04*a11);
  a58=(a58+a11);
  a58=(a02*a58);
  a67=(a67-a58);
  a67=(a67/a64);
  a58=(a61/a64);
  a59=(a62*a59);
  a65=(a47*a65);
  a59=(a59+a65);
  a59=(a58*a59);
  a67=(a67+a59);
  a59=(a62*a67);
  a56=(a56+a59);
  a49=(a49+a56);
  a56=(a49*a00);
  a25=(a25*a43);
  a32=(a32-a25);
  a19=(a02*a19);
  a32=(a32-a19);
  a19=(a32/a33);
  a25=(2.*a31);
  a25=(a07*a25);
  a59=(a20*a25);
  a25=(a25-a57);
  a25=(a25-a18);
  a18=(a06*a45);
  a57=(a22*a43);
  a18=(a18+a57);
  a25=(a25+a18);
  a25=(a36*a25);
  a59=(a59+a25);
  a30=(a30*a59);
  a19=(a19-a30);
  a18=(a02*a18);
  a30=(a18/a33);
  a66=(a66*a59);
  a30=(a30-a66);
  a66=(a61*a30);
  a51=(a51*a30);
  a32=(a62*a32);
  a51=(a51+a32);
  a51=(a51/a64);
  a18=(a62*a18);
  a47=(a47*a30);
  a18=(a18+a47);
  a58=(a58*a18);
  a51=(a51+a58);
  a58=(a62*a51);
  a66=(a66+a58);
  a19=(a19+a66);
  a66=(a19*a01);
  a56=(a56+a66);
  a50=(a50*a24);
  a66=(a52*a24);
  a50=(a50+a66);
  a24=(a45*a24);
  a50=(a50+a24);
  a50=(a50+a35);
  a50=(a50+a39);
  a28=(a28+a54);
  a54=(2.*a07);
  a54=(a07*a54);
  a28=(a28+a54);
  a54=(2.*a08);
  a28=(a28+a54);
  a28=(a28-a23);
  a23=(2.*a27);
  a28=(a28+a23);
  a28=(a02*a28);
  a50=(a50+a28);
  a28=(a50/a33);
  a23=(a48-a08);
  a23=(a02*a23);
  a60=(a60+a23);
  a50=(a62*a50);
  a60=(a60+a50);
  a60=(a60/a64);
  a50=(a62*a60);
  a28=(a28+a50);
  a50=arg[0]? arg[0][6] : 0;
  a23=(a28*a50);
  a56=(a56+a23);
  a23=(a02*a22);
  a52=(a52*a23);
  a52=(a52-a34);
  a55=(a55-a27);
  a55=(a02*a55);
  a52=(a52+a55);
  a33=(a52/a33);
  a52=(a62*a52);
  a52=(a52/a64);
  a64=(a62*a52);
  a33=(a33+a64);
  a64=arg[0]? arg[0][7] : 0;
  a55=(a33*a64);
  a56=(a56+a55);
  if (res[0]!=0) res[0][1]=a56;
  a56=(a67*a00);
  a55=(a51*a01);
  a56=(a56+a55);
  a50=(a60*a50);
  a56=(a56+a50);
  a64=(a52*a64);
  a56=(a56+a64);
  if (res[0]!=0) res[0][2]=a56;
  a56=-2.;
  a00=(a56*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a64=(a00-a01);
  if (res[0]!=0) res[0][4]=a64;
  a64=(a49*a00);
  a50=(a19*a01);
  a64=(a64+a50);
  a50=arg[0]? arg[0][10] : 0;
  a55=(a28*a50);
  a64=(a64+a55);
  a55=arg[0]? arg[0][11] : 0;
  a23=(a33*a55);
  a64=(a64+a23);
  a64=(a64-a03);
  if (res[0]!=0) res[0][5]=a64;
  a64=(a67*a00);
  a23=(a51*a01);
  a64=(a64+a23);
  a50=(a60*a50);
  a64=(a64+a50);
  a55=(a52*a55);
  a64=(a64+a55);
  if (res[0]!=0) res[0][6]=a64;
  a00=(a56*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a64=(a00-a01);
  if (res[0]!=0) res[0][8]=a64;
  a64=(a49*a00);
  a55=(a19*a01);
  a64=(a64+a55);
  a55=arg[0]? arg[0][14] : 0;
  a50=(a28*a55);
  a64=(a64+a50);
  a50=arg[0]? arg[0][15] : 0;
  a23=(a33*a50);
  a64=(a64+a23);
  if (res[0]!=0) res[0][9]=a64;
  a64=(a67*a00);
  a23=(a51*a01);
  a64=(a64+a23);
  a55=(a60*a55);
  a64=(a64+a55);
  a50=(a52*a50);
  a64=(a64+a50);
  a64=(a64-a03);
  if (res[0]!=0) res[0][10]=a64;
  a00=(a56*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=(a04-a13);
  if (res[0]!=0) res[0][12]=a00;
  a49=(a49*a04);
  a19=(a19*a13);
  a49=(a49+a19);
  a19=casadi_sq(a04);
  a00=(a19*a07);
  a00=(a00*a26);
  a21=(a21-a22);
  a21=(a02*a21);
  a21=(a20+a21);
  a00=(a00*a21);
  a17=(a17*a06);
  a17=(a17*a07);
  a05=(a05*a13);
  a05=(a05-a19);
  a26=casadi_sq(a13);
  a05=(a05-a26);
  a17=(a17*a05);
  a26=(a15-a09);
  a01=arg[3]? arg[3][6] : 0;
  a26=(a26+a01);
  a64=cos(a26);
  a64=(a64*a06);
  a17=(a17-a64);
  a50=(a10*a06);
  a50=(a50*a04);
  a50=(a50*a04);
  a50=(a50*a07);
  a17=(a17-a50);
  a50=(a09-a01);
  a55=cos(a50);
  a55=(a55*a06);
  a17=(a17-a55);
  a45=(a45*a06);
  a06=(a45*a13);
  a06=(a06*a14);
  a17=(a17+a06);
  a29=(a29*a43);
  a29=(a29*a14);
  a17=(a17-a29);
  a29=(a22*a07);
  a29=(a29*a31);
  a29=(a29*a05);
  a17=(a17+a29);
  a26=sin(a26);
  a26=(a22*a26);
  a17=(a17+a26);
  a17=(a02*a17);
  a00=(a00+a17);
  a01=sin(a01);
  a01=(a07*a01);
  a17=(a20+a36);
  a01=(a01*a17);
  a00=(a00-a01);
  a50=sin(a50);
  a50=(a50*a21);
  a00=(a00+a50);
  a10=(2.*a10);
  a10=(a10*a07);
  a07=(a20*a10);
  a39=(a39+a07);
  a39=(a39+a20);
  a39=(a39+a35);
  a08=(a08-a48);
  a08=(a08-a46);
  a08=(a08-a22);
  a08=(a08-a44);
  a08=(a08+a37);
  a08=(a08+a10);
  a08=(a08+a27);
  a08=(a08-a38);
  a08=(a08+a42);
  a08=(a08+a03);
  a36=(a36*a08);
  a39=(a39+a36);
  a36=(a00/a39);
  a46=(a46-a40);
  a46=(a46-a41);
  a46=(a46+a44);
  a46=(a46-a27);
  a46=(a46+a38);
  a46=(a02*a46);
  a46=(a46-a34);
  a39=(a46/a39);
  a64=(a64-a26);
  a57=(a57-a45);
  a19=(a19*a57);
  a64=(a64+a19);
  a02=(a02*a64);
  a00=(a39*a00);
  a02=(a02-a00);
  a46=(a46*a39);
  a63=(a63-a46);
  a02=(a02/a63);
  a39=(a39*a02);
  a36=(a36-a39);
  a28=(a28*a36);
  a49=(a49+a28);
  a33=(a33*a02);
  a49=(a49+a33);
  if (res[0]!=0) res[0][13]=a49;
  a67=(a67*a04);
  a51=(a51*a13);
  a67=(a67+a51);
  a60=(a60*a36);
  a67=(a67+a60);
  a52=(a52*a02);
  a67=(a67+a52);
  if (res[0]!=0) res[0][14]=a67;
  a56=(a56*a04);
  a56=(a56+a13);
  if (res[0]!=0) res[0][15]=a56;
  a56=arg[1]? arg[1][0] : 0;
  a16=(a16-a56);
  if (res[1]!=0) res[1][0]=a16;
  a62=(a62*a61);
  a53=(a53+a62);
  a62=arg[1]? arg[1][1] : 0;
  a53=(a53-a62);
  if (res[1]!=0) res[1][1]=a53;
  a53=arg[1]? arg[1][2] : 0;
  a61=(a61-a53);
  if (res[1]!=0) res[1][2]=a61;
  a09=(2.*a09);
  a15=(a15-a09);
  if (res[1]!=0) res[1][3]=a15;
  return 0;
}

/* round_feet_jacobian_12:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* scaled_jacobian_12:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+672, *w1=w+688, *w2=w+692, *w3=w+699, *w4=w+715;
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
  casadi_copy(arg[1], 7, w2);
  /* #3: {@3, @4} = round_feet_jacobian_12(@1, @2) */
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

/* newton_12:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_12:(i0[4],i1[7])->(o0[4]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+783, *w1=w+787, *w2=w+794;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* plain_step:(y[4],phase[2],turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92;
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
  a07=casadi_sq(a03);
  a08=arg[4]? arg[4][5] : 0;
  a09=(a07*a08);
  a10=sin(a00);
  a09=(a09*a10);
  a11=arg[4]? arg[4][0] : 0;
  a12=arg[4]? arg[4][1] : 0;
  a13=2.;
  a14=arg[4]? arg[4][3] : 0;
  a13=(a13-a14);
  a13=(a12*a13);
  a13=(a11+a13);
  a09=(a09*a13);
  a15=cos(a00);
  a16=arg[0]? arg[0][1] : 0;
  a17=cos(a16);
  a18=(a15*a17);
  a19=sin(a16);
  a20=(a10*a19);
  a18=(a18+a20);
  a20=arg[4]? arg[4][4] : 0;
  a21=(a18*a20);
  a21=(a21*a08);
  a22=(2.*a03);
  a23=arg[0]? arg[0][3] : 0;
  a24=(a22*a23);
  a24=(a24-a07);
  a25=casadi_sq(a23);
  a24=(a24-a25);
  a21=(a21*a24);
  a25=(a16-a00);
  a26=arg[4]? arg[4][6] : 0;
  a25=(a25+a26);
  a27=cos(a25);
  a27=(a27*a20);
  a21=(a21-a27);
  a28=(a15*a20);
  a28=(a28*a03);
  a28=(a28*a03);
  a28=(a28*a08);
  a21=(a21-a28);
  a28=cos(a26);
  a29=(a15*a28);
  a30=sin(a26);
  a31=(a10*a30);
  a29=(a29+a31);
  a29=(a29*a20);
  a21=(a21-a29);
  a29=(a17*a20);
  a31=(a29*a23);
  a22=(a22-a23);
  a31=(a31*a22);
  a21=(a21+a31);
  a31=(a14*a23);
  a31=(a31*a19);
  a31=(a31*a22);
  a21=(a21-a31);
  a31=(a14*a08);
  a22=(a10*a17);
  a32=(a15*a19);
  a22=(a22-a32);
  a32=(a31*a22);
  a32=(a32*a24);
  a21=(a21+a32);
  a25=sin(a25);
  a25=(a14*a25);
  a21=(a21+a25);
  a21=(a12*a21);
  a09=(a09+a21);
  a21=(a08*a30);
  a32=(2.*a12);
  a24=(a11+a32);
  a21=(a21*a24);
  a09=(a09-a21);
  a24=(a10*a28);
  a33=(a15*a30);
  a24=(a24-a33);
  a24=(a24*a13);
  a09=(a09+a24);
  a24=(a11*a08);
  a24=(a24*a08);
  a33=(2.*a15);
  a33=(a33*a08);
  a34=(a11*a33);
  a34=(a24+a34);
  a34=(a34+a11);
  a35=arg[4]? arg[4][2] : 0;
  a36=(2.*a35);
  a34=(a34+a36);
  a37=(a20*a08);
  a10=(a37*a10);
  a15=(a15*a14);
  a15=(a15*a08);
  a10=(a10-a15);
  a17=(a17*a14);
  a10=(a10-a17);
  a10=(a10-a14);
  a15=(a20*a19);
  a10=(a10-a15);
  a38=casadi_sq(a08);
  a10=(a10+a38);
  a10=(a10+a33);
  a22=(a37*a22);
  a10=(a10+a22);
  a18=(a18*a14);
  a18=(a18*a08);
  a10=(a10-a18);
  a33=casadi_sq(a14);
  a39=casadi_sq(a20);
  a40=(a33+a39);
  a10=(a10+a40);
  a41=1.;
  a10=(a10+a41);
  a10=(a32*a10);
  a34=(a34+a10);
  a10=(a09/a34);
  a17=(a17-a33);
  a17=(a17-a39);
  a17=(a17+a15);
  a17=(a17-a22);
  a17=(a17+a18);
  a17=(a12*a17);
  a17=(a17-a35);
  a34=(a17/a34);
  a27=(a27-a25);
  a19=(a14*a19);
  a19=(a19-a29);
  a07=(a07*a19);
  a27=(a27+a07);
  a27=(a12*a27);
  a09=(a34*a09);
  a27=(a27-a09);
  a09=(a12*a40);
  a09=(a35+a09);
  a17=(a17*a34);
  a17=(a09-a17);
  a27=(a27/a17);
  a34=(a34*a27);
  a10=(a10-a34);
  a34=(a06*a10);
  a17=1.7082860872947386e-01;
  a17=(a17*a02);
  a07=2.9587585476806851e-02;
  a07=(a07*a02);
  a19=(a07*a10);
  a29=8.8762756430420545e-02;
  a29=(a29*a02);
  a25=1.9725056984537900e-02;
  a25=(a25*a02);
  a18=(a25*a10);
  a22=5.9175170953613701e-02;
  a22=(a22*a02);
  a15=5.2600151958767730e-02;
  a15=(a15*a02);
  a42=(a15*a10);
  a42=(a03+a42);
  a43=casadi_sq(a42);
  a44=(a43*a08);
  a45=(a15*a03);
  a45=(a00+a45);
  a46=sin(a45);
  a44=(a44*a46);
  a44=(a44*a13);
  a47=cos(a45);
  a48=(a15*a23);
  a48=(a16+a48);
  a49=cos(a48);
  a50=(a47*a49);
  a51=sin(a48);
  a52=(a46*a51);
  a50=(a50+a52);
  a52=(a50*a20);
  a52=(a52*a08);
  a53=(2.*a42);
  a15=(a15*a27);
  a15=(a23+a15);
  a54=(a53*a15);
  a54=(a54-a43);
  a55=casadi_sq(a15);
  a54=(a54-a55);
  a52=(a52*a54);
  a48=(a48-a45);
  a48=(a48+a26);
  a45=cos(a48);
  a45=(a45*a20);
  a52=(a52-a45);
  a55=(a47*a20);
  a55=(a55*a42);
  a55=(a55*a42);
  a55=(a55*a08);
  a52=(a52-a55);
  a55=(a47*a28);
  a56=(a46*a30);
  a55=(a55+a56);
  a55=(a55*a20);
  a52=(a52-a55);
  a55=(a49*a20);
  a56=(a55*a15);
  a53=(a53-a15);
  a56=(a56*a53);
  a52=(a52+a56);
  a56=(a14*a15);
  a56=(a56*a51);
  a56=(a56*a53);
  a52=(a52-a56);
  a56=(a46*a49);
  a53=(a47*a51);
  a56=(a56-a53);
  a53=(a31*a56);
  a53=(a53*a54);
  a52=(a52+a53);
  a48=sin(a48);
  a48=(a14*a48);
  a52=(a52+a48);
  a52=(a12*a52);
  a44=(a44+a52);
  a44=(a44-a21);
  a52=(a46*a28);
  a53=(a47*a30);
  a52=(a52-a53);
  a52=(a52*a13);
  a44=(a44+a52);
  a52=(2.*a47);
  a52=(a52*a08);
  a53=(a11*a52);
  a53=(a24+a53);
  a53=(a53+a11);
  a53=(a53+a36);
  a46=(a37*a46);
  a47=(a47*a14);
  a47=(a47*a08);
  a46=(a46-a47);
  a49=(a49*a14);
  a46=(a46-a49);
  a46=(a46-a14);
  a47=(a20*a51);
  a46=(a46-a47);
  a46=(a46+a38);
  a46=(a46+a52);
  a56=(a37*a56);
  a46=(a46+a56);
  a50=(a50*a14);
  a50=(a50*a08);
  a46=(a46-a50);
  a46=(a46+a40);
  a46=(a46+a41);
  a46=(a32*a46);
  a53=(a53+a46);
  a46=(a44/a53);
  a49=(a49-a33);
  a49=(a49-a39);
  a49=(a49+a47);
  a49=(a49-a56);
  a49=(a49+a50);
  a49=(a12*a49);
  a49=(a49-a35);
  a53=(a49/a53);
  a45=(a45-a48);
  a51=(a14*a51);
  a51=(a51-a55);
  a43=(a43*a51);
  a45=(a45+a43);
  a45=(a12*a45);
  a44=(a53*a44);
  a45=(a45-a44);
  a49=(a49*a53);
  a49=(a09-a49);
  a45=(a45/a49);
  a53=(a53*a45);
  a46=(a46-a53);
  a46=(a22*a46);
  a18=(a18+a46);
  a18=(a03+a18);
  a46=casadi_sq(a18);
  a53=(a46*a08);
  a49=(a25*a03);
  a42=(a22*a42);
  a49=(a49+a42);
  a49=(a00+a49);
  a42=sin(a49);
  a53=(a53*a42);
  a53=(a53*a13);
  a44=cos(a49);
  a43=(a25*a23);
  a15=(a22*a15);
  a43=(a43+a15);
  a43=(a16+a43);
  a15=cos(a43);
  a51=(a44*a15);
  a55=sin(a43);
  a48=(a42*a55);
  a51=(a51+a48);
  a48=(a51*a20);
  a48=(a48*a08);
  a50=(2.*a18);
  a25=(a25*a27);
  a22=(a22*a45);
  a25=(a25+a22);
  a25=(a23+a25);
  a22=(a50*a25);
  a22=(a22-a46);
  a45=casadi_sq(a25);
  a22=(a22-a45);
  a48=(a48*a22);
  a43=(a43-a49);
  a43=(a43+a26);
  a49=cos(a43);
  a49=(a49*a20);
  a48=(a48-a49);
  a45=(a44*a20);
  a45=(a45*a18);
  a45=(a45*a18);
  a45=(a45*a08);
  a48=(a48-a45);
  a45=(a44*a28);
  a56=(a42*a30);
  a45=(a45+a56);
  a45=(a45*a20);
  a48=(a48-a45);
  a45=(a15*a20);
  a56=(a45*a25);
  a50=(a50-a25);
  a56=(a56*a50);
  a48=(a48+a56);
  a56=(a14*a25);
  a56=(a56*a55);
  a56=(a56*a50);
  a48=(a48-a56);
  a56=(a42*a15);
  a50=(a44*a55);
  a56=(a56-a50);
  a50=(a31*a56);
  a50=(a50*a22);
  a48=(a48+a50);
  a43=sin(a43);
  a43=(a14*a43);
  a48=(a48+a43);
  a48=(a12*a48);
  a53=(a53+a48);
  a53=(a53-a21);
  a48=(a42*a28);
  a50=(a44*a30);
  a48=(a48-a50);
  a48=(a48*a13);
  a53=(a53+a48);
  a48=(2.*a44);
  a48=(a48*a08);
  a50=(a11*a48);
  a50=(a24+a50);
  a50=(a50+a11);
  a50=(a50+a36);
  a42=(a37*a42);
  a44=(a44*a14);
  a44=(a44*a08);
  a42=(a42-a44);
  a15=(a15*a14);
  a42=(a42-a15);
  a42=(a42-a14);
  a44=(a20*a55);
  a42=(a42-a44);
  a42=(a42+a38);
  a42=(a42+a48);
  a56=(a37*a56);
  a42=(a42+a56);
  a51=(a51*a14);
  a51=(a51*a08);
  a42=(a42-a51);
  a42=(a42+a40);
  a42=(a42+a41);
  a42=(a32*a42);
  a50=(a50+a42);
  a42=(a53/a50);
  a15=(a15-a33);
  a15=(a15-a39);
  a15=(a15+a44);
  a15=(a15-a56);
  a15=(a15+a51);
  a15=(a12*a15);
  a15=(a15-a35);
  a50=(a15/a50);
  a49=(a49-a43);
  a55=(a14*a55);
  a55=(a55-a45);
  a46=(a46*a55);
  a49=(a49+a46);
  a49=(a12*a49);
  a53=(a50*a53);
  a49=(a49-a53);
  a15=(a15*a50);
  a15=(a09-a15);
  a49=(a49/a15);
  a50=(a50*a49);
  a42=(a42-a50);
  a50=(a29*a42);
  a19=(a19+a50);
  a19=(a03+a19);
  a50=casadi_sq(a19);
  a15=(a50*a08);
  a53=(a07*a03);
  a46=(a29*a18);
  a53=(a53+a46);
  a53=(a00+a53);
  a46=sin(a53);
  a15=(a15*a46);
  a15=(a15*a13);
  a55=cos(a53);
  a45=(a07*a23);
  a43=(a29*a25);
  a45=(a45+a43);
  a45=(a16+a45);
  a43=cos(a45);
  a51=(a55*a43);
  a56=sin(a45);
  a44=(a46*a56);
  a51=(a51+a44);
  a44=(a51*a20);
  a44=(a44*a08);
  a48=(2.*a19);
  a07=(a07*a27);
  a29=(a29*a49);
  a07=(a07+a29);
  a07=(a23+a07);
  a29=(a48*a07);
  a29=(a29-a50);
  a22=casadi_sq(a07);
  a29=(a29-a22);
  a44=(a44*a29);
  a45=(a45-a53);
  a45=(a45+a26);
  a53=cos(a45);
  a53=(a53*a20);
  a44=(a44-a53);
  a22=(a55*a20);
  a22=(a22*a19);
  a22=(a22*a19);
  a22=(a22*a08);
  a44=(a44-a22);
  a22=(a55*a28);
  a47=(a46*a30);
  a22=(a22+a47);
  a22=(a22*a20);
  a44=(a44-a22);
  a22=(a43*a20);
  a47=(a22*a07);
  a48=(a48-a07);
  a47=(a47*a48);
  a44=(a44+a47);
  a47=(a14*a07);
  a47=(a47*a56);
  a47=(a47*a48);
  a44=(a44-a47);
  a47=(a46*a43);
  a48=(a55*a56);
  a47=(a47-a48);
  a48=(a31*a47);
  a48=(a48*a29);
  a44=(a44+a48);
  a45=sin(a45);
  a45=(a14*a45);
  a44=(a44+a45);
  a44=(a12*a44);
  a15=(a15+a44);
  a15=(a15-a21);
  a44=(a46*a28);
  a48=(a55*a30);
  a44=(a44-a48);
  a44=(a44*a13);
  a15=(a15+a44);
  a44=(2.*a55);
  a44=(a44*a08);
  a48=(a11*a44);
  a48=(a24+a48);
  a48=(a48+a11);
  a48=(a48+a36);
  a46=(a37*a46);
  a55=(a55*a14);
  a55=(a55*a08);
  a46=(a46-a55);
  a43=(a43*a14);
  a46=(a46-a43);
  a46=(a46-a14);
  a55=(a20*a56);
  a46=(a46-a55);
  a46=(a46+a38);
  a46=(a46+a44);
  a47=(a37*a47);
  a46=(a46+a47);
  a51=(a51*a14);
  a51=(a51*a08);
  a46=(a46-a51);
  a46=(a46+a40);
  a46=(a46+a41);
  a46=(a32*a46);
  a48=(a48+a46);
  a46=(a15/a48);
  a43=(a43-a33);
  a43=(a43-a39);
  a43=(a43+a55);
  a43=(a43-a47);
  a43=(a43+a51);
  a43=(a12*a43);
  a43=(a43-a35);
  a48=(a43/a48);
  a53=(a53-a45);
  a56=(a14*a56);
  a56=(a56-a22);
  a50=(a50*a56);
  a53=(a53+a50);
  a53=(a12*a53);
  a15=(a48*a15);
  a53=(a53-a15);
  a43=(a43*a48);
  a43=(a09-a43);
  a53=(a53/a43);
  a48=(a48*a53);
  a46=(a46-a48);
  a48=(a17*a46);
  a34=(a34+a48);
  a48=1.2546768756682242e-01;
  a48=(a48*a02);
  a43=2.4136513415926669e-01;
  a43=(a43*a02);
  a15=(a43*a10);
  a50=-8.8454947932828609e-01;
  a50=(a50*a02);
  a42=(a50*a42);
  a15=(a15+a42);
  a42=9.2483400326179199e-01;
  a42=(a42*a02);
  a56=(a42*a46);
  a15=(a15+a56);
  a15=(a03+a15);
  a56=casadi_sq(a15);
  a22=(a56*a08);
  a45=(a43*a03);
  a18=(a50*a18);
  a45=(a45+a18);
  a18=(a42*a19);
  a45=(a45+a18);
  a45=(a00+a45);
  a18=sin(a45);
  a22=(a22*a18);
  a22=(a22*a13);
  a51=cos(a45);
  a47=(a43*a23);
  a25=(a50*a25);
  a47=(a47+a25);
  a25=(a42*a07);
  a47=(a47+a25);
  a47=(a16+a47);
  a25=cos(a47);
  a55=(a51*a25);
  a44=sin(a47);
  a29=(a18*a44);
  a55=(a55+a29);
  a29=(a55*a20);
  a29=(a29*a08);
  a52=(2.*a15);
  a43=(a43*a27);
  a50=(a50*a49);
  a43=(a43+a50);
  a42=(a42*a53);
  a43=(a43+a42);
  a43=(a23+a43);
  a42=(a52*a43);
  a42=(a42-a56);
  a50=casadi_sq(a43);
  a42=(a42-a50);
  a29=(a29*a42);
  a47=(a47-a45);
  a47=(a47+a26);
  a45=cos(a47);
  a45=(a45*a20);
  a29=(a29-a45);
  a50=(a51*a20);
  a50=(a50*a15);
  a50=(a50*a15);
  a50=(a50*a08);
  a29=(a29-a50);
  a50=(a51*a28);
  a49=(a18*a30);
  a50=(a50+a49);
  a50=(a50*a20);
  a29=(a29-a50);
  a50=(a25*a20);
  a49=(a50*a43);
  a52=(a52-a43);
  a49=(a49*a52);
  a29=(a29+a49);
  a49=(a14*a43);
  a49=(a49*a44);
  a49=(a49*a52);
  a29=(a29-a49);
  a49=(a18*a25);
  a52=(a51*a44);
  a49=(a49-a52);
  a52=(a31*a49);
  a52=(a52*a42);
  a29=(a29+a52);
  a47=sin(a47);
  a47=(a14*a47);
  a29=(a29+a47);
  a29=(a12*a29);
  a22=(a22+a29);
  a22=(a22-a21);
  a29=(a18*a28);
  a52=(a51*a30);
  a29=(a29-a52);
  a29=(a29*a13);
  a22=(a22+a29);
  a29=(2.*a51);
  a29=(a29*a08);
  a52=(a11*a29);
  a52=(a24+a52);
  a52=(a52+a11);
  a52=(a52+a36);
  a18=(a37*a18);
  a51=(a51*a14);
  a51=(a51*a08);
  a18=(a18-a51);
  a25=(a25*a14);
  a18=(a18-a25);
  a18=(a18-a14);
  a51=(a20*a44);
  a18=(a18-a51);
  a18=(a18+a38);
  a18=(a18+a29);
  a49=(a37*a49);
  a18=(a18+a49);
  a55=(a55*a14);
  a55=(a55*a08);
  a18=(a18-a55);
  a18=(a18+a40);
  a18=(a18+a41);
  a18=(a32*a18);
  a52=(a52+a18);
  a18=(a22/a52);
  a25=(a25-a33);
  a25=(a25-a39);
  a25=(a25+a51);
  a25=(a25-a49);
  a25=(a25+a55);
  a25=(a12*a25);
  a25=(a25-a35);
  a52=(a25/a52);
  a45=(a45-a47);
  a44=(a14*a44);
  a44=(a44-a50);
  a56=(a56*a44);
  a45=(a45+a56);
  a45=(a12*a45);
  a22=(a52*a22);
  a45=(a45-a22);
  a25=(a25*a52);
  a25=(a09-a25);
  a45=(a45/a25);
  a52=(a52*a45);
  a18=(a18-a52);
  a52=(a48*a18);
  a34=(a34+a52);
  a34=(a03+a34);
  a52=(a05*a34);
  a04=(a04+a52);
  a52=1.8915178993145003e+00;
  a52=(a52*a02);
  a25=3.7109375000000000e-02;
  a25=(a25*a02);
  a22=(a25*a10);
  a56=1.7025221101954405e-01;
  a56=(a56*a02);
  a44=(a56*a46);
  a22=(a22+a44);
  a44=6.0216538980455959e-02;
  a44=(a44*a02);
  a50=(a44*a18);
  a22=(a22+a50);
  a50=-1.7578125000000000e-02;
  a50=(a50*a02);
  a47=casadi_sq(a34);
  a55=(a47*a08);
  a49=(a06*a03);
  a51=(a17*a19);
  a49=(a49+a51);
  a51=(a48*a15);
  a49=(a49+a51);
  a49=(a00+a49);
  a51=sin(a49);
  a55=(a55*a51);
  a55=(a55*a13);
  a29=cos(a49);
  a42=(a06*a23);
  a54=(a17*a07);
  a42=(a42+a54);
  a54=(a48*a43);
  a42=(a42+a54);
  a42=(a16+a42);
  a54=cos(a42);
  a57=(a29*a54);
  a58=sin(a42);
  a59=(a51*a58);
  a57=(a57+a59);
  a59=(a57*a20);
  a59=(a59*a08);
  a60=(2.*a34);
  a06=(a06*a27);
  a17=(a17*a53);
  a06=(a06+a17);
  a48=(a48*a45);
  a06=(a06+a48);
  a06=(a23+a06);
  a48=(a60*a06);
  a48=(a48-a47);
  a17=casadi_sq(a06);
  a48=(a48-a17);
  a59=(a59*a48);
  a42=(a42-a49);
  a42=(a42+a26);
  a49=cos(a42);
  a49=(a49*a20);
  a59=(a59-a49);
  a17=(a29*a20);
  a17=(a17*a34);
  a17=(a17*a34);
  a17=(a17*a08);
  a59=(a59-a17);
  a17=(a29*a28);
  a61=(a51*a30);
  a17=(a17+a61);
  a17=(a17*a20);
  a59=(a59-a17);
  a17=(a54*a20);
  a61=(a17*a06);
  a60=(a60-a06);
  a61=(a61*a60);
  a59=(a59+a61);
  a61=(a14*a06);
  a61=(a61*a58);
  a61=(a61*a60);
  a59=(a59-a61);
  a61=(a51*a54);
  a60=(a29*a58);
  a61=(a61-a60);
  a60=(a31*a61);
  a60=(a60*a48);
  a59=(a59+a60);
  a42=sin(a42);
  a42=(a14*a42);
  a59=(a59+a42);
  a59=(a12*a59);
  a55=(a55+a59);
  a55=(a55-a21);
  a59=(a51*a28);
  a60=(a29*a30);
  a59=(a59-a60);
  a59=(a59*a13);
  a55=(a55+a59);
  a59=(2.*a29);
  a59=(a59*a08);
  a60=(a11*a59);
  a60=(a24+a60);
  a60=(a60+a11);
  a60=(a60+a36);
  a51=(a37*a51);
  a29=(a29*a14);
  a29=(a29*a08);
  a51=(a51-a29);
  a54=(a54*a14);
  a51=(a51-a54);
  a51=(a51-a14);
  a29=(a20*a58);
  a51=(a51-a29);
  a51=(a51+a38);
  a51=(a51+a59);
  a61=(a37*a61);
  a51=(a51+a61);
  a57=(a57*a14);
  a57=(a57*a08);
  a51=(a51-a57);
  a51=(a51+a40);
  a51=(a51+a41);
  a51=(a32*a51);
  a60=(a60+a51);
  a51=(a55/a60);
  a54=(a54-a33);
  a54=(a54-a39);
  a54=(a54+a29);
  a54=(a54-a61);
  a54=(a54+a57);
  a54=(a12*a54);
  a54=(a54-a35);
  a60=(a54/a60);
  a49=(a49-a42);
  a58=(a14*a58);
  a58=(a58-a17);
  a47=(a47*a58);
  a49=(a49+a47);
  a49=(a12*a49);
  a55=(a60*a55);
  a49=(a49-a55);
  a54=(a54*a60);
  a54=(a09-a54);
  a49=(a49/a54);
  a60=(a60*a49);
  a51=(a51-a60);
  a60=(a50*a51);
  a22=(a22+a60);
  a22=(a03+a22);
  a60=(a52*a22);
  a04=(a04+a60);
  a60=-5.8012039600105849e+00;
  a60=(a60*a02);
  a54=3.7092000118504789e-02;
  a54=(a54*a02);
  a55=(a54*a10);
  a47=1.7038392571223998e-01;
  a47=(a47*a02);
  a58=(a47*a46);
  a55=(a55+a58);
  a58=1.0726203044637328e-01;
  a58=(a58*a02);
  a17=(a58*a18);
  a55=(a55+a17);
  a17=-1.5319437748624402e-02;
  a17=(a17*a02);
  a42=(a17*a51);
  a55=(a55+a42);
  a42=8.2737891638140233e-03;
  a42=(a42*a02);
  a57=casadi_sq(a22);
  a61=(a57*a08);
  a29=(a25*a03);
  a59=(a56*a19);
  a29=(a29+a59);
  a59=(a44*a15);
  a29=(a29+a59);
  a59=(a50*a34);
  a29=(a29+a59);
  a29=(a00+a29);
  a59=sin(a29);
  a61=(a61*a59);
  a61=(a61*a13);
  a48=cos(a29);
  a62=(a25*a23);
  a63=(a56*a07);
  a62=(a62+a63);
  a63=(a44*a43);
  a62=(a62+a63);
  a63=(a50*a06);
  a62=(a62+a63);
  a62=(a16+a62);
  a63=cos(a62);
  a64=(a48*a63);
  a65=sin(a62);
  a66=(a59*a65);
  a64=(a64+a66);
  a66=(a64*a20);
  a66=(a66*a08);
  a67=(2.*a22);
  a25=(a25*a27);
  a56=(a56*a53);
  a25=(a25+a56);
  a44=(a44*a45);
  a25=(a25+a44);
  a50=(a50*a49);
  a25=(a25+a50);
  a25=(a23+a25);
  a50=(a67*a25);
  a50=(a50-a57);
  a44=casadi_sq(a25);
  a50=(a50-a44);
  a66=(a66*a50);
  a62=(a62-a29);
  a62=(a62+a26);
  a29=cos(a62);
  a29=(a29*a20);
  a66=(a66-a29);
  a44=(a48*a20);
  a44=(a44*a22);
  a44=(a44*a22);
  a44=(a44*a08);
  a66=(a66-a44);
  a44=(a48*a28);
  a56=(a59*a30);
  a44=(a44+a56);
  a44=(a44*a20);
  a66=(a66-a44);
  a44=(a63*a20);
  a56=(a44*a25);
  a67=(a67-a25);
  a56=(a56*a67);
  a66=(a66+a56);
  a56=(a14*a25);
  a56=(a56*a65);
  a56=(a56*a67);
  a66=(a66-a56);
  a56=(a59*a63);
  a67=(a48*a65);
  a56=(a56-a67);
  a67=(a31*a56);
  a67=(a67*a50);
  a66=(a66+a67);
  a62=sin(a62);
  a62=(a14*a62);
  a66=(a66+a62);
  a66=(a12*a66);
  a61=(a61+a66);
  a61=(a61-a21);
  a66=(a59*a28);
  a67=(a48*a30);
  a66=(a66-a67);
  a66=(a66*a13);
  a61=(a61+a66);
  a66=(2.*a48);
  a66=(a66*a08);
  a67=(a11*a66);
  a67=(a24+a67);
  a67=(a67+a11);
  a67=(a67+a36);
  a59=(a37*a59);
  a48=(a48*a14);
  a48=(a48*a08);
  a59=(a59-a48);
  a63=(a63*a14);
  a59=(a59-a63);
  a59=(a59-a14);
  a48=(a20*a65);
  a59=(a59-a48);
  a59=(a59+a38);
  a59=(a59+a66);
  a56=(a37*a56);
  a59=(a59+a56);
  a64=(a64*a14);
  a64=(a64*a08);
  a59=(a59-a64);
  a59=(a59+a40);
  a59=(a59+a41);
  a59=(a32*a59);
  a67=(a67+a59);
  a59=(a61/a67);
  a63=(a63-a33);
  a63=(a63-a39);
  a63=(a63+a48);
  a63=(a63-a56);
  a63=(a63+a64);
  a63=(a12*a63);
  a63=(a63-a35);
  a67=(a63/a67);
  a29=(a29-a62);
  a65=(a14*a65);
  a65=(a65-a44);
  a57=(a57*a65);
  a29=(a29+a57);
  a29=(a12*a29);
  a61=(a67*a61);
  a29=(a29-a61);
  a63=(a63*a67);
  a63=(a09-a63);
  a29=(a29/a63);
  a67=(a67*a29);
  a59=(a59-a67);
  a67=(a42*a59);
  a55=(a55+a67);
  a55=(a03+a55);
  a67=(a60*a55);
  a04=(a04+a67);
  a67=3.1116436695781990e-01;
  a67=(a67*a02);
  a63=6.2411095871607569e-01;
  a63=(a63*a02);
  a61=(a63*a10);
  a57=-3.3608926294469414e+00;
  a57=(a57*a02);
  a65=(a57*a46);
  a61=(a61+a65);
  a65=-8.6821934684172597e-01;
  a65=(a65*a02);
  a44=(a65*a18);
  a61=(a61+a44);
  a44=2.7592099699446710e+01;
  a44=(a44*a02);
  a62=(a44*a51);
  a61=(a61+a62);
  a62=2.0154067550477894e+01;
  a62=(a62*a02);
  a64=(a62*a59);
  a61=(a61+a64);
  a64=-4.3489884181069961e+01;
  a64=(a64*a02);
  a56=casadi_sq(a55);
  a48=(a56*a08);
  a66=(a54*a03);
  a50=(a47*a19);
  a66=(a66+a50);
  a50=(a58*a15);
  a66=(a66+a50);
  a50=(a17*a34);
  a66=(a66+a50);
  a50=(a42*a22);
  a66=(a66+a50);
  a66=(a00+a66);
  a50=sin(a66);
  a48=(a48*a50);
  a48=(a48*a13);
  a68=cos(a66);
  a69=(a54*a23);
  a70=(a47*a07);
  a69=(a69+a70);
  a70=(a58*a43);
  a69=(a69+a70);
  a70=(a17*a06);
  a69=(a69+a70);
  a70=(a42*a25);
  a69=(a69+a70);
  a69=(a16+a69);
  a70=cos(a69);
  a71=(a68*a70);
  a72=sin(a69);
  a73=(a50*a72);
  a71=(a71+a73);
  a73=(a71*a20);
  a73=(a73*a08);
  a74=(2.*a55);
  a54=(a54*a27);
  a47=(a47*a53);
  a54=(a54+a47);
  a58=(a58*a45);
  a54=(a54+a58);
  a17=(a17*a49);
  a54=(a54+a17);
  a42=(a42*a29);
  a54=(a54+a42);
  a54=(a23+a54);
  a42=(a74*a54);
  a42=(a42-a56);
  a17=casadi_sq(a54);
  a42=(a42-a17);
  a73=(a73*a42);
  a69=(a69-a66);
  a69=(a69+a26);
  a66=cos(a69);
  a66=(a66*a20);
  a73=(a73-a66);
  a17=(a68*a20);
  a17=(a17*a55);
  a17=(a17*a55);
  a17=(a17*a08);
  a73=(a73-a17);
  a17=(a68*a28);
  a58=(a50*a30);
  a17=(a17+a58);
  a17=(a17*a20);
  a73=(a73-a17);
  a17=(a70*a20);
  a58=(a17*a54);
  a74=(a74-a54);
  a58=(a58*a74);
  a73=(a73+a58);
  a58=(a14*a54);
  a58=(a58*a72);
  a58=(a58*a74);
  a73=(a73-a58);
  a58=(a50*a70);
  a74=(a68*a72);
  a58=(a58-a74);
  a74=(a31*a58);
  a74=(a74*a42);
  a73=(a73+a74);
  a69=sin(a69);
  a69=(a14*a69);
  a73=(a73+a69);
  a73=(a12*a73);
  a48=(a48+a73);
  a48=(a48-a21);
  a73=(a50*a28);
  a74=(a68*a30);
  a73=(a73-a74);
  a73=(a73*a13);
  a48=(a48+a73);
  a73=(2.*a68);
  a73=(a73*a08);
  a74=(a11*a73);
  a74=(a24+a74);
  a74=(a74+a11);
  a74=(a74+a36);
  a50=(a37*a50);
  a68=(a68*a14);
  a68=(a68*a08);
  a50=(a50-a68);
  a70=(a70*a14);
  a50=(a50-a70);
  a50=(a50-a14);
  a68=(a20*a72);
  a50=(a50-a68);
  a50=(a50+a38);
  a50=(a50+a73);
  a58=(a37*a58);
  a50=(a50+a58);
  a71=(a71*a14);
  a71=(a71*a08);
  a50=(a50-a71);
  a50=(a50+a40);
  a50=(a50+a41);
  a50=(a32*a50);
  a74=(a74+a50);
  a50=(a48/a74);
  a70=(a70-a33);
  a70=(a70-a39);
  a70=(a70+a68);
  a70=(a70-a58);
  a70=(a70+a71);
  a70=(a12*a70);
  a70=(a70-a35);
  a74=(a70/a74);
  a66=(a66-a69);
  a72=(a14*a72);
  a72=(a72-a17);
  a56=(a56*a72);
  a66=(a66+a56);
  a66=(a12*a66);
  a48=(a74*a48);
  a66=(a66-a48);
  a70=(a70*a74);
  a70=(a09-a70);
  a66=(a66/a70);
  a74=(a74*a66);
  a50=(a50-a74);
  a74=(a64*a50);
  a61=(a61+a74);
  a61=(a03+a61);
  a74=(a67*a61);
  a04=(a04+a74);
  a74=-1.5216094966251609e-01;
  a74=(a74*a02);
  a70=4.7766253643826434e-01;
  a70=(a70*a02);
  a48=(a70*a10);
  a56=-2.4881146199716677e+00;
  a56=(a56*a02);
  a72=(a56*a46);
  a48=(a48+a72);
  a72=-5.9029082683684297e-01;
  a72=(a72*a02);
  a17=(a72*a18);
  a48=(a48+a17);
  a17=2.1230051448181193e+01;
  a17=(a17*a02);
  a69=(a17*a51);
  a48=(a48+a69);
  a69=1.5279233632882423e+01;
  a69=(a69*a02);
  a71=(a69*a59);
  a48=(a48+a71);
  a71=-3.3288210968984863e+01;
  a71=(a71*a02);
  a58=(a71*a50);
  a48=(a48+a58);
  a58=-2.0331201708508627e-02;
  a58=(a58*a02);
  a68=casadi_sq(a61);
  a73=(a68*a08);
  a42=(a63*a03);
  a47=(a57*a19);
  a42=(a42+a47);
  a47=(a65*a15);
  a42=(a42+a47);
  a47=(a44*a34);
  a42=(a42+a47);
  a47=(a62*a22);
  a42=(a42+a47);
  a47=(a64*a55);
  a42=(a42+a47);
  a42=(a00+a42);
  a47=sin(a42);
  a73=(a73*a47);
  a73=(a73*a13);
  a75=cos(a42);
  a76=(a63*a23);
  a77=(a57*a07);
  a76=(a76+a77);
  a77=(a65*a43);
  a76=(a76+a77);
  a77=(a44*a06);
  a76=(a76+a77);
  a77=(a62*a25);
  a76=(a76+a77);
  a77=(a64*a54);
  a76=(a76+a77);
  a76=(a16+a76);
  a77=cos(a76);
  a78=(a75*a77);
  a79=sin(a76);
  a80=(a47*a79);
  a78=(a78+a80);
  a80=(a78*a20);
  a80=(a80*a08);
  a81=(2.*a61);
  a63=(a63*a27);
  a57=(a57*a53);
  a63=(a63+a57);
  a65=(a65*a45);
  a63=(a63+a65);
  a44=(a44*a49);
  a63=(a63+a44);
  a62=(a62*a29);
  a63=(a63+a62);
  a64=(a64*a66);
  a63=(a63+a64);
  a63=(a23+a63);
  a64=(a81*a63);
  a64=(a64-a68);
  a62=casadi_sq(a63);
  a64=(a64-a62);
  a80=(a80*a64);
  a76=(a76-a42);
  a76=(a76+a26);
  a42=cos(a76);
  a42=(a42*a20);
  a80=(a80-a42);
  a62=(a75*a20);
  a62=(a62*a61);
  a62=(a62*a61);
  a62=(a62*a08);
  a80=(a80-a62);
  a62=(a75*a28);
  a44=(a47*a30);
  a62=(a62+a44);
  a62=(a62*a20);
  a80=(a80-a62);
  a62=(a77*a20);
  a44=(a62*a63);
  a81=(a81-a63);
  a44=(a44*a81);
  a80=(a80+a44);
  a44=(a14*a63);
  a44=(a44*a79);
  a44=(a44*a81);
  a80=(a80-a44);
  a44=(a47*a77);
  a81=(a75*a79);
  a44=(a44-a81);
  a81=(a31*a44);
  a81=(a81*a64);
  a80=(a80+a81);
  a76=sin(a76);
  a76=(a14*a76);
  a80=(a80+a76);
  a80=(a12*a80);
  a73=(a73+a80);
  a73=(a73-a21);
  a80=(a47*a28);
  a81=(a75*a30);
  a80=(a80-a81);
  a80=(a80*a13);
  a73=(a73+a80);
  a80=(2.*a75);
  a80=(a80*a08);
  a81=(a11*a80);
  a81=(a24+a81);
  a81=(a81+a11);
  a81=(a81+a36);
  a47=(a37*a47);
  a75=(a75*a14);
  a75=(a75*a08);
  a47=(a47-a75);
  a77=(a77*a14);
  a47=(a47-a77);
  a47=(a47-a14);
  a75=(a20*a79);
  a47=(a47-a75);
  a47=(a47+a38);
  a47=(a47+a80);
  a44=(a37*a44);
  a47=(a47+a44);
  a78=(a78*a14);
  a78=(a78*a08);
  a47=(a47-a78);
  a47=(a47+a40);
  a47=(a47+a41);
  a47=(a32*a47);
  a81=(a81+a47);
  a47=(a73/a81);
  a77=(a77-a33);
  a77=(a77-a39);
  a77=(a77+a75);
  a77=(a77-a44);
  a77=(a77+a78);
  a77=(a12*a77);
  a77=(a77-a35);
  a81=(a77/a81);
  a42=(a42-a76);
  a79=(a14*a79);
  a79=(a79-a62);
  a68=(a68*a79);
  a42=(a42+a68);
  a42=(a12*a42);
  a73=(a81*a73);
  a42=(a42-a73);
  a77=(a77*a81);
  a77=(a09-a77);
  a42=(a42/a77);
  a81=(a81*a42);
  a47=(a47-a81);
  a81=(a58*a47);
  a48=(a48+a81);
  a48=(a03+a48);
  a81=(a74*a48);
  a04=(a04+a81);
  a81=2.0136540080403034e-01;
  a81=(a81*a02);
  a77=-9.3714243008598730e-01;
  a77=(a77*a02);
  a73=(a77*a10);
  a68=5.1863724288440638e+00;
  a68=(a68*a02);
  a79=(a68*a46);
  a73=(a73+a79);
  a79=1.0914373489967295e+00;
  a79=(a79*a02);
  a62=(a79*a18);
  a73=(a73+a62);
  a62=-8.1497870107469268e+00;
  a62=(a62*a02);
  a76=(a62*a51);
  a73=(a73+a76);
  a76=-1.8520065659996959e+01;
  a76=(a76*a02);
  a78=(a76*a59);
  a73=(a73+a78);
  a78=2.2739487099350505e+01;
  a78=(a78*a02);
  a44=(a78*a50);
  a73=(a73+a44);
  a44=2.4936055526796523e+00;
  a44=(a44*a02);
  a75=(a44*a47);
  a73=(a73+a75);
  a75=-3.0467644718982196e+00;
  a75=(a75*a02);
  a80=casadi_sq(a48);
  a64=(a80*a08);
  a65=(a70*a03);
  a57=(a56*a19);
  a65=(a65+a57);
  a57=(a72*a15);
  a65=(a65+a57);
  a57=(a17*a34);
  a65=(a65+a57);
  a57=(a69*a22);
  a65=(a65+a57);
  a57=(a71*a55);
  a65=(a65+a57);
  a57=(a58*a61);
  a65=(a65+a57);
  a65=(a00+a65);
  a57=sin(a65);
  a64=(a64*a57);
  a64=(a64*a13);
  a82=cos(a65);
  a83=(a70*a23);
  a84=(a56*a07);
  a83=(a83+a84);
  a84=(a72*a43);
  a83=(a83+a84);
  a84=(a17*a06);
  a83=(a83+a84);
  a84=(a69*a25);
  a83=(a83+a84);
  a84=(a71*a54);
  a83=(a83+a84);
  a84=(a58*a63);
  a83=(a83+a84);
  a83=(a16+a83);
  a84=cos(a83);
  a85=(a82*a84);
  a86=sin(a83);
  a87=(a57*a86);
  a85=(a85+a87);
  a87=(a85*a20);
  a87=(a87*a08);
  a88=(2.*a48);
  a70=(a70*a27);
  a56=(a56*a53);
  a70=(a70+a56);
  a72=(a72*a45);
  a70=(a70+a72);
  a17=(a17*a49);
  a70=(a70+a17);
  a69=(a69*a29);
  a70=(a70+a69);
  a71=(a71*a66);
  a70=(a70+a71);
  a58=(a58*a42);
  a70=(a70+a58);
  a70=(a23+a70);
  a58=(a88*a70);
  a58=(a58-a80);
  a71=casadi_sq(a70);
  a58=(a58-a71);
  a87=(a87*a58);
  a83=(a83-a65);
  a83=(a83+a26);
  a65=cos(a83);
  a65=(a65*a20);
  a87=(a87-a65);
  a71=(a82*a20);
  a71=(a71*a48);
  a71=(a71*a48);
  a71=(a71*a08);
  a87=(a87-a71);
  a71=(a82*a28);
  a69=(a57*a30);
  a71=(a71+a69);
  a71=(a71*a20);
  a87=(a87-a71);
  a71=(a84*a20);
  a69=(a71*a70);
  a88=(a88-a70);
  a69=(a69*a88);
  a87=(a87+a69);
  a69=(a14*a70);
  a69=(a69*a86);
  a69=(a69*a88);
  a87=(a87-a69);
  a69=(a57*a84);
  a88=(a82*a86);
  a69=(a69-a88);
  a88=(a31*a69);
  a88=(a88*a58);
  a87=(a87+a88);
  a83=sin(a83);
  a83=(a14*a83);
  a87=(a87+a83);
  a87=(a12*a87);
  a64=(a64+a87);
  a64=(a64-a21);
  a87=(a57*a28);
  a88=(a82*a30);
  a87=(a87-a88);
  a87=(a87*a13);
  a64=(a64+a87);
  a87=(2.*a82);
  a87=(a87*a08);
  a88=(a11*a87);
  a88=(a24+a88);
  a88=(a88+a11);
  a88=(a88+a36);
  a57=(a37*a57);
  a82=(a82*a14);
  a82=(a82*a08);
  a57=(a57-a82);
  a84=(a84*a14);
  a57=(a57-a84);
  a57=(a57-a14);
  a82=(a20*a86);
  a57=(a57-a82);
  a57=(a57+a38);
  a57=(a57+a87);
  a69=(a37*a69);
  a57=(a57+a69);
  a85=(a85*a14);
  a85=(a85*a08);
  a57=(a57-a85);
  a57=(a57+a40);
  a57=(a57+a41);
  a57=(a32*a57);
  a88=(a88+a57);
  a57=(a64/a88);
  a84=(a84-a33);
  a84=(a84-a39);
  a84=(a84+a82);
  a84=(a84-a69);
  a84=(a84+a85);
  a84=(a12*a84);
  a84=(a84-a35);
  a88=(a84/a88);
  a65=(a65-a83);
  a86=(a14*a86);
  a86=(a86-a71);
  a80=(a80*a86);
  a65=(a65+a80);
  a65=(a12*a65);
  a64=(a88*a64);
  a65=(a65-a64);
  a84=(a84*a88);
  a84=(a09-a84);
  a65=(a65/a84);
  a88=(a88*a65);
  a57=(a57-a88);
  a88=(a75*a57);
  a73=(a73+a88);
  a73=(a03+a73);
  a88=(a81*a73);
  a04=(a04+a88);
  a88=4.4710615727772587e-02;
  a88=(a88*a02);
  a84=2.2733101475165380e+00;
  a84=(a84*a02);
  a64=(a84*a10);
  a80=-1.0534495466737249e+01;
  a80=(a80*a02);
  a46=(a80*a46);
  a64=(a64+a46);
  a46=-2.0008720582248625e+00;
  a46=(a46*a02);
  a18=(a46*a18);
  a64=(a64+a18);
  a18=-1.7958931863118799e+01;
  a18=(a18*a02);
  a86=(a18*a51);
  a64=(a64+a86);
  a86=2.7948884529419960e+01;
  a86=(a86*a02);
  a71=(a86*a59);
  a64=(a64+a71);
  a71=-2.8589982771350235e+00;
  a71=(a71*a02);
  a83=(a71*a50);
  a64=(a64+a83);
  a83=-8.8728569335306293e+00;
  a83=(a83*a02);
  a85=(a83*a47);
  a64=(a64+a85);
  a85=1.2360567175794303e+01;
  a85=(a85*a02);
  a69=(a85*a57);
  a64=(a64+a69);
  a69=6.4339274601576357e-01;
  a69=(a69*a02);
  a02=casadi_sq(a73);
  a82=(a02*a08);
  a87=(a77*a03);
  a58=(a68*a19);
  a87=(a87+a58);
  a58=(a79*a15);
  a87=(a87+a58);
  a58=(a62*a34);
  a87=(a87+a58);
  a58=(a76*a22);
  a87=(a87+a58);
  a58=(a78*a55);
  a87=(a87+a58);
  a58=(a44*a61);
  a87=(a87+a58);
  a58=(a75*a48);
  a87=(a87+a58);
  a87=(a00+a87);
  a58=sin(a87);
  a82=(a82*a58);
  a82=(a82*a13);
  a17=cos(a87);
  a72=(a77*a23);
  a56=(a68*a07);
  a72=(a72+a56);
  a56=(a79*a43);
  a72=(a72+a56);
  a56=(a62*a06);
  a72=(a72+a56);
  a56=(a76*a25);
  a72=(a72+a56);
  a56=(a78*a54);
  a72=(a72+a56);
  a56=(a44*a63);
  a72=(a72+a56);
  a56=(a75*a70);
  a72=(a72+a56);
  a72=(a16+a72);
  a56=cos(a72);
  a89=(a17*a56);
  a90=sin(a72);
  a91=(a58*a90);
  a89=(a89+a91);
  a91=(a89*a20);
  a91=(a91*a08);
  a92=(2.*a73);
  a77=(a77*a27);
  a68=(a68*a53);
  a77=(a77+a68);
  a79=(a79*a45);
  a77=(a77+a79);
  a62=(a62*a49);
  a77=(a77+a62);
  a76=(a76*a29);
  a77=(a77+a76);
  a78=(a78*a66);
  a77=(a77+a78);
  a44=(a44*a42);
  a77=(a77+a44);
  a75=(a75*a65);
  a77=(a77+a75);
  a77=(a23+a77);
  a75=(a92*a77);
  a75=(a75-a02);
  a44=casadi_sq(a77);
  a75=(a75-a44);
  a91=(a91*a75);
  a72=(a72-a87);
  a72=(a72+a26);
  a87=cos(a72);
  a87=(a87*a20);
  a91=(a91-a87);
  a44=(a17*a20);
  a44=(a44*a73);
  a44=(a44*a73);
  a44=(a44*a08);
  a91=(a91-a44);
  a44=(a17*a28);
  a78=(a58*a30);
  a44=(a44+a78);
  a44=(a44*a20);
  a91=(a91-a44);
  a44=(a56*a20);
  a78=(a44*a77);
  a92=(a92-a77);
  a78=(a78*a92);
  a91=(a91+a78);
  a78=(a14*a77);
  a78=(a78*a90);
  a78=(a78*a92);
  a91=(a91-a78);
  a78=(a58*a56);
  a92=(a17*a90);
  a78=(a78-a92);
  a92=(a31*a78);
  a92=(a92*a75);
  a91=(a91+a92);
  a72=sin(a72);
  a72=(a14*a72);
  a91=(a91+a72);
  a91=(a12*a91);
  a82=(a82+a91);
  a82=(a82-a21);
  a91=(a58*a28);
  a92=(a17*a30);
  a91=(a91-a92);
  a91=(a91*a13);
  a82=(a82+a91);
  a91=(2.*a17);
  a91=(a91*a08);
  a92=(a11*a91);
  a92=(a24+a92);
  a92=(a92+a11);
  a92=(a92+a36);
  a58=(a37*a58);
  a17=(a17*a14);
  a17=(a17*a08);
  a58=(a58-a17);
  a56=(a56*a14);
  a58=(a58-a56);
  a58=(a58-a14);
  a17=(a20*a90);
  a58=(a58-a17);
  a58=(a58+a38);
  a58=(a58+a91);
  a78=(a37*a78);
  a58=(a58+a78);
  a89=(a89*a14);
  a89=(a89*a08);
  a58=(a58-a89);
  a58=(a58+a40);
  a58=(a58+a41);
  a58=(a32*a58);
  a92=(a92+a58);
  a58=(a82/a92);
  a56=(a56-a33);
  a56=(a56-a39);
  a56=(a56+a17);
  a56=(a56-a78);
  a56=(a56+a89);
  a56=(a12*a56);
  a56=(a56-a35);
  a92=(a56/a92);
  a87=(a87-a72);
  a90=(a14*a90);
  a90=(a90-a44);
  a02=(a02*a90);
  a87=(a87+a02);
  a87=(a12*a87);
  a82=(a92*a82);
  a87=(a87-a82);
  a56=(a56*a92);
  a56=(a09-a56);
  a87=(a87/a56);
  a92=(a92*a87);
  a58=(a58-a92);
  a92=(a69*a58);
  a64=(a64+a92);
  a64=(a03+a64);
  a92=(a88*a64);
  a04=(a04+a92);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a23);
  a92=(a05*a06);
  a04=(a04+a92);
  a92=(a52*a25);
  a04=(a04+a92);
  a92=(a60*a54);
  a04=(a04+a92);
  a92=(a67*a63);
  a04=(a04+a92);
  a92=(a74*a70);
  a04=(a04+a92);
  a92=(a81*a77);
  a04=(a04+a92);
  a92=(a84*a27);
  a53=(a80*a53);
  a92=(a92+a53);
  a45=(a46*a45);
  a92=(a92+a45);
  a45=(a18*a49);
  a92=(a92+a45);
  a45=(a86*a29);
  a92=(a92+a45);
  a45=(a71*a66);
  a92=(a92+a45);
  a45=(a83*a42);
  a92=(a92+a45);
  a45=(a85*a65);
  a92=(a92+a45);
  a45=(a69*a87);
  a92=(a92+a45);
  a92=(a23+a92);
  a45=(a88*a92);
  a04=(a04+a45);
  a04=(a16+a04);
  if (res[0]!=0) res[0][1]=a04;
  a10=(a01*a10);
  a51=(a05*a51);
  a10=(a10+a51);
  a59=(a52*a59);
  a10=(a10+a59);
  a50=(a60*a50);
  a10=(a10+a50);
  a47=(a67*a47);
  a10=(a10+a47);
  a57=(a74*a57);
  a10=(a10+a57);
  a58=(a81*a58);
  a10=(a10+a58);
  a58=casadi_sq(a64);
  a57=(a58*a08);
  a47=(a84*a03);
  a19=(a80*a19);
  a47=(a47+a19);
  a15=(a46*a15);
  a47=(a47+a15);
  a34=(a18*a34);
  a47=(a47+a34);
  a22=(a86*a22);
  a47=(a47+a22);
  a55=(a71*a55);
  a47=(a47+a55);
  a61=(a83*a61);
  a47=(a47+a61);
  a48=(a85*a48);
  a47=(a47+a48);
  a73=(a69*a73);
  a47=(a47+a73);
  a00=(a00+a47);
  a47=sin(a00);
  a57=(a57*a47);
  a57=(a57*a13);
  a73=cos(a00);
  a84=(a84*a23);
  a80=(a80*a07);
  a84=(a84+a80);
  a46=(a46*a43);
  a84=(a84+a46);
  a18=(a18*a06);
  a84=(a84+a18);
  a86=(a86*a25);
  a84=(a84+a86);
  a71=(a71*a54);
  a84=(a84+a71);
  a83=(a83*a63);
  a84=(a84+a83);
  a85=(a85*a70);
  a84=(a84+a85);
  a69=(a69*a77);
  a84=(a84+a69);
  a16=(a16+a84);
  a84=cos(a16);
  a69=(a73*a84);
  a77=sin(a16);
  a85=(a47*a77);
  a69=(a69+a85);
  a85=(a69*a20);
  a85=(a85*a08);
  a70=(2.*a64);
  a83=(a70*a92);
  a83=(a83-a58);
  a63=casadi_sq(a92);
  a83=(a83-a63);
  a85=(a85*a83);
  a16=(a16-a00);
  a16=(a16+a26);
  a26=cos(a16);
  a26=(a26*a20);
  a85=(a85-a26);
  a00=(a73*a20);
  a00=(a00*a64);
  a00=(a00*a64);
  a00=(a00*a08);
  a85=(a85-a00);
  a00=(a73*a28);
  a64=(a47*a30);
  a00=(a00+a64);
  a00=(a00*a20);
  a85=(a85-a00);
  a00=(a84*a20);
  a64=(a00*a92);
  a70=(a70-a92);
  a64=(a64*a70);
  a85=(a85+a64);
  a92=(a14*a92);
  a92=(a92*a77);
  a92=(a92*a70);
  a85=(a85-a92);
  a92=(a47*a84);
  a70=(a73*a77);
  a92=(a92-a70);
  a31=(a31*a92);
  a31=(a31*a83);
  a85=(a85+a31);
  a16=sin(a16);
  a16=(a14*a16);
  a85=(a85+a16);
  a85=(a12*a85);
  a57=(a57+a85);
  a57=(a57-a21);
  a28=(a47*a28);
  a30=(a73*a30);
  a28=(a28-a30);
  a28=(a28*a13);
  a57=(a57+a28);
  a28=(2.*a73);
  a28=(a28*a08);
  a13=(a11*a28);
  a24=(a24+a13);
  a24=(a24+a11);
  a24=(a24+a36);
  a47=(a37*a47);
  a73=(a73*a14);
  a73=(a73*a08);
  a47=(a47-a73);
  a84=(a84*a14);
  a47=(a47-a84);
  a47=(a47-a14);
  a20=(a20*a77);
  a47=(a47-a20);
  a47=(a47+a38);
  a47=(a47+a28);
  a37=(a37*a92);
  a47=(a47+a37);
  a69=(a69*a14);
  a69=(a69*a08);
  a47=(a47-a69);
  a47=(a47+a40);
  a47=(a47+a41);
  a32=(a32*a47);
  a24=(a24+a32);
  a32=(a57/a24);
  a84=(a84-a33);
  a84=(a84-a39);
  a84=(a84+a20);
  a84=(a84-a37);
  a84=(a84+a69);
  a84=(a12*a84);
  a84=(a84-a35);
  a24=(a84/a24);
  a26=(a26-a16);
  a14=(a14*a77);
  a14=(a14-a00);
  a58=(a58*a14);
  a26=(a26+a58);
  a12=(a12*a26);
  a57=(a24*a57);
  a12=(a12-a57);
  a84=(a84*a24);
  a09=(a09-a84);
  a12=(a12/a09);
  a24=(a24*a12);
  a32=(a32-a24);
  a32=(a88*a32);
  a10=(a10+a32);
  a03=(a03+a10);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a27);
  a05=(a05*a49);
  a01=(a01+a05);
  a52=(a52*a29);
  a01=(a01+a52);
  a60=(a60*a66);
  a01=(a01+a60);
  a67=(a67*a42);
  a01=(a01+a67);
  a74=(a74*a65);
  a01=(a01+a74);
  a81=(a81*a87);
  a01=(a01+a81);
  a88=(a88*a12);
  a01=(a01+a88);
  a23=(a23+a01);
  if (res[0]!=0) res[0][3]=a23;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+93, w1, *w2=w+97, *w3=w+104, w5, *w6=w+106, w7;
  const casadi_real **arg1=arg+5, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 7, w2);
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

/* landing:(y[4],z[3],p[7])->(R[4]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00-a01);
  a03=arg[1]? arg[1][0] : 0;
  a03=(a02-a03);
  if (res[0]!=0) res[0][0]=a03;
  a03=cos(a00);
  a04=arg[2]? arg[2][5] : 0;
  a05=(a03*a04);
  a06=arg[0]? arg[0][2] : 0;
  a07=arg[2]? arg[2][0] : 0;
  a08=arg[2]? arg[2][1] : 0;
  a09=2.;
  a10=arg[2]? arg[2][3] : 0;
  a11=(2.*a10);
  a09=(a09-a11);
  a09=(a08*a09);
  a09=(a07+a09);
  a09=(a06*a09);
  a05=(a05*a09);
  a12=cos(a02);
  a13=(a12*a04);
  a14=(a06*a07);
  a15=(2.*a06);
  a16=arg[0]? arg[0][3] : 0;
  a17=(a10*a16);
  a18=(a11*a06);
  a17=(a17-a18);
  a18=(a15+a17);
  a18=(a08*a18);
  a14=(a14+a18);
  a13=(a13*a14);
  a05=(a05+a13);
  a13=cos(a01);
  a09=(a13*a09);
  a05=(a05+a09);
  a09=arg[2]? arg[2][2] : 0;
  a14=(a15*a09);
  a05=(a05+a14);
  a14=(a07*a04);
  a14=(a14*a04);
  a18=(a06*a14);
  a05=(a05+a18);
  a18=(a16*a09);
  a05=(a05-a18);
  a11=(a11*a10);
  a11=(a11*a06);
  a18=casadi_sq(a10);
  a19=(a18*a16);
  a11=(a11-a19);
  a19=arg[2]? arg[2][4] : 0;
  a20=(2.*a19);
  a20=(a20*a19);
  a20=(a20*a06);
  a11=(a11+a20);
  a20=casadi_sq(a19);
  a21=(a20*a16);
  a11=(a11-a21);
  a21=(a15*a04);
  a21=(a21*a04);
  a11=(a11+a21);
  a21=(a19*a04);
  a22=sin(a00);
  a22=(a21*a22);
  a23=(a15*a22);
  a11=(a11+a23);
  a11=(a11+a17);
  a02=sin(a02);
  a21=(a21*a02);
  a15=(a15-a16);
  a15=(a21*a15);
  a11=(a11+a15);
  a11=(a08*a11);
  a05=(a05+a11);
  a11=(2.*a12);
  a11=(a11*a04);
  a15=(a07*a11);
  a15=(a15+a07);
  a07=(2.*a09);
  a15=(a15+a07);
  a07=(2.*a08);
  a16=casadi_sq(a04);
  a12=(a12*a10);
  a12=(a12*a04);
  a16=(a16-a12);
  a16=(a16-a10);
  a16=(a16+a11);
  a16=(a16+a21);
  a18=(a18+a20);
  a16=(a16+a18);
  a20=sin(a01);
  a19=(a19*a20);
  a13=(a13*a10);
  a19=(a19-a13);
  a19=(a19+a22);
  a03=(a03*a10);
  a03=(a03*a04);
  a19=(a19-a03);
  a16=(a16+a19);
  a04=1.;
  a16=(a16+a04);
  a07=(a07*a16);
  a15=(a15+a07);
  a15=(a15+a14);
  a14=(a05/a15);
  a19=(a18+a19);
  a19=(a08*a19);
  a19=(a09+a19);
  a15=(a19/a15);
  a10=(a10-a18);
  a10=(a08*a10);
  a10=(a10-a09);
  a10=(a06*a10);
  a03=(a06*a03);
  a06=(a06*a22);
  a03=(a03-a06);
  a03=(a08*a03);
  a10=(a10+a03);
  a05=(a15*a05);
  a10=(a10+a05);
  a08=(a08*a18);
  a09=(a09+a08);
  a19=(a19*a15);
  a09=(a09-a19);
  a10=(a10/a09);
  a15=(a15*a10);
  a14=(a14+a15);
  a15=arg[1]? arg[1][1] : 0;
  a14=(a14-a15);
  if (res[0]!=0) res[0][1]=a14;
  a14=arg[1]? arg[1][2] : 0;
  a10=(a10-a14);
  if (res[0]!=0) res[0][2]=a10;
  a00=(2.*a00);
  a01=(a01-a00);
  if (res[0]!=0) res[0][3]=a01;
  return 0;
}

/* round_feet_residual_12:(u[4],p[7])->(R[4]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* round_feet_search_12:(u0[4],p[7])->(u[4],R[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+798, *w1=w+802, *w2=w+809;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = round_feet_residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 813;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 813*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* scaled_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+672, *w1=w+688, *w2=w+692, *w3=w+699, *w4=w+715;
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
  casadi_copy(arg[1], 7, w2);
  /* #3: {@3, @4} = round_feet_jacobian_24(@1, @2) */
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

/* newton_24:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_24:(i0[4],i1[7])->(o0[4]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+783, *w1=w+787, *w2=w+794;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f17(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_residual_24:(u[4],p[7])->(R[4]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* round_feet_search_24:(u0[4],p[7])->(u[4],R[4]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+798, *w1=w+802, *w2=w+809;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = round_feet_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 813;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 813*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* scaled_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+672, *w1=w+688, *w2=w+692, *w3=w+699, *w4=w+715;
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
  casadi_copy(arg[1], 7, w2);
  /* #3: {@3, @4} = round_feet_jacobian_48(@1, @2) */
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

/* newton_48:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_48:(i0[4],i1[7])->(o0[4]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+783, *w1=w+787, *w2=w+794;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f23(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_residual_48:(u[4],p[7])->(R[4]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* round_feet_search_48:(u0[4],p[7])->(u[4],R[4]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+798, *w1=w+802, *w2=w+809;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = round_feet_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 813;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 813*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_24:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_24:(i0[4],i1[7])->(o0[4]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f29(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_limit_cycle_24:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_24(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_36:(u[4],p[7])->(R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_36:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f37(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_36:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_36:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_36:(i0[4],i1[7])->(o0[4]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_36:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_36:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_36(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_48:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_48:(i0[4],i1[7])->(o0[4]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_limit_cycle_48:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_48(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_72:(u[4],p[7])->(R[4]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_72:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f49(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_72:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_72:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_72:(i0[4],i1[7])->(o0[4]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_72:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_72:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_72(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_96:(u[4],p[7])->(R[4]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_96:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_96:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_96:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_96:(i0[4],i1[7])->(o0[4]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_96:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_96:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f52(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_96(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_144:(u[4],p[7])->(R[4]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_144:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_144:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_144:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_144:(i0[4],i1[7])->(o0[4]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_144:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_144:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f59(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_144(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f58(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_192:(u[4],p[7])->(R[4]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_192:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f57(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f70(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_192:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_192:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_192:(i0[4],i1[7])->(o0[4]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f67(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_192:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_192:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_192(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f65(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_288:(u[4],p[7])->(R[4]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_288:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_288:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_288:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_288:(i0[4],i1[7])->(o0[4]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f74(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_288:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_288:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f73(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_288(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_384:(u[4],p[7])->(R[4]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+137, *w1=w+141, *w2=w+144, *w3=w+151, w4, w5, w6, *w7=w+155;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

/* coarse_jacobian_384:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+672, *w1=w+676, *w2=w+683, *w3=w+699;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: {@2, NULL} = round_feet_jacobian_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f71(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f84(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* scaled_jacobian_384:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+703, *w1=w+719, *w2=w+723, *w3=w+730, *w4=w+746;
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
  casadi_copy(arg[1], 7, w2);
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

/* newton_384:(u0[4],p[7])->(u[4]) */
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

/* scaled_newton_384:(i0[4],i1[7])->(o0[4]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+814, *w1=w+818, *w2=w+825;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f81(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_384:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+583, *w01=w+587, *w02=w+590, *w03=w+597, *w04=w+601, *w05=w+613, w06, w07, w08, *w09=w+629;
  casadi_real *w10=w+653;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
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

/* round_feet_limit_cycle_384:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+829, *w1=w+833, *w2=w+840, *w3=w+844;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = scaled_newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f80(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_384(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f79(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 13;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 860;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 860*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_12_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_24_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_36_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f26(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_48_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f49(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_72_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_96_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f63(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_144_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_192_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f77(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_288_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_residual_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_residual_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_residual_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_residual_384_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_residual_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_residual_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_residual_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_residual_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 179;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 179*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f38(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_36_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f25(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_72_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_96_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f64(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_144_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_192_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f78(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_288_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_384_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 669;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 669*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[4],phase[2],turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92;
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
  a07=casadi_sq(a03);
  a08=arg[4]? arg[4][5] : 0;
  a09=(a07*a08);
  a10=sin(a00);
  a09=(a09*a10);
  a11=arg[4]? arg[4][0] : 0;
  a12=arg[4]? arg[4][1] : 0;
  a13=2.;
  a14=arg[4]? arg[4][3] : 0;
  a13=(a13-a14);
  a13=(a12*a13);
  a13=(a11+a13);
  a09=(a09*a13);
  a15=cos(a00);
  a16=arg[0]? arg[0][1] : 0;
  a17=cos(a16);
  a18=(a15*a17);
  a19=sin(a16);
  a20=(a10*a19);
  a18=(a18+a20);
  a20=arg[4]? arg[4][4] : 0;
  a21=(a18*a20);
  a21=(a21*a08);
  a22=(2.*a03);
  a23=arg[0]? arg[0][3] : 0;
  a24=(a22*a23);
  a24=(a24-a07);
  a25=casadi_sq(a23);
  a24=(a24-a25);
  a21=(a21*a24);
  a25=(a16-a00);
  a26=arg[4]? arg[4][6] : 0;
  a25=(a25+a26);
  a27=cos(a25);
  a27=(a27*a20);
  a21=(a21-a27);
  a28=(a15*a20);
  a28=(a28*a03);
  a28=(a28*a03);
  a28=(a28*a08);
  a21=(a21-a28);
  a28=cos(a26);
  a29=(a15*a28);
  a30=sin(a26);
  a31=(a10*a30);
  a29=(a29+a31);
  a29=(a29*a20);
  a21=(a21-a29);
  a29=(a17*a20);
  a31=(a29*a23);
  a22=(a22-a23);
  a31=(a31*a22);
  a21=(a21+a31);
  a31=(a14*a23);
  a31=(a31*a19);
  a31=(a31*a22);
  a21=(a21-a31);
  a31=(a14*a08);
  a22=(a10*a17);
  a32=(a15*a19);
  a22=(a22-a32);
  a32=(a31*a22);
  a32=(a32*a24);
  a21=(a21+a32);
  a25=sin(a25);
  a25=(a14*a25);
  a21=(a21+a25);
  a21=(a12*a21);
  a09=(a09+a21);
  a21=(a08*a30);
  a32=(2.*a12);
  a24=(a11+a32);
  a21=(a21*a24);
  a09=(a09-a21);
  a24=(a10*a28);
  a33=(a15*a30);
  a24=(a24-a33);
  a24=(a24*a13);
  a09=(a09+a24);
  a24=(a11*a08);
  a24=(a24*a08);
  a33=(2.*a15);
  a33=(a33*a08);
  a34=(a11*a33);
  a34=(a24+a34);
  a34=(a34+a11);
  a35=arg[4]? arg[4][2] : 0;
  a36=(2.*a35);
  a34=(a34+a36);
  a37=(a20*a08);
  a10=(a37*a10);
  a15=(a15*a14);
  a15=(a15*a08);
  a10=(a10-a15);
  a17=(a17*a14);
  a10=(a10-a17);
  a10=(a10-a14);
  a15=(a20*a19);
  a10=(a10-a15);
  a38=casadi_sq(a08);
  a10=(a10+a38);
  a10=(a10+a33);
  a22=(a37*a22);
  a10=(a10+a22);
  a18=(a18*a14);
  a18=(a18*a08);
  a10=(a10-a18);
  a33=casadi_sq(a14);
  a39=casadi_sq(a20);
  a40=(a33+a39);
  a10=(a10+a40);
  a41=1.;
  a10=(a10+a41);
  a10=(a32*a10);
  a34=(a34+a10);
  a10=(a09/a34);
  a17=(a17-a33);
  a17=(a17-a39);
  a17=(a17+a15);
  a17=(a17-a22);
  a17=(a17+a18);
  a17=(a12*a17);
  a17=(a17-a35);
  a34=(a17/a34);
  a27=(a27-a25);
  a19=(a14*a19);
  a19=(a19-a29);
  a07=(a07*a19);
  a27=(a27+a07);
  a27=(a12*a27);
  a09=(a34*a09);
  a27=(a27-a09);
  a09=(a12*a40);
  a09=(a35+a09);
  a17=(a17*a34);
  a17=(a09-a17);
  a27=(a27/a17);
  a34=(a34*a27);
  a10=(a10-a34);
  a34=(a06*a10);
  a17=1.7082860872947386e-01;
  a17=(a17*a02);
  a07=2.9587585476806851e-02;
  a07=(a07*a02);
  a19=(a07*a10);
  a29=8.8762756430420545e-02;
  a29=(a29*a02);
  a25=1.9725056984537900e-02;
  a25=(a25*a02);
  a18=(a25*a10);
  a22=5.9175170953613701e-02;
  a22=(a22*a02);
  a15=5.2600151958767730e-02;
  a15=(a15*a02);
  a42=(a15*a10);
  a42=(a03+a42);
  a43=casadi_sq(a42);
  a44=(a43*a08);
  a45=(a15*a03);
  a45=(a00+a45);
  a46=sin(a45);
  a44=(a44*a46);
  a44=(a44*a13);
  a47=cos(a45);
  a48=(a15*a23);
  a48=(a16+a48);
  a49=cos(a48);
  a50=(a47*a49);
  a51=sin(a48);
  a52=(a46*a51);
  a50=(a50+a52);
  a52=(a50*a20);
  a52=(a52*a08);
  a53=(2.*a42);
  a15=(a15*a27);
  a15=(a23+a15);
  a54=(a53*a15);
  a54=(a54-a43);
  a55=casadi_sq(a15);
  a54=(a54-a55);
  a52=(a52*a54);
  a48=(a48-a45);
  a48=(a48+a26);
  a45=cos(a48);
  a45=(a45*a20);
  a52=(a52-a45);
  a55=(a47*a20);
  a55=(a55*a42);
  a55=(a55*a42);
  a55=(a55*a08);
  a52=(a52-a55);
  a55=(a47*a28);
  a56=(a46*a30);
  a55=(a55+a56);
  a55=(a55*a20);
  a52=(a52-a55);
  a55=(a49*a20);
  a56=(a55*a15);
  a53=(a53-a15);
  a56=(a56*a53);
  a52=(a52+a56);
  a56=(a14*a15);
  a56=(a56*a51);
  a56=(a56*a53);
  a52=(a52-a56);
  a56=(a46*a49);
  a53=(a47*a51);
  a56=(a56-a53);
  a53=(a31*a56);
  a53=(a53*a54);
  a52=(a52+a53);
  a48=sin(a48);
  a48=(a14*a48);
  a52=(a52+a48);
  a52=(a12*a52);
  a44=(a44+a52);
  a44=(a44-a21);
  a52=(a46*a28);
  a53=(a47*a30);
  a52=(a52-a53);
  a52=(a52*a13);
  a44=(a44+a52);
  a52=(2.*a47);
  a52=(a52*a08);
  a53=(a11*a52);
  a53=(a24+a53);
  a53=(a53+a11);
  a53=(a53+a36);
  a46=(a37*a46);
  a47=(a47*a14);
  a47=(a47*a08);
  a46=(a46-a47);
  a49=(a49*a14);
  a46=(a46-a49);
  a46=(a46-a14);
  a47=(a20*a51);
  a46=(a46-a47);
  a46=(a46+a38);
  a46=(a46+a52);
  a56=(a37*a56);
  a46=(a46+a56);
  a50=(a50*a14);
  a50=(a50*a08);
  a46=(a46-a50);
  a46=(a46+a40);
  a46=(a46+a41);
  a46=(a32*a46);
  a53=(a53+a46);
  a46=(a44/a53);
  a49=(a49-a33);
  a49=(a49-a39);
  a49=(a49+a47);
  a49=(a49-a56);
  a49=(a49+a50);
  a49=(a12*a49);
  a49=(a49-a35);
  a53=(a49/a53);
  a45=(a45-a48);
  a51=(a14*a51);
  a51=(a51-a55);
  a43=(a43*a51);
  a45=(a45+a43);
  a45=(a12*a45);
  a44=(a53*a44);
  a45=(a45-a44);
  a49=(a49*a53);
  a49=(a09-a49);
  a45=(a45/a49);
  a53=(a53*a45);
  a46=(a46-a53);
  a46=(a22*a46);
  a18=(a18+a46);
  a18=(a03+a18);
  a46=casadi_sq(a18);
  a53=(a46*a08);
  a49=(a25*a03);
  a42=(a22*a42);
  a49=(a49+a42);
  a49=(a00+a49);
  a42=sin(a49);
  a53=(a53*a42);
  a53=(a53*a13);
  a44=cos(a49);
  a43=(a25*a23);
  a15=(a22*a15);
  a43=(a43+a15);
  a43=(a16+a43);
  a15=cos(a43);
  a51=(a44*a15);
  a55=sin(a43);
  a48=(a42*a55);
  a51=(a51+a48);
  a48=(a51*a20);
  a48=(a48*a08);
  a50=(2.*a18);
  a25=(a25*a27);
  a22=(a22*a45);
  a25=(a25+a22);
  a25=(a23+a25);
  a22=(a50*a25);
  a22=(a22-a46);
  a45=casadi_sq(a25);
  a22=(a22-a45);
  a48=(a48*a22);
  a43=(a43-a49);
  a43=(a43+a26);
  a49=cos(a43);
  a49=(a49*a20);
  a48=(a48-a49);
  a45=(a44*a20);
  a45=(a45*a18);
  a45=(a45*a18);
  a45=(a45*a08);
  a48=(a48-a45);
  a45=(a44*a28);
  a56=(a42*a30);
  a45=(a45+a56);
  a45=(a45*a20);
  a48=(a48-a45);
  a45=(a15*a20);
  a56=(a45*a25);
  a50=(a50-a25);
  a56=(a56*a50);
  a48=(a48+a56);
  a56=(a14*a25);
  a56=(a56*a55);
  a56=(a56*a50);
  a48=(a48-a56);
  a56=(a42*a15);
  a50=(a44*a55);
  a56=(a56-a50);
  a50=(a31*a56);
  a50=(a50*a22);
  a48=(a48+a50);
  a43=sin(a43);
  a43=(a14*a43);
  a48=(a48+a43);
  a48=(a12*a48);
  a53=(a53+a48);
  a53=(a53-a21);
  a48=(a42*a28);
  a50=(a44*a30);
  a48=(a48-a50);
  a48=(a48*a13);
  a53=(a53+a48);
  a48=(2.*a44);
  a48=(a48*a08);
  a50=(a11*a48);
  a50=(a24+a50);
  a50=(a50+a11);
  a50=(a50+a36);
  a42=(a37*a42);
  a44=(a44*a14);
  a44=(a44*a08);
  a42=(a42-a44);
  a15=(a15*a14);
  a42=(a42-a15);
  a42=(a42-a14);
  a44=(a20*a55);
  a42=(a42-a44);
  a42=(a42+a38);
  a42=(a42+a48);
  a56=(a37*a56);
  a42=(a42+a56);
  a51=(a51*a14);
  a51=(a51*a08);
  a42=(a42-a51);
  a42=(a42+a40);
  a42=(a42+a41);
  a42=(a32*a42);
  a50=(a50+a42);
  a42=(a53/a50);
  a15=(a15-a33);
  a15=(a15-a39);
  a15=(a15+a44);
  a15=(a15-a56);
  a15=(a15+a51);
  a15=(a12*a15);
  a15=(a15-a35);
  a50=(a15/a50);
  a49=(a49-a43);
  a55=(a14*a55);
  a55=(a55-a45);
  a46=(a46*a55);
  a49=(a49+a46);
  a49=(a12*a49);
  a53=(a50*a53);
  a49=(a49-a53);
  a15=(a15*a50);
  a15=(a09-a15);
  a49=(a49/a15);
  a50=(a50*a49);
  a42=(a42-a50);
  a50=(a29*a42);
  a19=(a19+a50);
  a19=(a03+a19);
  a50=casadi_sq(a19);
  a15=(a50*a08);
  a53=(a07*a03);
  a46=(a29*a18);
  a53=(a53+a46);
  a53=(a00+a53);
  a46=sin(a53);
  a15=(a15*a46);
  a15=(a15*a13);
  a55=cos(a53);
  a45=(a07*a23);
  a43=(a29*a25);
  a45=(a45+a43);
  a45=(a16+a45);
  a43=cos(a45);
  a51=(a55*a43);
  a56=sin(a45);
  a44=(a46*a56);
  a51=(a51+a44);
  a44=(a51*a20);
  a44=(a44*a08);
  a48=(2.*a19);
  a07=(a07*a27);
  a29=(a29*a49);
  a07=(a07+a29);
  a07=(a23+a07);
  a29=(a48*a07);
  a29=(a29-a50);
  a22=casadi_sq(a07);
  a29=(a29-a22);
  a44=(a44*a29);
  a45=(a45-a53);
  a45=(a45+a26);
  a53=cos(a45);
  a53=(a53*a20);
  a44=(a44-a53);
  a22=(a55*a20);
  a22=(a22*a19);
  a22=(a22*a19);
  a22=(a22*a08);
  a44=(a44-a22);
  a22=(a55*a28);
  a47=(a46*a30);
  a22=(a22+a47);
  a22=(a22*a20);
  a44=(a44-a22);
  a22=(a43*a20);
  a47=(a22*a07);
  a48=(a48-a07);
  a47=(a47*a48);
  a44=(a44+a47);
  a47=(a14*a07);
  a47=(a47*a56);
  a47=(a47*a48);
  a44=(a44-a47);
  a47=(a46*a43);
  a48=(a55*a56);
  a47=(a47-a48);
  a48=(a31*a47);
  a48=(a48*a29);
  a44=(a44+a48);
  a45=sin(a45);
  a45=(a14*a45);
  a44=(a44+a45);
  a44=(a12*a44);
  a15=(a15+a44);
  a15=(a15-a21);
  a44=(a46*a28);
  a48=(a55*a30);
  a44=(a44-a48);
  a44=(a44*a13);
  a15=(a15+a44);
  a44=(2.*a55);
  a44=(a44*a08);
  a48=(a11*a44);
  a48=(a24+a48);
  a48=(a48+a11);
  a48=(a48+a36);
  a46=(a37*a46);
  a55=(a55*a14);
  a55=(a55*a08);
  a46=(a46-a55);
  a43=(a43*a14);
  a46=(a46-a43);
  a46=(a46-a14);
  a55=(a20*a56);
  a46=(a46-a55);
  a46=(a46+a38);
  a46=(a46+a44);
  a47=(a37*a47);
  a46=(a46+a47);
  a51=(a51*a14);
  a51=(a51*a08);
  a46=(a46-a51);
  a46=(a46+a40);
  a46=(a46+a41);
  a46=(a32*a46);
  a48=(a48+a46);
  a46=(a15/a48);
  a43=(a43-a33);
  a43=(a43-a39);
  a43=(a43+a55);
  a43=(a43-a47);
  a43=(a43+a51);
  a43=(a12*a43);
  a43=(a43-a35);
  a48=(a43/a48);
  a53=(a53-a45);
  a56=(a14*a56);
  a56=(a56-a22);
  a50=(a50*a56);
  a53=(a53+a50);
  a53=(a12*a53);
  a15=(a48*a15);
  a53=(a53-a15);
  a43=(a43*a48);
  a43=(a09-a43);
  a53=(a53/a43);
  a48=(a48*a53);
  a46=(a46-a48);
  a48=(a17*a46);
  a34=(a34+a48);
  a48=1.2546768756682242e-01;
  a48=(a48*a02);
  a43=2.4136513415926669e-01;
  a43=(a43*a02);
  a15=(a43*a10);
  a50=-8.8454947932828609e-01;
  a50=(a50*a02);
  a42=(a50*a42);
  a15=(a15+a42);
  a42=9.2483400326179199e-01;
  a42=(a42*a02);
  a56=(a42*a46);
  a15=(a15+a56);
  a15=(a03+a15);
  a56=casadi_sq(a15);
  a22=(a56*a08);
  a45=(a43*a03);
  a18=(a50*a18);
  a45=(a45+a18);
  a18=(a42*a19);
  a45=(a45+a18);
  a45=(a00+a45);
  a18=sin(a45);
  a22=(a22*a18);
  a22=(a22*a13);
  a51=cos(a45);
  a47=(a43*a23);
  a25=(a50*a25);
  a47=(a47+a25);
  a25=(a42*a07);
  a47=(a47+a25);
  a47=(a16+a47);
  a25=cos(a47);
  a55=(a51*a25);
  a44=sin(a47);
  a29=(a18*a44);
  a55=(a55+a29);
  a29=(a55*a20);
  a29=(a29*a08);
  a52=(2.*a15);
  a43=(a43*a27);
  a50=(a50*a49);
  a43=(a43+a50);
  a42=(a42*a53);
  a43=(a43+a42);
  a43=(a23+a43);
  a42=(a52*a43);
  a42=(a42-a56);
  a50=casadi_sq(a43);
  a42=(a42-a50);
  a29=(a29*a42);
  a47=(a47-a45);
  a47=(a47+a26);
  a45=cos(a47);
  a45=(a45*a20);
  a29=(a29-a45);
  a50=(a51*a20);
  a50=(a50*a15);
  a50=(a50*a15);
  a50=(a50*a08);
  a29=(a29-a50);
  a50=(a51*a28);
  a49=(a18*a30);
  a50=(a50+a49);
  a50=(a50*a20);
  a29=(a29-a50);
  a50=(a25*a20);
  a49=(a50*a43);
  a52=(a52-a43);
  a49=(a49*a52);
  a29=(a29+a49);
  a49=(a14*a43);
  a49=(a49*a44);
  a49=(a49*a52);
  a29=(a29-a49);
  a49=(a18*a25);
  a52=(a51*a44);
  a49=(a49-a52);
  a52=(a31*a49);
  a52=(a52*a42);
  a29=(a29+a52);
  a47=sin(a47);
  a47=(a14*a47);
  a29=(a29+a47);
  a29=(a12*a29);
  a22=(a22+a29);
  a22=(a22-a21);
  a29=(a18*a28);
  a52=(a51*a30);
  a29=(a29-a52);
  a29=(a29*a13);
  a22=(a22+a29);
  a29=(2.*a51);
  a29=(a29*a08);
  a52=(a11*a29);
  a52=(a24+a52);
  a52=(a52+a11);
  a52=(a52+a36);
  a18=(a37*a18);
  a51=(a51*a14);
  a51=(a51*a08);
  a18=(a18-a51);
  a25=(a25*a14);
  a18=(a18-a25);
  a18=(a18-a14);
  a51=(a20*a44);
  a18=(a18-a51);
  a18=(a18+a38);
  a18=(a18+a29);
  a49=(a37*a49);
  a18=(a18+a49);
  a55=(a55*a14);
  a55=(a55*a08);
  a18=(a18-a55);
  a18=(a18+a40);
  a18=(a18+a41);
  a18=(a32*a18);
  a52=(a52+a18);
  a18=(a22/a52);
  a25=(a25-a33);
  a25=(a25-a39);
  a25=(a25+a51);
  a25=(a25-a49);
  a25=(a25+a55);
  a25=(a12*a25);
  a25=(a25-a35);
  a52=(a25/a52);
  a45=(a45-a47);
  a44=(a14*a44);
  a44=(a44-a50);
  a56=(a56*a44);
  a45=(a45+a56);
  a45=(a12*a45);
  a22=(a52*a22);
  a45=(a45-a22);
  a25=(a25*a52);
  a25=(a09-a25);
  a45=(a45/a25);
  a52=(a52*a45);
  a18=(a18-a52);
  a52=(a48*a18);
  a34=(a34+a52);
  a34=(a03+a34);
  a52=(a05*a34);
  a04=(a04+a52);
  a52=1.8915178993145003e+00;
  a52=(a52*a02);
  a25=3.7109375000000000e-02;
  a25=(a25*a02);
  a22=(a25*a10);
  a56=1.7025221101954405e-01;
  a56=(a56*a02);
  a44=(a56*a46);
  a22=(a22+a44);
  a44=6.0216538980455959e-02;
  a44=(a44*a02);
  a50=(a44*a18);
  a22=(a22+a50);
  a50=-1.7578125000000000e-02;
  a50=(a50*a02);
  a47=casadi_sq(a34);
  a55=(a47*a08);
  a49=(a06*a03);
  a51=(a17*a19);
  a49=(a49+a51);
  a51=(a48*a15);
  a49=(a49+a51);
  a49=(a00+a49);
  a51=sin(a49);
  a55=(a55*a51);
  a55=(a55*a13);
  a29=cos(a49);
  a42=(a06*a23);
  a54=(a17*a07);
  a42=(a42+a54);
  a54=(a48*a43);
  a42=(a42+a54);
  a42=(a16+a42);
  a54=cos(a42);
  a57=(a29*a54);
  a58=sin(a42);
  a59=(a51*a58);
  a57=(a57+a59);
  a59=(a57*a20);
  a59=(a59*a08);
  a60=(2.*a34);
  a06=(a06*a27);
  a17=(a17*a53);
  a06=(a06+a17);
  a48=(a48*a45);
  a06=(a06+a48);
  a06=(a23+a06);
  a48=(a60*a06);
  a48=(a48-a47);
  a17=casadi_sq(a06);
  a48=(a48-a17);
  a59=(a59*a48);
  a42=(a42-a49);
  a42=(a42+a26);
  a49=cos(a42);
  a49=(a49*a20);
  a59=(a59-a49);
  a17=(a29*a20);
  a17=(a17*a34);
  a17=(a17*a34);
  a17=(a17*a08);
  a59=(a59-a17);
  a17=(a29*a28);
  a61=(a51*a30);
  a17=(a17+a61);
  a17=(a17*a20);
  a59=(a59-a17);
  a17=(a54*a20);
  a61=(a17*a06);
  a60=(a60-a06);
  a61=(a61*a60);
  a59=(a59+a61);
  a61=(a14*a06);
  a61=(a61*a58);
  a61=(a61*a60);
  a59=(a59-a61);
  a61=(a51*a54);
  a60=(a29*a58);
  a61=(a61-a60);
  a60=(a31*a61);
  a60=(a60*a48);
  a59=(a59+a60);
  a42=sin(a42);
  a42=(a14*a42);
  a59=(a59+a42);
  a59=(a12*a59);
  a55=(a55+a59);
  a55=(a55-a21);
  a59=(a51*a28);
  a60=(a29*a30);
  a59=(a59-a60);
  a59=(a59*a13);
  a55=(a55+a59);
  a59=(2.*a29);
  a59=(a59*a08);
  a60=(a11*a59);
  a60=(a24+a60);
  a60=(a60+a11);
  a60=(a60+a36);
  a51=(a37*a51);
  a29=(a29*a14);
  a29=(a29*a08);
  a51=(a51-a29);
  a54=(a54*a14);
  a51=(a51-a54);
  a51=(a51-a14);
  a29=(a20*a58);
  a51=(a51-a29);
  a51=(a51+a38);
  a51=(a51+a59);
  a61=(a37*a61);
  a51=(a51+a61);
  a57=(a57*a14);
  a57=(a57*a08);
  a51=(a51-a57);
  a51=(a51+a40);
  a51=(a51+a41);
  a51=(a32*a51);
  a60=(a60+a51);
  a51=(a55/a60);
  a54=(a54-a33);
  a54=(a54-a39);
  a54=(a54+a29);
  a54=(a54-a61);
  a54=(a54+a57);
  a54=(a12*a54);
  a54=(a54-a35);
  a60=(a54/a60);
  a49=(a49-a42);
  a58=(a14*a58);
  a58=(a58-a17);
  a47=(a47*a58);
  a49=(a49+a47);
  a49=(a12*a49);
  a55=(a60*a55);
  a49=(a49-a55);
  a54=(a54*a60);
  a54=(a09-a54);
  a49=(a49/a54);
  a60=(a60*a49);
  a51=(a51-a60);
  a60=(a50*a51);
  a22=(a22+a60);
  a22=(a03+a22);
  a60=(a52*a22);
  a04=(a04+a60);
  a60=-5.8012039600105849e+00;
  a60=(a60*a02);
  a54=3.7092000118504789e-02;
  a54=(a54*a02);
  a55=(a54*a10);
  a47=1.7038392571223998e-01;
  a47=(a47*a02);
  a58=(a47*a46);
  a55=(a55+a58);
  a58=1.0726203044637328e-01;
  a58=(a58*a02);
  a17=(a58*a18);
  a55=(a55+a17);
  a17=-1.5319437748624402e-02;
  a17=(a17*a02);
  a42=(a17*a51);
  a55=(a55+a42);
  a42=8.2737891638140233e-03;
  a42=(a42*a02);
  a57=casadi_sq(a22);
  a61=(a57*a08);
  a29=(a25*a03);
  a59=(a56*a19);
  a29=(a29+a59);
  a59=(a44*a15);
  a29=(a29+a59);
  a59=(a50*a34);
  a29=(a29+a59);
  a29=(a00+a29);
  a59=sin(a29);
  a61=(a61*a59);
  a61=(a61*a13);
  a48=cos(a29);
  a62=(a25*a23);
  a63=(a56*a07);
  a62=(a62+a63);
  a63=(a44*a43);
  a62=(a62+a63);
  a63=(a50*a06);
  a62=(a62+a63);
  a62=(a16+a62);
  a63=cos(a62);
  a64=(a48*a63);
  a65=sin(a62);
  a66=(a59*a65);
  a64=(a64+a66);
  a66=(a64*a20);
  a66=(a66*a08);
  a67=(2.*a22);
  a25=(a25*a27);
  a56=(a56*a53);
  a25=(a25+a56);
  a44=(a44*a45);
  a25=(a25+a44);
  a50=(a50*a49);
  a25=(a25+a50);
  a25=(a23+a25);
  a50=(a67*a25);
  a50=(a50-a57);
  a44=casadi_sq(a25);
  a50=(a50-a44);
  a66=(a66*a50);
  a62=(a62-a29);
  a62=(a62+a26);
  a29=cos(a62);
  a29=(a29*a20);
  a66=(a66-a29);
  a44=(a48*a20);
  a44=(a44*a22);
  a44=(a44*a22);
  a44=(a44*a08);
  a66=(a66-a44);
  a44=(a48*a28);
  a56=(a59*a30);
  a44=(a44+a56);
  a44=(a44*a20);
  a66=(a66-a44);
  a44=(a63*a20);
  a56=(a44*a25);
  a67=(a67-a25);
  a56=(a56*a67);
  a66=(a66+a56);
  a56=(a14*a25);
  a56=(a56*a65);
  a56=(a56*a67);
  a66=(a66-a56);
  a56=(a59*a63);
  a67=(a48*a65);
  a56=(a56-a67);
  a67=(a31*a56);
  a67=(a67*a50);
  a66=(a66+a67);
  a62=sin(a62);
  a62=(a14*a62);
  a66=(a66+a62);
  a66=(a12*a66);
  a61=(a61+a66);
  a61=(a61-a21);
  a66=(a59*a28);
  a67=(a48*a30);
  a66=(a66-a67);
  a66=(a66*a13);
  a61=(a61+a66);
  a66=(2.*a48);
  a66=(a66*a08);
  a67=(a11*a66);
  a67=(a24+a67);
  a67=(a67+a11);
  a67=(a67+a36);
  a59=(a37*a59);
  a48=(a48*a14);
  a48=(a48*a08);
  a59=(a59-a48);
  a63=(a63*a14);
  a59=(a59-a63);
  a59=(a59-a14);
  a48=(a20*a65);
  a59=(a59-a48);
  a59=(a59+a38);
  a59=(a59+a66);
  a56=(a37*a56);
  a59=(a59+a56);
  a64=(a64*a14);
  a64=(a64*a08);
  a59=(a59-a64);
  a59=(a59+a40);
  a59=(a59+a41);
  a59=(a32*a59);
  a67=(a67+a59);
  a59=(a61/a67);
  a63=(a63-a33);
  a63=(a63-a39);
  a63=(a63+a48);
  a63=(a63-a56);
  a63=(a63+a64);
  a63=(a12*a63);
  a63=(a63-a35);
  a67=(a63/a67);
  a29=(a29-a62);
  a65=(a14*a65);
  a65=(a65-a44);
  a57=(a57*a65);
  a29=(a29+a57);
  a29=(a12*a29);
  a61=(a67*a61);
  a29=(a29-a61);
  a63=(a63*a67);
  a63=(a09-a63);
  a29=(a29/a63);
  a67=(a67*a29);
  a59=(a59-a67);
  a67=(a42*a59);
  a55=(a55+a67);
  a55=(a03+a55);
  a67=(a60*a55);
  a04=(a04+a67);
  a67=3.1116436695781990e-01;
  a67=(a67*a02);
  a63=6.2411095871607569e-01;
  a63=(a63*a02);
  a61=(a63*a10);
  a57=-3.3608926294469414e+00;
  a57=(a57*a02);
  a65=(a57*a46);
  a61=(a61+a65);
  a65=-8.6821934684172597e-01;
  a65=(a65*a02);
  a44=(a65*a18);
  a61=(a61+a44);
  a44=2.7592099699446710e+01;
  a44=(a44*a02);
  a62=(a44*a51);
  a61=(a61+a62);
  a62=2.0154067550477894e+01;
  a62=(a62*a02);
  a64=(a62*a59);
  a61=(a61+a64);
  a64=-4.3489884181069961e+01;
  a64=(a64*a02);
  a56=casadi_sq(a55);
  a48=(a56*a08);
  a66=(a54*a03);
  a50=(a47*a19);
  a66=(a66+a50);
  a50=(a58*a15);
  a66=(a66+a50);
  a50=(a17*a34);
  a66=(a66+a50);
  a50=(a42*a22);
  a66=(a66+a50);
  a66=(a00+a66);
  a50=sin(a66);
  a48=(a48*a50);
  a48=(a48*a13);
  a68=cos(a66);
  a69=(a54*a23);
  a70=(a47*a07);
  a69=(a69+a70);
  a70=(a58*a43);
  a69=(a69+a70);
  a70=(a17*a06);
  a69=(a69+a70);
  a70=(a42*a25);
  a69=(a69+a70);
  a69=(a16+a69);
  a70=cos(a69);
  a71=(a68*a70);
  a72=sin(a69);
  a73=(a50*a72);
  a71=(a71+a73);
  a73=(a71*a20);
  a73=(a73*a08);
  a74=(2.*a55);
  a54=(a54*a27);
  a47=(a47*a53);
  a54=(a54+a47);
  a58=(a58*a45);
  a54=(a54+a58);
  a17=(a17*a49);
  a54=(a54+a17);
  a42=(a42*a29);
  a54=(a54+a42);
  a54=(a23+a54);
  a42=(a74*a54);
  a42=(a42-a56);
  a17=casadi_sq(a54);
  a42=(a42-a17);
  a73=(a73*a42);
  a69=(a69-a66);
  a69=(a69+a26);
  a66=cos(a69);
  a66=(a66*a20);
  a73=(a73-a66);
  a17=(a68*a20);
  a17=(a17*a55);
  a17=(a17*a55);
  a17=(a17*a08);
  a73=(a73-a17);
  a17=(a68*a28);
  a58=(a50*a30);
  a17=(a17+a58);
  a17=(a17*a20);
  a73=(a73-a17);
  a17=(a70*a20);
  a58=(a17*a54);
  a74=(a74-a54);
  a58=(a58*a74);
  a73=(a73+a58);
  a58=(a14*a54);
  a58=(a58*a72);
  a58=(a58*a74);
  a73=(a73-a58);
  a58=(a50*a70);
  a74=(a68*a72);
  a58=(a58-a74);
  a74=(a31*a58);
  a74=(a74*a42);
  a73=(a73+a74);
  a69=sin(a69);
  a69=(a14*a69);
  a73=(a73+a69);
  a73=(a12*a73);
  a48=(a48+a73);
  a48=(a48-a21);
  a73=(a50*a28);
  a74=(a68*a30);
  a73=(a73-a74);
  a73=(a73*a13);
  a48=(a48+a73);
  a73=(2.*a68);
  a73=(a73*a08);
  a74=(a11*a73);
  a74=(a24+a74);
  a74=(a74+a11);
  a74=(a74+a36);
  a50=(a37*a50);
  a68=(a68*a14);
  a68=(a68*a08);
  a50=(a50-a68);
  a70=(a70*a14);
  a50=(a50-a70);
  a50=(a50-a14);
  a68=(a20*a72);
  a50=(a50-a68);
  a50=(a50+a38);
  a50=(a50+a73);
  a58=(a37*a58);
  a50=(a50+a58);
  a71=(a71*a14);
  a71=(a71*a08);
  a50=(a50-a71);
  a50=(a50+a40);
  a50=(a50+a41);
  a50=(a32*a50);
  a74=(a74+a50);
  a50=(a48/a74);
  a70=(a70-a33);
  a70=(a70-a39);
  a70=(a70+a68);
  a70=(a70-a58);
  a70=(a70+a71);
  a70=(a12*a70);
  a70=(a70-a35);
  a74=(a70/a74);
  a66=(a66-a69);
  a72=(a14*a72);
  a72=(a72-a17);
  a56=(a56*a72);
  a66=(a66+a56);
  a66=(a12*a66);
  a48=(a74*a48);
  a66=(a66-a48);
  a70=(a70*a74);
  a70=(a09-a70);
  a66=(a66/a70);
  a74=(a74*a66);
  a50=(a50-a74);
  a74=(a64*a50);
  a61=(a61+a74);
  a61=(a03+a61);
  a74=(a67*a61);
  a04=(a04+a74);
  a74=-1.5216094966251609e-01;
  a74=(a74*a02);
  a70=4.7766253643826434e-01;
  a70=(a70*a02);
  a48=(a70*a10);
  a56=-2.4881146199716677e+00;
  a56=(a56*a02);
  a72=(a56*a46);
  a48=(a48+a72);
  a72=-5.9029082683684297e-01;
  a72=(a72*a02);
  a17=(a72*a18);
  a48=(a48+a17);
  a17=2.1230051448181193e+01;
  a17=(a17*a02);
  a69=(a17*a51);
  a48=(a48+a69);
  a69=1.5279233632882423e+01;
  a69=(a69*a02);
  a71=(a69*a59);
  a48=(a48+a71);
  a71=-3.3288210968984863e+01;
  a71=(a71*a02);
  a58=(a71*a50);
  a48=(a48+a58);
  a58=-2.0331201708508627e-02;
  a58=(a58*a02);
  a68=casadi_sq(a61);
  a73=(a68*a08);
  a42=(a63*a03);
  a47=(a57*a19);
  a42=(a42+a47);
  a47=(a65*a15);
  a42=(a42+a47);
  a47=(a44*a34);
  a42=(a42+a47);
  a47=(a62*a22);
  a42=(a42+a47);
  a47=(a64*a55);
  a42=(a42+a47);
  a42=(a00+a42);
  a47=sin(a42);
  a73=(a73*a47);
  a73=(a73*a13);
  a75=cos(a42);
  a76=(a63*a23);
  a77=(a57*a07);
  a76=(a76+a77);
  a77=(a65*a43);
  a76=(a76+a77);
  a77=(a44*a06);
  a76=(a76+a77);
  a77=(a62*a25);
  a76=(a76+a77);
  a77=(a64*a54);
  a76=(a76+a77);
  a76=(a16+a76);
  a77=cos(a76);
  a78=(a75*a77);
  a79=sin(a76);
  a80=(a47*a79);
  a78=(a78+a80);
  a80=(a78*a20);
  a80=(a80*a08);
  a81=(2.*a61);
  a63=(a63*a27);
  a57=(a57*a53);
  a63=(a63+a57);
  a65=(a65*a45);
  a63=(a63+a65);
  a44=(a44*a49);
  a63=(a63+a44);
  a62=(a62*a29);
  a63=(a63+a62);
  a64=(a64*a66);
  a63=(a63+a64);
  a63=(a23+a63);
  a64=(a81*a63);
  a64=(a64-a68);
  a62=casadi_sq(a63);
  a64=(a64-a62);
  a80=(a80*a64);
  a76=(a76-a42);
  a76=(a76+a26);
  a42=cos(a76);
  a42=(a42*a20);
  a80=(a80-a42);
  a62=(a75*a20);
  a62=(a62*a61);
  a62=(a62*a61);
  a62=(a62*a08);
  a80=(a80-a62);
  a62=(a75*a28);
  a44=(a47*a30);
  a62=(a62+a44);
  a62=(a62*a20);
  a80=(a80-a62);
  a62=(a77*a20);
  a44=(a62*a63);
  a81=(a81-a63);
  a44=(a44*a81);
  a80=(a80+a44);
  a44=(a14*a63);
  a44=(a44*a79);
  a44=(a44*a81);
  a80=(a80-a44);
  a44=(a47*a77);
  a81=(a75*a79);
  a44=(a44-a81);
  a81=(a31*a44);
  a81=(a81*a64);
  a80=(a80+a81);
  a76=sin(a76);
  a76=(a14*a76);
  a80=(a80+a76);
  a80=(a12*a80);
  a73=(a73+a80);
  a73=(a73-a21);
  a80=(a47*a28);
  a81=(a75*a30);
  a80=(a80-a81);
  a80=(a80*a13);
  a73=(a73+a80);
  a80=(2.*a75);
  a80=(a80*a08);
  a81=(a11*a80);
  a81=(a24+a81);
  a81=(a81+a11);
  a81=(a81+a36);
  a47=(a37*a47);
  a75=(a75*a14);
  a75=(a75*a08);
  a47=(a47-a75);
  a77=(a77*a14);
  a47=(a47-a77);
  a47=(a47-a14);
  a75=(a20*a79);
  a47=(a47-a75);
  a47=(a47+a38);
  a47=(a47+a80);
  a44=(a37*a44);
  a47=(a47+a44);
  a78=(a78*a14);
  a78=(a78*a08);
  a47=(a47-a78);
  a47=(a47+a40);
  a47=(a47+a41);
  a47=(a32*a47);
  a81=(a81+a47);
  a47=(a73/a81);
  a77=(a77-a33);
  a77=(a77-a39);
  a77=(a77+a75);
  a77=(a77-a44);
  a77=(a77+a78);
  a77=(a12*a77);
  a77=(a77-a35);
  a81=(a77/a81);
  a42=(a42-a76);
  a79=(a14*a79);
  a79=(a79-a62);
  a68=(a68*a79);
  a42=(a42+a68);
  a42=(a12*a42);
  a73=(a81*a73);
  a42=(a42-a73);
  a77=(a77*a81);
  a77=(a09-a77);
  a42=(a42/a77);
  a81=(a81*a42);
  a47=(a47-a81);
  a81=(a58*a47);
  a48=(a48+a81);
  a48=(a03+a48);
  a81=(a74*a48);
  a04=(a04+a81);
  a81=2.0136540080403034e-01;
  a81=(a81*a02);
  a77=-9.3714243008598730e-01;
  a77=(a77*a02);
  a73=(a77*a10);
  a68=5.1863724288440638e+00;
  a68=(a68*a02);
  a79=(a68*a46);
  a73=(a73+a79);
  a79=1.0914373489967295e+00;
  a79=(a79*a02);
  a62=(a79*a18);
  a73=(a73+a62);
  a62=-8.1497870107469268e+00;
  a62=(a62*a02);
  a76=(a62*a51);
  a73=(a73+a76);
  a76=-1.8520065659996959e+01;
  a76=(a76*a02);
  a78=(a76*a59);
  a73=(a73+a78);
  a78=2.2739487099350505e+01;
  a78=(a78*a02);
  a44=(a78*a50);
  a73=(a73+a44);
  a44=2.4936055526796523e+00;
  a44=(a44*a02);
  a75=(a44*a47);
  a73=(a73+a75);
  a75=-3.0467644718982196e+00;
  a75=(a75*a02);
  a80=casadi_sq(a48);
  a64=(a80*a08);
  a65=(a70*a03);
  a57=(a56*a19);
  a65=(a65+a57);
  a57=(a72*a15);
  a65=(a65+a57);
  a57=(a17*a34);
  a65=(a65+a57);
  a57=(a69*a22);
  a65=(a65+a57);
  a57=(a71*a55);
  a65=(a65+a57);
  a57=(a58*a61);
  a65=(a65+a57);
  a65=(a00+a65);
  a57=sin(a65);
  a64=(a64*a57);
  a64=(a64*a13);
  a82=cos(a65);
  a83=(a70*a23);
  a84=(a56*a07);
  a83=(a83+a84);
  a84=(a72*a43);
  a83=(a83+a84);
  a84=(a17*a06);
  a83=(a83+a84);
  a84=(a69*a25);
  a83=(a83+a84);
  a84=(a71*a54);
  a83=(a83+a84);
  a84=(a58*a63);
  a83=(a83+a84);
  a83=(a16+a83);
  a84=cos(a83);
  a85=(a82*a84);
  a86=sin(a83);
  a87=(a57*a86);
  a85=(a85+a87);
  a87=(a85*a20);
  a87=(a87*a08);
  a88=(2.*a48);
  a70=(a70*a27);
  a56=(a56*a53);
  a70=(a70+a56);
  a72=(a72*a45);
  a70=(a70+a72);
  a17=(a17*a49);
  a70=(a70+a17);
  a69=(a69*a29);
  a70=(a70+a69);
  a71=(a71*a66);
  a70=(a70+a71);
  a58=(a58*a42);
  a70=(a70+a58);
  a70=(a23+a70);
  a58=(a88*a70);
  a58=(a58-a80);
  a71=casadi_sq(a70);
  a58=(a58-a71);
  a87=(a87*a58);
  a83=(a83-a65);
  a83=(a83+a26);
  a65=cos(a83);
  a65=(a65*a20);
  a87=(a87-a65);
  a71=(a82*a20);
  a71=(a71*a48);
  a71=(a71*a48);
  a71=(a71*a08);
  a87=(a87-a71);
  a71=(a82*a28);
  a69=(a57*a30);
  a71=(a71+a69);
  a71=(a71*a20);
  a87=(a87-a71);
  a71=(a84*a20);
  a69=(a71*a70);
  a88=(a88-a70);
  a69=(a69*a88);
  a87=(a87+a69);
  a69=(a14*a70);
  a69=(a69*a86);
  a69=(a69*a88);
  a87=(a87-a69);
  a69=(a57*a84);
  a88=(a82*a86);
  a69=(a69-a88);
  a88=(a31*a69);
  a88=(a88*a58);
  a87=(a87+a88);
  a83=sin(a83);
  a83=(a14*a83);
  a87=(a87+a83);
  a87=(a12*a87);
  a64=(a64+a87);
  a64=(a64-a21);
  a87=(a57*a28);
  a88=(a82*a30);
  a87=(a87-a88);
  a87=(a87*a13);
  a64=(a64+a87);
  a87=(2.*a82);
  a87=(a87*a08);
  a88=(a11*a87);
  a88=(a24+a88);
  a88=(a88+a11);
  a88=(a88+a36);
  a57=(a37*a57);
  a82=(a82*a14);
  a82=(a82*a08);
  a57=(a57-a82);
  a84=(a84*a14);
  a57=(a57-a84);
  a57=(a57-a14);
  a82=(a20*a86);
  a57=(a57-a82);
  a57=(a57+a38);
  a57=(a57+a87);
  a69=(a37*a69);
  a57=(a57+a69);
  a85=(a85*a14);
  a85=(a85*a08);
  a57=(a57-a85);
  a57=(a57+a40);
  a57=(a57+a41);
  a57=(a32*a57);
  a88=(a88+a57);
  a57=(a64/a88);
  a84=(a84-a33);
  a84=(a84-a39);
  a84=(a84+a82);
  a84=(a84-a69);
  a84=(a84+a85);
  a84=(a12*a84);
  a84=(a84-a35);
  a88=(a84/a88);
  a65=(a65-a83);
  a86=(a14*a86);
  a86=(a86-a71);
  a80=(a80*a86);
  a65=(a65+a80);
  a65=(a12*a65);
  a64=(a88*a64);
  a65=(a65-a64);
  a84=(a84*a88);
  a84=(a09-a84);
  a65=(a65/a84);
  a88=(a88*a65);
  a57=(a57-a88);
  a88=(a75*a57);
  a73=(a73+a88);
  a73=(a03+a73);
  a88=(a81*a73);
  a04=(a04+a88);
  a88=4.4710615727772587e-02;
  a88=(a88*a02);
  a84=2.2733101475165380e+00;
  a84=(a84*a02);
  a64=(a84*a10);
  a80=-1.0534495466737249e+01;
  a80=(a80*a02);
  a46=(a80*a46);
  a64=(a64+a46);
  a46=-2.0008720582248625e+00;
  a46=(a46*a02);
  a18=(a46*a18);
  a64=(a64+a18);
  a18=-1.7958931863118799e+01;
  a18=(a18*a02);
  a86=(a18*a51);
  a64=(a64+a86);
  a86=2.7948884529419960e+01;
  a86=(a86*a02);
  a71=(a86*a59);
  a64=(a64+a71);
  a71=-2.8589982771350235e+00;
  a71=(a71*a02);
  a83=(a71*a50);
  a64=(a64+a83);
  a83=-8.8728569335306293e+00;
  a83=(a83*a02);
  a85=(a83*a47);
  a64=(a64+a85);
  a85=1.2360567175794303e+01;
  a85=(a85*a02);
  a69=(a85*a57);
  a64=(a64+a69);
  a69=6.4339274601576357e-01;
  a69=(a69*a02);
  a02=casadi_sq(a73);
  a82=(a02*a08);
  a87=(a77*a03);
  a58=(a68*a19);
  a87=(a87+a58);
  a58=(a79*a15);
  a87=(a87+a58);
  a58=(a62*a34);
  a87=(a87+a58);
  a58=(a76*a22);
  a87=(a87+a58);
  a58=(a78*a55);
  a87=(a87+a58);
  a58=(a44*a61);
  a87=(a87+a58);
  a58=(a75*a48);
  a87=(a87+a58);
  a87=(a00+a87);
  a58=sin(a87);
  a82=(a82*a58);
  a82=(a82*a13);
  a17=cos(a87);
  a72=(a77*a23);
  a56=(a68*a07);
  a72=(a72+a56);
  a56=(a79*a43);
  a72=(a72+a56);
  a56=(a62*a06);
  a72=(a72+a56);
  a56=(a76*a25);
  a72=(a72+a56);
  a56=(a78*a54);
  a72=(a72+a56);
  a56=(a44*a63);
  a72=(a72+a56);
  a56=(a75*a70);
  a72=(a72+a56);
  a72=(a16+a72);
  a56=cos(a72);
  a89=(a17*a56);
  a90=sin(a72);
  a91=(a58*a90);
  a89=(a89+a91);
  a91=(a89*a20);
  a91=(a91*a08);
  a92=(2.*a73);
  a77=(a77*a27);
  a68=(a68*a53);
  a77=(a77+a68);
  a79=(a79*a45);
  a77=(a77+a79);
  a62=(a62*a49);
  a77=(a77+a62);
  a76=(a76*a29);
  a77=(a77+a76);
  a78=(a78*a66);
  a77=(a77+a78);
  a44=(a44*a42);
  a77=(a77+a44);
  a75=(a75*a65);
  a77=(a77+a75);
  a77=(a23+a77);
  a75=(a92*a77);
  a75=(a75-a02);
  a44=casadi_sq(a77);
  a75=(a75-a44);
  a91=(a91*a75);
  a72=(a72-a87);
  a72=(a72+a26);
  a87=cos(a72);
  a87=(a87*a20);
  a91=(a91-a87);
  a44=(a17*a20);
  a44=(a44*a73);
  a44=(a44*a73);
  a44=(a44*a08);
  a91=(a91-a44);
  a44=(a17*a28);
  a78=(a58*a30);
  a44=(a44+a78);
  a44=(a44*a20);
  a91=(a91-a44);
  a44=(a56*a20);
  a78=(a44*a77);
  a92=(a92-a77);
  a78=(a78*a92);
  a91=(a91+a78);
  a78=(a14*a77);
  a78=(a78*a90);
  a78=(a78*a92);
  a91=(a91-a78);
  a78=(a58*a56);
  a92=(a17*a90);
  a78=(a78-a92);
  a92=(a31*a78);
  a92=(a92*a75);
  a91=(a91+a92);
  a72=sin(a72);
  a72=(a14*a72);
  a91=(a91+a72);
  a91=(a12*a91);
  a82=(a82+a91);
  a82=(a82-a21);
  a91=(a58*a28);
  a92=(a17*a30);
  a91=(a91-a92);
  a91=(a91*a13);
  a82=(a82+a91);
  a91=(2.*a17);
  a91=(a91*a08);
  a92=(a11*a91);
  a92=(a24+a92);
  a92=(a92+a11);
  a92=(a92+a36);
  a58=(a37*a58);
  a17=(a17*a14);
  a17=(a17*a08);
  a58=(a58-a17);
  a56=(a56*a14);
  a58=(a58-a56);
  a58=(a58-a14);
  a17=(a20*a90);
  a58=(a58-a17);
  a58=(a58+a38);
  a58=(a58+a91);
  a78=(a37*a78);
  a58=(a58+a78);
  a89=(a89*a14);
  a89=(a89*a08);
  a58=(a58-a89);
  a58=(a58+a40);
  a58=(a58+a41);
  a58=(a32*a58);
  a92=(a92+a58);
  a58=(a82/a92);
  a56=(a56-a33);
  a56=(a56-a39);
  a56=(a56+a17);
  a56=(a56-a78);
  a56=(a56+a89);
  a56=(a12*a56);
  a56=(a56-a35);
  a92=(a56/a92);
  a87=(a87-a72);
  a90=(a14*a90);
  a90=(a90-a44);
  a02=(a02*a90);
  a87=(a87+a02);
  a87=(a12*a87);
  a82=(a92*a82);
  a87=(a87-a82);
  a56=(a56*a92);
  a56=(a09-a56);
  a87=(a87/a56);
  a92=(a92*a87);
  a58=(a58-a92);
  a92=(a69*a58);
  a64=(a64+a92);
  a64=(a03+a64);
  a92=(a88*a64);
  a04=(a04+a92);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a23);
  a92=(a05*a06);
  a04=(a04+a92);
  a92=(a52*a25);
  a04=(a04+a92);
  a92=(a60*a54);
  a04=(a04+a92);
  a92=(a67*a63);
  a04=(a04+a92);
  a92=(a74*a70);
  a04=(a04+a92);
  a92=(a81*a77);
  a04=(a04+a92);
  a92=(a84*a27);
  a53=(a80*a53);
  a92=(a92+a53);
  a45=(a46*a45);
  a92=(a92+a45);
  a45=(a18*a49);
  a92=(a92+a45);
  a45=(a86*a29);
  a92=(a92+a45);
  a45=(a71*a66);
  a92=(a92+a45);
  a45=(a83*a42);
  a92=(a92+a45);
  a45=(a85*a65);
  a92=(a92+a45);
  a45=(a69*a87);
  a92=(a92+a45);
  a92=(a23+a92);
  a45=(a88*a92);
  a04=(a04+a45);
  a04=(a16+a04);
  if (res[0]!=0) res[0][1]=a04;
  a10=(a01*a10);
  a51=(a05*a51);
  a10=(a10+a51);
  a59=(a52*a59);
  a10=(a10+a59);
  a50=(a60*a50);
  a10=(a10+a50);
  a47=(a67*a47);
  a10=(a10+a47);
  a57=(a74*a57);
  a10=(a10+a57);
  a58=(a81*a58);
  a10=(a10+a58);
  a58=casadi_sq(a64);
  a57=(a58*a08);
  a47=(a84*a03);
  a19=(a80*a19);
  a47=(a47+a19);
  a15=(a46*a15);
  a47=(a47+a15);
  a34=(a18*a34);
  a47=(a47+a34);
  a22=(a86*a22);
  a47=(a47+a22);
  a55=(a71*a55);
  a47=(a47+a55);
  a61=(a83*a61);
  a47=(a47+a61);
  a48=(a85*a48);
  a47=(a47+a48);
  a73=(a69*a73);
  a47=(a47+a73);
  a00=(a00+a47);
  a47=sin(a00);
  a57=(a57*a47);
  a57=(a57*a13);
  a73=cos(a00);
  a84=(a84*a23);
  a80=(a80*a07);
  a84=(a84+a80);
  a46=(a46*a43);
  a84=(a84+a46);
  a18=(a18*a06);
  a84=(a84+a18);
  a86=(a86*a25);
  a84=(a84+a86);
  a71=(a71*a54);
  a84=(a84+a71);
  a83=(a83*a63);
  a84=(a84+a83);
  a85=(a85*a70);
  a84=(a84+a85);
  a69=(a69*a77);
  a84=(a84+a69);
  a16=(a16+a84);
  a84=cos(a16);
  a69=(a73*a84);
  a77=sin(a16);
  a85=(a47*a77);
  a69=(a69+a85);
  a85=(a69*a20);
  a85=(a85*a08);
  a70=(2.*a64);
  a83=(a70*a92);
  a83=(a83-a58);
  a63=casadi_sq(a92);
  a83=(a83-a63);
  a85=(a85*a83);
  a16=(a16-a00);
  a16=(a16+a26);
  a26=cos(a16);
  a26=(a26*a20);
  a85=(a85-a26);
  a00=(a73*a20);
  a00=(a00*a64);
  a00=(a00*a64);
  a00=(a00*a08);
  a85=(a85-a00);
  a00=(a73*a28);
  a64=(a47*a30);
  a00=(a00+a64);
  a00=(a00*a20);
  a85=(a85-a00);
  a00=(a84*a20);
  a64=(a00*a92);
  a70=(a70-a92);
  a64=(a64*a70);
  a85=(a85+a64);
  a92=(a14*a92);
  a92=(a92*a77);
  a92=(a92*a70);
  a85=(a85-a92);
  a92=(a47*a84);
  a70=(a73*a77);
  a92=(a92-a70);
  a31=(a31*a92);
  a31=(a31*a83);
  a85=(a85+a31);
  a16=sin(a16);
  a16=(a14*a16);
  a85=(a85+a16);
  a85=(a12*a85);
  a57=(a57+a85);
  a57=(a57-a21);
  a28=(a47*a28);
  a30=(a73*a30);
  a28=(a28-a30);
  a28=(a28*a13);
  a57=(a57+a28);
  a28=(2.*a73);
  a28=(a28*a08);
  a13=(a11*a28);
  a24=(a24+a13);
  a24=(a24+a11);
  a24=(a24+a36);
  a47=(a37*a47);
  a73=(a73*a14);
  a73=(a73*a08);
  a47=(a47-a73);
  a84=(a84*a14);
  a47=(a47-a84);
  a47=(a47-a14);
  a20=(a20*a77);
  a47=(a47-a20);
  a47=(a47+a38);
  a47=(a47+a28);
  a37=(a37*a92);
  a47=(a47+a37);
  a69=(a69*a14);
  a69=(a69*a08);
  a47=(a47-a69);
  a47=(a47+a40);
  a47=(a47+a41);
  a32=(a32*a47);
  a24=(a24+a32);
  a32=(a57/a24);
  a84=(a84-a33);
  a84=(a84-a39);
  a84=(a84+a20);
  a84=(a84-a37);
  a84=(a84+a69);
  a84=(a12*a84);
  a84=(a84-a35);
  a24=(a84/a24);
  a26=(a26-a16);
  a14=(a14*a77);
  a14=(a14-a00);
  a58=(a58*a14);
  a26=(a26+a58);
  a12=(a12*a26);
  a57=(a24*a57);
  a12=(a12-a57);
  a84=(a84*a24);
  a09=(a09-a84);
  a12=(a12/a09);
  a24=(a24*a12);
  a32=(a32-a24);
  a32=(a88*a32);
  a10=(a10+a32);
  a03=(a03+a10);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a27);
  a05=(a05*a49);
  a01=(a01+a05);
  a52=(a52*a29);
  a01=(a01+a52);
  a60=(a60*a66);
  a01=(a01+a60);
  a67=(a67*a42);
  a01=(a01+a67);
  a74=(a74*a65);
  a01=(a01+a74);
  a81=(a81*a87);
  a01=(a01+a81);
  a88=(a88*a12);
  a01=(a01+a88);
  a23=(a23+a01);
  if (res[0]!=0) res[0][3]=a23;
  return 0;
}

/* observe:(t,y[4],p[7])->(g[7],dg[7]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102;
  a000=arg[2]? arg[2][1] : 0;
  a001=arg[1]? arg[1][0] : 0;
  a002=cos(a001);
  a003=arg[2]? arg[2][4] : 0;
  a004=(a002*a003);
  a005=arg[1]? arg[1][1] : 0;
  a006=(a001-a005);
  a007=cos(a006);
  a008=(a007*a003);
  a009=(a004+a008);
  a010=arg[2]? arg[2][3] : 0;
  a011=sin(a001);
  a012=(a010*a011);
  a009=(a009+a012);
  a006=sin(a006);
  a012=(a010*a006);
  a009=(a009+a012);
  a013=(2.*a001);
  a014=arg[2]? arg[2][5] : 0;
  a015=(a013*a014);
  a009=(a009-a015);
  a015=(2.*a011);
  a009=(a009-a015);
  a009=(a000*a009);
  a015=arg[2]? arg[2][0] : 0;
  a016=(a015*a001);
  a016=(a016*a014);
  a009=(a009-a016);
  a016=(a015*a011);
  a009=(a009-a016);
  a016=(2.*a000);
  a017=(a015+a016);
  a009=(a009/a017);
  a018=(a002*a015);
  a019=(a015*a014);
  a018=(a018+a019);
  a020=(2.*a002);
  a021=(a002*a010);
  a022=(a020-a021);
  a023=(a007*a010);
  a022=(a022-a023);
  a024=(a003*a011);
  a022=(a022+a024);
  a024=(a003*a006);
  a022=(a022+a024);
  a024=(2.*a014);
  a022=(a022+a024);
  a022=(a000*a022);
  a018=(a018+a022);
  a018=(a018/a017);
  a022=(2.*a003);
  a024=arg[1]? arg[1][2] : 0;
  a025=(a022*a024);
  a026=arg[1]? arg[1][3] : 0;
  a027=(a025*a026);
  a028=(a005-a001);
  a029=arg[2]? arg[2][6] : 0;
  a028=(a028+a029);
  a030=cos(a028);
  a031=(a030*a003);
  a028=sin(a028);
  a032=(a010*a028);
  a033=(a031-a032);
  a034=casadi_sq(a024);
  a035=sin(a005);
  a036=(a010*a035);
  a037=cos(a005);
  a038=(a037*a003);
  a036=(a036-a038);
  a039=(a034*a036);
  a033=(a033+a039);
  a033=(a000*a033);
  a039=(a037*a010);
  a040=casadi_sq(a010);
  a041=(a039-a040);
  a042=casadi_sq(a003);
  a041=(a041-a042);
  a043=(a003*a035);
  a041=(a041+a043);
  a044=(a003*a014);
  a045=(a044*a006);
  a041=(a041-a045);
  a023=(a023*a014);
  a041=(a041+a023);
  a041=(a000*a041);
  a046=arg[2]? arg[2][2] : 0;
  a041=(a041-a046);
  a047=(a020*a015);
  a047=(a047*a014);
  a019=(a019*a014);
  a047=(a047+a019);
  a047=(a047+a015);
  a048=(2.*a046);
  a047=(a047+a048);
  a020=(a020*a014);
  a021=(a021*a014);
  a049=(a020-a021);
  a049=(a049-a039);
  a049=(a049-a010);
  a050=(a044*a011);
  a049=(a049+a050);
  a049=(a049-a043);
  a051=casadi_sq(a014);
  a049=(a049+a051);
  a049=(a049+a045);
  a049=(a049-a023);
  a040=(a040+a042);
  a049=(a049+a040);
  a042=1.;
  a049=(a049+a042);
  a049=(a016*a049);
  a047=(a047+a049);
  a049=(a041/a047);
  a052=(a034*a014);
  a053=(a052*a011);
  a054=2.;
  a054=(a054-a010);
  a054=(a000*a054);
  a054=(a015+a054);
  a053=(a053*a054);
  a055=(2.*a024);
  a056=(a055*a026);
  a056=(a056-a034);
  a057=casadi_sq(a026);
  a056=(a056-a057);
  a057=(a014*a056);
  a058=(a008*a057);
  a058=(a058-a031);
  a059=(a002*a014);
  a060=(a003*a024);
  a061=(a060*a024);
  a062=(a059*a061);
  a058=(a058-a062);
  a063=(a001-a029);
  a064=cos(a063);
  a065=(a064*a003);
  a058=(a058-a065);
  a066=(a038*a026);
  a067=(a055-a026);
  a068=(a066*a067);
  a058=(a058+a068);
  a069=(a010*a026);
  a070=(a069*a035);
  a071=(a070*a067);
  a058=(a058-a071);
  a058=(a058+a032);
  a072=(a012*a057);
  a058=(a058+a072);
  a058=(a000*a058);
  a058=(a053+a058);
  a072=sin(a029);
  a073=(a014*a072);
  a073=(a073*a017);
  a058=(a058-a073);
  a063=sin(a063);
  a074=(a063*a054);
  a058=(a058+a074);
  a075=(a049*a058);
  a075=(a033-a075);
  a076=(a000*a040);
  a046=(a046+a076);
  a076=(a041*a049);
  a076=(a046-a076);
  a075=(a075/a076);
  a077=(a075*a010);
  a077=(a027-a077);
  a078=(a003*a026);
  a079=(a078*a026);
  a077=(a077-a079);
  a080=(a058/a047);
  a081=(a049*a075);
  a081=(a080-a081);
  a082=(a081*a010);
  a082=(a061-a082);
  a077=(a077-a082);
  a083=(a007*a077);
  a084=(a069*a026);
  a085=(a075*a003);
  a085=(a084-a085);
  a086=(2.*a010);
  a087=(a086*a024);
  a088=(a087*a026);
  a085=(a085-a088);
  a089=(a081*a003);
  a090=(a010*a024);
  a091=(a090*a024);
  a089=(a089+a091);
  a085=(a085+a089);
  a092=(a006*a085);
  a083=(a083-a092);
  a083=(a000*a083);
  a092=(a081*a015);
  a093=(2.*a081);
  a093=(a093+a082);
  a093=(a000*a093);
  a092=(a092+a093);
  a093=(a002*a092);
  a081=(a081*a014);
  a081=(a081*a017);
  a093=(a093+a081);
  a083=(a083-a093);
  a093=(a034*a015);
  a081=(a055*a024);
  a089=(a089-a081);
  a089=(a000*a089);
  a082=(a093-a089);
  a094=(a011*a082);
  a083=(a083+a094);
  a072=(a072*a017);
  a083=(a083-a072);
  a094=(a018*a083);
  a089=(a089-a093);
  a095=(a002*a089);
  a029=cos(a029);
  a029=(a029*a017);
  a095=(a095+a029);
  a096=(a007*a085);
  a097=(a006*a077);
  a096=(a096+a097);
  a096=(a000*a096);
  a095=(a095+a096);
  a096=(a011*a092);
  a095=(a095-a096);
  a094=(a094/a095);
  a009=(a009-a094);
  a001=(a001*a014);
  a009=(a009+a001);
  a009=(-a009);
  if (res[0]!=0) res[0][0]=a009;
  a009=(a008*a014);
  a001=(a009*a056);
  a001=(a001-a031);
  a062=(a001-a062);
  a062=(a062-a065);
  a062=(a062+a068);
  a062=(a062-a071);
  a031=(a010*a014);
  a096=(a031*a006);
  a097=(a096*a056);
  a062=(a062+a097);
  a062=(a062+a032);
  a062=(a000*a062);
  a062=(a053+a062);
  a062=(a062-a073);
  a062=(a062+a074);
  a098=(a015*a020);
  a019=(a019+a098);
  a019=(a019+a015);
  a019=(a019+a048);
  a050=(a050-a021);
  a050=(a050-a039);
  a050=(a050-a010);
  a050=(a050-a043);
  a050=(a050+a051);
  a050=(a050+a020);
  a050=(a050+a045);
  a050=(a050-a023);
  a050=(a050+a040);
  a050=(a050+a042);
  a050=(a016*a050);
  a019=(a019+a050);
  a050=(a062/a019);
  a042=(a041/a019);
  a040=(a042*a062);
  a040=(a033-a040);
  a023=(a041*a042);
  a046=(a046-a023);
  a040=(a040/a046);
  a023=(a042*a040);
  a023=(a050-a023);
  a045=(a023*a003);
  a045=(a045+a091);
  a081=(a045-a081);
  a081=(a000*a081);
  a091=(a081-a093);
  a020=(a002*a091);
  a020=(a020+a029);
  a029=(a040*a003);
  a084=(a084-a029);
  a084=(a084-a088);
  a084=(a084+a045);
  a045=(a007*a084);
  a088=(a040*a010);
  a027=(a027-a088);
  a027=(a027-a079);
  a079=(a023*a010);
  a079=(a061-a079);
  a027=(a027-a079);
  a088=(a006*a027);
  a045=(a045+a088);
  a045=(a000*a045);
  a020=(a020+a045);
  a045=(a023*a015);
  a088=(2.*a023);
  a088=(a088+a079);
  a088=(a000*a088);
  a045=(a045+a088);
  a088=(a011*a045);
  a020=(a020-a088);
  if (res[0]!=0) res[0][1]=a020;
  a088=(a007*a027);
  a079=(a006*a084);
  a088=(a088-a079);
  a088=(a000*a088);
  a079=(a002*a045);
  a023=(a023*a014);
  a023=(a023*a017);
  a079=(a079+a023);
  a088=(a088-a079);
  a093=(a093-a081);
  a081=(a011*a093);
  a088=(a088+a081);
  a088=(a088-a072);
  a088=(a088/a020);
  if (res[0]!=0) res[0][2]=a088;
  a072=(a002-a007);
  a072=(a072+a014);
  if (res[0]!=0) res[0][3]=a072;
  a072=(a004*a024);
  a081=(a072*a024);
  a081=(a081*a014);
  a001=(a001-a081);
  a001=(a001-a065);
  a001=(a001+a068);
  a001=(a001-a071);
  a001=(a001+a097);
  a001=(a001+a032);
  a001=(a000*a001);
  a053=(a053+a001);
  a053=(a053-a073);
  a053=(a053+a074);
  a074=(a053/a019);
  a073=(a042*a053);
  a033=(a033-a073);
  a033=(a033/a046);
  a073=(a042*a033);
  a073=(a074-a073);
  if (res[0]!=0) res[0][4]=a073;
  a005=(a005-a013);
  if (res[0]!=0) res[0][5]=a005;
  a005=0.;
  if (res[0]!=0) res[0][6]=a005;
  a013=(a002*a024);
  a001=(a010*a013);
  a032=(a011*a024);
  a097=(a003*a032);
  a071=(a024-a026);
  a068=(a006*a071);
  a065=(a003*a068);
  a081=(a097+a065);
  a001=(a001-a081);
  a071=(a007*a071);
  a081=(a010*a071);
  a001=(a001+a081);
  a079=(a014*a055);
  a001=(a001-a079);
  a079=(2.*a013);
  a001=(a001-a079);
  a001=(a000*a001);
  a079=(a015*a024);
  a079=(a014*a079);
  a001=(a001-a079);
  a079=(a015*a013);
  a001=(a001-a079);
  a001=(a001/a017);
  a079=(-a032);
  a079=(2.*a079);
  a023=(a010*a032);
  a029=(a079+a023);
  a051=(a010*a068);
  a029=(a029+a051);
  a043=(a003*a013);
  a029=(a029+a043);
  a043=(a003*a071);
  a029=(a029+a043);
  a029=(a000*a029);
  a043=(a015*a032);
  a029=(a029-a043);
  a029=(a029/a017);
  a083=(a083*a029);
  a022=(a022*a073);
  a022=(a026*a022);
  a025=(a025*a033);
  a022=(a022+a025);
  a025=(a055*a073);
  a036=(a036*a025);
  a037=(a037*a026);
  a029=(a010*a037);
  a043=(a035*a026);
  a039=(a003*a043);
  a029=(a029+a039);
  a034=(a034*a029);
  a036=(a036+a034);
  a034=(a026-a024);
  a028=(a028*a034);
  a028=(a003*a028);
  a030=(a030*a034);
  a030=(a010*a030);
  a034=(a028+a030);
  a036=(a036-a034);
  a036=(a000*a036);
  a034=(a003*a037);
  a043=(a010*a043);
  a029=(a034-a043);
  a021=(a044*a071);
  a029=(a029-a021);
  a051=(a014*a051);
  a029=(a029-a051);
  a029=(a000*a029);
  a048=(a029/a047);
  a098=(a049/a047);
  a099=(a015*a079);
  a099=(a014*a099);
  a079=(a014*a079);
  a023=(a014*a023);
  a100=(a079+a023);
  a100=(a100+a043);
  a044=(a044*a013);
  a100=(a100+a044);
  a100=(a100-a034);
  a100=(a100+a021);
  a100=(a100+a051);
  a100=(a016*a100);
  a099=(a099+a100);
  a098=(a098*a099);
  a048=(a048-a098);
  a058=(a058*a048);
  a098=(a014*a025);
  a098=(a011*a098);
  a052=(a052*a013);
  a098=(a098+a052);
  a098=(a054*a098);
  a052=(2.*a073);
  a100=(a026*a052);
  a101=(a055*a033);
  a100=(a100+a101);
  a100=(a100-a025);
  a101=(2.*a026);
  a101=(a101*a033);
  a100=(a100-a101);
  a101=(a014*a100);
  a008=(a008*a101);
  a102=(a057*a065);
  a008=(a008-a102);
  a008=(a008+a028);
  a102=(a003*a073);
  a102=(a024*a102);
  a060=(a060*a073);
  a102=(a102+a060);
  a059=(a059*a102);
  a060=(a014*a032);
  a061=(a061*a060);
  a059=(a059-a061);
  a008=(a008-a059);
  a063=(a063*a024);
  a063=(a003*a063);
  a008=(a008+a063);
  a038=(a038*a033);
  a039=(a026*a039);
  a038=(a038-a039);
  a038=(a067*a038);
  a039=(a052-a033);
  a066=(a066*a039);
  a038=(a038+a066);
  a008=(a008+a038);
  a066=(a010*a033);
  a035=(a035*a066);
  a037=(a069*a037);
  a035=(a035+a037);
  a067=(a067*a035);
  a070=(a070*a039);
  a067=(a067+a070);
  a008=(a008-a067);
  a008=(a008+a030);
  a057=(a057*a081);
  a012=(a012*a101);
  a057=(a057+a012);
  a008=(a008+a057);
  a008=(a000*a008);
  a008=(a098+a008);
  a064=(a064*a024);
  a054=(a054*a064);
  a008=(a008+a054);
  a064=(a049*a008);
  a058=(a058+a064);
  a058=(a036-a058);
  a058=(a058/a076);
  a076=(a075/a076);
  a064=(a049*a029);
  a057=(a041*a048);
  a064=(a064+a057);
  a076=(a076*a064);
  a058=(a058+a076);
  a076=(a010*a058);
  a076=(a022-a076);
  a064=(a003*a033);
  a064=(a026*a064);
  a078=(a078*a033);
  a064=(a064+a078);
  a076=(a076-a064);
  a008=(a008/a047);
  a080=(a080/a047);
  a080=(a080*a099);
  a008=(a008-a080);
  a075=(a075*a048);
  a049=(a049*a058);
  a075=(a075+a049);
  a008=(a008-a075);
  a075=(a010*a008);
  a075=(a102-a075);
  a076=(a076-a075);
  a049=(a007*a076);
  a048=(a077*a068);
  a049=(a049-a048);
  a048=(a085*a071);
  a066=(a026*a066);
  a069=(a069*a033);
  a066=(a066+a069);
  a058=(a003*a058);
  a058=(a066-a058);
  a086=(a086*a073);
  a086=(a026*a086);
  a087=(a087*a033);
  a086=(a086+a087);
  a058=(a058-a086);
  a087=(a003*a008);
  a069=(a010*a073);
  a069=(a024*a069);
  a090=(a090*a073);
  a069=(a069+a090);
  a087=(a087+a069);
  a058=(a058+a087);
  a090=(a006*a058);
  a048=(a048+a090);
  a049=(a049-a048);
  a049=(a000*a049);
  a048=(a015*a008);
  a090=(2.*a008);
  a090=(a090+a075);
  a090=(a000*a090);
  a048=(a048+a090);
  a090=(a002*a048);
  a075=(a092*a032);
  a090=(a090-a075);
  a008=(a014*a008);
  a008=(a017*a008);
  a090=(a090+a008);
  a049=(a049-a090);
  a082=(a082*a013);
  a090=(a015*a025);
  a052=(a024*a052);
  a052=(a052+a025);
  a087=(a087-a052);
  a087=(a000*a087);
  a025=(a090-a087);
  a025=(a011*a025);
  a082=(a082+a025);
  a049=(a049+a082);
  a018=(a018*a049);
  a083=(a083+a018);
  a083=(a083/a095);
  a094=(a094/a095);
  a087=(a087-a090);
  a087=(a002*a087);
  a089=(a089*a032);
  a087=(a087-a089);
  a058=(a007*a058);
  a085=(a085*a068);
  a058=(a058-a085);
  a077=(a077*a071);
  a076=(a006*a076);
  a077=(a077+a076);
  a058=(a058+a077);
  a058=(a000*a058);
  a087=(a087+a058);
  a092=(a092*a013);
  a048=(a011*a048);
  a092=(a092+a048);
  a087=(a087-a092);
  a094=(a094*a087);
  a083=(a083-a094);
  a001=(a001-a083);
  a083=(a014*a024);
  a001=(a001+a083);
  a001=(-a001);
  if (res[1]!=0) res[1][0]=a001;
  a009=(a009*a100);
  a065=(a014*a065);
  a065=(a056*a065);
  a009=(a009-a065);
  a009=(a009+a028);
  a059=(a009-a059);
  a059=(a059+a063);
  a059=(a059+a038);
  a059=(a059-a067);
  a031=(a031*a071);
  a056=(a056*a031);
  a096=(a096*a100);
  a056=(a056+a096);
  a059=(a059+a056);
  a059=(a059+a030);
  a059=(a000*a059);
  a059=(a098+a059);
  a059=(a059+a054);
  a096=(a059/a019);
  a050=(a050/a019);
  a100=(a015*a079);
  a044=(a044+a023);
  a044=(a044+a043);
  a044=(a044-a034);
  a044=(a044+a079);
  a044=(a044+a021);
  a044=(a044+a051);
  a016=(a016*a044);
  a100=(a100+a016);
  a050=(a050*a100);
  a096=(a096-a050);
  a050=(a029/a019);
  a016=(a042/a019);
  a016=(a016*a100);
  a050=(a050-a016);
  a016=(a040*a050);
  a062=(a062*a050);
  a059=(a042*a059);
  a062=(a062+a059);
  a062=(a036-a062);
  a062=(a062/a046);
  a040=(a040/a046);
  a029=(a042*a029);
  a041=(a041*a050);
  a029=(a029+a041);
  a040=(a040*a029);
  a062=(a062+a040);
  a040=(a042*a062);
  a016=(a016+a040);
  a096=(a096-a016);
  a016=(a003*a096);
  a016=(a016+a069);
  a052=(a016-a052);
  a052=(a000*a052);
  a069=(a052-a090);
  a069=(a002*a069);
  a091=(a091*a032);
  a069=(a069-a091);
  a003=(a003*a062);
  a066=(a066-a003);
  a066=(a066-a086);
  a066=(a066+a016);
  a016=(a007*a066);
  a086=(a084*a068);
  a016=(a016-a086);
  a086=(a027*a071);
  a062=(a010*a062);
  a022=(a022-a062);
  a022=(a022-a064);
  a010=(a010*a096);
  a102=(a102-a010);
  a022=(a022-a102);
  a010=(a006*a022);
  a086=(a086+a010);
  a016=(a016+a086);
  a016=(a000*a016);
  a069=(a069+a016);
  a016=(a045*a013);
  a015=(a015*a096);
  a086=(2.*a096);
  a086=(a086+a102);
  a086=(a000*a086);
  a015=(a015+a086);
  a086=(a011*a015);
  a016=(a016+a086);
  a069=(a069-a016);
  if (res[1]!=0) res[1][1]=a069;
  a007=(a007*a022);
  a027=(a027*a068);
  a007=(a007-a027);
  a084=(a084*a071);
  a006=(a006*a066);
  a084=(a084+a006);
  a007=(a007-a084);
  a007=(a000*a007);
  a002=(a002*a015);
  a045=(a045*a032);
  a002=(a002-a045);
  a096=(a014*a096);
  a017=(a017*a096);
  a002=(a002+a017);
  a007=(a007-a002);
  a093=(a093*a013);
  a090=(a090-a052);
  a011=(a011*a090);
  a093=(a093+a011);
  a007=(a007+a093);
  a007=(a007/a020);
  a088=(a088/a020);
  a088=(a088*a069);
  a007=(a007-a088);
  if (res[1]!=0) res[1][2]=a007;
  a068=(a068-a032);
  if (res[1]!=0) res[1][3]=a068;
  a004=(a004*a073);
  a097=(a024*a097);
  a004=(a004-a097);
  a024=(a024*a004);
  a072=(a072*a073);
  a024=(a024+a072);
  a014=(a014*a024);
  a009=(a009-a014);
  a009=(a009+a063);
  a009=(a009+a038);
  a009=(a009-a067);
  a009=(a009+a056);
  a009=(a009+a030);
  a000=(a000*a009);
  a098=(a098+a000);
  a098=(a098+a054);
  a054=(a098/a019);
  a074=(a074/a019);
  a074=(a074*a100);
  a054=(a054-a074);
  a074=(a033*a050);
  a053=(a053*a050);
  a098=(a042*a098);
  a053=(a053+a098);
  a036=(a036-a053);
  a036=(a036/a046);
  a033=(a033/a046);
  a033=(a033*a029);
  a036=(a036+a033);
  a042=(a042*a036);
  a074=(a074+a042);
  a054=(a054-a074);
  if (res[1]!=0) res[1][4]=a054;
  a026=(a026-a055);
  if (res[1]!=0) res[1][5]=a026;
  if (res[1]!=0) res[1][6]=a005;
  return 0;
}

/* working_steps:(t,turns[2x12],w[4],h,p[7])->(w_end[4],nodes[4x12],g[7x12],dg[7x12]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+103, w01, *w02=w+107, *w03=w+114, w05, *w06=w+116, w07, *w08=w+120, *w09=w+124, *w10=w+128, *w11=w+132;
  casadi_real *w12=w+136, *w13=w+140, *w14=w+144, *w15=w+148, *w16=w+152, *w17=w+156, *w18=w+160, *w19=w+164, *w20=w+171, *w21=w+178, *w22=w+185, *w23=w+192;
  casadi_real *w24=w+199, *w25=w+206, *w26=w+213, *w27=w+220, *w28=w+227, *w29=w+234, *w30=w+241, *w31=w+248;
  const casadi_real **arg1=arg+5, *wr04;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 4, w00);
  /* #1: @1 = input[0][0] */
  w01 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 7, w02);
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
  casadi_copy(w19, 7, res[2]);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+7);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+14);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+21);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+28);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+35);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+42);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+49);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+56);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+63);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+70);
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
  if (res[2]) casadi_copy(w19, 7, res[2]+77);
  /* #126: output[3][0] = @20 */
  casadi_copy(w20, 7, res[3]);
  /* #127: output[3][1] = @21 */
  if (res[3]) casadi_copy(w21, 7, res[3]+7);
  /* #128: output[3][2] = @22 */
  if (res[3]) casadi_copy(w22, 7, res[3]+14);
  /* #129: output[3][3] = @23 */
  if (res[3]) casadi_copy(w23, 7, res[3]+21);
  /* #130: output[3][4] = @24 */
  if (res[3]) casadi_copy(w24, 7, res[3]+28);
  /* #131: output[3][5] = @25 */
  if (res[3]) casadi_copy(w25, 7, res[3]+35);
  /* #132: output[3][6] = @26 */
  if (res[3]) casadi_copy(w26, 7, res[3]+42);
  /* #133: output[3][7] = @27 */
  if (res[3]) casadi_copy(w27, 7, res[3]+49);
  /* #134: output[3][8] = @28 */
  if (res[3]) casadi_copy(w28, 7, res[3]+56);
  /* #135: output[3][9] = @29 */
  if (res[3]) casadi_copy(w29, 7, res[3]+63);
  /* #136: output[3][10] = @30 */
  if (res[3]) casadi_copy(w30, 7, res[3]+70);
  /* #137: output[3][11] = @31 */
  if (res[3]) casadi_copy(w31, 7, res[3]+77);
  return 0;
}

/* round_feet_trace_48:(u[4],p[7])->(w[4x49],g[7x49],dg[7x49],R[4]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1051;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #25: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #26: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #27: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #28: {@17, @18} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w17;
  res1[1]=w18;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 7, res[1]+336);
  /* #30: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #31: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #32: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #33: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #34: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 7, res[2]+336);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s7;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1058;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1058*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_72:(u[4],p[7])->(w[4x73],g[7x73],dg[7x73],R[4]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1128, *w19=w+1212, *w20=w+1296, *w21=w+1380;
  casadi_real *w22=w+1387;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #33: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #34: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #35: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #36: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 84, res[1]+336);
  /* #37: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 84, res[1]+420);
  /* #38: {@21, @22} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w21;
  res1[1]=w22;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #39: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 7, res[1]+504);
  /* #40: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #41: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #42: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #43: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #44: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 84, res[2]+336);
  /* #45: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 84, res[2]+420);
  /* #46: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 7, res[2]+504);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f90(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_72_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1394;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1394*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_96:(u[4],p[7])->(w[4x97],g[7x97],dg[7x97],R[4]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1128, *w19=w+1212, *w20=w+1296, *w21=w+1380;
  casadi_real *w22=w+1464, *w23=w+1548, *w24=w+1632, *w25=w+1716, *w26=w+1723;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #41: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #42: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #43: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #44: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 84, res[1]+336);
  /* #45: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 84, res[1]+420);
  /* #46: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 84, res[1]+504);
  /* #47: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 84, res[1]+588);
  /* #48: {@25, @26} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w25;
  res1[1]=w26;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #49: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 7, res[1]+672);
  /* #50: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #51: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #52: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #53: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #54: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 84, res[2]+336);
  /* #55: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 84, res[2]+420);
  /* #56: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 84, res[2]+504);
  /* #57: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 84, res[2]+588);
  /* #58: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 7, res[2]+672);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1730;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1730*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_144:(u[4],p[7])->(w[4x145],g[7x145],dg[7x145],R[4]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1128, *w19=w+1212, *w20=w+1296, *w21=w+1380;
  casadi_real *w22=w+1464, *w23=w+1548, *w24=w+1632, *w25=w+1716, *w26=w+1800, *w27=w+1884, *w28=w+1968, *w29=w+2052, *w30=w+2136, *w31=w+2220, *w32=w+2304, *w33=w+2388;
  casadi_real *w34=w+2395;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #57: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #58: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #59: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #60: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 84, res[1]+336);
  /* #61: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 84, res[1]+420);
  /* #62: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 84, res[1]+504);
  /* #63: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 84, res[1]+588);
  /* #64: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 84, res[1]+672);
  /* #65: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 84, res[1]+756);
  /* #66: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 84, res[1]+840);
  /* #67: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 84, res[1]+924);
  /* #68: {@33, @34} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w33;
  res1[1]=w34;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #69: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 7, res[1]+1008);
  /* #70: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #71: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #72: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #73: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #74: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 84, res[2]+336);
  /* #75: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 84, res[2]+420);
  /* #76: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 84, res[2]+504);
  /* #77: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 84, res[2]+588);
  /* #78: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 84, res[2]+672);
  /* #79: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 84, res[2]+756);
  /* #80: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 84, res[2]+840);
  /* #81: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 84, res[2]+924);
  /* #82: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 7, res[2]+1008);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_144_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2402;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2402*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_192:(u[4],p[7])->(w[4x193],g[7x193],dg[7x193],R[4]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1128, *w19=w+1212, *w20=w+1296, *w21=w+1380;
  casadi_real *w22=w+1464, *w23=w+1548, *w24=w+1632, *w25=w+1716, *w26=w+1800, *w27=w+1884, *w28=w+1968, *w29=w+2052, *w30=w+2136, *w31=w+2220, *w32=w+2304, *w33=w+2388;
  casadi_real *w34=w+2472, *w35=w+2556, *w36=w+2640, *w37=w+2724, *w38=w+2808, *w39=w+2892, *w40=w+2976, *w41=w+3060, *w42=w+3067;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #73: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #74: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #75: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #76: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 84, res[1]+336);
  /* #77: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 84, res[1]+420);
  /* #78: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 84, res[1]+504);
  /* #79: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 84, res[1]+588);
  /* #80: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 84, res[1]+672);
  /* #81: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 84, res[1]+756);
  /* #82: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 84, res[1]+840);
  /* #83: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 84, res[1]+924);
  /* #84: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 84, res[1]+1008);
  /* #85: output[1][13] = @35 */
  if (res[1]) casadi_copy(w35, 84, res[1]+1092);
  /* #86: output[1][14] = @37 */
  if (res[1]) casadi_copy(w37, 84, res[1]+1176);
  /* #87: output[1][15] = @39 */
  if (res[1]) casadi_copy(w39, 84, res[1]+1260);
  /* #88: {@41, @42} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w41;
  res1[1]=w42;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[1][16] = @41 */
  if (res[1]) casadi_copy(w41, 7, res[1]+1344);
  /* #90: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #91: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #92: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #93: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #94: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 84, res[2]+336);
  /* #95: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 84, res[2]+420);
  /* #96: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 84, res[2]+504);
  /* #97: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 84, res[2]+588);
  /* #98: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 84, res[2]+672);
  /* #99: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 84, res[2]+756);
  /* #100: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 84, res[2]+840);
  /* #101: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 84, res[2]+924);
  /* #102: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 84, res[2]+1008);
  /* #103: output[2][13] = @36 */
  if (res[2]) casadi_copy(w36, 84, res[2]+1092);
  /* #104: output[2][14] = @38 */
  if (res[2]) casadi_copy(w38, 84, res[2]+1176);
  /* #105: output[2][15] = @40 */
  if (res[2]) casadi_copy(w40, 84, res[2]+1260);
  /* #106: output[2][16] = @42 */
  if (res[2]) casadi_copy(w42, 7, res[2]+1344);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3074;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3074*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_288:(u[4],p[7])->(w[4x289],g[7x289],dg[7x289],R[4]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1128, *w19=w+1212, *w20=w+1296, *w21=w+1380;
  casadi_real *w22=w+1464, *w23=w+1548, *w24=w+1632, *w25=w+1716, *w26=w+1800, *w27=w+1884, *w28=w+1968, *w29=w+2052, *w30=w+2136, *w31=w+2220, *w32=w+2304, *w33=w+2388;
  casadi_real *w34=w+2472, *w35=w+2556, *w36=w+2640, *w37=w+2724, *w38=w+2808, *w39=w+2892, *w40=w+2976, *w41=w+3060, *w42=w+3144, *w43=w+3228, *w44=w+3312, *w45=w+3396;
  casadi_real *w46=w+3480, *w47=w+3564, *w48=w+3648, *w49=w+3732, *w50=w+3816, *w51=w+3900, *w52=w+3984, *w53=w+4068, *w54=w+4152, *w55=w+4236, *w56=w+4320, *w57=w+4404;
  casadi_real *w58=w+4411;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #105: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #106: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #107: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #108: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 84, res[1]+336);
  /* #109: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 84, res[1]+420);
  /* #110: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 84, res[1]+504);
  /* #111: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 84, res[1]+588);
  /* #112: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 84, res[1]+672);
  /* #113: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 84, res[1]+756);
  /* #114: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 84, res[1]+840);
  /* #115: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 84, res[1]+924);
  /* #116: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 84, res[1]+1008);
  /* #117: output[1][13] = @35 */
  if (res[1]) casadi_copy(w35, 84, res[1]+1092);
  /* #118: output[1][14] = @37 */
  if (res[1]) casadi_copy(w37, 84, res[1]+1176);
  /* #119: output[1][15] = @39 */
  if (res[1]) casadi_copy(w39, 84, res[1]+1260);
  /* #120: output[1][16] = @41 */
  if (res[1]) casadi_copy(w41, 84, res[1]+1344);
  /* #121: output[1][17] = @43 */
  if (res[1]) casadi_copy(w43, 84, res[1]+1428);
  /* #122: output[1][18] = @45 */
  if (res[1]) casadi_copy(w45, 84, res[1]+1512);
  /* #123: output[1][19] = @47 */
  if (res[1]) casadi_copy(w47, 84, res[1]+1596);
  /* #124: output[1][20] = @49 */
  if (res[1]) casadi_copy(w49, 84, res[1]+1680);
  /* #125: output[1][21] = @51 */
  if (res[1]) casadi_copy(w51, 84, res[1]+1764);
  /* #126: output[1][22] = @53 */
  if (res[1]) casadi_copy(w53, 84, res[1]+1848);
  /* #127: output[1][23] = @55 */
  if (res[1]) casadi_copy(w55, 84, res[1]+1932);
  /* #128: {@57, @58} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w57;
  res1[1]=w58;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #129: output[1][24] = @57 */
  if (res[1]) casadi_copy(w57, 7, res[1]+2016);
  /* #130: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #131: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #132: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #133: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #134: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 84, res[2]+336);
  /* #135: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 84, res[2]+420);
  /* #136: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 84, res[2]+504);
  /* #137: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 84, res[2]+588);
  /* #138: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 84, res[2]+672);
  /* #139: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 84, res[2]+756);
  /* #140: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 84, res[2]+840);
  /* #141: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 84, res[2]+924);
  /* #142: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 84, res[2]+1008);
  /* #143: output[2][13] = @36 */
  if (res[2]) casadi_copy(w36, 84, res[2]+1092);
  /* #144: output[2][14] = @38 */
  if (res[2]) casadi_copy(w38, 84, res[2]+1176);
  /* #145: output[2][15] = @40 */
  if (res[2]) casadi_copy(w40, 84, res[2]+1260);
  /* #146: output[2][16] = @42 */
  if (res[2]) casadi_copy(w42, 84, res[2]+1344);
  /* #147: output[2][17] = @44 */
  if (res[2]) casadi_copy(w44, 84, res[2]+1428);
  /* #148: output[2][18] = @46 */
  if (res[2]) casadi_copy(w46, 84, res[2]+1512);
  /* #149: output[2][19] = @48 */
  if (res[2]) casadi_copy(w48, 84, res[2]+1596);
  /* #150: output[2][20] = @50 */
  if (res[2]) casadi_copy(w50, 84, res[2]+1680);
  /* #151: output[2][21] = @52 */
  if (res[2]) casadi_copy(w52, 84, res[2]+1764);
  /* #152: output[2][22] = @54 */
  if (res[2]) casadi_copy(w54, 84, res[2]+1848);
  /* #153: output[2][23] = @56 */
  if (res[2]) casadi_copy(w56, 84, res[2]+1932);
  /* #154: output[2][24] = @58 */
  if (res[2]) casadi_copy(w58, 7, res[2]+2016);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_288_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s18;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 4418;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4418*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_384:(u[4],p[7])->(w[4x385],g[7x385],dg[7x385],R[4]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+282, w02, w03, *w04=w+286, *w05=w+293, *w06=w+317, *w07=w+320, *w08=w+324, *w09=w+372;
  casadi_real *w10=w+456, *w11=w+540, *w12=w+624, *w13=w+708, *w14=w+792, *w15=w+876, *w16=w+960, *w17=w+1044, *w18=w+1128, *w19=w+1212, *w20=w+1296, *w21=w+1380;
  casadi_real *w22=w+1464, *w23=w+1548, *w24=w+1632, *w25=w+1716, *w26=w+1800, *w27=w+1884, *w28=w+1968, *w29=w+2052, *w30=w+2136, *w31=w+2220, *w32=w+2304, *w33=w+2388;
  casadi_real *w34=w+2472, *w35=w+2556, *w36=w+2640, *w37=w+2724, *w38=w+2808, *w39=w+2892, *w40=w+2976, *w41=w+3060, *w42=w+3144, *w43=w+3228, *w44=w+3312, *w45=w+3396;
  casadi_real *w46=w+3480, *w47=w+3564, *w48=w+3648, *w49=w+3732, *w50=w+3816, *w51=w+3900, *w52=w+3984, *w53=w+4068, *w54=w+4152, *w55=w+4236, *w56=w+4320, *w57=w+4404;
  casadi_real *w58=w+4488, *w59=w+4572, *w60=w+4656, *w61=w+4740, *w62=w+4824, *w63=w+4908, *w64=w+4992, *w65=w+5076, *w66=w+5160, *w67=w+5244, *w68=w+5328, *w69=w+5412;
  casadi_real *w70=w+5496, *w71=w+5580, *w72=w+5664, *w73=w+5748, *w74=w+5755;
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
  casadi_copy(arg[1], 7, w04);
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
  casadi_copy(w09, 84, res[1]);
  /* #137: output[1][1] = @11 */
  if (res[1]) casadi_copy(w11, 84, res[1]+84);
  /* #138: output[1][2] = @13 */
  if (res[1]) casadi_copy(w13, 84, res[1]+168);
  /* #139: output[1][3] = @15 */
  if (res[1]) casadi_copy(w15, 84, res[1]+252);
  /* #140: output[1][4] = @17 */
  if (res[1]) casadi_copy(w17, 84, res[1]+336);
  /* #141: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 84, res[1]+420);
  /* #142: output[1][6] = @21 */
  if (res[1]) casadi_copy(w21, 84, res[1]+504);
  /* #143: output[1][7] = @23 */
  if (res[1]) casadi_copy(w23, 84, res[1]+588);
  /* #144: output[1][8] = @25 */
  if (res[1]) casadi_copy(w25, 84, res[1]+672);
  /* #145: output[1][9] = @27 */
  if (res[1]) casadi_copy(w27, 84, res[1]+756);
  /* #146: output[1][10] = @29 */
  if (res[1]) casadi_copy(w29, 84, res[1]+840);
  /* #147: output[1][11] = @31 */
  if (res[1]) casadi_copy(w31, 84, res[1]+924);
  /* #148: output[1][12] = @33 */
  if (res[1]) casadi_copy(w33, 84, res[1]+1008);
  /* #149: output[1][13] = @35 */
  if (res[1]) casadi_copy(w35, 84, res[1]+1092);
  /* #150: output[1][14] = @37 */
  if (res[1]) casadi_copy(w37, 84, res[1]+1176);
  /* #151: output[1][15] = @39 */
  if (res[1]) casadi_copy(w39, 84, res[1]+1260);
  /* #152: output[1][16] = @41 */
  if (res[1]) casadi_copy(w41, 84, res[1]+1344);
  /* #153: output[1][17] = @43 */
  if (res[1]) casadi_copy(w43, 84, res[1]+1428);
  /* #154: output[1][18] = @45 */
  if (res[1]) casadi_copy(w45, 84, res[1]+1512);
  /* #155: output[1][19] = @47 */
  if (res[1]) casadi_copy(w47, 84, res[1]+1596);
  /* #156: output[1][20] = @49 */
  if (res[1]) casadi_copy(w49, 84, res[1]+1680);
  /* #157: output[1][21] = @51 */
  if (res[1]) casadi_copy(w51, 84, res[1]+1764);
  /* #158: output[1][22] = @53 */
  if (res[1]) casadi_copy(w53, 84, res[1]+1848);
  /* #159: output[1][23] = @55 */
  if (res[1]) casadi_copy(w55, 84, res[1]+1932);
  /* #160: output[1][24] = @57 */
  if (res[1]) casadi_copy(w57, 84, res[1]+2016);
  /* #161: output[1][25] = @59 */
  if (res[1]) casadi_copy(w59, 84, res[1]+2100);
  /* #162: output[1][26] = @61 */
  if (res[1]) casadi_copy(w61, 84, res[1]+2184);
  /* #163: output[1][27] = @63 */
  if (res[1]) casadi_copy(w63, 84, res[1]+2268);
  /* #164: output[1][28] = @65 */
  if (res[1]) casadi_copy(w65, 84, res[1]+2352);
  /* #165: output[1][29] = @67 */
  if (res[1]) casadi_copy(w67, 84, res[1]+2436);
  /* #166: output[1][30] = @69 */
  if (res[1]) casadi_copy(w69, 84, res[1]+2520);
  /* #167: output[1][31] = @71 */
  if (res[1]) casadi_copy(w71, 84, res[1]+2604);
  /* #168: {@73, @74} = observe(@2, @1, @4) */
  arg1[0]=(&w02);
  arg1[1]=w01;
  arg1[2]=w04;
  res1[0]=w73;
  res1[1]=w74;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #169: output[1][32] = @73 */
  if (res[1]) casadi_copy(w73, 7, res[1]+2688);
  /* #170: output[2][0] = @10 */
  casadi_copy(w10, 84, res[2]);
  /* #171: output[2][1] = @12 */
  if (res[2]) casadi_copy(w12, 84, res[2]+84);
  /* #172: output[2][2] = @14 */
  if (res[2]) casadi_copy(w14, 84, res[2]+168);
  /* #173: output[2][3] = @16 */
  if (res[2]) casadi_copy(w16, 84, res[2]+252);
  /* #174: output[2][4] = @18 */
  if (res[2]) casadi_copy(w18, 84, res[2]+336);
  /* #175: output[2][5] = @20 */
  if (res[2]) casadi_copy(w20, 84, res[2]+420);
  /* #176: output[2][6] = @22 */
  if (res[2]) casadi_copy(w22, 84, res[2]+504);
  /* #177: output[2][7] = @24 */
  if (res[2]) casadi_copy(w24, 84, res[2]+588);
  /* #178: output[2][8] = @26 */
  if (res[2]) casadi_copy(w26, 84, res[2]+672);
  /* #179: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 84, res[2]+756);
  /* #180: output[2][10] = @30 */
  if (res[2]) casadi_copy(w30, 84, res[2]+840);
  /* #181: output[2][11] = @32 */
  if (res[2]) casadi_copy(w32, 84, res[2]+924);
  /* #182: output[2][12] = @34 */
  if (res[2]) casadi_copy(w34, 84, res[2]+1008);
  /* #183: output[2][13] = @36 */
  if (res[2]) casadi_copy(w36, 84, res[2]+1092);
  /* #184: output[2][14] = @38 */
  if (res[2]) casadi_copy(w38, 84, res[2]+1176);
  /* #185: output[2][15] = @40 */
  if (res[2]) casadi_copy(w40, 84, res[2]+1260);
  /* #186: output[2][16] = @42 */
  if (res[2]) casadi_copy(w42, 84, res[2]+1344);
  /* #187: output[2][17] = @44 */
  if (res[2]) casadi_copy(w44, 84, res[2]+1428);
  /* #188: output[2][18] = @46 */
  if (res[2]) casadi_copy(w46, 84, res[2]+1512);
  /* #189: output[2][19] = @48 */
  if (res[2]) casadi_copy(w48, 84, res[2]+1596);
  /* #190: output[2][20] = @50 */
  if (res[2]) casadi_copy(w50, 84, res[2]+1680);
  /* #191: output[2][21] = @52 */
  if (res[2]) casadi_copy(w52, 84, res[2]+1764);
  /* #192: output[2][22] = @54 */
  if (res[2]) casadi_copy(w54, 84, res[2]+1848);
  /* #193: output[2][23] = @56 */
  if (res[2]) casadi_copy(w56, 84, res[2]+1932);
  /* #194: output[2][24] = @58 */
  if (res[2]) casadi_copy(w58, 84, res[2]+2016);
  /* #195: output[2][25] = @60 */
  if (res[2]) casadi_copy(w60, 84, res[2]+2100);
  /* #196: output[2][26] = @62 */
  if (res[2]) casadi_copy(w62, 84, res[2]+2184);
  /* #197: output[2][27] = @64 */
  if (res[2]) casadi_copy(w64, 84, res[2]+2268);
  /* #198: output[2][28] = @66 */
  if (res[2]) casadi_copy(w66, 84, res[2]+2352);
  /* #199: output[2][29] = @68 */
  if (res[2]) casadi_copy(w68, 84, res[2]+2436);
  /* #200: output[2][30] = @70 */
  if (res[2]) casadi_copy(w70, 84, res[2]+2520);
  /* #201: output[2][31] = @72 */
  if (res[2]) casadi_copy(w72, 84, res[2]+2604);
  /* #202: output[2][32] = @74 */
  if (res[2]) casadi_copy(w74, 7, res[2]+2688);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s19;
    case 1: return casadi_s20;
    case 2: return casadi_s20;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 5762;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 5762*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_576:(u[4],p[7])->(w[4x577],g[7x577],dg[7x577],R[4]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+282, w002, w003, *w004=w+286, *w005=w+293, *w006=w+317, *w007=w+320, *w008=w+324, *w009=w+372;
  casadi_real *w010=w+456, *w011=w+540, *w012=w+624, *w013=w+708, *w014=w+792, *w015=w+876, *w016=w+960, *w017=w+1044, *w018=w+1128, *w019=w+1212, *w020=w+1296, *w021=w+1380;
  casadi_real *w022=w+1464, *w023=w+1548, *w024=w+1632, *w025=w+1716, *w026=w+1800, *w027=w+1884, *w028=w+1968, *w029=w+2052, *w030=w+2136, *w031=w+2220, *w032=w+2304, *w033=w+2388;
  casadi_real *w034=w+2472, *w035=w+2556, *w036=w+2640, *w037=w+2724, *w038=w+2808, *w039=w+2892, *w040=w+2976, *w041=w+3060, *w042=w+3144, *w043=w+3228, *w044=w+3312, *w045=w+3396;
  casadi_real *w046=w+3480, *w047=w+3564, *w048=w+3648, *w049=w+3732, *w050=w+3816, *w051=w+3900, *w052=w+3984, *w053=w+4068, *w054=w+4152, *w055=w+4236, *w056=w+4320, *w057=w+4404;
  casadi_real *w058=w+4488, *w059=w+4572, *w060=w+4656, *w061=w+4740, *w062=w+4824, *w063=w+4908, *w064=w+4992, *w065=w+5076, *w066=w+5160, *w067=w+5244, *w068=w+5328, *w069=w+5412;
  casadi_real *w070=w+5496, *w071=w+5580, *w072=w+5664, *w073=w+5748, *w074=w+5832, *w075=w+5916, *w076=w+6000, *w077=w+6084, *w078=w+6168, *w079=w+6252, *w080=w+6336, *w081=w+6420;
  casadi_real *w082=w+6504, *w083=w+6588, *w084=w+6672, *w085=w+6756, *w086=w+6840, *w087=w+6924, *w088=w+7008, *w089=w+7092, *w090=w+7176, *w091=w+7260, *w092=w+7344, *w093=w+7428;
  casadi_real *w094=w+7512, *w095=w+7596, *w096=w+7680, *w097=w+7764, *w098=w+7848, *w099=w+7932, *w100=w+8016, *w101=w+8100, *w102=w+8184, *w103=w+8268, *w104=w+8352, *w105=w+8436;
  casadi_real *w106=w+8443;
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
  casadi_copy(arg[1], 7, w004);
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
  casadi_copy(w009, 84, res[1]);
  /* #201: output[1][1] = @11 */
  if (res[1]) casadi_copy(w011, 84, res[1]+84);
  /* #202: output[1][2] = @13 */
  if (res[1]) casadi_copy(w013, 84, res[1]+168);
  /* #203: output[1][3] = @15 */
  if (res[1]) casadi_copy(w015, 84, res[1]+252);
  /* #204: output[1][4] = @17 */
  if (res[1]) casadi_copy(w017, 84, res[1]+336);
  /* #205: output[1][5] = @19 */
  if (res[1]) casadi_copy(w019, 84, res[1]+420);
  /* #206: output[1][6] = @21 */
  if (res[1]) casadi_copy(w021, 84, res[1]+504);
  /* #207: output[1][7] = @23 */
  if (res[1]) casadi_copy(w023, 84, res[1]+588);
  /* #208: output[1][8] = @25 */
  if (res[1]) casadi_copy(w025, 84, res[1]+672);
  /* #209: output[1][9] = @27 */
  if (res[1]) casadi_copy(w027, 84, res[1]+756);
  /* #210: output[1][10] = @29 */
  if (res[1]) casadi_copy(w029, 84, res[1]+840);
  /* #211: output[1][11] = @31 */
  if (res[1]) casadi_copy(w031, 84, res[1]+924);
  /* #212: output[1][12] = @33 */
  if (res[1]) casadi_copy(w033, 84, res[1]+1008);
  /* #213: output[1][13] = @35 */
  if (res[1]) casadi_copy(w035, 84, res[1]+1092);
  /* #214: output[1][14] = @37 */
  if (res[1]) casadi_copy(w037, 84, res[1]+1176);
  /* #215: output[1][15] = @39 */
  if (res[1]) casadi_copy(w039, 84, res[1]+1260);
  /* #216: output[1][16] = @41 */
  if (res[1]) casadi_copy(w041, 84, res[1]+1344);
  /* #217: output[1][17] = @43 */
  if (res[1]) casadi_copy(w043, 84, res[1]+1428);
  /* #218: output[1][18] = @45 */
  if (res[1]) casadi_copy(w045, 84, res[1]+1512);
  /* #219: output[1][19] = @47 */
  if (res[1]) casadi_copy(w047, 84, res[1]+1596);
  /* #220: output[1][20] = @49 */
  if (res[1]) casadi_copy(w049, 84, res[1]+1680);
  /* #221: output[1][21] = @51 */
  if (res[1]) casadi_copy(w051, 84, res[1]+1764);
  /* #222: output[1][22] = @53 */
  if (res[1]) casadi_copy(w053, 84, res[1]+1848);
  /* #223: output[1][23] = @55 */
  if (res[1]) casadi_copy(w055, 84, res[1]+1932);
  /* #224: output[1][24] = @57 */
  if (res[1]) casadi_copy(w057, 84, res[1]+2016);
  /* #225: output[1][25] = @59 */
  if (res[1]) casadi_copy(w059, 84, res[1]+2100);
  /* #226: output[1][26] = @61 */
  if (res[1]) casadi_copy(w061, 84, res[1]+2184);
  /* #227: output[1][27] = @63 */
  if (res[1]) casadi_copy(w063, 84, res[1]+2268);
  /* #228: output[1][28] = @65 */
  if (res[1]) casadi_copy(w065, 84, res[1]+2352);
  /* #229: output[1][29] = @67 */
  if (res[1]) casadi_copy(w067, 84, res[1]+2436);
  /* #230: output[1][30] = @69 */
  if (res[1]) casadi_copy(w069, 84, res[1]+2520);
  /* #231: output[1][31] = @71 */
  if (res[1]) casadi_copy(w071, 84, res[1]+2604);
  /* #232: output[1][32] = @73 */
  if (res[1]) casadi_copy(w073, 84, res[1]+2688);
  /* #233: output[1][33] = @75 */
  if (res[1]) casadi_copy(w075, 84, res[1]+2772);
  /* #234: output[1][34] = @77 */
  if (res[1]) casadi_copy(w077, 84, res[1]+2856);
  /* #235: output[1][35] = @79 */
  if (res[1]) casadi_copy(w079, 84, res[1]+2940);
  /* #236: output[1][36] = @81 */
  if (res[1]) casadi_copy(w081, 84, res[1]+3024);
  /* #237: output[1][37] = @83 */
  if (res[1]) casadi_copy(w083, 84, res[1]+3108);
  /* #238: output[1][38] = @85 */
  if (res[1]) casadi_copy(w085, 84, res[1]+3192);
  /* #239: output[1][39] = @87 */
  if (res[1]) casadi_copy(w087, 84, res[1]+3276);
  /* #240: output[1][40] = @89 */
  if (res[1]) casadi_copy(w089, 84, res[1]+3360);
  /* #241: output[1][41] = @91 */
  if (res[1]) casadi_copy(w091, 84, res[1]+3444);
  /* #242: output[1][42] = @93 */
  if (res[1]) casadi_copy(w093, 84, res[1]+3528);
  /* #243: output[1][43] = @95 */
  if (res[1]) casadi_copy(w095, 84, res[1]+3612);
  /* #244: output[1][44] = @97 */
  if (res[1]) casadi_copy(w097, 84, res[1]+3696);
  /* #245: output[1][45] = @99 */
  if (res[1]) casadi_copy(w099, 84, res[1]+3780);
  /* #246: output[1][46] = @101 */
  if (res[1]) casadi_copy(w101, 84, res[1]+3864);
  /* #247: output[1][47] = @103 */
  if (res[1]) casadi_copy(w103, 84, res[1]+3948);
  /* #248: {@105, @106} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=w004;
  res1[0]=w105;
  res1[1]=w106;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #249: output[1][48] = @105 */
  if (res[1]) casadi_copy(w105, 7, res[1]+4032);
  /* #250: output[2][0] = @10 */
  casadi_copy(w010, 84, res[2]);
  /* #251: output[2][1] = @12 */
  if (res[2]) casadi_copy(w012, 84, res[2]+84);
  /* #252: output[2][2] = @14 */
  if (res[2]) casadi_copy(w014, 84, res[2]+168);
  /* #253: output[2][3] = @16 */
  if (res[2]) casadi_copy(w016, 84, res[2]+252);
  /* #254: output[2][4] = @18 */
  if (res[2]) casadi_copy(w018, 84, res[2]+336);
  /* #255: output[2][5] = @20 */
  if (res[2]) casadi_copy(w020, 84, res[2]+420);
  /* #256: output[2][6] = @22 */
  if (res[2]) casadi_copy(w022, 84, res[2]+504);
  /* #257: output[2][7] = @24 */
  if (res[2]) casadi_copy(w024, 84, res[2]+588);
  /* #258: output[2][8] = @26 */
  if (res[2]) casadi_copy(w026, 84, res[2]+672);
  /* #259: output[2][9] = @28 */
  if (res[2]) casadi_copy(w028, 84, res[2]+756);
  /* #260: output[2][10] = @30 */
  if (res[2]) casadi_copy(w030, 84, res[2]+840);
  /* #261: output[2][11] = @32 */
  if (res[2]) casadi_copy(w032, 84, res[2]+924);
  /* #262: output[2][12] = @34 */
  if (res[2]) casadi_copy(w034, 84, res[2]+1008);
  /* #263: output[2][13] = @36 */
  if (res[2]) casadi_copy(w036, 84, res[2]+1092);
  /* #264: output[2][14] = @38 */
  if (res[2]) casadi_copy(w038, 84, res[2]+1176);
  /* #265: output[2][15] = @40 */
  if (res[2]) casadi_copy(w040, 84, res[2]+1260);
  /* #266: output[2][16] = @42 */
  if (res[2]) casadi_copy(w042, 84, res[2]+1344);
  /* #267: output[2][17] = @44 */
  if (res[2]) casadi_copy(w044, 84, res[2]+1428);
  /* #268: output[2][18] = @46 */
  if (res[2]) casadi_copy(w046, 84, res[2]+1512);
  /* #269: output[2][19] = @48 */
  if (res[2]) casadi_copy(w048, 84, res[2]+1596);
  /* #270: output[2][20] = @50 */
  if (res[2]) casadi_copy(w050, 84, res[2]+1680);
  /* #271: output[2][21] = @52 */
  if (res[2]) casadi_copy(w052, 84, res[2]+1764);
  /* #272: output[2][22] = @54 */
  if (res[2]) casadi_copy(w054, 84, res[2]+1848);
  /* #273: output[2][23] = @56 */
  if (res[2]) casadi_copy(w056, 84, res[2]+1932);
  /* #274: output[2][24] = @58 */
  if (res[2]) casadi_copy(w058, 84, res[2]+2016);
  /* #275: output[2][25] = @60 */
  if (res[2]) casadi_copy(w060, 84, res[2]+2100);
  /* #276: output[2][26] = @62 */
  if (res[2]) casadi_copy(w062, 84, res[2]+2184);
  /* #277: output[2][27] = @64 */
  if (res[2]) casadi_copy(w064, 84, res[2]+2268);
  /* #278: output[2][28] = @66 */
  if (res[2]) casadi_copy(w066, 84, res[2]+2352);
  /* #279: output[2][29] = @68 */
  if (res[2]) casadi_copy(w068, 84, res[2]+2436);
  /* #280: output[2][30] = @70 */
  if (res[2]) casadi_copy(w070, 84, res[2]+2520);
  /* #281: output[2][31] = @72 */
  if (res[2]) casadi_copy(w072, 84, res[2]+2604);
  /* #282: output[2][32] = @74 */
  if (res[2]) casadi_copy(w074, 84, res[2]+2688);
  /* #283: output[2][33] = @76 */
  if (res[2]) casadi_copy(w076, 84, res[2]+2772);
  /* #284: output[2][34] = @78 */
  if (res[2]) casadi_copy(w078, 84, res[2]+2856);
  /* #285: output[2][35] = @80 */
  if (res[2]) casadi_copy(w080, 84, res[2]+2940);
  /* #286: output[2][36] = @82 */
  if (res[2]) casadi_copy(w082, 84, res[2]+3024);
  /* #287: output[2][37] = @84 */
  if (res[2]) casadi_copy(w084, 84, res[2]+3108);
  /* #288: output[2][38] = @86 */
  if (res[2]) casadi_copy(w086, 84, res[2]+3192);
  /* #289: output[2][39] = @88 */
  if (res[2]) casadi_copy(w088, 84, res[2]+3276);
  /* #290: output[2][40] = @90 */
  if (res[2]) casadi_copy(w090, 84, res[2]+3360);
  /* #291: output[2][41] = @92 */
  if (res[2]) casadi_copy(w092, 84, res[2]+3444);
  /* #292: output[2][42] = @94 */
  if (res[2]) casadi_copy(w094, 84, res[2]+3528);
  /* #293: output[2][43] = @96 */
  if (res[2]) casadi_copy(w096, 84, res[2]+3612);
  /* #294: output[2][44] = @98 */
  if (res[2]) casadi_copy(w098, 84, res[2]+3696);
  /* #295: output[2][45] = @100 */
  if (res[2]) casadi_copy(w100, 84, res[2]+3780);
  /* #296: output[2][46] = @102 */
  if (res[2]) casadi_copy(w102, 84, res[2]+3864);
  /* #297: output[2][47] = @104 */
  if (res[2]) casadi_copy(w104, 84, res[2]+3948);
  /* #298: output[2][48] = @106 */
  if (res[2]) casadi_copy(w106, 7, res[2]+4032);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_576_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_576_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_576_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_576_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_576_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_576_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_576_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_576_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_576_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_576_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_576_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s21;
    case 1: return casadi_s22;
    case 2: return casadi_s22;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_576_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 8450;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8450*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_768:(u[4],p[7])->(w[4x769],g[7x769],dg[7x769],R[4]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+282, w002, w003, *w004=w+286, *w005=w+293, *w006=w+317, *w007=w+320, *w008=w+324, *w009=w+372;
  casadi_real *w010=w+456, *w011=w+540, *w012=w+624, *w013=w+708, *w014=w+792, *w015=w+876, *w016=w+960, *w017=w+1044, *w018=w+1128, *w019=w+1212, *w020=w+1296, *w021=w+1380;
  casadi_real *w022=w+1464, *w023=w+1548, *w024=w+1632, *w025=w+1716, *w026=w+1800, *w027=w+1884, *w028=w+1968, *w029=w+2052, *w030=w+2136, *w031=w+2220, *w032=w+2304, *w033=w+2388;
  casadi_real *w034=w+2472, *w035=w+2556, *w036=w+2640, *w037=w+2724, *w038=w+2808, *w039=w+2892, *w040=w+2976, *w041=w+3060, *w042=w+3144, *w043=w+3228, *w044=w+3312, *w045=w+3396;
  casadi_real *w046=w+3480, *w047=w+3564, *w048=w+3648, *w049=w+3732, *w050=w+3816, *w051=w+3900, *w052=w+3984, *w053=w+4068, *w054=w+4152, *w055=w+4236, *w056=w+4320, *w057=w+4404;
  casadi_real *w058=w+4488, *w059=w+4572, *w060=w+4656, *w061=w+4740, *w062=w+4824, *w063=w+4908, *w064=w+4992, *w065=w+5076, *w066=w+5160, *w067=w+5244, *w068=w+5328, *w069=w+5412;
  casadi_real *w070=w+5496, *w071=w+5580, *w072=w+5664, *w073=w+5748, *w074=w+5832, *w075=w+5916, *w076=w+6000, *w077=w+6084, *w078=w+6168, *w079=w+6252, *w080=w+6336, *w081=w+6420;
  casadi_real *w082=w+6504, *w083=w+6588, *w084=w+6672, *w085=w+6756, *w086=w+6840, *w087=w+6924, *w088=w+7008, *w089=w+7092, *w090=w+7176, *w091=w+7260, *w092=w+7344, *w093=w+7428;
  casadi_real *w094=w+7512, *w095=w+7596, *w096=w+7680, *w097=w+7764, *w098=w+7848, *w099=w+7932, *w100=w+8016, *w101=w+8100, *w102=w+8184, *w103=w+8268, *w104=w+8352, *w105=w+8436;
  casadi_real *w106=w+8520, *w107=w+8604, *w108=w+8688, *w109=w+8772, *w110=w+8856, *w111=w+8940, *w112=w+9024, *w113=w+9108, *w114=w+9192, *w115=w+9276, *w116=w+9360, *w117=w+9444;
  casadi_real *w118=w+9528, *w119=w+9612, *w120=w+9696, *w121=w+9780, *w122=w+9864, *w123=w+9948, *w124=w+10032, *w125=w+10116, *w126=w+10200, *w127=w+10284, *w128=w+10368, *w129=w+10452;
  casadi_real *w130=w+10536, *w131=w+10620, *w132=w+10704, *w133=w+10788, *w134=w+10872, *w135=w+10956, *w136=w+11040, *w137=w+11124, *w138=w+11131;
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
  casadi_copy(arg[1], 7, w004);
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
  casadi_copy(w009, 84, res[1]);
  /* #265: output[1][1] = @11 */
  if (res[1]) casadi_copy(w011, 84, res[1]+84);
  /* #266: output[1][2] = @13 */
  if (res[1]) casadi_copy(w013, 84, res[1]+168);
  /* #267: output[1][3] = @15 */
  if (res[1]) casadi_copy(w015, 84, res[1]+252);
  /* #268: output[1][4] = @17 */
  if (res[1]) casadi_copy(w017, 84, res[1]+336);
  /* #269: output[1][5] = @19 */
  if (res[1]) casadi_copy(w019, 84, res[1]+420);
  /* #270: output[1][6] = @21 */
  if (res[1]) casadi_copy(w021, 84, res[1]+504);
  /* #271: output[1][7] = @23 */
  if (res[1]) casadi_copy(w023, 84, res[1]+588);
  /* #272: output[1][8] = @25 */
  if (res[1]) casadi_copy(w025, 84, res[1]+672);
  /* #273: output[1][9] = @27 */
  if (res[1]) casadi_copy(w027, 84, res[1]+756);
  /* #274: output[1][10] = @29 */
  if (res[1]) casadi_copy(w029, 84, res[1]+840);
  /* #275: output[1][11] = @31 */
  if (res[1]) casadi_copy(w031, 84, res[1]+924);
  /* #276: output[1][12] = @33 */
  if (res[1]) casadi_copy(w033, 84, res[1]+1008);
  /* #277: output[1][13] = @35 */
  if (res[1]) casadi_copy(w035, 84, res[1]+1092);
  /* #278: output[1][14] = @37 */
  if (res[1]) casadi_copy(w037, 84, res[1]+1176);
  /* #279: output[1][15] = @39 */
  if (res[1]) casadi_copy(w039, 84, res[1]+1260);
  /* #280: output[1][16] = @41 */
  if (res[1]) casadi_copy(w041, 84, res[1]+1344);
  /* #281: output[1][17] = @43 */
  if (res[1]) casadi_copy(w043, 84, res[1]+1428);
  /* #282: output[1][18] = @45 */
  if (res[1]) casadi_copy(w045, 84, res[1]+1512);
  /* #283: output[1][19] = @47 */
  if (res[1]) casadi_copy(w047, 84, res[1]+1596);
  /* #284: output[1][20] = @49 */
  if (res[1]) casadi_copy(w049, 84, res[1]+1680);
  /* #285: output[1][21] = @51 */
  if (res[1]) casadi_copy(w051, 84, res[1]+1764);
  /* #286: output[1][22] = @53 */
  if (res[1]) casadi_copy(w053, 84, res[1]+1848);
  /* #287: output[1][23] = @55 */
  if (res[1]) casadi_copy(w055, 84, res[1]+1932);
  /* #288: output[1][24] = @57 */
  if (res[1]) casadi_copy(w057, 84, res[1]+2016);
  /* #289: output[1][25] = @59 */
  if (res[1]) casadi_copy(w059, 84, res[1]+2100);
  /* #290: output[1][26] = @61 */
  if (res[1]) casadi_copy(w061, 84, res[1]+2184);
  /* #291: output[1][27] = @63 */
  if (res[1]) casadi_copy(w063, 84, res[1]+2268);
  /* #292: output[1][28] = @65 */
  if (res[1]) casadi_copy(w065, 84, res[1]+2352);
  /* #293: output[1][29] = @67 */
  if (res[1]) casadi_copy(w067, 84, res[1]+2436);
  /* #294: output[1][30] = @69 */
  if (res[1]) casadi_copy(w069, 84, res[1]+2520);
  /* #295: output[1][31] = @71 */
  if (res[1]) casadi_copy(w071, 84, res[1]+2604);
  /* #296: output[1][32] = @73 */
  if (res[1]) casadi_copy(w073, 84, res[1]+2688);
  /* #297: output[1][33] = @75 */
  if (res[1]) casadi_copy(w075, 84, res[1]+2772);
  /* #298: output[1][34] = @77 */
  if (res[1]) casadi_copy(w077, 84, res[1]+2856);
  /* #299: output[1][35] = @79 */
  if (res[1]) casadi_copy(w079, 84, res[1]+2940);
  /* #300: output[1][36] = @81 */
  if (res[1]) casadi_copy(w081, 84, res[1]+3024);
  /* #301: output[1][37] = @83 */
  if (res[1]) casadi_copy(w083, 84, res[1]+3108);
  /* #302: output[1][38] = @85 */
  if (res[1]) casadi_copy(w085, 84, res[1]+3192);
  /* #303: output[1][39] = @87 */
  if (res[1]) casadi_copy(w087, 84, res[1]+3276);
  /* #304: output[1][40] = @89 */
  if (res[1]) casadi_copy(w089, 84, res[1]+3360);
  /* #305: output[1][41] = @91 */
  if (res[1]) casadi_copy(w091, 84, res[1]+3444);
  /* #306: output[1][42] = @93 */
  if (res[1]) casadi_copy(w093, 84, res[1]+3528);
  /* #307: output[1][43] = @95 */
  if (res[1]) casadi_copy(w095, 84, res[1]+3612);
  /* #308: output[1][44] = @97 */
  if (res[1]) casadi_copy(w097, 84, res[1]+3696);
  /* #309: output[1][45] = @99 */
  if (res[1]) casadi_copy(w099, 84, res[1]+3780);
  /* #310: output[1][46] = @101 */
  if (res[1]) casadi_copy(w101, 84, res[1]+3864);
  /* #311: output[1][47] = @103 */
  if (res[1]) casadi_copy(w103, 84, res[1]+3948);
  /* #312: output[1][48] = @105 */
  if (res[1]) casadi_copy(w105, 84, res[1]+4032);
  /* #313: output[1][49] = @107 */
  if (res[1]) casadi_copy(w107, 84, res[1]+4116);
  /* #314: output[1][50] = @109 */
  if (res[1]) casadi_copy(w109, 84, res[1]+4200);
  /* #315: output[1][51] = @111 */
  if (res[1]) casadi_copy(w111, 84, res[1]+4284);
  /* #316: output[1][52] = @113 */
  if (res[1]) casadi_copy(w113, 84, res[1]+4368);
  /* #317: output[1][53] = @115 */
  if (res[1]) casadi_copy(w115, 84, res[1]+4452);
  /* #318: output[1][54] = @117 */
  if (res[1]) casadi_copy(w117, 84, res[1]+4536);
  /* #319: output[1][55] = @119 */
  if (res[1]) casadi_copy(w119, 84, res[1]+4620);
  /* #320: output[1][56] = @121 */
  if (res[1]) casadi_copy(w121, 84, res[1]+4704);
  /* #321: output[1][57] = @123 */
  if (res[1]) casadi_copy(w123, 84, res[1]+4788);
  /* #322: output[1][58] = @125 */
  if (res[1]) casadi_copy(w125, 84, res[1]+4872);
  /* #323: output[1][59] = @127 */
  if (res[1]) casadi_copy(w127, 84, res[1]+4956);
  /* #324: output[1][60] = @129 */
  if (res[1]) casadi_copy(w129, 84, res[1]+5040);
  /* #325: output[1][61] = @131 */
  if (res[1]) casadi_copy(w131, 84, res[1]+5124);
  /* #326: output[1][62] = @133 */
  if (res[1]) casadi_copy(w133, 84, res[1]+5208);
  /* #327: output[1][63] = @135 */
  if (res[1]) casadi_copy(w135, 84, res[1]+5292);
  /* #328: {@137, @138} = observe(@2, @1, @4) */
  arg1[0]=(&w002);
  arg1[1]=w001;
  arg1[2]=w004;
  res1[0]=w137;
  res1[1]=w138;
  if (casadi_f89(arg1, res1, iw, w, 0)) return 1;
  /* #329: output[1][64] = @137 */
  if (res[1]) casadi_copy(w137, 7, res[1]+5376);
  /* #330: output[2][0] = @10 */
  casadi_copy(w010, 84, res[2]);
  /* #331: output[2][1] = @12 */
  if (res[2]) casadi_copy(w012, 84, res[2]+84);
  /* #332: output[2][2] = @14 */
  if (res[2]) casadi_copy(w014, 84, res[2]+168);
  /* #333: output[2][3] = @16 */
  if (res[2]) casadi_copy(w016, 84, res[2]+252);
  /* #334: output[2][4] = @18 */
  if (res[2]) casadi_copy(w018, 84, res[2]+336);
  /* #335: output[2][5] = @20 */
  if (res[2]) casadi_copy(w020, 84, res[2]+420);
  /* #336: output[2][6] = @22 */
  if (res[2]) casadi_copy(w022, 84, res[2]+504);
  /* #337: output[2][7] = @24 */
  if (res[2]) casadi_copy(w024, 84, res[2]+588);
  /* #338: output[2][8] = @26 */
  if (res[2]) casadi_copy(w026, 84, res[2]+672);
  /* #339: output[2][9] = @28 */
  if (res[2]) casadi_copy(w028, 84, res[2]+756);
  /* #340: output[2][10] = @30 */
  if (res[2]) casadi_copy(w030, 84, res[2]+840);
  /* #341: output[2][11] = @32 */
  if (res[2]) casadi_copy(w032, 84, res[2]+924);
  /* #342: output[2][12] = @34 */
  if (res[2]) casadi_copy(w034, 84, res[2]+1008);
  /* #343: output[2][13] = @36 */
  if (res[2]) casadi_copy(w036, 84, res[2]+1092);
  /* #344: output[2][14] = @38 */
  if (res[2]) casadi_copy(w038, 84, res[2]+1176);
  /* #345: output[2][15] = @40 */
  if (res[2]) casadi_copy(w040, 84, res[2]+1260);
  /* #346: output[2][16] = @42 */
  if (res[2]) casadi_copy(w042, 84, res[2]+1344);
  /* #347: output[2][17] = @44 */
  if (res[2]) casadi_copy(w044, 84, res[2]+1428);
  /* #348: output[2][18] = @46 */
  if (res[2]) casadi_copy(w046, 84, res[2]+1512);
  /* #349: output[2][19] = @48 */
  if (res[2]) casadi_copy(w048, 84, res[2]+1596);
  /* #350: output[2][20] = @50 */
  if (res[2]) casadi_copy(w050, 84, res[2]+1680);
  /* #351: output[2][21] = @52 */
  if (res[2]) casadi_copy(w052, 84, res[2]+1764);
  /* #352: output[2][22] = @54 */
  if (res[2]) casadi_copy(w054, 84, res[2]+1848);
  /* #353: output[2][23] = @56 */
  if (res[2]) casadi_copy(w056, 84, res[2]+1932);
  /* #354: output[2][24] = @58 */
  if (res[2]) casadi_copy(w058, 84, res[2]+2016);
  /* #355: output[2][25] = @60 */
  if (res[2]) casadi_copy(w060, 84, res[2]+2100);
  /* #356: output[2][26] = @62 */
  if (res[2]) casadi_copy(w062, 84, res[2]+2184);
  /* #357: output[2][27] = @64 */
  if (res[2]) casadi_copy(w064, 84, res[2]+2268);
  /* #358: output[2][28] = @66 */
  if (res[2]) casadi_copy(w066, 84, res[2]+2352);
  /* #359: output[2][29] = @68 */
  if (res[2]) casadi_copy(w068, 84, res[2]+2436);
  /* #360: output[2][30] = @70 */
  if (res[2]) casadi_copy(w070, 84, res[2]+2520);
  /* #361: output[2][31] = @72 */
  if (res[2]) casadi_copy(w072, 84, res[2]+2604);
  /* #362: output[2][32] = @74 */
  if (res[2]) casadi_copy(w074, 84, res[2]+2688);
  /* #363: output[2][33] = @76 */
  if (res[2]) casadi_copy(w076, 84, res[2]+2772);
  /* #364: output[2][34] = @78 */
  if (res[2]) casadi_copy(w078, 84, res[2]+2856);
  /* #365: output[2][35] = @80 */
  if (res[2]) casadi_copy(w080, 84, res[2]+2940);
  /* #366: output[2][36] = @82 */
  if (res[2]) casadi_copy(w082, 84, res[2]+3024);
  /* #367: output[2][37] = @84 */
  if (res[2]) casadi_copy(w084, 84, res[2]+3108);
  /* #368: output[2][38] = @86 */
  if (res[2]) casadi_copy(w086, 84, res[2]+3192);
  /* #369: output[2][39] = @88 */
  if (res[2]) casadi_copy(w088, 84, res[2]+3276);
  /* #370: output[2][40] = @90 */
  if (res[2]) casadi_copy(w090, 84, res[2]+3360);
  /* #371: output[2][41] = @92 */
  if (res[2]) casadi_copy(w092, 84, res[2]+3444);
  /* #372: output[2][42] = @94 */
  if (res[2]) casadi_copy(w094, 84, res[2]+3528);
  /* #373: output[2][43] = @96 */
  if (res[2]) casadi_copy(w096, 84, res[2]+3612);
  /* #374: output[2][44] = @98 */
  if (res[2]) casadi_copy(w098, 84, res[2]+3696);
  /* #375: output[2][45] = @100 */
  if (res[2]) casadi_copy(w100, 84, res[2]+3780);
  /* #376: output[2][46] = @102 */
  if (res[2]) casadi_copy(w102, 84, res[2]+3864);
  /* #377: output[2][47] = @104 */
  if (res[2]) casadi_copy(w104, 84, res[2]+3948);
  /* #378: output[2][48] = @106 */
  if (res[2]) casadi_copy(w106, 84, res[2]+4032);
  /* #379: output[2][49] = @108 */
  if (res[2]) casadi_copy(w108, 84, res[2]+4116);
  /* #380: output[2][50] = @110 */
  if (res[2]) casadi_copy(w110, 84, res[2]+4200);
  /* #381: output[2][51] = @112 */
  if (res[2]) casadi_copy(w112, 84, res[2]+4284);
  /* #382: output[2][52] = @114 */
  if (res[2]) casadi_copy(w114, 84, res[2]+4368);
  /* #383: output[2][53] = @116 */
  if (res[2]) casadi_copy(w116, 84, res[2]+4452);
  /* #384: output[2][54] = @118 */
  if (res[2]) casadi_copy(w118, 84, res[2]+4536);
  /* #385: output[2][55] = @120 */
  if (res[2]) casadi_copy(w120, 84, res[2]+4620);
  /* #386: output[2][56] = @122 */
  if (res[2]) casadi_copy(w122, 84, res[2]+4704);
  /* #387: output[2][57] = @124 */
  if (res[2]) casadi_copy(w124, 84, res[2]+4788);
  /* #388: output[2][58] = @126 */
  if (res[2]) casadi_copy(w126, 84, res[2]+4872);
  /* #389: output[2][59] = @128 */
  if (res[2]) casadi_copy(w128, 84, res[2]+4956);
  /* #390: output[2][60] = @130 */
  if (res[2]) casadi_copy(w130, 84, res[2]+5040);
  /* #391: output[2][61] = @132 */
  if (res[2]) casadi_copy(w132, 84, res[2]+5124);
  /* #392: output[2][62] = @134 */
  if (res[2]) casadi_copy(w134, 84, res[2]+5208);
  /* #393: output[2][63] = @136 */
  if (res[2]) casadi_copy(w136, 84, res[2]+5292);
  /* #394: output[2][64] = @138 */
  if (res[2]) casadi_copy(w138, 7, res[2]+5376);
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

CASADI_SYMBOL_EXPORT int round_feet_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s23;
    case 1: return casadi_s24;
    case 2: return casadi_s24;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 11138;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 11138*sizeof(casadi_real);
  return 0;
}

/* round_feet_advance:(t,w[4],h,p[7])->(w_end[4],g[7],dg[7]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+103, w1, *w2=w+107, *w3=w+114, w4, *w5=w+116, *w6=w+140, *w7=w+144, *w8=w+151;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[1][0] */
  casadi_copy(arg[1], 4, w0);
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 7, w2);
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
  casadi_copy(w7, 7, res[1]);
  /* #11: output[2][0] = @8 */
  casadi_copy(w8, 7, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s4;
    case 2: return casadi_s25;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 158;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 158*sizeof(casadi_real);
  return 0;
}

/* round_feet_begin:(u[4],p[7])->(y[4x4]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+2, *w1=w+6, *w2=w+9, *w3=w+16;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w2);
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

CASADI_SYMBOL_EXPORT int round_feet_begin(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_begin_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_begin_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_begin_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_begin_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_begin_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_begin_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_begin_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_begin_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_begin_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_begin_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_begin_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_begin_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 28;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_begin_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 28*sizeof(casadi_real);
  return 0;
}

/* round_feet_swing:(t,h,y[4x4],p[7])->(y_end[4x4]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w3=w+583, *w4=w+590, *w5=w+614;
  const casadi_real **arg1=arg+4, *wr0;
  /* #0: @0 = input[2][0] */
  wr0 = arg[2] ? arg[2] : casadi_zeros;
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[1][0] */
  w2 = arg[1] ? arg[1][0] : 0;
  /* #3: @3 = input[3][0] */
  casadi_copy(arg[3], 7, w3);
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

CASADI_SYMBOL_EXPORT int round_feet_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f100(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_swing_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "y";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y_end";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s6;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 630;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 630*sizeof(casadi_real);
  return 0;
}

/* round_feet_end:(y[4x4],u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w1=w+68, *w2=w+72, w3, *w4=w+75, *w5=w+82;
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
  casadi_copy(arg[2], 7, w4);
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

CASADI_SYMBOL_EXPORT int round_feet_end(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f101(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_end_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_end_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_end_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_end_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_end_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_end_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_end_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_end_name_in(casadi_int i) {
  switch (i) {
    case 0: return "y";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_end_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_end_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_end_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_end_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 98;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 98*sizeof(casadi_real);
  return 0;
}

/* round_feet_observed_swing:(t,h,w[4],p[7])->(w_end[4],nodes[4x12],g[7x12],dg[7x12]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+282, *w3=w+289, *w4=w+313, *w5=w+317, *w6=w+321, *w7=w+369, *w8=w+453;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 7, w2);
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
  casadi_copy(w7, 84, res[2]);
  /* #9: output[3][0] = @8 */
  casadi_copy(w8, 84, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f102(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_observed_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_observed_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_observed_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_observed_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_observed_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_observed_swing_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_observed_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_observed_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "w";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_observed_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "nodes";
    case 2: return "g";
    case 3: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_observed_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s25;
    case 2: return casadi_s4;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_observed_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s26;
    case 2: return casadi_s27;
    case 3: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 537;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 537*sizeof(casadi_real);
  return 0;
}



/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*round_feet_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int round_feet_map(round_feet_kernel kernel, const casadi_int* work_size, casadi_int n,
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
