/* Rimless wheel: kernels of the solver
 * Printed by CasADi 3.8.2 from equations e67067441ccf2e08.
 * Do not edit: run `stridemap derive`.
 * SPDX-License-Identifier: BSD-3-Clause
 */
/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) rimless_wheel_kernels_ ## ID
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
#define casadi_clear CASADI_PREFIX(clear)
#define casadi_copy CASADI_PREFIX(copy)
#define casadi_dot CASADI_PREFIX(dot)
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_f1 CASADI_PREFIX(f1)
#define casadi_f10 CASADI_PREFIX(f10)
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

casadi_real casadi_sq(casadi_real x) { return x*x;}

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void rimless_wheel_kernels_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int rimless_wheel_kernels_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int rimless_wheel_kernels_casadi_real_size(void) { return (int) sizeof(casadi_real); }

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
static const casadi_int casadi_s5[3] = {3, 3, 1};
static const casadi_int casadi_s6[3] = {2, 49, 1};
static const casadi_int casadi_s7[3] = {8, 49, 1};
static const casadi_int casadi_s8[3] = {2, 73, 1};
static const casadi_int casadi_s9[3] = {8, 73, 1};
static const casadi_int casadi_s10[3] = {2, 97, 1};
static const casadi_int casadi_s11[3] = {8, 97, 1};
static const casadi_int casadi_s12[3] = {2, 145, 1};
static const casadi_int casadi_s13[3] = {8, 145, 1};
static const casadi_int casadi_s14[3] = {2, 193, 1};
static const casadi_int casadi_s15[3] = {8, 193, 1};
static const casadi_int casadi_s16[3] = {2, 289, 1};
static const casadi_int casadi_s17[3] = {8, 289, 1};
static const casadi_int casadi_s18[3] = {2, 385, 1};
static const casadi_int casadi_s19[3] = {8, 385, 1};
static const casadi_int casadi_s20[3] = {2, 577, 1};
static const casadi_int casadi_s21[3] = {8, 577, 1};
static const casadi_int casadi_s22[3] = {2, 769, 1};
static const casadi_int casadi_s23[3] = {8, 769, 1};
static const casadi_int casadi_s24[3] = {1, 1, 1};
static const casadi_int casadi_s25[3] = {2, 1, 1};
static const casadi_int casadi_s26[3] = {8, 1, 1};
static const casadi_int casadi_s27[3] = {2, 3, 1};
static const casadi_int casadi_s28[3] = {2, 12, 1};
static const casadi_int casadi_s29[3] = {8, 12, 1};

static const casadi_real casadi_zeros[24] = 
  {0.};

