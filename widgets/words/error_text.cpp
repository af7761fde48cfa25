#include "widgets/words/error_text.h"

#include "widgets/words/issue_text.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ErrorText
{
    Q_DECLARE_TR_FUNCTIONS(ErrorText)
};

} // namespace

QString errorText(ErrorCode code)
{
    switch (code) {
    case ErrorCode::FileNotFound:
        return ErrorText::tr("There is no such file. Check the name and the folder.");
    case ErrorCode::FileUnreadable:
        return ErrorText::tr("The file cannot be read. Check that it is a file and that you have "
                             "permission to read it.");
    case ErrorCode::FileUnwritable:
        return ErrorText::tr("The file cannot be written. Check that the folder exists, that you "
                             "have permission to write there and that the disk is not full.");
    case ErrorCode::FileTooLarge:
        return ErrorText::tr("The file is too large for a Bergwatch file.");
    case ErrorCode::SyntaxError:
        return ErrorText::tr("This is not a Bergwatch file, or it is damaged at the place named.");
    case ErrorCode::WrongFormat:
        return ErrorText::tr("This file is of a different type than expected here.");
    case ErrorCode::UnsupportedVersion:
        return ErrorText::tr("The file was made by a newer version of Bergwatch. Update the "
                             "program to open it.");
    case ErrorCode::InvalidInput:
        return ErrorText::tr("These values are not valid. Correct them and try again.");
    case ErrorCode::Unsupported:
        return ErrorText::tr("This version of Bergwatch cannot do that.");
    case ErrorCode::SolverFailed:
        return ErrorText::tr("The planner failed. Choose another solver.");
    case ErrorCode::ReplayMismatch:
        return ErrorText::tr("The replay of the run differs from the recording. The file may come "
                             "from another version of Bergwatch.");
    }
    return {};
}

QString errorReport(const Error& error)
{
    QString report =
        u"%1: %2"_s.arg(QString::fromStdString(error.subject()), errorText(error.code()));
    constexpr qsizetype kMostLines = 12; // a box with more lines would not fit a screen
    QStringList lines = issueLines(error);
    if (const qsizetype more = lines.size() - kMostLines; more > 0)
        lines = lines.first(kMostLines)
                << ErrorText::tr("… and %n more", nullptr, static_cast<int>(more));
    return report + u"\n  "_s + lines.join(u"\n  "_s);
}

} // namespace berg
