#include "run/current_fault.hpp"

#include <exception>
#include <new>

namespace orbweaver {

Fault current_fault() {
    try {
        throw;
    } catch (const Fault& fault) {
        return fault;
    } catch (const std::bad_alloc&) {
        return {FaultKind::limit, "out of memory; ask for less, or give the process more"};
    } catch (const std::exception& error) {
        return {FaultKind::internal, error.what()};
    } catch (...) {
        return {FaultKind::internal, "something was thrown that is no exception"};
    }
}

}  // namespace orbweaver
