// Layout of a one-dimensional list of invocations over compute groups, for C++ and GLSL.
#ifndef MELTPOOL_SHARED_DISPATCH_H
#define MELTPOOL_SHARED_DISPATCH_H

/// Invocations of a work group in passes over particles.
#define GROUP_SIZE 64

#ifndef __cplusplus
/// Index of this invocation in a list that Program::dispatch() folded into rows of groups. A macro, because drivers want
/// the group size declared before it is read.
#define linearInvocation()                                                                                             \
    ((gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex)
#endif

#endif
