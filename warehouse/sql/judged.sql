-- What was decided about which actor or requirement?
SELECT t.suite, left(t.suite_digest, 12) AS build, t.configuration, f.case_id, f.repeat, f.verifier, f.outcome,
       f.subject, f.detail, f.trial_id
FROM findings AS f
JOIN trials AS t USING (trial_id)
