# Views numpy arrays as an emtr_cloud, without a copy.

@cython.final
cdef class Rows:
    """Keeps an array's memory alive. The package guarantees the layout: two-dimensional, float32 or
    float64, each row contiguous, rows in ascending order without overlap."""
    cdef Py_buffer view
    cdef bint held
    cdef bint single
    cdef size_t stride

    def __init__(self, array):
        PyObject_GetBuffer(array, &self.view, PyBUF_STRIDES | PyBUF_FORMAT)
        self.held = True
        # The letter comes last; numpy puts a sign before it when the memory is unaligned.
        scalar = (<bytes>self.view.format)[-1:] if self.view.format != NULL else b""
        if self.view.ndim != 2 or scalar not in (b"f", b"d"):
            raise ValueError("a two-dimensional array of float32 or float64 is expected")
        self.single = scalar == b"f"
        packed = self.view.shape[1] * self.view.itemsize
        if self.view.shape[0] <= 1:  # the stride of a single row means nothing
            self.stride = packed
        elif self.view.strides[0] < packed or (
                self.view.shape[1] > 1 and self.view.strides[1] != self.view.itemsize):
            raise ValueError("an array with contiguous rows is expected")
        else:
            self.stride = self.view.strides[0]

    def __dealloc__(self):
        if self.held:
            PyBuffer_Release(&self.view)


@cython.final
cdef class CloudBuffer:
    """Points (n, 3), normals (n, 3) of the same type or None, features float32 (n, d) or None,
    colors float32 (n, 3) or None, intensity float32 (n, 1) or None."""
    cdef Rows points
    cdef Rows normals
    cdef Rows features
    cdef Rows colors
    cdef Rows intensity
    cdef emtr_cloud cloud

    def __init__(self, points, normals=None, features=None, colors=None, intensity=None,
                 bint keep_points=False):
        self.points = Rows(points)
        if self.points.view.shape[1] != 3:
            raise ValueError("a cloud of float32 or float64 with shape (n, 3) is expected")
        self.cloud.points = self.points.view.buf
        self.cloud.count = self.points.view.shape[0]
        self.cloud.scalar = EMTR_FLOAT32 if self.points.single else EMTR_FLOAT64
        self.cloud.stride = self.points.stride
        self.cloud.keep_points = keep_points
        if normals is not None:
            self.normals = self.beside(normals)
            if self.normals.view.shape[1] != 3 or self.normals.single != self.points.single:
                raise ValueError("normals of the type of the points, (n, 3), are expected")
            self.cloud.normals = self.normals.view.buf
            self.cloud.normal_stride = self.normals.stride
        if features is not None:
            self.features = self.beside(features)
            if not self.features.single:
                raise ValueError("features of float32 are expected")
            self.cloud.features = <const float*>self.features.view.buf
            self.cloud.feature_dimension = self.features.view.shape[1]
            self.cloud.feature_stride = self.features.stride
        if colors is not None:
            self.colors = self.channels(colors, 3)
            self.cloud.colors = <const float*>self.colors.view.buf
            self.cloud.color_stride = self.colors.stride
        if intensity is not None:
            self.intensity = self.channels(intensity, 1)
            self.cloud.intensities = <const float*>self.intensity.view.buf
            self.cloud.intensity_stride = self.intensity.stride

    cdef Rows channels(self, array, Py_ssize_t columns):
        cdef Rows rows = self.beside(array)
        if not rows.single or rows.view.shape[1] != columns:
            raise ValueError("colors (n, 3) and intensities (n, 1) of float32 are expected")
        return rows

    cdef Rows beside(self, array):
        cdef Rows rows = Rows(array)
        if rows.view.shape[0] != self.points.view.shape[0]:
            raise ValueError("as many rows as points are expected")
        return rows
