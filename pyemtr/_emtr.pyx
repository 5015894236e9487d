# cython: language_level=3, binding=True, embedsignature=False
"""Binds the C library to Python as directly as can be. Private: users call the package.

Arrays pass through the buffer protocol, so the module depends on no release of numpy.
"""
cimport cython
from pyemtr.c_emtr cimport *
from cpython.buffer cimport (
    PyBUF_FORMAT, PyBUF_ND, PyBUF_STRIDES, PyBUF_WRITABLE, PyBuffer_Release, PyObject_GetBuffer)
from cpython.exc cimport PyErr_CheckSignals
from libc.stdlib cimport free, malloc

include "errors.pxi"
include "settings.pxi"
include "cloud.pxi"
include "progress.pxi"
include "outcome.pxi"
include "residuals.pxi"
include "preprocessed.pxi"
include "problem.pxi"


def version():
    """Returns the library's version as "major.minor.patch"."""
    return emtr_version().decode()


def kernel_name():
    """Returns the instruction set of the inner loops: "generic", "avx2" or "avx512".

    It is the fastest that the machine has, or the one that the environment variable EMTR_KERNEL
    names. Results have the same bits with each. Raises ValueError when EMTR_KERNEL names one that
    this machine cannot run.
    """
    cdef const char* name = emtr_kernel_name()
    if name is NULL:
        check(EMTR_ERROR_SETTING)
    return name.decode()


def register(source, target, Settings settings not None, callback):
    """Registers two clouds by emtr_register_cached(); returns a result's fields as a dict.

    Each cloud is a CloudBuffer or a Preprocessed.
    """
    cdef CloudBuffer a
    cdef CloudBuffer b
    cdef Watch watch = Watch(callback)
    cdef emtr_settings* chosen = &settings.values
    cdef emtr_result* result = NULL
    cdef emtr_status status
    cdef void* user = <void*>watch
    cdef emtr_preprocessed* cached_a = NULL
    cdef emtr_preprocessed* cached_b = NULL
    cdef const emtr_cloud* from_ = NULL
    cdef const emtr_cloud* to = NULL
    if isinstance(source, Preprocessed):
        cached_a = (<Preprocessed>source).handle
    else:
        a = source
        from_ = &a.cloud
    if isinstance(target, Preprocessed):
        cached_b = (<Preprocessed>target).handle
    else:
        b = target
        to = &b.cloud
    # A null slot asks the library to keep nothing: nobody could use it after this call.
    cdef emtr_preprocessed** slot_a = NULL if cached_a == NULL else &cached_a
    cdef emtr_preprocessed** slot_b = NULL if cached_b == NULL else &cached_b
    with nogil:
        status = emtr_register_cached(from_, slot_a, to, slot_b, chosen, on_progress, user, &result)
    return finish(status, watch, result)
