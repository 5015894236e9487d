"""The types of the settings, for type checkers and editors; a test compares them with the table."""

from __future__ import annotations

from typing import Any, Literal, TypedDict, Union

Switch = Union[bool, Literal["on", "off"]]
When = Literal["off", "auto", "always"]
Scale = Union[Literal["fixed", "free", "bounded", "units"], float, tuple[float, float]]


class MethodSettings(TypedDict, total=False):
    """What :func:`pyemtr.settings` lists, but ``seed`` and ``threads``: any of them by name."""

    time_limit: float
    dense_points: int
    coarse_points: int
    sparse_points: int
    minimum_leaf_spacing: float
    maximum_leaf_growth: float
    leaf_ladder: Switch
    normal_radius: float
    feature_radius: float
    max_correspondences: int
    max_tims: int
    features: Literal["pcl", "simd"]
    seeds: int
    seed_threshold: float
    injected_seeds: int
    tau_factor: float
    inlier_threshold: float
    outlier_penalty: float
    scale_sparse: float
    scale_dense: float
    dense_reference: Literal["dense", "whole"]
    translation_bound: float
    population: int
    iterations: int
    stall_iterations: int
    inertia_start: float
    inertia_end: float
    cognitive: float
    social: float
    velocity_limit: float
    rotation_vector_steps: When
    transfer: Switch
    transfer_probability: float
    arc_transfer: When
    lambda_alpha_start: float
    lambda_alpha_end: float
    lambda_beta_start: float
    lambda_beta_end: float
    complement: Switch
    complement_iterations: int
    complement_scale_start: float
    complement_scale_end: float
    sparse_to_dense: Switch
    switch_fraction: float
    neighbors: Literal["grid", "kdtree", "brute"]
    candidates: int
    free_space: Switch
    distinctiveness: Switch
    rivals: Switch
    fallback_search: When
    fallback_confidence: float
    fallback_points: int
    fallback_correspondences: int
    fallback_seeds: int
    fallback_candidates: int
    plane_aligned_poses: int
    parts: int
    refine: Switch
    refine_leaf: float
    scale: Scale
    scale_minimum: float
    scale_maximum: float
    task_gamma: Switch
    use_colors: Literal["off", "auto", "on"]
    maximum_fitness: float
    minimum_fitness_gap: float
    minimum_confidence: float
    guess_rotation: float
    guess_translation: float
    axis_tilt: float
    axis_angle_minimum: float
    axis_angle_maximum: float
    maximum_rotation: float


class ManySettings(MethodSettings, total=False):
    """The settings that :func:`pyemtr.register_many` takes for all pairs."""

    seed: int
    guess: Any
    source_viewpoint: Any
    target_viewpoint: Any
    axis: Any
    translation_bounds: Any
    mesh_points: int


class AllSettings(MethodSettings, total=False):
    """The keyword arguments of :class:`pyemtr.Problem`."""

    seed: int
    threads: int
    preset: str
    guess: Any
    source_viewpoint: Any
    target_viewpoint: Any
    axis: Any
    translation_bounds: Any
    source_normals: Any
    target_normals: Any
    source_features: Any
    target_features: Any
    source_colors: Any
    target_colors: Any
    source_intensity: Any
    target_intensity: Any
    correspondences: Any
    mesh_points: int
