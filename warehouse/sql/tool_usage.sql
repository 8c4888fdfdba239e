-- How many tool calls does a recorded run make, status checks left out? Means over recorded runs, runs without a
-- call included, with the split into Python and other tools.
SELECT
    t.suite, left(t.suite_digest, 12) AS build, t.configuration, t.setting, count(*) AS runs,
    avg(a.tool_calls - a.polling_calls) AS mean_calls,
    avg(a.python_calls) AS mean_python_calls,
    avg(a.tool_calls - a.polling_calls - a.python_calls) AS mean_other_calls,
    avg(a.polling_calls) AS mean_polling_calls,
    sum(a.failed_calls) AS failed_calls,
    sum(a.named_transform_calls) AS named_transform_calls
FROM attempts AS a
JOIN trials AS t USING (trial_id)
WHERE a.recorded
GROUP BY t.suite, t.suite_digest, t.configuration, t.configuration_digest, t.setting
ORDER BY t.suite, t.suite_digest, t.setting, mean_calls DESC, t.configuration, t.configuration_digest
