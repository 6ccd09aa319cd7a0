/* Compass walker with a horizontally wobbling mass: kernels of the solver
 * Printed by CasADi 3.8.2 from equations c17e26acaabdb12f.
 * Do not edit: run `make derive`.
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
#define casadi_f5 CASADI_PREFIX(f5)
#define casadi_f6 CASADI_PREFIX(f6)
#define casadi_f7 CASADI_PREFIX(f7)
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
#define casadi_s2 CASADI_PREFIX(s2)
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
static const casadi_int casadi_s5[3] = {8, 1, 1};
static const casadi_int casadi_s6[3] = {6, 6, 1};
static const casadi_int casadi_s7[3] = {7, 49, 1};
static const casadi_int casadi_s8[3] = {8, 49, 1};
static const casadi_int casadi_s9[3] = {7, 97, 1};
static const casadi_int casadi_s10[3] = {8, 97, 1};
static const casadi_int casadi_s11[3] = {7, 193, 1};
static const casadi_int casadi_s12[3] = {8, 193, 1};
static const casadi_int casadi_s13[3] = {7, 385, 1};
static const casadi_int casadi_s14[3] = {8, 385, 1};
static const casadi_int casadi_s15[3] = {7, 769, 1};
static const casadi_int casadi_s16[3] = {8, 769, 1};
static const casadi_int casadi_s17[3] = {1, 1, 1};
static const casadi_int casadi_s18[3] = {7, 1, 1};

static const casadi_real casadi_zeros[36] = 
  {0.};

/* start:(z[5])->(y[6],dy_dz[6x5]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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

/* variational_step:(y[6x6],t,h,p[8])->(y_end[6x6]) */
static int casadi_f5(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
  casadi_real a312, a313;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[2]? arg[2][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][3] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[3]? arg[3][3] : 0;
  a008=arg[0]? arg[0][4] : 0;
  a009=(a007*a008);
  a010=arg[0]? arg[0][1] : 0;
  a011=sin(a010);
  a009=(a009*a011);
  a012=(2.*a003);
  a013=(a008-a012);
  a009=(a009*a013);
  a013=sin(a000);
  a014=(a000-a010);
  a015=sin(a014);
  a016=(a013-a015);
  a016=(a007*a016);
  a009=(a009+a016);
  a009=(a009+a013);
  a017=(2.*a007);
  a018=1.;
  a019=cos(a010);
  a020=(a018-a019);
  a020=(a017*a020);
  a020=(a020+a018);
  a021=(a009/a020);
  a022=(a019-a018);
  a022=(a007*a022);
  a023=(a022/a020);
  a024=casadi_sq(a003);
  a024=(a024*a011);
  a024=(a024+a015);
  a024=(a007*a024);
  a015=arg[3]? arg[3][5] : 0;
  a025=arg[3]? arg[3][7] : 0;
  a026=arg[3]? arg[3][2] : 0;
  a027=(a025*a026);
  a028=arg[1]? arg[1][0] : 0;
  a029=(a026*a028);
  a030=sin(a029);
  a030=(a027*a030);
  a030=(a008+a030);
  a030=(a015*a030);
  a031=arg[3]? arg[3][4] : 0;
  a032=arg[3]? arg[3][6] : 0;
  a029=cos(a029);
  a029=(a029+a018);
  a029=(a025*a029);
  a029=(a032-a029);
  a029=(a029+a010);
  a029=(a031*a029);
  a030=(a030+a029);
  a024=(a024-a030);
  a030=(a023*a009);
  a030=(a024-a030);
  a029=(a022*a023);
  a029=(a007-a029);
  a033=(a030/a029);
  a034=arg[3]? arg[3][1] : 0;
  a035=cos(a000);
  a036=(a034*a035);
  a037=(a036/a020);
  a022=(a022*a037);
  a038=(a022/a029);
  a009=(a037*a009);
  a039=(a034*a003);
  a039=(a039*a003);
  a039=(a039*a013);
  a040=arg[3]? arg[3][0] : 0;
  a041=arg[0]? arg[0][2] : 0;
  a042=(a040*a041);
  a039=(a039+a042);
  a009=(a009-a039);
  a030=(a038*a030);
  a009=(a009-a030);
  a036=(a036*a037);
  a036=(a034-a036);
  a022=(a022*a038);
  a036=(a036-a022);
  a009=(a009/a036);
  a022=(a038*a009);
  a033=(a033-a022);
  a022=(a023*a033);
  a021=(a021-a022);
  a022=(a037*a009);
  a021=(a021+a022);
  a022=(a006*a021);
  a030=1.7082860872947386e-01;
  a030=(a030*a002);
  a042=2.9587585476806851e-02;
  a042=(a042*a002);
  a043=(a042*a033);
  a044=8.8762756430420545e-02;
  a044=(a044*a002);
  a045=1.9725056984537900e-02;
  a045=(a045*a002);
  a046=(a045*a021);
  a047=5.9175170953613701e-02;
  a047=(a047*a002);
  a048=5.2600151958767730e-02;
  a048=(a048*a002);
  a049=(a048*a033);
  a049=(a008+a049);
  a050=(a007*a049);
  a051=(a048*a008);
  a051=(a010+a051);
  a052=sin(a051);
  a050=(a050*a052);
  a053=(a048*a021);
  a053=(a003+a053);
  a054=(2.*a053);
  a055=(a049-a054);
  a050=(a050*a055);
  a055=(a048*a003);
  a055=(a000+a055);
  a056=sin(a055);
  a057=(a055-a051);
  a058=sin(a057);
  a059=(a056-a058);
  a059=(a007*a059);
  a050=(a050+a059);
  a050=(a050+a056);
  a060=cos(a051);
  a061=(a018-a060);
  a061=(a017*a061);
  a061=(a061+a018);
  a062=(a050/a061);
  a063=(a060-a018);
  a063=(a007*a063);
  a064=(a063/a061);
  a065=casadi_sq(a053);
  a065=(a065*a052);
  a065=(a065+a058);
  a065=(a007*a065);
  a058=(a028+a048);
  a058=(a026*a058);
  a066=sin(a058);
  a066=(a027*a066);
  a066=(a049+a066);
  a066=(a015*a066);
  a058=cos(a058);
  a058=(a058+a018);
  a058=(a025*a058);
  a058=(a032-a058);
  a058=(a058+a051);
  a058=(a031*a058);
  a066=(a066+a058);
  a065=(a065-a066);
  a066=(a064*a050);
  a066=(a065-a066);
  a058=(a063*a064);
  a058=(a007-a058);
  a051=(a066/a058);
  a055=cos(a055);
  a067=(a034*a055);
  a068=(a067/a061);
  a063=(a063*a068);
  a069=(a063/a058);
  a050=(a068*a050);
  a070=(a034*a053);
  a070=(a070*a053);
  a070=(a070*a056);
  a071=arg[0]? arg[0][5] : 0;
  a072=(a048*a071);
  a072=(a041+a072);
  a072=(a040*a072);
  a070=(a070+a072);
  a050=(a050-a070);
  a066=(a069*a066);
  a050=(a050-a066);
  a067=(a067*a068);
  a067=(a034-a067);
  a063=(a063*a069);
  a067=(a067-a063);
  a050=(a050/a067);
  a063=(a069*a050);
  a051=(a051-a063);
  a063=(a064*a051);
  a062=(a062-a063);
  a063=(a068*a050);
  a062=(a062+a063);
  a062=(a047*a062);
  a046=(a046+a062);
  a046=(a003+a046);
  a062=casadi_sq(a046);
  a063=(a045*a008);
  a066=(a047*a049);
  a063=(a063+a066);
  a063=(a010+a063);
  a066=sin(a063);
  a062=(a062*a066);
  a072=(a045*a003);
  a073=(a047*a053);
  a072=(a072+a073);
  a072=(a000+a072);
  a073=(a072-a063);
  a074=sin(a073);
  a062=(a062+a074);
  a062=(a007*a062);
  a075=(a045*a033);
  a051=(a047*a051);
  a075=(a075+a051);
  a075=(a008+a075);
  a051=7.8900227938151601e-02;
  a051=(a051*a002);
  a051=(a028+a051);
  a051=(a026*a051);
  a076=sin(a051);
  a076=(a027*a076);
  a076=(a075+a076);
  a076=(a015*a076);
  a051=cos(a051);
  a051=(a051+a018);
  a051=(a025*a051);
  a051=(a032-a051);
  a051=(a051+a063);
  a051=(a031*a051);
  a076=(a076+a051);
  a062=(a062-a076);
  a063=cos(a063);
  a076=(a063-a018);
  a076=(a007*a076);
  a051=(a018-a063);
  a051=(a017*a051);
  a051=(a051+a018);
  a077=(a076/a051);
  a078=(a007*a075);
  a078=(a078*a066);
  a079=(2.*a046);
  a080=(a075-a079);
  a078=(a078*a080);
  a080=sin(a072);
  a074=(a080-a074);
  a074=(a007*a074);
  a078=(a078+a074);
  a078=(a078+a080);
  a081=(a077*a078);
  a081=(a062-a081);
  a082=(a076*a077);
  a082=(a007-a082);
  a083=(a081/a082);
  a072=cos(a072);
  a084=(a034*a072);
  a085=(a084/a051);
  a076=(a076*a085);
  a086=(a076/a082);
  a087=(a085*a078);
  a088=(a034*a046);
  a088=(a088*a046);
  a088=(a088*a080);
  a089=(a045*a071);
  a090=(a048*a009);
  a090=(a071+a090);
  a090=(a047*a090);
  a089=(a089+a090);
  a089=(a041+a089);
  a089=(a040*a089);
  a088=(a088+a089);
  a087=(a087-a088);
  a081=(a086*a081);
  a087=(a087-a081);
  a084=(a084*a085);
  a084=(a034-a084);
  a076=(a076*a086);
  a084=(a084-a076);
  a087=(a087/a084);
  a076=(a086*a087);
  a083=(a083-a076);
  a076=(a044*a083);
  a043=(a043+a076);
  a043=(a008+a043);
  a076=(a007*a043);
  a081=(a042*a008);
  a089=(a044*a075);
  a081=(a081+a089);
  a081=(a010+a081);
  a089=sin(a081);
  a076=(a076*a089);
  a090=(a042*a021);
  a078=(a078/a051);
  a091=(a077*a083);
  a078=(a078-a091);
  a091=(a085*a087);
  a078=(a078+a091);
  a091=(a044*a078);
  a090=(a090+a091);
  a090=(a003+a090);
  a091=(2.*a090);
  a092=(a043-a091);
  a076=(a076*a092);
  a092=(a042*a003);
  a093=(a044*a046);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=sin(a092);
  a094=(a092-a081);
  a095=sin(a094);
  a096=(a093-a095);
  a096=(a007*a096);
  a076=(a076+a096);
  a076=(a076+a093);
  a097=cos(a081);
  a098=(a018-a097);
  a098=(a017*a098);
  a098=(a098+a018);
  a099=(a076/a098);
  a100=(a097-a018);
  a100=(a007*a100);
  a101=(a100/a098);
  a102=casadi_sq(a090);
  a102=(a102*a089);
  a102=(a102+a095);
  a102=(a007*a102);
  a095=1.1835034190722740e-01;
  a095=(a095*a002);
  a095=(a028+a095);
  a095=(a026*a095);
  a103=sin(a095);
  a103=(a027*a103);
  a103=(a043+a103);
  a103=(a015*a103);
  a095=cos(a095);
  a095=(a095+a018);
  a095=(a025*a095);
  a095=(a032-a095);
  a095=(a095+a081);
  a095=(a031*a095);
  a103=(a103+a095);
  a102=(a102-a103);
  a103=(a101*a076);
  a103=(a102-a103);
  a095=(a100*a101);
  a095=(a007-a095);
  a081=(a103/a095);
  a092=cos(a092);
  a104=(a034*a092);
  a105=(a104/a098);
  a100=(a100*a105);
  a106=(a100/a095);
  a076=(a105*a076);
  a107=(a034*a090);
  a107=(a107*a090);
  a107=(a107*a093);
  a108=(a042*a071);
  a109=(a045*a009);
  a050=(a047*a050);
  a109=(a109+a050);
  a109=(a071+a109);
  a050=(a044*a109);
  a108=(a108+a050);
  a108=(a041+a108);
  a108=(a040*a108);
  a107=(a107+a108);
  a076=(a076-a107);
  a103=(a106*a103);
  a076=(a076-a103);
  a104=(a104*a105);
  a104=(a034-a104);
  a100=(a100*a106);
  a104=(a104-a100);
  a076=(a076/a104);
  a100=(a106*a076);
  a081=(a081-a100);
  a100=(a101*a081);
  a099=(a099-a100);
  a100=(a105*a076);
  a099=(a099+a100);
  a100=(a030*a099);
  a022=(a022+a100);
  a100=1.2546768756682242e-01;
  a100=(a100*a002);
  a103=2.4136513415926669e-01;
  a103=(a103*a002);
  a108=(a103*a033);
  a050=-8.8454947932828609e-01;
  a050=(a050*a002);
  a083=(a050*a083);
  a108=(a108+a083);
  a083=9.2483400326179199e-01;
  a083=(a083*a002);
  a110=(a083*a081);
  a108=(a108+a110);
  a108=(a008+a108);
  a110=(a007*a108);
  a111=(a103*a008);
  a112=(a050*a075);
  a111=(a111+a112);
  a112=(a083*a043);
  a111=(a111+a112);
  a111=(a010+a111);
  a112=sin(a111);
  a110=(a110*a112);
  a113=(a103*a021);
  a078=(a050*a078);
  a113=(a113+a078);
  a078=(a083*a099);
  a113=(a113+a078);
  a113=(a003+a113);
  a078=(2.*a113);
  a114=(a108-a078);
  a110=(a110*a114);
  a114=(a103*a003);
  a115=(a050*a046);
  a114=(a114+a115);
  a115=(a083*a090);
  a114=(a114+a115);
  a114=(a000+a114);
  a115=sin(a114);
  a116=(a114-a111);
  a117=sin(a116);
  a118=(a115-a117);
  a118=(a007*a118);
  a110=(a110+a118);
  a110=(a110+a115);
  a119=cos(a111);
  a120=(a018-a119);
  a120=(a017*a120);
  a120=(a120+a018);
  a121=(a110/a120);
  a122=(a119-a018);
  a122=(a007*a122);
  a123=(a122/a120);
  a124=casadi_sq(a113);
  a124=(a124*a112);
  a124=(a124+a117);
  a124=(a007*a124);
  a117=2.8164965809277259e-01;
  a117=(a117*a002);
  a117=(a028+a117);
  a117=(a026*a117);
  a125=sin(a117);
  a125=(a027*a125);
  a125=(a108+a125);
  a125=(a015*a125);
  a117=cos(a117);
  a117=(a117+a018);
  a117=(a025*a117);
  a117=(a032-a117);
  a117=(a117+a111);
  a117=(a031*a117);
  a125=(a125+a117);
  a124=(a124-a125);
  a125=(a123*a110);
  a125=(a124-a125);
  a117=(a122*a123);
  a117=(a007-a117);
  a111=(a125/a117);
  a114=cos(a114);
  a126=(a034*a114);
  a127=(a126/a120);
  a122=(a122*a127);
  a128=(a122/a117);
  a110=(a127*a110);
  a129=(a034*a113);
  a129=(a129*a113);
  a129=(a129*a115);
  a130=(a103*a071);
  a109=(a050*a109);
  a130=(a130+a109);
  a109=(a042*a009);
  a131=(a044*a087);
  a109=(a109+a131);
  a109=(a071+a109);
  a131=(a083*a109);
  a130=(a130+a131);
  a130=(a041+a130);
  a130=(a040*a130);
  a129=(a129+a130);
  a110=(a110-a129);
  a125=(a128*a125);
  a110=(a110-a125);
  a126=(a126*a127);
  a126=(a034-a126);
  a122=(a122*a128);
  a126=(a126-a122);
  a110=(a110/a126);
  a122=(a128*a110);
  a111=(a111-a122);
  a122=(a123*a111);
  a121=(a121-a122);
  a122=(a127*a110);
  a121=(a121+a122);
  a122=(a100*a121);
  a022=(a022+a122);
  a022=(a003+a022);
  a122=(a005*a022);
  a004=(a004+a122);
  a122=1.8915178993145003e+00;
  a122=(a122*a002);
  a125=3.7109375000000000e-02;
  a125=(a125*a002);
  a130=(a125*a021);
  a131=1.7025221101954405e-01;
  a131=(a131*a002);
  a132=(a131*a099);
  a130=(a130+a132);
  a132=6.0216538980455959e-02;
  a132=(a132*a002);
  a133=(a132*a121);
  a130=(a130+a133);
  a133=-1.7578125000000000e-02;
  a133=(a133*a002);
  a134=(a006*a033);
  a135=(a030*a081);
  a134=(a134+a135);
  a135=(a100*a111);
  a134=(a134+a135);
  a134=(a008+a134);
  a135=(a007*a134);
  a136=(a006*a008);
  a137=(a030*a043);
  a136=(a136+a137);
  a137=(a100*a108);
  a136=(a136+a137);
  a136=(a010+a136);
  a137=sin(a136);
  a135=(a135*a137);
  a138=(2.*a022);
  a139=(a134-a138);
  a135=(a135*a139);
  a139=(a006*a003);
  a140=(a030*a090);
  a139=(a139+a140);
  a140=(a100*a113);
  a139=(a139+a140);
  a139=(a000+a139);
  a140=sin(a139);
  a141=(a139-a136);
  a142=sin(a141);
  a143=(a140-a142);
  a143=(a007*a143);
  a135=(a135+a143);
  a135=(a135+a140);
  a144=cos(a136);
  a145=(a018-a144);
  a145=(a017*a145);
  a145=(a145+a018);
  a146=(a135/a145);
  a147=(a144-a018);
  a147=(a007*a147);
  a148=(a147/a145);
  a149=casadi_sq(a022);
  a149=(a149*a137);
  a149=(a149+a142);
  a149=(a007*a149);
  a142=3.3333333333333331e-01;
  a142=(a142*a002);
  a142=(a028+a142);
  a142=(a026*a142);
  a150=sin(a142);
  a150=(a027*a150);
  a150=(a134+a150);
  a150=(a015*a150);
  a142=cos(a142);
  a142=(a142+a018);
  a142=(a025*a142);
  a142=(a032-a142);
  a142=(a142+a136);
  a142=(a031*a142);
  a150=(a150+a142);
  a149=(a149-a150);
  a150=(a148*a135);
  a150=(a149-a150);
  a142=(a147*a148);
  a142=(a007-a142);
  a136=(a150/a142);
  a139=cos(a139);
  a151=(a034*a139);
  a152=(a151/a145);
  a147=(a147*a152);
  a153=(a147/a142);
  a135=(a152*a135);
  a154=(a034*a022);
  a154=(a154*a022);
  a154=(a154*a140);
  a155=(a006*a071);
  a156=(a030*a109);
  a155=(a155+a156);
  a156=(a103*a009);
  a087=(a050*a087);
  a156=(a156+a087);
  a087=(a083*a076);
  a156=(a156+a087);
  a156=(a071+a156);
  a087=(a100*a156);
  a155=(a155+a087);
  a155=(a041+a155);
  a155=(a040*a155);
  a154=(a154+a155);
  a135=(a135-a154);
  a150=(a153*a150);
  a135=(a135-a150);
  a151=(a151*a152);
  a151=(a034-a151);
  a147=(a147*a153);
  a151=(a151-a147);
  a135=(a135/a151);
  a147=(a153*a135);
  a136=(a136-a147);
  a147=(a148*a136);
  a146=(a146-a147);
  a147=(a152*a135);
  a146=(a146+a147);
  a147=(a133*a146);
  a130=(a130+a147);
  a130=(a003+a130);
  a147=(a122*a130);
  a004=(a004+a147);
  a147=-5.8012039600105849e+00;
  a147=(a147*a002);
  a150=3.7092000118504789e-02;
  a150=(a150*a002);
  a155=(a150*a021);
  a087=1.7038392571223998e-01;
  a087=(a087*a002);
  a157=(a087*a099);
  a155=(a155+a157);
  a157=1.0726203044637328e-01;
  a157=(a157*a002);
  a158=(a157*a121);
  a155=(a155+a158);
  a158=-1.5319437748624402e-02;
  a158=(a158*a002);
  a159=(a158*a146);
  a155=(a155+a159);
  a159=8.2737891638140233e-03;
  a159=(a159*a002);
  a160=(a125*a033);
  a161=(a131*a081);
  a160=(a160+a161);
  a161=(a132*a111);
  a160=(a160+a161);
  a161=(a133*a136);
  a160=(a160+a161);
  a160=(a008+a160);
  a161=(a007*a160);
  a162=(a125*a008);
  a163=(a131*a043);
  a162=(a162+a163);
  a163=(a132*a108);
  a162=(a162+a163);
  a163=(a133*a134);
  a162=(a162+a163);
  a162=(a010+a162);
  a163=sin(a162);
  a161=(a161*a163);
  a164=(2.*a130);
  a165=(a160-a164);
  a161=(a161*a165);
  a165=(a125*a003);
  a166=(a131*a090);
  a165=(a165+a166);
  a166=(a132*a113);
  a165=(a165+a166);
  a166=(a133*a022);
  a165=(a165+a166);
  a165=(a000+a165);
  a166=sin(a165);
  a167=(a165-a162);
  a168=sin(a167);
  a169=(a166-a168);
  a169=(a007*a169);
  a161=(a161+a169);
  a161=(a161+a166);
  a170=cos(a162);
  a171=(a018-a170);
  a171=(a017*a171);
  a171=(a171+a018);
  a172=(a161/a171);
  a173=(a170-a018);
  a173=(a007*a173);
  a174=(a173/a171);
  a175=casadi_sq(a130);
  a175=(a175*a163);
  a175=(a175+a168);
  a175=(a007*a175);
  a168=2.5000000000000000e-01;
  a168=(a168*a002);
  a168=(a028+a168);
  a168=(a026*a168);
  a176=sin(a168);
  a176=(a027*a176);
  a176=(a160+a176);
  a176=(a015*a176);
  a168=cos(a168);
  a168=(a168+a018);
  a168=(a025*a168);
  a168=(a032-a168);
  a168=(a168+a162);
  a168=(a031*a168);
  a176=(a176+a168);
  a175=(a175-a176);
  a176=(a174*a161);
  a176=(a175-a176);
  a168=(a173*a174);
  a168=(a007-a168);
  a162=(a176/a168);
  a165=cos(a165);
  a177=(a034*a165);
  a178=(a177/a171);
  a173=(a173*a178);
  a179=(a173/a168);
  a161=(a178*a161);
  a180=(a034*a130);
  a180=(a180*a130);
  a180=(a180*a166);
  a181=(a125*a071);
  a182=(a131*a109);
  a181=(a181+a182);
  a182=(a132*a156);
  a181=(a181+a182);
  a182=(a006*a009);
  a183=(a030*a076);
  a182=(a182+a183);
  a183=(a100*a110);
  a182=(a182+a183);
  a182=(a071+a182);
  a183=(a133*a182);
  a181=(a181+a183);
  a181=(a041+a181);
  a181=(a040*a181);
  a180=(a180+a181);
  a161=(a161-a180);
  a176=(a179*a176);
  a161=(a161-a176);
  a177=(a177*a178);
  a177=(a034-a177);
  a173=(a173*a179);
  a177=(a177-a173);
  a161=(a161/a177);
  a173=(a179*a161);
  a162=(a162-a173);
  a173=(a174*a162);
  a172=(a172-a173);
  a173=(a178*a161);
  a172=(a172+a173);
  a173=(a159*a172);
  a155=(a155+a173);
  a155=(a003+a155);
  a173=(a147*a155);
  a004=(a004+a173);
  a173=3.1116436695781990e-01;
  a173=(a173*a002);
  a176=6.2411095871607569e-01;
  a176=(a176*a002);
  a181=(a176*a021);
  a183=-3.3608926294469414e+00;
  a183=(a183*a002);
  a184=(a183*a099);
  a181=(a181+a184);
  a184=-8.6821934684172597e-01;
  a184=(a184*a002);
  a185=(a184*a121);
  a181=(a181+a185);
  a185=2.7592099699446710e+01;
  a185=(a185*a002);
  a186=(a185*a146);
  a181=(a181+a186);
  a186=2.0154067550477894e+01;
  a186=(a186*a002);
  a187=(a186*a172);
  a181=(a181+a187);
  a187=-4.3489884181069961e+01;
  a187=(a187*a002);
  a188=(a150*a033);
  a189=(a087*a081);
  a188=(a188+a189);
  a189=(a157*a111);
  a188=(a188+a189);
  a189=(a158*a136);
  a188=(a188+a189);
  a189=(a159*a162);
  a188=(a188+a189);
  a188=(a008+a188);
  a189=(a007*a188);
  a190=(a150*a008);
  a191=(a087*a043);
  a190=(a190+a191);
  a191=(a157*a108);
  a190=(a190+a191);
  a191=(a158*a134);
  a190=(a190+a191);
  a191=(a159*a160);
  a190=(a190+a191);
  a190=(a010+a190);
  a191=sin(a190);
  a189=(a189*a191);
  a192=(2.*a155);
  a193=(a188-a192);
  a189=(a189*a193);
  a193=(a150*a003);
  a194=(a087*a090);
  a193=(a193+a194);
  a194=(a157*a113);
  a193=(a193+a194);
  a194=(a158*a022);
  a193=(a193+a194);
  a194=(a159*a130);
  a193=(a193+a194);
  a193=(a000+a193);
  a194=sin(a193);
  a195=(a193-a190);
  a196=sin(a195);
  a197=(a194-a196);
  a197=(a007*a197);
  a189=(a189+a197);
  a189=(a189+a194);
  a198=cos(a190);
  a199=(a018-a198);
  a199=(a017*a199);
  a199=(a199+a018);
  a200=(a189/a199);
  a201=(a198-a018);
  a201=(a007*a201);
  a202=(a201/a199);
  a203=casadi_sq(a155);
  a203=(a203*a191);
  a203=(a203+a196);
  a203=(a007*a203);
  a196=3.0769230769230771e-01;
  a196=(a196*a002);
  a196=(a028+a196);
  a196=(a026*a196);
  a204=sin(a196);
  a204=(a027*a204);
  a204=(a188+a204);
  a204=(a015*a204);
  a196=cos(a196);
  a196=(a196+a018);
  a196=(a025*a196);
  a196=(a032-a196);
  a196=(a196+a190);
  a196=(a031*a196);
  a204=(a204+a196);
  a203=(a203-a204);
  a204=(a202*a189);
  a204=(a203-a204);
  a196=(a201*a202);
  a196=(a007-a196);
  a190=(a204/a196);
  a193=cos(a193);
  a205=(a034*a193);
  a206=(a205/a199);
  a201=(a201*a206);
  a207=(a201/a196);
  a189=(a206*a189);
  a208=(a034*a155);
  a208=(a208*a155);
  a208=(a208*a194);
  a209=(a150*a071);
  a210=(a087*a109);
  a209=(a209+a210);
  a210=(a157*a156);
  a209=(a209+a210);
  a210=(a158*a182);
  a209=(a209+a210);
  a210=(a125*a009);
  a211=(a131*a076);
  a210=(a210+a211);
  a211=(a132*a110);
  a210=(a210+a211);
  a211=(a133*a135);
  a210=(a210+a211);
  a210=(a071+a210);
  a211=(a159*a210);
  a209=(a209+a211);
  a209=(a041+a209);
  a209=(a040*a209);
  a208=(a208+a209);
  a189=(a189-a208);
  a204=(a207*a204);
  a189=(a189-a204);
  a205=(a205*a206);
  a205=(a034-a205);
  a201=(a201*a207);
  a205=(a205-a201);
  a189=(a189/a205);
  a201=(a207*a189);
  a190=(a190-a201);
  a201=(a202*a190);
  a200=(a200-a201);
  a201=(a206*a189);
  a200=(a200+a201);
  a201=(a187*a200);
  a181=(a181+a201);
  a181=(a003+a181);
  a201=(a173*a181);
  a004=(a004+a201);
  a201=-1.5216094966251609e-01;
  a201=(a201*a002);
  a204=4.7766253643826434e-01;
  a204=(a204*a002);
  a209=(a204*a021);
  a211=-2.4881146199716677e+00;
  a211=(a211*a002);
  a212=(a211*a099);
  a209=(a209+a212);
  a212=-5.9029082683684297e-01;
  a212=(a212*a002);
  a213=(a212*a121);
  a209=(a209+a213);
  a213=2.1230051448181193e+01;
  a213=(a213*a002);
  a214=(a213*a146);
  a209=(a209+a214);
  a214=1.5279233632882423e+01;
  a214=(a214*a002);
  a215=(a214*a172);
  a209=(a209+a215);
  a215=-3.3288210968984863e+01;
  a215=(a215*a002);
  a216=(a215*a200);
  a209=(a209+a216);
  a216=-2.0331201708508627e-02;
  a216=(a216*a002);
  a217=(a176*a033);
  a218=(a183*a081);
  a217=(a217+a218);
  a218=(a184*a111);
  a217=(a217+a218);
  a218=(a185*a136);
  a217=(a217+a218);
  a218=(a186*a162);
  a217=(a217+a218);
  a218=(a187*a190);
  a217=(a217+a218);
  a217=(a008+a217);
  a218=(a007*a217);
  a219=(a176*a008);
  a220=(a183*a043);
  a219=(a219+a220);
  a220=(a184*a108);
  a219=(a219+a220);
  a220=(a185*a134);
  a219=(a219+a220);
  a220=(a186*a160);
  a219=(a219+a220);
  a220=(a187*a188);
  a219=(a219+a220);
  a219=(a010+a219);
  a220=sin(a219);
  a218=(a218*a220);
  a221=(2.*a181);
  a222=(a217-a221);
  a218=(a218*a222);
  a222=(a176*a003);
  a223=(a183*a090);
  a222=(a222+a223);
  a223=(a184*a113);
  a222=(a222+a223);
  a223=(a185*a022);
  a222=(a222+a223);
  a223=(a186*a130);
  a222=(a222+a223);
  a223=(a187*a155);
  a222=(a222+a223);
  a222=(a000+a222);
  a223=sin(a222);
  a224=(a222-a219);
  a225=sin(a224);
  a226=(a223-a225);
  a226=(a007*a226);
  a218=(a218+a226);
  a218=(a218+a223);
  a227=cos(a219);
  a228=(a018-a227);
  a228=(a017*a228);
  a228=(a228+a018);
  a229=(a218/a228);
  a230=(a227-a018);
  a230=(a007*a230);
  a231=(a230/a228);
  a232=casadi_sq(a181);
  a232=(a232*a220);
  a232=(a232+a225);
  a232=(a007*a232);
  a225=6.5128205128205130e-01;
  a225=(a225*a002);
  a225=(a028+a225);
  a225=(a026*a225);
  a233=sin(a225);
  a233=(a027*a233);
  a233=(a217+a233);
  a233=(a015*a233);
  a225=cos(a225);
  a225=(a225+a018);
  a225=(a025*a225);
  a225=(a032-a225);
  a225=(a225+a219);
  a225=(a031*a225);
  a233=(a233+a225);
  a232=(a232-a233);
  a233=(a231*a218);
  a233=(a232-a233);
  a225=(a230*a231);
  a225=(a007-a225);
  a219=(a233/a225);
  a222=cos(a222);
  a234=(a034*a222);
  a235=(a234/a228);
  a230=(a230*a235);
  a236=(a230/a225);
  a218=(a235*a218);
  a237=(a034*a181);
  a237=(a237*a181);
  a237=(a237*a223);
  a238=(a176*a071);
  a239=(a183*a109);
  a238=(a238+a239);
  a239=(a184*a156);
  a238=(a238+a239);
  a239=(a185*a182);
  a238=(a238+a239);
  a239=(a186*a210);
  a238=(a238+a239);
  a239=(a150*a009);
  a240=(a087*a076);
  a239=(a239+a240);
  a240=(a157*a110);
  a239=(a239+a240);
  a240=(a158*a135);
  a239=(a239+a240);
  a240=(a159*a161);
  a239=(a239+a240);
  a239=(a071+a239);
  a240=(a187*a239);
  a238=(a238+a240);
  a238=(a041+a238);
  a238=(a040*a238);
  a237=(a237+a238);
  a218=(a218-a237);
  a233=(a236*a233);
  a218=(a218-a233);
  a234=(a234*a235);
  a234=(a034-a234);
  a230=(a230*a236);
  a234=(a234-a230);
  a218=(a218/a234);
  a230=(a236*a218);
  a219=(a219-a230);
  a230=(a231*a219);
  a229=(a229-a230);
  a230=(a235*a218);
  a229=(a229+a230);
  a230=(a216*a229);
  a209=(a209+a230);
  a209=(a003+a209);
  a230=(a201*a209);
  a004=(a004+a230);
  a230=2.0136540080403034e-01;
  a230=(a230*a002);
  a233=-9.3714243008598730e-01;
  a233=(a233*a002);
  a238=(a233*a021);
  a240=5.1863724288440638e+00;
  a240=(a240*a002);
  a241=(a240*a099);
  a238=(a238+a241);
  a241=1.0914373489967295e+00;
  a241=(a241*a002);
  a242=(a241*a121);
  a238=(a238+a242);
  a242=-8.1497870107469268e+00;
  a242=(a242*a002);
  a243=(a242*a146);
  a238=(a238+a243);
  a243=-1.8520065659996959e+01;
  a243=(a243*a002);
  a244=(a243*a172);
  a238=(a238+a244);
  a244=2.2739487099350505e+01;
  a244=(a244*a002);
  a245=(a244*a200);
  a238=(a238+a245);
  a245=2.4936055526796523e+00;
  a245=(a245*a002);
  a246=(a245*a229);
  a238=(a238+a246);
  a246=-3.0467644718982196e+00;
  a246=(a246*a002);
  a247=(a204*a033);
  a248=(a211*a081);
  a247=(a247+a248);
  a248=(a212*a111);
  a247=(a247+a248);
  a248=(a213*a136);
  a247=(a247+a248);
  a248=(a214*a162);
  a247=(a247+a248);
  a248=(a215*a190);
  a247=(a247+a248);
  a248=(a216*a219);
  a247=(a247+a248);
  a247=(a008+a247);
  a248=(a007*a247);
  a249=(a204*a008);
  a250=(a211*a043);
  a249=(a249+a250);
  a250=(a212*a108);
  a249=(a249+a250);
  a250=(a213*a134);
  a249=(a249+a250);
  a250=(a214*a160);
  a249=(a249+a250);
  a250=(a215*a188);
  a249=(a249+a250);
  a250=(a216*a217);
  a249=(a249+a250);
  a249=(a010+a249);
  a250=sin(a249);
  a248=(a248*a250);
  a251=(2.*a209);
  a252=(a247-a251);
  a248=(a248*a252);
  a252=(a204*a003);
  a253=(a211*a090);
  a252=(a252+a253);
  a253=(a212*a113);
  a252=(a252+a253);
  a253=(a213*a022);
  a252=(a252+a253);
  a253=(a214*a130);
  a252=(a252+a253);
  a253=(a215*a155);
  a252=(a252+a253);
  a253=(a216*a181);
  a252=(a252+a253);
  a252=(a000+a252);
  a253=sin(a252);
  a254=(a252-a249);
  a255=sin(a254);
  a256=(a253-a255);
  a256=(a007*a256);
  a248=(a248+a256);
  a248=(a248+a253);
  a257=cos(a249);
  a258=(a018-a257);
  a258=(a017*a258);
  a258=(a258+a018);
  a259=(a248/a258);
  a260=(a257-a018);
  a260=(a007*a260);
  a261=(a260/a258);
  a262=casadi_sq(a209);
  a262=(a262*a250);
  a262=(a262+a255);
  a262=(a007*a262);
  a255=5.9999999999999998e-01;
  a255=(a255*a002);
  a255=(a028+a255);
  a255=(a026*a255);
  a263=sin(a255);
  a263=(a027*a263);
  a263=(a247+a263);
  a263=(a015*a263);
  a255=cos(a255);
  a255=(a255+a018);
  a255=(a025*a255);
  a255=(a032-a255);
  a255=(a255+a249);
  a255=(a031*a255);
  a263=(a263+a255);
  a262=(a262-a263);
  a263=(a261*a248);
  a263=(a262-a263);
  a255=(a260*a261);
  a255=(a007-a255);
  a249=(a263/a255);
  a252=cos(a252);
  a264=(a034*a252);
  a265=(a264/a258);
  a260=(a260*a265);
  a266=(a260/a255);
  a248=(a265*a248);
  a267=(a034*a209);
  a267=(a267*a209);
  a267=(a267*a253);
  a268=(a204*a071);
  a269=(a211*a109);
  a268=(a268+a269);
  a269=(a212*a156);
  a268=(a268+a269);
  a269=(a213*a182);
  a268=(a268+a269);
  a269=(a214*a210);
  a268=(a268+a269);
  a269=(a215*a239);
  a268=(a268+a269);
  a269=(a176*a009);
  a270=(a183*a076);
  a269=(a269+a270);
  a270=(a184*a110);
  a269=(a269+a270);
  a270=(a185*a135);
  a269=(a269+a270);
  a270=(a186*a161);
  a269=(a269+a270);
  a270=(a187*a189);
  a269=(a269+a270);
  a269=(a071+a269);
  a270=(a216*a269);
  a268=(a268+a270);
  a268=(a041+a268);
  a268=(a040*a268);
  a267=(a267+a268);
  a248=(a248-a267);
  a263=(a266*a263);
  a248=(a248-a263);
  a264=(a264*a265);
  a264=(a034-a264);
  a260=(a260*a266);
  a264=(a264-a260);
  a248=(a248/a264);
  a260=(a266*a248);
  a249=(a249-a260);
  a260=(a261*a249);
  a259=(a259-a260);
  a260=(a265*a248);
  a259=(a259+a260);
  a260=(a246*a259);
  a238=(a238+a260);
  a238=(a003+a238);
  a260=(a230*a238);
  a004=(a004+a260);
  a260=4.4710615727772587e-02;
  a260=(a260*a002);
  a263=2.2733101475165380e+00;
  a263=(a263*a002);
  a268=(a263*a021);
  a270=-1.0534495466737249e+01;
  a270=(a270*a002);
  a099=(a270*a099);
  a268=(a268+a099);
  a099=-2.0008720582248625e+00;
  a099=(a099*a002);
  a121=(a099*a121);
  a268=(a268+a121);
  a121=-1.7958931863118799e+01;
  a121=(a121*a002);
  a271=(a121*a146);
  a268=(a268+a271);
  a271=2.7948884529419960e+01;
  a271=(a271*a002);
  a272=(a271*a172);
  a268=(a268+a272);
  a272=-2.8589982771350235e+00;
  a272=(a272*a002);
  a273=(a272*a200);
  a268=(a268+a273);
  a273=-8.8728569335306293e+00;
  a273=(a273*a002);
  a274=(a273*a229);
  a268=(a268+a274);
  a274=1.2360567175794303e+01;
  a274=(a274*a002);
  a275=(a274*a259);
  a268=(a268+a275);
  a275=6.4339274601576357e-01;
  a275=(a275*a002);
  a276=(a233*a033);
  a277=(a240*a081);
  a276=(a276+a277);
  a277=(a241*a111);
  a276=(a276+a277);
  a277=(a242*a136);
  a276=(a276+a277);
  a277=(a243*a162);
  a276=(a276+a277);
  a277=(a244*a190);
  a276=(a276+a277);
  a277=(a245*a219);
  a276=(a276+a277);
  a277=(a246*a249);
  a276=(a276+a277);
  a276=(a008+a276);
  a277=(a007*a276);
  a278=(a233*a008);
  a279=(a240*a043);
  a278=(a278+a279);
  a279=(a241*a108);
  a278=(a278+a279);
  a279=(a242*a134);
  a278=(a278+a279);
  a279=(a243*a160);
  a278=(a278+a279);
  a279=(a244*a188);
  a278=(a278+a279);
  a279=(a245*a217);
  a278=(a278+a279);
  a279=(a246*a247);
  a278=(a278+a279);
  a278=(a010+a278);
  a279=sin(a278);
  a277=(a277*a279);
  a280=(2.*a238);
  a281=(a276-a280);
  a277=(a277*a281);
  a281=(a233*a003);
  a282=(a240*a090);
  a281=(a281+a282);
  a282=(a241*a113);
  a281=(a281+a282);
  a282=(a242*a022);
  a281=(a281+a282);
  a282=(a243*a130);
  a281=(a281+a282);
  a282=(a244*a155);
  a281=(a281+a282);
  a282=(a245*a181);
  a281=(a281+a282);
  a282=(a246*a209);
  a281=(a281+a282);
  a281=(a000+a281);
  a282=sin(a281);
  a283=(a281-a278);
  a284=sin(a283);
  a285=(a282-a284);
  a285=(a007*a285);
  a277=(a277+a285);
  a277=(a277+a282);
  a286=cos(a278);
  a287=(a018-a286);
  a287=(a017*a287);
  a287=(a287+a018);
  a288=(a277/a287);
  a289=(a286-a018);
  a289=(a007*a289);
  a290=(a289/a287);
  a291=casadi_sq(a238);
  a291=(a291*a279);
  a291=(a291+a284);
  a291=(a007*a291);
  a284=8.5714285714285710e-01;
  a284=(a284*a002);
  a284=(a028+a284);
  a284=(a026*a284);
  a292=sin(a284);
  a292=(a027*a292);
  a292=(a276+a292);
  a292=(a015*a292);
  a284=cos(a284);
  a284=(a284+a018);
  a284=(a025*a284);
  a284=(a032-a284);
  a284=(a284+a278);
  a284=(a031*a284);
  a292=(a292+a284);
  a291=(a291-a292);
  a292=(a290*a277);
  a292=(a291-a292);
  a284=(a289*a290);
  a284=(a007-a284);
  a278=(a292/a284);
  a281=cos(a281);
  a293=(a034*a281);
  a294=(a293/a287);
  a289=(a289*a294);
  a295=(a289/a284);
  a277=(a294*a277);
  a296=(a034*a238);
  a296=(a296*a238);
  a296=(a296*a282);
  a297=(a233*a071);
  a298=(a240*a109);
  a297=(a297+a298);
  a298=(a241*a156);
  a297=(a297+a298);
  a298=(a242*a182);
  a297=(a297+a298);
  a298=(a243*a210);
  a297=(a297+a298);
  a298=(a244*a239);
  a297=(a297+a298);
  a298=(a245*a269);
  a297=(a297+a298);
  a298=(a204*a009);
  a299=(a211*a076);
  a298=(a298+a299);
  a299=(a212*a110);
  a298=(a298+a299);
  a299=(a213*a135);
  a298=(a298+a299);
  a299=(a214*a161);
  a298=(a298+a299);
  a299=(a215*a189);
  a298=(a298+a299);
  a299=(a216*a218);
  a298=(a298+a299);
  a298=(a071+a298);
  a299=(a246*a298);
  a297=(a297+a299);
  a297=(a041+a297);
  a297=(a040*a297);
  a296=(a296+a297);
  a277=(a277-a296);
  a292=(a295*a292);
  a277=(a277-a292);
  a293=(a293*a294);
  a293=(a034-a293);
  a289=(a289*a295);
  a293=(a293-a289);
  a277=(a277/a293);
  a289=(a295*a277);
  a278=(a278-a289);
  a289=(a290*a278);
  a288=(a288-a289);
  a289=(a294*a277);
  a288=(a288+a289);
  a289=(a275*a288);
  a268=(a268+a289);
  a268=(a003+a268);
  a289=(a260*a268);
  a004=(a004+a289);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a289=(a005*a134);
  a004=(a004+a289);
  a289=(a122*a160);
  a004=(a004+a289);
  a289=(a147*a188);
  a004=(a004+a289);
  a289=(a173*a217);
  a004=(a004+a289);
  a289=(a201*a247);
  a004=(a004+a289);
  a289=(a230*a276);
  a004=(a004+a289);
  a289=(a263*a033);
  a081=(a270*a081);
  a289=(a289+a081);
  a111=(a099*a111);
  a289=(a289+a111);
  a111=(a121*a136);
  a289=(a289+a111);
  a111=(a271*a162);
  a289=(a289+a111);
  a111=(a272*a190);
  a289=(a289+a111);
  a111=(a273*a219);
  a289=(a289+a111);
  a111=(a274*a249);
  a289=(a289+a111);
  a111=(a275*a278);
  a289=(a289+a111);
  a289=(a008+a289);
  a111=(a260*a289);
  a004=(a004+a111);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a071);
  a111=(a005*a182);
  a004=(a004+a111);
  a111=(a122*a210);
  a004=(a004+a111);
  a111=(a147*a239);
  a004=(a004+a111);
  a111=(a173*a269);
  a004=(a004+a111);
  a111=(a201*a298);
  a004=(a004+a111);
  a111=(a233*a009);
  a081=(a240*a076);
  a111=(a111+a081);
  a081=(a241*a110);
  a111=(a111+a081);
  a081=(a242*a135);
  a111=(a111+a081);
  a081=(a243*a161);
  a111=(a111+a081);
  a081=(a244*a189);
  a111=(a111+a081);
  a081=(a245*a218);
  a111=(a111+a081);
  a081=(a246*a248);
  a111=(a111+a081);
  a111=(a071+a111);
  a081=(a230*a111);
  a004=(a004+a081);
  a081=(a263*a009);
  a076=(a270*a076);
  a081=(a081+a076);
  a110=(a099*a110);
  a081=(a081+a110);
  a110=(a121*a135);
  a081=(a081+a110);
  a110=(a271*a161);
  a081=(a081+a110);
  a110=(a272*a189);
  a081=(a081+a110);
  a110=(a273*a218);
  a081=(a081+a110);
  a110=(a274*a248);
  a081=(a081+a110);
  a110=(a275*a277);
  a081=(a081+a110);
  a081=(a071+a081);
  a081=(a260*a081);
  a004=(a004+a081);
  a004=(a041+a004);
  if (res[0]!=0) res[0][2]=a004;
  a021=(a001*a021);
  a146=(a005*a146);
  a021=(a021+a146);
  a172=(a122*a172);
  a021=(a021+a172);
  a200=(a147*a200);
  a021=(a021+a200);
  a229=(a173*a229);
  a021=(a021+a229);
  a259=(a201*a259);
  a021=(a021+a259);
  a288=(a230*a288);
  a021=(a021+a288);
  a288=(a007*a289);
  a259=(a263*a008);
  a229=(a270*a043);
  a259=(a259+a229);
  a229=(a099*a108);
  a259=(a259+a229);
  a229=(a121*a134);
  a259=(a259+a229);
  a229=(a271*a160);
  a259=(a259+a229);
  a229=(a272*a188);
  a259=(a259+a229);
  a229=(a273*a217);
  a259=(a259+a229);
  a229=(a274*a247);
  a259=(a259+a229);
  a229=(a275*a276);
  a259=(a259+a229);
  a010=(a010+a259);
  a259=sin(a010);
  a288=(a288*a259);
  a229=(2.*a268);
  a200=(a289-a229);
  a288=(a288*a200);
  a200=(a263*a003);
  a172=(a270*a090);
  a200=(a200+a172);
  a172=(a099*a113);
  a200=(a200+a172);
  a172=(a121*a022);
  a200=(a200+a172);
  a172=(a271*a130);
  a200=(a200+a172);
  a172=(a272*a155);
  a200=(a200+a172);
  a172=(a273*a181);
  a200=(a200+a172);
  a172=(a274*a209);
  a200=(a200+a172);
  a172=(a275*a238);
  a200=(a200+a172);
  a000=(a000+a200);
  a200=sin(a000);
  a172=(a000-a010);
  a146=sin(a172);
  a004=(a200-a146);
  a004=(a007*a004);
  a288=(a288+a004);
  a288=(a288+a200);
  a081=cos(a010);
  a110=(a018-a081);
  a110=(a017*a110);
  a110=(a110+a018);
  a076=(a288/a110);
  a292=(a081-a018);
  a292=(a007*a292);
  a297=(a292/a110);
  a299=casadi_sq(a268);
  a299=(a299*a259);
  a299=(a299+a146);
  a299=(a007*a299);
  a028=(a028+a002);
  a026=(a026*a028);
  a028=sin(a026);
  a027=(a027*a028);
  a027=(a289+a027);
  a027=(a015*a027);
  a026=cos(a026);
  a026=(a026+a018);
  a025=(a025*a026);
  a032=(a032-a025);
  a032=(a032+a010);
  a032=(a031*a032);
  a027=(a027+a032);
  a299=(a299-a027);
  a027=(a297*a288);
  a027=(a299-a027);
  a032=(a292*a297);
  a032=(a007-a032);
  a010=(a027/a032);
  a000=cos(a000);
  a025=(a034*a000);
  a026=(a025/a110);
  a292=(a292*a026);
  a018=(a292/a032);
  a288=(a026*a288);
  a028=(a034*a268);
  a028=(a028*a268);
  a028=(a028*a200);
  a002=(a263*a071);
  a109=(a270*a109);
  a002=(a002+a109);
  a156=(a099*a156);
  a002=(a002+a156);
  a182=(a121*a182);
  a002=(a002+a182);
  a210=(a271*a210);
  a002=(a002+a210);
  a239=(a272*a239);
  a002=(a002+a239);
  a269=(a273*a269);
  a002=(a002+a269);
  a298=(a274*a298);
  a002=(a002+a298);
  a111=(a275*a111);
  a002=(a002+a111);
  a041=(a041+a002);
  a041=(a040*a041);
  a028=(a028+a041);
  a288=(a288-a028);
  a027=(a018*a027);
  a288=(a288-a027);
  a025=(a025*a026);
  a025=(a034-a025);
  a292=(a292*a018);
  a025=(a025-a292);
  a288=(a288/a025);
  a292=(a018*a288);
  a010=(a010-a292);
  a292=(a297*a010);
  a076=(a076-a292);
  a292=(a026*a288);
  a076=(a076+a292);
  a076=(a260*a076);
  a021=(a021+a076);
  a021=(a003+a021);
  if (res[0]!=0) res[0][3]=a021;
  a033=(a001*a033);
  a136=(a005*a136);
  a033=(a033+a136);
  a162=(a122*a162);
  a033=(a033+a162);
  a190=(a147*a190);
  a033=(a033+a190);
  a219=(a173*a219);
  a033=(a033+a219);
  a249=(a201*a249);
  a033=(a033+a249);
  a278=(a230*a278);
  a033=(a033+a278);
  a010=(a260*a010);
  a033=(a033+a010);
  a033=(a008+a033);
  if (res[0]!=0) res[0][4]=a033;
  a009=(a001*a009);
  a135=(a005*a135);
  a009=(a009+a135);
  a161=(a122*a161);
  a009=(a009+a161);
  a189=(a147*a189);
  a009=(a009+a189);
  a218=(a173*a218);
  a009=(a009+a218);
  a248=(a201*a248);
  a009=(a009+a248);
  a277=(a230*a277);
  a009=(a009+a277);
  a288=(a260*a288);
  a009=(a009+a288);
  a071=(a071+a009);
  if (res[0]!=0) res[0][5]=a071;
  a071=arg[0]? arg[0][6] : 0;
  a009=arg[0]? arg[0][9] : 0;
  a288=(a001*a009);
  a014=cos(a014);
  a277=(a035-a014);
  a277=(a007*a277);
  a248=(a007*a011);
  a012=(a012-a008);
  a012=(a008*a012);
  a248=(a248*a012);
  a016=(a016-a248);
  a016=(a016+a013);
  a248=(a037*a016);
  a248=(a248-a039);
  a039=(a023*a016);
  a024=(a024-a039);
  a039=(a038*a024);
  a248=(a248-a039);
  a248=(a248/a036);
  a039=(a248*a034);
  a039=(a039*a013);
  a277=(a277-a039);
  a277=(a277+a035);
  a039=(a277/a020);
  a218=(a007*a014);
  a189=(a023*a277);
  a218=(a218-a189);
  a189=(a218/a029);
  a277=(a037*a277);
  a016=(a016/a020);
  a024=(a024/a029);
  a161=(a038*a248);
  a024=(a024-a161);
  a161=(a023*a024);
  a016=(a016-a161);
  a248=(a037*a248);
  a016=(a016+a248);
  a248=(a016*a013);
  a035=(a035*a003);
  a035=(a035*a003);
  a248=(a248+a035);
  a248=(a034*a248);
  a277=(a277-a248);
  a218=(a038*a218);
  a277=(a277-a218);
  a277=(a277/a036);
  a218=(a038*a277);
  a189=(a189-a218);
  a218=(a023*a189);
  a039=(a039-a218);
  a218=(a037*a277);
  a039=(a039+a218);
  a218=(a039*a071);
  a024=(a024*a011);
  a248=(2.*a016);
  a248=(a248*a011);
  a024=(a024-a248);
  a024=(a024+a014);
  a012=(a019*a012);
  a024=(a024-a012);
  a024=(a007*a024);
  a012=(a024/a020);
  a016=(a016*a011);
  a016=(a016-a014);
  a019=(a019*a003);
  a019=(a019*a003);
  a016=(a016+a019);
  a016=(a007*a016);
  a016=(a016-a031);
  a019=(a023*a024);
  a016=(a016-a019);
  a019=(a016/a029);
  a024=(a037*a024);
  a016=(a038*a016);
  a024=(a024-a016);
  a024=(a024/a036);
  a016=(a038*a024);
  a019=(a019-a016);
  a016=(a023*a019);
  a012=(a012-a016);
  a016=(a037*a024);
  a012=(a012+a016);
  a016=arg[0]? arg[0][7] : 0;
  a014=(a012*a016);
  a218=(a218+a014);
  a014=(a040/a036);
  a248=(a038*a014);
  a035=(a023*a248);
  a161=(a037*a014);
  a035=(a035+a161);
  a161=arg[0]? arg[0][8] : 0;
  a135=(a035*a161);
  a218=(a218-a135);
  a135=-2.;
  a033=(a135*a007);
  a010=(a033*a008);
  a010=(a010*a011);
  a278=(a010/a020);
  a249=(a017*a003);
  a249=(a249*a011);
  a219=(a023*a010);
  a249=(a249-a219);
  a219=(a249/a029);
  a135=(a135*a034);
  a190=(a135*a003);
  a190=(a190*a013);
  a010=(a037*a010);
  a190=(a190+a010);
  a249=(a038*a249);
  a190=(a190-a249);
  a190=(a190/a036);
  a249=(a038*a190);
  a219=(a219-a249);
  a249=(a023*a219);
  a278=(a278-a249);
  a249=(a037*a190);
  a278=(a278+a249);
  a249=(a278*a009);
  a011=(a017*a011);
  a008=(a008-a003);
  a011=(a011*a008);
  a020=(a011/a020);
  a008=(a023*a011);
  a008=(a015+a008);
  a029=(a008/a029);
  a011=(a037*a011);
  a008=(a038*a008);
  a011=(a011+a008);
  a011=(a011/a036);
  a038=(a038*a011);
  a029=(a029+a038);
  a023=(a023*a029);
  a020=(a020+a023);
  a037=(a037*a011);
  a020=(a020+a037);
  a037=arg[0]? arg[0][10] : 0;
  a023=(a020*a037);
  a249=(a249+a023);
  a218=(a218+a249);
  a249=(a006*a218);
  a094=cos(a094);
  a023=(a092-a094);
  a023=(a007*a023);
  a038=(a007*a089);
  a091=(a091-a043);
  a091=(a043*a091);
  a038=(a038*a091);
  a096=(a096-a038);
  a096=(a096+a093);
  a038=(a105*a096);
  a038=(a038-a107);
  a107=(a101*a096);
  a102=(a102-a107);
  a107=(a106*a102);
  a038=(a038-a107);
  a038=(a038/a104);
  a107=(a038*a034);
  a107=(a107*a093);
  a023=(a023-a107);
  a023=(a023+a092);
  a107=(a023/a098);
  a036=(a007*a094);
  a008=(a101*a023);
  a036=(a036-a008);
  a008=(a036/a095);
  a023=(a105*a023);
  a096=(a096/a098);
  a102=(a102/a095);
  a003=(a106*a038);
  a102=(a102-a003);
  a003=(a101*a102);
  a096=(a096-a003);
  a038=(a105*a038);
  a096=(a096+a038);
  a038=(a096*a093);
  a092=(a092*a090);
  a092=(a092*a090);
  a038=(a038+a092);
  a038=(a034*a038);
  a023=(a023-a038);
  a036=(a106*a036);
  a023=(a023-a036);
  a023=(a023/a104);
  a036=(a106*a023);
  a008=(a008-a036);
  a036=(a101*a008);
  a107=(a107-a036);
  a036=(a105*a023);
  a107=(a107+a036);
  a036=(a042*a009);
  a038=(a045*a218);
  a057=cos(a057);
  a092=(a055-a057);
  a092=(a007*a092);
  a003=(a007*a052);
  a054=(a054-a049);
  a054=(a049*a054);
  a003=(a003*a054);
  a059=(a059-a003);
  a059=(a059+a056);
  a003=(a068*a059);
  a003=(a003-a070);
  a070=(a064*a059);
  a065=(a065-a070);
  a070=(a069*a065);
  a003=(a003-a070);
  a003=(a003/a067);
  a070=(a003*a034);
  a070=(a070*a056);
  a092=(a092-a070);
  a092=(a092+a055);
  a070=(a092/a061);
  a010=(a007*a057);
  a013=(a064*a092);
  a010=(a010-a013);
  a013=(a010/a058);
  a092=(a068*a092);
  a059=(a059/a061);
  a065=(a065/a058);
  a162=(a069*a003);
  a065=(a065-a162);
  a162=(a064*a065);
  a059=(a059-a162);
  a003=(a068*a003);
  a059=(a059+a003);
  a003=(a059*a056);
  a055=(a055*a053);
  a055=(a055*a053);
  a003=(a003+a055);
  a003=(a034*a003);
  a092=(a092-a003);
  a010=(a069*a010);
  a092=(a092-a010);
  a092=(a092/a067);
  a010=(a069*a092);
  a013=(a013-a010);
  a010=(a064*a013);
  a070=(a070-a010);
  a010=(a068*a092);
  a070=(a070+a010);
  a010=(a048*a009);
  a010=(a071+a010);
  a003=(a070*a010);
  a065=(a065*a052);
  a055=(2.*a059);
  a055=(a055*a052);
  a065=(a065-a055);
  a065=(a065+a057);
  a054=(a060*a054);
  a065=(a065-a054);
  a065=(a007*a065);
  a054=(a065/a061);
  a059=(a059*a052);
  a059=(a059-a057);
  a060=(a060*a053);
  a060=(a060*a053);
  a059=(a059+a060);
  a059=(a007*a059);
  a059=(a059-a031);
  a060=(a064*a065);
  a059=(a059-a060);
  a060=(a059/a058);
  a065=(a068*a065);
  a059=(a069*a059);
  a065=(a065-a059);
  a065=(a065/a067);
  a059=(a069*a065);
  a060=(a060-a059);
  a059=(a064*a060);
  a054=(a054-a059);
  a059=(a068*a065);
  a054=(a054+a059);
  a059=(a048*a037);
  a059=(a016+a059);
  a057=(a054*a059);
  a003=(a003+a057);
  a057=(a040/a067);
  a055=(a069*a057);
  a162=(a064*a055);
  a136=(a068*a057);
  a162=(a162+a136);
  a136=arg[0]? arg[0][11] : 0;
  a021=(a048*a136);
  a021=(a161+a021);
  a076=(a162*a021);
  a003=(a003-a076);
  a076=(a033*a049);
  a076=(a076*a052);
  a292=(a076/a061);
  a027=(a017*a053);
  a027=(a027*a052);
  a041=(a064*a076);
  a027=(a027-a041);
  a041=(a027/a058);
  a002=(a135*a053);
  a002=(a002*a056);
  a076=(a068*a076);
  a002=(a002+a076);
  a027=(a069*a027);
  a002=(a002-a027);
  a002=(a002/a067);
  a027=(a069*a002);
  a041=(a041-a027);
  a027=(a064*a041);
  a292=(a292-a027);
  a027=(a068*a002);
  a292=(a292+a027);
  a027=(a048*a218);
  a027=(a009+a027);
  a076=(a292*a027);
  a052=(a017*a052);
  a049=(a049-a053);
  a052=(a052*a049);
  a061=(a052/a061);
  a049=(a064*a052);
  a049=(a015+a049);
  a058=(a049/a058);
  a052=(a068*a052);
  a049=(a069*a049);
  a052=(a052+a049);
  a052=(a052/a067);
  a069=(a069*a052);
  a058=(a058+a069);
  a064=(a064*a058);
  a061=(a061+a064);
  a068=(a068*a052);
  a061=(a061+a068);
  a068=(a189*a071);
  a064=(a019*a016);
  a068=(a068+a064);
  a064=(a248*a161);
  a068=(a068+a064);
  a064=(a219*a009);
  a069=(a029*a037);
  a064=(a064-a069);
  a068=(a068+a064);
  a064=(a048*a068);
  a064=(a037+a064);
  a069=(a061*a064);
  a076=(a076+a069);
  a003=(a003+a076);
  a003=(a047*a003);
  a038=(a038+a003);
  a038=(a009+a038);
  a003=(a044*a038);
  a036=(a036+a003);
  a036=(a071+a036);
  a003=(a107*a036);
  a102=(a102*a089);
  a076=(2.*a096);
  a076=(a076*a089);
  a102=(a102-a076);
  a102=(a102+a094);
  a091=(a097*a091);
  a102=(a102-a091);
  a102=(a007*a102);
  a091=(a102/a098);
  a096=(a096*a089);
  a096=(a096-a094);
  a097=(a097*a090);
  a097=(a097*a090);
  a096=(a096+a097);
  a096=(a007*a096);
  a096=(a096-a031);
  a097=(a101*a102);
  a096=(a096-a097);
  a097=(a096/a095);
  a102=(a105*a102);
  a096=(a106*a096);
  a102=(a102-a096);
  a102=(a102/a104);
  a096=(a106*a102);
  a097=(a097-a096);
  a096=(a101*a097);
  a091=(a091-a096);
  a096=(a105*a102);
  a091=(a091+a096);
  a096=(a042*a037);
  a094=(a045*a068);
  a076=(a013*a010);
  a069=(a060*a059);
  a076=(a076+a069);
  a069=(a055*a021);
  a076=(a076+a069);
  a069=(a041*a027);
  a067=(a058*a064);
  a069=(a069-a067);
  a076=(a076+a069);
  a076=(a047*a076);
  a094=(a094+a076);
  a094=(a037+a094);
  a076=(a044*a094);
  a096=(a096+a076);
  a096=(a016+a096);
  a076=(a091*a096);
  a003=(a003+a076);
  a076=(a040/a104);
  a069=(a106*a076);
  a067=(a101*a069);
  a049=(a105*a076);
  a067=(a067+a049);
  a049=(a042*a136);
  a053=(a277*a071);
  a056=(a024*a016);
  a053=(a053+a056);
  a056=(a014*a161);
  a053=(a053-a056);
  a056=(a190*a009);
  a111=(a011*a037);
  a056=(a056+a111);
  a053=(a053+a056);
  a056=(a045*a053);
  a010=(a092*a010);
  a059=(a065*a059);
  a010=(a010+a059);
  a021=(a057*a021);
  a010=(a010-a021);
  a021=(a002*a027);
  a059=(a052*a064);
  a021=(a021+a059);
  a010=(a010+a021);
  a010=(a047*a010);
  a056=(a056+a010);
  a056=(a136+a056);
  a010=(a044*a056);
  a049=(a049+a010);
  a049=(a161+a049);
  a010=(a067*a049);
  a003=(a003-a010);
  a010=(a033*a043);
  a010=(a010*a089);
  a021=(a010/a098);
  a059=(a017*a090);
  a059=(a059*a089);
  a111=(a101*a010);
  a059=(a059-a111);
  a111=(a059/a095);
  a298=(a135*a090);
  a298=(a298*a093);
  a010=(a105*a010);
  a298=(a298+a010);
  a059=(a106*a059);
  a298=(a298-a059);
  a298=(a298/a104);
  a059=(a106*a298);
  a111=(a111-a059);
  a059=(a101*a111);
  a021=(a021-a059);
  a059=(a105*a298);
  a021=(a021+a059);
  a059=(a042*a218);
  a073=cos(a073);
  a010=(a072-a073);
  a010=(a007*a010);
  a093=(a007*a066);
  a079=(a079-a075);
  a079=(a075*a079);
  a093=(a093*a079);
  a074=(a074-a093);
  a074=(a074+a080);
  a093=(a085*a074);
  a093=(a093-a088);
  a088=(a077*a074);
  a062=(a062-a088);
  a088=(a086*a062);
  a093=(a093-a088);
  a093=(a093/a084);
  a088=(a093*a034);
  a088=(a088*a080);
  a010=(a010-a088);
  a010=(a010+a072);
  a088=(a010/a051);
  a269=(a007*a073);
  a239=(a077*a010);
  a269=(a269-a239);
  a239=(a269/a082);
  a010=(a085*a010);
  a074=(a074/a051);
  a062=(a062/a082);
  a210=(a086*a093);
  a062=(a062-a210);
  a210=(a077*a062);
  a074=(a074-a210);
  a093=(a085*a093);
  a074=(a074+a093);
  a093=(a074*a080);
  a072=(a072*a046);
  a072=(a072*a046);
  a093=(a093+a072);
  a093=(a034*a093);
  a010=(a010-a093);
  a269=(a086*a269);
  a010=(a010-a269);
  a010=(a010/a084);
  a269=(a086*a010);
  a239=(a239-a269);
  a269=(a077*a239);
  a088=(a088-a269);
  a269=(a085*a010);
  a088=(a088+a269);
  a269=(a045*a009);
  a027=(a047*a027);
  a269=(a269+a027);
  a269=(a071+a269);
  a027=(a088*a269);
  a062=(a062*a066);
  a093=(2.*a074);
  a093=(a093*a066);
  a062=(a062-a093);
  a062=(a062+a073);
  a079=(a063*a079);
  a062=(a062-a079);
  a062=(a007*a062);
  a079=(a062/a051);
  a074=(a074*a066);
  a074=(a074-a073);
  a063=(a063*a046);
  a063=(a063*a046);
  a074=(a074+a063);
  a074=(a007*a074);
  a074=(a074-a031);
  a063=(a077*a062);
  a074=(a074-a063);
  a063=(a074/a082);
  a062=(a085*a062);
  a074=(a086*a074);
  a062=(a062-a074);
  a062=(a062/a084);
  a074=(a086*a062);
  a063=(a063-a074);
  a074=(a077*a063);
  a079=(a079-a074);
  a074=(a085*a062);
  a079=(a079+a074);
  a074=(a045*a037);
  a064=(a047*a064);
  a074=(a074+a064);
  a074=(a016+a074);
  a064=(a079*a074);
  a027=(a027+a064);
  a064=(a040/a084);
  a073=(a086*a064);
  a093=(a077*a073);
  a072=(a085*a064);
  a093=(a093+a072);
  a072=(a045*a136);
  a210=(a048*a053);
  a210=(a136+a210);
  a210=(a047*a210);
  a072=(a072+a210);
  a072=(a161+a072);
  a210=(a093*a072);
  a027=(a027-a210);
  a210=(a033*a075);
  a210=(a210*a066);
  a182=(a210/a051);
  a156=(a017*a046);
  a156=(a156*a066);
  a109=(a077*a210);
  a156=(a156-a109);
  a109=(a156/a082);
  a146=(a135*a046);
  a146=(a146*a080);
  a210=(a085*a210);
  a146=(a146+a210);
  a156=(a086*a156);
  a146=(a146-a156);
  a146=(a146/a084);
  a156=(a086*a146);
  a109=(a109-a156);
  a156=(a077*a109);
  a182=(a182-a156);
  a156=(a085*a146);
  a182=(a182+a156);
  a156=(a182*a038);
  a066=(a017*a066);
  a075=(a075-a046);
  a066=(a066*a075);
  a051=(a066/a051);
  a075=(a077*a066);
  a075=(a015+a075);
  a082=(a075/a082);
  a066=(a085*a066);
  a075=(a086*a075);
  a066=(a066+a075);
  a066=(a066/a084);
  a086=(a086*a066);
  a082=(a082+a086);
  a077=(a077*a082);
  a051=(a051+a077);
  a085=(a085*a066);
  a051=(a051+a085);
  a085=(a051*a094);
  a156=(a156+a085);
  a027=(a027+a156);
  a156=(a044*a027);
  a059=(a059+a156);
  a059=(a009+a059);
  a156=(a021*a059);
  a089=(a017*a089);
  a043=(a043-a090);
  a089=(a089*a043);
  a098=(a089/a098);
  a043=(a101*a089);
  a043=(a015+a043);
  a095=(a043/a095);
  a089=(a105*a089);
  a043=(a106*a043);
  a089=(a089+a043);
  a089=(a089/a104);
  a106=(a106*a089);
  a095=(a095+a106);
  a101=(a101*a095);
  a098=(a098+a101);
  a105=(a105*a089);
  a098=(a098+a105);
  a105=(a042*a068);
  a101=(a239*a269);
  a106=(a063*a074);
  a101=(a101+a106);
  a106=(a073*a072);
  a101=(a101+a106);
  a106=(a109*a038);
  a104=(a082*a094);
  a106=(a106-a104);
  a101=(a101+a106);
  a106=(a044*a101);
  a105=(a105+a106);
  a105=(a037+a105);
  a106=(a098*a105);
  a156=(a156+a106);
  a003=(a003+a156);
  a156=(a030*a003);
  a249=(a249+a156);
  a116=cos(a116);
  a156=(a114-a116);
  a156=(a007*a156);
  a106=(a007*a112);
  a078=(a078-a108);
  a078=(a108*a078);
  a106=(a106*a078);
  a118=(a118-a106);
  a118=(a118+a115);
  a106=(a127*a118);
  a106=(a106-a129);
  a129=(a123*a118);
  a124=(a124-a129);
  a129=(a128*a124);
  a106=(a106-a129);
  a106=(a106/a126);
  a129=(a106*a034);
  a129=(a129*a115);
  a156=(a156-a129);
  a156=(a156+a114);
  a129=(a156/a120);
  a104=(a007*a116);
  a043=(a123*a156);
  a104=(a104-a043);
  a043=(a104/a117);
  a156=(a127*a156);
  a118=(a118/a120);
  a124=(a124/a117);
  a090=(a128*a106);
  a124=(a124-a090);
  a090=(a123*a124);
  a118=(a118-a090);
  a106=(a127*a106);
  a118=(a118+a106);
  a106=(a118*a115);
  a114=(a114*a113);
  a114=(a114*a113);
  a106=(a106+a114);
  a106=(a034*a106);
  a156=(a156-a106);
  a104=(a128*a104);
  a156=(a156-a104);
  a156=(a156/a126);
  a104=(a128*a156);
  a043=(a043-a104);
  a104=(a123*a043);
  a129=(a129-a104);
  a104=(a127*a156);
  a129=(a129+a104);
  a104=(a103*a009);
  a106=(a050*a038);
  a104=(a104+a106);
  a106=(a083*a059);
  a104=(a104+a106);
  a104=(a071+a104);
  a106=(a129*a104);
  a124=(a124*a112);
  a114=(2.*a118);
  a114=(a114*a112);
  a124=(a124-a114);
  a124=(a124+a116);
  a078=(a119*a078);
  a124=(a124-a078);
  a124=(a007*a124);
  a078=(a124/a120);
  a118=(a118*a112);
  a118=(a118-a116);
  a119=(a119*a113);
  a119=(a119*a113);
  a118=(a118+a119);
  a118=(a007*a118);
  a118=(a118-a031);
  a119=(a123*a124);
  a118=(a118-a119);
  a119=(a118/a117);
  a124=(a127*a124);
  a118=(a128*a118);
  a124=(a124-a118);
  a124=(a124/a126);
  a118=(a128*a124);
  a119=(a119-a118);
  a118=(a123*a119);
  a078=(a078-a118);
  a118=(a127*a124);
  a078=(a078+a118);
  a118=(a103*a037);
  a116=(a050*a094);
  a118=(a118+a116);
  a116=(a083*a105);
  a118=(a118+a116);
  a118=(a016+a118);
  a116=(a078*a118);
  a106=(a106+a116);
  a116=(a040/a126);
  a114=(a128*a116);
  a090=(a123*a114);
  a085=(a127*a116);
  a090=(a090+a085);
  a085=(a103*a136);
  a056=(a050*a056);
  a085=(a085+a056);
  a056=(a042*a053);
  a269=(a010*a269);
  a074=(a062*a074);
  a269=(a269+a074);
  a072=(a064*a072);
  a269=(a269-a072);
  a038=(a146*a038);
  a094=(a066*a094);
  a038=(a038+a094);
  a269=(a269+a038);
  a038=(a044*a269);
  a056=(a056+a038);
  a056=(a136+a056);
  a038=(a083*a056);
  a085=(a085+a038);
  a085=(a161+a085);
  a038=(a090*a085);
  a106=(a106-a038);
  a038=(a033*a108);
  a038=(a038*a112);
  a094=(a038/a120);
  a072=(a017*a113);
  a072=(a072*a112);
  a074=(a123*a038);
  a072=(a072-a074);
  a074=(a072/a117);
  a077=(a135*a113);
  a077=(a077*a115);
  a038=(a127*a038);
  a077=(a077+a038);
  a072=(a128*a072);
  a077=(a077-a072);
  a077=(a077/a126);
  a072=(a128*a077);
  a074=(a074-a072);
  a072=(a123*a074);
  a094=(a094-a072);
  a072=(a127*a077);
  a094=(a094+a072);
  a072=(a103*a218);
  a027=(a050*a027);
  a072=(a072+a027);
  a027=(a083*a003);
  a072=(a072+a027);
  a072=(a009+a072);
  a027=(a094*a072);
  a112=(a017*a112);
  a108=(a108-a113);
  a112=(a112*a108);
  a120=(a112/a120);
  a108=(a123*a112);
  a108=(a015+a108);
  a117=(a108/a117);
  a112=(a127*a112);
  a108=(a128*a108);
  a112=(a112+a108);
  a112=(a112/a126);
  a128=(a128*a112);
  a117=(a117+a128);
  a123=(a123*a117);
  a120=(a120+a123);
  a127=(a127*a112);
  a120=(a120+a127);
  a127=(a103*a068);
  a101=(a050*a101);
  a127=(a127+a101);
  a101=(a008*a036);
  a123=(a097*a096);
  a101=(a101+a123);
  a123=(a069*a049);
  a101=(a101+a123);
  a123=(a111*a059);
  a128=(a095*a105);
  a123=(a123-a128);
  a101=(a101+a123);
  a123=(a083*a101);
  a127=(a127+a123);
  a127=(a037+a127);
  a123=(a120*a127);
  a027=(a027+a123);
  a106=(a106+a027);
  a027=(a100*a106);
  a249=(a249+a027);
  a249=(a009+a249);
  a027=(a005*a249);
  a288=(a288+a027);
  a027=(a125*a218);
  a123=(a131*a003);
  a027=(a027+a123);
  a123=(a132*a106);
  a027=(a027+a123);
  a141=cos(a141);
  a123=(a139-a141);
  a123=(a007*a123);
  a128=(a007*a137);
  a138=(a138-a134);
  a138=(a134*a138);
  a128=(a128*a138);
  a143=(a143-a128);
  a143=(a143+a140);
  a128=(a152*a143);
  a128=(a128-a154);
  a154=(a148*a143);
  a149=(a149-a154);
  a154=(a153*a149);
  a128=(a128-a154);
  a128=(a128/a151);
  a154=(a128*a034);
  a154=(a154*a140);
  a123=(a123-a154);
  a123=(a123+a139);
  a154=(a123/a145);
  a126=(a007*a141);
  a108=(a148*a123);
  a126=(a126-a108);
  a108=(a126/a142);
  a123=(a152*a123);
  a143=(a143/a145);
  a149=(a149/a142);
  a113=(a153*a128);
  a149=(a149-a113);
  a113=(a148*a149);
  a143=(a143-a113);
  a128=(a152*a128);
  a143=(a143+a128);
  a128=(a143*a140);
  a139=(a139*a022);
  a139=(a139*a022);
  a128=(a128+a139);
  a128=(a034*a128);
  a123=(a123-a128);
  a126=(a153*a126);
  a123=(a123-a126);
  a123=(a123/a151);
  a126=(a153*a123);
  a108=(a108-a126);
  a126=(a148*a108);
  a154=(a154-a126);
  a126=(a152*a123);
  a154=(a154+a126);
  a126=(a006*a009);
  a128=(a030*a059);
  a126=(a126+a128);
  a128=(a100*a072);
  a126=(a126+a128);
  a126=(a071+a126);
  a128=(a154*a126);
  a149=(a149*a137);
  a139=(2.*a143);
  a139=(a139*a137);
  a149=(a149-a139);
  a149=(a149+a141);
  a138=(a144*a138);
  a149=(a149-a138);
  a149=(a007*a149);
  a138=(a149/a145);
  a143=(a143*a137);
  a143=(a143-a141);
  a144=(a144*a022);
  a144=(a144*a022);
  a143=(a143+a144);
  a143=(a007*a143);
  a143=(a143-a031);
  a144=(a148*a149);
  a143=(a143-a144);
  a144=(a143/a142);
  a149=(a152*a149);
  a143=(a153*a143);
  a149=(a149-a143);
  a149=(a149/a151);
  a143=(a153*a149);
  a144=(a144-a143);
  a143=(a148*a144);
  a138=(a138-a143);
  a143=(a152*a149);
  a138=(a138+a143);
  a143=(a006*a037);
  a141=(a030*a105);
  a143=(a143+a141);
  a141=(a100*a127);
  a143=(a143+a141);
  a143=(a016+a143);
  a141=(a138*a143);
  a128=(a128+a141);
  a141=(a040/a151);
  a139=(a153*a141);
  a113=(a148*a139);
  a038=(a152*a141);
  a113=(a113+a038);
  a038=(a006*a136);
  a115=(a030*a056);
  a038=(a038+a115);
  a115=(a103*a053);
  a269=(a050*a269);
  a115=(a115+a269);
  a036=(a023*a036);
  a096=(a102*a096);
  a036=(a036+a096);
  a049=(a076*a049);
  a036=(a036-a049);
  a049=(a298*a059);
  a096=(a089*a105);
  a049=(a049+a096);
  a036=(a036+a049);
  a049=(a083*a036);
  a115=(a115+a049);
  a115=(a136+a115);
  a049=(a100*a115);
  a038=(a038+a049);
  a038=(a161+a038);
  a049=(a113*a038);
  a128=(a128-a049);
  a049=(a033*a134);
  a049=(a049*a137);
  a096=(a049/a145);
  a269=(a017*a022);
  a269=(a269*a137);
  a086=(a148*a049);
  a269=(a269-a086);
  a086=(a269/a142);
  a084=(a135*a022);
  a084=(a084*a140);
  a049=(a152*a049);
  a084=(a084+a049);
  a269=(a153*a269);
  a084=(a084-a269);
  a084=(a084/a151);
  a269=(a153*a084);
  a086=(a086-a269);
  a269=(a148*a086);
  a096=(a096-a269);
  a269=(a152*a084);
  a096=(a096+a269);
  a269=(a096*a249);
  a137=(a017*a137);
  a134=(a134-a022);
  a137=(a137*a134);
  a145=(a137/a145);
  a134=(a148*a137);
  a134=(a015+a134);
  a142=(a134/a142);
  a137=(a152*a137);
  a134=(a153*a134);
  a137=(a137+a134);
  a137=(a137/a151);
  a153=(a153*a137);
  a142=(a142+a153);
  a148=(a148*a142);
  a145=(a145+a148);
  a152=(a152*a137);
  a145=(a145+a152);
  a152=(a006*a068);
  a148=(a030*a101);
  a152=(a152+a148);
  a148=(a043*a104);
  a153=(a119*a118);
  a148=(a148+a153);
  a153=(a114*a085);
  a148=(a148+a153);
  a153=(a074*a072);
  a151=(a117*a127);
  a153=(a153-a151);
  a148=(a148+a153);
  a153=(a100*a148);
  a152=(a152+a153);
  a152=(a037+a152);
  a153=(a145*a152);
  a269=(a269+a153);
  a128=(a128+a269);
  a269=(a133*a128);
  a027=(a027+a269);
  a027=(a009+a027);
  a269=(a122*a027);
  a288=(a288+a269);
  a269=(a150*a218);
  a153=(a087*a003);
  a269=(a269+a153);
  a153=(a157*a106);
  a269=(a269+a153);
  a153=(a158*a128);
  a269=(a269+a153);
  a167=cos(a167);
  a153=(a165-a167);
  a153=(a007*a153);
  a151=(a007*a163);
  a164=(a164-a160);
  a164=(a160*a164);
  a151=(a151*a164);
  a169=(a169-a151);
  a169=(a169+a166);
  a151=(a178*a169);
  a151=(a151-a180);
  a180=(a174*a169);
  a175=(a175-a180);
  a180=(a179*a175);
  a151=(a151-a180);
  a151=(a151/a177);
  a180=(a151*a034);
  a180=(a180*a166);
  a153=(a153-a180);
  a153=(a153+a165);
  a180=(a153/a171);
  a134=(a007*a167);
  a022=(a174*a153);
  a134=(a134-a022);
  a022=(a134/a168);
  a153=(a178*a153);
  a169=(a169/a171);
  a175=(a175/a168);
  a049=(a179*a151);
  a175=(a175-a049);
  a049=(a174*a175);
  a169=(a169-a049);
  a151=(a178*a151);
  a169=(a169+a151);
  a151=(a169*a166);
  a165=(a165*a130);
  a165=(a165*a130);
  a151=(a151+a165);
  a151=(a034*a151);
  a153=(a153-a151);
  a134=(a179*a134);
  a153=(a153-a134);
  a153=(a153/a177);
  a134=(a179*a153);
  a022=(a022-a134);
  a134=(a174*a022);
  a180=(a180-a134);
  a134=(a178*a153);
  a180=(a180+a134);
  a134=(a125*a009);
  a151=(a131*a059);
  a134=(a134+a151);
  a151=(a132*a072);
  a134=(a134+a151);
  a151=(a133*a249);
  a134=(a134+a151);
  a134=(a071+a134);
  a151=(a180*a134);
  a175=(a175*a163);
  a165=(2.*a169);
  a165=(a165*a163);
  a175=(a175-a165);
  a175=(a175+a167);
  a164=(a170*a164);
  a175=(a175-a164);
  a175=(a007*a175);
  a164=(a175/a171);
  a169=(a169*a163);
  a169=(a169-a167);
  a170=(a170*a130);
  a170=(a170*a130);
  a169=(a169+a170);
  a169=(a007*a169);
  a169=(a169-a031);
  a170=(a174*a175);
  a169=(a169-a170);
  a170=(a169/a168);
  a175=(a178*a175);
  a169=(a179*a169);
  a175=(a175-a169);
  a175=(a175/a177);
  a169=(a179*a175);
  a170=(a170-a169);
  a169=(a174*a170);
  a164=(a164-a169);
  a169=(a178*a175);
  a164=(a164+a169);
  a169=(a125*a037);
  a167=(a131*a105);
  a169=(a169+a167);
  a167=(a132*a127);
  a169=(a169+a167);
  a167=(a133*a152);
  a169=(a169+a167);
  a169=(a016+a169);
  a167=(a164*a169);
  a151=(a151+a167);
  a167=(a040/a177);
  a165=(a179*a167);
  a049=(a174*a165);
  a140=(a178*a167);
  a049=(a049+a140);
  a140=(a125*a136);
  a075=(a131*a056);
  a140=(a140+a075);
  a075=(a132*a115);
  a140=(a140+a075);
  a075=(a006*a053);
  a046=(a030*a036);
  a075=(a075+a046);
  a104=(a156*a104);
  a118=(a124*a118);
  a104=(a104+a118);
  a085=(a116*a085);
  a104=(a104-a085);
  a085=(a077*a072);
  a118=(a112*a127);
  a085=(a085+a118);
  a104=(a104+a085);
  a085=(a100*a104);
  a075=(a075+a085);
  a075=(a136+a075);
  a085=(a133*a075);
  a140=(a140+a085);
  a140=(a161+a140);
  a085=(a049*a140);
  a151=(a151-a085);
  a085=(a033*a160);
  a085=(a085*a163);
  a118=(a085/a171);
  a046=(a017*a130);
  a046=(a046*a163);
  a210=(a174*a085);
  a046=(a046-a210);
  a210=(a046/a168);
  a080=(a135*a130);
  a080=(a080*a166);
  a085=(a178*a085);
  a080=(a080+a085);
  a046=(a179*a046);
  a080=(a080-a046);
  a080=(a080/a177);
  a046=(a179*a080);
  a210=(a210-a046);
  a046=(a174*a210);
  a118=(a118-a046);
  a046=(a178*a080);
  a118=(a118+a046);
  a046=(a118*a027);
  a163=(a017*a163);
  a160=(a160-a130);
  a163=(a163*a160);
  a171=(a163/a171);
  a160=(a174*a163);
  a160=(a015+a160);
  a168=(a160/a168);
  a163=(a178*a163);
  a160=(a179*a160);
  a163=(a163+a160);
  a163=(a163/a177);
  a179=(a179*a163);
  a168=(a168+a179);
  a174=(a174*a168);
  a171=(a171+a174);
  a178=(a178*a163);
  a171=(a171+a178);
  a178=(a125*a068);
  a174=(a131*a101);
  a178=(a178+a174);
  a174=(a132*a148);
  a178=(a178+a174);
  a174=(a108*a126);
  a179=(a144*a143);
  a174=(a174+a179);
  a179=(a139*a038);
  a174=(a174+a179);
  a179=(a086*a249);
  a177=(a142*a152);
  a179=(a179-a177);
  a174=(a174+a179);
  a179=(a133*a174);
  a178=(a178+a179);
  a178=(a037+a178);
  a179=(a171*a178);
  a046=(a046+a179);
  a151=(a151+a046);
  a046=(a159*a151);
  a269=(a269+a046);
  a269=(a009+a269);
  a046=(a147*a269);
  a288=(a288+a046);
  a046=(a176*a218);
  a179=(a183*a003);
  a046=(a046+a179);
  a179=(a184*a106);
  a046=(a046+a179);
  a179=(a185*a128);
  a046=(a046+a179);
  a179=(a186*a151);
  a046=(a046+a179);
  a195=cos(a195);
  a179=(a193-a195);
  a179=(a007*a179);
  a177=(a007*a191);
  a192=(a192-a188);
  a192=(a188*a192);
  a177=(a177*a192);
  a197=(a197-a177);
  a197=(a197+a194);
  a177=(a206*a197);
  a177=(a177-a208);
  a208=(a202*a197);
  a203=(a203-a208);
  a208=(a207*a203);
  a177=(a177-a208);
  a177=(a177/a205);
  a208=(a177*a034);
  a208=(a208*a194);
  a179=(a179-a208);
  a179=(a179+a193);
  a208=(a179/a199);
  a160=(a007*a195);
  a130=(a202*a179);
  a160=(a160-a130);
  a130=(a160/a196);
  a179=(a206*a179);
  a197=(a197/a199);
  a203=(a203/a196);
  a085=(a207*a177);
  a203=(a203-a085);
  a085=(a202*a203);
  a197=(a197-a085);
  a177=(a206*a177);
  a197=(a197+a177);
  a177=(a197*a194);
  a193=(a193*a155);
  a193=(a193*a155);
  a177=(a177+a193);
  a177=(a034*a177);
  a179=(a179-a177);
  a160=(a207*a160);
  a179=(a179-a160);
  a179=(a179/a205);
  a160=(a207*a179);
  a130=(a130-a160);
  a160=(a202*a130);
  a208=(a208-a160);
  a160=(a206*a179);
  a208=(a208+a160);
  a160=(a150*a009);
  a177=(a087*a059);
  a160=(a160+a177);
  a177=(a157*a072);
  a160=(a160+a177);
  a177=(a158*a249);
  a160=(a160+a177);
  a177=(a159*a027);
  a160=(a160+a177);
  a160=(a071+a160);
  a177=(a208*a160);
  a203=(a203*a191);
  a193=(2.*a197);
  a193=(a193*a191);
  a203=(a203-a193);
  a203=(a203+a195);
  a192=(a198*a192);
  a203=(a203-a192);
  a203=(a007*a203);
  a192=(a203/a199);
  a197=(a197*a191);
  a197=(a197-a195);
  a198=(a198*a155);
  a198=(a198*a155);
  a197=(a197+a198);
  a197=(a007*a197);
  a197=(a197-a031);
  a198=(a202*a203);
  a197=(a197-a198);
  a198=(a197/a196);
  a203=(a206*a203);
  a197=(a207*a197);
  a203=(a203-a197);
  a203=(a203/a205);
  a197=(a207*a203);
  a198=(a198-a197);
  a197=(a202*a198);
  a192=(a192-a197);
  a197=(a206*a203);
  a192=(a192+a197);
  a197=(a150*a037);
  a195=(a087*a105);
  a197=(a197+a195);
  a195=(a157*a127);
  a197=(a197+a195);
  a195=(a158*a152);
  a197=(a197+a195);
  a195=(a159*a178);
  a197=(a197+a195);
  a197=(a016+a197);
  a195=(a192*a197);
  a177=(a177+a195);
  a195=(a040/a205);
  a193=(a207*a195);
  a085=(a202*a193);
  a166=(a206*a195);
  a085=(a085+a166);
  a166=(a150*a136);
  a300=(a087*a056);
  a166=(a166+a300);
  a300=(a157*a115);
  a166=(a166+a300);
  a300=(a158*a075);
  a166=(a166+a300);
  a300=(a125*a053);
  a301=(a131*a036);
  a300=(a300+a301);
  a301=(a132*a104);
  a300=(a300+a301);
  a126=(a123*a126);
  a143=(a149*a143);
  a126=(a126+a143);
  a038=(a141*a038);
  a126=(a126-a038);
  a038=(a084*a249);
  a143=(a137*a152);
  a038=(a038+a143);
  a126=(a126+a038);
  a038=(a133*a126);
  a300=(a300+a038);
  a300=(a136+a300);
  a038=(a159*a300);
  a166=(a166+a038);
  a166=(a161+a166);
  a038=(a085*a166);
  a177=(a177-a038);
  a038=(a033*a188);
  a038=(a038*a191);
  a143=(a038/a199);
  a301=(a017*a155);
  a301=(a301*a191);
  a302=(a202*a038);
  a301=(a301-a302);
  a302=(a301/a196);
  a303=(a135*a155);
  a303=(a303*a194);
  a038=(a206*a038);
  a303=(a303+a038);
  a301=(a207*a301);
  a303=(a303-a301);
  a303=(a303/a205);
  a301=(a207*a303);
  a302=(a302-a301);
  a301=(a202*a302);
  a143=(a143-a301);
  a301=(a206*a303);
  a143=(a143+a301);
  a301=(a143*a269);
  a191=(a017*a191);
  a188=(a188-a155);
  a191=(a191*a188);
  a199=(a191/a199);
  a188=(a202*a191);
  a188=(a015+a188);
  a196=(a188/a196);
  a191=(a206*a191);
  a188=(a207*a188);
  a191=(a191+a188);
  a191=(a191/a205);
  a207=(a207*a191);
  a196=(a196+a207);
  a202=(a202*a196);
  a199=(a199+a202);
  a206=(a206*a191);
  a199=(a199+a206);
  a206=(a150*a068);
  a202=(a087*a101);
  a206=(a206+a202);
  a202=(a157*a148);
  a206=(a206+a202);
  a202=(a158*a174);
  a206=(a206+a202);
  a202=(a022*a134);
  a207=(a170*a169);
  a202=(a202+a207);
  a207=(a165*a140);
  a202=(a202+a207);
  a207=(a210*a027);
  a205=(a168*a178);
  a207=(a207-a205);
  a202=(a202+a207);
  a207=(a159*a202);
  a206=(a206+a207);
  a206=(a037+a206);
  a207=(a199*a206);
  a301=(a301+a207);
  a177=(a177+a301);
  a301=(a187*a177);
  a046=(a046+a301);
  a046=(a009+a046);
  a301=(a173*a046);
  a288=(a288+a301);
  a301=(a204*a218);
  a207=(a211*a003);
  a301=(a301+a207);
  a207=(a212*a106);
  a301=(a301+a207);
  a207=(a213*a128);
  a301=(a301+a207);
  a207=(a214*a151);
  a301=(a301+a207);
  a207=(a215*a177);
  a301=(a301+a207);
  a224=cos(a224);
  a207=(a222-a224);
  a207=(a007*a207);
  a205=(a007*a220);
  a221=(a221-a217);
  a221=(a217*a221);
  a205=(a205*a221);
  a226=(a226-a205);
  a226=(a226+a223);
  a205=(a235*a226);
  a205=(a205-a237);
  a237=(a231*a226);
  a232=(a232-a237);
  a237=(a236*a232);
  a205=(a205-a237);
  a205=(a205/a234);
  a237=(a205*a034);
  a237=(a237*a223);
  a207=(a207-a237);
  a207=(a207+a222);
  a237=(a207/a228);
  a188=(a007*a224);
  a155=(a231*a207);
  a188=(a188-a155);
  a155=(a188/a225);
  a207=(a235*a207);
  a226=(a226/a228);
  a232=(a232/a225);
  a038=(a236*a205);
  a232=(a232-a038);
  a038=(a231*a232);
  a226=(a226-a038);
  a205=(a235*a205);
  a226=(a226+a205);
  a205=(a226*a223);
  a222=(a222*a181);
  a222=(a222*a181);
  a205=(a205+a222);
  a205=(a034*a205);
  a207=(a207-a205);
  a188=(a236*a188);
  a207=(a207-a188);
  a207=(a207/a234);
  a188=(a236*a207);
  a155=(a155-a188);
  a188=(a231*a155);
  a237=(a237-a188);
  a188=(a235*a207);
  a237=(a237+a188);
  a188=(a176*a009);
  a205=(a183*a059);
  a188=(a188+a205);
  a205=(a184*a072);
  a188=(a188+a205);
  a205=(a185*a249);
  a188=(a188+a205);
  a205=(a186*a027);
  a188=(a188+a205);
  a205=(a187*a269);
  a188=(a188+a205);
  a188=(a071+a188);
  a205=(a237*a188);
  a232=(a232*a220);
  a222=(2.*a226);
  a222=(a222*a220);
  a232=(a232-a222);
  a232=(a232+a224);
  a221=(a227*a221);
  a232=(a232-a221);
  a232=(a007*a232);
  a221=(a232/a228);
  a226=(a226*a220);
  a226=(a226-a224);
  a227=(a227*a181);
  a227=(a227*a181);
  a226=(a226+a227);
  a226=(a007*a226);
  a226=(a226-a031);
  a227=(a231*a232);
  a226=(a226-a227);
  a227=(a226/a225);
  a232=(a235*a232);
  a226=(a236*a226);
  a232=(a232-a226);
  a232=(a232/a234);
  a226=(a236*a232);
  a227=(a227-a226);
  a226=(a231*a227);
  a221=(a221-a226);
  a226=(a235*a232);
  a221=(a221+a226);
  a226=(a176*a037);
  a224=(a183*a105);
  a226=(a226+a224);
  a224=(a184*a127);
  a226=(a226+a224);
  a224=(a185*a152);
  a226=(a226+a224);
  a224=(a186*a178);
  a226=(a226+a224);
  a224=(a187*a206);
  a226=(a226+a224);
  a226=(a016+a226);
  a224=(a221*a226);
  a205=(a205+a224);
  a224=(a040/a234);
  a222=(a236*a224);
  a038=(a231*a222);
  a194=(a235*a224);
  a038=(a038+a194);
  a194=(a176*a136);
  a304=(a183*a056);
  a194=(a194+a304);
  a304=(a184*a115);
  a194=(a194+a304);
  a304=(a185*a075);
  a194=(a194+a304);
  a304=(a186*a300);
  a194=(a194+a304);
  a304=(a150*a053);
  a305=(a087*a036);
  a304=(a304+a305);
  a305=(a157*a104);
  a304=(a304+a305);
  a305=(a158*a126);
  a304=(a304+a305);
  a134=(a153*a134);
  a169=(a175*a169);
  a134=(a134+a169);
  a140=(a167*a140);
  a134=(a134-a140);
  a140=(a080*a027);
  a169=(a163*a178);
  a140=(a140+a169);
  a134=(a134+a140);
  a140=(a159*a134);
  a304=(a304+a140);
  a304=(a136+a304);
  a140=(a187*a304);
  a194=(a194+a140);
  a194=(a161+a194);
  a140=(a038*a194);
  a205=(a205-a140);
  a140=(a033*a217);
  a140=(a140*a220);
  a169=(a140/a228);
  a305=(a017*a181);
  a305=(a305*a220);
  a306=(a231*a140);
  a305=(a305-a306);
  a306=(a305/a225);
  a307=(a135*a181);
  a307=(a307*a223);
  a140=(a235*a140);
  a307=(a307+a140);
  a305=(a236*a305);
  a307=(a307-a305);
  a307=(a307/a234);
  a305=(a236*a307);
  a306=(a306-a305);
  a305=(a231*a306);
  a169=(a169-a305);
  a305=(a235*a307);
  a169=(a169+a305);
  a305=(a169*a046);
  a220=(a017*a220);
  a217=(a217-a181);
  a220=(a220*a217);
  a228=(a220/a228);
  a217=(a231*a220);
  a217=(a015+a217);
  a225=(a217/a225);
  a220=(a235*a220);
  a217=(a236*a217);
  a220=(a220+a217);
  a220=(a220/a234);
  a236=(a236*a220);
  a225=(a225+a236);
  a231=(a231*a225);
  a228=(a228+a231);
  a235=(a235*a220);
  a228=(a228+a235);
  a235=(a176*a068);
  a231=(a183*a101);
  a235=(a235+a231);
  a231=(a184*a148);
  a235=(a235+a231);
  a231=(a185*a174);
  a235=(a235+a231);
  a231=(a186*a202);
  a235=(a235+a231);
  a231=(a130*a160);
  a236=(a198*a197);
  a231=(a231+a236);
  a236=(a193*a166);
  a231=(a231+a236);
  a236=(a302*a269);
  a234=(a196*a206);
  a236=(a236-a234);
  a231=(a231+a236);
  a236=(a187*a231);
  a235=(a235+a236);
  a235=(a037+a235);
  a236=(a228*a235);
  a305=(a305+a236);
  a205=(a205+a305);
  a305=(a216*a205);
  a301=(a301+a305);
  a301=(a009+a301);
  a305=(a201*a301);
  a288=(a288+a305);
  a305=(a233*a218);
  a236=(a240*a003);
  a305=(a305+a236);
  a236=(a241*a106);
  a305=(a305+a236);
  a236=(a242*a128);
  a305=(a305+a236);
  a236=(a243*a151);
  a305=(a305+a236);
  a236=(a244*a177);
  a305=(a305+a236);
  a236=(a245*a205);
  a305=(a305+a236);
  a254=cos(a254);
  a236=(a252-a254);
  a236=(a007*a236);
  a234=(a007*a250);
  a251=(a251-a247);
  a251=(a247*a251);
  a234=(a234*a251);
  a256=(a256-a234);
  a256=(a256+a253);
  a234=(a265*a256);
  a234=(a234-a267);
  a267=(a261*a256);
  a262=(a262-a267);
  a267=(a266*a262);
  a234=(a234-a267);
  a234=(a234/a264);
  a267=(a234*a034);
  a267=(a267*a253);
  a236=(a236-a267);
  a236=(a236+a252);
  a267=(a236/a258);
  a217=(a007*a254);
  a181=(a261*a236);
  a217=(a217-a181);
  a181=(a217/a255);
  a236=(a265*a236);
  a256=(a256/a258);
  a262=(a262/a255);
  a140=(a266*a234);
  a262=(a262-a140);
  a140=(a261*a262);
  a256=(a256-a140);
  a234=(a265*a234);
  a256=(a256+a234);
  a234=(a256*a253);
  a252=(a252*a209);
  a252=(a252*a209);
  a234=(a234+a252);
  a234=(a034*a234);
  a236=(a236-a234);
  a217=(a266*a217);
  a236=(a236-a217);
  a236=(a236/a264);
  a217=(a266*a236);
  a181=(a181-a217);
  a217=(a261*a181);
  a267=(a267-a217);
  a217=(a265*a236);
  a267=(a267+a217);
  a217=(a204*a009);
  a234=(a211*a059);
  a217=(a217+a234);
  a234=(a212*a072);
  a217=(a217+a234);
  a234=(a213*a249);
  a217=(a217+a234);
  a234=(a214*a027);
  a217=(a217+a234);
  a234=(a215*a269);
  a217=(a217+a234);
  a234=(a216*a046);
  a217=(a217+a234);
  a217=(a071+a217);
  a234=(a267*a217);
  a262=(a262*a250);
  a252=(2.*a256);
  a252=(a252*a250);
  a262=(a262-a252);
  a262=(a262+a254);
  a251=(a257*a251);
  a262=(a262-a251);
  a262=(a007*a262);
  a251=(a262/a258);
  a256=(a256*a250);
  a256=(a256-a254);
  a257=(a257*a209);
  a257=(a257*a209);
  a256=(a256+a257);
  a256=(a007*a256);
  a256=(a256-a031);
  a257=(a261*a262);
  a256=(a256-a257);
  a257=(a256/a255);
  a262=(a265*a262);
  a256=(a266*a256);
  a262=(a262-a256);
  a262=(a262/a264);
  a256=(a266*a262);
  a257=(a257-a256);
  a256=(a261*a257);
  a251=(a251-a256);
  a256=(a265*a262);
  a251=(a251+a256);
  a256=(a204*a037);
  a254=(a211*a105);
  a256=(a256+a254);
  a254=(a212*a127);
  a256=(a256+a254);
  a254=(a213*a152);
  a256=(a256+a254);
  a254=(a214*a178);
  a256=(a256+a254);
  a254=(a215*a206);
  a256=(a256+a254);
  a254=(a216*a235);
  a256=(a256+a254);
  a256=(a016+a256);
  a254=(a251*a256);
  a234=(a234+a254);
  a254=(a040/a264);
  a252=(a266*a254);
  a140=(a261*a252);
  a223=(a265*a254);
  a140=(a140+a223);
  a223=(a204*a136);
  a308=(a211*a056);
  a223=(a223+a308);
  a308=(a212*a115);
  a223=(a223+a308);
  a308=(a213*a075);
  a223=(a223+a308);
  a308=(a214*a300);
  a223=(a223+a308);
  a308=(a215*a304);
  a223=(a223+a308);
  a308=(a176*a053);
  a309=(a183*a036);
  a308=(a308+a309);
  a309=(a184*a104);
  a308=(a308+a309);
  a309=(a185*a126);
  a308=(a308+a309);
  a309=(a186*a134);
  a308=(a308+a309);
  a160=(a179*a160);
  a197=(a203*a197);
  a160=(a160+a197);
  a166=(a195*a166);
  a160=(a160-a166);
  a166=(a303*a269);
  a197=(a191*a206);
  a166=(a166+a197);
  a160=(a160+a166);
  a166=(a187*a160);
  a308=(a308+a166);
  a308=(a136+a308);
  a166=(a216*a308);
  a223=(a223+a166);
  a223=(a161+a223);
  a166=(a140*a223);
  a234=(a234-a166);
  a166=(a033*a247);
  a166=(a166*a250);
  a197=(a166/a258);
  a309=(a017*a209);
  a309=(a309*a250);
  a310=(a261*a166);
  a309=(a309-a310);
  a310=(a309/a255);
  a311=(a135*a209);
  a311=(a311*a253);
  a166=(a265*a166);
  a311=(a311+a166);
  a309=(a266*a309);
  a311=(a311-a309);
  a311=(a311/a264);
  a309=(a266*a311);
  a310=(a310-a309);
  a309=(a261*a310);
  a197=(a197-a309);
  a309=(a265*a311);
  a197=(a197+a309);
  a309=(a197*a301);
  a250=(a017*a250);
  a247=(a247-a209);
  a250=(a250*a247);
  a258=(a250/a258);
  a247=(a261*a250);
  a247=(a015+a247);
  a255=(a247/a255);
  a250=(a265*a250);
  a247=(a266*a247);
  a250=(a250+a247);
  a250=(a250/a264);
  a266=(a266*a250);
  a255=(a255+a266);
  a261=(a261*a255);
  a258=(a258+a261);
  a265=(a265*a250);
  a258=(a258+a265);
  a265=(a204*a068);
  a261=(a211*a101);
  a265=(a265+a261);
  a261=(a212*a148);
  a265=(a265+a261);
  a261=(a213*a174);
  a265=(a265+a261);
  a261=(a214*a202);
  a265=(a265+a261);
  a261=(a215*a231);
  a265=(a265+a261);
  a261=(a155*a188);
  a266=(a227*a226);
  a261=(a261+a266);
  a266=(a222*a194);
  a261=(a261+a266);
  a266=(a306*a046);
  a264=(a225*a235);
  a266=(a266-a264);
  a261=(a261+a266);
  a266=(a216*a261);
  a265=(a265+a266);
  a265=(a037+a265);
  a266=(a258*a265);
  a309=(a309+a266);
  a234=(a234+a309);
  a309=(a246*a234);
  a305=(a305+a309);
  a305=(a009+a305);
  a309=(a230*a305);
  a288=(a288+a309);
  a309=(a263*a218);
  a003=(a270*a003);
  a309=(a309+a003);
  a106=(a099*a106);
  a309=(a309+a106);
  a106=(a121*a128);
  a309=(a309+a106);
  a106=(a271*a151);
  a309=(a309+a106);
  a106=(a272*a177);
  a309=(a309+a106);
  a106=(a273*a205);
  a309=(a309+a106);
  a106=(a274*a234);
  a309=(a309+a106);
  a283=cos(a283);
  a106=(a281-a283);
  a106=(a007*a106);
  a003=(a007*a279);
  a280=(a280-a276);
  a280=(a276*a280);
  a003=(a003*a280);
  a285=(a285-a003);
  a285=(a285+a282);
  a003=(a294*a285);
  a003=(a003-a296);
  a296=(a290*a285);
  a291=(a291-a296);
  a296=(a295*a291);
  a003=(a003-a296);
  a003=(a003/a293);
  a296=(a003*a034);
  a296=(a296*a282);
  a106=(a106-a296);
  a106=(a106+a281);
  a296=(a106/a287);
  a266=(a007*a283);
  a264=(a290*a106);
  a266=(a266-a264);
  a264=(a266/a284);
  a106=(a294*a106);
  a285=(a285/a287);
  a291=(a291/a284);
  a247=(a295*a003);
  a291=(a291-a247);
  a247=(a290*a291);
  a285=(a285-a247);
  a003=(a294*a003);
  a285=(a285+a003);
  a003=(a285*a282);
  a281=(a281*a238);
  a281=(a281*a238);
  a003=(a003+a281);
  a003=(a034*a003);
  a106=(a106-a003);
  a266=(a295*a266);
  a106=(a106-a266);
  a106=(a106/a293);
  a266=(a295*a106);
  a264=(a264-a266);
  a266=(a290*a264);
  a296=(a296-a266);
  a266=(a294*a106);
  a296=(a296+a266);
  a266=(a233*a009);
  a003=(a240*a059);
  a266=(a266+a003);
  a003=(a241*a072);
  a266=(a266+a003);
  a003=(a242*a249);
  a266=(a266+a003);
  a003=(a243*a027);
  a266=(a266+a003);
  a003=(a244*a269);
  a266=(a266+a003);
  a003=(a245*a046);
  a266=(a266+a003);
  a003=(a246*a301);
  a266=(a266+a003);
  a266=(a071+a266);
  a003=(a296*a266);
  a291=(a291*a279);
  a281=(2.*a285);
  a281=(a281*a279);
  a291=(a291-a281);
  a291=(a291+a283);
  a280=(a286*a280);
  a291=(a291-a280);
  a291=(a007*a291);
  a280=(a291/a287);
  a285=(a285*a279);
  a285=(a285-a283);
  a286=(a286*a238);
  a286=(a286*a238);
  a285=(a285+a286);
  a285=(a007*a285);
  a285=(a285-a031);
  a286=(a290*a291);
  a285=(a285-a286);
  a286=(a285/a284);
  a291=(a294*a291);
  a285=(a295*a285);
  a291=(a291-a285);
  a291=(a291/a293);
  a285=(a295*a291);
  a286=(a286-a285);
  a285=(a290*a286);
  a280=(a280-a285);
  a285=(a294*a291);
  a280=(a280+a285);
  a285=(a233*a037);
  a283=(a240*a105);
  a285=(a285+a283);
  a283=(a241*a127);
  a285=(a285+a283);
  a283=(a242*a152);
  a285=(a285+a283);
  a283=(a243*a178);
  a285=(a285+a283);
  a283=(a244*a206);
  a285=(a285+a283);
  a283=(a245*a235);
  a285=(a285+a283);
  a283=(a246*a265);
  a285=(a285+a283);
  a285=(a016+a285);
  a283=(a280*a285);
  a003=(a003+a283);
  a283=(a040/a293);
  a281=(a295*a283);
  a247=(a290*a281);
  a209=(a294*a283);
  a247=(a247+a209);
  a209=(a233*a136);
  a166=(a240*a056);
  a209=(a209+a166);
  a166=(a241*a115);
  a209=(a209+a166);
  a166=(a242*a075);
  a209=(a209+a166);
  a166=(a243*a300);
  a209=(a209+a166);
  a166=(a244*a304);
  a209=(a209+a166);
  a166=(a245*a308);
  a209=(a209+a166);
  a166=(a204*a053);
  a253=(a211*a036);
  a166=(a166+a253);
  a253=(a212*a104);
  a166=(a166+a253);
  a253=(a213*a126);
  a166=(a166+a253);
  a253=(a214*a134);
  a166=(a166+a253);
  a253=(a215*a160);
  a166=(a166+a253);
  a188=(a207*a188);
  a226=(a232*a226);
  a188=(a188+a226);
  a194=(a224*a194);
  a188=(a188-a194);
  a194=(a307*a046);
  a226=(a220*a235);
  a194=(a194+a226);
  a188=(a188+a194);
  a194=(a216*a188);
  a166=(a166+a194);
  a166=(a136+a166);
  a194=(a246*a166);
  a209=(a209+a194);
  a209=(a161+a209);
  a194=(a247*a209);
  a003=(a003-a194);
  a194=(a033*a276);
  a194=(a194*a279);
  a226=(a194/a287);
  a253=(a017*a238);
  a253=(a253*a279);
  a312=(a290*a194);
  a253=(a253-a312);
  a312=(a253/a284);
  a313=(a135*a238);
  a313=(a313*a282);
  a194=(a294*a194);
  a313=(a313+a194);
  a253=(a295*a253);
  a313=(a313-a253);
  a313=(a313/a293);
  a253=(a295*a313);
  a312=(a312-a253);
  a253=(a290*a312);
  a226=(a226-a253);
  a253=(a294*a313);
  a226=(a226+a253);
  a253=(a226*a305);
  a279=(a017*a279);
  a276=(a276-a238);
  a279=(a279*a276);
  a287=(a279/a287);
  a276=(a290*a279);
  a276=(a015+a276);
  a284=(a276/a284);
  a279=(a294*a279);
  a276=(a295*a276);
  a279=(a279+a276);
  a279=(a279/a293);
  a295=(a295*a279);
  a284=(a284+a295);
  a290=(a290*a284);
  a287=(a287+a290);
  a294=(a294*a279);
  a287=(a287+a294);
  a294=(a233*a068);
  a290=(a240*a101);
  a294=(a294+a290);
  a290=(a241*a148);
  a294=(a294+a290);
  a290=(a242*a174);
  a294=(a294+a290);
  a290=(a243*a202);
  a294=(a294+a290);
  a290=(a244*a231);
  a294=(a294+a290);
  a290=(a245*a261);
  a294=(a294+a290);
  a290=(a181*a217);
  a295=(a257*a256);
  a290=(a290+a295);
  a295=(a252*a223);
  a290=(a290+a295);
  a295=(a310*a301);
  a293=(a255*a265);
  a295=(a295-a293);
  a290=(a290+a295);
  a295=(a246*a290);
  a294=(a294+a295);
  a294=(a037+a294);
  a295=(a287*a294);
  a253=(a253+a295);
  a003=(a003+a253);
  a253=(a275*a003);
  a309=(a309+a253);
  a309=(a009+a309);
  a253=(a260*a309);
  a288=(a288+a253);
  a288=(a071+a288);
  if (res[0]!=0) res[0][6]=a288;
  a288=(a001*a037);
  a253=(a005*a152);
  a288=(a288+a253);
  a253=(a122*a178);
  a288=(a288+a253);
  a253=(a147*a206);
  a288=(a288+a253);
  a253=(a173*a235);
  a288=(a288+a253);
  a253=(a201*a265);
  a288=(a288+a253);
  a253=(a230*a294);
  a288=(a288+a253);
  a253=(a263*a068);
  a101=(a270*a101);
  a253=(a253+a101);
  a148=(a099*a148);
  a253=(a253+a148);
  a148=(a121*a174);
  a253=(a253+a148);
  a148=(a271*a202);
  a253=(a253+a148);
  a148=(a272*a231);
  a253=(a253+a148);
  a148=(a273*a261);
  a253=(a253+a148);
  a148=(a274*a290);
  a253=(a253+a148);
  a148=(a264*a266);
  a101=(a286*a285);
  a148=(a148+a101);
  a101=(a281*a209);
  a148=(a148+a101);
  a101=(a312*a305);
  a295=(a284*a294);
  a101=(a101-a295);
  a148=(a148+a101);
  a101=(a275*a148);
  a253=(a253+a101);
  a253=(a037+a253);
  a101=(a260*a253);
  a288=(a288+a101);
  a288=(a016+a288);
  if (res[0]!=0) res[0][7]=a288;
  a288=(a001*a136);
  a101=(a005*a075);
  a288=(a288+a101);
  a101=(a122*a300);
  a288=(a288+a101);
  a101=(a147*a304);
  a288=(a288+a101);
  a101=(a173*a308);
  a288=(a288+a101);
  a101=(a201*a166);
  a288=(a288+a101);
  a101=(a233*a053);
  a295=(a240*a036);
  a101=(a101+a295);
  a295=(a241*a104);
  a101=(a101+a295);
  a295=(a242*a126);
  a101=(a101+a295);
  a295=(a243*a134);
  a101=(a101+a295);
  a295=(a244*a160);
  a101=(a101+a295);
  a295=(a245*a188);
  a101=(a101+a295);
  a217=(a236*a217);
  a256=(a262*a256);
  a217=(a217+a256);
  a223=(a254*a223);
  a217=(a217-a223);
  a223=(a311*a301);
  a256=(a250*a265);
  a223=(a223+a256);
  a217=(a217+a223);
  a223=(a246*a217);
  a101=(a101+a223);
  a101=(a136+a101);
  a223=(a230*a101);
  a288=(a288+a223);
  a223=(a263*a053);
  a036=(a270*a036);
  a223=(a223+a036);
  a104=(a099*a104);
  a223=(a223+a104);
  a104=(a121*a126);
  a223=(a223+a104);
  a104=(a271*a134);
  a223=(a223+a104);
  a104=(a272*a160);
  a223=(a223+a104);
  a104=(a273*a188);
  a223=(a223+a104);
  a104=(a274*a217);
  a223=(a223+a104);
  a266=(a106*a266);
  a285=(a291*a285);
  a266=(a266+a285);
  a209=(a283*a209);
  a266=(a266-a209);
  a209=(a313*a305);
  a285=(a279*a294);
  a209=(a209+a285);
  a266=(a266+a209);
  a209=(a275*a266);
  a223=(a223+a209);
  a223=(a136+a223);
  a223=(a260*a223);
  a288=(a288+a223);
  a288=(a161+a288);
  if (res[0]!=0) res[0][8]=a288;
  a218=(a001*a218);
  a128=(a005*a128);
  a218=(a218+a128);
  a151=(a122*a151);
  a218=(a218+a151);
  a177=(a147*a177);
  a218=(a218+a177);
  a205=(a173*a205);
  a218=(a218+a205);
  a234=(a201*a234);
  a218=(a218+a234);
  a003=(a230*a003);
  a218=(a218+a003);
  a172=cos(a172);
  a003=(a000-a172);
  a003=(a007*a003);
  a234=(a007*a259);
  a229=(a229-a289);
  a229=(a289*a229);
  a234=(a234*a229);
  a004=(a004-a234);
  a004=(a004+a200);
  a234=(a026*a004);
  a234=(a234-a028);
  a028=(a297*a004);
  a299=(a299-a028);
  a028=(a018*a299);
  a234=(a234-a028);
  a234=(a234/a025);
  a028=(a234*a034);
  a028=(a028*a200);
  a003=(a003-a028);
  a003=(a003+a000);
  a028=(a003/a110);
  a205=(a007*a172);
  a177=(a297*a003);
  a205=(a205-a177);
  a177=(a205/a032);
  a003=(a026*a003);
  a004=(a004/a110);
  a299=(a299/a032);
  a151=(a018*a234);
  a299=(a299-a151);
  a151=(a297*a299);
  a004=(a004-a151);
  a234=(a026*a234);
  a004=(a004+a234);
  a234=(a004*a200);
  a000=(a000*a268);
  a000=(a000*a268);
  a234=(a234+a000);
  a034=(a034*a234);
  a003=(a003-a034);
  a205=(a018*a205);
  a003=(a003-a205);
  a003=(a003/a025);
  a205=(a018*a003);
  a177=(a177-a205);
  a205=(a297*a177);
  a028=(a028-a205);
  a205=(a026*a003);
  a028=(a028+a205);
  a205=(a263*a009);
  a059=(a270*a059);
  a205=(a205+a059);
  a072=(a099*a072);
  a205=(a205+a072);
  a249=(a121*a249);
  a205=(a205+a249);
  a027=(a271*a027);
  a205=(a205+a027);
  a269=(a272*a269);
  a205=(a205+a269);
  a046=(a273*a046);
  a205=(a205+a046);
  a301=(a274*a301);
  a205=(a205+a301);
  a305=(a275*a305);
  a205=(a205+a305);
  a071=(a071+a205);
  a205=(a028*a071);
  a299=(a299*a259);
  a305=(2.*a004);
  a305=(a305*a259);
  a299=(a299-a305);
  a299=(a299+a172);
  a229=(a081*a229);
  a299=(a299-a229);
  a299=(a007*a299);
  a229=(a299/a110);
  a004=(a004*a259);
  a004=(a004-a172);
  a081=(a081*a268);
  a081=(a081*a268);
  a004=(a004+a081);
  a007=(a007*a004);
  a007=(a007-a031);
  a031=(a297*a299);
  a007=(a007-a031);
  a031=(a007/a032);
  a299=(a026*a299);
  a007=(a018*a007);
  a299=(a299-a007);
  a299=(a299/a025);
  a007=(a018*a299);
  a031=(a031-a007);
  a007=(a297*a031);
  a229=(a229-a007);
  a007=(a026*a299);
  a229=(a229+a007);
  a007=(a263*a037);
  a105=(a270*a105);
  a007=(a007+a105);
  a127=(a099*a127);
  a007=(a007+a127);
  a152=(a121*a152);
  a007=(a007+a152);
  a178=(a271*a178);
  a007=(a007+a178);
  a206=(a272*a206);
  a007=(a007+a206);
  a235=(a273*a235);
  a007=(a007+a235);
  a265=(a274*a265);
  a007=(a007+a265);
  a294=(a275*a294);
  a007=(a007+a294);
  a016=(a016+a007);
  a007=(a229*a016);
  a205=(a205+a007);
  a040=(a040/a025);
  a007=(a018*a040);
  a294=(a297*a007);
  a265=(a026*a040);
  a294=(a294+a265);
  a265=(a263*a136);
  a056=(a270*a056);
  a265=(a265+a056);
  a115=(a099*a115);
  a265=(a265+a115);
  a075=(a121*a075);
  a265=(a265+a075);
  a300=(a271*a300);
  a265=(a265+a300);
  a304=(a272*a304);
  a265=(a265+a304);
  a308=(a273*a308);
  a265=(a265+a308);
  a166=(a274*a166);
  a265=(a265+a166);
  a101=(a275*a101);
  a265=(a265+a101);
  a161=(a161+a265);
  a265=(a294*a161);
  a205=(a205-a265);
  a033=(a033*a289);
  a033=(a033*a259);
  a265=(a033/a110);
  a101=(a017*a268);
  a101=(a101*a259);
  a166=(a297*a033);
  a101=(a101-a166);
  a166=(a101/a032);
  a135=(a135*a268);
  a135=(a135*a200);
  a033=(a026*a033);
  a135=(a135+a033);
  a101=(a018*a101);
  a135=(a135-a101);
  a135=(a135/a025);
  a101=(a018*a135);
  a166=(a166-a101);
  a101=(a297*a166);
  a265=(a265-a101);
  a101=(a026*a135);
  a265=(a265+a101);
  a101=(a265*a309);
  a017=(a017*a259);
  a289=(a289-a268);
  a017=(a017*a289);
  a110=(a017/a110);
  a289=(a297*a017);
  a015=(a015+a289);
  a032=(a015/a032);
  a017=(a026*a017);
  a015=(a018*a015);
  a017=(a017+a015);
  a017=(a017/a025);
  a018=(a018*a017);
  a032=(a032+a018);
  a297=(a297*a032);
  a110=(a110+a297);
  a026=(a026*a017);
  a110=(a110+a026);
  a026=(a110*a253);
  a101=(a101+a026);
  a205=(a205+a101);
  a205=(a260*a205);
  a218=(a218+a205);
  a009=(a009+a218);
  if (res[0]!=0) res[0][9]=a009;
  a068=(a001*a068);
  a174=(a005*a174);
  a068=(a068+a174);
  a202=(a122*a202);
  a068=(a068+a202);
  a231=(a147*a231);
  a068=(a068+a231);
  a261=(a173*a261);
  a068=(a068+a261);
  a290=(a201*a290);
  a068=(a068+a290);
  a148=(a230*a148);
  a068=(a068+a148);
  a148=(a177*a071);
  a290=(a031*a016);
  a148=(a148+a290);
  a290=(a007*a161);
  a148=(a148+a290);
  a290=(a166*a309);
  a261=(a032*a253);
  a290=(a290-a261);
  a148=(a148+a290);
  a148=(a260*a148);
  a068=(a068+a148);
  a037=(a037+a068);
  if (res[0]!=0) res[0][10]=a037;
  a053=(a001*a053);
  a126=(a005*a126);
  a053=(a053+a126);
  a134=(a122*a134);
  a053=(a053+a134);
  a160=(a147*a160);
  a053=(a053+a160);
  a188=(a173*a188);
  a053=(a053+a188);
  a217=(a201*a217);
  a053=(a053+a217);
  a266=(a230*a266);
  a053=(a053+a266);
  a071=(a003*a071);
  a016=(a299*a016);
  a071=(a071+a016);
  a161=(a040*a161);
  a071=(a071-a161);
  a309=(a135*a309);
  a253=(a017*a253);
  a309=(a309+a253);
  a071=(a071+a309);
  a071=(a260*a071);
  a053=(a053+a071);
  a136=(a136+a053);
  if (res[0]!=0) res[0][11]=a136;
  a136=arg[0]? arg[0][12] : 0;
  a053=arg[0]? arg[0][15] : 0;
  a071=(a001*a053);
  a309=(a039*a136);
  a253=arg[0]? arg[0][13] : 0;
  a161=(a012*a253);
  a309=(a309+a161);
  a161=arg[0]? arg[0][14] : 0;
  a016=(a035*a161);
  a309=(a309-a016);
  a016=(a278*a053);
  a266=arg[0]? arg[0][16] : 0;
  a217=(a020*a266);
  a016=(a016+a217);
  a309=(a309+a016);
  a016=(a006*a309);
  a217=(a042*a053);
  a188=(a045*a309);
  a160=(a048*a053);
  a160=(a136+a160);
  a134=(a070*a160);
  a126=(a048*a266);
  a126=(a253+a126);
  a037=(a054*a126);
  a134=(a134+a037);
  a037=arg[0]? arg[0][17] : 0;
  a068=(a048*a037);
  a068=(a161+a068);
  a148=(a162*a068);
  a134=(a134-a148);
  a148=(a048*a309);
  a148=(a053+a148);
  a290=(a292*a148);
  a261=(a189*a136);
  a231=(a019*a253);
  a261=(a261+a231);
  a231=(a248*a161);
  a261=(a261+a231);
  a231=(a219*a053);
  a202=(a029*a266);
  a231=(a231-a202);
  a261=(a261+a231);
  a231=(a048*a261);
  a231=(a266+a231);
  a202=(a061*a231);
  a290=(a290+a202);
  a134=(a134+a290);
  a134=(a047*a134);
  a188=(a188+a134);
  a188=(a053+a188);
  a134=(a044*a188);
  a217=(a217+a134);
  a217=(a136+a217);
  a134=(a107*a217);
  a290=(a042*a266);
  a202=(a045*a261);
  a174=(a013*a160);
  a009=(a060*a126);
  a174=(a174+a009);
  a009=(a055*a068);
  a174=(a174+a009);
  a009=(a041*a148);
  a218=(a058*a231);
  a009=(a009-a218);
  a174=(a174+a009);
  a174=(a047*a174);
  a202=(a202+a174);
  a202=(a266+a202);
  a174=(a044*a202);
  a290=(a290+a174);
  a290=(a253+a290);
  a174=(a091*a290);
  a134=(a134+a174);
  a174=(a042*a037);
  a009=(a277*a136);
  a218=(a024*a253);
  a009=(a009+a218);
  a218=(a014*a161);
  a009=(a009-a218);
  a218=(a190*a053);
  a205=(a011*a266);
  a218=(a218+a205);
  a009=(a009+a218);
  a218=(a045*a009);
  a160=(a092*a160);
  a126=(a065*a126);
  a160=(a160+a126);
  a068=(a057*a068);
  a160=(a160-a068);
  a068=(a002*a148);
  a126=(a052*a231);
  a068=(a068+a126);
  a160=(a160+a068);
  a160=(a047*a160);
  a218=(a218+a160);
  a218=(a037+a218);
  a160=(a044*a218);
  a174=(a174+a160);
  a174=(a161+a174);
  a160=(a067*a174);
  a134=(a134-a160);
  a160=(a042*a309);
  a068=(a045*a053);
  a148=(a047*a148);
  a068=(a068+a148);
  a068=(a136+a068);
  a148=(a088*a068);
  a126=(a045*a266);
  a231=(a047*a231);
  a126=(a126+a231);
  a126=(a253+a126);
  a231=(a079*a126);
  a148=(a148+a231);
  a231=(a045*a037);
  a205=(a048*a009);
  a205=(a037+a205);
  a205=(a047*a205);
  a231=(a231+a205);
  a231=(a161+a231);
  a205=(a093*a231);
  a148=(a148-a205);
  a205=(a182*a188);
  a101=(a051*a202);
  a205=(a205+a101);
  a148=(a148+a205);
  a205=(a044*a148);
  a160=(a160+a205);
  a160=(a053+a160);
  a205=(a021*a160);
  a101=(a042*a261);
  a026=(a239*a068);
  a297=(a063*a126);
  a026=(a026+a297);
  a297=(a073*a231);
  a026=(a026+a297);
  a297=(a109*a188);
  a018=(a082*a202);
  a297=(a297-a018);
  a026=(a026+a297);
  a297=(a044*a026);
  a101=(a101+a297);
  a101=(a266+a101);
  a297=(a098*a101);
  a205=(a205+a297);
  a134=(a134+a205);
  a205=(a030*a134);
  a016=(a016+a205);
  a205=(a103*a053);
  a297=(a050*a188);
  a205=(a205+a297);
  a297=(a083*a160);
  a205=(a205+a297);
  a205=(a136+a205);
  a297=(a129*a205);
  a018=(a103*a266);
  a025=(a050*a202);
  a018=(a018+a025);
  a025=(a083*a101);
  a018=(a018+a025);
  a018=(a253+a018);
  a025=(a078*a018);
  a297=(a297+a025);
  a025=(a103*a037);
  a218=(a050*a218);
  a025=(a025+a218);
  a218=(a042*a009);
  a068=(a010*a068);
  a126=(a062*a126);
  a068=(a068+a126);
  a231=(a064*a231);
  a068=(a068-a231);
  a188=(a146*a188);
  a202=(a066*a202);
  a188=(a188+a202);
  a068=(a068+a188);
  a188=(a044*a068);
  a218=(a218+a188);
  a218=(a037+a218);
  a188=(a083*a218);
  a025=(a025+a188);
  a025=(a161+a025);
  a188=(a090*a025);
  a297=(a297-a188);
  a188=(a103*a309);
  a148=(a050*a148);
  a188=(a188+a148);
  a148=(a083*a134);
  a188=(a188+a148);
  a188=(a053+a188);
  a148=(a094*a188);
  a202=(a103*a261);
  a026=(a050*a026);
  a202=(a202+a026);
  a026=(a008*a217);
  a231=(a097*a290);
  a026=(a026+a231);
  a231=(a069*a174);
  a026=(a026+a231);
  a231=(a111*a160);
  a126=(a095*a101);
  a231=(a231-a126);
  a026=(a026+a231);
  a231=(a083*a026);
  a202=(a202+a231);
  a202=(a266+a202);
  a231=(a120*a202);
  a148=(a148+a231);
  a297=(a297+a148);
  a148=(a100*a297);
  a016=(a016+a148);
  a016=(a053+a016);
  a148=(a005*a016);
  a071=(a071+a148);
  a148=(a125*a309);
  a231=(a131*a134);
  a148=(a148+a231);
  a231=(a132*a297);
  a148=(a148+a231);
  a231=(a006*a053);
  a126=(a030*a160);
  a231=(a231+a126);
  a126=(a100*a188);
  a231=(a231+a126);
  a231=(a136+a231);
  a126=(a154*a231);
  a015=(a006*a266);
  a289=(a030*a101);
  a015=(a015+a289);
  a289=(a100*a202);
  a015=(a015+a289);
  a015=(a253+a015);
  a289=(a138*a015);
  a126=(a126+a289);
  a289=(a006*a037);
  a268=(a030*a218);
  a289=(a289+a268);
  a268=(a103*a009);
  a068=(a050*a068);
  a268=(a268+a068);
  a217=(a023*a217);
  a290=(a102*a290);
  a217=(a217+a290);
  a174=(a076*a174);
  a217=(a217-a174);
  a174=(a298*a160);
  a290=(a089*a101);
  a174=(a174+a290);
  a217=(a217+a174);
  a174=(a083*a217);
  a268=(a268+a174);
  a268=(a037+a268);
  a174=(a100*a268);
  a289=(a289+a174);
  a289=(a161+a289);
  a174=(a113*a289);
  a126=(a126-a174);
  a174=(a096*a016);
  a290=(a006*a261);
  a068=(a030*a026);
  a290=(a290+a068);
  a068=(a043*a205);
  a259=(a119*a018);
  a068=(a068+a259);
  a259=(a114*a025);
  a068=(a068+a259);
  a259=(a074*a188);
  a033=(a117*a202);
  a259=(a259-a033);
  a068=(a068+a259);
  a259=(a100*a068);
  a290=(a290+a259);
  a290=(a266+a290);
  a259=(a145*a290);
  a174=(a174+a259);
  a126=(a126+a174);
  a174=(a133*a126);
  a148=(a148+a174);
  a148=(a053+a148);
  a174=(a122*a148);
  a071=(a071+a174);
  a174=(a150*a309);
  a259=(a087*a134);
  a174=(a174+a259);
  a259=(a157*a297);
  a174=(a174+a259);
  a259=(a158*a126);
  a174=(a174+a259);
  a259=(a125*a053);
  a033=(a131*a160);
  a259=(a259+a033);
  a033=(a132*a188);
  a259=(a259+a033);
  a033=(a133*a016);
  a259=(a259+a033);
  a259=(a136+a259);
  a033=(a180*a259);
  a200=(a125*a266);
  a308=(a131*a101);
  a200=(a200+a308);
  a308=(a132*a202);
  a200=(a200+a308);
  a308=(a133*a290);
  a200=(a200+a308);
  a200=(a253+a200);
  a308=(a164*a200);
  a033=(a033+a308);
  a308=(a125*a037);
  a304=(a131*a218);
  a308=(a308+a304);
  a304=(a132*a268);
  a308=(a308+a304);
  a304=(a006*a009);
  a300=(a030*a217);
  a304=(a304+a300);
  a205=(a156*a205);
  a018=(a124*a018);
  a205=(a205+a018);
  a025=(a116*a025);
  a205=(a205-a025);
  a025=(a077*a188);
  a018=(a112*a202);
  a025=(a025+a018);
  a205=(a205+a025);
  a025=(a100*a205);
  a304=(a304+a025);
  a304=(a037+a304);
  a025=(a133*a304);
  a308=(a308+a025);
  a308=(a161+a308);
  a025=(a049*a308);
  a033=(a033-a025);
  a025=(a118*a148);
  a018=(a125*a261);
  a300=(a131*a026);
  a018=(a018+a300);
  a300=(a132*a068);
  a018=(a018+a300);
  a300=(a108*a231);
  a075=(a144*a015);
  a300=(a300+a075);
  a075=(a139*a289);
  a300=(a300+a075);
  a075=(a086*a016);
  a115=(a142*a290);
  a075=(a075-a115);
  a300=(a300+a075);
  a075=(a133*a300);
  a018=(a018+a075);
  a018=(a266+a018);
  a075=(a171*a018);
  a025=(a025+a075);
  a033=(a033+a025);
  a025=(a159*a033);
  a174=(a174+a025);
  a174=(a053+a174);
  a025=(a147*a174);
  a071=(a071+a025);
  a025=(a176*a309);
  a075=(a183*a134);
  a025=(a025+a075);
  a075=(a184*a297);
  a025=(a025+a075);
  a075=(a185*a126);
  a025=(a025+a075);
  a075=(a186*a033);
  a025=(a025+a075);
  a075=(a150*a053);
  a115=(a087*a160);
  a075=(a075+a115);
  a115=(a157*a188);
  a075=(a075+a115);
  a115=(a158*a016);
  a075=(a075+a115);
  a115=(a159*a148);
  a075=(a075+a115);
  a075=(a136+a075);
  a115=(a208*a075);
  a056=(a150*a266);
  a235=(a087*a101);
  a056=(a056+a235);
  a235=(a157*a202);
  a056=(a056+a235);
  a235=(a158*a290);
  a056=(a056+a235);
  a235=(a159*a018);
  a056=(a056+a235);
  a056=(a253+a056);
  a235=(a192*a056);
  a115=(a115+a235);
  a235=(a150*a037);
  a206=(a087*a218);
  a235=(a235+a206);
  a206=(a157*a268);
  a235=(a235+a206);
  a206=(a158*a304);
  a235=(a235+a206);
  a206=(a125*a009);
  a178=(a131*a217);
  a206=(a206+a178);
  a178=(a132*a205);
  a206=(a206+a178);
  a231=(a123*a231);
  a015=(a149*a015);
  a231=(a231+a015);
  a289=(a141*a289);
  a231=(a231-a289);
  a289=(a084*a016);
  a015=(a137*a290);
  a289=(a289+a015);
  a231=(a231+a289);
  a289=(a133*a231);
  a206=(a206+a289);
  a206=(a037+a206);
  a289=(a159*a206);
  a235=(a235+a289);
  a235=(a161+a235);
  a289=(a085*a235);
  a115=(a115-a289);
  a289=(a143*a174);
  a015=(a150*a261);
  a178=(a087*a026);
  a015=(a015+a178);
  a178=(a157*a068);
  a015=(a015+a178);
  a178=(a158*a300);
  a015=(a015+a178);
  a178=(a022*a259);
  a152=(a170*a200);
  a178=(a178+a152);
  a152=(a165*a308);
  a178=(a178+a152);
  a152=(a210*a148);
  a127=(a168*a018);
  a152=(a152-a127);
  a178=(a178+a152);
  a152=(a159*a178);
  a015=(a015+a152);
  a015=(a266+a015);
  a152=(a199*a015);
  a289=(a289+a152);
  a115=(a115+a289);
  a289=(a187*a115);
  a025=(a025+a289);
  a025=(a053+a025);
  a289=(a173*a025);
  a071=(a071+a289);
  a289=(a204*a309);
  a152=(a211*a134);
  a289=(a289+a152);
  a152=(a212*a297);
  a289=(a289+a152);
  a152=(a213*a126);
  a289=(a289+a152);
  a152=(a214*a033);
  a289=(a289+a152);
  a152=(a215*a115);
  a289=(a289+a152);
  a152=(a176*a053);
  a127=(a183*a160);
  a152=(a152+a127);
  a127=(a184*a188);
  a152=(a152+a127);
  a127=(a185*a016);
  a152=(a152+a127);
  a127=(a186*a148);
  a152=(a152+a127);
  a127=(a187*a174);
  a152=(a152+a127);
  a152=(a136+a152);
  a127=(a237*a152);
  a105=(a176*a266);
  a004=(a183*a101);
  a105=(a105+a004);
  a004=(a184*a202);
  a105=(a105+a004);
  a004=(a185*a290);
  a105=(a105+a004);
  a004=(a186*a018);
  a105=(a105+a004);
  a004=(a187*a015);
  a105=(a105+a004);
  a105=(a253+a105);
  a004=(a221*a105);
  a127=(a127+a004);
  a004=(a176*a037);
  a081=(a183*a218);
  a004=(a004+a081);
  a081=(a184*a268);
  a004=(a004+a081);
  a081=(a185*a304);
  a004=(a004+a081);
  a081=(a186*a206);
  a004=(a004+a081);
  a081=(a150*a009);
  a172=(a087*a217);
  a081=(a081+a172);
  a172=(a157*a205);
  a081=(a081+a172);
  a172=(a158*a231);
  a081=(a081+a172);
  a259=(a153*a259);
  a200=(a175*a200);
  a259=(a259+a200);
  a308=(a167*a308);
  a259=(a259-a308);
  a308=(a080*a148);
  a200=(a163*a018);
  a308=(a308+a200);
  a259=(a259+a308);
  a308=(a159*a259);
  a081=(a081+a308);
  a081=(a037+a081);
  a308=(a187*a081);
  a004=(a004+a308);
  a004=(a161+a004);
  a308=(a038*a004);
  a127=(a127-a308);
  a308=(a169*a025);
  a200=(a176*a261);
  a172=(a183*a026);
  a200=(a200+a172);
  a172=(a184*a068);
  a200=(a200+a172);
  a172=(a185*a300);
  a200=(a200+a172);
  a172=(a186*a178);
  a200=(a200+a172);
  a172=(a130*a075);
  a305=(a198*a056);
  a172=(a172+a305);
  a305=(a193*a235);
  a172=(a172+a305);
  a305=(a302*a174);
  a301=(a196*a015);
  a305=(a305-a301);
  a172=(a172+a305);
  a305=(a187*a172);
  a200=(a200+a305);
  a200=(a266+a200);
  a305=(a228*a200);
  a308=(a308+a305);
  a127=(a127+a308);
  a308=(a216*a127);
  a289=(a289+a308);
  a289=(a053+a289);
  a308=(a201*a289);
  a071=(a071+a308);
  a308=(a233*a309);
  a305=(a240*a134);
  a308=(a308+a305);
  a305=(a241*a297);
  a308=(a308+a305);
  a305=(a242*a126);
  a308=(a308+a305);
  a305=(a243*a033);
  a308=(a308+a305);
  a305=(a244*a115);
  a308=(a308+a305);
  a305=(a245*a127);
  a308=(a308+a305);
  a305=(a204*a053);
  a301=(a211*a160);
  a305=(a305+a301);
  a301=(a212*a188);
  a305=(a305+a301);
  a301=(a213*a016);
  a305=(a305+a301);
  a301=(a214*a148);
  a305=(a305+a301);
  a301=(a215*a174);
  a305=(a305+a301);
  a301=(a216*a025);
  a305=(a305+a301);
  a305=(a136+a305);
  a301=(a267*a305);
  a046=(a204*a266);
  a269=(a211*a101);
  a046=(a046+a269);
  a269=(a212*a202);
  a046=(a046+a269);
  a269=(a213*a290);
  a046=(a046+a269);
  a269=(a214*a018);
  a046=(a046+a269);
  a269=(a215*a015);
  a046=(a046+a269);
  a269=(a216*a200);
  a046=(a046+a269);
  a046=(a253+a046);
  a269=(a251*a046);
  a301=(a301+a269);
  a269=(a204*a037);
  a027=(a211*a218);
  a269=(a269+a027);
  a027=(a212*a268);
  a269=(a269+a027);
  a027=(a213*a304);
  a269=(a269+a027);
  a027=(a214*a206);
  a269=(a269+a027);
  a027=(a215*a081);
  a269=(a269+a027);
  a027=(a176*a009);
  a249=(a183*a217);
  a027=(a027+a249);
  a249=(a184*a205);
  a027=(a027+a249);
  a249=(a185*a231);
  a027=(a027+a249);
  a249=(a186*a259);
  a027=(a027+a249);
  a075=(a179*a075);
  a056=(a203*a056);
  a075=(a075+a056);
  a235=(a195*a235);
  a075=(a075-a235);
  a235=(a303*a174);
  a056=(a191*a015);
  a235=(a235+a056);
  a075=(a075+a235);
  a235=(a187*a075);
  a027=(a027+a235);
  a027=(a037+a027);
  a235=(a216*a027);
  a269=(a269+a235);
  a269=(a161+a269);
  a235=(a140*a269);
  a301=(a301-a235);
  a235=(a197*a289);
  a056=(a204*a261);
  a249=(a211*a026);
  a056=(a056+a249);
  a249=(a212*a068);
  a056=(a056+a249);
  a249=(a213*a300);
  a056=(a056+a249);
  a249=(a214*a178);
  a056=(a056+a249);
  a249=(a215*a172);
  a056=(a056+a249);
  a249=(a155*a152);
  a072=(a227*a105);
  a249=(a249+a072);
  a072=(a222*a004);
  a249=(a249+a072);
  a072=(a306*a025);
  a059=(a225*a200);
  a072=(a072-a059);
  a249=(a249+a072);
  a072=(a216*a249);
  a056=(a056+a072);
  a056=(a266+a056);
  a072=(a258*a056);
  a235=(a235+a072);
  a301=(a301+a235);
  a235=(a246*a301);
  a308=(a308+a235);
  a308=(a053+a308);
  a235=(a230*a308);
  a071=(a071+a235);
  a235=(a263*a309);
  a134=(a270*a134);
  a235=(a235+a134);
  a297=(a099*a297);
  a235=(a235+a297);
  a297=(a121*a126);
  a235=(a235+a297);
  a297=(a271*a033);
  a235=(a235+a297);
  a297=(a272*a115);
  a235=(a235+a297);
  a297=(a273*a127);
  a235=(a235+a297);
  a297=(a274*a301);
  a235=(a235+a297);
  a297=(a233*a053);
  a134=(a240*a160);
  a297=(a297+a134);
  a134=(a241*a188);
  a297=(a297+a134);
  a134=(a242*a016);
  a297=(a297+a134);
  a134=(a243*a148);
  a297=(a297+a134);
  a134=(a244*a174);
  a297=(a297+a134);
  a134=(a245*a025);
  a297=(a297+a134);
  a134=(a246*a289);
  a297=(a297+a134);
  a297=(a136+a297);
  a134=(a296*a297);
  a072=(a233*a266);
  a059=(a240*a101);
  a072=(a072+a059);
  a059=(a241*a202);
  a072=(a072+a059);
  a059=(a242*a290);
  a072=(a072+a059);
  a059=(a243*a018);
  a072=(a072+a059);
  a059=(a244*a015);
  a072=(a072+a059);
  a059=(a245*a200);
  a072=(a072+a059);
  a059=(a246*a056);
  a072=(a072+a059);
  a072=(a253+a072);
  a059=(a280*a072);
  a134=(a134+a059);
  a059=(a233*a037);
  a034=(a240*a218);
  a059=(a059+a034);
  a034=(a241*a268);
  a059=(a059+a034);
  a034=(a242*a304);
  a059=(a059+a034);
  a034=(a243*a206);
  a059=(a059+a034);
  a034=(a244*a081);
  a059=(a059+a034);
  a034=(a245*a027);
  a059=(a059+a034);
  a034=(a204*a009);
  a234=(a211*a217);
  a034=(a034+a234);
  a234=(a212*a205);
  a034=(a034+a234);
  a234=(a213*a231);
  a034=(a034+a234);
  a234=(a214*a259);
  a034=(a034+a234);
  a234=(a215*a075);
  a034=(a034+a234);
  a152=(a207*a152);
  a105=(a232*a105);
  a152=(a152+a105);
  a004=(a224*a004);
  a152=(a152-a004);
  a004=(a307*a025);
  a105=(a220*a200);
  a004=(a004+a105);
  a152=(a152+a004);
  a004=(a216*a152);
  a034=(a034+a004);
  a034=(a037+a034);
  a004=(a246*a034);
  a059=(a059+a004);
  a059=(a161+a059);
  a004=(a247*a059);
  a134=(a134-a004);
  a004=(a226*a308);
  a105=(a233*a261);
  a234=(a240*a026);
  a105=(a105+a234);
  a234=(a241*a068);
  a105=(a105+a234);
  a234=(a242*a300);
  a105=(a105+a234);
  a234=(a243*a178);
  a105=(a105+a234);
  a234=(a244*a172);
  a105=(a105+a234);
  a234=(a245*a249);
  a105=(a105+a234);
  a234=(a181*a305);
  a000=(a257*a046);
  a234=(a234+a000);
  a000=(a252*a269);
  a234=(a234+a000);
  a000=(a310*a289);
  a151=(a255*a056);
  a000=(a000-a151);
  a234=(a234+a000);
  a000=(a246*a234);
  a105=(a105+a000);
  a105=(a266+a105);
  a000=(a287*a105);
  a004=(a004+a000);
  a134=(a134+a004);
  a004=(a275*a134);
  a235=(a235+a004);
  a235=(a053+a235);
  a004=(a260*a235);
  a071=(a071+a004);
  a071=(a136+a071);
  if (res[0]!=0) res[0][12]=a071;
  a071=(a001*a266);
  a004=(a005*a290);
  a071=(a071+a004);
  a004=(a122*a018);
  a071=(a071+a004);
  a004=(a147*a015);
  a071=(a071+a004);
  a004=(a173*a200);
  a071=(a071+a004);
  a004=(a201*a056);
  a071=(a071+a004);
  a004=(a230*a105);
  a071=(a071+a004);
  a004=(a263*a261);
  a026=(a270*a026);
  a004=(a004+a026);
  a068=(a099*a068);
  a004=(a004+a068);
  a068=(a121*a300);
  a004=(a004+a068);
  a068=(a271*a178);
  a004=(a004+a068);
  a068=(a272*a172);
  a004=(a004+a068);
  a068=(a273*a249);
  a004=(a004+a068);
  a068=(a274*a234);
  a004=(a004+a068);
  a068=(a264*a297);
  a026=(a286*a072);
  a068=(a068+a026);
  a026=(a281*a059);
  a068=(a068+a026);
  a026=(a312*a308);
  a000=(a284*a105);
  a026=(a026-a000);
  a068=(a068+a026);
  a026=(a275*a068);
  a004=(a004+a026);
  a004=(a266+a004);
  a026=(a260*a004);
  a071=(a071+a026);
  a071=(a253+a071);
  if (res[0]!=0) res[0][13]=a071;
  a071=(a001*a037);
  a026=(a005*a304);
  a071=(a071+a026);
  a026=(a122*a206);
  a071=(a071+a026);
  a026=(a147*a081);
  a071=(a071+a026);
  a026=(a173*a027);
  a071=(a071+a026);
  a026=(a201*a034);
  a071=(a071+a026);
  a026=(a233*a009);
  a000=(a240*a217);
  a026=(a026+a000);
  a000=(a241*a205);
  a026=(a026+a000);
  a000=(a242*a231);
  a026=(a026+a000);
  a000=(a243*a259);
  a026=(a026+a000);
  a000=(a244*a075);
  a026=(a026+a000);
  a000=(a245*a152);
  a026=(a026+a000);
  a305=(a236*a305);
  a046=(a262*a046);
  a305=(a305+a046);
  a269=(a254*a269);
  a305=(a305-a269);
  a269=(a311*a289);
  a046=(a250*a056);
  a269=(a269+a046);
  a305=(a305+a269);
  a269=(a246*a305);
  a026=(a026+a269);
  a026=(a037+a026);
  a269=(a230*a026);
  a071=(a071+a269);
  a269=(a263*a009);
  a217=(a270*a217);
  a269=(a269+a217);
  a205=(a099*a205);
  a269=(a269+a205);
  a205=(a121*a231);
  a269=(a269+a205);
  a205=(a271*a259);
  a269=(a269+a205);
  a205=(a272*a075);
  a269=(a269+a205);
  a205=(a273*a152);
  a269=(a269+a205);
  a205=(a274*a305);
  a269=(a269+a205);
  a297=(a106*a297);
  a072=(a291*a072);
  a297=(a297+a072);
  a059=(a283*a059);
  a297=(a297-a059);
  a059=(a313*a308);
  a072=(a279*a105);
  a059=(a059+a072);
  a297=(a297+a059);
  a059=(a275*a297);
  a269=(a269+a059);
  a269=(a037+a269);
  a269=(a260*a269);
  a071=(a071+a269);
  a071=(a161+a071);
  if (res[0]!=0) res[0][14]=a071;
  a309=(a001*a309);
  a126=(a005*a126);
  a309=(a309+a126);
  a033=(a122*a033);
  a309=(a309+a033);
  a115=(a147*a115);
  a309=(a309+a115);
  a127=(a173*a127);
  a309=(a309+a127);
  a301=(a201*a301);
  a309=(a309+a301);
  a134=(a230*a134);
  a309=(a309+a134);
  a134=(a263*a053);
  a160=(a270*a160);
  a134=(a134+a160);
  a188=(a099*a188);
  a134=(a134+a188);
  a016=(a121*a016);
  a134=(a134+a016);
  a148=(a271*a148);
  a134=(a134+a148);
  a174=(a272*a174);
  a134=(a134+a174);
  a025=(a273*a025);
  a134=(a134+a025);
  a289=(a274*a289);
  a134=(a134+a289);
  a308=(a275*a308);
  a134=(a134+a308);
  a136=(a136+a134);
  a134=(a028*a136);
  a308=(a263*a266);
  a101=(a270*a101);
  a308=(a308+a101);
  a202=(a099*a202);
  a308=(a308+a202);
  a290=(a121*a290);
  a308=(a308+a290);
  a018=(a271*a018);
  a308=(a308+a018);
  a015=(a272*a015);
  a308=(a308+a015);
  a200=(a273*a200);
  a308=(a308+a200);
  a056=(a274*a056);
  a308=(a308+a056);
  a105=(a275*a105);
  a308=(a308+a105);
  a253=(a253+a308);
  a308=(a229*a253);
  a134=(a134+a308);
  a308=(a263*a037);
  a218=(a270*a218);
  a308=(a308+a218);
  a268=(a099*a268);
  a308=(a308+a268);
  a304=(a121*a304);
  a308=(a308+a304);
  a206=(a271*a206);
  a308=(a308+a206);
  a081=(a272*a081);
  a308=(a308+a081);
  a027=(a273*a027);
  a308=(a308+a027);
  a034=(a274*a034);
  a308=(a308+a034);
  a026=(a275*a026);
  a308=(a308+a026);
  a161=(a161+a308);
  a308=(a294*a161);
  a134=(a134-a308);
  a308=(a265*a235);
  a026=(a110*a004);
  a308=(a308+a026);
  a134=(a134+a308);
  a134=(a260*a134);
  a309=(a309+a134);
  a053=(a053+a309);
  if (res[0]!=0) res[0][15]=a053;
  a261=(a001*a261);
  a300=(a005*a300);
  a261=(a261+a300);
  a178=(a122*a178);
  a261=(a261+a178);
  a172=(a147*a172);
  a261=(a261+a172);
  a249=(a173*a249);
  a261=(a261+a249);
  a234=(a201*a234);
  a261=(a261+a234);
  a068=(a230*a068);
  a261=(a261+a068);
  a068=(a177*a136);
  a234=(a031*a253);
  a068=(a068+a234);
  a234=(a007*a161);
  a068=(a068+a234);
  a234=(a166*a235);
  a249=(a032*a004);
  a234=(a234-a249);
  a068=(a068+a234);
  a068=(a260*a068);
  a261=(a261+a068);
  a266=(a266+a261);
  if (res[0]!=0) res[0][16]=a266;
  a009=(a001*a009);
  a231=(a005*a231);
  a009=(a009+a231);
  a259=(a122*a259);
  a009=(a009+a259);
  a075=(a147*a075);
  a009=(a009+a075);
  a152=(a173*a152);
  a009=(a009+a152);
  a305=(a201*a305);
  a009=(a009+a305);
  a297=(a230*a297);
  a009=(a009+a297);
  a136=(a003*a136);
  a253=(a299*a253);
  a136=(a136+a253);
  a161=(a040*a161);
  a136=(a136-a161);
  a235=(a135*a235);
  a004=(a017*a004);
  a235=(a235+a004);
  a136=(a136+a235);
  a136=(a260*a136);
  a009=(a009+a136);
  a037=(a037+a009);
  if (res[0]!=0) res[0][17]=a037;
  a037=arg[0]? arg[0][18] : 0;
  a009=arg[0]? arg[0][21] : 0;
  a136=(a001*a009);
  a235=(a039*a037);
  a004=arg[0]? arg[0][19] : 0;
  a161=(a012*a004);
  a235=(a235+a161);
  a161=arg[0]? arg[0][20] : 0;
  a253=(a035*a161);
  a235=(a235-a253);
  a253=(a278*a009);
  a297=arg[0]? arg[0][22] : 0;
  a305=(a020*a297);
  a253=(a253+a305);
  a235=(a235+a253);
  a253=(a006*a235);
  a305=(a042*a009);
  a152=(a045*a235);
  a075=(a048*a009);
  a075=(a037+a075);
  a259=(a070*a075);
  a231=(a048*a297);
  a231=(a004+a231);
  a266=(a054*a231);
  a259=(a259+a266);
  a266=arg[0]? arg[0][23] : 0;
  a261=(a048*a266);
  a261=(a161+a261);
  a068=(a162*a261);
  a259=(a259-a068);
  a068=(a048*a235);
  a068=(a009+a068);
  a234=(a292*a068);
  a249=(a189*a037);
  a172=(a019*a004);
  a249=(a249+a172);
  a172=(a248*a161);
  a249=(a249+a172);
  a172=(a219*a009);
  a178=(a029*a297);
  a172=(a172-a178);
  a249=(a249+a172);
  a172=(a048*a249);
  a172=(a297+a172);
  a178=(a061*a172);
  a234=(a234+a178);
  a259=(a259+a234);
  a259=(a047*a259);
  a152=(a152+a259);
  a152=(a009+a152);
  a259=(a044*a152);
  a305=(a305+a259);
  a305=(a037+a305);
  a259=(a107*a305);
  a234=(a042*a297);
  a178=(a045*a249);
  a300=(a013*a075);
  a053=(a060*a231);
  a300=(a300+a053);
  a053=(a055*a261);
  a300=(a300+a053);
  a053=(a041*a068);
  a309=(a058*a172);
  a053=(a053-a309);
  a300=(a300+a053);
  a300=(a047*a300);
  a178=(a178+a300);
  a178=(a297+a178);
  a300=(a044*a178);
  a234=(a234+a300);
  a234=(a004+a234);
  a300=(a091*a234);
  a259=(a259+a300);
  a300=(a042*a266);
  a053=(a277*a037);
  a309=(a024*a004);
  a053=(a053+a309);
  a309=(a014*a161);
  a053=(a053-a309);
  a309=(a190*a009);
  a134=(a011*a297);
  a309=(a309+a134);
  a053=(a053+a309);
  a309=(a045*a053);
  a075=(a092*a075);
  a231=(a065*a231);
  a075=(a075+a231);
  a261=(a057*a261);
  a075=(a075-a261);
  a261=(a002*a068);
  a231=(a052*a172);
  a261=(a261+a231);
  a075=(a075+a261);
  a075=(a047*a075);
  a309=(a309+a075);
  a309=(a266+a309);
  a075=(a044*a309);
  a300=(a300+a075);
  a300=(a161+a300);
  a075=(a067*a300);
  a259=(a259-a075);
  a075=(a042*a235);
  a261=(a045*a009);
  a068=(a047*a068);
  a261=(a261+a068);
  a261=(a037+a261);
  a068=(a088*a261);
  a231=(a045*a297);
  a172=(a047*a172);
  a231=(a231+a172);
  a231=(a004+a231);
  a172=(a079*a231);
  a068=(a068+a172);
  a172=(a045*a266);
  a134=(a048*a053);
  a134=(a266+a134);
  a134=(a047*a134);
  a172=(a172+a134);
  a172=(a161+a172);
  a134=(a093*a172);
  a068=(a068-a134);
  a134=(a182*a152);
  a308=(a051*a178);
  a134=(a134+a308);
  a068=(a068+a134);
  a134=(a044*a068);
  a075=(a075+a134);
  a075=(a009+a075);
  a134=(a021*a075);
  a308=(a042*a249);
  a026=(a239*a261);
  a034=(a063*a231);
  a026=(a026+a034);
  a034=(a073*a172);
  a026=(a026+a034);
  a034=(a109*a152);
  a027=(a082*a178);
  a034=(a034-a027);
  a026=(a026+a034);
  a034=(a044*a026);
  a308=(a308+a034);
  a308=(a297+a308);
  a034=(a098*a308);
  a134=(a134+a034);
  a259=(a259+a134);
  a134=(a030*a259);
  a253=(a253+a134);
  a134=(a103*a009);
  a034=(a050*a152);
  a134=(a134+a034);
  a034=(a083*a075);
  a134=(a134+a034);
  a134=(a037+a134);
  a034=(a129*a134);
  a027=(a103*a297);
  a081=(a050*a178);
  a027=(a027+a081);
  a081=(a083*a308);
  a027=(a027+a081);
  a027=(a004+a027);
  a081=(a078*a027);
  a034=(a034+a081);
  a081=(a103*a266);
  a309=(a050*a309);
  a081=(a081+a309);
  a309=(a042*a053);
  a261=(a010*a261);
  a231=(a062*a231);
  a261=(a261+a231);
  a172=(a064*a172);
  a261=(a261-a172);
  a152=(a146*a152);
  a178=(a066*a178);
  a152=(a152+a178);
  a261=(a261+a152);
  a152=(a044*a261);
  a309=(a309+a152);
  a309=(a266+a309);
  a152=(a083*a309);
  a081=(a081+a152);
  a081=(a161+a081);
  a152=(a090*a081);
  a034=(a034-a152);
  a152=(a103*a235);
  a068=(a050*a068);
  a152=(a152+a068);
  a068=(a083*a259);
  a152=(a152+a068);
  a152=(a009+a152);
  a068=(a094*a152);
  a178=(a103*a249);
  a026=(a050*a026);
  a178=(a178+a026);
  a026=(a008*a305);
  a172=(a097*a234);
  a026=(a026+a172);
  a172=(a069*a300);
  a026=(a026+a172);
  a172=(a111*a075);
  a231=(a095*a308);
  a172=(a172-a231);
  a026=(a026+a172);
  a172=(a083*a026);
  a178=(a178+a172);
  a178=(a297+a178);
  a172=(a120*a178);
  a068=(a068+a172);
  a034=(a034+a068);
  a068=(a100*a034);
  a253=(a253+a068);
  a253=(a009+a253);
  a068=(a005*a253);
  a136=(a136+a068);
  a068=(a125*a235);
  a172=(a131*a259);
  a068=(a068+a172);
  a172=(a132*a034);
  a068=(a068+a172);
  a172=(a006*a009);
  a231=(a030*a075);
  a172=(a172+a231);
  a231=(a100*a152);
  a172=(a172+a231);
  a172=(a037+a172);
  a231=(a154*a172);
  a206=(a006*a297);
  a304=(a030*a308);
  a206=(a206+a304);
  a304=(a100*a178);
  a206=(a206+a304);
  a206=(a004+a206);
  a304=(a138*a206);
  a231=(a231+a304);
  a304=(a006*a266);
  a268=(a030*a309);
  a304=(a304+a268);
  a268=(a103*a053);
  a261=(a050*a261);
  a268=(a268+a261);
  a305=(a023*a305);
  a234=(a102*a234);
  a305=(a305+a234);
  a300=(a076*a300);
  a305=(a305-a300);
  a300=(a298*a075);
  a234=(a089*a308);
  a300=(a300+a234);
  a305=(a305+a300);
  a300=(a083*a305);
  a268=(a268+a300);
  a268=(a266+a268);
  a300=(a100*a268);
  a304=(a304+a300);
  a304=(a161+a304);
  a300=(a113*a304);
  a231=(a231-a300);
  a300=(a096*a253);
  a234=(a006*a249);
  a261=(a030*a026);
  a234=(a234+a261);
  a261=(a043*a134);
  a218=(a119*a027);
  a261=(a261+a218);
  a218=(a114*a081);
  a261=(a261+a218);
  a218=(a074*a152);
  a105=(a117*a178);
  a218=(a218-a105);
  a261=(a261+a218);
  a218=(a100*a261);
  a234=(a234+a218);
  a234=(a297+a234);
  a218=(a145*a234);
  a300=(a300+a218);
  a231=(a231+a300);
  a300=(a133*a231);
  a068=(a068+a300);
  a068=(a009+a068);
  a300=(a122*a068);
  a136=(a136+a300);
  a300=(a150*a235);
  a218=(a087*a259);
  a300=(a300+a218);
  a218=(a157*a034);
  a300=(a300+a218);
  a218=(a158*a231);
  a300=(a300+a218);
  a218=(a125*a009);
  a105=(a131*a075);
  a218=(a218+a105);
  a105=(a132*a152);
  a218=(a218+a105);
  a105=(a133*a253);
  a218=(a218+a105);
  a218=(a037+a218);
  a105=(a180*a218);
  a056=(a125*a297);
  a200=(a131*a308);
  a056=(a056+a200);
  a200=(a132*a178);
  a056=(a056+a200);
  a200=(a133*a234);
  a056=(a056+a200);
  a056=(a004+a056);
  a200=(a164*a056);
  a105=(a105+a200);
  a200=(a125*a266);
  a015=(a131*a309);
  a200=(a200+a015);
  a015=(a132*a268);
  a200=(a200+a015);
  a015=(a006*a053);
  a018=(a030*a305);
  a015=(a015+a018);
  a134=(a156*a134);
  a027=(a124*a027);
  a134=(a134+a027);
  a081=(a116*a081);
  a134=(a134-a081);
  a081=(a077*a152);
  a027=(a112*a178);
  a081=(a081+a027);
  a134=(a134+a081);
  a081=(a100*a134);
  a015=(a015+a081);
  a015=(a266+a015);
  a081=(a133*a015);
  a200=(a200+a081);
  a200=(a161+a200);
  a081=(a049*a200);
  a105=(a105-a081);
  a081=(a118*a068);
  a027=(a125*a249);
  a018=(a131*a026);
  a027=(a027+a018);
  a018=(a132*a261);
  a027=(a027+a018);
  a018=(a108*a172);
  a290=(a144*a206);
  a018=(a018+a290);
  a290=(a139*a304);
  a018=(a018+a290);
  a290=(a086*a253);
  a202=(a142*a234);
  a290=(a290-a202);
  a018=(a018+a290);
  a290=(a133*a018);
  a027=(a027+a290);
  a027=(a297+a027);
  a290=(a171*a027);
  a081=(a081+a290);
  a105=(a105+a081);
  a081=(a159*a105);
  a300=(a300+a081);
  a300=(a009+a300);
  a081=(a147*a300);
  a136=(a136+a081);
  a081=(a176*a235);
  a290=(a183*a259);
  a081=(a081+a290);
  a290=(a184*a034);
  a081=(a081+a290);
  a290=(a185*a231);
  a081=(a081+a290);
  a290=(a186*a105);
  a081=(a081+a290);
  a290=(a150*a009);
  a202=(a087*a075);
  a290=(a290+a202);
  a202=(a157*a152);
  a290=(a290+a202);
  a202=(a158*a253);
  a290=(a290+a202);
  a202=(a159*a068);
  a290=(a290+a202);
  a290=(a037+a290);
  a202=(a208*a290);
  a101=(a150*a297);
  a289=(a087*a308);
  a101=(a101+a289);
  a289=(a157*a178);
  a101=(a101+a289);
  a289=(a158*a234);
  a101=(a101+a289);
  a289=(a159*a027);
  a101=(a101+a289);
  a101=(a004+a101);
  a289=(a192*a101);
  a202=(a202+a289);
  a289=(a150*a266);
  a025=(a087*a309);
  a289=(a289+a025);
  a025=(a157*a268);
  a289=(a289+a025);
  a025=(a158*a015);
  a289=(a289+a025);
  a025=(a125*a053);
  a174=(a131*a305);
  a025=(a025+a174);
  a174=(a132*a134);
  a025=(a025+a174);
  a172=(a123*a172);
  a206=(a149*a206);
  a172=(a172+a206);
  a304=(a141*a304);
  a172=(a172-a304);
  a304=(a084*a253);
  a206=(a137*a234);
  a304=(a304+a206);
  a172=(a172+a304);
  a304=(a133*a172);
  a025=(a025+a304);
  a025=(a266+a025);
  a304=(a159*a025);
  a289=(a289+a304);
  a289=(a161+a289);
  a304=(a085*a289);
  a202=(a202-a304);
  a304=(a143*a300);
  a206=(a150*a249);
  a174=(a087*a026);
  a206=(a206+a174);
  a174=(a157*a261);
  a206=(a206+a174);
  a174=(a158*a018);
  a206=(a206+a174);
  a174=(a022*a218);
  a148=(a170*a056);
  a174=(a174+a148);
  a148=(a165*a200);
  a174=(a174+a148);
  a148=(a210*a068);
  a016=(a168*a027);
  a148=(a148-a016);
  a174=(a174+a148);
  a148=(a159*a174);
  a206=(a206+a148);
  a206=(a297+a206);
  a148=(a199*a206);
  a304=(a304+a148);
  a202=(a202+a304);
  a304=(a187*a202);
  a081=(a081+a304);
  a081=(a009+a081);
  a304=(a173*a081);
  a136=(a136+a304);
  a304=(a204*a235);
  a148=(a211*a259);
  a304=(a304+a148);
  a148=(a212*a034);
  a304=(a304+a148);
  a148=(a213*a231);
  a304=(a304+a148);
  a148=(a214*a105);
  a304=(a304+a148);
  a148=(a215*a202);
  a304=(a304+a148);
  a148=(a176*a009);
  a016=(a183*a075);
  a148=(a148+a016);
  a016=(a184*a152);
  a148=(a148+a016);
  a016=(a185*a253);
  a148=(a148+a016);
  a016=(a186*a068);
  a148=(a148+a016);
  a016=(a187*a300);
  a148=(a148+a016);
  a148=(a037+a148);
  a016=(a237*a148);
  a188=(a176*a297);
  a160=(a183*a308);
  a188=(a188+a160);
  a160=(a184*a178);
  a188=(a188+a160);
  a160=(a185*a234);
  a188=(a188+a160);
  a160=(a186*a027);
  a188=(a188+a160);
  a160=(a187*a206);
  a188=(a188+a160);
  a188=(a004+a188);
  a160=(a221*a188);
  a016=(a016+a160);
  a160=(a176*a266);
  a301=(a183*a309);
  a160=(a160+a301);
  a301=(a184*a268);
  a160=(a160+a301);
  a301=(a185*a015);
  a160=(a160+a301);
  a301=(a186*a025);
  a160=(a160+a301);
  a301=(a150*a053);
  a127=(a087*a305);
  a301=(a301+a127);
  a127=(a157*a134);
  a301=(a301+a127);
  a127=(a158*a172);
  a301=(a301+a127);
  a218=(a153*a218);
  a056=(a175*a056);
  a218=(a218+a056);
  a200=(a167*a200);
  a218=(a218-a200);
  a200=(a080*a068);
  a056=(a163*a027);
  a200=(a200+a056);
  a218=(a218+a200);
  a200=(a159*a218);
  a301=(a301+a200);
  a301=(a266+a301);
  a200=(a187*a301);
  a160=(a160+a200);
  a160=(a161+a160);
  a200=(a038*a160);
  a016=(a016-a200);
  a200=(a169*a081);
  a056=(a176*a249);
  a127=(a183*a026);
  a056=(a056+a127);
  a127=(a184*a261);
  a056=(a056+a127);
  a127=(a185*a018);
  a056=(a056+a127);
  a127=(a186*a174);
  a056=(a056+a127);
  a127=(a130*a290);
  a115=(a198*a101);
  a127=(a127+a115);
  a115=(a193*a289);
  a127=(a127+a115);
  a115=(a302*a300);
  a033=(a196*a206);
  a115=(a115-a033);
  a127=(a127+a115);
  a115=(a187*a127);
  a056=(a056+a115);
  a056=(a297+a056);
  a115=(a228*a056);
  a200=(a200+a115);
  a016=(a016+a200);
  a200=(a216*a016);
  a304=(a304+a200);
  a304=(a009+a304);
  a200=(a201*a304);
  a136=(a136+a200);
  a200=(a233*a235);
  a115=(a240*a259);
  a200=(a200+a115);
  a115=(a241*a034);
  a200=(a200+a115);
  a115=(a242*a231);
  a200=(a200+a115);
  a115=(a243*a105);
  a200=(a200+a115);
  a115=(a244*a202);
  a200=(a200+a115);
  a115=(a245*a016);
  a200=(a200+a115);
  a115=(a204*a009);
  a033=(a211*a075);
  a115=(a115+a033);
  a033=(a212*a152);
  a115=(a115+a033);
  a033=(a213*a253);
  a115=(a115+a033);
  a033=(a214*a068);
  a115=(a115+a033);
  a033=(a215*a300);
  a115=(a115+a033);
  a033=(a216*a081);
  a115=(a115+a033);
  a115=(a037+a115);
  a033=(a267*a115);
  a126=(a204*a297);
  a071=(a211*a308);
  a126=(a126+a071);
  a071=(a212*a178);
  a126=(a126+a071);
  a071=(a213*a234);
  a126=(a126+a071);
  a071=(a214*a027);
  a126=(a126+a071);
  a071=(a215*a206);
  a126=(a126+a071);
  a071=(a216*a056);
  a126=(a126+a071);
  a126=(a004+a126);
  a071=(a251*a126);
  a033=(a033+a071);
  a071=(a204*a266);
  a269=(a211*a309);
  a071=(a071+a269);
  a269=(a212*a268);
  a071=(a071+a269);
  a269=(a213*a015);
  a071=(a071+a269);
  a269=(a214*a025);
  a071=(a071+a269);
  a269=(a215*a301);
  a071=(a071+a269);
  a269=(a176*a053);
  a059=(a183*a305);
  a269=(a269+a059);
  a059=(a184*a134);
  a269=(a269+a059);
  a059=(a185*a172);
  a269=(a269+a059);
  a059=(a186*a218);
  a269=(a269+a059);
  a290=(a179*a290);
  a101=(a203*a101);
  a290=(a290+a101);
  a289=(a195*a289);
  a290=(a290-a289);
  a289=(a303*a300);
  a101=(a191*a206);
  a289=(a289+a101);
  a290=(a290+a289);
  a289=(a187*a290);
  a269=(a269+a289);
  a269=(a266+a269);
  a289=(a216*a269);
  a071=(a071+a289);
  a071=(a161+a071);
  a289=(a140*a071);
  a033=(a033-a289);
  a289=(a197*a304);
  a101=(a204*a249);
  a059=(a211*a026);
  a101=(a101+a059);
  a059=(a212*a261);
  a101=(a101+a059);
  a059=(a213*a018);
  a101=(a101+a059);
  a059=(a214*a174);
  a101=(a101+a059);
  a059=(a215*a127);
  a101=(a101+a059);
  a059=(a155*a148);
  a072=(a227*a188);
  a059=(a059+a072);
  a072=(a222*a160);
  a059=(a059+a072);
  a072=(a306*a081);
  a205=(a225*a056);
  a072=(a072-a205);
  a059=(a059+a072);
  a072=(a216*a059);
  a101=(a101+a072);
  a101=(a297+a101);
  a072=(a258*a101);
  a289=(a289+a072);
  a033=(a033+a289);
  a289=(a246*a033);
  a200=(a200+a289);
  a200=(a009+a200);
  a289=(a230*a200);
  a136=(a136+a289);
  a289=(a263*a235);
  a259=(a270*a259);
  a289=(a289+a259);
  a034=(a099*a034);
  a289=(a289+a034);
  a034=(a121*a231);
  a289=(a289+a034);
  a034=(a271*a105);
  a289=(a289+a034);
  a034=(a272*a202);
  a289=(a289+a034);
  a034=(a273*a016);
  a289=(a289+a034);
  a034=(a274*a033);
  a289=(a289+a034);
  a034=(a233*a009);
  a259=(a240*a075);
  a034=(a034+a259);
  a259=(a241*a152);
  a034=(a034+a259);
  a259=(a242*a253);
  a034=(a034+a259);
  a259=(a243*a068);
  a034=(a034+a259);
  a259=(a244*a300);
  a034=(a034+a259);
  a259=(a245*a081);
  a034=(a034+a259);
  a259=(a246*a304);
  a034=(a034+a259);
  a034=(a037+a034);
  a259=(a296*a034);
  a072=(a233*a297);
  a205=(a240*a308);
  a072=(a072+a205);
  a205=(a241*a178);
  a072=(a072+a205);
  a205=(a242*a234);
  a072=(a072+a205);
  a205=(a243*a027);
  a072=(a072+a205);
  a205=(a244*a206);
  a072=(a072+a205);
  a205=(a245*a056);
  a072=(a072+a205);
  a205=(a246*a101);
  a072=(a072+a205);
  a072=(a004+a072);
  a205=(a280*a072);
  a259=(a259+a205);
  a205=(a233*a266);
  a217=(a240*a309);
  a205=(a205+a217);
  a217=(a241*a268);
  a205=(a205+a217);
  a217=(a242*a015);
  a205=(a205+a217);
  a217=(a243*a025);
  a205=(a205+a217);
  a217=(a244*a301);
  a205=(a205+a217);
  a217=(a245*a269);
  a205=(a205+a217);
  a217=(a204*a053);
  a046=(a211*a305);
  a217=(a217+a046);
  a046=(a212*a134);
  a217=(a217+a046);
  a046=(a213*a172);
  a217=(a217+a046);
  a046=(a214*a218);
  a217=(a217+a046);
  a046=(a215*a290);
  a217=(a217+a046);
  a148=(a207*a148);
  a188=(a232*a188);
  a148=(a148+a188);
  a160=(a224*a160);
  a148=(a148-a160);
  a160=(a307*a081);
  a188=(a220*a056);
  a160=(a160+a188);
  a148=(a148+a160);
  a160=(a216*a148);
  a217=(a217+a160);
  a217=(a266+a217);
  a160=(a246*a217);
  a205=(a205+a160);
  a205=(a161+a205);
  a160=(a247*a205);
  a259=(a259-a160);
  a160=(a226*a200);
  a188=(a233*a249);
  a046=(a240*a026);
  a188=(a188+a046);
  a046=(a241*a261);
  a188=(a188+a046);
  a046=(a242*a018);
  a188=(a188+a046);
  a046=(a243*a174);
  a188=(a188+a046);
  a046=(a244*a127);
  a188=(a188+a046);
  a046=(a245*a059);
  a188=(a188+a046);
  a046=(a181*a115);
  a000=(a257*a126);
  a046=(a046+a000);
  a000=(a252*a071);
  a046=(a046+a000);
  a000=(a310*a304);
  a151=(a255*a101);
  a000=(a000-a151);
  a046=(a046+a000);
  a000=(a246*a046);
  a188=(a188+a000);
  a188=(a297+a188);
  a000=(a287*a188);
  a160=(a160+a000);
  a259=(a259+a160);
  a160=(a275*a259);
  a289=(a289+a160);
  a289=(a009+a289);
  a160=(a260*a289);
  a136=(a136+a160);
  a136=(a037+a136);
  if (res[0]!=0) res[0][18]=a136;
  a136=(a001*a297);
  a160=(a005*a234);
  a136=(a136+a160);
  a160=(a122*a027);
  a136=(a136+a160);
  a160=(a147*a206);
  a136=(a136+a160);
  a160=(a173*a056);
  a136=(a136+a160);
  a160=(a201*a101);
  a136=(a136+a160);
  a160=(a230*a188);
  a136=(a136+a160);
  a160=(a263*a249);
  a026=(a270*a026);
  a160=(a160+a026);
  a261=(a099*a261);
  a160=(a160+a261);
  a261=(a121*a018);
  a160=(a160+a261);
  a261=(a271*a174);
  a160=(a160+a261);
  a261=(a272*a127);
  a160=(a160+a261);
  a261=(a273*a059);
  a160=(a160+a261);
  a261=(a274*a046);
  a160=(a160+a261);
  a261=(a264*a034);
  a026=(a286*a072);
  a261=(a261+a026);
  a026=(a281*a205);
  a261=(a261+a026);
  a026=(a312*a200);
  a000=(a284*a188);
  a026=(a026-a000);
  a261=(a261+a026);
  a026=(a275*a261);
  a160=(a160+a026);
  a160=(a297+a160);
  a026=(a260*a160);
  a136=(a136+a026);
  a136=(a004+a136);
  if (res[0]!=0) res[0][19]=a136;
  a136=(a001*a266);
  a026=(a005*a015);
  a136=(a136+a026);
  a026=(a122*a025);
  a136=(a136+a026);
  a026=(a147*a301);
  a136=(a136+a026);
  a026=(a173*a269);
  a136=(a136+a026);
  a026=(a201*a217);
  a136=(a136+a026);
  a026=(a233*a053);
  a000=(a240*a305);
  a026=(a026+a000);
  a000=(a241*a134);
  a026=(a026+a000);
  a000=(a242*a172);
  a026=(a026+a000);
  a000=(a243*a218);
  a026=(a026+a000);
  a000=(a244*a290);
  a026=(a026+a000);
  a000=(a245*a148);
  a026=(a026+a000);
  a115=(a236*a115);
  a126=(a262*a126);
  a115=(a115+a126);
  a071=(a254*a071);
  a115=(a115-a071);
  a071=(a311*a304);
  a126=(a250*a101);
  a071=(a071+a126);
  a115=(a115+a071);
  a071=(a246*a115);
  a026=(a026+a071);
  a026=(a266+a026);
  a071=(a230*a026);
  a136=(a136+a071);
  a071=(a263*a053);
  a305=(a270*a305);
  a071=(a071+a305);
  a134=(a099*a134);
  a071=(a071+a134);
  a134=(a121*a172);
  a071=(a071+a134);
  a134=(a271*a218);
  a071=(a071+a134);
  a134=(a272*a290);
  a071=(a071+a134);
  a134=(a273*a148);
  a071=(a071+a134);
  a134=(a274*a115);
  a071=(a071+a134);
  a034=(a106*a034);
  a072=(a291*a072);
  a034=(a034+a072);
  a205=(a283*a205);
  a034=(a034-a205);
  a205=(a313*a200);
  a072=(a279*a188);
  a205=(a205+a072);
  a034=(a034+a205);
  a205=(a275*a034);
  a071=(a071+a205);
  a071=(a266+a071);
  a071=(a260*a071);
  a136=(a136+a071);
  a136=(a161+a136);
  if (res[0]!=0) res[0][20]=a136;
  a235=(a001*a235);
  a231=(a005*a231);
  a235=(a235+a231);
  a105=(a122*a105);
  a235=(a235+a105);
  a202=(a147*a202);
  a235=(a235+a202);
  a016=(a173*a016);
  a235=(a235+a016);
  a033=(a201*a033);
  a235=(a235+a033);
  a259=(a230*a259);
  a235=(a235+a259);
  a259=(a263*a009);
  a075=(a270*a075);
  a259=(a259+a075);
  a152=(a099*a152);
  a259=(a259+a152);
  a253=(a121*a253);
  a259=(a259+a253);
  a068=(a271*a068);
  a259=(a259+a068);
  a300=(a272*a300);
  a259=(a259+a300);
  a081=(a273*a081);
  a259=(a259+a081);
  a304=(a274*a304);
  a259=(a259+a304);
  a200=(a275*a200);
  a259=(a259+a200);
  a037=(a037+a259);
  a259=(a028*a037);
  a200=(a263*a297);
  a308=(a270*a308);
  a200=(a200+a308);
  a178=(a099*a178);
  a200=(a200+a178);
  a234=(a121*a234);
  a200=(a200+a234);
  a027=(a271*a027);
  a200=(a200+a027);
  a206=(a272*a206);
  a200=(a200+a206);
  a056=(a273*a056);
  a200=(a200+a056);
  a101=(a274*a101);
  a200=(a200+a101);
  a188=(a275*a188);
  a200=(a200+a188);
  a004=(a004+a200);
  a200=(a229*a004);
  a259=(a259+a200);
  a200=(a263*a266);
  a309=(a270*a309);
  a200=(a200+a309);
  a268=(a099*a268);
  a200=(a200+a268);
  a015=(a121*a015);
  a200=(a200+a015);
  a025=(a271*a025);
  a200=(a200+a025);
  a301=(a272*a301);
  a200=(a200+a301);
  a269=(a273*a269);
  a200=(a200+a269);
  a217=(a274*a217);
  a200=(a200+a217);
  a026=(a275*a026);
  a200=(a200+a026);
  a161=(a161+a200);
  a200=(a294*a161);
  a259=(a259-a200);
  a200=(a265*a289);
  a026=(a110*a160);
  a200=(a200+a026);
  a259=(a259+a200);
  a259=(a260*a259);
  a235=(a235+a259);
  a009=(a009+a235);
  if (res[0]!=0) res[0][21]=a009;
  a249=(a001*a249);
  a018=(a005*a018);
  a249=(a249+a018);
  a174=(a122*a174);
  a249=(a249+a174);
  a127=(a147*a127);
  a249=(a249+a127);
  a059=(a173*a059);
  a249=(a249+a059);
  a046=(a201*a046);
  a249=(a249+a046);
  a261=(a230*a261);
  a249=(a249+a261);
  a261=(a177*a037);
  a046=(a031*a004);
  a261=(a261+a046);
  a046=(a007*a161);
  a261=(a261+a046);
  a046=(a166*a289);
  a059=(a032*a160);
  a046=(a046-a059);
  a261=(a261+a046);
  a261=(a260*a261);
  a249=(a249+a261);
  a297=(a297+a249);
  if (res[0]!=0) res[0][22]=a297;
  a053=(a001*a053);
  a172=(a005*a172);
  a053=(a053+a172);
  a218=(a122*a218);
  a053=(a053+a218);
  a290=(a147*a290);
  a053=(a053+a290);
  a148=(a173*a148);
  a053=(a053+a148);
  a115=(a201*a115);
  a053=(a053+a115);
  a034=(a230*a034);
  a053=(a053+a034);
  a037=(a003*a037);
  a004=(a299*a004);
  a037=(a037+a004);
  a161=(a040*a161);
  a037=(a037-a161);
  a289=(a135*a289);
  a160=(a017*a160);
  a289=(a289+a160);
  a037=(a037+a289);
  a037=(a260*a037);
  a053=(a053+a037);
  a266=(a266+a053);
  if (res[0]!=0) res[0][23]=a266;
  a266=arg[0]? arg[0][24] : 0;
  a053=arg[0]? arg[0][27] : 0;
  a037=(a001*a053);
  a289=(a039*a266);
  a160=arg[0]? arg[0][25] : 0;
  a161=(a012*a160);
  a289=(a289+a161);
  a161=arg[0]? arg[0][26] : 0;
  a004=(a035*a161);
  a289=(a289-a004);
  a004=(a278*a053);
  a034=arg[0]? arg[0][28] : 0;
  a115=(a020*a034);
  a004=(a004+a115);
  a289=(a289+a004);
  a004=(a006*a289);
  a115=(a042*a053);
  a148=(a045*a289);
  a290=(a048*a053);
  a290=(a266+a290);
  a218=(a070*a290);
  a172=(a048*a034);
  a172=(a160+a172);
  a297=(a054*a172);
  a218=(a218+a297);
  a297=arg[0]? arg[0][29] : 0;
  a249=(a048*a297);
  a249=(a161+a249);
  a261=(a162*a249);
  a218=(a218-a261);
  a261=(a048*a289);
  a261=(a053+a261);
  a046=(a292*a261);
  a059=(a189*a266);
  a127=(a019*a160);
  a059=(a059+a127);
  a127=(a248*a161);
  a059=(a059+a127);
  a127=(a219*a053);
  a174=(a029*a034);
  a127=(a127-a174);
  a059=(a059+a127);
  a127=(a048*a059);
  a127=(a034+a127);
  a174=(a061*a127);
  a046=(a046+a174);
  a218=(a218+a046);
  a218=(a047*a218);
  a148=(a148+a218);
  a148=(a053+a148);
  a218=(a044*a148);
  a115=(a115+a218);
  a115=(a266+a115);
  a218=(a107*a115);
  a046=(a042*a034);
  a174=(a045*a059);
  a018=(a013*a290);
  a009=(a060*a172);
  a018=(a018+a009);
  a009=(a055*a249);
  a018=(a018+a009);
  a009=(a041*a261);
  a235=(a058*a127);
  a009=(a009-a235);
  a018=(a018+a009);
  a018=(a047*a018);
  a174=(a174+a018);
  a174=(a034+a174);
  a018=(a044*a174);
  a046=(a046+a018);
  a046=(a160+a046);
  a018=(a091*a046);
  a218=(a218+a018);
  a018=(a042*a297);
  a009=(a277*a266);
  a235=(a024*a160);
  a009=(a009+a235);
  a235=(a014*a161);
  a009=(a009-a235);
  a235=(a190*a053);
  a259=(a011*a034);
  a235=(a235+a259);
  a009=(a009+a235);
  a235=(a045*a009);
  a290=(a092*a290);
  a172=(a065*a172);
  a290=(a290+a172);
  a249=(a057*a249);
  a290=(a290-a249);
  a249=(a002*a261);
  a172=(a052*a127);
  a249=(a249+a172);
  a290=(a290+a249);
  a290=(a047*a290);
  a235=(a235+a290);
  a235=(a297+a235);
  a290=(a044*a235);
  a018=(a018+a290);
  a018=(a161+a018);
  a290=(a067*a018);
  a218=(a218-a290);
  a290=(a042*a289);
  a249=(a045*a053);
  a261=(a047*a261);
  a249=(a249+a261);
  a249=(a266+a249);
  a261=(a088*a249);
  a172=(a045*a034);
  a127=(a047*a127);
  a172=(a172+a127);
  a172=(a160+a172);
  a127=(a079*a172);
  a261=(a261+a127);
  a127=(a045*a297);
  a259=(a048*a009);
  a259=(a297+a259);
  a259=(a047*a259);
  a127=(a127+a259);
  a127=(a161+a127);
  a259=(a093*a127);
  a261=(a261-a259);
  a259=(a182*a148);
  a200=(a051*a174);
  a259=(a259+a200);
  a261=(a261+a259);
  a259=(a044*a261);
  a290=(a290+a259);
  a290=(a053+a290);
  a259=(a021*a290);
  a200=(a042*a059);
  a026=(a239*a249);
  a217=(a063*a172);
  a026=(a026+a217);
  a217=(a073*a127);
  a026=(a026+a217);
  a217=(a109*a148);
  a269=(a082*a174);
  a217=(a217-a269);
  a026=(a026+a217);
  a217=(a044*a026);
  a200=(a200+a217);
  a200=(a034+a200);
  a217=(a098*a200);
  a259=(a259+a217);
  a218=(a218+a259);
  a259=(a030*a218);
  a004=(a004+a259);
  a259=(a103*a053);
  a217=(a050*a148);
  a259=(a259+a217);
  a217=(a083*a290);
  a259=(a259+a217);
  a259=(a266+a259);
  a217=(a129*a259);
  a269=(a103*a034);
  a301=(a050*a174);
  a269=(a269+a301);
  a301=(a083*a200);
  a269=(a269+a301);
  a269=(a160+a269);
  a301=(a078*a269);
  a217=(a217+a301);
  a301=(a103*a297);
  a235=(a050*a235);
  a301=(a301+a235);
  a235=(a042*a009);
  a249=(a010*a249);
  a172=(a062*a172);
  a249=(a249+a172);
  a127=(a064*a127);
  a249=(a249-a127);
  a148=(a146*a148);
  a174=(a066*a174);
  a148=(a148+a174);
  a249=(a249+a148);
  a148=(a044*a249);
  a235=(a235+a148);
  a235=(a297+a235);
  a148=(a083*a235);
  a301=(a301+a148);
  a301=(a161+a301);
  a148=(a090*a301);
  a217=(a217-a148);
  a148=(a103*a289);
  a261=(a050*a261);
  a148=(a148+a261);
  a261=(a083*a218);
  a148=(a148+a261);
  a148=(a053+a148);
  a261=(a094*a148);
  a174=(a103*a059);
  a026=(a050*a026);
  a174=(a174+a026);
  a026=(a008*a115);
  a127=(a097*a046);
  a026=(a026+a127);
  a127=(a069*a018);
  a026=(a026+a127);
  a127=(a111*a290);
  a172=(a095*a200);
  a127=(a127-a172);
  a026=(a026+a127);
  a127=(a083*a026);
  a174=(a174+a127);
  a174=(a034+a174);
  a127=(a120*a174);
  a261=(a261+a127);
  a217=(a217+a261);
  a261=(a100*a217);
  a004=(a004+a261);
  a004=(a053+a004);
  a261=(a005*a004);
  a037=(a037+a261);
  a261=(a125*a289);
  a127=(a131*a218);
  a261=(a261+a127);
  a127=(a132*a217);
  a261=(a261+a127);
  a127=(a006*a053);
  a172=(a030*a290);
  a127=(a127+a172);
  a172=(a100*a148);
  a127=(a127+a172);
  a127=(a266+a127);
  a172=(a154*a127);
  a025=(a006*a034);
  a015=(a030*a200);
  a025=(a025+a015);
  a015=(a100*a174);
  a025=(a025+a015);
  a025=(a160+a025);
  a015=(a138*a025);
  a172=(a172+a015);
  a015=(a006*a297);
  a268=(a030*a235);
  a015=(a015+a268);
  a268=(a103*a009);
  a249=(a050*a249);
  a268=(a268+a249);
  a115=(a023*a115);
  a046=(a102*a046);
  a115=(a115+a046);
  a018=(a076*a018);
  a115=(a115-a018);
  a018=(a298*a290);
  a046=(a089*a200);
  a018=(a018+a046);
  a115=(a115+a018);
  a018=(a083*a115);
  a268=(a268+a018);
  a268=(a297+a268);
  a018=(a100*a268);
  a015=(a015+a018);
  a015=(a161+a015);
  a018=(a113*a015);
  a172=(a172-a018);
  a018=(a096*a004);
  a046=(a006*a059);
  a249=(a030*a026);
  a046=(a046+a249);
  a249=(a043*a259);
  a309=(a119*a269);
  a249=(a249+a309);
  a309=(a114*a301);
  a249=(a249+a309);
  a309=(a074*a148);
  a188=(a117*a174);
  a309=(a309-a188);
  a249=(a249+a309);
  a309=(a100*a249);
  a046=(a046+a309);
  a046=(a034+a046);
  a309=(a145*a046);
  a018=(a018+a309);
  a172=(a172+a018);
  a018=(a133*a172);
  a261=(a261+a018);
  a261=(a053+a261);
  a018=(a122*a261);
  a037=(a037+a018);
  a018=(a150*a289);
  a309=(a087*a218);
  a018=(a018+a309);
  a309=(a157*a217);
  a018=(a018+a309);
  a309=(a158*a172);
  a018=(a018+a309);
  a309=(a125*a053);
  a188=(a131*a290);
  a309=(a309+a188);
  a188=(a132*a148);
  a309=(a309+a188);
  a188=(a133*a004);
  a309=(a309+a188);
  a309=(a266+a309);
  a188=(a180*a309);
  a101=(a125*a034);
  a056=(a131*a200);
  a101=(a101+a056);
  a056=(a132*a174);
  a101=(a101+a056);
  a056=(a133*a046);
  a101=(a101+a056);
  a101=(a160+a101);
  a056=(a164*a101);
  a188=(a188+a056);
  a056=(a125*a297);
  a206=(a131*a235);
  a056=(a056+a206);
  a206=(a132*a268);
  a056=(a056+a206);
  a206=(a006*a009);
  a027=(a030*a115);
  a206=(a206+a027);
  a259=(a156*a259);
  a269=(a124*a269);
  a259=(a259+a269);
  a301=(a116*a301);
  a259=(a259-a301);
  a301=(a077*a148);
  a269=(a112*a174);
  a301=(a301+a269);
  a259=(a259+a301);
  a301=(a100*a259);
  a206=(a206+a301);
  a206=(a297+a206);
  a301=(a133*a206);
  a056=(a056+a301);
  a056=(a161+a056);
  a301=(a049*a056);
  a188=(a188-a301);
  a301=(a118*a261);
  a269=(a125*a059);
  a027=(a131*a026);
  a269=(a269+a027);
  a027=(a132*a249);
  a269=(a269+a027);
  a027=(a108*a127);
  a234=(a144*a025);
  a027=(a027+a234);
  a234=(a139*a015);
  a027=(a027+a234);
  a234=(a086*a004);
  a178=(a142*a046);
  a234=(a234-a178);
  a027=(a027+a234);
  a234=(a133*a027);
  a269=(a269+a234);
  a269=(a034+a269);
  a234=(a171*a269);
  a301=(a301+a234);
  a188=(a188+a301);
  a301=(a159*a188);
  a018=(a018+a301);
  a018=(a053+a018);
  a301=(a147*a018);
  a037=(a037+a301);
  a301=(a176*a289);
  a234=(a183*a218);
  a301=(a301+a234);
  a234=(a184*a217);
  a301=(a301+a234);
  a234=(a185*a172);
  a301=(a301+a234);
  a234=(a186*a188);
  a301=(a301+a234);
  a234=(a150*a053);
  a178=(a087*a290);
  a234=(a234+a178);
  a178=(a157*a148);
  a234=(a234+a178);
  a178=(a158*a004);
  a234=(a234+a178);
  a178=(a159*a261);
  a234=(a234+a178);
  a234=(a266+a234);
  a178=(a208*a234);
  a308=(a150*a034);
  a304=(a087*a200);
  a308=(a308+a304);
  a304=(a157*a174);
  a308=(a308+a304);
  a304=(a158*a046);
  a308=(a308+a304);
  a304=(a159*a269);
  a308=(a308+a304);
  a308=(a160+a308);
  a304=(a192*a308);
  a178=(a178+a304);
  a304=(a150*a297);
  a081=(a087*a235);
  a304=(a304+a081);
  a081=(a157*a268);
  a304=(a304+a081);
  a081=(a158*a206);
  a304=(a304+a081);
  a081=(a125*a009);
  a300=(a131*a115);
  a081=(a081+a300);
  a300=(a132*a259);
  a081=(a081+a300);
  a127=(a123*a127);
  a025=(a149*a025);
  a127=(a127+a025);
  a015=(a141*a015);
  a127=(a127-a015);
  a015=(a084*a004);
  a025=(a137*a046);
  a015=(a015+a025);
  a127=(a127+a015);
  a015=(a133*a127);
  a081=(a081+a015);
  a081=(a297+a081);
  a015=(a159*a081);
  a304=(a304+a015);
  a304=(a161+a304);
  a015=(a085*a304);
  a178=(a178-a015);
  a015=(a143*a018);
  a025=(a150*a059);
  a300=(a087*a026);
  a025=(a025+a300);
  a300=(a157*a249);
  a025=(a025+a300);
  a300=(a158*a027);
  a025=(a025+a300);
  a300=(a022*a309);
  a068=(a170*a101);
  a300=(a300+a068);
  a068=(a165*a056);
  a300=(a300+a068);
  a068=(a210*a261);
  a253=(a168*a269);
  a068=(a068-a253);
  a300=(a300+a068);
  a068=(a159*a300);
  a025=(a025+a068);
  a025=(a034+a025);
  a068=(a199*a025);
  a015=(a015+a068);
  a178=(a178+a015);
  a015=(a187*a178);
  a301=(a301+a015);
  a301=(a053+a301);
  a015=(a173*a301);
  a037=(a037+a015);
  a015=(a204*a289);
  a068=(a211*a218);
  a015=(a015+a068);
  a068=(a212*a217);
  a015=(a015+a068);
  a068=(a213*a172);
  a015=(a015+a068);
  a068=(a214*a188);
  a015=(a015+a068);
  a068=(a215*a178);
  a015=(a015+a068);
  a068=(a176*a053);
  a253=(a183*a290);
  a068=(a068+a253);
  a253=(a184*a148);
  a068=(a068+a253);
  a253=(a185*a004);
  a068=(a068+a253);
  a253=(a186*a261);
  a068=(a068+a253);
  a253=(a187*a018);
  a068=(a068+a253);
  a068=(a266+a068);
  a253=(a237*a068);
  a152=(a176*a034);
  a075=(a183*a200);
  a152=(a152+a075);
  a075=(a184*a174);
  a152=(a152+a075);
  a075=(a185*a046);
  a152=(a152+a075);
  a075=(a186*a269);
  a152=(a152+a075);
  a075=(a187*a025);
  a152=(a152+a075);
  a152=(a160+a152);
  a075=(a221*a152);
  a253=(a253+a075);
  a075=(a176*a297);
  a033=(a183*a235);
  a075=(a075+a033);
  a033=(a184*a268);
  a075=(a075+a033);
  a033=(a185*a206);
  a075=(a075+a033);
  a033=(a186*a081);
  a075=(a075+a033);
  a033=(a150*a009);
  a016=(a087*a115);
  a033=(a033+a016);
  a016=(a157*a259);
  a033=(a033+a016);
  a016=(a158*a127);
  a033=(a033+a016);
  a309=(a153*a309);
  a101=(a175*a101);
  a309=(a309+a101);
  a056=(a167*a056);
  a309=(a309-a056);
  a056=(a080*a261);
  a101=(a163*a269);
  a056=(a056+a101);
  a309=(a309+a056);
  a056=(a159*a309);
  a033=(a033+a056);
  a033=(a297+a033);
  a056=(a187*a033);
  a075=(a075+a056);
  a075=(a161+a075);
  a056=(a038*a075);
  a253=(a253-a056);
  a056=(a169*a301);
  a101=(a176*a059);
  a016=(a183*a026);
  a101=(a101+a016);
  a016=(a184*a249);
  a101=(a101+a016);
  a016=(a185*a027);
  a101=(a101+a016);
  a016=(a186*a300);
  a101=(a101+a016);
  a016=(a130*a234);
  a202=(a198*a308);
  a016=(a016+a202);
  a202=(a193*a304);
  a016=(a016+a202);
  a202=(a302*a018);
  a105=(a196*a025);
  a202=(a202-a105);
  a016=(a016+a202);
  a202=(a187*a016);
  a101=(a101+a202);
  a101=(a034+a101);
  a202=(a228*a101);
  a056=(a056+a202);
  a253=(a253+a056);
  a056=(a216*a253);
  a015=(a015+a056);
  a015=(a053+a015);
  a056=(a201*a015);
  a037=(a037+a056);
  a056=(a233*a289);
  a202=(a240*a218);
  a056=(a056+a202);
  a202=(a241*a217);
  a056=(a056+a202);
  a202=(a242*a172);
  a056=(a056+a202);
  a202=(a243*a188);
  a056=(a056+a202);
  a202=(a244*a178);
  a056=(a056+a202);
  a202=(a245*a253);
  a056=(a056+a202);
  a202=(a204*a053);
  a105=(a211*a290);
  a202=(a202+a105);
  a105=(a212*a148);
  a202=(a202+a105);
  a105=(a213*a004);
  a202=(a202+a105);
  a105=(a214*a261);
  a202=(a202+a105);
  a105=(a215*a018);
  a202=(a202+a105);
  a105=(a216*a301);
  a202=(a202+a105);
  a202=(a266+a202);
  a105=(a267*a202);
  a231=(a204*a034);
  a136=(a211*a200);
  a231=(a231+a136);
  a136=(a212*a174);
  a231=(a231+a136);
  a136=(a213*a046);
  a231=(a231+a136);
  a136=(a214*a269);
  a231=(a231+a136);
  a136=(a215*a025);
  a231=(a231+a136);
  a136=(a216*a101);
  a231=(a231+a136);
  a231=(a160+a231);
  a136=(a251*a231);
  a105=(a105+a136);
  a136=(a204*a297);
  a071=(a211*a235);
  a136=(a136+a071);
  a071=(a212*a268);
  a136=(a136+a071);
  a071=(a213*a206);
  a136=(a136+a071);
  a071=(a214*a081);
  a136=(a136+a071);
  a071=(a215*a033);
  a136=(a136+a071);
  a071=(a176*a009);
  a205=(a183*a115);
  a071=(a071+a205);
  a205=(a184*a259);
  a071=(a071+a205);
  a205=(a185*a127);
  a071=(a071+a205);
  a205=(a186*a309);
  a071=(a071+a205);
  a234=(a179*a234);
  a308=(a203*a308);
  a234=(a234+a308);
  a304=(a195*a304);
  a234=(a234-a304);
  a304=(a303*a018);
  a308=(a191*a025);
  a304=(a304+a308);
  a234=(a234+a304);
  a304=(a187*a234);
  a071=(a071+a304);
  a071=(a297+a071);
  a304=(a216*a071);
  a136=(a136+a304);
  a136=(a161+a136);
  a304=(a140*a136);
  a105=(a105-a304);
  a304=(a197*a015);
  a308=(a204*a059);
  a205=(a211*a026);
  a308=(a308+a205);
  a205=(a212*a249);
  a308=(a308+a205);
  a205=(a213*a027);
  a308=(a308+a205);
  a205=(a214*a300);
  a308=(a308+a205);
  a205=(a215*a016);
  a308=(a308+a205);
  a205=(a155*a068);
  a072=(a227*a152);
  a205=(a205+a072);
  a072=(a222*a075);
  a205=(a205+a072);
  a072=(a306*a301);
  a134=(a225*a101);
  a072=(a072-a134);
  a205=(a205+a072);
  a072=(a216*a205);
  a308=(a308+a072);
  a308=(a034+a308);
  a072=(a258*a308);
  a304=(a304+a072);
  a105=(a105+a304);
  a304=(a246*a105);
  a056=(a056+a304);
  a056=(a053+a056);
  a304=(a230*a056);
  a037=(a037+a304);
  a304=(a263*a289);
  a218=(a270*a218);
  a304=(a304+a218);
  a217=(a099*a217);
  a304=(a304+a217);
  a217=(a121*a172);
  a304=(a304+a217);
  a217=(a271*a188);
  a304=(a304+a217);
  a217=(a272*a178);
  a304=(a304+a217);
  a217=(a273*a253);
  a304=(a304+a217);
  a217=(a274*a105);
  a304=(a304+a217);
  a217=(a233*a053);
  a218=(a240*a290);
  a217=(a217+a218);
  a218=(a241*a148);
  a217=(a217+a218);
  a218=(a242*a004);
  a217=(a217+a218);
  a218=(a243*a261);
  a217=(a217+a218);
  a218=(a244*a018);
  a217=(a217+a218);
  a218=(a245*a301);
  a217=(a217+a218);
  a218=(a246*a015);
  a217=(a217+a218);
  a217=(a266+a217);
  a218=(a296*a217);
  a072=(a233*a034);
  a134=(a240*a200);
  a072=(a072+a134);
  a134=(a241*a174);
  a072=(a072+a134);
  a134=(a242*a046);
  a072=(a072+a134);
  a134=(a243*a269);
  a072=(a072+a134);
  a134=(a244*a025);
  a072=(a072+a134);
  a134=(a245*a101);
  a072=(a072+a134);
  a134=(a246*a308);
  a072=(a072+a134);
  a072=(a160+a072);
  a134=(a280*a072);
  a218=(a218+a134);
  a134=(a233*a297);
  a305=(a240*a235);
  a134=(a134+a305);
  a305=(a241*a268);
  a134=(a134+a305);
  a305=(a242*a206);
  a134=(a134+a305);
  a305=(a243*a081);
  a134=(a134+a305);
  a305=(a244*a033);
  a134=(a134+a305);
  a305=(a245*a071);
  a134=(a134+a305);
  a305=(a204*a009);
  a126=(a211*a115);
  a305=(a305+a126);
  a126=(a212*a259);
  a305=(a305+a126);
  a126=(a213*a127);
  a305=(a305+a126);
  a126=(a214*a309);
  a305=(a305+a126);
  a126=(a215*a234);
  a305=(a305+a126);
  a068=(a207*a068);
  a152=(a232*a152);
  a068=(a068+a152);
  a075=(a224*a075);
  a068=(a068-a075);
  a075=(a307*a301);
  a152=(a220*a101);
  a075=(a075+a152);
  a068=(a068+a075);
  a075=(a216*a068);
  a305=(a305+a075);
  a305=(a297+a305);
  a075=(a246*a305);
  a134=(a134+a075);
  a134=(a161+a134);
  a075=(a247*a134);
  a218=(a218-a075);
  a075=(a226*a056);
  a152=(a233*a059);
  a126=(a240*a026);
  a152=(a152+a126);
  a126=(a241*a249);
  a152=(a152+a126);
  a126=(a242*a027);
  a152=(a152+a126);
  a126=(a243*a300);
  a152=(a152+a126);
  a126=(a244*a016);
  a152=(a152+a126);
  a126=(a245*a205);
  a152=(a152+a126);
  a126=(a181*a202);
  a000=(a257*a231);
  a126=(a126+a000);
  a000=(a252*a136);
  a126=(a126+a000);
  a000=(a310*a015);
  a151=(a255*a308);
  a000=(a000-a151);
  a126=(a126+a000);
  a000=(a246*a126);
  a152=(a152+a000);
  a152=(a034+a152);
  a000=(a287*a152);
  a075=(a075+a000);
  a218=(a218+a075);
  a075=(a275*a218);
  a304=(a304+a075);
  a304=(a053+a304);
  a075=(a260*a304);
  a037=(a037+a075);
  a037=(a266+a037);
  if (res[0]!=0) res[0][24]=a037;
  a037=(a001*a034);
  a075=(a005*a046);
  a037=(a037+a075);
  a075=(a122*a269);
  a037=(a037+a075);
  a075=(a147*a025);
  a037=(a037+a075);
  a075=(a173*a101);
  a037=(a037+a075);
  a075=(a201*a308);
  a037=(a037+a075);
  a075=(a230*a152);
  a037=(a037+a075);
  a075=(a263*a059);
  a026=(a270*a026);
  a075=(a075+a026);
  a249=(a099*a249);
  a075=(a075+a249);
  a249=(a121*a027);
  a075=(a075+a249);
  a249=(a271*a300);
  a075=(a075+a249);
  a249=(a272*a016);
  a075=(a075+a249);
  a249=(a273*a205);
  a075=(a075+a249);
  a249=(a274*a126);
  a075=(a075+a249);
  a249=(a264*a217);
  a026=(a286*a072);
  a249=(a249+a026);
  a026=(a281*a134);
  a249=(a249+a026);
  a026=(a312*a056);
  a000=(a284*a152);
  a026=(a026-a000);
  a249=(a249+a026);
  a026=(a275*a249);
  a075=(a075+a026);
  a075=(a034+a075);
  a026=(a260*a075);
  a037=(a037+a026);
  a037=(a160+a037);
  if (res[0]!=0) res[0][25]=a037;
  a037=(a001*a297);
  a026=(a005*a206);
  a037=(a037+a026);
  a026=(a122*a081);
  a037=(a037+a026);
  a026=(a147*a033);
  a037=(a037+a026);
  a026=(a173*a071);
  a037=(a037+a026);
  a026=(a201*a305);
  a037=(a037+a026);
  a026=(a233*a009);
  a000=(a240*a115);
  a026=(a026+a000);
  a000=(a241*a259);
  a026=(a026+a000);
  a000=(a242*a127);
  a026=(a026+a000);
  a000=(a243*a309);
  a026=(a026+a000);
  a000=(a244*a234);
  a026=(a026+a000);
  a000=(a245*a068);
  a026=(a026+a000);
  a202=(a236*a202);
  a231=(a262*a231);
  a202=(a202+a231);
  a136=(a254*a136);
  a202=(a202-a136);
  a136=(a311*a015);
  a231=(a250*a308);
  a136=(a136+a231);
  a202=(a202+a136);
  a136=(a246*a202);
  a026=(a026+a136);
  a026=(a297+a026);
  a136=(a230*a026);
  a037=(a037+a136);
  a136=(a263*a009);
  a115=(a270*a115);
  a136=(a136+a115);
  a259=(a099*a259);
  a136=(a136+a259);
  a259=(a121*a127);
  a136=(a136+a259);
  a259=(a271*a309);
  a136=(a136+a259);
  a259=(a272*a234);
  a136=(a136+a259);
  a259=(a273*a068);
  a136=(a136+a259);
  a259=(a274*a202);
  a136=(a136+a259);
  a217=(a106*a217);
  a072=(a291*a072);
  a217=(a217+a072);
  a134=(a283*a134);
  a217=(a217-a134);
  a134=(a313*a056);
  a072=(a279*a152);
  a134=(a134+a072);
  a217=(a217+a134);
  a134=(a275*a217);
  a136=(a136+a134);
  a136=(a297+a136);
  a136=(a260*a136);
  a037=(a037+a136);
  a037=(a161+a037);
  if (res[0]!=0) res[0][26]=a037;
  a289=(a001*a289);
  a172=(a005*a172);
  a289=(a289+a172);
  a188=(a122*a188);
  a289=(a289+a188);
  a178=(a147*a178);
  a289=(a289+a178);
  a253=(a173*a253);
  a289=(a289+a253);
  a105=(a201*a105);
  a289=(a289+a105);
  a218=(a230*a218);
  a289=(a289+a218);
  a218=(a263*a053);
  a290=(a270*a290);
  a218=(a218+a290);
  a148=(a099*a148);
  a218=(a218+a148);
  a004=(a121*a004);
  a218=(a218+a004);
  a261=(a271*a261);
  a218=(a218+a261);
  a018=(a272*a018);
  a218=(a218+a018);
  a301=(a273*a301);
  a218=(a218+a301);
  a015=(a274*a015);
  a218=(a218+a015);
  a056=(a275*a056);
  a218=(a218+a056);
  a266=(a266+a218);
  a218=(a028*a266);
  a056=(a263*a034);
  a200=(a270*a200);
  a056=(a056+a200);
  a174=(a099*a174);
  a056=(a056+a174);
  a046=(a121*a046);
  a056=(a056+a046);
  a269=(a271*a269);
  a056=(a056+a269);
  a025=(a272*a025);
  a056=(a056+a025);
  a101=(a273*a101);
  a056=(a056+a101);
  a308=(a274*a308);
  a056=(a056+a308);
  a152=(a275*a152);
  a056=(a056+a152);
  a160=(a160+a056);
  a056=(a229*a160);
  a218=(a218+a056);
  a056=(a263*a297);
  a235=(a270*a235);
  a056=(a056+a235);
  a268=(a099*a268);
  a056=(a056+a268);
  a206=(a121*a206);
  a056=(a056+a206);
  a081=(a271*a081);
  a056=(a056+a081);
  a033=(a272*a033);
  a056=(a056+a033);
  a071=(a273*a071);
  a056=(a056+a071);
  a305=(a274*a305);
  a056=(a056+a305);
  a026=(a275*a026);
  a056=(a056+a026);
  a161=(a161+a056);
  a056=(a294*a161);
  a218=(a218-a056);
  a056=(a265*a304);
  a026=(a110*a075);
  a056=(a056+a026);
  a218=(a218+a056);
  a218=(a260*a218);
  a289=(a289+a218);
  a053=(a053+a289);
  if (res[0]!=0) res[0][27]=a053;
  a059=(a001*a059);
  a027=(a005*a027);
  a059=(a059+a027);
  a300=(a122*a300);
  a059=(a059+a300);
  a016=(a147*a016);
  a059=(a059+a016);
  a205=(a173*a205);
  a059=(a059+a205);
  a126=(a201*a126);
  a059=(a059+a126);
  a249=(a230*a249);
  a059=(a059+a249);
  a249=(a177*a266);
  a126=(a031*a160);
  a249=(a249+a126);
  a126=(a007*a161);
  a249=(a249+a126);
  a126=(a166*a304);
  a205=(a032*a075);
  a126=(a126-a205);
  a249=(a249+a126);
  a249=(a260*a249);
  a059=(a059+a249);
  a034=(a034+a059);
  if (res[0]!=0) res[0][28]=a034;
  a009=(a001*a009);
  a127=(a005*a127);
  a009=(a009+a127);
  a309=(a122*a309);
  a009=(a009+a309);
  a234=(a147*a234);
  a009=(a009+a234);
  a068=(a173*a068);
  a009=(a009+a068);
  a202=(a201*a202);
  a009=(a009+a202);
  a217=(a230*a217);
  a009=(a009+a217);
  a266=(a003*a266);
  a160=(a299*a160);
  a266=(a266+a160);
  a161=(a040*a161);
  a266=(a266-a161);
  a304=(a135*a304);
  a075=(a017*a075);
  a304=(a304+a075);
  a266=(a266+a304);
  a266=(a260*a266);
  a009=(a009+a266);
  a297=(a297+a009);
  if (res[0]!=0) res[0][29]=a297;
  a297=arg[0]? arg[0][30] : 0;
  a009=arg[0]? arg[0][33] : 0;
  a266=(a001*a009);
  a039=(a039*a297);
  a304=arg[0]? arg[0][31] : 0;
  a012=(a012*a304);
  a039=(a039+a012);
  a012=arg[0]? arg[0][32] : 0;
  a035=(a035*a012);
  a039=(a039-a035);
  a278=(a278*a009);
  a035=arg[0]? arg[0][34] : 0;
  a020=(a020*a035);
  a278=(a278+a020);
  a039=(a039+a278);
  a278=(a006*a039);
  a020=(a042*a009);
  a075=(a045*a039);
  a161=(a048*a009);
  a161=(a297+a161);
  a070=(a070*a161);
  a160=(a048*a035);
  a160=(a304+a160);
  a054=(a054*a160);
  a070=(a070+a054);
  a054=arg[0]? arg[0][35] : 0;
  a217=(a048*a054);
  a217=(a012+a217);
  a162=(a162*a217);
  a070=(a070-a162);
  a162=(a048*a039);
  a162=(a009+a162);
  a292=(a292*a162);
  a189=(a189*a297);
  a019=(a019*a304);
  a189=(a189+a019);
  a248=(a248*a012);
  a189=(a189+a248);
  a219=(a219*a009);
  a029=(a029*a035);
  a219=(a219-a029);
  a189=(a189+a219);
  a219=(a048*a189);
  a219=(a035+a219);
  a061=(a061*a219);
  a292=(a292+a061);
  a070=(a070+a292);
  a070=(a047*a070);
  a075=(a075+a070);
  a075=(a009+a075);
  a070=(a044*a075);
  a020=(a020+a070);
  a020=(a297+a020);
  a107=(a107*a020);
  a070=(a042*a035);
  a292=(a045*a189);
  a013=(a013*a161);
  a060=(a060*a160);
  a013=(a013+a060);
  a055=(a055*a217);
  a013=(a013+a055);
  a041=(a041*a162);
  a058=(a058*a219);
  a041=(a041-a058);
  a013=(a013+a041);
  a013=(a047*a013);
  a292=(a292+a013);
  a292=(a035+a292);
  a013=(a044*a292);
  a070=(a070+a013);
  a070=(a304+a070);
  a091=(a091*a070);
  a107=(a107+a091);
  a091=(a042*a054);
  a277=(a277*a297);
  a024=(a024*a304);
  a277=(a277+a024);
  a014=(a014*a012);
  a277=(a277-a014);
  a190=(a190*a009);
  a011=(a011*a035);
  a190=(a190+a011);
  a277=(a277+a190);
  a190=(a045*a277);
  a092=(a092*a161);
  a065=(a065*a160);
  a092=(a092+a065);
  a057=(a057*a217);
  a092=(a092-a057);
  a002=(a002*a162);
  a052=(a052*a219);
  a002=(a002+a052);
  a092=(a092+a002);
  a092=(a047*a092);
  a190=(a190+a092);
  a190=(a054+a190);
  a092=(a044*a190);
  a091=(a091+a092);
  a091=(a012+a091);
  a067=(a067*a091);
  a107=(a107-a067);
  a067=(a042*a039);
  a092=(a045*a009);
  a162=(a047*a162);
  a092=(a092+a162);
  a092=(a297+a092);
  a088=(a088*a092);
  a162=(a045*a035);
  a219=(a047*a219);
  a162=(a162+a219);
  a162=(a304+a162);
  a079=(a079*a162);
  a088=(a088+a079);
  a045=(a045*a054);
  a048=(a048*a277);
  a048=(a054+a048);
  a047=(a047*a048);
  a045=(a045+a047);
  a045=(a012+a045);
  a093=(a093*a045);
  a088=(a088-a093);
  a182=(a182*a075);
  a051=(a051*a292);
  a182=(a182+a051);
  a088=(a088+a182);
  a182=(a044*a088);
  a067=(a067+a182);
  a067=(a009+a067);
  a021=(a021*a067);
  a182=(a042*a189);
  a239=(a239*a092);
  a063=(a063*a162);
  a239=(a239+a063);
  a073=(a073*a045);
  a239=(a239+a073);
  a109=(a109*a075);
  a082=(a082*a292);
  a109=(a109-a082);
  a239=(a239+a109);
  a109=(a044*a239);
  a182=(a182+a109);
  a182=(a035+a182);
  a098=(a098*a182);
  a021=(a021+a098);
  a107=(a107+a021);
  a021=(a030*a107);
  a278=(a278+a021);
  a021=(a103*a009);
  a098=(a050*a075);
  a021=(a021+a098);
  a098=(a083*a067);
  a021=(a021+a098);
  a021=(a297+a021);
  a129=(a129*a021);
  a098=(a103*a035);
  a109=(a050*a292);
  a098=(a098+a109);
  a109=(a083*a182);
  a098=(a098+a109);
  a098=(a304+a098);
  a078=(a078*a098);
  a129=(a129+a078);
  a078=(a103*a054);
  a190=(a050*a190);
  a078=(a078+a190);
  a042=(a042*a277);
  a010=(a010*a092);
  a062=(a062*a162);
  a010=(a010+a062);
  a064=(a064*a045);
  a010=(a010-a064);
  a146=(a146*a075);
  a066=(a066*a292);
  a146=(a146+a066);
  a010=(a010+a146);
  a044=(a044*a010);
  a042=(a042+a044);
  a042=(a054+a042);
  a044=(a083*a042);
  a078=(a078+a044);
  a078=(a012+a078);
  a090=(a090*a078);
  a129=(a129-a090);
  a090=(a103*a039);
  a088=(a050*a088);
  a090=(a090+a088);
  a088=(a083*a107);
  a090=(a090+a088);
  a090=(a009+a090);
  a094=(a094*a090);
  a088=(a103*a189);
  a239=(a050*a239);
  a088=(a088+a239);
  a008=(a008*a020);
  a097=(a097*a070);
  a008=(a008+a097);
  a069=(a069*a091);
  a008=(a008+a069);
  a111=(a111*a067);
  a095=(a095*a182);
  a111=(a111-a095);
  a008=(a008+a111);
  a111=(a083*a008);
  a088=(a088+a111);
  a088=(a035+a088);
  a120=(a120*a088);
  a094=(a094+a120);
  a129=(a129+a094);
  a094=(a100*a129);
  a278=(a278+a094);
  a278=(a009+a278);
  a094=(a005*a278);
  a266=(a266+a094);
  a094=(a125*a039);
  a120=(a131*a107);
  a094=(a094+a120);
  a120=(a132*a129);
  a094=(a094+a120);
  a120=(a006*a009);
  a111=(a030*a067);
  a120=(a120+a111);
  a111=(a100*a090);
  a120=(a120+a111);
  a120=(a297+a120);
  a154=(a154*a120);
  a111=(a006*a035);
  a095=(a030*a182);
  a111=(a111+a095);
  a095=(a100*a088);
  a111=(a111+a095);
  a111=(a304+a111);
  a138=(a138*a111);
  a154=(a154+a138);
  a138=(a006*a054);
  a095=(a030*a042);
  a138=(a138+a095);
  a103=(a103*a277);
  a050=(a050*a010);
  a103=(a103+a050);
  a023=(a023*a020);
  a102=(a102*a070);
  a023=(a023+a102);
  a076=(a076*a091);
  a023=(a023-a076);
  a298=(a298*a067);
  a089=(a089*a182);
  a298=(a298+a089);
  a023=(a023+a298);
  a083=(a083*a023);
  a103=(a103+a083);
  a103=(a054+a103);
  a083=(a100*a103);
  a138=(a138+a083);
  a138=(a012+a138);
  a113=(a113*a138);
  a154=(a154-a113);
  a096=(a096*a278);
  a113=(a006*a189);
  a083=(a030*a008);
  a113=(a113+a083);
  a043=(a043*a021);
  a119=(a119*a098);
  a043=(a043+a119);
  a114=(a114*a078);
  a043=(a043+a114);
  a074=(a074*a090);
  a117=(a117*a088);
  a074=(a074-a117);
  a043=(a043+a074);
  a074=(a100*a043);
  a113=(a113+a074);
  a113=(a035+a113);
  a145=(a145*a113);
  a096=(a096+a145);
  a154=(a154+a096);
  a096=(a133*a154);
  a094=(a094+a096);
  a094=(a009+a094);
  a096=(a122*a094);
  a266=(a266+a096);
  a096=(a150*a039);
  a145=(a087*a107);
  a096=(a096+a145);
  a145=(a157*a129);
  a096=(a096+a145);
  a145=(a158*a154);
  a096=(a096+a145);
  a145=(a125*a009);
  a074=(a131*a067);
  a145=(a145+a074);
  a074=(a132*a090);
  a145=(a145+a074);
  a074=(a133*a278);
  a145=(a145+a074);
  a145=(a297+a145);
  a180=(a180*a145);
  a074=(a125*a035);
  a117=(a131*a182);
  a074=(a074+a117);
  a117=(a132*a088);
  a074=(a074+a117);
  a117=(a133*a113);
  a074=(a074+a117);
  a074=(a304+a074);
  a164=(a164*a074);
  a180=(a180+a164);
  a164=(a125*a054);
  a117=(a131*a042);
  a164=(a164+a117);
  a117=(a132*a103);
  a164=(a164+a117);
  a006=(a006*a277);
  a030=(a030*a023);
  a006=(a006+a030);
  a156=(a156*a021);
  a124=(a124*a098);
  a156=(a156+a124);
  a116=(a116*a078);
  a156=(a156-a116);
  a077=(a077*a090);
  a112=(a112*a088);
  a077=(a077+a112);
  a156=(a156+a077);
  a100=(a100*a156);
  a006=(a006+a100);
  a006=(a054+a006);
  a100=(a133*a006);
  a164=(a164+a100);
  a164=(a012+a164);
  a049=(a049*a164);
  a180=(a180-a049);
  a118=(a118*a094);
  a049=(a125*a189);
  a100=(a131*a008);
  a049=(a049+a100);
  a100=(a132*a043);
  a049=(a049+a100);
  a108=(a108*a120);
  a144=(a144*a111);
  a108=(a108+a144);
  a139=(a139*a138);
  a108=(a108+a139);
  a086=(a086*a278);
  a142=(a142*a113);
  a086=(a086-a142);
  a108=(a108+a086);
  a086=(a133*a108);
  a049=(a049+a086);
  a049=(a035+a049);
  a171=(a171*a049);
  a118=(a118+a171);
  a180=(a180+a118);
  a118=(a159*a180);
  a096=(a096+a118);
  a096=(a009+a096);
  a118=(a147*a096);
  a266=(a266+a118);
  a118=(a176*a039);
  a171=(a183*a107);
  a118=(a118+a171);
  a171=(a184*a129);
  a118=(a118+a171);
  a171=(a185*a154);
  a118=(a118+a171);
  a171=(a186*a180);
  a118=(a118+a171);
  a171=(a150*a009);
  a086=(a087*a067);
  a171=(a171+a086);
  a086=(a157*a090);
  a171=(a171+a086);
  a086=(a158*a278);
  a171=(a171+a086);
  a086=(a159*a094);
  a171=(a171+a086);
  a171=(a297+a171);
  a208=(a208*a171);
  a086=(a150*a035);
  a142=(a087*a182);
  a086=(a086+a142);
  a142=(a157*a088);
  a086=(a086+a142);
  a142=(a158*a113);
  a086=(a086+a142);
  a142=(a159*a049);
  a086=(a086+a142);
  a086=(a304+a086);
  a192=(a192*a086);
  a208=(a208+a192);
  a192=(a150*a054);
  a142=(a087*a042);
  a192=(a192+a142);
  a142=(a157*a103);
  a192=(a192+a142);
  a142=(a158*a006);
  a192=(a192+a142);
  a125=(a125*a277);
  a131=(a131*a023);
  a125=(a125+a131);
  a132=(a132*a156);
  a125=(a125+a132);
  a123=(a123*a120);
  a149=(a149*a111);
  a123=(a123+a149);
  a141=(a141*a138);
  a123=(a123-a141);
  a084=(a084*a278);
  a137=(a137*a113);
  a084=(a084+a137);
  a123=(a123+a084);
  a133=(a133*a123);
  a125=(a125+a133);
  a125=(a054+a125);
  a133=(a159*a125);
  a192=(a192+a133);
  a192=(a012+a192);
  a085=(a085*a192);
  a208=(a208-a085);
  a143=(a143*a096);
  a085=(a150*a189);
  a133=(a087*a008);
  a085=(a085+a133);
  a133=(a157*a043);
  a085=(a085+a133);
  a133=(a158*a108);
  a085=(a085+a133);
  a022=(a022*a145);
  a170=(a170*a074);
  a022=(a022+a170);
  a165=(a165*a164);
  a022=(a022+a165);
  a210=(a210*a094);
  a168=(a168*a049);
  a210=(a210-a168);
  a022=(a022+a210);
  a210=(a159*a022);
  a085=(a085+a210);
  a085=(a035+a085);
  a199=(a199*a085);
  a143=(a143+a199);
  a208=(a208+a143);
  a143=(a187*a208);
  a118=(a118+a143);
  a118=(a009+a118);
  a143=(a173*a118);
  a266=(a266+a143);
  a143=(a204*a039);
  a199=(a211*a107);
  a143=(a143+a199);
  a199=(a212*a129);
  a143=(a143+a199);
  a199=(a213*a154);
  a143=(a143+a199);
  a199=(a214*a180);
  a143=(a143+a199);
  a199=(a215*a208);
  a143=(a143+a199);
  a199=(a176*a009);
  a210=(a183*a067);
  a199=(a199+a210);
  a210=(a184*a090);
  a199=(a199+a210);
  a210=(a185*a278);
  a199=(a199+a210);
  a210=(a186*a094);
  a199=(a199+a210);
  a210=(a187*a096);
  a199=(a199+a210);
  a199=(a297+a199);
  a237=(a237*a199);
  a210=(a176*a035);
  a168=(a183*a182);
  a210=(a210+a168);
  a168=(a184*a088);
  a210=(a210+a168);
  a168=(a185*a113);
  a210=(a210+a168);
  a168=(a186*a049);
  a210=(a210+a168);
  a168=(a187*a085);
  a210=(a210+a168);
  a210=(a304+a210);
  a221=(a221*a210);
  a237=(a237+a221);
  a221=(a176*a054);
  a168=(a183*a042);
  a221=(a221+a168);
  a168=(a184*a103);
  a221=(a221+a168);
  a168=(a185*a006);
  a221=(a221+a168);
  a168=(a186*a125);
  a221=(a221+a168);
  a150=(a150*a277);
  a087=(a087*a023);
  a150=(a150+a087);
  a157=(a157*a156);
  a150=(a150+a157);
  a158=(a158*a123);
  a150=(a150+a158);
  a153=(a153*a145);
  a175=(a175*a074);
  a153=(a153+a175);
  a167=(a167*a164);
  a153=(a153-a167);
  a080=(a080*a094);
  a163=(a163*a049);
  a080=(a080+a163);
  a153=(a153+a080);
  a159=(a159*a153);
  a150=(a150+a159);
  a150=(a054+a150);
  a159=(a187*a150);
  a221=(a221+a159);
  a221=(a012+a221);
  a038=(a038*a221);
  a237=(a237-a038);
  a169=(a169*a118);
  a038=(a176*a189);
  a159=(a183*a008);
  a038=(a038+a159);
  a159=(a184*a043);
  a038=(a038+a159);
  a159=(a185*a108);
  a038=(a038+a159);
  a159=(a186*a022);
  a038=(a038+a159);
  a130=(a130*a171);
  a198=(a198*a086);
  a130=(a130+a198);
  a193=(a193*a192);
  a130=(a130+a193);
  a302=(a302*a096);
  a196=(a196*a085);
  a302=(a302-a196);
  a130=(a130+a302);
  a302=(a187*a130);
  a038=(a038+a302);
  a038=(a035+a038);
  a228=(a228*a038);
  a169=(a169+a228);
  a237=(a237+a169);
  a169=(a216*a237);
  a143=(a143+a169);
  a143=(a009+a143);
  a169=(a201*a143);
  a266=(a266+a169);
  a169=(a233*a039);
  a228=(a240*a107);
  a169=(a169+a228);
  a228=(a241*a129);
  a169=(a169+a228);
  a228=(a242*a154);
  a169=(a169+a228);
  a228=(a243*a180);
  a169=(a169+a228);
  a228=(a244*a208);
  a169=(a169+a228);
  a228=(a245*a237);
  a169=(a169+a228);
  a228=(a204*a009);
  a302=(a211*a067);
  a228=(a228+a302);
  a302=(a212*a090);
  a228=(a228+a302);
  a302=(a213*a278);
  a228=(a228+a302);
  a302=(a214*a094);
  a228=(a228+a302);
  a302=(a215*a096);
  a228=(a228+a302);
  a302=(a216*a118);
  a228=(a228+a302);
  a228=(a297+a228);
  a267=(a267*a228);
  a302=(a204*a035);
  a196=(a211*a182);
  a302=(a302+a196);
  a196=(a212*a088);
  a302=(a302+a196);
  a196=(a213*a113);
  a302=(a302+a196);
  a196=(a214*a049);
  a302=(a302+a196);
  a196=(a215*a085);
  a302=(a302+a196);
  a196=(a216*a038);
  a302=(a302+a196);
  a302=(a304+a302);
  a251=(a251*a302);
  a267=(a267+a251);
  a251=(a204*a054);
  a196=(a211*a042);
  a251=(a251+a196);
  a196=(a212*a103);
  a251=(a251+a196);
  a196=(a213*a006);
  a251=(a251+a196);
  a196=(a214*a125);
  a251=(a251+a196);
  a196=(a215*a150);
  a251=(a251+a196);
  a176=(a176*a277);
  a183=(a183*a023);
  a176=(a176+a183);
  a184=(a184*a156);
  a176=(a176+a184);
  a185=(a185*a123);
  a176=(a176+a185);
  a186=(a186*a153);
  a176=(a176+a186);
  a179=(a179*a171);
  a203=(a203*a086);
  a179=(a179+a203);
  a195=(a195*a192);
  a179=(a179-a195);
  a303=(a303*a096);
  a191=(a191*a085);
  a303=(a303+a191);
  a179=(a179+a303);
  a187=(a187*a179);
  a176=(a176+a187);
  a176=(a054+a176);
  a187=(a216*a176);
  a251=(a251+a187);
  a251=(a012+a251);
  a140=(a140*a251);
  a267=(a267-a140);
  a197=(a197*a143);
  a140=(a204*a189);
  a187=(a211*a008);
  a140=(a140+a187);
  a187=(a212*a043);
  a140=(a140+a187);
  a187=(a213*a108);
  a140=(a140+a187);
  a187=(a214*a022);
  a140=(a140+a187);
  a187=(a215*a130);
  a140=(a140+a187);
  a155=(a155*a199);
  a227=(a227*a210);
  a155=(a155+a227);
  a222=(a222*a221);
  a155=(a155+a222);
  a306=(a306*a118);
  a225=(a225*a038);
  a306=(a306-a225);
  a155=(a155+a306);
  a306=(a216*a155);
  a140=(a140+a306);
  a140=(a035+a140);
  a258=(a258*a140);
  a197=(a197+a258);
  a267=(a267+a197);
  a197=(a246*a267);
  a169=(a169+a197);
  a169=(a009+a169);
  a197=(a230*a169);
  a266=(a266+a197);
  a197=(a263*a039);
  a107=(a270*a107);
  a197=(a197+a107);
  a129=(a099*a129);
  a197=(a197+a129);
  a129=(a121*a154);
  a197=(a197+a129);
  a129=(a271*a180);
  a197=(a197+a129);
  a129=(a272*a208);
  a197=(a197+a129);
  a129=(a273*a237);
  a197=(a197+a129);
  a129=(a274*a267);
  a197=(a197+a129);
  a129=(a233*a009);
  a107=(a240*a067);
  a129=(a129+a107);
  a107=(a241*a090);
  a129=(a129+a107);
  a107=(a242*a278);
  a129=(a129+a107);
  a107=(a243*a094);
  a129=(a129+a107);
  a107=(a244*a096);
  a129=(a129+a107);
  a107=(a245*a118);
  a129=(a129+a107);
  a107=(a246*a143);
  a129=(a129+a107);
  a129=(a297+a129);
  a296=(a296*a129);
  a107=(a233*a035);
  a258=(a240*a182);
  a107=(a107+a258);
  a258=(a241*a088);
  a107=(a107+a258);
  a258=(a242*a113);
  a107=(a107+a258);
  a258=(a243*a049);
  a107=(a107+a258);
  a258=(a244*a085);
  a107=(a107+a258);
  a258=(a245*a038);
  a107=(a107+a258);
  a258=(a246*a140);
  a107=(a107+a258);
  a107=(a304+a107);
  a280=(a280*a107);
  a296=(a296+a280);
  a280=(a233*a054);
  a258=(a240*a042);
  a280=(a280+a258);
  a258=(a241*a103);
  a280=(a280+a258);
  a258=(a242*a006);
  a280=(a280+a258);
  a258=(a243*a125);
  a280=(a280+a258);
  a258=(a244*a150);
  a280=(a280+a258);
  a258=(a245*a176);
  a280=(a280+a258);
  a204=(a204*a277);
  a211=(a211*a023);
  a204=(a204+a211);
  a212=(a212*a156);
  a204=(a204+a212);
  a213=(a213*a123);
  a204=(a204+a213);
  a214=(a214*a153);
  a204=(a204+a214);
  a215=(a215*a179);
  a204=(a204+a215);
  a207=(a207*a199);
  a232=(a232*a210);
  a207=(a207+a232);
  a224=(a224*a221);
  a207=(a207-a224);
  a307=(a307*a118);
  a220=(a220*a038);
  a307=(a307+a220);
  a207=(a207+a307);
  a216=(a216*a207);
  a204=(a204+a216);
  a204=(a054+a204);
  a216=(a246*a204);
  a280=(a280+a216);
  a280=(a012+a280);
  a247=(a247*a280);
  a296=(a296-a247);
  a226=(a226*a169);
  a247=(a233*a189);
  a216=(a240*a008);
  a247=(a247+a216);
  a216=(a241*a043);
  a247=(a247+a216);
  a216=(a242*a108);
  a247=(a247+a216);
  a216=(a243*a022);
  a247=(a247+a216);
  a216=(a244*a130);
  a247=(a247+a216);
  a216=(a245*a155);
  a247=(a247+a216);
  a181=(a181*a228);
  a257=(a257*a302);
  a181=(a181+a257);
  a252=(a252*a251);
  a181=(a181+a252);
  a310=(a310*a143);
  a255=(a255*a140);
  a310=(a310-a255);
  a181=(a181+a310);
  a310=(a246*a181);
  a247=(a247+a310);
  a247=(a035+a247);
  a287=(a287*a247);
  a226=(a226+a287);
  a296=(a296+a226);
  a226=(a275*a296);
  a197=(a197+a226);
  a197=(a009+a197);
  a226=(a260*a197);
  a266=(a266+a226);
  a266=(a297+a266);
  if (res[0]!=0) res[0][30]=a266;
  a266=(a001*a035);
  a226=(a005*a113);
  a266=(a266+a226);
  a226=(a122*a049);
  a266=(a266+a226);
  a226=(a147*a085);
  a266=(a266+a226);
  a226=(a173*a038);
  a266=(a266+a226);
  a226=(a201*a140);
  a266=(a266+a226);
  a226=(a230*a247);
  a266=(a266+a226);
  a226=(a263*a189);
  a008=(a270*a008);
  a226=(a226+a008);
  a043=(a099*a043);
  a226=(a226+a043);
  a043=(a121*a108);
  a226=(a226+a043);
  a043=(a271*a022);
  a226=(a226+a043);
  a043=(a272*a130);
  a226=(a226+a043);
  a043=(a273*a155);
  a226=(a226+a043);
  a043=(a274*a181);
  a226=(a226+a043);
  a264=(a264*a129);
  a286=(a286*a107);
  a264=(a264+a286);
  a281=(a281*a280);
  a264=(a264+a281);
  a312=(a312*a169);
  a284=(a284*a247);
  a312=(a312-a284);
  a264=(a264+a312);
  a312=(a275*a264);
  a226=(a226+a312);
  a226=(a035+a226);
  a312=(a260*a226);
  a266=(a266+a312);
  a266=(a304+a266);
  if (res[0]!=0) res[0][31]=a266;
  a266=(a001*a054);
  a312=(a005*a006);
  a266=(a266+a312);
  a312=(a122*a125);
  a266=(a266+a312);
  a312=(a147*a150);
  a266=(a266+a312);
  a312=(a173*a176);
  a266=(a266+a312);
  a312=(a201*a204);
  a266=(a266+a312);
  a233=(a233*a277);
  a240=(a240*a023);
  a233=(a233+a240);
  a241=(a241*a156);
  a233=(a233+a241);
  a242=(a242*a123);
  a233=(a233+a242);
  a243=(a243*a153);
  a233=(a233+a243);
  a244=(a244*a179);
  a233=(a233+a244);
  a245=(a245*a207);
  a233=(a233+a245);
  a236=(a236*a228);
  a262=(a262*a302);
  a236=(a236+a262);
  a254=(a254*a251);
  a236=(a236-a254);
  a311=(a311*a143);
  a250=(a250*a140);
  a311=(a311+a250);
  a236=(a236+a311);
  a246=(a246*a236);
  a233=(a233+a246);
  a233=(a054+a233);
  a246=(a230*a233);
  a266=(a266+a246);
  a246=(a263*a277);
  a023=(a270*a023);
  a246=(a246+a023);
  a156=(a099*a156);
  a246=(a246+a156);
  a156=(a121*a123);
  a246=(a246+a156);
  a156=(a271*a153);
  a246=(a246+a156);
  a156=(a272*a179);
  a246=(a246+a156);
  a156=(a273*a207);
  a246=(a246+a156);
  a156=(a274*a236);
  a246=(a246+a156);
  a106=(a106*a129);
  a291=(a291*a107);
  a106=(a106+a291);
  a283=(a283*a280);
  a106=(a106-a283);
  a313=(a313*a169);
  a279=(a279*a247);
  a313=(a313+a279);
  a106=(a106+a313);
  a313=(a275*a106);
  a246=(a246+a313);
  a246=(a054+a246);
  a246=(a260*a246);
  a266=(a266+a246);
  a266=(a012+a266);
  if (res[0]!=0) res[0][32]=a266;
  a039=(a001*a039);
  a154=(a005*a154);
  a039=(a039+a154);
  a180=(a122*a180);
  a039=(a039+a180);
  a208=(a147*a208);
  a039=(a039+a208);
  a237=(a173*a237);
  a039=(a039+a237);
  a267=(a201*a267);
  a039=(a039+a267);
  a296=(a230*a296);
  a039=(a039+a296);
  a296=(a263*a009);
  a067=(a270*a067);
  a296=(a296+a067);
  a090=(a099*a090);
  a296=(a296+a090);
  a278=(a121*a278);
  a296=(a296+a278);
  a094=(a271*a094);
  a296=(a296+a094);
  a096=(a272*a096);
  a296=(a296+a096);
  a118=(a273*a118);
  a296=(a296+a118);
  a143=(a274*a143);
  a296=(a296+a143);
  a169=(a275*a169);
  a296=(a296+a169);
  a297=(a297+a296);
  a028=(a028*a297);
  a296=(a263*a035);
  a182=(a270*a182);
  a296=(a296+a182);
  a088=(a099*a088);
  a296=(a296+a088);
  a113=(a121*a113);
  a296=(a296+a113);
  a049=(a271*a049);
  a296=(a296+a049);
  a085=(a272*a085);
  a296=(a296+a085);
  a038=(a273*a038);
  a296=(a296+a038);
  a140=(a274*a140);
  a296=(a296+a140);
  a247=(a275*a247);
  a296=(a296+a247);
  a304=(a304+a296);
  a229=(a229*a304);
  a028=(a028+a229);
  a263=(a263*a054);
  a270=(a270*a042);
  a263=(a263+a270);
  a099=(a099*a103);
  a263=(a263+a099);
  a121=(a121*a006);
  a263=(a263+a121);
  a271=(a271*a125);
  a263=(a263+a271);
  a272=(a272*a150);
  a263=(a263+a272);
  a273=(a273*a176);
  a263=(a263+a273);
  a274=(a274*a204);
  a263=(a263+a274);
  a275=(a275*a233);
  a263=(a263+a275);
  a012=(a012+a263);
  a294=(a294*a012);
  a028=(a028-a294);
  a265=(a265*a197);
  a110=(a110*a226);
  a265=(a265+a110);
  a028=(a028+a265);
  a028=(a260*a028);
  a039=(a039+a028);
  a009=(a009+a039);
  if (res[0]!=0) res[0][33]=a009;
  a189=(a001*a189);
  a108=(a005*a108);
  a189=(a189+a108);
  a022=(a122*a022);
  a189=(a189+a022);
  a130=(a147*a130);
  a189=(a189+a130);
  a155=(a173*a155);
  a189=(a189+a155);
  a181=(a201*a181);
  a189=(a189+a181);
  a264=(a230*a264);
  a189=(a189+a264);
  a177=(a177*a297);
  a031=(a031*a304);
  a177=(a177+a031);
  a007=(a007*a012);
  a177=(a177+a007);
  a166=(a166*a197);
  a032=(a032*a226);
  a166=(a166-a032);
  a177=(a177+a166);
  a177=(a260*a177);
  a189=(a189+a177);
  a035=(a035+a189);
  if (res[0]!=0) res[0][34]=a035;
  a001=(a001*a277);
  a005=(a005*a123);
  a001=(a001+a005);
  a122=(a122*a153);
  a001=(a001+a122);
  a147=(a147*a179);
  a001=(a001+a147);
  a173=(a173*a207);
  a001=(a001+a173);
  a201=(a201*a236);
  a001=(a001+a201);
  a230=(a230*a106);
  a001=(a001+a230);
  a003=(a003*a297);
  a299=(a299*a304);
  a003=(a003+a299);
  a040=(a040*a012);
  a003=(a003-a040);
  a135=(a135*a197);
  a017=(a017*a226);
  a135=(a135+a017);
  a003=(a003+a135);
  a260=(a260*a003);
  a001=(a001+a260);
  a054=(a054+a001);
  if (res[0]!=0) res[0][35]=a054;
  return 0;
}

/* variational_steps:(y[6x6],t,h,p[8])->(y_end[6x6]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+314, w1, w2, *w4=w+350, w5;
  const casadi_real **arg1=arg+4, *wr0, *wr3;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[2][0] */
  w2 = arg[2] ? arg[2][0] : 0;
  /* #3: @3 = input[3][0] */
  wr3 = arg[3] ? arg[3] : casadi_zeros;
  /* #4: @4 = variational_step(@0, @1, @2, @3) */
  arg1[0]=wr0;
  arg1[1]=(&w1);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = (@1+@2) */
  w5  = (w1+w2);
  /* #6: @0 = variational_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #7: @5 = (2.*@2) */
  w5 = (2.* w2 );
  /* #8: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #9: @4 = variational_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 3 */
  w5 = 3.;
  /* #11: @5 = (@5*@2) */
  w5 *= w2;
  /* #12: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #13: @0 = variational_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 4 */
  w5 = 4.;
  /* #15: @5 = (@5*@2) */
  w5 *= w2;
  /* #16: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #17: @4 = variational_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #18: @5 = 5 */
  w5 = 5.;
  /* #19: @5 = (@5*@2) */
  w5 *= w2;
  /* #20: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #21: @0 = variational_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #22: @5 = 6 */
  w5 = 6.;
  /* #23: @5 = (@5*@2) */
  w5 *= w2;
  /* #24: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #25: @4 = variational_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 7 */
  w5 = 7.;
  /* #27: @5 = (@5*@2) */
  w5 *= w2;
  /* #28: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #29: @0 = variational_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 8 */
  w5 = 8.;
  /* #31: @5 = (@5*@2) */
  w5 *= w2;
  /* #32: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #33: @4 = variational_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #34: @5 = 9 */
  w5 = 9.;
  /* #35: @5 = (@5*@2) */
  w5 *= w2;
  /* #36: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #37: @0 = variational_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #38: @5 = 10 */
  w5 = 10.;
  /* #39: @5 = (@5*@2) */
  w5 *= w2;
  /* #40: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #41: @4 = variational_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #42: @5 = 11 */
  w5 = 11.;
  /* #43: @5 = (@5*@2) */
  w5 *= w2;
  /* #44: @1 = (@1+@5) */
  w1 += w5;
  /* #45: @0 = variational_step(@4, @1, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w1);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @0 */
  casadi_copy(w0, 36, res[0]);
  return 0;
}

/* landing_with_derivative:(y[6x6],z[5],T,p[8])->(J[6x6],R[6]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43;
  a00=arg[0]? arg[0][6] : 0;
  a01=arg[0]? arg[0][7] : 0;
  a02=(a00-a01);
  a03=1.;
  a02=(a02-a03);
  if (res[0]!=0) res[0][0]=a02;
  a02=arg[3]? arg[3][1] : 0;
  a04=arg[0]? arg[0][0] : 0;
  a05=arg[0]? arg[0][1] : 0;
  a06=(a04-a05);
  a07=cos(a06);
  a07=(a02*a07);
  a08=arg[3]? arg[3][3] : 0;
  a09=(2.*a08);
  a10=cos(a05);
  a11=(a03-a10);
  a11=(a09*a11);
  a11=(a11+a03);
  a12=(a07/a11);
  a13=arg[0]? arg[0][3] : 0;
  a14=sin(a04);
  a15=(a13*a14);
  a15=(a02*a15);
  a16=arg[0]? arg[0][5] : 0;
  a17=(a07*a16);
  a18=(a10*a13);
  a17=(a17-a18);
  a18=sin(a06);
  a19=(a02*a18);
  a20=(a19/a11);
  a21=(a17*a20);
  a22=(a16*a19);
  a23=(a12*a22);
  a21=(a21+a23);
  a15=(a15+a21);
  a21=(a10-a03);
  a21=(a08*a21);
  a23=(a21-a03);
  a24=(a23/a11);
  a25=(a24*a17);
  a25=(a17+a25);
  a26=(a23*a20);
  a26=(a19+a26);
  a27=(a08+a03);
  a28=(a23*a24);
  a27=(a27-a28);
  a28=(a26/a27);
  a29=(a25*a28);
  a30=(a23*a12);
  a30=(a07+a30);
  a31=(a30/a27);
  a32=(a24*a22);
  a32=(a22+a32);
  a33=(a31*a32);
  a29=(a29+a33);
  a15=(a15+a29);
  a29=(a07*a12);
  a29=(a02-a29);
  a33=(a30*a31);
  a29=(a29-a33);
  a15=(a15/a29);
  a33=cos(a04);
  a34=(a33*a13);
  a34=(a16-a34);
  a34=(a02*a34);
  a35=(a12*a17);
  a34=(a34-a35);
  a35=(a31*a25);
  a34=(a34-a35);
  a34=(a34/a29);
  a35=(a34/a29);
  a36=(a12*a19);
  a37=(a07*a20);
  a37=(a36+a37);
  a26=(a31*a26);
  a38=(a30*a28);
  a26=(a26+a38);
  a37=(a37+a26);
  a37=(a35*a37);
  a15=(a15-a37);
  a37=(a12*a15);
  a26=(a34*a20);
  a37=(a37-a26);
  a26=(a22/a11);
  a32=(a32/a27);
  a38=(a31*a15);
  a28=(a34*a28);
  a38=(a38-a28);
  a32=(a32+a38);
  a38=(a24*a32);
  a26=(a26+a38);
  a37=(a37+a26);
  a37=(a37+a32);
  a26=(a37*a00);
  a38=(a12/a11);
  a28=sin(a05);
  a09=(a09*a28);
  a38=(a38*a09);
  a20=(a20-a38);
  a38=(a34*a20);
  a39=(a07*a20);
  a36=(a36+a39);
  a39=(a23*a20);
  a40=(a08*a28);
  a41=(a12*a40);
  a39=(a39-a41);
  a19=(a19+a39);
  a39=(a31*a19);
  a19=(a19/a27);
  a41=(a31/a27);
  a42=(a24*a40);
  a40=(a40/a11);
  a43=(a24/a11);
  a43=(a43*a09);
  a40=(a40+a43);
  a23=(a23*a40);
  a42=(a42+a23);
  a41=(a41*a42);
  a19=(a19-a41);
  a30=(a30*a19);
  a39=(a39+a30);
  a36=(a36+a39);
  a35=(a35*a36);
  a20=(a17*a20);
  a36=(a13*a28);
  a22=(a22+a36);
  a36=(a12*a22);
  a20=(a20+a36);
  a36=(a25*a19);
  a39=(a24*a22);
  a30=(a17*a40);
  a39=(a39-a30);
  a39=(a22+a39);
  a30=(a31*a39);
  a36=(a36+a30);
  a20=(a20+a36);
  a20=(a20/a29);
  a35=(a35-a20);
  a20=(a12*a35);
  a38=(a38+a20);
  a22=(a22/a11);
  a17=(a17/a11);
  a20=(a17/a11);
  a20=(a20*a09);
  a22=(a22-a20);
  a39=(a39/a27);
  a25=(a25/a27);
  a20=(a25/a27);
  a20=(a20*a42);
  a39=(a39-a20);
  a19=(a34*a19);
  a20=(a31*a35);
  a19=(a19+a20);
  a39=(a39-a19);
  a19=(a24*a39);
  a20=(a31*a34);
  a25=(a25-a20);
  a40=(a25*a40);
  a19=(a19-a40);
  a22=(a22+a19);
  a38=(a38-a22);
  a38=(a38-a39);
  a22=(a38*a01);
  a26=(a26+a22);
  a22=(a12*a10);
  a33=(a02*a33);
  a22=(a22-a33);
  a19=(a24*a10);
  a19=(a10+a19);
  a40=(a31*a19);
  a22=(a22+a40);
  a22=(a22/a29);
  a40=(a12*a22);
  a10=(a10/a11);
  a19=(a19/a27);
  a20=(a31*a22);
  a19=(a19+a20);
  a20=(a24*a19);
  a10=(a10+a20);
  a40=(a40+a10);
  a40=(a40+a19);
  a10=arg[0]? arg[0][9] : 0;
  a20=(a40*a10);
  a26=(a26+a20);
  a20=(a12*a07);
  a20=(a02-a20);
  a42=(a24*a07);
  a07=(a07+a42);
  a42=(a31*a07);
  a20=(a20-a42);
  a20=(a20/a29);
  a29=(a12*a20);
  a07=(a07/a27);
  a31=(a31*a20);
  a07=(a07-a31);
  a31=(a24*a07);
  a31=(a12+a31);
  a29=(a29-a31);
  a29=(a29-a07);
  a31=arg[0]? arg[0][11] : 0;
  a27=(a29*a31);
  a26=(a26+a27);
  if (res[0]!=0) res[0][1]=a26;
  a26=(a32*a00);
  a27=(a39*a01);
  a26=(a26-a27);
  a27=(a19*a10);
  a26=(a26+a27);
  a27=(a07*a31);
  a26=(a26-a27);
  if (res[0]!=0) res[0][2]=a26;
  a26=arg[0]? arg[0][8] : 0;
  if (res[0]!=0) res[0][3]=a26;
  a26=(a15*a00);
  a27=(a35*a01);
  a26=(a26+a27);
  a10=(a22*a10);
  a26=(a26+a10);
  a31=(a20*a31);
  a26=(a26+a31);
  if (res[0]!=0) res[0][4]=a26;
  a26=-2.;
  a00=(a26*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][5]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a31=(a00-a01);
  if (res[0]!=0) res[0][6]=a31;
  a31=(a37*a00);
  a10=(a38*a01);
  a31=(a31+a10);
  a10=arg[0]? arg[0][15] : 0;
  a27=(a40*a10);
  a31=(a31+a27);
  a27=arg[0]? arg[0][17] : 0;
  a42=(a29*a27);
  a31=(a31+a42);
  a31=(a31-a03);
  if (res[0]!=0) res[0][7]=a31;
  a31=(a32*a00);
  a42=(a39*a01);
  a31=(a31-a42);
  a42=(a19*a10);
  a31=(a31+a42);
  a42=(a07*a27);
  a31=(a31-a42);
  if (res[0]!=0) res[0][8]=a31;
  a31=arg[0]? arg[0][14] : 0;
  if (res[0]!=0) res[0][9]=a31;
  a31=(a15*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a10=(a22*a10);
  a31=(a31+a10);
  a27=(a20*a27);
  a31=(a31+a27);
  if (res[0]!=0) res[0][10]=a31;
  a00=(a26*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=arg[0]? arg[0][18] : 0;
  a01=arg[0]? arg[0][19] : 0;
  a31=(a00-a01);
  if (res[0]!=0) res[0][12]=a31;
  a31=(a37*a00);
  a27=(a38*a01);
  a31=(a31+a27);
  a27=arg[0]? arg[0][21] : 0;
  a10=(a40*a27);
  a31=(a31+a10);
  a10=arg[0]? arg[0][23] : 0;
  a42=(a29*a10);
  a31=(a31+a42);
  if (res[0]!=0) res[0][13]=a31;
  a31=(a32*a00);
  a42=(a39*a01);
  a31=(a31-a42);
  a42=(a19*a27);
  a31=(a31+a42);
  a42=(a07*a10);
  a31=(a31-a42);
  a31=(a31-a03);
  if (res[0]!=0) res[0][14]=a31;
  a31=arg[0]? arg[0][20] : 0;
  if (res[0]!=0) res[0][15]=a31;
  a31=(a15*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a27=(a22*a27);
  a31=(a31+a27);
  a10=(a20*a10);
  a31=(a31+a10);
  if (res[0]!=0) res[0][16]=a31;
  a00=(a26*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][17]=a00;
  a00=arg[0]? arg[0][24] : 0;
  a01=arg[0]? arg[0][25] : 0;
  a31=(a00-a01);
  if (res[0]!=0) res[0][18]=a31;
  a31=(a37*a00);
  a10=(a38*a01);
  a31=(a31+a10);
  a10=arg[0]? arg[0][27] : 0;
  a27=(a40*a10);
  a31=(a31+a27);
  a27=arg[0]? arg[0][29] : 0;
  a42=(a29*a27);
  a31=(a31+a42);
  if (res[0]!=0) res[0][19]=a31;
  a31=(a32*a00);
  a42=(a39*a01);
  a31=(a31-a42);
  a42=(a19*a10);
  a31=(a31+a42);
  a42=(a07*a27);
  a31=(a31-a42);
  if (res[0]!=0) res[0][20]=a31;
  a31=arg[0]? arg[0][26] : 0;
  a31=(a31-a03);
  if (res[0]!=0) res[0][21]=a31;
  a31=(a15*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a10=(a22*a10);
  a31=(a31+a10);
  a27=(a20*a27);
  a31=(a31+a27);
  if (res[0]!=0) res[0][22]=a31;
  a00=(a26*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][23]=a00;
  a00=arg[0]? arg[0][30] : 0;
  a01=arg[0]? arg[0][31] : 0;
  a31=(a00-a01);
  if (res[0]!=0) res[0][24]=a31;
  a31=(a37*a00);
  a27=(a38*a01);
  a31=(a31+a27);
  a27=arg[0]? arg[0][33] : 0;
  a10=(a40*a27);
  a31=(a31+a10);
  a10=arg[0]? arg[0][35] : 0;
  a42=(a29*a10);
  a31=(a31+a42);
  if (res[0]!=0) res[0][25]=a31;
  a31=(a32*a00);
  a42=(a39*a01);
  a31=(a31-a42);
  a42=(a19*a27);
  a31=(a31+a42);
  a42=(a07*a10);
  a31=(a31-a42);
  if (res[0]!=0) res[0][26]=a31;
  a31=arg[0]? arg[0][32] : 0;
  if (res[0]!=0) res[0][27]=a31;
  a31=(a15*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a27=(a22*a27);
  a31=(a31+a27);
  a10=(a20*a10);
  a31=(a31+a10);
  a31=(a31-a03);
  if (res[0]!=0) res[0][28]=a31;
  a00=(a26*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][29]=a00;
  a00=arg[0]? arg[0][4] : 0;
  a01=(a13-a00);
  if (res[0]!=0) res[0][30]=a01;
  a37=(a37*a13);
  a38=(a38*a00);
  a37=(a37+a38);
  a38=(a08*a00);
  a38=(a38*a28);
  a01=(2.*a13);
  a01=(a00-a01);
  a38=(a38*a01);
  a01=(a14-a18);
  a01=(a08*a01);
  a38=(a38+a01);
  a38=(a38+a14);
  a01=(a38/a11);
  a31=(a21/a11);
  a10=casadi_sq(a13);
  a10=(a10*a28);
  a10=(a10+a18);
  a10=(a08*a10);
  a18=arg[3]? arg[3][5] : 0;
  a28=arg[3]? arg[3][7] : 0;
  a27=arg[3]? arg[3][2] : 0;
  a42=(a28*a27);
  a09=arg[2]? arg[2][0] : 0;
  a27=(a27*a09);
  a09=sin(a27);
  a42=(a42*a09);
  a42=(a00+a42);
  a18=(a18*a42);
  a42=arg[3]? arg[3][4] : 0;
  a09=arg[3]? arg[3][6] : 0;
  a27=cos(a27);
  a27=(a27+a03);
  a28=(a28*a27);
  a09=(a09-a28);
  a09=(a09+a05);
  a42=(a42*a09);
  a18=(a18+a42);
  a10=(a10-a18);
  a18=(a31*a38);
  a10=(a10-a18);
  a18=(a21*a31);
  a08=(a08-a18);
  a18=(a10/a08);
  a11=(a33/a11);
  a21=(a21*a11);
  a08=(a21/a08);
  a38=(a11*a38);
  a42=(a02*a13);
  a42=(a42*a13);
  a42=(a42*a14);
  a14=arg[3]? arg[3][0] : 0;
  a09=arg[0]? arg[0][2] : 0;
  a14=(a14*a09);
  a42=(a42+a14);
  a38=(a38-a42);
  a10=(a08*a10);
  a38=(a38-a10);
  a33=(a33*a11);
  a02=(a02-a33);
  a21=(a21*a08);
  a02=(a02-a21);
  a38=(a38/a02);
  a08=(a08*a38);
  a18=(a18-a08);
  a31=(a31*a18);
  a01=(a01-a31);
  a11=(a11*a38);
  a01=(a01+a11);
  a40=(a40*a01);
  a37=(a37+a40);
  a29=(a29*a38);
  a37=(a37+a29);
  if (res[0]!=0) res[0][31]=a37;
  a32=(a32*a13);
  a39=(a39*a00);
  a32=(a32-a39);
  a19=(a19*a01);
  a32=(a32+a19);
  a07=(a07*a38);
  a32=(a32-a07);
  if (res[0]!=0) res[0][32]=a32;
  if (res[0]!=0) res[0][33]=a16;
  a15=(a15*a13);
  a35=(a35*a00);
  a15=(a15+a35);
  a22=(a22*a01);
  a15=(a15+a22);
  a20=(a20*a38);
  a15=(a15+a20);
  if (res[0]!=0) res[0][34]=a15;
  a26=(a26*a13);
  a26=(a26+a00);
  if (res[0]!=0) res[0][35]=a26;
  a26=arg[1]? arg[1][0] : 0;
  a06=(a06-a26);
  if (res[1]!=0) res[1][0]=a06;
  a12=(a12*a34);
  a24=(a24*a25);
  a17=(a17+a24);
  a12=(a12-a17);
  a12=(a12-a25);
  a17=arg[1]? arg[1][1] : 0;
  a12=(a12-a17);
  if (res[1]!=0) res[1][1]=a12;
  a12=arg[1]? arg[1][2] : 0;
  a25=(a25+a12);
  a25=(-a25);
  if (res[1]!=0) res[1][2]=a25;
  a25=arg[1]? arg[1][3] : 0;
  a09=(a09-a25);
  if (res[1]!=0) res[1][3]=a09;
  a09=arg[1]? arg[1][4] : 0;
  a34=(a34-a09);
  if (res[1]!=0) res[1][4]=a34;
  a04=(2.*a04);
  a05=(a05-a04);
  if (res[1]!=0) res[1][5]=a05;
  return 0;
}

/* jacobian_12:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 12 */
  w7 = 12.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: {@4, @0} = landing_with_derivative(@9, @1, @6, @8) */
  arg1[0]=w9;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w4;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @4 */
  casadi_copy(w4, 36, res[0]);
  /* #12: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_12:(u0[6],p[8])->(u[6]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f2(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* plain_step:(y[6],t,h,p[8])->(y_end[6]) */
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
  casadi_real a108;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[2]? arg[2][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][3] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[3]? arg[3][3] : 0;
  a008=arg[0]? arg[0][4] : 0;
  a009=(a007*a008);
  a010=arg[0]? arg[0][1] : 0;
  a011=sin(a010);
  a009=(a009*a011);
  a012=(2.*a003);
  a012=(a008-a012);
  a009=(a009*a012);
  a012=sin(a000);
  a013=(a000-a010);
  a013=sin(a013);
  a014=(a012-a013);
  a014=(a007*a014);
  a009=(a009+a014);
  a009=(a009+a012);
  a014=(2.*a007);
  a015=1.;
  a016=cos(a010);
  a017=(a015-a016);
  a017=(a014*a017);
  a017=(a017+a015);
  a018=(a009/a017);
  a016=(a016-a015);
  a016=(a007*a016);
  a019=(a016/a017);
  a020=casadi_sq(a003);
  a020=(a020*a011);
  a020=(a020+a013);
  a020=(a007*a020);
  a013=arg[3]? arg[3][5] : 0;
  a011=arg[3]? arg[3][7] : 0;
  a021=arg[3]? arg[3][2] : 0;
  a022=(a011*a021);
  a023=arg[1]? arg[1][0] : 0;
  a024=(a021*a023);
  a025=sin(a024);
  a025=(a022*a025);
  a025=(a008+a025);
  a025=(a013*a025);
  a026=arg[3]? arg[3][4] : 0;
  a027=arg[3]? arg[3][6] : 0;
  a024=cos(a024);
  a024=(a024+a015);
  a024=(a011*a024);
  a024=(a027-a024);
  a024=(a024+a010);
  a024=(a026*a024);
  a025=(a025+a024);
  a020=(a020-a025);
  a025=(a019*a009);
  a020=(a020-a025);
  a025=(a016*a019);
  a025=(a007-a025);
  a024=(a020/a025);
  a028=arg[3]? arg[3][1] : 0;
  a029=cos(a000);
  a029=(a028*a029);
  a017=(a029/a017);
  a016=(a016*a017);
  a025=(a016/a025);
  a009=(a017*a009);
  a030=(a028*a003);
  a030=(a030*a003);
  a030=(a030*a012);
  a012=arg[3]? arg[3][0] : 0;
  a031=arg[0]? arg[0][2] : 0;
  a032=(a012*a031);
  a030=(a030+a032);
  a009=(a009-a030);
  a020=(a025*a020);
  a009=(a009-a020);
  a029=(a029*a017);
  a029=(a028-a029);
  a016=(a016*a025);
  a029=(a029-a016);
  a009=(a009/a029);
  a025=(a025*a009);
  a024=(a024-a025);
  a019=(a019*a024);
  a018=(a018-a019);
  a017=(a017*a009);
  a018=(a018+a017);
  a017=(a006*a018);
  a019=1.7082860872947386e-01;
  a019=(a019*a002);
  a025=2.9587585476806851e-02;
  a025=(a025*a002);
  a029=(a025*a024);
  a016=8.8762756430420545e-02;
  a016=(a016*a002);
  a020=1.9725056984537900e-02;
  a020=(a020*a002);
  a030=(a020*a018);
  a032=5.9175170953613701e-02;
  a032=(a032*a002);
  a033=5.2600151958767730e-02;
  a033=(a033*a002);
  a034=(a033*a024);
  a034=(a008+a034);
  a035=(a007*a034);
  a036=(a033*a008);
  a036=(a010+a036);
  a037=sin(a036);
  a035=(a035*a037);
  a038=(a033*a018);
  a038=(a003+a038);
  a039=(2.*a038);
  a039=(a034-a039);
  a035=(a035*a039);
  a039=(a033*a003);
  a039=(a000+a039);
  a040=sin(a039);
  a041=(a039-a036);
  a041=sin(a041);
  a042=(a040-a041);
  a042=(a007*a042);
  a035=(a035+a042);
  a035=(a035+a040);
  a042=cos(a036);
  a043=(a015-a042);
  a043=(a014*a043);
  a043=(a043+a015);
  a044=(a035/a043);
  a042=(a042-a015);
  a042=(a007*a042);
  a045=(a042/a043);
  a046=casadi_sq(a038);
  a046=(a046*a037);
  a046=(a046+a041);
  a046=(a007*a046);
  a041=(a023+a033);
  a041=(a021*a041);
  a037=sin(a041);
  a037=(a022*a037);
  a037=(a034+a037);
  a037=(a013*a037);
  a041=cos(a041);
  a041=(a041+a015);
  a041=(a011*a041);
  a041=(a027-a041);
  a041=(a041+a036);
  a041=(a026*a041);
  a037=(a037+a041);
  a046=(a046-a037);
  a037=(a045*a035);
  a046=(a046-a037);
  a037=(a042*a045);
  a037=(a007-a037);
  a041=(a046/a037);
  a039=cos(a039);
  a039=(a028*a039);
  a043=(a039/a043);
  a042=(a042*a043);
  a037=(a042/a037);
  a035=(a043*a035);
  a036=(a028*a038);
  a036=(a036*a038);
  a036=(a036*a040);
  a040=arg[0]? arg[0][5] : 0;
  a047=(a033*a040);
  a047=(a031+a047);
  a047=(a012*a047);
  a036=(a036+a047);
  a035=(a035-a036);
  a046=(a037*a046);
  a035=(a035-a046);
  a039=(a039*a043);
  a039=(a028-a039);
  a042=(a042*a037);
  a039=(a039-a042);
  a035=(a035/a039);
  a037=(a037*a035);
  a041=(a041-a037);
  a045=(a045*a041);
  a044=(a044-a045);
  a043=(a043*a035);
  a044=(a044+a043);
  a044=(a032*a044);
  a030=(a030+a044);
  a030=(a003+a030);
  a044=casadi_sq(a030);
  a043=(a020*a008);
  a034=(a032*a034);
  a043=(a043+a034);
  a043=(a010+a043);
  a034=sin(a043);
  a044=(a044*a034);
  a045=(a020*a003);
  a038=(a032*a038);
  a045=(a045+a038);
  a045=(a000+a045);
  a038=(a045-a043);
  a038=sin(a038);
  a044=(a044+a038);
  a044=(a007*a044);
  a037=(a020*a024);
  a041=(a032*a041);
  a037=(a037+a041);
  a037=(a008+a037);
  a041=7.8900227938151601e-02;
  a041=(a041*a002);
  a041=(a023+a041);
  a041=(a021*a041);
  a039=sin(a041);
  a039=(a022*a039);
  a039=(a037+a039);
  a039=(a013*a039);
  a041=cos(a041);
  a041=(a041+a015);
  a041=(a011*a041);
  a041=(a027-a041);
  a041=(a041+a043);
  a041=(a026*a041);
  a039=(a039+a041);
  a044=(a044-a039);
  a043=cos(a043);
  a039=(a043-a015);
  a039=(a007*a039);
  a043=(a015-a043);
  a043=(a014*a043);
  a043=(a043+a015);
  a041=(a039/a043);
  a042=(a007*a037);
  a042=(a042*a034);
  a034=(2.*a030);
  a034=(a037-a034);
  a042=(a042*a034);
  a034=sin(a045);
  a038=(a034-a038);
  a038=(a007*a038);
  a042=(a042+a038);
  a042=(a042+a034);
  a038=(a041*a042);
  a044=(a044-a038);
  a038=(a039*a041);
  a038=(a007-a038);
  a046=(a044/a038);
  a045=cos(a045);
  a045=(a028*a045);
  a036=(a045/a043);
  a039=(a039*a036);
  a038=(a039/a038);
  a047=(a036*a042);
  a048=(a028*a030);
  a048=(a048*a030);
  a048=(a048*a034);
  a034=(a020*a040);
  a033=(a033*a009);
  a033=(a040+a033);
  a033=(a032*a033);
  a034=(a034+a033);
  a034=(a031+a034);
  a034=(a012*a034);
  a048=(a048+a034);
  a047=(a047-a048);
  a044=(a038*a044);
  a047=(a047-a044);
  a045=(a045*a036);
  a045=(a028-a045);
  a039=(a039*a038);
  a045=(a045-a039);
  a047=(a047/a045);
  a038=(a038*a047);
  a046=(a046-a038);
  a038=(a016*a046);
  a029=(a029+a038);
  a029=(a008+a029);
  a038=(a007*a029);
  a045=(a025*a008);
  a039=(a016*a037);
  a045=(a045+a039);
  a045=(a010+a045);
  a039=sin(a045);
  a038=(a038*a039);
  a044=(a025*a018);
  a042=(a042/a043);
  a041=(a041*a046);
  a042=(a042-a041);
  a036=(a036*a047);
  a042=(a042+a036);
  a036=(a016*a042);
  a044=(a044+a036);
  a044=(a003+a044);
  a036=(2.*a044);
  a036=(a029-a036);
  a038=(a038*a036);
  a036=(a025*a003);
  a041=(a016*a030);
  a036=(a036+a041);
  a036=(a000+a036);
  a041=sin(a036);
  a043=(a036-a045);
  a043=sin(a043);
  a048=(a041-a043);
  a048=(a007*a048);
  a038=(a038+a048);
  a038=(a038+a041);
  a048=cos(a045);
  a034=(a015-a048);
  a034=(a014*a034);
  a034=(a034+a015);
  a033=(a038/a034);
  a048=(a048-a015);
  a048=(a007*a048);
  a049=(a048/a034);
  a050=casadi_sq(a044);
  a050=(a050*a039);
  a050=(a050+a043);
  a050=(a007*a050);
  a043=1.1835034190722740e-01;
  a043=(a043*a002);
  a043=(a023+a043);
  a043=(a021*a043);
  a039=sin(a043);
  a039=(a022*a039);
  a039=(a029+a039);
  a039=(a013*a039);
  a043=cos(a043);
  a043=(a043+a015);
  a043=(a011*a043);
  a043=(a027-a043);
  a043=(a043+a045);
  a043=(a026*a043);
  a039=(a039+a043);
  a050=(a050-a039);
  a039=(a049*a038);
  a050=(a050-a039);
  a039=(a048*a049);
  a039=(a007-a039);
  a043=(a050/a039);
  a036=cos(a036);
  a036=(a028*a036);
  a034=(a036/a034);
  a048=(a048*a034);
  a039=(a048/a039);
  a038=(a034*a038);
  a045=(a028*a044);
  a045=(a045*a044);
  a045=(a045*a041);
  a041=(a025*a040);
  a020=(a020*a009);
  a032=(a032*a035);
  a020=(a020+a032);
  a020=(a040+a020);
  a032=(a016*a020);
  a041=(a041+a032);
  a041=(a031+a041);
  a041=(a012*a041);
  a045=(a045+a041);
  a038=(a038-a045);
  a050=(a039*a050);
  a038=(a038-a050);
  a036=(a036*a034);
  a036=(a028-a036);
  a048=(a048*a039);
  a036=(a036-a048);
  a038=(a038/a036);
  a039=(a039*a038);
  a043=(a043-a039);
  a049=(a049*a043);
  a033=(a033-a049);
  a034=(a034*a038);
  a033=(a033+a034);
  a034=(a019*a033);
  a017=(a017+a034);
  a034=1.2546768756682242e-01;
  a034=(a034*a002);
  a049=2.4136513415926669e-01;
  a049=(a049*a002);
  a039=(a049*a024);
  a036=-8.8454947932828609e-01;
  a036=(a036*a002);
  a046=(a036*a046);
  a039=(a039+a046);
  a046=9.2483400326179199e-01;
  a046=(a046*a002);
  a048=(a046*a043);
  a039=(a039+a048);
  a039=(a008+a039);
  a048=(a007*a039);
  a050=(a049*a008);
  a037=(a036*a037);
  a050=(a050+a037);
  a037=(a046*a029);
  a050=(a050+a037);
  a050=(a010+a050);
  a037=sin(a050);
  a048=(a048*a037);
  a045=(a049*a018);
  a042=(a036*a042);
  a045=(a045+a042);
  a042=(a046*a033);
  a045=(a045+a042);
  a045=(a003+a045);
  a042=(2.*a045);
  a042=(a039-a042);
  a048=(a048*a042);
  a042=(a049*a003);
  a030=(a036*a030);
  a042=(a042+a030);
  a030=(a046*a044);
  a042=(a042+a030);
  a042=(a000+a042);
  a030=sin(a042);
  a041=(a042-a050);
  a041=sin(a041);
  a032=(a030-a041);
  a032=(a007*a032);
  a048=(a048+a032);
  a048=(a048+a030);
  a032=cos(a050);
  a035=(a015-a032);
  a035=(a014*a035);
  a035=(a035+a015);
  a051=(a048/a035);
  a032=(a032-a015);
  a032=(a007*a032);
  a052=(a032/a035);
  a053=casadi_sq(a045);
  a053=(a053*a037);
  a053=(a053+a041);
  a053=(a007*a053);
  a041=2.8164965809277259e-01;
  a041=(a041*a002);
  a041=(a023+a041);
  a041=(a021*a041);
  a037=sin(a041);
  a037=(a022*a037);
  a037=(a039+a037);
  a037=(a013*a037);
  a041=cos(a041);
  a041=(a041+a015);
  a041=(a011*a041);
  a041=(a027-a041);
  a041=(a041+a050);
  a041=(a026*a041);
  a037=(a037+a041);
  a053=(a053-a037);
  a037=(a052*a048);
  a053=(a053-a037);
  a037=(a032*a052);
  a037=(a007-a037);
  a041=(a053/a037);
  a042=cos(a042);
  a042=(a028*a042);
  a035=(a042/a035);
  a032=(a032*a035);
  a037=(a032/a037);
  a048=(a035*a048);
  a050=(a028*a045);
  a050=(a050*a045);
  a050=(a050*a030);
  a030=(a049*a040);
  a020=(a036*a020);
  a030=(a030+a020);
  a025=(a025*a009);
  a016=(a016*a047);
  a025=(a025+a016);
  a025=(a040+a025);
  a016=(a046*a025);
  a030=(a030+a016);
  a030=(a031+a030);
  a030=(a012*a030);
  a050=(a050+a030);
  a048=(a048-a050);
  a053=(a037*a053);
  a048=(a048-a053);
  a042=(a042*a035);
  a042=(a028-a042);
  a032=(a032*a037);
  a042=(a042-a032);
  a048=(a048/a042);
  a037=(a037*a048);
  a041=(a041-a037);
  a052=(a052*a041);
  a051=(a051-a052);
  a035=(a035*a048);
  a051=(a051+a035);
  a035=(a034*a051);
  a017=(a017+a035);
  a017=(a003+a017);
  a035=(a005*a017);
  a004=(a004+a035);
  a035=1.8915178993145003e+00;
  a035=(a035*a002);
  a052=3.7109375000000000e-02;
  a052=(a052*a002);
  a037=(a052*a018);
  a042=1.7025221101954405e-01;
  a042=(a042*a002);
  a032=(a042*a033);
  a037=(a037+a032);
  a032=6.0216538980455959e-02;
  a032=(a032*a002);
  a053=(a032*a051);
  a037=(a037+a053);
  a053=-1.7578125000000000e-02;
  a053=(a053*a002);
  a050=(a006*a024);
  a030=(a019*a043);
  a050=(a050+a030);
  a030=(a034*a041);
  a050=(a050+a030);
  a050=(a008+a050);
  a030=(a007*a050);
  a016=(a006*a008);
  a020=(a019*a029);
  a016=(a016+a020);
  a020=(a034*a039);
  a016=(a016+a020);
  a016=(a010+a016);
  a020=sin(a016);
  a030=(a030*a020);
  a054=(2.*a017);
  a054=(a050-a054);
  a030=(a030*a054);
  a054=(a006*a003);
  a055=(a019*a044);
  a054=(a054+a055);
  a055=(a034*a045);
  a054=(a054+a055);
  a054=(a000+a054);
  a055=sin(a054);
  a056=(a054-a016);
  a056=sin(a056);
  a057=(a055-a056);
  a057=(a007*a057);
  a030=(a030+a057);
  a030=(a030+a055);
  a057=cos(a016);
  a058=(a015-a057);
  a058=(a014*a058);
  a058=(a058+a015);
  a059=(a030/a058);
  a057=(a057-a015);
  a057=(a007*a057);
  a060=(a057/a058);
  a061=casadi_sq(a017);
  a061=(a061*a020);
  a061=(a061+a056);
  a061=(a007*a061);
  a056=3.3333333333333331e-01;
  a056=(a056*a002);
  a056=(a023+a056);
  a056=(a021*a056);
  a020=sin(a056);
  a020=(a022*a020);
  a020=(a050+a020);
  a020=(a013*a020);
  a056=cos(a056);
  a056=(a056+a015);
  a056=(a011*a056);
  a056=(a027-a056);
  a056=(a056+a016);
  a056=(a026*a056);
  a020=(a020+a056);
  a061=(a061-a020);
  a020=(a060*a030);
  a061=(a061-a020);
  a020=(a057*a060);
  a020=(a007-a020);
  a056=(a061/a020);
  a054=cos(a054);
  a054=(a028*a054);
  a058=(a054/a058);
  a057=(a057*a058);
  a020=(a057/a020);
  a030=(a058*a030);
  a016=(a028*a017);
  a016=(a016*a017);
  a016=(a016*a055);
  a055=(a006*a040);
  a062=(a019*a025);
  a055=(a055+a062);
  a049=(a049*a009);
  a036=(a036*a047);
  a049=(a049+a036);
  a046=(a046*a038);
  a049=(a049+a046);
  a049=(a040+a049);
  a046=(a034*a049);
  a055=(a055+a046);
  a055=(a031+a055);
  a055=(a012*a055);
  a016=(a016+a055);
  a030=(a030-a016);
  a061=(a020*a061);
  a030=(a030-a061);
  a054=(a054*a058);
  a054=(a028-a054);
  a057=(a057*a020);
  a054=(a054-a057);
  a030=(a030/a054);
  a020=(a020*a030);
  a056=(a056-a020);
  a060=(a060*a056);
  a059=(a059-a060);
  a058=(a058*a030);
  a059=(a059+a058);
  a058=(a053*a059);
  a037=(a037+a058);
  a037=(a003+a037);
  a058=(a035*a037);
  a004=(a004+a058);
  a058=-5.8012039600105849e+00;
  a058=(a058*a002);
  a060=3.7092000118504789e-02;
  a060=(a060*a002);
  a020=(a060*a018);
  a054=1.7038392571223998e-01;
  a054=(a054*a002);
  a057=(a054*a033);
  a020=(a020+a057);
  a057=1.0726203044637328e-01;
  a057=(a057*a002);
  a061=(a057*a051);
  a020=(a020+a061);
  a061=-1.5319437748624402e-02;
  a061=(a061*a002);
  a016=(a061*a059);
  a020=(a020+a016);
  a016=8.2737891638140233e-03;
  a016=(a016*a002);
  a055=(a052*a024);
  a046=(a042*a043);
  a055=(a055+a046);
  a046=(a032*a041);
  a055=(a055+a046);
  a046=(a053*a056);
  a055=(a055+a046);
  a055=(a008+a055);
  a046=(a007*a055);
  a036=(a052*a008);
  a047=(a042*a029);
  a036=(a036+a047);
  a047=(a032*a039);
  a036=(a036+a047);
  a047=(a053*a050);
  a036=(a036+a047);
  a036=(a010+a036);
  a047=sin(a036);
  a046=(a046*a047);
  a062=(2.*a037);
  a062=(a055-a062);
  a046=(a046*a062);
  a062=(a052*a003);
  a063=(a042*a044);
  a062=(a062+a063);
  a063=(a032*a045);
  a062=(a062+a063);
  a063=(a053*a017);
  a062=(a062+a063);
  a062=(a000+a062);
  a063=sin(a062);
  a064=(a062-a036);
  a064=sin(a064);
  a065=(a063-a064);
  a065=(a007*a065);
  a046=(a046+a065);
  a046=(a046+a063);
  a065=cos(a036);
  a066=(a015-a065);
  a066=(a014*a066);
  a066=(a066+a015);
  a067=(a046/a066);
  a065=(a065-a015);
  a065=(a007*a065);
  a068=(a065/a066);
  a069=casadi_sq(a037);
  a069=(a069*a047);
  a069=(a069+a064);
  a069=(a007*a069);
  a064=2.5000000000000000e-01;
  a064=(a064*a002);
  a064=(a023+a064);
  a064=(a021*a064);
  a047=sin(a064);
  a047=(a022*a047);
  a047=(a055+a047);
  a047=(a013*a047);
  a064=cos(a064);
  a064=(a064+a015);
  a064=(a011*a064);
  a064=(a027-a064);
  a064=(a064+a036);
  a064=(a026*a064);
  a047=(a047+a064);
  a069=(a069-a047);
  a047=(a068*a046);
  a069=(a069-a047);
  a047=(a065*a068);
  a047=(a007-a047);
  a064=(a069/a047);
  a062=cos(a062);
  a062=(a028*a062);
  a066=(a062/a066);
  a065=(a065*a066);
  a047=(a065/a047);
  a046=(a066*a046);
  a036=(a028*a037);
  a036=(a036*a037);
  a036=(a036*a063);
  a063=(a052*a040);
  a070=(a042*a025);
  a063=(a063+a070);
  a070=(a032*a049);
  a063=(a063+a070);
  a006=(a006*a009);
  a019=(a019*a038);
  a006=(a006+a019);
  a034=(a034*a048);
  a006=(a006+a034);
  a006=(a040+a006);
  a034=(a053*a006);
  a063=(a063+a034);
  a063=(a031+a063);
  a063=(a012*a063);
  a036=(a036+a063);
  a046=(a046-a036);
  a069=(a047*a069);
  a046=(a046-a069);
  a062=(a062*a066);
  a062=(a028-a062);
  a065=(a065*a047);
  a062=(a062-a065);
  a046=(a046/a062);
  a047=(a047*a046);
  a064=(a064-a047);
  a068=(a068*a064);
  a067=(a067-a068);
  a066=(a066*a046);
  a067=(a067+a066);
  a066=(a016*a067);
  a020=(a020+a066);
  a020=(a003+a020);
  a066=(a058*a020);
  a004=(a004+a066);
  a066=3.1116436695781990e-01;
  a066=(a066*a002);
  a068=6.2411095871607569e-01;
  a068=(a068*a002);
  a047=(a068*a018);
  a062=-3.3608926294469414e+00;
  a062=(a062*a002);
  a065=(a062*a033);
  a047=(a047+a065);
  a065=-8.6821934684172597e-01;
  a065=(a065*a002);
  a069=(a065*a051);
  a047=(a047+a069);
  a069=2.7592099699446710e+01;
  a069=(a069*a002);
  a036=(a069*a059);
  a047=(a047+a036);
  a036=2.0154067550477894e+01;
  a036=(a036*a002);
  a063=(a036*a067);
  a047=(a047+a063);
  a063=-4.3489884181069961e+01;
  a063=(a063*a002);
  a034=(a060*a024);
  a019=(a054*a043);
  a034=(a034+a019);
  a019=(a057*a041);
  a034=(a034+a019);
  a019=(a061*a056);
  a034=(a034+a019);
  a019=(a016*a064);
  a034=(a034+a019);
  a034=(a008+a034);
  a019=(a007*a034);
  a070=(a060*a008);
  a071=(a054*a029);
  a070=(a070+a071);
  a071=(a057*a039);
  a070=(a070+a071);
  a071=(a061*a050);
  a070=(a070+a071);
  a071=(a016*a055);
  a070=(a070+a071);
  a070=(a010+a070);
  a071=sin(a070);
  a019=(a019*a071);
  a072=(2.*a020);
  a072=(a034-a072);
  a019=(a019*a072);
  a072=(a060*a003);
  a073=(a054*a044);
  a072=(a072+a073);
  a073=(a057*a045);
  a072=(a072+a073);
  a073=(a061*a017);
  a072=(a072+a073);
  a073=(a016*a037);
  a072=(a072+a073);
  a072=(a000+a072);
  a073=sin(a072);
  a074=(a072-a070);
  a074=sin(a074);
  a075=(a073-a074);
  a075=(a007*a075);
  a019=(a019+a075);
  a019=(a019+a073);
  a075=cos(a070);
  a076=(a015-a075);
  a076=(a014*a076);
  a076=(a076+a015);
  a077=(a019/a076);
  a075=(a075-a015);
  a075=(a007*a075);
  a078=(a075/a076);
  a079=casadi_sq(a020);
  a079=(a079*a071);
  a079=(a079+a074);
  a079=(a007*a079);
  a074=3.0769230769230771e-01;
  a074=(a074*a002);
  a074=(a023+a074);
  a074=(a021*a074);
  a071=sin(a074);
  a071=(a022*a071);
  a071=(a034+a071);
  a071=(a013*a071);
  a074=cos(a074);
  a074=(a074+a015);
  a074=(a011*a074);
  a074=(a027-a074);
  a074=(a074+a070);
  a074=(a026*a074);
  a071=(a071+a074);
  a079=(a079-a071);
  a071=(a078*a019);
  a079=(a079-a071);
  a071=(a075*a078);
  a071=(a007-a071);
  a074=(a079/a071);
  a072=cos(a072);
  a072=(a028*a072);
  a076=(a072/a076);
  a075=(a075*a076);
  a071=(a075/a071);
  a019=(a076*a019);
  a070=(a028*a020);
  a070=(a070*a020);
  a070=(a070*a073);
  a073=(a060*a040);
  a080=(a054*a025);
  a073=(a073+a080);
  a080=(a057*a049);
  a073=(a073+a080);
  a080=(a061*a006);
  a073=(a073+a080);
  a052=(a052*a009);
  a042=(a042*a038);
  a052=(a052+a042);
  a032=(a032*a048);
  a052=(a052+a032);
  a053=(a053*a030);
  a052=(a052+a053);
  a052=(a040+a052);
  a053=(a016*a052);
  a073=(a073+a053);
  a073=(a031+a073);
  a073=(a012*a073);
  a070=(a070+a073);
  a019=(a019-a070);
  a079=(a071*a079);
  a019=(a019-a079);
  a072=(a072*a076);
  a072=(a028-a072);
  a075=(a075*a071);
  a072=(a072-a075);
  a019=(a019/a072);
  a071=(a071*a019);
  a074=(a074-a071);
  a078=(a078*a074);
  a077=(a077-a078);
  a076=(a076*a019);
  a077=(a077+a076);
  a076=(a063*a077);
  a047=(a047+a076);
  a047=(a003+a047);
  a076=(a066*a047);
  a004=(a004+a076);
  a076=-1.5216094966251609e-01;
  a076=(a076*a002);
  a078=4.7766253643826434e-01;
  a078=(a078*a002);
  a071=(a078*a018);
  a072=-2.4881146199716677e+00;
  a072=(a072*a002);
  a075=(a072*a033);
  a071=(a071+a075);
  a075=-5.9029082683684297e-01;
  a075=(a075*a002);
  a079=(a075*a051);
  a071=(a071+a079);
  a079=2.1230051448181193e+01;
  a079=(a079*a002);
  a070=(a079*a059);
  a071=(a071+a070);
  a070=1.5279233632882423e+01;
  a070=(a070*a002);
  a073=(a070*a067);
  a071=(a071+a073);
  a073=-3.3288210968984863e+01;
  a073=(a073*a002);
  a053=(a073*a077);
  a071=(a071+a053);
  a053=-2.0331201708508627e-02;
  a053=(a053*a002);
  a032=(a068*a024);
  a042=(a062*a043);
  a032=(a032+a042);
  a042=(a065*a041);
  a032=(a032+a042);
  a042=(a069*a056);
  a032=(a032+a042);
  a042=(a036*a064);
  a032=(a032+a042);
  a042=(a063*a074);
  a032=(a032+a042);
  a032=(a008+a032);
  a042=(a007*a032);
  a080=(a068*a008);
  a081=(a062*a029);
  a080=(a080+a081);
  a081=(a065*a039);
  a080=(a080+a081);
  a081=(a069*a050);
  a080=(a080+a081);
  a081=(a036*a055);
  a080=(a080+a081);
  a081=(a063*a034);
  a080=(a080+a081);
  a080=(a010+a080);
  a081=sin(a080);
  a042=(a042*a081);
  a082=(2.*a047);
  a082=(a032-a082);
  a042=(a042*a082);
  a082=(a068*a003);
  a083=(a062*a044);
  a082=(a082+a083);
  a083=(a065*a045);
  a082=(a082+a083);
  a083=(a069*a017);
  a082=(a082+a083);
  a083=(a036*a037);
  a082=(a082+a083);
  a083=(a063*a020);
  a082=(a082+a083);
  a082=(a000+a082);
  a083=sin(a082);
  a084=(a082-a080);
  a084=sin(a084);
  a085=(a083-a084);
  a085=(a007*a085);
  a042=(a042+a085);
  a042=(a042+a083);
  a085=cos(a080);
  a086=(a015-a085);
  a086=(a014*a086);
  a086=(a086+a015);
  a087=(a042/a086);
  a085=(a085-a015);
  a085=(a007*a085);
  a088=(a085/a086);
  a089=casadi_sq(a047);
  a089=(a089*a081);
  a089=(a089+a084);
  a089=(a007*a089);
  a084=6.5128205128205130e-01;
  a084=(a084*a002);
  a084=(a023+a084);
  a084=(a021*a084);
  a081=sin(a084);
  a081=(a022*a081);
  a081=(a032+a081);
  a081=(a013*a081);
  a084=cos(a084);
  a084=(a084+a015);
  a084=(a011*a084);
  a084=(a027-a084);
  a084=(a084+a080);
  a084=(a026*a084);
  a081=(a081+a084);
  a089=(a089-a081);
  a081=(a088*a042);
  a089=(a089-a081);
  a081=(a085*a088);
  a081=(a007-a081);
  a084=(a089/a081);
  a082=cos(a082);
  a082=(a028*a082);
  a086=(a082/a086);
  a085=(a085*a086);
  a081=(a085/a081);
  a042=(a086*a042);
  a080=(a028*a047);
  a080=(a080*a047);
  a080=(a080*a083);
  a083=(a068*a040);
  a090=(a062*a025);
  a083=(a083+a090);
  a090=(a065*a049);
  a083=(a083+a090);
  a090=(a069*a006);
  a083=(a083+a090);
  a090=(a036*a052);
  a083=(a083+a090);
  a060=(a060*a009);
  a054=(a054*a038);
  a060=(a060+a054);
  a057=(a057*a048);
  a060=(a060+a057);
  a061=(a061*a030);
  a060=(a060+a061);
  a016=(a016*a046);
  a060=(a060+a016);
  a060=(a040+a060);
  a016=(a063*a060);
  a083=(a083+a016);
  a083=(a031+a083);
  a083=(a012*a083);
  a080=(a080+a083);
  a042=(a042-a080);
  a089=(a081*a089);
  a042=(a042-a089);
  a082=(a082*a086);
  a082=(a028-a082);
  a085=(a085*a081);
  a082=(a082-a085);
  a042=(a042/a082);
  a081=(a081*a042);
  a084=(a084-a081);
  a088=(a088*a084);
  a087=(a087-a088);
  a086=(a086*a042);
  a087=(a087+a086);
  a086=(a053*a087);
  a071=(a071+a086);
  a071=(a003+a071);
  a086=(a076*a071);
  a004=(a004+a086);
  a086=2.0136540080403034e-01;
  a086=(a086*a002);
  a088=-9.3714243008598730e-01;
  a088=(a088*a002);
  a081=(a088*a018);
  a082=5.1863724288440638e+00;
  a082=(a082*a002);
  a085=(a082*a033);
  a081=(a081+a085);
  a085=1.0914373489967295e+00;
  a085=(a085*a002);
  a089=(a085*a051);
  a081=(a081+a089);
  a089=-8.1497870107469268e+00;
  a089=(a089*a002);
  a080=(a089*a059);
  a081=(a081+a080);
  a080=-1.8520065659996959e+01;
  a080=(a080*a002);
  a083=(a080*a067);
  a081=(a081+a083);
  a083=2.2739487099350505e+01;
  a083=(a083*a002);
  a016=(a083*a077);
  a081=(a081+a016);
  a016=2.4936055526796523e+00;
  a016=(a016*a002);
  a061=(a016*a087);
  a081=(a081+a061);
  a061=-3.0467644718982196e+00;
  a061=(a061*a002);
  a057=(a078*a024);
  a054=(a072*a043);
  a057=(a057+a054);
  a054=(a075*a041);
  a057=(a057+a054);
  a054=(a079*a056);
  a057=(a057+a054);
  a054=(a070*a064);
  a057=(a057+a054);
  a054=(a073*a074);
  a057=(a057+a054);
  a054=(a053*a084);
  a057=(a057+a054);
  a057=(a008+a057);
  a054=(a007*a057);
  a090=(a078*a008);
  a091=(a072*a029);
  a090=(a090+a091);
  a091=(a075*a039);
  a090=(a090+a091);
  a091=(a079*a050);
  a090=(a090+a091);
  a091=(a070*a055);
  a090=(a090+a091);
  a091=(a073*a034);
  a090=(a090+a091);
  a091=(a053*a032);
  a090=(a090+a091);
  a090=(a010+a090);
  a091=sin(a090);
  a054=(a054*a091);
  a092=(2.*a071);
  a092=(a057-a092);
  a054=(a054*a092);
  a092=(a078*a003);
  a093=(a072*a044);
  a092=(a092+a093);
  a093=(a075*a045);
  a092=(a092+a093);
  a093=(a079*a017);
  a092=(a092+a093);
  a093=(a070*a037);
  a092=(a092+a093);
  a093=(a073*a020);
  a092=(a092+a093);
  a093=(a053*a047);
  a092=(a092+a093);
  a092=(a000+a092);
  a093=sin(a092);
  a094=(a092-a090);
  a094=sin(a094);
  a095=(a093-a094);
  a095=(a007*a095);
  a054=(a054+a095);
  a054=(a054+a093);
  a095=cos(a090);
  a096=(a015-a095);
  a096=(a014*a096);
  a096=(a096+a015);
  a097=(a054/a096);
  a095=(a095-a015);
  a095=(a007*a095);
  a098=(a095/a096);
  a099=casadi_sq(a071);
  a099=(a099*a091);
  a099=(a099+a094);
  a099=(a007*a099);
  a094=5.9999999999999998e-01;
  a094=(a094*a002);
  a094=(a023+a094);
  a094=(a021*a094);
  a091=sin(a094);
  a091=(a022*a091);
  a091=(a057+a091);
  a091=(a013*a091);
  a094=cos(a094);
  a094=(a094+a015);
  a094=(a011*a094);
  a094=(a027-a094);
  a094=(a094+a090);
  a094=(a026*a094);
  a091=(a091+a094);
  a099=(a099-a091);
  a091=(a098*a054);
  a099=(a099-a091);
  a091=(a095*a098);
  a091=(a007-a091);
  a094=(a099/a091);
  a092=cos(a092);
  a092=(a028*a092);
  a096=(a092/a096);
  a095=(a095*a096);
  a091=(a095/a091);
  a054=(a096*a054);
  a090=(a028*a071);
  a090=(a090*a071);
  a090=(a090*a093);
  a093=(a078*a040);
  a100=(a072*a025);
  a093=(a093+a100);
  a100=(a075*a049);
  a093=(a093+a100);
  a100=(a079*a006);
  a093=(a093+a100);
  a100=(a070*a052);
  a093=(a093+a100);
  a100=(a073*a060);
  a093=(a093+a100);
  a068=(a068*a009);
  a062=(a062*a038);
  a068=(a068+a062);
  a065=(a065*a048);
  a068=(a068+a065);
  a069=(a069*a030);
  a068=(a068+a069);
  a036=(a036*a046);
  a068=(a068+a036);
  a063=(a063*a019);
  a068=(a068+a063);
  a068=(a040+a068);
  a063=(a053*a068);
  a093=(a093+a063);
  a093=(a031+a093);
  a093=(a012*a093);
  a090=(a090+a093);
  a054=(a054-a090);
  a099=(a091*a099);
  a054=(a054-a099);
  a092=(a092*a096);
  a092=(a028-a092);
  a095=(a095*a091);
  a092=(a092-a095);
  a054=(a054/a092);
  a091=(a091*a054);
  a094=(a094-a091);
  a098=(a098*a094);
  a097=(a097-a098);
  a096=(a096*a054);
  a097=(a097+a096);
  a096=(a061*a097);
  a081=(a081+a096);
  a081=(a003+a081);
  a096=(a086*a081);
  a004=(a004+a096);
  a096=4.4710615727772587e-02;
  a096=(a096*a002);
  a098=2.2733101475165380e+00;
  a098=(a098*a002);
  a091=(a098*a018);
  a092=-1.0534495466737249e+01;
  a092=(a092*a002);
  a033=(a092*a033);
  a091=(a091+a033);
  a033=-2.0008720582248625e+00;
  a033=(a033*a002);
  a051=(a033*a051);
  a091=(a091+a051);
  a051=-1.7958931863118799e+01;
  a051=(a051*a002);
  a095=(a051*a059);
  a091=(a091+a095);
  a095=2.7948884529419960e+01;
  a095=(a095*a002);
  a099=(a095*a067);
  a091=(a091+a099);
  a099=-2.8589982771350235e+00;
  a099=(a099*a002);
  a090=(a099*a077);
  a091=(a091+a090);
  a090=-8.8728569335306293e+00;
  a090=(a090*a002);
  a093=(a090*a087);
  a091=(a091+a093);
  a093=1.2360567175794303e+01;
  a093=(a093*a002);
  a063=(a093*a097);
  a091=(a091+a063);
  a063=6.4339274601576357e-01;
  a063=(a063*a002);
  a036=(a088*a024);
  a069=(a082*a043);
  a036=(a036+a069);
  a069=(a085*a041);
  a036=(a036+a069);
  a069=(a089*a056);
  a036=(a036+a069);
  a069=(a080*a064);
  a036=(a036+a069);
  a069=(a083*a074);
  a036=(a036+a069);
  a069=(a016*a084);
  a036=(a036+a069);
  a069=(a061*a094);
  a036=(a036+a069);
  a036=(a008+a036);
  a069=(a007*a036);
  a065=(a088*a008);
  a062=(a082*a029);
  a065=(a065+a062);
  a062=(a085*a039);
  a065=(a065+a062);
  a062=(a089*a050);
  a065=(a065+a062);
  a062=(a080*a055);
  a065=(a065+a062);
  a062=(a083*a034);
  a065=(a065+a062);
  a062=(a016*a032);
  a065=(a065+a062);
  a062=(a061*a057);
  a065=(a065+a062);
  a065=(a010+a065);
  a062=sin(a065);
  a069=(a069*a062);
  a100=(2.*a081);
  a100=(a036-a100);
  a069=(a069*a100);
  a100=(a088*a003);
  a101=(a082*a044);
  a100=(a100+a101);
  a101=(a085*a045);
  a100=(a100+a101);
  a101=(a089*a017);
  a100=(a100+a101);
  a101=(a080*a037);
  a100=(a100+a101);
  a101=(a083*a020);
  a100=(a100+a101);
  a101=(a016*a047);
  a100=(a100+a101);
  a101=(a061*a071);
  a100=(a100+a101);
  a100=(a000+a100);
  a101=sin(a100);
  a102=(a100-a065);
  a102=sin(a102);
  a103=(a101-a102);
  a103=(a007*a103);
  a069=(a069+a103);
  a069=(a069+a101);
  a103=cos(a065);
  a104=(a015-a103);
  a104=(a014*a104);
  a104=(a104+a015);
  a105=(a069/a104);
  a103=(a103-a015);
  a103=(a007*a103);
  a106=(a103/a104);
  a107=casadi_sq(a081);
  a107=(a107*a062);
  a107=(a107+a102);
  a107=(a007*a107);
  a102=8.5714285714285710e-01;
  a102=(a102*a002);
  a102=(a023+a102);
  a102=(a021*a102);
  a062=sin(a102);
  a062=(a022*a062);
  a062=(a036+a062);
  a062=(a013*a062);
  a102=cos(a102);
  a102=(a102+a015);
  a102=(a011*a102);
  a102=(a027-a102);
  a102=(a102+a065);
  a102=(a026*a102);
  a062=(a062+a102);
  a107=(a107-a062);
  a062=(a106*a069);
  a107=(a107-a062);
  a062=(a103*a106);
  a062=(a007-a062);
  a102=(a107/a062);
  a100=cos(a100);
  a100=(a028*a100);
  a104=(a100/a104);
  a103=(a103*a104);
  a062=(a103/a062);
  a069=(a104*a069);
  a065=(a028*a081);
  a065=(a065*a081);
  a065=(a065*a101);
  a101=(a088*a040);
  a108=(a082*a025);
  a101=(a101+a108);
  a108=(a085*a049);
  a101=(a101+a108);
  a108=(a089*a006);
  a101=(a101+a108);
  a108=(a080*a052);
  a101=(a101+a108);
  a108=(a083*a060);
  a101=(a101+a108);
  a108=(a016*a068);
  a101=(a101+a108);
  a078=(a078*a009);
  a072=(a072*a038);
  a078=(a078+a072);
  a075=(a075*a048);
  a078=(a078+a075);
  a079=(a079*a030);
  a078=(a078+a079);
  a070=(a070*a046);
  a078=(a078+a070);
  a073=(a073*a019);
  a078=(a078+a073);
  a053=(a053*a042);
  a078=(a078+a053);
  a078=(a040+a078);
  a053=(a061*a078);
  a101=(a101+a053);
  a101=(a031+a101);
  a101=(a012*a101);
  a065=(a065+a101);
  a069=(a069-a065);
  a107=(a062*a107);
  a069=(a069-a107);
  a100=(a100*a104);
  a100=(a028-a100);
  a103=(a103*a062);
  a100=(a100-a103);
  a069=(a069/a100);
  a062=(a062*a069);
  a102=(a102-a062);
  a106=(a106*a102);
  a105=(a105-a106);
  a104=(a104*a069);
  a105=(a105+a104);
  a104=(a063*a105);
  a091=(a091+a104);
  a091=(a003+a091);
  a104=(a096*a091);
  a004=(a004+a104);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a104=(a005*a050);
  a004=(a004+a104);
  a104=(a035*a055);
  a004=(a004+a104);
  a104=(a058*a034);
  a004=(a004+a104);
  a104=(a066*a032);
  a004=(a004+a104);
  a104=(a076*a057);
  a004=(a004+a104);
  a104=(a086*a036);
  a004=(a004+a104);
  a104=(a098*a024);
  a043=(a092*a043);
  a104=(a104+a043);
  a041=(a033*a041);
  a104=(a104+a041);
  a041=(a051*a056);
  a104=(a104+a041);
  a041=(a095*a064);
  a104=(a104+a041);
  a041=(a099*a074);
  a104=(a104+a041);
  a041=(a090*a084);
  a104=(a104+a041);
  a041=(a093*a094);
  a104=(a104+a041);
  a041=(a063*a102);
  a104=(a104+a041);
  a104=(a008+a104);
  a041=(a096*a104);
  a004=(a004+a041);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a040);
  a041=(a005*a006);
  a004=(a004+a041);
  a041=(a035*a052);
  a004=(a004+a041);
  a041=(a058*a060);
  a004=(a004+a041);
  a041=(a066*a068);
  a004=(a004+a041);
  a041=(a076*a078);
  a004=(a004+a041);
  a088=(a088*a009);
  a082=(a082*a038);
  a088=(a088+a082);
  a085=(a085*a048);
  a088=(a088+a085);
  a089=(a089*a030);
  a088=(a088+a089);
  a080=(a080*a046);
  a088=(a088+a080);
  a083=(a083*a019);
  a088=(a088+a083);
  a016=(a016*a042);
  a088=(a088+a016);
  a061=(a061*a054);
  a088=(a088+a061);
  a088=(a040+a088);
  a061=(a086*a088);
  a004=(a004+a061);
  a061=(a098*a009);
  a038=(a092*a038);
  a061=(a061+a038);
  a048=(a033*a048);
  a061=(a061+a048);
  a048=(a051*a030);
  a061=(a061+a048);
  a048=(a095*a046);
  a061=(a061+a048);
  a048=(a099*a019);
  a061=(a061+a048);
  a048=(a090*a042);
  a061=(a061+a048);
  a048=(a093*a054);
  a061=(a061+a048);
  a048=(a063*a069);
  a061=(a061+a048);
  a061=(a040+a061);
  a061=(a096*a061);
  a004=(a004+a061);
  a004=(a031+a004);
  if (res[0]!=0) res[0][2]=a004;
  a018=(a001*a018);
  a059=(a005*a059);
  a018=(a018+a059);
  a067=(a035*a067);
  a018=(a018+a067);
  a077=(a058*a077);
  a018=(a018+a077);
  a087=(a066*a087);
  a018=(a018+a087);
  a097=(a076*a097);
  a018=(a018+a097);
  a105=(a086*a105);
  a018=(a018+a105);
  a105=(a007*a104);
  a097=(a098*a008);
  a029=(a092*a029);
  a097=(a097+a029);
  a039=(a033*a039);
  a097=(a097+a039);
  a050=(a051*a050);
  a097=(a097+a050);
  a055=(a095*a055);
  a097=(a097+a055);
  a034=(a099*a034);
  a097=(a097+a034);
  a032=(a090*a032);
  a097=(a097+a032);
  a057=(a093*a057);
  a097=(a097+a057);
  a036=(a063*a036);
  a097=(a097+a036);
  a010=(a010+a097);
  a097=sin(a010);
  a105=(a105*a097);
  a036=(2.*a091);
  a036=(a104-a036);
  a105=(a105*a036);
  a036=(a098*a003);
  a044=(a092*a044);
  a036=(a036+a044);
  a045=(a033*a045);
  a036=(a036+a045);
  a017=(a051*a017);
  a036=(a036+a017);
  a037=(a095*a037);
  a036=(a036+a037);
  a020=(a099*a020);
  a036=(a036+a020);
  a047=(a090*a047);
  a036=(a036+a047);
  a071=(a093*a071);
  a036=(a036+a071);
  a081=(a063*a081);
  a036=(a036+a081);
  a000=(a000+a036);
  a036=sin(a000);
  a081=(a000-a010);
  a081=sin(a081);
  a071=(a036-a081);
  a071=(a007*a071);
  a105=(a105+a071);
  a105=(a105+a036);
  a071=cos(a010);
  a047=(a015-a071);
  a014=(a014*a047);
  a014=(a014+a015);
  a047=(a105/a014);
  a071=(a071-a015);
  a071=(a007*a071);
  a020=(a071/a014);
  a037=casadi_sq(a091);
  a037=(a037*a097);
  a037=(a037+a081);
  a037=(a007*a037);
  a023=(a023+a002);
  a021=(a021*a023);
  a023=sin(a021);
  a022=(a022*a023);
  a104=(a104+a022);
  a013=(a013*a104);
  a021=cos(a021);
  a021=(a021+a015);
  a011=(a011*a021);
  a027=(a027-a011);
  a027=(a027+a010);
  a026=(a026*a027);
  a013=(a013+a026);
  a037=(a037-a013);
  a013=(a020*a105);
  a037=(a037-a013);
  a013=(a071*a020);
  a007=(a007-a013);
  a013=(a037/a007);
  a000=cos(a000);
  a000=(a028*a000);
  a014=(a000/a014);
  a071=(a071*a014);
  a007=(a071/a007);
  a105=(a014*a105);
  a026=(a028*a091);
  a026=(a026*a091);
  a026=(a026*a036);
  a098=(a098*a040);
  a092=(a092*a025);
  a098=(a098+a092);
  a033=(a033*a049);
  a098=(a098+a033);
  a051=(a051*a006);
  a098=(a098+a051);
  a095=(a095*a052);
  a098=(a098+a095);
  a099=(a099*a060);
  a098=(a098+a099);
  a090=(a090*a068);
  a098=(a098+a090);
  a093=(a093*a078);
  a098=(a098+a093);
  a063=(a063*a088);
  a098=(a098+a063);
  a031=(a031+a098);
  a012=(a012*a031);
  a026=(a026+a012);
  a105=(a105-a026);
  a037=(a007*a037);
  a105=(a105-a037);
  a000=(a000*a014);
  a028=(a028-a000);
  a071=(a071*a007);
  a028=(a028-a071);
  a105=(a105/a028);
  a007=(a007*a105);
  a013=(a013-a007);
  a020=(a020*a013);
  a047=(a047-a020);
  a014=(a014*a105);
  a047=(a047+a014);
  a047=(a096*a047);
  a018=(a018+a047);
  a003=(a003+a018);
  if (res[0]!=0) res[0][3]=a003;
  a024=(a001*a024);
  a056=(a005*a056);
  a024=(a024+a056);
  a064=(a035*a064);
  a024=(a024+a064);
  a074=(a058*a074);
  a024=(a024+a074);
  a084=(a066*a084);
  a024=(a024+a084);
  a094=(a076*a094);
  a024=(a024+a094);
  a102=(a086*a102);
  a024=(a024+a102);
  a013=(a096*a013);
  a024=(a024+a013);
  a008=(a008+a024);
  if (res[0]!=0) res[0][4]=a008;
  a001=(a001*a009);
  a005=(a005*a030);
  a001=(a001+a005);
  a035=(a035*a046);
  a001=(a001+a035);
  a058=(a058*a019);
  a001=(a001+a058);
  a066=(a066*a042);
  a001=(a001+a066);
  a076=(a076*a054);
  a001=(a001+a076);
  a086=(a086*a069);
  a001=(a001+a086);
  a096=(a096*a105);
  a001=(a001+a096);
  a040=(a040+a001);
  if (res[0]!=0) res[0][5]=a040;
  return 0;
}

/* plain_steps:(y[6],t,h,p[8])->(y_end[6]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+109, w1, w2, *w4=w+115, w5;
  const casadi_real **arg1=arg+4, *wr3;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[2][0] */
  w2 = arg[2] ? arg[2][0] : 0;
  /* #3: @3 = input[3][0] */
  wr3 = arg[3] ? arg[3] : casadi_zeros;
  /* #4: @4 = plain_step(@0, @1, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = (@1+@2) */
  w5  = (w1+w2);
  /* #6: @0 = plain_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #7: @5 = (2.*@2) */
  w5 = (2.* w2 );
  /* #8: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #9: @4 = plain_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 3 */
  w5 = 3.;
  /* #11: @5 = (@5*@2) */
  w5 *= w2;
  /* #12: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #13: @0 = plain_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #14: @5 = 4 */
  w5 = 4.;
  /* #15: @5 = (@5*@2) */
  w5 *= w2;
  /* #16: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #17: @4 = plain_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #18: @5 = 5 */
  w5 = 5.;
  /* #19: @5 = (@5*@2) */
  w5 *= w2;
  /* #20: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #21: @0 = plain_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #22: @5 = 6 */
  w5 = 6.;
  /* #23: @5 = (@5*@2) */
  w5 *= w2;
  /* #24: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #25: @4 = plain_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #26: @5 = 7 */
  w5 = 7.;
  /* #27: @5 = (@5*@2) */
  w5 *= w2;
  /* #28: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #29: @0 = plain_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 8 */
  w5 = 8.;
  /* #31: @5 = (@5*@2) */
  w5 *= w2;
  /* #32: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #33: @4 = plain_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #34: @5 = 9 */
  w5 = 9.;
  /* #35: @5 = (@5*@2) */
  w5 *= w2;
  /* #36: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #37: @0 = plain_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #38: @5 = 10 */
  w5 = 10.;
  /* #39: @5 = (@5*@2) */
  w5 *= w2;
  /* #40: @5 = (@1+@5) */
  w5  = (w1+w5);
  /* #41: @4 = plain_step(@0, @5, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #42: @5 = 11 */
  w5 = 11.;
  /* #43: @5 = (@5*@2) */
  w5 *= w2;
  /* #44: @1 = (@1+@5) */
  w1 += w5;
  /* #45: @0 = plain_step(@4, @1, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w1);
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* landing:(y[6],z[5],p[8])->(R[6]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[0]? arg[0][1] : 0;
  a02=(a00-a01);
  a03=arg[1]? arg[1][0] : 0;
  a03=(a02-a03);
  if (res[0]!=0) res[0][0]=a03;
  a03=arg[2]? arg[2][1] : 0;
  a02=cos(a02);
  a02=(a03*a02);
  a04=arg[2]? arg[2][3] : 0;
  a05=(2.*a04);
  a06=1.;
  a07=cos(a01);
  a08=(a06-a07);
  a05=(a05*a08);
  a05=(a05+a06);
  a08=(a02/a05);
  a09=arg[0]? arg[0][5] : 0;
  a10=cos(a00);
  a11=arg[0]? arg[0][3] : 0;
  a10=(a10*a11);
  a10=(a09-a10);
  a10=(a03*a10);
  a09=(a02*a09);
  a11=(a07*a11);
  a09=(a09-a11);
  a11=(a08*a09);
  a10=(a10-a11);
  a07=(a07-a06);
  a07=(a04*a07);
  a07=(a07-a06);
  a11=(a07*a08);
  a11=(a02+a11);
  a04=(a04+a06);
  a06=(a07/a05);
  a07=(a07*a06);
  a04=(a04-a07);
  a07=(a11/a04);
  a12=(a06*a09);
  a12=(a09+a12);
  a13=(a07*a12);
  a10=(a10-a13);
  a02=(a02*a08);
  a03=(a03-a02);
  a11=(a11*a07);
  a03=(a03-a11);
  a10=(a10/a03);
  a08=(a08*a10);
  a09=(a09/a05);
  a12=(a12/a04);
  a07=(a07*a10);
  a12=(a12-a07);
  a06=(a06*a12);
  a09=(a09+a06);
  a08=(a08-a09);
  a08=(a08-a12);
  a09=arg[1]? arg[1][1] : 0;
  a08=(a08-a09);
  if (res[0]!=0) res[0][1]=a08;
  a08=arg[1]? arg[1][2] : 0;
  a12=(a12+a08);
  a12=(-a12);
  if (res[0]!=0) res[0][2]=a12;
  a12=arg[0]? arg[0][2] : 0;
  a08=arg[1]? arg[1][3] : 0;
  a12=(a12-a08);
  if (res[0]!=0) res[0][3]=a12;
  a12=arg[1]? arg[1][4] : 0;
  a10=(a10-a12);
  if (res[0]!=0) res[0][4]=a10;
  a00=(2.*a00);
  a01=(a01-a00);
  if (res[0]!=0) res[0][5]=a01;
  return 0;
}

/* residual_12:(u[6],p[8])->(R[6]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+132, *w1=w+138, *w2=w+143, w3, w4, w5;
  const casadi_real **arg1=arg+2, *cs, *wr6;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, NULL} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @3 = 0 */
  w3 = 0.;
  /* #4: @4 = @0[5] */
  for (rr=(&w4), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #5: @5 = 12 */
  w5 = 12.;
  /* #6: @4 = (@4/@5) */
  w4 /= w5;
  /* #7: @6 = input[1][0] */
  wr6 = arg[1] ? arg[1] : casadi_zeros;
  /* #8: @0 = plain_steps(@2, @3, @4, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w4);
  arg1[3]=wr6;
  res1[0]=w0;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @2 = landing(@0, @1, @6) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=wr6;
  res1[0]=w2;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  return 0;
}

/* wobbling_search_12:(u0[6],p[8])->(u[6],R[6]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+647, *w2=w+653;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: @0 = residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 659;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 659*sizeof(casadi_real);
  return 0;
}

/* jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 24 */
  w7 = 24.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 24 */
  w7 = 24.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #17: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_24:(u0[6],p[8])->(u[6]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f13(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* residual_24:(u[6],p[8])->(R[6]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+132, *w1=w+138, *w2=w+143, w3, w4, w5;
  const casadi_real **arg1=arg+2, *cs, *wr6;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, NULL} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @3 = 0 */
  w3 = 0.;
  /* #4: @4 = @0[5] */
  for (rr=(&w4), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #5: @5 = 24 */
  w5 = 24.;
  /* #6: @5 = (@4/@5) */
  w5  = (w4/w5);
  /* #7: @6 = input[1][0] */
  wr6 = arg[1] ? arg[1] : casadi_zeros;
  /* #8: @0 = plain_steps(@2, @3, @5, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w5);
  arg1[3]=wr6;
  res1[0]=w0;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @3 = 0.5 */
  w3 = 5.0000000000000000e-01;
  /* #10: @3 = (@3*@4) */
  w3 *= w4;
  /* #11: @5 = 24 */
  w5 = 24.;
  /* #12: @4 = (@4/@5) */
  w4 /= w5;
  /* #13: @2 = plain_steps(@0, @3, @4, @6) */
  arg1[0]=w0;
  arg1[1]=(&w3);
  arg1[2]=(&w4);
  arg1[3]=wr6;
  res1[0]=w2;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #14: @0 = landing(@2, @1, @6) */
  arg1[0]=w2;
  arg1[1]=w1;
  arg1[2]=wr6;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* wobbling_search_24:(u0[6],p[8])->(u[6],R[6]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+647, *w2=w+653;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: @0 = residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 659;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 659*sizeof(casadi_real);
  return 0;
}

/* jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 48 */
  w7 = 48.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 48 */
  w7 = 48.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 48 */
  w7 = 48.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 48 */
  w7 = 48.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #27: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_48:(u0[6],p[8])->(u[6]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f17(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* residual_48:(u[6],p[8])->(R[6]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+132, *w1=w+138, *w2=w+143, w3, w4, w5;
  const casadi_real **arg1=arg+2, *cs, *wr6;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, NULL} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @3 = 0 */
  w3 = 0.;
  /* #4: @4 = @0[5] */
  for (rr=(&w4), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #5: @5 = 48 */
  w5 = 48.;
  /* #6: @5 = (@4/@5) */
  w5  = (w4/w5);
  /* #7: @6 = input[1][0] */
  wr6 = arg[1] ? arg[1] : casadi_zeros;
  /* #8: @0 = plain_steps(@2, @3, @5, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w5);
  arg1[3]=wr6;
  res1[0]=w0;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @3 = 0.25 */
  w3 = 2.5000000000000000e-01;
  /* #10: @3 = (@3*@4) */
  w3 *= w4;
  /* #11: @5 = 48 */
  w5 = 48.;
  /* #12: @5 = (@4/@5) */
  w5  = (w4/w5);
  /* #13: @2 = plain_steps(@0, @3, @5, @6) */
  arg1[0]=w0;
  arg1[1]=(&w3);
  arg1[2]=(&w5);
  arg1[3]=wr6;
  res1[0]=w2;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #14: @3 = 0.5 */
  w3 = 5.0000000000000000e-01;
  /* #15: @3 = (@3*@4) */
  w3 *= w4;
  /* #16: @5 = 48 */
  w5 = 48.;
  /* #17: @5 = (@4/@5) */
  w5  = (w4/w5);
  /* #18: @0 = plain_steps(@2, @3, @5, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w5);
  arg1[3]=wr6;
  res1[0]=w0;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #19: @3 = 0.75 */
  w3 = 7.5000000000000000e-01;
  /* #20: @3 = (@3*@4) */
  w3 *= w4;
  /* #21: @5 = 48 */
  w5 = 48.;
  /* #22: @4 = (@4/@5) */
  w4 /= w5;
  /* #23: @2 = plain_steps(@0, @3, @4, @6) */
  arg1[0]=w0;
  arg1[1]=(&w3);
  arg1[2]=(&w4);
  arg1[3]=wr6;
  res1[0]=w2;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #24: @0 = landing(@2, @1, @6) */
  arg1[0]=w2;
  arg1[1]=w1;
  arg1[2]=wr6;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: output[0][0] = @0 */
  casadi_copy(w0, 6, res[0]);
  return 0;
}

/* wobbling_search_48:(u0[6],p[8])->(u[6],R[6]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+647, *w2=w+653;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: @0 = residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w0;
  if (casadi_f18(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 659;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 659*sizeof(casadi_real);
  return 0;
}

/* jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 24 */
  w7 = 24.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 24 */
  w7 = 24.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #17: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_24:(u0[6],p[8])->(u[6]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f21(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* jacobian_24:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 24 */
  w7 = 24.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 24 */
  w7 = 24.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #17: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_24:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+647, *w2=w+653, *w3=w+659;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 695*sizeof(casadi_real);
  return 0;
}

/* jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 48 */
  w7 = 48.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 48 */
  w7 = 48.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 48 */
  w7 = 48.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 48 */
  w7 = 48.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #27: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_48:(u0[6],p[8])->(u[6]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f25(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* jacobian_48:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 48 */
  w7 = 48.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 48 */
  w7 = 48.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 48 */
  w7 = 48.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 48 */
  w7 = 48.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #27: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_48:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+647, *w2=w+653, *w3=w+659;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f24(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = jacobian_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f23(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 695*sizeof(casadi_real);
  return 0;
}

/* jacobian_96:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 96 */
  w7 = 96.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.125 */
  w5 = 1.2500000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 96 */
  w7 = 96.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 96 */
  w7 = 96.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.375 */
  w5 = 3.7500000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 96 */
  w7 = 96.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #26: @5 = (@5*@6) */
  w5 *= w6;
  /* #27: @7 = 96 */
  w7 = 96.;
  /* #28: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #29: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 0.625 */
  w5 = 6.2500000000000000e-01;
  /* #31: @5 = (@5*@6) */
  w5 *= w6;
  /* #32: @7 = 96 */
  w7 = 96.;
  /* #33: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #34: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w5 *= w6;
  /* #37: @7 = 96 */
  w7 = 96.;
  /* #38: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #39: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #40: @5 = 0.875 */
  w5 = 8.7500000000000000e-01;
  /* #41: @5 = (@5*@6) */
  w5 *= w6;
  /* #42: @7 = 96 */
  w7 = 96.;
  /* #43: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #44: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #47: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_96:(u0[6],p[8])->(u[6]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f29(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* jacobian_96:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 96 */
  w7 = 96.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.125 */
  w5 = 1.2500000000000000e-01;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 96 */
  w7 = 96.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 96 */
  w7 = 96.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.375 */
  w5 = 3.7500000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 96 */
  w7 = 96.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #26: @5 = (@5*@6) */
  w5 *= w6;
  /* #27: @7 = 96 */
  w7 = 96.;
  /* #28: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #29: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 0.625 */
  w5 = 6.2500000000000000e-01;
  /* #31: @5 = (@5*@6) */
  w5 *= w6;
  /* #32: @7 = 96 */
  w7 = 96.;
  /* #33: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #34: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w5 *= w6;
  /* #37: @7 = 96 */
  w7 = 96.;
  /* #38: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #39: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #40: @5 = 0.875 */
  w5 = 8.7500000000000000e-01;
  /* #41: @5 = (@5*@6) */
  w5 *= w6;
  /* #42: @7 = 96 */
  w7 = 96.;
  /* #43: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #44: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #47: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_96:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+647, *w2=w+653, *w3=w+659;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f30(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 695*sizeof(casadi_real);
  return 0;
}

/* jacobian_192:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 192 */
  w7 = 192.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.0625 */
  w5 = 6.2500000000000000e-02;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 192 */
  w7 = 192.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.125 */
  w5 = 1.2500000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 192 */
  w7 = 192.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.1875 */
  w5 = 1.8750000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 192 */
  w7 = 192.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #26: @5 = (@5*@6) */
  w5 *= w6;
  /* #27: @7 = 192 */
  w7 = 192.;
  /* #28: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #29: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 0.3125 */
  w5 = 3.1250000000000000e-01;
  /* #31: @5 = (@5*@6) */
  w5 *= w6;
  /* #32: @7 = 192 */
  w7 = 192.;
  /* #33: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #34: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.375 */
  w5 = 3.7500000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w5 *= w6;
  /* #37: @7 = 192 */
  w7 = 192.;
  /* #38: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #39: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #40: @5 = 0.4375 */
  w5 = 4.3750000000000000e-01;
  /* #41: @5 = (@5*@6) */
  w5 *= w6;
  /* #42: @7 = 192 */
  w7 = 192.;
  /* #43: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #44: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #46: @5 = (@5*@6) */
  w5 *= w6;
  /* #47: @7 = 192 */
  w7 = 192.;
  /* #48: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #49: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.5625 */
  w5 = 5.6250000000000000e-01;
  /* #51: @5 = (@5*@6) */
  w5 *= w6;
  /* #52: @7 = 192 */
  w7 = 192.;
  /* #53: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #54: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #55: @5 = 0.625 */
  w5 = 6.2500000000000000e-01;
  /* #56: @5 = (@5*@6) */
  w5 *= w6;
  /* #57: @7 = 192 */
  w7 = 192.;
  /* #58: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #59: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #60: @5 = 0.6875 */
  w5 = 6.8750000000000000e-01;
  /* #61: @5 = (@5*@6) */
  w5 *= w6;
  /* #62: @7 = 192 */
  w7 = 192.;
  /* #63: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #64: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #65: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #66: @5 = (@5*@6) */
  w5 *= w6;
  /* #67: @7 = 192 */
  w7 = 192.;
  /* #68: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #69: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #70: @5 = 0.8125 */
  w5 = 8.1250000000000000e-01;
  /* #71: @5 = (@5*@6) */
  w5 *= w6;
  /* #72: @7 = 192 */
  w7 = 192.;
  /* #73: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #74: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #75: @5 = 0.875 */
  w5 = 8.7500000000000000e-01;
  /* #76: @5 = (@5*@6) */
  w5 *= w6;
  /* #77: @7 = 192 */
  w7 = 192.;
  /* #78: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #79: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #80: @5 = 0.9375 */
  w5 = 9.3750000000000000e-01;
  /* #81: @5 = (@5*@6) */
  w5 *= w6;
  /* #82: @7 = 192 */
  w7 = 192.;
  /* #83: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #84: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #85: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #87: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_192:(u0[6],p[8])->(u[6]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f33(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* jacobian_192:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 192 */
  w7 = 192.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.0625 */
  w5 = 6.2500000000000000e-02;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 192 */
  w7 = 192.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.125 */
  w5 = 1.2500000000000000e-01;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 192 */
  w7 = 192.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.1875 */
  w5 = 1.8750000000000000e-01;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 192 */
  w7 = 192.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #26: @5 = (@5*@6) */
  w5 *= w6;
  /* #27: @7 = 192 */
  w7 = 192.;
  /* #28: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #29: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 0.3125 */
  w5 = 3.1250000000000000e-01;
  /* #31: @5 = (@5*@6) */
  w5 *= w6;
  /* #32: @7 = 192 */
  w7 = 192.;
  /* #33: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #34: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.375 */
  w5 = 3.7500000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w5 *= w6;
  /* #37: @7 = 192 */
  w7 = 192.;
  /* #38: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #39: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #40: @5 = 0.4375 */
  w5 = 4.3750000000000000e-01;
  /* #41: @5 = (@5*@6) */
  w5 *= w6;
  /* #42: @7 = 192 */
  w7 = 192.;
  /* #43: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #44: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #46: @5 = (@5*@6) */
  w5 *= w6;
  /* #47: @7 = 192 */
  w7 = 192.;
  /* #48: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #49: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.5625 */
  w5 = 5.6250000000000000e-01;
  /* #51: @5 = (@5*@6) */
  w5 *= w6;
  /* #52: @7 = 192 */
  w7 = 192.;
  /* #53: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #54: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #55: @5 = 0.625 */
  w5 = 6.2500000000000000e-01;
  /* #56: @5 = (@5*@6) */
  w5 *= w6;
  /* #57: @7 = 192 */
  w7 = 192.;
  /* #58: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #59: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #60: @5 = 0.6875 */
  w5 = 6.8750000000000000e-01;
  /* #61: @5 = (@5*@6) */
  w5 *= w6;
  /* #62: @7 = 192 */
  w7 = 192.;
  /* #63: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #64: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #65: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #66: @5 = (@5*@6) */
  w5 *= w6;
  /* #67: @7 = 192 */
  w7 = 192.;
  /* #68: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #69: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #70: @5 = 0.8125 */
  w5 = 8.1250000000000000e-01;
  /* #71: @5 = (@5*@6) */
  w5 *= w6;
  /* #72: @7 = 192 */
  w7 = 192.;
  /* #73: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #74: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #75: @5 = 0.875 */
  w5 = 8.7500000000000000e-01;
  /* #76: @5 = (@5*@6) */
  w5 *= w6;
  /* #77: @7 = 192 */
  w7 = 192.;
  /* #78: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #79: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #80: @5 = 0.9375 */
  w5 = 9.3750000000000000e-01;
  /* #81: @5 = (@5*@6) */
  w5 *= w6;
  /* #82: @7 = 192 */
  w7 = 192.;
  /* #83: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #84: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #85: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #87: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_192:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+647, *w2=w+653, *w3=w+659;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f32(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=wr1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 36, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 6, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f31(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 695*sizeof(casadi_real);
  return 0;
}

/* jacobian_384:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 384 */
  w7 = 384.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.03125 */
  w5 = 3.1250000000000000e-02;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 384 */
  w7 = 384.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.0625 */
  w5 = 6.2500000000000000e-02;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 384 */
  w7 = 384.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.09375 */
  w5 = 9.3750000000000000e-02;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 384 */
  w7 = 384.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: @5 = 0.125 */
  w5 = 1.2500000000000000e-01;
  /* #26: @5 = (@5*@6) */
  w5 *= w6;
  /* #27: @7 = 384 */
  w7 = 384.;
  /* #28: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #29: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 0.15625 */
  w5 = 1.5625000000000000e-01;
  /* #31: @5 = (@5*@6) */
  w5 *= w6;
  /* #32: @7 = 384 */
  w7 = 384.;
  /* #33: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #34: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.1875 */
  w5 = 1.8750000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w5 *= w6;
  /* #37: @7 = 384 */
  w7 = 384.;
  /* #38: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #39: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #40: @5 = 0.21875 */
  w5 = 2.1875000000000000e-01;
  /* #41: @5 = (@5*@6) */
  w5 *= w6;
  /* #42: @7 = 384 */
  w7 = 384.;
  /* #43: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #44: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #46: @5 = (@5*@6) */
  w5 *= w6;
  /* #47: @7 = 384 */
  w7 = 384.;
  /* #48: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #49: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.28125 */
  w5 = 2.8125000000000000e-01;
  /* #51: @5 = (@5*@6) */
  w5 *= w6;
  /* #52: @7 = 384 */
  w7 = 384.;
  /* #53: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #54: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #55: @5 = 0.3125 */
  w5 = 3.1250000000000000e-01;
  /* #56: @5 = (@5*@6) */
  w5 *= w6;
  /* #57: @7 = 384 */
  w7 = 384.;
  /* #58: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #59: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #60: @5 = 0.34375 */
  w5 = 3.4375000000000000e-01;
  /* #61: @5 = (@5*@6) */
  w5 *= w6;
  /* #62: @7 = 384 */
  w7 = 384.;
  /* #63: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #64: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #65: @5 = 0.375 */
  w5 = 3.7500000000000000e-01;
  /* #66: @5 = (@5*@6) */
  w5 *= w6;
  /* #67: @7 = 384 */
  w7 = 384.;
  /* #68: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #69: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #70: @5 = 0.40625 */
  w5 = 4.0625000000000000e-01;
  /* #71: @5 = (@5*@6) */
  w5 *= w6;
  /* #72: @7 = 384 */
  w7 = 384.;
  /* #73: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #74: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #75: @5 = 0.4375 */
  w5 = 4.3750000000000000e-01;
  /* #76: @5 = (@5*@6) */
  w5 *= w6;
  /* #77: @7 = 384 */
  w7 = 384.;
  /* #78: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #79: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #80: @5 = 0.46875 */
  w5 = 4.6875000000000000e-01;
  /* #81: @5 = (@5*@6) */
  w5 *= w6;
  /* #82: @7 = 384 */
  w7 = 384.;
  /* #83: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #84: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #85: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #86: @5 = (@5*@6) */
  w5 *= w6;
  /* #87: @7 = 384 */
  w7 = 384.;
  /* #88: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #89: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #90: @5 = 0.53125 */
  w5 = 5.3125000000000000e-01;
  /* #91: @5 = (@5*@6) */
  w5 *= w6;
  /* #92: @7 = 384 */
  w7 = 384.;
  /* #93: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #94: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #95: @5 = 0.5625 */
  w5 = 5.6250000000000000e-01;
  /* #96: @5 = (@5*@6) */
  w5 *= w6;
  /* #97: @7 = 384 */
  w7 = 384.;
  /* #98: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #99: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #100: @5 = 0.59375 */
  w5 = 5.9375000000000000e-01;
  /* #101: @5 = (@5*@6) */
  w5 *= w6;
  /* #102: @7 = 384 */
  w7 = 384.;
  /* #103: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #104: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #105: @5 = 0.625 */
  w5 = 6.2500000000000000e-01;
  /* #106: @5 = (@5*@6) */
  w5 *= w6;
  /* #107: @7 = 384 */
  w7 = 384.;
  /* #108: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #109: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #110: @5 = 0.65625 */
  w5 = 6.5625000000000000e-01;
  /* #111: @5 = (@5*@6) */
  w5 *= w6;
  /* #112: @7 = 384 */
  w7 = 384.;
  /* #113: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #114: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #115: @5 = 0.6875 */
  w5 = 6.8750000000000000e-01;
  /* #116: @5 = (@5*@6) */
  w5 *= w6;
  /* #117: @7 = 384 */
  w7 = 384.;
  /* #118: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #119: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #120: @5 = 0.71875 */
  w5 = 7.1875000000000000e-01;
  /* #121: @5 = (@5*@6) */
  w5 *= w6;
  /* #122: @7 = 384 */
  w7 = 384.;
  /* #123: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #124: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #125: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #126: @5 = (@5*@6) */
  w5 *= w6;
  /* #127: @7 = 384 */
  w7 = 384.;
  /* #128: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #129: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #130: @5 = 0.78125 */
  w5 = 7.8125000000000000e-01;
  /* #131: @5 = (@5*@6) */
  w5 *= w6;
  /* #132: @7 = 384 */
  w7 = 384.;
  /* #133: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #134: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #135: @5 = 0.8125 */
  w5 = 8.1250000000000000e-01;
  /* #136: @5 = (@5*@6) */
  w5 *= w6;
  /* #137: @7 = 384 */
  w7 = 384.;
  /* #138: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #139: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #140: @5 = 0.84375 */
  w5 = 8.4375000000000000e-01;
  /* #141: @5 = (@5*@6) */
  w5 *= w6;
  /* #142: @7 = 384 */
  w7 = 384.;
  /* #143: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #144: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #145: @5 = 0.875 */
  w5 = 8.7500000000000000e-01;
  /* #146: @5 = (@5*@6) */
  w5 *= w6;
  /* #147: @7 = 384 */
  w7 = 384.;
  /* #148: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #149: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #150: @5 = 0.90625 */
  w5 = 9.0625000000000000e-01;
  /* #151: @5 = (@5*@6) */
  w5 *= w6;
  /* #152: @7 = 384 */
  w7 = 384.;
  /* #153: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #154: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #155: @5 = 0.9375 */
  w5 = 9.3750000000000000e-01;
  /* #156: @5 = (@5*@6) */
  w5 *= w6;
  /* #157: @7 = 384 */
  w7 = 384.;
  /* #158: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #159: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #160: @5 = 0.96875 */
  w5 = 9.6875000000000000e-01;
  /* #161: @5 = (@5*@6) */
  w5 *= w6;
  /* #162: @7 = 384 */
  w7 = 384.;
  /* #163: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #164: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #165: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #167: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* newton_384:(u0[6],p[8])->(u[6]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 6;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f37(arg+2, res+1, iw, w+108, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 6, res[0]);
  return 0;
}

/* jacobian_384:(u[6],p[8])->(J[6x6],R[6]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+397, *w1=w+403, *w2=w+408, *w3=w+414, *w4=w+444, w5, w6, w7, *w9=w+480;
  const casadi_real **arg1=arg+2, *cs, *wr8;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = @0[:5] */
  for (rr=w1, cs=w0+0; cs!=w0+5; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<6; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<30; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[5] */
  for (rr=(&w6), cs=w0+5; cs!=w0+6; cs+=1) *rr++ = *cs;
  /* #6: @7 = 384 */
  w7 = 384.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  wr8 = arg[1] ? arg[1] : casadi_zeros;
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: @5 = 0.03125 */
  w5 = 3.1250000000000000e-02;
  /* #11: @5 = (@5*@6) */
  w5 *= w6;
  /* #12: @7 = 384 */
  w7 = 384.;
  /* #13: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #14: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: @5 = 0.0625 */
  w5 = 6.2500000000000000e-02;
  /* #16: @5 = (@5*@6) */
  w5 *= w6;
  /* #17: @7 = 384 */
  w7 = 384.;
  /* #18: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #19: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #20: @5 = 0.09375 */
  w5 = 9.3750000000000000e-02;
  /* #21: @5 = (@5*@6) */
  w5 *= w6;
  /* #22: @7 = 384 */
  w7 = 384.;
  /* #23: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #24: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: @5 = 0.125 */
  w5 = 1.2500000000000000e-01;
  /* #26: @5 = (@5*@6) */
  w5 *= w6;
  /* #27: @7 = 384 */
  w7 = 384.;
  /* #28: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #29: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #30: @5 = 0.15625 */
  w5 = 1.5625000000000000e-01;
  /* #31: @5 = (@5*@6) */
  w5 *= w6;
  /* #32: @7 = 384 */
  w7 = 384.;
  /* #33: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #34: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #35: @5 = 0.1875 */
  w5 = 1.8750000000000000e-01;
  /* #36: @5 = (@5*@6) */
  w5 *= w6;
  /* #37: @7 = 384 */
  w7 = 384.;
  /* #38: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #39: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #40: @5 = 0.21875 */
  w5 = 2.1875000000000000e-01;
  /* #41: @5 = (@5*@6) */
  w5 *= w6;
  /* #42: @7 = 384 */
  w7 = 384.;
  /* #43: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #44: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: @5 = 0.25 */
  w5 = 2.5000000000000000e-01;
  /* #46: @5 = (@5*@6) */
  w5 *= w6;
  /* #47: @7 = 384 */
  w7 = 384.;
  /* #48: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #49: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #50: @5 = 0.28125 */
  w5 = 2.8125000000000000e-01;
  /* #51: @5 = (@5*@6) */
  w5 *= w6;
  /* #52: @7 = 384 */
  w7 = 384.;
  /* #53: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #54: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #55: @5 = 0.3125 */
  w5 = 3.1250000000000000e-01;
  /* #56: @5 = (@5*@6) */
  w5 *= w6;
  /* #57: @7 = 384 */
  w7 = 384.;
  /* #58: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #59: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #60: @5 = 0.34375 */
  w5 = 3.4375000000000000e-01;
  /* #61: @5 = (@5*@6) */
  w5 *= w6;
  /* #62: @7 = 384 */
  w7 = 384.;
  /* #63: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #64: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #65: @5 = 0.375 */
  w5 = 3.7500000000000000e-01;
  /* #66: @5 = (@5*@6) */
  w5 *= w6;
  /* #67: @7 = 384 */
  w7 = 384.;
  /* #68: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #69: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #70: @5 = 0.40625 */
  w5 = 4.0625000000000000e-01;
  /* #71: @5 = (@5*@6) */
  w5 *= w6;
  /* #72: @7 = 384 */
  w7 = 384.;
  /* #73: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #74: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #75: @5 = 0.4375 */
  w5 = 4.3750000000000000e-01;
  /* #76: @5 = (@5*@6) */
  w5 *= w6;
  /* #77: @7 = 384 */
  w7 = 384.;
  /* #78: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #79: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #80: @5 = 0.46875 */
  w5 = 4.6875000000000000e-01;
  /* #81: @5 = (@5*@6) */
  w5 *= w6;
  /* #82: @7 = 384 */
  w7 = 384.;
  /* #83: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #84: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #85: @5 = 0.5 */
  w5 = 5.0000000000000000e-01;
  /* #86: @5 = (@5*@6) */
  w5 *= w6;
  /* #87: @7 = 384 */
  w7 = 384.;
  /* #88: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #89: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #90: @5 = 0.53125 */
  w5 = 5.3125000000000000e-01;
  /* #91: @5 = (@5*@6) */
  w5 *= w6;
  /* #92: @7 = 384 */
  w7 = 384.;
  /* #93: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #94: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #95: @5 = 0.5625 */
  w5 = 5.6250000000000000e-01;
  /* #96: @5 = (@5*@6) */
  w5 *= w6;
  /* #97: @7 = 384 */
  w7 = 384.;
  /* #98: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #99: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #100: @5 = 0.59375 */
  w5 = 5.9375000000000000e-01;
  /* #101: @5 = (@5*@6) */
  w5 *= w6;
  /* #102: @7 = 384 */
  w7 = 384.;
  /* #103: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #104: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #105: @5 = 0.625 */
  w5 = 6.2500000000000000e-01;
  /* #106: @5 = (@5*@6) */
  w5 *= w6;
  /* #107: @7 = 384 */
  w7 = 384.;
  /* #108: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #109: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #110: @5 = 0.65625 */
  w5 = 6.5625000000000000e-01;
  /* #111: @5 = (@5*@6) */
  w5 *= w6;
  /* #112: @7 = 384 */
  w7 = 384.;
  /* #113: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #114: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #115: @5 = 0.6875 */
  w5 = 6.8750000000000000e-01;
  /* #116: @5 = (@5*@6) */
  w5 *= w6;
  /* #117: @7 = 384 */
  w7 = 384.;
  /* #118: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #119: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #120: @5 = 0.71875 */
  w5 = 7.1875000000000000e-01;
  /* #121: @5 = (@5*@6) */
  w5 *= w6;
  /* #122: @7 = 384 */
  w7 = 384.;
  /* #123: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #124: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #125: @5 = 0.75 */
  w5 = 7.5000000000000000e-01;
  /* #126: @5 = (@5*@6) */
  w5 *= w6;
  /* #127: @7 = 384 */
  w7 = 384.;
  /* #128: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #129: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #130: @5 = 0.78125 */
  w5 = 7.8125000000000000e-01;
  /* #131: @5 = (@5*@6) */
  w5 *= w6;
  /* #132: @7 = 384 */
  w7 = 384.;
  /* #133: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #134: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #135: @5 = 0.8125 */
  w5 = 8.1250000000000000e-01;
  /* #136: @5 = (@5*@6) */
  w5 *= w6;
  /* #137: @7 = 384 */
  w7 = 384.;
  /* #138: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #139: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #140: @5 = 0.84375 */
  w5 = 8.4375000000000000e-01;
  /* #141: @5 = (@5*@6) */
  w5 *= w6;
  /* #142: @7 = 384 */
  w7 = 384.;
  /* #143: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #144: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #145: @5 = 0.875 */
  w5 = 8.7500000000000000e-01;
  /* #146: @5 = (@5*@6) */
  w5 *= w6;
  /* #147: @7 = 384 */
  w7 = 384.;
  /* #148: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #149: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #150: @5 = 0.90625 */
  w5 = 9.0625000000000000e-01;
  /* #151: @5 = (@5*@6) */
  w5 *= w6;
  /* #152: @7 = 384 */
  w7 = 384.;
  /* #153: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #154: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #155: @5 = 0.9375 */
  w5 = 9.3750000000000000e-01;
  /* #156: @5 = (@5*@6) */
  w5 *= w6;
  /* #157: @7 = 384 */
  w7 = 384.;
  /* #158: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #159: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #160: @5 = 0.96875 */
  w5 = 9.6875000000000000e-01;
  /* #161: @5 = (@5*@6) */
  w5 *= w6;
  /* #162: @7 = 384 */
  w7 = 384.;
  /* #163: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #164: @4 = variational_steps(@9, @5, @7, @8) */
  arg1[0]=w9;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=wr8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #165: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=wr8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][0] = @9 */
  casadi_copy(w9, 36, res[0]);
  /* #167: output[1][0] = @0 */
  casadi_copy(w0, 6, res[1]);
  return 0;
}

/* wobbling_limit_cycle_384:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+647, *w2=w+653, *w3=w+659;
  const casadi_real **arg1=arg+2, *wr1;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 6, w0);
  /* #1: @1 = input[1][0] */
  wr1 = arg[1] ? arg[1] : casadi_zeros;
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=wr1;
  res1[0]=w2;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 6, res[0]);
  /* #4: {@3, @0} = jacobian_384(@2, @1) */
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

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f35(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 695*sizeof(casadi_real);
  return 0;
}

/* working_step:(t,w[7],h,p[8])->(w_end[7]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115;
  a000=arg[1]? arg[1][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[2]? arg[2][0] : 0;
  a001=(a001*a002);
  a003=arg[1]? arg[1][3] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[3]? arg[3][3] : 0;
  a008=arg[1]? arg[1][4] : 0;
  a009=(a007*a008);
  a010=arg[1]? arg[1][1] : 0;
  a011=sin(a010);
  a009=(a009*a011);
  a012=(2.*a003);
  a012=(a008-a012);
  a009=(a009*a012);
  a012=sin(a000);
  a013=(a000-a010);
  a013=sin(a013);
  a014=(a012-a013);
  a014=(a007*a014);
  a009=(a009+a014);
  a009=(a009+a012);
  a014=(2.*a007);
  a015=1.;
  a016=cos(a010);
  a017=(a015-a016);
  a017=(a014*a017);
  a017=(a017+a015);
  a018=(a009/a017);
  a016=(a016-a015);
  a016=(a007*a016);
  a019=(a016/a017);
  a020=casadi_sq(a003);
  a020=(a020*a011);
  a020=(a020+a013);
  a020=(a007*a020);
  a013=arg[3]? arg[3][5] : 0;
  a011=arg[3]? arg[3][7] : 0;
  a021=arg[3]? arg[3][2] : 0;
  a022=(a011*a021);
  a023=arg[0]? arg[0][0] : 0;
  a024=(a021*a023);
  a025=sin(a024);
  a025=(a022*a025);
  a025=(a008+a025);
  a025=(a013*a025);
  a026=arg[3]? arg[3][4] : 0;
  a027=arg[3]? arg[3][6] : 0;
  a024=cos(a024);
  a024=(a024+a015);
  a024=(a011*a024);
  a024=(a027-a024);
  a024=(a024+a010);
  a024=(a026*a024);
  a025=(a025+a024);
  a020=(a020-a025);
  a024=(a019*a009);
  a020=(a020-a024);
  a024=(a016*a019);
  a024=(a007-a024);
  a028=(a020/a024);
  a029=arg[3]? arg[3][1] : 0;
  a030=cos(a000);
  a030=(a029*a030);
  a017=(a030/a017);
  a016=(a016*a017);
  a024=(a016/a024);
  a009=(a017*a009);
  a031=(a029*a003);
  a031=(a031*a003);
  a031=(a031*a012);
  a012=arg[3]? arg[3][0] : 0;
  a032=arg[1]? arg[1][2] : 0;
  a033=(a012*a032);
  a031=(a031+a033);
  a009=(a009-a031);
  a020=(a024*a020);
  a009=(a009-a020);
  a030=(a030*a017);
  a030=(a029-a030);
  a016=(a016*a024);
  a030=(a030-a016);
  a009=(a009/a030);
  a024=(a024*a009);
  a028=(a028-a024);
  a019=(a019*a028);
  a018=(a018-a019);
  a017=(a017*a009);
  a018=(a018+a017);
  a017=(a006*a018);
  a019=1.7082860872947386e-01;
  a019=(a019*a002);
  a024=2.9587585476806851e-02;
  a024=(a024*a002);
  a030=(a024*a028);
  a016=8.8762756430420545e-02;
  a016=(a016*a002);
  a020=1.9725056984537900e-02;
  a020=(a020*a002);
  a031=(a020*a018);
  a033=5.9175170953613701e-02;
  a033=(a033*a002);
  a034=5.2600151958767730e-02;
  a034=(a034*a002);
  a035=(a034*a028);
  a035=(a008+a035);
  a036=(a007*a035);
  a037=(a034*a008);
  a037=(a010+a037);
  a038=sin(a037);
  a036=(a036*a038);
  a039=(a034*a018);
  a039=(a003+a039);
  a040=(2.*a039);
  a040=(a035-a040);
  a036=(a036*a040);
  a040=(a034*a003);
  a040=(a000+a040);
  a041=sin(a040);
  a042=(a040-a037);
  a042=sin(a042);
  a043=(a041-a042);
  a043=(a007*a043);
  a036=(a036+a043);
  a036=(a036+a041);
  a043=cos(a037);
  a044=(a015-a043);
  a044=(a014*a044);
  a044=(a044+a015);
  a045=(a036/a044);
  a043=(a043-a015);
  a043=(a007*a043);
  a046=(a043/a044);
  a047=casadi_sq(a039);
  a047=(a047*a038);
  a047=(a047+a042);
  a047=(a007*a047);
  a042=(a023+a034);
  a042=(a021*a042);
  a038=sin(a042);
  a038=(a022*a038);
  a038=(a035+a038);
  a038=(a013*a038);
  a042=cos(a042);
  a042=(a042+a015);
  a042=(a011*a042);
  a042=(a027-a042);
  a042=(a042+a037);
  a042=(a026*a042);
  a038=(a038+a042);
  a047=(a047-a038);
  a038=(a046*a036);
  a047=(a047-a038);
  a038=(a043*a046);
  a038=(a007-a038);
  a042=(a047/a038);
  a040=cos(a040);
  a040=(a029*a040);
  a044=(a040/a044);
  a043=(a043*a044);
  a038=(a043/a038);
  a036=(a044*a036);
  a037=(a029*a039);
  a037=(a037*a039);
  a037=(a037*a041);
  a041=arg[1]? arg[1][5] : 0;
  a048=(a034*a041);
  a048=(a032+a048);
  a048=(a012*a048);
  a037=(a037+a048);
  a036=(a036-a037);
  a047=(a038*a047);
  a036=(a036-a047);
  a040=(a040*a044);
  a040=(a029-a040);
  a043=(a043*a038);
  a040=(a040-a043);
  a036=(a036/a040);
  a038=(a038*a036);
  a042=(a042-a038);
  a046=(a046*a042);
  a045=(a045-a046);
  a044=(a044*a036);
  a045=(a045+a044);
  a045=(a033*a045);
  a031=(a031+a045);
  a031=(a003+a031);
  a045=casadi_sq(a031);
  a044=(a020*a008);
  a035=(a033*a035);
  a044=(a044+a035);
  a044=(a010+a044);
  a035=sin(a044);
  a045=(a045*a035);
  a046=(a020*a003);
  a039=(a033*a039);
  a046=(a046+a039);
  a046=(a000+a046);
  a039=(a046-a044);
  a039=sin(a039);
  a045=(a045+a039);
  a045=(a007*a045);
  a038=(a020*a028);
  a042=(a033*a042);
  a038=(a038+a042);
  a038=(a008+a038);
  a042=7.8900227938151601e-02;
  a042=(a042*a002);
  a042=(a023+a042);
  a042=(a021*a042);
  a040=sin(a042);
  a040=(a022*a040);
  a040=(a038+a040);
  a040=(a013*a040);
  a042=cos(a042);
  a042=(a042+a015);
  a042=(a011*a042);
  a042=(a027-a042);
  a042=(a042+a044);
  a042=(a026*a042);
  a040=(a040+a042);
  a045=(a045-a040);
  a044=cos(a044);
  a040=(a044-a015);
  a040=(a007*a040);
  a044=(a015-a044);
  a044=(a014*a044);
  a044=(a044+a015);
  a042=(a040/a044);
  a043=(a007*a038);
  a043=(a043*a035);
  a035=(2.*a031);
  a035=(a038-a035);
  a043=(a043*a035);
  a035=sin(a046);
  a039=(a035-a039);
  a039=(a007*a039);
  a043=(a043+a039);
  a043=(a043+a035);
  a039=(a042*a043);
  a045=(a045-a039);
  a039=(a040*a042);
  a039=(a007-a039);
  a047=(a045/a039);
  a046=cos(a046);
  a046=(a029*a046);
  a037=(a046/a044);
  a040=(a040*a037);
  a039=(a040/a039);
  a048=(a037*a043);
  a049=(a029*a031);
  a049=(a049*a031);
  a049=(a049*a035);
  a035=(a020*a041);
  a034=(a034*a009);
  a034=(a041+a034);
  a034=(a033*a034);
  a035=(a035+a034);
  a035=(a032+a035);
  a035=(a012*a035);
  a049=(a049+a035);
  a048=(a048-a049);
  a045=(a039*a045);
  a048=(a048-a045);
  a046=(a046*a037);
  a046=(a029-a046);
  a040=(a040*a039);
  a046=(a046-a040);
  a048=(a048/a046);
  a039=(a039*a048);
  a047=(a047-a039);
  a039=(a016*a047);
  a030=(a030+a039);
  a030=(a008+a030);
  a039=(a007*a030);
  a046=(a024*a008);
  a040=(a016*a038);
  a046=(a046+a040);
  a046=(a010+a046);
  a040=sin(a046);
  a039=(a039*a040);
  a045=(a024*a018);
  a043=(a043/a044);
  a042=(a042*a047);
  a043=(a043-a042);
  a037=(a037*a048);
  a043=(a043+a037);
  a037=(a016*a043);
  a045=(a045+a037);
  a045=(a003+a045);
  a037=(2.*a045);
  a037=(a030-a037);
  a039=(a039*a037);
  a037=(a024*a003);
  a042=(a016*a031);
  a037=(a037+a042);
  a037=(a000+a037);
  a042=sin(a037);
  a044=(a037-a046);
  a044=sin(a044);
  a049=(a042-a044);
  a049=(a007*a049);
  a039=(a039+a049);
  a039=(a039+a042);
  a049=cos(a046);
  a035=(a015-a049);
  a035=(a014*a035);
  a035=(a035+a015);
  a034=(a039/a035);
  a049=(a049-a015);
  a049=(a007*a049);
  a050=(a049/a035);
  a051=casadi_sq(a045);
  a051=(a051*a040);
  a051=(a051+a044);
  a051=(a007*a051);
  a044=1.1835034190722740e-01;
  a044=(a044*a002);
  a044=(a023+a044);
  a044=(a021*a044);
  a040=sin(a044);
  a040=(a022*a040);
  a040=(a030+a040);
  a040=(a013*a040);
  a044=cos(a044);
  a044=(a044+a015);
  a044=(a011*a044);
  a044=(a027-a044);
  a044=(a044+a046);
  a044=(a026*a044);
  a040=(a040+a044);
  a051=(a051-a040);
  a040=(a050*a039);
  a051=(a051-a040);
  a040=(a049*a050);
  a040=(a007-a040);
  a044=(a051/a040);
  a037=cos(a037);
  a037=(a029*a037);
  a035=(a037/a035);
  a049=(a049*a035);
  a040=(a049/a040);
  a039=(a035*a039);
  a046=(a029*a045);
  a046=(a046*a045);
  a046=(a046*a042);
  a042=(a024*a041);
  a020=(a020*a009);
  a033=(a033*a036);
  a020=(a020+a033);
  a020=(a041+a020);
  a033=(a016*a020);
  a042=(a042+a033);
  a042=(a032+a042);
  a042=(a012*a042);
  a046=(a046+a042);
  a039=(a039-a046);
  a051=(a040*a051);
  a039=(a039-a051);
  a037=(a037*a035);
  a037=(a029-a037);
  a049=(a049*a040);
  a037=(a037-a049);
  a039=(a039/a037);
  a040=(a040*a039);
  a044=(a044-a040);
  a050=(a050*a044);
  a034=(a034-a050);
  a035=(a035*a039);
  a034=(a034+a035);
  a035=(a019*a034);
  a017=(a017+a035);
  a035=1.2546768756682242e-01;
  a035=(a035*a002);
  a050=2.4136513415926669e-01;
  a050=(a050*a002);
  a040=(a050*a028);
  a037=-8.8454947932828609e-01;
  a037=(a037*a002);
  a047=(a037*a047);
  a040=(a040+a047);
  a047=9.2483400326179199e-01;
  a047=(a047*a002);
  a049=(a047*a044);
  a040=(a040+a049);
  a040=(a008+a040);
  a049=(a007*a040);
  a051=(a050*a008);
  a038=(a037*a038);
  a051=(a051+a038);
  a038=(a047*a030);
  a051=(a051+a038);
  a051=(a010+a051);
  a038=sin(a051);
  a049=(a049*a038);
  a046=(a050*a018);
  a043=(a037*a043);
  a046=(a046+a043);
  a043=(a047*a034);
  a046=(a046+a043);
  a046=(a003+a046);
  a043=(2.*a046);
  a043=(a040-a043);
  a049=(a049*a043);
  a043=(a050*a003);
  a031=(a037*a031);
  a043=(a043+a031);
  a031=(a047*a045);
  a043=(a043+a031);
  a043=(a000+a043);
  a031=sin(a043);
  a042=(a043-a051);
  a042=sin(a042);
  a033=(a031-a042);
  a033=(a007*a033);
  a049=(a049+a033);
  a049=(a049+a031);
  a033=cos(a051);
  a036=(a015-a033);
  a036=(a014*a036);
  a036=(a036+a015);
  a052=(a049/a036);
  a033=(a033-a015);
  a033=(a007*a033);
  a053=(a033/a036);
  a054=casadi_sq(a046);
  a054=(a054*a038);
  a054=(a054+a042);
  a054=(a007*a054);
  a042=2.8164965809277259e-01;
  a042=(a042*a002);
  a042=(a023+a042);
  a042=(a021*a042);
  a038=sin(a042);
  a038=(a022*a038);
  a038=(a040+a038);
  a038=(a013*a038);
  a042=cos(a042);
  a042=(a042+a015);
  a042=(a011*a042);
  a042=(a027-a042);
  a042=(a042+a051);
  a042=(a026*a042);
  a038=(a038+a042);
  a054=(a054-a038);
  a038=(a053*a049);
  a054=(a054-a038);
  a038=(a033*a053);
  a038=(a007-a038);
  a042=(a054/a038);
  a043=cos(a043);
  a043=(a029*a043);
  a036=(a043/a036);
  a033=(a033*a036);
  a038=(a033/a038);
  a049=(a036*a049);
  a051=(a029*a046);
  a051=(a051*a046);
  a051=(a051*a031);
  a031=(a050*a041);
  a020=(a037*a020);
  a031=(a031+a020);
  a024=(a024*a009);
  a016=(a016*a048);
  a024=(a024+a016);
  a024=(a041+a024);
  a016=(a047*a024);
  a031=(a031+a016);
  a031=(a032+a031);
  a031=(a012*a031);
  a051=(a051+a031);
  a049=(a049-a051);
  a054=(a038*a054);
  a049=(a049-a054);
  a043=(a043*a036);
  a043=(a029-a043);
  a033=(a033*a038);
  a043=(a043-a033);
  a049=(a049/a043);
  a038=(a038*a049);
  a042=(a042-a038);
  a053=(a053*a042);
  a052=(a052-a053);
  a036=(a036*a049);
  a052=(a052+a036);
  a036=(a035*a052);
  a017=(a017+a036);
  a017=(a003+a017);
  a036=(a005*a017);
  a004=(a004+a036);
  a036=1.8915178993145003e+00;
  a036=(a036*a002);
  a053=3.7109375000000000e-02;
  a053=(a053*a002);
  a038=(a053*a018);
  a043=1.7025221101954405e-01;
  a043=(a043*a002);
  a033=(a043*a034);
  a038=(a038+a033);
  a033=6.0216538980455959e-02;
  a033=(a033*a002);
  a054=(a033*a052);
  a038=(a038+a054);
  a054=-1.7578125000000000e-02;
  a054=(a054*a002);
  a051=(a006*a028);
  a031=(a019*a044);
  a051=(a051+a031);
  a031=(a035*a042);
  a051=(a051+a031);
  a051=(a008+a051);
  a031=(a007*a051);
  a016=(a006*a008);
  a020=(a019*a030);
  a016=(a016+a020);
  a020=(a035*a040);
  a016=(a016+a020);
  a016=(a010+a016);
  a020=sin(a016);
  a031=(a031*a020);
  a055=(2.*a017);
  a055=(a051-a055);
  a031=(a031*a055);
  a055=(a006*a003);
  a056=(a019*a045);
  a055=(a055+a056);
  a056=(a035*a046);
  a055=(a055+a056);
  a055=(a000+a055);
  a056=sin(a055);
  a057=(a055-a016);
  a057=sin(a057);
  a058=(a056-a057);
  a058=(a007*a058);
  a031=(a031+a058);
  a031=(a031+a056);
  a058=cos(a016);
  a059=(a015-a058);
  a059=(a014*a059);
  a059=(a059+a015);
  a060=(a031/a059);
  a058=(a058-a015);
  a058=(a007*a058);
  a061=(a058/a059);
  a062=casadi_sq(a017);
  a062=(a062*a020);
  a062=(a062+a057);
  a062=(a007*a062);
  a057=3.3333333333333331e-01;
  a057=(a057*a002);
  a057=(a023+a057);
  a057=(a021*a057);
  a020=sin(a057);
  a020=(a022*a020);
  a020=(a051+a020);
  a020=(a013*a020);
  a057=cos(a057);
  a057=(a057+a015);
  a057=(a011*a057);
  a057=(a027-a057);
  a057=(a057+a016);
  a057=(a026*a057);
  a020=(a020+a057);
  a062=(a062-a020);
  a057=(a061*a031);
  a062=(a062-a057);
  a057=(a058*a061);
  a057=(a007-a057);
  a016=(a062/a057);
  a055=cos(a055);
  a055=(a029*a055);
  a059=(a055/a059);
  a058=(a058*a059);
  a057=(a058/a057);
  a031=(a059*a031);
  a063=(a029*a017);
  a063=(a063*a017);
  a063=(a063*a056);
  a056=(a006*a041);
  a064=(a019*a024);
  a056=(a056+a064);
  a050=(a050*a009);
  a037=(a037*a048);
  a050=(a050+a037);
  a047=(a047*a039);
  a050=(a050+a047);
  a050=(a041+a050);
  a047=(a035*a050);
  a056=(a056+a047);
  a056=(a032+a056);
  a056=(a012*a056);
  a063=(a063+a056);
  a031=(a031-a063);
  a062=(a057*a062);
  a031=(a031-a062);
  a055=(a055*a059);
  a055=(a029-a055);
  a058=(a058*a057);
  a055=(a055-a058);
  a031=(a031/a055);
  a057=(a057*a031);
  a016=(a016-a057);
  a061=(a061*a016);
  a060=(a060-a061);
  a059=(a059*a031);
  a060=(a060+a059);
  a059=(a054*a060);
  a038=(a038+a059);
  a038=(a003+a038);
  a059=(a036*a038);
  a004=(a004+a059);
  a059=-5.8012039600105849e+00;
  a059=(a059*a002);
  a061=3.7092000118504789e-02;
  a061=(a061*a002);
  a057=(a061*a018);
  a055=1.7038392571223998e-01;
  a055=(a055*a002);
  a058=(a055*a034);
  a057=(a057+a058);
  a058=1.0726203044637328e-01;
  a058=(a058*a002);
  a062=(a058*a052);
  a057=(a057+a062);
  a062=-1.5319437748624402e-02;
  a062=(a062*a002);
  a063=(a062*a060);
  a057=(a057+a063);
  a063=8.2737891638140233e-03;
  a063=(a063*a002);
  a056=(a053*a028);
  a047=(a043*a044);
  a056=(a056+a047);
  a047=(a033*a042);
  a056=(a056+a047);
  a047=(a054*a016);
  a056=(a056+a047);
  a056=(a008+a056);
  a047=(a007*a056);
  a037=(a053*a008);
  a048=(a043*a030);
  a037=(a037+a048);
  a048=(a033*a040);
  a037=(a037+a048);
  a048=(a054*a051);
  a037=(a037+a048);
  a037=(a010+a037);
  a048=sin(a037);
  a047=(a047*a048);
  a064=(2.*a038);
  a064=(a056-a064);
  a047=(a047*a064);
  a064=(a053*a003);
  a065=(a043*a045);
  a064=(a064+a065);
  a065=(a033*a046);
  a064=(a064+a065);
  a065=(a054*a017);
  a064=(a064+a065);
  a064=(a000+a064);
  a065=sin(a064);
  a066=(a064-a037);
  a066=sin(a066);
  a067=(a065-a066);
  a067=(a007*a067);
  a047=(a047+a067);
  a047=(a047+a065);
  a067=cos(a037);
  a068=(a015-a067);
  a068=(a014*a068);
  a068=(a068+a015);
  a069=(a047/a068);
  a067=(a067-a015);
  a067=(a007*a067);
  a070=(a067/a068);
  a071=casadi_sq(a038);
  a071=(a071*a048);
  a071=(a071+a066);
  a071=(a007*a071);
  a066=2.5000000000000000e-01;
  a066=(a066*a002);
  a066=(a023+a066);
  a066=(a021*a066);
  a048=sin(a066);
  a048=(a022*a048);
  a048=(a056+a048);
  a048=(a013*a048);
  a066=cos(a066);
  a066=(a066+a015);
  a066=(a011*a066);
  a066=(a027-a066);
  a066=(a066+a037);
  a066=(a026*a066);
  a048=(a048+a066);
  a071=(a071-a048);
  a066=(a070*a047);
  a071=(a071-a066);
  a066=(a067*a070);
  a066=(a007-a066);
  a037=(a071/a066);
  a064=cos(a064);
  a064=(a029*a064);
  a068=(a064/a068);
  a067=(a067*a068);
  a066=(a067/a066);
  a047=(a068*a047);
  a072=(a029*a038);
  a072=(a072*a038);
  a072=(a072*a065);
  a065=(a053*a041);
  a073=(a043*a024);
  a065=(a065+a073);
  a073=(a033*a050);
  a065=(a065+a073);
  a006=(a006*a009);
  a019=(a019*a039);
  a006=(a006+a019);
  a035=(a035*a049);
  a006=(a006+a035);
  a006=(a041+a006);
  a035=(a054*a006);
  a065=(a065+a035);
  a065=(a032+a065);
  a065=(a012*a065);
  a072=(a072+a065);
  a047=(a047-a072);
  a071=(a066*a071);
  a047=(a047-a071);
  a064=(a064*a068);
  a064=(a029-a064);
  a067=(a067*a066);
  a064=(a064-a067);
  a047=(a047/a064);
  a066=(a066*a047);
  a037=(a037-a066);
  a070=(a070*a037);
  a069=(a069-a070);
  a068=(a068*a047);
  a069=(a069+a068);
  a068=(a063*a069);
  a057=(a057+a068);
  a057=(a003+a057);
  a068=(a059*a057);
  a004=(a004+a068);
  a068=3.1116436695781990e-01;
  a068=(a068*a002);
  a070=6.2411095871607569e-01;
  a070=(a070*a002);
  a066=(a070*a018);
  a064=-3.3608926294469414e+00;
  a064=(a064*a002);
  a067=(a064*a034);
  a066=(a066+a067);
  a067=-8.6821934684172597e-01;
  a067=(a067*a002);
  a071=(a067*a052);
  a066=(a066+a071);
  a071=2.7592099699446710e+01;
  a071=(a071*a002);
  a072=(a071*a060);
  a066=(a066+a072);
  a072=2.0154067550477894e+01;
  a072=(a072*a002);
  a065=(a072*a069);
  a066=(a066+a065);
  a065=-4.3489884181069961e+01;
  a065=(a065*a002);
  a035=(a061*a028);
  a019=(a055*a044);
  a035=(a035+a019);
  a019=(a058*a042);
  a035=(a035+a019);
  a019=(a062*a016);
  a035=(a035+a019);
  a019=(a063*a037);
  a035=(a035+a019);
  a035=(a008+a035);
  a019=(a007*a035);
  a073=(a061*a008);
  a074=(a055*a030);
  a073=(a073+a074);
  a074=(a058*a040);
  a073=(a073+a074);
  a074=(a062*a051);
  a073=(a073+a074);
  a074=(a063*a056);
  a073=(a073+a074);
  a073=(a010+a073);
  a074=sin(a073);
  a019=(a019*a074);
  a075=(2.*a057);
  a075=(a035-a075);
  a019=(a019*a075);
  a075=(a061*a003);
  a076=(a055*a045);
  a075=(a075+a076);
  a076=(a058*a046);
  a075=(a075+a076);
  a076=(a062*a017);
  a075=(a075+a076);
  a076=(a063*a038);
  a075=(a075+a076);
  a075=(a000+a075);
  a076=sin(a075);
  a077=(a075-a073);
  a077=sin(a077);
  a078=(a076-a077);
  a078=(a007*a078);
  a019=(a019+a078);
  a019=(a019+a076);
  a078=cos(a073);
  a079=(a015-a078);
  a079=(a014*a079);
  a079=(a079+a015);
  a080=(a019/a079);
  a078=(a078-a015);
  a078=(a007*a078);
  a081=(a078/a079);
  a082=casadi_sq(a057);
  a082=(a082*a074);
  a082=(a082+a077);
  a082=(a007*a082);
  a077=3.0769230769230771e-01;
  a077=(a077*a002);
  a077=(a023+a077);
  a077=(a021*a077);
  a074=sin(a077);
  a074=(a022*a074);
  a074=(a035+a074);
  a074=(a013*a074);
  a077=cos(a077);
  a077=(a077+a015);
  a077=(a011*a077);
  a077=(a027-a077);
  a077=(a077+a073);
  a077=(a026*a077);
  a074=(a074+a077);
  a082=(a082-a074);
  a077=(a081*a019);
  a082=(a082-a077);
  a077=(a078*a081);
  a077=(a007-a077);
  a073=(a082/a077);
  a075=cos(a075);
  a075=(a029*a075);
  a079=(a075/a079);
  a078=(a078*a079);
  a077=(a078/a077);
  a019=(a079*a019);
  a083=(a029*a057);
  a083=(a083*a057);
  a083=(a083*a076);
  a076=(a061*a041);
  a084=(a055*a024);
  a076=(a076+a084);
  a084=(a058*a050);
  a076=(a076+a084);
  a084=(a062*a006);
  a076=(a076+a084);
  a053=(a053*a009);
  a043=(a043*a039);
  a053=(a053+a043);
  a033=(a033*a049);
  a053=(a053+a033);
  a054=(a054*a031);
  a053=(a053+a054);
  a053=(a041+a053);
  a054=(a063*a053);
  a076=(a076+a054);
  a076=(a032+a076);
  a076=(a012*a076);
  a083=(a083+a076);
  a019=(a019-a083);
  a082=(a077*a082);
  a019=(a019-a082);
  a075=(a075*a079);
  a075=(a029-a075);
  a078=(a078*a077);
  a075=(a075-a078);
  a019=(a019/a075);
  a077=(a077*a019);
  a073=(a073-a077);
  a081=(a081*a073);
  a080=(a080-a081);
  a079=(a079*a019);
  a080=(a080+a079);
  a079=(a065*a080);
  a066=(a066+a079);
  a066=(a003+a066);
  a079=(a068*a066);
  a004=(a004+a079);
  a079=-1.5216094966251609e-01;
  a079=(a079*a002);
  a081=4.7766253643826434e-01;
  a081=(a081*a002);
  a077=(a081*a018);
  a075=-2.4881146199716677e+00;
  a075=(a075*a002);
  a078=(a075*a034);
  a077=(a077+a078);
  a078=-5.9029082683684297e-01;
  a078=(a078*a002);
  a082=(a078*a052);
  a077=(a077+a082);
  a082=2.1230051448181193e+01;
  a082=(a082*a002);
  a083=(a082*a060);
  a077=(a077+a083);
  a083=1.5279233632882423e+01;
  a083=(a083*a002);
  a076=(a083*a069);
  a077=(a077+a076);
  a076=-3.3288210968984863e+01;
  a076=(a076*a002);
  a054=(a076*a080);
  a077=(a077+a054);
  a054=-2.0331201708508627e-02;
  a054=(a054*a002);
  a033=(a070*a028);
  a043=(a064*a044);
  a033=(a033+a043);
  a043=(a067*a042);
  a033=(a033+a043);
  a043=(a071*a016);
  a033=(a033+a043);
  a043=(a072*a037);
  a033=(a033+a043);
  a043=(a065*a073);
  a033=(a033+a043);
  a033=(a008+a033);
  a043=(a007*a033);
  a084=(a070*a008);
  a085=(a064*a030);
  a084=(a084+a085);
  a085=(a067*a040);
  a084=(a084+a085);
  a085=(a071*a051);
  a084=(a084+a085);
  a085=(a072*a056);
  a084=(a084+a085);
  a085=(a065*a035);
  a084=(a084+a085);
  a084=(a010+a084);
  a085=sin(a084);
  a043=(a043*a085);
  a086=(2.*a066);
  a086=(a033-a086);
  a043=(a043*a086);
  a086=(a070*a003);
  a087=(a064*a045);
  a086=(a086+a087);
  a087=(a067*a046);
  a086=(a086+a087);
  a087=(a071*a017);
  a086=(a086+a087);
  a087=(a072*a038);
  a086=(a086+a087);
  a087=(a065*a057);
  a086=(a086+a087);
  a086=(a000+a086);
  a087=sin(a086);
  a088=(a086-a084);
  a088=sin(a088);
  a089=(a087-a088);
  a089=(a007*a089);
  a043=(a043+a089);
  a043=(a043+a087);
  a089=cos(a084);
  a090=(a015-a089);
  a090=(a014*a090);
  a090=(a090+a015);
  a091=(a043/a090);
  a089=(a089-a015);
  a089=(a007*a089);
  a092=(a089/a090);
  a093=casadi_sq(a066);
  a093=(a093*a085);
  a093=(a093+a088);
  a093=(a007*a093);
  a088=6.5128205128205130e-01;
  a088=(a088*a002);
  a088=(a023+a088);
  a088=(a021*a088);
  a085=sin(a088);
  a085=(a022*a085);
  a085=(a033+a085);
  a085=(a013*a085);
  a088=cos(a088);
  a088=(a088+a015);
  a088=(a011*a088);
  a088=(a027-a088);
  a088=(a088+a084);
  a088=(a026*a088);
  a085=(a085+a088);
  a093=(a093-a085);
  a088=(a092*a043);
  a093=(a093-a088);
  a088=(a089*a092);
  a088=(a007-a088);
  a084=(a093/a088);
  a086=cos(a086);
  a086=(a029*a086);
  a090=(a086/a090);
  a089=(a089*a090);
  a088=(a089/a088);
  a043=(a090*a043);
  a094=(a029*a066);
  a094=(a094*a066);
  a094=(a094*a087);
  a087=(a070*a041);
  a095=(a064*a024);
  a087=(a087+a095);
  a095=(a067*a050);
  a087=(a087+a095);
  a095=(a071*a006);
  a087=(a087+a095);
  a095=(a072*a053);
  a087=(a087+a095);
  a061=(a061*a009);
  a055=(a055*a039);
  a061=(a061+a055);
  a058=(a058*a049);
  a061=(a061+a058);
  a062=(a062*a031);
  a061=(a061+a062);
  a063=(a063*a047);
  a061=(a061+a063);
  a061=(a041+a061);
  a063=(a065*a061);
  a087=(a087+a063);
  a087=(a032+a087);
  a087=(a012*a087);
  a094=(a094+a087);
  a043=(a043-a094);
  a093=(a088*a093);
  a043=(a043-a093);
  a086=(a086*a090);
  a086=(a029-a086);
  a089=(a089*a088);
  a086=(a086-a089);
  a043=(a043/a086);
  a088=(a088*a043);
  a084=(a084-a088);
  a092=(a092*a084);
  a091=(a091-a092);
  a090=(a090*a043);
  a091=(a091+a090);
  a090=(a054*a091);
  a077=(a077+a090);
  a077=(a003+a077);
  a090=(a079*a077);
  a004=(a004+a090);
  a090=2.0136540080403034e-01;
  a090=(a090*a002);
  a092=-9.3714243008598730e-01;
  a092=(a092*a002);
  a088=(a092*a018);
  a086=5.1863724288440638e+00;
  a086=(a086*a002);
  a089=(a086*a034);
  a088=(a088+a089);
  a089=1.0914373489967295e+00;
  a089=(a089*a002);
  a093=(a089*a052);
  a088=(a088+a093);
  a093=-8.1497870107469268e+00;
  a093=(a093*a002);
  a094=(a093*a060);
  a088=(a088+a094);
  a094=-1.8520065659996959e+01;
  a094=(a094*a002);
  a087=(a094*a069);
  a088=(a088+a087);
  a087=2.2739487099350505e+01;
  a087=(a087*a002);
  a063=(a087*a080);
  a088=(a088+a063);
  a063=2.4936055526796523e+00;
  a063=(a063*a002);
  a062=(a063*a091);
  a088=(a088+a062);
  a062=-3.0467644718982196e+00;
  a062=(a062*a002);
  a058=(a081*a028);
  a055=(a075*a044);
  a058=(a058+a055);
  a055=(a078*a042);
  a058=(a058+a055);
  a055=(a082*a016);
  a058=(a058+a055);
  a055=(a083*a037);
  a058=(a058+a055);
  a055=(a076*a073);
  a058=(a058+a055);
  a055=(a054*a084);
  a058=(a058+a055);
  a058=(a008+a058);
  a055=(a007*a058);
  a095=(a081*a008);
  a096=(a075*a030);
  a095=(a095+a096);
  a096=(a078*a040);
  a095=(a095+a096);
  a096=(a082*a051);
  a095=(a095+a096);
  a096=(a083*a056);
  a095=(a095+a096);
  a096=(a076*a035);
  a095=(a095+a096);
  a096=(a054*a033);
  a095=(a095+a096);
  a095=(a010+a095);
  a096=sin(a095);
  a055=(a055*a096);
  a097=(2.*a077);
  a097=(a058-a097);
  a055=(a055*a097);
  a097=(a081*a003);
  a098=(a075*a045);
  a097=(a097+a098);
  a098=(a078*a046);
  a097=(a097+a098);
  a098=(a082*a017);
  a097=(a097+a098);
  a098=(a083*a038);
  a097=(a097+a098);
  a098=(a076*a057);
  a097=(a097+a098);
  a098=(a054*a066);
  a097=(a097+a098);
  a097=(a000+a097);
  a098=sin(a097);
  a099=(a097-a095);
  a099=sin(a099);
  a100=(a098-a099);
  a100=(a007*a100);
  a055=(a055+a100);
  a055=(a055+a098);
  a100=cos(a095);
  a101=(a015-a100);
  a101=(a014*a101);
  a101=(a101+a015);
  a102=(a055/a101);
  a100=(a100-a015);
  a100=(a007*a100);
  a103=(a100/a101);
  a104=casadi_sq(a077);
  a104=(a104*a096);
  a104=(a104+a099);
  a104=(a007*a104);
  a099=5.9999999999999998e-01;
  a099=(a099*a002);
  a099=(a023+a099);
  a099=(a021*a099);
  a096=sin(a099);
  a096=(a022*a096);
  a096=(a058+a096);
  a096=(a013*a096);
  a099=cos(a099);
  a099=(a099+a015);
  a099=(a011*a099);
  a099=(a027-a099);
  a099=(a099+a095);
  a099=(a026*a099);
  a096=(a096+a099);
  a104=(a104-a096);
  a099=(a103*a055);
  a104=(a104-a099);
  a099=(a100*a103);
  a099=(a007-a099);
  a095=(a104/a099);
  a097=cos(a097);
  a097=(a029*a097);
  a101=(a097/a101);
  a100=(a100*a101);
  a099=(a100/a099);
  a055=(a101*a055);
  a105=(a029*a077);
  a105=(a105*a077);
  a105=(a105*a098);
  a098=(a081*a041);
  a106=(a075*a024);
  a098=(a098+a106);
  a106=(a078*a050);
  a098=(a098+a106);
  a106=(a082*a006);
  a098=(a098+a106);
  a106=(a083*a053);
  a098=(a098+a106);
  a106=(a076*a061);
  a098=(a098+a106);
  a070=(a070*a009);
  a064=(a064*a039);
  a070=(a070+a064);
  a067=(a067*a049);
  a070=(a070+a067);
  a071=(a071*a031);
  a070=(a070+a071);
  a072=(a072*a047);
  a070=(a070+a072);
  a065=(a065*a019);
  a070=(a070+a065);
  a070=(a041+a070);
  a065=(a054*a070);
  a098=(a098+a065);
  a098=(a032+a098);
  a098=(a012*a098);
  a105=(a105+a098);
  a055=(a055-a105);
  a104=(a099*a104);
  a055=(a055-a104);
  a097=(a097*a101);
  a097=(a029-a097);
  a100=(a100*a099);
  a097=(a097-a100);
  a055=(a055/a097);
  a099=(a099*a055);
  a095=(a095-a099);
  a103=(a103*a095);
  a102=(a102-a103);
  a101=(a101*a055);
  a102=(a102+a101);
  a101=(a062*a102);
  a088=(a088+a101);
  a088=(a003+a088);
  a101=(a090*a088);
  a004=(a004+a101);
  a101=4.4710615727772587e-02;
  a101=(a101*a002);
  a103=2.2733101475165380e+00;
  a103=(a103*a002);
  a099=(a103*a018);
  a097=-1.0534495466737249e+01;
  a097=(a097*a002);
  a034=(a097*a034);
  a099=(a099+a034);
  a034=-2.0008720582248625e+00;
  a034=(a034*a002);
  a052=(a034*a052);
  a099=(a099+a052);
  a052=-1.7958931863118799e+01;
  a052=(a052*a002);
  a100=(a052*a060);
  a099=(a099+a100);
  a100=2.7948884529419960e+01;
  a100=(a100*a002);
  a104=(a100*a069);
  a099=(a099+a104);
  a104=-2.8589982771350235e+00;
  a104=(a104*a002);
  a105=(a104*a080);
  a099=(a099+a105);
  a105=-8.8728569335306293e+00;
  a105=(a105*a002);
  a098=(a105*a091);
  a099=(a099+a098);
  a098=1.2360567175794303e+01;
  a098=(a098*a002);
  a065=(a098*a102);
  a099=(a099+a065);
  a065=6.4339274601576357e-01;
  a065=(a065*a002);
  a072=(a092*a028);
  a071=(a086*a044);
  a072=(a072+a071);
  a071=(a089*a042);
  a072=(a072+a071);
  a071=(a093*a016);
  a072=(a072+a071);
  a071=(a094*a037);
  a072=(a072+a071);
  a071=(a087*a073);
  a072=(a072+a071);
  a071=(a063*a084);
  a072=(a072+a071);
  a071=(a062*a095);
  a072=(a072+a071);
  a072=(a008+a072);
  a071=(a007*a072);
  a067=(a092*a008);
  a064=(a086*a030);
  a067=(a067+a064);
  a064=(a089*a040);
  a067=(a067+a064);
  a064=(a093*a051);
  a067=(a067+a064);
  a064=(a094*a056);
  a067=(a067+a064);
  a064=(a087*a035);
  a067=(a067+a064);
  a064=(a063*a033);
  a067=(a067+a064);
  a064=(a062*a058);
  a067=(a067+a064);
  a067=(a010+a067);
  a064=sin(a067);
  a071=(a071*a064);
  a106=(2.*a088);
  a106=(a072-a106);
  a071=(a071*a106);
  a106=(a092*a003);
  a107=(a086*a045);
  a106=(a106+a107);
  a107=(a089*a046);
  a106=(a106+a107);
  a107=(a093*a017);
  a106=(a106+a107);
  a107=(a094*a038);
  a106=(a106+a107);
  a107=(a087*a057);
  a106=(a106+a107);
  a107=(a063*a066);
  a106=(a106+a107);
  a107=(a062*a077);
  a106=(a106+a107);
  a106=(a000+a106);
  a107=sin(a106);
  a108=(a106-a067);
  a108=sin(a108);
  a109=(a107-a108);
  a109=(a007*a109);
  a071=(a071+a109);
  a071=(a071+a107);
  a109=cos(a067);
  a110=(a015-a109);
  a110=(a014*a110);
  a110=(a110+a015);
  a111=(a071/a110);
  a109=(a109-a015);
  a109=(a007*a109);
  a112=(a109/a110);
  a113=casadi_sq(a088);
  a113=(a113*a064);
  a113=(a113+a108);
  a113=(a007*a113);
  a108=8.5714285714285710e-01;
  a108=(a108*a002);
  a108=(a023+a108);
  a108=(a021*a108);
  a064=sin(a108);
  a064=(a022*a064);
  a064=(a072+a064);
  a064=(a013*a064);
  a108=cos(a108);
  a108=(a108+a015);
  a108=(a011*a108);
  a108=(a027-a108);
  a108=(a108+a067);
  a108=(a026*a108);
  a064=(a064+a108);
  a113=(a113-a064);
  a108=(a112*a071);
  a113=(a113-a108);
  a108=(a109*a112);
  a108=(a007-a108);
  a067=(a113/a108);
  a106=cos(a106);
  a106=(a029*a106);
  a110=(a106/a110);
  a109=(a109*a110);
  a108=(a109/a108);
  a071=(a110*a071);
  a114=(a029*a088);
  a114=(a114*a088);
  a114=(a114*a107);
  a107=(a092*a041);
  a115=(a086*a024);
  a107=(a107+a115);
  a115=(a089*a050);
  a107=(a107+a115);
  a115=(a093*a006);
  a107=(a107+a115);
  a115=(a094*a053);
  a107=(a107+a115);
  a115=(a087*a061);
  a107=(a107+a115);
  a115=(a063*a070);
  a107=(a107+a115);
  a081=(a081*a009);
  a075=(a075*a039);
  a081=(a081+a075);
  a078=(a078*a049);
  a081=(a081+a078);
  a082=(a082*a031);
  a081=(a081+a082);
  a083=(a083*a047);
  a081=(a081+a083);
  a076=(a076*a019);
  a081=(a081+a076);
  a054=(a054*a043);
  a081=(a081+a054);
  a081=(a041+a081);
  a054=(a062*a081);
  a107=(a107+a054);
  a107=(a032+a107);
  a107=(a012*a107);
  a114=(a114+a107);
  a071=(a071-a114);
  a113=(a108*a113);
  a071=(a071-a113);
  a106=(a106*a110);
  a106=(a029-a106);
  a109=(a109*a108);
  a106=(a106-a109);
  a071=(a071/a106);
  a108=(a108*a071);
  a067=(a067-a108);
  a112=(a112*a067);
  a111=(a111-a112);
  a110=(a110*a071);
  a111=(a111+a110);
  a110=(a065*a111);
  a099=(a099+a110);
  a099=(a003+a099);
  a110=(a101*a099);
  a004=(a004+a110);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a110=(a005*a051);
  a004=(a004+a110);
  a110=(a036*a056);
  a004=(a004+a110);
  a110=(a059*a035);
  a004=(a004+a110);
  a110=(a068*a033);
  a004=(a004+a110);
  a110=(a079*a058);
  a004=(a004+a110);
  a110=(a090*a072);
  a004=(a004+a110);
  a110=(a103*a028);
  a044=(a097*a044);
  a110=(a110+a044);
  a042=(a034*a042);
  a110=(a110+a042);
  a042=(a052*a016);
  a110=(a110+a042);
  a042=(a100*a037);
  a110=(a110+a042);
  a042=(a104*a073);
  a110=(a110+a042);
  a042=(a105*a084);
  a110=(a110+a042);
  a042=(a098*a095);
  a110=(a110+a042);
  a042=(a065*a067);
  a110=(a110+a042);
  a110=(a008+a110);
  a042=(a101*a110);
  a004=(a004+a042);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a041);
  a042=(a005*a006);
  a004=(a004+a042);
  a042=(a036*a053);
  a004=(a004+a042);
  a042=(a059*a061);
  a004=(a004+a042);
  a042=(a068*a070);
  a004=(a004+a042);
  a042=(a079*a081);
  a004=(a004+a042);
  a092=(a092*a009);
  a086=(a086*a039);
  a092=(a092+a086);
  a089=(a089*a049);
  a092=(a092+a089);
  a093=(a093*a031);
  a092=(a092+a093);
  a094=(a094*a047);
  a092=(a092+a094);
  a087=(a087*a019);
  a092=(a092+a087);
  a063=(a063*a043);
  a092=(a092+a063);
  a062=(a062*a055);
  a092=(a092+a062);
  a092=(a041+a092);
  a062=(a090*a092);
  a004=(a004+a062);
  a062=(a103*a009);
  a039=(a097*a039);
  a062=(a062+a039);
  a049=(a034*a049);
  a062=(a062+a049);
  a049=(a052*a031);
  a062=(a062+a049);
  a049=(a100*a047);
  a062=(a062+a049);
  a049=(a104*a019);
  a062=(a062+a049);
  a049=(a105*a043);
  a062=(a062+a049);
  a049=(a098*a055);
  a062=(a062+a049);
  a049=(a065*a071);
  a062=(a062+a049);
  a062=(a041+a062);
  a062=(a101*a062);
  a004=(a004+a062);
  a004=(a032+a004);
  if (res[0]!=0) res[0][2]=a004;
  a018=(a001*a018);
  a060=(a005*a060);
  a018=(a018+a060);
  a069=(a036*a069);
  a018=(a018+a069);
  a080=(a059*a080);
  a018=(a018+a080);
  a091=(a068*a091);
  a018=(a018+a091);
  a102=(a079*a102);
  a018=(a018+a102);
  a111=(a090*a111);
  a018=(a018+a111);
  a111=(a007*a110);
  a102=(a103*a008);
  a030=(a097*a030);
  a102=(a102+a030);
  a040=(a034*a040);
  a102=(a102+a040);
  a040=(a052*a051);
  a102=(a102+a040);
  a040=(a100*a056);
  a102=(a102+a040);
  a040=(a104*a035);
  a102=(a102+a040);
  a040=(a105*a033);
  a102=(a102+a040);
  a040=(a098*a058);
  a102=(a102+a040);
  a040=(a065*a072);
  a102=(a102+a040);
  a010=(a010+a102);
  a102=sin(a010);
  a111=(a111*a102);
  a040=(2.*a099);
  a040=(a110-a040);
  a111=(a111*a040);
  a040=(a103*a003);
  a045=(a097*a045);
  a040=(a040+a045);
  a046=(a034*a046);
  a040=(a040+a046);
  a017=(a052*a017);
  a040=(a040+a017);
  a038=(a100*a038);
  a040=(a040+a038);
  a057=(a104*a057);
  a040=(a040+a057);
  a066=(a105*a066);
  a040=(a040+a066);
  a077=(a098*a077);
  a040=(a040+a077);
  a088=(a065*a088);
  a040=(a040+a088);
  a000=(a000+a040);
  a040=sin(a000);
  a088=(a000-a010);
  a088=sin(a088);
  a077=(a040-a088);
  a077=(a007*a077);
  a111=(a111+a077);
  a111=(a111+a040);
  a077=cos(a010);
  a066=(a015-a077);
  a014=(a014*a066);
  a014=(a014+a015);
  a066=(a111/a014);
  a077=(a077-a015);
  a077=(a007*a077);
  a057=(a077/a014);
  a038=casadi_sq(a099);
  a038=(a038*a102);
  a038=(a038+a088);
  a038=(a007*a038);
  a023=(a023+a002);
  a021=(a021*a023);
  a023=sin(a021);
  a022=(a022*a023);
  a022=(a110+a022);
  a013=(a013*a022);
  a021=cos(a021);
  a021=(a021+a015);
  a011=(a011*a021);
  a027=(a027-a011);
  a027=(a027+a010);
  a026=(a026*a027);
  a013=(a013+a026);
  a038=(a038-a013);
  a026=(a057*a111);
  a038=(a038-a026);
  a026=(a077*a057);
  a007=(a007-a026);
  a026=(a038/a007);
  a000=cos(a000);
  a000=(a029*a000);
  a014=(a000/a014);
  a077=(a077*a014);
  a007=(a077/a007);
  a111=(a014*a111);
  a027=(a029*a099);
  a027=(a027*a099);
  a027=(a027*a040);
  a103=(a103*a041);
  a097=(a097*a024);
  a103=(a103+a097);
  a034=(a034*a050);
  a103=(a103+a034);
  a052=(a052*a006);
  a103=(a103+a052);
  a100=(a100*a053);
  a103=(a103+a100);
  a104=(a104*a061);
  a103=(a103+a104);
  a105=(a105*a070);
  a103=(a103+a105);
  a098=(a098*a081);
  a103=(a103+a098);
  a065=(a065*a092);
  a103=(a103+a065);
  a032=(a032+a103);
  a012=(a012*a032);
  a027=(a027+a012);
  a111=(a111-a027);
  a038=(a007*a038);
  a111=(a111-a038);
  a000=(a000*a014);
  a029=(a029-a000);
  a077=(a077*a007);
  a029=(a029-a077);
  a111=(a111/a029);
  a007=(a007*a111);
  a026=(a026-a007);
  a057=(a057*a026);
  a066=(a066-a057);
  a014=(a014*a111);
  a066=(a066+a014);
  a066=(a101*a066);
  a018=(a018+a066);
  a003=(a003+a018);
  if (res[0]!=0) res[0][3]=a003;
  a028=(a001*a028);
  a016=(a005*a016);
  a028=(a028+a016);
  a037=(a036*a037);
  a028=(a028+a037);
  a073=(a059*a073);
  a028=(a028+a073);
  a084=(a068*a084);
  a028=(a028+a084);
  a095=(a079*a095);
  a028=(a028+a095);
  a067=(a090*a067);
  a028=(a028+a067);
  a026=(a101*a026);
  a028=(a028+a026);
  a028=(a008+a028);
  if (res[0]!=0) res[0][4]=a028;
  a009=(a001*a009);
  a031=(a005*a031);
  a009=(a009+a031);
  a047=(a036*a047);
  a009=(a009+a047);
  a019=(a059*a019);
  a009=(a009+a019);
  a043=(a068*a043);
  a009=(a009+a043);
  a055=(a079*a055);
  a009=(a009+a055);
  a071=(a090*a071);
  a009=(a009+a071);
  a111=(a101*a111);
  a009=(a009+a111);
  a041=(a041+a009);
  if (res[0]!=0) res[0][5]=a041;
  a041=arg[1]? arg[1][6] : 0;
  a025=(a025*a008);
  a001=(a001*a025);
  a020=(a020*a051);
  a005=(a005*a020);
  a001=(a001+a005);
  a048=(a048*a056);
  a036=(a036*a048);
  a001=(a001+a036);
  a074=(a074*a035);
  a059=(a059*a074);
  a001=(a001+a059);
  a085=(a085*a033);
  a068=(a068*a085);
  a001=(a001+a068);
  a096=(a096*a058);
  a079=(a079*a096);
  a001=(a001+a079);
  a064=(a064*a072);
  a090=(a090*a064);
  a001=(a001+a090);
  a013=(a013*a110);
  a101=(a101*a013);
  a001=(a001+a101);
  a041=(a041-a001);
  if (res[0]!=0) res[0][6]=a041;
  return 0;
}

/* observe:(t,y[6],p[8])->(g[8],dg[8]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78;
  a00=arg[2]? arg[2][5] : 0;
  a01=arg[1]? arg[1][4] : 0;
  a02=arg[2]? arg[2][7] : 0;
  a03=arg[2]? arg[2][2] : 0;
  a04=(a02*a03);
  a05=arg[0]? arg[0][0] : 0;
  a05=(a03*a05);
  a06=sin(a05);
  a07=(a04*a06);
  a07=(a01+a07);
  a07=(a00*a07);
  a08=arg[2]? arg[2][4] : 0;
  a09=arg[2]? arg[2][6] : 0;
  a05=cos(a05);
  a10=1.;
  a11=(a05+a10);
  a11=(a02*a11);
  a09=(a09-a11);
  a11=arg[1]? arg[1][1] : 0;
  a09=(a09+a11);
  a09=(a08*a09);
  a07=(a07+a09);
  a09=(a07*a01);
  a09=(-a09);
  if (res[0]!=0) res[0][0]=a09;
  a09=arg[2]? arg[2][1] : 0;
  a12=arg[1]? arg[1][2] : 0;
  a13=(a09*a12);
  a14=arg[2]? arg[2][3] : 0;
  a15=arg[1]? arg[1][0] : 0;
  a16=(a15-a11);
  a17=sin(a16);
  a18=sin(a15);
  a19=(a17-a18);
  a19=(a14*a19);
  a19=(a19-a18);
  a13=(a13+a19);
  a20=(2.*a14);
  a21=(a20+a10);
  a13=(a13/a21);
  a22=cos(a15);
  a16=cos(a16);
  a23=(a22-a16);
  a24=(a14*a23);
  a24=(a24+a22);
  a24=(a24/a21);
  a25=(a14*a01);
  a26=sin(a11);
  a27=(a25*a26);
  a28=arg[1]? arg[1][3] : 0;
  a29=(2.*a28);
  a30=(a01-a29);
  a31=(a27*a30);
  a19=(a31-a19);
  a32=cos(a11);
  a33=(a10-a32);
  a33=(a20*a33);
  a33=(a33+a10);
  a34=(a19/a33);
  a35=(a32-a10);
  a35=(a14*a35);
  a36=(a35/a33);
  a37=casadi_sq(a28);
  a38=(a37*a26);
  a38=(a38+a17);
  a38=(a14*a38);
  a38=(a38-a07);
  a39=(a36*a19);
  a39=(a38-a39);
  a40=(a35*a36);
  a40=(a14-a40);
  a41=(a39/a40);
  a42=(a09*a22);
  a43=(a42/a33);
  a44=(a35*a43);
  a45=(a44/a40);
  a46=(a43*a19);
  a47=(a09*a28);
  a48=(a47*a28);
  a49=(a48*a18);
  a50=arg[2]? arg[2][0] : 0;
  a51=(a50*a12);
  a49=(a49+a51);
  a46=(a46-a49);
  a51=(a45*a39);
  a46=(a46-a51);
  a51=(a42*a43);
  a51=(a09-a51);
  a52=(a44*a45);
  a51=(a51-a52);
  a46=(a46/a51);
  a52=(a45*a46);
  a52=(a41-a52);
  a53=(a36*a52);
  a53=(a34-a53);
  a54=(a43*a46);
  a53=(a53+a54);
  a54=(a16-a22);
  a54=(a14*a54);
  a54=(a54-a22);
  a55=(a53*a54);
  a56=(a52*a14);
  a57=(a56*a16);
  a55=(a55-a57);
  a57=(a46*a09);
  a55=(a55+a57);
  a57=(a25*a01);
  a58=(a57*a17);
  a55=(a55-a58);
  a59=(a14*a17);
  a60=(a29*a01);
  a61=(a59*a60);
  a55=(a55+a61);
  a62=(a14*a18);
  a62=(a62-a59);
  a62=(a62+a18);
  a63=(a37*a62);
  a55=(a55+a63);
  a64=(a24*a55);
  a65=(a53*a17);
  a66=(a52*a17);
  a65=(a65-a66);
  a66=(a16*a28);
  a67=(a66*a28);
  a65=(a65+a67);
  a68=(a16*a01);
  a69=(a68*a01);
  a65=(a65+a69);
  a70=(a16*a60);
  a65=(a65-a70);
  a71=(a53*a18);
  a72=(a22*a28);
  a73=(a72*a28);
  a71=(a71+a73);
  a65=(a65-a71);
  a74=2.;
  a65=(a65+a74);
  a65=(a14*a65);
  a65=(a65-a71);
  a65=(a65+a10);
  a64=(a64/a65);
  a13=(a13-a64);
  a13=(-a13);
  if (res[0]!=0) res[0][1]=a13;
  a13=(a18-a17);
  a13=(a14*a13);
  a31=(a31+a13);
  a31=(a31+a18);
  a13=(a31/a33);
  a71=(a36*a31);
  a38=(a38-a71);
  a71=(a38/a40);
  a75=(a43*a31);
  a75=(a75-a49);
  a49=(a45*a38);
  a75=(a75-a49);
  a75=(a75/a51);
  a49=(a45*a75);
  a49=(a71-a49);
  a76=(a36*a49);
  a76=(a13-a76);
  a77=(a43*a75);
  a76=(a76+a77);
  a77=(a76*a17);
  a78=(a49*a17);
  a77=(a77-a78);
  a77=(a77+a67);
  a77=(a77+a69);
  a77=(a77-a70);
  a70=(a76*a18);
  a70=(a70+a73);
  a77=(a77-a70);
  a77=(a77+a74);
  a77=(a14*a77);
  a77=(a77-a70);
  a77=(a77+a10);
  if (res[0]!=0) res[0][2]=a77;
  a10=(a76*a54);
  a70=(a49*a14);
  a74=(a70*a16);
  a10=(a10-a74);
  a74=(a75*a09);
  a10=(a10+a74);
  a10=(a10-a58);
  a10=(a10+a61);
  a10=(a10+a63);
  a10=(a10/a77);
  if (res[0]!=0) res[0][3]=a10;
  if (res[0]!=0) res[0][4]=a23;
  if (res[0]!=0) res[0][5]=a76;
  a15=(2.*a15);
  a11=(a11-a15);
  if (res[0]!=0) res[0][6]=a11;
  if (res[0]!=0) res[0][7]=a12;
  a05=(a05*a03);
  a04=(a04*a05);
  a04=(a49+a04);
  a00=(a00*a04);
  a06=(a06*a03);
  a02=(a02*a06);
  a02=(a02+a01);
  a08=(a08*a02);
  a00=(a00+a08);
  a08=(a01*a00);
  a07=(a07*a49);
  a08=(a08+a07);
  a08=(-a08);
  if (res[1]!=0) res[1][0]=a08;
  a08=arg[1]? arg[1][5] : 0;
  a07=(a09*a08);
  a02=(a28-a01);
  a06=(a16*a02);
  a03=(a06-a72);
  a03=(a14*a03);
  a03=(a03-a72);
  a07=(a07+a03);
  a07=(a07/a21);
  a02=(a17*a02);
  a04=(a18*a28);
  a05=(a02-a04);
  a12=(a14*a05);
  a12=(a12-a04);
  a12=(a12/a21);
  a55=(a55*a12);
  a12=(a14*a49);
  a21=(a26*a12);
  a32=(a32*a01);
  a11=(a25*a32);
  a21=(a21+a11);
  a21=(a30*a21);
  a11=(2.*a76);
  a15=(a49-a11);
  a27=(a27*a15);
  a21=(a21+a27);
  a03=(a21-a03);
  a27=(a03/a33);
  a34=(a34/a33);
  a15=(a26*a01);
  a20=(a20*a15);
  a34=(a34*a20);
  a27=(a27-a34);
  a34=(a29*a76);
  a26=(a26*a34);
  a32=(a37*a32);
  a26=(a26+a32);
  a26=(a26+a06);
  a26=(a14*a26);
  a26=(a26-a00);
  a00=(a36*a03);
  a15=(a14*a15);
  a32=(a15/a33);
  a23=(a36/a33);
  a23=(a23*a20);
  a32=(a32+a23);
  a23=(a19*a32);
  a00=(a00-a23);
  a00=(a26-a00);
  a23=(a00/a40);
  a41=(a41/a40);
  a63=(a36*a15);
  a61=(a35*a32);
  a63=(a63+a61);
  a41=(a41*a63);
  a23=(a23-a41);
  a03=(a43*a03);
  a41=(a09*a04);
  a61=(a41/a33);
  a58=(a43/a33);
  a58=(a58*a20);
  a61=(a61+a58);
  a19=(a19*a61);
  a03=(a03-a19);
  a19=(a09*a76);
  a19=(a28*a19);
  a47=(a47*a76);
  a19=(a19+a47);
  a19=(a18*a19);
  a48=(a48*a72);
  a19=(a19+a48);
  a50=(a50*a08);
  a19=(a19+a50);
  a03=(a03-a19);
  a00=(a45*a00);
  a15=(a43*a15);
  a35=(a35*a61);
  a15=(a15+a35);
  a35=(a15/a40);
  a50=(a45/a40);
  a50=(a50*a63);
  a35=(a35+a50);
  a39=(a39*a35);
  a00=(a00-a39);
  a03=(a03-a00);
  a03=(a03/a51);
  a00=(a46/a51);
  a41=(a43*a41);
  a42=(a42*a61);
  a41=(a41+a42);
  a15=(a45*a15);
  a44=(a44*a35);
  a15=(a15+a44);
  a41=(a41+a15);
  a00=(a00*a41);
  a03=(a03-a00);
  a00=(a45*a03);
  a15=(a46*a35);
  a00=(a00-a15);
  a23=(a23-a00);
  a00=(a36*a23);
  a15=(a52*a32);
  a00=(a00-a15);
  a27=(a27-a00);
  a00=(a43*a03);
  a46=(a46*a61);
  a00=(a00-a46);
  a27=(a27+a00);
  a00=(a54*a27);
  a46=(a04-a02);
  a46=(a14*a46);
  a46=(a46+a04);
  a15=(a53*a46);
  a00=(a00+a15);
  a15=(a14*a23);
  a15=(a16*a15);
  a56=(a56*a02);
  a15=(a15-a56);
  a00=(a00-a15);
  a03=(a09*a03);
  a00=(a00+a03);
  a12=(a01*a12);
  a25=(a25*a49);
  a12=(a12+a25);
  a12=(a17*a12);
  a57=(a57*a06);
  a12=(a12+a57);
  a00=(a00-a12);
  a57=(a14*a06);
  a25=(a60*a57);
  a11=(a01*a11);
  a29=(a29*a49);
  a11=(a11+a29);
  a59=(a59*a11);
  a25=(a25+a59);
  a00=(a00+a25);
  a62=(a62*a34);
  a34=(a14*a72);
  a34=(a34-a57);
  a34=(a34+a72);
  a37=(a37*a34);
  a62=(a62+a37);
  a00=(a00+a62);
  a24=(a24*a00);
  a55=(a55+a24);
  a55=(a55/a65);
  a64=(a64/a65);
  a65=(a17*a27);
  a24=(a53*a06);
  a65=(a65+a24);
  a23=(a17*a23);
  a52=(a52*a06);
  a23=(a23+a52);
  a65=(a65-a23);
  a23=(a16*a76);
  a52=(a28*a02);
  a23=(a23-a52);
  a23=(a28*a23);
  a66=(a66*a76);
  a23=(a23+a66);
  a65=(a65+a23);
  a66=(a16*a49);
  a52=(a01*a02);
  a66=(a66-a52);
  a01=(a01*a66);
  a68=(a68*a49);
  a01=(a01+a68);
  a65=(a65+a01);
  a11=(a16*a11);
  a60=(a60*a02);
  a11=(a11-a60);
  a65=(a65-a11);
  a27=(a18*a27);
  a53=(a53*a72);
  a27=(a27+a53);
  a22=(a22*a76);
  a04=(a28*a04);
  a22=(a22-a04);
  a28=(a28*a22);
  a22=(a72*a76);
  a28=(a28+a22);
  a27=(a27+a28);
  a65=(a65-a27);
  a65=(a14*a65);
  a65=(a65-a27);
  a64=(a64*a65);
  a55=(a55-a64);
  a07=(a07-a55);
  a07=(-a07);
  if (res[1]!=0) res[1][1]=a07;
  a07=(a72-a06);
  a07=(a14*a07);
  a21=(a21+a07);
  a21=(a21+a72);
  a07=(a21/a33);
  a13=(a13/a33);
  a13=(a13*a20);
  a07=(a07-a13);
  a13=(a36*a21);
  a20=(a31*a32);
  a13=(a13-a20);
  a26=(a26-a13);
  a13=(a26/a40);
  a71=(a71/a40);
  a71=(a71*a63);
  a13=(a13-a71);
  a21=(a43*a21);
  a31=(a31*a61);
  a21=(a21-a31);
  a21=(a21-a19);
  a26=(a45*a26);
  a38=(a38*a35);
  a26=(a26-a38);
  a21=(a21-a26);
  a21=(a21/a51);
  a51=(a75/a51);
  a51=(a51*a41);
  a21=(a21-a51);
  a45=(a45*a21);
  a35=(a75*a35);
  a45=(a45-a35);
  a13=(a13-a45);
  a36=(a36*a13);
  a32=(a49*a32);
  a36=(a36-a32);
  a07=(a07-a36);
  a43=(a43*a21);
  a75=(a75*a61);
  a43=(a43-a75);
  a07=(a07+a43);
  a43=(a17*a07);
  a75=(a76*a06);
  a43=(a43+a75);
  a17=(a17*a13);
  a49=(a49*a06);
  a17=(a17+a49);
  a43=(a43-a17);
  a43=(a43+a23);
  a43=(a43+a01);
  a43=(a43-a11);
  a18=(a18*a07);
  a72=(a76*a72);
  a18=(a18+a72);
  a18=(a18+a28);
  a43=(a43-a18);
  a43=(a14*a43);
  a43=(a43-a18);
  if (res[1]!=0) res[1][2]=a43;
  a54=(a54*a07);
  a76=(a76*a46);
  a54=(a54+a76);
  a14=(a14*a13);
  a16=(a16*a14);
  a70=(a70*a02);
  a16=(a16-a70);
  a54=(a54-a16);
  a09=(a09*a21);
  a54=(a54+a09);
  a54=(a54-a12);
  a54=(a54+a25);
  a54=(a54+a62);
  a54=(a54/a77);
  a10=(a10/a77);
  a10=(a10*a43);
  a54=(a54-a10);
  if (res[1]!=0) res[1][3]=a54;
  if (res[1]!=0) res[1][4]=a05;
  if (res[1]!=0) res[1][5]=a07;
  if (res[1]!=0) res[1][6]=a30;
  if (res[1]!=0) res[1][7]=a08;
  return 0;
}

/* working_steps:(t,w[7],h,p[8])->(w_end[7],nodes[7x12],g[8x12],dg[8x12]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, w01, w02, w03, w04, w05, w06, w07, w08, w09;
  casadi_real w10, w11, w12, *w13=w+116, *w15=w+123, *w16=w+130, *w17=w+137, *w18=w+144, *w19=w+151, *w20=w+158, *w21=w+165, *w22=w+172;
  casadi_real *w23=w+179, *w24=w+186, *w25=w+193, *w26=w+200, *w27=w+207, *w28=w+213, *w29=w+221, *w30=w+229, *w31=w+237, *w32=w+245, *w33=w+253, *w34=w+261;
  casadi_real *w35=w+269, *w36=w+277, *w37=w+285, *w38=w+293, *w39=w+301, *w40=w+309;
  const casadi_real **arg1=arg+4, *cs, *wr14;
  /* #0: @0 = input[0][0] */
  w00 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = 11 */
  w01 = 11.;
  /* #2: @2 = input[2][0] */
  w02 = arg[2] ? arg[2][0] : 0;
  /* #3: @1 = (@1*@2) */
  w01 *= w02;
  /* #4: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #5: @3 = 10 */
  w03 = 10.;
  /* #6: @3 = (@3*@2) */
  w03 *= w02;
  /* #7: @3 = (@0+@3) */
  w03  = (w00+w03);
  /* #8: @4 = 9 */
  w04 = 9.;
  /* #9: @4 = (@4*@2) */
  w04 *= w02;
  /* #10: @4 = (@0+@4) */
  w04  = (w00+w04);
  /* #11: @5 = 8 */
  w05 = 8.;
  /* #12: @5 = (@5*@2) */
  w05 *= w02;
  /* #13: @5 = (@0+@5) */
  w05  = (w00+w05);
  /* #14: @6 = 7 */
  w06 = 7.;
  /* #15: @6 = (@6*@2) */
  w06 *= w02;
  /* #16: @6 = (@0+@6) */
  w06  = (w00+w06);
  /* #17: @7 = 6 */
  w07 = 6.;
  /* #18: @7 = (@7*@2) */
  w07 *= w02;
  /* #19: @7 = (@0+@7) */
  w07  = (w00+w07);
  /* #20: @8 = 5 */
  w08 = 5.;
  /* #21: @8 = (@8*@2) */
  w08 *= w02;
  /* #22: @8 = (@0+@8) */
  w08  = (w00+w08);
  /* #23: @9 = 4 */
  w09 = 4.;
  /* #24: @9 = (@9*@2) */
  w09 *= w02;
  /* #25: @9 = (@0+@9) */
  w09  = (w00+w09);
  /* #26: @10 = 3 */
  w10 = 3.;
  /* #27: @10 = (@10*@2) */
  w10 *= w02;
  /* #28: @10 = (@0+@10) */
  w10  = (w00+w10);
  /* #29: @11 = (2.*@2) */
  w11 = (2.* w02 );
  /* #30: @11 = (@0+@11) */
  w11  = (w00+w11);
  /* #31: @12 = (@0+@2) */
  w12  = (w00+w02);
  /* #32: @13 = input[1][0] */
  casadi_copy(arg[1], 7, w13);
  /* #33: @14 = input[3][0] */
  wr14 = arg[3] ? arg[3] : casadi_zeros;
  /* #34: @15 = working_step(@0, @13, @2, @14) */
  arg1[0]=(&w00);
  arg1[1]=w13;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w15;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #35: @16 = working_step(@12, @15, @2, @14) */
  arg1[0]=(&w12);
  arg1[1]=w15;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w16;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #36: @17 = working_step(@11, @16, @2, @14) */
  arg1[0]=(&w11);
  arg1[1]=w16;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w17;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #37: @18 = working_step(@10, @17, @2, @14) */
  arg1[0]=(&w10);
  arg1[1]=w17;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w18;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #38: @19 = working_step(@9, @18, @2, @14) */
  arg1[0]=(&w09);
  arg1[1]=w18;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w19;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #39: @20 = working_step(@8, @19, @2, @14) */
  arg1[0]=(&w08);
  arg1[1]=w19;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w20;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #40: @21 = working_step(@7, @20, @2, @14) */
  arg1[0]=(&w07);
  arg1[1]=w20;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w21;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #41: @22 = working_step(@6, @21, @2, @14) */
  arg1[0]=(&w06);
  arg1[1]=w21;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w22;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #42: @23 = working_step(@5, @22, @2, @14) */
  arg1[0]=(&w05);
  arg1[1]=w22;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w23;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #43: @24 = working_step(@4, @23, @2, @14) */
  arg1[0]=(&w04);
  arg1[1]=w23;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w24;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #44: @25 = working_step(@3, @24, @2, @14) */
  arg1[0]=(&w03);
  arg1[1]=w24;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w25;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #45: @26 = working_step(@1, @25, @2, @14) */
  arg1[0]=(&w01);
  arg1[1]=w25;
  arg1[2]=(&w02);
  arg1[3]=wr14;
  res1[0]=w26;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @26 */
  casadi_copy(w26, 7, res[0]);
  /* #47: output[1][0] = @13 */
  casadi_copy(w13, 7, res[1]);
  /* #48: output[1][1] = @15 */
  if (res[1]) casadi_copy(w15, 7, res[1]+7);
  /* #49: output[1][2] = @16 */
  if (res[1]) casadi_copy(w16, 7, res[1]+14);
  /* #50: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 7, res[1]+21);
  /* #51: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 7, res[1]+28);
  /* #52: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 7, res[1]+35);
  /* #53: output[1][6] = @20 */
  if (res[1]) casadi_copy(w20, 7, res[1]+42);
  /* #54: output[1][7] = @21 */
  if (res[1]) casadi_copy(w21, 7, res[1]+49);
  /* #55: output[1][8] = @22 */
  if (res[1]) casadi_copy(w22, 7, res[1]+56);
  /* #56: output[1][9] = @23 */
  if (res[1]) casadi_copy(w23, 7, res[1]+63);
  /* #57: output[1][10] = @24 */
  if (res[1]) casadi_copy(w24, 7, res[1]+70);
  /* #58: output[1][11] = @25 */
  if (res[1]) casadi_copy(w25, 7, res[1]+77);
  /* #59: @27 = @13[:6] */
  for (rr=w27, cs=w13+0; cs!=w13+6; cs+=1) *rr++ = *cs;
  /* #60: {@28, @29} = observe(@0, @27, @14) */
  arg1[0]=(&w00);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w29;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #61: output[2][0] = @28 */
  casadi_copy(w28, 8, res[2]);
  /* #62: @1 = (@0+@2) */
  w01  = (w00+w02);
  /* #63: @27 = @15[:6] */
  for (rr=w27, cs=w15+0; cs!=w15+6; cs+=1) *rr++ = *cs;
  /* #64: {@28, @30} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w30;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[2][1] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+8);
  /* #66: @1 = (2.*@2) */
  w01 = (2.* w02 );
  /* #67: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #68: @27 = @16[:6] */
  for (rr=w27, cs=w16+0; cs!=w16+6; cs+=1) *rr++ = *cs;
  /* #69: {@28, @31} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w31;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #70: output[2][2] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+16);
  /* #71: @1 = 3 */
  w01 = 3.;
  /* #72: @1 = (@1*@2) */
  w01 *= w02;
  /* #73: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #74: @27 = @17[:6] */
  for (rr=w27, cs=w17+0; cs!=w17+6; cs+=1) *rr++ = *cs;
  /* #75: {@28, @32} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w32;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #76: output[2][3] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+24);
  /* #77: @1 = 4 */
  w01 = 4.;
  /* #78: @1 = (@1*@2) */
  w01 *= w02;
  /* #79: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #80: @27 = @18[:6] */
  for (rr=w27, cs=w18+0; cs!=w18+6; cs+=1) *rr++ = *cs;
  /* #81: {@28, @33} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w33;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #82: output[2][4] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+32);
  /* #83: @1 = 5 */
  w01 = 5.;
  /* #84: @1 = (@1*@2) */
  w01 *= w02;
  /* #85: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #86: @27 = @19[:6] */
  for (rr=w27, cs=w19+0; cs!=w19+6; cs+=1) *rr++ = *cs;
  /* #87: {@28, @34} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w34;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #88: output[2][5] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+40);
  /* #89: @1 = 6 */
  w01 = 6.;
  /* #90: @1 = (@1*@2) */
  w01 *= w02;
  /* #91: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #92: @27 = @20[:6] */
  for (rr=w27, cs=w20+0; cs!=w20+6; cs+=1) *rr++ = *cs;
  /* #93: {@28, @35} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w35;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #94: output[2][6] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+48);
  /* #95: @1 = 7 */
  w01 = 7.;
  /* #96: @1 = (@1*@2) */
  w01 *= w02;
  /* #97: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #98: @27 = @21[:6] */
  for (rr=w27, cs=w21+0; cs!=w21+6; cs+=1) *rr++ = *cs;
  /* #99: {@28, @36} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w36;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #100: output[2][7] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+56);
  /* #101: @1 = 8 */
  w01 = 8.;
  /* #102: @1 = (@1*@2) */
  w01 *= w02;
  /* #103: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #104: @27 = @22[:6] */
  for (rr=w27, cs=w22+0; cs!=w22+6; cs+=1) *rr++ = *cs;
  /* #105: {@28, @37} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w37;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #106: output[2][8] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+64);
  /* #107: @1 = 9 */
  w01 = 9.;
  /* #108: @1 = (@1*@2) */
  w01 *= w02;
  /* #109: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #110: @27 = @23[:6] */
  for (rr=w27, cs=w23+0; cs!=w23+6; cs+=1) *rr++ = *cs;
  /* #111: {@28, @38} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w38;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #112: output[2][9] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+72);
  /* #113: @1 = 10 */
  w01 = 10.;
  /* #114: @1 = (@1*@2) */
  w01 *= w02;
  /* #115: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #116: @27 = @24[:6] */
  for (rr=w27, cs=w24+0; cs!=w24+6; cs+=1) *rr++ = *cs;
  /* #117: {@28, @39} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w39;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #118: output[2][10] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+80);
  /* #119: @1 = 11 */
  w01 = 11.;
  /* #120: @1 = (@1*@2) */
  w01 *= w02;
  /* #121: @0 = (@0+@1) */
  w00 += w01;
  /* #122: @27 = @25[:6] */
  for (rr=w27, cs=w25+0; cs!=w25+6; cs+=1) *rr++ = *cs;
  /* #123: {@28, @40} = observe(@0, @27, @14) */
  arg1[0]=(&w00);
  arg1[1]=w27;
  arg1[2]=wr14;
  res1[0]=w28;
  res1[1]=w40;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #124: output[2][11] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+88);
  /* #125: output[3][0] = @29 */
  casadi_copy(w29, 8, res[3]);
  /* #126: output[3][1] = @30 */
  if (res[3]) casadi_copy(w30, 8, res[3]+8);
  /* #127: output[3][2] = @31 */
  if (res[3]) casadi_copy(w31, 8, res[3]+16);
  /* #128: output[3][3] = @32 */
  if (res[3]) casadi_copy(w32, 8, res[3]+24);
  /* #129: output[3][4] = @33 */
  if (res[3]) casadi_copy(w33, 8, res[3]+32);
  /* #130: output[3][5] = @34 */
  if (res[3]) casadi_copy(w34, 8, res[3]+40);
  /* #131: output[3][6] = @35 */
  if (res[3]) casadi_copy(w35, 8, res[3]+48);
  /* #132: output[3][7] = @36 */
  if (res[3]) casadi_copy(w36, 8, res[3]+56);
  /* #133: output[3][8] = @37 */
  if (res[3]) casadi_copy(w37, 8, res[3]+64);
  /* #134: output[3][9] = @38 */
  if (res[3]) casadi_copy(w38, 8, res[3]+72);
  /* #135: output[3][10] = @39 */
  if (res[3]) casadi_copy(w39, 8, res[3]+80);
  /* #136: output[3][11] = @40 */
  if (res[3]) casadi_copy(w40, 8, res[3]+88);
  return 0;
}

/* wobbling_trace_48:(u[6],p[8])->(w[7x49],g[8x49],dg[8x49],R[6]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+338, *w02=w+344, *w03=w+349, w04, *w05=w+355, w06, *w08=w+362, *w09=w+369, *w10=w+453;
  casadi_real *w11=w+549, *w12=w+645, *w13=w+741, *w14=w+837, *w15=w+933, *w16=w+1029, *w17=w+1125, *w18=w+1221, *w19=w+1229;
  const casadi_real **arg1=arg+2, *cs, *wr07;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[:5] */
  for (rr=w02, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[5] */
  for (rr=(&w04), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #7: @6 = 48 */
  w06 = 48.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  wr07 = arg[1] ? arg[1] : casadi_zeros;
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 84, res[0]);
  /* #12: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #13: @0 = (@0*@4) */
  w00 *= w04;
  /* #14: @6 = 48 */
  w06 = 48.;
  /* #15: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #16: {@5, @9, @12, @13} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+84);
  /* #18: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #19: @0 = (@0*@4) */
  w00 *= w04;
  /* #20: @6 = 48 */
  w06 = 48.;
  /* #21: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #22: {@8, @9, @14, @15} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+168);
  /* #24: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #25: @0 = (@0*@4) */
  w00 *= w04;
  /* #26: @6 = 48 */
  w06 = 48.;
  /* #27: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #28: {@5, @9, @16, @17} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+252);
  /* #30: output[0][4] = @5 */
  if (res[0]) casadi_copy(w05, 7, res[0]+336);
  /* #31: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #32: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #33: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #34: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #35: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #36: {@18, @19} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=wr07;
  res1[0]=w18;
  res1[1]=w19;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #37: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 8, res[1]+384);
  /* #38: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #39: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #40: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #41: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #42: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 8, res[2]+384);
  /* #43: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #44: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=wr07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[3][0] = @3 */
  casadi_copy(w03, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1237;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1237*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_96:(u[6],p[8])->(w[7x97],g[8x97],dg[8x97],R[6]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+338, *w02=w+344, *w03=w+349, w04, *w05=w+355, w06, *w08=w+362, *w09=w+369, *w10=w+453;
  casadi_real *w11=w+549, *w12=w+645, *w13=w+741, *w14=w+837, *w15=w+933, *w16=w+1029, *w17=w+1125, *w18=w+1221, *w19=w+1317, *w20=w+1413, *w21=w+1509, *w22=w+1605;
  casadi_real *w23=w+1701, *w24=w+1797, *w25=w+1893, *w26=w+1989, *w27=w+1997;
  const casadi_real **arg1=arg+2, *cs, *wr07;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[:5] */
  for (rr=w02, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[5] */
  for (rr=(&w04), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #7: @6 = 96 */
  w06 = 96.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  wr07 = arg[1] ? arg[1] : casadi_zeros;
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 84, res[0]);
  /* #12: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #13: @0 = (@0*@4) */
  w00 *= w04;
  /* #14: @6 = 96 */
  w06 = 96.;
  /* #15: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #16: {@5, @9, @12, @13} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+84);
  /* #18: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #19: @0 = (@0*@4) */
  w00 *= w04;
  /* #20: @6 = 96 */
  w06 = 96.;
  /* #21: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #22: {@8, @9, @14, @15} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+168);
  /* #24: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #25: @0 = (@0*@4) */
  w00 *= w04;
  /* #26: @6 = 96 */
  w06 = 96.;
  /* #27: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #28: {@5, @9, @16, @17} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+252);
  /* #30: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #31: @0 = (@0*@4) */
  w00 *= w04;
  /* #32: @6 = 96 */
  w06 = 96.;
  /* #33: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #34: {@8, @9, @18, @19} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+336);
  /* #36: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #37: @0 = (@0*@4) */
  w00 *= w04;
  /* #38: @6 = 96 */
  w06 = 96.;
  /* #39: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #40: {@5, @9, @20, @21} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+420);
  /* #42: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #43: @0 = (@0*@4) */
  w00 *= w04;
  /* #44: @6 = 96 */
  w06 = 96.;
  /* #45: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #46: {@8, @9, @22, @23} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+504);
  /* #48: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #49: @0 = (@0*@4) */
  w00 *= w04;
  /* #50: @6 = 96 */
  w06 = 96.;
  /* #51: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #52: {@5, @9, @24, @25} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+588);
  /* #54: output[0][8] = @5 */
  if (res[0]) casadi_copy(w05, 7, res[0]+672);
  /* #55: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #56: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #57: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #58: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #59: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #60: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #61: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #62: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #63: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #64: {@26, @27} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=wr07;
  res1[0]=w26;
  res1[1]=w27;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 8, res[1]+768);
  /* #66: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #67: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #68: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #69: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #70: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #71: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #72: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #73: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #74: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 8, res[2]+768);
  /* #75: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #76: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=wr07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[3][0] = @3 */
  casadi_copy(w03, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f43(arg, res, iw, w, mem);
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
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2005;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2005*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_192:(u[6],p[8])->(w[7x193],g[8x193],dg[8x193],R[6]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+338, *w02=w+344, *w03=w+349, w04, *w05=w+355, w06, *w08=w+362, *w09=w+369, *w10=w+453;
  casadi_real *w11=w+549, *w12=w+645, *w13=w+741, *w14=w+837, *w15=w+933, *w16=w+1029, *w17=w+1125, *w18=w+1221, *w19=w+1317, *w20=w+1413, *w21=w+1509, *w22=w+1605;
  casadi_real *w23=w+1701, *w24=w+1797, *w25=w+1893, *w26=w+1989, *w27=w+2085, *w28=w+2181, *w29=w+2277, *w30=w+2373, *w31=w+2469, *w32=w+2565, *w33=w+2661, *w34=w+2757;
  casadi_real *w35=w+2853, *w36=w+2949, *w37=w+3045, *w38=w+3141, *w39=w+3237, *w40=w+3333, *w41=w+3429, *w42=w+3525, *w43=w+3533;
  const casadi_real **arg1=arg+2, *cs, *wr07;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[:5] */
  for (rr=w02, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[5] */
  for (rr=(&w04), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #7: @6 = 192 */
  w06 = 192.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  wr07 = arg[1] ? arg[1] : casadi_zeros;
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 84, res[0]);
  /* #12: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #13: @0 = (@0*@4) */
  w00 *= w04;
  /* #14: @6 = 192 */
  w06 = 192.;
  /* #15: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #16: {@5, @9, @12, @13} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+84);
  /* #18: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #19: @0 = (@0*@4) */
  w00 *= w04;
  /* #20: @6 = 192 */
  w06 = 192.;
  /* #21: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #22: {@8, @9, @14, @15} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+168);
  /* #24: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #25: @0 = (@0*@4) */
  w00 *= w04;
  /* #26: @6 = 192 */
  w06 = 192.;
  /* #27: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #28: {@5, @9, @16, @17} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+252);
  /* #30: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #31: @0 = (@0*@4) */
  w00 *= w04;
  /* #32: @6 = 192 */
  w06 = 192.;
  /* #33: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #34: {@8, @9, @18, @19} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+336);
  /* #36: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #37: @0 = (@0*@4) */
  w00 *= w04;
  /* #38: @6 = 192 */
  w06 = 192.;
  /* #39: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #40: {@5, @9, @20, @21} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+420);
  /* #42: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #43: @0 = (@0*@4) */
  w00 *= w04;
  /* #44: @6 = 192 */
  w06 = 192.;
  /* #45: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #46: {@8, @9, @22, @23} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+504);
  /* #48: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #49: @0 = (@0*@4) */
  w00 *= w04;
  /* #50: @6 = 192 */
  w06 = 192.;
  /* #51: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #52: {@5, @9, @24, @25} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+588);
  /* #54: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #55: @0 = (@0*@4) */
  w00 *= w04;
  /* #56: @6 = 192 */
  w06 = 192.;
  /* #57: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #58: {@8, @9, @26, @27} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+672);
  /* #60: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #61: @0 = (@0*@4) */
  w00 *= w04;
  /* #62: @6 = 192 */
  w06 = 192.;
  /* #63: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #64: {@5, @9, @28, @29} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+756);
  /* #66: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #67: @0 = (@0*@4) */
  w00 *= w04;
  /* #68: @6 = 192 */
  w06 = 192.;
  /* #69: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #70: {@8, @9, @30, @31} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #71: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+840);
  /* #72: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #73: @0 = (@0*@4) */
  w00 *= w04;
  /* #74: @6 = 192 */
  w06 = 192.;
  /* #75: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #76: {@5, @9, @32, @33} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+924);
  /* #78: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #79: @0 = (@0*@4) */
  w00 *= w04;
  /* #80: @6 = 192 */
  w06 = 192.;
  /* #81: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #82: {@8, @9, @34, @35} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1008);
  /* #84: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #85: @0 = (@0*@4) */
  w00 *= w04;
  /* #86: @6 = 192 */
  w06 = 192.;
  /* #87: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #88: {@5, @9, @36, @37} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1092);
  /* #90: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #91: @0 = (@0*@4) */
  w00 *= w04;
  /* #92: @6 = 192 */
  w06 = 192.;
  /* #93: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #94: {@8, @9, @38, @39} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1176);
  /* #96: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #97: @0 = (@0*@4) */
  w00 *= w04;
  /* #98: @6 = 192 */
  w06 = 192.;
  /* #99: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #100: {@5, @9, @40, @41} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1260);
  /* #102: output[0][16] = @5 */
  if (res[0]) casadi_copy(w05, 7, res[0]+1344);
  /* #103: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #104: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #105: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #106: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #107: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #108: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #109: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #110: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #111: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 96, res[1]+768);
  /* #112: output[1][9] = @28 */
  if (res[1]) casadi_copy(w28, 96, res[1]+864);
  /* #113: output[1][10] = @30 */
  if (res[1]) casadi_copy(w30, 96, res[1]+960);
  /* #114: output[1][11] = @32 */
  if (res[1]) casadi_copy(w32, 96, res[1]+1056);
  /* #115: output[1][12] = @34 */
  if (res[1]) casadi_copy(w34, 96, res[1]+1152);
  /* #116: output[1][13] = @36 */
  if (res[1]) casadi_copy(w36, 96, res[1]+1248);
  /* #117: output[1][14] = @38 */
  if (res[1]) casadi_copy(w38, 96, res[1]+1344);
  /* #118: output[1][15] = @40 */
  if (res[1]) casadi_copy(w40, 96, res[1]+1440);
  /* #119: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #120: {@42, @43} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=wr07;
  res1[0]=w42;
  res1[1]=w43;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #121: output[1][16] = @42 */
  if (res[1]) casadi_copy(w42, 8, res[1]+1536);
  /* #122: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #123: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #124: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #125: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #126: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #127: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #128: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #129: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #130: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 96, res[2]+768);
  /* #131: output[2][9] = @29 */
  if (res[2]) casadi_copy(w29, 96, res[2]+864);
  /* #132: output[2][10] = @31 */
  if (res[2]) casadi_copy(w31, 96, res[2]+960);
  /* #133: output[2][11] = @33 */
  if (res[2]) casadi_copy(w33, 96, res[2]+1056);
  /* #134: output[2][12] = @35 */
  if (res[2]) casadi_copy(w35, 96, res[2]+1152);
  /* #135: output[2][13] = @37 */
  if (res[2]) casadi_copy(w37, 96, res[2]+1248);
  /* #136: output[2][14] = @39 */
  if (res[2]) casadi_copy(w39, 96, res[2]+1344);
  /* #137: output[2][15] = @41 */
  if (res[2]) casadi_copy(w41, 96, res[2]+1440);
  /* #138: output[2][16] = @43 */
  if (res[2]) casadi_copy(w43, 8, res[2]+1536);
  /* #139: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #140: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=wr07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #141: output[3][0] = @3 */
  casadi_copy(w03, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
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
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3541;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3541*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_384:(u[6],p[8])->(w[7x385],g[8x385],dg[8x385],R[6]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+338, *w02=w+344, *w03=w+349, w04, *w05=w+355, w06, *w08=w+362, *w09=w+369, *w10=w+453;
  casadi_real *w11=w+549, *w12=w+645, *w13=w+741, *w14=w+837, *w15=w+933, *w16=w+1029, *w17=w+1125, *w18=w+1221, *w19=w+1317, *w20=w+1413, *w21=w+1509, *w22=w+1605;
  casadi_real *w23=w+1701, *w24=w+1797, *w25=w+1893, *w26=w+1989, *w27=w+2085, *w28=w+2181, *w29=w+2277, *w30=w+2373, *w31=w+2469, *w32=w+2565, *w33=w+2661, *w34=w+2757;
  casadi_real *w35=w+2853, *w36=w+2949, *w37=w+3045, *w38=w+3141, *w39=w+3237, *w40=w+3333, *w41=w+3429, *w42=w+3525, *w43=w+3621, *w44=w+3717, *w45=w+3813, *w46=w+3909;
  casadi_real *w47=w+4005, *w48=w+4101, *w49=w+4197, *w50=w+4293, *w51=w+4389, *w52=w+4485, *w53=w+4581, *w54=w+4677, *w55=w+4773, *w56=w+4869, *w57=w+4965, *w58=w+5061;
  casadi_real *w59=w+5157, *w60=w+5253, *w61=w+5349, *w62=w+5445, *w63=w+5541, *w64=w+5637, *w65=w+5733, *w66=w+5829, *w67=w+5925, *w68=w+6021, *w69=w+6117, *w70=w+6213;
  casadi_real *w71=w+6309, *w72=w+6405, *w73=w+6501, *w74=w+6597, *w75=w+6605;
  const casadi_real **arg1=arg+2, *cs, *wr07;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w01);
  /* #2: @2 = @1[:5] */
  for (rr=w02, cs=w01+0; cs!=w01+5; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<6; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[5] */
  for (rr=(&w04), cs=w01+5; cs!=w01+6; cs+=1) *rr++ = *cs;
  /* #7: @6 = 384 */
  w06 = 384.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  wr07 = arg[1] ? arg[1] : casadi_zeros;
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 84, res[0]);
  /* #12: @0 = 0.03125 */
  w00 = 3.1250000000000000e-02;
  /* #13: @0 = (@0*@4) */
  w00 *= w04;
  /* #14: @6 = 384 */
  w06 = 384.;
  /* #15: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #16: {@5, @9, @12, @13} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+84);
  /* #18: @0 = 0.0625 */
  w00 = 6.2500000000000000e-02;
  /* #19: @0 = (@0*@4) */
  w00 *= w04;
  /* #20: @6 = 384 */
  w06 = 384.;
  /* #21: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #22: {@8, @9, @14, @15} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+168);
  /* #24: @0 = 0.09375 */
  w00 = 9.3750000000000000e-02;
  /* #25: @0 = (@0*@4) */
  w00 *= w04;
  /* #26: @6 = 384 */
  w06 = 384.;
  /* #27: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #28: {@5, @9, @16, @17} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+252);
  /* #30: @0 = 0.125 */
  w00 = 1.2500000000000000e-01;
  /* #31: @0 = (@0*@4) */
  w00 *= w04;
  /* #32: @6 = 384 */
  w06 = 384.;
  /* #33: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #34: {@8, @9, @18, @19} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+336);
  /* #36: @0 = 0.15625 */
  w00 = 1.5625000000000000e-01;
  /* #37: @0 = (@0*@4) */
  w00 *= w04;
  /* #38: @6 = 384 */
  w06 = 384.;
  /* #39: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #40: {@5, @9, @20, @21} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+420);
  /* #42: @0 = 0.1875 */
  w00 = 1.8750000000000000e-01;
  /* #43: @0 = (@0*@4) */
  w00 *= w04;
  /* #44: @6 = 384 */
  w06 = 384.;
  /* #45: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #46: {@8, @9, @22, @23} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+504);
  /* #48: @0 = 0.21875 */
  w00 = 2.1875000000000000e-01;
  /* #49: @0 = (@0*@4) */
  w00 *= w04;
  /* #50: @6 = 384 */
  w06 = 384.;
  /* #51: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #52: {@5, @9, @24, @25} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+588);
  /* #54: @0 = 0.25 */
  w00 = 2.5000000000000000e-01;
  /* #55: @0 = (@0*@4) */
  w00 *= w04;
  /* #56: @6 = 384 */
  w06 = 384.;
  /* #57: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #58: {@8, @9, @26, @27} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+672);
  /* #60: @0 = 0.28125 */
  w00 = 2.8125000000000000e-01;
  /* #61: @0 = (@0*@4) */
  w00 *= w04;
  /* #62: @6 = 384 */
  w06 = 384.;
  /* #63: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #64: {@5, @9, @28, @29} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+756);
  /* #66: @0 = 0.3125 */
  w00 = 3.1250000000000000e-01;
  /* #67: @0 = (@0*@4) */
  w00 *= w04;
  /* #68: @6 = 384 */
  w06 = 384.;
  /* #69: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #70: {@8, @9, @30, @31} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #71: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+840);
  /* #72: @0 = 0.34375 */
  w00 = 3.4375000000000000e-01;
  /* #73: @0 = (@0*@4) */
  w00 *= w04;
  /* #74: @6 = 384 */
  w06 = 384.;
  /* #75: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #76: {@5, @9, @32, @33} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+924);
  /* #78: @0 = 0.375 */
  w00 = 3.7500000000000000e-01;
  /* #79: @0 = (@0*@4) */
  w00 *= w04;
  /* #80: @6 = 384 */
  w06 = 384.;
  /* #81: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #82: {@8, @9, @34, @35} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1008);
  /* #84: @0 = 0.40625 */
  w00 = 4.0625000000000000e-01;
  /* #85: @0 = (@0*@4) */
  w00 *= w04;
  /* #86: @6 = 384 */
  w06 = 384.;
  /* #87: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #88: {@5, @9, @36, @37} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1092);
  /* #90: @0 = 0.4375 */
  w00 = 4.3750000000000000e-01;
  /* #91: @0 = (@0*@4) */
  w00 *= w04;
  /* #92: @6 = 384 */
  w06 = 384.;
  /* #93: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #94: {@8, @9, @38, @39} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1176);
  /* #96: @0 = 0.46875 */
  w00 = 4.6875000000000000e-01;
  /* #97: @0 = (@0*@4) */
  w00 *= w04;
  /* #98: @6 = 384 */
  w06 = 384.;
  /* #99: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #100: {@5, @9, @40, @41} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1260);
  /* #102: @0 = 0.5 */
  w00 = 5.0000000000000000e-01;
  /* #103: @0 = (@0*@4) */
  w00 *= w04;
  /* #104: @6 = 384 */
  w06 = 384.;
  /* #105: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #106: {@8, @9, @42, @43} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w42;
  res1[3]=w43;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #107: output[0][16] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1344);
  /* #108: @0 = 0.53125 */
  w00 = 5.3125000000000000e-01;
  /* #109: @0 = (@0*@4) */
  w00 *= w04;
  /* #110: @6 = 384 */
  w06 = 384.;
  /* #111: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #112: {@5, @9, @44, @45} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w44;
  res1[3]=w45;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #113: output[0][17] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1428);
  /* #114: @0 = 0.5625 */
  w00 = 5.6250000000000000e-01;
  /* #115: @0 = (@0*@4) */
  w00 *= w04;
  /* #116: @6 = 384 */
  w06 = 384.;
  /* #117: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #118: {@8, @9, @46, @47} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w46;
  res1[3]=w47;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #119: output[0][18] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1512);
  /* #120: @0 = 0.59375 */
  w00 = 5.9375000000000000e-01;
  /* #121: @0 = (@0*@4) */
  w00 *= w04;
  /* #122: @6 = 384 */
  w06 = 384.;
  /* #123: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #124: {@5, @9, @48, @49} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w48;
  res1[3]=w49;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #125: output[0][19] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1596);
  /* #126: @0 = 0.625 */
  w00 = 6.2500000000000000e-01;
  /* #127: @0 = (@0*@4) */
  w00 *= w04;
  /* #128: @6 = 384 */
  w06 = 384.;
  /* #129: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #130: {@8, @9, @50, @51} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w50;
  res1[3]=w51;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #131: output[0][20] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1680);
  /* #132: @0 = 0.65625 */
  w00 = 6.5625000000000000e-01;
  /* #133: @0 = (@0*@4) */
  w00 *= w04;
  /* #134: @6 = 384 */
  w06 = 384.;
  /* #135: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #136: {@5, @9, @52, @53} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w52;
  res1[3]=w53;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #137: output[0][21] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1764);
  /* #138: @0 = 0.6875 */
  w00 = 6.8750000000000000e-01;
  /* #139: @0 = (@0*@4) */
  w00 *= w04;
  /* #140: @6 = 384 */
  w06 = 384.;
  /* #141: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #142: {@8, @9, @54, @55} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w54;
  res1[3]=w55;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #143: output[0][22] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1848);
  /* #144: @0 = 0.71875 */
  w00 = 7.1875000000000000e-01;
  /* #145: @0 = (@0*@4) */
  w00 *= w04;
  /* #146: @6 = 384 */
  w06 = 384.;
  /* #147: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #148: {@5, @9, @56, @57} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w56;
  res1[3]=w57;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #149: output[0][23] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+1932);
  /* #150: @0 = 0.75 */
  w00 = 7.5000000000000000e-01;
  /* #151: @0 = (@0*@4) */
  w00 *= w04;
  /* #152: @6 = 384 */
  w06 = 384.;
  /* #153: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #154: {@8, @9, @58, @59} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w58;
  res1[3]=w59;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #155: output[0][24] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2016);
  /* #156: @0 = 0.78125 */
  w00 = 7.8125000000000000e-01;
  /* #157: @0 = (@0*@4) */
  w00 *= w04;
  /* #158: @6 = 384 */
  w06 = 384.;
  /* #159: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #160: {@5, @9, @60, @61} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w60;
  res1[3]=w61;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #161: output[0][25] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2100);
  /* #162: @0 = 0.8125 */
  w00 = 8.1250000000000000e-01;
  /* #163: @0 = (@0*@4) */
  w00 *= w04;
  /* #164: @6 = 384 */
  w06 = 384.;
  /* #165: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #166: {@8, @9, @62, @63} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w62;
  res1[3]=w63;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #167: output[0][26] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2184);
  /* #168: @0 = 0.84375 */
  w00 = 8.4375000000000000e-01;
  /* #169: @0 = (@0*@4) */
  w00 *= w04;
  /* #170: @6 = 384 */
  w06 = 384.;
  /* #171: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #172: {@5, @9, @64, @65} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w64;
  res1[3]=w65;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #173: output[0][27] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2268);
  /* #174: @0 = 0.875 */
  w00 = 8.7500000000000000e-01;
  /* #175: @0 = (@0*@4) */
  w00 *= w04;
  /* #176: @6 = 384 */
  w06 = 384.;
  /* #177: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #178: {@8, @9, @66, @67} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w66;
  res1[3]=w67;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #179: output[0][28] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2352);
  /* #180: @0 = 0.90625 */
  w00 = 9.0625000000000000e-01;
  /* #181: @0 = (@0*@4) */
  w00 *= w04;
  /* #182: @6 = 384 */
  w06 = 384.;
  /* #183: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #184: {@5, @9, @68, @69} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w68;
  res1[3]=w69;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #185: output[0][29] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2436);
  /* #186: @0 = 0.9375 */
  w00 = 9.3750000000000000e-01;
  /* #187: @0 = (@0*@4) */
  w00 *= w04;
  /* #188: @6 = 384 */
  w06 = 384.;
  /* #189: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #190: {@8, @9, @70, @71} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w70;
  res1[3]=w71;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #191: output[0][30] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2520);
  /* #192: @0 = 0.96875 */
  w00 = 9.6875000000000000e-01;
  /* #193: @0 = (@0*@4) */
  w00 *= w04;
  /* #194: @6 = 384 */
  w06 = 384.;
  /* #195: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #196: {@5, @9, @72, @73} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w08;
  arg1[2]=(&w06);
  arg1[3]=wr07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w72;
  res1[3]=w73;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #197: output[0][31] = @9 */
  if (res[0]) casadi_copy(w09, 84, res[0]+2604);
  /* #198: output[0][32] = @5 */
  if (res[0]) casadi_copy(w05, 7, res[0]+2688);
  /* #199: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #200: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #201: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #202: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #203: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 96, res[1]+384);
  /* #204: output[1][5] = @20 */
  if (res[1]) casadi_copy(w20, 96, res[1]+480);
  /* #205: output[1][6] = @22 */
  if (res[1]) casadi_copy(w22, 96, res[1]+576);
  /* #206: output[1][7] = @24 */
  if (res[1]) casadi_copy(w24, 96, res[1]+672);
  /* #207: output[1][8] = @26 */
  if (res[1]) casadi_copy(w26, 96, res[1]+768);
  /* #208: output[1][9] = @28 */
  if (res[1]) casadi_copy(w28, 96, res[1]+864);
  /* #209: output[1][10] = @30 */
  if (res[1]) casadi_copy(w30, 96, res[1]+960);
  /* #210: output[1][11] = @32 */
  if (res[1]) casadi_copy(w32, 96, res[1]+1056);
  /* #211: output[1][12] = @34 */
  if (res[1]) casadi_copy(w34, 96, res[1]+1152);
  /* #212: output[1][13] = @36 */
  if (res[1]) casadi_copy(w36, 96, res[1]+1248);
  /* #213: output[1][14] = @38 */
  if (res[1]) casadi_copy(w38, 96, res[1]+1344);
  /* #214: output[1][15] = @40 */
  if (res[1]) casadi_copy(w40, 96, res[1]+1440);
  /* #215: output[1][16] = @42 */
  if (res[1]) casadi_copy(w42, 96, res[1]+1536);
  /* #216: output[1][17] = @44 */
  if (res[1]) casadi_copy(w44, 96, res[1]+1632);
  /* #217: output[1][18] = @46 */
  if (res[1]) casadi_copy(w46, 96, res[1]+1728);
  /* #218: output[1][19] = @48 */
  if (res[1]) casadi_copy(w48, 96, res[1]+1824);
  /* #219: output[1][20] = @50 */
  if (res[1]) casadi_copy(w50, 96, res[1]+1920);
  /* #220: output[1][21] = @52 */
  if (res[1]) casadi_copy(w52, 96, res[1]+2016);
  /* #221: output[1][22] = @54 */
  if (res[1]) casadi_copy(w54, 96, res[1]+2112);
  /* #222: output[1][23] = @56 */
  if (res[1]) casadi_copy(w56, 96, res[1]+2208);
  /* #223: output[1][24] = @58 */
  if (res[1]) casadi_copy(w58, 96, res[1]+2304);
  /* #224: output[1][25] = @60 */
  if (res[1]) casadi_copy(w60, 96, res[1]+2400);
  /* #225: output[1][26] = @62 */
  if (res[1]) casadi_copy(w62, 96, res[1]+2496);
  /* #226: output[1][27] = @64 */
  if (res[1]) casadi_copy(w64, 96, res[1]+2592);
  /* #227: output[1][28] = @66 */
  if (res[1]) casadi_copy(w66, 96, res[1]+2688);
  /* #228: output[1][29] = @68 */
  if (res[1]) casadi_copy(w68, 96, res[1]+2784);
  /* #229: output[1][30] = @70 */
  if (res[1]) casadi_copy(w70, 96, res[1]+2880);
  /* #230: output[1][31] = @72 */
  if (res[1]) casadi_copy(w72, 96, res[1]+2976);
  /* #231: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #232: {@74, @75} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=wr07;
  res1[0]=w74;
  res1[1]=w75;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #233: output[1][32] = @74 */
  if (res[1]) casadi_copy(w74, 8, res[1]+3072);
  /* #234: output[2][0] = @11 */
  casadi_copy(w11, 96, res[2]);
  /* #235: output[2][1] = @13 */
  if (res[2]) casadi_copy(w13, 96, res[2]+96);
  /* #236: output[2][2] = @15 */
  if (res[2]) casadi_copy(w15, 96, res[2]+192);
  /* #237: output[2][3] = @17 */
  if (res[2]) casadi_copy(w17, 96, res[2]+288);
  /* #238: output[2][4] = @19 */
  if (res[2]) casadi_copy(w19, 96, res[2]+384);
  /* #239: output[2][5] = @21 */
  if (res[2]) casadi_copy(w21, 96, res[2]+480);
  /* #240: output[2][6] = @23 */
  if (res[2]) casadi_copy(w23, 96, res[2]+576);
  /* #241: output[2][7] = @25 */
  if (res[2]) casadi_copy(w25, 96, res[2]+672);
  /* #242: output[2][8] = @27 */
  if (res[2]) casadi_copy(w27, 96, res[2]+768);
  /* #243: output[2][9] = @29 */
  if (res[2]) casadi_copy(w29, 96, res[2]+864);
  /* #244: output[2][10] = @31 */
  if (res[2]) casadi_copy(w31, 96, res[2]+960);
  /* #245: output[2][11] = @33 */
  if (res[2]) casadi_copy(w33, 96, res[2]+1056);
  /* #246: output[2][12] = @35 */
  if (res[2]) casadi_copy(w35, 96, res[2]+1152);
  /* #247: output[2][13] = @37 */
  if (res[2]) casadi_copy(w37, 96, res[2]+1248);
  /* #248: output[2][14] = @39 */
  if (res[2]) casadi_copy(w39, 96, res[2]+1344);
  /* #249: output[2][15] = @41 */
  if (res[2]) casadi_copy(w41, 96, res[2]+1440);
  /* #250: output[2][16] = @43 */
  if (res[2]) casadi_copy(w43, 96, res[2]+1536);
  /* #251: output[2][17] = @45 */
  if (res[2]) casadi_copy(w45, 96, res[2]+1632);
  /* #252: output[2][18] = @47 */
  if (res[2]) casadi_copy(w47, 96, res[2]+1728);
  /* #253: output[2][19] = @49 */
  if (res[2]) casadi_copy(w49, 96, res[2]+1824);
  /* #254: output[2][20] = @51 */
  if (res[2]) casadi_copy(w51, 96, res[2]+1920);
  /* #255: output[2][21] = @53 */
  if (res[2]) casadi_copy(w53, 96, res[2]+2016);
  /* #256: output[2][22] = @55 */
  if (res[2]) casadi_copy(w55, 96, res[2]+2112);
  /* #257: output[2][23] = @57 */
  if (res[2]) casadi_copy(w57, 96, res[2]+2208);
  /* #258: output[2][24] = @59 */
  if (res[2]) casadi_copy(w59, 96, res[2]+2304);
  /* #259: output[2][25] = @61 */
  if (res[2]) casadi_copy(w61, 96, res[2]+2400);
  /* #260: output[2][26] = @63 */
  if (res[2]) casadi_copy(w63, 96, res[2]+2496);
  /* #261: output[2][27] = @65 */
  if (res[2]) casadi_copy(w65, 96, res[2]+2592);
  /* #262: output[2][28] = @67 */
  if (res[2]) casadi_copy(w67, 96, res[2]+2688);
  /* #263: output[2][29] = @69 */
  if (res[2]) casadi_copy(w69, 96, res[2]+2784);
  /* #264: output[2][30] = @71 */
  if (res[2]) casadi_copy(w71, 96, res[2]+2880);
  /* #265: output[2][31] = @73 */
  if (res[2]) casadi_copy(w73, 96, res[2]+2976);
  /* #266: output[2][32] = @75 */
  if (res[2]) casadi_copy(w75, 8, res[2]+3072);
  /* #267: @1 = @5[:6] */
  for (rr=w01, cs=w05+0; cs!=w05+6; cs+=1) *rr++ = *cs;
  /* #268: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=wr07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #269: output[3][0] = @3 */
  casadi_copy(w03, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f45(arg, res, iw, w, mem);
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
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6613;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6613*sizeof(casadi_real);
  return 0;
}

/* wobbling_trace_768:(u[6],p[8])->(w[7x769],g[8x769],dg[8x769],R[6]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+338, *w002=w+344, *w003=w+349, w004, *w005=w+355, w006, *w008=w+362, *w009=w+369, *w010=w+453;
  casadi_real *w011=w+549, *w012=w+645, *w013=w+741, *w014=w+837, *w015=w+933, *w016=w+1029, *w017=w+1125, *w018=w+1221, *w019=w+1317, *w020=w+1413, *w021=w+1509, *w022=w+1605;
  casadi_real *w023=w+1701, *w024=w+1797, *w025=w+1893, *w026=w+1989, *w027=w+2085, *w028=w+2181, *w029=w+2277, *w030=w+2373, *w031=w+2469, *w032=w+2565, *w033=w+2661, *w034=w+2757;
  casadi_real *w035=w+2853, *w036=w+2949, *w037=w+3045, *w038=w+3141, *w039=w+3237, *w040=w+3333, *w041=w+3429, *w042=w+3525, *w043=w+3621, *w044=w+3717, *w045=w+3813, *w046=w+3909;
  casadi_real *w047=w+4005, *w048=w+4101, *w049=w+4197, *w050=w+4293, *w051=w+4389, *w052=w+4485, *w053=w+4581, *w054=w+4677, *w055=w+4773, *w056=w+4869, *w057=w+4965, *w058=w+5061;
  casadi_real *w059=w+5157, *w060=w+5253, *w061=w+5349, *w062=w+5445, *w063=w+5541, *w064=w+5637, *w065=w+5733, *w066=w+5829, *w067=w+5925, *w068=w+6021, *w069=w+6117, *w070=w+6213;
  casadi_real *w071=w+6309, *w072=w+6405, *w073=w+6501, *w074=w+6597, *w075=w+6693, *w076=w+6789, *w077=w+6885, *w078=w+6981, *w079=w+7077, *w080=w+7173, *w081=w+7269, *w082=w+7365;
  casadi_real *w083=w+7461, *w084=w+7557, *w085=w+7653, *w086=w+7749, *w087=w+7845, *w088=w+7941, *w089=w+8037, *w090=w+8133, *w091=w+8229, *w092=w+8325, *w093=w+8421, *w094=w+8517;
  casadi_real *w095=w+8613, *w096=w+8709, *w097=w+8805, *w098=w+8901, *w099=w+8997, *w100=w+9093, *w101=w+9189, *w102=w+9285, *w103=w+9381, *w104=w+9477, *w105=w+9573, *w106=w+9669;
  casadi_real *w107=w+9765, *w108=w+9861, *w109=w+9957, *w110=w+10053, *w111=w+10149, *w112=w+10245, *w113=w+10341, *w114=w+10437, *w115=w+10533, *w116=w+10629, *w117=w+10725, *w118=w+10821;
  casadi_real *w119=w+10917, *w120=w+11013, *w121=w+11109, *w122=w+11205, *w123=w+11301, *w124=w+11397, *w125=w+11493, *w126=w+11589, *w127=w+11685, *w128=w+11781, *w129=w+11877, *w130=w+11973;
  casadi_real *w131=w+12069, *w132=w+12165, *w133=w+12261, *w134=w+12357, *w135=w+12453, *w136=w+12549, *w137=w+12645, *w138=w+12741, *w139=w+12749;
  const casadi_real **arg1=arg+2, *cs, *wr007;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 6, w001);
  /* #2: @2 = @1[:5] */
  for (rr=w002, cs=w001+0; cs!=w001+5; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w002;
  res1[0]=w003;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w004 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w005;
  for (i=0, cs=w003; i<6; ++i) *rr++ = *cs++;
  *rr++ = w004;
  /* #6: @4 = @1[5] */
  for (rr=(&w004), cs=w001+5; cs!=w001+6; cs+=1) *rr++ = *cs;
  /* #7: @6 = 768 */
  w006 = 768.;
  /* #8: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #9: @7 = input[1][0] */
  wr007 = arg[1] ? arg[1] : casadi_zeros;
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w010;
  res1[3]=w011;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w009, 84, res[0]);
  /* #12: @0 = 0.015625 */
  w000 = 1.5625000000000000e-02;
  /* #13: @0 = (@0*@4) */
  w000 *= w004;
  /* #14: @6 = 768 */
  w006 = 768.;
  /* #15: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #16: {@5, @9, @12, @13} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w012;
  res1[3]=w013;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+84);
  /* #18: @0 = 0.03125 */
  w000 = 3.1250000000000000e-02;
  /* #19: @0 = (@0*@4) */
  w000 *= w004;
  /* #20: @6 = 768 */
  w006 = 768.;
  /* #21: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #22: {@8, @9, @14, @15} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w014;
  res1[3]=w015;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+168);
  /* #24: @0 = 0.046875 */
  w000 = 4.6875000000000000e-02;
  /* #25: @0 = (@0*@4) */
  w000 *= w004;
  /* #26: @6 = 768 */
  w006 = 768.;
  /* #27: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #28: {@5, @9, @16, @17} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w016;
  res1[3]=w017;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+252);
  /* #30: @0 = 0.0625 */
  w000 = 6.2500000000000000e-02;
  /* #31: @0 = (@0*@4) */
  w000 *= w004;
  /* #32: @6 = 768 */
  w006 = 768.;
  /* #33: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #34: {@8, @9, @18, @19} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w018;
  res1[3]=w019;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+336);
  /* #36: @0 = 0.078125 */
  w000 = 7.8125000000000000e-02;
  /* #37: @0 = (@0*@4) */
  w000 *= w004;
  /* #38: @6 = 768 */
  w006 = 768.;
  /* #39: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #40: {@5, @9, @20, @21} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w020;
  res1[3]=w021;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+420);
  /* #42: @0 = 0.09375 */
  w000 = 9.3750000000000000e-02;
  /* #43: @0 = (@0*@4) */
  w000 *= w004;
  /* #44: @6 = 768 */
  w006 = 768.;
  /* #45: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #46: {@8, @9, @22, @23} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w022;
  res1[3]=w023;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+504);
  /* #48: @0 = 0.109375 */
  w000 = 1.0937500000000000e-01;
  /* #49: @0 = (@0*@4) */
  w000 *= w004;
  /* #50: @6 = 768 */
  w006 = 768.;
  /* #51: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #52: {@5, @9, @24, @25} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w024;
  res1[3]=w025;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+588);
  /* #54: @0 = 0.125 */
  w000 = 1.2500000000000000e-01;
  /* #55: @0 = (@0*@4) */
  w000 *= w004;
  /* #56: @6 = 768 */
  w006 = 768.;
  /* #57: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #58: {@8, @9, @26, @27} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w026;
  res1[3]=w027;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][8] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+672);
  /* #60: @0 = 0.140625 */
  w000 = 1.4062500000000000e-01;
  /* #61: @0 = (@0*@4) */
  w000 *= w004;
  /* #62: @6 = 768 */
  w006 = 768.;
  /* #63: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #64: {@5, @9, @28, @29} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w028;
  res1[3]=w029;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[0][9] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+756);
  /* #66: @0 = 0.15625 */
  w000 = 1.5625000000000000e-01;
  /* #67: @0 = (@0*@4) */
  w000 *= w004;
  /* #68: @6 = 768 */
  w006 = 768.;
  /* #69: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #70: {@8, @9, @30, @31} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w030;
  res1[3]=w031;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #71: output[0][10] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+840);
  /* #72: @0 = 0.171875 */
  w000 = 1.7187500000000000e-01;
  /* #73: @0 = (@0*@4) */
  w000 *= w004;
  /* #74: @6 = 768 */
  w006 = 768.;
  /* #75: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #76: {@5, @9, @32, @33} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w032;
  res1[3]=w033;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[0][11] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+924);
  /* #78: @0 = 0.1875 */
  w000 = 1.8750000000000000e-01;
  /* #79: @0 = (@0*@4) */
  w000 *= w004;
  /* #80: @6 = 768 */
  w006 = 768.;
  /* #81: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #82: {@8, @9, @34, @35} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w034;
  res1[3]=w035;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[0][12] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1008);
  /* #84: @0 = 0.203125 */
  w000 = 2.0312500000000000e-01;
  /* #85: @0 = (@0*@4) */
  w000 *= w004;
  /* #86: @6 = 768 */
  w006 = 768.;
  /* #87: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #88: {@5, @9, @36, @37} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w036;
  res1[3]=w037;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[0][13] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1092);
  /* #90: @0 = 0.21875 */
  w000 = 2.1875000000000000e-01;
  /* #91: @0 = (@0*@4) */
  w000 *= w004;
  /* #92: @6 = 768 */
  w006 = 768.;
  /* #93: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #94: {@8, @9, @38, @39} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w038;
  res1[3]=w039;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[0][14] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1176);
  /* #96: @0 = 0.234375 */
  w000 = 2.3437500000000000e-01;
  /* #97: @0 = (@0*@4) */
  w000 *= w004;
  /* #98: @6 = 768 */
  w006 = 768.;
  /* #99: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #100: {@5, @9, @40, @41} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w040;
  res1[3]=w041;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[0][15] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1260);
  /* #102: @0 = 0.25 */
  w000 = 2.5000000000000000e-01;
  /* #103: @0 = (@0*@4) */
  w000 *= w004;
  /* #104: @6 = 768 */
  w006 = 768.;
  /* #105: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #106: {@8, @9, @42, @43} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w042;
  res1[3]=w043;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #107: output[0][16] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1344);
  /* #108: @0 = 0.265625 */
  w000 = 2.6562500000000000e-01;
  /* #109: @0 = (@0*@4) */
  w000 *= w004;
  /* #110: @6 = 768 */
  w006 = 768.;
  /* #111: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #112: {@5, @9, @44, @45} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w044;
  res1[3]=w045;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #113: output[0][17] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1428);
  /* #114: @0 = 0.28125 */
  w000 = 2.8125000000000000e-01;
  /* #115: @0 = (@0*@4) */
  w000 *= w004;
  /* #116: @6 = 768 */
  w006 = 768.;
  /* #117: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #118: {@8, @9, @46, @47} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w046;
  res1[3]=w047;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #119: output[0][18] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1512);
  /* #120: @0 = 0.296875 */
  w000 = 2.9687500000000000e-01;
  /* #121: @0 = (@0*@4) */
  w000 *= w004;
  /* #122: @6 = 768 */
  w006 = 768.;
  /* #123: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #124: {@5, @9, @48, @49} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w048;
  res1[3]=w049;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #125: output[0][19] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1596);
  /* #126: @0 = 0.3125 */
  w000 = 3.1250000000000000e-01;
  /* #127: @0 = (@0*@4) */
  w000 *= w004;
  /* #128: @6 = 768 */
  w006 = 768.;
  /* #129: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #130: {@8, @9, @50, @51} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w050;
  res1[3]=w051;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #131: output[0][20] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1680);
  /* #132: @0 = 0.328125 */
  w000 = 3.2812500000000000e-01;
  /* #133: @0 = (@0*@4) */
  w000 *= w004;
  /* #134: @6 = 768 */
  w006 = 768.;
  /* #135: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #136: {@5, @9, @52, @53} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w052;
  res1[3]=w053;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #137: output[0][21] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1764);
  /* #138: @0 = 0.34375 */
  w000 = 3.4375000000000000e-01;
  /* #139: @0 = (@0*@4) */
  w000 *= w004;
  /* #140: @6 = 768 */
  w006 = 768.;
  /* #141: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #142: {@8, @9, @54, @55} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w054;
  res1[3]=w055;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #143: output[0][22] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1848);
  /* #144: @0 = 0.359375 */
  w000 = 3.5937500000000000e-01;
  /* #145: @0 = (@0*@4) */
  w000 *= w004;
  /* #146: @6 = 768 */
  w006 = 768.;
  /* #147: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #148: {@5, @9, @56, @57} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w056;
  res1[3]=w057;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #149: output[0][23] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+1932);
  /* #150: @0 = 0.375 */
  w000 = 3.7500000000000000e-01;
  /* #151: @0 = (@0*@4) */
  w000 *= w004;
  /* #152: @6 = 768 */
  w006 = 768.;
  /* #153: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #154: {@8, @9, @58, @59} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w058;
  res1[3]=w059;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #155: output[0][24] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2016);
  /* #156: @0 = 0.390625 */
  w000 = 3.9062500000000000e-01;
  /* #157: @0 = (@0*@4) */
  w000 *= w004;
  /* #158: @6 = 768 */
  w006 = 768.;
  /* #159: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #160: {@5, @9, @60, @61} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w060;
  res1[3]=w061;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #161: output[0][25] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2100);
  /* #162: @0 = 0.40625 */
  w000 = 4.0625000000000000e-01;
  /* #163: @0 = (@0*@4) */
  w000 *= w004;
  /* #164: @6 = 768 */
  w006 = 768.;
  /* #165: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #166: {@8, @9, @62, @63} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w062;
  res1[3]=w063;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #167: output[0][26] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2184);
  /* #168: @0 = 0.421875 */
  w000 = 4.2187500000000000e-01;
  /* #169: @0 = (@0*@4) */
  w000 *= w004;
  /* #170: @6 = 768 */
  w006 = 768.;
  /* #171: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #172: {@5, @9, @64, @65} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w064;
  res1[3]=w065;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #173: output[0][27] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2268);
  /* #174: @0 = 0.4375 */
  w000 = 4.3750000000000000e-01;
  /* #175: @0 = (@0*@4) */
  w000 *= w004;
  /* #176: @6 = 768 */
  w006 = 768.;
  /* #177: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #178: {@8, @9, @66, @67} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w066;
  res1[3]=w067;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #179: output[0][28] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2352);
  /* #180: @0 = 0.453125 */
  w000 = 4.5312500000000000e-01;
  /* #181: @0 = (@0*@4) */
  w000 *= w004;
  /* #182: @6 = 768 */
  w006 = 768.;
  /* #183: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #184: {@5, @9, @68, @69} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w068;
  res1[3]=w069;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #185: output[0][29] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2436);
  /* #186: @0 = 0.46875 */
  w000 = 4.6875000000000000e-01;
  /* #187: @0 = (@0*@4) */
  w000 *= w004;
  /* #188: @6 = 768 */
  w006 = 768.;
  /* #189: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #190: {@8, @9, @70, @71} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w070;
  res1[3]=w071;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #191: output[0][30] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2520);
  /* #192: @0 = 0.484375 */
  w000 = 4.8437500000000000e-01;
  /* #193: @0 = (@0*@4) */
  w000 *= w004;
  /* #194: @6 = 768 */
  w006 = 768.;
  /* #195: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #196: {@5, @9, @72, @73} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w072;
  res1[3]=w073;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #197: output[0][31] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2604);
  /* #198: @0 = 0.5 */
  w000 = 5.0000000000000000e-01;
  /* #199: @0 = (@0*@4) */
  w000 *= w004;
  /* #200: @6 = 768 */
  w006 = 768.;
  /* #201: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #202: {@8, @9, @74, @75} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w074;
  res1[3]=w075;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #203: output[0][32] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2688);
  /* #204: @0 = 0.515625 */
  w000 = 5.1562500000000000e-01;
  /* #205: @0 = (@0*@4) */
  w000 *= w004;
  /* #206: @6 = 768 */
  w006 = 768.;
  /* #207: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #208: {@5, @9, @76, @77} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w076;
  res1[3]=w077;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #209: output[0][33] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2772);
  /* #210: @0 = 0.53125 */
  w000 = 5.3125000000000000e-01;
  /* #211: @0 = (@0*@4) */
  w000 *= w004;
  /* #212: @6 = 768 */
  w006 = 768.;
  /* #213: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #214: {@8, @9, @78, @79} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w078;
  res1[3]=w079;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #215: output[0][34] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2856);
  /* #216: @0 = 0.546875 */
  w000 = 5.4687500000000000e-01;
  /* #217: @0 = (@0*@4) */
  w000 *= w004;
  /* #218: @6 = 768 */
  w006 = 768.;
  /* #219: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #220: {@5, @9, @80, @81} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w080;
  res1[3]=w081;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #221: output[0][35] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+2940);
  /* #222: @0 = 0.5625 */
  w000 = 5.6250000000000000e-01;
  /* #223: @0 = (@0*@4) */
  w000 *= w004;
  /* #224: @6 = 768 */
  w006 = 768.;
  /* #225: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #226: {@8, @9, @82, @83} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w082;
  res1[3]=w083;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #227: output[0][36] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3024);
  /* #228: @0 = 0.578125 */
  w000 = 5.7812500000000000e-01;
  /* #229: @0 = (@0*@4) */
  w000 *= w004;
  /* #230: @6 = 768 */
  w006 = 768.;
  /* #231: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #232: {@5, @9, @84, @85} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w084;
  res1[3]=w085;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #233: output[0][37] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3108);
  /* #234: @0 = 0.59375 */
  w000 = 5.9375000000000000e-01;
  /* #235: @0 = (@0*@4) */
  w000 *= w004;
  /* #236: @6 = 768 */
  w006 = 768.;
  /* #237: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #238: {@8, @9, @86, @87} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w086;
  res1[3]=w087;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #239: output[0][38] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3192);
  /* #240: @0 = 0.609375 */
  w000 = 6.0937500000000000e-01;
  /* #241: @0 = (@0*@4) */
  w000 *= w004;
  /* #242: @6 = 768 */
  w006 = 768.;
  /* #243: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #244: {@5, @9, @88, @89} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w088;
  res1[3]=w089;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #245: output[0][39] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3276);
  /* #246: @0 = 0.625 */
  w000 = 6.2500000000000000e-01;
  /* #247: @0 = (@0*@4) */
  w000 *= w004;
  /* #248: @6 = 768 */
  w006 = 768.;
  /* #249: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #250: {@8, @9, @90, @91} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w090;
  res1[3]=w091;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #251: output[0][40] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3360);
  /* #252: @0 = 0.640625 */
  w000 = 6.4062500000000000e-01;
  /* #253: @0 = (@0*@4) */
  w000 *= w004;
  /* #254: @6 = 768 */
  w006 = 768.;
  /* #255: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #256: {@5, @9, @92, @93} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w092;
  res1[3]=w093;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #257: output[0][41] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3444);
  /* #258: @0 = 0.65625 */
  w000 = 6.5625000000000000e-01;
  /* #259: @0 = (@0*@4) */
  w000 *= w004;
  /* #260: @6 = 768 */
  w006 = 768.;
  /* #261: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #262: {@8, @9, @94, @95} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w094;
  res1[3]=w095;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #263: output[0][42] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3528);
  /* #264: @0 = 0.671875 */
  w000 = 6.7187500000000000e-01;
  /* #265: @0 = (@0*@4) */
  w000 *= w004;
  /* #266: @6 = 768 */
  w006 = 768.;
  /* #267: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #268: {@5, @9, @96, @97} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w096;
  res1[3]=w097;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #269: output[0][43] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3612);
  /* #270: @0 = 0.6875 */
  w000 = 6.8750000000000000e-01;
  /* #271: @0 = (@0*@4) */
  w000 *= w004;
  /* #272: @6 = 768 */
  w006 = 768.;
  /* #273: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #274: {@8, @9, @98, @99} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w098;
  res1[3]=w099;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #275: output[0][44] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3696);
  /* #276: @0 = 0.703125 */
  w000 = 7.0312500000000000e-01;
  /* #277: @0 = (@0*@4) */
  w000 *= w004;
  /* #278: @6 = 768 */
  w006 = 768.;
  /* #279: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #280: {@5, @9, @100, @101} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w100;
  res1[3]=w101;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #281: output[0][45] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3780);
  /* #282: @0 = 0.71875 */
  w000 = 7.1875000000000000e-01;
  /* #283: @0 = (@0*@4) */
  w000 *= w004;
  /* #284: @6 = 768 */
  w006 = 768.;
  /* #285: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #286: {@8, @9, @102, @103} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w102;
  res1[3]=w103;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #287: output[0][46] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3864);
  /* #288: @0 = 0.734375 */
  w000 = 7.3437500000000000e-01;
  /* #289: @0 = (@0*@4) */
  w000 *= w004;
  /* #290: @6 = 768 */
  w006 = 768.;
  /* #291: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #292: {@5, @9, @104, @105} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w104;
  res1[3]=w105;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #293: output[0][47] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+3948);
  /* #294: @0 = 0.75 */
  w000 = 7.5000000000000000e-01;
  /* #295: @0 = (@0*@4) */
  w000 *= w004;
  /* #296: @6 = 768 */
  w006 = 768.;
  /* #297: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #298: {@8, @9, @106, @107} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w106;
  res1[3]=w107;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #299: output[0][48] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4032);
  /* #300: @0 = 0.765625 */
  w000 = 7.6562500000000000e-01;
  /* #301: @0 = (@0*@4) */
  w000 *= w004;
  /* #302: @6 = 768 */
  w006 = 768.;
  /* #303: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #304: {@5, @9, @108, @109} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w108;
  res1[3]=w109;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #305: output[0][49] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4116);
  /* #306: @0 = 0.78125 */
  w000 = 7.8125000000000000e-01;
  /* #307: @0 = (@0*@4) */
  w000 *= w004;
  /* #308: @6 = 768 */
  w006 = 768.;
  /* #309: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #310: {@8, @9, @110, @111} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w110;
  res1[3]=w111;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #311: output[0][50] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4200);
  /* #312: @0 = 0.796875 */
  w000 = 7.9687500000000000e-01;
  /* #313: @0 = (@0*@4) */
  w000 *= w004;
  /* #314: @6 = 768 */
  w006 = 768.;
  /* #315: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #316: {@5, @9, @112, @113} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w112;
  res1[3]=w113;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #317: output[0][51] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4284);
  /* #318: @0 = 0.8125 */
  w000 = 8.1250000000000000e-01;
  /* #319: @0 = (@0*@4) */
  w000 *= w004;
  /* #320: @6 = 768 */
  w006 = 768.;
  /* #321: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #322: {@8, @9, @114, @115} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w114;
  res1[3]=w115;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #323: output[0][52] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4368);
  /* #324: @0 = 0.828125 */
  w000 = 8.2812500000000000e-01;
  /* #325: @0 = (@0*@4) */
  w000 *= w004;
  /* #326: @6 = 768 */
  w006 = 768.;
  /* #327: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #328: {@5, @9, @116, @117} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w116;
  res1[3]=w117;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #329: output[0][53] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4452);
  /* #330: @0 = 0.84375 */
  w000 = 8.4375000000000000e-01;
  /* #331: @0 = (@0*@4) */
  w000 *= w004;
  /* #332: @6 = 768 */
  w006 = 768.;
  /* #333: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #334: {@8, @9, @118, @119} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w118;
  res1[3]=w119;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #335: output[0][54] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4536);
  /* #336: @0 = 0.859375 */
  w000 = 8.5937500000000000e-01;
  /* #337: @0 = (@0*@4) */
  w000 *= w004;
  /* #338: @6 = 768 */
  w006 = 768.;
  /* #339: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #340: {@5, @9, @120, @121} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w120;
  res1[3]=w121;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #341: output[0][55] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4620);
  /* #342: @0 = 0.875 */
  w000 = 8.7500000000000000e-01;
  /* #343: @0 = (@0*@4) */
  w000 *= w004;
  /* #344: @6 = 768 */
  w006 = 768.;
  /* #345: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #346: {@8, @9, @122, @123} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w122;
  res1[3]=w123;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #347: output[0][56] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4704);
  /* #348: @0 = 0.890625 */
  w000 = 8.9062500000000000e-01;
  /* #349: @0 = (@0*@4) */
  w000 *= w004;
  /* #350: @6 = 768 */
  w006 = 768.;
  /* #351: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #352: {@5, @9, @124, @125} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w124;
  res1[3]=w125;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #353: output[0][57] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4788);
  /* #354: @0 = 0.90625 */
  w000 = 9.0625000000000000e-01;
  /* #355: @0 = (@0*@4) */
  w000 *= w004;
  /* #356: @6 = 768 */
  w006 = 768.;
  /* #357: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #358: {@8, @9, @126, @127} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w126;
  res1[3]=w127;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #359: output[0][58] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4872);
  /* #360: @0 = 0.921875 */
  w000 = 9.2187500000000000e-01;
  /* #361: @0 = (@0*@4) */
  w000 *= w004;
  /* #362: @6 = 768 */
  w006 = 768.;
  /* #363: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #364: {@5, @9, @128, @129} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w128;
  res1[3]=w129;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #365: output[0][59] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+4956);
  /* #366: @0 = 0.9375 */
  w000 = 9.3750000000000000e-01;
  /* #367: @0 = (@0*@4) */
  w000 *= w004;
  /* #368: @6 = 768 */
  w006 = 768.;
  /* #369: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #370: {@8, @9, @130, @131} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w130;
  res1[3]=w131;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #371: output[0][60] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+5040);
  /* #372: @0 = 0.953125 */
  w000 = 9.5312500000000000e-01;
  /* #373: @0 = (@0*@4) */
  w000 *= w004;
  /* #374: @6 = 768 */
  w006 = 768.;
  /* #375: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #376: {@5, @9, @132, @133} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w132;
  res1[3]=w133;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #377: output[0][61] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+5124);
  /* #378: @0 = 0.96875 */
  w000 = 9.6875000000000000e-01;
  /* #379: @0 = (@0*@4) */
  w000 *= w004;
  /* #380: @6 = 768 */
  w006 = 768.;
  /* #381: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #382: {@8, @9, @134, @135} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w134;
  res1[3]=w135;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #383: output[0][62] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+5208);
  /* #384: @0 = 0.984375 */
  w000 = 9.8437500000000000e-01;
  /* #385: @0 = (@0*@4) */
  w000 *= w004;
  /* #386: @6 = 768 */
  w006 = 768.;
  /* #387: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #388: {@5, @9, @136, @137} = working_steps(@0, @8, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w008;
  arg1[2]=(&w006);
  arg1[3]=wr007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w136;
  res1[3]=w137;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #389: output[0][63] = @9 */
  if (res[0]) casadi_copy(w009, 84, res[0]+5292);
  /* #390: output[0][64] = @5 */
  if (res[0]) casadi_copy(w005, 7, res[0]+5376);
  /* #391: output[1][0] = @10 */
  casadi_copy(w010, 96, res[1]);
  /* #392: output[1][1] = @12 */
  if (res[1]) casadi_copy(w012, 96, res[1]+96);
  /* #393: output[1][2] = @14 */
  if (res[1]) casadi_copy(w014, 96, res[1]+192);
  /* #394: output[1][3] = @16 */
  if (res[1]) casadi_copy(w016, 96, res[1]+288);
  /* #395: output[1][4] = @18 */
  if (res[1]) casadi_copy(w018, 96, res[1]+384);
  /* #396: output[1][5] = @20 */
  if (res[1]) casadi_copy(w020, 96, res[1]+480);
  /* #397: output[1][6] = @22 */
  if (res[1]) casadi_copy(w022, 96, res[1]+576);
  /* #398: output[1][7] = @24 */
  if (res[1]) casadi_copy(w024, 96, res[1]+672);
  /* #399: output[1][8] = @26 */
  if (res[1]) casadi_copy(w026, 96, res[1]+768);
  /* #400: output[1][9] = @28 */
  if (res[1]) casadi_copy(w028, 96, res[1]+864);
  /* #401: output[1][10] = @30 */
  if (res[1]) casadi_copy(w030, 96, res[1]+960);
  /* #402: output[1][11] = @32 */
  if (res[1]) casadi_copy(w032, 96, res[1]+1056);
  /* #403: output[1][12] = @34 */
  if (res[1]) casadi_copy(w034, 96, res[1]+1152);
  /* #404: output[1][13] = @36 */
  if (res[1]) casadi_copy(w036, 96, res[1]+1248);
  /* #405: output[1][14] = @38 */
  if (res[1]) casadi_copy(w038, 96, res[1]+1344);
  /* #406: output[1][15] = @40 */
  if (res[1]) casadi_copy(w040, 96, res[1]+1440);
  /* #407: output[1][16] = @42 */
  if (res[1]) casadi_copy(w042, 96, res[1]+1536);
  /* #408: output[1][17] = @44 */
  if (res[1]) casadi_copy(w044, 96, res[1]+1632);
  /* #409: output[1][18] = @46 */
  if (res[1]) casadi_copy(w046, 96, res[1]+1728);
  /* #410: output[1][19] = @48 */
  if (res[1]) casadi_copy(w048, 96, res[1]+1824);
  /* #411: output[1][20] = @50 */
  if (res[1]) casadi_copy(w050, 96, res[1]+1920);
  /* #412: output[1][21] = @52 */
  if (res[1]) casadi_copy(w052, 96, res[1]+2016);
  /* #413: output[1][22] = @54 */
  if (res[1]) casadi_copy(w054, 96, res[1]+2112);
  /* #414: output[1][23] = @56 */
  if (res[1]) casadi_copy(w056, 96, res[1]+2208);
  /* #415: output[1][24] = @58 */
  if (res[1]) casadi_copy(w058, 96, res[1]+2304);
  /* #416: output[1][25] = @60 */
  if (res[1]) casadi_copy(w060, 96, res[1]+2400);
  /* #417: output[1][26] = @62 */
  if (res[1]) casadi_copy(w062, 96, res[1]+2496);
  /* #418: output[1][27] = @64 */
  if (res[1]) casadi_copy(w064, 96, res[1]+2592);
  /* #419: output[1][28] = @66 */
  if (res[1]) casadi_copy(w066, 96, res[1]+2688);
  /* #420: output[1][29] = @68 */
  if (res[1]) casadi_copy(w068, 96, res[1]+2784);
  /* #421: output[1][30] = @70 */
  if (res[1]) casadi_copy(w070, 96, res[1]+2880);
  /* #422: output[1][31] = @72 */
  if (res[1]) casadi_copy(w072, 96, res[1]+2976);
  /* #423: output[1][32] = @74 */
  if (res[1]) casadi_copy(w074, 96, res[1]+3072);
  /* #424: output[1][33] = @76 */
  if (res[1]) casadi_copy(w076, 96, res[1]+3168);
  /* #425: output[1][34] = @78 */
  if (res[1]) casadi_copy(w078, 96, res[1]+3264);
  /* #426: output[1][35] = @80 */
  if (res[1]) casadi_copy(w080, 96, res[1]+3360);
  /* #427: output[1][36] = @82 */
  if (res[1]) casadi_copy(w082, 96, res[1]+3456);
  /* #428: output[1][37] = @84 */
  if (res[1]) casadi_copy(w084, 96, res[1]+3552);
  /* #429: output[1][38] = @86 */
  if (res[1]) casadi_copy(w086, 96, res[1]+3648);
  /* #430: output[1][39] = @88 */
  if (res[1]) casadi_copy(w088, 96, res[1]+3744);
  /* #431: output[1][40] = @90 */
  if (res[1]) casadi_copy(w090, 96, res[1]+3840);
  /* #432: output[1][41] = @92 */
  if (res[1]) casadi_copy(w092, 96, res[1]+3936);
  /* #433: output[1][42] = @94 */
  if (res[1]) casadi_copy(w094, 96, res[1]+4032);
  /* #434: output[1][43] = @96 */
  if (res[1]) casadi_copy(w096, 96, res[1]+4128);
  /* #435: output[1][44] = @98 */
  if (res[1]) casadi_copy(w098, 96, res[1]+4224);
  /* #436: output[1][45] = @100 */
  if (res[1]) casadi_copy(w100, 96, res[1]+4320);
  /* #437: output[1][46] = @102 */
  if (res[1]) casadi_copy(w102, 96, res[1]+4416);
  /* #438: output[1][47] = @104 */
  if (res[1]) casadi_copy(w104, 96, res[1]+4512);
  /* #439: output[1][48] = @106 */
  if (res[1]) casadi_copy(w106, 96, res[1]+4608);
  /* #440: output[1][49] = @108 */
  if (res[1]) casadi_copy(w108, 96, res[1]+4704);
  /* #441: output[1][50] = @110 */
  if (res[1]) casadi_copy(w110, 96, res[1]+4800);
  /* #442: output[1][51] = @112 */
  if (res[1]) casadi_copy(w112, 96, res[1]+4896);
  /* #443: output[1][52] = @114 */
  if (res[1]) casadi_copy(w114, 96, res[1]+4992);
  /* #444: output[1][53] = @116 */
  if (res[1]) casadi_copy(w116, 96, res[1]+5088);
  /* #445: output[1][54] = @118 */
  if (res[1]) casadi_copy(w118, 96, res[1]+5184);
  /* #446: output[1][55] = @120 */
  if (res[1]) casadi_copy(w120, 96, res[1]+5280);
  /* #447: output[1][56] = @122 */
  if (res[1]) casadi_copy(w122, 96, res[1]+5376);
  /* #448: output[1][57] = @124 */
  if (res[1]) casadi_copy(w124, 96, res[1]+5472);
  /* #449: output[1][58] = @126 */
  if (res[1]) casadi_copy(w126, 96, res[1]+5568);
  /* #450: output[1][59] = @128 */
  if (res[1]) casadi_copy(w128, 96, res[1]+5664);
  /* #451: output[1][60] = @130 */
  if (res[1]) casadi_copy(w130, 96, res[1]+5760);
  /* #452: output[1][61] = @132 */
  if (res[1]) casadi_copy(w132, 96, res[1]+5856);
  /* #453: output[1][62] = @134 */
  if (res[1]) casadi_copy(w134, 96, res[1]+5952);
  /* #454: output[1][63] = @136 */
  if (res[1]) casadi_copy(w136, 96, res[1]+6048);
  /* #455: @1 = @5[:6] */
  for (rr=w001, cs=w005+0; cs!=w005+6; cs+=1) *rr++ = *cs;
  /* #456: {@138, @139} = observe(@4, @1, @7) */
  arg1[0]=(&w004);
  arg1[1]=w001;
  arg1[2]=wr007;
  res1[0]=w138;
  res1[1]=w139;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #457: output[1][64] = @138 */
  if (res[1]) casadi_copy(w138, 8, res[1]+6144);
  /* #458: output[2][0] = @11 */
  casadi_copy(w011, 96, res[2]);
  /* #459: output[2][1] = @13 */
  if (res[2]) casadi_copy(w013, 96, res[2]+96);
  /* #460: output[2][2] = @15 */
  if (res[2]) casadi_copy(w015, 96, res[2]+192);
  /* #461: output[2][3] = @17 */
  if (res[2]) casadi_copy(w017, 96, res[2]+288);
  /* #462: output[2][4] = @19 */
  if (res[2]) casadi_copy(w019, 96, res[2]+384);
  /* #463: output[2][5] = @21 */
  if (res[2]) casadi_copy(w021, 96, res[2]+480);
  /* #464: output[2][6] = @23 */
  if (res[2]) casadi_copy(w023, 96, res[2]+576);
  /* #465: output[2][7] = @25 */
  if (res[2]) casadi_copy(w025, 96, res[2]+672);
  /* #466: output[2][8] = @27 */
  if (res[2]) casadi_copy(w027, 96, res[2]+768);
  /* #467: output[2][9] = @29 */
  if (res[2]) casadi_copy(w029, 96, res[2]+864);
  /* #468: output[2][10] = @31 */
  if (res[2]) casadi_copy(w031, 96, res[2]+960);
  /* #469: output[2][11] = @33 */
  if (res[2]) casadi_copy(w033, 96, res[2]+1056);
  /* #470: output[2][12] = @35 */
  if (res[2]) casadi_copy(w035, 96, res[2]+1152);
  /* #471: output[2][13] = @37 */
  if (res[2]) casadi_copy(w037, 96, res[2]+1248);
  /* #472: output[2][14] = @39 */
  if (res[2]) casadi_copy(w039, 96, res[2]+1344);
  /* #473: output[2][15] = @41 */
  if (res[2]) casadi_copy(w041, 96, res[2]+1440);
  /* #474: output[2][16] = @43 */
  if (res[2]) casadi_copy(w043, 96, res[2]+1536);
  /* #475: output[2][17] = @45 */
  if (res[2]) casadi_copy(w045, 96, res[2]+1632);
  /* #476: output[2][18] = @47 */
  if (res[2]) casadi_copy(w047, 96, res[2]+1728);
  /* #477: output[2][19] = @49 */
  if (res[2]) casadi_copy(w049, 96, res[2]+1824);
  /* #478: output[2][20] = @51 */
  if (res[2]) casadi_copy(w051, 96, res[2]+1920);
  /* #479: output[2][21] = @53 */
  if (res[2]) casadi_copy(w053, 96, res[2]+2016);
  /* #480: output[2][22] = @55 */
  if (res[2]) casadi_copy(w055, 96, res[2]+2112);
  /* #481: output[2][23] = @57 */
  if (res[2]) casadi_copy(w057, 96, res[2]+2208);
  /* #482: output[2][24] = @59 */
  if (res[2]) casadi_copy(w059, 96, res[2]+2304);
  /* #483: output[2][25] = @61 */
  if (res[2]) casadi_copy(w061, 96, res[2]+2400);
  /* #484: output[2][26] = @63 */
  if (res[2]) casadi_copy(w063, 96, res[2]+2496);
  /* #485: output[2][27] = @65 */
  if (res[2]) casadi_copy(w065, 96, res[2]+2592);
  /* #486: output[2][28] = @67 */
  if (res[2]) casadi_copy(w067, 96, res[2]+2688);
  /* #487: output[2][29] = @69 */
  if (res[2]) casadi_copy(w069, 96, res[2]+2784);
  /* #488: output[2][30] = @71 */
  if (res[2]) casadi_copy(w071, 96, res[2]+2880);
  /* #489: output[2][31] = @73 */
  if (res[2]) casadi_copy(w073, 96, res[2]+2976);
  /* #490: output[2][32] = @75 */
  if (res[2]) casadi_copy(w075, 96, res[2]+3072);
  /* #491: output[2][33] = @77 */
  if (res[2]) casadi_copy(w077, 96, res[2]+3168);
  /* #492: output[2][34] = @79 */
  if (res[2]) casadi_copy(w079, 96, res[2]+3264);
  /* #493: output[2][35] = @81 */
  if (res[2]) casadi_copy(w081, 96, res[2]+3360);
  /* #494: output[2][36] = @83 */
  if (res[2]) casadi_copy(w083, 96, res[2]+3456);
  /* #495: output[2][37] = @85 */
  if (res[2]) casadi_copy(w085, 96, res[2]+3552);
  /* #496: output[2][38] = @87 */
  if (res[2]) casadi_copy(w087, 96, res[2]+3648);
  /* #497: output[2][39] = @89 */
  if (res[2]) casadi_copy(w089, 96, res[2]+3744);
  /* #498: output[2][40] = @91 */
  if (res[2]) casadi_copy(w091, 96, res[2]+3840);
  /* #499: output[2][41] = @93 */
  if (res[2]) casadi_copy(w093, 96, res[2]+3936);
  /* #500: output[2][42] = @95 */
  if (res[2]) casadi_copy(w095, 96, res[2]+4032);
  /* #501: output[2][43] = @97 */
  if (res[2]) casadi_copy(w097, 96, res[2]+4128);
  /* #502: output[2][44] = @99 */
  if (res[2]) casadi_copy(w099, 96, res[2]+4224);
  /* #503: output[2][45] = @101 */
  if (res[2]) casadi_copy(w101, 96, res[2]+4320);
  /* #504: output[2][46] = @103 */
  if (res[2]) casadi_copy(w103, 96, res[2]+4416);
  /* #505: output[2][47] = @105 */
  if (res[2]) casadi_copy(w105, 96, res[2]+4512);
  /* #506: output[2][48] = @107 */
  if (res[2]) casadi_copy(w107, 96, res[2]+4608);
  /* #507: output[2][49] = @109 */
  if (res[2]) casadi_copy(w109, 96, res[2]+4704);
  /* #508: output[2][50] = @111 */
  if (res[2]) casadi_copy(w111, 96, res[2]+4800);
  /* #509: output[2][51] = @113 */
  if (res[2]) casadi_copy(w113, 96, res[2]+4896);
  /* #510: output[2][52] = @115 */
  if (res[2]) casadi_copy(w115, 96, res[2]+4992);
  /* #511: output[2][53] = @117 */
  if (res[2]) casadi_copy(w117, 96, res[2]+5088);
  /* #512: output[2][54] = @119 */
  if (res[2]) casadi_copy(w119, 96, res[2]+5184);
  /* #513: output[2][55] = @121 */
  if (res[2]) casadi_copy(w121, 96, res[2]+5280);
  /* #514: output[2][56] = @123 */
  if (res[2]) casadi_copy(w123, 96, res[2]+5376);
  /* #515: output[2][57] = @125 */
  if (res[2]) casadi_copy(w125, 96, res[2]+5472);
  /* #516: output[2][58] = @127 */
  if (res[2]) casadi_copy(w127, 96, res[2]+5568);
  /* #517: output[2][59] = @129 */
  if (res[2]) casadi_copy(w129, 96, res[2]+5664);
  /* #518: output[2][60] = @131 */
  if (res[2]) casadi_copy(w131, 96, res[2]+5760);
  /* #519: output[2][61] = @133 */
  if (res[2]) casadi_copy(w133, 96, res[2]+5856);
  /* #520: output[2][62] = @135 */
  if (res[2]) casadi_copy(w135, 96, res[2]+5952);
  /* #521: output[2][63] = @137 */
  if (res[2]) casadi_copy(w137, 96, res[2]+6048);
  /* #522: output[2][64] = @139 */
  if (res[2]) casadi_copy(w139, 8, res[2]+6144);
  /* #523: @1 = @5[:6] */
  for (rr=w001, cs=w005+0; cs!=w005+6; cs+=1) *rr++ = *cs;
  /* #524: @3 = landing(@1, @2, @7) */
  arg1[0]=w001;
  arg1[1]=w002;
  arg1[2]=wr007;
  res1[0]=w003;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #525: output[3][0] = @3 */
  casadi_copy(w003, 6, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f46(arg, res, iw, w, mem);
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
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12757;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12757*sizeof(casadi_real);
  return 0;
}

/* wobbling_advance:(t,w[7],h,p[8])->(w_end[7],g[8],dg[8]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, w0, *w1=w+116, w2, *w4=w+123, *w5=w+130, *w6=w+136, *w7=w+144;
  const casadi_real **arg1=arg+4, *cs, *wr3;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 7, w1);
  /* #2: @2 = input[2][0] */
  w2 = arg[2] ? arg[2][0] : 0;
  /* #3: @3 = input[3][0] */
  wr3 = arg[3] ? arg[3] : casadi_zeros;
  /* #4: @4 = working_step(@0, @1, @2, @3) */
  arg1[0]=(&w0);
  arg1[1]=w1;
  arg1[2]=(&w2);
  arg1[3]=wr3;
  res1[0]=w4;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[0][0] = @4 */
  casadi_copy(w4, 7, res[0]);
  /* #6: @0 = (@0+@2) */
  w0 += w2;
  /* #7: @5 = @4[:6] */
  for (rr=w5, cs=w4+0; cs!=w4+6; cs+=1) *rr++ = *cs;
  /* #8: {@6, @7} = observe(@0, @5, @3) */
  arg1[0]=(&w0);
  arg1[1]=w5;
  arg1[2]=wr3;
  res1[0]=w6;
  res1[1]=w7;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #9: output[1][0] = @6 */
  casadi_copy(w6, 8, res[1]);
  /* #10: output[2][0] = @7 */
  casadi_copy(w7, 8, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f47(arg, res, iw, w, mem);
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
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s17;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* wobbling_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s18;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int wobbling_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 152;
  return 0;
}

CASADI_SYMBOL_EXPORT int wobbling_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 152*sizeof(casadi_real);
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
    const double** arg = malloc((size_t) work_size[0] * sizeof(double*));
    double** res = malloc((size_t) work_size[1] * sizeof(double*));
    casadi_int* iw = malloc((size_t) (work_size[2] + 1) * sizeof(casadi_int));
    double* w = malloc((size_t) (work_size[3] + 1) * sizeof(double));
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
