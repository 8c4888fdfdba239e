-- Which configuration was best on each build of a suite? The coverage gate: a setting with a pending trial has no mean, a
-- repair mean needs both domains, and only a configuration with an overall score has a rank. Results by different judges,
-- engines, policies, suites or builds of a suite are never ranked together, two contents of one name are never one row, and
-- configurations that validate the evaluator are never ranked.
WITH pooled AS (
    SELECT
        suite, suite_digest, latest, policy, judge, engine, configuration, configuration_digest, ranked,
        max(mean_score) FILTER (WHERE construction) AS text_to_scene,
        max(mean_score) FILTER (WHERE indoor_repair) AS indoor,
        max(mean_score) FILTER (WHERE outdoor_repair) AS outdoor,
        max(cases) FILTER (WHERE indoor_repair) AS indoor_cases,
        max(cases) FILTER (WHERE outdoor_repair) AS outdoor_cases,
        max(detailed) FILTER (WHERE construction) AS detailed,
        max(overview) FILTER (WHERE construction) AS overview,
        max(physics) FILTER (WHERE construction) AS text_physics,
        CASE WHEN bool_and(repair_f1 IS NOT NULL) FILTER (WHERE NOT construction)
            THEN sum(cases * repair_f1) FILTER (WHERE NOT construction)
                / sum(cases) FILTER (WHERE NOT construction) END AS repair_f1,
        CASE WHEN bool_and(physics IS NOT NULL) FILTER (WHERE NOT construction)
            THEN sum(cases * physics) FILTER (WHERE NOT construction)
                / sum(cases) FILTER (WHERE NOT construction) END AS image_physics,
        sum(cases) AS planned,
        sum(resolved) AS resolved
    FROM setting_means JOIN settings USING (setting)
    GROUP BY ALL
), scored AS (
    SELECT
        *,
        (indoor_cases * indoor + outdoor_cases * outdoor) / (indoor_cases + outdoor_cases) AS image_to_scene
    FROM pooled
), overall AS (
    SELECT
        *,
        CASE WHEN resolved = planned THEN 0.5 * text_to_scene + 0.5 * image_to_scene END AS model_score
    FROM scored
)
SELECT
    suite, suite_digest, latest, policy, judge, engine, configuration, configuration_digest, ranked,
    CASE WHEN ranked AND model_score IS NOT NULL THEN
        1 + count(*) FILTER (WHERE ranked AND model_score IS NOT NULL) OVER field
          - count(*) FILTER (WHERE ranked AND model_score IS NOT NULL) OVER not_better
    END AS rank,
    model_score, text_to_scene, image_to_scene, indoor, outdoor, detailed, overview, text_physics, repair_f1,
    image_physics, planned, resolved, indoor_cases, outdoor_cases
FROM overall
WINDOW
    field AS (PARTITION BY suite, suite_digest, policy, judge, engine),
    not_better AS (PARTITION BY suite, suite_digest, policy, judge, engine ORDER BY model_score NULLS FIRST
                   RANGE BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW)
ORDER BY suite, latest DESC, suite_digest, policy, judge, engine, ranked DESC, model_score DESC NULLS LAST,
         configuration, configuration_digest
