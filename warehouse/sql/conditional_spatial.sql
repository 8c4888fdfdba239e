-- Where everything that a spatial requirement speaks of is there, how often is it not as asked? By kind of requirement:
-- relations, distributions, composition, boundary. `spatial_decisions` says which are kept; one that is left open is kept
-- and is no mismatch. Without a configuration: all that are ranked.
WITH counted AS (
    SELECT * FROM spatial_decisions
    UNION ALL
    SELECT * REPLACE (CAST(NULL AS VARCHAR) AS configuration) FROM spatial_decisions WHERE ranked
)
SELECT suite, left(suite_digest, 12) AS build, policy, judge, judge_version, engine, configuration, predicate_type,
       count(DISTINCT trial_id) AS scenes, count(*) AS requirements, count(*) FILTER (WHERE kept) AS kept,
       count(*) FILTER (WHERE kept AND answer = 'MISMATCH') AS mismatches,
       count(*) FILTER (WHERE kept AND answer NOT IN ('MATCH', 'MISMATCH')) AS undecided,
       count(*) FILTER (WHERE kept AND answer = 'MISMATCH') / nullif(count(*) FILTER (WHERE kept), 0) AS mismatch_rate
FROM counted
GROUP BY suite, suite_digest, policy, judge, judge_version, engine, configuration, predicate_type
ORDER BY suite, suite_digest, policy, judge, judge_version, engine, configuration NULLS FIRST, predicate_type
