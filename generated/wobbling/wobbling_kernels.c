/* Compass walker with a horizontally wobbling mass: kernels of the solver, printed by CasADi 3.8.2 from equations 8e215572d5eaf0d1.
 * Do not edit: run `make derive`. SPDX-License-Identifier: BSD-3-Clause
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
  a007=sin(a000);
  a008=arg[3]? arg[3][3] : 0;
  a009=arg[0]? arg[0][4] : 0;
  a010=(a008*a009);
  a011=arg[0]? arg[0][1] : 0;
  a012=sin(a011);
  a010=(a010*a012);
  a013=(2.*a003);
  a013=(a013-a009);
  a010=(a010*a013);
  a010=(a007-a010);
  a014=(a000-a011);
  a015=sin(a014);
  a016=(a015-a007);
  a016=(a008*a016);
  a010=(a010-a016);
  a017=1.;
  a018=(2.*a008);
  a019=cos(a011);
  a020=(a019-a017);
  a021=(a018*a020);
  a021=(a017-a021);
  a022=(a010/a021);
  a020=(a008*a020);
  a023=(a020/a021);
  a024=casadi_sq(a003);
  a024=(a024*a012);
  a024=(a024+a015);
  a024=(a008*a024);
  a015=arg[3]? arg[3][5] : 0;
  a025=arg[3]? arg[3][7] : 0;
  a026=arg[3]? arg[3][2] : 0;
  a027=(a025*a026);
  a028=arg[1]? arg[1][0] : 0;
  a029=(a026*a028);
  a030=sin(a029);
  a030=(a027*a030);
  a030=(a009+a030);
  a030=(a015*a030);
  a031=arg[3]? arg[3][4] : 0;
  a032=arg[3]? arg[3][6] : 0;
  a029=cos(a029);
  a029=(a029+a017);
  a029=(a025*a029);
  a029=(a032-a029);
  a029=(a029+a011);
  a029=(a031*a029);
  a030=(a030+a029);
  a024=(a024-a030);
  a030=(a023*a010);
  a030=(a024-a030);
  a029=(a020*a023);
  a029=(a008-a029);
  a033=(a030/a029);
  a034=arg[3]? arg[3][1] : 0;
  a035=cos(a000);
  a036=(a034*a035);
  a037=(a036/a021);
  a020=(a020*a037);
  a038=(a020/a029);
  a010=(a037*a010);
  a039=(a034*a003);
  a039=(a039*a003);
  a039=(a039*a007);
  a040=arg[3]? arg[3][0] : 0;
  a041=arg[0]? arg[0][2] : 0;
  a042=(a040*a041);
  a039=(a039+a042);
  a010=(a010-a039);
  a030=(a038*a030);
  a010=(a010-a030);
  a036=(a036*a037);
  a036=(a034-a036);
  a020=(a020*a038);
  a036=(a036-a020);
  a010=(a010/a036);
  a020=(a038*a010);
  a033=(a033-a020);
  a020=(a023*a033);
  a022=(a022-a020);
  a020=(a037*a010);
  a022=(a022+a020);
  a020=(a006*a022);
  a030=1.7082860872947386e-01;
  a030=(a030*a002);
  a042=2.9587585476806851e-02;
  a042=(a042*a002);
  a043=(a042*a003);
  a044=8.8762756430420545e-02;
  a044=(a044*a002);
  a045=1.9725056984537900e-02;
  a045=(a045*a002);
  a046=(a045*a022);
  a047=5.9175170953613701e-02;
  a047=(a047*a002);
  a048=5.2600151958767730e-02;
  a048=(a048*a002);
  a049=(a048*a003);
  a049=(a000+a049);
  a050=sin(a049);
  a051=(a048*a033);
  a051=(a009+a051);
  a052=(a008*a051);
  a053=(a048*a009);
  a053=(a011+a053);
  a054=sin(a053);
  a052=(a052*a054);
  a055=(a048*a022);
  a055=(a003+a055);
  a056=(2.*a055);
  a056=(a056-a051);
  a052=(a052*a056);
  a052=(a050-a052);
  a057=(a049-a053);
  a058=sin(a057);
  a059=(a058-a050);
  a059=(a008*a059);
  a052=(a052-a059);
  a060=cos(a053);
  a061=(a060-a017);
  a062=(a018*a061);
  a062=(a017-a062);
  a063=(a052/a062);
  a061=(a008*a061);
  a064=(a061/a062);
  a065=casadi_sq(a055);
  a065=(a065*a054);
  a065=(a065+a058);
  a065=(a008*a065);
  a058=(a028+a048);
  a058=(a026*a058);
  a066=sin(a058);
  a066=(a027*a066);
  a066=(a051+a066);
  a066=(a015*a066);
  a058=cos(a058);
  a058=(a058+a017);
  a058=(a025*a058);
  a058=(a032-a058);
  a058=(a058+a053);
  a058=(a031*a058);
  a066=(a066+a058);
  a065=(a065-a066);
  a066=(a064*a052);
  a066=(a065-a066);
  a058=(a061*a064);
  a058=(a008-a058);
  a053=(a066/a058);
  a049=cos(a049);
  a067=(a034*a049);
  a068=(a067/a062);
  a061=(a061*a068);
  a069=(a061/a058);
  a052=(a068*a052);
  a070=(a034*a055);
  a070=(a070*a055);
  a070=(a070*a050);
  a071=arg[0]? arg[0][5] : 0;
  a072=(a048*a071);
  a072=(a041+a072);
  a072=(a040*a072);
  a070=(a070+a072);
  a052=(a052-a070);
  a066=(a069*a066);
  a052=(a052-a066);
  a067=(a067*a068);
  a067=(a034-a067);
  a061=(a061*a069);
  a067=(a067-a061);
  a052=(a052/a067);
  a061=(a069*a052);
  a053=(a053-a061);
  a061=(a064*a053);
  a063=(a063-a061);
  a061=(a068*a052);
  a063=(a063+a061);
  a063=(a047*a063);
  a046=(a046+a063);
  a046=(a003+a046);
  a063=(a044*a046);
  a043=(a043+a063);
  a043=(a000+a043);
  a063=sin(a043);
  a061=(a042*a033);
  a066=casadi_sq(a046);
  a072=(a045*a009);
  a073=(a047*a051);
  a072=(a072+a073);
  a072=(a011+a072);
  a073=sin(a072);
  a066=(a066*a073);
  a074=(a045*a003);
  a075=(a047*a055);
  a074=(a074+a075);
  a074=(a000+a074);
  a075=(a074-a072);
  a076=sin(a075);
  a066=(a066+a076);
  a066=(a008*a066);
  a077=(a045*a033);
  a053=(a047*a053);
  a077=(a077+a053);
  a077=(a009+a077);
  a053=7.8900227938151601e-02;
  a053=(a053*a002);
  a053=(a028+a053);
  a053=(a026*a053);
  a078=sin(a053);
  a078=(a027*a078);
  a078=(a077+a078);
  a078=(a015*a078);
  a053=cos(a053);
  a053=(a053+a017);
  a053=(a025*a053);
  a053=(a032-a053);
  a053=(a053+a072);
  a053=(a031*a053);
  a078=(a078+a053);
  a066=(a066-a078);
  a072=cos(a072);
  a078=(a072-a017);
  a053=(a008*a078);
  a078=(a018*a078);
  a078=(a017-a078);
  a079=(a053/a078);
  a080=sin(a074);
  a081=(a008*a077);
  a081=(a081*a073);
  a082=(2.*a046);
  a082=(a082-a077);
  a081=(a081*a082);
  a081=(a080-a081);
  a076=(a076-a080);
  a076=(a008*a076);
  a081=(a081-a076);
  a083=(a079*a081);
  a083=(a066-a083);
  a084=(a053*a079);
  a084=(a008-a084);
  a085=(a083/a084);
  a074=cos(a074);
  a086=(a034*a074);
  a087=(a086/a078);
  a053=(a053*a087);
  a088=(a053/a084);
  a089=(a087*a081);
  a090=(a034*a046);
  a090=(a090*a046);
  a090=(a090*a080);
  a091=(a045*a071);
  a092=(a048*a010);
  a092=(a071+a092);
  a092=(a047*a092);
  a091=(a091+a092);
  a091=(a041+a091);
  a091=(a040*a091);
  a090=(a090+a091);
  a089=(a089-a090);
  a083=(a088*a083);
  a089=(a089-a083);
  a086=(a086*a087);
  a086=(a034-a086);
  a053=(a053*a088);
  a086=(a086-a053);
  a089=(a089/a086);
  a053=(a088*a089);
  a085=(a085-a053);
  a053=(a044*a085);
  a061=(a061+a053);
  a061=(a009+a061);
  a053=(a008*a061);
  a083=(a042*a009);
  a091=(a044*a077);
  a083=(a083+a091);
  a083=(a011+a083);
  a091=sin(a083);
  a053=(a053*a091);
  a092=(a042*a022);
  a081=(a081/a078);
  a093=(a079*a085);
  a081=(a081-a093);
  a093=(a087*a089);
  a081=(a081+a093);
  a093=(a044*a081);
  a092=(a092+a093);
  a092=(a003+a092);
  a093=(2.*a092);
  a093=(a093-a061);
  a053=(a053*a093);
  a053=(a063-a053);
  a094=(a043-a083);
  a095=sin(a094);
  a096=(a095-a063);
  a096=(a008*a096);
  a053=(a053-a096);
  a097=cos(a083);
  a098=(a097-a017);
  a099=(a018*a098);
  a099=(a017-a099);
  a100=(a053/a099);
  a098=(a008*a098);
  a101=(a098/a099);
  a102=casadi_sq(a092);
  a102=(a102*a091);
  a102=(a102+a095);
  a102=(a008*a102);
  a095=1.1835034190722740e-01;
  a095=(a095*a002);
  a095=(a028+a095);
  a095=(a026*a095);
  a103=sin(a095);
  a103=(a027*a103);
  a103=(a061+a103);
  a103=(a015*a103);
  a095=cos(a095);
  a095=(a095+a017);
  a095=(a025*a095);
  a095=(a032-a095);
  a095=(a095+a083);
  a095=(a031*a095);
  a103=(a103+a095);
  a102=(a102-a103);
  a103=(a101*a053);
  a103=(a102-a103);
  a095=(a098*a101);
  a095=(a008-a095);
  a083=(a103/a095);
  a043=cos(a043);
  a104=(a034*a043);
  a105=(a104/a099);
  a098=(a098*a105);
  a106=(a098/a095);
  a053=(a105*a053);
  a107=(a034*a092);
  a107=(a107*a092);
  a107=(a107*a063);
  a108=(a042*a071);
  a109=(a045*a010);
  a052=(a047*a052);
  a109=(a109+a052);
  a109=(a071+a109);
  a052=(a044*a109);
  a108=(a108+a052);
  a108=(a041+a108);
  a108=(a040*a108);
  a107=(a107+a108);
  a053=(a053-a107);
  a103=(a106*a103);
  a053=(a053-a103);
  a104=(a104*a105);
  a104=(a034-a104);
  a098=(a098*a106);
  a104=(a104-a098);
  a053=(a053/a104);
  a098=(a106*a053);
  a083=(a083-a098);
  a098=(a101*a083);
  a100=(a100-a098);
  a098=(a105*a053);
  a100=(a100+a098);
  a098=(a030*a100);
  a020=(a020+a098);
  a098=1.2546768756682242e-01;
  a098=(a098*a002);
  a103=2.4136513415926669e-01;
  a103=(a103*a002);
  a108=(a103*a003);
  a052=-8.8454947932828609e-01;
  a052=(a052*a002);
  a110=(a052*a046);
  a108=(a108+a110);
  a110=9.2483400326179199e-01;
  a110=(a110*a002);
  a111=(a110*a092);
  a108=(a108+a111);
  a108=(a000+a108);
  a111=sin(a108);
  a112=(a103*a033);
  a085=(a052*a085);
  a112=(a112+a085);
  a085=(a110*a083);
  a112=(a112+a085);
  a112=(a009+a112);
  a085=(a008*a112);
  a113=(a103*a009);
  a114=(a052*a077);
  a113=(a113+a114);
  a114=(a110*a061);
  a113=(a113+a114);
  a113=(a011+a113);
  a114=sin(a113);
  a085=(a085*a114);
  a115=(a103*a022);
  a081=(a052*a081);
  a115=(a115+a081);
  a081=(a110*a100);
  a115=(a115+a081);
  a115=(a003+a115);
  a081=(2.*a115);
  a081=(a081-a112);
  a085=(a085*a081);
  a085=(a111-a085);
  a116=(a108-a113);
  a117=sin(a116);
  a118=(a117-a111);
  a118=(a008*a118);
  a085=(a085-a118);
  a119=cos(a113);
  a120=(a119-a017);
  a121=(a018*a120);
  a121=(a017-a121);
  a122=(a085/a121);
  a120=(a008*a120);
  a123=(a120/a121);
  a124=casadi_sq(a115);
  a124=(a124*a114);
  a124=(a124+a117);
  a124=(a008*a124);
  a117=2.8164965809277259e-01;
  a117=(a117*a002);
  a117=(a028+a117);
  a117=(a026*a117);
  a125=sin(a117);
  a125=(a027*a125);
  a125=(a112+a125);
  a125=(a015*a125);
  a117=cos(a117);
  a117=(a117+a017);
  a117=(a025*a117);
  a117=(a032-a117);
  a117=(a117+a113);
  a117=(a031*a117);
  a125=(a125+a117);
  a124=(a124-a125);
  a125=(a123*a085);
  a125=(a124-a125);
  a117=(a120*a123);
  a117=(a008-a117);
  a113=(a125/a117);
  a108=cos(a108);
  a126=(a034*a108);
  a127=(a126/a121);
  a120=(a120*a127);
  a128=(a120/a117);
  a085=(a127*a085);
  a129=(a034*a115);
  a129=(a129*a115);
  a129=(a129*a111);
  a130=(a103*a071);
  a109=(a052*a109);
  a130=(a130+a109);
  a109=(a042*a010);
  a131=(a044*a089);
  a109=(a109+a131);
  a109=(a071+a109);
  a131=(a110*a109);
  a130=(a130+a131);
  a130=(a041+a130);
  a130=(a040*a130);
  a129=(a129+a130);
  a085=(a085-a129);
  a125=(a128*a125);
  a085=(a085-a125);
  a126=(a126*a127);
  a126=(a034-a126);
  a120=(a120*a128);
  a126=(a126-a120);
  a085=(a085/a126);
  a120=(a128*a085);
  a113=(a113-a120);
  a120=(a123*a113);
  a122=(a122-a120);
  a120=(a127*a085);
  a122=(a122+a120);
  a120=(a098*a122);
  a020=(a020+a120);
  a020=(a003+a020);
  a120=(a005*a020);
  a004=(a004+a120);
  a120=1.8915178993145003e+00;
  a120=(a120*a002);
  a125=3.7109375000000000e-02;
  a125=(a125*a002);
  a130=(a125*a022);
  a131=1.7025221101954405e-01;
  a131=(a131*a002);
  a132=(a131*a100);
  a130=(a130+a132);
  a132=6.0216538980455959e-02;
  a132=(a132*a002);
  a133=(a132*a122);
  a130=(a130+a133);
  a133=-1.7578125000000000e-02;
  a133=(a133*a002);
  a134=(a006*a003);
  a135=(a030*a092);
  a134=(a134+a135);
  a135=(a098*a115);
  a134=(a134+a135);
  a134=(a000+a134);
  a135=sin(a134);
  a136=(a006*a033);
  a137=(a030*a083);
  a136=(a136+a137);
  a137=(a098*a113);
  a136=(a136+a137);
  a136=(a009+a136);
  a137=(a008*a136);
  a138=(a006*a009);
  a139=(a030*a061);
  a138=(a138+a139);
  a139=(a098*a112);
  a138=(a138+a139);
  a138=(a011+a138);
  a139=sin(a138);
  a137=(a137*a139);
  a140=(2.*a020);
  a140=(a140-a136);
  a137=(a137*a140);
  a137=(a135-a137);
  a141=(a134-a138);
  a142=sin(a141);
  a143=(a142-a135);
  a143=(a008*a143);
  a137=(a137-a143);
  a144=cos(a138);
  a145=(a144-a017);
  a146=(a018*a145);
  a146=(a017-a146);
  a147=(a137/a146);
  a145=(a008*a145);
  a148=(a145/a146);
  a149=casadi_sq(a020);
  a149=(a149*a139);
  a149=(a149+a142);
  a149=(a008*a149);
  a142=3.3333333333333331e-01;
  a142=(a142*a002);
  a142=(a028+a142);
  a142=(a026*a142);
  a150=sin(a142);
  a150=(a027*a150);
  a150=(a136+a150);
  a150=(a015*a150);
  a142=cos(a142);
  a142=(a142+a017);
  a142=(a025*a142);
  a142=(a032-a142);
  a142=(a142+a138);
  a142=(a031*a142);
  a150=(a150+a142);
  a149=(a149-a150);
  a150=(a148*a137);
  a150=(a149-a150);
  a142=(a145*a148);
  a142=(a008-a142);
  a138=(a150/a142);
  a134=cos(a134);
  a151=(a034*a134);
  a152=(a151/a146);
  a145=(a145*a152);
  a153=(a145/a142);
  a137=(a152*a137);
  a154=(a034*a020);
  a154=(a154*a020);
  a154=(a154*a135);
  a155=(a006*a071);
  a156=(a030*a109);
  a155=(a155+a156);
  a156=(a103*a010);
  a089=(a052*a089);
  a156=(a156+a089);
  a089=(a110*a053);
  a156=(a156+a089);
  a156=(a071+a156);
  a089=(a098*a156);
  a155=(a155+a089);
  a155=(a041+a155);
  a155=(a040*a155);
  a154=(a154+a155);
  a137=(a137-a154);
  a150=(a153*a150);
  a137=(a137-a150);
  a151=(a151*a152);
  a151=(a034-a151);
  a145=(a145*a153);
  a151=(a151-a145);
  a137=(a137/a151);
  a145=(a153*a137);
  a138=(a138-a145);
  a145=(a148*a138);
  a147=(a147-a145);
  a145=(a152*a137);
  a147=(a147+a145);
  a145=(a133*a147);
  a130=(a130+a145);
  a130=(a003+a130);
  a145=(a120*a130);
  a004=(a004+a145);
  a145=-5.8012039600105849e+00;
  a145=(a145*a002);
  a150=3.7092000118504789e-02;
  a150=(a150*a002);
  a155=(a150*a022);
  a089=1.7038392571223998e-01;
  a089=(a089*a002);
  a157=(a089*a100);
  a155=(a155+a157);
  a157=1.0726203044637328e-01;
  a157=(a157*a002);
  a158=(a157*a122);
  a155=(a155+a158);
  a158=-1.5319437748624402e-02;
  a158=(a158*a002);
  a159=(a158*a147);
  a155=(a155+a159);
  a159=8.2737891638140233e-03;
  a159=(a159*a002);
  a160=(a125*a003);
  a161=(a131*a092);
  a160=(a160+a161);
  a161=(a132*a115);
  a160=(a160+a161);
  a161=(a133*a020);
  a160=(a160+a161);
  a160=(a000+a160);
  a161=sin(a160);
  a162=(a125*a033);
  a163=(a131*a083);
  a162=(a162+a163);
  a163=(a132*a113);
  a162=(a162+a163);
  a163=(a133*a138);
  a162=(a162+a163);
  a162=(a009+a162);
  a163=(a008*a162);
  a164=(a125*a009);
  a165=(a131*a061);
  a164=(a164+a165);
  a165=(a132*a112);
  a164=(a164+a165);
  a165=(a133*a136);
  a164=(a164+a165);
  a164=(a011+a164);
  a165=sin(a164);
  a163=(a163*a165);
  a166=(2.*a130);
  a166=(a166-a162);
  a163=(a163*a166);
  a163=(a161-a163);
  a167=(a160-a164);
  a168=sin(a167);
  a169=(a168-a161);
  a169=(a008*a169);
  a163=(a163-a169);
  a170=cos(a164);
  a171=(a170-a017);
  a172=(a018*a171);
  a172=(a017-a172);
  a173=(a163/a172);
  a171=(a008*a171);
  a174=(a171/a172);
  a175=casadi_sq(a130);
  a175=(a175*a165);
  a175=(a175+a168);
  a175=(a008*a175);
  a168=2.5000000000000000e-01;
  a168=(a168*a002);
  a168=(a028+a168);
  a168=(a026*a168);
  a176=sin(a168);
  a176=(a027*a176);
  a176=(a162+a176);
  a176=(a015*a176);
  a168=cos(a168);
  a168=(a168+a017);
  a168=(a025*a168);
  a168=(a032-a168);
  a168=(a168+a164);
  a168=(a031*a168);
  a176=(a176+a168);
  a175=(a175-a176);
  a176=(a174*a163);
  a176=(a175-a176);
  a168=(a171*a174);
  a168=(a008-a168);
  a164=(a176/a168);
  a160=cos(a160);
  a177=(a034*a160);
  a178=(a177/a172);
  a171=(a171*a178);
  a179=(a171/a168);
  a163=(a178*a163);
  a180=(a034*a130);
  a180=(a180*a130);
  a180=(a180*a161);
  a181=(a125*a071);
  a182=(a131*a109);
  a181=(a181+a182);
  a182=(a132*a156);
  a181=(a181+a182);
  a182=(a006*a010);
  a183=(a030*a053);
  a182=(a182+a183);
  a183=(a098*a085);
  a182=(a182+a183);
  a182=(a071+a182);
  a183=(a133*a182);
  a181=(a181+a183);
  a181=(a041+a181);
  a181=(a040*a181);
  a180=(a180+a181);
  a163=(a163-a180);
  a176=(a179*a176);
  a163=(a163-a176);
  a177=(a177*a178);
  a177=(a034-a177);
  a171=(a171*a179);
  a177=(a177-a171);
  a163=(a163/a177);
  a171=(a179*a163);
  a164=(a164-a171);
  a171=(a174*a164);
  a173=(a173-a171);
  a171=(a178*a163);
  a173=(a173+a171);
  a171=(a159*a173);
  a155=(a155+a171);
  a155=(a003+a155);
  a171=(a145*a155);
  a004=(a004+a171);
  a171=3.1116436695781990e-01;
  a171=(a171*a002);
  a176=6.2411095871607569e-01;
  a176=(a176*a002);
  a181=(a176*a022);
  a183=-3.3608926294469414e+00;
  a183=(a183*a002);
  a184=(a183*a100);
  a181=(a181+a184);
  a184=-8.6821934684172597e-01;
  a184=(a184*a002);
  a185=(a184*a122);
  a181=(a181+a185);
  a185=2.7592099699446710e+01;
  a185=(a185*a002);
  a186=(a185*a147);
  a181=(a181+a186);
  a186=2.0154067550477894e+01;
  a186=(a186*a002);
  a187=(a186*a173);
  a181=(a181+a187);
  a187=-4.3489884181069961e+01;
  a187=(a187*a002);
  a188=(a150*a003);
  a189=(a089*a092);
  a188=(a188+a189);
  a189=(a157*a115);
  a188=(a188+a189);
  a189=(a158*a020);
  a188=(a188+a189);
  a189=(a159*a130);
  a188=(a188+a189);
  a188=(a000+a188);
  a189=sin(a188);
  a190=(a150*a033);
  a191=(a089*a083);
  a190=(a190+a191);
  a191=(a157*a113);
  a190=(a190+a191);
  a191=(a158*a138);
  a190=(a190+a191);
  a191=(a159*a164);
  a190=(a190+a191);
  a190=(a009+a190);
  a191=(a008*a190);
  a192=(a150*a009);
  a193=(a089*a061);
  a192=(a192+a193);
  a193=(a157*a112);
  a192=(a192+a193);
  a193=(a158*a136);
  a192=(a192+a193);
  a193=(a159*a162);
  a192=(a192+a193);
  a192=(a011+a192);
  a193=sin(a192);
  a191=(a191*a193);
  a194=(2.*a155);
  a194=(a194-a190);
  a191=(a191*a194);
  a191=(a189-a191);
  a195=(a188-a192);
  a196=sin(a195);
  a197=(a196-a189);
  a197=(a008*a197);
  a191=(a191-a197);
  a198=cos(a192);
  a199=(a198-a017);
  a200=(a018*a199);
  a200=(a017-a200);
  a201=(a191/a200);
  a199=(a008*a199);
  a202=(a199/a200);
  a203=casadi_sq(a155);
  a203=(a203*a193);
  a203=(a203+a196);
  a203=(a008*a203);
  a196=3.0769230769230771e-01;
  a196=(a196*a002);
  a196=(a028+a196);
  a196=(a026*a196);
  a204=sin(a196);
  a204=(a027*a204);
  a204=(a190+a204);
  a204=(a015*a204);
  a196=cos(a196);
  a196=(a196+a017);
  a196=(a025*a196);
  a196=(a032-a196);
  a196=(a196+a192);
  a196=(a031*a196);
  a204=(a204+a196);
  a203=(a203-a204);
  a204=(a202*a191);
  a204=(a203-a204);
  a196=(a199*a202);
  a196=(a008-a196);
  a192=(a204/a196);
  a188=cos(a188);
  a205=(a034*a188);
  a206=(a205/a200);
  a199=(a199*a206);
  a207=(a199/a196);
  a191=(a206*a191);
  a208=(a034*a155);
  a208=(a208*a155);
  a208=(a208*a189);
  a209=(a150*a071);
  a210=(a089*a109);
  a209=(a209+a210);
  a210=(a157*a156);
  a209=(a209+a210);
  a210=(a158*a182);
  a209=(a209+a210);
  a210=(a125*a010);
  a211=(a131*a053);
  a210=(a210+a211);
  a211=(a132*a085);
  a210=(a210+a211);
  a211=(a133*a137);
  a210=(a210+a211);
  a210=(a071+a210);
  a211=(a159*a210);
  a209=(a209+a211);
  a209=(a041+a209);
  a209=(a040*a209);
  a208=(a208+a209);
  a191=(a191-a208);
  a204=(a207*a204);
  a191=(a191-a204);
  a205=(a205*a206);
  a205=(a034-a205);
  a199=(a199*a207);
  a205=(a205-a199);
  a191=(a191/a205);
  a199=(a207*a191);
  a192=(a192-a199);
  a199=(a202*a192);
  a201=(a201-a199);
  a199=(a206*a191);
  a201=(a201+a199);
  a199=(a187*a201);
  a181=(a181+a199);
  a181=(a003+a181);
  a199=(a171*a181);
  a004=(a004+a199);
  a199=-1.5216094966251609e-01;
  a199=(a199*a002);
  a204=4.7766253643826434e-01;
  a204=(a204*a002);
  a209=(a204*a022);
  a211=-2.4881146199716677e+00;
  a211=(a211*a002);
  a212=(a211*a100);
  a209=(a209+a212);
  a212=-5.9029082683684297e-01;
  a212=(a212*a002);
  a213=(a212*a122);
  a209=(a209+a213);
  a213=2.1230051448181193e+01;
  a213=(a213*a002);
  a214=(a213*a147);
  a209=(a209+a214);
  a214=1.5279233632882423e+01;
  a214=(a214*a002);
  a215=(a214*a173);
  a209=(a209+a215);
  a215=-3.3288210968984863e+01;
  a215=(a215*a002);
  a216=(a215*a201);
  a209=(a209+a216);
  a216=-2.0331201708508627e-02;
  a216=(a216*a002);
  a217=(a176*a003);
  a218=(a183*a092);
  a217=(a217+a218);
  a218=(a184*a115);
  a217=(a217+a218);
  a218=(a185*a020);
  a217=(a217+a218);
  a218=(a186*a130);
  a217=(a217+a218);
  a218=(a187*a155);
  a217=(a217+a218);
  a217=(a000+a217);
  a218=sin(a217);
  a219=(a176*a033);
  a220=(a183*a083);
  a219=(a219+a220);
  a220=(a184*a113);
  a219=(a219+a220);
  a220=(a185*a138);
  a219=(a219+a220);
  a220=(a186*a164);
  a219=(a219+a220);
  a220=(a187*a192);
  a219=(a219+a220);
  a219=(a009+a219);
  a220=(a008*a219);
  a221=(a176*a009);
  a222=(a183*a061);
  a221=(a221+a222);
  a222=(a184*a112);
  a221=(a221+a222);
  a222=(a185*a136);
  a221=(a221+a222);
  a222=(a186*a162);
  a221=(a221+a222);
  a222=(a187*a190);
  a221=(a221+a222);
  a221=(a011+a221);
  a222=sin(a221);
  a220=(a220*a222);
  a223=(2.*a181);
  a223=(a223-a219);
  a220=(a220*a223);
  a220=(a218-a220);
  a224=(a217-a221);
  a225=sin(a224);
  a226=(a225-a218);
  a226=(a008*a226);
  a220=(a220-a226);
  a227=cos(a221);
  a228=(a227-a017);
  a229=(a018*a228);
  a229=(a017-a229);
  a230=(a220/a229);
  a228=(a008*a228);
  a231=(a228/a229);
  a232=casadi_sq(a181);
  a232=(a232*a222);
  a232=(a232+a225);
  a232=(a008*a232);
  a225=6.5128205128205130e-01;
  a225=(a225*a002);
  a225=(a028+a225);
  a225=(a026*a225);
  a233=sin(a225);
  a233=(a027*a233);
  a233=(a219+a233);
  a233=(a015*a233);
  a225=cos(a225);
  a225=(a225+a017);
  a225=(a025*a225);
  a225=(a032-a225);
  a225=(a225+a221);
  a225=(a031*a225);
  a233=(a233+a225);
  a232=(a232-a233);
  a233=(a231*a220);
  a233=(a232-a233);
  a225=(a228*a231);
  a225=(a008-a225);
  a221=(a233/a225);
  a217=cos(a217);
  a234=(a034*a217);
  a235=(a234/a229);
  a228=(a228*a235);
  a236=(a228/a225);
  a220=(a235*a220);
  a237=(a034*a181);
  a237=(a237*a181);
  a237=(a237*a218);
  a238=(a176*a071);
  a239=(a183*a109);
  a238=(a238+a239);
  a239=(a184*a156);
  a238=(a238+a239);
  a239=(a185*a182);
  a238=(a238+a239);
  a239=(a186*a210);
  a238=(a238+a239);
  a239=(a150*a010);
  a240=(a089*a053);
  a239=(a239+a240);
  a240=(a157*a085);
  a239=(a239+a240);
  a240=(a158*a137);
  a239=(a239+a240);
  a240=(a159*a163);
  a239=(a239+a240);
  a239=(a071+a239);
  a240=(a187*a239);
  a238=(a238+a240);
  a238=(a041+a238);
  a238=(a040*a238);
  a237=(a237+a238);
  a220=(a220-a237);
  a233=(a236*a233);
  a220=(a220-a233);
  a234=(a234*a235);
  a234=(a034-a234);
  a228=(a228*a236);
  a234=(a234-a228);
  a220=(a220/a234);
  a228=(a236*a220);
  a221=(a221-a228);
  a228=(a231*a221);
  a230=(a230-a228);
  a228=(a235*a220);
  a230=(a230+a228);
  a228=(a216*a230);
  a209=(a209+a228);
  a209=(a003+a209);
  a228=(a199*a209);
  a004=(a004+a228);
  a228=2.0136540080403034e-01;
  a228=(a228*a002);
  a233=-9.3714243008598730e-01;
  a233=(a233*a002);
  a238=(a233*a022);
  a240=5.1863724288440638e+00;
  a240=(a240*a002);
  a241=(a240*a100);
  a238=(a238+a241);
  a241=1.0914373489967295e+00;
  a241=(a241*a002);
  a242=(a241*a122);
  a238=(a238+a242);
  a242=-8.1497870107469268e+00;
  a242=(a242*a002);
  a243=(a242*a147);
  a238=(a238+a243);
  a243=-1.8520065659996959e+01;
  a243=(a243*a002);
  a244=(a243*a173);
  a238=(a238+a244);
  a244=2.2739487099350505e+01;
  a244=(a244*a002);
  a245=(a244*a201);
  a238=(a238+a245);
  a245=2.4936055526796523e+00;
  a245=(a245*a002);
  a246=(a245*a230);
  a238=(a238+a246);
  a246=-3.0467644718982196e+00;
  a246=(a246*a002);
  a247=(a204*a003);
  a248=(a211*a092);
  a247=(a247+a248);
  a248=(a212*a115);
  a247=(a247+a248);
  a248=(a213*a020);
  a247=(a247+a248);
  a248=(a214*a130);
  a247=(a247+a248);
  a248=(a215*a155);
  a247=(a247+a248);
  a248=(a216*a181);
  a247=(a247+a248);
  a247=(a000+a247);
  a248=sin(a247);
  a249=(a204*a033);
  a250=(a211*a083);
  a249=(a249+a250);
  a250=(a212*a113);
  a249=(a249+a250);
  a250=(a213*a138);
  a249=(a249+a250);
  a250=(a214*a164);
  a249=(a249+a250);
  a250=(a215*a192);
  a249=(a249+a250);
  a250=(a216*a221);
  a249=(a249+a250);
  a249=(a009+a249);
  a250=(a008*a249);
  a251=(a204*a009);
  a252=(a211*a061);
  a251=(a251+a252);
  a252=(a212*a112);
  a251=(a251+a252);
  a252=(a213*a136);
  a251=(a251+a252);
  a252=(a214*a162);
  a251=(a251+a252);
  a252=(a215*a190);
  a251=(a251+a252);
  a252=(a216*a219);
  a251=(a251+a252);
  a251=(a011+a251);
  a252=sin(a251);
  a250=(a250*a252);
  a253=(2.*a209);
  a253=(a253-a249);
  a250=(a250*a253);
  a250=(a248-a250);
  a254=(a247-a251);
  a255=sin(a254);
  a256=(a255-a248);
  a256=(a008*a256);
  a250=(a250-a256);
  a257=cos(a251);
  a258=(a257-a017);
  a259=(a018*a258);
  a259=(a017-a259);
  a260=(a250/a259);
  a258=(a008*a258);
  a261=(a258/a259);
  a262=casadi_sq(a209);
  a262=(a262*a252);
  a262=(a262+a255);
  a262=(a008*a262);
  a255=5.9999999999999998e-01;
  a255=(a255*a002);
  a255=(a028+a255);
  a255=(a026*a255);
  a263=sin(a255);
  a263=(a027*a263);
  a263=(a249+a263);
  a263=(a015*a263);
  a255=cos(a255);
  a255=(a255+a017);
  a255=(a025*a255);
  a255=(a032-a255);
  a255=(a255+a251);
  a255=(a031*a255);
  a263=(a263+a255);
  a262=(a262-a263);
  a263=(a261*a250);
  a263=(a262-a263);
  a255=(a258*a261);
  a255=(a008-a255);
  a251=(a263/a255);
  a247=cos(a247);
  a264=(a034*a247);
  a265=(a264/a259);
  a258=(a258*a265);
  a266=(a258/a255);
  a250=(a265*a250);
  a267=(a034*a209);
  a267=(a267*a209);
  a267=(a267*a248);
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
  a269=(a176*a010);
  a270=(a183*a053);
  a269=(a269+a270);
  a270=(a184*a085);
  a269=(a269+a270);
  a270=(a185*a137);
  a269=(a269+a270);
  a270=(a186*a163);
  a269=(a269+a270);
  a270=(a187*a191);
  a269=(a269+a270);
  a269=(a071+a269);
  a270=(a216*a269);
  a268=(a268+a270);
  a268=(a041+a268);
  a268=(a040*a268);
  a267=(a267+a268);
  a250=(a250-a267);
  a263=(a266*a263);
  a250=(a250-a263);
  a264=(a264*a265);
  a264=(a034-a264);
  a258=(a258*a266);
  a264=(a264-a258);
  a250=(a250/a264);
  a258=(a266*a250);
  a251=(a251-a258);
  a258=(a261*a251);
  a260=(a260-a258);
  a258=(a265*a250);
  a260=(a260+a258);
  a258=(a246*a260);
  a238=(a238+a258);
  a238=(a003+a238);
  a258=(a228*a238);
  a004=(a004+a258);
  a258=4.4710615727772587e-02;
  a258=(a258*a002);
  a263=2.2733101475165380e+00;
  a263=(a263*a002);
  a268=(a263*a022);
  a270=-1.0534495466737249e+01;
  a270=(a270*a002);
  a100=(a270*a100);
  a268=(a268+a100);
  a100=-2.0008720582248625e+00;
  a100=(a100*a002);
  a122=(a100*a122);
  a268=(a268+a122);
  a122=-1.7958931863118799e+01;
  a122=(a122*a002);
  a271=(a122*a147);
  a268=(a268+a271);
  a271=2.7948884529419960e+01;
  a271=(a271*a002);
  a272=(a271*a173);
  a268=(a268+a272);
  a272=-2.8589982771350235e+00;
  a272=(a272*a002);
  a273=(a272*a201);
  a268=(a268+a273);
  a273=-8.8728569335306293e+00;
  a273=(a273*a002);
  a274=(a273*a230);
  a268=(a268+a274);
  a274=1.2360567175794303e+01;
  a274=(a274*a002);
  a275=(a274*a260);
  a268=(a268+a275);
  a275=6.4339274601576357e-01;
  a275=(a275*a002);
  a276=(a233*a003);
  a277=(a240*a092);
  a276=(a276+a277);
  a277=(a241*a115);
  a276=(a276+a277);
  a277=(a242*a020);
  a276=(a276+a277);
  a277=(a243*a130);
  a276=(a276+a277);
  a277=(a244*a155);
  a276=(a276+a277);
  a277=(a245*a181);
  a276=(a276+a277);
  a277=(a246*a209);
  a276=(a276+a277);
  a276=(a000+a276);
  a277=sin(a276);
  a278=(a233*a033);
  a279=(a240*a083);
  a278=(a278+a279);
  a279=(a241*a113);
  a278=(a278+a279);
  a279=(a242*a138);
  a278=(a278+a279);
  a279=(a243*a164);
  a278=(a278+a279);
  a279=(a244*a192);
  a278=(a278+a279);
  a279=(a245*a221);
  a278=(a278+a279);
  a279=(a246*a251);
  a278=(a278+a279);
  a278=(a009+a278);
  a279=(a008*a278);
  a280=(a233*a009);
  a281=(a240*a061);
  a280=(a280+a281);
  a281=(a241*a112);
  a280=(a280+a281);
  a281=(a242*a136);
  a280=(a280+a281);
  a281=(a243*a162);
  a280=(a280+a281);
  a281=(a244*a190);
  a280=(a280+a281);
  a281=(a245*a219);
  a280=(a280+a281);
  a281=(a246*a249);
  a280=(a280+a281);
  a280=(a011+a280);
  a281=sin(a280);
  a279=(a279*a281);
  a282=(2.*a238);
  a282=(a282-a278);
  a279=(a279*a282);
  a279=(a277-a279);
  a283=(a276-a280);
  a284=sin(a283);
  a285=(a284-a277);
  a285=(a008*a285);
  a279=(a279-a285);
  a286=cos(a280);
  a287=(a286-a017);
  a288=(a018*a287);
  a288=(a017-a288);
  a289=(a279/a288);
  a287=(a008*a287);
  a290=(a287/a288);
  a291=casadi_sq(a238);
  a291=(a291*a281);
  a291=(a291+a284);
  a291=(a008*a291);
  a284=8.5714285714285710e-01;
  a284=(a284*a002);
  a284=(a028+a284);
  a284=(a026*a284);
  a292=sin(a284);
  a292=(a027*a292);
  a292=(a278+a292);
  a292=(a015*a292);
  a284=cos(a284);
  a284=(a284+a017);
  a284=(a025*a284);
  a284=(a032-a284);
  a284=(a284+a280);
  a284=(a031*a284);
  a292=(a292+a284);
  a291=(a291-a292);
  a292=(a290*a279);
  a292=(a291-a292);
  a284=(a287*a290);
  a284=(a008-a284);
  a280=(a292/a284);
  a276=cos(a276);
  a293=(a034*a276);
  a294=(a293/a288);
  a287=(a287*a294);
  a295=(a287/a284);
  a279=(a294*a279);
  a296=(a034*a238);
  a296=(a296*a238);
  a296=(a296*a277);
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
  a298=(a204*a010);
  a299=(a211*a053);
  a298=(a298+a299);
  a299=(a212*a085);
  a298=(a298+a299);
  a299=(a213*a137);
  a298=(a298+a299);
  a299=(a214*a163);
  a298=(a298+a299);
  a299=(a215*a191);
  a298=(a298+a299);
  a299=(a216*a220);
  a298=(a298+a299);
  a298=(a071+a298);
  a299=(a246*a298);
  a297=(a297+a299);
  a297=(a041+a297);
  a297=(a040*a297);
  a296=(a296+a297);
  a279=(a279-a296);
  a292=(a295*a292);
  a279=(a279-a292);
  a293=(a293*a294);
  a293=(a034-a293);
  a287=(a287*a295);
  a293=(a293-a287);
  a279=(a279/a293);
  a287=(a295*a279);
  a280=(a280-a287);
  a287=(a290*a280);
  a289=(a289-a287);
  a287=(a294*a279);
  a289=(a289+a287);
  a287=(a275*a289);
  a268=(a268+a287);
  a268=(a003+a268);
  a287=(a258*a268);
  a004=(a004+a287);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a009);
  a287=(a005*a136);
  a004=(a004+a287);
  a287=(a120*a162);
  a004=(a004+a287);
  a287=(a145*a190);
  a004=(a004+a287);
  a287=(a171*a219);
  a004=(a004+a287);
  a287=(a199*a249);
  a004=(a004+a287);
  a287=(a228*a278);
  a004=(a004+a287);
  a287=(a263*a033);
  a083=(a270*a083);
  a287=(a287+a083);
  a113=(a100*a113);
  a287=(a287+a113);
  a113=(a122*a138);
  a287=(a287+a113);
  a113=(a271*a164);
  a287=(a287+a113);
  a113=(a272*a192);
  a287=(a287+a113);
  a113=(a273*a221);
  a287=(a287+a113);
  a113=(a274*a251);
  a287=(a287+a113);
  a113=(a275*a280);
  a287=(a287+a113);
  a287=(a009+a287);
  a113=(a258*a287);
  a004=(a004+a113);
  a004=(a011+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a071);
  a113=(a005*a182);
  a004=(a004+a113);
  a113=(a120*a210);
  a004=(a004+a113);
  a113=(a145*a239);
  a004=(a004+a113);
  a113=(a171*a269);
  a004=(a004+a113);
  a113=(a199*a298);
  a004=(a004+a113);
  a113=(a233*a010);
  a083=(a240*a053);
  a113=(a113+a083);
  a083=(a241*a085);
  a113=(a113+a083);
  a083=(a242*a137);
  a113=(a113+a083);
  a083=(a243*a163);
  a113=(a113+a083);
  a083=(a244*a191);
  a113=(a113+a083);
  a083=(a245*a220);
  a113=(a113+a083);
  a083=(a246*a250);
  a113=(a113+a083);
  a113=(a071+a113);
  a083=(a228*a113);
  a004=(a004+a083);
  a083=(a263*a010);
  a053=(a270*a053);
  a083=(a083+a053);
  a085=(a100*a085);
  a083=(a083+a085);
  a085=(a122*a137);
  a083=(a083+a085);
  a085=(a271*a163);
  a083=(a083+a085);
  a085=(a272*a191);
  a083=(a083+a085);
  a085=(a273*a220);
  a083=(a083+a085);
  a085=(a274*a250);
  a083=(a083+a085);
  a085=(a275*a279);
  a083=(a083+a085);
  a083=(a071+a083);
  a083=(a258*a083);
  a004=(a004+a083);
  a004=(a041+a004);
  if (res[0]!=0) res[0][2]=a004;
  a022=(a001*a022);
  a147=(a005*a147);
  a022=(a022+a147);
  a173=(a120*a173);
  a022=(a022+a173);
  a201=(a145*a201);
  a022=(a022+a201);
  a230=(a171*a230);
  a022=(a022+a230);
  a260=(a199*a260);
  a022=(a022+a260);
  a289=(a228*a289);
  a022=(a022+a289);
  a289=(a263*a003);
  a260=(a270*a092);
  a289=(a289+a260);
  a260=(a100*a115);
  a289=(a289+a260);
  a260=(a122*a020);
  a289=(a289+a260);
  a260=(a271*a130);
  a289=(a289+a260);
  a260=(a272*a155);
  a289=(a289+a260);
  a260=(a273*a181);
  a289=(a289+a260);
  a260=(a274*a209);
  a289=(a289+a260);
  a260=(a275*a238);
  a289=(a289+a260);
  a000=(a000+a289);
  a289=sin(a000);
  a260=(a008*a287);
  a230=(a263*a009);
  a201=(a270*a061);
  a230=(a230+a201);
  a201=(a100*a112);
  a230=(a230+a201);
  a201=(a122*a136);
  a230=(a230+a201);
  a201=(a271*a162);
  a230=(a230+a201);
  a201=(a272*a190);
  a230=(a230+a201);
  a201=(a273*a219);
  a230=(a230+a201);
  a201=(a274*a249);
  a230=(a230+a201);
  a201=(a275*a278);
  a230=(a230+a201);
  a011=(a011+a230);
  a230=sin(a011);
  a260=(a260*a230);
  a201=(2.*a268);
  a201=(a201-a287);
  a260=(a260*a201);
  a260=(a289-a260);
  a173=(a000-a011);
  a147=sin(a173);
  a004=(a147-a289);
  a004=(a008*a004);
  a260=(a260-a004);
  a083=cos(a011);
  a085=(a083-a017);
  a053=(a018*a085);
  a053=(a017-a053);
  a292=(a260/a053);
  a085=(a008*a085);
  a297=(a085/a053);
  a299=casadi_sq(a268);
  a299=(a299*a230);
  a299=(a299+a147);
  a299=(a008*a299);
  a028=(a028+a002);
  a026=(a026*a028);
  a028=sin(a026);
  a027=(a027*a028);
  a027=(a287+a027);
  a027=(a015*a027);
  a026=cos(a026);
  a026=(a026+a017);
  a025=(a025*a026);
  a032=(a032-a025);
  a032=(a032+a011);
  a032=(a031*a032);
  a027=(a027+a032);
  a299=(a299-a027);
  a027=(a297*a260);
  a027=(a299-a027);
  a032=(a085*a297);
  a032=(a008-a032);
  a011=(a027/a032);
  a000=cos(a000);
  a025=(a034*a000);
  a026=(a025/a053);
  a085=(a085*a026);
  a017=(a085/a032);
  a260=(a026*a260);
  a028=(a034*a268);
  a028=(a028*a268);
  a028=(a028*a289);
  a002=(a263*a071);
  a109=(a270*a109);
  a002=(a002+a109);
  a156=(a100*a156);
  a002=(a002+a156);
  a182=(a122*a182);
  a002=(a002+a182);
  a210=(a271*a210);
  a002=(a002+a210);
  a239=(a272*a239);
  a002=(a002+a239);
  a269=(a273*a269);
  a002=(a002+a269);
  a298=(a274*a298);
  a002=(a002+a298);
  a113=(a275*a113);
  a002=(a002+a113);
  a041=(a041+a002);
  a041=(a040*a041);
  a028=(a028+a041);
  a260=(a260-a028);
  a027=(a017*a027);
  a260=(a260-a027);
  a025=(a025*a026);
  a025=(a034-a025);
  a085=(a085*a017);
  a025=(a025-a085);
  a260=(a260/a025);
  a085=(a017*a260);
  a011=(a011-a085);
  a085=(a297*a011);
  a292=(a292-a085);
  a085=(a026*a260);
  a292=(a292+a085);
  a292=(a258*a292);
  a022=(a022+a292);
  a022=(a003+a022);
  if (res[0]!=0) res[0][3]=a022;
  a033=(a001*a033);
  a138=(a005*a138);
  a033=(a033+a138);
  a164=(a120*a164);
  a033=(a033+a164);
  a192=(a145*a192);
  a033=(a033+a192);
  a221=(a171*a221);
  a033=(a033+a221);
  a251=(a199*a251);
  a033=(a033+a251);
  a280=(a228*a280);
  a033=(a033+a280);
  a011=(a258*a011);
  a033=(a033+a011);
  a033=(a009+a033);
  if (res[0]!=0) res[0][4]=a033;
  a010=(a001*a010);
  a137=(a005*a137);
  a010=(a010+a137);
  a163=(a120*a163);
  a010=(a010+a163);
  a191=(a145*a191);
  a010=(a010+a191);
  a220=(a171*a220);
  a010=(a010+a220);
  a250=(a199*a250);
  a010=(a010+a250);
  a279=(a228*a279);
  a010=(a010+a279);
  a260=(a258*a260);
  a010=(a010+a260);
  a071=(a071+a010);
  if (res[0]!=0) res[0][5]=a071;
  a071=arg[0]? arg[0][6] : 0;
  a010=arg[0]? arg[0][9] : 0;
  a260=(a001*a010);
  a279=(a008*a012);
  a013=(a009*a013);
  a279=(a279*a013);
  a279=(a007-a279);
  a279=(a279-a016);
  a016=(a037*a279);
  a016=(a016-a039);
  a039=(a023*a279);
  a024=(a024-a039);
  a039=(a038*a024);
  a016=(a016-a039);
  a016=(a016/a036);
  a039=(a016*a034);
  a039=(a039*a007);
  a039=(a035-a039);
  a014=cos(a014);
  a250=(a014-a035);
  a250=(a008*a250);
  a039=(a039-a250);
  a250=(a039/a021);
  a220=(a008*a014);
  a191=(a023*a039);
  a220=(a220-a191);
  a191=(a220/a029);
  a039=(a037*a039);
  a279=(a279/a021);
  a024=(a024/a029);
  a163=(a038*a016);
  a024=(a024-a163);
  a163=(a023*a024);
  a279=(a279-a163);
  a016=(a037*a016);
  a279=(a279+a016);
  a016=(a279*a007);
  a035=(a035*a003);
  a035=(a035*a003);
  a016=(a016+a035);
  a016=(a034*a016);
  a039=(a039-a016);
  a220=(a038*a220);
  a039=(a039-a220);
  a039=(a039/a036);
  a220=(a038*a039);
  a191=(a191-a220);
  a220=(a023*a191);
  a250=(a250-a220);
  a220=(a037*a039);
  a250=(a250+a220);
  a220=(a250*a071);
  a024=(a024*a012);
  a016=(2.*a279);
  a016=(a016*a012);
  a024=(a024-a016);
  a024=(a024+a014);
  a013=(a019*a013);
  a024=(a024-a013);
  a024=(a008*a024);
  a013=(a024/a021);
  a279=(a279*a012);
  a279=(a279-a014);
  a019=(a019*a003);
  a019=(a019*a003);
  a279=(a279+a019);
  a279=(a008*a279);
  a279=(a279-a031);
  a019=(a023*a024);
  a279=(a279-a019);
  a019=(a279/a029);
  a024=(a037*a024);
  a279=(a038*a279);
  a024=(a024-a279);
  a024=(a024/a036);
  a279=(a038*a024);
  a019=(a019-a279);
  a279=(a023*a019);
  a013=(a013-a279);
  a279=(a037*a024);
  a013=(a013+a279);
  a279=arg[0]? arg[0][7] : 0;
  a014=(a013*a279);
  a220=(a220+a014);
  a014=(a040/a036);
  a016=(a038*a014);
  a035=(a023*a016);
  a163=(a037*a014);
  a035=(a035+a163);
  a163=arg[0]? arg[0][8] : 0;
  a137=(a035*a163);
  a220=(a220-a137);
  a137=-2.;
  a033=(a137*a008);
  a011=(a033*a009);
  a011=(a011*a012);
  a280=(a011/a021);
  a251=(a018*a003);
  a251=(a251*a012);
  a221=(a023*a011);
  a251=(a251-a221);
  a221=(a251/a029);
  a137=(a137*a034);
  a192=(a137*a003);
  a192=(a192*a007);
  a011=(a037*a011);
  a192=(a192+a011);
  a251=(a038*a251);
  a192=(a192-a251);
  a192=(a192/a036);
  a251=(a038*a192);
  a221=(a221-a251);
  a251=(a023*a221);
  a280=(a280-a251);
  a251=(a037*a192);
  a280=(a280+a251);
  a251=(a280*a010);
  a012=(a018*a012);
  a009=(a009-a003);
  a012=(a012*a009);
  a021=(a012/a021);
  a009=(a023*a012);
  a009=(a015+a009);
  a029=(a009/a029);
  a012=(a037*a012);
  a009=(a038*a009);
  a012=(a012+a009);
  a012=(a012/a036);
  a038=(a038*a012);
  a029=(a029+a038);
  a023=(a023*a029);
  a021=(a021+a023);
  a037=(a037*a012);
  a021=(a021+a037);
  a037=arg[0]? arg[0][10] : 0;
  a023=(a021*a037);
  a251=(a251+a023);
  a220=(a220+a251);
  a251=(a006*a220);
  a023=(a008*a091);
  a093=(a061*a093);
  a023=(a023*a093);
  a023=(a063-a023);
  a023=(a023-a096);
  a096=(a105*a023);
  a096=(a096-a107);
  a107=(a101*a023);
  a102=(a102-a107);
  a107=(a106*a102);
  a096=(a096-a107);
  a096=(a096/a104);
  a107=(a096*a034);
  a107=(a107*a063);
  a107=(a043-a107);
  a094=cos(a094);
  a038=(a094-a043);
  a038=(a008*a038);
  a107=(a107-a038);
  a038=(a107/a099);
  a036=(a008*a094);
  a009=(a101*a107);
  a036=(a036-a009);
  a009=(a036/a095);
  a107=(a105*a107);
  a023=(a023/a099);
  a102=(a102/a095);
  a003=(a106*a096);
  a102=(a102-a003);
  a003=(a101*a102);
  a023=(a023-a003);
  a096=(a105*a096);
  a023=(a023+a096);
  a096=(a023*a063);
  a043=(a043*a092);
  a043=(a043*a092);
  a096=(a096+a043);
  a096=(a034*a096);
  a107=(a107-a096);
  a036=(a106*a036);
  a107=(a107-a036);
  a107=(a107/a104);
  a036=(a106*a107);
  a009=(a009-a036);
  a036=(a101*a009);
  a038=(a038-a036);
  a036=(a105*a107);
  a038=(a038+a036);
  a036=(a042*a010);
  a096=(a045*a220);
  a043=(a008*a054);
  a056=(a051*a056);
  a043=(a043*a056);
  a043=(a050-a043);
  a043=(a043-a059);
  a059=(a068*a043);
  a059=(a059-a070);
  a070=(a064*a043);
  a065=(a065-a070);
  a070=(a069*a065);
  a059=(a059-a070);
  a059=(a059/a067);
  a070=(a059*a034);
  a070=(a070*a050);
  a070=(a049-a070);
  a057=cos(a057);
  a003=(a057-a049);
  a003=(a008*a003);
  a070=(a070-a003);
  a003=(a070/a062);
  a011=(a008*a057);
  a007=(a064*a070);
  a011=(a011-a007);
  a007=(a011/a058);
  a070=(a068*a070);
  a043=(a043/a062);
  a065=(a065/a058);
  a164=(a069*a059);
  a065=(a065-a164);
  a164=(a064*a065);
  a043=(a043-a164);
  a059=(a068*a059);
  a043=(a043+a059);
  a059=(a043*a050);
  a049=(a049*a055);
  a049=(a049*a055);
  a059=(a059+a049);
  a059=(a034*a059);
  a070=(a070-a059);
  a011=(a069*a011);
  a070=(a070-a011);
  a070=(a070/a067);
  a011=(a069*a070);
  a007=(a007-a011);
  a011=(a064*a007);
  a003=(a003-a011);
  a011=(a068*a070);
  a003=(a003+a011);
  a011=(a048*a010);
  a011=(a071+a011);
  a059=(a003*a011);
  a065=(a065*a054);
  a049=(2.*a043);
  a049=(a049*a054);
  a065=(a065-a049);
  a065=(a065+a057);
  a056=(a060*a056);
  a065=(a065-a056);
  a065=(a008*a065);
  a056=(a065/a062);
  a043=(a043*a054);
  a043=(a043-a057);
  a060=(a060*a055);
  a060=(a060*a055);
  a043=(a043+a060);
  a043=(a008*a043);
  a043=(a043-a031);
  a060=(a064*a065);
  a043=(a043-a060);
  a060=(a043/a058);
  a065=(a068*a065);
  a043=(a069*a043);
  a065=(a065-a043);
  a065=(a065/a067);
  a043=(a069*a065);
  a060=(a060-a043);
  a043=(a064*a060);
  a056=(a056-a043);
  a043=(a068*a065);
  a056=(a056+a043);
  a043=(a048*a037);
  a043=(a279+a043);
  a057=(a056*a043);
  a059=(a059+a057);
  a057=(a040/a067);
  a049=(a069*a057);
  a164=(a064*a049);
  a138=(a068*a057);
  a164=(a164+a138);
  a138=arg[0]? arg[0][11] : 0;
  a022=(a048*a138);
  a022=(a163+a022);
  a292=(a164*a022);
  a059=(a059-a292);
  a292=(a033*a051);
  a292=(a292*a054);
  a085=(a292/a062);
  a027=(a018*a055);
  a027=(a027*a054);
  a041=(a064*a292);
  a027=(a027-a041);
  a041=(a027/a058);
  a002=(a137*a055);
  a002=(a002*a050);
  a292=(a068*a292);
  a002=(a002+a292);
  a027=(a069*a027);
  a002=(a002-a027);
  a002=(a002/a067);
  a027=(a069*a002);
  a041=(a041-a027);
  a027=(a064*a041);
  a085=(a085-a027);
  a027=(a068*a002);
  a085=(a085+a027);
  a027=(a048*a220);
  a027=(a010+a027);
  a292=(a085*a027);
  a054=(a018*a054);
  a051=(a051-a055);
  a054=(a054*a051);
  a062=(a054/a062);
  a051=(a064*a054);
  a051=(a015+a051);
  a058=(a051/a058);
  a054=(a068*a054);
  a051=(a069*a051);
  a054=(a054+a051);
  a054=(a054/a067);
  a069=(a069*a054);
  a058=(a058+a069);
  a064=(a064*a058);
  a062=(a062+a064);
  a068=(a068*a054);
  a062=(a062+a068);
  a068=(a191*a071);
  a064=(a019*a279);
  a068=(a068+a064);
  a064=(a016*a163);
  a068=(a068+a064);
  a064=(a221*a010);
  a069=(a029*a037);
  a064=(a064-a069);
  a068=(a068+a064);
  a064=(a048*a068);
  a064=(a037+a064);
  a069=(a062*a064);
  a292=(a292+a069);
  a059=(a059+a292);
  a059=(a047*a059);
  a096=(a096+a059);
  a096=(a010+a096);
  a059=(a044*a096);
  a036=(a036+a059);
  a036=(a071+a036);
  a059=(a038*a036);
  a102=(a102*a091);
  a292=(2.*a023);
  a292=(a292*a091);
  a102=(a102-a292);
  a102=(a102+a094);
  a093=(a097*a093);
  a102=(a102-a093);
  a102=(a008*a102);
  a093=(a102/a099);
  a023=(a023*a091);
  a023=(a023-a094);
  a097=(a097*a092);
  a097=(a097*a092);
  a023=(a023+a097);
  a023=(a008*a023);
  a023=(a023-a031);
  a097=(a101*a102);
  a023=(a023-a097);
  a097=(a023/a095);
  a102=(a105*a102);
  a023=(a106*a023);
  a102=(a102-a023);
  a102=(a102/a104);
  a023=(a106*a102);
  a097=(a097-a023);
  a023=(a101*a097);
  a093=(a093-a023);
  a023=(a105*a102);
  a093=(a093+a023);
  a023=(a042*a037);
  a094=(a045*a068);
  a292=(a007*a011);
  a069=(a060*a043);
  a292=(a292+a069);
  a069=(a049*a022);
  a292=(a292+a069);
  a069=(a041*a027);
  a067=(a058*a064);
  a069=(a069-a067);
  a292=(a292+a069);
  a292=(a047*a292);
  a094=(a094+a292);
  a094=(a037+a094);
  a292=(a044*a094);
  a023=(a023+a292);
  a023=(a279+a023);
  a292=(a093*a023);
  a059=(a059+a292);
  a292=(a040/a104);
  a069=(a106*a292);
  a067=(a101*a069);
  a051=(a105*a292);
  a067=(a067+a051);
  a051=(a042*a138);
  a055=(a039*a071);
  a050=(a024*a279);
  a055=(a055+a050);
  a050=(a014*a163);
  a055=(a055-a050);
  a050=(a192*a010);
  a113=(a012*a037);
  a050=(a050+a113);
  a055=(a055+a050);
  a050=(a045*a055);
  a011=(a070*a011);
  a043=(a065*a043);
  a011=(a011+a043);
  a022=(a057*a022);
  a011=(a011-a022);
  a022=(a002*a027);
  a043=(a054*a064);
  a022=(a022+a043);
  a011=(a011+a022);
  a011=(a047*a011);
  a050=(a050+a011);
  a050=(a138+a050);
  a011=(a044*a050);
  a051=(a051+a011);
  a051=(a163+a051);
  a011=(a067*a051);
  a059=(a059-a011);
  a011=(a033*a061);
  a011=(a011*a091);
  a022=(a011/a099);
  a043=(a018*a092);
  a043=(a043*a091);
  a113=(a101*a011);
  a043=(a043-a113);
  a113=(a043/a095);
  a298=(a137*a092);
  a298=(a298*a063);
  a011=(a105*a011);
  a298=(a298+a011);
  a043=(a106*a043);
  a298=(a298-a043);
  a298=(a298/a104);
  a043=(a106*a298);
  a113=(a113-a043);
  a043=(a101*a113);
  a022=(a022-a043);
  a043=(a105*a298);
  a022=(a022+a043);
  a043=(a042*a220);
  a011=(a008*a073);
  a082=(a077*a082);
  a011=(a011*a082);
  a011=(a080-a011);
  a011=(a011-a076);
  a076=(a087*a011);
  a076=(a076-a090);
  a090=(a079*a011);
  a066=(a066-a090);
  a090=(a088*a066);
  a076=(a076-a090);
  a076=(a076/a086);
  a090=(a076*a034);
  a090=(a090*a080);
  a090=(a074-a090);
  a075=cos(a075);
  a063=(a075-a074);
  a063=(a008*a063);
  a090=(a090-a063);
  a063=(a090/a078);
  a269=(a008*a075);
  a239=(a079*a090);
  a269=(a269-a239);
  a239=(a269/a084);
  a090=(a087*a090);
  a011=(a011/a078);
  a066=(a066/a084);
  a210=(a088*a076);
  a066=(a066-a210);
  a210=(a079*a066);
  a011=(a011-a210);
  a076=(a087*a076);
  a011=(a011+a076);
  a076=(a011*a080);
  a074=(a074*a046);
  a074=(a074*a046);
  a076=(a076+a074);
  a076=(a034*a076);
  a090=(a090-a076);
  a269=(a088*a269);
  a090=(a090-a269);
  a090=(a090/a086);
  a269=(a088*a090);
  a239=(a239-a269);
  a269=(a079*a239);
  a063=(a063-a269);
  a269=(a087*a090);
  a063=(a063+a269);
  a269=(a045*a010);
  a027=(a047*a027);
  a269=(a269+a027);
  a269=(a071+a269);
  a027=(a063*a269);
  a066=(a066*a073);
  a076=(2.*a011);
  a076=(a076*a073);
  a066=(a066-a076);
  a066=(a066+a075);
  a082=(a072*a082);
  a066=(a066-a082);
  a066=(a008*a066);
  a082=(a066/a078);
  a011=(a011*a073);
  a011=(a011-a075);
  a072=(a072*a046);
  a072=(a072*a046);
  a011=(a011+a072);
  a011=(a008*a011);
  a011=(a011-a031);
  a072=(a079*a066);
  a011=(a011-a072);
  a072=(a011/a084);
  a066=(a087*a066);
  a011=(a088*a011);
  a066=(a066-a011);
  a066=(a066/a086);
  a011=(a088*a066);
  a072=(a072-a011);
  a011=(a079*a072);
  a082=(a082-a011);
  a011=(a087*a066);
  a082=(a082+a011);
  a011=(a045*a037);
  a064=(a047*a064);
  a011=(a011+a064);
  a011=(a279+a011);
  a064=(a082*a011);
  a027=(a027+a064);
  a064=(a040/a086);
  a075=(a088*a064);
  a076=(a079*a075);
  a074=(a087*a064);
  a076=(a076+a074);
  a074=(a045*a138);
  a210=(a048*a055);
  a210=(a138+a210);
  a210=(a047*a210);
  a074=(a074+a210);
  a074=(a163+a074);
  a210=(a076*a074);
  a027=(a027-a210);
  a210=(a033*a077);
  a210=(a210*a073);
  a182=(a210/a078);
  a156=(a018*a046);
  a156=(a156*a073);
  a109=(a079*a210);
  a156=(a156-a109);
  a109=(a156/a084);
  a147=(a137*a046);
  a147=(a147*a080);
  a210=(a087*a210);
  a147=(a147+a210);
  a156=(a088*a156);
  a147=(a147-a156);
  a147=(a147/a086);
  a156=(a088*a147);
  a109=(a109-a156);
  a156=(a079*a109);
  a182=(a182-a156);
  a156=(a087*a147);
  a182=(a182+a156);
  a156=(a182*a096);
  a073=(a018*a073);
  a077=(a077-a046);
  a073=(a073*a077);
  a078=(a073/a078);
  a077=(a079*a073);
  a077=(a015+a077);
  a084=(a077/a084);
  a073=(a087*a073);
  a077=(a088*a077);
  a073=(a073+a077);
  a073=(a073/a086);
  a088=(a088*a073);
  a084=(a084+a088);
  a079=(a079*a084);
  a078=(a078+a079);
  a087=(a087*a073);
  a078=(a078+a087);
  a087=(a078*a094);
  a156=(a156+a087);
  a027=(a027+a156);
  a156=(a044*a027);
  a043=(a043+a156);
  a043=(a010+a043);
  a156=(a022*a043);
  a091=(a018*a091);
  a061=(a061-a092);
  a091=(a091*a061);
  a099=(a091/a099);
  a061=(a101*a091);
  a061=(a015+a061);
  a095=(a061/a095);
  a091=(a105*a091);
  a061=(a106*a061);
  a091=(a091+a061);
  a091=(a091/a104);
  a106=(a106*a091);
  a095=(a095+a106);
  a101=(a101*a095);
  a099=(a099+a101);
  a105=(a105*a091);
  a099=(a099+a105);
  a105=(a042*a068);
  a101=(a239*a269);
  a106=(a072*a011);
  a101=(a101+a106);
  a106=(a075*a074);
  a101=(a101+a106);
  a106=(a109*a096);
  a104=(a084*a094);
  a106=(a106-a104);
  a101=(a101+a106);
  a106=(a044*a101);
  a105=(a105+a106);
  a105=(a037+a105);
  a106=(a099*a105);
  a156=(a156+a106);
  a059=(a059+a156);
  a156=(a030*a059);
  a251=(a251+a156);
  a156=(a008*a114);
  a081=(a112*a081);
  a156=(a156*a081);
  a156=(a111-a156);
  a156=(a156-a118);
  a118=(a127*a156);
  a118=(a118-a129);
  a129=(a123*a156);
  a124=(a124-a129);
  a129=(a128*a124);
  a118=(a118-a129);
  a118=(a118/a126);
  a129=(a118*a034);
  a129=(a129*a111);
  a129=(a108-a129);
  a116=cos(a116);
  a106=(a116-a108);
  a106=(a008*a106);
  a129=(a129-a106);
  a106=(a129/a121);
  a104=(a008*a116);
  a061=(a123*a129);
  a104=(a104-a061);
  a061=(a104/a117);
  a129=(a127*a129);
  a156=(a156/a121);
  a124=(a124/a117);
  a092=(a128*a118);
  a124=(a124-a092);
  a092=(a123*a124);
  a156=(a156-a092);
  a118=(a127*a118);
  a156=(a156+a118);
  a118=(a156*a111);
  a108=(a108*a115);
  a108=(a108*a115);
  a118=(a118+a108);
  a118=(a034*a118);
  a129=(a129-a118);
  a104=(a128*a104);
  a129=(a129-a104);
  a129=(a129/a126);
  a104=(a128*a129);
  a061=(a061-a104);
  a104=(a123*a061);
  a106=(a106-a104);
  a104=(a127*a129);
  a106=(a106+a104);
  a104=(a103*a010);
  a118=(a052*a096);
  a104=(a104+a118);
  a118=(a110*a043);
  a104=(a104+a118);
  a104=(a071+a104);
  a118=(a106*a104);
  a124=(a124*a114);
  a108=(2.*a156);
  a108=(a108*a114);
  a124=(a124-a108);
  a124=(a124+a116);
  a081=(a119*a081);
  a124=(a124-a081);
  a124=(a008*a124);
  a081=(a124/a121);
  a156=(a156*a114);
  a156=(a156-a116);
  a119=(a119*a115);
  a119=(a119*a115);
  a156=(a156+a119);
  a156=(a008*a156);
  a156=(a156-a031);
  a119=(a123*a124);
  a156=(a156-a119);
  a119=(a156/a117);
  a124=(a127*a124);
  a156=(a128*a156);
  a124=(a124-a156);
  a124=(a124/a126);
  a156=(a128*a124);
  a119=(a119-a156);
  a156=(a123*a119);
  a081=(a081-a156);
  a156=(a127*a124);
  a081=(a081+a156);
  a156=(a103*a037);
  a116=(a052*a094);
  a156=(a156+a116);
  a116=(a110*a105);
  a156=(a156+a116);
  a156=(a279+a156);
  a116=(a081*a156);
  a118=(a118+a116);
  a116=(a040/a126);
  a108=(a128*a116);
  a092=(a123*a108);
  a087=(a127*a116);
  a092=(a092+a087);
  a087=(a103*a138);
  a050=(a052*a050);
  a087=(a087+a050);
  a050=(a042*a055);
  a269=(a090*a269);
  a011=(a066*a011);
  a269=(a269+a011);
  a074=(a064*a074);
  a269=(a269-a074);
  a096=(a147*a096);
  a094=(a073*a094);
  a096=(a096+a094);
  a269=(a269+a096);
  a096=(a044*a269);
  a050=(a050+a096);
  a050=(a138+a050);
  a096=(a110*a050);
  a087=(a087+a096);
  a087=(a163+a087);
  a096=(a092*a087);
  a118=(a118-a096);
  a096=(a033*a112);
  a096=(a096*a114);
  a094=(a096/a121);
  a074=(a018*a115);
  a074=(a074*a114);
  a011=(a123*a096);
  a074=(a074-a011);
  a011=(a074/a117);
  a079=(a137*a115);
  a079=(a079*a111);
  a096=(a127*a096);
  a079=(a079+a096);
  a074=(a128*a074);
  a079=(a079-a074);
  a079=(a079/a126);
  a074=(a128*a079);
  a011=(a011-a074);
  a074=(a123*a011);
  a094=(a094-a074);
  a074=(a127*a079);
  a094=(a094+a074);
  a074=(a103*a220);
  a027=(a052*a027);
  a074=(a074+a027);
  a027=(a110*a059);
  a074=(a074+a027);
  a074=(a010+a074);
  a027=(a094*a074);
  a114=(a018*a114);
  a112=(a112-a115);
  a114=(a114*a112);
  a121=(a114/a121);
  a112=(a123*a114);
  a112=(a015+a112);
  a117=(a112/a117);
  a114=(a127*a114);
  a112=(a128*a112);
  a114=(a114+a112);
  a114=(a114/a126);
  a128=(a128*a114);
  a117=(a117+a128);
  a123=(a123*a117);
  a121=(a121+a123);
  a127=(a127*a114);
  a121=(a121+a127);
  a127=(a103*a068);
  a101=(a052*a101);
  a127=(a127+a101);
  a101=(a009*a036);
  a123=(a097*a023);
  a101=(a101+a123);
  a123=(a069*a051);
  a101=(a101+a123);
  a123=(a113*a043);
  a128=(a095*a105);
  a123=(a123-a128);
  a101=(a101+a123);
  a123=(a110*a101);
  a127=(a127+a123);
  a127=(a037+a127);
  a123=(a121*a127);
  a027=(a027+a123);
  a118=(a118+a027);
  a027=(a098*a118);
  a251=(a251+a027);
  a251=(a010+a251);
  a027=(a005*a251);
  a260=(a260+a027);
  a027=(a125*a220);
  a123=(a131*a059);
  a027=(a027+a123);
  a123=(a132*a118);
  a027=(a027+a123);
  a123=(a008*a139);
  a140=(a136*a140);
  a123=(a123*a140);
  a123=(a135-a123);
  a123=(a123-a143);
  a143=(a152*a123);
  a143=(a143-a154);
  a154=(a148*a123);
  a149=(a149-a154);
  a154=(a153*a149);
  a143=(a143-a154);
  a143=(a143/a151);
  a154=(a143*a034);
  a154=(a154*a135);
  a154=(a134-a154);
  a141=cos(a141);
  a128=(a141-a134);
  a128=(a008*a128);
  a154=(a154-a128);
  a128=(a154/a146);
  a126=(a008*a141);
  a112=(a148*a154);
  a126=(a126-a112);
  a112=(a126/a142);
  a154=(a152*a154);
  a123=(a123/a146);
  a149=(a149/a142);
  a115=(a153*a143);
  a149=(a149-a115);
  a115=(a148*a149);
  a123=(a123-a115);
  a143=(a152*a143);
  a123=(a123+a143);
  a143=(a123*a135);
  a134=(a134*a020);
  a134=(a134*a020);
  a143=(a143+a134);
  a143=(a034*a143);
  a154=(a154-a143);
  a126=(a153*a126);
  a154=(a154-a126);
  a154=(a154/a151);
  a126=(a153*a154);
  a112=(a112-a126);
  a126=(a148*a112);
  a128=(a128-a126);
  a126=(a152*a154);
  a128=(a128+a126);
  a126=(a006*a010);
  a143=(a030*a043);
  a126=(a126+a143);
  a143=(a098*a074);
  a126=(a126+a143);
  a126=(a071+a126);
  a143=(a128*a126);
  a149=(a149*a139);
  a134=(2.*a123);
  a134=(a134*a139);
  a149=(a149-a134);
  a149=(a149+a141);
  a140=(a144*a140);
  a149=(a149-a140);
  a149=(a008*a149);
  a140=(a149/a146);
  a123=(a123*a139);
  a123=(a123-a141);
  a144=(a144*a020);
  a144=(a144*a020);
  a123=(a123+a144);
  a123=(a008*a123);
  a123=(a123-a031);
  a144=(a148*a149);
  a123=(a123-a144);
  a144=(a123/a142);
  a149=(a152*a149);
  a123=(a153*a123);
  a149=(a149-a123);
  a149=(a149/a151);
  a123=(a153*a149);
  a144=(a144-a123);
  a123=(a148*a144);
  a140=(a140-a123);
  a123=(a152*a149);
  a140=(a140+a123);
  a123=(a006*a037);
  a141=(a030*a105);
  a123=(a123+a141);
  a141=(a098*a127);
  a123=(a123+a141);
  a123=(a279+a123);
  a141=(a140*a123);
  a143=(a143+a141);
  a141=(a040/a151);
  a134=(a153*a141);
  a115=(a148*a134);
  a096=(a152*a141);
  a115=(a115+a096);
  a096=(a006*a138);
  a111=(a030*a050);
  a096=(a096+a111);
  a111=(a103*a055);
  a269=(a052*a269);
  a111=(a111+a269);
  a036=(a107*a036);
  a023=(a102*a023);
  a036=(a036+a023);
  a051=(a292*a051);
  a036=(a036-a051);
  a051=(a298*a043);
  a023=(a091*a105);
  a051=(a051+a023);
  a036=(a036+a051);
  a051=(a110*a036);
  a111=(a111+a051);
  a111=(a138+a111);
  a051=(a098*a111);
  a096=(a096+a051);
  a096=(a163+a096);
  a051=(a115*a096);
  a143=(a143-a051);
  a051=(a033*a136);
  a051=(a051*a139);
  a023=(a051/a146);
  a269=(a018*a020);
  a269=(a269*a139);
  a088=(a148*a051);
  a269=(a269-a088);
  a088=(a269/a142);
  a086=(a137*a020);
  a086=(a086*a135);
  a051=(a152*a051);
  a086=(a086+a051);
  a269=(a153*a269);
  a086=(a086-a269);
  a086=(a086/a151);
  a269=(a153*a086);
  a088=(a088-a269);
  a269=(a148*a088);
  a023=(a023-a269);
  a269=(a152*a086);
  a023=(a023+a269);
  a269=(a023*a251);
  a139=(a018*a139);
  a136=(a136-a020);
  a139=(a139*a136);
  a146=(a139/a146);
  a136=(a148*a139);
  a136=(a015+a136);
  a142=(a136/a142);
  a139=(a152*a139);
  a136=(a153*a136);
  a139=(a139+a136);
  a139=(a139/a151);
  a153=(a153*a139);
  a142=(a142+a153);
  a148=(a148*a142);
  a146=(a146+a148);
  a152=(a152*a139);
  a146=(a146+a152);
  a152=(a006*a068);
  a148=(a030*a101);
  a152=(a152+a148);
  a148=(a061*a104);
  a153=(a119*a156);
  a148=(a148+a153);
  a153=(a108*a087);
  a148=(a148+a153);
  a153=(a011*a074);
  a151=(a117*a127);
  a153=(a153-a151);
  a148=(a148+a153);
  a153=(a098*a148);
  a152=(a152+a153);
  a152=(a037+a152);
  a153=(a146*a152);
  a269=(a269+a153);
  a143=(a143+a269);
  a269=(a133*a143);
  a027=(a027+a269);
  a027=(a010+a027);
  a269=(a120*a027);
  a260=(a260+a269);
  a269=(a150*a220);
  a153=(a089*a059);
  a269=(a269+a153);
  a153=(a157*a118);
  a269=(a269+a153);
  a153=(a158*a143);
  a269=(a269+a153);
  a153=(a008*a165);
  a166=(a162*a166);
  a153=(a153*a166);
  a153=(a161-a153);
  a153=(a153-a169);
  a169=(a178*a153);
  a169=(a169-a180);
  a180=(a174*a153);
  a175=(a175-a180);
  a180=(a179*a175);
  a169=(a169-a180);
  a169=(a169/a177);
  a180=(a169*a034);
  a180=(a180*a161);
  a180=(a160-a180);
  a167=cos(a167);
  a151=(a167-a160);
  a151=(a008*a151);
  a180=(a180-a151);
  a151=(a180/a172);
  a136=(a008*a167);
  a020=(a174*a180);
  a136=(a136-a020);
  a020=(a136/a168);
  a180=(a178*a180);
  a153=(a153/a172);
  a175=(a175/a168);
  a051=(a179*a169);
  a175=(a175-a051);
  a051=(a174*a175);
  a153=(a153-a051);
  a169=(a178*a169);
  a153=(a153+a169);
  a169=(a153*a161);
  a160=(a160*a130);
  a160=(a160*a130);
  a169=(a169+a160);
  a169=(a034*a169);
  a180=(a180-a169);
  a136=(a179*a136);
  a180=(a180-a136);
  a180=(a180/a177);
  a136=(a179*a180);
  a020=(a020-a136);
  a136=(a174*a020);
  a151=(a151-a136);
  a136=(a178*a180);
  a151=(a151+a136);
  a136=(a125*a010);
  a169=(a131*a043);
  a136=(a136+a169);
  a169=(a132*a074);
  a136=(a136+a169);
  a169=(a133*a251);
  a136=(a136+a169);
  a136=(a071+a136);
  a169=(a151*a136);
  a175=(a175*a165);
  a160=(2.*a153);
  a160=(a160*a165);
  a175=(a175-a160);
  a175=(a175+a167);
  a166=(a170*a166);
  a175=(a175-a166);
  a175=(a008*a175);
  a166=(a175/a172);
  a153=(a153*a165);
  a153=(a153-a167);
  a170=(a170*a130);
  a170=(a170*a130);
  a153=(a153+a170);
  a153=(a008*a153);
  a153=(a153-a031);
  a170=(a174*a175);
  a153=(a153-a170);
  a170=(a153/a168);
  a175=(a178*a175);
  a153=(a179*a153);
  a175=(a175-a153);
  a175=(a175/a177);
  a153=(a179*a175);
  a170=(a170-a153);
  a153=(a174*a170);
  a166=(a166-a153);
  a153=(a178*a175);
  a166=(a166+a153);
  a153=(a125*a037);
  a167=(a131*a105);
  a153=(a153+a167);
  a167=(a132*a127);
  a153=(a153+a167);
  a167=(a133*a152);
  a153=(a153+a167);
  a153=(a279+a153);
  a167=(a166*a153);
  a169=(a169+a167);
  a167=(a040/a177);
  a160=(a179*a167);
  a051=(a174*a160);
  a135=(a178*a167);
  a051=(a051+a135);
  a135=(a125*a138);
  a077=(a131*a050);
  a135=(a135+a077);
  a077=(a132*a111);
  a135=(a135+a077);
  a077=(a006*a055);
  a046=(a030*a036);
  a077=(a077+a046);
  a104=(a129*a104);
  a156=(a124*a156);
  a104=(a104+a156);
  a087=(a116*a087);
  a104=(a104-a087);
  a087=(a079*a074);
  a156=(a114*a127);
  a087=(a087+a156);
  a104=(a104+a087);
  a087=(a098*a104);
  a077=(a077+a087);
  a077=(a138+a077);
  a087=(a133*a077);
  a135=(a135+a087);
  a135=(a163+a135);
  a087=(a051*a135);
  a169=(a169-a087);
  a087=(a033*a162);
  a087=(a087*a165);
  a156=(a087/a172);
  a046=(a018*a130);
  a046=(a046*a165);
  a210=(a174*a087);
  a046=(a046-a210);
  a210=(a046/a168);
  a080=(a137*a130);
  a080=(a080*a161);
  a087=(a178*a087);
  a080=(a080+a087);
  a046=(a179*a046);
  a080=(a080-a046);
  a080=(a080/a177);
  a046=(a179*a080);
  a210=(a210-a046);
  a046=(a174*a210);
  a156=(a156-a046);
  a046=(a178*a080);
  a156=(a156+a046);
  a046=(a156*a027);
  a165=(a018*a165);
  a162=(a162-a130);
  a165=(a165*a162);
  a172=(a165/a172);
  a162=(a174*a165);
  a162=(a015+a162);
  a168=(a162/a168);
  a165=(a178*a165);
  a162=(a179*a162);
  a165=(a165+a162);
  a165=(a165/a177);
  a179=(a179*a165);
  a168=(a168+a179);
  a174=(a174*a168);
  a172=(a172+a174);
  a178=(a178*a165);
  a172=(a172+a178);
  a178=(a125*a068);
  a174=(a131*a101);
  a178=(a178+a174);
  a174=(a132*a148);
  a178=(a178+a174);
  a174=(a112*a126);
  a179=(a144*a123);
  a174=(a174+a179);
  a179=(a134*a096);
  a174=(a174+a179);
  a179=(a088*a251);
  a177=(a142*a152);
  a179=(a179-a177);
  a174=(a174+a179);
  a179=(a133*a174);
  a178=(a178+a179);
  a178=(a037+a178);
  a179=(a172*a178);
  a046=(a046+a179);
  a169=(a169+a046);
  a046=(a159*a169);
  a269=(a269+a046);
  a269=(a010+a269);
  a046=(a145*a269);
  a260=(a260+a046);
  a046=(a176*a220);
  a179=(a183*a059);
  a046=(a046+a179);
  a179=(a184*a118);
  a046=(a046+a179);
  a179=(a185*a143);
  a046=(a046+a179);
  a179=(a186*a169);
  a046=(a046+a179);
  a179=(a008*a193);
  a194=(a190*a194);
  a179=(a179*a194);
  a179=(a189-a179);
  a179=(a179-a197);
  a197=(a206*a179);
  a197=(a197-a208);
  a208=(a202*a179);
  a203=(a203-a208);
  a208=(a207*a203);
  a197=(a197-a208);
  a197=(a197/a205);
  a208=(a197*a034);
  a208=(a208*a189);
  a208=(a188-a208);
  a195=cos(a195);
  a177=(a195-a188);
  a177=(a008*a177);
  a208=(a208-a177);
  a177=(a208/a200);
  a162=(a008*a195);
  a130=(a202*a208);
  a162=(a162-a130);
  a130=(a162/a196);
  a208=(a206*a208);
  a179=(a179/a200);
  a203=(a203/a196);
  a087=(a207*a197);
  a203=(a203-a087);
  a087=(a202*a203);
  a179=(a179-a087);
  a197=(a206*a197);
  a179=(a179+a197);
  a197=(a179*a189);
  a188=(a188*a155);
  a188=(a188*a155);
  a197=(a197+a188);
  a197=(a034*a197);
  a208=(a208-a197);
  a162=(a207*a162);
  a208=(a208-a162);
  a208=(a208/a205);
  a162=(a207*a208);
  a130=(a130-a162);
  a162=(a202*a130);
  a177=(a177-a162);
  a162=(a206*a208);
  a177=(a177+a162);
  a162=(a150*a010);
  a197=(a089*a043);
  a162=(a162+a197);
  a197=(a157*a074);
  a162=(a162+a197);
  a197=(a158*a251);
  a162=(a162+a197);
  a197=(a159*a027);
  a162=(a162+a197);
  a162=(a071+a162);
  a197=(a177*a162);
  a203=(a203*a193);
  a188=(2.*a179);
  a188=(a188*a193);
  a203=(a203-a188);
  a203=(a203+a195);
  a194=(a198*a194);
  a203=(a203-a194);
  a203=(a008*a203);
  a194=(a203/a200);
  a179=(a179*a193);
  a179=(a179-a195);
  a198=(a198*a155);
  a198=(a198*a155);
  a179=(a179+a198);
  a179=(a008*a179);
  a179=(a179-a031);
  a198=(a202*a203);
  a179=(a179-a198);
  a198=(a179/a196);
  a203=(a206*a203);
  a179=(a207*a179);
  a203=(a203-a179);
  a203=(a203/a205);
  a179=(a207*a203);
  a198=(a198-a179);
  a179=(a202*a198);
  a194=(a194-a179);
  a179=(a206*a203);
  a194=(a194+a179);
  a179=(a150*a037);
  a195=(a089*a105);
  a179=(a179+a195);
  a195=(a157*a127);
  a179=(a179+a195);
  a195=(a158*a152);
  a179=(a179+a195);
  a195=(a159*a178);
  a179=(a179+a195);
  a179=(a279+a179);
  a195=(a194*a179);
  a197=(a197+a195);
  a195=(a040/a205);
  a188=(a207*a195);
  a087=(a202*a188);
  a161=(a206*a195);
  a087=(a087+a161);
  a161=(a150*a138);
  a300=(a089*a050);
  a161=(a161+a300);
  a300=(a157*a111);
  a161=(a161+a300);
  a300=(a158*a077);
  a161=(a161+a300);
  a300=(a125*a055);
  a301=(a131*a036);
  a300=(a300+a301);
  a301=(a132*a104);
  a300=(a300+a301);
  a126=(a154*a126);
  a123=(a149*a123);
  a126=(a126+a123);
  a096=(a141*a096);
  a126=(a126-a096);
  a096=(a086*a251);
  a123=(a139*a152);
  a096=(a096+a123);
  a126=(a126+a096);
  a096=(a133*a126);
  a300=(a300+a096);
  a300=(a138+a300);
  a096=(a159*a300);
  a161=(a161+a096);
  a161=(a163+a161);
  a096=(a087*a161);
  a197=(a197-a096);
  a096=(a033*a190);
  a096=(a096*a193);
  a123=(a096/a200);
  a301=(a018*a155);
  a301=(a301*a193);
  a302=(a202*a096);
  a301=(a301-a302);
  a302=(a301/a196);
  a303=(a137*a155);
  a303=(a303*a189);
  a096=(a206*a096);
  a303=(a303+a096);
  a301=(a207*a301);
  a303=(a303-a301);
  a303=(a303/a205);
  a301=(a207*a303);
  a302=(a302-a301);
  a301=(a202*a302);
  a123=(a123-a301);
  a301=(a206*a303);
  a123=(a123+a301);
  a301=(a123*a269);
  a193=(a018*a193);
  a190=(a190-a155);
  a193=(a193*a190);
  a200=(a193/a200);
  a190=(a202*a193);
  a190=(a015+a190);
  a196=(a190/a196);
  a193=(a206*a193);
  a190=(a207*a190);
  a193=(a193+a190);
  a193=(a193/a205);
  a207=(a207*a193);
  a196=(a196+a207);
  a202=(a202*a196);
  a200=(a200+a202);
  a206=(a206*a193);
  a200=(a200+a206);
  a206=(a150*a068);
  a202=(a089*a101);
  a206=(a206+a202);
  a202=(a157*a148);
  a206=(a206+a202);
  a202=(a158*a174);
  a206=(a206+a202);
  a202=(a020*a136);
  a207=(a170*a153);
  a202=(a202+a207);
  a207=(a160*a135);
  a202=(a202+a207);
  a207=(a210*a027);
  a205=(a168*a178);
  a207=(a207-a205);
  a202=(a202+a207);
  a207=(a159*a202);
  a206=(a206+a207);
  a206=(a037+a206);
  a207=(a200*a206);
  a301=(a301+a207);
  a197=(a197+a301);
  a301=(a187*a197);
  a046=(a046+a301);
  a046=(a010+a046);
  a301=(a171*a046);
  a260=(a260+a301);
  a301=(a204*a220);
  a207=(a211*a059);
  a301=(a301+a207);
  a207=(a212*a118);
  a301=(a301+a207);
  a207=(a213*a143);
  a301=(a301+a207);
  a207=(a214*a169);
  a301=(a301+a207);
  a207=(a215*a197);
  a301=(a301+a207);
  a207=(a008*a222);
  a223=(a219*a223);
  a207=(a207*a223);
  a207=(a218-a207);
  a207=(a207-a226);
  a226=(a235*a207);
  a226=(a226-a237);
  a237=(a231*a207);
  a232=(a232-a237);
  a237=(a236*a232);
  a226=(a226-a237);
  a226=(a226/a234);
  a237=(a226*a034);
  a237=(a237*a218);
  a237=(a217-a237);
  a224=cos(a224);
  a205=(a224-a217);
  a205=(a008*a205);
  a237=(a237-a205);
  a205=(a237/a229);
  a190=(a008*a224);
  a155=(a231*a237);
  a190=(a190-a155);
  a155=(a190/a225);
  a237=(a235*a237);
  a207=(a207/a229);
  a232=(a232/a225);
  a096=(a236*a226);
  a232=(a232-a096);
  a096=(a231*a232);
  a207=(a207-a096);
  a226=(a235*a226);
  a207=(a207+a226);
  a226=(a207*a218);
  a217=(a217*a181);
  a217=(a217*a181);
  a226=(a226+a217);
  a226=(a034*a226);
  a237=(a237-a226);
  a190=(a236*a190);
  a237=(a237-a190);
  a237=(a237/a234);
  a190=(a236*a237);
  a155=(a155-a190);
  a190=(a231*a155);
  a205=(a205-a190);
  a190=(a235*a237);
  a205=(a205+a190);
  a190=(a176*a010);
  a226=(a183*a043);
  a190=(a190+a226);
  a226=(a184*a074);
  a190=(a190+a226);
  a226=(a185*a251);
  a190=(a190+a226);
  a226=(a186*a027);
  a190=(a190+a226);
  a226=(a187*a269);
  a190=(a190+a226);
  a190=(a071+a190);
  a226=(a205*a190);
  a232=(a232*a222);
  a217=(2.*a207);
  a217=(a217*a222);
  a232=(a232-a217);
  a232=(a232+a224);
  a223=(a227*a223);
  a232=(a232-a223);
  a232=(a008*a232);
  a223=(a232/a229);
  a207=(a207*a222);
  a207=(a207-a224);
  a227=(a227*a181);
  a227=(a227*a181);
  a207=(a207+a227);
  a207=(a008*a207);
  a207=(a207-a031);
  a227=(a231*a232);
  a207=(a207-a227);
  a227=(a207/a225);
  a232=(a235*a232);
  a207=(a236*a207);
  a232=(a232-a207);
  a232=(a232/a234);
  a207=(a236*a232);
  a227=(a227-a207);
  a207=(a231*a227);
  a223=(a223-a207);
  a207=(a235*a232);
  a223=(a223+a207);
  a207=(a176*a037);
  a224=(a183*a105);
  a207=(a207+a224);
  a224=(a184*a127);
  a207=(a207+a224);
  a224=(a185*a152);
  a207=(a207+a224);
  a224=(a186*a178);
  a207=(a207+a224);
  a224=(a187*a206);
  a207=(a207+a224);
  a207=(a279+a207);
  a224=(a223*a207);
  a226=(a226+a224);
  a224=(a040/a234);
  a217=(a236*a224);
  a096=(a231*a217);
  a189=(a235*a224);
  a096=(a096+a189);
  a189=(a176*a138);
  a304=(a183*a050);
  a189=(a189+a304);
  a304=(a184*a111);
  a189=(a189+a304);
  a304=(a185*a077);
  a189=(a189+a304);
  a304=(a186*a300);
  a189=(a189+a304);
  a304=(a150*a055);
  a305=(a089*a036);
  a304=(a304+a305);
  a305=(a157*a104);
  a304=(a304+a305);
  a305=(a158*a126);
  a304=(a304+a305);
  a136=(a180*a136);
  a153=(a175*a153);
  a136=(a136+a153);
  a135=(a167*a135);
  a136=(a136-a135);
  a135=(a080*a027);
  a153=(a165*a178);
  a135=(a135+a153);
  a136=(a136+a135);
  a135=(a159*a136);
  a304=(a304+a135);
  a304=(a138+a304);
  a135=(a187*a304);
  a189=(a189+a135);
  a189=(a163+a189);
  a135=(a096*a189);
  a226=(a226-a135);
  a135=(a033*a219);
  a135=(a135*a222);
  a153=(a135/a229);
  a305=(a018*a181);
  a305=(a305*a222);
  a306=(a231*a135);
  a305=(a305-a306);
  a306=(a305/a225);
  a307=(a137*a181);
  a307=(a307*a218);
  a135=(a235*a135);
  a307=(a307+a135);
  a305=(a236*a305);
  a307=(a307-a305);
  a307=(a307/a234);
  a305=(a236*a307);
  a306=(a306-a305);
  a305=(a231*a306);
  a153=(a153-a305);
  a305=(a235*a307);
  a153=(a153+a305);
  a305=(a153*a046);
  a222=(a018*a222);
  a219=(a219-a181);
  a222=(a222*a219);
  a229=(a222/a229);
  a219=(a231*a222);
  a219=(a015+a219);
  a225=(a219/a225);
  a222=(a235*a222);
  a219=(a236*a219);
  a222=(a222+a219);
  a222=(a222/a234);
  a236=(a236*a222);
  a225=(a225+a236);
  a231=(a231*a225);
  a229=(a229+a231);
  a235=(a235*a222);
  a229=(a229+a235);
  a235=(a176*a068);
  a231=(a183*a101);
  a235=(a235+a231);
  a231=(a184*a148);
  a235=(a235+a231);
  a231=(a185*a174);
  a235=(a235+a231);
  a231=(a186*a202);
  a235=(a235+a231);
  a231=(a130*a162);
  a236=(a198*a179);
  a231=(a231+a236);
  a236=(a188*a161);
  a231=(a231+a236);
  a236=(a302*a269);
  a234=(a196*a206);
  a236=(a236-a234);
  a231=(a231+a236);
  a236=(a187*a231);
  a235=(a235+a236);
  a235=(a037+a235);
  a236=(a229*a235);
  a305=(a305+a236);
  a226=(a226+a305);
  a305=(a216*a226);
  a301=(a301+a305);
  a301=(a010+a301);
  a305=(a199*a301);
  a260=(a260+a305);
  a305=(a233*a220);
  a236=(a240*a059);
  a305=(a305+a236);
  a236=(a241*a118);
  a305=(a305+a236);
  a236=(a242*a143);
  a305=(a305+a236);
  a236=(a243*a169);
  a305=(a305+a236);
  a236=(a244*a197);
  a305=(a305+a236);
  a236=(a245*a226);
  a305=(a305+a236);
  a236=(a008*a252);
  a253=(a249*a253);
  a236=(a236*a253);
  a236=(a248-a236);
  a236=(a236-a256);
  a256=(a265*a236);
  a256=(a256-a267);
  a267=(a261*a236);
  a262=(a262-a267);
  a267=(a266*a262);
  a256=(a256-a267);
  a256=(a256/a264);
  a267=(a256*a034);
  a267=(a267*a248);
  a267=(a247-a267);
  a254=cos(a254);
  a234=(a254-a247);
  a234=(a008*a234);
  a267=(a267-a234);
  a234=(a267/a259);
  a219=(a008*a254);
  a181=(a261*a267);
  a219=(a219-a181);
  a181=(a219/a255);
  a267=(a265*a267);
  a236=(a236/a259);
  a262=(a262/a255);
  a135=(a266*a256);
  a262=(a262-a135);
  a135=(a261*a262);
  a236=(a236-a135);
  a256=(a265*a256);
  a236=(a236+a256);
  a256=(a236*a248);
  a247=(a247*a209);
  a247=(a247*a209);
  a256=(a256+a247);
  a256=(a034*a256);
  a267=(a267-a256);
  a219=(a266*a219);
  a267=(a267-a219);
  a267=(a267/a264);
  a219=(a266*a267);
  a181=(a181-a219);
  a219=(a261*a181);
  a234=(a234-a219);
  a219=(a265*a267);
  a234=(a234+a219);
  a219=(a204*a010);
  a256=(a211*a043);
  a219=(a219+a256);
  a256=(a212*a074);
  a219=(a219+a256);
  a256=(a213*a251);
  a219=(a219+a256);
  a256=(a214*a027);
  a219=(a219+a256);
  a256=(a215*a269);
  a219=(a219+a256);
  a256=(a216*a046);
  a219=(a219+a256);
  a219=(a071+a219);
  a256=(a234*a219);
  a262=(a262*a252);
  a247=(2.*a236);
  a247=(a247*a252);
  a262=(a262-a247);
  a262=(a262+a254);
  a253=(a257*a253);
  a262=(a262-a253);
  a262=(a008*a262);
  a253=(a262/a259);
  a236=(a236*a252);
  a236=(a236-a254);
  a257=(a257*a209);
  a257=(a257*a209);
  a236=(a236+a257);
  a236=(a008*a236);
  a236=(a236-a031);
  a257=(a261*a262);
  a236=(a236-a257);
  a257=(a236/a255);
  a262=(a265*a262);
  a236=(a266*a236);
  a262=(a262-a236);
  a262=(a262/a264);
  a236=(a266*a262);
  a257=(a257-a236);
  a236=(a261*a257);
  a253=(a253-a236);
  a236=(a265*a262);
  a253=(a253+a236);
  a236=(a204*a037);
  a254=(a211*a105);
  a236=(a236+a254);
  a254=(a212*a127);
  a236=(a236+a254);
  a254=(a213*a152);
  a236=(a236+a254);
  a254=(a214*a178);
  a236=(a236+a254);
  a254=(a215*a206);
  a236=(a236+a254);
  a254=(a216*a235);
  a236=(a236+a254);
  a236=(a279+a236);
  a254=(a253*a236);
  a256=(a256+a254);
  a254=(a040/a264);
  a247=(a266*a254);
  a135=(a261*a247);
  a218=(a265*a254);
  a135=(a135+a218);
  a218=(a204*a138);
  a308=(a211*a050);
  a218=(a218+a308);
  a308=(a212*a111);
  a218=(a218+a308);
  a308=(a213*a077);
  a218=(a218+a308);
  a308=(a214*a300);
  a218=(a218+a308);
  a308=(a215*a304);
  a218=(a218+a308);
  a308=(a176*a055);
  a309=(a183*a036);
  a308=(a308+a309);
  a309=(a184*a104);
  a308=(a308+a309);
  a309=(a185*a126);
  a308=(a308+a309);
  a309=(a186*a136);
  a308=(a308+a309);
  a162=(a208*a162);
  a179=(a203*a179);
  a162=(a162+a179);
  a161=(a195*a161);
  a162=(a162-a161);
  a161=(a303*a269);
  a179=(a193*a206);
  a161=(a161+a179);
  a162=(a162+a161);
  a161=(a187*a162);
  a308=(a308+a161);
  a308=(a138+a308);
  a161=(a216*a308);
  a218=(a218+a161);
  a218=(a163+a218);
  a161=(a135*a218);
  a256=(a256-a161);
  a161=(a033*a249);
  a161=(a161*a252);
  a179=(a161/a259);
  a309=(a018*a209);
  a309=(a309*a252);
  a310=(a261*a161);
  a309=(a309-a310);
  a310=(a309/a255);
  a311=(a137*a209);
  a311=(a311*a248);
  a161=(a265*a161);
  a311=(a311+a161);
  a309=(a266*a309);
  a311=(a311-a309);
  a311=(a311/a264);
  a309=(a266*a311);
  a310=(a310-a309);
  a309=(a261*a310);
  a179=(a179-a309);
  a309=(a265*a311);
  a179=(a179+a309);
  a309=(a179*a301);
  a252=(a018*a252);
  a249=(a249-a209);
  a252=(a252*a249);
  a259=(a252/a259);
  a249=(a261*a252);
  a249=(a015+a249);
  a255=(a249/a255);
  a252=(a265*a252);
  a249=(a266*a249);
  a252=(a252+a249);
  a252=(a252/a264);
  a266=(a266*a252);
  a255=(a255+a266);
  a261=(a261*a255);
  a259=(a259+a261);
  a265=(a265*a252);
  a259=(a259+a265);
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
  a261=(a155*a190);
  a266=(a227*a207);
  a261=(a261+a266);
  a266=(a217*a189);
  a261=(a261+a266);
  a266=(a306*a046);
  a264=(a225*a235);
  a266=(a266-a264);
  a261=(a261+a266);
  a266=(a216*a261);
  a265=(a265+a266);
  a265=(a037+a265);
  a266=(a259*a265);
  a309=(a309+a266);
  a256=(a256+a309);
  a309=(a246*a256);
  a305=(a305+a309);
  a305=(a010+a305);
  a309=(a228*a305);
  a260=(a260+a309);
  a309=(a263*a220);
  a059=(a270*a059);
  a309=(a309+a059);
  a118=(a100*a118);
  a309=(a309+a118);
  a118=(a122*a143);
  a309=(a309+a118);
  a118=(a271*a169);
  a309=(a309+a118);
  a118=(a272*a197);
  a309=(a309+a118);
  a118=(a273*a226);
  a309=(a309+a118);
  a118=(a274*a256);
  a309=(a309+a118);
  a118=(a008*a281);
  a282=(a278*a282);
  a118=(a118*a282);
  a118=(a277-a118);
  a118=(a118-a285);
  a285=(a294*a118);
  a285=(a285-a296);
  a296=(a290*a118);
  a291=(a291-a296);
  a296=(a295*a291);
  a285=(a285-a296);
  a285=(a285/a293);
  a296=(a285*a034);
  a296=(a296*a277);
  a296=(a276-a296);
  a283=cos(a283);
  a059=(a283-a276);
  a059=(a008*a059);
  a296=(a296-a059);
  a059=(a296/a288);
  a266=(a008*a283);
  a264=(a290*a296);
  a266=(a266-a264);
  a264=(a266/a284);
  a296=(a294*a296);
  a118=(a118/a288);
  a291=(a291/a284);
  a249=(a295*a285);
  a291=(a291-a249);
  a249=(a290*a291);
  a118=(a118-a249);
  a285=(a294*a285);
  a118=(a118+a285);
  a285=(a118*a277);
  a276=(a276*a238);
  a276=(a276*a238);
  a285=(a285+a276);
  a285=(a034*a285);
  a296=(a296-a285);
  a266=(a295*a266);
  a296=(a296-a266);
  a296=(a296/a293);
  a266=(a295*a296);
  a264=(a264-a266);
  a266=(a290*a264);
  a059=(a059-a266);
  a266=(a294*a296);
  a059=(a059+a266);
  a266=(a233*a010);
  a285=(a240*a043);
  a266=(a266+a285);
  a285=(a241*a074);
  a266=(a266+a285);
  a285=(a242*a251);
  a266=(a266+a285);
  a285=(a243*a027);
  a266=(a266+a285);
  a285=(a244*a269);
  a266=(a266+a285);
  a285=(a245*a046);
  a266=(a266+a285);
  a285=(a246*a301);
  a266=(a266+a285);
  a266=(a071+a266);
  a285=(a059*a266);
  a291=(a291*a281);
  a276=(2.*a118);
  a276=(a276*a281);
  a291=(a291-a276);
  a291=(a291+a283);
  a282=(a286*a282);
  a291=(a291-a282);
  a291=(a008*a291);
  a282=(a291/a288);
  a118=(a118*a281);
  a118=(a118-a283);
  a286=(a286*a238);
  a286=(a286*a238);
  a118=(a118+a286);
  a118=(a008*a118);
  a118=(a118-a031);
  a286=(a290*a291);
  a118=(a118-a286);
  a286=(a118/a284);
  a291=(a294*a291);
  a118=(a295*a118);
  a291=(a291-a118);
  a291=(a291/a293);
  a118=(a295*a291);
  a286=(a286-a118);
  a118=(a290*a286);
  a282=(a282-a118);
  a118=(a294*a291);
  a282=(a282+a118);
  a118=(a233*a037);
  a283=(a240*a105);
  a118=(a118+a283);
  a283=(a241*a127);
  a118=(a118+a283);
  a283=(a242*a152);
  a118=(a118+a283);
  a283=(a243*a178);
  a118=(a118+a283);
  a283=(a244*a206);
  a118=(a118+a283);
  a283=(a245*a235);
  a118=(a118+a283);
  a283=(a246*a265);
  a118=(a118+a283);
  a118=(a279+a118);
  a283=(a282*a118);
  a285=(a285+a283);
  a283=(a040/a293);
  a276=(a295*a283);
  a249=(a290*a276);
  a209=(a294*a283);
  a249=(a249+a209);
  a209=(a233*a138);
  a161=(a240*a050);
  a209=(a209+a161);
  a161=(a241*a111);
  a209=(a209+a161);
  a161=(a242*a077);
  a209=(a209+a161);
  a161=(a243*a300);
  a209=(a209+a161);
  a161=(a244*a304);
  a209=(a209+a161);
  a161=(a245*a308);
  a209=(a209+a161);
  a161=(a204*a055);
  a248=(a211*a036);
  a161=(a161+a248);
  a248=(a212*a104);
  a161=(a161+a248);
  a248=(a213*a126);
  a161=(a161+a248);
  a248=(a214*a136);
  a161=(a161+a248);
  a248=(a215*a162);
  a161=(a161+a248);
  a190=(a237*a190);
  a207=(a232*a207);
  a190=(a190+a207);
  a189=(a224*a189);
  a190=(a190-a189);
  a189=(a307*a046);
  a207=(a222*a235);
  a189=(a189+a207);
  a190=(a190+a189);
  a189=(a216*a190);
  a161=(a161+a189);
  a161=(a138+a161);
  a189=(a246*a161);
  a209=(a209+a189);
  a209=(a163+a209);
  a189=(a249*a209);
  a285=(a285-a189);
  a189=(a033*a278);
  a189=(a189*a281);
  a207=(a189/a288);
  a248=(a018*a238);
  a248=(a248*a281);
  a312=(a290*a189);
  a248=(a248-a312);
  a312=(a248/a284);
  a313=(a137*a238);
  a313=(a313*a277);
  a189=(a294*a189);
  a313=(a313+a189);
  a248=(a295*a248);
  a313=(a313-a248);
  a313=(a313/a293);
  a248=(a295*a313);
  a312=(a312-a248);
  a248=(a290*a312);
  a207=(a207-a248);
  a248=(a294*a313);
  a207=(a207+a248);
  a248=(a207*a305);
  a281=(a018*a281);
  a278=(a278-a238);
  a281=(a281*a278);
  a288=(a281/a288);
  a278=(a290*a281);
  a278=(a015+a278);
  a284=(a278/a284);
  a281=(a294*a281);
  a278=(a295*a278);
  a281=(a281+a278);
  a281=(a281/a293);
  a295=(a295*a281);
  a284=(a284+a295);
  a290=(a290*a284);
  a288=(a288+a290);
  a294=(a294*a281);
  a288=(a288+a294);
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
  a290=(a181*a219);
  a295=(a257*a236);
  a290=(a290+a295);
  a295=(a247*a218);
  a290=(a290+a295);
  a295=(a310*a301);
  a293=(a255*a265);
  a295=(a295-a293);
  a290=(a290+a295);
  a295=(a246*a290);
  a294=(a294+a295);
  a294=(a037+a294);
  a295=(a288*a294);
  a248=(a248+a295);
  a285=(a285+a248);
  a248=(a275*a285);
  a309=(a309+a248);
  a309=(a010+a309);
  a248=(a258*a309);
  a260=(a260+a248);
  a260=(a071+a260);
  if (res[0]!=0) res[0][6]=a260;
  a260=(a001*a037);
  a248=(a005*a152);
  a260=(a260+a248);
  a248=(a120*a178);
  a260=(a260+a248);
  a248=(a145*a206);
  a260=(a260+a248);
  a248=(a171*a235);
  a260=(a260+a248);
  a248=(a199*a265);
  a260=(a260+a248);
  a248=(a228*a294);
  a260=(a260+a248);
  a248=(a263*a068);
  a101=(a270*a101);
  a248=(a248+a101);
  a148=(a100*a148);
  a248=(a248+a148);
  a148=(a122*a174);
  a248=(a248+a148);
  a148=(a271*a202);
  a248=(a248+a148);
  a148=(a272*a231);
  a248=(a248+a148);
  a148=(a273*a261);
  a248=(a248+a148);
  a148=(a274*a290);
  a248=(a248+a148);
  a148=(a264*a266);
  a101=(a286*a118);
  a148=(a148+a101);
  a101=(a276*a209);
  a148=(a148+a101);
  a101=(a312*a305);
  a295=(a284*a294);
  a101=(a101-a295);
  a148=(a148+a101);
  a101=(a275*a148);
  a248=(a248+a101);
  a248=(a037+a248);
  a101=(a258*a248);
  a260=(a260+a101);
  a260=(a279+a260);
  if (res[0]!=0) res[0][7]=a260;
  a260=(a001*a138);
  a101=(a005*a077);
  a260=(a260+a101);
  a101=(a120*a300);
  a260=(a260+a101);
  a101=(a145*a304);
  a260=(a260+a101);
  a101=(a171*a308);
  a260=(a260+a101);
  a101=(a199*a161);
  a260=(a260+a101);
  a101=(a233*a055);
  a295=(a240*a036);
  a101=(a101+a295);
  a295=(a241*a104);
  a101=(a101+a295);
  a295=(a242*a126);
  a101=(a101+a295);
  a295=(a243*a136);
  a101=(a101+a295);
  a295=(a244*a162);
  a101=(a101+a295);
  a295=(a245*a190);
  a101=(a101+a295);
  a219=(a267*a219);
  a236=(a262*a236);
  a219=(a219+a236);
  a218=(a254*a218);
  a219=(a219-a218);
  a218=(a311*a301);
  a236=(a252*a265);
  a218=(a218+a236);
  a219=(a219+a218);
  a218=(a246*a219);
  a101=(a101+a218);
  a101=(a138+a101);
  a218=(a228*a101);
  a260=(a260+a218);
  a218=(a263*a055);
  a036=(a270*a036);
  a218=(a218+a036);
  a104=(a100*a104);
  a218=(a218+a104);
  a104=(a122*a126);
  a218=(a218+a104);
  a104=(a271*a136);
  a218=(a218+a104);
  a104=(a272*a162);
  a218=(a218+a104);
  a104=(a273*a190);
  a218=(a218+a104);
  a104=(a274*a219);
  a218=(a218+a104);
  a266=(a296*a266);
  a118=(a291*a118);
  a266=(a266+a118);
  a209=(a283*a209);
  a266=(a266-a209);
  a209=(a313*a305);
  a118=(a281*a294);
  a209=(a209+a118);
  a266=(a266+a209);
  a209=(a275*a266);
  a218=(a218+a209);
  a218=(a138+a218);
  a218=(a258*a218);
  a260=(a260+a218);
  a260=(a163+a260);
  if (res[0]!=0) res[0][8]=a260;
  a220=(a001*a220);
  a143=(a005*a143);
  a220=(a220+a143);
  a169=(a120*a169);
  a220=(a220+a169);
  a197=(a145*a197);
  a220=(a220+a197);
  a226=(a171*a226);
  a220=(a220+a226);
  a256=(a199*a256);
  a220=(a220+a256);
  a285=(a228*a285);
  a220=(a220+a285);
  a285=(a008*a230);
  a201=(a287*a201);
  a285=(a285*a201);
  a285=(a289-a285);
  a285=(a285-a004);
  a004=(a026*a285);
  a004=(a004-a028);
  a028=(a297*a285);
  a299=(a299-a028);
  a028=(a017*a299);
  a004=(a004-a028);
  a004=(a004/a025);
  a028=(a004*a034);
  a028=(a028*a289);
  a028=(a000-a028);
  a173=cos(a173);
  a256=(a173-a000);
  a256=(a008*a256);
  a028=(a028-a256);
  a256=(a028/a053);
  a226=(a008*a173);
  a197=(a297*a028);
  a226=(a226-a197);
  a197=(a226/a032);
  a028=(a026*a028);
  a285=(a285/a053);
  a299=(a299/a032);
  a169=(a017*a004);
  a299=(a299-a169);
  a169=(a297*a299);
  a285=(a285-a169);
  a004=(a026*a004);
  a285=(a285+a004);
  a004=(a285*a289);
  a000=(a000*a268);
  a000=(a000*a268);
  a004=(a004+a000);
  a034=(a034*a004);
  a028=(a028-a034);
  a226=(a017*a226);
  a028=(a028-a226);
  a028=(a028/a025);
  a226=(a017*a028);
  a197=(a197-a226);
  a226=(a297*a197);
  a256=(a256-a226);
  a226=(a026*a028);
  a256=(a256+a226);
  a226=(a263*a010);
  a043=(a270*a043);
  a226=(a226+a043);
  a074=(a100*a074);
  a226=(a226+a074);
  a251=(a122*a251);
  a226=(a226+a251);
  a027=(a271*a027);
  a226=(a226+a027);
  a269=(a272*a269);
  a226=(a226+a269);
  a046=(a273*a046);
  a226=(a226+a046);
  a301=(a274*a301);
  a226=(a226+a301);
  a305=(a275*a305);
  a226=(a226+a305);
  a071=(a071+a226);
  a226=(a256*a071);
  a299=(a299*a230);
  a305=(2.*a285);
  a305=(a305*a230);
  a299=(a299-a305);
  a299=(a299+a173);
  a201=(a083*a201);
  a299=(a299-a201);
  a299=(a008*a299);
  a201=(a299/a053);
  a285=(a285*a230);
  a285=(a285-a173);
  a083=(a083*a268);
  a083=(a083*a268);
  a285=(a285+a083);
  a008=(a008*a285);
  a008=(a008-a031);
  a031=(a297*a299);
  a008=(a008-a031);
  a031=(a008/a032);
  a299=(a026*a299);
  a008=(a017*a008);
  a299=(a299-a008);
  a299=(a299/a025);
  a008=(a017*a299);
  a031=(a031-a008);
  a008=(a297*a031);
  a201=(a201-a008);
  a008=(a026*a299);
  a201=(a201+a008);
  a008=(a263*a037);
  a105=(a270*a105);
  a008=(a008+a105);
  a127=(a100*a127);
  a008=(a008+a127);
  a152=(a122*a152);
  a008=(a008+a152);
  a178=(a271*a178);
  a008=(a008+a178);
  a206=(a272*a206);
  a008=(a008+a206);
  a235=(a273*a235);
  a008=(a008+a235);
  a265=(a274*a265);
  a008=(a008+a265);
  a294=(a275*a294);
  a008=(a008+a294);
  a279=(a279+a008);
  a008=(a201*a279);
  a226=(a226+a008);
  a040=(a040/a025);
  a008=(a017*a040);
  a294=(a297*a008);
  a265=(a026*a040);
  a294=(a294+a265);
  a265=(a263*a138);
  a050=(a270*a050);
  a265=(a265+a050);
  a111=(a100*a111);
  a265=(a265+a111);
  a077=(a122*a077);
  a265=(a265+a077);
  a300=(a271*a300);
  a265=(a265+a300);
  a304=(a272*a304);
  a265=(a265+a304);
  a308=(a273*a308);
  a265=(a265+a308);
  a161=(a274*a161);
  a265=(a265+a161);
  a101=(a275*a101);
  a265=(a265+a101);
  a163=(a163+a265);
  a265=(a294*a163);
  a226=(a226-a265);
  a033=(a033*a287);
  a033=(a033*a230);
  a265=(a033/a053);
  a101=(a018*a268);
  a101=(a101*a230);
  a161=(a297*a033);
  a101=(a101-a161);
  a161=(a101/a032);
  a137=(a137*a268);
  a137=(a137*a289);
  a033=(a026*a033);
  a137=(a137+a033);
  a101=(a017*a101);
  a137=(a137-a101);
  a137=(a137/a025);
  a101=(a017*a137);
  a161=(a161-a101);
  a101=(a297*a161);
  a265=(a265-a101);
  a101=(a026*a137);
  a265=(a265+a101);
  a101=(a265*a309);
  a018=(a018*a230);
  a287=(a287-a268);
  a018=(a018*a287);
  a053=(a018/a053);
  a287=(a297*a018);
  a015=(a015+a287);
  a032=(a015/a032);
  a018=(a026*a018);
  a015=(a017*a015);
  a018=(a018+a015);
  a018=(a018/a025);
  a017=(a017*a018);
  a032=(a032+a017);
  a297=(a297*a032);
  a053=(a053+a297);
  a026=(a026*a018);
  a053=(a053+a026);
  a026=(a053*a248);
  a101=(a101+a026);
  a226=(a226+a101);
  a226=(a258*a226);
  a220=(a220+a226);
  a010=(a010+a220);
  if (res[0]!=0) res[0][9]=a010;
  a068=(a001*a068);
  a174=(a005*a174);
  a068=(a068+a174);
  a202=(a120*a202);
  a068=(a068+a202);
  a231=(a145*a231);
  a068=(a068+a231);
  a261=(a171*a261);
  a068=(a068+a261);
  a290=(a199*a290);
  a068=(a068+a290);
  a148=(a228*a148);
  a068=(a068+a148);
  a148=(a197*a071);
  a290=(a031*a279);
  a148=(a148+a290);
  a290=(a008*a163);
  a148=(a148+a290);
  a290=(a161*a309);
  a261=(a032*a248);
  a290=(a290-a261);
  a148=(a148+a290);
  a148=(a258*a148);
  a068=(a068+a148);
  a037=(a037+a068);
  if (res[0]!=0) res[0][10]=a037;
  a055=(a001*a055);
  a126=(a005*a126);
  a055=(a055+a126);
  a136=(a120*a136);
  a055=(a055+a136);
  a162=(a145*a162);
  a055=(a055+a162);
  a190=(a171*a190);
  a055=(a055+a190);
  a219=(a199*a219);
  a055=(a055+a219);
  a266=(a228*a266);
  a055=(a055+a266);
  a071=(a028*a071);
  a279=(a299*a279);
  a071=(a071+a279);
  a163=(a040*a163);
  a071=(a071-a163);
  a309=(a137*a309);
  a248=(a018*a248);
  a309=(a309+a248);
  a071=(a071+a309);
  a071=(a258*a071);
  a055=(a055+a071);
  a138=(a138+a055);
  if (res[0]!=0) res[0][11]=a138;
  a138=arg[0]? arg[0][12] : 0;
  a055=arg[0]? arg[0][15] : 0;
  a071=(a001*a055);
  a309=(a250*a138);
  a248=arg[0]? arg[0][13] : 0;
  a163=(a013*a248);
  a309=(a309+a163);
  a163=arg[0]? arg[0][14] : 0;
  a279=(a035*a163);
  a309=(a309-a279);
  a279=(a280*a055);
  a266=arg[0]? arg[0][16] : 0;
  a219=(a021*a266);
  a279=(a279+a219);
  a309=(a309+a279);
  a279=(a006*a309);
  a219=(a042*a055);
  a190=(a045*a309);
  a162=(a048*a055);
  a162=(a138+a162);
  a136=(a003*a162);
  a126=(a048*a266);
  a126=(a248+a126);
  a037=(a056*a126);
  a136=(a136+a037);
  a037=arg[0]? arg[0][17] : 0;
  a068=(a048*a037);
  a068=(a163+a068);
  a148=(a164*a068);
  a136=(a136-a148);
  a148=(a048*a309);
  a148=(a055+a148);
  a290=(a085*a148);
  a261=(a191*a138);
  a231=(a019*a248);
  a261=(a261+a231);
  a231=(a016*a163);
  a261=(a261+a231);
  a231=(a221*a055);
  a202=(a029*a266);
  a231=(a231-a202);
  a261=(a261+a231);
  a231=(a048*a261);
  a231=(a266+a231);
  a202=(a062*a231);
  a290=(a290+a202);
  a136=(a136+a290);
  a136=(a047*a136);
  a190=(a190+a136);
  a190=(a055+a190);
  a136=(a044*a190);
  a219=(a219+a136);
  a219=(a138+a219);
  a136=(a038*a219);
  a290=(a042*a266);
  a202=(a045*a261);
  a174=(a007*a162);
  a010=(a060*a126);
  a174=(a174+a010);
  a010=(a049*a068);
  a174=(a174+a010);
  a010=(a041*a148);
  a220=(a058*a231);
  a010=(a010-a220);
  a174=(a174+a010);
  a174=(a047*a174);
  a202=(a202+a174);
  a202=(a266+a202);
  a174=(a044*a202);
  a290=(a290+a174);
  a290=(a248+a290);
  a174=(a093*a290);
  a136=(a136+a174);
  a174=(a042*a037);
  a010=(a039*a138);
  a220=(a024*a248);
  a010=(a010+a220);
  a220=(a014*a163);
  a010=(a010-a220);
  a220=(a192*a055);
  a226=(a012*a266);
  a220=(a220+a226);
  a010=(a010+a220);
  a220=(a045*a010);
  a162=(a070*a162);
  a126=(a065*a126);
  a162=(a162+a126);
  a068=(a057*a068);
  a162=(a162-a068);
  a068=(a002*a148);
  a126=(a054*a231);
  a068=(a068+a126);
  a162=(a162+a068);
  a162=(a047*a162);
  a220=(a220+a162);
  a220=(a037+a220);
  a162=(a044*a220);
  a174=(a174+a162);
  a174=(a163+a174);
  a162=(a067*a174);
  a136=(a136-a162);
  a162=(a042*a309);
  a068=(a045*a055);
  a148=(a047*a148);
  a068=(a068+a148);
  a068=(a138+a068);
  a148=(a063*a068);
  a126=(a045*a266);
  a231=(a047*a231);
  a126=(a126+a231);
  a126=(a248+a126);
  a231=(a082*a126);
  a148=(a148+a231);
  a231=(a045*a037);
  a226=(a048*a010);
  a226=(a037+a226);
  a226=(a047*a226);
  a231=(a231+a226);
  a231=(a163+a231);
  a226=(a076*a231);
  a148=(a148-a226);
  a226=(a182*a190);
  a101=(a078*a202);
  a226=(a226+a101);
  a148=(a148+a226);
  a226=(a044*a148);
  a162=(a162+a226);
  a162=(a055+a162);
  a226=(a022*a162);
  a101=(a042*a261);
  a026=(a239*a068);
  a297=(a072*a126);
  a026=(a026+a297);
  a297=(a075*a231);
  a026=(a026+a297);
  a297=(a109*a190);
  a017=(a084*a202);
  a297=(a297-a017);
  a026=(a026+a297);
  a297=(a044*a026);
  a101=(a101+a297);
  a101=(a266+a101);
  a297=(a099*a101);
  a226=(a226+a297);
  a136=(a136+a226);
  a226=(a030*a136);
  a279=(a279+a226);
  a226=(a103*a055);
  a297=(a052*a190);
  a226=(a226+a297);
  a297=(a110*a162);
  a226=(a226+a297);
  a226=(a138+a226);
  a297=(a106*a226);
  a017=(a103*a266);
  a025=(a052*a202);
  a017=(a017+a025);
  a025=(a110*a101);
  a017=(a017+a025);
  a017=(a248+a017);
  a025=(a081*a017);
  a297=(a297+a025);
  a025=(a103*a037);
  a220=(a052*a220);
  a025=(a025+a220);
  a220=(a042*a010);
  a068=(a090*a068);
  a126=(a066*a126);
  a068=(a068+a126);
  a231=(a064*a231);
  a068=(a068-a231);
  a190=(a147*a190);
  a202=(a073*a202);
  a190=(a190+a202);
  a068=(a068+a190);
  a190=(a044*a068);
  a220=(a220+a190);
  a220=(a037+a220);
  a190=(a110*a220);
  a025=(a025+a190);
  a025=(a163+a025);
  a190=(a092*a025);
  a297=(a297-a190);
  a190=(a103*a309);
  a148=(a052*a148);
  a190=(a190+a148);
  a148=(a110*a136);
  a190=(a190+a148);
  a190=(a055+a190);
  a148=(a094*a190);
  a202=(a103*a261);
  a026=(a052*a026);
  a202=(a202+a026);
  a026=(a009*a219);
  a231=(a097*a290);
  a026=(a026+a231);
  a231=(a069*a174);
  a026=(a026+a231);
  a231=(a113*a162);
  a126=(a095*a101);
  a231=(a231-a126);
  a026=(a026+a231);
  a231=(a110*a026);
  a202=(a202+a231);
  a202=(a266+a202);
  a231=(a121*a202);
  a148=(a148+a231);
  a297=(a297+a148);
  a148=(a098*a297);
  a279=(a279+a148);
  a279=(a055+a279);
  a148=(a005*a279);
  a071=(a071+a148);
  a148=(a125*a309);
  a231=(a131*a136);
  a148=(a148+a231);
  a231=(a132*a297);
  a148=(a148+a231);
  a231=(a006*a055);
  a126=(a030*a162);
  a231=(a231+a126);
  a126=(a098*a190);
  a231=(a231+a126);
  a231=(a138+a231);
  a126=(a128*a231);
  a015=(a006*a266);
  a287=(a030*a101);
  a015=(a015+a287);
  a287=(a098*a202);
  a015=(a015+a287);
  a015=(a248+a015);
  a287=(a140*a015);
  a126=(a126+a287);
  a287=(a006*a037);
  a268=(a030*a220);
  a287=(a287+a268);
  a268=(a103*a010);
  a068=(a052*a068);
  a268=(a268+a068);
  a219=(a107*a219);
  a290=(a102*a290);
  a219=(a219+a290);
  a174=(a292*a174);
  a219=(a219-a174);
  a174=(a298*a162);
  a290=(a091*a101);
  a174=(a174+a290);
  a219=(a219+a174);
  a174=(a110*a219);
  a268=(a268+a174);
  a268=(a037+a268);
  a174=(a098*a268);
  a287=(a287+a174);
  a287=(a163+a287);
  a174=(a115*a287);
  a126=(a126-a174);
  a174=(a023*a279);
  a290=(a006*a261);
  a068=(a030*a026);
  a290=(a290+a068);
  a068=(a061*a226);
  a230=(a119*a017);
  a068=(a068+a230);
  a230=(a108*a025);
  a068=(a068+a230);
  a230=(a011*a190);
  a033=(a117*a202);
  a230=(a230-a033);
  a068=(a068+a230);
  a230=(a098*a068);
  a290=(a290+a230);
  a290=(a266+a290);
  a230=(a146*a290);
  a174=(a174+a230);
  a126=(a126+a174);
  a174=(a133*a126);
  a148=(a148+a174);
  a148=(a055+a148);
  a174=(a120*a148);
  a071=(a071+a174);
  a174=(a150*a309);
  a230=(a089*a136);
  a174=(a174+a230);
  a230=(a157*a297);
  a174=(a174+a230);
  a230=(a158*a126);
  a174=(a174+a230);
  a230=(a125*a055);
  a033=(a131*a162);
  a230=(a230+a033);
  a033=(a132*a190);
  a230=(a230+a033);
  a033=(a133*a279);
  a230=(a230+a033);
  a230=(a138+a230);
  a033=(a151*a230);
  a289=(a125*a266);
  a308=(a131*a101);
  a289=(a289+a308);
  a308=(a132*a202);
  a289=(a289+a308);
  a308=(a133*a290);
  a289=(a289+a308);
  a289=(a248+a289);
  a308=(a166*a289);
  a033=(a033+a308);
  a308=(a125*a037);
  a304=(a131*a220);
  a308=(a308+a304);
  a304=(a132*a268);
  a308=(a308+a304);
  a304=(a006*a010);
  a300=(a030*a219);
  a304=(a304+a300);
  a226=(a129*a226);
  a017=(a124*a017);
  a226=(a226+a017);
  a025=(a116*a025);
  a226=(a226-a025);
  a025=(a079*a190);
  a017=(a114*a202);
  a025=(a025+a017);
  a226=(a226+a025);
  a025=(a098*a226);
  a304=(a304+a025);
  a304=(a037+a304);
  a025=(a133*a304);
  a308=(a308+a025);
  a308=(a163+a308);
  a025=(a051*a308);
  a033=(a033-a025);
  a025=(a156*a148);
  a017=(a125*a261);
  a300=(a131*a026);
  a017=(a017+a300);
  a300=(a132*a068);
  a017=(a017+a300);
  a300=(a112*a231);
  a077=(a144*a015);
  a300=(a300+a077);
  a077=(a134*a287);
  a300=(a300+a077);
  a077=(a088*a279);
  a111=(a142*a290);
  a077=(a077-a111);
  a300=(a300+a077);
  a077=(a133*a300);
  a017=(a017+a077);
  a017=(a266+a017);
  a077=(a172*a017);
  a025=(a025+a077);
  a033=(a033+a025);
  a025=(a159*a033);
  a174=(a174+a025);
  a174=(a055+a174);
  a025=(a145*a174);
  a071=(a071+a025);
  a025=(a176*a309);
  a077=(a183*a136);
  a025=(a025+a077);
  a077=(a184*a297);
  a025=(a025+a077);
  a077=(a185*a126);
  a025=(a025+a077);
  a077=(a186*a033);
  a025=(a025+a077);
  a077=(a150*a055);
  a111=(a089*a162);
  a077=(a077+a111);
  a111=(a157*a190);
  a077=(a077+a111);
  a111=(a158*a279);
  a077=(a077+a111);
  a111=(a159*a148);
  a077=(a077+a111);
  a077=(a138+a077);
  a111=(a177*a077);
  a050=(a150*a266);
  a235=(a089*a101);
  a050=(a050+a235);
  a235=(a157*a202);
  a050=(a050+a235);
  a235=(a158*a290);
  a050=(a050+a235);
  a235=(a159*a017);
  a050=(a050+a235);
  a050=(a248+a050);
  a235=(a194*a050);
  a111=(a111+a235);
  a235=(a150*a037);
  a206=(a089*a220);
  a235=(a235+a206);
  a206=(a157*a268);
  a235=(a235+a206);
  a206=(a158*a304);
  a235=(a235+a206);
  a206=(a125*a010);
  a178=(a131*a219);
  a206=(a206+a178);
  a178=(a132*a226);
  a206=(a206+a178);
  a231=(a154*a231);
  a015=(a149*a015);
  a231=(a231+a015);
  a287=(a141*a287);
  a231=(a231-a287);
  a287=(a086*a279);
  a015=(a139*a290);
  a287=(a287+a015);
  a231=(a231+a287);
  a287=(a133*a231);
  a206=(a206+a287);
  a206=(a037+a206);
  a287=(a159*a206);
  a235=(a235+a287);
  a235=(a163+a235);
  a287=(a087*a235);
  a111=(a111-a287);
  a287=(a123*a174);
  a015=(a150*a261);
  a178=(a089*a026);
  a015=(a015+a178);
  a178=(a157*a068);
  a015=(a015+a178);
  a178=(a158*a300);
  a015=(a015+a178);
  a178=(a020*a230);
  a152=(a170*a289);
  a178=(a178+a152);
  a152=(a160*a308);
  a178=(a178+a152);
  a152=(a210*a148);
  a127=(a168*a017);
  a152=(a152-a127);
  a178=(a178+a152);
  a152=(a159*a178);
  a015=(a015+a152);
  a015=(a266+a015);
  a152=(a200*a015);
  a287=(a287+a152);
  a111=(a111+a287);
  a287=(a187*a111);
  a025=(a025+a287);
  a025=(a055+a025);
  a287=(a171*a025);
  a071=(a071+a287);
  a287=(a204*a309);
  a152=(a211*a136);
  a287=(a287+a152);
  a152=(a212*a297);
  a287=(a287+a152);
  a152=(a213*a126);
  a287=(a287+a152);
  a152=(a214*a033);
  a287=(a287+a152);
  a152=(a215*a111);
  a287=(a287+a152);
  a152=(a176*a055);
  a127=(a183*a162);
  a152=(a152+a127);
  a127=(a184*a190);
  a152=(a152+a127);
  a127=(a185*a279);
  a152=(a152+a127);
  a127=(a186*a148);
  a152=(a152+a127);
  a127=(a187*a174);
  a152=(a152+a127);
  a152=(a138+a152);
  a127=(a205*a152);
  a105=(a176*a266);
  a285=(a183*a101);
  a105=(a105+a285);
  a285=(a184*a202);
  a105=(a105+a285);
  a285=(a185*a290);
  a105=(a105+a285);
  a285=(a186*a017);
  a105=(a105+a285);
  a285=(a187*a015);
  a105=(a105+a285);
  a105=(a248+a105);
  a285=(a223*a105);
  a127=(a127+a285);
  a285=(a176*a037);
  a083=(a183*a220);
  a285=(a285+a083);
  a083=(a184*a268);
  a285=(a285+a083);
  a083=(a185*a304);
  a285=(a285+a083);
  a083=(a186*a206);
  a285=(a285+a083);
  a083=(a150*a010);
  a173=(a089*a219);
  a083=(a083+a173);
  a173=(a157*a226);
  a083=(a083+a173);
  a173=(a158*a231);
  a083=(a083+a173);
  a230=(a180*a230);
  a289=(a175*a289);
  a230=(a230+a289);
  a308=(a167*a308);
  a230=(a230-a308);
  a308=(a080*a148);
  a289=(a165*a017);
  a308=(a308+a289);
  a230=(a230+a308);
  a308=(a159*a230);
  a083=(a083+a308);
  a083=(a037+a083);
  a308=(a187*a083);
  a285=(a285+a308);
  a285=(a163+a285);
  a308=(a096*a285);
  a127=(a127-a308);
  a308=(a153*a025);
  a289=(a176*a261);
  a173=(a183*a026);
  a289=(a289+a173);
  a173=(a184*a068);
  a289=(a289+a173);
  a173=(a185*a300);
  a289=(a289+a173);
  a173=(a186*a178);
  a289=(a289+a173);
  a173=(a130*a077);
  a305=(a198*a050);
  a173=(a173+a305);
  a305=(a188*a235);
  a173=(a173+a305);
  a305=(a302*a174);
  a301=(a196*a015);
  a305=(a305-a301);
  a173=(a173+a305);
  a305=(a187*a173);
  a289=(a289+a305);
  a289=(a266+a289);
  a305=(a229*a289);
  a308=(a308+a305);
  a127=(a127+a308);
  a308=(a216*a127);
  a287=(a287+a308);
  a287=(a055+a287);
  a308=(a199*a287);
  a071=(a071+a308);
  a308=(a233*a309);
  a305=(a240*a136);
  a308=(a308+a305);
  a305=(a241*a297);
  a308=(a308+a305);
  a305=(a242*a126);
  a308=(a308+a305);
  a305=(a243*a033);
  a308=(a308+a305);
  a305=(a244*a111);
  a308=(a308+a305);
  a305=(a245*a127);
  a308=(a308+a305);
  a305=(a204*a055);
  a301=(a211*a162);
  a305=(a305+a301);
  a301=(a212*a190);
  a305=(a305+a301);
  a301=(a213*a279);
  a305=(a305+a301);
  a301=(a214*a148);
  a305=(a305+a301);
  a301=(a215*a174);
  a305=(a305+a301);
  a301=(a216*a025);
  a305=(a305+a301);
  a305=(a138+a305);
  a301=(a234*a305);
  a046=(a204*a266);
  a269=(a211*a101);
  a046=(a046+a269);
  a269=(a212*a202);
  a046=(a046+a269);
  a269=(a213*a290);
  a046=(a046+a269);
  a269=(a214*a017);
  a046=(a046+a269);
  a269=(a215*a015);
  a046=(a046+a269);
  a269=(a216*a289);
  a046=(a046+a269);
  a046=(a248+a046);
  a269=(a253*a046);
  a301=(a301+a269);
  a269=(a204*a037);
  a027=(a211*a220);
  a269=(a269+a027);
  a027=(a212*a268);
  a269=(a269+a027);
  a027=(a213*a304);
  a269=(a269+a027);
  a027=(a214*a206);
  a269=(a269+a027);
  a027=(a215*a083);
  a269=(a269+a027);
  a027=(a176*a010);
  a251=(a183*a219);
  a027=(a027+a251);
  a251=(a184*a226);
  a027=(a027+a251);
  a251=(a185*a231);
  a027=(a027+a251);
  a251=(a186*a230);
  a027=(a027+a251);
  a077=(a208*a077);
  a050=(a203*a050);
  a077=(a077+a050);
  a235=(a195*a235);
  a077=(a077-a235);
  a235=(a303*a174);
  a050=(a193*a015);
  a235=(a235+a050);
  a077=(a077+a235);
  a235=(a187*a077);
  a027=(a027+a235);
  a027=(a037+a027);
  a235=(a216*a027);
  a269=(a269+a235);
  a269=(a163+a269);
  a235=(a135*a269);
  a301=(a301-a235);
  a235=(a179*a287);
  a050=(a204*a261);
  a251=(a211*a026);
  a050=(a050+a251);
  a251=(a212*a068);
  a050=(a050+a251);
  a251=(a213*a300);
  a050=(a050+a251);
  a251=(a214*a178);
  a050=(a050+a251);
  a251=(a215*a173);
  a050=(a050+a251);
  a251=(a155*a152);
  a074=(a227*a105);
  a251=(a251+a074);
  a074=(a217*a285);
  a251=(a251+a074);
  a074=(a306*a025);
  a043=(a225*a289);
  a074=(a074-a043);
  a251=(a251+a074);
  a074=(a216*a251);
  a050=(a050+a074);
  a050=(a266+a050);
  a074=(a259*a050);
  a235=(a235+a074);
  a301=(a301+a235);
  a235=(a246*a301);
  a308=(a308+a235);
  a308=(a055+a308);
  a235=(a228*a308);
  a071=(a071+a235);
  a235=(a263*a309);
  a136=(a270*a136);
  a235=(a235+a136);
  a297=(a100*a297);
  a235=(a235+a297);
  a297=(a122*a126);
  a235=(a235+a297);
  a297=(a271*a033);
  a235=(a235+a297);
  a297=(a272*a111);
  a235=(a235+a297);
  a297=(a273*a127);
  a235=(a235+a297);
  a297=(a274*a301);
  a235=(a235+a297);
  a297=(a233*a055);
  a136=(a240*a162);
  a297=(a297+a136);
  a136=(a241*a190);
  a297=(a297+a136);
  a136=(a242*a279);
  a297=(a297+a136);
  a136=(a243*a148);
  a297=(a297+a136);
  a136=(a244*a174);
  a297=(a297+a136);
  a136=(a245*a025);
  a297=(a297+a136);
  a136=(a246*a287);
  a297=(a297+a136);
  a297=(a138+a297);
  a136=(a059*a297);
  a074=(a233*a266);
  a043=(a240*a101);
  a074=(a074+a043);
  a043=(a241*a202);
  a074=(a074+a043);
  a043=(a242*a290);
  a074=(a074+a043);
  a043=(a243*a017);
  a074=(a074+a043);
  a043=(a244*a015);
  a074=(a074+a043);
  a043=(a245*a289);
  a074=(a074+a043);
  a043=(a246*a050);
  a074=(a074+a043);
  a074=(a248+a074);
  a043=(a282*a074);
  a136=(a136+a043);
  a043=(a233*a037);
  a034=(a240*a220);
  a043=(a043+a034);
  a034=(a241*a268);
  a043=(a043+a034);
  a034=(a242*a304);
  a043=(a043+a034);
  a034=(a243*a206);
  a043=(a043+a034);
  a034=(a244*a083);
  a043=(a043+a034);
  a034=(a245*a027);
  a043=(a043+a034);
  a034=(a204*a010);
  a004=(a211*a219);
  a034=(a034+a004);
  a004=(a212*a226);
  a034=(a034+a004);
  a004=(a213*a231);
  a034=(a034+a004);
  a004=(a214*a230);
  a034=(a034+a004);
  a004=(a215*a077);
  a034=(a034+a004);
  a152=(a237*a152);
  a105=(a232*a105);
  a152=(a152+a105);
  a285=(a224*a285);
  a152=(a152-a285);
  a285=(a307*a025);
  a105=(a222*a289);
  a285=(a285+a105);
  a152=(a152+a285);
  a285=(a216*a152);
  a034=(a034+a285);
  a034=(a037+a034);
  a285=(a246*a034);
  a043=(a043+a285);
  a043=(a163+a043);
  a285=(a249*a043);
  a136=(a136-a285);
  a285=(a207*a308);
  a105=(a233*a261);
  a004=(a240*a026);
  a105=(a105+a004);
  a004=(a241*a068);
  a105=(a105+a004);
  a004=(a242*a300);
  a105=(a105+a004);
  a004=(a243*a178);
  a105=(a105+a004);
  a004=(a244*a173);
  a105=(a105+a004);
  a004=(a245*a251);
  a105=(a105+a004);
  a004=(a181*a305);
  a000=(a257*a046);
  a004=(a004+a000);
  a000=(a247*a269);
  a004=(a004+a000);
  a000=(a310*a287);
  a169=(a255*a050);
  a000=(a000-a169);
  a004=(a004+a000);
  a000=(a246*a004);
  a105=(a105+a000);
  a105=(a266+a105);
  a000=(a288*a105);
  a285=(a285+a000);
  a136=(a136+a285);
  a285=(a275*a136);
  a235=(a235+a285);
  a235=(a055+a235);
  a285=(a258*a235);
  a071=(a071+a285);
  a071=(a138+a071);
  if (res[0]!=0) res[0][12]=a071;
  a071=(a001*a266);
  a285=(a005*a290);
  a071=(a071+a285);
  a285=(a120*a017);
  a071=(a071+a285);
  a285=(a145*a015);
  a071=(a071+a285);
  a285=(a171*a289);
  a071=(a071+a285);
  a285=(a199*a050);
  a071=(a071+a285);
  a285=(a228*a105);
  a071=(a071+a285);
  a285=(a263*a261);
  a026=(a270*a026);
  a285=(a285+a026);
  a068=(a100*a068);
  a285=(a285+a068);
  a068=(a122*a300);
  a285=(a285+a068);
  a068=(a271*a178);
  a285=(a285+a068);
  a068=(a272*a173);
  a285=(a285+a068);
  a068=(a273*a251);
  a285=(a285+a068);
  a068=(a274*a004);
  a285=(a285+a068);
  a068=(a264*a297);
  a026=(a286*a074);
  a068=(a068+a026);
  a026=(a276*a043);
  a068=(a068+a026);
  a026=(a312*a308);
  a000=(a284*a105);
  a026=(a026-a000);
  a068=(a068+a026);
  a026=(a275*a068);
  a285=(a285+a026);
  a285=(a266+a285);
  a026=(a258*a285);
  a071=(a071+a026);
  a071=(a248+a071);
  if (res[0]!=0) res[0][13]=a071;
  a071=(a001*a037);
  a026=(a005*a304);
  a071=(a071+a026);
  a026=(a120*a206);
  a071=(a071+a026);
  a026=(a145*a083);
  a071=(a071+a026);
  a026=(a171*a027);
  a071=(a071+a026);
  a026=(a199*a034);
  a071=(a071+a026);
  a026=(a233*a010);
  a000=(a240*a219);
  a026=(a026+a000);
  a000=(a241*a226);
  a026=(a026+a000);
  a000=(a242*a231);
  a026=(a026+a000);
  a000=(a243*a230);
  a026=(a026+a000);
  a000=(a244*a077);
  a026=(a026+a000);
  a000=(a245*a152);
  a026=(a026+a000);
  a305=(a267*a305);
  a046=(a262*a046);
  a305=(a305+a046);
  a269=(a254*a269);
  a305=(a305-a269);
  a269=(a311*a287);
  a046=(a252*a050);
  a269=(a269+a046);
  a305=(a305+a269);
  a269=(a246*a305);
  a026=(a026+a269);
  a026=(a037+a026);
  a269=(a228*a026);
  a071=(a071+a269);
  a269=(a263*a010);
  a219=(a270*a219);
  a269=(a269+a219);
  a226=(a100*a226);
  a269=(a269+a226);
  a226=(a122*a231);
  a269=(a269+a226);
  a226=(a271*a230);
  a269=(a269+a226);
  a226=(a272*a077);
  a269=(a269+a226);
  a226=(a273*a152);
  a269=(a269+a226);
  a226=(a274*a305);
  a269=(a269+a226);
  a297=(a296*a297);
  a074=(a291*a074);
  a297=(a297+a074);
  a043=(a283*a043);
  a297=(a297-a043);
  a043=(a313*a308);
  a074=(a281*a105);
  a043=(a043+a074);
  a297=(a297+a043);
  a043=(a275*a297);
  a269=(a269+a043);
  a269=(a037+a269);
  a269=(a258*a269);
  a071=(a071+a269);
  a071=(a163+a071);
  if (res[0]!=0) res[0][14]=a071;
  a309=(a001*a309);
  a126=(a005*a126);
  a309=(a309+a126);
  a033=(a120*a033);
  a309=(a309+a033);
  a111=(a145*a111);
  a309=(a309+a111);
  a127=(a171*a127);
  a309=(a309+a127);
  a301=(a199*a301);
  a309=(a309+a301);
  a136=(a228*a136);
  a309=(a309+a136);
  a136=(a263*a055);
  a162=(a270*a162);
  a136=(a136+a162);
  a190=(a100*a190);
  a136=(a136+a190);
  a279=(a122*a279);
  a136=(a136+a279);
  a148=(a271*a148);
  a136=(a136+a148);
  a174=(a272*a174);
  a136=(a136+a174);
  a025=(a273*a025);
  a136=(a136+a025);
  a287=(a274*a287);
  a136=(a136+a287);
  a308=(a275*a308);
  a136=(a136+a308);
  a138=(a138+a136);
  a136=(a256*a138);
  a308=(a263*a266);
  a101=(a270*a101);
  a308=(a308+a101);
  a202=(a100*a202);
  a308=(a308+a202);
  a290=(a122*a290);
  a308=(a308+a290);
  a017=(a271*a017);
  a308=(a308+a017);
  a015=(a272*a015);
  a308=(a308+a015);
  a289=(a273*a289);
  a308=(a308+a289);
  a050=(a274*a050);
  a308=(a308+a050);
  a105=(a275*a105);
  a308=(a308+a105);
  a248=(a248+a308);
  a308=(a201*a248);
  a136=(a136+a308);
  a308=(a263*a037);
  a220=(a270*a220);
  a308=(a308+a220);
  a268=(a100*a268);
  a308=(a308+a268);
  a304=(a122*a304);
  a308=(a308+a304);
  a206=(a271*a206);
  a308=(a308+a206);
  a083=(a272*a083);
  a308=(a308+a083);
  a027=(a273*a027);
  a308=(a308+a027);
  a034=(a274*a034);
  a308=(a308+a034);
  a026=(a275*a026);
  a308=(a308+a026);
  a163=(a163+a308);
  a308=(a294*a163);
  a136=(a136-a308);
  a308=(a265*a235);
  a026=(a053*a285);
  a308=(a308+a026);
  a136=(a136+a308);
  a136=(a258*a136);
  a309=(a309+a136);
  a055=(a055+a309);
  if (res[0]!=0) res[0][15]=a055;
  a261=(a001*a261);
  a300=(a005*a300);
  a261=(a261+a300);
  a178=(a120*a178);
  a261=(a261+a178);
  a173=(a145*a173);
  a261=(a261+a173);
  a251=(a171*a251);
  a261=(a261+a251);
  a004=(a199*a004);
  a261=(a261+a004);
  a068=(a228*a068);
  a261=(a261+a068);
  a068=(a197*a138);
  a004=(a031*a248);
  a068=(a068+a004);
  a004=(a008*a163);
  a068=(a068+a004);
  a004=(a161*a235);
  a251=(a032*a285);
  a004=(a004-a251);
  a068=(a068+a004);
  a068=(a258*a068);
  a261=(a261+a068);
  a266=(a266+a261);
  if (res[0]!=0) res[0][16]=a266;
  a010=(a001*a010);
  a231=(a005*a231);
  a010=(a010+a231);
  a230=(a120*a230);
  a010=(a010+a230);
  a077=(a145*a077);
  a010=(a010+a077);
  a152=(a171*a152);
  a010=(a010+a152);
  a305=(a199*a305);
  a010=(a010+a305);
  a297=(a228*a297);
  a010=(a010+a297);
  a138=(a028*a138);
  a248=(a299*a248);
  a138=(a138+a248);
  a163=(a040*a163);
  a138=(a138-a163);
  a235=(a137*a235);
  a285=(a018*a285);
  a235=(a235+a285);
  a138=(a138+a235);
  a138=(a258*a138);
  a010=(a010+a138);
  a037=(a037+a010);
  if (res[0]!=0) res[0][17]=a037;
  a037=arg[0]? arg[0][18] : 0;
  a010=arg[0]? arg[0][21] : 0;
  a138=(a001*a010);
  a235=(a250*a037);
  a285=arg[0]? arg[0][19] : 0;
  a163=(a013*a285);
  a235=(a235+a163);
  a163=arg[0]? arg[0][20] : 0;
  a248=(a035*a163);
  a235=(a235-a248);
  a248=(a280*a010);
  a297=arg[0]? arg[0][22] : 0;
  a305=(a021*a297);
  a248=(a248+a305);
  a235=(a235+a248);
  a248=(a006*a235);
  a305=(a042*a010);
  a152=(a045*a235);
  a077=(a048*a010);
  a077=(a037+a077);
  a230=(a003*a077);
  a231=(a048*a297);
  a231=(a285+a231);
  a266=(a056*a231);
  a230=(a230+a266);
  a266=arg[0]? arg[0][23] : 0;
  a261=(a048*a266);
  a261=(a163+a261);
  a068=(a164*a261);
  a230=(a230-a068);
  a068=(a048*a235);
  a068=(a010+a068);
  a004=(a085*a068);
  a251=(a191*a037);
  a173=(a019*a285);
  a251=(a251+a173);
  a173=(a016*a163);
  a251=(a251+a173);
  a173=(a221*a010);
  a178=(a029*a297);
  a173=(a173-a178);
  a251=(a251+a173);
  a173=(a048*a251);
  a173=(a297+a173);
  a178=(a062*a173);
  a004=(a004+a178);
  a230=(a230+a004);
  a230=(a047*a230);
  a152=(a152+a230);
  a152=(a010+a152);
  a230=(a044*a152);
  a305=(a305+a230);
  a305=(a037+a305);
  a230=(a038*a305);
  a004=(a042*a297);
  a178=(a045*a251);
  a300=(a007*a077);
  a055=(a060*a231);
  a300=(a300+a055);
  a055=(a049*a261);
  a300=(a300+a055);
  a055=(a041*a068);
  a309=(a058*a173);
  a055=(a055-a309);
  a300=(a300+a055);
  a300=(a047*a300);
  a178=(a178+a300);
  a178=(a297+a178);
  a300=(a044*a178);
  a004=(a004+a300);
  a004=(a285+a004);
  a300=(a093*a004);
  a230=(a230+a300);
  a300=(a042*a266);
  a055=(a039*a037);
  a309=(a024*a285);
  a055=(a055+a309);
  a309=(a014*a163);
  a055=(a055-a309);
  a309=(a192*a010);
  a136=(a012*a297);
  a309=(a309+a136);
  a055=(a055+a309);
  a309=(a045*a055);
  a077=(a070*a077);
  a231=(a065*a231);
  a077=(a077+a231);
  a261=(a057*a261);
  a077=(a077-a261);
  a261=(a002*a068);
  a231=(a054*a173);
  a261=(a261+a231);
  a077=(a077+a261);
  a077=(a047*a077);
  a309=(a309+a077);
  a309=(a266+a309);
  a077=(a044*a309);
  a300=(a300+a077);
  a300=(a163+a300);
  a077=(a067*a300);
  a230=(a230-a077);
  a077=(a042*a235);
  a261=(a045*a010);
  a068=(a047*a068);
  a261=(a261+a068);
  a261=(a037+a261);
  a068=(a063*a261);
  a231=(a045*a297);
  a173=(a047*a173);
  a231=(a231+a173);
  a231=(a285+a231);
  a173=(a082*a231);
  a068=(a068+a173);
  a173=(a045*a266);
  a136=(a048*a055);
  a136=(a266+a136);
  a136=(a047*a136);
  a173=(a173+a136);
  a173=(a163+a173);
  a136=(a076*a173);
  a068=(a068-a136);
  a136=(a182*a152);
  a308=(a078*a178);
  a136=(a136+a308);
  a068=(a068+a136);
  a136=(a044*a068);
  a077=(a077+a136);
  a077=(a010+a077);
  a136=(a022*a077);
  a308=(a042*a251);
  a026=(a239*a261);
  a034=(a072*a231);
  a026=(a026+a034);
  a034=(a075*a173);
  a026=(a026+a034);
  a034=(a109*a152);
  a027=(a084*a178);
  a034=(a034-a027);
  a026=(a026+a034);
  a034=(a044*a026);
  a308=(a308+a034);
  a308=(a297+a308);
  a034=(a099*a308);
  a136=(a136+a034);
  a230=(a230+a136);
  a136=(a030*a230);
  a248=(a248+a136);
  a136=(a103*a010);
  a034=(a052*a152);
  a136=(a136+a034);
  a034=(a110*a077);
  a136=(a136+a034);
  a136=(a037+a136);
  a034=(a106*a136);
  a027=(a103*a297);
  a083=(a052*a178);
  a027=(a027+a083);
  a083=(a110*a308);
  a027=(a027+a083);
  a027=(a285+a027);
  a083=(a081*a027);
  a034=(a034+a083);
  a083=(a103*a266);
  a309=(a052*a309);
  a083=(a083+a309);
  a309=(a042*a055);
  a261=(a090*a261);
  a231=(a066*a231);
  a261=(a261+a231);
  a173=(a064*a173);
  a261=(a261-a173);
  a152=(a147*a152);
  a178=(a073*a178);
  a152=(a152+a178);
  a261=(a261+a152);
  a152=(a044*a261);
  a309=(a309+a152);
  a309=(a266+a309);
  a152=(a110*a309);
  a083=(a083+a152);
  a083=(a163+a083);
  a152=(a092*a083);
  a034=(a034-a152);
  a152=(a103*a235);
  a068=(a052*a068);
  a152=(a152+a068);
  a068=(a110*a230);
  a152=(a152+a068);
  a152=(a010+a152);
  a068=(a094*a152);
  a178=(a103*a251);
  a026=(a052*a026);
  a178=(a178+a026);
  a026=(a009*a305);
  a173=(a097*a004);
  a026=(a026+a173);
  a173=(a069*a300);
  a026=(a026+a173);
  a173=(a113*a077);
  a231=(a095*a308);
  a173=(a173-a231);
  a026=(a026+a173);
  a173=(a110*a026);
  a178=(a178+a173);
  a178=(a297+a178);
  a173=(a121*a178);
  a068=(a068+a173);
  a034=(a034+a068);
  a068=(a098*a034);
  a248=(a248+a068);
  a248=(a010+a248);
  a068=(a005*a248);
  a138=(a138+a068);
  a068=(a125*a235);
  a173=(a131*a230);
  a068=(a068+a173);
  a173=(a132*a034);
  a068=(a068+a173);
  a173=(a006*a010);
  a231=(a030*a077);
  a173=(a173+a231);
  a231=(a098*a152);
  a173=(a173+a231);
  a173=(a037+a173);
  a231=(a128*a173);
  a206=(a006*a297);
  a304=(a030*a308);
  a206=(a206+a304);
  a304=(a098*a178);
  a206=(a206+a304);
  a206=(a285+a206);
  a304=(a140*a206);
  a231=(a231+a304);
  a304=(a006*a266);
  a268=(a030*a309);
  a304=(a304+a268);
  a268=(a103*a055);
  a261=(a052*a261);
  a268=(a268+a261);
  a305=(a107*a305);
  a004=(a102*a004);
  a305=(a305+a004);
  a300=(a292*a300);
  a305=(a305-a300);
  a300=(a298*a077);
  a004=(a091*a308);
  a300=(a300+a004);
  a305=(a305+a300);
  a300=(a110*a305);
  a268=(a268+a300);
  a268=(a266+a268);
  a300=(a098*a268);
  a304=(a304+a300);
  a304=(a163+a304);
  a300=(a115*a304);
  a231=(a231-a300);
  a300=(a023*a248);
  a004=(a006*a251);
  a261=(a030*a026);
  a004=(a004+a261);
  a261=(a061*a136);
  a220=(a119*a027);
  a261=(a261+a220);
  a220=(a108*a083);
  a261=(a261+a220);
  a220=(a011*a152);
  a105=(a117*a178);
  a220=(a220-a105);
  a261=(a261+a220);
  a220=(a098*a261);
  a004=(a004+a220);
  a004=(a297+a004);
  a220=(a146*a004);
  a300=(a300+a220);
  a231=(a231+a300);
  a300=(a133*a231);
  a068=(a068+a300);
  a068=(a010+a068);
  a300=(a120*a068);
  a138=(a138+a300);
  a300=(a150*a235);
  a220=(a089*a230);
  a300=(a300+a220);
  a220=(a157*a034);
  a300=(a300+a220);
  a220=(a158*a231);
  a300=(a300+a220);
  a220=(a125*a010);
  a105=(a131*a077);
  a220=(a220+a105);
  a105=(a132*a152);
  a220=(a220+a105);
  a105=(a133*a248);
  a220=(a220+a105);
  a220=(a037+a220);
  a105=(a151*a220);
  a050=(a125*a297);
  a289=(a131*a308);
  a050=(a050+a289);
  a289=(a132*a178);
  a050=(a050+a289);
  a289=(a133*a004);
  a050=(a050+a289);
  a050=(a285+a050);
  a289=(a166*a050);
  a105=(a105+a289);
  a289=(a125*a266);
  a015=(a131*a309);
  a289=(a289+a015);
  a015=(a132*a268);
  a289=(a289+a015);
  a015=(a006*a055);
  a017=(a030*a305);
  a015=(a015+a017);
  a136=(a129*a136);
  a027=(a124*a027);
  a136=(a136+a027);
  a083=(a116*a083);
  a136=(a136-a083);
  a083=(a079*a152);
  a027=(a114*a178);
  a083=(a083+a027);
  a136=(a136+a083);
  a083=(a098*a136);
  a015=(a015+a083);
  a015=(a266+a015);
  a083=(a133*a015);
  a289=(a289+a083);
  a289=(a163+a289);
  a083=(a051*a289);
  a105=(a105-a083);
  a083=(a156*a068);
  a027=(a125*a251);
  a017=(a131*a026);
  a027=(a027+a017);
  a017=(a132*a261);
  a027=(a027+a017);
  a017=(a112*a173);
  a290=(a144*a206);
  a017=(a017+a290);
  a290=(a134*a304);
  a017=(a017+a290);
  a290=(a088*a248);
  a202=(a142*a004);
  a290=(a290-a202);
  a017=(a017+a290);
  a290=(a133*a017);
  a027=(a027+a290);
  a027=(a297+a027);
  a290=(a172*a027);
  a083=(a083+a290);
  a105=(a105+a083);
  a083=(a159*a105);
  a300=(a300+a083);
  a300=(a010+a300);
  a083=(a145*a300);
  a138=(a138+a083);
  a083=(a176*a235);
  a290=(a183*a230);
  a083=(a083+a290);
  a290=(a184*a034);
  a083=(a083+a290);
  a290=(a185*a231);
  a083=(a083+a290);
  a290=(a186*a105);
  a083=(a083+a290);
  a290=(a150*a010);
  a202=(a089*a077);
  a290=(a290+a202);
  a202=(a157*a152);
  a290=(a290+a202);
  a202=(a158*a248);
  a290=(a290+a202);
  a202=(a159*a068);
  a290=(a290+a202);
  a290=(a037+a290);
  a202=(a177*a290);
  a101=(a150*a297);
  a287=(a089*a308);
  a101=(a101+a287);
  a287=(a157*a178);
  a101=(a101+a287);
  a287=(a158*a004);
  a101=(a101+a287);
  a287=(a159*a027);
  a101=(a101+a287);
  a101=(a285+a101);
  a287=(a194*a101);
  a202=(a202+a287);
  a287=(a150*a266);
  a025=(a089*a309);
  a287=(a287+a025);
  a025=(a157*a268);
  a287=(a287+a025);
  a025=(a158*a015);
  a287=(a287+a025);
  a025=(a125*a055);
  a174=(a131*a305);
  a025=(a025+a174);
  a174=(a132*a136);
  a025=(a025+a174);
  a173=(a154*a173);
  a206=(a149*a206);
  a173=(a173+a206);
  a304=(a141*a304);
  a173=(a173-a304);
  a304=(a086*a248);
  a206=(a139*a004);
  a304=(a304+a206);
  a173=(a173+a304);
  a304=(a133*a173);
  a025=(a025+a304);
  a025=(a266+a025);
  a304=(a159*a025);
  a287=(a287+a304);
  a287=(a163+a287);
  a304=(a087*a287);
  a202=(a202-a304);
  a304=(a123*a300);
  a206=(a150*a251);
  a174=(a089*a026);
  a206=(a206+a174);
  a174=(a157*a261);
  a206=(a206+a174);
  a174=(a158*a017);
  a206=(a206+a174);
  a174=(a020*a220);
  a148=(a170*a050);
  a174=(a174+a148);
  a148=(a160*a289);
  a174=(a174+a148);
  a148=(a210*a068);
  a279=(a168*a027);
  a148=(a148-a279);
  a174=(a174+a148);
  a148=(a159*a174);
  a206=(a206+a148);
  a206=(a297+a206);
  a148=(a200*a206);
  a304=(a304+a148);
  a202=(a202+a304);
  a304=(a187*a202);
  a083=(a083+a304);
  a083=(a010+a083);
  a304=(a171*a083);
  a138=(a138+a304);
  a304=(a204*a235);
  a148=(a211*a230);
  a304=(a304+a148);
  a148=(a212*a034);
  a304=(a304+a148);
  a148=(a213*a231);
  a304=(a304+a148);
  a148=(a214*a105);
  a304=(a304+a148);
  a148=(a215*a202);
  a304=(a304+a148);
  a148=(a176*a010);
  a279=(a183*a077);
  a148=(a148+a279);
  a279=(a184*a152);
  a148=(a148+a279);
  a279=(a185*a248);
  a148=(a148+a279);
  a279=(a186*a068);
  a148=(a148+a279);
  a279=(a187*a300);
  a148=(a148+a279);
  a148=(a037+a148);
  a279=(a205*a148);
  a190=(a176*a297);
  a162=(a183*a308);
  a190=(a190+a162);
  a162=(a184*a178);
  a190=(a190+a162);
  a162=(a185*a004);
  a190=(a190+a162);
  a162=(a186*a027);
  a190=(a190+a162);
  a162=(a187*a206);
  a190=(a190+a162);
  a190=(a285+a190);
  a162=(a223*a190);
  a279=(a279+a162);
  a162=(a176*a266);
  a301=(a183*a309);
  a162=(a162+a301);
  a301=(a184*a268);
  a162=(a162+a301);
  a301=(a185*a015);
  a162=(a162+a301);
  a301=(a186*a025);
  a162=(a162+a301);
  a301=(a150*a055);
  a127=(a089*a305);
  a301=(a301+a127);
  a127=(a157*a136);
  a301=(a301+a127);
  a127=(a158*a173);
  a301=(a301+a127);
  a220=(a180*a220);
  a050=(a175*a050);
  a220=(a220+a050);
  a289=(a167*a289);
  a220=(a220-a289);
  a289=(a080*a068);
  a050=(a165*a027);
  a289=(a289+a050);
  a220=(a220+a289);
  a289=(a159*a220);
  a301=(a301+a289);
  a301=(a266+a301);
  a289=(a187*a301);
  a162=(a162+a289);
  a162=(a163+a162);
  a289=(a096*a162);
  a279=(a279-a289);
  a289=(a153*a083);
  a050=(a176*a251);
  a127=(a183*a026);
  a050=(a050+a127);
  a127=(a184*a261);
  a050=(a050+a127);
  a127=(a185*a017);
  a050=(a050+a127);
  a127=(a186*a174);
  a050=(a050+a127);
  a127=(a130*a290);
  a111=(a198*a101);
  a127=(a127+a111);
  a111=(a188*a287);
  a127=(a127+a111);
  a111=(a302*a300);
  a033=(a196*a206);
  a111=(a111-a033);
  a127=(a127+a111);
  a111=(a187*a127);
  a050=(a050+a111);
  a050=(a297+a050);
  a111=(a229*a050);
  a289=(a289+a111);
  a279=(a279+a289);
  a289=(a216*a279);
  a304=(a304+a289);
  a304=(a010+a304);
  a289=(a199*a304);
  a138=(a138+a289);
  a289=(a233*a235);
  a111=(a240*a230);
  a289=(a289+a111);
  a111=(a241*a034);
  a289=(a289+a111);
  a111=(a242*a231);
  a289=(a289+a111);
  a111=(a243*a105);
  a289=(a289+a111);
  a111=(a244*a202);
  a289=(a289+a111);
  a111=(a245*a279);
  a289=(a289+a111);
  a111=(a204*a010);
  a033=(a211*a077);
  a111=(a111+a033);
  a033=(a212*a152);
  a111=(a111+a033);
  a033=(a213*a248);
  a111=(a111+a033);
  a033=(a214*a068);
  a111=(a111+a033);
  a033=(a215*a300);
  a111=(a111+a033);
  a033=(a216*a083);
  a111=(a111+a033);
  a111=(a037+a111);
  a033=(a234*a111);
  a126=(a204*a297);
  a071=(a211*a308);
  a126=(a126+a071);
  a071=(a212*a178);
  a126=(a126+a071);
  a071=(a213*a004);
  a126=(a126+a071);
  a071=(a214*a027);
  a126=(a126+a071);
  a071=(a215*a206);
  a126=(a126+a071);
  a071=(a216*a050);
  a126=(a126+a071);
  a126=(a285+a126);
  a071=(a253*a126);
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
  a269=(a176*a055);
  a043=(a183*a305);
  a269=(a269+a043);
  a043=(a184*a136);
  a269=(a269+a043);
  a043=(a185*a173);
  a269=(a269+a043);
  a043=(a186*a220);
  a269=(a269+a043);
  a290=(a208*a290);
  a101=(a203*a101);
  a290=(a290+a101);
  a287=(a195*a287);
  a290=(a290-a287);
  a287=(a303*a300);
  a101=(a193*a206);
  a287=(a287+a101);
  a290=(a290+a287);
  a287=(a187*a290);
  a269=(a269+a287);
  a269=(a266+a269);
  a287=(a216*a269);
  a071=(a071+a287);
  a071=(a163+a071);
  a287=(a135*a071);
  a033=(a033-a287);
  a287=(a179*a304);
  a101=(a204*a251);
  a043=(a211*a026);
  a101=(a101+a043);
  a043=(a212*a261);
  a101=(a101+a043);
  a043=(a213*a017);
  a101=(a101+a043);
  a043=(a214*a174);
  a101=(a101+a043);
  a043=(a215*a127);
  a101=(a101+a043);
  a043=(a155*a148);
  a074=(a227*a190);
  a043=(a043+a074);
  a074=(a217*a162);
  a043=(a043+a074);
  a074=(a306*a083);
  a226=(a225*a050);
  a074=(a074-a226);
  a043=(a043+a074);
  a074=(a216*a043);
  a101=(a101+a074);
  a101=(a297+a101);
  a074=(a259*a101);
  a287=(a287+a074);
  a033=(a033+a287);
  a287=(a246*a033);
  a289=(a289+a287);
  a289=(a010+a289);
  a287=(a228*a289);
  a138=(a138+a287);
  a287=(a263*a235);
  a230=(a270*a230);
  a287=(a287+a230);
  a034=(a100*a034);
  a287=(a287+a034);
  a034=(a122*a231);
  a287=(a287+a034);
  a034=(a271*a105);
  a287=(a287+a034);
  a034=(a272*a202);
  a287=(a287+a034);
  a034=(a273*a279);
  a287=(a287+a034);
  a034=(a274*a033);
  a287=(a287+a034);
  a034=(a233*a010);
  a230=(a240*a077);
  a034=(a034+a230);
  a230=(a241*a152);
  a034=(a034+a230);
  a230=(a242*a248);
  a034=(a034+a230);
  a230=(a243*a068);
  a034=(a034+a230);
  a230=(a244*a300);
  a034=(a034+a230);
  a230=(a245*a083);
  a034=(a034+a230);
  a230=(a246*a304);
  a034=(a034+a230);
  a034=(a037+a034);
  a230=(a059*a034);
  a074=(a233*a297);
  a226=(a240*a308);
  a074=(a074+a226);
  a226=(a241*a178);
  a074=(a074+a226);
  a226=(a242*a004);
  a074=(a074+a226);
  a226=(a243*a027);
  a074=(a074+a226);
  a226=(a244*a206);
  a074=(a074+a226);
  a226=(a245*a050);
  a074=(a074+a226);
  a226=(a246*a101);
  a074=(a074+a226);
  a074=(a285+a074);
  a226=(a282*a074);
  a230=(a230+a226);
  a226=(a233*a266);
  a219=(a240*a309);
  a226=(a226+a219);
  a219=(a241*a268);
  a226=(a226+a219);
  a219=(a242*a015);
  a226=(a226+a219);
  a219=(a243*a025);
  a226=(a226+a219);
  a219=(a244*a301);
  a226=(a226+a219);
  a219=(a245*a269);
  a226=(a226+a219);
  a219=(a204*a055);
  a046=(a211*a305);
  a219=(a219+a046);
  a046=(a212*a136);
  a219=(a219+a046);
  a046=(a213*a173);
  a219=(a219+a046);
  a046=(a214*a220);
  a219=(a219+a046);
  a046=(a215*a290);
  a219=(a219+a046);
  a148=(a237*a148);
  a190=(a232*a190);
  a148=(a148+a190);
  a162=(a224*a162);
  a148=(a148-a162);
  a162=(a307*a083);
  a190=(a222*a050);
  a162=(a162+a190);
  a148=(a148+a162);
  a162=(a216*a148);
  a219=(a219+a162);
  a219=(a266+a219);
  a162=(a246*a219);
  a226=(a226+a162);
  a226=(a163+a226);
  a162=(a249*a226);
  a230=(a230-a162);
  a162=(a207*a289);
  a190=(a233*a251);
  a046=(a240*a026);
  a190=(a190+a046);
  a046=(a241*a261);
  a190=(a190+a046);
  a046=(a242*a017);
  a190=(a190+a046);
  a046=(a243*a174);
  a190=(a190+a046);
  a046=(a244*a127);
  a190=(a190+a046);
  a046=(a245*a043);
  a190=(a190+a046);
  a046=(a181*a111);
  a000=(a257*a126);
  a046=(a046+a000);
  a000=(a247*a071);
  a046=(a046+a000);
  a000=(a310*a304);
  a169=(a255*a101);
  a000=(a000-a169);
  a046=(a046+a000);
  a000=(a246*a046);
  a190=(a190+a000);
  a190=(a297+a190);
  a000=(a288*a190);
  a162=(a162+a000);
  a230=(a230+a162);
  a162=(a275*a230);
  a287=(a287+a162);
  a287=(a010+a287);
  a162=(a258*a287);
  a138=(a138+a162);
  a138=(a037+a138);
  if (res[0]!=0) res[0][18]=a138;
  a138=(a001*a297);
  a162=(a005*a004);
  a138=(a138+a162);
  a162=(a120*a027);
  a138=(a138+a162);
  a162=(a145*a206);
  a138=(a138+a162);
  a162=(a171*a050);
  a138=(a138+a162);
  a162=(a199*a101);
  a138=(a138+a162);
  a162=(a228*a190);
  a138=(a138+a162);
  a162=(a263*a251);
  a026=(a270*a026);
  a162=(a162+a026);
  a261=(a100*a261);
  a162=(a162+a261);
  a261=(a122*a017);
  a162=(a162+a261);
  a261=(a271*a174);
  a162=(a162+a261);
  a261=(a272*a127);
  a162=(a162+a261);
  a261=(a273*a043);
  a162=(a162+a261);
  a261=(a274*a046);
  a162=(a162+a261);
  a261=(a264*a034);
  a026=(a286*a074);
  a261=(a261+a026);
  a026=(a276*a226);
  a261=(a261+a026);
  a026=(a312*a289);
  a000=(a284*a190);
  a026=(a026-a000);
  a261=(a261+a026);
  a026=(a275*a261);
  a162=(a162+a026);
  a162=(a297+a162);
  a026=(a258*a162);
  a138=(a138+a026);
  a138=(a285+a138);
  if (res[0]!=0) res[0][19]=a138;
  a138=(a001*a266);
  a026=(a005*a015);
  a138=(a138+a026);
  a026=(a120*a025);
  a138=(a138+a026);
  a026=(a145*a301);
  a138=(a138+a026);
  a026=(a171*a269);
  a138=(a138+a026);
  a026=(a199*a219);
  a138=(a138+a026);
  a026=(a233*a055);
  a000=(a240*a305);
  a026=(a026+a000);
  a000=(a241*a136);
  a026=(a026+a000);
  a000=(a242*a173);
  a026=(a026+a000);
  a000=(a243*a220);
  a026=(a026+a000);
  a000=(a244*a290);
  a026=(a026+a000);
  a000=(a245*a148);
  a026=(a026+a000);
  a111=(a267*a111);
  a126=(a262*a126);
  a111=(a111+a126);
  a071=(a254*a071);
  a111=(a111-a071);
  a071=(a311*a304);
  a126=(a252*a101);
  a071=(a071+a126);
  a111=(a111+a071);
  a071=(a246*a111);
  a026=(a026+a071);
  a026=(a266+a026);
  a071=(a228*a026);
  a138=(a138+a071);
  a071=(a263*a055);
  a305=(a270*a305);
  a071=(a071+a305);
  a136=(a100*a136);
  a071=(a071+a136);
  a136=(a122*a173);
  a071=(a071+a136);
  a136=(a271*a220);
  a071=(a071+a136);
  a136=(a272*a290);
  a071=(a071+a136);
  a136=(a273*a148);
  a071=(a071+a136);
  a136=(a274*a111);
  a071=(a071+a136);
  a034=(a296*a034);
  a074=(a291*a074);
  a034=(a034+a074);
  a226=(a283*a226);
  a034=(a034-a226);
  a226=(a313*a289);
  a074=(a281*a190);
  a226=(a226+a074);
  a034=(a034+a226);
  a226=(a275*a034);
  a071=(a071+a226);
  a071=(a266+a071);
  a071=(a258*a071);
  a138=(a138+a071);
  a138=(a163+a138);
  if (res[0]!=0) res[0][20]=a138;
  a235=(a001*a235);
  a231=(a005*a231);
  a235=(a235+a231);
  a105=(a120*a105);
  a235=(a235+a105);
  a202=(a145*a202);
  a235=(a235+a202);
  a279=(a171*a279);
  a235=(a235+a279);
  a033=(a199*a033);
  a235=(a235+a033);
  a230=(a228*a230);
  a235=(a235+a230);
  a230=(a263*a010);
  a077=(a270*a077);
  a230=(a230+a077);
  a152=(a100*a152);
  a230=(a230+a152);
  a248=(a122*a248);
  a230=(a230+a248);
  a068=(a271*a068);
  a230=(a230+a068);
  a300=(a272*a300);
  a230=(a230+a300);
  a083=(a273*a083);
  a230=(a230+a083);
  a304=(a274*a304);
  a230=(a230+a304);
  a289=(a275*a289);
  a230=(a230+a289);
  a037=(a037+a230);
  a230=(a256*a037);
  a289=(a263*a297);
  a308=(a270*a308);
  a289=(a289+a308);
  a178=(a100*a178);
  a289=(a289+a178);
  a004=(a122*a004);
  a289=(a289+a004);
  a027=(a271*a027);
  a289=(a289+a027);
  a206=(a272*a206);
  a289=(a289+a206);
  a050=(a273*a050);
  a289=(a289+a050);
  a101=(a274*a101);
  a289=(a289+a101);
  a190=(a275*a190);
  a289=(a289+a190);
  a285=(a285+a289);
  a289=(a201*a285);
  a230=(a230+a289);
  a289=(a263*a266);
  a309=(a270*a309);
  a289=(a289+a309);
  a268=(a100*a268);
  a289=(a289+a268);
  a015=(a122*a015);
  a289=(a289+a015);
  a025=(a271*a025);
  a289=(a289+a025);
  a301=(a272*a301);
  a289=(a289+a301);
  a269=(a273*a269);
  a289=(a289+a269);
  a219=(a274*a219);
  a289=(a289+a219);
  a026=(a275*a026);
  a289=(a289+a026);
  a163=(a163+a289);
  a289=(a294*a163);
  a230=(a230-a289);
  a289=(a265*a287);
  a026=(a053*a162);
  a289=(a289+a026);
  a230=(a230+a289);
  a230=(a258*a230);
  a235=(a235+a230);
  a010=(a010+a235);
  if (res[0]!=0) res[0][21]=a010;
  a251=(a001*a251);
  a017=(a005*a017);
  a251=(a251+a017);
  a174=(a120*a174);
  a251=(a251+a174);
  a127=(a145*a127);
  a251=(a251+a127);
  a043=(a171*a043);
  a251=(a251+a043);
  a046=(a199*a046);
  a251=(a251+a046);
  a261=(a228*a261);
  a251=(a251+a261);
  a261=(a197*a037);
  a046=(a031*a285);
  a261=(a261+a046);
  a046=(a008*a163);
  a261=(a261+a046);
  a046=(a161*a287);
  a043=(a032*a162);
  a046=(a046-a043);
  a261=(a261+a046);
  a261=(a258*a261);
  a251=(a251+a261);
  a297=(a297+a251);
  if (res[0]!=0) res[0][22]=a297;
  a055=(a001*a055);
  a173=(a005*a173);
  a055=(a055+a173);
  a220=(a120*a220);
  a055=(a055+a220);
  a290=(a145*a290);
  a055=(a055+a290);
  a148=(a171*a148);
  a055=(a055+a148);
  a111=(a199*a111);
  a055=(a055+a111);
  a034=(a228*a034);
  a055=(a055+a034);
  a037=(a028*a037);
  a285=(a299*a285);
  a037=(a037+a285);
  a163=(a040*a163);
  a037=(a037-a163);
  a287=(a137*a287);
  a162=(a018*a162);
  a287=(a287+a162);
  a037=(a037+a287);
  a037=(a258*a037);
  a055=(a055+a037);
  a266=(a266+a055);
  if (res[0]!=0) res[0][23]=a266;
  a266=arg[0]? arg[0][24] : 0;
  a055=arg[0]? arg[0][27] : 0;
  a037=(a001*a055);
  a287=(a250*a266);
  a162=arg[0]? arg[0][25] : 0;
  a163=(a013*a162);
  a287=(a287+a163);
  a163=arg[0]? arg[0][26] : 0;
  a285=(a035*a163);
  a287=(a287-a285);
  a285=(a280*a055);
  a034=arg[0]? arg[0][28] : 0;
  a111=(a021*a034);
  a285=(a285+a111);
  a287=(a287+a285);
  a285=(a006*a287);
  a111=(a042*a055);
  a148=(a045*a287);
  a290=(a048*a055);
  a290=(a266+a290);
  a220=(a003*a290);
  a173=(a048*a034);
  a173=(a162+a173);
  a297=(a056*a173);
  a220=(a220+a297);
  a297=arg[0]? arg[0][29] : 0;
  a251=(a048*a297);
  a251=(a163+a251);
  a261=(a164*a251);
  a220=(a220-a261);
  a261=(a048*a287);
  a261=(a055+a261);
  a046=(a085*a261);
  a043=(a191*a266);
  a127=(a019*a162);
  a043=(a043+a127);
  a127=(a016*a163);
  a043=(a043+a127);
  a127=(a221*a055);
  a174=(a029*a034);
  a127=(a127-a174);
  a043=(a043+a127);
  a127=(a048*a043);
  a127=(a034+a127);
  a174=(a062*a127);
  a046=(a046+a174);
  a220=(a220+a046);
  a220=(a047*a220);
  a148=(a148+a220);
  a148=(a055+a148);
  a220=(a044*a148);
  a111=(a111+a220);
  a111=(a266+a111);
  a220=(a038*a111);
  a046=(a042*a034);
  a174=(a045*a043);
  a017=(a007*a290);
  a010=(a060*a173);
  a017=(a017+a010);
  a010=(a049*a251);
  a017=(a017+a010);
  a010=(a041*a261);
  a235=(a058*a127);
  a010=(a010-a235);
  a017=(a017+a010);
  a017=(a047*a017);
  a174=(a174+a017);
  a174=(a034+a174);
  a017=(a044*a174);
  a046=(a046+a017);
  a046=(a162+a046);
  a017=(a093*a046);
  a220=(a220+a017);
  a017=(a042*a297);
  a010=(a039*a266);
  a235=(a024*a162);
  a010=(a010+a235);
  a235=(a014*a163);
  a010=(a010-a235);
  a235=(a192*a055);
  a230=(a012*a034);
  a235=(a235+a230);
  a010=(a010+a235);
  a235=(a045*a010);
  a290=(a070*a290);
  a173=(a065*a173);
  a290=(a290+a173);
  a251=(a057*a251);
  a290=(a290-a251);
  a251=(a002*a261);
  a173=(a054*a127);
  a251=(a251+a173);
  a290=(a290+a251);
  a290=(a047*a290);
  a235=(a235+a290);
  a235=(a297+a235);
  a290=(a044*a235);
  a017=(a017+a290);
  a017=(a163+a017);
  a290=(a067*a017);
  a220=(a220-a290);
  a290=(a042*a287);
  a251=(a045*a055);
  a261=(a047*a261);
  a251=(a251+a261);
  a251=(a266+a251);
  a261=(a063*a251);
  a173=(a045*a034);
  a127=(a047*a127);
  a173=(a173+a127);
  a173=(a162+a173);
  a127=(a082*a173);
  a261=(a261+a127);
  a127=(a045*a297);
  a230=(a048*a010);
  a230=(a297+a230);
  a230=(a047*a230);
  a127=(a127+a230);
  a127=(a163+a127);
  a230=(a076*a127);
  a261=(a261-a230);
  a230=(a182*a148);
  a289=(a078*a174);
  a230=(a230+a289);
  a261=(a261+a230);
  a230=(a044*a261);
  a290=(a290+a230);
  a290=(a055+a290);
  a230=(a022*a290);
  a289=(a042*a043);
  a026=(a239*a251);
  a219=(a072*a173);
  a026=(a026+a219);
  a219=(a075*a127);
  a026=(a026+a219);
  a219=(a109*a148);
  a269=(a084*a174);
  a219=(a219-a269);
  a026=(a026+a219);
  a219=(a044*a026);
  a289=(a289+a219);
  a289=(a034+a289);
  a219=(a099*a289);
  a230=(a230+a219);
  a220=(a220+a230);
  a230=(a030*a220);
  a285=(a285+a230);
  a230=(a103*a055);
  a219=(a052*a148);
  a230=(a230+a219);
  a219=(a110*a290);
  a230=(a230+a219);
  a230=(a266+a230);
  a219=(a106*a230);
  a269=(a103*a034);
  a301=(a052*a174);
  a269=(a269+a301);
  a301=(a110*a289);
  a269=(a269+a301);
  a269=(a162+a269);
  a301=(a081*a269);
  a219=(a219+a301);
  a301=(a103*a297);
  a235=(a052*a235);
  a301=(a301+a235);
  a235=(a042*a010);
  a251=(a090*a251);
  a173=(a066*a173);
  a251=(a251+a173);
  a127=(a064*a127);
  a251=(a251-a127);
  a148=(a147*a148);
  a174=(a073*a174);
  a148=(a148+a174);
  a251=(a251+a148);
  a148=(a044*a251);
  a235=(a235+a148);
  a235=(a297+a235);
  a148=(a110*a235);
  a301=(a301+a148);
  a301=(a163+a301);
  a148=(a092*a301);
  a219=(a219-a148);
  a148=(a103*a287);
  a261=(a052*a261);
  a148=(a148+a261);
  a261=(a110*a220);
  a148=(a148+a261);
  a148=(a055+a148);
  a261=(a094*a148);
  a174=(a103*a043);
  a026=(a052*a026);
  a174=(a174+a026);
  a026=(a009*a111);
  a127=(a097*a046);
  a026=(a026+a127);
  a127=(a069*a017);
  a026=(a026+a127);
  a127=(a113*a290);
  a173=(a095*a289);
  a127=(a127-a173);
  a026=(a026+a127);
  a127=(a110*a026);
  a174=(a174+a127);
  a174=(a034+a174);
  a127=(a121*a174);
  a261=(a261+a127);
  a219=(a219+a261);
  a261=(a098*a219);
  a285=(a285+a261);
  a285=(a055+a285);
  a261=(a005*a285);
  a037=(a037+a261);
  a261=(a125*a287);
  a127=(a131*a220);
  a261=(a261+a127);
  a127=(a132*a219);
  a261=(a261+a127);
  a127=(a006*a055);
  a173=(a030*a290);
  a127=(a127+a173);
  a173=(a098*a148);
  a127=(a127+a173);
  a127=(a266+a127);
  a173=(a128*a127);
  a025=(a006*a034);
  a015=(a030*a289);
  a025=(a025+a015);
  a015=(a098*a174);
  a025=(a025+a015);
  a025=(a162+a025);
  a015=(a140*a025);
  a173=(a173+a015);
  a015=(a006*a297);
  a268=(a030*a235);
  a015=(a015+a268);
  a268=(a103*a010);
  a251=(a052*a251);
  a268=(a268+a251);
  a111=(a107*a111);
  a046=(a102*a046);
  a111=(a111+a046);
  a017=(a292*a017);
  a111=(a111-a017);
  a017=(a298*a290);
  a046=(a091*a289);
  a017=(a017+a046);
  a111=(a111+a017);
  a017=(a110*a111);
  a268=(a268+a017);
  a268=(a297+a268);
  a017=(a098*a268);
  a015=(a015+a017);
  a015=(a163+a015);
  a017=(a115*a015);
  a173=(a173-a017);
  a017=(a023*a285);
  a046=(a006*a043);
  a251=(a030*a026);
  a046=(a046+a251);
  a251=(a061*a230);
  a309=(a119*a269);
  a251=(a251+a309);
  a309=(a108*a301);
  a251=(a251+a309);
  a309=(a011*a148);
  a190=(a117*a174);
  a309=(a309-a190);
  a251=(a251+a309);
  a309=(a098*a251);
  a046=(a046+a309);
  a046=(a034+a046);
  a309=(a146*a046);
  a017=(a017+a309);
  a173=(a173+a017);
  a017=(a133*a173);
  a261=(a261+a017);
  a261=(a055+a261);
  a017=(a120*a261);
  a037=(a037+a017);
  a017=(a150*a287);
  a309=(a089*a220);
  a017=(a017+a309);
  a309=(a157*a219);
  a017=(a017+a309);
  a309=(a158*a173);
  a017=(a017+a309);
  a309=(a125*a055);
  a190=(a131*a290);
  a309=(a309+a190);
  a190=(a132*a148);
  a309=(a309+a190);
  a190=(a133*a285);
  a309=(a309+a190);
  a309=(a266+a309);
  a190=(a151*a309);
  a101=(a125*a034);
  a050=(a131*a289);
  a101=(a101+a050);
  a050=(a132*a174);
  a101=(a101+a050);
  a050=(a133*a046);
  a101=(a101+a050);
  a101=(a162+a101);
  a050=(a166*a101);
  a190=(a190+a050);
  a050=(a125*a297);
  a206=(a131*a235);
  a050=(a050+a206);
  a206=(a132*a268);
  a050=(a050+a206);
  a206=(a006*a010);
  a027=(a030*a111);
  a206=(a206+a027);
  a230=(a129*a230);
  a269=(a124*a269);
  a230=(a230+a269);
  a301=(a116*a301);
  a230=(a230-a301);
  a301=(a079*a148);
  a269=(a114*a174);
  a301=(a301+a269);
  a230=(a230+a301);
  a301=(a098*a230);
  a206=(a206+a301);
  a206=(a297+a206);
  a301=(a133*a206);
  a050=(a050+a301);
  a050=(a163+a050);
  a301=(a051*a050);
  a190=(a190-a301);
  a301=(a156*a261);
  a269=(a125*a043);
  a027=(a131*a026);
  a269=(a269+a027);
  a027=(a132*a251);
  a269=(a269+a027);
  a027=(a112*a127);
  a004=(a144*a025);
  a027=(a027+a004);
  a004=(a134*a015);
  a027=(a027+a004);
  a004=(a088*a285);
  a178=(a142*a046);
  a004=(a004-a178);
  a027=(a027+a004);
  a004=(a133*a027);
  a269=(a269+a004);
  a269=(a034+a269);
  a004=(a172*a269);
  a301=(a301+a004);
  a190=(a190+a301);
  a301=(a159*a190);
  a017=(a017+a301);
  a017=(a055+a017);
  a301=(a145*a017);
  a037=(a037+a301);
  a301=(a176*a287);
  a004=(a183*a220);
  a301=(a301+a004);
  a004=(a184*a219);
  a301=(a301+a004);
  a004=(a185*a173);
  a301=(a301+a004);
  a004=(a186*a190);
  a301=(a301+a004);
  a004=(a150*a055);
  a178=(a089*a290);
  a004=(a004+a178);
  a178=(a157*a148);
  a004=(a004+a178);
  a178=(a158*a285);
  a004=(a004+a178);
  a178=(a159*a261);
  a004=(a004+a178);
  a004=(a266+a004);
  a178=(a177*a004);
  a308=(a150*a034);
  a304=(a089*a289);
  a308=(a308+a304);
  a304=(a157*a174);
  a308=(a308+a304);
  a304=(a158*a046);
  a308=(a308+a304);
  a304=(a159*a269);
  a308=(a308+a304);
  a308=(a162+a308);
  a304=(a194*a308);
  a178=(a178+a304);
  a304=(a150*a297);
  a083=(a089*a235);
  a304=(a304+a083);
  a083=(a157*a268);
  a304=(a304+a083);
  a083=(a158*a206);
  a304=(a304+a083);
  a083=(a125*a010);
  a300=(a131*a111);
  a083=(a083+a300);
  a300=(a132*a230);
  a083=(a083+a300);
  a127=(a154*a127);
  a025=(a149*a025);
  a127=(a127+a025);
  a015=(a141*a015);
  a127=(a127-a015);
  a015=(a086*a285);
  a025=(a139*a046);
  a015=(a015+a025);
  a127=(a127+a015);
  a015=(a133*a127);
  a083=(a083+a015);
  a083=(a297+a083);
  a015=(a159*a083);
  a304=(a304+a015);
  a304=(a163+a304);
  a015=(a087*a304);
  a178=(a178-a015);
  a015=(a123*a017);
  a025=(a150*a043);
  a300=(a089*a026);
  a025=(a025+a300);
  a300=(a157*a251);
  a025=(a025+a300);
  a300=(a158*a027);
  a025=(a025+a300);
  a300=(a020*a309);
  a068=(a170*a101);
  a300=(a300+a068);
  a068=(a160*a050);
  a300=(a300+a068);
  a068=(a210*a261);
  a248=(a168*a269);
  a068=(a068-a248);
  a300=(a300+a068);
  a068=(a159*a300);
  a025=(a025+a068);
  a025=(a034+a025);
  a068=(a200*a025);
  a015=(a015+a068);
  a178=(a178+a015);
  a015=(a187*a178);
  a301=(a301+a015);
  a301=(a055+a301);
  a015=(a171*a301);
  a037=(a037+a015);
  a015=(a204*a287);
  a068=(a211*a220);
  a015=(a015+a068);
  a068=(a212*a219);
  a015=(a015+a068);
  a068=(a213*a173);
  a015=(a015+a068);
  a068=(a214*a190);
  a015=(a015+a068);
  a068=(a215*a178);
  a015=(a015+a068);
  a068=(a176*a055);
  a248=(a183*a290);
  a068=(a068+a248);
  a248=(a184*a148);
  a068=(a068+a248);
  a248=(a185*a285);
  a068=(a068+a248);
  a248=(a186*a261);
  a068=(a068+a248);
  a248=(a187*a017);
  a068=(a068+a248);
  a068=(a266+a068);
  a248=(a205*a068);
  a152=(a176*a034);
  a077=(a183*a289);
  a152=(a152+a077);
  a077=(a184*a174);
  a152=(a152+a077);
  a077=(a185*a046);
  a152=(a152+a077);
  a077=(a186*a269);
  a152=(a152+a077);
  a077=(a187*a025);
  a152=(a152+a077);
  a152=(a162+a152);
  a077=(a223*a152);
  a248=(a248+a077);
  a077=(a176*a297);
  a033=(a183*a235);
  a077=(a077+a033);
  a033=(a184*a268);
  a077=(a077+a033);
  a033=(a185*a206);
  a077=(a077+a033);
  a033=(a186*a083);
  a077=(a077+a033);
  a033=(a150*a010);
  a279=(a089*a111);
  a033=(a033+a279);
  a279=(a157*a230);
  a033=(a033+a279);
  a279=(a158*a127);
  a033=(a033+a279);
  a309=(a180*a309);
  a101=(a175*a101);
  a309=(a309+a101);
  a050=(a167*a050);
  a309=(a309-a050);
  a050=(a080*a261);
  a101=(a165*a269);
  a050=(a050+a101);
  a309=(a309+a050);
  a050=(a159*a309);
  a033=(a033+a050);
  a033=(a297+a033);
  a050=(a187*a033);
  a077=(a077+a050);
  a077=(a163+a077);
  a050=(a096*a077);
  a248=(a248-a050);
  a050=(a153*a301);
  a101=(a176*a043);
  a279=(a183*a026);
  a101=(a101+a279);
  a279=(a184*a251);
  a101=(a101+a279);
  a279=(a185*a027);
  a101=(a101+a279);
  a279=(a186*a300);
  a101=(a101+a279);
  a279=(a130*a004);
  a202=(a198*a308);
  a279=(a279+a202);
  a202=(a188*a304);
  a279=(a279+a202);
  a202=(a302*a017);
  a105=(a196*a025);
  a202=(a202-a105);
  a279=(a279+a202);
  a202=(a187*a279);
  a101=(a101+a202);
  a101=(a034+a101);
  a202=(a229*a101);
  a050=(a050+a202);
  a248=(a248+a050);
  a050=(a216*a248);
  a015=(a015+a050);
  a015=(a055+a015);
  a050=(a199*a015);
  a037=(a037+a050);
  a050=(a233*a287);
  a202=(a240*a220);
  a050=(a050+a202);
  a202=(a241*a219);
  a050=(a050+a202);
  a202=(a242*a173);
  a050=(a050+a202);
  a202=(a243*a190);
  a050=(a050+a202);
  a202=(a244*a178);
  a050=(a050+a202);
  a202=(a245*a248);
  a050=(a050+a202);
  a202=(a204*a055);
  a105=(a211*a290);
  a202=(a202+a105);
  a105=(a212*a148);
  a202=(a202+a105);
  a105=(a213*a285);
  a202=(a202+a105);
  a105=(a214*a261);
  a202=(a202+a105);
  a105=(a215*a017);
  a202=(a202+a105);
  a105=(a216*a301);
  a202=(a202+a105);
  a202=(a266+a202);
  a105=(a234*a202);
  a231=(a204*a034);
  a138=(a211*a289);
  a231=(a231+a138);
  a138=(a212*a174);
  a231=(a231+a138);
  a138=(a213*a046);
  a231=(a231+a138);
  a138=(a214*a269);
  a231=(a231+a138);
  a138=(a215*a025);
  a231=(a231+a138);
  a138=(a216*a101);
  a231=(a231+a138);
  a231=(a162+a231);
  a138=(a253*a231);
  a105=(a105+a138);
  a138=(a204*a297);
  a071=(a211*a235);
  a138=(a138+a071);
  a071=(a212*a268);
  a138=(a138+a071);
  a071=(a213*a206);
  a138=(a138+a071);
  a071=(a214*a083);
  a138=(a138+a071);
  a071=(a215*a033);
  a138=(a138+a071);
  a071=(a176*a010);
  a226=(a183*a111);
  a071=(a071+a226);
  a226=(a184*a230);
  a071=(a071+a226);
  a226=(a185*a127);
  a071=(a071+a226);
  a226=(a186*a309);
  a071=(a071+a226);
  a004=(a208*a004);
  a308=(a203*a308);
  a004=(a004+a308);
  a304=(a195*a304);
  a004=(a004-a304);
  a304=(a303*a017);
  a308=(a193*a025);
  a304=(a304+a308);
  a004=(a004+a304);
  a304=(a187*a004);
  a071=(a071+a304);
  a071=(a297+a071);
  a304=(a216*a071);
  a138=(a138+a304);
  a138=(a163+a138);
  a304=(a135*a138);
  a105=(a105-a304);
  a304=(a179*a015);
  a308=(a204*a043);
  a226=(a211*a026);
  a308=(a308+a226);
  a226=(a212*a251);
  a308=(a308+a226);
  a226=(a213*a027);
  a308=(a308+a226);
  a226=(a214*a300);
  a308=(a308+a226);
  a226=(a215*a279);
  a308=(a308+a226);
  a226=(a155*a068);
  a074=(a227*a152);
  a226=(a226+a074);
  a074=(a217*a077);
  a226=(a226+a074);
  a074=(a306*a301);
  a136=(a225*a101);
  a074=(a074-a136);
  a226=(a226+a074);
  a074=(a216*a226);
  a308=(a308+a074);
  a308=(a034+a308);
  a074=(a259*a308);
  a304=(a304+a074);
  a105=(a105+a304);
  a304=(a246*a105);
  a050=(a050+a304);
  a050=(a055+a050);
  a304=(a228*a050);
  a037=(a037+a304);
  a304=(a263*a287);
  a220=(a270*a220);
  a304=(a304+a220);
  a219=(a100*a219);
  a304=(a304+a219);
  a219=(a122*a173);
  a304=(a304+a219);
  a219=(a271*a190);
  a304=(a304+a219);
  a219=(a272*a178);
  a304=(a304+a219);
  a219=(a273*a248);
  a304=(a304+a219);
  a219=(a274*a105);
  a304=(a304+a219);
  a219=(a233*a055);
  a220=(a240*a290);
  a219=(a219+a220);
  a220=(a241*a148);
  a219=(a219+a220);
  a220=(a242*a285);
  a219=(a219+a220);
  a220=(a243*a261);
  a219=(a219+a220);
  a220=(a244*a017);
  a219=(a219+a220);
  a220=(a245*a301);
  a219=(a219+a220);
  a220=(a246*a015);
  a219=(a219+a220);
  a219=(a266+a219);
  a220=(a059*a219);
  a074=(a233*a034);
  a136=(a240*a289);
  a074=(a074+a136);
  a136=(a241*a174);
  a074=(a074+a136);
  a136=(a242*a046);
  a074=(a074+a136);
  a136=(a243*a269);
  a074=(a074+a136);
  a136=(a244*a025);
  a074=(a074+a136);
  a136=(a245*a101);
  a074=(a074+a136);
  a136=(a246*a308);
  a074=(a074+a136);
  a074=(a162+a074);
  a136=(a282*a074);
  a220=(a220+a136);
  a136=(a233*a297);
  a305=(a240*a235);
  a136=(a136+a305);
  a305=(a241*a268);
  a136=(a136+a305);
  a305=(a242*a206);
  a136=(a136+a305);
  a305=(a243*a083);
  a136=(a136+a305);
  a305=(a244*a033);
  a136=(a136+a305);
  a305=(a245*a071);
  a136=(a136+a305);
  a305=(a204*a010);
  a126=(a211*a111);
  a305=(a305+a126);
  a126=(a212*a230);
  a305=(a305+a126);
  a126=(a213*a127);
  a305=(a305+a126);
  a126=(a214*a309);
  a305=(a305+a126);
  a126=(a215*a004);
  a305=(a305+a126);
  a068=(a237*a068);
  a152=(a232*a152);
  a068=(a068+a152);
  a077=(a224*a077);
  a068=(a068-a077);
  a077=(a307*a301);
  a152=(a222*a101);
  a077=(a077+a152);
  a068=(a068+a077);
  a077=(a216*a068);
  a305=(a305+a077);
  a305=(a297+a305);
  a077=(a246*a305);
  a136=(a136+a077);
  a136=(a163+a136);
  a077=(a249*a136);
  a220=(a220-a077);
  a077=(a207*a050);
  a152=(a233*a043);
  a126=(a240*a026);
  a152=(a152+a126);
  a126=(a241*a251);
  a152=(a152+a126);
  a126=(a242*a027);
  a152=(a152+a126);
  a126=(a243*a300);
  a152=(a152+a126);
  a126=(a244*a279);
  a152=(a152+a126);
  a126=(a245*a226);
  a152=(a152+a126);
  a126=(a181*a202);
  a000=(a257*a231);
  a126=(a126+a000);
  a000=(a247*a138);
  a126=(a126+a000);
  a000=(a310*a015);
  a169=(a255*a308);
  a000=(a000-a169);
  a126=(a126+a000);
  a000=(a246*a126);
  a152=(a152+a000);
  a152=(a034+a152);
  a000=(a288*a152);
  a077=(a077+a000);
  a220=(a220+a077);
  a077=(a275*a220);
  a304=(a304+a077);
  a304=(a055+a304);
  a077=(a258*a304);
  a037=(a037+a077);
  a037=(a266+a037);
  if (res[0]!=0) res[0][24]=a037;
  a037=(a001*a034);
  a077=(a005*a046);
  a037=(a037+a077);
  a077=(a120*a269);
  a037=(a037+a077);
  a077=(a145*a025);
  a037=(a037+a077);
  a077=(a171*a101);
  a037=(a037+a077);
  a077=(a199*a308);
  a037=(a037+a077);
  a077=(a228*a152);
  a037=(a037+a077);
  a077=(a263*a043);
  a026=(a270*a026);
  a077=(a077+a026);
  a251=(a100*a251);
  a077=(a077+a251);
  a251=(a122*a027);
  a077=(a077+a251);
  a251=(a271*a300);
  a077=(a077+a251);
  a251=(a272*a279);
  a077=(a077+a251);
  a251=(a273*a226);
  a077=(a077+a251);
  a251=(a274*a126);
  a077=(a077+a251);
  a251=(a264*a219);
  a026=(a286*a074);
  a251=(a251+a026);
  a026=(a276*a136);
  a251=(a251+a026);
  a026=(a312*a050);
  a000=(a284*a152);
  a026=(a026-a000);
  a251=(a251+a026);
  a026=(a275*a251);
  a077=(a077+a026);
  a077=(a034+a077);
  a026=(a258*a077);
  a037=(a037+a026);
  a037=(a162+a037);
  if (res[0]!=0) res[0][25]=a037;
  a037=(a001*a297);
  a026=(a005*a206);
  a037=(a037+a026);
  a026=(a120*a083);
  a037=(a037+a026);
  a026=(a145*a033);
  a037=(a037+a026);
  a026=(a171*a071);
  a037=(a037+a026);
  a026=(a199*a305);
  a037=(a037+a026);
  a026=(a233*a010);
  a000=(a240*a111);
  a026=(a026+a000);
  a000=(a241*a230);
  a026=(a026+a000);
  a000=(a242*a127);
  a026=(a026+a000);
  a000=(a243*a309);
  a026=(a026+a000);
  a000=(a244*a004);
  a026=(a026+a000);
  a000=(a245*a068);
  a026=(a026+a000);
  a202=(a267*a202);
  a231=(a262*a231);
  a202=(a202+a231);
  a138=(a254*a138);
  a202=(a202-a138);
  a138=(a311*a015);
  a231=(a252*a308);
  a138=(a138+a231);
  a202=(a202+a138);
  a138=(a246*a202);
  a026=(a026+a138);
  a026=(a297+a026);
  a138=(a228*a026);
  a037=(a037+a138);
  a138=(a263*a010);
  a111=(a270*a111);
  a138=(a138+a111);
  a230=(a100*a230);
  a138=(a138+a230);
  a230=(a122*a127);
  a138=(a138+a230);
  a230=(a271*a309);
  a138=(a138+a230);
  a230=(a272*a004);
  a138=(a138+a230);
  a230=(a273*a068);
  a138=(a138+a230);
  a230=(a274*a202);
  a138=(a138+a230);
  a219=(a296*a219);
  a074=(a291*a074);
  a219=(a219+a074);
  a136=(a283*a136);
  a219=(a219-a136);
  a136=(a313*a050);
  a074=(a281*a152);
  a136=(a136+a074);
  a219=(a219+a136);
  a136=(a275*a219);
  a138=(a138+a136);
  a138=(a297+a138);
  a138=(a258*a138);
  a037=(a037+a138);
  a037=(a163+a037);
  if (res[0]!=0) res[0][26]=a037;
  a287=(a001*a287);
  a173=(a005*a173);
  a287=(a287+a173);
  a190=(a120*a190);
  a287=(a287+a190);
  a178=(a145*a178);
  a287=(a287+a178);
  a248=(a171*a248);
  a287=(a287+a248);
  a105=(a199*a105);
  a287=(a287+a105);
  a220=(a228*a220);
  a287=(a287+a220);
  a220=(a263*a055);
  a290=(a270*a290);
  a220=(a220+a290);
  a148=(a100*a148);
  a220=(a220+a148);
  a285=(a122*a285);
  a220=(a220+a285);
  a261=(a271*a261);
  a220=(a220+a261);
  a017=(a272*a017);
  a220=(a220+a017);
  a301=(a273*a301);
  a220=(a220+a301);
  a015=(a274*a015);
  a220=(a220+a015);
  a050=(a275*a050);
  a220=(a220+a050);
  a266=(a266+a220);
  a220=(a256*a266);
  a050=(a263*a034);
  a289=(a270*a289);
  a050=(a050+a289);
  a174=(a100*a174);
  a050=(a050+a174);
  a046=(a122*a046);
  a050=(a050+a046);
  a269=(a271*a269);
  a050=(a050+a269);
  a025=(a272*a025);
  a050=(a050+a025);
  a101=(a273*a101);
  a050=(a050+a101);
  a308=(a274*a308);
  a050=(a050+a308);
  a152=(a275*a152);
  a050=(a050+a152);
  a162=(a162+a050);
  a050=(a201*a162);
  a220=(a220+a050);
  a050=(a263*a297);
  a235=(a270*a235);
  a050=(a050+a235);
  a268=(a100*a268);
  a050=(a050+a268);
  a206=(a122*a206);
  a050=(a050+a206);
  a083=(a271*a083);
  a050=(a050+a083);
  a033=(a272*a033);
  a050=(a050+a033);
  a071=(a273*a071);
  a050=(a050+a071);
  a305=(a274*a305);
  a050=(a050+a305);
  a026=(a275*a026);
  a050=(a050+a026);
  a163=(a163+a050);
  a050=(a294*a163);
  a220=(a220-a050);
  a050=(a265*a304);
  a026=(a053*a077);
  a050=(a050+a026);
  a220=(a220+a050);
  a220=(a258*a220);
  a287=(a287+a220);
  a055=(a055+a287);
  if (res[0]!=0) res[0][27]=a055;
  a043=(a001*a043);
  a027=(a005*a027);
  a043=(a043+a027);
  a300=(a120*a300);
  a043=(a043+a300);
  a279=(a145*a279);
  a043=(a043+a279);
  a226=(a171*a226);
  a043=(a043+a226);
  a126=(a199*a126);
  a043=(a043+a126);
  a251=(a228*a251);
  a043=(a043+a251);
  a251=(a197*a266);
  a126=(a031*a162);
  a251=(a251+a126);
  a126=(a008*a163);
  a251=(a251+a126);
  a126=(a161*a304);
  a226=(a032*a077);
  a126=(a126-a226);
  a251=(a251+a126);
  a251=(a258*a251);
  a043=(a043+a251);
  a034=(a034+a043);
  if (res[0]!=0) res[0][28]=a034;
  a010=(a001*a010);
  a127=(a005*a127);
  a010=(a010+a127);
  a309=(a120*a309);
  a010=(a010+a309);
  a004=(a145*a004);
  a010=(a010+a004);
  a068=(a171*a068);
  a010=(a010+a068);
  a202=(a199*a202);
  a010=(a010+a202);
  a219=(a228*a219);
  a010=(a010+a219);
  a266=(a028*a266);
  a162=(a299*a162);
  a266=(a266+a162);
  a163=(a040*a163);
  a266=(a266-a163);
  a304=(a137*a304);
  a077=(a018*a077);
  a304=(a304+a077);
  a266=(a266+a304);
  a266=(a258*a266);
  a010=(a010+a266);
  a297=(a297+a010);
  if (res[0]!=0) res[0][29]=a297;
  a297=arg[0]? arg[0][30] : 0;
  a010=arg[0]? arg[0][33] : 0;
  a266=(a001*a010);
  a250=(a250*a297);
  a304=arg[0]? arg[0][31] : 0;
  a013=(a013*a304);
  a250=(a250+a013);
  a013=arg[0]? arg[0][32] : 0;
  a035=(a035*a013);
  a250=(a250-a035);
  a280=(a280*a010);
  a035=arg[0]? arg[0][34] : 0;
  a021=(a021*a035);
  a280=(a280+a021);
  a250=(a250+a280);
  a280=(a006*a250);
  a021=(a042*a010);
  a077=(a045*a250);
  a163=(a048*a010);
  a163=(a297+a163);
  a003=(a003*a163);
  a162=(a048*a035);
  a162=(a304+a162);
  a056=(a056*a162);
  a003=(a003+a056);
  a056=arg[0]? arg[0][35] : 0;
  a219=(a048*a056);
  a219=(a013+a219);
  a164=(a164*a219);
  a003=(a003-a164);
  a164=(a048*a250);
  a164=(a010+a164);
  a085=(a085*a164);
  a191=(a191*a297);
  a019=(a019*a304);
  a191=(a191+a019);
  a016=(a016*a013);
  a191=(a191+a016);
  a221=(a221*a010);
  a029=(a029*a035);
  a221=(a221-a029);
  a191=(a191+a221);
  a221=(a048*a191);
  a221=(a035+a221);
  a062=(a062*a221);
  a085=(a085+a062);
  a003=(a003+a085);
  a003=(a047*a003);
  a077=(a077+a003);
  a077=(a010+a077);
  a003=(a044*a077);
  a021=(a021+a003);
  a021=(a297+a021);
  a038=(a038*a021);
  a003=(a042*a035);
  a085=(a045*a191);
  a007=(a007*a163);
  a060=(a060*a162);
  a007=(a007+a060);
  a049=(a049*a219);
  a007=(a007+a049);
  a041=(a041*a164);
  a058=(a058*a221);
  a041=(a041-a058);
  a007=(a007+a041);
  a007=(a047*a007);
  a085=(a085+a007);
  a085=(a035+a085);
  a007=(a044*a085);
  a003=(a003+a007);
  a003=(a304+a003);
  a093=(a093*a003);
  a038=(a038+a093);
  a093=(a042*a056);
  a039=(a039*a297);
  a024=(a024*a304);
  a039=(a039+a024);
  a014=(a014*a013);
  a039=(a039-a014);
  a192=(a192*a010);
  a012=(a012*a035);
  a192=(a192+a012);
  a039=(a039+a192);
  a192=(a045*a039);
  a070=(a070*a163);
  a065=(a065*a162);
  a070=(a070+a065);
  a057=(a057*a219);
  a070=(a070-a057);
  a002=(a002*a164);
  a054=(a054*a221);
  a002=(a002+a054);
  a070=(a070+a002);
  a070=(a047*a070);
  a192=(a192+a070);
  a192=(a056+a192);
  a070=(a044*a192);
  a093=(a093+a070);
  a093=(a013+a093);
  a067=(a067*a093);
  a038=(a038-a067);
  a067=(a042*a250);
  a070=(a045*a010);
  a164=(a047*a164);
  a070=(a070+a164);
  a070=(a297+a070);
  a063=(a063*a070);
  a164=(a045*a035);
  a221=(a047*a221);
  a164=(a164+a221);
  a164=(a304+a164);
  a082=(a082*a164);
  a063=(a063+a082);
  a045=(a045*a056);
  a048=(a048*a039);
  a048=(a056+a048);
  a047=(a047*a048);
  a045=(a045+a047);
  a045=(a013+a045);
  a076=(a076*a045);
  a063=(a063-a076);
  a182=(a182*a077);
  a078=(a078*a085);
  a182=(a182+a078);
  a063=(a063+a182);
  a182=(a044*a063);
  a067=(a067+a182);
  a067=(a010+a067);
  a022=(a022*a067);
  a182=(a042*a191);
  a239=(a239*a070);
  a072=(a072*a164);
  a239=(a239+a072);
  a075=(a075*a045);
  a239=(a239+a075);
  a109=(a109*a077);
  a084=(a084*a085);
  a109=(a109-a084);
  a239=(a239+a109);
  a109=(a044*a239);
  a182=(a182+a109);
  a182=(a035+a182);
  a099=(a099*a182);
  a022=(a022+a099);
  a038=(a038+a022);
  a022=(a030*a038);
  a280=(a280+a022);
  a022=(a103*a010);
  a099=(a052*a077);
  a022=(a022+a099);
  a099=(a110*a067);
  a022=(a022+a099);
  a022=(a297+a022);
  a106=(a106*a022);
  a099=(a103*a035);
  a109=(a052*a085);
  a099=(a099+a109);
  a109=(a110*a182);
  a099=(a099+a109);
  a099=(a304+a099);
  a081=(a081*a099);
  a106=(a106+a081);
  a081=(a103*a056);
  a192=(a052*a192);
  a081=(a081+a192);
  a042=(a042*a039);
  a090=(a090*a070);
  a066=(a066*a164);
  a090=(a090+a066);
  a064=(a064*a045);
  a090=(a090-a064);
  a147=(a147*a077);
  a073=(a073*a085);
  a147=(a147+a073);
  a090=(a090+a147);
  a044=(a044*a090);
  a042=(a042+a044);
  a042=(a056+a042);
  a044=(a110*a042);
  a081=(a081+a044);
  a081=(a013+a081);
  a092=(a092*a081);
  a106=(a106-a092);
  a092=(a103*a250);
  a063=(a052*a063);
  a092=(a092+a063);
  a063=(a110*a038);
  a092=(a092+a063);
  a092=(a010+a092);
  a094=(a094*a092);
  a063=(a103*a191);
  a239=(a052*a239);
  a063=(a063+a239);
  a009=(a009*a021);
  a097=(a097*a003);
  a009=(a009+a097);
  a069=(a069*a093);
  a009=(a009+a069);
  a113=(a113*a067);
  a095=(a095*a182);
  a113=(a113-a095);
  a009=(a009+a113);
  a113=(a110*a009);
  a063=(a063+a113);
  a063=(a035+a063);
  a121=(a121*a063);
  a094=(a094+a121);
  a106=(a106+a094);
  a094=(a098*a106);
  a280=(a280+a094);
  a280=(a010+a280);
  a094=(a005*a280);
  a266=(a266+a094);
  a094=(a125*a250);
  a121=(a131*a038);
  a094=(a094+a121);
  a121=(a132*a106);
  a094=(a094+a121);
  a121=(a006*a010);
  a113=(a030*a067);
  a121=(a121+a113);
  a113=(a098*a092);
  a121=(a121+a113);
  a121=(a297+a121);
  a128=(a128*a121);
  a113=(a006*a035);
  a095=(a030*a182);
  a113=(a113+a095);
  a095=(a098*a063);
  a113=(a113+a095);
  a113=(a304+a113);
  a140=(a140*a113);
  a128=(a128+a140);
  a140=(a006*a056);
  a095=(a030*a042);
  a140=(a140+a095);
  a103=(a103*a039);
  a052=(a052*a090);
  a103=(a103+a052);
  a107=(a107*a021);
  a102=(a102*a003);
  a107=(a107+a102);
  a292=(a292*a093);
  a107=(a107-a292);
  a298=(a298*a067);
  a091=(a091*a182);
  a298=(a298+a091);
  a107=(a107+a298);
  a110=(a110*a107);
  a103=(a103+a110);
  a103=(a056+a103);
  a110=(a098*a103);
  a140=(a140+a110);
  a140=(a013+a140);
  a115=(a115*a140);
  a128=(a128-a115);
  a023=(a023*a280);
  a115=(a006*a191);
  a110=(a030*a009);
  a115=(a115+a110);
  a061=(a061*a022);
  a119=(a119*a099);
  a061=(a061+a119);
  a108=(a108*a081);
  a061=(a061+a108);
  a011=(a011*a092);
  a117=(a117*a063);
  a011=(a011-a117);
  a061=(a061+a011);
  a011=(a098*a061);
  a115=(a115+a011);
  a115=(a035+a115);
  a146=(a146*a115);
  a023=(a023+a146);
  a128=(a128+a023);
  a023=(a133*a128);
  a094=(a094+a023);
  a094=(a010+a094);
  a023=(a120*a094);
  a266=(a266+a023);
  a023=(a150*a250);
  a146=(a089*a038);
  a023=(a023+a146);
  a146=(a157*a106);
  a023=(a023+a146);
  a146=(a158*a128);
  a023=(a023+a146);
  a146=(a125*a010);
  a011=(a131*a067);
  a146=(a146+a011);
  a011=(a132*a092);
  a146=(a146+a011);
  a011=(a133*a280);
  a146=(a146+a011);
  a146=(a297+a146);
  a151=(a151*a146);
  a011=(a125*a035);
  a117=(a131*a182);
  a011=(a011+a117);
  a117=(a132*a063);
  a011=(a011+a117);
  a117=(a133*a115);
  a011=(a011+a117);
  a011=(a304+a011);
  a166=(a166*a011);
  a151=(a151+a166);
  a166=(a125*a056);
  a117=(a131*a042);
  a166=(a166+a117);
  a117=(a132*a103);
  a166=(a166+a117);
  a006=(a006*a039);
  a030=(a030*a107);
  a006=(a006+a030);
  a129=(a129*a022);
  a124=(a124*a099);
  a129=(a129+a124);
  a116=(a116*a081);
  a129=(a129-a116);
  a079=(a079*a092);
  a114=(a114*a063);
  a079=(a079+a114);
  a129=(a129+a079);
  a098=(a098*a129);
  a006=(a006+a098);
  a006=(a056+a006);
  a098=(a133*a006);
  a166=(a166+a098);
  a166=(a013+a166);
  a051=(a051*a166);
  a151=(a151-a051);
  a156=(a156*a094);
  a051=(a125*a191);
  a098=(a131*a009);
  a051=(a051+a098);
  a098=(a132*a061);
  a051=(a051+a098);
  a112=(a112*a121);
  a144=(a144*a113);
  a112=(a112+a144);
  a134=(a134*a140);
  a112=(a112+a134);
  a088=(a088*a280);
  a142=(a142*a115);
  a088=(a088-a142);
  a112=(a112+a088);
  a088=(a133*a112);
  a051=(a051+a088);
  a051=(a035+a051);
  a172=(a172*a051);
  a156=(a156+a172);
  a151=(a151+a156);
  a156=(a159*a151);
  a023=(a023+a156);
  a023=(a010+a023);
  a156=(a145*a023);
  a266=(a266+a156);
  a156=(a176*a250);
  a172=(a183*a038);
  a156=(a156+a172);
  a172=(a184*a106);
  a156=(a156+a172);
  a172=(a185*a128);
  a156=(a156+a172);
  a172=(a186*a151);
  a156=(a156+a172);
  a172=(a150*a010);
  a088=(a089*a067);
  a172=(a172+a088);
  a088=(a157*a092);
  a172=(a172+a088);
  a088=(a158*a280);
  a172=(a172+a088);
  a088=(a159*a094);
  a172=(a172+a088);
  a172=(a297+a172);
  a177=(a177*a172);
  a088=(a150*a035);
  a142=(a089*a182);
  a088=(a088+a142);
  a142=(a157*a063);
  a088=(a088+a142);
  a142=(a158*a115);
  a088=(a088+a142);
  a142=(a159*a051);
  a088=(a088+a142);
  a088=(a304+a088);
  a194=(a194*a088);
  a177=(a177+a194);
  a194=(a150*a056);
  a142=(a089*a042);
  a194=(a194+a142);
  a142=(a157*a103);
  a194=(a194+a142);
  a142=(a158*a006);
  a194=(a194+a142);
  a125=(a125*a039);
  a131=(a131*a107);
  a125=(a125+a131);
  a132=(a132*a129);
  a125=(a125+a132);
  a154=(a154*a121);
  a149=(a149*a113);
  a154=(a154+a149);
  a141=(a141*a140);
  a154=(a154-a141);
  a086=(a086*a280);
  a139=(a139*a115);
  a086=(a086+a139);
  a154=(a154+a086);
  a133=(a133*a154);
  a125=(a125+a133);
  a125=(a056+a125);
  a133=(a159*a125);
  a194=(a194+a133);
  a194=(a013+a194);
  a087=(a087*a194);
  a177=(a177-a087);
  a123=(a123*a023);
  a087=(a150*a191);
  a133=(a089*a009);
  a087=(a087+a133);
  a133=(a157*a061);
  a087=(a087+a133);
  a133=(a158*a112);
  a087=(a087+a133);
  a020=(a020*a146);
  a170=(a170*a011);
  a020=(a020+a170);
  a160=(a160*a166);
  a020=(a020+a160);
  a210=(a210*a094);
  a168=(a168*a051);
  a210=(a210-a168);
  a020=(a020+a210);
  a210=(a159*a020);
  a087=(a087+a210);
  a087=(a035+a087);
  a200=(a200*a087);
  a123=(a123+a200);
  a177=(a177+a123);
  a123=(a187*a177);
  a156=(a156+a123);
  a156=(a010+a156);
  a123=(a171*a156);
  a266=(a266+a123);
  a123=(a204*a250);
  a200=(a211*a038);
  a123=(a123+a200);
  a200=(a212*a106);
  a123=(a123+a200);
  a200=(a213*a128);
  a123=(a123+a200);
  a200=(a214*a151);
  a123=(a123+a200);
  a200=(a215*a177);
  a123=(a123+a200);
  a200=(a176*a010);
  a210=(a183*a067);
  a200=(a200+a210);
  a210=(a184*a092);
  a200=(a200+a210);
  a210=(a185*a280);
  a200=(a200+a210);
  a210=(a186*a094);
  a200=(a200+a210);
  a210=(a187*a023);
  a200=(a200+a210);
  a200=(a297+a200);
  a205=(a205*a200);
  a210=(a176*a035);
  a168=(a183*a182);
  a210=(a210+a168);
  a168=(a184*a063);
  a210=(a210+a168);
  a168=(a185*a115);
  a210=(a210+a168);
  a168=(a186*a051);
  a210=(a210+a168);
  a168=(a187*a087);
  a210=(a210+a168);
  a210=(a304+a210);
  a223=(a223*a210);
  a205=(a205+a223);
  a223=(a176*a056);
  a168=(a183*a042);
  a223=(a223+a168);
  a168=(a184*a103);
  a223=(a223+a168);
  a168=(a185*a006);
  a223=(a223+a168);
  a168=(a186*a125);
  a223=(a223+a168);
  a150=(a150*a039);
  a089=(a089*a107);
  a150=(a150+a089);
  a157=(a157*a129);
  a150=(a150+a157);
  a158=(a158*a154);
  a150=(a150+a158);
  a180=(a180*a146);
  a175=(a175*a011);
  a180=(a180+a175);
  a167=(a167*a166);
  a180=(a180-a167);
  a080=(a080*a094);
  a165=(a165*a051);
  a080=(a080+a165);
  a180=(a180+a080);
  a159=(a159*a180);
  a150=(a150+a159);
  a150=(a056+a150);
  a159=(a187*a150);
  a223=(a223+a159);
  a223=(a013+a223);
  a096=(a096*a223);
  a205=(a205-a096);
  a153=(a153*a156);
  a096=(a176*a191);
  a159=(a183*a009);
  a096=(a096+a159);
  a159=(a184*a061);
  a096=(a096+a159);
  a159=(a185*a112);
  a096=(a096+a159);
  a159=(a186*a020);
  a096=(a096+a159);
  a130=(a130*a172);
  a198=(a198*a088);
  a130=(a130+a198);
  a188=(a188*a194);
  a130=(a130+a188);
  a302=(a302*a023);
  a196=(a196*a087);
  a302=(a302-a196);
  a130=(a130+a302);
  a302=(a187*a130);
  a096=(a096+a302);
  a096=(a035+a096);
  a229=(a229*a096);
  a153=(a153+a229);
  a205=(a205+a153);
  a153=(a216*a205);
  a123=(a123+a153);
  a123=(a010+a123);
  a153=(a199*a123);
  a266=(a266+a153);
  a153=(a233*a250);
  a229=(a240*a038);
  a153=(a153+a229);
  a229=(a241*a106);
  a153=(a153+a229);
  a229=(a242*a128);
  a153=(a153+a229);
  a229=(a243*a151);
  a153=(a153+a229);
  a229=(a244*a177);
  a153=(a153+a229);
  a229=(a245*a205);
  a153=(a153+a229);
  a229=(a204*a010);
  a302=(a211*a067);
  a229=(a229+a302);
  a302=(a212*a092);
  a229=(a229+a302);
  a302=(a213*a280);
  a229=(a229+a302);
  a302=(a214*a094);
  a229=(a229+a302);
  a302=(a215*a023);
  a229=(a229+a302);
  a302=(a216*a156);
  a229=(a229+a302);
  a229=(a297+a229);
  a234=(a234*a229);
  a302=(a204*a035);
  a196=(a211*a182);
  a302=(a302+a196);
  a196=(a212*a063);
  a302=(a302+a196);
  a196=(a213*a115);
  a302=(a302+a196);
  a196=(a214*a051);
  a302=(a302+a196);
  a196=(a215*a087);
  a302=(a302+a196);
  a196=(a216*a096);
  a302=(a302+a196);
  a302=(a304+a302);
  a253=(a253*a302);
  a234=(a234+a253);
  a253=(a204*a056);
  a196=(a211*a042);
  a253=(a253+a196);
  a196=(a212*a103);
  a253=(a253+a196);
  a196=(a213*a006);
  a253=(a253+a196);
  a196=(a214*a125);
  a253=(a253+a196);
  a196=(a215*a150);
  a253=(a253+a196);
  a176=(a176*a039);
  a183=(a183*a107);
  a176=(a176+a183);
  a184=(a184*a129);
  a176=(a176+a184);
  a185=(a185*a154);
  a176=(a176+a185);
  a186=(a186*a180);
  a176=(a176+a186);
  a208=(a208*a172);
  a203=(a203*a088);
  a208=(a208+a203);
  a195=(a195*a194);
  a208=(a208-a195);
  a303=(a303*a023);
  a193=(a193*a087);
  a303=(a303+a193);
  a208=(a208+a303);
  a187=(a187*a208);
  a176=(a176+a187);
  a176=(a056+a176);
  a187=(a216*a176);
  a253=(a253+a187);
  a253=(a013+a253);
  a135=(a135*a253);
  a234=(a234-a135);
  a179=(a179*a123);
  a135=(a204*a191);
  a187=(a211*a009);
  a135=(a135+a187);
  a187=(a212*a061);
  a135=(a135+a187);
  a187=(a213*a112);
  a135=(a135+a187);
  a187=(a214*a020);
  a135=(a135+a187);
  a187=(a215*a130);
  a135=(a135+a187);
  a155=(a155*a200);
  a227=(a227*a210);
  a155=(a155+a227);
  a217=(a217*a223);
  a155=(a155+a217);
  a306=(a306*a156);
  a225=(a225*a096);
  a306=(a306-a225);
  a155=(a155+a306);
  a306=(a216*a155);
  a135=(a135+a306);
  a135=(a035+a135);
  a259=(a259*a135);
  a179=(a179+a259);
  a234=(a234+a179);
  a179=(a246*a234);
  a153=(a153+a179);
  a153=(a010+a153);
  a179=(a228*a153);
  a266=(a266+a179);
  a179=(a263*a250);
  a038=(a270*a038);
  a179=(a179+a038);
  a106=(a100*a106);
  a179=(a179+a106);
  a106=(a122*a128);
  a179=(a179+a106);
  a106=(a271*a151);
  a179=(a179+a106);
  a106=(a272*a177);
  a179=(a179+a106);
  a106=(a273*a205);
  a179=(a179+a106);
  a106=(a274*a234);
  a179=(a179+a106);
  a106=(a233*a010);
  a038=(a240*a067);
  a106=(a106+a038);
  a038=(a241*a092);
  a106=(a106+a038);
  a038=(a242*a280);
  a106=(a106+a038);
  a038=(a243*a094);
  a106=(a106+a038);
  a038=(a244*a023);
  a106=(a106+a038);
  a038=(a245*a156);
  a106=(a106+a038);
  a038=(a246*a123);
  a106=(a106+a038);
  a106=(a297+a106);
  a059=(a059*a106);
  a038=(a233*a035);
  a259=(a240*a182);
  a038=(a038+a259);
  a259=(a241*a063);
  a038=(a038+a259);
  a259=(a242*a115);
  a038=(a038+a259);
  a259=(a243*a051);
  a038=(a038+a259);
  a259=(a244*a087);
  a038=(a038+a259);
  a259=(a245*a096);
  a038=(a038+a259);
  a259=(a246*a135);
  a038=(a038+a259);
  a038=(a304+a038);
  a282=(a282*a038);
  a059=(a059+a282);
  a282=(a233*a056);
  a259=(a240*a042);
  a282=(a282+a259);
  a259=(a241*a103);
  a282=(a282+a259);
  a259=(a242*a006);
  a282=(a282+a259);
  a259=(a243*a125);
  a282=(a282+a259);
  a259=(a244*a150);
  a282=(a282+a259);
  a259=(a245*a176);
  a282=(a282+a259);
  a204=(a204*a039);
  a211=(a211*a107);
  a204=(a204+a211);
  a212=(a212*a129);
  a204=(a204+a212);
  a213=(a213*a154);
  a204=(a204+a213);
  a214=(a214*a180);
  a204=(a204+a214);
  a215=(a215*a208);
  a204=(a204+a215);
  a237=(a237*a200);
  a232=(a232*a210);
  a237=(a237+a232);
  a224=(a224*a223);
  a237=(a237-a224);
  a307=(a307*a156);
  a222=(a222*a096);
  a307=(a307+a222);
  a237=(a237+a307);
  a216=(a216*a237);
  a204=(a204+a216);
  a204=(a056+a204);
  a216=(a246*a204);
  a282=(a282+a216);
  a282=(a013+a282);
  a249=(a249*a282);
  a059=(a059-a249);
  a207=(a207*a153);
  a249=(a233*a191);
  a216=(a240*a009);
  a249=(a249+a216);
  a216=(a241*a061);
  a249=(a249+a216);
  a216=(a242*a112);
  a249=(a249+a216);
  a216=(a243*a020);
  a249=(a249+a216);
  a216=(a244*a130);
  a249=(a249+a216);
  a216=(a245*a155);
  a249=(a249+a216);
  a181=(a181*a229);
  a257=(a257*a302);
  a181=(a181+a257);
  a247=(a247*a253);
  a181=(a181+a247);
  a310=(a310*a123);
  a255=(a255*a135);
  a310=(a310-a255);
  a181=(a181+a310);
  a310=(a246*a181);
  a249=(a249+a310);
  a249=(a035+a249);
  a288=(a288*a249);
  a207=(a207+a288);
  a059=(a059+a207);
  a207=(a275*a059);
  a179=(a179+a207);
  a179=(a010+a179);
  a207=(a258*a179);
  a266=(a266+a207);
  a266=(a297+a266);
  if (res[0]!=0) res[0][30]=a266;
  a266=(a001*a035);
  a207=(a005*a115);
  a266=(a266+a207);
  a207=(a120*a051);
  a266=(a266+a207);
  a207=(a145*a087);
  a266=(a266+a207);
  a207=(a171*a096);
  a266=(a266+a207);
  a207=(a199*a135);
  a266=(a266+a207);
  a207=(a228*a249);
  a266=(a266+a207);
  a207=(a263*a191);
  a009=(a270*a009);
  a207=(a207+a009);
  a061=(a100*a061);
  a207=(a207+a061);
  a061=(a122*a112);
  a207=(a207+a061);
  a061=(a271*a020);
  a207=(a207+a061);
  a061=(a272*a130);
  a207=(a207+a061);
  a061=(a273*a155);
  a207=(a207+a061);
  a061=(a274*a181);
  a207=(a207+a061);
  a264=(a264*a106);
  a286=(a286*a038);
  a264=(a264+a286);
  a276=(a276*a282);
  a264=(a264+a276);
  a312=(a312*a153);
  a284=(a284*a249);
  a312=(a312-a284);
  a264=(a264+a312);
  a312=(a275*a264);
  a207=(a207+a312);
  a207=(a035+a207);
  a312=(a258*a207);
  a266=(a266+a312);
  a266=(a304+a266);
  if (res[0]!=0) res[0][31]=a266;
  a266=(a001*a056);
  a312=(a005*a006);
  a266=(a266+a312);
  a312=(a120*a125);
  a266=(a266+a312);
  a312=(a145*a150);
  a266=(a266+a312);
  a312=(a171*a176);
  a266=(a266+a312);
  a312=(a199*a204);
  a266=(a266+a312);
  a233=(a233*a039);
  a240=(a240*a107);
  a233=(a233+a240);
  a241=(a241*a129);
  a233=(a233+a241);
  a242=(a242*a154);
  a233=(a233+a242);
  a243=(a243*a180);
  a233=(a233+a243);
  a244=(a244*a208);
  a233=(a233+a244);
  a245=(a245*a237);
  a233=(a233+a245);
  a267=(a267*a229);
  a262=(a262*a302);
  a267=(a267+a262);
  a254=(a254*a253);
  a267=(a267-a254);
  a311=(a311*a123);
  a252=(a252*a135);
  a311=(a311+a252);
  a267=(a267+a311);
  a246=(a246*a267);
  a233=(a233+a246);
  a233=(a056+a233);
  a246=(a228*a233);
  a266=(a266+a246);
  a246=(a263*a039);
  a107=(a270*a107);
  a246=(a246+a107);
  a129=(a100*a129);
  a246=(a246+a129);
  a129=(a122*a154);
  a246=(a246+a129);
  a129=(a271*a180);
  a246=(a246+a129);
  a129=(a272*a208);
  a246=(a246+a129);
  a129=(a273*a237);
  a246=(a246+a129);
  a129=(a274*a267);
  a246=(a246+a129);
  a296=(a296*a106);
  a291=(a291*a038);
  a296=(a296+a291);
  a283=(a283*a282);
  a296=(a296-a283);
  a313=(a313*a153);
  a281=(a281*a249);
  a313=(a313+a281);
  a296=(a296+a313);
  a313=(a275*a296);
  a246=(a246+a313);
  a246=(a056+a246);
  a246=(a258*a246);
  a266=(a266+a246);
  a266=(a013+a266);
  if (res[0]!=0) res[0][32]=a266;
  a250=(a001*a250);
  a128=(a005*a128);
  a250=(a250+a128);
  a151=(a120*a151);
  a250=(a250+a151);
  a177=(a145*a177);
  a250=(a250+a177);
  a205=(a171*a205);
  a250=(a250+a205);
  a234=(a199*a234);
  a250=(a250+a234);
  a059=(a228*a059);
  a250=(a250+a059);
  a059=(a263*a010);
  a067=(a270*a067);
  a059=(a059+a067);
  a092=(a100*a092);
  a059=(a059+a092);
  a280=(a122*a280);
  a059=(a059+a280);
  a094=(a271*a094);
  a059=(a059+a094);
  a023=(a272*a023);
  a059=(a059+a023);
  a156=(a273*a156);
  a059=(a059+a156);
  a123=(a274*a123);
  a059=(a059+a123);
  a153=(a275*a153);
  a059=(a059+a153);
  a297=(a297+a059);
  a256=(a256*a297);
  a059=(a263*a035);
  a182=(a270*a182);
  a059=(a059+a182);
  a063=(a100*a063);
  a059=(a059+a063);
  a115=(a122*a115);
  a059=(a059+a115);
  a051=(a271*a051);
  a059=(a059+a051);
  a087=(a272*a087);
  a059=(a059+a087);
  a096=(a273*a096);
  a059=(a059+a096);
  a135=(a274*a135);
  a059=(a059+a135);
  a249=(a275*a249);
  a059=(a059+a249);
  a304=(a304+a059);
  a201=(a201*a304);
  a256=(a256+a201);
  a263=(a263*a056);
  a270=(a270*a042);
  a263=(a263+a270);
  a100=(a100*a103);
  a263=(a263+a100);
  a122=(a122*a006);
  a263=(a263+a122);
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
  a013=(a013+a263);
  a294=(a294*a013);
  a256=(a256-a294);
  a265=(a265*a179);
  a053=(a053*a207);
  a265=(a265+a053);
  a256=(a256+a265);
  a256=(a258*a256);
  a250=(a250+a256);
  a010=(a010+a250);
  if (res[0]!=0) res[0][33]=a010;
  a191=(a001*a191);
  a112=(a005*a112);
  a191=(a191+a112);
  a020=(a120*a020);
  a191=(a191+a020);
  a130=(a145*a130);
  a191=(a191+a130);
  a155=(a171*a155);
  a191=(a191+a155);
  a181=(a199*a181);
  a191=(a191+a181);
  a264=(a228*a264);
  a191=(a191+a264);
  a197=(a197*a297);
  a031=(a031*a304);
  a197=(a197+a031);
  a008=(a008*a013);
  a197=(a197+a008);
  a161=(a161*a179);
  a032=(a032*a207);
  a161=(a161-a032);
  a197=(a197+a161);
  a197=(a258*a197);
  a191=(a191+a197);
  a035=(a035+a191);
  if (res[0]!=0) res[0][34]=a035;
  a001=(a001*a039);
  a005=(a005*a154);
  a001=(a001+a005);
  a120=(a120*a180);
  a001=(a001+a120);
  a145=(a145*a208);
  a001=(a001+a145);
  a171=(a171*a237);
  a001=(a001+a171);
  a199=(a199*a267);
  a001=(a001+a199);
  a228=(a228*a296);
  a001=(a001+a228);
  a028=(a028*a297);
  a299=(a299*a304);
  a028=(a028+a299);
  a040=(a040*a013);
  a028=(a028-a040);
  a137=(a137*a179);
  a018=(a018*a207);
  a137=(a137+a018);
  a028=(a028+a137);
  a258=(a258*a028);
  a001=(a001+a258);
  a056=(a056+a001);
  if (res[0]!=0) res[0][35]=a056;
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
  a11=(a10-a03);
  a12=(a09*a11);
  a12=(a03-a12);
  a13=(a07/a12);
  a14=arg[0]? arg[0][3] : 0;
  a15=sin(a04);
  a16=(a14*a15);
  a16=(a02*a16);
  a17=arg[0]? arg[0][5] : 0;
  a18=(a07*a17);
  a19=(a10*a14);
  a18=(a18-a19);
  a19=sin(a06);
  a20=(a02*a19);
  a21=(a20/a12);
  a22=(a18*a21);
  a23=(a17*a20);
  a24=(a13*a23);
  a22=(a22+a24);
  a16=(a16+a22);
  a11=(a08*a11);
  a22=(a11-a03);
  a24=(a22/a12);
  a25=(a24*a18);
  a25=(a18+a25);
  a26=(a22*a21);
  a26=(a20+a26);
  a27=(a08+a03);
  a28=(a22*a24);
  a27=(a27-a28);
  a28=(a26/a27);
  a29=(a25*a28);
  a30=(a22*a13);
  a30=(a07+a30);
  a31=(a30/a27);
  a32=(a24*a23);
  a32=(a23+a32);
  a33=(a31*a32);
  a29=(a29+a33);
  a16=(a16+a29);
  a29=(a07*a13);
  a29=(a02-a29);
  a33=(a30*a31);
  a29=(a29-a33);
  a16=(a16/a29);
  a33=cos(a04);
  a34=(a33*a14);
  a34=(a17-a34);
  a34=(a02*a34);
  a35=(a13*a18);
  a34=(a34-a35);
  a35=(a31*a25);
  a34=(a34-a35);
  a34=(a34/a29);
  a35=(a34/a29);
  a36=(a13*a20);
  a37=(a07*a21);
  a37=(a36+a37);
  a26=(a31*a26);
  a38=(a30*a28);
  a26=(a26+a38);
  a37=(a37+a26);
  a37=(a35*a37);
  a16=(a16-a37);
  a37=(a13*a16);
  a26=(a34*a21);
  a37=(a37-a26);
  a26=(a23/a12);
  a32=(a32/a27);
  a38=(a31*a16);
  a28=(a34*a28);
  a38=(a38-a28);
  a32=(a32+a38);
  a38=(a24*a32);
  a26=(a26+a38);
  a37=(a37+a26);
  a37=(a37+a32);
  a26=(a37*a00);
  a38=(a13/a12);
  a28=sin(a05);
  a09=(a09*a28);
  a38=(a38*a09);
  a21=(a21-a38);
  a38=(a34*a21);
  a39=(a07*a21);
  a36=(a36+a39);
  a39=(a22*a21);
  a40=(a08*a28);
  a41=(a13*a40);
  a39=(a39-a41);
  a20=(a20+a39);
  a39=(a31*a20);
  a20=(a20/a27);
  a41=(a31/a27);
  a42=(a24*a40);
  a40=(a40/a12);
  a43=(a24/a12);
  a43=(a43*a09);
  a40=(a40+a43);
  a22=(a22*a40);
  a42=(a42+a22);
  a41=(a41*a42);
  a20=(a20-a41);
  a30=(a30*a20);
  a39=(a39+a30);
  a36=(a36+a39);
  a35=(a35*a36);
  a21=(a18*a21);
  a36=(a14*a28);
  a23=(a23+a36);
  a36=(a13*a23);
  a21=(a21+a36);
  a36=(a25*a20);
  a39=(a24*a23);
  a30=(a18*a40);
  a39=(a39-a30);
  a39=(a23+a39);
  a30=(a31*a39);
  a36=(a36+a30);
  a21=(a21+a36);
  a21=(a21/a29);
  a35=(a35-a21);
  a21=(a13*a35);
  a38=(a38+a21);
  a23=(a23/a12);
  a18=(a18/a12);
  a21=(a18/a12);
  a21=(a21*a09);
  a23=(a23-a21);
  a39=(a39/a27);
  a25=(a25/a27);
  a21=(a25/a27);
  a21=(a21*a42);
  a39=(a39-a21);
  a20=(a34*a20);
  a21=(a31*a35);
  a20=(a20+a21);
  a39=(a39-a20);
  a20=(a24*a39);
  a21=(a31*a34);
  a25=(a25-a21);
  a40=(a25*a40);
  a20=(a20-a40);
  a23=(a23+a20);
  a38=(a38-a23);
  a38=(a38-a39);
  a23=(a38*a01);
  a26=(a26+a23);
  a23=(a13*a10);
  a33=(a02*a33);
  a23=(a23-a33);
  a20=(a24*a10);
  a20=(a10+a20);
  a40=(a31*a20);
  a23=(a23+a40);
  a23=(a23/a29);
  a40=(a13*a23);
  a10=(a10/a12);
  a20=(a20/a27);
  a21=(a31*a23);
  a20=(a20+a21);
  a21=(a24*a20);
  a10=(a10+a21);
  a40=(a40+a10);
  a40=(a40+a20);
  a10=arg[0]? arg[0][9] : 0;
  a21=(a40*a10);
  a26=(a26+a21);
  a21=(a13*a07);
  a21=(a02-a21);
  a42=(a24*a07);
  a07=(a07+a42);
  a42=(a31*a07);
  a21=(a21-a42);
  a21=(a21/a29);
  a29=(a13*a21);
  a07=(a07/a27);
  a31=(a31*a21);
  a07=(a07-a31);
  a31=(a24*a07);
  a31=(a13+a31);
  a29=(a29-a31);
  a29=(a29-a07);
  a31=arg[0]? arg[0][11] : 0;
  a27=(a29*a31);
  a26=(a26+a27);
  if (res[0]!=0) res[0][1]=a26;
  a26=(a32*a00);
  a27=(a39*a01);
  a26=(a26-a27);
  a27=(a20*a10);
  a26=(a26+a27);
  a27=(a07*a31);
  a26=(a26-a27);
  if (res[0]!=0) res[0][2]=a26;
  a26=arg[0]? arg[0][8] : 0;
  if (res[0]!=0) res[0][3]=a26;
  a26=(a16*a00);
  a27=(a35*a01);
  a26=(a26+a27);
  a10=(a23*a10);
  a26=(a26+a10);
  a31=(a21*a31);
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
  a42=(a20*a10);
  a31=(a31+a42);
  a42=(a07*a27);
  a31=(a31-a42);
  if (res[0]!=0) res[0][8]=a31;
  a31=arg[0]? arg[0][14] : 0;
  if (res[0]!=0) res[0][9]=a31;
  a31=(a16*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a10=(a23*a10);
  a31=(a31+a10);
  a27=(a21*a27);
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
  a42=(a20*a27);
  a31=(a31+a42);
  a42=(a07*a10);
  a31=(a31-a42);
  a31=(a31-a03);
  if (res[0]!=0) res[0][14]=a31;
  a31=arg[0]? arg[0][20] : 0;
  if (res[0]!=0) res[0][15]=a31;
  a31=(a16*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a27=(a23*a27);
  a31=(a31+a27);
  a10=(a21*a10);
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
  a42=(a20*a10);
  a31=(a31+a42);
  a42=(a07*a27);
  a31=(a31-a42);
  if (res[0]!=0) res[0][20]=a31;
  a31=arg[0]? arg[0][26] : 0;
  a31=(a31-a03);
  if (res[0]!=0) res[0][21]=a31;
  a31=(a16*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a10=(a23*a10);
  a31=(a31+a10);
  a27=(a21*a27);
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
  a42=(a20*a27);
  a31=(a31+a42);
  a42=(a07*a10);
  a31=(a31-a42);
  if (res[0]!=0) res[0][26]=a31;
  a31=arg[0]? arg[0][32] : 0;
  if (res[0]!=0) res[0][27]=a31;
  a31=(a16*a00);
  a42=(a35*a01);
  a31=(a31+a42);
  a27=(a23*a27);
  a31=(a31+a27);
  a10=(a21*a10);
  a31=(a31+a10);
  a31=(a31-a03);
  if (res[0]!=0) res[0][28]=a31;
  a00=(a26*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][29]=a00;
  a00=arg[0]? arg[0][4] : 0;
  a01=(a14-a00);
  if (res[0]!=0) res[0][30]=a01;
  a37=(a37*a14);
  a38=(a38*a00);
  a37=(a37+a38);
  a38=(a08*a00);
  a38=(a38*a28);
  a01=(2.*a14);
  a01=(a01-a00);
  a38=(a38*a01);
  a38=(a15-a38);
  a01=(a19-a15);
  a01=(a08*a01);
  a38=(a38-a01);
  a01=(a38/a12);
  a31=(a11/a12);
  a10=casadi_sq(a14);
  a10=(a10*a28);
  a10=(a10+a19);
  a10=(a08*a10);
  a19=arg[3]? arg[3][5] : 0;
  a28=arg[3]? arg[3][7] : 0;
  a27=arg[3]? arg[3][2] : 0;
  a42=(a28*a27);
  a09=arg[2]? arg[2][0] : 0;
  a27=(a27*a09);
  a09=sin(a27);
  a42=(a42*a09);
  a42=(a00+a42);
  a19=(a19*a42);
  a42=arg[3]? arg[3][4] : 0;
  a09=arg[3]? arg[3][6] : 0;
  a27=cos(a27);
  a27=(a27+a03);
  a28=(a28*a27);
  a09=(a09-a28);
  a09=(a09+a05);
  a42=(a42*a09);
  a19=(a19+a42);
  a10=(a10-a19);
  a19=(a31*a38);
  a10=(a10-a19);
  a19=(a11*a31);
  a08=(a08-a19);
  a19=(a10/a08);
  a12=(a33/a12);
  a11=(a11*a12);
  a08=(a11/a08);
  a38=(a12*a38);
  a42=(a02*a14);
  a42=(a42*a14);
  a42=(a42*a15);
  a15=arg[3]? arg[3][0] : 0;
  a09=arg[0]? arg[0][2] : 0;
  a15=(a15*a09);
  a42=(a42+a15);
  a38=(a38-a42);
  a10=(a08*a10);
  a38=(a38-a10);
  a33=(a33*a12);
  a02=(a02-a33);
  a11=(a11*a08);
  a02=(a02-a11);
  a38=(a38/a02);
  a08=(a08*a38);
  a19=(a19-a08);
  a31=(a31*a19);
  a01=(a01-a31);
  a12=(a12*a38);
  a01=(a01+a12);
  a40=(a40*a01);
  a37=(a37+a40);
  a29=(a29*a38);
  a37=(a37+a29);
  if (res[0]!=0) res[0][31]=a37;
  a32=(a32*a14);
  a39=(a39*a00);
  a32=(a32-a39);
  a20=(a20*a01);
  a32=(a32+a20);
  a07=(a07*a38);
  a32=(a32-a07);
  if (res[0]!=0) res[0][32]=a32;
  if (res[0]!=0) res[0][33]=a17;
  a16=(a16*a14);
  a35=(a35*a00);
  a16=(a16+a35);
  a23=(a23*a01);
  a16=(a16+a23);
  a21=(a21*a38);
  a16=(a16+a21);
  if (res[0]!=0) res[0][34]=a16;
  a26=(a26*a14);
  a26=(a26+a00);
  if (res[0]!=0) res[0][35]=a26;
  a26=arg[1]? arg[1][0] : 0;
  a06=(a06-a26);
  if (res[1]!=0) res[1][0]=a06;
  a13=(a13*a34);
  a24=(a24*a25);
  a18=(a18+a24);
  a13=(a13-a18);
  a13=(a13-a25);
  a18=arg[1]? arg[1][1] : 0;
  a13=(a13-a18);
  if (res[1]!=0) res[1][1]=a13;
  a13=arg[1]? arg[1][2] : 0;
  a25=(a25+a13);
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
  for (iter=0; iter<14; ++iter) {
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
  a007=sin(a000);
  a008=arg[3]? arg[3][3] : 0;
  a009=arg[0]? arg[0][4] : 0;
  a010=(a008*a009);
  a011=arg[0]? arg[0][1] : 0;
  a012=sin(a011);
  a010=(a010*a012);
  a013=(2.*a003);
  a013=(a013-a009);
  a010=(a010*a013);
  a010=(a007-a010);
  a013=(a000-a011);
  a013=sin(a013);
  a014=(a013-a007);
  a014=(a008*a014);
  a010=(a010-a014);
  a014=1.;
  a015=(2.*a008);
  a016=cos(a011);
  a016=(a016-a014);
  a017=(a015*a016);
  a017=(a014-a017);
  a018=(a010/a017);
  a016=(a008*a016);
  a019=(a016/a017);
  a020=casadi_sq(a003);
  a020=(a020*a012);
  a020=(a020+a013);
  a020=(a008*a020);
  a013=arg[3]? arg[3][5] : 0;
  a012=arg[3]? arg[3][7] : 0;
  a021=arg[3]? arg[3][2] : 0;
  a022=(a012*a021);
  a023=arg[1]? arg[1][0] : 0;
  a024=(a021*a023);
  a025=sin(a024);
  a025=(a022*a025);
  a025=(a009+a025);
  a025=(a013*a025);
  a026=arg[3]? arg[3][4] : 0;
  a027=arg[3]? arg[3][6] : 0;
  a024=cos(a024);
  a024=(a024+a014);
  a024=(a012*a024);
  a024=(a027-a024);
  a024=(a024+a011);
  a024=(a026*a024);
  a025=(a025+a024);
  a020=(a020-a025);
  a025=(a019*a010);
  a020=(a020-a025);
  a025=(a016*a019);
  a025=(a008-a025);
  a024=(a020/a025);
  a028=arg[3]? arg[3][1] : 0;
  a029=cos(a000);
  a029=(a028*a029);
  a017=(a029/a017);
  a016=(a016*a017);
  a025=(a016/a025);
  a010=(a017*a010);
  a030=(a028*a003);
  a030=(a030*a003);
  a030=(a030*a007);
  a007=arg[3]? arg[3][0] : 0;
  a031=arg[0]? arg[0][2] : 0;
  a032=(a007*a031);
  a030=(a030+a032);
  a010=(a010-a030);
  a020=(a025*a020);
  a010=(a010-a020);
  a029=(a029*a017);
  a029=(a028-a029);
  a016=(a016*a025);
  a029=(a029-a016);
  a010=(a010/a029);
  a025=(a025*a010);
  a024=(a024-a025);
  a019=(a019*a024);
  a018=(a018-a019);
  a017=(a017*a010);
  a018=(a018+a017);
  a017=(a006*a018);
  a019=1.7082860872947386e-01;
  a019=(a019*a002);
  a025=2.9587585476806851e-02;
  a025=(a025*a002);
  a029=(a025*a003);
  a016=8.8762756430420545e-02;
  a016=(a016*a002);
  a020=1.9725056984537900e-02;
  a020=(a020*a002);
  a030=(a020*a018);
  a032=5.9175170953613701e-02;
  a032=(a032*a002);
  a033=5.2600151958767730e-02;
  a033=(a033*a002);
  a034=(a033*a003);
  a034=(a000+a034);
  a035=sin(a034);
  a036=(a033*a024);
  a036=(a009+a036);
  a037=(a008*a036);
  a038=(a033*a009);
  a038=(a011+a038);
  a039=sin(a038);
  a037=(a037*a039);
  a040=(a033*a018);
  a040=(a003+a040);
  a041=(2.*a040);
  a041=(a041-a036);
  a037=(a037*a041);
  a037=(a035-a037);
  a041=(a034-a038);
  a041=sin(a041);
  a042=(a041-a035);
  a042=(a008*a042);
  a037=(a037-a042);
  a042=cos(a038);
  a042=(a042-a014);
  a043=(a015*a042);
  a043=(a014-a043);
  a044=(a037/a043);
  a042=(a008*a042);
  a045=(a042/a043);
  a046=casadi_sq(a040);
  a046=(a046*a039);
  a046=(a046+a041);
  a046=(a008*a046);
  a041=(a023+a033);
  a041=(a021*a041);
  a039=sin(a041);
  a039=(a022*a039);
  a039=(a036+a039);
  a039=(a013*a039);
  a041=cos(a041);
  a041=(a041+a014);
  a041=(a012*a041);
  a041=(a027-a041);
  a041=(a041+a038);
  a041=(a026*a041);
  a039=(a039+a041);
  a046=(a046-a039);
  a039=(a045*a037);
  a046=(a046-a039);
  a039=(a042*a045);
  a039=(a008-a039);
  a041=(a046/a039);
  a034=cos(a034);
  a034=(a028*a034);
  a043=(a034/a043);
  a042=(a042*a043);
  a039=(a042/a039);
  a037=(a043*a037);
  a038=(a028*a040);
  a038=(a038*a040);
  a038=(a038*a035);
  a035=arg[0]? arg[0][5] : 0;
  a047=(a033*a035);
  a047=(a031+a047);
  a047=(a007*a047);
  a038=(a038+a047);
  a037=(a037-a038);
  a046=(a039*a046);
  a037=(a037-a046);
  a034=(a034*a043);
  a034=(a028-a034);
  a042=(a042*a039);
  a034=(a034-a042);
  a037=(a037/a034);
  a039=(a039*a037);
  a041=(a041-a039);
  a045=(a045*a041);
  a044=(a044-a045);
  a043=(a043*a037);
  a044=(a044+a043);
  a044=(a032*a044);
  a030=(a030+a044);
  a030=(a003+a030);
  a044=(a016*a030);
  a029=(a029+a044);
  a029=(a000+a029);
  a044=sin(a029);
  a043=(a025*a024);
  a045=casadi_sq(a030);
  a039=(a020*a009);
  a036=(a032*a036);
  a039=(a039+a036);
  a039=(a011+a039);
  a036=sin(a039);
  a045=(a045*a036);
  a034=(a020*a003);
  a040=(a032*a040);
  a034=(a034+a040);
  a034=(a000+a034);
  a040=(a034-a039);
  a040=sin(a040);
  a045=(a045+a040);
  a045=(a008*a045);
  a042=(a020*a024);
  a041=(a032*a041);
  a042=(a042+a041);
  a042=(a009+a042);
  a041=7.8900227938151601e-02;
  a041=(a041*a002);
  a041=(a023+a041);
  a041=(a021*a041);
  a046=sin(a041);
  a046=(a022*a046);
  a046=(a042+a046);
  a046=(a013*a046);
  a041=cos(a041);
  a041=(a041+a014);
  a041=(a012*a041);
  a041=(a027-a041);
  a041=(a041+a039);
  a041=(a026*a041);
  a046=(a046+a041);
  a045=(a045-a046);
  a039=cos(a039);
  a039=(a039-a014);
  a046=(a008*a039);
  a039=(a015*a039);
  a039=(a014-a039);
  a041=(a046/a039);
  a038=sin(a034);
  a047=(a008*a042);
  a047=(a047*a036);
  a036=(2.*a030);
  a036=(a036-a042);
  a047=(a047*a036);
  a047=(a038-a047);
  a040=(a040-a038);
  a040=(a008*a040);
  a047=(a047-a040);
  a040=(a041*a047);
  a045=(a045-a040);
  a040=(a046*a041);
  a040=(a008-a040);
  a036=(a045/a040);
  a034=cos(a034);
  a034=(a028*a034);
  a048=(a034/a039);
  a046=(a046*a048);
  a040=(a046/a040);
  a049=(a048*a047);
  a050=(a028*a030);
  a050=(a050*a030);
  a050=(a050*a038);
  a038=(a020*a035);
  a033=(a033*a010);
  a033=(a035+a033);
  a033=(a032*a033);
  a038=(a038+a033);
  a038=(a031+a038);
  a038=(a007*a038);
  a050=(a050+a038);
  a049=(a049-a050);
  a045=(a040*a045);
  a049=(a049-a045);
  a034=(a034*a048);
  a034=(a028-a034);
  a046=(a046*a040);
  a034=(a034-a046);
  a049=(a049/a034);
  a040=(a040*a049);
  a036=(a036-a040);
  a040=(a016*a036);
  a043=(a043+a040);
  a043=(a009+a043);
  a040=(a008*a043);
  a034=(a025*a009);
  a046=(a016*a042);
  a034=(a034+a046);
  a034=(a011+a034);
  a046=sin(a034);
  a040=(a040*a046);
  a045=(a025*a018);
  a047=(a047/a039);
  a041=(a041*a036);
  a047=(a047-a041);
  a048=(a048*a049);
  a047=(a047+a048);
  a048=(a016*a047);
  a045=(a045+a048);
  a045=(a003+a045);
  a048=(2.*a045);
  a048=(a048-a043);
  a040=(a040*a048);
  a040=(a044-a040);
  a048=(a029-a034);
  a048=sin(a048);
  a041=(a048-a044);
  a041=(a008*a041);
  a040=(a040-a041);
  a041=cos(a034);
  a041=(a041-a014);
  a039=(a015*a041);
  a039=(a014-a039);
  a050=(a040/a039);
  a041=(a008*a041);
  a038=(a041/a039);
  a033=casadi_sq(a045);
  a033=(a033*a046);
  a033=(a033+a048);
  a033=(a008*a033);
  a048=1.1835034190722740e-01;
  a048=(a048*a002);
  a048=(a023+a048);
  a048=(a021*a048);
  a046=sin(a048);
  a046=(a022*a046);
  a046=(a043+a046);
  a046=(a013*a046);
  a048=cos(a048);
  a048=(a048+a014);
  a048=(a012*a048);
  a048=(a027-a048);
  a048=(a048+a034);
  a048=(a026*a048);
  a046=(a046+a048);
  a033=(a033-a046);
  a046=(a038*a040);
  a033=(a033-a046);
  a046=(a041*a038);
  a046=(a008-a046);
  a048=(a033/a046);
  a029=cos(a029);
  a029=(a028*a029);
  a039=(a029/a039);
  a041=(a041*a039);
  a046=(a041/a046);
  a040=(a039*a040);
  a034=(a028*a045);
  a034=(a034*a045);
  a034=(a034*a044);
  a044=(a025*a035);
  a020=(a020*a010);
  a032=(a032*a037);
  a020=(a020+a032);
  a020=(a035+a020);
  a032=(a016*a020);
  a044=(a044+a032);
  a044=(a031+a044);
  a044=(a007*a044);
  a034=(a034+a044);
  a040=(a040-a034);
  a033=(a046*a033);
  a040=(a040-a033);
  a029=(a029*a039);
  a029=(a028-a029);
  a041=(a041*a046);
  a029=(a029-a041);
  a040=(a040/a029);
  a046=(a046*a040);
  a048=(a048-a046);
  a038=(a038*a048);
  a050=(a050-a038);
  a039=(a039*a040);
  a050=(a050+a039);
  a039=(a019*a050);
  a017=(a017+a039);
  a039=1.2546768756682242e-01;
  a039=(a039*a002);
  a038=2.4136513415926669e-01;
  a038=(a038*a002);
  a046=(a038*a003);
  a029=-8.8454947932828609e-01;
  a029=(a029*a002);
  a030=(a029*a030);
  a046=(a046+a030);
  a030=9.2483400326179199e-01;
  a030=(a030*a002);
  a041=(a030*a045);
  a046=(a046+a041);
  a046=(a000+a046);
  a041=sin(a046);
  a033=(a038*a024);
  a036=(a029*a036);
  a033=(a033+a036);
  a036=(a030*a048);
  a033=(a033+a036);
  a033=(a009+a033);
  a036=(a008*a033);
  a034=(a038*a009);
  a042=(a029*a042);
  a034=(a034+a042);
  a042=(a030*a043);
  a034=(a034+a042);
  a034=(a011+a034);
  a042=sin(a034);
  a036=(a036*a042);
  a044=(a038*a018);
  a047=(a029*a047);
  a044=(a044+a047);
  a047=(a030*a050);
  a044=(a044+a047);
  a044=(a003+a044);
  a047=(2.*a044);
  a047=(a047-a033);
  a036=(a036*a047);
  a036=(a041-a036);
  a047=(a046-a034);
  a047=sin(a047);
  a032=(a047-a041);
  a032=(a008*a032);
  a036=(a036-a032);
  a032=cos(a034);
  a032=(a032-a014);
  a037=(a015*a032);
  a037=(a014-a037);
  a051=(a036/a037);
  a032=(a008*a032);
  a052=(a032/a037);
  a053=casadi_sq(a044);
  a053=(a053*a042);
  a053=(a053+a047);
  a053=(a008*a053);
  a047=2.8164965809277259e-01;
  a047=(a047*a002);
  a047=(a023+a047);
  a047=(a021*a047);
  a042=sin(a047);
  a042=(a022*a042);
  a042=(a033+a042);
  a042=(a013*a042);
  a047=cos(a047);
  a047=(a047+a014);
  a047=(a012*a047);
  a047=(a027-a047);
  a047=(a047+a034);
  a047=(a026*a047);
  a042=(a042+a047);
  a053=(a053-a042);
  a042=(a052*a036);
  a053=(a053-a042);
  a042=(a032*a052);
  a042=(a008-a042);
  a047=(a053/a042);
  a046=cos(a046);
  a046=(a028*a046);
  a037=(a046/a037);
  a032=(a032*a037);
  a042=(a032/a042);
  a036=(a037*a036);
  a034=(a028*a044);
  a034=(a034*a044);
  a034=(a034*a041);
  a041=(a038*a035);
  a020=(a029*a020);
  a041=(a041+a020);
  a025=(a025*a010);
  a016=(a016*a049);
  a025=(a025+a016);
  a025=(a035+a025);
  a016=(a030*a025);
  a041=(a041+a016);
  a041=(a031+a041);
  a041=(a007*a041);
  a034=(a034+a041);
  a036=(a036-a034);
  a053=(a042*a053);
  a036=(a036-a053);
  a046=(a046*a037);
  a046=(a028-a046);
  a032=(a032*a042);
  a046=(a046-a032);
  a036=(a036/a046);
  a042=(a042*a036);
  a047=(a047-a042);
  a052=(a052*a047);
  a051=(a051-a052);
  a037=(a037*a036);
  a051=(a051+a037);
  a037=(a039*a051);
  a017=(a017+a037);
  a017=(a003+a017);
  a037=(a005*a017);
  a004=(a004+a037);
  a037=1.8915178993145003e+00;
  a037=(a037*a002);
  a052=3.7109375000000000e-02;
  a052=(a052*a002);
  a042=(a052*a018);
  a046=1.7025221101954405e-01;
  a046=(a046*a002);
  a032=(a046*a050);
  a042=(a042+a032);
  a032=6.0216538980455959e-02;
  a032=(a032*a002);
  a053=(a032*a051);
  a042=(a042+a053);
  a053=-1.7578125000000000e-02;
  a053=(a053*a002);
  a034=(a006*a003);
  a041=(a019*a045);
  a034=(a034+a041);
  a041=(a039*a044);
  a034=(a034+a041);
  a034=(a000+a034);
  a041=sin(a034);
  a016=(a006*a024);
  a020=(a019*a048);
  a016=(a016+a020);
  a020=(a039*a047);
  a016=(a016+a020);
  a016=(a009+a016);
  a020=(a008*a016);
  a054=(a006*a009);
  a055=(a019*a043);
  a054=(a054+a055);
  a055=(a039*a033);
  a054=(a054+a055);
  a054=(a011+a054);
  a055=sin(a054);
  a020=(a020*a055);
  a056=(2.*a017);
  a056=(a056-a016);
  a020=(a020*a056);
  a020=(a041-a020);
  a056=(a034-a054);
  a056=sin(a056);
  a057=(a056-a041);
  a057=(a008*a057);
  a020=(a020-a057);
  a057=cos(a054);
  a057=(a057-a014);
  a058=(a015*a057);
  a058=(a014-a058);
  a059=(a020/a058);
  a057=(a008*a057);
  a060=(a057/a058);
  a061=casadi_sq(a017);
  a061=(a061*a055);
  a061=(a061+a056);
  a061=(a008*a061);
  a056=3.3333333333333331e-01;
  a056=(a056*a002);
  a056=(a023+a056);
  a056=(a021*a056);
  a055=sin(a056);
  a055=(a022*a055);
  a055=(a016+a055);
  a055=(a013*a055);
  a056=cos(a056);
  a056=(a056+a014);
  a056=(a012*a056);
  a056=(a027-a056);
  a056=(a056+a054);
  a056=(a026*a056);
  a055=(a055+a056);
  a061=(a061-a055);
  a055=(a060*a020);
  a061=(a061-a055);
  a055=(a057*a060);
  a055=(a008-a055);
  a056=(a061/a055);
  a034=cos(a034);
  a034=(a028*a034);
  a058=(a034/a058);
  a057=(a057*a058);
  a055=(a057/a055);
  a020=(a058*a020);
  a054=(a028*a017);
  a054=(a054*a017);
  a054=(a054*a041);
  a041=(a006*a035);
  a062=(a019*a025);
  a041=(a041+a062);
  a038=(a038*a010);
  a029=(a029*a049);
  a038=(a038+a029);
  a030=(a030*a040);
  a038=(a038+a030);
  a038=(a035+a038);
  a030=(a039*a038);
  a041=(a041+a030);
  a041=(a031+a041);
  a041=(a007*a041);
  a054=(a054+a041);
  a020=(a020-a054);
  a061=(a055*a061);
  a020=(a020-a061);
  a034=(a034*a058);
  a034=(a028-a034);
  a057=(a057*a055);
  a034=(a034-a057);
  a020=(a020/a034);
  a055=(a055*a020);
  a056=(a056-a055);
  a060=(a060*a056);
  a059=(a059-a060);
  a058=(a058*a020);
  a059=(a059+a058);
  a058=(a053*a059);
  a042=(a042+a058);
  a042=(a003+a042);
  a058=(a037*a042);
  a004=(a004+a058);
  a058=-5.8012039600105849e+00;
  a058=(a058*a002);
  a060=3.7092000118504789e-02;
  a060=(a060*a002);
  a055=(a060*a018);
  a034=1.7038392571223998e-01;
  a034=(a034*a002);
  a057=(a034*a050);
  a055=(a055+a057);
  a057=1.0726203044637328e-01;
  a057=(a057*a002);
  a061=(a057*a051);
  a055=(a055+a061);
  a061=-1.5319437748624402e-02;
  a061=(a061*a002);
  a054=(a061*a059);
  a055=(a055+a054);
  a054=8.2737891638140233e-03;
  a054=(a054*a002);
  a041=(a052*a003);
  a030=(a046*a045);
  a041=(a041+a030);
  a030=(a032*a044);
  a041=(a041+a030);
  a030=(a053*a017);
  a041=(a041+a030);
  a041=(a000+a041);
  a030=sin(a041);
  a029=(a052*a024);
  a049=(a046*a048);
  a029=(a029+a049);
  a049=(a032*a047);
  a029=(a029+a049);
  a049=(a053*a056);
  a029=(a029+a049);
  a029=(a009+a029);
  a049=(a008*a029);
  a062=(a052*a009);
  a063=(a046*a043);
  a062=(a062+a063);
  a063=(a032*a033);
  a062=(a062+a063);
  a063=(a053*a016);
  a062=(a062+a063);
  a062=(a011+a062);
  a063=sin(a062);
  a049=(a049*a063);
  a064=(2.*a042);
  a064=(a064-a029);
  a049=(a049*a064);
  a049=(a030-a049);
  a064=(a041-a062);
  a064=sin(a064);
  a065=(a064-a030);
  a065=(a008*a065);
  a049=(a049-a065);
  a065=cos(a062);
  a065=(a065-a014);
  a066=(a015*a065);
  a066=(a014-a066);
  a067=(a049/a066);
  a065=(a008*a065);
  a068=(a065/a066);
  a069=casadi_sq(a042);
  a069=(a069*a063);
  a069=(a069+a064);
  a069=(a008*a069);
  a064=2.5000000000000000e-01;
  a064=(a064*a002);
  a064=(a023+a064);
  a064=(a021*a064);
  a063=sin(a064);
  a063=(a022*a063);
  a063=(a029+a063);
  a063=(a013*a063);
  a064=cos(a064);
  a064=(a064+a014);
  a064=(a012*a064);
  a064=(a027-a064);
  a064=(a064+a062);
  a064=(a026*a064);
  a063=(a063+a064);
  a069=(a069-a063);
  a063=(a068*a049);
  a069=(a069-a063);
  a063=(a065*a068);
  a063=(a008-a063);
  a064=(a069/a063);
  a041=cos(a041);
  a041=(a028*a041);
  a066=(a041/a066);
  a065=(a065*a066);
  a063=(a065/a063);
  a049=(a066*a049);
  a062=(a028*a042);
  a062=(a062*a042);
  a062=(a062*a030);
  a030=(a052*a035);
  a070=(a046*a025);
  a030=(a030+a070);
  a070=(a032*a038);
  a030=(a030+a070);
  a006=(a006*a010);
  a019=(a019*a040);
  a006=(a006+a019);
  a039=(a039*a036);
  a006=(a006+a039);
  a006=(a035+a006);
  a039=(a053*a006);
  a030=(a030+a039);
  a030=(a031+a030);
  a030=(a007*a030);
  a062=(a062+a030);
  a049=(a049-a062);
  a069=(a063*a069);
  a049=(a049-a069);
  a041=(a041*a066);
  a041=(a028-a041);
  a065=(a065*a063);
  a041=(a041-a065);
  a049=(a049/a041);
  a063=(a063*a049);
  a064=(a064-a063);
  a068=(a068*a064);
  a067=(a067-a068);
  a066=(a066*a049);
  a067=(a067+a066);
  a066=(a054*a067);
  a055=(a055+a066);
  a055=(a003+a055);
  a066=(a058*a055);
  a004=(a004+a066);
  a066=3.1116436695781990e-01;
  a066=(a066*a002);
  a068=6.2411095871607569e-01;
  a068=(a068*a002);
  a063=(a068*a018);
  a041=-3.3608926294469414e+00;
  a041=(a041*a002);
  a065=(a041*a050);
  a063=(a063+a065);
  a065=-8.6821934684172597e-01;
  a065=(a065*a002);
  a069=(a065*a051);
  a063=(a063+a069);
  a069=2.7592099699446710e+01;
  a069=(a069*a002);
  a062=(a069*a059);
  a063=(a063+a062);
  a062=2.0154067550477894e+01;
  a062=(a062*a002);
  a030=(a062*a067);
  a063=(a063+a030);
  a030=-4.3489884181069961e+01;
  a030=(a030*a002);
  a039=(a060*a003);
  a019=(a034*a045);
  a039=(a039+a019);
  a019=(a057*a044);
  a039=(a039+a019);
  a019=(a061*a017);
  a039=(a039+a019);
  a019=(a054*a042);
  a039=(a039+a019);
  a039=(a000+a039);
  a019=sin(a039);
  a070=(a060*a024);
  a071=(a034*a048);
  a070=(a070+a071);
  a071=(a057*a047);
  a070=(a070+a071);
  a071=(a061*a056);
  a070=(a070+a071);
  a071=(a054*a064);
  a070=(a070+a071);
  a070=(a009+a070);
  a071=(a008*a070);
  a072=(a060*a009);
  a073=(a034*a043);
  a072=(a072+a073);
  a073=(a057*a033);
  a072=(a072+a073);
  a073=(a061*a016);
  a072=(a072+a073);
  a073=(a054*a029);
  a072=(a072+a073);
  a072=(a011+a072);
  a073=sin(a072);
  a071=(a071*a073);
  a074=(2.*a055);
  a074=(a074-a070);
  a071=(a071*a074);
  a071=(a019-a071);
  a074=(a039-a072);
  a074=sin(a074);
  a075=(a074-a019);
  a075=(a008*a075);
  a071=(a071-a075);
  a075=cos(a072);
  a075=(a075-a014);
  a076=(a015*a075);
  a076=(a014-a076);
  a077=(a071/a076);
  a075=(a008*a075);
  a078=(a075/a076);
  a079=casadi_sq(a055);
  a079=(a079*a073);
  a079=(a079+a074);
  a079=(a008*a079);
  a074=3.0769230769230771e-01;
  a074=(a074*a002);
  a074=(a023+a074);
  a074=(a021*a074);
  a073=sin(a074);
  a073=(a022*a073);
  a073=(a070+a073);
  a073=(a013*a073);
  a074=cos(a074);
  a074=(a074+a014);
  a074=(a012*a074);
  a074=(a027-a074);
  a074=(a074+a072);
  a074=(a026*a074);
  a073=(a073+a074);
  a079=(a079-a073);
  a073=(a078*a071);
  a079=(a079-a073);
  a073=(a075*a078);
  a073=(a008-a073);
  a074=(a079/a073);
  a039=cos(a039);
  a039=(a028*a039);
  a076=(a039/a076);
  a075=(a075*a076);
  a073=(a075/a073);
  a071=(a076*a071);
  a072=(a028*a055);
  a072=(a072*a055);
  a072=(a072*a019);
  a019=(a060*a035);
  a080=(a034*a025);
  a019=(a019+a080);
  a080=(a057*a038);
  a019=(a019+a080);
  a080=(a061*a006);
  a019=(a019+a080);
  a052=(a052*a010);
  a046=(a046*a040);
  a052=(a052+a046);
  a032=(a032*a036);
  a052=(a052+a032);
  a053=(a053*a020);
  a052=(a052+a053);
  a052=(a035+a052);
  a053=(a054*a052);
  a019=(a019+a053);
  a019=(a031+a019);
  a019=(a007*a019);
  a072=(a072+a019);
  a071=(a071-a072);
  a079=(a073*a079);
  a071=(a071-a079);
  a039=(a039*a076);
  a039=(a028-a039);
  a075=(a075*a073);
  a039=(a039-a075);
  a071=(a071/a039);
  a073=(a073*a071);
  a074=(a074-a073);
  a078=(a078*a074);
  a077=(a077-a078);
  a076=(a076*a071);
  a077=(a077+a076);
  a076=(a030*a077);
  a063=(a063+a076);
  a063=(a003+a063);
  a076=(a066*a063);
  a004=(a004+a076);
  a076=-1.5216094966251609e-01;
  a076=(a076*a002);
  a078=4.7766253643826434e-01;
  a078=(a078*a002);
  a073=(a078*a018);
  a039=-2.4881146199716677e+00;
  a039=(a039*a002);
  a075=(a039*a050);
  a073=(a073+a075);
  a075=-5.9029082683684297e-01;
  a075=(a075*a002);
  a079=(a075*a051);
  a073=(a073+a079);
  a079=2.1230051448181193e+01;
  a079=(a079*a002);
  a072=(a079*a059);
  a073=(a073+a072);
  a072=1.5279233632882423e+01;
  a072=(a072*a002);
  a019=(a072*a067);
  a073=(a073+a019);
  a019=-3.3288210968984863e+01;
  a019=(a019*a002);
  a053=(a019*a077);
  a073=(a073+a053);
  a053=-2.0331201708508627e-02;
  a053=(a053*a002);
  a032=(a068*a003);
  a046=(a041*a045);
  a032=(a032+a046);
  a046=(a065*a044);
  a032=(a032+a046);
  a046=(a069*a017);
  a032=(a032+a046);
  a046=(a062*a042);
  a032=(a032+a046);
  a046=(a030*a055);
  a032=(a032+a046);
  a032=(a000+a032);
  a046=sin(a032);
  a080=(a068*a024);
  a081=(a041*a048);
  a080=(a080+a081);
  a081=(a065*a047);
  a080=(a080+a081);
  a081=(a069*a056);
  a080=(a080+a081);
  a081=(a062*a064);
  a080=(a080+a081);
  a081=(a030*a074);
  a080=(a080+a081);
  a080=(a009+a080);
  a081=(a008*a080);
  a082=(a068*a009);
  a083=(a041*a043);
  a082=(a082+a083);
  a083=(a065*a033);
  a082=(a082+a083);
  a083=(a069*a016);
  a082=(a082+a083);
  a083=(a062*a029);
  a082=(a082+a083);
  a083=(a030*a070);
  a082=(a082+a083);
  a082=(a011+a082);
  a083=sin(a082);
  a081=(a081*a083);
  a084=(2.*a063);
  a084=(a084-a080);
  a081=(a081*a084);
  a081=(a046-a081);
  a084=(a032-a082);
  a084=sin(a084);
  a085=(a084-a046);
  a085=(a008*a085);
  a081=(a081-a085);
  a085=cos(a082);
  a085=(a085-a014);
  a086=(a015*a085);
  a086=(a014-a086);
  a087=(a081/a086);
  a085=(a008*a085);
  a088=(a085/a086);
  a089=casadi_sq(a063);
  a089=(a089*a083);
  a089=(a089+a084);
  a089=(a008*a089);
  a084=6.5128205128205130e-01;
  a084=(a084*a002);
  a084=(a023+a084);
  a084=(a021*a084);
  a083=sin(a084);
  a083=(a022*a083);
  a083=(a080+a083);
  a083=(a013*a083);
  a084=cos(a084);
  a084=(a084+a014);
  a084=(a012*a084);
  a084=(a027-a084);
  a084=(a084+a082);
  a084=(a026*a084);
  a083=(a083+a084);
  a089=(a089-a083);
  a083=(a088*a081);
  a089=(a089-a083);
  a083=(a085*a088);
  a083=(a008-a083);
  a084=(a089/a083);
  a032=cos(a032);
  a032=(a028*a032);
  a086=(a032/a086);
  a085=(a085*a086);
  a083=(a085/a083);
  a081=(a086*a081);
  a082=(a028*a063);
  a082=(a082*a063);
  a082=(a082*a046);
  a046=(a068*a035);
  a090=(a041*a025);
  a046=(a046+a090);
  a090=(a065*a038);
  a046=(a046+a090);
  a090=(a069*a006);
  a046=(a046+a090);
  a090=(a062*a052);
  a046=(a046+a090);
  a060=(a060*a010);
  a034=(a034*a040);
  a060=(a060+a034);
  a057=(a057*a036);
  a060=(a060+a057);
  a061=(a061*a020);
  a060=(a060+a061);
  a054=(a054*a049);
  a060=(a060+a054);
  a060=(a035+a060);
  a054=(a030*a060);
  a046=(a046+a054);
  a046=(a031+a046);
  a046=(a007*a046);
  a082=(a082+a046);
  a081=(a081-a082);
  a089=(a083*a089);
  a081=(a081-a089);
  a032=(a032*a086);
  a032=(a028-a032);
  a085=(a085*a083);
  a032=(a032-a085);
  a081=(a081/a032);
  a083=(a083*a081);
  a084=(a084-a083);
  a088=(a088*a084);
  a087=(a087-a088);
  a086=(a086*a081);
  a087=(a087+a086);
  a086=(a053*a087);
  a073=(a073+a086);
  a073=(a003+a073);
  a086=(a076*a073);
  a004=(a004+a086);
  a086=2.0136540080403034e-01;
  a086=(a086*a002);
  a088=-9.3714243008598730e-01;
  a088=(a088*a002);
  a083=(a088*a018);
  a032=5.1863724288440638e+00;
  a032=(a032*a002);
  a085=(a032*a050);
  a083=(a083+a085);
  a085=1.0914373489967295e+00;
  a085=(a085*a002);
  a089=(a085*a051);
  a083=(a083+a089);
  a089=-8.1497870107469268e+00;
  a089=(a089*a002);
  a082=(a089*a059);
  a083=(a083+a082);
  a082=-1.8520065659996959e+01;
  a082=(a082*a002);
  a046=(a082*a067);
  a083=(a083+a046);
  a046=2.2739487099350505e+01;
  a046=(a046*a002);
  a054=(a046*a077);
  a083=(a083+a054);
  a054=2.4936055526796523e+00;
  a054=(a054*a002);
  a061=(a054*a087);
  a083=(a083+a061);
  a061=-3.0467644718982196e+00;
  a061=(a061*a002);
  a057=(a078*a003);
  a034=(a039*a045);
  a057=(a057+a034);
  a034=(a075*a044);
  a057=(a057+a034);
  a034=(a079*a017);
  a057=(a057+a034);
  a034=(a072*a042);
  a057=(a057+a034);
  a034=(a019*a055);
  a057=(a057+a034);
  a034=(a053*a063);
  a057=(a057+a034);
  a057=(a000+a057);
  a034=sin(a057);
  a090=(a078*a024);
  a091=(a039*a048);
  a090=(a090+a091);
  a091=(a075*a047);
  a090=(a090+a091);
  a091=(a079*a056);
  a090=(a090+a091);
  a091=(a072*a064);
  a090=(a090+a091);
  a091=(a019*a074);
  a090=(a090+a091);
  a091=(a053*a084);
  a090=(a090+a091);
  a090=(a009+a090);
  a091=(a008*a090);
  a092=(a078*a009);
  a093=(a039*a043);
  a092=(a092+a093);
  a093=(a075*a033);
  a092=(a092+a093);
  a093=(a079*a016);
  a092=(a092+a093);
  a093=(a072*a029);
  a092=(a092+a093);
  a093=(a019*a070);
  a092=(a092+a093);
  a093=(a053*a080);
  a092=(a092+a093);
  a092=(a011+a092);
  a093=sin(a092);
  a091=(a091*a093);
  a094=(2.*a073);
  a094=(a094-a090);
  a091=(a091*a094);
  a091=(a034-a091);
  a094=(a057-a092);
  a094=sin(a094);
  a095=(a094-a034);
  a095=(a008*a095);
  a091=(a091-a095);
  a095=cos(a092);
  a095=(a095-a014);
  a096=(a015*a095);
  a096=(a014-a096);
  a097=(a091/a096);
  a095=(a008*a095);
  a098=(a095/a096);
  a099=casadi_sq(a073);
  a099=(a099*a093);
  a099=(a099+a094);
  a099=(a008*a099);
  a094=5.9999999999999998e-01;
  a094=(a094*a002);
  a094=(a023+a094);
  a094=(a021*a094);
  a093=sin(a094);
  a093=(a022*a093);
  a093=(a090+a093);
  a093=(a013*a093);
  a094=cos(a094);
  a094=(a094+a014);
  a094=(a012*a094);
  a094=(a027-a094);
  a094=(a094+a092);
  a094=(a026*a094);
  a093=(a093+a094);
  a099=(a099-a093);
  a093=(a098*a091);
  a099=(a099-a093);
  a093=(a095*a098);
  a093=(a008-a093);
  a094=(a099/a093);
  a057=cos(a057);
  a057=(a028*a057);
  a096=(a057/a096);
  a095=(a095*a096);
  a093=(a095/a093);
  a091=(a096*a091);
  a092=(a028*a073);
  a092=(a092*a073);
  a092=(a092*a034);
  a034=(a078*a035);
  a100=(a039*a025);
  a034=(a034+a100);
  a100=(a075*a038);
  a034=(a034+a100);
  a100=(a079*a006);
  a034=(a034+a100);
  a100=(a072*a052);
  a034=(a034+a100);
  a100=(a019*a060);
  a034=(a034+a100);
  a068=(a068*a010);
  a041=(a041*a040);
  a068=(a068+a041);
  a065=(a065*a036);
  a068=(a068+a065);
  a069=(a069*a020);
  a068=(a068+a069);
  a062=(a062*a049);
  a068=(a068+a062);
  a030=(a030*a071);
  a068=(a068+a030);
  a068=(a035+a068);
  a030=(a053*a068);
  a034=(a034+a030);
  a034=(a031+a034);
  a034=(a007*a034);
  a092=(a092+a034);
  a091=(a091-a092);
  a099=(a093*a099);
  a091=(a091-a099);
  a057=(a057*a096);
  a057=(a028-a057);
  a095=(a095*a093);
  a057=(a057-a095);
  a091=(a091/a057);
  a093=(a093*a091);
  a094=(a094-a093);
  a098=(a098*a094);
  a097=(a097-a098);
  a096=(a096*a091);
  a097=(a097+a096);
  a096=(a061*a097);
  a083=(a083+a096);
  a083=(a003+a083);
  a096=(a086*a083);
  a004=(a004+a096);
  a096=4.4710615727772587e-02;
  a096=(a096*a002);
  a098=2.2733101475165380e+00;
  a098=(a098*a002);
  a093=(a098*a018);
  a057=-1.0534495466737249e+01;
  a057=(a057*a002);
  a050=(a057*a050);
  a093=(a093+a050);
  a050=-2.0008720582248625e+00;
  a050=(a050*a002);
  a051=(a050*a051);
  a093=(a093+a051);
  a051=-1.7958931863118799e+01;
  a051=(a051*a002);
  a095=(a051*a059);
  a093=(a093+a095);
  a095=2.7948884529419960e+01;
  a095=(a095*a002);
  a099=(a095*a067);
  a093=(a093+a099);
  a099=-2.8589982771350235e+00;
  a099=(a099*a002);
  a092=(a099*a077);
  a093=(a093+a092);
  a092=-8.8728569335306293e+00;
  a092=(a092*a002);
  a034=(a092*a087);
  a093=(a093+a034);
  a034=1.2360567175794303e+01;
  a034=(a034*a002);
  a030=(a034*a097);
  a093=(a093+a030);
  a030=6.4339274601576357e-01;
  a030=(a030*a002);
  a062=(a088*a003);
  a069=(a032*a045);
  a062=(a062+a069);
  a069=(a085*a044);
  a062=(a062+a069);
  a069=(a089*a017);
  a062=(a062+a069);
  a069=(a082*a042);
  a062=(a062+a069);
  a069=(a046*a055);
  a062=(a062+a069);
  a069=(a054*a063);
  a062=(a062+a069);
  a069=(a061*a073);
  a062=(a062+a069);
  a062=(a000+a062);
  a069=sin(a062);
  a065=(a088*a024);
  a041=(a032*a048);
  a065=(a065+a041);
  a041=(a085*a047);
  a065=(a065+a041);
  a041=(a089*a056);
  a065=(a065+a041);
  a041=(a082*a064);
  a065=(a065+a041);
  a041=(a046*a074);
  a065=(a065+a041);
  a041=(a054*a084);
  a065=(a065+a041);
  a041=(a061*a094);
  a065=(a065+a041);
  a065=(a009+a065);
  a041=(a008*a065);
  a100=(a088*a009);
  a101=(a032*a043);
  a100=(a100+a101);
  a101=(a085*a033);
  a100=(a100+a101);
  a101=(a089*a016);
  a100=(a100+a101);
  a101=(a082*a029);
  a100=(a100+a101);
  a101=(a046*a070);
  a100=(a100+a101);
  a101=(a054*a080);
  a100=(a100+a101);
  a101=(a061*a090);
  a100=(a100+a101);
  a100=(a011+a100);
  a101=sin(a100);
  a041=(a041*a101);
  a102=(2.*a083);
  a102=(a102-a065);
  a041=(a041*a102);
  a041=(a069-a041);
  a102=(a062-a100);
  a102=sin(a102);
  a103=(a102-a069);
  a103=(a008*a103);
  a041=(a041-a103);
  a103=cos(a100);
  a103=(a103-a014);
  a104=(a015*a103);
  a104=(a014-a104);
  a105=(a041/a104);
  a103=(a008*a103);
  a106=(a103/a104);
  a107=casadi_sq(a083);
  a107=(a107*a101);
  a107=(a107+a102);
  a107=(a008*a107);
  a102=8.5714285714285710e-01;
  a102=(a102*a002);
  a102=(a023+a102);
  a102=(a021*a102);
  a101=sin(a102);
  a101=(a022*a101);
  a101=(a065+a101);
  a101=(a013*a101);
  a102=cos(a102);
  a102=(a102+a014);
  a102=(a012*a102);
  a102=(a027-a102);
  a102=(a102+a100);
  a102=(a026*a102);
  a101=(a101+a102);
  a107=(a107-a101);
  a101=(a106*a041);
  a107=(a107-a101);
  a101=(a103*a106);
  a101=(a008-a101);
  a102=(a107/a101);
  a062=cos(a062);
  a062=(a028*a062);
  a104=(a062/a104);
  a103=(a103*a104);
  a101=(a103/a101);
  a041=(a104*a041);
  a100=(a028*a083);
  a100=(a100*a083);
  a100=(a100*a069);
  a069=(a088*a035);
  a108=(a032*a025);
  a069=(a069+a108);
  a108=(a085*a038);
  a069=(a069+a108);
  a108=(a089*a006);
  a069=(a069+a108);
  a108=(a082*a052);
  a069=(a069+a108);
  a108=(a046*a060);
  a069=(a069+a108);
  a108=(a054*a068);
  a069=(a069+a108);
  a078=(a078*a010);
  a039=(a039*a040);
  a078=(a078+a039);
  a075=(a075*a036);
  a078=(a078+a075);
  a079=(a079*a020);
  a078=(a078+a079);
  a072=(a072*a049);
  a078=(a078+a072);
  a019=(a019*a071);
  a078=(a078+a019);
  a053=(a053*a081);
  a078=(a078+a053);
  a078=(a035+a078);
  a053=(a061*a078);
  a069=(a069+a053);
  a069=(a031+a069);
  a069=(a007*a069);
  a100=(a100+a069);
  a041=(a041-a100);
  a107=(a101*a107);
  a041=(a041-a107);
  a062=(a062*a104);
  a062=(a028-a062);
  a103=(a103*a101);
  a062=(a062-a103);
  a041=(a041/a062);
  a101=(a101*a041);
  a102=(a102-a101);
  a106=(a106*a102);
  a105=(a105-a106);
  a104=(a104*a041);
  a105=(a105+a104);
  a104=(a030*a105);
  a093=(a093+a104);
  a093=(a003+a093);
  a104=(a096*a093);
  a004=(a004+a104);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a009);
  a104=(a005*a016);
  a004=(a004+a104);
  a104=(a037*a029);
  a004=(a004+a104);
  a104=(a058*a070);
  a004=(a004+a104);
  a104=(a066*a080);
  a004=(a004+a104);
  a104=(a076*a090);
  a004=(a004+a104);
  a104=(a086*a065);
  a004=(a004+a104);
  a104=(a098*a024);
  a048=(a057*a048);
  a104=(a104+a048);
  a047=(a050*a047);
  a104=(a104+a047);
  a047=(a051*a056);
  a104=(a104+a047);
  a047=(a095*a064);
  a104=(a104+a047);
  a047=(a099*a074);
  a104=(a104+a047);
  a047=(a092*a084);
  a104=(a104+a047);
  a047=(a034*a094);
  a104=(a104+a047);
  a047=(a030*a102);
  a104=(a104+a047);
  a104=(a009+a104);
  a047=(a096*a104);
  a004=(a004+a047);
  a004=(a011+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a035);
  a047=(a005*a006);
  a004=(a004+a047);
  a047=(a037*a052);
  a004=(a004+a047);
  a047=(a058*a060);
  a004=(a004+a047);
  a047=(a066*a068);
  a004=(a004+a047);
  a047=(a076*a078);
  a004=(a004+a047);
  a088=(a088*a010);
  a032=(a032*a040);
  a088=(a088+a032);
  a085=(a085*a036);
  a088=(a088+a085);
  a089=(a089*a020);
  a088=(a088+a089);
  a082=(a082*a049);
  a088=(a088+a082);
  a046=(a046*a071);
  a088=(a088+a046);
  a054=(a054*a081);
  a088=(a088+a054);
  a061=(a061*a091);
  a088=(a088+a061);
  a088=(a035+a088);
  a061=(a086*a088);
  a004=(a004+a061);
  a061=(a098*a010);
  a040=(a057*a040);
  a061=(a061+a040);
  a036=(a050*a036);
  a061=(a061+a036);
  a036=(a051*a020);
  a061=(a061+a036);
  a036=(a095*a049);
  a061=(a061+a036);
  a036=(a099*a071);
  a061=(a061+a036);
  a036=(a092*a081);
  a061=(a061+a036);
  a036=(a034*a091);
  a061=(a061+a036);
  a036=(a030*a041);
  a061=(a061+a036);
  a061=(a035+a061);
  a061=(a096*a061);
  a004=(a004+a061);
  a004=(a031+a004);
  if (res[0]!=0) res[0][2]=a004;
  a018=(a001*a018);
  a059=(a005*a059);
  a018=(a018+a059);
  a067=(a037*a067);
  a018=(a018+a067);
  a077=(a058*a077);
  a018=(a018+a077);
  a087=(a066*a087);
  a018=(a018+a087);
  a097=(a076*a097);
  a018=(a018+a097);
  a105=(a086*a105);
  a018=(a018+a105);
  a105=(a098*a003);
  a045=(a057*a045);
  a105=(a105+a045);
  a044=(a050*a044);
  a105=(a105+a044);
  a017=(a051*a017);
  a105=(a105+a017);
  a042=(a095*a042);
  a105=(a105+a042);
  a055=(a099*a055);
  a105=(a105+a055);
  a063=(a092*a063);
  a105=(a105+a063);
  a073=(a034*a073);
  a105=(a105+a073);
  a083=(a030*a083);
  a105=(a105+a083);
  a000=(a000+a105);
  a105=sin(a000);
  a083=(a008*a104);
  a073=(a098*a009);
  a043=(a057*a043);
  a073=(a073+a043);
  a033=(a050*a033);
  a073=(a073+a033);
  a016=(a051*a016);
  a073=(a073+a016);
  a029=(a095*a029);
  a073=(a073+a029);
  a070=(a099*a070);
  a073=(a073+a070);
  a080=(a092*a080);
  a073=(a073+a080);
  a090=(a034*a090);
  a073=(a073+a090);
  a065=(a030*a065);
  a073=(a073+a065);
  a011=(a011+a073);
  a073=sin(a011);
  a083=(a083*a073);
  a065=(2.*a093);
  a065=(a065-a104);
  a083=(a083*a065);
  a083=(a105-a083);
  a065=(a000-a011);
  a065=sin(a065);
  a090=(a065-a105);
  a090=(a008*a090);
  a083=(a083-a090);
  a090=cos(a011);
  a090=(a090-a014);
  a015=(a015*a090);
  a015=(a014-a015);
  a080=(a083/a015);
  a090=(a008*a090);
  a070=(a090/a015);
  a029=casadi_sq(a093);
  a029=(a029*a073);
  a029=(a029+a065);
  a029=(a008*a029);
  a023=(a023+a002);
  a021=(a021*a023);
  a023=sin(a021);
  a022=(a022*a023);
  a104=(a104+a022);
  a013=(a013*a104);
  a021=cos(a021);
  a021=(a021+a014);
  a012=(a012*a021);
  a027=(a027-a012);
  a027=(a027+a011);
  a026=(a026*a027);
  a013=(a013+a026);
  a029=(a029-a013);
  a013=(a070*a083);
  a029=(a029-a013);
  a013=(a090*a070);
  a008=(a008-a013);
  a013=(a029/a008);
  a000=cos(a000);
  a000=(a028*a000);
  a015=(a000/a015);
  a090=(a090*a015);
  a008=(a090/a008);
  a083=(a015*a083);
  a026=(a028*a093);
  a026=(a026*a093);
  a026=(a026*a105);
  a098=(a098*a035);
  a057=(a057*a025);
  a098=(a098+a057);
  a050=(a050*a038);
  a098=(a098+a050);
  a051=(a051*a006);
  a098=(a098+a051);
  a095=(a095*a052);
  a098=(a098+a095);
  a099=(a099*a060);
  a098=(a098+a099);
  a092=(a092*a068);
  a098=(a098+a092);
  a034=(a034*a078);
  a098=(a098+a034);
  a030=(a030*a088);
  a098=(a098+a030);
  a031=(a031+a098);
  a007=(a007*a031);
  a026=(a026+a007);
  a083=(a083-a026);
  a029=(a008*a029);
  a083=(a083-a029);
  a000=(a000*a015);
  a028=(a028-a000);
  a090=(a090*a008);
  a028=(a028-a090);
  a083=(a083/a028);
  a008=(a008*a083);
  a013=(a013-a008);
  a070=(a070*a013);
  a080=(a080-a070);
  a015=(a015*a083);
  a080=(a080+a015);
  a080=(a096*a080);
  a018=(a018+a080);
  a003=(a003+a018);
  if (res[0]!=0) res[0][3]=a003;
  a024=(a001*a024);
  a056=(a005*a056);
  a024=(a024+a056);
  a064=(a037*a064);
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
  a009=(a009+a024);
  if (res[0]!=0) res[0][4]=a009;
  a001=(a001*a010);
  a005=(a005*a020);
  a001=(a001+a005);
  a037=(a037*a049);
  a001=(a001+a037);
  a058=(a058*a071);
  a001=(a001+a058);
  a066=(a066*a081);
  a001=(a001+a066);
  a076=(a076*a091);
  a001=(a001+a076);
  a086=(a086*a041);
  a001=(a001+a086);
  a096=(a096*a083);
  a001=(a001+a096);
  a035=(a035+a001);
  if (res[0]!=0) res[0][5]=a035;
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
  a04=1.;
  a05=arg[2]? arg[2][3] : 0;
  a06=(2.*a05);
  a07=cos(a01);
  a08=(a07-a04);
  a06=(a06*a08);
  a06=(a04-a06);
  a09=(a02/a06);
  a10=arg[0]? arg[0][5] : 0;
  a11=cos(a00);
  a12=arg[0]? arg[0][3] : 0;
  a11=(a11*a12);
  a11=(a10-a11);
  a11=(a03*a11);
  a10=(a02*a10);
  a07=(a07*a12);
  a10=(a10-a07);
  a07=(a09*a10);
  a11=(a11-a07);
  a08=(a05*a08);
  a08=(a08-a04);
  a07=(a08*a09);
  a07=(a02+a07);
  a05=(a05+a04);
  a04=(a08/a06);
  a08=(a08*a04);
  a05=(a05-a08);
  a08=(a07/a05);
  a12=(a04*a10);
  a12=(a10+a12);
  a13=(a08*a12);
  a11=(a11-a13);
  a02=(a02*a09);
  a03=(a03-a02);
  a07=(a07*a08);
  a03=(a03-a07);
  a11=(a11/a03);
  a09=(a09*a11);
  a10=(a10/a06);
  a12=(a12/a05);
  a08=(a08*a11);
  a12=(a12-a08);
  a04=(a04*a12);
  a10=(a10+a04);
  a09=(a09-a10);
  a09=(a09-a12);
  a10=arg[1]? arg[1][1] : 0;
  a09=(a09-a10);
  if (res[0]!=0) res[0][1]=a09;
  a09=arg[1]? arg[1][2] : 0;
  a12=(a12+a09);
  a12=(-a12);
  if (res[0]!=0) res[0][2]=a12;
  a12=arg[0]? arg[0][2] : 0;
  a09=arg[1]? arg[1][3] : 0;
  a12=(a12-a09);
  if (res[0]!=0) res[0][3]=a12;
  a12=arg[1]? arg[1][4] : 0;
  a11=(a11-a12);
  if (res[0]!=0) res[0][4]=a11;
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

/* search_12:(u0[6],p[8])->(u[6],R[6]) */
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

CASADI_SYMBOL_EXPORT int search_12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int search_12_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void search_12_release(int mem) {
}

CASADI_SYMBOL_EXPORT void search_12_incref(void) {
}

CASADI_SYMBOL_EXPORT void search_12_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int search_12_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int search_12_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real search_12_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* search_12_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* search_12_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* search_12_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* search_12_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int search_12_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 659;
  return 0;
}

CASADI_SYMBOL_EXPORT int search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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
  for (iter=0; iter<14; ++iter) {
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

/* search_24:(u0[6],p[8])->(u[6],R[6]) */
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

CASADI_SYMBOL_EXPORT int search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int search_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void search_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void search_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void search_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int search_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int search_24_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real search_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* search_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* search_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* search_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* search_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int search_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 659;
  return 0;
}

CASADI_SYMBOL_EXPORT int search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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
  for (iter=0; iter<14; ++iter) {
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

/* search_48:(u0[6],p[8])->(u[6],R[6]) */
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

CASADI_SYMBOL_EXPORT int search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int search_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void search_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void search_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void search_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int search_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int search_48_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real search_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* search_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* search_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* search_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* search_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int search_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 659;
  return 0;
}

CASADI_SYMBOL_EXPORT int search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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

/* limit_cycle_24:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
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

CASADI_SYMBOL_EXPORT int limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int limit_cycle_24_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void limit_cycle_24_release(int mem) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_24_incref(void) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_24_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_24_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_24_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real limit_cycle_24_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_24_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_24_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_24_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_24_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int limit_cycle_24_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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

/* limit_cycle_48:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
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

CASADI_SYMBOL_EXPORT int limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f23(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int limit_cycle_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void limit_cycle_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_48_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real limit_cycle_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int limit_cycle_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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

/* limit_cycle_96:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
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

CASADI_SYMBOL_EXPORT int limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int limit_cycle_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void limit_cycle_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_96_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real limit_cycle_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int limit_cycle_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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

/* limit_cycle_192:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
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

CASADI_SYMBOL_EXPORT int limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f31(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int limit_cycle_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void limit_cycle_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_192_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real limit_cycle_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int limit_cycle_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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

/* limit_cycle_384:(u0[6],p[8])->(u[6],J[6x6],R[6]) */
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

CASADI_SYMBOL_EXPORT int limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f35(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int limit_cycle_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void limit_cycle_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void limit_cycle_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int limit_cycle_384_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real limit_cycle_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u0";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* limit_cycle_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "J";
    case 2: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* limit_cycle_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s6;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int limit_cycle_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 695;
  return 0;
}

CASADI_SYMBOL_EXPORT int limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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
  a007=sin(a000);
  a008=arg[3]? arg[3][3] : 0;
  a009=arg[1]? arg[1][4] : 0;
  a010=(a008*a009);
  a011=arg[1]? arg[1][1] : 0;
  a012=sin(a011);
  a010=(a010*a012);
  a013=(2.*a003);
  a013=(a013-a009);
  a010=(a010*a013);
  a010=(a007-a010);
  a013=(a000-a011);
  a013=sin(a013);
  a014=(a013-a007);
  a014=(a008*a014);
  a010=(a010-a014);
  a014=1.;
  a015=(2.*a008);
  a016=cos(a011);
  a016=(a016-a014);
  a017=(a015*a016);
  a017=(a014-a017);
  a018=(a010/a017);
  a016=(a008*a016);
  a019=(a016/a017);
  a020=casadi_sq(a003);
  a020=(a020*a012);
  a020=(a020+a013);
  a020=(a008*a020);
  a013=arg[3]? arg[3][5] : 0;
  a012=arg[3]? arg[3][7] : 0;
  a021=arg[3]? arg[3][2] : 0;
  a022=(a012*a021);
  a023=arg[0]? arg[0][0] : 0;
  a024=(a021*a023);
  a025=sin(a024);
  a025=(a022*a025);
  a025=(a009+a025);
  a025=(a013*a025);
  a026=arg[3]? arg[3][4] : 0;
  a027=arg[3]? arg[3][6] : 0;
  a024=cos(a024);
  a024=(a024+a014);
  a024=(a012*a024);
  a024=(a027-a024);
  a024=(a024+a011);
  a024=(a026*a024);
  a025=(a025+a024);
  a020=(a020-a025);
  a024=(a019*a010);
  a020=(a020-a024);
  a024=(a016*a019);
  a024=(a008-a024);
  a028=(a020/a024);
  a029=arg[3]? arg[3][1] : 0;
  a030=cos(a000);
  a030=(a029*a030);
  a017=(a030/a017);
  a016=(a016*a017);
  a024=(a016/a024);
  a010=(a017*a010);
  a031=(a029*a003);
  a031=(a031*a003);
  a031=(a031*a007);
  a007=arg[3]? arg[3][0] : 0;
  a032=arg[1]? arg[1][2] : 0;
  a033=(a007*a032);
  a031=(a031+a033);
  a010=(a010-a031);
  a020=(a024*a020);
  a010=(a010-a020);
  a030=(a030*a017);
  a030=(a029-a030);
  a016=(a016*a024);
  a030=(a030-a016);
  a010=(a010/a030);
  a024=(a024*a010);
  a028=(a028-a024);
  a019=(a019*a028);
  a018=(a018-a019);
  a017=(a017*a010);
  a018=(a018+a017);
  a017=(a006*a018);
  a019=1.7082860872947386e-01;
  a019=(a019*a002);
  a024=2.9587585476806851e-02;
  a024=(a024*a002);
  a030=(a024*a003);
  a016=8.8762756430420545e-02;
  a016=(a016*a002);
  a020=1.9725056984537900e-02;
  a020=(a020*a002);
  a031=(a020*a018);
  a033=5.9175170953613701e-02;
  a033=(a033*a002);
  a034=5.2600151958767730e-02;
  a034=(a034*a002);
  a035=(a034*a003);
  a035=(a000+a035);
  a036=sin(a035);
  a037=(a034*a028);
  a037=(a009+a037);
  a038=(a008*a037);
  a039=(a034*a009);
  a039=(a011+a039);
  a040=sin(a039);
  a038=(a038*a040);
  a041=(a034*a018);
  a041=(a003+a041);
  a042=(2.*a041);
  a042=(a042-a037);
  a038=(a038*a042);
  a038=(a036-a038);
  a042=(a035-a039);
  a042=sin(a042);
  a043=(a042-a036);
  a043=(a008*a043);
  a038=(a038-a043);
  a043=cos(a039);
  a043=(a043-a014);
  a044=(a015*a043);
  a044=(a014-a044);
  a045=(a038/a044);
  a043=(a008*a043);
  a046=(a043/a044);
  a047=casadi_sq(a041);
  a047=(a047*a040);
  a047=(a047+a042);
  a047=(a008*a047);
  a042=(a023+a034);
  a042=(a021*a042);
  a040=sin(a042);
  a040=(a022*a040);
  a040=(a037+a040);
  a040=(a013*a040);
  a042=cos(a042);
  a042=(a042+a014);
  a042=(a012*a042);
  a042=(a027-a042);
  a042=(a042+a039);
  a042=(a026*a042);
  a040=(a040+a042);
  a047=(a047-a040);
  a040=(a046*a038);
  a047=(a047-a040);
  a040=(a043*a046);
  a040=(a008-a040);
  a042=(a047/a040);
  a035=cos(a035);
  a035=(a029*a035);
  a044=(a035/a044);
  a043=(a043*a044);
  a040=(a043/a040);
  a038=(a044*a038);
  a039=(a029*a041);
  a039=(a039*a041);
  a039=(a039*a036);
  a036=arg[1]? arg[1][5] : 0;
  a048=(a034*a036);
  a048=(a032+a048);
  a048=(a007*a048);
  a039=(a039+a048);
  a038=(a038-a039);
  a047=(a040*a047);
  a038=(a038-a047);
  a035=(a035*a044);
  a035=(a029-a035);
  a043=(a043*a040);
  a035=(a035-a043);
  a038=(a038/a035);
  a040=(a040*a038);
  a042=(a042-a040);
  a046=(a046*a042);
  a045=(a045-a046);
  a044=(a044*a038);
  a045=(a045+a044);
  a045=(a033*a045);
  a031=(a031+a045);
  a031=(a003+a031);
  a045=(a016*a031);
  a030=(a030+a045);
  a030=(a000+a030);
  a045=sin(a030);
  a044=(a024*a028);
  a046=casadi_sq(a031);
  a040=(a020*a009);
  a037=(a033*a037);
  a040=(a040+a037);
  a040=(a011+a040);
  a037=sin(a040);
  a046=(a046*a037);
  a035=(a020*a003);
  a041=(a033*a041);
  a035=(a035+a041);
  a035=(a000+a035);
  a041=(a035-a040);
  a041=sin(a041);
  a046=(a046+a041);
  a046=(a008*a046);
  a043=(a020*a028);
  a042=(a033*a042);
  a043=(a043+a042);
  a043=(a009+a043);
  a042=7.8900227938151601e-02;
  a042=(a042*a002);
  a042=(a023+a042);
  a042=(a021*a042);
  a047=sin(a042);
  a047=(a022*a047);
  a047=(a043+a047);
  a047=(a013*a047);
  a042=cos(a042);
  a042=(a042+a014);
  a042=(a012*a042);
  a042=(a027-a042);
  a042=(a042+a040);
  a042=(a026*a042);
  a047=(a047+a042);
  a046=(a046-a047);
  a040=cos(a040);
  a040=(a040-a014);
  a047=(a008*a040);
  a040=(a015*a040);
  a040=(a014-a040);
  a042=(a047/a040);
  a039=sin(a035);
  a048=(a008*a043);
  a048=(a048*a037);
  a037=(2.*a031);
  a037=(a037-a043);
  a048=(a048*a037);
  a048=(a039-a048);
  a041=(a041-a039);
  a041=(a008*a041);
  a048=(a048-a041);
  a041=(a042*a048);
  a046=(a046-a041);
  a041=(a047*a042);
  a041=(a008-a041);
  a037=(a046/a041);
  a035=cos(a035);
  a035=(a029*a035);
  a049=(a035/a040);
  a047=(a047*a049);
  a041=(a047/a041);
  a050=(a049*a048);
  a051=(a029*a031);
  a051=(a051*a031);
  a051=(a051*a039);
  a039=(a020*a036);
  a034=(a034*a010);
  a034=(a036+a034);
  a034=(a033*a034);
  a039=(a039+a034);
  a039=(a032+a039);
  a039=(a007*a039);
  a051=(a051+a039);
  a050=(a050-a051);
  a046=(a041*a046);
  a050=(a050-a046);
  a035=(a035*a049);
  a035=(a029-a035);
  a047=(a047*a041);
  a035=(a035-a047);
  a050=(a050/a035);
  a041=(a041*a050);
  a037=(a037-a041);
  a041=(a016*a037);
  a044=(a044+a041);
  a044=(a009+a044);
  a041=(a008*a044);
  a035=(a024*a009);
  a047=(a016*a043);
  a035=(a035+a047);
  a035=(a011+a035);
  a047=sin(a035);
  a041=(a041*a047);
  a046=(a024*a018);
  a048=(a048/a040);
  a042=(a042*a037);
  a048=(a048-a042);
  a049=(a049*a050);
  a048=(a048+a049);
  a049=(a016*a048);
  a046=(a046+a049);
  a046=(a003+a046);
  a049=(2.*a046);
  a049=(a049-a044);
  a041=(a041*a049);
  a041=(a045-a041);
  a049=(a030-a035);
  a049=sin(a049);
  a042=(a049-a045);
  a042=(a008*a042);
  a041=(a041-a042);
  a042=cos(a035);
  a042=(a042-a014);
  a040=(a015*a042);
  a040=(a014-a040);
  a051=(a041/a040);
  a042=(a008*a042);
  a039=(a042/a040);
  a034=casadi_sq(a046);
  a034=(a034*a047);
  a034=(a034+a049);
  a034=(a008*a034);
  a049=1.1835034190722740e-01;
  a049=(a049*a002);
  a049=(a023+a049);
  a049=(a021*a049);
  a047=sin(a049);
  a047=(a022*a047);
  a047=(a044+a047);
  a047=(a013*a047);
  a049=cos(a049);
  a049=(a049+a014);
  a049=(a012*a049);
  a049=(a027-a049);
  a049=(a049+a035);
  a049=(a026*a049);
  a047=(a047+a049);
  a034=(a034-a047);
  a047=(a039*a041);
  a034=(a034-a047);
  a047=(a042*a039);
  a047=(a008-a047);
  a049=(a034/a047);
  a030=cos(a030);
  a030=(a029*a030);
  a040=(a030/a040);
  a042=(a042*a040);
  a047=(a042/a047);
  a041=(a040*a041);
  a035=(a029*a046);
  a035=(a035*a046);
  a035=(a035*a045);
  a045=(a024*a036);
  a020=(a020*a010);
  a033=(a033*a038);
  a020=(a020+a033);
  a020=(a036+a020);
  a033=(a016*a020);
  a045=(a045+a033);
  a045=(a032+a045);
  a045=(a007*a045);
  a035=(a035+a045);
  a041=(a041-a035);
  a034=(a047*a034);
  a041=(a041-a034);
  a030=(a030*a040);
  a030=(a029-a030);
  a042=(a042*a047);
  a030=(a030-a042);
  a041=(a041/a030);
  a047=(a047*a041);
  a049=(a049-a047);
  a039=(a039*a049);
  a051=(a051-a039);
  a040=(a040*a041);
  a051=(a051+a040);
  a040=(a019*a051);
  a017=(a017+a040);
  a040=1.2546768756682242e-01;
  a040=(a040*a002);
  a039=2.4136513415926669e-01;
  a039=(a039*a002);
  a047=(a039*a003);
  a030=-8.8454947932828609e-01;
  a030=(a030*a002);
  a031=(a030*a031);
  a047=(a047+a031);
  a031=9.2483400326179199e-01;
  a031=(a031*a002);
  a042=(a031*a046);
  a047=(a047+a042);
  a047=(a000+a047);
  a042=sin(a047);
  a034=(a039*a028);
  a037=(a030*a037);
  a034=(a034+a037);
  a037=(a031*a049);
  a034=(a034+a037);
  a034=(a009+a034);
  a037=(a008*a034);
  a035=(a039*a009);
  a043=(a030*a043);
  a035=(a035+a043);
  a043=(a031*a044);
  a035=(a035+a043);
  a035=(a011+a035);
  a043=sin(a035);
  a037=(a037*a043);
  a045=(a039*a018);
  a048=(a030*a048);
  a045=(a045+a048);
  a048=(a031*a051);
  a045=(a045+a048);
  a045=(a003+a045);
  a048=(2.*a045);
  a048=(a048-a034);
  a037=(a037*a048);
  a037=(a042-a037);
  a048=(a047-a035);
  a048=sin(a048);
  a033=(a048-a042);
  a033=(a008*a033);
  a037=(a037-a033);
  a033=cos(a035);
  a033=(a033-a014);
  a038=(a015*a033);
  a038=(a014-a038);
  a052=(a037/a038);
  a033=(a008*a033);
  a053=(a033/a038);
  a054=casadi_sq(a045);
  a054=(a054*a043);
  a054=(a054+a048);
  a054=(a008*a054);
  a048=2.8164965809277259e-01;
  a048=(a048*a002);
  a048=(a023+a048);
  a048=(a021*a048);
  a043=sin(a048);
  a043=(a022*a043);
  a043=(a034+a043);
  a043=(a013*a043);
  a048=cos(a048);
  a048=(a048+a014);
  a048=(a012*a048);
  a048=(a027-a048);
  a048=(a048+a035);
  a048=(a026*a048);
  a043=(a043+a048);
  a054=(a054-a043);
  a043=(a053*a037);
  a054=(a054-a043);
  a043=(a033*a053);
  a043=(a008-a043);
  a048=(a054/a043);
  a047=cos(a047);
  a047=(a029*a047);
  a038=(a047/a038);
  a033=(a033*a038);
  a043=(a033/a043);
  a037=(a038*a037);
  a035=(a029*a045);
  a035=(a035*a045);
  a035=(a035*a042);
  a042=(a039*a036);
  a020=(a030*a020);
  a042=(a042+a020);
  a024=(a024*a010);
  a016=(a016*a050);
  a024=(a024+a016);
  a024=(a036+a024);
  a016=(a031*a024);
  a042=(a042+a016);
  a042=(a032+a042);
  a042=(a007*a042);
  a035=(a035+a042);
  a037=(a037-a035);
  a054=(a043*a054);
  a037=(a037-a054);
  a047=(a047*a038);
  a047=(a029-a047);
  a033=(a033*a043);
  a047=(a047-a033);
  a037=(a037/a047);
  a043=(a043*a037);
  a048=(a048-a043);
  a053=(a053*a048);
  a052=(a052-a053);
  a038=(a038*a037);
  a052=(a052+a038);
  a038=(a040*a052);
  a017=(a017+a038);
  a017=(a003+a017);
  a038=(a005*a017);
  a004=(a004+a038);
  a038=1.8915178993145003e+00;
  a038=(a038*a002);
  a053=3.7109375000000000e-02;
  a053=(a053*a002);
  a043=(a053*a018);
  a047=1.7025221101954405e-01;
  a047=(a047*a002);
  a033=(a047*a051);
  a043=(a043+a033);
  a033=6.0216538980455959e-02;
  a033=(a033*a002);
  a054=(a033*a052);
  a043=(a043+a054);
  a054=-1.7578125000000000e-02;
  a054=(a054*a002);
  a035=(a006*a003);
  a042=(a019*a046);
  a035=(a035+a042);
  a042=(a040*a045);
  a035=(a035+a042);
  a035=(a000+a035);
  a042=sin(a035);
  a016=(a006*a028);
  a020=(a019*a049);
  a016=(a016+a020);
  a020=(a040*a048);
  a016=(a016+a020);
  a016=(a009+a016);
  a020=(a008*a016);
  a055=(a006*a009);
  a056=(a019*a044);
  a055=(a055+a056);
  a056=(a040*a034);
  a055=(a055+a056);
  a055=(a011+a055);
  a056=sin(a055);
  a020=(a020*a056);
  a057=(2.*a017);
  a057=(a057-a016);
  a020=(a020*a057);
  a020=(a042-a020);
  a057=(a035-a055);
  a057=sin(a057);
  a058=(a057-a042);
  a058=(a008*a058);
  a020=(a020-a058);
  a058=cos(a055);
  a058=(a058-a014);
  a059=(a015*a058);
  a059=(a014-a059);
  a060=(a020/a059);
  a058=(a008*a058);
  a061=(a058/a059);
  a062=casadi_sq(a017);
  a062=(a062*a056);
  a062=(a062+a057);
  a062=(a008*a062);
  a057=3.3333333333333331e-01;
  a057=(a057*a002);
  a057=(a023+a057);
  a057=(a021*a057);
  a056=sin(a057);
  a056=(a022*a056);
  a056=(a016+a056);
  a056=(a013*a056);
  a057=cos(a057);
  a057=(a057+a014);
  a057=(a012*a057);
  a057=(a027-a057);
  a057=(a057+a055);
  a057=(a026*a057);
  a056=(a056+a057);
  a062=(a062-a056);
  a057=(a061*a020);
  a062=(a062-a057);
  a057=(a058*a061);
  a057=(a008-a057);
  a055=(a062/a057);
  a035=cos(a035);
  a035=(a029*a035);
  a059=(a035/a059);
  a058=(a058*a059);
  a057=(a058/a057);
  a020=(a059*a020);
  a063=(a029*a017);
  a063=(a063*a017);
  a063=(a063*a042);
  a042=(a006*a036);
  a064=(a019*a024);
  a042=(a042+a064);
  a039=(a039*a010);
  a030=(a030*a050);
  a039=(a039+a030);
  a031=(a031*a041);
  a039=(a039+a031);
  a039=(a036+a039);
  a031=(a040*a039);
  a042=(a042+a031);
  a042=(a032+a042);
  a042=(a007*a042);
  a063=(a063+a042);
  a020=(a020-a063);
  a062=(a057*a062);
  a020=(a020-a062);
  a035=(a035*a059);
  a035=(a029-a035);
  a058=(a058*a057);
  a035=(a035-a058);
  a020=(a020/a035);
  a057=(a057*a020);
  a055=(a055-a057);
  a061=(a061*a055);
  a060=(a060-a061);
  a059=(a059*a020);
  a060=(a060+a059);
  a059=(a054*a060);
  a043=(a043+a059);
  a043=(a003+a043);
  a059=(a038*a043);
  a004=(a004+a059);
  a059=-5.8012039600105849e+00;
  a059=(a059*a002);
  a061=3.7092000118504789e-02;
  a061=(a061*a002);
  a057=(a061*a018);
  a035=1.7038392571223998e-01;
  a035=(a035*a002);
  a058=(a035*a051);
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
  a042=(a053*a003);
  a031=(a047*a046);
  a042=(a042+a031);
  a031=(a033*a045);
  a042=(a042+a031);
  a031=(a054*a017);
  a042=(a042+a031);
  a042=(a000+a042);
  a031=sin(a042);
  a030=(a053*a028);
  a050=(a047*a049);
  a030=(a030+a050);
  a050=(a033*a048);
  a030=(a030+a050);
  a050=(a054*a055);
  a030=(a030+a050);
  a030=(a009+a030);
  a050=(a008*a030);
  a064=(a053*a009);
  a065=(a047*a044);
  a064=(a064+a065);
  a065=(a033*a034);
  a064=(a064+a065);
  a065=(a054*a016);
  a064=(a064+a065);
  a064=(a011+a064);
  a065=sin(a064);
  a050=(a050*a065);
  a066=(2.*a043);
  a066=(a066-a030);
  a050=(a050*a066);
  a050=(a031-a050);
  a066=(a042-a064);
  a066=sin(a066);
  a067=(a066-a031);
  a067=(a008*a067);
  a050=(a050-a067);
  a067=cos(a064);
  a067=(a067-a014);
  a068=(a015*a067);
  a068=(a014-a068);
  a069=(a050/a068);
  a067=(a008*a067);
  a070=(a067/a068);
  a071=casadi_sq(a043);
  a071=(a071*a065);
  a071=(a071+a066);
  a071=(a008*a071);
  a066=2.5000000000000000e-01;
  a066=(a066*a002);
  a066=(a023+a066);
  a066=(a021*a066);
  a065=sin(a066);
  a065=(a022*a065);
  a065=(a030+a065);
  a065=(a013*a065);
  a066=cos(a066);
  a066=(a066+a014);
  a066=(a012*a066);
  a066=(a027-a066);
  a066=(a066+a064);
  a066=(a026*a066);
  a065=(a065+a066);
  a071=(a071-a065);
  a066=(a070*a050);
  a071=(a071-a066);
  a066=(a067*a070);
  a066=(a008-a066);
  a064=(a071/a066);
  a042=cos(a042);
  a042=(a029*a042);
  a068=(a042/a068);
  a067=(a067*a068);
  a066=(a067/a066);
  a050=(a068*a050);
  a072=(a029*a043);
  a072=(a072*a043);
  a072=(a072*a031);
  a031=(a053*a036);
  a073=(a047*a024);
  a031=(a031+a073);
  a073=(a033*a039);
  a031=(a031+a073);
  a006=(a006*a010);
  a019=(a019*a041);
  a006=(a006+a019);
  a040=(a040*a037);
  a006=(a006+a040);
  a006=(a036+a006);
  a040=(a054*a006);
  a031=(a031+a040);
  a031=(a032+a031);
  a031=(a007*a031);
  a072=(a072+a031);
  a050=(a050-a072);
  a071=(a066*a071);
  a050=(a050-a071);
  a042=(a042*a068);
  a042=(a029-a042);
  a067=(a067*a066);
  a042=(a042-a067);
  a050=(a050/a042);
  a066=(a066*a050);
  a064=(a064-a066);
  a070=(a070*a064);
  a069=(a069-a070);
  a068=(a068*a050);
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
  a042=-3.3608926294469414e+00;
  a042=(a042*a002);
  a067=(a042*a051);
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
  a031=(a072*a069);
  a066=(a066+a031);
  a031=-4.3489884181069961e+01;
  a031=(a031*a002);
  a040=(a061*a003);
  a019=(a035*a046);
  a040=(a040+a019);
  a019=(a058*a045);
  a040=(a040+a019);
  a019=(a062*a017);
  a040=(a040+a019);
  a019=(a063*a043);
  a040=(a040+a019);
  a040=(a000+a040);
  a019=sin(a040);
  a073=(a061*a028);
  a074=(a035*a049);
  a073=(a073+a074);
  a074=(a058*a048);
  a073=(a073+a074);
  a074=(a062*a055);
  a073=(a073+a074);
  a074=(a063*a064);
  a073=(a073+a074);
  a073=(a009+a073);
  a074=(a008*a073);
  a075=(a061*a009);
  a076=(a035*a044);
  a075=(a075+a076);
  a076=(a058*a034);
  a075=(a075+a076);
  a076=(a062*a016);
  a075=(a075+a076);
  a076=(a063*a030);
  a075=(a075+a076);
  a075=(a011+a075);
  a076=sin(a075);
  a074=(a074*a076);
  a077=(2.*a057);
  a077=(a077-a073);
  a074=(a074*a077);
  a074=(a019-a074);
  a077=(a040-a075);
  a077=sin(a077);
  a078=(a077-a019);
  a078=(a008*a078);
  a074=(a074-a078);
  a078=cos(a075);
  a078=(a078-a014);
  a079=(a015*a078);
  a079=(a014-a079);
  a080=(a074/a079);
  a078=(a008*a078);
  a081=(a078/a079);
  a082=casadi_sq(a057);
  a082=(a082*a076);
  a082=(a082+a077);
  a082=(a008*a082);
  a077=3.0769230769230771e-01;
  a077=(a077*a002);
  a077=(a023+a077);
  a077=(a021*a077);
  a076=sin(a077);
  a076=(a022*a076);
  a076=(a073+a076);
  a076=(a013*a076);
  a077=cos(a077);
  a077=(a077+a014);
  a077=(a012*a077);
  a077=(a027-a077);
  a077=(a077+a075);
  a077=(a026*a077);
  a076=(a076+a077);
  a082=(a082-a076);
  a077=(a081*a074);
  a082=(a082-a077);
  a077=(a078*a081);
  a077=(a008-a077);
  a075=(a082/a077);
  a040=cos(a040);
  a040=(a029*a040);
  a079=(a040/a079);
  a078=(a078*a079);
  a077=(a078/a077);
  a074=(a079*a074);
  a083=(a029*a057);
  a083=(a083*a057);
  a083=(a083*a019);
  a019=(a061*a036);
  a084=(a035*a024);
  a019=(a019+a084);
  a084=(a058*a039);
  a019=(a019+a084);
  a084=(a062*a006);
  a019=(a019+a084);
  a053=(a053*a010);
  a047=(a047*a041);
  a053=(a053+a047);
  a033=(a033*a037);
  a053=(a053+a033);
  a054=(a054*a020);
  a053=(a053+a054);
  a053=(a036+a053);
  a054=(a063*a053);
  a019=(a019+a054);
  a019=(a032+a019);
  a019=(a007*a019);
  a083=(a083+a019);
  a074=(a074-a083);
  a082=(a077*a082);
  a074=(a074-a082);
  a040=(a040*a079);
  a040=(a029-a040);
  a078=(a078*a077);
  a040=(a040-a078);
  a074=(a074/a040);
  a077=(a077*a074);
  a075=(a075-a077);
  a081=(a081*a075);
  a080=(a080-a081);
  a079=(a079*a074);
  a080=(a080+a079);
  a079=(a031*a080);
  a066=(a066+a079);
  a066=(a003+a066);
  a079=(a068*a066);
  a004=(a004+a079);
  a079=-1.5216094966251609e-01;
  a079=(a079*a002);
  a081=4.7766253643826434e-01;
  a081=(a081*a002);
  a077=(a081*a018);
  a040=-2.4881146199716677e+00;
  a040=(a040*a002);
  a078=(a040*a051);
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
  a019=(a083*a069);
  a077=(a077+a019);
  a019=-3.3288210968984863e+01;
  a019=(a019*a002);
  a054=(a019*a080);
  a077=(a077+a054);
  a054=-2.0331201708508627e-02;
  a054=(a054*a002);
  a033=(a070*a003);
  a047=(a042*a046);
  a033=(a033+a047);
  a047=(a067*a045);
  a033=(a033+a047);
  a047=(a071*a017);
  a033=(a033+a047);
  a047=(a072*a043);
  a033=(a033+a047);
  a047=(a031*a057);
  a033=(a033+a047);
  a033=(a000+a033);
  a047=sin(a033);
  a084=(a070*a028);
  a085=(a042*a049);
  a084=(a084+a085);
  a085=(a067*a048);
  a084=(a084+a085);
  a085=(a071*a055);
  a084=(a084+a085);
  a085=(a072*a064);
  a084=(a084+a085);
  a085=(a031*a075);
  a084=(a084+a085);
  a084=(a009+a084);
  a085=(a008*a084);
  a086=(a070*a009);
  a087=(a042*a044);
  a086=(a086+a087);
  a087=(a067*a034);
  a086=(a086+a087);
  a087=(a071*a016);
  a086=(a086+a087);
  a087=(a072*a030);
  a086=(a086+a087);
  a087=(a031*a073);
  a086=(a086+a087);
  a086=(a011+a086);
  a087=sin(a086);
  a085=(a085*a087);
  a088=(2.*a066);
  a088=(a088-a084);
  a085=(a085*a088);
  a085=(a047-a085);
  a088=(a033-a086);
  a088=sin(a088);
  a089=(a088-a047);
  a089=(a008*a089);
  a085=(a085-a089);
  a089=cos(a086);
  a089=(a089-a014);
  a090=(a015*a089);
  a090=(a014-a090);
  a091=(a085/a090);
  a089=(a008*a089);
  a092=(a089/a090);
  a093=casadi_sq(a066);
  a093=(a093*a087);
  a093=(a093+a088);
  a093=(a008*a093);
  a088=6.5128205128205130e-01;
  a088=(a088*a002);
  a088=(a023+a088);
  a088=(a021*a088);
  a087=sin(a088);
  a087=(a022*a087);
  a087=(a084+a087);
  a087=(a013*a087);
  a088=cos(a088);
  a088=(a088+a014);
  a088=(a012*a088);
  a088=(a027-a088);
  a088=(a088+a086);
  a088=(a026*a088);
  a087=(a087+a088);
  a093=(a093-a087);
  a088=(a092*a085);
  a093=(a093-a088);
  a088=(a089*a092);
  a088=(a008-a088);
  a086=(a093/a088);
  a033=cos(a033);
  a033=(a029*a033);
  a090=(a033/a090);
  a089=(a089*a090);
  a088=(a089/a088);
  a085=(a090*a085);
  a094=(a029*a066);
  a094=(a094*a066);
  a094=(a094*a047);
  a047=(a070*a036);
  a095=(a042*a024);
  a047=(a047+a095);
  a095=(a067*a039);
  a047=(a047+a095);
  a095=(a071*a006);
  a047=(a047+a095);
  a095=(a072*a053);
  a047=(a047+a095);
  a061=(a061*a010);
  a035=(a035*a041);
  a061=(a061+a035);
  a058=(a058*a037);
  a061=(a061+a058);
  a062=(a062*a020);
  a061=(a061+a062);
  a063=(a063*a050);
  a061=(a061+a063);
  a061=(a036+a061);
  a063=(a031*a061);
  a047=(a047+a063);
  a047=(a032+a047);
  a047=(a007*a047);
  a094=(a094+a047);
  a085=(a085-a094);
  a093=(a088*a093);
  a085=(a085-a093);
  a033=(a033*a090);
  a033=(a029-a033);
  a089=(a089*a088);
  a033=(a033-a089);
  a085=(a085/a033);
  a088=(a088*a085);
  a086=(a086-a088);
  a092=(a092*a086);
  a091=(a091-a092);
  a090=(a090*a085);
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
  a033=5.1863724288440638e+00;
  a033=(a033*a002);
  a089=(a033*a051);
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
  a047=(a094*a069);
  a088=(a088+a047);
  a047=2.2739487099350505e+01;
  a047=(a047*a002);
  a063=(a047*a080);
  a088=(a088+a063);
  a063=2.4936055526796523e+00;
  a063=(a063*a002);
  a062=(a063*a091);
  a088=(a088+a062);
  a062=-3.0467644718982196e+00;
  a062=(a062*a002);
  a058=(a081*a003);
  a035=(a040*a046);
  a058=(a058+a035);
  a035=(a078*a045);
  a058=(a058+a035);
  a035=(a082*a017);
  a058=(a058+a035);
  a035=(a083*a043);
  a058=(a058+a035);
  a035=(a019*a057);
  a058=(a058+a035);
  a035=(a054*a066);
  a058=(a058+a035);
  a058=(a000+a058);
  a035=sin(a058);
  a095=(a081*a028);
  a096=(a040*a049);
  a095=(a095+a096);
  a096=(a078*a048);
  a095=(a095+a096);
  a096=(a082*a055);
  a095=(a095+a096);
  a096=(a083*a064);
  a095=(a095+a096);
  a096=(a019*a075);
  a095=(a095+a096);
  a096=(a054*a086);
  a095=(a095+a096);
  a095=(a009+a095);
  a096=(a008*a095);
  a097=(a081*a009);
  a098=(a040*a044);
  a097=(a097+a098);
  a098=(a078*a034);
  a097=(a097+a098);
  a098=(a082*a016);
  a097=(a097+a098);
  a098=(a083*a030);
  a097=(a097+a098);
  a098=(a019*a073);
  a097=(a097+a098);
  a098=(a054*a084);
  a097=(a097+a098);
  a097=(a011+a097);
  a098=sin(a097);
  a096=(a096*a098);
  a099=(2.*a077);
  a099=(a099-a095);
  a096=(a096*a099);
  a096=(a035-a096);
  a099=(a058-a097);
  a099=sin(a099);
  a100=(a099-a035);
  a100=(a008*a100);
  a096=(a096-a100);
  a100=cos(a097);
  a100=(a100-a014);
  a101=(a015*a100);
  a101=(a014-a101);
  a102=(a096/a101);
  a100=(a008*a100);
  a103=(a100/a101);
  a104=casadi_sq(a077);
  a104=(a104*a098);
  a104=(a104+a099);
  a104=(a008*a104);
  a099=5.9999999999999998e-01;
  a099=(a099*a002);
  a099=(a023+a099);
  a099=(a021*a099);
  a098=sin(a099);
  a098=(a022*a098);
  a098=(a095+a098);
  a098=(a013*a098);
  a099=cos(a099);
  a099=(a099+a014);
  a099=(a012*a099);
  a099=(a027-a099);
  a099=(a099+a097);
  a099=(a026*a099);
  a098=(a098+a099);
  a104=(a104-a098);
  a099=(a103*a096);
  a104=(a104-a099);
  a099=(a100*a103);
  a099=(a008-a099);
  a097=(a104/a099);
  a058=cos(a058);
  a058=(a029*a058);
  a101=(a058/a101);
  a100=(a100*a101);
  a099=(a100/a099);
  a096=(a101*a096);
  a105=(a029*a077);
  a105=(a105*a077);
  a105=(a105*a035);
  a035=(a081*a036);
  a106=(a040*a024);
  a035=(a035+a106);
  a106=(a078*a039);
  a035=(a035+a106);
  a106=(a082*a006);
  a035=(a035+a106);
  a106=(a083*a053);
  a035=(a035+a106);
  a106=(a019*a061);
  a035=(a035+a106);
  a070=(a070*a010);
  a042=(a042*a041);
  a070=(a070+a042);
  a067=(a067*a037);
  a070=(a070+a067);
  a071=(a071*a020);
  a070=(a070+a071);
  a072=(a072*a050);
  a070=(a070+a072);
  a031=(a031*a074);
  a070=(a070+a031);
  a070=(a036+a070);
  a031=(a054*a070);
  a035=(a035+a031);
  a035=(a032+a035);
  a035=(a007*a035);
  a105=(a105+a035);
  a096=(a096-a105);
  a104=(a099*a104);
  a096=(a096-a104);
  a058=(a058*a101);
  a058=(a029-a058);
  a100=(a100*a099);
  a058=(a058-a100);
  a096=(a096/a058);
  a099=(a099*a096);
  a097=(a097-a099);
  a103=(a103*a097);
  a102=(a102-a103);
  a101=(a101*a096);
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
  a058=-1.0534495466737249e+01;
  a058=(a058*a002);
  a051=(a058*a051);
  a099=(a099+a051);
  a051=-2.0008720582248625e+00;
  a051=(a051*a002);
  a052=(a051*a052);
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
  a035=(a105*a091);
  a099=(a099+a035);
  a035=1.2360567175794303e+01;
  a035=(a035*a002);
  a031=(a035*a102);
  a099=(a099+a031);
  a031=6.4339274601576357e-01;
  a031=(a031*a002);
  a072=(a092*a003);
  a071=(a033*a046);
  a072=(a072+a071);
  a071=(a089*a045);
  a072=(a072+a071);
  a071=(a093*a017);
  a072=(a072+a071);
  a071=(a094*a043);
  a072=(a072+a071);
  a071=(a047*a057);
  a072=(a072+a071);
  a071=(a063*a066);
  a072=(a072+a071);
  a071=(a062*a077);
  a072=(a072+a071);
  a072=(a000+a072);
  a071=sin(a072);
  a067=(a092*a028);
  a042=(a033*a049);
  a067=(a067+a042);
  a042=(a089*a048);
  a067=(a067+a042);
  a042=(a093*a055);
  a067=(a067+a042);
  a042=(a094*a064);
  a067=(a067+a042);
  a042=(a047*a075);
  a067=(a067+a042);
  a042=(a063*a086);
  a067=(a067+a042);
  a042=(a062*a097);
  a067=(a067+a042);
  a067=(a009+a067);
  a042=(a008*a067);
  a106=(a092*a009);
  a107=(a033*a044);
  a106=(a106+a107);
  a107=(a089*a034);
  a106=(a106+a107);
  a107=(a093*a016);
  a106=(a106+a107);
  a107=(a094*a030);
  a106=(a106+a107);
  a107=(a047*a073);
  a106=(a106+a107);
  a107=(a063*a084);
  a106=(a106+a107);
  a107=(a062*a095);
  a106=(a106+a107);
  a106=(a011+a106);
  a107=sin(a106);
  a042=(a042*a107);
  a108=(2.*a088);
  a108=(a108-a067);
  a042=(a042*a108);
  a042=(a071-a042);
  a108=(a072-a106);
  a108=sin(a108);
  a109=(a108-a071);
  a109=(a008*a109);
  a042=(a042-a109);
  a109=cos(a106);
  a109=(a109-a014);
  a110=(a015*a109);
  a110=(a014-a110);
  a111=(a042/a110);
  a109=(a008*a109);
  a112=(a109/a110);
  a113=casadi_sq(a088);
  a113=(a113*a107);
  a113=(a113+a108);
  a113=(a008*a113);
  a108=8.5714285714285710e-01;
  a108=(a108*a002);
  a108=(a023+a108);
  a108=(a021*a108);
  a107=sin(a108);
  a107=(a022*a107);
  a107=(a067+a107);
  a107=(a013*a107);
  a108=cos(a108);
  a108=(a108+a014);
  a108=(a012*a108);
  a108=(a027-a108);
  a108=(a108+a106);
  a108=(a026*a108);
  a107=(a107+a108);
  a113=(a113-a107);
  a108=(a112*a042);
  a113=(a113-a108);
  a108=(a109*a112);
  a108=(a008-a108);
  a106=(a113/a108);
  a072=cos(a072);
  a072=(a029*a072);
  a110=(a072/a110);
  a109=(a109*a110);
  a108=(a109/a108);
  a042=(a110*a042);
  a114=(a029*a088);
  a114=(a114*a088);
  a114=(a114*a071);
  a071=(a092*a036);
  a115=(a033*a024);
  a071=(a071+a115);
  a115=(a089*a039);
  a071=(a071+a115);
  a115=(a093*a006);
  a071=(a071+a115);
  a115=(a094*a053);
  a071=(a071+a115);
  a115=(a047*a061);
  a071=(a071+a115);
  a115=(a063*a070);
  a071=(a071+a115);
  a081=(a081*a010);
  a040=(a040*a041);
  a081=(a081+a040);
  a078=(a078*a037);
  a081=(a081+a078);
  a082=(a082*a020);
  a081=(a081+a082);
  a083=(a083*a050);
  a081=(a081+a083);
  a019=(a019*a074);
  a081=(a081+a019);
  a054=(a054*a085);
  a081=(a081+a054);
  a081=(a036+a081);
  a054=(a062*a081);
  a071=(a071+a054);
  a071=(a032+a071);
  a071=(a007*a071);
  a114=(a114+a071);
  a042=(a042-a114);
  a113=(a108*a113);
  a042=(a042-a113);
  a072=(a072*a110);
  a072=(a029-a072);
  a109=(a109*a108);
  a072=(a072-a109);
  a042=(a042/a072);
  a108=(a108*a042);
  a106=(a106-a108);
  a112=(a112*a106);
  a111=(a111-a112);
  a110=(a110*a042);
  a111=(a111+a110);
  a110=(a031*a111);
  a099=(a099+a110);
  a099=(a003+a099);
  a110=(a101*a099);
  a004=(a004+a110);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a009);
  a110=(a005*a016);
  a004=(a004+a110);
  a110=(a038*a030);
  a004=(a004+a110);
  a110=(a059*a073);
  a004=(a004+a110);
  a110=(a068*a084);
  a004=(a004+a110);
  a110=(a079*a095);
  a004=(a004+a110);
  a110=(a090*a067);
  a004=(a004+a110);
  a110=(a103*a028);
  a049=(a058*a049);
  a110=(a110+a049);
  a048=(a051*a048);
  a110=(a110+a048);
  a048=(a052*a055);
  a110=(a110+a048);
  a048=(a100*a064);
  a110=(a110+a048);
  a048=(a104*a075);
  a110=(a110+a048);
  a048=(a105*a086);
  a110=(a110+a048);
  a048=(a035*a097);
  a110=(a110+a048);
  a048=(a031*a106);
  a110=(a110+a048);
  a110=(a009+a110);
  a048=(a101*a110);
  a004=(a004+a048);
  a004=(a011+a004);
  if (res[0]!=0) res[0][1]=a004;
  a004=(a001*a036);
  a048=(a005*a006);
  a004=(a004+a048);
  a048=(a038*a053);
  a004=(a004+a048);
  a048=(a059*a061);
  a004=(a004+a048);
  a048=(a068*a070);
  a004=(a004+a048);
  a048=(a079*a081);
  a004=(a004+a048);
  a092=(a092*a010);
  a033=(a033*a041);
  a092=(a092+a033);
  a089=(a089*a037);
  a092=(a092+a089);
  a093=(a093*a020);
  a092=(a092+a093);
  a094=(a094*a050);
  a092=(a092+a094);
  a047=(a047*a074);
  a092=(a092+a047);
  a063=(a063*a085);
  a092=(a092+a063);
  a062=(a062*a096);
  a092=(a092+a062);
  a092=(a036+a092);
  a062=(a090*a092);
  a004=(a004+a062);
  a062=(a103*a010);
  a041=(a058*a041);
  a062=(a062+a041);
  a037=(a051*a037);
  a062=(a062+a037);
  a037=(a052*a020);
  a062=(a062+a037);
  a037=(a100*a050);
  a062=(a062+a037);
  a037=(a104*a074);
  a062=(a062+a037);
  a037=(a105*a085);
  a062=(a062+a037);
  a037=(a035*a096);
  a062=(a062+a037);
  a037=(a031*a042);
  a062=(a062+a037);
  a062=(a036+a062);
  a062=(a101*a062);
  a004=(a004+a062);
  a004=(a032+a004);
  if (res[0]!=0) res[0][2]=a004;
  a018=(a001*a018);
  a060=(a005*a060);
  a018=(a018+a060);
  a069=(a038*a069);
  a018=(a018+a069);
  a080=(a059*a080);
  a018=(a018+a080);
  a091=(a068*a091);
  a018=(a018+a091);
  a102=(a079*a102);
  a018=(a018+a102);
  a111=(a090*a111);
  a018=(a018+a111);
  a111=(a103*a003);
  a046=(a058*a046);
  a111=(a111+a046);
  a045=(a051*a045);
  a111=(a111+a045);
  a017=(a052*a017);
  a111=(a111+a017);
  a043=(a100*a043);
  a111=(a111+a043);
  a057=(a104*a057);
  a111=(a111+a057);
  a066=(a105*a066);
  a111=(a111+a066);
  a077=(a035*a077);
  a111=(a111+a077);
  a088=(a031*a088);
  a111=(a111+a088);
  a000=(a000+a111);
  a111=sin(a000);
  a088=(a008*a110);
  a077=(a103*a009);
  a044=(a058*a044);
  a077=(a077+a044);
  a034=(a051*a034);
  a077=(a077+a034);
  a034=(a052*a016);
  a077=(a077+a034);
  a034=(a100*a030);
  a077=(a077+a034);
  a034=(a104*a073);
  a077=(a077+a034);
  a034=(a105*a084);
  a077=(a077+a034);
  a034=(a035*a095);
  a077=(a077+a034);
  a034=(a031*a067);
  a077=(a077+a034);
  a011=(a011+a077);
  a077=sin(a011);
  a088=(a088*a077);
  a034=(2.*a099);
  a034=(a034-a110);
  a088=(a088*a034);
  a088=(a111-a088);
  a034=(a000-a011);
  a034=sin(a034);
  a044=(a034-a111);
  a044=(a008*a044);
  a088=(a088-a044);
  a044=cos(a011);
  a044=(a044-a014);
  a015=(a015*a044);
  a015=(a014-a015);
  a066=(a088/a015);
  a044=(a008*a044);
  a057=(a044/a015);
  a043=casadi_sq(a099);
  a043=(a043*a077);
  a043=(a043+a034);
  a043=(a008*a043);
  a023=(a023+a002);
  a021=(a021*a023);
  a023=sin(a021);
  a022=(a022*a023);
  a022=(a110+a022);
  a013=(a013*a022);
  a021=cos(a021);
  a021=(a021+a014);
  a012=(a012*a021);
  a027=(a027-a012);
  a027=(a027+a011);
  a026=(a026*a027);
  a013=(a013+a026);
  a043=(a043-a013);
  a026=(a057*a088);
  a043=(a043-a026);
  a026=(a044*a057);
  a008=(a008-a026);
  a026=(a043/a008);
  a000=cos(a000);
  a000=(a029*a000);
  a015=(a000/a015);
  a044=(a044*a015);
  a008=(a044/a008);
  a088=(a015*a088);
  a027=(a029*a099);
  a027=(a027*a099);
  a027=(a027*a111);
  a103=(a103*a036);
  a058=(a058*a024);
  a103=(a103+a058);
  a051=(a051*a039);
  a103=(a103+a051);
  a052=(a052*a006);
  a103=(a103+a052);
  a100=(a100*a053);
  a103=(a103+a100);
  a104=(a104*a061);
  a103=(a103+a104);
  a105=(a105*a070);
  a103=(a103+a105);
  a035=(a035*a081);
  a103=(a103+a035);
  a031=(a031*a092);
  a103=(a103+a031);
  a032=(a032+a103);
  a007=(a007*a032);
  a027=(a027+a007);
  a088=(a088-a027);
  a043=(a008*a043);
  a088=(a088-a043);
  a000=(a000*a015);
  a029=(a029-a000);
  a044=(a044*a008);
  a029=(a029-a044);
  a088=(a088/a029);
  a008=(a008*a088);
  a026=(a026-a008);
  a057=(a057*a026);
  a066=(a066-a057);
  a015=(a015*a088);
  a066=(a066+a015);
  a066=(a101*a066);
  a018=(a018+a066);
  a003=(a003+a018);
  if (res[0]!=0) res[0][3]=a003;
  a028=(a001*a028);
  a055=(a005*a055);
  a028=(a028+a055);
  a064=(a038*a064);
  a028=(a028+a064);
  a075=(a059*a075);
  a028=(a028+a075);
  a086=(a068*a086);
  a028=(a028+a086);
  a097=(a079*a097);
  a028=(a028+a097);
  a106=(a090*a106);
  a028=(a028+a106);
  a026=(a101*a026);
  a028=(a028+a026);
  a028=(a009+a028);
  if (res[0]!=0) res[0][4]=a028;
  a010=(a001*a010);
  a020=(a005*a020);
  a010=(a010+a020);
  a050=(a038*a050);
  a010=(a010+a050);
  a074=(a059*a074);
  a010=(a010+a074);
  a085=(a068*a085);
  a010=(a010+a085);
  a096=(a079*a096);
  a010=(a010+a096);
  a042=(a090*a042);
  a010=(a010+a042);
  a088=(a101*a088);
  a010=(a010+a088);
  a036=(a036+a010);
  if (res[0]!=0) res[0][5]=a036;
  a036=arg[1]? arg[1][6] : 0;
  a025=(a025*a009);
  a001=(a001*a025);
  a056=(a056*a016);
  a005=(a005*a056);
  a001=(a001+a005);
  a065=(a065*a030);
  a038=(a038*a065);
  a001=(a001+a038);
  a076=(a076*a073);
  a059=(a059*a076);
  a001=(a001+a059);
  a087=(a087*a084);
  a068=(a068*a087);
  a001=(a001+a068);
  a098=(a098*a095);
  a079=(a079*a098);
  a001=(a001+a079);
  a107=(a107*a067);
  a090=(a090*a107);
  a001=(a001+a090);
  a013=(a013*a110);
  a101=(a101*a013);
  a001=(a001+a101);
  a036=(a036-a001);
  if (res[0]!=0) res[0][6]=a036;
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
  a20=(a19-a18);
  a13=(a13+a20);
  a21=(2.*a14);
  a22=(a21+a10);
  a13=(a13/a22);
  a23=cos(a15);
  a16=cos(a16);
  a24=(a23-a16);
  a25=(a14*a24);
  a25=(a25+a23);
  a26=(a25/a22);
  a27=(a14*a01);
  a28=sin(a11);
  a29=(a27*a28);
  a30=arg[1]? arg[1][3] : 0;
  a31=(2.*a30);
  a32=(a31-a01);
  a33=(a29*a32);
  a20=(a33+a20);
  a34=cos(a11);
  a35=(a34-a10);
  a36=(a21*a35);
  a36=(a10-a36);
  a37=(a20/a36);
  a35=(a14*a35);
  a38=(a35/a36);
  a39=casadi_sq(a30);
  a40=(a39*a28);
  a40=(a40+a17);
  a40=(a14*a40);
  a40=(a40-a07);
  a41=(a38*a20);
  a41=(a40+a41);
  a42=(a35*a38);
  a42=(a14-a42);
  a43=(a41/a42);
  a44=(a09*a23);
  a45=(a44/a36);
  a46=(a35*a45);
  a47=(a46/a42);
  a48=(a09*a30);
  a49=(a48*a30);
  a50=(a49*a18);
  a51=arg[2]? arg[2][0] : 0;
  a52=(a51*a12);
  a50=(a50+a52);
  a52=(a45*a20);
  a52=(a50+a52);
  a53=(a47*a41);
  a52=(a52+a53);
  a53=(a44*a45);
  a53=(a09-a53);
  a54=(a46*a47);
  a53=(a53-a54);
  a52=(a52/a53);
  a54=(a47*a52);
  a54=(a43+a54);
  a55=(a38*a54);
  a55=(a37+a55);
  a56=(a45*a52);
  a55=(a55+a56);
  a56=(a55*a25);
  a57=(a54*a14);
  a58=(a57*a16);
  a56=(a56-a58);
  a58=(a52*a09);
  a56=(a56-a58);
  a58=(a27*a01);
  a59=(a58*a17);
  a56=(a56-a59);
  a60=(a14*a17);
  a61=(a31*a01);
  a62=(a60*a61);
  a56=(a56+a62);
  a63=(a14*a18);
  a63=(a63-a60);
  a63=(a63+a18);
  a64=(a39*a63);
  a56=(a56+a64);
  a65=(a26*a56);
  a66=(a16*a30);
  a67=(a66*a30);
  a68=(a55*a17);
  a69=(a54*a17);
  a68=(a68+a69);
  a68=(a67-a68);
  a69=(a16*a01);
  a70=(a69*a01);
  a68=(a68+a70);
  a71=(a16*a61);
  a68=(a68-a71);
  a72=(a23*a30);
  a73=(a72*a30);
  a74=(a55*a18);
  a74=(a73-a74);
  a68=(a68-a74);
  a75=2.;
  a68=(a68+a75);
  a68=(a14*a68);
  a68=(a68-a74);
  a68=(a68+a10);
  a65=(a65/a68);
  a13=(a13-a65);
  a13=(-a13);
  if (res[0]!=0) res[0][1]=a13;
  a33=(a18-a33);
  a33=(a33-a19);
  a19=(a33/a36);
  a13=(a38*a33);
  a40=(a40-a13);
  a13=(a40/a42);
  a74=(a45*a33);
  a74=(a74-a50);
  a50=(a47*a40);
  a74=(a74-a50);
  a74=(a74/a53);
  a50=(a47*a74);
  a50=(a13-a50);
  a76=(a38*a50);
  a76=(a19-a76);
  a77=(a45*a74);
  a76=(a76+a77);
  a77=(a76*a17);
  a78=(a50*a17);
  a77=(a77-a78);
  a77=(a77+a67);
  a77=(a77+a70);
  a77=(a77-a71);
  a71=(a76*a18);
  a71=(a71+a73);
  a77=(a77-a71);
  a77=(a77+a75);
  a77=(a14*a77);
  a77=(a77-a71);
  a77=(a77+a10);
  if (res[0]!=0) res[0][2]=a77;
  a10=(a16-a23);
  a10=(a14*a10);
  a10=(a10-a23);
  a71=(a76*a10);
  a75=(a50*a14);
  a73=(a75*a16);
  a71=(a71-a73);
  a73=(a74*a09);
  a71=(a71+a73);
  a71=(a71-a59);
  a71=(a71+a62);
  a71=(a71+a64);
  a71=(a71/a77);
  if (res[0]!=0) res[0][3]=a71;
  if (res[0]!=0) res[0][4]=a24;
  if (res[0]!=0) res[0][5]=a76;
  a15=(2.*a15);
  a11=(a11-a15);
  if (res[0]!=0) res[0][6]=a11;
  if (res[0]!=0) res[0][7]=a12;
  a05=(a05*a03);
  a04=(a04*a05);
  a04=(a50+a04);
  a00=(a00*a04);
  a06=(a06*a03);
  a02=(a02*a06);
  a02=(a02+a01);
  a08=(a08*a02);
  a00=(a00+a08);
  a08=(a01*a00);
  a07=(a07*a50);
  a08=(a08+a07);
  a08=(-a08);
  if (res[1]!=0) res[1][0]=a08;
  a08=arg[1]? arg[1][5] : 0;
  a07=(a09*a08);
  a02=(a30-a01);
  a06=(a16*a02);
  a03=(a06-a72);
  a03=(a14*a03);
  a04=(a03-a72);
  a07=(a07+a04);
  a07=(a07/a22);
  a02=(a17*a02);
  a05=(a18*a30);
  a12=(a02-a05);
  a11=(a14*a12);
  a11=(a11-a05);
  a22=(a11/a22);
  a56=(a56*a22);
  a22=(a14*a50);
  a15=(a28*a22);
  a34=(a34*a01);
  a24=(a27*a34);
  a15=(a15+a24);
  a32=(a32*a15);
  a15=(2.*a76);
  a24=(a15-a50);
  a29=(a29*a24);
  a32=(a32+a29);
  a04=(a32+a04);
  a29=(a04/a36);
  a37=(a37/a36);
  a24=(a28*a01);
  a21=(a21*a24);
  a37=(a37*a21);
  a29=(a29-a37);
  a37=(a31*a76);
  a28=(a28*a37);
  a34=(a39*a34);
  a28=(a28+a34);
  a28=(a28+a06);
  a28=(a14*a28);
  a28=(a28-a00);
  a00=(a38*a04);
  a24=(a14*a24);
  a34=(a24/a36);
  a64=(a38/a36);
  a64=(a64*a21);
  a34=(a34+a64);
  a64=(a20*a34);
  a00=(a00-a64);
  a00=(a28+a00);
  a64=(a00/a42);
  a43=(a43/a42);
  a62=(a38*a24);
  a59=(a35*a34);
  a62=(a62+a59);
  a43=(a43*a62);
  a64=(a64-a43);
  a43=(a09*a76);
  a43=(a30*a43);
  a48=(a48*a76);
  a43=(a43+a48);
  a43=(a18*a43);
  a49=(a49*a72);
  a43=(a43+a49);
  a51=(a51*a08);
  a43=(a43+a51);
  a04=(a45*a04);
  a51=(a09*a05);
  a49=(a51/a36);
  a48=(a45/a36);
  a48=(a48*a21);
  a49=(a49+a48);
  a20=(a20*a49);
  a04=(a04-a20);
  a04=(a43+a04);
  a00=(a47*a00);
  a24=(a45*a24);
  a35=(a35*a49);
  a24=(a24+a35);
  a35=(a24/a42);
  a20=(a47/a42);
  a20=(a20*a62);
  a35=(a35+a20);
  a41=(a41*a35);
  a00=(a00-a41);
  a04=(a04+a00);
  a04=(a04/a53);
  a00=(a52/a53);
  a51=(a45*a51);
  a44=(a44*a49);
  a51=(a51+a44);
  a24=(a47*a24);
  a46=(a46*a35);
  a24=(a24+a46);
  a51=(a51+a24);
  a00=(a00*a51);
  a04=(a04-a00);
  a00=(a47*a04);
  a24=(a52*a35);
  a00=(a00-a24);
  a64=(a64+a00);
  a00=(a38*a64);
  a24=(a54*a34);
  a00=(a00-a24);
  a29=(a29+a00);
  a00=(a45*a04);
  a52=(a52*a49);
  a00=(a00-a52);
  a29=(a29+a00);
  a25=(a25*a29);
  a11=(a55*a11);
  a25=(a25+a11);
  a11=(a14*a64);
  a11=(a16*a11);
  a57=(a57*a02);
  a11=(a11-a57);
  a25=(a25-a11);
  a04=(a09*a04);
  a25=(a25-a04);
  a22=(a01*a22);
  a27=(a27*a50);
  a22=(a22+a27);
  a22=(a17*a22);
  a58=(a58*a06);
  a22=(a22+a58);
  a25=(a25-a22);
  a58=(a14*a06);
  a27=(a61*a58);
  a15=(a01*a15);
  a04=(a31*a50);
  a15=(a15+a04);
  a60=(a60*a15);
  a27=(a27+a60);
  a25=(a25+a27);
  a63=(a63*a37);
  a37=(a14*a72);
  a37=(a37-a58);
  a37=(a37+a72);
  a39=(a39*a37);
  a63=(a63+a39);
  a25=(a25+a63);
  a26=(a26*a25);
  a56=(a56+a26);
  a56=(a56/a68);
  a65=(a65/a68);
  a68=(a16*a76);
  a26=(a30*a02);
  a68=(a68-a26);
  a68=(a30*a68);
  a66=(a66*a76);
  a68=(a68+a66);
  a66=(a17*a29);
  a26=(a55*a06);
  a66=(a66+a26);
  a64=(a17*a64);
  a54=(a54*a06);
  a64=(a64+a54);
  a66=(a66+a64);
  a66=(a68-a66);
  a64=(a16*a50);
  a54=(a01*a02);
  a64=(a64-a54);
  a64=(a01*a64);
  a69=(a69*a50);
  a64=(a64+a69);
  a66=(a66+a64);
  a15=(a16*a15);
  a61=(a61*a02);
  a15=(a15-a61);
  a66=(a66-a15);
  a23=(a23*a76);
  a61=(a30*a05);
  a23=(a23-a61);
  a30=(a30*a23);
  a23=(a72*a76);
  a30=(a30+a23);
  a29=(a18*a29);
  a55=(a55*a72);
  a29=(a29+a55);
  a29=(a30-a29);
  a66=(a66-a29);
  a66=(a14*a66);
  a66=(a66-a29);
  a65=(a65*a66);
  a56=(a56-a65);
  a07=(a07-a56);
  a07=(-a07);
  if (res[1]!=0) res[1][1]=a07;
  a32=(a72-a32);
  a32=(a32-a03);
  a03=(a32/a36);
  a19=(a19/a36);
  a19=(a19*a21);
  a03=(a03-a19);
  a19=(a38*a32);
  a21=(a33*a34);
  a19=(a19-a21);
  a28=(a28-a19);
  a19=(a28/a42);
  a13=(a13/a42);
  a13=(a13*a62);
  a19=(a19-a13);
  a32=(a45*a32);
  a33=(a33*a49);
  a32=(a32-a33);
  a32=(a32-a43);
  a28=(a47*a28);
  a40=(a40*a35);
  a28=(a28-a40);
  a32=(a32-a28);
  a32=(a32/a53);
  a53=(a74/a53);
  a53=(a53*a51);
  a32=(a32-a53);
  a47=(a47*a32);
  a35=(a74*a35);
  a47=(a47-a35);
  a19=(a19-a47);
  a38=(a38*a19);
  a34=(a50*a34);
  a38=(a38-a34);
  a03=(a03-a38);
  a45=(a45*a32);
  a74=(a74*a49);
  a45=(a45-a74);
  a03=(a03+a45);
  a45=(a17*a03);
  a74=(a76*a06);
  a45=(a45+a74);
  a17=(a17*a19);
  a50=(a50*a06);
  a17=(a17+a50);
  a45=(a45-a17);
  a45=(a45+a68);
  a45=(a45+a64);
  a45=(a45-a15);
  a18=(a18*a03);
  a72=(a76*a72);
  a18=(a18+a72);
  a18=(a18+a30);
  a45=(a45-a18);
  a45=(a14*a45);
  a45=(a45-a18);
  if (res[1]!=0) res[1][2]=a45;
  a10=(a10*a03);
  a18=(a05-a02);
  a18=(a14*a18);
  a18=(a18+a05);
  a76=(a76*a18);
  a10=(a10+a76);
  a14=(a14*a19);
  a16=(a16*a14);
  a75=(a75*a02);
  a16=(a16-a75);
  a10=(a10-a16);
  a09=(a09*a32);
  a10=(a10+a09);
  a10=(a10-a22);
  a10=(a10+a27);
  a10=(a10+a63);
  a10=(a10/a77);
  a71=(a71/a77);
  a71=(a71*a45);
  a10=(a10-a71);
  if (res[1]!=0) res[1][3]=a10;
  if (res[1]!=0) res[1][4]=a12;
  if (res[1]!=0) res[1][5]=a03;
  a01=(a01-a31);
  if (res[1]!=0) res[1][6]=a01;
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

/* trace_48:(u[6],p[8])->(w[7x49],g[8x49],dg[8x49],R[6]) */
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

CASADI_SYMBOL_EXPORT int trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int trace_48_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void trace_48_release(int mem) {
}

CASADI_SYMBOL_EXPORT void trace_48_incref(void) {
}

CASADI_SYMBOL_EXPORT void trace_48_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int trace_48_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int trace_48_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real trace_48_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_48_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_48_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_48_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_48_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s7;
    case 1: return casadi_s8;
    case 2: return casadi_s8;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int trace_48_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1237;
  return 0;
}

CASADI_SYMBOL_EXPORT int trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1237*sizeof(casadi_real);
  return 0;
}

/* trace_96:(u[6],p[8])->(w[7x97],g[8x97],dg[8x97],R[6]) */
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

CASADI_SYMBOL_EXPORT int trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f43(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int trace_96_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void trace_96_release(int mem) {
}

CASADI_SYMBOL_EXPORT void trace_96_incref(void) {
}

CASADI_SYMBOL_EXPORT void trace_96_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int trace_96_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int trace_96_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real trace_96_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_96_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_96_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_96_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_96_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 2005;
  return 0;
}

CASADI_SYMBOL_EXPORT int trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 2005*sizeof(casadi_real);
  return 0;
}

/* trace_192:(u[6],p[8])->(w[7x193],g[8x193],dg[8x193],R[6]) */
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

CASADI_SYMBOL_EXPORT int trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int trace_192_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void trace_192_release(int mem) {
}

CASADI_SYMBOL_EXPORT void trace_192_incref(void) {
}

CASADI_SYMBOL_EXPORT void trace_192_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int trace_192_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int trace_192_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real trace_192_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_192_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_192_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_192_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_192_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3541;
  return 0;
}

CASADI_SYMBOL_EXPORT int trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3541*sizeof(casadi_real);
  return 0;
}

/* trace_384:(u[6],p[8])->(w[7x385],g[8x385],dg[8x385],R[6]) */
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

CASADI_SYMBOL_EXPORT int trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f45(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int trace_384_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void trace_384_release(int mem) {
}

CASADI_SYMBOL_EXPORT void trace_384_incref(void) {
}

CASADI_SYMBOL_EXPORT void trace_384_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int trace_384_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int trace_384_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real trace_384_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_384_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_384_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_384_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_384_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6613;
  return 0;
}

CASADI_SYMBOL_EXPORT int trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6613*sizeof(casadi_real);
  return 0;
}

/* trace_768:(u[6],p[8])->(w[7x769],g[8x769],dg[8x769],R[6]) */
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

CASADI_SYMBOL_EXPORT int trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f46(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int trace_768_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void trace_768_release(int mem) {
}

CASADI_SYMBOL_EXPORT void trace_768_incref(void) {
}

CASADI_SYMBOL_EXPORT void trace_768_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int trace_768_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int trace_768_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real trace_768_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_768_name_in(casadi_int i) {
  switch (i) {
    case 0: return "u";
    case 1: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* trace_768_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w";
    case 1: return "g";
    case 2: return "dg";
    case 3: return "R";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_768_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* trace_768_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12757;
  return 0;
}

CASADI_SYMBOL_EXPORT int trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12757*sizeof(casadi_real);
  return 0;
}

/* advance:(t,w[7],h,p[8])->(w_end[7],g[8],dg[8]) */
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

CASADI_SYMBOL_EXPORT int advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f47(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int advance_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void advance_release(int mem) {
}

CASADI_SYMBOL_EXPORT void advance_incref(void) {
}

CASADI_SYMBOL_EXPORT void advance_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int advance_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int advance_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real advance_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* advance_name_in(casadi_int i) {
  switch (i) {
    case 0: return "t";
    case 1: return "w";
    case 2: return "h";
    case 3: return "p";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* advance_name_out(casadi_int i) {
  switch (i) {
    case 0: return "w_end";
    case 1: return "g";
    case 2: return "dg";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* advance_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s17;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s18;
    case 1: return casadi_s5;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 152;
  return 0;
}

CASADI_SYMBOL_EXPORT int advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
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

typedef int (*stridemap_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int stridemap_map(stridemap_kernel kernel, const casadi_int* work_size, casadi_int n,
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
