#pragma once

#include <sundials/sundials_nvector.h>

namespace orbweaver::peers {

/// A serial vector of SUNDIALS whose operations are compiled here, four lanes wide and fused where CVODE asks
/// for several at once. Those of Debian's libsundials_nvecserial 6.4.1 are compiled without optimisation: its
/// machine code keeps every loop's counter in memory and has no packed instruction.
N_Vector make_wide_vector(sunindextype length, SUNContext context);

}  // namespace orbweaver::peers
