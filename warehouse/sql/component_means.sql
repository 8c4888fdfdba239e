-- Where do scores come from? Each component of each verifier: over how many trials it was measured, of how many that have
-- an outcome, and its mean, least and greatest value there. Trials without it are left out of the mean, unlike in scores.
WITH scored AS (
    SELECT t.suite, t.suite_digest, t.policy, t.judge, t.judge_version, t.engine, t.configuration,
           t.configuration_digest, t.setting, t.trial_id,
           count(*) OVER (
               PARTITION BY t.suite, t.suite_digest, t.policy, t.judge, t.judge_version, t.engine,
                            t.configuration_digest, t.configuration, t.setting
           ) AS outcomes
    FROM trials AS t JOIN outcomes USING (trial_id)
)
SELECT
    s.suite, left(s.suite_digest, 12) AS build, s.policy, s.judge, s.judge_version, s.engine,
    s.configuration, s.setting, c.verifier, c.name,
    count(*) AS measured, any_value(s.outcomes) AS outcomes,
    avg(c.value) AS mean_value, min(c.value) AS least, max(c.value) AS greatest
FROM components AS c
JOIN scored AS s USING (trial_id)
GROUP BY s.suite, s.suite_digest, s.policy, s.judge, s.judge_version, s.engine, s.configuration,
         s.configuration_digest, s.setting, c.verifier, c.name
ORDER BY s.suite, s.suite_digest, s.policy, s.judge, s.judge_version, s.engine, s.setting, s.configuration,
         s.configuration_digest, c.verifier, c.name
