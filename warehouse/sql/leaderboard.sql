-- Which configuration is best? On the latest build of each suite; `leaderboards` has every build, and says how it ranks.
SELECT * EXCLUDE (latest) FROM leaderboards WHERE latest
ORDER BY suite, policy, judge, engine, ranked DESC, model_score DESC NULLS LAST, configuration, configuration_digest
