-- Which errors recur in Python submissions? Shares are of submissions with an observed error, not of all: missing feedback
-- does not establish error-free execution. A submission counts once for each class.
WITH bearing AS (
    SELECT p.suite, p.configuration, s.setting, p.trial_id, p.call, p.errors,
           count(*) OVER (PARTITION BY p.suite, p.configuration, s.setting) AS error_bearing
    FROM python_submissions AS p
    JOIN schedule AS s USING (trial_id)
    WHERE p.recorded AND p.errors <> ''
)
SELECT suite, configuration, setting, error, count(*) AS submissions, any_value(error_bearing) AS error_bearing,
       count(*) / any_value(error_bearing) AS share
FROM (SELECT *, unnest(string_split(errors, ' ')) AS error FROM bearing)
GROUP BY ALL
ORDER BY suite, setting, configuration, submissions DESC, error
