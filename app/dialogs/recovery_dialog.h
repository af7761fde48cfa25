#pragma once

#include "app/dialogs/interaction.h"

#include <QDialog>

class QTableWidget;

namespace berg {

/** Lists unsaved work of programs that ended unexpectedly, newest first, and asks what to do. */
class RecoveryDialog : public QDialog
{
    Q_OBJECT

public:
    /** `offers` is not empty. */
    explicit RecoveryDialog(const std::vector<RecoveryOffer>& offers, QWidget* parent = nullptr);

    /** Returns the answer after `exec`; `Later` if the dialog was closed without a choice. */
    [[nodiscard]] RecoveryAnswer answer() const { return m_answer; }

private:
    void fill(const std::vector<RecoveryOffer>& offers);
    void end(RecoveryAnswer::Action action);

    QTableWidget* m_list;
    RecoveryAnswer m_answer;
};

} // namespace berg
