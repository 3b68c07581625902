namespace Msisf.App.Settings;

/// <summary>The four ways to say where the camera is (thesis section 6.3); exactly one is used.</summary>
internal enum Mode
{
    Kepler,
    StateVectors,
    FixedState,
    BatchFile,
}