/* start:(z[2],p[3])->(y[2],dy_dz[2x2]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a0=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][1]=a0;
  a0=1.;
  if (res[1]!=0) res[1][0]=a0;
  a1=0.;
  if (res[1]!=0) res[1][1]=a1;
  if (res[1]!=0) res[1][2]=a1;
  if (res[1]!=0) res[1][3]=a0;
  return 0;
}

/* turns:(h,p[3])->(turns[2x12]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[2x3],phase[2],turns[2x12],h,p[3])->(y_end[2x3]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90;
  a00=arg[0]? arg[0][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[3]? arg[3][0] : 0;
  a01=(a01*a02);
  a03=arg[0]? arg[0][1] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[4]? arg[4][0] : 0;
  a08=(a07+a00);
  a09=sin(a08);
  a10=arg[4]? arg[4][2] : 0;
  a09=(a09*a10);
  a11=(a06*a09);
  a12=1.7082860872947386e-01;
  a12=(a12*a02);
  a13=2.9587585476806851e-02;
  a13=(a13*a02);
  a14=(a13*a03);
  a15=8.8762756430420545e-02;
  a15=(a15*a02);
  a16=1.9725056984537900e-02;
  a16=(a16*a02);
  a17=(a16*a09);
  a18=5.9175170953613701e-02;
  a18=(a18*a02);
  a19=5.2600151958767730e-02;
  a19=(a19*a02);
  a20=(a19*a03);
  a20=(a00+a20);
  a20=(a07+a20);
  a21=sin(a20);
  a21=(a21*a10);
  a21=(a18*a21);
  a17=(a17+a21);
  a17=(a03+a17);
  a21=(a15*a17);
  a14=(a14+a21);
  a14=(a00+a14);
  a14=(a07+a14);
  a21=sin(a14);
  a21=(a21*a10);
  a22=(a12*a21);
  a11=(a11+a22);
  a22=1.2546768756682242e-01;
  a22=(a22*a02);
  a23=2.4136513415926669e-01;
  a23=(a23*a02);
  a24=(a23*a03);
  a25=-8.8454947932828609e-01;
  a25=(a25*a02);
  a17=(a25*a17);
  a24=(a24+a17);
  a17=9.2483400326179199e-01;
  a17=(a17*a02);
  a26=(a13*a09);
  a27=(a16*a03);
  a28=(a19*a09);
  a28=(a03+a28);
  a28=(a18*a28);
  a27=(a27+a28);
  a27=(a00+a27);
  a27=(a07+a27);
  a28=sin(a27);
  a28=(a28*a10);
  a29=(a15*a28);
  a26=(a26+a29);
  a26=(a03+a26);
  a29=(a17*a26);
  a24=(a24+a29);
  a24=(a00+a24);
  a24=(a07+a24);
  a29=sin(a24);
  a29=(a29*a10);
  a30=(a22*a29);
  a11=(a11+a30);
  a11=(a03+a11);
  a30=(a05*a11);
  a04=(a04+a30);
  a30=1.8915178993145003e+00;
  a30=(a30*a02);
  a31=3.7109375000000000e-02;
  a31=(a31*a02);
  a32=(a31*a09);
  a33=1.7025221101954405e-01;
  a33=(a33*a02);
  a34=(a33*a21);
  a32=(a32+a34);
  a34=6.0216538980455959e-02;
  a34=(a34*a02);
  a35=(a34*a29);
  a32=(a32+a35);
  a35=-1.7578125000000000e-02;
  a35=(a35*a02);
  a36=(a06*a03);
  a37=(a12*a26);
  a36=(a36+a37);
  a37=(a23*a09);
  a28=(a25*a28);
  a37=(a37+a28);
  a28=(a17*a21);
  a37=(a37+a28);
  a37=(a03+a37);
  a28=(a22*a37);
  a36=(a36+a28);
  a36=(a00+a36);
  a36=(a07+a36);
  a28=sin(a36);
  a28=(a28*a10);
  a38=(a35*a28);
  a32=(a32+a38);
  a32=(a03+a32);
  a38=(a30*a32);
  a04=(a04+a38);
  a38=-5.8012039600105849e+00;
  a38=(a38*a02);
  a39=3.7092000118504789e-02;
  a39=(a39*a02);
  a40=(a39*a09);
  a41=1.7038392571223998e-01;
  a41=(a41*a02);
  a42=(a41*a21);
  a40=(a40+a42);
  a42=1.0726203044637328e-01;
  a42=(a42*a02);
  a43=(a42*a29);
  a40=(a40+a43);
  a43=-1.5319437748624402e-02;
  a43=(a43*a02);
  a44=(a43*a28);
  a40=(a40+a44);
  a44=8.2737891638140233e-03;
  a44=(a44*a02);
  a45=(a31*a03);
  a46=(a33*a26);
  a45=(a45+a46);
  a46=(a34*a37);
  a45=(a45+a46);
  a46=(a35*a11);
  a45=(a45+a46);
  a45=(a00+a45);
  a45=(a07+a45);
  a46=sin(a45);
  a46=(a46*a10);
  a47=(a44*a46);
  a40=(a40+a47);
  a40=(a03+a40);
  a47=(a38*a40);
  a04=(a04+a47);
  a47=3.1116436695781990e-01;
  a47=(a47*a02);
  a48=6.2411095871607569e-01;
  a48=(a48*a02);
  a49=(a48*a09);
  a50=-3.3608926294469414e+00;
  a50=(a50*a02);
  a51=(a50*a21);
  a49=(a49+a51);
  a51=-8.6821934684172597e-01;
  a51=(a51*a02);
  a52=(a51*a29);
  a49=(a49+a52);
  a52=2.7592099699446710e+01;
  a52=(a52*a02);
  a53=(a52*a28);
  a49=(a49+a53);
  a53=2.0154067550477894e+01;
  a53=(a53*a02);
  a54=(a53*a46);
  a49=(a49+a54);
  a54=-4.3489884181069961e+01;
  a54=(a54*a02);
  a55=(a39*a03);
  a56=(a41*a26);
  a55=(a55+a56);
  a56=(a42*a37);
  a55=(a55+a56);
  a56=(a43*a11);
  a55=(a55+a56);
  a56=(a44*a32);
  a55=(a55+a56);
  a55=(a00+a55);
  a55=(a07+a55);
  a56=sin(a55);
  a56=(a56*a10);
  a57=(a54*a56);
  a49=(a49+a57);
  a49=(a03+a49);
  a57=(a47*a49);
  a04=(a04+a57);
  a57=-1.5216094966251609e-01;
  a57=(a57*a02);
  a58=4.7766253643826434e-01;
  a58=(a58*a02);
  a59=(a58*a09);
  a60=-2.4881146199716677e+00;
  a60=(a60*a02);
  a61=(a60*a21);
  a59=(a59+a61);
  a61=-5.9029082683684297e-01;
  a61=(a61*a02);
  a62=(a61*a29);
  a59=(a59+a62);
  a62=2.1230051448181193e+01;
  a62=(a62*a02);
  a63=(a62*a28);
  a59=(a59+a63);
  a63=1.5279233632882423e+01;
  a63=(a63*a02);
  a64=(a63*a46);
  a59=(a59+a64);
  a64=-3.3288210968984863e+01;
  a64=(a64*a02);
  a65=(a64*a56);
  a59=(a59+a65);
  a65=-2.0331201708508627e-02;
  a65=(a65*a02);
  a66=(a48*a03);
  a67=(a50*a26);
  a66=(a66+a67);
  a67=(a51*a37);
  a66=(a66+a67);
  a67=(a52*a11);
  a66=(a66+a67);
  a67=(a53*a32);
  a66=(a66+a67);
  a67=(a54*a40);
  a66=(a66+a67);
  a66=(a00+a66);
  a66=(a07+a66);
  a67=sin(a66);
  a67=(a67*a10);
  a68=(a65*a67);
  a59=(a59+a68);
  a59=(a03+a59);
  a68=(a57*a59);
  a04=(a04+a68);
  a68=2.0136540080403034e-01;
  a68=(a68*a02);
  a69=-9.3714243008598730e-01;
  a69=(a69*a02);
  a70=(a69*a09);
  a71=5.1863724288440638e+00;
  a71=(a71*a02);
  a72=(a71*a21);
  a70=(a70+a72);
  a72=1.0914373489967295e+00;
  a72=(a72*a02);
  a73=(a72*a29);
  a70=(a70+a73);
  a73=-8.1497870107469268e+00;
  a73=(a73*a02);
  a74=(a73*a28);
  a70=(a70+a74);
  a74=-1.8520065659996959e+01;
  a74=(a74*a02);
  a75=(a74*a46);
  a70=(a70+a75);
  a75=2.2739487099350505e+01;
  a75=(a75*a02);
  a76=(a75*a56);
  a70=(a70+a76);
  a76=2.4936055526796523e+00;
  a76=(a76*a02);
  a77=(a76*a67);
  a70=(a70+a77);
  a77=-3.0467644718982196e+00;
  a77=(a77*a02);
  a78=(a58*a03);
  a79=(a60*a26);
  a78=(a78+a79);
  a79=(a61*a37);
  a78=(a78+a79);
  a79=(a62*a11);
  a78=(a78+a79);
  a79=(a63*a32);
  a78=(a78+a79);
  a79=(a64*a40);
  a78=(a78+a79);
  a79=(a65*a49);
  a78=(a78+a79);
  a78=(a00+a78);
  a78=(a07+a78);
  a79=sin(a78);
  a79=(a79*a10);
  a80=(a77*a79);
  a70=(a70+a80);
  a70=(a03+a70);
  a80=(a68*a70);
  a04=(a04+a80);
  a80=4.4710615727772587e-02;
  a80=(a80*a02);
  a81=2.2733101475165380e+00;
  a81=(a81*a02);
  a82=(a81*a09);
  a83=-1.0534495466737249e+01;
  a83=(a83*a02);
  a21=(a83*a21);
  a82=(a82+a21);
  a21=-2.0008720582248625e+00;
  a21=(a21*a02);
  a29=(a21*a29);
  a82=(a82+a29);
  a29=-1.7958931863118799e+01;
  a29=(a29*a02);
  a84=(a29*a28);
  a82=(a82+a84);
  a84=2.7948884529419960e+01;
  a84=(a84*a02);
  a85=(a84*a46);
  a82=(a82+a85);
  a85=-2.8589982771350235e+00;
  a85=(a85*a02);
  a86=(a85*a56);
  a82=(a82+a86);
  a86=-8.8728569335306293e+00;
  a86=(a86*a02);
  a87=(a86*a67);
  a82=(a82+a87);
  a87=1.2360567175794303e+01;
  a87=(a87*a02);
  a88=(a87*a79);
  a82=(a82+a88);
  a88=6.4339274601576357e-01;
  a88=(a88*a02);
  a02=(a69*a03);
  a89=(a71*a26);
  a02=(a02+a89);
  a89=(a72*a37);
  a02=(a02+a89);
  a89=(a73*a11);
  a02=(a02+a89);
  a89=(a74*a32);
  a02=(a02+a89);
  a89=(a75*a40);
  a02=(a02+a89);
  a89=(a76*a49);
  a02=(a02+a89);
  a89=(a77*a59);
  a02=(a02+a89);
  a02=(a00+a02);
  a02=(a07+a02);
  a89=sin(a02);
  a89=(a89*a10);
  a90=(a88*a89);
  a82=(a82+a90);
  a82=(a03+a82);
  a82=(a80*a82);
  a04=(a04+a82);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a09=(a01*a09);
  a28=(a05*a28);
  a09=(a09+a28);
  a46=(a30*a46);
  a09=(a09+a46);
  a56=(a38*a56);
  a09=(a09+a56);
  a67=(a47*a67);
  a09=(a09+a67);
  a79=(a57*a79);
  a09=(a09+a79);
  a89=(a68*a89);
  a09=(a09+a89);
  a89=(a81*a03);
  a26=(a83*a26);
  a89=(a89+a26);
  a37=(a21*a37);
  a89=(a89+a37);
  a11=(a29*a11);
  a89=(a89+a11);
  a32=(a84*a32);
  a89=(a89+a32);
  a40=(a85*a40);
  a89=(a89+a40);
  a49=(a86*a49);
  a89=(a89+a49);
  a59=(a87*a59);
  a89=(a89+a59);
  a70=(a88*a70);
  a89=(a89+a70);
  a00=(a00+a89);
  a07=(a07+a00);
  a00=sin(a07);
  a00=(a00*a10);
  a00=(a80*a00);
  a09=(a09+a00);
  a03=(a03+a09);
  if (res[0]!=0) res[0][1]=a03;
  a03=arg[0]? arg[0][2] : 0;
  a09=arg[0]? arg[0][3] : 0;
  a00=(a01*a09);
  a08=cos(a08);
  a08=(a08*a10);
  a89=(a08*a03);
  a70=(a06*a89);
  a14=cos(a14);
  a14=(a14*a10);
  a59=(a13*a09);
  a49=(a16*a89);
  a20=cos(a20);
  a20=(a20*a10);
  a40=(a19*a09);
  a40=(a03+a40);
  a40=(a20*a40);
  a40=(a18*a40);
  a49=(a49+a40);
  a49=(a09+a49);
  a40=(a15*a49);
  a59=(a59+a40);
  a59=(a03+a59);
  a59=(a14*a59);
  a40=(a12*a59);
  a70=(a70+a40);
  a24=cos(a24);
  a24=(a24*a10);
  a40=(a23*a09);
  a49=(a25*a49);
  a40=(a40+a49);
  a49=(a13*a89);
  a27=cos(a27);
  a27=(a27*a10);
  a32=(a16*a09);
  a11=(a19*a89);
  a11=(a09+a11);
  a11=(a18*a11);
  a32=(a32+a11);
  a32=(a03+a32);
  a32=(a27*a32);
  a11=(a15*a32);
  a49=(a49+a11);
  a49=(a09+a49);
  a11=(a17*a49);
  a40=(a40+a11);
  a40=(a03+a40);
  a40=(a24*a40);
  a11=(a22*a40);
  a70=(a70+a11);
  a70=(a09+a70);
  a11=(a05*a70);
  a00=(a00+a11);
  a11=(a31*a89);
  a37=(a33*a59);
  a11=(a11+a37);
  a37=(a34*a40);
  a11=(a11+a37);
  a36=cos(a36);
  a36=(a36*a10);
  a37=(a06*a09);
  a26=(a12*a49);
  a37=(a37+a26);
  a26=(a23*a89);
  a32=(a25*a32);
  a26=(a26+a32);
  a32=(a17*a59);
  a26=(a26+a32);
  a26=(a09+a26);
  a32=(a22*a26);
  a37=(a37+a32);
  a37=(a03+a37);
  a37=(a36*a37);
  a32=(a35*a37);
  a11=(a11+a32);
  a11=(a09+a11);
  a32=(a30*a11);
  a00=(a00+a32);
  a32=(a39*a89);
  a79=(a41*a59);
  a32=(a32+a79);
  a79=(a42*a40);
  a32=(a32+a79);
  a79=(a43*a37);
  a32=(a32+a79);
  a45=cos(a45);
  a45=(a45*a10);
  a79=(a31*a09);
  a67=(a33*a49);
  a79=(a79+a67);
  a67=(a34*a26);
  a79=(a79+a67);
  a67=(a35*a70);
  a79=(a79+a67);
  a79=(a03+a79);
  a79=(a45*a79);
  a67=(a44*a79);
  a32=(a32+a67);
  a32=(a09+a32);
  a67=(a38*a32);
  a00=(a00+a67);
  a67=(a48*a89);
  a56=(a50*a59);
  a67=(a67+a56);
  a56=(a51*a40);
  a67=(a67+a56);
  a56=(a52*a37);
  a67=(a67+a56);
  a56=(a53*a79);
  a67=(a67+a56);
  a55=cos(a55);
  a55=(a55*a10);
  a56=(a39*a09);
  a46=(a41*a49);
  a56=(a56+a46);
  a46=(a42*a26);
  a56=(a56+a46);
  a46=(a43*a70);
  a56=(a56+a46);
  a46=(a44*a11);
  a56=(a56+a46);
  a56=(a03+a56);
  a56=(a55*a56);
  a46=(a54*a56);
  a67=(a67+a46);
  a67=(a09+a67);
  a46=(a47*a67);
  a00=(a00+a46);
  a46=(a58*a89);
  a28=(a60*a59);
  a46=(a46+a28);
  a28=(a61*a40);
  a46=(a46+a28);
  a28=(a62*a37);
  a46=(a46+a28);
  a28=(a63*a79);
  a46=(a46+a28);
  a28=(a64*a56);
  a46=(a46+a28);
  a66=cos(a66);
  a66=(a66*a10);
  a28=(a48*a09);
  a04=(a50*a49);
  a28=(a28+a04);
  a04=(a51*a26);
  a28=(a28+a04);
  a04=(a52*a70);
  a28=(a28+a04);
  a04=(a53*a11);
  a28=(a28+a04);
  a04=(a54*a32);
  a28=(a28+a04);
  a28=(a03+a28);
  a28=(a66*a28);
  a04=(a65*a28);
  a46=(a46+a04);
  a46=(a09+a46);
  a04=(a57*a46);
  a00=(a00+a04);
  a04=(a69*a89);
  a82=(a71*a59);
  a04=(a04+a82);
  a82=(a72*a40);
  a04=(a04+a82);
  a82=(a73*a37);
  a04=(a04+a82);
  a82=(a74*a79);
  a04=(a04+a82);
  a82=(a75*a56);
  a04=(a04+a82);
  a82=(a76*a28);
  a04=(a04+a82);
  a78=cos(a78);
  a78=(a78*a10);
  a82=(a58*a09);
  a90=(a60*a49);
  a82=(a82+a90);
  a90=(a61*a26);
  a82=(a82+a90);
  a90=(a62*a70);
  a82=(a82+a90);
  a90=(a63*a11);
  a82=(a82+a90);
  a90=(a64*a32);
  a82=(a82+a90);
  a90=(a65*a67);
  a82=(a82+a90);
  a82=(a03+a82);
  a82=(a78*a82);
  a90=(a77*a82);
  a04=(a04+a90);
  a04=(a09+a04);
  a90=(a68*a04);
  a00=(a00+a90);
  a90=(a81*a89);
  a59=(a83*a59);
  a90=(a90+a59);
  a40=(a21*a40);
  a90=(a90+a40);
  a40=(a29*a37);
  a90=(a90+a40);
  a40=(a84*a79);
  a90=(a90+a40);
  a40=(a85*a56);
  a90=(a90+a40);
  a40=(a86*a28);
  a90=(a90+a40);
  a40=(a87*a82);
  a90=(a90+a40);
  a02=cos(a02);
  a02=(a02*a10);
  a40=(a69*a09);
  a59=(a71*a49);
  a40=(a40+a59);
  a59=(a72*a26);
  a40=(a40+a59);
  a59=(a73*a70);
  a40=(a40+a59);
  a59=(a74*a11);
  a40=(a40+a59);
  a59=(a75*a32);
  a40=(a40+a59);
  a59=(a76*a67);
  a40=(a40+a59);
  a59=(a77*a46);
  a40=(a40+a59);
  a40=(a03+a40);
  a40=(a02*a40);
  a59=(a88*a40);
  a90=(a90+a59);
  a90=(a09+a90);
  a90=(a80*a90);
  a00=(a00+a90);
  a00=(a03+a00);
  if (res[0]!=0) res[0][2]=a00;
  a89=(a01*a89);
  a37=(a05*a37);
  a89=(a89+a37);
  a79=(a30*a79);
  a89=(a89+a79);
  a56=(a38*a56);
  a89=(a89+a56);
  a28=(a47*a28);
  a89=(a89+a28);
  a82=(a57*a82);
  a89=(a89+a82);
  a40=(a68*a40);
  a89=(a89+a40);
  a07=cos(a07);
  a07=(a07*a10);
  a10=(a81*a09);
  a49=(a83*a49);
  a10=(a10+a49);
  a26=(a21*a26);
  a10=(a10+a26);
  a70=(a29*a70);
  a10=(a10+a70);
  a11=(a84*a11);
  a10=(a10+a11);
  a32=(a85*a32);
  a10=(a10+a32);
  a67=(a86*a67);
  a10=(a10+a67);
  a46=(a87*a46);
  a10=(a10+a46);
  a04=(a88*a04);
  a10=(a10+a04);
  a03=(a03+a10);
  a03=(a07*a03);
  a03=(a80*a03);
  a89=(a89+a03);
  a09=(a09+a89);
  if (res[0]!=0) res[0][3]=a09;
  a09=arg[0]? arg[0][4] : 0;
  a89=arg[0]? arg[0][5] : 0;
  a03=(a01*a89);
  a08=(a08*a09);
  a10=(a06*a08);
  a04=(a13*a89);
  a46=(a16*a08);
  a67=(a19*a89);
  a67=(a09+a67);
  a20=(a20*a67);
  a20=(a18*a20);
  a46=(a46+a20);
  a46=(a89+a46);
  a20=(a15*a46);
  a04=(a04+a20);
  a04=(a09+a04);
  a14=(a14*a04);
  a04=(a12*a14);
  a10=(a10+a04);
  a04=(a23*a89);
  a46=(a25*a46);
  a04=(a04+a46);
  a13=(a13*a08);
  a16=(a16*a89);
  a19=(a19*a08);
  a19=(a89+a19);
  a18=(a18*a19);
  a16=(a16+a18);
  a16=(a09+a16);
  a27=(a27*a16);
  a15=(a15*a27);
  a13=(a13+a15);
  a13=(a89+a13);
  a15=(a17*a13);
  a04=(a04+a15);
  a04=(a09+a04);
  a24=(a24*a04);
  a04=(a22*a24);
  a10=(a10+a04);
  a10=(a89+a10);
  a04=(a05*a10);
  a03=(a03+a04);
  a04=(a31*a08);
  a15=(a33*a14);
  a04=(a04+a15);
  a15=(a34*a24);
  a04=(a04+a15);
  a06=(a06*a89);
  a12=(a12*a13);
  a06=(a06+a12);
  a23=(a23*a08);
  a25=(a25*a27);
  a23=(a23+a25);
  a17=(a17*a14);
  a23=(a23+a17);
  a23=(a89+a23);
  a22=(a22*a23);
  a06=(a06+a22);
  a06=(a09+a06);
  a36=(a36*a06);
  a06=(a35*a36);
  a04=(a04+a06);
  a04=(a89+a04);
  a06=(a30*a04);
  a03=(a03+a06);
  a06=(a39*a08);
  a22=(a41*a14);
  a06=(a06+a22);
  a22=(a42*a24);
  a06=(a06+a22);
  a22=(a43*a36);
  a06=(a06+a22);
  a31=(a31*a89);
  a33=(a33*a13);
  a31=(a31+a33);
  a34=(a34*a23);
  a31=(a31+a34);
  a35=(a35*a10);
  a31=(a31+a35);
  a31=(a09+a31);
  a45=(a45*a31);
  a31=(a44*a45);
  a06=(a06+a31);
  a06=(a89+a06);
  a31=(a38*a06);
  a03=(a03+a31);
  a31=(a48*a08);
  a35=(a50*a14);
  a31=(a31+a35);
  a35=(a51*a24);
  a31=(a31+a35);
  a35=(a52*a36);
  a31=(a31+a35);
  a35=(a53*a45);
  a31=(a31+a35);
  a39=(a39*a89);
  a41=(a41*a13);
  a39=(a39+a41);
  a42=(a42*a23);
  a39=(a39+a42);
  a43=(a43*a10);
  a39=(a39+a43);
  a44=(a44*a04);
  a39=(a39+a44);
  a39=(a09+a39);
  a55=(a55*a39);
  a39=(a54*a55);
  a31=(a31+a39);
  a31=(a89+a31);
  a39=(a47*a31);
  a03=(a03+a39);
  a39=(a58*a08);
  a44=(a60*a14);
  a39=(a39+a44);
  a44=(a61*a24);
  a39=(a39+a44);
  a44=(a62*a36);
  a39=(a39+a44);
  a44=(a63*a45);
  a39=(a39+a44);
  a44=(a64*a55);
  a39=(a39+a44);
  a48=(a48*a89);
  a50=(a50*a13);
  a48=(a48+a50);
  a51=(a51*a23);
  a48=(a48+a51);
  a52=(a52*a10);
  a48=(a48+a52);
  a53=(a53*a04);
  a48=(a48+a53);
  a54=(a54*a06);
  a48=(a48+a54);
  a48=(a09+a48);
  a66=(a66*a48);
  a48=(a65*a66);
  a39=(a39+a48);
  a39=(a89+a39);
  a48=(a57*a39);
  a03=(a03+a48);
  a48=(a69*a08);
  a54=(a71*a14);
  a48=(a48+a54);
  a54=(a72*a24);
  a48=(a48+a54);
  a54=(a73*a36);
  a48=(a48+a54);
  a54=(a74*a45);
  a48=(a48+a54);
  a54=(a75*a55);
  a48=(a48+a54);
  a54=(a76*a66);
  a48=(a48+a54);
  a58=(a58*a89);
  a60=(a60*a13);
  a58=(a58+a60);
  a61=(a61*a23);
  a58=(a58+a61);
  a62=(a62*a10);
  a58=(a58+a62);
  a63=(a63*a04);
  a58=(a58+a63);
  a64=(a64*a06);
  a58=(a58+a64);
  a65=(a65*a31);
  a58=(a58+a65);
  a58=(a09+a58);
  a78=(a78*a58);
  a58=(a77*a78);
  a48=(a48+a58);
  a48=(a89+a48);
  a58=(a68*a48);
  a03=(a03+a58);
  a58=(a81*a08);
  a14=(a83*a14);
  a58=(a58+a14);
  a24=(a21*a24);
  a58=(a58+a24);
  a24=(a29*a36);
  a58=(a58+a24);
  a24=(a84*a45);
  a58=(a58+a24);
  a24=(a85*a55);
  a58=(a58+a24);
  a24=(a86*a66);
  a58=(a58+a24);
  a24=(a87*a78);
  a58=(a58+a24);
  a69=(a69*a89);
  a71=(a71*a13);
  a69=(a69+a71);
  a72=(a72*a23);
  a69=(a69+a72);
  a73=(a73*a10);
  a69=(a69+a73);
  a74=(a74*a04);
  a69=(a69+a74);
  a75=(a75*a06);
  a69=(a69+a75);
  a76=(a76*a31);
  a69=(a69+a76);
  a77=(a77*a39);
  a69=(a69+a77);
  a69=(a09+a69);
  a02=(a02*a69);
  a69=(a88*a02);
  a58=(a58+a69);
  a58=(a89+a58);
  a58=(a80*a58);
  a03=(a03+a58);
  a03=(a09+a03);
  if (res[0]!=0) res[0][4]=a03;
  a01=(a01*a08);
  a05=(a05*a36);
  a01=(a01+a05);
  a30=(a30*a45);
  a01=(a01+a30);
  a38=(a38*a55);
  a01=(a01+a38);
  a47=(a47*a66);
  a01=(a01+a47);
  a57=(a57*a78);
  a01=(a01+a57);
  a68=(a68*a02);
  a01=(a01+a68);
  a81=(a81*a89);
  a83=(a83*a13);
  a81=(a81+a83);
  a21=(a21*a23);
  a81=(a81+a21);
  a29=(a29*a10);
  a81=(a81+a29);
  a84=(a84*a04);
  a81=(a81+a84);
  a85=(a85*a06);
  a81=(a81+a85);
  a86=(a86*a31);
  a81=(a81+a86);
  a87=(a87*a39);
  a81=(a81+a87);
  a88=(a88*a48);
  a81=(a81+a88);
  a09=(a09+a81);
  a07=(a07*a09);
  a80=(a80*a07);
  a01=(a01+a80);
  a89=(a89+a01);
  if (res[0]!=0) res[0][5]=a89;
  return 0;
}

/* variational_steps:(y[2x3],t,turns[2x12],h,p[3])->(y_end[2x3]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+91, w1, *w2=w+97, *w3=w+100, w5, *w6=w+102, w7;
  const casadi_real **arg1=arg+5, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w2);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  wr4 = arg[2] ? arg[2] : casadi_zeros;
  /* #5: @5 = input[3][0] */
  w5 = arg[3] ? arg[3][0] : 0;
  /* #6: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #18: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #23: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #43: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #48: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #53: @6 = variational_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = variational_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* landing_with_derivative:(y[2x3],z[2],T,p[3])->(J[3x3],R[3]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8, a9;
  a0=arg[0]? arg[0][2] : 0;
  a1=1.;
  a2=(a0-a1);
  if (res[0]!=0) res[0][0]=a2;
  a2=arg[3]? arg[3][2] : 0;
  a3=(1./a2);
  a4=6.2831853071795862e+00;
  a5=arg[3]? arg[3][1] : 0;
  a4=(a4/a5);
  a6=cos(a4);
  a3=(a3+a6);
  a3=(a3-a1);
  a6=(a2*a3);
  a7=arg[0]? arg[0][3] : 0;
  a7=(a6*a7);
  if (res[0]!=0) res[0][1]=a7;
  a7=arg[0]? arg[0][0] : 0;
  a8=sin(a7);
  a0=(a8*a0);
  if (res[0]!=0) res[0][2]=a0;
  a0=arg[0]? arg[0][4] : 0;
  if (res[0]!=0) res[0][3]=a0;
  a9=arg[0]? arg[0][5] : 0;
  a9=(a6*a9);
  a9=(a9-a1);
  if (res[0]!=0) res[0][4]=a9;
  a0=(a8*a0);
  if (res[0]!=0) res[0][5]=a0;
  a0=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][6]=a0;
  a9=arg[3]? arg[3][0] : 0;
  a9=(a9+a7);
  a9=sin(a9);
  a9=(a9*a2);
  a6=(a6*a9);
  if (res[0]!=0) res[0][7]=a6;
  a8=(a8*a0);
  if (res[0]!=0) res[0][8]=a8;
  a4=(a7-a4);
  a8=arg[1]? arg[1][0] : 0;
  a4=(a4-a8);
  if (res[1]!=0) res[1][0]=a4;
  a0=(a0*a3);
  a0=(a0*a2);
  a2=arg[1]? arg[1][1] : 0;
  a0=(a0-a2);
  if (res[1]!=0) res[1][1]=a0;
  a0=3.1415926535897931e+00;
  a0=(a0/a5);
  a0=cos(a0);
  a7=cos(a7);
  a0=(a0-a7);
  if (res[1]!=0) res[1][2]=a0;
  return 0;
}

/* rimless_wheel_jacobian_12:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@11, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* newton_12:(u0[3],p[3])->(u[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f2(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* plain_step:(y[2],phase[2],turns[2x12],h,p[3])->(y_end[2]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45;
  a00=arg[0]? arg[0][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[3]? arg[3][0] : 0;
  a01=(a01*a02);
  a03=arg[0]? arg[0][1] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[4]? arg[4][0] : 0;
  a08=(a07+a00);
  a08=sin(a08);
  a09=arg[4]? arg[4][2] : 0;
  a08=(a08*a09);
  a10=(a06*a08);
  a11=1.7082860872947386e-01;
  a11=(a11*a02);
  a12=2.9587585476806851e-02;
  a12=(a12*a02);
  a13=(a12*a03);
  a14=8.8762756430420545e-02;
  a14=(a14*a02);
  a15=1.9725056984537900e-02;
  a15=(a15*a02);
  a16=(a15*a08);
  a17=5.9175170953613701e-02;
  a17=(a17*a02);
  a18=5.2600151958767730e-02;
  a18=(a18*a02);
  a19=(a18*a03);
  a19=(a00+a19);
  a19=(a07+a19);
  a19=sin(a19);
  a19=(a19*a09);
  a19=(a17*a19);
  a16=(a16+a19);
  a16=(a03+a16);
  a19=(a14*a16);
  a13=(a13+a19);
  a13=(a00+a13);
  a13=(a07+a13);
  a13=sin(a13);
  a13=(a13*a09);
  a19=(a11*a13);
  a10=(a10+a19);
  a19=1.2546768756682242e-01;
  a19=(a19*a02);
  a20=2.4136513415926669e-01;
  a20=(a20*a02);
  a21=(a20*a03);
  a22=-8.8454947932828609e-01;
  a22=(a22*a02);
  a16=(a22*a16);
  a21=(a21+a16);
  a16=9.2483400326179199e-01;
  a16=(a16*a02);
  a12=(a12*a08);
  a15=(a15*a03);
  a18=(a18*a08);
  a18=(a03+a18);
  a17=(a17*a18);
  a15=(a15+a17);
  a15=(a00+a15);
  a15=(a07+a15);
  a15=sin(a15);
  a15=(a15*a09);
  a14=(a14*a15);
  a12=(a12+a14);
  a12=(a03+a12);
  a14=(a16*a12);
  a21=(a21+a14);
  a21=(a00+a21);
  a21=(a07+a21);
  a21=sin(a21);
  a21=(a21*a09);
  a14=(a19*a21);
  a10=(a10+a14);
  a10=(a03+a10);
  a14=(a05*a10);
  a04=(a04+a14);
  a14=1.8915178993145003e+00;
  a14=(a14*a02);
  a17=3.7109375000000000e-02;
  a17=(a17*a02);
  a18=(a17*a08);
  a23=1.7025221101954405e-01;
  a23=(a23*a02);
  a24=(a23*a13);
  a18=(a18+a24);
  a24=6.0216538980455959e-02;
  a24=(a24*a02);
  a25=(a24*a21);
  a18=(a18+a25);
  a25=-1.7578125000000000e-02;
  a25=(a25*a02);
  a06=(a06*a03);
  a11=(a11*a12);
  a06=(a06+a11);
  a20=(a20*a08);
  a22=(a22*a15);
  a20=(a20+a22);
  a16=(a16*a13);
  a20=(a20+a16);
  a20=(a03+a20);
  a19=(a19*a20);
  a06=(a06+a19);
  a06=(a00+a06);
  a06=(a07+a06);
  a06=sin(a06);
  a06=(a06*a09);
  a19=(a25*a06);
  a18=(a18+a19);
  a18=(a03+a18);
  a19=(a14*a18);
  a04=(a04+a19);
  a19=-5.8012039600105849e+00;
  a19=(a19*a02);
  a16=3.7092000118504789e-02;
  a16=(a16*a02);
  a22=(a16*a08);
  a15=1.7038392571223998e-01;
  a15=(a15*a02);
  a11=(a15*a13);
  a22=(a22+a11);
  a11=1.0726203044637328e-01;
  a11=(a11*a02);
  a26=(a11*a21);
  a22=(a22+a26);
  a26=-1.5319437748624402e-02;
  a26=(a26*a02);
  a27=(a26*a06);
  a22=(a22+a27);
  a27=8.2737891638140233e-03;
  a27=(a27*a02);
  a17=(a17*a03);
  a23=(a23*a12);
  a17=(a17+a23);
  a24=(a24*a20);
  a17=(a17+a24);
  a25=(a25*a10);
  a17=(a17+a25);
  a17=(a00+a17);
  a17=(a07+a17);
  a17=sin(a17);
  a17=(a17*a09);
  a25=(a27*a17);
  a22=(a22+a25);
  a22=(a03+a22);
  a25=(a19*a22);
  a04=(a04+a25);
  a25=3.1116436695781990e-01;
  a25=(a25*a02);
  a24=6.2411095871607569e-01;
  a24=(a24*a02);
  a23=(a24*a08);
  a28=-3.3608926294469414e+00;
  a28=(a28*a02);
  a29=(a28*a13);
  a23=(a23+a29);
  a29=-8.6821934684172597e-01;
  a29=(a29*a02);
  a30=(a29*a21);
  a23=(a23+a30);
  a30=2.7592099699446710e+01;
  a30=(a30*a02);
  a31=(a30*a06);
  a23=(a23+a31);
  a31=2.0154067550477894e+01;
  a31=(a31*a02);
  a32=(a31*a17);
  a23=(a23+a32);
  a32=-4.3489884181069961e+01;
  a32=(a32*a02);
  a16=(a16*a03);
  a15=(a15*a12);
  a16=(a16+a15);
  a11=(a11*a20);
  a16=(a16+a11);
  a26=(a26*a10);
  a16=(a16+a26);
  a27=(a27*a18);
  a16=(a16+a27);
  a16=(a00+a16);
  a16=(a07+a16);
  a16=sin(a16);
  a16=(a16*a09);
  a27=(a32*a16);
  a23=(a23+a27);
  a23=(a03+a23);
  a27=(a25*a23);
  a04=(a04+a27);
  a27=-1.5216094966251609e-01;
  a27=(a27*a02);
  a26=4.7766253643826434e-01;
  a26=(a26*a02);
  a11=(a26*a08);
  a15=-2.4881146199716677e+00;
  a15=(a15*a02);
  a33=(a15*a13);
  a11=(a11+a33);
  a33=-5.9029082683684297e-01;
  a33=(a33*a02);
  a34=(a33*a21);
  a11=(a11+a34);
  a34=2.1230051448181193e+01;
  a34=(a34*a02);
  a35=(a34*a06);
  a11=(a11+a35);
  a35=1.5279233632882423e+01;
  a35=(a35*a02);
  a36=(a35*a17);
  a11=(a11+a36);
  a36=-3.3288210968984863e+01;
  a36=(a36*a02);
  a37=(a36*a16);
  a11=(a11+a37);
  a37=-2.0331201708508627e-02;
  a37=(a37*a02);
  a24=(a24*a03);
  a28=(a28*a12);
  a24=(a24+a28);
  a29=(a29*a20);
  a24=(a24+a29);
  a30=(a30*a10);
  a24=(a24+a30);
  a31=(a31*a18);
  a24=(a24+a31);
  a32=(a32*a22);
  a24=(a24+a32);
  a24=(a00+a24);
  a24=(a07+a24);
  a24=sin(a24);
  a24=(a24*a09);
  a32=(a37*a24);
  a11=(a11+a32);
  a11=(a03+a11);
  a32=(a27*a11);
  a04=(a04+a32);
  a32=2.0136540080403034e-01;
  a32=(a32*a02);
  a31=-9.3714243008598730e-01;
  a31=(a31*a02);
  a30=(a31*a08);
  a29=5.1863724288440638e+00;
  a29=(a29*a02);
  a28=(a29*a13);
  a30=(a30+a28);
  a28=1.0914373489967295e+00;
  a28=(a28*a02);
  a38=(a28*a21);
  a30=(a30+a38);
  a38=-8.1497870107469268e+00;
  a38=(a38*a02);
  a39=(a38*a06);
  a30=(a30+a39);
  a39=-1.8520065659996959e+01;
  a39=(a39*a02);
  a40=(a39*a17);
  a30=(a30+a40);
  a40=2.2739487099350505e+01;
  a40=(a40*a02);
  a41=(a40*a16);
  a30=(a30+a41);
  a41=2.4936055526796523e+00;
  a41=(a41*a02);
  a42=(a41*a24);
  a30=(a30+a42);
  a42=-3.0467644718982196e+00;
  a42=(a42*a02);
  a26=(a26*a03);
  a15=(a15*a12);
  a26=(a26+a15);
  a33=(a33*a20);
  a26=(a26+a33);
  a34=(a34*a10);
  a26=(a26+a34);
  a35=(a35*a18);
  a26=(a26+a35);
  a36=(a36*a22);
  a26=(a26+a36);
  a37=(a37*a23);
  a26=(a26+a37);
  a26=(a00+a26);
  a26=(a07+a26);
  a26=sin(a26);
  a26=(a26*a09);
  a37=(a42*a26);
  a30=(a30+a37);
  a30=(a03+a30);
  a37=(a32*a30);
  a04=(a04+a37);
  a37=4.4710615727772587e-02;
  a37=(a37*a02);
  a36=2.2733101475165380e+00;
  a36=(a36*a02);
  a35=(a36*a08);
  a34=-1.0534495466737249e+01;
  a34=(a34*a02);
  a13=(a34*a13);
  a35=(a35+a13);
  a13=-2.0008720582248625e+00;
  a13=(a13*a02);
  a21=(a13*a21);
  a35=(a35+a21);
  a21=-1.7958931863118799e+01;
  a21=(a21*a02);
  a33=(a21*a06);
  a35=(a35+a33);
  a33=2.7948884529419960e+01;
  a33=(a33*a02);
  a15=(a33*a17);
  a35=(a35+a15);
  a15=-2.8589982771350235e+00;
  a15=(a15*a02);
  a43=(a15*a16);
  a35=(a35+a43);
  a43=-8.8728569335306293e+00;
  a43=(a43*a02);
  a44=(a43*a24);
  a35=(a35+a44);
  a44=1.2360567175794303e+01;
  a44=(a44*a02);
  a45=(a44*a26);
  a35=(a35+a45);
  a45=6.4339274601576357e-01;
  a45=(a45*a02);
  a31=(a31*a03);
  a29=(a29*a12);
  a31=(a31+a29);
  a28=(a28*a20);
  a31=(a31+a28);
  a38=(a38*a10);
  a31=(a31+a38);
  a39=(a39*a18);
  a31=(a31+a39);
  a40=(a40*a22);
  a31=(a31+a40);
  a41=(a41*a23);
  a31=(a31+a41);
  a42=(a42*a11);
  a31=(a31+a42);
  a31=(a00+a31);
  a31=(a07+a31);
  a31=sin(a31);
  a31=(a31*a09);
  a42=(a45*a31);
  a35=(a35+a42);
  a35=(a03+a35);
  a35=(a37*a35);
  a04=(a04+a35);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a01=(a01*a08);
  a05=(a05*a06);
  a01=(a01+a05);
  a14=(a14*a17);
  a01=(a01+a14);
  a19=(a19*a16);
  a01=(a01+a19);
  a25=(a25*a24);
  a01=(a01+a25);
  a27=(a27*a26);
  a01=(a01+a27);
  a32=(a32*a31);
  a01=(a01+a32);
  a36=(a36*a03);
  a34=(a34*a12);
  a36=(a36+a34);
  a13=(a13*a20);
  a36=(a36+a13);
  a21=(a21*a10);
  a36=(a36+a21);
  a33=(a33*a18);
  a36=(a36+a33);
  a15=(a15*a22);
  a36=(a36+a15);
  a43=(a43*a23);
  a36=(a36+a43);
  a44=(a44*a11);
  a36=(a36+a44);
  a45=(a45*a30);
  a36=(a36+a45);
  a00=(a00+a36);
  a07=(a07+a00);
  a07=sin(a07);
  a07=(a07*a09);
  a37=(a37*a07);
  a01=(a01+a37);
  a03=(a03+a01);
  if (res[0]!=0) res[0][1]=a03;
  return 0;
}

/* plain_steps:(y[2],t,turns[2x12],h,p[3])->(y_end[2]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+46, w1, *w2=w+48, *w3=w+51, w5, *w6=w+53, w7;
  const casadi_real **arg1=arg+5, *wr4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 2, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w2);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w7  = (w1+w5);
  /* #8: @0 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @3 = plain_step(@6, @0, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w0;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @6 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w6;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #13: @0 = plain_step(@3, @6, @4, @5, @2) */
  arg1[0]=w3;
  arg1[1]=w6;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #18: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #19: @7 = 4 */
  w7 = 4.;
  /* #20: @7 = (@7*@5) */
  w7 *= w5;
  /* #21: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #22: @0 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #23: @3 = plain_step(@6, @0, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w0;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = 5 */
  w7 = 5.;
  /* #25: @7 = (@7*@5) */
  w7 *= w5;
  /* #26: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #27: @6 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w6;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #28: @0 = plain_step(@3, @6, @4, @5, @2) */
  arg1[0]=w3;
  arg1[1]=w6;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #33: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = 7 */
  w7 = 7.;
  /* #35: @7 = (@7*@5) */
  w7 *= w5;
  /* #36: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #37: @0 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #38: @3 = plain_step(@6, @0, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w0;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #39: @7 = 8 */
  w7 = 8.;
  /* #40: @7 = (@7*@5) */
  w7 *= w5;
  /* #41: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #42: @6 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w6;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #43: @0 = plain_step(@3, @6, @4, @5, @2) */
  arg1[0]=w3;
  arg1[1]=w6;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #48: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #49: @7 = 10 */
  w7 = 10.;
  /* #50: @7 = (@7*@5) */
  w7 *= w5;
  /* #51: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #52: @0 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #53: @3 = plain_step(@6, @0, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w0;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = 11 */
  w7 = 11.;
  /* #55: @7 = (@7*@5) */
  w7 *= w5;
  /* #56: @1 = (@1+@7) */
  w1 += w7;
  /* #57: @6 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w6;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #58: @0 = plain_step(@3, @6, @4, @5, @2) */
  arg1[0]=w3;
  arg1[1]=w6;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 2, res[0]);
  return 0;
}

