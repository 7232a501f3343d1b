#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "support/folder.hpp"

namespace orbweaver::test {

struct Outcome {
    int code = 0;  ///< exit code, or minus the signal that killed it
    std::string out;
    std::string err;
};

/// One of our programs, running: `orbweaver` unless told otherwise.
class Program {
public:
    explicit Program(std::vector<std::string> arguments, const std::string& program = ORBWEAVER_PROGRAM) {
        arguments.insert(arguments.begin(), program);
        std::vector<char*> argv;
        argv.reserve(arguments.size() + 1);
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        for (const auto& [stream, name] : {std::pair(STDOUT_FILENO, "out"), std::pair(STDERR_FILENO, "err")})
            posix_spawn_file_actions_addopen(&actions, stream, folder_.path(name).c_str(),
                                             O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int failed = ::posix_spawn(&pid_, program.c_str(), &actions, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (failed != 0) throw std::runtime_error("the test cannot start " + program);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void send(int signal) const { ::kill(pid_, signal); }

    Outcome wait() {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_file(folder_.path("out")),
                read_file(folder_.path("err"))};
    }

private:
    Folder folder_;
    pid_t pid_ = 0;
};

inline Outcome run_program(std::vector<std::string> arguments) { return Program(std::move(arguments)).wait(); }

inline Outcome run_assets(std::vector<std::string> arguments) {
    return Program(std::move(arguments), ORBWEAVER_ASSETS_PROGRAM).wait();
}

inline std::string fixture(const std::string& name) { return ORBWEAVER_FIXTURES "/" + name; }

}  // namespace orbweaver::test
