// Included before every test of a program that holds several (BERGWATCH_UNITY): the macro that
// makes a test a program registers it in the list of test_room.cpp instead. No include guard: each
// test needs the macro anew.
#include "tests/support/test_list.h"

#include <QtTest>

#undef QTEST_MAIN_WRAPPER
#define QTEST_MAIN_WRAPPER(TestObject, ...)                                                        \
    static int run##TestObject(int argc, char** argv)                                              \
    {                                                                                              \
        QTest::Internal::callInitMain<TestObject>();                                               \
        __VA_ARGS__                                                                                \
        TestObject tc;                                                                             \
        QTEST_SET_MAIN_SOURCE_PATH                                                                 \
        return QTest::qExec(&tc, argc, argv);                                                      \
    }                                                                                              \
    static const bool enlisted##TestObject = berg::enlistTest(__FILE__, run##TestObject);
