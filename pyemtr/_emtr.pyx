# cython: language_level=3, binding=True, embedsignature=False
"""The C library, as directly as Python can hold it. Private: what users call is in the package.

Arrays come and go by the buffer protocol, so the module is bound to no release of numpy.
"""
cimport cython
from pyemtr.c_emtr cimport *
from cpython.buffer cimport (
    PyBUF_FORMAT, PyBUF_ND, PyBUF_STRIDES, PyBUF_WRITABLE, PyBuffer_Release, PyObject_GetBuffer)
from cpython.exc cimport PyErr_CheckSignals

include "errors.pxi"
include "settings.pxi"
include "cloud.pxi"
include "progress.pxi"
include "outcome.pxi"
include "residuals.pxi"
include "prepared.pxi"
include "problem.pxi"


def version():
    """The library's version, "major.minor.patch"."""
    return emtr_version().decode()


def kernel_name():
    """The instruction set of the inner loops: "generic", "avx2" or "avx512".

    The fastest that the machine has, or what the variable EMTR_KERNEL asks for; results have the
    same bits with each. Raises ValueError when EMTR_KERNEL asks for what cannot run here.
    """
    cdef const char* name = emtr_kernel_name()
    if name is NULL:
        check(EMTR_ERROR_SETTING)
    return name.decode()


def register(source, target, Settings settings not None, callback):
    """emtr_register_cached: two CloudBuffers, the fields of a result as a dict.

    Either may be a Preprocessed.
    """
    cdef CloudBuffer a
    cdef CloudBuffer b
    cdef Watch watch = Watch(callback)
    cdef emtr_settings* chosen = &settings.values
    cdef emtr_result* result = NULL
    cdef emtr_status status
    cdef void* user = <void*>watch
    cdef emtr_preprocessed* kept_a = NULL
    cdef emtr_preprocessed* kept_b = NULL
    cdef const emtr_cloud* from_ = NULL
    cdef const emtr_cloud* to = NULL
    if isinstance(source, Preprocessed):
        kept_a = (<Preprocessed>source).prepared
    else:
        a = source
        from_ = &a.cloud
    if isinstance(target, Preprocessed):
        kept_b = (<Preprocessed>target).prepared
    else:
        b = target
        to = &b.cloud
    # What is not prepared yet is no use to anyone afterwards.
    cdef emtr_preprocessed** keep_a = NULL if kept_a == NULL else &kept_a
    cdef emtr_preprocessed** keep_b = NULL if kept_b == NULL else &kept_b
    with nogil:
        status = emtr_register_cached(from_, keep_a, to, keep_b, chosen, on_progress, user, &result)
    return finish(status, watch, result)
