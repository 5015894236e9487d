# Turns an emtr_result into a dict of plain Python values.

cdef dict fields(const emtr_result* r):
    return {
        "transformation": listed(r.transformation, 16),
        "registered": bool(r.registered),
        "reason": emtr_reason_name(r.reason).decode(),
        "reason_text": emtr_reason_text(r.reason).decode(),
        "fitness": r.fitness,
        "inlier_ratio_source": r.inlier_ratio_source,
        "inlier_ratio_target": r.inlier_ratio_target,
        "fitness_gap": r.fitness_gap,
        "overlap_source": r.overlap_source,
        "overlap_target": r.overlap_target,
        "inlier_rmse": r.inlier_rmse,
        "inlier_rmse_plane": r.inlier_rmse_plane,
        "points_source": r.points_source, "points_target": r.points_target,
        "dropped_source": r.dropped_source, "dropped_target": r.dropped_target,
        "sparse_source": r.sparse_source, "sparse_target": r.sparse_target,
        "dense_source": r.dense_source, "dense_target": r.dense_target,
        "correspondences": r.correspondences,
        "correspondences_found": r.correspondences_found,
        "tims": r.tims, "tims_pruned": r.tims_pruned,
        "queries": {"evaluation": r.queries_evaluation, "switch": r.queries_switch,
                    "complement": r.queries_complement},
        "normalization_scale": r.normalization_scale,
        "center_source": listed(r.center_source, 3),
        "center_target": listed(r.center_target, 3),
        "leaf_sparse": r.leaf_sparse, "leaf_dense": r.leaf_dense, "leaf_fine": r.leaf_fine,
        "timings": {"normalization": r.seconds_normalization,
                    "downsampling": r.seconds_downsampling,
                    "features": r.seconds_features, "matching": r.seconds_matching,
                    "seeds": r.seconds_seeds, "evolution": r.seconds_evolution,
                    "candidates": r.seconds_candidates,
                    "fallback_search": r.seconds_fallback_search,
                    "refinement": r.seconds_refinement, "verdict": r.seconds_verdict,
                    "total": r.seconds_total},
        "iterations": r.iterations,
        "history": {"alpha": listed(r.history_alpha, r.iterations),
                    "beta": listed(r.history_beta, r.iterations)},
        "seed": r.seed,
        "threads": r.threads,
        "kernel": r.kernel.decode(),
        "confidence": r.confidence, "score": r.score, "surface_fit": r.surface_fit,
        "violation": r.violation, "score_gap": r.score_gap,
        "seeds": r.seeds, "candidates": r.candidates,
        "used_fallback_search": bool(r.used_fallback_search), "refined": bool(r.refined),
        "alternatives": [(listed(r.alternatives[i].transformation, 16), r.alternatives[i].score)
                         for i in range(r.alternative_count)],
        "information": listed(r.information, 36),
        "hessian_eigenvalues": listed(r.hessian_eigenvalues, 6),
        "hessian_eigenvectors": listed(r.hessian_eigenvectors, 36),
        "unconstrained_directions": r.unconstrained_directions if r.refined else None,
    }


cdef dict finish(emtr_status status, Watch watch, emtr_result* result):
    # An exception of the callback comes first, because it ended the run.
    try:
        if watch.error is not None:
            raise watch.error
        check(status)
        return fields(result)
    finally:
        emtr_result_free(result)