/* landing:(y[2],z[2],p[3])->(R[3]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5;
  a0=arg[0]? arg[0][0] : 0;
  a1=6.2831853071795862e+00;
  a2=arg[2]? arg[2][1] : 0;
  a1=(a1/a2);
  a3=(a0-a1);
  a4=arg[1]? arg[1][0] : 0;
  a3=(a3-a4);
  if (res[0]!=0) res[0][0]=a3;
  a3=arg[0]? arg[0][1] : 0;
  a4=arg[2]? arg[2][2] : 0;
  a5=(1./a4);
  a1=cos(a1);
  a5=(a5+a1);
  a1=1.;
  a5=(a5-a1);
  a3=(a3*a5);
  a3=(a3*a4);
  a4=arg[1]? arg[1][1] : 0;
  a3=(a3-a4);
  if (res[0]!=0) res[0][1]=a3;
  a3=3.1415926535897931e+00;
  a3=(a3/a2);
  a3=cos(a3);
  a0=cos(a0);
  a3=(a3-a0);
  if (res[0]!=0) res[0][2]=a3;
  return 0;
}

/* rimless_wheel_residual_12:(u[3],p[3])->(R[3]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @5, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @0 = landing(@8, @1, @2) */
  arg1[0]=w8;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* rimless_wheel_search_12:(u0[3],p[3])->(u[3],R[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+239, *w1=w+242, *w2=w+245;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: @0 = rimless_wheel_residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 248;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 248*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_24:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* newton_24:(u0[3],p[3])->(u[3]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f15(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_residual_24:(u[3],p[3])->(R[3]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* rimless_wheel_search_24:(u0[3],p[3])->(u[3],R[3]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+239, *w1=w+242, *w2=w+245;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: @0 = rimless_wheel_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f13(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 248;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 248*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_48:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* newton_48:(u0[3],p[3])->(u[3]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f19(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_residual_48:(u[3],p[3])->(R[3]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* rimless_wheel_search_48:(u0[3],p[3])->(u[3],R[3]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+239, *w1=w+242, *w2=w+245;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f18(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: @0 = rimless_wheel_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f17(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 248;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 248*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_24:(u0[3],p[3])->(u[3]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f23(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_limit_cycle_24:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f15(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_36:(u[3],p[3])->(R[3]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @0 = landing(@8, @1, @2) */
  arg1[0]=w8;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_36:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f27(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_36:(u0[3],p[3])->(u[3]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f26(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_jacobian_36:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@11, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_36:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_36(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f24(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f15(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_48:(u0[3],p[3])->(u[3]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f31(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_limit_cycle_48:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f30(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f29(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_72:(u[3],p[3])->(R[3]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_72:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f35(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_72:(u0[3],p[3])->(u[3]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f34(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_jacobian_72:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_72:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_72(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_96:(u[3],p[3])->(R[3]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #31: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_96:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_96:(u0[3],p[3])->(u[3]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f39(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_jacobian_96:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_96:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_144:(u[3],p[3])->(R[3]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0833333 */
  w4 = 8.3333333333333329e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.416667 */
  w4 = 4.1666666666666669e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.583333 */
  w4 = 5.8333333333333337e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.916667 */
  w4 = 9.1666666666666663e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #43: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_144:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_144:(u0[3],p[3])->(u[3]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f44(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_jacobian_144:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_144:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f43(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_144(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f42(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_192:(u[3],p[3])->(R[3]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0625 */
  w4 = 6.2500000000000000e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.1875 */
  w4 = 1.8750000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.3125 */
  w4 = 3.1250000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.4375 */
  w4 = 4.3750000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.5625 */
  w4 = 5.6250000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.6875 */
  w4 = 6.8750000000000000e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.8125 */
  w4 = 8.1250000000000000e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.9375 */
  w4 = 9.3750000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #55: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_192:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_192:(u0[3],p[3])->(u[3]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f49(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_jacobian_192:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_192:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f48(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f51(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f47(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_288:(u[3],p[3])->(R[3]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.0416667 */
  w4 = 4.1666666666666664e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.0833333 */
  w4 = 8.3333333333333329e-02;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.166667 */
  w4 = 1.6666666666666666e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.208333 */
  w4 = 2.0833333333333334e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.291667 */
  w4 = 2.9166666666666669e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.333333 */
  w4 = 3.3333333333333331e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.416667 */
  w4 = 4.1666666666666669e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.458333 */
  w4 = 4.5833333333333331e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.541667 */
  w4 = 5.4166666666666663e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.583333 */
  w4 = 5.8333333333333337e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #55: @4 = 0.666667 */
  w4 = 6.6666666666666663e-01;
  /* #56: @4 = (@4*@5) */
  w4 *= w5;
  /* #57: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #58: @4 = 0.708333 */
  w4 = 7.0833333333333337e-01;
  /* #59: @4 = (@4*@5) */
  w4 *= w5;
  /* #60: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #61: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #62: @4 = (@4*@5) */
  w4 *= w5;
  /* #63: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #64: @4 = 0.791667 */
  w4 = 7.9166666666666663e-01;
  /* #65: @4 = (@4*@5) */
  w4 *= w5;
  /* #66: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #67: @4 = 0.833333 */
  w4 = 8.3333333333333337e-01;
  /* #68: @4 = (@4*@5) */
  w4 *= w5;
  /* #69: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #70: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #71: @4 = (@4*@5) */
  w4 *= w5;
  /* #72: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #73: @4 = 0.916667 */
  w4 = 9.1666666666666663e-01;
  /* #74: @4 = (@4*@5) */
  w4 *= w5;
  /* #75: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #76: @4 = 0.958333 */
  w4 = 9.5833333333333337e-01;
  /* #77: @4 = (@4*@5) */
  w4 *= w5;
  /* #78: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #79: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_288:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f55(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_288:(u0[3],p[3])->(u[3]) */
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

/* rimless_wheel_jacobian_288:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_288:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_288(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f52(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_residual_384:(u[3],p[3])->(R[3]) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+82, *w1=w+85, *w2=w+87, *w3=w+90, w4, w5, w6, *w7=w+92, *w8=w+116;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w2);
  /* #3: {@3, NULL} = start(@1, @2) */
  arg1[0]=w1;
  arg1[1]=w2;
  res1[0]=w3;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w2;
  res1[0]=w7;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @4 = 0.03125 */
  w4 = 3.1250000000000000e-02;
  /* #11: @4 = (@4*@5) */
  w4 *= w5;
  /* #12: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @4 = 0.0625 */
  w4 = 6.2500000000000000e-02;
  /* #14: @4 = (@4*@5) */
  w4 *= w5;
  /* #15: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @4 = 0.09375 */
  w4 = 9.3750000000000000e-02;
  /* #17: @4 = (@4*@5) */
  w4 *= w5;
  /* #18: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @4 = 0.125 */
  w4 = 1.2500000000000000e-01;
  /* #20: @4 = (@4*@5) */
  w4 *= w5;
  /* #21: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #22: @4 = 0.15625 */
  w4 = 1.5625000000000000e-01;
  /* #23: @4 = (@4*@5) */
  w4 *= w5;
  /* #24: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @4 = 0.1875 */
  w4 = 1.8750000000000000e-01;
  /* #26: @4 = (@4*@5) */
  w4 *= w5;
  /* #27: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #28: @4 = 0.21875 */
  w4 = 2.1875000000000000e-01;
  /* #29: @4 = (@4*@5) */
  w4 *= w5;
  /* #30: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #31: @4 = 0.25 */
  w4 = 2.5000000000000000e-01;
  /* #32: @4 = (@4*@5) */
  w4 *= w5;
  /* #33: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #34: @4 = 0.28125 */
  w4 = 2.8125000000000000e-01;
  /* #35: @4 = (@4*@5) */
  w4 *= w5;
  /* #36: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #37: @4 = 0.3125 */
  w4 = 3.1250000000000000e-01;
  /* #38: @4 = (@4*@5) */
  w4 *= w5;
  /* #39: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #40: @4 = 0.34375 */
  w4 = 3.4375000000000000e-01;
  /* #41: @4 = (@4*@5) */
  w4 *= w5;
  /* #42: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #43: @4 = 0.375 */
  w4 = 3.7500000000000000e-01;
  /* #44: @4 = (@4*@5) */
  w4 *= w5;
  /* #45: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #46: @4 = 0.40625 */
  w4 = 4.0625000000000000e-01;
  /* #47: @4 = (@4*@5) */
  w4 *= w5;
  /* #48: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #49: @4 = 0.4375 */
  w4 = 4.3750000000000000e-01;
  /* #50: @4 = (@4*@5) */
  w4 *= w5;
  /* #51: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #52: @4 = 0.46875 */
  w4 = 4.6875000000000000e-01;
  /* #53: @4 = (@4*@5) */
  w4 *= w5;
  /* #54: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #55: @4 = 0.5 */
  w4 = 5.0000000000000000e-01;
  /* #56: @4 = (@4*@5) */
  w4 *= w5;
  /* #57: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #58: @4 = 0.53125 */
  w4 = 5.3125000000000000e-01;
  /* #59: @4 = (@4*@5) */
  w4 *= w5;
  /* #60: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #61: @4 = 0.5625 */
  w4 = 5.6250000000000000e-01;
  /* #62: @4 = (@4*@5) */
  w4 *= w5;
  /* #63: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #64: @4 = 0.59375 */
  w4 = 5.9375000000000000e-01;
  /* #65: @4 = (@4*@5) */
  w4 *= w5;
  /* #66: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #67: @4 = 0.625 */
  w4 = 6.2500000000000000e-01;
  /* #68: @4 = (@4*@5) */
  w4 *= w5;
  /* #69: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #70: @4 = 0.65625 */
  w4 = 6.5625000000000000e-01;
  /* #71: @4 = (@4*@5) */
  w4 *= w5;
  /* #72: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #73: @4 = 0.6875 */
  w4 = 6.8750000000000000e-01;
  /* #74: @4 = (@4*@5) */
  w4 *= w5;
  /* #75: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #76: @4 = 0.71875 */
  w4 = 7.1875000000000000e-01;
  /* #77: @4 = (@4*@5) */
  w4 *= w5;
  /* #78: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #79: @4 = 0.75 */
  w4 = 7.5000000000000000e-01;
  /* #80: @4 = (@4*@5) */
  w4 *= w5;
  /* #81: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #82: @4 = 0.78125 */
  w4 = 7.8125000000000000e-01;
  /* #83: @4 = (@4*@5) */
  w4 *= w5;
  /* #84: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #85: @4 = 0.8125 */
  w4 = 8.1250000000000000e-01;
  /* #86: @4 = (@4*@5) */
  w4 *= w5;
  /* #87: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #88: @4 = 0.84375 */
  w4 = 8.4375000000000000e-01;
  /* #89: @4 = (@4*@5) */
  w4 *= w5;
  /* #90: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #91: @4 = 0.875 */
  w4 = 8.7500000000000000e-01;
  /* #92: @4 = (@4*@5) */
  w4 *= w5;
  /* #93: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #94: @4 = 0.90625 */
  w4 = 9.0625000000000000e-01;
  /* #95: @4 = (@4*@5) */
  w4 *= w5;
  /* #96: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #97: @4 = 0.9375 */
  w4 = 9.3750000000000000e-01;
  /* #98: @4 = (@4*@5) */
  w4 *= w5;
  /* #99: @8 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w8;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #100: @4 = 0.96875 */
  w4 = 9.6875000000000000e-01;
  /* #101: @4 = (@4*@5) */
  w4 *= w5;
  /* #102: @3 = plain_steps(@8, @4, @7, @6, @2) */
  arg1[0]=w8;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w3;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #103: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][0] = @0 */
  casadi_copy(w0, 3, res[0]);
  return 0;
}

/* coarse_jacobian_384:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+197, *w1=w+200, *w2=w+203, *w3=w+212;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: {@2, NULL} = rimless_wheel_jacobian_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f51(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 9, res[0]);
  /* #4: @3 = rimless_wheel_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 3, res[1]);
  return 0;
}

/* newton_384:(u0[3],p[3])->(u[3]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f59(arg+2, res+1, iw, w+36, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 3, res[0]);
  return 0;
}

/* rimless_wheel_jacobian_384:(u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+135, *w01=w+138, *w02=w+140, *w03=w+143, *w04=w+145, *w05=w+149, w06, w07, w08, *w09=w+155;
  casadi_real *w10=w+179, *w11=w+185;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: {@3, @4} = start(@1, @2) */
  arg1[0]=w01;
  arg1[1]=w02;
  res1[0]=w03;
  res1[1]=w04;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @5 = horzcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<2; ++i) *rr++ = *cs++;
  for (i=0, cs=w04; i<4; ++i) *rr++ = *cs++;
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
  arg1[1]=w02;
  res1[0]=w09;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@11, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w11;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @11 */
  casadi_copy(w11, 9, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  return 0;
}

/* rimless_wheel_limit_cycle_384:(u0[3],p[3])->(u[3],J[3x3],R[3]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+257, *w1=w+260, *w2=w+263, *w3=w+266;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f58(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 3, res[0]);
  /* #4: {@3, @0} = rimless_wheel_jacobian_384(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f61(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 9, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 275;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 275*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f9(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_12_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f16(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_24_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_36_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f20(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_48_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f35(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_72_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f40(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_96_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f45(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_144_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f50(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_192_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f55(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_288_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f60(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_residual_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_residual_384_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_residual_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_residual_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_residual_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_residual_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f28(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_36_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_36_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f36(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_72_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f41(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_96_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f46(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_144_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_192_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_288_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f61(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_384_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 194;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 194*sizeof(casadi_real);
  return 0;
}

/* start_along:(z[2],p[3],d[3])->(y[2x4]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][0] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a0=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][1]=a0;
  a0=1.;
  if (res[0]!=0) res[0][2]=a0;
  a1=0.;
  if (res[0]!=0) res[0][3]=a1;
  if (res[0]!=0) res[0][4]=a1;
  if (res[0]!=0) res[0][5]=a0;
  if (res[0]!=0) res[0][6]=a1;
  if (res[0]!=0) res[0][7]=a1;
  return 0;
}

/* step_along:(y[2x4],phase[2],turns[2x12],h,p[3],t,d[3])->(y_end[2x4]) */
static int casadi_f65(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  a003=arg[0]? arg[0][1] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[4]? arg[4][0] : 0;
  a008=(a007+a000);
  a009=sin(a008);
  a010=arg[4]? arg[4][2] : 0;
  a011=(a009*a010);
  a012=(a006*a011);
  a013=1.7082860872947386e-01;
  a013=(a013*a002);
  a014=2.9587585476806851e-02;
  a014=(a014*a002);
  a015=(a014*a003);
  a016=8.8762756430420545e-02;
  a016=(a016*a002);
  a017=1.9725056984537900e-02;
  a017=(a017*a002);
  a018=(a017*a011);
  a019=5.9175170953613701e-02;
  a019=(a019*a002);
  a020=5.2600151958767730e-02;
  a020=(a020*a002);
  a021=(a020*a003);
  a021=(a000+a021);
  a021=(a007+a021);
  a022=sin(a021);
  a023=(a022*a010);
  a023=(a019*a023);
  a018=(a018+a023);
  a018=(a003+a018);
  a023=(a016*a018);
  a015=(a015+a023);
  a015=(a000+a015);
  a015=(a007+a015);
  a023=sin(a015);
  a024=(a023*a010);
  a025=(a013*a024);
  a012=(a012+a025);
  a025=1.2546768756682242e-01;
  a025=(a025*a002);
  a026=2.4136513415926669e-01;
  a026=(a026*a002);
  a027=(a026*a003);
  a028=-8.8454947932828609e-01;
  a028=(a028*a002);
  a018=(a028*a018);
  a027=(a027+a018);
  a018=9.2483400326179199e-01;
  a018=(a018*a002);
  a029=(a014*a011);
  a030=(a017*a003);
  a031=(a020*a011);
  a031=(a003+a031);
  a031=(a019*a031);
  a030=(a030+a031);
  a030=(a000+a030);
  a030=(a007+a030);
  a031=sin(a030);
  a032=(a031*a010);
  a033=(a016*a032);
  a029=(a029+a033);
  a029=(a003+a029);
  a033=(a018*a029);
  a027=(a027+a033);
  a027=(a000+a027);
  a027=(a007+a027);
  a033=sin(a027);
  a034=(a033*a010);
  a035=(a025*a034);
  a012=(a012+a035);
  a012=(a003+a012);
  a035=(a005*a012);
  a004=(a004+a035);
  a035=1.8915178993145003e+00;
  a035=(a035*a002);
  a036=3.7109375000000000e-02;
  a036=(a036*a002);
  a037=(a036*a011);
  a038=1.7025221101954405e-01;
  a038=(a038*a002);
  a039=(a038*a024);
  a037=(a037+a039);
  a039=6.0216538980455959e-02;
  a039=(a039*a002);
  a040=(a039*a034);
  a037=(a037+a040);
  a040=-1.7578125000000000e-02;
  a040=(a040*a002);
  a041=(a006*a003);
  a042=(a013*a029);
  a041=(a041+a042);
  a042=(a026*a011);
  a032=(a028*a032);
  a042=(a042+a032);
  a032=(a018*a024);
  a042=(a042+a032);
  a042=(a003+a042);
  a032=(a025*a042);
  a041=(a041+a032);
  a041=(a000+a041);
  a041=(a007+a041);
  a032=sin(a041);
  a043=(a032*a010);
  a044=(a040*a043);
  a037=(a037+a044);
  a037=(a003+a037);
  a044=(a035*a037);
  a004=(a004+a044);
  a044=-5.8012039600105849e+00;
  a044=(a044*a002);
  a045=3.7092000118504789e-02;
  a045=(a045*a002);
  a046=(a045*a011);
  a047=1.7038392571223998e-01;
  a047=(a047*a002);
  a048=(a047*a024);
  a046=(a046+a048);
  a048=1.0726203044637328e-01;
  a048=(a048*a002);
  a049=(a048*a034);
  a046=(a046+a049);
  a049=-1.5319437748624402e-02;
  a049=(a049*a002);
  a050=(a049*a043);
  a046=(a046+a050);
  a050=8.2737891638140233e-03;
  a050=(a050*a002);
  a051=(a036*a003);
  a052=(a038*a029);
  a051=(a051+a052);
  a052=(a039*a042);
  a051=(a051+a052);
  a052=(a040*a012);
  a051=(a051+a052);
  a051=(a000+a051);
  a051=(a007+a051);
  a052=sin(a051);
  a053=(a052*a010);
  a054=(a050*a053);
  a046=(a046+a054);
  a046=(a003+a046);
  a054=(a044*a046);
  a004=(a004+a054);
  a054=3.1116436695781990e-01;
  a054=(a054*a002);
  a055=6.2411095871607569e-01;
  a055=(a055*a002);
  a056=(a055*a011);
  a057=-3.3608926294469414e+00;
  a057=(a057*a002);
  a058=(a057*a024);
  a056=(a056+a058);
  a058=-8.6821934684172597e-01;
  a058=(a058*a002);
  a059=(a058*a034);
  a056=(a056+a059);
  a059=2.7592099699446710e+01;
  a059=(a059*a002);
  a060=(a059*a043);
  a056=(a056+a060);
  a060=2.0154067550477894e+01;
  a060=(a060*a002);
  a061=(a060*a053);
  a056=(a056+a061);
  a061=-4.3489884181069961e+01;
  a061=(a061*a002);
  a062=(a045*a003);
  a063=(a047*a029);
  a062=(a062+a063);
  a063=(a048*a042);
  a062=(a062+a063);
  a063=(a049*a012);
  a062=(a062+a063);
  a063=(a050*a037);
  a062=(a062+a063);
  a062=(a000+a062);
  a062=(a007+a062);
  a063=sin(a062);
  a064=(a063*a010);
  a065=(a061*a064);
  a056=(a056+a065);
  a056=(a003+a056);
  a065=(a054*a056);
  a004=(a004+a065);
  a065=-1.5216094966251609e-01;
  a065=(a065*a002);
  a066=4.7766253643826434e-01;
  a066=(a066*a002);
  a067=(a066*a011);
  a068=-2.4881146199716677e+00;
  a068=(a068*a002);
  a069=(a068*a024);
  a067=(a067+a069);
  a069=-5.9029082683684297e-01;
  a069=(a069*a002);
  a070=(a069*a034);
  a067=(a067+a070);
  a070=2.1230051448181193e+01;
  a070=(a070*a002);
  a071=(a070*a043);
  a067=(a067+a071);
  a071=1.5279233632882423e+01;
  a071=(a071*a002);
  a072=(a071*a053);
  a067=(a067+a072);
  a072=-3.3288210968984863e+01;
  a072=(a072*a002);
  a073=(a072*a064);
  a067=(a067+a073);
  a073=-2.0331201708508627e-02;
  a073=(a073*a002);
  a074=(a055*a003);
  a075=(a057*a029);
  a074=(a074+a075);
  a075=(a058*a042);
  a074=(a074+a075);
  a075=(a059*a012);
  a074=(a074+a075);
  a075=(a060*a037);
  a074=(a074+a075);
  a075=(a061*a046);
  a074=(a074+a075);
  a074=(a000+a074);
  a074=(a007+a074);
  a075=sin(a074);
  a076=(a075*a010);
  a077=(a073*a076);
  a067=(a067+a077);
  a067=(a003+a067);
  a077=(a065*a067);
  a004=(a004+a077);
  a077=2.0136540080403034e-01;
  a077=(a077*a002);
  a078=-9.3714243008598730e-01;
  a078=(a078*a002);
  a079=(a078*a011);
  a080=5.1863724288440638e+00;
  a080=(a080*a002);
  a081=(a080*a024);
  a079=(a079+a081);
  a081=1.0914373489967295e+00;
  a081=(a081*a002);
  a082=(a081*a034);
  a079=(a079+a082);
  a082=-8.1497870107469268e+00;
  a082=(a082*a002);
  a083=(a082*a043);
  a079=(a079+a083);
  a083=-1.8520065659996959e+01;
  a083=(a083*a002);
  a084=(a083*a053);
  a079=(a079+a084);
  a084=2.2739487099350505e+01;
  a084=(a084*a002);
  a085=(a084*a064);
  a079=(a079+a085);
  a085=2.4936055526796523e+00;
  a085=(a085*a002);
  a086=(a085*a076);
  a079=(a079+a086);
  a086=-3.0467644718982196e+00;
  a086=(a086*a002);
  a087=(a066*a003);
  a088=(a068*a029);
  a087=(a087+a088);
  a088=(a069*a042);
  a087=(a087+a088);
  a088=(a070*a012);
  a087=(a087+a088);
  a088=(a071*a037);
  a087=(a087+a088);
  a088=(a072*a046);
  a087=(a087+a088);
  a088=(a073*a056);
  a087=(a087+a088);
  a087=(a000+a087);
  a087=(a007+a087);
  a088=sin(a087);
  a089=(a088*a010);
  a090=(a086*a089);
  a079=(a079+a090);
  a079=(a003+a079);
  a090=(a077*a079);
  a004=(a004+a090);
  a090=4.4710615727772587e-02;
  a090=(a090*a002);
  a091=2.2733101475165380e+00;
  a091=(a091*a002);
  a092=(a091*a011);
  a093=-1.0534495466737249e+01;
  a093=(a093*a002);
  a024=(a093*a024);
  a092=(a092+a024);
  a024=-2.0008720582248625e+00;
  a024=(a024*a002);
  a034=(a024*a034);
  a092=(a092+a034);
  a034=-1.7958931863118799e+01;
  a034=(a034*a002);
  a094=(a034*a043);
  a092=(a092+a094);
  a094=2.7948884529419960e+01;
  a094=(a094*a002);
  a095=(a094*a053);
  a092=(a092+a095);
  a095=-2.8589982771350235e+00;
  a095=(a095*a002);
  a096=(a095*a064);
  a092=(a092+a096);
  a096=-8.8728569335306293e+00;
  a096=(a096*a002);
  a097=(a096*a076);
  a092=(a092+a097);
  a097=1.2360567175794303e+01;
  a097=(a097*a002);
  a098=(a097*a089);
  a092=(a092+a098);
  a098=6.4339274601576357e-01;
  a098=(a098*a002);
  a002=(a078*a003);
  a099=(a080*a029);
  a002=(a002+a099);
  a099=(a081*a042);
  a002=(a002+a099);
  a099=(a082*a012);
  a002=(a002+a099);
  a099=(a083*a037);
  a002=(a002+a099);
  a099=(a084*a046);
  a002=(a002+a099);
  a099=(a085*a056);
  a002=(a002+a099);
  a099=(a086*a067);
  a002=(a002+a099);
  a002=(a000+a002);
  a002=(a007+a002);
  a099=sin(a002);
  a100=(a099*a010);
  a101=(a098*a100);
  a092=(a092+a101);
  a092=(a003+a092);
  a092=(a090*a092);
  a004=(a004+a092);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a011=(a001*a011);
  a043=(a005*a043);
  a011=(a011+a043);
  a053=(a035*a053);
  a011=(a011+a053);
  a064=(a044*a064);
  a011=(a011+a064);
  a076=(a054*a076);
  a011=(a011+a076);
  a089=(a065*a089);
  a011=(a011+a089);
  a100=(a077*a100);
  a011=(a011+a100);
  a100=(a091*a003);
  a029=(a093*a029);
  a100=(a100+a029);
  a042=(a024*a042);
  a100=(a100+a042);
  a012=(a034*a012);
  a100=(a100+a012);
  a037=(a094*a037);
  a100=(a100+a037);
  a046=(a095*a046);
  a100=(a100+a046);
  a056=(a096*a056);
  a100=(a100+a056);
  a067=(a097*a067);
  a100=(a100+a067);
  a079=(a098*a079);
  a100=(a100+a079);
  a000=(a000+a100);
  a007=(a007+a000);
  a000=sin(a007);
  a100=(a000*a010);
  a100=(a090*a100);
  a011=(a011+a100);
  a003=(a003+a011);
  if (res[0]!=0) res[0][1]=a003;
  a003=arg[0]? arg[0][2] : 0;
  a011=arg[0]? arg[0][3] : 0;
  a100=(a001*a011);
  a008=cos(a008);
  a079=(a008*a010);
  a067=(a079*a003);
  a056=(a006*a067);
  a015=cos(a015);
  a046=(a015*a010);
  a037=(a014*a011);
  a012=(a017*a067);
  a021=cos(a021);
  a042=(a021*a010);
  a029=(a020*a011);
  a029=(a003+a029);
  a029=(a042*a029);
  a029=(a019*a029);
  a012=(a012+a029);
  a012=(a011+a012);
  a029=(a016*a012);
  a037=(a037+a029);
  a037=(a003+a037);
  a037=(a046*a037);
  a029=(a013*a037);
  a056=(a056+a029);
  a027=cos(a027);
  a029=(a027*a010);
  a089=(a026*a011);
  a012=(a028*a012);
  a089=(a089+a012);
  a012=(a014*a067);
  a030=cos(a030);
  a076=(a030*a010);
  a064=(a017*a011);
  a053=(a020*a067);
  a053=(a011+a053);
  a053=(a019*a053);
  a064=(a064+a053);
  a064=(a003+a064);
  a064=(a076*a064);
  a053=(a016*a064);
  a012=(a012+a053);
  a012=(a011+a012);
  a053=(a018*a012);
  a089=(a089+a053);
  a089=(a003+a089);
  a089=(a029*a089);
  a053=(a025*a089);
  a056=(a056+a053);
  a056=(a011+a056);
  a053=(a005*a056);
  a100=(a100+a053);
  a053=(a036*a067);
  a043=(a038*a037);
  a053=(a053+a043);
  a043=(a039*a089);
  a053=(a053+a043);
  a041=cos(a041);
  a043=(a041*a010);
  a004=(a006*a011);
  a092=(a013*a012);
  a004=(a004+a092);
  a092=(a026*a067);
  a064=(a028*a064);
  a092=(a092+a064);
  a064=(a018*a037);
  a092=(a092+a064);
  a092=(a011+a092);
  a064=(a025*a092);
  a004=(a004+a064);
  a004=(a003+a004);
  a004=(a043*a004);
  a064=(a040*a004);
  a053=(a053+a064);
  a053=(a011+a053);
  a064=(a035*a053);
  a100=(a100+a064);
  a064=(a045*a067);
  a101=(a047*a037);
  a064=(a064+a101);
  a101=(a048*a089);
  a064=(a064+a101);
  a101=(a049*a004);
  a064=(a064+a101);
  a051=cos(a051);
  a101=(a051*a010);
  a102=(a036*a011);
  a103=(a038*a012);
  a102=(a102+a103);
  a103=(a039*a092);
  a102=(a102+a103);
  a103=(a040*a056);
  a102=(a102+a103);
  a102=(a003+a102);
  a102=(a101*a102);
  a103=(a050*a102);
  a064=(a064+a103);
  a064=(a011+a064);
  a103=(a044*a064);
  a100=(a100+a103);
  a103=(a055*a067);
  a104=(a057*a037);
  a103=(a103+a104);
  a104=(a058*a089);
  a103=(a103+a104);
  a104=(a059*a004);
  a103=(a103+a104);
  a104=(a060*a102);
  a103=(a103+a104);
  a062=cos(a062);
  a104=(a062*a010);
  a105=(a045*a011);
  a106=(a047*a012);
  a105=(a105+a106);
  a106=(a048*a092);
  a105=(a105+a106);
  a106=(a049*a056);
  a105=(a105+a106);
  a106=(a050*a053);
  a105=(a105+a106);
  a105=(a003+a105);
  a105=(a104*a105);
  a106=(a061*a105);
  a103=(a103+a106);
  a103=(a011+a103);
  a106=(a054*a103);
  a100=(a100+a106);
  a106=(a066*a067);
  a107=(a068*a037);
  a106=(a106+a107);
  a107=(a069*a089);
  a106=(a106+a107);
  a107=(a070*a004);
  a106=(a106+a107);
  a107=(a071*a102);
  a106=(a106+a107);
  a107=(a072*a105);
  a106=(a106+a107);
  a074=cos(a074);
  a107=(a074*a010);
  a108=(a055*a011);
  a109=(a057*a012);
  a108=(a108+a109);
  a109=(a058*a092);
  a108=(a108+a109);
  a109=(a059*a056);
  a108=(a108+a109);
  a109=(a060*a053);
  a108=(a108+a109);
  a109=(a061*a064);
  a108=(a108+a109);
  a108=(a003+a108);
  a108=(a107*a108);
  a109=(a073*a108);
  a106=(a106+a109);
  a106=(a011+a106);
  a109=(a065*a106);
  a100=(a100+a109);
  a109=(a078*a067);
  a110=(a080*a037);
  a109=(a109+a110);
  a110=(a081*a089);
  a109=(a109+a110);
  a110=(a082*a004);
  a109=(a109+a110);
  a110=(a083*a102);
  a109=(a109+a110);
  a110=(a084*a105);
  a109=(a109+a110);
  a110=(a085*a108);
  a109=(a109+a110);
  a087=cos(a087);
  a110=(a087*a010);
  a111=(a066*a011);
  a112=(a068*a012);
  a111=(a111+a112);
  a112=(a069*a092);
  a111=(a111+a112);
  a112=(a070*a056);
  a111=(a111+a112);
  a112=(a071*a053);
  a111=(a111+a112);
  a112=(a072*a064);
  a111=(a111+a112);
  a112=(a073*a103);
  a111=(a111+a112);
  a111=(a003+a111);
  a111=(a110*a111);
  a112=(a086*a111);
  a109=(a109+a112);
  a109=(a011+a109);
  a112=(a077*a109);
  a100=(a100+a112);
  a112=(a091*a067);
  a037=(a093*a037);
  a112=(a112+a037);
  a089=(a024*a089);
  a112=(a112+a089);
  a089=(a034*a004);
  a112=(a112+a089);
  a089=(a094*a102);
  a112=(a112+a089);
  a089=(a095*a105);
  a112=(a112+a089);
  a089=(a096*a108);
  a112=(a112+a089);
  a089=(a097*a111);
  a112=(a112+a089);
  a002=cos(a002);
  a089=(a002*a010);
  a037=(a078*a011);
  a113=(a080*a012);
  a037=(a037+a113);
  a113=(a081*a092);
  a037=(a037+a113);
  a113=(a082*a056);
  a037=(a037+a113);
  a113=(a083*a053);
  a037=(a037+a113);
  a113=(a084*a064);
  a037=(a037+a113);
  a113=(a085*a103);
  a037=(a037+a113);
  a113=(a086*a106);
  a037=(a037+a113);
  a037=(a003+a037);
  a037=(a089*a037);
  a113=(a098*a037);
  a112=(a112+a113);
  a112=(a011+a112);
  a112=(a090*a112);
  a100=(a100+a112);
  a100=(a003+a100);
  if (res[0]!=0) res[0][2]=a100;
  a067=(a001*a067);
  a004=(a005*a004);
  a067=(a067+a004);
  a102=(a035*a102);
  a067=(a067+a102);
  a105=(a044*a105);
  a067=(a067+a105);
  a108=(a054*a108);
  a067=(a067+a108);
  a111=(a065*a111);
  a067=(a067+a111);
  a037=(a077*a037);
  a067=(a067+a037);
  a007=cos(a007);
  a037=(a007*a010);
  a111=(a091*a011);
  a012=(a093*a012);
  a111=(a111+a012);
  a092=(a024*a092);
  a111=(a111+a092);
  a056=(a034*a056);
  a111=(a111+a056);
  a053=(a094*a053);
  a111=(a111+a053);
  a064=(a095*a064);
  a111=(a111+a064);
  a103=(a096*a103);
  a111=(a111+a103);
  a106=(a097*a106);
  a111=(a111+a106);
  a109=(a098*a109);
  a111=(a111+a109);
  a003=(a003+a111);
  a003=(a037*a003);
  a003=(a090*a003);
  a067=(a067+a003);
  a011=(a011+a067);
  if (res[0]!=0) res[0][3]=a011;
  a011=arg[0]? arg[0][4] : 0;
  a067=arg[0]? arg[0][5] : 0;
  a003=(a001*a067);
  a111=(a079*a011);
  a109=(a006*a111);
  a106=(a014*a067);
  a103=(a017*a111);
  a064=(a020*a067);
  a064=(a011+a064);
  a064=(a042*a064);
  a064=(a019*a064);
  a103=(a103+a064);
  a103=(a067+a103);
  a064=(a016*a103);
  a106=(a106+a064);
  a106=(a011+a106);
  a106=(a046*a106);
  a064=(a013*a106);
  a109=(a109+a064);
  a064=(a026*a067);
  a103=(a028*a103);
  a064=(a064+a103);
  a103=(a014*a111);
  a053=(a017*a067);
  a056=(a020*a111);
  a056=(a067+a056);
  a056=(a019*a056);
  a053=(a053+a056);
  a053=(a011+a053);
  a053=(a076*a053);
  a056=(a016*a053);
  a103=(a103+a056);
  a103=(a067+a103);
  a056=(a018*a103);
  a064=(a064+a056);
  a064=(a011+a064);
  a064=(a029*a064);
  a056=(a025*a064);
  a109=(a109+a056);
  a109=(a067+a109);
  a056=(a005*a109);
  a003=(a003+a056);
  a056=(a036*a111);
  a092=(a038*a106);
  a056=(a056+a092);
  a092=(a039*a064);
  a056=(a056+a092);
  a092=(a006*a067);
  a012=(a013*a103);
  a092=(a092+a012);
  a012=(a026*a111);
  a053=(a028*a053);
  a012=(a012+a053);
  a053=(a018*a106);
  a012=(a012+a053);
  a012=(a067+a012);
  a053=(a025*a012);
  a092=(a092+a053);
  a092=(a011+a092);
  a092=(a043*a092);
  a053=(a040*a092);
  a056=(a056+a053);
  a056=(a067+a056);
  a053=(a035*a056);
  a003=(a003+a053);
  a053=(a045*a111);
  a108=(a047*a106);
  a053=(a053+a108);
  a108=(a048*a064);
  a053=(a053+a108);
  a108=(a049*a092);
  a053=(a053+a108);
  a108=(a036*a067);
  a105=(a038*a103);
  a108=(a108+a105);
  a105=(a039*a012);
  a108=(a108+a105);
  a105=(a040*a109);
  a108=(a108+a105);
  a108=(a011+a108);
  a108=(a101*a108);
  a105=(a050*a108);
  a053=(a053+a105);
  a053=(a067+a053);
  a105=(a044*a053);
  a003=(a003+a105);
  a105=(a055*a111);
  a102=(a057*a106);
  a105=(a105+a102);
  a102=(a058*a064);
  a105=(a105+a102);
  a102=(a059*a092);
  a105=(a105+a102);
  a102=(a060*a108);
  a105=(a105+a102);
  a102=(a045*a067);
  a004=(a047*a103);
  a102=(a102+a004);
  a004=(a048*a012);
  a102=(a102+a004);
  a004=(a049*a109);
  a102=(a102+a004);
  a004=(a050*a056);
  a102=(a102+a004);
  a102=(a011+a102);
  a102=(a104*a102);
  a004=(a061*a102);
  a105=(a105+a004);
  a105=(a067+a105);
  a004=(a054*a105);
  a003=(a003+a004);
  a004=(a066*a111);
  a100=(a068*a106);
  a004=(a004+a100);
  a100=(a069*a064);
  a004=(a004+a100);
  a100=(a070*a092);
  a004=(a004+a100);
  a100=(a071*a108);
  a004=(a004+a100);
  a100=(a072*a102);
  a004=(a004+a100);
  a100=(a055*a067);
  a112=(a057*a103);
  a100=(a100+a112);
  a112=(a058*a012);
  a100=(a100+a112);
  a112=(a059*a109);
  a100=(a100+a112);
  a112=(a060*a056);
  a100=(a100+a112);
  a112=(a061*a053);
  a100=(a100+a112);
  a100=(a011+a100);
  a100=(a107*a100);
  a112=(a073*a100);
  a004=(a004+a112);
  a004=(a067+a004);
  a112=(a065*a004);
  a003=(a003+a112);
  a112=(a078*a111);
  a113=(a080*a106);
  a112=(a112+a113);
  a113=(a081*a064);
  a112=(a112+a113);
  a113=(a082*a092);
  a112=(a112+a113);
  a113=(a083*a108);
  a112=(a112+a113);
  a113=(a084*a102);
  a112=(a112+a113);
  a113=(a085*a100);
  a112=(a112+a113);
  a113=(a066*a067);
  a114=(a068*a103);
  a113=(a113+a114);
  a114=(a069*a012);
  a113=(a113+a114);
  a114=(a070*a109);
  a113=(a113+a114);
  a114=(a071*a056);
  a113=(a113+a114);
  a114=(a072*a053);
  a113=(a113+a114);
  a114=(a073*a105);
  a113=(a113+a114);
  a113=(a011+a113);
  a113=(a110*a113);
  a114=(a086*a113);
  a112=(a112+a114);
  a112=(a067+a112);
  a114=(a077*a112);
  a003=(a003+a114);
  a114=(a091*a111);
  a106=(a093*a106);
  a114=(a114+a106);
  a064=(a024*a064);
  a114=(a114+a064);
  a064=(a034*a092);
  a114=(a114+a064);
  a064=(a094*a108);
  a114=(a114+a064);
  a064=(a095*a102);
  a114=(a114+a064);
  a064=(a096*a100);
  a114=(a114+a064);
  a064=(a097*a113);
  a114=(a114+a064);
  a064=(a078*a067);
  a106=(a080*a103);
  a064=(a064+a106);
  a106=(a081*a012);
  a064=(a064+a106);
  a106=(a082*a109);
  a064=(a064+a106);
  a106=(a083*a056);
  a064=(a064+a106);
  a106=(a084*a053);
  a064=(a064+a106);
  a106=(a085*a105);
  a064=(a064+a106);
  a106=(a086*a004);
  a064=(a064+a106);
  a064=(a011+a064);
  a064=(a089*a064);
  a106=(a098*a064);
  a114=(a114+a106);
  a114=(a067+a114);
  a114=(a090*a114);
  a003=(a003+a114);
  a003=(a011+a003);
  if (res[0]!=0) res[0][4]=a003;
  a111=(a001*a111);
  a092=(a005*a092);
  a111=(a111+a092);
  a108=(a035*a108);
  a111=(a111+a108);
  a102=(a044*a102);
  a111=(a111+a102);
  a100=(a054*a100);
  a111=(a111+a100);
  a113=(a065*a113);
  a111=(a111+a113);
  a064=(a077*a064);
  a111=(a111+a064);
  a064=(a091*a067);
  a103=(a093*a103);
  a064=(a064+a103);
  a012=(a024*a012);
  a064=(a064+a012);
  a109=(a034*a109);
  a064=(a064+a109);
  a056=(a094*a056);
  a064=(a064+a056);
  a053=(a095*a053);
  a064=(a064+a053);
  a105=(a096*a105);
  a064=(a064+a105);
  a004=(a097*a004);
  a064=(a064+a004);
  a112=(a098*a112);
  a064=(a064+a112);
  a011=(a011+a064);
  a011=(a037*a011);
  a011=(a090*a011);
  a111=(a111+a011);
  a067=(a067+a111);
  if (res[0]!=0) res[0][5]=a067;
  a067=arg[0]? arg[0][6] : 0;
  a111=arg[0]? arg[0][7] : 0;
  a011=(a001*a111);
  a079=(a079*a067);
  a064=arg[6]? arg[6][0] : 0;
  a008=(a008*a064);
  a008=(a010*a008);
  a112=arg[6]? arg[6][2] : 0;
  a009=(a009*a112);
  a008=(a008+a009);
  a079=(a079+a008);
  a008=(a006*a079);
  a009=(a014*a111);
  a004=(a017*a079);
  a105=(a020*a111);
  a105=(a067+a105);
  a042=(a042*a105);
  a021=(a021*a064);
  a021=(a010*a021);
  a022=(a022*a112);
  a021=(a021+a022);
  a042=(a042+a021);
  a042=(a019*a042);
  a004=(a004+a042);
  a004=(a111+a004);
  a042=(a016*a004);
  a009=(a009+a042);
  a009=(a067+a009);
  a046=(a046*a009);
  a015=(a015*a064);
  a015=(a010*a015);
  a023=(a023*a112);
  a015=(a015+a023);
  a046=(a046+a015);
  a015=(a013*a046);
  a008=(a008+a015);
  a015=(a026*a111);
  a004=(a028*a004);
  a015=(a015+a004);
  a014=(a014*a079);
  a017=(a017*a111);
  a020=(a020*a079);
  a020=(a111+a020);
  a019=(a019*a020);
  a017=(a017+a019);
  a017=(a067+a017);
  a076=(a076*a017);
  a030=(a030*a064);
  a030=(a010*a030);
  a031=(a031*a112);
  a030=(a030+a031);
  a076=(a076+a030);
  a016=(a016*a076);
  a014=(a014+a016);
  a014=(a111+a014);
  a016=(a018*a014);
  a015=(a015+a016);
  a015=(a067+a015);
  a029=(a029*a015);
  a027=(a027*a064);
  a027=(a010*a027);
  a033=(a033*a112);
  a027=(a027+a033);
  a029=(a029+a027);
  a027=(a025*a029);
  a008=(a008+a027);
  a008=(a111+a008);
  a027=(a005*a008);
  a011=(a011+a027);
  a027=(a036*a079);
  a033=(a038*a046);
  a027=(a027+a033);
  a033=(a039*a029);
  a027=(a027+a033);
  a006=(a006*a111);
  a013=(a013*a014);
  a006=(a006+a013);
  a026=(a026*a079);
  a028=(a028*a076);
  a026=(a026+a028);
  a018=(a018*a046);
  a026=(a026+a018);
  a026=(a111+a026);
  a025=(a025*a026);
  a006=(a006+a025);
  a006=(a067+a006);
  a043=(a043*a006);
  a041=(a041*a064);
  a041=(a010*a041);
  a032=(a032*a112);
  a041=(a041+a032);
  a043=(a043+a041);
  a041=(a040*a043);
  a027=(a027+a041);
  a027=(a111+a027);
  a041=(a035*a027);
  a011=(a011+a041);
  a041=(a045*a079);
  a032=(a047*a046);
  a041=(a041+a032);
  a032=(a048*a029);
  a041=(a041+a032);
  a032=(a049*a043);
  a041=(a041+a032);
  a036=(a036*a111);
  a038=(a038*a014);
  a036=(a036+a038);
  a039=(a039*a026);
  a036=(a036+a039);
  a040=(a040*a008);
  a036=(a036+a040);
  a036=(a067+a036);
  a101=(a101*a036);
  a051=(a051*a064);
  a051=(a010*a051);
  a052=(a052*a112);
  a051=(a051+a052);
  a101=(a101+a051);
  a051=(a050*a101);
  a041=(a041+a051);
  a041=(a111+a041);
  a051=(a044*a041);
  a011=(a011+a051);
  a051=(a055*a079);
  a052=(a057*a046);
  a051=(a051+a052);
  a052=(a058*a029);
  a051=(a051+a052);
  a052=(a059*a043);
  a051=(a051+a052);
  a052=(a060*a101);
  a051=(a051+a052);
  a045=(a045*a111);
  a047=(a047*a014);
  a045=(a045+a047);
  a048=(a048*a026);
  a045=(a045+a048);
  a049=(a049*a008);
  a045=(a045+a049);
  a050=(a050*a027);
  a045=(a045+a050);
  a045=(a067+a045);
  a104=(a104*a045);
  a062=(a062*a064);
  a062=(a010*a062);
  a063=(a063*a112);
  a062=(a062+a063);
  a104=(a104+a062);
  a062=(a061*a104);
  a051=(a051+a062);
  a051=(a111+a051);
  a062=(a054*a051);
  a011=(a011+a062);
  a062=(a066*a079);
  a063=(a068*a046);
  a062=(a062+a063);
  a063=(a069*a029);
  a062=(a062+a063);
  a063=(a070*a043);
  a062=(a062+a063);
  a063=(a071*a101);
  a062=(a062+a063);
  a063=(a072*a104);
  a062=(a062+a063);
  a055=(a055*a111);
  a057=(a057*a014);
  a055=(a055+a057);
  a058=(a058*a026);
  a055=(a055+a058);
  a059=(a059*a008);
  a055=(a055+a059);
  a060=(a060*a027);
  a055=(a055+a060);
  a061=(a061*a041);
  a055=(a055+a061);
  a055=(a067+a055);
  a107=(a107*a055);
  a074=(a074*a064);
  a074=(a010*a074);
  a075=(a075*a112);
  a074=(a074+a075);
  a107=(a107+a074);
  a074=(a073*a107);
  a062=(a062+a074);
  a062=(a111+a062);
  a074=(a065*a062);
  a011=(a011+a074);
  a074=(a078*a079);
  a075=(a080*a046);
  a074=(a074+a075);
  a075=(a081*a029);
  a074=(a074+a075);
  a075=(a082*a043);
  a074=(a074+a075);
  a075=(a083*a101);
  a074=(a074+a075);
  a075=(a084*a104);
  a074=(a074+a075);
  a075=(a085*a107);
  a074=(a074+a075);
  a066=(a066*a111);
  a068=(a068*a014);
  a066=(a066+a068);
  a069=(a069*a026);
  a066=(a066+a069);
  a070=(a070*a008);
  a066=(a066+a070);
  a071=(a071*a027);
  a066=(a066+a071);
  a072=(a072*a041);
  a066=(a066+a072);
  a073=(a073*a051);
  a066=(a066+a073);
  a066=(a067+a066);
  a110=(a110*a066);
  a087=(a087*a064);
  a087=(a010*a087);
  a088=(a088*a112);
  a087=(a087+a088);
  a110=(a110+a087);
  a087=(a086*a110);
  a074=(a074+a087);
  a074=(a111+a074);
  a087=(a077*a074);
  a011=(a011+a087);
  a087=(a091*a079);
  a046=(a093*a046);
  a087=(a087+a046);
  a029=(a024*a029);
  a087=(a087+a029);
  a029=(a034*a043);
  a087=(a087+a029);
  a029=(a094*a101);
  a087=(a087+a029);
  a029=(a095*a104);
  a087=(a087+a029);
  a029=(a096*a107);
  a087=(a087+a029);
  a029=(a097*a110);
  a087=(a087+a029);
  a078=(a078*a111);
  a080=(a080*a014);
  a078=(a078+a080);
  a081=(a081*a026);
  a078=(a078+a081);
  a082=(a082*a008);
  a078=(a078+a082);
  a083=(a083*a027);
  a078=(a078+a083);
  a084=(a084*a041);
  a078=(a078+a084);
  a085=(a085*a051);
  a078=(a078+a085);
  a086=(a086*a062);
  a078=(a078+a086);
  a078=(a067+a078);
  a089=(a089*a078);
  a002=(a002*a064);
  a002=(a010*a002);
  a099=(a099*a112);
  a002=(a002+a099);
  a089=(a089+a002);
  a002=(a098*a089);
  a087=(a087+a002);
  a087=(a111+a087);
  a087=(a090*a087);
  a011=(a011+a087);
  a011=(a067+a011);
  if (res[0]!=0) res[0][6]=a011;
  a001=(a001*a079);
  a005=(a005*a043);
  a001=(a001+a005);
  a035=(a035*a101);
  a001=(a001+a035);
  a044=(a044*a104);
  a001=(a001+a044);
  a054=(a054*a107);
  a001=(a001+a054);
  a065=(a065*a110);
  a001=(a001+a065);
  a077=(a077*a089);
  a001=(a001+a077);
  a091=(a091*a111);
  a093=(a093*a014);
  a091=(a091+a093);
  a024=(a024*a026);
  a091=(a091+a024);
  a034=(a034*a008);
  a091=(a091+a034);
  a094=(a094*a027);
  a091=(a091+a094);
  a095=(a095*a041);
  a091=(a091+a095);
  a096=(a096*a051);
  a091=(a091+a096);
  a097=(a097*a062);
  a091=(a091+a097);
  a098=(a098*a074);
  a091=(a091+a098);
  a067=(a067+a091);
  a037=(a037*a067);
  a007=(a007*a064);
  a010=(a010*a007);
  a000=(a000*a112);
  a010=(a010+a000);
  a037=(a037+a010);
  a090=(a090*a037);
  a001=(a001+a090);
  a111=(a111+a001);
  if (res[0]!=0) res[0][7]=a111;
  return 0;
}

/* step_alongs:(y[2x4],t,turns[2x12],h,p[3],d[3])->(y_end[2x4]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+115, w1, *w2=w+123, *w3=w+126, w5, *w6=w+128, *w7=w+131, w8;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
  /* #8: @8 = (@1+@5) */
  w8  = (w1+w5);
  /* #9: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #10: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
  /* #11: @8 = (2.*@5) */
  w8 = (2.* w5 );
  /* #12: @8 = (@1+@8) */
  w8  = (w1+w8);
  /* #13: @3 = phase(@8, @2) */
  arg1[0]=(&w8);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #14: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #24: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #29: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #34: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #39: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #44: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #49: @0 = step_along(@7, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #54: @7 = step_along(@0, @3, @4, @5, @2, @8, @6) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w8);
  arg1[6]=w6;
  res1[0]=w7;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #59: @0 = step_along(@7, @3, @4, @5, @2, @1, @6) */
  arg1[0]=w7;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  arg1[5]=(&w1);
  arg1[6]=w6;
  res1[0]=w0;
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[0][0] = @0 */
  casadi_copy(w0, 8, res[0]);
  return 0;
}

/* landing_along:(y[2x4],z[2],T,p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12;
  a00=arg[0]? arg[0][2] : 0;
  a01=1.;
  a02=(a00-a01);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[3]? arg[3][2] : 0;
  a03=(1./a02);
  a04=6.2831853071795862e+00;
  a05=arg[3]? arg[3][1] : 0;
  a04=(a04/a05);
  a06=cos(a04);
  a06=(a03+a06);
  a06=(a06-a01);
  a07=(a02*a06);
  a08=arg[0]? arg[0][3] : 0;
  a08=(a07*a08);
  if (res[0]!=0) res[0][1]=a08;
  a08=arg[0]? arg[0][0] : 0;
  a09=sin(a08);
  a00=(a09*a00);
  if (res[0]!=0) res[0][2]=a00;
  a00=arg[0]? arg[0][4] : 0;
  if (res[0]!=0) res[0][3]=a00;
  a10=arg[0]? arg[0][5] : 0;
  a10=(a07*a10);
  a10=(a10-a01);
  if (res[0]!=0) res[0][4]=a10;
  a00=(a09*a00);
  if (res[0]!=0) res[0][5]=a00;
  a00=arg[0]? arg[0][1] : 0;
  if (res[0]!=0) res[0][6]=a00;
  a10=arg[3]? arg[3][0] : 0;
  a10=(a10+a08);
  a10=sin(a10);
  a10=(a10*a02);
  a07=(a07*a10);
  if (res[0]!=0) res[0][7]=a07;
  a07=(a09*a00);
  if (res[0]!=0) res[0][8]=a07;
  a07=arg[0]? arg[0][6] : 0;
  a10=(a04/a05);
  a01=arg[4]? arg[4][1] : 0;
  a10=(a10*a01);
  a11=(a07+a10);
  if (res[1]!=0) res[1][0]=a11;
  a11=arg[0]? arg[0][7] : 0;
  a11=(a06*a11);
  a12=sin(a04);
  a12=(a12*a10);
  a03=(a03/a02);
  a10=arg[4]? arg[4][2] : 0;
  a03=(a03*a10);
  a12=(a12-a03);
  a12=(a00*a12);
  a11=(a11+a12);
  a11=(a02*a11);
  a00=(a00*a06);
  a10=(a00*a10);
  a11=(a11+a10);
  if (res[1]!=0) res[1][1]=a11;
  a11=3.1415926535897931e+00;
  a11=(a11/a05);
  a10=sin(a11);
  a05=(a11/a05);
  a05=(a05*a01);
  a10=(a10*a05);
  a09=(a09*a07);
  a10=(a10+a09);
  if (res[1]!=0) res[1][2]=a10;
  a04=(a08-a04);
  a10=arg[1]? arg[1][0] : 0;
  a04=(a04-a10);
  if (res[2]!=0) res[2][0]=a04;
  a00=(a00*a02);
  a02=arg[1]? arg[1][1] : 0;
  a00=(a00-a02);
  if (res[2]!=0) res[2][1]=a00;
  a11=cos(a11);
  a08=cos(a08);
  a11=(a11-a08);
  if (res[2]!=0) res[2][2]=a11;
  return 0;
}

/* rimless_wheel_jacobian_along_12:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@10, @0, @11} = landing_along(@9, @1, @6, @2, @3) */
  arg1[0]=w09;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #14: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f62(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_12_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_12_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_24:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #14: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #17: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f67(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_24_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_36:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #17: {@10, @0, @11} = landing_along(@9, @1, @6, @2, @3) */
  arg1[0]=w09;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #20: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f68(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_36_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_36_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_36_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_36_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_36_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_36_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_36_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_36_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_36_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_36_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_36_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_36_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_48:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #20: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #23: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f69(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_48_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_72:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #26: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #29: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_72_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_72_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_96:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #32: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #35: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_96_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_144:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #44: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #47: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_144_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_144_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_192:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #56: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #59: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f73(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_192_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_288:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #80: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #83: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f74(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_288_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_288_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_jacobian_along_384:(u[3],p[3],d[3])->(J[3x3],R_d[3],R[3]) */
static int casadi_f75(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, *w00=w+166, *w01=w+169, *w02=w+171, *w03=w+174, *w04=w+177, w05, w06, w07, *w08=w+185, *w09=w+209;
  casadi_real *w10=w+217, *w11=w+226;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w00);
  /* #1: @1 = @0[:2] */
  for (rr=w01, cs=w00+0; cs!=w00+2; cs+=1) *rr++ = *cs;
  /* #2: @2 = input[1][0] */
  casadi_copy(arg[1], 3, w02);
  /* #3: @3 = input[2][0] */
  casadi_copy(arg[2], 3, w03);
  /* #4: @4 = start_along(@1, @2, @3) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w03;
  res1[0]=w04;
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  arg1[1]=w02;
  res1[0]=w08;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @9 = step_alongs(@4, @5, @8, @7, @2, @3) */
  arg1[0]=w04;
  arg1[1]=(&w05);
  arg1[2]=w08;
  arg1[3]=(&w07);
  arg1[4]=w02;
  arg1[5]=w03;
  res1[0]=w09;
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
  /* #104: {@10, @0, @11} = landing_along(@4, @1, @6, @2, @3) */
  arg1[0]=w04;
  arg1[1]=w01;
  arg1[2]=(&w06);
  arg1[3]=w02;
  arg1[4]=w03;
  res1[0]=w10;
  res1[1]=w00;
  res1[2]=w11;
  if (casadi_f66(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @10 */
  casadi_copy(w10, 9, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 3, res[1]);
  /* #107: output[2][0] = @11 */
  casadi_copy(w11, 3, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f75(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_jacobian_along_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_384_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_jacobian_along_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_jacobian_along_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    case 2: return "d";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_jacobian_along_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R_d";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_jacobian_along_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 6;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 229;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_jacobian_along_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 6*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 229*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[2],phase[2],turns[2x12],h,p[3])->(y_end[2]) */
static int casadi_f78(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45;
  a00=arg[0]? arg[0][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[3]? arg[3][0] : 0;
  a01=(a01*a02);
  a03=arg[0]? arg[0][1] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[4]? arg[4][0] : 0;
  a08=(a07+a00);
  a08=sin(a08);
  a09=arg[4]? arg[4][2] : 0;
  a08=(a08*a09);
  a10=(a06*a08);
  a11=1.7082860872947386e-01;
  a11=(a11*a02);
  a12=2.9587585476806851e-02;
  a12=(a12*a02);
  a13=(a12*a03);
  a14=8.8762756430420545e-02;
  a14=(a14*a02);
  a15=1.9725056984537900e-02;
  a15=(a15*a02);
  a16=(a15*a08);
  a17=5.9175170953613701e-02;
  a17=(a17*a02);
  a18=5.2600151958767730e-02;
  a18=(a18*a02);
  a19=(a18*a03);
  a19=(a00+a19);
  a19=(a07+a19);
  a19=sin(a19);
  a19=(a19*a09);
  a19=(a17*a19);
  a16=(a16+a19);
  a16=(a03+a16);
  a19=(a14*a16);
  a13=(a13+a19);
  a13=(a00+a13);
  a13=(a07+a13);
  a13=sin(a13);
  a13=(a13*a09);
  a19=(a11*a13);
  a10=(a10+a19);
  a19=1.2546768756682242e-01;
  a19=(a19*a02);
  a20=2.4136513415926669e-01;
  a20=(a20*a02);
  a21=(a20*a03);
  a22=-8.8454947932828609e-01;
  a22=(a22*a02);
  a16=(a22*a16);
  a21=(a21+a16);
  a16=9.2483400326179199e-01;
  a16=(a16*a02);
  a12=(a12*a08);
  a15=(a15*a03);
  a18=(a18*a08);
  a18=(a03+a18);
  a17=(a17*a18);
  a15=(a15+a17);
  a15=(a00+a15);
  a15=(a07+a15);
  a15=sin(a15);
  a15=(a15*a09);
  a14=(a14*a15);
  a12=(a12+a14);
  a12=(a03+a12);
  a14=(a16*a12);
  a21=(a21+a14);
  a21=(a00+a21);
  a21=(a07+a21);
  a21=sin(a21);
  a21=(a21*a09);
  a14=(a19*a21);
  a10=(a10+a14);
  a10=(a03+a10);
  a14=(a05*a10);
  a04=(a04+a14);
  a14=1.8915178993145003e+00;
  a14=(a14*a02);
  a17=3.7109375000000000e-02;
  a17=(a17*a02);
  a18=(a17*a08);
  a23=1.7025221101954405e-01;
  a23=(a23*a02);
  a24=(a23*a13);
  a18=(a18+a24);
  a24=6.0216538980455959e-02;
  a24=(a24*a02);
  a25=(a24*a21);
  a18=(a18+a25);
  a25=-1.7578125000000000e-02;
  a25=(a25*a02);
  a06=(a06*a03);
  a11=(a11*a12);
  a06=(a06+a11);
  a20=(a20*a08);
  a22=(a22*a15);
  a20=(a20+a22);
  a16=(a16*a13);
  a20=(a20+a16);
  a20=(a03+a20);
  a19=(a19*a20);
  a06=(a06+a19);
  a06=(a00+a06);
  a06=(a07+a06);
  a06=sin(a06);
  a06=(a06*a09);
  a19=(a25*a06);
  a18=(a18+a19);
  a18=(a03+a18);
  a19=(a14*a18);
  a04=(a04+a19);
  a19=-5.8012039600105849e+00;
  a19=(a19*a02);
  a16=3.7092000118504789e-02;
  a16=(a16*a02);
  a22=(a16*a08);
  a15=1.7038392571223998e-01;
  a15=(a15*a02);
  a11=(a15*a13);
  a22=(a22+a11);
  a11=1.0726203044637328e-01;
  a11=(a11*a02);
  a26=(a11*a21);
  a22=(a22+a26);
  a26=-1.5319437748624402e-02;
  a26=(a26*a02);
  a27=(a26*a06);
  a22=(a22+a27);
  a27=8.2737891638140233e-03;
  a27=(a27*a02);
  a17=(a17*a03);
  a23=(a23*a12);
  a17=(a17+a23);
  a24=(a24*a20);
  a17=(a17+a24);
  a25=(a25*a10);
  a17=(a17+a25);
  a17=(a00+a17);
  a17=(a07+a17);
  a17=sin(a17);
  a17=(a17*a09);
  a25=(a27*a17);
  a22=(a22+a25);
  a22=(a03+a22);
  a25=(a19*a22);
  a04=(a04+a25);
  a25=3.1116436695781990e-01;
  a25=(a25*a02);
  a24=6.2411095871607569e-01;
  a24=(a24*a02);
  a23=(a24*a08);
  a28=-3.3608926294469414e+00;
  a28=(a28*a02);
  a29=(a28*a13);
  a23=(a23+a29);
  a29=-8.6821934684172597e-01;
  a29=(a29*a02);
  a30=(a29*a21);
  a23=(a23+a30);
  a30=2.7592099699446710e+01;
  a30=(a30*a02);
  a31=(a30*a06);
  a23=(a23+a31);
  a31=2.0154067550477894e+01;
  a31=(a31*a02);
  a32=(a31*a17);
  a23=(a23+a32);
  a32=-4.3489884181069961e+01;
  a32=(a32*a02);
  a16=(a16*a03);
  a15=(a15*a12);
  a16=(a16+a15);
  a11=(a11*a20);
  a16=(a16+a11);
  a26=(a26*a10);
  a16=(a16+a26);
  a27=(a27*a18);
  a16=(a16+a27);
  a16=(a00+a16);
  a16=(a07+a16);
  a16=sin(a16);
  a16=(a16*a09);
  a27=(a32*a16);
  a23=(a23+a27);
  a23=(a03+a23);
  a27=(a25*a23);
  a04=(a04+a27);
  a27=-1.5216094966251609e-01;
  a27=(a27*a02);
  a26=4.7766253643826434e-01;
  a26=(a26*a02);
  a11=(a26*a08);
  a15=-2.4881146199716677e+00;
  a15=(a15*a02);
  a33=(a15*a13);
  a11=(a11+a33);
  a33=-5.9029082683684297e-01;
  a33=(a33*a02);
  a34=(a33*a21);
  a11=(a11+a34);
  a34=2.1230051448181193e+01;
  a34=(a34*a02);
  a35=(a34*a06);
  a11=(a11+a35);
  a35=1.5279233632882423e+01;
  a35=(a35*a02);
  a36=(a35*a17);
  a11=(a11+a36);
  a36=-3.3288210968984863e+01;
  a36=(a36*a02);
  a37=(a36*a16);
  a11=(a11+a37);
  a37=-2.0331201708508627e-02;
  a37=(a37*a02);
  a24=(a24*a03);
  a28=(a28*a12);
  a24=(a24+a28);
  a29=(a29*a20);
  a24=(a24+a29);
  a30=(a30*a10);
  a24=(a24+a30);
  a31=(a31*a18);
  a24=(a24+a31);
  a32=(a32*a22);
  a24=(a24+a32);
  a24=(a00+a24);
  a24=(a07+a24);
  a24=sin(a24);
  a24=(a24*a09);
  a32=(a37*a24);
  a11=(a11+a32);
  a11=(a03+a11);
  a32=(a27*a11);
  a04=(a04+a32);
  a32=2.0136540080403034e-01;
  a32=(a32*a02);
  a31=-9.3714243008598730e-01;
  a31=(a31*a02);
  a30=(a31*a08);
  a29=5.1863724288440638e+00;
  a29=(a29*a02);
  a28=(a29*a13);
  a30=(a30+a28);
  a28=1.0914373489967295e+00;
  a28=(a28*a02);
  a38=(a28*a21);
  a30=(a30+a38);
  a38=-8.1497870107469268e+00;
  a38=(a38*a02);
  a39=(a38*a06);
  a30=(a30+a39);
  a39=-1.8520065659996959e+01;
  a39=(a39*a02);
  a40=(a39*a17);
  a30=(a30+a40);
  a40=2.2739487099350505e+01;
  a40=(a40*a02);
  a41=(a40*a16);
  a30=(a30+a41);
  a41=2.4936055526796523e+00;
  a41=(a41*a02);
  a42=(a41*a24);
  a30=(a30+a42);
  a42=-3.0467644718982196e+00;
  a42=(a42*a02);
  a26=(a26*a03);
  a15=(a15*a12);
  a26=(a26+a15);
  a33=(a33*a20);
  a26=(a26+a33);
  a34=(a34*a10);
  a26=(a26+a34);
  a35=(a35*a18);
  a26=(a26+a35);
  a36=(a36*a22);
  a26=(a26+a36);
  a37=(a37*a23);
  a26=(a26+a37);
  a26=(a00+a26);
  a26=(a07+a26);
  a26=sin(a26);
  a26=(a26*a09);
  a37=(a42*a26);
  a30=(a30+a37);
  a30=(a03+a30);
  a37=(a32*a30);
  a04=(a04+a37);
  a37=4.4710615727772587e-02;
  a37=(a37*a02);
  a36=2.2733101475165380e+00;
  a36=(a36*a02);
  a35=(a36*a08);
  a34=-1.0534495466737249e+01;
  a34=(a34*a02);
  a13=(a34*a13);
  a35=(a35+a13);
  a13=-2.0008720582248625e+00;
  a13=(a13*a02);
  a21=(a13*a21);
  a35=(a35+a21);
  a21=-1.7958931863118799e+01;
  a21=(a21*a02);
  a33=(a21*a06);
  a35=(a35+a33);
  a33=2.7948884529419960e+01;
  a33=(a33*a02);
  a15=(a33*a17);
  a35=(a35+a15);
  a15=-2.8589982771350235e+00;
  a15=(a15*a02);
  a43=(a15*a16);
  a35=(a35+a43);
  a43=-8.8728569335306293e+00;
  a43=(a43*a02);
  a44=(a43*a24);
  a35=(a35+a44);
  a44=1.2360567175794303e+01;
  a44=(a44*a02);
  a45=(a44*a26);
  a35=(a35+a45);
  a45=6.4339274601576357e-01;
  a45=(a45*a02);
  a31=(a31*a03);
  a29=(a29*a12);
  a31=(a31+a29);
  a28=(a28*a20);
  a31=(a31+a28);
  a38=(a38*a10);
  a31=(a31+a38);
  a39=(a39*a18);
  a31=(a31+a39);
  a40=(a40*a22);
  a31=(a31+a40);
  a41=(a41*a23);
  a31=(a31+a41);
  a42=(a42*a11);
  a31=(a31+a42);
  a31=(a00+a31);
  a31=(a07+a31);
  a31=sin(a31);
  a31=(a31*a09);
  a42=(a45*a31);
  a35=(a35+a42);
  a35=(a03+a35);
  a35=(a37*a35);
  a04=(a04+a35);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a01=(a01*a08);
  a05=(a05*a06);
  a01=(a01+a05);
  a14=(a14*a17);
  a01=(a01+a14);
  a19=(a19*a16);
  a01=(a01+a19);
  a25=(a25*a24);
  a01=(a01+a25);
  a27=(a27*a26);
  a01=(a01+a27);
  a32=(a32*a31);
  a01=(a01+a32);
  a36=(a36*a03);
  a34=(a34*a12);
  a36=(a36+a34);
  a13=(a13*a20);
  a36=(a36+a13);
  a21=(a21*a10);
  a36=(a36+a21);
  a33=(a33*a18);
  a36=(a36+a33);
  a15=(a15*a22);
  a36=(a36+a15);
  a43=(a43*a23);
  a36=(a36+a43);
  a44=(a44*a11);
  a36=(a36+a44);
  a45=(a45*a30);
  a36=(a36+a45);
  a00=(a00+a36);
  a07=(a07+a00);
  a07=sin(a07);
  a07=(a07*a09);
  a37=(a37*a07);
  a01=(a01+a37);
  a03=(a03+a01);
  if (res[0]!=0) res[0][1]=a03;
  return 0;
}

/* observe:(t,y[2],p[3])->(g[8],dg[8]) */
static int casadi_f79(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15;
  a00=arg[1]? arg[1][0] : 0;
  a01=sin(a00);
  a02=cos(a00);
  a03=arg[2]? arg[2][0] : 0;
  a04=(a03+a00);
  a05=sin(a04);
  a06=arg[2]? arg[2][2] : 0;
  a05=(a05*a06);
  a07=(a05*a02);
  a08=arg[1]? arg[1][1] : 0;
  a09=casadi_sq(a08);
  a10=(a09*a01);
  a07=(a07-a10);
  a10=sin(a03);
  a07=(a07-a10);
  a10=(a02*a07);
  a03=cos(a03);
  a11=(a05*a01);
  a03=(a03-a11);
  a11=(a02*a08);
  a12=(a11*a08);
  a03=(a03-a12);
  a10=(a10/a03);
  a12=(a01-a10);
  a12=(-a12);
  if (res[0]!=0) res[0][0]=a12;
  a12=0.;
  if (res[0]!=0) res[0][1]=a12;
  if (res[0]!=0) res[0][2]=a03;
  a13=(a07/a03);
  if (res[0]!=0) res[0][3]=a13;
  a14=6.2831853071795862e+00;
  a15=arg[2]? arg[2][1] : 0;
  a14=(a14/a15);
  a00=(a00-a14);
  a14=cos(a00);
  a14=(a02-a14);
  if (res[0]!=0) res[0][4]=a14;
  if (res[0]!=0) res[0][5]=a05;
  a14=3.1415926535897931e+00;
  a14=(a14/a15);
  a14=cos(a14);
  a14=(a14-a02);
  if (res[0]!=0) res[0][6]=a14;
  if (res[0]!=0) res[0][7]=a12;
  a04=cos(a04);
  a04=(a04*a08);
  a06=(a06*a04);
  a04=(a02*a06);
  a14=(a01*a08);
  a15=(a05*a14);
  a04=(a04-a15);
  a15=(2.*a08);
  a15=(a15*a05);
  a15=(a01*a15);
  a09=(a09*a11);
  a15=(a15+a09);
  a04=(a04-a15);
  a15=(a02*a04);
  a07=(a07*a14);
  a15=(a15-a07);
  a15=(a15/a03);
  a10=(a10/a03);
  a01=(a01*a06);
  a07=(a05*a11);
  a01=(a01+a07);
  a02=(a02*a05);
  a07=(a08*a14);
  a02=(a02-a07);
  a02=(a08*a02);
  a05=(a11*a05);
  a02=(a02+a05);
  a01=(a01+a02);
  a10=(a10*a01);
  a15=(a15+a10);
  a11=(a11-a15);
  a11=(-a11);
  if (res[1]!=0) res[1][0]=a11;
  if (res[1]!=0) res[1][1]=a12;
  a11=(-a01);
  if (res[1]!=0) res[1][2]=a11;
  a04=(a04/a03);
  a13=(a13/a03);
  a13=(a13*a01);
  a04=(a04+a13);
  if (res[1]!=0) res[1][3]=a04;
  a00=sin(a00);
  a00=(a00*a08);
  a00=(a00-a14);
  if (res[1]!=0) res[1][4]=a00;
  if (res[1]!=0) res[1][5]=a06;
  if (res[1]!=0) res[1][6]=a14;
  if (res[1]!=0) res[1][7]=a12;
  return 0;
}

/* working_steps:(t,turns[2x12],w[2],h,p[3])->(w_end[2],nodes[2x12],g[8x12],dg[8x12]) */
static int casadi_f77(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+46, w01, *w02=w+48, *w03=w+51, w05, *w06=w+53, w07, *w08=w+55, *w09=w+57, *w10=w+59, *w11=w+61;
  casadi_real *w12=w+63, *w13=w+65, *w14=w+67, *w15=w+69, *w16=w+71, *w17=w+73, *w18=w+75, *w19=w+77, *w20=w+85, *w21=w+93, *w22=w+101, *w23=w+109;
  casadi_real *w24=w+117, *w25=w+125, *w26=w+133, *w27=w+141, *w28=w+149, *w29=w+157, *w30=w+165, *w31=w+173;
  const casadi_real **arg1=arg+5, *wr04;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 2, w00);
  /* #1: @1 = input[0][0] */
  w01 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[4][0] */
  casadi_copy(arg[4], 3, w02);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w01);
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #7: @7 = (@1+@5) */
  w07  = (w01+w05);
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @8 = working_step(@6, @3, @4, @5, @2) */
  arg1[0]=w06;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w08;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w07 = (2.* w05 );
  /* #11: @7 = (@1+@7) */
  w07  = (w01+w07);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w07);
  arg1[1]=w02;
  res1[0]=w03;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #13: @9 = working_step(@8, @3, @4, @5, @2) */
  arg1[0]=w08;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w09;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #18: @10 = working_step(@9, @3, @4, @5, @2) */
  arg1[0]=w09;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #23: @11 = working_step(@10, @3, @4, @5, @2) */
  arg1[0]=w10;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w11;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #28: @12 = working_step(@11, @3, @4, @5, @2) */
  arg1[0]=w11;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w12;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #33: @13 = working_step(@12, @3, @4, @5, @2) */
  arg1[0]=w12;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w13;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #38: @14 = working_step(@13, @3, @4, @5, @2) */
  arg1[0]=w13;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w14;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #43: @15 = working_step(@14, @3, @4, @5, @2) */
  arg1[0]=w14;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w15;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #48: @16 = working_step(@15, @3, @4, @5, @2) */
  arg1[0]=w15;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w16;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #53: @17 = working_step(@16, @3, @4, @5, @2) */
  arg1[0]=w16;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w17;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #58: @18 = working_step(@17, @3, @4, @5, @2) */
  arg1[0]=w17;
  arg1[1]=w03;
  arg1[2]=wr04;
  arg1[3]=(&w05);
  arg1[4]=w02;
  res1[0]=w18;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @18 */
  casadi_copy(w18, 2, res[0]);
  /* #60: output[1][0] = @0 */
  casadi_copy(w00, 2, res[1]);
  /* #61: output[1][1] = @6 */
  if (res[1]) casadi_copy(w06, 2, res[1]+2);
  /* #62: output[1][2] = @8 */
  if (res[1]) casadi_copy(w08, 2, res[1]+4);
  /* #63: output[1][3] = @9 */
  if (res[1]) casadi_copy(w09, 2, res[1]+6);
  /* #64: output[1][4] = @10 */
  if (res[1]) casadi_copy(w10, 2, res[1]+8);
  /* #65: output[1][5] = @11 */
  if (res[1]) casadi_copy(w11, 2, res[1]+10);
  /* #66: output[1][6] = @12 */
  if (res[1]) casadi_copy(w12, 2, res[1]+12);
  /* #67: output[1][7] = @13 */
  if (res[1]) casadi_copy(w13, 2, res[1]+14);
  /* #68: output[1][8] = @14 */
  if (res[1]) casadi_copy(w14, 2, res[1]+16);
  /* #69: output[1][9] = @15 */
  if (res[1]) casadi_copy(w15, 2, res[1]+18);
  /* #70: output[1][10] = @16 */
  if (res[1]) casadi_copy(w16, 2, res[1]+20);
  /* #71: output[1][11] = @17 */
  if (res[1]) casadi_copy(w17, 2, res[1]+22);
  /* #72: {@19, @20} = observe(@1, @0, @2) */
  arg1[0]=(&w01);
  arg1[1]=w00;
  arg1[2]=w02;
  res1[0]=w19;
  res1[1]=w20;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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

/* rimless_wheel_trace_48:(u[3],p[3])->(w[2x49],g[8x49],dg[8x49],R[3]) */
static int casadi_f76(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1044;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: output[0][4] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+96);
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
  arg1[2]=w04;
  res1[0]=w18;
  res1[1]=w19;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f76(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s6;
    case 1: return casadi_s7;
    case 2: return casadi_s7;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1052;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1052*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_72:(u[3],p[3])->(w[2x73],g[8x73],dg[8x73],R[3]) */
static int casadi_f80(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1132, *w20=w+1228, *w21=w+1324;
  casadi_real *w22=w+1420, *w23=w+1428;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+96);
  /* #27: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+120);
  /* #31: output[0][6] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+144);
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
  arg1[2]=w04;
  res1[0]=w22;
  res1[1]=w23;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f80(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_72_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_72_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_72_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_72_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_72_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_72_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_72_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_72_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_72_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_72_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_72_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s8;
    case 1: return casadi_s9;
    case 2: return casadi_s9;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_72_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1436;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1436*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_96:(u[3],p[3])->(w[2x97],g[8x97],dg[8x97],R[3]) */
static int casadi_f81(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1132, *w20=w+1228, *w21=w+1324;
  casadi_real *w22=w+1420, *w23=w+1516, *w24=w+1612, *w25=w+1708, *w26=w+1804, *w27=w+1812;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+96);
  /* #27: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+120);
  /* #31: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+144);
  /* #35: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+168);
  /* #39: output[0][8] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+192);
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
  arg1[2]=w04;
  res1[0]=w26;
  res1[1]=w27;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f81(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s10;
    case 1: return casadi_s11;
    case 2: return casadi_s11;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1820;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1820*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_144:(u[3],p[3])->(w[2x145],g[8x145],dg[8x145],R[3]) */
static int casadi_f82(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1132, *w20=w+1228, *w21=w+1324;
  casadi_real *w22=w+1420, *w23=w+1516, *w24=w+1612, *w25=w+1708, *w26=w+1804, *w27=w+1900, *w28=w+1996, *w29=w+2092, *w30=w+2188, *w31=w+2284, *w32=w+2380, *w33=w+2476;
  casadi_real *w34=w+2572, *w35=w+2580;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+96);
  /* #27: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+120);
  /* #31: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+144);
  /* #35: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+168);
  /* #39: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+192);
  /* #43: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+216);
  /* #47: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+240);
  /* #51: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+264);
  /* #55: output[0][12] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+288);
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
  arg1[2]=w04;
  res1[0]=w34;
  res1[1]=w35;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f82(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_144_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_144_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_144_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_144_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_144_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_144_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_144_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_144_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_144_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_144_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_144_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s12;
    case 1: return casadi_s13;
    case 2: return casadi_s13;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_144_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2588;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2588*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_192:(u[3],p[3])->(w[2x193],g[8x193],dg[8x193],R[3]) */
static int casadi_f83(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1132, *w20=w+1228, *w21=w+1324;
  casadi_real *w22=w+1420, *w23=w+1516, *w24=w+1612, *w25=w+1708, *w26=w+1804, *w27=w+1900, *w28=w+1996, *w29=w+2092, *w30=w+2188, *w31=w+2284, *w32=w+2380, *w33=w+2476;
  casadi_real *w34=w+2572, *w35=w+2668, *w36=w+2764, *w37=w+2860, *w38=w+2956, *w39=w+3052, *w40=w+3148, *w41=w+3244, *w42=w+3340, *w43=w+3348;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+96);
  /* #27: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+120);
  /* #31: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+144);
  /* #35: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+168);
  /* #39: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+192);
  /* #43: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+216);
  /* #47: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+240);
  /* #51: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+264);
  /* #55: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+288);
  /* #59: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+312);
  /* #63: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+336);
  /* #67: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+360);
  /* #71: output[0][16] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+384);
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
  arg1[2]=w04;
  res1[0]=w42;
  res1[1]=w43;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f83(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s14;
    case 1: return casadi_s15;
    case 2: return casadi_s15;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3356;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3356*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_288:(u[3],p[3])->(w[2x289],g[8x289],dg[8x289],R[3]) */
static int casadi_f84(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1132, *w20=w+1228, *w21=w+1324;
  casadi_real *w22=w+1420, *w23=w+1516, *w24=w+1612, *w25=w+1708, *w26=w+1804, *w27=w+1900, *w28=w+1996, *w29=w+2092, *w30=w+2188, *w31=w+2284, *w32=w+2380, *w33=w+2476;
  casadi_real *w34=w+2572, *w35=w+2668, *w36=w+2764, *w37=w+2860, *w38=w+2956, *w39=w+3052, *w40=w+3148, *w41=w+3244, *w42=w+3340, *w43=w+3436, *w44=w+3532, *w45=w+3628;
  casadi_real *w46=w+3724, *w47=w+3820, *w48=w+3916, *w49=w+4012, *w50=w+4108, *w51=w+4204, *w52=w+4300, *w53=w+4396, *w54=w+4492, *w55=w+4588, *w56=w+4684, *w57=w+4780;
  casadi_real *w58=w+4876, *w59=w+4884;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.0416667 */
  w00 = 4.1666666666666664e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.0833333 */
  w00 = 8.3333333333333329e-02;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: @0 = 0.166667 */
  w00 = 1.6666666666666666e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+96);
  /* #27: @0 = 0.208333 */
  w00 = 2.0833333333333334e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+120);
  /* #31: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+144);
  /* #35: @0 = 0.291667 */
  w00 = 2.9166666666666669e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+168);
  /* #39: @0 = 0.333333 */
  w00 = 3.3333333333333331e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+192);
  /* #43: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+216);
  /* #47: @0 = 0.416667 */
  w00 = 4.1666666666666669e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+240);
  /* #51: @0 = 0.458333 */
  w00 = 4.5833333333333331e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+264);
  /* #55: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+288);
  /* #59: @0 = 0.541667 */
  w00 = 5.4166666666666663e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+312);
  /* #63: @0 = 0.583333 */
  w00 = 5.8333333333333337e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+336);
  /* #67: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+360);
  /* #71: @0 = 0.666667 */
  w00 = 6.6666666666666663e-01;
  /* #72: @0 = (@0*@2) */
  w00 *= w02;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w42;
  res1[3]=w43;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+384);
  /* #75: @0 = 0.708333 */
  w00 = 7.0833333333333337e-01;
  /* #76: @0 = (@0*@2) */
  w00 *= w02;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w44;
  res1[3]=w45;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+408);
  /* #79: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w00 *= w02;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w46;
  res1[3]=w47;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+432);
  /* #83: @0 = 0.791667 */
  w00 = 7.9166666666666663e-01;
  /* #84: @0 = (@0*@2) */
  w00 *= w02;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w48;
  res1[3]=w49;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+456);
  /* #87: @0 = 0.833333 */
  w00 = 8.3333333333333337e-01;
  /* #88: @0 = (@0*@2) */
  w00 *= w02;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w50;
  res1[3]=w51;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+480);
  /* #91: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w00 *= w02;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w52;
  res1[3]=w53;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+504);
  /* #95: @0 = 0.916667 */
  w00 = 9.1666666666666663e-01;
  /* #96: @0 = (@0*@2) */
  w00 *= w02;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w54;
  res1[3]=w55;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+528);
  /* #99: @0 = 0.958333 */
  w00 = 9.5833333333333337e-01;
  /* #100: @0 = (@0*@2) */
  w00 *= w02;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w56;
  res1[3]=w57;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+552);
  /* #103: output[0][24] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+576);
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
  arg1[2]=w04;
  res1[0]=w58;
  res1[1]=w59;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f84(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_288_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_288_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_288_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_288_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_288_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_288_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_288_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_288_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_288_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_288_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_288_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s16;
    case 1: return casadi_s17;
    case 2: return casadi_s17;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_288_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 4892;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4892*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_384:(u[3],p[3])->(w[2x385],g[8x385],dg[8x385],R[3]) */
static int casadi_f85(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+208, w02, w03, *w04=w+211, *w05=w+214, *w06=w+238, *w07=w+240, *w08=w+242, *w09=w+244;
  casadi_real *w10=w+268, *w11=w+364, *w12=w+460, *w13=w+556, *w14=w+652, *w15=w+748, *w16=w+844, *w17=w+940, *w18=w+1036, *w19=w+1132, *w20=w+1228, *w21=w+1324;
  casadi_real *w22=w+1420, *w23=w+1516, *w24=w+1612, *w25=w+1708, *w26=w+1804, *w27=w+1900, *w28=w+1996, *w29=w+2092, *w30=w+2188, *w31=w+2284, *w32=w+2380, *w33=w+2476;
  casadi_real *w34=w+2572, *w35=w+2668, *w36=w+2764, *w37=w+2860, *w38=w+2956, *w39=w+3052, *w40=w+3148, *w41=w+3244, *w42=w+3340, *w43=w+3436, *w44=w+3532, *w45=w+3628;
  casadi_real *w46=w+3724, *w47=w+3820, *w48=w+3916, *w49=w+4012, *w50=w+4108, *w51=w+4204, *w52=w+4300, *w53=w+4396, *w54=w+4492, *w55=w+4588, *w56=w+4684, *w57=w+4780;
  casadi_real *w58=w+4876, *w59=w+4972, *w60=w+5068, *w61=w+5164, *w62=w+5260, *w63=w+5356, *w64=w+5452, *w65=w+5548, *w66=w+5644, *w67=w+5740, *w68=w+5836, *w69=w+5932;
  casadi_real *w70=w+6028, *w71=w+6124, *w72=w+6220, *w73=w+6316, *w74=w+6412, *w75=w+6420;
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
  casadi_copy(arg[1], 3, w04);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w03);
  arg1[1]=w04;
  res1[0]=w05;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w06, cs=w01+0; cs!=w01+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w07;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w09, 24, res[0]);
  /* #11: @0 = 0.03125 */
  w00 = 3.1250000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w00 *= w02;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+24);
  /* #15: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #16: @0 = (@0*@2) */
  w00 *= w02;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+48);
  /* #19: @0 = 0.09375 */
  w00 = 9.3750000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w00 *= w02;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+72);
  /* #23: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #24: @0 = (@0*@2) */
  w00 *= w02;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+96);
  /* #27: @0 = 0.15625 */
  w00 = 1.5625000000000000e-01;
  /* #28: @0 = (@0*@2) */
  w00 *= w02;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+120);
  /* #31: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w00 *= w02;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+144);
  /* #35: @0 = 0.21875 */
  w00 = 2.1875000000000000e-01;
  /* #36: @0 = (@0*@2) */
  w00 *= w02;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+168);
  /* #39: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w00 *= w02;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+192);
  /* #43: @0 = 0.28125 */
  w00 = 2.8125000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w00 *= w02;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+216);
  /* #47: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w00 *= w02;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+240);
  /* #51: @0 = 0.34375 */
  w00 = 3.4375000000000000e-01;
  /* #52: @0 = (@0*@2) */
  w00 *= w02;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+264);
  /* #55: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w00 *= w02;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+288);
  /* #59: @0 = 0.40625 */
  w00 = 4.0625000000000000e-01;
  /* #60: @0 = (@0*@2) */
  w00 *= w02;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+312);
  /* #63: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w00 *= w02;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+336);
  /* #67: @0 = 0.46875 */
  w00 = 4.6875000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w00 *= w02;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+360);
  /* #71: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #72: @0 = (@0*@2) */
  w00 *= w02;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w42;
  res1[3]=w43;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+384);
  /* #75: @0 = 0.53125 */
  w00 = 5.3125000000000000e-01;
  /* #76: @0 = (@0*@2) */
  w00 *= w02;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w44;
  res1[3]=w45;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+408);
  /* #79: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w00 *= w02;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w46;
  res1[3]=w47;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+432);
  /* #83: @0 = 0.59375 */
  w00 = 5.9375000000000000e-01;
  /* #84: @0 = (@0*@2) */
  w00 *= w02;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w48;
  res1[3]=w49;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+456);
  /* #87: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #88: @0 = (@0*@2) */
  w00 *= w02;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w50;
  res1[3]=w51;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+480);
  /* #91: @0 = 0.65625 */
  w00 = 6.5625000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w00 *= w02;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w52;
  res1[3]=w53;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+504);
  /* #95: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #96: @0 = (@0*@2) */
  w00 *= w02;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w54;
  res1[3]=w55;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+528);
  /* #99: @0 = 0.71875 */
  w00 = 7.1875000000000000e-01;
  /* #100: @0 = (@0*@2) */
  w00 *= w02;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w56;
  res1[3]=w57;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+552);
  /* #103: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w00 *= w02;
  /* #105: {@8, @9, @58, @59} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w58;
  res1[3]=w59;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+576);
  /* #107: @0 = 0.78125 */
  w00 = 7.8125000000000000e-01;
  /* #108: @0 = (@0*@2) */
  w00 *= w02;
  /* #109: {@7, @9, @60, @61} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w60;
  res1[3]=w61;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+600);
  /* #111: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #112: @0 = (@0*@2) */
  w00 *= w02;
  /* #113: {@8, @9, @62, @63} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w62;
  res1[3]=w63;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+624);
  /* #115: @0 = 0.84375 */
  w00 = 8.4375000000000000e-01;
  /* #116: @0 = (@0*@2) */
  w00 *= w02;
  /* #117: {@7, @9, @64, @65} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w64;
  res1[3]=w65;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+648);
  /* #119: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #120: @0 = (@0*@2) */
  w00 *= w02;
  /* #121: {@8, @9, @66, @67} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w66;
  res1[3]=w67;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+672);
  /* #123: @0 = 0.90625 */
  w00 = 9.0625000000000000e-01;
  /* #124: @0 = (@0*@2) */
  w00 *= w02;
  /* #125: {@7, @9, @68, @69} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w68;
  res1[3]=w69;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+696);
  /* #127: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w00 *= w02;
  /* #129: {@8, @9, @70, @71} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w07;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w70;
  res1[3]=w71;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+720);
  /* #131: @0 = 0.96875 */
  w00 = 9.6875000000000000e-01;
  /* #132: @0 = (@0*@2) */
  w00 *= w02;
  /* #133: {@7, @9, @72, @73} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=w08;
  arg1[3]=(&w03);
  arg1[4]=w04;
  res1[0]=w07;
  res1[1]=w09;
  res1[2]=w72;
  res1[3]=w73;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @9 */
  if (res[0]) casadi_copy(w09, 24, res[0]+744);
  /* #135: output[0][32] = @7 */
  if (res[0]) casadi_copy(w07, 2, res[0]+768);
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
  arg1[2]=w04;
  res1[0]=w74;
  res1[1]=w75;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w04;
  res1[0]=w01;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #204: output[3][0] = @1 */
  casadi_copy(w01, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f85(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s18;
    case 1: return casadi_s19;
    case 2: return casadi_s19;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6428;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6428*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_576:(u[3],p[3])->(w[2x577],g[8x577],dg[8x577],R[3]) */
static int casadi_f86(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+208, w002, w003, *w004=w+211, *w005=w+214, *w006=w+238, *w007=w+240, *w008=w+242, *w009=w+244;
  casadi_real *w010=w+268, *w011=w+364, *w012=w+460, *w013=w+556, *w014=w+652, *w015=w+748, *w016=w+844, *w017=w+940, *w018=w+1036, *w019=w+1132, *w020=w+1228, *w021=w+1324;
  casadi_real *w022=w+1420, *w023=w+1516, *w024=w+1612, *w025=w+1708, *w026=w+1804, *w027=w+1900, *w028=w+1996, *w029=w+2092, *w030=w+2188, *w031=w+2284, *w032=w+2380, *w033=w+2476;
  casadi_real *w034=w+2572, *w035=w+2668, *w036=w+2764, *w037=w+2860, *w038=w+2956, *w039=w+3052, *w040=w+3148, *w041=w+3244, *w042=w+3340, *w043=w+3436, *w044=w+3532, *w045=w+3628;
  casadi_real *w046=w+3724, *w047=w+3820, *w048=w+3916, *w049=w+4012, *w050=w+4108, *w051=w+4204, *w052=w+4300, *w053=w+4396, *w054=w+4492, *w055=w+4588, *w056=w+4684, *w057=w+4780;
  casadi_real *w058=w+4876, *w059=w+4972, *w060=w+5068, *w061=w+5164, *w062=w+5260, *w063=w+5356, *w064=w+5452, *w065=w+5548, *w066=w+5644, *w067=w+5740, *w068=w+5836, *w069=w+5932;
  casadi_real *w070=w+6028, *w071=w+6124, *w072=w+6220, *w073=w+6316, *w074=w+6412, *w075=w+6508, *w076=w+6604, *w077=w+6700, *w078=w+6796, *w079=w+6892, *w080=w+6988, *w081=w+7084;
  casadi_real *w082=w+7180, *w083=w+7276, *w084=w+7372, *w085=w+7468, *w086=w+7564, *w087=w+7660, *w088=w+7756, *w089=w+7852, *w090=w+7948, *w091=w+8044, *w092=w+8140, *w093=w+8236;
  casadi_real *w094=w+8332, *w095=w+8428, *w096=w+8524, *w097=w+8620, *w098=w+8716, *w099=w+8812, *w100=w+8908, *w101=w+9004, *w102=w+9100, *w103=w+9196, *w104=w+9292, *w105=w+9388;
  casadi_real *w106=w+9484, *w107=w+9492;
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
  casadi_copy(arg[1], 3, w004);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=w004;
  res1[0]=w005;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w006, cs=w001+0; cs!=w001+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=w004;
  res1[0]=w007;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w010;
  res1[3]=w011;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w009, 24, res[0]);
  /* #11: @0 = 0.0208333 */
  w000 = 2.0833333333333332e-02;
  /* #12: @0 = (@0*@2) */
  w000 *= w002;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w012;
  res1[3]=w013;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+24);
  /* #15: @0 = 0.0416667 */
  w000 = 4.1666666666666664e-02;
  /* #16: @0 = (@0*@2) */
  w000 *= w002;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w014;
  res1[3]=w015;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+48);
  /* #19: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w000 *= w002;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w016;
  res1[3]=w017;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+72);
  /* #23: @0 = 0.0833333 */
  w000 = 8.3333333333333329e-02;
  /* #24: @0 = (@0*@2) */
  w000 *= w002;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w018;
  res1[3]=w019;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+96);
  /* #27: @0 = 0.104167 */
  w000 = 1.0416666666666667e-01;
  /* #28: @0 = (@0*@2) */
  w000 *= w002;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w020;
  res1[3]=w021;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+120);
  /* #31: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #32: @0 = (@0*@2) */
  w000 *= w002;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w022;
  res1[3]=w023;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+144);
  /* #35: @0 = 0.145833 */
  w000 = 1.4583333333333334e-01;
  /* #36: @0 = (@0*@2) */
  w000 *= w002;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w024;
  res1[3]=w025;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+168);
  /* #39: @0 = 0.166667 */
  w000 = 1.6666666666666666e-01;
  /* #40: @0 = (@0*@2) */
  w000 *= w002;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w026;
  res1[3]=w027;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+192);
  /* #43: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #44: @0 = (@0*@2) */
  w000 *= w002;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w028;
  res1[3]=w029;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+216);
  /* #47: @0 = 0.208333 */
  w000 = 2.0833333333333334e-01;
  /* #48: @0 = (@0*@2) */
  w000 *= w002;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w030;
  res1[3]=w031;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+240);
  /* #51: @0 = 0.229167 */
  w000 = 2.2916666666666666e-01;
  /* #52: @0 = (@0*@2) */
  w000 *= w002;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w032;
  res1[3]=w033;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+264);
  /* #55: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w000 *= w002;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w034;
  res1[3]=w035;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+288);
  /* #59: @0 = 0.270833 */
  w000 = 2.7083333333333331e-01;
  /* #60: @0 = (@0*@2) */
  w000 *= w002;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w036;
  res1[3]=w037;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+312);
  /* #63: @0 = 0.291667 */
  w000 = 2.9166666666666669e-01;
  /* #64: @0 = (@0*@2) */
  w000 *= w002;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w038;
  res1[3]=w039;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+336);
  /* #67: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #68: @0 = (@0*@2) */
  w000 *= w002;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w040;
  res1[3]=w041;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+360);
  /* #71: @0 = 0.333333 */
  w000 = 3.3333333333333331e-01;
  /* #72: @0 = (@0*@2) */
  w000 *= w002;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w042;
  res1[3]=w043;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+384);
  /* #75: @0 = 0.354167 */
  w000 = 3.5416666666666669e-01;
  /* #76: @0 = (@0*@2) */
  w000 *= w002;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w044;
  res1[3]=w045;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+408);
  /* #79: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w000 *= w002;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w046;
  res1[3]=w047;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+432);
  /* #83: @0 = 0.395833 */
  w000 = 3.9583333333333331e-01;
  /* #84: @0 = (@0*@2) */
  w000 *= w002;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w048;
  res1[3]=w049;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+456);
  /* #87: @0 = 0.416667 */
  w000 = 4.1666666666666669e-01;
  /* #88: @0 = (@0*@2) */
  w000 *= w002;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w050;
  res1[3]=w051;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+480);
  /* #91: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #92: @0 = (@0*@2) */
  w000 *= w002;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w052;
  res1[3]=w053;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+504);
  /* #95: @0 = 0.458333 */
  w000 = 4.5833333333333331e-01;
  /* #96: @0 = (@0*@2) */
  w000 *= w002;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w054;
  res1[3]=w055;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+528);
  /* #99: @0 = 0.479167 */
  w000 = 4.7916666666666669e-01;
  /* #100: @0 = (@0*@2) */
  w000 *= w002;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w056;
  res1[3]=w057;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+552);
  /* #103: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w000 *= w002;
  /* #105: {@8, @9, @58, @59} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w058;
  res1[3]=w059;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+576);
  /* #107: @0 = 0.520833 */
  w000 = 5.2083333333333337e-01;
  /* #108: @0 = (@0*@2) */
  w000 *= w002;
  /* #109: {@7, @9, @60, @61} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w060;
  res1[3]=w061;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+600);
  /* #111: @0 = 0.541667 */
  w000 = 5.4166666666666663e-01;
  /* #112: @0 = (@0*@2) */
  w000 *= w002;
  /* #113: {@8, @9, @62, @63} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w062;
  res1[3]=w063;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+624);
  /* #115: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #116: @0 = (@0*@2) */
  w000 *= w002;
  /* #117: {@7, @9, @64, @65} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w064;
  res1[3]=w065;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+648);
  /* #119: @0 = 0.583333 */
  w000 = 5.8333333333333337e-01;
  /* #120: @0 = (@0*@2) */
  w000 *= w002;
  /* #121: {@8, @9, @66, @67} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w066;
  res1[3]=w067;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+672);
  /* #123: @0 = 0.604167 */
  w000 = 6.0416666666666663e-01;
  /* #124: @0 = (@0*@2) */
  w000 *= w002;
  /* #125: {@7, @9, @68, @69} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w068;
  res1[3]=w069;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+696);
  /* #127: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w000 *= w002;
  /* #129: {@8, @9, @70, @71} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w070;
  res1[3]=w071;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+720);
  /* #131: @0 = 0.645833 */
  w000 = 6.4583333333333337e-01;
  /* #132: @0 = (@0*@2) */
  w000 *= w002;
  /* #133: {@7, @9, @72, @73} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w072;
  res1[3]=w073;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+744);
  /* #135: @0 = 0.666667 */
  w000 = 6.6666666666666663e-01;
  /* #136: @0 = (@0*@2) */
  w000 *= w002;
  /* #137: {@8, @9, @74, @75} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w074;
  res1[3]=w075;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #138: output[0][32] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+768);
  /* #139: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #140: @0 = (@0*@2) */
  w000 *= w002;
  /* #141: {@7, @9, @76, @77} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w076;
  res1[3]=w077;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #142: output[0][33] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+792);
  /* #143: @0 = 0.708333 */
  w000 = 7.0833333333333337e-01;
  /* #144: @0 = (@0*@2) */
  w000 *= w002;
  /* #145: {@8, @9, @78, @79} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w078;
  res1[3]=w079;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #146: output[0][34] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+816);
  /* #147: @0 = 0.729167 */
  w000 = 7.2916666666666663e-01;
  /* #148: @0 = (@0*@2) */
  w000 *= w002;
  /* #149: {@7, @9, @80, @81} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w080;
  res1[3]=w081;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #150: output[0][35] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+840);
  /* #151: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #152: @0 = (@0*@2) */
  w000 *= w002;
  /* #153: {@8, @9, @82, @83} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w082;
  res1[3]=w083;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #154: output[0][36] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+864);
  /* #155: @0 = 0.770833 */
  w000 = 7.7083333333333337e-01;
  /* #156: @0 = (@0*@2) */
  w000 *= w002;
  /* #157: {@7, @9, @84, @85} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w084;
  res1[3]=w085;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #158: output[0][37] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+888);
  /* #159: @0 = 0.791667 */
  w000 = 7.9166666666666663e-01;
  /* #160: @0 = (@0*@2) */
  w000 *= w002;
  /* #161: {@8, @9, @86, @87} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w086;
  res1[3]=w087;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #162: output[0][38] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+912);
  /* #163: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #164: @0 = (@0*@2) */
  w000 *= w002;
  /* #165: {@7, @9, @88, @89} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w088;
  res1[3]=w089;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][39] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+936);
  /* #167: @0 = 0.833333 */
  w000 = 8.3333333333333337e-01;
  /* #168: @0 = (@0*@2) */
  w000 *= w002;
  /* #169: {@8, @9, @90, @91} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w090;
  res1[3]=w091;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #170: output[0][40] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+960);
  /* #171: @0 = 0.854167 */
  w000 = 8.5416666666666663e-01;
  /* #172: @0 = (@0*@2) */
  w000 *= w002;
  /* #173: {@7, @9, @92, @93} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w092;
  res1[3]=w093;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #174: output[0][41] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+984);
  /* #175: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #176: @0 = (@0*@2) */
  w000 *= w002;
  /* #177: {@8, @9, @94, @95} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w094;
  res1[3]=w095;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #178: output[0][42] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1008);
  /* #179: @0 = 0.895833 */
  w000 = 8.9583333333333337e-01;
  /* #180: @0 = (@0*@2) */
  w000 *= w002;
  /* #181: {@7, @9, @96, @97} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w096;
  res1[3]=w097;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #182: output[0][43] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1032);
  /* #183: @0 = 0.916667 */
  w000 = 9.1666666666666663e-01;
  /* #184: @0 = (@0*@2) */
  w000 *= w002;
  /* #185: {@8, @9, @98, @99} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w098;
  res1[3]=w099;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #186: output[0][44] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1056);
  /* #187: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #188: @0 = (@0*@2) */
  w000 *= w002;
  /* #189: {@7, @9, @100, @101} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w100;
  res1[3]=w101;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #190: output[0][45] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1080);
  /* #191: @0 = 0.958333 */
  w000 = 9.5833333333333337e-01;
  /* #192: @0 = (@0*@2) */
  w000 *= w002;
  /* #193: {@8, @9, @102, @103} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w102;
  res1[3]=w103;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #194: output[0][46] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1104);
  /* #195: @0 = 0.979167 */
  w000 = 9.7916666666666663e-01;
  /* #196: @0 = (@0*@2) */
  w000 *= w002;
  /* #197: {@7, @9, @104, @105} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w104;
  res1[3]=w105;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #198: output[0][47] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1128);
  /* #199: output[0][48] = @7 */
  if (res[0]) casadi_copy(w007, 2, res[0]+1152);
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
  arg1[2]=w004;
  res1[0]=w106;
  res1[1]=w107;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w004;
  res1[0]=w001;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #300: output[3][0] = @1 */
  casadi_copy(w001, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f86(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_576_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_576_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_576_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_576_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_576_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_576_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_576_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_576_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_576_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_576_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_576_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s20;
    case 1: return casadi_s21;
    case 2: return casadi_s21;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_576_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 9500;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 9500*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_trace_768:(u[3],p[3])->(w[2x769],g[8x769],dg[8x769],R[3]) */
static int casadi_f87(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+208, w002, w003, *w004=w+211, *w005=w+214, *w006=w+238, *w007=w+240, *w008=w+242, *w009=w+244;
  casadi_real *w010=w+268, *w011=w+364, *w012=w+460, *w013=w+556, *w014=w+652, *w015=w+748, *w016=w+844, *w017=w+940, *w018=w+1036, *w019=w+1132, *w020=w+1228, *w021=w+1324;
  casadi_real *w022=w+1420, *w023=w+1516, *w024=w+1612, *w025=w+1708, *w026=w+1804, *w027=w+1900, *w028=w+1996, *w029=w+2092, *w030=w+2188, *w031=w+2284, *w032=w+2380, *w033=w+2476;
  casadi_real *w034=w+2572, *w035=w+2668, *w036=w+2764, *w037=w+2860, *w038=w+2956, *w039=w+3052, *w040=w+3148, *w041=w+3244, *w042=w+3340, *w043=w+3436, *w044=w+3532, *w045=w+3628;
  casadi_real *w046=w+3724, *w047=w+3820, *w048=w+3916, *w049=w+4012, *w050=w+4108, *w051=w+4204, *w052=w+4300, *w053=w+4396, *w054=w+4492, *w055=w+4588, *w056=w+4684, *w057=w+4780;
  casadi_real *w058=w+4876, *w059=w+4972, *w060=w+5068, *w061=w+5164, *w062=w+5260, *w063=w+5356, *w064=w+5452, *w065=w+5548, *w066=w+5644, *w067=w+5740, *w068=w+5836, *w069=w+5932;
  casadi_real *w070=w+6028, *w071=w+6124, *w072=w+6220, *w073=w+6316, *w074=w+6412, *w075=w+6508, *w076=w+6604, *w077=w+6700, *w078=w+6796, *w079=w+6892, *w080=w+6988, *w081=w+7084;
  casadi_real *w082=w+7180, *w083=w+7276, *w084=w+7372, *w085=w+7468, *w086=w+7564, *w087=w+7660, *w088=w+7756, *w089=w+7852, *w090=w+7948, *w091=w+8044, *w092=w+8140, *w093=w+8236;
  casadi_real *w094=w+8332, *w095=w+8428, *w096=w+8524, *w097=w+8620, *w098=w+8716, *w099=w+8812, *w100=w+8908, *w101=w+9004, *w102=w+9100, *w103=w+9196, *w104=w+9292, *w105=w+9388;
  casadi_real *w106=w+9484, *w107=w+9580, *w108=w+9676, *w109=w+9772, *w110=w+9868, *w111=w+9964, *w112=w+10060, *w113=w+10156, *w114=w+10252, *w115=w+10348, *w116=w+10444, *w117=w+10540;
  casadi_real *w118=w+10636, *w119=w+10732, *w120=w+10828, *w121=w+10924, *w122=w+11020, *w123=w+11116, *w124=w+11212, *w125=w+11308, *w126=w+11404, *w127=w+11500, *w128=w+11596, *w129=w+11692;
  casadi_real *w130=w+11788, *w131=w+11884, *w132=w+11980, *w133=w+12076, *w134=w+12172, *w135=w+12268, *w136=w+12364, *w137=w+12460, *w138=w+12556, *w139=w+12564;
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
  casadi_copy(arg[1], 3, w004);
  /* #6: @5 = turns(@3, @4) */
  arg1[0]=(&w003);
  arg1[1]=w004;
  res1[0]=w005;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:2] */
  for (rr=w006, cs=w001+0; cs!=w001+2; cs+=1) *rr++ = *cs;
  /* #8: {@7, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=w004;
  res1[0]=w007;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #9: {@8, @9, @10, @11} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w010;
  res1[3]=w011;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @9 */
  casadi_copy(w009, 24, res[0]);
  /* #11: @0 = 0.015625 */
  w000 = 1.5625000000000000e-02;
  /* #12: @0 = (@0*@2) */
  w000 *= w002;
  /* #13: {@7, @9, @12, @13} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w012;
  res1[3]=w013;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][1] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+24);
  /* #15: @0 = 0.03125 */
  w000 = 3.1250000000000000e-02;
  /* #16: @0 = (@0*@2) */
  w000 *= w002;
  /* #17: {@8, @9, @14, @15} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w014;
  res1[3]=w015;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][2] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+48);
  /* #19: @0 = 0.046875 */
  w000 = 4.6875000000000000e-02;
  /* #20: @0 = (@0*@2) */
  w000 *= w002;
  /* #21: {@7, @9, @16, @17} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w016;
  res1[3]=w017;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #22: output[0][3] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+72);
  /* #23: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #24: @0 = (@0*@2) */
  w000 *= w002;
  /* #25: {@8, @9, @18, @19} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w018;
  res1[3]=w019;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][4] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+96);
  /* #27: @0 = 0.078125 */
  w000 = 7.8125000000000000e-02;
  /* #28: @0 = (@0*@2) */
  w000 *= w002;
  /* #29: {@7, @9, @20, @21} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w020;
  res1[3]=w021;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #30: output[0][5] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+120);
  /* #31: @0 = 0.09375 */
  w000 = 9.3750000000000000e-02;
  /* #32: @0 = (@0*@2) */
  w000 *= w002;
  /* #33: {@8, @9, @22, @23} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w022;
  res1[3]=w023;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #34: output[0][6] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+144);
  /* #35: @0 = 0.109375 */
  w000 = 1.0937500000000000e-01;
  /* #36: @0 = (@0*@2) */
  w000 *= w002;
  /* #37: {@7, @9, @24, @25} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w024;
  res1[3]=w025;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #38: output[0][7] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+168);
  /* #39: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #40: @0 = (@0*@2) */
  w000 *= w002;
  /* #41: {@8, @9, @26, @27} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w026;
  res1[3]=w027;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #42: output[0][8] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+192);
  /* #43: @0 = 0.140625 */
  w000 = 1.4062500000000000e-01;
  /* #44: @0 = (@0*@2) */
  w000 *= w002;
  /* #45: {@7, @9, @28, @29} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w028;
  res1[3]=w029;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][9] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+216);
  /* #47: @0 = 0.15625 */
  w000 = 1.5625000000000000e-01;
  /* #48: @0 = (@0*@2) */
  w000 *= w002;
  /* #49: {@8, @9, @30, @31} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w030;
  res1[3]=w031;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #50: output[0][10] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+240);
  /* #51: @0 = 0.171875 */
  w000 = 1.7187500000000000e-01;
  /* #52: @0 = (@0*@2) */
  w000 *= w002;
  /* #53: {@7, @9, @32, @33} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w032;
  res1[3]=w033;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #54: output[0][11] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+264);
  /* #55: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #56: @0 = (@0*@2) */
  w000 *= w002;
  /* #57: {@8, @9, @34, @35} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w034;
  res1[3]=w035;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #58: output[0][12] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+288);
  /* #59: @0 = 0.203125 */
  w000 = 2.0312500000000000e-01;
  /* #60: @0 = (@0*@2) */
  w000 *= w002;
  /* #61: {@7, @9, @36, @37} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w036;
  res1[3]=w037;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #62: output[0][13] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+312);
  /* #63: @0 = 0.21875 */
  w000 = 2.1875000000000000e-01;
  /* #64: @0 = (@0*@2) */
  w000 *= w002;
  /* #65: {@8, @9, @38, @39} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w038;
  res1[3]=w039;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #66: output[0][14] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+336);
  /* #67: @0 = 0.234375 */
  w000 = 2.3437500000000000e-01;
  /* #68: @0 = (@0*@2) */
  w000 *= w002;
  /* #69: {@7, @9, @40, @41} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w040;
  res1[3]=w041;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[0][15] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+360);
  /* #71: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #72: @0 = (@0*@2) */
  w000 *= w002;
  /* #73: {@8, @9, @42, @43} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w042;
  res1[3]=w043;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #74: output[0][16] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+384);
  /* #75: @0 = 0.265625 */
  w000 = 2.6562500000000000e-01;
  /* #76: @0 = (@0*@2) */
  w000 *= w002;
  /* #77: {@7, @9, @44, @45} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w044;
  res1[3]=w045;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #78: output[0][17] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+408);
  /* #79: @0 = 0.28125 */
  w000 = 2.8125000000000000e-01;
  /* #80: @0 = (@0*@2) */
  w000 *= w002;
  /* #81: {@8, @9, @46, @47} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w046;
  res1[3]=w047;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[0][18] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+432);
  /* #83: @0 = 0.296875 */
  w000 = 2.9687500000000000e-01;
  /* #84: @0 = (@0*@2) */
  w000 *= w002;
  /* #85: {@7, @9, @48, @49} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w048;
  res1[3]=w049;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][19] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+456);
  /* #87: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #88: @0 = (@0*@2) */
  w000 *= w002;
  /* #89: {@8, @9, @50, @51} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w050;
  res1[3]=w051;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #90: output[0][20] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+480);
  /* #91: @0 = 0.328125 */
  w000 = 3.2812500000000000e-01;
  /* #92: @0 = (@0*@2) */
  w000 *= w002;
  /* #93: {@7, @9, @52, @53} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w052;
  res1[3]=w053;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[0][21] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+504);
  /* #95: @0 = 0.34375 */
  w000 = 3.4375000000000000e-01;
  /* #96: @0 = (@0*@2) */
  w000 *= w002;
  /* #97: {@8, @9, @54, @55} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w054;
  res1[3]=w055;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #98: output[0][22] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+528);
  /* #99: @0 = 0.359375 */
  w000 = 3.5937500000000000e-01;
  /* #100: @0 = (@0*@2) */
  w000 *= w002;
  /* #101: {@7, @9, @56, @57} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w056;
  res1[3]=w057;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #102: output[0][23] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+552);
  /* #103: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #104: @0 = (@0*@2) */
  w000 *= w002;
  /* #105: {@8, @9, @58, @59} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w058;
  res1[3]=w059;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[0][24] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+576);
  /* #107: @0 = 0.390625 */
  w000 = 3.9062500000000000e-01;
  /* #108: @0 = (@0*@2) */
  w000 *= w002;
  /* #109: {@7, @9, @60, @61} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w060;
  res1[3]=w061;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #110: output[0][25] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+600);
  /* #111: @0 = 0.40625 */
  w000 = 4.0625000000000000e-01;
  /* #112: @0 = (@0*@2) */
  w000 *= w002;
  /* #113: {@8, @9, @62, @63} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w062;
  res1[3]=w063;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #114: output[0][26] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+624);
  /* #115: @0 = 0.421875 */
  w000 = 4.2187500000000000e-01;
  /* #116: @0 = (@0*@2) */
  w000 *= w002;
  /* #117: {@7, @9, @64, @65} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w064;
  res1[3]=w065;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[0][27] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+648);
  /* #119: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #120: @0 = (@0*@2) */
  w000 *= w002;
  /* #121: {@8, @9, @66, @67} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w066;
  res1[3]=w067;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #122: output[0][28] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+672);
  /* #123: @0 = 0.453125 */
  w000 = 4.5312500000000000e-01;
  /* #124: @0 = (@0*@2) */
  w000 *= w002;
  /* #125: {@7, @9, @68, @69} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w068;
  res1[3]=w069;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #126: output[0][29] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+696);
  /* #127: @0 = 0.46875 */
  w000 = 4.6875000000000000e-01;
  /* #128: @0 = (@0*@2) */
  w000 *= w002;
  /* #129: {@8, @9, @70, @71} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w070;
  res1[3]=w071;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #130: output[0][30] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+720);
  /* #131: @0 = 0.484375 */
  w000 = 4.8437500000000000e-01;
  /* #132: @0 = (@0*@2) */
  w000 *= w002;
  /* #133: {@7, @9, @72, @73} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w072;
  res1[3]=w073;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #134: output[0][31] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+744);
  /* #135: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #136: @0 = (@0*@2) */
  w000 *= w002;
  /* #137: {@8, @9, @74, @75} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w074;
  res1[3]=w075;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #138: output[0][32] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+768);
  /* #139: @0 = 0.515625 */
  w000 = 5.1562500000000000e-01;
  /* #140: @0 = (@0*@2) */
  w000 *= w002;
  /* #141: {@7, @9, @76, @77} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w076;
  res1[3]=w077;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #142: output[0][33] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+792);
  /* #143: @0 = 0.53125 */
  w000 = 5.3125000000000000e-01;
  /* #144: @0 = (@0*@2) */
  w000 *= w002;
  /* #145: {@8, @9, @78, @79} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w078;
  res1[3]=w079;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #146: output[0][34] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+816);
  /* #147: @0 = 0.546875 */
  w000 = 5.4687500000000000e-01;
  /* #148: @0 = (@0*@2) */
  w000 *= w002;
  /* #149: {@7, @9, @80, @81} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w080;
  res1[3]=w081;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #150: output[0][35] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+840);
  /* #151: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #152: @0 = (@0*@2) */
  w000 *= w002;
  /* #153: {@8, @9, @82, @83} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w082;
  res1[3]=w083;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #154: output[0][36] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+864);
  /* #155: @0 = 0.578125 */
  w000 = 5.7812500000000000e-01;
  /* #156: @0 = (@0*@2) */
  w000 *= w002;
  /* #157: {@7, @9, @84, @85} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w084;
  res1[3]=w085;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #158: output[0][37] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+888);
  /* #159: @0 = 0.59375 */
  w000 = 5.9375000000000000e-01;
  /* #160: @0 = (@0*@2) */
  w000 *= w002;
  /* #161: {@8, @9, @86, @87} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w086;
  res1[3]=w087;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #162: output[0][38] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+912);
  /* #163: @0 = 0.609375 */
  w000 = 6.0937500000000000e-01;
  /* #164: @0 = (@0*@2) */
  w000 *= w002;
  /* #165: {@7, @9, @88, @89} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w088;
  res1[3]=w089;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][39] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+936);
  /* #167: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #168: @0 = (@0*@2) */
  w000 *= w002;
  /* #169: {@8, @9, @90, @91} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w090;
  res1[3]=w091;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #170: output[0][40] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+960);
  /* #171: @0 = 0.640625 */
  w000 = 6.4062500000000000e-01;
  /* #172: @0 = (@0*@2) */
  w000 *= w002;
  /* #173: {@7, @9, @92, @93} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w092;
  res1[3]=w093;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #174: output[0][41] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+984);
  /* #175: @0 = 0.65625 */
  w000 = 6.5625000000000000e-01;
  /* #176: @0 = (@0*@2) */
  w000 *= w002;
  /* #177: {@8, @9, @94, @95} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w094;
  res1[3]=w095;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #178: output[0][42] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1008);
  /* #179: @0 = 0.671875 */
  w000 = 6.7187500000000000e-01;
  /* #180: @0 = (@0*@2) */
  w000 *= w002;
  /* #181: {@7, @9, @96, @97} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w096;
  res1[3]=w097;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #182: output[0][43] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1032);
  /* #183: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #184: @0 = (@0*@2) */
  w000 *= w002;
  /* #185: {@8, @9, @98, @99} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w098;
  res1[3]=w099;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #186: output[0][44] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1056);
  /* #187: @0 = 0.703125 */
  w000 = 7.0312500000000000e-01;
  /* #188: @0 = (@0*@2) */
  w000 *= w002;
  /* #189: {@7, @9, @100, @101} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w100;
  res1[3]=w101;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #190: output[0][45] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1080);
  /* #191: @0 = 0.71875 */
  w000 = 7.1875000000000000e-01;
  /* #192: @0 = (@0*@2) */
  w000 *= w002;
  /* #193: {@8, @9, @102, @103} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w102;
  res1[3]=w103;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #194: output[0][46] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1104);
  /* #195: @0 = 0.734375 */
  w000 = 7.3437500000000000e-01;
  /* #196: @0 = (@0*@2) */
  w000 *= w002;
  /* #197: {@7, @9, @104, @105} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w104;
  res1[3]=w105;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #198: output[0][47] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1128);
  /* #199: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #200: @0 = (@0*@2) */
  w000 *= w002;
  /* #201: {@8, @9, @106, @107} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w106;
  res1[3]=w107;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #202: output[0][48] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1152);
  /* #203: @0 = 0.765625 */
  w000 = 7.6562500000000000e-01;
  /* #204: @0 = (@0*@2) */
  w000 *= w002;
  /* #205: {@7, @9, @108, @109} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w108;
  res1[3]=w109;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #206: output[0][49] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1176);
  /* #207: @0 = 0.78125 */
  w000 = 7.8125000000000000e-01;
  /* #208: @0 = (@0*@2) */
  w000 *= w002;
  /* #209: {@8, @9, @110, @111} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w110;
  res1[3]=w111;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #210: output[0][50] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1200);
  /* #211: @0 = 0.796875 */
  w000 = 7.9687500000000000e-01;
  /* #212: @0 = (@0*@2) */
  w000 *= w002;
  /* #213: {@7, @9, @112, @113} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w112;
  res1[3]=w113;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #214: output[0][51] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1224);
  /* #215: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #216: @0 = (@0*@2) */
  w000 *= w002;
  /* #217: {@8, @9, @114, @115} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w114;
  res1[3]=w115;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #218: output[0][52] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1248);
  /* #219: @0 = 0.828125 */
  w000 = 8.2812500000000000e-01;
  /* #220: @0 = (@0*@2) */
  w000 *= w002;
  /* #221: {@7, @9, @116, @117} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w116;
  res1[3]=w117;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #222: output[0][53] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1272);
  /* #223: @0 = 0.84375 */
  w000 = 8.4375000000000000e-01;
  /* #224: @0 = (@0*@2) */
  w000 *= w002;
  /* #225: {@8, @9, @118, @119} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w118;
  res1[3]=w119;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #226: output[0][54] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1296);
  /* #227: @0 = 0.859375 */
  w000 = 8.5937500000000000e-01;
  /* #228: @0 = (@0*@2) */
  w000 *= w002;
  /* #229: {@7, @9, @120, @121} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w120;
  res1[3]=w121;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #230: output[0][55] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1320);
  /* #231: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #232: @0 = (@0*@2) */
  w000 *= w002;
  /* #233: {@8, @9, @122, @123} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w122;
  res1[3]=w123;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #234: output[0][56] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1344);
  /* #235: @0 = 0.890625 */
  w000 = 8.9062500000000000e-01;
  /* #236: @0 = (@0*@2) */
  w000 *= w002;
  /* #237: {@7, @9, @124, @125} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w124;
  res1[3]=w125;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #238: output[0][57] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1368);
  /* #239: @0 = 0.90625 */
  w000 = 9.0625000000000000e-01;
  /* #240: @0 = (@0*@2) */
  w000 *= w002;
  /* #241: {@8, @9, @126, @127} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w126;
  res1[3]=w127;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #242: output[0][58] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1392);
  /* #243: @0 = 0.921875 */
  w000 = 9.2187500000000000e-01;
  /* #244: @0 = (@0*@2) */
  w000 *= w002;
  /* #245: {@7, @9, @128, @129} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w128;
  res1[3]=w129;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #246: output[0][59] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1416);
  /* #247: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #248: @0 = (@0*@2) */
  w000 *= w002;
  /* #249: {@8, @9, @130, @131} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w130;
  res1[3]=w131;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #250: output[0][60] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1440);
  /* #251: @0 = 0.953125 */
  w000 = 9.5312500000000000e-01;
  /* #252: @0 = (@0*@2) */
  w000 *= w002;
  /* #253: {@7, @9, @132, @133} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w132;
  res1[3]=w133;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #254: output[0][61] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1464);
  /* #255: @0 = 0.96875 */
  w000 = 9.6875000000000000e-01;
  /* #256: @0 = (@0*@2) */
  w000 *= w002;
  /* #257: {@8, @9, @134, @135} = working_steps(@0, @5, @7, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w007;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w134;
  res1[3]=w135;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #258: output[0][62] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1488);
  /* #259: @0 = 0.984375 */
  w000 = 9.8437500000000000e-01;
  /* #260: @0 = (@0*@2) */
  w000 *= w002;
  /* #261: {@7, @9, @136, @137} = working_steps(@0, @5, @8, @3, @4) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=w008;
  arg1[3]=(&w003);
  arg1[4]=w004;
  res1[0]=w007;
  res1[1]=w009;
  res1[2]=w136;
  res1[3]=w137;
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #262: output[0][63] = @9 */
  if (res[0]) casadi_copy(w009, 24, res[0]+1512);
  /* #263: output[0][64] = @7 */
  if (res[0]) casadi_copy(w007, 2, res[0]+1536);
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
  arg1[2]=w004;
  res1[0]=w138;
  res1[1]=w139;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
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
  arg1[2]=w004;
  res1[0]=w001;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #396: output[3][0] = @1 */
  casadi_copy(w001, 3, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f87(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s22;
    case 1: return casadi_s23;
    case 2: return casadi_s23;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12572;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12572*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_advance:(t,w[2],h,p[3])->(w_end[2],g[8],dg[8]) */
static int casadi_f88(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+46, w1, *w2=w+48, *w3=w+51, w4, *w5=w+53, *w6=w+77, *w7=w+79, *w8=w+87;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[1][0] */
  casadi_copy(arg[1], 2, w0);
  /* #1: @1 = input[0][0] */
  w1 = arg[0] ? arg[0][0] : 0;
  /* #2: @2 = input[3][0] */
  casadi_copy(arg[3], 3, w2);
  /* #3: @3 = phase(@1, @2) */
  arg1[0]=(&w1);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  w4 = arg[2] ? arg[2][0] : 0;
  /* #5: @5 = turns(@4, @2) */
  arg1[0]=(&w4);
  arg1[1]=w2;
  res1[0]=w5;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #6: @6 = working_step(@0, @3, @5, @4, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=w5;
  arg1[3]=(&w4);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f78(arg1, res1, iw, w, 0)) return 1;
  /* #7: output[0][0] = @6 */
  casadi_copy(w6, 2, res[0]);
  /* #8: @1 = (@1+@4) */
  w1 += w4;
  /* #9: {@7, @8} = observe(@1, @6, @2) */
  arg1[0]=(&w1);
  arg1[1]=w6;
  arg1[2]=w2;
  res1[0]=w7;
  res1[1]=w8;
  if (casadi_f79(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[1][0] = @7 */
  casadi_copy(w7, 8, res[1]);
  /* #11: output[2][0] = @8 */
  casadi_copy(w8, 8, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f88(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s24;
    case 1: return casadi_s25;
    case 2: return casadi_s24;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s26;
    case 2: return casadi_s26;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 95;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 95*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_begin:(u[3],p[3])->(y[2x3]) */
static int casadi_f89(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+2, *w1=w+5, *w2=w+7, *w3=w+9;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 3, w0);
  /* #1: @1 = @0[:2] */
  for (rr=w1, cs=w0+0; cs!=w0+2; cs+=1) *rr++ = *cs;
  /* #2: @0 = input[1][0] */
  casadi_copy(arg[1], 3, w0);
  /* #3: {@2, @3} = start(@1, @0) */
  arg1[0]=w1;
  arg1[1]=w0;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: output[0][0] = @2 */
  casadi_copy(w2, 2, res[0]);
  /* #5: output[0][1] = @3 */
  if (res[0]) casadi_copy(w3, 4, res[0]+2);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_begin(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f89(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_begin_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_begin_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_begin_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_begin_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_begin_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_begin_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_begin_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_begin_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_begin_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_begin_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_begin_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_begin_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 13;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_begin_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 13*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_swing:(t,h,y[2x3],p[3])->(y_end[2x3]) */
static int casadi_f90(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+135, w1, w2, *w3=w+141, *w4=w+144, *w5=w+168;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[2][0] */
  casadi_copy(arg[2], 6, w0);
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = variational_steps(@0, @1, @4, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  arg1[2]=w4;
  arg1[3]=(&w2);
  arg1[4]=w3;
  res1[0]=w5;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 6, res[0]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f90(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_swing_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "y";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "y_end";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s24;
    case 1: return casadi_s24;
    case 2: return casadi_s27;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s27;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 174;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 174*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_end:(y[2x3],u[3],p[3])->(J[3x3],R[3]) */
static int casadi_f91(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *rr, *w0=w+10, *w1=w+16, *w2=w+19, w3, *w4=w+21, *w5=w+30;
  const casadi_real **arg1=arg+3, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 3, w1);
  /* #2: @2 = @1[:2] */
  for (rr=w2, cs=w1+0; cs!=w1+2; cs+=1) *rr++ = *cs;
  /* #3: @3 = @1[2] */
  for (rr=(&w3), cs=w1+2; cs!=w1+3; cs+=1) *rr++ = *cs;
  /* #4: @1 = input[2][0] */
  casadi_copy(arg[2], 3, w1);
  /* #5: {@4, @5} = landing_with_derivative(@0, @2, @3, @1) */
  arg1[0]=w0;
  arg1[1]=w2;
  arg1[2]=(&w3);
  arg1[3]=w1;
  res1[0]=w4;
  res1[1]=w5;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @4 */
  casadi_copy(w4, 9, res[0]);
  /* #7: output[1][0] = @5 */
  casadi_copy(w5, 3, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_end(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f91(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_end_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_end_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_end_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_end_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_end_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_end_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_end_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_end_name_in(casadi_int i) {
  switch (i) {
    case 0: return "y";
    case 1: return "u";
    case 2: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_end_name_out(casadi_int i) {
  switch (i) {
    case 0: return "J";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_end_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s27;
    case 1: return casadi_s4;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_end_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s5;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_end_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 33;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_end_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 33*sizeof(casadi_real);
  return 0;
}

/* rimless_wheel_observed_swing:(t,h,w[2],p[3])->(w_end[2],nodes[2x12],g[8x12],dg[8x12]) */
static int casadi_f92(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, w0, w1, *w2=w+208, *w3=w+211, *w4=w+235, *w5=w+237, *w6=w+239, *w7=w+263, *w8=w+359;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = input[2][0] */
  casadi_copy(arg[2], 2, w4);
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
  if (casadi_f77(arg1, res1, iw, w, 0)) return 1;
  /* #6: output[0][0] = @5 */
  casadi_copy(w5, 2, res[0]);
  /* #7: output[1][0] = @6 */
  casadi_copy(w6, 24, res[1]);
  /* #8: output[2][0] = @7 */
  casadi_copy(w7, 96, res[2]);
  /* #9: output[3][0] = @8 */
  casadi_copy(w8, 96, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_observed_swing(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f92(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rimless_wheel_observed_swing_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rimless_wheel_observed_swing_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_observed_swing_incref(void) {
}

CASADI_SYMBOL_EXPORT void rimless_wheel_observed_swing_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_observed_swing_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int rimless_wheel_observed_swing_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real rimless_wheel_observed_swing_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_observed_swing_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "h";
    case 2: return "w";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rimless_wheel_observed_swing_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "nodes";
    case 2: return "g";
    case 3: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_observed_swing_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s24;
    case 1: return casadi_s24;
    case 2: return casadi_s25;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rimless_wheel_observed_swing_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s25;
    case 1: return casadi_s28;
    case 2: return casadi_s29;
    case 3: return casadi_s29;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rimless_wheel_observed_swing_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 455;
  return 0;
}

CASADI_SYMBOL_EXPORT int rimless_wheel_observed_swing_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 455*sizeof(casadi_real);
  return 0;
}



/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*rimless_wheel_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int rimless_wheel_map(rimless_wheel_kernel kernel, const casadi_int* work_size, casadi_int n,
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
