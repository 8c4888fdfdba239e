-- What do agents attempt inside Python? Share of parseable scripts of recorded runs that hold each operation family;
-- families may co-occur. A script that does not parse rules nothing out.
WITH scripts AS (
    SELECT p.suite, p.configuration, s.setting, p.trial_id, p.call, p.families,
           count(*) OVER (PARTITION BY p.suite, p.configuration, s.setting) AS parseable_scripts
    FROM python_submissions AS p
    JOIN schedule AS s USING (trial_id)
    WHERE p.recorded AND p.parseable
)
SELECT suite, configuration, setting, family, count(*) AS scripts, any_value(parseable_scripts) AS parseable_scripts,
       count(*) / any_value(parseable_scripts) AS share, count(DISTINCT trial_id) AS trials
FROM (SELECT *, unnest(string_split(families, ' ')) AS family FROM scripts)
WHERE family <> ''
GROUP BY ALL
ORDER BY suite, setting, configuration, scripts DESC, family
