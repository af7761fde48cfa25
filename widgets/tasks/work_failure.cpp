#include "widgets/tasks/work_failure.h"

#include "widgets/words/error_text.h"

#include <QCoreApplication>

#include <new>

namespace berg {
namespace {

struct WorkFailureText
{
    Q_DECLARE_TR_FUNCTIONS(WorkFailureText)
};

} // namespace

WorkFailure presentFailure()
{
    try {
        throw;
    } catch (const Error& error) {
        return {.error = error, .report = errorReport(error), .isExpected = true};
    } catch (const std::bad_alloc&) {
        return {.error = Error(ErrorCode::SolverFailed, "memory", "there is not enough of it"),
                .report = WorkFailureText::tr(
                    "Not enough memory. Close other programs or choose a smaller task.")};
    } catch (const std::exception& fault) {
        return {.error = Error(ErrorCode::SolverFailed, "Bergwatch", fault.what()),
                .report =
                    WorkFailureText::tr("Internal error: %1").arg(QString::fromUtf8(fault.what()))};
    } catch (...) {
        return {.error = Error(ErrorCode::SolverFailed, "Bergwatch", "unknown fault"),
                .report = WorkFailureText::tr("Internal error: %1").arg(QStringLiteral("?"))};
    }
}

} // namespace berg
