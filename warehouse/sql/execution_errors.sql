-- Which errors recur in Python submissions? Shares are of submissions with an observed error, not of all: missing feedback
-- does not establish error-free execution. A submission counts once for each class.
WITH bearing AS (
    SELECT t.suite, t.suite_digest, t.configuration, t.configuration_digest, t.setting, p.trial_id, p.call, p.errors,
           count(*) OVER (
               PARTITION BY t.suite, t.suite_digest, t.configuration, t.configuration_digest, t.setting
           ) AS error_bearing
    FROM python_submissions AS p
    JOIN trials AS t USING (trial_id)
    WHERE p.recorded AND p.errors <> ''
)
SELECT suite, left(suite_digest, 12) AS build, configuration, setting, error, count(*) AS submissions,
       any_value(error_bearing) AS error_bearing, count(*) / any_value(error_bearing) AS share
FROM (SELECT *, unnest(string_split(errors, ' ')) AS error FROM bearing)
GROUP BY suite, suite_digest, configuration, configuration_digest, setting, error
ORDER BY suite, suite_digest, setting, configuration, configuration_digest, submissions DESC, error
