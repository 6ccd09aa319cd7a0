/* Residuals in numbers of twice the digits, at arrays of points. Compiled after pairs.h and the kernels. */

typedef int (*Evaluate)(const Pair** arg, Pair** res, casadi_int* iw, Pair* w, int mem);
typedef int (*WorkSize)(casadi_int* arg, casadi_int* res, casadi_int* iw, casadi_int* w);

/* A kernel as the library shows it. */
struct Kernel {
    Evaluate evaluate;
    WorkSize work_size;
};

#define KERNEL(name) \
    extern "C" { extern const Kernel precise_##name; const Kernel precise_##name = {name, name##_work}; }

namespace {

/* Memory for n numbers. */
Pair* new_array(casadi_int n) { return (Pair*) aligned_alloc(sizeof(Doubles), (size_t) (n + 1) * sizeof(Pair)); }

} /* namespace */

/* A residual (u, p) -> R at n points. u, out: shape (n, nu). p: shape (n, np).
 * Returns 0, or 1 when there is no memory, or 2 when the kernel failed. */
extern "C" int precise_map(const Kernel* kernel, casadi_int n, casadi_int nu, casadi_int np, const double* u,
    const double* p, double* out)
{
    casadi_int n_arg, n_res, n_iw, n_w;
    kernel->work_size(&n_arg, &n_res, &n_iw, &n_w);
    const Pair** const arg = (const Pair**) malloc((size_t) n_arg * sizeof(Pair*));
    Pair** const res = (Pair**) malloc((size_t) n_res * sizeof(Pair*));
    casadi_int* const iw = (casadi_int*) malloc((size_t) (n_iw + 1) * sizeof(casadi_int));
    Pair *const w = new_array(n_w), *const point = new_array(2 * nu + np), *const residual = point + nu + np;
    int status = arg && res && iw && w && point ? 0 : 1;

    for (casadi_int i = 0; i < n && !status; i += LANES) {
        const int used = n - i < LANES ? (int) (n - i) : LANES;
        for (casadi_int k = 0; k < nu + np; k++) {
            point[k] = Pair(0.0);
            for (int lane = 0; lane < LANES; lane++) {
                const casadi_int at = i + (lane < used ? lane : used - 1); /* the last lanes repeat the last point */
                point[k].hi[lane] = k < nu ? u[at * nu + k] : p[at * np + k - nu];
            }
        }
        arg[0] = point;
        arg[1] = point + nu;
        res[0] = residual;
        status = kernel->evaluate(arg, res, iw, w, 0) ? 2 : 0;
        for (casadi_int k = 0; k < nu; k++)
            for (int lane = 0; lane < used; lane++) out[(i + lane) * nu + k] = residual[k].hi[lane];
    }
    free(arg); free(res); free(iw); free(w); free(point);
    return status;
}
