namespace Msisf.Core.Scene;

/// <summary>
/// Which noise a frame's detector has, whatever the frame's state: Monte Carlo runs draw other noises of one state. <c>default</c> is one
/// of them too.
/// </summary>
/// <param name="Number">The user's number; each makes a series of its own.</param>
/// <param name="Step">Number of the frame in that series.</param>
public readonly record struct NoiseSeed(ulong Number, ulong Step);
