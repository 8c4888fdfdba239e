-- The mean of each setting over its scheduled cases, a case being the mean of its repeats; null until every contribution is
-- resolved. `visibility` is the panel: public and private cases have means of their own. `cases` and `resolved` count
-- trials, `distinct_cases` the cases that are planned for the configuration, `of_cases` those that are planned for any
-- configuration of the same field.
WITH each_case AS (
    SELECT
        suite, suite_digest, latest, policy, judge, judge_version, engine, visibility, configuration, configuration_digest,
        ranked, setting, case_id,
        count(*) AS trials,
        count(score) AS resolved,
        avg(score) AS score,
        avg(coalesce(physics, 0)) AS physics,
        avg(coalesce(detailed, 0)) AS detailed,
        avg(coalesce(overview, 0)) AS overview,
        avg(coalesce(repair_precision, 0)) AS repair_precision,
        avg(coalesce(repair_recall, 0)) AS repair_recall,
        avg(coalesce(repair_f1, 0)) AS repair_f1
    FROM case_scores
    GROUP BY ALL
)
SELECT
    suite, suite_digest, latest, policy, judge, judge_version, engine, visibility, configuration, configuration_digest,
    ranked, setting,
    CAST(sum(trials) AS BIGINT) AS cases,
    CAST(sum(e.resolved) AS BIGINT) AS resolved,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(score) END AS mean_score,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(e.physics) END AS physics,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(e.detailed) END AS detailed,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(e.overview) END AS overview,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(e.repair_precision) END AS repair_precision,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(e.repair_recall) END AS repair_recall,
    CASE WHEN sum(e.resolved) = sum(trials) THEN avg(e.repair_f1) END AS repair_f1,
    count(*) AS distinct_cases,
    any_value(of_cases) AS of_cases
FROM each_case AS e
JOIN (
    SELECT suite, suite_digest, policy, judge, judge_version, engine, visibility, setting,
           count(DISTINCT case_id) AS of_cases
    FROM each_case GROUP BY ALL
) USING (suite, suite_digest, policy, judge, judge_version, engine, visibility, setting)
GROUP BY ALL
