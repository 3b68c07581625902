namespace Msisf.App.Settings;

/// <summary>How the user moves an elevation model; <c>default</c> is not at all.</summary>
/// <param name="MeetsBorder">Whether it is raised by what makes its border meet the models around it in the mean.</param>
/// <param name="East">m towards the east.</param>
/// <param name="North">m towards the north.</param>
internal readonly record struct ModelPlacement(bool MeetsBorder, double East, double North)
{
    /// <summary>Whether it is moved over the ground.</summary>
    public bool IsShifted => (East, North) != (0.0, 0.0);
}
