/* Walker on round feet: kernels of the solver
 * Printed by CasADi 3.8.2 from equations 8215575a9c41fada.
 * Do not edit: run `stridemap derive`.
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
  casadi_real a504, a505, a506, a507, a508, a509, a510, a511, a512, a513, a514, a515;
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
  a050=(a010*a033);
  a051=(a015*a035);
  a050=(a050-a051);
  a051=(a050*a013);
  a027=(a027+a051);
  a052=(a011*a008);
  a052=(a052*a008);
  a053=(2.*a015);
  a053=(a053*a008);
  a054=(a011*a053);
  a054=(a052+a054);
  a054=(a054+a011);
  a055=arg[4]? arg[4][2] : 0;
  a056=(2.*a055);
  a054=(a054+a056);
  a057=(a020*a008);
  a058=(a057*a010);
  a059=(a015*a014);
  a059=(a059*a008);
  a058=(a058-a059);
  a059=(a017*a014);
  a058=(a058-a059);
  a058=(a058-a014);
  a060=(a020*a019);
  a058=(a058-a060);
  a061=casadi_sq(a008);
  a058=(a058+a061);
  a058=(a058+a053);
  a053=(a057*a044);
  a058=(a058+a053);
  a062=(a018*a014);
  a062=(a062*a008);
  a058=(a058-a062);
  a063=casadi_sq(a014);
  a064=casadi_sq(a020);
  a065=(a063+a064);
  a058=(a058+a065);
  a066=1.;
  a058=(a058+a066);
  a058=(a048*a058);
  a054=(a054+a058);
  a058=(a027/a054);
  a059=(a059-a063);
  a059=(a059-a064);
  a059=(a059+a060);
  a059=(a059-a053);
  a059=(a059+a062);
  a059=(a012*a059);
  a059=(a059-a055);
  a062=(a059/a054);
  a053=(a031-a046);
  a060=(a014*a019);
  a067=(a060-a037);
  a067=(a007*a067);
  a053=(a053+a067);
  a053=(a012*a053);
  a027=(a062*a027);
  a027=(a053-a027);
  a067=(a012*a065);
  a067=(a055+a067);
  a059=(a059*a062);
  a059=(a067-a059);
  a027=(a027/a059);
  a068=(a062*a027);
  a058=(a058-a068);
  a068=(a006*a058);
  a069=1.7082860872947386e-01;
  a069=(a069*a002);
  a070=2.9587585476806851e-02;
  a070=(a070*a002);
  a071=(a070*a058);
  a072=8.8762756430420545e-02;
  a072=(a072*a002);
  a073=1.9725056984537900e-02;
  a073=(a073*a002);
  a074=(a073*a058);
  a075=5.9175170953613701e-02;
  a075=(a075*a002);
  a076=5.2600151958767730e-02;
  a076=(a076*a002);
  a077=(a076*a058);
  a077=(a003+a077);
  a078=casadi_sq(a077);
  a079=(a078*a008);
  a080=(a076*a003);
  a080=(a000+a080);
  a081=sin(a080);
  a079=(a079*a081);
  a079=(a079*a013);
  a082=cos(a080);
  a083=(a076*a024);
  a083=(a016+a083);
  a084=cos(a083);
  a085=(a082*a084);
  a086=sin(a083);
  a087=(a081*a086);
  a085=(a085+a087);
  a087=(a085*a020);
  a088=(a087*a008);
  a089=(2.*a077);
  a090=(a076*a027);
  a090=(a024+a090);
  a091=(a089*a090);
  a092=(a091-a078);
  a093=casadi_sq(a090);
  a092=(a092-a093);
  a093=(a088*a092);
  a083=(a083-a080);
  a083=(a083+a029);
  a080=cos(a083);
  a094=(a080*a020);
  a093=(a093-a094);
  a095=(a082*a020);
  a096=(a095*a077);
  a096=(a096*a077);
  a096=(a096*a008);
  a093=(a093-a096);
  a096=(a082*a033);
  a097=(a081*a035);
  a096=(a096+a097);
  a097=(a096*a020);
  a093=(a093-a097);
  a098=(a084*a020);
  a099=(a098*a090);
  a100=(a089-a090);
  a101=(a099*a100);
  a093=(a093+a101);
  a102=(a014*a090);
  a103=(a102*a086);
  a100=(a103*a100);
  a093=(a093-a100);
  a104=(a081*a084);
  a105=(a082*a086);
  a104=(a104-a105);
  a105=(a043*a104);
  a106=(a105*a092);
  a093=(a093+a106);
  a083=sin(a083);
  a106=(a014*a083);
  a093=(a093+a106);
  a093=(a012*a093);
  a093=(a079+a093);
  a093=(a093-a047);
  a107=(a081*a033);
  a108=(a082*a035);
  a107=(a107-a108);
  a108=(a107*a013);
  a093=(a093+a108);
  a109=(2.*a082);
  a109=(a109*a008);
  a110=(a011*a109);
  a110=(a052+a110);
  a110=(a110+a011);
  a110=(a110+a056);
  a111=(a057*a081);
  a112=(a082*a014);
  a112=(a112*a008);
  a111=(a111-a112);
  a112=(a084*a014);
  a111=(a111-a112);
  a111=(a111-a014);
  a113=(a020*a086);
  a111=(a111-a113);
  a111=(a111+a061);
  a111=(a111+a109);
  a109=(a057*a104);
  a111=(a111+a109);
  a114=(a085*a014);
  a114=(a114*a008);
  a111=(a111-a114);
  a111=(a111+a065);
  a111=(a111+a066);
  a111=(a048*a111);
  a110=(a110+a111);
  a111=(a093/a110);
  a112=(a112-a063);
  a112=(a112-a064);
  a112=(a112+a113);
  a112=(a112-a109);
  a112=(a112+a114);
  a112=(a012*a112);
  a112=(a112-a055);
  a114=(a112/a110);
  a109=(a094-a106);
  a113=(a014*a086);
  a115=(a113-a098);
  a115=(a078*a115);
  a109=(a109+a115);
  a109=(a012*a109);
  a093=(a114*a093);
  a093=(a109-a093);
  a112=(a112*a114);
  a112=(a067-a112);
  a093=(a093/a112);
  a115=(a114*a093);
  a111=(a111-a115);
  a111=(a075*a111);
  a074=(a074+a111);
  a074=(a003+a074);
  a111=casadi_sq(a074);
  a115=(a111*a008);
  a116=(a073*a003);
  a117=(a075*a077);
  a116=(a116+a117);
  a116=(a000+a116);
  a117=sin(a116);
  a115=(a115*a117);
  a115=(a115*a013);
  a118=cos(a116);
  a119=(a073*a024);
  a120=(a075*a090);
  a119=(a119+a120);
  a119=(a016+a119);
  a120=cos(a119);
  a121=(a118*a120);
  a122=sin(a119);
  a123=(a117*a122);
  a121=(a121+a123);
  a123=(a121*a020);
  a124=(a123*a008);
  a125=(2.*a074);
  a126=(a073*a027);
  a093=(a075*a093);
  a126=(a126+a093);
  a126=(a024+a126);
  a093=(a125*a126);
  a127=(a093-a111);
  a128=casadi_sq(a126);
  a127=(a127-a128);
  a128=(a124*a127);
  a119=(a119-a116);
  a119=(a119+a029);
  a116=cos(a119);
  a129=(a116*a020);
  a128=(a128-a129);
  a130=(a118*a020);
  a131=(a130*a074);
  a131=(a131*a074);
  a131=(a131*a008);
  a128=(a128-a131);
  a131=(a118*a033);
  a132=(a117*a035);
  a131=(a131+a132);
  a132=(a131*a020);
  a128=(a128-a132);
  a133=(a120*a020);
  a134=(a133*a126);
  a135=(a125-a126);
  a136=(a134*a135);
  a128=(a128+a136);
  a137=(a014*a126);
  a138=(a137*a122);
  a135=(a138*a135);
  a128=(a128-a135);
  a139=(a117*a120);
  a140=(a118*a122);
  a139=(a139-a140);
  a140=(a043*a139);
  a141=(a140*a127);
  a128=(a128+a141);
  a119=sin(a119);
  a141=(a014*a119);
  a128=(a128+a141);
  a128=(a012*a128);
  a128=(a115+a128);
  a128=(a128-a047);
  a142=(a117*a033);
  a143=(a118*a035);
  a142=(a142-a143);
  a143=(a142*a013);
  a128=(a128+a143);
  a144=(2.*a118);
  a144=(a144*a008);
  a145=(a011*a144);
  a145=(a052+a145);
  a145=(a145+a011);
  a145=(a145+a056);
  a146=(a057*a117);
  a147=(a118*a014);
  a147=(a147*a008);
  a146=(a146-a147);
  a147=(a120*a014);
  a146=(a146-a147);
  a146=(a146-a014);
  a148=(a020*a122);
  a146=(a146-a148);
  a146=(a146+a061);
  a146=(a146+a144);
  a144=(a057*a139);
  a146=(a146+a144);
  a149=(a121*a014);
  a149=(a149*a008);
  a146=(a146-a149);
  a146=(a146+a065);
  a146=(a146+a066);
  a146=(a048*a146);
  a145=(a145+a146);
  a146=(a128/a145);
  a147=(a147-a063);
  a147=(a147-a064);
  a147=(a147+a148);
  a147=(a147-a144);
  a147=(a147+a149);
  a147=(a012*a147);
  a147=(a147-a055);
  a149=(a147/a145);
  a144=(a129-a141);
  a148=(a014*a122);
  a150=(a148-a133);
  a150=(a111*a150);
  a144=(a144+a150);
  a144=(a012*a144);
  a128=(a149*a128);
  a128=(a144-a128);
  a147=(a147*a149);
  a147=(a067-a147);
  a128=(a128/a147);
  a150=(a149*a128);
  a146=(a146-a150);
  a150=(a072*a146);
  a071=(a071+a150);
  a071=(a003+a071);
  a150=casadi_sq(a071);
  a151=(a150*a008);
  a152=(a070*a003);
  a153=(a072*a074);
  a152=(a152+a153);
  a152=(a000+a152);
  a153=sin(a152);
  a151=(a151*a153);
  a151=(a151*a013);
  a154=cos(a152);
  a155=(a070*a024);
  a156=(a072*a126);
  a155=(a155+a156);
  a155=(a016+a155);
  a156=cos(a155);
  a157=(a154*a156);
  a158=sin(a155);
  a159=(a153*a158);
  a157=(a157+a159);
  a159=(a157*a020);
  a160=(a159*a008);
  a161=(2.*a071);
  a162=(a070*a027);
  a163=(a072*a128);
  a162=(a162+a163);
  a162=(a024+a162);
  a163=(a161*a162);
  a164=(a163-a150);
  a165=casadi_sq(a162);
  a164=(a164-a165);
  a165=(a160*a164);
  a155=(a155-a152);
  a155=(a155+a029);
  a152=cos(a155);
  a166=(a152*a020);
  a165=(a165-a166);
  a167=(a154*a020);
  a168=(a167*a071);
  a168=(a168*a071);
  a168=(a168*a008);
  a165=(a165-a168);
  a168=(a154*a033);
  a169=(a153*a035);
  a168=(a168+a169);
  a169=(a168*a020);
  a165=(a165-a169);
  a170=(a156*a020);
  a171=(a170*a162);
  a172=(a161-a162);
  a173=(a171*a172);
  a165=(a165+a173);
  a174=(a014*a162);
  a175=(a174*a158);
  a172=(a175*a172);
  a165=(a165-a172);
  a176=(a153*a156);
  a177=(a154*a158);
  a176=(a176-a177);
  a177=(a043*a176);
  a178=(a177*a164);
  a165=(a165+a178);
  a155=sin(a155);
  a178=(a014*a155);
  a165=(a165+a178);
  a165=(a012*a165);
  a165=(a151+a165);
  a165=(a165-a047);
  a179=(a153*a033);
  a180=(a154*a035);
  a179=(a179-a180);
  a180=(a179*a013);
  a165=(a165+a180);
  a181=(2.*a154);
  a181=(a181*a008);
  a182=(a011*a181);
  a182=(a052+a182);
  a182=(a182+a011);
  a182=(a182+a056);
  a183=(a057*a153);
  a184=(a154*a014);
  a184=(a184*a008);
  a183=(a183-a184);
  a184=(a156*a014);
  a183=(a183-a184);
  a183=(a183-a014);
  a185=(a020*a158);
  a183=(a183-a185);
  a183=(a183+a061);
  a183=(a183+a181);
  a181=(a057*a176);
  a183=(a183+a181);
  a186=(a157*a014);
  a186=(a186*a008);
  a183=(a183-a186);
  a183=(a183+a065);
  a183=(a183+a066);
  a183=(a048*a183);
  a182=(a182+a183);
  a183=(a165/a182);
  a184=(a184-a063);
  a184=(a184-a064);
  a184=(a184+a185);
  a184=(a184-a181);
  a184=(a184+a186);
  a184=(a012*a184);
  a184=(a184-a055);
  a186=(a184/a182);
  a181=(a166-a178);
  a185=(a014*a158);
  a187=(a185-a170);
  a187=(a150*a187);
  a181=(a181+a187);
  a181=(a012*a181);
  a165=(a186*a165);
  a165=(a181-a165);
  a184=(a184*a186);
  a184=(a067-a184);
  a165=(a165/a184);
  a187=(a186*a165);
  a183=(a183-a187);
  a187=(a069*a183);
  a068=(a068+a187);
  a187=1.2546768756682242e-01;
  a187=(a187*a002);
  a188=2.4136513415926669e-01;
  a188=(a188*a002);
  a189=(a188*a058);
  a190=-8.8454947932828609e-01;
  a190=(a190*a002);
  a146=(a190*a146);
  a189=(a189+a146);
  a146=9.2483400326179199e-01;
  a146=(a146*a002);
  a191=(a146*a183);
  a189=(a189+a191);
  a189=(a003+a189);
  a191=casadi_sq(a189);
  a192=(a191*a008);
  a193=(a188*a003);
  a194=(a190*a074);
  a193=(a193+a194);
  a194=(a146*a071);
  a193=(a193+a194);
  a193=(a000+a193);
  a194=sin(a193);
  a192=(a192*a194);
  a192=(a192*a013);
  a195=cos(a193);
  a196=(a188*a024);
  a197=(a190*a126);
  a196=(a196+a197);
  a197=(a146*a162);
  a196=(a196+a197);
  a196=(a016+a196);
  a197=cos(a196);
  a198=(a195*a197);
  a199=sin(a196);
  a200=(a194*a199);
  a198=(a198+a200);
  a200=(a198*a020);
  a201=(a200*a008);
  a202=(2.*a189);
  a203=(a188*a027);
  a128=(a190*a128);
  a203=(a203+a128);
  a128=(a146*a165);
  a203=(a203+a128);
  a203=(a024+a203);
  a128=(a202*a203);
  a204=(a128-a191);
  a205=casadi_sq(a203);
  a204=(a204-a205);
  a205=(a201*a204);
  a196=(a196-a193);
  a196=(a196+a029);
  a193=cos(a196);
  a206=(a193*a020);
  a205=(a205-a206);
  a207=(a195*a020);
  a208=(a207*a189);
  a208=(a208*a189);
  a208=(a208*a008);
  a205=(a205-a208);
  a208=(a195*a033);
  a209=(a194*a035);
  a208=(a208+a209);
  a209=(a208*a020);
  a205=(a205-a209);
  a210=(a197*a020);
  a211=(a210*a203);
  a212=(a202-a203);
  a213=(a211*a212);
  a205=(a205+a213);
  a214=(a014*a203);
  a215=(a214*a199);
  a212=(a215*a212);
  a205=(a205-a212);
  a216=(a194*a197);
  a217=(a195*a199);
  a216=(a216-a217);
  a217=(a043*a216);
  a218=(a217*a204);
  a205=(a205+a218);
  a196=sin(a196);
  a218=(a014*a196);
  a205=(a205+a218);
  a205=(a012*a205);
  a205=(a192+a205);
  a205=(a205-a047);
  a219=(a194*a033);
  a220=(a195*a035);
  a219=(a219-a220);
  a220=(a219*a013);
  a205=(a205+a220);
  a221=(2.*a195);
  a221=(a221*a008);
  a222=(a011*a221);
  a222=(a052+a222);
  a222=(a222+a011);
  a222=(a222+a056);
  a223=(a057*a194);
  a224=(a195*a014);
  a224=(a224*a008);
  a223=(a223-a224);
  a224=(a197*a014);
  a223=(a223-a224);
  a223=(a223-a014);
  a225=(a020*a199);
  a223=(a223-a225);
  a223=(a223+a061);
  a223=(a223+a221);
  a221=(a057*a216);
  a223=(a223+a221);
  a226=(a198*a014);
  a226=(a226*a008);
  a223=(a223-a226);
  a223=(a223+a065);
  a223=(a223+a066);
  a223=(a048*a223);
  a222=(a222+a223);
  a223=(a205/a222);
  a224=(a224-a063);
  a224=(a224-a064);
  a224=(a224+a225);
  a224=(a224-a221);
  a224=(a224+a226);
  a224=(a012*a224);
  a224=(a224-a055);
  a226=(a224/a222);
  a221=(a206-a218);
  a225=(a014*a199);
  a227=(a225-a210);
  a227=(a191*a227);
  a221=(a221+a227);
  a221=(a012*a221);
  a205=(a226*a205);
  a205=(a221-a205);
  a224=(a224*a226);
  a224=(a067-a224);
  a205=(a205/a224);
  a227=(a226*a205);
  a223=(a223-a227);
  a227=(a187*a223);
  a068=(a068+a227);
  a068=(a003+a068);
  a227=(a005*a068);
  a004=(a004+a227);
  a227=1.8915178993145003e+00;
  a227=(a227*a002);
  a228=3.7109375000000000e-02;
  a228=(a228*a002);
  a229=(a228*a058);
  a230=1.7025221101954405e-01;
  a230=(a230*a002);
  a231=(a230*a183);
  a229=(a229+a231);
  a231=6.0216538980455959e-02;
  a231=(a231*a002);
  a232=(a231*a223);
  a229=(a229+a232);
  a232=-1.7578125000000000e-02;
  a232=(a232*a002);
  a233=casadi_sq(a068);
  a234=(a233*a008);
  a235=(a006*a003);
  a236=(a069*a071);
  a235=(a235+a236);
  a236=(a187*a189);
  a235=(a235+a236);
  a235=(a000+a235);
  a236=sin(a235);
  a234=(a234*a236);
  a234=(a234*a013);
  a237=cos(a235);
  a238=(a006*a024);
  a239=(a069*a162);
  a238=(a238+a239);
  a239=(a187*a203);
  a238=(a238+a239);
  a238=(a016+a238);
  a239=cos(a238);
  a240=(a237*a239);
  a241=sin(a238);
  a242=(a236*a241);
  a240=(a240+a242);
  a242=(a240*a020);
  a243=(a242*a008);
  a244=(2.*a068);
  a245=(a006*a027);
  a246=(a069*a165);
  a245=(a245+a246);
  a246=(a187*a205);
  a245=(a245+a246);
  a245=(a024+a245);
  a246=(a244*a245);
  a247=(a246-a233);
  a248=casadi_sq(a245);
  a247=(a247-a248);
  a248=(a243*a247);
  a238=(a238-a235);
  a238=(a238+a029);
  a235=cos(a238);
  a249=(a235*a020);
  a248=(a248-a249);
  a250=(a237*a020);
  a251=(a250*a068);
  a251=(a251*a068);
  a251=(a251*a008);
  a248=(a248-a251);
  a251=(a237*a033);
  a252=(a236*a035);
  a251=(a251+a252);
  a252=(a251*a020);
  a248=(a248-a252);
  a253=(a239*a020);
  a254=(a253*a245);
  a255=(a244-a245);
  a256=(a254*a255);
  a248=(a248+a256);
  a257=(a014*a245);
  a258=(a257*a241);
  a255=(a258*a255);
  a248=(a248-a255);
  a259=(a236*a239);
  a260=(a237*a241);
  a259=(a259-a260);
  a260=(a043*a259);
  a261=(a260*a247);
  a248=(a248+a261);
  a238=sin(a238);
  a261=(a014*a238);
  a248=(a248+a261);
  a248=(a012*a248);
  a248=(a234+a248);
  a248=(a248-a047);
  a262=(a236*a033);
  a263=(a237*a035);
  a262=(a262-a263);
  a263=(a262*a013);
  a248=(a248+a263);
  a264=(2.*a237);
  a264=(a264*a008);
  a265=(a011*a264);
  a265=(a052+a265);
  a265=(a265+a011);
  a265=(a265+a056);
  a266=(a057*a236);
  a267=(a237*a014);
  a267=(a267*a008);
  a266=(a266-a267);
  a267=(a239*a014);
  a266=(a266-a267);
  a266=(a266-a014);
  a268=(a020*a241);
  a266=(a266-a268);
  a266=(a266+a061);
  a266=(a266+a264);
  a264=(a057*a259);
  a266=(a266+a264);
  a269=(a240*a014);
  a269=(a269*a008);
  a266=(a266-a269);
  a266=(a266+a065);
  a266=(a266+a066);
  a266=(a048*a266);
  a265=(a265+a266);
  a266=(a248/a265);
  a267=(a267-a063);
  a267=(a267-a064);
  a267=(a267+a268);
  a267=(a267-a264);
  a267=(a267+a269);
  a267=(a012*a267);
  a267=(a267-a055);
  a269=(a267/a265);
  a264=(a249-a261);
  a268=(a014*a241);
  a270=(a268-a253);
  a270=(a233*a270);
  a264=(a264+a270);
  a264=(a012*a264);
  a248=(a269*a248);
  a248=(a264-a248);
  a267=(a267*a269);
  a267=(a067-a267);
  a248=(a248/a267);
  a270=(a269*a248);
  a266=(a266-a270);
  a270=(a232*a266);
  a229=(a229+a270);
  a229=(a003+a229);
  a270=(a227*a229);
  a004=(a004+a270);
  a270=-5.8012039600105849e+00;
  a270=(a270*a002);
  a271=3.7092000118504789e-02;
  a271=(a271*a002);
  a272=(a271*a058);
  a273=1.7038392571223998e-01;
  a273=(a273*a002);
  a274=(a273*a183);
  a272=(a272+a274);
  a274=1.0726203044637328e-01;
  a274=(a274*a002);
  a275=(a274*a223);
  a272=(a272+a275);
  a275=-1.5319437748624402e-02;
  a275=(a275*a002);
  a276=(a275*a266);
  a272=(a272+a276);
  a276=8.2737891638140233e-03;
  a276=(a276*a002);
  a277=casadi_sq(a229);
  a278=(a277*a008);
  a279=(a228*a003);
  a280=(a230*a071);
  a279=(a279+a280);
  a280=(a231*a189);
  a279=(a279+a280);
  a280=(a232*a068);
  a279=(a279+a280);
  a279=(a000+a279);
  a280=sin(a279);
  a278=(a278*a280);
  a278=(a278*a013);
  a281=cos(a279);
  a282=(a228*a024);
  a283=(a230*a162);
  a282=(a282+a283);
  a283=(a231*a203);
  a282=(a282+a283);
  a283=(a232*a245);
  a282=(a282+a283);
  a282=(a016+a282);
  a283=cos(a282);
  a284=(a281*a283);
  a285=sin(a282);
  a286=(a280*a285);
  a284=(a284+a286);
  a286=(a284*a020);
  a287=(a286*a008);
  a288=(2.*a229);
  a289=(a228*a027);
  a290=(a230*a165);
  a289=(a289+a290);
  a290=(a231*a205);
  a289=(a289+a290);
  a290=(a232*a248);
  a289=(a289+a290);
  a289=(a024+a289);
  a290=(a288*a289);
  a291=(a290-a277);
  a292=casadi_sq(a289);
  a291=(a291-a292);
  a292=(a287*a291);
  a282=(a282-a279);
  a282=(a282+a029);
  a279=cos(a282);
  a293=(a279*a020);
  a292=(a292-a293);
  a294=(a281*a020);
  a295=(a294*a229);
  a295=(a295*a229);
  a295=(a295*a008);
  a292=(a292-a295);
  a295=(a281*a033);
  a296=(a280*a035);
  a295=(a295+a296);
  a296=(a295*a020);
  a292=(a292-a296);
  a297=(a283*a020);
  a298=(a297*a289);
  a299=(a288-a289);
  a300=(a298*a299);
  a292=(a292+a300);
  a301=(a014*a289);
  a302=(a301*a285);
  a299=(a302*a299);
  a292=(a292-a299);
  a303=(a280*a283);
  a304=(a281*a285);
  a303=(a303-a304);
  a304=(a043*a303);
  a305=(a304*a291);
  a292=(a292+a305);
  a282=sin(a282);
  a305=(a014*a282);
  a292=(a292+a305);
  a292=(a012*a292);
  a292=(a278+a292);
  a292=(a292-a047);
  a306=(a280*a033);
  a307=(a281*a035);
  a306=(a306-a307);
  a307=(a306*a013);
  a292=(a292+a307);
  a308=(2.*a281);
  a308=(a308*a008);
  a309=(a011*a308);
  a309=(a052+a309);
  a309=(a309+a011);
  a309=(a309+a056);
  a310=(a057*a280);
  a311=(a281*a014);
  a311=(a311*a008);
  a310=(a310-a311);
  a311=(a283*a014);
  a310=(a310-a311);
  a310=(a310-a014);
  a312=(a020*a285);
  a310=(a310-a312);
  a310=(a310+a061);
  a310=(a310+a308);
  a308=(a057*a303);
  a310=(a310+a308);
  a313=(a284*a014);
  a313=(a313*a008);
  a310=(a310-a313);
  a310=(a310+a065);
  a310=(a310+a066);
  a310=(a048*a310);
  a309=(a309+a310);
  a310=(a292/a309);
  a311=(a311-a063);
  a311=(a311-a064);
  a311=(a311+a312);
  a311=(a311-a308);
  a311=(a311+a313);
  a311=(a012*a311);
  a311=(a311-a055);
  a313=(a311/a309);
  a308=(a293-a305);
  a312=(a014*a285);
  a314=(a312-a297);
  a314=(a277*a314);
  a308=(a308+a314);
  a308=(a012*a308);
  a292=(a313*a292);
  a292=(a308-a292);
  a311=(a311*a313);
  a311=(a067-a311);
  a292=(a292/a311);
  a314=(a313*a292);
  a310=(a310-a314);
  a314=(a276*a310);
  a272=(a272+a314);
  a272=(a003+a272);
  a314=(a270*a272);
  a004=(a004+a314);
  a314=3.1116436695781990e-01;
  a314=(a314*a002);
  a315=6.2411095871607569e-01;
  a315=(a315*a002);
  a316=(a315*a058);
  a317=-3.3608926294469414e+00;
  a317=(a317*a002);
  a318=(a317*a183);
  a316=(a316+a318);
  a318=-8.6821934684172597e-01;
  a318=(a318*a002);
  a319=(a318*a223);
  a316=(a316+a319);
  a319=2.7592099699446710e+01;
  a319=(a319*a002);
  a320=(a319*a266);
  a316=(a316+a320);
  a320=2.0154067550477894e+01;
  a320=(a320*a002);
  a321=(a320*a310);
  a316=(a316+a321);
  a321=-4.3489884181069961e+01;
  a321=(a321*a002);
  a322=casadi_sq(a272);
  a323=(a322*a008);
  a324=(a271*a003);
  a325=(a273*a071);
  a324=(a324+a325);
  a325=(a274*a189);
  a324=(a324+a325);
  a325=(a275*a068);
  a324=(a324+a325);
  a325=(a276*a229);
  a324=(a324+a325);
  a324=(a000+a324);
  a325=sin(a324);
  a323=(a323*a325);
  a323=(a323*a013);
  a326=cos(a324);
  a327=(a271*a024);
  a328=(a273*a162);
  a327=(a327+a328);
  a328=(a274*a203);
  a327=(a327+a328);
  a328=(a275*a245);
  a327=(a327+a328);
  a328=(a276*a289);
  a327=(a327+a328);
  a327=(a016+a327);
  a328=cos(a327);
  a329=(a326*a328);
  a330=sin(a327);
  a331=(a325*a330);
  a329=(a329+a331);
  a331=(a329*a020);
  a332=(a331*a008);
  a333=(2.*a272);
  a334=(a271*a027);
  a335=(a273*a165);
  a334=(a334+a335);
  a335=(a274*a205);
  a334=(a334+a335);
  a335=(a275*a248);
  a334=(a334+a335);
  a335=(a276*a292);
  a334=(a334+a335);
  a334=(a024+a334);
  a335=(a333*a334);
  a336=(a335-a322);
  a337=casadi_sq(a334);
  a336=(a336-a337);
  a337=(a332*a336);
  a327=(a327-a324);
  a327=(a327+a029);
  a324=cos(a327);
  a338=(a324*a020);
  a337=(a337-a338);
  a339=(a326*a020);
  a340=(a339*a272);
  a340=(a340*a272);
  a340=(a340*a008);
  a337=(a337-a340);
  a340=(a326*a033);
  a341=(a325*a035);
  a340=(a340+a341);
  a341=(a340*a020);
  a337=(a337-a341);
  a342=(a328*a020);
  a343=(a342*a334);
  a344=(a333-a334);
  a345=(a343*a344);
  a337=(a337+a345);
  a346=(a014*a334);
  a347=(a346*a330);
  a344=(a347*a344);
  a337=(a337-a344);
  a348=(a325*a328);
  a349=(a326*a330);
  a348=(a348-a349);
  a349=(a043*a348);
  a350=(a349*a336);
  a337=(a337+a350);
  a327=sin(a327);
  a350=(a014*a327);
  a337=(a337+a350);
  a337=(a012*a337);
  a337=(a323+a337);
  a337=(a337-a047);
  a351=(a325*a033);
  a352=(a326*a035);
  a351=(a351-a352);
  a352=(a351*a013);
  a337=(a337+a352);
  a353=(2.*a326);
  a353=(a353*a008);
  a354=(a011*a353);
  a354=(a052+a354);
  a354=(a354+a011);
  a354=(a354+a056);
  a355=(a057*a325);
  a356=(a326*a014);
  a356=(a356*a008);
  a355=(a355-a356);
  a356=(a328*a014);
  a355=(a355-a356);
  a355=(a355-a014);
  a357=(a020*a330);
  a355=(a355-a357);
  a355=(a355+a061);
  a355=(a355+a353);
  a353=(a057*a348);
  a355=(a355+a353);
  a358=(a329*a014);
  a358=(a358*a008);
  a355=(a355-a358);
  a355=(a355+a065);
  a355=(a355+a066);
  a355=(a048*a355);
  a354=(a354+a355);
  a355=(a337/a354);
  a356=(a356-a063);
  a356=(a356-a064);
  a356=(a356+a357);
  a356=(a356-a353);
  a356=(a356+a358);
  a356=(a012*a356);
  a356=(a356-a055);
  a358=(a356/a354);
  a353=(a338-a350);
  a357=(a014*a330);
  a359=(a357-a342);
  a359=(a322*a359);
  a353=(a353+a359);
  a353=(a012*a353);
  a337=(a358*a337);
  a337=(a353-a337);
  a356=(a356*a358);
  a356=(a067-a356);
  a337=(a337/a356);
  a359=(a358*a337);
  a355=(a355-a359);
  a359=(a321*a355);
  a316=(a316+a359);
  a316=(a003+a316);
  a359=(a314*a316);
  a004=(a004+a359);
  a359=-1.5216094966251609e-01;
  a359=(a359*a002);
  a360=4.7766253643826434e-01;
  a360=(a360*a002);
  a361=(a360*a058);
  a362=-2.4881146199716677e+00;
  a362=(a362*a002);
  a363=(a362*a183);
  a361=(a361+a363);
  a363=-5.9029082683684297e-01;
  a363=(a363*a002);
  a364=(a363*a223);
  a361=(a361+a364);
  a364=2.1230051448181193e+01;
  a364=(a364*a002);
  a365=(a364*a266);
  a361=(a361+a365);
  a365=1.5279233632882423e+01;
  a365=(a365*a002);
  a366=(a365*a310);
  a361=(a361+a366);
  a366=-3.3288210968984863e+01;
  a366=(a366*a002);
  a367=(a366*a355);
  a361=(a361+a367);
  a367=-2.0331201708508627e-02;
  a367=(a367*a002);
  a368=casadi_sq(a316);
  a369=(a368*a008);
  a370=(a315*a003);
  a371=(a317*a071);
  a370=(a370+a371);
  a371=(a318*a189);
  a370=(a370+a371);
  a371=(a319*a068);
  a370=(a370+a371);
  a371=(a320*a229);
  a370=(a370+a371);
  a371=(a321*a272);
  a370=(a370+a371);
  a370=(a000+a370);
  a371=sin(a370);
  a369=(a369*a371);
  a369=(a369*a013);
  a372=cos(a370);
  a373=(a315*a024);
  a374=(a317*a162);
  a373=(a373+a374);
  a374=(a318*a203);
  a373=(a373+a374);
  a374=(a319*a245);
  a373=(a373+a374);
  a374=(a320*a289);
  a373=(a373+a374);
  a374=(a321*a334);
  a373=(a373+a374);
  a373=(a016+a373);
  a374=cos(a373);
  a375=(a372*a374);
  a376=sin(a373);
  a377=(a371*a376);
  a375=(a375+a377);
  a377=(a375*a020);
  a378=(a377*a008);
  a379=(2.*a316);
  a380=(a315*a027);
  a381=(a317*a165);
  a380=(a380+a381);
  a381=(a318*a205);
  a380=(a380+a381);
  a381=(a319*a248);
  a380=(a380+a381);
  a381=(a320*a292);
  a380=(a380+a381);
  a381=(a321*a337);
  a380=(a380+a381);
  a380=(a024+a380);
  a381=(a379*a380);
  a382=(a381-a368);
  a383=casadi_sq(a380);
  a382=(a382-a383);
  a383=(a378*a382);
  a373=(a373-a370);
  a373=(a373+a029);
  a370=cos(a373);
  a384=(a370*a020);
  a383=(a383-a384);
  a385=(a372*a020);
  a386=(a385*a316);
  a386=(a386*a316);
  a386=(a386*a008);
  a383=(a383-a386);
  a386=(a372*a033);
  a387=(a371*a035);
  a386=(a386+a387);
  a387=(a386*a020);
  a383=(a383-a387);
  a388=(a374*a020);
  a389=(a388*a380);
  a390=(a379-a380);
  a391=(a389*a390);
  a383=(a383+a391);
  a392=(a014*a380);
  a393=(a392*a376);
  a390=(a393*a390);
  a383=(a383-a390);
  a394=(a371*a374);
  a395=(a372*a376);
  a394=(a394-a395);
  a395=(a043*a394);
  a396=(a395*a382);
  a383=(a383+a396);
  a373=sin(a373);
  a396=(a014*a373);
  a383=(a383+a396);
  a383=(a012*a383);
  a383=(a369+a383);
  a383=(a383-a047);
  a397=(a371*a033);
  a398=(a372*a035);
  a397=(a397-a398);
  a398=(a397*a013);
  a383=(a383+a398);
  a399=(2.*a372);
  a399=(a399*a008);
  a400=(a011*a399);
  a400=(a052+a400);
  a400=(a400+a011);
  a400=(a400+a056);
  a401=(a057*a371);
  a402=(a372*a014);
  a402=(a402*a008);
  a401=(a401-a402);
  a402=(a374*a014);
  a401=(a401-a402);
  a401=(a401-a014);
  a403=(a020*a376);
  a401=(a401-a403);
  a401=(a401+a061);
  a401=(a401+a399);
  a399=(a057*a394);
  a401=(a401+a399);
  a404=(a375*a014);
  a404=(a404*a008);
  a401=(a401-a404);
  a401=(a401+a065);
  a401=(a401+a066);
  a401=(a048*a401);
  a400=(a400+a401);
  a401=(a383/a400);
  a402=(a402-a063);
  a402=(a402-a064);
  a402=(a402+a403);
  a402=(a402-a399);
  a402=(a402+a404);
  a402=(a012*a402);
  a402=(a402-a055);
  a404=(a402/a400);
  a399=(a384-a396);
  a403=(a014*a376);
  a405=(a403-a388);
  a405=(a368*a405);
  a399=(a399+a405);
  a399=(a012*a399);
  a383=(a404*a383);
  a383=(a399-a383);
  a402=(a402*a404);
  a402=(a067-a402);
  a383=(a383/a402);
  a405=(a404*a383);
  a401=(a401-a405);
  a405=(a367*a401);
  a361=(a361+a405);
  a361=(a003+a361);
  a405=(a359*a361);
  a004=(a004+a405);
  a405=2.0136540080403034e-01;
  a405=(a405*a002);
  a406=-9.3714243008598730e-01;
  a406=(a406*a002);
  a407=(a406*a058);
  a408=5.1863724288440638e+00;
  a408=(a408*a002);
  a409=(a408*a183);
  a407=(a407+a409);
  a409=1.0914373489967295e+00;
  a409=(a409*a002);
  a410=(a409*a223);
  a407=(a407+a410);
  a410=-8.1497870107469268e+00;
  a410=(a410*a002);
  a411=(a410*a266);
  a407=(a407+a411);
  a411=-1.8520065659996959e+01;
  a411=(a411*a002);
  a412=(a411*a310);
  a407=(a407+a412);
  a412=2.2739487099350505e+01;
  a412=(a412*a002);
  a413=(a412*a355);
  a407=(a407+a413);
  a413=2.4936055526796523e+00;
  a413=(a413*a002);
  a414=(a413*a401);
  a407=(a407+a414);
  a414=-3.0467644718982196e+00;
  a414=(a414*a002);
  a415=casadi_sq(a361);
  a416=(a415*a008);
  a417=(a360*a003);
  a418=(a362*a071);
  a417=(a417+a418);
  a418=(a363*a189);
  a417=(a417+a418);
  a418=(a364*a068);
  a417=(a417+a418);
  a418=(a365*a229);
  a417=(a417+a418);
  a418=(a366*a272);
  a417=(a417+a418);
  a418=(a367*a316);
  a417=(a417+a418);
  a417=(a000+a417);
  a418=sin(a417);
  a416=(a416*a418);
  a416=(a416*a013);
  a419=cos(a417);
  a420=(a360*a024);
  a421=(a362*a162);
  a420=(a420+a421);
  a421=(a363*a203);
  a420=(a420+a421);
  a421=(a364*a245);
  a420=(a420+a421);
  a421=(a365*a289);
  a420=(a420+a421);
  a421=(a366*a334);
  a420=(a420+a421);
  a421=(a367*a380);
  a420=(a420+a421);
  a420=(a016+a420);
  a421=cos(a420);
  a422=(a419*a421);
  a423=sin(a420);
  a424=(a418*a423);
  a422=(a422+a424);
  a424=(a422*a020);
  a425=(a424*a008);
  a426=(2.*a361);
  a427=(a360*a027);
  a428=(a362*a165);
  a427=(a427+a428);
  a428=(a363*a205);
  a427=(a427+a428);
  a428=(a364*a248);
  a427=(a427+a428);
  a428=(a365*a292);
  a427=(a427+a428);
  a428=(a366*a337);
  a427=(a427+a428);
  a428=(a367*a383);
  a427=(a427+a428);
  a427=(a024+a427);
  a428=(a426*a427);
  a429=(a428-a415);
  a430=casadi_sq(a427);
  a429=(a429-a430);
  a430=(a425*a429);
  a420=(a420-a417);
  a420=(a420+a029);
  a417=cos(a420);
  a431=(a417*a020);
  a430=(a430-a431);
  a432=(a419*a020);
  a433=(a432*a361);
  a433=(a433*a361);
  a433=(a433*a008);
  a430=(a430-a433);
  a433=(a419*a033);
  a434=(a418*a035);
  a433=(a433+a434);
  a434=(a433*a020);
  a430=(a430-a434);
  a435=(a421*a020);
  a436=(a435*a427);
  a437=(a426-a427);
  a438=(a436*a437);
  a430=(a430+a438);
  a439=(a014*a427);
  a440=(a439*a423);
  a437=(a440*a437);
  a430=(a430-a437);
  a441=(a418*a421);
  a442=(a419*a423);
  a441=(a441-a442);
  a442=(a043*a441);
  a443=(a442*a429);
  a430=(a430+a443);
  a420=sin(a420);
  a443=(a014*a420);
  a430=(a430+a443);
  a430=(a012*a430);
  a430=(a416+a430);
  a430=(a430-a047);
  a444=(a418*a033);
  a445=(a419*a035);
  a444=(a444-a445);
  a445=(a444*a013);
  a430=(a430+a445);
  a446=(2.*a419);
  a446=(a446*a008);
  a447=(a011*a446);
  a447=(a052+a447);
  a447=(a447+a011);
  a447=(a447+a056);
  a448=(a057*a418);
  a449=(a419*a014);
  a449=(a449*a008);
  a448=(a448-a449);
  a449=(a421*a014);
  a448=(a448-a449);
  a448=(a448-a014);
  a450=(a020*a423);
  a448=(a448-a450);
  a448=(a448+a061);
  a448=(a448+a446);
  a446=(a057*a441);
  a448=(a448+a446);
  a451=(a422*a014);
  a451=(a451*a008);
  a448=(a448-a451);
  a448=(a448+a065);
  a448=(a448+a066);
  a448=(a048*a448);
  a447=(a447+a448);
  a448=(a430/a447);
  a449=(a449-a063);
  a449=(a449-a064);
  a449=(a449+a450);
  a449=(a449-a446);
  a449=(a449+a451);
  a449=(a012*a449);
  a449=(a449-a055);
  a451=(a449/a447);
  a446=(a431-a443);
  a450=(a014*a423);
  a452=(a450-a435);
  a452=(a415*a452);
  a446=(a446+a452);
  a446=(a012*a446);
  a430=(a451*a430);
  a430=(a446-a430);
  a449=(a449*a451);
  a449=(a067-a449);
  a430=(a430/a449);
  a452=(a451*a430);
  a448=(a448-a452);
  a452=(a414*a448);
  a407=(a407+a452);
  a407=(a003+a407);
  a452=(a405*a407);
  a004=(a004+a452);
  a452=4.4710615727772587e-02;
  a452=(a452*a002);
  a453=2.2733101475165380e+00;
  a453=(a453*a002);
  a454=(a453*a058);
  a455=-1.0534495466737249e+01;
  a455=(a455*a002);
  a183=(a455*a183);
  a454=(a454+a183);
  a183=-2.0008720582248625e+00;
  a183=(a183*a002);
  a223=(a183*a223);
  a454=(a454+a223);
  a223=-1.7958931863118799e+01;
  a223=(a223*a002);
  a456=(a223*a266);
  a454=(a454+a456);
  a456=2.7948884529419960e+01;
  a456=(a456*a002);
  a457=(a456*a310);
  a454=(a454+a457);
  a457=-2.8589982771350235e+00;
  a457=(a457*a002);
  a458=(a457*a355);
  a454=(a454+a458);
  a458=-8.8728569335306293e+00;
  a458=(a458*a002);
  a459=(a458*a401);
  a454=(a454+a459);
  a459=1.2360567175794303e+01;
  a459=(a459*a002);
  a460=(a459*a448);
  a454=(a454+a460);
  a460=6.4339274601576357e-01;
  a460=(a460*a002);
  a002=casadi_sq(a407);
  a461=(a002*a008);
  a462=(a406*a003);
  a463=(a408*a071);
  a462=(a462+a463);
  a463=(a409*a189);
  a462=(a462+a463);
  a463=(a410*a068);
  a462=(a462+a463);
  a463=(a411*a229);
  a462=(a462+a463);
  a463=(a412*a272);
  a462=(a462+a463);
  a463=(a413*a316);
  a462=(a462+a463);
  a463=(a414*a361);
  a462=(a462+a463);
  a462=(a000+a462);
  a463=sin(a462);
  a461=(a461*a463);
  a461=(a461*a013);
  a464=cos(a462);
  a465=(a406*a024);
  a466=(a408*a162);
  a465=(a465+a466);
  a466=(a409*a203);
  a465=(a465+a466);
  a466=(a410*a245);
  a465=(a465+a466);
  a466=(a411*a289);
  a465=(a465+a466);
  a466=(a412*a334);
  a465=(a465+a466);
  a466=(a413*a380);
  a465=(a465+a466);
  a466=(a414*a427);
  a465=(a465+a466);
  a465=(a016+a465);
  a466=cos(a465);
  a467=(a464*a466);
  a468=sin(a465);
  a469=(a463*a468);
  a467=(a467+a469);
  a469=(a467*a020);
  a470=(a469*a008);
  a471=(2.*a407);
  a472=(a406*a027);
  a473=(a408*a165);
  a472=(a472+a473);
  a473=(a409*a205);
  a472=(a472+a473);
  a473=(a410*a248);
  a472=(a472+a473);
  a473=(a411*a292);
  a472=(a472+a473);
  a473=(a412*a337);
  a472=(a472+a473);
  a473=(a413*a383);
  a472=(a472+a473);
  a473=(a414*a430);
  a472=(a472+a473);
  a472=(a024+a472);
  a473=(a471*a472);
  a474=(a473-a002);
  a475=casadi_sq(a472);
  a474=(a474-a475);
  a475=(a470*a474);
  a465=(a465-a462);
  a465=(a465+a029);
  a462=cos(a465);
  a476=(a462*a020);
  a475=(a475-a476);
  a477=(a464*a020);
  a478=(a477*a407);
  a478=(a478*a407);
  a478=(a478*a008);
  a475=(a475-a478);
  a478=(a464*a033);
  a479=(a463*a035);
  a478=(a478+a479);
  a479=(a478*a020);
  a475=(a475-a479);
  a480=(a466*a020);
  a481=(a480*a472);
  a482=(a471-a472);
  a483=(a481*a482);
  a475=(a475+a483);
  a484=(a014*a472);
  a485=(a484*a468);
  a482=(a485*a482);
  a475=(a475-a482);
  a486=(a463*a466);
  a487=(a464*a468);
  a486=(a486-a487);
  a487=(a043*a486);
  a488=(a487*a474);
  a475=(a475+a488);
  a465=sin(a465);
  a488=(a014*a465);
  a475=(a475+a488);
  a475=(a012*a475);
  a475=(a461+a475);
  a475=(a475-a047);
  a489=(a463*a033);
  a490=(a464*a035);
  a489=(a489-a490);
  a490=(a489*a013);
  a475=(a475+a490);
  a491=(2.*a464);
  a491=(a491*a008);
  a492=(a011*a491);
  a492=(a052+a492);
  a492=(a492+a011);
  a492=(a492+a056);
  a493=(a057*a463);
  a494=(a464*a014);
  a494=(a494*a008);
  a493=(a493-a494);
  a494=(a466*a014);
  a493=(a493-a494);
  a493=(a493-a014);
  a495=(a020*a468);
  a493=(a493-a495);
  a493=(a493+a061);
  a493=(a493+a491);
  a491=(a057*a486);
  a493=(a493+a491);
  a496=(a467*a014);
  a496=(a496*a008);
  a493=(a493-a496);
  a493=(a493+a065);
  a493=(a493+a066);
  a493=(a048*a493);
  a492=(a492+a493);
  a493=(a475/a492);
  a494=(a494-a063);
  a494=(a494-a064);
  a494=(a494+a495);
  a494=(a494-a491);
  a494=(a494+a496);
  a494=(a012*a494);
  a494=(a494-a055);
  a496=(a494/a492);
  a491=(a476-a488);
  a495=(a014*a468);
  a497=(a495-a480);
  a497=(a002*a497);
  a491=(a491+a497);
  a491=(a012*a491);
  a475=(a496*a475);
  a475=(a491-a475);
  a494=(a494*a496);
  a494=(a067-a494);
  a475=(a475/a494);
  a497=(a496*a475);
  a493=(a493-a497);
  a497=(a460*a493);
  a454=(a454+a497);
  a454=(a003+a454);
  a497=(a452*a454);
  a004=(a004+a497);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a024);
  a497=(a005*a245);
  a004=(a004+a497);
  a497=(a227*a289);
  a004=(a004+a497);
  a497=(a270*a334);
  a004=(a004+a497);
  a497=(a314*a380);
  a004=(a004+a497);
  a497=(a359*a427);
  a004=(a004+a497);
  a497=(a405*a472);
  a004=(a004+a497);
  a497=(a453*a027);
  a165=(a455*a165);
  a497=(a497+a165);
  a205=(a183*a205);
  a497=(a497+a205);
  a205=(a223*a248);
  a497=(a497+a205);
  a205=(a456*a292);
  a497=(a497+a205);
  a205=(a457*a337);
  a497=(a497+a205);
  a205=(a458*a383);
  a497=(a497+a205);
  a205=(a459*a430);
  a497=(a497+a205);
  a205=(a460*a475);
  a497=(a497+a205);
  a497=(a024+a497);
  a205=(a452*a497);
  a004=(a004+a205);
  a004=(a016+a004);
  if (res[0]!=0) res[0][1]=a004;
  a058=(a001*a058);
  a266=(a005*a266);
  a058=(a058+a266);
  a310=(a227*a310);
  a058=(a058+a310);
  a355=(a270*a355);
  a058=(a058+a355);
  a401=(a314*a401);
  a058=(a058+a401);
  a448=(a359*a448);
  a058=(a058+a448);
  a493=(a405*a493);
  a058=(a058+a493);
  a493=casadi_sq(a454);
  a448=(a493*a008);
  a401=(a453*a003);
  a355=(a455*a071);
  a401=(a401+a355);
  a355=(a183*a189);
  a401=(a401+a355);
  a355=(a223*a068);
  a401=(a401+a355);
  a355=(a456*a229);
  a401=(a401+a355);
  a355=(a457*a272);
  a401=(a401+a355);
  a355=(a458*a316);
  a401=(a401+a355);
  a355=(a459*a361);
  a401=(a401+a355);
  a355=(a460*a407);
  a401=(a401+a355);
  a000=(a000+a401);
  a401=sin(a000);
  a448=(a448*a401);
  a448=(a448*a013);
  a355=cos(a000);
  a310=(a453*a024);
  a266=(a455*a162);
  a310=(a310+a266);
  a266=(a183*a203);
  a310=(a310+a266);
  a266=(a223*a245);
  a310=(a310+a266);
  a266=(a456*a289);
  a310=(a310+a266);
  a266=(a457*a334);
  a310=(a310+a266);
  a266=(a458*a380);
  a310=(a310+a266);
  a266=(a459*a427);
  a310=(a310+a266);
  a266=(a460*a472);
  a310=(a310+a266);
  a016=(a016+a310);
  a310=cos(a016);
  a266=(a355*a310);
  a004=sin(a016);
  a205=(a401*a004);
  a266=(a266+a205);
  a205=(a266*a020);
  a165=(a205*a008);
  a498=(2.*a454);
  a499=(a498*a497);
  a500=(a499-a493);
  a501=casadi_sq(a497);
  a500=(a500-a501);
  a501=(a165*a500);
  a016=(a016-a000);
  a016=(a016+a029);
  a029=cos(a016);
  a000=(a029*a020);
  a501=(a501-a000);
  a502=(a355*a020);
  a503=(a502*a454);
  a503=(a503*a454);
  a503=(a503*a008);
  a501=(a501-a503);
  a503=(a355*a033);
  a504=(a401*a035);
  a503=(a503+a504);
  a504=(a503*a020);
  a501=(a501-a504);
  a505=(a310*a020);
  a506=(a505*a497);
  a507=(a498-a497);
  a508=(a506*a507);
  a501=(a501+a508);
  a509=(a014*a497);
  a510=(a509*a004);
  a507=(a510*a507);
  a501=(a501-a507);
  a511=(a401*a310);
  a512=(a355*a004);
  a511=(a511-a512);
  a043=(a043*a511);
  a512=(a043*a500);
  a501=(a501+a512);
  a016=sin(a016);
  a512=(a014*a016);
  a501=(a501+a512);
  a501=(a012*a501);
  a501=(a448+a501);
  a501=(a501-a047);
  a033=(a401*a033);
  a035=(a355*a035);
  a033=(a033-a035);
  a035=(a033*a013);
  a501=(a501+a035);
  a513=(2.*a355);
  a513=(a513*a008);
  a514=(a011*a513);
  a052=(a052+a514);
  a052=(a052+a011);
  a052=(a052+a056);
  a056=(a057*a401);
  a514=(a355*a014);
  a514=(a514*a008);
  a056=(a056-a514);
  a514=(a310*a014);
  a056=(a056-a514);
  a056=(a056-a014);
  a515=(a020*a004);
  a056=(a056-a515);
  a056=(a056+a061);
  a056=(a056+a513);
  a057=(a057*a511);
  a056=(a056+a057);
  a513=(a266*a014);
  a513=(a513*a008);
  a056=(a056-a513);
  a056=(a056+a065);
  a056=(a056+a066);
  a056=(a048*a056);
  a052=(a052+a056);
  a056=(a501/a052);
  a514=(a514-a063);
  a514=(a514-a064);
  a514=(a514+a515);
  a514=(a514-a057);
  a514=(a514+a513);
  a514=(a012*a514);
  a514=(a514-a055);
  a055=(a514/a052);
  a513=(a000-a512);
  a057=(a014*a004);
  a515=(a057-a505);
  a515=(a493*a515);
  a513=(a513+a515);
  a513=(a012*a513);
  a501=(a055*a501);
  a501=(a513-a501);
  a514=(a514*a055);
  a067=(a067-a514);
  a501=(a501/a067);
  a514=(a055*a501);
  a056=(a056-a514);
  a056=(a452*a056);
  a058=(a058+a056);
  a058=(a003+a058);
  if (res[0]!=0) res[0][2]=a058;
  a027=(a001*a027);
  a248=(a005*a248);
  a027=(a027+a248);
  a292=(a227*a292);
  a027=(a027+a292);
  a337=(a270*a337);
  a027=(a027+a337);
  a383=(a314*a383);
  a027=(a027+a383);
  a430=(a359*a430);
  a027=(a027+a430);
  a475=(a405*a475);
  a027=(a027+a475);
  a501=(a452*a501);
  a027=(a027+a501);
  a027=(a024+a027);
  if (res[0]!=0) res[0][3]=a027;
  a027=arg[0]? arg[0][4] : 0;
  a501=arg[0]? arg[0][6] : 0;
  a475=(a001*a501);
  a015=(a015*a008);
  a007=(a007*a011);
  a430=(a023*a003);
  a383=(a014*a003);
  a383=(a383*a003);
  a430=(a430-a383);
  a026=(a008*a026);
  a337=(a021*a026);
  a337=(a337-a031);
  a031=(a020*a003);
  a031=(a031*a003);
  a292=(a015*a031);
  a337=(a337-a292);
  a337=(a337-a036);
  a337=(a337+a040);
  a337=(a337-a039);
  a337=(a337+a046);
  a046=(a014*a044);
  a026=(a046*a026);
  a337=(a337+a026);
  a337=(a012*a337);
  a009=(a009+a337);
  a009=(a009-a047);
  a009=(a009+a051);
  a051=(a009/a054);
  a009=(a062*a009);
  a053=(a053-a009);
  a053=(a053/a059);
  a009=(a062*a053);
  a051=(a051-a009);
  a009=(2.*a051);
  a337=(a009*a020);
  a430=(a430-a337);
  a430=(a012*a430);
  a007=(a007+a430);
  a015=(a015*a007);
  a034=(a034*a013);
  a015=(a015+a034);
  a050=(a020*a050);
  a030=(a030*a014);
  a050=(a050-a030);
  a034=(a018*a008);
  a007=(a383+a337);
  a041=(a041*a024);
  a430=(a053*a020);
  a041=(a041-a430);
  a430=(a014*a025);
  a041=(a041-a430);
  a007=(a007+a041);
  a034=(a034*a007);
  a050=(a050-a034);
  a028=(a020*a028);
  a050=(a050-a028);
  a007=(a008*a044);
  a053=(a053*a014);
  a025=(a020*a025);
  a053=(a053-a025);
  a025=(a009*a014);
  a053=(a053-a025);
  a430=(a020*a024);
  a430=(a430*a024);
  a053=(a053+a430);
  a430=(a053+a031);
  a007=(a007*a430);
  a050=(a050+a007);
  a050=(a012*a050);
  a015=(a015+a050);
  a050=(a008*a010);
  a009=(a009*a011);
  a430=4.;
  a026=(a430*a051);
  a026=(a026-a025);
  a026=(a026+a031);
  a026=(a012*a026);
  a009=(a009+a026);
  a050=(a050*a009);
  a015=(a015+a050);
  a050=(a015/a054);
  a009=(a051*a008);
  a021=(a021+a046);
  a009=(a009*a021);
  a030=(a030+a028);
  a009=(a009+a030);
  a009=(a012*a009);
  a015=(a062*a015);
  a009=(a009-a015);
  a009=(a009/a059);
  a015=(a062*a009);
  a050=(a050-a015);
  a015=(a050*a027);
  a337=(a337+a041);
  a337=(a017*a337);
  a034=(a034+a337);
  a034=(a034-a007);
  a053=(a019*a053);
  a034=(a034+a053);
  a034=(a034+a030);
  a034=(a012*a034);
  a053=(a034/a054);
  a007=(a051*a020);
  a383=(a383-a007);
  a017=(a017*a383);
  a018=(a051*a018);
  a018=(a018*a020);
  a018=(a018*a008);
  a017=(a017-a018);
  a051=(a051*a014);
  a018=(a051*a008);
  a018=(a018*a044);
  a017=(a017-a018);
  a051=(a051+a031);
  a019=(a019*a051);
  a017=(a017+a019);
  a017=(a017-a030);
  a017=(a012*a017);
  a034=(a062*a034);
  a017=(a017-a034);
  a017=(a017/a059);
  a034=(a062*a017);
  a053=(a053-a034);
  a034=arg[0]? arg[0][5] : 0;
  a030=(a053*a034);
  a015=(a015+a030);
  a030=(a023*a008);
  a030=(a030*a010);
  a010=(a014*a012);
  a049=(a049-a010);
  a030=(a030*a049);
  a038=(a048*a038);
  a030=(a030+a038);
  a042=(a048*a042);
  a030=(a030-a042);
  a042=(a024-a003);
  a042=(a048*a042);
  a038=(a022*a042);
  a030=(a030+a038);
  a042=(a045*a042);
  a030=(a030+a042);
  a023=(a023*a012);
  a032=(a032*a008);
  a032=(a023*a032);
  a030=(a030-a032);
  a032=(a030/a054);
  a037=(a037-a060);
  a023=(a023*a037);
  a030=(a062*a030);
  a023=(a023+a030);
  a023=(a023/a059);
  a030=(a062*a023);
  a032=(a032+a030);
  a030=(a032*a501);
  a003=(a003-a024);
  a003=(a048*a003);
  a022=(a022+a045);
  a022=(a022+a037);
  a003=(a003*a022);
  a054=(a003/a054);
  a003=(a062*a003);
  a003=(a003/a059);
  a062=(a062*a003);
  a054=(a054+a062);
  a062=arg[0]? arg[0][7] : 0;
  a059=(a054*a062);
  a030=(a030+a059);
  a015=(a015+a030);
  a030=(a006*a015);
  a154=(a154*a008);
  a150=(a150*a011);
  a059=(a161*a071);
  a022=(a014*a071);
  a022=(a022*a071);
  a059=(a059-a022);
  a164=(a008*a164);
  a037=(a159*a164);
  a037=(a037-a166);
  a166=(a020*a071);
  a166=(a166*a071);
  a045=(a154*a166);
  a037=(a037-a045);
  a037=(a037-a169);
  a037=(a037+a173);
  a037=(a037-a172);
  a037=(a037+a178);
  a178=(a014*a176);
  a164=(a178*a164);
  a037=(a037+a164);
  a037=(a012*a037);
  a151=(a151+a037);
  a151=(a151-a047);
  a151=(a151+a180);
  a180=(a151/a182);
  a151=(a186*a151);
  a181=(a181-a151);
  a181=(a181/a184);
  a151=(a186*a181);
  a180=(a180-a151);
  a151=(2.*a180);
  a037=(a151*a020);
  a059=(a059-a037);
  a059=(a012*a059);
  a150=(a150+a059);
  a154=(a154*a150);
  a168=(a168*a013);
  a154=(a154+a168);
  a179=(a020*a179);
  a152=(a152*a014);
  a179=(a179-a152);
  a168=(a157*a008);
  a150=(a022+a037);
  a174=(a174*a162);
  a059=(a181*a020);
  a174=(a174-a059);
  a059=(a014*a163);
  a174=(a174-a059);
  a150=(a150+a174);
  a168=(a168*a150);
  a179=(a179-a168);
  a155=(a020*a155);
  a179=(a179-a155);
  a150=(a008*a176);
  a181=(a181*a014);
  a163=(a020*a163);
  a181=(a181-a163);
  a163=(a151*a014);
  a181=(a181-a163);
  a059=(a020*a162);
  a059=(a059*a162);
  a181=(a181+a059);
  a059=(a181+a166);
  a150=(a150*a059);
  a179=(a179+a150);
  a179=(a012*a179);
  a154=(a154+a179);
  a179=(a008*a153);
  a151=(a151*a011);
  a059=(a430*a180);
  a059=(a059-a163);
  a059=(a059+a166);
  a059=(a012*a059);
  a151=(a151+a059);
  a179=(a179*a151);
  a154=(a154+a179);
  a179=(a154/a182);
  a151=(a180*a008);
  a159=(a159+a178);
  a151=(a151*a159);
  a152=(a152+a155);
  a151=(a151+a152);
  a151=(a012*a151);
  a154=(a186*a154);
  a151=(a151-a154);
  a151=(a151/a184);
  a154=(a186*a151);
  a179=(a179-a154);
  a154=(a070*a501);
  a155=(a073*a015);
  a082=(a082*a008);
  a078=(a078*a011);
  a159=(a089*a077);
  a178=(a014*a077);
  a178=(a178*a077);
  a159=(a159-a178);
  a092=(a008*a092);
  a059=(a087*a092);
  a059=(a059-a094);
  a094=(a020*a077);
  a094=(a094*a077);
  a163=(a082*a094);
  a059=(a059-a163);
  a059=(a059-a097);
  a059=(a059+a101);
  a059=(a059-a100);
  a059=(a059+a106);
  a106=(a014*a104);
  a092=(a106*a092);
  a059=(a059+a092);
  a059=(a012*a059);
  a079=(a079+a059);
  a079=(a079-a047);
  a079=(a079+a108);
  a108=(a079/a110);
  a079=(a114*a079);
  a109=(a109-a079);
  a109=(a109/a112);
  a079=(a114*a109);
  a108=(a108-a079);
  a079=(2.*a108);
  a059=(a079*a020);
  a159=(a159-a059);
  a159=(a012*a159);
  a078=(a078+a159);
  a082=(a082*a078);
  a096=(a096*a013);
  a082=(a082+a096);
  a107=(a020*a107);
  a080=(a080*a014);
  a107=(a107-a080);
  a096=(a085*a008);
  a078=(a178+a059);
  a102=(a102*a090);
  a159=(a109*a020);
  a102=(a102-a159);
  a159=(a014*a091);
  a102=(a102-a159);
  a078=(a078+a102);
  a096=(a096*a078);
  a107=(a107-a096);
  a083=(a020*a083);
  a107=(a107-a083);
  a078=(a008*a104);
  a109=(a109*a014);
  a091=(a020*a091);
  a109=(a109-a091);
  a091=(a079*a014);
  a109=(a109-a091);
  a159=(a020*a090);
  a159=(a159*a090);
  a109=(a109+a159);
  a159=(a109+a094);
  a078=(a078*a159);
  a107=(a107+a078);
  a107=(a012*a107);
  a082=(a082+a107);
  a107=(a008*a081);
  a079=(a079*a011);
  a159=(a430*a108);
  a159=(a159-a091);
  a159=(a159+a094);
  a159=(a012*a159);
  a079=(a079+a159);
  a107=(a107*a079);
  a082=(a082+a107);
  a107=(a082/a110);
  a079=(a108*a008);
  a087=(a087+a106);
  a079=(a079*a087);
  a080=(a080+a083);
  a079=(a079+a080);
  a079=(a012*a079);
  a082=(a114*a082);
  a079=(a079-a082);
  a079=(a079/a112);
  a082=(a114*a079);
  a107=(a107-a082);
  a082=(a076*a501);
  a082=(a027+a082);
  a083=(a107*a082);
  a059=(a059+a102);
  a059=(a084*a059);
  a096=(a096+a059);
  a096=(a096-a078);
  a109=(a086*a109);
  a096=(a096+a109);
  a096=(a096+a080);
  a096=(a012*a096);
  a109=(a096/a110);
  a078=(a108*a020);
  a178=(a178-a078);
  a084=(a084*a178);
  a085=(a108*a085);
  a085=(a085*a020);
  a085=(a085*a008);
  a084=(a084-a085);
  a108=(a108*a014);
  a085=(a108*a008);
  a085=(a085*a104);
  a084=(a084-a085);
  a108=(a108+a094);
  a086=(a086*a108);
  a084=(a084+a086);
  a084=(a084-a080);
  a084=(a012*a084);
  a096=(a114*a096);
  a084=(a084-a096);
  a084=(a084/a112);
  a096=(a114*a084);
  a109=(a109-a096);
  a096=(a076*a062);
  a096=(a034+a096);
  a080=(a109*a096);
  a083=(a083+a080);
  a080=(a089*a008);
  a080=(a080*a081);
  a080=(a080*a049);
  a099=(a048*a099);
  a080=(a080+a099);
  a103=(a048*a103);
  a080=(a080-a103);
  a103=(a090-a077);
  a103=(a048*a103);
  a099=(a088*a103);
  a080=(a080+a099);
  a103=(a105*a103);
  a080=(a080+a103);
  a089=(a089*a012);
  a095=(a095*a008);
  a095=(a089*a095);
  a080=(a080-a095);
  a095=(a080/a110);
  a098=(a098-a113);
  a089=(a089*a098);
  a080=(a114*a080);
  a089=(a089+a080);
  a089=(a089/a112);
  a080=(a114*a089);
  a095=(a095+a080);
  a080=(a076*a015);
  a080=(a501+a080);
  a113=(a095*a080);
  a077=(a077-a090);
  a077=(a048*a077);
  a088=(a088+a105);
  a088=(a088+a098);
  a077=(a077*a088);
  a110=(a077/a110);
  a077=(a114*a077);
  a077=(a077/a112);
  a114=(a114*a077);
  a110=(a110+a114);
  a114=(a009*a027);
  a112=(a017*a034);
  a114=(a114+a112);
  a112=(a023*a501);
  a088=(a003*a062);
  a112=(a112+a088);
  a114=(a114-a112);
  a112=(a076*a114);
  a112=(a062+a112);
  a088=(a110*a112);
  a113=(a113+a088);
  a083=(a083+a113);
  a083=(a075*a083);
  a155=(a155+a083);
  a155=(a501+a155);
  a083=(a072*a155);
  a154=(a154+a083);
  a154=(a027+a154);
  a083=(a179*a154);
  a037=(a037+a174);
  a037=(a156*a037);
  a168=(a168+a037);
  a168=(a168-a150);
  a181=(a158*a181);
  a168=(a168+a181);
  a168=(a168+a152);
  a168=(a012*a168);
  a181=(a168/a182);
  a150=(a180*a020);
  a022=(a022-a150);
  a156=(a156*a022);
  a157=(a180*a157);
  a157=(a157*a020);
  a157=(a157*a008);
  a156=(a156-a157);
  a180=(a180*a014);
  a157=(a180*a008);
  a157=(a157*a176);
  a156=(a156-a157);
  a180=(a180+a166);
  a158=(a158*a180);
  a156=(a156+a158);
  a156=(a156-a152);
  a156=(a012*a156);
  a168=(a186*a168);
  a156=(a156-a168);
  a156=(a156/a184);
  a168=(a186*a156);
  a181=(a181-a168);
  a168=(a070*a062);
  a152=(a073*a114);
  a082=(a079*a082);
  a096=(a084*a096);
  a082=(a082+a096);
  a096=(a089*a080);
  a158=(a077*a112);
  a096=(a096+a158);
  a082=(a082-a096);
  a082=(a075*a082);
  a152=(a152+a082);
  a152=(a062+a152);
  a082=(a072*a152);
  a168=(a168+a082);
  a168=(a034+a168);
  a082=(a181*a168);
  a083=(a083+a082);
  a082=(a161*a008);
  a082=(a082*a153);
  a082=(a082*a049);
  a171=(a048*a171);
  a082=(a082+a171);
  a175=(a048*a175);
  a082=(a082-a175);
  a175=(a162-a071);
  a175=(a048*a175);
  a171=(a160*a175);
  a082=(a082+a171);
  a175=(a177*a175);
  a082=(a082+a175);
  a161=(a161*a012);
  a167=(a167*a008);
  a167=(a161*a167);
  a082=(a082-a167);
  a167=(a082/a182);
  a170=(a170-a185);
  a161=(a161*a170);
  a082=(a186*a082);
  a161=(a161+a082);
  a161=(a161/a184);
  a082=(a186*a161);
  a167=(a167+a082);
  a082=(a070*a015);
  a118=(a118*a008);
  a111=(a111*a011);
  a185=(a125*a074);
  a175=(a014*a074);
  a175=(a175*a074);
  a185=(a185-a175);
  a127=(a008*a127);
  a171=(a123*a127);
  a171=(a171-a129);
  a129=(a020*a074);
  a129=(a129*a074);
  a153=(a118*a129);
  a171=(a171-a153);
  a171=(a171-a132);
  a171=(a171+a136);
  a171=(a171-a135);
  a171=(a171+a141);
  a141=(a014*a139);
  a127=(a141*a127);
  a171=(a171+a127);
  a171=(a012*a171);
  a115=(a115+a171);
  a115=(a115-a047);
  a115=(a115+a143);
  a143=(a115/a145);
  a115=(a149*a115);
  a144=(a144-a115);
  a144=(a144/a147);
  a115=(a149*a144);
  a143=(a143-a115);
  a115=(2.*a143);
  a171=(a115*a020);
  a185=(a185-a171);
  a185=(a012*a185);
  a111=(a111+a185);
  a118=(a118*a111);
  a131=(a131*a013);
  a118=(a118+a131);
  a142=(a020*a142);
  a116=(a116*a014);
  a142=(a142-a116);
  a131=(a121*a008);
  a111=(a175+a171);
  a137=(a137*a126);
  a185=(a144*a020);
  a137=(a137-a185);
  a185=(a014*a093);
  a137=(a137-a185);
  a111=(a111+a137);
  a131=(a131*a111);
  a142=(a142-a131);
  a119=(a020*a119);
  a142=(a142-a119);
  a111=(a008*a139);
  a144=(a144*a014);
  a093=(a020*a093);
  a144=(a144-a093);
  a093=(a115*a014);
  a144=(a144-a093);
  a185=(a020*a126);
  a185=(a185*a126);
  a144=(a144+a185);
  a185=(a144+a129);
  a111=(a111*a185);
  a142=(a142+a111);
  a142=(a012*a142);
  a118=(a118+a142);
  a142=(a008*a117);
  a115=(a115*a011);
  a185=(a430*a143);
  a185=(a185-a093);
  a185=(a185+a129);
  a185=(a012*a185);
  a115=(a115+a185);
  a142=(a142*a115);
  a118=(a118+a142);
  a142=(a118/a145);
  a115=(a143*a008);
  a123=(a123+a141);
  a115=(a115*a123);
  a116=(a116+a119);
  a115=(a115+a116);
  a115=(a012*a115);
  a118=(a149*a118);
  a115=(a115-a118);
  a115=(a115/a147);
  a118=(a149*a115);
  a142=(a142-a118);
  a118=(a073*a501);
  a080=(a075*a080);
  a118=(a118+a080);
  a118=(a027+a118);
  a080=(a142*a118);
  a171=(a171+a137);
  a171=(a120*a171);
  a131=(a131+a171);
  a131=(a131-a111);
  a144=(a122*a144);
  a131=(a131+a144);
  a131=(a131+a116);
  a131=(a012*a131);
  a144=(a131/a145);
  a111=(a143*a020);
  a175=(a175-a111);
  a120=(a120*a175);
  a121=(a143*a121);
  a121=(a121*a020);
  a121=(a121*a008);
  a120=(a120-a121);
  a143=(a143*a014);
  a121=(a143*a008);
  a121=(a121*a139);
  a120=(a120-a121);
  a143=(a143+a129);
  a122=(a122*a143);
  a120=(a120+a122);
  a120=(a120-a116);
  a120=(a012*a120);
  a131=(a149*a131);
  a120=(a120-a131);
  a120=(a120/a147);
  a131=(a149*a120);
  a144=(a144-a131);
  a131=(a073*a062);
  a112=(a075*a112);
  a131=(a131+a112);
  a131=(a034+a131);
  a112=(a144*a131);
  a080=(a080+a112);
  a112=(a125*a008);
  a112=(a112*a117);
  a112=(a112*a049);
  a134=(a048*a134);
  a112=(a112+a134);
  a138=(a048*a138);
  a112=(a112-a138);
  a138=(a126-a074);
  a138=(a048*a138);
  a134=(a124*a138);
  a112=(a112+a134);
  a138=(a140*a138);
  a112=(a112+a138);
  a125=(a125*a012);
  a130=(a130*a008);
  a130=(a125*a130);
  a112=(a112-a130);
  a130=(a112/a145);
  a133=(a133-a148);
  a125=(a125*a133);
  a112=(a149*a112);
  a125=(a125+a112);
  a125=(a125/a147);
  a112=(a149*a125);
  a130=(a130+a112);
  a112=(a130*a155);
  a074=(a074-a126);
  a074=(a048*a074);
  a124=(a124+a140);
  a124=(a124+a133);
  a074=(a074*a124);
  a145=(a074/a145);
  a074=(a149*a074);
  a074=(a074/a147);
  a149=(a149*a074);
  a145=(a145+a149);
  a149=(a145*a152);
  a112=(a112+a149);
  a080=(a080+a112);
  a112=(a072*a080);
  a082=(a082+a112);
  a082=(a501+a082);
  a112=(a167*a082);
  a071=(a071-a162);
  a071=(a048*a071);
  a160=(a160+a177);
  a160=(a160+a170);
  a071=(a071*a160);
  a182=(a071/a182);
  a071=(a186*a071);
  a071=(a071/a184);
  a186=(a186*a071);
  a182=(a182+a186);
  a186=(a070*a114);
  a118=(a115*a118);
  a131=(a120*a131);
  a118=(a118+a131);
  a131=(a125*a155);
  a184=(a074*a152);
  a131=(a131+a184);
  a118=(a118-a131);
  a131=(a072*a118);
  a186=(a186+a131);
  a186=(a062+a186);
  a131=(a182*a186);
  a112=(a112+a131);
  a083=(a083+a112);
  a112=(a069*a083);
  a030=(a030+a112);
  a195=(a195*a008);
  a191=(a191*a011);
  a112=(a202*a189);
  a131=(a014*a189);
  a131=(a131*a189);
  a112=(a112-a131);
  a204=(a008*a204);
  a184=(a200*a204);
  a184=(a184-a206);
  a206=(a020*a189);
  a206=(a206*a189);
  a160=(a195*a206);
  a184=(a184-a160);
  a184=(a184-a209);
  a184=(a184+a213);
  a184=(a184-a212);
  a184=(a184+a218);
  a218=(a014*a216);
  a204=(a218*a204);
  a184=(a184+a204);
  a184=(a012*a184);
  a192=(a192+a184);
  a192=(a192-a047);
  a192=(a192+a220);
  a220=(a192/a222);
  a192=(a226*a192);
  a221=(a221-a192);
  a221=(a221/a224);
  a192=(a226*a221);
  a220=(a220-a192);
  a192=(2.*a220);
  a184=(a192*a020);
  a112=(a112-a184);
  a112=(a012*a112);
  a191=(a191+a112);
  a195=(a195*a191);
  a208=(a208*a013);
  a195=(a195+a208);
  a219=(a020*a219);
  a193=(a193*a014);
  a219=(a219-a193);
  a208=(a198*a008);
  a191=(a131+a184);
  a214=(a214*a203);
  a112=(a221*a020);
  a214=(a214-a112);
  a112=(a014*a128);
  a214=(a214-a112);
  a191=(a191+a214);
  a208=(a208*a191);
  a219=(a219-a208);
  a196=(a020*a196);
  a219=(a219-a196);
  a191=(a008*a216);
  a221=(a221*a014);
  a128=(a020*a128);
  a221=(a221-a128);
  a128=(a192*a014);
  a221=(a221-a128);
  a112=(a020*a203);
  a112=(a112*a203);
  a221=(a221+a112);
  a112=(a221+a206);
  a191=(a191*a112);
  a219=(a219+a191);
  a219=(a012*a219);
  a195=(a195+a219);
  a219=(a008*a194);
  a192=(a192*a011);
  a112=(a430*a220);
  a112=(a112-a128);
  a112=(a112+a206);
  a112=(a012*a112);
  a192=(a192+a112);
  a219=(a219*a192);
  a195=(a195+a219);
  a219=(a195/a222);
  a192=(a220*a008);
  a200=(a200+a218);
  a192=(a192*a200);
  a193=(a193+a196);
  a192=(a192+a193);
  a192=(a012*a192);
  a195=(a226*a195);
  a192=(a192-a195);
  a192=(a192/a224);
  a195=(a226*a192);
  a219=(a219-a195);
  a195=(a188*a501);
  a155=(a190*a155);
  a195=(a195+a155);
  a155=(a146*a082);
  a195=(a195+a155);
  a195=(a027+a195);
  a155=(a219*a195);
  a184=(a184+a214);
  a184=(a197*a184);
  a208=(a208+a184);
  a208=(a208-a191);
  a221=(a199*a221);
  a208=(a208+a221);
  a208=(a208+a193);
  a208=(a012*a208);
  a221=(a208/a222);
  a191=(a220*a020);
  a131=(a131-a191);
  a197=(a197*a131);
  a198=(a220*a198);
  a198=(a198*a020);
  a198=(a198*a008);
  a197=(a197-a198);
  a220=(a220*a014);
  a198=(a220*a008);
  a198=(a198*a216);
  a197=(a197-a198);
  a220=(a220+a206);
  a199=(a199*a220);
  a197=(a197+a199);
  a197=(a197-a193);
  a197=(a012*a197);
  a208=(a226*a208);
  a197=(a197-a208);
  a197=(a197/a224);
  a208=(a226*a197);
  a221=(a221-a208);
  a208=(a188*a062);
  a152=(a190*a152);
  a208=(a208+a152);
  a152=(a146*a186);
  a208=(a208+a152);
  a208=(a034+a208);
  a152=(a221*a208);
  a155=(a155+a152);
  a152=(a202*a008);
  a152=(a152*a194);
  a152=(a152*a049);
  a211=(a048*a211);
  a152=(a152+a211);
  a215=(a048*a215);
  a152=(a152-a215);
  a215=(a203-a189);
  a215=(a048*a215);
  a211=(a201*a215);
  a152=(a152+a211);
  a215=(a217*a215);
  a152=(a152+a215);
  a202=(a202*a012);
  a207=(a207*a008);
  a207=(a202*a207);
  a152=(a152-a207);
  a207=(a152/a222);
  a210=(a210-a225);
  a202=(a202*a210);
  a152=(a226*a152);
  a202=(a202+a152);
  a202=(a202/a224);
  a152=(a226*a202);
  a207=(a207+a152);
  a152=(a188*a015);
  a080=(a190*a080);
  a152=(a152+a080);
  a080=(a146*a083);
  a152=(a152+a080);
  a152=(a501+a152);
  a080=(a207*a152);
  a189=(a189-a203);
  a189=(a048*a189);
  a201=(a201+a217);
  a201=(a201+a210);
  a189=(a189*a201);
  a222=(a189/a222);
  a189=(a226*a189);
  a189=(a189/a224);
  a226=(a226*a189);
  a222=(a222+a226);
  a226=(a188*a114);
  a118=(a190*a118);
  a226=(a226+a118);
  a154=(a151*a154);
  a168=(a156*a168);
  a154=(a154+a168);
  a168=(a161*a082);
  a118=(a071*a186);
  a168=(a168+a118);
  a154=(a154-a168);
  a168=(a146*a154);
  a226=(a226+a168);
  a226=(a062+a226);
  a168=(a222*a226);
  a080=(a080+a168);
  a155=(a155+a080);
  a080=(a187*a155);
  a030=(a030+a080);
  a030=(a501+a030);
  a080=(a005*a030);
  a475=(a475+a080);
  a080=(a228*a015);
  a168=(a230*a083);
  a080=(a080+a168);
  a168=(a231*a155);
  a080=(a080+a168);
  a237=(a237*a008);
  a233=(a233*a011);
  a168=(a244*a068);
  a118=(a014*a068);
  a118=(a118*a068);
  a168=(a168-a118);
  a247=(a008*a247);
  a224=(a242*a247);
  a224=(a224-a249);
  a249=(a020*a068);
  a249=(a249*a068);
  a201=(a237*a249);
  a224=(a224-a201);
  a224=(a224-a252);
  a224=(a224+a256);
  a224=(a224-a255);
  a224=(a224+a261);
  a261=(a014*a259);
  a247=(a261*a247);
  a224=(a224+a247);
  a224=(a012*a224);
  a234=(a234+a224);
  a234=(a234-a047);
  a234=(a234+a263);
  a263=(a234/a265);
  a234=(a269*a234);
  a264=(a264-a234);
  a264=(a264/a267);
  a234=(a269*a264);
  a263=(a263-a234);
  a234=(2.*a263);
  a224=(a234*a020);
  a168=(a168-a224);
  a168=(a012*a168);
  a233=(a233+a168);
  a237=(a237*a233);
  a251=(a251*a013);
  a237=(a237+a251);
  a262=(a020*a262);
  a235=(a235*a014);
  a262=(a262-a235);
  a251=(a240*a008);
  a233=(a118+a224);
  a257=(a257*a245);
  a168=(a264*a020);
  a257=(a257-a168);
  a168=(a014*a246);
  a257=(a257-a168);
  a233=(a233+a257);
  a251=(a251*a233);
  a262=(a262-a251);
  a238=(a020*a238);
  a262=(a262-a238);
  a233=(a008*a259);
  a264=(a264*a014);
  a246=(a020*a246);
  a264=(a264-a246);
  a246=(a234*a014);
  a264=(a264-a246);
  a168=(a020*a245);
  a168=(a168*a245);
  a264=(a264+a168);
  a168=(a264+a249);
  a233=(a233*a168);
  a262=(a262+a233);
  a262=(a012*a262);
  a237=(a237+a262);
  a262=(a008*a236);
  a234=(a234*a011);
  a168=(a430*a263);
  a168=(a168-a246);
  a168=(a168+a249);
  a168=(a012*a168);
  a234=(a234+a168);
  a262=(a262*a234);
  a237=(a237+a262);
  a262=(a237/a265);
  a234=(a263*a008);
  a242=(a242+a261);
  a234=(a234*a242);
  a235=(a235+a238);
  a234=(a234+a235);
  a234=(a012*a234);
  a237=(a269*a237);
  a234=(a234-a237);
  a234=(a234/a267);
  a237=(a269*a234);
  a262=(a262-a237);
  a237=(a006*a501);
  a238=(a069*a082);
  a237=(a237+a238);
  a238=(a187*a152);
  a237=(a237+a238);
  a237=(a027+a237);
  a238=(a262*a237);
  a224=(a224+a257);
  a224=(a239*a224);
  a251=(a251+a224);
  a251=(a251-a233);
  a264=(a241*a264);
  a251=(a251+a264);
  a251=(a251+a235);
  a251=(a012*a251);
  a264=(a251/a265);
  a233=(a263*a020);
  a118=(a118-a233);
  a239=(a239*a118);
  a240=(a263*a240);
  a240=(a240*a020);
  a240=(a240*a008);
  a239=(a239-a240);
  a263=(a263*a014);
  a240=(a263*a008);
  a240=(a240*a259);
  a239=(a239-a240);
  a263=(a263+a249);
  a241=(a241*a263);
  a239=(a239+a241);
  a239=(a239-a235);
  a239=(a012*a239);
  a251=(a269*a251);
  a239=(a239-a251);
  a239=(a239/a267);
  a251=(a269*a239);
  a264=(a264-a251);
  a251=(a006*a062);
  a235=(a069*a186);
  a251=(a251+a235);
  a235=(a187*a226);
  a251=(a251+a235);
  a251=(a034+a251);
  a235=(a264*a251);
  a238=(a238+a235);
  a235=(a244*a008);
  a235=(a235*a236);
  a235=(a235*a049);
  a254=(a048*a254);
  a235=(a235+a254);
  a258=(a048*a258);
  a235=(a235-a258);
  a258=(a245-a068);
  a258=(a048*a258);
  a254=(a243*a258);
  a235=(a235+a254);
  a258=(a260*a258);
  a235=(a235+a258);
  a244=(a244*a012);
  a250=(a250*a008);
  a250=(a244*a250);
  a235=(a235-a250);
  a250=(a235/a265);
  a253=(a253-a268);
  a244=(a244*a253);
  a235=(a269*a235);
  a244=(a244+a235);
  a244=(a244/a267);
  a235=(a269*a244);
  a250=(a250+a235);
  a235=(a250*a030);
  a068=(a068-a245);
  a068=(a048*a068);
  a243=(a243+a260);
  a243=(a243+a253);
  a068=(a068*a243);
  a265=(a068/a265);
  a068=(a269*a068);
  a068=(a068/a267);
  a269=(a269*a068);
  a265=(a265+a269);
  a269=(a006*a114);
  a267=(a069*a154);
  a269=(a269+a267);
  a195=(a192*a195);
  a208=(a197*a208);
  a195=(a195+a208);
  a208=(a202*a152);
  a267=(a189*a226);
  a208=(a208+a267);
  a195=(a195-a208);
  a208=(a187*a195);
  a269=(a269+a208);
  a269=(a062+a269);
  a208=(a265*a269);
  a235=(a235+a208);
  a238=(a238+a235);
  a235=(a232*a238);
  a080=(a080+a235);
  a080=(a501+a080);
  a235=(a227*a080);
  a475=(a475+a235);
  a235=(a271*a015);
  a208=(a273*a083);
  a235=(a235+a208);
  a208=(a274*a155);
  a235=(a235+a208);
  a208=(a275*a238);
  a235=(a235+a208);
  a281=(a281*a008);
  a277=(a277*a011);
  a208=(a288*a229);
  a267=(a014*a229);
  a267=(a267*a229);
  a208=(a208-a267);
  a291=(a008*a291);
  a243=(a286*a291);
  a243=(a243-a293);
  a293=(a020*a229);
  a293=(a293*a229);
  a253=(a281*a293);
  a243=(a243-a253);
  a243=(a243-a296);
  a243=(a243+a300);
  a243=(a243-a299);
  a243=(a243+a305);
  a305=(a014*a303);
  a291=(a305*a291);
  a243=(a243+a291);
  a243=(a012*a243);
  a278=(a278+a243);
  a278=(a278-a047);
  a278=(a278+a307);
  a307=(a278/a309);
  a278=(a313*a278);
  a308=(a308-a278);
  a308=(a308/a311);
  a278=(a313*a308);
  a307=(a307-a278);
  a278=(2.*a307);
  a243=(a278*a020);
  a208=(a208-a243);
  a208=(a012*a208);
  a277=(a277+a208);
  a281=(a281*a277);
  a295=(a295*a013);
  a281=(a281+a295);
  a306=(a020*a306);
  a279=(a279*a014);
  a306=(a306-a279);
  a295=(a284*a008);
  a277=(a267+a243);
  a301=(a301*a289);
  a208=(a308*a020);
  a301=(a301-a208);
  a208=(a014*a290);
  a301=(a301-a208);
  a277=(a277+a301);
  a295=(a295*a277);
  a306=(a306-a295);
  a282=(a020*a282);
  a306=(a306-a282);
  a277=(a008*a303);
  a308=(a308*a014);
  a290=(a020*a290);
  a308=(a308-a290);
  a290=(a278*a014);
  a308=(a308-a290);
  a208=(a020*a289);
  a208=(a208*a289);
  a308=(a308+a208);
  a208=(a308+a293);
  a277=(a277*a208);
  a306=(a306+a277);
  a306=(a012*a306);
  a281=(a281+a306);
  a306=(a008*a280);
  a278=(a278*a011);
  a208=(a430*a307);
  a208=(a208-a290);
  a208=(a208+a293);
  a208=(a012*a208);
  a278=(a278+a208);
  a306=(a306*a278);
  a281=(a281+a306);
  a306=(a281/a309);
  a278=(a307*a008);
  a286=(a286+a305);
  a278=(a278*a286);
  a279=(a279+a282);
  a278=(a278+a279);
  a278=(a012*a278);
  a281=(a313*a281);
  a278=(a278-a281);
  a278=(a278/a311);
  a281=(a313*a278);
  a306=(a306-a281);
  a281=(a228*a501);
  a282=(a230*a082);
  a281=(a281+a282);
  a282=(a231*a152);
  a281=(a281+a282);
  a282=(a232*a030);
  a281=(a281+a282);
  a281=(a027+a281);
  a282=(a306*a281);
  a243=(a243+a301);
  a243=(a283*a243);
  a295=(a295+a243);
  a295=(a295-a277);
  a308=(a285*a308);
  a295=(a295+a308);
  a295=(a295+a279);
  a295=(a012*a295);
  a308=(a295/a309);
  a277=(a307*a020);
  a267=(a267-a277);
  a283=(a283*a267);
  a284=(a307*a284);
  a284=(a284*a020);
  a284=(a284*a008);
  a283=(a283-a284);
  a307=(a307*a014);
  a284=(a307*a008);
  a284=(a284*a303);
  a283=(a283-a284);
  a307=(a307+a293);
  a285=(a285*a307);
  a283=(a283+a285);
  a283=(a283-a279);
  a283=(a012*a283);
  a295=(a313*a295);
  a283=(a283-a295);
  a283=(a283/a311);
  a295=(a313*a283);
  a308=(a308-a295);
  a295=(a228*a062);
  a279=(a230*a186);
  a295=(a295+a279);
  a279=(a231*a226);
  a295=(a295+a279);
  a279=(a232*a269);
  a295=(a295+a279);
  a295=(a034+a295);
  a279=(a308*a295);
  a282=(a282+a279);
  a279=(a288*a008);
  a279=(a279*a280);
  a279=(a279*a049);
  a298=(a048*a298);
  a279=(a279+a298);
  a302=(a048*a302);
  a279=(a279-a302);
  a302=(a289-a229);
  a302=(a048*a302);
  a298=(a287*a302);
  a279=(a279+a298);
  a302=(a304*a302);
  a279=(a279+a302);
  a288=(a288*a012);
  a294=(a294*a008);
  a294=(a288*a294);
  a279=(a279-a294);
  a294=(a279/a309);
  a297=(a297-a312);
  a288=(a288*a297);
  a279=(a313*a279);
  a288=(a288+a279);
  a288=(a288/a311);
  a279=(a313*a288);
  a294=(a294+a279);
  a279=(a294*a080);
  a229=(a229-a289);
  a229=(a048*a229);
  a287=(a287+a304);
  a287=(a287+a297);
  a229=(a229*a287);
  a309=(a229/a309);
  a229=(a313*a229);
  a229=(a229/a311);
  a313=(a313*a229);
  a309=(a309+a313);
  a313=(a228*a114);
  a311=(a230*a154);
  a313=(a313+a311);
  a311=(a231*a195);
  a313=(a313+a311);
  a237=(a234*a237);
  a251=(a239*a251);
  a237=(a237+a251);
  a251=(a244*a030);
  a311=(a068*a269);
  a251=(a251+a311);
  a237=(a237-a251);
  a251=(a232*a237);
  a313=(a313+a251);
  a313=(a062+a313);
  a251=(a309*a313);
  a279=(a279+a251);
  a282=(a282+a279);
  a279=(a276*a282);
  a235=(a235+a279);
  a235=(a501+a235);
  a279=(a270*a235);
  a475=(a475+a279);
  a279=(a315*a015);
  a251=(a317*a083);
  a279=(a279+a251);
  a251=(a318*a155);
  a279=(a279+a251);
  a251=(a319*a238);
  a279=(a279+a251);
  a251=(a320*a282);
  a279=(a279+a251);
  a326=(a326*a008);
  a322=(a322*a011);
  a251=(a333*a272);
  a311=(a014*a272);
  a311=(a311*a272);
  a251=(a251-a311);
  a336=(a008*a336);
  a287=(a331*a336);
  a287=(a287-a338);
  a338=(a020*a272);
  a338=(a338*a272);
  a297=(a326*a338);
  a287=(a287-a297);
  a287=(a287-a341);
  a287=(a287+a345);
  a287=(a287-a344);
  a287=(a287+a350);
  a350=(a014*a348);
  a336=(a350*a336);
  a287=(a287+a336);
  a287=(a012*a287);
  a323=(a323+a287);
  a323=(a323-a047);
  a323=(a323+a352);
  a352=(a323/a354);
  a323=(a358*a323);
  a353=(a353-a323);
  a353=(a353/a356);
  a323=(a358*a353);
  a352=(a352-a323);
  a323=(2.*a352);
  a287=(a323*a020);
  a251=(a251-a287);
  a251=(a012*a251);
  a322=(a322+a251);
  a326=(a326*a322);
  a340=(a340*a013);
  a326=(a326+a340);
  a351=(a020*a351);
  a324=(a324*a014);
  a351=(a351-a324);
  a340=(a329*a008);
  a322=(a311+a287);
  a346=(a346*a334);
  a251=(a353*a020);
  a346=(a346-a251);
  a251=(a014*a335);
  a346=(a346-a251);
  a322=(a322+a346);
  a340=(a340*a322);
  a351=(a351-a340);
  a327=(a020*a327);
  a351=(a351-a327);
  a322=(a008*a348);
  a353=(a353*a014);
  a335=(a020*a335);
  a353=(a353-a335);
  a335=(a323*a014);
  a353=(a353-a335);
  a251=(a020*a334);
  a251=(a251*a334);
  a353=(a353+a251);
  a251=(a353+a338);
  a322=(a322*a251);
  a351=(a351+a322);
  a351=(a012*a351);
  a326=(a326+a351);
  a351=(a008*a325);
  a323=(a323*a011);
  a251=(a430*a352);
  a251=(a251-a335);
  a251=(a251+a338);
  a251=(a012*a251);
  a323=(a323+a251);
  a351=(a351*a323);
  a326=(a326+a351);
  a351=(a326/a354);
  a323=(a352*a008);
  a331=(a331+a350);
  a323=(a323*a331);
  a324=(a324+a327);
  a323=(a323+a324);
  a323=(a012*a323);
  a326=(a358*a326);
  a323=(a323-a326);
  a323=(a323/a356);
  a326=(a358*a323);
  a351=(a351-a326);
  a326=(a271*a501);
  a327=(a273*a082);
  a326=(a326+a327);
  a327=(a274*a152);
  a326=(a326+a327);
  a327=(a275*a030);
  a326=(a326+a327);
  a327=(a276*a080);
  a326=(a326+a327);
  a326=(a027+a326);
  a327=(a351*a326);
  a287=(a287+a346);
  a287=(a328*a287);
  a340=(a340+a287);
  a340=(a340-a322);
  a353=(a330*a353);
  a340=(a340+a353);
  a340=(a340+a324);
  a340=(a012*a340);
  a353=(a340/a354);
  a322=(a352*a020);
  a311=(a311-a322);
  a328=(a328*a311);
  a329=(a352*a329);
  a329=(a329*a020);
  a329=(a329*a008);
  a328=(a328-a329);
  a352=(a352*a014);
  a329=(a352*a008);
  a329=(a329*a348);
  a328=(a328-a329);
  a352=(a352+a338);
  a330=(a330*a352);
  a328=(a328+a330);
  a328=(a328-a324);
  a328=(a012*a328);
  a340=(a358*a340);
  a328=(a328-a340);
  a328=(a328/a356);
  a340=(a358*a328);
  a353=(a353-a340);
  a340=(a271*a062);
  a324=(a273*a186);
  a340=(a340+a324);
  a324=(a274*a226);
  a340=(a340+a324);
  a324=(a275*a269);
  a340=(a340+a324);
  a324=(a276*a313);
  a340=(a340+a324);
  a340=(a034+a340);
  a324=(a353*a340);
  a327=(a327+a324);
  a324=(a333*a008);
  a324=(a324*a325);
  a324=(a324*a049);
  a343=(a048*a343);
  a324=(a324+a343);
  a347=(a048*a347);
  a324=(a324-a347);
  a347=(a334-a272);
  a347=(a048*a347);
  a343=(a332*a347);
  a324=(a324+a343);
  a347=(a349*a347);
  a324=(a324+a347);
  a333=(a333*a012);
  a339=(a339*a008);
  a339=(a333*a339);
  a324=(a324-a339);
  a339=(a324/a354);
  a342=(a342-a357);
  a333=(a333*a342);
  a324=(a358*a324);
  a333=(a333+a324);
  a333=(a333/a356);
  a324=(a358*a333);
  a339=(a339+a324);
  a324=(a339*a235);
  a272=(a272-a334);
  a272=(a048*a272);
  a332=(a332+a349);
  a332=(a332+a342);
  a272=(a272*a332);
  a354=(a272/a354);
  a272=(a358*a272);
  a272=(a272/a356);
  a358=(a358*a272);
  a354=(a354+a358);
  a358=(a271*a114);
  a356=(a273*a154);
  a358=(a358+a356);
  a356=(a274*a195);
  a358=(a358+a356);
  a356=(a275*a237);
  a358=(a358+a356);
  a281=(a278*a281);
  a295=(a283*a295);
  a281=(a281+a295);
  a295=(a288*a080);
  a356=(a229*a313);
  a295=(a295+a356);
  a281=(a281-a295);
  a295=(a276*a281);
  a358=(a358+a295);
  a358=(a062+a358);
  a295=(a354*a358);
  a324=(a324+a295);
  a327=(a327+a324);
  a324=(a321*a327);
  a279=(a279+a324);
  a279=(a501+a279);
  a324=(a314*a279);
  a475=(a475+a324);
  a324=(a360*a015);
  a295=(a362*a083);
  a324=(a324+a295);
  a295=(a363*a155);
  a324=(a324+a295);
  a295=(a364*a238);
  a324=(a324+a295);
  a295=(a365*a282);
  a324=(a324+a295);
  a295=(a366*a327);
  a324=(a324+a295);
  a372=(a372*a008);
  a368=(a368*a011);
  a295=(a379*a316);
  a356=(a014*a316);
  a356=(a356*a316);
  a295=(a295-a356);
  a382=(a008*a382);
  a332=(a377*a382);
  a332=(a332-a384);
  a384=(a020*a316);
  a384=(a384*a316);
  a342=(a372*a384);
  a332=(a332-a342);
  a332=(a332-a387);
  a332=(a332+a391);
  a332=(a332-a390);
  a332=(a332+a396);
  a396=(a014*a394);
  a382=(a396*a382);
  a332=(a332+a382);
  a332=(a012*a332);
  a369=(a369+a332);
  a369=(a369-a047);
  a369=(a369+a398);
  a398=(a369/a400);
  a369=(a404*a369);
  a399=(a399-a369);
  a399=(a399/a402);
  a369=(a404*a399);
  a398=(a398-a369);
  a369=(2.*a398);
  a332=(a369*a020);
  a295=(a295-a332);
  a295=(a012*a295);
  a368=(a368+a295);
  a372=(a372*a368);
  a386=(a386*a013);
  a372=(a372+a386);
  a397=(a020*a397);
  a370=(a370*a014);
  a397=(a397-a370);
  a386=(a375*a008);
  a368=(a356+a332);
  a392=(a392*a380);
  a295=(a399*a020);
  a392=(a392-a295);
  a295=(a014*a381);
  a392=(a392-a295);
  a368=(a368+a392);
  a386=(a386*a368);
  a397=(a397-a386);
  a373=(a020*a373);
  a397=(a397-a373);
  a368=(a008*a394);
  a399=(a399*a014);
  a381=(a020*a381);
  a399=(a399-a381);
  a381=(a369*a014);
  a399=(a399-a381);
  a295=(a020*a380);
  a295=(a295*a380);
  a399=(a399+a295);
  a295=(a399+a384);
  a368=(a368*a295);
  a397=(a397+a368);
  a397=(a012*a397);
  a372=(a372+a397);
  a397=(a008*a371);
  a369=(a369*a011);
  a295=(a430*a398);
  a295=(a295-a381);
  a295=(a295+a384);
  a295=(a012*a295);
  a369=(a369+a295);
  a397=(a397*a369);
  a372=(a372+a397);
  a397=(a372/a400);
  a369=(a398*a008);
  a377=(a377+a396);
  a369=(a369*a377);
  a370=(a370+a373);
  a369=(a369+a370);
  a369=(a012*a369);
  a372=(a404*a372);
  a369=(a369-a372);
  a369=(a369/a402);
  a372=(a404*a369);
  a397=(a397-a372);
  a372=(a315*a501);
  a373=(a317*a082);
  a372=(a372+a373);
  a373=(a318*a152);
  a372=(a372+a373);
  a373=(a319*a030);
  a372=(a372+a373);
  a373=(a320*a080);
  a372=(a372+a373);
  a373=(a321*a235);
  a372=(a372+a373);
  a372=(a027+a372);
  a373=(a397*a372);
  a332=(a332+a392);
  a332=(a374*a332);
  a386=(a386+a332);
  a386=(a386-a368);
  a399=(a376*a399);
  a386=(a386+a399);
  a386=(a386+a370);
  a386=(a012*a386);
  a399=(a386/a400);
  a368=(a398*a020);
  a356=(a356-a368);
  a374=(a374*a356);
  a375=(a398*a375);
  a375=(a375*a020);
  a375=(a375*a008);
  a374=(a374-a375);
  a398=(a398*a014);
  a375=(a398*a008);
  a375=(a375*a394);
  a374=(a374-a375);
  a398=(a398+a384);
  a376=(a376*a398);
  a374=(a374+a376);
  a374=(a374-a370);
  a374=(a012*a374);
  a386=(a404*a386);
  a374=(a374-a386);
  a374=(a374/a402);
  a386=(a404*a374);
  a399=(a399-a386);
  a386=(a315*a062);
  a370=(a317*a186);
  a386=(a386+a370);
  a370=(a318*a226);
  a386=(a386+a370);
  a370=(a319*a269);
  a386=(a386+a370);
  a370=(a320*a313);
  a386=(a386+a370);
  a370=(a321*a358);
  a386=(a386+a370);
  a386=(a034+a386);
  a370=(a399*a386);
  a373=(a373+a370);
  a370=(a379*a008);
  a370=(a370*a371);
  a370=(a370*a049);
  a389=(a048*a389);
  a370=(a370+a389);
  a393=(a048*a393);
  a370=(a370-a393);
  a393=(a380-a316);
  a393=(a048*a393);
  a389=(a378*a393);
  a370=(a370+a389);
  a393=(a395*a393);
  a370=(a370+a393);
  a379=(a379*a012);
  a385=(a385*a008);
  a385=(a379*a385);
  a370=(a370-a385);
  a385=(a370/a400);
  a388=(a388-a403);
  a379=(a379*a388);
  a370=(a404*a370);
  a379=(a379+a370);
  a379=(a379/a402);
  a370=(a404*a379);
  a385=(a385+a370);
  a370=(a385*a279);
  a316=(a316-a380);
  a316=(a048*a316);
  a378=(a378+a395);
  a378=(a378+a388);
  a316=(a316*a378);
  a400=(a316/a400);
  a316=(a404*a316);
  a316=(a316/a402);
  a404=(a404*a316);
  a400=(a400+a404);
  a404=(a315*a114);
  a402=(a317*a154);
  a404=(a404+a402);
  a402=(a318*a195);
  a404=(a404+a402);
  a402=(a319*a237);
  a404=(a404+a402);
  a402=(a320*a281);
  a404=(a404+a402);
  a326=(a323*a326);
  a340=(a328*a340);
  a326=(a326+a340);
  a340=(a333*a235);
  a402=(a272*a358);
  a340=(a340+a402);
  a326=(a326-a340);
  a340=(a321*a326);
  a404=(a404+a340);
  a404=(a062+a404);
  a340=(a400*a404);
  a370=(a370+a340);
  a373=(a373+a370);
  a370=(a367*a373);
  a324=(a324+a370);
  a324=(a501+a324);
  a370=(a359*a324);
  a475=(a475+a370);
  a370=(a406*a015);
  a340=(a408*a083);
  a370=(a370+a340);
  a340=(a409*a155);
  a370=(a370+a340);
  a340=(a410*a238);
  a370=(a370+a340);
  a340=(a411*a282);
  a370=(a370+a340);
  a340=(a412*a327);
  a370=(a370+a340);
  a340=(a413*a373);
  a370=(a370+a340);
  a419=(a419*a008);
  a415=(a415*a011);
  a340=(a426*a361);
  a402=(a014*a361);
  a402=(a402*a361);
  a340=(a340-a402);
  a429=(a008*a429);
  a378=(a424*a429);
  a378=(a378-a431);
  a431=(a020*a361);
  a431=(a431*a361);
  a388=(a419*a431);
  a378=(a378-a388);
  a378=(a378-a434);
  a378=(a378+a438);
  a378=(a378-a437);
  a378=(a378+a443);
  a443=(a014*a441);
  a429=(a443*a429);
  a378=(a378+a429);
  a378=(a012*a378);
  a416=(a416+a378);
  a416=(a416-a047);
  a416=(a416+a445);
  a445=(a416/a447);
  a416=(a451*a416);
  a446=(a446-a416);
  a446=(a446/a449);
  a416=(a451*a446);
  a445=(a445-a416);
  a416=(2.*a445);
  a378=(a416*a020);
  a340=(a340-a378);
  a340=(a012*a340);
  a415=(a415+a340);
  a419=(a419*a415);
  a433=(a433*a013);
  a419=(a419+a433);
  a444=(a020*a444);
  a417=(a417*a014);
  a444=(a444-a417);
  a433=(a422*a008);
  a415=(a402+a378);
  a439=(a439*a427);
  a340=(a446*a020);
  a439=(a439-a340);
  a340=(a014*a428);
  a439=(a439-a340);
  a415=(a415+a439);
  a433=(a433*a415);
  a444=(a444-a433);
  a420=(a020*a420);
  a444=(a444-a420);
  a415=(a008*a441);
  a446=(a446*a014);
  a428=(a020*a428);
  a446=(a446-a428);
  a428=(a416*a014);
  a446=(a446-a428);
  a340=(a020*a427);
  a340=(a340*a427);
  a446=(a446+a340);
  a340=(a446+a431);
  a415=(a415*a340);
  a444=(a444+a415);
  a444=(a012*a444);
  a419=(a419+a444);
  a444=(a008*a418);
  a416=(a416*a011);
  a340=(a430*a445);
  a340=(a340-a428);
  a340=(a340+a431);
  a340=(a012*a340);
  a416=(a416+a340);
  a444=(a444*a416);
  a419=(a419+a444);
  a444=(a419/a447);
  a416=(a445*a008);
  a424=(a424+a443);
  a416=(a416*a424);
  a417=(a417+a420);
  a416=(a416+a417);
  a416=(a012*a416);
  a419=(a451*a419);
  a416=(a416-a419);
  a416=(a416/a449);
  a419=(a451*a416);
  a444=(a444-a419);
  a419=(a360*a501);
  a420=(a362*a082);
  a419=(a419+a420);
  a420=(a363*a152);
  a419=(a419+a420);
  a420=(a364*a030);
  a419=(a419+a420);
  a420=(a365*a080);
  a419=(a419+a420);
  a420=(a366*a235);
  a419=(a419+a420);
  a420=(a367*a279);
  a419=(a419+a420);
  a419=(a027+a419);
  a420=(a444*a419);
  a378=(a378+a439);
  a378=(a421*a378);
  a433=(a433+a378);
  a433=(a433-a415);
  a446=(a423*a446);
  a433=(a433+a446);
  a433=(a433+a417);
  a433=(a012*a433);
  a446=(a433/a447);
  a415=(a445*a020);
  a402=(a402-a415);
  a421=(a421*a402);
  a422=(a445*a422);
  a422=(a422*a020);
  a422=(a422*a008);
  a421=(a421-a422);
  a445=(a445*a014);
  a422=(a445*a008);
  a422=(a422*a441);
  a421=(a421-a422);
  a445=(a445+a431);
  a423=(a423*a445);
  a421=(a421+a423);
  a421=(a421-a417);
  a421=(a012*a421);
  a433=(a451*a433);
  a421=(a421-a433);
  a421=(a421/a449);
  a433=(a451*a421);
  a446=(a446-a433);
  a433=(a360*a062);
  a417=(a362*a186);
  a433=(a433+a417);
  a417=(a363*a226);
  a433=(a433+a417);
  a417=(a364*a269);
  a433=(a433+a417);
  a417=(a365*a313);
  a433=(a433+a417);
  a417=(a366*a358);
  a433=(a433+a417);
  a417=(a367*a404);
  a433=(a433+a417);
  a433=(a034+a433);
  a417=(a446*a433);
  a420=(a420+a417);
  a417=(a426*a008);
  a417=(a417*a418);
  a417=(a417*a049);
  a436=(a048*a436);
  a417=(a417+a436);
  a440=(a048*a440);
  a417=(a417-a440);
  a440=(a427-a361);
  a440=(a048*a440);
  a436=(a425*a440);
  a417=(a417+a436);
  a440=(a442*a440);
  a417=(a417+a440);
  a426=(a426*a012);
  a432=(a432*a008);
  a432=(a426*a432);
  a417=(a417-a432);
  a432=(a417/a447);
  a435=(a435-a450);
  a426=(a426*a435);
  a417=(a451*a417);
  a426=(a426+a417);
  a426=(a426/a449);
  a417=(a451*a426);
  a432=(a432+a417);
  a417=(a432*a324);
  a361=(a361-a427);
  a361=(a048*a361);
  a425=(a425+a442);
  a425=(a425+a435);
  a361=(a361*a425);
  a447=(a361/a447);
  a361=(a451*a361);
  a361=(a361/a449);
  a451=(a451*a361);
  a447=(a447+a451);
  a451=(a360*a114);
  a449=(a362*a154);
  a451=(a451+a449);
  a449=(a363*a195);
  a451=(a451+a449);
  a449=(a364*a237);
  a451=(a451+a449);
  a449=(a365*a281);
  a451=(a451+a449);
  a449=(a366*a326);
  a451=(a451+a449);
  a372=(a369*a372);
  a386=(a374*a386);
  a372=(a372+a386);
  a386=(a379*a279);
  a449=(a316*a404);
  a386=(a386+a449);
  a372=(a372-a386);
  a386=(a367*a372);
  a451=(a451+a386);
  a451=(a062+a451);
  a386=(a447*a451);
  a417=(a417+a386);
  a420=(a420+a417);
  a417=(a414*a420);
  a370=(a370+a417);
  a370=(a501+a370);
  a417=(a405*a370);
  a475=(a475+a417);
  a417=(a453*a015);
  a083=(a455*a083);
  a417=(a417+a083);
  a155=(a183*a155);
  a417=(a417+a155);
  a155=(a223*a238);
  a417=(a417+a155);
  a155=(a456*a282);
  a417=(a417+a155);
  a155=(a457*a327);
  a417=(a417+a155);
  a155=(a458*a373);
  a417=(a417+a155);
  a155=(a459*a420);
  a417=(a417+a155);
  a464=(a464*a008);
  a002=(a002*a011);
  a155=(a471*a407);
  a083=(a014*a407);
  a083=(a083*a407);
  a155=(a155-a083);
  a474=(a008*a474);
  a386=(a469*a474);
  a386=(a386-a476);
  a476=(a020*a407);
  a476=(a476*a407);
  a449=(a464*a476);
  a386=(a386-a449);
  a386=(a386-a479);
  a386=(a386+a483);
  a386=(a386-a482);
  a386=(a386+a488);
  a488=(a014*a486);
  a474=(a488*a474);
  a386=(a386+a474);
  a386=(a012*a386);
  a461=(a461+a386);
  a461=(a461-a047);
  a461=(a461+a490);
  a490=(a461/a492);
  a461=(a496*a461);
  a491=(a491-a461);
  a491=(a491/a494);
  a461=(a496*a491);
  a490=(a490-a461);
  a461=(2.*a490);
  a386=(a461*a020);
  a155=(a155-a386);
  a155=(a012*a155);
  a002=(a002+a155);
  a464=(a464*a002);
  a478=(a478*a013);
  a464=(a464+a478);
  a489=(a020*a489);
  a462=(a462*a014);
  a489=(a489-a462);
  a478=(a467*a008);
  a002=(a083+a386);
  a484=(a484*a472);
  a155=(a491*a020);
  a484=(a484-a155);
  a155=(a014*a473);
  a484=(a484-a155);
  a002=(a002+a484);
  a478=(a478*a002);
  a489=(a489-a478);
  a465=(a020*a465);
  a489=(a489-a465);
  a002=(a008*a486);
  a491=(a491*a014);
  a473=(a020*a473);
  a491=(a491-a473);
  a473=(a461*a014);
  a491=(a491-a473);
  a155=(a020*a472);
  a155=(a155*a472);
  a491=(a491+a155);
  a155=(a491+a476);
  a002=(a002*a155);
  a489=(a489+a002);
  a489=(a012*a489);
  a464=(a464+a489);
  a489=(a008*a463);
  a461=(a461*a011);
  a155=(a430*a490);
  a155=(a155-a473);
  a155=(a155+a476);
  a155=(a012*a155);
  a461=(a461+a155);
  a489=(a489*a461);
  a464=(a464+a489);
  a489=(a464/a492);
  a461=(a490*a008);
  a469=(a469+a488);
  a461=(a461*a469);
  a462=(a462+a465);
  a461=(a461+a462);
  a461=(a012*a461);
  a464=(a496*a464);
  a461=(a461-a464);
  a461=(a461/a494);
  a464=(a496*a461);
  a489=(a489-a464);
  a464=(a406*a501);
  a465=(a408*a082);
  a464=(a464+a465);
  a465=(a409*a152);
  a464=(a464+a465);
  a465=(a410*a030);
  a464=(a464+a465);
  a465=(a411*a080);
  a464=(a464+a465);
  a465=(a412*a235);
  a464=(a464+a465);
  a465=(a413*a279);
  a464=(a464+a465);
  a465=(a414*a324);
  a464=(a464+a465);
  a464=(a027+a464);
  a465=(a489*a464);
  a386=(a386+a484);
  a386=(a466*a386);
  a478=(a478+a386);
  a478=(a478-a002);
  a491=(a468*a491);
  a478=(a478+a491);
  a478=(a478+a462);
  a478=(a012*a478);
  a491=(a478/a492);
  a002=(a490*a020);
  a083=(a083-a002);
  a466=(a466*a083);
  a467=(a490*a467);
  a467=(a467*a020);
  a467=(a467*a008);
  a466=(a466-a467);
  a490=(a490*a014);
  a467=(a490*a008);
  a467=(a467*a486);
  a466=(a466-a467);
  a490=(a490+a476);
  a468=(a468*a490);
  a466=(a466+a468);
  a466=(a466-a462);
  a466=(a012*a466);
  a478=(a496*a478);
  a466=(a466-a478);
  a466=(a466/a494);
  a478=(a496*a466);
  a491=(a491-a478);
  a478=(a406*a062);
  a462=(a408*a186);
  a478=(a478+a462);
  a462=(a409*a226);
  a478=(a478+a462);
  a462=(a410*a269);
  a478=(a478+a462);
  a462=(a411*a313);
  a478=(a478+a462);
  a462=(a412*a358);
  a478=(a478+a462);
  a462=(a413*a404);
  a478=(a478+a462);
  a462=(a414*a451);
  a478=(a478+a462);
  a478=(a034+a478);
  a462=(a491*a478);
  a465=(a465+a462);
  a462=(a471*a008);
  a462=(a462*a463);
  a462=(a462*a049);
  a481=(a048*a481);
  a462=(a462+a481);
  a485=(a048*a485);
  a462=(a462-a485);
  a485=(a472-a407);
  a485=(a048*a485);
  a481=(a470*a485);
  a462=(a462+a481);
  a485=(a487*a485);
  a462=(a462+a485);
  a471=(a471*a012);
  a477=(a477*a008);
  a477=(a471*a477);
  a462=(a462-a477);
  a477=(a462/a492);
  a480=(a480-a495);
  a471=(a471*a480);
  a462=(a496*a462);
  a471=(a471+a462);
  a471=(a471/a494);
  a462=(a496*a471);
  a477=(a477+a462);
  a462=(a477*a370);
  a407=(a407-a472);
  a407=(a048*a407);
  a470=(a470+a487);
  a470=(a470+a480);
  a407=(a407*a470);
  a492=(a407/a492);
  a407=(a496*a407);
  a407=(a407/a494);
  a496=(a496*a407);
  a492=(a492+a496);
  a496=(a406*a114);
  a494=(a408*a154);
  a496=(a496+a494);
  a494=(a409*a195);
  a496=(a496+a494);
  a494=(a410*a237);
  a496=(a496+a494);
  a494=(a411*a281);
  a496=(a496+a494);
  a494=(a412*a326);
  a496=(a496+a494);
  a494=(a413*a372);
  a496=(a496+a494);
  a419=(a416*a419);
  a433=(a421*a433);
  a419=(a419+a433);
  a433=(a426*a324);
  a494=(a361*a451);
  a433=(a433+a494);
  a419=(a419-a433);
  a433=(a414*a419);
  a496=(a496+a433);
  a496=(a062+a496);
  a433=(a492*a496);
  a462=(a462+a433);
  a465=(a465+a462);
  a462=(a460*a465);
  a417=(a417+a462);
  a417=(a501+a417);
  a462=(a452*a417);
  a475=(a475+a462);
  a475=(a027+a475);
  if (res[0]!=0) res[0][4]=a475;
  a475=(a001*a062);
  a462=(a005*a269);
  a475=(a475+a462);
  a462=(a227*a313);
  a475=(a475+a462);
  a462=(a270*a358);
  a475=(a475+a462);
  a462=(a314*a404);
  a475=(a475+a462);
  a462=(a359*a451);
  a475=(a475+a462);
  a462=(a405*a496);
  a475=(a475+a462);
  a462=(a453*a114);
  a154=(a455*a154);
  a462=(a462+a154);
  a195=(a183*a195);
  a462=(a462+a195);
  a195=(a223*a237);
  a462=(a462+a195);
  a195=(a456*a281);
  a462=(a462+a195);
  a195=(a457*a326);
  a462=(a462+a195);
  a195=(a458*a372);
  a462=(a462+a195);
  a195=(a459*a419);
  a462=(a462+a195);
  a464=(a461*a464);
  a478=(a466*a478);
  a464=(a464+a478);
  a478=(a471*a370);
  a195=(a407*a496);
  a478=(a478+a195);
  a464=(a464-a478);
  a478=(a460*a464);
  a462=(a462+a478);
  a462=(a062+a462);
  a478=(a452*a462);
  a475=(a475+a478);
  a475=(a034+a475);
  if (res[0]!=0) res[0][5]=a475;
  a015=(a001*a015);
  a238=(a005*a238);
  a015=(a015+a238);
  a282=(a227*a282);
  a015=(a015+a282);
  a327=(a270*a327);
  a015=(a015+a327);
  a373=(a314*a373);
  a015=(a015+a373);
  a420=(a359*a420);
  a015=(a015+a420);
  a465=(a405*a465);
  a015=(a015+a465);
  a355=(a355*a008);
  a493=(a493*a011);
  a465=(a498*a454);
  a420=(a014*a454);
  a420=(a420*a454);
  a465=(a465-a420);
  a500=(a008*a500);
  a373=(a205*a500);
  a373=(a373-a000);
  a000=(a020*a454);
  a000=(a000*a454);
  a327=(a355*a000);
  a373=(a373-a327);
  a373=(a373-a504);
  a373=(a373+a508);
  a373=(a373-a507);
  a373=(a373+a512);
  a512=(a014*a511);
  a500=(a512*a500);
  a373=(a373+a500);
  a373=(a012*a373);
  a448=(a448+a373);
  a448=(a448-a047);
  a448=(a448+a035);
  a035=(a448/a052);
  a448=(a055*a448);
  a513=(a513-a448);
  a513=(a513/a067);
  a448=(a055*a513);
  a035=(a035-a448);
  a448=(2.*a035);
  a047=(a448*a020);
  a465=(a465-a047);
  a465=(a012*a465);
  a493=(a493+a465);
  a355=(a355*a493);
  a503=(a503*a013);
  a355=(a355+a503);
  a033=(a020*a033);
  a029=(a029*a014);
  a033=(a033-a029);
  a503=(a266*a008);
  a013=(a420+a047);
  a509=(a509*a497);
  a493=(a513*a020);
  a509=(a509-a493);
  a493=(a014*a499);
  a509=(a509-a493);
  a013=(a013+a509);
  a503=(a503*a013);
  a033=(a033-a503);
  a016=(a020*a016);
  a033=(a033-a016);
  a013=(a008*a511);
  a513=(a513*a014);
  a499=(a020*a499);
  a513=(a513-a499);
  a499=(a448*a014);
  a513=(a513-a499);
  a493=(a020*a497);
  a493=(a493*a497);
  a513=(a513+a493);
  a493=(a513+a000);
  a013=(a013*a493);
  a033=(a033+a013);
  a033=(a012*a033);
  a355=(a355+a033);
  a033=(a008*a401);
  a448=(a448*a011);
  a430=(a430*a035);
  a430=(a430-a499);
  a430=(a430+a000);
  a430=(a012*a430);
  a448=(a448+a430);
  a033=(a033*a448);
  a355=(a355+a033);
  a033=(a355/a052);
  a448=(a035*a008);
  a205=(a205+a512);
  a448=(a448*a205);
  a029=(a029+a016);
  a448=(a448+a029);
  a448=(a012*a448);
  a355=(a055*a355);
  a448=(a448-a355);
  a448=(a448/a067);
  a355=(a055*a448);
  a033=(a033-a355);
  a355=(a453*a501);
  a082=(a455*a082);
  a355=(a355+a082);
  a152=(a183*a152);
  a355=(a355+a152);
  a030=(a223*a030);
  a355=(a355+a030);
  a080=(a456*a080);
  a355=(a355+a080);
  a235=(a457*a235);
  a355=(a355+a235);
  a279=(a458*a279);
  a355=(a355+a279);
  a324=(a459*a324);
  a355=(a355+a324);
  a370=(a460*a370);
  a355=(a355+a370);
  a027=(a027+a355);
  a355=(a033*a027);
  a047=(a047+a509);
  a047=(a310*a047);
  a503=(a503+a047);
  a503=(a503-a013);
  a513=(a004*a513);
  a503=(a503+a513);
  a503=(a503+a029);
  a503=(a012*a503);
  a513=(a503/a052);
  a013=(a035*a020);
  a420=(a420-a013);
  a310=(a310*a420);
  a266=(a035*a266);
  a266=(a266*a020);
  a266=(a266*a008);
  a310=(a310-a266);
  a035=(a035*a014);
  a014=(a035*a008);
  a014=(a014*a511);
  a310=(a310-a014);
  a035=(a035+a000);
  a004=(a004*a035);
  a310=(a310+a004);
  a310=(a310-a029);
  a310=(a012*a310);
  a503=(a055*a503);
  a310=(a310-a503);
  a310=(a310/a067);
  a503=(a055*a310);
  a513=(a513-a503);
  a503=(a453*a062);
  a186=(a455*a186);
  a503=(a503+a186);
  a226=(a183*a226);
  a503=(a503+a226);
  a269=(a223*a269);
  a503=(a503+a269);
  a313=(a456*a313);
  a503=(a503+a313);
  a358=(a457*a358);
  a503=(a503+a358);
  a404=(a458*a404);
  a503=(a503+a404);
  a451=(a459*a451);
  a503=(a503+a451);
  a496=(a460*a496);
  a503=(a503+a496);
  a034=(a034+a503);
  a503=(a513*a034);
  a355=(a355+a503);
  a503=(a498*a008);
  a503=(a503*a401);
  a503=(a503*a049);
  a506=(a048*a506);
  a503=(a503+a506);
  a510=(a048*a510);
  a503=(a503-a510);
  a510=(a497-a454);
  a510=(a048*a510);
  a506=(a165*a510);
  a503=(a503+a506);
  a510=(a043*a510);
  a503=(a503+a510);
  a498=(a498*a012);
  a502=(a502*a008);
  a502=(a498*a502);
  a503=(a503-a502);
  a502=(a503/a052);
  a505=(a505-a057);
  a498=(a498*a505);
  a503=(a055*a503);
  a498=(a498+a503);
  a498=(a498/a067);
  a503=(a055*a498);
  a502=(a502+a503);
  a503=(a502*a417);
  a454=(a454-a497);
  a048=(a048*a454);
  a165=(a165+a043);
  a165=(a165+a505);
  a048=(a048*a165);
  a052=(a048/a052);
  a048=(a055*a048);
  a048=(a048/a067);
  a055=(a055*a048);
  a052=(a052+a055);
  a055=(a052*a462);
  a503=(a503+a055);
  a355=(a355+a503);
  a355=(a452*a355);
  a015=(a015+a355);
  a501=(a501+a015);
  if (res[0]!=0) res[0][6]=a501;
  a114=(a001*a114);
  a237=(a005*a237);
  a114=(a114+a237);
  a281=(a227*a281);
  a114=(a114+a281);
  a326=(a270*a326);
  a114=(a114+a326);
  a372=(a314*a372);
  a114=(a114+a372);
  a419=(a359*a419);
  a114=(a114+a419);
  a464=(a405*a464);
  a114=(a114+a464);
  a027=(a448*a027);
  a034=(a310*a034);
  a027=(a027+a034);
  a417=(a498*a417);
  a462=(a048*a462);
  a417=(a417+a462);
  a027=(a027-a417);
  a027=(a452*a027);
  a114=(a114+a027);
  a062=(a062+a114);
  if (res[0]!=0) res[0][7]=a062;
  a062=arg[0]? arg[0][8] : 0;
  a114=arg[0]? arg[0][10] : 0;
  a027=(a001*a114);
  a417=(a050*a062);
  a462=arg[0]? arg[0][9] : 0;
  a034=(a053*a462);
  a417=(a417+a034);
  a034=(a032*a114);
  a464=arg[0]? arg[0][11] : 0;
  a419=(a054*a464);
  a034=(a034+a419);
  a417=(a417+a034);
  a034=(a006*a417);
  a419=(a070*a114);
  a372=(a073*a417);
  a326=(a076*a114);
  a326=(a062+a326);
  a281=(a107*a326);
  a237=(a076*a464);
  a237=(a462+a237);
  a501=(a109*a237);
  a281=(a281+a501);
  a501=(a076*a417);
  a501=(a114+a501);
  a015=(a095*a501);
  a355=(a009*a062);
  a503=(a017*a462);
  a355=(a355+a503);
  a503=(a023*a114);
  a055=(a003*a464);
  a503=(a503+a055);
  a355=(a355-a503);
  a503=(a076*a355);
  a503=(a464+a503);
  a055=(a110*a503);
  a015=(a015+a055);
  a281=(a281+a015);
  a281=(a075*a281);
  a372=(a372+a281);
  a372=(a114+a372);
  a281=(a072*a372);
  a419=(a419+a281);
  a419=(a062+a419);
  a281=(a179*a419);
  a015=(a070*a464);
  a055=(a073*a355);
  a326=(a079*a326);
  a237=(a084*a237);
  a326=(a326+a237);
  a237=(a089*a501);
  a067=(a077*a503);
  a237=(a237+a067);
  a326=(a326-a237);
  a326=(a075*a326);
  a055=(a055+a326);
  a055=(a464+a055);
  a326=(a072*a055);
  a015=(a015+a326);
  a015=(a462+a015);
  a326=(a181*a015);
  a281=(a281+a326);
  a326=(a070*a417);
  a237=(a073*a114);
  a501=(a075*a501);
  a237=(a237+a501);
  a237=(a062+a237);
  a501=(a142*a237);
  a067=(a073*a464);
  a503=(a075*a503);
  a067=(a067+a503);
  a067=(a462+a067);
  a503=(a144*a067);
  a501=(a501+a503);
  a503=(a130*a372);
  a165=(a145*a055);
  a503=(a503+a165);
  a501=(a501+a503);
  a503=(a072*a501);
  a326=(a326+a503);
  a326=(a114+a326);
  a503=(a167*a326);
  a165=(a070*a355);
  a237=(a115*a237);
  a067=(a120*a067);
  a237=(a237+a067);
  a067=(a125*a372);
  a505=(a074*a055);
  a067=(a067+a505);
  a237=(a237-a067);
  a067=(a072*a237);
  a165=(a165+a067);
  a165=(a464+a165);
  a067=(a182*a165);
  a503=(a503+a067);
  a281=(a281+a503);
  a503=(a069*a281);
  a034=(a034+a503);
  a503=(a188*a114);
  a372=(a190*a372);
  a503=(a503+a372);
  a372=(a146*a326);
  a503=(a503+a372);
  a503=(a062+a503);
  a372=(a219*a503);
  a067=(a188*a464);
  a055=(a190*a055);
  a067=(a067+a055);
  a055=(a146*a165);
  a067=(a067+a055);
  a067=(a462+a067);
  a055=(a221*a067);
  a372=(a372+a055);
  a055=(a188*a417);
  a501=(a190*a501);
  a055=(a055+a501);
  a501=(a146*a281);
  a055=(a055+a501);
  a055=(a114+a055);
  a501=(a207*a055);
  a505=(a188*a355);
  a237=(a190*a237);
  a505=(a505+a237);
  a419=(a151*a419);
  a015=(a156*a015);
  a419=(a419+a015);
  a015=(a161*a326);
  a237=(a071*a165);
  a015=(a015+a237);
  a419=(a419-a015);
  a015=(a146*a419);
  a505=(a505+a015);
  a505=(a464+a505);
  a015=(a222*a505);
  a501=(a501+a015);
  a372=(a372+a501);
  a501=(a187*a372);
  a034=(a034+a501);
  a034=(a114+a034);
  a501=(a005*a034);
  a027=(a027+a501);
  a501=(a228*a417);
  a015=(a230*a281);
  a501=(a501+a015);
  a015=(a231*a372);
  a501=(a501+a015);
  a015=(a006*a114);
  a237=(a069*a326);
  a015=(a015+a237);
  a237=(a187*a055);
  a015=(a015+a237);
  a015=(a062+a015);
  a237=(a262*a015);
  a043=(a006*a464);
  a454=(a069*a165);
  a043=(a043+a454);
  a454=(a187*a505);
  a043=(a043+a454);
  a043=(a462+a043);
  a454=(a264*a043);
  a237=(a237+a454);
  a454=(a250*a034);
  a497=(a006*a355);
  a057=(a069*a419);
  a497=(a497+a057);
  a503=(a192*a503);
  a067=(a197*a067);
  a503=(a503+a067);
  a067=(a202*a055);
  a057=(a189*a505);
  a067=(a067+a057);
  a503=(a503-a067);
  a067=(a187*a503);
  a497=(a497+a067);
  a497=(a464+a497);
  a067=(a265*a497);
  a454=(a454+a067);
  a237=(a237+a454);
  a454=(a232*a237);
  a501=(a501+a454);
  a501=(a114+a501);
  a454=(a227*a501);
  a027=(a027+a454);
  a454=(a271*a417);
  a067=(a273*a281);
  a454=(a454+a067);
  a067=(a274*a372);
  a454=(a454+a067);
  a067=(a275*a237);
  a454=(a454+a067);
  a067=(a228*a114);
  a057=(a230*a326);
  a067=(a067+a057);
  a057=(a231*a055);
  a067=(a067+a057);
  a057=(a232*a034);
  a067=(a067+a057);
  a067=(a062+a067);
  a057=(a306*a067);
  a008=(a228*a464);
  a012=(a230*a165);
  a008=(a008+a012);
  a012=(a231*a505);
  a008=(a008+a012);
  a012=(a232*a497);
  a008=(a008+a012);
  a008=(a462+a008);
  a012=(a308*a008);
  a057=(a057+a012);
  a012=(a294*a501);
  a510=(a228*a355);
  a506=(a230*a419);
  a510=(a510+a506);
  a506=(a231*a503);
  a510=(a510+a506);
  a015=(a234*a015);
  a043=(a239*a043);
  a015=(a015+a043);
  a043=(a244*a034);
  a506=(a068*a497);
  a043=(a043+a506);
  a015=(a015-a043);
  a043=(a232*a015);
  a510=(a510+a043);
  a510=(a464+a510);
  a043=(a309*a510);
  a012=(a012+a043);
  a057=(a057+a012);
  a012=(a276*a057);
  a454=(a454+a012);
  a454=(a114+a454);
  a012=(a270*a454);
  a027=(a027+a012);
  a012=(a315*a417);
  a043=(a317*a281);
  a012=(a012+a043);
  a043=(a318*a372);
  a012=(a012+a043);
  a043=(a319*a237);
  a012=(a012+a043);
  a043=(a320*a057);
  a012=(a012+a043);
  a043=(a271*a114);
  a506=(a273*a326);
  a043=(a043+a506);
  a506=(a274*a055);
  a043=(a043+a506);
  a506=(a275*a034);
  a043=(a043+a506);
  a506=(a276*a501);
  a043=(a043+a506);
  a043=(a062+a043);
  a506=(a351*a043);
  a049=(a271*a464);
  a401=(a273*a165);
  a049=(a049+a401);
  a401=(a274*a505);
  a049=(a049+a401);
  a401=(a275*a497);
  a049=(a049+a401);
  a401=(a276*a510);
  a049=(a049+a401);
  a049=(a462+a049);
  a401=(a353*a049);
  a506=(a506+a401);
  a401=(a339*a454);
  a496=(a271*a355);
  a451=(a273*a419);
  a496=(a496+a451);
  a451=(a274*a503);
  a496=(a496+a451);
  a451=(a275*a015);
  a496=(a496+a451);
  a067=(a278*a067);
  a008=(a283*a008);
  a067=(a067+a008);
  a008=(a288*a501);
  a451=(a229*a510);
  a008=(a008+a451);
  a067=(a067-a008);
  a008=(a276*a067);
  a496=(a496+a008);
  a496=(a464+a496);
  a008=(a354*a496);
  a401=(a401+a008);
  a506=(a506+a401);
  a401=(a321*a506);
  a012=(a012+a401);
  a012=(a114+a012);
  a401=(a314*a012);
  a027=(a027+a401);
  a401=(a360*a417);
  a008=(a362*a281);
  a401=(a401+a008);
  a008=(a363*a372);
  a401=(a401+a008);
  a008=(a364*a237);
  a401=(a401+a008);
  a008=(a365*a057);
  a401=(a401+a008);
  a008=(a366*a506);
  a401=(a401+a008);
  a008=(a315*a114);
  a451=(a317*a326);
  a008=(a008+a451);
  a451=(a318*a055);
  a008=(a008+a451);
  a451=(a319*a034);
  a008=(a008+a451);
  a451=(a320*a501);
  a008=(a008+a451);
  a451=(a321*a454);
  a008=(a008+a451);
  a008=(a062+a008);
  a451=(a397*a008);
  a404=(a315*a464);
  a358=(a317*a165);
  a404=(a404+a358);
  a358=(a318*a505);
  a404=(a404+a358);
  a358=(a319*a497);
  a404=(a404+a358);
  a358=(a320*a510);
  a404=(a404+a358);
  a358=(a321*a496);
  a404=(a404+a358);
  a404=(a462+a404);
  a358=(a399*a404);
  a451=(a451+a358);
  a358=(a385*a012);
  a313=(a315*a355);
  a269=(a317*a419);
  a313=(a313+a269);
  a269=(a318*a503);
  a313=(a313+a269);
  a269=(a319*a015);
  a313=(a313+a269);
  a269=(a320*a067);
  a313=(a313+a269);
  a043=(a323*a043);
  a049=(a328*a049);
  a043=(a043+a049);
  a049=(a333*a454);
  a269=(a272*a496);
  a049=(a049+a269);
  a043=(a043-a049);
  a049=(a321*a043);
  a313=(a313+a049);
  a313=(a464+a313);
  a049=(a400*a313);
  a358=(a358+a049);
  a451=(a451+a358);
  a358=(a367*a451);
  a401=(a401+a358);
  a401=(a114+a401);
  a358=(a359*a401);
  a027=(a027+a358);
  a358=(a406*a417);
  a049=(a408*a281);
  a358=(a358+a049);
  a049=(a409*a372);
  a358=(a358+a049);
  a049=(a410*a237);
  a358=(a358+a049);
  a049=(a411*a057);
  a358=(a358+a049);
  a049=(a412*a506);
  a358=(a358+a049);
  a049=(a413*a451);
  a358=(a358+a049);
  a049=(a360*a114);
  a269=(a362*a326);
  a049=(a049+a269);
  a269=(a363*a055);
  a049=(a049+a269);
  a269=(a364*a034);
  a049=(a049+a269);
  a269=(a365*a501);
  a049=(a049+a269);
  a269=(a366*a454);
  a049=(a049+a269);
  a269=(a367*a012);
  a049=(a049+a269);
  a049=(a062+a049);
  a269=(a444*a049);
  a226=(a360*a464);
  a186=(a362*a165);
  a226=(a226+a186);
  a186=(a363*a505);
  a226=(a226+a186);
  a186=(a364*a497);
  a226=(a226+a186);
  a186=(a365*a510);
  a226=(a226+a186);
  a186=(a366*a496);
  a226=(a226+a186);
  a186=(a367*a313);
  a226=(a226+a186);
  a226=(a462+a226);
  a186=(a446*a226);
  a269=(a269+a186);
  a186=(a432*a401);
  a029=(a360*a355);
  a004=(a362*a419);
  a029=(a029+a004);
  a004=(a363*a503);
  a029=(a029+a004);
  a004=(a364*a015);
  a029=(a029+a004);
  a004=(a365*a067);
  a029=(a029+a004);
  a004=(a366*a043);
  a029=(a029+a004);
  a008=(a369*a008);
  a404=(a374*a404);
  a008=(a008+a404);
  a404=(a379*a012);
  a004=(a316*a313);
  a404=(a404+a004);
  a008=(a008-a404);
  a404=(a367*a008);
  a029=(a029+a404);
  a029=(a464+a029);
  a404=(a447*a029);
  a186=(a186+a404);
  a269=(a269+a186);
  a186=(a414*a269);
  a358=(a358+a186);
  a358=(a114+a358);
  a186=(a405*a358);
  a027=(a027+a186);
  a186=(a453*a417);
  a281=(a455*a281);
  a186=(a186+a281);
  a372=(a183*a372);
  a186=(a186+a372);
  a372=(a223*a237);
  a186=(a186+a372);
  a372=(a456*a057);
  a186=(a186+a372);
  a372=(a457*a506);
  a186=(a186+a372);
  a372=(a458*a451);
  a186=(a186+a372);
  a372=(a459*a269);
  a186=(a186+a372);
  a372=(a406*a114);
  a281=(a408*a326);
  a372=(a372+a281);
  a281=(a409*a055);
  a372=(a372+a281);
  a281=(a410*a034);
  a372=(a372+a281);
  a281=(a411*a501);
  a372=(a372+a281);
  a281=(a412*a454);
  a372=(a372+a281);
  a281=(a413*a012);
  a372=(a372+a281);
  a281=(a414*a401);
  a372=(a372+a281);
  a372=(a062+a372);
  a281=(a489*a372);
  a404=(a406*a464);
  a004=(a408*a165);
  a404=(a404+a004);
  a004=(a409*a505);
  a404=(a404+a004);
  a004=(a410*a497);
  a404=(a404+a004);
  a004=(a411*a510);
  a404=(a404+a004);
  a004=(a412*a496);
  a404=(a404+a004);
  a004=(a413*a313);
  a404=(a404+a004);
  a004=(a414*a029);
  a404=(a404+a004);
  a404=(a462+a404);
  a004=(a491*a404);
  a281=(a281+a004);
  a004=(a477*a358);
  a035=(a406*a355);
  a000=(a408*a419);
  a035=(a035+a000);
  a000=(a409*a503);
  a035=(a035+a000);
  a000=(a410*a015);
  a035=(a035+a000);
  a000=(a411*a067);
  a035=(a035+a000);
  a000=(a412*a043);
  a035=(a035+a000);
  a000=(a413*a008);
  a035=(a035+a000);
  a049=(a416*a049);
  a226=(a421*a226);
  a049=(a049+a226);
  a226=(a426*a401);
  a000=(a361*a029);
  a226=(a226+a000);
  a049=(a049-a226);
  a226=(a414*a049);
  a035=(a035+a226);
  a035=(a464+a035);
  a226=(a492*a035);
  a004=(a004+a226);
  a281=(a281+a004);
  a004=(a460*a281);
  a186=(a186+a004);
  a186=(a114+a186);
  a004=(a452*a186);
  a027=(a027+a004);
  a027=(a062+a027);
  if (res[0]!=0) res[0][8]=a027;
  a027=(a001*a464);
  a004=(a005*a497);
  a027=(a027+a004);
  a004=(a227*a510);
  a027=(a027+a004);
  a004=(a270*a496);
  a027=(a027+a004);
  a004=(a314*a313);
  a027=(a027+a004);
  a004=(a359*a029);
  a027=(a027+a004);
  a004=(a405*a035);
  a027=(a027+a004);
  a004=(a453*a355);
  a419=(a455*a419);
  a004=(a004+a419);
  a503=(a183*a503);
  a004=(a004+a503);
  a503=(a223*a015);
  a004=(a004+a503);
  a503=(a456*a067);
  a004=(a004+a503);
  a503=(a457*a043);
  a004=(a004+a503);
  a503=(a458*a008);
  a004=(a004+a503);
  a503=(a459*a049);
  a004=(a004+a503);
  a372=(a461*a372);
  a404=(a466*a404);
  a372=(a372+a404);
  a404=(a471*a358);
  a503=(a407*a035);
  a404=(a404+a503);
  a372=(a372-a404);
  a404=(a460*a372);
  a004=(a004+a404);
  a004=(a464+a004);
  a404=(a452*a004);
  a027=(a027+a404);
  a027=(a462+a027);
  if (res[0]!=0) res[0][9]=a027;
  a417=(a001*a417);
  a237=(a005*a237);
  a417=(a417+a237);
  a057=(a227*a057);
  a417=(a417+a057);
  a506=(a270*a506);
  a417=(a417+a506);
  a451=(a314*a451);
  a417=(a417+a451);
  a269=(a359*a269);
  a417=(a417+a269);
  a281=(a405*a281);
  a417=(a417+a281);
  a281=(a453*a114);
  a326=(a455*a326);
  a281=(a281+a326);
  a055=(a183*a055);
  a281=(a281+a055);
  a034=(a223*a034);
  a281=(a281+a034);
  a501=(a456*a501);
  a281=(a281+a501);
  a454=(a457*a454);
  a281=(a281+a454);
  a012=(a458*a012);
  a281=(a281+a012);
  a401=(a459*a401);
  a281=(a281+a401);
  a358=(a460*a358);
  a281=(a281+a358);
  a062=(a062+a281);
  a281=(a033*a062);
  a358=(a453*a464);
  a165=(a455*a165);
  a358=(a358+a165);
  a505=(a183*a505);
  a358=(a358+a505);
  a497=(a223*a497);
  a358=(a358+a497);
  a510=(a456*a510);
  a358=(a358+a510);
  a496=(a457*a496);
  a358=(a358+a496);
  a313=(a458*a313);
  a358=(a358+a313);
  a029=(a459*a029);
  a358=(a358+a029);
  a035=(a460*a035);
  a358=(a358+a035);
  a462=(a462+a358);
  a358=(a513*a462);
  a281=(a281+a358);
  a358=(a502*a186);
  a035=(a052*a004);
  a358=(a358+a035);
  a281=(a281+a358);
  a281=(a452*a281);
  a417=(a417+a281);
  a114=(a114+a417);
  if (res[0]!=0) res[0][10]=a114;
  a355=(a001*a355);
  a015=(a005*a015);
  a355=(a355+a015);
  a067=(a227*a067);
  a355=(a355+a067);
  a043=(a270*a043);
  a355=(a355+a043);
  a008=(a314*a008);
  a355=(a355+a008);
  a049=(a359*a049);
  a355=(a355+a049);
  a372=(a405*a372);
  a355=(a355+a372);
  a062=(a448*a062);
  a462=(a310*a462);
  a062=(a062+a462);
  a186=(a498*a186);
  a004=(a048*a004);
  a186=(a186+a004);
  a062=(a062-a186);
  a062=(a452*a062);
  a355=(a355+a062);
  a464=(a464+a355);
  if (res[0]!=0) res[0][11]=a464;
  a464=arg[0]? arg[0][12] : 0;
  a355=arg[0]? arg[0][14] : 0;
  a062=(a001*a355);
  a050=(a050*a464);
  a186=arg[0]? arg[0][13] : 0;
  a053=(a053*a186);
  a050=(a050+a053);
  a032=(a032*a355);
  a053=arg[0]? arg[0][15] : 0;
  a054=(a054*a053);
  a032=(a032+a054);
  a050=(a050+a032);
  a032=(a006*a050);
  a054=(a070*a355);
  a004=(a073*a050);
  a462=(a076*a355);
  a462=(a464+a462);
  a107=(a107*a462);
  a372=(a076*a053);
  a372=(a186+a372);
  a109=(a109*a372);
  a107=(a107+a109);
  a109=(a076*a050);
  a109=(a355+a109);
  a095=(a095*a109);
  a009=(a009*a464);
  a017=(a017*a186);
  a009=(a009+a017);
  a023=(a023*a355);
  a003=(a003*a053);
  a023=(a023+a003);
  a009=(a009-a023);
  a076=(a076*a009);
  a076=(a053+a076);
  a110=(a110*a076);
  a095=(a095+a110);
  a107=(a107+a095);
  a107=(a075*a107);
  a004=(a004+a107);
  a004=(a355+a004);
  a107=(a072*a004);
  a054=(a054+a107);
  a054=(a464+a054);
  a179=(a179*a054);
  a107=(a070*a053);
  a095=(a073*a009);
  a079=(a079*a462);
  a084=(a084*a372);
  a079=(a079+a084);
  a089=(a089*a109);
  a077=(a077*a076);
  a089=(a089+a077);
  a079=(a079-a089);
  a079=(a075*a079);
  a095=(a095+a079);
  a095=(a053+a095);
  a079=(a072*a095);
  a107=(a107+a079);
  a107=(a186+a107);
  a181=(a181*a107);
  a179=(a179+a181);
  a181=(a070*a050);
  a079=(a073*a355);
  a109=(a075*a109);
  a079=(a079+a109);
  a079=(a464+a079);
  a142=(a142*a079);
  a073=(a073*a053);
  a075=(a075*a076);
  a073=(a073+a075);
  a073=(a186+a073);
  a144=(a144*a073);
  a142=(a142+a144);
  a130=(a130*a004);
  a145=(a145*a095);
  a130=(a130+a145);
  a142=(a142+a130);
  a130=(a072*a142);
  a181=(a181+a130);
  a181=(a355+a181);
  a167=(a167*a181);
  a070=(a070*a009);
  a115=(a115*a079);
  a120=(a120*a073);
  a115=(a115+a120);
  a125=(a125*a004);
  a074=(a074*a095);
  a125=(a125+a074);
  a115=(a115-a125);
  a072=(a072*a115);
  a070=(a070+a072);
  a070=(a053+a070);
  a182=(a182*a070);
  a167=(a167+a182);
  a179=(a179+a167);
  a167=(a069*a179);
  a032=(a032+a167);
  a167=(a188*a355);
  a004=(a190*a004);
  a167=(a167+a004);
  a004=(a146*a181);
  a167=(a167+a004);
  a167=(a464+a167);
  a219=(a219*a167);
  a004=(a188*a053);
  a095=(a190*a095);
  a004=(a004+a095);
  a095=(a146*a070);
  a004=(a004+a095);
  a004=(a186+a004);
  a221=(a221*a004);
  a219=(a219+a221);
  a221=(a188*a050);
  a142=(a190*a142);
  a221=(a221+a142);
  a142=(a146*a179);
  a221=(a221+a142);
  a221=(a355+a221);
  a207=(a207*a221);
  a188=(a188*a009);
  a190=(a190*a115);
  a188=(a188+a190);
  a151=(a151*a054);
  a156=(a156*a107);
  a151=(a151+a156);
  a161=(a161*a181);
  a071=(a071*a070);
  a161=(a161+a071);
  a151=(a151-a161);
  a146=(a146*a151);
  a188=(a188+a146);
  a188=(a053+a188);
  a222=(a222*a188);
  a207=(a207+a222);
  a219=(a219+a207);
  a207=(a187*a219);
  a032=(a032+a207);
  a032=(a355+a032);
  a207=(a005*a032);
  a062=(a062+a207);
  a207=(a228*a050);
  a222=(a230*a179);
  a207=(a207+a222);
  a222=(a231*a219);
  a207=(a207+a222);
  a222=(a006*a355);
  a146=(a069*a181);
  a222=(a222+a146);
  a146=(a187*a221);
  a222=(a222+a146);
  a222=(a464+a222);
  a262=(a262*a222);
  a146=(a006*a053);
  a161=(a069*a070);
  a146=(a146+a161);
  a161=(a187*a188);
  a146=(a146+a161);
  a146=(a186+a146);
  a264=(a264*a146);
  a262=(a262+a264);
  a250=(a250*a032);
  a006=(a006*a009);
  a069=(a069*a151);
  a006=(a006+a069);
  a192=(a192*a167);
  a197=(a197*a004);
  a192=(a192+a197);
  a202=(a202*a221);
  a189=(a189*a188);
  a202=(a202+a189);
  a192=(a192-a202);
  a187=(a187*a192);
  a006=(a006+a187);
  a006=(a053+a006);
  a265=(a265*a006);
  a250=(a250+a265);
  a262=(a262+a250);
  a250=(a232*a262);
  a207=(a207+a250);
  a207=(a355+a207);
  a250=(a227*a207);
  a062=(a062+a250);
  a250=(a271*a050);
  a265=(a273*a179);
  a250=(a250+a265);
  a265=(a274*a219);
  a250=(a250+a265);
  a265=(a275*a262);
  a250=(a250+a265);
  a265=(a228*a355);
  a187=(a230*a181);
  a265=(a265+a187);
  a187=(a231*a221);
  a265=(a265+a187);
  a187=(a232*a032);
  a265=(a265+a187);
  a265=(a464+a265);
  a306=(a306*a265);
  a187=(a228*a053);
  a202=(a230*a070);
  a187=(a187+a202);
  a202=(a231*a188);
  a187=(a187+a202);
  a202=(a232*a006);
  a187=(a187+a202);
  a187=(a186+a187);
  a308=(a308*a187);
  a306=(a306+a308);
  a294=(a294*a207);
  a228=(a228*a009);
  a230=(a230*a151);
  a228=(a228+a230);
  a231=(a231*a192);
  a228=(a228+a231);
  a234=(a234*a222);
  a239=(a239*a146);
  a234=(a234+a239);
  a244=(a244*a032);
  a068=(a068*a006);
  a244=(a244+a068);
  a234=(a234-a244);
  a232=(a232*a234);
  a228=(a228+a232);
  a228=(a053+a228);
  a309=(a309*a228);
  a294=(a294+a309);
  a306=(a306+a294);
  a294=(a276*a306);
  a250=(a250+a294);
  a250=(a355+a250);
  a294=(a270*a250);
  a062=(a062+a294);
  a294=(a315*a050);
  a309=(a317*a179);
  a294=(a294+a309);
  a309=(a318*a219);
  a294=(a294+a309);
  a309=(a319*a262);
  a294=(a294+a309);
  a309=(a320*a306);
  a294=(a294+a309);
  a309=(a271*a355);
  a232=(a273*a181);
  a309=(a309+a232);
  a232=(a274*a221);
  a309=(a309+a232);
  a232=(a275*a032);
  a309=(a309+a232);
  a232=(a276*a207);
  a309=(a309+a232);
  a309=(a464+a309);
  a351=(a351*a309);
  a232=(a271*a053);
  a244=(a273*a070);
  a232=(a232+a244);
  a244=(a274*a188);
  a232=(a232+a244);
  a244=(a275*a006);
  a232=(a232+a244);
  a244=(a276*a228);
  a232=(a232+a244);
  a232=(a186+a232);
  a353=(a353*a232);
  a351=(a351+a353);
  a339=(a339*a250);
  a271=(a271*a009);
  a273=(a273*a151);
  a271=(a271+a273);
  a274=(a274*a192);
  a271=(a271+a274);
  a275=(a275*a234);
  a271=(a271+a275);
  a278=(a278*a265);
  a283=(a283*a187);
  a278=(a278+a283);
  a288=(a288*a207);
  a229=(a229*a228);
  a288=(a288+a229);
  a278=(a278-a288);
  a276=(a276*a278);
  a271=(a271+a276);
  a271=(a053+a271);
  a354=(a354*a271);
  a339=(a339+a354);
  a351=(a351+a339);
  a339=(a321*a351);
  a294=(a294+a339);
  a294=(a355+a294);
  a339=(a314*a294);
  a062=(a062+a339);
  a339=(a360*a050);
  a354=(a362*a179);
  a339=(a339+a354);
  a354=(a363*a219);
  a339=(a339+a354);
  a354=(a364*a262);
  a339=(a339+a354);
  a354=(a365*a306);
  a339=(a339+a354);
  a354=(a366*a351);
  a339=(a339+a354);
  a354=(a315*a355);
  a276=(a317*a181);
  a354=(a354+a276);
  a276=(a318*a221);
  a354=(a354+a276);
  a276=(a319*a032);
  a354=(a354+a276);
  a276=(a320*a207);
  a354=(a354+a276);
  a276=(a321*a250);
  a354=(a354+a276);
  a354=(a464+a354);
  a397=(a397*a354);
  a276=(a315*a053);
  a288=(a317*a070);
  a276=(a276+a288);
  a288=(a318*a188);
  a276=(a276+a288);
  a288=(a319*a006);
  a276=(a276+a288);
  a288=(a320*a228);
  a276=(a276+a288);
  a288=(a321*a271);
  a276=(a276+a288);
  a276=(a186+a276);
  a399=(a399*a276);
  a397=(a397+a399);
  a385=(a385*a294);
  a315=(a315*a009);
  a317=(a317*a151);
  a315=(a315+a317);
  a318=(a318*a192);
  a315=(a315+a318);
  a319=(a319*a234);
  a315=(a315+a319);
  a320=(a320*a278);
  a315=(a315+a320);
  a323=(a323*a309);
  a328=(a328*a232);
  a323=(a323+a328);
  a333=(a333*a250);
  a272=(a272*a271);
  a333=(a333+a272);
  a323=(a323-a333);
  a321=(a321*a323);
  a315=(a315+a321);
  a315=(a053+a315);
  a400=(a400*a315);
  a385=(a385+a400);
  a397=(a397+a385);
  a385=(a367*a397);
  a339=(a339+a385);
  a339=(a355+a339);
  a385=(a359*a339);
  a062=(a062+a385);
  a385=(a406*a050);
  a400=(a408*a179);
  a385=(a385+a400);
  a400=(a409*a219);
  a385=(a385+a400);
  a400=(a410*a262);
  a385=(a385+a400);
  a400=(a411*a306);
  a385=(a385+a400);
  a400=(a412*a351);
  a385=(a385+a400);
  a400=(a413*a397);
  a385=(a385+a400);
  a400=(a360*a355);
  a321=(a362*a181);
  a400=(a400+a321);
  a321=(a363*a221);
  a400=(a400+a321);
  a321=(a364*a032);
  a400=(a400+a321);
  a321=(a365*a207);
  a400=(a400+a321);
  a321=(a366*a250);
  a400=(a400+a321);
  a321=(a367*a294);
  a400=(a400+a321);
  a400=(a464+a400);
  a444=(a444*a400);
  a321=(a360*a053);
  a333=(a362*a070);
  a321=(a321+a333);
  a333=(a363*a188);
  a321=(a321+a333);
  a333=(a364*a006);
  a321=(a321+a333);
  a333=(a365*a228);
  a321=(a321+a333);
  a333=(a366*a271);
  a321=(a321+a333);
  a333=(a367*a315);
  a321=(a321+a333);
  a321=(a186+a321);
  a446=(a446*a321);
  a444=(a444+a446);
  a432=(a432*a339);
  a360=(a360*a009);
  a362=(a362*a151);
  a360=(a360+a362);
  a363=(a363*a192);
  a360=(a360+a363);
  a364=(a364*a234);
  a360=(a360+a364);
  a365=(a365*a278);
  a360=(a360+a365);
  a366=(a366*a323);
  a360=(a360+a366);
  a369=(a369*a354);
  a374=(a374*a276);
  a369=(a369+a374);
  a379=(a379*a294);
  a316=(a316*a315);
  a379=(a379+a316);
  a369=(a369-a379);
  a367=(a367*a369);
  a360=(a360+a367);
  a360=(a053+a360);
  a447=(a447*a360);
  a432=(a432+a447);
  a444=(a444+a432);
  a432=(a414*a444);
  a385=(a385+a432);
  a385=(a355+a385);
  a432=(a405*a385);
  a062=(a062+a432);
  a432=(a453*a050);
  a179=(a455*a179);
  a432=(a432+a179);
  a219=(a183*a219);
  a432=(a432+a219);
  a219=(a223*a262);
  a432=(a432+a219);
  a219=(a456*a306);
  a432=(a432+a219);
  a219=(a457*a351);
  a432=(a432+a219);
  a219=(a458*a397);
  a432=(a432+a219);
  a219=(a459*a444);
  a432=(a432+a219);
  a219=(a406*a355);
  a179=(a408*a181);
  a219=(a219+a179);
  a179=(a409*a221);
  a219=(a219+a179);
  a179=(a410*a032);
  a219=(a219+a179);
  a179=(a411*a207);
  a219=(a219+a179);
  a179=(a412*a250);
  a219=(a219+a179);
  a179=(a413*a294);
  a219=(a219+a179);
  a179=(a414*a339);
  a219=(a219+a179);
  a219=(a464+a219);
  a489=(a489*a219);
  a179=(a406*a053);
  a447=(a408*a070);
  a179=(a179+a447);
  a447=(a409*a188);
  a179=(a179+a447);
  a447=(a410*a006);
  a179=(a179+a447);
  a447=(a411*a228);
  a179=(a179+a447);
  a447=(a412*a271);
  a179=(a179+a447);
  a447=(a413*a315);
  a179=(a179+a447);
  a447=(a414*a360);
  a179=(a179+a447);
  a179=(a186+a179);
  a491=(a491*a179);
  a489=(a489+a491);
  a477=(a477*a385);
  a406=(a406*a009);
  a408=(a408*a151);
  a406=(a406+a408);
  a409=(a409*a192);
  a406=(a406+a409);
  a410=(a410*a234);
  a406=(a406+a410);
  a411=(a411*a278);
  a406=(a406+a411);
  a412=(a412*a323);
  a406=(a406+a412);
  a413=(a413*a369);
  a406=(a406+a413);
  a416=(a416*a400);
  a421=(a421*a321);
  a416=(a416+a421);
  a426=(a426*a339);
  a361=(a361*a360);
  a426=(a426+a361);
  a416=(a416-a426);
  a414=(a414*a416);
  a406=(a406+a414);
  a406=(a053+a406);
  a492=(a492*a406);
  a477=(a477+a492);
  a489=(a489+a477);
  a477=(a460*a489);
  a432=(a432+a477);
  a432=(a355+a432);
  a477=(a452*a432);
  a062=(a062+a477);
  a062=(a464+a062);
  if (res[0]!=0) res[0][12]=a062;
  a062=(a001*a053);
  a477=(a005*a006);
  a062=(a062+a477);
  a477=(a227*a228);
  a062=(a062+a477);
  a477=(a270*a271);
  a062=(a062+a477);
  a477=(a314*a315);
  a062=(a062+a477);
  a477=(a359*a360);
  a062=(a062+a477);
  a477=(a405*a406);
  a062=(a062+a477);
  a477=(a453*a009);
  a151=(a455*a151);
  a477=(a477+a151);
  a192=(a183*a192);
  a477=(a477+a192);
  a192=(a223*a234);
  a477=(a477+a192);
  a192=(a456*a278);
  a477=(a477+a192);
  a192=(a457*a323);
  a477=(a477+a192);
  a192=(a458*a369);
  a477=(a477+a192);
  a192=(a459*a416);
  a477=(a477+a192);
  a461=(a461*a219);
  a466=(a466*a179);
  a461=(a461+a466);
  a471=(a471*a385);
  a407=(a407*a406);
  a471=(a471+a407);
  a461=(a461-a471);
  a471=(a460*a461);
  a477=(a477+a471);
  a477=(a053+a477);
  a471=(a452*a477);
  a062=(a062+a471);
  a062=(a186+a062);
  if (res[0]!=0) res[0][13]=a062;
  a050=(a001*a050);
  a262=(a005*a262);
  a050=(a050+a262);
  a306=(a227*a306);
  a050=(a050+a306);
  a351=(a270*a351);
  a050=(a050+a351);
  a397=(a314*a397);
  a050=(a050+a397);
  a444=(a359*a444);
  a050=(a050+a444);
  a489=(a405*a489);
  a050=(a050+a489);
  a489=(a453*a355);
  a181=(a455*a181);
  a489=(a489+a181);
  a221=(a183*a221);
  a489=(a489+a221);
  a032=(a223*a032);
  a489=(a489+a032);
  a207=(a456*a207);
  a489=(a489+a207);
  a250=(a457*a250);
  a489=(a489+a250);
  a294=(a458*a294);
  a489=(a489+a294);
  a339=(a459*a339);
  a489=(a489+a339);
  a385=(a460*a385);
  a489=(a489+a385);
  a464=(a464+a489);
  a033=(a033*a464);
  a453=(a453*a053);
  a455=(a455*a070);
  a453=(a453+a455);
  a183=(a183*a188);
  a453=(a453+a183);
  a223=(a223*a006);
  a453=(a453+a223);
  a456=(a456*a228);
  a453=(a453+a456);
  a457=(a457*a271);
  a453=(a453+a457);
  a458=(a458*a315);
  a453=(a453+a458);
  a459=(a459*a360);
  a453=(a453+a459);
  a460=(a460*a406);
  a453=(a453+a460);
  a186=(a186+a453);
  a513=(a513*a186);
  a033=(a033+a513);
  a502=(a502*a432);
  a052=(a052*a477);
  a502=(a502+a052);
  a033=(a033+a502);
  a033=(a452*a033);
  a050=(a050+a033);
  a355=(a355+a050);
  if (res[0]!=0) res[0][14]=a355;
  a001=(a001*a009);
  a005=(a005*a234);
  a001=(a001+a005);
  a227=(a227*a278);
  a001=(a001+a227);
  a270=(a270*a323);
  a001=(a001+a270);
  a314=(a314*a369);
  a001=(a001+a314);
  a359=(a359*a416);
  a001=(a001+a359);
  a405=(a405*a461);
  a001=(a001+a405);
  a448=(a448*a464);
  a310=(a310*a186);
  a448=(a448+a310);
  a498=(a498*a432);
  a048=(a048*a477);
  a498=(a498+a048);
  a448=(a448-a498);
  a452=(a452*a448);
  a001=(a001+a452);
  a053=(a053+a001);
  if (res[0]!=0) res[0][15]=a053;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[7])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+516, w1, *w2=w+532, *w3=w+539, w5, *w6=w+541, w7;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+2, *rr, *w0=w+673, *w1=w+689, *w2=w+693, *w3=w+700, *w4=w+716;
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
  casadi_real **res1=res+1, *w0=w+784, *w1=w+788, *w2=w+795;
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
  casadi_real **res1=res+2, *w0=w+799, *w1=w+803, *w2=w+810;
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
  if (sz_w) *sz_w = 814;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 814*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+2, *rr, *w0=w+673, *w1=w+689, *w2=w+693, *w3=w+700, *w4=w+716;
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
  casadi_real **res1=res+1, *w0=w+784, *w1=w+788, *w2=w+795;
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
  casadi_real **res1=res+2, *w0=w+799, *w1=w+803, *w2=w+810;
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
  if (sz_w) *sz_w = 814;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 814*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+2, *rr, *w0=w+673, *w1=w+689, *w2=w+693, *w3=w+700, *w4=w+716;
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
  casadi_real **res1=res+1, *w0=w+784, *w1=w+788, *w2=w+795;
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
  casadi_real **res1=res+2, *w0=w+799, *w1=w+803, *w2=w+810;
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
  if (sz_w) *sz_w = 814;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 20*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 814*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  casadi_real **res1=res+2, *w0=w+673, *w1=w+677, *w2=w+684, *w3=w+700;
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
  casadi_real **res1=res+2, *rr, *w0=w+704, *w1=w+720, *w2=w+724, *w3=w+731, *w4=w+747;
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
  casadi_real **res1=res+1, *w0=w+815, *w1=w+819, *w2=w+826;
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
  casadi_real **res1=res+2, *rr, *w00=w+584, *w01=w+588, *w02=w+591, *w03=w+598, *w04=w+602, *w05=w+614, w06, w07, w08, *w09=w+630;
  casadi_real *w10=w+654;
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
  casadi_real **res1=res+3, *w0=w+830, *w1=w+834, *w2=w+841, *w3=w+845;
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
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 13*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
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
  if (sz_w) *sz_w = 670;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 670*sizeof(casadi_real);
  return 0;
}

/* start_along:(z[3],p[7],d[7])->(y[4x5]) */
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

/* step_along:(y[4x5],phase[2],turns[2x12],h,p[7],t,d[7])->(y_end[4x5]) */
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
  casadi_real a444, a445, a446, a447, a448, a449, a450, a451, a452, a453, a454, a455;
  casadi_real a456, a457, a458, a459, a460, a461, a462, a463, a464, a465, a466, a467;
  casadi_real a468, a469, a470, a471, a472, a473, a474, a475, a476, a477, a478, a479;
  casadi_real a480, a481, a482, a483, a484, a485, a486, a487, a488, a489, a490, a491;
  casadi_real a492, a493, a494, a495, a496, a497, a498, a499, a500, a501, a502, a503;
  casadi_real a504, a505, a506, a507, a508, a509, a510, a511, a512, a513, a514, a515;
  casadi_real a516, a517, a518, a519, a520, a521, a522, a523, a524, a525, a526, a527;
  casadi_real a528, a529, a530, a531, a532, a533, a534, a535, a536, a537, a538, a539;
  casadi_real a540, a541, a542, a543, a544, a545, a546, a547, a548, a549, a550, a551;
  casadi_real a552, a553, a554, a555, a556, a557, a558, a559, a560, a561, a562, a563;
  casadi_real a564, a565, a566, a567, a568, a569, a570, a571, a572, a573, a574, a575;
  casadi_real a576, a577, a578, a579, a580, a581, a582, a583, a584, a585, a586, a587;
  casadi_real a588, a589, a590, a591, a592, a593, a594, a595, a596, a597, a598, a599;
  casadi_real a600, a601, a602, a603, a604, a605, a606, a607, a608, a609, a610, a611;
  casadi_real a612, a613, a614, a615, a616, a617, a618, a619, a620, a621, a622, a623;
  casadi_real a624, a625, a626, a627, a628, a629, a630, a631, a632, a633, a634, a635;
  casadi_real a636, a637, a638, a639, a640, a641, a642, a643, a644, a645, a646, a647;
  casadi_real a648, a649, a650, a651, a652, a653, a654, a655, a656, a657, a658, a659;
  casadi_real a660, a661, a662, a663, a664, a665, a666, a667, a668, a669, a670, a671;
  casadi_real a672, a673, a674, a675, a676, a677, a678, a679, a680, a681, a682, a683;
  casadi_real a684, a685, a686, a687, a688, a689, a690, a691, a692, a693, a694;
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
  a015=(a012*a013);
  a015=(a011+a015);
  a016=(a009*a015);
  a017=cos(a000);
  a018=arg[0]? arg[0][1] : 0;
  a019=cos(a018);
  a020=(a017*a019);
  a021=sin(a018);
  a022=(a010*a021);
  a020=(a020+a022);
  a022=arg[4]? arg[4][4] : 0;
  a023=(a020*a022);
  a024=(a023*a008);
  a025=(2.*a003);
  a026=arg[0]? arg[0][3] : 0;
  a027=(a025*a026);
  a028=(a027-a007);
  a029=casadi_sq(a026);
  a028=(a028-a029);
  a029=(a024*a028);
  a030=(a018-a000);
  a031=arg[4]? arg[4][6] : 0;
  a030=(a030+a031);
  a032=cos(a030);
  a033=(a032*a022);
  a029=(a029-a033);
  a034=(a017*a022);
  a035=(a034*a003);
  a035=(a035*a003);
  a036=(a035*a008);
  a029=(a029-a036);
  a036=cos(a031);
  a037=(a017*a036);
  a038=sin(a031);
  a039=(a010*a038);
  a037=(a037+a039);
  a039=(a037*a022);
  a029=(a029-a039);
  a040=(a019*a022);
  a041=(a040*a026);
  a042=(a025-a026);
  a043=(a041*a042);
  a029=(a029+a043);
  a044=(a014*a026);
  a045=(a044*a021);
  a046=(a045*a042);
  a029=(a029-a046);
  a047=(a014*a008);
  a048=(a010*a019);
  a049=(a017*a021);
  a048=(a048-a049);
  a049=(a047*a048);
  a050=(a049*a028);
  a029=(a029+a050);
  a030=sin(a030);
  a050=(a014*a030);
  a029=(a029+a050);
  a051=(a012*a029);
  a051=(a016+a051);
  a052=(a008*a038);
  a053=(2.*a012);
  a054=(a011+a053);
  a055=(a052*a054);
  a051=(a051-a055);
  a056=(a010*a036);
  a057=(a017*a038);
  a056=(a056-a057);
  a057=(a056*a015);
  a051=(a051+a057);
  a058=(a011*a008);
  a059=(a058*a008);
  a060=(2.*a017);
  a061=(a060*a008);
  a062=(a011*a061);
  a062=(a059+a062);
  a062=(a062+a011);
  a063=arg[4]? arg[4][2] : 0;
  a064=(2.*a063);
  a062=(a062+a064);
  a065=(a022*a008);
  a066=(a065*a010);
  a067=(a017*a014);
  a068=(a067*a008);
  a066=(a066-a068);
  a068=(a019*a014);
  a066=(a066-a068);
  a066=(a066-a014);
  a069=(a022*a021);
  a066=(a066-a069);
  a070=casadi_sq(a008);
  a066=(a066+a070);
  a066=(a066+a061);
  a071=(a065*a048);
  a066=(a066+a071);
  a072=(a020*a014);
  a073=(a072*a008);
  a066=(a066-a073);
  a074=casadi_sq(a014);
  a075=casadi_sq(a022);
  a076=(a074+a075);
  a066=(a066+a076);
  a077=1.;
  a066=(a066+a077);
  a078=(a053*a066);
  a062=(a062+a078);
  a078=(a051/a062);
  a068=(a068-a074);
  a068=(a068-a075);
  a068=(a068+a069);
  a068=(a068-a071);
  a068=(a068+a073);
  a073=(a012*a068);
  a073=(a073-a063);
  a071=(a073/a062);
  a069=(a033-a050);
  a079=(a014*a021);
  a080=(a079-a040);
  a080=(a007*a080);
  a069=(a069+a080);
  a080=(a012*a069);
  a081=(a071*a051);
  a081=(a080-a081);
  a082=(a012*a076);
  a082=(a063+a082);
  a083=(a073*a071);
  a083=(a082-a083);
  a081=(a081/a083);
  a084=(a071*a081);
  a084=(a078-a084);
  a085=(a006*a084);
  a086=1.7082860872947386e-01;
  a086=(a086*a002);
  a087=2.9587585476806851e-02;
  a087=(a087*a002);
  a088=(a087*a084);
  a089=8.8762756430420545e-02;
  a089=(a089*a002);
  a090=1.9725056984537900e-02;
  a090=(a090*a002);
  a091=(a090*a084);
  a092=5.9175170953613701e-02;
  a092=(a092*a002);
  a093=5.2600151958767730e-02;
  a093=(a093*a002);
  a094=(a093*a084);
  a094=(a003+a094);
  a095=casadi_sq(a094);
  a096=(a095*a008);
  a097=(a093*a003);
  a097=(a000+a097);
  a098=sin(a097);
  a096=(a096*a098);
  a099=(a096*a015);
  a100=cos(a097);
  a101=(a093*a026);
  a101=(a018+a101);
  a102=cos(a101);
  a103=(a100*a102);
  a104=sin(a101);
  a105=(a098*a104);
  a103=(a103+a105);
  a105=(a103*a022);
  a106=(a105*a008);
  a107=(2.*a094);
  a108=(a093*a081);
  a108=(a026+a108);
  a109=(a107*a108);
  a110=(a109-a095);
  a111=casadi_sq(a108);
  a110=(a110-a111);
  a111=(a106*a110);
  a101=(a101-a097);
  a101=(a101+a031);
  a097=cos(a101);
  a112=(a097*a022);
  a111=(a111-a112);
  a113=(a100*a022);
  a114=(a113*a094);
  a114=(a114*a094);
  a115=(a114*a008);
  a111=(a111-a115);
  a115=(a100*a036);
  a116=(a098*a038);
  a115=(a115+a116);
  a116=(a115*a022);
  a111=(a111-a116);
  a117=(a102*a022);
  a118=(a117*a108);
  a119=(a107-a108);
  a120=(a118*a119);
  a111=(a111+a120);
  a121=(a014*a108);
  a122=(a121*a104);
  a123=(a122*a119);
  a111=(a111-a123);
  a124=(a098*a102);
  a125=(a100*a104);
  a124=(a124-a125);
  a125=(a047*a124);
  a126=(a125*a110);
  a111=(a111+a126);
  a101=sin(a101);
  a126=(a014*a101);
  a111=(a111+a126);
  a127=(a012*a111);
  a127=(a099+a127);
  a127=(a127-a055);
  a128=(a098*a036);
  a129=(a100*a038);
  a128=(a128-a129);
  a129=(a128*a015);
  a127=(a127+a129);
  a130=(2.*a100);
  a131=(a130*a008);
  a132=(a011*a131);
  a132=(a059+a132);
  a132=(a132+a011);
  a132=(a132+a064);
  a133=(a065*a098);
  a134=(a100*a014);
  a135=(a134*a008);
  a133=(a133-a135);
  a135=(a102*a014);
  a133=(a133-a135);
  a133=(a133-a014);
  a136=(a022*a104);
  a133=(a133-a136);
  a133=(a133+a070);
  a133=(a133+a131);
  a137=(a065*a124);
  a133=(a133+a137);
  a138=(a103*a014);
  a139=(a138*a008);
  a133=(a133-a139);
  a133=(a133+a076);
  a133=(a133+a077);
  a140=(a053*a133);
  a132=(a132+a140);
  a140=(a127/a132);
  a135=(a135-a074);
  a135=(a135-a075);
  a135=(a135+a136);
  a135=(a135-a137);
  a135=(a135+a139);
  a139=(a012*a135);
  a139=(a139-a063);
  a137=(a139/a132);
  a136=(a112-a126);
  a141=(a014*a104);
  a142=(a141-a117);
  a142=(a095*a142);
  a136=(a136+a142);
  a142=(a012*a136);
  a143=(a137*a127);
  a143=(a142-a143);
  a144=(a139*a137);
  a144=(a082-a144);
  a143=(a143/a144);
  a145=(a137*a143);
  a145=(a140-a145);
  a145=(a092*a145);
  a091=(a091+a145);
  a091=(a003+a091);
  a145=casadi_sq(a091);
  a146=(a145*a008);
  a147=(a090*a003);
  a148=(a092*a094);
  a147=(a147+a148);
  a147=(a000+a147);
  a148=sin(a147);
  a146=(a146*a148);
  a149=(a146*a015);
  a150=cos(a147);
  a151=(a090*a026);
  a152=(a092*a108);
  a151=(a151+a152);
  a151=(a018+a151);
  a152=cos(a151);
  a153=(a150*a152);
  a154=sin(a151);
  a155=(a148*a154);
  a153=(a153+a155);
  a155=(a153*a022);
  a156=(a155*a008);
  a157=(2.*a091);
  a158=(a090*a081);
  a159=(a092*a143);
  a158=(a158+a159);
  a158=(a026+a158);
  a159=(a157*a158);
  a160=(a159-a145);
  a161=casadi_sq(a158);
  a160=(a160-a161);
  a161=(a156*a160);
  a151=(a151-a147);
  a151=(a151+a031);
  a147=cos(a151);
  a162=(a147*a022);
  a161=(a161-a162);
  a163=(a150*a022);
  a164=(a163*a091);
  a164=(a164*a091);
  a165=(a164*a008);
  a161=(a161-a165);
  a165=(a150*a036);
  a166=(a148*a038);
  a165=(a165+a166);
  a166=(a165*a022);
  a161=(a161-a166);
  a167=(a152*a022);
  a168=(a167*a158);
  a169=(a157-a158);
  a170=(a168*a169);
  a161=(a161+a170);
  a171=(a014*a158);
  a172=(a171*a154);
  a173=(a172*a169);
  a161=(a161-a173);
  a174=(a148*a152);
  a175=(a150*a154);
  a174=(a174-a175);
  a175=(a047*a174);
  a176=(a175*a160);
  a161=(a161+a176);
  a151=sin(a151);
  a176=(a014*a151);
  a161=(a161+a176);
  a177=(a012*a161);
  a177=(a149+a177);
  a177=(a177-a055);
  a178=(a148*a036);
  a179=(a150*a038);
  a178=(a178-a179);
  a179=(a178*a015);
  a177=(a177+a179);
  a180=(2.*a150);
  a181=(a180*a008);
  a182=(a011*a181);
  a182=(a059+a182);
  a182=(a182+a011);
  a182=(a182+a064);
  a183=(a065*a148);
  a184=(a150*a014);
  a185=(a184*a008);
  a183=(a183-a185);
  a185=(a152*a014);
  a183=(a183-a185);
  a183=(a183-a014);
  a186=(a022*a154);
  a183=(a183-a186);
  a183=(a183+a070);
  a183=(a183+a181);
  a187=(a065*a174);
  a183=(a183+a187);
  a188=(a153*a014);
  a189=(a188*a008);
  a183=(a183-a189);
  a183=(a183+a076);
  a183=(a183+a077);
  a190=(a053*a183);
  a182=(a182+a190);
  a190=(a177/a182);
  a185=(a185-a074);
  a185=(a185-a075);
  a185=(a185+a186);
  a185=(a185-a187);
  a185=(a185+a189);
  a189=(a012*a185);
  a189=(a189-a063);
  a187=(a189/a182);
  a186=(a162-a176);
  a191=(a014*a154);
  a192=(a191-a167);
  a192=(a145*a192);
  a186=(a186+a192);
  a192=(a012*a186);
  a193=(a187*a177);
  a193=(a192-a193);
  a194=(a189*a187);
  a194=(a082-a194);
  a193=(a193/a194);
  a195=(a187*a193);
  a195=(a190-a195);
  a196=(a089*a195);
  a088=(a088+a196);
  a088=(a003+a088);
  a196=casadi_sq(a088);
  a197=(a196*a008);
  a198=(a087*a003);
  a199=(a089*a091);
  a198=(a198+a199);
  a198=(a000+a198);
  a199=sin(a198);
  a197=(a197*a199);
  a200=(a197*a015);
  a201=cos(a198);
  a202=(a087*a026);
  a203=(a089*a158);
  a202=(a202+a203);
  a202=(a018+a202);
  a203=cos(a202);
  a204=(a201*a203);
  a205=sin(a202);
  a206=(a199*a205);
  a204=(a204+a206);
  a206=(a204*a022);
  a207=(a206*a008);
  a208=(2.*a088);
  a209=(a087*a081);
  a210=(a089*a193);
  a209=(a209+a210);
  a209=(a026+a209);
  a210=(a208*a209);
  a211=(a210-a196);
  a212=casadi_sq(a209);
  a211=(a211-a212);
  a212=(a207*a211);
  a202=(a202-a198);
  a202=(a202+a031);
  a198=cos(a202);
  a213=(a198*a022);
  a212=(a212-a213);
  a214=(a201*a022);
  a215=(a214*a088);
  a215=(a215*a088);
  a216=(a215*a008);
  a212=(a212-a216);
  a216=(a201*a036);
  a217=(a199*a038);
  a216=(a216+a217);
  a217=(a216*a022);
  a212=(a212-a217);
  a218=(a203*a022);
  a219=(a218*a209);
  a220=(a208-a209);
  a221=(a219*a220);
  a212=(a212+a221);
  a222=(a014*a209);
  a223=(a222*a205);
  a224=(a223*a220);
  a212=(a212-a224);
  a225=(a199*a203);
  a226=(a201*a205);
  a225=(a225-a226);
  a226=(a047*a225);
  a227=(a226*a211);
  a212=(a212+a227);
  a202=sin(a202);
  a227=(a014*a202);
  a212=(a212+a227);
  a228=(a012*a212);
  a228=(a200+a228);
  a228=(a228-a055);
  a229=(a199*a036);
  a230=(a201*a038);
  a229=(a229-a230);
  a230=(a229*a015);
  a228=(a228+a230);
  a231=(2.*a201);
  a232=(a231*a008);
  a233=(a011*a232);
  a233=(a059+a233);
  a233=(a233+a011);
  a233=(a233+a064);
  a234=(a065*a199);
  a235=(a201*a014);
  a236=(a235*a008);
  a234=(a234-a236);
  a236=(a203*a014);
  a234=(a234-a236);
  a234=(a234-a014);
  a237=(a022*a205);
  a234=(a234-a237);
  a234=(a234+a070);
  a234=(a234+a232);
  a238=(a065*a225);
  a234=(a234+a238);
  a239=(a204*a014);
  a240=(a239*a008);
  a234=(a234-a240);
  a234=(a234+a076);
  a234=(a234+a077);
  a241=(a053*a234);
  a233=(a233+a241);
  a241=(a228/a233);
  a236=(a236-a074);
  a236=(a236-a075);
  a236=(a236+a237);
  a236=(a236-a238);
  a236=(a236+a240);
  a240=(a012*a236);
  a240=(a240-a063);
  a238=(a240/a233);
  a237=(a213-a227);
  a242=(a014*a205);
  a243=(a242-a218);
  a243=(a196*a243);
  a237=(a237+a243);
  a243=(a012*a237);
  a244=(a238*a228);
  a244=(a243-a244);
  a245=(a240*a238);
  a245=(a082-a245);
  a244=(a244/a245);
  a246=(a238*a244);
  a246=(a241-a246);
  a247=(a086*a246);
  a085=(a085+a247);
  a247=1.2546768756682242e-01;
  a247=(a247*a002);
  a248=2.4136513415926669e-01;
  a248=(a248*a002);
  a249=(a248*a084);
  a250=-8.8454947932828609e-01;
  a250=(a250*a002);
  a195=(a250*a195);
  a249=(a249+a195);
  a195=9.2483400326179199e-01;
  a195=(a195*a002);
  a251=(a195*a246);
  a249=(a249+a251);
  a249=(a003+a249);
  a251=casadi_sq(a249);
  a252=(a251*a008);
  a253=(a248*a003);
  a254=(a250*a091);
  a253=(a253+a254);
  a254=(a195*a088);
  a253=(a253+a254);
  a253=(a000+a253);
  a254=sin(a253);
  a252=(a252*a254);
  a255=(a252*a015);
  a256=cos(a253);
  a257=(a248*a026);
  a258=(a250*a158);
  a257=(a257+a258);
  a258=(a195*a209);
  a257=(a257+a258);
  a257=(a018+a257);
  a258=cos(a257);
  a259=(a256*a258);
  a260=sin(a257);
  a261=(a254*a260);
  a259=(a259+a261);
  a261=(a259*a022);
  a262=(a261*a008);
  a263=(2.*a249);
  a264=(a248*a081);
  a265=(a250*a193);
  a264=(a264+a265);
  a265=(a195*a244);
  a264=(a264+a265);
  a264=(a026+a264);
  a265=(a263*a264);
  a266=(a265-a251);
  a267=casadi_sq(a264);
  a266=(a266-a267);
  a267=(a262*a266);
  a257=(a257-a253);
  a257=(a257+a031);
  a253=cos(a257);
  a268=(a253*a022);
  a267=(a267-a268);
  a269=(a256*a022);
  a270=(a269*a249);
  a270=(a270*a249);
  a271=(a270*a008);
  a267=(a267-a271);
  a271=(a256*a036);
  a272=(a254*a038);
  a271=(a271+a272);
  a272=(a271*a022);
  a267=(a267-a272);
  a273=(a258*a022);
  a274=(a273*a264);
  a275=(a263-a264);
  a276=(a274*a275);
  a267=(a267+a276);
  a277=(a014*a264);
  a278=(a277*a260);
  a279=(a278*a275);
  a267=(a267-a279);
  a280=(a254*a258);
  a281=(a256*a260);
  a280=(a280-a281);
  a281=(a047*a280);
  a282=(a281*a266);
  a267=(a267+a282);
  a257=sin(a257);
  a282=(a014*a257);
  a267=(a267+a282);
  a283=(a012*a267);
  a283=(a255+a283);
  a283=(a283-a055);
  a284=(a254*a036);
  a285=(a256*a038);
  a284=(a284-a285);
  a285=(a284*a015);
  a283=(a283+a285);
  a286=(2.*a256);
  a287=(a286*a008);
  a288=(a011*a287);
  a288=(a059+a288);
  a288=(a288+a011);
  a288=(a288+a064);
  a289=(a065*a254);
  a290=(a256*a014);
  a291=(a290*a008);
  a289=(a289-a291);
  a291=(a258*a014);
  a289=(a289-a291);
  a289=(a289-a014);
  a292=(a022*a260);
  a289=(a289-a292);
  a289=(a289+a070);
  a289=(a289+a287);
  a293=(a065*a280);
  a289=(a289+a293);
  a294=(a259*a014);
  a295=(a294*a008);
  a289=(a289-a295);
  a289=(a289+a076);
  a289=(a289+a077);
  a296=(a053*a289);
  a288=(a288+a296);
  a296=(a283/a288);
  a291=(a291-a074);
  a291=(a291-a075);
  a291=(a291+a292);
  a291=(a291-a293);
  a291=(a291+a295);
  a295=(a012*a291);
  a295=(a295-a063);
  a293=(a295/a288);
  a292=(a268-a282);
  a297=(a014*a260);
  a298=(a297-a273);
  a298=(a251*a298);
  a292=(a292+a298);
  a298=(a012*a292);
  a299=(a293*a283);
  a299=(a298-a299);
  a300=(a295*a293);
  a300=(a082-a300);
  a299=(a299/a300);
  a301=(a293*a299);
  a301=(a296-a301);
  a302=(a247*a301);
  a085=(a085+a302);
  a085=(a003+a085);
  a302=(a005*a085);
  a004=(a004+a302);
  a302=1.8915178993145003e+00;
  a302=(a302*a002);
  a303=3.7109375000000000e-02;
  a303=(a303*a002);
  a304=(a303*a084);
  a305=1.7025221101954405e-01;
  a305=(a305*a002);
  a306=(a305*a246);
  a304=(a304+a306);
  a306=6.0216538980455959e-02;
  a306=(a306*a002);
  a307=(a306*a301);
  a304=(a304+a307);
  a307=-1.7578125000000000e-02;
  a307=(a307*a002);
  a308=casadi_sq(a085);
  a309=(a308*a008);
  a310=(a006*a003);
  a311=(a086*a088);
  a310=(a310+a311);
  a311=(a247*a249);
  a310=(a310+a311);
  a310=(a000+a310);
  a311=sin(a310);
  a309=(a309*a311);
  a312=(a309*a015);
  a313=cos(a310);
  a314=(a006*a026);
  a315=(a086*a209);
  a314=(a314+a315);
  a315=(a247*a264);
  a314=(a314+a315);
  a314=(a018+a314);
  a315=cos(a314);
  a316=(a313*a315);
  a317=sin(a314);
  a318=(a311*a317);
  a316=(a316+a318);
  a318=(a316*a022);
  a319=(a318*a008);
  a320=(2.*a085);
  a321=(a006*a081);
  a322=(a086*a244);
  a321=(a321+a322);
  a322=(a247*a299);
  a321=(a321+a322);
  a321=(a026+a321);
  a322=(a320*a321);
  a323=(a322-a308);
  a324=casadi_sq(a321);
  a323=(a323-a324);
  a324=(a319*a323);
  a314=(a314-a310);
  a314=(a314+a031);
  a310=cos(a314);
  a325=(a310*a022);
  a324=(a324-a325);
  a326=(a313*a022);
  a327=(a326*a085);
  a327=(a327*a085);
  a328=(a327*a008);
  a324=(a324-a328);
  a328=(a313*a036);
  a329=(a311*a038);
  a328=(a328+a329);
  a329=(a328*a022);
  a324=(a324-a329);
  a330=(a315*a022);
  a331=(a330*a321);
  a332=(a320-a321);
  a333=(a331*a332);
  a324=(a324+a333);
  a334=(a014*a321);
  a335=(a334*a317);
  a336=(a335*a332);
  a324=(a324-a336);
  a337=(a311*a315);
  a338=(a313*a317);
  a337=(a337-a338);
  a338=(a047*a337);
  a339=(a338*a323);
  a324=(a324+a339);
  a314=sin(a314);
  a339=(a014*a314);
  a324=(a324+a339);
  a340=(a012*a324);
  a340=(a312+a340);
  a340=(a340-a055);
  a341=(a311*a036);
  a342=(a313*a038);
  a341=(a341-a342);
  a342=(a341*a015);
  a340=(a340+a342);
  a343=(2.*a313);
  a344=(a343*a008);
  a345=(a011*a344);
  a345=(a059+a345);
  a345=(a345+a011);
  a345=(a345+a064);
  a346=(a065*a311);
  a347=(a313*a014);
  a348=(a347*a008);
  a346=(a346-a348);
  a348=(a315*a014);
  a346=(a346-a348);
  a346=(a346-a014);
  a349=(a022*a317);
  a346=(a346-a349);
  a346=(a346+a070);
  a346=(a346+a344);
  a350=(a065*a337);
  a346=(a346+a350);
  a351=(a316*a014);
  a352=(a351*a008);
  a346=(a346-a352);
  a346=(a346+a076);
  a346=(a346+a077);
  a353=(a053*a346);
  a345=(a345+a353);
  a353=(a340/a345);
  a348=(a348-a074);
  a348=(a348-a075);
  a348=(a348+a349);
  a348=(a348-a350);
  a348=(a348+a352);
  a352=(a012*a348);
  a352=(a352-a063);
  a350=(a352/a345);
  a349=(a325-a339);
  a354=(a014*a317);
  a355=(a354-a330);
  a355=(a308*a355);
  a349=(a349+a355);
  a355=(a012*a349);
  a356=(a350*a340);
  a356=(a355-a356);
  a357=(a352*a350);
  a357=(a082-a357);
  a356=(a356/a357);
  a358=(a350*a356);
  a358=(a353-a358);
  a359=(a307*a358);
  a304=(a304+a359);
  a304=(a003+a304);
  a359=(a302*a304);
  a004=(a004+a359);
  a359=-5.8012039600105849e+00;
  a359=(a359*a002);
  a360=3.7092000118504789e-02;
  a360=(a360*a002);
  a361=(a360*a084);
  a362=1.7038392571223998e-01;
  a362=(a362*a002);
  a363=(a362*a246);
  a361=(a361+a363);
  a363=1.0726203044637328e-01;
  a363=(a363*a002);
  a364=(a363*a301);
  a361=(a361+a364);
  a364=-1.5319437748624402e-02;
  a364=(a364*a002);
  a365=(a364*a358);
  a361=(a361+a365);
  a365=8.2737891638140233e-03;
  a365=(a365*a002);
  a366=casadi_sq(a304);
  a367=(a366*a008);
  a368=(a303*a003);
  a369=(a305*a088);
  a368=(a368+a369);
  a369=(a306*a249);
  a368=(a368+a369);
  a369=(a307*a085);
  a368=(a368+a369);
  a368=(a000+a368);
  a369=sin(a368);
  a367=(a367*a369);
  a370=(a367*a015);
  a371=cos(a368);
  a372=(a303*a026);
  a373=(a305*a209);
  a372=(a372+a373);
  a373=(a306*a264);
  a372=(a372+a373);
  a373=(a307*a321);
  a372=(a372+a373);
  a372=(a018+a372);
  a373=cos(a372);
  a374=(a371*a373);
  a375=sin(a372);
  a376=(a369*a375);
  a374=(a374+a376);
  a376=(a374*a022);
  a377=(a376*a008);
  a378=(2.*a304);
  a379=(a303*a081);
  a380=(a305*a244);
  a379=(a379+a380);
  a380=(a306*a299);
  a379=(a379+a380);
  a380=(a307*a356);
  a379=(a379+a380);
  a379=(a026+a379);
  a380=(a378*a379);
  a381=(a380-a366);
  a382=casadi_sq(a379);
  a381=(a381-a382);
  a382=(a377*a381);
  a372=(a372-a368);
  a372=(a372+a031);
  a368=cos(a372);
  a383=(a368*a022);
  a382=(a382-a383);
  a384=(a371*a022);
  a385=(a384*a304);
  a385=(a385*a304);
  a386=(a385*a008);
  a382=(a382-a386);
  a386=(a371*a036);
  a387=(a369*a038);
  a386=(a386+a387);
  a387=(a386*a022);
  a382=(a382-a387);
  a388=(a373*a022);
  a389=(a388*a379);
  a390=(a378-a379);
  a391=(a389*a390);
  a382=(a382+a391);
  a392=(a014*a379);
  a393=(a392*a375);
  a394=(a393*a390);
  a382=(a382-a394);
  a395=(a369*a373);
  a396=(a371*a375);
  a395=(a395-a396);
  a396=(a047*a395);
  a397=(a396*a381);
  a382=(a382+a397);
  a372=sin(a372);
  a397=(a014*a372);
  a382=(a382+a397);
  a398=(a012*a382);
  a398=(a370+a398);
  a398=(a398-a055);
  a399=(a369*a036);
  a400=(a371*a038);
  a399=(a399-a400);
  a400=(a399*a015);
  a398=(a398+a400);
  a401=(2.*a371);
  a402=(a401*a008);
  a403=(a011*a402);
  a403=(a059+a403);
  a403=(a403+a011);
  a403=(a403+a064);
  a404=(a065*a369);
  a405=(a371*a014);
  a406=(a405*a008);
  a404=(a404-a406);
  a406=(a373*a014);
  a404=(a404-a406);
  a404=(a404-a014);
  a407=(a022*a375);
  a404=(a404-a407);
  a404=(a404+a070);
  a404=(a404+a402);
  a408=(a065*a395);
  a404=(a404+a408);
  a409=(a374*a014);
  a410=(a409*a008);
  a404=(a404-a410);
  a404=(a404+a076);
  a404=(a404+a077);
  a411=(a053*a404);
  a403=(a403+a411);
  a411=(a398/a403);
  a406=(a406-a074);
  a406=(a406-a075);
  a406=(a406+a407);
  a406=(a406-a408);
  a406=(a406+a410);
  a410=(a012*a406);
  a410=(a410-a063);
  a408=(a410/a403);
  a407=(a383-a397);
  a412=(a014*a375);
  a413=(a412-a388);
  a413=(a366*a413);
  a407=(a407+a413);
  a413=(a012*a407);
  a414=(a408*a398);
  a414=(a413-a414);
  a415=(a410*a408);
  a415=(a082-a415);
  a414=(a414/a415);
  a416=(a408*a414);
  a416=(a411-a416);
  a417=(a365*a416);
  a361=(a361+a417);
  a361=(a003+a361);
  a417=(a359*a361);
  a004=(a004+a417);
  a417=3.1116436695781990e-01;
  a417=(a417*a002);
  a418=6.2411095871607569e-01;
  a418=(a418*a002);
  a419=(a418*a084);
  a420=-3.3608926294469414e+00;
  a420=(a420*a002);
  a421=(a420*a246);
  a419=(a419+a421);
  a421=-8.6821934684172597e-01;
  a421=(a421*a002);
  a422=(a421*a301);
  a419=(a419+a422);
  a422=2.7592099699446710e+01;
  a422=(a422*a002);
  a423=(a422*a358);
  a419=(a419+a423);
  a423=2.0154067550477894e+01;
  a423=(a423*a002);
  a424=(a423*a416);
  a419=(a419+a424);
  a424=-4.3489884181069961e+01;
  a424=(a424*a002);
  a425=casadi_sq(a361);
  a426=(a425*a008);
  a427=(a360*a003);
  a428=(a362*a088);
  a427=(a427+a428);
  a428=(a363*a249);
  a427=(a427+a428);
  a428=(a364*a085);
  a427=(a427+a428);
  a428=(a365*a304);
  a427=(a427+a428);
  a427=(a000+a427);
  a428=sin(a427);
  a426=(a426*a428);
  a429=(a426*a015);
  a430=cos(a427);
  a431=(a360*a026);
  a432=(a362*a209);
  a431=(a431+a432);
  a432=(a363*a264);
  a431=(a431+a432);
  a432=(a364*a321);
  a431=(a431+a432);
  a432=(a365*a379);
  a431=(a431+a432);
  a431=(a018+a431);
  a432=cos(a431);
  a433=(a430*a432);
  a434=sin(a431);
  a435=(a428*a434);
  a433=(a433+a435);
  a435=(a433*a022);
  a436=(a435*a008);
  a437=(2.*a361);
  a438=(a360*a081);
  a439=(a362*a244);
  a438=(a438+a439);
  a439=(a363*a299);
  a438=(a438+a439);
  a439=(a364*a356);
  a438=(a438+a439);
  a439=(a365*a414);
  a438=(a438+a439);
  a438=(a026+a438);
  a439=(a437*a438);
  a440=(a439-a425);
  a441=casadi_sq(a438);
  a440=(a440-a441);
  a441=(a436*a440);
  a431=(a431-a427);
  a431=(a431+a031);
  a427=cos(a431);
  a442=(a427*a022);
  a441=(a441-a442);
  a443=(a430*a022);
  a444=(a443*a361);
  a444=(a444*a361);
  a445=(a444*a008);
  a441=(a441-a445);
  a445=(a430*a036);
  a446=(a428*a038);
  a445=(a445+a446);
  a446=(a445*a022);
  a441=(a441-a446);
  a447=(a432*a022);
  a448=(a447*a438);
  a449=(a437-a438);
  a450=(a448*a449);
  a441=(a441+a450);
  a451=(a014*a438);
  a452=(a451*a434);
  a453=(a452*a449);
  a441=(a441-a453);
  a454=(a428*a432);
  a455=(a430*a434);
  a454=(a454-a455);
  a455=(a047*a454);
  a456=(a455*a440);
  a441=(a441+a456);
  a431=sin(a431);
  a456=(a014*a431);
  a441=(a441+a456);
  a457=(a012*a441);
  a457=(a429+a457);
  a457=(a457-a055);
  a458=(a428*a036);
  a459=(a430*a038);
  a458=(a458-a459);
  a459=(a458*a015);
  a457=(a457+a459);
  a460=(2.*a430);
  a461=(a460*a008);
  a462=(a011*a461);
  a462=(a059+a462);
  a462=(a462+a011);
  a462=(a462+a064);
  a463=(a065*a428);
  a464=(a430*a014);
  a465=(a464*a008);
  a463=(a463-a465);
  a465=(a432*a014);
  a463=(a463-a465);
  a463=(a463-a014);
  a466=(a022*a434);
  a463=(a463-a466);
  a463=(a463+a070);
  a463=(a463+a461);
  a467=(a065*a454);
  a463=(a463+a467);
  a468=(a433*a014);
  a469=(a468*a008);
  a463=(a463-a469);
  a463=(a463+a076);
  a463=(a463+a077);
  a470=(a053*a463);
  a462=(a462+a470);
  a470=(a457/a462);
  a465=(a465-a074);
  a465=(a465-a075);
  a465=(a465+a466);
  a465=(a465-a467);
  a465=(a465+a469);
  a469=(a012*a465);
  a469=(a469-a063);
  a467=(a469/a462);
  a466=(a442-a456);
  a471=(a014*a434);
  a472=(a471-a447);
  a472=(a425*a472);
  a466=(a466+a472);
  a472=(a012*a466);
  a473=(a467*a457);
  a473=(a472-a473);
  a474=(a469*a467);
  a474=(a082-a474);
  a473=(a473/a474);
  a475=(a467*a473);
  a475=(a470-a475);
  a476=(a424*a475);
  a419=(a419+a476);
  a419=(a003+a419);
  a476=(a417*a419);
  a004=(a004+a476);
  a476=-1.5216094966251609e-01;
  a476=(a476*a002);
  a477=4.7766253643826434e-01;
  a477=(a477*a002);
  a478=(a477*a084);
  a479=-2.4881146199716677e+00;
  a479=(a479*a002);
  a480=(a479*a246);
  a478=(a478+a480);
  a480=-5.9029082683684297e-01;
  a480=(a480*a002);
  a481=(a480*a301);
  a478=(a478+a481);
  a481=2.1230051448181193e+01;
  a481=(a481*a002);
  a482=(a481*a358);
  a478=(a478+a482);
  a482=1.5279233632882423e+01;
  a482=(a482*a002);
  a483=(a482*a416);
  a478=(a478+a483);
  a483=-3.3288210968984863e+01;
  a483=(a483*a002);
  a484=(a483*a475);
  a478=(a478+a484);
  a484=-2.0331201708508627e-02;
  a484=(a484*a002);
  a485=casadi_sq(a419);
  a486=(a485*a008);
  a487=(a418*a003);
  a488=(a420*a088);
  a487=(a487+a488);
  a488=(a421*a249);
  a487=(a487+a488);
  a488=(a422*a085);
  a487=(a487+a488);
  a488=(a423*a304);
  a487=(a487+a488);
  a488=(a424*a361);
  a487=(a487+a488);
  a487=(a000+a487);
  a488=sin(a487);
  a486=(a486*a488);
  a489=(a486*a015);
  a490=cos(a487);
  a491=(a418*a026);
  a492=(a420*a209);
  a491=(a491+a492);
  a492=(a421*a264);
  a491=(a491+a492);
  a492=(a422*a321);
  a491=(a491+a492);
  a492=(a423*a379);
  a491=(a491+a492);
  a492=(a424*a438);
  a491=(a491+a492);
  a491=(a018+a491);
  a492=cos(a491);
  a493=(a490*a492);
  a494=sin(a491);
  a495=(a488*a494);
  a493=(a493+a495);
  a495=(a493*a022);
  a496=(a495*a008);
  a497=(2.*a419);
  a498=(a418*a081);
  a499=(a420*a244);
  a498=(a498+a499);
  a499=(a421*a299);
  a498=(a498+a499);
  a499=(a422*a356);
  a498=(a498+a499);
  a499=(a423*a414);
  a498=(a498+a499);
  a499=(a424*a473);
  a498=(a498+a499);
  a498=(a026+a498);
  a499=(a497*a498);
  a500=(a499-a485);
  a501=casadi_sq(a498);
  a500=(a500-a501);
  a501=(a496*a500);
  a491=(a491-a487);
  a491=(a491+a031);
  a487=cos(a491);
  a502=(a487*a022);
  a501=(a501-a502);
  a503=(a490*a022);
  a504=(a503*a419);
  a504=(a504*a419);
  a505=(a504*a008);
  a501=(a501-a505);
  a505=(a490*a036);
  a506=(a488*a038);
  a505=(a505+a506);
  a506=(a505*a022);
  a501=(a501-a506);
  a507=(a492*a022);
  a508=(a507*a498);
  a509=(a497-a498);
  a510=(a508*a509);
  a501=(a501+a510);
  a511=(a014*a498);
  a512=(a511*a494);
  a513=(a512*a509);
  a501=(a501-a513);
  a514=(a488*a492);
  a515=(a490*a494);
  a514=(a514-a515);
  a515=(a047*a514);
  a516=(a515*a500);
  a501=(a501+a516);
  a491=sin(a491);
  a516=(a014*a491);
  a501=(a501+a516);
  a517=(a012*a501);
  a517=(a489+a517);
  a517=(a517-a055);
  a518=(a488*a036);
  a519=(a490*a038);
  a518=(a518-a519);
  a519=(a518*a015);
  a517=(a517+a519);
  a520=(2.*a490);
  a521=(a520*a008);
  a522=(a011*a521);
  a522=(a059+a522);
  a522=(a522+a011);
  a522=(a522+a064);
  a523=(a065*a488);
  a524=(a490*a014);
  a525=(a524*a008);
  a523=(a523-a525);
  a525=(a492*a014);
  a523=(a523-a525);
  a523=(a523-a014);
  a526=(a022*a494);
  a523=(a523-a526);
  a523=(a523+a070);
  a523=(a523+a521);
  a527=(a065*a514);
  a523=(a523+a527);
  a528=(a493*a014);
  a529=(a528*a008);
  a523=(a523-a529);
  a523=(a523+a076);
  a523=(a523+a077);
  a530=(a053*a523);
  a522=(a522+a530);
  a530=(a517/a522);
  a525=(a525-a074);
  a525=(a525-a075);
  a525=(a525+a526);
  a525=(a525-a527);
  a525=(a525+a529);
  a529=(a012*a525);
  a529=(a529-a063);
  a527=(a529/a522);
  a526=(a502-a516);
  a531=(a014*a494);
  a532=(a531-a507);
  a532=(a485*a532);
  a526=(a526+a532);
  a532=(a012*a526);
  a533=(a527*a517);
  a533=(a532-a533);
  a534=(a529*a527);
  a534=(a082-a534);
  a533=(a533/a534);
  a535=(a527*a533);
  a535=(a530-a535);
  a536=(a484*a535);
  a478=(a478+a536);
  a478=(a003+a478);
  a536=(a476*a478);
  a004=(a004+a536);
  a536=2.0136540080403034e-01;
  a536=(a536*a002);
  a537=-9.3714243008598730e-01;
  a537=(a537*a002);
  a538=(a537*a084);
  a539=5.1863724288440638e+00;
  a539=(a539*a002);
  a540=(a539*a246);
  a538=(a538+a540);
  a540=1.0914373489967295e+00;
  a540=(a540*a002);
  a541=(a540*a301);
  a538=(a538+a541);
  a541=-8.1497870107469268e+00;
  a541=(a541*a002);
  a542=(a541*a358);
  a538=(a538+a542);
  a542=-1.8520065659996959e+01;
  a542=(a542*a002);
  a543=(a542*a416);
  a538=(a538+a543);
  a543=2.2739487099350505e+01;
  a543=(a543*a002);
  a544=(a543*a475);
  a538=(a538+a544);
  a544=2.4936055526796523e+00;
  a544=(a544*a002);
  a545=(a544*a535);
  a538=(a538+a545);
  a545=-3.0467644718982196e+00;
  a545=(a545*a002);
  a546=casadi_sq(a478);
  a547=(a546*a008);
  a548=(a477*a003);
  a549=(a479*a088);
  a548=(a548+a549);
  a549=(a480*a249);
  a548=(a548+a549);
  a549=(a481*a085);
  a548=(a548+a549);
  a549=(a482*a304);
  a548=(a548+a549);
  a549=(a483*a361);
  a548=(a548+a549);
  a549=(a484*a419);
  a548=(a548+a549);
  a548=(a000+a548);
  a549=sin(a548);
  a547=(a547*a549);
  a550=(a547*a015);
  a551=cos(a548);
  a552=(a477*a026);
  a553=(a479*a209);
  a552=(a552+a553);
  a553=(a480*a264);
  a552=(a552+a553);
  a553=(a481*a321);
  a552=(a552+a553);
  a553=(a482*a379);
  a552=(a552+a553);
  a553=(a483*a438);
  a552=(a552+a553);
  a553=(a484*a498);
  a552=(a552+a553);
  a552=(a018+a552);
  a553=cos(a552);
  a554=(a551*a553);
  a555=sin(a552);
  a556=(a549*a555);
  a554=(a554+a556);
  a556=(a554*a022);
  a557=(a556*a008);
  a558=(2.*a478);
  a559=(a477*a081);
  a560=(a479*a244);
  a559=(a559+a560);
  a560=(a480*a299);
  a559=(a559+a560);
  a560=(a481*a356);
  a559=(a559+a560);
  a560=(a482*a414);
  a559=(a559+a560);
  a560=(a483*a473);
  a559=(a559+a560);
  a560=(a484*a533);
  a559=(a559+a560);
  a559=(a026+a559);
  a560=(a558*a559);
  a561=(a560-a546);
  a562=casadi_sq(a559);
  a561=(a561-a562);
  a562=(a557*a561);
  a552=(a552-a548);
  a552=(a552+a031);
  a548=cos(a552);
  a563=(a548*a022);
  a562=(a562-a563);
  a564=(a551*a022);
  a565=(a564*a478);
  a565=(a565*a478);
  a566=(a565*a008);
  a562=(a562-a566);
  a566=(a551*a036);
  a567=(a549*a038);
  a566=(a566+a567);
  a567=(a566*a022);
  a562=(a562-a567);
  a568=(a553*a022);
  a569=(a568*a559);
  a570=(a558-a559);
  a571=(a569*a570);
  a562=(a562+a571);
  a572=(a014*a559);
  a573=(a572*a555);
  a574=(a573*a570);
  a562=(a562-a574);
  a575=(a549*a553);
  a576=(a551*a555);
  a575=(a575-a576);
  a576=(a047*a575);
  a577=(a576*a561);
  a562=(a562+a577);
  a552=sin(a552);
  a577=(a014*a552);
  a562=(a562+a577);
  a578=(a012*a562);
  a578=(a550+a578);
  a578=(a578-a055);
  a579=(a549*a036);
  a580=(a551*a038);
  a579=(a579-a580);
  a580=(a579*a015);
  a578=(a578+a580);
  a581=(2.*a551);
  a582=(a581*a008);
  a583=(a011*a582);
  a583=(a059+a583);
  a583=(a583+a011);
  a583=(a583+a064);
  a584=(a065*a549);
  a585=(a551*a014);
  a586=(a585*a008);
  a584=(a584-a586);
  a586=(a553*a014);
  a584=(a584-a586);
  a584=(a584-a014);
  a587=(a022*a555);
  a584=(a584-a587);
  a584=(a584+a070);
  a584=(a584+a582);
  a588=(a065*a575);
  a584=(a584+a588);
  a589=(a554*a014);
  a590=(a589*a008);
  a584=(a584-a590);
  a584=(a584+a076);
  a584=(a584+a077);
  a591=(a053*a584);
  a583=(a583+a591);
  a591=(a578/a583);
  a586=(a586-a074);
  a586=(a586-a075);
  a586=(a586+a587);
  a586=(a586-a588);
  a586=(a586+a590);
  a590=(a012*a586);
  a590=(a590-a063);
  a588=(a590/a583);
  a587=(a563-a577);
  a592=(a014*a555);
  a593=(a592-a568);
  a593=(a546*a593);
  a587=(a587+a593);
  a593=(a012*a587);
  a594=(a588*a578);
  a594=(a593-a594);
  a595=(a590*a588);
  a595=(a082-a595);
  a594=(a594/a595);
  a596=(a588*a594);
  a596=(a591-a596);
  a597=(a545*a596);
  a538=(a538+a597);
  a538=(a003+a538);
  a597=(a536*a538);
  a004=(a004+a597);
  a597=4.4710615727772587e-02;
  a597=(a597*a002);
  a598=2.2733101475165380e+00;
  a598=(a598*a002);
  a599=(a598*a084);
  a600=-1.0534495466737249e+01;
  a600=(a600*a002);
  a246=(a600*a246);
  a599=(a599+a246);
  a246=-2.0008720582248625e+00;
  a246=(a246*a002);
  a301=(a246*a301);
  a599=(a599+a301);
  a301=-1.7958931863118799e+01;
  a301=(a301*a002);
  a601=(a301*a358);
  a599=(a599+a601);
  a601=2.7948884529419960e+01;
  a601=(a601*a002);
  a602=(a601*a416);
  a599=(a599+a602);
  a602=-2.8589982771350235e+00;
  a602=(a602*a002);
  a603=(a602*a475);
  a599=(a599+a603);
  a603=-8.8728569335306293e+00;
  a603=(a603*a002);
  a604=(a603*a535);
  a599=(a599+a604);
  a604=1.2360567175794303e+01;
  a604=(a604*a002);
  a605=(a604*a596);
  a599=(a599+a605);
  a605=6.4339274601576357e-01;
  a605=(a605*a002);
  a002=casadi_sq(a538);
  a606=(a002*a008);
  a607=(a537*a003);
  a608=(a539*a088);
  a607=(a607+a608);
  a608=(a540*a249);
  a607=(a607+a608);
  a608=(a541*a085);
  a607=(a607+a608);
  a608=(a542*a304);
  a607=(a607+a608);
  a608=(a543*a361);
  a607=(a607+a608);
  a608=(a544*a419);
  a607=(a607+a608);
  a608=(a545*a478);
  a607=(a607+a608);
  a607=(a000+a607);
  a608=sin(a607);
  a606=(a606*a608);
  a609=(a606*a015);
  a610=cos(a607);
  a611=(a537*a026);
  a612=(a539*a209);
  a611=(a611+a612);
  a612=(a540*a264);
  a611=(a611+a612);
  a612=(a541*a321);
  a611=(a611+a612);
  a612=(a542*a379);
  a611=(a611+a612);
  a612=(a543*a438);
  a611=(a611+a612);
  a612=(a544*a498);
  a611=(a611+a612);
  a612=(a545*a559);
  a611=(a611+a612);
  a611=(a018+a611);
  a612=cos(a611);
  a613=(a610*a612);
  a614=sin(a611);
  a615=(a608*a614);
  a613=(a613+a615);
  a615=(a613*a022);
  a616=(a615*a008);
  a617=(2.*a538);
  a618=(a537*a081);
  a619=(a539*a244);
  a618=(a618+a619);
  a619=(a540*a299);
  a618=(a618+a619);
  a619=(a541*a356);
  a618=(a618+a619);
  a619=(a542*a414);
  a618=(a618+a619);
  a619=(a543*a473);
  a618=(a618+a619);
  a619=(a544*a533);
  a618=(a618+a619);
  a619=(a545*a594);
  a618=(a618+a619);
  a618=(a026+a618);
  a619=(a617*a618);
  a620=(a619-a002);
  a621=casadi_sq(a618);
  a620=(a620-a621);
  a621=(a616*a620);
  a611=(a611-a607);
  a611=(a611+a031);
  a607=cos(a611);
  a622=(a607*a022);
  a621=(a621-a622);
  a623=(a610*a022);
  a624=(a623*a538);
  a624=(a624*a538);
  a625=(a624*a008);
  a621=(a621-a625);
  a625=(a610*a036);
  a626=(a608*a038);
  a625=(a625+a626);
  a626=(a625*a022);
  a621=(a621-a626);
  a627=(a612*a022);
  a628=(a627*a618);
  a629=(a617-a618);
  a630=(a628*a629);
  a621=(a621+a630);
  a631=(a014*a618);
  a632=(a631*a614);
  a633=(a632*a629);
  a621=(a621-a633);
  a634=(a608*a612);
  a635=(a610*a614);
  a634=(a634-a635);
  a635=(a047*a634);
  a636=(a635*a620);
  a621=(a621+a636);
  a611=sin(a611);
  a636=(a014*a611);
  a621=(a621+a636);
  a637=(a012*a621);
  a637=(a609+a637);
  a637=(a637-a055);
  a638=(a608*a036);
  a639=(a610*a038);
  a638=(a638-a639);
  a639=(a638*a015);
  a637=(a637+a639);
  a640=(2.*a610);
  a641=(a640*a008);
  a642=(a011*a641);
  a642=(a059+a642);
  a642=(a642+a011);
  a642=(a642+a064);
  a643=(a065*a608);
  a644=(a610*a014);
  a645=(a644*a008);
  a643=(a643-a645);
  a645=(a612*a014);
  a643=(a643-a645);
  a643=(a643-a014);
  a646=(a022*a614);
  a643=(a643-a646);
  a643=(a643+a070);
  a643=(a643+a641);
  a647=(a065*a634);
  a643=(a643+a647);
  a648=(a613*a014);
  a649=(a648*a008);
  a643=(a643-a649);
  a643=(a643+a076);
  a643=(a643+a077);
  a650=(a053*a643);
  a642=(a642+a650);
  a650=(a637/a642);
  a645=(a645-a074);
  a645=(a645-a075);
  a645=(a645+a646);
  a645=(a645-a647);
  a645=(a645+a649);
  a649=(a012*a645);
  a649=(a649-a063);
  a647=(a649/a642);
  a646=(a622-a636);
  a651=(a014*a614);
  a652=(a651-a627);
  a652=(a002*a652);
  a646=(a646+a652);
  a652=(a012*a646);
  a653=(a647*a637);
  a653=(a652-a653);
  a654=(a649*a647);
  a654=(a082-a654);
  a653=(a653/a654);
  a655=(a647*a653);
  a655=(a650-a655);
  a656=(a605*a655);
  a599=(a599+a656);
  a599=(a003+a599);
  a656=(a597*a599);
  a004=(a004+a656);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a026);
  a656=(a005*a321);
  a004=(a004+a656);
  a656=(a302*a379);
  a004=(a004+a656);
  a656=(a359*a438);
  a004=(a004+a656);
  a656=(a417*a498);
  a004=(a004+a656);
  a656=(a476*a559);
  a004=(a004+a656);
  a656=(a536*a618);
  a004=(a004+a656);
  a656=(a598*a081);
  a657=(a600*a244);
  a656=(a656+a657);
  a657=(a246*a299);
  a656=(a656+a657);
  a657=(a301*a356);
  a656=(a656+a657);
  a657=(a601*a414);
  a656=(a656+a657);
  a657=(a602*a473);
  a656=(a656+a657);
  a657=(a603*a533);
  a656=(a656+a657);
  a657=(a604*a594);
  a656=(a656+a657);
  a657=(a605*a653);
  a656=(a656+a657);
  a656=(a026+a656);
  a657=(a597*a656);
  a004=(a004+a657);
  a004=(a018+a004);
  if (res[0]!=0) res[0][1]=a004;
  a084=(a001*a084);
  a358=(a005*a358);
  a084=(a084+a358);
  a416=(a302*a416);
  a084=(a084+a416);
  a475=(a359*a475);
  a084=(a084+a475);
  a535=(a417*a535);
  a084=(a084+a535);
  a596=(a476*a596);
  a084=(a084+a596);
  a655=(a536*a655);
  a084=(a084+a655);
  a655=casadi_sq(a599);
  a596=(a655*a008);
  a535=(a598*a003);
  a475=(a600*a088);
  a535=(a535+a475);
  a475=(a246*a249);
  a535=(a535+a475);
  a475=(a301*a085);
  a535=(a535+a475);
  a475=(a601*a304);
  a535=(a535+a475);
  a475=(a602*a361);
  a535=(a535+a475);
  a475=(a603*a419);
  a535=(a535+a475);
  a475=(a604*a478);
  a535=(a535+a475);
  a475=(a605*a538);
  a535=(a535+a475);
  a000=(a000+a535);
  a535=sin(a000);
  a596=(a596*a535);
  a475=(a596*a015);
  a416=cos(a000);
  a358=(a598*a026);
  a004=(a600*a209);
  a358=(a358+a004);
  a004=(a246*a264);
  a358=(a358+a004);
  a004=(a301*a321);
  a358=(a358+a004);
  a004=(a601*a379);
  a358=(a358+a004);
  a004=(a602*a438);
  a358=(a358+a004);
  a004=(a603*a498);
  a358=(a358+a004);
  a004=(a604*a559);
  a358=(a358+a004);
  a004=(a605*a618);
  a358=(a358+a004);
  a018=(a018+a358);
  a358=cos(a018);
  a004=(a416*a358);
  a657=sin(a018);
  a658=(a535*a657);
  a004=(a004+a658);
  a658=(a004*a022);
  a659=(a658*a008);
  a660=(2.*a599);
  a661=(a660*a656);
  a662=(a661-a655);
  a663=casadi_sq(a656);
  a662=(a662-a663);
  a663=(a659*a662);
  a018=(a018-a000);
  a018=(a018+a031);
  a031=cos(a018);
  a000=(a031*a022);
  a663=(a663-a000);
  a664=(a416*a022);
  a665=(a664*a599);
  a665=(a665*a599);
  a666=(a665*a008);
  a663=(a663-a666);
  a666=(a416*a036);
  a667=(a535*a038);
  a666=(a666+a667);
  a667=(a666*a022);
  a663=(a663-a667);
  a668=(a358*a022);
  a669=(a668*a656);
  a670=(a660-a656);
  a671=(a669*a670);
  a663=(a663+a671);
  a672=(a014*a656);
  a673=(a672*a657);
  a674=(a673*a670);
  a663=(a663-a674);
  a675=(a535*a358);
  a676=(a416*a657);
  a675=(a675-a676);
  a047=(a047*a675);
  a676=(a047*a662);
  a663=(a663+a676);
  a018=sin(a018);
  a676=(a014*a018);
  a663=(a663+a676);
  a677=(a012*a663);
  a677=(a475+a677);
  a677=(a677-a055);
  a678=(a535*a036);
  a679=(a416*a038);
  a678=(a678-a679);
  a679=(a678*a015);
  a677=(a677+a679);
  a680=(2.*a416);
  a681=(a680*a008);
  a682=(a011*a681);
  a059=(a059+a682);
  a059=(a059+a011);
  a059=(a059+a064);
  a064=(a065*a535);
  a682=(a416*a014);
  a683=(a682*a008);
  a064=(a064-a683);
  a683=(a358*a014);
  a064=(a064-a683);
  a064=(a064-a014);
  a684=(a022*a657);
  a064=(a064-a684);
  a064=(a064+a070);
  a064=(a064+a681);
  a065=(a065*a675);
  a064=(a064+a065);
  a070=(a004*a014);
  a685=(a070*a008);
  a064=(a064-a685);
  a064=(a064+a076);
  a064=(a064+a077);
  a077=(a053*a064);
  a059=(a059+a077);
  a077=(a677/a059);
  a683=(a683-a074);
  a683=(a683-a075);
  a683=(a683+a684);
  a683=(a683-a065);
  a683=(a683+a685);
  a685=(a012*a683);
  a685=(a685-a063);
  a063=(a685/a059);
  a065=(a000-a676);
  a684=(a014*a657);
  a075=(a684-a668);
  a075=(a655*a075);
  a065=(a065+a075);
  a075=(a012*a065);
  a074=(a063*a677);
  a074=(a075-a074);
  a686=(a685*a063);
  a082=(a082-a686);
  a074=(a074/a082);
  a686=(a063*a074);
  a686=(a077-a686);
  a686=(a597*a686);
  a084=(a084+a686);
  a084=(a003+a084);
  if (res[0]!=0) res[0][2]=a084;
  a084=(a001*a081);
  a686=(a005*a356);
  a084=(a084+a686);
  a686=(a302*a414);
  a084=(a084+a686);
  a686=(a359*a473);
  a084=(a084+a686);
  a686=(a417*a533);
  a084=(a084+a686);
  a686=(a476*a594);
  a084=(a084+a686);
  a686=(a536*a653);
  a084=(a084+a686);
  a686=(a597*a074);
  a084=(a084+a686);
  a084=(a026+a084);
  if (res[0]!=0) res[0][3]=a084;
  a084=arg[0]? arg[0][4] : 0;
  a686=arg[0]? arg[0][6] : 0;
  a687=(a001*a686);
  a688=(a017*a008);
  a689=(a007*a011);
  a690=(a025*a003);
  a691=(a014*a003);
  a691=(a691*a003);
  a690=(a690-a691);
  a692=(a008*a028);
  a693=(a023*a692);
  a693=(a693-a033);
  a033=(a022*a003);
  a033=(a033*a003);
  a694=(a688*a033);
  a693=(a693-a694);
  a693=(a693-a039);
  a693=(a693+a043);
  a693=(a693-a046);
  a693=(a693+a050);
  a050=(a014*a048);
  a692=(a050*a692);
  a693=(a693+a692);
  a693=(a012*a693);
  a016=(a016+a693);
  a016=(a016-a055);
  a016=(a016+a057);
  a057=(a016/a062);
  a016=(a071*a016);
  a080=(a080-a016);
  a080=(a080/a083);
  a016=(a071*a080);
  a057=(a057-a016);
  a016=(2.*a057);
  a693=(a016*a022);
  a690=(a690-a693);
  a690=(a012*a690);
  a689=(a689+a690);
  a688=(a688*a689);
  a689=(a037*a015);
  a688=(a688+a689);
  a689=(a022*a056);
  a690=(a032*a014);
  a689=(a689-a690);
  a692=(a020*a008);
  a046=(a691+a693);
  a044=(a044*a026);
  a043=(a080*a022);
  a044=(a044-a043);
  a043=(a014*a027);
  a044=(a044-a043);
  a046=(a046+a044);
  a692=(a692*a046);
  a689=(a689-a692);
  a046=(a022*a030);
  a689=(a689-a046);
  a043=(a008*a048);
  a080=(a080*a014);
  a027=(a022*a027);
  a080=(a080-a027);
  a027=(a016*a014);
  a080=(a080-a027);
  a039=(a022*a026);
  a039=(a039*a026);
  a080=(a080+a039);
  a039=(a080+a033);
  a043=(a043*a039);
  a689=(a689+a043);
  a689=(a012*a689);
  a688=(a688+a689);
  a689=(a008*a010);
  a016=(a016*a011);
  a039=4.;
  a694=(a039*a057);
  a694=(a694-a027);
  a694=(a694+a033);
  a694=(a012*a694);
  a016=(a016+a694);
  a689=(a689*a016);
  a688=(a688+a689);
  a689=(a688/a062);
  a016=(a057*a008);
  a050=(a023+a050);
  a016=(a016*a050);
  a690=(a690+a046);
  a016=(a016+a690);
  a016=(a012*a016);
  a688=(a071*a688);
  a016=(a016-a688);
  a016=(a016/a083);
  a688=(a071*a016);
  a689=(a689-a688);
  a688=(a689*a084);
  a693=(a693+a044);
  a693=(a019*a693);
  a692=(a692+a693);
  a692=(a692-a043);
  a080=(a021*a080);
  a692=(a692+a080);
  a692=(a692+a690);
  a692=(a012*a692);
  a080=(a692/a062);
  a043=(a057*a022);
  a691=(a691-a043);
  a691=(a019*a691);
  a043=(a057*a020);
  a043=(a043*a022);
  a043=(a043*a008);
  a691=(a691-a043);
  a057=(a057*a014);
  a043=(a057*a008);
  a043=(a043*a048);
  a691=(a691-a043);
  a057=(a057+a033);
  a057=(a021*a057);
  a691=(a691+a057);
  a691=(a691-a690);
  a691=(a012*a691);
  a692=(a071*a692);
  a691=(a691-a692);
  a691=(a691/a083);
  a692=(a071*a691);
  a080=(a080-a692);
  a692=arg[0]? arg[0][5] : 0;
  a690=(a080*a692);
  a688=(a688+a690);
  a690=(a025*a008);
  a690=(a690*a010);
  a057=(a014*a012);
  a057=(a054-a057);
  a690=(a690*a057);
  a041=(a053*a041);
  a690=(a690+a041);
  a045=(a053*a045);
  a690=(a690-a045);
  a045=(a026-a003);
  a045=(a053*a045);
  a041=(a024*a045);
  a690=(a690+a041);
  a045=(a049*a045);
  a690=(a690+a045);
  a025=(a025*a012);
  a034=(a034*a008);
  a034=(a025*a034);
  a690=(a690-a034);
  a034=(a690/a062);
  a040=(a040-a079);
  a025=(a025*a040);
  a690=(a071*a690);
  a025=(a025+a690);
  a025=(a025/a083);
  a690=(a071*a025);
  a034=(a034+a690);
  a690=(a034*a686);
  a079=(a003-a026);
  a079=(a053*a079);
  a024=(a024+a049);
  a024=(a024+a040);
  a079=(a079*a024);
  a024=(a079/a062);
  a079=(a071*a079);
  a079=(a079/a083);
  a040=(a071*a079);
  a024=(a024+a040);
  a040=arg[0]? arg[0][7] : 0;
  a049=(a024*a040);
  a690=(a690+a049);
  a688=(a688+a690);
  a690=(a006*a688);
  a049=(a201*a008);
  a045=(a196*a011);
  a041=(a208*a088);
  a033=(a014*a088);
  a033=(a033*a088);
  a041=(a041-a033);
  a043=(a008*a211);
  a693=(a206*a043);
  a693=(a693-a213);
  a213=(a022*a088);
  a213=(a213*a088);
  a044=(a049*a213);
  a693=(a693-a044);
  a693=(a693-a217);
  a693=(a693+a221);
  a693=(a693-a224);
  a693=(a693+a227);
  a227=(a014*a225);
  a043=(a227*a043);
  a693=(a693+a043);
  a693=(a012*a693);
  a200=(a200+a693);
  a200=(a200-a055);
  a200=(a200+a230);
  a230=(a200/a233);
  a200=(a238*a200);
  a243=(a243-a200);
  a243=(a243/a245);
  a200=(a238*a243);
  a230=(a230-a200);
  a200=(2.*a230);
  a693=(a200*a022);
  a041=(a041-a693);
  a041=(a012*a041);
  a045=(a045+a041);
  a049=(a049*a045);
  a045=(a216*a015);
  a049=(a049+a045);
  a045=(a022*a229);
  a041=(a198*a014);
  a045=(a045-a041);
  a043=(a204*a008);
  a224=(a033+a693);
  a222=(a222*a209);
  a221=(a243*a022);
  a222=(a222-a221);
  a221=(a014*a210);
  a222=(a222-a221);
  a224=(a224+a222);
  a043=(a043*a224);
  a045=(a045-a043);
  a224=(a022*a202);
  a045=(a045-a224);
  a221=(a008*a225);
  a243=(a243*a014);
  a210=(a022*a210);
  a243=(a243-a210);
  a210=(a200*a014);
  a243=(a243-a210);
  a217=(a022*a209);
  a217=(a217*a209);
  a243=(a243+a217);
  a217=(a243+a213);
  a221=(a221*a217);
  a045=(a045+a221);
  a045=(a012*a045);
  a049=(a049+a045);
  a045=(a008*a199);
  a200=(a200*a011);
  a217=(a039*a230);
  a217=(a217-a210);
  a217=(a217+a213);
  a217=(a012*a217);
  a200=(a200+a217);
  a045=(a045*a200);
  a049=(a049+a045);
  a045=(a049/a233);
  a200=(a230*a008);
  a227=(a206+a227);
  a200=(a200*a227);
  a041=(a041+a224);
  a200=(a200+a041);
  a200=(a012*a200);
  a049=(a238*a049);
  a200=(a200-a049);
  a200=(a200/a245);
  a049=(a238*a200);
  a045=(a045-a049);
  a049=(a087*a686);
  a224=(a090*a688);
  a227=(a100*a008);
  a217=(a095*a011);
  a210=(a107*a094);
  a044=(a014*a094);
  a044=(a044*a094);
  a210=(a210-a044);
  a046=(a008*a110);
  a050=(a105*a046);
  a050=(a050-a112);
  a112=(a022*a094);
  a112=(a112*a094);
  a694=(a227*a112);
  a050=(a050-a694);
  a050=(a050-a116);
  a050=(a050+a120);
  a050=(a050-a123);
  a050=(a050+a126);
  a126=(a014*a124);
  a046=(a126*a046);
  a050=(a050+a046);
  a050=(a012*a050);
  a099=(a099+a050);
  a099=(a099-a055);
  a099=(a099+a129);
  a129=(a099/a132);
  a099=(a137*a099);
  a142=(a142-a099);
  a142=(a142/a144);
  a099=(a137*a142);
  a129=(a129-a099);
  a099=(2.*a129);
  a050=(a099*a022);
  a210=(a210-a050);
  a210=(a012*a210);
  a217=(a217+a210);
  a227=(a227*a217);
  a217=(a115*a015);
  a227=(a227+a217);
  a217=(a022*a128);
  a210=(a097*a014);
  a217=(a217-a210);
  a046=(a103*a008);
  a123=(a044+a050);
  a121=(a121*a108);
  a120=(a142*a022);
  a121=(a121-a120);
  a120=(a014*a109);
  a121=(a121-a120);
  a123=(a123+a121);
  a046=(a046*a123);
  a217=(a217-a046);
  a123=(a022*a101);
  a217=(a217-a123);
  a120=(a008*a124);
  a142=(a142*a014);
  a109=(a022*a109);
  a142=(a142-a109);
  a109=(a099*a014);
  a142=(a142-a109);
  a116=(a022*a108);
  a116=(a116*a108);
  a142=(a142+a116);
  a116=(a142+a112);
  a120=(a120*a116);
  a217=(a217+a120);
  a217=(a012*a217);
  a227=(a227+a217);
  a217=(a008*a098);
  a099=(a099*a011);
  a116=(a039*a129);
  a116=(a116-a109);
  a116=(a116+a112);
  a116=(a012*a116);
  a099=(a099+a116);
  a217=(a217*a099);
  a227=(a227+a217);
  a217=(a227/a132);
  a099=(a129*a008);
  a126=(a105+a126);
  a099=(a099*a126);
  a210=(a210+a123);
  a099=(a099+a210);
  a099=(a012*a099);
  a227=(a137*a227);
  a099=(a099-a227);
  a099=(a099/a144);
  a227=(a137*a099);
  a217=(a217-a227);
  a227=(a093*a686);
  a227=(a084+a227);
  a123=(a217*a227);
  a050=(a050+a121);
  a050=(a102*a050);
  a046=(a046+a050);
  a046=(a046-a120);
  a142=(a104*a142);
  a046=(a046+a142);
  a046=(a046+a210);
  a046=(a012*a046);
  a142=(a046/a132);
  a120=(a129*a022);
  a044=(a044-a120);
  a044=(a102*a044);
  a120=(a129*a103);
  a120=(a120*a022);
  a120=(a120*a008);
  a044=(a044-a120);
  a129=(a129*a014);
  a120=(a129*a008);
  a120=(a120*a124);
  a044=(a044-a120);
  a129=(a129+a112);
  a129=(a104*a129);
  a044=(a044+a129);
  a044=(a044-a210);
  a044=(a012*a044);
  a046=(a137*a046);
  a044=(a044-a046);
  a044=(a044/a144);
  a046=(a137*a044);
  a142=(a142-a046);
  a046=(a093*a040);
  a046=(a692+a046);
  a210=(a142*a046);
  a123=(a123+a210);
  a210=(a107*a008);
  a210=(a210*a098);
  a210=(a210*a057);
  a118=(a053*a118);
  a210=(a210+a118);
  a122=(a053*a122);
  a210=(a210-a122);
  a122=(a108-a094);
  a122=(a053*a122);
  a118=(a106*a122);
  a210=(a210+a118);
  a122=(a125*a122);
  a210=(a210+a122);
  a107=(a107*a012);
  a113=(a113*a008);
  a113=(a107*a113);
  a210=(a210-a113);
  a113=(a210/a132);
  a117=(a117-a141);
  a107=(a107*a117);
  a210=(a137*a210);
  a107=(a107+a210);
  a107=(a107/a144);
  a210=(a137*a107);
  a113=(a113+a210);
  a210=(a093*a688);
  a210=(a686+a210);
  a141=(a113*a210);
  a122=(a094-a108);
  a122=(a053*a122);
  a106=(a106+a125);
  a106=(a106+a117);
  a122=(a122*a106);
  a106=(a122/a132);
  a122=(a137*a122);
  a122=(a122/a144);
  a117=(a137*a122);
  a106=(a106+a117);
  a117=(a016*a084);
  a125=(a691*a692);
  a117=(a117+a125);
  a125=(a025*a686);
  a118=(a079*a040);
  a125=(a125+a118);
  a117=(a117-a125);
  a125=(a093*a117);
  a125=(a040+a125);
  a118=(a106*a125);
  a141=(a141+a118);
  a123=(a123+a141);
  a123=(a092*a123);
  a224=(a224+a123);
  a224=(a686+a224);
  a123=(a089*a224);
  a049=(a049+a123);
  a049=(a084+a049);
  a123=(a045*a049);
  a693=(a693+a222);
  a693=(a203*a693);
  a043=(a043+a693);
  a043=(a043-a221);
  a243=(a205*a243);
  a043=(a043+a243);
  a043=(a043+a041);
  a043=(a012*a043);
  a243=(a043/a233);
  a221=(a230*a022);
  a033=(a033-a221);
  a033=(a203*a033);
  a221=(a230*a204);
  a221=(a221*a022);
  a221=(a221*a008);
  a033=(a033-a221);
  a230=(a230*a014);
  a221=(a230*a008);
  a221=(a221*a225);
  a033=(a033-a221);
  a230=(a230+a213);
  a230=(a205*a230);
  a033=(a033+a230);
  a033=(a033-a041);
  a033=(a012*a033);
  a043=(a238*a043);
  a033=(a033-a043);
  a033=(a033/a245);
  a043=(a238*a033);
  a243=(a243-a043);
  a043=(a087*a040);
  a041=(a090*a117);
  a227=(a099*a227);
  a046=(a044*a046);
  a227=(a227+a046);
  a046=(a107*a210);
  a230=(a122*a125);
  a046=(a046+a230);
  a227=(a227-a046);
  a227=(a092*a227);
  a041=(a041+a227);
  a041=(a040+a041);
  a227=(a089*a041);
  a043=(a043+a227);
  a043=(a692+a043);
  a227=(a243*a043);
  a123=(a123+a227);
  a227=(a208*a008);
  a227=(a227*a199);
  a227=(a227*a057);
  a219=(a053*a219);
  a227=(a227+a219);
  a223=(a053*a223);
  a227=(a227-a223);
  a223=(a209-a088);
  a223=(a053*a223);
  a219=(a207*a223);
  a227=(a227+a219);
  a223=(a226*a223);
  a227=(a227+a223);
  a208=(a208*a012);
  a214=(a214*a008);
  a214=(a208*a214);
  a227=(a227-a214);
  a214=(a227/a233);
  a218=(a218-a242);
  a208=(a208*a218);
  a227=(a238*a227);
  a208=(a208+a227);
  a208=(a208/a245);
  a227=(a238*a208);
  a214=(a214+a227);
  a227=(a087*a688);
  a242=(a150*a008);
  a223=(a145*a011);
  a219=(a157*a091);
  a046=(a014*a091);
  a046=(a046*a091);
  a219=(a219-a046);
  a230=(a008*a160);
  a213=(a155*a230);
  a213=(a213-a162);
  a162=(a022*a091);
  a162=(a162*a091);
  a221=(a242*a162);
  a213=(a213-a221);
  a213=(a213-a166);
  a213=(a213+a170);
  a213=(a213-a173);
  a213=(a213+a176);
  a176=(a014*a174);
  a230=(a176*a230);
  a213=(a213+a230);
  a213=(a012*a213);
  a149=(a149+a213);
  a149=(a149-a055);
  a149=(a149+a179);
  a179=(a149/a182);
  a149=(a187*a149);
  a192=(a192-a149);
  a192=(a192/a194);
  a149=(a187*a192);
  a179=(a179-a149);
  a149=(2.*a179);
  a213=(a149*a022);
  a219=(a219-a213);
  a219=(a012*a219);
  a223=(a223+a219);
  a242=(a242*a223);
  a223=(a165*a015);
  a242=(a242+a223);
  a223=(a022*a178);
  a219=(a147*a014);
  a223=(a223-a219);
  a230=(a153*a008);
  a173=(a046+a213);
  a171=(a171*a158);
  a170=(a192*a022);
  a171=(a171-a170);
  a170=(a014*a159);
  a171=(a171-a170);
  a173=(a173+a171);
  a230=(a230*a173);
  a223=(a223-a230);
  a173=(a022*a151);
  a223=(a223-a173);
  a170=(a008*a174);
  a192=(a192*a014);
  a159=(a022*a159);
  a192=(a192-a159);
  a159=(a149*a014);
  a192=(a192-a159);
  a166=(a022*a158);
  a166=(a166*a158);
  a192=(a192+a166);
  a166=(a192+a162);
  a170=(a170*a166);
  a223=(a223+a170);
  a223=(a012*a223);
  a242=(a242+a223);
  a223=(a008*a148);
  a149=(a149*a011);
  a166=(a039*a179);
  a166=(a166-a159);
  a166=(a166+a162);
  a166=(a012*a166);
  a149=(a149+a166);
  a223=(a223*a149);
  a242=(a242+a223);
  a223=(a242/a182);
  a149=(a179*a008);
  a176=(a155+a176);
  a149=(a149*a176);
  a219=(a219+a173);
  a149=(a149+a219);
  a149=(a012*a149);
  a242=(a187*a242);
  a149=(a149-a242);
  a149=(a149/a194);
  a242=(a187*a149);
  a223=(a223-a242);
  a242=(a090*a686);
  a210=(a092*a210);
  a242=(a242+a210);
  a242=(a084+a242);
  a210=(a223*a242);
  a213=(a213+a171);
  a213=(a152*a213);
  a230=(a230+a213);
  a230=(a230-a170);
  a192=(a154*a192);
  a230=(a230+a192);
  a230=(a230+a219);
  a230=(a012*a230);
  a192=(a230/a182);
  a170=(a179*a022);
  a046=(a046-a170);
  a046=(a152*a046);
  a170=(a179*a153);
  a170=(a170*a022);
  a170=(a170*a008);
  a046=(a046-a170);
  a179=(a179*a014);
  a170=(a179*a008);
  a170=(a170*a174);
  a046=(a046-a170);
  a179=(a179+a162);
  a179=(a154*a179);
  a046=(a046+a179);
  a046=(a046-a219);
  a046=(a012*a046);
  a230=(a187*a230);
  a046=(a046-a230);
  a046=(a046/a194);
  a230=(a187*a046);
  a192=(a192-a230);
  a230=(a090*a040);
  a125=(a092*a125);
  a230=(a230+a125);
  a230=(a692+a230);
  a125=(a192*a230);
  a210=(a210+a125);
  a125=(a157*a008);
  a125=(a125*a148);
  a125=(a125*a057);
  a168=(a053*a168);
  a125=(a125+a168);
  a172=(a053*a172);
  a125=(a125-a172);
  a172=(a158-a091);
  a172=(a053*a172);
  a168=(a156*a172);
  a125=(a125+a168);
  a172=(a175*a172);
  a125=(a125+a172);
  a157=(a157*a012);
  a163=(a163*a008);
  a163=(a157*a163);
  a125=(a125-a163);
  a163=(a125/a182);
  a167=(a167-a191);
  a157=(a157*a167);
  a125=(a187*a125);
  a157=(a157+a125);
  a157=(a157/a194);
  a125=(a187*a157);
  a163=(a163+a125);
  a125=(a163*a224);
  a191=(a091-a158);
  a191=(a053*a191);
  a156=(a156+a175);
  a156=(a156+a167);
  a191=(a191*a156);
  a156=(a191/a182);
  a191=(a187*a191);
  a191=(a191/a194);
  a167=(a187*a191);
  a156=(a156+a167);
  a167=(a156*a041);
  a125=(a125+a167);
  a210=(a210+a125);
  a125=(a089*a210);
  a227=(a227+a125);
  a227=(a686+a227);
  a125=(a214*a227);
  a167=(a088-a209);
  a167=(a053*a167);
  a207=(a207+a226);
  a207=(a207+a218);
  a167=(a167*a207);
  a207=(a167/a233);
  a167=(a238*a167);
  a167=(a167/a245);
  a218=(a238*a167);
  a207=(a207+a218);
  a218=(a087*a117);
  a242=(a149*a242);
  a230=(a046*a230);
  a242=(a242+a230);
  a230=(a157*a224);
  a226=(a191*a041);
  a230=(a230+a226);
  a242=(a242-a230);
  a230=(a089*a242);
  a218=(a218+a230);
  a218=(a040+a218);
  a230=(a207*a218);
  a125=(a125+a230);
  a123=(a123+a125);
  a125=(a086*a123);
  a690=(a690+a125);
  a125=(a256*a008);
  a230=(a251*a011);
  a226=(a263*a249);
  a175=(a014*a249);
  a175=(a175*a249);
  a226=(a226-a175);
  a172=(a008*a266);
  a168=(a261*a172);
  a168=(a168-a268);
  a268=(a022*a249);
  a268=(a268*a249);
  a219=(a125*a268);
  a168=(a168-a219);
  a168=(a168-a272);
  a168=(a168+a276);
  a168=(a168-a279);
  a168=(a168+a282);
  a282=(a014*a280);
  a172=(a282*a172);
  a168=(a168+a172);
  a168=(a012*a168);
  a255=(a255+a168);
  a255=(a255-a055);
  a255=(a255+a285);
  a285=(a255/a288);
  a255=(a293*a255);
  a298=(a298-a255);
  a298=(a298/a300);
  a255=(a293*a298);
  a285=(a285-a255);
  a255=(2.*a285);
  a168=(a255*a022);
  a226=(a226-a168);
  a226=(a012*a226);
  a230=(a230+a226);
  a125=(a125*a230);
  a230=(a271*a015);
  a125=(a125+a230);
  a230=(a022*a284);
  a226=(a253*a014);
  a230=(a230-a226);
  a172=(a259*a008);
  a279=(a175+a168);
  a277=(a277*a264);
  a276=(a298*a022);
  a277=(a277-a276);
  a276=(a014*a265);
  a277=(a277-a276);
  a279=(a279+a277);
  a172=(a172*a279);
  a230=(a230-a172);
  a279=(a022*a257);
  a230=(a230-a279);
  a276=(a008*a280);
  a298=(a298*a014);
  a265=(a022*a265);
  a298=(a298-a265);
  a265=(a255*a014);
  a298=(a298-a265);
  a272=(a022*a264);
  a272=(a272*a264);
  a298=(a298+a272);
  a272=(a298+a268);
  a276=(a276*a272);
  a230=(a230+a276);
  a230=(a012*a230);
  a125=(a125+a230);
  a230=(a008*a254);
  a255=(a255*a011);
  a272=(a039*a285);
  a272=(a272-a265);
  a272=(a272+a268);
  a272=(a012*a272);
  a255=(a255+a272);
  a230=(a230*a255);
  a125=(a125+a230);
  a230=(a125/a288);
  a255=(a285*a008);
  a282=(a261+a282);
  a255=(a255*a282);
  a226=(a226+a279);
  a255=(a255+a226);
  a255=(a012*a255);
  a125=(a293*a125);
  a255=(a255-a125);
  a255=(a255/a300);
  a125=(a293*a255);
  a230=(a230-a125);
  a125=(a248*a686);
  a224=(a250*a224);
  a125=(a125+a224);
  a224=(a195*a227);
  a125=(a125+a224);
  a125=(a084+a125);
  a224=(a230*a125);
  a168=(a168+a277);
  a168=(a258*a168);
  a172=(a172+a168);
  a172=(a172-a276);
  a298=(a260*a298);
  a172=(a172+a298);
  a172=(a172+a226);
  a172=(a012*a172);
  a298=(a172/a288);
  a276=(a285*a022);
  a175=(a175-a276);
  a175=(a258*a175);
  a276=(a285*a259);
  a276=(a276*a022);
  a276=(a276*a008);
  a175=(a175-a276);
  a285=(a285*a014);
  a276=(a285*a008);
  a276=(a276*a280);
  a175=(a175-a276);
  a285=(a285+a268);
  a285=(a260*a285);
  a175=(a175+a285);
  a175=(a175-a226);
  a175=(a012*a175);
  a172=(a293*a172);
  a175=(a175-a172);
  a175=(a175/a300);
  a172=(a293*a175);
  a298=(a298-a172);
  a172=(a248*a040);
  a041=(a250*a041);
  a172=(a172+a041);
  a041=(a195*a218);
  a172=(a172+a041);
  a172=(a692+a172);
  a041=(a298*a172);
  a224=(a224+a041);
  a041=(a263*a008);
  a041=(a041*a254);
  a041=(a041*a057);
  a274=(a053*a274);
  a041=(a041+a274);
  a278=(a053*a278);
  a041=(a041-a278);
  a278=(a264-a249);
  a278=(a053*a278);
  a274=(a262*a278);
  a041=(a041+a274);
  a278=(a281*a278);
  a041=(a041+a278);
  a263=(a263*a012);
  a269=(a269*a008);
  a269=(a263*a269);
  a041=(a041-a269);
  a269=(a041/a288);
  a273=(a273-a297);
  a263=(a263*a273);
  a041=(a293*a041);
  a263=(a263+a041);
  a263=(a263/a300);
  a041=(a293*a263);
  a269=(a269+a041);
  a041=(a248*a688);
  a210=(a250*a210);
  a041=(a041+a210);
  a210=(a195*a123);
  a041=(a041+a210);
  a041=(a686+a041);
  a210=(a269*a041);
  a297=(a249-a264);
  a297=(a053*a297);
  a262=(a262+a281);
  a262=(a262+a273);
  a297=(a297*a262);
  a262=(a297/a288);
  a297=(a293*a297);
  a297=(a297/a300);
  a273=(a293*a297);
  a262=(a262+a273);
  a273=(a248*a117);
  a242=(a250*a242);
  a273=(a273+a242);
  a049=(a200*a049);
  a043=(a033*a043);
  a049=(a049+a043);
  a043=(a208*a227);
  a242=(a167*a218);
  a043=(a043+a242);
  a049=(a049-a043);
  a043=(a195*a049);
  a273=(a273+a043);
  a273=(a040+a273);
  a043=(a262*a273);
  a210=(a210+a043);
  a224=(a224+a210);
  a210=(a247*a224);
  a690=(a690+a210);
  a690=(a686+a690);
  a210=(a005*a690);
  a687=(a687+a210);
  a210=(a303*a688);
  a043=(a305*a123);
  a210=(a210+a043);
  a043=(a306*a224);
  a210=(a210+a043);
  a043=(a313*a008);
  a242=(a308*a011);
  a281=(a320*a085);
  a278=(a014*a085);
  a278=(a278*a085);
  a281=(a281-a278);
  a274=(a008*a323);
  a226=(a318*a274);
  a226=(a226-a325);
  a325=(a022*a085);
  a325=(a325*a085);
  a285=(a043*a325);
  a226=(a226-a285);
  a226=(a226-a329);
  a226=(a226+a333);
  a226=(a226-a336);
  a226=(a226+a339);
  a339=(a014*a337);
  a274=(a339*a274);
  a226=(a226+a274);
  a226=(a012*a226);
  a312=(a312+a226);
  a312=(a312-a055);
  a312=(a312+a342);
  a342=(a312/a345);
  a312=(a350*a312);
  a355=(a355-a312);
  a355=(a355/a357);
  a312=(a350*a355);
  a342=(a342-a312);
  a312=(2.*a342);
  a226=(a312*a022);
  a281=(a281-a226);
  a281=(a012*a281);
  a242=(a242+a281);
  a043=(a043*a242);
  a242=(a328*a015);
  a043=(a043+a242);
  a242=(a022*a341);
  a281=(a310*a014);
  a242=(a242-a281);
  a274=(a316*a008);
  a336=(a278+a226);
  a334=(a334*a321);
  a333=(a355*a022);
  a334=(a334-a333);
  a333=(a014*a322);
  a334=(a334-a333);
  a336=(a336+a334);
  a274=(a274*a336);
  a242=(a242-a274);
  a336=(a022*a314);
  a242=(a242-a336);
  a333=(a008*a337);
  a355=(a355*a014);
  a322=(a022*a322);
  a355=(a355-a322);
  a322=(a312*a014);
  a355=(a355-a322);
  a329=(a022*a321);
  a329=(a329*a321);
  a355=(a355+a329);
  a329=(a355+a325);
  a333=(a333*a329);
  a242=(a242+a333);
  a242=(a012*a242);
  a043=(a043+a242);
  a242=(a008*a311);
  a312=(a312*a011);
  a329=(a039*a342);
  a329=(a329-a322);
  a329=(a329+a325);
  a329=(a012*a329);
  a312=(a312+a329);
  a242=(a242*a312);
  a043=(a043+a242);
  a242=(a043/a345);
  a312=(a342*a008);
  a339=(a318+a339);
  a312=(a312*a339);
  a281=(a281+a336);
  a312=(a312+a281);
  a312=(a012*a312);
  a043=(a350*a043);
  a312=(a312-a043);
  a312=(a312/a357);
  a043=(a350*a312);
  a242=(a242-a043);
  a043=(a006*a686);
  a336=(a086*a227);
  a043=(a043+a336);
  a336=(a247*a041);
  a043=(a043+a336);
  a043=(a084+a043);
  a336=(a242*a043);
  a226=(a226+a334);
  a226=(a315*a226);
  a274=(a274+a226);
  a274=(a274-a333);
  a355=(a317*a355);
  a274=(a274+a355);
  a274=(a274+a281);
  a274=(a012*a274);
  a355=(a274/a345);
  a333=(a342*a022);
  a278=(a278-a333);
  a278=(a315*a278);
  a333=(a342*a316);
  a333=(a333*a022);
  a333=(a333*a008);
  a278=(a278-a333);
  a342=(a342*a014);
  a333=(a342*a008);
  a333=(a333*a337);
  a278=(a278-a333);
  a342=(a342+a325);
  a342=(a317*a342);
  a278=(a278+a342);
  a278=(a278-a281);
  a278=(a012*a278);
  a274=(a350*a274);
  a278=(a278-a274);
  a278=(a278/a357);
  a274=(a350*a278);
  a355=(a355-a274);
  a274=(a006*a040);
  a281=(a086*a218);
  a274=(a274+a281);
  a281=(a247*a273);
  a274=(a274+a281);
  a274=(a692+a274);
  a281=(a355*a274);
  a336=(a336+a281);
  a281=(a320*a008);
  a281=(a281*a311);
  a281=(a281*a057);
  a331=(a053*a331);
  a281=(a281+a331);
  a335=(a053*a335);
  a281=(a281-a335);
  a335=(a321-a085);
  a335=(a053*a335);
  a331=(a319*a335);
  a281=(a281+a331);
  a335=(a338*a335);
  a281=(a281+a335);
  a320=(a320*a012);
  a326=(a326*a008);
  a326=(a320*a326);
  a281=(a281-a326);
  a326=(a281/a345);
  a330=(a330-a354);
  a320=(a320*a330);
  a281=(a350*a281);
  a320=(a320+a281);
  a320=(a320/a357);
  a281=(a350*a320);
  a326=(a326+a281);
  a281=(a326*a690);
  a354=(a085-a321);
  a354=(a053*a354);
  a319=(a319+a338);
  a319=(a319+a330);
  a354=(a354*a319);
  a319=(a354/a345);
  a354=(a350*a354);
  a354=(a354/a357);
  a330=(a350*a354);
  a319=(a319+a330);
  a330=(a006*a117);
  a338=(a086*a049);
  a330=(a330+a338);
  a125=(a255*a125);
  a172=(a175*a172);
  a125=(a125+a172);
  a172=(a263*a041);
  a338=(a297*a273);
  a172=(a172+a338);
  a125=(a125-a172);
  a172=(a247*a125);
  a330=(a330+a172);
  a330=(a040+a330);
  a172=(a319*a330);
  a281=(a281+a172);
  a336=(a336+a281);
  a281=(a307*a336);
  a210=(a210+a281);
  a210=(a686+a210);
  a281=(a302*a210);
  a687=(a687+a281);
  a281=(a360*a688);
  a172=(a362*a123);
  a281=(a281+a172);
  a172=(a363*a224);
  a281=(a281+a172);
  a172=(a364*a336);
  a281=(a281+a172);
  a172=(a371*a008);
  a338=(a366*a011);
  a335=(a378*a304);
  a331=(a014*a304);
  a331=(a331*a304);
  a335=(a335-a331);
  a342=(a008*a381);
  a325=(a376*a342);
  a325=(a325-a383);
  a383=(a022*a304);
  a383=(a383*a304);
  a333=(a172*a383);
  a325=(a325-a333);
  a325=(a325-a387);
  a325=(a325+a391);
  a325=(a325-a394);
  a325=(a325+a397);
  a397=(a014*a395);
  a342=(a397*a342);
  a325=(a325+a342);
  a325=(a012*a325);
  a370=(a370+a325);
  a370=(a370-a055);
  a370=(a370+a400);
  a400=(a370/a403);
  a370=(a408*a370);
  a413=(a413-a370);
  a413=(a413/a415);
  a370=(a408*a413);
  a400=(a400-a370);
  a370=(2.*a400);
  a325=(a370*a022);
  a335=(a335-a325);
  a335=(a012*a335);
  a338=(a338+a335);
  a172=(a172*a338);
  a338=(a386*a015);
  a172=(a172+a338);
  a338=(a022*a399);
  a335=(a368*a014);
  a338=(a338-a335);
  a342=(a374*a008);
  a394=(a331+a325);
  a392=(a392*a379);
  a391=(a413*a022);
  a392=(a392-a391);
  a391=(a014*a380);
  a392=(a392-a391);
  a394=(a394+a392);
  a342=(a342*a394);
  a338=(a338-a342);
  a394=(a022*a372);
  a338=(a338-a394);
  a391=(a008*a395);
  a413=(a413*a014);
  a380=(a022*a380);
  a413=(a413-a380);
  a380=(a370*a014);
  a413=(a413-a380);
  a387=(a022*a379);
  a387=(a387*a379);
  a413=(a413+a387);
  a387=(a413+a383);
  a391=(a391*a387);
  a338=(a338+a391);
  a338=(a012*a338);
  a172=(a172+a338);
  a338=(a008*a369);
  a370=(a370*a011);
  a387=(a039*a400);
  a387=(a387-a380);
  a387=(a387+a383);
  a387=(a012*a387);
  a370=(a370+a387);
  a338=(a338*a370);
  a172=(a172+a338);
  a338=(a172/a403);
  a370=(a400*a008);
  a397=(a376+a397);
  a370=(a370*a397);
  a335=(a335+a394);
  a370=(a370+a335);
  a370=(a012*a370);
  a172=(a408*a172);
  a370=(a370-a172);
  a370=(a370/a415);
  a172=(a408*a370);
  a338=(a338-a172);
  a172=(a303*a686);
  a394=(a305*a227);
  a172=(a172+a394);
  a394=(a306*a041);
  a172=(a172+a394);
  a394=(a307*a690);
  a172=(a172+a394);
  a172=(a084+a172);
  a394=(a338*a172);
  a325=(a325+a392);
  a325=(a373*a325);
  a342=(a342+a325);
  a342=(a342-a391);
  a413=(a375*a413);
  a342=(a342+a413);
  a342=(a342+a335);
  a342=(a012*a342);
  a413=(a342/a403);
  a391=(a400*a022);
  a331=(a331-a391);
  a331=(a373*a331);
  a391=(a400*a374);
  a391=(a391*a022);
  a391=(a391*a008);
  a331=(a331-a391);
  a400=(a400*a014);
  a391=(a400*a008);
  a391=(a391*a395);
  a331=(a331-a391);
  a400=(a400+a383);
  a400=(a375*a400);
  a331=(a331+a400);
  a331=(a331-a335);
  a331=(a012*a331);
  a342=(a408*a342);
  a331=(a331-a342);
  a331=(a331/a415);
  a342=(a408*a331);
  a413=(a413-a342);
  a342=(a303*a040);
  a335=(a305*a218);
  a342=(a342+a335);
  a335=(a306*a273);
  a342=(a342+a335);
  a335=(a307*a330);
  a342=(a342+a335);
  a342=(a692+a342);
  a335=(a413*a342);
  a394=(a394+a335);
  a335=(a378*a008);
  a335=(a335*a369);
  a335=(a335*a057);
  a389=(a053*a389);
  a335=(a335+a389);
  a393=(a053*a393);
  a335=(a335-a393);
  a393=(a379-a304);
  a393=(a053*a393);
  a389=(a377*a393);
  a335=(a335+a389);
  a393=(a396*a393);
  a335=(a335+a393);
  a378=(a378*a012);
  a384=(a384*a008);
  a384=(a378*a384);
  a335=(a335-a384);
  a384=(a335/a403);
  a388=(a388-a412);
  a378=(a378*a388);
  a335=(a408*a335);
  a378=(a378+a335);
  a378=(a378/a415);
  a335=(a408*a378);
  a384=(a384+a335);
  a335=(a384*a210);
  a412=(a304-a379);
  a412=(a053*a412);
  a377=(a377+a396);
  a377=(a377+a388);
  a412=(a412*a377);
  a377=(a412/a403);
  a412=(a408*a412);
  a412=(a412/a415);
  a388=(a408*a412);
  a377=(a377+a388);
  a388=(a303*a117);
  a396=(a305*a049);
  a388=(a388+a396);
  a396=(a306*a125);
  a388=(a388+a396);
  a043=(a312*a043);
  a274=(a278*a274);
  a043=(a043+a274);
  a274=(a320*a690);
  a396=(a354*a330);
  a274=(a274+a396);
  a043=(a043-a274);
  a274=(a307*a043);
  a388=(a388+a274);
  a388=(a040+a388);
  a274=(a377*a388);
  a335=(a335+a274);
  a394=(a394+a335);
  a335=(a365*a394);
  a281=(a281+a335);
  a281=(a686+a281);
  a335=(a359*a281);
  a687=(a687+a335);
  a335=(a418*a688);
  a274=(a420*a123);
  a335=(a335+a274);
  a274=(a421*a224);
  a335=(a335+a274);
  a274=(a422*a336);
  a335=(a335+a274);
  a274=(a423*a394);
  a335=(a335+a274);
  a274=(a430*a008);
  a396=(a425*a011);
  a393=(a437*a361);
  a389=(a014*a361);
  a389=(a389*a361);
  a393=(a393-a389);
  a400=(a008*a440);
  a383=(a435*a400);
  a383=(a383-a442);
  a442=(a022*a361);
  a442=(a442*a361);
  a391=(a274*a442);
  a383=(a383-a391);
  a383=(a383-a446);
  a383=(a383+a450);
  a383=(a383-a453);
  a383=(a383+a456);
  a456=(a014*a454);
  a400=(a456*a400);
  a383=(a383+a400);
  a383=(a012*a383);
  a429=(a429+a383);
  a429=(a429-a055);
  a429=(a429+a459);
  a459=(a429/a462);
  a429=(a467*a429);
  a472=(a472-a429);
  a472=(a472/a474);
  a429=(a467*a472);
  a459=(a459-a429);
  a429=(2.*a459);
  a383=(a429*a022);
  a393=(a393-a383);
  a393=(a012*a393);
  a396=(a396+a393);
  a274=(a274*a396);
  a396=(a445*a015);
  a274=(a274+a396);
  a396=(a022*a458);
  a393=(a427*a014);
  a396=(a396-a393);
  a400=(a433*a008);
  a453=(a389+a383);
  a451=(a451*a438);
  a450=(a472*a022);
  a451=(a451-a450);
  a450=(a014*a439);
  a451=(a451-a450);
  a453=(a453+a451);
  a400=(a400*a453);
  a396=(a396-a400);
  a453=(a022*a431);
  a396=(a396-a453);
  a450=(a008*a454);
  a472=(a472*a014);
  a439=(a022*a439);
  a472=(a472-a439);
  a439=(a429*a014);
  a472=(a472-a439);
  a446=(a022*a438);
  a446=(a446*a438);
  a472=(a472+a446);
  a446=(a472+a442);
  a450=(a450*a446);
  a396=(a396+a450);
  a396=(a012*a396);
  a274=(a274+a396);
  a396=(a008*a428);
  a429=(a429*a011);
  a446=(a039*a459);
  a446=(a446-a439);
  a446=(a446+a442);
  a446=(a012*a446);
  a429=(a429+a446);
  a396=(a396*a429);
  a274=(a274+a396);
  a396=(a274/a462);
  a429=(a459*a008);
  a456=(a435+a456);
  a429=(a429*a456);
  a393=(a393+a453);
  a429=(a429+a393);
  a429=(a012*a429);
  a274=(a467*a274);
  a429=(a429-a274);
  a429=(a429/a474);
  a274=(a467*a429);
  a396=(a396-a274);
  a274=(a360*a686);
  a453=(a362*a227);
  a274=(a274+a453);
  a453=(a363*a041);
  a274=(a274+a453);
  a453=(a364*a690);
  a274=(a274+a453);
  a453=(a365*a210);
  a274=(a274+a453);
  a274=(a084+a274);
  a453=(a396*a274);
  a383=(a383+a451);
  a383=(a432*a383);
  a400=(a400+a383);
  a400=(a400-a450);
  a472=(a434*a472);
  a400=(a400+a472);
  a400=(a400+a393);
  a400=(a012*a400);
  a472=(a400/a462);
  a450=(a459*a022);
  a389=(a389-a450);
  a389=(a432*a389);
  a450=(a459*a433);
  a450=(a450*a022);
  a450=(a450*a008);
  a389=(a389-a450);
  a459=(a459*a014);
  a450=(a459*a008);
  a450=(a450*a454);
  a389=(a389-a450);
  a459=(a459+a442);
  a459=(a434*a459);
  a389=(a389+a459);
  a389=(a389-a393);
  a389=(a012*a389);
  a400=(a467*a400);
  a389=(a389-a400);
  a389=(a389/a474);
  a400=(a467*a389);
  a472=(a472-a400);
  a400=(a360*a040);
  a393=(a362*a218);
  a400=(a400+a393);
  a393=(a363*a273);
  a400=(a400+a393);
  a393=(a364*a330);
  a400=(a400+a393);
  a393=(a365*a388);
  a400=(a400+a393);
  a400=(a692+a400);
  a393=(a472*a400);
  a453=(a453+a393);
  a393=(a437*a008);
  a393=(a393*a428);
  a393=(a393*a057);
  a448=(a053*a448);
  a393=(a393+a448);
  a452=(a053*a452);
  a393=(a393-a452);
  a452=(a438-a361);
  a452=(a053*a452);
  a448=(a436*a452);
  a393=(a393+a448);
  a452=(a455*a452);
  a393=(a393+a452);
  a437=(a437*a012);
  a443=(a443*a008);
  a443=(a437*a443);
  a393=(a393-a443);
  a443=(a393/a462);
  a447=(a447-a471);
  a437=(a437*a447);
  a393=(a467*a393);
  a437=(a437+a393);
  a437=(a437/a474);
  a393=(a467*a437);
  a443=(a443+a393);
  a393=(a443*a281);
  a471=(a361-a438);
  a471=(a053*a471);
  a436=(a436+a455);
  a436=(a436+a447);
  a471=(a471*a436);
  a436=(a471/a462);
  a471=(a467*a471);
  a471=(a471/a474);
  a447=(a467*a471);
  a436=(a436+a447);
  a447=(a360*a117);
  a455=(a362*a049);
  a447=(a447+a455);
  a455=(a363*a125);
  a447=(a447+a455);
  a455=(a364*a043);
  a447=(a447+a455);
  a172=(a370*a172);
  a342=(a331*a342);
  a172=(a172+a342);
  a342=(a378*a210);
  a455=(a412*a388);
  a342=(a342+a455);
  a172=(a172-a342);
  a342=(a365*a172);
  a447=(a447+a342);
  a447=(a040+a447);
  a342=(a436*a447);
  a393=(a393+a342);
  a453=(a453+a393);
  a393=(a424*a453);
  a335=(a335+a393);
  a335=(a686+a335);
  a393=(a417*a335);
  a687=(a687+a393);
  a393=(a477*a688);
  a342=(a479*a123);
  a393=(a393+a342);
  a342=(a480*a224);
  a393=(a393+a342);
  a342=(a481*a336);
  a393=(a393+a342);
  a342=(a482*a394);
  a393=(a393+a342);
  a342=(a483*a453);
  a393=(a393+a342);
  a342=(a490*a008);
  a455=(a485*a011);
  a452=(a497*a419);
  a448=(a014*a419);
  a448=(a448*a419);
  a452=(a452-a448);
  a459=(a008*a500);
  a442=(a495*a459);
  a442=(a442-a502);
  a502=(a022*a419);
  a502=(a502*a419);
  a450=(a342*a502);
  a442=(a442-a450);
  a442=(a442-a506);
  a442=(a442+a510);
  a442=(a442-a513);
  a442=(a442+a516);
  a516=(a014*a514);
  a459=(a516*a459);
  a442=(a442+a459);
  a442=(a012*a442);
  a489=(a489+a442);
  a489=(a489-a055);
  a489=(a489+a519);
  a519=(a489/a522);
  a489=(a527*a489);
  a532=(a532-a489);
  a532=(a532/a534);
  a489=(a527*a532);
  a519=(a519-a489);
  a489=(2.*a519);
  a442=(a489*a022);
  a452=(a452-a442);
  a452=(a012*a452);
  a455=(a455+a452);
  a342=(a342*a455);
  a455=(a505*a015);
  a342=(a342+a455);
  a455=(a022*a518);
  a452=(a487*a014);
  a455=(a455-a452);
  a459=(a493*a008);
  a513=(a448+a442);
  a511=(a511*a498);
  a510=(a532*a022);
  a511=(a511-a510);
  a510=(a014*a499);
  a511=(a511-a510);
  a513=(a513+a511);
  a459=(a459*a513);
  a455=(a455-a459);
  a513=(a022*a491);
  a455=(a455-a513);
  a510=(a008*a514);
  a532=(a532*a014);
  a499=(a022*a499);
  a532=(a532-a499);
  a499=(a489*a014);
  a532=(a532-a499);
  a506=(a022*a498);
  a506=(a506*a498);
  a532=(a532+a506);
  a506=(a532+a502);
  a510=(a510*a506);
  a455=(a455+a510);
  a455=(a012*a455);
  a342=(a342+a455);
  a455=(a008*a488);
  a489=(a489*a011);
  a506=(a039*a519);
  a506=(a506-a499);
  a506=(a506+a502);
  a506=(a012*a506);
  a489=(a489+a506);
  a455=(a455*a489);
  a342=(a342+a455);
  a455=(a342/a522);
  a489=(a519*a008);
  a516=(a495+a516);
  a489=(a489*a516);
  a452=(a452+a513);
  a489=(a489+a452);
  a489=(a012*a489);
  a342=(a527*a342);
  a489=(a489-a342);
  a489=(a489/a534);
  a342=(a527*a489);
  a455=(a455-a342);
  a342=(a418*a686);
  a513=(a420*a227);
  a342=(a342+a513);
  a513=(a421*a041);
  a342=(a342+a513);
  a513=(a422*a690);
  a342=(a342+a513);
  a513=(a423*a210);
  a342=(a342+a513);
  a513=(a424*a281);
  a342=(a342+a513);
  a342=(a084+a342);
  a513=(a455*a342);
  a442=(a442+a511);
  a442=(a492*a442);
  a459=(a459+a442);
  a459=(a459-a510);
  a532=(a494*a532);
  a459=(a459+a532);
  a459=(a459+a452);
  a459=(a012*a459);
  a532=(a459/a522);
  a510=(a519*a022);
  a448=(a448-a510);
  a448=(a492*a448);
  a510=(a519*a493);
  a510=(a510*a022);
  a510=(a510*a008);
  a448=(a448-a510);
  a519=(a519*a014);
  a510=(a519*a008);
  a510=(a510*a514);
  a448=(a448-a510);
  a519=(a519+a502);
  a519=(a494*a519);
  a448=(a448+a519);
  a448=(a448-a452);
  a448=(a012*a448);
  a459=(a527*a459);
  a448=(a448-a459);
  a448=(a448/a534);
  a459=(a527*a448);
  a532=(a532-a459);
  a459=(a418*a040);
  a452=(a420*a218);
  a459=(a459+a452);
  a452=(a421*a273);
  a459=(a459+a452);
  a452=(a422*a330);
  a459=(a459+a452);
  a452=(a423*a388);
  a459=(a459+a452);
  a452=(a424*a447);
  a459=(a459+a452);
  a459=(a692+a459);
  a452=(a532*a459);
  a513=(a513+a452);
  a452=(a497*a008);
  a452=(a452*a488);
  a452=(a452*a057);
  a508=(a053*a508);
  a452=(a452+a508);
  a512=(a053*a512);
  a452=(a452-a512);
  a512=(a498-a419);
  a512=(a053*a512);
  a508=(a496*a512);
  a452=(a452+a508);
  a512=(a515*a512);
  a452=(a452+a512);
  a497=(a497*a012);
  a503=(a503*a008);
  a503=(a497*a503);
  a452=(a452-a503);
  a503=(a452/a522);
  a507=(a507-a531);
  a497=(a497*a507);
  a452=(a527*a452);
  a497=(a497+a452);
  a497=(a497/a534);
  a452=(a527*a497);
  a503=(a503+a452);
  a452=(a503*a335);
  a531=(a419-a498);
  a531=(a053*a531);
  a496=(a496+a515);
  a496=(a496+a507);
  a531=(a531*a496);
  a496=(a531/a522);
  a531=(a527*a531);
  a531=(a531/a534);
  a507=(a527*a531);
  a496=(a496+a507);
  a507=(a418*a117);
  a515=(a420*a049);
  a507=(a507+a515);
  a515=(a421*a125);
  a507=(a507+a515);
  a515=(a422*a043);
  a507=(a507+a515);
  a515=(a423*a172);
  a507=(a507+a515);
  a274=(a429*a274);
  a400=(a389*a400);
  a274=(a274+a400);
  a400=(a437*a281);
  a515=(a471*a447);
  a400=(a400+a515);
  a274=(a274-a400);
  a400=(a424*a274);
  a507=(a507+a400);
  a507=(a040+a507);
  a400=(a496*a507);
  a452=(a452+a400);
  a513=(a513+a452);
  a452=(a484*a513);
  a393=(a393+a452);
  a393=(a686+a393);
  a452=(a476*a393);
  a687=(a687+a452);
  a452=(a537*a688);
  a400=(a539*a123);
  a452=(a452+a400);
  a400=(a540*a224);
  a452=(a452+a400);
  a400=(a541*a336);
  a452=(a452+a400);
  a400=(a542*a394);
  a452=(a452+a400);
  a400=(a543*a453);
  a452=(a452+a400);
  a400=(a544*a513);
  a452=(a452+a400);
  a400=(a551*a008);
  a515=(a546*a011);
  a512=(a558*a478);
  a508=(a014*a478);
  a508=(a508*a478);
  a512=(a512-a508);
  a519=(a008*a561);
  a502=(a556*a519);
  a502=(a502-a563);
  a563=(a022*a478);
  a563=(a563*a478);
  a510=(a400*a563);
  a502=(a502-a510);
  a502=(a502-a567);
  a502=(a502+a571);
  a502=(a502-a574);
  a502=(a502+a577);
  a577=(a014*a575);
  a519=(a577*a519);
  a502=(a502+a519);
  a502=(a012*a502);
  a550=(a550+a502);
  a550=(a550-a055);
  a550=(a550+a580);
  a580=(a550/a583);
  a550=(a588*a550);
  a593=(a593-a550);
  a593=(a593/a595);
  a550=(a588*a593);
  a580=(a580-a550);
  a550=(2.*a580);
  a502=(a550*a022);
  a512=(a512-a502);
  a512=(a012*a512);
  a515=(a515+a512);
  a400=(a400*a515);
  a515=(a566*a015);
  a400=(a400+a515);
  a515=(a022*a579);
  a512=(a548*a014);
  a515=(a515-a512);
  a519=(a554*a008);
  a574=(a508+a502);
  a572=(a572*a559);
  a571=(a593*a022);
  a572=(a572-a571);
  a571=(a014*a560);
  a572=(a572-a571);
  a574=(a574+a572);
  a519=(a519*a574);
  a515=(a515-a519);
  a574=(a022*a552);
  a515=(a515-a574);
  a571=(a008*a575);
  a593=(a593*a014);
  a560=(a022*a560);
  a593=(a593-a560);
  a560=(a550*a014);
  a593=(a593-a560);
  a567=(a022*a559);
  a567=(a567*a559);
  a593=(a593+a567);
  a567=(a593+a563);
  a571=(a571*a567);
  a515=(a515+a571);
  a515=(a012*a515);
  a400=(a400+a515);
  a515=(a008*a549);
  a550=(a550*a011);
  a567=(a039*a580);
  a567=(a567-a560);
  a567=(a567+a563);
  a567=(a012*a567);
  a550=(a550+a567);
  a515=(a515*a550);
  a400=(a400+a515);
  a515=(a400/a583);
  a550=(a580*a008);
  a577=(a556+a577);
  a550=(a550*a577);
  a512=(a512+a574);
  a550=(a550+a512);
  a550=(a012*a550);
  a400=(a588*a400);
  a550=(a550-a400);
  a550=(a550/a595);
  a400=(a588*a550);
  a515=(a515-a400);
  a400=(a477*a686);
  a574=(a479*a227);
  a400=(a400+a574);
  a574=(a480*a041);
  a400=(a400+a574);
  a574=(a481*a690);
  a400=(a400+a574);
  a574=(a482*a210);
  a400=(a400+a574);
  a574=(a483*a281);
  a400=(a400+a574);
  a574=(a484*a335);
  a400=(a400+a574);
  a400=(a084+a400);
  a574=(a515*a400);
  a502=(a502+a572);
  a502=(a553*a502);
  a519=(a519+a502);
  a519=(a519-a571);
  a593=(a555*a593);
  a519=(a519+a593);
  a519=(a519+a512);
  a519=(a012*a519);
  a593=(a519/a583);
  a571=(a580*a022);
  a508=(a508-a571);
  a508=(a553*a508);
  a571=(a580*a554);
  a571=(a571*a022);
  a571=(a571*a008);
  a508=(a508-a571);
  a580=(a580*a014);
  a571=(a580*a008);
  a571=(a571*a575);
  a508=(a508-a571);
  a580=(a580+a563);
  a580=(a555*a580);
  a508=(a508+a580);
  a508=(a508-a512);
  a508=(a012*a508);
  a519=(a588*a519);
  a508=(a508-a519);
  a508=(a508/a595);
  a519=(a588*a508);
  a593=(a593-a519);
  a519=(a477*a040);
  a512=(a479*a218);
  a519=(a519+a512);
  a512=(a480*a273);
  a519=(a519+a512);
  a512=(a481*a330);
  a519=(a519+a512);
  a512=(a482*a388);
  a519=(a519+a512);
  a512=(a483*a447);
  a519=(a519+a512);
  a512=(a484*a507);
  a519=(a519+a512);
  a519=(a692+a519);
  a512=(a593*a519);
  a574=(a574+a512);
  a512=(a558*a008);
  a512=(a512*a549);
  a512=(a512*a057);
  a569=(a053*a569);
  a512=(a512+a569);
  a573=(a053*a573);
  a512=(a512-a573);
  a573=(a559-a478);
  a573=(a053*a573);
  a569=(a557*a573);
  a512=(a512+a569);
  a573=(a576*a573);
  a512=(a512+a573);
  a558=(a558*a012);
  a564=(a564*a008);
  a564=(a558*a564);
  a512=(a512-a564);
  a564=(a512/a583);
  a568=(a568-a592);
  a558=(a558*a568);
  a512=(a588*a512);
  a558=(a558+a512);
  a558=(a558/a595);
  a512=(a588*a558);
  a564=(a564+a512);
  a512=(a564*a393);
  a592=(a478-a559);
  a592=(a053*a592);
  a557=(a557+a576);
  a557=(a557+a568);
  a592=(a592*a557);
  a557=(a592/a583);
  a592=(a588*a592);
  a592=(a592/a595);
  a568=(a588*a592);
  a557=(a557+a568);
  a568=(a477*a117);
  a576=(a479*a049);
  a568=(a568+a576);
  a576=(a480*a125);
  a568=(a568+a576);
  a576=(a481*a043);
  a568=(a568+a576);
  a576=(a482*a172);
  a568=(a568+a576);
  a576=(a483*a274);
  a568=(a568+a576);
  a342=(a489*a342);
  a459=(a448*a459);
  a342=(a342+a459);
  a459=(a497*a335);
  a576=(a531*a507);
  a459=(a459+a576);
  a342=(a342-a459);
  a459=(a484*a342);
  a568=(a568+a459);
  a568=(a040+a568);
  a459=(a557*a568);
  a512=(a512+a459);
  a574=(a574+a512);
  a512=(a545*a574);
  a452=(a452+a512);
  a452=(a686+a452);
  a512=(a536*a452);
  a687=(a687+a512);
  a512=(a598*a688);
  a123=(a600*a123);
  a512=(a512+a123);
  a224=(a246*a224);
  a512=(a512+a224);
  a224=(a301*a336);
  a512=(a512+a224);
  a224=(a601*a394);
  a512=(a512+a224);
  a224=(a602*a453);
  a512=(a512+a224);
  a224=(a603*a513);
  a512=(a512+a224);
  a224=(a604*a574);
  a512=(a512+a224);
  a224=(a610*a008);
  a123=(a002*a011);
  a459=(a617*a538);
  a576=(a014*a538);
  a576=(a576*a538);
  a459=(a459-a576);
  a573=(a008*a620);
  a569=(a615*a573);
  a569=(a569-a622);
  a622=(a022*a538);
  a622=(a622*a538);
  a580=(a224*a622);
  a569=(a569-a580);
  a569=(a569-a626);
  a569=(a569+a630);
  a569=(a569-a633);
  a569=(a569+a636);
  a636=(a014*a634);
  a573=(a636*a573);
  a569=(a569+a573);
  a569=(a012*a569);
  a609=(a609+a569);
  a609=(a609-a055);
  a609=(a609+a639);
  a639=(a609/a642);
  a609=(a647*a609);
  a652=(a652-a609);
  a652=(a652/a654);
  a609=(a647*a652);
  a639=(a639-a609);
  a609=(2.*a639);
  a569=(a609*a022);
  a459=(a459-a569);
  a459=(a012*a459);
  a123=(a123+a459);
  a224=(a224*a123);
  a123=(a625*a015);
  a224=(a224+a123);
  a123=(a022*a638);
  a459=(a607*a014);
  a123=(a123-a459);
  a573=(a613*a008);
  a633=(a576+a569);
  a631=(a631*a618);
  a630=(a652*a022);
  a631=(a631-a630);
  a630=(a014*a619);
  a631=(a631-a630);
  a633=(a633+a631);
  a573=(a573*a633);
  a123=(a123-a573);
  a633=(a022*a611);
  a123=(a123-a633);
  a630=(a008*a634);
  a652=(a652*a014);
  a619=(a022*a619);
  a652=(a652-a619);
  a619=(a609*a014);
  a652=(a652-a619);
  a626=(a022*a618);
  a626=(a626*a618);
  a652=(a652+a626);
  a626=(a652+a622);
  a630=(a630*a626);
  a123=(a123+a630);
  a123=(a012*a123);
  a224=(a224+a123);
  a123=(a008*a608);
  a609=(a609*a011);
  a626=(a039*a639);
  a626=(a626-a619);
  a626=(a626+a622);
  a626=(a012*a626);
  a609=(a609+a626);
  a123=(a123*a609);
  a224=(a224+a123);
  a123=(a224/a642);
  a609=(a639*a008);
  a636=(a615+a636);
  a609=(a609*a636);
  a459=(a459+a633);
  a609=(a609+a459);
  a609=(a012*a609);
  a224=(a647*a224);
  a609=(a609-a224);
  a609=(a609/a654);
  a224=(a647*a609);
  a123=(a123-a224);
  a224=(a537*a686);
  a633=(a539*a227);
  a224=(a224+a633);
  a633=(a540*a041);
  a224=(a224+a633);
  a633=(a541*a690);
  a224=(a224+a633);
  a633=(a542*a210);
  a224=(a224+a633);
  a633=(a543*a281);
  a224=(a224+a633);
  a633=(a544*a335);
  a224=(a224+a633);
  a633=(a545*a393);
  a224=(a224+a633);
  a224=(a084+a224);
  a633=(a123*a224);
  a569=(a569+a631);
  a569=(a612*a569);
  a573=(a573+a569);
  a573=(a573-a630);
  a652=(a614*a652);
  a573=(a573+a652);
  a573=(a573+a459);
  a573=(a012*a573);
  a652=(a573/a642);
  a630=(a639*a022);
  a576=(a576-a630);
  a576=(a612*a576);
  a630=(a639*a613);
  a630=(a630*a022);
  a630=(a630*a008);
  a576=(a576-a630);
  a639=(a639*a014);
  a630=(a639*a008);
  a630=(a630*a634);
  a576=(a576-a630);
  a639=(a639+a622);
  a639=(a614*a639);
  a576=(a576+a639);
  a576=(a576-a459);
  a576=(a012*a576);
  a573=(a647*a573);
  a576=(a576-a573);
  a576=(a576/a654);
  a573=(a647*a576);
  a652=(a652-a573);
  a573=(a537*a040);
  a459=(a539*a218);
  a573=(a573+a459);
  a459=(a540*a273);
  a573=(a573+a459);
  a459=(a541*a330);
  a573=(a573+a459);
  a459=(a542*a388);
  a573=(a573+a459);
  a459=(a543*a447);
  a573=(a573+a459);
  a459=(a544*a507);
  a573=(a573+a459);
  a459=(a545*a568);
  a573=(a573+a459);
  a573=(a692+a573);
  a459=(a652*a573);
  a633=(a633+a459);
  a459=(a617*a008);
  a459=(a459*a608);
  a459=(a459*a057);
  a628=(a053*a628);
  a459=(a459+a628);
  a632=(a053*a632);
  a459=(a459-a632);
  a632=(a618-a538);
  a632=(a053*a632);
  a628=(a616*a632);
  a459=(a459+a628);
  a632=(a635*a632);
  a459=(a459+a632);
  a617=(a617*a012);
  a623=(a623*a008);
  a623=(a617*a623);
  a459=(a459-a623);
  a623=(a459/a642);
  a627=(a627-a651);
  a617=(a617*a627);
  a459=(a647*a459);
  a617=(a617+a459);
  a617=(a617/a654);
  a459=(a647*a617);
  a623=(a623+a459);
  a459=(a623*a452);
  a651=(a538-a618);
  a651=(a053*a651);
  a616=(a616+a635);
  a616=(a616+a627);
  a651=(a651*a616);
  a616=(a651/a642);
  a651=(a647*a651);
  a651=(a651/a654);
  a627=(a647*a651);
  a616=(a616+a627);
  a627=(a537*a117);
  a635=(a539*a049);
  a627=(a627+a635);
  a635=(a540*a125);
  a627=(a627+a635);
  a635=(a541*a043);
  a627=(a627+a635);
  a635=(a542*a172);
  a627=(a627+a635);
  a635=(a543*a274);
  a627=(a627+a635);
  a635=(a544*a342);
  a627=(a627+a635);
  a400=(a550*a400);
  a519=(a508*a519);
  a400=(a400+a519);
  a519=(a558*a393);
  a635=(a592*a568);
  a519=(a519+a635);
  a400=(a400-a519);
  a519=(a545*a400);
  a627=(a627+a519);
  a627=(a040+a627);
  a519=(a616*a627);
  a459=(a459+a519);
  a633=(a633+a459);
  a459=(a605*a633);
  a512=(a512+a459);
  a512=(a686+a512);
  a459=(a597*a512);
  a687=(a687+a459);
  a687=(a084+a687);
  if (res[0]!=0) res[0][4]=a687;
  a687=(a001*a040);
  a459=(a005*a330);
  a687=(a687+a459);
  a459=(a302*a388);
  a687=(a687+a459);
  a459=(a359*a447);
  a687=(a687+a459);
  a459=(a417*a507);
  a687=(a687+a459);
  a459=(a476*a568);
  a687=(a687+a459);
  a459=(a536*a627);
  a687=(a687+a459);
  a459=(a598*a117);
  a049=(a600*a049);
  a459=(a459+a049);
  a125=(a246*a125);
  a459=(a459+a125);
  a125=(a301*a043);
  a459=(a459+a125);
  a125=(a601*a172);
  a459=(a459+a125);
  a125=(a602*a274);
  a459=(a459+a125);
  a125=(a603*a342);
  a459=(a459+a125);
  a125=(a604*a400);
  a459=(a459+a125);
  a224=(a609*a224);
  a573=(a576*a573);
  a224=(a224+a573);
  a573=(a617*a452);
  a125=(a651*a627);
  a573=(a573+a125);
  a224=(a224-a573);
  a573=(a605*a224);
  a459=(a459+a573);
  a459=(a040+a459);
  a573=(a597*a459);
  a687=(a687+a573);
  a687=(a692+a687);
  if (res[0]!=0) res[0][5]=a687;
  a688=(a001*a688);
  a336=(a005*a336);
  a688=(a688+a336);
  a394=(a302*a394);
  a688=(a688+a394);
  a453=(a359*a453);
  a688=(a688+a453);
  a513=(a417*a513);
  a688=(a688+a513);
  a574=(a476*a574);
  a688=(a688+a574);
  a633=(a536*a633);
  a688=(a688+a633);
  a633=(a416*a008);
  a574=(a655*a011);
  a513=(a660*a599);
  a453=(a014*a599);
  a453=(a453*a599);
  a513=(a513-a453);
  a394=(a008*a662);
  a336=(a658*a394);
  a336=(a336-a000);
  a000=(a022*a599);
  a000=(a000*a599);
  a687=(a633*a000);
  a336=(a336-a687);
  a336=(a336-a667);
  a336=(a336+a671);
  a336=(a336-a674);
  a336=(a336+a676);
  a676=(a014*a675);
  a394=(a676*a394);
  a336=(a336+a394);
  a336=(a012*a336);
  a475=(a475+a336);
  a475=(a475-a055);
  a475=(a475+a679);
  a679=(a475/a059);
  a475=(a063*a475);
  a075=(a075-a475);
  a075=(a075/a082);
  a475=(a063*a075);
  a679=(a679-a475);
  a475=(2.*a679);
  a055=(a475*a022);
  a513=(a513-a055);
  a513=(a012*a513);
  a574=(a574+a513);
  a633=(a633*a574);
  a574=(a666*a015);
  a633=(a633+a574);
  a574=(a022*a678);
  a513=(a031*a014);
  a574=(a574-a513);
  a336=(a004*a008);
  a394=(a453+a055);
  a672=(a672*a656);
  a674=(a075*a022);
  a672=(a672-a674);
  a674=(a014*a661);
  a672=(a672-a674);
  a394=(a394+a672);
  a336=(a336*a394);
  a574=(a574-a336);
  a394=(a022*a018);
  a574=(a574-a394);
  a674=(a008*a675);
  a075=(a075*a014);
  a661=(a022*a661);
  a075=(a075-a661);
  a661=(a475*a014);
  a075=(a075-a661);
  a671=(a022*a656);
  a671=(a671*a656);
  a075=(a075+a671);
  a671=(a075+a000);
  a674=(a674*a671);
  a574=(a574+a674);
  a574=(a012*a574);
  a633=(a633+a574);
  a574=(a008*a535);
  a475=(a475*a011);
  a039=(a039*a679);
  a039=(a039-a661);
  a039=(a039+a000);
  a039=(a012*a039);
  a475=(a475+a039);
  a574=(a574*a475);
  a633=(a633+a574);
  a574=(a633/a059);
  a475=(a679*a008);
  a676=(a658+a676);
  a475=(a475*a676);
  a513=(a513+a394);
  a475=(a475+a513);
  a475=(a012*a475);
  a633=(a063*a633);
  a475=(a475-a633);
  a475=(a475/a082);
  a633=(a063*a475);
  a574=(a574-a633);
  a633=(a598*a686);
  a227=(a600*a227);
  a633=(a633+a227);
  a041=(a246*a041);
  a633=(a633+a041);
  a690=(a301*a690);
  a633=(a633+a690);
  a210=(a601*a210);
  a633=(a633+a210);
  a281=(a602*a281);
  a633=(a633+a281);
  a335=(a603*a335);
  a633=(a633+a335);
  a393=(a604*a393);
  a633=(a633+a393);
  a452=(a605*a452);
  a633=(a633+a452);
  a084=(a084+a633);
  a633=(a574*a084);
  a055=(a055+a672);
  a055=(a358*a055);
  a336=(a336+a055);
  a336=(a336-a674);
  a075=(a657*a075);
  a336=(a336+a075);
  a336=(a336+a513);
  a336=(a012*a336);
  a075=(a336/a059);
  a674=(a679*a022);
  a453=(a453-a674);
  a453=(a358*a453);
  a674=(a679*a004);
  a674=(a674*a022);
  a674=(a674*a008);
  a453=(a453-a674);
  a679=(a679*a014);
  a674=(a679*a008);
  a674=(a674*a675);
  a453=(a453-a674);
  a679=(a679+a000);
  a679=(a657*a679);
  a453=(a453+a679);
  a453=(a453-a513);
  a453=(a012*a453);
  a336=(a063*a336);
  a453=(a453-a336);
  a453=(a453/a082);
  a336=(a063*a453);
  a075=(a075-a336);
  a336=(a598*a040);
  a218=(a600*a218);
  a336=(a336+a218);
  a273=(a246*a273);
  a336=(a336+a273);
  a330=(a301*a330);
  a336=(a336+a330);
  a388=(a601*a388);
  a336=(a336+a388);
  a447=(a602*a447);
  a336=(a336+a447);
  a507=(a603*a507);
  a336=(a336+a507);
  a568=(a604*a568);
  a336=(a336+a568);
  a627=(a605*a627);
  a336=(a336+a627);
  a692=(a692+a336);
  a336=(a075*a692);
  a633=(a633+a336);
  a336=(a660*a008);
  a336=(a336*a535);
  a336=(a336*a057);
  a669=(a053*a669);
  a336=(a336+a669);
  a673=(a053*a673);
  a336=(a336-a673);
  a673=(a656-a599);
  a673=(a053*a673);
  a669=(a659*a673);
  a336=(a336+a669);
  a673=(a047*a673);
  a336=(a336+a673);
  a660=(a660*a012);
  a664=(a664*a008);
  a664=(a660*a664);
  a336=(a336-a664);
  a664=(a336/a059);
  a668=(a668-a684);
  a660=(a660*a668);
  a336=(a063*a336);
  a660=(a660+a336);
  a660=(a660/a082);
  a336=(a063*a660);
  a664=(a664+a336);
  a336=(a664*a512);
  a684=(a599-a656);
  a684=(a053*a684);
  a659=(a659+a047);
  a659=(a659+a668);
  a684=(a684*a659);
  a659=(a684/a059);
  a684=(a063*a684);
  a684=(a684/a082);
  a668=(a063*a684);
  a659=(a659+a668);
  a668=(a659*a459);
  a336=(a336+a668);
  a633=(a633+a336);
  a633=(a597*a633);
  a688=(a688+a633);
  a686=(a686+a688);
  if (res[0]!=0) res[0][6]=a686;
  a117=(a001*a117);
  a043=(a005*a043);
  a117=(a117+a043);
  a172=(a302*a172);
  a117=(a117+a172);
  a274=(a359*a274);
  a117=(a117+a274);
  a342=(a417*a342);
  a117=(a117+a342);
  a400=(a476*a400);
  a117=(a117+a400);
  a224=(a536*a224);
  a117=(a117+a224);
  a084=(a475*a084);
  a692=(a453*a692);
  a084=(a084+a692);
  a512=(a660*a512);
  a459=(a684*a459);
  a512=(a512+a459);
  a084=(a084-a512);
  a084=(a597*a084);
  a117=(a117+a084);
  a040=(a040+a117);
  if (res[0]!=0) res[0][7]=a040;
  a040=arg[0]? arg[0][8] : 0;
  a117=arg[0]? arg[0][10] : 0;
  a084=(a001*a117);
  a512=(a689*a040);
  a459=arg[0]? arg[0][9] : 0;
  a692=(a080*a459);
  a512=(a512+a692);
  a692=(a034*a117);
  a224=arg[0]? arg[0][11] : 0;
  a400=(a024*a224);
  a692=(a692+a400);
  a512=(a512+a692);
  a692=(a006*a512);
  a400=(a087*a117);
  a342=(a090*a512);
  a274=(a093*a117);
  a274=(a040+a274);
  a172=(a217*a274);
  a043=(a093*a224);
  a043=(a459+a043);
  a686=(a142*a043);
  a172=(a172+a686);
  a686=(a093*a512);
  a686=(a117+a686);
  a688=(a113*a686);
  a633=(a016*a040);
  a336=(a691*a459);
  a633=(a633+a336);
  a336=(a025*a117);
  a668=(a079*a224);
  a336=(a336+a668);
  a633=(a633-a336);
  a336=(a093*a633);
  a336=(a224+a336);
  a668=(a106*a336);
  a688=(a688+a668);
  a172=(a172+a688);
  a172=(a092*a172);
  a342=(a342+a172);
  a342=(a117+a342);
  a172=(a089*a342);
  a400=(a400+a172);
  a400=(a040+a400);
  a172=(a045*a400);
  a688=(a087*a224);
  a668=(a090*a633);
  a274=(a099*a274);
  a043=(a044*a043);
  a274=(a274+a043);
  a043=(a107*a686);
  a047=(a122*a336);
  a043=(a043+a047);
  a274=(a274-a043);
  a274=(a092*a274);
  a668=(a668+a274);
  a668=(a224+a668);
  a274=(a089*a668);
  a688=(a688+a274);
  a688=(a459+a688);
  a274=(a243*a688);
  a172=(a172+a274);
  a274=(a087*a512);
  a043=(a090*a117);
  a686=(a092*a686);
  a043=(a043+a686);
  a043=(a040+a043);
  a686=(a223*a043);
  a047=(a090*a224);
  a336=(a092*a336);
  a047=(a047+a336);
  a047=(a459+a047);
  a336=(a192*a047);
  a686=(a686+a336);
  a336=(a163*a342);
  a673=(a156*a668);
  a336=(a336+a673);
  a686=(a686+a336);
  a336=(a089*a686);
  a274=(a274+a336);
  a274=(a117+a274);
  a336=(a214*a274);
  a673=(a087*a633);
  a043=(a149*a043);
  a047=(a046*a047);
  a043=(a043+a047);
  a047=(a157*a342);
  a669=(a191*a668);
  a047=(a047+a669);
  a043=(a043-a047);
  a047=(a089*a043);
  a673=(a673+a047);
  a673=(a224+a673);
  a047=(a207*a673);
  a336=(a336+a047);
  a172=(a172+a336);
  a336=(a086*a172);
  a692=(a692+a336);
  a336=(a248*a117);
  a342=(a250*a342);
  a336=(a336+a342);
  a342=(a195*a274);
  a336=(a336+a342);
  a336=(a040+a336);
  a342=(a230*a336);
  a047=(a248*a224);
  a668=(a250*a668);
  a047=(a047+a668);
  a668=(a195*a673);
  a047=(a047+a668);
  a047=(a459+a047);
  a668=(a298*a047);
  a342=(a342+a668);
  a668=(a248*a512);
  a686=(a250*a686);
  a668=(a668+a686);
  a686=(a195*a172);
  a668=(a668+a686);
  a668=(a117+a668);
  a686=(a269*a668);
  a669=(a248*a633);
  a043=(a250*a043);
  a669=(a669+a043);
  a400=(a200*a400);
  a688=(a033*a688);
  a400=(a400+a688);
  a688=(a208*a274);
  a043=(a167*a673);
  a688=(a688+a043);
  a400=(a400-a688);
  a688=(a195*a400);
  a669=(a669+a688);
  a669=(a224+a669);
  a688=(a262*a669);
  a686=(a686+a688);
  a342=(a342+a686);
  a686=(a247*a342);
  a692=(a692+a686);
  a692=(a117+a692);
  a686=(a005*a692);
  a084=(a084+a686);
  a686=(a303*a512);
  a688=(a305*a172);
  a686=(a686+a688);
  a688=(a306*a342);
  a686=(a686+a688);
  a688=(a006*a117);
  a043=(a086*a274);
  a688=(a688+a043);
  a043=(a247*a668);
  a688=(a688+a043);
  a688=(a040+a688);
  a043=(a242*a688);
  a057=(a006*a224);
  a627=(a086*a673);
  a057=(a057+a627);
  a627=(a247*a669);
  a057=(a057+a627);
  a057=(a459+a057);
  a627=(a355*a057);
  a043=(a043+a627);
  a627=(a326*a692);
  a568=(a006*a633);
  a507=(a086*a400);
  a568=(a568+a507);
  a336=(a255*a336);
  a047=(a175*a047);
  a336=(a336+a047);
  a047=(a263*a668);
  a507=(a297*a669);
  a047=(a047+a507);
  a336=(a336-a047);
  a047=(a247*a336);
  a568=(a568+a047);
  a568=(a224+a568);
  a047=(a319*a568);
  a627=(a627+a047);
  a043=(a043+a627);
  a627=(a307*a043);
  a686=(a686+a627);
  a686=(a117+a686);
  a627=(a302*a686);
  a084=(a084+a627);
  a627=(a360*a512);
  a047=(a362*a172);
  a627=(a627+a047);
  a047=(a363*a342);
  a627=(a627+a047);
  a047=(a364*a043);
  a627=(a627+a047);
  a047=(a303*a117);
  a507=(a305*a274);
  a047=(a047+a507);
  a507=(a306*a668);
  a047=(a047+a507);
  a507=(a307*a692);
  a047=(a047+a507);
  a047=(a040+a047);
  a507=(a338*a047);
  a447=(a303*a224);
  a388=(a305*a673);
  a447=(a447+a388);
  a388=(a306*a669);
  a447=(a447+a388);
  a388=(a307*a568);
  a447=(a447+a388);
  a447=(a459+a447);
  a388=(a413*a447);
  a507=(a507+a388);
  a388=(a384*a686);
  a330=(a303*a633);
  a273=(a305*a400);
  a330=(a330+a273);
  a273=(a306*a336);
  a330=(a330+a273);
  a688=(a312*a688);
  a057=(a278*a057);
  a688=(a688+a057);
  a057=(a320*a692);
  a273=(a354*a568);
  a057=(a057+a273);
  a688=(a688-a057);
  a057=(a307*a688);
  a330=(a330+a057);
  a330=(a224+a330);
  a057=(a377*a330);
  a388=(a388+a057);
  a507=(a507+a388);
  a388=(a365*a507);
  a627=(a627+a388);
  a627=(a117+a627);
  a388=(a359*a627);
  a084=(a084+a388);
  a388=(a418*a512);
  a057=(a420*a172);
  a388=(a388+a057);
  a057=(a421*a342);
  a388=(a388+a057);
  a057=(a422*a043);
  a388=(a388+a057);
  a057=(a423*a507);
  a388=(a388+a057);
  a057=(a360*a117);
  a273=(a362*a274);
  a057=(a057+a273);
  a273=(a363*a668);
  a057=(a057+a273);
  a273=(a364*a692);
  a057=(a057+a273);
  a273=(a365*a686);
  a057=(a057+a273);
  a057=(a040+a057);
  a273=(a396*a057);
  a218=(a360*a224);
  a513=(a362*a673);
  a218=(a218+a513);
  a513=(a363*a669);
  a218=(a218+a513);
  a513=(a364*a568);
  a218=(a218+a513);
  a513=(a365*a330);
  a218=(a218+a513);
  a218=(a459+a218);
  a513=(a472*a218);
  a273=(a273+a513);
  a513=(a443*a627);
  a679=(a360*a633);
  a000=(a362*a400);
  a679=(a679+a000);
  a000=(a363*a336);
  a679=(a679+a000);
  a000=(a364*a688);
  a679=(a679+a000);
  a047=(a370*a047);
  a447=(a331*a447);
  a047=(a047+a447);
  a447=(a378*a686);
  a000=(a412*a330);
  a447=(a447+a000);
  a047=(a047-a447);
  a447=(a365*a047);
  a679=(a679+a447);
  a679=(a224+a679);
  a447=(a436*a679);
  a513=(a513+a447);
  a273=(a273+a513);
  a513=(a424*a273);
  a388=(a388+a513);
  a388=(a117+a388);
  a513=(a417*a388);
  a084=(a084+a513);
  a513=(a477*a512);
  a447=(a479*a172);
  a513=(a513+a447);
  a447=(a480*a342);
  a513=(a513+a447);
  a447=(a481*a043);
  a513=(a513+a447);
  a447=(a482*a507);
  a513=(a513+a447);
  a447=(a483*a273);
  a513=(a513+a447);
  a447=(a418*a117);
  a000=(a420*a274);
  a447=(a447+a000);
  a000=(a421*a668);
  a447=(a447+a000);
  a000=(a422*a692);
  a447=(a447+a000);
  a000=(a423*a686);
  a447=(a447+a000);
  a000=(a424*a627);
  a447=(a447+a000);
  a447=(a040+a447);
  a000=(a455*a447);
  a674=(a418*a224);
  a055=(a420*a673);
  a674=(a674+a055);
  a055=(a421*a669);
  a674=(a674+a055);
  a055=(a422*a568);
  a674=(a674+a055);
  a055=(a423*a330);
  a674=(a674+a055);
  a055=(a424*a679);
  a674=(a674+a055);
  a674=(a459+a674);
  a055=(a532*a674);
  a000=(a000+a055);
  a055=(a503*a388);
  a672=(a418*a633);
  a452=(a420*a400);
  a672=(a672+a452);
  a452=(a421*a336);
  a672=(a672+a452);
  a452=(a422*a688);
  a672=(a672+a452);
  a452=(a423*a047);
  a672=(a672+a452);
  a057=(a429*a057);
  a218=(a389*a218);
  a057=(a057+a218);
  a218=(a437*a627);
  a452=(a471*a679);
  a218=(a218+a452);
  a057=(a057-a218);
  a218=(a424*a057);
  a672=(a672+a218);
  a672=(a224+a672);
  a218=(a496*a672);
  a055=(a055+a218);
  a000=(a000+a055);
  a055=(a484*a000);
  a513=(a513+a055);
  a513=(a117+a513);
  a055=(a476*a513);
  a084=(a084+a055);
  a055=(a537*a512);
  a218=(a539*a172);
  a055=(a055+a218);
  a218=(a540*a342);
  a055=(a055+a218);
  a218=(a541*a043);
  a055=(a055+a218);
  a218=(a542*a507);
  a055=(a055+a218);
  a218=(a543*a273);
  a055=(a055+a218);
  a218=(a544*a000);
  a055=(a055+a218);
  a218=(a477*a117);
  a452=(a479*a274);
  a218=(a218+a452);
  a452=(a480*a668);
  a218=(a218+a452);
  a452=(a481*a692);
  a218=(a218+a452);
  a452=(a482*a686);
  a218=(a218+a452);
  a452=(a483*a627);
  a218=(a218+a452);
  a452=(a484*a388);
  a218=(a218+a452);
  a218=(a040+a218);
  a452=(a515*a218);
  a393=(a477*a224);
  a335=(a479*a673);
  a393=(a393+a335);
  a335=(a480*a669);
  a393=(a393+a335);
  a335=(a481*a568);
  a393=(a393+a335);
  a335=(a482*a330);
  a393=(a393+a335);
  a335=(a483*a679);
  a393=(a393+a335);
  a335=(a484*a672);
  a393=(a393+a335);
  a393=(a459+a393);
  a335=(a593*a393);
  a452=(a452+a335);
  a335=(a564*a513);
  a281=(a477*a633);
  a210=(a479*a400);
  a281=(a281+a210);
  a210=(a480*a336);
  a281=(a281+a210);
  a210=(a481*a688);
  a281=(a281+a210);
  a210=(a482*a047);
  a281=(a281+a210);
  a210=(a483*a057);
  a281=(a281+a210);
  a447=(a489*a447);
  a674=(a448*a674);
  a447=(a447+a674);
  a674=(a497*a388);
  a210=(a531*a672);
  a674=(a674+a210);
  a447=(a447-a674);
  a674=(a484*a447);
  a281=(a281+a674);
  a281=(a224+a281);
  a674=(a557*a281);
  a335=(a335+a674);
  a452=(a452+a335);
  a335=(a545*a452);
  a055=(a055+a335);
  a055=(a117+a055);
  a335=(a536*a055);
  a084=(a084+a335);
  a335=(a598*a512);
  a172=(a600*a172);
  a335=(a335+a172);
  a342=(a246*a342);
  a335=(a335+a342);
  a342=(a301*a043);
  a335=(a335+a342);
  a342=(a601*a507);
  a335=(a335+a342);
  a342=(a602*a273);
  a335=(a335+a342);
  a342=(a603*a000);
  a335=(a335+a342);
  a342=(a604*a452);
  a335=(a335+a342);
  a342=(a537*a117);
  a172=(a539*a274);
  a342=(a342+a172);
  a172=(a540*a668);
  a342=(a342+a172);
  a172=(a541*a692);
  a342=(a342+a172);
  a172=(a542*a686);
  a342=(a342+a172);
  a172=(a543*a627);
  a342=(a342+a172);
  a172=(a544*a388);
  a342=(a342+a172);
  a172=(a545*a513);
  a342=(a342+a172);
  a342=(a040+a342);
  a172=(a123*a342);
  a674=(a537*a224);
  a210=(a539*a673);
  a674=(a674+a210);
  a210=(a540*a669);
  a674=(a674+a210);
  a210=(a541*a568);
  a674=(a674+a210);
  a210=(a542*a330);
  a674=(a674+a210);
  a210=(a543*a679);
  a674=(a674+a210);
  a210=(a544*a672);
  a674=(a674+a210);
  a210=(a545*a281);
  a674=(a674+a210);
  a674=(a459+a674);
  a210=(a652*a674);
  a172=(a172+a210);
  a210=(a623*a055);
  a690=(a537*a633);
  a041=(a539*a400);
  a690=(a690+a041);
  a041=(a540*a336);
  a690=(a690+a041);
  a041=(a541*a688);
  a690=(a690+a041);
  a041=(a542*a047);
  a690=(a690+a041);
  a041=(a543*a057);
  a690=(a690+a041);
  a041=(a544*a447);
  a690=(a690+a041);
  a218=(a550*a218);
  a393=(a508*a393);
  a218=(a218+a393);
  a393=(a558*a513);
  a041=(a592*a281);
  a393=(a393+a041);
  a218=(a218-a393);
  a393=(a545*a218);
  a690=(a690+a393);
  a690=(a224+a690);
  a393=(a616*a690);
  a210=(a210+a393);
  a172=(a172+a210);
  a210=(a605*a172);
  a335=(a335+a210);
  a335=(a117+a335);
  a210=(a597*a335);
  a084=(a084+a210);
  a084=(a040+a084);
  if (res[0]!=0) res[0][8]=a084;
  a084=(a001*a224);
  a210=(a005*a568);
  a084=(a084+a210);
  a210=(a302*a330);
  a084=(a084+a210);
  a210=(a359*a679);
  a084=(a084+a210);
  a210=(a417*a672);
  a084=(a084+a210);
  a210=(a476*a281);
  a084=(a084+a210);
  a210=(a536*a690);
  a084=(a084+a210);
  a210=(a598*a633);
  a400=(a600*a400);
  a210=(a210+a400);
  a336=(a246*a336);
  a210=(a210+a336);
  a336=(a301*a688);
  a210=(a210+a336);
  a336=(a601*a047);
  a210=(a210+a336);
  a336=(a602*a057);
  a210=(a210+a336);
  a336=(a603*a447);
  a210=(a210+a336);
  a336=(a604*a218);
  a210=(a210+a336);
  a342=(a609*a342);
  a674=(a576*a674);
  a342=(a342+a674);
  a674=(a617*a055);
  a336=(a651*a690);
  a674=(a674+a336);
  a342=(a342-a674);
  a674=(a605*a342);
  a210=(a210+a674);
  a210=(a224+a210);
  a674=(a597*a210);
  a084=(a084+a674);
  a084=(a459+a084);
  if (res[0]!=0) res[0][9]=a084;
  a512=(a001*a512);
  a043=(a005*a043);
  a512=(a512+a043);
  a507=(a302*a507);
  a512=(a512+a507);
  a273=(a359*a273);
  a512=(a512+a273);
  a000=(a417*a000);
  a512=(a512+a000);
  a452=(a476*a452);
  a512=(a512+a452);
  a172=(a536*a172);
  a512=(a512+a172);
  a172=(a598*a117);
  a274=(a600*a274);
  a172=(a172+a274);
  a668=(a246*a668);
  a172=(a172+a668);
  a692=(a301*a692);
  a172=(a172+a692);
  a686=(a601*a686);
  a172=(a172+a686);
  a627=(a602*a627);
  a172=(a172+a627);
  a388=(a603*a388);
  a172=(a172+a388);
  a513=(a604*a513);
  a172=(a172+a513);
  a055=(a605*a055);
  a172=(a172+a055);
  a040=(a040+a172);
  a172=(a574*a040);
  a055=(a598*a224);
  a673=(a600*a673);
  a055=(a055+a673);
  a669=(a246*a669);
  a055=(a055+a669);
  a568=(a301*a568);
  a055=(a055+a568);
  a330=(a601*a330);
  a055=(a055+a330);
  a679=(a602*a679);
  a055=(a055+a679);
  a672=(a603*a672);
  a055=(a055+a672);
  a281=(a604*a281);
  a055=(a055+a281);
  a690=(a605*a690);
  a055=(a055+a690);
  a459=(a459+a055);
  a055=(a075*a459);
  a172=(a172+a055);
  a055=(a664*a335);
  a690=(a659*a210);
  a055=(a055+a690);
  a172=(a172+a055);
  a172=(a597*a172);
  a512=(a512+a172);
  a117=(a117+a512);
  if (res[0]!=0) res[0][10]=a117;
  a633=(a001*a633);
  a688=(a005*a688);
  a633=(a633+a688);
  a047=(a302*a047);
  a633=(a633+a047);
  a057=(a359*a057);
  a633=(a633+a057);
  a447=(a417*a447);
  a633=(a633+a447);
  a218=(a476*a218);
  a633=(a633+a218);
  a342=(a536*a342);
  a633=(a633+a342);
  a040=(a475*a040);
  a459=(a453*a459);
  a040=(a040+a459);
  a335=(a660*a335);
  a210=(a684*a210);
  a335=(a335+a210);
  a040=(a040-a335);
  a040=(a597*a040);
  a633=(a633+a040);
  a224=(a224+a633);
  if (res[0]!=0) res[0][11]=a224;
  a224=arg[0]? arg[0][12] : 0;
  a633=arg[0]? arg[0][14] : 0;
  a040=(a001*a633);
  a335=(a689*a224);
  a210=arg[0]? arg[0][13] : 0;
  a459=(a080*a210);
  a335=(a335+a459);
  a459=(a034*a633);
  a342=arg[0]? arg[0][15] : 0;
  a218=(a024*a342);
  a459=(a459+a218);
  a335=(a335+a459);
  a459=(a006*a335);
  a218=(a087*a633);
  a447=(a090*a335);
  a057=(a093*a633);
  a057=(a224+a057);
  a047=(a217*a057);
  a688=(a093*a342);
  a688=(a210+a688);
  a117=(a142*a688);
  a047=(a047+a117);
  a117=(a093*a335);
  a117=(a633+a117);
  a512=(a113*a117);
  a172=(a016*a224);
  a055=(a691*a210);
  a172=(a172+a055);
  a055=(a025*a633);
  a690=(a079*a342);
  a055=(a055+a690);
  a172=(a172-a055);
  a055=(a093*a172);
  a055=(a342+a055);
  a690=(a106*a055);
  a512=(a512+a690);
  a047=(a047+a512);
  a047=(a092*a047);
  a447=(a447+a047);
  a447=(a633+a447);
  a047=(a089*a447);
  a218=(a218+a047);
  a218=(a224+a218);
  a047=(a045*a218);
  a512=(a087*a342);
  a690=(a090*a172);
  a057=(a099*a057);
  a688=(a044*a688);
  a057=(a057+a688);
  a688=(a107*a117);
  a281=(a122*a055);
  a688=(a688+a281);
  a057=(a057-a688);
  a057=(a092*a057);
  a690=(a690+a057);
  a690=(a342+a690);
  a057=(a089*a690);
  a512=(a512+a057);
  a512=(a210+a512);
  a057=(a243*a512);
  a047=(a047+a057);
  a057=(a087*a335);
  a688=(a090*a633);
  a117=(a092*a117);
  a688=(a688+a117);
  a688=(a224+a688);
  a117=(a223*a688);
  a281=(a090*a342);
  a055=(a092*a055);
  a281=(a281+a055);
  a281=(a210+a281);
  a055=(a192*a281);
  a117=(a117+a055);
  a055=(a163*a447);
  a672=(a156*a690);
  a055=(a055+a672);
  a117=(a117+a055);
  a055=(a089*a117);
  a057=(a057+a055);
  a057=(a633+a057);
  a055=(a214*a057);
  a672=(a087*a172);
  a688=(a149*a688);
  a281=(a046*a281);
  a688=(a688+a281);
  a281=(a157*a447);
  a679=(a191*a690);
  a281=(a281+a679);
  a688=(a688-a281);
  a281=(a089*a688);
  a672=(a672+a281);
  a672=(a342+a672);
  a281=(a207*a672);
  a055=(a055+a281);
  a047=(a047+a055);
  a055=(a086*a047);
  a459=(a459+a055);
  a055=(a248*a633);
  a447=(a250*a447);
  a055=(a055+a447);
  a447=(a195*a057);
  a055=(a055+a447);
  a055=(a224+a055);
  a447=(a230*a055);
  a281=(a248*a342);
  a690=(a250*a690);
  a281=(a281+a690);
  a690=(a195*a672);
  a281=(a281+a690);
  a281=(a210+a281);
  a690=(a298*a281);
  a447=(a447+a690);
  a690=(a248*a335);
  a117=(a250*a117);
  a690=(a690+a117);
  a117=(a195*a047);
  a690=(a690+a117);
  a690=(a633+a690);
  a117=(a269*a690);
  a679=(a248*a172);
  a688=(a250*a688);
  a679=(a679+a688);
  a218=(a200*a218);
  a512=(a033*a512);
  a218=(a218+a512);
  a512=(a208*a057);
  a688=(a167*a672);
  a512=(a512+a688);
  a218=(a218-a512);
  a512=(a195*a218);
  a679=(a679+a512);
  a679=(a342+a679);
  a512=(a262*a679);
  a117=(a117+a512);
  a447=(a447+a117);
  a117=(a247*a447);
  a459=(a459+a117);
  a459=(a633+a459);
  a117=(a005*a459);
  a040=(a040+a117);
  a117=(a303*a335);
  a512=(a305*a047);
  a117=(a117+a512);
  a512=(a306*a447);
  a117=(a117+a512);
  a512=(a006*a633);
  a688=(a086*a057);
  a512=(a512+a688);
  a688=(a247*a690);
  a512=(a512+a688);
  a512=(a224+a512);
  a688=(a242*a512);
  a330=(a006*a342);
  a568=(a086*a672);
  a330=(a330+a568);
  a568=(a247*a679);
  a330=(a330+a568);
  a330=(a210+a330);
  a568=(a355*a330);
  a688=(a688+a568);
  a568=(a326*a459);
  a669=(a006*a172);
  a673=(a086*a218);
  a669=(a669+a673);
  a055=(a255*a055);
  a281=(a175*a281);
  a055=(a055+a281);
  a281=(a263*a690);
  a673=(a297*a679);
  a281=(a281+a673);
  a055=(a055-a281);
  a281=(a247*a055);
  a669=(a669+a281);
  a669=(a342+a669);
  a281=(a319*a669);
  a568=(a568+a281);
  a688=(a688+a568);
  a568=(a307*a688);
  a117=(a117+a568);
  a117=(a633+a117);
  a568=(a302*a117);
  a040=(a040+a568);
  a568=(a360*a335);
  a281=(a362*a047);
  a568=(a568+a281);
  a281=(a363*a447);
  a568=(a568+a281);
  a281=(a364*a688);
  a568=(a568+a281);
  a281=(a303*a633);
  a673=(a305*a057);
  a281=(a281+a673);
  a673=(a306*a690);
  a281=(a281+a673);
  a673=(a307*a459);
  a281=(a281+a673);
  a281=(a224+a281);
  a673=(a338*a281);
  a513=(a303*a342);
  a388=(a305*a672);
  a513=(a513+a388);
  a388=(a306*a679);
  a513=(a513+a388);
  a388=(a307*a669);
  a513=(a513+a388);
  a513=(a210+a513);
  a388=(a413*a513);
  a673=(a673+a388);
  a388=(a384*a117);
  a627=(a303*a172);
  a686=(a305*a218);
  a627=(a627+a686);
  a686=(a306*a055);
  a627=(a627+a686);
  a512=(a312*a512);
  a330=(a278*a330);
  a512=(a512+a330);
  a330=(a320*a459);
  a686=(a354*a669);
  a330=(a330+a686);
  a512=(a512-a330);
  a330=(a307*a512);
  a627=(a627+a330);
  a627=(a342+a627);
  a330=(a377*a627);
  a388=(a388+a330);
  a673=(a673+a388);
  a388=(a365*a673);
  a568=(a568+a388);
  a568=(a633+a568);
  a388=(a359*a568);
  a040=(a040+a388);
  a388=(a418*a335);
  a330=(a420*a047);
  a388=(a388+a330);
  a330=(a421*a447);
  a388=(a388+a330);
  a330=(a422*a688);
  a388=(a388+a330);
  a330=(a423*a673);
  a388=(a388+a330);
  a330=(a360*a633);
  a686=(a362*a057);
  a330=(a330+a686);
  a686=(a363*a690);
  a330=(a330+a686);
  a686=(a364*a459);
  a330=(a330+a686);
  a686=(a365*a117);
  a330=(a330+a686);
  a330=(a224+a330);
  a686=(a396*a330);
  a692=(a360*a342);
  a668=(a362*a672);
  a692=(a692+a668);
  a668=(a363*a679);
  a692=(a692+a668);
  a668=(a364*a669);
  a692=(a692+a668);
  a668=(a365*a627);
  a692=(a692+a668);
  a692=(a210+a692);
  a668=(a472*a692);
  a686=(a686+a668);
  a668=(a443*a568);
  a274=(a360*a172);
  a452=(a362*a218);
  a274=(a274+a452);
  a452=(a363*a055);
  a274=(a274+a452);
  a452=(a364*a512);
  a274=(a274+a452);
  a281=(a370*a281);
  a513=(a331*a513);
  a281=(a281+a513);
  a513=(a378*a117);
  a452=(a412*a627);
  a513=(a513+a452);
  a281=(a281-a513);
  a513=(a365*a281);
  a274=(a274+a513);
  a274=(a342+a274);
  a513=(a436*a274);
  a668=(a668+a513);
  a686=(a686+a668);
  a668=(a424*a686);
  a388=(a388+a668);
  a388=(a633+a388);
  a668=(a417*a388);
  a040=(a040+a668);
  a668=(a477*a335);
  a513=(a479*a047);
  a668=(a668+a513);
  a513=(a480*a447);
  a668=(a668+a513);
  a513=(a481*a688);
  a668=(a668+a513);
  a513=(a482*a673);
  a668=(a668+a513);
  a513=(a483*a686);
  a668=(a668+a513);
  a513=(a418*a633);
  a452=(a420*a057);
  a513=(a513+a452);
  a452=(a421*a690);
  a513=(a513+a452);
  a452=(a422*a459);
  a513=(a513+a452);
  a452=(a423*a117);
  a513=(a513+a452);
  a452=(a424*a568);
  a513=(a513+a452);
  a513=(a224+a513);
  a452=(a455*a513);
  a000=(a418*a342);
  a273=(a420*a672);
  a000=(a000+a273);
  a273=(a421*a679);
  a000=(a000+a273);
  a273=(a422*a669);
  a000=(a000+a273);
  a273=(a423*a627);
  a000=(a000+a273);
  a273=(a424*a274);
  a000=(a000+a273);
  a000=(a210+a000);
  a273=(a532*a000);
  a452=(a452+a273);
  a273=(a503*a388);
  a507=(a418*a172);
  a043=(a420*a218);
  a507=(a507+a043);
  a043=(a421*a055);
  a507=(a507+a043);
  a043=(a422*a512);
  a507=(a507+a043);
  a043=(a423*a281);
  a507=(a507+a043);
  a330=(a429*a330);
  a692=(a389*a692);
  a330=(a330+a692);
  a692=(a437*a568);
  a043=(a471*a274);
  a692=(a692+a043);
  a330=(a330-a692);
  a692=(a424*a330);
  a507=(a507+a692);
  a507=(a342+a507);
  a692=(a496*a507);
  a273=(a273+a692);
  a452=(a452+a273);
  a273=(a484*a452);
  a668=(a668+a273);
  a668=(a633+a668);
  a273=(a476*a668);
  a040=(a040+a273);
  a273=(a537*a335);
  a692=(a539*a047);
  a273=(a273+a692);
  a692=(a540*a447);
  a273=(a273+a692);
  a692=(a541*a688);
  a273=(a273+a692);
  a692=(a542*a673);
  a273=(a273+a692);
  a692=(a543*a686);
  a273=(a273+a692);
  a692=(a544*a452);
  a273=(a273+a692);
  a692=(a477*a633);
  a043=(a479*a057);
  a692=(a692+a043);
  a043=(a480*a690);
  a692=(a692+a043);
  a043=(a481*a459);
  a692=(a692+a043);
  a043=(a482*a117);
  a692=(a692+a043);
  a043=(a483*a568);
  a692=(a692+a043);
  a043=(a484*a388);
  a692=(a692+a043);
  a692=(a224+a692);
  a043=(a515*a692);
  a084=(a477*a342);
  a674=(a479*a672);
  a084=(a084+a674);
  a674=(a480*a679);
  a084=(a084+a674);
  a674=(a481*a669);
  a084=(a084+a674);
  a674=(a482*a627);
  a084=(a084+a674);
  a674=(a483*a274);
  a084=(a084+a674);
  a674=(a484*a507);
  a084=(a084+a674);
  a084=(a210+a084);
  a674=(a593*a084);
  a043=(a043+a674);
  a674=(a564*a668);
  a336=(a477*a172);
  a400=(a479*a218);
  a336=(a336+a400);
  a400=(a480*a055);
  a336=(a336+a400);
  a400=(a481*a512);
  a336=(a336+a400);
  a400=(a482*a281);
  a336=(a336+a400);
  a400=(a483*a330);
  a336=(a336+a400);
  a513=(a489*a513);
  a000=(a448*a000);
  a513=(a513+a000);
  a000=(a497*a388);
  a400=(a531*a507);
  a000=(a000+a400);
  a513=(a513-a000);
  a000=(a484*a513);
  a336=(a336+a000);
  a336=(a342+a336);
  a000=(a557*a336);
  a674=(a674+a000);
  a043=(a043+a674);
  a674=(a545*a043);
  a273=(a273+a674);
  a273=(a633+a273);
  a674=(a536*a273);
  a040=(a040+a674);
  a674=(a598*a335);
  a047=(a600*a047);
  a674=(a674+a047);
  a447=(a246*a447);
  a674=(a674+a447);
  a447=(a301*a688);
  a674=(a674+a447);
  a447=(a601*a673);
  a674=(a674+a447);
  a447=(a602*a686);
  a674=(a674+a447);
  a447=(a603*a452);
  a674=(a674+a447);
  a447=(a604*a043);
  a674=(a674+a447);
  a447=(a537*a633);
  a047=(a539*a057);
  a447=(a447+a047);
  a047=(a540*a690);
  a447=(a447+a047);
  a047=(a541*a459);
  a447=(a447+a047);
  a047=(a542*a117);
  a447=(a447+a047);
  a047=(a543*a568);
  a447=(a447+a047);
  a047=(a544*a388);
  a447=(a447+a047);
  a047=(a545*a668);
  a447=(a447+a047);
  a447=(a224+a447);
  a047=(a123*a447);
  a000=(a537*a342);
  a400=(a539*a672);
  a000=(a000+a400);
  a400=(a540*a679);
  a000=(a000+a400);
  a400=(a541*a669);
  a000=(a000+a400);
  a400=(a542*a627);
  a000=(a000+a400);
  a400=(a543*a274);
  a000=(a000+a400);
  a400=(a544*a507);
  a000=(a000+a400);
  a400=(a545*a336);
  a000=(a000+a400);
  a000=(a210+a000);
  a400=(a652*a000);
  a047=(a047+a400);
  a400=(a623*a273);
  a393=(a537*a172);
  a041=(a539*a218);
  a393=(a393+a041);
  a041=(a540*a055);
  a393=(a393+a041);
  a041=(a541*a512);
  a393=(a393+a041);
  a041=(a542*a281);
  a393=(a393+a041);
  a041=(a543*a330);
  a393=(a393+a041);
  a041=(a544*a513);
  a393=(a393+a041);
  a692=(a550*a692);
  a084=(a508*a084);
  a692=(a692+a084);
  a084=(a558*a668);
  a041=(a592*a336);
  a084=(a084+a041);
  a692=(a692-a084);
  a084=(a545*a692);
  a393=(a393+a084);
  a393=(a342+a393);
  a084=(a616*a393);
  a400=(a400+a084);
  a047=(a047+a400);
  a400=(a605*a047);
  a674=(a674+a400);
  a674=(a633+a674);
  a400=(a597*a674);
  a040=(a040+a400);
  a040=(a224+a040);
  if (res[0]!=0) res[0][12]=a040;
  a040=(a001*a342);
  a400=(a005*a669);
  a040=(a040+a400);
  a400=(a302*a627);
  a040=(a040+a400);
  a400=(a359*a274);
  a040=(a040+a400);
  a400=(a417*a507);
  a040=(a040+a400);
  a400=(a476*a336);
  a040=(a040+a400);
  a400=(a536*a393);
  a040=(a040+a400);
  a400=(a598*a172);
  a218=(a600*a218);
  a400=(a400+a218);
  a055=(a246*a055);
  a400=(a400+a055);
  a055=(a301*a512);
  a400=(a400+a055);
  a055=(a601*a281);
  a400=(a400+a055);
  a055=(a602*a330);
  a400=(a400+a055);
  a055=(a603*a513);
  a400=(a400+a055);
  a055=(a604*a692);
  a400=(a400+a055);
  a447=(a609*a447);
  a000=(a576*a000);
  a447=(a447+a000);
  a000=(a617*a273);
  a055=(a651*a393);
  a000=(a000+a055);
  a447=(a447-a000);
  a000=(a605*a447);
  a400=(a400+a000);
  a400=(a342+a400);
  a000=(a597*a400);
  a040=(a040+a000);
  a040=(a210+a040);
  if (res[0]!=0) res[0][13]=a040;
  a335=(a001*a335);
  a688=(a005*a688);
  a335=(a335+a688);
  a673=(a302*a673);
  a335=(a335+a673);
  a686=(a359*a686);
  a335=(a335+a686);
  a452=(a417*a452);
  a335=(a335+a452);
  a043=(a476*a043);
  a335=(a335+a043);
  a047=(a536*a047);
  a335=(a335+a047);
  a047=(a598*a633);
  a057=(a600*a057);
  a047=(a047+a057);
  a690=(a246*a690);
  a047=(a047+a690);
  a459=(a301*a459);
  a047=(a047+a459);
  a117=(a601*a117);
  a047=(a047+a117);
  a568=(a602*a568);
  a047=(a047+a568);
  a388=(a603*a388);
  a047=(a047+a388);
  a668=(a604*a668);
  a047=(a047+a668);
  a273=(a605*a273);
  a047=(a047+a273);
  a224=(a224+a047);
  a047=(a574*a224);
  a273=(a598*a342);
  a672=(a600*a672);
  a273=(a273+a672);
  a679=(a246*a679);
  a273=(a273+a679);
  a669=(a301*a669);
  a273=(a273+a669);
  a627=(a601*a627);
  a273=(a273+a627);
  a274=(a602*a274);
  a273=(a273+a274);
  a507=(a603*a507);
  a273=(a273+a507);
  a336=(a604*a336);
  a273=(a273+a336);
  a393=(a605*a393);
  a273=(a273+a393);
  a210=(a210+a273);
  a273=(a075*a210);
  a047=(a047+a273);
  a273=(a664*a674);
  a393=(a659*a400);
  a273=(a273+a393);
  a047=(a047+a273);
  a047=(a597*a047);
  a335=(a335+a047);
  a633=(a633+a335);
  if (res[0]!=0) res[0][14]=a633;
  a172=(a001*a172);
  a512=(a005*a512);
  a172=(a172+a512);
  a281=(a302*a281);
  a172=(a172+a281);
  a330=(a359*a330);
  a172=(a172+a330);
  a513=(a417*a513);
  a172=(a172+a513);
  a692=(a476*a692);
  a172=(a172+a692);
  a447=(a536*a447);
  a172=(a172+a447);
  a224=(a475*a224);
  a210=(a453*a210);
  a224=(a224+a210);
  a674=(a660*a674);
  a400=(a684*a400);
  a674=(a674+a400);
  a224=(a224-a674);
  a224=(a597*a224);
  a172=(a172+a224);
  a342=(a342+a172);
  if (res[0]!=0) res[0][15]=a342;
  a342=arg[0]? arg[0][16] : 0;
  a172=arg[0]? arg[0][18] : 0;
  a224=(a001*a172);
  a689=(a689*a342);
  a674=arg[0]? arg[0][17] : 0;
  a080=(a080*a674);
  a689=(a689+a080);
  a034=(a034*a172);
  a080=arg[0]? arg[0][19] : 0;
  a024=(a024*a080);
  a034=(a034+a024);
  a689=(a689+a034);
  a034=arg[6]? arg[6][5] : 0;
  a024=(a007*a034);
  a024=(a010*a024);
  a024=(a015*a024);
  a400=arg[6]? arg[6][0] : 0;
  a210=arg[6]? arg[6][1] : 0;
  a013=(a013*a210);
  a447=arg[6]? arg[6][3] : 0;
  a692=(a012*a447);
  a013=(a013-a692);
  a013=(a400+a013);
  a009=(a009*a013);
  a024=(a024+a009);
  a029=(a029*a210);
  a009=arg[6]? arg[6][4] : 0;
  a692=(a020*a009);
  a692=(a008*a692);
  a023=(a023*a034);
  a692=(a692+a023);
  a692=(a028*a692);
  a023=(a032*a009);
  a513=arg[6]? arg[6][6] : 0;
  a330=(a030*a513);
  a330=(a022*a330);
  a023=(a023-a330);
  a692=(a692-a023);
  a330=(a017*a009);
  a330=(a003*a330);
  a003=(a003*a330);
  a003=(a008*a003);
  a035=(a035*a034);
  a003=(a003+a035);
  a692=(a692-a003);
  a036=(a036*a513);
  a003=(a010*a036);
  a035=(a038*a513);
  a330=(a017*a035);
  a003=(a003-a330);
  a003=(a022*a003);
  a037=(a037*a009);
  a003=(a003+a037);
  a692=(a692-a003);
  a003=(a019*a009);
  a037=(a026*a003);
  a037=(a042*a037);
  a692=(a692+a037);
  a026=(a026*a447);
  a026=(a021*a026);
  a042=(a042*a026);
  a692=(a692-a042);
  a042=(a008*a447);
  a026=(a014*a034);
  a042=(a042+a026);
  a026=(a048*a042);
  a028=(a028*a026);
  a692=(a692+a028);
  a030=(a030*a447);
  a032=(a032*a513);
  a032=(a014*a032);
  a030=(a030+a032);
  a692=(a692+a030);
  a692=(a012*a692);
  a029=(a029+a692);
  a024=(a024+a029);
  a038=(a038*a034);
  a029=(a008*a036);
  a038=(a038+a029);
  a054=(a054*a038);
  a038=(2.*a210);
  a029=(a400+a038);
  a052=(a052*a029);
  a054=(a054+a052);
  a024=(a024-a054);
  a056=(a056*a013);
  a052=(a010*a035);
  a029=(a017*a036);
  a052=(a052+a029);
  a052=(a015*a052);
  a056=(a056-a052);
  a024=(a024+a056);
  a056=(a024/a062);
  a078=(a078/a062);
  a052=(a008*a400);
  a029=(a011*a034);
  a052=(a052+a029);
  a052=(a008*a052);
  a058=(a058*a034);
  a052=(a052+a058);
  a061=(a061*a400);
  a060=(a060*a034);
  a058=(a011*a060);
  a061=(a061+a058);
  a061=(a052+a061);
  a061=(a061+a400);
  a058=arg[6]? arg[6][2] : 0;
  a029=(2.*a058);
  a061=(a061+a029);
  a066=(a066*a038);
  a692=(a008*a009);
  a032=(a022*a034);
  a692=(a692+a032);
  a010=(a010*a692);
  a017=(a017*a447);
  a017=(a008*a017);
  a067=(a067*a034);
  a017=(a017+a067);
  a010=(a010-a017);
  a019=(a019*a447);
  a010=(a010-a019);
  a010=(a010-a447);
  a017=(a021*a009);
  a010=(a010-a017);
  a067=(2.*a008);
  a067=(a067*a034);
  a010=(a010+a067);
  a010=(a010+a060);
  a048=(a048*a692);
  a010=(a010+a048);
  a020=(a020*a447);
  a020=(a008*a020);
  a072=(a072*a034);
  a020=(a020+a072);
  a010=(a010-a020);
  a072=(2.*a014);
  a072=(a072*a447);
  a060=(2.*a022);
  a060=(a060*a009);
  a032=(a072+a060);
  a010=(a010+a032);
  a010=(a053*a010);
  a066=(a066+a010);
  a061=(a061+a066);
  a078=(a078*a061);
  a056=(a056-a078);
  a068=(a068*a210);
  a019=(a019-a072);
  a019=(a019-a060);
  a019=(a019+a017);
  a019=(a019-a048);
  a019=(a019+a020);
  a019=(a012*a019);
  a068=(a068+a019);
  a068=(a068-a058);
  a019=(a068/a062);
  a062=(a071/a062);
  a062=(a062*a061);
  a019=(a019-a062);
  a062=(a081*a019);
  a069=(a069*a210);
  a023=(a023-a030);
  a021=(a021*a447);
  a021=(a021-a003);
  a007=(a007*a021);
  a023=(a023+a007);
  a023=(a012*a023);
  a069=(a069+a023);
  a051=(a051*a019);
  a024=(a071*a024);
  a051=(a051+a024);
  a069=(a069-a051);
  a069=(a069/a083);
  a081=(a081/a083);
  a076=(a076*a210);
  a083=(a012*a032);
  a076=(a076+a083);
  a076=(a058+a076);
  a068=(a071*a068);
  a073=(a073*a019);
  a068=(a068+a073);
  a068=(a076-a068);
  a081=(a081*a068);
  a069=(a069-a081);
  a071=(a071*a069);
  a062=(a062+a071);
  a056=(a056-a062);
  a689=(a689+a056);
  a056=(a006*a689);
  a062=(a087*a172);
  a071=(a090*a689);
  a081=(a093*a172);
  a081=(a342+a081);
  a217=(a217*a081);
  a068=(a093*a080);
  a068=(a674+a068);
  a142=(a142*a068);
  a217=(a217+a142);
  a142=(a093*a689);
  a142=(a172+a142);
  a113=(a113*a142);
  a016=(a016*a342);
  a691=(a691*a674);
  a016=(a016+a691);
  a025=(a025*a172);
  a079=(a079*a080);
  a025=(a025+a079);
  a016=(a016-a025);
  a016=(a016+a069);
  a093=(a093*a016);
  a093=(a080+a093);
  a106=(a106*a093);
  a113=(a113+a106);
  a217=(a217+a113);
  a113=(a095*a034);
  a113=(a098*a113);
  a113=(a015*a113);
  a096=(a096*a013);
  a113=(a113+a096);
  a111=(a111*a210);
  a096=(a103*a009);
  a096=(a008*a096);
  a105=(a105*a034);
  a096=(a096+a105);
  a096=(a110*a096);
  a105=(a097*a009);
  a106=(a101*a513);
  a106=(a022*a106);
  a105=(a105-a106);
  a096=(a096-a105);
  a106=(a100*a009);
  a106=(a094*a106);
  a094=(a094*a106);
  a094=(a008*a094);
  a114=(a114*a034);
  a094=(a094+a114);
  a096=(a096-a094);
  a094=(a098*a036);
  a114=(a100*a035);
  a094=(a094-a114);
  a094=(a022*a094);
  a115=(a115*a009);
  a094=(a094+a115);
  a096=(a096-a094);
  a094=(a102*a009);
  a115=(a108*a094);
  a115=(a119*a115);
  a096=(a096+a115);
  a108=(a108*a447);
  a108=(a104*a108);
  a119=(a119*a108);
  a096=(a096-a119);
  a119=(a124*a042);
  a110=(a110*a119);
  a096=(a096+a110);
  a101=(a101*a447);
  a097=(a097*a513);
  a097=(a014*a097);
  a101=(a101+a097);
  a096=(a096+a101);
  a096=(a012*a096);
  a111=(a111+a096);
  a113=(a113+a111);
  a113=(a113-a054);
  a128=(a128*a013);
  a111=(a098*a035);
  a096=(a100*a036);
  a111=(a111+a096);
  a111=(a015*a111);
  a128=(a128-a111);
  a113=(a113+a128);
  a128=(a113/a132);
  a140=(a140/a132);
  a131=(a131*a400);
  a130=(a130*a034);
  a111=(a011*a130);
  a131=(a131+a111);
  a131=(a052+a131);
  a131=(a131+a400);
  a131=(a131+a029);
  a133=(a133*a038);
  a098=(a098*a692);
  a100=(a100*a447);
  a100=(a008*a100);
  a134=(a134*a034);
  a100=(a100+a134);
  a098=(a098-a100);
  a102=(a102*a447);
  a098=(a098-a102);
  a098=(a098-a447);
  a100=(a104*a009);
  a098=(a098-a100);
  a098=(a098+a067);
  a098=(a098+a130);
  a124=(a124*a692);
  a098=(a098+a124);
  a103=(a103*a447);
  a103=(a008*a103);
  a138=(a138*a034);
  a103=(a103+a138);
  a098=(a098-a103);
  a098=(a098+a032);
  a098=(a053*a098);
  a133=(a133+a098);
  a131=(a131+a133);
  a140=(a140*a131);
  a128=(a128-a140);
  a135=(a135*a210);
  a102=(a102-a072);
  a102=(a102-a060);
  a102=(a102+a100);
  a102=(a102-a124);
  a102=(a102+a103);
  a102=(a012*a102);
  a135=(a135+a102);
  a135=(a135-a058);
  a102=(a135/a132);
  a132=(a137/a132);
  a132=(a132*a131);
  a102=(a102-a132);
  a132=(a143*a102);
  a136=(a136*a210);
  a105=(a105-a101);
  a104=(a104*a447);
  a104=(a104-a094);
  a095=(a095*a104);
  a105=(a105+a095);
  a105=(a012*a105);
  a136=(a136+a105);
  a127=(a127*a102);
  a113=(a137*a113);
  a127=(a127+a113);
  a136=(a136-a127);
  a136=(a136/a144);
  a143=(a143/a144);
  a135=(a137*a135);
  a139=(a139*a102);
  a135=(a135+a139);
  a135=(a076-a135);
  a143=(a143*a135);
  a136=(a136-a143);
  a137=(a137*a136);
  a132=(a132+a137);
  a128=(a128-a132);
  a217=(a217+a128);
  a217=(a092*a217);
  a071=(a071+a217);
  a071=(a172+a071);
  a217=(a089*a071);
  a062=(a062+a217);
  a062=(a342+a062);
  a045=(a045*a062);
  a217=(a087*a080);
  a128=(a090*a016);
  a099=(a099*a081);
  a044=(a044*a068);
  a099=(a099+a044);
  a107=(a107*a142);
  a122=(a122*a093);
  a107=(a107+a122);
  a099=(a099-a107);
  a099=(a099+a136);
  a099=(a092*a099);
  a128=(a128+a099);
  a128=(a080+a128);
  a099=(a089*a128);
  a217=(a217+a099);
  a217=(a674+a217);
  a243=(a243*a217);
  a045=(a045+a243);
  a243=(a087*a689);
  a099=(a090*a172);
  a142=(a092*a142);
  a099=(a099+a142);
  a099=(a342+a099);
  a223=(a223*a099);
  a090=(a090*a080);
  a092=(a092*a093);
  a090=(a090+a092);
  a090=(a674+a090);
  a192=(a192*a090);
  a223=(a223+a192);
  a163=(a163*a071);
  a156=(a156*a128);
  a163=(a163+a156);
  a223=(a223+a163);
  a163=(a145*a034);
  a163=(a148*a163);
  a163=(a015*a163);
  a146=(a146*a013);
  a163=(a163+a146);
  a161=(a161*a210);
  a146=(a153*a009);
  a146=(a008*a146);
  a155=(a155*a034);
  a146=(a146+a155);
  a146=(a160*a146);
  a155=(a147*a009);
  a156=(a151*a513);
  a156=(a022*a156);
  a155=(a155-a156);
  a146=(a146-a155);
  a156=(a150*a009);
  a156=(a091*a156);
  a091=(a091*a156);
  a091=(a008*a091);
  a164=(a164*a034);
  a091=(a091+a164);
  a146=(a146-a091);
  a091=(a148*a036);
  a164=(a150*a035);
  a091=(a091-a164);
  a091=(a022*a091);
  a165=(a165*a009);
  a091=(a091+a165);
  a146=(a146-a091);
  a091=(a152*a009);
  a165=(a158*a091);
  a165=(a169*a165);
  a146=(a146+a165);
  a158=(a158*a447);
  a158=(a154*a158);
  a169=(a169*a158);
  a146=(a146-a169);
  a169=(a174*a042);
  a160=(a160*a169);
  a146=(a146+a160);
  a151=(a151*a447);
  a147=(a147*a513);
  a147=(a014*a147);
  a151=(a151+a147);
  a146=(a146+a151);
  a146=(a012*a146);
  a161=(a161+a146);
  a163=(a163+a161);
  a163=(a163-a054);
  a178=(a178*a013);
  a161=(a148*a035);
  a146=(a150*a036);
  a161=(a161+a146);
  a161=(a015*a161);
  a178=(a178-a161);
  a163=(a163+a178);
  a178=(a163/a182);
  a190=(a190/a182);
  a181=(a181*a400);
  a180=(a180*a034);
  a161=(a011*a180);
  a181=(a181+a161);
  a181=(a052+a181);
  a181=(a181+a400);
  a181=(a181+a029);
  a183=(a183*a038);
  a148=(a148*a692);
  a150=(a150*a447);
  a150=(a008*a150);
  a184=(a184*a034);
  a150=(a150+a184);
  a148=(a148-a150);
  a152=(a152*a447);
  a148=(a148-a152);
  a148=(a148-a447);
  a150=(a154*a009);
  a148=(a148-a150);
  a148=(a148+a067);
  a148=(a148+a180);
  a174=(a174*a692);
  a148=(a148+a174);
  a153=(a153*a447);
  a153=(a008*a153);
  a188=(a188*a034);
  a153=(a153+a188);
  a148=(a148-a153);
  a148=(a148+a032);
  a148=(a053*a148);
  a183=(a183+a148);
  a181=(a181+a183);
  a190=(a190*a181);
  a178=(a178-a190);
  a185=(a185*a210);
  a152=(a152-a072);
  a152=(a152-a060);
  a152=(a152+a150);
  a152=(a152-a174);
  a152=(a152+a153);
  a152=(a012*a152);
  a185=(a185+a152);
  a185=(a185-a058);
  a152=(a185/a182);
  a182=(a187/a182);
  a182=(a182*a181);
  a152=(a152-a182);
  a182=(a193*a152);
  a186=(a186*a210);
  a155=(a155-a151);
  a154=(a154*a447);
  a154=(a154-a091);
  a145=(a145*a154);
  a155=(a155+a145);
  a155=(a012*a155);
  a186=(a186+a155);
  a177=(a177*a152);
  a163=(a187*a163);
  a177=(a177+a163);
  a186=(a186-a177);
  a186=(a186/a194);
  a193=(a193/a194);
  a185=(a187*a185);
  a189=(a189*a152);
  a185=(a185+a189);
  a185=(a076-a185);
  a193=(a193*a185);
  a186=(a186-a193);
  a187=(a187*a186);
  a182=(a182+a187);
  a178=(a178-a182);
  a223=(a223+a178);
  a178=(a089*a223);
  a243=(a243+a178);
  a243=(a172+a243);
  a214=(a214*a243);
  a087=(a087*a016);
  a149=(a149*a099);
  a046=(a046*a090);
  a149=(a149+a046);
  a157=(a157*a071);
  a191=(a191*a128);
  a157=(a157+a191);
  a149=(a149-a157);
  a149=(a149+a186);
  a089=(a089*a149);
  a087=(a087+a089);
  a087=(a080+a087);
  a207=(a207*a087);
  a214=(a214+a207);
  a045=(a045+a214);
  a214=(a196*a034);
  a214=(a199*a214);
  a214=(a015*a214);
  a197=(a197*a013);
  a214=(a214+a197);
  a212=(a212*a210);
  a197=(a204*a009);
  a197=(a008*a197);
  a206=(a206*a034);
  a197=(a197+a206);
  a197=(a211*a197);
  a206=(a198*a009);
  a207=(a202*a513);
  a207=(a022*a207);
  a206=(a206-a207);
  a197=(a197-a206);
  a207=(a201*a009);
  a207=(a088*a207);
  a088=(a088*a207);
  a088=(a008*a088);
  a215=(a215*a034);
  a088=(a088+a215);
  a197=(a197-a088);
  a088=(a199*a036);
  a215=(a201*a035);
  a088=(a088-a215);
  a088=(a022*a088);
  a216=(a216*a009);
  a088=(a088+a216);
  a197=(a197-a088);
  a088=(a203*a009);
  a216=(a209*a088);
  a216=(a220*a216);
  a197=(a197+a216);
  a209=(a209*a447);
  a209=(a205*a209);
  a220=(a220*a209);
  a197=(a197-a220);
  a220=(a225*a042);
  a211=(a211*a220);
  a197=(a197+a211);
  a202=(a202*a447);
  a198=(a198*a513);
  a198=(a014*a198);
  a202=(a202+a198);
  a197=(a197+a202);
  a197=(a012*a197);
  a212=(a212+a197);
  a214=(a214+a212);
  a214=(a214-a054);
  a229=(a229*a013);
  a212=(a199*a035);
  a197=(a201*a036);
  a212=(a212+a197);
  a212=(a015*a212);
  a229=(a229-a212);
  a214=(a214+a229);
  a229=(a214/a233);
  a241=(a241/a233);
  a232=(a232*a400);
  a231=(a231*a034);
  a212=(a011*a231);
  a232=(a232+a212);
  a232=(a052+a232);
  a232=(a232+a400);
  a232=(a232+a029);
  a234=(a234*a038);
  a199=(a199*a692);
  a201=(a201*a447);
  a201=(a008*a201);
  a235=(a235*a034);
  a201=(a201+a235);
  a199=(a199-a201);
  a203=(a203*a447);
  a199=(a199-a203);
  a199=(a199-a447);
  a201=(a205*a009);
  a199=(a199-a201);
  a199=(a199+a067);
  a199=(a199+a231);
  a225=(a225*a692);
  a199=(a199+a225);
  a204=(a204*a447);
  a204=(a008*a204);
  a239=(a239*a034);
  a204=(a204+a239);
  a199=(a199-a204);
  a199=(a199+a032);
  a199=(a053*a199);
  a234=(a234+a199);
  a232=(a232+a234);
  a241=(a241*a232);
  a229=(a229-a241);
  a236=(a236*a210);
  a203=(a203-a072);
  a203=(a203-a060);
  a203=(a203+a201);
  a203=(a203-a225);
  a203=(a203+a204);
  a203=(a012*a203);
  a236=(a236+a203);
  a236=(a236-a058);
  a203=(a236/a233);
  a233=(a238/a233);
  a233=(a233*a232);
  a203=(a203-a233);
  a233=(a244*a203);
  a237=(a237*a210);
  a206=(a206-a202);
  a205=(a205*a447);
  a205=(a205-a088);
  a196=(a196*a205);
  a206=(a206+a196);
  a206=(a012*a206);
  a237=(a237+a206);
  a228=(a228*a203);
  a214=(a238*a214);
  a228=(a228+a214);
  a237=(a237-a228);
  a237=(a237/a245);
  a244=(a244/a245);
  a236=(a238*a236);
  a240=(a240*a203);
  a236=(a236+a240);
  a236=(a076-a236);
  a244=(a244*a236);
  a237=(a237-a244);
  a238=(a238*a237);
  a233=(a233+a238);
  a229=(a229-a233);
  a045=(a045+a229);
  a229=(a086*a045);
  a056=(a056+a229);
  a229=(a248*a172);
  a071=(a250*a071);
  a229=(a229+a071);
  a071=(a195*a243);
  a229=(a229+a071);
  a229=(a342+a229);
  a230=(a230*a229);
  a071=(a248*a080);
  a128=(a250*a128);
  a071=(a071+a128);
  a128=(a195*a087);
  a071=(a071+a128);
  a071=(a674+a071);
  a298=(a298*a071);
  a230=(a230+a298);
  a298=(a248*a689);
  a223=(a250*a223);
  a298=(a298+a223);
  a223=(a195*a045);
  a298=(a298+a223);
  a298=(a172+a298);
  a269=(a269*a298);
  a248=(a248*a016);
  a250=(a250*a149);
  a248=(a248+a250);
  a200=(a200*a062);
  a033=(a033*a217);
  a200=(a200+a033);
  a208=(a208*a243);
  a167=(a167*a087);
  a208=(a208+a167);
  a200=(a200-a208);
  a200=(a200+a237);
  a195=(a195*a200);
  a248=(a248+a195);
  a248=(a080+a248);
  a262=(a262*a248);
  a269=(a269+a262);
  a230=(a230+a269);
  a269=(a251*a034);
  a269=(a254*a269);
  a269=(a015*a269);
  a252=(a252*a013);
  a269=(a269+a252);
  a267=(a267*a210);
  a252=(a259*a009);
  a252=(a008*a252);
  a261=(a261*a034);
  a252=(a252+a261);
  a252=(a266*a252);
  a261=(a253*a009);
  a262=(a257*a513);
  a262=(a022*a262);
  a261=(a261-a262);
  a252=(a252-a261);
  a262=(a256*a009);
  a262=(a249*a262);
  a249=(a249*a262);
  a249=(a008*a249);
  a270=(a270*a034);
  a249=(a249+a270);
  a252=(a252-a249);
  a249=(a254*a036);
  a270=(a256*a035);
  a249=(a249-a270);
  a249=(a022*a249);
  a271=(a271*a009);
  a249=(a249+a271);
  a252=(a252-a249);
  a249=(a258*a009);
  a271=(a264*a249);
  a271=(a275*a271);
  a252=(a252+a271);
  a264=(a264*a447);
  a264=(a260*a264);
  a275=(a275*a264);
  a252=(a252-a275);
  a275=(a280*a042);
  a266=(a266*a275);
  a252=(a252+a266);
  a257=(a257*a447);
  a253=(a253*a513);
  a253=(a014*a253);
  a257=(a257+a253);
  a252=(a252+a257);
  a252=(a012*a252);
  a267=(a267+a252);
  a269=(a269+a267);
  a269=(a269-a054);
  a284=(a284*a013);
  a267=(a254*a035);
  a252=(a256*a036);
  a267=(a267+a252);
  a267=(a015*a267);
  a284=(a284-a267);
  a269=(a269+a284);
  a284=(a269/a288);
  a296=(a296/a288);
  a287=(a287*a400);
  a286=(a286*a034);
  a267=(a011*a286);
  a287=(a287+a267);
  a287=(a052+a287);
  a287=(a287+a400);
  a287=(a287+a029);
  a289=(a289*a038);
  a254=(a254*a692);
  a256=(a256*a447);
  a256=(a008*a256);
  a290=(a290*a034);
  a256=(a256+a290);
  a254=(a254-a256);
  a258=(a258*a447);
  a254=(a254-a258);
  a254=(a254-a447);
  a256=(a260*a009);
  a254=(a254-a256);
  a254=(a254+a067);
  a254=(a254+a286);
  a280=(a280*a692);
  a254=(a254+a280);
  a259=(a259*a447);
  a259=(a008*a259);
  a294=(a294*a034);
  a259=(a259+a294);
  a254=(a254-a259);
  a254=(a254+a032);
  a254=(a053*a254);
  a289=(a289+a254);
  a287=(a287+a289);
  a296=(a296*a287);
  a284=(a284-a296);
  a291=(a291*a210);
  a258=(a258-a072);
  a258=(a258-a060);
  a258=(a258+a256);
  a258=(a258-a280);
  a258=(a258+a259);
  a258=(a012*a258);
  a291=(a291+a258);
  a291=(a291-a058);
  a258=(a291/a288);
  a288=(a293/a288);
  a288=(a288*a287);
  a258=(a258-a288);
  a288=(a299*a258);
  a292=(a292*a210);
  a261=(a261-a257);
  a260=(a260*a447);
  a260=(a260-a249);
  a251=(a251*a260);
  a261=(a261+a251);
  a261=(a012*a261);
  a292=(a292+a261);
  a283=(a283*a258);
  a269=(a293*a269);
  a283=(a283+a269);
  a292=(a292-a283);
  a292=(a292/a300);
  a299=(a299/a300);
  a291=(a293*a291);
  a295=(a295*a258);
  a291=(a291+a295);
  a291=(a076-a291);
  a299=(a299*a291);
  a292=(a292-a299);
  a293=(a293*a292);
  a288=(a288+a293);
  a284=(a284-a288);
  a230=(a230+a284);
  a284=(a247*a230);
  a056=(a056+a284);
  a056=(a172+a056);
  a284=(a005*a056);
  a224=(a224+a284);
  a284=(a303*a689);
  a288=(a305*a045);
  a284=(a284+a288);
  a288=(a306*a230);
  a284=(a284+a288);
  a288=(a006*a172);
  a293=(a086*a243);
  a288=(a288+a293);
  a293=(a247*a298);
  a288=(a288+a293);
  a288=(a342+a288);
  a242=(a242*a288);
  a293=(a006*a080);
  a299=(a086*a087);
  a293=(a293+a299);
  a299=(a247*a248);
  a293=(a293+a299);
  a293=(a674+a293);
  a355=(a355*a293);
  a242=(a242+a355);
  a326=(a326*a056);
  a006=(a006*a016);
  a086=(a086*a200);
  a006=(a006+a086);
  a255=(a255*a229);
  a175=(a175*a071);
  a255=(a255+a175);
  a263=(a263*a298);
  a297=(a297*a248);
  a263=(a263+a297);
  a255=(a255-a263);
  a255=(a255+a292);
  a247=(a247*a255);
  a006=(a006+a247);
  a006=(a080+a006);
  a319=(a319*a006);
  a326=(a326+a319);
  a242=(a242+a326);
  a326=(a308*a034);
  a326=(a311*a326);
  a326=(a015*a326);
  a309=(a309*a013);
  a326=(a326+a309);
  a324=(a324*a210);
  a309=(a316*a009);
  a309=(a008*a309);
  a318=(a318*a034);
  a309=(a309+a318);
  a309=(a323*a309);
  a318=(a310*a009);
  a319=(a314*a513);
  a319=(a022*a319);
  a318=(a318-a319);
  a309=(a309-a318);
  a319=(a313*a009);
  a319=(a085*a319);
  a085=(a085*a319);
  a085=(a008*a085);
  a327=(a327*a034);
  a085=(a085+a327);
  a309=(a309-a085);
  a085=(a311*a036);
  a327=(a313*a035);
  a085=(a085-a327);
  a085=(a022*a085);
  a328=(a328*a009);
  a085=(a085+a328);
  a309=(a309-a085);
  a085=(a315*a009);
  a328=(a321*a085);
  a328=(a332*a328);
  a309=(a309+a328);
  a321=(a321*a447);
  a321=(a317*a321);
  a332=(a332*a321);
  a309=(a309-a332);
  a332=(a337*a042);
  a323=(a323*a332);
  a309=(a309+a323);
  a314=(a314*a447);
  a310=(a310*a513);
  a310=(a014*a310);
  a314=(a314+a310);
  a309=(a309+a314);
  a309=(a012*a309);
  a324=(a324+a309);
  a326=(a326+a324);
  a326=(a326-a054);
  a341=(a341*a013);
  a324=(a311*a035);
  a309=(a313*a036);
  a324=(a324+a309);
  a324=(a015*a324);
  a341=(a341-a324);
  a326=(a326+a341);
  a341=(a326/a345);
  a353=(a353/a345);
  a344=(a344*a400);
  a343=(a343*a034);
  a324=(a011*a343);
  a344=(a344+a324);
  a344=(a052+a344);
  a344=(a344+a400);
  a344=(a344+a029);
  a346=(a346*a038);
  a311=(a311*a692);
  a313=(a313*a447);
  a313=(a008*a313);
  a347=(a347*a034);
  a313=(a313+a347);
  a311=(a311-a313);
  a315=(a315*a447);
  a311=(a311-a315);
  a311=(a311-a447);
  a313=(a317*a009);
  a311=(a311-a313);
  a311=(a311+a067);
  a311=(a311+a343);
  a337=(a337*a692);
  a311=(a311+a337);
  a316=(a316*a447);
  a316=(a008*a316);
  a351=(a351*a034);
  a316=(a316+a351);
  a311=(a311-a316);
  a311=(a311+a032);
  a311=(a053*a311);
  a346=(a346+a311);
  a344=(a344+a346);
  a353=(a353*a344);
  a341=(a341-a353);
  a348=(a348*a210);
  a315=(a315-a072);
  a315=(a315-a060);
  a315=(a315+a313);
  a315=(a315-a337);
  a315=(a315+a316);
  a315=(a012*a315);
  a348=(a348+a315);
  a348=(a348-a058);
  a315=(a348/a345);
  a345=(a350/a345);
  a345=(a345*a344);
  a315=(a315-a345);
  a345=(a356*a315);
  a349=(a349*a210);
  a318=(a318-a314);
  a317=(a317*a447);
  a317=(a317-a085);
  a308=(a308*a317);
  a318=(a318+a308);
  a318=(a012*a318);
  a349=(a349+a318);
  a340=(a340*a315);
  a326=(a350*a326);
  a340=(a340+a326);
  a349=(a349-a340);
  a349=(a349/a357);
  a356=(a356/a357);
  a348=(a350*a348);
  a352=(a352*a315);
  a348=(a348+a352);
  a348=(a076-a348);
  a356=(a356*a348);
  a349=(a349-a356);
  a350=(a350*a349);
  a345=(a345+a350);
  a341=(a341-a345);
  a242=(a242+a341);
  a341=(a307*a242);
  a284=(a284+a341);
  a284=(a172+a284);
  a341=(a302*a284);
  a224=(a224+a341);
  a341=(a360*a689);
  a345=(a362*a045);
  a341=(a341+a345);
  a345=(a363*a230);
  a341=(a341+a345);
  a345=(a364*a242);
  a341=(a341+a345);
  a345=(a303*a172);
  a350=(a305*a243);
  a345=(a345+a350);
  a350=(a306*a298);
  a345=(a345+a350);
  a350=(a307*a056);
  a345=(a345+a350);
  a345=(a342+a345);
  a338=(a338*a345);
  a350=(a303*a080);
  a356=(a305*a087);
  a350=(a350+a356);
  a356=(a306*a248);
  a350=(a350+a356);
  a356=(a307*a006);
  a350=(a350+a356);
  a350=(a674+a350);
  a413=(a413*a350);
  a338=(a338+a413);
  a384=(a384*a284);
  a303=(a303*a016);
  a305=(a305*a200);
  a303=(a303+a305);
  a306=(a306*a255);
  a303=(a303+a306);
  a312=(a312*a288);
  a278=(a278*a293);
  a312=(a312+a278);
  a320=(a320*a056);
  a354=(a354*a006);
  a320=(a320+a354);
  a312=(a312-a320);
  a312=(a312+a349);
  a307=(a307*a312);
  a303=(a303+a307);
  a303=(a080+a303);
  a377=(a377*a303);
  a384=(a384+a377);
  a338=(a338+a384);
  a384=(a366*a034);
  a384=(a369*a384);
  a384=(a015*a384);
  a367=(a367*a013);
  a384=(a384+a367);
  a382=(a382*a210);
  a367=(a374*a009);
  a367=(a008*a367);
  a376=(a376*a034);
  a367=(a367+a376);
  a367=(a381*a367);
  a376=(a368*a009);
  a377=(a372*a513);
  a377=(a022*a377);
  a376=(a376-a377);
  a367=(a367-a376);
  a377=(a371*a009);
  a377=(a304*a377);
  a304=(a304*a377);
  a304=(a008*a304);
  a385=(a385*a034);
  a304=(a304+a385);
  a367=(a367-a304);
  a304=(a369*a036);
  a385=(a371*a035);
  a304=(a304-a385);
  a304=(a022*a304);
  a386=(a386*a009);
  a304=(a304+a386);
  a367=(a367-a304);
  a304=(a373*a009);
  a386=(a379*a304);
  a386=(a390*a386);
  a367=(a367+a386);
  a379=(a379*a447);
  a379=(a375*a379);
  a390=(a390*a379);
  a367=(a367-a390);
  a390=(a395*a042);
  a381=(a381*a390);
  a367=(a367+a381);
  a372=(a372*a447);
  a368=(a368*a513);
  a368=(a014*a368);
  a372=(a372+a368);
  a367=(a367+a372);
  a367=(a012*a367);
  a382=(a382+a367);
  a384=(a384+a382);
  a384=(a384-a054);
  a399=(a399*a013);
  a382=(a369*a035);
  a367=(a371*a036);
  a382=(a382+a367);
  a382=(a015*a382);
  a399=(a399-a382);
  a384=(a384+a399);
  a399=(a384/a403);
  a411=(a411/a403);
  a402=(a402*a400);
  a401=(a401*a034);
  a382=(a011*a401);
  a402=(a402+a382);
  a402=(a052+a402);
  a402=(a402+a400);
  a402=(a402+a029);
  a404=(a404*a038);
  a369=(a369*a692);
  a371=(a371*a447);
  a371=(a008*a371);
  a405=(a405*a034);
  a371=(a371+a405);
  a369=(a369-a371);
  a373=(a373*a447);
  a369=(a369-a373);
  a369=(a369-a447);
  a371=(a375*a009);
  a369=(a369-a371);
  a369=(a369+a067);
  a369=(a369+a401);
  a395=(a395*a692);
  a369=(a369+a395);
  a374=(a374*a447);
  a374=(a008*a374);
  a409=(a409*a034);
  a374=(a374+a409);
  a369=(a369-a374);
  a369=(a369+a032);
  a369=(a053*a369);
  a404=(a404+a369);
  a402=(a402+a404);
  a411=(a411*a402);
  a399=(a399-a411);
  a406=(a406*a210);
  a373=(a373-a072);
  a373=(a373-a060);
  a373=(a373+a371);
  a373=(a373-a395);
  a373=(a373+a374);
  a373=(a012*a373);
  a406=(a406+a373);
  a406=(a406-a058);
  a373=(a406/a403);
  a403=(a408/a403);
  a403=(a403*a402);
  a373=(a373-a403);
  a403=(a414*a373);
  a407=(a407*a210);
  a376=(a376-a372);
  a375=(a375*a447);
  a375=(a375-a304);
  a366=(a366*a375);
  a376=(a376+a366);
  a376=(a012*a376);
  a407=(a407+a376);
  a398=(a398*a373);
  a384=(a408*a384);
  a398=(a398+a384);
  a407=(a407-a398);
  a407=(a407/a415);
  a414=(a414/a415);
  a406=(a408*a406);
  a410=(a410*a373);
  a406=(a406+a410);
  a406=(a076-a406);
  a414=(a414*a406);
  a407=(a407-a414);
  a408=(a408*a407);
  a403=(a403+a408);
  a399=(a399-a403);
  a338=(a338+a399);
  a399=(a365*a338);
  a341=(a341+a399);
  a341=(a172+a341);
  a399=(a359*a341);
  a224=(a224+a399);
  a399=(a418*a689);
  a403=(a420*a045);
  a399=(a399+a403);
  a403=(a421*a230);
  a399=(a399+a403);
  a403=(a422*a242);
  a399=(a399+a403);
  a403=(a423*a338);
  a399=(a399+a403);
  a403=(a360*a172);
  a408=(a362*a243);
  a403=(a403+a408);
  a408=(a363*a298);
  a403=(a403+a408);
  a408=(a364*a056);
  a403=(a403+a408);
  a408=(a365*a284);
  a403=(a403+a408);
  a403=(a342+a403);
  a396=(a396*a403);
  a408=(a360*a080);
  a414=(a362*a087);
  a408=(a408+a414);
  a414=(a363*a248);
  a408=(a408+a414);
  a414=(a364*a006);
  a408=(a408+a414);
  a414=(a365*a303);
  a408=(a408+a414);
  a408=(a674+a408);
  a472=(a472*a408);
  a396=(a396+a472);
  a443=(a443*a341);
  a360=(a360*a016);
  a362=(a362*a200);
  a360=(a360+a362);
  a363=(a363*a255);
  a360=(a360+a363);
  a364=(a364*a312);
  a360=(a360+a364);
  a370=(a370*a345);
  a331=(a331*a350);
  a370=(a370+a331);
  a378=(a378*a284);
  a412=(a412*a303);
  a378=(a378+a412);
  a370=(a370-a378);
  a370=(a370+a407);
  a365=(a365*a370);
  a360=(a360+a365);
  a360=(a080+a360);
  a436=(a436*a360);
  a443=(a443+a436);
  a396=(a396+a443);
  a443=(a425*a034);
  a443=(a428*a443);
  a443=(a015*a443);
  a426=(a426*a013);
  a443=(a443+a426);
  a441=(a441*a210);
  a426=(a433*a009);
  a426=(a008*a426);
  a435=(a435*a034);
  a426=(a426+a435);
  a426=(a440*a426);
  a435=(a427*a009);
  a436=(a431*a513);
  a436=(a022*a436);
  a435=(a435-a436);
  a426=(a426-a435);
  a436=(a430*a009);
  a436=(a361*a436);
  a361=(a361*a436);
  a361=(a008*a361);
  a444=(a444*a034);
  a361=(a361+a444);
  a426=(a426-a361);
  a361=(a428*a036);
  a444=(a430*a035);
  a361=(a361-a444);
  a361=(a022*a361);
  a445=(a445*a009);
  a361=(a361+a445);
  a426=(a426-a361);
  a361=(a432*a009);
  a445=(a438*a361);
  a445=(a449*a445);
  a426=(a426+a445);
  a438=(a438*a447);
  a438=(a434*a438);
  a449=(a449*a438);
  a426=(a426-a449);
  a449=(a454*a042);
  a440=(a440*a449);
  a426=(a426+a440);
  a431=(a431*a447);
  a427=(a427*a513);
  a427=(a014*a427);
  a431=(a431+a427);
  a426=(a426+a431);
  a426=(a012*a426);
  a441=(a441+a426);
  a443=(a443+a441);
  a443=(a443-a054);
  a458=(a458*a013);
  a441=(a428*a035);
  a426=(a430*a036);
  a441=(a441+a426);
  a441=(a015*a441);
  a458=(a458-a441);
  a443=(a443+a458);
  a458=(a443/a462);
  a470=(a470/a462);
  a461=(a461*a400);
  a460=(a460*a034);
  a441=(a011*a460);
  a461=(a461+a441);
  a461=(a052+a461);
  a461=(a461+a400);
  a461=(a461+a029);
  a463=(a463*a038);
  a428=(a428*a692);
  a430=(a430*a447);
  a430=(a008*a430);
  a464=(a464*a034);
  a430=(a430+a464);
  a428=(a428-a430);
  a432=(a432*a447);
  a428=(a428-a432);
  a428=(a428-a447);
  a430=(a434*a009);
  a428=(a428-a430);
  a428=(a428+a067);
  a428=(a428+a460);
  a454=(a454*a692);
  a428=(a428+a454);
  a433=(a433*a447);
  a433=(a008*a433);
  a468=(a468*a034);
  a433=(a433+a468);
  a428=(a428-a433);
  a428=(a428+a032);
  a428=(a053*a428);
  a463=(a463+a428);
  a461=(a461+a463);
  a470=(a470*a461);
  a458=(a458-a470);
  a465=(a465*a210);
  a432=(a432-a072);
  a432=(a432-a060);
  a432=(a432+a430);
  a432=(a432-a454);
  a432=(a432+a433);
  a432=(a012*a432);
  a465=(a465+a432);
  a465=(a465-a058);
  a432=(a465/a462);
  a462=(a467/a462);
  a462=(a462*a461);
  a432=(a432-a462);
  a462=(a473*a432);
  a466=(a466*a210);
  a435=(a435-a431);
  a434=(a434*a447);
  a434=(a434-a361);
  a425=(a425*a434);
  a435=(a435+a425);
  a435=(a012*a435);
  a466=(a466+a435);
  a457=(a457*a432);
  a443=(a467*a443);
  a457=(a457+a443);
  a466=(a466-a457);
  a466=(a466/a474);
  a473=(a473/a474);
  a465=(a467*a465);
  a469=(a469*a432);
  a465=(a465+a469);
  a465=(a076-a465);
  a473=(a473*a465);
  a466=(a466-a473);
  a467=(a467*a466);
  a462=(a462+a467);
  a458=(a458-a462);
  a396=(a396+a458);
  a458=(a424*a396);
  a399=(a399+a458);
  a399=(a172+a399);
  a458=(a417*a399);
  a224=(a224+a458);
  a458=(a477*a689);
  a462=(a479*a045);
  a458=(a458+a462);
  a462=(a480*a230);
  a458=(a458+a462);
  a462=(a481*a242);
  a458=(a458+a462);
  a462=(a482*a338);
  a458=(a458+a462);
  a462=(a483*a396);
  a458=(a458+a462);
  a462=(a418*a172);
  a467=(a420*a243);
  a462=(a462+a467);
  a467=(a421*a298);
  a462=(a462+a467);
  a467=(a422*a056);
  a462=(a462+a467);
  a467=(a423*a284);
  a462=(a462+a467);
  a467=(a424*a341);
  a462=(a462+a467);
  a462=(a342+a462);
  a455=(a455*a462);
  a467=(a418*a080);
  a473=(a420*a087);
  a467=(a467+a473);
  a473=(a421*a248);
  a467=(a467+a473);
  a473=(a422*a006);
  a467=(a467+a473);
  a473=(a423*a303);
  a467=(a467+a473);
  a473=(a424*a360);
  a467=(a467+a473);
  a467=(a674+a467);
  a532=(a532*a467);
  a455=(a455+a532);
  a503=(a503*a399);
  a418=(a418*a016);
  a420=(a420*a200);
  a418=(a418+a420);
  a421=(a421*a255);
  a418=(a418+a421);
  a422=(a422*a312);
  a418=(a418+a422);
  a423=(a423*a370);
  a418=(a418+a423);
  a429=(a429*a403);
  a389=(a389*a408);
  a429=(a429+a389);
  a437=(a437*a341);
  a471=(a471*a360);
  a437=(a437+a471);
  a429=(a429-a437);
  a429=(a429+a466);
  a424=(a424*a429);
  a418=(a418+a424);
  a418=(a080+a418);
  a496=(a496*a418);
  a503=(a503+a496);
  a455=(a455+a503);
  a503=(a485*a034);
  a503=(a488*a503);
  a503=(a015*a503);
  a486=(a486*a013);
  a503=(a503+a486);
  a501=(a501*a210);
  a486=(a493*a009);
  a486=(a008*a486);
  a495=(a495*a034);
  a486=(a486+a495);
  a486=(a500*a486);
  a495=(a487*a009);
  a496=(a491*a513);
  a496=(a022*a496);
  a495=(a495-a496);
  a486=(a486-a495);
  a496=(a490*a009);
  a496=(a419*a496);
  a419=(a419*a496);
  a419=(a008*a419);
  a504=(a504*a034);
  a419=(a419+a504);
  a486=(a486-a419);
  a419=(a488*a036);
  a504=(a490*a035);
  a419=(a419-a504);
  a419=(a022*a419);
  a505=(a505*a009);
  a419=(a419+a505);
  a486=(a486-a419);
  a419=(a492*a009);
  a505=(a498*a419);
  a505=(a509*a505);
  a486=(a486+a505);
  a498=(a498*a447);
  a498=(a494*a498);
  a509=(a509*a498);
  a486=(a486-a509);
  a509=(a514*a042);
  a500=(a500*a509);
  a486=(a486+a500);
  a491=(a491*a447);
  a487=(a487*a513);
  a487=(a014*a487);
  a491=(a491+a487);
  a486=(a486+a491);
  a486=(a012*a486);
  a501=(a501+a486);
  a503=(a503+a501);
  a503=(a503-a054);
  a518=(a518*a013);
  a501=(a488*a035);
  a486=(a490*a036);
  a501=(a501+a486);
  a501=(a015*a501);
  a518=(a518-a501);
  a503=(a503+a518);
  a518=(a503/a522);
  a530=(a530/a522);
  a521=(a521*a400);
  a520=(a520*a034);
  a501=(a011*a520);
  a521=(a521+a501);
  a521=(a052+a521);
  a521=(a521+a400);
  a521=(a521+a029);
  a523=(a523*a038);
  a488=(a488*a692);
  a490=(a490*a447);
  a490=(a008*a490);
  a524=(a524*a034);
  a490=(a490+a524);
  a488=(a488-a490);
  a492=(a492*a447);
  a488=(a488-a492);
  a488=(a488-a447);
  a490=(a494*a009);
  a488=(a488-a490);
  a488=(a488+a067);
  a488=(a488+a520);
  a514=(a514*a692);
  a488=(a488+a514);
  a493=(a493*a447);
  a493=(a008*a493);
  a528=(a528*a034);
  a493=(a493+a528);
  a488=(a488-a493);
  a488=(a488+a032);
  a488=(a053*a488);
  a523=(a523+a488);
  a521=(a521+a523);
  a530=(a530*a521);
  a518=(a518-a530);
  a525=(a525*a210);
  a492=(a492-a072);
  a492=(a492-a060);
  a492=(a492+a490);
  a492=(a492-a514);
  a492=(a492+a493);
  a492=(a012*a492);
  a525=(a525+a492);
  a525=(a525-a058);
  a492=(a525/a522);
  a522=(a527/a522);
  a522=(a522*a521);
  a492=(a492-a522);
  a522=(a533*a492);
  a526=(a526*a210);
  a495=(a495-a491);
  a494=(a494*a447);
  a494=(a494-a419);
  a485=(a485*a494);
  a495=(a495+a485);
  a495=(a012*a495);
  a526=(a526+a495);
  a517=(a517*a492);
  a503=(a527*a503);
  a517=(a517+a503);
  a526=(a526-a517);
  a526=(a526/a534);
  a533=(a533/a534);
  a525=(a527*a525);
  a529=(a529*a492);
  a525=(a525+a529);
  a525=(a076-a525);
  a533=(a533*a525);
  a526=(a526-a533);
  a527=(a527*a526);
  a522=(a522+a527);
  a518=(a518-a522);
  a455=(a455+a518);
  a518=(a484*a455);
  a458=(a458+a518);
  a458=(a172+a458);
  a518=(a476*a458);
  a224=(a224+a518);
  a518=(a537*a689);
  a522=(a539*a045);
  a518=(a518+a522);
  a522=(a540*a230);
  a518=(a518+a522);
  a522=(a541*a242);
  a518=(a518+a522);
  a522=(a542*a338);
  a518=(a518+a522);
  a522=(a543*a396);
  a518=(a518+a522);
  a522=(a544*a455);
  a518=(a518+a522);
  a522=(a477*a172);
  a527=(a479*a243);
  a522=(a522+a527);
  a527=(a480*a298);
  a522=(a522+a527);
  a527=(a481*a056);
  a522=(a522+a527);
  a527=(a482*a284);
  a522=(a522+a527);
  a527=(a483*a341);
  a522=(a522+a527);
  a527=(a484*a399);
  a522=(a522+a527);
  a522=(a342+a522);
  a515=(a515*a522);
  a527=(a477*a080);
  a533=(a479*a087);
  a527=(a527+a533);
  a533=(a480*a248);
  a527=(a527+a533);
  a533=(a481*a006);
  a527=(a527+a533);
  a533=(a482*a303);
  a527=(a527+a533);
  a533=(a483*a360);
  a527=(a527+a533);
  a533=(a484*a418);
  a527=(a527+a533);
  a527=(a674+a527);
  a593=(a593*a527);
  a515=(a515+a593);
  a564=(a564*a458);
  a477=(a477*a016);
  a479=(a479*a200);
  a477=(a477+a479);
  a480=(a480*a255);
  a477=(a477+a480);
  a481=(a481*a312);
  a477=(a477+a481);
  a482=(a482*a370);
  a477=(a477+a482);
  a483=(a483*a429);
  a477=(a477+a483);
  a489=(a489*a462);
  a448=(a448*a467);
  a489=(a489+a448);
  a497=(a497*a399);
  a531=(a531*a418);
  a497=(a497+a531);
  a489=(a489-a497);
  a489=(a489+a526);
  a484=(a484*a489);
  a477=(a477+a484);
  a477=(a080+a477);
  a557=(a557*a477);
  a564=(a564+a557);
  a515=(a515+a564);
  a564=(a546*a034);
  a564=(a549*a564);
  a564=(a015*a564);
  a547=(a547*a013);
  a564=(a564+a547);
  a562=(a562*a210);
  a547=(a554*a009);
  a547=(a008*a547);
  a556=(a556*a034);
  a547=(a547+a556);
  a547=(a561*a547);
  a556=(a548*a009);
  a557=(a552*a513);
  a557=(a022*a557);
  a556=(a556-a557);
  a547=(a547-a556);
  a557=(a551*a009);
  a557=(a478*a557);
  a478=(a478*a557);
  a478=(a008*a478);
  a565=(a565*a034);
  a478=(a478+a565);
  a547=(a547-a478);
  a478=(a549*a036);
  a565=(a551*a035);
  a478=(a478-a565);
  a478=(a022*a478);
  a566=(a566*a009);
  a478=(a478+a566);
  a547=(a547-a478);
  a478=(a553*a009);
  a566=(a559*a478);
  a566=(a570*a566);
  a547=(a547+a566);
  a559=(a559*a447);
  a559=(a555*a559);
  a570=(a570*a559);
  a547=(a547-a570);
  a570=(a575*a042);
  a561=(a561*a570);
  a547=(a547+a561);
  a552=(a552*a447);
  a548=(a548*a513);
  a548=(a014*a548);
  a552=(a552+a548);
  a547=(a547+a552);
  a547=(a012*a547);
  a562=(a562+a547);
  a564=(a564+a562);
  a564=(a564-a054);
  a579=(a579*a013);
  a562=(a549*a035);
  a547=(a551*a036);
  a562=(a562+a547);
  a562=(a015*a562);
  a579=(a579-a562);
  a564=(a564+a579);
  a579=(a564/a583);
  a591=(a591/a583);
  a582=(a582*a400);
  a581=(a581*a034);
  a562=(a011*a581);
  a582=(a582+a562);
  a582=(a052+a582);
  a582=(a582+a400);
  a582=(a582+a029);
  a584=(a584*a038);
  a549=(a549*a692);
  a551=(a551*a447);
  a551=(a008*a551);
  a585=(a585*a034);
  a551=(a551+a585);
  a549=(a549-a551);
  a553=(a553*a447);
  a549=(a549-a553);
  a549=(a549-a447);
  a551=(a555*a009);
  a549=(a549-a551);
  a549=(a549+a067);
  a549=(a549+a581);
  a575=(a575*a692);
  a549=(a549+a575);
  a554=(a554*a447);
  a554=(a008*a554);
  a589=(a589*a034);
  a554=(a554+a589);
  a549=(a549-a554);
  a549=(a549+a032);
  a549=(a053*a549);
  a584=(a584+a549);
  a582=(a582+a584);
  a591=(a591*a582);
  a579=(a579-a591);
  a586=(a586*a210);
  a553=(a553-a072);
  a553=(a553-a060);
  a553=(a553+a551);
  a553=(a553-a575);
  a553=(a553+a554);
  a553=(a012*a553);
  a586=(a586+a553);
  a586=(a586-a058);
  a553=(a586/a583);
  a583=(a588/a583);
  a583=(a583*a582);
  a553=(a553-a583);
  a583=(a594*a553);
  a587=(a587*a210);
  a556=(a556-a552);
  a555=(a555*a447);
  a555=(a555-a478);
  a546=(a546*a555);
  a556=(a556+a546);
  a556=(a012*a556);
  a587=(a587+a556);
  a578=(a578*a553);
  a564=(a588*a564);
  a578=(a578+a564);
  a587=(a587-a578);
  a587=(a587/a595);
  a594=(a594/a595);
  a586=(a588*a586);
  a590=(a590*a553);
  a586=(a586+a590);
  a586=(a076-a586);
  a594=(a594*a586);
  a587=(a587-a594);
  a588=(a588*a587);
  a583=(a583+a588);
  a579=(a579-a583);
  a515=(a515+a579);
  a579=(a545*a515);
  a518=(a518+a579);
  a518=(a172+a518);
  a579=(a536*a518);
  a224=(a224+a579);
  a579=(a598*a689);
  a045=(a600*a045);
  a579=(a579+a045);
  a230=(a246*a230);
  a579=(a579+a230);
  a230=(a301*a242);
  a579=(a579+a230);
  a230=(a601*a338);
  a579=(a579+a230);
  a230=(a602*a396);
  a579=(a579+a230);
  a230=(a603*a455);
  a579=(a579+a230);
  a230=(a604*a515);
  a579=(a579+a230);
  a230=(a537*a172);
  a045=(a539*a243);
  a230=(a230+a045);
  a045=(a540*a298);
  a230=(a230+a045);
  a045=(a541*a056);
  a230=(a230+a045);
  a045=(a542*a284);
  a230=(a230+a045);
  a045=(a543*a341);
  a230=(a230+a045);
  a045=(a544*a399);
  a230=(a230+a045);
  a045=(a545*a458);
  a230=(a230+a045);
  a230=(a342+a230);
  a123=(a123*a230);
  a045=(a537*a080);
  a583=(a539*a087);
  a045=(a045+a583);
  a583=(a540*a248);
  a045=(a045+a583);
  a583=(a541*a006);
  a045=(a045+a583);
  a583=(a542*a303);
  a045=(a045+a583);
  a583=(a543*a360);
  a045=(a045+a583);
  a583=(a544*a418);
  a045=(a045+a583);
  a583=(a545*a477);
  a045=(a045+a583);
  a045=(a674+a045);
  a652=(a652*a045);
  a123=(a123+a652);
  a623=(a623*a518);
  a537=(a537*a016);
  a539=(a539*a200);
  a537=(a537+a539);
  a540=(a540*a255);
  a537=(a537+a540);
  a541=(a541*a312);
  a537=(a537+a541);
  a542=(a542*a370);
  a537=(a537+a542);
  a543=(a543*a429);
  a537=(a537+a543);
  a544=(a544*a489);
  a537=(a537+a544);
  a550=(a550*a522);
  a508=(a508*a527);
  a550=(a550+a508);
  a558=(a558*a458);
  a592=(a592*a477);
  a558=(a558+a592);
  a550=(a550-a558);
  a550=(a550+a587);
  a545=(a545*a550);
  a537=(a537+a545);
  a537=(a080+a537);
  a616=(a616*a537);
  a623=(a623+a616);
  a123=(a123+a623);
  a623=(a002*a034);
  a623=(a608*a623);
  a623=(a015*a623);
  a606=(a606*a013);
  a623=(a623+a606);
  a621=(a621*a210);
  a606=(a613*a009);
  a606=(a008*a606);
  a615=(a615*a034);
  a606=(a606+a615);
  a606=(a620*a606);
  a615=(a607*a009);
  a616=(a611*a513);
  a616=(a022*a616);
  a615=(a615-a616);
  a606=(a606-a615);
  a616=(a610*a009);
  a616=(a538*a616);
  a538=(a538*a616);
  a538=(a008*a538);
  a624=(a624*a034);
  a538=(a538+a624);
  a606=(a606-a538);
  a538=(a608*a036);
  a624=(a610*a035);
  a538=(a538-a624);
  a538=(a022*a538);
  a625=(a625*a009);
  a538=(a538+a625);
  a606=(a606-a538);
  a538=(a612*a009);
  a625=(a618*a538);
  a625=(a629*a625);
  a606=(a606+a625);
  a618=(a618*a447);
  a618=(a614*a618);
  a629=(a629*a618);
  a606=(a606-a629);
  a629=(a634*a042);
  a620=(a620*a629);
  a606=(a606+a620);
  a611=(a611*a447);
  a607=(a607*a513);
  a607=(a014*a607);
  a611=(a611+a607);
  a606=(a606+a611);
  a606=(a012*a606);
  a621=(a621+a606);
  a623=(a623+a621);
  a623=(a623-a054);
  a638=(a638*a013);
  a621=(a608*a035);
  a606=(a610*a036);
  a621=(a621+a606);
  a621=(a015*a621);
  a638=(a638-a621);
  a623=(a623+a638);
  a638=(a623/a642);
  a650=(a650/a642);
  a641=(a641*a400);
  a640=(a640*a034);
  a621=(a011*a640);
  a641=(a641+a621);
  a641=(a052+a641);
  a641=(a641+a400);
  a641=(a641+a029);
  a643=(a643*a038);
  a608=(a608*a692);
  a610=(a610*a447);
  a610=(a008*a610);
  a644=(a644*a034);
  a610=(a610+a644);
  a608=(a608-a610);
  a612=(a612*a447);
  a608=(a608-a612);
  a608=(a608-a447);
  a610=(a614*a009);
  a608=(a608-a610);
  a608=(a608+a067);
  a608=(a608+a640);
  a634=(a634*a692);
  a608=(a608+a634);
  a613=(a613*a447);
  a613=(a008*a613);
  a648=(a648*a034);
  a613=(a613+a648);
  a608=(a608-a613);
  a608=(a608+a032);
  a608=(a053*a608);
  a643=(a643+a608);
  a641=(a641+a643);
  a650=(a650*a641);
  a638=(a638-a650);
  a645=(a645*a210);
  a612=(a612-a072);
  a612=(a612-a060);
  a612=(a612+a610);
  a612=(a612-a634);
  a612=(a612+a613);
  a612=(a012*a612);
  a645=(a645+a612);
  a645=(a645-a058);
  a612=(a645/a642);
  a642=(a647/a642);
  a642=(a642*a641);
  a612=(a612-a642);
  a642=(a653*a612);
  a646=(a646*a210);
  a615=(a615-a611);
  a614=(a614*a447);
  a614=(a614-a538);
  a002=(a002*a614);
  a615=(a615+a002);
  a615=(a012*a615);
  a646=(a646+a615);
  a637=(a637*a612);
  a623=(a647*a623);
  a637=(a637+a623);
  a646=(a646-a637);
  a646=(a646/a654);
  a653=(a653/a654);
  a645=(a647*a645);
  a649=(a649*a612);
  a645=(a645+a649);
  a645=(a076-a645);
  a653=(a653*a645);
  a646=(a646-a653);
  a647=(a647*a646);
  a642=(a642+a647);
  a638=(a638-a642);
  a123=(a123+a638);
  a638=(a605*a123);
  a579=(a579+a638);
  a579=(a172+a579);
  a638=(a597*a579);
  a224=(a224+a638);
  a224=(a342+a224);
  if (res[0]!=0) res[0][16]=a224;
  a224=(a001*a080);
  a638=(a005*a006);
  a224=(a224+a638);
  a638=(a302*a303);
  a224=(a224+a638);
  a638=(a359*a360);
  a224=(a224+a638);
  a638=(a417*a418);
  a224=(a224+a638);
  a638=(a476*a477);
  a224=(a224+a638);
  a638=(a536*a537);
  a224=(a224+a638);
  a638=(a598*a016);
  a200=(a600*a200);
  a638=(a638+a200);
  a255=(a246*a255);
  a638=(a638+a255);
  a255=(a301*a312);
  a638=(a638+a255);
  a255=(a601*a370);
  a638=(a638+a255);
  a255=(a602*a429);
  a638=(a638+a255);
  a255=(a603*a489);
  a638=(a638+a255);
  a255=(a604*a550);
  a638=(a638+a255);
  a609=(a609*a230);
  a576=(a576*a045);
  a609=(a609+a576);
  a617=(a617*a518);
  a651=(a651*a537);
  a617=(a617+a651);
  a609=(a609-a617);
  a609=(a609+a646);
  a646=(a605*a609);
  a638=(a638+a646);
  a638=(a080+a638);
  a646=(a597*a638);
  a224=(a224+a646);
  a224=(a674+a224);
  if (res[0]!=0) res[0][17]=a224;
  a689=(a001*a689);
  a242=(a005*a242);
  a689=(a689+a242);
  a338=(a302*a338);
  a689=(a689+a338);
  a396=(a359*a396);
  a689=(a689+a396);
  a455=(a417*a455);
  a689=(a689+a455);
  a515=(a476*a515);
  a689=(a689+a515);
  a123=(a536*a123);
  a689=(a689+a123);
  a123=(a598*a172);
  a243=(a600*a243);
  a123=(a123+a243);
  a298=(a246*a298);
  a123=(a123+a298);
  a056=(a301*a056);
  a123=(a123+a056);
  a284=(a601*a284);
  a123=(a123+a284);
  a341=(a602*a341);
  a123=(a123+a341);
  a399=(a603*a399);
  a123=(a123+a399);
  a458=(a604*a458);
  a123=(a123+a458);
  a518=(a605*a518);
  a123=(a123+a518);
  a342=(a342+a123);
  a574=(a574*a342);
  a598=(a598*a080);
  a600=(a600*a087);
  a598=(a598+a600);
  a246=(a246*a248);
  a598=(a598+a246);
  a301=(a301*a006);
  a598=(a598+a301);
  a601=(a601*a303);
  a598=(a598+a601);
  a602=(a602*a360);
  a598=(a598+a602);
  a603=(a603*a418);
  a598=(a598+a603);
  a604=(a604*a477);
  a598=(a598+a604);
  a605=(a605*a537);
  a598=(a598+a605);
  a674=(a674+a598);
  a075=(a075*a674);
  a574=(a574+a075);
  a664=(a664*a579);
  a659=(a659*a638);
  a664=(a664+a659);
  a574=(a574+a664);
  a664=(a655*a034);
  a664=(a535*a664);
  a664=(a015*a664);
  a596=(a596*a013);
  a664=(a664+a596);
  a663=(a663*a210);
  a596=(a004*a009);
  a596=(a008*a596);
  a658=(a658*a034);
  a596=(a596+a658);
  a596=(a662*a596);
  a658=(a031*a009);
  a659=(a018*a513);
  a659=(a022*a659);
  a658=(a658-a659);
  a596=(a596-a658);
  a659=(a416*a009);
  a659=(a599*a659);
  a599=(a599*a659);
  a599=(a008*a599);
  a665=(a665*a034);
  a599=(a599+a665);
  a596=(a596-a599);
  a599=(a535*a036);
  a665=(a416*a035);
  a599=(a599-a665);
  a022=(a022*a599);
  a666=(a666*a009);
  a022=(a022+a666);
  a596=(a596-a022);
  a022=(a358*a009);
  a666=(a656*a022);
  a666=(a670*a666);
  a596=(a596+a666);
  a656=(a656*a447);
  a656=(a657*a656);
  a670=(a670*a656);
  a596=(a596-a670);
  a042=(a675*a042);
  a662=(a662*a042);
  a596=(a596+a662);
  a018=(a018*a447);
  a031=(a031*a513);
  a014=(a014*a031);
  a018=(a018+a014);
  a596=(a596+a018);
  a596=(a012*a596);
  a663=(a663+a596);
  a664=(a664+a663);
  a664=(a664-a054);
  a678=(a678*a013);
  a035=(a535*a035);
  a036=(a416*a036);
  a035=(a035+a036);
  a015=(a015*a035);
  a678=(a678-a015);
  a664=(a664+a678);
  a678=(a664/a059);
  a077=(a077/a059);
  a681=(a681*a400);
  a680=(a680*a034);
  a011=(a011*a680);
  a681=(a681+a011);
  a052=(a052+a681);
  a052=(a052+a400);
  a052=(a052+a029);
  a064=(a064*a038);
  a535=(a535*a692);
  a416=(a416*a447);
  a416=(a008*a416);
  a682=(a682*a034);
  a416=(a416+a682);
  a535=(a535-a416);
  a358=(a358*a447);
  a535=(a535-a358);
  a535=(a535-a447);
  a009=(a657*a009);
  a535=(a535-a009);
  a535=(a535+a067);
  a535=(a535+a680);
  a675=(a675*a692);
  a535=(a535+a675);
  a004=(a004*a447);
  a008=(a008*a004);
  a070=(a070*a034);
  a008=(a008+a070);
  a535=(a535-a008);
  a535=(a535+a032);
  a053=(a053*a535);
  a064=(a064+a053);
  a052=(a052+a064);
  a077=(a077*a052);
  a678=(a678-a077);
  a683=(a683*a210);
  a358=(a358-a072);
  a358=(a358-a060);
  a358=(a358+a009);
  a358=(a358-a675);
  a358=(a358+a008);
  a358=(a012*a358);
  a683=(a683+a358);
  a683=(a683-a058);
  a058=(a683/a059);
  a059=(a063/a059);
  a059=(a059*a052);
  a058=(a058-a059);
  a059=(a074*a058);
  a065=(a065*a210);
  a658=(a658-a018);
  a657=(a657*a447);
  a657=(a657-a022);
  a655=(a655*a657);
  a658=(a658+a655);
  a012=(a012*a658);
  a065=(a065+a012);
  a677=(a677*a058);
  a664=(a063*a664);
  a677=(a677+a664);
  a065=(a065-a677);
  a065=(a065/a082);
  a074=(a074/a082);
  a683=(a063*a683);
  a685=(a685*a058);
  a683=(a683+a685);
  a076=(a076-a683);
  a074=(a074*a076);
  a065=(a065-a074);
  a063=(a063*a065);
  a059=(a059+a063);
  a678=(a678-a059);
  a574=(a574+a678);
  a574=(a597*a574);
  a689=(a689+a574);
  a172=(a172+a689);
  if (res[0]!=0) res[0][18]=a172;
  a001=(a001*a016);
  a005=(a005*a312);
  a001=(a001+a005);
  a302=(a302*a370);
  a001=(a001+a302);
  a359=(a359*a429);
  a001=(a001+a359);
  a417=(a417*a489);
  a001=(a001+a417);
  a476=(a476*a550);
  a001=(a001+a476);
  a536=(a536*a609);
  a001=(a001+a536);
  a475=(a475*a342);
  a453=(a453*a674);
  a475=(a475+a453);
  a660=(a660*a579);
  a684=(a684*a638);
  a660=(a660+a684);
  a475=(a475-a660);
  a475=(a475+a065);
  a597=(a597*a475);
  a001=(a001+a597);
  a080=(a080+a001);
  if (res[0]!=0) res[0][19]=a080;
  return 0;
}

/* step_alongs:(y[4x5],t,turns[2x12],h,p[7],d[7])->(y_end[4x5]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+695, w1, *w2=w+715, *w3=w+722, w5, *w6=w+724, *w7=w+731, w8;
  const casadi_real **arg1=arg+6, *wr0, *wr4;
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
  /* #6: @6 = input[5][0] */
  casadi_copy(arg[5], 7, w6);
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

/* landing_along:(y[4x5],z[3],T,p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89;
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
  a25=(a02*a24);
  a25=(a20+a25);
  a26=(a04*a25);
  a27=sin(a09);
  a28=(a07*a27);
  a28=(a26*a28);
  a29=(a04*a20);
  a30=(a22*a13);
  a31=(a23*a04);
  a31=(a30-a31);
  a32=(a05+a31);
  a33=(a02*a32);
  a29=(a29+a33);
  a33=sin(a16);
  a34=(a07*a33);
  a34=(a29*a34);
  a28=(a28+a34);
  a12=(a12-a28);
  a28=(2.*a17);
  a35=(a28*a07);
  a36=(a20*a35);
  a36=(a36+a20);
  a37=arg[3]? arg[3][2] : 0;
  a38=(2.*a37);
  a36=(a36+a38);
  a39=(2.*a02);
  a40=casadi_sq(a07);
  a41=(a17*a22);
  a42=(a41*a07);
  a43=(a40-a42);
  a43=(a43-a22);
  a43=(a43+a35);
  a44=(a08*a33);
  a43=(a43+a44);
  a45=casadi_sq(a22);
  a46=casadi_sq(a06);
  a47=(a45+a46);
  a43=(a43+a47);
  a48=sin(a15);
  a49=(a06*a48);
  a50=cos(a15);
  a51=(a50*a22);
  a52=(a49-a51);
  a53=(a08*a27);
  a52=(a52+a53);
  a54=(a10*a22);
  a55=(a54*a07);
  a52=(a52-a55);
  a43=(a43+a52);
  a43=(a43+a03);
  a56=(a39*a43);
  a36=(a36+a56);
  a56=(a20*a07);
  a57=(a56*a07);
  a36=(a36+a57);
  a58=(a12/a36);
  a59=(a10*a07);
  a60=(a59*a26);
  a61=(a17*a07);
  a62=(a61*a29);
  a60=(a60+a62);
  a62=(a50*a26);
  a60=(a60+a62);
  a62=(a05*a37);
  a60=(a60+a62);
  a62=(a04*a57);
  a60=(a60+a62);
  a62=(a13*a37);
  a60=(a60-a62);
  a62=(a23*a22);
  a63=(a62*a04);
  a64=(a45*a13);
  a63=(a63-a64);
  a64=(2.*a06);
  a65=(a64*a06);
  a66=(a65*a04);
  a63=(a63+a66);
  a66=(a46*a13);
  a63=(a63-a66);
  a66=(a05*a07);
  a67=(a66*a07);
  a63=(a63+a67);
  a67=(a05*a53);
  a63=(a63+a67);
  a63=(a63+a31);
  a31=(a44*a14);
  a63=(a63+a31);
  a31=(a02*a63);
  a60=(a60+a31);
  a31=(a60/a36);
  a67=(a31/a36);
  a68=(-a33);
  a68=(2.*a68);
  a68=(a07*a68);
  a69=(a20*a68);
  a70=(a22*a33);
  a70=(a07*a70);
  a68=(a70+a68);
  a68=(a68+a18);
  a71=(a22*a27);
  a71=(a07*a71);
  a72=(a11+a71);
  a68=(a68+a72);
  a68=(a39*a68);
  a69=(a69+a68);
  a68=(a67*a69);
  a58=(a58-a68);
  a68=(a22-a47);
  a73=(a02*a68);
  a73=(a73-a37);
  a74=(a04*a73);
  a75=(a04*a55);
  a76=(a04*a53);
  a75=(a75-a76);
  a76=(a02*a75);
  a74=(a74+a76);
  a52=(a47+a52);
  a76=(a02*a52);
  a76=(a37+a76);
  a77=(a76/a36);
  a78=(a77*a60);
  a74=(a74+a78);
  a78=(a02*a47);
  a78=(a37+a78);
  a79=(a76*a77);
  a79=(a78-a79);
  a74=(a74/a79);
  a72=(a02*a72);
  a80=(a72/a36);
  a81=(a77/a36);
  a69=(a81*a69);
  a80=(a80-a69);
  a69=(a74*a80);
  a82=(a60*a80);
  a12=(a77*a12);
  a82=(a82+a12);
  a71=(a04*a71);
  a11=(a04*a11);
  a71=(a71+a11);
  a71=(a02*a71);
  a82=(a82-a71);
  a82=(a82/a79);
  a71=(a74/a79);
  a72=(a77*a72);
  a80=(a76*a80);
  a72=(a72+a80);
  a72=(a71*a72);
  a82=(a82+a72);
  a72=(a77*a82);
  a69=(a69+a72);
  a58=(a58+a69);
  a69=(a58*a00);
  a72=(a26*a48);
  a34=(a34-a72);
  a19=(a02*a19);
  a34=(a34-a19);
  a19=(a34/a36);
  a72=(2.*a33);
  a72=(a07*a72);
  a80=(a20*a72);
  a72=(a72-a70);
  a72=(a72-a18);
  a18=(a06*a50);
  a70=(a22*a48);
  a18=(a18+a70);
  a72=(a72+a18);
  a72=(a39*a72);
  a80=(a80+a72);
  a72=(a67*a80);
  a19=(a19-a72);
  a18=(a02*a18);
  a72=(a18/a36);
  a80=(a81*a80);
  a72=(a72-a80);
  a80=(a74*a72);
  a11=(a60*a72);
  a34=(a77*a34);
  a11=(a11+a34);
  a11=(a11/a79);
  a18=(a77*a18);
  a72=(a76*a72);
  a18=(a18+a72);
  a18=(a71*a18);
  a11=(a11+a18);
  a18=(a77*a11);
  a80=(a80+a18);
  a19=(a19+a80);
  a80=(a19*a01);
  a69=(a69+a80);
  a80=(a59*a25);
  a18=(a61*a25);
  a80=(a80+a18);
  a18=(a50*a25);
  a80=(a80+a18);
  a80=(a80+a38);
  a80=(a80+a57);
  a18=(a62+a65);
  a72=(2.*a07);
  a34=(a07*a72);
  a18=(a18+a34);
  a34=(2.*a53);
  a18=(a18+a34);
  a18=(a18-a23);
  a34=(2.*a44);
  a18=(a18+a34);
  a18=(a02*a18);
  a80=(a80+a18);
  a18=(a80/a36);
  a34=(a55-a53);
  a34=(a02*a34);
  a34=(a73+a34);
  a80=(a77*a80);
  a34=(a34+a80);
  a34=(a34/a79);
  a80=(a77*a34);
  a18=(a18+a80);
  a80=arg[0]? arg[0][6] : 0;
  a12=(a18*a80);
  a69=(a69+a12);
  a12=(a02*a22);
  a12=(a61*a12);
  a12=(a12-a37);
  a83=(a68-a44);
  a83=(a02*a83);
  a12=(a12+a83);
  a83=(a12/a36);
  a12=(a77*a12);
  a12=(a12/a79);
  a84=(a77*a12);
  a83=(a83+a84);
  a84=arg[0]? arg[0][7] : 0;
  a85=(a83*a84);
  a69=(a69+a85);
  if (res[0]!=0) res[0][1]=a69;
  a69=(a82*a00);
  a85=(a11*a01);
  a69=(a69+a85);
  a80=(a34*a80);
  a69=(a69+a80);
  a84=(a12*a84);
  a69=(a69+a84);
  if (res[0]!=0) res[0][2]=a69;
  a69=-2.;
  a00=(a69*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a84=(a00-a01);
  if (res[0]!=0) res[0][4]=a84;
  a84=(a58*a00);
  a80=(a19*a01);
  a84=(a84+a80);
  a80=arg[0]? arg[0][10] : 0;
  a85=(a18*a80);
  a84=(a84+a85);
  a85=arg[0]? arg[0][11] : 0;
  a86=(a83*a85);
  a84=(a84+a86);
  a84=(a84-a03);
  if (res[0]!=0) res[0][5]=a84;
  a84=(a82*a00);
  a86=(a11*a01);
  a84=(a84+a86);
  a80=(a34*a80);
  a84=(a84+a80);
  a85=(a12*a85);
  a84=(a84+a85);
  if (res[0]!=0) res[0][6]=a84;
  a00=(a69*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a84=(a00-a01);
  if (res[0]!=0) res[0][8]=a84;
  a84=(a58*a00);
  a85=(a19*a01);
  a84=(a84+a85);
  a85=arg[0]? arg[0][14] : 0;
  a80=(a18*a85);
  a84=(a84+a80);
  a80=arg[0]? arg[0][15] : 0;
  a86=(a83*a80);
  a84=(a84+a86);
  if (res[0]!=0) res[0][9]=a84;
  a84=(a82*a00);
  a86=(a11*a01);
  a84=(a84+a86);
  a85=(a34*a85);
  a84=(a84+a85);
  a80=(a12*a80);
  a84=(a84+a80);
  a84=(a84-a03);
  if (res[0]!=0) res[0][10]=a84;
  a00=(a69*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=(a04-a13);
  if (res[0]!=0) res[0][12]=a00;
  a58=(a58*a04);
  a19=(a19*a13);
  a58=(a58+a19);
  a19=casadi_sq(a04);
  a00=(a19*a07);
  a00=(a00*a27);
  a21=(a21-a22);
  a21=(a02*a21);
  a21=(a20+a21);
  a00=(a00*a21);
  a01=(a17*a06);
  a01=(a01*a07);
  a84=(a05*a13);
  a84=(a84-a19);
  a80=casadi_sq(a13);
  a84=(a84-a80);
  a01=(a01*a84);
  a80=(a15-a09);
  a85=arg[3]? arg[3][6] : 0;
  a80=(a80+a85);
  a86=cos(a80);
  a86=(a86*a06);
  a01=(a01-a86);
  a87=(a10*a06);
  a87=(a87*a04);
  a87=(a87*a04);
  a87=(a87*a07);
  a01=(a01-a87);
  a87=(a09-a85);
  a88=cos(a87);
  a88=(a88*a06);
  a01=(a01-a88);
  a88=(a50*a06);
  a89=(a88*a13);
  a89=(a89*a14);
  a01=(a01+a89);
  a30=(a30*a48);
  a30=(a30*a14);
  a01=(a01-a30);
  a30=(a22*a07);
  a30=(a30*a33);
  a30=(a30*a84);
  a01=(a01+a30);
  a80=sin(a80);
  a80=(a22*a80);
  a01=(a01+a80);
  a01=(a02*a01);
  a00=(a00+a01);
  a85=sin(a85);
  a85=(a07*a85);
  a01=(a20+a39);
  a85=(a85*a01);
  a00=(a00-a85);
  a87=sin(a87);
  a87=(a87*a21);
  a00=(a00+a87);
  a87=(2.*a10);
  a87=(a87*a07);
  a21=(a20*a87);
  a21=(a57+a21);
  a21=(a21+a20);
  a21=(a21+a38);
  a38=(a53-a55);
  a38=(a38-a51);
  a38=(a38-a22);
  a38=(a38-a49);
  a38=(a38+a40);
  a38=(a38+a87);
  a38=(a38+a44);
  a38=(a38-a42);
  a38=(a38+a47);
  a38=(a38+a03);
  a38=(a39*a38);
  a21=(a21+a38);
  a38=(a00/a21);
  a51=(a51-a45);
  a51=(a51-a46);
  a51=(a51+a49);
  a51=(a51-a44);
  a51=(a51+a42);
  a51=(a02*a51);
  a51=(a51-a37);
  a21=(a51/a21);
  a86=(a86-a80);
  a70=(a70-a88);
  a19=(a19*a70);
  a86=(a86+a19);
  a86=(a02*a86);
  a00=(a21*a00);
  a86=(a86-a00);
  a51=(a51*a21);
  a78=(a78-a51);
  a86=(a86/a78);
  a21=(a21*a86);
  a38=(a38-a21);
  a18=(a18*a38);
  a58=(a58+a18);
  a83=(a83*a86);
  a58=(a58+a83);
  if (res[0]!=0) res[0][13]=a58;
  a82=(a82*a04);
  a11=(a11*a13);
  a82=(a82+a11);
  a34=(a34*a38);
  a82=(a82+a34);
  a12=(a12*a86);
  a82=(a82+a12);
  if (res[0]!=0) res[0][14]=a82;
  a69=(a69*a04);
  a69=(a69+a13);
  if (res[0]!=0) res[0][15]=a69;
  a69=arg[0]? arg[0][16] : 0;
  a82=arg[0]? arg[0][17] : 0;
  a12=(a69-a82);
  if (res[1]!=0) res[1][0]=a12;
  a86=arg[4]? arg[4][5] : 0;
  a34=(a10*a86);
  a38=(a27*a69);
  a11=(a07*a38);
  a34=(a34-a11);
  a34=(a26*a34);
  a11=arg[0]? arg[0][18] : 0;
  a25=(a25*a11);
  a58=arg[4]? arg[4][0] : 0;
  a83=arg[4]? arg[4][1] : 0;
  a24=(a24*a83);
  a18=arg[4]? arg[4][3] : 0;
  a21=(2.*a18);
  a78=(a02*a21);
  a24=(a24-a78);
  a24=(a58+a24);
  a24=(a04*a24);
  a25=(a25+a24);
  a59=(a59*a25);
  a34=(a34+a59);
  a59=(a17*a86);
  a24=(a33*a12);
  a78=(a07*a24);
  a59=(a59-a78);
  a29=(a29*a59);
  a59=(a20*a11);
  a78=(a04*a58);
  a59=(a59+a78);
  a32=(a32*a83);
  a78=(2.*a11);
  a51=(a13*a18);
  a00=arg[0]? arg[0][19] : 0;
  a19=(a22*a00);
  a51=(a51+a19);
  a19=(a04*a21);
  a70=(a23*a11);
  a19=(a19+a70);
  a51=(a51-a19);
  a19=(a78+a51);
  a19=(a02*a19);
  a32=(a32+a19);
  a59=(a59+a32);
  a61=(a61*a59);
  a29=(a29+a61);
  a34=(a34+a29);
  a25=(a50*a25);
  a29=(a48*a82);
  a26=(a26*a29);
  a25=(a25-a26);
  a34=(a34+a25);
  a25=(a37*a78);
  a26=arg[4]? arg[4][2] : 0;
  a61=(a05*a26);
  a25=(a25+a61);
  a34=(a34+a25);
  a57=(a57*a11);
  a25=(a07*a58);
  a61=(a20*a86);
  a25=(a25+a61);
  a25=(a07*a25);
  a56=(a56*a86);
  a25=(a25+a56);
  a56=(a04*a25);
  a57=(a57+a56);
  a34=(a34+a57);
  a37=(a37*a00);
  a57=(a13*a26);
  a37=(a37+a57);
  a34=(a34-a37);
  a63=(a63*a83);
  a21=(a22*a21);
  a23=(a23*a18);
  a21=(a21+a23);
  a21=(a04*a21);
  a62=(a62*a11);
  a21=(a21+a62);
  a62=(a13*a23);
  a45=(a45*a00);
  a62=(a62+a45);
  a21=(a21-a62);
  a62=arg[4]? arg[4][4] : 0;
  a45=(2.*a62);
  a45=(a06*a45);
  a64=(a64*a62);
  a45=(a45+a64);
  a45=(a04*a45);
  a65=(a65*a11);
  a45=(a45+a65);
  a21=(a21+a45);
  a13=(a13*a64);
  a46=(a46*a00);
  a13=(a13+a46);
  a21=(a21-a13);
  a13=(a07*a78);
  a46=(a05*a86);
  a13=(a13+a46);
  a13=(a07*a13);
  a66=(a66*a86);
  a13=(a13+a66);
  a21=(a21+a13);
  a13=(a53*a78);
  a66=(a07*a62);
  a46=(a06*a86);
  a66=(a66+a46);
  a27=(a27*a66);
  a46=(a10*a69);
  a46=(a08*a46);
  a27=(a27+a46);
  a05=(a05*a27);
  a13=(a13+a05);
  a21=(a21+a13);
  a21=(a21+a51);
  a33=(a33*a66);
  a12=(a17*a12);
  a08=(a08*a12);
  a33=(a33+a08);
  a14=(a14*a33);
  a78=(a78-a00);
  a44=(a44*a78);
  a14=(a14+a44);
  a21=(a21+a14);
  a21=(a02*a21);
  a63=(a63+a21);
  a34=(a34+a63);
  a63=(a34/a36);
  a35=(a35*a58);
  a21=(-a24);
  a21=(2.*a21);
  a21=(a07*a21);
  a28=(a28*a86);
  a21=(a21+a28);
  a20=(a20*a21);
  a35=(a35+a20);
  a35=(a35+a58);
  a58=(2.*a26);
  a35=(a35+a58);
  a58=(2.*a83);
  a43=(a43*a58);
  a72=(a72*a86);
  a17=(a17*a18);
  a24=(a22*a24);
  a17=(a17-a24);
  a17=(a07*a17);
  a41=(a41*a86);
  a17=(a17+a41);
  a72=(a72-a17);
  a72=(a72-a18);
  a72=(a72+a21);
  a72=(a72+a33);
  a23=(a23+a64);
  a72=(a72+a23);
  a48=(a48*a62);
  a62=(a50*a82);
  a06=(a06*a62);
  a48=(a48+a06);
  a50=(a50*a18);
  a29=(a22*a29);
  a50=(a50-a29);
  a48=(a48-a50);
  a48=(a48+a27);
  a10=(a10*a18);
  a22=(a22*a38);
  a10=(a10-a22);
  a07=(a07*a10);
  a54=(a54*a86);
  a07=(a07+a54);
  a48=(a48-a07);
  a72=(a72+a48);
  a39=(a39*a72);
  a43=(a43+a39);
  a35=(a35+a43);
  a35=(a35+a25);
  a67=(a67*a35);
  a63=(a63-a67);
  a52=(a52*a83);
  a48=(a23+a48);
  a48=(a02*a48);
  a52=(a52+a48);
  a52=(a26+a52);
  a36=(a52/a36);
  a81=(a81*a35);
  a36=(a36-a81);
  a81=(a74*a36);
  a73=(a73*a11);
  a68=(a68*a83);
  a18=(a18-a23);
  a18=(a02*a18);
  a68=(a68+a18);
  a68=(a68-a26);
  a68=(a04*a68);
  a73=(a73+a68);
  a75=(a75*a83);
  a55=(a55*a11);
  a07=(a04*a07);
  a55=(a55+a07);
  a53=(a53*a11);
  a04=(a04*a27);
  a53=(a53+a04);
  a55=(a55-a53);
  a55=(a02*a55);
  a75=(a75+a55);
  a73=(a73+a75);
  a60=(a60*a36);
  a34=(a77*a34);
  a60=(a60+a34);
  a73=(a73+a60);
  a73=(a73/a79);
  a47=(a47*a83);
  a02=(a02*a23);
  a47=(a47+a02);
  a26=(a26+a47);
  a52=(a77*a52);
  a76=(a76*a36);
  a52=(a52+a76);
  a26=(a26-a52);
  a71=(a71*a26);
  a73=(a73-a71);
  a71=(a77*a73);
  a81=(a81+a71);
  a63=(a63+a81);
  if (res[1]!=0) res[1][1]=a63;
  if (res[1]!=0) res[1][2]=a73;
  a69=(2.*a69);
  a82=(a82-a69);
  if (res[1]!=0) res[1][3]=a82;
  a82=arg[1]? arg[1][0] : 0;
  a16=(a16-a82);
  if (res[2]!=0) res[2][0]=a16;
  a77=(a77*a74);
  a31=(a31+a77);
  a77=arg[1]? arg[1][1] : 0;
  a31=(a31-a77);
  if (res[2]!=0) res[2][1]=a31;
  a31=arg[1]? arg[1][2] : 0;
  a74=(a74-a31);
  if (res[2]!=0) res[2][2]=a74;
  a09=(2.*a09);
  a15=(a15-a09);
  if (res[2]!=0) res[2][3]=a15;
  return 0;
}

/* round_feet_jacobian_along_12:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_12_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_12_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_24:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_24_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_36:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_36_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_48:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f93(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f93(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_48_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_72:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f94(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f94(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_72_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_96:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f95(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f95(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_96_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_144:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f96(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_144_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_192:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f97(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f97(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_192_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_288:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f98(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f98(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_288_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_along_384:(u[4],p[7],d[7])->(J[4x4],R_d[4],R[4]) */
static int casadi_f99(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+778, *w01=w+782, *w02=w+785, *w03=w+792, *w04=w+799, w05, w06, w07, *w08=w+819, *w09=w+843;
  casadi_real *w10=w+863, *w11=w+879;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w00);
  /* #1: @1 = @0[:3] */
  for (rr=w01, cs=w00+0; cs!=w00+3; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 7, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 7, w03);
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

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f99(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void round_feet_jacobian_along_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_384_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int round_feet_jacobian_along_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real round_feet_jacobian_along_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* round_feet_jacobian_along_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* round_feet_jacobian_along_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 883;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_along_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 883*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[4],phase[2],turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f102(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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

/* observe:(t,y[4],p[7])->(g[8],dg[8]) */
static int casadi_f103(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92, a93, a94, a95;
  casadi_real a96, a97;
  a00=arg[2]? arg[2][1] : 0;
  a01=arg[2]? arg[2][0] : 0;
  a02=(2.*a00);
  a03=(a01+a02);
  a04=(a00/a03);
  a05=arg[1]? arg[1][0] : 0;
  a06=cos(a05);
  a07=arg[2]? arg[2][4] : 0;
  a08=(a06*a07);
  a09=arg[1]? arg[1][1] : 0;
  a10=(a05-a09);
  a11=cos(a10);
  a12=(a11*a07);
  a13=(a08+a12);
  a14=arg[2]? arg[2][3] : 0;
  a15=sin(a05);
  a16=(a14*a15);
  a13=(a13+a16);
  a10=sin(a10);
  a16=(a14*a10);
  a13=(a13+a16);
  a17=(2.*a15);
  a13=(a13-a17);
  a13=(a04*a13);
  a17=(a01*a15);
  a17=(a17/a03);
  a13=(a13-a17);
  a17=arg[2]? arg[2][5] : 0;
  a18=(a05*a17);
  a13=(a13-a18);
  a19=(a06*a01);
  a19=(a19/a03);
  a20=(2.*a06);
  a21=(a06*a14);
  a22=(a20-a21);
  a23=(a11*a14);
  a22=(a22-a23);
  a24=(a07*a15);
  a22=(a22+a24);
  a24=(a07*a10);
  a22=(a22+a24);
  a22=(a04*a22);
  a19=(a19+a22);
  a19=(a19+a17);
  a22=(2.*a07);
  a24=arg[1]? arg[1][2] : 0;
  a25=(a22*a24);
  a26=arg[1]? arg[1][3] : 0;
  a27=(a25*a26);
  a28=(a09-a05);
  a29=arg[2]? arg[2][6] : 0;
  a28=(a28+a29);
  a30=cos(a28);
  a31=(a30*a07);
  a28=sin(a28);
  a32=(a14*a28);
  a33=(a31-a32);
  a34=casadi_sq(a24);
  a35=sin(a09);
  a36=(a14*a35);
  a37=cos(a09);
  a38=(a37*a07);
  a36=(a36-a38);
  a39=(a34*a36);
  a33=(a33+a39);
  a33=(a00*a33);
  a39=(a37*a14);
  a40=casadi_sq(a14);
  a41=(a39-a40);
  a42=casadi_sq(a07);
  a41=(a41-a42);
  a43=(a07*a35);
  a41=(a41+a43);
  a44=(a07*a17);
  a45=(a44*a10);
  a41=(a41-a45);
  a23=(a23*a17);
  a41=(a41+a23);
  a41=(a00*a41);
  a46=arg[2]? arg[2][2] : 0;
  a41=(a41-a46);
  a47=(a01*a17);
  a47=(a47*a17);
  a20=(a20*a17);
  a48=(a01*a20);
  a47=(a47+a48);
  a47=(a47+a01);
  a48=(2.*a46);
  a47=(a47+a48);
  a48=(a44*a15);
  a21=(a21*a17);
  a48=(a48-a21);
  a48=(a48-a39);
  a48=(a48-a14);
  a48=(a48-a43);
  a43=casadi_sq(a17);
  a48=(a48+a43);
  a48=(a48+a20);
  a48=(a48+a45);
  a48=(a48-a23);
  a40=(a40+a42);
  a48=(a48+a40);
  a42=1.;
  a48=(a48+a42);
  a48=(a02*a48);
  a47=(a47+a48);
  a48=(a41/a47);
  a42=(a34*a17);
  a23=(a42*a15);
  a45=2.;
  a45=(a45-a14);
  a45=(a00*a45);
  a45=(a01+a45);
  a23=(a23*a45);
  a20=(2.*a24);
  a43=(a20*a26);
  a43=(a43-a34);
  a39=casadi_sq(a26);
  a43=(a43-a39);
  a39=(a17*a43);
  a21=(a12*a39);
  a21=(a21-a31);
  a49=(a06*a17);
  a50=(a07*a24);
  a51=(a50*a24);
  a52=(a49*a51);
  a21=(a21-a52);
  a53=(a05-a29);
  a54=cos(a53);
  a55=(a54*a07);
  a21=(a21-a55);
  a56=(a38*a26);
  a57=(a20-a26);
  a58=(a56*a57);
  a21=(a21+a58);
  a59=(a14*a26);
  a60=(a59*a35);
  a61=(a60*a57);
  a21=(a21-a61);
  a21=(a21+a32);
  a62=(a16*a39);
  a21=(a21+a62);
  a21=(a00*a21);
  a21=(a23+a21);
  a62=sin(a29);
  a63=(a17*a62);
  a63=(a63*a03);
  a21=(a21-a63);
  a53=sin(a53);
  a64=(a53*a45);
  a21=(a21+a64);
  a65=(a48*a21);
  a65=(a33-a65);
  a40=(a00*a40);
  a46=(a46+a40);
  a40=(a41*a48);
  a46=(a46-a40);
  a65=(a65/a46);
  a40=(a65*a14);
  a40=(a27-a40);
  a66=(a07*a26);
  a67=(a66*a26);
  a40=(a40-a67);
  a68=(a21/a47);
  a69=(a48*a65);
  a69=(a68-a69);
  a70=(a69*a14);
  a70=(a51-a70);
  a40=(a40-a70);
  a71=(a11*a40);
  a72=(a59*a26);
  a73=(a65*a07);
  a73=(a72-a73);
  a74=(2.*a14);
  a75=(a74*a24);
  a76=(a75*a26);
  a73=(a73-a76);
  a77=(a69*a07);
  a78=(a14*a24);
  a79=(a78*a24);
  a77=(a77+a79);
  a73=(a73+a77);
  a80=(a10*a73);
  a71=(a71-a80);
  a71=(a00*a71);
  a80=(a69*a01);
  a81=(2.*a69);
  a81=(a81+a70);
  a81=(a00*a81);
  a80=(a80+a81);
  a81=(a06*a80);
  a69=(a69*a17);
  a69=(a69*a03);
  a81=(a81+a69);
  a71=(a71-a81);
  a81=(a34*a01);
  a69=(a20*a24);
  a77=(a77-a69);
  a77=(a00*a77);
  a70=(a81-a77);
  a82=(a15*a70);
  a71=(a71+a82);
  a62=(a62*a03);
  a71=(a71-a62);
  a82=(a19*a71);
  a77=(a77-a81);
  a83=(a06*a77);
  a29=cos(a29);
  a29=(a29*a03);
  a83=(a83+a29);
  a84=(a11*a73);
  a85=(a10*a40);
  a84=(a84+a85);
  a84=(a00*a84);
  a83=(a83+a84);
  a84=(a15*a80);
  a83=(a83-a84);
  a82=(a82/a83);
  a13=(a13-a82);
  a13=(a13+a18);
  a13=(-a13);
  if (res[0]!=0) res[0][0]=a13;
  a13=0.;
  if (res[0]!=0) res[0][1]=a13;
  a18=(a12*a17);
  a84=(a18*a43);
  a84=(a84-a31);
  a52=(a84-a52);
  a52=(a52-a55);
  a52=(a52+a58);
  a52=(a52-a61);
  a31=(a14*a17);
  a85=(a31*a10);
  a86=(a85*a43);
  a52=(a52+a86);
  a52=(a52+a32);
  a52=(a00*a52);
  a52=(a23+a52);
  a52=(a52-a63);
  a52=(a52+a64);
  a87=(a52/a47);
  a88=(a48*a52);
  a88=(a33-a88);
  a88=(a88/a46);
  a89=(a48*a88);
  a89=(a87-a89);
  a90=(a89*a07);
  a90=(a90+a79);
  a69=(a90-a69);
  a69=(a00*a69);
  a79=(a69-a81);
  a91=(a06*a79);
  a91=(a91+a29);
  a29=(a88*a07);
  a72=(a72-a29);
  a72=(a72-a76);
  a72=(a72+a90);
  a90=(a11*a72);
  a76=(a88*a14);
  a27=(a27-a76);
  a27=(a27-a67);
  a67=(a89*a14);
  a67=(a51-a67);
  a27=(a27-a67);
  a76=(a10*a27);
  a90=(a90+a76);
  a90=(a00*a90);
  a91=(a91+a90);
  a90=(a89*a01);
  a76=(2.*a89);
  a76=(a76+a67);
  a76=(a00*a76);
  a90=(a90+a76);
  a76=(a15*a90);
  a91=(a91-a76);
  if (res[0]!=0) res[0][2]=a91;
  a76=(a11*a27);
  a67=(a10*a72);
  a76=(a76-a67);
  a76=(a00*a76);
  a67=(a06*a90);
  a89=(a89*a17);
  a89=(a89*a03);
  a67=(a67+a89);
  a76=(a76-a67);
  a81=(a81-a69);
  a69=(a15*a81);
  a76=(a76+a69);
  a76=(a76-a62);
  a76=(a76/a91);
  if (res[0]!=0) res[0][3]=a76;
  a62=(a06-a11);
  a62=(a62+a17);
  if (res[0]!=0) res[0][4]=a62;
  a62=(a08*a24);
  a69=(a62*a24);
  a69=(a69*a17);
  a84=(a84-a69);
  a84=(a84-a55);
  a84=(a84+a58);
  a84=(a84-a61);
  a84=(a84+a86);
  a84=(a84+a32);
  a84=(a00*a84);
  a23=(a23+a84);
  a23=(a23-a63);
  a23=(a23+a64);
  a64=(a23/a47);
  a63=(a48*a23);
  a33=(a33-a63);
  a33=(a33/a46);
  a63=(a48*a33);
  a63=(a64-a63);
  if (res[0]!=0) res[0][5]=a63;
  a05=(2.*a05);
  a09=(a09-a05);
  if (res[0]!=0) res[0][6]=a09;
  if (res[0]!=0) res[0][7]=a13;
  a09=(a06*a24);
  a05=(a14*a09);
  a84=(a15*a24);
  a32=(a07*a84);
  a86=(a24-a26);
  a61=(a10*a86);
  a58=(a07*a61);
  a55=(a32+a58);
  a05=(a05-a55);
  a86=(a11*a86);
  a55=(a14*a86);
  a05=(a05+a55);
  a69=(2.*a09);
  a05=(a05-a69);
  a05=(a04*a05);
  a69=(a01*a09);
  a69=(a69/a03);
  a05=(a05-a69);
  a69=(a17*a24);
  a05=(a05-a69);
  a67=(-a84);
  a67=(2.*a67);
  a89=(a14*a84);
  a29=(a67+a89);
  a92=(a14*a61);
  a29=(a29+a92);
  a93=(a07*a09);
  a29=(a29+a93);
  a93=(a07*a86);
  a29=(a29+a93);
  a04=(a04*a29);
  a29=(a01*a84);
  a29=(a29/a03);
  a04=(a04-a29);
  a71=(a71*a04);
  a22=(a22*a63);
  a22=(a26*a22);
  a25=(a25*a33);
  a22=(a22+a25);
  a25=(a20*a63);
  a36=(a36*a25);
  a37=(a37*a26);
  a04=(a14*a37);
  a29=(a35*a26);
  a93=(a07*a29);
  a04=(a04+a93);
  a34=(a34*a04);
  a36=(a36+a34);
  a34=(a26-a24);
  a28=(a28*a34);
  a28=(a07*a28);
  a30=(a30*a34);
  a30=(a14*a30);
  a34=(a28+a30);
  a36=(a36-a34);
  a36=(a00*a36);
  a34=(a07*a37);
  a29=(a14*a29);
  a04=(a34-a29);
  a94=(a44*a86);
  a04=(a04-a94);
  a92=(a17*a92);
  a04=(a04-a92);
  a04=(a00*a04);
  a95=(a04/a47);
  a96=(a48/a47);
  a67=(a17*a67);
  a97=(a01*a67);
  a44=(a44*a09);
  a89=(a17*a89);
  a44=(a44+a89);
  a44=(a44+a29);
  a44=(a44-a34);
  a44=(a44+a67);
  a44=(a44+a94);
  a44=(a44+a92);
  a02=(a02*a44);
  a97=(a97+a02);
  a96=(a96*a97);
  a95=(a95-a96);
  a21=(a21*a95);
  a96=(a17*a25);
  a96=(a15*a96);
  a42=(a42*a09);
  a96=(a96+a42);
  a96=(a45*a96);
  a42=(2.*a63);
  a02=(a26*a42);
  a44=(a20*a33);
  a02=(a02+a44);
  a02=(a02-a25);
  a44=(2.*a26);
  a44=(a44*a33);
  a02=(a02-a44);
  a44=(a17*a02);
  a12=(a12*a44);
  a92=(a39*a58);
  a12=(a12-a92);
  a12=(a12+a28);
  a92=(a07*a63);
  a92=(a24*a92);
  a50=(a50*a63);
  a92=(a92+a50);
  a49=(a49*a92);
  a50=(a17*a84);
  a51=(a51*a50);
  a49=(a49-a51);
  a12=(a12-a49);
  a53=(a53*a24);
  a53=(a07*a53);
  a12=(a12+a53);
  a38=(a38*a33);
  a93=(a26*a93);
  a38=(a38-a93);
  a38=(a57*a38);
  a93=(a42-a33);
  a56=(a56*a93);
  a38=(a38+a56);
  a12=(a12+a38);
  a56=(a14*a33);
  a35=(a35*a56);
  a37=(a59*a37);
  a35=(a35+a37);
  a57=(a57*a35);
  a60=(a60*a93);
  a57=(a57+a60);
  a12=(a12-a57);
  a12=(a12+a30);
  a39=(a39*a55);
  a16=(a16*a44);
  a39=(a39+a16);
  a12=(a12+a39);
  a12=(a00*a12);
  a12=(a96+a12);
  a54=(a54*a24);
  a45=(a45*a54);
  a12=(a12+a45);
  a54=(a48*a12);
  a21=(a21+a54);
  a21=(a36-a21);
  a21=(a21/a46);
  a54=(a65/a46);
  a04=(a48*a04);
  a41=(a41*a95);
  a04=(a04+a41);
  a54=(a54*a04);
  a21=(a21+a54);
  a54=(a14*a21);
  a54=(a22-a54);
  a41=(a07*a33);
  a41=(a26*a41);
  a66=(a66*a33);
  a41=(a41+a66);
  a54=(a54-a41);
  a12=(a12/a47);
  a68=(a68/a47);
  a68=(a68*a97);
  a12=(a12-a68);
  a65=(a65*a95);
  a68=(a48*a21);
  a65=(a65+a68);
  a12=(a12-a65);
  a65=(a14*a12);
  a65=(a92-a65);
  a54=(a54-a65);
  a68=(a11*a54);
  a66=(a40*a61);
  a68=(a68-a66);
  a66=(a73*a86);
  a56=(a26*a56);
  a59=(a59*a33);
  a56=(a56+a59);
  a21=(a07*a21);
  a21=(a56-a21);
  a74=(a74*a63);
  a74=(a26*a74);
  a75=(a75*a33);
  a74=(a74+a75);
  a21=(a21-a74);
  a75=(a07*a12);
  a59=(a14*a63);
  a59=(a24*a59);
  a78=(a78*a63);
  a59=(a59+a78);
  a75=(a75+a59);
  a21=(a21+a75);
  a78=(a10*a21);
  a66=(a66+a78);
  a68=(a68-a66);
  a68=(a00*a68);
  a66=(a01*a12);
  a78=(2.*a12);
  a78=(a78+a65);
  a78=(a00*a78);
  a66=(a66+a78);
  a78=(a06*a66);
  a65=(a80*a84);
  a78=(a78-a65);
  a12=(a17*a12);
  a12=(a03*a12);
  a78=(a78+a12);
  a68=(a68-a78);
  a70=(a70*a09);
  a78=(a01*a25);
  a42=(a24*a42);
  a42=(a42+a25);
  a75=(a75-a42);
  a75=(a00*a75);
  a25=(a78-a75);
  a25=(a15*a25);
  a70=(a70+a25);
  a68=(a68+a70);
  a19=(a19*a68);
  a71=(a71+a19);
  a71=(a71/a83);
  a82=(a82/a83);
  a75=(a75-a78);
  a75=(a06*a75);
  a77=(a77*a84);
  a75=(a75-a77);
  a21=(a11*a21);
  a73=(a73*a61);
  a21=(a21-a73);
  a40=(a40*a86);
  a54=(a10*a54);
  a40=(a40+a54);
  a21=(a21+a40);
  a21=(a00*a21);
  a75=(a75+a21);
  a80=(a80*a09);
  a66=(a15*a66);
  a80=(a80+a66);
  a75=(a75-a80);
  a82=(a82*a75);
  a71=(a71-a82);
  a05=(a05-a71);
  a05=(a05+a69);
  a05=(-a05);
  if (res[1]!=0) res[1][0]=a05;
  if (res[1]!=0) res[1][1]=a13;
  a18=(a18*a02);
  a58=(a17*a58);
  a58=(a43*a58);
  a18=(a18-a58);
  a18=(a18+a28);
  a49=(a18-a49);
  a49=(a49+a53);
  a49=(a49+a38);
  a49=(a49-a57);
  a31=(a31*a86);
  a43=(a43*a31);
  a85=(a85*a02);
  a43=(a43+a85);
  a49=(a49+a43);
  a49=(a49+a30);
  a49=(a00*a49);
  a49=(a96+a49);
  a49=(a49+a45);
  a85=(a49/a47);
  a87=(a87/a47);
  a87=(a87*a97);
  a85=(a85-a87);
  a87=(a88*a95);
  a52=(a52*a95);
  a49=(a48*a49);
  a52=(a52+a49);
  a52=(a36-a52);
  a52=(a52/a46);
  a88=(a88/a46);
  a88=(a88*a04);
  a52=(a52+a88);
  a88=(a48*a52);
  a87=(a87+a88);
  a85=(a85-a87);
  a87=(a07*a85);
  a87=(a87+a59);
  a42=(a87-a42);
  a42=(a00*a42);
  a59=(a42-a78);
  a59=(a06*a59);
  a79=(a79*a84);
  a59=(a59-a79);
  a07=(a07*a52);
  a56=(a56-a07);
  a56=(a56-a74);
  a56=(a56+a87);
  a87=(a11*a56);
  a74=(a72*a61);
  a87=(a87-a74);
  a74=(a27*a86);
  a52=(a14*a52);
  a22=(a22-a52);
  a22=(a22-a41);
  a14=(a14*a85);
  a92=(a92-a14);
  a22=(a22-a92);
  a14=(a10*a22);
  a74=(a74+a14);
  a87=(a87+a74);
  a87=(a00*a87);
  a59=(a59+a87);
  a87=(a90*a09);
  a01=(a01*a85);
  a74=(2.*a85);
  a74=(a74+a92);
  a74=(a00*a74);
  a01=(a01+a74);
  a74=(a15*a01);
  a87=(a87+a74);
  a59=(a59-a87);
  if (res[1]!=0) res[1][2]=a59;
  a11=(a11*a22);
  a27=(a27*a61);
  a11=(a11-a27);
  a72=(a72*a86);
  a10=(a10*a56);
  a72=(a72+a10);
  a11=(a11-a72);
  a11=(a00*a11);
  a06=(a06*a01);
  a90=(a90*a84);
  a06=(a06-a90);
  a85=(a17*a85);
  a03=(a03*a85);
  a06=(a06+a03);
  a11=(a11-a06);
  a81=(a81*a09);
  a78=(a78-a42);
  a15=(a15*a78);
  a81=(a81+a15);
  a11=(a11+a81);
  a11=(a11/a91);
  a76=(a76/a91);
  a76=(a76*a59);
  a11=(a11-a76);
  if (res[1]!=0) res[1][3]=a11;
  a61=(a61-a84);
  if (res[1]!=0) res[1][4]=a61;
  a08=(a08*a63);
  a32=(a24*a32);
  a08=(a08-a32);
  a24=(a24*a08);
  a62=(a62*a63);
  a24=(a24+a62);
  a17=(a17*a24);
  a18=(a18-a17);
  a18=(a18+a53);
  a18=(a18+a38);
  a18=(a18-a57);
  a18=(a18+a43);
  a18=(a18+a30);
  a00=(a00*a18);
  a96=(a96+a00);
  a96=(a96+a45);
  a45=(a96/a47);
  a64=(a64/a47);
  a64=(a64*a97);
  a45=(a45-a64);
  a64=(a33*a95);
  a23=(a23*a95);
  a96=(a48*a96);
  a23=(a23+a96);
  a36=(a36-a23);
  a36=(a36/a46);
  a33=(a33/a46);
  a33=(a33*a04);
  a36=(a36+a33);
  a48=(a48*a36);
  a64=(a64+a48);
  a45=(a45-a64);
  if (res[1]!=0) res[1][5]=a45;
  a26=(a26-a20);
  if (res[1]!=0) res[1][6]=a26;
  if (res[1]!=0) res[1][7]=a13;
  return 0;
}

/* working_steps:(t,turns[2x12],w[4],h,p[7])->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f101(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+98, w01, *w02=w+102, *w03=w+109, w05, *w06=w+111, w07, *w08=w+115, *w09=w+119, *w10=w+123, *w11=w+127;
  casadi_real *w12=w+131, *w13=w+135, *w14=w+139, *w15=w+143, *w16=w+147, *w17=w+151, *w18=w+155, *w19=w+159, *w20=w+167, *w21=w+175, *w22=w+183, *w23=w+191;
  casadi_real *w24=w+199, *w25=w+207, *w26=w+215, *w27=w+223, *w28=w+231, *w29=w+239, *w30=w+247, *w31=w+255;
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

/* round_feet_trace_48:(u[4],p[7])->(w[4x49],g[8x49],dg[8x49],R[4]) */
static int casadi_f100(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1156;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f100(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1164;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1164*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_72:(u[4],p[7])->(w[4x73],g[8x73],dg[8x73],R[4]) */
static int casadi_f104(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1244, *w19=w+1340, *w20=w+1436, *w21=w+1532;
  casadi_real *w22=w+1540;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f104(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1548;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1548*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_96:(u[4],p[7])->(w[4x97],g[8x97],dg[8x97],R[4]) */
static int casadi_f105(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1244, *w19=w+1340, *w20=w+1436, *w21=w+1532;
  casadi_real *w22=w+1628, *w23=w+1724, *w24=w+1820, *w25=w+1916, *w26=w+1924;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f105(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1932;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1932*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_144:(u[4],p[7])->(w[4x145],g[8x145],dg[8x145],R[4]) */
static int casadi_f106(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1244, *w19=w+1340, *w20=w+1436, *w21=w+1532;
  casadi_real *w22=w+1628, *w23=w+1724, *w24=w+1820, *w25=w+1916, *w26=w+2012, *w27=w+2108, *w28=w+2204, *w29=w+2300, *w30=w+2396, *w31=w+2492, *w32=w+2588, *w33=w+2684;
  casadi_real *w34=w+2692;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f106(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 2700;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2700*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_192:(u[4],p[7])->(w[4x193],g[8x193],dg[8x193],R[4]) */
static int casadi_f107(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1244, *w19=w+1340, *w20=w+1436, *w21=w+1532;
  casadi_real *w22=w+1628, *w23=w+1724, *w24=w+1820, *w25=w+1916, *w26=w+2012, *w27=w+2108, *w28=w+2204, *w29=w+2300, *w30=w+2396, *w31=w+2492, *w32=w+2588, *w33=w+2684;
  casadi_real *w34=w+2780, *w35=w+2876, *w36=w+2972, *w37=w+3068, *w38=w+3164, *w39=w+3260, *w40=w+3356, *w41=w+3452, *w42=w+3460;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f107(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 3468;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3468*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_288:(u[4],p[7])->(w[4x289],g[8x289],dg[8x289],R[4]) */
static int casadi_f108(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1244, *w19=w+1340, *w20=w+1436, *w21=w+1532;
  casadi_real *w22=w+1628, *w23=w+1724, *w24=w+1820, *w25=w+1916, *w26=w+2012, *w27=w+2108, *w28=w+2204, *w29=w+2300, *w30=w+2396, *w31=w+2492, *w32=w+2588, *w33=w+2684;
  casadi_real *w34=w+2780, *w35=w+2876, *w36=w+2972, *w37=w+3068, *w38=w+3164, *w39=w+3260, *w40=w+3356, *w41=w+3452, *w42=w+3548, *w43=w+3644, *w44=w+3740, *w45=w+3836;
  casadi_real *w46=w+3932, *w47=w+4028, *w48=w+4124, *w49=w+4220, *w50=w+4316, *w51=w+4412, *w52=w+4508, *w53=w+4604, *w54=w+4700, *w55=w+4796, *w56=w+4892, *w57=w+4988;
  casadi_real *w58=w+4996;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f108(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 5004;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 5004*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_384:(u[4],p[7])->(w[4x385],g[8x385],dg[8x385],R[4]) */
static int casadi_f109(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+290, w02, w03, *w04=w+294, *w05=w+301, *w06=w+325, *w07=w+328, *w08=w+332, *w09=w+380;
  casadi_real *w10=w+476, *w11=w+572, *w12=w+668, *w13=w+764, *w14=w+860, *w15=w+956, *w16=w+1052, *w17=w+1148, *w18=w+1244, *w19=w+1340, *w20=w+1436, *w21=w+1532;
  casadi_real *w22=w+1628, *w23=w+1724, *w24=w+1820, *w25=w+1916, *w26=w+2012, *w27=w+2108, *w28=w+2204, *w29=w+2300, *w30=w+2396, *w31=w+2492, *w32=w+2588, *w33=w+2684;
  casadi_real *w34=w+2780, *w35=w+2876, *w36=w+2972, *w37=w+3068, *w38=w+3164, *w39=w+3260, *w40=w+3356, *w41=w+3452, *w42=w+3548, *w43=w+3644, *w44=w+3740, *w45=w+3836;
  casadi_real *w46=w+3932, *w47=w+4028, *w48=w+4124, *w49=w+4220, *w50=w+4316, *w51=w+4412, *w52=w+4508, *w53=w+4604, *w54=w+4700, *w55=w+4796, *w56=w+4892, *w57=w+4988;
  casadi_real *w58=w+5084, *w59=w+5180, *w60=w+5276, *w61=w+5372, *w62=w+5468, *w63=w+5564, *w64=w+5660, *w65=w+5756, *w66=w+5852, *w67=w+5948, *w68=w+6044, *w69=w+6140;
  casadi_real *w70=w+6236, *w71=w+6332, *w72=w+6428, *w73=w+6524, *w74=w+6532;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f109(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 6540;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6540*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_576:(u[4],p[7])->(w[4x577],g[8x577],dg[8x577],R[4]) */
static int casadi_f110(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+290, w002, w003, *w004=w+294, *w005=w+301, *w006=w+325, *w007=w+328, *w008=w+332, *w009=w+380;
  casadi_real *w010=w+476, *w011=w+572, *w012=w+668, *w013=w+764, *w014=w+860, *w015=w+956, *w016=w+1052, *w017=w+1148, *w018=w+1244, *w019=w+1340, *w020=w+1436, *w021=w+1532;
  casadi_real *w022=w+1628, *w023=w+1724, *w024=w+1820, *w025=w+1916, *w026=w+2012, *w027=w+2108, *w028=w+2204, *w029=w+2300, *w030=w+2396, *w031=w+2492, *w032=w+2588, *w033=w+2684;
  casadi_real *w034=w+2780, *w035=w+2876, *w036=w+2972, *w037=w+3068, *w038=w+3164, *w039=w+3260, *w040=w+3356, *w041=w+3452, *w042=w+3548, *w043=w+3644, *w044=w+3740, *w045=w+3836;
  casadi_real *w046=w+3932, *w047=w+4028, *w048=w+4124, *w049=w+4220, *w050=w+4316, *w051=w+4412, *w052=w+4508, *w053=w+4604, *w054=w+4700, *w055=w+4796, *w056=w+4892, *w057=w+4988;
  casadi_real *w058=w+5084, *w059=w+5180, *w060=w+5276, *w061=w+5372, *w062=w+5468, *w063=w+5564, *w064=w+5660, *w065=w+5756, *w066=w+5852, *w067=w+5948, *w068=w+6044, *w069=w+6140;
  casadi_real *w070=w+6236, *w071=w+6332, *w072=w+6428, *w073=w+6524, *w074=w+6620, *w075=w+6716, *w076=w+6812, *w077=w+6908, *w078=w+7004, *w079=w+7100, *w080=w+7196, *w081=w+7292;
  casadi_real *w082=w+7388, *w083=w+7484, *w084=w+7580, *w085=w+7676, *w086=w+7772, *w087=w+7868, *w088=w+7964, *w089=w+8060, *w090=w+8156, *w091=w+8252, *w092=w+8348, *w093=w+8444;
  casadi_real *w094=w+8540, *w095=w+8636, *w096=w+8732, *w097=w+8828, *w098=w+8924, *w099=w+9020, *w100=w+9116, *w101=w+9212, *w102=w+9308, *w103=w+9404, *w104=w+9500, *w105=w+9596;
  casadi_real *w106=w+9604;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f110(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 9612;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 9612*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_768:(u[4],p[7])->(w[4x769],g[8x769],dg[8x769],R[4]) */
static int casadi_f111(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+290, w002, w003, *w004=w+294, *w005=w+301, *w006=w+325, *w007=w+328, *w008=w+332, *w009=w+380;
  casadi_real *w010=w+476, *w011=w+572, *w012=w+668, *w013=w+764, *w014=w+860, *w015=w+956, *w016=w+1052, *w017=w+1148, *w018=w+1244, *w019=w+1340, *w020=w+1436, *w021=w+1532;
  casadi_real *w022=w+1628, *w023=w+1724, *w024=w+1820, *w025=w+1916, *w026=w+2012, *w027=w+2108, *w028=w+2204, *w029=w+2300, *w030=w+2396, *w031=w+2492, *w032=w+2588, *w033=w+2684;
  casadi_real *w034=w+2780, *w035=w+2876, *w036=w+2972, *w037=w+3068, *w038=w+3164, *w039=w+3260, *w040=w+3356, *w041=w+3452, *w042=w+3548, *w043=w+3644, *w044=w+3740, *w045=w+3836;
  casadi_real *w046=w+3932, *w047=w+4028, *w048=w+4124, *w049=w+4220, *w050=w+4316, *w051=w+4412, *w052=w+4508, *w053=w+4604, *w054=w+4700, *w055=w+4796, *w056=w+4892, *w057=w+4988;
  casadi_real *w058=w+5084, *w059=w+5180, *w060=w+5276, *w061=w+5372, *w062=w+5468, *w063=w+5564, *w064=w+5660, *w065=w+5756, *w066=w+5852, *w067=w+5948, *w068=w+6044, *w069=w+6140;
  casadi_real *w070=w+6236, *w071=w+6332, *w072=w+6428, *w073=w+6524, *w074=w+6620, *w075=w+6716, *w076=w+6812, *w077=w+6908, *w078=w+7004, *w079=w+7100, *w080=w+7196, *w081=w+7292;
  casadi_real *w082=w+7388, *w083=w+7484, *w084=w+7580, *w085=w+7676, *w086=w+7772, *w087=w+7868, *w088=w+7964, *w089=w+8060, *w090=w+8156, *w091=w+8252, *w092=w+8348, *w093=w+8444;
  casadi_real *w094=w+8540, *w095=w+8636, *w096=w+8732, *w097=w+8828, *w098=w+8924, *w099=w+9020, *w100=w+9116, *w101=w+9212, *w102=w+9308, *w103=w+9404, *w104=w+9500, *w105=w+9596;
  casadi_real *w106=w+9692, *w107=w+9788, *w108=w+9884, *w109=w+9980, *w110=w+10076, *w111=w+10172, *w112=w+10268, *w113=w+10364, *w114=w+10460, *w115=w+10556, *w116=w+10652, *w117=w+10748;
  casadi_real *w118=w+10844, *w119=w+10940, *w120=w+11036, *w121=w+11132, *w122=w+11228, *w123=w+11324, *w124=w+11420, *w125=w+11516, *w126=w+11612, *w127=w+11708, *w128=w+11804, *w129=w+11900;
  casadi_real *w130=w+11996, *w131=w+12092, *w132=w+12188, *w133=w+12284, *w134=w+12380, *w135=w+12476, *w136=w+12572, *w137=w+12668, *w138=w+12676;
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

CASADI_SYMBOL_EXPORT int round_feet_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f111(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 12684;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12684*sizeof(casadi_real);
  return 0;
}

/* round_feet_advance:(t,w[4],h,p[7])->(w_end[4],g[8],dg[8]) */
static int casadi_f112(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+98, w1, *w2=w+102, *w3=w+109, w4, *w5=w+111, *w6=w+135, *w7=w+139, *w8=w+147;
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

CASADI_SYMBOL_EXPORT int round_feet_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f112(arg, res, iw, w, mem);
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
    case 1: return casadi_s26;
    case 2: return casadi_s26;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 155;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 155*sizeof(casadi_real);
  return 0;
}

/* round_feet_begin:(u[4],p[7])->(y[4x4]) */
static int casadi_f113(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  return casadi_f113(arg, res, iw, w, mem);
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
static int casadi_f114(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, w1, w2, *w3=w+584, *w4=w+591, *w5=w+615;
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
  return casadi_f114(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 631;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 631*sizeof(casadi_real);
  return 0;
}

/* round_feet_end:(y[4x4],u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f115(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  return casadi_f115(arg, res, iw, w, mem);
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

/* round_feet_observed_swing:(t,h,w[4],p[7])->(w_end[4],nodes[4x12],g[8x12],dg[8x12]) */
static int casadi_f116(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+290, *w3=w+297, *w4=w+321, *w5=w+325, *w6=w+329, *w7=w+377, *w8=w+473;
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

CASADI_SYMBOL_EXPORT int round_feet_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f116(arg, res, iw, w, mem);
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
    case 1: return casadi_s27;
    case 2: return casadi_s28;
    case 3: return casadi_s28;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int round_feet_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 569;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 569*sizeof(casadi_real);
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
