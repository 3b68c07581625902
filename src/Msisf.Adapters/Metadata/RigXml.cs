using System.Text;
using Msisf.Core.Camera;

namespace Msisf.Adapters.Metadata;

/// <summary>The element of a meta file that says how the camera sits on its body, and where the other cameras of the rig are.</summary>
internal static class RigXml
{
    /// <summary>The lines, each after an LF; empty without a rig.</summary>
    /// <param name="rig">Which camera of a rig took the image; null for none.</param>
    /// <param name="digits">Of the numbers.</param>
    public static string Lines(RigCamera? rig, LongEDigits digits)
    {
        if (rig is null)
        {
            return string.Empty;
        }

        StringBuilder text = new();
        text.Append("\n    <Rig camera=\"").Append(rig.Name).Append("\">\n      <Mounting unit=\"m\">");
        AppendPose(text, rig.Mounting, digits);
        text.Append("\n      </Mounting>");
        foreach (MountedCamera other in rig.Cameras.Where((_, index) => index != rig.Index))
        {
            text.Append("\n      <OtherCamera name=\"").Append(other.Name).Append("\" unit=\"m\">");
            AppendPose(text, other.Mounting.SeenFrom(rig.Mounting), digits);
            text.Append("\n      </OtherCamera>");
        }

        return text.Append("\n    </Rig>").ToString();
    }

    private static void AppendPose(StringBuilder text, Mounting pose, LongEDigits digits) => text
        .Append("\n        ").Append(VectorXml.Of(pose.OffsetBody, digits))
        .Append("\n        ").Append(VectorXml.Of(pose.BodyFromCamera, digits));
}
