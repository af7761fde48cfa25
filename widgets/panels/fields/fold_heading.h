#pragma once

#include <QToolButton>

namespace berg {

/** Heading of a group of rows; checked while the rows are shown. */
class FoldHeading : public QToolButton
{
    Q_OBJECT

public:
    explicit FoldHeading(const QString& title, QWidget* parent = nullptr);
};

} // namespace berg
