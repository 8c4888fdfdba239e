-- Which trials are planned, and what is each configuration called? By its name; where a build of a suite was run with two
-- contents of one name, by its name and the first digits of its content's digest. `latest` marks the build of a suite
-- whose plan was frozen last.
SELECT
    s.* REPLACE (
        CASE WHEN min(s.configuration_digest) OVER named = max(s.configuration_digest) OVER named THEN s.configuration
             ELSE s.configuration || ' @' || left(s.configuration_digest, 6) END AS configuration
    ),
    s.suite_digest = first_value(s.suite_digest) OVER builds AS latest
FROM schedule AS s
WINDOW
    named AS (PARTITION BY s.suite, s.suite_digest, s.configuration),
    builds AS (PARTITION BY s.suite ORDER BY s.planned_at DESC, s.suite_digest)
