//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.
