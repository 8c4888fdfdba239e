-- Why did a trial score zero without being measured?
SELECT suite, left(suite_digest, 12) AS build, configuration, setting, status, reason, count(*) AS trials, list(case_id ORDER BY case_id) AS cases
FROM case_scores
WHERE status IN ('zero_invalid_candidate', 'zero_missing_submission', 'zero_missing_result')
GROUP BY suite, suite_digest, configuration, configuration_digest, setting, status, reason
ORDER BY trials DESC
