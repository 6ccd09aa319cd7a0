/* Compass walker: kernels of the solver
 * Printed by CasADi 3.8.2 from equations c442f74fc5d9ec97.
 * Do not edit: run `make derive`.
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
#define casadi_s19 CASADI_PREFIX(s19)
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
static const casadi_int casadi_s8[3] = {8, 49, 1};
static const casadi_int casadi_s9[3] = {5, 97, 1};
static const casadi_int casadi_s10[3] = {8, 97, 1};
static const casadi_int casadi_s11[3] = {5, 193, 1};
static const casadi_int casadi_s12[3] = {8, 193, 1};
static const casadi_int casadi_s13[3] = {5, 385, 1};
static const casadi_int casadi_s14[3] = {8, 385, 1};
static const casadi_int casadi_s15[3] = {5, 769, 1};
static const casadi_int casadi_s16[3] = {8, 769, 1};
static const casadi_int casadi_s17[3] = {1, 1, 1};
static const casadi_int casadi_s18[3] = {5, 1, 1};
static const casadi_int casadi_s19[3] = {8, 1, 1};

static const casadi_real casadi_zeros[16] = 
  {0.};

/* start:(z[3])->(y[4],dy_dz[4x3]) */
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

/* variational_step:(y[4x4],t,h,p[6])->(y_end[4x4]) */
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
  casadi_real a228, a229, a230, a231, a232, a233, a234, a235, a236;
  a000=arg[0]? arg[0][0] : 0;
  a001=5.4293734116568765e-02;
  a002=arg[2]? arg[2][0] : 0;
  a001=(a001*a002);
  a003=arg[0]? arg[0][2] : 0;
  a004=(a001*a003);
  a005=4.4503128927524092e+00;
  a005=(a005*a002);
  a006=3.7037037037037035e-02;
  a006=(a006*a002);
  a007=arg[3]? arg[3][1] : 0;
  a008=arg[0]? arg[0][3] : 0;
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
  a015=arg[3]? arg[3][3] : 0;
  a025=arg[3]? arg[3][5] : 0;
  a026=arg[3]? arg[3][0] : 0;
  a027=(a025*a026);
  a028=arg[1]? arg[1][0] : 0;
  a029=(a026*a028);
  a030=sin(a029);
  a030=(a027*a030);
  a030=(a008+a030);
  a030=(a015*a030);
  a031=arg[3]? arg[3][2] : 0;
  a032=arg[3]? arg[3][4] : 0;
  a029=cos(a029);
  a029=(a029+a018);
  a029=(a025*a029);
  a029=(a032-a029);
  a029=(a029+a010);
  a029=(a031*a029);
  a030=(a030+a029);
  a024=(a024-a030);
  a009=(a023*a009);
  a009=(a024-a009);
  a022=(a022*a023);
  a022=(a007-a022);
  a009=(a009/a022);
  a030=(a023*a009);
  a021=(a021-a030);
  a030=(a006*a021);
  a029=1.7082860872947386e-01;
  a029=(a029*a002);
  a033=2.9587585476806851e-02;
  a033=(a033*a002);
  a034=(a033*a009);
  a035=8.8762756430420545e-02;
  a035=(a035*a002);
  a036=1.9725056984537900e-02;
  a036=(a036*a002);
  a037=(a036*a021);
  a038=5.9175170953613701e-02;
  a038=(a038*a002);
  a039=5.2600151958767730e-02;
  a039=(a039*a002);
  a040=(a039*a009);
  a040=(a008+a040);
  a041=(a007*a040);
  a042=(a039*a008);
  a042=(a010+a042);
  a043=sin(a042);
  a041=(a041*a043);
  a044=(a039*a021);
  a044=(a003+a044);
  a045=(2.*a044);
  a046=(a040-a045);
  a041=(a041*a046);
  a046=(a039*a003);
  a046=(a000+a046);
  a047=sin(a046);
  a048=(a046-a042);
  a049=sin(a048);
  a050=(a047-a049);
  a050=(a007*a050);
  a041=(a041+a050);
  a041=(a041+a047);
  a051=cos(a042);
  a052=(a018-a051);
  a052=(a017*a052);
  a052=(a052+a018);
  a053=(a041/a052);
  a054=(a051-a018);
  a054=(a007*a054);
  a055=(a054/a052);
  a056=casadi_sq(a044);
  a056=(a056*a043);
  a056=(a056+a049);
  a056=(a007*a056);
  a049=(a028+a039);
  a049=(a026*a049);
  a057=sin(a049);
  a057=(a027*a057);
  a057=(a040+a057);
  a057=(a015*a057);
  a049=cos(a049);
  a049=(a049+a018);
  a049=(a025*a049);
  a049=(a032-a049);
  a049=(a049+a042);
  a049=(a031*a049);
  a057=(a057+a049);
  a056=(a056-a057);
  a041=(a055*a041);
  a041=(a056-a041);
  a054=(a054*a055);
  a054=(a007-a054);
  a041=(a041/a054);
  a057=(a055*a041);
  a053=(a053-a057);
  a053=(a038*a053);
  a037=(a037+a053);
  a037=(a003+a037);
  a053=casadi_sq(a037);
  a057=(a036*a008);
  a049=(a038*a040);
  a057=(a057+a049);
  a057=(a010+a057);
  a049=sin(a057);
  a053=(a053*a049);
  a042=(a036*a003);
  a058=(a038*a044);
  a042=(a042+a058);
  a042=(a000+a042);
  a058=(a042-a057);
  a059=sin(a058);
  a053=(a053+a059);
  a053=(a007*a053);
  a060=(a036*a009);
  a041=(a038*a041);
  a060=(a060+a041);
  a060=(a008+a060);
  a041=7.8900227938151601e-02;
  a041=(a041*a002);
  a041=(a028+a041);
  a041=(a026*a041);
  a061=sin(a041);
  a061=(a027*a061);
  a061=(a060+a061);
  a061=(a015*a061);
  a041=cos(a041);
  a041=(a041+a018);
  a041=(a025*a041);
  a041=(a032-a041);
  a041=(a041+a057);
  a041=(a031*a041);
  a061=(a061+a041);
  a053=(a053-a061);
  a057=cos(a057);
  a061=(a057-a018);
  a061=(a007*a061);
  a041=(a018-a057);
  a041=(a017*a041);
  a041=(a041+a018);
  a062=(a061/a041);
  a063=(a007*a060);
  a063=(a063*a049);
  a064=(2.*a037);
  a065=(a060-a064);
  a063=(a063*a065);
  a065=sin(a042);
  a059=(a065-a059);
  a059=(a007*a059);
  a063=(a063+a059);
  a063=(a063+a065);
  a066=(a062*a063);
  a066=(a053-a066);
  a061=(a061*a062);
  a061=(a007-a061);
  a066=(a066/a061);
  a067=(a035*a066);
  a034=(a034+a067);
  a034=(a008+a034);
  a067=(a007*a034);
  a068=(a033*a008);
  a069=(a035*a060);
  a068=(a068+a069);
  a068=(a010+a068);
  a069=sin(a068);
  a067=(a067*a069);
  a070=(a033*a021);
  a063=(a063/a041);
  a071=(a062*a066);
  a063=(a063-a071);
  a071=(a035*a063);
  a070=(a070+a071);
  a070=(a003+a070);
  a071=(2.*a070);
  a072=(a034-a071);
  a067=(a067*a072);
  a072=(a033*a003);
  a073=(a035*a037);
  a072=(a072+a073);
  a072=(a000+a072);
  a073=sin(a072);
  a074=(a072-a068);
  a075=sin(a074);
  a076=(a073-a075);
  a076=(a007*a076);
  a067=(a067+a076);
  a067=(a067+a073);
  a077=cos(a068);
  a078=(a018-a077);
  a078=(a017*a078);
  a078=(a078+a018);
  a079=(a067/a078);
  a080=(a077-a018);
  a080=(a007*a080);
  a081=(a080/a078);
  a082=casadi_sq(a070);
  a082=(a082*a069);
  a082=(a082+a075);
  a082=(a007*a082);
  a075=1.1835034190722740e-01;
  a075=(a075*a002);
  a075=(a028+a075);
  a075=(a026*a075);
  a083=sin(a075);
  a083=(a027*a083);
  a083=(a034+a083);
  a083=(a015*a083);
  a075=cos(a075);
  a075=(a075+a018);
  a075=(a025*a075);
  a075=(a032-a075);
  a075=(a075+a068);
  a075=(a031*a075);
  a083=(a083+a075);
  a082=(a082-a083);
  a067=(a081*a067);
  a067=(a082-a067);
  a080=(a080*a081);
  a080=(a007-a080);
  a067=(a067/a080);
  a083=(a081*a067);
  a079=(a079-a083);
  a083=(a029*a079);
  a030=(a030+a083);
  a083=1.2546768756682242e-01;
  a083=(a083*a002);
  a075=2.4136513415926669e-01;
  a075=(a075*a002);
  a068=(a075*a009);
  a084=-8.8454947932828609e-01;
  a084=(a084*a002);
  a066=(a084*a066);
  a068=(a068+a066);
  a066=9.2483400326179199e-01;
  a066=(a066*a002);
  a085=(a066*a067);
  a068=(a068+a085);
  a068=(a008+a068);
  a085=(a007*a068);
  a086=(a075*a008);
  a087=(a084*a060);
  a086=(a086+a087);
  a087=(a066*a034);
  a086=(a086+a087);
  a086=(a010+a086);
  a087=sin(a086);
  a085=(a085*a087);
  a088=(a075*a021);
  a063=(a084*a063);
  a088=(a088+a063);
  a063=(a066*a079);
  a088=(a088+a063);
  a088=(a003+a088);
  a063=(2.*a088);
  a089=(a068-a063);
  a085=(a085*a089);
  a089=(a075*a003);
  a090=(a084*a037);
  a089=(a089+a090);
  a090=(a066*a070);
  a089=(a089+a090);
  a089=(a000+a089);
  a090=sin(a089);
  a091=(a089-a086);
  a092=sin(a091);
  a093=(a090-a092);
  a093=(a007*a093);
  a085=(a085+a093);
  a085=(a085+a090);
  a094=cos(a086);
  a095=(a018-a094);
  a095=(a017*a095);
  a095=(a095+a018);
  a096=(a085/a095);
  a097=(a094-a018);
  a097=(a007*a097);
  a098=(a097/a095);
  a099=casadi_sq(a088);
  a099=(a099*a087);
  a099=(a099+a092);
  a099=(a007*a099);
  a092=2.8164965809277259e-01;
  a092=(a092*a002);
  a092=(a028+a092);
  a092=(a026*a092);
  a100=sin(a092);
  a100=(a027*a100);
  a100=(a068+a100);
  a100=(a015*a100);
  a092=cos(a092);
  a092=(a092+a018);
  a092=(a025*a092);
  a092=(a032-a092);
  a092=(a092+a086);
  a092=(a031*a092);
  a100=(a100+a092);
  a099=(a099-a100);
  a085=(a098*a085);
  a085=(a099-a085);
  a097=(a097*a098);
  a097=(a007-a097);
  a085=(a085/a097);
  a100=(a098*a085);
  a096=(a096-a100);
  a100=(a083*a096);
  a030=(a030+a100);
  a030=(a003+a030);
  a100=(a005*a030);
  a004=(a004+a100);
  a100=1.8915178993145003e+00;
  a100=(a100*a002);
  a092=3.7109375000000000e-02;
  a092=(a092*a002);
  a086=(a092*a021);
  a101=1.7025221101954405e-01;
  a101=(a101*a002);
  a102=(a101*a079);
  a086=(a086+a102);
  a102=6.0216538980455959e-02;
  a102=(a102*a002);
  a103=(a102*a096);
  a086=(a086+a103);
  a103=-1.7578125000000000e-02;
  a103=(a103*a002);
  a104=(a006*a009);
  a105=(a029*a067);
  a104=(a104+a105);
  a105=(a083*a085);
  a104=(a104+a105);
  a104=(a008+a104);
  a105=(a007*a104);
  a106=(a006*a008);
  a107=(a029*a034);
  a106=(a106+a107);
  a107=(a083*a068);
  a106=(a106+a107);
  a106=(a010+a106);
  a107=sin(a106);
  a105=(a105*a107);
  a108=(2.*a030);
  a109=(a104-a108);
  a105=(a105*a109);
  a109=(a006*a003);
  a110=(a029*a070);
  a109=(a109+a110);
  a110=(a083*a088);
  a109=(a109+a110);
  a109=(a000+a109);
  a110=sin(a109);
  a111=(a109-a106);
  a112=sin(a111);
  a113=(a110-a112);
  a113=(a007*a113);
  a105=(a105+a113);
  a105=(a105+a110);
  a114=cos(a106);
  a115=(a018-a114);
  a115=(a017*a115);
  a115=(a115+a018);
  a116=(a105/a115);
  a117=(a114-a018);
  a117=(a007*a117);
  a118=(a117/a115);
  a119=casadi_sq(a030);
  a119=(a119*a107);
  a119=(a119+a112);
  a119=(a007*a119);
  a112=3.3333333333333331e-01;
  a112=(a112*a002);
  a112=(a028+a112);
  a112=(a026*a112);
  a120=sin(a112);
  a120=(a027*a120);
  a120=(a104+a120);
  a120=(a015*a120);
  a112=cos(a112);
  a112=(a112+a018);
  a112=(a025*a112);
  a112=(a032-a112);
  a112=(a112+a106);
  a112=(a031*a112);
  a120=(a120+a112);
  a119=(a119-a120);
  a105=(a118*a105);
  a105=(a119-a105);
  a117=(a117*a118);
  a117=(a007-a117);
  a105=(a105/a117);
  a120=(a118*a105);
  a116=(a116-a120);
  a120=(a103*a116);
  a086=(a086+a120);
  a086=(a003+a086);
  a120=(a100*a086);
  a004=(a004+a120);
  a120=-5.8012039600105849e+00;
  a120=(a120*a002);
  a112=3.7092000118504789e-02;
  a112=(a112*a002);
  a106=(a112*a021);
  a121=1.7038392571223998e-01;
  a121=(a121*a002);
  a122=(a121*a079);
  a106=(a106+a122);
  a122=1.0726203044637328e-01;
  a122=(a122*a002);
  a123=(a122*a096);
  a106=(a106+a123);
  a123=-1.5319437748624402e-02;
  a123=(a123*a002);
  a124=(a123*a116);
  a106=(a106+a124);
  a124=8.2737891638140233e-03;
  a124=(a124*a002);
  a125=(a092*a009);
  a126=(a101*a067);
  a125=(a125+a126);
  a126=(a102*a085);
  a125=(a125+a126);
  a126=(a103*a105);
  a125=(a125+a126);
  a125=(a008+a125);
  a126=(a007*a125);
  a127=(a092*a008);
  a128=(a101*a034);
  a127=(a127+a128);
  a128=(a102*a068);
  a127=(a127+a128);
  a128=(a103*a104);
  a127=(a127+a128);
  a127=(a010+a127);
  a128=sin(a127);
  a126=(a126*a128);
  a129=(2.*a086);
  a130=(a125-a129);
  a126=(a126*a130);
  a130=(a092*a003);
  a131=(a101*a070);
  a130=(a130+a131);
  a131=(a102*a088);
  a130=(a130+a131);
  a131=(a103*a030);
  a130=(a130+a131);
  a130=(a000+a130);
  a131=sin(a130);
  a132=(a130-a127);
  a133=sin(a132);
  a134=(a131-a133);
  a134=(a007*a134);
  a126=(a126+a134);
  a126=(a126+a131);
  a135=cos(a127);
  a136=(a018-a135);
  a136=(a017*a136);
  a136=(a136+a018);
  a137=(a126/a136);
  a138=(a135-a018);
  a138=(a007*a138);
  a139=(a138/a136);
  a140=casadi_sq(a086);
  a140=(a140*a128);
  a140=(a140+a133);
  a140=(a007*a140);
  a133=2.5000000000000000e-01;
  a133=(a133*a002);
  a133=(a028+a133);
  a133=(a026*a133);
  a141=sin(a133);
  a141=(a027*a141);
  a141=(a125+a141);
  a141=(a015*a141);
  a133=cos(a133);
  a133=(a133+a018);
  a133=(a025*a133);
  a133=(a032-a133);
  a133=(a133+a127);
  a133=(a031*a133);
  a141=(a141+a133);
  a140=(a140-a141);
  a126=(a139*a126);
  a126=(a140-a126);
  a138=(a138*a139);
  a138=(a007-a138);
  a126=(a126/a138);
  a141=(a139*a126);
  a137=(a137-a141);
  a141=(a124*a137);
  a106=(a106+a141);
  a106=(a003+a106);
  a141=(a120*a106);
  a004=(a004+a141);
  a141=3.1116436695781990e-01;
  a141=(a141*a002);
  a133=6.2411095871607569e-01;
  a133=(a133*a002);
  a127=(a133*a021);
  a142=-3.3608926294469414e+00;
  a142=(a142*a002);
  a143=(a142*a079);
  a127=(a127+a143);
  a143=-8.6821934684172597e-01;
  a143=(a143*a002);
  a144=(a143*a096);
  a127=(a127+a144);
  a144=2.7592099699446710e+01;
  a144=(a144*a002);
  a145=(a144*a116);
  a127=(a127+a145);
  a145=2.0154067550477894e+01;
  a145=(a145*a002);
  a146=(a145*a137);
  a127=(a127+a146);
  a146=-4.3489884181069961e+01;
  a146=(a146*a002);
  a147=(a112*a009);
  a148=(a121*a067);
  a147=(a147+a148);
  a148=(a122*a085);
  a147=(a147+a148);
  a148=(a123*a105);
  a147=(a147+a148);
  a148=(a124*a126);
  a147=(a147+a148);
  a147=(a008+a147);
  a148=(a007*a147);
  a149=(a112*a008);
  a150=(a121*a034);
  a149=(a149+a150);
  a150=(a122*a068);
  a149=(a149+a150);
  a150=(a123*a104);
  a149=(a149+a150);
  a150=(a124*a125);
  a149=(a149+a150);
  a149=(a010+a149);
  a150=sin(a149);
  a148=(a148*a150);
  a151=(2.*a106);
  a152=(a147-a151);
  a148=(a148*a152);
  a152=(a112*a003);
  a153=(a121*a070);
  a152=(a152+a153);
  a153=(a122*a088);
  a152=(a152+a153);
  a153=(a123*a030);
  a152=(a152+a153);
  a153=(a124*a086);
  a152=(a152+a153);
  a152=(a000+a152);
  a153=sin(a152);
  a154=(a152-a149);
  a155=sin(a154);
  a156=(a153-a155);
  a156=(a007*a156);
  a148=(a148+a156);
  a148=(a148+a153);
  a157=cos(a149);
  a158=(a018-a157);
  a158=(a017*a158);
  a158=(a158+a018);
  a159=(a148/a158);
  a160=(a157-a018);
  a160=(a007*a160);
  a161=(a160/a158);
  a162=casadi_sq(a106);
  a162=(a162*a150);
  a162=(a162+a155);
  a162=(a007*a162);
  a155=3.0769230769230771e-01;
  a155=(a155*a002);
  a155=(a028+a155);
  a155=(a026*a155);
  a163=sin(a155);
  a163=(a027*a163);
  a163=(a147+a163);
  a163=(a015*a163);
  a155=cos(a155);
  a155=(a155+a018);
  a155=(a025*a155);
  a155=(a032-a155);
  a155=(a155+a149);
  a155=(a031*a155);
  a163=(a163+a155);
  a162=(a162-a163);
  a148=(a161*a148);
  a148=(a162-a148);
  a160=(a160*a161);
  a160=(a007-a160);
  a148=(a148/a160);
  a163=(a161*a148);
  a159=(a159-a163);
  a163=(a146*a159);
  a127=(a127+a163);
  a127=(a003+a127);
  a163=(a141*a127);
  a004=(a004+a163);
  a163=-1.5216094966251609e-01;
  a163=(a163*a002);
  a155=4.7766253643826434e-01;
  a155=(a155*a002);
  a149=(a155*a021);
  a164=-2.4881146199716677e+00;
  a164=(a164*a002);
  a165=(a164*a079);
  a149=(a149+a165);
  a165=-5.9029082683684297e-01;
  a165=(a165*a002);
  a166=(a165*a096);
  a149=(a149+a166);
  a166=2.1230051448181193e+01;
  a166=(a166*a002);
  a167=(a166*a116);
  a149=(a149+a167);
  a167=1.5279233632882423e+01;
  a167=(a167*a002);
  a168=(a167*a137);
  a149=(a149+a168);
  a168=-3.3288210968984863e+01;
  a168=(a168*a002);
  a169=(a168*a159);
  a149=(a149+a169);
  a169=-2.0331201708508627e-02;
  a169=(a169*a002);
  a170=(a133*a009);
  a171=(a142*a067);
  a170=(a170+a171);
  a171=(a143*a085);
  a170=(a170+a171);
  a171=(a144*a105);
  a170=(a170+a171);
  a171=(a145*a126);
  a170=(a170+a171);
  a171=(a146*a148);
  a170=(a170+a171);
  a170=(a008+a170);
  a171=(a007*a170);
  a172=(a133*a008);
  a173=(a142*a034);
  a172=(a172+a173);
  a173=(a143*a068);
  a172=(a172+a173);
  a173=(a144*a104);
  a172=(a172+a173);
  a173=(a145*a125);
  a172=(a172+a173);
  a173=(a146*a147);
  a172=(a172+a173);
  a172=(a010+a172);
  a173=sin(a172);
  a171=(a171*a173);
  a174=(2.*a127);
  a175=(a170-a174);
  a171=(a171*a175);
  a175=(a133*a003);
  a176=(a142*a070);
  a175=(a175+a176);
  a176=(a143*a088);
  a175=(a175+a176);
  a176=(a144*a030);
  a175=(a175+a176);
  a176=(a145*a086);
  a175=(a175+a176);
  a176=(a146*a106);
  a175=(a175+a176);
  a175=(a000+a175);
  a176=sin(a175);
  a177=(a175-a172);
  a178=sin(a177);
  a179=(a176-a178);
  a179=(a007*a179);
  a171=(a171+a179);
  a171=(a171+a176);
  a180=cos(a172);
  a181=(a018-a180);
  a181=(a017*a181);
  a181=(a181+a018);
  a182=(a171/a181);
  a183=(a180-a018);
  a183=(a007*a183);
  a184=(a183/a181);
  a185=casadi_sq(a127);
  a185=(a185*a173);
  a185=(a185+a178);
  a185=(a007*a185);
  a178=6.5128205128205130e-01;
  a178=(a178*a002);
  a178=(a028+a178);
  a178=(a026*a178);
  a186=sin(a178);
  a186=(a027*a186);
  a186=(a170+a186);
  a186=(a015*a186);
  a178=cos(a178);
  a178=(a178+a018);
  a178=(a025*a178);
  a178=(a032-a178);
  a178=(a178+a172);
  a178=(a031*a178);
  a186=(a186+a178);
  a185=(a185-a186);
  a171=(a184*a171);
  a171=(a185-a171);
  a183=(a183*a184);
  a183=(a007-a183);
  a171=(a171/a183);
  a186=(a184*a171);
  a182=(a182-a186);
  a186=(a169*a182);
  a149=(a149+a186);
  a149=(a003+a149);
  a186=(a163*a149);
  a004=(a004+a186);
  a186=2.0136540080403034e-01;
  a186=(a186*a002);
  a178=-9.3714243008598730e-01;
  a178=(a178*a002);
  a172=(a178*a021);
  a187=5.1863724288440638e+00;
  a187=(a187*a002);
  a188=(a187*a079);
  a172=(a172+a188);
  a188=1.0914373489967295e+00;
  a188=(a188*a002);
  a189=(a188*a096);
  a172=(a172+a189);
  a189=-8.1497870107469268e+00;
  a189=(a189*a002);
  a190=(a189*a116);
  a172=(a172+a190);
  a190=-1.8520065659996959e+01;
  a190=(a190*a002);
  a191=(a190*a137);
  a172=(a172+a191);
  a191=2.2739487099350505e+01;
  a191=(a191*a002);
  a192=(a191*a159);
  a172=(a172+a192);
  a192=2.4936055526796523e+00;
  a192=(a192*a002);
  a193=(a192*a182);
  a172=(a172+a193);
  a193=-3.0467644718982196e+00;
  a193=(a193*a002);
  a194=(a155*a009);
  a195=(a164*a067);
  a194=(a194+a195);
  a195=(a165*a085);
  a194=(a194+a195);
  a195=(a166*a105);
  a194=(a194+a195);
  a195=(a167*a126);
  a194=(a194+a195);
  a195=(a168*a148);
  a194=(a194+a195);
  a195=(a169*a171);
  a194=(a194+a195);
  a194=(a008+a194);
  a195=(a007*a194);
  a196=(a155*a008);
  a197=(a164*a034);
  a196=(a196+a197);
  a197=(a165*a068);
  a196=(a196+a197);
  a197=(a166*a104);
  a196=(a196+a197);
  a197=(a167*a125);
  a196=(a196+a197);
  a197=(a168*a147);
  a196=(a196+a197);
  a197=(a169*a170);
  a196=(a196+a197);
  a196=(a010+a196);
  a197=sin(a196);
  a195=(a195*a197);
  a198=(2.*a149);
  a199=(a194-a198);
  a195=(a195*a199);
  a199=(a155*a003);
  a200=(a164*a070);
  a199=(a199+a200);
  a200=(a165*a088);
  a199=(a199+a200);
  a200=(a166*a030);
  a199=(a199+a200);
  a200=(a167*a086);
  a199=(a199+a200);
  a200=(a168*a106);
  a199=(a199+a200);
  a200=(a169*a127);
  a199=(a199+a200);
  a199=(a000+a199);
  a200=sin(a199);
  a201=(a199-a196);
  a202=sin(a201);
  a203=(a200-a202);
  a203=(a007*a203);
  a195=(a195+a203);
  a195=(a195+a200);
  a204=cos(a196);
  a205=(a018-a204);
  a205=(a017*a205);
  a205=(a205+a018);
  a206=(a195/a205);
  a207=(a204-a018);
  a207=(a007*a207);
  a208=(a207/a205);
  a209=casadi_sq(a149);
  a209=(a209*a197);
  a209=(a209+a202);
  a209=(a007*a209);
  a202=5.9999999999999998e-01;
  a202=(a202*a002);
  a202=(a028+a202);
  a202=(a026*a202);
  a210=sin(a202);
  a210=(a027*a210);
  a210=(a194+a210);
  a210=(a015*a210);
  a202=cos(a202);
  a202=(a202+a018);
  a202=(a025*a202);
  a202=(a032-a202);
  a202=(a202+a196);
  a202=(a031*a202);
  a210=(a210+a202);
  a209=(a209-a210);
  a195=(a208*a195);
  a195=(a209-a195);
  a207=(a207*a208);
  a207=(a007-a207);
  a195=(a195/a207);
  a210=(a208*a195);
  a206=(a206-a210);
  a210=(a193*a206);
  a172=(a172+a210);
  a172=(a003+a172);
  a210=(a186*a172);
  a004=(a004+a210);
  a210=4.4710615727772587e-02;
  a210=(a210*a002);
  a202=2.2733101475165380e+00;
  a202=(a202*a002);
  a196=(a202*a021);
  a211=-1.0534495466737249e+01;
  a211=(a211*a002);
  a079=(a211*a079);
  a196=(a196+a079);
  a079=-2.0008720582248625e+00;
  a079=(a079*a002);
  a096=(a079*a096);
  a196=(a196+a096);
  a096=-1.7958931863118799e+01;
  a096=(a096*a002);
  a212=(a096*a116);
  a196=(a196+a212);
  a212=2.7948884529419960e+01;
  a212=(a212*a002);
  a213=(a212*a137);
  a196=(a196+a213);
  a213=-2.8589982771350235e+00;
  a213=(a213*a002);
  a214=(a213*a159);
  a196=(a196+a214);
  a214=-8.8728569335306293e+00;
  a214=(a214*a002);
  a215=(a214*a182);
  a196=(a196+a215);
  a215=1.2360567175794303e+01;
  a215=(a215*a002);
  a216=(a215*a206);
  a196=(a196+a216);
  a216=6.4339274601576357e-01;
  a216=(a216*a002);
  a217=(a178*a009);
  a218=(a187*a067);
  a217=(a217+a218);
  a218=(a188*a085);
  a217=(a217+a218);
  a218=(a189*a105);
  a217=(a217+a218);
  a218=(a190*a126);
  a217=(a217+a218);
  a218=(a191*a148);
  a217=(a217+a218);
  a218=(a192*a171);
  a217=(a217+a218);
  a218=(a193*a195);
  a217=(a217+a218);
  a217=(a008+a217);
  a218=(a007*a217);
  a219=(a178*a008);
  a220=(a187*a034);
  a219=(a219+a220);
  a220=(a188*a068);
  a219=(a219+a220);
  a220=(a189*a104);
  a219=(a219+a220);
  a220=(a190*a125);
  a219=(a219+a220);
  a220=(a191*a147);
  a219=(a219+a220);
  a220=(a192*a170);
  a219=(a219+a220);
  a220=(a193*a194);
  a219=(a219+a220);
  a219=(a010+a219);
  a220=sin(a219);
  a218=(a218*a220);
  a221=(2.*a172);
  a222=(a217-a221);
  a218=(a218*a222);
  a222=(a178*a003);
  a223=(a187*a070);
  a222=(a222+a223);
  a223=(a188*a088);
  a222=(a222+a223);
  a223=(a189*a030);
  a222=(a222+a223);
  a223=(a190*a086);
  a222=(a222+a223);
  a223=(a191*a106);
  a222=(a222+a223);
  a223=(a192*a127);
  a222=(a222+a223);
  a223=(a193*a149);
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
  a232=casadi_sq(a172);
  a232=(a232*a220);
  a232=(a232+a225);
  a232=(a007*a232);
  a225=8.5714285714285710e-01;
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
  a218=(a231*a218);
  a218=(a232-a218);
  a230=(a230*a231);
  a230=(a007-a230);
  a218=(a218/a230);
  a233=(a231*a218);
  a229=(a229-a233);
  a233=(a216*a229);
  a196=(a196+a233);
  a196=(a003+a196);
  a233=(a210*a196);
  a004=(a004+a233);
  a004=(a000+a004);
  if (res[0]!=0) res[0][0]=a004;
  a004=(a001*a008);
  a233=(a005*a104);
  a004=(a004+a233);
  a233=(a100*a125);
  a004=(a004+a233);
  a233=(a120*a147);
  a004=(a004+a233);
  a233=(a141*a170);
  a004=(a004+a233);
  a233=(a163*a194);
  a004=(a004+a233);
  a233=(a186*a217);
  a004=(a004+a233);
  a233=(a202*a009);
  a067=(a211*a067);
  a233=(a233+a067);
  a085=(a079*a085);
  a233=(a233+a085);
  a085=(a096*a105);
  a233=(a233+a085);
  a085=(a212*a126);
  a233=(a233+a085);
  a085=(a213*a148);
  a233=(a233+a085);
  a085=(a214*a171);
  a233=(a233+a085);
  a085=(a215*a195);
  a233=(a233+a085);
  a085=(a216*a218);
  a233=(a233+a085);
  a233=(a008+a233);
  a085=(a210*a233);
  a004=(a004+a085);
  a004=(a010+a004);
  if (res[0]!=0) res[0][1]=a004;
  a021=(a001*a021);
  a116=(a005*a116);
  a021=(a021+a116);
  a137=(a100*a137);
  a021=(a021+a137);
  a159=(a120*a159);
  a021=(a021+a159);
  a182=(a141*a182);
  a021=(a021+a182);
  a206=(a163*a206);
  a021=(a021+a206);
  a229=(a186*a229);
  a021=(a021+a229);
  a229=(a007*a233);
  a206=(a202*a008);
  a182=(a211*a034);
  a206=(a206+a182);
  a182=(a079*a068);
  a206=(a206+a182);
  a182=(a096*a104);
  a206=(a206+a182);
  a182=(a212*a125);
  a206=(a206+a182);
  a182=(a213*a147);
  a206=(a206+a182);
  a182=(a214*a170);
  a206=(a206+a182);
  a182=(a215*a194);
  a206=(a206+a182);
  a182=(a216*a217);
  a206=(a206+a182);
  a010=(a010+a206);
  a206=sin(a010);
  a229=(a229*a206);
  a182=(2.*a196);
  a159=(a233-a182);
  a229=(a229*a159);
  a159=(a202*a003);
  a137=(a211*a070);
  a159=(a159+a137);
  a137=(a079*a088);
  a159=(a159+a137);
  a137=(a096*a030);
  a159=(a159+a137);
  a137=(a212*a086);
  a159=(a159+a137);
  a137=(a213*a106);
  a159=(a159+a137);
  a137=(a214*a127);
  a159=(a159+a137);
  a137=(a215*a149);
  a159=(a159+a137);
  a137=(a216*a172);
  a159=(a159+a137);
  a159=(a000+a159);
  a137=sin(a159);
  a116=(a159-a010);
  a004=sin(a116);
  a085=(a137-a004);
  a085=(a007*a085);
  a229=(a229+a085);
  a229=(a229+a137);
  a067=cos(a010);
  a225=(a018-a067);
  a225=(a017*a225);
  a225=(a225+a018);
  a219=(a229/a225);
  a234=(a067-a018);
  a234=(a007*a234);
  a235=(a234/a225);
  a236=casadi_sq(a196);
  a236=(a236*a206);
  a236=(a236+a004);
  a236=(a007*a236);
  a028=(a028+a002);
  a026=(a026*a028);
  a028=sin(a026);
  a027=(a027*a028);
  a027=(a233+a027);
  a027=(a015*a027);
  a026=cos(a026);
  a026=(a026+a018);
  a025=(a025*a026);
  a032=(a032-a025);
  a032=(a032+a010);
  a032=(a031*a032);
  a027=(a027+a032);
  a236=(a236-a027);
  a229=(a235*a229);
  a229=(a236-a229);
  a234=(a234*a235);
  a234=(a007-a234);
  a229=(a229/a234);
  a027=(a235*a229);
  a219=(a219-a027);
  a219=(a210*a219);
  a021=(a021+a219);
  a021=(a003+a021);
  if (res[0]!=0) res[0][2]=a021;
  a009=(a001*a009);
  a105=(a005*a105);
  a009=(a009+a105);
  a126=(a100*a126);
  a009=(a009+a126);
  a148=(a120*a148);
  a009=(a009+a148);
  a171=(a141*a171);
  a009=(a009+a171);
  a195=(a163*a195);
  a009=(a009+a195);
  a218=(a186*a218);
  a009=(a009+a218);
  a229=(a210*a229);
  a009=(a009+a229);
  a009=(a008+a009);
  if (res[0]!=0) res[0][3]=a009;
  a009=arg[0]? arg[0][4] : 0;
  a229=arg[0]? arg[0][6] : 0;
  a218=(a001*a229);
  a000=cos(a000);
  a014=cos(a014);
  a195=(a000-a014);
  a195=(a007*a195);
  a195=(a195+a000);
  a000=(a195/a020);
  a171=(a007*a014);
  a195=(a023*a195);
  a171=(a171-a195);
  a171=(a171/a022);
  a195=(a023*a171);
  a000=(a000-a195);
  a195=(a000*a009);
  a148=(a007*a011);
  a012=(a012-a008);
  a012=(a008*a012);
  a148=(a148*a012);
  a016=(a016-a148);
  a016=(a016+a013);
  a013=(a023*a016);
  a024=(a024-a013);
  a024=(a024/a022);
  a013=(a024*a011);
  a016=(a016/a020);
  a024=(a023*a024);
  a016=(a016-a024);
  a024=(2.*a016);
  a024=(a024*a011);
  a013=(a013-a024);
  a013=(a013+a014);
  a012=(a019*a012);
  a013=(a013-a012);
  a013=(a007*a013);
  a012=(a013/a020);
  a016=(a016*a011);
  a016=(a016-a014);
  a019=(a019*a003);
  a019=(a019*a003);
  a016=(a016+a019);
  a016=(a007*a016);
  a016=(a016-a031);
  a013=(a023*a013);
  a016=(a016-a013);
  a016=(a016/a022);
  a013=(a023*a016);
  a012=(a012-a013);
  a013=arg[0]? arg[0][5] : 0;
  a019=(a012*a013);
  a195=(a195+a019);
  a019=-2.;
  a019=(a019*a007);
  a014=(a019*a008);
  a014=(a014*a011);
  a024=(a014/a020);
  a148=(a017*a003);
  a148=(a148*a011);
  a014=(a023*a014);
  a148=(a148-a014);
  a148=(a148/a022);
  a014=(a023*a148);
  a024=(a024-a014);
  a014=(a024*a229);
  a011=(a017*a011);
  a008=(a008-a003);
  a011=(a011*a008);
  a020=(a011/a020);
  a011=(a023*a011);
  a011=(a015+a011);
  a011=(a011/a022);
  a023=(a023*a011);
  a020=(a020+a023);
  a023=arg[0]? arg[0][7] : 0;
  a022=(a020*a023);
  a014=(a014+a022);
  a195=(a195+a014);
  a014=(a006*a195);
  a072=cos(a072);
  a074=cos(a074);
  a022=(a072-a074);
  a022=(a007*a022);
  a022=(a022+a072);
  a072=(a022/a078);
  a008=(a007*a074);
  a022=(a081*a022);
  a008=(a008-a022);
  a008=(a008/a080);
  a022=(a081*a008);
  a072=(a072-a022);
  a022=(a033*a229);
  a003=(a036*a195);
  a046=cos(a046);
  a048=cos(a048);
  a126=(a046-a048);
  a126=(a007*a126);
  a126=(a126+a046);
  a046=(a126/a052);
  a105=(a007*a048);
  a126=(a055*a126);
  a105=(a105-a126);
  a105=(a105/a054);
  a126=(a055*a105);
  a046=(a046-a126);
  a126=(a039*a229);
  a126=(a009+a126);
  a021=(a046*a126);
  a219=(a007*a043);
  a045=(a045-a040);
  a045=(a040*a045);
  a219=(a219*a045);
  a050=(a050-a219);
  a050=(a050+a047);
  a047=(a055*a050);
  a056=(a056-a047);
  a056=(a056/a054);
  a047=(a056*a043);
  a050=(a050/a052);
  a056=(a055*a056);
  a050=(a050-a056);
  a056=(2.*a050);
  a056=(a056*a043);
  a047=(a047-a056);
  a047=(a047+a048);
  a045=(a051*a045);
  a047=(a047-a045);
  a047=(a007*a047);
  a045=(a047/a052);
  a050=(a050*a043);
  a050=(a050-a048);
  a051=(a051*a044);
  a051=(a051*a044);
  a050=(a050+a051);
  a050=(a007*a050);
  a050=(a050-a031);
  a047=(a055*a047);
  a050=(a050-a047);
  a050=(a050/a054);
  a047=(a055*a050);
  a045=(a045-a047);
  a047=(a039*a023);
  a047=(a013+a047);
  a051=(a045*a047);
  a021=(a021+a051);
  a051=(a019*a040);
  a051=(a051*a043);
  a048=(a051/a052);
  a056=(a017*a044);
  a056=(a056*a043);
  a051=(a055*a051);
  a056=(a056-a051);
  a056=(a056/a054);
  a051=(a055*a056);
  a048=(a048-a051);
  a051=(a039*a195);
  a051=(a229+a051);
  a219=(a048*a051);
  a043=(a017*a043);
  a040=(a040-a044);
  a043=(a043*a040);
  a052=(a043/a052);
  a043=(a055*a043);
  a043=(a015+a043);
  a043=(a043/a054);
  a055=(a055*a043);
  a052=(a052+a055);
  a055=(a171*a009);
  a054=(a016*a013);
  a055=(a055+a054);
  a054=(a148*a229);
  a040=(a011*a023);
  a054=(a054-a040);
  a055=(a055+a054);
  a054=(a039*a055);
  a054=(a023+a054);
  a040=(a052*a054);
  a219=(a219+a040);
  a021=(a021+a219);
  a021=(a038*a021);
  a003=(a003+a021);
  a003=(a229+a003);
  a021=(a035*a003);
  a022=(a022+a021);
  a022=(a009+a022);
  a021=(a072*a022);
  a219=(a007*a069);
  a071=(a071-a034);
  a071=(a034*a071);
  a219=(a219*a071);
  a076=(a076-a219);
  a076=(a076+a073);
  a073=(a081*a076);
  a082=(a082-a073);
  a082=(a082/a080);
  a073=(a082*a069);
  a076=(a076/a078);
  a082=(a081*a082);
  a076=(a076-a082);
  a082=(2.*a076);
  a082=(a082*a069);
  a073=(a073-a082);
  a073=(a073+a074);
  a071=(a077*a071);
  a073=(a073-a071);
  a073=(a007*a073);
  a071=(a073/a078);
  a076=(a076*a069);
  a076=(a076-a074);
  a077=(a077*a070);
  a077=(a077*a070);
  a076=(a076+a077);
  a076=(a007*a076);
  a076=(a076-a031);
  a073=(a081*a073);
  a076=(a076-a073);
  a076=(a076/a080);
  a073=(a081*a076);
  a071=(a071-a073);
  a073=(a033*a023);
  a077=(a036*a055);
  a126=(a105*a126);
  a047=(a050*a047);
  a126=(a126+a047);
  a047=(a056*a051);
  a074=(a043*a054);
  a047=(a047-a074);
  a126=(a126+a047);
  a126=(a038*a126);
  a077=(a077+a126);
  a077=(a023+a077);
  a126=(a035*a077);
  a073=(a073+a126);
  a073=(a013+a073);
  a126=(a071*a073);
  a021=(a021+a126);
  a126=(a019*a034);
  a126=(a126*a069);
  a047=(a126/a078);
  a074=(a017*a070);
  a074=(a074*a069);
  a126=(a081*a126);
  a074=(a074-a126);
  a074=(a074/a080);
  a126=(a081*a074);
  a047=(a047-a126);
  a126=(a033*a195);
  a042=cos(a042);
  a058=cos(a058);
  a082=(a042-a058);
  a082=(a007*a082);
  a082=(a082+a042);
  a042=(a082/a041);
  a219=(a007*a058);
  a082=(a062*a082);
  a219=(a219-a082);
  a219=(a219/a061);
  a082=(a062*a219);
  a042=(a042-a082);
  a082=(a036*a229);
  a051=(a038*a051);
  a082=(a082+a051);
  a082=(a009+a082);
  a051=(a042*a082);
  a040=(a007*a049);
  a064=(a064-a060);
  a064=(a060*a064);
  a040=(a040*a064);
  a059=(a059-a040);
  a059=(a059+a065);
  a065=(a062*a059);
  a053=(a053-a065);
  a053=(a053/a061);
  a065=(a053*a049);
  a059=(a059/a041);
  a053=(a062*a053);
  a059=(a059-a053);
  a053=(2.*a059);
  a053=(a053*a049);
  a065=(a065-a053);
  a065=(a065+a058);
  a064=(a057*a064);
  a065=(a065-a064);
  a065=(a007*a065);
  a064=(a065/a041);
  a059=(a059*a049);
  a059=(a059-a058);
  a057=(a057*a037);
  a057=(a057*a037);
  a059=(a059+a057);
  a059=(a007*a059);
  a059=(a059-a031);
  a065=(a062*a065);
  a059=(a059-a065);
  a059=(a059/a061);
  a065=(a062*a059);
  a064=(a064-a065);
  a065=(a036*a023);
  a054=(a038*a054);
  a065=(a065+a054);
  a065=(a013+a065);
  a054=(a064*a065);
  a051=(a051+a054);
  a054=(a019*a060);
  a054=(a054*a049);
  a057=(a054/a041);
  a058=(a017*a037);
  a058=(a058*a049);
  a054=(a062*a054);
  a058=(a058-a054);
  a058=(a058/a061);
  a054=(a062*a058);
  a057=(a057-a054);
  a054=(a057*a003);
  a049=(a017*a049);
  a060=(a060-a037);
  a049=(a049*a060);
  a041=(a049/a041);
  a049=(a062*a049);
  a049=(a015+a049);
  a049=(a049/a061);
  a062=(a062*a049);
  a041=(a041+a062);
  a062=(a041*a077);
  a054=(a054+a062);
  a051=(a051+a054);
  a054=(a035*a051);
  a126=(a126+a054);
  a126=(a229+a126);
  a054=(a047*a126);
  a069=(a017*a069);
  a034=(a034-a070);
  a069=(a069*a034);
  a078=(a069/a078);
  a069=(a081*a069);
  a069=(a015+a069);
  a069=(a069/a080);
  a081=(a081*a069);
  a078=(a078+a081);
  a081=(a033*a055);
  a082=(a219*a082);
  a065=(a059*a065);
  a082=(a082+a065);
  a065=(a058*a003);
  a080=(a049*a077);
  a065=(a065-a080);
  a082=(a082+a065);
  a065=(a035*a082);
  a081=(a081+a065);
  a081=(a023+a081);
  a065=(a078*a081);
  a054=(a054+a065);
  a021=(a021+a054);
  a054=(a029*a021);
  a014=(a014+a054);
  a089=cos(a089);
  a091=cos(a091);
  a054=(a089-a091);
  a054=(a007*a054);
  a054=(a054+a089);
  a089=(a054/a095);
  a065=(a007*a091);
  a054=(a098*a054);
  a065=(a065-a054);
  a065=(a065/a097);
  a054=(a098*a065);
  a089=(a089-a054);
  a054=(a075*a229);
  a003=(a084*a003);
  a054=(a054+a003);
  a003=(a066*a126);
  a054=(a054+a003);
  a054=(a009+a054);
  a003=(a089*a054);
  a080=(a007*a087);
  a063=(a063-a068);
  a063=(a068*a063);
  a080=(a080*a063);
  a093=(a093-a080);
  a093=(a093+a090);
  a090=(a098*a093);
  a099=(a099-a090);
  a099=(a099/a097);
  a090=(a099*a087);
  a093=(a093/a095);
  a099=(a098*a099);
  a093=(a093-a099);
  a099=(2.*a093);
  a099=(a099*a087);
  a090=(a090-a099);
  a090=(a090+a091);
  a063=(a094*a063);
  a090=(a090-a063);
  a090=(a007*a090);
  a063=(a090/a095);
  a093=(a093*a087);
  a093=(a093-a091);
  a094=(a094*a088);
  a094=(a094*a088);
  a093=(a093+a094);
  a093=(a007*a093);
  a093=(a093-a031);
  a090=(a098*a090);
  a093=(a093-a090);
  a093=(a093/a097);
  a090=(a098*a093);
  a063=(a063-a090);
  a090=(a075*a023);
  a077=(a084*a077);
  a090=(a090+a077);
  a077=(a066*a081);
  a090=(a090+a077);
  a090=(a013+a090);
  a077=(a063*a090);
  a003=(a003+a077);
  a077=(a019*a068);
  a077=(a077*a087);
  a094=(a077/a095);
  a091=(a017*a088);
  a091=(a091*a087);
  a077=(a098*a077);
  a091=(a091-a077);
  a091=(a091/a097);
  a077=(a098*a091);
  a094=(a094-a077);
  a077=(a075*a195);
  a051=(a084*a051);
  a077=(a077+a051);
  a051=(a066*a021);
  a077=(a077+a051);
  a077=(a229+a077);
  a051=(a094*a077);
  a087=(a017*a087);
  a068=(a068-a088);
  a087=(a087*a068);
  a095=(a087/a095);
  a087=(a098*a087);
  a087=(a015+a087);
  a087=(a087/a097);
  a098=(a098*a087);
  a095=(a095+a098);
  a098=(a075*a055);
  a082=(a084*a082);
  a098=(a098+a082);
  a022=(a008*a022);
  a073=(a076*a073);
  a022=(a022+a073);
  a073=(a074*a126);
  a082=(a069*a081);
  a073=(a073-a082);
  a022=(a022+a073);
  a073=(a066*a022);
  a098=(a098+a073);
  a098=(a023+a098);
  a073=(a095*a098);
  a051=(a051+a073);
  a003=(a003+a051);
  a051=(a083*a003);
  a014=(a014+a051);
  a014=(a229+a014);
  a051=(a005*a014);
  a218=(a218+a051);
  a051=(a092*a195);
  a073=(a101*a021);
  a051=(a051+a073);
  a073=(a102*a003);
  a051=(a051+a073);
  a109=cos(a109);
  a111=cos(a111);
  a073=(a109-a111);
  a073=(a007*a073);
  a073=(a073+a109);
  a109=(a073/a115);
  a082=(a007*a111);
  a073=(a118*a073);
  a082=(a082-a073);
  a082=(a082/a117);
  a073=(a118*a082);
  a109=(a109-a073);
  a073=(a006*a229);
  a097=(a029*a126);
  a073=(a073+a097);
  a097=(a083*a077);
  a073=(a073+a097);
  a073=(a009+a073);
  a097=(a109*a073);
  a068=(a007*a107);
  a108=(a108-a104);
  a108=(a104*a108);
  a068=(a068*a108);
  a113=(a113-a068);
  a113=(a113+a110);
  a110=(a118*a113);
  a119=(a119-a110);
  a119=(a119/a117);
  a110=(a119*a107);
  a113=(a113/a115);
  a119=(a118*a119);
  a113=(a113-a119);
  a119=(2.*a113);
  a119=(a119*a107);
  a110=(a110-a119);
  a110=(a110+a111);
  a108=(a114*a108);
  a110=(a110-a108);
  a110=(a007*a110);
  a108=(a110/a115);
  a113=(a113*a107);
  a113=(a113-a111);
  a114=(a114*a030);
  a114=(a114*a030);
  a113=(a113+a114);
  a113=(a007*a113);
  a113=(a113-a031);
  a110=(a118*a110);
  a113=(a113-a110);
  a113=(a113/a117);
  a110=(a118*a113);
  a108=(a108-a110);
  a110=(a006*a023);
  a114=(a029*a081);
  a110=(a110+a114);
  a114=(a083*a098);
  a110=(a110+a114);
  a110=(a013+a110);
  a114=(a108*a110);
  a097=(a097+a114);
  a114=(a019*a104);
  a114=(a114*a107);
  a111=(a114/a115);
  a119=(a017*a030);
  a119=(a119*a107);
  a114=(a118*a114);
  a119=(a119-a114);
  a119=(a119/a117);
  a114=(a118*a119);
  a111=(a111-a114);
  a114=(a111*a014);
  a107=(a017*a107);
  a104=(a104-a030);
  a107=(a107*a104);
  a115=(a107/a115);
  a107=(a118*a107);
  a107=(a015+a107);
  a107=(a107/a117);
  a118=(a118*a107);
  a115=(a115+a118);
  a118=(a006*a055);
  a117=(a029*a022);
  a118=(a118+a117);
  a054=(a065*a054);
  a090=(a093*a090);
  a054=(a054+a090);
  a090=(a091*a077);
  a117=(a087*a098);
  a090=(a090-a117);
  a054=(a054+a090);
  a090=(a083*a054);
  a118=(a118+a090);
  a118=(a023+a118);
  a090=(a115*a118);
  a114=(a114+a090);
  a097=(a097+a114);
  a114=(a103*a097);
  a051=(a051+a114);
  a051=(a229+a051);
  a114=(a100*a051);
  a218=(a218+a114);
  a114=(a112*a195);
  a090=(a121*a021);
  a114=(a114+a090);
  a090=(a122*a003);
  a114=(a114+a090);
  a090=(a123*a097);
  a114=(a114+a090);
  a130=cos(a130);
  a132=cos(a132);
  a090=(a130-a132);
  a090=(a007*a090);
  a090=(a090+a130);
  a130=(a090/a136);
  a117=(a007*a132);
  a090=(a139*a090);
  a117=(a117-a090);
  a117=(a117/a138);
  a090=(a139*a117);
  a130=(a130-a090);
  a090=(a092*a229);
  a104=(a101*a126);
  a090=(a090+a104);
  a104=(a102*a077);
  a090=(a090+a104);
  a104=(a103*a014);
  a090=(a090+a104);
  a090=(a009+a090);
  a104=(a130*a090);
  a030=(a007*a128);
  a129=(a129-a125);
  a129=(a125*a129);
  a030=(a030*a129);
  a134=(a134-a030);
  a134=(a134+a131);
  a131=(a139*a134);
  a140=(a140-a131);
  a140=(a140/a138);
  a131=(a140*a128);
  a134=(a134/a136);
  a140=(a139*a140);
  a134=(a134-a140);
  a140=(2.*a134);
  a140=(a140*a128);
  a131=(a131-a140);
  a131=(a131+a132);
  a129=(a135*a129);
  a131=(a131-a129);
  a131=(a007*a131);
  a129=(a131/a136);
  a134=(a134*a128);
  a134=(a134-a132);
  a135=(a135*a086);
  a135=(a135*a086);
  a134=(a134+a135);
  a134=(a007*a134);
  a134=(a134-a031);
  a131=(a139*a131);
  a134=(a134-a131);
  a134=(a134/a138);
  a131=(a139*a134);
  a129=(a129-a131);
  a131=(a092*a023);
  a135=(a101*a081);
  a131=(a131+a135);
  a135=(a102*a098);
  a131=(a131+a135);
  a135=(a103*a118);
  a131=(a131+a135);
  a131=(a013+a131);
  a135=(a129*a131);
  a104=(a104+a135);
  a135=(a019*a125);
  a135=(a135*a128);
  a132=(a135/a136);
  a140=(a017*a086);
  a140=(a140*a128);
  a135=(a139*a135);
  a140=(a140-a135);
  a140=(a140/a138);
  a135=(a139*a140);
  a132=(a132-a135);
  a135=(a132*a051);
  a128=(a017*a128);
  a125=(a125-a086);
  a128=(a128*a125);
  a136=(a128/a136);
  a128=(a139*a128);
  a128=(a015+a128);
  a128=(a128/a138);
  a139=(a139*a128);
  a136=(a136+a139);
  a139=(a092*a055);
  a138=(a101*a022);
  a139=(a139+a138);
  a138=(a102*a054);
  a139=(a139+a138);
  a073=(a082*a073);
  a110=(a113*a110);
  a073=(a073+a110);
  a110=(a119*a014);
  a138=(a107*a118);
  a110=(a110-a138);
  a073=(a073+a110);
  a110=(a103*a073);
  a139=(a139+a110);
  a139=(a023+a139);
  a110=(a136*a139);
  a135=(a135+a110);
  a104=(a104+a135);
  a135=(a124*a104);
  a114=(a114+a135);
  a114=(a229+a114);
  a135=(a120*a114);
  a218=(a218+a135);
  a135=(a133*a195);
  a110=(a142*a021);
  a135=(a135+a110);
  a110=(a143*a003);
  a135=(a135+a110);
  a110=(a144*a097);
  a135=(a135+a110);
  a110=(a145*a104);
  a135=(a135+a110);
  a152=cos(a152);
  a154=cos(a154);
  a110=(a152-a154);
  a110=(a007*a110);
  a110=(a110+a152);
  a152=(a110/a158);
  a138=(a007*a154);
  a110=(a161*a110);
  a138=(a138-a110);
  a138=(a138/a160);
  a110=(a161*a138);
  a152=(a152-a110);
  a110=(a112*a229);
  a125=(a121*a126);
  a110=(a110+a125);
  a125=(a122*a077);
  a110=(a110+a125);
  a125=(a123*a014);
  a110=(a110+a125);
  a125=(a124*a051);
  a110=(a110+a125);
  a110=(a009+a110);
  a125=(a152*a110);
  a086=(a007*a150);
  a151=(a151-a147);
  a151=(a147*a151);
  a086=(a086*a151);
  a156=(a156-a086);
  a156=(a156+a153);
  a153=(a161*a156);
  a162=(a162-a153);
  a162=(a162/a160);
  a153=(a162*a150);
  a156=(a156/a158);
  a162=(a161*a162);
  a156=(a156-a162);
  a162=(2.*a156);
  a162=(a162*a150);
  a153=(a153-a162);
  a153=(a153+a154);
  a151=(a157*a151);
  a153=(a153-a151);
  a153=(a007*a153);
  a151=(a153/a158);
  a156=(a156*a150);
  a156=(a156-a154);
  a157=(a157*a106);
  a157=(a157*a106);
  a156=(a156+a157);
  a156=(a007*a156);
  a156=(a156-a031);
  a153=(a161*a153);
  a156=(a156-a153);
  a156=(a156/a160);
  a153=(a161*a156);
  a151=(a151-a153);
  a153=(a112*a023);
  a157=(a121*a081);
  a153=(a153+a157);
  a157=(a122*a098);
  a153=(a153+a157);
  a157=(a123*a118);
  a153=(a153+a157);
  a157=(a124*a139);
  a153=(a153+a157);
  a153=(a013+a153);
  a157=(a151*a153);
  a125=(a125+a157);
  a157=(a019*a147);
  a157=(a157*a150);
  a154=(a157/a158);
  a162=(a017*a106);
  a162=(a162*a150);
  a157=(a161*a157);
  a162=(a162-a157);
  a162=(a162/a160);
  a157=(a161*a162);
  a154=(a154-a157);
  a157=(a154*a114);
  a150=(a017*a150);
  a147=(a147-a106);
  a150=(a150*a147);
  a158=(a150/a158);
  a150=(a161*a150);
  a150=(a015+a150);
  a150=(a150/a160);
  a161=(a161*a150);
  a158=(a158+a161);
  a161=(a112*a055);
  a160=(a121*a022);
  a161=(a161+a160);
  a160=(a122*a054);
  a161=(a161+a160);
  a160=(a123*a073);
  a161=(a161+a160);
  a090=(a117*a090);
  a131=(a134*a131);
  a090=(a090+a131);
  a131=(a140*a051);
  a160=(a128*a139);
  a131=(a131-a160);
  a090=(a090+a131);
  a131=(a124*a090);
  a161=(a161+a131);
  a161=(a023+a161);
  a131=(a158*a161);
  a157=(a157+a131);
  a125=(a125+a157);
  a157=(a146*a125);
  a135=(a135+a157);
  a135=(a229+a135);
  a157=(a141*a135);
  a218=(a218+a157);
  a157=(a155*a195);
  a131=(a164*a021);
  a157=(a157+a131);
  a131=(a165*a003);
  a157=(a157+a131);
  a131=(a166*a097);
  a157=(a157+a131);
  a131=(a167*a104);
  a157=(a157+a131);
  a131=(a168*a125);
  a157=(a157+a131);
  a175=cos(a175);
  a177=cos(a177);
  a131=(a175-a177);
  a131=(a007*a131);
  a131=(a131+a175);
  a175=(a131/a181);
  a160=(a007*a177);
  a131=(a184*a131);
  a160=(a160-a131);
  a160=(a160/a183);
  a131=(a184*a160);
  a175=(a175-a131);
  a131=(a133*a229);
  a147=(a142*a126);
  a131=(a131+a147);
  a147=(a143*a077);
  a131=(a131+a147);
  a147=(a144*a014);
  a131=(a131+a147);
  a147=(a145*a051);
  a131=(a131+a147);
  a147=(a146*a114);
  a131=(a131+a147);
  a131=(a009+a131);
  a147=(a175*a131);
  a106=(a007*a173);
  a174=(a174-a170);
  a174=(a170*a174);
  a106=(a106*a174);
  a179=(a179-a106);
  a179=(a179+a176);
  a176=(a184*a179);
  a185=(a185-a176);
  a185=(a185/a183);
  a176=(a185*a173);
  a179=(a179/a181);
  a185=(a184*a185);
  a179=(a179-a185);
  a185=(2.*a179);
  a185=(a185*a173);
  a176=(a176-a185);
  a176=(a176+a177);
  a174=(a180*a174);
  a176=(a176-a174);
  a176=(a007*a176);
  a174=(a176/a181);
  a179=(a179*a173);
  a179=(a179-a177);
  a180=(a180*a127);
  a180=(a180*a127);
  a179=(a179+a180);
  a179=(a007*a179);
  a179=(a179-a031);
  a176=(a184*a176);
  a179=(a179-a176);
  a179=(a179/a183);
  a176=(a184*a179);
  a174=(a174-a176);
  a176=(a133*a023);
  a180=(a142*a081);
  a176=(a176+a180);
  a180=(a143*a098);
  a176=(a176+a180);
  a180=(a144*a118);
  a176=(a176+a180);
  a180=(a145*a139);
  a176=(a176+a180);
  a180=(a146*a161);
  a176=(a176+a180);
  a176=(a013+a176);
  a180=(a174*a176);
  a147=(a147+a180);
  a180=(a019*a170);
  a180=(a180*a173);
  a177=(a180/a181);
  a185=(a017*a127);
  a185=(a185*a173);
  a180=(a184*a180);
  a185=(a185-a180);
  a185=(a185/a183);
  a180=(a184*a185);
  a177=(a177-a180);
  a180=(a177*a135);
  a173=(a017*a173);
  a170=(a170-a127);
  a173=(a173*a170);
  a181=(a173/a181);
  a173=(a184*a173);
  a173=(a015+a173);
  a173=(a173/a183);
  a184=(a184*a173);
  a181=(a181+a184);
  a184=(a133*a055);
  a183=(a142*a022);
  a184=(a184+a183);
  a183=(a143*a054);
  a184=(a184+a183);
  a183=(a144*a073);
  a184=(a184+a183);
  a183=(a145*a090);
  a184=(a184+a183);
  a110=(a138*a110);
  a153=(a156*a153);
  a110=(a110+a153);
  a153=(a162*a114);
  a183=(a150*a161);
  a153=(a153-a183);
  a110=(a110+a153);
  a153=(a146*a110);
  a184=(a184+a153);
  a184=(a023+a184);
  a153=(a181*a184);
  a180=(a180+a153);
  a147=(a147+a180);
  a180=(a169*a147);
  a157=(a157+a180);
  a157=(a229+a157);
  a180=(a163*a157);
  a218=(a218+a180);
  a180=(a178*a195);
  a153=(a187*a021);
  a180=(a180+a153);
  a153=(a188*a003);
  a180=(a180+a153);
  a153=(a189*a097);
  a180=(a180+a153);
  a153=(a190*a104);
  a180=(a180+a153);
  a153=(a191*a125);
  a180=(a180+a153);
  a153=(a192*a147);
  a180=(a180+a153);
  a199=cos(a199);
  a201=cos(a201);
  a153=(a199-a201);
  a153=(a007*a153);
  a153=(a153+a199);
  a199=(a153/a205);
  a183=(a007*a201);
  a153=(a208*a153);
  a183=(a183-a153);
  a183=(a183/a207);
  a153=(a208*a183);
  a199=(a199-a153);
  a153=(a155*a229);
  a170=(a164*a126);
  a153=(a153+a170);
  a170=(a165*a077);
  a153=(a153+a170);
  a170=(a166*a014);
  a153=(a153+a170);
  a170=(a167*a051);
  a153=(a153+a170);
  a170=(a168*a114);
  a153=(a153+a170);
  a170=(a169*a135);
  a153=(a153+a170);
  a153=(a009+a153);
  a170=(a199*a153);
  a127=(a007*a197);
  a198=(a198-a194);
  a198=(a194*a198);
  a127=(a127*a198);
  a203=(a203-a127);
  a203=(a203+a200);
  a200=(a208*a203);
  a209=(a209-a200);
  a209=(a209/a207);
  a200=(a209*a197);
  a203=(a203/a205);
  a209=(a208*a209);
  a203=(a203-a209);
  a209=(2.*a203);
  a209=(a209*a197);
  a200=(a200-a209);
  a200=(a200+a201);
  a198=(a204*a198);
  a200=(a200-a198);
  a200=(a007*a200);
  a198=(a200/a205);
  a203=(a203*a197);
  a203=(a203-a201);
  a204=(a204*a149);
  a204=(a204*a149);
  a203=(a203+a204);
  a203=(a007*a203);
  a203=(a203-a031);
  a200=(a208*a200);
  a203=(a203-a200);
  a203=(a203/a207);
  a200=(a208*a203);
  a198=(a198-a200);
  a200=(a155*a023);
  a204=(a164*a081);
  a200=(a200+a204);
  a204=(a165*a098);
  a200=(a200+a204);
  a204=(a166*a118);
  a200=(a200+a204);
  a204=(a167*a139);
  a200=(a200+a204);
  a204=(a168*a161);
  a200=(a200+a204);
  a204=(a169*a184);
  a200=(a200+a204);
  a200=(a013+a200);
  a204=(a198*a200);
  a170=(a170+a204);
  a204=(a019*a194);
  a204=(a204*a197);
  a201=(a204/a205);
  a209=(a017*a149);
  a209=(a209*a197);
  a204=(a208*a204);
  a209=(a209-a204);
  a209=(a209/a207);
  a204=(a208*a209);
  a201=(a201-a204);
  a204=(a201*a157);
  a197=(a017*a197);
  a194=(a194-a149);
  a197=(a197*a194);
  a205=(a197/a205);
  a197=(a208*a197);
  a197=(a015+a197);
  a197=(a197/a207);
  a208=(a208*a197);
  a205=(a205+a208);
  a208=(a155*a055);
  a207=(a164*a022);
  a208=(a208+a207);
  a207=(a165*a054);
  a208=(a208+a207);
  a207=(a166*a073);
  a208=(a208+a207);
  a207=(a167*a090);
  a208=(a208+a207);
  a207=(a168*a110);
  a208=(a208+a207);
  a131=(a160*a131);
  a176=(a179*a176);
  a131=(a131+a176);
  a176=(a185*a135);
  a207=(a173*a184);
  a176=(a176-a207);
  a131=(a131+a176);
  a176=(a169*a131);
  a208=(a208+a176);
  a208=(a023+a208);
  a176=(a205*a208);
  a204=(a204+a176);
  a170=(a170+a204);
  a204=(a193*a170);
  a180=(a180+a204);
  a180=(a229+a180);
  a204=(a186*a180);
  a218=(a218+a204);
  a204=(a202*a195);
  a021=(a211*a021);
  a204=(a204+a021);
  a003=(a079*a003);
  a204=(a204+a003);
  a003=(a096*a097);
  a204=(a204+a003);
  a003=(a212*a104);
  a204=(a204+a003);
  a003=(a213*a125);
  a204=(a204+a003);
  a003=(a214*a147);
  a204=(a204+a003);
  a003=(a215*a170);
  a204=(a204+a003);
  a222=cos(a222);
  a224=cos(a224);
  a003=(a222-a224);
  a003=(a007*a003);
  a003=(a003+a222);
  a222=(a003/a228);
  a021=(a007*a224);
  a003=(a231*a003);
  a021=(a021-a003);
  a021=(a021/a230);
  a003=(a231*a021);
  a222=(a222-a003);
  a003=(a178*a229);
  a176=(a187*a126);
  a003=(a003+a176);
  a176=(a188*a077);
  a003=(a003+a176);
  a176=(a189*a014);
  a003=(a003+a176);
  a176=(a190*a051);
  a003=(a003+a176);
  a176=(a191*a114);
  a003=(a003+a176);
  a176=(a192*a135);
  a003=(a003+a176);
  a176=(a193*a157);
  a003=(a003+a176);
  a003=(a009+a003);
  a176=(a222*a003);
  a207=(a007*a220);
  a221=(a221-a217);
  a221=(a217*a221);
  a207=(a207*a221);
  a226=(a226-a207);
  a226=(a226+a223);
  a223=(a231*a226);
  a232=(a232-a223);
  a232=(a232/a230);
  a223=(a232*a220);
  a226=(a226/a228);
  a232=(a231*a232);
  a226=(a226-a232);
  a232=(2.*a226);
  a232=(a232*a220);
  a223=(a223-a232);
  a223=(a223+a224);
  a221=(a227*a221);
  a223=(a223-a221);
  a223=(a007*a223);
  a221=(a223/a228);
  a226=(a226*a220);
  a226=(a226-a224);
  a227=(a227*a172);
  a227=(a227*a172);
  a226=(a226+a227);
  a226=(a007*a226);
  a226=(a226-a031);
  a223=(a231*a223);
  a226=(a226-a223);
  a226=(a226/a230);
  a223=(a231*a226);
  a221=(a221-a223);
  a223=(a178*a023);
  a227=(a187*a081);
  a223=(a223+a227);
  a227=(a188*a098);
  a223=(a223+a227);
  a227=(a189*a118);
  a223=(a223+a227);
  a227=(a190*a139);
  a223=(a223+a227);
  a227=(a191*a161);
  a223=(a223+a227);
  a227=(a192*a184);
  a223=(a223+a227);
  a227=(a193*a208);
  a223=(a223+a227);
  a223=(a013+a223);
  a227=(a221*a223);
  a176=(a176+a227);
  a227=(a019*a217);
  a227=(a227*a220);
  a224=(a227/a228);
  a232=(a017*a172);
  a232=(a232*a220);
  a227=(a231*a227);
  a232=(a232-a227);
  a232=(a232/a230);
  a227=(a231*a232);
  a224=(a224-a227);
  a227=(a224*a180);
  a220=(a017*a220);
  a217=(a217-a172);
  a220=(a220*a217);
  a228=(a220/a228);
  a220=(a231*a220);
  a220=(a015+a220);
  a220=(a220/a230);
  a231=(a231*a220);
  a228=(a228+a231);
  a231=(a178*a055);
  a230=(a187*a022);
  a231=(a231+a230);
  a230=(a188*a054);
  a231=(a231+a230);
  a230=(a189*a073);
  a231=(a231+a230);
  a230=(a190*a090);
  a231=(a231+a230);
  a230=(a191*a110);
  a231=(a231+a230);
  a230=(a192*a131);
  a231=(a231+a230);
  a153=(a183*a153);
  a200=(a203*a200);
  a153=(a153+a200);
  a200=(a209*a157);
  a230=(a197*a208);
  a200=(a200-a230);
  a153=(a153+a200);
  a200=(a193*a153);
  a231=(a231+a200);
  a231=(a023+a231);
  a200=(a228*a231);
  a227=(a227+a200);
  a176=(a176+a227);
  a227=(a216*a176);
  a204=(a204+a227);
  a204=(a229+a204);
  a227=(a210*a204);
  a218=(a218+a227);
  a218=(a009+a218);
  if (res[0]!=0) res[0][4]=a218;
  a218=(a001*a023);
  a227=(a005*a118);
  a218=(a218+a227);
  a227=(a100*a139);
  a218=(a218+a227);
  a227=(a120*a161);
  a218=(a218+a227);
  a227=(a141*a184);
  a218=(a218+a227);
  a227=(a163*a208);
  a218=(a218+a227);
  a227=(a186*a231);
  a218=(a218+a227);
  a227=(a202*a055);
  a022=(a211*a022);
  a227=(a227+a022);
  a054=(a079*a054);
  a227=(a227+a054);
  a054=(a096*a073);
  a227=(a227+a054);
  a054=(a212*a090);
  a227=(a227+a054);
  a054=(a213*a110);
  a227=(a227+a054);
  a054=(a214*a131);
  a227=(a227+a054);
  a054=(a215*a153);
  a227=(a227+a054);
  a003=(a021*a003);
  a223=(a226*a223);
  a003=(a003+a223);
  a223=(a232*a180);
  a054=(a220*a231);
  a223=(a223-a054);
  a003=(a003+a223);
  a223=(a216*a003);
  a227=(a227+a223);
  a227=(a023+a227);
  a223=(a210*a227);
  a218=(a218+a223);
  a218=(a013+a218);
  if (res[0]!=0) res[0][5]=a218;
  a195=(a001*a195);
  a097=(a005*a097);
  a195=(a195+a097);
  a104=(a100*a104);
  a195=(a195+a104);
  a125=(a120*a125);
  a195=(a195+a125);
  a147=(a141*a147);
  a195=(a195+a147);
  a170=(a163*a170);
  a195=(a195+a170);
  a176=(a186*a176);
  a195=(a195+a176);
  a159=cos(a159);
  a116=cos(a116);
  a176=(a159-a116);
  a176=(a007*a176);
  a176=(a176+a159);
  a159=(a176/a225);
  a170=(a007*a116);
  a176=(a235*a176);
  a170=(a170-a176);
  a170=(a170/a234);
  a176=(a235*a170);
  a159=(a159-a176);
  a176=(a202*a229);
  a126=(a211*a126);
  a176=(a176+a126);
  a077=(a079*a077);
  a176=(a176+a077);
  a014=(a096*a014);
  a176=(a176+a014);
  a051=(a212*a051);
  a176=(a176+a051);
  a114=(a213*a114);
  a176=(a176+a114);
  a135=(a214*a135);
  a176=(a176+a135);
  a157=(a215*a157);
  a176=(a176+a157);
  a180=(a216*a180);
  a176=(a176+a180);
  a009=(a009+a176);
  a176=(a159*a009);
  a180=(a007*a206);
  a182=(a182-a233);
  a182=(a233*a182);
  a180=(a180*a182);
  a085=(a085-a180);
  a085=(a085+a137);
  a137=(a235*a085);
  a236=(a236-a137);
  a236=(a236/a234);
  a137=(a236*a206);
  a085=(a085/a225);
  a236=(a235*a236);
  a085=(a085-a236);
  a236=(2.*a085);
  a236=(a236*a206);
  a137=(a137-a236);
  a137=(a137+a116);
  a182=(a067*a182);
  a137=(a137-a182);
  a137=(a007*a137);
  a182=(a137/a225);
  a085=(a085*a206);
  a085=(a085-a116);
  a067=(a067*a196);
  a067=(a067*a196);
  a085=(a085+a067);
  a007=(a007*a085);
  a007=(a007-a031);
  a137=(a235*a137);
  a007=(a007-a137);
  a007=(a007/a234);
  a137=(a235*a007);
  a182=(a182-a137);
  a137=(a202*a023);
  a081=(a211*a081);
  a137=(a137+a081);
  a098=(a079*a098);
  a137=(a137+a098);
  a118=(a096*a118);
  a137=(a137+a118);
  a139=(a212*a139);
  a137=(a137+a139);
  a161=(a213*a161);
  a137=(a137+a161);
  a184=(a214*a184);
  a137=(a137+a184);
  a208=(a215*a208);
  a137=(a137+a208);
  a231=(a216*a231);
  a137=(a137+a231);
  a013=(a013+a137);
  a137=(a182*a013);
  a176=(a176+a137);
  a019=(a019*a233);
  a019=(a019*a206);
  a137=(a019/a225);
  a231=(a017*a196);
  a231=(a231*a206);
  a019=(a235*a019);
  a231=(a231-a019);
  a231=(a231/a234);
  a019=(a235*a231);
  a137=(a137-a019);
  a019=(a137*a204);
  a017=(a017*a206);
  a233=(a233-a196);
  a017=(a017*a233);
  a225=(a017/a225);
  a017=(a235*a017);
  a015=(a015+a017);
  a015=(a015/a234);
  a235=(a235*a015);
  a225=(a225+a235);
  a235=(a225*a227);
  a019=(a019+a235);
  a176=(a176+a019);
  a176=(a210*a176);
  a195=(a195+a176);
  a229=(a229+a195);
  if (res[0]!=0) res[0][6]=a229;
  a055=(a001*a055);
  a073=(a005*a073);
  a055=(a055+a073);
  a090=(a100*a090);
  a055=(a055+a090);
  a110=(a120*a110);
  a055=(a055+a110);
  a131=(a141*a131);
  a055=(a055+a131);
  a153=(a163*a153);
  a055=(a055+a153);
  a003=(a186*a003);
  a055=(a055+a003);
  a009=(a170*a009);
  a013=(a007*a013);
  a009=(a009+a013);
  a204=(a231*a204);
  a227=(a015*a227);
  a204=(a204-a227);
  a009=(a009+a204);
  a009=(a210*a009);
  a055=(a055+a009);
  a023=(a023+a055);
  if (res[0]!=0) res[0][7]=a023;
  a023=arg[0]? arg[0][8] : 0;
  a055=arg[0]? arg[0][10] : 0;
  a009=(a001*a055);
  a204=(a000*a023);
  a227=arg[0]? arg[0][9] : 0;
  a013=(a012*a227);
  a204=(a204+a013);
  a013=(a024*a055);
  a003=arg[0]? arg[0][11] : 0;
  a153=(a020*a003);
  a013=(a013+a153);
  a204=(a204+a013);
  a013=(a006*a204);
  a153=(a033*a055);
  a131=(a036*a204);
  a110=(a039*a055);
  a110=(a023+a110);
  a090=(a046*a110);
  a073=(a039*a003);
  a073=(a227+a073);
  a229=(a045*a073);
  a090=(a090+a229);
  a229=(a039*a204);
  a229=(a055+a229);
  a195=(a048*a229);
  a176=(a171*a023);
  a019=(a016*a227);
  a176=(a176+a019);
  a019=(a148*a055);
  a235=(a011*a003);
  a019=(a019-a235);
  a176=(a176+a019);
  a019=(a039*a176);
  a019=(a003+a019);
  a235=(a052*a019);
  a195=(a195+a235);
  a090=(a090+a195);
  a090=(a038*a090);
  a131=(a131+a090);
  a131=(a055+a131);
  a090=(a035*a131);
  a153=(a153+a090);
  a153=(a023+a153);
  a090=(a072*a153);
  a195=(a033*a003);
  a235=(a036*a176);
  a110=(a105*a110);
  a073=(a050*a073);
  a110=(a110+a073);
  a073=(a056*a229);
  a234=(a043*a019);
  a073=(a073-a234);
  a110=(a110+a073);
  a110=(a038*a110);
  a235=(a235+a110);
  a235=(a003+a235);
  a110=(a035*a235);
  a195=(a195+a110);
  a195=(a227+a195);
  a110=(a071*a195);
  a090=(a090+a110);
  a110=(a033*a204);
  a073=(a036*a055);
  a229=(a038*a229);
  a073=(a073+a229);
  a073=(a023+a073);
  a229=(a042*a073);
  a234=(a036*a003);
  a019=(a038*a019);
  a234=(a234+a019);
  a234=(a227+a234);
  a019=(a064*a234);
  a229=(a229+a019);
  a019=(a057*a131);
  a017=(a041*a235);
  a019=(a019+a017);
  a229=(a229+a019);
  a019=(a035*a229);
  a110=(a110+a019);
  a110=(a055+a110);
  a019=(a047*a110);
  a017=(a033*a176);
  a073=(a219*a073);
  a234=(a059*a234);
  a073=(a073+a234);
  a234=(a058*a131);
  a233=(a049*a235);
  a234=(a234-a233);
  a073=(a073+a234);
  a234=(a035*a073);
  a017=(a017+a234);
  a017=(a003+a017);
  a234=(a078*a017);
  a019=(a019+a234);
  a090=(a090+a019);
  a019=(a029*a090);
  a013=(a013+a019);
  a019=(a075*a055);
  a131=(a084*a131);
  a019=(a019+a131);
  a131=(a066*a110);
  a019=(a019+a131);
  a019=(a023+a019);
  a131=(a089*a019);
  a234=(a075*a003);
  a235=(a084*a235);
  a234=(a234+a235);
  a235=(a066*a017);
  a234=(a234+a235);
  a234=(a227+a234);
  a235=(a063*a234);
  a131=(a131+a235);
  a235=(a075*a204);
  a229=(a084*a229);
  a235=(a235+a229);
  a229=(a066*a090);
  a235=(a235+a229);
  a235=(a055+a235);
  a229=(a094*a235);
  a233=(a075*a176);
  a073=(a084*a073);
  a233=(a233+a073);
  a153=(a008*a153);
  a195=(a076*a195);
  a153=(a153+a195);
  a195=(a074*a110);
  a073=(a069*a017);
  a195=(a195-a073);
  a153=(a153+a195);
  a195=(a066*a153);
  a233=(a233+a195);
  a233=(a003+a233);
  a195=(a095*a233);
  a229=(a229+a195);
  a131=(a131+a229);
  a229=(a083*a131);
  a013=(a013+a229);
  a013=(a055+a013);
  a229=(a005*a013);
  a009=(a009+a229);
  a229=(a092*a204);
  a195=(a101*a090);
  a229=(a229+a195);
  a195=(a102*a131);
  a229=(a229+a195);
  a195=(a006*a055);
  a073=(a029*a110);
  a195=(a195+a073);
  a073=(a083*a235);
  a195=(a195+a073);
  a195=(a023+a195);
  a073=(a109*a195);
  a196=(a006*a003);
  a206=(a029*a017);
  a196=(a196+a206);
  a206=(a083*a233);
  a196=(a196+a206);
  a196=(a227+a196);
  a206=(a108*a196);
  a073=(a073+a206);
  a206=(a111*a013);
  a208=(a006*a176);
  a184=(a029*a153);
  a208=(a208+a184);
  a019=(a065*a019);
  a234=(a093*a234);
  a019=(a019+a234);
  a234=(a091*a235);
  a184=(a087*a233);
  a234=(a234-a184);
  a019=(a019+a234);
  a234=(a083*a019);
  a208=(a208+a234);
  a208=(a003+a208);
  a234=(a115*a208);
  a206=(a206+a234);
  a073=(a073+a206);
  a206=(a103*a073);
  a229=(a229+a206);
  a229=(a055+a229);
  a206=(a100*a229);
  a009=(a009+a206);
  a206=(a112*a204);
  a234=(a121*a090);
  a206=(a206+a234);
  a234=(a122*a131);
  a206=(a206+a234);
  a234=(a123*a073);
  a206=(a206+a234);
  a234=(a092*a055);
  a184=(a101*a110);
  a234=(a234+a184);
  a184=(a102*a235);
  a234=(a234+a184);
  a184=(a103*a013);
  a234=(a234+a184);
  a234=(a023+a234);
  a184=(a130*a234);
  a161=(a092*a003);
  a139=(a101*a017);
  a161=(a161+a139);
  a139=(a102*a233);
  a161=(a161+a139);
  a139=(a103*a208);
  a161=(a161+a139);
  a161=(a227+a161);
  a139=(a129*a161);
  a184=(a184+a139);
  a139=(a132*a229);
  a118=(a092*a176);
  a098=(a101*a153);
  a118=(a118+a098);
  a098=(a102*a019);
  a118=(a118+a098);
  a195=(a082*a195);
  a196=(a113*a196);
  a195=(a195+a196);
  a196=(a119*a013);
  a098=(a107*a208);
  a196=(a196-a098);
  a195=(a195+a196);
  a196=(a103*a195);
  a118=(a118+a196);
  a118=(a003+a118);
  a196=(a136*a118);
  a139=(a139+a196);
  a184=(a184+a139);
  a139=(a124*a184);
  a206=(a206+a139);
  a206=(a055+a206);
  a139=(a120*a206);
  a009=(a009+a139);
  a139=(a133*a204);
  a196=(a142*a090);
  a139=(a139+a196);
  a196=(a143*a131);
  a139=(a139+a196);
  a196=(a144*a073);
  a139=(a139+a196);
  a196=(a145*a184);
  a139=(a139+a196);
  a196=(a112*a055);
  a098=(a121*a110);
  a196=(a196+a098);
  a098=(a122*a235);
  a196=(a196+a098);
  a098=(a123*a013);
  a196=(a196+a098);
  a098=(a124*a229);
  a196=(a196+a098);
  a196=(a023+a196);
  a098=(a152*a196);
  a081=(a112*a003);
  a031=(a121*a017);
  a081=(a081+a031);
  a031=(a122*a233);
  a081=(a081+a031);
  a031=(a123*a208);
  a081=(a081+a031);
  a031=(a124*a118);
  a081=(a081+a031);
  a081=(a227+a081);
  a031=(a151*a081);
  a098=(a098+a031);
  a031=(a154*a206);
  a085=(a112*a176);
  a067=(a121*a153);
  a085=(a085+a067);
  a067=(a122*a019);
  a085=(a085+a067);
  a067=(a123*a195);
  a085=(a085+a067);
  a234=(a117*a234);
  a161=(a134*a161);
  a234=(a234+a161);
  a161=(a140*a229);
  a067=(a128*a118);
  a161=(a161-a067);
  a234=(a234+a161);
  a161=(a124*a234);
  a085=(a085+a161);
  a085=(a003+a085);
  a161=(a158*a085);
  a031=(a031+a161);
  a098=(a098+a031);
  a031=(a146*a098);
  a139=(a139+a031);
  a139=(a055+a139);
  a031=(a141*a139);
  a009=(a009+a031);
  a031=(a155*a204);
  a161=(a164*a090);
  a031=(a031+a161);
  a161=(a165*a131);
  a031=(a031+a161);
  a161=(a166*a073);
  a031=(a031+a161);
  a161=(a167*a184);
  a031=(a031+a161);
  a161=(a168*a098);
  a031=(a031+a161);
  a161=(a133*a055);
  a067=(a142*a110);
  a161=(a161+a067);
  a067=(a143*a235);
  a161=(a161+a067);
  a067=(a144*a013);
  a161=(a161+a067);
  a067=(a145*a229);
  a161=(a161+a067);
  a067=(a146*a206);
  a161=(a161+a067);
  a161=(a023+a161);
  a067=(a175*a161);
  a116=(a133*a003);
  a236=(a142*a017);
  a116=(a116+a236);
  a236=(a143*a233);
  a116=(a116+a236);
  a236=(a144*a208);
  a116=(a116+a236);
  a236=(a145*a118);
  a116=(a116+a236);
  a236=(a146*a085);
  a116=(a116+a236);
  a116=(a227+a116);
  a236=(a174*a116);
  a067=(a067+a236);
  a236=(a177*a139);
  a180=(a133*a176);
  a157=(a142*a153);
  a180=(a180+a157);
  a157=(a143*a019);
  a180=(a180+a157);
  a157=(a144*a195);
  a180=(a180+a157);
  a157=(a145*a234);
  a180=(a180+a157);
  a196=(a138*a196);
  a081=(a156*a081);
  a196=(a196+a081);
  a081=(a162*a206);
  a157=(a150*a085);
  a081=(a081-a157);
  a196=(a196+a081);
  a081=(a146*a196);
  a180=(a180+a081);
  a180=(a003+a180);
  a081=(a181*a180);
  a236=(a236+a081);
  a067=(a067+a236);
  a236=(a169*a067);
  a031=(a031+a236);
  a031=(a055+a031);
  a236=(a163*a031);
  a009=(a009+a236);
  a236=(a178*a204);
  a081=(a187*a090);
  a236=(a236+a081);
  a081=(a188*a131);
  a236=(a236+a081);
  a081=(a189*a073);
  a236=(a236+a081);
  a081=(a190*a184);
  a236=(a236+a081);
  a081=(a191*a098);
  a236=(a236+a081);
  a081=(a192*a067);
  a236=(a236+a081);
  a081=(a155*a055);
  a157=(a164*a110);
  a081=(a081+a157);
  a157=(a165*a235);
  a081=(a081+a157);
  a157=(a166*a013);
  a081=(a081+a157);
  a157=(a167*a229);
  a081=(a081+a157);
  a157=(a168*a206);
  a081=(a081+a157);
  a157=(a169*a139);
  a081=(a081+a157);
  a081=(a023+a081);
  a157=(a199*a081);
  a135=(a155*a003);
  a114=(a164*a017);
  a135=(a135+a114);
  a114=(a165*a233);
  a135=(a135+a114);
  a114=(a166*a208);
  a135=(a135+a114);
  a114=(a167*a118);
  a135=(a135+a114);
  a114=(a168*a085);
  a135=(a135+a114);
  a114=(a169*a180);
  a135=(a135+a114);
  a135=(a227+a135);
  a114=(a198*a135);
  a157=(a157+a114);
  a114=(a201*a031);
  a051=(a155*a176);
  a014=(a164*a153);
  a051=(a051+a014);
  a014=(a165*a019);
  a051=(a051+a014);
  a014=(a166*a195);
  a051=(a051+a014);
  a014=(a167*a234);
  a051=(a051+a014);
  a014=(a168*a196);
  a051=(a051+a014);
  a161=(a160*a161);
  a116=(a179*a116);
  a161=(a161+a116);
  a116=(a185*a139);
  a014=(a173*a180);
  a116=(a116-a014);
  a161=(a161+a116);
  a116=(a169*a161);
  a051=(a051+a116);
  a051=(a003+a051);
  a116=(a205*a051);
  a114=(a114+a116);
  a157=(a157+a114);
  a114=(a193*a157);
  a236=(a236+a114);
  a236=(a055+a236);
  a114=(a186*a236);
  a009=(a009+a114);
  a114=(a202*a204);
  a090=(a211*a090);
  a114=(a114+a090);
  a131=(a079*a131);
  a114=(a114+a131);
  a131=(a096*a073);
  a114=(a114+a131);
  a131=(a212*a184);
  a114=(a114+a131);
  a131=(a213*a098);
  a114=(a114+a131);
  a131=(a214*a067);
  a114=(a114+a131);
  a131=(a215*a157);
  a114=(a114+a131);
  a131=(a178*a055);
  a090=(a187*a110);
  a131=(a131+a090);
  a090=(a188*a235);
  a131=(a131+a090);
  a090=(a189*a013);
  a131=(a131+a090);
  a090=(a190*a229);
  a131=(a131+a090);
  a090=(a191*a206);
  a131=(a131+a090);
  a090=(a192*a139);
  a131=(a131+a090);
  a090=(a193*a031);
  a131=(a131+a090);
  a131=(a023+a131);
  a090=(a222*a131);
  a116=(a178*a003);
  a014=(a187*a017);
  a116=(a116+a014);
  a014=(a188*a233);
  a116=(a116+a014);
  a014=(a189*a208);
  a116=(a116+a014);
  a014=(a190*a118);
  a116=(a116+a014);
  a014=(a191*a085);
  a116=(a116+a014);
  a014=(a192*a180);
  a116=(a116+a014);
  a014=(a193*a051);
  a116=(a116+a014);
  a116=(a227+a116);
  a014=(a221*a116);
  a090=(a090+a014);
  a014=(a224*a236);
  a077=(a178*a176);
  a126=(a187*a153);
  a077=(a077+a126);
  a126=(a188*a019);
  a077=(a077+a126);
  a126=(a189*a195);
  a077=(a077+a126);
  a126=(a190*a234);
  a077=(a077+a126);
  a126=(a191*a196);
  a077=(a077+a126);
  a126=(a192*a161);
  a077=(a077+a126);
  a081=(a183*a081);
  a135=(a203*a135);
  a081=(a081+a135);
  a135=(a209*a031);
  a126=(a197*a051);
  a135=(a135-a126);
  a081=(a081+a135);
  a135=(a193*a081);
  a077=(a077+a135);
  a077=(a003+a077);
  a135=(a228*a077);
  a014=(a014+a135);
  a090=(a090+a014);
  a014=(a216*a090);
  a114=(a114+a014);
  a114=(a055+a114);
  a014=(a210*a114);
  a009=(a009+a014);
  a009=(a023+a009);
  if (res[0]!=0) res[0][8]=a009;
  a009=(a001*a003);
  a014=(a005*a208);
  a009=(a009+a014);
  a014=(a100*a118);
  a009=(a009+a014);
  a014=(a120*a085);
  a009=(a009+a014);
  a014=(a141*a180);
  a009=(a009+a014);
  a014=(a163*a051);
  a009=(a009+a014);
  a014=(a186*a077);
  a009=(a009+a014);
  a014=(a202*a176);
  a153=(a211*a153);
  a014=(a014+a153);
  a019=(a079*a019);
  a014=(a014+a019);
  a019=(a096*a195);
  a014=(a014+a019);
  a019=(a212*a234);
  a014=(a014+a019);
  a019=(a213*a196);
  a014=(a014+a019);
  a019=(a214*a161);
  a014=(a014+a019);
  a019=(a215*a081);
  a014=(a014+a019);
  a131=(a021*a131);
  a116=(a226*a116);
  a131=(a131+a116);
  a116=(a232*a236);
  a019=(a220*a077);
  a116=(a116-a019);
  a131=(a131+a116);
  a116=(a216*a131);
  a014=(a014+a116);
  a014=(a003+a014);
  a116=(a210*a014);
  a009=(a009+a116);
  a009=(a227+a009);
  if (res[0]!=0) res[0][9]=a009;
  a204=(a001*a204);
  a073=(a005*a073);
  a204=(a204+a073);
  a184=(a100*a184);
  a204=(a204+a184);
  a098=(a120*a098);
  a204=(a204+a098);
  a067=(a141*a067);
  a204=(a204+a067);
  a157=(a163*a157);
  a204=(a204+a157);
  a090=(a186*a090);
  a204=(a204+a090);
  a090=(a202*a055);
  a110=(a211*a110);
  a090=(a090+a110);
  a235=(a079*a235);
  a090=(a090+a235);
  a013=(a096*a013);
  a090=(a090+a013);
  a229=(a212*a229);
  a090=(a090+a229);
  a206=(a213*a206);
  a090=(a090+a206);
  a139=(a214*a139);
  a090=(a090+a139);
  a031=(a215*a031);
  a090=(a090+a031);
  a236=(a216*a236);
  a090=(a090+a236);
  a023=(a023+a090);
  a090=(a159*a023);
  a236=(a202*a003);
  a017=(a211*a017);
  a236=(a236+a017);
  a233=(a079*a233);
  a236=(a236+a233);
  a208=(a096*a208);
  a236=(a236+a208);
  a118=(a212*a118);
  a236=(a236+a118);
  a085=(a213*a085);
  a236=(a236+a085);
  a180=(a214*a180);
  a236=(a236+a180);
  a051=(a215*a051);
  a236=(a236+a051);
  a077=(a216*a077);
  a236=(a236+a077);
  a227=(a227+a236);
  a236=(a182*a227);
  a090=(a090+a236);
  a236=(a137*a114);
  a077=(a225*a014);
  a236=(a236+a077);
  a090=(a090+a236);
  a090=(a210*a090);
  a204=(a204+a090);
  a055=(a055+a204);
  if (res[0]!=0) res[0][10]=a055;
  a176=(a001*a176);
  a195=(a005*a195);
  a176=(a176+a195);
  a234=(a100*a234);
  a176=(a176+a234);
  a196=(a120*a196);
  a176=(a176+a196);
  a161=(a141*a161);
  a176=(a176+a161);
  a081=(a163*a081);
  a176=(a176+a081);
  a131=(a186*a131);
  a176=(a176+a131);
  a023=(a170*a023);
  a227=(a007*a227);
  a023=(a023+a227);
  a114=(a231*a114);
  a014=(a015*a014);
  a114=(a114-a014);
  a023=(a023+a114);
  a023=(a210*a023);
  a176=(a176+a023);
  a003=(a003+a176);
  if (res[0]!=0) res[0][11]=a003;
  a003=arg[0]? arg[0][12] : 0;
  a176=arg[0]? arg[0][14] : 0;
  a023=(a001*a176);
  a000=(a000*a003);
  a114=arg[0]? arg[0][13] : 0;
  a012=(a012*a114);
  a000=(a000+a012);
  a024=(a024*a176);
  a012=arg[0]? arg[0][15] : 0;
  a020=(a020*a012);
  a024=(a024+a020);
  a000=(a000+a024);
  a024=(a006*a000);
  a020=(a033*a176);
  a014=(a036*a000);
  a227=(a039*a176);
  a227=(a003+a227);
  a046=(a046*a227);
  a131=(a039*a012);
  a131=(a114+a131);
  a045=(a045*a131);
  a046=(a046+a045);
  a045=(a039*a000);
  a045=(a176+a045);
  a048=(a048*a045);
  a171=(a171*a003);
  a016=(a016*a114);
  a171=(a171+a016);
  a148=(a148*a176);
  a011=(a011*a012);
  a148=(a148-a011);
  a171=(a171+a148);
  a039=(a039*a171);
  a039=(a012+a039);
  a052=(a052*a039);
  a048=(a048+a052);
  a046=(a046+a048);
  a046=(a038*a046);
  a014=(a014+a046);
  a014=(a176+a014);
  a046=(a035*a014);
  a020=(a020+a046);
  a020=(a003+a020);
  a072=(a072*a020);
  a046=(a033*a012);
  a048=(a036*a171);
  a105=(a105*a227);
  a050=(a050*a131);
  a105=(a105+a050);
  a056=(a056*a045);
  a043=(a043*a039);
  a056=(a056-a043);
  a105=(a105+a056);
  a105=(a038*a105);
  a048=(a048+a105);
  a048=(a012+a048);
  a105=(a035*a048);
  a046=(a046+a105);
  a046=(a114+a046);
  a071=(a071*a046);
  a072=(a072+a071);
  a071=(a033*a000);
  a105=(a036*a176);
  a045=(a038*a045);
  a105=(a105+a045);
  a105=(a003+a105);
  a042=(a042*a105);
  a036=(a036*a012);
  a038=(a038*a039);
  a036=(a036+a038);
  a036=(a114+a036);
  a064=(a064*a036);
  a042=(a042+a064);
  a057=(a057*a014);
  a041=(a041*a048);
  a057=(a057+a041);
  a042=(a042+a057);
  a057=(a035*a042);
  a071=(a071+a057);
  a071=(a176+a071);
  a047=(a047*a071);
  a033=(a033*a171);
  a219=(a219*a105);
  a059=(a059*a036);
  a219=(a219+a059);
  a058=(a058*a014);
  a049=(a049*a048);
  a058=(a058-a049);
  a219=(a219+a058);
  a035=(a035*a219);
  a033=(a033+a035);
  a033=(a012+a033);
  a078=(a078*a033);
  a047=(a047+a078);
  a072=(a072+a047);
  a047=(a029*a072);
  a024=(a024+a047);
  a047=(a075*a176);
  a014=(a084*a014);
  a047=(a047+a014);
  a014=(a066*a071);
  a047=(a047+a014);
  a047=(a003+a047);
  a089=(a089*a047);
  a014=(a075*a012);
  a048=(a084*a048);
  a014=(a014+a048);
  a048=(a066*a033);
  a014=(a014+a048);
  a014=(a114+a014);
  a063=(a063*a014);
  a089=(a089+a063);
  a063=(a075*a000);
  a042=(a084*a042);
  a063=(a063+a042);
  a042=(a066*a072);
  a063=(a063+a042);
  a063=(a176+a063);
  a094=(a094*a063);
  a075=(a075*a171);
  a084=(a084*a219);
  a075=(a075+a084);
  a008=(a008*a020);
  a076=(a076*a046);
  a008=(a008+a076);
  a074=(a074*a071);
  a069=(a069*a033);
  a074=(a074-a069);
  a008=(a008+a074);
  a066=(a066*a008);
  a075=(a075+a066);
  a075=(a012+a075);
  a095=(a095*a075);
  a094=(a094+a095);
  a089=(a089+a094);
  a094=(a083*a089);
  a024=(a024+a094);
  a024=(a176+a024);
  a094=(a005*a024);
  a023=(a023+a094);
  a094=(a092*a000);
  a095=(a101*a072);
  a094=(a094+a095);
  a095=(a102*a089);
  a094=(a094+a095);
  a095=(a006*a176);
  a066=(a029*a071);
  a095=(a095+a066);
  a066=(a083*a063);
  a095=(a095+a066);
  a095=(a003+a095);
  a109=(a109*a095);
  a066=(a006*a012);
  a074=(a029*a033);
  a066=(a066+a074);
  a074=(a083*a075);
  a066=(a066+a074);
  a066=(a114+a066);
  a108=(a108*a066);
  a109=(a109+a108);
  a111=(a111*a024);
  a006=(a006*a171);
  a029=(a029*a008);
  a006=(a006+a029);
  a065=(a065*a047);
  a093=(a093*a014);
  a065=(a065+a093);
  a091=(a091*a063);
  a087=(a087*a075);
  a091=(a091-a087);
  a065=(a065+a091);
  a083=(a083*a065);
  a006=(a006+a083);
  a006=(a012+a006);
  a115=(a115*a006);
  a111=(a111+a115);
  a109=(a109+a111);
  a111=(a103*a109);
  a094=(a094+a111);
  a094=(a176+a094);
  a111=(a100*a094);
  a023=(a023+a111);
  a111=(a112*a000);
  a115=(a121*a072);
  a111=(a111+a115);
  a115=(a122*a089);
  a111=(a111+a115);
  a115=(a123*a109);
  a111=(a111+a115);
  a115=(a092*a176);
  a083=(a101*a071);
  a115=(a115+a083);
  a083=(a102*a063);
  a115=(a115+a083);
  a083=(a103*a024);
  a115=(a115+a083);
  a115=(a003+a115);
  a130=(a130*a115);
  a083=(a092*a012);
  a091=(a101*a033);
  a083=(a083+a091);
  a091=(a102*a075);
  a083=(a083+a091);
  a091=(a103*a006);
  a083=(a083+a091);
  a083=(a114+a083);
  a129=(a129*a083);
  a130=(a130+a129);
  a132=(a132*a094);
  a092=(a092*a171);
  a101=(a101*a008);
  a092=(a092+a101);
  a102=(a102*a065);
  a092=(a092+a102);
  a082=(a082*a095);
  a113=(a113*a066);
  a082=(a082+a113);
  a119=(a119*a024);
  a107=(a107*a006);
  a119=(a119-a107);
  a082=(a082+a119);
  a103=(a103*a082);
  a092=(a092+a103);
  a092=(a012+a092);
  a136=(a136*a092);
  a132=(a132+a136);
  a130=(a130+a132);
  a132=(a124*a130);
  a111=(a111+a132);
  a111=(a176+a111);
  a132=(a120*a111);
  a023=(a023+a132);
  a132=(a133*a000);
  a136=(a142*a072);
  a132=(a132+a136);
  a136=(a143*a089);
  a132=(a132+a136);
  a136=(a144*a109);
  a132=(a132+a136);
  a136=(a145*a130);
  a132=(a132+a136);
  a136=(a112*a176);
  a103=(a121*a071);
  a136=(a136+a103);
  a103=(a122*a063);
  a136=(a136+a103);
  a103=(a123*a024);
  a136=(a136+a103);
  a103=(a124*a094);
  a136=(a136+a103);
  a136=(a003+a136);
  a152=(a152*a136);
  a103=(a112*a012);
  a119=(a121*a033);
  a103=(a103+a119);
  a119=(a122*a075);
  a103=(a103+a119);
  a119=(a123*a006);
  a103=(a103+a119);
  a119=(a124*a092);
  a103=(a103+a119);
  a103=(a114+a103);
  a151=(a151*a103);
  a152=(a152+a151);
  a154=(a154*a111);
  a112=(a112*a171);
  a121=(a121*a008);
  a112=(a112+a121);
  a122=(a122*a065);
  a112=(a112+a122);
  a123=(a123*a082);
  a112=(a112+a123);
  a117=(a117*a115);
  a134=(a134*a083);
  a117=(a117+a134);
  a140=(a140*a094);
  a128=(a128*a092);
  a140=(a140-a128);
  a117=(a117+a140);
  a124=(a124*a117);
  a112=(a112+a124);
  a112=(a012+a112);
  a158=(a158*a112);
  a154=(a154+a158);
  a152=(a152+a154);
  a154=(a146*a152);
  a132=(a132+a154);
  a132=(a176+a132);
  a154=(a141*a132);
  a023=(a023+a154);
  a154=(a155*a000);
  a158=(a164*a072);
  a154=(a154+a158);
  a158=(a165*a089);
  a154=(a154+a158);
  a158=(a166*a109);
  a154=(a154+a158);
  a158=(a167*a130);
  a154=(a154+a158);
  a158=(a168*a152);
  a154=(a154+a158);
  a158=(a133*a176);
  a124=(a142*a071);
  a158=(a158+a124);
  a124=(a143*a063);
  a158=(a158+a124);
  a124=(a144*a024);
  a158=(a158+a124);
  a124=(a145*a094);
  a158=(a158+a124);
  a124=(a146*a111);
  a158=(a158+a124);
  a158=(a003+a158);
  a175=(a175*a158);
  a124=(a133*a012);
  a140=(a142*a033);
  a124=(a124+a140);
  a140=(a143*a075);
  a124=(a124+a140);
  a140=(a144*a006);
  a124=(a124+a140);
  a140=(a145*a092);
  a124=(a124+a140);
  a140=(a146*a112);
  a124=(a124+a140);
  a124=(a114+a124);
  a174=(a174*a124);
  a175=(a175+a174);
  a177=(a177*a132);
  a133=(a133*a171);
  a142=(a142*a008);
  a133=(a133+a142);
  a143=(a143*a065);
  a133=(a133+a143);
  a144=(a144*a082);
  a133=(a133+a144);
  a145=(a145*a117);
  a133=(a133+a145);
  a138=(a138*a136);
  a156=(a156*a103);
  a138=(a138+a156);
  a162=(a162*a111);
  a150=(a150*a112);
  a162=(a162-a150);
  a138=(a138+a162);
  a146=(a146*a138);
  a133=(a133+a146);
  a133=(a012+a133);
  a181=(a181*a133);
  a177=(a177+a181);
  a175=(a175+a177);
  a177=(a169*a175);
  a154=(a154+a177);
  a154=(a176+a154);
  a177=(a163*a154);
  a023=(a023+a177);
  a177=(a178*a000);
  a181=(a187*a072);
  a177=(a177+a181);
  a181=(a188*a089);
  a177=(a177+a181);
  a181=(a189*a109);
  a177=(a177+a181);
  a181=(a190*a130);
  a177=(a177+a181);
  a181=(a191*a152);
  a177=(a177+a181);
  a181=(a192*a175);
  a177=(a177+a181);
  a181=(a155*a176);
  a146=(a164*a071);
  a181=(a181+a146);
  a146=(a165*a063);
  a181=(a181+a146);
  a146=(a166*a024);
  a181=(a181+a146);
  a146=(a167*a094);
  a181=(a181+a146);
  a146=(a168*a111);
  a181=(a181+a146);
  a146=(a169*a132);
  a181=(a181+a146);
  a181=(a003+a181);
  a199=(a199*a181);
  a146=(a155*a012);
  a162=(a164*a033);
  a146=(a146+a162);
  a162=(a165*a075);
  a146=(a146+a162);
  a162=(a166*a006);
  a146=(a146+a162);
  a162=(a167*a092);
  a146=(a146+a162);
  a162=(a168*a112);
  a146=(a146+a162);
  a162=(a169*a133);
  a146=(a146+a162);
  a146=(a114+a146);
  a198=(a198*a146);
  a199=(a199+a198);
  a201=(a201*a154);
  a155=(a155*a171);
  a164=(a164*a008);
  a155=(a155+a164);
  a165=(a165*a065);
  a155=(a155+a165);
  a166=(a166*a082);
  a155=(a155+a166);
  a167=(a167*a117);
  a155=(a155+a167);
  a168=(a168*a138);
  a155=(a155+a168);
  a160=(a160*a158);
  a179=(a179*a124);
  a160=(a160+a179);
  a185=(a185*a132);
  a173=(a173*a133);
  a185=(a185-a173);
  a160=(a160+a185);
  a169=(a169*a160);
  a155=(a155+a169);
  a155=(a012+a155);
  a205=(a205*a155);
  a201=(a201+a205);
  a199=(a199+a201);
  a201=(a193*a199);
  a177=(a177+a201);
  a177=(a176+a177);
  a201=(a186*a177);
  a023=(a023+a201);
  a201=(a202*a000);
  a072=(a211*a072);
  a201=(a201+a072);
  a089=(a079*a089);
  a201=(a201+a089);
  a089=(a096*a109);
  a201=(a201+a089);
  a089=(a212*a130);
  a201=(a201+a089);
  a089=(a213*a152);
  a201=(a201+a089);
  a089=(a214*a175);
  a201=(a201+a089);
  a089=(a215*a199);
  a201=(a201+a089);
  a089=(a178*a176);
  a072=(a187*a071);
  a089=(a089+a072);
  a072=(a188*a063);
  a089=(a089+a072);
  a072=(a189*a024);
  a089=(a089+a072);
  a072=(a190*a094);
  a089=(a089+a072);
  a072=(a191*a111);
  a089=(a089+a072);
  a072=(a192*a132);
  a089=(a089+a072);
  a072=(a193*a154);
  a089=(a089+a072);
  a089=(a003+a089);
  a222=(a222*a089);
  a072=(a178*a012);
  a205=(a187*a033);
  a072=(a072+a205);
  a205=(a188*a075);
  a072=(a072+a205);
  a205=(a189*a006);
  a072=(a072+a205);
  a205=(a190*a092);
  a072=(a072+a205);
  a205=(a191*a112);
  a072=(a072+a205);
  a205=(a192*a133);
  a072=(a072+a205);
  a205=(a193*a155);
  a072=(a072+a205);
  a072=(a114+a072);
  a221=(a221*a072);
  a222=(a222+a221);
  a224=(a224*a177);
  a178=(a178*a171);
  a187=(a187*a008);
  a178=(a178+a187);
  a188=(a188*a065);
  a178=(a178+a188);
  a189=(a189*a082);
  a178=(a178+a189);
  a190=(a190*a117);
  a178=(a178+a190);
  a191=(a191*a138);
  a178=(a178+a191);
  a192=(a192*a160);
  a178=(a178+a192);
  a183=(a183*a181);
  a203=(a203*a146);
  a183=(a183+a203);
  a209=(a209*a154);
  a197=(a197*a155);
  a209=(a209-a197);
  a183=(a183+a209);
  a193=(a193*a183);
  a178=(a178+a193);
  a178=(a012+a178);
  a228=(a228*a178);
  a224=(a224+a228);
  a222=(a222+a224);
  a224=(a216*a222);
  a201=(a201+a224);
  a201=(a176+a201);
  a224=(a210*a201);
  a023=(a023+a224);
  a023=(a003+a023);
  if (res[0]!=0) res[0][12]=a023;
  a023=(a001*a012);
  a224=(a005*a006);
  a023=(a023+a224);
  a224=(a100*a092);
  a023=(a023+a224);
  a224=(a120*a112);
  a023=(a023+a224);
  a224=(a141*a133);
  a023=(a023+a224);
  a224=(a163*a155);
  a023=(a023+a224);
  a224=(a186*a178);
  a023=(a023+a224);
  a224=(a202*a171);
  a008=(a211*a008);
  a224=(a224+a008);
  a065=(a079*a065);
  a224=(a224+a065);
  a065=(a096*a082);
  a224=(a224+a065);
  a065=(a212*a117);
  a224=(a224+a065);
  a065=(a213*a138);
  a224=(a224+a065);
  a065=(a214*a160);
  a224=(a224+a065);
  a065=(a215*a183);
  a224=(a224+a065);
  a021=(a021*a089);
  a226=(a226*a072);
  a021=(a021+a226);
  a232=(a232*a177);
  a220=(a220*a178);
  a232=(a232-a220);
  a021=(a021+a232);
  a232=(a216*a021);
  a224=(a224+a232);
  a224=(a012+a224);
  a232=(a210*a224);
  a023=(a023+a232);
  a023=(a114+a023);
  if (res[0]!=0) res[0][13]=a023;
  a000=(a001*a000);
  a109=(a005*a109);
  a000=(a000+a109);
  a130=(a100*a130);
  a000=(a000+a130);
  a152=(a120*a152);
  a000=(a000+a152);
  a175=(a141*a175);
  a000=(a000+a175);
  a199=(a163*a199);
  a000=(a000+a199);
  a222=(a186*a222);
  a000=(a000+a222);
  a222=(a202*a176);
  a071=(a211*a071);
  a222=(a222+a071);
  a063=(a079*a063);
  a222=(a222+a063);
  a024=(a096*a024);
  a222=(a222+a024);
  a094=(a212*a094);
  a222=(a222+a094);
  a111=(a213*a111);
  a222=(a222+a111);
  a132=(a214*a132);
  a222=(a222+a132);
  a154=(a215*a154);
  a222=(a222+a154);
  a177=(a216*a177);
  a222=(a222+a177);
  a003=(a003+a222);
  a159=(a159*a003);
  a202=(a202*a012);
  a211=(a211*a033);
  a202=(a202+a211);
  a079=(a079*a075);
  a202=(a202+a079);
  a096=(a096*a006);
  a202=(a202+a096);
  a212=(a212*a092);
  a202=(a202+a212);
  a213=(a213*a112);
  a202=(a202+a213);
  a214=(a214*a133);
  a202=(a202+a214);
  a215=(a215*a155);
  a202=(a202+a215);
  a216=(a216*a178);
  a202=(a202+a216);
  a114=(a114+a202);
  a182=(a182*a114);
  a159=(a159+a182);
  a137=(a137*a201);
  a225=(a225*a224);
  a137=(a137+a225);
  a159=(a159+a137);
  a159=(a210*a159);
  a000=(a000+a159);
  a176=(a176+a000);
  if (res[0]!=0) res[0][14]=a176;
  a001=(a001*a171);
  a005=(a005*a082);
  a001=(a001+a005);
  a100=(a100*a117);
  a001=(a001+a100);
  a120=(a120*a138);
  a001=(a001+a120);
  a141=(a141*a160);
  a001=(a001+a141);
  a163=(a163*a183);
  a001=(a001+a163);
  a186=(a186*a021);
  a001=(a001+a186);
  a170=(a170*a003);
  a007=(a007*a114);
  a170=(a170+a007);
  a231=(a231*a201);
  a015=(a015*a224);
  a231=(a231-a015);
  a170=(a170+a231);
  a210=(a210*a170);
  a001=(a001+a210);
  a012=(a012+a001);
  if (res[0]!=0) res[0][15]=a012;
  return 0;
}

