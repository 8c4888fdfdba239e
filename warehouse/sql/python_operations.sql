-- What do agents attempt inside Python? Share of parseable scripts of recorded runs that hold each operation family;
-- families may co-occur. A script that does not parse rules nothing out.
WITH scripts AS (
    SELECT t.suite, t.suite_digest, t.configuration, t.configuration_digest, t.setting, p.trial_id, p.call, p.families,
           count(*) OVER (
               PARTITION BY t.suite, t.suite_digest, t.configuration, t.configuration_digest, t.setting
           ) AS parseable_scripts
    FROM python_submissions AS p
    JOIN trials AS t USING (trial_id)
    WHERE p.recorded AND p.parseable
)
SELECT suite, left(suite_digest, 12) AS build, configuration, setting, family, count(*) AS scripts,
       any_value(parseable_scripts) AS parseable_scripts, count(*) / any_value(parseable_scripts) AS share,
       count(DISTINCT trial_id) AS trials
FROM (SELECT *, unnest(string_split(families, ' ')) AS family FROM scripts)
WHERE family <> ''
GROUP BY suite, suite_digest, configuration, configuration_digest, setting, family
ORDER BY suite, suite_digest, setting, configuration, configuration_digest, scripts DESC, family
