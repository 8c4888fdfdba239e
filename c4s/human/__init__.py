"""A human study of generated scenes: made from a run, answers taken in, weights fitted and frozen, holdout opened."""

from c4s.human.agreeing import agreement
from c4s.human.answer_log import AnswerLog
from c4s.human.desk import DeskProgress, QuestionDesk
from c4s.human.evaluating import evaluate
from c4s.human.fits import fit_study
from c4s.human.intake import IntakeFault, TakenRankings, take
from c4s.human.making import design_study
from c4s.human.ranking import RankingDesk
from c4s.human.reviewing import ReviewDesk
from c4s.human.seats import access_for, keep_access
from c4s.human.study import OpenStudy, study_named

__all__ = [
    "AnswerLog",
    "DeskProgress",
    "IntakeFault",
    "OpenStudy",
    "QuestionDesk",
    "RankingDesk",
    "ReviewDesk",
    "TakenRankings",
    "access_for",
    "agreement",
    "design_study",
    "evaluate",
    "fit_study",
    "keep_access",
    "study_named",
    "take",
]
