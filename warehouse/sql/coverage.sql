-- How complete is each configuration, and why is a contribution zero?
SELECT
    suite, left(suite_digest, 12) AS build, policy, judge, judge_version, engine, visibility, configuration, setting,
    count(*) AS planned,
    count(*) FILTER (WHERE score IS NOT NULL) AS resolved,
    count(*) FILTER (WHERE status = 'pending') AS pending,
    count(*) FILTER (WHERE status IN ('measured', 'measured_with_missing_zero')) AS measured,
    count(*) FILTER (WHERE status = 'zero_invalid_candidate') AS invalid,
    count(*) FILTER (WHERE status = 'zero_missing_submission') AS no_submission,
    count(*) FILTER (WHERE status = 'zero_missing_result') AS no_result
FROM case_scores
GROUP BY suite, suite_digest, policy, judge, judge_version, engine, visibility, configuration, configuration_digest, setting
ORDER BY suite, suite_digest, policy, judge, judge_version, engine, visibility DESC, configuration, configuration_digest,
         setting
