# The progress callback: how a run that holds no GIL hears of Python again.

@cython.final
cdef class Watch:
    """What on_progress needs: the user's callback, and room for what it raised."""
    cdef object callback
    cdef object error

    def __init__(self, callback):
        self.callback = callback


cdef int on_progress(const emtr_progress* progress, void* user) noexcept with gil:
    # Always installed, with or without a user's callback: it is what makes Ctrl-C work.
    cdef Watch watch = <Watch>user
    try:
        PyErr_CheckSignals()
        if watch.callback is None:
            return 0
        stop = watch.callback(progress.stage.decode(), progress.iteration, progress.iterations,
                              progress.best_alpha, progress.best_beta)
        return 1 if stop else 0
    except BaseException as error:  # C cannot be unwound: finish() raises it again
        watch.error = error
        return 1