/* variational_steps:(y[4x4],t,h,p[6])->(y_end[4x4]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+237, w1, w2, *w3=w+253, *w4=w+259, w5;
  const casadi_real **arg1=arg+4, *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[2][0] */
  w2 = arg[2] ? arg[2][0] : 0;
  /* #3: @3 = input[3][0] */
  casadi_copy(arg[3], 6, w3);
  /* #4: @4 = variational_step(@0, @1, @2, @3) */
  arg1[0]=wr0;
  arg1[1]=(&w1);
  arg1[2]=(&w2);
  arg1[3]=w3;
  res1[0]=w4;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = (@1+@2) */
  w5  = (w1+w2);
  /* #6: @0 = variational_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
  res1[0]=w0;
  if (casadi_f5(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @0 */
  casadi_copy(w0, 16, res[0]);
  return 0;
}

/* landing_with_derivative:(y[4x4],z[3],T,p[6])->(J[4x4],R[4]) */
static int casadi_f6(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24;
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
  a10=(a09-a03);
  a11=(a10/a07);
  a12=(a11*a04);
  a12=(a04+a12);
  a13=(a05+a03);
  a14=(a10*a11);
  a13=(a13-a14);
  a12=(a12/a13);
  a14=(a11*a12);
  a08=(a08+a14);
  a08=(a08+a12);
  a14=arg[0]? arg[0][6] : 0;
  a15=(a08*a14);
  a16=arg[0]? arg[0][2] : 0;
  a17=sin(a02);
  a18=(a16*a17);
  a19=(a18/a07);
  a04=(a04*a16);
  a20=(a04/a07);
  a21=(a20/a07);
  a06=(a06*a17);
  a21=(a21*a06);
  a19=(a19+a21);
  a21=(a11*a04);
  a21=(a04+a21);
  a21=(a21/a13);
  a22=(a05*a17);
  a23=(a22/a07);
  a24=(a11/a07);
  a24=(a24*a06);
  a23=(a23+a24);
  a24=(a21*a23);
  a04=(a04*a23);
  a06=(a11*a18);
  a04=(a04+a06);
  a18=(a18+a04);
  a18=(a18/a13);
  a13=(a21/a13);
  a22=(a11*a22);
  a10=(a10*a23);
  a22=(a22+a10);
  a13=(a13*a22);
  a18=(a18+a13);
  a13=(a11*a18);
  a24=(a24+a13);
  a19=(a19+a24);
  a19=(a19+a18);
  a24=(a19*a01);
  a15=(a15-a24);
  if (res[0]!=0) res[0][1]=a15;
  a14=(a12*a14);
  a15=(a18*a01);
  a14=(a14-a15);
  if (res[0]!=0) res[0][2]=a14;
  a14=-2.;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][3]=a00;
  a00=arg[0]? arg[0][8] : 0;
  a01=arg[0]? arg[0][9] : 0;
  a15=(a00-a01);
  if (res[0]!=0) res[0][4]=a15;
  a15=arg[0]? arg[0][10] : 0;
  a24=(a08*a15);
  a13=(a19*a01);
  a24=(a24-a13);
  a24=(a24-a03);
  if (res[0]!=0) res[0][5]=a24;
  a15=(a12*a15);
  a24=(a18*a01);
  a15=(a15-a24);
  if (res[0]!=0) res[0][6]=a15;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][7]=a00;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
  a15=(a00-a01);
  if (res[0]!=0) res[0][8]=a15;
  a15=arg[0]? arg[0][14] : 0;
  a24=(a08*a15);
  a13=(a19*a01);
  a24=(a24-a13);
  if (res[0]!=0) res[0][9]=a24;
  a15=(a12*a15);
  a24=(a18*a01);
  a15=(a15-a24);
  a15=(a15-a03);
  if (res[0]!=0) res[0][10]=a15;
  a00=(a14*a00);
  a00=(a00+a01);
  if (res[0]!=0) res[0][11]=a00;
  a00=arg[0]? arg[0][3] : 0;
  a01=(a16-a00);
  if (res[0]!=0) res[0][12]=a01;
  a01=(a05*a00);
  a01=(a01*a17);
  a15=(2.*a16);
  a15=(a00-a15);
  a01=(a01*a15);
  a15=arg[0]? arg[0][0] : 0;
  a24=sin(a15);
  a13=(a15-a02);
  a22=sin(a13);
  a10=(a24-a22);
  a10=(a05*a10);
  a01=(a01+a10);
  a01=(a01+a24);
  a24=(a01/a07);
  a07=(a09/a07);
  a10=casadi_sq(a16);
  a10=(a10*a17);
  a10=(a10+a22);
  a10=(a05*a10);
  a22=arg[3]? arg[3][3] : 0;
  a17=arg[3]? arg[3][5] : 0;
  a23=arg[3]? arg[3][0] : 0;
  a04=(a17*a23);
  a06=arg[2]? arg[2][0] : 0;
  a23=(a23*a06);
  a06=sin(a23);
  a04=(a04*a06);
  a04=(a00+a04);
  a22=(a22*a04);
  a04=arg[3]? arg[3][2] : 0;
  a06=arg[3]? arg[3][4] : 0;
  a23=cos(a23);
  a23=(a23+a03);
  a17=(a17*a23);
  a06=(a06-a17);
  a06=(a06+a02);
  a04=(a04*a06);
  a22=(a22+a04);
  a10=(a10-a22);
  a01=(a07*a01);
  a10=(a10-a01);
  a09=(a09*a07);
  a05=(a05-a09);
  a10=(a10/a05);
  a07=(a07*a10);
  a24=(a24-a07);
  a08=(a08*a24);
  a19=(a19*a00);
  a08=(a08-a19);
  if (res[0]!=0) res[0][13]=a08;
  a12=(a12*a24);
  a18=(a18*a00);
  a12=(a12-a18);
  if (res[0]!=0) res[0][14]=a12;
  a14=(a14*a16);
  a14=(a14+a00);
  if (res[0]!=0) res[0][15]=a14;
  a14=arg[1]? arg[1][0] : 0;
  a13=(a13-a14);
  if (res[1]!=0) res[1][0]=a13;
  a11=(a11*a21);
  a20=(a20+a11);
  a20=(a20+a21);
  a11=arg[1]? arg[1][1] : 0;
  a20=(a20-a11);
  if (res[1]!=0) res[1][1]=a20;
  a20=arg[1]? arg[1][2] : 0;
  a21=(a21-a20);
  if (res[1]!=0) res[1][2]=a21;
  a15=(2.*a15);
  a02=(a02-a15);
  if (res[1]!=0) res[1][3]=a02;
  return 0;
}

