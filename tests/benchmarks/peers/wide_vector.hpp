#pragma once

#include <sundials/sundials_nvector.h>

namespace orbweaver::peers {

/// A serial vector of SUNDIALS whose operations are compiled here, four lanes wide and fused where CVODE asks
/// for several at once. Debian compiles those of libsundials_nvecserial for plain x86-64 at -O2, one number at
/// a time.
N_Vector make_wide_vector(sunindextype length, SUNContext context);

}  // namespace orbweaver::peers
