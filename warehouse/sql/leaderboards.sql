-- Which configuration was best on each build of a suite? The coverage gate: a setting with a pending trial has no mean, a
-- repair mean needs both domains, and only a configuration with an overall score has a rank; one with fewer cases than
-- others of its field has none (`cases` of `of_cases`). Results by different judges, engines, policies, suites, builds of a
-- suite or panels (`visibility`) are never ranked together, two contents of one name are never one row, and configurations
-- that validate the evaluator are never ranked. Scores that differ by rounding alone share a rank.
WITH pooled AS (
    SELECT
        suite, suite_digest, latest, policy, judge, judge_version, engine, visibility, configuration, configuration_digest,
        ranked,
        max(mean_score) FILTER (WHERE construction) AS text_to_scene,
        max(mean_score) FILTER (WHERE indoor_repair) AS indoor,
        max(mean_score) FILTER (WHERE outdoor_repair) AS outdoor,
        max(distinct_cases) FILTER (WHERE indoor_repair) AS indoor_cases,
        max(distinct_cases) FILTER (WHERE outdoor_repair) AS outdoor_cases,
        max(detailed) FILTER (WHERE construction) AS detailed,
        max(overview) FILTER (WHERE construction) AS overview,
        max(physics) FILTER (WHERE construction) AS text_physics,
        CASE WHEN bool_and(repair_f1 IS NOT NULL) FILTER (WHERE NOT construction)
            THEN sum(distinct_cases * repair_f1) FILTER (WHERE NOT construction)
                / sum(distinct_cases) FILTER (WHERE NOT construction) END AS repair_f1,
        CASE WHEN bool_and(physics IS NOT NULL) FILTER (WHERE NOT construction)
            THEN sum(distinct_cases * physics) FILTER (WHERE NOT construction)
                / sum(distinct_cases) FILTER (WHERE NOT construction) END AS image_physics,
        sum(cases) AS planned,
        sum(resolved) AS resolved,
        sum(distinct_cases) AS cases
    FROM setting_means JOIN settings USING (setting)
    GROUP BY ALL
), panels AS (
    SELECT suite, suite_digest, policy, judge, judge_version, engine, visibility, sum(of_cases) AS of_cases
    FROM (
        SELECT DISTINCT suite, suite_digest, policy, judge, judge_version, engine, visibility, setting, of_cases
        FROM setting_means
    )
    GROUP BY ALL
), scored AS (
    SELECT
        *,
        (indoor_cases * indoor + outdoor_cases * outdoor) / (indoor_cases + outdoor_cases) AS image_to_scene
    FROM pooled JOIN panels USING (suite, suite_digest, policy, judge, judge_version, engine, visibility)
), overall AS (
    SELECT
        *,
        CASE WHEN resolved = planned AND cases = of_cases THEN 0.5 * text_to_scene + 0.5 * image_to_scene END AS model_score
    FROM scored
)
SELECT
    suite, suite_digest, latest, policy, judge, judge_version, engine, visibility, configuration, configuration_digest,
    ranked,
    CASE WHEN ranked AND model_score IS NOT NULL THEN
        1 + count(*) FILTER (WHERE ranked AND model_score IS NOT NULL) OVER field
          - count(*) FILTER (WHERE ranked AND model_score IS NOT NULL) OVER not_better
    END AS rank,
    model_score, text_to_scene, image_to_scene, indoor, outdoor, detailed, overview, text_physics, repair_f1,
    image_physics, planned, resolved, cases, of_cases,
    indoor_cases, outdoor_cases
FROM overall
WINDOW
    field AS (PARTITION BY suite, suite_digest, policy, judge, judge_version, engine, visibility),
    not_better AS (PARTITION BY suite, suite_digest, policy, judge, judge_version, engine, visibility
                   ORDER BY round(model_score, 12) NULLS FIRST RANGE BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW)
ORDER BY suite, latest DESC, suite_digest, policy, judge, judge_version, engine, visibility DESC, ranked DESC,
         model_score DESC NULLS LAST, configuration, configuration_digest