/* jacobian_12:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 12 */
  w7 = 12.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
  res1[0]=w9;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #10: {@4, @0} = landing_with_derivative(@9, @1, @6, @8) */
  arg1[0]=w9;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w4;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @4 */
  casadi_copy(w4, 16, res[0]);
  /* #12: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_12:(u0[4],p[6])->(u[4]) */
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

/* plain_step:(y[4],t,h,p[6])->(y_end[4]) */
static int casadi_f9(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75;
  a00=arg[0]? arg[0][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[2]? arg[2][0] : 0;
  a01=(a01*a02);
  a03=arg[0]? arg[0][2] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[3]? arg[3][1] : 0;
  a08=arg[0]? arg[0][3] : 0;
  a09=(a07*a08);
  a10=arg[0]? arg[0][1] : 0;
  a11=sin(a10);
  a09=(a09*a11);
  a12=(2.*a03);
  a12=(a08-a12);
  a09=(a09*a12);
  a12=sin(a00);
  a13=(a00-a10);
  a13=sin(a13);
  a14=(a12-a13);
  a14=(a07*a14);
  a09=(a09+a14);
  a09=(a09+a12);
  a12=(2.*a07);
  a14=1.;
  a15=cos(a10);
  a16=(a14-a15);
  a16=(a12*a16);
  a16=(a16+a14);
  a17=(a09/a16);
  a15=(a15-a14);
  a15=(a07*a15);
  a16=(a15/a16);
  a18=casadi_sq(a03);
  a18=(a18*a11);
  a18=(a18+a13);
  a18=(a07*a18);
  a13=arg[3]? arg[3][3] : 0;
  a11=arg[3]? arg[3][5] : 0;
  a19=arg[3]? arg[3][0] : 0;
  a20=(a11*a19);
  a21=arg[1]? arg[1][0] : 0;
  a22=(a19*a21);
  a23=sin(a22);
  a23=(a20*a23);
  a23=(a08+a23);
  a23=(a13*a23);
  a24=arg[3]? arg[3][2] : 0;
  a25=arg[3]? arg[3][4] : 0;
  a22=cos(a22);
  a22=(a22+a14);
  a22=(a11*a22);
  a22=(a25-a22);
  a22=(a22+a10);
  a22=(a24*a22);
  a23=(a23+a22);
  a18=(a18-a23);
  a09=(a16*a09);
  a18=(a18-a09);
  a15=(a15*a16);
  a15=(a07-a15);
  a18=(a18/a15);
  a16=(a16*a18);
  a17=(a17-a16);
  a16=(a06*a17);
  a15=1.7082860872947386e-01;
  a15=(a15*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a23=(a09*a18);
  a22=8.8762756430420545e-02;
  a22=(a22*a02);
  a26=1.9725056984537900e-02;
  a26=(a26*a02);
  a27=(a26*a17);
  a28=5.9175170953613701e-02;
  a28=(a28*a02);
  a29=5.2600151958767730e-02;
  a29=(a29*a02);
  a30=(a29*a18);
  a30=(a08+a30);
  a31=(a07*a30);
  a32=(a29*a08);
  a32=(a10+a32);
  a33=sin(a32);
  a31=(a31*a33);
  a34=(a29*a17);
  a34=(a03+a34);
  a35=(2.*a34);
  a35=(a30-a35);
  a31=(a31*a35);
  a35=(a29*a03);
  a35=(a00+a35);
  a36=sin(a35);
  a35=(a35-a32);
  a35=sin(a35);
  a37=(a36-a35);
  a37=(a07*a37);
  a31=(a31+a37);
  a31=(a31+a36);
  a36=cos(a32);
  a37=(a14-a36);
  a37=(a12*a37);
  a37=(a37+a14);
  a38=(a31/a37);
  a36=(a36-a14);
  a36=(a07*a36);
  a37=(a36/a37);
  a39=casadi_sq(a34);
  a39=(a39*a33);
  a39=(a39+a35);
  a39=(a07*a39);
  a29=(a21+a29);
  a29=(a19*a29);
  a35=sin(a29);
  a35=(a20*a35);
  a35=(a30+a35);
  a35=(a13*a35);
  a29=cos(a29);
  a29=(a29+a14);
  a29=(a11*a29);
  a29=(a25-a29);
  a29=(a29+a32);
  a29=(a24*a29);
  a35=(a35+a29);
  a39=(a39-a35);
  a31=(a37*a31);
  a39=(a39-a31);
  a36=(a36*a37);
  a36=(a07-a36);
  a39=(a39/a36);
  a37=(a37*a39);
  a38=(a38-a37);
  a38=(a28*a38);
  a27=(a27+a38);
  a27=(a03+a27);
  a38=casadi_sq(a27);
  a37=(a26*a08);
  a30=(a28*a30);
  a37=(a37+a30);
  a37=(a10+a37);
  a30=sin(a37);
  a38=(a38*a30);
  a36=(a26*a03);
  a34=(a28*a34);
  a36=(a36+a34);
  a36=(a00+a36);
  a34=(a36-a37);
  a34=sin(a34);
  a38=(a38+a34);
  a38=(a07*a38);
  a26=(a26*a18);
  a28=(a28*a39);
  a26=(a26+a28);
  a26=(a08+a26);
  a28=7.8900227938151601e-02;
  a28=(a28*a02);
  a28=(a21+a28);
  a28=(a19*a28);
  a39=sin(a28);
  a39=(a20*a39);
  a39=(a26+a39);
  a39=(a13*a39);
  a28=cos(a28);
  a28=(a28+a14);
  a28=(a11*a28);
  a28=(a25-a28);
  a28=(a28+a37);
  a28=(a24*a28);
  a39=(a39+a28);
  a38=(a38-a39);
  a37=cos(a37);
  a39=(a37-a14);
  a39=(a07*a39);
  a37=(a14-a37);
  a37=(a12*a37);
  a37=(a37+a14);
  a28=(a39/a37);
  a31=(a07*a26);
  a31=(a31*a30);
  a30=(2.*a27);
  a30=(a26-a30);
  a31=(a31*a30);
  a36=sin(a36);
  a34=(a36-a34);
  a34=(a07*a34);
  a31=(a31+a34);
  a31=(a31+a36);
  a36=(a28*a31);
  a38=(a38-a36);
  a39=(a39*a28);
  a39=(a07-a39);
  a38=(a38/a39);
  a39=(a22*a38);
  a23=(a23+a39);
  a23=(a08+a23);
  a39=(a07*a23);
  a36=(a09*a08);
  a34=(a22*a26);
  a36=(a36+a34);
  a36=(a10+a36);
  a34=sin(a36);
  a39=(a39*a34);
  a30=(a09*a17);
  a31=(a31/a37);
  a28=(a28*a38);
  a31=(a31-a28);
  a28=(a22*a31);
  a30=(a30+a28);
  a30=(a03+a30);
  a28=(2.*a30);
  a28=(a23-a28);
  a39=(a39*a28);
  a09=(a09*a03);
  a22=(a22*a27);
  a09=(a09+a22);
  a09=(a00+a09);
  a22=sin(a09);
  a09=(a09-a36);
  a09=sin(a09);
  a28=(a22-a09);
  a28=(a07*a28);
  a39=(a39+a28);
  a39=(a39+a22);
  a22=cos(a36);
  a28=(a14-a22);
  a28=(a12*a28);
  a28=(a28+a14);
  a37=(a39/a28);
  a22=(a22-a14);
  a22=(a07*a22);
  a28=(a22/a28);
  a35=casadi_sq(a30);
  a35=(a35*a34);
  a35=(a35+a09);
  a35=(a07*a35);
  a09=1.1835034190722740e-01;
  a09=(a09*a02);
  a09=(a21+a09);
  a09=(a19*a09);
  a34=sin(a09);
  a34=(a20*a34);
  a34=(a23+a34);
  a34=(a13*a34);
  a09=cos(a09);
  a09=(a09+a14);
  a09=(a11*a09);
  a09=(a25-a09);
  a09=(a09+a36);
  a09=(a24*a09);
  a34=(a34+a09);
  a35=(a35-a34);
  a39=(a28*a39);
  a35=(a35-a39);
  a22=(a22*a28);
  a22=(a07-a22);
  a35=(a35/a22);
  a28=(a28*a35);
  a37=(a37-a28);
  a28=(a15*a37);
  a16=(a16+a28);
  a28=1.2546768756682242e-01;
  a28=(a28*a02);
  a22=2.4136513415926669e-01;
  a22=(a22*a02);
  a39=(a22*a18);
  a34=-8.8454947932828609e-01;
  a34=(a34*a02);
  a38=(a34*a38);
  a39=(a39+a38);
  a38=9.2483400326179199e-01;
  a38=(a38*a02);
  a09=(a38*a35);
  a39=(a39+a09);
  a39=(a08+a39);
  a09=(a07*a39);
  a36=(a22*a08);
  a26=(a34*a26);
  a36=(a36+a26);
  a26=(a38*a23);
  a36=(a36+a26);
  a36=(a10+a36);
  a26=sin(a36);
  a09=(a09*a26);
  a29=(a22*a17);
  a31=(a34*a31);
  a29=(a29+a31);
  a31=(a38*a37);
  a29=(a29+a31);
  a29=(a03+a29);
  a31=(2.*a29);
  a31=(a39-a31);
  a09=(a09*a31);
  a22=(a22*a03);
  a34=(a34*a27);
  a22=(a22+a34);
  a38=(a38*a30);
  a22=(a22+a38);
  a22=(a00+a22);
  a38=sin(a22);
  a22=(a22-a36);
  a22=sin(a22);
  a34=(a38-a22);
  a34=(a07*a34);
  a09=(a09+a34);
  a09=(a09+a38);
  a38=cos(a36);
  a34=(a14-a38);
  a34=(a12*a34);
  a34=(a34+a14);
  a27=(a09/a34);
  a38=(a38-a14);
  a38=(a07*a38);
  a34=(a38/a34);
  a31=casadi_sq(a29);
  a31=(a31*a26);
  a31=(a31+a22);
  a31=(a07*a31);
  a22=2.8164965809277259e-01;
  a22=(a22*a02);
  a22=(a21+a22);
  a22=(a19*a22);
  a26=sin(a22);
  a26=(a20*a26);
  a26=(a39+a26);
  a26=(a13*a26);
  a22=cos(a22);
  a22=(a22+a14);
  a22=(a11*a22);
  a22=(a25-a22);
  a22=(a22+a36);
  a22=(a24*a22);
  a26=(a26+a22);
  a31=(a31-a26);
  a09=(a34*a09);
  a31=(a31-a09);
  a38=(a38*a34);
  a38=(a07-a38);
  a31=(a31/a38);
  a34=(a34*a31);
  a27=(a27-a34);
  a34=(a28*a27);
  a16=(a16+a34);
  a16=(a03+a16);
  a34=(a05*a16);
  a04=(a04+a34);
  a34=1.8915178993145003e+00;
  a34=(a34*a02);
  a38=3.7109375000000000e-02;
  a38=(a38*a02);
  a09=(a38*a17);
  a26=1.7025221101954405e-01;
  a26=(a26*a02);
  a22=(a26*a37);
  a09=(a09+a22);
  a22=6.0216538980455959e-02;
  a22=(a22*a02);
  a36=(a22*a27);
  a09=(a09+a36);
  a36=-1.7578125000000000e-02;
  a36=(a36*a02);
  a32=(a06*a18);
  a33=(a15*a35);
  a32=(a32+a33);
  a33=(a28*a31);
  a32=(a32+a33);
  a32=(a08+a32);
  a33=(a07*a32);
  a40=(a06*a08);
  a41=(a15*a23);
  a40=(a40+a41);
  a41=(a28*a39);
  a40=(a40+a41);
  a40=(a10+a40);
  a41=sin(a40);
  a33=(a33*a41);
  a42=(2.*a16);
  a42=(a32-a42);
  a33=(a33*a42);
  a06=(a06*a03);
  a15=(a15*a30);
  a06=(a06+a15);
  a28=(a28*a29);
  a06=(a06+a28);
  a06=(a00+a06);
  a28=sin(a06);
  a06=(a06-a40);
  a06=sin(a06);
  a15=(a28-a06);
  a15=(a07*a15);
  a33=(a33+a15);
  a33=(a33+a28);
  a28=cos(a40);
  a15=(a14-a28);
  a15=(a12*a15);
  a15=(a15+a14);
  a42=(a33/a15);
  a28=(a28-a14);
  a28=(a07*a28);
  a15=(a28/a15);
  a43=casadi_sq(a16);
  a43=(a43*a41);
  a43=(a43+a06);
  a43=(a07*a43);
  a06=3.3333333333333331e-01;
  a06=(a06*a02);
  a06=(a21+a06);
  a06=(a19*a06);
  a41=sin(a06);
  a41=(a20*a41);
  a41=(a32+a41);
  a41=(a13*a41);
  a06=cos(a06);
  a06=(a06+a14);
  a06=(a11*a06);
  a06=(a25-a06);
  a06=(a06+a40);
  a06=(a24*a06);
  a41=(a41+a06);
  a43=(a43-a41);
  a33=(a15*a33);
  a43=(a43-a33);
  a28=(a28*a15);
  a28=(a07-a28);
  a43=(a43/a28);
  a15=(a15*a43);
  a42=(a42-a15);
  a15=(a36*a42);
  a09=(a09+a15);
  a09=(a03+a09);
  a15=(a34*a09);
  a04=(a04+a15);
  a15=-5.8012039600105849e+00;
  a15=(a15*a02);
  a28=3.7092000118504789e-02;
  a28=(a28*a02);
  a33=(a28*a17);
  a41=1.7038392571223998e-01;
  a41=(a41*a02);
  a06=(a41*a37);
  a33=(a33+a06);
  a06=1.0726203044637328e-01;
  a06=(a06*a02);
  a40=(a06*a27);
  a33=(a33+a40);
  a40=-1.5319437748624402e-02;
  a40=(a40*a02);
  a44=(a40*a42);
  a33=(a33+a44);
  a44=8.2737891638140233e-03;
  a44=(a44*a02);
  a45=(a38*a18);
  a46=(a26*a35);
  a45=(a45+a46);
  a46=(a22*a31);
  a45=(a45+a46);
  a46=(a36*a43);
  a45=(a45+a46);
  a45=(a08+a45);
  a46=(a07*a45);
  a47=(a38*a08);
  a48=(a26*a23);
  a47=(a47+a48);
  a48=(a22*a39);
  a47=(a47+a48);
  a48=(a36*a32);
  a47=(a47+a48);
  a47=(a10+a47);
  a48=sin(a47);
  a46=(a46*a48);
  a49=(2.*a09);
  a49=(a45-a49);
  a46=(a46*a49);
  a38=(a38*a03);
  a26=(a26*a30);
  a38=(a38+a26);
  a22=(a22*a29);
  a38=(a38+a22);
  a36=(a36*a16);
  a38=(a38+a36);
  a38=(a00+a38);
  a36=sin(a38);
  a38=(a38-a47);
  a38=sin(a38);
  a22=(a36-a38);
  a22=(a07*a22);
  a46=(a46+a22);
  a46=(a46+a36);
  a36=cos(a47);
  a22=(a14-a36);
  a22=(a12*a22);
  a22=(a22+a14);
  a26=(a46/a22);
  a36=(a36-a14);
  a36=(a07*a36);
  a22=(a36/a22);
  a49=casadi_sq(a09);
  a49=(a49*a48);
  a49=(a49+a38);
  a49=(a07*a49);
  a38=2.5000000000000000e-01;
  a38=(a38*a02);
  a38=(a21+a38);
  a38=(a19*a38);
  a48=sin(a38);
  a48=(a20*a48);
  a48=(a45+a48);
  a48=(a13*a48);
  a38=cos(a38);
  a38=(a38+a14);
  a38=(a11*a38);
  a38=(a25-a38);
  a38=(a38+a47);
  a38=(a24*a38);
  a48=(a48+a38);
  a49=(a49-a48);
  a46=(a22*a46);
  a49=(a49-a46);
  a36=(a36*a22);
  a36=(a07-a36);
  a49=(a49/a36);
  a22=(a22*a49);
  a26=(a26-a22);
  a22=(a44*a26);
  a33=(a33+a22);
  a33=(a03+a33);
  a22=(a15*a33);
  a04=(a04+a22);
  a22=3.1116436695781990e-01;
  a22=(a22*a02);
  a36=6.2411095871607569e-01;
  a36=(a36*a02);
  a46=(a36*a17);
  a48=-3.3608926294469414e+00;
  a48=(a48*a02);
  a38=(a48*a37);
  a46=(a46+a38);
  a38=-8.6821934684172597e-01;
  a38=(a38*a02);
  a47=(a38*a27);
  a46=(a46+a47);
  a47=2.7592099699446710e+01;
  a47=(a47*a02);
  a50=(a47*a42);
  a46=(a46+a50);
  a50=2.0154067550477894e+01;
  a50=(a50*a02);
  a51=(a50*a26);
  a46=(a46+a51);
  a51=-4.3489884181069961e+01;
  a51=(a51*a02);
  a52=(a28*a18);
  a53=(a41*a35);
  a52=(a52+a53);
  a53=(a06*a31);
  a52=(a52+a53);
  a53=(a40*a43);
  a52=(a52+a53);
  a53=(a44*a49);
  a52=(a52+a53);
  a52=(a08+a52);
  a53=(a07*a52);
  a54=(a28*a08);
  a55=(a41*a23);
  a54=(a54+a55);
  a55=(a06*a39);
  a54=(a54+a55);
  a55=(a40*a32);
  a54=(a54+a55);
  a55=(a44*a45);
  a54=(a54+a55);
  a54=(a10+a54);
  a55=sin(a54);
  a53=(a53*a55);
  a56=(2.*a33);
  a56=(a52-a56);
  a53=(a53*a56);
  a28=(a28*a03);
  a41=(a41*a30);
  a28=(a28+a41);
  a06=(a06*a29);
  a28=(a28+a06);
  a40=(a40*a16);
  a28=(a28+a40);
  a44=(a44*a09);
  a28=(a28+a44);
  a28=(a00+a28);
  a44=sin(a28);
  a28=(a28-a54);
  a28=sin(a28);
  a40=(a44-a28);
  a40=(a07*a40);
  a53=(a53+a40);
  a53=(a53+a44);
  a44=cos(a54);
  a40=(a14-a44);
  a40=(a12*a40);
  a40=(a40+a14);
  a06=(a53/a40);
  a44=(a44-a14);
  a44=(a07*a44);
  a40=(a44/a40);
  a41=casadi_sq(a33);
  a41=(a41*a55);
  a41=(a41+a28);
  a41=(a07*a41);
  a28=3.0769230769230771e-01;
  a28=(a28*a02);
  a28=(a21+a28);
  a28=(a19*a28);
  a55=sin(a28);
  a55=(a20*a55);
  a55=(a52+a55);
  a55=(a13*a55);
  a28=cos(a28);
  a28=(a28+a14);
  a28=(a11*a28);
  a28=(a25-a28);
  a28=(a28+a54);
  a28=(a24*a28);
  a55=(a55+a28);
  a41=(a41-a55);
  a53=(a40*a53);
  a41=(a41-a53);
  a44=(a44*a40);
  a44=(a07-a44);
  a41=(a41/a44);
  a40=(a40*a41);
  a06=(a06-a40);
  a40=(a51*a06);
  a46=(a46+a40);
  a46=(a03+a46);
  a40=(a22*a46);
  a04=(a04+a40);
  a40=-1.5216094966251609e-01;
  a40=(a40*a02);
  a44=4.7766253643826434e-01;
  a44=(a44*a02);
  a53=(a44*a17);
  a55=-2.4881146199716677e+00;
  a55=(a55*a02);
  a28=(a55*a37);
  a53=(a53+a28);
  a28=-5.9029082683684297e-01;
  a28=(a28*a02);
  a54=(a28*a27);
  a53=(a53+a54);
  a54=2.1230051448181193e+01;
  a54=(a54*a02);
  a56=(a54*a42);
  a53=(a53+a56);
  a56=1.5279233632882423e+01;
  a56=(a56*a02);
  a57=(a56*a26);
  a53=(a53+a57);
  a57=-3.3288210968984863e+01;
  a57=(a57*a02);
  a58=(a57*a06);
  a53=(a53+a58);
  a58=-2.0331201708508627e-02;
  a58=(a58*a02);
  a59=(a36*a18);
  a60=(a48*a35);
  a59=(a59+a60);
  a60=(a38*a31);
  a59=(a59+a60);
  a60=(a47*a43);
  a59=(a59+a60);
  a60=(a50*a49);
  a59=(a59+a60);
  a60=(a51*a41);
  a59=(a59+a60);
  a59=(a08+a59);
  a60=(a07*a59);
  a61=(a36*a08);
  a62=(a48*a23);
  a61=(a61+a62);
  a62=(a38*a39);
  a61=(a61+a62);
  a62=(a47*a32);
  a61=(a61+a62);
  a62=(a50*a45);
  a61=(a61+a62);
  a62=(a51*a52);
  a61=(a61+a62);
  a61=(a10+a61);
  a62=sin(a61);
  a60=(a60*a62);
  a63=(2.*a46);
  a63=(a59-a63);
  a60=(a60*a63);
  a36=(a36*a03);
  a48=(a48*a30);
  a36=(a36+a48);
  a38=(a38*a29);
  a36=(a36+a38);
  a47=(a47*a16);
  a36=(a36+a47);
  a50=(a50*a09);
  a36=(a36+a50);
  a51=(a51*a33);
  a36=(a36+a51);
  a36=(a00+a36);
  a51=sin(a36);
  a36=(a36-a61);
  a36=sin(a36);
  a50=(a51-a36);
  a50=(a07*a50);
  a60=(a60+a50);
  a60=(a60+a51);
  a51=cos(a61);
  a50=(a14-a51);
  a50=(a12*a50);
  a50=(a50+a14);
  a47=(a60/a50);
  a51=(a51-a14);
  a51=(a07*a51);
  a50=(a51/a50);
  a38=casadi_sq(a46);
  a38=(a38*a62);
  a38=(a38+a36);
  a38=(a07*a38);
  a36=6.5128205128205130e-01;
  a36=(a36*a02);
  a36=(a21+a36);
  a36=(a19*a36);
  a62=sin(a36);
  a62=(a20*a62);
  a62=(a59+a62);
  a62=(a13*a62);
  a36=cos(a36);
  a36=(a36+a14);
  a36=(a11*a36);
  a36=(a25-a36);
  a36=(a36+a61);
  a36=(a24*a36);
  a62=(a62+a36);
  a38=(a38-a62);
  a60=(a50*a60);
  a38=(a38-a60);
  a51=(a51*a50);
  a51=(a07-a51);
  a38=(a38/a51);
  a50=(a50*a38);
  a47=(a47-a50);
  a50=(a58*a47);
  a53=(a53+a50);
  a53=(a03+a53);
  a50=(a40*a53);
  a04=(a04+a50);
  a50=2.0136540080403034e-01;
  a50=(a50*a02);
  a51=-9.3714243008598730e-01;
  a51=(a51*a02);
  a60=(a51*a17);
  a62=5.1863724288440638e+00;
  a62=(a62*a02);
  a36=(a62*a37);
  a60=(a60+a36);
  a36=1.0914373489967295e+00;
  a36=(a36*a02);
  a61=(a36*a27);
  a60=(a60+a61);
  a61=-8.1497870107469268e+00;
  a61=(a61*a02);
  a48=(a61*a42);
  a60=(a60+a48);
  a48=-1.8520065659996959e+01;
  a48=(a48*a02);
  a63=(a48*a26);
  a60=(a60+a63);
  a63=2.2739487099350505e+01;
  a63=(a63*a02);
  a64=(a63*a06);
  a60=(a60+a64);
  a64=2.4936055526796523e+00;
  a64=(a64*a02);
  a65=(a64*a47);
  a60=(a60+a65);
  a65=-3.0467644718982196e+00;
  a65=(a65*a02);
  a66=(a44*a18);
  a67=(a55*a35);
  a66=(a66+a67);
  a67=(a28*a31);
  a66=(a66+a67);
  a67=(a54*a43);
  a66=(a66+a67);
  a67=(a56*a49);
  a66=(a66+a67);
  a67=(a57*a41);
  a66=(a66+a67);
  a67=(a58*a38);
  a66=(a66+a67);
  a66=(a08+a66);
  a67=(a07*a66);
  a68=(a44*a08);
  a69=(a55*a23);
  a68=(a68+a69);
  a69=(a28*a39);
  a68=(a68+a69);
  a69=(a54*a32);
  a68=(a68+a69);
  a69=(a56*a45);
  a68=(a68+a69);
  a69=(a57*a52);
  a68=(a68+a69);
  a69=(a58*a59);
  a68=(a68+a69);
  a68=(a10+a68);
  a69=sin(a68);
  a67=(a67*a69);
  a70=(2.*a53);
  a70=(a66-a70);
  a67=(a67*a70);
  a44=(a44*a03);
  a55=(a55*a30);
  a44=(a44+a55);
  a28=(a28*a29);
  a44=(a44+a28);
  a54=(a54*a16);
  a44=(a44+a54);
  a56=(a56*a09);
  a44=(a44+a56);
  a57=(a57*a33);
  a44=(a44+a57);
  a58=(a58*a46);
  a44=(a44+a58);
  a44=(a00+a44);
  a58=sin(a44);
  a44=(a44-a68);
  a44=sin(a44);
  a57=(a58-a44);
  a57=(a07*a57);
  a67=(a67+a57);
  a67=(a67+a58);
  a58=cos(a68);
  a57=(a14-a58);
  a57=(a12*a57);
  a57=(a57+a14);
  a56=(a67/a57);
  a58=(a58-a14);
  a58=(a07*a58);
  a57=(a58/a57);
  a54=casadi_sq(a53);
  a54=(a54*a69);
  a54=(a54+a44);
  a54=(a07*a54);
  a44=5.9999999999999998e-01;
  a44=(a44*a02);
  a44=(a21+a44);
  a44=(a19*a44);
  a69=sin(a44);
  a69=(a20*a69);
  a69=(a66+a69);
  a69=(a13*a69);
  a44=cos(a44);
  a44=(a44+a14);
  a44=(a11*a44);
  a44=(a25-a44);
  a44=(a44+a68);
  a44=(a24*a44);
  a69=(a69+a44);
  a54=(a54-a69);
  a67=(a57*a67);
  a54=(a54-a67);
  a58=(a58*a57);
  a58=(a07-a58);
  a54=(a54/a58);
  a57=(a57*a54);
  a56=(a56-a57);
  a57=(a65*a56);
  a60=(a60+a57);
  a60=(a03+a60);
  a57=(a50*a60);
  a04=(a04+a57);
  a57=4.4710615727772587e-02;
  a57=(a57*a02);
  a58=2.2733101475165380e+00;
  a58=(a58*a02);
  a67=(a58*a17);
  a69=-1.0534495466737249e+01;
  a69=(a69*a02);
  a37=(a69*a37);
  a67=(a67+a37);
  a37=-2.0008720582248625e+00;
  a37=(a37*a02);
  a27=(a37*a27);
  a67=(a67+a27);
  a27=-1.7958931863118799e+01;
  a27=(a27*a02);
  a44=(a27*a42);
  a67=(a67+a44);
  a44=2.7948884529419960e+01;
  a44=(a44*a02);
  a68=(a44*a26);
  a67=(a67+a68);
  a68=-2.8589982771350235e+00;
  a68=(a68*a02);
  a28=(a68*a06);
  a67=(a67+a28);
  a28=-8.8728569335306293e+00;
  a28=(a28*a02);
  a55=(a28*a47);
  a67=(a67+a55);
  a55=1.2360567175794303e+01;
  a55=(a55*a02);
  a70=(a55*a56);
  a67=(a67+a70);
  a70=6.4339274601576357e-01;
  a70=(a70*a02);
  a71=(a51*a18);
  a72=(a62*a35);
  a71=(a71+a72);
  a72=(a36*a31);
  a71=(a71+a72);
  a72=(a61*a43);
  a71=(a71+a72);
  a72=(a48*a49);
  a71=(a71+a72);
  a72=(a63*a41);
  a71=(a71+a72);
  a72=(a64*a38);
  a71=(a71+a72);
  a72=(a65*a54);
  a71=(a71+a72);
  a71=(a08+a71);
  a72=(a07*a71);
  a73=(a51*a08);
  a74=(a62*a23);
  a73=(a73+a74);
  a74=(a36*a39);
  a73=(a73+a74);
  a74=(a61*a32);
  a73=(a73+a74);
  a74=(a48*a45);
  a73=(a73+a74);
  a74=(a63*a52);
  a73=(a73+a74);
  a74=(a64*a59);
  a73=(a73+a74);
  a74=(a65*a66);
  a73=(a73+a74);
  a73=(a10+a73);
  a74=sin(a73);
  a72=(a72*a74);
  a75=(2.*a60);
  a75=(a71-a75);
  a72=(a72*a75);
  a51=(a51*a03);
  a62=(a62*a30);
  a51=(a51+a62);
  a36=(a36*a29);
  a51=(a51+a36);
  a61=(a61*a16);
  a51=(a51+a61);
  a48=(a48*a09);
  a51=(a51+a48);
  a63=(a63*a33);
  a51=(a51+a63);
  a64=(a64*a46);
  a51=(a51+a64);
  a65=(a65*a53);
  a51=(a51+a65);
  a51=(a00+a51);
  a65=sin(a51);
  a51=(a51-a73);
  a51=sin(a51);
  a64=(a65-a51);
  a64=(a07*a64);
  a72=(a72+a64);
  a72=(a72+a65);
  a65=cos(a73);
  a64=(a14-a65);
  a64=(a12*a64);
  a64=(a64+a14);
  a63=(a72/a64);
  a65=(a65-a14);
  a65=(a07*a65);
  a64=(a65/a64);
  a48=casadi_sq(a60);
  a48=(a48*a74);
  a48=(a48+a51);
  a48=(a07*a48);
  a51=8.5714285714285710e-01;
  a51=(a51*a02);
  a51=(a21+a51);
  a51=(a19*a51);
  a74=sin(a51);
  a74=(a20*a74);
  a74=(a71+a74);
  a74=(a13*a74);
  a51=cos(a51);
  a51=(a51+a14);
  a51=(a11*a51);
  a51=(a25-a51);
  a51=(a51+a73);
  a51=(a24*a51);
  a74=(a74+a51);
  a48=(a48-a74);
  a72=(a64*a72);
  a48=(a48-a72);
  a65=(a65*a64);
  a65=(a07-a65);
  a48=(a48/a65);
  a64=(a64*a48);
  a63=(a63-a64);
  a64=(a70*a63);
  a67=(a67+a64);
  a67=(a03+a67);
  a64=(a57*a67);
  a04=(a04+a64);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a64=(a05*a32);
  a04=(a04+a64);
  a64=(a34*a45);
  a04=(a04+a64);
  a64=(a15*a52);
  a04=(a04+a64);
  a64=(a22*a59);
  a04=(a04+a64);
  a64=(a40*a66);
  a04=(a04+a64);
  a64=(a50*a71);
  a04=(a04+a64);
  a64=(a58*a18);
  a35=(a69*a35);
  a64=(a64+a35);
  a31=(a37*a31);
  a64=(a64+a31);
  a31=(a27*a43);
  a64=(a64+a31);
  a31=(a44*a49);
  a64=(a64+a31);
  a31=(a68*a41);
  a64=(a64+a31);
  a31=(a28*a38);
  a64=(a64+a31);
  a31=(a55*a54);
  a64=(a64+a31);
  a31=(a70*a48);
  a64=(a64+a31);
  a64=(a08+a64);
  a31=(a57*a64);
  a04=(a04+a31);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a17=(a01*a17);
  a42=(a05*a42);
  a17=(a17+a42);
  a26=(a34*a26);
  a17=(a17+a26);
  a06=(a15*a06);
  a17=(a17+a06);
  a47=(a22*a47);
  a17=(a17+a47);
  a56=(a40*a56);
  a17=(a17+a56);
  a63=(a50*a63);
  a17=(a17+a63);
  a63=(a07*a64);
  a56=(a58*a08);
  a23=(a69*a23);
  a56=(a56+a23);
  a39=(a37*a39);
  a56=(a56+a39);
  a32=(a27*a32);
  a56=(a56+a32);
  a45=(a44*a45);
  a56=(a56+a45);
  a52=(a68*a52);
  a56=(a56+a52);
  a59=(a28*a59);
  a56=(a56+a59);
  a66=(a55*a66);
  a56=(a56+a66);
  a71=(a70*a71);
  a56=(a56+a71);
  a10=(a10+a56);
  a56=sin(a10);
  a63=(a63*a56);
  a71=(2.*a67);
  a71=(a64-a71);
  a63=(a63*a71);
  a58=(a58*a03);
  a69=(a69*a30);
  a58=(a58+a69);
  a37=(a37*a29);
  a58=(a58+a37);
  a27=(a27*a16);
  a58=(a58+a27);
  a44=(a44*a09);
  a58=(a58+a44);
  a68=(a68*a33);
  a58=(a58+a68);
  a28=(a28*a46);
  a58=(a58+a28);
  a55=(a55*a53);
  a58=(a58+a55);
  a70=(a70*a60);
  a58=(a58+a70);
  a00=(a00+a58);
  a58=sin(a00);
  a00=(a00-a10);
  a00=sin(a00);
  a70=(a58-a00);
  a70=(a07*a70);
  a63=(a63+a70);
  a63=(a63+a58);
  a58=cos(a10);
  a70=(a14-a58);
  a12=(a12*a70);
  a12=(a12+a14);
  a70=(a63/a12);
  a58=(a58-a14);
  a58=(a07*a58);
  a12=(a58/a12);
  a67=casadi_sq(a67);
  a67=(a67*a56);
  a67=(a67+a00);
  a67=(a07*a67);
  a21=(a21+a02);
  a19=(a19*a21);
  a21=sin(a19);
  a20=(a20*a21);
  a64=(a64+a20);
  a13=(a13*a64);
  a19=cos(a19);
  a19=(a19+a14);
  a11=(a11*a19);
  a25=(a25-a11);
  a25=(a25+a10);
  a24=(a24*a25);
  a13=(a13+a24);
  a67=(a67-a13);
  a63=(a12*a63);
  a67=(a67-a63);
  a58=(a58*a12);
  a07=(a07-a58);
  a67=(a67/a07);
  a12=(a12*a67);
  a70=(a70-a12);
  a70=(a57*a70);
  a17=(a17+a70);
  a03=(a03+a17);
  if (res[0]!=0) res[0][2]=a03;
  a01=(a01*a18);
  a05=(a05*a43);
  a01=(a01+a05);
  a34=(a34*a49);
  a01=(a01+a34);
  a15=(a15*a41);
  a01=(a01+a15);
  a22=(a22*a38);
  a01=(a01+a22);
  a40=(a40*a54);
  a01=(a01+a40);
  a50=(a50*a48);
  a01=(a01+a50);
  a57=(a57*a67);
  a01=(a01+a57);
  a08=(a08+a01);
  if (res[0]!=0) res[0][3]=a08;
  return 0;
}

/* plain_steps:(y[4],t,h,p[6])->(y_end[4]) */
static int casadi_f8(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *w0=w+76, w1, w2, *w3=w+80, *w4=w+86, w5;
  const casadi_real **arg1=arg+4;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  w1 = arg[1] ? arg[1][0] : 0;
  /* #2: @2 = input[2][0] */
  w2 = arg[2] ? arg[2][0] : 0;
  /* #3: @3 = input[3][0] */
  casadi_copy(arg[3], 6, w3);
  /* #4: @4 = plain_step(@0, @1, @2, @3) */
  arg1[0]=w0;
  arg1[1]=(&w1);
  arg1[2]=(&w2);
  arg1[3]=w3;
  res1[0]=w4;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #5: @5 = (@1+@2) */
  w5  = (w1+w2);
  /* #6: @0 = plain_step(@4, @5, @2, @3) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w2);
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
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
  arg1[3]=w3;
  res1[0]=w0;
  if (casadi_f9(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* landing:(y[4],z[3],p[6])->(R[4]) */
static int casadi_f10(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
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
  a2=(a2-a6);
  a5=(a2/a5);
  a8=(a5*a3);
  a3=(a3+a8);
  a4=(a4+a6);
  a2=(a2*a5);
  a4=(a4-a2);
  a3=(a3/a4);
  a5=(a5*a3);
  a7=(a7+a5);
  a7=(a7+a3);
  a5=arg[1]? arg[1][1] : 0;
  a7=(a7-a5);
  if (res[0]!=0) res[0][1]=a7;
  a7=arg[1]? arg[1][2] : 0;
  a3=(a3-a7);
  if (res[0]!=0) res[0][2]=a3;
  a0=(2.*a0);
  a1=(a1-a0);
  if (res[0]!=0) res[0][3]=a1;
  return 0;
}

/* residual_12:(u[4],p[6])->(R[4]) */
static int casadi_f7(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+93, *w1=w+97, *w2=w+100, w3, w4, w5, *w6=w+104;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, NULL} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @3 = 0 */
  w3 = 0.;
  /* #4: @4 = @0[3] */
  for (rr=(&w4), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #5: @5 = 12 */
  w5 = 12.;
  /* #6: @4 = (@4/@5) */
  w4 /= w5;
  /* #7: @6 = input[1][0] */
  casadi_copy(arg[1], 6, w6);
  /* #8: @0 = plain_steps(@2, @3, @4, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w4);
  arg1[3]=w6;
  res1[0]=w0;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #9: @2 = landing(@0, @1, @6) */
  arg1[0]=w0;
  arg1[1]=w1;
  arg1[2]=w6;
  res1[0]=w2;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #10: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  return 0;
}

/* compass_search_12:(u0[4],p[6])->(u[4],R[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+406, *w1=w+410, *w2=w+416;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_12(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f1(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = residual_12(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f7(arg1, res1, iw, w, 0)) return 1;
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 420;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_12_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 420*sizeof(casadi_real);
  return 0;
}

/* jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f13(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 24 */
  w7 = 24.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #17: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_24:(u0[4],p[6])->(u[4]) */
static int casadi_f12(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f13(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* residual_24:(u[4],p[6])->(R[4]) */
static int casadi_f14(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+93, *w1=w+97, *w2=w+100, w3, w4, w5, *w6=w+104;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, NULL} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @3 = 0 */
  w3 = 0.;
  /* #4: @4 = @0[3] */
  for (rr=(&w4), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #5: @5 = 24 */
  w5 = 24.;
  /* #6: @5 = (@4/@5) */
  w5  = (w4/w5);
  /* #7: @6 = input[1][0] */
  casadi_copy(arg[1], 6, w6);
  /* #8: @0 = plain_steps(@2, @3, @5, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w5);
  arg1[3]=w6;
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
  arg1[3]=w6;
  res1[0]=w2;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #14: @0 = landing(@2, @1, @6) */
  arg1[0]=w2;
  arg1[1]=w1;
  arg1[2]=w6;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #15: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* compass_search_24:(u0[4],p[6])->(u[4],R[4]) */
static int casadi_f11(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+406, *w1=w+410, *w2=w+416;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f12(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = residual_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f14(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f11(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 420;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 420*sizeof(casadi_real);
  return 0;
}

/* jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f17(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 48 */
  w7 = 48.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #27: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_48:(u0[4],p[6])->(u[4]) */
static int casadi_f16(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
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
    if (casadi_f17(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* residual_48:(u[4],p[6])->(R[4]) */
static int casadi_f18(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+1, *rr, *w0=w+93, *w1=w+97, *w2=w+100, w3, w4, w5, *w6=w+104;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, NULL} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @3 = 0 */
  w3 = 0.;
  /* #4: @4 = @0[3] */
  for (rr=(&w4), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #5: @5 = 48 */
  w5 = 48.;
  /* #6: @5 = (@4/@5) */
  w5  = (w4/w5);
  /* #7: @6 = input[1][0] */
  casadi_copy(arg[1], 6, w6);
  /* #8: @0 = plain_steps(@2, @3, @5, @6) */
  arg1[0]=w2;
  arg1[1]=(&w3);
  arg1[2]=(&w5);
  arg1[3]=w6;
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
  arg1[3]=w6;
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
  arg1[3]=w6;
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
  arg1[3]=w6;
  res1[0]=w2;
  if (casadi_f8(arg1, res1, iw, w, 0)) return 1;
  /* #24: @0 = landing(@2, @1, @6) */
  arg1[0]=w2;
  arg1[1]=w1;
  arg1[2]=w6;
  res1[0]=w0;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #25: output[0][0] = @0 */
  casadi_copy(w0, 4, res[0]);
  return 0;
}

/* compass_search_48:(u0[4],p[6])->(u[4],R[4]) */
static int casadi_f15(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+2, *w0=w+406, *w1=w+410, *w2=w+416;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f16(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: @0 = residual_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w0;
  if (casadi_f18(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f15(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 420;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_search_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 420*sizeof(casadi_real);
  return 0;
}

/* jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f21(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 24 */
  w7 = 24.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #17: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_24:(u0[4],p[6])->(u[4]) */
static int casadi_f20(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f21(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* jacobian_24:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f22(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 24 */
  w7 = 24.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #15: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #16: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #17: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_24:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f19(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+406, *w1=w+410, *w2=w+416, *w3=w+420;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_24(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f20(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = jacobian_24(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f22(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f19(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 436;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_24_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 436*sizeof(casadi_real);
  return 0;
}

/* jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f25(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 48 */
  w7 = 48.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #27: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_48:(u0[4],p[6])->(u[4]) */
static int casadi_f24(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f25(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* jacobian_48:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f26(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 48 */
  w7 = 48.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #25: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #26: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #27: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_48:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f23(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+406, *w1=w+410, *w2=w+416, *w3=w+420;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_48(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f24(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = jacobian_48(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f26(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f23(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 436;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 436*sizeof(casadi_real);
  return 0;
}

/* jacobian_96:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f29(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 96 */
  w7 = 96.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #47: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_96:(u0[4],p[6])->(u[4]) */
static int casadi_f28(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f29(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* jacobian_96:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f30(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 96 */
  w7 = 96.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #45: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #47: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_96:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f27(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+406, *w1=w+410, *w2=w+416, *w3=w+420;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_96(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f28(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = jacobian_96(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f30(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f27(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 436;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 436*sizeof(casadi_real);
  return 0;
}

/* jacobian_192:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f33(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 192 */
  w7 = 192.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #85: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #87: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_192:(u0[4],p[6])->(u[4]) */
static int casadi_f32(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f33(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* jacobian_192:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f34(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 192 */
  w7 = 192.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #85: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #86: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #87: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_192:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f31(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+406, *w1=w+410, *w2=w+416, *w3=w+420;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_192(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f32(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = jacobian_192(@2, @1) */
  arg1[0]=w2;
  arg1[1]=w1;
  res1[0]=w3;
  res1[1]=w0;
  if (casadi_f34(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[1][0] = @3 */
  casadi_copy(w3, 16, res[1]);
  /* #6: output[2][0] = @0 */
  casadi_copy(w0, 4, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f31(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 436;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 436*sizeof(casadi_real);
  return 0;
}

/* jacobian_384:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f37(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 384 */
  w7 = 384.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #165: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #167: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* newton_384:(u0[4],p[6])->(u[4]) */
static int casadi_f36(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int iter;
  struct casadi_newton_mem m;
  m.n = 4;
  m.abstol = 1e-14;
  m.abstol_step = 1e-07;
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
    if (casadi_f37(arg+2, res+1, iw, w+56, 0)) return 1;
    if (casadi_newton(&m)) break;
  }
  /* Get the solution */
  casadi_copy(m.x, 4, res[0]);
  return 0;
}

/* jacobian_384:(u[4],p[6])->(J[4x4],R[4]) */
static int casadi_f38(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+2, *rr, *w0=w+278, *w1=w+282, *w2=w+285, *w3=w+289, *w4=w+301, w5, w6, w7, *w8=w+317, *w9=w+323;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = @0[:3] */
  for (rr=w1, cs=w0+0; cs!=w0+3; cs+=1) *rr++ = *cs;
  /* #2: {@2, @3} = start(@1) */
  arg1[0]=w1;
  res1[0]=w2;
  res1[1]=w3;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #3: @4 = horzcat(@2, @3) */
  rr=w4;
  for (i=0, cs=w2; i<4; ++i) *rr++ = *cs++;
  for (i=0, cs=w3; i<12; ++i) *rr++ = *cs++;
  /* #4: @5 = 0 */
  w5 = 0.;
  /* #5: @6 = @0[3] */
  for (rr=(&w6), cs=w0+3; cs!=w0+4; cs+=1) *rr++ = *cs;
  /* #6: @7 = 384 */
  w7 = 384.;
  /* #7: @7 = (@6/@7) */
  w7  = (w6/w7);
  /* #8: @8 = input[1][0] */
  casadi_copy(arg[1], 6, w8);
  /* #9: @9 = variational_steps(@4, @5, @7, @8) */
  arg1[0]=w4;
  arg1[1]=(&w5);
  arg1[2]=(&w7);
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
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
  arg1[3]=w8;
  res1[0]=w4;
  if (casadi_f4(arg1, res1, iw, w, 0)) return 1;
  /* #165: {@9, @0} = landing_with_derivative(@4, @1, @6, @8) */
  arg1[0]=w4;
  arg1[1]=w1;
  arg1[2]=(&w6);
  arg1[3]=w8;
  res1[0]=w9;
  res1[1]=w0;
  if (casadi_f6(arg1, res1, iw, w, 0)) return 1;
  /* #166: output[0][0] = @9 */
  casadi_copy(w9, 16, res[0]);
  /* #167: output[1][0] = @0 */
  casadi_copy(w0, 4, res[1]);
  return 0;
}

/* compass_limit_cycle_384:(u0[4],p[6])->(u[4],J[4x4],R[4]) */
static int casadi_f35(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *w0=w+406, *w1=w+410, *w2=w+416, *w3=w+420;
  const casadi_real **arg1=arg+2;
  /* #0: @0 = input[0][0] */
  casadi_copy(arg[0], 4, w0);
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 6, w1);
  /* #2: @2 = newton_384(@0, @1) */
  arg1[0]=w0;
  arg1[1]=w1;
  res1[0]=w2;
  if (casadi_f36(arg1, res1, iw, w, 0)) return 1;
  /* #3: output[0][0] = @2 */
  casadi_copy(w2, 4, res[0]);
  /* #4: {@3, @0} = jacobian_384(@2, @1) */
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

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f35(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 14;
  if (sz_res) *sz_res = 8;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 436;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_limit_cycle_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 14*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 8*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 436*sizeof(casadi_real);
  return 0;
}

/* working_step:(t,w[5],h,p[6])->(w_end[5]) */
static int casadi_f41(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81;
  a00=arg[1]? arg[1][0] : 0;
  a01=5.4293734116568765e-02;
  a02=arg[2]? arg[2][0] : 0;
  a01=(a01*a02);
  a03=arg[1]? arg[1][2] : 0;
  a04=(a01*a03);
  a05=4.4503128927524092e+00;
  a05=(a05*a02);
  a06=3.7037037037037035e-02;
  a06=(a06*a02);
  a07=arg[3]? arg[3][1] : 0;
  a08=arg[1]? arg[1][3] : 0;
  a09=(a07*a08);
  a10=arg[1]? arg[1][1] : 0;
  a11=sin(a10);
  a09=(a09*a11);
  a12=(2.*a03);
  a12=(a08-a12);
  a09=(a09*a12);
  a12=sin(a00);
  a13=(a00-a10);
  a13=sin(a13);
  a14=(a12-a13);
  a14=(a07*a14);
  a09=(a09+a14);
  a09=(a09+a12);
  a12=(2.*a07);
  a14=1.;
  a15=cos(a10);
  a16=(a14-a15);
  a16=(a12*a16);
  a16=(a16+a14);
  a17=(a09/a16);
  a15=(a15-a14);
  a15=(a07*a15);
  a16=(a15/a16);
  a18=casadi_sq(a03);
  a18=(a18*a11);
  a18=(a18+a13);
  a18=(a07*a18);
  a13=arg[3]? arg[3][3] : 0;
  a11=arg[3]? arg[3][5] : 0;
  a19=arg[3]? arg[3][0] : 0;
  a20=(a11*a19);
  a21=arg[0]? arg[0][0] : 0;
  a22=(a19*a21);
  a23=sin(a22);
  a23=(a20*a23);
  a23=(a08+a23);
  a23=(a13*a23);
  a24=arg[3]? arg[3][2] : 0;
  a25=arg[3]? arg[3][4] : 0;
  a22=cos(a22);
  a22=(a22+a14);
  a22=(a11*a22);
  a22=(a25-a22);
  a22=(a22+a10);
  a22=(a24*a22);
  a23=(a23+a22);
  a18=(a18-a23);
  a09=(a16*a09);
  a18=(a18-a09);
  a15=(a15*a16);
  a15=(a07-a15);
  a18=(a18/a15);
  a16=(a16*a18);
  a17=(a17-a16);
  a16=(a06*a17);
  a15=1.7082860872947386e-01;
  a15=(a15*a02);
  a09=2.9587585476806851e-02;
  a09=(a09*a02);
  a22=(a09*a18);
  a26=8.8762756430420545e-02;
  a26=(a26*a02);
  a27=1.9725056984537900e-02;
  a27=(a27*a02);
  a28=(a27*a17);
  a29=5.9175170953613701e-02;
  a29=(a29*a02);
  a30=5.2600151958767730e-02;
  a30=(a30*a02);
  a31=(a30*a18);
  a31=(a08+a31);
  a32=(a07*a31);
  a33=(a30*a08);
  a33=(a10+a33);
  a34=sin(a33);
  a32=(a32*a34);
  a35=(a30*a17);
  a35=(a03+a35);
  a36=(2.*a35);
  a36=(a31-a36);
  a32=(a32*a36);
  a36=(a30*a03);
  a36=(a00+a36);
  a37=sin(a36);
  a36=(a36-a33);
  a36=sin(a36);
  a38=(a37-a36);
  a38=(a07*a38);
  a32=(a32+a38);
  a32=(a32+a37);
  a37=cos(a33);
  a38=(a14-a37);
  a38=(a12*a38);
  a38=(a38+a14);
  a39=(a32/a38);
  a37=(a37-a14);
  a37=(a07*a37);
  a38=(a37/a38);
  a40=casadi_sq(a35);
  a40=(a40*a34);
  a40=(a40+a36);
  a40=(a07*a40);
  a30=(a21+a30);
  a30=(a19*a30);
  a36=sin(a30);
  a36=(a20*a36);
  a36=(a31+a36);
  a36=(a13*a36);
  a30=cos(a30);
  a30=(a30+a14);
  a30=(a11*a30);
  a30=(a25-a30);
  a30=(a30+a33);
  a30=(a24*a30);
  a36=(a36+a30);
  a40=(a40-a36);
  a32=(a38*a32);
  a40=(a40-a32);
  a37=(a37*a38);
  a37=(a07-a37);
  a40=(a40/a37);
  a38=(a38*a40);
  a39=(a39-a38);
  a39=(a29*a39);
  a28=(a28+a39);
  a28=(a03+a28);
  a39=casadi_sq(a28);
  a38=(a27*a08);
  a31=(a29*a31);
  a38=(a38+a31);
  a38=(a10+a38);
  a31=sin(a38);
  a39=(a39*a31);
  a37=(a27*a03);
  a35=(a29*a35);
  a37=(a37+a35);
  a37=(a00+a37);
  a35=(a37-a38);
  a35=sin(a35);
  a39=(a39+a35);
  a39=(a07*a39);
  a27=(a27*a18);
  a29=(a29*a40);
  a27=(a27+a29);
  a27=(a08+a27);
  a29=7.8900227938151601e-02;
  a29=(a29*a02);
  a29=(a21+a29);
  a29=(a19*a29);
  a40=sin(a29);
  a40=(a20*a40);
  a40=(a27+a40);
  a40=(a13*a40);
  a29=cos(a29);
  a29=(a29+a14);
  a29=(a11*a29);
  a29=(a25-a29);
  a29=(a29+a38);
  a29=(a24*a29);
  a40=(a40+a29);
  a39=(a39-a40);
  a38=cos(a38);
  a40=(a38-a14);
  a40=(a07*a40);
  a38=(a14-a38);
  a38=(a12*a38);
  a38=(a38+a14);
  a29=(a40/a38);
  a32=(a07*a27);
  a32=(a32*a31);
  a31=(2.*a28);
  a31=(a27-a31);
  a32=(a32*a31);
  a37=sin(a37);
  a35=(a37-a35);
  a35=(a07*a35);
  a32=(a32+a35);
  a32=(a32+a37);
  a37=(a29*a32);
  a39=(a39-a37);
  a40=(a40*a29);
  a40=(a07-a40);
  a39=(a39/a40);
  a40=(a26*a39);
  a22=(a22+a40);
  a22=(a08+a22);
  a40=(a07*a22);
  a37=(a09*a08);
  a35=(a26*a27);
  a37=(a37+a35);
  a37=(a10+a37);
  a35=sin(a37);
  a40=(a40*a35);
  a31=(a09*a17);
  a32=(a32/a38);
  a29=(a29*a39);
  a32=(a32-a29);
  a29=(a26*a32);
  a31=(a31+a29);
  a31=(a03+a31);
  a29=(2.*a31);
  a29=(a22-a29);
  a40=(a40*a29);
  a09=(a09*a03);
  a26=(a26*a28);
  a09=(a09+a26);
  a09=(a00+a09);
  a26=sin(a09);
  a09=(a09-a37);
  a09=sin(a09);
  a29=(a26-a09);
  a29=(a07*a29);
  a40=(a40+a29);
  a40=(a40+a26);
  a26=cos(a37);
  a29=(a14-a26);
  a29=(a12*a29);
  a29=(a29+a14);
  a38=(a40/a29);
  a26=(a26-a14);
  a26=(a07*a26);
  a29=(a26/a29);
  a36=casadi_sq(a31);
  a36=(a36*a35);
  a36=(a36+a09);
  a36=(a07*a36);
  a09=1.1835034190722740e-01;
  a09=(a09*a02);
  a09=(a21+a09);
  a09=(a19*a09);
  a35=sin(a09);
  a35=(a20*a35);
  a35=(a22+a35);
  a35=(a13*a35);
  a09=cos(a09);
  a09=(a09+a14);
  a09=(a11*a09);
  a09=(a25-a09);
  a09=(a09+a37);
  a09=(a24*a09);
  a35=(a35+a09);
  a36=(a36-a35);
  a40=(a29*a40);
  a36=(a36-a40);
  a26=(a26*a29);
  a26=(a07-a26);
  a36=(a36/a26);
  a29=(a29*a36);
  a38=(a38-a29);
  a29=(a15*a38);
  a16=(a16+a29);
  a29=1.2546768756682242e-01;
  a29=(a29*a02);
  a26=2.4136513415926669e-01;
  a26=(a26*a02);
  a40=(a26*a18);
  a35=-8.8454947932828609e-01;
  a35=(a35*a02);
  a39=(a35*a39);
  a40=(a40+a39);
  a39=9.2483400326179199e-01;
  a39=(a39*a02);
  a09=(a39*a36);
  a40=(a40+a09);
  a40=(a08+a40);
  a09=(a07*a40);
  a37=(a26*a08);
  a27=(a35*a27);
  a37=(a37+a27);
  a27=(a39*a22);
  a37=(a37+a27);
  a37=(a10+a37);
  a27=sin(a37);
  a09=(a09*a27);
  a30=(a26*a17);
  a32=(a35*a32);
  a30=(a30+a32);
  a32=(a39*a38);
  a30=(a30+a32);
  a30=(a03+a30);
  a32=(2.*a30);
  a32=(a40-a32);
  a09=(a09*a32);
  a26=(a26*a03);
  a35=(a35*a28);
  a26=(a26+a35);
  a39=(a39*a31);
  a26=(a26+a39);
  a26=(a00+a26);
  a39=sin(a26);
  a26=(a26-a37);
  a26=sin(a26);
  a35=(a39-a26);
  a35=(a07*a35);
  a09=(a09+a35);
  a09=(a09+a39);
  a39=cos(a37);
  a35=(a14-a39);
  a35=(a12*a35);
  a35=(a35+a14);
  a28=(a09/a35);
  a39=(a39-a14);
  a39=(a07*a39);
  a35=(a39/a35);
  a32=casadi_sq(a30);
  a32=(a32*a27);
  a32=(a32+a26);
  a32=(a07*a32);
  a26=2.8164965809277259e-01;
  a26=(a26*a02);
  a26=(a21+a26);
  a26=(a19*a26);
  a27=sin(a26);
  a27=(a20*a27);
  a27=(a40+a27);
  a27=(a13*a27);
  a26=cos(a26);
  a26=(a26+a14);
  a26=(a11*a26);
  a26=(a25-a26);
  a26=(a26+a37);
  a26=(a24*a26);
  a27=(a27+a26);
  a32=(a32-a27);
  a09=(a35*a09);
  a32=(a32-a09);
  a39=(a39*a35);
  a39=(a07-a39);
  a32=(a32/a39);
  a35=(a35*a32);
  a28=(a28-a35);
  a35=(a29*a28);
  a16=(a16+a35);
  a16=(a03+a16);
  a35=(a05*a16);
  a04=(a04+a35);
  a35=1.8915178993145003e+00;
  a35=(a35*a02);
  a39=3.7109375000000000e-02;
  a39=(a39*a02);
  a09=(a39*a17);
  a27=1.7025221101954405e-01;
  a27=(a27*a02);
  a26=(a27*a38);
  a09=(a09+a26);
  a26=6.0216538980455959e-02;
  a26=(a26*a02);
  a37=(a26*a28);
  a09=(a09+a37);
  a37=-1.7578125000000000e-02;
  a37=(a37*a02);
  a33=(a06*a18);
  a34=(a15*a36);
  a33=(a33+a34);
  a34=(a29*a32);
  a33=(a33+a34);
  a33=(a08+a33);
  a34=(a07*a33);
  a41=(a06*a08);
  a42=(a15*a22);
  a41=(a41+a42);
  a42=(a29*a40);
  a41=(a41+a42);
  a41=(a10+a41);
  a42=sin(a41);
  a34=(a34*a42);
  a43=(2.*a16);
  a43=(a33-a43);
  a34=(a34*a43);
  a06=(a06*a03);
  a15=(a15*a31);
  a06=(a06+a15);
  a29=(a29*a30);
  a06=(a06+a29);
  a06=(a00+a06);
  a29=sin(a06);
  a06=(a06-a41);
  a06=sin(a06);
  a15=(a29-a06);
  a15=(a07*a15);
  a34=(a34+a15);
  a34=(a34+a29);
  a29=cos(a41);
  a15=(a14-a29);
  a15=(a12*a15);
  a15=(a15+a14);
  a43=(a34/a15);
  a29=(a29-a14);
  a29=(a07*a29);
  a15=(a29/a15);
  a44=casadi_sq(a16);
  a44=(a44*a42);
  a44=(a44+a06);
  a44=(a07*a44);
  a06=3.3333333333333331e-01;
  a06=(a06*a02);
  a06=(a21+a06);
  a06=(a19*a06);
  a42=sin(a06);
  a42=(a20*a42);
  a42=(a33+a42);
  a42=(a13*a42);
  a06=cos(a06);
  a06=(a06+a14);
  a06=(a11*a06);
  a06=(a25-a06);
  a06=(a06+a41);
  a06=(a24*a06);
  a42=(a42+a06);
  a44=(a44-a42);
  a34=(a15*a34);
  a44=(a44-a34);
  a29=(a29*a15);
  a29=(a07-a29);
  a44=(a44/a29);
  a15=(a15*a44);
  a43=(a43-a15);
  a15=(a37*a43);
  a09=(a09+a15);
  a09=(a03+a09);
  a15=(a35*a09);
  a04=(a04+a15);
  a15=-5.8012039600105849e+00;
  a15=(a15*a02);
  a29=3.7092000118504789e-02;
  a29=(a29*a02);
  a34=(a29*a17);
  a06=1.7038392571223998e-01;
  a06=(a06*a02);
  a41=(a06*a38);
  a34=(a34+a41);
  a41=1.0726203044637328e-01;
  a41=(a41*a02);
  a45=(a41*a28);
  a34=(a34+a45);
  a45=-1.5319437748624402e-02;
  a45=(a45*a02);
  a46=(a45*a43);
  a34=(a34+a46);
  a46=8.2737891638140233e-03;
  a46=(a46*a02);
  a47=(a39*a18);
  a48=(a27*a36);
  a47=(a47+a48);
  a48=(a26*a32);
  a47=(a47+a48);
  a48=(a37*a44);
  a47=(a47+a48);
  a47=(a08+a47);
  a48=(a07*a47);
  a49=(a39*a08);
  a50=(a27*a22);
  a49=(a49+a50);
  a50=(a26*a40);
  a49=(a49+a50);
  a50=(a37*a33);
  a49=(a49+a50);
  a49=(a10+a49);
  a50=sin(a49);
  a48=(a48*a50);
  a51=(2.*a09);
  a51=(a47-a51);
  a48=(a48*a51);
  a39=(a39*a03);
  a27=(a27*a31);
  a39=(a39+a27);
  a26=(a26*a30);
  a39=(a39+a26);
  a37=(a37*a16);
  a39=(a39+a37);
  a39=(a00+a39);
  a37=sin(a39);
  a39=(a39-a49);
  a39=sin(a39);
  a26=(a37-a39);
  a26=(a07*a26);
  a48=(a48+a26);
  a48=(a48+a37);
  a37=cos(a49);
  a26=(a14-a37);
  a26=(a12*a26);
  a26=(a26+a14);
  a27=(a48/a26);
  a37=(a37-a14);
  a37=(a07*a37);
  a26=(a37/a26);
  a51=casadi_sq(a09);
  a51=(a51*a50);
  a51=(a51+a39);
  a51=(a07*a51);
  a39=2.5000000000000000e-01;
  a39=(a39*a02);
  a39=(a21+a39);
  a39=(a19*a39);
  a50=sin(a39);
  a50=(a20*a50);
  a50=(a47+a50);
  a50=(a13*a50);
  a39=cos(a39);
  a39=(a39+a14);
  a39=(a11*a39);
  a39=(a25-a39);
  a39=(a39+a49);
  a39=(a24*a39);
  a50=(a50+a39);
  a51=(a51-a50);
  a48=(a26*a48);
  a51=(a51-a48);
  a37=(a37*a26);
  a37=(a07-a37);
  a51=(a51/a37);
  a26=(a26*a51);
  a27=(a27-a26);
  a26=(a46*a27);
  a34=(a34+a26);
  a34=(a03+a34);
  a26=(a15*a34);
  a04=(a04+a26);
  a26=3.1116436695781990e-01;
  a26=(a26*a02);
  a37=6.2411095871607569e-01;
  a37=(a37*a02);
  a48=(a37*a17);
  a39=-3.3608926294469414e+00;
  a39=(a39*a02);
  a49=(a39*a38);
  a48=(a48+a49);
  a49=-8.6821934684172597e-01;
  a49=(a49*a02);
  a52=(a49*a28);
  a48=(a48+a52);
  a52=2.7592099699446710e+01;
  a52=(a52*a02);
  a53=(a52*a43);
  a48=(a48+a53);
  a53=2.0154067550477894e+01;
  a53=(a53*a02);
  a54=(a53*a27);
  a48=(a48+a54);
  a54=-4.3489884181069961e+01;
  a54=(a54*a02);
  a55=(a29*a18);
  a56=(a06*a36);
  a55=(a55+a56);
  a56=(a41*a32);
  a55=(a55+a56);
  a56=(a45*a44);
  a55=(a55+a56);
  a56=(a46*a51);
  a55=(a55+a56);
  a55=(a08+a55);
  a56=(a07*a55);
  a57=(a29*a08);
  a58=(a06*a22);
  a57=(a57+a58);
  a58=(a41*a40);
  a57=(a57+a58);
  a58=(a45*a33);
  a57=(a57+a58);
  a58=(a46*a47);
  a57=(a57+a58);
  a57=(a10+a57);
  a58=sin(a57);
  a56=(a56*a58);
  a59=(2.*a34);
  a59=(a55-a59);
  a56=(a56*a59);
  a29=(a29*a03);
  a06=(a06*a31);
  a29=(a29+a06);
  a41=(a41*a30);
  a29=(a29+a41);
  a45=(a45*a16);
  a29=(a29+a45);
  a46=(a46*a09);
  a29=(a29+a46);
  a29=(a00+a29);
  a46=sin(a29);
  a29=(a29-a57);
  a29=sin(a29);
  a45=(a46-a29);
  a45=(a07*a45);
  a56=(a56+a45);
  a56=(a56+a46);
  a46=cos(a57);
  a45=(a14-a46);
  a45=(a12*a45);
  a45=(a45+a14);
  a41=(a56/a45);
  a46=(a46-a14);
  a46=(a07*a46);
  a45=(a46/a45);
  a06=casadi_sq(a34);
  a06=(a06*a58);
  a06=(a06+a29);
  a06=(a07*a06);
  a29=3.0769230769230771e-01;
  a29=(a29*a02);
  a29=(a21+a29);
  a29=(a19*a29);
  a58=sin(a29);
  a58=(a20*a58);
  a58=(a55+a58);
  a58=(a13*a58);
  a29=cos(a29);
  a29=(a29+a14);
  a29=(a11*a29);
  a29=(a25-a29);
  a29=(a29+a57);
  a29=(a24*a29);
  a58=(a58+a29);
  a06=(a06-a58);
  a56=(a45*a56);
  a06=(a06-a56);
  a46=(a46*a45);
  a46=(a07-a46);
  a06=(a06/a46);
  a45=(a45*a06);
  a41=(a41-a45);
  a45=(a54*a41);
  a48=(a48+a45);
  a48=(a03+a48);
  a45=(a26*a48);
  a04=(a04+a45);
  a45=-1.5216094966251609e-01;
  a45=(a45*a02);
  a46=4.7766253643826434e-01;
  a46=(a46*a02);
  a56=(a46*a17);
  a29=-2.4881146199716677e+00;
  a29=(a29*a02);
  a57=(a29*a38);
  a56=(a56+a57);
  a57=-5.9029082683684297e-01;
  a57=(a57*a02);
  a59=(a57*a28);
  a56=(a56+a59);
  a59=2.1230051448181193e+01;
  a59=(a59*a02);
  a60=(a59*a43);
  a56=(a56+a60);
  a60=1.5279233632882423e+01;
  a60=(a60*a02);
  a61=(a60*a27);
  a56=(a56+a61);
  a61=-3.3288210968984863e+01;
  a61=(a61*a02);
  a62=(a61*a41);
  a56=(a56+a62);
  a62=-2.0331201708508627e-02;
  a62=(a62*a02);
  a63=(a37*a18);
  a64=(a39*a36);
  a63=(a63+a64);
  a64=(a49*a32);
  a63=(a63+a64);
  a64=(a52*a44);
  a63=(a63+a64);
  a64=(a53*a51);
  a63=(a63+a64);
  a64=(a54*a06);
  a63=(a63+a64);
  a63=(a08+a63);
  a64=(a07*a63);
  a65=(a37*a08);
  a66=(a39*a22);
  a65=(a65+a66);
  a66=(a49*a40);
  a65=(a65+a66);
  a66=(a52*a33);
  a65=(a65+a66);
  a66=(a53*a47);
  a65=(a65+a66);
  a66=(a54*a55);
  a65=(a65+a66);
  a65=(a10+a65);
  a66=sin(a65);
  a64=(a64*a66);
  a67=(2.*a48);
  a67=(a63-a67);
  a64=(a64*a67);
  a37=(a37*a03);
  a39=(a39*a31);
  a37=(a37+a39);
  a49=(a49*a30);
  a37=(a37+a49);
  a52=(a52*a16);
  a37=(a37+a52);
  a53=(a53*a09);
  a37=(a37+a53);
  a54=(a54*a34);
  a37=(a37+a54);
  a37=(a00+a37);
  a54=sin(a37);
  a37=(a37-a65);
  a37=sin(a37);
  a53=(a54-a37);
  a53=(a07*a53);
  a64=(a64+a53);
  a64=(a64+a54);
  a54=cos(a65);
  a53=(a14-a54);
  a53=(a12*a53);
  a53=(a53+a14);
  a52=(a64/a53);
  a54=(a54-a14);
  a54=(a07*a54);
  a53=(a54/a53);
  a49=casadi_sq(a48);
  a49=(a49*a66);
  a49=(a49+a37);
  a49=(a07*a49);
  a37=6.5128205128205130e-01;
  a37=(a37*a02);
  a37=(a21+a37);
  a37=(a19*a37);
  a66=sin(a37);
  a66=(a20*a66);
  a66=(a63+a66);
  a66=(a13*a66);
  a37=cos(a37);
  a37=(a37+a14);
  a37=(a11*a37);
  a37=(a25-a37);
  a37=(a37+a65);
  a37=(a24*a37);
  a66=(a66+a37);
  a49=(a49-a66);
  a64=(a53*a64);
  a49=(a49-a64);
  a54=(a54*a53);
  a54=(a07-a54);
  a49=(a49/a54);
  a53=(a53*a49);
  a52=(a52-a53);
  a53=(a62*a52);
  a56=(a56+a53);
  a56=(a03+a56);
  a53=(a45*a56);
  a04=(a04+a53);
  a53=2.0136540080403034e-01;
  a53=(a53*a02);
  a54=-9.3714243008598730e-01;
  a54=(a54*a02);
  a64=(a54*a17);
  a37=5.1863724288440638e+00;
  a37=(a37*a02);
  a65=(a37*a38);
  a64=(a64+a65);
  a65=1.0914373489967295e+00;
  a65=(a65*a02);
  a39=(a65*a28);
  a64=(a64+a39);
  a39=-8.1497870107469268e+00;
  a39=(a39*a02);
  a67=(a39*a43);
  a64=(a64+a67);
  a67=-1.8520065659996959e+01;
  a67=(a67*a02);
  a68=(a67*a27);
  a64=(a64+a68);
  a68=2.2739487099350505e+01;
  a68=(a68*a02);
  a69=(a68*a41);
  a64=(a64+a69);
  a69=2.4936055526796523e+00;
  a69=(a69*a02);
  a70=(a69*a52);
  a64=(a64+a70);
  a70=-3.0467644718982196e+00;
  a70=(a70*a02);
  a71=(a46*a18);
  a72=(a29*a36);
  a71=(a71+a72);
  a72=(a57*a32);
  a71=(a71+a72);
  a72=(a59*a44);
  a71=(a71+a72);
  a72=(a60*a51);
  a71=(a71+a72);
  a72=(a61*a06);
  a71=(a71+a72);
  a72=(a62*a49);
  a71=(a71+a72);
  a71=(a08+a71);
  a72=(a07*a71);
  a73=(a46*a08);
  a74=(a29*a22);
  a73=(a73+a74);
  a74=(a57*a40);
  a73=(a73+a74);
  a74=(a59*a33);
  a73=(a73+a74);
  a74=(a60*a47);
  a73=(a73+a74);
  a74=(a61*a55);
  a73=(a73+a74);
  a74=(a62*a63);
  a73=(a73+a74);
  a73=(a10+a73);
  a74=sin(a73);
  a72=(a72*a74);
  a75=(2.*a56);
  a75=(a71-a75);
  a72=(a72*a75);
  a46=(a46*a03);
  a29=(a29*a31);
  a46=(a46+a29);
  a57=(a57*a30);
  a46=(a46+a57);
  a59=(a59*a16);
  a46=(a46+a59);
  a60=(a60*a09);
  a46=(a46+a60);
  a61=(a61*a34);
  a46=(a46+a61);
  a62=(a62*a48);
  a46=(a46+a62);
  a46=(a00+a46);
  a62=sin(a46);
  a46=(a46-a73);
  a46=sin(a46);
  a61=(a62-a46);
  a61=(a07*a61);
  a72=(a72+a61);
  a72=(a72+a62);
  a62=cos(a73);
  a61=(a14-a62);
  a61=(a12*a61);
  a61=(a61+a14);
  a60=(a72/a61);
  a62=(a62-a14);
  a62=(a07*a62);
  a61=(a62/a61);
  a59=casadi_sq(a56);
  a59=(a59*a74);
  a59=(a59+a46);
  a59=(a07*a59);
  a46=5.9999999999999998e-01;
  a46=(a46*a02);
  a46=(a21+a46);
  a46=(a19*a46);
  a74=sin(a46);
  a74=(a20*a74);
  a74=(a71+a74);
  a74=(a13*a74);
  a46=cos(a46);
  a46=(a46+a14);
  a46=(a11*a46);
  a46=(a25-a46);
  a46=(a46+a73);
  a46=(a24*a46);
  a74=(a74+a46);
  a59=(a59-a74);
  a72=(a61*a72);
  a59=(a59-a72);
  a62=(a62*a61);
  a62=(a07-a62);
  a59=(a59/a62);
  a61=(a61*a59);
  a60=(a60-a61);
  a61=(a70*a60);
  a64=(a64+a61);
  a64=(a03+a64);
  a61=(a53*a64);
  a04=(a04+a61);
  a61=4.4710615727772587e-02;
  a61=(a61*a02);
  a62=2.2733101475165380e+00;
  a62=(a62*a02);
  a72=(a62*a17);
  a46=-1.0534495466737249e+01;
  a46=(a46*a02);
  a38=(a46*a38);
  a72=(a72+a38);
  a38=-2.0008720582248625e+00;
  a38=(a38*a02);
  a28=(a38*a28);
  a72=(a72+a28);
  a28=-1.7958931863118799e+01;
  a28=(a28*a02);
  a73=(a28*a43);
  a72=(a72+a73);
  a73=2.7948884529419960e+01;
  a73=(a73*a02);
  a57=(a73*a27);
  a72=(a72+a57);
  a57=-2.8589982771350235e+00;
  a57=(a57*a02);
  a29=(a57*a41);
  a72=(a72+a29);
  a29=-8.8728569335306293e+00;
  a29=(a29*a02);
  a75=(a29*a52);
  a72=(a72+a75);
  a75=1.2360567175794303e+01;
  a75=(a75*a02);
  a76=(a75*a60);
  a72=(a72+a76);
  a76=6.4339274601576357e-01;
  a76=(a76*a02);
  a77=(a54*a18);
  a78=(a37*a36);
  a77=(a77+a78);
  a78=(a65*a32);
  a77=(a77+a78);
  a78=(a39*a44);
  a77=(a77+a78);
  a78=(a67*a51);
  a77=(a77+a78);
  a78=(a68*a06);
  a77=(a77+a78);
  a78=(a69*a49);
  a77=(a77+a78);
  a78=(a70*a59);
  a77=(a77+a78);
  a77=(a08+a77);
  a78=(a07*a77);
  a79=(a54*a08);
  a80=(a37*a22);
  a79=(a79+a80);
  a80=(a65*a40);
  a79=(a79+a80);
  a80=(a39*a33);
  a79=(a79+a80);
  a80=(a67*a47);
  a79=(a79+a80);
  a80=(a68*a55);
  a79=(a79+a80);
  a80=(a69*a63);
  a79=(a79+a80);
  a80=(a70*a71);
  a79=(a79+a80);
  a79=(a10+a79);
  a80=sin(a79);
  a78=(a78*a80);
  a81=(2.*a64);
  a81=(a77-a81);
  a78=(a78*a81);
  a54=(a54*a03);
  a37=(a37*a31);
  a54=(a54+a37);
  a65=(a65*a30);
  a54=(a54+a65);
  a39=(a39*a16);
  a54=(a54+a39);
  a67=(a67*a09);
  a54=(a54+a67);
  a68=(a68*a34);
  a54=(a54+a68);
  a69=(a69*a48);
  a54=(a54+a69);
  a70=(a70*a56);
  a54=(a54+a70);
  a54=(a00+a54);
  a70=sin(a54);
  a54=(a54-a79);
  a54=sin(a54);
  a69=(a70-a54);
  a69=(a07*a69);
  a78=(a78+a69);
  a78=(a78+a70);
  a70=cos(a79);
  a69=(a14-a70);
  a69=(a12*a69);
  a69=(a69+a14);
  a68=(a78/a69);
  a70=(a70-a14);
  a70=(a07*a70);
  a69=(a70/a69);
  a67=casadi_sq(a64);
  a67=(a67*a80);
  a67=(a67+a54);
  a67=(a07*a67);
  a54=8.5714285714285710e-01;
  a54=(a54*a02);
  a54=(a21+a54);
  a54=(a19*a54);
  a80=sin(a54);
  a80=(a20*a80);
  a80=(a77+a80);
  a80=(a13*a80);
  a54=cos(a54);
  a54=(a54+a14);
  a54=(a11*a54);
  a54=(a25-a54);
  a54=(a54+a79);
  a54=(a24*a54);
  a80=(a80+a54);
  a67=(a67-a80);
  a78=(a69*a78);
  a67=(a67-a78);
  a70=(a70*a69);
  a70=(a07-a70);
  a67=(a67/a70);
  a69=(a69*a67);
  a68=(a68-a69);
  a69=(a76*a68);
  a72=(a72+a69);
  a72=(a03+a72);
  a69=(a61*a72);
  a04=(a04+a69);
  a04=(a00+a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a08);
  a69=(a05*a33);
  a04=(a04+a69);
  a69=(a35*a47);
  a04=(a04+a69);
  a69=(a15*a55);
  a04=(a04+a69);
  a69=(a26*a63);
  a04=(a04+a69);
  a69=(a45*a71);
  a04=(a04+a69);
  a69=(a53*a77);
  a04=(a04+a69);
  a69=(a62*a18);
  a36=(a46*a36);
  a69=(a69+a36);
  a32=(a38*a32);
  a69=(a69+a32);
  a32=(a28*a44);
  a69=(a69+a32);
  a32=(a73*a51);
  a69=(a69+a32);
  a32=(a57*a06);
  a69=(a69+a32);
  a32=(a29*a49);
  a69=(a69+a32);
  a32=(a75*a59);
  a69=(a69+a32);
  a32=(a76*a67);
  a69=(a69+a32);
  a69=(a08+a69);
  a32=(a61*a69);
  a04=(a04+a32);
  a04=(a10+a04);
  if (res[0]!=0) res[0][1]=a04;
  a17=(a01*a17);
  a43=(a05*a43);
  a17=(a17+a43);
  a27=(a35*a27);
  a17=(a17+a27);
  a41=(a15*a41);
  a17=(a17+a41);
  a52=(a26*a52);
  a17=(a17+a52);
  a60=(a45*a60);
  a17=(a17+a60);
  a68=(a53*a68);
  a17=(a17+a68);
  a68=(a07*a69);
  a60=(a62*a08);
  a22=(a46*a22);
  a60=(a60+a22);
  a40=(a38*a40);
  a60=(a60+a40);
  a40=(a28*a33);
  a60=(a60+a40);
  a40=(a73*a47);
  a60=(a60+a40);
  a40=(a57*a55);
  a60=(a60+a40);
  a40=(a29*a63);
  a60=(a60+a40);
  a40=(a75*a71);
  a60=(a60+a40);
  a40=(a76*a77);
  a60=(a60+a40);
  a10=(a10+a60);
  a60=sin(a10);
  a68=(a68*a60);
  a40=(2.*a72);
  a40=(a69-a40);
  a68=(a68*a40);
  a62=(a62*a03);
  a46=(a46*a31);
  a62=(a62+a46);
  a38=(a38*a30);
  a62=(a62+a38);
  a28=(a28*a16);
  a62=(a62+a28);
  a73=(a73*a09);
  a62=(a62+a73);
  a57=(a57*a34);
  a62=(a62+a57);
  a29=(a29*a48);
  a62=(a62+a29);
  a75=(a75*a56);
  a62=(a62+a75);
  a76=(a76*a64);
  a62=(a62+a76);
  a00=(a00+a62);
  a62=sin(a00);
  a00=(a00-a10);
  a00=sin(a00);
  a76=(a62-a00);
  a76=(a07*a76);
  a68=(a68+a76);
  a68=(a68+a62);
  a62=cos(a10);
  a76=(a14-a62);
  a12=(a12*a76);
  a12=(a12+a14);
  a76=(a68/a12);
  a62=(a62-a14);
  a62=(a07*a62);
  a12=(a62/a12);
  a72=casadi_sq(a72);
  a72=(a72*a60);
  a72=(a72+a00);
  a72=(a07*a72);
  a21=(a21+a02);
  a19=(a19*a21);
  a21=sin(a19);
  a20=(a20*a21);
  a20=(a69+a20);
  a13=(a13*a20);
  a19=cos(a19);
  a19=(a19+a14);
  a11=(a11*a19);
  a25=(a25-a11);
  a25=(a25+a10);
  a24=(a24*a25);
  a13=(a13+a24);
  a72=(a72-a13);
  a68=(a12*a68);
  a72=(a72-a68);
  a62=(a62*a12);
  a07=(a07-a62);
  a72=(a72/a07);
  a12=(a12*a72);
  a76=(a76-a12);
  a76=(a61*a76);
  a17=(a17+a76);
  a03=(a03+a17);
  if (res[0]!=0) res[0][2]=a03;
  a18=(a01*a18);
  a44=(a05*a44);
  a18=(a18+a44);
  a51=(a35*a51);
  a18=(a18+a51);
  a06=(a15*a06);
  a18=(a18+a06);
  a49=(a26*a49);
  a18=(a18+a49);
  a59=(a45*a59);
  a18=(a18+a59);
  a67=(a53*a67);
  a18=(a18+a67);
  a72=(a61*a72);
  a18=(a18+a72);
  a18=(a08+a18);
  if (res[0]!=0) res[0][3]=a18;
  a18=arg[1]? arg[1][4] : 0;
  a23=(a23*a08);
  a01=(a01*a23);
  a42=(a42*a33);
  a05=(a05*a42);
  a01=(a01+a05);
  a50=(a50*a47);
  a35=(a35*a50);
  a01=(a01+a35);
  a58=(a58*a55);
  a15=(a15*a58);
  a01=(a01+a15);
  a66=(a66*a63);
  a26=(a26*a66);
  a01=(a01+a26);
  a74=(a74*a71);
  a45=(a45*a74);
  a01=(a01+a45);
  a80=(a80*a77);
  a53=(a53*a80);
  a01=(a01+a53);
  a13=(a13*a69);
  a61=(a61*a13);
  a01=(a01+a61);
  a18=(a18-a01);
  if (res[0]!=0) res[0][4]=a18;
  return 0;
}

/* observe:(t,y[4],p[6])->(g[8],dg[8]) */
static int casadi_f42(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57;
  a00=arg[2]? arg[2][3] : 0;
  a01=arg[1]? arg[1][3] : 0;
  a02=arg[2]? arg[2][5] : 0;
  a03=arg[2]? arg[2][0] : 0;
  a04=(a02*a03);
  a05=arg[0]? arg[0][0] : 0;
  a05=(a03*a05);
  a06=sin(a05);
  a07=(a04*a06);
  a07=(a01+a07);
  a07=(a00*a07);
  a08=arg[2]? arg[2][2] : 0;
  a09=arg[2]? arg[2][4] : 0;
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
  a12=arg[1]? arg[1][0] : 0;
  a13=(a12-a11);
  a14=sin(a13);
  a15=sin(a12);
  a16=(a14-a15);
  a16=(a09*a16);
  a16=(a16-a15);
  a17=(2.*a09);
  a18=(a17+a10);
  a19=(a16/a18);
  a20=cos(a12);
  a13=cos(a13);
  a21=(a20-a13);
  a22=(a09*a21);
  a22=(a22+a20);
  a22=(a22/a18);
  a23=(a09*a01);
  a24=sin(a11);
  a25=(a23*a24);
  a26=arg[1]? arg[1][2] : 0;
  a27=(2.*a26);
  a28=(a01-a27);
  a29=(a25*a28);
  a30=(a29-a16);
  a31=cos(a11);
  a32=(a10-a31);
  a32=(a17*a32);
  a32=(a32+a10);
  a33=(a30/a32);
  a34=(a31-a10);
  a34=(a09*a34);
  a35=(a34/a32);
  a36=casadi_sq(a26);
  a37=(a36*a24);
  a37=(a37+a14);
  a37=(a09*a37);
  a37=(a37-a07);
  a38=(a35*a30);
  a38=(a37-a38);
  a39=(a34*a35);
  a39=(a09-a39);
  a38=(a38/a39);
  a40=(a35*a38);
  a40=(a33-a40);
  a41=(a13-a20);
  a42=(a09*a41);
  a42=(a42-a20);
  a43=(a40*a42);
  a44=(a38*a09);
  a45=(a44*a13);
  a43=(a43-a45);
  a45=(a23*a14);
  a46=(a26-a01);
  a47=(a45*a46);
  a43=(a43+a47);
  a47=(a15-a14);
  a48=(a26*a47);
  a49=(a01*a14);
  a48=(a48+a49);
  a48=(a09*a48);
  a49=(a26*a15);
  a48=(a48+a49);
  a49=(a26*a48);
  a43=(a43+a49);
  a49=(a22*a43);
  a50=(a40*a16);
  a51=(a44*a14);
  a50=(a50-a51);
  a51=(a09*a13);
  a52=(a51*a01);
  a53=(a01-a26);
  a54=(a52*a53);
  a50=(a50+a54);
  a54=(a26*a41);
  a55=(a13*a01);
  a54=(a54-a55);
  a54=(a09*a54);
  a55=(a20*a26);
  a54=(a54-a55);
  a56=(a26*a54);
  a57=(a50+a56);
  a57=(a57+a18);
  a49=(a49/a57);
  a19=(a19-a49);
  a19=(-a19);
  if (res[0]!=0) res[0][1]=a19;
  a50=(a50+a17);
  a50=(a50+a56);
  a50=(a50+a10);
  if (res[0]!=0) res[0][2]=a50;
  a10=(a43/a50);
  if (res[0]!=0) res[0][3]=a10;
  if (res[0]!=0) res[0][4]=a21;
  a21=(a09*a47);
  a29=(a29+a21);
  a29=(a29+a15);
  a21=(a29/a32);
  a56=(a35*a29);
  a37=(a37-a56);
  a37=(a37/a39);
  a56=(a35*a37);
  a56=(a21-a56);
  if (res[0]!=0) res[0][5]=a56;
  a12=(2.*a12);
  a11=(a11-a12);
  if (res[0]!=0) res[0][6]=a11;
  a11=0.;
  if (res[0]!=0) res[0][7]=a11;
  a05=(a05*a03);
  a04=(a04*a05);
  a04=(a37+a04);
  a00=(a00*a04);
  a06=(a06*a03);
  a02=(a02*a06);
  a02=(a02+a01);
  a08=(a08*a02);
  a00=(a00+a08);
  a08=(a01*a00);
  a07=(a07*a37);
  a08=(a08+a07);
  a08=(-a08);
  if (res[1]!=0) res[1][0]=a08;
  a08=(a13*a46);
  a07=(a08-a55);
  a07=(a09*a07);
  a07=(a07-a55);
  a02=(a07/a18);
  a06=(a14*a46);
  a03=(a15*a26);
  a04=(a06-a03);
  a05=(a09*a04);
  a05=(a05-a03);
  a05=(a05/a18);
  a43=(a43*a05);
  a05=(a09*a37);
  a18=(a24*a05);
  a31=(a31*a01);
  a12=(a23*a31);
  a18=(a18+a12);
  a18=(a28*a18);
  a12=(2.*a56);
  a12=(a37-a12);
  a25=(a25*a12);
  a18=(a18+a25);
  a25=(a18-a07);
  a12=(a25/a32);
  a33=(a33/a32);
  a19=(a24*a01);
  a17=(a17*a19);
  a33=(a33*a17);
  a12=(a12-a33);
  a27=(a27*a56);
  a24=(a24*a27);
  a36=(a36*a31);
  a24=(a24+a36);
  a24=(a24+a08);
  a24=(a09*a24);
  a24=(a24-a00);
  a25=(a35*a25);
  a19=(a09*a19);
  a00=(a19/a32);
  a36=(a35/a32);
  a36=(a36*a17);
  a00=(a00+a36);
  a30=(a30*a00);
  a25=(a25-a30);
  a25=(a24-a25);
  a25=(a25/a39);
  a30=(a38/a39);
  a19=(a35*a19);
  a34=(a34*a00);
  a19=(a19+a34);
  a30=(a30*a19);
  a25=(a25-a30);
  a30=(a35*a25);
  a38=(a38*a00);
  a30=(a30-a38);
  a12=(a12-a30);
  a42=(a42*a12);
  a30=(a03-a06);
  a38=(a09*a30);
  a38=(a38+a03);
  a38=(a40*a38);
  a42=(a42+a38);
  a25=(a09*a25);
  a38=(a13*a25);
  a34=(a44*a06);
  a38=(a38-a34);
  a42=(a42-a38);
  a05=(a14*a05);
  a23=(a23*a08);
  a05=(a05+a23);
  a46=(a46*a05);
  a05=(a56-a37);
  a45=(a45*a05);
  a46=(a46+a45);
  a42=(a42+a46);
  a48=(a48*a56);
  a47=(a47*a56);
  a46=(a55-a08);
  a45=(a26*a46);
  a47=(a47+a45);
  a45=(a14*a37);
  a05=(a01*a08);
  a45=(a45+a05);
  a47=(a47+a45);
  a47=(a09*a47);
  a15=(a15*a56);
  a45=(a26*a55);
  a15=(a15+a45);
  a47=(a47+a15);
  a47=(a26*a47);
  a48=(a48+a47);
  a42=(a42+a48);
  a22=(a22*a42);
  a43=(a43+a22);
  a43=(a43/a57);
  a49=(a49/a57);
  a16=(a16*a12);
  a40=(a40*a07);
  a16=(a16+a40);
  a14=(a14*a25);
  a44=(a44*a08);
  a14=(a14+a44);
  a16=(a16-a14);
  a51=(a51*a37);
  a14=(a09*a06);
  a14=(a01*a14);
  a51=(a51-a14);
  a53=(a53*a51);
  a51=(a37-a56);
  a52=(a52*a51);
  a53=(a53+a52);
  a16=(a16+a53);
  a54=(a54*a56);
  a41=(a41*a56);
  a30=(a26*a30);
  a41=(a41+a30);
  a13=(a13*a37);
  a01=(a01*a06);
  a13=(a13-a01);
  a41=(a41-a13);
  a41=(a09*a41);
  a20=(a20*a56);
  a03=(a26*a03);
  a20=(a20-a03);
  a41=(a41-a20);
  a26=(a26*a41);
  a54=(a54+a26);
  a16=(a16+a54);
  a49=(a49*a16);
  a43=(a43-a49);
  a02=(a02-a43);
  a02=(-a02);
  if (res[1]!=0) res[1][1]=a02;
  if (res[1]!=0) res[1][2]=a16;
  a42=(a42/a50);
  a10=(a10/a50);
  a10=(a10*a16);
  a42=(a42-a10);
  if (res[1]!=0) res[1][3]=a42;
  if (res[1]!=0) res[1][4]=a04;
  a09=(a09*a46);
  a18=(a18+a09);
  a18=(a18+a55);
  a55=(a18/a32);
  a21=(a21/a32);
  a21=(a21*a17);
  a55=(a55-a21);
  a18=(a35*a18);
  a29=(a29*a00);
  a18=(a18-a29);
  a24=(a24-a18);
  a24=(a24/a39);
  a39=(a37/a39);
  a39=(a39*a19);
  a24=(a24-a39);
  a35=(a35*a24);
  a37=(a37*a00);
  a35=(a35-a37);
  a55=(a55-a35);
  if (res[1]!=0) res[1][5]=a55;
  if (res[1]!=0) res[1][6]=a28;
  if (res[1]!=0) res[1][7]=a11;
  return 0;
}

/* working_steps:(t,w[5],h,p[6])->(w_end[5],nodes[5x12],g[8x12],dg[8x12]) */
static int casadi_f40(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+4, *rr, w00, w01, w02, w03, w04, w05, w06, w07, w08, w09;
  casadi_real w10, w11, w12, *w13=w+82, *w14=w+87, *w15=w+93, *w16=w+98, *w17=w+103, *w18=w+108, *w19=w+113, *w20=w+118, *w21=w+123;
  casadi_real *w22=w+128, *w23=w+133, *w24=w+138, *w25=w+143, *w26=w+148, *w27=w+153, *w28=w+157, *w29=w+165, *w30=w+173, *w31=w+181, *w32=w+189, *w33=w+197;
  casadi_real *w34=w+205, *w35=w+213, *w36=w+221, *w37=w+229, *w38=w+237, *w39=w+245, *w40=w+253;
  const casadi_real **arg1=arg+4, *cs;
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
  casadi_copy(arg[1], 5, w13);
  /* #33: @14 = input[3][0] */
  casadi_copy(arg[3], 6, w14);
  /* #34: @15 = working_step(@0, @13, @2, @14) */
  arg1[0]=(&w00);
  arg1[1]=w13;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w15;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #35: @16 = working_step(@12, @15, @2, @14) */
  arg1[0]=(&w12);
  arg1[1]=w15;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w16;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #36: @17 = working_step(@11, @16, @2, @14) */
  arg1[0]=(&w11);
  arg1[1]=w16;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w17;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #37: @18 = working_step(@10, @17, @2, @14) */
  arg1[0]=(&w10);
  arg1[1]=w17;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w18;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #38: @19 = working_step(@9, @18, @2, @14) */
  arg1[0]=(&w09);
  arg1[1]=w18;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w19;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #39: @20 = working_step(@8, @19, @2, @14) */
  arg1[0]=(&w08);
  arg1[1]=w19;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w20;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #40: @21 = working_step(@7, @20, @2, @14) */
  arg1[0]=(&w07);
  arg1[1]=w20;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w21;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #41: @22 = working_step(@6, @21, @2, @14) */
  arg1[0]=(&w06);
  arg1[1]=w21;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w22;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #42: @23 = working_step(@5, @22, @2, @14) */
  arg1[0]=(&w05);
  arg1[1]=w22;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w23;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #43: @24 = working_step(@4, @23, @2, @14) */
  arg1[0]=(&w04);
  arg1[1]=w23;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w24;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #44: @25 = working_step(@3, @24, @2, @14) */
  arg1[0]=(&w03);
  arg1[1]=w24;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w25;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #45: @26 = working_step(@1, @25, @2, @14) */
  arg1[0]=(&w01);
  arg1[1]=w25;
  arg1[2]=(&w02);
  arg1[3]=w14;
  res1[0]=w26;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #46: output[0][0] = @26 */
  casadi_copy(w26, 5, res[0]);
  /* #47: output[1][0] = @13 */
  casadi_copy(w13, 5, res[1]);
  /* #48: output[1][1] = @15 */
  if (res[1]) casadi_copy(w15, 5, res[1]+5);
  /* #49: output[1][2] = @16 */
  if (res[1]) casadi_copy(w16, 5, res[1]+10);
  /* #50: output[1][3] = @17 */
  if (res[1]) casadi_copy(w17, 5, res[1]+15);
  /* #51: output[1][4] = @18 */
  if (res[1]) casadi_copy(w18, 5, res[1]+20);
  /* #52: output[1][5] = @19 */
  if (res[1]) casadi_copy(w19, 5, res[1]+25);
  /* #53: output[1][6] = @20 */
  if (res[1]) casadi_copy(w20, 5, res[1]+30);
  /* #54: output[1][7] = @21 */
  if (res[1]) casadi_copy(w21, 5, res[1]+35);
  /* #55: output[1][8] = @22 */
  if (res[1]) casadi_copy(w22, 5, res[1]+40);
  /* #56: output[1][9] = @23 */
  if (res[1]) casadi_copy(w23, 5, res[1]+45);
  /* #57: output[1][10] = @24 */
  if (res[1]) casadi_copy(w24, 5, res[1]+50);
  /* #58: output[1][11] = @25 */
  if (res[1]) casadi_copy(w25, 5, res[1]+55);
  /* #59: @27 = @13[:4] */
  for (rr=w27, cs=w13+0; cs!=w13+4; cs+=1) *rr++ = *cs;
  /* #60: {@28, @29} = observe(@0, @27, @14) */
  arg1[0]=(&w00);
  arg1[1]=w27;
  arg1[2]=w14;
  res1[0]=w28;
  res1[1]=w29;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #61: output[2][0] = @28 */
  casadi_copy(w28, 8, res[2]);
  /* #62: @1 = (@0+@2) */
  w01  = (w00+w02);
  /* #63: @27 = @15[:4] */
  for (rr=w27, cs=w15+0; cs!=w15+4; cs+=1) *rr++ = *cs;
  /* #64: {@28, @30} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
  res1[0]=w28;
  res1[1]=w30;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[2][1] = @28 */
  if (res[2]) casadi_copy(w28, 8, res[2]+8);
  /* #66: @1 = (2.*@2) */
  w01 = (2.* w02 );
  /* #67: @1 = (@0+@1) */
  w01  = (w00+w01);
  /* #68: @27 = @16[:4] */
  for (rr=w27, cs=w16+0; cs!=w16+4; cs+=1) *rr++ = *cs;
  /* #69: {@28, @31} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #74: @27 = @17[:4] */
  for (rr=w27, cs=w17+0; cs!=w17+4; cs+=1) *rr++ = *cs;
  /* #75: {@28, @32} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #80: @27 = @18[:4] */
  for (rr=w27, cs=w18+0; cs!=w18+4; cs+=1) *rr++ = *cs;
  /* #81: {@28, @33} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #86: @27 = @19[:4] */
  for (rr=w27, cs=w19+0; cs!=w19+4; cs+=1) *rr++ = *cs;
  /* #87: {@28, @34} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #92: @27 = @20[:4] */
  for (rr=w27, cs=w20+0; cs!=w20+4; cs+=1) *rr++ = *cs;
  /* #93: {@28, @35} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #98: @27 = @21[:4] */
  for (rr=w27, cs=w21+0; cs!=w21+4; cs+=1) *rr++ = *cs;
  /* #99: {@28, @36} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #104: @27 = @22[:4] */
  for (rr=w27, cs=w22+0; cs!=w22+4; cs+=1) *rr++ = *cs;
  /* #105: {@28, @37} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #110: @27 = @23[:4] */
  for (rr=w27, cs=w23+0; cs!=w23+4; cs+=1) *rr++ = *cs;
  /* #111: {@28, @38} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #116: @27 = @24[:4] */
  for (rr=w27, cs=w24+0; cs!=w24+4; cs+=1) *rr++ = *cs;
  /* #117: {@28, @39} = observe(@1, @27, @14) */
  arg1[0]=(&w01);
  arg1[1]=w27;
  arg1[2]=w14;
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
  /* #122: @27 = @25[:4] */
  for (rr=w27, cs=w25+0; cs!=w25+4; cs+=1) *rr++ = *cs;
  /* #123: {@28, @40} = observe(@0, @27, @14) */
  arg1[0]=(&w00);
  arg1[1]=w27;
  arg1[2]=w14;
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

/* compass_trace_48:(u[4],p[6])->(w[5x49],g[8x49],dg[8x49],R[4]) */
static int casadi_f39(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+274, *w02=w+278, *w03=w+281, w04, *w05=w+285, w06, *w07=w+290, *w08=w+296, *w09=w+301;
  casadi_real *w10=w+361, *w11=w+457, *w12=w+553, *w13=w+649, *w14=w+745, *w15=w+841, *w16=w+937, *w17=w+1033, *w18=w+1129, *w19=w+1137;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[:3] */
  for (rr=w02, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[3] */
  for (rr=(&w04), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #7: @6 = 48 */
  w06 = 48.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  casadi_copy(arg[1], 6, w07);
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 60, res[0]);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+60);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+120);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+180);
  /* #30: output[0][4] = @5 */
  if (res[0]) casadi_copy(w05, 5, res[0]+240);
  /* #31: output[1][0] = @10 */
  casadi_copy(w10, 96, res[1]);
  /* #32: output[1][1] = @12 */
  if (res[1]) casadi_copy(w12, 96, res[1]+96);
  /* #33: output[1][2] = @14 */
  if (res[1]) casadi_copy(w14, 96, res[1]+192);
  /* #34: output[1][3] = @16 */
  if (res[1]) casadi_copy(w16, 96, res[1]+288);
  /* #35: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #36: {@18, @19} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=w07;
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
  /* #43: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #44: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #45: output[3][0] = @3 */
  casadi_copy(w03, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_48(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f39(arg, res, iw, w, mem);
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
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1145;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_48_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1145*sizeof(casadi_real);
  return 0;
}

/* compass_trace_96:(u[4],p[6])->(w[5x97],g[8x97],dg[8x97],R[4]) */
static int casadi_f43(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+274, *w02=w+278, *w03=w+281, w04, *w05=w+285, w06, *w07=w+290, *w08=w+296, *w09=w+301;
  casadi_real *w10=w+361, *w11=w+457, *w12=w+553, *w13=w+649, *w14=w+745, *w15=w+841, *w16=w+937, *w17=w+1033, *w18=w+1129, *w19=w+1225, *w20=w+1321, *w21=w+1417;
  casadi_real *w22=w+1513, *w23=w+1609, *w24=w+1705, *w25=w+1801, *w26=w+1897, *w27=w+1905;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[:3] */
  for (rr=w02, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[3] */
  for (rr=(&w04), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #7: @6 = 96 */
  w06 = 96.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  casadi_copy(arg[1], 6, w07);
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 60, res[0]);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+60);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+120);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+180);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+240);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+300);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+360);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+420);
  /* #54: output[0][8] = @5 */
  if (res[0]) casadi_copy(w05, 5, res[0]+480);
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
  /* #63: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #64: {@26, @27} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=w07;
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
  /* #75: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #76: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[3][0] = @3 */
  casadi_copy(w03, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_96(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f43(arg, res, iw, w, mem);
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
    case 0: return casadi_s9;
    case 1: return casadi_s10;
    case 2: return casadi_s10;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_96_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 1913;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_96_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 1913*sizeof(casadi_real);
  return 0;
}

/* compass_trace_192:(u[4],p[6])->(w[5x193],g[8x193],dg[8x193],R[4]) */
static int casadi_f44(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+274, *w02=w+278, *w03=w+281, w04, *w05=w+285, w06, *w07=w+290, *w08=w+296, *w09=w+301;
  casadi_real *w10=w+361, *w11=w+457, *w12=w+553, *w13=w+649, *w14=w+745, *w15=w+841, *w16=w+937, *w17=w+1033, *w18=w+1129, *w19=w+1225, *w20=w+1321, *w21=w+1417;
  casadi_real *w22=w+1513, *w23=w+1609, *w24=w+1705, *w25=w+1801, *w26=w+1897, *w27=w+1993, *w28=w+2089, *w29=w+2185, *w30=w+2281, *w31=w+2377, *w32=w+2473, *w33=w+2569;
  casadi_real *w34=w+2665, *w35=w+2761, *w36=w+2857, *w37=w+2953, *w38=w+3049, *w39=w+3145, *w40=w+3241, *w41=w+3337, *w42=w+3433, *w43=w+3441;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[:3] */
  for (rr=w02, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[3] */
  for (rr=(&w04), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #7: @6 = 192 */
  w06 = 192.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  casadi_copy(arg[1], 6, w07);
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 60, res[0]);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+60);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+120);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+180);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+240);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+300);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+360);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+420);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+480);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+540);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #71: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+600);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+660);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+720);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+780);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+840);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+900);
  /* #102: output[0][16] = @5 */
  if (res[0]) casadi_copy(w05, 5, res[0]+960);
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
  /* #119: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #120: {@42, @43} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=w07;
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
  /* #139: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #140: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #141: output[3][0] = @3 */
  casadi_copy(w03, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_192(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f44(arg, res, iw, w, mem);
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
    case 0: return casadi_s11;
    case 1: return casadi_s12;
    case 2: return casadi_s12;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_192_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 3449;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_192_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 3449*sizeof(casadi_real);
  return 0;
}

/* compass_trace_384:(u[4],p[6])->(w[5x385],g[8x385],dg[8x385],R[4]) */
static int casadi_f45(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w00, *w01=w+274, *w02=w+278, *w03=w+281, w04, *w05=w+285, w06, *w07=w+290, *w08=w+296, *w09=w+301;
  casadi_real *w10=w+361, *w11=w+457, *w12=w+553, *w13=w+649, *w14=w+745, *w15=w+841, *w16=w+937, *w17=w+1033, *w18=w+1129, *w19=w+1225, *w20=w+1321, *w21=w+1417;
  casadi_real *w22=w+1513, *w23=w+1609, *w24=w+1705, *w25=w+1801, *w26=w+1897, *w27=w+1993, *w28=w+2089, *w29=w+2185, *w30=w+2281, *w31=w+2377, *w32=w+2473, *w33=w+2569;
  casadi_real *w34=w+2665, *w35=w+2761, *w36=w+2857, *w37=w+2953, *w38=w+3049, *w39=w+3145, *w40=w+3241, *w41=w+3337, *w42=w+3433, *w43=w+3529, *w44=w+3625, *w45=w+3721;
  casadi_real *w46=w+3817, *w47=w+3913, *w48=w+4009, *w49=w+4105, *w50=w+4201, *w51=w+4297, *w52=w+4393, *w53=w+4489, *w54=w+4585, *w55=w+4681, *w56=w+4777, *w57=w+4873;
  casadi_real *w58=w+4969, *w59=w+5065, *w60=w+5161, *w61=w+5257, *w62=w+5353, *w63=w+5449, *w64=w+5545, *w65=w+5641, *w66=w+5737, *w67=w+5833, *w68=w+5929, *w69=w+6025;
  casadi_real *w70=w+6121, *w71=w+6217, *w72=w+6313, *w73=w+6409, *w74=w+6505, *w75=w+6513;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w00 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w01);
  /* #2: @2 = @1[:3] */
  for (rr=w02, cs=w01+0; cs!=w01+3; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w02;
  res1[0]=w03;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w04 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w05;
  for (i=0, cs=w03; i<4; ++i) *rr++ = *cs++;
  *rr++ = w04;
  /* #6: @4 = @1[3] */
  for (rr=(&w04), cs=w01+3; cs!=w01+4; cs+=1) *rr++ = *cs;
  /* #7: @6 = 384 */
  w06 = 384.;
  /* #8: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #9: @7 = input[1][0] */
  casadi_copy(arg[1], 6, w07);
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w00);
  arg1[1]=w05;
  arg1[2]=(&w06);
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w10;
  res1[3]=w11;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w09, 60, res[0]);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w12;
  res1[3]=w13;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+60);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w14;
  res1[3]=w15;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+120);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w16;
  res1[3]=w17;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+180);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w18;
  res1[3]=w19;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+240);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w20;
  res1[3]=w21;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+300);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w22;
  res1[3]=w23;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+360);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w24;
  res1[3]=w25;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+420);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w26;
  res1[3]=w27;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][8] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+480);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w28;
  res1[3]=w29;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[0][9] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+540);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w30;
  res1[3]=w31;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #71: output[0][10] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+600);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w32;
  res1[3]=w33;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[0][11] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+660);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w34;
  res1[3]=w35;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[0][12] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+720);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w36;
  res1[3]=w37;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[0][13] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+780);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w38;
  res1[3]=w39;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[0][14] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+840);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w40;
  res1[3]=w41;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[0][15] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+900);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w42;
  res1[3]=w43;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #107: output[0][16] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+960);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w44;
  res1[3]=w45;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #113: output[0][17] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1020);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w46;
  res1[3]=w47;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #119: output[0][18] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1080);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w48;
  res1[3]=w49;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #125: output[0][19] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1140);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w50;
  res1[3]=w51;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #131: output[0][20] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1200);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w52;
  res1[3]=w53;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #137: output[0][21] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1260);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w54;
  res1[3]=w55;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #143: output[0][22] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1320);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w56;
  res1[3]=w57;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #149: output[0][23] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1380);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w58;
  res1[3]=w59;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #155: output[0][24] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1440);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w60;
  res1[3]=w61;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #161: output[0][25] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1500);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w62;
  res1[3]=w63;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #167: output[0][26] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1560);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w64;
  res1[3]=w65;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #173: output[0][27] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1620);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w66;
  res1[3]=w67;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #179: output[0][28] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1680);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w68;
  res1[3]=w69;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #185: output[0][29] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1740);
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
  arg1[3]=w07;
  res1[0]=w08;
  res1[1]=w09;
  res1[2]=w70;
  res1[3]=w71;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #191: output[0][30] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1800);
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
  arg1[3]=w07;
  res1[0]=w05;
  res1[1]=w09;
  res1[2]=w72;
  res1[3]=w73;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #197: output[0][31] = @9 */
  if (res[0]) casadi_copy(w09, 60, res[0]+1860);
  /* #198: output[0][32] = @5 */
  if (res[0]) casadi_copy(w05, 5, res[0]+1920);
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
  /* #231: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #232: {@74, @75} = observe(@4, @1, @7) */
  arg1[0]=(&w04);
  arg1[1]=w01;
  arg1[2]=w07;
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
  /* #267: @1 = @5[:4] */
  for (rr=w01, cs=w05+0; cs!=w05+4; cs+=1) *rr++ = *cs;
  /* #268: @3 = landing(@1, @2, @7) */
  arg1[0]=w01;
  arg1[1]=w02;
  arg1[2]=w07;
  res1[0]=w03;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #269: output[3][0] = @3 */
  casadi_copy(w03, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_384(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f45(arg, res, iw, w, mem);
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
    case 0: return casadi_s13;
    case 1: return casadi_s14;
    case 2: return casadi_s14;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_384_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 6521;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_384_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 6521*sizeof(casadi_real);
  return 0;
}

/* compass_trace_768:(u[4],p[6])->(w[5x769],g[8x769],dg[8x769],R[4]) */
static int casadi_f46(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_int i;
  casadi_real **res1=res+4, *rr, w000, *w001=w+274, *w002=w+278, *w003=w+281, w004, *w005=w+285, w006, *w007=w+290, *w008=w+296, *w009=w+301;
  casadi_real *w010=w+361, *w011=w+457, *w012=w+553, *w013=w+649, *w014=w+745, *w015=w+841, *w016=w+937, *w017=w+1033, *w018=w+1129, *w019=w+1225, *w020=w+1321, *w021=w+1417;
  casadi_real *w022=w+1513, *w023=w+1609, *w024=w+1705, *w025=w+1801, *w026=w+1897, *w027=w+1993, *w028=w+2089, *w029=w+2185, *w030=w+2281, *w031=w+2377, *w032=w+2473, *w033=w+2569;
  casadi_real *w034=w+2665, *w035=w+2761, *w036=w+2857, *w037=w+2953, *w038=w+3049, *w039=w+3145, *w040=w+3241, *w041=w+3337, *w042=w+3433, *w043=w+3529, *w044=w+3625, *w045=w+3721;
  casadi_real *w046=w+3817, *w047=w+3913, *w048=w+4009, *w049=w+4105, *w050=w+4201, *w051=w+4297, *w052=w+4393, *w053=w+4489, *w054=w+4585, *w055=w+4681, *w056=w+4777, *w057=w+4873;
  casadi_real *w058=w+4969, *w059=w+5065, *w060=w+5161, *w061=w+5257, *w062=w+5353, *w063=w+5449, *w064=w+5545, *w065=w+5641, *w066=w+5737, *w067=w+5833, *w068=w+5929, *w069=w+6025;
  casadi_real *w070=w+6121, *w071=w+6217, *w072=w+6313, *w073=w+6409, *w074=w+6505, *w075=w+6601, *w076=w+6697, *w077=w+6793, *w078=w+6889, *w079=w+6985, *w080=w+7081, *w081=w+7177;
  casadi_real *w082=w+7273, *w083=w+7369, *w084=w+7465, *w085=w+7561, *w086=w+7657, *w087=w+7753, *w088=w+7849, *w089=w+7945, *w090=w+8041, *w091=w+8137, *w092=w+8233, *w093=w+8329;
  casadi_real *w094=w+8425, *w095=w+8521, *w096=w+8617, *w097=w+8713, *w098=w+8809, *w099=w+8905, *w100=w+9001, *w101=w+9097, *w102=w+9193, *w103=w+9289, *w104=w+9385, *w105=w+9481;
  casadi_real *w106=w+9577, *w107=w+9673, *w108=w+9769, *w109=w+9865, *w110=w+9961, *w111=w+10057, *w112=w+10153, *w113=w+10249, *w114=w+10345, *w115=w+10441, *w116=w+10537, *w117=w+10633;
  casadi_real *w118=w+10729, *w119=w+10825, *w120=w+10921, *w121=w+11017, *w122=w+11113, *w123=w+11209, *w124=w+11305, *w125=w+11401, *w126=w+11497, *w127=w+11593, *w128=w+11689, *w129=w+11785;
  casadi_real *w130=w+11881, *w131=w+11977, *w132=w+12073, *w133=w+12169, *w134=w+12265, *w135=w+12361, *w136=w+12457, *w137=w+12553, *w138=w+12649, *w139=w+12657;
  const casadi_real **arg1=arg+2, *cs;
  /* #0: @0 = 0 */
  w000 = 0.;
  /* #1: @1 = input[0][0] */
  casadi_copy(arg[0], 4, w001);
  /* #2: @2 = @1[:3] */
  for (rr=w002, cs=w001+0; cs!=w001+3; cs+=1) *rr++ = *cs;
  /* #3: {@3, NULL} = start(@2) */
  arg1[0]=w002;
  res1[0]=w003;
  res1[1]=0;
  if (casadi_f3(arg1, res1, iw, w, 0)) return 1;
  /* #4: @4 = 0 */
  w004 = 0.;
  /* #5: @5 = vertcat(@3, @4) */
  rr=w005;
  for (i=0, cs=w003; i<4; ++i) *rr++ = *cs++;
  *rr++ = w004;
  /* #6: @4 = @1[3] */
  for (rr=(&w004), cs=w001+3; cs!=w001+4; cs+=1) *rr++ = *cs;
  /* #7: @6 = 768 */
  w006 = 768.;
  /* #8: @6 = (@4/@6) */
  w006  = (w004/w006);
  /* #9: @7 = input[1][0] */
  casadi_copy(arg[1], 6, w007);
  /* #10: {@8, @9, @10, @11} = working_steps(@0, @5, @6, @7) */
  arg1[0]=(&w000);
  arg1[1]=w005;
  arg1[2]=(&w006);
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w010;
  res1[3]=w011;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #11: output[0][0] = @9 */
  casadi_copy(w009, 60, res[0]);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w012;
  res1[3]=w013;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #17: output[0][1] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+60);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w014;
  res1[3]=w015;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #23: output[0][2] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+120);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w016;
  res1[3]=w017;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #29: output[0][3] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+180);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w018;
  res1[3]=w019;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #35: output[0][4] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+240);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w020;
  res1[3]=w021;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #41: output[0][5] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+300);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w022;
  res1[3]=w023;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #47: output[0][6] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+360);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w024;
  res1[3]=w025;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #53: output[0][7] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+420);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w026;
  res1[3]=w027;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #59: output[0][8] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+480);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w028;
  res1[3]=w029;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #65: output[0][9] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+540);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w030;
  res1[3]=w031;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #71: output[0][10] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+600);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w032;
  res1[3]=w033;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #77: output[0][11] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+660);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w034;
  res1[3]=w035;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #83: output[0][12] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+720);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w036;
  res1[3]=w037;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #89: output[0][13] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+780);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w038;
  res1[3]=w039;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #95: output[0][14] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+840);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w040;
  res1[3]=w041;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #101: output[0][15] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+900);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w042;
  res1[3]=w043;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #107: output[0][16] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+960);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w044;
  res1[3]=w045;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #113: output[0][17] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1020);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w046;
  res1[3]=w047;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #119: output[0][18] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1080);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w048;
  res1[3]=w049;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #125: output[0][19] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1140);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w050;
  res1[3]=w051;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #131: output[0][20] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1200);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w052;
  res1[3]=w053;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #137: output[0][21] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1260);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w054;
  res1[3]=w055;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #143: output[0][22] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1320);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w056;
  res1[3]=w057;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #149: output[0][23] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1380);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w058;
  res1[3]=w059;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #155: output[0][24] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1440);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w060;
  res1[3]=w061;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #161: output[0][25] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1500);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w062;
  res1[3]=w063;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #167: output[0][26] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1560);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w064;
  res1[3]=w065;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #173: output[0][27] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1620);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w066;
  res1[3]=w067;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #179: output[0][28] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1680);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w068;
  res1[3]=w069;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #185: output[0][29] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1740);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w070;
  res1[3]=w071;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #191: output[0][30] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1800);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w072;
  res1[3]=w073;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #197: output[0][31] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1860);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w074;
  res1[3]=w075;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #203: output[0][32] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1920);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w076;
  res1[3]=w077;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #209: output[0][33] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+1980);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w078;
  res1[3]=w079;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #215: output[0][34] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2040);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w080;
  res1[3]=w081;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #221: output[0][35] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2100);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w082;
  res1[3]=w083;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #227: output[0][36] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2160);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w084;
  res1[3]=w085;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #233: output[0][37] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2220);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w086;
  res1[3]=w087;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #239: output[0][38] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2280);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w088;
  res1[3]=w089;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #245: output[0][39] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2340);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w090;
  res1[3]=w091;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #251: output[0][40] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2400);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w092;
  res1[3]=w093;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #257: output[0][41] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2460);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w094;
  res1[3]=w095;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #263: output[0][42] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2520);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w096;
  res1[3]=w097;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #269: output[0][43] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2580);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w098;
  res1[3]=w099;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #275: output[0][44] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2640);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w100;
  res1[3]=w101;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #281: output[0][45] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2700);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w102;
  res1[3]=w103;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #287: output[0][46] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2760);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w104;
  res1[3]=w105;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #293: output[0][47] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2820);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w106;
  res1[3]=w107;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #299: output[0][48] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2880);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w108;
  res1[3]=w109;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #305: output[0][49] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+2940);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w110;
  res1[3]=w111;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #311: output[0][50] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3000);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w112;
  res1[3]=w113;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #317: output[0][51] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3060);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w114;
  res1[3]=w115;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #323: output[0][52] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3120);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w116;
  res1[3]=w117;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #329: output[0][53] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3180);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w118;
  res1[3]=w119;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #335: output[0][54] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3240);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w120;
  res1[3]=w121;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #341: output[0][55] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3300);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w122;
  res1[3]=w123;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #347: output[0][56] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3360);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w124;
  res1[3]=w125;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #353: output[0][57] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3420);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w126;
  res1[3]=w127;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #359: output[0][58] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3480);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w128;
  res1[3]=w129;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #365: output[0][59] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3540);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w130;
  res1[3]=w131;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #371: output[0][60] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3600);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w132;
  res1[3]=w133;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #377: output[0][61] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3660);
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
  arg1[3]=w007;
  res1[0]=w008;
  res1[1]=w009;
  res1[2]=w134;
  res1[3]=w135;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #383: output[0][62] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3720);
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
  arg1[3]=w007;
  res1[0]=w005;
  res1[1]=w009;
  res1[2]=w136;
  res1[3]=w137;
  if (casadi_f40(arg1, res1, iw, w, 0)) return 1;
  /* #389: output[0][63] = @9 */
  if (res[0]) casadi_copy(w009, 60, res[0]+3780);
  /* #390: output[0][64] = @5 */
  if (res[0]) casadi_copy(w005, 5, res[0]+3840);
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
  /* #455: @1 = @5[:4] */
  for (rr=w001, cs=w005+0; cs!=w005+4; cs+=1) *rr++ = *cs;
  /* #456: {@138, @139} = observe(@4, @1, @7) */
  arg1[0]=(&w004);
  arg1[1]=w001;
  arg1[2]=w007;
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
  /* #523: @1 = @5[:4] */
  for (rr=w001, cs=w005+0; cs!=w005+4; cs+=1) *rr++ = *cs;
  /* #524: @3 = landing(@1, @2, @7) */
  arg1[0]=w001;
  arg1[1]=w002;
  arg1[2]=w007;
  res1[0]=w003;
  if (casadi_f10(arg1, res1, iw, w, 0)) return 1;
  /* #525: output[3][0] = @3 */
  casadi_copy(w003, 4, res[3]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_768(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f46(arg, res, iw, w, mem);
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
    case 0: return casadi_s15;
    case 1: return casadi_s16;
    case 2: return casadi_s16;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_trace_768_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 10;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 12665;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_trace_768_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 10*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 12665*sizeof(casadi_real);
  return 0;
}

/* compass_advance:(t,w[5],h,p[6])->(w_end[5],g[8],dg[8]) */
static int casadi_f47(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real **res1=res+3, *rr, w0, *w1=w+82, w2, *w3=w+87, *w4=w+93, *w5=w+98, *w6=w+102, *w7=w+110;
  const casadi_real **arg1=arg+4, *cs;
  /* #0: @0 = input[0][0] */
  w0 = arg[0] ? arg[0][0] : 0;
  /* #1: @1 = input[1][0] */
  casadi_copy(arg[1], 5, w1);
  /* #2: @2 = input[2][0] */
  w2 = arg[2] ? arg[2][0] : 0;
  /* #3: @3 = input[3][0] */
  casadi_copy(arg[3], 6, w3);
  /* #4: @4 = working_step(@0, @1, @2, @3) */
  arg1[0]=(&w0);
  arg1[1]=w1;
  arg1[2]=(&w2);
  arg1[3]=w3;
  res1[0]=w4;
  if (casadi_f41(arg1, res1, iw, w, 0)) return 1;
  /* #5: output[0][0] = @4 */
  casadi_copy(w4, 5, res[0]);
  /* #6: @0 = (@0+@2) */
  w0 += w2;
  /* #7: @5 = @4[:4] */
  for (rr=w5, cs=w4+0; cs!=w4+4; cs+=1) *rr++ = *cs;
  /* #8: {@6, @7} = observe(@0, @5, @3) */
  arg1[0]=(&w0);
  arg1[1]=w5;
  arg1[2]=w3;
  res1[0]=w6;
  res1[1]=w7;
  if (casadi_f42(arg1, res1, iw, w, 0)) return 1;
  /* #9: output[1][0] = @6 */
  casadi_copy(w6, 8, res[1]);
  /* #10: output[2][0] = @7 */
  casadi_copy(w7, 8, res[2]);
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_advance(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f47(arg, res, iw, w, mem);
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
    case 0: return casadi_s17;
    case 1: return casadi_s18;
    case 2: return casadi_s17;
    case 3: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* compass_advance_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s18;
    case 1: return casadi_s19;
    case 2: return casadi_s19;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int compass_advance_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 118;
  return 0;
}

CASADI_SYMBOL_EXPORT int compass_advance_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 118*sizeof(casadi_real);
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
