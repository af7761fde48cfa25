#include "widgets/words/error_text.h"

#include "widgets/words/issue_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Sentences about an error, in English. */
struct ErrorRow
{
    ErrorCode code;
    const char* sentence;
    /** Sentence about a file to be imported, if another one applies to it than to our files. */
    const char* ofImports = nullptr;
};

struct ErrorText
{
    Q_DECLARE_TR_FUNCTIONS(ErrorText)

public:
    static constexpr ErrorRow kRows[]{
        {ErrorCode::FileNotFound,
         QT_TR_NOOP("There is no such file. Check the name and the folder.")},
        {ErrorCode::FileUnreadable, QT_TR_NOOP("The file cannot be read. Check that it is a file "
                                               "and that you have permission to read it.")},
        {ErrorCode::FileUnwritable,
         QT_TR_NOOP("The file cannot be written. Check that the folder exists, that you have "
                    "permission to write there and that the disk is not full.")},
        {ErrorCode::FileTooLarge, QT_TR_NOOP("The file is too large for a Bergwatch file."),
         QT_TR_NOOP(
             "The file is too large to be imported. Split it, or leave out what is not needed.")},
        {ErrorCode::SyntaxError,
         QT_TR_NOOP("This is not a Bergwatch file, or it is damaged at the place named."),
         QT_TR_NOOP("The file is broken. Correct it at the place named, or export it again.")},
        {ErrorCode::WrongFormat, QT_TR_NOOP("This file is of a different type than expected here."),
         QT_TR_NOOP("Bergwatch does not recognise this file. If it is a table, choose its latitude "
                    "and longitude columns below.")},
        {ErrorCode::UnsupportedVersion,
         QT_TR_NOOP(
             "The file was made by a newer version of Bergwatch. Update the program to open it.")},
        {ErrorCode::InvalidInput,
         QT_TR_NOOP("These values are not valid. Correct them and try again."),
         QT_TR_NOOP("Nothing of it can be used like this.")},
        {ErrorCode::Unsupported, QT_TR_NOOP("This version of Bergwatch cannot do that.")},
        {ErrorCode::SolverFailed, QT_TR_NOOP("The planner failed. Choose another solver.")},
        {ErrorCode::ReplayMismatch,
         QT_TR_NOOP("The replay of the run differs from the recording. The file may come from "
                    "another version of Bergwatch.")},
    };
};
static_assert(std::size(ErrorText::kRows) == std::size_t(ErrorCode::ReplayMismatch) + 1);

const ErrorRow& errorRow(ErrorCode code)
{
    return *std::ranges::find(ErrorText::kRows, code, &ErrorRow::code);
}

} // namespace

QString errorText(ErrorCode code)
{
    return ErrorText::tr(errorRow(code).sentence);
}

QString importErrorText(ErrorCode code)
{
    const ErrorRow& row = errorRow(code);
    return ErrorText::tr(row.ofImports == nullptr ? row.sentence : row.ofImports);
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
