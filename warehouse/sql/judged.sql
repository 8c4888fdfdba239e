-- What was decided about which actor or requirement?
SELECT suite, configuration, case_id, repeat, verifier, outcome, subject, detail, trial_id FROM findings
