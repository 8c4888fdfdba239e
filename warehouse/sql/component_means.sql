-- Where do scores come from? Each component of each verifier: over how many trials it was measured, of how many that have
-- an outcome, and its mean, least and greatest value there. Trials without it are left out of the mean, unlike in scores.
WITH scored AS (
    SELECT suite, configuration, setting, count(*) AS outcomes FROM outcomes GROUP BY ALL
)
SELECT
    o.suite, o.configuration, o.setting, c.verifier, c.name,
    count(*) AS measured, any_value(s.outcomes) AS outcomes,
    avg(c.value) AS mean_value, min(c.value) AS least, max(c.value) AS greatest
FROM components AS c
JOIN outcomes AS o USING (trial_id)
JOIN scored AS s ON s.suite = o.suite AND s.configuration = o.configuration AND s.setting = o.setting
GROUP BY ALL
ORDER BY o.suite, o.setting, o.configuration, c.verifier, c.name
