using System.Text;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>
/// Writes an image as PDS4: a label and an array. PDS4's core has no camera, so the label's comment says where it was and how it looked.
/// </summary>
internal static class Pds4Product
{
    /// <summary>Ending of the array; a label ends in .lblx, because .xml is the meta file.</summary>
    public const string ArrayEnding = ".img";

    /// <summary>Stands for pixels without a number.</summary>
    private const float Missing = -32768.0f;

    public static void WriteArray(Stream stream, ExportedFrame frame) => frame.Image!.WritePixels(stream, Missing);

    public static void WriteLabel(TextWriter writer, ExportedFrame frame)
    {
        ExportedImage image = frame.Image!;
        CelestialBody body = frame.Globe.Body;
        string time = frame.Time.ToIsoUtc();
        string end = frame.Scan is { } scan ? frame.Time.After(scan.States[^1].Seconds).ToIsoUtc() : time;
        string name = XmlText.Escape(frame.Name);
        string kind = body.NaifNumber % 100 == 99 ? "Planet" : "Satellite";
        writer.Write(Invariant($"""
            <?xml version="1.0" encoding="UTF-8"?>
            <?xml-model href="https://pds.nasa.gov/pds4/pds/v1/PDS4_PDS_1K00.sch" schematypens="http://purl.oclc.org/dsdl/schematron"?>
            <Product_Observational xmlns="http://pds.nasa.gov/pds4/pds/v1" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
                xsi:schemaLocation="http://pds.nasa.gov/pds4/pds/v1 https://pds.nasa.gov/pds4/pds/v1/PDS4_PDS_1K00.xsd">
              <Identification_Area>
                <logical_identifier>urn:nasa:pds:msisf:images:{IdentifierOf(frame.Name)}</logical_identifier>
                <version_id>1.0</version_id>
                <title>Synthetic image {name} of {body.NameInText} by MSISF</title>
                <information_model_version>1.20.0.0</information_model_version>
                <product_class>Product_Observational</product_class>
              </Identification_Area>
              <Observation_Area>
                <comment>
            {Comment(frame)}
                </comment>
                <Time_Coordinates>
                  <start_date_time>{time}</start_date_time>
                  <stop_date_time>{end}</stop_date_time>
                </Time_Coordinates>
                <Investigation_Area>
                  <name>None</name>
                  <type>Individual Investigation</type>
                  <Internal_Reference>
                    <lid_reference>urn:nasa:pds:context:investigation:individual.none</lid_reference>
                    <reference_type>data_to_investigation</reference_type>
                  </Internal_Reference>
                </Investigation_Area>
                <Observing_System>
                  <Observing_System_Component>
                    <name>MSISF</name>
                    <type>Instrument</type>
                    <description>Synthetic camera</description>
                  </Observing_System_Component>
                </Observing_System>
                <Target_Identification>
                  <name>{body.Name}</name>
                  <type>{kind}</type>
                  <Internal_Reference>
                    <lid_reference>urn:nasa:pds:context:target:{kind.ToLowerInvariant()}.{TargetOf(body)}</lid_reference>
                    <reference_type>data_to_target</reference_type>
                  </Internal_Reference>
                </Target_Identification>
              </Observation_Area>
              <File_Area_Observational>
                <File>
                  <file_name>{name}{ArrayEnding}</file_name>
                </File>
                <Array_2D_Image>
                  <local_identifier>image</local_identifier>
                  <offset unit="byte">0</offset>
                  <axes>2</axes>
                  <axis_index_order>Last Index Fastest</axis_index_order>
                  <description>{(image.IsDigital ? "Digital numbers of the detector" : "Radiance factor I/F")}</description>
                  <Element_Array>
                    <data_type>IEEE754LSBSingle</data_type>
                    <scaling_factor>1.0</scaling_factor>
                    <value_offset>0.0</value_offset>
                  </Element_Array>
                  <Axis_Array>
                    <axis_name>Line</axis_name>
                    <elements>{image.Height}</elements>
                    <sequence_number>1</sequence_number>
                  </Axis_Array>
                  <Axis_Array>
                    <axis_name>Sample</axis_name>
                    <elements>{image.Width}</elements>
                    <sequence_number>2</sequence_number>
                  </Axis_Array>
                  <Special_Constants>
                    <missing_constant>{Missing:F1}</missing_constant>
                  </Special_Constants>
                </Array_2D_Image>
              </File_Area_Observational>
            </Product_Observational>

            """).ReplaceLineEndings("\n"));
    }

    private static string Comment(ExportedFrame frame)
    {
        CameraMatrix camera = CameraMatrix.Of(frame.Camera);
        UnitQuaternion q = frame.BodyFromOpenCv;
        string axes = frame.Globe.Body.Frame;
        StringBuilder text = new();
        Line($"MJD (UTC) = {Real(frame.Time.Mjd)}");
        Line($"Camera position ({axes}, m) = {Reals(" ", Of(frame.Camera.PositionBodyFixed))}");
        Line($"Quaternion x y z w, camera axes (x right, y down, z forward) to {axes} = {Reals(" ", q.X, q.Y, q.Z, q.W)}");
        Line($"Position of the light ({axes}, m) = {Reals(" ", Of(frame.SunPosition))}");
        Line($"K by rows, pixels from 0 = {Reals(" ", camera.IntrinsicRows.SelectMany(Of))}");
        if (frame.Scan is not null)
        {
            Line("The rows have times and places of their own; these are those of the MJD above. The meta file of MSISF has the others");
        }

        Line(camera.Distortion is { } lens ? $"Lens {lens.Name} = {Reals(" ", lens.Coefficients)}" : "No lens distortion");
        return text.ToString().TrimEnd('\n');

        void Line(string line) => text.Append("      ").Append(line).Append('\n');
    }

    /// <summary>The letters that identifiers of PDS4 may have.</summary>
    private static string IdentifierOf(string name) => string.Concat(
        name.ToLowerInvariant().Select(letter => char.IsAsciiLetterOrDigit(letter) || letter is '-' or '.' or '_' ? letter : '_'));

    /// <summary>The body as the context products of PDS4 name it: a satellite after its planet.</summary>
    private static string TargetOf(CelestialBody body)
    {
        string name = body.Name.ToLowerInvariant();
        return body.IsMoon ? "earth.moon" : body.NaifNumber / 100 == 5 ? $"jupiter.{name}" : name;
    }
}
