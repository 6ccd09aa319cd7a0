/* Derivatives of a residual in two directions, at arrays of points. Compiled after jets.h and the kernels. */

typedef int (*Evaluate)(const Jet** arg, Jet** res, casadi_int* iw, Jet* w, int mem);
typedef int (*WorkSize)(casadi_int* arg, casadi_int* res, casadi_int* iw, casadi_int* w);

/* A kernel as the library shows it. */
struct Kernel {
    Evaluate evaluate;
    WorkSize work_size;
};

#define KERNEL(name) \
    extern "C" { extern const Kernel directional_##name; const Kernel directional_##name = {name, name##_work}; }

namespace {

/* Memory for n things of a type that is as wide as the processor's vectors. */
template <class T> T* new_array(casadi_int n) { return (T*) aligned_alloc(sizeof(Lanes), (size_t) (n + 1) * sizeof(T)); }

void put(const double* from, casadi_int size, Jet* to, Lanes Jet::*part, int lane)
{
    for (casadi_int k = 0; k < size; k++) (to[k].*part).v[lane] = from[k];
}

} /* namespace */

/* A residual (u, p) -> R at n points with its derivatives in the directions a and b of (u, p).
 *
 * u: shape (n, nu). p: shape (n, np). a, b: shape (n, nu + np). out: R, DR[a], DR[b], D2R[a, b], shape (n, nu) each.
 * Returns 0, or 1 when there is no memory, or 2 when the kernel failed. */
extern "C" int directional_map(const Kernel* kernel, casadi_int n, casadi_int nu, casadi_int np, const double* u,
    const double* p, const double* a, const double* b, double* const* out)
{
    casadi_int n_arg, n_res, n_iw, n_w;
    kernel->work_size(&n_arg, &n_res, &n_iw, &n_w);
    const Jet** const arg = (const Jet**) malloc((size_t) n_arg * sizeof(Jet*));
    Jet** const res = (Jet**) malloc((size_t) n_res * sizeof(Jet*));
    casadi_int* const iw = (casadi_int*) malloc((size_t) (n_iw + 1) * sizeof(casadi_int));
    Jet *const w = new_array<Jet>(n_w), *const point = new_array<Jet>(2 * nu + np), *const residual = point + nu + np;
    Lanes Jet::*const parts[] = {&Jet::x, &Jet::a, &Jet::b, &Jet::ab};
    const casadi_int width = nu + np;
    int status = arg && res && iw && w && point ? 0 : 1;

    for (casadi_int k = 0; k < width && !status; k++) point[k] = Jet(0.0);
    for (casadi_int i = 0; i < n && !status; i += LANES) {
        const int used = n - i < LANES ? (int) (n - i) : LANES;
        for (int lane = 0; lane < LANES; lane++) {
            const casadi_int at = i + (lane < used ? lane : used - 1); /* the last lanes repeat the last point */
            put(u + at * nu, nu, point, &Jet::x, lane);
            put(p + at * np, np, point + nu, &Jet::x, lane);
            put(a + at * width, width, point, &Jet::a, lane);
            put(b + at * width, width, point, &Jet::b, lane);
        }
        arg[0] = point;
        arg[1] = point + nu;
        res[0] = residual;
        status = kernel->evaluate(arg, res, iw, w, 0) ? 2 : 0;
        for (int part = 0; part < 4; part++)
            for (casadi_int k = 0; k < nu; k++)
                for (int lane = 0; lane < used; lane++) out[part][(i + lane) * nu + k] = (residual[k].*parts[part]).v[lane];
    }
    free(arg); free(res); free(iw); free(w); free(point);
    return status;
}
