-- Why did a trial score zero without being measured?
SELECT suite, configuration, setting, status, reason, count(*) AS trials, list(case_id ORDER BY case_id) AS cases
FROM case_scores
WHERE status IN ('zero_invalid_candidate', 'zero_missing_submission', 'zero_missing_result')
GROUP BY ALL
ORDER BY trials DESC
