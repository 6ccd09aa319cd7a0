/* Walker on round feet: kernels of the solver
 * Printed by CasADi 3.8.2 from equations fcccfb1221b8b255.
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
#define casadi_f8 CASADI_PREFIX(f8)
#define casadi_f9 CASADI_PREFIX(f9)
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

static const casadi_real casadi_zeros[24] = 
  {0.};

/* start:(z[3],p[7])->(y[4],dy_dz[4x3]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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

/* phase:(t,p[7])->(phase[2]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  a0=0.;
  if (res[0]!=0) res[0][1]=a0;
  return 0;
}

/* variational_step:(y[4x4],phase[2],turns[2x12],h,p[7])->(y_end[4x4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a624;
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
  a007=arg[4]? arg[4][3] : 0;
  a008=arg[0]? arg[0][3] : 0;
  a009=(a007*a008);
  a009=(a009*a008);
  a010=arg[4]? arg[4][1] : 0;
  a009=(a009*a010);
  a011=arg[0]? arg[0][1] : 0;
  a012=sin(a011);
  a009=(a009*a012);
  a013=cos(a011);
  a014=arg[4]? arg[4][4] : 0;
  a015=(a013*a014);
  a016=casadi_sq(a008);
  a017=(a016*a010);
  a018=(a015*a017);
  a009=(a009-a018);
  a018=casadi_sq(a003);
  a019=arg[4]? arg[4][5] : 0;
  a020=(a018*a019);
  a021=cos(a000);
  a022=(a021*a014);
  a023=(a022*a010);
  a024=(a021*a013);
  a025=sin(a000);
  a026=(a025*a012);
  a024=(a024+a026);
  a026=(a024*a014);
  a027=(a026*a010);
  a028=(a023+a027);
  a029=(a007*a010);
  a030=(a029*a025);
  a028=(a028+a030);
  a031=(a025*a013);
  a032=(a021*a012);
  a031=(a031-a032);
  a032=(a029*a031);
  a028=(a028+a032);
  a033=arg[4]? arg[4][0] : 0;
  a034=(a033*a025);
  a028=(a028-a034);
  a035=(2.*a010);
  a036=(a035*a025);
  a028=(a028-a036);
  a037=(a020*a028);
  a037=(a009-a037);
  a038=(2.*a003);
  a038=(a038*a008);
  a039=(a038*a010);
  a040=(a007*a012);
  a015=(a015-a040);
  a040=(a026*a019);
  a041=(a015+a040);
  a042=(a007*a019);
  a043=(a042*a031);
  a041=(a041+a043);
  a041=(a039*a041);
  a037=(a037+a041);
  a041=(a033*a019);
  a044=arg[4]? arg[4][6] : 0;
  a045=sin(a044);
  a046=(a041*a045);
  a037=(a037-a046);
  a047=cos(a044);
  a048=(a025*a047);
  a049=(a021*a045);
  a048=(a048-a049);
  a049=(a033*a048);
  a037=(a037+a049);
  a050=(a021*a047);
  a051=(a025*a045);
  a050=(a050+a051);
  a051=(a050*a014);
  a052=(a007*a048);
  a051=(a051+a052);
  a052=(2.*a019);
  a052=(a052*a045);
  a051=(a051+a052);
  a053=(2.*a048);
  a051=(a051-a053);
  a053=(a011-a000);
  a053=(a053+a044);
  a054=cos(a053);
  a055=(a054*a014);
  a053=sin(a053);
  a056=(a007*a053);
  a055=(a055-a056);
  a051=(a051+a055);
  a051=(a010*a051);
  a037=(a037-a051);
  a056=(a017*a040);
  a037=(a037-a056);
  a056=(a017*a043);
  a037=(a037-a056);
  a041=(a041*a019);
  a056=(2.*a021);
  a057=(a056*a019);
  a058=(a033*a057);
  a058=(a041+a058);
  a058=(a058+a033);
  a059=arg[4]? arg[4][2] : 0;
  a060=(2.*a059);
  a058=(a058+a060);
  a061=(a014*a019);
  a062=(a061*a025);
  a063=(a021*a007);
  a064=(a063*a019);
  a065=(a062-a064);
  a013=(a013*a007);
  a065=(a065-a013);
  a065=(a065-a007);
  a066=(a014*a012);
  a065=(a065-a066);
  a067=casadi_sq(a019);
  a065=(a065+a067);
  a065=(a065+a057);
  a068=(a061*a031);
  a065=(a065+a068);
  a024=(a024*a007);
  a069=(a024*a019);
  a065=(a065-a069);
  a070=casadi_sq(a007);
  a071=casadi_sq(a014);
  a072=(a070+a071);
  a065=(a065+a072);
  a073=1.;
  a065=(a065+a073);
  a065=(a035*a065);
  a058=(a058+a065);
  a065=(a037/a058);
  a074=(a013-a070);
  a074=(a074-a071);
  a074=(a074+a066);
  a074=(a074-a068);
  a074=(a074+a069);
  a074=(a010*a074);
  a074=(a074-a059);
  a075=(a074/a058);
  a076=(a018*a015);
  a055=(a055-a076);
  a055=(a010*a055);
  a037=(a075*a037);
  a037=(a055-a037);
  a076=(a010*a072);
  a076=(a059+a076);
  a074=(a074*a075);
  a074=(a076-a074);
  a037=(a037/a074);
  a077=(a075*a037);
  a065=(a065-a077);
  a077=(a006*a065);
  a078=1.7082860872947386e-01;
  a078=(a078*a002);
  a079=2.9587585476806851e-02;
  a079=(a079*a002);
  a080=(a079*a037);
  a081=8.8762756430420545e-02;
  a081=(a081*a002);
  a082=1.9725056984537900e-02;
  a082=(a082*a002);
  a083=(a082*a008);
  a084=5.9175170953613701e-02;
  a084=(a084*a002);
  a085=5.2600151958767730e-02;
  a085=(a085*a002);
  a086=(a085*a037);
  a086=(a008+a086);
  a087=(a084*a086);
  a083=(a083+a087);
  a083=(a011+a083);
  a087=(a082*a003);
  a088=(a085*a065);
  a088=(a003+a088);
  a089=(a084*a088);
  a087=(a087+a089);
  a087=(a000+a087);
  a089=(a083-a087);
  a089=(a089+a044);
  a090=cos(a089);
  a091=(a090*a014);
  a089=sin(a089);
  a092=(a007*a089);
  a091=(a091-a092);
  a092=(a082*a065);
  a093=(a007*a086);
  a093=(a093*a086);
  a093=(a093*a010);
  a094=(a085*a008);
  a094=(a011+a094);
  a095=sin(a094);
  a093=(a093*a095);
  a096=cos(a094);
  a097=(a096*a014);
  a098=casadi_sq(a086);
  a099=(a098*a010);
  a100=(a097*a099);
  a093=(a093-a100);
  a100=casadi_sq(a088);
  a101=(a100*a019);
  a102=(a085*a003);
  a102=(a000+a102);
  a103=cos(a102);
  a104=(a103*a014);
  a105=(a104*a010);
  a106=(a103*a096);
  a107=sin(a102);
  a108=(a107*a095);
  a106=(a106+a108);
  a108=(a106*a014);
  a109=(a108*a010);
  a110=(a105+a109);
  a111=(a029*a107);
  a110=(a110+a111);
  a112=(a107*a096);
  a113=(a103*a095);
  a112=(a112-a113);
  a113=(a029*a112);
  a110=(a110+a113);
  a114=(a033*a107);
  a110=(a110-a114);
  a115=(a035*a107);
  a110=(a110-a115);
  a116=(a101*a110);
  a116=(a093-a116);
  a117=(2.*a088);
  a117=(a117*a086);
  a118=(a117*a010);
  a119=(a007*a095);
  a097=(a097-a119);
  a119=(a108*a019);
  a120=(a097+a119);
  a121=(a042*a112);
  a120=(a120+a121);
  a120=(a118*a120);
  a116=(a116+a120);
  a116=(a116-a046);
  a120=(a107*a047);
  a122=(a103*a045);
  a120=(a120-a122);
  a122=(a033*a120);
  a116=(a116+a122);
  a123=(a103*a047);
  a124=(a107*a045);
  a123=(a123+a124);
  a124=(a123*a014);
  a125=(a007*a120);
  a124=(a124+a125);
  a124=(a124+a052);
  a125=(2.*a120);
  a124=(a124-a125);
  a094=(a094-a102);
  a094=(a094+a044);
  a102=cos(a094);
  a125=(a102*a014);
  a094=sin(a094);
  a126=(a007*a094);
  a125=(a125-a126);
  a124=(a124+a125);
  a124=(a010*a124);
  a116=(a116-a124);
  a126=(a099*a119);
  a116=(a116-a126);
  a126=(a099*a121);
  a116=(a116-a126);
  a126=(2.*a103);
  a127=(a126*a019);
  a128=(a033*a127);
  a128=(a041+a128);
  a128=(a128+a033);
  a128=(a128+a060);
  a129=(a061*a107);
  a130=(a103*a007);
  a131=(a130*a019);
  a132=(a129-a131);
  a096=(a096*a007);
  a132=(a132-a096);
  a132=(a132-a007);
  a133=(a014*a095);
  a132=(a132-a133);
  a132=(a132+a067);
  a132=(a132+a127);
  a134=(a061*a112);
  a132=(a132+a134);
  a106=(a106*a007);
  a135=(a106*a019);
  a132=(a132-a135);
  a132=(a132+a072);
  a132=(a132+a073);
  a132=(a035*a132);
  a128=(a128+a132);
  a132=(a116/a128);
  a136=(a096-a070);
  a136=(a136-a071);
  a136=(a136+a133);
  a136=(a136-a134);
  a136=(a136+a135);
  a136=(a010*a136);
  a136=(a136-a059);
  a137=(a136/a128);
  a138=(a100*a097);
  a125=(a125-a138);
  a125=(a010*a125);
  a116=(a137*a116);
  a116=(a125-a116);
  a136=(a136*a137);
  a136=(a076-a136);
  a116=(a116/a136);
  a138=(a137*a116);
  a132=(a132-a138);
  a132=(a084*a132);
  a092=(a092+a132);
  a092=(a003+a092);
  a132=casadi_sq(a092);
  a138=cos(a083);
  a139=(a138*a014);
  a083=sin(a083);
  a140=(a007*a083);
  a140=(a139-a140);
  a141=(a132*a140);
  a141=(a091-a141);
  a141=(a010*a141);
  a142=(a138*a007);
  a143=(a142-a070);
  a143=(a143-a071);
  a144=(a014*a083);
  a143=(a143+a144);
  a145=sin(a087);
  a146=(a145*a138);
  a087=cos(a087);
  a147=(a087*a083);
  a146=(a146-a147);
  a147=(a061*a146);
  a143=(a143-a147);
  a138=(a087*a138);
  a148=(a145*a083);
  a138=(a138+a148);
  a148=(a138*a007);
  a149=(a148*a019);
  a143=(a143+a149);
  a143=(a010*a143);
  a143=(a143-a059);
  a150=(2.*a087);
  a151=(a150*a019);
  a152=(a033*a151);
  a152=(a041+a152);
  a152=(a152+a033);
  a152=(a152+a060);
  a153=(a061*a145);
  a154=(a087*a007);
  a155=(a154*a019);
  a156=(a153-a155);
  a156=(a156-a142);
  a156=(a156-a007);
  a156=(a156-a144);
  a156=(a156+a067);
  a156=(a156+a151);
  a156=(a156+a147);
  a156=(a156-a149);
  a156=(a156+a072);
  a156=(a156+a073);
  a156=(a035*a156);
  a152=(a152+a156);
  a156=(a143/a152);
  a157=(a082*a037);
  a116=(a084*a116);
  a157=(a157+a116);
  a157=(a008+a157);
  a116=(a007*a157);
  a116=(a116*a157);
  a116=(a116*a010);
  a116=(a116*a083);
  a158=casadi_sq(a157);
  a159=(a158*a010);
  a139=(a139*a159);
  a116=(a116-a139);
  a139=(a132*a019);
  a160=(a087*a014);
  a161=(a160*a010);
  a138=(a138*a014);
  a162=(a138*a010);
  a163=(a161+a162);
  a164=(a029*a145);
  a163=(a163+a164);
  a165=(a029*a146);
  a163=(a163+a165);
  a166=(a033*a145);
  a163=(a163-a166);
  a167=(a035*a145);
  a163=(a163-a167);
  a168=(a139*a163);
  a168=(a116-a168);
  a169=(2.*a092);
  a169=(a169*a157);
  a170=(a169*a010);
  a171=(a138*a019);
  a172=(a140+a171);
  a173=(a042*a146);
  a172=(a172+a173);
  a172=(a170*a172);
  a168=(a168+a172);
  a168=(a168-a046);
  a172=(a145*a047);
  a174=(a087*a045);
  a172=(a172-a174);
  a174=(a033*a172);
  a168=(a168+a174);
  a175=(a087*a047);
  a176=(a145*a045);
  a175=(a175+a176);
  a176=(a175*a014);
  a177=(a007*a172);
  a176=(a176+a177);
  a176=(a176+a052);
  a177=(2.*a172);
  a176=(a176-a177);
  a176=(a176+a091);
  a176=(a010*a176);
  a168=(a168-a176);
  a091=(a159*a171);
  a168=(a168-a091);
  a091=(a159*a173);
  a168=(a168-a091);
  a091=(a156*a168);
  a091=(a141-a091);
  a143=(a143*a156);
  a143=(a076-a143);
  a091=(a091/a143);
  a177=(a081*a091);
  a080=(a080+a177);
  a080=(a008+a080);
  a177=(a007*a080);
  a177=(a177*a080);
  a177=(a177*a010);
  a178=(a079*a008);
  a179=(a081*a157);
  a178=(a178+a179);
  a178=(a011+a178);
  a179=sin(a178);
  a177=(a177*a179);
  a180=cos(a178);
  a181=(a180*a014);
  a182=casadi_sq(a080);
  a183=(a182*a010);
  a184=(a181*a183);
  a177=(a177-a184);
  a184=(a079*a065);
  a168=(a168/a152);
  a185=(a156*a091);
  a168=(a168-a185);
  a185=(a081*a168);
  a184=(a184+a185);
  a184=(a003+a184);
  a185=casadi_sq(a184);
  a186=(a185*a019);
  a187=(a079*a003);
  a188=(a081*a092);
  a187=(a187+a188);
  a187=(a000+a187);
  a188=cos(a187);
  a189=(a188*a014);
  a190=(a189*a010);
  a191=(a188*a180);
  a192=sin(a187);
  a193=(a192*a179);
  a191=(a191+a193);
  a193=(a191*a014);
  a194=(a193*a010);
  a195=(a190+a194);
  a196=(a029*a192);
  a195=(a195+a196);
  a197=(a192*a180);
  a198=(a188*a179);
  a197=(a197-a198);
  a198=(a029*a197);
  a195=(a195+a198);
  a199=(a033*a192);
  a195=(a195-a199);
  a200=(a035*a192);
  a195=(a195-a200);
  a201=(a186*a195);
  a201=(a177-a201);
  a202=(2.*a184);
  a202=(a202*a080);
  a203=(a202*a010);
  a204=(a007*a179);
  a181=(a181-a204);
  a204=(a193*a019);
  a205=(a181+a204);
  a206=(a042*a197);
  a205=(a205+a206);
  a205=(a203*a205);
  a201=(a201+a205);
  a201=(a201-a046);
  a205=(a192*a047);
  a207=(a188*a045);
  a205=(a205-a207);
  a207=(a033*a205);
  a201=(a201+a207);
  a208=(a188*a047);
  a209=(a192*a045);
  a208=(a208+a209);
  a209=(a208*a014);
  a210=(a007*a205);
  a209=(a209+a210);
  a209=(a209+a052);
  a210=(2.*a205);
  a209=(a209-a210);
  a178=(a178-a187);
  a178=(a178+a044);
  a187=cos(a178);
  a210=(a187*a014);
  a178=sin(a178);
  a211=(a007*a178);
  a210=(a210-a211);
  a209=(a209+a210);
  a209=(a010*a209);
  a201=(a201-a209);
  a211=(a183*a204);
  a201=(a201-a211);
  a211=(a183*a206);
  a201=(a201-a211);
  a211=(2.*a188);
  a212=(a211*a019);
  a213=(a033*a212);
  a213=(a041+a213);
  a213=(a213+a033);
  a213=(a213+a060);
  a214=(a061*a192);
  a215=(a188*a007);
  a216=(a215*a019);
  a217=(a214-a216);
  a180=(a180*a007);
  a217=(a217-a180);
  a217=(a217-a007);
  a218=(a014*a179);
  a217=(a217-a218);
  a217=(a217+a067);
  a217=(a217+a212);
  a219=(a061*a197);
  a217=(a217+a219);
  a191=(a191*a007);
  a220=(a191*a019);
  a217=(a217-a220);
  a217=(a217+a072);
  a217=(a217+a073);
  a217=(a035*a217);
  a213=(a213+a217);
  a217=(a201/a213);
  a221=(a180-a070);
  a221=(a221-a071);
  a221=(a221+a218);
  a221=(a221-a219);
  a221=(a221+a220);
  a221=(a010*a221);
  a221=(a221-a059);
  a222=(a221/a213);
  a223=(a185*a181);
  a210=(a210-a223);
  a210=(a010*a210);
  a201=(a222*a201);
  a201=(a210-a201);
  a221=(a221*a222);
  a221=(a076-a221);
  a201=(a201/a221);
  a223=(a222*a201);
  a217=(a217-a223);
  a223=(a078*a217);
  a077=(a077+a223);
  a223=1.2546768756682242e-01;
  a223=(a223*a002);
  a224=2.4136513415926669e-01;
  a224=(a224*a002);
  a225=(a224*a037);
  a226=-8.8454947932828609e-01;
  a226=(a226*a002);
  a091=(a226*a091);
  a225=(a225+a091);
  a091=9.2483400326179199e-01;
  a091=(a091*a002);
  a227=(a091*a201);
  a225=(a225+a227);
  a225=(a008+a225);
  a227=(a007*a225);
  a227=(a227*a225);
  a227=(a227*a010);
  a228=(a224*a008);
  a229=(a226*a157);
  a228=(a228+a229);
  a229=(a091*a080);
  a228=(a228+a229);
  a228=(a011+a228);
  a229=sin(a228);
  a227=(a227*a229);
  a230=cos(a228);
  a231=(a230*a014);
  a232=casadi_sq(a225);
  a233=(a232*a010);
  a234=(a231*a233);
  a227=(a227-a234);
  a234=(a224*a065);
  a168=(a226*a168);
  a234=(a234+a168);
  a168=(a091*a217);
  a234=(a234+a168);
  a234=(a003+a234);
  a168=casadi_sq(a234);
  a235=(a168*a019);
  a236=(a224*a003);
  a237=(a226*a092);
  a236=(a236+a237);
  a237=(a091*a184);
  a236=(a236+a237);
  a236=(a000+a236);
  a237=cos(a236);
  a238=(a237*a014);
  a239=(a238*a010);
  a240=(a237*a230);
  a241=sin(a236);
  a242=(a241*a229);
  a240=(a240+a242);
  a242=(a240*a014);
  a243=(a242*a010);
  a244=(a239+a243);
  a245=(a029*a241);
  a244=(a244+a245);
  a246=(a241*a230);
  a247=(a237*a229);
  a246=(a246-a247);
  a247=(a029*a246);
  a244=(a244+a247);
  a248=(a033*a241);
  a244=(a244-a248);
  a249=(a035*a241);
  a244=(a244-a249);
  a250=(a235*a244);
  a250=(a227-a250);
  a251=(2.*a234);
  a251=(a251*a225);
  a252=(a251*a010);
  a253=(a007*a229);
  a231=(a231-a253);
  a253=(a242*a019);
  a254=(a231+a253);
  a255=(a042*a246);
  a254=(a254+a255);
  a254=(a252*a254);
  a250=(a250+a254);
  a250=(a250-a046);
  a254=(a241*a047);
  a256=(a237*a045);
  a254=(a254-a256);
  a256=(a033*a254);
  a250=(a250+a256);
  a257=(a237*a047);
  a258=(a241*a045);
  a257=(a257+a258);
  a258=(a257*a014);
  a259=(a007*a254);
  a258=(a258+a259);
  a258=(a258+a052);
  a259=(2.*a254);
  a258=(a258-a259);
  a228=(a228-a236);
  a228=(a228+a044);
  a236=cos(a228);
  a259=(a236*a014);
  a228=sin(a228);
  a260=(a007*a228);
  a259=(a259-a260);
  a258=(a258+a259);
  a258=(a010*a258);
  a250=(a250-a258);
  a260=(a233*a253);
  a250=(a250-a260);
  a260=(a233*a255);
  a250=(a250-a260);
  a260=(2.*a237);
  a261=(a260*a019);
  a262=(a033*a261);
  a262=(a041+a262);
  a262=(a262+a033);
  a262=(a262+a060);
  a263=(a061*a241);
  a264=(a237*a007);
  a265=(a264*a019);
  a266=(a263-a265);
  a230=(a230*a007);
  a266=(a266-a230);
  a266=(a266-a007);
  a267=(a014*a229);
  a266=(a266-a267);
  a266=(a266+a067);
  a266=(a266+a261);
  a268=(a061*a246);
  a266=(a266+a268);
  a240=(a240*a007);
  a269=(a240*a019);
  a266=(a266-a269);
  a266=(a266+a072);
  a266=(a266+a073);
  a266=(a035*a266);
  a262=(a262+a266);
  a266=(a250/a262);
  a270=(a230-a070);
  a270=(a270-a071);
  a270=(a270+a267);
  a270=(a270-a268);
  a270=(a270+a269);
  a270=(a010*a270);
  a270=(a270-a059);
  a271=(a270/a262);
  a272=(a168*a231);
  a259=(a259-a272);
  a259=(a010*a259);
  a250=(a271*a250);
  a250=(a259-a250);
  a270=(a270*a271);
  a270=(a076-a270);
  a250=(a250/a270);
  a272=(a271*a250);
  a266=(a266-a272);
  a272=(a223*a266);
  a077=(a077+a272);
  a077=(a003+a077);
  a272=(a005*a077);
  a004=(a004+a272);
  a272=1.8915178993145003e+00;
  a272=(a272*a002);
  a273=3.7109375000000000e-02;
  a273=(a273*a002);
  a274=(a273*a065);
  a275=1.7025221101954405e-01;
  a275=(a275*a002);
  a276=(a275*a217);
  a274=(a274+a276);
  a276=6.0216538980455959e-02;
  a276=(a276*a002);
  a277=(a276*a266);
  a274=(a274+a277);
  a277=-1.7578125000000000e-02;
  a277=(a277*a002);
  a278=(a006*a037);
  a279=(a078*a201);
  a278=(a278+a279);
  a279=(a223*a250);
  a278=(a278+a279);
  a278=(a008+a278);
  a279=(a007*a278);
  a279=(a279*a278);
  a279=(a279*a010);
  a280=(a006*a008);
  a281=(a078*a080);
  a280=(a280+a281);
  a281=(a223*a225);
  a280=(a280+a281);
  a280=(a011+a280);
  a281=sin(a280);
  a279=(a279*a281);
  a282=cos(a280);
  a283=(a282*a014);
  a284=casadi_sq(a278);
  a285=(a284*a010);
  a286=(a283*a285);
  a279=(a279-a286);
  a286=casadi_sq(a077);
  a287=(a286*a019);
  a288=(a006*a003);
  a289=(a078*a184);
  a288=(a288+a289);
  a289=(a223*a234);
  a288=(a288+a289);
  a288=(a000+a288);
  a289=cos(a288);
  a290=(a289*a014);
  a291=(a290*a010);
  a292=(a289*a282);
  a293=sin(a288);
  a294=(a293*a281);
  a292=(a292+a294);
  a294=(a292*a014);
  a295=(a294*a010);
  a296=(a291+a295);
  a297=(a029*a293);
  a296=(a296+a297);
  a298=(a293*a282);
  a299=(a289*a281);
  a298=(a298-a299);
  a299=(a029*a298);
  a296=(a296+a299);
  a300=(a033*a293);
  a296=(a296-a300);
  a301=(a035*a293);
  a296=(a296-a301);
  a302=(a287*a296);
  a302=(a279-a302);
  a303=(2.*a077);
  a303=(a303*a278);
  a304=(a303*a010);
  a305=(a007*a281);
  a283=(a283-a305);
  a305=(a294*a019);
  a306=(a283+a305);
  a307=(a042*a298);
  a306=(a306+a307);
  a306=(a304*a306);
  a302=(a302+a306);
  a302=(a302-a046);
  a306=(a293*a047);
  a308=(a289*a045);
  a306=(a306-a308);
  a308=(a033*a306);
  a302=(a302+a308);
  a309=(a289*a047);
  a310=(a293*a045);
  a309=(a309+a310);
  a310=(a309*a014);
  a311=(a007*a306);
  a310=(a310+a311);
  a310=(a310+a052);
  a311=(2.*a306);
  a310=(a310-a311);
  a280=(a280-a288);
  a280=(a280+a044);
  a288=cos(a280);
  a311=(a288*a014);
  a280=sin(a280);
  a312=(a007*a280);
  a311=(a311-a312);
  a310=(a310+a311);
  a310=(a010*a310);
  a302=(a302-a310);
  a312=(a285*a305);
  a302=(a302-a312);
  a312=(a285*a307);
  a302=(a302-a312);
  a312=(2.*a289);
  a313=(a312*a019);
  a314=(a033*a313);
  a314=(a041+a314);
  a314=(a314+a033);
  a314=(a314+a060);
  a315=(a061*a293);
  a316=(a289*a007);
  a317=(a316*a019);
  a318=(a315-a317);
  a282=(a282*a007);
  a318=(a318-a282);
  a318=(a318-a007);
  a319=(a014*a281);
  a318=(a318-a319);
  a318=(a318+a067);
  a318=(a318+a313);
  a320=(a061*a298);
  a318=(a318+a320);
  a292=(a292*a007);
  a321=(a292*a019);
  a318=(a318-a321);
  a318=(a318+a072);
  a318=(a318+a073);
  a318=(a035*a318);
  a314=(a314+a318);
  a318=(a302/a314);
  a322=(a282-a070);
  a322=(a322-a071);
  a322=(a322+a319);
  a322=(a322-a320);
  a322=(a322+a321);
  a322=(a010*a322);
  a322=(a322-a059);
  a323=(a322/a314);
  a324=(a286*a283);
  a311=(a311-a324);
  a311=(a010*a311);
  a302=(a323*a302);
  a302=(a311-a302);
  a322=(a322*a323);
  a322=(a076-a322);
  a302=(a302/a322);
  a324=(a323*a302);
  a318=(a318-a324);
  a324=(a277*a318);
  a274=(a274+a324);
  a274=(a003+a274);
  a324=(a272*a274);
  a004=(a004+a324);
  a324=-5.8012039600105849e+00;
  a324=(a324*a002);
  a325=3.7092000118504789e-02;
  a325=(a325*a002);
  a326=(a325*a065);
  a327=1.7038392571223998e-01;
  a327=(a327*a002);
  a328=(a327*a217);
  a326=(a326+a328);
  a328=1.0726203044637328e-01;
  a328=(a328*a002);
  a329=(a328*a266);
  a326=(a326+a329);
  a329=-1.5319437748624402e-02;
  a329=(a329*a002);
  a330=(a329*a318);
  a326=(a326+a330);
  a330=8.2737891638140233e-03;
  a330=(a330*a002);
  a331=(a273*a037);
  a332=(a275*a201);
  a331=(a331+a332);
  a332=(a276*a250);
  a331=(a331+a332);
  a332=(a277*a302);
  a331=(a331+a332);
  a331=(a008+a331);
  a332=(a007*a331);
  a332=(a332*a331);
  a332=(a332*a010);
  a333=(a273*a008);
  a334=(a275*a080);
  a333=(a333+a334);
  a334=(a276*a225);
  a333=(a333+a334);
  a334=(a277*a278);
  a333=(a333+a334);
  a333=(a011+a333);
  a334=sin(a333);
  a332=(a332*a334);
  a335=cos(a333);
  a336=(a335*a014);
  a337=casadi_sq(a331);
  a338=(a337*a010);
  a339=(a336*a338);
  a332=(a332-a339);
  a339=casadi_sq(a274);
  a340=(a339*a019);
  a341=(a273*a003);
  a342=(a275*a184);
  a341=(a341+a342);
  a342=(a276*a234);
  a341=(a341+a342);
  a342=(a277*a077);
  a341=(a341+a342);
  a341=(a000+a341);
  a342=cos(a341);
  a343=(a342*a014);
  a344=(a343*a010);
  a345=(a342*a335);
  a346=sin(a341);
  a347=(a346*a334);
  a345=(a345+a347);
  a347=(a345*a014);
  a348=(a347*a010);
  a349=(a344+a348);
  a350=(a029*a346);
  a349=(a349+a350);
  a351=(a346*a335);
  a352=(a342*a334);
  a351=(a351-a352);
  a352=(a029*a351);
  a349=(a349+a352);
  a353=(a033*a346);
  a349=(a349-a353);
  a354=(a035*a346);
  a349=(a349-a354);
  a355=(a340*a349);
  a355=(a332-a355);
  a356=(2.*a274);
  a356=(a356*a331);
  a357=(a356*a010);
  a358=(a007*a334);
  a336=(a336-a358);
  a358=(a347*a019);
  a359=(a336+a358);
  a360=(a042*a351);
  a359=(a359+a360);
  a359=(a357*a359);
  a355=(a355+a359);
  a355=(a355-a046);
  a359=(a346*a047);
  a361=(a342*a045);
  a359=(a359-a361);
  a361=(a033*a359);
  a355=(a355+a361);
  a362=(a342*a047);
  a363=(a346*a045);
  a362=(a362+a363);
  a363=(a362*a014);
  a364=(a007*a359);
  a363=(a363+a364);
  a363=(a363+a052);
  a364=(2.*a359);
  a363=(a363-a364);
  a333=(a333-a341);
  a333=(a333+a044);
  a341=cos(a333);
  a364=(a341*a014);
  a333=sin(a333);
  a365=(a007*a333);
  a364=(a364-a365);
  a363=(a363+a364);
  a363=(a010*a363);
  a355=(a355-a363);
  a365=(a338*a358);
  a355=(a355-a365);
  a365=(a338*a360);
  a355=(a355-a365);
  a365=(2.*a342);
  a366=(a365*a019);
  a367=(a033*a366);
  a367=(a041+a367);
  a367=(a367+a033);
  a367=(a367+a060);
  a368=(a061*a346);
  a369=(a342*a007);
  a370=(a369*a019);
  a371=(a368-a370);
  a335=(a335*a007);
  a371=(a371-a335);
  a371=(a371-a007);
  a372=(a014*a334);
  a371=(a371-a372);
  a371=(a371+a067);
  a371=(a371+a366);
  a373=(a061*a351);
  a371=(a371+a373);
  a345=(a345*a007);
  a374=(a345*a019);
  a371=(a371-a374);
  a371=(a371+a072);
  a371=(a371+a073);
  a371=(a035*a371);
  a367=(a367+a371);
  a371=(a355/a367);
  a375=(a335-a070);
  a375=(a375-a071);
  a375=(a375+a372);
  a375=(a375-a373);
  a375=(a375+a374);
  a375=(a010*a375);
  a375=(a375-a059);
  a376=(a375/a367);
  a377=(a339*a336);
  a364=(a364-a377);
  a364=(a010*a364);
  a355=(a376*a355);
  a355=(a364-a355);
  a375=(a375*a376);
  a375=(a076-a375);
  a355=(a355/a375);
  a377=(a376*a355);
  a371=(a371-a377);
  a377=(a330*a371);
  a326=(a326+a377);
  a326=(a003+a326);
  a377=(a324*a326);
  a004=(a004+a377);
  a377=3.1116436695781990e-01;
  a377=(a377*a002);
  a378=6.2411095871607569e-01;
  a378=(a378*a002);
  a379=(a378*a065);
  a380=-3.3608926294469414e+00;
  a380=(a380*a002);
  a381=(a380*a217);
  a379=(a379+a381);
  a381=-8.6821934684172597e-01;
  a381=(a381*a002);
  a382=(a381*a266);
  a379=(a379+a382);
  a382=2.7592099699446710e+01;
  a382=(a382*a002);
  a383=(a382*a318);
  a379=(a379+a383);
  a383=2.0154067550477894e+01;
  a383=(a383*a002);
  a384=(a383*a371);
  a379=(a379+a384);
  a384=-4.3489884181069961e+01;
  a384=(a384*a002);
  a385=(a325*a037);
  a386=(a327*a201);
  a385=(a385+a386);
  a386=(a328*a250);
  a385=(a385+a386);
  a386=(a329*a302);
  a385=(a385+a386);
  a386=(a330*a355);
  a385=(a385+a386);
  a385=(a008+a385);
  a386=(a007*a385);
  a386=(a386*a385);
  a386=(a386*a010);
  a387=(a325*a008);
  a388=(a327*a080);
  a387=(a387+a388);
  a388=(a328*a225);
  a387=(a387+a388);
  a388=(a329*a278);
  a387=(a387+a388);
  a388=(a330*a331);
  a387=(a387+a388);
  a387=(a011+a387);
  a388=sin(a387);
  a386=(a386*a388);
  a389=cos(a387);
  a390=(a389*a014);
  a391=casadi_sq(a385);
  a392=(a391*a010);
  a393=(a390*a392);
  a386=(a386-a393);
  a393=casadi_sq(a326);
  a394=(a393*a019);
  a395=(a325*a003);
  a396=(a327*a184);
  a395=(a395+a396);
  a396=(a328*a234);
  a395=(a395+a396);
  a396=(a329*a077);
  a395=(a395+a396);
  a396=(a330*a274);
  a395=(a395+a396);
  a395=(a000+a395);
  a396=cos(a395);
  a397=(a396*a014);
  a398=(a397*a010);
  a399=(a396*a389);
  a400=sin(a395);
  a401=(a400*a388);
  a399=(a399+a401);
  a401=(a399*a014);
  a402=(a401*a010);
  a403=(a398+a402);
  a404=(a029*a400);
  a403=(a403+a404);
  a405=(a400*a389);
  a406=(a396*a388);
  a405=(a405-a406);
  a406=(a029*a405);
  a403=(a403+a406);
  a407=(a033*a400);
  a403=(a403-a407);
  a408=(a035*a400);
  a403=(a403-a408);
  a409=(a394*a403);
  a409=(a386-a409);
  a410=(2.*a326);
  a410=(a410*a385);
  a411=(a410*a010);
  a412=(a007*a388);
  a390=(a390-a412);
  a412=(a401*a019);
  a413=(a390+a412);
  a414=(a042*a405);
  a413=(a413+a414);
  a413=(a411*a413);
  a409=(a409+a413);
  a409=(a409-a046);
  a413=(a400*a047);
  a415=(a396*a045);
  a413=(a413-a415);
  a415=(a033*a413);
  a409=(a409+a415);
  a416=(a396*a047);
  a417=(a400*a045);
  a416=(a416+a417);
  a417=(a416*a014);
  a418=(a007*a413);
  a417=(a417+a418);
  a417=(a417+a052);
  a418=(2.*a413);
  a417=(a417-a418);
  a387=(a387-a395);
  a387=(a387+a044);
  a395=cos(a387);
  a418=(a395*a014);
  a387=sin(a387);
  a419=(a007*a387);
  a418=(a418-a419);
  a417=(a417+a418);
  a417=(a010*a417);
  a409=(a409-a417);
  a419=(a392*a412);
  a409=(a409-a419);
  a419=(a392*a414);
  a409=(a409-a419);
  a419=(2.*a396);
  a420=(a419*a019);
  a421=(a033*a420);
  a421=(a041+a421);
  a421=(a421+a033);
  a421=(a421+a060);
  a422=(a061*a400);
  a423=(a396*a007);
  a424=(a423*a019);
  a425=(a422-a424);
  a389=(a389*a007);
  a425=(a425-a389);
  a425=(a425-a007);
  a426=(a014*a388);
  a425=(a425-a426);
  a425=(a425+a067);
  a425=(a425+a420);
  a427=(a061*a405);
  a425=(a425+a427);
  a399=(a399*a007);
  a428=(a399*a019);
  a425=(a425-a428);
  a425=(a425+a072);
  a425=(a425+a073);
  a425=(a035*a425);
  a421=(a421+a425);
  a425=(a409/a421);
  a429=(a389-a070);
  a429=(a429-a071);
  a429=(a429+a426);
  a429=(a429-a427);
  a429=(a429+a428);
  a429=(a010*a429);
  a429=(a429-a059);
  a430=(a429/a421);
  a431=(a393*a390);
  a418=(a418-a431);
  a418=(a010*a418);
  a409=(a430*a409);
  a409=(a418-a409);
  a429=(a429*a430);
  a429=(a076-a429);
  a409=(a409/a429);
  a431=(a430*a409);
  a425=(a425-a431);
  a431=(a384*a425);
  a379=(a379+a431);
  a379=(a003+a379);
  a431=(a377*a379);
  a004=(a004+a431);
  a431=-1.5216094966251609e-01;
  a431=(a431*a002);
  a432=4.7766253643826434e-01;
  a432=(a432*a002);
  a433=(a432*a065);
  a434=-2.4881146199716677e+00;
  a434=(a434*a002);
  a435=(a434*a217);
  a433=(a433+a435);
  a435=-5.9029082683684297e-01;
  a435=(a435*a002);
  a436=(a435*a266);
  a433=(a433+a436);
  a436=2.1230051448181193e+01;
  a436=(a436*a002);
  a437=(a436*a318);
  a433=(a433+a437);
  a437=1.5279233632882423e+01;
  a437=(a437*a002);
  a438=(a437*a371);
  a433=(a433+a438);
  a438=-3.3288210968984863e+01;
  a438=(a438*a002);
  a439=(a438*a425);
  a433=(a433+a439);
  a439=-2.0331201708508627e-02;
  a439=(a439*a002);
  a440=(a378*a037);
  a441=(a380*a201);
  a440=(a440+a441);
  a441=(a381*a250);
  a440=(a440+a441);
  a441=(a382*a302);
  a440=(a440+a441);
  a441=(a383*a355);
  a440=(a440+a441);
  a441=(a384*a409);
  a440=(a440+a441);
  a440=(a008+a440);
  a441=(a007*a440);
  a441=(a441*a440);
  a441=(a441*a010);
  a442=(a378*a008);
  a443=(a380*a080);
  a442=(a442+a443);
  a443=(a381*a225);
  a442=(a442+a443);
  a443=(a382*a278);
  a442=(a442+a443);
  a443=(a383*a331);
  a442=(a442+a443);
  a443=(a384*a385);
  a442=(a442+a443);
  a442=(a011+a442);
  a443=sin(a442);
  a441=(a441*a443);
  a444=cos(a442);
  a445=(a444*a014);
  a446=casadi_sq(a440);
  a447=(a446*a010);
  a448=(a445*a447);
  a441=(a441-a448);
  a448=casadi_sq(a379);
  a449=(a448*a019);
  a450=(a378*a003);
  a451=(a380*a184);
  a450=(a450+a451);
  a451=(a381*a234);
  a450=(a450+a451);
  a451=(a382*a077);
  a450=(a450+a451);
  a451=(a383*a274);
  a450=(a450+a451);
  a451=(a384*a326);
  a450=(a450+a451);
  a450=(a000+a450);
  a451=cos(a450);
  a452=(a451*a014);
  a453=(a452*a010);
  a454=(a451*a444);
  a455=sin(a450);
  a456=(a455*a443);
  a454=(a454+a456);
  a456=(a454*a014);
  a457=(a456*a010);
  a458=(a453+a457);
  a459=(a029*a455);
  a458=(a458+a459);
  a460=(a455*a444);
  a461=(a451*a443);
  a460=(a460-a461);
  a461=(a029*a460);
  a458=(a458+a461);
  a462=(a033*a455);
  a458=(a458-a462);
  a463=(a035*a455);
  a458=(a458-a463);
  a464=(a449*a458);
  a464=(a441-a464);
  a465=(2.*a379);
  a465=(a465*a440);
  a466=(a465*a010);
  a467=(a007*a443);
  a445=(a445-a467);
  a467=(a456*a019);
  a468=(a445+a467);
  a469=(a042*a460);
  a468=(a468+a469);
  a468=(a466*a468);
  a464=(a464+a468);
  a464=(a464-a046);
  a468=(a455*a047);
  a470=(a451*a045);
  a468=(a468-a470);
  a470=(a033*a468);
  a464=(a464+a470);
  a471=(a451*a047);
  a472=(a455*a045);
  a471=(a471+a472);
  a472=(a471*a014);
  a473=(a007*a468);
  a472=(a472+a473);
  a472=(a472+a052);
  a473=(2.*a468);
  a472=(a472-a473);
  a442=(a442-a450);
  a442=(a442+a044);
  a450=cos(a442);
  a473=(a450*a014);
  a442=sin(a442);
  a474=(a007*a442);
  a473=(a473-a474);
  a472=(a472+a473);
  a472=(a010*a472);
  a464=(a464-a472);
  a474=(a447*a467);
  a464=(a464-a474);
  a474=(a447*a469);
  a464=(a464-a474);
  a474=(2.*a451);
  a475=(a474*a019);
  a476=(a033*a475);
  a476=(a041+a476);
  a476=(a476+a033);
  a476=(a476+a060);
  a477=(a061*a455);
  a478=(a451*a007);
  a479=(a478*a019);
  a480=(a477-a479);
  a444=(a444*a007);
  a480=(a480-a444);
  a480=(a480-a007);
  a481=(a014*a443);
  a480=(a480-a481);
  a480=(a480+a067);
  a480=(a480+a475);
  a482=(a061*a460);
  a480=(a480+a482);
  a454=(a454*a007);
  a483=(a454*a019);
  a480=(a480-a483);
  a480=(a480+a072);
  a480=(a480+a073);
  a480=(a035*a480);
  a476=(a476+a480);
  a480=(a464/a476);
  a484=(a444-a070);
  a484=(a484-a071);
  a484=(a484+a481);
  a484=(a484-a482);
  a484=(a484+a483);
  a484=(a010*a484);
  a484=(a484-a059);
  a485=(a484/a476);
  a486=(a448*a445);
  a473=(a473-a486);
  a473=(a010*a473);
  a464=(a485*a464);
  a464=(a473-a464);
  a484=(a484*a485);
  a484=(a076-a484);
  a464=(a464/a484);
  a486=(a485*a464);
  a480=(a480-a486);
  a486=(a439*a480);
  a433=(a433+a486);
  a433=(a003+a433);
  a486=(a431*a433);
  a004=(a004+a486);
  a486=2.0136540080403034e-01;
  a486=(a486*a002);
  a487=-9.3714243008598730e-01;
  a487=(a487*a002);
  a488=(a487*a065);
  a489=5.1863724288440638e+00;
  a489=(a489*a002);
  a490=(a489*a217);
  a488=(a488+a490);
  a490=1.0914373489967295e+00;
  a490=(a490*a002);
  a491=(a490*a266);
  a488=(a488+a491);
  a491=-8.1497870107469268e+00;
  a491=(a491*a002);
  a492=(a491*a318);
  a488=(a488+a492);
  a492=-1.8520065659996959e+01;
  a492=(a492*a002);
  a493=(a492*a371);
  a488=(a488+a493);
  a493=2.2739487099350505e+01;
  a493=(a493*a002);
  a494=(a493*a425);
  a488=(a488+a494);
  a494=2.4936055526796523e+00;
  a494=(a494*a002);
  a495=(a494*a480);
  a488=(a488+a495);
  a495=-3.0467644718982196e+00;
  a495=(a495*a002);
  a496=(a432*a037);
  a497=(a434*a201);
  a496=(a496+a497);
  a497=(a435*a250);
  a496=(a496+a497);
  a497=(a436*a302);
  a496=(a496+a497);
  a497=(a437*a355);
  a496=(a496+a497);
  a497=(a438*a409);
  a496=(a496+a497);
  a497=(a439*a464);
  a496=(a496+a497);
  a496=(a008+a496);
  a497=(a007*a496);
  a497=(a497*a496);
  a497=(a497*a010);
  a498=(a432*a008);
  a499=(a434*a080);
  a498=(a498+a499);
  a499=(a435*a225);
  a498=(a498+a499);
  a499=(a436*a278);
  a498=(a498+a499);
  a499=(a437*a331);
  a498=(a498+a499);
  a499=(a438*a385);
  a498=(a498+a499);
  a499=(a439*a440);
  a498=(a498+a499);
  a498=(a011+a498);
  a499=sin(a498);
  a497=(a497*a499);
  a500=cos(a498);
  a501=(a500*a014);
  a502=casadi_sq(a496);
  a503=(a502*a010);
  a504=(a501*a503);
  a497=(a497-a504);
  a504=casadi_sq(a433);
  a505=(a504*a019);
  a506=(a432*a003);
  a507=(a434*a184);
  a506=(a506+a507);
  a507=(a435*a234);
  a506=(a506+a507);
  a507=(a436*a077);
  a506=(a506+a507);
  a507=(a437*a274);
  a506=(a506+a507);
  a507=(a438*a326);
  a506=(a506+a507);
  a507=(a439*a379);
  a506=(a506+a507);
  a506=(a000+a506);
  a507=cos(a506);
  a508=(a507*a014);
  a509=(a508*a010);
  a510=(a507*a500);
  a511=sin(a506);
  a512=(a511*a499);
  a510=(a510+a512);
  a512=(a510*a014);
  a513=(a512*a010);
  a514=(a509+a513);
  a515=(a029*a511);
  a514=(a514+a515);
  a516=(a511*a500);
  a517=(a507*a499);
  a516=(a516-a517);
  a517=(a029*a516);
  a514=(a514+a517);
  a518=(a033*a511);
  a514=(a514-a518);
  a519=(a035*a511);
  a514=(a514-a519);
  a520=(a505*a514);
  a520=(a497-a520);
  a521=(2.*a433);
  a521=(a521*a496);
  a522=(a521*a010);
  a523=(a007*a499);
  a501=(a501-a523);
  a523=(a512*a019);
  a524=(a501+a523);
  a525=(a042*a516);
  a524=(a524+a525);
  a524=(a522*a524);
  a520=(a520+a524);
  a520=(a520-a046);
  a524=(a511*a047);
  a526=(a507*a045);
  a524=(a524-a526);
  a526=(a033*a524);
  a520=(a520+a526);
  a527=(a507*a047);
  a528=(a511*a045);
  a527=(a527+a528);
  a528=(a527*a014);
  a529=(a007*a524);
  a528=(a528+a529);
  a528=(a528+a052);
  a529=(2.*a524);
  a528=(a528-a529);
  a498=(a498-a506);
  a498=(a498+a044);
  a506=cos(a498);
  a529=(a506*a014);
  a498=sin(a498);
  a530=(a007*a498);
  a529=(a529-a530);
  a528=(a528+a529);
  a528=(a010*a528);
  a520=(a520-a528);
  a530=(a503*a523);
  a520=(a520-a530);
  a530=(a503*a525);
  a520=(a520-a530);
  a530=(2.*a507);
  a531=(a530*a019);
  a532=(a033*a531);
  a532=(a041+a532);
  a532=(a532+a033);
  a532=(a532+a060);
  a533=(a061*a511);
  a534=(a507*a007);
  a535=(a534*a019);
  a536=(a533-a535);
  a500=(a500*a007);
  a536=(a536-a500);
  a536=(a536-a007);
  a537=(a014*a499);
  a536=(a536-a537);
  a536=(a536+a067);
  a536=(a536+a531);
  a538=(a061*a516);
  a536=(a536+a538);
  a510=(a510*a007);
  a539=(a510*a019);
  a536=(a536-a539);
  a536=(a536+a072);
  a536=(a536+a073);
  a536=(a035*a536);
  a532=(a532+a536);
  a536=(a520/a532);
  a540=(a500-a070);
  a540=(a540-a071);
  a540=(a540+a537);
  a540=(a540-a538);
  a540=(a540+a539);
  a540=(a010*a540);
  a540=(a540-a059);
  a541=(a540/a532);
  a542=(a504*a501);
  a529=(a529-a542);
  a529=(a010*a529);
  a520=(a541*a520);
  a520=(a529-a520);
  a540=(a540*a541);
  a540=(a076-a540);
  a520=(a520/a540);
  a542=(a541*a520);
  a536=(a536-a542);
  a542=(a495*a536);
  a488=(a488+a542);
  a488=(a003+a488);
  a542=(a486*a488);
  a004=(a004+a542);
  a542=4.4710615727772587e-02;
  a542=(a542*a002);
  a543=2.2733101475165380e+00;
  a543=(a543*a002);
  a544=(a543*a065);
  a545=-1.0534495466737249e+01;
  a545=(a545*a002);
  a217=(a545*a217);
  a544=(a544+a217);
  a217=-2.0008720582248625e+00;
  a217=(a217*a002);
  a266=(a217*a266);
  a544=(a544+a266);
  a266=-1.7958931863118799e+01;
  a266=(a266*a002);
  a546=(a266*a318);
  a544=(a544+a546);
  a546=2.7948884529419960e+01;
  a546=(a546*a002);
  a547=(a546*a371);
  a544=(a544+a547);
  a547=-2.8589982771350235e+00;
  a547=(a547*a002);
  a548=(a547*a425);
  a544=(a544+a548);
  a548=-8.8728569335306293e+00;
  a548=(a548*a002);
  a549=(a548*a480);
  a544=(a544+a549);
  a549=1.2360567175794303e+01;
  a549=(a549*a002);
  a550=(a549*a536);
  a544=(a544+a550);
  a550=6.4339274601576357e-01;
  a550=(a550*a002);
  a002=(a487*a037);
  a551=(a489*a201);
  a002=(a002+a551);
  a551=(a490*a250);
  a002=(a002+a551);
  a551=(a491*a302);
  a002=(a002+a551);
  a551=(a492*a355);
  a002=(a002+a551);
  a551=(a493*a409);
  a002=(a002+a551);
  a551=(a494*a464);
  a002=(a002+a551);
  a551=(a495*a520);
  a002=(a002+a551);
  a002=(a008+a002);
  a551=(a007*a002);
  a551=(a551*a002);
  a551=(a551*a010);
  a552=(a487*a008);
  a553=(a489*a080);
  a552=(a552+a553);
  a553=(a490*a225);
  a552=(a552+a553);
  a553=(a491*a278);
  a552=(a552+a553);
  a553=(a492*a331);
  a552=(a552+a553);
  a553=(a493*a385);
  a552=(a552+a553);
  a553=(a494*a440);
  a552=(a552+a553);
  a553=(a495*a496);
  a552=(a552+a553);
  a552=(a011+a552);
  a553=sin(a552);
  a551=(a551*a553);
  a554=cos(a552);
  a555=(a554*a014);
  a556=casadi_sq(a002);
  a557=(a556*a010);
  a558=(a555*a557);
  a551=(a551-a558);
  a558=casadi_sq(a488);
  a559=(a558*a019);
  a560=(a487*a003);
  a561=(a489*a184);
  a560=(a560+a561);
  a561=(a490*a234);
  a560=(a560+a561);
  a561=(a491*a077);
  a560=(a560+a561);
  a561=(a492*a274);
  a560=(a560+a561);
  a561=(a493*a326);
  a560=(a560+a561);
  a561=(a494*a379);
  a560=(a560+a561);
  a561=(a495*a433);
  a560=(a560+a561);
  a560=(a000+a560);
  a561=cos(a560);
  a562=(a561*a014);
  a563=(a562*a010);
  a564=(a561*a554);
  a565=sin(a560);
  a566=(a565*a553);
  a564=(a564+a566);
  a566=(a564*a014);
  a567=(a566*a010);
  a568=(a563+a567);
  a569=(a029*a565);
  a568=(a568+a569);
  a570=(a565*a554);
  a571=(a561*a553);
  a570=(a570-a571);
  a571=(a029*a570);
  a568=(a568+a571);
  a572=(a033*a565);
  a568=(a568-a572);
  a573=(a035*a565);
  a568=(a568-a573);
  a574=(a559*a568);
  a574=(a551-a574);
  a575=(2.*a488);
  a575=(a575*a002);
  a576=(a575*a010);
  a577=(a007*a553);
  a555=(a555-a577);
  a577=(a566*a019);
  a578=(a555+a577);
  a579=(a042*a570);
  a578=(a578+a579);
  a578=(a576*a578);
  a574=(a574+a578);
  a574=(a574-a046);
  a578=(a565*a047);
  a580=(a561*a045);
  a578=(a578-a580);
  a580=(a033*a578);
  a574=(a574+a580);
  a581=(a561*a047);
  a582=(a565*a045);
  a581=(a581+a582);
  a582=(a581*a014);
  a583=(a007*a578);
  a582=(a582+a583);
  a582=(a582+a052);
  a583=(2.*a578);
  a582=(a582-a583);
  a552=(a552-a560);
  a552=(a552+a044);
  a560=cos(a552);
  a583=(a560*a014);
  a552=sin(a552);
  a584=(a007*a552);
  a583=(a583-a584);
  a582=(a582+a583);
  a582=(a010*a582);
  a574=(a574-a582);
  a584=(a557*a577);
  a574=(a574-a584);
  a584=(a557*a579);
  a574=(a574-a584);
  a584=(2.*a561);
  a585=(a584*a019);
  a586=(a033*a585);
  a586=(a041+a586);
  a586=(a586+a033);
  a586=(a586+a060);
  a587=(a061*a565);
  a588=(a561*a007);
  a589=(a588*a019);
  a590=(a587-a589);
  a554=(a554*a007);
  a590=(a590-a554);
  a590=(a590-a007);
  a591=(a014*a553);
  a590=(a590-a591);
  a590=(a590+a067);
  a590=(a590+a585);
  a592=(a061*a570);
  a590=(a590+a592);
  a564=(a564*a007);
  a593=(a564*a019);
  a590=(a590-a593);
  a590=(a590+a072);
  a590=(a590+a073);
  a590=(a035*a590);
  a586=(a586+a590);
  a590=(a574/a586);
  a594=(a554-a070);
  a594=(a594-a071);
  a594=(a594+a591);
  a594=(a594-a592);
  a594=(a594+a593);
  a594=(a010*a594);
  a594=(a594-a059);
  a595=(a594/a586);
  a596=(a558*a555);
  a583=(a583-a596);
  a583=(a010*a583);
  a574=(a595*a574);
  a574=(a583-a574);
  a594=(a594*a595);
  a594=(a076-a594);
  a574=(a574/a594);
  a596=(a595*a574);
  a590=(a590-a596);
  a596=(a550*a590);
  a544=(a544+a596);
  a544=(a003+a544);
  a596=(a542*a544);
  a004=(a004+a596);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a596=(a005*a278);
  a004=(a004+a596);
  a596=(a272*a331);
  a004=(a004+a596);
  a596=(a324*a385);
  a004=(a004+a596);
  a596=(a377*a440);
  a004=(a004+a596);
  a596=(a431*a496);
  a004=(a004+a596);
  a596=(a486*a002);
  a004=(a004+a596);
  a596=(a543*a037);
  a201=(a545*a201);
  a596=(a596+a201);
  a250=(a217*a250);
  a596=(a596+a250);
  a250=(a266*a302);
  a596=(a596+a250);
  a250=(a546*a355);
  a596=(a596+a250);
  a250=(a547*a409);
  a596=(a596+a250);
  a250=(a548*a464);
  a596=(a596+a250);
  a250=(a549*a520);
  a596=(a596+a250);
  a250=(a550*a574);
  a596=(a596+a250);
  a596=(a008+a596);
  a250=(a542*a596);
  a004=(a004+a250);
  a004=(a011+a004);
  if (res[0]!=0) res[0][1]=a004;
  a065=(a001*a065);
  a318=(a005*a318);
  a065=(a065+a318);
  a371=(a272*a371);
  a065=(a065+a371);
  a425=(a324*a425);
  a065=(a065+a425);
  a480=(a377*a480);
  a065=(a065+a480);
  a536=(a431*a536);
  a065=(a065+a536);
  a590=(a486*a590);
  a065=(a065+a590);
  a590=(a007*a596);
  a590=(a590*a596);
  a590=(a590*a010);
  a536=(a543*a008);
  a480=(a545*a080);
  a536=(a536+a480);
  a480=(a217*a225);
  a536=(a536+a480);
  a480=(a266*a278);
  a536=(a536+a480);
  a480=(a546*a331);
  a536=(a536+a480);
  a480=(a547*a385);
  a536=(a536+a480);
  a480=(a548*a440);
  a536=(a536+a480);
  a480=(a549*a496);
  a536=(a536+a480);
  a480=(a550*a002);
  a536=(a536+a480);
  a011=(a011+a536);
  a536=sin(a011);
  a590=(a590*a536);
  a480=cos(a011);
  a425=(a480*a014);
  a371=casadi_sq(a596);
  a318=(a371*a010);
  a004=(a425*a318);
  a590=(a590-a004);
  a004=casadi_sq(a544);
  a250=(a004*a019);
  a201=(a543*a003);
  a597=(a545*a184);
  a201=(a201+a597);
  a597=(a217*a234);
  a201=(a201+a597);
  a597=(a266*a077);
  a201=(a201+a597);
  a597=(a546*a274);
  a201=(a201+a597);
  a597=(a547*a326);
  a201=(a201+a597);
  a597=(a548*a379);
  a201=(a201+a597);
  a597=(a549*a433);
  a201=(a201+a597);
  a597=(a550*a488);
  a201=(a201+a597);
  a000=(a000+a201);
  a201=cos(a000);
  a597=(a201*a014);
  a598=(a597*a010);
  a599=(a201*a480);
  a600=sin(a000);
  a601=(a600*a536);
  a599=(a599+a601);
  a601=(a599*a014);
  a602=(a601*a010);
  a603=(a598+a602);
  a604=(a029*a600);
  a603=(a603+a604);
  a605=(a600*a480);
  a606=(a201*a536);
  a605=(a605-a606);
  a029=(a029*a605);
  a603=(a603+a029);
  a606=(a033*a600);
  a603=(a603-a606);
  a607=(a035*a600);
  a603=(a603-a607);
  a608=(a250*a603);
  a608=(a590-a608);
  a609=(2.*a544);
  a609=(a609*a596);
  a610=(a609*a010);
  a611=(a007*a536);
  a425=(a425-a611);
  a611=(a601*a019);
  a612=(a425+a611);
  a042=(a042*a605);
  a612=(a612+a042);
  a612=(a610*a612);
  a608=(a608+a612);
  a608=(a608-a046);
  a612=(a600*a047);
  a613=(a201*a045);
  a612=(a612-a613);
  a613=(a033*a612);
  a608=(a608+a613);
  a047=(a201*a047);
  a045=(a600*a045);
  a047=(a047+a045);
  a045=(a047*a014);
  a614=(a007*a612);
  a045=(a045+a614);
  a045=(a045+a052);
  a052=(2.*a612);
  a045=(a045-a052);
  a011=(a011-a000);
  a011=(a011+a044);
  a044=cos(a011);
  a000=(a044*a014);
  a011=sin(a011);
  a052=(a007*a011);
  a000=(a000-a052);
  a045=(a045+a000);
  a045=(a010*a045);
  a608=(a608-a045);
  a052=(a318*a611);
  a608=(a608-a052);
  a052=(a318*a042);
  a608=(a608-a052);
  a052=(2.*a201);
  a614=(a052*a019);
  a615=(a033*a614);
  a615=(a041+a615);
  a615=(a615+a033);
  a615=(a615+a060);
  a616=(a061*a600);
  a617=(a201*a007);
  a618=(a617*a019);
  a619=(a616-a618);
  a480=(a480*a007);
  a619=(a619-a480);
  a619=(a619-a007);
  a620=(a014*a536);
  a619=(a619-a620);
  a619=(a619+a067);
  a619=(a619+a614);
  a061=(a061*a605);
  a619=(a619+a061);
  a599=(a599*a007);
  a621=(a599*a019);
  a619=(a619-a621);
  a619=(a619+a072);
  a619=(a619+a073);
  a619=(a035*a619);
  a615=(a615+a619);
  a619=(a608/a615);
  a622=(a480-a070);
  a622=(a622-a071);
  a622=(a622+a620);
  a622=(a622-a061);
  a622=(a622+a621);
  a622=(a010*a622);
  a622=(a622-a059);
  a623=(a622/a615);
  a624=(a004*a425);
  a000=(a000-a624);
  a000=(a010*a000);
  a608=(a623*a608);
  a608=(a000-a608);
  a622=(a622*a623);
  a622=(a076-a622);
  a608=(a608/a622);
  a624=(a623*a608);
  a619=(a619-a624);
  a619=(a542*a619);
  a065=(a065+a619);
  a065=(a003+a065);
  if (res[0]!=0) res[0][2]=a065;
  a037=(a001*a037);
  a302=(a005*a302);
  a037=(a037+a302);
  a355=(a272*a355);
  a037=(a037+a355);
  a409=(a324*a409);
  a037=(a037+a409);
  a464=(a377*a464);
  a037=(a037+a464);
  a520=(a431*a520);
  a037=(a037+a520);
  a574=(a486*a574);
  a037=(a037+a574);
  a608=(a542*a608);
  a037=(a037+a608);
  a037=(a008+a037);
  if (res[0]!=0) res[0][3]=a037;
  a037=arg[0]? arg[0][4] : 0;
  a608=arg[0]? arg[0][6] : 0;
  a574=(a001*a608);
  a009=(a009-a046);
  a009=(a009+a049);
  a009=(a009-a051);
  a023=(a023+a030);
  a023=(a023-a034);
  a023=(a023-a036);
  a023=(a023+a027);
  a023=(a023+a032);
  a023=(a020*a023);
  a009=(a009-a023);
  a023=(a016*a019);
  a027=(a027*a023);
  a009=(a009-a027);
  a023=(a023*a032);
  a009=(a009-a023);
  a040=(a040+a043);
  a040=(a040+a015);
  a043=(a040*a039);
  a009=(a009+a043);
  a043=(a056*a033);
  a043=(a043*a019);
  a043=(a043+a041);
  a043=(a043+a033);
  a043=(a043+a060);
  a057=(a057-a064);
  a057=(a057-a013);
  a057=(a057-a007);
  a057=(a057+a062);
  a057=(a057-a066);
  a057=(a057+a067);
  a057=(a057+a068);
  a057=(a057-a069);
  a057=(a057+a072);
  a057=(a057+a073);
  a057=(a035*a057);
  a043=(a043+a057);
  a057=(a009/a043);
  a062=(a069-a068);
  a066=(a013+a066);
  a062=(a062+a066);
  a064=(a062-a070);
  a064=(a064-a071);
  a064=(a010*a064);
  a064=(a064-a059);
  a023=(a064/a043);
  a009=(a023*a009);
  a055=(a055-a009);
  a064=(a064*a023);
  a064=(a076-a064);
  a055=(a055/a064);
  a009=(a023*a055);
  a057=(a057-a009);
  a009=(2.*a057);
  a032=(a009*a019);
  a027=(a007*a025);
  a022=(a022+a027);
  a027=(2.*a025);
  a022=(a022-a027);
  a027=(a007*a031);
  a026=(a026+a027);
  a022=(a022+a026);
  a022=(a010*a022);
  a034=(a034-a022);
  a032=(a032*a034);
  a034=(a055*a010);
  a034=(a034*a019);
  a034=(a034*a026);
  a032=(a032+a034);
  a034=(a050*a033);
  a032=(a032+a034);
  a034=(a014*a008);
  a034=(a034*a008);
  a022=(a034*a010);
  a022=(a022*a019);
  a022=(a022*a031);
  a032=(a032+a022);
  a022=(2.*a050);
  a050=(a050*a007);
  a022=(a022-a050);
  a048=(a014*a048);
  a022=(a022+a048);
  a054=(a054*a007);
  a053=(a014*a053);
  a048=(a054+a053);
  a022=(a022-a048);
  a022=(a010*a022);
  a032=(a032+a022);
  a022=(a014*a031);
  a022=(a022-a024);
  a050=(a019*a022);
  a050=(a050*a039);
  a032=(a032-a050);
  a021=(a021*a033);
  a063=(a063*a010);
  a021=(a021-a063);
  a056=(a056*a010);
  a021=(a021+a056);
  a056=(a024*a010);
  a021=(a021-a056);
  a056=(a014*a010);
  a025=(a056*a025);
  a021=(a021+a025);
  a031=(a056*a031);
  a021=(a021+a031);
  a021=(a020*a021);
  a032=(a032+a021);
  a069=(a069*a017);
  a032=(a032-a069);
  a069=(a032/a043);
  a017=(a057*a019);
  a017=(a017*a026);
  a017=(a017+a048);
  a017=(a010*a017);
  a032=(a023*a032);
  a017=(a017-a032);
  a017=(a017/a064);
  a032=(a023*a017);
  a069=(a069-a032);
  a032=(a069*a037);
  a009=(a009*a040);
  a055=(a055*a040);
  a009=(a009-a055);
  a009=(a009+a054);
  a024=(a024*a008);
  a024=(a024*a008);
  a024=(a024*a019);
  a009=(a009+a024);
  a013=(a013*a008);
  a013=(a013*a008);
  a009=(a009+a013);
  a034=(a034*a012);
  a009=(a009+a034);
  a009=(a009+a053);
  a038=(a038*a062);
  a009=(a009-a038);
  a016=(a016*a068);
  a009=(a009-a016);
  a020=(a020*a022);
  a009=(a009-a020);
  a009=(a010*a009);
  a043=(a009/a043);
  a018=(a018*a066);
  a057=(a057*a040);
  a018=(a018-a057);
  a018=(a018-a048);
  a018=(a010*a018);
  a009=(a023*a009);
  a018=(a018-a009);
  a018=(a018/a064);
  a023=(a023*a018);
  a043=(a043-a023);
  a023=arg[0]? arg[0][5] : 0;
  a064=(a043*a023);
  a032=(a032+a064);
  a064=-2.;
  a009=(a064*a003);
  a028=(a019*a028);
  a028=(a009*a028);
  a048=(a064*a008);
  a048=(a048*a010);
  a048=(a048*a040);
  a028=(a028-a048);
  a048=(a028/a058);
  a009=(a009*a010);
  a009=(a009*a015);
  a028=(a075*a028);
  a009=(a009-a028);
  a009=(a009/a074);
  a028=(a075*a009);
  a048=(a048-a028);
  a028=(a048*a608);
  a040=(a035*a040);
  a003=(a003-a008);
  a040=(a040*a003);
  a058=(a040/a058);
  a040=(a075*a040);
  a040=(a040/a074);
  a075=(a075*a040);
  a058=(a058+a075);
  a075=arg[0]? arg[0][7] : 0;
  a074=(a058*a075);
  a028=(a028+a074);
  a032=(a032+a028);
  a028=(a006*a032);
  a177=(a177-a046);
  a177=(a177+a207);
  a177=(a177-a209);
  a190=(a190+a196);
  a190=(a190-a199);
  a190=(a190-a200);
  a190=(a190+a194);
  a190=(a190+a198);
  a190=(a186*a190);
  a177=(a177-a190);
  a190=(a182*a019);
  a194=(a194*a190);
  a177=(a177-a194);
  a190=(a190*a198);
  a177=(a177-a190);
  a204=(a204+a206);
  a204=(a204+a181);
  a206=(a204*a203);
  a177=(a177+a206);
  a206=(a211*a033);
  a206=(a206*a019);
  a206=(a206+a041);
  a206=(a206+a033);
  a206=(a206+a060);
  a212=(a212-a216);
  a212=(a212-a180);
  a212=(a212-a007);
  a212=(a212+a214);
  a212=(a212-a218);
  a212=(a212+a067);
  a212=(a212+a219);
  a212=(a212-a220);
  a212=(a212+a072);
  a212=(a212+a073);
  a212=(a035*a212);
  a206=(a206+a212);
  a212=(a177/a206);
  a214=(a220-a219);
  a218=(a180+a218);
  a214=(a214+a218);
  a216=(a214-a070);
  a216=(a216-a071);
  a216=(a010*a216);
  a216=(a216-a059);
  a190=(a216/a206);
  a177=(a190*a177);
  a210=(a210-a177);
  a216=(a216*a190);
  a216=(a076-a216);
  a210=(a210/a216);
  a177=(a190*a210);
  a212=(a212-a177);
  a177=(2.*a212);
  a198=(a177*a019);
  a194=(a007*a192);
  a189=(a189+a194);
  a194=(2.*a192);
  a189=(a189-a194);
  a194=(a007*a197);
  a193=(a193+a194);
  a189=(a189+a193);
  a189=(a010*a189);
  a199=(a199-a189);
  a198=(a198*a199);
  a199=(a210*a010);
  a199=(a199*a019);
  a199=(a199*a193);
  a198=(a198+a199);
  a199=(a208*a033);
  a198=(a198+a199);
  a199=(a014*a080);
  a199=(a199*a080);
  a189=(a199*a010);
  a189=(a189*a019);
  a189=(a189*a197);
  a198=(a198+a189);
  a189=(2.*a208);
  a208=(a208*a007);
  a189=(a189-a208);
  a205=(a014*a205);
  a189=(a189+a205);
  a187=(a187*a007);
  a178=(a014*a178);
  a205=(a187+a178);
  a189=(a189-a205);
  a189=(a010*a189);
  a198=(a198+a189);
  a189=(a014*a197);
  a189=(a189-a191);
  a208=(a019*a189);
  a208=(a208*a203);
  a198=(a198-a208);
  a188=(a188*a033);
  a215=(a215*a010);
  a188=(a188-a215);
  a211=(a211*a010);
  a188=(a188+a211);
  a211=(a191*a010);
  a188=(a188-a211);
  a192=(a056*a192);
  a188=(a188+a192);
  a197=(a056*a197);
  a188=(a188+a197);
  a188=(a186*a188);
  a198=(a198+a188);
  a220=(a220*a183);
  a198=(a198-a220);
  a220=(a198/a206);
  a183=(a212*a019);
  a183=(a183*a193);
  a183=(a183+a205);
  a183=(a010*a183);
  a198=(a190*a198);
  a183=(a183-a198);
  a183=(a183/a216);
  a198=(a190*a183);
  a220=(a220-a198);
  a198=(a079*a608);
  a193=(a082*a032);
  a093=(a093-a046);
  a093=(a093+a122);
  a093=(a093-a124);
  a105=(a105+a111);
  a105=(a105-a114);
  a105=(a105-a115);
  a105=(a105+a109);
  a105=(a105+a113);
  a105=(a101*a105);
  a093=(a093-a105);
  a105=(a098*a019);
  a109=(a109*a105);
  a093=(a093-a109);
  a105=(a105*a113);
  a093=(a093-a105);
  a119=(a119+a121);
  a119=(a119+a097);
  a121=(a119*a118);
  a093=(a093+a121);
  a121=(a126*a033);
  a121=(a121*a019);
  a121=(a121+a041);
  a121=(a121+a033);
  a121=(a121+a060);
  a127=(a127-a131);
  a127=(a127-a096);
  a127=(a127-a007);
  a127=(a127+a129);
  a127=(a127-a133);
  a127=(a127+a067);
  a127=(a127+a134);
  a127=(a127-a135);
  a127=(a127+a072);
  a127=(a127+a073);
  a127=(a035*a127);
  a121=(a121+a127);
  a127=(a093/a121);
  a129=(a135-a134);
  a133=(a096+a133);
  a129=(a129+a133);
  a131=(a129-a070);
  a131=(a131-a071);
  a131=(a010*a131);
  a131=(a131-a059);
  a105=(a131/a121);
  a093=(a105*a093);
  a125=(a125-a093);
  a131=(a131*a105);
  a131=(a076-a131);
  a125=(a125/a131);
  a093=(a105*a125);
  a127=(a127-a093);
  a093=(2.*a127);
  a113=(a093*a019);
  a109=(a007*a107);
  a104=(a104+a109);
  a109=(2.*a107);
  a104=(a104-a109);
  a109=(a007*a112);
  a108=(a108+a109);
  a104=(a104+a108);
  a104=(a010*a104);
  a114=(a114-a104);
  a113=(a113*a114);
  a114=(a125*a010);
  a114=(a114*a019);
  a114=(a114*a108);
  a113=(a113+a114);
  a114=(a123*a033);
  a113=(a113+a114);
  a114=(a014*a086);
  a114=(a114*a086);
  a104=(a114*a010);
  a104=(a104*a019);
  a104=(a104*a112);
  a113=(a113+a104);
  a104=(2.*a123);
  a123=(a123*a007);
  a104=(a104-a123);
  a120=(a014*a120);
  a104=(a104+a120);
  a102=(a102*a007);
  a094=(a014*a094);
  a120=(a102+a094);
  a104=(a104-a120);
  a104=(a010*a104);
  a113=(a113+a104);
  a104=(a014*a112);
  a104=(a104-a106);
  a123=(a019*a104);
  a123=(a123*a118);
  a113=(a113-a123);
  a103=(a103*a033);
  a130=(a130*a010);
  a103=(a103-a130);
  a126=(a126*a010);
  a103=(a103+a126);
  a126=(a106*a010);
  a103=(a103-a126);
  a107=(a056*a107);
  a103=(a103+a107);
  a112=(a056*a112);
  a103=(a103+a112);
  a103=(a101*a103);
  a113=(a113+a103);
  a135=(a135*a099);
  a113=(a113-a135);
  a135=(a113/a121);
  a099=(a127*a019);
  a099=(a099*a108);
  a099=(a099+a120);
  a099=(a010*a099);
  a113=(a105*a113);
  a099=(a099-a113);
  a099=(a099/a131);
  a113=(a105*a099);
  a135=(a135-a113);
  a113=(a085*a608);
  a113=(a037+a113);
  a108=(a135*a113);
  a093=(a093*a119);
  a125=(a125*a119);
  a093=(a093-a125);
  a093=(a093+a102);
  a106=(a106*a086);
  a106=(a106*a086);
  a106=(a106*a019);
  a093=(a093+a106);
  a096=(a096*a086);
  a096=(a096*a086);
  a093=(a093+a096);
  a114=(a114*a095);
  a093=(a093+a114);
  a093=(a093+a094);
  a117=(a117*a129);
  a093=(a093-a117);
  a098=(a098*a134);
  a093=(a093-a098);
  a101=(a101*a104);
  a093=(a093-a101);
  a093=(a010*a093);
  a121=(a093/a121);
  a100=(a100*a133);
  a127=(a127*a119);
  a100=(a100-a127);
  a100=(a100-a120);
  a100=(a010*a100);
  a093=(a105*a093);
  a100=(a100-a093);
  a100=(a100/a131);
  a105=(a105*a100);
  a121=(a121-a105);
  a105=(a085*a075);
  a105=(a023+a105);
  a131=(a121*a105);
  a108=(a108+a131);
  a131=(a064*a088);
  a110=(a019*a110);
  a110=(a131*a110);
  a093=(a064*a086);
  a093=(a093*a010);
  a093=(a093*a119);
  a110=(a110-a093);
  a093=(a110/a128);
  a131=(a131*a010);
  a131=(a131*a097);
  a110=(a137*a110);
  a131=(a131-a110);
  a131=(a131/a136);
  a110=(a137*a131);
  a093=(a093-a110);
  a110=(a085*a032);
  a110=(a608+a110);
  a097=(a093*a110);
  a119=(a035*a119);
  a088=(a088-a086);
  a119=(a119*a088);
  a128=(a119/a128);
  a119=(a137*a119);
  a119=(a119/a136);
  a137=(a137*a119);
  a128=(a128+a137);
  a137=(a017*a037);
  a136=(a018*a023);
  a137=(a137+a136);
  a136=(a009*a608);
  a088=(a040*a075);
  a136=(a136-a088);
  a137=(a137+a136);
  a136=(a085*a137);
  a136=(a075+a136);
  a088=(a128*a136);
  a097=(a097+a088);
  a108=(a108+a097);
  a108=(a084*a108);
  a193=(a193+a108);
  a193=(a608+a193);
  a108=(a081*a193);
  a198=(a198+a108);
  a198=(a037+a198);
  a108=(a220*a198);
  a177=(a177*a204);
  a210=(a210*a204);
  a177=(a177-a210);
  a177=(a177+a187);
  a191=(a191*a080);
  a191=(a191*a080);
  a191=(a191*a019);
  a177=(a177+a191);
  a180=(a180*a080);
  a180=(a180*a080);
  a177=(a177+a180);
  a199=(a199*a179);
  a177=(a177+a199);
  a177=(a177+a178);
  a202=(a202*a214);
  a177=(a177-a202);
  a182=(a182*a219);
  a177=(a177-a182);
  a186=(a186*a189);
  a177=(a177-a186);
  a177=(a010*a177);
  a206=(a177/a206);
  a185=(a185*a218);
  a212=(a212*a204);
  a185=(a185-a212);
  a185=(a185-a205);
  a185=(a010*a185);
  a177=(a190*a177);
  a185=(a185-a177);
  a185=(a185/a216);
  a190=(a190*a185);
  a206=(a206-a190);
  a190=(a079*a075);
  a216=(a082*a137);
  a113=(a099*a113);
  a105=(a100*a105);
  a113=(a113+a105);
  a105=(a131*a110);
  a177=(a119*a136);
  a105=(a105-a177);
  a113=(a113+a105);
  a113=(a084*a113);
  a216=(a216+a113);
  a216=(a075+a216);
  a113=(a081*a216);
  a190=(a190+a113);
  a190=(a023+a190);
  a113=(a206*a190);
  a108=(a108+a113);
  a113=(a064*a184);
  a195=(a019*a195);
  a195=(a113*a195);
  a105=(a064*a080);
  a105=(a105*a010);
  a105=(a105*a204);
  a195=(a195-a105);
  a105=(a195/a213);
  a113=(a113*a010);
  a113=(a113*a181);
  a195=(a222*a195);
  a113=(a113-a195);
  a113=(a113/a221);
  a195=(a222*a113);
  a105=(a105-a195);
  a195=(a079*a032);
  a116=(a116-a046);
  a116=(a116+a174);
  a116=(a116-a176);
  a161=(a161+a164);
  a161=(a161-a166);
  a161=(a161-a167);
  a161=(a161+a162);
  a161=(a161+a165);
  a161=(a139*a161);
  a116=(a116-a161);
  a161=(a158*a019);
  a162=(a162*a161);
  a116=(a116-a162);
  a161=(a161*a165);
  a116=(a116-a161);
  a171=(a171+a173);
  a171=(a171+a140);
  a173=(a171*a170);
  a116=(a116+a173);
  a173=(a150*a033);
  a173=(a173*a019);
  a173=(a173+a041);
  a173=(a173+a033);
  a173=(a173+a060);
  a151=(a151-a155);
  a151=(a151-a142);
  a151=(a151-a007);
  a151=(a151+a153);
  a151=(a151-a144);
  a151=(a151+a067);
  a151=(a151+a147);
  a151=(a151-a149);
  a151=(a151+a072);
  a151=(a151+a073);
  a151=(a035*a151);
  a173=(a173+a151);
  a151=(a116/a173);
  a153=(a149-a147);
  a144=(a142+a144);
  a153=(a153+a144);
  a155=(a153-a070);
  a155=(a155-a071);
  a155=(a010*a155);
  a155=(a155-a059);
  a161=(a155/a173);
  a116=(a161*a116);
  a141=(a141-a116);
  a155=(a155*a161);
  a155=(a076-a155);
  a141=(a141/a155);
  a116=(a161*a141);
  a151=(a151-a116);
  a116=(2.*a151);
  a165=(a116*a019);
  a162=(a007*a145);
  a160=(a160+a162);
  a162=(2.*a145);
  a160=(a160-a162);
  a162=(a007*a146);
  a138=(a138+a162);
  a160=(a160+a138);
  a160=(a010*a160);
  a166=(a166-a160);
  a165=(a165*a166);
  a166=(a141*a010);
  a166=(a166*a019);
  a166=(a166*a138);
  a165=(a165+a166);
  a166=(a175*a033);
  a165=(a165+a166);
  a166=(a014*a157);
  a166=(a166*a157);
  a160=(a166*a010);
  a160=(a160*a019);
  a160=(a160*a146);
  a165=(a165+a160);
  a160=(2.*a175);
  a175=(a175*a007);
  a160=(a160-a175);
  a172=(a014*a172);
  a160=(a160+a172);
  a090=(a090*a007);
  a089=(a014*a089);
  a172=(a090+a089);
  a160=(a160-a172);
  a160=(a010*a160);
  a165=(a165+a160);
  a160=(a014*a146);
  a160=(a160-a148);
  a175=(a019*a160);
  a175=(a175*a170);
  a165=(a165-a175);
  a087=(a087*a033);
  a154=(a154*a010);
  a087=(a087-a154);
  a150=(a150*a010);
  a087=(a087+a150);
  a150=(a148*a010);
  a087=(a087-a150);
  a145=(a056*a145);
  a087=(a087+a145);
  a146=(a056*a146);
  a087=(a087+a146);
  a087=(a139*a087);
  a165=(a165+a087);
  a149=(a149*a159);
  a165=(a165-a149);
  a149=(a165/a173);
  a159=(a151*a019);
  a159=(a159*a138);
  a159=(a159+a172);
  a159=(a010*a159);
  a165=(a161*a165);
  a159=(a159-a165);
  a159=(a159/a155);
  a165=(a161*a159);
  a149=(a149-a165);
  a165=(a082*a608);
  a110=(a084*a110);
  a165=(a165+a110);
  a165=(a037+a165);
  a110=(a149*a165);
  a116=(a116*a171);
  a141=(a141*a171);
  a116=(a116-a141);
  a116=(a116+a090);
  a148=(a148*a157);
  a148=(a148*a157);
  a148=(a148*a019);
  a116=(a116+a148);
  a142=(a142*a157);
  a142=(a142*a157);
  a116=(a116+a142);
  a166=(a166*a083);
  a116=(a116+a166);
  a116=(a116+a089);
  a169=(a169*a153);
  a116=(a116-a169);
  a158=(a158*a147);
  a116=(a116-a158);
  a139=(a139*a160);
  a116=(a116-a139);
  a116=(a010*a116);
  a173=(a116/a173);
  a132=(a132*a144);
  a151=(a151*a171);
  a132=(a132-a151);
  a132=(a132-a172);
  a132=(a010*a132);
  a116=(a161*a116);
  a132=(a132-a116);
  a132=(a132/a155);
  a161=(a161*a132);
  a173=(a173-a161);
  a161=(a082*a075);
  a136=(a084*a136);
  a161=(a161+a136);
  a161=(a023+a161);
  a136=(a173*a161);
  a110=(a110+a136);
  a136=(a064*a092);
  a163=(a019*a163);
  a163=(a136*a163);
  a155=(a064*a157);
  a155=(a155*a010);
  a155=(a155*a171);
  a163=(a163-a155);
  a155=(a163/a152);
  a136=(a136*a010);
  a136=(a136*a140);
  a163=(a156*a163);
  a136=(a136-a163);
  a136=(a136/a143);
  a163=(a156*a136);
  a155=(a155-a163);
  a163=(a155*a193);
  a171=(a035*a171);
  a092=(a092-a157);
  a171=(a171*a092);
  a152=(a171/a152);
  a171=(a156*a171);
  a171=(a171/a143);
  a156=(a156*a171);
  a152=(a152+a156);
  a156=(a152*a216);
  a163=(a163+a156);
  a110=(a110+a163);
  a163=(a081*a110);
  a195=(a195+a163);
  a195=(a608+a195);
  a163=(a105*a195);
  a204=(a035*a204);
  a184=(a184-a080);
  a204=(a204*a184);
  a213=(a204/a213);
  a204=(a222*a204);
  a204=(a204/a221);
  a222=(a222*a204);
  a213=(a213+a222);
  a222=(a079*a137);
  a165=(a159*a165);
  a161=(a132*a161);
  a165=(a165+a161);
  a161=(a136*a193);
  a221=(a171*a216);
  a161=(a161-a221);
  a165=(a165+a161);
  a161=(a081*a165);
  a222=(a222+a161);
  a222=(a075+a222);
  a161=(a213*a222);
  a163=(a163+a161);
  a108=(a108+a163);
  a163=(a078*a108);
  a028=(a028+a163);
  a227=(a227-a046);
  a227=(a227+a256);
  a227=(a227-a258);
  a239=(a239+a245);
  a239=(a239-a248);
  a239=(a239-a249);
  a239=(a239+a243);
  a239=(a239+a247);
  a239=(a235*a239);
  a227=(a227-a239);
  a239=(a232*a019);
  a243=(a243*a239);
  a227=(a227-a243);
  a239=(a239*a247);
  a227=(a227-a239);
  a253=(a253+a255);
  a253=(a253+a231);
  a255=(a253*a252);
  a227=(a227+a255);
  a255=(a260*a033);
  a255=(a255*a019);
  a255=(a255+a041);
  a255=(a255+a033);
  a255=(a255+a060);
  a261=(a261-a265);
  a261=(a261-a230);
  a261=(a261-a007);
  a261=(a261+a263);
  a261=(a261-a267);
  a261=(a261+a067);
  a261=(a261+a268);
  a261=(a261-a269);
  a261=(a261+a072);
  a261=(a261+a073);
  a261=(a035*a261);
  a255=(a255+a261);
  a261=(a227/a255);
  a263=(a269-a268);
  a267=(a230+a267);
  a263=(a263+a267);
  a265=(a263-a070);
  a265=(a265-a071);
  a265=(a010*a265);
  a265=(a265-a059);
  a239=(a265/a255);
  a227=(a239*a227);
  a259=(a259-a227);
  a265=(a265*a239);
  a265=(a076-a265);
  a259=(a259/a265);
  a227=(a239*a259);
  a261=(a261-a227);
  a227=(2.*a261);
  a247=(a227*a019);
  a243=(a007*a241);
  a238=(a238+a243);
  a243=(2.*a241);
  a238=(a238-a243);
  a243=(a007*a246);
  a242=(a242+a243);
  a238=(a238+a242);
  a238=(a010*a238);
  a248=(a248-a238);
  a247=(a247*a248);
  a248=(a259*a010);
  a248=(a248*a019);
  a248=(a248*a242);
  a247=(a247+a248);
  a248=(a257*a033);
  a247=(a247+a248);
  a248=(a014*a225);
  a248=(a248*a225);
  a238=(a248*a010);
  a238=(a238*a019);
  a238=(a238*a246);
  a247=(a247+a238);
  a238=(2.*a257);
  a257=(a257*a007);
  a238=(a238-a257);
  a254=(a014*a254);
  a238=(a238+a254);
  a236=(a236*a007);
  a228=(a014*a228);
  a254=(a236+a228);
  a238=(a238-a254);
  a238=(a010*a238);
  a247=(a247+a238);
  a238=(a014*a246);
  a238=(a238-a240);
  a257=(a019*a238);
  a257=(a257*a252);
  a247=(a247-a257);
  a237=(a237*a033);
  a264=(a264*a010);
  a237=(a237-a264);
  a260=(a260*a010);
  a237=(a237+a260);
  a260=(a240*a010);
  a237=(a237-a260);
  a241=(a056*a241);
  a237=(a237+a241);
  a246=(a056*a246);
  a237=(a237+a246);
  a237=(a235*a237);
  a247=(a247+a237);
  a269=(a269*a233);
  a247=(a247-a269);
  a269=(a247/a255);
  a233=(a261*a019);
  a233=(a233*a242);
  a233=(a233+a254);
  a233=(a010*a233);
  a247=(a239*a247);
  a233=(a233-a247);
  a233=(a233/a265);
  a247=(a239*a233);
  a269=(a269-a247);
  a247=(a224*a608);
  a193=(a226*a193);
  a247=(a247+a193);
  a193=(a091*a195);
  a247=(a247+a193);
  a247=(a037+a247);
  a193=(a269*a247);
  a227=(a227*a253);
  a259=(a259*a253);
  a227=(a227-a259);
  a227=(a227+a236);
  a240=(a240*a225);
  a240=(a240*a225);
  a240=(a240*a019);
  a227=(a227+a240);
  a230=(a230*a225);
  a230=(a230*a225);
  a227=(a227+a230);
  a248=(a248*a229);
  a227=(a227+a248);
  a227=(a227+a228);
  a251=(a251*a263);
  a227=(a227-a251);
  a232=(a232*a268);
  a227=(a227-a232);
  a235=(a235*a238);
  a227=(a227-a235);
  a227=(a010*a227);
  a255=(a227/a255);
  a168=(a168*a267);
  a261=(a261*a253);
  a168=(a168-a261);
  a168=(a168-a254);
  a168=(a010*a168);
  a227=(a239*a227);
  a168=(a168-a227);
  a168=(a168/a265);
  a239=(a239*a168);
  a255=(a255-a239);
  a239=(a224*a075);
  a216=(a226*a216);
  a239=(a239+a216);
  a216=(a091*a222);
  a239=(a239+a216);
  a239=(a023+a239);
  a216=(a255*a239);
  a193=(a193+a216);
  a216=(a064*a234);
  a244=(a019*a244);
  a244=(a216*a244);
  a265=(a064*a225);
  a265=(a265*a010);
  a265=(a265*a253);
  a244=(a244-a265);
  a265=(a244/a262);
  a216=(a216*a010);
  a216=(a216*a231);
  a244=(a271*a244);
  a216=(a216-a244);
  a216=(a216/a270);
  a244=(a271*a216);
  a265=(a265-a244);
  a244=(a224*a032);
  a110=(a226*a110);
  a244=(a244+a110);
  a110=(a091*a108);
  a244=(a244+a110);
  a244=(a608+a244);
  a110=(a265*a244);
  a253=(a035*a253);
  a234=(a234-a225);
  a253=(a253*a234);
  a262=(a253/a262);
  a253=(a271*a253);
  a253=(a253/a270);
  a271=(a271*a253);
  a262=(a262+a271);
  a271=(a224*a137);
  a165=(a226*a165);
  a271=(a271+a165);
  a198=(a183*a198);
  a190=(a185*a190);
  a198=(a198+a190);
  a190=(a113*a195);
  a165=(a204*a222);
  a190=(a190-a165);
  a198=(a198+a190);
  a190=(a091*a198);
  a271=(a271+a190);
  a271=(a075+a271);
  a190=(a262*a271);
  a110=(a110+a190);
  a193=(a193+a110);
  a110=(a223*a193);
  a028=(a028+a110);
  a028=(a608+a028);
  a110=(a005*a028);
  a574=(a574+a110);
  a110=(a273*a032);
  a190=(a275*a108);
  a110=(a110+a190);
  a190=(a276*a193);
  a110=(a110+a190);
  a279=(a279-a046);
  a279=(a279+a308);
  a279=(a279-a310);
  a291=(a291+a297);
  a291=(a291-a300);
  a291=(a291-a301);
  a291=(a291+a295);
  a291=(a291+a299);
  a291=(a287*a291);
  a279=(a279-a291);
  a291=(a284*a019);
  a295=(a295*a291);
  a279=(a279-a295);
  a291=(a291*a299);
  a279=(a279-a291);
  a305=(a305+a307);
  a305=(a305+a283);
  a307=(a305*a304);
  a279=(a279+a307);
  a307=(a312*a033);
  a307=(a307*a019);
  a307=(a307+a041);
  a307=(a307+a033);
  a307=(a307+a060);
  a313=(a313-a317);
  a313=(a313-a282);
  a313=(a313-a007);
  a313=(a313+a315);
  a313=(a313-a319);
  a313=(a313+a067);
  a313=(a313+a320);
  a313=(a313-a321);
  a313=(a313+a072);
  a313=(a313+a073);
  a313=(a035*a313);
  a307=(a307+a313);
  a313=(a279/a307);
  a315=(a321-a320);
  a319=(a282+a319);
  a315=(a315+a319);
  a317=(a315-a070);
  a317=(a317-a071);
  a317=(a010*a317);
  a317=(a317-a059);
  a291=(a317/a307);
  a279=(a291*a279);
  a311=(a311-a279);
  a317=(a317*a291);
  a317=(a076-a317);
  a311=(a311/a317);
  a279=(a291*a311);
  a313=(a313-a279);
  a279=(2.*a313);
  a299=(a279*a019);
  a295=(a007*a293);
  a290=(a290+a295);
  a295=(2.*a293);
  a290=(a290-a295);
  a295=(a007*a298);
  a294=(a294+a295);
  a290=(a290+a294);
  a290=(a010*a290);
  a300=(a300-a290);
  a299=(a299*a300);
  a300=(a311*a010);
  a300=(a300*a019);
  a300=(a300*a294);
  a299=(a299+a300);
  a300=(a309*a033);
  a299=(a299+a300);
  a300=(a014*a278);
  a300=(a300*a278);
  a290=(a300*a010);
  a290=(a290*a019);
  a290=(a290*a298);
  a299=(a299+a290);
  a290=(2.*a309);
  a309=(a309*a007);
  a290=(a290-a309);
  a306=(a014*a306);
  a290=(a290+a306);
  a288=(a288*a007);
  a280=(a014*a280);
  a306=(a288+a280);
  a290=(a290-a306);
  a290=(a010*a290);
  a299=(a299+a290);
  a290=(a014*a298);
  a290=(a290-a292);
  a309=(a019*a290);
  a309=(a309*a304);
  a299=(a299-a309);
  a289=(a289*a033);
  a316=(a316*a010);
  a289=(a289-a316);
  a312=(a312*a010);
  a289=(a289+a312);
  a312=(a292*a010);
  a289=(a289-a312);
  a293=(a056*a293);
  a289=(a289+a293);
  a298=(a056*a298);
  a289=(a289+a298);
  a289=(a287*a289);
  a299=(a299+a289);
  a321=(a321*a285);
  a299=(a299-a321);
  a321=(a299/a307);
  a285=(a313*a019);
  a285=(a285*a294);
  a285=(a285+a306);
  a285=(a010*a285);
  a299=(a291*a299);
  a285=(a285-a299);
  a285=(a285/a317);
  a299=(a291*a285);
  a321=(a321-a299);
  a299=(a006*a608);
  a294=(a078*a195);
  a299=(a299+a294);
  a294=(a223*a244);
  a299=(a299+a294);
  a299=(a037+a299);
  a294=(a321*a299);
  a279=(a279*a305);
  a311=(a311*a305);
  a279=(a279-a311);
  a279=(a279+a288);
  a292=(a292*a278);
  a292=(a292*a278);
  a292=(a292*a019);
  a279=(a279+a292);
  a282=(a282*a278);
  a282=(a282*a278);
  a279=(a279+a282);
  a300=(a300*a281);
  a279=(a279+a300);
  a279=(a279+a280);
  a303=(a303*a315);
  a279=(a279-a303);
  a284=(a284*a320);
  a279=(a279-a284);
  a287=(a287*a290);
  a279=(a279-a287);
  a279=(a010*a279);
  a307=(a279/a307);
  a286=(a286*a319);
  a313=(a313*a305);
  a286=(a286-a313);
  a286=(a286-a306);
  a286=(a010*a286);
  a279=(a291*a279);
  a286=(a286-a279);
  a286=(a286/a317);
  a291=(a291*a286);
  a307=(a307-a291);
  a291=(a006*a075);
  a317=(a078*a222);
  a291=(a291+a317);
  a317=(a223*a271);
  a291=(a291+a317);
  a291=(a023+a291);
  a317=(a307*a291);
  a294=(a294+a317);
  a317=(a064*a077);
  a296=(a019*a296);
  a296=(a317*a296);
  a279=(a064*a278);
  a279=(a279*a010);
  a279=(a279*a305);
  a296=(a296-a279);
  a279=(a296/a314);
  a317=(a317*a010);
  a317=(a317*a283);
  a296=(a323*a296);
  a317=(a317-a296);
  a317=(a317/a322);
  a296=(a323*a317);
  a279=(a279-a296);
  a296=(a279*a028);
  a305=(a035*a305);
  a077=(a077-a278);
  a305=(a305*a077);
  a314=(a305/a314);
  a305=(a323*a305);
  a305=(a305/a322);
  a323=(a323*a305);
  a314=(a314+a323);
  a323=(a006*a137);
  a322=(a078*a198);
  a323=(a323+a322);
  a247=(a233*a247);
  a239=(a168*a239);
  a247=(a247+a239);
  a239=(a216*a244);
  a322=(a253*a271);
  a239=(a239-a322);
  a247=(a247+a239);
  a239=(a223*a247);
  a323=(a323+a239);
  a323=(a075+a323);
  a239=(a314*a323);
  a296=(a296+a239);
  a294=(a294+a296);
  a296=(a277*a294);
  a110=(a110+a296);
  a110=(a608+a110);
  a296=(a272*a110);
  a574=(a574+a296);
  a296=(a325*a032);
  a239=(a327*a108);
  a296=(a296+a239);
  a239=(a328*a193);
  a296=(a296+a239);
  a239=(a329*a294);
  a296=(a296+a239);
  a332=(a332-a046);
  a332=(a332+a361);
  a332=(a332-a363);
  a344=(a344+a350);
  a344=(a344-a353);
  a344=(a344-a354);
  a344=(a344+a348);
  a344=(a344+a352);
  a344=(a340*a344);
  a332=(a332-a344);
  a344=(a337*a019);
  a348=(a348*a344);
  a332=(a332-a348);
  a344=(a344*a352);
  a332=(a332-a344);
  a358=(a358+a360);
  a358=(a358+a336);
  a360=(a358*a357);
  a332=(a332+a360);
  a360=(a365*a033);
  a360=(a360*a019);
  a360=(a360+a041);
  a360=(a360+a033);
  a360=(a360+a060);
  a366=(a366-a370);
  a366=(a366-a335);
  a366=(a366-a007);
  a366=(a366+a368);
  a366=(a366-a372);
  a366=(a366+a067);
  a366=(a366+a373);
  a366=(a366-a374);
  a366=(a366+a072);
  a366=(a366+a073);
  a366=(a035*a366);
  a360=(a360+a366);
  a366=(a332/a360);
  a368=(a374-a373);
  a372=(a335+a372);
  a368=(a368+a372);
  a370=(a368-a070);
  a370=(a370-a071);
  a370=(a010*a370);
  a370=(a370-a059);
  a344=(a370/a360);
  a332=(a344*a332);
  a364=(a364-a332);
  a370=(a370*a344);
  a370=(a076-a370);
  a364=(a364/a370);
  a332=(a344*a364);
  a366=(a366-a332);
  a332=(2.*a366);
  a352=(a332*a019);
  a348=(a007*a346);
  a343=(a343+a348);
  a348=(2.*a346);
  a343=(a343-a348);
  a348=(a007*a351);
  a347=(a347+a348);
  a343=(a343+a347);
  a343=(a010*a343);
  a353=(a353-a343);
  a352=(a352*a353);
  a353=(a364*a010);
  a353=(a353*a019);
  a353=(a353*a347);
  a352=(a352+a353);
  a353=(a362*a033);
  a352=(a352+a353);
  a353=(a014*a331);
  a353=(a353*a331);
  a343=(a353*a010);
  a343=(a343*a019);
  a343=(a343*a351);
  a352=(a352+a343);
  a343=(2.*a362);
  a362=(a362*a007);
  a343=(a343-a362);
  a359=(a014*a359);
  a343=(a343+a359);
  a341=(a341*a007);
  a333=(a014*a333);
  a359=(a341+a333);
  a343=(a343-a359);
  a343=(a010*a343);
  a352=(a352+a343);
  a343=(a014*a351);
  a343=(a343-a345);
  a362=(a019*a343);
  a362=(a362*a357);
  a352=(a352-a362);
  a342=(a342*a033);
  a369=(a369*a010);
  a342=(a342-a369);
  a365=(a365*a010);
  a342=(a342+a365);
  a365=(a345*a010);
  a342=(a342-a365);
  a346=(a056*a346);
  a342=(a342+a346);
  a351=(a056*a351);
  a342=(a342+a351);
  a342=(a340*a342);
  a352=(a352+a342);
  a374=(a374*a338);
  a352=(a352-a374);
  a374=(a352/a360);
  a338=(a366*a019);
  a338=(a338*a347);
  a338=(a338+a359);
  a338=(a010*a338);
  a352=(a344*a352);
  a338=(a338-a352);
  a338=(a338/a370);
  a352=(a344*a338);
  a374=(a374-a352);
  a352=(a273*a608);
  a347=(a275*a195);
  a352=(a352+a347);
  a347=(a276*a244);
  a352=(a352+a347);
  a347=(a277*a028);
  a352=(a352+a347);
  a352=(a037+a352);
  a347=(a374*a352);
  a332=(a332*a358);
  a364=(a364*a358);
  a332=(a332-a364);
  a332=(a332+a341);
  a345=(a345*a331);
  a345=(a345*a331);
  a345=(a345*a019);
  a332=(a332+a345);
  a335=(a335*a331);
  a335=(a335*a331);
  a332=(a332+a335);
  a353=(a353*a334);
  a332=(a332+a353);
  a332=(a332+a333);
  a356=(a356*a368);
  a332=(a332-a356);
  a337=(a337*a373);
  a332=(a332-a337);
  a340=(a340*a343);
  a332=(a332-a340);
  a332=(a010*a332);
  a360=(a332/a360);
  a339=(a339*a372);
  a366=(a366*a358);
  a339=(a339-a366);
  a339=(a339-a359);
  a339=(a010*a339);
  a332=(a344*a332);
  a339=(a339-a332);
  a339=(a339/a370);
  a344=(a344*a339);
  a360=(a360-a344);
  a344=(a273*a075);
  a370=(a275*a222);
  a344=(a344+a370);
  a370=(a276*a271);
  a344=(a344+a370);
  a370=(a277*a323);
  a344=(a344+a370);
  a344=(a023+a344);
  a370=(a360*a344);
  a347=(a347+a370);
  a370=(a064*a274);
  a349=(a019*a349);
  a349=(a370*a349);
  a332=(a064*a331);
  a332=(a332*a010);
  a332=(a332*a358);
  a349=(a349-a332);
  a332=(a349/a367);
  a370=(a370*a010);
  a370=(a370*a336);
  a349=(a376*a349);
  a370=(a370-a349);
  a370=(a370/a375);
  a349=(a376*a370);
  a332=(a332-a349);
  a349=(a332*a110);
  a358=(a035*a358);
  a274=(a274-a331);
  a358=(a358*a274);
  a367=(a358/a367);
  a358=(a376*a358);
  a358=(a358/a375);
  a376=(a376*a358);
  a367=(a367+a376);
  a376=(a273*a137);
  a375=(a275*a198);
  a376=(a376+a375);
  a375=(a276*a247);
  a376=(a376+a375);
  a299=(a285*a299);
  a291=(a286*a291);
  a299=(a299+a291);
  a291=(a317*a028);
  a375=(a305*a323);
  a291=(a291-a375);
  a299=(a299+a291);
  a291=(a277*a299);
  a376=(a376+a291);
  a376=(a075+a376);
  a291=(a367*a376);
  a349=(a349+a291);
  a347=(a347+a349);
  a349=(a330*a347);
  a296=(a296+a349);
  a296=(a608+a296);
  a349=(a324*a296);
  a574=(a574+a349);
  a349=(a378*a032);
  a291=(a380*a108);
  a349=(a349+a291);
  a291=(a381*a193);
  a349=(a349+a291);
  a291=(a382*a294);
  a349=(a349+a291);
  a291=(a383*a347);
  a349=(a349+a291);
  a386=(a386-a046);
  a386=(a386+a415);
  a386=(a386-a417);
  a398=(a398+a404);
  a398=(a398-a407);
  a398=(a398-a408);
  a398=(a398+a402);
  a398=(a398+a406);
  a398=(a394*a398);
  a386=(a386-a398);
  a398=(a391*a019);
  a402=(a402*a398);
  a386=(a386-a402);
  a398=(a398*a406);
  a386=(a386-a398);
  a412=(a412+a414);
  a412=(a412+a390);
  a414=(a412*a411);
  a386=(a386+a414);
  a414=(a419*a033);
  a414=(a414*a019);
  a414=(a414+a041);
  a414=(a414+a033);
  a414=(a414+a060);
  a420=(a420-a424);
  a420=(a420-a389);
  a420=(a420-a007);
  a420=(a420+a422);
  a420=(a420-a426);
  a420=(a420+a067);
  a420=(a420+a427);
  a420=(a420-a428);
  a420=(a420+a072);
  a420=(a420+a073);
  a420=(a035*a420);
  a414=(a414+a420);
  a420=(a386/a414);
  a422=(a428-a427);
  a426=(a389+a426);
  a422=(a422+a426);
  a424=(a422-a070);
  a424=(a424-a071);
  a424=(a010*a424);
  a424=(a424-a059);
  a398=(a424/a414);
  a386=(a398*a386);
  a418=(a418-a386);
  a424=(a424*a398);
  a424=(a076-a424);
  a418=(a418/a424);
  a386=(a398*a418);
  a420=(a420-a386);
  a386=(2.*a420);
  a406=(a386*a019);
  a402=(a007*a400);
  a397=(a397+a402);
  a402=(2.*a400);
  a397=(a397-a402);
  a402=(a007*a405);
  a401=(a401+a402);
  a397=(a397+a401);
  a397=(a010*a397);
  a407=(a407-a397);
  a406=(a406*a407);
  a407=(a418*a010);
  a407=(a407*a019);
  a407=(a407*a401);
  a406=(a406+a407);
  a407=(a416*a033);
  a406=(a406+a407);
  a407=(a014*a385);
  a407=(a407*a385);
  a397=(a407*a010);
  a397=(a397*a019);
  a397=(a397*a405);
  a406=(a406+a397);
  a397=(2.*a416);
  a416=(a416*a007);
  a397=(a397-a416);
  a413=(a014*a413);
  a397=(a397+a413);
  a395=(a395*a007);
  a387=(a014*a387);
  a413=(a395+a387);
  a397=(a397-a413);
  a397=(a010*a397);
  a406=(a406+a397);
  a397=(a014*a405);
  a397=(a397-a399);
  a416=(a019*a397);
  a416=(a416*a411);
  a406=(a406-a416);
  a396=(a396*a033);
  a423=(a423*a010);
  a396=(a396-a423);
  a419=(a419*a010);
  a396=(a396+a419);
  a419=(a399*a010);
  a396=(a396-a419);
  a400=(a056*a400);
  a396=(a396+a400);
  a405=(a056*a405);
  a396=(a396+a405);
  a396=(a394*a396);
  a406=(a406+a396);
  a428=(a428*a392);
  a406=(a406-a428);
  a428=(a406/a414);
  a392=(a420*a019);
  a392=(a392*a401);
  a392=(a392+a413);
  a392=(a010*a392);
  a406=(a398*a406);
  a392=(a392-a406);
  a392=(a392/a424);
  a406=(a398*a392);
  a428=(a428-a406);
  a406=(a325*a608);
  a401=(a327*a195);
  a406=(a406+a401);
  a401=(a328*a244);
  a406=(a406+a401);
  a401=(a329*a028);
  a406=(a406+a401);
  a401=(a330*a110);
  a406=(a406+a401);
  a406=(a037+a406);
  a401=(a428*a406);
  a386=(a386*a412);
  a418=(a418*a412);
  a386=(a386-a418);
  a386=(a386+a395);
  a399=(a399*a385);
  a399=(a399*a385);
  a399=(a399*a019);
  a386=(a386+a399);
  a389=(a389*a385);
  a389=(a389*a385);
  a386=(a386+a389);
  a407=(a407*a388);
  a386=(a386+a407);
  a386=(a386+a387);
  a410=(a410*a422);
  a386=(a386-a410);
  a391=(a391*a427);
  a386=(a386-a391);
  a394=(a394*a397);
  a386=(a386-a394);
  a386=(a010*a386);
  a414=(a386/a414);
  a393=(a393*a426);
  a420=(a420*a412);
  a393=(a393-a420);
  a393=(a393-a413);
  a393=(a010*a393);
  a386=(a398*a386);
  a393=(a393-a386);
  a393=(a393/a424);
  a398=(a398*a393);
  a414=(a414-a398);
  a398=(a325*a075);
  a424=(a327*a222);
  a398=(a398+a424);
  a424=(a328*a271);
  a398=(a398+a424);
  a424=(a329*a323);
  a398=(a398+a424);
  a424=(a330*a376);
  a398=(a398+a424);
  a398=(a023+a398);
  a424=(a414*a398);
  a401=(a401+a424);
  a424=(a064*a326);
  a403=(a019*a403);
  a403=(a424*a403);
  a386=(a064*a385);
  a386=(a386*a010);
  a386=(a386*a412);
  a403=(a403-a386);
  a386=(a403/a421);
  a424=(a424*a010);
  a424=(a424*a390);
  a403=(a430*a403);
  a424=(a424-a403);
  a424=(a424/a429);
  a403=(a430*a424);
  a386=(a386-a403);
  a403=(a386*a296);
  a412=(a035*a412);
  a326=(a326-a385);
  a412=(a412*a326);
  a421=(a412/a421);
  a412=(a430*a412);
  a412=(a412/a429);
  a430=(a430*a412);
  a421=(a421+a430);
  a430=(a325*a137);
  a429=(a327*a198);
  a430=(a430+a429);
  a429=(a328*a247);
  a430=(a430+a429);
  a429=(a329*a299);
  a430=(a430+a429);
  a352=(a338*a352);
  a344=(a339*a344);
  a352=(a352+a344);
  a344=(a370*a110);
  a429=(a358*a376);
  a344=(a344-a429);
  a352=(a352+a344);
  a344=(a330*a352);
  a430=(a430+a344);
  a430=(a075+a430);
  a344=(a421*a430);
  a403=(a403+a344);
  a401=(a401+a403);
  a403=(a384*a401);
  a349=(a349+a403);
  a349=(a608+a349);
  a403=(a377*a349);
  a574=(a574+a403);
  a403=(a432*a032);
  a344=(a434*a108);
  a403=(a403+a344);
  a344=(a435*a193);
  a403=(a403+a344);
  a344=(a436*a294);
  a403=(a403+a344);
  a344=(a437*a347);
  a403=(a403+a344);
  a344=(a438*a401);
  a403=(a403+a344);
  a441=(a441-a046);
  a441=(a441+a470);
  a441=(a441-a472);
  a453=(a453+a459);
  a453=(a453-a462);
  a453=(a453-a463);
  a453=(a453+a457);
  a453=(a453+a461);
  a453=(a449*a453);
  a441=(a441-a453);
  a453=(a446*a019);
  a457=(a457*a453);
  a441=(a441-a457);
  a453=(a453*a461);
  a441=(a441-a453);
  a467=(a467+a469);
  a467=(a467+a445);
  a469=(a467*a466);
  a441=(a441+a469);
  a469=(a474*a033);
  a469=(a469*a019);
  a469=(a469+a041);
  a469=(a469+a033);
  a469=(a469+a060);
  a475=(a475-a479);
  a475=(a475-a444);
  a475=(a475-a007);
  a475=(a475+a477);
  a475=(a475-a481);
  a475=(a475+a067);
  a475=(a475+a482);
  a475=(a475-a483);
  a475=(a475+a072);
  a475=(a475+a073);
  a475=(a035*a475);
  a469=(a469+a475);
  a475=(a441/a469);
  a477=(a483-a482);
  a481=(a444+a481);
  a477=(a477+a481);
  a479=(a477-a070);
  a479=(a479-a071);
  a479=(a010*a479);
  a479=(a479-a059);
  a453=(a479/a469);
  a441=(a453*a441);
  a473=(a473-a441);
  a479=(a479*a453);
  a479=(a076-a479);
  a473=(a473/a479);
  a441=(a453*a473);
  a475=(a475-a441);
  a441=(2.*a475);
  a461=(a441*a019);
  a457=(a007*a455);
  a452=(a452+a457);
  a457=(2.*a455);
  a452=(a452-a457);
  a457=(a007*a460);
  a456=(a456+a457);
  a452=(a452+a456);
  a452=(a010*a452);
  a462=(a462-a452);
  a461=(a461*a462);
  a462=(a473*a010);
  a462=(a462*a019);
  a462=(a462*a456);
  a461=(a461+a462);
  a462=(a471*a033);
  a461=(a461+a462);
  a462=(a014*a440);
  a462=(a462*a440);
  a452=(a462*a010);
  a452=(a452*a019);
  a452=(a452*a460);
  a461=(a461+a452);
  a452=(2.*a471);
  a471=(a471*a007);
  a452=(a452-a471);
  a468=(a014*a468);
  a452=(a452+a468);
  a450=(a450*a007);
  a442=(a014*a442);
  a468=(a450+a442);
  a452=(a452-a468);
  a452=(a010*a452);
  a461=(a461+a452);
  a452=(a014*a460);
  a452=(a452-a454);
  a471=(a019*a452);
  a471=(a471*a466);
  a461=(a461-a471);
  a451=(a451*a033);
  a478=(a478*a010);
  a451=(a451-a478);
  a474=(a474*a010);
  a451=(a451+a474);
  a474=(a454*a010);
  a451=(a451-a474);
  a455=(a056*a455);
  a451=(a451+a455);
  a460=(a056*a460);
  a451=(a451+a460);
  a451=(a449*a451);
  a461=(a461+a451);
  a483=(a483*a447);
  a461=(a461-a483);
  a483=(a461/a469);
  a447=(a475*a019);
  a447=(a447*a456);
  a447=(a447+a468);
  a447=(a010*a447);
  a461=(a453*a461);
  a447=(a447-a461);
  a447=(a447/a479);
  a461=(a453*a447);
  a483=(a483-a461);
  a461=(a378*a608);
  a456=(a380*a195);
  a461=(a461+a456);
  a456=(a381*a244);
  a461=(a461+a456);
  a456=(a382*a028);
  a461=(a461+a456);
  a456=(a383*a110);
  a461=(a461+a456);
  a456=(a384*a296);
  a461=(a461+a456);
  a461=(a037+a461);
  a456=(a483*a461);
  a441=(a441*a467);
  a473=(a473*a467);
  a441=(a441-a473);
  a441=(a441+a450);
  a454=(a454*a440);
  a454=(a454*a440);
  a454=(a454*a019);
  a441=(a441+a454);
  a444=(a444*a440);
  a444=(a444*a440);
  a441=(a441+a444);
  a462=(a462*a443);
  a441=(a441+a462);
  a441=(a441+a442);
  a465=(a465*a477);
  a441=(a441-a465);
  a446=(a446*a482);
  a441=(a441-a446);
  a449=(a449*a452);
  a441=(a441-a449);
  a441=(a010*a441);
  a469=(a441/a469);
  a448=(a448*a481);
  a475=(a475*a467);
  a448=(a448-a475);
  a448=(a448-a468);
  a448=(a010*a448);
  a441=(a453*a441);
  a448=(a448-a441);
  a448=(a448/a479);
  a453=(a453*a448);
  a469=(a469-a453);
  a453=(a378*a075);
  a479=(a380*a222);
  a453=(a453+a479);
  a479=(a381*a271);
  a453=(a453+a479);
  a479=(a382*a323);
  a453=(a453+a479);
  a479=(a383*a376);
  a453=(a453+a479);
  a479=(a384*a430);
  a453=(a453+a479);
  a453=(a023+a453);
  a479=(a469*a453);
  a456=(a456+a479);
  a479=(a064*a379);
  a458=(a019*a458);
  a458=(a479*a458);
  a441=(a064*a440);
  a441=(a441*a010);
  a441=(a441*a467);
  a458=(a458-a441);
  a441=(a458/a476);
  a479=(a479*a010);
  a479=(a479*a445);
  a458=(a485*a458);
  a479=(a479-a458);
  a479=(a479/a484);
  a458=(a485*a479);
  a441=(a441-a458);
  a458=(a441*a349);
  a467=(a035*a467);
  a379=(a379-a440);
  a467=(a467*a379);
  a476=(a467/a476);
  a467=(a485*a467);
  a467=(a467/a484);
  a485=(a485*a467);
  a476=(a476+a485);
  a485=(a378*a137);
  a484=(a380*a198);
  a485=(a485+a484);
  a484=(a381*a247);
  a485=(a485+a484);
  a484=(a382*a299);
  a485=(a485+a484);
  a484=(a383*a352);
  a485=(a485+a484);
  a406=(a392*a406);
  a398=(a393*a398);
  a406=(a406+a398);
  a398=(a424*a296);
  a484=(a412*a430);
  a398=(a398-a484);
  a406=(a406+a398);
  a398=(a384*a406);
  a485=(a485+a398);
  a485=(a075+a485);
  a398=(a476*a485);
  a458=(a458+a398);
  a456=(a456+a458);
  a458=(a439*a456);
  a403=(a403+a458);
  a403=(a608+a403);
  a458=(a431*a403);
  a574=(a574+a458);
  a458=(a487*a032);
  a398=(a489*a108);
  a458=(a458+a398);
  a398=(a490*a193);
  a458=(a458+a398);
  a398=(a491*a294);
  a458=(a458+a398);
  a398=(a492*a347);
  a458=(a458+a398);
  a398=(a493*a401);
  a458=(a458+a398);
  a398=(a494*a456);
  a458=(a458+a398);
  a497=(a497-a046);
  a497=(a497+a526);
  a497=(a497-a528);
  a509=(a509+a515);
  a509=(a509-a518);
  a509=(a509-a519);
  a509=(a509+a513);
  a509=(a509+a517);
  a509=(a505*a509);
  a497=(a497-a509);
  a509=(a502*a019);
  a513=(a513*a509);
  a497=(a497-a513);
  a509=(a509*a517);
  a497=(a497-a509);
  a523=(a523+a525);
  a523=(a523+a501);
  a525=(a523*a522);
  a497=(a497+a525);
  a525=(a530*a033);
  a525=(a525*a019);
  a525=(a525+a041);
  a525=(a525+a033);
  a525=(a525+a060);
  a531=(a531-a535);
  a531=(a531-a500);
  a531=(a531-a007);
  a531=(a531+a533);
  a531=(a531-a537);
  a531=(a531+a067);
  a531=(a531+a538);
  a531=(a531-a539);
  a531=(a531+a072);
  a531=(a531+a073);
  a531=(a035*a531);
  a525=(a525+a531);
  a531=(a497/a525);
  a533=(a539-a538);
  a537=(a500+a537);
  a533=(a533+a537);
  a535=(a533-a070);
  a535=(a535-a071);
  a535=(a010*a535);
  a535=(a535-a059);
  a509=(a535/a525);
  a497=(a509*a497);
  a529=(a529-a497);
  a535=(a535*a509);
  a535=(a076-a535);
  a529=(a529/a535);
  a497=(a509*a529);
  a531=(a531-a497);
  a497=(2.*a531);
  a517=(a497*a019);
  a513=(a007*a511);
  a508=(a508+a513);
  a513=(2.*a511);
  a508=(a508-a513);
  a513=(a007*a516);
  a512=(a512+a513);
  a508=(a508+a512);
  a508=(a010*a508);
  a518=(a518-a508);
  a517=(a517*a518);
  a518=(a529*a010);
  a518=(a518*a019);
  a518=(a518*a512);
  a517=(a517+a518);
  a518=(a527*a033);
  a517=(a517+a518);
  a518=(a014*a496);
  a518=(a518*a496);
  a508=(a518*a010);
  a508=(a508*a019);
  a508=(a508*a516);
  a517=(a517+a508);
  a508=(2.*a527);
  a527=(a527*a007);
  a508=(a508-a527);
  a524=(a014*a524);
  a508=(a508+a524);
  a506=(a506*a007);
  a498=(a014*a498);
  a524=(a506+a498);
  a508=(a508-a524);
  a508=(a010*a508);
  a517=(a517+a508);
  a508=(a014*a516);
  a508=(a508-a510);
  a527=(a019*a508);
  a527=(a527*a522);
  a517=(a517-a527);
  a507=(a507*a033);
  a534=(a534*a010);
  a507=(a507-a534);
  a530=(a530*a010);
  a507=(a507+a530);
  a530=(a510*a010);
  a507=(a507-a530);
  a511=(a056*a511);
  a507=(a507+a511);
  a516=(a056*a516);
  a507=(a507+a516);
  a507=(a505*a507);
  a517=(a517+a507);
  a539=(a539*a503);
  a517=(a517-a539);
  a539=(a517/a525);
  a503=(a531*a019);
  a503=(a503*a512);
  a503=(a503+a524);
  a503=(a010*a503);
  a517=(a509*a517);
  a503=(a503-a517);
  a503=(a503/a535);
  a517=(a509*a503);
  a539=(a539-a517);
  a517=(a432*a608);
  a512=(a434*a195);
  a517=(a517+a512);
  a512=(a435*a244);
  a517=(a517+a512);
  a512=(a436*a028);
  a517=(a517+a512);
  a512=(a437*a110);
  a517=(a517+a512);
  a512=(a438*a296);
  a517=(a517+a512);
  a512=(a439*a349);
  a517=(a517+a512);
  a517=(a037+a517);
  a512=(a539*a517);
  a497=(a497*a523);
  a529=(a529*a523);
  a497=(a497-a529);
  a497=(a497+a506);
  a510=(a510*a496);
  a510=(a510*a496);
  a510=(a510*a019);
  a497=(a497+a510);
  a500=(a500*a496);
  a500=(a500*a496);
  a497=(a497+a500);
  a518=(a518*a499);
  a497=(a497+a518);
  a497=(a497+a498);
  a521=(a521*a533);
  a497=(a497-a521);
  a502=(a502*a538);
  a497=(a497-a502);
  a505=(a505*a508);
  a497=(a497-a505);
  a497=(a010*a497);
  a525=(a497/a525);
  a504=(a504*a537);
  a531=(a531*a523);
  a504=(a504-a531);
  a504=(a504-a524);
  a504=(a010*a504);
  a497=(a509*a497);
  a504=(a504-a497);
  a504=(a504/a535);
  a509=(a509*a504);
  a525=(a525-a509);
  a509=(a432*a075);
  a535=(a434*a222);
  a509=(a509+a535);
  a535=(a435*a271);
  a509=(a509+a535);
  a535=(a436*a323);
  a509=(a509+a535);
  a535=(a437*a376);
  a509=(a509+a535);
  a535=(a438*a430);
  a509=(a509+a535);
  a535=(a439*a485);
  a509=(a509+a535);
  a509=(a023+a509);
  a535=(a525*a509);
  a512=(a512+a535);
  a535=(a064*a433);
  a514=(a019*a514);
  a514=(a535*a514);
  a497=(a064*a496);
  a497=(a497*a010);
  a497=(a497*a523);
  a514=(a514-a497);
  a497=(a514/a532);
  a535=(a535*a010);
  a535=(a535*a501);
  a514=(a541*a514);
  a535=(a535-a514);
  a535=(a535/a540);
  a514=(a541*a535);
  a497=(a497-a514);
  a514=(a497*a403);
  a523=(a035*a523);
  a433=(a433-a496);
  a523=(a523*a433);
  a532=(a523/a532);
  a523=(a541*a523);
  a523=(a523/a540);
  a541=(a541*a523);
  a532=(a532+a541);
  a541=(a432*a137);
  a540=(a434*a198);
  a541=(a541+a540);
  a540=(a435*a247);
  a541=(a541+a540);
  a540=(a436*a299);
  a541=(a541+a540);
  a540=(a437*a352);
  a541=(a541+a540);
  a540=(a438*a406);
  a541=(a541+a540);
  a461=(a447*a461);
  a453=(a448*a453);
  a461=(a461+a453);
  a453=(a479*a349);
  a540=(a467*a485);
  a453=(a453-a540);
  a461=(a461+a453);
  a453=(a439*a461);
  a541=(a541+a453);
  a541=(a075+a541);
  a453=(a532*a541);
  a514=(a514+a453);
  a512=(a512+a514);
  a514=(a495*a512);
  a458=(a458+a514);
  a458=(a608+a458);
  a514=(a486*a458);
  a574=(a574+a514);
  a514=(a543*a032);
  a108=(a545*a108);
  a514=(a514+a108);
  a193=(a217*a193);
  a514=(a514+a193);
  a193=(a266*a294);
  a514=(a514+a193);
  a193=(a546*a347);
  a514=(a514+a193);
  a193=(a547*a401);
  a514=(a514+a193);
  a193=(a548*a456);
  a514=(a514+a193);
  a193=(a549*a512);
  a514=(a514+a193);
  a551=(a551-a046);
  a551=(a551+a580);
  a551=(a551-a582);
  a563=(a563+a569);
  a563=(a563-a572);
  a563=(a563-a573);
  a563=(a563+a567);
  a563=(a563+a571);
  a563=(a559*a563);
  a551=(a551-a563);
  a563=(a556*a019);
  a567=(a567*a563);
  a551=(a551-a567);
  a563=(a563*a571);
  a551=(a551-a563);
  a577=(a577+a579);
  a577=(a577+a555);
  a579=(a577*a576);
  a551=(a551+a579);
  a579=(a584*a033);
  a579=(a579*a019);
  a579=(a579+a041);
  a579=(a579+a033);
  a579=(a579+a060);
  a585=(a585-a589);
  a585=(a585-a554);
  a585=(a585-a007);
  a585=(a585+a587);
  a585=(a585-a591);
  a585=(a585+a067);
  a585=(a585+a592);
  a585=(a585-a593);
  a585=(a585+a072);
  a585=(a585+a073);
  a585=(a035*a585);
  a579=(a579+a585);
  a585=(a551/a579);
  a587=(a593-a592);
  a591=(a554+a591);
  a587=(a587+a591);
  a589=(a587-a070);
  a589=(a589-a071);
  a589=(a010*a589);
  a589=(a589-a059);
  a563=(a589/a579);
  a551=(a563*a551);
  a583=(a583-a551);
  a589=(a589*a563);
  a589=(a076-a589);
  a583=(a583/a589);
  a551=(a563*a583);
  a585=(a585-a551);
  a551=(2.*a585);
  a571=(a551*a019);
  a567=(a007*a565);
  a562=(a562+a567);
  a567=(2.*a565);
  a562=(a562-a567);
  a567=(a007*a570);
  a566=(a566+a567);
  a562=(a562+a566);
  a562=(a010*a562);
  a572=(a572-a562);
  a571=(a571*a572);
  a572=(a583*a010);
  a572=(a572*a019);
  a572=(a572*a566);
  a571=(a571+a572);
  a572=(a581*a033);
  a571=(a571+a572);
  a572=(a014*a002);
  a572=(a572*a002);
  a562=(a572*a010);
  a562=(a562*a019);
  a562=(a562*a570);
  a571=(a571+a562);
  a562=(2.*a581);
  a581=(a581*a007);
  a562=(a562-a581);
  a578=(a014*a578);
  a562=(a562+a578);
  a560=(a560*a007);
  a552=(a014*a552);
  a578=(a560+a552);
  a562=(a562-a578);
  a562=(a010*a562);
  a571=(a571+a562);
  a562=(a014*a570);
  a562=(a562-a564);
  a581=(a019*a562);
  a581=(a581*a576);
  a571=(a571-a581);
  a561=(a561*a033);
  a588=(a588*a010);
  a561=(a561-a588);
  a584=(a584*a010);
  a561=(a561+a584);
  a584=(a564*a010);
  a561=(a561-a584);
  a565=(a056*a565);
  a561=(a561+a565);
  a570=(a056*a570);
  a561=(a561+a570);
  a561=(a559*a561);
  a571=(a571+a561);
  a593=(a593*a557);
  a571=(a571-a593);
  a593=(a571/a579);
  a557=(a585*a019);
  a557=(a557*a566);
  a557=(a557+a578);
  a557=(a010*a557);
  a571=(a563*a571);
  a557=(a557-a571);
  a557=(a557/a589);
  a571=(a563*a557);
  a593=(a593-a571);
  a571=(a487*a608);
  a566=(a489*a195);
  a571=(a571+a566);
  a566=(a490*a244);
  a571=(a571+a566);
  a566=(a491*a028);
  a571=(a571+a566);
  a566=(a492*a110);
  a571=(a571+a566);
  a566=(a493*a296);
  a571=(a571+a566);
  a566=(a494*a349);
  a571=(a571+a566);
  a566=(a495*a403);
  a571=(a571+a566);
  a571=(a037+a571);
  a566=(a593*a571);
  a551=(a551*a577);
  a583=(a583*a577);
  a551=(a551-a583);
  a551=(a551+a560);
  a564=(a564*a002);
  a564=(a564*a002);
  a564=(a564*a019);
  a551=(a551+a564);
  a554=(a554*a002);
  a554=(a554*a002);
  a551=(a551+a554);
  a572=(a572*a553);
  a551=(a551+a572);
  a551=(a551+a552);
  a575=(a575*a587);
  a551=(a551-a575);
  a556=(a556*a592);
  a551=(a551-a556);
  a559=(a559*a562);
  a551=(a551-a559);
  a551=(a010*a551);
  a579=(a551/a579);
  a558=(a558*a591);
  a585=(a585*a577);
  a558=(a558-a585);
  a558=(a558-a578);
  a558=(a010*a558);
  a551=(a563*a551);
  a558=(a558-a551);
  a558=(a558/a589);
  a563=(a563*a558);
  a579=(a579-a563);
  a563=(a487*a075);
  a589=(a489*a222);
  a563=(a563+a589);
  a589=(a490*a271);
  a563=(a563+a589);
  a589=(a491*a323);
  a563=(a563+a589);
  a589=(a492*a376);
  a563=(a563+a589);
  a589=(a493*a430);
  a563=(a563+a589);
  a589=(a494*a485);
  a563=(a563+a589);
  a589=(a495*a541);
  a563=(a563+a589);
  a563=(a023+a563);
  a589=(a579*a563);
  a566=(a566+a589);
  a589=(a064*a488);
  a568=(a019*a568);
  a568=(a589*a568);
  a551=(a064*a002);
  a551=(a551*a010);
  a551=(a551*a577);
  a568=(a568-a551);
  a551=(a568/a586);
  a589=(a589*a010);
  a589=(a589*a555);
  a568=(a595*a568);
  a589=(a589-a568);
  a589=(a589/a594);
  a568=(a595*a589);
  a551=(a551-a568);
  a568=(a551*a458);
  a577=(a035*a577);
  a488=(a488-a002);
  a577=(a577*a488);
  a586=(a577/a586);
  a577=(a595*a577);
  a577=(a577/a594);
  a595=(a595*a577);
  a586=(a586+a595);
  a595=(a487*a137);
  a594=(a489*a198);
  a595=(a595+a594);
  a594=(a490*a247);
  a595=(a595+a594);
  a594=(a491*a299);
  a595=(a595+a594);
  a594=(a492*a352);
  a595=(a595+a594);
  a594=(a493*a406);
  a595=(a595+a594);
  a594=(a494*a461);
  a595=(a595+a594);
  a517=(a503*a517);
  a509=(a504*a509);
  a517=(a517+a509);
  a509=(a535*a403);
  a594=(a523*a541);
  a509=(a509-a594);
  a517=(a517+a509);
  a509=(a495*a517);
  a595=(a595+a509);
  a595=(a075+a595);
  a509=(a586*a595);
  a568=(a568+a509);
  a566=(a566+a568);
  a568=(a550*a566);
  a514=(a514+a568);
  a514=(a608+a514);
  a568=(a542*a514);
  a574=(a574+a568);
  a574=(a037+a574);
  if (res[0]!=0) res[0][4]=a574;
  a574=(a001*a075);
  a568=(a005*a323);
  a574=(a574+a568);
  a568=(a272*a376);
  a574=(a574+a568);
  a568=(a324*a430);
  a574=(a574+a568);
  a568=(a377*a485);
  a574=(a574+a568);
  a568=(a431*a541);
  a574=(a574+a568);
  a568=(a486*a595);
  a574=(a574+a568);
  a568=(a543*a137);
  a198=(a545*a198);
  a568=(a568+a198);
  a247=(a217*a247);
  a568=(a568+a247);
  a247=(a266*a299);
  a568=(a568+a247);
  a247=(a546*a352);
  a568=(a568+a247);
  a247=(a547*a406);
  a568=(a568+a247);
  a247=(a548*a461);
  a568=(a568+a247);
  a247=(a549*a517);
  a568=(a568+a247);
  a571=(a557*a571);
  a563=(a558*a563);
  a571=(a571+a563);
  a563=(a589*a458);
  a247=(a577*a595);
  a563=(a563-a247);
  a571=(a571+a563);
  a563=(a550*a571);
  a568=(a568+a563);
  a568=(a075+a568);
  a563=(a542*a568);
  a574=(a574+a563);
  a574=(a023+a574);
  if (res[0]!=0) res[0][5]=a574;
  a032=(a001*a032);
  a294=(a005*a294);
  a032=(a032+a294);
  a347=(a272*a347);
  a032=(a032+a347);
  a401=(a324*a401);
  a032=(a032+a401);
  a456=(a377*a456);
  a032=(a032+a456);
  a512=(a431*a512);
  a032=(a032+a512);
  a566=(a486*a566);
  a032=(a032+a566);
  a590=(a590-a046);
  a590=(a590+a613);
  a590=(a590-a045);
  a598=(a598+a604);
  a598=(a598-a606);
  a598=(a598-a607);
  a598=(a598+a602);
  a598=(a598+a029);
  a598=(a250*a598);
  a590=(a590-a598);
  a598=(a371*a019);
  a602=(a602*a598);
  a590=(a590-a602);
  a598=(a598*a029);
  a590=(a590-a598);
  a611=(a611+a042);
  a611=(a611+a425);
  a042=(a611*a610);
  a590=(a590+a042);
  a042=(a052*a033);
  a042=(a042*a019);
  a042=(a042+a041);
  a042=(a042+a033);
  a042=(a042+a060);
  a614=(a614-a618);
  a614=(a614-a480);
  a614=(a614-a007);
  a614=(a614+a616);
  a614=(a614-a620);
  a614=(a614+a067);
  a614=(a614+a061);
  a614=(a614-a621);
  a614=(a614+a072);
  a614=(a614+a073);
  a614=(a035*a614);
  a042=(a042+a614);
  a614=(a590/a042);
  a073=(a621-a061);
  a620=(a480+a620);
  a073=(a073+a620);
  a070=(a073-a070);
  a070=(a070-a071);
  a070=(a010*a070);
  a070=(a070-a059);
  a059=(a070/a042);
  a590=(a059*a590);
  a000=(a000-a590);
  a070=(a070*a059);
  a076=(a076-a070);
  a000=(a000/a076);
  a070=(a059*a000);
  a614=(a614-a070);
  a070=(2.*a614);
  a590=(a070*a019);
  a071=(a007*a600);
  a597=(a597+a071);
  a071=(2.*a600);
  a597=(a597-a071);
  a071=(a007*a605);
  a601=(a601+a071);
  a597=(a597+a601);
  a597=(a010*a597);
  a606=(a606-a597);
  a590=(a590*a606);
  a606=(a000*a010);
  a606=(a606*a019);
  a606=(a606*a601);
  a590=(a590+a606);
  a606=(a047*a033);
  a590=(a590+a606);
  a606=(a014*a596);
  a606=(a606*a596);
  a597=(a606*a010);
  a597=(a597*a019);
  a597=(a597*a605);
  a590=(a590+a597);
  a597=(2.*a047);
  a047=(a047*a007);
  a597=(a597-a047);
  a612=(a014*a612);
  a597=(a597+a612);
  a044=(a044*a007);
  a011=(a014*a011);
  a007=(a044+a011);
  a597=(a597-a007);
  a597=(a010*a597);
  a590=(a590+a597);
  a014=(a014*a605);
  a014=(a014-a599);
  a597=(a019*a014);
  a597=(a597*a610);
  a590=(a590-a597);
  a201=(a201*a033);
  a617=(a617*a010);
  a201=(a201-a617);
  a052=(a052*a010);
  a201=(a201+a052);
  a052=(a599*a010);
  a201=(a201-a052);
  a600=(a056*a600);
  a201=(a201+a600);
  a056=(a056*a605);
  a201=(a201+a056);
  a201=(a250*a201);
  a590=(a590+a201);
  a621=(a621*a318);
  a590=(a590-a621);
  a621=(a590/a042);
  a318=(a614*a019);
  a318=(a318*a601);
  a318=(a318+a007);
  a318=(a010*a318);
  a590=(a059*a590);
  a318=(a318-a590);
  a318=(a318/a076);
  a590=(a059*a318);
  a621=(a621-a590);
  a590=(a543*a608);
  a195=(a545*a195);
  a590=(a590+a195);
  a244=(a217*a244);
  a590=(a590+a244);
  a028=(a266*a028);
  a590=(a590+a028);
  a110=(a546*a110);
  a590=(a590+a110);
  a296=(a547*a296);
  a590=(a590+a296);
  a349=(a548*a349);
  a590=(a590+a349);
  a403=(a549*a403);
  a590=(a590+a403);
  a458=(a550*a458);
  a590=(a590+a458);
  a037=(a037+a590);
  a590=(a621*a037);
  a070=(a070*a611);
  a000=(a000*a611);
  a070=(a070-a000);
  a070=(a070+a044);
  a599=(a599*a596);
  a599=(a599*a596);
  a599=(a599*a019);
  a070=(a070+a599);
  a480=(a480*a596);
  a480=(a480*a596);
  a070=(a070+a480);
  a606=(a606*a536);
  a070=(a070+a606);
  a070=(a070+a011);
  a609=(a609*a073);
  a070=(a070-a609);
  a371=(a371*a061);
  a070=(a070-a371);
  a250=(a250*a014);
  a070=(a070-a250);
  a070=(a010*a070);
  a042=(a070/a042);
  a004=(a004*a620);
  a614=(a614*a611);
  a004=(a004-a614);
  a004=(a004-a007);
  a004=(a010*a004);
  a070=(a059*a070);
  a004=(a004-a070);
  a004=(a004/a076);
  a059=(a059*a004);
  a042=(a042-a059);
  a059=(a543*a075);
  a222=(a545*a222);
  a059=(a059+a222);
  a271=(a217*a271);
  a059=(a059+a271);
  a323=(a266*a323);
  a059=(a059+a323);
  a376=(a546*a376);
  a059=(a059+a376);
  a430=(a547*a430);
  a059=(a059+a430);
  a485=(a548*a485);
  a059=(a059+a485);
  a541=(a549*a541);
  a059=(a059+a541);
  a595=(a550*a595);
  a059=(a059+a595);
  a023=(a023+a059);
  a059=(a042*a023);
  a590=(a590+a059);
  a059=(a064*a544);
  a019=(a019*a603);
  a019=(a059*a019);
  a064=(a064*a596);
  a064=(a064*a010);
  a064=(a064*a611);
  a019=(a019-a064);
  a064=(a019/a615);
  a059=(a059*a010);
  a059=(a059*a425);
  a019=(a623*a019);
  a059=(a059-a019);
  a059=(a059/a622);
  a019=(a623*a059);
  a064=(a064-a019);
  a019=(a064*a514);
  a035=(a035*a611);
  a544=(a544-a596);
  a035=(a035*a544);
  a615=(a035/a615);
  a035=(a623*a035);
  a035=(a035/a622);
  a623=(a623*a035);
  a615=(a615+a623);
  a623=(a615*a568);
  a019=(a019+a623);
  a590=(a590+a019);
  a590=(a542*a590);
  a032=(a032+a590);
  a608=(a608+a032);
  if (res[0]!=0) res[0][6]=a608;
  a137=(a001*a137);
  a299=(a005*a299);
  a137=(a137+a299);
  a352=(a272*a352);
  a137=(a137+a352);
  a406=(a324*a406);
  a137=(a137+a406);
  a461=(a377*a461);
  a137=(a137+a461);
  a517=(a431*a517);
  a137=(a137+a517);
  a571=(a486*a571);
  a137=(a137+a571);
  a037=(a318*a037);
  a023=(a004*a023);
  a037=(a037+a023);
  a514=(a059*a514);
  a568=(a035*a568);
  a514=(a514-a568);
  a037=(a037+a514);
  a037=(a542*a037);
  a137=(a137+a037);
  a075=(a075+a137);
  if (res[0]!=0) res[0][7]=a075;
  a075=arg[0]? arg[0][8] : 0;
  a137=arg[0]? arg[0][10] : 0;
  a037=(a001*a137);
  a514=(a069*a075);
  a568=arg[0]? arg[0][9] : 0;
  a023=(a043*a568);
  a514=(a514+a023);
  a023=(a048*a137);
  a571=arg[0]? arg[0][11] : 0;
  a517=(a058*a571);
  a023=(a023+a517);
  a514=(a514+a023);
  a023=(a006*a514);
  a517=(a079*a137);
  a461=(a082*a514);
  a406=(a085*a137);
  a406=(a075+a406);
  a352=(a135*a406);
  a299=(a085*a571);
  a299=(a568+a299);
  a608=(a121*a299);
  a352=(a352+a608);
  a608=(a085*a514);
  a608=(a137+a608);
  a032=(a093*a608);
  a590=(a017*a075);
  a019=(a018*a568);
  a590=(a590+a019);
  a019=(a009*a137);
  a623=(a040*a571);
  a019=(a019-a623);
  a590=(a590+a019);
  a019=(a085*a590);
  a019=(a571+a019);
  a623=(a128*a019);
  a032=(a032+a623);
  a352=(a352+a032);
  a352=(a084*a352);
  a461=(a461+a352);
  a461=(a137+a461);
  a352=(a081*a461);
  a517=(a517+a352);
  a517=(a075+a517);
  a352=(a220*a517);
  a032=(a079*a571);
  a623=(a082*a590);
  a406=(a099*a406);
  a299=(a100*a299);
  a406=(a406+a299);
  a299=(a131*a608);
  a622=(a119*a019);
  a299=(a299-a622);
  a406=(a406+a299);
  a406=(a084*a406);
  a623=(a623+a406);
  a623=(a571+a623);
  a406=(a081*a623);
  a032=(a032+a406);
  a032=(a568+a032);
  a406=(a206*a032);
  a352=(a352+a406);
  a406=(a079*a514);
  a299=(a082*a137);
  a608=(a084*a608);
  a299=(a299+a608);
  a299=(a075+a299);
  a608=(a149*a299);
  a622=(a082*a571);
  a019=(a084*a019);
  a622=(a622+a019);
  a622=(a568+a622);
  a019=(a173*a622);
  a608=(a608+a019);
  a019=(a155*a461);
  a544=(a152*a623);
  a019=(a019+a544);
  a608=(a608+a019);
  a019=(a081*a608);
  a406=(a406+a019);
  a406=(a137+a406);
  a019=(a105*a406);
  a544=(a079*a590);
  a299=(a159*a299);
  a622=(a132*a622);
  a299=(a299+a622);
  a622=(a136*a461);
  a596=(a171*a623);
  a622=(a622-a596);
  a299=(a299+a622);
  a622=(a081*a299);
  a544=(a544+a622);
  a544=(a571+a544);
  a622=(a213*a544);
  a019=(a019+a622);
  a352=(a352+a019);
  a019=(a078*a352);
  a023=(a023+a019);
  a019=(a224*a137);
  a461=(a226*a461);
  a019=(a019+a461);
  a461=(a091*a406);
  a019=(a019+a461);
  a019=(a075+a019);
  a461=(a269*a019);
  a622=(a224*a571);
  a623=(a226*a623);
  a622=(a622+a623);
  a623=(a091*a544);
  a622=(a622+a623);
  a622=(a568+a622);
  a623=(a255*a622);
  a461=(a461+a623);
  a623=(a224*a514);
  a608=(a226*a608);
  a623=(a623+a608);
  a608=(a091*a352);
  a623=(a623+a608);
  a623=(a137+a623);
  a608=(a265*a623);
  a596=(a224*a590);
  a299=(a226*a299);
  a596=(a596+a299);
  a517=(a183*a517);
  a032=(a185*a032);
  a517=(a517+a032);
  a032=(a113*a406);
  a299=(a204*a544);
  a032=(a032-a299);
  a517=(a517+a032);
  a032=(a091*a517);
  a596=(a596+a032);
  a596=(a571+a596);
  a032=(a262*a596);
  a608=(a608+a032);
  a461=(a461+a608);
  a608=(a223*a461);
  a023=(a023+a608);
  a023=(a137+a023);
  a608=(a005*a023);
  a037=(a037+a608);
  a608=(a273*a514);
  a032=(a275*a352);
  a608=(a608+a032);
  a032=(a276*a461);
  a608=(a608+a032);
  a032=(a006*a137);
  a299=(a078*a406);
  a032=(a032+a299);
  a299=(a223*a623);
  a032=(a032+a299);
  a032=(a075+a032);
  a299=(a321*a032);
  a611=(a006*a571);
  a425=(a078*a544);
  a611=(a611+a425);
  a425=(a223*a596);
  a611=(a611+a425);
  a611=(a568+a611);
  a425=(a307*a611);
  a299=(a299+a425);
  a425=(a279*a023);
  a010=(a006*a590);
  a603=(a078*a517);
  a010=(a010+a603);
  a019=(a233*a019);
  a622=(a168*a622);
  a019=(a019+a622);
  a622=(a216*a623);
  a603=(a253*a596);
  a622=(a622-a603);
  a019=(a019+a622);
  a622=(a223*a019);
  a010=(a010+a622);
  a010=(a571+a010);
  a622=(a314*a010);
  a425=(a425+a622);
  a299=(a299+a425);
  a425=(a277*a299);
  a608=(a608+a425);
  a608=(a137+a608);
  a425=(a272*a608);
  a037=(a037+a425);
  a425=(a325*a514);
  a622=(a327*a352);
  a425=(a425+a622);
  a622=(a328*a461);
  a425=(a425+a622);
  a622=(a329*a299);
  a425=(a425+a622);
  a622=(a273*a137);
  a603=(a275*a406);
  a622=(a622+a603);
  a603=(a276*a623);
  a622=(a622+a603);
  a603=(a277*a023);
  a622=(a622+a603);
  a622=(a075+a622);
  a603=(a374*a622);
  a595=(a273*a571);
  a541=(a275*a544);
  a595=(a595+a541);
  a541=(a276*a596);
  a595=(a595+a541);
  a541=(a277*a010);
  a595=(a595+a541);
  a595=(a568+a595);
  a541=(a360*a595);
  a603=(a603+a541);
  a541=(a332*a608);
  a485=(a273*a590);
  a430=(a275*a517);
  a485=(a485+a430);
  a430=(a276*a019);
  a485=(a485+a430);
  a032=(a285*a032);
  a611=(a286*a611);
  a032=(a032+a611);
  a611=(a317*a023);
  a430=(a305*a010);
  a611=(a611-a430);
  a032=(a032+a611);
  a611=(a277*a032);
  a485=(a485+a611);
  a485=(a571+a485);
  a611=(a367*a485);
  a541=(a541+a611);
  a603=(a603+a541);
  a541=(a330*a603);
  a425=(a425+a541);
  a425=(a137+a425);
  a541=(a324*a425);
  a037=(a037+a541);
  a541=(a378*a514);
  a611=(a380*a352);
  a541=(a541+a611);
  a611=(a381*a461);
  a541=(a541+a611);
  a611=(a382*a299);
  a541=(a541+a611);
  a611=(a383*a603);
  a541=(a541+a611);
  a611=(a325*a137);
  a430=(a327*a406);
  a611=(a611+a430);
  a430=(a328*a623);
  a611=(a611+a430);
  a430=(a329*a023);
  a611=(a611+a430);
  a430=(a330*a608);
  a611=(a611+a430);
  a611=(a075+a611);
  a430=(a428*a611);
  a376=(a325*a571);
  a323=(a327*a544);
  a376=(a376+a323);
  a323=(a328*a596);
  a376=(a376+a323);
  a323=(a329*a010);
  a376=(a376+a323);
  a323=(a330*a485);
  a376=(a376+a323);
  a376=(a568+a376);
  a323=(a414*a376);
  a430=(a430+a323);
  a323=(a386*a425);
  a271=(a325*a590);
  a222=(a327*a517);
  a271=(a271+a222);
  a222=(a328*a019);
  a271=(a271+a222);
  a222=(a329*a032);
  a271=(a271+a222);
  a622=(a338*a622);
  a595=(a339*a595);
  a622=(a622+a595);
  a595=(a370*a608);
  a222=(a358*a485);
  a595=(a595-a222);
  a622=(a622+a595);
  a595=(a330*a622);
  a271=(a271+a595);
  a271=(a571+a271);
  a595=(a421*a271);
  a323=(a323+a595);
  a430=(a430+a323);
  a323=(a384*a430);
  a541=(a541+a323);
  a541=(a137+a541);
  a323=(a377*a541);
  a037=(a037+a323);
  a323=(a432*a514);
  a595=(a434*a352);
  a323=(a323+a595);
  a595=(a435*a461);
  a323=(a323+a595);
  a595=(a436*a299);
  a323=(a323+a595);
  a595=(a437*a603);
  a323=(a323+a595);
  a595=(a438*a430);
  a323=(a323+a595);
  a595=(a378*a137);
  a222=(a380*a406);
  a595=(a595+a222);
  a222=(a381*a623);
  a595=(a595+a222);
  a222=(a382*a023);
  a595=(a595+a222);
  a222=(a383*a608);
  a595=(a595+a222);
  a222=(a384*a425);
  a595=(a595+a222);
  a595=(a075+a595);
  a222=(a483*a595);
  a076=(a378*a571);
  a070=(a380*a544);
  a076=(a076+a070);
  a070=(a381*a596);
  a076=(a076+a070);
  a070=(a382*a010);
  a076=(a076+a070);
  a070=(a383*a485);
  a076=(a076+a070);
  a070=(a384*a271);
  a076=(a076+a070);
  a076=(a568+a076);
  a070=(a469*a076);
  a222=(a222+a070);
  a070=(a441*a541);
  a007=(a378*a590);
  a614=(a380*a517);
  a007=(a007+a614);
  a614=(a381*a019);
  a007=(a007+a614);
  a614=(a382*a032);
  a007=(a007+a614);
  a614=(a383*a622);
  a007=(a007+a614);
  a611=(a392*a611);
  a376=(a393*a376);
  a611=(a611+a376);
  a376=(a424*a425);
  a614=(a412*a271);
  a376=(a376-a614);
  a611=(a611+a376);
  a376=(a384*a611);
  a007=(a007+a376);
  a007=(a571+a007);
  a376=(a476*a007);
  a070=(a070+a376);
  a222=(a222+a070);
  a070=(a439*a222);
  a323=(a323+a070);
  a323=(a137+a323);
  a070=(a431*a323);
  a037=(a037+a070);
  a070=(a487*a514);
  a376=(a489*a352);
  a070=(a070+a376);
  a376=(a490*a461);
  a070=(a070+a376);
  a376=(a491*a299);
  a070=(a070+a376);
  a376=(a492*a603);
  a070=(a070+a376);
  a376=(a493*a430);
  a070=(a070+a376);
  a376=(a494*a222);
  a070=(a070+a376);
  a376=(a432*a137);
  a614=(a434*a406);
  a376=(a376+a614);
  a614=(a435*a623);
  a376=(a376+a614);
  a614=(a436*a023);
  a376=(a376+a614);
  a614=(a437*a608);
  a376=(a376+a614);
  a614=(a438*a425);
  a376=(a376+a614);
  a614=(a439*a541);
  a376=(a376+a614);
  a376=(a075+a376);
  a614=(a539*a376);
  a620=(a432*a571);
  a250=(a434*a544);
  a620=(a620+a250);
  a250=(a435*a596);
  a620=(a620+a250);
  a250=(a436*a010);
  a620=(a620+a250);
  a250=(a437*a485);
  a620=(a620+a250);
  a250=(a438*a271);
  a620=(a620+a250);
  a250=(a439*a007);
  a620=(a620+a250);
  a620=(a568+a620);
  a250=(a525*a620);
  a614=(a614+a250);
  a250=(a497*a323);
  a014=(a432*a590);
  a371=(a434*a517);
  a014=(a014+a371);
  a371=(a435*a019);
  a014=(a014+a371);
  a371=(a436*a032);
  a014=(a014+a371);
  a371=(a437*a622);
  a014=(a014+a371);
  a371=(a438*a611);
  a014=(a014+a371);
  a595=(a447*a595);
  a076=(a448*a076);
  a595=(a595+a076);
  a076=(a479*a541);
  a371=(a467*a007);
  a076=(a076-a371);
  a595=(a595+a076);
  a076=(a439*a595);
  a014=(a014+a076);
  a014=(a571+a014);
  a076=(a532*a014);
  a250=(a250+a076);
  a614=(a614+a250);
  a250=(a495*a614);
  a070=(a070+a250);
  a070=(a137+a070);
  a250=(a486*a070);
  a037=(a037+a250);
  a250=(a543*a514);
  a352=(a545*a352);
  a250=(a250+a352);
  a461=(a217*a461);
  a250=(a250+a461);
  a461=(a266*a299);
  a250=(a250+a461);
  a461=(a546*a603);
  a250=(a250+a461);
  a461=(a547*a430);
  a250=(a250+a461);
  a461=(a548*a222);
  a250=(a250+a461);
  a461=(a549*a614);
  a250=(a250+a461);
  a461=(a487*a137);
  a352=(a489*a406);
  a461=(a461+a352);
  a352=(a490*a623);
  a461=(a461+a352);
  a352=(a491*a023);
  a461=(a461+a352);
  a352=(a492*a608);
  a461=(a461+a352);
  a352=(a493*a425);
  a461=(a461+a352);
  a352=(a494*a541);
  a461=(a461+a352);
  a352=(a495*a323);
  a461=(a461+a352);
  a461=(a075+a461);
  a352=(a593*a461);
  a076=(a487*a571);
  a371=(a489*a544);
  a076=(a076+a371);
  a371=(a490*a596);
  a076=(a076+a371);
  a371=(a491*a010);
  a076=(a076+a371);
  a371=(a492*a485);
  a076=(a076+a371);
  a371=(a493*a271);
  a076=(a076+a371);
  a371=(a494*a007);
  a076=(a076+a371);
  a371=(a495*a014);
  a076=(a076+a371);
  a076=(a568+a076);
  a371=(a579*a076);
  a352=(a352+a371);
  a371=(a551*a070);
  a061=(a487*a590);
  a609=(a489*a517);
  a061=(a061+a609);
  a609=(a490*a019);
  a061=(a061+a609);
  a609=(a491*a032);
  a061=(a061+a609);
  a609=(a492*a622);
  a061=(a061+a609);
  a609=(a493*a611);
  a061=(a061+a609);
  a609=(a494*a595);
  a061=(a061+a609);
  a376=(a503*a376);
  a620=(a504*a620);
  a376=(a376+a620);
  a620=(a535*a323);
  a609=(a523*a014);
  a620=(a620-a609);
  a376=(a376+a620);
  a620=(a495*a376);
  a061=(a061+a620);
  a061=(a571+a061);
  a620=(a586*a061);
  a371=(a371+a620);
  a352=(a352+a371);
  a371=(a550*a352);
  a250=(a250+a371);
  a250=(a137+a250);
  a371=(a542*a250);
  a037=(a037+a371);
  a037=(a075+a037);
  if (res[0]!=0) res[0][8]=a037;
  a037=(a001*a571);
  a371=(a005*a010);
  a037=(a037+a371);
  a371=(a272*a485);
  a037=(a037+a371);
  a371=(a324*a271);
  a037=(a037+a371);
  a371=(a377*a007);
  a037=(a037+a371);
  a371=(a431*a014);
  a037=(a037+a371);
  a371=(a486*a061);
  a037=(a037+a371);
  a371=(a543*a590);
  a517=(a545*a517);
  a371=(a371+a517);
  a019=(a217*a019);
  a371=(a371+a019);
  a019=(a266*a032);
  a371=(a371+a019);
  a019=(a546*a622);
  a371=(a371+a019);
  a019=(a547*a611);
  a371=(a371+a019);
  a019=(a548*a595);
  a371=(a371+a019);
  a019=(a549*a376);
  a371=(a371+a019);
  a461=(a557*a461);
  a076=(a558*a076);
  a461=(a461+a076);
  a076=(a589*a070);
  a019=(a577*a061);
  a076=(a076-a019);
  a461=(a461+a076);
  a076=(a550*a461);
  a371=(a371+a076);
  a371=(a571+a371);
  a076=(a542*a371);
  a037=(a037+a076);
  a037=(a568+a037);
  if (res[0]!=0) res[0][9]=a037;
  a514=(a001*a514);
  a299=(a005*a299);
  a514=(a514+a299);
  a603=(a272*a603);
  a514=(a514+a603);
  a430=(a324*a430);
  a514=(a514+a430);
  a222=(a377*a222);
  a514=(a514+a222);
  a614=(a431*a614);
  a514=(a514+a614);
  a352=(a486*a352);
  a514=(a514+a352);
  a352=(a543*a137);
  a406=(a545*a406);
  a352=(a352+a406);
  a623=(a217*a623);
  a352=(a352+a623);
  a023=(a266*a023);
  a352=(a352+a023);
  a608=(a546*a608);
  a352=(a352+a608);
  a425=(a547*a425);
  a352=(a352+a425);
  a541=(a548*a541);
  a352=(a352+a541);
  a323=(a549*a323);
  a352=(a352+a323);
  a070=(a550*a070);
  a352=(a352+a070);
  a075=(a075+a352);
  a352=(a621*a075);
  a070=(a543*a571);
  a544=(a545*a544);
  a070=(a070+a544);
  a596=(a217*a596);
  a070=(a070+a596);
  a010=(a266*a010);
  a070=(a070+a010);
  a485=(a546*a485);
  a070=(a070+a485);
  a271=(a547*a271);
  a070=(a070+a271);
  a007=(a548*a007);
  a070=(a070+a007);
  a014=(a549*a014);
  a070=(a070+a014);
  a061=(a550*a061);
  a070=(a070+a061);
  a568=(a568+a070);
  a070=(a042*a568);
  a352=(a352+a070);
  a070=(a064*a250);
  a061=(a615*a371);
  a070=(a070+a061);
  a352=(a352+a070);
  a352=(a542*a352);
  a514=(a514+a352);
  a137=(a137+a514);
  if (res[0]!=0) res[0][10]=a137;
  a590=(a001*a590);
  a032=(a005*a032);
  a590=(a590+a032);
  a622=(a272*a622);
  a590=(a590+a622);
  a611=(a324*a611);
  a590=(a590+a611);
  a595=(a377*a595);
  a590=(a590+a595);
  a376=(a431*a376);
  a590=(a590+a376);
  a461=(a486*a461);
  a590=(a590+a461);
  a075=(a318*a075);
  a568=(a004*a568);
  a075=(a075+a568);
  a250=(a059*a250);
  a371=(a035*a371);
  a250=(a250-a371);
  a075=(a075+a250);
  a075=(a542*a075);
  a590=(a590+a075);
  a571=(a571+a590);
  if (res[0]!=0) res[0][11]=a571;
  a571=arg[0]? arg[0][12] : 0;
  a590=arg[0]? arg[0][14] : 0;
  a075=(a001*a590);
  a069=(a069*a571);
  a250=arg[0]? arg[0][13] : 0;
  a043=(a043*a250);
  a069=(a069+a043);
  a048=(a048*a590);
  a043=arg[0]? arg[0][15] : 0;
  a058=(a058*a043);
  a048=(a048+a058);
  a069=(a069+a048);
  a048=(a006*a069);
  a058=(a079*a590);
  a371=(a082*a069);
  a568=(a085*a590);
  a568=(a571+a568);
  a135=(a135*a568);
  a461=(a085*a043);
  a461=(a250+a461);
  a121=(a121*a461);
  a135=(a135+a121);
  a121=(a085*a069);
  a121=(a590+a121);
  a093=(a093*a121);
  a017=(a017*a571);
  a018=(a018*a250);
  a017=(a017+a018);
  a009=(a009*a590);
  a040=(a040*a043);
  a009=(a009-a040);
  a017=(a017+a009);
  a085=(a085*a017);
  a085=(a043+a085);
  a128=(a128*a085);
  a093=(a093+a128);
  a135=(a135+a093);
  a135=(a084*a135);
  a371=(a371+a135);
  a371=(a590+a371);
  a135=(a081*a371);
  a058=(a058+a135);
  a058=(a571+a058);
  a220=(a220*a058);
  a135=(a079*a043);
  a093=(a082*a017);
  a099=(a099*a568);
  a100=(a100*a461);
  a099=(a099+a100);
  a131=(a131*a121);
  a119=(a119*a085);
  a131=(a131-a119);
  a099=(a099+a131);
  a099=(a084*a099);
  a093=(a093+a099);
  a093=(a043+a093);
  a099=(a081*a093);
  a135=(a135+a099);
  a135=(a250+a135);
  a206=(a206*a135);
  a220=(a220+a206);
  a206=(a079*a069);
  a099=(a082*a590);
  a121=(a084*a121);
  a099=(a099+a121);
  a099=(a571+a099);
  a149=(a149*a099);
  a082=(a082*a043);
  a084=(a084*a085);
  a082=(a082+a084);
  a082=(a250+a082);
  a173=(a173*a082);
  a149=(a149+a173);
  a155=(a155*a371);
  a152=(a152*a093);
  a155=(a155+a152);
  a149=(a149+a155);
  a155=(a081*a149);
  a206=(a206+a155);
  a206=(a590+a206);
  a105=(a105*a206);
  a079=(a079*a017);
  a159=(a159*a099);
  a132=(a132*a082);
  a159=(a159+a132);
  a136=(a136*a371);
  a171=(a171*a093);
  a136=(a136-a171);
  a159=(a159+a136);
  a081=(a081*a159);
  a079=(a079+a081);
  a079=(a043+a079);
  a213=(a213*a079);
  a105=(a105+a213);
  a220=(a220+a105);
  a105=(a078*a220);
  a048=(a048+a105);
  a105=(a224*a590);
  a371=(a226*a371);
  a105=(a105+a371);
  a371=(a091*a206);
  a105=(a105+a371);
  a105=(a571+a105);
  a269=(a269*a105);
  a371=(a224*a043);
  a093=(a226*a093);
  a371=(a371+a093);
  a093=(a091*a079);
  a371=(a371+a093);
  a371=(a250+a371);
  a255=(a255*a371);
  a269=(a269+a255);
  a255=(a224*a069);
  a149=(a226*a149);
  a255=(a255+a149);
  a149=(a091*a220);
  a255=(a255+a149);
  a255=(a590+a255);
  a265=(a265*a255);
  a224=(a224*a017);
  a226=(a226*a159);
  a224=(a224+a226);
  a183=(a183*a058);
  a185=(a185*a135);
  a183=(a183+a185);
  a113=(a113*a206);
  a204=(a204*a079);
  a113=(a113-a204);
  a183=(a183+a113);
  a091=(a091*a183);
  a224=(a224+a091);
  a224=(a043+a224);
  a262=(a262*a224);
  a265=(a265+a262);
  a269=(a269+a265);
  a265=(a223*a269);
  a048=(a048+a265);
  a048=(a590+a048);
  a265=(a005*a048);
  a075=(a075+a265);
  a265=(a273*a069);
  a262=(a275*a220);
  a265=(a265+a262);
  a262=(a276*a269);
  a265=(a265+a262);
  a262=(a006*a590);
  a091=(a078*a206);
  a262=(a262+a091);
  a091=(a223*a255);
  a262=(a262+a091);
  a262=(a571+a262);
  a321=(a321*a262);
  a091=(a006*a043);
  a113=(a078*a079);
  a091=(a091+a113);
  a113=(a223*a224);
  a091=(a091+a113);
  a091=(a250+a091);
  a307=(a307*a091);
  a321=(a321+a307);
  a279=(a279*a048);
  a006=(a006*a017);
  a078=(a078*a183);
  a006=(a006+a078);
  a233=(a233*a105);
  a168=(a168*a371);
  a233=(a233+a168);
  a216=(a216*a255);
  a253=(a253*a224);
  a216=(a216-a253);
  a233=(a233+a216);
  a223=(a223*a233);
  a006=(a006+a223);
  a006=(a043+a006);
  a314=(a314*a006);
  a279=(a279+a314);
  a321=(a321+a279);
  a279=(a277*a321);
  a265=(a265+a279);
  a265=(a590+a265);
  a279=(a272*a265);
  a075=(a075+a279);
  a279=(a325*a069);
  a314=(a327*a220);
  a279=(a279+a314);
  a314=(a328*a269);
  a279=(a279+a314);
  a314=(a329*a321);
  a279=(a279+a314);
  a314=(a273*a590);
  a223=(a275*a206);
  a314=(a314+a223);
  a223=(a276*a255);
  a314=(a314+a223);
  a223=(a277*a048);
  a314=(a314+a223);
  a314=(a571+a314);
  a374=(a374*a314);
  a223=(a273*a043);
  a216=(a275*a079);
  a223=(a223+a216);
  a216=(a276*a224);
  a223=(a223+a216);
  a216=(a277*a006);
  a223=(a223+a216);
  a223=(a250+a223);
  a360=(a360*a223);
  a374=(a374+a360);
  a332=(a332*a265);
  a273=(a273*a017);
  a275=(a275*a183);
  a273=(a273+a275);
  a276=(a276*a233);
  a273=(a273+a276);
  a285=(a285*a262);
  a286=(a286*a091);
  a285=(a285+a286);
  a317=(a317*a048);
  a305=(a305*a006);
  a317=(a317-a305);
  a285=(a285+a317);
  a277=(a277*a285);
  a273=(a273+a277);
  a273=(a043+a273);
  a367=(a367*a273);
  a332=(a332+a367);
  a374=(a374+a332);
  a332=(a330*a374);
  a279=(a279+a332);
  a279=(a590+a279);
  a332=(a324*a279);
  a075=(a075+a332);
  a332=(a378*a069);
  a367=(a380*a220);
  a332=(a332+a367);
  a367=(a381*a269);
  a332=(a332+a367);
  a367=(a382*a321);
  a332=(a332+a367);
  a367=(a383*a374);
  a332=(a332+a367);
  a367=(a325*a590);
  a277=(a327*a206);
  a367=(a367+a277);
  a277=(a328*a255);
  a367=(a367+a277);
  a277=(a329*a048);
  a367=(a367+a277);
  a277=(a330*a265);
  a367=(a367+a277);
  a367=(a571+a367);
  a428=(a428*a367);
  a277=(a325*a043);
  a317=(a327*a079);
  a277=(a277+a317);
  a317=(a328*a224);
  a277=(a277+a317);
  a317=(a329*a006);
  a277=(a277+a317);
  a317=(a330*a273);
  a277=(a277+a317);
  a277=(a250+a277);
  a414=(a414*a277);
  a428=(a428+a414);
  a386=(a386*a279);
  a325=(a325*a017);
  a327=(a327*a183);
  a325=(a325+a327);
  a328=(a328*a233);
  a325=(a325+a328);
  a329=(a329*a285);
  a325=(a325+a329);
  a338=(a338*a314);
  a339=(a339*a223);
  a338=(a338+a339);
  a370=(a370*a265);
  a358=(a358*a273);
  a370=(a370-a358);
  a338=(a338+a370);
  a330=(a330*a338);
  a325=(a325+a330);
  a325=(a043+a325);
  a421=(a421*a325);
  a386=(a386+a421);
  a428=(a428+a386);
  a386=(a384*a428);
  a332=(a332+a386);
  a332=(a590+a332);
  a386=(a377*a332);
  a075=(a075+a386);
  a386=(a432*a069);
  a421=(a434*a220);
  a386=(a386+a421);
  a421=(a435*a269);
  a386=(a386+a421);
  a421=(a436*a321);
  a386=(a386+a421);
  a421=(a437*a374);
  a386=(a386+a421);
  a421=(a438*a428);
  a386=(a386+a421);
  a421=(a378*a590);
  a330=(a380*a206);
  a421=(a421+a330);
  a330=(a381*a255);
  a421=(a421+a330);
  a330=(a382*a048);
  a421=(a421+a330);
  a330=(a383*a265);
  a421=(a421+a330);
  a330=(a384*a279);
  a421=(a421+a330);
  a421=(a571+a421);
  a483=(a483*a421);
  a330=(a378*a043);
  a370=(a380*a079);
  a330=(a330+a370);
  a370=(a381*a224);
  a330=(a330+a370);
  a370=(a382*a006);
  a330=(a330+a370);
  a370=(a383*a273);
  a330=(a330+a370);
  a370=(a384*a325);
  a330=(a330+a370);
  a330=(a250+a330);
  a469=(a469*a330);
  a483=(a483+a469);
  a441=(a441*a332);
  a378=(a378*a017);
  a380=(a380*a183);
  a378=(a378+a380);
  a381=(a381*a233);
  a378=(a378+a381);
  a382=(a382*a285);
  a378=(a378+a382);
  a383=(a383*a338);
  a378=(a378+a383);
  a392=(a392*a367);
  a393=(a393*a277);
  a392=(a392+a393);
  a424=(a424*a279);
  a412=(a412*a325);
  a424=(a424-a412);
  a392=(a392+a424);
  a384=(a384*a392);
  a378=(a378+a384);
  a378=(a043+a378);
  a476=(a476*a378);
  a441=(a441+a476);
  a483=(a483+a441);
  a441=(a439*a483);
  a386=(a386+a441);
  a386=(a590+a386);
  a441=(a431*a386);
  a075=(a075+a441);
  a441=(a487*a069);
  a476=(a489*a220);
  a441=(a441+a476);
  a476=(a490*a269);
  a441=(a441+a476);
  a476=(a491*a321);
  a441=(a441+a476);
  a476=(a492*a374);
  a441=(a441+a476);
  a476=(a493*a428);
  a441=(a441+a476);
  a476=(a494*a483);
  a441=(a441+a476);
  a476=(a432*a590);
  a384=(a434*a206);
  a476=(a476+a384);
  a384=(a435*a255);
  a476=(a476+a384);
  a384=(a436*a048);
  a476=(a476+a384);
  a384=(a437*a265);
  a476=(a476+a384);
  a384=(a438*a279);
  a476=(a476+a384);
  a384=(a439*a332);
  a476=(a476+a384);
  a476=(a571+a476);
  a539=(a539*a476);
  a384=(a432*a043);
  a424=(a434*a079);
  a384=(a384+a424);
  a424=(a435*a224);
  a384=(a384+a424);
  a424=(a436*a006);
  a384=(a384+a424);
  a424=(a437*a273);
  a384=(a384+a424);
  a424=(a438*a325);
  a384=(a384+a424);
  a424=(a439*a378);
  a384=(a384+a424);
  a384=(a250+a384);
  a525=(a525*a384);
  a539=(a539+a525);
  a497=(a497*a386);
  a432=(a432*a017);
  a434=(a434*a183);
  a432=(a432+a434);
  a435=(a435*a233);
  a432=(a432+a435);
  a436=(a436*a285);
  a432=(a432+a436);
  a437=(a437*a338);
  a432=(a432+a437);
  a438=(a438*a392);
  a432=(a432+a438);
  a447=(a447*a421);
  a448=(a448*a330);
  a447=(a447+a448);
  a479=(a479*a332);
  a467=(a467*a378);
  a479=(a479-a467);
  a447=(a447+a479);
  a439=(a439*a447);
  a432=(a432+a439);
  a432=(a043+a432);
  a532=(a532*a432);
  a497=(a497+a532);
  a539=(a539+a497);
  a497=(a495*a539);
  a441=(a441+a497);
  a441=(a590+a441);
  a497=(a486*a441);
  a075=(a075+a497);
  a497=(a543*a069);
  a220=(a545*a220);
  a497=(a497+a220);
  a269=(a217*a269);
  a497=(a497+a269);
  a269=(a266*a321);
  a497=(a497+a269);
  a269=(a546*a374);
  a497=(a497+a269);
  a269=(a547*a428);
  a497=(a497+a269);
  a269=(a548*a483);
  a497=(a497+a269);
  a269=(a549*a539);
  a497=(a497+a269);
  a269=(a487*a590);
  a220=(a489*a206);
  a269=(a269+a220);
  a220=(a490*a255);
  a269=(a269+a220);
  a220=(a491*a048);
  a269=(a269+a220);
  a220=(a492*a265);
  a269=(a269+a220);
  a220=(a493*a279);
  a269=(a269+a220);
  a220=(a494*a332);
  a269=(a269+a220);
  a220=(a495*a386);
  a269=(a269+a220);
  a269=(a571+a269);
  a593=(a593*a269);
  a220=(a487*a043);
  a532=(a489*a079);
  a220=(a220+a532);
  a532=(a490*a224);
  a220=(a220+a532);
  a532=(a491*a006);
  a220=(a220+a532);
  a532=(a492*a273);
  a220=(a220+a532);
  a532=(a493*a325);
  a220=(a220+a532);
  a532=(a494*a378);
  a220=(a220+a532);
  a532=(a495*a432);
  a220=(a220+a532);
  a220=(a250+a220);
  a579=(a579*a220);
  a593=(a593+a579);
  a551=(a551*a441);
  a487=(a487*a017);
  a489=(a489*a183);
  a487=(a487+a489);
  a490=(a490*a233);
  a487=(a487+a490);
  a491=(a491*a285);
  a487=(a487+a491);
  a492=(a492*a338);
  a487=(a487+a492);
  a493=(a493*a392);
  a487=(a487+a493);
  a494=(a494*a447);
  a487=(a487+a494);
  a503=(a503*a476);
  a504=(a504*a384);
  a503=(a503+a504);
  a535=(a535*a386);
  a523=(a523*a432);
  a535=(a535-a523);
  a503=(a503+a535);
  a495=(a495*a503);
  a487=(a487+a495);
  a487=(a043+a487);
  a586=(a586*a487);
  a551=(a551+a586);
  a593=(a593+a551);
  a551=(a550*a593);
  a497=(a497+a551);
  a497=(a590+a497);
  a551=(a542*a497);
  a075=(a075+a551);
  a075=(a571+a075);
  if (res[0]!=0) res[0][12]=a075;
  a075=(a001*a043);
  a551=(a005*a006);
  a075=(a075+a551);
  a551=(a272*a273);
  a075=(a075+a551);
  a551=(a324*a325);
  a075=(a075+a551);
  a551=(a377*a378);
  a075=(a075+a551);
  a551=(a431*a432);
  a075=(a075+a551);
  a551=(a486*a487);
  a075=(a075+a551);
  a551=(a543*a017);
  a183=(a545*a183);
  a551=(a551+a183);
  a233=(a217*a233);
  a551=(a551+a233);
  a233=(a266*a285);
  a551=(a551+a233);
  a233=(a546*a338);
  a551=(a551+a233);
  a233=(a547*a392);
  a551=(a551+a233);
  a233=(a548*a447);
  a551=(a551+a233);
  a233=(a549*a503);
  a551=(a551+a233);
  a557=(a557*a269);
  a558=(a558*a220);
  a557=(a557+a558);
  a589=(a589*a441);
  a577=(a577*a487);
  a589=(a589-a577);
  a557=(a557+a589);
  a589=(a550*a557);
  a551=(a551+a589);
  a551=(a043+a551);
  a589=(a542*a551);
  a075=(a075+a589);
  a075=(a250+a075);
  if (res[0]!=0) res[0][13]=a075;
  a069=(a001*a069);
  a321=(a005*a321);
  a069=(a069+a321);
  a374=(a272*a374);
  a069=(a069+a374);
  a428=(a324*a428);
  a069=(a069+a428);
  a483=(a377*a483);
  a069=(a069+a483);
  a539=(a431*a539);
  a069=(a069+a539);
  a593=(a486*a593);
  a069=(a069+a593);
  a593=(a543*a590);
  a206=(a545*a206);
  a593=(a593+a206);
  a255=(a217*a255);
  a593=(a593+a255);
  a048=(a266*a048);
  a593=(a593+a048);
  a265=(a546*a265);
  a593=(a593+a265);
  a279=(a547*a279);
  a593=(a593+a279);
  a332=(a548*a332);
  a593=(a593+a332);
  a386=(a549*a386);
  a593=(a593+a386);
  a441=(a550*a441);
  a593=(a593+a441);
  a571=(a571+a593);
  a621=(a621*a571);
  a543=(a543*a043);
  a545=(a545*a079);
  a543=(a543+a545);
  a217=(a217*a224);
  a543=(a543+a217);
  a266=(a266*a006);
  a543=(a543+a266);
  a546=(a546*a273);
  a543=(a543+a546);
  a547=(a547*a325);
  a543=(a543+a547);
  a548=(a548*a378);
  a543=(a543+a548);
  a549=(a549*a432);
  a543=(a543+a549);
  a550=(a550*a487);
  a543=(a543+a550);
  a250=(a250+a543);
  a042=(a042*a250);
  a621=(a621+a042);
  a064=(a064*a497);
  a615=(a615*a551);
  a064=(a064+a615);
  a621=(a621+a064);
  a621=(a542*a621);
  a069=(a069+a621);
  a590=(a590+a069);
  if (res[0]!=0) res[0][14]=a590;
  a001=(a001*a017);
  a005=(a005*a285);
  a001=(a001+a005);
  a272=(a272*a338);
  a001=(a001+a272);
  a324=(a324*a392);
  a001=(a001+a324);
  a377=(a377*a447);
  a001=(a001+a377);
  a431=(a431*a503);
  a001=(a001+a431);
  a486=(a486*a557);
  a001=(a001+a486);
  a318=(a318*a571);
  a004=(a004*a250);
  a318=(a318+a004);
  a059=(a059*a497);
  a035=(a035*a551);
  a059=(a059-a035);
  a318=(a318+a059);
  a542=(a542*a318);
  a001=(a001+a542);
  a043=(a043+a001);
  if (res[0]!=0) res[0][15]=a043;
  return 0;
}

/* variational_steps:(y[4x4],t,turns[2x12],h,p[7])->(y_end[4x4]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+625, w1, *w2=w+641, *w3=w+648, w5, *w6=w+650, w7;
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
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
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
  casadi_copy(w0, 16, res[0]);
  return 0;
}

/* landing_with_derivative:(y[4x4],z[3],T,p[7])->(J[4x4],R[4]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61;
  a00=arg[0]? arg[0][4] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[0]? arg[0][2] : 0;
  a04=arg[3]? arg[3][5] : 0;
  a05=arg[3]? arg[3][1] : 0;
  a06=arg[0]? arg[0][0] : 0;
  a07=sin(a06);
  a08=(-a07);
  a08=(2.*a08);
  a08=(a05*a08);
  a08=(a04*a08);
  a09=arg[3]? arg[3][0] : 0;
  a10=(a09*a07);
  a11=(a04*a10);
  a08=(a08-a11);
  a11=arg[0]? arg[0][1] : 0;
  a12=(a06-a11);
  a13=sin(a12);
  a14=(a09*a13);
  a14=(a04*a14);
  a08=(a08-a14);
  a15=arg[3]? arg[3][3] : 0;
  a16=(a15*a05);
  a17=(-a13);
  a17=(2.*a17);
  a17=(a04*a17);
  a18=(a16*a17);
  a08=(a08-a18);
  a18=(a05*a17);
  a08=(a08+a18);
  a18=(2.*a05);
  a19=arg[3]? arg[3][4] : 0;
  a20=(a19*a04);
  a21=cos(a12);
  a22=(a20*a21);
  a23=(a18*a22);
  a08=(a08+a23);
  a24=cos(a06);
  a25=(a20*a24);
  a26=(a18*a25);
  a08=(a08+a26);
  a26=(a15*a07);
  a26=(a04*a26);
  a27=(a18*a26);
  a08=(a08+a27);
  a08=(a02*a08);
  a27=arg[0]? arg[0][3] : 0;
  a28=(a15*a13);
  a29=(a27*a28);
  a29=(a05*a29);
  a29=(a04*a29);
  a08=(a08-a29);
  a30=(a27*a05);
  a31=(a30*a22);
  a08=(a08-a31);
  a32=(2.*a21);
  a32=(a32*a04);
  a33=(a09*a32);
  a33=(a33+a09);
  a34=casadi_sq(a04);
  a35=(a21*a15);
  a36=(a35*a04);
  a37=(a34-a36);
  a37=(a37-a15);
  a37=(a37+a32);
  a38=(a20*a13);
  a37=(a37+a38);
  a20=(a20*a07);
  a39=(a24*a15);
  a39=(a39*a04);
  a40=(a20-a39);
  a41=casadi_sq(a15);
  a42=casadi_sq(a19);
  a43=(a41+a42);
  a44=(a40+a43);
  a37=(a37+a44);
  a45=sin(a11);
  a46=(a19*a45);
  a47=cos(a11);
  a48=(a47*a15);
  a49=(a46-a48);
  a37=(a37+a49);
  a37=(a37+a03);
  a37=(a18*a37);
  a33=(a33+a37);
  a37=(a09*a04);
  a50=(a37*a04);
  a51=arg[3]? arg[3][2] : 0;
  a52=(2.*a51);
  a53=(a50+a52);
  a33=(a33+a53);
  a54=(a08/a33);
  a55=(a35*a27);
  a55=(a55*a05);
  a55=(a55*a04);
  a56=(a41*a27);
  a56=(a56*a05);
  a55=(a55-a56);
  a56=(a15*a27);
  a57=(a56*a05);
  a55=(a55+a57);
  a57=(a42*a27);
  a57=(a57*a05);
  a55=(a55-a57);
  a57=(a24*a09);
  a57=(a57*a04);
  a58=(2.*a24);
  a59=(a58*a05);
  a59=(a59*a04);
  a57=(a57+a59);
  a59=(a21*a09);
  a59=(a59*a04);
  a57=(a57+a59);
  a59=(2.*a47);
  a60=(a59*a15);
  a60=(a60*a05);
  a57=(a57-a60);
  a60=(a47*a09);
  a57=(a57+a60);
  a59=(a59*a05);
  a57=(a57+a59);
  a59=(2.*a15);
  a60=(a59*a15);
  a60=(a60*a05);
  a57=(a57+a60);
  a60=(a16*a32);
  a57=(a57-a60);
  a59=(a59*a05);
  a57=(a57-a59);
  a59=(2.*a19);
  a59=(a59*a19);
  a59=(a59*a05);
  a57=(a57+a59);
  a59=(a18*a04);
  a59=(a59*a04);
  a57=(a57+a59);
  a32=(a05*a32);
  a57=(a57+a32);
  a32=(a18*a38);
  a57=(a57+a32);
  a20=(a18*a20);
  a57=(a57+a20);
  a39=(a18*a39);
  a57=(a57-a39);
  a57=(a57+a53);
  a53=(a02*a57);
  a55=(a55+a53);
  a53=(a27*a51);
  a55=(a55-a53);
  a30=(a30*a38);
  a55=(a55-a30);
  a30=(a55/a33);
  a53=(a30/a33);
  a39=(a09*a17);
  a28=(a04*a28);
  a17=(a28+a17);
  a17=(a17+a22);
  a25=(a25+a26);
  a17=(a17+a25);
  a17=(a18*a17);
  a39=(a39+a17);
  a17=(a53*a39);
  a54=(a54-a17);
  a17=(a15-a44);
  a17=(a05*a17);
  a17=(a17-a51);
  a26=(a02*a17);
  a44=(a44+a49);
  a44=(a05*a44);
  a44=(a51+a44);
  a49=(a44/a33);
  a20=(a49*a55);
  a26=(a26+a20);
  a20=(a05*a43);
  a20=(a51+a20);
  a32=(a44*a49);
  a32=(a20-a32);
  a26=(a26/a32);
  a25=(a05*a25);
  a59=(a25/a33);
  a60=(a49/a33);
  a39=(a60*a39);
  a59=(a59-a39);
  a39=(a26*a59);
  a61=(a55*a59);
  a08=(a49*a08);
  a61=(a61+a08);
  a08=(a02*a25);
  a61=(a61-a08);
  a61=(a61/a32);
  a08=(a26/a32);
  a25=(a49*a25);
  a59=(a44*a59);
  a25=(a25+a59);
  a25=(a08*a25);
  a61=(a61+a25);
  a25=(a49*a61);
  a39=(a39+a25);
  a54=(a54+a39);
  a39=(a54*a00);
  a25=(-a45);
  a25=(2.*a25);
  a59=(a15*a25);
  a59=(a05*a59);
  a14=(a14-a59);
  a59=(a09*a45);
  a14=(a14-a59);
  a25=(a05*a25);
  a14=(a14+a25);
  a25=(2.*a13);
  a25=(a04*a25);
  a59=(a16*a25);
  a14=(a14-a59);
  a59=(a05*a25);
  a14=(a14+a59);
  a14=(a14-a23);
  a14=(a02*a14);
  a29=(a29+a14);
  a29=(a29+a31);
  a31=(a29/a33);
  a14=(a09*a25);
  a25=(a25-a28);
  a25=(a25-a22);
  a22=(a19*a47);
  a28=(a15*a45);
  a22=(a22+a28);
  a25=(a25+a22);
  a25=(a18*a25);
  a14=(a14+a25);
  a53=(a53*a14);
  a31=(a31-a53);
  a22=(a05*a22);
  a53=(a22/a33);
  a60=(a60*a14);
  a53=(a53-a60);
  a60=(a26*a53);
  a55=(a55*a53);
  a29=(a49*a29);
  a55=(a55+a29);
  a55=(a55/a32);
  a22=(a49*a22);
  a44=(a44*a53);
  a22=(a22+a44);
  a08=(a08*a22);
  a55=(a55+a08);
  a08=(a49*a55);
  a60=(a60+a08);
  a31=(a31+a60);
  a60=(a31*a01);
  a39=(a39+a60);
  a60=(a57/a33);
  a57=(a49*a57);
  a17=(a17+a57);
  a17=(a17/a32);
  a57=(a49*a17);
  a60=(a60+a57);
  a57=arg[0]? arg[0][6] : 0;
  a08=(a60*a57);
  a39=(a39+a08);
  a35=(a05*a35);
  a35=(a04*a35);
  a08=(a05*a41);
  a35=(a35-a08);
  a08=(a05*a15);
  a35=(a35+a08);
  a08=(a05*a42);
  a35=(a35-a08);
  a35=(a35-a51);
  a08=(a38*a05);
  a35=(a35-a08);
  a33=(a35/a33);
  a35=(a49*a35);
  a35=(a35/a32);
  a32=(a49*a35);
  a33=(a33+a32);
  a32=arg[0]? arg[0][7] : 0;
  a08=(a33*a32);
  a39=(a39+a08);
  if (res[0]!=0) res[0][1]=a39;
  a39=(a61*a00);
  a08=(a55*a01);
  a39=(a39+a08);
  a57=(a17*a57);
  a39=(a39+a57);
  a32=(a35*a32);
  a39=(a39+a32);
  if (res[0]!=0) res[0][2]=a39;
  a39=-2.;
  a00=(a39*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a32=(a00-a01);
  if (res[0]!=0) res[0][4]=a32;
  a32=(a54*a00);
  a57=(a31*a01);
  a32=(a32+a57);
  a57=arg[0]? arg[0][10] : 0;
  a08=(a60*a57);
  a32=(a32+a08);
  a08=arg[0]? arg[0][11] : 0;
  a22=(a33*a08);
  a32=(a32+a22);
  a32=(a32-a03);
  if (res[0]!=0) res[0][5]=a32;
  a32=(a61*a00);
  a22=(a55*a01);
  a32=(a32+a22);
  a57=(a17*a57);
  a32=(a32+a57);
  a08=(a35*a08);
  a32=(a32+a08);
  if (res[0]!=0) res[0][6]=a32;
  a00=(a39*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a32=(a00-a01);
  if (res[0]!=0) res[0][8]=a32;
  a32=(a54*a00);
  a08=(a31*a01);
  a32=(a32+a08);
  a08=arg[0]? arg[0][14] : 0;
  a57=(a60*a08);
  a32=(a32+a57);
  a57=arg[0]? arg[0][15] : 0;
  a22=(a33*a57);
  a32=(a32+a22);
  if (res[0]!=0) res[0][9]=a32;
  a32=(a61*a00);
  a22=(a55*a01);
  a32=(a32+a22);
  a08=(a17*a08);
  a32=(a32+a08);
  a57=(a35*a57);
  a32=(a32+a57);
  a32=(a32-a03);
  if (res[0]!=0) res[0][10]=a32;
  a00=(a39*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=(a02-a27);
  if (res[0]!=0) res[0][12]=a00;
  a54=(a54*a02);
  a31=(a31*a27);
  a54=(a54+a31);
  a56=(a56*a27);
  a56=(a56*a05);
  a56=(a56*a45);
  a47=(a47*a19);
  a45=casadi_sq(a27);
  a45=(a45*a05);
  a31=(a47*a45);
  a56=(a56-a31);
  a31=casadi_sq(a02);
  a00=(a31*a04);
  a24=(a24*a19);
  a24=(a24*a05);
  a21=(a21*a19);
  a01=(a21*a05);
  a24=(a24+a01);
  a01=(a16*a07);
  a24=(a24+a01);
  a16=(a16*a13);
  a24=(a24+a16);
  a24=(a24-a10);
  a07=(a18*a07);
  a24=(a24-a07);
  a00=(a00*a24);
  a56=(a56-a00);
  a00=(2.*a02);
  a00=(a00*a27);
  a00=(a00*a05);
  a47=(a47-a28);
  a21=(a21*a04);
  a28=(a47+a21);
  a24=(a15*a04);
  a24=(a24*a13);
  a28=(a28+a24);
  a00=(a00*a28);
  a56=(a56+a00);
  a00=arg[3]? arg[3][6] : 0;
  a28=sin(a00);
  a37=(a37*a28);
  a56=(a56-a37);
  a37=(a06-a00);
  a13=sin(a37);
  a07=(a09*a13);
  a56=(a56+a07);
  a37=cos(a37);
  a37=(a37*a19);
  a07=(a15*a13);
  a37=(a37+a07);
  a07=(2.*a04);
  a07=(a07*a28);
  a37=(a37+a07);
  a13=(2.*a13);
  a37=(a37-a13);
  a13=(a11-a06);
  a13=(a13+a00);
  a00=cos(a13);
  a00=(a00*a19);
  a13=sin(a13);
  a13=(a15*a13);
  a00=(a00-a13);
  a37=(a37+a00);
  a37=(a05*a37);
  a56=(a56-a37);
  a21=(a45*a21);
  a56=(a56-a21);
  a45=(a45*a24);
  a56=(a56-a45);
  a58=(a58*a04);
  a04=(a09*a58);
  a50=(a50+a04);
  a50=(a50+a09);
  a50=(a50+a52);
  a40=(a40-a48);
  a40=(a40-a15);
  a40=(a40-a46);
  a40=(a40+a34);
  a40=(a40+a58);
  a40=(a40+a38);
  a40=(a40-a36);
  a40=(a40+a43);
  a40=(a40+a03);
  a18=(a18*a40);
  a50=(a50+a18);
  a18=(a56/a50);
  a48=(a48-a41);
  a48=(a48-a42);
  a48=(a48+a46);
  a48=(a48-a38);
  a48=(a48+a36);
  a48=(a05*a48);
  a48=(a48-a51);
  a50=(a48/a50);
  a31=(a31*a47);
  a00=(a00-a31);
  a05=(a05*a00);
  a56=(a50*a56);
  a05=(a05-a56);
  a48=(a48*a50);
  a20=(a20-a48);
  a05=(a05/a20);
  a50=(a50*a05);
  a18=(a18-a50);
  a60=(a60*a18);
  a54=(a54+a60);
  a33=(a33*a05);
  a54=(a54+a33);
  if (res[0]!=0) res[0][13]=a54;
  a61=(a61*a02);
  a55=(a55*a27);
  a61=(a61+a55);
  a17=(a17*a18);
  a61=(a61+a17);
  a35=(a35*a05);
  a61=(a61+a35);
  if (res[0]!=0) res[0][14]=a61;
  a39=(a39*a02);
  a39=(a39+a27);
  if (res[0]!=0) res[0][15]=a39;
  a39=arg[1]? arg[1][0] : 0;
  a12=(a12-a39);
  if (res[1]!=0) res[1][0]=a12;
  a49=(a49*a26);
  a30=(a30+a49);
  a49=arg[1]? arg[1][1] : 0;
  a30=(a30-a49);
  if (res[1]!=0) res[1][1]=a30;
  a30=arg[1]? arg[1][2] : 0;
  a26=(a26-a30);
  if (res[1]!=0) res[1][2]=a26;
  a06=(2.*a06);
  a11=(a11-a06);
  if (res[1]!=0) res[1][3]=a11;
  return 0;
}

/* round_feet_jacobian_12:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @10 = variational_steps(@5, @6, @9, @8, @2) */
  arg1[0]=w05;
  arg1[1]=(&w06);
  arg1[2]=w09;
  arg1[3]=(&w08);
  arg1[4]=w02;
  res1[0]=w10;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #11: {@5, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w05;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #12: output[0][0] = @5 */
  casadi_copy(w05, 16, res[0]);
  /* #13: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* newton_12:(u0[4],p[7])->(u[4]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f2(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* plain_step:(y[4],phase[2],turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  a07=arg[4]? arg[4][3] : 0;
  a08=arg[0]? arg[0][3] : 0;
  a09=(a07*a08);
  a09=(a09*a08);
  a10=arg[4]? arg[4][1] : 0;
  a09=(a09*a10);
  a11=arg[0]? arg[0][1] : 0;
  a12=sin(a11);
  a09=(a09*a12);
  a13=cos(a11);
  a14=arg[4]? arg[4][4] : 0;
  a15=(a13*a14);
  a16=casadi_sq(a08);
  a16=(a16*a10);
  a17=(a15*a16);
  a09=(a09-a17);
  a17=casadi_sq(a03);
  a18=arg[4]? arg[4][5] : 0;
  a19=(a17*a18);
  a20=cos(a00);
  a21=(a20*a14);
  a21=(a21*a10);
  a22=(a20*a13);
  a23=sin(a00);
  a24=(a23*a12);
  a22=(a22+a24);
  a24=(a22*a14);
  a25=(a24*a10);
  a21=(a21+a25);
  a25=(a07*a10);
  a26=(a25*a23);
  a21=(a21+a26);
  a26=(a23*a13);
  a27=(a20*a12);
  a26=(a26-a27);
  a27=(a25*a26);
  a21=(a21+a27);
  a27=arg[4]? arg[4][0] : 0;
  a28=(a27*a23);
  a21=(a21-a28);
  a28=(2.*a10);
  a29=(a28*a23);
  a21=(a21-a29);
  a19=(a19*a21);
  a09=(a09-a19);
  a19=(2.*a03);
  a19=(a19*a08);
  a19=(a19*a10);
  a21=(a07*a12);
  a15=(a15-a21);
  a24=(a24*a18);
  a21=(a15+a24);
  a29=(a07*a18);
  a30=(a29*a26);
  a21=(a21+a30);
  a19=(a19*a21);
  a09=(a09+a19);
  a19=(a27*a18);
  a21=arg[4]? arg[4][6] : 0;
  a31=sin(a21);
  a32=(a19*a31);
  a09=(a09-a32);
  a33=cos(a21);
  a34=(a23*a33);
  a35=(a20*a31);
  a34=(a34-a35);
  a35=(a27*a34);
  a09=(a09+a35);
  a35=(a20*a33);
  a36=(a23*a31);
  a35=(a35+a36);
  a35=(a35*a14);
  a36=(a07*a34);
  a35=(a35+a36);
  a36=(2.*a18);
  a36=(a36*a31);
  a35=(a35+a36);
  a34=(2.*a34);
  a35=(a35-a34);
  a34=(a11-a00);
  a34=(a34+a21);
  a37=cos(a34);
  a37=(a37*a14);
  a34=sin(a34);
  a34=(a07*a34);
  a37=(a37-a34);
  a35=(a35+a37);
  a35=(a10*a35);
  a09=(a09-a35);
  a24=(a16*a24);
  a09=(a09-a24);
  a16=(a16*a30);
  a09=(a09-a16);
  a19=(a19*a18);
  a16=(2.*a20);
  a16=(a16*a18);
  a30=(a27*a16);
  a30=(a19+a30);
  a30=(a30+a27);
  a24=arg[4]? arg[4][2] : 0;
  a35=(2.*a24);
  a30=(a30+a35);
  a34=(a14*a18);
  a23=(a34*a23);
  a20=(a20*a07);
  a20=(a20*a18);
  a23=(a23-a20);
  a13=(a13*a07);
  a23=(a23-a13);
  a23=(a23-a07);
  a12=(a14*a12);
  a23=(a23-a12);
  a20=casadi_sq(a18);
  a23=(a23+a20);
  a23=(a23+a16);
  a26=(a34*a26);
  a23=(a23+a26);
  a22=(a22*a07);
  a22=(a22*a18);
  a23=(a23-a22);
  a16=casadi_sq(a07);
  a38=casadi_sq(a14);
  a39=(a16+a38);
  a23=(a23+a39);
  a40=1.;
  a23=(a23+a40);
  a23=(a28*a23);
  a30=(a30+a23);
  a23=(a09/a30);
  a13=(a13-a16);
  a13=(a13-a38);
  a13=(a13+a12);
  a13=(a13-a26);
  a13=(a13+a22);
  a13=(a10*a13);
  a13=(a13-a24);
  a30=(a13/a30);
  a17=(a17*a15);
  a37=(a37-a17);
  a37=(a10*a37);
  a09=(a30*a09);
  a37=(a37-a09);
  a09=(a10*a39);
  a09=(a24+a09);
  a13=(a13*a30);
  a13=(a09-a13);
  a37=(a37/a13);
  a30=(a30*a37);
  a23=(a23-a30);
  a30=(a06*a23);
  a13=1.7082860872947386e-01;
  a13=(a13*a02);
  a17=2.9587585476806851e-02;
  a17=(a17*a02);
  a15=(a17*a37);
  a22=8.8762756430420545e-02;
  a22=(a22*a02);
  a26=1.9725056984537900e-02;
  a26=(a26*a02);
  a12=(a26*a08);
  a41=5.9175170953613701e-02;
  a41=(a41*a02);
  a42=5.2600151958767730e-02;
  a42=(a42*a02);
  a43=(a42*a37);
  a43=(a08+a43);
  a44=(a41*a43);
  a12=(a12+a44);
  a12=(a11+a12);
  a44=(a26*a03);
  a45=(a42*a23);
  a45=(a03+a45);
  a46=(a41*a45);
  a44=(a44+a46);
  a44=(a00+a44);
  a46=(a12-a44);
  a46=(a46+a21);
  a47=cos(a46);
  a47=(a47*a14);
  a46=sin(a46);
  a46=(a07*a46);
  a47=(a47-a46);
  a46=(a26*a23);
  a48=(a07*a43);
  a48=(a48*a43);
  a48=(a48*a10);
  a49=(a42*a08);
  a49=(a11+a49);
  a50=sin(a49);
  a48=(a48*a50);
  a51=cos(a49);
  a52=(a51*a14);
  a53=casadi_sq(a43);
  a53=(a53*a10);
  a54=(a52*a53);
  a48=(a48-a54);
  a54=casadi_sq(a45);
  a55=(a54*a18);
  a42=(a42*a03);
  a42=(a00+a42);
  a56=cos(a42);
  a57=(a56*a14);
  a57=(a57*a10);
  a58=(a56*a51);
  a59=sin(a42);
  a60=(a59*a50);
  a58=(a58+a60);
  a60=(a58*a14);
  a61=(a60*a10);
  a57=(a57+a61);
  a61=(a25*a59);
  a57=(a57+a61);
  a61=(a59*a51);
  a62=(a56*a50);
  a61=(a61-a62);
  a62=(a25*a61);
  a57=(a57+a62);
  a62=(a27*a59);
  a57=(a57-a62);
  a62=(a28*a59);
  a57=(a57-a62);
  a55=(a55*a57);
  a48=(a48-a55);
  a45=(2.*a45);
  a45=(a45*a43);
  a45=(a45*a10);
  a43=(a07*a50);
  a52=(a52-a43);
  a60=(a60*a18);
  a43=(a52+a60);
  a55=(a29*a61);
  a43=(a43+a55);
  a45=(a45*a43);
  a48=(a48+a45);
  a48=(a48-a32);
  a45=(a59*a33);
  a43=(a56*a31);
  a45=(a45-a43);
  a43=(a27*a45);
  a48=(a48+a43);
  a43=(a56*a33);
  a57=(a59*a31);
  a43=(a43+a57);
  a43=(a43*a14);
  a57=(a07*a45);
  a43=(a43+a57);
  a43=(a43+a36);
  a45=(2.*a45);
  a43=(a43-a45);
  a49=(a49-a42);
  a49=(a49+a21);
  a42=cos(a49);
  a42=(a42*a14);
  a49=sin(a49);
  a49=(a07*a49);
  a42=(a42-a49);
  a43=(a43+a42);
  a43=(a10*a43);
  a48=(a48-a43);
  a60=(a53*a60);
  a48=(a48-a60);
  a53=(a53*a55);
  a48=(a48-a53);
  a53=(2.*a56);
  a53=(a53*a18);
  a55=(a27*a53);
  a55=(a19+a55);
  a55=(a55+a27);
  a55=(a55+a35);
  a59=(a34*a59);
  a56=(a56*a07);
  a56=(a56*a18);
  a59=(a59-a56);
  a51=(a51*a07);
  a59=(a59-a51);
  a59=(a59-a07);
  a50=(a14*a50);
  a59=(a59-a50);
  a59=(a59+a20);
  a59=(a59+a53);
  a61=(a34*a61);
  a59=(a59+a61);
  a58=(a58*a07);
  a58=(a58*a18);
  a59=(a59-a58);
  a59=(a59+a39);
  a59=(a59+a40);
  a59=(a28*a59);
  a55=(a55+a59);
  a59=(a48/a55);
  a51=(a51-a16);
  a51=(a51-a38);
  a51=(a51+a50);
  a51=(a51-a61);
  a51=(a51+a58);
  a51=(a10*a51);
  a51=(a51-a24);
  a55=(a51/a55);
  a54=(a54*a52);
  a42=(a42-a54);
  a42=(a10*a42);
  a48=(a55*a48);
  a42=(a42-a48);
  a51=(a51*a55);
  a51=(a09-a51);
  a42=(a42/a51);
  a55=(a55*a42);
  a59=(a59-a55);
  a59=(a41*a59);
  a46=(a46+a59);
  a46=(a03+a46);
  a59=casadi_sq(a46);
  a55=cos(a12);
  a51=(a55*a14);
  a12=sin(a12);
  a48=(a07*a12);
  a48=(a51-a48);
  a54=(a59*a48);
  a54=(a47-a54);
  a54=(a10*a54);
  a52=(a55*a07);
  a58=(a52-a16);
  a58=(a58-a38);
  a61=(a14*a12);
  a58=(a58+a61);
  a50=sin(a44);
  a53=(a50*a55);
  a44=cos(a44);
  a56=(a44*a12);
  a53=(a53-a56);
  a56=(a34*a53);
  a58=(a58-a56);
  a55=(a44*a55);
  a60=(a50*a12);
  a55=(a55+a60);
  a60=(a55*a07);
  a60=(a60*a18);
  a58=(a58+a60);
  a58=(a10*a58);
  a58=(a58-a24);
  a43=(2.*a44);
  a43=(a43*a18);
  a49=(a27*a43);
  a49=(a19+a49);
  a49=(a49+a27);
  a49=(a49+a35);
  a45=(a34*a50);
  a57=(a44*a07);
  a57=(a57*a18);
  a45=(a45-a57);
  a45=(a45-a52);
  a45=(a45-a07);
  a45=(a45-a61);
  a45=(a45+a20);
  a45=(a45+a43);
  a45=(a45+a56);
  a45=(a45-a60);
  a45=(a45+a39);
  a45=(a45+a40);
  a45=(a28*a45);
  a49=(a49+a45);
  a45=(a58/a49);
  a26=(a26*a37);
  a41=(a41*a42);
  a26=(a26+a41);
  a26=(a08+a26);
  a41=(a07*a26);
  a41=(a41*a26);
  a41=(a41*a10);
  a41=(a41*a12);
  a12=casadi_sq(a26);
  a12=(a12*a10);
  a51=(a51*a12);
  a41=(a41-a51);
  a59=(a59*a18);
  a51=(a44*a14);
  a51=(a51*a10);
  a55=(a55*a14);
  a42=(a55*a10);
  a51=(a51+a42);
  a42=(a25*a50);
  a51=(a51+a42);
  a42=(a25*a53);
  a51=(a51+a42);
  a42=(a27*a50);
  a51=(a51-a42);
  a42=(a28*a50);
  a51=(a51-a42);
  a59=(a59*a51);
  a41=(a41-a59);
  a59=(2.*a46);
  a59=(a59*a26);
  a59=(a59*a10);
  a55=(a55*a18);
  a48=(a48+a55);
  a53=(a29*a53);
  a48=(a48+a53);
  a59=(a59*a48);
  a41=(a41+a59);
  a41=(a41-a32);
  a59=(a50*a33);
  a48=(a44*a31);
  a59=(a59-a48);
  a48=(a27*a59);
  a41=(a41+a48);
  a44=(a44*a33);
  a50=(a50*a31);
  a44=(a44+a50);
  a44=(a44*a14);
  a50=(a07*a59);
  a44=(a44+a50);
  a44=(a44+a36);
  a59=(2.*a59);
  a44=(a44-a59);
  a44=(a44+a47);
  a44=(a10*a44);
  a41=(a41-a44);
  a55=(a12*a55);
  a41=(a41-a55);
  a12=(a12*a53);
  a41=(a41-a12);
  a12=(a45*a41);
  a54=(a54-a12);
  a58=(a58*a45);
  a58=(a09-a58);
  a54=(a54/a58);
  a58=(a22*a54);
  a15=(a15+a58);
  a15=(a08+a15);
  a58=(a07*a15);
  a58=(a58*a15);
  a58=(a58*a10);
  a12=(a17*a08);
  a53=(a22*a26);
  a12=(a12+a53);
  a12=(a11+a12);
  a53=sin(a12);
  a58=(a58*a53);
  a55=cos(a12);
  a44=(a55*a14);
  a47=casadi_sq(a15);
  a47=(a47*a10);
  a59=(a44*a47);
  a58=(a58-a59);
  a59=(a17*a23);
  a41=(a41/a49);
  a45=(a45*a54);
  a41=(a41-a45);
  a45=(a22*a41);
  a59=(a59+a45);
  a59=(a03+a59);
  a45=casadi_sq(a59);
  a49=(a45*a18);
  a17=(a17*a03);
  a22=(a22*a46);
  a17=(a17+a22);
  a17=(a00+a17);
  a22=cos(a17);
  a50=(a22*a14);
  a50=(a50*a10);
  a48=(a22*a55);
  a51=sin(a17);
  a42=(a51*a53);
  a48=(a48+a42);
  a42=(a48*a14);
  a60=(a42*a10);
  a50=(a50+a60);
  a60=(a25*a51);
  a50=(a50+a60);
  a60=(a51*a55);
  a56=(a22*a53);
  a60=(a60-a56);
  a56=(a25*a60);
  a50=(a50+a56);
  a56=(a27*a51);
  a50=(a50-a56);
  a56=(a28*a51);
  a50=(a50-a56);
  a49=(a49*a50);
  a58=(a58-a49);
  a49=(2.*a59);
  a49=(a49*a15);
  a49=(a49*a10);
  a50=(a07*a53);
  a44=(a44-a50);
  a42=(a42*a18);
  a50=(a44+a42);
  a56=(a29*a60);
  a50=(a50+a56);
  a49=(a49*a50);
  a58=(a58+a49);
  a58=(a58-a32);
  a49=(a51*a33);
  a50=(a22*a31);
  a49=(a49-a50);
  a50=(a27*a49);
  a58=(a58+a50);
  a50=(a22*a33);
  a43=(a51*a31);
  a50=(a50+a43);
  a50=(a50*a14);
  a43=(a07*a49);
  a50=(a50+a43);
  a50=(a50+a36);
  a49=(2.*a49);
  a50=(a50-a49);
  a12=(a12-a17);
  a12=(a12+a21);
  a17=cos(a12);
  a17=(a17*a14);
  a12=sin(a12);
  a12=(a07*a12);
  a17=(a17-a12);
  a50=(a50+a17);
  a50=(a10*a50);
  a58=(a58-a50);
  a42=(a47*a42);
  a58=(a58-a42);
  a47=(a47*a56);
  a58=(a58-a47);
  a47=(2.*a22);
  a47=(a47*a18);
  a56=(a27*a47);
  a56=(a19+a56);
  a56=(a56+a27);
  a56=(a56+a35);
  a51=(a34*a51);
  a22=(a22*a07);
  a22=(a22*a18);
  a51=(a51-a22);
  a55=(a55*a07);
  a51=(a51-a55);
  a51=(a51-a07);
  a53=(a14*a53);
  a51=(a51-a53);
  a51=(a51+a20);
  a51=(a51+a47);
  a60=(a34*a60);
  a51=(a51+a60);
  a48=(a48*a07);
  a48=(a48*a18);
  a51=(a51-a48);
  a51=(a51+a39);
  a51=(a51+a40);
  a51=(a28*a51);
  a56=(a56+a51);
  a51=(a58/a56);
  a55=(a55-a16);
  a55=(a55-a38);
  a55=(a55+a53);
  a55=(a55-a60);
  a55=(a55+a48);
  a55=(a10*a55);
  a55=(a55-a24);
  a56=(a55/a56);
  a45=(a45*a44);
  a17=(a17-a45);
  a17=(a10*a17);
  a58=(a56*a58);
  a17=(a17-a58);
  a55=(a55*a56);
  a55=(a09-a55);
  a17=(a17/a55);
  a56=(a56*a17);
  a51=(a51-a56);
  a56=(a13*a51);
  a30=(a30+a56);
  a56=1.2546768756682242e-01;
  a56=(a56*a02);
  a55=2.4136513415926669e-01;
  a55=(a55*a02);
  a58=(a55*a37);
  a45=-8.8454947932828609e-01;
  a45=(a45*a02);
  a54=(a45*a54);
  a58=(a58+a54);
  a54=9.2483400326179199e-01;
  a54=(a54*a02);
  a44=(a54*a17);
  a58=(a58+a44);
  a58=(a08+a58);
  a44=(a07*a58);
  a44=(a44*a58);
  a44=(a44*a10);
  a48=(a55*a08);
  a26=(a45*a26);
  a48=(a48+a26);
  a26=(a54*a15);
  a48=(a48+a26);
  a48=(a11+a48);
  a26=sin(a48);
  a44=(a44*a26);
  a60=cos(a48);
  a53=(a60*a14);
  a47=casadi_sq(a58);
  a47=(a47*a10);
  a22=(a53*a47);
  a44=(a44-a22);
  a22=(a55*a23);
  a41=(a45*a41);
  a22=(a22+a41);
  a41=(a54*a51);
  a22=(a22+a41);
  a22=(a03+a22);
  a41=casadi_sq(a22);
  a42=(a41*a18);
  a55=(a55*a03);
  a45=(a45*a46);
  a55=(a55+a45);
  a54=(a54*a59);
  a55=(a55+a54);
  a55=(a00+a55);
  a54=cos(a55);
  a45=(a54*a14);
  a45=(a45*a10);
  a46=(a54*a60);
  a50=sin(a55);
  a12=(a50*a26);
  a46=(a46+a12);
  a12=(a46*a14);
  a49=(a12*a10);
  a45=(a45+a49);
  a49=(a25*a50);
  a45=(a45+a49);
  a49=(a50*a60);
  a43=(a54*a26);
  a49=(a49-a43);
  a43=(a25*a49);
  a45=(a45+a43);
  a43=(a27*a50);
  a45=(a45-a43);
  a43=(a28*a50);
  a45=(a45-a43);
  a42=(a42*a45);
  a44=(a44-a42);
  a42=(2.*a22);
  a42=(a42*a58);
  a42=(a42*a10);
  a45=(a07*a26);
  a53=(a53-a45);
  a12=(a12*a18);
  a45=(a53+a12);
  a43=(a29*a49);
  a45=(a45+a43);
  a42=(a42*a45);
  a44=(a44+a42);
  a44=(a44-a32);
  a42=(a50*a33);
  a45=(a54*a31);
  a42=(a42-a45);
  a45=(a27*a42);
  a44=(a44+a45);
  a45=(a54*a33);
  a61=(a50*a31);
  a45=(a45+a61);
  a45=(a45*a14);
  a61=(a07*a42);
  a45=(a45+a61);
  a45=(a45+a36);
  a42=(2.*a42);
  a45=(a45-a42);
  a48=(a48-a55);
  a48=(a48+a21);
  a55=cos(a48);
  a55=(a55*a14);
  a48=sin(a48);
  a48=(a07*a48);
  a55=(a55-a48);
  a45=(a45+a55);
  a45=(a10*a45);
  a44=(a44-a45);
  a12=(a47*a12);
  a44=(a44-a12);
  a47=(a47*a43);
  a44=(a44-a47);
  a47=(2.*a54);
  a47=(a47*a18);
  a43=(a27*a47);
  a43=(a19+a43);
  a43=(a43+a27);
  a43=(a43+a35);
  a50=(a34*a50);
  a54=(a54*a07);
  a54=(a54*a18);
  a50=(a50-a54);
  a60=(a60*a07);
  a50=(a50-a60);
  a50=(a50-a07);
  a26=(a14*a26);
  a50=(a50-a26);
  a50=(a50+a20);
  a50=(a50+a47);
  a49=(a34*a49);
  a50=(a50+a49);
  a46=(a46*a07);
  a46=(a46*a18);
  a50=(a50-a46);
  a50=(a50+a39);
  a50=(a50+a40);
  a50=(a28*a50);
  a43=(a43+a50);
  a50=(a44/a43);
  a60=(a60-a16);
  a60=(a60-a38);
  a60=(a60+a26);
  a60=(a60-a49);
  a60=(a60+a46);
  a60=(a10*a60);
  a60=(a60-a24);
  a43=(a60/a43);
  a41=(a41*a53);
  a55=(a55-a41);
  a55=(a10*a55);
  a44=(a43*a44);
  a55=(a55-a44);
  a60=(a60*a43);
  a60=(a09-a60);
  a55=(a55/a60);
  a43=(a43*a55);
  a50=(a50-a43);
  a43=(a56*a50);
  a30=(a30+a43);
  a30=(a03+a30);
  a43=(a05*a30);
  a04=(a04+a43);
  a43=1.8915178993145003e+00;
  a43=(a43*a02);
  a60=3.7109375000000000e-02;
  a60=(a60*a02);
  a44=(a60*a23);
  a41=1.7025221101954405e-01;
  a41=(a41*a02);
  a53=(a41*a51);
  a44=(a44+a53);
  a53=6.0216538980455959e-02;
  a53=(a53*a02);
  a46=(a53*a50);
  a44=(a44+a46);
  a46=-1.7578125000000000e-02;
  a46=(a46*a02);
  a49=(a06*a37);
  a26=(a13*a17);
  a49=(a49+a26);
  a26=(a56*a55);
  a49=(a49+a26);
  a49=(a08+a49);
  a26=(a07*a49);
  a26=(a26*a49);
  a26=(a26*a10);
  a47=(a06*a08);
  a54=(a13*a15);
  a47=(a47+a54);
  a54=(a56*a58);
  a47=(a47+a54);
  a47=(a11+a47);
  a54=sin(a47);
  a26=(a26*a54);
  a12=cos(a47);
  a45=(a12*a14);
  a48=casadi_sq(a49);
  a48=(a48*a10);
  a42=(a45*a48);
  a26=(a26-a42);
  a42=casadi_sq(a30);
  a61=(a42*a18);
  a06=(a06*a03);
  a13=(a13*a59);
  a06=(a06+a13);
  a56=(a56*a22);
  a06=(a06+a56);
  a06=(a00+a06);
  a56=cos(a06);
  a13=(a56*a14);
  a13=(a13*a10);
  a52=(a56*a12);
  a57=sin(a06);
  a62=(a57*a54);
  a52=(a52+a62);
  a62=(a52*a14);
  a63=(a62*a10);
  a13=(a13+a63);
  a63=(a25*a57);
  a13=(a13+a63);
  a63=(a57*a12);
  a64=(a56*a54);
  a63=(a63-a64);
  a64=(a25*a63);
  a13=(a13+a64);
  a64=(a27*a57);
  a13=(a13-a64);
  a64=(a28*a57);
  a13=(a13-a64);
  a61=(a61*a13);
  a26=(a26-a61);
  a61=(2.*a30);
  a61=(a61*a49);
  a61=(a61*a10);
  a13=(a07*a54);
  a45=(a45-a13);
  a62=(a62*a18);
  a13=(a45+a62);
  a64=(a29*a63);
  a13=(a13+a64);
  a61=(a61*a13);
  a26=(a26+a61);
  a26=(a26-a32);
  a61=(a57*a33);
  a13=(a56*a31);
  a61=(a61-a13);
  a13=(a27*a61);
  a26=(a26+a13);
  a13=(a56*a33);
  a65=(a57*a31);
  a13=(a13+a65);
  a13=(a13*a14);
  a65=(a07*a61);
  a13=(a13+a65);
  a13=(a13+a36);
  a61=(2.*a61);
  a13=(a13-a61);
  a47=(a47-a06);
  a47=(a47+a21);
  a06=cos(a47);
  a06=(a06*a14);
  a47=sin(a47);
  a47=(a07*a47);
  a06=(a06-a47);
  a13=(a13+a06);
  a13=(a10*a13);
  a26=(a26-a13);
  a62=(a48*a62);
  a26=(a26-a62);
  a48=(a48*a64);
  a26=(a26-a48);
  a48=(2.*a56);
  a48=(a48*a18);
  a64=(a27*a48);
  a64=(a19+a64);
  a64=(a64+a27);
  a64=(a64+a35);
  a57=(a34*a57);
  a56=(a56*a07);
  a56=(a56*a18);
  a57=(a57-a56);
  a12=(a12*a07);
  a57=(a57-a12);
  a57=(a57-a07);
  a54=(a14*a54);
  a57=(a57-a54);
  a57=(a57+a20);
  a57=(a57+a48);
  a63=(a34*a63);
  a57=(a57+a63);
  a52=(a52*a07);
  a52=(a52*a18);
  a57=(a57-a52);
  a57=(a57+a39);
  a57=(a57+a40);
  a57=(a28*a57);
  a64=(a64+a57);
  a57=(a26/a64);
  a12=(a12-a16);
  a12=(a12-a38);
  a12=(a12+a54);
  a12=(a12-a63);
  a12=(a12+a52);
  a12=(a10*a12);
  a12=(a12-a24);
  a64=(a12/a64);
  a42=(a42*a45);
  a06=(a06-a42);
  a06=(a10*a06);
  a26=(a64*a26);
  a06=(a06-a26);
  a12=(a12*a64);
  a12=(a09-a12);
  a06=(a06/a12);
  a64=(a64*a06);
  a57=(a57-a64);
  a64=(a46*a57);
  a44=(a44+a64);
  a44=(a03+a44);
  a64=(a43*a44);
  a04=(a04+a64);
  a64=-5.8012039600105849e+00;
  a64=(a64*a02);
  a12=3.7092000118504789e-02;
  a12=(a12*a02);
  a26=(a12*a23);
  a42=1.7038392571223998e-01;
  a42=(a42*a02);
  a45=(a42*a51);
  a26=(a26+a45);
  a45=1.0726203044637328e-01;
  a45=(a45*a02);
  a52=(a45*a50);
  a26=(a26+a52);
  a52=-1.5319437748624402e-02;
  a52=(a52*a02);
  a63=(a52*a57);
  a26=(a26+a63);
  a63=8.2737891638140233e-03;
  a63=(a63*a02);
  a54=(a60*a37);
  a48=(a41*a17);
  a54=(a54+a48);
  a48=(a53*a55);
  a54=(a54+a48);
  a48=(a46*a06);
  a54=(a54+a48);
  a54=(a08+a54);
  a48=(a07*a54);
  a48=(a48*a54);
  a48=(a48*a10);
  a56=(a60*a08);
  a62=(a41*a15);
  a56=(a56+a62);
  a62=(a53*a58);
  a56=(a56+a62);
  a62=(a46*a49);
  a56=(a56+a62);
  a56=(a11+a56);
  a62=sin(a56);
  a48=(a48*a62);
  a13=cos(a56);
  a47=(a13*a14);
  a61=casadi_sq(a54);
  a61=(a61*a10);
  a65=(a47*a61);
  a48=(a48-a65);
  a65=casadi_sq(a44);
  a66=(a65*a18);
  a60=(a60*a03);
  a41=(a41*a59);
  a60=(a60+a41);
  a53=(a53*a22);
  a60=(a60+a53);
  a46=(a46*a30);
  a60=(a60+a46);
  a60=(a00+a60);
  a46=cos(a60);
  a53=(a46*a14);
  a53=(a53*a10);
  a41=(a46*a13);
  a67=sin(a60);
  a68=(a67*a62);
  a41=(a41+a68);
  a68=(a41*a14);
  a69=(a68*a10);
  a53=(a53+a69);
  a69=(a25*a67);
  a53=(a53+a69);
  a69=(a67*a13);
  a70=(a46*a62);
  a69=(a69-a70);
  a70=(a25*a69);
  a53=(a53+a70);
  a70=(a27*a67);
  a53=(a53-a70);
  a70=(a28*a67);
  a53=(a53-a70);
  a66=(a66*a53);
  a48=(a48-a66);
  a66=(2.*a44);
  a66=(a66*a54);
  a66=(a66*a10);
  a53=(a07*a62);
  a47=(a47-a53);
  a68=(a68*a18);
  a53=(a47+a68);
  a70=(a29*a69);
  a53=(a53+a70);
  a66=(a66*a53);
  a48=(a48+a66);
  a48=(a48-a32);
  a66=(a67*a33);
  a53=(a46*a31);
  a66=(a66-a53);
  a53=(a27*a66);
  a48=(a48+a53);
  a53=(a46*a33);
  a71=(a67*a31);
  a53=(a53+a71);
  a53=(a53*a14);
  a71=(a07*a66);
  a53=(a53+a71);
  a53=(a53+a36);
  a66=(2.*a66);
  a53=(a53-a66);
  a56=(a56-a60);
  a56=(a56+a21);
  a60=cos(a56);
  a60=(a60*a14);
  a56=sin(a56);
  a56=(a07*a56);
  a60=(a60-a56);
  a53=(a53+a60);
  a53=(a10*a53);
  a48=(a48-a53);
  a68=(a61*a68);
  a48=(a48-a68);
  a61=(a61*a70);
  a48=(a48-a61);
  a61=(2.*a46);
  a61=(a61*a18);
  a70=(a27*a61);
  a70=(a19+a70);
  a70=(a70+a27);
  a70=(a70+a35);
  a67=(a34*a67);
  a46=(a46*a07);
  a46=(a46*a18);
  a67=(a67-a46);
  a13=(a13*a07);
  a67=(a67-a13);
  a67=(a67-a07);
  a62=(a14*a62);
  a67=(a67-a62);
  a67=(a67+a20);
  a67=(a67+a61);
  a69=(a34*a69);
  a67=(a67+a69);
  a41=(a41*a07);
  a41=(a41*a18);
  a67=(a67-a41);
  a67=(a67+a39);
  a67=(a67+a40);
  a67=(a28*a67);
  a70=(a70+a67);
  a67=(a48/a70);
  a13=(a13-a16);
  a13=(a13-a38);
  a13=(a13+a62);
  a13=(a13-a69);
  a13=(a13+a41);
  a13=(a10*a13);
  a13=(a13-a24);
  a70=(a13/a70);
  a65=(a65*a47);
  a60=(a60-a65);
  a60=(a10*a60);
  a48=(a70*a48);
  a60=(a60-a48);
  a13=(a13*a70);
  a13=(a09-a13);
  a60=(a60/a13);
  a70=(a70*a60);
  a67=(a67-a70);
  a70=(a63*a67);
  a26=(a26+a70);
  a26=(a03+a26);
  a70=(a64*a26);
  a04=(a04+a70);
  a70=3.1116436695781990e-01;
  a70=(a70*a02);
  a13=6.2411095871607569e-01;
  a13=(a13*a02);
  a48=(a13*a23);
  a65=-3.3608926294469414e+00;
  a65=(a65*a02);
  a47=(a65*a51);
  a48=(a48+a47);
  a47=-8.6821934684172597e-01;
  a47=(a47*a02);
  a41=(a47*a50);
  a48=(a48+a41);
  a41=2.7592099699446710e+01;
  a41=(a41*a02);
  a69=(a41*a57);
  a48=(a48+a69);
  a69=2.0154067550477894e+01;
  a69=(a69*a02);
  a62=(a69*a67);
  a48=(a48+a62);
  a62=-4.3489884181069961e+01;
  a62=(a62*a02);
  a61=(a12*a37);
  a46=(a42*a17);
  a61=(a61+a46);
  a46=(a45*a55);
  a61=(a61+a46);
  a46=(a52*a06);
  a61=(a61+a46);
  a46=(a63*a60);
  a61=(a61+a46);
  a61=(a08+a61);
  a46=(a07*a61);
  a46=(a46*a61);
  a46=(a46*a10);
  a68=(a12*a08);
  a53=(a42*a15);
  a68=(a68+a53);
  a53=(a45*a58);
  a68=(a68+a53);
  a53=(a52*a49);
  a68=(a68+a53);
  a53=(a63*a54);
  a68=(a68+a53);
  a68=(a11+a68);
  a53=sin(a68);
  a46=(a46*a53);
  a56=cos(a68);
  a66=(a56*a14);
  a71=casadi_sq(a61);
  a71=(a71*a10);
  a72=(a66*a71);
  a46=(a46-a72);
  a72=casadi_sq(a26);
  a73=(a72*a18);
  a12=(a12*a03);
  a42=(a42*a59);
  a12=(a12+a42);
  a45=(a45*a22);
  a12=(a12+a45);
  a52=(a52*a30);
  a12=(a12+a52);
  a63=(a63*a44);
  a12=(a12+a63);
  a12=(a00+a12);
  a63=cos(a12);
  a52=(a63*a14);
  a52=(a52*a10);
  a45=(a63*a56);
  a42=sin(a12);
  a74=(a42*a53);
  a45=(a45+a74);
  a74=(a45*a14);
  a75=(a74*a10);
  a52=(a52+a75);
  a75=(a25*a42);
  a52=(a52+a75);
  a75=(a42*a56);
  a76=(a63*a53);
  a75=(a75-a76);
  a76=(a25*a75);
  a52=(a52+a76);
  a76=(a27*a42);
  a52=(a52-a76);
  a76=(a28*a42);
  a52=(a52-a76);
  a73=(a73*a52);
  a46=(a46-a73);
  a73=(2.*a26);
  a73=(a73*a61);
  a73=(a73*a10);
  a52=(a07*a53);
  a66=(a66-a52);
  a74=(a74*a18);
  a52=(a66+a74);
  a76=(a29*a75);
  a52=(a52+a76);
  a73=(a73*a52);
  a46=(a46+a73);
  a46=(a46-a32);
  a73=(a42*a33);
  a52=(a63*a31);
  a73=(a73-a52);
  a52=(a27*a73);
  a46=(a46+a52);
  a52=(a63*a33);
  a77=(a42*a31);
  a52=(a52+a77);
  a52=(a52*a14);
  a77=(a07*a73);
  a52=(a52+a77);
  a52=(a52+a36);
  a73=(2.*a73);
  a52=(a52-a73);
  a68=(a68-a12);
  a68=(a68+a21);
  a12=cos(a68);
  a12=(a12*a14);
  a68=sin(a68);
  a68=(a07*a68);
  a12=(a12-a68);
  a52=(a52+a12);
  a52=(a10*a52);
  a46=(a46-a52);
  a74=(a71*a74);
  a46=(a46-a74);
  a71=(a71*a76);
  a46=(a46-a71);
  a71=(2.*a63);
  a71=(a71*a18);
  a76=(a27*a71);
  a76=(a19+a76);
  a76=(a76+a27);
  a76=(a76+a35);
  a42=(a34*a42);
  a63=(a63*a07);
  a63=(a63*a18);
  a42=(a42-a63);
  a56=(a56*a07);
  a42=(a42-a56);
  a42=(a42-a07);
  a53=(a14*a53);
  a42=(a42-a53);
  a42=(a42+a20);
  a42=(a42+a71);
  a75=(a34*a75);
  a42=(a42+a75);
  a45=(a45*a07);
  a45=(a45*a18);
  a42=(a42-a45);
  a42=(a42+a39);
  a42=(a42+a40);
  a42=(a28*a42);
  a76=(a76+a42);
  a42=(a46/a76);
  a56=(a56-a16);
  a56=(a56-a38);
  a56=(a56+a53);
  a56=(a56-a75);
  a56=(a56+a45);
  a56=(a10*a56);
  a56=(a56-a24);
  a76=(a56/a76);
  a72=(a72*a66);
  a12=(a12-a72);
  a12=(a10*a12);
  a46=(a76*a46);
  a12=(a12-a46);
  a56=(a56*a76);
  a56=(a09-a56);
  a12=(a12/a56);
  a76=(a76*a12);
  a42=(a42-a76);
  a76=(a62*a42);
  a48=(a48+a76);
  a48=(a03+a48);
  a76=(a70*a48);
  a04=(a04+a76);
  a76=-1.5216094966251609e-01;
  a76=(a76*a02);
  a56=4.7766253643826434e-01;
  a56=(a56*a02);
  a46=(a56*a23);
  a72=-2.4881146199716677e+00;
  a72=(a72*a02);
  a66=(a72*a51);
  a46=(a46+a66);
  a66=-5.9029082683684297e-01;
  a66=(a66*a02);
  a45=(a66*a50);
  a46=(a46+a45);
  a45=2.1230051448181193e+01;
  a45=(a45*a02);
  a75=(a45*a57);
  a46=(a46+a75);
  a75=1.5279233632882423e+01;
  a75=(a75*a02);
  a53=(a75*a67);
  a46=(a46+a53);
  a53=-3.3288210968984863e+01;
  a53=(a53*a02);
  a71=(a53*a42);
  a46=(a46+a71);
  a71=-2.0331201708508627e-02;
  a71=(a71*a02);
  a63=(a13*a37);
  a74=(a65*a17);
  a63=(a63+a74);
  a74=(a47*a55);
  a63=(a63+a74);
  a74=(a41*a06);
  a63=(a63+a74);
  a74=(a69*a60);
  a63=(a63+a74);
  a74=(a62*a12);
  a63=(a63+a74);
  a63=(a08+a63);
  a74=(a07*a63);
  a74=(a74*a63);
  a74=(a74*a10);
  a52=(a13*a08);
  a68=(a65*a15);
  a52=(a52+a68);
  a68=(a47*a58);
  a52=(a52+a68);
  a68=(a41*a49);
  a52=(a52+a68);
  a68=(a69*a54);
  a52=(a52+a68);
  a68=(a62*a61);
  a52=(a52+a68);
  a52=(a11+a52);
  a68=sin(a52);
  a74=(a74*a68);
  a73=cos(a52);
  a77=(a73*a14);
  a78=casadi_sq(a63);
  a78=(a78*a10);
  a79=(a77*a78);
  a74=(a74-a79);
  a79=casadi_sq(a48);
  a80=(a79*a18);
  a13=(a13*a03);
  a65=(a65*a59);
  a13=(a13+a65);
  a47=(a47*a22);
  a13=(a13+a47);
  a41=(a41*a30);
  a13=(a13+a41);
  a69=(a69*a44);
  a13=(a13+a69);
  a62=(a62*a26);
  a13=(a13+a62);
  a13=(a00+a13);
  a62=cos(a13);
  a69=(a62*a14);
  a69=(a69*a10);
  a41=(a62*a73);
  a47=sin(a13);
  a65=(a47*a68);
  a41=(a41+a65);
  a65=(a41*a14);
  a81=(a65*a10);
  a69=(a69+a81);
  a81=(a25*a47);
  a69=(a69+a81);
  a81=(a47*a73);
  a82=(a62*a68);
  a81=(a81-a82);
  a82=(a25*a81);
  a69=(a69+a82);
  a82=(a27*a47);
  a69=(a69-a82);
  a82=(a28*a47);
  a69=(a69-a82);
  a80=(a80*a69);
  a74=(a74-a80);
  a80=(2.*a48);
  a80=(a80*a63);
  a80=(a80*a10);
  a69=(a07*a68);
  a77=(a77-a69);
  a65=(a65*a18);
  a69=(a77+a65);
  a82=(a29*a81);
  a69=(a69+a82);
  a80=(a80*a69);
  a74=(a74+a80);
  a74=(a74-a32);
  a80=(a47*a33);
  a69=(a62*a31);
  a80=(a80-a69);
  a69=(a27*a80);
  a74=(a74+a69);
  a69=(a62*a33);
  a83=(a47*a31);
  a69=(a69+a83);
  a69=(a69*a14);
  a83=(a07*a80);
  a69=(a69+a83);
  a69=(a69+a36);
  a80=(2.*a80);
  a69=(a69-a80);
  a52=(a52-a13);
  a52=(a52+a21);
  a13=cos(a52);
  a13=(a13*a14);
  a52=sin(a52);
  a52=(a07*a52);
  a13=(a13-a52);
  a69=(a69+a13);
  a69=(a10*a69);
  a74=(a74-a69);
  a65=(a78*a65);
  a74=(a74-a65);
  a78=(a78*a82);
  a74=(a74-a78);
  a78=(2.*a62);
  a78=(a78*a18);
  a82=(a27*a78);
  a82=(a19+a82);
  a82=(a82+a27);
  a82=(a82+a35);
  a47=(a34*a47);
  a62=(a62*a07);
  a62=(a62*a18);
  a47=(a47-a62);
  a73=(a73*a07);
  a47=(a47-a73);
  a47=(a47-a07);
  a68=(a14*a68);
  a47=(a47-a68);
  a47=(a47+a20);
  a47=(a47+a78);
  a81=(a34*a81);
  a47=(a47+a81);
  a41=(a41*a07);
  a41=(a41*a18);
  a47=(a47-a41);
  a47=(a47+a39);
  a47=(a47+a40);
  a47=(a28*a47);
  a82=(a82+a47);
  a47=(a74/a82);
  a73=(a73-a16);
  a73=(a73-a38);
  a73=(a73+a68);
  a73=(a73-a81);
  a73=(a73+a41);
  a73=(a10*a73);
  a73=(a73-a24);
  a82=(a73/a82);
  a79=(a79*a77);
  a13=(a13-a79);
  a13=(a10*a13);
  a74=(a82*a74);
  a13=(a13-a74);
  a73=(a73*a82);
  a73=(a09-a73);
  a13=(a13/a73);
  a82=(a82*a13);
  a47=(a47-a82);
  a82=(a71*a47);
  a46=(a46+a82);
  a46=(a03+a46);
  a82=(a76*a46);
  a04=(a04+a82);
  a82=2.0136540080403034e-01;
  a82=(a82*a02);
  a73=-9.3714243008598730e-01;
  a73=(a73*a02);
  a74=(a73*a23);
  a79=5.1863724288440638e+00;
  a79=(a79*a02);
  a77=(a79*a51);
  a74=(a74+a77);
  a77=1.0914373489967295e+00;
  a77=(a77*a02);
  a41=(a77*a50);
  a74=(a74+a41);
  a41=-8.1497870107469268e+00;
  a41=(a41*a02);
  a81=(a41*a57);
  a74=(a74+a81);
  a81=-1.8520065659996959e+01;
  a81=(a81*a02);
  a68=(a81*a67);
  a74=(a74+a68);
  a68=2.2739487099350505e+01;
  a68=(a68*a02);
  a78=(a68*a42);
  a74=(a74+a78);
  a78=2.4936055526796523e+00;
  a78=(a78*a02);
  a62=(a78*a47);
  a74=(a74+a62);
  a62=-3.0467644718982196e+00;
  a62=(a62*a02);
  a65=(a56*a37);
  a69=(a72*a17);
  a65=(a65+a69);
  a69=(a66*a55);
  a65=(a65+a69);
  a69=(a45*a06);
  a65=(a65+a69);
  a69=(a75*a60);
  a65=(a65+a69);
  a69=(a53*a12);
  a65=(a65+a69);
  a69=(a71*a13);
  a65=(a65+a69);
  a65=(a08+a65);
  a69=(a07*a65);
  a69=(a69*a65);
  a69=(a69*a10);
  a52=(a56*a08);
  a80=(a72*a15);
  a52=(a52+a80);
  a80=(a66*a58);
  a52=(a52+a80);
  a80=(a45*a49);
  a52=(a52+a80);
  a80=(a75*a54);
  a52=(a52+a80);
  a80=(a53*a61);
  a52=(a52+a80);
  a80=(a71*a63);
  a52=(a52+a80);
  a52=(a11+a52);
  a80=sin(a52);
  a69=(a69*a80);
  a83=cos(a52);
  a84=(a83*a14);
  a85=casadi_sq(a65);
  a85=(a85*a10);
  a86=(a84*a85);
  a69=(a69-a86);
  a86=casadi_sq(a46);
  a87=(a86*a18);
  a56=(a56*a03);
  a72=(a72*a59);
  a56=(a56+a72);
  a66=(a66*a22);
  a56=(a56+a66);
  a45=(a45*a30);
  a56=(a56+a45);
  a75=(a75*a44);
  a56=(a56+a75);
  a53=(a53*a26);
  a56=(a56+a53);
  a71=(a71*a48);
  a56=(a56+a71);
  a56=(a00+a56);
  a71=cos(a56);
  a53=(a71*a14);
  a53=(a53*a10);
  a75=(a71*a83);
  a45=sin(a56);
  a66=(a45*a80);
  a75=(a75+a66);
  a66=(a75*a14);
  a72=(a66*a10);
  a53=(a53+a72);
  a72=(a25*a45);
  a53=(a53+a72);
  a72=(a45*a83);
  a88=(a71*a80);
  a72=(a72-a88);
  a88=(a25*a72);
  a53=(a53+a88);
  a88=(a27*a45);
  a53=(a53-a88);
  a88=(a28*a45);
  a53=(a53-a88);
  a87=(a87*a53);
  a69=(a69-a87);
  a87=(2.*a46);
  a87=(a87*a65);
  a87=(a87*a10);
  a53=(a07*a80);
  a84=(a84-a53);
  a66=(a66*a18);
  a53=(a84+a66);
  a88=(a29*a72);
  a53=(a53+a88);
  a87=(a87*a53);
  a69=(a69+a87);
  a69=(a69-a32);
  a87=(a45*a33);
  a53=(a71*a31);
  a87=(a87-a53);
  a53=(a27*a87);
  a69=(a69+a53);
  a53=(a71*a33);
  a89=(a45*a31);
  a53=(a53+a89);
  a53=(a53*a14);
  a89=(a07*a87);
  a53=(a53+a89);
  a53=(a53+a36);
  a87=(2.*a87);
  a53=(a53-a87);
  a52=(a52-a56);
  a52=(a52+a21);
  a56=cos(a52);
  a56=(a56*a14);
  a52=sin(a52);
  a52=(a07*a52);
  a56=(a56-a52);
  a53=(a53+a56);
  a53=(a10*a53);
  a69=(a69-a53);
  a66=(a85*a66);
  a69=(a69-a66);
  a85=(a85*a88);
  a69=(a69-a85);
  a85=(2.*a71);
  a85=(a85*a18);
  a88=(a27*a85);
  a88=(a19+a88);
  a88=(a88+a27);
  a88=(a88+a35);
  a45=(a34*a45);
  a71=(a71*a07);
  a71=(a71*a18);
  a45=(a45-a71);
  a83=(a83*a07);
  a45=(a45-a83);
  a45=(a45-a07);
  a80=(a14*a80);
  a45=(a45-a80);
  a45=(a45+a20);
  a45=(a45+a85);
  a72=(a34*a72);
  a45=(a45+a72);
  a75=(a75*a07);
  a75=(a75*a18);
  a45=(a45-a75);
  a45=(a45+a39);
  a45=(a45+a40);
  a45=(a28*a45);
  a88=(a88+a45);
  a45=(a69/a88);
  a83=(a83-a16);
  a83=(a83-a38);
  a83=(a83+a80);
  a83=(a83-a72);
  a83=(a83+a75);
  a83=(a10*a83);
  a83=(a83-a24);
  a88=(a83/a88);
  a86=(a86*a84);
  a56=(a56-a86);
  a56=(a10*a56);
  a69=(a88*a69);
  a56=(a56-a69);
  a83=(a83*a88);
  a83=(a09-a83);
  a56=(a56/a83);
  a88=(a88*a56);
  a45=(a45-a88);
  a88=(a62*a45);
  a74=(a74+a88);
  a74=(a03+a74);
  a88=(a82*a74);
  a04=(a04+a88);
  a88=4.4710615727772587e-02;
  a88=(a88*a02);
  a83=2.2733101475165380e+00;
  a83=(a83*a02);
  a69=(a83*a23);
  a86=-1.0534495466737249e+01;
  a86=(a86*a02);
  a51=(a86*a51);
  a69=(a69+a51);
  a51=-2.0008720582248625e+00;
  a51=(a51*a02);
  a50=(a51*a50);
  a69=(a69+a50);
  a50=-1.7958931863118799e+01;
  a50=(a50*a02);
  a84=(a50*a57);
  a69=(a69+a84);
  a84=2.7948884529419960e+01;
  a84=(a84*a02);
  a75=(a84*a67);
  a69=(a69+a75);
  a75=-2.8589982771350235e+00;
  a75=(a75*a02);
  a72=(a75*a42);
  a69=(a69+a72);
  a72=-8.8728569335306293e+00;
  a72=(a72*a02);
  a80=(a72*a47);
  a69=(a69+a80);
  a80=1.2360567175794303e+01;
  a80=(a80*a02);
  a85=(a80*a45);
  a69=(a69+a85);
  a85=6.4339274601576357e-01;
  a85=(a85*a02);
  a02=(a73*a37);
  a71=(a79*a17);
  a02=(a02+a71);
  a71=(a77*a55);
  a02=(a02+a71);
  a71=(a41*a06);
  a02=(a02+a71);
  a71=(a81*a60);
  a02=(a02+a71);
  a71=(a68*a12);
  a02=(a02+a71);
  a71=(a78*a13);
  a02=(a02+a71);
  a71=(a62*a56);
  a02=(a02+a71);
  a02=(a08+a02);
  a71=(a07*a02);
  a71=(a71*a02);
  a71=(a71*a10);
  a66=(a73*a08);
  a53=(a79*a15);
  a66=(a66+a53);
  a53=(a77*a58);
  a66=(a66+a53);
  a53=(a41*a49);
  a66=(a66+a53);
  a53=(a81*a54);
  a66=(a66+a53);
  a53=(a68*a61);
  a66=(a66+a53);
  a53=(a78*a63);
  a66=(a66+a53);
  a53=(a62*a65);
  a66=(a66+a53);
  a66=(a11+a66);
  a53=sin(a66);
  a71=(a71*a53);
  a52=cos(a66);
  a87=(a52*a14);
  a89=casadi_sq(a02);
  a89=(a89*a10);
  a90=(a87*a89);
  a71=(a71-a90);
  a90=casadi_sq(a74);
  a91=(a90*a18);
  a73=(a73*a03);
  a79=(a79*a59);
  a73=(a73+a79);
  a77=(a77*a22);
  a73=(a73+a77);
  a41=(a41*a30);
  a73=(a73+a41);
  a81=(a81*a44);
  a73=(a73+a81);
  a68=(a68*a26);
  a73=(a73+a68);
  a78=(a78*a48);
  a73=(a73+a78);
  a62=(a62*a46);
  a73=(a73+a62);
  a73=(a00+a73);
  a62=cos(a73);
  a78=(a62*a14);
  a78=(a78*a10);
  a68=(a62*a52);
  a81=sin(a73);
  a41=(a81*a53);
  a68=(a68+a41);
  a41=(a68*a14);
  a77=(a41*a10);
  a78=(a78+a77);
  a77=(a25*a81);
  a78=(a78+a77);
  a77=(a81*a52);
  a79=(a62*a53);
  a77=(a77-a79);
  a79=(a25*a77);
  a78=(a78+a79);
  a79=(a27*a81);
  a78=(a78-a79);
  a79=(a28*a81);
  a78=(a78-a79);
  a91=(a91*a78);
  a71=(a71-a91);
  a91=(2.*a74);
  a91=(a91*a02);
  a91=(a91*a10);
  a78=(a07*a53);
  a87=(a87-a78);
  a41=(a41*a18);
  a78=(a87+a41);
  a79=(a29*a77);
  a78=(a78+a79);
  a91=(a91*a78);
  a71=(a71+a91);
  a71=(a71-a32);
  a91=(a81*a33);
  a78=(a62*a31);
  a91=(a91-a78);
  a78=(a27*a91);
  a71=(a71+a78);
  a78=(a62*a33);
  a92=(a81*a31);
  a78=(a78+a92);
  a78=(a78*a14);
  a92=(a07*a91);
  a78=(a78+a92);
  a78=(a78+a36);
  a91=(2.*a91);
  a78=(a78-a91);
  a66=(a66-a73);
  a66=(a66+a21);
  a73=cos(a66);
  a73=(a73*a14);
  a66=sin(a66);
  a66=(a07*a66);
  a73=(a73-a66);
  a78=(a78+a73);
  a78=(a10*a78);
  a71=(a71-a78);
  a41=(a89*a41);
  a71=(a71-a41);
  a89=(a89*a79);
  a71=(a71-a89);
  a89=(2.*a62);
  a89=(a89*a18);
  a79=(a27*a89);
  a79=(a19+a79);
  a79=(a79+a27);
  a79=(a79+a35);
  a81=(a34*a81);
  a62=(a62*a07);
  a62=(a62*a18);
  a81=(a81-a62);
  a52=(a52*a07);
  a81=(a81-a52);
  a81=(a81-a07);
  a53=(a14*a53);
  a81=(a81-a53);
  a81=(a81+a20);
  a81=(a81+a89);
  a77=(a34*a77);
  a81=(a81+a77);
  a68=(a68*a07);
  a68=(a68*a18);
  a81=(a81-a68);
  a81=(a81+a39);
  a81=(a81+a40);
  a81=(a28*a81);
  a79=(a79+a81);
  a81=(a71/a79);
  a52=(a52-a16);
  a52=(a52-a38);
  a52=(a52+a53);
  a52=(a52-a77);
  a52=(a52+a68);
  a52=(a10*a52);
  a52=(a52-a24);
  a79=(a52/a79);
  a90=(a90*a87);
  a73=(a73-a90);
  a73=(a10*a73);
  a71=(a79*a71);
  a73=(a73-a71);
  a52=(a52*a79);
  a52=(a09-a52);
  a73=(a73/a52);
  a79=(a79*a73);
  a81=(a81-a79);
  a79=(a85*a81);
  a69=(a69+a79);
  a69=(a03+a69);
  a79=(a88*a69);
  a04=(a04+a79);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a79=(a05*a49);
  a04=(a04+a79);
  a79=(a43*a54);
  a04=(a04+a79);
  a79=(a64*a61);
  a04=(a04+a79);
  a79=(a70*a63);
  a04=(a04+a79);
  a79=(a76*a65);
  a04=(a04+a79);
  a79=(a82*a02);
  a04=(a04+a79);
  a79=(a83*a37);
  a17=(a86*a17);
  a79=(a79+a17);
  a55=(a51*a55);
  a79=(a79+a55);
  a55=(a50*a06);
  a79=(a79+a55);
  a55=(a84*a60);
  a79=(a79+a55);
  a55=(a75*a12);
  a79=(a79+a55);
  a55=(a72*a13);
  a79=(a79+a55);
  a55=(a80*a56);
  a79=(a79+a55);
  a55=(a85*a73);
  a79=(a79+a55);
  a79=(a08+a79);
  a55=(a88*a79);
  a04=(a04+a55);
  a04=(a11+a04);
  if (res[0]!=0) res[0][1]=a04;
  a23=(a01*a23);
  a57=(a05*a57);
  a23=(a23+a57);
  a67=(a43*a67);
  a23=(a23+a67);
  a42=(a64*a42);
  a23=(a23+a42);
  a47=(a70*a47);
  a23=(a23+a47);
  a45=(a76*a45);
  a23=(a23+a45);
  a81=(a82*a81);
  a23=(a23+a81);
  a81=(a07*a79);
  a81=(a81*a79);
  a81=(a81*a10);
  a45=(a83*a08);
  a15=(a86*a15);
  a45=(a45+a15);
  a58=(a51*a58);
  a45=(a45+a58);
  a49=(a50*a49);
  a45=(a45+a49);
  a54=(a84*a54);
  a45=(a45+a54);
  a61=(a75*a61);
  a45=(a45+a61);
  a63=(a72*a63);
  a45=(a45+a63);
  a65=(a80*a65);
  a45=(a45+a65);
  a02=(a85*a02);
  a45=(a45+a02);
  a11=(a11+a45);
  a45=sin(a11);
  a81=(a81*a45);
  a02=cos(a11);
  a65=(a02*a14);
  a63=casadi_sq(a79);
  a63=(a63*a10);
  a61=(a65*a63);
  a81=(a81-a61);
  a61=casadi_sq(a69);
  a54=(a61*a18);
  a83=(a83*a03);
  a86=(a86*a59);
  a83=(a83+a86);
  a51=(a51*a22);
  a83=(a83+a51);
  a50=(a50*a30);
  a83=(a83+a50);
  a84=(a84*a44);
  a83=(a83+a84);
  a75=(a75*a26);
  a83=(a83+a75);
  a72=(a72*a48);
  a83=(a83+a72);
  a80=(a80*a46);
  a83=(a83+a80);
  a85=(a85*a74);
  a83=(a83+a85);
  a00=(a00+a83);
  a83=cos(a00);
  a85=(a83*a14);
  a85=(a85*a10);
  a74=(a83*a02);
  a80=sin(a00);
  a46=(a80*a45);
  a74=(a74+a46);
  a46=(a74*a14);
  a72=(a46*a10);
  a85=(a85+a72);
  a72=(a25*a80);
  a85=(a85+a72);
  a72=(a80*a02);
  a48=(a83*a45);
  a72=(a72-a48);
  a25=(a25*a72);
  a85=(a85+a25);
  a25=(a27*a80);
  a85=(a85-a25);
  a25=(a28*a80);
  a85=(a85-a25);
  a54=(a54*a85);
  a81=(a81-a54);
  a69=(2.*a69);
  a69=(a69*a79);
  a69=(a69*a10);
  a79=(a07*a45);
  a65=(a65-a79);
  a46=(a46*a18);
  a79=(a65+a46);
  a29=(a29*a72);
  a79=(a79+a29);
  a69=(a69*a79);
  a81=(a81+a69);
  a81=(a81-a32);
  a32=(a80*a33);
  a69=(a83*a31);
  a32=(a32-a69);
  a69=(a27*a32);
  a81=(a81+a69);
  a33=(a83*a33);
  a31=(a80*a31);
  a33=(a33+a31);
  a33=(a33*a14);
  a31=(a07*a32);
  a33=(a33+a31);
  a33=(a33+a36);
  a32=(2.*a32);
  a33=(a33-a32);
  a11=(a11-a00);
  a11=(a11+a21);
  a21=cos(a11);
  a21=(a21*a14);
  a11=sin(a11);
  a11=(a07*a11);
  a21=(a21-a11);
  a33=(a33+a21);
  a33=(a10*a33);
  a81=(a81-a33);
  a46=(a63*a46);
  a81=(a81-a46);
  a63=(a63*a29);
  a81=(a81-a63);
  a63=(2.*a83);
  a63=(a63*a18);
  a29=(a27*a63);
  a19=(a19+a29);
  a19=(a19+a27);
  a19=(a19+a35);
  a80=(a34*a80);
  a83=(a83*a07);
  a83=(a83*a18);
  a80=(a80-a83);
  a02=(a02*a07);
  a80=(a80-a02);
  a80=(a80-a07);
  a14=(a14*a45);
  a80=(a80-a14);
  a80=(a80+a20);
  a80=(a80+a63);
  a34=(a34*a72);
  a80=(a80+a34);
  a74=(a74*a07);
  a74=(a74*a18);
  a80=(a80-a74);
  a80=(a80+a39);
  a80=(a80+a40);
  a28=(a28*a80);
  a19=(a19+a28);
  a28=(a81/a19);
  a02=(a02-a16);
  a02=(a02-a38);
  a02=(a02+a14);
  a02=(a02-a34);
  a02=(a02+a74);
  a02=(a10*a02);
  a02=(a02-a24);
  a19=(a02/a19);
  a61=(a61*a65);
  a21=(a21-a61);
  a10=(a10*a21);
  a81=(a19*a81);
  a10=(a10-a81);
  a02=(a02*a19);
  a09=(a09-a02);
  a10=(a10/a09);
  a19=(a19*a10);
  a28=(a28-a19);
  a28=(a88*a28);
  a23=(a23+a28);
  a03=(a03+a23);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a37);
  a05=(a05*a06);
  a01=(a01+a05);
  a43=(a43*a60);
  a01=(a01+a43);
  a64=(a64*a12);
  a01=(a01+a64);
  a70=(a70*a13);
  a01=(a01+a70);
  a76=(a76*a56);
  a01=(a01+a76);
  a82=(a82*a73);
  a01=(a01+a82);
  a88=(a88*a10);
  a01=(a01+a88);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* plain_steps:(y[4],t,turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  /* #8: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #10: @7 = (2.*@5) */
  w7 = (2.* w5 );
  /* #11: @7 = (@1+@7) */
  w7  = (w1+w7);
  /* #12: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #13: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
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
  /* #18: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  /* #23: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  /* #28: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
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
  /* #37: @3 = phase(@7, @2) */
  arg1[0]=(&w7);
  arg1[1]=w2;
  res1[0]=w3;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #38: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  /* #43: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
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
  /* #48: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  /* #53: @6 = plain_step(@0, @3, @4, @5, @2) */
  arg1[0]=w0;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w6;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
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
  /* #58: @0 = plain_step(@6, @3, @4, @5, @2) */
  arg1[0]=w6;
  arg1[1]=w3;
  arg1[2]=wr4;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f11(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* landing:(y[4],z[3],p[7])->(R[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00-a01);
  a03=arg[1]? arg[1][0] : 0;
  a03=(a02-a03);
  if (res[0]!=0) res[0][0]=a03;
  a03=cos(a02);
  a04=arg[2]? arg[2][3] : 0;
  a05=(a03*a04);
  a06=arg[0]? arg[0][3] : 0;
  a07=(a05*a06);
  a08=arg[2]? arg[2][1] : 0;
  a07=(a07*a08);
  a09=arg[2]? arg[2][5] : 0;
  a07=(a07*a09);
  a10=casadi_sq(a04);
  a11=(a10*a06);
  a11=(a11*a08);
  a07=(a07-a11);
  a11=(a04*a06);
  a11=(a11*a08);
  a07=(a07+a11);
  a11=arg[2]? arg[2][4] : 0;
  a12=casadi_sq(a11);
  a13=(a12*a06);
  a13=(a13*a08);
  a07=(a07-a13);
  a13=arg[0]? arg[0][2] : 0;
  a14=cos(a00);
  a15=arg[2]? arg[2][0] : 0;
  a16=(a14*a15);
  a16=(a16*a09);
  a17=(2.*a14);
  a17=(a17*a08);
  a17=(a17*a09);
  a16=(a16+a17);
  a17=(a03*a15);
  a17=(a17*a09);
  a16=(a16+a17);
  a17=cos(a01);
  a18=(2.*a17);
  a19=(a18*a04);
  a19=(a19*a08);
  a16=(a16-a19);
  a19=(a17*a15);
  a16=(a16+a19);
  a18=(a18*a08);
  a16=(a16+a18);
  a18=(2.*a04);
  a19=(a18*a04);
  a19=(a19*a08);
  a16=(a16+a19);
  a19=(a04*a08);
  a03=(2.*a03);
  a03=(a03*a09);
  a19=(a19*a03);
  a16=(a16-a19);
  a18=(a18*a08);
  a16=(a16-a18);
  a18=(2.*a11);
  a18=(a18*a11);
  a18=(a18*a08);
  a16=(a16+a18);
  a18=(2.*a08);
  a19=(a18*a09);
  a19=(a19*a09);
  a16=(a16+a19);
  a19=(a08*a03);
  a16=(a16+a19);
  a19=(a11*a09);
  a02=sin(a02);
  a02=(a19*a02);
  a20=(a18*a02);
  a16=(a16+a20);
  a20=sin(a00);
  a19=(a19*a20);
  a20=(a18*a19);
  a16=(a16+a20);
  a14=(a14*a04);
  a14=(a14*a09);
  a20=(a18*a14);
  a16=(a16-a20);
  a20=(a15*a09);
  a20=(a20*a09);
  a21=arg[2]? arg[2][2] : 0;
  a22=(2.*a21);
  a20=(a20+a22);
  a16=(a16+a20);
  a16=(a13*a16);
  a07=(a07+a16);
  a16=(a06*a21);
  a07=(a07-a16);
  a06=(a06*a08);
  a06=(a06*a02);
  a07=(a07-a06);
  a06=(a15*a03);
  a06=(a06+a15);
  a15=casadi_sq(a09);
  a05=(a05*a09);
  a15=(a15-a05);
  a15=(a15-a04);
  a15=(a15+a03);
  a15=(a15+a02);
  a19=(a19-a14);
  a10=(a10+a12);
  a19=(a19+a10);
  a15=(a15+a19);
  a12=sin(a01);
  a11=(a11*a12);
  a17=(a17*a04);
  a11=(a11-a17);
  a15=(a15+a11);
  a17=1.;
  a15=(a15+a17);
  a18=(a18*a15);
  a06=(a06+a18);
  a06=(a06+a20);
  a20=(a07/a06);
  a11=(a19+a11);
  a11=(a08*a11);
  a11=(a21+a11);
  a06=(a11/a06);
  a04=(a04-a19);
  a04=(a08*a04);
  a04=(a04-a21);
  a13=(a13*a04);
  a07=(a06*a07);
  a13=(a13+a07);
  a08=(a08*a10);
  a21=(a21+a08);
  a11=(a11*a06);
  a21=(a21-a11);
  a13=(a13/a21);
  a06=(a06*a13);
  a20=(a20+a06);
  a06=arg[1]? arg[1][1] : 0;
  a20=(a20-a06);
  if (res[0]!=0) res[0][1]=a20;
  a20=arg[1]? arg[1][2] : 0;
  a13=(a13-a20);
  if (res[0]!=0) res[0][2]=a13;
  a00=(2.*a00);
  a01=(a01-a00);
  if (res[0]!=0) res[0][3]=a01;
  return 0;
}

/* round_feet_residual_12:(u[4],p[7])->(R[4]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @5, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w5);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: @3 = landing(@0, @1, @2) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @3 */
  casadi_copy(w3, 4, res[0]);
  return 0;
}

/* round_feet_search_12:(u0[4],p[7])->(u[4],R[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+846, *w1=w+850, *w2=w+857;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_12(@0, @1) */
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
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
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
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #14: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #16: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* newton_24:(u0[4],p[7])->(u[4]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f15(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_residual_24:(u[4],p[7])->(R[4]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #13: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #14: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* round_feet_search_24:(u0[4],p[7])->(u[4],R[4]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+846, *w1=w+850, *w2=w+857;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = round_feet_residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f13(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
  return 0;
}

/* round_feet_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #20: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #21: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #22: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* newton_48:(u0[4],p[7])->(u[4]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f19(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_residual_48:(u[4],p[7])->(R[4]) */
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #19: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #20: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* round_feet_search_48:(u0[4],p[7])->(u[4],R[4]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+846, *w1=w+850, *w2=w+857;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f18(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = round_feet_residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f17(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 16;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 861;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 16*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 861*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_24:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_24:(u0[4],p[7])->(u[4]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f23(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_limit_cycle_24:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f15(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f21(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_36:(u[4],p[7])->(R[4]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #16: @3 = landing(@0, @1, @2) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w3;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][0] = @3 */
  casadi_copy(w3, 4, res[0]);
  return 0;
}

/* coarse_jacobian_36:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f2(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f27(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_36:(u0[4],p[7])->(u[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f26(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_36:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #17: {@5, @0} = landing_with_derivative(@10, @1, @7, @2) */
  arg1[0]=w10;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w05;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #18: output[0][0] = @5 */
  casadi_copy(w05, 16, res[0]);
  /* #19: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_36:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_36(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f25(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_36(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f24(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* coarse_jacobian_48:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f15(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_48:(u0[4],p[7])->(u[4]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f31(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_limit_cycle_48:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f30(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_48(@2, @1) */
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

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f29(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_72:(u[4],p[7])->(R[4]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_72:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f35(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_72:(u0[4],p[7])->(u[4]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f34(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_72:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #26: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #27: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #28: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_72:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_72(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f33(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_72(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f32(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_96:(u[4],p[7])->(R[4]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #31: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #32: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_96:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f19(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_96:(u0[4],p[7])->(u[4]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f39(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_96:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #32: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #33: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #34: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_96:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f38(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f37(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_144:(u[4],p[7])->(R[4]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #43: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #44: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_144:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f45(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_144:(u0[4],p[7])->(u[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f44(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_144:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #44: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #46: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_144:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_144(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f43(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_144(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f42(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_192:(u[4],p[7])->(R[4]) */
static int casadi_f50(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #55: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #56: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_192:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f49(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f50(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_192:(u0[4],p[7])->(u[4]) */
static int casadi_f48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f49(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_192:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f51(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #56: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #57: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #58: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_192:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f48(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f51(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f47(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_288:(u[4],p[7])->(R[4]) */
static int casadi_f55(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #79: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #80: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_288:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f54(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f46(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f55(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_288:(u0[4],p[7])->(u[4]) */
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

/* round_feet_jacobian_288:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f56(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #80: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #81: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #82: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_288:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f52(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_288(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f53(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_288(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f56(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f52(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

/* round_feet_residual_384:(u[4],p[7])->(R[4]) */
static int casadi_f60(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #9: @0 = plain_steps(@3, @4, @7, @6, @2) */
  arg1[0]=w3;
  arg1[1]=(&w4);
  arg1[2]=w7;
  arg1[3]=(&w6);
  arg1[4]=w2;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #103: @0 = landing(@3, @1, @2) */
  arg1[0]=w3;
  arg1[1]=w1;
  arg1[2]=w2;
  res1[0]=w0;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #104: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* coarse_jacobian_384:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f59(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+782, *w1=w+786, *w2=w+793, *w3=w+809;
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
  if (casadi_f51(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 16, res[0]);
  /* #4: @3 = round_feet_residual_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w3;
  if (casadi_f60(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 4, res[1]);
  return 0;
}

/* newton_384:(u0[4],p[7])->(u[4]) */
static int casadi_f58(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f59(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* round_feet_jacobian_384:(u[4],p[7])->(J[4x4],R[4]) */
static int casadi_f61(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w00=w+693, *w01=w+697, *w02=w+700, *w03=w+707, *w04=w+711, *w05=w+723, w06, w07, w08, *w09=w+739;
  casadi_real *w10=w+763;
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
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  /* #104: {@10, @0} = landing_with_derivative(@5, @1, @7, @2) */
  arg1[0]=w05;
  arg1[1]=w01;
  arg1[2]=(&w07);
  arg1[3]=w02;
  res1[0]=w10;
  res1[1]=w00;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #105: output[0][0] = @10 */
  casadi_copy(w10, 16, res[0]);
  /* #106: output[1][0] = @0 */
  casadi_copy(w00, 4, res[1]);
  return 0;
}

/* round_feet_limit_cycle_384:(u0[4],p[7])->(u[4],J[4x4],R[4]) */
static int casadi_f57(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+877, *w1=w+881, *w2=w+888, *w3=w+892;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f58(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = round_feet_jacobian_384(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f61(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f57(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 18;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 908;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 18*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 908*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_residual_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f9(arg, res, iw, w, mem);
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
  return casadi_f16(arg, res, iw, w, mem);
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
  return casadi_f27(arg, res, iw, w, mem);
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
  return casadi_f20(arg, res, iw, w, mem);
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
  return casadi_f35(arg, res, iw, w, mem);
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
  return casadi_f40(arg, res, iw, w, mem);
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
  return casadi_f45(arg, res, iw, w, mem);
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
  return casadi_f50(arg, res, iw, w, mem);
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
  return casadi_f55(arg, res, iw, w, mem);
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
  return casadi_f60(arg, res, iw, w, mem);
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
  return casadi_f2(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f28(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_36_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f36(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f41(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f46(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f51(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f56(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f61(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 779;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_jacobian_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 779*sizeof(casadi_real);
  return 0;
}

/* working_step:(y[4],phase[2],turns[2x12],h,p[7])->(y_end[4]) */
static int casadi_f64(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  a07=arg[4]? arg[4][3] : 0;
  a08=arg[0]? arg[0][3] : 0;
  a09=(a07*a08);
  a09=(a09*a08);
  a10=arg[4]? arg[4][1] : 0;
  a09=(a09*a10);
  a11=arg[0]? arg[0][1] : 0;
  a12=sin(a11);
  a09=(a09*a12);
  a13=cos(a11);
  a14=arg[4]? arg[4][4] : 0;
  a15=(a13*a14);
  a16=casadi_sq(a08);
  a16=(a16*a10);
  a17=(a15*a16);
  a09=(a09-a17);
  a17=casadi_sq(a03);
  a18=arg[4]? arg[4][5] : 0;
  a19=(a17*a18);
  a20=cos(a00);
  a21=(a20*a14);
  a21=(a21*a10);
  a22=(a20*a13);
  a23=sin(a00);
  a24=(a23*a12);
  a22=(a22+a24);
  a24=(a22*a14);
  a25=(a24*a10);
  a21=(a21+a25);
  a25=(a07*a10);
  a26=(a25*a23);
  a21=(a21+a26);
  a26=(a23*a13);
  a27=(a20*a12);
  a26=(a26-a27);
  a27=(a25*a26);
  a21=(a21+a27);
  a27=arg[4]? arg[4][0] : 0;
  a28=(a27*a23);
  a21=(a21-a28);
  a28=(2.*a10);
  a29=(a28*a23);
  a21=(a21-a29);
  a19=(a19*a21);
  a09=(a09-a19);
  a19=(2.*a03);
  a19=(a19*a08);
  a19=(a19*a10);
  a21=(a07*a12);
  a15=(a15-a21);
  a24=(a24*a18);
  a21=(a15+a24);
  a29=(a07*a18);
  a30=(a29*a26);
  a21=(a21+a30);
  a19=(a19*a21);
  a09=(a09+a19);
  a19=(a27*a18);
  a21=arg[4]? arg[4][6] : 0;
  a31=sin(a21);
  a32=(a19*a31);
  a09=(a09-a32);
  a33=cos(a21);
  a34=(a23*a33);
  a35=(a20*a31);
  a34=(a34-a35);
  a35=(a27*a34);
  a09=(a09+a35);
  a35=(a20*a33);
  a36=(a23*a31);
  a35=(a35+a36);
  a35=(a35*a14);
  a36=(a07*a34);
  a35=(a35+a36);
  a36=(2.*a18);
  a36=(a36*a31);
  a35=(a35+a36);
  a34=(2.*a34);
  a35=(a35-a34);
  a34=(a11-a00);
  a34=(a34+a21);
  a37=cos(a34);
  a37=(a37*a14);
  a34=sin(a34);
  a34=(a07*a34);
  a37=(a37-a34);
  a35=(a35+a37);
  a35=(a10*a35);
  a09=(a09-a35);
  a24=(a16*a24);
  a09=(a09-a24);
  a16=(a16*a30);
  a09=(a09-a16);
  a19=(a19*a18);
  a16=(2.*a20);
  a16=(a16*a18);
  a30=(a27*a16);
  a30=(a19+a30);
  a30=(a30+a27);
  a24=arg[4]? arg[4][2] : 0;
  a35=(2.*a24);
  a30=(a30+a35);
  a34=(a14*a18);
  a23=(a34*a23);
  a20=(a20*a07);
  a20=(a20*a18);
  a23=(a23-a20);
  a13=(a13*a07);
  a23=(a23-a13);
  a23=(a23-a07);
  a12=(a14*a12);
  a23=(a23-a12);
  a20=casadi_sq(a18);
  a23=(a23+a20);
  a23=(a23+a16);
  a26=(a34*a26);
  a23=(a23+a26);
  a22=(a22*a07);
  a22=(a22*a18);
  a23=(a23-a22);
  a16=casadi_sq(a07);
  a38=casadi_sq(a14);
  a39=(a16+a38);
  a23=(a23+a39);
  a40=1.;
  a23=(a23+a40);
  a23=(a28*a23);
  a30=(a30+a23);
  a23=(a09/a30);
  a13=(a13-a16);
  a13=(a13-a38);
  a13=(a13+a12);
  a13=(a13-a26);
  a13=(a13+a22);
  a13=(a10*a13);
  a13=(a13-a24);
  a30=(a13/a30);
  a17=(a17*a15);
  a37=(a37-a17);
  a37=(a10*a37);
  a09=(a30*a09);
  a37=(a37-a09);
  a09=(a10*a39);
  a09=(a24+a09);
  a13=(a13*a30);
  a13=(a09-a13);
  a37=(a37/a13);
  a30=(a30*a37);
  a23=(a23-a30);
  a30=(a06*a23);
  a13=1.7082860872947386e-01;
  a13=(a13*a02);
  a17=2.9587585476806851e-02;
  a17=(a17*a02);
  a15=(a17*a37);
  a22=8.8762756430420545e-02;
  a22=(a22*a02);
  a26=1.9725056984537900e-02;
  a26=(a26*a02);
  a12=(a26*a08);
  a41=5.9175170953613701e-02;
  a41=(a41*a02);
  a42=5.2600151958767730e-02;
  a42=(a42*a02);
  a43=(a42*a37);
  a43=(a08+a43);
  a44=(a41*a43);
  a12=(a12+a44);
  a12=(a11+a12);
  a44=(a26*a03);
  a45=(a42*a23);
  a45=(a03+a45);
  a46=(a41*a45);
  a44=(a44+a46);
  a44=(a00+a44);
  a46=(a12-a44);
  a46=(a46+a21);
  a47=cos(a46);
  a47=(a47*a14);
  a46=sin(a46);
  a46=(a07*a46);
  a47=(a47-a46);
  a46=(a26*a23);
  a48=(a07*a43);
  a48=(a48*a43);
  a48=(a48*a10);
  a49=(a42*a08);
  a49=(a11+a49);
  a50=sin(a49);
  a48=(a48*a50);
  a51=cos(a49);
  a52=(a51*a14);
  a53=casadi_sq(a43);
  a53=(a53*a10);
  a54=(a52*a53);
  a48=(a48-a54);
  a54=casadi_sq(a45);
  a55=(a54*a18);
  a42=(a42*a03);
  a42=(a00+a42);
  a56=cos(a42);
  a57=(a56*a14);
  a57=(a57*a10);
  a58=(a56*a51);
  a59=sin(a42);
  a60=(a59*a50);
  a58=(a58+a60);
  a60=(a58*a14);
  a61=(a60*a10);
  a57=(a57+a61);
  a61=(a25*a59);
  a57=(a57+a61);
  a61=(a59*a51);
  a62=(a56*a50);
  a61=(a61-a62);
  a62=(a25*a61);
  a57=(a57+a62);
  a62=(a27*a59);
  a57=(a57-a62);
  a62=(a28*a59);
  a57=(a57-a62);
  a55=(a55*a57);
  a48=(a48-a55);
  a45=(2.*a45);
  a45=(a45*a43);
  a45=(a45*a10);
  a43=(a07*a50);
  a52=(a52-a43);
  a60=(a60*a18);
  a43=(a52+a60);
  a55=(a29*a61);
  a43=(a43+a55);
  a45=(a45*a43);
  a48=(a48+a45);
  a48=(a48-a32);
  a45=(a59*a33);
  a43=(a56*a31);
  a45=(a45-a43);
  a43=(a27*a45);
  a48=(a48+a43);
  a43=(a56*a33);
  a57=(a59*a31);
  a43=(a43+a57);
  a43=(a43*a14);
  a57=(a07*a45);
  a43=(a43+a57);
  a43=(a43+a36);
  a45=(2.*a45);
  a43=(a43-a45);
  a49=(a49-a42);
  a49=(a49+a21);
  a42=cos(a49);
  a42=(a42*a14);
  a49=sin(a49);
  a49=(a07*a49);
  a42=(a42-a49);
  a43=(a43+a42);
  a43=(a10*a43);
  a48=(a48-a43);
  a60=(a53*a60);
  a48=(a48-a60);
  a53=(a53*a55);
  a48=(a48-a53);
  a53=(2.*a56);
  a53=(a53*a18);
  a55=(a27*a53);
  a55=(a19+a55);
  a55=(a55+a27);
  a55=(a55+a35);
  a59=(a34*a59);
  a56=(a56*a07);
  a56=(a56*a18);
  a59=(a59-a56);
  a51=(a51*a07);
  a59=(a59-a51);
  a59=(a59-a07);
  a50=(a14*a50);
  a59=(a59-a50);
  a59=(a59+a20);
  a59=(a59+a53);
  a61=(a34*a61);
  a59=(a59+a61);
  a58=(a58*a07);
  a58=(a58*a18);
  a59=(a59-a58);
  a59=(a59+a39);
  a59=(a59+a40);
  a59=(a28*a59);
  a55=(a55+a59);
  a59=(a48/a55);
  a51=(a51-a16);
  a51=(a51-a38);
  a51=(a51+a50);
  a51=(a51-a61);
  a51=(a51+a58);
  a51=(a10*a51);
  a51=(a51-a24);
  a55=(a51/a55);
  a54=(a54*a52);
  a42=(a42-a54);
  a42=(a10*a42);
  a48=(a55*a48);
  a42=(a42-a48);
  a51=(a51*a55);
  a51=(a09-a51);
  a42=(a42/a51);
  a55=(a55*a42);
  a59=(a59-a55);
  a59=(a41*a59);
  a46=(a46+a59);
  a46=(a03+a46);
  a59=casadi_sq(a46);
  a55=cos(a12);
  a51=(a55*a14);
  a12=sin(a12);
  a48=(a07*a12);
  a48=(a51-a48);
  a54=(a59*a48);
  a54=(a47-a54);
  a54=(a10*a54);
  a52=(a55*a07);
  a58=(a52-a16);
  a58=(a58-a38);
  a61=(a14*a12);
  a58=(a58+a61);
  a50=sin(a44);
  a53=(a50*a55);
  a44=cos(a44);
  a56=(a44*a12);
  a53=(a53-a56);
  a56=(a34*a53);
  a58=(a58-a56);
  a55=(a44*a55);
  a60=(a50*a12);
  a55=(a55+a60);
  a60=(a55*a07);
  a60=(a60*a18);
  a58=(a58+a60);
  a58=(a10*a58);
  a58=(a58-a24);
  a43=(2.*a44);
  a43=(a43*a18);
  a49=(a27*a43);
  a49=(a19+a49);
  a49=(a49+a27);
  a49=(a49+a35);
  a45=(a34*a50);
  a57=(a44*a07);
  a57=(a57*a18);
  a45=(a45-a57);
  a45=(a45-a52);
  a45=(a45-a07);
  a45=(a45-a61);
  a45=(a45+a20);
  a45=(a45+a43);
  a45=(a45+a56);
  a45=(a45-a60);
  a45=(a45+a39);
  a45=(a45+a40);
  a45=(a28*a45);
  a49=(a49+a45);
  a45=(a58/a49);
  a26=(a26*a37);
  a41=(a41*a42);
  a26=(a26+a41);
  a26=(a08+a26);
  a41=(a07*a26);
  a41=(a41*a26);
  a41=(a41*a10);
  a41=(a41*a12);
  a12=casadi_sq(a26);
  a12=(a12*a10);
  a51=(a51*a12);
  a41=(a41-a51);
  a59=(a59*a18);
  a51=(a44*a14);
  a51=(a51*a10);
  a55=(a55*a14);
  a42=(a55*a10);
  a51=(a51+a42);
  a42=(a25*a50);
  a51=(a51+a42);
  a42=(a25*a53);
  a51=(a51+a42);
  a42=(a27*a50);
  a51=(a51-a42);
  a42=(a28*a50);
  a51=(a51-a42);
  a59=(a59*a51);
  a41=(a41-a59);
  a59=(2.*a46);
  a59=(a59*a26);
  a59=(a59*a10);
  a55=(a55*a18);
  a48=(a48+a55);
  a53=(a29*a53);
  a48=(a48+a53);
  a59=(a59*a48);
  a41=(a41+a59);
  a41=(a41-a32);
  a59=(a50*a33);
  a48=(a44*a31);
  a59=(a59-a48);
  a48=(a27*a59);
  a41=(a41+a48);
  a44=(a44*a33);
  a50=(a50*a31);
  a44=(a44+a50);
  a44=(a44*a14);
  a50=(a07*a59);
  a44=(a44+a50);
  a44=(a44+a36);
  a59=(2.*a59);
  a44=(a44-a59);
  a44=(a44+a47);
  a44=(a10*a44);
  a41=(a41-a44);
  a55=(a12*a55);
  a41=(a41-a55);
  a12=(a12*a53);
  a41=(a41-a12);
  a12=(a45*a41);
  a54=(a54-a12);
  a58=(a58*a45);
  a58=(a09-a58);
  a54=(a54/a58);
  a58=(a22*a54);
  a15=(a15+a58);
  a15=(a08+a15);
  a58=(a07*a15);
  a58=(a58*a15);
  a58=(a58*a10);
  a12=(a17*a08);
  a53=(a22*a26);
  a12=(a12+a53);
  a12=(a11+a12);
  a53=sin(a12);
  a58=(a58*a53);
  a55=cos(a12);
  a44=(a55*a14);
  a47=casadi_sq(a15);
  a47=(a47*a10);
  a59=(a44*a47);
  a58=(a58-a59);
  a59=(a17*a23);
  a41=(a41/a49);
  a45=(a45*a54);
  a41=(a41-a45);
  a45=(a22*a41);
  a59=(a59+a45);
  a59=(a03+a59);
  a45=casadi_sq(a59);
  a49=(a45*a18);
  a17=(a17*a03);
  a22=(a22*a46);
  a17=(a17+a22);
  a17=(a00+a17);
  a22=cos(a17);
  a50=(a22*a14);
  a50=(a50*a10);
  a48=(a22*a55);
  a51=sin(a17);
  a42=(a51*a53);
  a48=(a48+a42);
  a42=(a48*a14);
  a60=(a42*a10);
  a50=(a50+a60);
  a60=(a25*a51);
  a50=(a50+a60);
  a60=(a51*a55);
  a56=(a22*a53);
  a60=(a60-a56);
  a56=(a25*a60);
  a50=(a50+a56);
  a56=(a27*a51);
  a50=(a50-a56);
  a56=(a28*a51);
  a50=(a50-a56);
  a49=(a49*a50);
  a58=(a58-a49);
  a49=(2.*a59);
  a49=(a49*a15);
  a49=(a49*a10);
  a50=(a07*a53);
  a44=(a44-a50);
  a42=(a42*a18);
  a50=(a44+a42);
  a56=(a29*a60);
  a50=(a50+a56);
  a49=(a49*a50);
  a58=(a58+a49);
  a58=(a58-a32);
  a49=(a51*a33);
  a50=(a22*a31);
  a49=(a49-a50);
  a50=(a27*a49);
  a58=(a58+a50);
  a50=(a22*a33);
  a43=(a51*a31);
  a50=(a50+a43);
  a50=(a50*a14);
  a43=(a07*a49);
  a50=(a50+a43);
  a50=(a50+a36);
  a49=(2.*a49);
  a50=(a50-a49);
  a12=(a12-a17);
  a12=(a12+a21);
  a17=cos(a12);
  a17=(a17*a14);
  a12=sin(a12);
  a12=(a07*a12);
  a17=(a17-a12);
  a50=(a50+a17);
  a50=(a10*a50);
  a58=(a58-a50);
  a42=(a47*a42);
  a58=(a58-a42);
  a47=(a47*a56);
  a58=(a58-a47);
  a47=(2.*a22);
  a47=(a47*a18);
  a56=(a27*a47);
  a56=(a19+a56);
  a56=(a56+a27);
  a56=(a56+a35);
  a51=(a34*a51);
  a22=(a22*a07);
  a22=(a22*a18);
  a51=(a51-a22);
  a55=(a55*a07);
  a51=(a51-a55);
  a51=(a51-a07);
  a53=(a14*a53);
  a51=(a51-a53);
  a51=(a51+a20);
  a51=(a51+a47);
  a60=(a34*a60);
  a51=(a51+a60);
  a48=(a48*a07);
  a48=(a48*a18);
  a51=(a51-a48);
  a51=(a51+a39);
  a51=(a51+a40);
  a51=(a28*a51);
  a56=(a56+a51);
  a51=(a58/a56);
  a55=(a55-a16);
  a55=(a55-a38);
  a55=(a55+a53);
  a55=(a55-a60);
  a55=(a55+a48);
  a55=(a10*a55);
  a55=(a55-a24);
  a56=(a55/a56);
  a45=(a45*a44);
  a17=(a17-a45);
  a17=(a10*a17);
  a58=(a56*a58);
  a17=(a17-a58);
  a55=(a55*a56);
  a55=(a09-a55);
  a17=(a17/a55);
  a56=(a56*a17);
  a51=(a51-a56);
  a56=(a13*a51);
  a30=(a30+a56);
  a56=1.2546768756682242e-01;
  a56=(a56*a02);
  a55=2.4136513415926669e-01;
  a55=(a55*a02);
  a58=(a55*a37);
  a45=-8.8454947932828609e-01;
  a45=(a45*a02);
  a54=(a45*a54);
  a58=(a58+a54);
  a54=9.2483400326179199e-01;
  a54=(a54*a02);
  a44=(a54*a17);
  a58=(a58+a44);
  a58=(a08+a58);
  a44=(a07*a58);
  a44=(a44*a58);
  a44=(a44*a10);
  a48=(a55*a08);
  a26=(a45*a26);
  a48=(a48+a26);
  a26=(a54*a15);
  a48=(a48+a26);
  a48=(a11+a48);
  a26=sin(a48);
  a44=(a44*a26);
  a60=cos(a48);
  a53=(a60*a14);
  a47=casadi_sq(a58);
  a47=(a47*a10);
  a22=(a53*a47);
  a44=(a44-a22);
  a22=(a55*a23);
  a41=(a45*a41);
  a22=(a22+a41);
  a41=(a54*a51);
  a22=(a22+a41);
  a22=(a03+a22);
  a41=casadi_sq(a22);
  a42=(a41*a18);
  a55=(a55*a03);
  a45=(a45*a46);
  a55=(a55+a45);
  a54=(a54*a59);
  a55=(a55+a54);
  a55=(a00+a55);
  a54=cos(a55);
  a45=(a54*a14);
  a45=(a45*a10);
  a46=(a54*a60);
  a50=sin(a55);
  a12=(a50*a26);
  a46=(a46+a12);
  a12=(a46*a14);
  a49=(a12*a10);
  a45=(a45+a49);
  a49=(a25*a50);
  a45=(a45+a49);
  a49=(a50*a60);
  a43=(a54*a26);
  a49=(a49-a43);
  a43=(a25*a49);
  a45=(a45+a43);
  a43=(a27*a50);
  a45=(a45-a43);
  a43=(a28*a50);
  a45=(a45-a43);
  a42=(a42*a45);
  a44=(a44-a42);
  a42=(2.*a22);
  a42=(a42*a58);
  a42=(a42*a10);
  a45=(a07*a26);
  a53=(a53-a45);
  a12=(a12*a18);
  a45=(a53+a12);
  a43=(a29*a49);
  a45=(a45+a43);
  a42=(a42*a45);
  a44=(a44+a42);
  a44=(a44-a32);
  a42=(a50*a33);
  a45=(a54*a31);
  a42=(a42-a45);
  a45=(a27*a42);
  a44=(a44+a45);
  a45=(a54*a33);
  a61=(a50*a31);
  a45=(a45+a61);
  a45=(a45*a14);
  a61=(a07*a42);
  a45=(a45+a61);
  a45=(a45+a36);
  a42=(2.*a42);
  a45=(a45-a42);
  a48=(a48-a55);
  a48=(a48+a21);
  a55=cos(a48);
  a55=(a55*a14);
  a48=sin(a48);
  a48=(a07*a48);
  a55=(a55-a48);
  a45=(a45+a55);
  a45=(a10*a45);
  a44=(a44-a45);
  a12=(a47*a12);
  a44=(a44-a12);
  a47=(a47*a43);
  a44=(a44-a47);
  a47=(2.*a54);
  a47=(a47*a18);
  a43=(a27*a47);
  a43=(a19+a43);
  a43=(a43+a27);
  a43=(a43+a35);
  a50=(a34*a50);
  a54=(a54*a07);
  a54=(a54*a18);
  a50=(a50-a54);
  a60=(a60*a07);
  a50=(a50-a60);
  a50=(a50-a07);
  a26=(a14*a26);
  a50=(a50-a26);
  a50=(a50+a20);
  a50=(a50+a47);
  a49=(a34*a49);
  a50=(a50+a49);
  a46=(a46*a07);
  a46=(a46*a18);
  a50=(a50-a46);
  a50=(a50+a39);
  a50=(a50+a40);
  a50=(a28*a50);
  a43=(a43+a50);
  a50=(a44/a43);
  a60=(a60-a16);
  a60=(a60-a38);
  a60=(a60+a26);
  a60=(a60-a49);
  a60=(a60+a46);
  a60=(a10*a60);
  a60=(a60-a24);
  a43=(a60/a43);
  a41=(a41*a53);
  a55=(a55-a41);
  a55=(a10*a55);
  a44=(a43*a44);
  a55=(a55-a44);
  a60=(a60*a43);
  a60=(a09-a60);
  a55=(a55/a60);
  a43=(a43*a55);
  a50=(a50-a43);
  a43=(a56*a50);
  a30=(a30+a43);
  a30=(a03+a30);
  a43=(a05*a30);
  a04=(a04+a43);
  a43=1.8915178993145003e+00;
  a43=(a43*a02);
  a60=3.7109375000000000e-02;
  a60=(a60*a02);
  a44=(a60*a23);
  a41=1.7025221101954405e-01;
  a41=(a41*a02);
  a53=(a41*a51);
  a44=(a44+a53);
  a53=6.0216538980455959e-02;
  a53=(a53*a02);
  a46=(a53*a50);
  a44=(a44+a46);
  a46=-1.7578125000000000e-02;
  a46=(a46*a02);
  a49=(a06*a37);
  a26=(a13*a17);
  a49=(a49+a26);
  a26=(a56*a55);
  a49=(a49+a26);
  a49=(a08+a49);
  a26=(a07*a49);
  a26=(a26*a49);
  a26=(a26*a10);
  a47=(a06*a08);
  a54=(a13*a15);
  a47=(a47+a54);
  a54=(a56*a58);
  a47=(a47+a54);
  a47=(a11+a47);
  a54=sin(a47);
  a26=(a26*a54);
  a12=cos(a47);
  a45=(a12*a14);
  a48=casadi_sq(a49);
  a48=(a48*a10);
  a42=(a45*a48);
  a26=(a26-a42);
  a42=casadi_sq(a30);
  a61=(a42*a18);
  a06=(a06*a03);
  a13=(a13*a59);
  a06=(a06+a13);
  a56=(a56*a22);
  a06=(a06+a56);
  a06=(a00+a06);
  a56=cos(a06);
  a13=(a56*a14);
  a13=(a13*a10);
  a52=(a56*a12);
  a57=sin(a06);
  a62=(a57*a54);
  a52=(a52+a62);
  a62=(a52*a14);
  a63=(a62*a10);
  a13=(a13+a63);
  a63=(a25*a57);
  a13=(a13+a63);
  a63=(a57*a12);
  a64=(a56*a54);
  a63=(a63-a64);
  a64=(a25*a63);
  a13=(a13+a64);
  a64=(a27*a57);
  a13=(a13-a64);
  a64=(a28*a57);
  a13=(a13-a64);
  a61=(a61*a13);
  a26=(a26-a61);
  a61=(2.*a30);
  a61=(a61*a49);
  a61=(a61*a10);
  a13=(a07*a54);
  a45=(a45-a13);
  a62=(a62*a18);
  a13=(a45+a62);
  a64=(a29*a63);
  a13=(a13+a64);
  a61=(a61*a13);
  a26=(a26+a61);
  a26=(a26-a32);
  a61=(a57*a33);
  a13=(a56*a31);
  a61=(a61-a13);
  a13=(a27*a61);
  a26=(a26+a13);
  a13=(a56*a33);
  a65=(a57*a31);
  a13=(a13+a65);
  a13=(a13*a14);
  a65=(a07*a61);
  a13=(a13+a65);
  a13=(a13+a36);
  a61=(2.*a61);
  a13=(a13-a61);
  a47=(a47-a06);
  a47=(a47+a21);
  a06=cos(a47);
  a06=(a06*a14);
  a47=sin(a47);
  a47=(a07*a47);
  a06=(a06-a47);
  a13=(a13+a06);
  a13=(a10*a13);
  a26=(a26-a13);
  a62=(a48*a62);
  a26=(a26-a62);
  a48=(a48*a64);
  a26=(a26-a48);
  a48=(2.*a56);
  a48=(a48*a18);
  a64=(a27*a48);
  a64=(a19+a64);
  a64=(a64+a27);
  a64=(a64+a35);
  a57=(a34*a57);
  a56=(a56*a07);
  a56=(a56*a18);
  a57=(a57-a56);
  a12=(a12*a07);
  a57=(a57-a12);
  a57=(a57-a07);
  a54=(a14*a54);
  a57=(a57-a54);
  a57=(a57+a20);
  a57=(a57+a48);
  a63=(a34*a63);
  a57=(a57+a63);
  a52=(a52*a07);
  a52=(a52*a18);
  a57=(a57-a52);
  a57=(a57+a39);
  a57=(a57+a40);
  a57=(a28*a57);
  a64=(a64+a57);
  a57=(a26/a64);
  a12=(a12-a16);
  a12=(a12-a38);
  a12=(a12+a54);
  a12=(a12-a63);
  a12=(a12+a52);
  a12=(a10*a12);
  a12=(a12-a24);
  a64=(a12/a64);
  a42=(a42*a45);
  a06=(a06-a42);
  a06=(a10*a06);
  a26=(a64*a26);
  a06=(a06-a26);
  a12=(a12*a64);
  a12=(a09-a12);
  a06=(a06/a12);
  a64=(a64*a06);
  a57=(a57-a64);
  a64=(a46*a57);
  a44=(a44+a64);
  a44=(a03+a44);
  a64=(a43*a44);
  a04=(a04+a64);
  a64=-5.8012039600105849e+00;
  a64=(a64*a02);
  a12=3.7092000118504789e-02;
  a12=(a12*a02);
  a26=(a12*a23);
  a42=1.7038392571223998e-01;
  a42=(a42*a02);
  a45=(a42*a51);
  a26=(a26+a45);
  a45=1.0726203044637328e-01;
  a45=(a45*a02);
  a52=(a45*a50);
  a26=(a26+a52);
  a52=-1.5319437748624402e-02;
  a52=(a52*a02);
  a63=(a52*a57);
  a26=(a26+a63);
  a63=8.2737891638140233e-03;
  a63=(a63*a02);
  a54=(a60*a37);
  a48=(a41*a17);
  a54=(a54+a48);
  a48=(a53*a55);
  a54=(a54+a48);
  a48=(a46*a06);
  a54=(a54+a48);
  a54=(a08+a54);
  a48=(a07*a54);
  a48=(a48*a54);
  a48=(a48*a10);
  a56=(a60*a08);
  a62=(a41*a15);
  a56=(a56+a62);
  a62=(a53*a58);
  a56=(a56+a62);
  a62=(a46*a49);
  a56=(a56+a62);
  a56=(a11+a56);
  a62=sin(a56);
  a48=(a48*a62);
  a13=cos(a56);
  a47=(a13*a14);
  a61=casadi_sq(a54);
  a61=(a61*a10);
  a65=(a47*a61);
  a48=(a48-a65);
  a65=casadi_sq(a44);
  a66=(a65*a18);
  a60=(a60*a03);
  a41=(a41*a59);
  a60=(a60+a41);
  a53=(a53*a22);
  a60=(a60+a53);
  a46=(a46*a30);
  a60=(a60+a46);
  a60=(a00+a60);
  a46=cos(a60);
  a53=(a46*a14);
  a53=(a53*a10);
  a41=(a46*a13);
  a67=sin(a60);
  a68=(a67*a62);
  a41=(a41+a68);
  a68=(a41*a14);
  a69=(a68*a10);
  a53=(a53+a69);
  a69=(a25*a67);
  a53=(a53+a69);
  a69=(a67*a13);
  a70=(a46*a62);
  a69=(a69-a70);
  a70=(a25*a69);
  a53=(a53+a70);
  a70=(a27*a67);
  a53=(a53-a70);
  a70=(a28*a67);
  a53=(a53-a70);
  a66=(a66*a53);
  a48=(a48-a66);
  a66=(2.*a44);
  a66=(a66*a54);
  a66=(a66*a10);
  a53=(a07*a62);
  a47=(a47-a53);
  a68=(a68*a18);
  a53=(a47+a68);
  a70=(a29*a69);
  a53=(a53+a70);
  a66=(a66*a53);
  a48=(a48+a66);
  a48=(a48-a32);
  a66=(a67*a33);
  a53=(a46*a31);
  a66=(a66-a53);
  a53=(a27*a66);
  a48=(a48+a53);
  a53=(a46*a33);
  a71=(a67*a31);
  a53=(a53+a71);
  a53=(a53*a14);
  a71=(a07*a66);
  a53=(a53+a71);
  a53=(a53+a36);
  a66=(2.*a66);
  a53=(a53-a66);
  a56=(a56-a60);
  a56=(a56+a21);
  a60=cos(a56);
  a60=(a60*a14);
  a56=sin(a56);
  a56=(a07*a56);
  a60=(a60-a56);
  a53=(a53+a60);
  a53=(a10*a53);
  a48=(a48-a53);
  a68=(a61*a68);
  a48=(a48-a68);
  a61=(a61*a70);
  a48=(a48-a61);
  a61=(2.*a46);
  a61=(a61*a18);
  a70=(a27*a61);
  a70=(a19+a70);
  a70=(a70+a27);
  a70=(a70+a35);
  a67=(a34*a67);
  a46=(a46*a07);
  a46=(a46*a18);
  a67=(a67-a46);
  a13=(a13*a07);
  a67=(a67-a13);
  a67=(a67-a07);
  a62=(a14*a62);
  a67=(a67-a62);
  a67=(a67+a20);
  a67=(a67+a61);
  a69=(a34*a69);
  a67=(a67+a69);
  a41=(a41*a07);
  a41=(a41*a18);
  a67=(a67-a41);
  a67=(a67+a39);
  a67=(a67+a40);
  a67=(a28*a67);
  a70=(a70+a67);
  a67=(a48/a70);
  a13=(a13-a16);
  a13=(a13-a38);
  a13=(a13+a62);
  a13=(a13-a69);
  a13=(a13+a41);
  a13=(a10*a13);
  a13=(a13-a24);
  a70=(a13/a70);
  a65=(a65*a47);
  a60=(a60-a65);
  a60=(a10*a60);
  a48=(a70*a48);
  a60=(a60-a48);
  a13=(a13*a70);
  a13=(a09-a13);
  a60=(a60/a13);
  a70=(a70*a60);
  a67=(a67-a70);
  a70=(a63*a67);
  a26=(a26+a70);
  a26=(a03+a26);
  a70=(a64*a26);
  a04=(a04+a70);
  a70=3.1116436695781990e-01;
  a70=(a70*a02);
  a13=6.2411095871607569e-01;
  a13=(a13*a02);
  a48=(a13*a23);
  a65=-3.3608926294469414e+00;
  a65=(a65*a02);
  a47=(a65*a51);
  a48=(a48+a47);
  a47=-8.6821934684172597e-01;
  a47=(a47*a02);
  a41=(a47*a50);
  a48=(a48+a41);
  a41=2.7592099699446710e+01;
  a41=(a41*a02);
  a69=(a41*a57);
  a48=(a48+a69);
  a69=2.0154067550477894e+01;
  a69=(a69*a02);
  a62=(a69*a67);
  a48=(a48+a62);
  a62=-4.3489884181069961e+01;
  a62=(a62*a02);
  a61=(a12*a37);
  a46=(a42*a17);
  a61=(a61+a46);
  a46=(a45*a55);
  a61=(a61+a46);
  a46=(a52*a06);
  a61=(a61+a46);
  a46=(a63*a60);
  a61=(a61+a46);
  a61=(a08+a61);
  a46=(a07*a61);
  a46=(a46*a61);
  a46=(a46*a10);
  a68=(a12*a08);
  a53=(a42*a15);
  a68=(a68+a53);
  a53=(a45*a58);
  a68=(a68+a53);
  a53=(a52*a49);
  a68=(a68+a53);
  a53=(a63*a54);
  a68=(a68+a53);
  a68=(a11+a68);
  a53=sin(a68);
  a46=(a46*a53);
  a56=cos(a68);
  a66=(a56*a14);
  a71=casadi_sq(a61);
  a71=(a71*a10);
  a72=(a66*a71);
  a46=(a46-a72);
  a72=casadi_sq(a26);
  a73=(a72*a18);
  a12=(a12*a03);
  a42=(a42*a59);
  a12=(a12+a42);
  a45=(a45*a22);
  a12=(a12+a45);
  a52=(a52*a30);
  a12=(a12+a52);
  a63=(a63*a44);
  a12=(a12+a63);
  a12=(a00+a12);
  a63=cos(a12);
  a52=(a63*a14);
  a52=(a52*a10);
  a45=(a63*a56);
  a42=sin(a12);
  a74=(a42*a53);
  a45=(a45+a74);
  a74=(a45*a14);
  a75=(a74*a10);
  a52=(a52+a75);
  a75=(a25*a42);
  a52=(a52+a75);
  a75=(a42*a56);
  a76=(a63*a53);
  a75=(a75-a76);
  a76=(a25*a75);
  a52=(a52+a76);
  a76=(a27*a42);
  a52=(a52-a76);
  a76=(a28*a42);
  a52=(a52-a76);
  a73=(a73*a52);
  a46=(a46-a73);
  a73=(2.*a26);
  a73=(a73*a61);
  a73=(a73*a10);
  a52=(a07*a53);
  a66=(a66-a52);
  a74=(a74*a18);
  a52=(a66+a74);
  a76=(a29*a75);
  a52=(a52+a76);
  a73=(a73*a52);
  a46=(a46+a73);
  a46=(a46-a32);
  a73=(a42*a33);
  a52=(a63*a31);
  a73=(a73-a52);
  a52=(a27*a73);
  a46=(a46+a52);
  a52=(a63*a33);
  a77=(a42*a31);
  a52=(a52+a77);
  a52=(a52*a14);
  a77=(a07*a73);
  a52=(a52+a77);
  a52=(a52+a36);
  a73=(2.*a73);
  a52=(a52-a73);
  a68=(a68-a12);
  a68=(a68+a21);
  a12=cos(a68);
  a12=(a12*a14);
  a68=sin(a68);
  a68=(a07*a68);
  a12=(a12-a68);
  a52=(a52+a12);
  a52=(a10*a52);
  a46=(a46-a52);
  a74=(a71*a74);
  a46=(a46-a74);
  a71=(a71*a76);
  a46=(a46-a71);
  a71=(2.*a63);
  a71=(a71*a18);
  a76=(a27*a71);
  a76=(a19+a76);
  a76=(a76+a27);
  a76=(a76+a35);
  a42=(a34*a42);
  a63=(a63*a07);
  a63=(a63*a18);
  a42=(a42-a63);
  a56=(a56*a07);
  a42=(a42-a56);
  a42=(a42-a07);
  a53=(a14*a53);
  a42=(a42-a53);
  a42=(a42+a20);
  a42=(a42+a71);
  a75=(a34*a75);
  a42=(a42+a75);
  a45=(a45*a07);
  a45=(a45*a18);
  a42=(a42-a45);
  a42=(a42+a39);
  a42=(a42+a40);
  a42=(a28*a42);
  a76=(a76+a42);
  a42=(a46/a76);
  a56=(a56-a16);
  a56=(a56-a38);
  a56=(a56+a53);
  a56=(a56-a75);
  a56=(a56+a45);
  a56=(a10*a56);
  a56=(a56-a24);
  a76=(a56/a76);
  a72=(a72*a66);
  a12=(a12-a72);
  a12=(a10*a12);
  a46=(a76*a46);
  a12=(a12-a46);
  a56=(a56*a76);
  a56=(a09-a56);
  a12=(a12/a56);
  a76=(a76*a12);
  a42=(a42-a76);
  a76=(a62*a42);
  a48=(a48+a76);
  a48=(a03+a48);
  a76=(a70*a48);
  a04=(a04+a76);
  a76=-1.5216094966251609e-01;
  a76=(a76*a02);
  a56=4.7766253643826434e-01;
  a56=(a56*a02);
  a46=(a56*a23);
  a72=-2.4881146199716677e+00;
  a72=(a72*a02);
  a66=(a72*a51);
  a46=(a46+a66);
  a66=-5.9029082683684297e-01;
  a66=(a66*a02);
  a45=(a66*a50);
  a46=(a46+a45);
  a45=2.1230051448181193e+01;
  a45=(a45*a02);
  a75=(a45*a57);
  a46=(a46+a75);
  a75=1.5279233632882423e+01;
  a75=(a75*a02);
  a53=(a75*a67);
  a46=(a46+a53);
  a53=-3.3288210968984863e+01;
  a53=(a53*a02);
  a71=(a53*a42);
  a46=(a46+a71);
  a71=-2.0331201708508627e-02;
  a71=(a71*a02);
  a63=(a13*a37);
  a74=(a65*a17);
  a63=(a63+a74);
  a74=(a47*a55);
  a63=(a63+a74);
  a74=(a41*a06);
  a63=(a63+a74);
  a74=(a69*a60);
  a63=(a63+a74);
  a74=(a62*a12);
  a63=(a63+a74);
  a63=(a08+a63);
  a74=(a07*a63);
  a74=(a74*a63);
  a74=(a74*a10);
  a52=(a13*a08);
  a68=(a65*a15);
  a52=(a52+a68);
  a68=(a47*a58);
  a52=(a52+a68);
  a68=(a41*a49);
  a52=(a52+a68);
  a68=(a69*a54);
  a52=(a52+a68);
  a68=(a62*a61);
  a52=(a52+a68);
  a52=(a11+a52);
  a68=sin(a52);
  a74=(a74*a68);
  a73=cos(a52);
  a77=(a73*a14);
  a78=casadi_sq(a63);
  a78=(a78*a10);
  a79=(a77*a78);
  a74=(a74-a79);
  a79=casadi_sq(a48);
  a80=(a79*a18);
  a13=(a13*a03);
  a65=(a65*a59);
  a13=(a13+a65);
  a47=(a47*a22);
  a13=(a13+a47);
  a41=(a41*a30);
  a13=(a13+a41);
  a69=(a69*a44);
  a13=(a13+a69);
  a62=(a62*a26);
  a13=(a13+a62);
  a13=(a00+a13);
  a62=cos(a13);
  a69=(a62*a14);
  a69=(a69*a10);
  a41=(a62*a73);
  a47=sin(a13);
  a65=(a47*a68);
  a41=(a41+a65);
  a65=(a41*a14);
  a81=(a65*a10);
  a69=(a69+a81);
  a81=(a25*a47);
  a69=(a69+a81);
  a81=(a47*a73);
  a82=(a62*a68);
  a81=(a81-a82);
  a82=(a25*a81);
  a69=(a69+a82);
  a82=(a27*a47);
  a69=(a69-a82);
  a82=(a28*a47);
  a69=(a69-a82);
  a80=(a80*a69);
  a74=(a74-a80);
  a80=(2.*a48);
  a80=(a80*a63);
  a80=(a80*a10);
  a69=(a07*a68);
  a77=(a77-a69);
  a65=(a65*a18);
  a69=(a77+a65);
  a82=(a29*a81);
  a69=(a69+a82);
  a80=(a80*a69);
  a74=(a74+a80);
  a74=(a74-a32);
  a80=(a47*a33);
  a69=(a62*a31);
  a80=(a80-a69);
  a69=(a27*a80);
  a74=(a74+a69);
  a69=(a62*a33);
  a83=(a47*a31);
  a69=(a69+a83);
  a69=(a69*a14);
  a83=(a07*a80);
  a69=(a69+a83);
  a69=(a69+a36);
  a80=(2.*a80);
  a69=(a69-a80);
  a52=(a52-a13);
  a52=(a52+a21);
  a13=cos(a52);
  a13=(a13*a14);
  a52=sin(a52);
  a52=(a07*a52);
  a13=(a13-a52);
  a69=(a69+a13);
  a69=(a10*a69);
  a74=(a74-a69);
  a65=(a78*a65);
  a74=(a74-a65);
  a78=(a78*a82);
  a74=(a74-a78);
  a78=(2.*a62);
  a78=(a78*a18);
  a82=(a27*a78);
  a82=(a19+a82);
  a82=(a82+a27);
  a82=(a82+a35);
  a47=(a34*a47);
  a62=(a62*a07);
  a62=(a62*a18);
  a47=(a47-a62);
  a73=(a73*a07);
  a47=(a47-a73);
  a47=(a47-a07);
  a68=(a14*a68);
  a47=(a47-a68);
  a47=(a47+a20);
  a47=(a47+a78);
  a81=(a34*a81);
  a47=(a47+a81);
  a41=(a41*a07);
  a41=(a41*a18);
  a47=(a47-a41);
  a47=(a47+a39);
  a47=(a47+a40);
  a47=(a28*a47);
  a82=(a82+a47);
  a47=(a74/a82);
  a73=(a73-a16);
  a73=(a73-a38);
  a73=(a73+a68);
  a73=(a73-a81);
  a73=(a73+a41);
  a73=(a10*a73);
  a73=(a73-a24);
  a82=(a73/a82);
  a79=(a79*a77);
  a13=(a13-a79);
  a13=(a10*a13);
  a74=(a82*a74);
  a13=(a13-a74);
  a73=(a73*a82);
  a73=(a09-a73);
  a13=(a13/a73);
  a82=(a82*a13);
  a47=(a47-a82);
  a82=(a71*a47);
  a46=(a46+a82);
  a46=(a03+a46);
  a82=(a76*a46);
  a04=(a04+a82);
  a82=2.0136540080403034e-01;
  a82=(a82*a02);
  a73=-9.3714243008598730e-01;
  a73=(a73*a02);
  a74=(a73*a23);
  a79=5.1863724288440638e+00;
  a79=(a79*a02);
  a77=(a79*a51);
  a74=(a74+a77);
  a77=1.0914373489967295e+00;
  a77=(a77*a02);
  a41=(a77*a50);
  a74=(a74+a41);
  a41=-8.1497870107469268e+00;
  a41=(a41*a02);
  a81=(a41*a57);
  a74=(a74+a81);
  a81=-1.8520065659996959e+01;
  a81=(a81*a02);
  a68=(a81*a67);
  a74=(a74+a68);
  a68=2.2739487099350505e+01;
  a68=(a68*a02);
  a78=(a68*a42);
  a74=(a74+a78);
  a78=2.4936055526796523e+00;
  a78=(a78*a02);
  a62=(a78*a47);
  a74=(a74+a62);
  a62=-3.0467644718982196e+00;
  a62=(a62*a02);
  a65=(a56*a37);
  a69=(a72*a17);
  a65=(a65+a69);
  a69=(a66*a55);
  a65=(a65+a69);
  a69=(a45*a06);
  a65=(a65+a69);
  a69=(a75*a60);
  a65=(a65+a69);
  a69=(a53*a12);
  a65=(a65+a69);
  a69=(a71*a13);
  a65=(a65+a69);
  a65=(a08+a65);
  a69=(a07*a65);
  a69=(a69*a65);
  a69=(a69*a10);
  a52=(a56*a08);
  a80=(a72*a15);
  a52=(a52+a80);
  a80=(a66*a58);
  a52=(a52+a80);
  a80=(a45*a49);
  a52=(a52+a80);
  a80=(a75*a54);
  a52=(a52+a80);
  a80=(a53*a61);
  a52=(a52+a80);
  a80=(a71*a63);
  a52=(a52+a80);
  a52=(a11+a52);
  a80=sin(a52);
  a69=(a69*a80);
  a83=cos(a52);
  a84=(a83*a14);
  a85=casadi_sq(a65);
  a85=(a85*a10);
  a86=(a84*a85);
  a69=(a69-a86);
  a86=casadi_sq(a46);
  a87=(a86*a18);
  a56=(a56*a03);
  a72=(a72*a59);
  a56=(a56+a72);
  a66=(a66*a22);
  a56=(a56+a66);
  a45=(a45*a30);
  a56=(a56+a45);
  a75=(a75*a44);
  a56=(a56+a75);
  a53=(a53*a26);
  a56=(a56+a53);
  a71=(a71*a48);
  a56=(a56+a71);
  a56=(a00+a56);
  a71=cos(a56);
  a53=(a71*a14);
  a53=(a53*a10);
  a75=(a71*a83);
  a45=sin(a56);
  a66=(a45*a80);
  a75=(a75+a66);
  a66=(a75*a14);
  a72=(a66*a10);
  a53=(a53+a72);
  a72=(a25*a45);
  a53=(a53+a72);
  a72=(a45*a83);
  a88=(a71*a80);
  a72=(a72-a88);
  a88=(a25*a72);
  a53=(a53+a88);
  a88=(a27*a45);
  a53=(a53-a88);
  a88=(a28*a45);
  a53=(a53-a88);
  a87=(a87*a53);
  a69=(a69-a87);
  a87=(2.*a46);
  a87=(a87*a65);
  a87=(a87*a10);
  a53=(a07*a80);
  a84=(a84-a53);
  a66=(a66*a18);
  a53=(a84+a66);
  a88=(a29*a72);
  a53=(a53+a88);
  a87=(a87*a53);
  a69=(a69+a87);
  a69=(a69-a32);
  a87=(a45*a33);
  a53=(a71*a31);
  a87=(a87-a53);
  a53=(a27*a87);
  a69=(a69+a53);
  a53=(a71*a33);
  a89=(a45*a31);
  a53=(a53+a89);
  a53=(a53*a14);
  a89=(a07*a87);
  a53=(a53+a89);
  a53=(a53+a36);
  a87=(2.*a87);
  a53=(a53-a87);
  a52=(a52-a56);
  a52=(a52+a21);
  a56=cos(a52);
  a56=(a56*a14);
  a52=sin(a52);
  a52=(a07*a52);
  a56=(a56-a52);
  a53=(a53+a56);
  a53=(a10*a53);
  a69=(a69-a53);
  a66=(a85*a66);
  a69=(a69-a66);
  a85=(a85*a88);
  a69=(a69-a85);
  a85=(2.*a71);
  a85=(a85*a18);
  a88=(a27*a85);
  a88=(a19+a88);
  a88=(a88+a27);
  a88=(a88+a35);
  a45=(a34*a45);
  a71=(a71*a07);
  a71=(a71*a18);
  a45=(a45-a71);
  a83=(a83*a07);
  a45=(a45-a83);
  a45=(a45-a07);
  a80=(a14*a80);
  a45=(a45-a80);
  a45=(a45+a20);
  a45=(a45+a85);
  a72=(a34*a72);
  a45=(a45+a72);
  a75=(a75*a07);
  a75=(a75*a18);
  a45=(a45-a75);
  a45=(a45+a39);
  a45=(a45+a40);
  a45=(a28*a45);
  a88=(a88+a45);
  a45=(a69/a88);
  a83=(a83-a16);
  a83=(a83-a38);
  a83=(a83+a80);
  a83=(a83-a72);
  a83=(a83+a75);
  a83=(a10*a83);
  a83=(a83-a24);
  a88=(a83/a88);
  a86=(a86*a84);
  a56=(a56-a86);
  a56=(a10*a56);
  a69=(a88*a69);
  a56=(a56-a69);
  a83=(a83*a88);
  a83=(a09-a83);
  a56=(a56/a83);
  a88=(a88*a56);
  a45=(a45-a88);
  a88=(a62*a45);
  a74=(a74+a88);
  a74=(a03+a74);
  a88=(a82*a74);
  a04=(a04+a88);
  a88=4.4710615727772587e-02;
  a88=(a88*a02);
  a83=2.2733101475165380e+00;
  a83=(a83*a02);
  a69=(a83*a23);
  a86=-1.0534495466737249e+01;
  a86=(a86*a02);
  a51=(a86*a51);
  a69=(a69+a51);
  a51=-2.0008720582248625e+00;
  a51=(a51*a02);
  a50=(a51*a50);
  a69=(a69+a50);
  a50=-1.7958931863118799e+01;
  a50=(a50*a02);
  a84=(a50*a57);
  a69=(a69+a84);
  a84=2.7948884529419960e+01;
  a84=(a84*a02);
  a75=(a84*a67);
  a69=(a69+a75);
  a75=-2.8589982771350235e+00;
  a75=(a75*a02);
  a72=(a75*a42);
  a69=(a69+a72);
  a72=-8.8728569335306293e+00;
  a72=(a72*a02);
  a80=(a72*a47);
  a69=(a69+a80);
  a80=1.2360567175794303e+01;
  a80=(a80*a02);
  a85=(a80*a45);
  a69=(a69+a85);
  a85=6.4339274601576357e-01;
  a85=(a85*a02);
  a02=(a73*a37);
  a71=(a79*a17);
  a02=(a02+a71);
  a71=(a77*a55);
  a02=(a02+a71);
  a71=(a41*a06);
  a02=(a02+a71);
  a71=(a81*a60);
  a02=(a02+a71);
  a71=(a68*a12);
  a02=(a02+a71);
  a71=(a78*a13);
  a02=(a02+a71);
  a71=(a62*a56);
  a02=(a02+a71);
  a02=(a08+a02);
  a71=(a07*a02);
  a71=(a71*a02);
  a71=(a71*a10);
  a66=(a73*a08);
  a53=(a79*a15);
  a66=(a66+a53);
  a53=(a77*a58);
  a66=(a66+a53);
  a53=(a41*a49);
  a66=(a66+a53);
  a53=(a81*a54);
  a66=(a66+a53);
  a53=(a68*a61);
  a66=(a66+a53);
  a53=(a78*a63);
  a66=(a66+a53);
  a53=(a62*a65);
  a66=(a66+a53);
  a66=(a11+a66);
  a53=sin(a66);
  a71=(a71*a53);
  a52=cos(a66);
  a87=(a52*a14);
  a89=casadi_sq(a02);
  a89=(a89*a10);
  a90=(a87*a89);
  a71=(a71-a90);
  a90=casadi_sq(a74);
  a91=(a90*a18);
  a73=(a73*a03);
  a79=(a79*a59);
  a73=(a73+a79);
  a77=(a77*a22);
  a73=(a73+a77);
  a41=(a41*a30);
  a73=(a73+a41);
  a81=(a81*a44);
  a73=(a73+a81);
  a68=(a68*a26);
  a73=(a73+a68);
  a78=(a78*a48);
  a73=(a73+a78);
  a62=(a62*a46);
  a73=(a73+a62);
  a73=(a00+a73);
  a62=cos(a73);
  a78=(a62*a14);
  a78=(a78*a10);
  a68=(a62*a52);
  a81=sin(a73);
  a41=(a81*a53);
  a68=(a68+a41);
  a41=(a68*a14);
  a77=(a41*a10);
  a78=(a78+a77);
  a77=(a25*a81);
  a78=(a78+a77);
  a77=(a81*a52);
  a79=(a62*a53);
  a77=(a77-a79);
  a79=(a25*a77);
  a78=(a78+a79);
  a79=(a27*a81);
  a78=(a78-a79);
  a79=(a28*a81);
  a78=(a78-a79);
  a91=(a91*a78);
  a71=(a71-a91);
  a91=(2.*a74);
  a91=(a91*a02);
  a91=(a91*a10);
  a78=(a07*a53);
  a87=(a87-a78);
  a41=(a41*a18);
  a78=(a87+a41);
  a79=(a29*a77);
  a78=(a78+a79);
  a91=(a91*a78);
  a71=(a71+a91);
  a71=(a71-a32);
  a91=(a81*a33);
  a78=(a62*a31);
  a91=(a91-a78);
  a78=(a27*a91);
  a71=(a71+a78);
  a78=(a62*a33);
  a92=(a81*a31);
  a78=(a78+a92);
  a78=(a78*a14);
  a92=(a07*a91);
  a78=(a78+a92);
  a78=(a78+a36);
  a91=(2.*a91);
  a78=(a78-a91);
  a66=(a66-a73);
  a66=(a66+a21);
  a73=cos(a66);
  a73=(a73*a14);
  a66=sin(a66);
  a66=(a07*a66);
  a73=(a73-a66);
  a78=(a78+a73);
  a78=(a10*a78);
  a71=(a71-a78);
  a41=(a89*a41);
  a71=(a71-a41);
  a89=(a89*a79);
  a71=(a71-a89);
  a89=(2.*a62);
  a89=(a89*a18);
  a79=(a27*a89);
  a79=(a19+a79);
  a79=(a79+a27);
  a79=(a79+a35);
  a81=(a34*a81);
  a62=(a62*a07);
  a62=(a62*a18);
  a81=(a81-a62);
  a52=(a52*a07);
  a81=(a81-a52);
  a81=(a81-a07);
  a53=(a14*a53);
  a81=(a81-a53);
  a81=(a81+a20);
  a81=(a81+a89);
  a77=(a34*a77);
  a81=(a81+a77);
  a68=(a68*a07);
  a68=(a68*a18);
  a81=(a81-a68);
  a81=(a81+a39);
  a81=(a81+a40);
  a81=(a28*a81);
  a79=(a79+a81);
  a81=(a71/a79);
  a52=(a52-a16);
  a52=(a52-a38);
  a52=(a52+a53);
  a52=(a52-a77);
  a52=(a52+a68);
  a52=(a10*a52);
  a52=(a52-a24);
  a79=(a52/a79);
  a90=(a90*a87);
  a73=(a73-a90);
  a73=(a10*a73);
  a71=(a79*a71);
  a73=(a73-a71);
  a52=(a52*a79);
  a52=(a09-a52);
  a73=(a73/a52);
  a79=(a79*a73);
  a81=(a81-a79);
  a79=(a85*a81);
  a69=(a69+a79);
  a69=(a03+a69);
  a79=(a88*a69);
  a04=(a04+a79);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a79=(a05*a49);
  a04=(a04+a79);
  a79=(a43*a54);
  a04=(a04+a79);
  a79=(a64*a61);
  a04=(a04+a79);
  a79=(a70*a63);
  a04=(a04+a79);
  a79=(a76*a65);
  a04=(a04+a79);
  a79=(a82*a02);
  a04=(a04+a79);
  a79=(a83*a37);
  a17=(a86*a17);
  a79=(a79+a17);
  a55=(a51*a55);
  a79=(a79+a55);
  a55=(a50*a06);
  a79=(a79+a55);
  a55=(a84*a60);
  a79=(a79+a55);
  a55=(a75*a12);
  a79=(a79+a55);
  a55=(a72*a13);
  a79=(a79+a55);
  a55=(a80*a56);
  a79=(a79+a55);
  a55=(a85*a73);
  a79=(a79+a55);
  a79=(a08+a79);
  a55=(a88*a79);
  a04=(a04+a55);
  a04=(a11+a04);
  if (res[0]!=0) res[0][1]=a04;
  a23=(a01*a23);
  a57=(a05*a57);
  a23=(a23+a57);
  a67=(a43*a67);
  a23=(a23+a67);
  a42=(a64*a42);
  a23=(a23+a42);
  a47=(a70*a47);
  a23=(a23+a47);
  a45=(a76*a45);
  a23=(a23+a45);
  a81=(a82*a81);
  a23=(a23+a81);
  a81=(a07*a79);
  a81=(a81*a79);
  a81=(a81*a10);
  a45=(a83*a08);
  a15=(a86*a15);
  a45=(a45+a15);
  a58=(a51*a58);
  a45=(a45+a58);
  a49=(a50*a49);
  a45=(a45+a49);
  a54=(a84*a54);
  a45=(a45+a54);
  a61=(a75*a61);
  a45=(a45+a61);
  a63=(a72*a63);
  a45=(a45+a63);
  a65=(a80*a65);
  a45=(a45+a65);
  a02=(a85*a02);
  a45=(a45+a02);
  a11=(a11+a45);
  a45=sin(a11);
  a81=(a81*a45);
  a02=cos(a11);
  a65=(a02*a14);
  a63=casadi_sq(a79);
  a63=(a63*a10);
  a61=(a65*a63);
  a81=(a81-a61);
  a61=casadi_sq(a69);
  a54=(a61*a18);
  a83=(a83*a03);
  a86=(a86*a59);
  a83=(a83+a86);
  a51=(a51*a22);
  a83=(a83+a51);
  a50=(a50*a30);
  a83=(a83+a50);
  a84=(a84*a44);
  a83=(a83+a84);
  a75=(a75*a26);
  a83=(a83+a75);
  a72=(a72*a48);
  a83=(a83+a72);
  a80=(a80*a46);
  a83=(a83+a80);
  a85=(a85*a74);
  a83=(a83+a85);
  a00=(a00+a83);
  a83=cos(a00);
  a85=(a83*a14);
  a85=(a85*a10);
  a74=(a83*a02);
  a80=sin(a00);
  a46=(a80*a45);
  a74=(a74+a46);
  a46=(a74*a14);
  a72=(a46*a10);
  a85=(a85+a72);
  a72=(a25*a80);
  a85=(a85+a72);
  a72=(a80*a02);
  a48=(a83*a45);
  a72=(a72-a48);
  a25=(a25*a72);
  a85=(a85+a25);
  a25=(a27*a80);
  a85=(a85-a25);
  a25=(a28*a80);
  a85=(a85-a25);
  a54=(a54*a85);
  a81=(a81-a54);
  a69=(2.*a69);
  a69=(a69*a79);
  a69=(a69*a10);
  a79=(a07*a45);
  a65=(a65-a79);
  a46=(a46*a18);
  a79=(a65+a46);
  a29=(a29*a72);
  a79=(a79+a29);
  a69=(a69*a79);
  a81=(a81+a69);
  a81=(a81-a32);
  a32=(a80*a33);
  a69=(a83*a31);
  a32=(a32-a69);
  a69=(a27*a32);
  a81=(a81+a69);
  a33=(a83*a33);
  a31=(a80*a31);
  a33=(a33+a31);
  a33=(a33*a14);
  a31=(a07*a32);
  a33=(a33+a31);
  a33=(a33+a36);
  a32=(2.*a32);
  a33=(a33-a32);
  a11=(a11-a00);
  a11=(a11+a21);
  a21=cos(a11);
  a21=(a21*a14);
  a11=sin(a11);
  a11=(a07*a11);
  a21=(a21-a11);
  a33=(a33+a21);
  a33=(a10*a33);
  a81=(a81-a33);
  a46=(a63*a46);
  a81=(a81-a46);
  a63=(a63*a29);
  a81=(a81-a63);
  a63=(2.*a83);
  a63=(a63*a18);
  a29=(a27*a63);
  a19=(a19+a29);
  a19=(a19+a27);
  a19=(a19+a35);
  a80=(a34*a80);
  a83=(a83*a07);
  a83=(a83*a18);
  a80=(a80-a83);
  a02=(a02*a07);
  a80=(a80-a02);
  a80=(a80-a07);
  a14=(a14*a45);
  a80=(a80-a14);
  a80=(a80+a20);
  a80=(a80+a63);
  a34=(a34*a72);
  a80=(a80+a34);
  a74=(a74*a07);
  a74=(a74*a18);
  a80=(a80-a74);
  a80=(a80+a39);
  a80=(a80+a40);
  a28=(a28*a80);
  a19=(a19+a28);
  a28=(a81/a19);
  a02=(a02-a16);
  a02=(a02-a38);
  a02=(a02+a14);
  a02=(a02-a34);
  a02=(a02+a74);
  a02=(a10*a02);
  a02=(a02-a24);
  a19=(a02/a19);
  a61=(a61*a65);
  a21=(a21-a61);
  a10=(a10*a21);
  a81=(a19*a81);
  a10=(a10-a81);
  a02=(a02*a19);
  a09=(a09-a02);
  a10=(a10/a09);
  a19=(a19*a10);
  a28=(a28-a19);
  a28=(a88*a28);
  a23=(a23+a28);
  a03=(a03+a23);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a37);
  a05=(a05*a06);
  a01=(a01+a05);
  a43=(a43*a60);
  a01=(a01+a43);
  a64=(a64*a12);
  a01=(a01+a64);
  a70=(a70*a13);
  a01=(a01+a70);
  a76=(a76*a56);
  a01=(a01+a76);
  a82=(a82*a73);
  a01=(a01+a82);
  a88=(a88*a10);
  a01=(a01+a88);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* observe:(t,y[4],p[7])->(g[7],dg[7]) */
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
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116;
  a000=arg[2]? arg[2][1] : 0;
  a001=arg[1]? arg[1][0] : 0;
  a002=arg[1]? arg[1][1] : 0;
  a003=(a001-a002);
  a004=cos(a003);
  a005=arg[2]? arg[2][4] : 0;
  a006=(a004*a005);
  a007=arg[2]? arg[2][3] : 0;
  a003=sin(a003);
  a008=(a007*a003);
  a008=(a006+a008);
  a009=sin(a001);
  a010=(2.*a009);
  a010=(a008-a010);
  a011=cos(a001);
  a012=(a011*a005);
  a013=(a007*a009);
  a013=(a012+a013);
  a010=(a010+a013);
  a014=(2.*a001);
  a015=arg[2]? arg[2][5] : 0;
  a016=(a014*a015);
  a016=(a010-a016);
  a016=(a000*a016);
  a017=arg[2]? arg[2][0] : 0;
  a018=(a017*a001);
  a018=(a018*a015);
  a016=(a016-a018);
  a018=(a017*a009);
  a016=(a016-a018);
  a019=(2.*a000);
  a020=(a017+a019);
  a016=(a016/a020);
  a021=(a011*a017);
  a022=(a017*a015);
  a023=(a021+a022);
  a024=(2.*a015);
  a025=(2.*a011);
  a026=(a011*a007);
  a027=(a025-a026);
  a028=(a004*a007);
  a027=(a027-a028);
  a029=(a005*a009);
  a027=(a027+a029);
  a030=(a005*a003);
  a027=(a027+a030);
  a031=(a024+a027);
  a031=(a000*a031);
  a023=(a023+a031);
  a023=(a023/a020);
  a031=(a002-a001);
  a032=arg[2]? arg[2][6] : 0;
  a031=(a031+a032);
  a033=cos(a031);
  a034=(a033*a005);
  a031=sin(a031);
  a035=(a007*a031);
  a034=(a034-a035);
  a035=arg[1]? arg[1][2] : 0;
  a036=casadi_sq(a035);
  a037=cos(a002);
  a038=(a037*a005);
  a039=sin(a002);
  a040=(a007*a039);
  a040=(a038-a040);
  a041=(a036*a040);
  a041=(a034-a041);
  a041=(a000*a041);
  a042=(a037*a007);
  a043=casadi_sq(a007);
  a044=(a042-a043);
  a045=casadi_sq(a005);
  a044=(a044-a045);
  a046=(a005*a039);
  a044=(a044+a046);
  a047=(a005*a015);
  a048=(a047*a003);
  a044=(a044-a048);
  a049=(a028*a015);
  a044=(a044+a049);
  a044=(a000*a044);
  a050=arg[2]? arg[2][2] : 0;
  a044=(a044-a050);
  a051=(a025*a017);
  a051=(a051*a015);
  a052=(a022*a015);
  a051=(a051+a052);
  a051=(a051+a017);
  a053=(2.*a050);
  a051=(a051+a053);
  a054=(a025*a015);
  a055=(a026*a015);
  a056=(a054-a055);
  a056=(a056-a042);
  a056=(a056-a007);
  a057=(a047*a009);
  a056=(a056+a057);
  a056=(a056-a046);
  a058=casadi_sq(a015);
  a056=(a056+a058);
  a043=(a043+a045);
  a056=(a056+a043);
  a056=(a056+a048);
  a056=(a056-a049);
  a045=1.;
  a056=(a056+a045);
  a056=(a019*a056);
  a051=(a051+a056);
  a056=(a044/a051);
  a059=arg[1]? arg[1][3] : 0;
  a060=(a007*a059);
  a061=(a060*a059);
  a061=(a061*a000);
  a062=(a061*a039);
  a063=(a038*a059);
  a064=(a063*a059);
  a064=(a064*a000);
  a064=(a062-a064);
  a065=(a036*a015);
  a012=(a012*a000);
  a066=(a007*a000);
  a067=(a066*a009);
  a068=(a012+a067);
  a068=(a068-a018);
  a069=(a019*a009);
  a068=(a068-a069);
  a070=(a006*a000);
  a068=(a068+a070);
  a071=(a066*a003);
  a068=(a068+a071);
  a072=(a065*a068);
  a064=(a064-a072);
  a072=sin(a032);
  a022=(a022*a072);
  a064=(a064-a022);
  a073=(a001-a032);
  a074=sin(a073);
  a075=(a017*a074);
  a064=(a064+a075);
  a073=cos(a073);
  a076=(a073*a005);
  a077=(a007*a074);
  a076=(a076+a077);
  a024=(a024*a072);
  a076=(a076+a024);
  a024=(2.*a074);
  a076=(a076-a024);
  a076=(a076+a034);
  a076=(a000*a076);
  a064=(a064-a076);
  a034=casadi_sq(a059);
  a024=(a034*a015);
  a077=(a070*a024);
  a064=(a064-a077);
  a077=(a024*a071);
  a064=(a064-a077);
  a077=(2.*a035);
  a078=(a077*a059);
  a078=(a078*a000);
  a006=(a006*a015);
  a079=(a007*a015);
  a080=(a079*a003);
  a081=(a006+a080);
  a081=(a081+a040);
  a082=(a078*a081);
  a064=(a064+a082);
  a082=(a056*a064);
  a082=(a041-a082);
  a083=(a000*a043);
  a050=(a050+a083);
  a083=(a044*a056);
  a083=(a050-a083);
  a082=(a082/a083);
  a084=(a082*a000);
  a085=(a030-a028);
  a086=(a084*a085);
  a087=(a064/a051);
  a088=(a056*a082);
  a088=(a087-a088);
  a089=(a088*a015);
  a089=(a089*a020);
  a086=(a086-a089);
  a027=(a000*a027);
  a027=(a021+a027);
  a089=(a088*a027);
  a086=(a086-a089);
  a089=(a035*a017);
  a090=(a089*a009);
  a091=(a035*a000);
  a013=(a009-a013);
  a092=(a091*a013);
  a090=(a090+a092);
  a092=(a009-a008);
  a093=(a035*a092);
  a094=(a059*a008);
  a093=(a093+a094);
  a093=(a000*a093);
  a090=(a090+a093);
  a093=(a035*a090);
  a086=(a086+a093);
  a094=(a059*a000);
  a095=(a094*a008);
  a096=(a035-a059);
  a097=(a095*a096);
  a086=(a086+a097);
  a072=(a072*a020);
  a086=(a086-a072);
  a098=(a023*a086);
  a010=(a000*a010);
  a010=(a010-a018);
  a099=(a088*a010);
  a100=(a084*a008);
  a099=(a099-a100);
  a100=(a028*a059);
  a101=(a100*a059);
  a101=(a101*a000);
  a099=(a099+a101);
  a032=cos(a032);
  a032=(a032*a020);
  a099=(a099+a032);
  a102=(a026*a000);
  a102=(a021-a102);
  a103=(a025*a000);
  a102=(a102+a103);
  a103=(a028*a000);
  a102=(a102-a103);
  a103=(a005*a000);
  a104=(a103*a009);
  a102=(a102+a104);
  a104=(a103*a003);
  a102=(a102+a104);
  a105=(a036*a102);
  a099=(a099-a105);
  a106=(a034*a104);
  a099=(a099-a106);
  a107=(a078*a085);
  a099=(a099+a107);
  a098=(a098/a099);
  a016=(a016-a098);
  a001=(a001*a015);
  a016=(a016+a001);
  a016=(-a016);
  if (res[0]!=0) res[0][0]=a016;
  a016=(a017*a054);
  a052=(a052+a016);
  a052=(a052+a017);
  a052=(a052+a053);
  a057=(a057-a055);
  a057=(a057-a042);
  a057=(a057-a007);
  a057=(a057-a046);
  a057=(a057+a058);
  a057=(a057+a054);
  a057=(a057+a048);
  a057=(a057-a049);
  a057=(a057+a043);
  a057=(a057+a045);
  a057=(a019*a057);
  a052=(a052+a057);
  a057=(a064/a052);
  a045=(a044/a052);
  a043=(a045*a064);
  a043=(a041-a043);
  a049=(a044*a045);
  a050=(a050-a049);
  a043=(a043/a050);
  a049=(a045*a043);
  a049=(a057-a049);
  a048=(a049*a010);
  a054=(a043*a000);
  a058=(a054*a008);
  a048=(a048-a058);
  a048=(a048+a101);
  a048=(a048+a032);
  a048=(a048-a105);
  a048=(a048-a106);
  a048=(a048+a107);
  if (res[0]!=0) res[0][1]=a048;
  a026=(a026-a025);
  a026=(a026+a028);
  a026=(a026-a029);
  a026=(a026-a030);
  a026=(a000*a026);
  a026=(a026-a021);
  a021=(a049*a026);
  a030=(a049*a015);
  a030=(a030*a020);
  a021=(a021-a030);
  a030=(a054*a085);
  a021=(a021+a030);
  a021=(a021+a093);
  a021=(a021+a097);
  a021=(a021-a072);
  a021=(a021/a048);
  if (res[0]!=0) res[0][2]=a021;
  a072=(a011-a004);
  a072=(a072+a015);
  if (res[0]!=0) res[0][3]=a072;
  a072=(a034*a000);
  a097=(a038*a072);
  a062=(a062-a097);
  a012=(a012+a070);
  a012=(a012+a067);
  a012=(a012+a071);
  a012=(a012-a018);
  a012=(a012-a069);
  a069=(a065*a012);
  a062=(a062-a069);
  a069=(a040+a006);
  a069=(a069+a080);
  a018=(a078*a069);
  a062=(a062+a018);
  a062=(a062-a022);
  a062=(a062+a075);
  a062=(a062-a076);
  a076=(a072*a006);
  a062=(a062-a076);
  a076=(a072*a080);
  a062=(a062-a076);
  a076=(a062/a052);
  a075=(a045*a062);
  a041=(a041-a075);
  a041=(a041/a050);
  a075=(a045*a041);
  a075=(a076-a075);
  if (res[0]!=0) res[0][4]=a075;
  a002=(a002-a014);
  if (res[0]!=0) res[0][5]=a002;
  a002=0.;
  if (res[0]!=0) res[0][6]=a002;
  a004=(a004*a096);
  a014=(a007*a004);
  a003=(a003*a096);
  a022=(a005*a003);
  a014=(a014-a022);
  a011=(a011*a035);
  a018=(2.*a011);
  a018=(a014-a018);
  a067=(a007*a011);
  a097=(a009*a035);
  a093=(a005*a097);
  a067=(a067-a093);
  a018=(a018+a067);
  a030=(a015*a077);
  a030=(a018-a030);
  a030=(a000*a030);
  a029=(a017*a035);
  a029=(a015*a029);
  a030=(a030-a029);
  a029=(a017*a011);
  a030=(a030-a029);
  a030=(a030/a020);
  a025=(-a097);
  a025=(2.*a025);
  a107=(a007*a097);
  a106=(a025+a107);
  a105=(a007*a003);
  a106=(a106+a105);
  a032=(a005*a011);
  a106=(a106+a032);
  a101=(a005*a004);
  a106=(a106+a101);
  a106=(a000*a106);
  a058=(a017*a097);
  a106=(a106-a058);
  a046=(a106/a020);
  a086=(a086*a046);
  a046=(a082/a083);
  a037=(a037*a059);
  a042=(a005*a037);
  a055=(a039*a059);
  a053=(a007*a055);
  a016=(a042-a053);
  a001=(a047*a004);
  a016=(a016-a001);
  a108=(a015*a105);
  a016=(a016-a108);
  a016=(a000*a016);
  a109=(a056*a016);
  a110=(a016/a051);
  a111=(a056/a051);
  a112=(a017*a025);
  a112=(a015*a112);
  a113=(a015*a025);
  a114=(a015*a107);
  a115=(a113+a114);
  a115=(a115+a053);
  a047=(a047*a011);
  a115=(a115+a047);
  a115=(a115-a042);
  a115=(a115+a001);
  a115=(a115+a108);
  a115=(a019*a115);
  a112=(a112+a115);
  a111=(a111*a112);
  a110=(a110-a111);
  a111=(a044*a110);
  a109=(a109+a111);
  a046=(a046*a109);
  a109=(a059-a035);
  a031=(a031*a109);
  a031=(a005*a031);
  a033=(a033*a109);
  a033=(a007*a033);
  a031=(a031+a033);
  a033=(a077*a075);
  a040=(a040*a033);
  a055=(a005*a055);
  a109=(a007*a037);
  a109=(a055+a109);
  a111=(a036*a109);
  a040=(a040-a111);
  a040=(a031+a040);
  a040=(a000*a040);
  a111=(a064*a110);
  a115=(a007*a041);
  a115=(a059*a115);
  a060=(a060*a041);
  a115=(a115+a060);
  a115=(a000*a115);
  a039=(a039*a115);
  a061=(a061*a037);
  a039=(a039+a061);
  a061=(a038*a041);
  a037=(a059*a055);
  a061=(a061-a037);
  a061=(a059*a061);
  a063=(a063*a041);
  a061=(a061+a063);
  a061=(a000*a061);
  a061=(a039-a061);
  a063=(a015*a033);
  a068=(a068*a063);
  a037=(a066*a011);
  a093=(a000*a093);
  a115=(a037-a093);
  a115=(a115-a029);
  a060=(a019*a011);
  a115=(a115-a060);
  a116=(a000*a022);
  a115=(a115-a116);
  a066=(a066*a004);
  a115=(a115+a066);
  a115=(a065*a115);
  a068=(a068+a115);
  a061=(a061-a068);
  a073=(a073*a035);
  a068=(a017*a073);
  a061=(a061+a068);
  a007=(a007*a073);
  a074=(a074*a035);
  a005=(a005*a074);
  a007=(a007-a005);
  a073=(2.*a073);
  a007=(a007-a073);
  a007=(a007-a031);
  a007=(a000*a007);
  a061=(a061-a007);
  a031=(2.*a059);
  a031=(a031*a041);
  a073=(a015*a031);
  a070=(a070*a073);
  a005=(a024*a116);
  a070=(a070-a005);
  a061=(a061-a070);
  a071=(a071*a073);
  a024=(a024*a066);
  a071=(a071+a024);
  a061=(a061-a071);
  a071=(2.*a075);
  a071=(a059*a071);
  a024=(a077*a041);
  a071=(a071+a024);
  a071=(a000*a071);
  a081=(a081*a071);
  a079=(a079*a004);
  a022=(a015*a022);
  a024=(a079-a022);
  a024=(a024-a109);
  a024=(a078*a024);
  a081=(a081+a024);
  a061=(a061+a081);
  a081=(a056*a061);
  a111=(a111+a081);
  a111=(a040+a111);
  a111=(a111/a083);
  a046=(a046-a111);
  a111=(a000*a046);
  a083=(a085*a111);
  a081=(a101+a105);
  a024=(a084*a081);
  a083=(a083+a024);
  a024=(a061/a051);
  a087=(a087/a051);
  a087=(a087*a112);
  a024=(a024-a087);
  a082=(a082*a110);
  a056=(a056*a046);
  a082=(a082+a056);
  a024=(a024-a082);
  a082=(a015*a024);
  a082=(a020*a082);
  a083=(a083-a082);
  a027=(a027*a024);
  a106=(a088*a106);
  a027=(a027+a106);
  a083=(a083-a027);
  a090=(a090*a075);
  a027=(a017*a075);
  a009=(a009*a027);
  a089=(a089*a011);
  a009=(a009+a089);
  a089=(a000*a075);
  a013=(a013*a089);
  a067=(a011-a067);
  a091=(a091*a067);
  a013=(a013+a091);
  a009=(a009+a013);
  a092=(a092*a075);
  a013=(a011-a014);
  a013=(a035*a013);
  a092=(a092+a013);
  a013=(a008*a041);
  a091=(a059*a014);
  a013=(a013+a091);
  a092=(a092+a013);
  a092=(a000*a092);
  a009=(a009+a092);
  a009=(a035*a009);
  a090=(a090+a009);
  a083=(a083+a090);
  a009=(a000*a041);
  a009=(a008*a009);
  a094=(a094*a014);
  a009=(a009+a094);
  a096=(a096*a009);
  a075=(a075-a041);
  a095=(a095*a075);
  a096=(a096+a095);
  a083=(a083+a096);
  a023=(a023*a083);
  a086=(a086+a023);
  a086=(a086/a099);
  a098=(a098/a099);
  a024=(a010*a024);
  a018=(a000*a018);
  a018=(a018-a029);
  a088=(a088*a018);
  a024=(a024+a088);
  a111=(a008*a111);
  a084=(a084*a014);
  a111=(a111+a084);
  a024=(a024-a111);
  a028=(a028*a041);
  a111=(a059*a105);
  a028=(a028-a111);
  a028=(a059*a028);
  a100=(a100*a041);
  a028=(a028+a100);
  a028=(a000*a028);
  a024=(a024+a028);
  a102=(a102*a033);
  a033=(a000*a107);
  a033=(a033-a058);
  a100=(a000*a025);
  a033=(a033+a100);
  a100=(a000*a105);
  a033=(a033+a100);
  a011=(a103*a011);
  a033=(a033+a011);
  a103=(a103*a004);
  a033=(a033+a103);
  a036=(a036*a033);
  a102=(a102+a036);
  a024=(a024-a102);
  a104=(a104*a031);
  a034=(a034*a103);
  a104=(a104+a034);
  a024=(a024-a104);
  a034=(a085*a071);
  a103=(a078*a081);
  a034=(a034+a103);
  a024=(a024+a034);
  a098=(a098*a024);
  a086=(a086-a098);
  a030=(a030-a086);
  a035=(a015*a035);
  a030=(a030+a035);
  a030=(-a030);
  if (res[1]!=0) res[1][0]=a030;
  a030=(a061/a052);
  a057=(a057/a052);
  a017=(a017*a113);
  a047=(a047+a114);
  a047=(a047+a053);
  a047=(a047-a042);
  a047=(a047+a113);
  a047=(a047+a001);
  a047=(a047+a108);
  a019=(a019*a047);
  a017=(a017+a019);
  a057=(a057*a017);
  a030=(a030-a057);
  a057=(a016/a052);
  a019=(a045/a052);
  a019=(a019*a017);
  a057=(a057-a019);
  a019=(a043*a057);
  a043=(a043/a050);
  a016=(a045*a016);
  a044=(a044*a057);
  a016=(a016+a044);
  a043=(a043*a016);
  a064=(a064*a057);
  a061=(a045*a061);
  a064=(a064+a061);
  a064=(a040+a064);
  a064=(a064/a050);
  a043=(a043-a064);
  a064=(a045*a043);
  a019=(a019+a064);
  a030=(a030-a019);
  a010=(a010*a030);
  a018=(a049*a018);
  a010=(a010+a018);
  a043=(a000*a043);
  a008=(a008*a043);
  a014=(a054*a014);
  a008=(a008+a014);
  a010=(a010-a008);
  a010=(a010+a028);
  a010=(a010-a102);
  a010=(a010-a104);
  a010=(a010+a034);
  if (res[1]!=0) res[1][1]=a010;
  a026=(a026*a030);
  a107=(a107+a025);
  a107=(a107+a105);
  a107=(a107+a032);
  a107=(a107+a101);
  a107=(a000*a107);
  a058=(a058-a107);
  a049=(a049*a058);
  a026=(a026+a049);
  a015=(a015*a030);
  a020=(a020*a015);
  a026=(a026-a020);
  a085=(a085*a043);
  a054=(a054*a081);
  a085=(a085+a054);
  a026=(a026+a085);
  a026=(a026+a090);
  a026=(a026+a096);
  a026=(a026/a048);
  a021=(a021/a048);
  a021=(a021*a010);
  a026=(a026-a021);
  if (res[1]!=0) res[1][2]=a026;
  a003=(a003-a097);
  if (res[1]!=0) res[1][3]=a003;
  a000=(a000*a031);
  a038=(a038*a000);
  a055=(a072*a055);
  a038=(a038-a055);
  a039=(a039-a038);
  a012=(a012*a063);
  a093=(a093+a116);
  a037=(a037-a093);
  a037=(a037+a066);
  a037=(a037-a029);
  a037=(a037-a060);
  a065=(a065*a037);
  a012=(a012+a065);
  a039=(a039-a012);
  a069=(a069*a071);
  a109=(a109+a022);
  a109=(a079-a109);
  a078=(a078*a109);
  a069=(a069+a078);
  a039=(a039+a069);
  a039=(a039+a068);
  a039=(a039-a007);
  a006=(a006*a000);
  a022=(a072*a022);
  a006=(a006-a022);
  a039=(a039-a006);
  a080=(a080*a000);
  a072=(a072*a079);
  a080=(a080+a072);
  a039=(a039-a080);
  a080=(a039/a052);
  a076=(a076/a052);
  a076=(a076*a017);
  a080=(a080-a076);
  a076=(a041*a057);
  a041=(a041/a050);
  a041=(a041*a016);
  a062=(a062*a057);
  a039=(a045*a039);
  a062=(a062+a039);
  a040=(a040+a062);
  a040=(a040/a050);
  a041=(a041-a040);
  a045=(a045*a041);
  a076=(a076+a045);
  a080=(a080-a076);
  if (res[1]!=0) res[1][4]=a080;
  a059=(a059-a077);
  if (res[1]!=0) res[1][5]=a059;
  if (res[1]!=0) res[1][6]=a002;
  return 0;
}

/* working_steps:(t,turns[2x12],w[4],h,p[7])->(w_end[4],nodes[4x12],g[7x12],dg[7x12]) */
static int casadi_f63(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *w00=w+117, w01, *w02=w+121, *w03=w+128, w05, *w06=w+130, w07, *w08=w+134, *w09=w+138, *w10=w+142, *w11=w+146;
  casadi_real *w12=w+150, *w13=w+154, *w14=w+158, *w15=w+162, *w16=w+166, *w17=w+170, *w18=w+174, *w19=w+178, *w20=w+185, *w21=w+192, *w22=w+199, *w23=w+206;
  casadi_real *w24=w+213, *w25=w+220, *w26=w+227, *w27=w+234, *w28=w+241, *w29=w+248, *w30=w+255, *w31=w+262;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
static int casadi_f62(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1065;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #36: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f62(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1072;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1072*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_72:(u[4],p[7])->(w[4x73],g[7x73],dg[7x73],R[4]) */
static int casadi_f66(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1142, *w19=w+1226, *w20=w+1310, *w21=w+1394;
  casadi_real *w22=w+1401;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #48: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f66(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1408;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_72_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1408*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_96:(u[4],p[7])->(w[4x97],g[7x97],dg[7x97],R[4]) */
static int casadi_f67(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1142, *w19=w+1226, *w20=w+1310, *w21=w+1394;
  casadi_real *w22=w+1478, *w23=w+1562, *w24=w+1646, *w25=w+1730, *w26=w+1737;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #60: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f67(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 1744;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1744*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_144:(u[4],p[7])->(w[4x145],g[7x145],dg[7x145],R[4]) */
static int casadi_f68(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1142, *w19=w+1226, *w20=w+1310, *w21=w+1394;
  casadi_real *w22=w+1478, *w23=w+1562, *w24=w+1646, *w25=w+1730, *w26=w+1814, *w27=w+1898, *w28=w+1982, *w29=w+2066, *w30=w+2150, *w31=w+2234, *w32=w+2318, *w33=w+2402;
  casadi_real *w34=w+2409;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #84: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_144(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f68(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 2416;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_144_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2416*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_192:(u[4],p[7])->(w[4x193],g[7x193],dg[7x193],R[4]) */
static int casadi_f69(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1142, *w19=w+1226, *w20=w+1310, *w21=w+1394;
  casadi_real *w22=w+1478, *w23=w+1562, *w24=w+1646, *w25=w+1730, *w26=w+1814, *w27=w+1898, *w28=w+1982, *w29=w+2066, *w30=w+2150, *w31=w+2234, *w32=w+2318, *w33=w+2402;
  casadi_real *w34=w+2486, *w35=w+2570, *w36=w+2654, *w37=w+2738, *w38=w+2822, *w39=w+2906, *w40=w+2990, *w41=w+3074, *w42=w+3081;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #108: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f69(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 3088;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3088*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_288:(u[4],p[7])->(w[4x289],g[7x289],dg[7x289],R[4]) */
static int casadi_f70(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1142, *w19=w+1226, *w20=w+1310, *w21=w+1394;
  casadi_real *w22=w+1478, *w23=w+1562, *w24=w+1646, *w25=w+1730, *w26=w+1814, *w27=w+1898, *w28=w+1982, *w29=w+2066, *w30=w+2150, *w31=w+2234, *w32=w+2318, *w33=w+2402;
  casadi_real *w34=w+2486, *w35=w+2570, *w36=w+2654, *w37=w+2738, *w38=w+2822, *w39=w+2906, *w40=w+2990, *w41=w+3074, *w42=w+3158, *w43=w+3242, *w44=w+3326, *w45=w+3410;
  casadi_real *w46=w+3494, *w47=w+3578, *w48=w+3662, *w49=w+3746, *w50=w+3830, *w51=w+3914, *w52=w+3998, *w53=w+4082, *w54=w+4166, *w55=w+4250, *w56=w+4334, *w57=w+4418;
  casadi_real *w58=w+4425;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #156: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_288(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f70(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 4432;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_288_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 4432*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_384:(u[4],p[7])->(w[4x385],g[7x385],dg[7x385],R[4]) */
static int casadi_f71(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, *w01=w+296, w02, w03, *w04=w+300, *w05=w+307, *w06=w+331, *w07=w+334, *w08=w+338, *w09=w+386;
  casadi_real *w10=w+470, *w11=w+554, *w12=w+638, *w13=w+722, *w14=w+806, *w15=w+890, *w16=w+974, *w17=w+1058, *w18=w+1142, *w19=w+1226, *w20=w+1310, *w21=w+1394;
  casadi_real *w22=w+1478, *w23=w+1562, *w24=w+1646, *w25=w+1730, *w26=w+1814, *w27=w+1898, *w28=w+1982, *w29=w+2066, *w30=w+2150, *w31=w+2234, *w32=w+2318, *w33=w+2402;
  casadi_real *w34=w+2486, *w35=w+2570, *w36=w+2654, *w37=w+2738, *w38=w+2822, *w39=w+2906, *w40=w+2990, *w41=w+3074, *w42=w+3158, *w43=w+3242, *w44=w+3326, *w45=w+3410;
  casadi_real *w46=w+3494, *w47=w+3578, *w48=w+3662, *w49=w+3746, *w50=w+3830, *w51=w+3914, *w52=w+3998, *w53=w+4082, *w54=w+4166, *w55=w+4250, *w56=w+4334, *w57=w+4418;
  casadi_real *w58=w+4502, *w59=w+4586, *w60=w+4670, *w61=w+4754, *w62=w+4838, *w63=w+4922, *w64=w+5006, *w65=w+5090, *w66=w+5174, *w67=w+5258, *w68=w+5342, *w69=w+5426;
  casadi_real *w70=w+5510, *w71=w+5594, *w72=w+5678, *w73=w+5762, *w74=w+5769;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w06, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w06;
  arg1[1]=w04;
  res1[0]=w01;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #204: output[3][0] = @7 */
  casadi_copy(w07, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f71(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 5776;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 5776*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_576:(u[4],p[7])->(w[4x577],g[7x577],dg[7x577],R[4]) */
static int casadi_f72(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+296, w002, w003, *w004=w+300, *w005=w+307, *w006=w+331, *w007=w+334, *w008=w+338, *w009=w+386;
  casadi_real *w010=w+470, *w011=w+554, *w012=w+638, *w013=w+722, *w014=w+806, *w015=w+890, *w016=w+974, *w017=w+1058, *w018=w+1142, *w019=w+1226, *w020=w+1310, *w021=w+1394;
  casadi_real *w022=w+1478, *w023=w+1562, *w024=w+1646, *w025=w+1730, *w026=w+1814, *w027=w+1898, *w028=w+1982, *w029=w+2066, *w030=w+2150, *w031=w+2234, *w032=w+2318, *w033=w+2402;
  casadi_real *w034=w+2486, *w035=w+2570, *w036=w+2654, *w037=w+2738, *w038=w+2822, *w039=w+2906, *w040=w+2990, *w041=w+3074, *w042=w+3158, *w043=w+3242, *w044=w+3326, *w045=w+3410;
  casadi_real *w046=w+3494, *w047=w+3578, *w048=w+3662, *w049=w+3746, *w050=w+3830, *w051=w+3914, *w052=w+3998, *w053=w+4082, *w054=w+4166, *w055=w+4250, *w056=w+4334, *w057=w+4418;
  casadi_real *w058=w+4502, *w059=w+4586, *w060=w+4670, *w061=w+4754, *w062=w+4838, *w063=w+4922, *w064=w+5006, *w065=w+5090, *w066=w+5174, *w067=w+5258, *w068=w+5342, *w069=w+5426;
  casadi_real *w070=w+5510, *w071=w+5594, *w072=w+5678, *w073=w+5762, *w074=w+5846, *w075=w+5930, *w076=w+6014, *w077=w+6098, *w078=w+6182, *w079=w+6266, *w080=w+6350, *w081=w+6434;
  casadi_real *w082=w+6518, *w083=w+6602, *w084=w+6686, *w085=w+6770, *w086=w+6854, *w087=w+6938, *w088=w+7022, *w089=w+7106, *w090=w+7190, *w091=w+7274, *w092=w+7358, *w093=w+7442;
  casadi_real *w094=w+7526, *w095=w+7610, *w096=w+7694, *w097=w+7778, *w098=w+7862, *w099=w+7946, *w100=w+8030, *w101=w+8114, *w102=w+8198, *w103=w+8282, *w104=w+8366, *w105=w+8450;
  casadi_real *w106=w+8457;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w006, cs=w001+0; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=w004;
  res1[0]=w001;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #300: output[3][0] = @7 */
  casadi_copy(w007, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_576(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f72(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 8464;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_576_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 8464*sizeof(casadi_real);
  return 0;
}

/* round_feet_trace_768:(u[4],p[7])->(w[4x769],g[7x769],dg[7x769],R[4]) */
static int casadi_f73(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w000, *w001=w+296, w002, w003, *w004=w+300, *w005=w+307, *w006=w+331, *w007=w+334, *w008=w+338, *w009=w+386;
  casadi_real *w010=w+470, *w011=w+554, *w012=w+638, *w013=w+722, *w014=w+806, *w015=w+890, *w016=w+974, *w017=w+1058, *w018=w+1142, *w019=w+1226, *w020=w+1310, *w021=w+1394;
  casadi_real *w022=w+1478, *w023=w+1562, *w024=w+1646, *w025=w+1730, *w026=w+1814, *w027=w+1898, *w028=w+1982, *w029=w+2066, *w030=w+2150, *w031=w+2234, *w032=w+2318, *w033=w+2402;
  casadi_real *w034=w+2486, *w035=w+2570, *w036=w+2654, *w037=w+2738, *w038=w+2822, *w039=w+2906, *w040=w+2990, *w041=w+3074, *w042=w+3158, *w043=w+3242, *w044=w+3326, *w045=w+3410;
  casadi_real *w046=w+3494, *w047=w+3578, *w048=w+3662, *w049=w+3746, *w050=w+3830, *w051=w+3914, *w052=w+3998, *w053=w+4082, *w054=w+4166, *w055=w+4250, *w056=w+4334, *w057=w+4418;
  casadi_real *w058=w+4502, *w059=w+4586, *w060=w+4670, *w061=w+4754, *w062=w+4838, *w063=w+4922, *w064=w+5006, *w065=w+5090, *w066=w+5174, *w067=w+5258, *w068=w+5342, *w069=w+5426;
  casadi_real *w070=w+5510, *w071=w+5594, *w072=w+5678, *w073=w+5762, *w074=w+5846, *w075=w+5930, *w076=w+6014, *w077=w+6098, *w078=w+6182, *w079=w+6266, *w080=w+6350, *w081=w+6434;
  casadi_real *w082=w+6518, *w083=w+6602, *w084=w+6686, *w085=w+6770, *w086=w+6854, *w087=w+6938, *w088=w+7022, *w089=w+7106, *w090=w+7190, *w091=w+7274, *w092=w+7358, *w093=w+7442;
  casadi_real *w094=w+7526, *w095=w+7610, *w096=w+7694, *w097=w+7778, *w098=w+7862, *w099=w+7946, *w100=w+8030, *w101=w+8114, *w102=w+8198, *w103=w+8282, *w104=w+8366, *w105=w+8450;
  casadi_real *w106=w+8534, *w107=w+8618, *w108=w+8702, *w109=w+8786, *w110=w+8870, *w111=w+8954, *w112=w+9038, *w113=w+9122, *w114=w+9206, *w115=w+9290, *w116=w+9374, *w117=w+9458;
  casadi_real *w118=w+9542, *w119=w+9626, *w120=w+9710, *w121=w+9794, *w122=w+9878, *w123=w+9962, *w124=w+10046, *w125=w+10130, *w126=w+10214, *w127=w+10298, *w128=w+10382, *w129=w+10466;
  casadi_real *w130=w+10550, *w131=w+10634, *w132=w+10718, *w133=w+10802, *w134=w+10886, *w135=w+10970, *w136=w+11054, *w137=w+11138, *w138=w+11145;
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
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #7: @6 = @1[:3] */
  for (rr=w006, cs=w001+0; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #8: {@1, NULL} = start(@6, @4) */
  arg1[0]=w006;
  arg1[1]=w004;
  res1[0]=w001;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f63(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #396: output[3][0] = @7 */
  casadi_copy(w007, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f73(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 11152;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 11152*sizeof(casadi_real);
  return 0;
}

/* round_feet_advance:(t,w[4],h,p[7])->(w_end[4],g[7],dg[7]) */
static int casadi_f74(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+117, w1, *w2=w+121, *w3=w+128, w4, *w5=w+130, *w6=w+154, *w7=w+158, *w8=w+165;
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
  if (casadi_f64(arg1, res1, iw, w, 0)) return 1;
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
  if (casadi_f65(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[1][0] = @7 */
  casadi_copy(w7, 7, res[1]);
  /* #11: output[2][0] = @8 */
  casadi_copy(w8, 7, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f74(arg, res, iw, w, mem);
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
  if (sz_w) *sz_w = 172;
  return 0;
}

CASADI_SYMBOL_EXPORT int round_feet_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 172*sizeof(casadi_real);
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
