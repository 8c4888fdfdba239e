-- Which configuration is best? On the latest build of each suite; `leaderboards` has every build, and says how it ranks.
SELECT * EXCLUDE (latest) FROM leaderboards WHERE latest
ORDER BY suite, policy, judge, judge_version, engine, visibility DESC, ranked DESC, model_score DESC NULLS LAST,
         configuration, configuration_digest
