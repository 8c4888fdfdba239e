-- Why did a trial score zero without being measured? A row a configuration, panel, setting and reason code; how many
-- trials and cases it took stands beside it, and `told` is how one of its verdicts says it. A code that is empty was not told.
SELECT suite, left(suite_digest, 12) AS build, policy, judge, judge_version, engine, visibility, configuration, setting,
       status, reason_code, count(*) AS trials, count(DISTINCT case_id) AS cases, min(reason) AS told
FROM case_scores
WHERE status IN ('zero_invalid_candidate', 'zero_missing_submission', 'zero_missing_result')
GROUP BY suite, suite_digest, policy, judge, judge_version, engine, visibility, configuration, configuration_digest,
         setting, status, reason_code
ORDER BY trials DESC, suite, configuration, configuration_digest, setting, status, reason_code
