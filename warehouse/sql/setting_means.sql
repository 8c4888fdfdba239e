-- The mean of each setting over its scheduled cases; null until every contribution is resolved.
SELECT
    suite, suite_digest, latest, policy, judge, engine, configuration, configuration_digest, ranked, setting,
    count(*) AS cases,
    count(score) AS resolved,
    CASE WHEN count(score) = count(*) THEN avg(score) END AS mean_score,
    CASE WHEN count(score) = count(*) THEN avg(coalesce(physics, 0)) END AS physics,
    CASE WHEN count(score) = count(*) THEN avg(coalesce(detailed, 0)) END AS detailed,
    CASE WHEN count(score) = count(*) THEN avg(coalesce(overview, 0)) END AS overview,
    CASE WHEN count(score) = count(*) THEN avg(coalesce(repair_precision, 0)) END AS repair_precision,
    CASE WHEN count(score) = count(*) THEN avg(coalesce(repair_recall, 0)) END AS repair_recall,
    CASE WHEN count(score) = count(*) THEN avg(coalesce(repair_f1, 0)) END AS repair_f1
FROM case_scores
GROUP BY ALL
